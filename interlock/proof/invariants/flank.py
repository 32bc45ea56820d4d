"""What must hold about flanks: no vehicle can roll in, and where it is asked for the flank space is clear (R5)."""

from __future__ import annotations

from collections.abc import Iterator

from interlock.logic.expr import FALSE, TRUE, Expr, conj, disj, implies, neg, var
from interlock.logic.plant import accepted, came, lamp, lies, o, rests
from interlock.model.elements import BoundaryKind, EdgeId, NodeId, SectionId, SignalId
from interlock.proof.invariants.kinds import Facts
from interlock.proof.invariants.paths import ground_of, shown_over, signal_paths


def exposed(f: Facts, edge: EdgeId, node: NodeId, gone: float, clear_of: float, seen: frozenset[NodeId]) -> Expr:
    """Whether a vehicle from beyond the next signal could roll along `edge` to `node`, as everything really lies."""
    layout = f.layout
    e = layout.edge[edge]
    if e.one_way and e.a == node:
        return FALSE
    far = layout.far(edge, node)
    gone += e.length
    if far in seen or far in layout.buffer_at:
        return FALSE
    seen = seen | {far}
    for g in f.signals_at.get(far, ()):
        if g.into == edge and gone >= clear_of:
            called = [x for k in f.functions(g.id) for x in (f.sym.signal(g.id, k), lamp(g.id, k), accepted(g.id, k))]
            if not g.main:  # a train passes it on a lock that leads this way
                called.append(conj((f.train(e.section), f.firm(e.section), f.locked_in(e.section, far))))
            return disj(called)
    boundary = layout.boundary_at.get(far)
    if boundary is not None:
        return FALSE if boundary.kind is BoundaryKind.OUT else neg(FALSE)
    point = layout.point_at.get(far)
    if point is not None:
        position = point.position_of(edge)
        if position is None:
            return disj(exposed(f, leg, far, gone, clear_of, seen) for leg in (point.normal, point.reverse))
        return conj((neg(lies(point.machine, position.other)), exposed(f, point.toe, far, gone, clear_of, seen)))
    crossing = layout.crossing_at.get(far)
    if crossing is not None:
        onward = [b if edge == a else a for a, b in crossing.arms if edge in (a, b)]
    else:
        onward = [x.id for x in layout.edges_at[far] if x.id != edge]
    return disj(exposed(f, x, far, gone, clear_of, seen) for x in onward)


def flank(f: Facts) -> Iterator[tuple[str, str, Expr]]:
    margin = f.layout.principles.clearance_m
    over: dict[tuple[SectionId, int], dict[tuple[SignalId, bool], None]] = {}
    for g in f.layout.signals:
        for k in f.functions(g.id):
            for path in signal_paths(f, g.id, k):
                for t in path.ways:
                    over.setdefault(t.key, {})[g.id, k] = None
    for s in f.topo.sections:
        for t in f.topo.traversals[s]:
            if (s, t.number) not in f.sym.lock:
                continue
            places: list[tuple[str, NodeId, EdgeId, float]] = []
            for pid, x in t.points:
                p = f.layout.point[pid]
                places.append((f"{pid}.{x.other}", p.node, p.leg(x.other), p.fouling + margin))
            for cid, arm in t.crossings:
                c = f.layout.crossing[cid]
                for edge in c.arms[1 - arm]:
                    places.append((f"{cid}.{edge}", c.node, edge, f.layout.principles.fouling_m + margin))
            uses = conj((f.firm(s), f.lock(s, t.number)))
            train = conj((o(s), neg(rests(s)), came(s, t.entry)))
            shown = disj(f.sym.signal(g, k) for g, k in over.get(t.key, ()))
            for name, node, edge, clear_of in places:
                danger = exposed(f, edge, node, 0.0, clear_of, frozenset({node}))
                yield "T-FLANK", f"{s}:{t.number}:{name}", implies(conj((uses, train)), neg(danger))
                yield "S-FLANK", f"{s}:{t.number}:{name}", implies(conj((uses, shown)), neg(danger))


def flank_space(f: Facts) -> Iterator[tuple[str, str, Expr]]:
    rules = f.layout.principles
    if not rules.flank_space and not rules.flank_lamp:
        return
    ground = ground_of(f)
    waived = {(w.point, w.leg) for w in f.layout.waivers}
    margin = rules.clearance_m
    for s in f.topo.sections:
        for t in f.topo.traversals[s]:
            shown = disj(shown_over(ground, [t]).values())
            for pid, x in t.points:
                p = f.layout.point[pid]
                if (pid, x.other) not in waived:
                    quiet = _quiet(f, s, p.leg(x.other), p.node, 0.0, p.fouling + margin, frozenset({p.node}))
                    yield "S-FLANK-SPACE", f"{s}:{t.number}:{pid}", implies(f.system.after(shown), quiet)
            for cid, arm in t.crossings:
                c = f.layout.crossing[cid]
                for edge in c.arms[1 - arm]:
                    quiet = _quiet(f, s, edge, c.node, 0.0, rules.fouling_m + margin, frozenset({c.node}))
                    yield "S-FLANK-SPACE", f"{s}:{t.number}:{cid}.{edge}", implies(f.system.after(shown), quiet)


def _quiet(
    f: Facts, own: SectionId, edge: EdgeId, node: NodeId, gone: float, clear_of: float, seen: frozenset[NodeId]
) -> Expr:
    """Nothing stands along `edge` up to what stops a vehicle, as everything really lies, and stop signals are lit."""
    layout = f.layout
    e = layout.edge[edge]
    if e.one_way and e.a == node:
        return TRUE
    far = layout.far(edge, node)
    gone += e.length
    looked_at = layout.principles.flank_space and e.section != own and e.section not in layout.undetected
    clear = f.clear(e.section) if looked_at else TRUE
    if far in seen or far in layout.buffer_at or far in layout.boundary_at:
        return clear
    seen = seen | {far}
    for g in f.signals_at.get(far, ()):
        if g.into == edge and gone >= clear_of:
            lit = layout.principles.flank_lamp and g.id in f.sym.stop_lamp
            return conj((clear, var(f.sym.stop_lamp[g.id]))) if lit else clear
    point, crossing = layout.point_at.get(far), layout.crossing_at.get(far)
    if point is not None and point.position_of(edge) is not None:
        position = point.position_of(edge)
        assert position is not None
        turned = f.system.after(lies(point.machine, position.other))
        return conj((clear, disj((turned, _quiet(f, own, point.toe, far, gone, clear_of, seen)))))
    if point is not None:
        onward = [point.normal, point.reverse]
    elif crossing is not None:
        onward = [b if edge == a else a for a, b in crossing.arms if edge in (a, b)]
    else:
        onward = [x.id for x in layout.edges_at[far] if x.id != edge]
    return conj([clear, *(_quiet(f, own, x, far, gone, clear_of, seen) for x in onward)])
