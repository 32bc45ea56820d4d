"""The panel's page in Chromium, for tests: as a process or from this one, looked at and worked with the mouse."""

from __future__ import annotations

import os
import queue
import signal
import statistics
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from functools import partial
from pathlib import Path
from typing import Any, TypeVar

from interlock.app.run import Ready
from interlock.panel.desk import Desk
from interlock.panel.operating import Person
from interlock.panel.server import Access, listening, serve
from tests.browsers import crowding
from tests.panels import large, unproved

Found = TypeVar("Found")

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


TAPPED = """{
    const Real = WebSocket;
    window.sent = [];
    window.WebSocket = class extends Real {
        constructor(url) { super(window.away ? url + '/nowhere' : url); window.socket = this; }
        send(text) {
            const m = JSON.parse(text);
            if (m.do !== "clock") window.sent.push(m);
            if (!window.mute) super.send(text);
        }
        set onmessage(heard) { super.onmessage = e => { if (!window.deaf) heard(e); }; this.heard = heard; }
    };
    window.SYS = {power: true, valid: true, lost: [], restart: [], delay: null, releasing: false, releases: 0, speed: 1,
        minutes: 0, failed: [], voyages: [], numbers: []};
    window.tell = m => window.socket.heard({data: JSON.stringify({c: {}, ...m, t: Date.now() / 1000})});
}"""
"""Keeps what a page sends, but for questions for the clock (nothing leaves it while `mute`, none comes back to the
server while `away`); `tell` is what its server might say to it, who is not heard while `deaf`."""


UNSENT = """{
    const counted = new WeakSet();
    window.unsent = 0;
    new MutationObserver(() => {
        const told = document.querySelector("#said .unsent");
        if (told && !counted.has(told)) { counted.add(told); window.unsent++; }
    }).observe(document, {subtree: true, childList: true});
}"""
"""Counts how often a page has said that nothing was sent."""


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
        self.process.communicate(timeout=60)
        return self.process.returncode


@contextmanager
def serving_process(layout: Path) -> Iterator[Server]:
    """A panel as a process, which is interrupted at the end unless it has ended; what is expected of that end."""
    one = Server(layout)
    try:
        yield one
    finally:
        code = one.end() if one.process.poll() is None else None
    assert code in (130, None), code


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
    page.add_init_script(UNSENT)
    page.add_init_script(script)
    page.goto(url)
    page.wait_for_selector("#plan svg")
    return page, wrong


def click(page: Any, selector: str) -> None:
    """The mouse goes to the middle of something, and clicks, as soon as what is shown is not old, and the plan takes
    clicks."""
    fresh(page)
    is_(page, "#plan", "settling", False)
    box = page.locator(selector).first.bounding_box()
    page.mouse.click(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)


def asked(page: Any, act: Callable[[], Found]) -> Found:
    """Do what asks the server for something, as soon as what is shown is not old, and again where the page says that
    nothing was sent: on a busy computer news are old for a moment, at any time."""
    for _ in range(20):
        fresh(page)
        before = page.evaluate("window.unsent")
        found = act()
        if page.evaluate("window.unsent") == before:
            return found
    raise AssertionError("again and again nothing was sent")


def press(page: Any, name: str) -> None:
    """The mouse clicks the button with that name, as soon as it can be clicked and lies still."""
    asked(page, page.locator(f"button:enabled:has-text({name!r})").first.click)


def release_all(page: Any) -> None:
    """The mouse releases all clear sections, which rests on somebody's word, and says so."""
    press(page, "Release all clear sections")
    press(page, "It is so: release all that is clear")


def typed(page: Any, line: str) -> None:
    """A line is typed below the plan."""

    def enter() -> None:
        page.fill("#typed", line)
        page.press("#typed", "Enter")

    asked(page, enter)


def is_(page: Any, element: str, name: str, on: bool = True) -> None:
    """Wait until an element has a class, or has it not."""
    page.wait_for_selector(f"{element}.{name}" if on else f"{element}:not(.{name})", state="attached")


def fresh(page: Any) -> None:
    """Wait until what is shown is not old: the page sends nothing while it is, and says so."""
    is_(page, "body", "stale", False)


def until(page: Any, so: str) -> None:
    """Wait until an expression is true on a page, whose policy forbids to keep it there."""
    end = time.monotonic() + 40
    while not page.evaluate(so):
        assert time.monotonic() < end, so
        page.wait_for_timeout(50)


def from_to(page: Any, signal: str, end: str) -> None:
    """Click a signal, then where the route ends."""

    def both() -> None:
        click(page, f"#{signal} .reach")
        click(page, f"#{end} .reach")

    asked(page, both)


def set_route(page: Any, signal: str, end: str) -> None:
    """A route is set from a signal; it is asked for again where it is refused for now."""
    log = f"#log li:has-text('route {signal.removeprefix('signal-')}-'):has-text(' is set')"
    before = page.locator(log).count()
    for _ in range(5):
        from_to(page, signal, end)
        page.wait_for_selector(
            f"#{signal}.set, #said > :not(.unsent), :nth-match({log}, {before + 1})", state="attached"
        )
        if page.locator(f"#{signal}.set").count() or page.locator(log).count() > before:
            return
    raise AssertionError(page.inner_text("#said"))


def refused(page: Any, signal: str, end: str, why: str) -> None:
    """A route is asked for, and is refused for that reason; asked for again where nothing is said of it."""
    from playwright import sync_api

    said = page.locator(f"#said:has-text({why!r})")
    for _ in range(5):
        page.keyboard.press("Escape")  # what was said before is said no longer
        from_to(page, signal, end)
        with suppress(sync_api.TimeoutError):
            said.wait_for(timeout=8000)
            return
    raise AssertionError(page.inner_text("#said"))


OVERLAPPING = """() => {
    const box = e => e.getBBox(), all = [...document.querySelectorAll('#plan text:not(.title), #plan .lamp')];
    const meet = (a, b) => a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
    const seen = all.filter(e => box(e).width), told = e => e.textContent || e.closest('[data-key]').dataset.key;
    return seen.filter(e => e.matches('.number, .berth, .note')).flatMap(n =>
        seen.filter(e => e !== n && meet(box(n), box(e))).map(e => n.textContent + ' over ' + told(e)));
}"""
"""What stands on the plan for a while, over a name, a lamp or another."""


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


def changes(chromium: Any) -> tuple[list[float], float]:
    """Milliseconds from the detector to the pixel in a yard of a thousand routes: from what a section reports until the
    browser draws it; and how crowded the computer was meanwhile (`crowding`, its median)."""
    with serving(large()) as (desk, url), closing_pages(chromium) as b:
        page, wrong = opened(b, url)
        fresh(page)
        page.evaluate("new Promise(done => requestIdleCallback(done))")  # the yard is drawn
        page.evaluate(WATCH)
        assert desk.field is not None
        faults, took, crowded = desk.field.faults, list[float](), list[float]()

        def reports(s: str) -> float:
            faults.fail("section", s, True)
            return time.time()

        for s in list(desk.field.stock.places())[:160:4]:
            crowded.append(crowding())
            at = between(desk, partial(reports, s))
            while (seen := page.evaluate(f"window.seen[{'section-' + s!r}] ?? 0")) == 0:
                assert time.time() < at + 40
            took.append(seen - 1000 * at)
        assert wrong == []
        return took, statistics.median(crowded)


@contextmanager
def worked(chromium: Any, path: Path, script: str = "") -> Iterator[tuple[Desk, Any]]:
    """A page of a panel that has gone through its restart, with its desk in this process."""
    with serving(unproved(path.read_text("utf-8"))) as (desk, url), closing_pages(chromium) as b:
        page, wrong = opened(b, url, script)
        release_all(page)
        page.wait_for_selector("#restart", state="hidden")
        yield desk, page
        assert [w for w in wrong if "/nowhere" not in w] == []  # where a test has sent it away


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


def style(page: Any, selector: str, what: str) -> str:
    """How something is drawn at last, while what is shown is not old: then everything is grey."""
    drawn = "(e, what) => document.body.classList.contains('stale') ? '' : getComputedStyle(e)[what]"
    while not (found := str(page.eval_on_selector(selector, drawn, what))):
        fresh(page)
    return found
