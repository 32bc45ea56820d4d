"""Where trains change direction: at a standstill, within one section, towards a signal (A-REVERSE)."""

from __future__ import annotations

from typing import Protocol

from interlock.logic import names
from interlock.logic.expr import FALSE, Expr, conj, disj, neg
from interlock.logic.plant.kinds import Plant
from interlock.logic.plant.standing import Standing, functions
from interlock.logic.plant.words import accepted, across, came, image, o, rests
from interlock.model.elements import SectionId
from interlock.model.layout import Layout
from interlock.model.traversal import Topology


class Making(Protocol):
    """What this part needs of the plant in the making."""

    layout: Layout
    topo: Topology
    p: Plant
    dropped: frozenset[str]
    standing: Standing

    def choice(self, name: names.Name, text: str) -> Expr:
        """A free choice of the world."""
        ...


def reversals(b: Making, s: SectionId) -> None:
    """A train reverses at a standstill where a signal governs its new direction; in a berth any signal calls."""
    if b.standing.berth(s):
        return
    for x in b.topo.ends[s]:
        ahead = b.topo.beyond(s, x)
        g = b.topo.signal_into.get((x, ahead)) if ahead is not None else None
        if g is None and ("A-REVERSE" not in b.dropped or x in b.layout.track.buffer_at):
            continue
        for y in b.topo.ends[s]:
            back = disj(b.standing.lie(t) for t in b.standing.ways(s, y, x))
            there = disj(b.standing.lie(t) for t in b.standing.ways(s, x, y))
            if x == y or back is FALSE or there is FALSE:
                continue
            alone = conj(
                neg(z)
                for k in b.topo.ends[s]
                if k not in b.layout.track.buffer_at
                for z in (across(k, s), b.standing.coming(s, k))
            )
            waiting = conj(
                [
                    *(neg(accepted(h, k)) for h in b.topo.signals_out(s) for k in functions(b.layout, h)),
                    *(
                        neg(b.p.events[names.accepts(h, k)])
                        for h in b.topo.signals_out(s)
                        for k in functions(b.layout, h)
                    ),
                    *(neg(b.p.events[names.HEAD(k, s)]) for k in b.topo.ends[s] if k not in b.layout.track.buffer_at),
                ]
            )
            b.p.events[names.TURNS(s, x, y)] = conj(
                (
                    o(s),
                    came(s, x),
                    there,
                    neg(rests(s)),
                    neg(b.standing.parted(s)),
                    alone,
                    image(s),
                    waiting,
                    b.choice(names.TURNS(s, x, y), f"the train in {s} changes direction"),
                )
            )
