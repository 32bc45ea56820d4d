"""The mapping program carries every wire to its variable and back: read back from its text and compared, name by name.

The interlocking is proved for every value of its inputs, so nothing more is asked of the mapping than this: each input
gets its own wire (or the operator's variable of its name), each wire to the outside gets its own output, no address
twice, VALID only while no cycle was too long and every substation is seen to be well (its watch, its diagnosis bit, or
both), each substation with outputs gets a heartbeat that changes in every cycle, and one task.
"""

from __future__ import annotations

from collections.abc import Iterator

from interlock.logic.cabinet import Allocation
from interlock.logic.controller import Controller
from interlock.model.portable import portable
from interlock.proof.equivalence.structured_text import Difference
from interlock.st.ast import Assign, Block, Call, Expression, Name, Nary, Not
from interlock.st.parser import NotInSubset, parse_unit
from interlock.st.program import io_task, watch_name, watches


def compare_program(controller: Controller, a: Allocation, text: str) -> tuple[Difference, ...]:
    """What is wrong with a mapping program; empty when nothing is."""
    try:
        unit = parse_unit(text)
    except NotInSubset as error:
        return (Difference("text", f"cannot be read: {error}"),)
    prefix = f"IL_{portable(controller.name)}"
    *before, program = unit.blocks
    if tuple(before) != watches(controller, a) or program.kind != "PROGRAM" or program.name != f"{prefix}_IO":
        return (Difference("text", "not the watches and a program as they are made"),)
    wrong: list[Difference] = []
    if unit.task != io_task(controller):
        wrong.append(Difference("task", "does not run the program as it should"))
    wrong += _declared(controller, a, program)
    steps = _steps(controller, a)
    for mine, should in zip(program.body, steps, strict=False):
        if mine != should:
            name = mine.target if isinstance(mine, Assign) else getattr(mine, "instance", "IF")
            wrong.append(Difference(str(name), "is not as it should be"))
    if len(program.body) != len(steps):
        wrong.append(Difference("body", f"has {len(program.body)} statements, not {len(steps)}"))
    return tuple(wrong)


def _steps(controller: Controller, a: Allocation) -> list[Assign | Call]:
    """What the program has to do, in this order."""
    beats = {c.substation: c.variable for c in a.heartbeats}
    bits = {c.substation: c.variable for c in a.diagnoses}
    watched = [(f"W_{portable(h.substation)}", beats[h.substation]) for h in a.health if h.beats]
    well: list[Expression] = [Name(("CYC", "OK")), *(Name((w, "OK")) for w, _ in watched)]
    well += [Name((bits[h.substation],)) for h in a.health if h.diagnosed]
    steps: list[Assign | Call] = [Call("CYC", ())]
    steps += [Call(w, (("HB", Name((hb,))),)) for w, hb in watched]
    steps.append(Assign(Name((controller.symbols.valid,)), Nary("AND", tuple(well))))
    steps.append(Call("RUN", tuple((i.name, Name((i.name,))) for i in controller.inputs)))
    steps += [Assign(Name((o.name,)), Name(("RUN", o.name))) for o in controller.outputs]
    if a.sent:
        steps.append(Assign(Name(("BEAT",)), Not(Name(("BEAT",)))))
    return steps + [Assign(Name((c.variable,)), Name(("BEAT",))) for c in a.sent]


def _declared(controller: Controller, a: Allocation, program: Block) -> Iterator[Difference]:
    """What is wrong with the variables: addresses, instances, values at the start."""
    prefix = f"IL_{portable(controller.name)}"
    wanted = {c.variable: c.located for c in a.wires}
    found = {d.name: d.address for d in program.locals if d.address}
    for n, x in wanted.items():
        if found.get(n) != x:
            yield Difference(n, f"has address {found.get(n)}, not {x}")
    for n in found:
        if n not in wanted:
            yield Difference(n, "has an address that nobody gave it")
    worked = {c.substation for c in a.channels if c.direction == "Q"}
    if {c.substation for c in a.sent} != worked or {h.substation for h in a.health} < worked:
        yield Difference("BEAT", "does not go to each substation that has outputs")
    if len(set(found.values())) != len(found):
        yield Difference("addresses", "one is given twice")
    instances = {d.name: d.type for d in program.locals if d.type not in ("BOOL", "INT")}
    own = {f"W_{portable(h.substation)}": watch_name(prefix, h.within_ms) for h in a.health if h.beats}
    if instances != {**own, "CYC": f"{prefix}_CYCLE", "RUN": prefix}:
        yield Difference("instances", "are not a watch for each heartbeat and the cycle, and the interlocking")
    start: dict[str, int] = {i.name: i.restrictive for i in controller.inputs} | {"BEAT": 0}
    wires = {*a.written, controller.symbols.valid, *(("BEAT",) if a.sent else ())}
    values = {d.name: getattr(d.initial, "value", None) for d in program.locals}
    for n in sorted(wires):
        value = values.get(n)
        if value is None or int(value) != start[n]:
            yield Difference(n, "does not begin with its restrictive value")
