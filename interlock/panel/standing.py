"""What outlasts a restart of the server: sections that are blocked, and reminders.  A record that goes on has them."""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Mapping
from contextlib import suppress
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


def left_behind(path: Path, layout: str, shown: object) -> tuple[tuple[str, str], ...]:
    """Where a record begins: what was blocked at the end of the one in the same folder that ended last, and what that
    one had from before it; as `Standing.left`.  It is of the same layout, which may have been changed since, or of one
    that had another name and shows the same (`shown`: the views of this one).

    One that is damaged, or empty, says too little: it is told, and so is what those before it say."""
    left: dict[tuple[str, str], None] = {}
    for found, ours in _before(path, layout, shown):
        try:
            recorded = read_file(found) if ours else None
        except OSError:
            recorded = None
        if recorded is not None:
            then = standing(recorded.events)
            left |= dict.fromkeys((s, found.name) for s in then.blocks) | dict.fromkeys(then.left)
            if recorded.problem is None:
                break
        left["", found.name] = None
    return tuple(left)


def _before(path: Path, layout: str, shown: object) -> list[tuple[Path, bool]]:
    """The records of a layout in the folder of another one, whatever they are called, the last first; and those that a
    panel has named after it and that cannot be read at all (False)."""
    named = re.compile(re.escape(layout) + r"-\d{8}-\d{6}\.log")
    found = []
    with suppress(OSError):
        for p in path.parent.glob("*.log"):
            if p != path:
                begin = _first(p)
                if (ours := _is_of(begin, layout, shown)) or (not begin and named.fullmatch(p.name)):
                    found.append((_ended_ms(p), p.name, p, ours))
    return [(p, ours) for _, _, p, ours in sorted(found, reverse=True)]


def _is_of(begin: Mapping[str, Any], layout: str, shown: object) -> bool:
    """Whether a record that begins so is one of a panel of this layout."""
    return "views" in begin and (begin.get("layout") == layout or begin["views"] == shown)


def _first(path: Path) -> Mapping[str, Any]:
    """The first event of a record; empty where it is none."""
    try:
        with path.open("rb") as f:
            return _event(f.readline(LONGEST))
    except OSError:
        return {}


def _ended_ms(path: Path) -> int:
    """When the last event was written; where that cannot be read, when the file was, rather later than sooner: the
    system's times of files are behind its clock."""
    last = b""
    with suppress(OSError), path.open("rb") as f:
        size = f.seek(0, 2)
        f.seek(max(0, size - TAIL))
        last = f.read().rpartition(b"\n")[0].rpartition(b"\n")[2]
    t = _event(last).get("t")
    return t if isinstance(t, int) else path.stat().st_mtime_ns // 1_000_000 + 1000


def _event(line: bytes) -> Mapping[str, Any]:
    try:
        event = json.loads(line)
    except (ValueError, RecursionError):
        return {}
    return event if isinstance(event, dict) else {}


def told(section: str, log: str) -> str:
    """The alarm of something that is left."""
    if not section:
        return f"{log} cannot be read to its end: what was blocked then is not known, and is not blocked now"
    return f"section {section} was blocked when {log} ended, and is not blocked now: block it again"
