"""Tell the author which joints and boundaries are foul (R7).  IL3018, IL3041, IL3042, IL3045."""

from __future__ import annotations

from interlock.dataclass import dataclass
from interlock.diag.called import called
from interlock.frontend.context import Context
from interlock.model.elements import BoundaryKind, CrossingId, PointId
from interlock.model.foul import crossed_sections, foul_beside, foul_boundaries, foul_joints
from interlock.model.layout import Layout


@dataclass(frozen=True)
class _Written:
    """A point or diamond as the layout file has it: under which key, what it is called, what else would help."""

    key: tuple[str, str]
    kind: str
    name: str
    fouling: str

    @property
    def side(self) -> str:
        """What it has two of."""
        return "arm" if self.kind == "diamond" else "leg"


def _written(layout: Layout, element: PointId | CrossingId) -> _Written:
    """A point or diamond, also of a slip, or a derailer, whose fouling point nobody states."""
    point = layout.pointwork.point.get(PointId(element))
    slip = layout.pointwork.slip_of.get(PointId(element))
    if point is None:
        if element in {*layout.pointwork.slip_of.values()}:
            where = "where fouling points are that nothing is stated of: `principles: {fouling_m: ...}`"
            name = f"the diamond of {called('slip', element)}"
            return _Written(("slips", element), "diamond", name, f", or state {where}")
        where = f"where the fouling point of {element} is: `crossings: {{{element}: {{fouling: ...}}}}`"
        return _Written(("crossings", element), "diamond", f"diamond {element}", f", or state {where}")
    if point.derailer:
        return _Written(("derailers", element), "derailer", f"derailer {element}", "")
    key, owner = ("points", str(element)) if slip is None else ("slips", slip)
    name = f"point {element}" if slip is None else f"point {element} of {called('slip', slip)}"
    where = f"where the fouling point of {element} is: `{key}: {{{owner}: {{fouling: ...}}}}`"
    return _Written((key, owner), "point", name, f", or state {where}")


def check_foul(ctx: Context, layout: Layout) -> None:
    """Report each foul joint; the derivation protects it."""
    for f in foul_joints(layout):
        it = _written(layout, f.element)
        before = next((e.section for e in layout.track.edges_at[f.node] if e.section != f.neighbour), f.section)
        ctx.add(
            "IL3018",
            f"the joint {before}|{f.neighbour} is foul of {it.name}: it lies {f.distance:g} m "
            f"from the {it.kind}, and {f.needed:g} m are needed; routes over the other {it.side} of {f.element} "
            f"require {f.neighbour} clear"
            + (f" unless {f.when[0]} is detected {f.when[1].other}" if f.when is not None else ""),
            ctx.at_key(*it.key),
            f"where it is to be free, draw the joint {f.needed - f.distance:g} m further out (`legs`){it.fouling}",
        )
        if f.near is not None:
            near, metres, needed = f.near
            fouling = (
                it.fouling if needed == f.needed else f", or state where the fouling point of {near} is (`fouling`)"
            )
            ctx.add(
                "IL3042",
                f"{near} leads to the joint {before}|{f.neighbour}, which is foul of {it.name}, and itself lies only "
                f"{metres:g} m from {it.name}, where {needed:g} m are needed: whatever passes {near} comes too near, "
                f"and {f.neighbour} is required clear however {near} lies",
                ctx.at_key(*it.key),
                f"draw {near} as far away as it is (`legs`){fouling}; if they are so near, nothing",
            )
    _near_diamonds(ctx, layout)
    _facing(ctx, layout)
    _boundaries(ctx, layout)


def _facing(ctx: Context, layout: Layout) -> None:
    """Report points and diamonds on either side of which a section begins too near."""
    found: dict[PointId | CrossingId, set[str]] = {}
    for x in foul_beside(layout):
        found.setdefault(x.element, set()).update((x.section, x.neighbour))
    for element, sections in found.items():
        it = _written(layout, element)
        ctx.add(
            "IL3045",
            f"{', '.join(sorted(sections))} begin too near to {it.name}, on both of its {it.side}s: what stands at the "
            "one joint is in the way of what stands at the other, or runs past it, and routes there require the other "
            "section clear",
            ctx.at_key(*it.key),
            f"draw {it.key[1]} as far away from them as it is (`legs`){it.fouling}; if they are so near, nothing",
        )


def _near_diamonds(ctx: Context, layout: Layout) -> None:
    """Report points and diamonds that lie nearer to a diamond than vehicles on it stand clear."""
    told = dict[tuple[str, str], float]()
    for x in crossed_sections(layout):
        unless = f" unless {x.when[0]} is detected {x.when[1].other}" if x.when is not None else ""
        if x.element != x.crossing and told.setdefault((x.crossing, x.element), x.distance) == x.distance:
            met = _written(layout, x.element)
            ctx.add(
                "IL3042",
                f"diamond {x.crossing} lies only {x.distance:g} m from {met.name}, where {x.needed:g} m are "
                "needed: whatever passes over its other arm comes too near, and "
                f"{x.neighbour} is required clear{unless}",
                ctx.at_key("crossings", x.crossing),
                f"draw {x.crossing} as far away as it is (`legs`){met.fouling}; if they are so near, nothing",
            )
        elif x.element == x.crossing and x.near is not None:
            it, metres, needed = x.near
            ctx.add(
                "IL3042",
                f"{it} leads to the diamond {x.crossing}, and lies only {metres:g} m from it, where {needed:g} m are "
                f"needed: whatever passes {it} comes too near, and {x.neighbour} is required clear however {it} lies",
                ctx.at_key("crossings", x.crossing),
                f"draw {it} as far away as it is (`legs`); if they are so near, nothing",
            )


def _boundaries(ctx: Context, layout: Layout) -> None:
    for b in foul_boundaries(layout):
        it = _written(layout, b.element)
        enters = layout.track.boundary_at[b.node].kind is BoundaryKind.IN
        ctx.add(
            "IL3041",
            f"boundary {b.node} is foul of {it.name}: it lies {b.distance:g} m from it, and {b.needed:g} m "
            f"are needed; a train that {'waits to come in' if enters else 'has left'} may {'' if enters else 'still '}"
            "stand there while another one passes",
            ctx.at_key("boundaries", str(b.node)),
            f"draw the track on beyond the fouling point of {b.element}, in a section of its own{it.fouling}",
        )
