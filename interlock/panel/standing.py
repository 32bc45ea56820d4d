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
    """Sections that are blocked, and reminders (text, by whom, since when) by element.  `left`: sections, each with the
    name of a record at whose end it was blocked, that nobody has blocked again, nor acknowledged the alarm that says
    so; no section: a record that cannot be read."""

    blocks: tuple[str, ...] = ()
    reminders: Mapping[str, list[str]] = field(default_factory=dict)
    left: tuple[tuple[str, str], ...] = ()


def standing(events: Iterable[Event]) -> Standing:
    """What a record says that stands at its end."""
    blocks: dict[str, None] = {}
    reminders: Mapping[str, list[str]] = {}
    left: tuple[tuple[str, str], ...] = ()
    for e in events:
        if e["kind"] == KEPT:
            blocks, reminders = dict.fromkeys(e["blocks"]), e["reminders"]
            left = tuple((s, log) for s, log in e.get("left", ()))
        elif e["kind"] == "operation":
            text = str(e.get("text", ""))
            if text.startswith(BLOCK):
                blocks[text.removeprefix(BLOCK)] = None
            elif text.startswith(FREE):
                blocks.pop(text.removeprefix(FREE), None)
    return Standing(tuple(blocks), reminders, left)


def left_behind(path: Path, layout: str) -> tuple[tuple[str, str], ...]:
    """Where a record begins: what was blocked at the end of the one before it in the same folder, where a panel named
    that itself, and what that one had from before it; as `Standing.left`.  One that is empty, damaged or of something
    else says too little: it is told, and so is what those before it say."""
    left: dict[tuple[str, str], None] = {}
    for found in _before(path, layout):
        try:
            recorded = read_file(found)
        except OSError:
            recorded = None
        events = () if recorded is None else recorded.events
        ours = bool(events) and "views" in events[0] and events[0].get("layout") == layout
        if ours:
            then = standing(events)
            left |= dict.fromkeys((s, found.name) for s in then.blocks) | dict.fromkeys(then.left)
        if ours and recorded is not None and recorded.problem is None:
            break
        left["", found.name] = None
    return tuple(left)


def _before(path: Path, layout: str) -> list[Path]:
    """The records that panels of a layout have named themselves in the folder of another one, the last first."""
    named = re.compile(re.escape(layout) + r"-\d{8}-\d{6}\.log")
    try:
        return sorted((p for p in path.parent.iterdir() if named.fullmatch(p.name) and p != path), reverse=True)
    except OSError:
        return []


def told(section: str, log: str) -> str:
    """The alarm of something that is left."""
    if not section:
        return f"{log} cannot be read to its end: what was blocked then is not known, and is not blocked now"
    return f"section {section} was blocked when {log} ended, and is not blocked now: block it again"
