"""Derailers and slips as what they are made of: points, edges and a diamond.

Input: the wirer with every port joined.  Output: its graph parts.
"""

from __future__ import annotations

from typing import Protocol

from interlock.frontend.ports import Port, Wiring
from interlock.frontend.schema import DerailerSpec, SlipSpec
from interlock.model.elements import (
    Buffer,
    BufferKind,
    Crossing,
    CrossingId,
    EdgeId,
    MachineId,
    NodeId,
    Point,
    PointId,
    Work,
)
from interlock.model.principles import Principles


class Wirer(Protocol):
    """What parts are built with: nodes of ports, edges, and where they go."""

    out: Wiring
    principles: Principles

    def node(self, port: Port) -> NodeId:
        """The node of a port."""
        ...

    def edge(self, name: str, a: NodeId, b: NodeId, length: float, section: str) -> EdgeId:
        """A new edge."""
        ...


def build_derailer(w: Wirer, name: str, d: DerailerSpec) -> None:
    """A point whose normal leg leads off the rails."""
    length = d.legs if d.legs is not None else w.principles.leg_m
    node, off = NodeId(name), NodeId(f"{name}.off")
    outer = w.edge(f"{name}.outer", node, w.node(Port("derailer", name, "outer")), length, d.section)
    inner = w.edge(f"{name}.inner", node, w.node(Port("derailer", name, "inner")), length, d.section)
    rails = w.edge(f"{name}.off", node, off, 1.0, d.section)
    w.out.buffers.append(Buffer(off, BufferKind.DERAIL))
    w.out.points.append(
        Point(PointId(name), MachineId(name), node, outer, rails, inner, 1.0, Work.MOTOR, derailer=True)
    )


def build_slip(w: Wirer, name: str, slip: SlipSpec) -> None:
    """A double slip: two points toe to toe.  A single slip: a diamond, and a point on each arm that is joined."""
    length = slip.legs if slip.legs is not None else w.principles.leg_m
    fouling = slip.fouling if slip.fouling is not None else w.principles.fouling_m
    machines = [MachineId(m) for m in slip.machines] or [MachineId(f"{name}a"), MachineId(f"{name}b")]
    sides = [PointId(f"{name}a"), PointId(f"{name}b")]

    def outward(node: NodeId, end: str) -> EdgeId:
        return w.edge(f"{name}.{end}", node, w.node(Port("slip", name, end)), length, slip.section)

    def point(side: int, toe: EdgeId, normal: EdgeId, reverse: EdgeId) -> None:
        node = NodeId(sides[side])
        w.out.points.append(Point(sides[side], machines[side % len(machines)], node, toe, normal, reverse, fouling))

    a, b = (NodeId(s) for s in sides)
    if slip.single is None:
        middle = w.edge(f"{name}.m", a, b, 1.0, slip.section)
        for side, node in enumerate((a, b)):
            point(side, middle, outward(node, f"1{'ab'[side]}"), outward(node, f"2{'ab'[side]}"))
        return
    first, second = slip.single.split("-")  # the slip joins these two ends
    x = NodeId(name)
    curve = w.edge(f"{name}.s", a, b, length, slip.section)
    arms: dict[str, tuple[EdgeId, EdgeId]] = {}
    for side, (node, end) in enumerate(((a, first), (b, second))):
        straight = w.edge(f"{name}.{end}x", node, x, length / 2, slip.section)
        point(side, outward(node, end), straight, curve)
        other = f"{end[0]}{'b' if end[1] == 'a' else 'a'}"
        arms[end[0]] = (
            straight,
            w.edge(f"{name}.{other}", x, w.node(Port("slip", name, other)), length, slip.section),
        )
    w.out.crossings.append(Crossing(CrossingId(name), x, (arms["1"], arms["2"])))
