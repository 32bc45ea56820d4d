"""The mapping program carries every wire to its variable and back: read back from its text and compared, name by name.

The interlocking is proved for every value of its inputs, so nothing more is asked of the mapping than this: each input
gets its own wire (or the operator's variable of its name), each wire to the outside gets its own output, each word a
variable, no address twice, VALID only while no cycle was too long and every substation's watch says that it is alive,
and one task.
"""

from __future__ import annotations

from interlock.logic.cabinet import Allocation
from interlock.logic.controller import Controller
from interlock.model.portable import portable
from interlock.proof.equivalence.structured_text import Difference
from interlock.st.ast import Assign, Call, Expression, Name, Nary
from interlock.st.parser import NotInSubset, parse_unit
from interlock.st.program import cycle, io_task, watch


def compare_program(controller: Controller, a: Allocation, text: str) -> tuple[Difference, ...]:
    """What is wrong with a mapping program; empty when nothing is."""
    try:
        unit = parse_unit(text)
    except NotInSubset as error:
        return (Difference("text", f"cannot be read: {error}"),)
    prefix = f"IL_{portable(controller.name)}"
    watches_of = (watch(f"{prefix}_WATCH"), cycle(f"{prefix}_CYCLE"))
    *before, program = unit.blocks
    if tuple(before) != watches_of or program.kind != "PROGRAM" or program.name != f"{prefix}_IO":
        return (Difference("text", "not the watches and a program as they are made"),)
    wrong: list[Difference] = []
    if unit.task != io_task(controller):
        wrong.append(Difference("task", "does not run the program as it should"))
    wanted = {c.variable: c.located for c in (*a.heartbeats, *a.channels)}
    found = {d.name: d.address for d in program.locals if d.address}
    wrong += [Difference(n, f"has address {found.get(n)}, not {x}") for n, x in wanted.items() if found.get(n) != x]
    wrong += [Difference(n, "has an address that nobody gave it") for n in found if n not in wanted]
    if len(set(found.values())) != len(found):
        wrong.append(Difference("addresses", "one is given twice"))
    instances = {d.name: d.type for d in program.locals if d.type not in ("BOOL", "INT")}
    watches = {f"W_{portable(c.substation)}": c.variable for c in a.heartbeats}
    if instances != {**dict.fromkeys(watches, f"{prefix}_WATCH"), "CYC": f"{prefix}_CYCLE", "RUN": prefix}:
        wrong.append(Difference("instances", "are not a watch for each substation and the cycle, and the interlocking"))
    valid = controller.symbols.valid
    alive: tuple[Expression, ...] = (Name(("CYC", "OK")), *(Name((w, "OK")) for w in watches))
    steps: list[Assign | Call] = [Call("CYC", ())]
    steps += [Call(w, (("HB", Name((hb,))),)) for w, hb in watches.items()]
    steps.append(Assign(Name((valid,)), Nary("AND", alive)))
    steps.append(Call("RUN", tuple((i.name, Name((i.name,))) for i in controller.inputs)))
    steps += [Assign(Name((o.name,)), Name(("RUN", o.name))) for o in controller.outputs]
    steps += [Assign(Name((n,)), Name(("RUN", n))) for n in controller.words.routes.values()]
    for mine, should in zip(program.body, steps, strict=False):
        if mine != should:
            name = mine.target if isinstance(mine, Assign) else getattr(mine, "instance", "IF")
            wrong.append(Difference(str(name), "is not as it should be"))
    if len(program.body) != len(steps):
        wrong.append(Difference("body", f"has {len(program.body)} statements, not {len(steps)}"))
    start: dict[str, int] = {i.name: i.restrictive for i in controller.inputs}
    wires: set[str] = {*a.written, valid}
    for d in program.locals:
        if d.name in wires:
            value = getattr(d.initial, "value", None)
            if value is None or int(value) != start[d.name]:
                wrong.append(Difference(d.name, "does not begin with its restrictive value"))
    return tuple(wrong)
