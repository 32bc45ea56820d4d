"""What a panel's record tells afterwards: the page of a shift for printing, and any span of it for the player."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Iterator, Sequence
from datetime import datetime, timedelta
from itertools import accumulate, groupby, pairwise
from typing import Any

from jinja2 import Environment, PackageLoader, select_autoescape

from interlock.record.log import END, Event, Recorded

PICTURE = "picture"
"""The kind of an event that tells a change of what the player shows."""

SET_BACK_S = 1
"""Seconds by which the clock may be corrected without a word (our choice)."""

TOGETHER_MS = 2000
"""Milliseconds within which what is said and the change of the plan that follows are one step (our choice)."""

MOST = 2000
"""States that a page of the player shows at most."""

TOLD = ("operation", "refusal", "release", "alarm", "acknowledged", "cleared", "note", "gap", "begin", END)


class NotAPanels(Exception):
    """The log is none of a panel, or has nothing in the span; the message says why."""


def clock(t_ms: int) -> str:
    """Date and time of an event on this computer's clock."""
    return datetime.fromtimestamp(t_ms / 1000).astimezone().strftime("%Y-%m-%d %H:%M:%S")


def at(text: str, events: Sequence[Event]) -> int:
    """Milliseconds of a time given as HH:MM, HH:MM:SS (on the day of the log's first event, or on the next one where
    only that lies in the log) or whole.

    Raises `ValueError`.
    """
    day = datetime.fromtimestamp(events[0]["t"] / 1000).astimezone()
    first, last = _whole(events)
    for form in ("%H:%M", "%H:%M:%S"):
        try:
            given = datetime.strptime(text, form)
        except ValueError:
            continue
        moment = day.replace(hour=given.hour, minute=given.minute, second=given.second, microsecond=0)
        then, next_day = (round(m.timestamp() * 1000) for m in (moment, moment + timedelta(days=1)))
        return next_day if then < first <= next_day <= last else then
    return round(datetime.fromisoformat(text).astimezone().timestamp() * 1000)


def _whole(events: Sequence[Event]) -> tuple[int, int]:
    """The first and the last time in a log; the clock may have been set back."""
    times = [int(e["t"]) for e in events]
    return min(times), max(times)


def _set_back(before: Event, e: Event) -> str:
    """That the clock was set back between two events; empty where it was not."""
    seconds = round((before["t"] - e["t"]) / 1000)
    return f"the clock of this computer was set back by {seconds} s" if seconds > SET_BACK_S else ""


def span(found: Recorded, first: str, last: str) -> tuple[Event, int, int]:
    """The event that begins a panel's log, and the span in milliseconds.  Raises `NotAPanels`."""
    events = found.events
    if events and events[0].get("what") == "shift":
        raise NotAPanels("this is the record of a simulated shift: name its layout with --layout")
    if not events or events[0]["kind"] != "begin" or "views" not in events[0]:
        raise NotAPanels("this is no record of a panel")
    for line, e in enumerate(events, 1):
        if wrong := next((k for k, fits in _fields(e, first=line == 1) if not fits), ""):
            raise NotAPanels(f"line {line}: `{wrong}` is missing, or not as a panel writes it")
    begins, ends = _whole(events)
    try:
        since, until = at(first, events) if first else begins, at(last, events) if last else ends
    except ValueError:
        raise NotAPanels("write times as HH:MM, HH:MM:SS or 2026-01-31T06:00:00") from None
    if since > until and first and last:
        raise NotAPanels(f"--to {last} is before --from {first}")
    return events[0], since, until


def _fields(e: Event, first: bool) -> Iterator[tuple[str, bool]]:
    """The fields of an event that are read here, and whether each is as a panel writes it: whoever can compute digests
    can write any."""
    if first:
        yield from ((k, isinstance(e.get(k), str)) for k in ("title", "digest", "program"))
        yield from (("plan", "plan" in e), ("views", isinstance(e.get("views"), dict)))
    if e["kind"] == PICTURE:
        yield from (("on", _texts(e.get("on"))), ("off", _texts(e.get("off"))))
        yield "whole", isinstance(e.get("whole"), bool)
    elif e["kind"] in TOLD:
        reasons = e.get("reasons", [])
        told = isinstance(reasons, list) and all(isinstance(r, list) and len(r) == 2 for r in reasons)
        yield "reasons", told and _texts([r[0] for r in reasons])
        yield "rules", _texts(e.get("rules", []))
        yield from ((k, isinstance(e.get(k, ""), str)) for k in ("text", "who"))
        yield "who", e["kind"] != "release" or "who" in e


def _texts(x: object) -> bool:
    return isinstance(x, list) and all(isinstance(text, str) for text in x)


def trace(found: Recorded, first: str = "", last: str = "") -> str:
    """A span of the record as an ITF trace.  Raises `NotAPanels`."""
    begin, start, end = span(found, first, last)
    on: set[str] = set()
    said: list[tuple[int, str]] = []
    states: list[tuple[str, frozenset[str]]] = []
    seen = False  # a picture, without which nothing is known
    for before, e in pairwise((found.events[0], *found.events)):
        inside = start <= e["t"] <= end
        if inside and (jump := _set_back(before, e)):
            said.append((e["t"], jump))
        if e["kind"] == PICTURE:
            earlier = [x for x in said if e["t"] - x[0] > TOGETHER_MS]
            if seen and inside and earlier:  # when the plan was still another
                states.append((_told(earlier), frozenset(on)))
                said = [x for x in said if x not in earlier]
            on, seen = set(e["on"]) if e["whole"] else (on | set(e["on"])) - set(e["off"]), True
            if inside:
                if not said or clock(said[-1][0]) != clock(e["t"]):
                    said.append((e["t"], "the plan changes"))
                states.append((_told(said), frozenset(on)))
                said.clear()
        elif inside and e["kind"] in TOLD:
            said.append((e["t"], _sentence(e)))
    if said:
        states.append((_told(said), frozenset(on)))
    if not states:
        raise NotAPanels("nothing is recorded in that time")
    if len(states) > MOST:
        raise NotAPanels(f"{len(states)} changes are recorded in that time, {MOST} can be played: take a shorter one")
    names = sorted(begin["views"])
    body = {
        "#meta": {
            "format": "ITF",
            "title": f"{begin['title']}: the panel's record, {clock(start)} to {clock(end)}",
            "claim": "",  # nothing is violated
            "occupied": "reported occupied",  # by a train or by nobody: that is not recorded
            "plan": begin["plan"],
            "views": begin["views"],
        },
        "vars": names,
        "states": [
            {"#meta": {"index": k, "text": text}, **{n: n in true for n in names}}
            for k, (text, true) in enumerate(states)
        ],
    }
    return json.dumps(body, ensure_ascii=False) + "\n"


def _told(said: Sequence[tuple[int, str]]) -> str:
    """Sentences, each with its time, those of one second after one time."""
    timed = groupby(said, key=lambda x: clock(x[0])[11:])
    return "; ".join(f"{time}  {'; '.join(text for _, text in those)}" for time, those in timed)


def _sentence(e: Event) -> str:
    reasons = ", ".join(text for text, _ in e.get("reasons", ()))
    who = f"{e['who']}: " if e.get("who") else ""
    return f"{who}{e.get('text', e['kind'])}{f' ({reasons})' if reasons else ''}"


def _with_rules(e: Event) -> list[str]:
    """The reasons of an event, each with its rule where one is named."""
    rules = [*e.get("rules", ()), *[""] * len(e.get("reasons", ()))]
    return [f"{r[0]} ({rule})" if rule else r[0] for r, rule in zip(e.get("reasons", ()), rules, strict=False)]


def page(found: Recorded, first: str = "", last: str = "") -> str:
    """The page of a shift: what was done, refused, released by hand and alarmed.  Raises `NotAPanels`."""
    begin, start, end = span(found, first, last)
    told: list[Event] = []
    for before, e in pairwise((found.events[0], *found.events)):
        if jump := _set_back(before, e):
            told.append({"kind": "gap", "t": e["t"], "text": jump})
        if e["kind"] in TOLD:
            told.append(e)
    numbers = list(accumulate(e["kind"] == "release" for e in told))
    inside = [(n, e) for n, e in zip(numbers, told, strict=True) if start <= e["t"] <= end]
    rows = [
        {
            "time": clock(e["t"]),
            "kind": e["kind"],
            "who": e.get("who", ""),
            "text": e.get("text") or {"begin": "the panel begins", END: "the panel ends"}.get(e["kind"], e["kind"]),
            "reasons": _with_rules(e),
        }
        for _, e in inside
    ]
    kinds = Counter(e["kind"] for _, e in inside)
    people = Counter(e["who"] for _, e in inside if e["kind"] == "release")
    environment = Environment(
        loader=PackageLoader("interlock.panel", "."), autoescape=select_autoescape(default=True), trim_blocks=True
    )
    body: dict[str, Any] = {
        "title": begin["title"],
        "start": clock(start),
        "end": clock(end),
        "rows": rows,
        "kinds": kinds,
        "people": sorted(people.items()),
        "counter": (numbers[-1] if numbers else 0),
        "before": inside[0][0] - (inside[0][1]["kind"] == "release") if inside else 0,
        "chain": found.chain.digest,
        "events": found.chain.number,
        "ended": found.ended,
        "digest": begin["digest"],
        "program": begin["program"],
    }
    return environment.get_template("journal.html.j2").render(**body)
