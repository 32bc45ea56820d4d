"""The figures of a shift of ten minutes, event by event: every number can be read off the events below."""

from __future__ import annotations

import csv
from typing import Any

import pytest

from interlock.record.report import share
from interlock.record.shift import Figures, clock, figures, to_csv

PLACES = {"c1": {"kind": "loading", "capacity": 2}, "tip": {"kind": "tipping", "capacity": 1}}
BEGIN = {"kind": "begin", "what": "shift", "t": 0, "layout": "demo", "layout_digest": "d", "seed": 1, "metres": {}}
BEGIN |= {"fleet": {"1": {}, "2": {}}, "places": PLACES, "orders": {"a": {"trains": 3}}, "main": []}


def _at(seconds: int, kind: str, **more: Any) -> dict[str, Any]:
    return {"t": 1000 * seconds, "kind": kind, **more}


TIPPED = {"place": "tip", "order": "a", "ore": "iron", "tonnes": 40.0}
EVENTS = [
    BEGIN,
    _at(0, "runs", train="1"),
    _at(60, "loads", train="1", place="c1"),
    _at(180, "loaded", train="1", place="c1"),
    _at(200, "waits", train="1", cause="refused"),
    _at(230, "waits", train="1", cause="zone"),
    _at(260, "granted", train="1"),
    _at(260, "runs", train="1"),
    _at(300, "leaves", train="1"),
    _at(310, "tips", train="1", place="tip"),
    _at(370, "tipped", train="1", **TIPPED),
    _at(400, "alarm", text="points 3 are not detected"),
    _at(410, "fault", text="a contact of points 3"),
    _at(420, "hazard", text="trains 1 and 2 collide"),
    _at(500, "loads", train="2", place="c1"),
    _at(550, "standstill", waiting={}),
    _at(600, "end", held_back=4),
]


@pytest.fixture
def shift() -> Figures:
    return figures(EVENTS)


def test_what_is_no_work_and_not_outside_is_waiting(shift: Figures) -> None:
    """Train 1 stands for 20 s after it was loaded, waits for 30 s each, for the tippler 10 s; train 2 stands 500 s."""
    assert shift.seconds == 600
    assert shift.waiting == {"stands": 520, "refused": 30, "zone": 30, "waits for the tippler": 10}
    assert shift.states["1"]["outside"] == 230 and shift.states["1"]["runs"] == 100
    assert share(shift, "1", "waits") == pytest.approx(90 / 600) and share(shift, "2", "waits") == pytest.approx(5 / 6)


def test_a_place_is_used_by_as_many_as_it_has_room_for_and_until_the_end(shift: Figures) -> None:
    """At c1 there is room for two trains; train 2 is loaded there when the shift ends."""
    assert shift.utilisation("c1") == pytest.approx((120 + 100) / (2 * 600))
    assert shift.utilisation("tip") == pytest.approx(60 / 600)


def test_what_happened_is_counted_and_dated_in_seconds(shift: Figures) -> None:
    assert shift.alarms == [(400, "points 3 are not detected")] and shift.faults == [(410, "a contact of points 3")]
    assert shift.hazards == ["trains 1 and 2 collide"]
    assert (shift.requests.granted, shift.requests.refused, shift.requests.held_back) == (1, 1, 4)
    assert shift.standstill == [(550, "nothing is told of why")], "all stood, whatever is known of it"
    assert shift.tonnes == {"iron": 40} and shift.trains == {"a": 1}
    told = {(x["figure"], x["of"]): x["value"] for x in csv.DictReader(to_csv(shift).splitlines())}
    assert [told[k, ""] for k in ("alarms", "faults", "hazards", "standstills")] == ["1"] * 4
    assert told["trains ordered", "a"] == "3" and told["trains tipped", "a"] == "1"


def test_a_clock_runs_on_after_a_day() -> None:
    assert [clock(s) for s in (0, 59.6, 3661, 90061)] == ["0:00:00", "0:01:00", "1:01:01", "25:01:01"]
