"""What the panel's page says: of what was asked, of old news, and of what is to be done after a restart."""

from __future__ import annotations

import time
from pathlib import Path
from typing import Any

import pytest

from tests.pages import (
    TAPPED,
    asked,
    closing_pages,
    fresh,
    is_,
    opened,
    press,
    refused,
    serving,
)
from tests.panels import quick, unproved

pytestmark = pytest.mark.external


def test_what_was_asked_and_what_is_said_of_it(chromium: Any, tmp_path: Path) -> None:
    """One page, whose messages are held back or made up: requests without an answer, reasons that are past."""
    with serving(unproved(quick(tmp_path).read_text("utf-8"))) as (desk, url), closing_pages(chromium) as b:
        page, wrong = opened(b, url, TAPPED)
        press(page, "Release all clear sections")
        page.wait_for_selector("#restart", state="hidden")
        fresh(page)
        page.evaluate("window.mute = true")

        def stop() -> tuple[float, float]:
            before = time.time()
            page.locator("#stop").click()
            return before, time.time()

        before, after = asked(page, stop)
        told = page.evaluate("sent.at(-1)")
        when = told["heard"] + told["after"] / 1000
        assert told["do"] == "stop" and before - 1 < when < after + 1, "when it was clicked"
        page.wait_for_selector("#grey:text-matches('Sent [1-9][0-9]* s ago, no answer yet')")
        page.evaluate("window.away = true, socket.close()")
        page.wait_for_selector("#said:has-text('not known whether it was done: look at the plan')")
        count = page.evaluate("window.mute = false, sent.length")
        page.evaluate("document.getElementById('stop').click()")
        page.wait_for_selector("#said:has-text('nothing was sent')")
        assert page.evaluate("unsent") > 0, "by this the tests ask again"
        page.evaluate("new Promise(done => setTimeout(done, 300))")
        assert "nothing was sent" in page.inner_text("#said"), "until news come again"
        assert page.evaluate(f"sent.slice({count}).filter(m => m.do)") == []
        page.evaluate("window.away = false")
        fresh(page)
        page.wait_for_selector("#grey:empty", state="attached")
        page.wait_for_selector("#said:empty", state="attached")  # what was not sent is past when news come again
        event = """(e, c = {}) => tell({c, events: [{n: 9, time: "2026-01-31T06:00:00", rules: [], at: [], ...e}]})"""
        mine = page.evaluate("sent.find(m => 'name' in m).name")
        assert mine.startswith("operator ") and page.get_attribute("#name", "placeholder") == mine
        why = [["points P1 cannot move: section s3 is locked", ["s:s3"]]]
        for kind, who, seen in (("refusal", "operator", False), ("refusal", "x", False), ("refusal", mine, True),
                                ("operation", mine, True), ("operation", "x", False)):  # fmt: skip
            page.keyboard.press("Escape")
            page.evaluate(f"e => ({event})(e)", {"kind": kind, "who": who, "text": "XB-XC1: so", "reasons": why})
            assert ("P1 cannot move" in page.inner_text("#said")) == seen, "what is said to another is not said here"
        page.keyboard.press("Escape")
        page.evaluate(f"e => ({event})(e)", {"kind": "refusal", "who": mine, "text": "XB-XC1: so", "reasons": why})
        waiting = [0, [], 0, 0, 0, 5, 0, 0, []]
        page.evaluate("v => tell({c: {'s:s3': v, 's:s9': [1, [], 0, 0, 0, null, 0, 0]}})", waiting)
        page.evaluate("new Promise(done => setTimeout(done, 300))")  # by its own clock, which counts what is past
        assert page.locator("#said.past").count() == 0 and page.locator("#plan .shown").count() > 0
        page.evaluate("tell({c: {'s:s3': [1, [], 0, 0, 0, null, 0, 0]}})")
        page.wait_for_selector("#said.past")
        assert page.locator("#plan .shown").count() == 0
        page.evaluate("tell({c: {'s:s3': [0, [], 0, 0, 0, null, 0, 0], 's:s9': [0, [], 0, 0, 0, null, 0, 0]}})")
        desk.power = False
        is_(page, "#power", "bad")
        refused(page, "signal-XB", "buffer-XC1", "the controller has no power")
        desk.power = True
        page.wait_for_selector("#said.past")
        page.fill("#typed", "  ")
        page.press("#typed", "Enter")
        away = [w for w in wrong if "/nowhere" in w]  # one for each time it tried to come back meanwhile
        assert desk.broken == "" and away == wrong


def test_the_box_of_the_restart_asks_for_what_can_be_done_and_no_more(chromium: Any) -> None:
    """On a layout with call-on signals, or a section that has no detection; after a loss of inputs, or without."""
    text = Path("layouts/passing_loop.yaml").read_text("utf-8")
    with serving(unproved(text)) as (_, url), closing_pages(chromium) as b:
        page, wrong = opened(b, url, TAPPED)
        fresh(page)

        def told(valid: bool, **sections: list[Any]) -> str:
            state = {f"s:{s}": v for s, v in sections.items()}
            page.evaluate("([valid, c]) => tell({c, sys: {...SYS, valid, delay: 0}})", [valid, state])
            return str(page.inner_text("#restart")) if page.is_visible("#restart") else ""

        def locked(occupied: int, stale: int) -> list[Any]:
            return [occupied, ["1"], 0, 0, stale, None, 0, 0]

        page.evaluate("window.deaf = true")
        names = page.eval_on_selector_all("#plan g.section[id]:has(.track[id])", "es => es.map(e => e.id.slice(8))")
        assert {"IAG", "IIAG"} <= set(names)
        free: dict[str, list[Any]] = {s: [0, [], 0, 0, 0, None, 0, 0] for s in names}
        assert told(True, **free) == ""
        assert told(True, IAG=locked(1, 2)) == told(True, IAG=locked(0, 2)) == "", "a train is called on over it"
        assert told(True, IAG=free["IAG"]) == ""
        assert "released when clear: IAG." in told(True, IAG=locked(1, 1)), "to a page that came later, too"
        assert told(True, IAG=free["IAG"]) == ""
        assert "do not report" in told(False, IAG=locked(1, 1), IIAG=locked(0, 1)), "inputs were lost"
        box = told(True)
        assert "loss of inputs" in box and "released when clear: IAG." in box and "Release what is clear: IIAG." in box
        assert "IAG" not in told(True, IAG=locked(0, 1)).partition("Release what is clear")[0]
        assert told(True, **free) == ""
        steps = """async restart => (await import('/acts.js')).steps({sections: {wsh: {detected: false}, arr: {}}},
            {'s:wsh': [1, [], 1], 's:arr': [1, [], 1]}, {...SYS, restart})"""
        assert page.evaluate(steps, ["wsh"]) is None, "a section without detection is never released"
        assert "released when clear: arr." in page.evaluate(steps, ["arr", "wsh"])[3][1]
        assert wrong == []
