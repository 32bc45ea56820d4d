"""Where an element lies, in short words: a channel of the same name that means another place is another test."""

from __future__ import annotations

from collections.abc import Callable

from interlock.logic.symbols import Symbols
from interlock.model.elements import EdgeId, MachineId, NodeId, Point, PointId, Position, SectionId, SignalId
from interlock.model.figures import metres
from interlock.model.layout import Layout
from interlock.model.traversal import topology


def places(layout: Layout, symbols: Symbols) -> dict[str, str]:
    """The place of the element to which each variable with a wire belongs; none of conditions, which lie nowhere."""
    y, at = symbols, Place(layout)
    found: dict[str, str] = {}

    def say(names: object, of: Callable[..., str]) -> None:
        assert isinstance(names, dict)
        found.update({str(name): of(key) for key, name in names.items()})

    for sections in (y.sections.clear, y.sections.healthy):
        say(sections, at.section)
    for machines in (y.machines.detected, y.machines.drive):
        say(machines, lambda key: at.machine(key[0]))
    lamps, a = y.lamp_proof, y.aspects
    for proofs in (lamps.stop, lamps.clear, lamps.caution, lamps.identifier, lamps.second, lamps.speed):
        say(proofs, at.signal)
    for aspects in (a.clear, a.caution, a.second, a.call_on, a.identifier, a.shunt, a.stop):
        say(aspects, at.signal)
    say(a.speed, lambda key: at.signal(key[0]))
    for distants in (a.distant_clear, a.distant_caution):
        say(distants, at.distant)
    for b, block in y.token.items():
        names = (block.asks, block.gives, block.keeps, block.has, block.clear, *block.tells.values())
        found.update(dict.fromkeys(map(str, names), at.boundary(b)))
    return found


class Place:
    """Says where elements lie."""

    def __init__(self, layout: Layout) -> None:
        self._layout, self._topo = layout, topology(layout)
        self._off = {layout.track.far(p.normal, p.node) for p in layout.pointwork.points if p.derailer}
        """Where derailers lead off the rails."""

    def section(self, s: SectionId) -> str:
        """Metres, and what lies beyond each end: `500 m between w1 (P1 normal) and w2 (P2 normal)`."""
        track = self._layout.track
        outside = next((b for b in track.boundaries if b.approach == s), None)
        if outside is not None:
            return f"{metres(outside.approach_m)} outside {outside.node}"
        ends = [self._end(s, node) for node in self._topo.ends[s] if node not in self._off]
        long = metres(sum(e.length for e in track.edges_in[s]))
        points = [str(p.id) for p in self._layout.machines.points_in.get(s, ())]
        over = f" over {', '.join(points)}" if points else ""
        return f"{long}{over} between {' and '.join(ends)}"

    def _end(self, s: SectionId, node: NodeId) -> str:
        """What lies beyond an end, and the legs of points that meet there."""
        track, pointwork = self._layout.track, self._layout.pointwork
        legs = []
        for e in sorted(track.edges_at[node], key=lambda e: e.section != s):
            point = pointwork.point_at.get(track.far(e.id, node))
            position = None if point is None else point.position_of(e.id)
            legs += [] if point is None else [f"{point.id} {'toe' if position is None else position}"]
        beyond = str(self._topo.beyond(s, node) or node)
        return f"{beyond} ({', '.join(legs)})" if legs else beyond

    def machine(self, m: MachineId) -> str:
        """The ends that it works, and whither each leads; of a device what it crosses."""
        device = self._layout.machines.device.get(m)
        if device is not None:
            return f"over {', '.join(device.over)}"
        return "; ".join(map(self._point, self._layout.machines.ends[m]))

    def _point(self, p: Point) -> str:
        toe, normal, reverse = (self._onto(edge, p.node) for edge in (p.toe, p.normal, p.reverse))
        legs = f"between {toe} and {reverse}" if p.derailer else f": normal to {normal}, reverse to {reverse}"
        return f"{p.id} in {self._layout.track.section_of(p.toe)}{' ' if p.derailer else ''}{legs}"

    def leads(self, m: MachineId, position: Position) -> str:
        """Whither points lead in a position: `P1 to g2`; nothing of devices."""
        ends = [p for p in self._layout.machines.ends.get(m, ()) if not p.derailer]
        return ", ".join(f"{p.id} to {self._onto(p.leg(position), p.node)}" for p in ends)

    def _onto(self, edge: EdgeId, node: NodeId) -> str:
        """The section, or the point within the same one, to which an edge leads from a node."""
        track, pointwork, own = self._layout.track, self._layout.pointwork, self._layout.track.section_of(edge)
        while True:
            node = track.far(edge, node)
            at: PointId | str | None = None
            if node in pointwork.point_at:
                at = pointwork.point_at[node].id
            elif node in pointwork.crossing_at:
                at = pointwork.crossing_at[node].id
            on = [e for e in track.edges_at[node] if e.id != edge]
            if at is not None or not on:
                return str(at or node)
            if on[0].section != own:
                return str(on[0].section)
            edge = on[0].id

    def signal(self, g: SignalId) -> str:
        """Between which sections, read in which direction, and for which movements."""
        signal = self._layout.signalling.signal[g]
        into = self._layout.track.section_of(signal.into)
        return f"from {self._topo.beyond(into, signal.node) or signal.node} into {into}, {signal.kind}"

    def distant(self, d: SignalId) -> str:
        """What it announces."""
        of = next(x.of for x in self._layout.signalling.distants if x.id == d)
        return f"announces {of}, {self.signal(of)}"

    def boundary(self, b: NodeId) -> str:
        """The line beyond."""
        outside = self._layout.track.boundary_at[b].approach
        return "the line beyond it" if outside is None else f"the line beyond it, {outside}"
