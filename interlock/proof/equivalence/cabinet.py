"""The mapping program carries every wire to its variable and back: read back from its text and compared, name by name.

The interlocking is proved for every value of its inputs, so nothing more is asked of the mapping than this: each input
gets its own wire (or the operator's variable of its name), each wire to the outside gets its own output, each word a
variable, no address twice, VALID only while no cycle was too long and every substation's watch says that it is alive,
and one task.
"""

from __future__ import annotations

from collections.abc import Mapping

from interlock.logic.cabinet import Allocation
from interlock.logic.controller import Controller
from interlock.model.portable import portable
from interlock.proof.equivalence.structured_text import Difference, compare_unit
from interlock.proof.equivalence.tags import BadTags, read_tags
from interlock.st.ast import Assign, Bool, Call, Declaration, Expression, Name, Nary, Unit
from interlock.st.dialects import Dialect, Files
from interlock.st.parser import NotInSubset, parse_unit
from interlock.st.program import INSTANCE, Runs, io_task, parted, watches
from interlock.st.restart import RESTART


def compare_program(controller: Controller, a: Allocation, text: str) -> tuple[Difference, ...]:
    """What is wrong with a mapping program in the portable dialect; empty when nothing is."""
    try:
        unit = parse_unit(text)
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
        tags = read_tags(book or b"") if dialect.tags else None
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
    made = {b.name: b for b in watches(prefix, restart)}
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
    wanted = {c.variable: c.located for c in (*a.heartbeats, *a.channels)}
    found = dict(tags) if tags is not None else {d.name: d.address for d in program.locals if d.address}
    wrong += [Difference(n, f"has address {found.get(n)}, not {x}") for n, x in wanted.items() if found.get(n) != x]
    wrong += [Difference(n, "has an address that nobody gave it") for n in found if n not in wanted]
    if len(set(found.values())) != len(found):
        wrong.append(Difference("addresses", "one is given twice"))
    instances = {d.name: d.type for d in program.locals if d.type not in ("BOOL", "INT")}
    guards = {f"W_{portable(c.substation)}": c.variable for c in a.heartbeats}
    if instances != {**dict.fromkeys(guards, f"{prefix}_WATCH"), "CYC": f"{prefix}_CYCLE", INSTANCE: prefix}:
        wrong.append(Difference("instances", "are not a watch for each substation and the cycle, and the interlocking"))
    steps = _steps(controller, guards, restart)
    for mine, should in zip(program.body, steps, strict=False):
        if mine != should:
            name = mine.target if isinstance(mine, Assign) else getattr(mine, "instance", "IF")
            wrong.append(Difference(str(name), "is not as it should be"))
    if len(program.body) != len(steps):
        wrong.append(Difference("body", f"has {len(program.body)} statements, not {len(steps)}"))
    return (*wrong, *_beginnings(controller, a, program.locals, restart))


def _steps(controller: Controller, guards: Mapping[str, str], restart: bool) -> list[Assign | Call]:
    """What the program has to do, in order."""
    told: tuple[tuple[str, Expression], ...] = ((RESTART, Name((RESTART,))),) if restart else ()
    alive: tuple[Expression, ...] = (Name(("CYC", "OK")), *(Name((w, "OK")) for w in guards))
    steps: list[Assign | Call] = [Call("CYC", told)]
    steps += [Call(w, (*told, ("HB", Name((hb,))))) for w, hb in guards.items()]
    steps.append(Assign(Name((controller.symbols.valid,)), Nary("AND", alive)))
    steps.append(Call(INSTANCE, (*told, *((i.name, Name((i.name,))) for i in controller.inputs))))
    steps += [Assign(Name((o.name,)), Name((INSTANCE, o.name))) for o in controller.outputs]
    steps += [Assign(Name((n,)), Name((INSTANCE, n))) for n in controller.words.routes.values()]
    return [*steps, Assign(Name((RESTART,)), Bool(False))] if restart else steps


def _beginnings(
    controller: Controller, a: Allocation, declared: tuple[Declaration, ...], restart: bool
) -> list[Difference]:
    """What the operator's place writes begins with what permits least, each variable is there once."""
    start: dict[str, int] = {i.name: i.restrictive for i in controller.inputs}
    sizes: dict[str, int] = {i.name: i.size for i in controller.inputs}
    wires: set[str] = {*a.written, controller.symbols.valid}
    if restart:
        start[RESTART], sizes[RESTART] = 1, 0
        wires.add(RESTART)
    wrong = [Difference(n, "is not declared") for n in sorted({*wires, *a.read} - {d.name for d in declared})]
    if len({d.name for d in declared}) != len(declared):
        wrong.append(Difference("names", "one is declared twice"))
    for d in declared:
        if d.name in wires:
            value = getattr(d.initial, "value", None)
            if value is None or int(value) != start[d.name] or d.type != ("INT" if sizes[d.name] else "BOOL"):
                wrong.append(Difference(d.name, "does not begin with its restrictive value"))
    return wrong
