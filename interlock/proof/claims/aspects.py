"""What signals show of the way ahead: speeds, clear or caution, distants (R4, R11)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from interlock.logic.expr import FALSE, TRUE, Expr, conj, disj, implies, neg, var
from interlock.model.elements import Condition, Device, Position, SignalId
from interlock.model.foul import Foul
from interlock.model.overlap import entry_speed
from interlock.model.principles import Caution
from interlock.model.traversal import Traversal, path_speed
from interlock.proof.claims.kinds import Facts
from interlock.proof.claims.paths import SignalPath, exit_of, lie, runs_past
from interlock.proof.claims.space import quiet_beside


def at_speed(f: Facts, signal: SignalId, path: SignalPath, here: Expr) -> Iterator[tuple[str, Expr]]:
    """Of the speeds that a signal can show it shows none above what a path permits, and one of the others when it
    opens."""
    permitted = path_speed(f.layout, path.ways)
    if permitted is None:
        return
    after, shown = f.after, [(v, var(n)) for (g, v), n in f.sym.aspects.speed.items() if g == signal]
    slow, faster = (disj(x for v, x in shown if (v <= permitted) is fits) for fits in (True, False))
    if faster is not FALSE:
        yield "", implies(here, neg(after(faster)))
    yield " shown", implies(conj((here, after(disj(map(var, f.sym.aspects.main_lamps(signal)))))), after(slow))


def past_identifier(f: Facts, signal: SignalId, first: SignalPath, here: Expr) -> Iterator[tuple[str, str, Expr]]:
    """What a signal shows to a train that passes the next ones at identifier light counts for the ways beyond, too."""
    for run in runs_past(f, first):
        lit, last = f.after(run.lit(f)), run.parts[-1]
        for what, x in at_speed(f, signal, last, conj((here, lit))):
            yield "S-SPEED", f"{run.called}{what}", x
        exit_ = exit_of(f, last)
        if exit_ is not None:
            for id_, what, x in entry(f, signal, last, exit_, f.track.overlap_paths(exit_)):
                yield id_, f"{run.called}{what}", implies(lit, x)


def entry(
    f: Facts, signal: SignalId, path: SignalPath, exit_: SignalId, over: Sequence[tuple[Traversal, ...]]
) -> Iterator[tuple[str, str, Expr]]:
    """A train is shown no more than the speed for which its overlap is made: (claim, what of the path, claim).

    Where a short overlap that is told apart lies inside a longer one, the longer one is ready for a faster train.
    """
    after = f.after
    shown = {v: var(n) for (g, v), n in f.sym.aspects.speed.items() if g == signal}
    for k, ways in enumerate(over, 1):
        kmh = entry_speed(f.layout, exit_, ways)
        if kmh is None:
            continue
        main = after(disj(map(var, f.sym.aspects.main_lamps(signal))))
        lying = after(lie(f, (*path.ways, *ways)))
        slow, faster = (disj(x for v, x in shown.items() if (v <= kmh) is fits) for fits in (True, False))
        longer = disj(overlap_ready(f, x) for x in f.track.longer_overlaps(exit_, k))
        told = conj((after(slow), neg(after(faster))))
        yield "S-ENTRY", f" overlap {k}", implies(conj((main, lying)), disj((told, longer)))
        if f.layout.principles.caution is not Caution.NEVER and kmh < f.layout.principles.slow_below_kmh:
            yield "S-ASPECT", f" overlap {k}", implies(lying, disj((neg(clear_aspect(f, signal)), longer)))


def overlap_ready(f: Facts, ways: tuple[Traversal, ...]) -> Expr:
    """An overlap is clear and not blocked, its points lie and are detected, its devices are closed, the conditions over
    it hold, nothing can stand foul of it, and its flank space is clear where the principles ask for that."""
    blocked = f.sym.sections.blocked
    points = [(f.layout.pointwork.point[p].machine, x) for t in ways for p, x in t.points]
    return conj(
        [
            *(f.seen.steadily_clear(t.section) for t in ways),
            f.after(lie(f, ways)),
            *(var(f.sym.machines.detected[m, x]) for m, x in points),
            *(neg(var(f.sym.machines.detected[m, x.other])) for m, x in points),
            *devices_closed(f, ways),
            *(neg(var(blocked[t.section])) for t in ways if t.section in blocked),
            *(var(f.sym.condition[c.id]) for c in f.layout.signalling.conditions if _over(c, ways)),
            *nothing_foul(f, ways),
            *(quiet for t in ways for _, quiet in quiet_beside(f, t)),
        ]
    )


def nothing_foul(f: Facts, ways: Sequence[Traversal]) -> list[Expr]:
    """Of each section in which a vehicle may stand foul of ways (R6, R7): it is clear, or its point is detected so that
    nothing in it stands at the joint or on the diamond."""
    beside: list[Foul] = [*f.track.fouls, *f.track.crossed, *f.track.beside]
    needed = []
    for x in (x for x in beside if any(map(x.fouls, ways))):
        away = FALSE
        if x.when is not None:
            m, position = x.when
            detected = f.sym.machines.detected
            away = conj((var(detected[m, position.other]), neg(var(detected[m, position]))))
        needed.append(disj((f.seen.steadily_clear(x.neighbour), away)))
    return needed


def devices_closed(f: Facts, ways: Sequence[Traversal]) -> list[Expr]:
    """Each crossing, bridge or door over ways is detected closed, and not open."""
    return [
        conj(
            (
                var(f.sym.machines.detected[d.id, Position.REVERSE]),
                neg(var(f.sym.machines.detected[d.id, Position.NORMAL])),
            )
        )
        for d in f.layout.signalling.devices
        if _over(d, ways)
    ]


def _over(x: Condition | Device, ways: Sequence[Traversal]) -> bool:
    return any(t.section in x.over for t in ways)


def shows_open(f: Facts, g: SignalId, shunt: bool = False) -> Expr:
    """The lamps show proceed to a movement before the signal: not by calling a train on, nor for one that already
    passes it (which is the controller's own word; S-PASSING says when it may be given)."""
    lamps = f.sym.aspects.proceed_lamps(g, True) if shunt else f.sym.aspects.main_lamps(g)
    return conj((disj(map(var, lamps)), neg(f.sym.routes.passing(g, shunt))))


def clear_aspect(f: Facts, g: SignalId) -> Expr:
    """The signal will show clear, not caution."""
    return f.after(var(f.sym.aspects.clear[g])) if g in f.sym.aspects.clear else FALSE


def allows_clear(f: Facts, path: SignalPath) -> Expr:
    """Whether a path may be shown as clear: the line beyond is checked, or the next main signal will be open (R11);
    where signals show their identifier lights, the one after them is the next, and all before it must allow it."""
    runs = (run for run in runs_past(f, path) if all(_awaits(f, p) for p in run.parts[:-1]))
    past = (conj((f.after(run.lit(f)), _ends_clear(f, run.parts[-1]))) for run in runs)
    return disj((_ends_clear(f, path), *past))


def _ends_clear(f: Facts, path: SignalPath) -> Expr:
    """The line beyond a path is checked, or the next main signal will be open."""
    boundary = f.layout.track.boundary_at.get(path.ways[-1].exit)
    if boundary is not None and boundary.checked:
        return FALSE if _slow(f, path) else TRUE
    exit_ = exit_of(f, path)
    return f.after(shows_open(f, exit_)) if exit_ is not None and _awaits(f, path) else FALSE


def _awaits(f: Facts, path: SignalPath) -> bool:
    """Clear may be shown over a path to a main signal, if that is open."""
    turned = any(x is Position.REVERSE for t in path.ways for _, x in t.points)
    last = exit_of(f, path) is not None and path.ways[-1].exit not in f.layout.track.boundary_at
    return last and not _slow(f, path) and not (turned and f.layout.principles.caution is Caution.TURNOUT)


def _slow(f: Facts, path: SignalPath) -> bool:
    kmh = path_speed(f.layout, path.ways)
    return kmh is not None and kmh < f.layout.principles.slow_below_kmh


def two_yellows(f: Facts, signal: SignalId, first: SignalPath) -> Iterator[tuple[str, str, Expr]]:
    """A main signal that opens over a reversed point into a track inside the layout lights its second yellow lamp, and
    so it does where such a path lies beyond the signals past which a train runs (R11)."""
    if f.layout.principles.caution is not Caution.TURNOUT:
        return
    second = f.sym.aspects.second.get(signal)
    lit = FALSE if second is None else f.after(var(second))
    opens = f.after(conj((disj(map(var, f.sym.aspects.main_lamps(signal))), lie(f, first.ways))))
    if turned_inside(f, first):
        yield "S-ASPECT", " two yellows", implies(opens, lit)
        return
    for run in runs_past(f, first):
        if any(turned_inside(f, p) for p in run.parts):
            yield "S-ASPECT", f"{run.called} two yellows", implies(conj((opens, f.after(run.lit(f)))), lit)


def branching(f: Facts, signal: SignalId, first: SignalPath) -> Iterator[tuple[str, str, Expr]]:
    """A main signal that opens lights its route indicator for departures in a direction that has one, and for none in
    another direction, past the signals at identifier light, too (R11)."""
    lamp = f.sym.aspects.indicator.get(signal)
    lit = FALSE if lamp is None else f.after(var(lamp))
    opens = f.after(conj((disj(map(var, f.sym.aspects.main_lamps(signal))), lie(f, first.ways))))
    ends = [("", first, TRUE), *((r.called, r.parts[-1], f.after(r.lit(f))) for r in runs_past(f, first))]
    for called, last, past in ends:
        boundary = f.layout.track.boundary_at.get(last.ways[-1].exit)
        if boundary is not None and (boundary.indicator or lit is not FALSE):
            right = lit if boundary.indicator else neg(lit)
            yield "S-ASPECT", f"{called} route indicator", implies(conj((opens, past)), right)


def turned_inside(f: Facts, path: SignalPath) -> bool:
    """Whether a path leads over a reversed point, and not out onto a checked line."""
    turned = any(x is Position.REVERSE for t in path.ways for _, x in t.points)
    boundary = f.layout.track.boundary_at.get(path.ways[-1].exit)
    return turned and not (boundary is not None and boundary.checked)


def distants(f: Facts) -> Iterator[tuple[str, str, Expr]]:
    """A distant shows clear only while its main signal does."""
    for d in f.layout.signalling.distants:
        shown = f.after(var(f.sym.aspects.distant_clear[d.id]))
        yield "S-ASPECT", d.id, implies(shown, clear_aspect(f, d.of))
