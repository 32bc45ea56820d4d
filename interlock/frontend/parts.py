"""Derailers and slips as what they are made of: points, edges and a diamond.

Input: the wirer with every port joined.  Output: its graph parts.
"""

from __future__ import annotations

from typing import Protocol

from interlock.frontend.ports import Port, Wiring
from interlock.frontend.schema import DerailerSpec, SlipSpec
from interlock.model.elements import (
    Blades,
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
        Point(PointId(name), MachineId(d.machine or name), node, outer, rails, inner, 1.0, Work.MOTOR, derailer=True)
    )


def build_slip(w: Wirer, name: str, slip: SlipSpec) -> None:
    """A double slip: two points toe to toe.  One that one motor works, and a single slip: a diamond, and a point at
    each end from which slip rails lead."""
    s = _Slip(w, name, slip)
    if slip.single is not None:
        s.diamond((slip.single,), (f"{name}a", f"{name}b"))
    elif one_motor(slip):
        s.diamond(("1a-2b", "2a-1b"), tuple(f"{name}/{end}" for end in ENDS))
    else:
        s.toe_to_toe()


ENDS = ("1a", "2b", "2a", "1b")
"""The ends of a slip, those that slip rails join one after the other."""


def one_motor(slip: SlipSpec) -> bool:
    """Whether a double slip has one machine, which lays all of its blades for the straight ways, or for the slips."""
    return slip.single is None and len(slip.machines) > 0 and len(set(slip.machines)) == 1


def points_of(name: str, slip: SlipSpec) -> tuple[str, ...]:
    """The names of the points of which a slip is made."""
    return tuple(f"{name}/{end}" for end in ENDS) if one_motor(slip) else (f"{name}a", f"{name}b")


class _Slip:
    """A slip under construction."""

    def __init__(self, w: Wirer, name: str, slip: SlipSpec) -> None:
        self.w, self.name, self.slip = w, name, slip
        self.length = slip.legs if slip.legs is not None else w.principles.leg_m
        self.fouling = slip.fouling if slip.fouling is not None else w.principles.fouling_m
        self.machines = [MachineId(m) for m in slip.machines] or [MachineId(f"{name}a"), MachineId(f"{name}b")]

    def toe_to_toe(self) -> None:
        """One machine chooses between the ends `a`, the other between the ends `b`: its blades lie at those across."""
        own = self.slip.blades == "near"  # the first machine's blades lie at the ends `a`, so that it chooses among `b`
        sides = "ba" if own else "ab"
        nodes = NodeId(f"{self.name}a"), NodeId(f"{self.name}b")
        middle = self._edge("m", nodes[0], nodes[1], 1.0)
        for i, side in enumerate(sides):
            across = sides[1 - i]
            legs = [self._outward(nodes[i], f"{n}{side}") for n in (1, 2)]
            self._point(nodes[i], i, (middle, legs[0], legs[1]), (f"1{across}", f"2{across}"), f"1{side}", f"2{side}")

    def diamond(self, joined: tuple[str, ...], names: tuple[str, ...]) -> None:
        """A diamond; `joined`: the pairs of ends with slip rails between, `names` of the points at these, in order."""
        x = NodeId(self.name)
        at = dict(zip([end for pair in joined for end in pair.split("-")], map(NodeId, names), strict=True))
        straight = {end: self._straight(x, end, at.get(end)) for end in ("1a", "1b", "2a", "2b")}
        for k, pair in enumerate(joined):
            first, second = pair.split("-")
            curve = self._edge("s" if len(joined) == 1 else f"s{k + 1}", at[first], at[second], self.length)
            for i, (end, to) in enumerate(((first, second), (second, first))):
                legs = self._outward(at[end], end), straight[end], curve
                self._point(at[end], i, legs, (end,), across(end), to)
        arms = (straight["1a"], straight["1b"]), (straight["2a"], straight["2b"])
        self.w.out.crossings.append(
            Crossing(CrossingId(self.name), x, arms, max(self.fouling, self.w.principles.fouling_m))
        )

    def _straight(self, x: NodeId, end: str, point: NodeId | None) -> EdgeId:
        return self._outward(x, end) if point is None else self._edge(f"{end}x", point, x, self.length / 2)

    def _edge(self, end: str, a: NodeId, b: NodeId, length: float) -> EdgeId:
        return self.w.edge(f"{self.name}.{end}", a, b, length, self.slip.section)

    def _outward(self, node: NodeId, end: str) -> EdgeId:
        return self._edge(end, node, self.w.node(Port("slip", self.name, end)), self.length)

    def _point(
        self,
        node: NodeId,
        side: int,
        edges: tuple[EdgeId, EdgeId, EdgeId],
        lie_at: tuple[str, ...],
        normal: str,
        reverse: str,
    ) -> None:
        p, machine = PointId(node), self.machines[side % len(self.machines)]
        self.w.out.points.append(Point(p, machine, node, *edges, self.fouling))
        self.w.out.blades.append(Blades(p, lie_at, normal, reverse))


def across(end: str) -> str:
    """The other end of the same arm."""
    return f"{end[0]}{'b' if end[1] == 'a' else 'a'}"
