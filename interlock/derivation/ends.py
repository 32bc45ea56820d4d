"""Where routes lead, as sentences for whoever chose some of them and met none."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from interlock.model.elements import SectionId


def over_which(ways: Iterable[Sequence[SectionId]]) -> str:
    """Over which sections routes lead that fit but for these; the first three."""
    told = list(dict.fromkeys(", ".join(dict.fromkeys(w)) for w in ways))
    return "the routes between these ends lead over " + ", or over ".join(told[:3]) + (", ..." if told[3:] else "")


def where_routes_lead(entry: str | None, exit_: str | None, led: Iterable[tuple[str, str]]) -> str:
    """Of a choice of routes that fits none: where those from its signal lead, or from where those to its end come."""
    led = list(led)
    if entry is not None:
        ends = ", ".join(sorted({there for here, there in led if here == entry}))
        return f": from {entry} routes lead to {ends}" if ends else f": no route begins at {entry}"
    if exit_ is not None:
        starts = ", ".join(sorted({here for here, there in led if there == exit_}))
        return f": to {exit_} routes lead from {starts}" if starts else f": no route ends at {exit_}"
    return ""
