"""What must hold about flanks: no vehicle can roll in, and the partner of a scissors lies normal (R5)."""

from __future__ import annotations

from collections.abc import Iterator

from interlock.logic.expr import FALSE, TRUE, Expr, conj, disj, implies, neg, var
from interlock.logic.plant import accepted, came, lamp, lies, o, overran, rests
from interlock.model.elements import (
    BoundaryKind,
    CrossingId,
    MachineId,
    Position,
    SectionId,
    SignalId,
)
from interlock.model.measured import Beyond
from interlock.model.traversal import Traversal
from interlock.proof.claims.kinds import Facts
from interlock.proof.claims.paths import ground_of, shown_over, signal_paths


def exposed(f: Facts, beyond: Beyond) -> Expr:
    """Whether a vehicle could roll over a track towards the place, from beyond the next signal, from an inclined lane,
    or from the end of a track behind a derailer, as everything really lies."""
    if beyond.lane:
        return neg(_kept(beyond))
    if beyond.one_way or beyond.closed:
        return TRUE if beyond.spur else FALSE
    if beyond.signal is not None:
        g = f.layout.signalling.signal[beyond.signal]
        called = [
            x
            for k in f.track.functions(g.id)
            for x in (f.sym.aspects.signal(g.id, k), lamp(g.id, k), accepted(g.id, k))
        ]
        if not g.main:  # a train passes it on a lock that leads this way
            s = beyond.section
            called.append(conj((f.locking.train(s), f.locking.firm(s), f.locking.locked_in(s, g.node))))
        return disj(called)
    if beyond.boundary is not None:
        return FALSE if beyond.boundary is BoundaryKind.OUT and not beyond.spur else TRUE
    rolls = disj(exposed(f, x) for x in beyond.onward)
    if beyond.trailed is None:
        return rolls
    machine, position = beyond.trailed
    return conj((neg(lies(machine, position.other)), rolls))


def _kept(lane: Beyond) -> Expr:
    """Whether nothing stands on an inclined lane, nor comes over it: it ends in a trap.  Points that turn away do not
    keep it empty: after a restart a vehicle may stand on the leg beyond which they lie."""
    if not lane.lane:
        return TRUE
    if lane.closed or lane.signal is not None or lane.boundary is not None:
        return FALSE
    return conj(_kept(x) if x.section == lane.section else FALSE for x in lane.onward)


def flank(f: Facts) -> Iterator[tuple[str, str, Expr]]:
    """Nothing rolls in at the flank of a way that a train, a proceed or an overlap uses (T-FLANK, S-FLANK)."""
    over: dict[tuple[SectionId, int], dict[tuple[SignalId, bool], None]] = {}
    for g in f.layout.signalling.signals:
        for k in f.track.functions(g.id):
            for path in signal_paths(f, g.id, k):
                for t in path.ways:
                    over.setdefault(t.key, {})[g.id, k] = None
    for s in f.topo.sections:
        for t in f.topo.traversals[s]:
            if (s, t.number) not in f.sym.sections.lock:
                continue
            uses = conj((f.locking.firm(s), f.locking.lock(s, t.number)))
            train = conj((o(s), neg(rests(s)), came(s, t.entry)))
            shown = disj(f.sym.aspects.signal(g, k) for g, k in over.get(t.key, ()))
            for name, danger in _dangers(f, t):
                yield "T-FLANK", f"{s}:{t.number}:{name}", implies(conj((uses, train)), neg(danger))
                yield "S-FLANK", f"{s}:{t.number}:{name}", implies(conj((uses, shown)), neg(danger))
    for option, held in f.sym.overlaps.held.items():
        firm = conj((var(held), var(f.sym.overlaps.firm[option[0]])))
        for s, n in f.sym.overlaps.ways[option]:
            for name, danger in _dangers(f, f.topo.traversals[s][n - 1]):
                place = f"{s}:{n}:{name} as overlap {option[1]} of {option[0]}"
                yield "T-FLANK", place, implies(firm, neg(danger))
    for s in f.topo.sections:
        for h in f.seen.overrun(s):
            for t in f.topo.traversals[s]:
                there = conj((overran(h, s), came(s, t.entry), *_points_lie(f, t)))
                for name, danger in _dangers(f, t):
                    yield "T-FLANK", f"{s}:{t.number}:{name} overrun from {h}", implies(there, neg(danger))


def _points_lie(f: Facts, t: Traversal) -> Iterator[Expr]:
    return (lies(f.layout.pointwork.point[p].machine, x) for p, x in t.points)


def _dangers(f: Facts, t: Traversal) -> Iterator[tuple[str, Expr]]:
    """Every place on a way at which a vehicle might come in, and whether one could roll there now."""
    for pid, x in t.points:
        p = f.layout.pointwork.point[pid]
        yield f"{pid}.{x.other}", exposed(f, f.track.beyond[p.node, p.leg(x.other)])
    for cid, arm in t.crossings:
        c = f.layout.pointwork.crossing[cid]
        for edge in c.arms[1 - arm]:
            yield f"{cid}.{edge}", exposed(f, f.track.beyond[c.node, edge])


def scissors(f: Facts) -> Iterator[tuple[str, str, Expr]]:
    """The partner of a scissors crossover lies normal while the other one is used."""
    ground = ground_of(f)
    for s in f.topo.sections:
        for t in f.topo.traversals[s]:
            if (s, t.number) not in f.sym.sections.lock:
                continue
            uses = conj((f.locking.firm(s), f.locking.lock(s, t.number)))
            train = conj((uses, o(s), neg(rests(s)), came(s, t.entry)))
            shown = f.after(disj(shown_over(ground, [t]).values()))
            for cid, arm in t.crossings:
                for m in _crossover(f, cid, 1 - arm):
                    normal = lies(m, Position.NORMAL)
                    yield "T-SCISSORS", f"{s}:{t.number}:{m}", implies(train, normal)
                    yield "S-SCISSORS", f"{s}:{t.number}:{m}", implies(shown, f.after(normal))


def _crossover(f: Facts, crossing: CrossingId, arm: int) -> tuple[MachineId, ...]:
    """The machines of an arm that is a crossover: plain track leads from both of its ends to the reverse leg of a
    point."""
    c = f.layout.pointwork.crossing[crossing]
    found: dict[MachineId, None] = {}
    for edge in c.arms[arm]:
        node, seen = f.layout.track.far(edge, c.node), {c.node}
        while node not in f.layout.pointwork.point_at:
            onward = [e.id for e in f.layout.track.edges_at[node] if e.id != edge]
            if node in seen or len(onward) != 1:
                return ()
            seen.add(node)
            edge, node = onward[0], f.layout.track.far(onward[0], node)
        if f.layout.pointwork.point_at[node].reverse != edge:
            return ()
        found[f.layout.pointwork.point_at[node].machine] = None
    return tuple(found)
