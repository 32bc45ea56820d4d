"""Double slips with two machines.

In the layout such a slip is two points toe to toe, the blades of each lying at the legs of the other.  On the plan it
is a diamond with two slip rails and blades at all four ends, as on the ground: it is placed as a diamond, and then
given its points back, which lie in its middle.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace

from interlock.dataclass import dataclass
from interlock.derivation.lamps import beside_main
from interlock.emit.drawing.canvas import BLADES, Drawing, Spot, cut_at
from interlock.model.elements import Blades, Crossing, CrossingId, Edge, EdgeId, NodeId, PointId
from interlock.model.layout import Layout, carried

CHORDS = {"1a": "2b", "2b": "1a", "2a": "1b", "1b": "2a"}
"""The ends that slip rails join."""


@dataclass(frozen=True)
class DoubleSlip:
    """Its name, the blades of its two points, and its four legs by the end to which they lead."""

    name: str
    blades: tuple[Blades, Blades]
    legs: Mapping[str, EdgeId]

    @property
    def nodes(self) -> tuple[NodeId, NodeId]:
        """Where its points lie; the first is the node of its diamond."""
        one, two = self.blades
        return NodeId(one.point), NodeId(two.point)


def double_slips(layout: Layout) -> list[DoubleSlip]:
    """Those of a layout, whether it has their points or their diamonds."""
    pairs: dict[str, list[Blades]] = {}
    for b in layout.pointwork.blades:
        if len(b.at) == 2:
            pairs.setdefault(b.point[:-1], []).append(b)  # NAMEa and NAMEb
    out = []
    for name, (one, two) in sorted(pairs.items()):
        legs = {end: EdgeId(f"{name}.{end}") for end in CHORDS}
        diamond = layout.pointwork.crossing_at.get(NodeId(one.point))
        if diamond is not None:
            ends = zip(("1a", "1b", "2a", "2b"), (*diamond.arms[0], *diamond.arms[1]), strict=True)
            legs = dict(ends)
        out.append(DoubleSlip(name, (one, two), legs))
    return out


def with_diamonds(layout: Layout) -> Layout:
    """The layout with a diamond in the place of each of them, at the node of its first point."""
    slips = double_slips(layout)
    if not slips:
        return layout
    gone = {b.point for s in slips for b in s.blades}
    middles = {layout.pointwork.point[s.blades[0].point].toe for s in slips}
    inward = {s.legs[end] for s in slips for end in ("1a", "2a")}
    to = {two: one for one, two in (s.nodes for s in slips)}

    def joined(e: Edge) -> Edge:
        a, b = to.get(e.a, e.a), to.get(e.b, e.b)
        centre = {s.nodes[0] for s in slips}
        return replace(e, a=b, b=a) if e.id in inward and a in centre else replace(e, a=a, b=b)

    diamonds = [
        Crossing(CrossingId(s.nodes[0]), s.nodes[0], ((s.legs["1a"], s.legs["1b"]), (s.legs["2a"], s.legs["2b"])), 0.0)
        for s in slips
    ]
    made = replace(
        layout,
        track=replace(layout.track, edges=tuple(joined(e) for e in layout.track.edges if e.id not in middles)),
        pointwork=replace(
            layout.pointwork,
            points=tuple(p for p in layout.pointwork.points if p.id not in gone),
            crossings=tuple(sorted((*layout.pointwork.crossings, *diamonds), key=lambda c: c.id)),
        ),
        printed=replace(
            layout.printed,
            anchors=tuple(
                replace(a, nodes=tuple(dict.fromkeys(to.get(n, n) for n in a.nodes))) for a in layout.printed.anchors
            ),
        ),
    )
    carried(beside_main, layout, made)  # its routes are not those of the layout
    return made


def restore(d: Drawing, layout: Layout) -> None:
    """Give the plan of `with_diamonds` the points of the layout, and the edges between them."""
    d.layout = layout
    for s in double_slips(layout):
        x, y = d.at[s.nodes[0]]
        for n in s.nodes:
            p = layout.pointwork.point_at[n]
            left = d.edges[p.normal][-1] == (x, y)
            d.at[n] = here = (x - 1, y) if left else (x + 1, y)
            for e in (p.normal, p.reverse):
                d.edges[e] = [*d.edges[e][:-1], here] if left else [here, *d.edges[e][1:]]
            d.edges[p.toe] = [(x - 1, y), (x + 1, y)]


@dataclass(frozen=True)
class Blade:
    """A pair of blades: whose they are, at which end, where they lie, the next spot along the arm and along the slip
    rail, whether they lead along the rail in normal, and the line from them to the far end of their leg."""

    point: PointId
    end: str
    at: Spot
    arm: Spot
    chord: Spot
    turned: bool
    leg: list[Spot]

    def towards(self, normal: bool) -> Spot:
        """Where they lead in a position."""
        return self.chord if normal is self.turned else self.arm


def blades(d: Drawing, s: DoubleSlip) -> Iterator[Blade]:
    """The four pairs of blades of a slip."""
    there = [d.at[n] for n in s.nodes if n in d.at]
    middle = (sum(x for x, _ in there) / len(there), there[0][1])
    legs = {}
    for end, edge in s.legs.items():
        line = d.edges[edge]
        outward = line if abs(line[0][0] - middle[0]) <= abs(line[-1][0] - middle[0]) else line[::-1]
        legs[end] = cut_at([middle, *outward[1:]], BLADES)[1]
    for b in s.blades:
        for end in b.at:
            at, chord = legs[end][0], legs[CHORDS[end]][0]
            yield Blade(b.point, end, at, middle, chord, b.normal == CHORDS[end], legs[end])
