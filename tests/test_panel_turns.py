"""Whose turn it is between two cycles: to stop waits for nobody, and whoever only looks holds nothing up."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from interlock.app.run import LATE_S, Ready
from interlock.panel.desk import Desk
from interlock.panel.operating import Person
from interlock.panel.turns import ORDERS_S, STOPPED, TOO_MUCH, Turns
from tests.panels import in_cycles, unproved

ANN, EVE = Person("Ann", True), Person("Eve", False)
WHY = {"do": "why", "route": "r"}


class Time:
    """A clock that stands still but for what is done."""

    now = 0.0


@pytest.fixture
def time() -> Time:
    return Time()


@pytest.fixture
def turns(time: Time) -> Turns:
    return Turns(0.01, lambda: time.now)


def due(turns: Turns, time: Time, seconds: float = 0.0) -> list[Any]:
    """What is done in a cycle, each in so many seconds."""
    found = []
    for x in turns.due():
        time.now += seconds
        found.append((x.command["do"], x.why_not) if x.why_not else x.command["do"])
    return found


def put(turns: Turns, who: Person, *commands: dict[str, Any]) -> None:
    for c in commands:
        turns.put(who, c, lambda answer: None)


def test_to_stop_comes_first_and_what_came_before_it_is_not_done(turns: Turns, time: Time) -> None:
    put(turns, EVE, *[WHY] * 3, {"do": "stop"})
    put(turns, ANN, WHY, {"do": "set"}, {"do": "block", "on": True}, {"do": "block", "on": False}, {"do": "cancel"})
    put(turns, ANN, {"do": "stop"}, {"do": "set"})
    asked = ["stop", ("set", STOPPED), "block", ("block", STOPPED), "cancel", "set"]
    assert due(turns, time) == [*asked, "why", "why", "why", "why", "stop"] and due(turns, time) == []


def test_who_looks_has_a_part_of_the_cycle_and_no_more(turns: Turns, time: Time) -> None:
    """Sixty browsers asked fifty times each why a signal is at stop: a cycle took a second, and so did to stop."""
    put(turns, EVE, *[WHY] * 1000)
    put(turns, ANN, WHY, {"do": "stop"})
    assert due(turns, time, 0.004) == ["stop", "why", "why", "why", "why"]
    assert due(turns, time, 1.0) == ["why"], "one in each cycle, however long it takes"
    assert due(turns, time, 0.0) == ["why"] * 996


def test_too_much_at_once_is_refused_but_to_stop_to_cancel_and_to_block(turns: Turns, time: Time) -> None:
    put(turns, ANN, *[{"do": "set"}] * 5, {"do": "cancel"}, {"do": "block", "on": True}, {"do": "set"})
    assert due(turns, time, ORDERS_S / 2) == [
        *["set"] * 3,
        *[("set", TOO_MUCH)] * 2,
        "cancel",
        "block",
        ("set", TOO_MUCH),
    ]


def test_whatever_is_asked_is_a_turn(turns: Turns, time: Time) -> None:
    put(turns, ANN, {"do": ["stop"]}, {"do": " stop "}, {"do": {"a": 1}})
    assert due(turns, time) == [" stop ", (["stop"], STOPPED), {"a": 1}]


def test_what_waits_too_long_for_its_turn_is_late(monkeypatch: pytest.MonkeyPatch) -> None:
    """A request over Modbus says nothing of when it was made: it is as old as it has waited here."""
    desk, answers = Desk(unproved(Path("layouts/passing_loop.yaml").read_text("utf-8"))), list[dict[str, Any]]()
    for command in ({"do": "set", "route": "X-S1"}, {"do": "block", "section": "IG", "on": True}):
        desk.ask(ANN, command, answers.append)
    since = desk._turns._now
    monkeypatch.setattr("interlock.panel.desk.since_boot", lambda: since() + LATE_S + 1)
    desk._commands()
    assert answers[0]["why"][0][0] == "it was asked for 6 s ago, and is not done now: ask again" and answers[1]["ok"]


@pytest.fixture(scope="module")
def loop() -> Ready:
    return unproved(Path("layouts/passing_loop.yaml").read_text("utf-8"))


def test_what_is_cancelled_before_it_was_made_is_not_made(loop: Ready) -> None:
    """No route was set from the signal yet: to cancel was refused, and the signal opened when its turn came."""
    desk = Desk(loop)
    routes = list(desk.operating.buttons.routes.values())
    a = next(r for r in routes if str(r.entry) == "X")
    b = next(r for r in routes if str(r.entry) == "S")
    start = loop.layout.principles.restart_delay_s if loop.layout else 0.0
    at = round(start * 10) + 30
    script = {
        at: [("Ann", {"do": "release all"})],
        at + 20: [
            ("Ann", {"do": "set", "route": str(a.id)}),
            ("Bob", {"do": "set", "route": str(b.id)}),
            ("Cid", {"do": "cancel", "signal": str(b.entry)}),
        ],
    }
    answers = in_cycles(desk, at + 80, script)
    assert [(who, told["ok"]) for who, told in answers] == [("Ann", True), ("Ann", True), ("Bob", True), ("Cid", True)]
    told = [e for e in (*desk.browsers.events, *desk.browsers._fresh) if e.kind in ("refusal", "operation")]
    assert [(e.text, e.who) for e in told if str(b.id) in e.text] == [(f"route {b.id} is refused", "Bob")]
    (why,) = [e.reasons[0].text for e in told if e.kind == "refusal"]
    assert why == f"signal {b.entry} was cancelled after it"
    assert [(e.text, e.who) for e in told if str(a.id) in e.text] == [(f"route {a.id} is set", "Ann")]
    assert (f"cancel at {b.entry}, where none is set yet", "Cid") in [(e.text, e.who) for e in told]
