"""Tell the author which joints and boundaries are foul (R7).  IL3018, IL3041, IL3042, IL3045."""

from __future__ import annotations

from interlock.frontend.context import Context
from interlock.model.elements import BoundaryKind, Position
from interlock.model.foul import crossed_sections, foul_beside, foul_boundaries, foul_joints
from interlock.model.layout import Layout


def check_foul(ctx: Context, layout: Layout) -> None:
    """Report each foul joint; the derivation protects it."""
    for f in foul_joints(layout):
        kind, side = ("points", "leg") if isinstance(f.side, Position) else ("crossings", "arm")
        before = next((e.section for e in layout.track.edges_at[f.node] if e.section != f.neighbour), f.section)
        ctx.add(
            "IL3018",
            f"the joint {before}|{f.neighbour} is foul of {f.name}: it lies {f.distance:g} m "
            f"from the {kind[:-1]}, and {f.needed:g} m are needed; routes over the other {side} of {f.element} require "
            f"{f.neighbour} clear"
            + (f" unless {f.when[0]} is detected {f.when[1].other}" if f.when is not None else ""),
            ctx.at_key(kind, f.element),
            f"where it is to be free, draw the joint {f.needed - f.distance:g} m further out (`legs`)"
            + (", or state where the fouling point is (`fouling`)" if kind == "points" else ""),
        )
        if f.near is not None:
            it, metres, needed = f.near
            ctx.add(
                "IL3042",
                f"{it} leads to the joint {before}|{f.neighbour}, which is foul of {f.name}, and itself lies only "
                f"{metres:g} m from {f.name}, where {needed:g} m are needed: whatever passes {it} comes too near, "
                f"and {f.neighbour} is required clear however {it} lies",
                ctx.at_key(kind, f.element),
                f"draw {it} as far away as it is (`legs`), or state where the fouling point of {f.element} is "
                "(`fouling`); if they are so near, nothing",
            )
    _near_diamonds(ctx, layout)
    _facing(ctx, layout)
    _boundaries(ctx, layout)


def _facing(ctx: Context, layout: Layout) -> None:
    """Report points and diamonds on either side of which a section begins too near."""
    found: dict[str, tuple[str, set[str]]] = {}
    for x in foul_beside(layout):
        found.setdefault(x.element, (x.name, set()))[1].update((x.section, x.neighbour))
    for element, (name, sections) in found.items():
        point = name.startswith("point")
        those = ", ".join(sorted(sections))
        fouling = f", or state where its fouling point is: `points: {{{element}: {{fouling: ...}}}}`" if point else ""
        ctx.add(
            "IL3045",
            f"{those} begin too near to {name}, on both of its {'legs' if point else 'arms'}: what stands at the one "
            "joint is in the way of what stands at the other, or runs past it, and routes there require the other "
            "section clear",
            ctx.at_key("points" if point else "crossings", element),
            f"draw {element} as far away from them as it is (`legs`){fouling}; if they are so near, nothing",
        )


def _near_diamonds(ctx: Context, layout: Layout) -> None:
    """Report points and diamonds that lie nearer to a diamond than vehicles on it stand clear."""
    told = dict[tuple[str, str], float]()
    for x in crossed_sections(layout):
        unless = f" unless {x.when[0]} is detected {x.when[1].other}" if x.when is not None else ""
        if x.element != x.crossing and told.setdefault((x.crossing, x.element), x.distance) == x.distance:
            kind = "point" if x.element in layout.pointwork.point else "diamond"
            ctx.add(
                "IL3042",
                f"diamond {x.crossing} lies only {x.distance:g} m from {kind} {x.element}, where {x.needed:g} m are "
                "needed: whatever passes over its other arm comes too near, and "
                f"{x.neighbour} is required clear{unless}",
                ctx.at_key("crossings", x.crossing),
                f"draw {x.crossing} as far away as it is (`legs`), or state where the fouling point of {x.element} is "
                "(`fouling`); if they are so near, nothing",
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
        point = b.element in layout.pointwork.point
        kind = "point" if point else "diamond"
        fouling = f", or state where its fouling point is: `points: {{{b.element}: {{fouling: ...}}}}`" if point else ""
        enters = layout.track.boundary_at[b.node].kind is BoundaryKind.IN
        ctx.add(
            "IL3041",
            f"boundary {b.node} is foul of {kind} {b.element}: it lies {b.distance:g} m from it, and {b.needed:g} m "
            f"are needed; a train that {'waits to come in' if enters else 'has left'} may {'' if enters else 'still '}"
            "stand there while another one passes",
            ctx.at_key("boundaries", str(b.node)),
            f"draw the track on beyond the fouling point of {b.element}, in a section of its own{fouling}",
        )
