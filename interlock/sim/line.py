"""The lines with a direction token (R12) in runs of trains: what neighbours and operators do so that trains can run.

A neighbour sends a train when one is to come in from him, takes the direction for it, and gives it when he is asked;
nobody sends against a train that is on the line.  Where nobody has the direction it is taken as agreed by telephone:
by the neighbour for a train of his, by the operator's hand for a route that is set.  Telegrams arrive in every scan.
"""

from __future__ import annotations

from collections.abc import Sequence

from interlock.logic import names
from interlock.logic.names import Name
from interlock.logic.symbols import BlockSymbols, Symbols
from interlock.model.elements import BlockKind, NodeId
from interlock.model.layout import Layout
from interlock.sim.lanes import Lane
from interlock.sim.trains import Train


class Lines:
    """The lines with a token beyond a layout's boundaries."""

    def __init__(self, layout: Layout, symbols: Symbols) -> None:
        """`symbols`: of the layout's controller."""
        self._layout = layout
        self._tokens: list[tuple[NodeId, str, BlockSymbols]] = [
            (b.node, b.approach or names.outside(b.node), symbols.token[b.node])
            for b in layout.track.boundaries
            if b.block is BlockKind.TOKEN
        ]

    def scan(self, lane: Lane, trains: Sequence[Train]) -> tuple[list[Name], dict[str, int]]:
        """The events of the next scan, and the inputs that are on in it.  `trains`: all that run, or are to come."""
        events: list[Name] = []
        inputs: dict[str, int] = {}
        for b, outside, wire in self._tokens:
            events += [names.TELEGRAM_COMES(b), names.TELEGRAM_REACHES(b)]
            here = lane.is_on(names.ON_LINE(b, "in"))
            out = lane.is_on(names.ON_LINE(b, "out"))
            if here:
                events.append(names.LINE_LAST(b))
            if out and not any(t.leaves_at == b for t in trains):
                events.append(names.LINE_ARRIVED(b))
            waits = any(not t.there and t.due <= 0 and t.under[0].section == outside for t in trains)
            if lane.is_on(wire.tells["asks"]) and not here:
                events.append(names.TOKEN_MOVES(b, "gives"))
                his = (*(names.NEIGHBOUR_TOKEN(b, x) for x in ("has", "gives")), names.TELEGRAM(b, "gives"))
                if not any(map(lane.is_on, his)):
                    inputs[wire.manual] = 1
            elif waits and not out:
                self._comes(lane, b, wire, outside, events, inputs)
        return events, inputs

    def _comes(
        self, lane: Lane, b: NodeId, wire: BlockSymbols, outside: str, events: list[Name], inputs: dict[str, int]
    ) -> None:
        """A train is to come in: the neighbour sends it, or gets the direction for it."""
        if not lane.is_on(names.NEIGHBOUR_TOKEN(b, "has")):
            events.append(names.TOKEN_MOVES(b, "manual"))
            inputs[wire.asks] = 1
        elif not lane.is_on(names.ON_LINE(b, "in")) and not lane.is_on(names.STANDS(outside)):
            events.append(names.SENDS(b))
