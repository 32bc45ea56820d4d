"""A panel for tests: Heishan with delays so short that nobody has to wait, and what a browser would say to it."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from functools import partial
from pathlib import Path
from typing import Any

from starlette.testclient import TestClient

from interlock.app.check import Checked
from interlock.app.init import yard
from interlock.app.proved import Proved
from interlock.app.run import Ready, prepare
from interlock.derivation import derive
from interlock.diag import Sink
from interlock.emit.python.runtime import runtime_py
from interlock.frontend import load_text
from interlock.logic.cabinet import allocate
from interlock.logic.expr import interning
from interlock.logic.lower import lower
from interlock.panel.browsers import now_s
from interlock.panel.clock import Clock
from interlock.panel.desk import Desk
from interlock.panel.operating import Person
from interlock.panel.server import Access, application

QUICK = """
principles: {restart_delay_s: 0.8, release_delay_s: 0.3, line_speed_kmh: 20000, braking_ms2: 50000,
             reaction_s: 0.01, output_delay_s: 0.01, approach_release_s: 2}
"""  # trains that stop so soon that the delays may be short

AUTOMATIC = f"""
interlock: 1
name: automatic
boundaries: {{W: {{approach: wa 600}}, E: {{approach: ea 600, trains: out}}}}
tracks: {{line: [W, q1 300, q2 300, E]}}
signals: {{A: {{from: W, into: q1}}}}
automatic: [{{from: A, to: E}}]
{QUICK}
"""
"""A route that may work automatically, on a line without points."""


def quick(folder: Path, name: str = "heishan", more: str = "") -> Path:
    """A shipped layout with short delays, as a file."""
    path = folder / f"{name}.yaml"
    path.write_text(Path(f"layouts/{name}.yaml").read_text("utf-8") + QUICK + more, "utf-8")
    return path


def proved(path: Path) -> Ready:
    """The layout, ready to run."""
    ready = prepare(str(path))
    assert ready.proved.green, ready.proved.checked.diagnostics
    return ready


class Browser:
    """A socket, and what it has been told."""

    def __init__(self, ws: Any) -> None:
        self.ws, self.state, self.rest = ws, {}, {}  # type: Any, dict[str, Any], dict[str, Any]
        self.events: list[dict[str, Any]] = []
        self.answers: list[dict[str, Any]] = []

    def hear(self) -> dict[str, Any]:
        """The next message."""
        m: dict[str, Any] = self.ws.receive_json()
        if "re" in m:
            self.answers.append(m)
            return m
        self.state |= m.get("c", {})
        self.events += m.get("events", [])
        self.refused = m.get("refused", "")
        self.rest |= {k: v for k, v in m.items() if k in ("sys", "alarms", "reminders", "trains", "still", "hello")}
        return m

    def ask(self, do: str, **more: Any) -> dict[str, Any]:
        """A command, and the answer."""
        self.send(do=do, re=7, **more)
        before = len(self.answers)
        self.until(lambda: len(self.answers) > before)
        return self.answers[-1]

    def send(self, **command: Any) -> None:
        """A command, asked for now unless it says something else."""
        self.ws.send_json({"heard": now_s(), "after": 0, **command})

    def until(self, so: Callable[[], Any], seconds: float = 20.0) -> None:
        """Hear messages until something is so."""
        end = time.monotonic() + seconds
        while not so():
            assert time.monotonic() < end, (self.events[-6:], self.rest.get("sys"), self.state)
            self.hear()

    def released(self) -> None:
        """Go through the restart."""
        self.until(lambda: self.rest["sys"]["valid"] and self.rest["sys"]["delay"] == 0)
        assert self.ask("release all")["ok"]
        self.until(lambda: not self.rest["sys"]["restart"])


@contextmanager
def panel(ready: Ready, access: Access | None = None, **more: Any) -> Iterator[tuple[Desk, Callable[..., Any]]]:
    """A desk at work, and a way to open browsers on it."""
    desk = Desk(ready, cycle_ms=50, **more)
    with TestClient(application(desk, access or Access()), base_url="http://127.0.0.1") as client:

        @contextmanager
        def browser(headers: dict[str, str] | None = None, host: str = "127.0.0.1", **hello: Any) -> Iterator[Browser]:
            with client.websocket_connect(f"ws://{host}/talk", headers=headers or {}) as ws:
                ws.send_json(hello or {"name": "first"})
                b = Browser(ws)
                b.hear()
                yield b

        yield desk, browser
    assert desk.broken == ""


@contextmanager
def at_work(ready: Ready) -> Iterator[tuple[Desk, Callable[..., Any]]]:
    """A panel whose time runs ten times as fast, after its restart: several tests use it, and each leaves it without
    routes, trains and faults."""
    with panel(ready) as (desk, browser):
        with browser() as b:
            b.ask("speed", times=10)
            b.released()
        yield desk, browser


def in_cycles(
    desk: Desk,
    cycles: int,
    script: Mapping[int, Sequence[tuple[str, dict[str, Any]]]],
    wall: Callable[[], object] = bool,
) -> list[tuple[str, dict[str, Any]]]:
    """Run so many cycles of a simulated railway as fast as they go, with what people ask for before some of them; who
    was answered what.  `wall` is called after each cycle."""
    now, count, answers = [0.0], [0], list[tuple[str, dict[str, Any]]]()

    def heard(who: str, answer: dict[str, Any]) -> None:
        answers.append((who, answer))

    def sleep(seconds: float) -> None:
        now[0] += seconds
        count[0] += 1
        wall()
        for who, command in script.get(count[0], ()):
            desk.ask(Person(who, True), command, partial(heard, who))
        if count[0] >= cycles:
            desk._stop.set()

    desk.clock = Clock(1.0, lambda: now[0], sleep)
    desk._run()
    assert desk.broken == ""
    return answers


def flank_lab() -> Ready:
    """Flank protection, an overlap with two alternatives, a level crossing, proof of lamps."""
    text = Path("layouts/flank_lab.yaml").read_text("utf-8")
    own = next(line for line in text.splitlines() if line.startswith("principles:"))
    return unproved(text.replace(own, QUICK.replace("{", "{lamp_proof: yes, ")))


def large(tracks: int = 124) -> Ready:
    """A yard of a thousand routes, as if it were proved: nothing here is about its proof."""
    return unproved(yard(tracks))


def unproved(text: str) -> Ready:
    """A layout's text, ready to run as if it were proved."""
    path = "unproved.yaml"
    layout, source = load_text(path, text, sink := Sink())
    assert layout is not None
    table = derive(layout, sink)
    with interning():
        controller = lower(layout, table)
        allocation = allocate(layout, controller)
    proved = Proved(Checked(path, source, ()))
    return Ready(proved, layout, table, controller, allocation, runtime_py(controller, []))


def kinds(events: list[dict[str, Any]], kind: str) -> list[str]:
    """What events of a kind say."""
    return [e["text"] for e in events if e["kind"] == kind]


def all_released(b: Any, *signals: str) -> None:
    """Routes are cancelled, and what they have locked is released, by hand where it must be."""
    for g in signals:
        b.ask("cancel", signal=g)
        b.until(lambda g=g: b.state[f"g:{g}"][3] is None)
    for _ in range(20):
        b.hear()
    if any(v[1] for k, v in b.state.items() if k[0] == "s"):
        assert b.ask("release all")["ok"]
        b.until(lambda: not any(v[1] for k, v in b.state.items() if k[0] == "s"))


def every_command(still: dict[str, Any]) -> Iterator[dict[str, Any]]:
    """Whatever a page could ask for."""
    for r in still["routes"]:
        yield {"do": "set", "route": r["id"]}
        yield {"do": "why", "route": r["id"]}
        if r["automatic"]:
            yield {"do": "automatic", "route": r["id"], "on": True}
    for s, one in still["sections"].items():
        yield {"do": "release", "section": s}
        yield {"do": "block", "section": s, "on": not one["approach"]}
        yield {"do": "block", "section": s, "on": False}
        yield {"do": "fail", "kind": "section", "name": s, "on": one["detected"]}
        yield from ({"do": "put", "section": s, "towards": t, "metres": 10} for t in still["stands"].get(s, ()))
    for m in still["machines"]:
        yield from ({"do": "turn", "machine": m, "to": to} for to in "NR")
        yield {"do": "looked", "machine": m}
        yield {"do": "fail", "kind": "machine", "name": m, "on": True}
    for g in still["signals"]:
        yield {"do": "cancel", "signal": g}
        yield {"do": "swing", "signal": g}
        yield from ({"do": "fail", "kind": "lamp", "name": n, "on": True} for n in still["lamps"].get(g, {}).values())
    for b in still["boundaries"]:
        yield {"do": "bring", "boundary": b}
        yield {"do": "direction", "boundary": b, "on": True}
    yield from ({"do": "voyage", "name": v} for v in still["voyages"])
    yield {"do": "release all"}
    yield {"do": "stop"}
