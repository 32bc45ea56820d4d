"""Faults planted on purpose: one in the runtime or in a text, each of which the comparison must notice."""

from __future__ import annotations

import re
from collections.abc import Callable

RISING = ("0 if before is None else min(before + dt_ms, TIMERS[name])", "min((before or 0) + dt_ms, TIMERS[name])")


def _put(text: str, old: str, new: str) -> str:
    if text.count(old) < 1:
        raise ValueError(f"nothing to plant at: {old}")
    return text.replace(old, new, 1)


def early_timer(runtime: str) -> str:
    """The runtime counts time in the very scan in which a timer's input rises."""
    return _put(runtime, *RISING)


def _output_term(source: str) -> str:
    """The first lamp that several routes light no longer hears of one of them."""
    found = re.search(r"^  OUTP\.Y[PYW]_\w+ := (?:D\d*\.\w+ OR )+D\d*\.\w+;", source, re.MULTILINE)
    if found is None:
        raise ValueError("no lamp is lit by several routes")
    return _put(source, found[0], found[0].rpartition(" OR ")[0] + ";")


def _exchanged_wires(source: str) -> str:
    """The first two wires of %Q are exchanged."""
    first, second = re.findall(r"AT (%QX\d+\.\d)", source)[:2]
    other = {first: second, second: first}
    return re.sub(r"%QX\d+\.\d", lambda m: other.get(m[0], m[0]), source)


def _long_cycle(source: str) -> str:
    """A cycle may be one millisecond longer."""
    return source.replace("PT := T#1001ms", "PT := T#1002ms")


def _slow_heartbeat(source: str) -> str:
    """A heartbeat may stand still a millisecond longer."""
    return _put(source, "STILL(IN := SAME, PT := T#1s)", "STILL(IN := SAME, PT := T#1001ms)")


def _open_said_otherwise(source: str) -> str:
    """A route that is open says that it is only set."""
    return source.replace(" := 3;", " := 2;")


TEXTS: dict[str, Callable[[str], str]] = {
    "a lamp no longer hears of one route: one term less in one output equation": _output_term,
    "two wires exchanged in the mapping program": _exchanged_wires,
    "the watch of the cycle: one millisecond later": _long_cycle,
    "the watch of the heartbeat: one millisecond later": _slow_heartbeat,
    "a route that is open says that its signal is at stop: another number in its word": _open_said_otherwise,
}
"""Faults of the text with its mapping program."""
