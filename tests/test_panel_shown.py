"""What an operator tells apart on the panel's plan (in Debian's Chromium), without colours, too, and while nothing
blinks: how points and devices lie, where a vehicle may stand, which way leads over a slip, what a signal shows."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from itertools import combinations
from pathlib import Path
from typing import Any

import pytest

from tests.pages import (
    OVERLAPPING,
    TAPPED,
    closing_pages,
    fresh,
    is_,
    opened,
    press,
    release_all,
    serving,
    set_route,
    style,
)
from tests.panels import QUICK, unproved

pytestmark = pytest.mark.external

RED, YELLOW, WHITE = "rgb(255, 77, 77)", "rgb(255, 210, 74)", "rgb(242, 245, 248)"


@contextmanager
def told(chromium: Any, text: str) -> Iterator[tuple[Any, dict[str, Any]]]:
    """A page that hears nothing from its server, whose sections are clear, and what never changes on it."""
    with serving(unproved(text)) as (desk, url), closing_pages(chromium) as b:
        page, wrong = opened(b, url, TAPPED)
        fresh(page)
        page.evaluate("window.deaf = true, setInterval(() => tell({}), 200)")
        still = desk.browsers.still
        tell(page, {f"s:{s}": section() for s in still["sections"]})
        yield page, still
        assert desk.broken == "" and wrong == []


def tell(page: Any, changes: dict[str, Any]) -> None:
    """What the server might say."""
    page.evaluate("c => tell({c, sys: SYS})", changes)


def section(occupied: int = 0, *ways: Any) -> list[Any]:
    """What is said of a section with these ways locked."""
    return [occupied, list(ways), 0, 0, 0, None, 0, 0, []]


def machine(lies: str, wanted: str = "", locked: int = 0, late: int = 0, trailed: int = 0) -> list[Any]:
    """What is said of a machine."""
    return [lies, wanted, locked, late, trailed, "section w1 is locked" if locked else ""]


LEGS = """m => ["N", "R"].map(leg => {
    const those = [...document.querySelectorAll(`#point-${m} .lie.${leg} path`), document.querySelector("#plan rect")];
    const [rim, piece, board] = those.map(e => getComputedStyle(e));
    return [piece.stroke, piece.strokeDasharray, piece.animationName,
        parseFloat(rim.strokeWidth) > parseFloat(piece.strokeWidth) && rim.stroke === board.fill];
})"""
"""How the two legs of points are drawn: colour, dashes, whether they blink, whether they have a rim."""


def test_points_that_are_not_detected_never_look_as_if_they_were(chromium: Any) -> None:
    """A leg that was commanded and not yet reached was a white piece as before, which did not blink; points without
    detection were told from others by a square of five pixels."""
    lies, none = (WHITE, "none", "none", True), ("none", "none", "none", False)
    wanted, lost = (WHITE, "4px, 3px", "flash", True), (RED, "4px, 3px", "none", True)
    wanted_late = (RED, "4px, 3px", "flash", True)
    with told(chromium, Path("layouts/flank_lab.yaml").read_text("utf-8")) as (page, _):
        for state, normal, reverse in (
            (machine("N", "N"), lies, none),
            (machine("R"), none, lies),
            (machine("N", "R"), lies, wanted),
            (machine("", "R"), none, wanted),
            (machine(""), lost, lost),
            (machine("NR"), lost, lost),
            (machine("", "R", late=1), lost, wanted_late),
            (machine("", "", trailed=1), lost, lost),
            (machine("N", "", trailed=1), (RED, *lies[1:]), lost),
        ):
            tell(page, {"m:2": state})
            fresh(page)
            assert [tuple(x) for x in page.evaluate(LEGS, "2")] == [normal, reverse], state
        frames = page.evaluate("""() => [...document.styleSheets].flatMap(s => [...s.cssRules])
            .find(r => r.name === "flash").cssRules.length && [...document.styleSheets].flatMap(s => [...s.cssRules])
            .find(r => r.name === "flash").cssText.match(/opacity: [^;]*/g)""")
        assert frames == ["opacity: 1", "opacity: 0.35"], "it is seen that it blinks, and never gone"
        sizes = []
        for late in (0, 1):
            tell(page, {"m:2": machine("", late=late)})
            sizes.append(page.evaluate("document.querySelector('#point-2 .mark').getBoundingClientRect().width"))
        assert sizes[1] > 1.5 * sizes[0]


def test_where_a_way_is_locked_a_vehicle_may_stand_on_the_other_leg(chromium: Any) -> None:
    """The other leg of an occupied section of points was drawn as if it were clear; the detector does not say so."""
    with told(chromium, Path("layouts/flank_lab.yaml").read_text("utf-8")) as (page, still):
        edges, ways = still["sections"]["w1"]["edges"], still["sections"]["w1"]["ways"]
        way = next(k for k, es in ways.items() if "1.reverse" in es)
        for occupied, locked in ((1, [way]), (1, []), (0, [way]), (0, [])):
            tell(page, {"s:w1": section(occupied, *locked)})
            for e in edges:
                colour, wide = (style(page, f'[id="edge-{e}"]', x) for x in ("stroke", "strokeWidth"))
                assert (colour == RED) == bool(occupied), (e, locked)
                assert (wide == "7px") == bool(occupied and (not locked or e in ways[way]))
                assert (wide == "2px") == bool(occupied and locked and e not in ways[way]), (
                    "and it is not said that it does"
                )


SHOWS = """([paths, kind]) => paths.map(id => document.getElementById(id))
    .map(e => getComputedStyle(e).display !== "none" && e.classList.contains(kind))"""
"""Which of some lines are seen to be in a state."""

FARTHEST = """() => { const c = document.getElementById("edge-210.m"), m = c.getPointAtLength(0);
    return Math.min(...[...document.querySelectorAll("#plan .train")].flatMap(t => [...t.points])
        .map(p => Math.hypot(p.x - m.x, p.y - m.y))); }"""
"""How near trains are drawn to the middle of a slip's diamond."""


def test_over_a_double_slip_the_way_of_a_train_is_lit_and_no_other(chromium: Any) -> None:
    """It was lit through the middle of the diamond, where no train comes from the one leg to the other."""
    rail, other = "rail-210.1a-210.2b", "rail-210.1b-210.2a"
    arms, legs = ["arm-210.1a", "arm-210.2b"], ["edge-210.1a", "edge-210.2b", "edge-210.m"]
    with told(chromium, Path("layouts/slip_junction.yaml").read_text("utf-8")) as (page, still):
        ways = still["sections"]["SC"]["ways"]
        slip = [k for k, es in ways.items() if {"210.1a", "210.2b"} <= set(es)]
        straight = [k for k, es in ways.items() if {"210.1a", "210.1b"} <= set(es)]
        assert slip and straight
        for kind, state in (("locked", section(0, slip[0])), ("occupied", section(1, slip[0]))):
            tell(page, {"s:SC": state})
            assert page.evaluate(SHOWS, [[rail, *arms], kind]) == [True] * 3
            assert page.evaluate(SHOWS, [[other, *legs, "edge-210.1b"], kind]) == [False] * 5
        assert page.evaluate(SHOWS, [[*legs, other], "maybe"]) == [True] * 4
        tell(page, {"s:SC": section(0, straight[0])})
        assert page.evaluate(SHOWS, [["edge-210.1a", "edge-210.1b", "edge-210.m"], "locked"]) == [True] * 3
        assert page.evaluate(SHOWS, [[rail, other, *arms], "locked"]) == [False] * 4
        tell(page, {"s:SC": section(1)})
        assert page.evaluate(SHOWS, [[rail, other, *legs], "occupied"]) == [True] * 5
        edges = still["edges"]
        one, two, middle = (edges[e][0] for e in ("210.1a", "210.2b", "210.m"))
        spans = {
            "whole": [["210.1a", 0, one], ["210.m", 0, middle], ["210.2b", 0, two]],
            "its front": [["210.1a", 0, one], ["210.m", 0, middle]],
            "its rear": [["210.2b", 0, two]],
        }
        for blades, kept in ((("N", "R"), True), (("N", "N"), False)):
            tell(page, {"m:210a": machine(blades[0]), "m:210b": machine(blades[1])})
            for part, span in spans.items():
                page.evaluate("t => tell({trains: [t]})", ["T", span, 20, 80, ["SC"], 0, 1])
                near = page.evaluate(FARTHEST)
                assert (near > 10) == (kept or part == "whole"), (part, blades, near)


LOOKS = """d => [...document.querySelectorAll(`#device-${d} > .mark`)].map(e => getComputedStyle(e))
    .map(s => [s.display, s.strokeDasharray, s.strokeWidth])"""
"""How a device is drawn, without its colour."""


@pytest.mark.parametrize(
    ("layout", "device"),
    [
        ("layouts/flank_lab.yaml", "LC1"),
        ("layouts/depot.yaml", "BRIDGE"),
        ("tests/layouts_for_tests/air_lock_doors.yaml", "D1"),
    ],
)
def test_a_device_shows_how_it_is_and_that_it_is_locked(chromium: Any, layout: str, device: str) -> None:
    """An open door was drawn as something closed, a shut one as if nothing were known of it; that a device was locked
    was seen nowhere."""
    with told(chromium, Path(layout).read_text("utf-8")) as (page, still):
        assert still["machines"][device]["device"]
        page.evaluate("document.querySelector('#plan g.signal').classList.add('shown')")
        seen, refused = {}, style(page, "#plan .shown .reach", "stroke")
        for lies in ("N", "R", ""):
            tell(page, {f"m:{device}": machine(lies)})
            seen[lies] = page.evaluate(LOOKS, device)
            colour = style(page, f"#device-{device} > .mark", "stroke")
            assert colour != refused, "the colour of what refuses something"
            assert (colour == RED) == (lies == "")
            assert style(page, f"#device-{device} > .mark", "animationName") == "none"
        for one, other in combinations(seen.values(), 2):
            assert one != other
        across = [x[0] != "none" for lies in ("N", "R") for x in seen[lies][1:]]
        kind = page.get_attribute(f"#device-{device}", "data-kind")
        assert across == [kind != "level crossing", kind == "level crossing"], "barriers, a leaf, a cross"
        tell(page, {f"m:{device}": machine("", "R")})
        assert style(page, f"#device-{device} > .mark", "animationName") == "flash"
        for locked in (0, 1):
            tell(page, {f"m:{device}": machine("R", "R", locked)})
            assert (style(page, f"#device-{device} > .lock", "fill") == YELLOW) == bool(locked)
        assert "locked" in str(page.get_attribute(f"#device-{device}", "aria-label"))


def test_a_speed_indicator_stands_at_its_signal(chromium: Any) -> None:
    """It stood nowhere."""
    text = Path("tests/layouts_for_tests/speeds.yaml").read_text("utf-8")
    text = text.replace("principles: {", QUICK.strip().replace("}", ", ").replace("\n", " "))
    with serving(unproved(text)) as (desk, url), closing_pages(chromium) as b:
        page, wrong = opened(b, url)
        release_all(page)
        page.wait_for_selector("#restart", state="hidden")
        assert page.locator("#plan text.speed").count() == 0
        set_route(page, "signal-X2", "signal-X4")
        page.wait_for_selector("#plan text.speed:text-is('40')", state="attached")
        assert page.get_attribute("#plan text.speed", "id") == "speed-g:X2"
        near = page.evaluate("""() => {
            const [a, b] = ["#plan text.speed", "#signal-X2"].map(s => document.querySelector(s).getBBox());
            return Math.hypot(a.x + a.width / 2 - b.x - b.width / 2, a.y - b.y); }""")
        assert near < 60 and page.evaluate(OVERLAPPING.replace(".note'", ".note, .speed'")) == []
        lit = [style(page, f"#signal-{g} .lamp.speed", "fill") for g in ("X2", "X1")]
        assert lit[0] == "rgb(255, 255, 255)" != lit[1], "the triangle of the indicator that is lit, and of no other"
        page.locator("#signal-X2").focus()
        page.keyboard.press("Enter")
        page.wait_for_selector("#acts .lines:has-text(' at 40 km/h')")
        press(page, "Cancel X2-X4")
        is_(page, "#signal-X2", "stop")
        page.wait_for_selector("#plan text.speed", state="detached")
        assert desk.broken == "" and wrong == []


def test_two_yellows_and_the_route_indicator_light_units_of_their_own(chromium: Any) -> None:
    """They were letters beside a signal that was drawn without them."""
    with told(chromium, Path("layouts/cn6502.yaml").read_text("utf-8")) as (page, _):
        units = {"UU": "#signal-X .lamp.second", "B": "#signal-S5 .lamp.indicator"}
        for mark, signal in (("UU", "X"), ("B", "S5")):
            dark = style(page, units[mark], "fill")
            for marks, aspect in ((mark, "caution"), ("", "caution"), (mark, "clear"), ("", "stop")):
                tell(page, {f"g:{signal}": [aspect, 0, None, None, 0, None, marks]})
                lit = {"UU": "rgb(255, 210, 31)", "B": "rgb(255, 255, 255)"}[mark] if marks else dark
                assert style(page, units[mark], "fill") == lit, (mark, marks)
        tell(page, {"g:S5": ["stop", 0, None, None, 1, None, ""]})
        assert style(page, units["B"], "stroke") != "rgb(255, 176, 0)", "the stop lamp is out, not the indicator"


def test_a_signal_that_calls_on_shows_white_beside_its_red(chromium: Any) -> None:
    """Its main lamp turned white, though stop stays lit."""
    with told(chromium, Path("layouts/passing_loop.yaml").read_text("utf-8")) as (page, still):
        calls = [g for g, x in still["signals"].items() if x["calls"]]
        assert sorted(calls) == ["S", "X"]
        for g in calls:
            drawn = {}
            for aspect in ("stop", "call", "clear"):
                tell(page, {f"g:{g}": [aspect, 0, None, None, 0, None]})
                lamp, sign, white = (f"#signal-{g} {x}" for x in (".lamp.main", ".sign.bar", ".caller"))
                drawn[aspect] = [style(page, lamp, "fill"), style(page, sign, "stroke"), style(page, white, "display")]
            assert drawn["call"] == [*drawn["stop"][:2], "inline"] and drawn["stop"][2] == drawn["clear"][2] == "none"
            assert style(page, f"#signal-{g} .caller", "fill") == "rgb(255, 255, 255)"
            tell(page, {f"g:{g}": ["call", 0, None, None, 1, None]})
            assert style(page, f"#signal-{g} .sign.cross", "stroke") == "rgb(255, 176, 0)", "the stop lamp is out"
            tell(page, {f"g:{g}": ["call", 0, None, None, 0, 60]})
        meet = """() => {
            const box = e => e.getBoundingClientRect(), apart = (a, b) => a.right < b.left || a.bottom < b.top;
            const all = [...document.querySelectorAll("#plan text:not(.title), #plan .lamp")].filter(e => box(e).width);
            return [...document.querySelectorAll("#plan .caller")].map(box).flatMap(b =>
                all.filter(e => !apart(b, box(e)) && !apart(box(e), b)).map(e => e.textContent)); }"""
        assert page.evaluate(meet) == []


CUT = """() => [...document.querySelectorAll("header .pill, #rest span, #rest small")]
    .filter(e => e.getClientRects().length).flatMap(e => {
        const all = document.createRange(), s = getComputedStyle(e), b = e.getBoundingClientRect();
        all.selectNodeContents(e);
        const r = all.getBoundingClientRect(), [left, right] = [s.paddingLeft, s.paddingRight].map(parseFloat);
        const over = r.left < b.left + left - 1 || r.right > b.right - right + 1 || e.scrollWidth > e.clientWidth + 1;
        return over ? [e.textContent] : [];
    })"""
"""What runs over its place at the side, or in the head."""

CONTRAST = """([selector, what, behind]) => {
    const linear = x => x <= 0.03928 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4;
    const light = c => c.reduce((sum, x, k) => sum + linear(x / 255) * [0.2126, 0.7152, 0.0722][k], 0);
    const style = e => getComputedStyle(e), rgb = text => text.match(/[\\d.]+/g).map(Number).slice(0, 3);
    const e = document.querySelector(selector), under = rgb(style(document.querySelector(behind)).backgroundColor);
    const dim = Number(style(e).opacity) * Number(style(e.parentElement).opacity);
    const over = rgb(style(e)[what]).map((x, k) => x * dim + under[k] * (1 - dim));
    const [a, b] = [light(over), light(under)].sort((x, y) => y - x);
    return (a + 0.05) / (b + 0.05);
}"""
"""The contrast of something with what lies behind it."""


def test_nothing_at_the_side_is_cut_and_everything_is_bright_enough(chromium: Any) -> None:
    with told(chromium, Path("layouts/pit_bottom.yaml").read_text("utf-8")) as (page, still):
        long = next(c for c, (text, _) in still["conditions"].items() if "clamp" in text)
        heights = set()
        for known in (1, 0, None):
            tell(page, {f"c:{c}": [known] for c in still["conditions"]})
            page.evaluate("v => tell({sys: {...SYS, valid: v, power: v}})", known is not None)
            page.wait_for_selector(f"#rest li:has-text('{long}'):has-text('{still['conditions'][long][0]}')")
            page.wait_for_selector(
                "#rest li:has-text('not known')", state="detached" if known is not None else "attached"
            )
            assert page.evaluate(CUT) == []
            heights.add(page.evaluate("document.querySelector('#rest ul, #rest').scrollHeight"))
        assert len(heights) == 1, "nothing moves"
        page.evaluate("tell({sys: SYS})")
        page.evaluate("document.getElementById('said').innerHTML = '<strong>Refused: </strong><span>a</span>'")
        page.evaluate("document.getElementById('said').classList.add('past')")
        page.evaluate("document.getElementById('test').disabled = true")
        page.evaluate("document.body.dataset.profile = 'cn'")
        fresh(page)
        page.evaluate("tell({alarms: [['a', 'an alarm', [], '2026-01-31T06:00:00', 1, '']]})")
        for field in ("#typed", "#fit"):
            assert page.evaluate(CONTRAST, [field, "borderTopColor", "body"]) > 3, field
        for selector, what, behind in (
            ("#alarms .new b", "color", "#alarms .new"),
            ("#plan text.length", "fill", "#plan svg"),
            ("#said.past span", "color", "body"),
            ("#said.past strong", "color", "body"),
            ("#test", "color", "body"),
        ):
            assert page.evaluate(CONTRAST, [selector, what, behind]) > 4.5, selector
