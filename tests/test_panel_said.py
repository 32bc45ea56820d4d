"""What the panel's page says: of what was asked, of old news, and of what is to be done after a restart."""

from __future__ import annotations

import time
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from interlock.panel import browsers
from interlock.panel.desk import Desk
from tests.pages import (
    TAPPED,
    asked,
    between,
    click,
    closing_pages,
    fresh,
    is_,
    opened,
    refused,
    release_all,
    serving,
    style,
    typed,
    until,
    worked,
)
from tests.panels import quick, unproved

pytestmark = pytest.mark.external


def test_what_was_asked_and_what_is_said_of_it(chromium: Any, tmp_path: Path) -> None:
    """One page, whose messages are held back or made up: requests without an answer, reasons that are past."""
    with serving(unproved(quick(tmp_path).read_text("utf-8"))) as (desk, url), closing_pages(chromium) as b:
        page, wrong = opened(b, url, TAPPED)
        release_all(page)
        page.wait_for_selector("#restart", state="hidden")
        fresh(page)
        page.locator("#section-s9").focus()
        page.keyboard.press("Enter")
        page.evaluate("window.mute = true")

        def block() -> tuple[float, float]:
            before = time.time()
            page.locator("#acts button:text-is('Block')").click()
            return before, time.time()

        before, after = asked(page, block)
        told = page.evaluate("sent.at(-1)")
        when = told["heard"] + told["after"] / 1000
        assert told["do"] == "block" and before - 1 < when < after + 1, "when it was clicked"
        page.wait_for_selector("#grey:text-matches('Sent [1-9][0-9]* s ago, no answer yet')")
        page.evaluate("window.away = true, socket.close()")
        page.wait_for_selector("#said:has-text('not known whether it was done: look at the plan')")
        count = page.evaluate("window.mute = false, sent.length")
        page.locator("#acts button:text-is('Block')").evaluate("b => b.click()")
        page.wait_for_selector("#said:has-text('nothing was sent')")
        assert page.evaluate("unsent") > 0, "by this the tests ask again"
        assert page.evaluate(f"sent.slice({count}).filter(m => m.do)") == []
        page.evaluate("window.away = false")
        fresh(page)
        page.wait_for_selector("#grey:empty", state="attached")
        page.evaluate("new Promise(done => setTimeout(done, 300))")
        assert "nothing was sent" in page.inner_text("#said"), "news that come again do not take it away"
        page.keyboard.press("Escape")
        page.wait_for_selector("#said:not(:has(.unsent))")
        page.keyboard.press("Escape")
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


def done(desk: Desk, text: str) -> int:
    """How often something was done here."""
    b = desk.browsers
    return int(between(desk, lambda: sum(e.text.startswith(text) for e in (*b.events, *b._fresh))))


def is_done(desk: Desk, text: str, times: int) -> None:
    """Wait until something was done so often here, and no more often."""
    end = time.monotonic() + 40
    while (found := done(desk, text)) != times:
        assert found < times and time.monotonic() < end, (text, found)
        time.sleep(0.05)


def test_all_signals_to_stop_is_sent_whatever_the_news_are(chromium: Any, tmp_path: Path) -> None:
    """In a stall of a second nothing was sent, and that was said for a quarter of a second."""
    with worked(chromium, quick(tmp_path), TAPPED) as (desk, page):
        page.locator("#section-s9").focus()
        page.keyboard.press("Enter")
        page.evaluate("window.deaf = true")
        is_(page, "body", "stale")
        page.click("#stop")
        page.click("#acts button:text-is('Block')")
        until(page, "['stop', 'block'].every(d => sent.some(m => m.do === d))")
        page.click("#test")
        page.wait_for_selector("#said .unsent:has-text('no news from the server')")
        is_done(desk, "all signals to stop", 1)
        is_done(desk, "block section s9", 1)
        page.evaluate("window.deaf = false")
        fresh(page)
        assert page.locator("#said .unsent").count() == 1 and style(page, "#said", "opacity") == "1"
        asked(page, lambda: page.click("#stop"))
        page.wait_for_selector("#said:not(:has(.unsent))")  # something was done since
        before = done(desk, "all signals to stop")
        page.evaluate("window.away = true, socket.close()")
        until(page, "socket.readyState === 3")
        page.click("#stop")
        page.click("#stop")
        page.wait_for_selector("#grey:has-text('All signals to stop: not sent for')")
        page.evaluate("window.away = false")
        page.wait_for_selector("#grey:empty", state="attached")
        is_done(desk, "all signals to stop", before + 1)
        page.evaluate("window.mute = true")
        page.click("#stop")
        until(page, "sent.at(-1).do === 'stop'")
        page.evaluate("window.mute = false, socket.close()")  # nobody knows whether it was done
        until(page, "socket.readyState === 1")
        page.wait_for_selector("#grey:empty", state="attached")
        is_done(desk, "all signals to stop", before + 2)


def test_a_clock_that_is_set_does_not_make_the_page_old_for_ever(
    chromium: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    ahead = [0.0]
    clock = SimpleNamespace(time=lambda: time.time() + ahead[0], monotonic=time.monotonic)
    monkeypatch.setattr(browsers, "time", clock)
    with worked(chromium, quick(tmp_path)) as (_, page):
        for seconds in (-10.0, 25.0):
            ahead[0] += seconds
            page.evaluate("new Promise(done => setTimeout(done, 3000))")
            fresh(page)
        page.evaluate("(now => { Date.now = () => now() + 60000; })(Date.now.bind(Date))")
        page.evaluate("new Promise(done => setTimeout(done, 1500))")
        fresh(page)


SLOW = """{
    const Real = WebSocket;
    window.fresh = 0;
    window.WebSocket = class extends Real {
        set onmessage(heard) { super.onmessage = e => setTimeout(heard, 1500, e); }
    };
    new MutationObserver(() => { if (!document.body.classList.contains("stale")) window.fresh++; })
        .observe(document, {subtree: true, attributes: true, attributeFilter: ["class"]});
}"""
"""All that comes from the server comes a second and a half late; counts how often it is said to be fresh."""


def test_news_that_are_always_late_are_never_fresh(chromium: Any, tmp_path: Path) -> None:
    """The delay of the quickest message was taken for the difference of the clocks."""
    with serving(unproved(quick(tmp_path).read_text("utf-8"))) as (_, url), closing_pages(chromium) as b:
        page, wrong = opened(b, url, SLOW)
        page.wait_for_selector("#inputs.good")
        page.wait_for_selector("#link:text-is('OLD NEWS')")
        page.evaluate("new Promise(done => setTimeout(done, 4000))")
        assert page.evaluate("window.fresh") == 0 and wrong == []


def test_times_of_another_day_have_their_date_and_alarms_are_heard(chromium: Any, tmp_path: Path) -> None:
    """And who acknowledges by keys goes on with the next alarm; faults of points and signals have names."""
    with serving(unproved(quick(tmp_path).read_text("utf-8"))) as (desk, url), closing_pages(chromium) as b:
        page, wrong = opened(b, url, TAPPED)
        fresh(page)
        page.evaluate("window.deaf = true, setInterval(() => tell({}), 200)")
        at = "2026-01-31T06:00:00"
        alarms = [[f"a{k}", f"alarm {k}", [], at, 1, ""] for k in range(3)]
        tell = """([day, alarms, events, c = {}]) => tell({c, sys: {...SYS, day}, alarms, events})"""
        event = {
            "n": 9,
            "time": at,
            "rules": [],
            "at": [],
            "reasons": [],
            "kind": "note",
            "who": "",
            "text": "so it is",
        }
        page.evaluate(tell, ["2026-01-31", alarms, [event]])
        assert page.inner_text("#log li:first-child") == "06:00:00 so it is"
        assert page.inner_text("#alarms li:first-child b") == "06:00:00:"
        heard = page.inner_text("#news[role=alert]")
        assert [f"Alarm: alarm {k}" in heard for k in range(3)] == [True] * 3
        page.evaluate(tell, ["2026-02-01", alarms, []])
        assert page.inner_text("#log li:first-child") == "2026-01-31 06:00:00 so it is"
        assert page.inner_text("#alarms li:first-child b") == "2026-01-31 06:00:00:"
        page.wait_for_selector("#alarms:not(:has(.settling))")
        page.locator("#alarms li:nth-child(2) button").focus()
        page.keyboard.press("Enter")
        focused = "document.activeElement.parentElement.textContent"
        assert "alarm 0" in page.evaluate(focused), "the one below it"
        c = {"m:P4": ["", "R", 0, 1, 1, ""], "g:XB": ["stop", 1, 5, ["XB-XI7", 1], 1, None]}
        page.evaluate(tell, ["2026-02-01", alarms, [], c])
        name = page.get_attribute("#point-P4", "aria-label")
        assert all(word in name for word in ("not detected", "commanded", "not in time", "trailed")), name
        name = page.get_attribute("#signal-XB", "aria-label")
        assert "route XB-XI7, cancelling, stop lamp out" in name
        assert desk.broken == "" and wrong == []


def test_a_signal_waits_for_the_end_of_a_route_for_a_while(chromium: Any, tmp_path: Path) -> None:
    """A click a minute later, made to look at another signal, set a route; a double click made the next one wait."""
    with worked(chromium, quick(tmp_path), TAPPED) as (_, page):
        later = "ms => { const now = performance.now.bind(performance); performance.now = () => now() + ms; }"
        click(page, "#signal-XB .reach")
        page.wait_for_selector("#plan .exit")
        page.evaluate(later, 21_000)
        page.wait_for_selector("#plan:not(:has(.exit))")
        assert page.inner_text("#of") == "signal XB"
        click(page, "#signal-XI7 .reach")
        page.wait_for_selector("#of:text-is('signal XI7')")
        assert page.evaluate("sent.filter(m => m.do === 'set')") == []
        page.evaluate(later, 21_000)
        page.wait_for_selector("#plan:not(:has(.exit))")
        click(page, "#signal-XI7 .reach")  # again: it waits again
        page.wait_for_selector("#plan .exit")
        typed(page, "XI7 XB")
        page.wait_for_selector("#said:has-text('none leads from XI7 to XB')")
        assert page.locator("#plan .exit").count() == 0

        def twice() -> None:
            page.keyboard.press("Escape")
            click(page, "#signal-XB .reach")
            fresh(page)
            box = page.locator("#signal-XI7 .reach").bounding_box()
            page.mouse.dblclick(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)

        asked(page, twice)
        page.wait_for_selector("#of:text-is('Nothing chosen')")
        is_(page, "#signal-XB", "set")


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
