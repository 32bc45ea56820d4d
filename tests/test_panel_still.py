"""Nothing on the panel's page moves under the mouse, or says something else while it is clicked."""

from __future__ import annotations

import queue
from pathlib import Path
from typing import Any

import pytest

from interlock.panel.desk import Desk
from interlock.panel.operating import Person
from tests.pages import (
    TAPPED,
    asked,
    between,
    closing_pages,
    fresh,
    is_,
    opened,
    over,
    press,
    release_all,
    serving,
    until,
    worked,
)
from tests.panels import quick, unproved

pytestmark = pytest.mark.external


BUTTONS = """() => {
    window.all = new Map();
    for (const b of document.querySelectorAll("button, #plan [data-key]")) {
        const r = b.getBoundingClientRect();
        if (b.checkVisibility({visibilityProperty: true})) window.all.set(b, [r.x, r.y, r.width, r.height]);
    }
    return window.all.size;
}"""
"""Keeps where every button stands, and every element of the plan that can be clicked."""


MOVED = """() => [...window.all].flatMap(([b, [x, y, w, h]]) => {
    const r = b.getBoundingClientRect(), told = b.textContent.slice(0, 40) || b.id;
    const free = e => e.closest("aside [data-moved]") && !e.closest("aside > section").matches(":hover");
    const there = document.elementFromPoint(x + w / 2, y + h / 2)?.closest("button");
    if (!b.isConnected || !b.checkVisibility({visibilityProperty: true}))
        return there && !free(there) ? [`${told} is over, there is now ${there.textContent}`] : [];
    const same = b.matches("#plan *") ? true : r.width === w && r.height === h;
    if (free(b)) return [];
    return r.x === x && r.y === y && same ? [] : [`${told} moved by ${r.x - x}, ${r.y - y}, ${r.width - w}`];
})"""
"""What does not stand where it stood, or has another button in its place.  In boxes at the side in which the mouse is
not rows may move: they take no click then for a moment."""


@pytest.mark.parametrize(
    ("at", "size"),
    [
        ("#acts button:text-is('Block')", (1500, 900)),
        ("#alarms button", (1000, 700)),
        ("#trains button", (390, 800)),
        ("#rest button", (1280, 720)),
    ],
)
def test_nothing_moves_under_the_mouse(chromium: Any, tmp_path: Path, at: str, size: tuple[int, int]) -> None:
    """Alarms come and go, trains come, inputs and power are lost: whatever can be clicked stays where it is."""
    with worked(chromium, quick(tmp_path)) as (desk, page):
        f = desk.field
        assert f is not None
        page.set_viewport_size({"width": size[0], "height": size[1]})
        between(desk, lambda: f.stock.stand("s2", desk.browsers.still["stands"]["s2"][0], 50.0, "stands"))
        between(desk, lambda: desk._once("something happened"))
        page.wait_for_selector("#trains li")
        page.wait_for_selector("#alarms li:has-text('something happened')")
        is_(page, "#section-s2 .track", "occupied")
        page.locator("#section-s2").focus()
        page.keyboard.press("Enter")
        page.locator(at).first.scroll_into_view_if_needed()
        over(page, at)
        page.wait_for_selector("body:not(:has(.settling))")
        assert page.evaluate(BUTTONS) > 20

        def still(so: str) -> None:
            page.wait_for_selector(so, state="attached")
            page.wait_for_timeout(100)
            assert page.evaluate(MOVED) == [], so
            page.evaluate(BUTTONS)

        count = page.locator("#alarms li").count()
        long = "something happened whose telling takes more than one line of that box, as alarms of trains do"
        between(desk, lambda: desk._once(long))
        still(f"#alarms li:nth-child({count + 1})")
        desk.ask(Person("another", True), {"do": "acknowledge"}, lambda _: None)
        still("#unseen:not(.new)")
        between(desk, lambda: f.stock.stand("s10_xc4", desk.browsers.still["stands"]["s10_xc4"][0], 50.0, "second"))
        still("#trains li:nth-child(2)")
        between(desk, lambda: f.stock.take_away("stands"))
        still("#section-s2 .track:not(.occupied)")
        between(desk, lambda: f.faults.fail("station", desk.browsers.still["stations"][0], True))
        still("#inputs.bad")
        still("#restart:not([hidden])")
        desk.power = False
        still("#power.bad")
        desk.power = True
        still("#power.good")


def test_a_button_that_is_held_down_is_clicked_whatever_happens_meanwhile(chromium: Any, tmp_path: Path) -> None:
    """A button that is drawn anew between the press and the release of the mouse would lose the click."""
    with serving(unproved(quick(tmp_path).read_text("utf-8"))) as (desk, url):
        assert desk.field is not None
        with closing_pages(chromium) as b:
            page, wrong = opened(b, url)
            release_all(page)
            page.wait_for_selector("#restart", state="hidden")
            page.locator("#section-s3").focus()
            page.keyboard.press("Enter")
            middle = page.locator("#acts button:text-is('Block')").bounding_box()
            page.mouse.move(middle["x"] + middle["width"] / 2, middle["y"] + middle["height"] / 2)
            faults = desk.field.faults

            def hold() -> None:
                between(desk, lambda: faults.fail("section", "s3", False))
                is_(page, "#section-s3 .track", "occupied", False)
                page.mouse.down()
                between(desk, lambda: faults.fail("section", "s3", True))
                is_(page, "#section-s3 .track", "occupied")
                page.wait_for_timeout(200)
                page.mouse.up()

            asked(page, hold)
            page.wait_for_selector("#section-s3 .track.blocked", state="attached")
            page.wait_for_selector("#acts:has-text('occupied'):has-text('blocked'):has-text('Free it again')")
            assert wrong == []


WHEN = """([box, word, act]) => new Promise(done => new MutationObserver((_, o) => {
    if (!document.querySelector(box).textContent.includes(word)) return;
    o.disconnect();
    const b = [...document.querySelectorAll(`${box} button`)].find(e => e.textContent.includes(word));
    const r = b?.getBoundingClientRect();
    if (act === "click") b.click();
    else if (act) document.getElementById("ack").dispatchEvent(new KeyboardEvent("keydown", {key: act, bubbles: true}));
    window.hit = r && document.elementFromPoint(r.x + r.width / 2, r.y + r.height / 2) === b;
}).observe(document.querySelector(box), {subtree: true, childList: true, characterData: true}) ?? done())"""
"""In the moment in which a word appears in a box: presses a key beside the alarms, or clicks the button without the
mouse, as a key does; and keeps whether a click of the mouse would hit it."""


def done(desk: Desk, text: str) -> int:
    """How often something was done here."""
    return int(between(desk, lambda: sum(e.text == text for e in (*desk.browsers.events, *desk.browsers._fresh))))


def by(desk: Desk, **command: Any) -> None:
    """Somebody else asks for something, and has it."""
    found: queue.SimpleQueue[dict[str, Any]] = queue.SimpleQueue()
    desk.ask(Person("another", True), command, found.put)
    assert found.get(timeout=10)["ok"]


def test_a_key_does_what_stood_there_when_it_was_pressed_and_does_it_once(chromium: Any, tmp_path: Path) -> None:
    """Enter pressed twice, or held down, blocked a section and freed it; Space that was pressed on `Block` freed what
    somebody else had blocked meanwhile."""
    with worked(chromium, quick(tmp_path), TAPPED) as (desk, page):
        page.locator("#section-s3").focus()
        page.keyboard.press("Enter")
        page.evaluate(WHEN, ["#acts", "Free it again", "click"])
        page.locator("#acts button:text-is('Block')").focus()
        for _ in range(30):
            page.keyboard.down("Enter")
            page.wait_for_timeout(33)
        page.keyboard.up("Enter")
        page.wait_for_selector("#acts button:text-is('Free it again')")
        page.wait_for_selector("#acts:not(:has(.settling))")
        assert (done(desk, "block section s3"), done(desk, "free section s3")) == (1, 0)
        by(desk, do="block", section="s3", on=False)
        page.wait_for_selector("#acts button:not(.settling):text-is('Block')")
        page.locator("#acts button:text-is('Block')").focus()
        page.keyboard.down("Space")
        by(desk, do="block", section="s3", on=True)
        is_(page, "#section-s3 .track", "blocked")
        page.wait_for_timeout(500)
        page.keyboard.up("Space")
        page.wait_for_selector("#acts button:not(.settling):text-is('Free it again')")
        assert done(desk, "free section s3") == 1 and desk.operating.stands.blocks == ("s3",)
        page.wait_for_selector("#power-key:not(.settling):text-is('Cut the power')")
        page.locator("#power-key").focus()
        page.keyboard.down("Space")
        by(desk, do="power", on=False)
        page.wait_for_selector("#power-key:not(.settling):text-is('Give power')")
        page.keyboard.up("Space")
        fresh(page)
        page.evaluate("new Promise(done => setTimeout(done, 300))")
        assert not desk.power and page.evaluate("sent.filter(m => m.do === 'power')") == []
        page.locator("#section-s9").focus()
        for _ in range(2):
            page.keyboard.down("Enter")
        page.keyboard.up("Enter")
        assert page.inner_text("#of") == "section s9"


SETTLED = """() => {
    window.settled = 0;
    const look = all => { for (const m of all) window.settled += m.target.matches("#acts button.settling"); };
    new MutationObserver(look).observe(document.body, {subtree: true, attributes: true, attributeFilter: ["class"]});
}"""
"""Counts how often a button of what is chosen takes no click for a moment."""


def test_a_page_that_comes_back_has_what_was_chosen_and_typed_and_takes_no_click_at_once(
    chromium: Any, tmp_path: Path
) -> None:
    """Its buttons were new, and freed what had just been blocked; what was typed on went nowhere, and an a in it
    acknowledged all alarms."""
    with worked(chromium, quick(tmp_path), TAPPED) as (desk, page):
        page.locator("#section-s3").focus()
        page.keyboard.press("Enter")
        page.evaluate(SETTLED)
        page.evaluate(WHEN, ["#acts", "Free it again", "click"])

        def back() -> None:
            page.evaluate("window.away = true, socket.close()")
            until(page, "socket.readyState === 3")
            by(desk, do="block", section="s3", on=True)
            page.evaluate("window.away = false")
            until(page, "socket.readyState === 1")
            fresh(page)

        back()
        page.wait_for_selector("#acts button:not(.settling):text-is('Free it again')")
        assert desk.operating.stands.blocks == ("s3",) and done(desk, "free section s3") == 0
        count = page.evaluate("settled")
        between(desk, lambda: desk._once("something happened"))
        page.wait_for_selector("#alarms li:has-text('something happened')")
        note = page.locator("[data-mark=note]")
        note.focus()
        page.keyboard.type("rail crack, men ")
        back()
        page.keyboard.type("at work")
        until(page, f"settled > {count}")
        assert page.inner_text("#of") == "section s3"
        assert note.input_value() == "rail crack, men at work" and "NOT SAVED" in page.inner_text("#acts .unsaved")
        page.locator("h1").click()
        page.keyboard.press("a")
        page.locator("#section-s9").focus()
        page.keyboard.press("Enter")
        assert note.input_value() == ""
        page.locator("#section-s3").focus()
        page.keyboard.press("Enter")
        assert note.input_value() == "rail crack, men at work"
        by(desk, do="remind", at="s:s3", text="another's")
        page.wait_for_selector('#acts .unsaved:has-text("saved: another\'s, by another")')
        enter = "e => e.dispatchEvent(new KeyboardEvent('keydown', {key: 'Enter', isComposing: %s, bubbles: true}))"
        note.evaluate(enter % "true")
        assert page.evaluate("sent.filter(m => m.do === 'remind')") == []
        asked(page, lambda: note.evaluate(enter % "false"))
        page.wait_for_selector("#acts:not(:has(.unsaved)):has-text('by operator')")
        assert page.locator("#alarms .new:has-text('something happened')").count() == 1
        assert desk.operating.reminders["s:s3"][0] == "rail crack, men at work"
        note.fill("x")
        note.press("Escape")
        assert note.input_value() == "rail crack, men at work" and page.inner_text("#of") == "section s3"


def test_an_alarm_that_was_never_in_view_is_not_acknowledged_with_all(chromium: Any, tmp_path: Path) -> None:
    with worked(chromium, quick(tmp_path)) as (desk, page):
        over(page, "h1")
        for n in range(12):
            between(desk, lambda n=n: desk._once(f"something happened, number {n}"))
        page.wait_for_selector("#alarms li:has-text('number 11')")
        page.wait_for_selector("#unseen:has-text(' new, '):has-text(' below')")

        def acknowledge_until_gone(alarm: str) -> None:
            for _ in range(30):
                page.evaluate("new Promise(done => setTimeout(done, 700))")  # by the page's clock, as it counts itself
                asked(page, lambda: page.locator("#ack").evaluate("b => b.click()"))
                if done(desk, f"seen: {alarm}"):
                    return
                page.locator("#alarms li:last-child").scroll_into_view_if_needed()
            raise AssertionError(page.inner_text("#alarms"))

        page.evaluate("new Promise(done => setTimeout(done, 2000))")
        asked(page, lambda: page.locator("#ack").evaluate("b => b.click()"))
        page.wait_for_selector("#alarms:not(:has-text('number 11'))")
        assert "number 0" in page.inner_text("#alarms") and not done(desk, "seen: something happened, number 0")
        acknowledge_until_gone("something happened, number 0")


def test_what_has_moved_or_says_something_else_takes_no_click_at_once(chromium: Any, tmp_path: Path) -> None:
    """A signaller who clicks twice does not undo what he has done, nor acknowledge an alarm that came that moment."""
    with worked(chromium, quick(tmp_path)) as (desk, page):
        page.locator("#section-s3").focus()
        page.keyboard.press("Enter")
        page.evaluate(WHEN, ["#acts", "Free it again", ""])
        press(page, "Block")
        page.wait_for_selector("#section-s3 .track.blocked", state="attached")
        page.wait_for_selector("#acts button:not(.settling):text-is('Free it again')")
        assert page.evaluate("window.hit") is False
        words = iter(("first", "second", "third", "fourth", "fifth", "sixth"))

        def two_come() -> tuple[str, str]:
            """The newest that somebody can have seen, and one that comes when all of them are acknowledged."""
            seen, newest = next(words), next(words)
            over(page, "h1")
            between(desk, lambda: desk._once(seen))
            page.wait_for_selector(f"#alarms li:has-text('{seen}')")
            page.evaluate("new Promise(done => setTimeout(done, 2000))")  # by the page's clock, as it counts itself
            over(page, f"#alarms li:has-text('{seen}') button")
            fresh(page)
            page.evaluate(WHEN, ["#alarms", newest, "a"])  # it has just come: nobody can have seen it
            between(desk, lambda: desk._once(newest))
            page.wait_for_selector(f"#alarms li:has-text('{newest}')")
            return seen, newest

        seen, newest = asked(page, two_come)
        page.wait_for_selector(f"#alarms li.over:has-text('{seen}')", state="attached")
        page.wait_for_selector("#unseen:has-text('1 new')")
        assert newest in page.inner_text("#alarms li:not(.over)")
        over(page, "h1")  # the newest comes first when the mouse has left
        page.wait_for_selector(f"#alarms li:first-child:has-text('{newest}')")
