"""The panel in a real browser (Debian's Chromium, driven by Playwright): worked by mouse, by keys, by two at once."""

from __future__ import annotations

import signal
import time
from pathlib import Path
from typing import Any

import pytest

from tests.pages import (
    OVERLAPPING,
    Server,
    asked,
    click,
    closing_pages,
    fresh,
    is_,
    opened,
    press,
    refused,
    release_all,
    serving,
    set_route,
    typed,
)
from tests.panels import QUICK, unproved
from tests.test_coupled_derailer import SPUR

pytestmark = pytest.mark.external


SHOWN = """[...document.querySelectorAll('#plan [id]')]
    .map(e => [e.id, e.getAttribute('class')?.replace(' chosen', ''), e.textContent].join())"""
"""What the plan shows, but for what is chosen there."""


TURNS_OLD = """() => {
    let before = document.body.classList.contains("stale");
    window.old = before ? Date.now() : Infinity;
    new MutationObserver(() => {
        const now = document.body.classList.contains("stale");
        if (now && !before) window.old = Date.now();
        before = now;
    }).observe(document.body, {attributes: true, attributeFilter: ["class"]});
    let last = performance.now();
    window.longest = 0;
    setInterval(() => {
        const now = performance.now();
        window.longest = Math.max(window.longest, now - last);
        last = now;
    }, 100);
}"""
"""Keeps when a page last said that what it shows is old, and for how long its timers stood still meanwhile: by 0.1 s,
where the computer does nothing else."""


def test_from_request_to_release_by_mouse_alone(chromium: Any, server: Server) -> None:
    with closing_pages(chromium) as b:
        page, wrong = opened(b, server.url)
        for simulated, told in ((True, "let time run faster"), (False, "come to a stand.")):
            delay = "{power: 1, valid: 1, restart: ['s2'], delay: 586, lost: []}"
            still = "{simulated: s, sections: {}}"
            steps = f"async s => (await import('/acts.js')).steps({still}, {{'s:s2': [0]}}, {delay}, () => false)"
            assert told in page.evaluate(steps, simulated)[2][1].rpartition("Trains")[2]
        release_all(page)
        page.wait_for_selector("#restart", state="hidden")
        asked(page, lambda: page.select_option("#speed select", "10"))  # time, not the railway
        click(page, "#signal-XB .reach")
        assert sorted(page.eval_on_selector_all("#plan .exit", "es => es.map(e => e.id)")) == [
            "buffer-XC1",
            "buffer-XC2",
            "signal-XI7",
        ]
        page.keyboard.press("Escape")
        set_route(page, "signal-XB", "signal-XI7")
        is_(page, "#signal-XB", "clear")
        for edge in page.eval_on_selector_all("#plan .locked", "es => es.map(e => e.id)"):
            assert edge.startswith("edge-")
        refused(page, "signal-XB", "buffer-XC1", "section s3 is locked for route XB-XI7")
        click(page, "#boundary-W .reach")  # a train comes when all has been said of the route: it waits for nobody
        press(page, "A train comes in here")
        page.wait_for_selector("#section-s6 .track.occupied", state="attached")
        is_(page, "#signal-XB", "stop")
        page.wait_for_selector("#plan:not(:has(#section-s2 .locked))")
        set_route(page, "signal-XI7", "buffer-XC3")
        page.wait_for_selector("#section-s8_xc3 .track.occupied", state="attached")
        page.wait_for_selector("#plan:not(:has(#section-s3 .locked, #section-s6 .locked, #section-s7 .locked))")
        assert page.locator("#plan .train").count() >= 1
        assert wrong == []


def test_by_keys_alone(chromium: Any, server: Server) -> None:
    with closing_pages(chromium) as b:
        page, wrong = opened(b, server.url)
        release_all(page)
        page.wait_for_selector("#restart", state="hidden")

        def route() -> None:
            page.keyboard.press("Escape")
            page.keyboard.press("/")
            page.keyboard.type("XI7 XC3")
            page.keyboard.press("Enter")

        def cancel() -> None:
            page.get_by_role("button", name="Cancel XI7-XC3").focus()
            page.keyboard.press("Enter")

        asked(page, route)
        is_(page, "#signal-XI7", "clear")
        page.keyboard.press("Escape")
        page.locator("#signal-XI7").focus()
        page.keyboard.press("Enter")
        asked(page, cancel)
        is_(page, "#signal-XI7", "stop")
        for line, said in (("XI7 XB", "none leads from XI7 to XB"), ("12:W>", "write 12:W>E for the way of a train")):
            typed(page, line)
            page.wait_for_selector(f"#said:has-text('{said}')")
        assert page.inner_text("#of") == "signal XI7", "what was typed first is chosen, and not what does not fit"
        page.keyboard.press("Escape")
        page.locator("#signal-XI7").focus()
        before = page.locator("#plan svg").get_attribute("viewBox")
        page.keyboard.press("+")
        assert page.locator("#plan svg").get_attribute("viewBox") != before
        page.keyboard.press("0")
        assert page.locator("#plan svg").get_attribute("viewBox") == before
        click(page, "#test")
        page.wait_for_selector("#said:has-text('lamp test: over')")
        assert wrong == []


def test_two_browsers_agree_and_the_page_outlives_its_server(chromium: Any, server: Server, tmp_path: Path) -> None:
    with closing_pages(chromium) as b:
        one, _ = opened(b, server.url)
        two, _ = opened(b, server.url + "?look")
        release_all(one)
        one.wait_for_selector("#restart", state="hidden")
        set_route(one, "signal-XI9", "buffer-XC5")
        for page in (one, two):
            is_(page, "#signal-XI9", "clear")
        click(one, "#signal-XI9 .reach")
        note = one.locator("[data-mark=note]")
        note.fill("lamp is being changed")
        asked(one, lambda: note.press("Enter"))
        two.wait_for_selector(".note.reminder:has-text('XI9: lamp is being changed')")
        assert two.evaluate(OVERLAPPING) == []
        press(one, "Cancel XI9-XC5")
        for page in (one, two):
            page.wait_for_selector("#plan:not(:has(.locked))")
        click(one, "h1")
        one.keyboard.press("Escape")
        for _ in range(20):  # each is told by messages of its own
            shown = [page.evaluate(SHOWN) for page in (one, two)]
            if shown[0] == shown[1]:
                break
            one.wait_for_timeout(300)
        assert shown[0] == shown[1]
        click(two, "#signal-XI9 .reach")
        assert two.locator("#acts button:enabled").count() == 0
        for page in (one, two):
            page.evaluate(TURNS_OLD)
        began = time.time()
        server.end(signal.SIGKILL)
        for page in (one, two):
            is_(page, "body", "stale")
            assert page.evaluate("window.old - window.longest") - 1000 * began < 2400
        assert "older than a second" in one.inner_text("#grey")
        colours = "ids => ids.map(i => getComputedStyle(document.getElementById(i)).backgroundColor)"
        unknown = one.evaluate("getComputedStyle(document.getElementById('releases')).backgroundColor")
        assert one.evaluate(colours, ["inputs", "power"]) == [unknown] * 2, "what is not known is not green"
        assert one.get_attribute("#title", "title") == one.inner_text("#title"), "a title that is cut is told whole"
        again = Server(tmp_path / "heishan.yaml", server.port)
        try:
            for page in (one, two):
                is_(page, "body", "stale", False)
                page.wait_for_selector("#restart", state="visible")
        finally:
            assert again.end() == 130


@pytest.mark.parametrize("name", ["depot", "crossing_line"])
def test_bridges_and_roads_are_clicked_where_they_lie(chromium: Any, name: str) -> None:
    """In the middle of the frame, where the track runs through it, and of the road."""
    with (
        serving(unproved(Path(f"layouts/{name}.yaml").read_text("utf-8"))) as (desk, url),
        closing_pages(chromium) as b,
    ):
        page, wrong = opened(b, url)
        for machine, one in desk.browsers.still["machines"].items():
            if one["device"]:
                for k in range(page.locator(f"#device-{machine} .reach").count()):
                    click(page, f":nth-match(#device-{machine} .reach, {k + 1})")
                    page.wait_for_selector(f"#of:has-text('{machine}')")
                    page.keyboard.press("Escape")
                    page.wait_for_selector("#of:has-text('Nothing chosen')")
                assert page.locator(f"#device-{machine} .reach").count() > 0
        assert wrong == []


def test_between_two_signals_each_kind_of_route_is_offered(chromium: Any) -> None:
    """The train route was set without a question, and a call-on route only by its name in the list."""
    ready = unproved(Path("layouts/passing_loop.yaml").read_text("utf-8") + QUICK)
    with serving(ready) as (_, url), closing_pages(chromium) as b:
        page, wrong = opened(b, url)
        release_all(page)
        page.wait_for_selector("#restart", state="hidden")
        offered = ["train route S-S1 over IIAG, 2DG, IG", "call-on route S-S1.c over IIAG, 2DG, IG"]
        for again, route in enumerate(offered):

            def choose(route: str = route) -> None:
                page.keyboard.press("Escape")
                click(page, "#signal-S .reach")
                click(page, "#signal-S1 .reach")
                page.wait_for_selector("#said button")
                assert page.locator("#said button").all_inner_texts() == offered
                page.locator(f"#said button:has-text({route!r})").click()

            asked(page, choose)
            is_(page, "#signal-S", "call" if again else "set")
            click(page, "#signal-S .reach")
            press(page, "Cancel")
            is_(page, "#signal-S", "set", False)
            page.wait_for_selector("#plan:not(:has(.locked))")
            page.keyboard.press("Escape")
        set_route(page, "signal-S1", "boundary-W")
        assert page.locator("#said button").count() == 0, "one route needs no choice"
        assert wrong == []


def test_the_ends_of_a_machine_are_names_of_it(chromium: Any) -> None:
    """Only the machine's own was known, which stands on no plan."""
    with serving(unproved(SPUR)) as (_, url), closing_pages(chromium) as b:
        page, wrong = opened(b, url)
        fresh(page)
        for name in ("3", "Vk1", "3/Vk1"):
            typed(page, name)
            page.wait_for_selector("#of:text-is('points 3/Vk1 (3, derailer Vk1)')")
            page.keyboard.press("Escape")
            page.wait_for_selector("#of:has-text('Nothing chosen')")
        assert page.locator("#names option[value='Vk1']").inner_text() == "points 3/Vk1 (3, derailer Vk1)"
        assert wrong == []
