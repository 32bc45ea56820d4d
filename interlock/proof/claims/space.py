"""What must hold about the flank space (R5): where the principles ask for it nothing stands beside a way that is used,
up to what protects it, and stop signals that protect are lit."""

from __future__ import annotations

from collections.abc import Iterator

from interlock.dataclass import dataclass
from interlock.logic.expr import FALSE, TRUE, Expr, conj, disj, implies, var
from interlock.logic.plant import lies
from interlock.model.elements import BufferKind, SectionId
from interlock.model.measured import Beyond
from interlock.model.traversal import Traversal
from interlock.proof.claims.kinds import Facts
from interlock.proof.claims.paths import ground_of, shown_over, signal_paths


def flank_space(f: Facts) -> Iterator[tuple[str, str, Expr]]:
    """S-FLANK-SPACE, way by way over which proceed is shown.  That of overlaps is part of S-OVERLAP."""
    if not _asked_for(f):
        return
    ground = ground_of(f)
    for s in f.topo.sections:
        for t in f.topo.traversals[s]:
            shown = f.after(disj(shown_over(ground, [t]).values()))
            for place, quiet in quiet_beside(f, t):
                yield "S-FLANK-SPACE", f"{s}:{t.number}:{place}", implies(shown, quiet)


def quiet_beside(f: Facts, t: Traversal) -> Iterator[tuple[str, Expr]]:
    """Each place on a way at which a vehicle might come in, and that nothing stands in the flank space there and stop
    signals that protect are lit; none where the principles do not ask for it.

    Where another movement may be called meanwhile over a section, or from it, a train stands there on a route of its
    own: nothing is said of that section.
    """
    if not _asked_for(f):
        return
    waived = {(w.point, w.leg) for w in f.layout.declared.waivers}
    movements = _movements(f)
    beside = frozenset(x for x, those in movements.items() if any(t.section not in over for over in those))
    space = _Space(f, t.section, beside)
    for pid, x in t.points:
        p = f.layout.pointwork.point[pid]
        if (pid, x.other) not in waived:
            yield str(pid), space.quiet(f.track.beyond[p.node, p.leg(x.other)])
    for cid, arm in t.crossings:
        c = f.layout.pointwork.crossing[cid]
        for edge in c.arms[1 - arm]:
            yield f"{cid}.{edge}", space.quiet(f.track.beyond[c.node, edge])


def _asked_for(f: Facts) -> bool:
    return f.layout.principles.flank_space or f.layout.principles.flank_lamp


def _movements(f: Facts) -> dict[SectionId, list[frozenset[SectionId]]]:
    """For each section the paths, as sections, over it; none at all for a train that stands there before its path, or
    vehicles at its end.  Nobody is called into a trap."""
    found = f.movements
    if found:
        return found
    traps = {b.node for b in f.layout.track.buffers if b.kind is BufferKind.TRAP}
    for g in f.layout.signalling.signals:
        rear = f.topo.beyond(f.layout.track.section_of(g.into), g.node)
        for k in f.track.functions(g.id):
            for path in signal_paths(f, g.id, k):
                if path.ways[-1].exit in traps:
                    continue
                over = frozenset(t.section for t in path.ways)
                for s in over:
                    found.setdefault(s, []).append(over)
                for stands in (rear, path.berth):
                    if stands is not None:
                        found.setdefault(stands, []).append(frozenset())
    return found


@dataclass(frozen=True)
class _Space:
    """The flank space of a place in section `own`; `beside`: sections where others may run meanwhile."""

    f: Facts
    own: SectionId
    beside: frozenset[SectionId]

    def quiet(self, beyond: Beyond) -> Expr:
        """Nothing stands along a track up to what stops a vehicle, as everything really lies, and stop signals are
        lit.  The section of a point that turns vehicles away is no flank space."""
        layout, s = self.f.layout, beyond.section
        if beyond.one_way:
            return TRUE
        looked_at = (
            layout.principles.flank_space and s != self.own and s not in (*layout.track.undetected, *self.beside)
        )
        clear = self.f.seen.steadily_clear(s) if looked_at else TRUE
        if beyond.signal is not None:
            lit = layout.principles.flank_lamp and beyond.signal in self.f.sym.lamp_proof.stop
            return conj((clear, var(self.f.sym.lamp_proof.stop[beyond.signal]))) if lit else clear
        if beyond.closed or beyond.boundary is not None:
            return clear
        onward = conj((clear, *(self.quiet(x) for x in beyond.onward)))
        return disj((self._turned(beyond), onward))

    def _turned(self, beyond: Beyond) -> Expr:
        """Whether points of the very section, wherever a vehicle could come from, turn it away."""
        if beyond.one_way:
            return TRUE
        if beyond.closed or beyond.signal is not None or beyond.boundary is not None:
            return FALSE
        inside = conj(self._turned(x) if x.section == beyond.section else FALSE for x in beyond.onward)
        if beyond.trailed is None:
            return inside
        machine, position = beyond.trailed
        return disj((self.f.after(lies(machine, position.other)), inside))
