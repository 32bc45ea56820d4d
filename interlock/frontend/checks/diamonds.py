"""Diamonds whose arms hardly join what they should: ends of the two are exchanged.  IL7023.

In a scissors one arm of the diamond joins the two ends of one crossover.  Where they are exchanged, the machine of each
crossover leads onto both arms.  Whatever works them, whoever runs over an arm may be led back to where he came from.
"""

from __future__ import annotations

from interlock.dataclass import dataclass
from interlock.diag import Element
from interlock.diag.called import called
from interlock.frontend.context import Context
from interlock.model.elements import Crossing, EdgeId, NodeId, Point, Position
from interlock.model.layout import Layout
from interlock.model.plain import plains

_LEG = {Position.NORMAL: "normal", Position.REVERSE: "reverse"}
_Arm = list["_Leg | None"]


@dataclass(frozen=True)
class _Leg:
    """A leg of a point, to which one comes over plain track."""

    point: Point
    at: Position

    def __str__(self) -> str:
        return f"{self.point.id}.{_LEG[self.at]}"


def check_diamonds(ctx: Context, layout: Layout) -> None:
    """Report each diamond once: onto both of whose arms one machine leads, or an arm of which leads back to a point.
    (Of the diamond in a slip IL7017 tells it.)"""
    for c in layout.pointwork.crossings:
        if c.id in ctx.file.crossings:
            arms = [[_leg(layout, c.node, e) for e in arm] for arm in c.arms]
            told = _worked_together(c, arms) or _leads_back(layout, c, arms)
            if told is not None:
                ctx.add("IL7023", told[0], ctx.at_key("crossings", c.id), told[1], about=Element("crossings", c.id))


def _leg(layout: Layout, node: NodeId, edge: EdgeId) -> _Leg | None:
    """The leg of a point to which plain track leads from a node over an edge."""
    p = plains(layout).of[edge]
    forward = p.nodes[0] == node and p.edges[0].id == edge
    point, last = layout.pointwork.point_at.get(p.end(forward)), p.edges[-1 if forward else 0].id
    at = None if point is None or point.derailer else point.position_of(last)
    return None if point is None or at is None else _Leg(point, at)


def _worked_together(c: Crossing, arms: list[_Arm]) -> tuple[str, str] | None:
    """Two ends of one machine that lie for both arms at once; what to exchange so that one arm joins them."""
    for k, first in enumerate(arms[0]):
        for second in arms[1]:
            if first is None or second is None or first.point == second.point:
                continue
            if (first.point.machine, first.at) != (second.point.machine, second.at):
                continue
            other = arms[0][1 - k] or f"{c.id}.1{'ba'[k]}"
            return (
                f"the machine {first.point.machine} leads onto both arms of {called('diamond', c.id)} at once, over "
                f"{first} and over {second}, and ways over these cross each other",
                "one arm of a scissors joins the two ends of one crossover: see whether "
                f"`{other}` and `{second}` are exchanged in the `arms` of {c.id}",
            )
    return None


def _leads_back(layout: Layout, c: Crossing, arms: list[_Arm]) -> tuple[str, str] | None:
    """An arm whose two points turn their toes to the two legs of one point: over it one comes back to that."""
    for first, second in arms:
        if first is None or second is None:
            continue
        one, other = (_leg(layout, x.point.node, x.point.toe) for x in (first, second))
        if one is not None and other is not None and one.point == other.point and one.at is not other.at:
            return (
                f"whoever runs over {one}, then over {first}, {called('diamond', c.id)} and {second}, comes back to "
                f"{called('point', one.point.id)} over its other leg",
                f"if no loop is meant, see whether ends are exchanged in the `arms` of {c.id}",
            )
    return None
