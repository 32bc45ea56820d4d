"""Whether what signals may show of speeds is what the delays are made for (R11)."""

from __future__ import annotations

from interlock.checker.ahead import Ahead
from interlock.checker.railway import Calling, Path, Run
from interlock.verify import need


def stated_throughout(world: Ahead) -> None:
    """Raises Rejected where a signal may show more than the line's speed over sections that state none: there every
    delay and every braking distance is made for the line's."""
    r, line = world.r, world.r.drawn.rule("line_speed_kmh")
    for c in (Calling(g, False) for g in r.signals.values() if g.main):
        runs = [u for p in r.paths.of(c) for u in (Run((p,), ()), *r.paths.runs(p))]
        for u in runs:
            shown = min(_shown(world, p) for p in u.parts)
            bare = {w.section for w in u.whole.ways if (r.track.told.get(w.section) or {}).get("speed") is None}
            if not line < shown < float("inf") or not bare:
                continue
            wanted = r.paths.can_be(c, u.whole) and not r.paths.barred(c, u.whole, False)
            over = ", ".join(sorted(bare))
            need(
                not wanted, f"{c.name} may show {shown:g} km/h over {over}, where none is stated and {line:g} km/h hold"
            )


def _shown(world: Ahead, p: Path) -> float:
    """The highest speed that may be shown of a path, as the overlap beyond it may lie; infinite where nothing is
    stated."""
    beyond = [world.entry(p, o) for o in world.w_overlaps_beyond(p)]
    highest = max((float("inf") if v is None else v for v in beyond), default=float("inf"))
    along = world.lengths.path_kmh(p)
    return highest if along is None else min(along, highest)
