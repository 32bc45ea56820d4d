"""At what speed trains were called, where a short overlap lies inside a longer one of the same signal (R4, A-SLOW).

A driver is told a speed by the indicator of the main signal that he passes.  He counts as called at no more than a
speed if, from when he first may have accepted the signal until he passes it, it showed an indicator of no more whenever
it showed proceed, and none of more.  Every other train counts as faster: one that stood there at the restart, that a
signal without indicator has called, or called on, or that has turned; and a shunting movement.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Protocol

from interlock.logic import names
from interlock.logic.expr import FALSE, Expr, conj, disj, neg
from interlock.logic.plant.kinds import Plant, Wiring
from interlock.logic.plant.standing import Entries
from interlock.logic.plant.words import accepted, fast, slow
from interlock.model.elements import NodeId, SectionId, SignalId
from interlock.model.layout import Layout
from interlock.model.measured import Measured
from interlock.model.traversal import Topology, Traversal


class Making(Protocol):
    """What this part needs of the plant in the making."""

    layout: Layout
    topo: Topology
    w: Wiring
    p: Plant
    entries: Entries
    dropped: frozenset[str]

    def shown(self, g: SignalId, shunt: bool) -> Expr:
        """What the controller shows at a signal, to trains or to shunting movements."""
        ...


class ShortEnds:
    """Where short overlaps end that lie inside longer ones, and for which speeds (km/h) they are made."""

    def __init__(self, read: Measured, overlaps: Mapping[SignalId, tuple[tuple[Traversal, ...], ...]]) -> None:
        """`overlaps`: the alternatives of each signal's overlap, in order of their numbers."""
        self._at: dict[tuple[SignalId, SectionId, NodeId], list[int]] = {}
        for g, apart in read.apart.items():
            for k, kmh in apart.items():
                last = overlaps[g][k - 1][-1]
                self._at.setdefault((g, last.section, last.exit), []).append(kmh)
        self.speeds = tuple(sorted({kmh for apart in read.apart.values() for kmh in apart.values()}))

    def stops(self, g: SignalId, s: SectionId, j: NodeId) -> Expr:
        """What has overrun g stops in s before j at the latest, since it was called slowly enough for a short overlap
        that ends there."""
        return disj(slow(s, kmh) for kmh in self._at.get((g, s, j), ()))


def shows_more(b: Making, g: SignalId, kmh: int) -> Expr:
    """A signal shows proceed, and not that no more than a speed is permitted."""
    lamps = [(v, x) for (h, v), x in b.w.speed.items() if h == g]
    within, above = (disj(x for v, x in lamps if (v <= kmh) is fits) for fits in (True, False))
    return conj((b.shown(g, False), neg(conj((within, neg(above))))))


def speeds_called(b: Making, ends: ShortEnds) -> None:
    """State and next states: what the train before each signal has seen, how that in each section was called."""
    for kmh in ends.speeds:
        for g in b.layout.signalling.signals:
            go, name = names.accepted(g.id), names.FAST(g.id, kmh)
            if g.main and go in b.p.next:
                b.p.state[name] = f"the train before {g.id} may have seen that more than {kmh} km/h is permitted"
                b.p.next[name] = disj((shows_more(b, g.id, kmh), conj((fast(g.id, kmh), b.p.next[go]))))
                b.p.initial.append(neg(fast(g.id, kmh)))
        for s in b.topo.sections:
            name = names.SLOW(s, kmh)
            b.p.state[name] = f"the train in {s} was called at no more than {kmh} km/h"
            comes = disj(b.entries.comes_in(s, j) for j in b.topo.ends[s])
            gone = b.p.gone[s]
            stays = conj((slow(s, kmh), neg(gone), neg(b.entries.turns(s)), neg(comes)))
            into = FALSE if "A-SLOW" in b.dropped else disj(_into(b, s, kmh))
            b.p.next[name] = disj((stays, into))
            b.p.initial.append(neg(slow(s, kmh)))


def _into(b: Making, s: SectionId, kmh: int) -> Iterator[Expr]:
    """A train that was called at no more than a speed comes into a section, over each end."""
    for j in b.topo.ends[s]:
        comes, rear = b.entries.comes_in(s, j), b.topo.beyond(s, j)
        if comes is FALSE:
            continue
        g = b.topo.main_into.get((j, s))
        on = FALSE if rear is None else slow(rear, kmh)
        if g is not None:  # it has accepted the signal, or overruns one
            seen = conj((accepted(g), neg(fast(g, kmh)), neg(shows_more(b, g, kmh)))) if _called_by(b, g) else FALSE
            on = disj((conj((b.entries.overrun_over(s, j), on)), seen))
        yield conj((comes, neg(b.entries.shunts_in(s, j)), on))


def _called_by(b: Making, g: SignalId) -> bool:
    """Trains come to the signal, so that one may have accepted it."""
    return names.accepted(g) in b.p.next


__all__ = ["ShortEnds", "speeds_called"]
