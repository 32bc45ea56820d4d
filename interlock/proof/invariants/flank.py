"""What must hold about flanks: no vehicle can roll in, and where it is asked for the flank space is clear (R5)."""

from __future__ import annotations

from collections.abc import Iterator

from interlock.logic.expr import FALSE, TRUE, Expr, conj, disj, implies, neg, var
from interlock.logic.plant import accepted, came, lamp, lies, o, rests
from interlock.model.elements import BoundaryKind, EdgeId, NodeId, SectionId, SignalId
from interlock.model.measured import Beyond
from interlock.proof.invariants.kinds import Facts
from interlock.proof.invariants.paths import ground_of, shown_over, signal_paths


def exposed(f: Facts, beyond: Beyond) -> Expr:
    """Whether a vehicle could roll over a track towards the place, from beyond the next signal, as everything really
    lies."""
    if beyond.one_way or beyond.closed:
        return FALSE
    if beyond.signal is not None:
        g = f.layout.signal[beyond.signal]
        called = [x for k in f.functions(g.id) for x in (f.sym.signal(g.id, k), lamp(g.id, k), accepted(g.id, k))]
        if not g.main:  # a train passes it on a lock that leads this way
            s = beyond.section
            called.append(conj((f.train(s), f.firm(s), f.locked_in(s, g.node))))
        return disj(called)
    if beyond.boundary is not None:
        return FALSE if beyond.boundary is BoundaryKind.OUT else TRUE
    rolls = disj(exposed(f, x) for x in beyond.onward)
    if beyond.trailed is None:
        return rolls
    machine, position = beyond.trailed
    return conj((neg(lies(machine, position.other)), rolls))


def flank(f: Facts) -> Iterator[tuple[str, str, Expr]]:
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
            places: list[tuple[str, NodeId, EdgeId]] = []
            for pid, x in t.points:
                p = f.layout.point[pid]
                places.append((f"{pid}.{x.other}", p.node, p.leg(x.other)))
            for cid, arm in t.crossings:
                c = f.layout.crossing[cid]
                places += [(f"{cid}.{edge}", c.node, edge) for edge in c.arms[1 - arm]]
            uses = conj((f.firm(s), f.lock(s, t.number)))
            train = conj((o(s), neg(rests(s)), came(s, t.entry)))
            shown = disj(f.sym.signal(g, k) for g, k in over.get(t.key, ()))
            for name, node, edge in places:
                danger = exposed(f, f.beyond[node, edge])
                yield "T-FLANK", f"{s}:{t.number}:{name}", implies(conj((uses, train)), neg(danger))
                yield "S-FLANK", f"{s}:{t.number}:{name}", implies(conj((uses, shown)), neg(danger))


def flank_space(f: Facts) -> Iterator[tuple[str, str, Expr]]:
    rules = f.layout.principles
    if not rules.flank_space and not rules.flank_lamp:
        return
    ground = ground_of(f)
    waived = {(w.point, w.leg) for w in f.layout.waivers}
    for s in f.topo.sections:
        for t in f.topo.traversals[s]:
            shown = disj(shown_over(ground, [t]).values())
            for pid, x in t.points:
                p = f.layout.point[pid]
                if (pid, x.other) not in waived:
                    quiet = _quiet(f, s, f.beyond[p.node, p.leg(x.other)])
                    yield "S-FLANK-SPACE", f"{s}:{t.number}:{pid}", implies(f.system.after(shown), quiet)
            for cid, arm in t.crossings:
                c = f.layout.crossing[cid]
                for edge in c.arms[1 - arm]:
                    quiet = _quiet(f, s, f.beyond[c.node, edge])
                    yield "S-FLANK-SPACE", f"{s}:{t.number}:{cid}.{edge}", implies(f.system.after(shown), quiet)


def _quiet(f: Facts, own: SectionId, beyond: Beyond) -> Expr:
    """Nothing stands along a track up to what stops a vehicle, as everything really lies, and stop signals are lit."""
    layout, s = f.layout, beyond.section
    if beyond.one_way:
        return TRUE
    looked_at = layout.principles.flank_space and s != own and s not in layout.undetected
    clear = f.clear(s) if looked_at else TRUE
    if beyond.closed or beyond.boundary is not None:
        return clear
    if beyond.signal is not None:
        lit = layout.principles.flank_lamp and beyond.signal in f.sym.stop_lamp
        return conj((clear, var(f.sym.stop_lamp[beyond.signal]))) if lit else clear
    onward = [_quiet(f, own, x) for x in beyond.onward]
    if beyond.trailed is None:
        return conj([clear, *onward])
    machine, position = beyond.trailed
    return conj((clear, disj((f.system.after(lies(machine, position.other)), *onward))))
