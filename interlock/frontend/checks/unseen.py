"""Sections through which a train may run before a scan has read them as occupied (A-SCAN).  IL3037.

The proof assumes that no train does: where one is faster than detector and scan, all sections may read clear with it
between them.  So the fastest passage of each section is held against `detection_delay_s`.
"""

from __future__ import annotations

from interlock.diag import Element
from interlock.diag.called import called
from interlock.frontend.context import Context
from interlock.frontend.scalars import item_parts
from interlock.model.layout import Layout
from interlock.model.needs import passages


def check_unseen(ctx: Context, layout: Layout) -> None:
    """Report each section, and each approach, that is run through in less."""
    delay = layout.principles.detection_delay_s
    approach_of = {item_parts(b.approach or "")[0]: n for n, b in ctx.file.boundaries.items()}
    for x in passages(layout):
        outside = approach_of.get(x.section)
        about = Element("sections", x.section) if outside is None else Element("boundaries", outside)
        if x.seconds >= delay or ctx.sink.gave("IL7005", about):  # a slip is told once
            continue
        run = f"{x.metres:g} m at {x.kmh:g} km/h are run through in {x.seconds:.2f} s"
        late = f"a scan may not have read it for {delay:g} s"
        text = f"{called('section', x.section)} may be run through unseen: {run}, and {late}"
        slower = int(x.metres / delay * 3.6)
        inside = f"state `sections: {{{x.section}: {{speed: {slower}}}}}` or less, join it to its neighbour, or "
        own = f"state the `detection_delay_s` that detector and scan keep: {int(x.seconds * 100) / 100:g} or less"
        if outside is not None:
            ctx.add("IL3037", text, ctx.at("boundaries", outside, "approach"), own)
        else:
            fix = (inside if slower >= 5 else "join it to its neighbour, or ") + own
            ctx.sink.add("IL3037", text, None, fix, about=about, cause="unseen", note=run)
