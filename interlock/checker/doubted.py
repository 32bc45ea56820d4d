"""Where the layout's own numbers leave an assumption no room: what runs through a section unseen (A-SCAN), runs on
while its overlap is given up (A-STAND), or stands foul beyond a boundary (A-BEYOND).

Nothing is refused for it: it is said beside the assumptions."""

from __future__ import annotations

from collections.abc import Iterator

from interlock.checker.drawing import Drawing, Edge
from interlock.checker.lengths import Lengths


def doubts(lengths: Lengths) -> Iterator[str]:
    """What is to be said, an assumption each."""
    fast = [f"{s} in {seconds:.2f} s" for s, seconds in lengths.unseen().items()]
    if fast:
        yield f"A-SCAN holds of no train at full speed through {', '.join(fast)}"
    running = [
        f"{g}, whose overlap is released after {ms / 1000:g} s" for g, (ms, _) in released_early(lengths).items()
    ]
    if running:
        yield f"A-STAND holds of no train at full speed to {', '.join(running)}"
    foul = [f"{b}, foul of {of}" for b, of in foul_boundaries(lengths.r.drawn)]
    if foul:
        yield f"A-BEYOND says nothing of a train that stands at {', '.join(foul)}"


def released_early(lengths: Lengths) -> dict[str, tuple[int, float]]:
    """By signal the milliseconds after which its overlap is given up, where the fastest train runs on for longer in the
    section before it, and for how many seconds: its whole length, the last of it braking as late as it can."""
    found: dict[str, tuple[int, float]] = {}
    b = lengths.r.drawn.rule("braking_ms2")
    for name in sorted(lengths.overlaps):
        g = lengths.r.signals[name]
        before = lengths.before(g)
        metres = (
            max((w.length for w in lengths.r.track.ways[before] if w.exit == g.node), default=0.0) if before else 0.0
        )
        v = lengths.kmh(before) / 3.6
        braked = v * v / 2 / b
        seconds = v / b + (metres - braked) / v if metres >= braked else (2 * metres / b) ** 0.5
        if lengths.overlap_release(g) < 1000 * seconds:
            found[name] = lengths.overlap_release(g), seconds
    return found


def foul_boundaries(d: Drawing) -> list[tuple[str, str]]:
    """Boundaries nearer to a point or diamond than what stands there must be, and to which."""
    margin = d.rule("clearance_m")
    legs = [(p.name, d.edges[p.leg(x)], p.fouling + margin) for p in d.points.values() for x in ("N", "R")]
    arms = [(c.name, d.edges[n], c.fouling + margin) for c in d.diamonds.values() for a in c.arms for n in a]
    return sorted({(b, of) for of, e, room in (*legs, *arms) for b in _near(d, of, e, of, room)})


def _near(d: Drawing, start: str, e: Edge, node: str, room: float) -> Iterator[str]:
    """Boundaries within so many metres of a node, over an edge and on from there."""
    far, left = e.far(node), room - e.length
    if left <= 0 or far == start:
        return
    if far in d.boundaries:
        yield far
    for x in d.onward(far, e):
        yield from _near(d, start, x, far, left)
