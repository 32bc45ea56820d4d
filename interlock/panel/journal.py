"""What a panel's record tells afterwards: the page of a shift for printing, and any span of it for the player."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from datetime import datetime, timedelta
from itertools import accumulate, groupby, pairwise
from typing import Any

from jinja2 import Environment, PackageLoader, select_autoescape

from interlock.record.log import END, Event, Recorded

PICTURE = "picture"
"""The kind of an event that tells a change of what the player shows."""

BEGIN = "begin"
"""The kind of the event with which a panel begins a record, or goes on with one."""

GAP = "gap"
"""The kind of the event with which a record goes on where it could not be written."""

SET_BACK_S = 1
"""Seconds by which the clock may be corrected without a word (our choice)."""

TOGETHER_MS = 2000
"""Milliseconds within which what is said and the change of the plan that follows are one step (our choice)."""

MOST = 2000
"""States that a page of the player shows at most."""

TOLD = ("operation", "refusal", "release", "alarm", "acknowledged", "cleared", "note", GAP, BEGIN, END)


class NotAPanels(Exception):
    """The log is none of a panel, or has nothing in the span; the message says why."""


def clock(t_ms: int, zoned: bool = False) -> str:
    """Date and time of an event in the zone of this computer; `zoned`: with how far that is from UTC then."""
    time = datetime.fromtimestamp(t_ms / 1000).astimezone()
    return time.strftime("%Y-%m-%d %H:%M:%S") + (f" {_zone(t_ms)}" if zoned else "")


def _zone(t_ms: int) -> str:
    """How far this computer's clock is from UTC at a time, which changes with summer time."""
    return datetime.fromtimestamp(t_ms / 1000).astimezone().isoformat()[-6:]


def _zones(events: Iterable[Event]) -> list[str]:
    """All of these that there are, in their order."""
    return list(dict.fromkeys(_zone(e["t"]) for e in events))


def at(text: str, events: Sequence[Event], ends: bool = False, after: int = 0) -> int:
    """Milliseconds of a time given as HH:MM, HH:MM:SS (on the day of the log's first event, or on the next one where
    only that lies in the log, and not before `after`) or whole.  Where the clock shows it twice, when summer time ends,
    the first, or with `ends` the second.

    Raises `ValueError`.
    """
    day = datetime.fromtimestamp(events[0]["t"] / 1000)
    first, last = _whole(events)
    for form in ("%H:%M", "%H:%M:%S"):
        try:
            given = datetime.strptime(text, form)
        except ValueError:
            continue
        moment = day.replace(hour=given.hour, minute=given.minute, second=given.second, microsecond=0)
        then, next_day = (_moment(m, ends) for m in (moment, moment + timedelta(days=1)))
        other = then < max(first, after) <= next_day and (next_day <= last or (ends and then < min(first, after)))
        return next_day if other else then
    return _moment(datetime.fromisoformat(text), ends)


def _moment(time: datetime, ends: bool) -> int:
    """Milliseconds of a time; one without a zone is of this computer's clock, which shows it once, twice or never."""
    if time.tzinfo is not None:
        return round(time.timestamp() * 1000)
    both = [round(time.replace(fold=fold).timestamp() * 1000) for fold in (0, 1)]
    return max(both) if ends else min(both)


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
    if not events or events[0]["kind"] != BEGIN or "views" not in events[0]:
        raise NotAPanels("this is no record of a panel")
    for line, e in enumerate(events, 1):
        if wrong := next((k for k, fits in _fields(e, first=line == 1) if not fits), ""):
            raise NotAPanels(f"line {line}: `{wrong}` is missing, or not as a panel writes it")
    begins, ends = _whole(events)
    try:
        since = at(first, events) if first else begins
        until = at(last, events, ends=True, after=since) if last else ends
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
    elif e["kind"] == BEGIN and "views" in e:
        yield from (("plan", "plan" in e), ("views", isinstance(e["views"], dict)))
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
        yield from ((k, type(e.get(k, 0)) is int) for k in ("dropped", "releases"))


def _texts(x: object) -> bool:
    return isinstance(x, list) and all(isinstance(text, str) for text in x)


def trace(found: Recorded, first: str = "", last: str = "") -> str:
    """A span of the record as an ITF trace.  Raises `NotAPanels`."""
    _, start, end = span(found, first, last)
    begin = {**found.events[0], **_in_force(found.events, start, end)}
    on: set[str] = set()
    said: list[tuple[int, str]] = []
    states: list[tuple[str, frozenset[str]]] = []
    seen = False  # a picture, without which nothing is known
    zoned = len(_zones(e for e in found.events if start <= e["t"] <= end)) > 1
    for before, e in pairwise((found.events[0], *found.events)):
        inside = start <= e["t"] <= end
        if inside and (jump := _set_back(before, e)):
            said.append((e["t"], jump))
        if e["kind"] == PICTURE:
            earlier = [x for x in said if not inside or e["t"] - x[0] > TOGETHER_MS]
            if seen and earlier:  # when the plan was still another
                states.append((_told(earlier, zoned), frozenset(on)))
                said = [x for x in said if x not in earlier]
            on, seen = set(e["on"]) if e["whole"] else (on | set(e["on"])) - set(e["off"]), True
            if inside:
                if not said or clock(said[-1][0]) != clock(e["t"]):
                    said.append((e["t"], "the plan changes"))
                states.append((_told(said, zoned), frozenset(on)))
                said.clear()
        elif inside and e["kind"] in TOLD:
            said.append((e["t"], _sentence(e)))
    if said:
        states.append((_told(said, zoned), frozenset(on)))
    if not states:
        raise NotAPanels("nothing is recorded in that time")
    if len(states) > MOST:
        raise NotAPanels(f"{len(states)} changes are recorded in that time, {MOST} can be played: take a shorter one")
    names = sorted(begin["views"])
    body = {
        "#meta": {
            "format": "ITF",
            "title": f"{begin['title']}: the panel's record, {clock(start, True)} to {clock(end, True)}",
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


def _in_force(events: Sequence[Event], start: int, end: int) -> Event:
    """The event that says what each variable of a span shows: another version of the program may have gone on with a
    record, and called them otherwise.  Raises `NotAPanels` where that was within the span."""
    found = events[0]
    for e in events:
        if e["kind"] == BEGIN and "views" in e and e["t"] <= end and e["views"] != found["views"]:
            if e["t"] > start:
                why = f"from {clock(e['t'], True)} on another version of the program writes it"
                raise NotAPanels(f"{why}, with other variables: play the time before and the time after by themselves")
            found = e
    return found


def _told(said: Sequence[tuple[int, str]], zoned: bool) -> str:
    """Sentences, each with its time, those of one second after one time."""
    timed = groupby(said, key=lambda x: clock(x[0], zoned)[11:])
    return "; ".join(f"{time}  {'; '.join(text for _, text in those)}" for time, those in timed)


def _sentence(e: Event) -> str:
    reasons = ", ".join(text for text, _ in e.get("reasons", ()))
    who = f"{e['who']}: " if e.get("who") else ""
    return f"{who}{e.get('text', e['kind'])}{f' ({reasons})' if reasons else ''}"


def _with_rules(e: Event) -> list[str]:
    """The reasons of an event, each with its rule where one is named."""
    rules = [*e.get("rules", ()), *[""] * len(e.get("reasons", ()))]
    return [f"{r[0]} ({rule})" if rule else r[0] for r, rule in zip(e.get("reasons", ()), rules, strict=False)]


def released(e: Event) -> int:
    """Releases by hand that an event tells of: its own, or those among the events that were dropped."""
    return int(e.get("releases", 0)) if e["kind"] == GAP else int(e["kind"] == "release")


def _text(e: Event) -> str:
    """What an event says on the page of a shift."""
    text = e.get("text") or {BEGIN: "the panel begins", END: "the panel ends"}.get(e["kind"], e["kind"])
    if not e.get("dropped"):
        return str(text)
    by_hand = f", {released(e)} of them releases by hand" if released(e) else ""
    return f"{text}; {e['dropped']} events were dropped{by_hand}"


def _unended(events: Sequence[Event]) -> int:
    """Sessions that broke off: another one began, or the log ends, without the event that ends them."""
    after = [e["kind"] for e in events[1:]] + [BEGIN]
    return sum(b == BEGIN and a["kind"] != END for a, b in zip(events, after, strict=True))


def page(found: Recorded, first: str = "", last: str = "") -> str:
    """The page of a shift: what was done, refused, released by hand and alarmed.  Raises `NotAPanels`."""
    begin, start, end = span(found, first, last)
    told: list[Event] = []
    for before, e in pairwise((found.events[0], *found.events)):
        if jump := _set_back(before, e):
            told.append({"kind": GAP, "t": e["t"], "text": jump})
        if e["kind"] in TOLD:
            told.append(e)
    numbers = list(accumulate(released(e) for e in told))
    inside = [(n, e) for n, e in zip(numbers, told, strict=True) if start <= e["t"] <= end]
    zoned = len(_zones(e for _, e in inside)) > 1
    rows = [
        {
            "time": clock(e["t"], zoned),
            "kind": e["kind"],
            "who": e.get("who", ""),
            "text": _text(e),
            "reasons": _with_rules(e),
        }
        for _, e in inside
    ]
    begins = [e for e in found.events if e["kind"] == BEGIN]
    kinds = Counter(e["kind"] for _, e in inside)
    people = Counter(e["who"] for _, e in inside if e["kind"] == "release")
    environment = Environment(
        loader=PackageLoader("interlock.panel", "."), autoescape=select_autoescape(default=True), trim_blocks=True
    )
    body: dict[str, Any] = {
        "title": begin["title"],
        "start": clock(start, True),
        "end": clock(end, True),
        "rows": rows,
        "kinds": kinds,
        "people": sorted(people.items()),
        "counter": (numbers[-1] if numbers else 0),
        "before": inside[0][0] - released(inside[0][1]) if inside else 0,
        "after": inside[-1][0] if inside else 0,
        "chain": found.chain.digest,
        "events": found.chain.number,
        "ended": found.ended,
        "sessions": len(begins),
        "unended": _unended(found.events),
        "digest": begin["digest"],
        "program": ", ".join(dict.fromkeys(str(e.get("program", "")) for e in begins)),
    }
    return environment.get_template("journal.html.j2").render(**body)
