"""A restart as an input, for tools whose data keep their values over a restart.

While RESTART is true the scan ends in the initial state with all timers stopped, whatever was kept; the outputs follow
from it, and the words say that nothing is known.

The mapping program looks at RESTART once, in RESTARTING, and clears it only in a call that has begun with it: an S7-400
that goes on where its power was cut (hot restart) carries out the rest of a call that has begun without it, and must
not forget it there.
"""

from __future__ import annotations

from dataclasses import replace

from interlock.logic.words import UNKNOWN
from interlock.st.ast import Assign, Block, Bool, Call, Declaration, If, Int, Name, Nary, Not, Statement, Unit

RESTART, RESTARTING = "RESTART", "RESTARTING"


def with_restart(unit: Unit) -> Unit:
    """The unit with an input RESTART in its main block and in every block that keeps state or has timers."""
    timing = {b.name for b in unit.blocks[:-1] if any(d.type == "TON" for d in b.locals)}
    keeping = {b.name for b in unit.blocks[:-1] if b.outputs and all(f"N_{d.name}" in b.input_names for d in b.outputs)}
    saying = {b.name for b in unit.blocks[:-1] if any(d.type == "INT" for d in b.outputs)}
    main = unit.blocks[-1]
    types = {d.name: d.type for d in main.locals}
    signal = Declaration(RESTART, "BOOL", Bool(True), "true in the first scan after a restart: everything is locked")

    def passed(s: Statement) -> Statement:
        if isinstance(s, Call) and types.get(s.instance) in keeping | timing | saying:
            return replace(s, params=((RESTART, Name((RESTART,))), *s.params))
        return s

    blocks = [
        _keeping(b, signal)
        if b.name in keeping
        else _timing(b, signal)
        if b.name in timing
        else _saying(b, signal)
        if b.name in saying
        else b
        for b in unit.blocks[:-1]
    ]
    whole = replace(main, inputs=(signal, *main.inputs), body=tuple(map(passed, main.body)))
    return replace(unit, blocks=(*blocks, whole))


def _keeping(b: Block, signal: Declaration) -> Block:
    initial = tuple(Assign(Name((d.name,)), d.initial or Bool(False)) for d in b.outputs)
    return replace(b, inputs=(signal, *b.inputs), body=(If(Name((RESTART,)), initial, b.body),))


def _saying(b: Block, signal: Declaration) -> Block:
    """Words say that nothing is known."""
    unknown = tuple(Assign(Name((d.name,)), Int(UNKNOWN)) for d in b.outputs)
    return replace(b, inputs=(signal, *b.inputs), body=(If(Name((RESTART,)), unknown, b.body),))


def _timing(b: Block, signal: Declaration) -> Block:
    """Each timer's input by way of a variable of its own, which RESTART holds false."""
    statements: list[Statement] = []
    extra: list[Declaration] = []
    for s in b.body:
        if isinstance(s, Call):
            given = dict(s.params)
            run = Name((f"T_{len(extra) + 1}",))
            extra.append(Declaration(run.parts[0], "BOOL"))
            statements.append(Assign(run, Nary("AND", (Not(Name((RESTART,))), given["IN"]))))
            statements.append(replace(s, params=tuple((n, run if n == "IN" else x) for n, x in s.params)))
        else:
            statements.append(s)
    return replace(b, inputs=(signal, *b.inputs), locals=(*b.locals, *extra), body=tuple(statements))


def restarted(b: Block) -> Block:
    """A block that keeps values and has timers of its own: while RESTART is true its timers stop, and it ends as it
    begins."""
    timed = _timing(b, Declaration(RESTART, "BOOL", Bool(True), "true in the first scan after a restart"))
    kept = [(d.name, d.initial) for d in (*b.outputs, *b.locals) if d.type == "BOOL"]
    initial = tuple(Assign(Name((n,)), x) for n, x in kept if x is not None)
    return replace(timed, body=(*timed.body, If(Name((RESTART,)), initial)))
