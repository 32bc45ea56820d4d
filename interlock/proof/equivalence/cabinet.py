"""The mapping program carries every wire to its variable and back: read back from its text and compared, name by name.

The interlocking is proved for every value of its inputs, so nothing more is asked of the mapping than this: each input
gets its own wire (or the operator's variable of its name), each wire to the outside gets its own output, each word a
variable, no address twice, VALID only while no cycle was too long and every substation is seen to be well (its watch,
its diagnosis bit, or both), each substation with outputs gets a heartbeat that changes in every cycle, and one task.

**Theorem.**  Where each input has a wire of its own and each wire to the outside an output of its own, a claim that
holds for every value of the inputs holds for every state of the wires.  (Renaming by a bijection keeps validity;
everything else that the program computes is compared formula by formula.)
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from interlock.logic.cabinet import Allocation
from interlock.logic.controller import Controller
from interlock.logic.words import UNKNOWN
from interlock.model.portable import portable
from interlock.proof.equivalence.structured_text import Difference, compare_unit
from interlock.proof.equivalence.tags import BadTags, read_tags
from interlock.st.ast import Assign, Block, Bool, Call, Expression, If, Name, Nary, Not, Statement, Unit
from interlock.st.dialects.dialect import Dialect, Files
from interlock.st.parser import NotInSubset, parse_unit
from interlock.st.program import BEAT, INSTANCE, Runs, io_task, parted, watch_name, watches
from interlock.st.restart import RESTART, RESTARTING
from interlock.st.shared import label
from interlock.st.structures import plain


def compare_program(controller: Controller, a: Allocation, text: str) -> tuple[Difference, ...]:
    """What is wrong with a mapping program in the portable dialect; empty when nothing is."""
    try:
        unit = plain(parse_unit(text))
    except NotInSubset as error:
        return (Difference("text", f"cannot be read: {error}"),)
    return compare_mapping(controller, a, unit)


def compare_delivery(
    controller: Controller,
    a: Allocation,
    dialect: Dialect,
    files: Files,
    book: bytes | None = None,
) -> tuple[Difference, ...]:
    """What is wrong with a dialect's files, the interlocking and its mapping program; `book`: its table of tags."""
    try:
        core, io = parted(dialect.read(files))
        tags = read_tags(book or b"", label(f"IL_{portable(controller.name)}")) if dialect.tags else None
    except (NotInSubset, BadTags, KeyError, ValueError) as error:
        return (Difference("text", f"cannot be read: {error}"),)
    mapping = compare_mapping(controller, a, io, dialect.runs, dialect.restart, tags)
    return (*compare_unit(controller, core, dialect.restart).differences, *mapping)


def compare_mapping(
    controller: Controller,
    a: Allocation,
    unit: Unit,
    runs: Runs = Runs.CONFIGURATION,
    restart: bool = False,
    tags: Mapping[str, str] | None = None,
) -> tuple[Difference, ...]:
    """The same of a program that is read already.

    `restart`: it tells a restart to all that it calls.  `tags`: addresses by variable, where they stand in a table
    beside the program.
    """
    prefix = f"IL_{portable(controller.name)}"
    *before, program = unit.blocks
    made = {b.name: b for b in watches(controller, a, restart)}
    if (
        {b.name: b for b in before} != made
        or len(before) != len(made)
        or program.kind != "PROGRAM"
        or program.name != f"{prefix}_IO"
    ):
        return (Difference("text", "not the watches and a program as they are made"),)
    wrong: list[Difference] = []
    if unit.task != io_task(controller, runs, restart):
        wrong.append(Difference("task", "does not run the program as it should"))
    wrong += _declared(controller, a, program, tags, restart)
    steps = _steps(controller, a, restart)
    for mine, should in zip(program.body, steps, strict=False):
        if mine != should:
            name = mine.target if isinstance(mine, Assign) else getattr(mine, "instance", "IF")
            wrong.append(Difference(str(name), "is not as it should be"))
    if len(program.body) != len(steps):
        wrong.append(Difference("body", f"has {len(program.body)} statements, not {len(steps)}"))
    return tuple(wrong)


def _steps(controller: Controller, a: Allocation, restart: bool) -> list[Statement]:
    """What the program has to do, in this order."""
    told: tuple[tuple[str, Expression], ...] = ((RESTART, Name((RESTARTING,))),) if restart else ()
    beats = {c.substation: c.variable for c in a.heartbeats}
    bits = {c.substation: c.variable for c in a.diagnoses}
    watched = [(f"W_{portable(h.substation)}", beats[h.substation]) for h in a.health if h.beats]
    well: list[Expression] = [Name(("CYC", "WELL")), *(Name((w, "WELL")) for w, _ in watched)]
    well += [Name((bits[h.substation],)) for h in a.health if h.diagnosed]
    steps: list[Statement] = [Assign(Name((RESTARTING,)), Name((RESTART,)))] if restart else []
    steps.append(Call("CYC", told))
    steps += [Call(w, (*told, ("HB", Name((hb,))))) for w, hb in watched]
    steps.append(Assign(Name((controller.symbols.valid,)), Nary("AND", tuple(well))))
    steps.append(Call(INSTANCE, (*told, *((i.name, Name((i.name,))) for i in controller.inputs))))
    steps += [Assign(Name((o.name,)), Name((INSTANCE, o.name))) for o in controller.outputs]
    steps += [Assign(Name((n,)), Name((INSTANCE, n))) for n in controller.words.routes.values()]
    if a.sent:
        steps.append(Assign(Name((BEAT,)), Not(Name((BEAT,)))))
    steps += [Assign(Name((c.variable,)), Name((BEAT,))) for c in a.sent]
    return [*steps, If(Name((RESTARTING,)), (Assign(Name((RESTART,)), Bool(False)),))] if restart else steps


def _declared(
    controller: Controller, a: Allocation, program: Block, tags: Mapping[str, str] | None, restart: bool
) -> Iterator[Difference]:
    """What is wrong with the variables: addresses, instances, values at the start."""
    prefix = f"IL_{portable(controller.name)}"
    wanted = {c.variable: c.located for c in a.wires}
    found = dict(tags) if tags is not None else {d.name: d.address for d in program.locals if d.address}
    for n, x in wanted.items():
        if found.get(n) != x:
            yield Difference(n, f"has address {found.get(n)}, not {x}")
    for n in found:
        if n not in wanted:
            yield Difference(n, "has an address that nobody gave it")
    worked = {c.substation for c in a.channels if c.direction == "Q"}
    if {c.substation for c in a.sent} != worked or {h.substation for h in a.health} < worked:
        yield Difference(BEAT, "does not go to each substation that has outputs")
    if len(set(found.values())) != len(found):
        yield Difference("addresses", "one is given twice")
    instances = {d.name: d.type for d in program.locals if d.type not in ("BOOL", "INT")}
    own = {f"W_{portable(h.substation)}": watch_name(prefix, h.within_ms) for h in a.health if h.beats}
    if instances != {**own, "CYC": f"{prefix}_CYCLE", INSTANCE: prefix}:
        yield Difference("instances", "are not a watch for each heartbeat and the cycle, and the interlocking")
    if program.inputs or program.outputs:
        yield Difference(program.name, "is given something, or gives something, but by its addresses")
    yield from _beginnings(controller, a, program, restart)


def _beginnings(controller: Controller, a: Allocation, program: Block, restart: bool) -> Iterator[Difference]:
    """What the operator's place writes begins restrictive, words say nothing, wires and what is shown begin with no
    value of their own; each variable is there once, and no other."""
    start: dict[str, int] = {i.name: i.restrictive for i in controller.inputs}
    sizes: dict[str, int] = {i.name: i.size for i in controller.inputs}
    words = dict.fromkeys(controller.words.routes.values(), UNKNOWN)
    start, sizes = start | words, sizes | dict.fromkeys(words, 1)
    wires: set[str] = {*a.written, controller.symbols.valid, *words}
    for name, first, there in ((BEAT, 0, a.sent), (RESTART, 1, restart), (RESTARTING, 0, restart)):
        if there:
            start[name], sizes[name] = first, 0
            wires.add(name)
    plain = {*a.read, *(c.variable for c in a.wires)}
    needed = wires | plain
    for n in sorted({*wires, *a.read} - {d.name for d in program.locals}):
        yield Difference(n, "is not declared")
    if len({d.name.upper() for d in program.locals}) != len(program.locals):
        yield Difference("names", "one is declared twice")
    for d in program.locals:
        if d.type in ("BOOL", "INT") and d.name not in needed:
            yield Difference(d.name, "is a variable that nobody needs")
        if d.name not in wires and (d.initial is not None or (d.name in plain and d.type != "BOOL")):
            yield Difference(d.name, "begins with a value that nobody gave it, or is no bit")
        if d.name in wires:
            value = getattr(d.initial, "value", None)
            typed = d.begins_as_typed and d.type == ("INT" if sizes[d.name] else "BOOL")
            if value is None or int(value) != start[d.name] or not typed:
                yield Difference(d.name, "does not begin with its restrictive value")
