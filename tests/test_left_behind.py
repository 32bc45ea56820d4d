"""What lets go of a section from which a movement has gone: what runtime, panel and service say of it, and how long.

Behind a closely followed train the delay of approach locking; after a section that read occupied for a moment behind an
open signal the release by hand (R8, R9).
"""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import pytest

from interlock.app.reasons import Moment, Reasons
from interlock.emit.python.runtime import runtime_py
from interlock.field.plc import Memory
from interlock.logic.lower import lower
from tests.layouts import grown

PAGE = Path("interlock/docs/rules/R9.md").read_text("utf-8")
STATION = PAGE[PAGE.index("```yaml\n") + 8 : PAGE.index("```\n", PAGE.index("```yaml"))]
"""A passing loop: X2 leads over the points in q2 into q3 or q4; a train has 180 s to come to a stand."""

LINE = """
interlock: 1
name: line
boundaries: {W: {approach: wa 600, trains: in}, E: {trains: out}}
tracks: {line: [W, q1 400, E]}
signals: {X: {from: W, into: q1}}
"""
LOCKED = "section q2 is locked for a train that has passed its signal"


class Desk:
    """The runtime of a layout, a scan a second, its points as they are driven, and what is told of it."""

    def __init__(self, text: str) -> None:
        made = grown(text)
        assert made is not None and not made[2].has_errors
        layout, table, _ = made
        controller = lower(layout, table)
        self.reasons, self.number = Reasons(layout, controller), {str(r.id): r.number for r in table.routes}
        names: dict[str, Any] = {}
        exec(runtime_py(controller, []), names)
        self.runtime = names["Controller"]()
        self.inputs = {n: int(n.startswith(("CLR_", "VALID"))) for n in names["INPUTS"]}
        self.lies = {n.split("_", 1)[1]: "N" for n in names["INPUTS"] if n.startswith("DN_")}
        self.scans(700)
        self.scan(RELALL=1)
        self.scan(RELALL=0)

    def scan(self, **read: int) -> None:
        """One scan with inputs that change, and stay so."""
        self.inputs |= read
        contacts = {f"D{x}_{m}": int(self.lies[m] == x) for x in "NR" for m in self.lies}
        out = self.runtime.scan({**self.inputs, **contacts}, 1000)
        self.lies |= {m: x for m in self.lies for x in "NR" if out[f"Y{x}_{m}"]}

    def scans(self, count: int) -> None:
        for _ in range(count):
            self.scan()

    def set(self, route: str) -> None:
        """Sets a route, whose signal opens."""
        self.scan(REQ=self.number[route])
        self.scan(REQ=0)
        self.scans(3)
        assert self.runtime.status(route)[1] == "open"

    def runs(self, *sections: str) -> None:
        """What came into one section after the other, and has left the one before."""
        for left, into in zip(("", *sections), sections, strict=False):
            self.scan(**{f"CLR_{into}": 0})
            self.scan(**({f"CLR_{left}": 1} if left else {}))

    def told(self, route: str) -> list[str]:
        """What panel and service say."""
        moment = Moment(self.runtime._last[2], Memory(*self.runtime._last[:2]), 1000)
        return [r.text for r in self.reasons.of_request(self.number[route], moment, self.runtime.why_not(route)[0])]


def followed() -> Desk:
    """A train has gone over q2 into q3, and another one stands in q1 all the time."""
    desk = Desk(STATION)
    desk.scan(CLR_q1=0)
    desk.set("X2-X3")
    desk.runs("q2", "q3")
    return desk


def test_behind_a_train_that_is_followed_closely_the_delay_is_counted_down() -> None:
    desk, left = followed(), []
    desk.scans(4)
    for _ in range(400):
        if desk.runtime.why_not("X2-X4") is None:
            break
        left.append(desk.runtime.countdown_ms("X2-X4"))
        seconds = left[-1] // 1000
        why = f"no other train can be on its way to X2: {seconds} s to go"
        code, sentence, rule = desk.runtime.why_not("X2-X4")
        assert sentence == f"section q2 is locked from q1 to q3 for route X2-X3: it is released when {why}"
        assert rule == "R6" and desk.runtime.status("X2-X4") == (code, sentence)
        (about,) = {t for t in desk.told("X2-X4") if t.startswith(LOCKED)}
        seen = re.fullmatch(
            rf"{LOCKED}: it is released when no other train can be on its way to X2: (\d+) s to go", about
        )
        assert seen is not None and int(seen[1]) in (seconds, seconds + 1), (about, seconds)
        desk.scan()
    assert left[0] > 170_000 and left == [*range(left[0], -1, -1000)], left


def test_of_a_section_that_is_not_clear_yet_nothing_is_counted() -> None:
    """The train is in q2 and q3: its delay runs, and q2 is not released at its end."""
    desk = Desk(STATION)
    desk.scan(CLR_q1=0)
    desk.set("X2-X3")
    desk.scan(CLR_q2=0)
    desk.scan(CLR_q3=0)
    desk.scans(9)
    assert desk.runtime.countdown_ms("X2-X4") is None and "released" not in desk.runtime.why_not("X2-X4")[1]
    assert not any("s to go" in text or "released" in text for text in desk.told("X2-X4"))


def flickered() -> Desk:
    """q2 has read occupied for a moment behind the open signal, while a train stood before it."""
    desk = Desk(STATION)
    desk.scan(CLR_q1=0)
    desk.set("X2-X3")
    desk.scan(CLR_q2=0)
    desk.scan(CLR_q2=1)
    return desk


@pytest.mark.parametrize("route", ["X2-X3", "X2-X4"])
def test_a_section_from_which_nothing_was_seen_to_go_on_says_how_and_when_it_is_released(route: str) -> None:
    desk = flickered()
    desk.scans(20)
    assert desk.runtime.countdown_ms(route) is None, "nothing lets go of it by itself"
    _, sentence, _ = desk.runtime.why_not(route)
    seen = re.fullmatch(r"(.*X2-X3): nothing was seen to go on from there; hold REL_q2, for (\d+) s or more", sentence)
    assert seen is not None and 150 < int(seen[2]) < 165, sentence
    told = desk.told(route)[0]
    remedy = "nothing was seen to go on from there; release section q2 by hand"
    assert re.fullmatch(rf"{LOCKED}: {remedy}: \d+ s to go, as a train may be on its way to X2", told), told
    desk.scans(300)
    _, sentence, _ = desk.runtime.why_not(route)
    assert sentence.endswith("X2-X3: nothing was seen to go on from there; hold REL_q2 until it is released")
    assert desk.told(route)[0] == f"{LOCKED}: {remedy}"
    desk.scan(REL_q2=1)
    desk.scans(2)
    assert desk.runtime.why_not(route) is None


def test_where_the_delay_begins_with_the_release_it_is_told_before() -> None:
    """The approach was read clear meanwhile, so that nothing is counted, and another train has come since."""
    desk = flickered()
    desk.scan(CLR_q1=1)
    desk.scans(9)
    desk.scan(CLR_q1=0)
    desk.scans(9)
    assert desk.runtime._last[0]["RC_q2"]
    hold = "hold REL_q2 until it is released (180 s while a train may be on its way to X2)"
    assert desk.runtime.why_not("X2-X4")[1].endswith(f": nothing was seen to go on from there; {hold}")
    assert desk.told("X2-X4")[0].endswith(
        "release section q2 by hand: it takes 180 s, as a train may be on its way to X2"
    )
    desk.scan(REL_q2=1)
    desk.scans(9)
    seen = re.search(r"by hand: (\d+) s to go, as", desk.told("X2-X4")[0])
    assert seen is not None and 165 < int(seen[1]) < 175
    assert f"hold REL_q2, for {int(seen[1]) - 1} s or more" in desk.runtime.why_not("X2-X4")[1], "one scan later"
    desk.scans(int(seen[1]) + 2)
    assert desk.runtime.why_not("X2-X4") is None


def test_a_section_beyond_says_which_one_in_rear_is_released_first() -> None:
    desk = flickered()
    desk.scans(20)
    q3 = [text for text in desk.told("X2-X3") if text.startswith("section q3 is locked")]
    assert q3 == ["section q3 is locked for a train that has passed its signal: q2 in rear is released first"]


def test_at_a_boundary_a_section_is_released_after_the_delay_though_nothing_is_seen_beyond() -> None:
    desk = Desk(LINE)
    desk.scan(CLR_wa=0)
    desk.set("X-E")
    desk.scan(CLR_q1=0)
    desk.scan(CLR_q1=1)
    desk.scans(5)
    left = desk.runtime.countdown_ms("X-E")
    assert left is not None and left > 100_000
    assert "it is released when no other train can be on its way to X:" in desk.told("X-E")[0]
    desk.scans(left // 1000 + 2)
    assert desk.runtime.why_not("X-E") is None


def test_of_a_route_that_is_set_or_cancelled_nothing_else_is_told_than_before() -> None:
    desk = Desk(STATION)
    desk.scan(CLR_q1=0)
    desk.set("X2-X3")
    said = "section q2 is locked from q1 to q3 for route X2-X3"
    assert desk.runtime.why_not("X2-X4")[1] == said and desk.runtime.countdown_ms("X2-X4") is None
    desk.scan(CAN_X2=1)
    desk.scan(CAN_X2=0)
    desk.scans(5)
    assert desk.runtime.why_not("X2-X4")[1] == said
    assert desk.told("X2-X4")[0] == "section q2 is locked for route X2-X3"
