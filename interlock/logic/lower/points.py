"""Points (R10): detection, when a machine may move, commands, supervision.

A machine moves only when the sections of all its ends are unlocked and reported clear and nobody needs it as
flank protection.  The command is held; in the initial state there is none, so that nothing moves at start-up.
"""

from __future__ import annotations

from interlock.logic.controller import Input, Join, Output, Term
from interlock.logic.expr import FALSE, Expr, conj, disj, neg, var
from interlock.logic.lower.draft import Draft
from interlock.model.elements import MachineId, Position, SectionId
from interlock.model.portable import portable
from interlock.table.rows import Role, RouteRow


def inputs(d: Draft) -> None:
    """Detection contacts and manual commands."""
    for m in d.machines:
        n = portable(m)
        for x in Position:
            d.inputs.append(Input(f"D{x}_{n}", f"machine {m} detected {d.layout.word(m, x)}"))
        for x in Position:
            d.inputs.append(Input(f"M{x}_{n}", f"operator: move machine {m} {d.layout.word(m, x)}"))


def detection(d: Draft) -> None:
    """Contacts 10 and 01 are positions; 00 and 11 are none (R10)."""
    for m in d.machines:
        n = portable(m)
        for x in Position:
            d.wire(
                f"Q{x}_{n}",
                Join.ALL,
                (
                    Term(var("VALID"), "inputs valid"),
                    Term(var(f"D{x}_{n}"), "contact"),
                    Term(neg(var(f"D{x.other}_{n}")), "no opposite contact"),
                ),
                f"point {m}",
                f"machine {m} lies {x} (R10)",
            )


def flank_demand(d: Draft, m: MachineId, x: Position) -> Expr:
    """Some lock needs the machine as flank protection in that position."""
    return disj(
        d.holding(t.key)
        for t in d.table.locks
        for p in t.points
        if p.machine == m and p.position is x and p.role is Role.FLANK
    )


def movable(d: Draft) -> None:
    """Free to move: nothing locked, nothing occupied, no flank held (R10; never a shared flag)."""
    for m in d.machines:
        n = portable(m)
        terms: list[Term] = [Term(var("VALID"), "inputs valid")]
        for s in d.sections_of(m):
            terms.append(Term(var(f"FREE_{portable(s)}"), "point section free", f"{s} not locked"))
            terms.append(Term(neg(d.occupied(s)), "point section clear", f"{s} clear"))
        for x in Position:
            held = flank_demand(d, m, x)
            terms.append(Term(neg(held), "flank not held", f"nobody needs {m} {x} as flank protection"))
        d.wire(f"MOV_{n}", Join.ALL, terms, f"point {m}", f"machine {m} is free to move (R10)")
        for x in Position:
            d.wire(
                f"AV{x}_{n}",
                Join.ANY,
                (
                    Term(d.command(m, x), "commanded"),
                    Term(var(f"MOV_{n}"), "free to move"),
                    Term(
                        conj((d.detected(m, x), *(neg(d.command(m, y)) for y in Position))),
                        "lies there since the restart",
                    ),
                ),
                f"point {m}",
                f"machine {m} can be demanded {x}",
            )


def _taken(r: RouteRow) -> set[SectionId]:
    """The sections of a route's path and overlap."""
    return {*r.section_ids, *(s for s, _ in (r.overlap.ways if r.overlap else ()))}


def commands(d: Draft) -> None:
    """Commands follow grants; by hand only when free and not touched by a grant in this scan."""
    for m in d.machines:
        n = portable(m)
        secs = set(d.sections_of(m))
        touching = [r for r in d.table.routes if secs & _taken(r) or any(p.machine == m for p in r.points)]
        touched = disj(var(f"G_R{r.number}") for r in touching)
        for x in Position:
            granted = disj(
                var(f"G_R{r.number}") for r in touching if any(p.machine == m and p.position is x for p in r.points)
            )
            driven = disj(
                var(f"G_R{r.number}") for r in touching if any(p.machine == m and p.position is x for p in r.driven)
            )
            terms = [Term(granted, "granted")]
            if driven is not FALSE:
                terms.append(Term(conj((driven, var(f"MOV_{n}"))), "driven along", "beside the path, if free to move"))
            if m in d.layout.device and x is Position.NORMAL:
                back = conj((var(f"MOV_{n}"), neg(touched), neg(var(f"M{x.other}_{n}"))))
                terms.append(Term(back, "returns", "opens by itself when nothing is locked over it (R13)"))
            d.wire(f"GP{x}_{n}", Join.ANY, terms, f"point {m}", f"a grant needs {m} {x}")
            d.wire(
                f"MA{x}_{n}",
                Join.ALL,
                (
                    Term(var(f"M{x}_{n}"), "by hand"),
                    Term(neg(var(f"M{x.other}_{n}")), "not both by hand"),
                    Term(var(f"MOV_{n}"), "point free by hand"),
                    Term(neg(touched), "no grant in this scan"),
                ),
                f"point {m}",
                f"machine {m} moved {x} by hand",
            )
        for x in Position:
            d.wire(
                f"HD{x}_{n}",
                Join.ALL,
                (
                    Term(d.command(m, x), "held"),
                    Term(neg(var(f"GP{x.other}_{n}")), "no opposite grant"),
                    Term(neg(var(f"MA{x.other}_{n}")), "not moved by hand"),
                ),
                f"point {m}",
                f"the command {x} stays",
            )
            d.kept(
                f"C{x}_{n}",
                False,
                f"machine {m} commanded {x}",
                Join.ANY,
                (
                    Term(var(f"GP{x}_{n}"), "granted"),
                    Term(var(f"MA{x}_{n}"), "by hand"),
                    Term(var(f"HD{x}_{n}"), "held"),
                ),
                f"point {m}",
            )
            d.outputs.append(Output(f"Y{x}_{n}", d.command(m, x), False, f"machine {m}: {d.layout.word(m, x)}"))


def supervision(d: Draft) -> None:
    """A commanded machine that is not detected in time raises an alarm (R10)."""
    for m in d.machines:
        n = portable(m)
        d.wire(
            f"STI_{n}",
            Join.ANY,
            tuple(Term(conj((d.command(m, x), neg(d.detected(m, x)))), "not detected") for x in Position),
            f"point {m}",
            f"machine {m} is not where it was commanded",
        )
    for m in d.machines:
        n = portable(m)
        late = d.timer(f"ST_{n}", f"STI_{n}", d.layout.principles.point_supervision_s, f"machine {m}: time-out")
        d.kept(f"AL_{n}", False, f"alarm: machine {m} not detected", Join.ANY, (Term(late, "late"),), f"point {m}")
        d.outputs.append(Output(f"YA_{n}", var(f"AL_{n}"), False, f"alarm: machine {m} not detected in time"))
