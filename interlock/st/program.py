"""The mapping program: the only place with addresses.

It watches the cycle and the substations, calls the interlocking once, carries every wire to its variable and back,
every word to a variable of its own, and tells the substations that it is alive.
"""

from __future__ import annotations

from collections.abc import Sequence
from enum import StrEnum

from interlock.logic.cabinet import Allocation
from interlock.logic.controller import Controller, Input
from interlock.logic.on_delay import CYCLE_MAX_MS
from interlock.logic.words import UNKNOWN
from interlock.model.elements import HEARTBEAT_MS
from interlock.model.portable import portable
from interlock.st.ast import (
    Assign,
    Block,
    Bool,
    Call,
    Declaration,
    Expression,
    If,
    Int,
    Name,
    Nary,
    Not,
    Statement,
    Task,
    Time,
    Unit,
)
from interlock.st.restart import RESTART, RESTARTING, restarted

CYCLE_MS = 100  # our choice
INSTANCE = "RUN"
BEAT = "BEAT"


def watch(name: str, within_ms: int = HEARTBEAT_MS) -> Block:
    """WELL while the heartbeat changes at least once in the time; never before it has changed since the restart."""
    hb, last, run, ok = (Name((n,)) for n in ("HB", "LAST", "RUNS", "WELL"))
    same = Name(("SAME",))
    both = Nary("OR", (Nary("AND", (hb, last)), Nary("AND", (Not(hb), Not(last)))))
    alive = Nary("AND", (run, Not(Name(("STILL", "Q"))), Nary("OR", (ok, Not(same)))))
    return Block(
        name,
        (Declaration("HB", "BOOL", None, "heartbeat of a substation"),),
        (Declaration("WELL", "BOOL", Bool(False), "the substation is alive"),),
        (
            Declaration("LAST", "BOOL", Bool(False), "heartbeat in the last scan"),
            Declaration("RUNS", "BOOL", Bool(False), "false in the first scan after a restart"),
            Declaration("SAME", "BOOL", Bool(False)),
            Declaration("STILL", "TON", None, "no change for too long"),
        ),
        (
            Assign(same, both, "no change since the last scan"),
            Call("STILL", (("IN", same), ("PT", Time(within_ms)))),
            Assign(ok, alive, "alive"),
            Assign(last, hb),
            Assign(run, Bool(True)),
        ),
        "watches the heartbeat of a substation",
    )


def cycle(name: str) -> Block:
    """WELL while no cycle takes too long: three timers in turn, each running from one scan to the next.

    After a longer cycle nobody knows what happened meanwhile; its inputs count as lost, as in the Python runtime.
    """
    ok = Name(("WELL",))
    turns = tuple(Name((f"TURN{n}",)) for n in range(3))
    runs = tuple(Name((f"RUN{n}",)) for n in range(3))
    body: list[Assign | Call] = []
    for n in range(3):
        body.append(
            Assign(runs[n], Nary("OR", (turns[n], turns[(n + 1) % 3])), f"from one scan of {turns[n]} to the next")
        )
        body.append(Call(f"LONG{n}", (("IN", runs[n]), ("PT", Time(CYCLE_MAX_MS + 1)))))
    late = tuple(Nary("AND", (Name((f"LONG{n}", "Q")), turns[(n + 1) % 3])) for n in range(3))
    body.append(Assign(ok, Not(Nary("OR", late)), "the last cycle was short enough"))
    body.append(Assign(Name(("NEXT",)), turns[2]))
    body += [Assign(turns[2], turns[1]), Assign(turns[1], turns[0]), Assign(turns[0], Name(("NEXT",)))]
    first = (Bool(True), Bool(False), Bool(False))
    return Block(
        name,
        (),
        (Declaration("WELL", "BOOL", Bool(False), "the last cycle was short enough"),),
        (
            *(Declaration(f"TURN{n}", "BOOL", first[n]) for n in range(3)),
            *(Declaration(f"RUN{n}", "BOOL", Bool(False)) for n in range(3)),
            Declaration("NEXT", "BOOL", Bool(False)),
            *(Declaration(f"LONG{n}", "TON") for n in range(3)),
        ),
        tuple(body),
        "watches the time between two scans",
    )


class Runs(StrEnum):
    """What runs the mapping program: a task of a configuration, one of the application of a device, as CODESYS has it,
    a task that is a file of its own, or what a Siemens controller calls in each of its cycles."""

    CONFIGURATION = "configuration"
    APPLICATION = "application"
    TASK = "task"
    CYCLE = "OB1"


def io_task(controller: Controller, runs: Runs = Runs.CONFIGURATION, restart: bool = False) -> Task:
    """What runs the mapping program, and after a restart tells it so."""
    prefix = f"IL_{portable(controller.name)}"
    program, startup = f"{prefix}_IO", RESTART if restart else ""
    if runs is Runs.CYCLE:
        return Task("", "", runs.value, 0, "", program, startup)
    if runs is Runs.TASK:
        return Task("", "", f"{prefix}_TASK", CYCLE_MS, "", program, startup)
    if runs is Runs.APPLICATION:
        return Task("Device", "Application", f"{prefix}_TASK", CYCLE_MS, "", program, startup)
    return Task(f"{prefix}_CONF", f"{prefix}_RES", f"{prefix}_TASK", CYCLE_MS, f"{prefix}_MAIN", program, startup)


def watch_name(prefix: str, within_ms: int) -> str:
    """The block that watches heartbeats of a time."""
    return f"{prefix}_WATCH" if within_ms == HEARTBEAT_MS else f"{prefix}_H{within_ms}"


def watches(controller: Controller, a: Allocation, restart: bool = False) -> tuple[Block, ...]:
    """The blocks that watch: one for each time of a heartbeat, and the one of the cycle."""
    prefix = f"IL_{portable(controller.name)}"
    times = sorted({h.within_ms for h in a.health if h.beats}, reverse=True)
    made = (*(watch(watch_name(prefix, ms), ms) for ms in times), cycle(f"{prefix}_CYCLE"))
    return tuple(map(restarted, made)) if restart else made


def joined(core: Unit, io: Unit) -> Unit:
    """The interlocking with its mapping program, which comes last."""
    return Unit((*io.blocks[:-1], *core.blocks, io.blocks[-1]), io.header, task=io.task, index=core.index)


def parted(unit: Unit) -> tuple[Unit, Unit]:
    """The interlocking, its main block last, and the mapping program with its watches.  Raises ValueError."""
    *blocks, program = unit.blocks
    types = {d.name: d.type for d in program.locals}
    helpers = {t for n, t in types.items() if n != INSTANCE}
    mains = [b for b in blocks if b.name == types.get(INSTANCE)]
    if program.kind != "PROGRAM" or len(mains) != 1:
        raise ValueError("no program that calls one interlocking")
    core = [b for b in blocks if b.name not in helpers and b is not mains[0]]
    return Unit((*core, *mains)), Unit((*(b for b in blocks if b.name in helpers), program), task=unit.task)


def io_program(
    controller: Controller,
    a: Allocation,
    header: Sequence[str],
    runs: Runs = Runs.CONFIGURATION,
    restart: bool = False,
) -> Unit:
    """The watches and the program; the interlocking itself stands before them, or in a file of its own.

    `restart`: the tool keeps variables over a restart; the program tells it to all that it calls, then forgets it.
    """
    prefix = f"IL_{portable(controller.name)}"
    sizes: dict[str, Input] = {i.name: i for i in controller.inputs}
    notes: dict[str, str] = {o.name: o.note for o in controller.outputs}
    blocks = watches(controller, a, restart)
    valid = controller.symbols.valid
    declared = [Declaration(c.variable, "BOOL", None, f"{c.substation}: {c.note}", c.located) for c in a.wires]
    for n in a.written:
        i = sizes[n]
        initial: Expression = Int(i.restrictive) if i.size else Bool(bool(i.restrictive))
        declared.append(Declaration(n, "INT" if i.size else "BOOL", initial, i.note))
    declared += [Declaration(n, "BOOL", None, notes[n]) for n in a.read]
    words = [controller.words.by_name[n] for n in controller.words.routes.values()]
    declared += [Declaration(w.name, "INT", Int(UNKNOWN), w.note) for w in words]
    declared.append(Declaration(valid, "BOOL", Bool(False), sizes[valid].note))
    if restart:
        declared.append(Declaration(RESTART, "BOOL", Bool(True), "true until the first call after a restart is over"))
        declared.append(Declaration(RESTARTING, "BOOL", Bool(False), "true in the first call after a restart"))
    within = {h.substation: h.within_ms for h in a.health}
    watched = [(c, f"W_{portable(c.substation)}") for c in a.heartbeats]
    for c, w in watched:
        kind = watch_name(prefix, within[c.substation])
        declared.append(Declaration(w, kind, None, f"watches substation {c.substation}"))
    declared.append(Declaration("CYC", blocks[-1].name, None, "watches the cycle"))
    declared.append(Declaration(INSTANCE, prefix, None, "the interlocking"))
    if a.sent:
        declared.append(Declaration(BEAT, "BOOL", Bool(False), "changes in every cycle"))
    told: tuple[tuple[str, Expression], ...] = ((RESTART, Name((RESTARTING,))),) if restart else ()
    well: list[Expression] = [Name(("CYC", "WELL")), *(Name((w, "WELL")) for _, w in watched)]
    well += [Name((c.variable,)) for c in a.diagnoses]
    body: list[Statement] = []
    if restart:
        body.append(Assign(Name((RESTARTING,)), Name((RESTART,)), "looked at once: it may be set while this runs"))
    body.append(Call("CYC", told))
    body += [Call(w, (*told, ("HB", Name((c.variable,))))) for c, w in watched]
    body.append(Assign(Name((valid,)), Nary("AND", tuple(well))))
    body.append(Call(INSTANCE, (*told, *((i.name, Name((i.name,))) for i in controller.inputs))))
    body += [Assign(Name((o.name,)), Name((INSTANCE, o.name))) for o in controller.outputs]
    body += [Assign(Name((w.name,)), Name((INSTANCE, w.name))) for w in words]
    if a.sent:
        body.append(Assign(Name((BEAT,)), Not(Name((BEAT,)))))
        body += [Assign(Name((c.variable,)), Name((BEAT,))) for c in a.sent]
    if restart:
        body.append(If(Name((RESTARTING,)), (Assign(Name((RESTART,)), Bool(False), "the restart is over"),)))
    note = "inputs, interlocking, outputs: run it in one task with a constant cycle"
    program = Block(f"{prefix}_IO", (), (), tuple(declared), tuple(body), note, "PROGRAM")
    return Unit((*blocks, program), tuple(header), task=io_task(controller, runs, restart))
