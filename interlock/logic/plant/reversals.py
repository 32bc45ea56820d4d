"""Where trains change direction: at a standstill, within one section, towards a signal (A-REVERSE)."""

from __future__ import annotations

from typing import Protocol

from interlock.logic import names
from interlock.logic.expr import FALSE, Expr, conj, disj, neg
from interlock.logic.plant.kinds import Plant
from interlock.logic.plant.words import accepted, across, came, image, o, rests
from interlock.model.elements import NodeId, SectionId, SignalId
from interlock.model.layout import Layout
from interlock.model.traversal import Topology, Traversal


class Making(Protocol):
    """What this part needs of the plant in the making."""

    layout: Layout
    topo: Topology
    p: Plant
    dropped: frozenset[str]

    def berth(self, s: str) -> bool:
        """Vehicles may stand there in any number."""
        ...

    def lie(self, t: Traversal) -> Expr:
        """Every point on the way really lies for it."""
        ...

    def ways(self, s: SectionId, a: NodeId, b: NodeId | None = None) -> list[Traversal]:
        """Traversals from an end, to an end if given."""
        ...

    def coming(self, s: SectionId, j: NodeId) -> Expr:
        """A train stands across j on its way into s."""
        ...

    def parted(self, s: SectionId) -> Expr:
        """What stands in s is the rear part of a train that was left there."""
        ...

    def functions(self, g: SignalId) -> list[bool]:
        """Whom a signal speaks to."""
        ...

    def choice(self, name: names.Name, text: str) -> Expr:
        """A free choice of the world."""
        ...


def reversals(b: Making, s: SectionId) -> None:
    """A train reverses at a standstill where a signal governs its new direction; in a berth any signal calls."""
    if b.berth(s):
        return
    for x in b.topo.ends[s]:
        ahead = b.topo.beyond(s, x)
        g = b.topo.signal_into.get((x, ahead)) if ahead is not None else None
        if g is None and ("A-REVERSE" not in b.dropped or x in b.layout.buffer_at):
            continue
        for y in b.topo.ends[s]:
            back = disj(b.lie(t) for t in b.ways(s, y, x))
            there = disj(b.lie(t) for t in b.ways(s, x, y))
            if x == y or back is FALSE or there is FALSE:
                continue
            alone = conj(
                neg(z) for k in b.topo.ends[s] if k not in b.layout.buffer_at for z in (across(k, s), b.coming(s, k))
            )
            waiting = conj(
                [
                    *(neg(accepted(h, k)) for h in b.topo.signals_out(s) for k in b.functions(h)),
                    *(neg(b.p.events[names.accepts(h, k)]) for h in b.topo.signals_out(s) for k in b.functions(h)),
                    *(neg(b.p.events[names.HEAD(k, s)]) for k in b.topo.ends[s] if k not in b.layout.buffer_at),
                ]
            )
            b.p.events[names.TURNS(s, x, y)] = conj(
                (
                    o(s),
                    came(s, x),
                    there,
                    neg(rests(s)),
                    neg(b.parted(s)),
                    alone,
                    image(s),
                    waiting,
                    b.choice(names.TURNS(s, x, y), f"the train in {s} changes direction"),
                )
            )
