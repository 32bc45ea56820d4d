"""What outlasts a restart of the server: sections that are blocked, and reminders.  A record that goes on has them."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from dataclasses import field
from pathlib import Path

from interlock.dataclass import dataclass
from interlock.record.log import Event, read_file

KEPT = "kept"
"""The kind of an event that tells all of it: written before the operation that changes it, so that nothing is lost
however the server ends."""

BLOCK, FREE = "block section ", "free section "
"""What an operation that blocks a section, or frees it, begins with: records of before have nothing else."""


@dataclass(frozen=True)
class Standing:
    """Sections that are blocked, and reminders (text, by whom, since when) by element."""

    blocks: tuple[str, ...] = ()
    reminders: Mapping[str, list[str]] = field(default_factory=dict)


def standing(events: Iterable[Event]) -> Standing:
    """What a record says that stands at its end."""
    blocks: dict[str, None] = {}
    reminders: Mapping[str, list[str]] = {}
    for e in events:
        if e["kind"] == KEPT:
            blocks, reminders = dict.fromkeys(e["blocks"]), e["reminders"]
        elif e["kind"] == "operation":
            text = str(e.get("text", ""))
            if text.startswith(BLOCK):
                blocks[text.removeprefix(BLOCK)] = None
            elif text.startswith(FREE):
                blocks.pop(text.removeprefix(FREE), None)
    return Standing(tuple(blocks), reminders)


def left_behind(path: Path, layout: str) -> tuple[str, tuple[str, ...]]:
    """Where a record begins: the name of the one before it in the same folder, where a panel named that itself, and
    the sections that were blocked at its end."""
    named = re.compile(re.escape(layout) + r"-\d{8}-\d{6}\.log")
    try:
        found = max((p for p in path.parent.iterdir() if named.fullmatch(p.name) and p != path), default=None)
        events = () if found is None else read_file(found).events
    except OSError:
        return "", ()
    if found is None or not events or "views" not in events[0] or events[0].get("layout") != layout:
        return "", ()
    return found.name, standing(events).blocks
