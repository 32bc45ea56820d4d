"""What the panel's page draws (in Debian's Chromium): states, colours, numbers, small screens, and how soon."""

from __future__ import annotations

import os
import statistics
from itertools import pairwise
from pathlib import Path
from typing import Any

import pytest

from interlock.panel.operating import Person
from tests.layouts import SLIPS
from tests.pages import (
    OVERLAPPING,
    TAPPED,
    Server,
    between,
    changes,
    click,
    closing_pages,
    fresh,
    is_,
    opened,
    press,
    release_all,
    serving,
    serving_process,
    style,
    typed,
    worked,
)
from tests.panels import QUICK, quick, unproved
from tests.test_coupled_derailer import SPUR

pytestmark = pytest.mark.external


FLANK = Path("layouts/flank_lab.yaml")
"""With a derailer, proof of lamps, and a signal that shows caution."""


SIGNS = """() => [...document.querySelectorAll("#signal-F .sign")].filter(e => getComputedStyle(e).stroke !== "none")
    .map(e => e.classList[1])"""
"""What is drawn over the lamps of a signal."""


def test_each_state_is_drawn_as_the_table_says(chromium: Any) -> None:
    """What the server says of an element, alone and together with something else: on one page, one after the other."""
    with serving(unproved(FLANK.read_text("utf-8"))) as (desk, url), closing_pages(chromium) as b:
        page, wrong = opened(b, url, TAPPED)
        fresh(page)
        page.evaluate("window.deaf = true, setInterval(() => tell({}), 200)")
        red, yellow = "rgb(255, 77, 77)", "rgb(255, 210, 74)"
        for late, trailed, colour in ((0, 0, yellow), (1, 0, red), (0, 1, red)):
            for m, mark in (("6", "rect.mark"), ("Gs1", "path.mark")):
                page.evaluate("([k, v]) => tell({c: {[k]: v}})", [f"m:{m}", ["", "", 1, late, trailed]])
                assert style(page, f"#point-{m} {mark}", "fill") == colour, "points that are locked, and lost"
                assert (style(page, f"#point-{m} {mark}", "animationName") == "blink") == (colour == red)
        dark, bar = "rgb(34, 43, 53)", "none"
        for aspect, out, fill, cross in (
            ("stop", 0, "rgb(255, 59, 59)", bar),
            ("stop", 1, dark, "rgb(255, 176, 0)"),
            ("clear", 1, "rgb(53, 224, 111)", bar),
        ):
            page.evaluate("v => tell({sys: {...SYS, valid: true}, c: {'g:F': v}})", [aspect, 0, None, None, out])
            assert style(page, "#signal-F .lamp", "fill") == fill, "a lamp that is out is dark here, too"
            assert style(page, "#signal-F .sign.cross", "stroke") == cross
            assert (style(page, "#signal-F .lamp", "strokeWidth") != "1.3px") == bool(out)
        page.evaluate("tell({sys: {...SYS, valid: false}, c: {'g:F': ['stop', 0, null, null, 1]}})")
        assert style(page, "#signal-F .sign.cross", "stroke") == "none", "nobody knows: no inputs come"
        page.evaluate("tell({sys: {...SYS, valid: true}})")
        for aspect, fault, signs in (
            ("stop", 0, ["bar"]),
            ("caution", 0, ["slash"]),
            ("clear", 0, []),
            ("stop", 1, ["cross"]),
        ):
            page.evaluate("v => tell({c: {'g:F': v}})", [aspect, 0, None, None, fault])
            assert page.evaluate(SIGNS) == signs, "aspects are told from each other without colours"
        wide = []
        for occupied, ways in ((0, []), (0, [1]), (1, []), (1, [1])):
            page.evaluate("v => tell({c: {'s:g4': v}})", [occupied, ways, 0, 0, 0, None, 0, 0])
            wide.append(float(style(page, "#section-g4 .track", "strokeWidth").removesuffix("px")))
        assert wide[0] < wide[1] < wide[2] == wide[3] >= 1.6 * wide[0]
        page.evaluate("document.getElementById('section-g8').classList.add('chosen', 'shown', 'exit')")
        page.evaluate("tell({c: {'s:g8': [0, [], 0, 0, 0, null, 0, 0]}})")
        assert style(page, "#section-g8 .track", "strokeWidth") == f"{wide[0]:g}px", "pointed at is not occupied"
        assert style(page, "#section-g8 .hit", "stroke") not in ("none", "rgba(0, 0, 0, 0)")
        assert style(page, "#section-g8 .hit", "strokeDasharray") != "none", "what refuses is not chosen"
        core = "document.querySelector('#section-g4 .track + .core')"
        for state, double in (([0, []], False), ([0, [1]], True), ([1, [1]], False), ([1, []], False)):
            page.evaluate("v => tell({c: {'s:g4': v}})", [*state, 0, 0, 0, None, 0, 0])
            assert (page.evaluate(f"getComputedStyle({core}).stroke") != "none") == double, "told without its colour"
        for blocked in (0, 1):
            page.evaluate("v => tell({c: {'s:g4': v}})", [0, [1], 0, blocked, 0, None, 0, 0])
            assert style(page, "#section-g4 .track", "stroke") == yellow, "blocked, and still seen to be locked"
            assert (style(page, "#section-g4 .block", "stroke") != "none") == bool(blocked)
        for on in (1, 0, 1):
            page.evaluate("on => tell({c: {'a:N8-F': [on], 'a:SA-S1': [on]}})", on)
            assert page.locator("#plan .automatic circle").count() == 2 * on
            assert page.evaluate(OVERLAPPING.replace(".note'", ".note, .automatic text'")) == []
        assert desk.broken == "" and wrong == []


@pytest.mark.parametrize(
    ("profile", "stop"), [("uk", "rgb(255, 59, 59)"), ("de", "rgb(255, 59, 59)"), ("cn", "rgb(106, 156, 255)")]
)
def test_a_shunt_signal_at_stop_has_the_colour_of_its_country(chromium: Any, profile: str, stop: str) -> None:
    """It was blue everywhere.  The second lamp of a combined signal is dark beside the red one."""
    text = SPUR.replace("name: spur", f"name: spur\nprofile: {profile}")
    text = text.replace("into: q2, kind: combined}\n  S:", "into: q2, kind: shunt}\n  S:")
    with serving(unproved(text)) as (desk, url), closing_pages(chromium) as b:
        page, wrong = opened(b, url, TAPPED)
        fresh(page)
        for g in ("L1", "S2"):
            is_(page, f"#signal-{g}", "stop")
        assert style(page, "#signal-L1 .lamp.shunt", "fill") == stop
        assert style(page, "#signal-S2 .lamp.shunt", "fill") == "rgb(34, 43, 53)"
        assert style(page, "#signal-S2 .lamp.main", "fill") == "rgb(255, 59, 59)"
        assert desk.broken == "" and wrong == []


@pytest.mark.parametrize(("said", "points"), [(", single: 1a-2b", 2), ("", 2), (", machines: [7]", 4)])
def test_each_blade_of_a_slip_shows_how_it_lies(chromium: Any, said: str, points: int, tmp_path: Path) -> None:
    path = tmp_path / "slips.yaml"
    path.write_text(SLIPS % said, "utf-8")
    with serving_process(path) as one, closing_pages(chromium) as found:
        page, wrong = opened(found, one.url)
        page.wait_for_function(f"document.querySelectorAll('#plan .lie.N.lies').length === {points}")
        apart = page.evaluate(
            "[...document.querySelectorAll('#plan .point .reach')].map(c => c.getBBox())"
            ".map(b => [b.x + b.width / 2, b.y + b.height / 2])"
        )
        assert len(apart) == points
        for i, (x, y) in enumerate(apart):  # each is clicked by itself
            assert all(abs(x - a) + abs(y - b) > 22 for a, b in apart[i + 1 :]), apart
        assert page.locator("#plan .lie.R.lies").count() == 0
        if os.environ.get("INTERLOCK_PICTURES"):
            page.screenshot(path=Path(os.environ["INTERLOCK_PICTURES"]) / f"slip{points}{len(said)}.png")
        assert wrong == []


def test_a_manual_change_of_direction_stands_on_the_plan(chromium: Any) -> None:
    """Nothing on the page said that it was on."""
    ready = unproved(Path("layouts/passing_loop.yaml").read_text("utf-8") + QUICK)
    with serving(ready) as (_, url), closing_pages(chromium) as b:
        page, wrong = opened(b, url)
        release_all(page)
        page.wait_for_selector("#restart", state="hidden")
        click(page, "#boundary-W .reach")
        on, off = (page.get_by_role("button", name=f"Special manual change: {x}") for x in ("on", "off"))
        assert off.is_disabled()
        press(page, "Special manual change: on")
        page.wait_for_selector("#said:has-text('agreed by telephone')")
        press(page, "It is agreed: change it")
        page.wait_for_selector(".note.left:text-matches('^manual change: [1-6][0-9] s$')")
        assert on.is_disabled() and "Special manual change of direction: on, complete in " in page.inner_text("#acts")
        press(page, "Special manual change: off")
        page.wait_for_selector(".note.left", state="detached")
        assert off.is_disabled() and "complete in" not in page.inner_text("#acts")
        assert wrong == []


def test_numbers_stand_at_their_sections_and_over_no_name(chromium: Any, server: Server) -> None:
    with closing_pages(chromium) as b:
        page, wrong = opened(b, server.url)
        for number, section in (("4711", "s5_xc2"), ("12", "s2"), ("13", "s10_xc4"), ("901", "s7")):
            click(page, f"#section-{section} .track")
            press(page, "Put a train here")
            is_(page, f"#section-{section} .track", "occupied")
            shown = f"#plan text.number[data-of={section}]:has-text({number!r})"
            for _ in range(40):  # refused as long as the describer has not seen that the section is occupied
                typed(page, f"{number}@{section}")
                page.wait_for_timeout(500)
                if page.locator(shown).count():
                    break
            page.wait_for_selector(shown, state="attached")
            assert page.evaluate(OVERLAPPING) == []
            at, on = (page.locator(f"#plan {x}").first.bounding_box() for x in
                      (f"text.number[data-of={section}]", f"#section-{section}"))  # fmt: skip
            assert on["x"] - 20 < at["x"] + at["width"] / 2 < on["x"] + on["width"] + 20
            assert on["y"] - 60 < at["y"] + at["height"] / 2 < on["y"] + on["height"] + 60
        assert wrong == []


MEETING = """() => {
    const all = [...document.querySelectorAll(
        'header > :not([hidden], #bar), #bar > *, #line label, #line button')];
    const boxes = all.map(e => [e.id, e.getBoundingClientRect()]);
    const meet = (a, b) => a.x < b.right - 1 && b.x < a.right - 1 && a.y < b.bottom - 1 && b.y < a.bottom - 1;
    return boxes.flatMap(([n, a], k) => boxes.slice(k + 1).filter(([, b]) => meet(a, b)).map(([m]) => [n, m]));
}"""
"""What of the head, and of the line below the plan, lies over something else."""


def test_on_small_screens_nothing_lies_over_anything_or_is_cut(chromium: Any, server: Server) -> None:
    with closing_pages(chromium) as b:
        page, wrong = opened(b, server.url)
        page.set_viewport_size({"width": 390, "height": 800})
        parts = "['#plan', '#line', 'aside'].map(x => document.querySelector(x).getBoundingClientRect().toJSON())"
        boxes = page.evaluate(parts)
        for across, down, lines, plan in ((1024, 768, 2, 520), (1366, 768, 1, 560), (390, 800, 5, 200)):
            page.set_viewport_size({"width": across, "height": down})
            assert page.evaluate(MEETING) == [] and page.evaluate("document.documentElement.scrollWidth") <= across
            assert page.locator("header").bounding_box()["height"] < 8 + 32 * lines, across
            assert page.locator("#plan").bounding_box()["height"] > plan
            stop, test = (page.locator(x).bounding_box() for x in ("#stop", "#test"))
            assert abs(stop["y"] - test["y"]) > 150, "what stops the trains is not beside what tests the lamps"
        assert page.evaluate("document.documentElement.scrollWidth") <= 390 and boxes[0]["width"] > 380
        assert boxes[0]["height"] > 200
        for above, below in pairwise(boxes):
            assert above["bottom"] <= below["top"] + 1
        width = "Number(document.querySelector('#plan svg').getAttribute('viewBox').split(' ')[2])"
        before, touch, y = page.evaluate(width), page.context.new_cdp_session(page), boxes[0]["y"] + 80
        for kind, apart in (("Start", 20), ("Move", 40), ("Move", 80), ("End", None)):  # two fingers look closer
            points = [] if apart is None else [{"x": 195 - apart, "y": y, "id": 0}, {"x": 195 + apart, "y": y, "id": 1}]
            touch.send("Input.dispatchTouchEvent", {"type": f"touch{kind}", "touchPoints": points})
        page.wait_for_function(f"{width} < {before / 2}")
        press(page, "fit")
        assert page.evaluate(width) == before
        page.evaluate("""() => { const svg = document.querySelector("#plan svg"), r = svg.getBoundingClientRect();
            const at = (kind, x) => svg.dispatchEvent(new PointerEvent(kind, {pointerId: 1, isPrimary: true, buttons: 1,
                bubbles: true, pointerType: "mouse", clientX: r.x + x, clientY: r.y + 20}));
            at("pointerdown", 50); at("pointermove", 90); at("pointerdown", 60); }""")  # let go outside the window
        press(page, "fit")
        click(page, "#signal-XB .reach")
        is_(page, "#signal-XB", "chosen")
        page.keyboard.press("Escape")
        for wide, high in ((683, 384), (390, 844)):
            page.set_viewport_size({"width": wide, "height": high})
            typed(page, "nowhere")
            page.wait_for_selector("#said:has-text('nothing on the plan is called nowhere')")
            page.evaluate("scrollTo(0, document.documentElement.scrollHeight)")
            for part in ("#link", "#stop", "#said", "#fresh"):
                box = page.locator(part).bounding_box()
                assert box["y"] >= 0 and box["y"] + box["height"] <= high and box["width"] > 20, (part, wide)
            assert page.title().startswith("(") and page.title().endswith("heishan")
        page.set_viewport_size({"width": 1280, "height": 760})
        tops = "[...document.querySelectorAll('header > :not([hidden])')].map(e => e.getBoundingClientRect().bottom)"
        assert max(page.evaluate(tops)) < 40, "the head is one line"
        cut = """() => { const b = document.getElementById("steps"), r = b.getBoundingClientRect();
            return [...b.children].filter(e => { const q = e.getBoundingClientRect();
                return q.top < r.top - 1 && q.bottom > r.top + 1; }).map(e => e.textContent); }"""
        page.wait_for_selector("#restart button:enabled")
        page.evaluate("new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))")
        assert page.evaluate(cut) == [], "the first step in view is whole"
        assert wrong == []


def test_alarms_and_the_author_of_a_reminder_are_read_whole(chromium: Any, tmp_path: Path) -> None:
    """Two alarms, each as long as they are, and the box of trains is there: none is cut on a small desktop."""
    with worked(chromium, quick(tmp_path)) as (desk, page):
        assert desk.field is not None
        for at, element in (("s:s2", "#section-s2"), ("g:XI7", "#signal-XI7")):
            page.locator(element).focus()
            page.keyboard.press("Enter")
            desk.ask(
                Person("somebody with a name", True),
                {"do": "remind", "at": at, "text": "a"},
                lambda _: None,
            )
            page.wait_for_selector("#acts small:has-text('by somebody with a name')")
            for high in (900, 720):
                page.set_viewport_size({"width": 1440, "height": high})
                box, by = (page.locator(x).bounding_box() for x in ("#acts", "#acts small"))
                assert by["y"] >= box["y"] and by["y"] + by["height"] <= box["y"] + box["height"], high
                assert by["x"] + by["width"] <= box["x"] + box["width"]
        page.set_viewport_size({"width": 1280, "height": 760})
        stock, towards = desk.field.stock, desk.browsers.still["stands"]["s2"][0]
        between(desk, lambda: stock.stand("s2", towards, 50.0, "stands"))
        page.wait_for_selector("#trains li")
        for what in (
            "every signal shows stop until its route is asked for",
            "no points turn until somebody asks for a route over them",
        ):
            between(desk, lambda what=what: desk._once(f"the controller starts: {what}"))  # type: ignore[misc]
        page.wait_for_selector("#alarms li:nth-child(3)")
        assert (
            page.evaluate("""() => { const b = document.getElementById("alarms").getBoundingClientRect();
            return [...document.querySelectorAll("#alarms li:nth-child(-n+2)")].map(e => e.getBoundingClientRect())
                .filter(r => r.bottom > b.bottom || r.top < b.top).length; }""")
            == 0
        )


def test_a_change_in_a_yard_of_a_thousand_routes_reaches_the_page_at_once(chromium: Any) -> None:
    took, crowded = changes(chromium)
    assert statistics.quantiles(took, n=20)[-1] < 200 * crowded, (crowded, took)
