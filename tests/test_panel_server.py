"""The panel's server: tokens, origins, files, ports, its clock, and interrupts."""

from __future__ import annotations

import os
import signal
import socket
import subprocess
import sys
import threading
import time
from pathlib import Path
from random import Random
from typing import Any
from xml.sax.saxutils import escape

import pytest
from click.testing import CliRunner
from starlette.testclient import TestClient
from starlette.websockets import WebSocketDisconnect

from interlock.app.run import Ready, run
from interlock.cli.main import cli
from interlock.cli.panel import opened
from interlock.panel.clock import MOST_S, Clock
from interlock.panel.desk import Desk
from interlock.panel.operating import Person
from interlock.panel.server import FILES, Access, application, listening, serve
from tests.layouts import SHIPPED
from tests.panels import every_command, panel, quick, unproved


def test_tokens_origins_and_rubbish(ready: Ready) -> None:
    with panel(ready, Access("work", "see")) as (_, browser):
        with browser(token="work") as b:
            assert b.rest["hello"]["operates"]
        with browser(token="see") as b:
            assert not b.rest["hello"]["operates"]
        no_token, another = "this panel asks for a token", "this token is none of this panel's"
        for hello, why in (({"token": "wrong"}, another), ({"token": ""}, no_token), ({"name": 3}, no_token)):
            with browser(**hello) as b:
                assert "still" not in b.rest and b.refused == why
                with pytest.raises(WebSocketDisconnect):
                    b.hear()
        with pytest.raises(WebSocketDisconnect), browser(headers={"origin": "http://elsewhere.example"}, token="work"):
            pass
        with browser(headers={"origin": "http://127.0.0.1"}, token="work") as b:
            b.ws.send_text("[" * 3000)
            with pytest.raises(WebSocketDisconnect):
                for _ in range(1000):
                    b.hear()


def test_no_other_name_leads_here_without_a_token(ready: Ready) -> None:
    with panel(ready) as (_, browser):
        with browser(host="localhost:8420", headers={"origin": "http://localhost:8420"}) as b:
            assert b.rest["hello"]["operates"]
        headers = {"origin": "http://elsewhere.example"}  # its name was made to lead to this computer
        with pytest.raises(WebSocketDisconnect), browser(host="elsewhere.example", headers=headers):
            pass


def test_files_are_served_and_nothing_else(ready: Ready) -> None:
    client = TestClient(application(Desk(ready), Access()))
    for path in FILES:
        found = client.get(f"/{path}")
        assert found.status_code == 200 and "default-src 'none'" in found.headers["content-security-policy"]
    assert client.get("/../desk.py").status_code == 404 and client.get("/plan.svg").status_code == 404
    page = client.get("/").text
    assert not [x for x in ("http:", "https:", "//") if x in page]


class Wall:
    """A clock on the wall that goes on by so many seconds with each look at it, and by what is slept."""

    def __init__(self, look_s: float) -> None:
        self.at, self.look_s = 0.0, look_s

    def __call__(self) -> float:
        self.at += self.look_s
        return self.at

    def sleep(self, seconds: float) -> None:
        self.at += seconds


def test_the_clock_is_told_at_once(ready: Ready) -> None:
    """To somebody who only looks, too: by it he knows how old is what he sees."""
    with panel(ready) as (_, browser), browser(name="x", look=True) as b:
        before = time.time()
        answer = b.ask("clock")
        assert before <= answer["clock"] <= time.time() and answer["re"] == 7


def test_simulated_time_runs_faster_and_never_leaps() -> None:
    wall = Wall(0.0)
    clock = Clock(MOST_S, wall, wall.sleep)
    clock.speed = 10
    began = clock.now()
    wall.at += 0.01
    assert clock.now() - began == pytest.approx(0.1)
    wall.at += 5.0
    assert clock.now() - began == clock.now() - began == pytest.approx(MOST_S)
    clock.sleep(0.05)
    wall.at += 5.0  # the process sleeps longer than it asked for
    began, before = clock.now(), began
    assert began - before == pytest.approx(MOST_S)
    clock.sleep(0.2)
    assert clock.now() - began == pytest.approx(0.2)


@pytest.mark.parametrize("cycle_ms", [100, 1000])
def test_a_computer_that_is_busy_slows_the_railway_down_and_no_cycle_is_too_long(ready: Ready, cycle_ms: int) -> None:
    """However often a cycle looks at the clock: inputs that count as lost close every signal, and a train that runs on
    for longer than a scan is said to last is in no section for a scan."""
    desk, wall = Desk(ready, cycle_ms=cycle_ms), Wall(0.3)
    desk.clock = Clock(desk.clock.most_s, wall, wall.sleep)
    desk.clock.speed = 60
    cycles = run(ready, desk.links, cycle_ms, 12, desk._inputs, desk.clock.now, desk.clock.sleep)
    valid, long = [], []
    for cycle, _ in cycles:
        desk._after(cycle)
        valid.append(cycle.valid)
        long.append(desk._dt_ms)
    assert all(valid[2:]) and max(long) <= round(1000 * desk.clock.most_s)
    assert desk.field is not None and desk.field.world.drivers.scan_s == desk.clock.most_s


def test_what_only_a_run_without_panel_has_is_refused(ready: Ready) -> None:
    done = CliRunner().invoke(cli, ["run", ready.proved.checked.path, "--panel", "--port", "0", "--cycles", "3"])
    assert done.exit_code == 2 and "--cycles goes without --panel" in done.output


def test_a_port_in_use_and_a_missing_extra_are_messages(monkeypatch: pytest.MonkeyPatch) -> None:
    with socket.socket() as s:
        s.bind(("127.0.0.1", 0))
        s.listen()
        args = ["run", "layouts/mine11.yaml", "--panel", "--port", str(s.getsockname()[1])]
        done = CliRunner().invoke(cli, args)
        assert done.exit_code == 2 and "the panel cannot listen on 127.0.0.1 port" in done.output
    assert CliRunner().invoke(cli, ["run", "layouts/mine11.yaml"]).exit_code == 2
    monkeypatch.setattr("importlib.util.find_spec", lambda name: None)
    done = CliRunner().invoke(cli, args)
    assert done.exit_code == 2 and "interlock[panel]" in done.output


def test_who_interrupts_twice_is_told_no_traceback_and_all_is_restrictive(
    ready: Ready, capfd: pytest.CaptureFixture[str]
) -> None:
    desk, both = Desk(ready), [signal.SIGINT, signal.SIGINT]
    threading.Timer(0.5, lambda: [os.kill(os.getpid(), s) for s in both]).start()
    serve(desk, Access(), listening("127.0.0.1", 0))
    assert not desk._thread.is_alive() and desk.broken == ""
    assert capfd.readouterr().err == ""


def test_tokens_are_made_where_others_can_reach_the_panel() -> None:
    sock, access = opened("127.0.0.1", 0, "", "")
    sock.close()
    assert access == Access()
    sock, access = opened("0.0.0.0", 0, "", "x")
    sock.close()
    assert len(access.operate) >= 16 and access.look == "x"


def test_everything_of_the_page_is_in_the_package() -> None:
    found = {p.name for p in Path("interlock/panel/page").iterdir()}
    assert found == {name for name, _ in FILES.values()}


@pytest.mark.parametrize("name", SHIPPED)
def test_every_shipped_layout_has_its_panel(name: str) -> None:
    """Everything has its place on the plan (B-04); whatever is asked is done or refused in words."""
    desk = Desk(unproved(Path(f"layouts/{name}.yaml").read_text("utf-8")))
    plan, places = desk.browsers.still["plan"], {"s": "section", "g": "signal"}
    answers: list[dict[str, Any]] = []
    commands = list(every_command(desk.browsers.still))
    Random(name).shuffle(commands)
    cycles = run(desk.ready, desk.links, 400, None, desk._inputs, desk.clock.now, lambda s: None)
    for k, cycle in zip(range(60), (c for c, _ in cycles), strict=False):
        desk._after(cycle)
        for command in commands[k * len(commands) // 59 : (k + 1) * len(commands) // 59]:
            desk.ask(Person("tester", True), command, answers.append)
    for _ in range(len(commands)):  # whoever wants to know why may have waited
        desk._commands()
    cycles.close()
    assert len(answers) == len(commands)
    said = [why for a in answers if not a["ok"] for why, _ in a["why"]]
    assert not [x for x in said if x == "this panel does not know such a command"]
    for key in desk.picture.dark():
        kind, _, element = key.partition(":")
        if kind in places and not desk.browsers.still["sections"].get(element, {}).get("approach"):
            assert f'id="{places[kind]}-{element}"' in plan, key
    for r in desk.browsers.still["routes"]:
        kind, where = r["exit"]
        assert f'id="{kind}-{escape(where)}"' in plan, r


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
