"""What outlasts a restart of the server: sections that are blocked, and reminders.  A record that goes on has them."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from dataclasses import field
from pathlib import Path
from typing import Any

from interlock.dataclass import dataclass
from interlock.record.log import Event, read_file

KEPT = "kept"
"""The kind of an event that tells all of it: written before the operation that changes it, so that nothing is lost
however the server ends."""

LONGEST = 100_000_000
"""Bytes of the first event of a record, with its plan, at most."""
TAIL = 1_000_000
"""Bytes at the end of a record in which its last event is looked for."""

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


def left_behind(path: Path, layout: str, shown: object) -> tuple[str, tuple[str, ...]]:
    """Where a record begins: the name of the one in the same folder that ended last, whatever it is called, and the
    sections that were blocked at its end.  It is of the same layout, which may have been changed since, or of one that
    had another name and shows the same (`shown`: the views of this one)."""
    found = []
    try:
        for p in path.parent.glob("*.log"):
            if p != path and p.is_file() and _is_of(_first(p), layout, shown):
                found.append((_ended_ms(p), p.name, p))
        events = read_file(max(found)[2]).events if found else ()
    except OSError:
        return "", ()
    return (max(found)[1], standing(events).blocks) if events else ("", ())


def _is_of(begin: Mapping[str, Any], layout: str, shown: object) -> bool:
    """Whether a record that begins so is one of a panel of this layout."""
    return "views" in begin and (begin.get("layout") == layout or begin["views"] == shown)


def _first(path: Path) -> Mapping[str, Any]:
    """The first event of a record; empty where it is none."""
    with path.open("rb") as f:
        return _event(f.readline(LONGEST))


def _ended_ms(path: Path) -> int:
    """When the last event was written; where that cannot be read, when the file was."""
    with path.open("rb") as f:
        size = f.seek(0, 2)
        f.seek(max(0, size - TAIL))
        last = f.read().rpartition(b"\n")[0].rpartition(b"\n")[2]
    t = _event(last).get("t")
    return t if isinstance(t, int) else path.stat().st_mtime_ns // 1_000_000


def _event(line: bytes) -> Mapping[str, Any]:
    try:
        event = json.loads(line)
    except (ValueError, RecursionError):
        return {}
    return event if isinstance(event, dict) else {}
