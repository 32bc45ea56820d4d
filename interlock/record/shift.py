"""What the record of a shift says: trains, tonnes by ore, waiting by cause, utilisation, refusals, alarms.

A train is at any time in one state: it runs, stands (before it is told why), waits for a cause, is loaded, is tipped,
or is outside.  Nothing but the record is read.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import field

from interlock.dataclass import dataclass
from interlock.record.log import Event
from interlock.spreadsheet import csv_text

RUNS, STANDS, LOADS, TIPS, OUTSIDE = "runs", "stands", "is loaded", "is tipped", "outside"

_STATES = {
    "runs": RUNS,
    "stands": STANDS,
    "loads": LOADS,
    "loaded": STANDS,
    "leaves": "waits for the tippler",
    "tips": TIPS,
    "tipped": OUTSIDE,
    "back": STANDS,
}


HEADING = ("layout", "layout_digest", "seed", "fleet", "places", "orders", "metres", "main")
"""What the first event of a shift says that its report needs."""


class NoShift(Exception):
    """The log is no record of a shift."""


@dataclass
class Requests:
    """What became of requests; `held_back`: no plan would have existed after them; told at the end, None before it."""

    granted: int = 0
    held_back: int | None = None
    refused: int = 0


@dataclass
class Figures:
    """A shift in figures; times in seconds.  `states`: by train, how long it was in each state."""

    heading: Event
    seconds: float = 0.0
    trains: dict[str, int] = field(default_factory=dict)
    """Trains tipped, by order."""
    tonnes: dict[str, float] = field(default_factory=dict)
    """By kind of ore."""
    states: dict[str, dict[str, float]] = field(default_factory=dict)
    tipped_by: dict[str, int] = field(default_factory=dict)
    """Trains tipped, by locomotive."""
    places: dict[str, float] = field(default_factory=dict)
    """Seconds for which each place worked."""
    alarms: list[tuple[float, str]] = field(default_factory=list)
    faults: list[tuple[float, str]] = field(default_factory=list)
    requests: Requests = field(default_factory=Requests)
    hazards: list[str] = field(default_factory=list)
    standstill: list[tuple[float, str]] = field(default_factory=list)
    """Why trains stood when all stood for ever; empty where they did not."""

    @property
    def waiting(self) -> dict[str, float]:
        """Seconds of waiting by cause, of all trains, the longest first."""
        found: dict[str, float] = {}
        for of in self.states.values():
            for state, seconds in of.items():
                if state not in (RUNS, LOADS, TIPS, OUTSIDE):
                    found[state] = found.get(state, 0.0) + seconds
        return dict(sorted(found.items(), key=lambda x: (-x[1], x[0])))

    def share(self, train: str, state: str) -> float:
        """The part of the shift for which a train was in a state."""
        return self.states[train].get(state, 0.0) / self.seconds if self.seconds else 0.0

    def utilisation(self, place: str) -> float:
        """The part of the shift for which a place worked, of all that it has room for."""
        room = self.heading["places"][place]["capacity"]
        return self.places.get(place, 0.0) / (self.seconds * room) if self.seconds else 0.0


@contextmanager
def as_written() -> Iterator[None]:
    """What a record lacks that a shift writes, or has otherwise, is told as `NoShift`."""
    try:
        yield
    except (LookupError, TypeError, ValueError, AttributeError, ArithmeticError) as error:
        missing = isinstance(error, KeyError)
        what = f"`{error.args[0]}` is missing" if missing else "a field of an event is not as a shift writes it"
        raise NoShift(f"this log is no record of a shift: {what}") from error


@as_written()
def figures(events: Sequence[Event]) -> Figures:
    """The figures of a record, up to its last event.  Raises `NoShift`."""
    if not events or events[0]["kind"] != "begin" or events[0].get("what") != "shift":
        raise NoShift("this log is no record of a shift; the page of a panel's log: `interlock play LOG --journal`")
    f = Figures({k: events[0][k] for k in HEADING})
    now = dict.fromkeys(f.heading["fleet"], (STANDS, 0))
    f.states = {n: {} for n in now}
    works: dict[str, int] = {}
    for e in events:
        train, kind, t = str(e.get("train")), e["kind"], e["t"]
        if train in now:
            state = e["cause"] if kind == "waits" else _STATES.get(kind)
            if state is not None:
                _add(f, train, now[train], t)
                now[train] = (state, t)
        _count(f, e, works)
    end = events[-1]["t"]
    for train, since in now.items():
        _add(f, train, since, end)
    for e in events:
        if e["kind"] in ("loads", "tips") and e["train"] in works and works[e["train"]] == e["t"]:
            f.places[e["place"]] = f.places.get(e["place"], 0.0) + (end - e["t"]) / 1000
    f.seconds = end / 1000
    return f


def _add(f: Figures, train: str, since: tuple[str, int], t: int) -> None:
    state, began = since
    if t > began:
        f.states[train][state] = f.states[train].get(state, 0.0) + (t - began) / 1000


def _count(f: Figures, e: Event, works: dict[str, int]) -> None:
    kind, t = e["kind"], e["t"]
    if kind in ("loads", "tips"):
        works[e["train"]] = t
    elif kind in ("loaded", "tipped"):
        began = works.pop(e["train"], t)
        f.places[e["place"]] = f.places.get(e["place"], 0.0) + (t - began) / 1000
    if kind == "tipped":
        f.trains[e["order"]] = f.trains.get(e["order"], 0) + 1
        f.tipped_by[e["train"]] = f.tipped_by.get(e["train"], 0) + 1
        ore = e["ore"] or "ore"
        f.tonnes[ore] = f.tonnes.get(ore, 0.0) + e["tonnes"]
    elif kind == "alarm":
        f.alarms.append((t / 1000, e["text"]))
    elif kind == "fault":
        f.faults.append((t / 1000, e["text"]))
    elif kind == "hazard":
        f.hazards.append(e["text"])
    elif kind == "granted":
        f.requests.granted += 1
    elif kind == "waits" and e["cause"] == "refused":
        f.requests.refused += 1
    elif kind == "standstill":
        why = [f"{train}: {text}" for train, text in e["waiting"].items()]
        f.standstill += [(t / 1000, text) for text in why or ["nothing is told of why"]]
    elif kind == "end":
        f.requests.held_back = e["held_back"]


def clock(seconds: float) -> str:
    """h:mm:ss."""
    whole = round(seconds)
    return f"{whole // 3600}:{whole // 60 % 60:02}:{whole % 60:02}"


@as_written()
def to_csv(f: Figures) -> str:
    """All figures, one a line: what, of which, value, unit."""
    rows = list[tuple[object, ...]]()
    rows.append(("figure", "of", "value", "unit"))
    rows.append(("shift", f.heading["layout"], round(f.seconds, 1), "s"))
    rows.append(("seed", f.heading["layout"], f.heading["seed"], ""))
    for order, given in f.heading["orders"].items():
        rows.append(("trains ordered", order, given["trains"], "trains"))
        rows.append(("trains tipped", order, f.trains.get(order, 0), "trains"))
    for ore, tonnes in sorted(f.tonnes.items()):
        rows.append(("tonnes", ore, round(tonnes, 3), "t"))
    for cause, seconds in f.waiting.items():
        rows.append(("waiting", cause, round(seconds, 1), "s"))
    for train, of in f.states.items():
        rows.append(("trains tipped by", train, f.tipped_by.get(train, 0), "trains"))
        for state, seconds in sorted(of.items()):
            rows.append((state, train, round(seconds, 1), "s"))
    for place in f.heading["places"]:
        if f.heading["places"][place]["kind"] in ("loading", "tipping"):
            rows.append(("utilisation", place, round(f.utilisation(place), 4), "part of the shift"))
    for name, value in (("requests granted", f.requests.granted), ("requests held back", f.requests.held_back),
                        ("requests refused", f.requests.refused), ("alarms", len(f.alarms)), ("faults", len(f.faults)),
                        ("hazards", len(f.hazards)), ("standstills", int(bool(f.standstill)))):  # fmt: skip
        rows.append((name, "", value, ""))
    return csv_text(rows)
