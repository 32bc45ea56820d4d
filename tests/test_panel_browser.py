"""The panel in a real browser (Debian's Chromium, driven by Playwright): worked by mouse, by keys, by two at once."""

from __future__ import annotations

import os
import queue
import signal
import socket
import statistics
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import partial
from itertools import pairwise
from pathlib import Path
from typing import Any

import pytest

from interlock.app.run import Ready
from interlock.panel.desk import Desk
from interlock.panel.operating import Person
from interlock.panel.server import Access, listening, serve
from tests.layouts import SLIPS
from tests.panels import QUICK, large, quick, unproved
from tests.test_coupled_derailer import SPUR

pytestmark = pytest.mark.external

SHOWN = "[...document.querySelectorAll('#plan [id]')].map(e => [e.id, e.getAttribute('class'), e.textContent].join())"


WATCH = """() => {
    window.seen = {};
    const look = all => requestAnimationFrame(() => {
        for (const m of all) {
            const s = m.target.closest('g.section');
            if (s) window.seen[s.id] ??= Date.now();
        }
    });
    const what = {subtree: true, attributes: true, attributeFilter: ['class']};
    new MutationObserver(look).observe(document.querySelector('#plan'), what);
}"""
"""Keeps when the browser drew the first change of each section."""


TURNS_OLD = """() => {
    let before = document.body.classList.contains("stale");
    window.old = before ? Date.now() : Infinity;
    new MutationObserver(() => {
        const now = document.body.classList.contains("stale");
        if (now && !before) window.old = Date.now();
        before = now;
    }).observe(document.body, {attributes: true, attributeFilter: ["class"]});
}"""
"""Keeps when a page last said that what it shows is old."""


TAPPED = """{
    const Real = WebSocket;
    window.sent = [];
    window.WebSocket = class extends Real {
        constructor(url) { super(window.away ? url + '/nowhere' : url); window.socket = this; }
        send(text) { window.sent.push(JSON.parse(text)); if (!window.mute) super.send(text); }
        set onmessage(heard) { super.onmessage = e => { if (!window.deaf) heard(e); }; this.heard = heard; }
    };
    window.SYS = {power: true, valid: true, lost: [], restart: [], delay: null, releasing: false, releases: 0, speed: 1,
        minutes: 0, failed: [], voyages: [], numbers: []};
    window.tell = m => window.socket.heard({data: JSON.stringify({c: {}, ...m, t: Date.now() / 1000})});
}"""
"""Keeps what a page sends (nothing leaves it while `mute`, none comes back to the server while `away`); `tell` is what
its server might say to it, who is not heard while `deaf`."""


class Server:
    """`interlock run --panel` as a process."""

    def __init__(self, layout: Path, port: int = 0) -> None:
        command = [sys.executable, "-m", "interlock", "run", layout.name, "--panel", "--port", str(port)]
        command += ["--record", "panel.log"]
        environment = {**os.environ, "PYTHONPATH": str(Path.cwd()), "INTERLOCK_DEBUG": "1"}
        self.process = subprocess.Popen(
            command, cwd=layout.parent, env=environment, text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE
        )
        assert self.process.stdout is not None
        told = next(line for line in self.process.stdout if line.startswith("panel: "))
        self.url = told.removeprefix("panel: ").strip()
        self.port = int(self.url.rstrip("/").rsplit(":", 1)[1])

    def end(self, how: int = signal.SIGINT) -> int:
        """End it; its exit code."""
        self.process.send_signal(how)
        self.process.communicate(timeout=20)
        return self.process.returncode


@contextmanager
def closing_pages(found: Any) -> Iterator[Any]:
    """A browser whose pages are closed at the end."""
    try:
        yield found
    finally:
        for context in found.contexts:
            context.close()


def opened(found: Any, url: str, script: str = "") -> tuple[Any, list[str]]:
    """A page, and what goes wrong on it; a script that runs before it."""
    page, wrong = found.new_page(viewport={"width": 1500, "height": 900}), list[str]()
    page.set_default_timeout(40_000)
    page.on("console", lambda m: wrong.append(m.text) if m.type == "error" else None)
    page.on("pageerror", lambda e: wrong.append(str(e)))
    page.add_init_script(script)
    page.goto(url)
    page.wait_for_selector("#plan svg")
    return page, wrong


def click(page: Any, selector: str) -> None:
    """The mouse goes to the middle of something, and clicks, as soon as what is shown is not old."""
    fresh(page)
    box = page.locator(selector).first.bounding_box()
    page.mouse.click(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)


def press(page: Any, name: str) -> None:
    """The mouse clicks the button with that name, as soon as it can be clicked and lies still."""
    fresh(page)
    page.locator(f"button:enabled:has-text({name!r})").first.click()


def is_(page: Any, element: str, name: str, on: bool = True) -> None:
    """Wait until an element has a class, or has it not."""
    page.wait_for_selector(f"{element}.{name}" if on else f"{element}:not(.{name})", state="attached")


def fresh(page: Any) -> None:
    """Wait until what is shown is not old: the page sends nothing while it is, and says so."""
    is_(page, "body", "stale", False)


def set_route(page: Any, signal: str, end: str) -> None:
    """Click a signal, then where the route ends; once more where the page says that nothing was done."""
    for _ in range(5):
        click(page, f"#{signal} .reach")
        click(page, f"#{end} .reach")
        page.wait_for_selector(f"#{signal}.set, #said:not(:empty)", state="attached")
        if page.locator(f"#{signal}.set").count():
            return
    raise AssertionError(page.inner_text("#said"))


@pytest.fixture
def server(tmp_path: Path) -> Iterator[Server]:
    """Heishan with short delays."""
    one = Server(quick(tmp_path))
    yield one
    if one.process.poll() is None:
        assert one.end() == 130


def test_from_request_to_release_by_mouse_alone(chromium: Any, server: Server) -> None:
    with closing_pages(chromium) as b:
        page, wrong = opened(b, server.url)
        for simulated, told in ((True, "let time run faster"), (False, "come to a stand.")):
            delay = "{power: 1, valid: 1, restart: ['s2'], delay: 586, lost: []}"
            still = "{simulated: s, sections: {}}"
            steps = f"async s => (await import('/acts.js')).steps({still}, {{'s:s2': [0]}}, {delay}, () => false)"
            assert told in page.evaluate(steps, simulated)[2][1].rpartition("Trains")[2]
        press(page, "Release all clear sections")
        page.wait_for_selector("#restart", state="hidden")
        fresh(page)
        page.select_option("#speed select", "10")  # time, not the railway
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
        click(page, "#signal-XB .reach")
        click(page, "#buffer-XC1 .reach")
        page.wait_for_selector("#said:has-text('section s3 is locked for route XB-XI7')")
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


OVERLAPPING = """() => {
    const box = e => e.getBBox(), all = [...document.querySelectorAll('#plan text:not(.title), #plan .lamp')];
    const meet = (a, b) => a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
    const seen = all.filter(e => box(e).width), told = e => e.textContent || e.closest('[data-key]').dataset.key;
    return seen.filter(e => e.matches('.number, .berth, .note')).flatMap(n =>
        seen.filter(e => e !== n && meet(box(n), box(e))).map(e => n.textContent + ' over ' + told(e)));
}"""
"""What stands on the plan for a while, over a name, a lamp or another."""


def test_numbers_stand_at_their_sections_and_over_no_name(chromium: Any, server: Server) -> None:
    with closing_pages(chromium) as b:
        page, wrong = opened(b, server.url)
        for number, section in (("4711", "s5_xc2"), ("12", "s2"), ("13", "s10_xc4"), ("901", "s7")):
            click(page, f"#section-{section} .track")
            press(page, "Put a train here")
            is_(page, f"#section-{section} .track", "occupied")
            shown = f"#plan text.number[data-of={section}]:has-text({number!r})"
            for _ in range(10):  # refused as long as the describer has not seen that the section is occupied
                fresh(page)
                page.fill("#typed", f"{number}@{section}")
                page.press("#typed", "Enter")
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


def test_by_keys_alone(chromium: Any, server: Server) -> None:
    with closing_pages(chromium) as b:
        page, wrong = opened(b, server.url)
        press(page, "Release all clear sections")
        page.wait_for_selector("#restart", state="hidden")
        page.keyboard.press("/")
        page.keyboard.type("XI7 XC3")
        fresh(page)
        page.keyboard.press("Enter")
        is_(page, "#signal-XI7", "clear")
        page.keyboard.press("Escape")
        page.locator("#signal-XI7").focus()
        page.keyboard.press("Enter")
        page.get_by_role("button", name="Cancel XI7-XC3").focus()
        fresh(page)
        page.keyboard.press("Enter")
        is_(page, "#signal-XI7", "stop")
        for typed, said in (("XI7 XB", "none leads from XI7 to XB"), ("12:W>", "write 12:W>E for the way of a train")):
            page.fill("#typed", typed)
            page.press("#typed", "Enter")
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


MEETING = """() => {
    const all = [...document.querySelectorAll('header > :not([hidden]), #line label, #line button')];
    const boxes = all.map(e => [e.id, e.getBoundingClientRect()]);
    const meet = (a, b) => a.x < b.right - 1 && b.x < a.right - 1 && a.y < b.bottom - 1 && b.y < a.bottom - 1;
    return boxes.flatMap(([n, a], k) => boxes.slice(k + 1).filter(([, b]) => meet(a, b)).map(([m]) => [n, m]));
}"""
"""What of the head, and of the line below the plan, lies over something else."""


def test_on_small_screens_nothing_lies_over_anything_or_is_cut(chromium: Any, server: Server) -> None:
    with closing_pages(chromium) as b:
        page, wrong = opened(b, server.url)
        page.set_viewport_size({"width": 390, "height": 800})
        parts = (
            "['#plan', '#said', '#line', 'aside'].map(x => document.querySelector(x).getBoundingClientRect().toJSON())"
        )
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
        page.wait_for_timeout(200)
        assert page.evaluate(width) < before / 2
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
        page.set_viewport_size({"width": 1280, "height": 760})
        tops = "[...document.querySelectorAll('header > :not([hidden])')].map(e => e.getBoundingClientRect().bottom)"
        assert max(page.evaluate(tops)) < 40, "the head is one line"
        cut = """() => { const b = document.getElementById("steps"), r = b.getBoundingClientRect();
            return [...b.children].filter(e => { const q = e.getBoundingClientRect();
                return q.top < r.top - 1 && q.bottom > r.top + 1; }).map(e => e.textContent); }"""
        page.wait_for_selector("#restart button:enabled")
        page.wait_for_timeout(200)
        assert page.evaluate(cut) == [], "the first step in view is whole"
        assert wrong == []


def test_two_browsers_agree_and_the_page_outlives_its_server(chromium: Any, server: Server, tmp_path: Path) -> None:
    with closing_pages(chromium) as b:
        one, _ = opened(b, server.url)
        two, _ = opened(b, server.url + "?look")
        press(one, "Release all clear sections")
        one.wait_for_selector("#restart", state="hidden")
        click(one, "#signal-XI9 .reach")
        click(one, "#buffer-XC5 .reach")
        for page in (one, two):
            is_(page, "#signal-XI9", "clear")
        click(one, "#signal-XI9 .reach")
        one.locator("[data-mark=note]").fill("lamp is being changed")
        fresh(one)
        one.keyboard.press("Enter")
        two.wait_for_selector(".note.reminder:has-text('XI9: lamp is being changed')")
        assert two.evaluate(OVERLAPPING) == []
        press(one, "Cancel XI9-XC5")
        for page in (one, two):
            page.wait_for_selector("#plan:not(:has(.locked))")
        click(one, "h1")
        one.keyboard.press("Escape")
        one.wait_for_timeout(300)
        assert one.evaluate(SHOWN.replace("'class')", "'class').replace(' chosen', '')")) == two.evaluate(SHOWN)
        click(two, "#signal-XI9 .reach")
        assert two.locator("#acts button:enabled").count() == 0
        for page in (one, two):
            page.evaluate(TURNS_OLD)
        began = time.time()
        server.end(signal.SIGKILL)
        for page in (one, two):
            is_(page, "body", "stale")
            assert page.evaluate("window.old") - 1000 * began < 2500
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


@contextmanager
def serving(ready: Ready) -> Iterator[tuple[Desk, str]]:
    """A desk with a simulated railway, served from a thread of this process; its address."""
    desk, sock = Desk(ready), listening("127.0.0.1", 0)
    host, port = sock.getsockname()
    thread = threading.Thread(target=serve, args=(desk, Access(), sock), daemon=True)
    thread.start()
    try:
        yield desk, f"http://{host}:{port}/"
    finally:
        desk.stop()
        thread.join(10)


def changes(chromium: Any) -> list[float]:
    """Milliseconds from the detector to the pixel in a yard of a thousand routes: from what a section reports until the
    browser draws it."""
    with serving(large()) as (desk, url), closing_pages(chromium) as b:
        page, wrong = opened(b, url)
        page.wait_for_timeout(3000)
        page.evaluate(WATCH)
        assert desk.field is not None
        faults, took = desk.field.faults, []

        def reports(s: str) -> float:
            faults.fail("section", s, True)
            return time.time()

        for s in list(desk.field.stock.places())[:160:4]:
            at = between(desk, partial(reports, s))
            while (seen := page.evaluate(f"window.seen[{'section-' + s!r}] ?? 0")) == 0:
                assert time.time() < at + 10
            took.append(seen - 1000 * at)
        assert wrong == []
        return took


def test_a_button_that_is_held_down_is_clicked_whatever_happens_meanwhile(chromium: Any, tmp_path: Path) -> None:
    """A button that is drawn anew between the press and the release of the mouse would lose the click."""
    with serving(unproved(quick(tmp_path).read_text("utf-8"))) as (desk, url):
        assert desk.field is not None
        with closing_pages(chromium) as b:
            page, wrong = opened(b, url)
            press(page, "Release all clear sections")
            page.wait_for_selector("#restart", state="hidden")
            page.locator("#section-s3").focus()
            page.keyboard.press("Enter")
            middle = page.locator("#acts button:text-is('Block')").bounding_box()
            page.mouse.move(middle["x"] + middle["width"] / 2, middle["y"] + middle["height"] / 2)
            page.mouse.down()
            faults = desk.field.faults
            between(desk, lambda: faults.fail("section", "s3", True))
            page.wait_for_selector("#section-s3 .track.occupied", state="attached")
            page.wait_for_timeout(200)
            fresh(page)
            page.mouse.up()
            page.wait_for_selector("#section-s3 .track.blocked", state="attached")
            page.wait_for_selector("#acts:has-text('occupied'):has-text('blocked'):has-text('Free it again')")
            assert wrong == []


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


@contextmanager
def worked(chromium: Any, path: Path) -> Iterator[tuple[Desk, Any]]:
    """A page of a panel that has gone through its restart, with its desk in this process."""
    with serving(unproved(path.read_text("utf-8"))) as (desk, url), closing_pages(chromium) as b:
        page, wrong = opened(b, url)
        press(page, "Release all clear sections")
        page.wait_for_selector("#restart", state="hidden")
        yield desk, page
        assert wrong == []


def between(desk: Desk, act: Callable[[], Any]) -> Any:
    """Do something where commands are carried out: in the thread of the cycles, between two of them.  From a thread of
    its own a test would change what a cycle is just looking at."""
    done: queue.SimpleQueue[Any] = queue.SimpleQueue()
    desk.ask(Person("test", True), {"do": "no command of the panel"}, lambda _: done.put(act()))
    return done.get(timeout=10)


def over(page: Any, selector: str) -> None:
    """The mouse goes to the middle of something, and stays."""
    box = page.locator(selector).first.bounding_box()
    page.mouse.move(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)


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
        page.locator("#section-s2").focus()
        page.keyboard.press("Enter")
        page.locator(at).first.scroll_into_view_if_needed()
        over(page, at)
        page.wait_for_timeout(600)
        assert page.evaluate(BUTTONS) > 20

        def still(so: str) -> None:
            page.wait_for_selector(so, state="attached", timeout=8000)
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
        for _ in range(2):
            between(desk, lambda: desk._once("the controller starts: every section stays locked until it is released"))
        page.wait_for_selector("#alarms li:nth-child(3)")
        assert (
            page.evaluate("""() => { const b = document.getElementById("alarms").getBoundingClientRect();
            return [...document.querySelectorAll("#alarms li:nth-child(-n+2)")].map(e => e.getBoundingClientRect())
                .filter(r => r.bottom > b.bottom || r.top < b.top).length; }""")
            == 0
        )


WHEN = """([box, word, act]) => new Promise(done => new MutationObserver((_, o) => {
    if (!document.querySelector(box).textContent.includes(word)) return;
    o.disconnect();
    const b = [...document.querySelectorAll(`${box} button`)].find(e => e.textContent.includes(word));
    const r = b?.getBoundingClientRect();
    if (act) document.body.dispatchEvent(new KeyboardEvent("keydown", {key: act, bubbles: true}));
    window.hit = r && document.elementFromPoint(r.x + r.width / 2, r.y + r.height / 2) === b;
}).observe(document.querySelector(box), {subtree: true, childList: true, characterData: true}) ?? done())"""
"""In the moment in which a word appears in a box: presses a key, and keeps whether a click would hit that button."""


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
        over(page, "h1")
        between(desk, lambda: desk._once("first"))
        page.wait_for_selector("#alarms li:has-text('first')")
        page.wait_for_timeout(700)
        over(page, "#alarms li:has-text('first') button")
        fresh(page)
        page.evaluate(WHEN, ["#alarms", "second", "a"])  # it has just come: nobody can have seen it
        between(desk, lambda: desk._once("second"))
        page.wait_for_selector("#alarms li.over:has-text('first')", state="attached")
        page.wait_for_selector("#unseen:has-text('1 new')")
        assert "second" in page.inner_text("#alarms li:not(.over)")
        over(page, "h1")  # the newest comes first when the mouse has left
        page.wait_for_selector("#alarms li:first-child:has-text('second')")


def test_a_change_in_a_yard_of_a_thousand_routes_reaches_the_page_at_once(chromium: Any) -> None:
    took = changes(chromium)
    assert statistics.quantiles(took, n=20)[-1] < 200, took


def test_nothing_is_said_with_a_traceback(tmp_path: Path) -> None:
    path = quick(tmp_path)
    with socket.socket() as s:
        s.bind(("127.0.0.1", 0))
        s.listen()
        command = [sys.executable, "-m", "interlock", "run", str(path), "--panel", "--port"]
        done = subprocess.run(
            [*command, str(s.getsockname()[1])], env={**os.environ, "PYTHONPATH": "."}, capture_output=True, text=True
        )
    assert done.returncode == 2 and "Traceback" not in done.stderr and "cannot listen" in done.stderr


@pytest.mark.parametrize(("said", "points"), [(", single: 1a-2b", 2), ("", 2), (", machines: [7]", 4)])
def test_each_blade_of_a_slip_shows_how_it_lies(chromium: Any, said: str, points: int, tmp_path: Path) -> None:
    path = tmp_path / "slips.yaml"
    path.write_text(SLIPS % said, "utf-8")
    one = Server(path)
    try:
        with closing_pages(chromium) as found:
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
    finally:
        one.end()


FLANK = Path("layouts/flank_lab.yaml")
"""With a derailer, proof of lamps, and a signal that shows caution."""


def style(page: Any, selector: str, what: str) -> str:
    """How something is drawn at last."""
    found: str = page.eval_on_selector(selector, "(e, what) => getComputedStyle(e)[what]", what)
    return found


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
        assert wide[0] == wide[1] and wide[2] == wide[3] >= 1.6 * wide[0]
        page.evaluate("document.getElementById('section-g8').classList.add('chosen', 'shown', 'exit')")
        page.evaluate("tell({c: {'s:g8': [0, [], 0, 0, 0, null, 0, 0]}})")
        assert style(page, "#section-g8 .track", "strokeWidth") == f"{wide[0]:g}px", "pointed at is not occupied"
        assert style(page, "#section-g8 .hit", "stroke") not in ("none", "rgba(0, 0, 0, 0)")
        for blocked in (0, 1):
            page.evaluate("v => tell({c: {'s:g4': v}})", [0, [1], 0, blocked, 0, None, 0, 0])
            assert style(page, "#section-g4 .track", "stroke") == yellow, "blocked, and still seen to be locked"
            assert (style(page, "#section-g4 .block", "stroke") != "none") == bool(blocked)
        for on in (1, 0, 1):
            page.evaluate("on => tell({c: {'a:N8-F': [on], 'a:SA-S1': [on]}})", on)
            assert page.locator("#plan .automatic circle").count() == 2 * on
            assert page.evaluate(OVERLAPPING.replace(".note'", ".note, .automatic text'")) == []
        assert desk.broken == "" and wrong == []


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


def test_a_manual_change_of_direction_stands_on_the_plan(chromium: Any) -> None:
    """Nothing on the page said that it was on."""
    ready = unproved(Path("layouts/passing_loop.yaml").read_text("utf-8") + QUICK)
    with serving(ready) as (_, url), closing_pages(chromium) as b:
        page, wrong = opened(b, url)
        press(page, "Release all clear sections")
        page.wait_for_selector("#restart", state="hidden")
        click(page, "#boundary-W .reach")
        on, off = (page.get_by_role("button", name=f"Special manual change: {x}") for x in ("on", "off"))
        assert off.is_disabled()
        press(page, "Special manual change: on")
        page.wait_for_selector(".note.left:text-matches('^manual change: [1-6][0-9] s$')")
        assert on.is_disabled() and "Special manual change of direction: on, complete in " in page.inner_text("#acts")
        press(page, "Special manual change: off")
        page.wait_for_selector(".note.left", state="detached")
        assert off.is_disabled() and "complete in" not in page.inner_text("#acts")
        assert wrong == []


def test_between_two_signals_each_kind_of_route_is_offered(chromium: Any) -> None:
    """The train route was set without a question, and a call-on route only by its name in the list."""
    ready = unproved(Path("layouts/passing_loop.yaml").read_text("utf-8") + QUICK)
    with serving(ready) as (_, url), closing_pages(chromium) as b:
        page, wrong = opened(b, url)
        press(page, "Release all clear sections")
        page.wait_for_selector("#restart", state="hidden")
        offered = ["train route S-S1 over IIAG, 2DG, IG", "call-on route S-S1.c over IIAG, 2DG, IG"]
        for again, route in enumerate(offered):
            click(page, "#signal-S .reach")
            click(page, "#signal-S1 .reach")
            page.wait_for_selector("#said button")
            assert page.locator("#said button").all_inner_texts() == offered
            press(page, route)
            is_(page, "#signal-S", "call" if again else "set")
            click(page, "#signal-S .reach")
            press(page, "Cancel")
            is_(page, "#signal-S", "set", False)
            page.wait_for_selector("#plan:not(:has(.locked))")
            page.keyboard.press("Escape")
        click(page, "#signal-S1 .reach")
        click(page, "#boundary-W .reach")
        is_(page, "#signal-S1", "set")
        assert page.locator("#said button").count() == 0, "one route needs no choice"
        assert wrong == []


def test_what_was_asked_and_what_is_said_of_it(chromium: Any, tmp_path: Path) -> None:
    """One page, whose messages are held back or made up: requests without an answer, reasons that are past."""
    with serving(unproved(quick(tmp_path).read_text("utf-8"))) as (desk, url), closing_pages(chromium) as b:
        page, wrong = opened(b, url, TAPPED)
        press(page, "Release all clear sections")
        page.wait_for_selector("#restart", state="hidden")
        fresh(page)
        page.evaluate("window.mute = true")
        before = time.time()
        page.locator("#stop").click()
        asked = page.evaluate("sent.at(-1)")
        assert asked["do"] == "stop" and abs(asked["heard"] + asked["after"] / 1000 - before) < 1, "when it was clicked"
        page.wait_for_selector("#grey:has-text('Sent 1 s ago, no answer yet')")
        page.evaluate("window.away = true, socket.close()")
        page.wait_for_selector("#said:has-text('not known whether it was done: look at the plan')")
        count = page.evaluate("window.mute = false, sent.length")
        page.evaluate("document.getElementById('stop').click()")
        page.wait_for_selector("#said:has-text('nothing was sent')")
        page.wait_for_timeout(300)
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
        page.wait_for_timeout(200)
        assert page.locator("#said.past").count() == 0 and page.locator("#plan .shown").count() > 0
        page.evaluate("tell({c: {'s:s3': [1, [], 0, 0, 0, null, 0, 0]}})")
        page.wait_for_selector("#said.past")
        assert page.locator("#plan .shown").count() == 0
        page.evaluate("tell({c: {'s:s3': [0, [], 0, 0, 0, null, 0, 0], 's:s9': [0, [], 0, 0, 0, null, 0, 0]}})")
        desk.power = False
        is_(page, "#power", "bad")
        said = page.locator("#said:not(.past):has-text('the controller has no power')")
        for turn in range(200):  # asked again where nothing was sent, or what was said is past already: a busy computer
            if said.count():
                break
            if turn % 40 == 0:
                page.keyboard.press("Escape")
                click(page, "#signal-XB .reach")
                click(page, "#buffer-XC1 .reach")
            page.wait_for_timeout(100)
        assert said.count() == 1, page.inner_text("#said")
        desk.power = True
        page.wait_for_selector("#said.past")
        page.fill("#typed", "  ")
        page.press("#typed", "Enter")
        away = [w for w in wrong if "/nowhere" in w]  # one for each time it tried to come back meanwhile
        assert desk.broken == "" and away == wrong


def test_the_ends_of_a_machine_are_names_of_it(chromium: Any) -> None:
    """Only the machine's own was known, which stands on no plan."""
    with serving(unproved(SPUR)) as (_, url), closing_pages(chromium) as b:
        page, wrong = opened(b, url)
        fresh(page)
        for name in ("3", "Vk1", "3/Vk1"):
            page.fill("#typed", name)
            page.press("#typed", "Enter")
            page.wait_for_selector("#of:text-is('points 3/Vk1 (3, derailer Vk1)')")
            page.keyboard.press("Escape")
            page.wait_for_selector("#of:has-text('Nothing chosen')")
        assert page.locator("#names option[value='Vk1']").inner_text() == "points 3/Vk1 (3, derailer Vk1)"
        assert wrong == []


@pytest.mark.parametrize(
    ("profile", "stop"), [("uk", "rgb(255, 59, 59)"), ("de", "rgb(255, 59, 59)"), ("cn", "rgb(53, 104, 201)")]
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
