"""Sections without detection are sidings.  IL3020."""

from __future__ import annotations

from interlock.diag.called import called
from interlock.frontend.context import Context
from interlock.model.layout import Layout
from interlock.model.traversal import topology


def check_detection(ctx: Context, layout: Layout) -> None:
    """Report sections without detection in which movements could not end."""
    for s in sorted(layout.track.undetected - topology(layout).berths):
        ctx.add(
            "IL3020",
            f"{called('section', s)} has no detection, and is no siding where shunting movements end",
            ctx.at("sections", s, "detected"),
            "a siding is plain track that is left only on a signal, one of them for shunting",
        )
