"""Points (R10): detection, when a machine may move, commands, supervision.

A machine moves only when the sections of all its ends are unlocked and reported clear and nobody needs it as
flank protection; for a route only when none of them is blocked.  The command is held; in the initial state there is
none, so that nothing moves at start-up.
"""

from __future__ import annotations

from collections.abc import Mapping

from interlock.logic import names, rules
from interlock.logic.controller import Input, Join, Output, Term
from interlock.logic.expr import FALSE, TRUE, Expr, conj, disj, neg, var
from interlock.logic.lower import added, ways
from interlock.logic.lower.draft import Draft
from interlock.model.elements import MachineId, Position
from interlock.model.machines import other_doors
from interlock.model.times import supervision_s
from interlock.table.cells import Role


def inputs(d: Draft) -> None:
    """Detection contacts and manual commands."""
    for m in d.machines.all:
        for x in Position:
            d.inputs.append(Input(names.CONTACT(m, x), f"machine {m} detected {d.layout.machines.word(m, x)}"))
        for x in Position:
            d.inputs.append(
                Input(names.MOVE_BY_HAND(m, x), f"operator: move machine {m} {d.layout.machines.word(m, x)}")
            )
        if m in d.machines.powered:
            d.inputs.append(Input(names.LOOKED_AT(m), f"operator: machine {m} has been looked at after it was trailed"))


def detection(d: Draft) -> None:
    """Contacts 10 and 01 are positions; 00 and 11 are none (R10)."""
    for m in d.machines.all:
        for x in Position:
            d.wire(
                names.DETECTED(m, x),
                Join.ALL,
                (
                    Term(var(names.VALID), "inputs valid"),
                    Term(var(names.CONTACT(m, x)), "contact"),
                    Term(neg(var(names.CONTACT(m, x.other))), "no opposite contact"),
                ),
                f"point {m}",
                f"machine {m} lies {x} ({rules.POINTS})",
            )


def flank_demands(d: Draft) -> dict[tuple[MachineId, Position], Expr]:
    """For each machine and position: some lock needs it so as flank protection."""
    found: dict[tuple[MachineId, Position], list[Expr]] = {}
    for t in d.table.locks:
        for p in t.points:
            if p.role is Role.FLANK:
                found.setdefault((p.machine, p.position), []).append(d.overlaps.holding(t.key))
    return {k: disj(xs) for k, xs in found.items()}


def movable(d: Draft) -> None:
    """Free to move: nothing locked, nothing occupied, no flank held (R10; never a shared flag)."""
    flank = flank_demands(d)
    for m in (m for m in d.machines.all if other_doors(d.layout.machines, m)):
        d.wire(
            names.OTHERS_SHUT(m),
            Join.ALL,
            [t for other in other_doors(d.layout.machines, m) for t in _shut(d, other)],
            f"point {m}",
            f"the other doors of its air lock are shut ({rules.LEVEL_CROSSINGS})",
        )
    for m in d.machines.all:
        terms: list[Term] = [Term(var(names.VALID), "inputs valid")]
        for s in d.machines.sections_of(m):
            terms.append(Term(var(names.FREE(s)), "point section free", f"{s} not locked"))
            terms.append(Term(d.sections.clear(s), "point section clear", f"{s} clear"))
        by_routes = added.held(d, m)
        if by_routes:
            terms.append(Term(neg(disj(by_routes)), "added point not held", f"no route holds {m} that was added to it"))
        for x in Position:
            held = flank.get((m, x), FALSE)
            terms.append(Term(neg(held), "flank not held", f"nobody needs {m} {x} as flank protection"))
        d.wire(names.MOVABLE(m), Join.ALL, terms, f"point {m}", f"machine {m} is free to move ({rules.POINTS})")
        for x in Position:
            closes = [Term(TRUE, "closes", "it can always be closed")] if _closing(d, m, x) else []
            d.wire(
                names.POINT_AVAILABLE(m, x),
                Join.ANY,
                (
                    *closes,
                    Term(_comes_to_lie(d, m, x), "commanded", f"commanded {x}, and lies there or is on its way"),
                    Term(conj((var(names.MOVABLE(m)), *(t.expr for t in ways.unblocked(d, m)))), "free to move"),
                    Term(
                        conj((d.machines.detected(m, x), *(neg(d.machines.command(m, y)) for y in Position))),
                        "lies there since the restart",
                    ),
                ),
                f"point {m}",
                f"machine {m} can be demanded {x}",
            )


def _shut(d: Draft, m: MachineId) -> list[Term]:
    """A door is proved shut, and was not commanded open in the scan before (R13)."""
    lies, opens = d.machines.detected(m, Position.NORMAL), d.machines.command(m, Position.REVERSE)
    return [Term(lies, "other door shut", f"{m} shut"), Term(neg(opens), "other door not commanded open")]


def _comes_to_lie(d: Draft, m: MachineId, x: Position) -> Expr:
    """The machine is commanded there already, and lies there or its drive is not kept off: what a block has stopped
    half-way does not come by itself, so that a route would be granted whose points never lie."""
    arrives = disj((d.machines.detected(m, x), neg(d.machines.kept_off(m))))
    return conj((d.machines.command(m, x), arrives))


def _closing(d: Draft, m: MachineId, x: Position) -> bool:
    """To close a level crossing, a bridge or another device is always permitted: it opens nothing for a train (R13);
    but for one that the author has routes hold open to its road, as the doors of an air lock."""
    device = m in d.layout.machines.device and not other_doors(d.layout.machines, m)
    return device and x is Position.REVERSE and (m, x.other) not in added.demanded(d)


def commands(d: Draft) -> None:
    """Commands follow grants; by hand only when free and not touched by a grant in this scan."""
    touches, demands = ways.demands(d)
    driving = _driving(d)
    for m in d.machines.all:
        terms = [Term(touches[m], "granted", "a way over it, or one that demands it")]
        touched = d.wire(names.TOUCHED(m), Join.ANY, terms, f"point {m}", f"a grant touches machine {m} in this scan")
        for x in Position:
            granted, driven = demands[m, x], driving.get((m, x), FALSE)
            terms = [Term(granted, "granted")]
            if driven is not FALSE:
                free = (var(names.MOVABLE(m)), *(t.expr for t in ways.unblocked(d, m)))
                terms.append(Term(conj((driven, *free)), "driven along", "beside the path, if free to move"))
            if m in d.layout.machines.device and x is Position.NORMAL:
                back = conj((var(names.MOVABLE(m)), neg(touched), neg(var(names.MOVE_BY_HAND(m, x.other)))))
                terms.append(
                    Term(back, "returns", f"opens by itself when nothing is locked over it ({rules.LEVEL_CROSSINGS})")
                )
            d.wire(names.DEMANDED(m, x), Join.ANY, terms, f"point {m}", f"a grant needs {m} {x}")
            d.wire(
                names.MOVED_BY_HAND(m, x),
                Join.ALL,
                (
                    Term(var(names.MOVE_BY_HAND(m, x)), "by hand"),
                    Term(neg(var(names.MOVE_BY_HAND(m, x.other))), "not both by hand"),
                    *(
                        []
                        if _closing(d, m, x)
                        else [
                            Term(var(names.MOVABLE(m)), "point free by hand"),
                            Term(neg(touched), "no grant in this scan"),
                        ]
                    ),
                    *_apart_by_hand(d, m, x, demands),
                ),
                f"point {m}",
                f"machine {m} moved {x} by hand",
            )
        for x in Position:
            _keep_command(d, m, x)


def _apart_by_hand(
    d: Draft, m: MachineId, x: Position, demands: Mapping[tuple[MachineId, Position], Expr]
) -> list[Term]:
    """A door of an air lock is opened by hand only while the others are shut, and nothing opens one in this scan; of
    two that somebody opens by hand in one scan the first is opened (R13)."""
    if x is Position.NORMAL or not other_doors(d.layout.machines, m):
        return []
    others = other_doors(d.layout.machines, m)
    granted = disj(demands[other, x] for other in others)
    by_hand = disj(var(names.MOVED_BY_HAND(other, x)) for other in others if other < m)
    return [
        Term(var(names.OTHERS_SHUT(m)), "other doors shut", "the other doors of its air lock are shut"),
        Term(neg(granted), "no other door opens", "no grant opens another one in this scan"),
        Term(neg(by_hand), "no other door opens", "nor is one before it opened by hand"),
    ]


def _keep_command(d: Draft, m: MachineId, x: Position) -> None:
    """A command is given by a grant or by hand, and stays until the opposite one is."""
    d.wire(
        names.COMMAND_HELD(m, x),
        Join.ALL,
        (
            Term(d.machines.command(m, x), "held"),
            Term(neg(var(names.DEMANDED(m, x.other))), "no opposite grant"),
            Term(neg(var(names.MOVED_BY_HAND(m, x.other))), "not moved by hand"),
        ),
        f"point {m}",
        f"the command {x} stays",
    )
    d.kept(
        names.COMMAND(m, x),
        False,
        f"machine {m} commanded {x}",
        Join.ANY,
        (
            Term(var(names.DEMANDED(m, x)), "granted"),
            Term(var(names.MOVED_BY_HAND(m, x)), "by hand"),
            Term(var(names.COMMAND_HELD(m, x)), "held"),
        ),
        f"point {m}",
    )
    runs = conj((d.machines.command(m, x), d.machines.started(m), neg(d.machines.kept_off(m))))
    d.outputs.append(Output(names.DRIVE(m, x), runs, False, f"machine {m}: {d.layout.machines.word(m, x)}"))


def _driving(d: Draft) -> dict[tuple[MachineId, Position], Expr]:
    """The grants that drive a machine beside their path."""
    found: dict[tuple[MachineId, Position], list[Expr]] = {}
    for r in d.table.routes:
        for p in r.locking.driven:
            found.setdefault((p.machine, p.position), []).append(var(names.GRANTED(r.number)))
    return {k: disj(xs) for k, xs in found.items()}


def supervision(d: Draft) -> None:
    """A commanded machine that is not detected in time raises an alarm (R10)."""
    for m in d.machines.all:
        d.wire(
            names.SUPERVISED(m),
            Join.ANY,
            tuple(
                Term(conj((d.machines.command(m, x), neg(d.machines.detected(m, x)))), "not detected") for x in Position
            ),
            f"point {m}",
            f"machine {m} is not where it was commanded",
        )
    for m in d.machines.all:
        late = d.timer(names.LATE(m), names.SUPERVISED(m), supervision_s(d.layout, m), f"machine {m}: time-out")
        d.kept(
            names.NOT_DETECTED(m),
            False,
            f"alarm: machine {m} not detected",
            Join.ANY,
            (Term(late, "late"),),
            f"point {m}",
        )
        d.outputs.append(
            Output(names.LATE_SHOWN(m), var(names.NOT_DETECTED(m)), False, f"alarm: machine {m} not detected in time")
        )


def _anew(d: Draft, m: MachineId) -> Expr:
    """A machine is commanded to where it was not commanded before: a key that is held commands once."""
    return disj(
        conj((disj((var(names.DEMANDED(m, x)), var(names.MOVED_BY_HAND(m, x)))), neg(d.machines.command(m, x))))
        for x in Position
    )


def trailing(d: Draft) -> None:
    """Detection lost without a command: run through from the wrong side; locked until looked at (R10).

    TH: detected in a position, not commanded to the other one, nor anew since.  What is seen so is remembered while
    inputs are lost, and from when the restart delay is over: before that nobody has looked at the points yet (R16).
    TR: trailed.
    """
    for m in d.machines.powered:
        group = f"point {m}"
        for x in Position:
            there = conj((d.machines.detected(m, x), neg(d.machines.command(m, x.other))))
            unseen = conj((var(names.WAS_DETECTED(m, x)), neg(var(names.VALID))))
            terms = (
                Term(disj((there, unseen)), "detected"),
                Term(neg(_anew(d, m)), "no new command"),
                Term(var(names.RESTART_OVER), "restart delay over"),
            )
            d.kept(
                names.WAS_DETECTED(m, x),
                False,
                f"machine {m} was detected {d.layout.machines.word(m, x)}",
                Join.ALL,
                terms,
                group,
            )
        was = (conj((var(names.WAS_DETECTED(m, x)), neg(d.machines.detected(m, x)))) for x in Position)
        trailed = conj((disj(was), var(names.VALID), neg(_anew(d, m))))
        seen = conj(
            [var(names.LOOKED_AT(m)), var(names.VALID), *(d.sections.clear(s) for s in d.machines.sections_of(m))]
        )
        d.kept(
            names.TRAILED(m),
            False,
            f"machine {m} was trailed",
            Join.ANY,
            (Term(trailed, "trailed"), Term(conj((var(names.TRAILED(m)), neg(seen))), "until looked at")),
            group,
        )
        d.outputs.append(
            Output(names.TRAILED_SHOWN(m), var(names.TRAILED(m)), False, f"alarm: machine {m} was trailed")
        )


def starting(d: Draft) -> None:
    """Machines start one after the other, so that their currents do not add up (R10).

    Z: the machine may run.  The first that waits starts when the gap since the last start is over.  It starts only
    while its sections are reported clear and not blocked: since it was commanded a vehicle may have come, or somebody
    to work there.  What a block stops waits for its turn anew.
    """
    gap = d.layout.principles.point_start_gap_s
    if not gap:
        return
    machines = d.machines.powered
    for m in machines:
        free = conj(t.expr for t in ways.unblocked(d, m))
        d.wire(
            names.MAY_START(m),
            Join.ALL,
            (
                Term(var(names.VALID), "inputs valid"),
                *(Term(d.sections.clear(s), "point section clear", f"{s} clear") for s in d.machines.sections_of(m)),
                Term(disj((free, _moves_by_hand(m))), "not blocked", "not blocked, or moved by hand"),
                Term(neg(var(names.TRAILED(m))), "not trailed", f"{m} was not trailed"),
                Term(neg(d.machines.kept_off(m)), "not kept off", f"the drive of {m} is not kept off"),
            ),
            "starts",
            f"machine {m} could start now ({rules.POINTS})",
        )
    waits = {m: conj((var(names.SUPERVISED(m)), neg(var(names.MAY_RUN(m))), var(names.MAY_START(m)))) for m in machines}
    d.wire(
        names.GAP_RUNS,
        Join.ALL,
        (Term(neg(var(names.STARTED)), "none started", "no machine started in the last scan"),),
        "starts",
    )
    d.timer(names.GAP_OVER, names.GAP_RUNS, gap, f"the gap since the last start is over ({rules.POINTS})")
    before: list[Expr] = []
    for m in machines:
        first = neg(before[-1]) if before else TRUE
        turn = d.wire(
            names.STARTS(m),
            Join.ALL,
            (Term(waits[m], "waits"), Term(var(names.GAP_OVER), "gap over"), Term(first, "none before it waits")),
            "starts",
            f"machine {m} starts ({rules.POINTS})",
        )
        before.append(d.wire(names.WAITS(m), Join.ANY, (Term(waits[m], "waits"), *_terms(before)), "starts"))
        d.kept(
            names.MAY_RUN(m),
            False,
            f"machine {m} may run",
            Join.ALL,
            (
                Term(disj((var(names.MAY_RUN(m)), turn)), "started"),
                Term(var(names.SUPERVISED(m)), "not there yet"),
                Term(neg(_anew(d, m)), "no new command"),
                Term(neg(d.machines.kept_off(m)), "not kept off"),
            ),
            "starts",
        )
    starts = disj(var(names.STARTS(m)) for m in machines)
    d.kept(names.STARTED, False, "a machine started in the last scan", Join.ANY, (Term(starts, "started"),), "starts")


def _moves_by_hand(m: MachineId) -> Expr:
    return disj(var(names.MOVED_BY_HAND(m, x)) for x in Position)


def keep_off(d: Draft) -> None:
    """No drive runs in a blocked section, but as long as the operator moves the point by hand; afterwards it stays off
    until it is commanded again, by a route or by hand, and the sections are reported clear: nobody's hand on a block
    turns points (R10).  What turns as an overlap swings comes to lie first (R4)."""
    swings: dict[MachineId, list[Expr]] = {}
    for g in d.overlaps.swinging:
        over = (key for o, keys in d.overlaps.ways.items() if o[0] == g for key in keys)
        under = (p.machine for key in over for p in d.table.lock[key].points if p.role is Role.PATH)
        for m in dict.fromkeys(under):
            swings.setdefault(m, []).append(var(names.OVERLAP_SWINGS(g)))
    for m in d.machines.powered:
        free = conj(t.expr for t in ways.unblocked(d, m))
        clear = conj((var(names.VALID), *(d.sections.clear(s) for s in d.machines.sections_of(m))))
        blocked = conj((neg(free), *(neg(x) for x in swings.get(m, ()))))
        again = disj(var(names.DEMANDED(m, x)) for x in Position)
        off = disj((blocked, conj((var(names.KEPT_OFF(m)), neg(conj((free, clear, again)))))))
        d.kept(
            names.KEPT_OFF(m),
            False,
            f"machine {m}: its drive is kept off",
            Join.ALL,
            (
                Term(off, "blocked", "a section of it is blocked, or was, and it was not commanded again since"),
                Term(neg(_moves_by_hand(m)), "not moved by hand"),
            ),
            f"point {m}",
        )


def _terms(before: list[Expr]) -> list[Term]:
    return [Term(before[-1], "one before it waits")] if before else []
