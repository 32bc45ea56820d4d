"""What the author has added to routes (R5, R6): hostile routes, and points that routes lock.

AH: a route holds what was added to it.  From its grant until its train is wholly in its last section, or, where the
route leads out over a boundary or has no other section, until its last section is released.  The lock that is looked at
is the last to go, since sections are released from rear to front; the overlap goes when the train stands.

AHI, AHT, AHE: where the author asks for it (`hold`), the route holds it so many seconds longer, counted without a break
from when it would let go; a grant of the same route meanwhile begins anew, and nothing else does.  Others may lock the
same section, or an overlap of the same signal, again meanwhile, so that it is remembered that the seconds have begun.
"""

from __future__ import annotations

from collections.abc import Iterator

from interlock.logic import names, rules
from interlock.logic.controller import Join, Term
from interlock.logic.expr import Expr, conj, disj, neg, var
from interlock.logic.lower.draft import Draft
from interlock.logic.names import Name
from interlock.model.elements import MachineId, Position
from interlock.model.machines import other_doors
from interlock.table.rows import RouteRow, last_left


def holds(r: RouteRow) -> Name | None:
    """The bit that tells that a route holds what was added to it; None where nothing was."""
    return names.HOLDS_ADDED(r.number) if r.locking.barred or r.locking.added else None


def free(d: Draft, r: RouteRow) -> list[Term]:
    """Nothing that was added keeps the route from being granted."""
    out = [
        Term(
            neg(var(names.HOLDS_ADDED(d.table.route[c.route].number))),
            "declared hostile",
            c.because.text,
            c.because.rule,
        )
        for c in r.locking.barred
    ]
    for p in r.locking.added:
        free_ = var(names.POINT_AVAILABLE(p.machine, p.position))
        out.append(Term(free_, "added point available", f"{p.machine} {p.position}: {p.because.text}", p.because.rule))
        out += [*not_trailed(d, p.machine), *others_shut(d, p.machine, p.position)]
    return out


def others_shut(d: Draft, m: MachineId, x: Position) -> list[Term]:
    """A door of an air lock is commanded open only while the others are shut, or was so before (R13)."""
    if x is Position.NORMAL or not other_doors(d.layout.machines, m):
        return []
    shut = disj((d.machines.command(m, x), var(names.OTHERS_SHUT(m))))
    note = f"{' and '.join(other_doors(d.layout.machines, m))} shut before {m} opens"
    return [Term(shut, "other doors shut", note, rules.LEVEL_CROSSINGS)]


def not_trailed(d: Draft, m: MachineId) -> list[Term]:
    """A machine that was added was not trailed (R10)."""
    return [Term(neg(var(names.TRAILED(m))), "not trailed", f"{m} was not trailed")] if m in d.machines.powered else []


def detected(d: Draft, r: RouteRow) -> list[Term]:
    """The points that were added lie and are detected, and were not trailed (R10)."""
    out = []
    for p in r.locking.added:
        note = f"{p.machine} {p.position}: {p.because.text}"
        out.append(Term(d.machines.detected(p.machine, p.position), "added point detected", note, p.because.rule))
        out += not_trailed(d, p.machine)
    return out


def clear(d: Draft, r: RouteRow) -> list[Term]:
    """The sections beside or beyond the path that were added are clear (R3)."""
    return [
        Term(d.sections.clear(c.section), "added section clear", c.because.text, c.because.rule)
        for c in r.clear.demanded or ()
    ]


def hold_timer(r: RouteRow) -> Name | None:
    """The timer after which the route lets go what was added to it; None where it does at once."""
    return names.HOLD_OVER(r.number) if r.locking.hold else None


def hold_begun(r: RouteRow) -> Name | None:
    """The bit that tells that this timer runs since some scan before."""
    return names.HOLD_BEGUN(r.number) if r.locking.hold else None


def held(d: Draft, m: MachineId) -> list[Expr]:
    """Some route holds a machine that was added to it."""
    return [var(names.HOLDS_ADDED(r.number)) for r in d.routes.adding.get(m, ())]


def demanded(d: Draft) -> set[tuple[MachineId, Position]]:
    """Machines with the positions in which the author has some route hold them."""
    return {(p.machine, p.position) for r in d.table.routes for p in r.locking.added}


def granted(d: Draft) -> Iterator[tuple[MachineId, Position, Expr]]:
    """The grants that demand a machine that was added."""
    for r in d.table.routes:
        for p in r.locking.added:
            yield p.machine, p.position, var(names.GRANTED(r.number))


def keep(d: Draft) -> None:
    """Next values of the bits."""
    for r in d.table.routes:
        name = holds(r)
        if name is None:
            continue
        overlaps = []
        if r.locking.overlap is not None:
            options = {r.locking.overlap.option, *r.locking.overlap.swings}
            overlaps = [d.overlaps.held(o) for o in d.overlaps.of_signal[r.locking.overlap.signal] if o[1] in options]
        under_way = disj(
            (var(names.GRANTED(r.number)), var(names.ACTIVE(r.number)), d.sections.lock(*last_left(r)), *overlaps)
        )
        way, note = under_way, "set, or its train not yet wholly in the last section"
        if r.locking.hold:
            way = neg(_longer(d, r, under_way))
            note = f"{note}, or so less than {r.locking.hold:g} s ago"
        d.kept(
            name,
            False,
            f"route {r.id} holds what was added to it",
            Join.ALL,
            (Term(disj((var(name), var(names.GRANTED(r.number)))), "held or granted"), Term(way, "under way", note)),
            f"route {r.id}",
        )


def _longer(d: Draft, r: RouteRow, under_way: Expr) -> Expr:
    """The route has held what was added to it for so many seconds since it was under way: then it lets go, whatever
    others have locked meanwhile."""
    input_, begun, over = names.HOLD_RUNS(r.number), names.HOLD_BEGUN(r.number), names.HOLD_OVER(r.number)
    beginning = "not set, and its train wholly in the last section, or so since its last grant"
    terms = (
        Term(var(names.HOLDS_ADDED(r.number)), "held"),
        Term(neg(var(names.GRANTED(r.number))), "not granted", "not set anew"),
        Term(disj((var(begun), neg(under_way))), "not under way", beginning),
    )
    note, group = f"route {r.id} keeps what was added to it ({rules.FLANK_PROTECTION})", f"route {r.id}"
    runs = d.wire(input_, Join.ALL, terms, group, note)
    is_over = d.timer(over, input_, r.locking.hold, note)
    going_on = (Term(runs, "runs"), Term(neg(is_over), "not over"))
    d.kept(begun, False, f"route {r.id} keeps what was added to it since it was under way", Join.ALL, going_on, group)
    return conj((runs, is_over))
