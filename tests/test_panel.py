"""The panel's desk and server, without a browser: what is asked, refused, told and counted."""

from __future__ import annotations

import errno
import html
import json
import os
import signal
import socket
import threading
import time
from collections.abc import Iterator
from dataclasses import replace
from datetime import datetime
from pathlib import Path
from random import Random
from typing import Any
from xml.sax.saxutils import escape

import pytest
from click.testing import CliRunner
from starlette.testclient import TestClient
from starlette.websockets import WebSocketDisconnect

from interlock.app.reasons import Moment
from interlock.app.run import Ready, run
from interlock.cli.main import cli
from interlock.cli.panel import opened
from interlock.field.alone import InUse
from interlock.panel.asking import ASKED, SWITCHED, in_words
from interlock.panel.clock import MOST_S, Clock
from interlock.panel.desk import Desk
from interlock.panel.event import Event
from interlock.panel.journal import page, trace
from interlock.panel.operating import Person
from interlock.panel.recorder import Recorder
from interlock.panel.server import FILES, Access, application, listening, serve
from interlock.panel.simulated import SimulatedField
from interlock.record.log import Log, read_file
from tests.layouts import SHIPPED
from tests.panels import QUICK, panel, proved, quick, unproved


@pytest.fixture(scope="module")
def ready(tmp_path_factory: pytest.TempPathFactory) -> Ready:
    """Heishan, quick and proved."""
    return proved(quick(tmp_path_factory.mktemp("panel")))


@pytest.fixture(scope="module")
def at_work(ready: Ready) -> Iterator[tuple[Desk, Any]]:
    """A panel that several tests use; each leaves it without routes, trains and faults."""
    with panel(ready) as (desk, browser):
        with browser() as b:
            b.ask("speed", times=10)
            b.released()
        yield desk, browser


def kinds(events: list[dict[str, Any]], kind: str) -> list[str]:
    return [e["text"] for e in events if e["kind"] == kind]


def test_from_request_to_release(at_work: tuple[Desk, Any]) -> None:
    """A route is set, a train is called in by it, every section is released behind it."""
    _, browser = at_work
    with browser(name="Anna") as b:
        assert b.ask("set", route="XB-XI7")["ok"]
        b.until(lambda: b.state["g:XB"][0] == "clear" and b.state["g:XB"][3] == ["XB-XI7", 1])
        assert b.state["s:s2"][:2] == [0, [1]] and b.state["m:P1"][0] == "N" and b.state["m:P1"][2] == 1
        assert b.ask("bring", boundary="W", train="L7", metres=30)["ok"]
        b.until(lambda: b.state["s:s2"][0] == 1)
        assert b.state["g:XB"][0] == "stop"  # the first axle closes it
        b.until(lambda: b.state["s:s6"][0] == 1 and not any(b.state[f"s:{s}"][1] for s in ("s2", "s3")))
        assert [t[0] for t in b.rest["trains"]] == ["L7"] and "s6" in b.rest["trains"][0][4]
        assert "route XB-XI7 is set" in kinds(b.events, "operation") and b.events[-1]["who"] in ("Anna", "")
        assert b.ask("take away", train="L7")["ok"]
        b.until(lambda: b.state["s:s6"][0] == 0)
        assert b.ask("release", section="s6")["ok"]
        b.until(lambda: not b.state["s:s6"][1])


def test_a_refusal_says_why_and_where(at_work: tuple[Desk, Any]) -> None:
    _, browser = at_work
    with browser(name="Bert") as b:
        b.ask("set", route="XI7-XC3")
        b.until(lambda: b.state["g:XI7"][3])
        b.ask("set", route="XT9-XT7")
        b.until(lambda: kinds(b.events, "refusal"))
        told = b.events[-1]["reasons"] if b.events[-1]["kind"] == "refusal" else []
        told = told or next(e["reasons"] for e in b.events if e["kind"] == "refusal")
        assert ["section s7 is locked for route XI7-XC3", ["s:s7"]] in told
        assert "points P3 cannot move: section s7 is locked" in [text for text, _ in told] or len(told) == 1
        refusal = next(e for e in b.events if e["kind"] == "refusal")
        assert len(refusal["rules"]) == len(refusal["reasons"]) and refusal["rules"][0] == "R6"
        assert b.ask("cancel", signal="XI7")["ok"]
        b.until(lambda: not b.state["g:XI7"][3])
        no = b.ask("cancel", signal="XI7")
        assert not no["ok"] and "no route from XI7 is set" in no["why"][0][0]
        b.until(lambda: b.state["m:P3"][:2] == ["R", "R"])  # a block would stop it half-way
        b.ask("block", section="s7", on=True)
        b.ask("fail", kind="section", name="s8_xc3", on=True)
        b.until(lambda: b.state["s:s8_xc3"][0] == 1 and b.state["s:s7"][3] == 1)
        b.events.clear()
        b.ask("set", route="XI7-XC3")
        b.until(lambda: kinds(b.events, "refusal"))
        told = next(e["reasons"] for e in b.events if e["kind"] == "refusal")
        assert sorted(text for text, _ in told) == ["section s7 is blocked", "section s8_xc3 is occupied"]
        b.ask("block", section="s7", on=False)
        b.ask("fail", kind="section", name="s8_xc3", on=False)
        b.until(lambda: b.state["s:s8_xc3"][0] == 0 and b.state["s:s7"][3] == 0)


def test_all_signals_are_put_to_stop_at_once_and_nothing_opens_by_itself(at_work: tuple[Desk, Any]) -> None:
    """Two routes, a voyage whose train is still to come, a request that was just made: nothing of all this goes on."""
    desk, browser = at_work
    with browser(name="Ida") as b:
        b.ask("voyage", name="12:W>s4_xc1")
        b.until(lambda: b.rest["sys"]["voyages"] != [])
        b.ask("set", route="XB-XI7")
        b.until(lambda: b.state["g:XB"][0] == "clear")
        b.ask("set", route="XI9-XC4")
        b.until(lambda: b.state["g:XI9"][0] == "clear")
        b.ws.send_json({"do": "set", "re": 7, "route": "XI7-XC3"})
        b.ask("stop")
        b.until(lambda: b.rest["sys"]["voyages"] == [] and not any(b.state[f"g:{g}"][3] for g in ("XB", "XI9", "XI7")))
        assert "all signals to stop: every route is cancelled, every voyage given up" in kinds(b.events, "operation")
        for _ in range(40):
            b.hear()
            assert [b.state[f"g:{g}"][0] for g in ("XB", "XI9", "XI7")] == ["stop", "stop", "stop"]
        assert not desk.operating.operator.dispatcher.arbiter.waiting
        assert b.ask("set", route="XI9-XC4")["ok"], "what is asked for afterwards is asked for"
        b.until(lambda: b.state["g:XI9"][0] == "clear")
        assert b.ask("stop")["ok"]
        b.until(lambda: not b.state["s:s9"][1])


def test_what_was_asked_for_long_ago_is_not_done_any_more(at_work: tuple[Desk, Any]) -> None:
    """The computer was busy: whoever clicked has seen no answer, and done something else."""
    _, browser = at_work
    with browser(name="Jo") as b:
        late = {"heard": time.time() - 12, "after": 3000}
        no = b.ask("set", route="XI9-XC4", **late)
        assert not no["ok"] and no["why"][0][0] == "it was asked for 9 s ago, and is not done now: ask again"
        assert b.ask("set", route="XI9-XC4", heard=time.time() - 12, after=11_900)["ok"]
        b.until(lambda: b.state["g:XI9"][0] == "clear")
        assert b.ask("cancel", signal="XI9", **late)["ok"], "late is better than never"
        b.until(lambda: not b.state["s:s9"][1])


@pytest.mark.parametrize(
    "more",
    [
        {"heard": "noon", "after": 0},
        {"heard": 10**400, "after": None},
        {"heard": [], "after": {}},
        {"on": 7, "route": 5, "text": 2000 * "x", "alarms": 3},
    ],
    ids=["no number", "too large", "other kinds", "other fields"],
)
def test_stop_is_taken_whatever_stands_beside_it(at_work: tuple[Desk, Any], more: dict[str, Any]) -> None:
    """A time that could not be read, which stop does not ask for, had it refused."""
    _, browser = at_work
    with browser(name="Jo") as b:
        assert b.ask("set", route="XI9-XC4")["ok"]
        b.until(lambda: b.state["g:XI9"][0] == "clear")
        assert b.ask("stop", **more)["ok"]
        b.until(lambda: b.state["g:XI9"][0] == "stop")
        b.until(lambda: not b.state["s:s9"][1])
        assert b.ask("set", route="XI9-XC4")["ok"]
        b.until(lambda: b.state["g:XI9"][0] == "clear")
        times = {k: v for k, v in more.items() if k in ("heard", "after")}
        assert b.ask("cancel", signal="XI9", **times)["ok"], "nor does this ask when it was asked for"
        b.until(lambda: not b.state["s:s9"][1])
        if times:
            assert not b.ask("set", route="XI9-XC4", heard="noon", after=0)["ok"]


def test_points_are_moved_by_hand_and_not_while_they_are_locked(at_work: tuple[Desk, Any]) -> None:
    _, browser = at_work
    with browser() as b:
        lies = b.state["m:P4"][0]
        assert b.ask("turn", machine="P4", to="NR".replace(lies, ""))["ok"]
        b.until(lambda: b.state["m:P4"][0] == "NR".replace(lies, ""))
        b.ask("set", route="XI9-XC4")
        b.until(lambda: b.state["g:XI9"][0] == "clear")
        assert b.state["m:P4"][0] == "N"
        no = b.ask("turn", machine="P4", to="R")
        assert no["why"] == [["P4 cannot be moved: section s9 is locked for route XI9-XC4", ["m:P4", "s:s9"]]]
        b.ask("cancel", signal="XI9")
        b.until(lambda: not b.state["s:s9"][1])
        for _ in range(20):
            b.hear()
        assert b.state["m:P4"][0] == "N", "nothing is kept for later"
        b.ask("block", section="s9", on=True)
        b.until(lambda: b.state["s:s9"][3] == 1)
        assert b.ask("turn", machine="P4", to="R")["ok"], "in a blocked section by hand it moves"
        b.until(lambda: b.state["m:P4"][0] == "R")
        b.ask("block", section="s9", on=False)
        if not b.state["m:P3"][0]:  # it was driven along, and the block has stopped it half-way
            b.ask("turn", machine="P3", to=b.state["m:P3"][1])
            b.until(lambda: b.state["m:P3"][0])
        b.ask("fail", kind="machine", name="P4", on=True)
        b.until(lambda: b.state["m:P4"][0] == "")
        b.events.clear()
        assert b.ask("turn", machine="P4", to="N")["ok"]
        late = "P4 was to be moved normal by hand, and is not detected there after 15 s"
        b.until(lambda: late in kinds(b.events, "note"))
        b.ask("fail", kind="machine", name="P4", on=False)
        b.until(lambda: b.state["m:P4"][0] == "N")
        if b.state["m:P4"][4]:
            b.ask("looked", machine="P4")
            b.until(lambda: not b.state["m:P4"][4])
        b.until(lambda: all(not a[4] for a in b.rest["alarms"]))
        b.ask("acknowledge")


def test_what_a_route_keeps_is_not_released_by_hand_and_a_train_ends_a_release(tmp_path: Path) -> None:
    """It was taken, counted, and armed for ten minutes, even when a train came into the section."""
    slow = quick(tmp_path).read_text("utf-8").replace("release_delay_s: 0.3", "release_delay_s: 2")
    with panel(unproved(slow)) as (desk, browser), browser() as b:
        b.ask("speed", times=10)
        b.released()
        counted = b.rest["sys"]["releases"]
        b.ask("set", route="XB-XI7")
        b.until(lambda: b.state["g:XB"][0] == "clear")
        for s in ("s2", "s3"):
            assert b.ask("release", section=s)["why"] == [["route XB-XI7 is set: cancel it first", ["g:XB"]]]
        b.ask("bring", boundary="W", train="L7", metres=30)
        b.until(lambda: b.state["s:s6"][0] == 1 and not any(b.state[f"s:{s}"][1] for s in ("s2", "s3")))
        b.ask("speed", times=1)
        b.ask("take away", train="L7")
        b.until(lambda: b.state["s:s6"][0] == 0)
        assert b.state["s:s6"][1]
        assert b.ask("release", section="s6")["ok"]
        b.ask("fail", kind="section", name="s6", on=True)
        b.until(lambda: "the release of section s6 is given up: it is occupied" in kinds(b.events, "note"))
        assert not desk.operating.operator.held
        b.ask("fail", kind="section", name="s6", on=False)
        b.until(lambda: b.state["s:s6"][0] == 0)
        assert b.ask("release", section="s6")["ok"]
        b.until(lambda: not b.state["s:s6"][1] and b.rest["sys"]["releases"] == counted + 2)


def test_a_section_without_detection_needs_no_release(tmp_path: Path) -> None:
    """It counts as occupied for ever: after a restart it was the last step, which nobody could ever take."""
    text = Path("layouts/depot.yaml").read_text("utf-8") + QUICK
    with panel(unproved(text)) as (desk, browser), browser() as b:
        published: list[set[str]] = []
        desk.publish = lambda cycle, alarms: published.append(set(alarms))
        b.ask("speed", times=10)
        b.until(lambda: b.rest["sys"]["valid"] and b.rest["sys"]["delay"] == 0)
        assert "wsh" not in b.rest["sys"]["restart"] and "p1" in b.rest["sys"]["restart"]
        assert b.state["s:wsh"][:3] == [1, [], 0]
        told = "section wsh has no detection: it counts as occupied, and needs no release"
        assert b.ask("release", section="wsh")["why"] == [[told, ["s:wsh"]]]
        assert "start" in published[-1]
        assert b.ask("release all")["ok"]
        b.until(lambda: not b.rest["sys"]["restart"])
        b.until(lambda: "start" not in published[-1])
        routes = b.rest["still"]["routes"]
        into = next(r for r in routes if r["exit"][1] in ("wsh", "WASH"))
        out = next(r for r in routes if r["entry"] == "W")
        for r in (into, out):
            b.ask("set", route=r["id"])
            b.until(lambda r=r: f"route {r['id']} is set" in kinds(b.events, "operation"))  # type: ignore[misc]
            b.ask("cancel", signal=r["entry"])
            b.until(lambda r=r: b.state[f"g:{r['entry']}"][3] is None)  # type: ignore[misc]
            b.until(lambda: not b.state["s:p1"][1])
        restart = desk.picture.symbols.sections.restart
        assert desk._last.memory.state[restart["wsh"]], "it is locked all the time"  # type: ignore[index]


def test_the_record_says_what_was_refused_and_which_lamp_failed(lab: tuple[Desk, Any]) -> None:
    """`section s6 is occupied` told nobody what was asked for."""
    _, browser = lab
    with browser() as b:
        b.events.clear()
        b.ask("release", section="g4")
        b.ask("cancel", signal="SA")
        b.ask("turn", machine="6", to="N")
        b.ask("take away", train="nobody")
        b.ask("speed", times=1000)
        b.ask("drive", train="x", go=True)
        b.until(lambda: len(kinds(b.events, "refusal")) == 6)
        assert kinds(b.events, "refusal") == [
            "release section g4: refused: section g4 is not locked",
            "cancel the route from SA: refused: no route from SA is set that a train has not entered",
            "move 6 normal: refused: 6 lies there already",
            "take away train nobody: refused: there is no train nobody",
            "time runs 1000 times as fast: refused: time runs 1, 2, 5, 10, 60 times as fast",
            "let train x go on: refused: there is no train x",
        ]
        lamp = b.rest["still"]["lamps"]["F"]["stop"]
        b.ask("fail", kind="lamp", name=lamp, on=True)
        b.ask("fail", kind="lamp", name=lamp, on=False)
        b.until(lambda: len(kinds(b.events, "operation")) == 2)
        told = ["fault of the stop lamp of F", "fault put right: the stop lamp of F"]
        assert kinds(b.events, "operation") == told


def test_every_command_has_words_for_its_refusal(lab: tuple[Desk, Any]) -> None:
    desk, _ = lab
    for command in every_command(desk.browsers.still):
        told = in_words(command, desk.picture.layout.machines)
        assert command["do"] in {**ASKED, **SWITCHED} and "  " not in told and told


@pytest.fixture(scope="module")
def lab() -> Iterator[tuple[Desk, Any]]:
    """Flank protection, an overlap with two alternatives, a level crossing; each test leaves it without routes."""
    text = Path("layouts/flank_lab.yaml").read_text("utf-8")
    own = next(line for line in text.splitlines() if line.startswith("principles:"))
    with panel(unproved(text.replace(own, QUICK.replace("{", "{lamp_proof: yes, ")))) as (desk, browser):
        with browser() as b:
            b.ask("speed", times=10)
            b.released()
        yield desk, browser


def test_a_move_that_flank_protection_forbids_is_refused_and_a_crossing_always_closes(lab: tuple[Desk, Any]) -> None:
    _, browser = lab
    with browser() as b:
        b.ask("set", route="L5-N8")
        b.until(lambda: b.state["g:L5"][3] == ["L5-N8", 1])
        no = b.ask("turn", machine="1", to="R")["why"][0][0]
        assert no == "1 cannot be moved: 1 is held as flank protection: section w5 is locked for route L5-N8"
        b.ask("cancel", signal="L5")
        b.until(lambda: b.state["g:L5"][3] is None and not b.state["s:w5"][1])
        b.ask("fail", kind="section", name="g4", on=True)
        b.until(lambda: b.state["s:g4"][0] == 1)
        assert b.state["m:LC1"][0] == "N"
        assert b.ask("turn", machine="LC1", to="R")["ok"]
        b.until(lambda: b.state["m:LC1"][0] == "R")
        assert "close level crossing LC1 by hand" in kinds(b.events, "operation")
        no = b.ask("turn", machine="LC1", to="R")["why"][0][0]
        assert no == "level crossing LC1 is closed already"
        b.events.clear()
        no = b.ask("turn", machine="LC1", to="N")["why"][0][0]
        assert no == "level crossing LC1 cannot be opened: section g4 is occupied"
        told = f"open level crossing LC1: refused: {no}"
        b.until(lambda: told in kinds(b.events, "refusal"))
        b.ask("fail", kind="section", name="g4", on=False)
        b.until(lambda: b.state["m:LC1"][0] == "N")


def test_of_a_crossing_and_of_an_overlap_that_swings_it_is_said_what_is_wrong_with_them(lab: tuple[Desk, Any]) -> None:
    """A crossing was `not detected reverse`; of the overlap the alternative that nobody holds was told as well."""
    _, browser = lab
    with browser() as b:
        b.ask("set", route="N2-F")
        b.until(lambda: b.state["g:N2"][0] == "caution")
        assert b.state["o:F.1"] == [1]
        said = {
            "LC1": ["level crossing LC1 is not proved closed", ["m:LC1"]],
            "6": ["the overlap of F: 6 is not detected normal", ["m:6"]],
        }
        for m, why in said.items():
            b.events.clear()
            b.ask("fail", kind="machine", name=m, on=True)
            b.until(lambda: "signal N2 has returned to stop" in kinds(b.events, "alarm"))
            alarm = next(e for e in b.events if e["text"] == "signal N2 has returned to stop")
            assert alarm["reasons"] == [why]
            b.ask("fail", kind="machine", name=m, on=False)
            b.until(lambda m=m: b.state[f"m:{m}"][0])  # type: ignore[misc]
            if b.state[f"m:{m}"][4]:
                b.ask("looked", machine=m)
                b.until(lambda m=m: not b.state[f"m:{m}"][4])  # type: ignore[misc]
            b.ask("set", route="N2-F")
            b.until(lambda: b.state["g:N2"][0] == "caution")
        b.ask("cancel", signal="N2")
        b.until(lambda: b.state["g:N2"][3] is None and not b.state["s:g4"][1] and b.state["o:F.1"] == [0])
        b.ask("acknowledge")


def test_faults_are_alarms_until_they_are_gone_and_seen(at_work: tuple[Desk, Any]) -> None:
    _, browser = at_work
    with browser(name="Cleo") as b:
        b.ask("acknowledge")
        b.ask("set", route="XI9-XC5")
        b.until(lambda: b.state["g:XI9"][0] == "clear")
        b.events.clear()
        b.ask("fail", kind="machine", name="P4", on=True)
        b.until(lambda: b.state["g:XI9"][0] == "stop" and kinds(b.events, "alarm"))
        alarm = next(e for e in b.events if e["kind"] == "alarm")
        assert alarm["text"] == "signal XI9 has returned to stop"
        assert ["P4 is not detected reverse", ["m:P4"]] in alarm["reasons"]
        why = b.ask("why", route="XI9-XC5")["why"]
        assert why[-1][0] == "it has closed once, and opens only when it is asked for again"
        b.ask("fail", kind="machine", name="P4", on=False)
        b.until(lambda: b.state["m:P4"][0] == "R")
        b.ask("set", route="XI9-XC5")
        b.until(lambda: "its signal is asked for again" in b.events[-1]["text"])
        assert ["points P4 were trailed: look at them, and confirm it", ["m:P4"]] in b.events[-1]["reasons"]
        assert b.ask("looked", machine="P4")["ok"]
        b.until(lambda: not b.state["m:P4"][4])
        b.ask("set", route="XI9-XC5")
        b.until(lambda: b.state["g:XI9"][0] == "clear")
        b.ask("cancel", signal="XI9")
        b.until(lambda: not b.state["s:s9"][1])
        b.until(lambda: b.rest["alarms"])
        b.ask("acknowledge")
        b.until(lambda: not b.rest["alarms"])
        assert [e["who"] for e in b.events if e["kind"] == "acknowledged"] in (["Cleo"], ["Cleo", "Cleo"])


def test_a_signal_that_closes_says_what_has_closed_it(at_work: tuple[Desk, Any]) -> None:
    """Not that a delay runs: what it waits for is what has just ended it."""
    _, browser = at_work
    with browser() as b:
        b.ask("set", route="XI9-XC5")
        b.until(lambda: b.state["g:XI9"][0] == "clear")
        b.events.clear()
        b.ask("fail", kind="section", name="s11_xc5", on=True)
        b.until(lambda: kinds(b.events, "alarm"))
        closed = next(e for e in b.events if e["kind"] == "alarm")
        b.ask("fail", kind="section", name="s11_xc5", on=False)
        b.ask("cancel", signal="XI9")
        b.until(lambda: b.state["s:s11_xc5"][0] == 0 and not b.state["s:s9"][1])
        b.ask("acknowledge")
        assert closed["text"] == "signal XI9 has returned to stop"
        assert closed["reasons"] == [["section s11_xc5 is occupied", ["s:s11_xc5"]]]


def test_points_that_nobody_has_commanded_are_supervised_too(ready: Ready) -> None:
    """After a restart nothing is commanded, and the controller supervises what it commands: what loses its detection
    then would be told of only when a route over it is refused."""
    with panel(ready) as (desk, browser), browser() as b:
        published: list[set[str]] = []
        desk.publish = lambda cycle, alarms: published.append(set(alarms))
        b.ask("speed", times=10)
        b.until(lambda: b.rest["sys"]["valid"])
        assert b.state["m:P4"][:2] == ["N", ""]  # never commanded
        b.ask("fail", kind="machine", name="P4", on=True)
        b.until(lambda: b.state["m:P4"][0] == "")
        assert not b.state["m:P4"][3] and not b.rest["alarms"][1:]  # not before the supervision time, 13 s
        b.until(lambda: b.state["m:P4"][3] and b.rest["alarms"][1:])
        assert b.rest["alarms"][1][1:3] == ["P4 is not detected, and was not commanded", ["m:P4"]]
        b.ask("fail", kind="machine", name="P4", on=False)
        b.until(lambda: b.state["m:P4"][0] == "N" and not b.rest["alarms"][1][4])
        assert not b.state["m:P4"][3]
        assert {"start"} in published and {"start", "idle P4"} in published and "idle P4" not in published[-1]


def test_trains_are_put_driven_turned_and_divided(at_work: tuple[Desk, Any]) -> None:
    _, browser = at_work
    with browser() as b:
        assert b.ask("put", section="s10_xc4", towards="XL4", train="A", metres=80)["ok"]
        assert not b.ask("put", section="s10_xc4", towards="XL4", train="B")["ok"]
        b.until(lambda: b.state["s:s10_xc4"][0] == 1)
        b.ask("drive", train="A", go=False)
        b.ask("set", route="XL4-XT9")
        b.until(lambda: b.state["g:XL4"][0] == "clear")
        b.ask("drive", train="A", go=True)
        b.until(lambda: b.rest["trains"] and b.rest["trains"][0][2] == 0 and b.rest["trains"][0][4] == ["s9"])
        assert b.ask("divide", train="A")["ok"]
        b.until(lambda: {t[0] for t in b.rest["trains"]} == {"A", "A.2"})
        assert not b.ask("turn train", train="nobody")["ok"]
        for name in ("A", "A.2"):
            b.ask("take away", train=name)
        b.until(lambda: b.state["s:s9"][0] == 0)
        b.ask("release", section="s9")
        b.until(lambda: not b.state["s:s9"][1])


def test_a_train_that_a_zone_does_not_count_is_told_of(at_work: tuple[Desk, Any]) -> None:
    """Where nothing is locked nothing is counted: one that was put there by hand could be one too many, unsaid."""
    _, browser = at_work
    with browser() as b:
        b.events.clear()
        assert b.state["z:INSIDE"] == [0, []]
        b.ask("put", section="s10_xc4", towards="XL4", train="A", metres=80)
        told = "train A stands in s10_xc4; the limit of zone INSIDE does not count it: nothing is locked there"
        b.until(lambda: told in kinds(b.events, "operation"))
        b.until(lambda: b.state["z:INSIDE"] == [0, ["s10_xc4"]])
        b.ask("put", section="s2_out", towards="XO", train="B", metres=40)
        b.until(lambda: "train B stands in s2_out" in kinds(b.events, "operation"))
        b.ask("set", route="XB-XI7")
        b.until(lambda: b.state["g:XB"][0] == "clear")
        b.ask("put", section="s6", towards="XI7", train="C", metres=40)
        b.until(lambda: "train C stands in s6" in kinds(b.events, "operation") and b.state["s:s6"][0] == 1)
        assert b.state["z:INSIDE"] == [0, ["s10_xc4"]], "what is locked is counted"
        for train in "ABC":
            b.ask("take away", train=train)
        b.until(lambda: b.state["z:INSIDE"] == [0, []])
        all_released(b, "XB")
        b.ask("acknowledge")


def test_two_browsers_see_the_same_and_one_may_only_look(at_work: tuple[Desk, Any]) -> None:
    _, browser = at_work
    with browser(name="one") as a, browser(name="two", look=True) as b:
        assert a.rest["hello"] == {"operates": True} and b.rest["hello"] == {"operates": False}
        assert a.ask("remind", at="g:XB", text="lamp is being changed")["ok"]
        b.until(lambda: "g:XB" in b.rest["reminders"])
        assert b.rest["reminders"]["g:XB"][:2] == ["lamp is being changed", "one"]
        no = b.ask("set", route="XB-XI7")
        assert no == {"re": 7, "ok": False, "why": [["this browser may only look", []]]}
        a.ask("remind", at="g:XB", text="")
        a.ask("block", section="s3", on=True)
        for x in (a, b):
            x.until(lambda x=x: x.state["s:s3"][3] == 1)  # type: ignore[misc]
        a.ask("block", section="s3", on=False)
        b.until(lambda: b.state["s:s3"][3] == 0)


def test_without_power_nothing_is_known_and_then_all_is_locked(at_work: tuple[Desk, Any]) -> None:
    _, browser = at_work
    with browser() as b:
        b.ask("set", route="XB-XI7")
        b.until(lambda: b.state["g:XB"][0] == "clear")
        assert b.ask("power", on=False)["ok"]
        b.until(lambda: b.state["g:XB"][0] == "dark" and b.state["s:s2"][0] == 1)
        assert not b.ask("set", route="XB-XI7")["ok"]
        before = b.rest["sys"]["releases"]
        b.ask("power", on=True)
        b.until(lambda: len(b.rest["sys"]["restart"]) == 11)
        assert "restart delay" in b.ask("release all")["why"][0][0] or b.rest["sys"]["delay"] == 0
        b.released()
        assert b.rest["sys"]["releases"] in (before + 1, before + 2)
        assert b.state["g:XB"][3] is None  # nothing is restored by itself (R16)


AUTOMATIC = f"""
interlock: 1
name: automatic
boundaries: {{W: {{approach: wa 600}}, E: {{approach: ea 600, trains: out}}}}
tracks: {{line: [W, q1 300, q2 300, E]}}
signals: {{A: {{from: W, into: q1}}}}
automatic: [{{from: A, to: E}}]
{QUICK}
"""


def test_blocks_outlast_a_power_cut_and_automatic_working_does_not() -> None:
    """Somebody may work on the track: the operator's place holds a block, whatever becomes of the controller."""
    with panel(unproved(AUTOMATIC)) as (_, browser), browser() as b:
        b.ask("speed", times=10)
        b.released()
        s, r = "q2", "A-E"
        assert b.ask("block", section=s, on=True)["ok"] and b.ask("automatic", route=r, on=True)["ok"]
        b.until(lambda: b.state[f"s:{s}"][3] == 1 and b.state[f"a:{r}"][0] == 1)
        b.ask("power", on=False)
        b.until(lambda: not b.rest["sys"]["power"] and b.state[f"s:{s}"][0] == 1)
        assert b.state[f"s:{s}"][3] == 1, "it is known without power, too"
        b.events.clear()
        b.ask("power", on=True)
        b.until(lambda: b.rest["sys"]["valid"])
        for _ in range(10):
            b.hear()
        assert b.state[f"s:{s}"][3] == 1 and b.state[f"a:{r}"][0] == 0
        assert f"section {s} is still blocked" in kinds(b.events, "note")
        assert b.ask("block", section=s, on=False)["ok"]
        b.until(lambda: b.state[f"s:{s}"][3] == 0)


@pytest.mark.parametrize("name", ["heishan", "passing_loop", ""])
def test_without_power_no_value_of_before_is_left(tmp_path: Path, name: str) -> None:
    """Conditions, zones, directions and automatic working kept what they showed when the power went."""
    text = quick(tmp_path, name).read_text("utf-8") if name else AUTOMATIC
    with panel(unproved(text)) as (desk, browser), browser() as b:
        b.until(lambda: b.rest["sys"]["valid"])
        shown = set(b.state)
        b.ask("power", on=False)
        b.until(lambda: not b.rest["sys"]["power"] and all(v[0] == 1 for k, v in b.state.items() if k[0] == "s"))
        assert shown == set(desk.picture.dark())
        others = {k: v for k, v in b.state.items() if k[0] in "czba"}
        assert others and all(x is None for v in others.values() for x in v)


def test_what_an_overlap_or_flank_protection_holds_is_shown_as_locked(lab: tuple[Desk, Any]) -> None:
    """By locks of routes alone, points in an overlap looked free, and could not be moved."""
    _, browser = lab
    with browser() as b:
        assert b.state["m:6"][2] == 0 and b.state["m:6"][5] == "" and b.state["s:w6"][8] == []
        b.ask("set", route="N2-F")
        b.until(lambda: b.state["o:F.1"][0] and b.state["g:N2"][0] != "stop")
        assert b.state["m:6"][2] == 1 and b.state["m:6"][5] == "overlap 1 of F is held there"
        assert b.state["s:w6"][1] == [] and b.state["s:w6"][8] == ["F"]
        assert b.ask("turn", machine="6", to="R")["why"][0][0] == "6 cannot be moved: overlap 1 of F is held there"
        b.ask("cancel", signal="N2")
        b.until(lambda: b.state["g:N2"][3] is None and not b.state["s:w2"][1] and not b.state["o:F.1"][0])
        b.ask("set", route="L5-N8")
        b.until(lambda: b.state["g:L5"][3] == ["L5-N8", 1])
        why = "1 is held as flank protection: section w5 is locked for route L5-N8"
        assert b.state["s:w1"][1] == [] and b.state["m:1"][2] == 1 and b.state["m:1"][5] == why
        b.ask("cancel", signal="L5")
        b.until(lambda: b.state["g:L5"][3] is None and not b.state["s:w5"][1])
        b.ask("fail", kind="section", name="w1", on=True)
        b.until(lambda: b.state["s:w1"][0] == 1)
        assert b.state["m:1"][2] == 0, "occupied is not locked"
        b.ask("fail", kind="section", name="w1", on=False)
        b.until(lambda: b.state["s:w1"][0] == 0)


def test_where_no_overlap_is_held_there_is_nothing_to_swing(lab: tuple[Desk, Any]) -> None:
    _, browser = lab
    with browser() as b:
        b.events.clear()
        b.ask("swing", signal="F")
        b.until(lambda: kinds(b.events, "refusal"))
        no = next(e for e in b.events if e["kind"] == "refusal")
        assert no["text"] == "the overlap of F does not swing"
        assert no["reasons"] == [["no overlap of F is held: there is nothing to swing", ["g:F"]]]


def test_cancel_switches_automatic_working_off_and_what_is_set_by_itself_is_told() -> None:
    """A route that is cancelled was set again 0.2 s later, and no word of it stood in the record."""
    with panel(unproved(AUTOMATIC)) as (_, browser), browser() as b:
        b.ask("speed", times=10)
        b.released()
        b.ask("automatic", route="A-E", on=True)
        b.until(lambda: b.state["g:A"][0] == "clear")
        b.until(lambda: "route A-E is set, automatically" in kinds(b.events, "operation"))
        assert b.ask("cancel", signal="A")["ok"]
        b.until(lambda: b.state["g:A"][3] is None)
        assert kinds(b.events, "operation")[-1] == "cancel the route from A; it no longer works automatically"
        for _ in range(30):
            b.hear()
        assert b.state["g:A"][3] is None and b.state["a:A-E"] == [0]
        b.events.clear()
        b.ask("set", route="A-E")
        b.until(lambda: b.state["g:A"][0] == "clear")
        b.ask("cancel", signal="A")
        b.until(lambda: b.state["g:A"][3] is None)
        assert kinds(b.events, "operation") == ["route A-E is set", "cancel the route from A"]
        b.ask("block", section="q1", on=True)
        b.ask("automatic", route="A-E", on=True)
        b.events.clear()
        assert b.ask("cancel", signal="A")["ok"], "nothing is set yet, and nothing is to be"
        b.until(lambda: any("cancel" in x for x in kinds(b.events, "operation")))
        assert kinds(b.events, "operation")[-1] == "cancel at A, where none is set; no longer automatic: A-E"


def test_blocks_and_reminders_are_restored_from_the_record_that_is_gone_on_with(ready: Ready, tmp_path: Path) -> None:
    path = tmp_path / "shift.log"
    with panel(ready, recorder=Recorder(path, ready)) as (_, browser), browser(name="Eva") as b:
        b.ask("block", section="s3", on=True)
        b.ask("block", section="s9", on=True)
        b.ask("remind", at="g:XB", text="lamp is being changed")
        b.ask("block", section="s9", on=False)
    for _ in range(2):  # the second time from a record in which it was restored
        with panel(ready, recorder=Recorder(path, ready)) as (_, browser), browser() as b:
            b.until(lambda: b.rest["reminders"].get("g:XB", [])[:2] == ["lamp is being changed", "Eva"])
            b.until(lambda: b.rest["sys"]["valid"] and b.state["s:s3"][3] == 1)
            assert b.state["s:s9"][3] == 0
            assert "section s3 is still blocked" in kinds(b.events, "note")
            b.released()
            b.ask("set", route="XB-XI7")
            b.until(lambda: kinds(b.events, "refusal"))
            assert ["section s3 is blocked", ["s:s3"]] in next(e["reasons"] for e in b.events if e["kind"] == "refusal")
    with panel(ready, recorder=Recorder(path, ready)) as (_, browser), browser() as b:
        b.ask("block", section="s3", on=False)
        b.ask("remind", at="g:XB", text="")
    with panel(ready, recorder=Recorder(path, ready)) as (_, browser), browser() as b:
        b.until(lambda: b.rest["sys"]["valid"])
        assert b.state["s:s3"][3] == 0 and not b.rest["reminders"]


def test_a_block_that_cannot_be_restored_is_an_alarm(ready: Ready, tmp_path: Path) -> None:
    """As where the record goes elsewhere from now on: nobody would look for the block of yesterday."""
    before, after = (tmp_path / f"heishan-20260101-0{n}0000.log" for n in (1, 2))
    with panel(ready, recorder=Recorder(before, ready)) as (_, browser), browser() as b:
        b.ask("block", section="s3", on=True)
    with panel(ready, recorder=Recorder(after, ready)) as (_, browser), browser() as b:
        told = "section s3 was blocked when heishan-20260101-010000.log ended, and is not blocked now: block it again"
        assert told in [a[1] for a in b.rest["alarms"]]
        assert b.state["s:s3"][3] == 0
    with Log.resume(after)[0] as log:
        log.add(0, "kept", blocks=["s99"], reminders={})
    with panel(ready, recorder=Recorder(after, ready)) as (_, browser), browser() as b:
        assert "the block of section s99 cannot be restored: there is no such section" in [
            a[1] for a in b.rest["alarms"]
        ]


def test_a_record_of_before_says_what_is_blocked_in_its_operations(ready: Ready, tmp_path: Path) -> None:
    path = tmp_path / "old.log"
    recorder = Recorder(path, ready)
    for text in ("block section s3", "block section s9", "free section s9"):
        recorder.event(Event("operation", text))
    recorder.close()
    again = Recorder(path, ready)
    assert again.standing.blocks == ("s3",)
    again.close()


def test_a_lost_substation_is_an_alarm_and_closes_everything(at_work: tuple[Desk, Any]) -> None:
    _, browser = at_work
    with browser() as b:
        b.ask("set", route="XB-XI7")
        b.until(lambda: b.state["g:XB"][0] == "clear")
        b.events.clear()
        b.ask("fail", kind="station", name="main", on=True)
        b.until(lambda: not b.rest["sys"]["valid"] and b.state["g:XB"][0] == "stop" and kinds(b.events, "alarm"))
        assert "inputs are not valid: a substation is lost" in json.dumps(b.events)
        assert kinds(b.events, "refusal") == []
        assert not b.ask("set", route="XL1-XT3")["ok"]
        b.ask("fail", kind="station", name="main", on=False)
        b.until(lambda: b.rest["sys"]["valid"])
        b.ask("cancel", signal="XB")
        b.until(lambda: b.state["g:XB"][3] is None)
        if any(b.state[f"s:{s}"][1] for s in ("s2", "s3", "s6")):
            b.ask("release all")
            b.until(lambda: not any(b.state[f"s:{s}"][1] for s in ("s2", "s3", "s6")))


@pytest.fixture(scope="module")
def single_line() -> Iterator[tuple[Desk, Any]]:
    """A passing loop with call-on signals and a direction token; each test leaves it without routes and trains."""
    with panel(unproved(Path("layouts/passing_loop.yaml").read_text("utf-8") + QUICK)) as (desk, browser):
        with browser() as b:
            b.ask("speed", times=10)
            b.released()
        yield desk, browser


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


def test_the_server_says_why_the_detection_of_a_section_is_not_relied_on(single_line: tuple[Desk, Any]) -> None:
    """A page guessed it from what it had seen; one that came later took lost inputs for a train that is called on."""
    _, browser = single_line
    with browser() as b:
        b.ask("set", route="S-S1.c")
        b.until(lambda: b.state["g:S"][0] == "call")
        ways = ("s:IIAG", "s:2DG", "s:IG")
        assert [b.state[s][4] for s in ways] == [2, 2, 2]
        for n in b.rest["still"]["stations"]:
            b.ask("fail", kind="station", name=n, on=True)
        b.until(lambda: not b.rest["sys"]["valid"] and b.state["s:IG"][4] == 1)
        for n in b.rest["still"]["stations"]:
            b.ask("fail", kind="station", name=n, on=False)
        b.until(lambda: b.rest["sys"]["valid"])
        with browser(name="later") as late:
            assert [late.state[s][4] for s in ways] == [1, 1, 1]
        all_released(b, "S")
        assert [b.state[s][4] for s in ways] == [0, 0, 0]


def test_the_special_manual_change_of_direction_is_shown_and_ends(single_line: tuple[Desk, Any]) -> None:
    """Once it was done it was held for ever, unseen: a direction that was lost later was taken back by itself."""
    desk, browser = single_line
    name, held = "the special manual change of direction at W", desk.operating.operator.held
    manual = desk.picture.symbols.token["W"].manual  # type: ignore[index]
    with browser() as b:
        b.events.clear()
        assert b.state["b:W"] == [0, 0, 1, 0, None]
        no = b.ask("direction", boundary="W", on=False)
        assert no["why"] == [[f"{name} is not on", ["b:W"]]]
        assert b.ask("direction", boundary="W", on=True)["ok"]
        b.until(lambda: b.state["b:W"][3] == 1 and 0 < (b.state["b:W"][4] or 0) < 60)
        assert b.ask("direction", boundary="W", on=True)["why"] == [[f"{name} is on already", ["b:W"]]]
        assert b.ask("direction", boundary="W", on=False)["ok"]
        b.until(lambda: b.state["b:W"] == [0, 0, 1, 0, None])
        assert b.ask("direction", boundary="W", on=True)["ok"]
        for on in (True, False):
            b.ask("fail", kind="station", name=b.rest["still"]["stations"][0], on=on)
            b.until(lambda on=on: b.rest["sys"]["valid"] is not on)  # type: ignore[misc]
        lost = f"{name} is given up: inputs are not valid: a substation is lost"
        b.until(lambda: lost in kinds(b.events, "note"))
        assert b.state["b:W"] == [0, 0, 1, 0, None] and manual not in held
        assert b.ask("direction", boundary="W", on=True)["ok"]
        b.until(lambda: b.state["b:W"] == [1, 0, 1, 0, None])
        assert f"{name} is complete, and no longer on: the direction is ours" in kinds(b.events, "note")
        assert manual not in held
        assert b.ask("direction", boundary="W", on=True)["why"] == [["the direction at W is ours", ["b:W"]]]
        b.ask("bring", boundary="W", train="A", metres=40)
        b.until(lambda: b.state["b:W"][0] == 0 and b.state["s:XJG"][0] == 1)
        no = b.ask("direction", boundary="W", on=True)
        assert no["why"] == [["the neighbour at W has the direction", ["b:W"]]]
        b.ask("take away", train="A")
        b.until(lambda: b.state["s:XJG"][0] == 0)
        told = [text for text in kinds(b.events, "operation") if text.startswith("special")]
        told = [text.removeprefix("special manual change of direction at W: ") for text in told]
        assert told == ["on, complete in 60 s", "taken off", "on, complete in 60 s", "on, complete in 60 s"]


def test_a_train_that_is_called_on_passes_its_signal_without_an_alarm(single_line: tuple[Desk, Any]) -> None:
    """`signal S has returned to stop: section IIAG is occupied`; of what else closes it there is an alarm."""
    desk, browser = single_line
    fallen = "signal S has returned to stop"
    with browser() as b:
        b.ask("acknowledge")
        b.events.clear()
        b.ask("set", route="S-S1.c")
        b.until(lambda: b.state["g:S"][0] == "call")
        b.ask("bring", boundary="E", train="A", metres=40)
        b.until(lambda: b.state["g:S"][0] == "stop")
        b.until(lambda: b.state["s:IG"][0] == 1 and b.state["s:2DG"][0] == 0 and b.rest["trains"][0][1] != [])
        assert fallen not in kinds(b.events, "alarm") and "fallen S" not in desk._watch.past
        b.ask("take away", train="A")
        b.until(lambda: b.state["s:IG"][0] == 0)
        all_released(b, "S")
        for what, name in (("section", "IIAG"), ("machine", "2")):  # nobody comes; points that are lost
            b.ask("set", route="S-S1.c")
            b.until(lambda: b.state["g:S"][0] == "call")
            b.events.clear()
            b.ask("fail", kind=what, name=name, on=True)
            b.until(lambda: fallen in kinds(b.events, "alarm"))
            assert b.state["g:S"][0] == "stop" and "fallen S" in desk._watch.past
            b.ask("fail", kind=what, name=name, on=False)
            b.until(lambda: b.state["m:2"][0] and not b.state["s:IIAG"][0])
            if b.state["m:2"][4]:
                b.ask("looked", machine="2")
                b.until(lambda: not b.state["m:2"][4])
            all_released(b, "S")
        b.ask("acknowledge")


def test_of_what_lost_inputs_would_tell_nothing_is_said_but_that_they_are_lost(lab: tuple[Desk, Any]) -> None:
    """Stop lamps were out, and conditions did not hold: of neither was anything known."""
    desk, browser = lab
    with browser() as b:
        b.ask("acknowledge")
        b.ask("set", route="N2-F")
        b.until(lambda: b.state["g:N2"][0] == "caution")
        assert b.state["g:N8"][4] == 0
        b.events.clear()
        stations = b.rest["still"]["stations"]
        for n in stations:
            b.ask("fail", kind="station", name=n, on=True)
        b.until(lambda: not b.rest["sys"]["valid"] and b.state["g:N2"][0] == "stop" and kinds(b.events, "alarm"))
        lost = ["inputs are not valid: a substation is lost", []]
        alarm = next(e for e in b.events if e["text"] == "signal N2 has returned to stop")
        assert alarm["reasons"] == [lost]
        why = b.ask("why", route="N2-F")["why"]
        stale = (
            "section w2: inputs were lost, or a train was called on; cancel the route, or release the section by hand"
        )
        again = ["it has closed once, and opens only when it is asked for again", []]
        assert why == [lost, [stale, ["s:w2"]], again]
        assert [b.state[f"g:{g}"][4] for g in ("N2", "N8", "S1", "F")] == [None] * 4
        moment = Moment(desk._last.inputs, desk._last.memory, 0)
        number = desk.operating.buttons.routes["S1-N8"].number
        told = desk.operating.reasons.of_request(number, moment, desk._last.words()[number])
        assert [r.text for r in told] == lost[:1]
        for n in stations:
            b.ask("fail", kind="station", name=n, on=False)
        b.until(lambda: b.rest["sys"]["valid"])
        assert b.state["g:N8"][4] == 0
        b.ask("cancel", signal="N2")
        b.until(lambda: b.state["g:N2"][3] is None)
        b.until(lambda: not any(b.state[f"s:{s}"][1] for s in ("w2", "g4")) or b.ask("release all"))
        b.until(lambda: not any(b.state[f"s:{s}"][1] for s in ("w2", "g4")) and b.state["o:F.1"] == [0])


@pytest.mark.parametrize(
    "command",
    [
        {"do": "set", "route": "nowhere"},
        {"do": "cancel"},
        {"do": "fly"},
        {"do": "block", "section": ["s3"], "on": 1},
        {"do": "bring", "boundary": "OUT"},
        {"do": "put", "section": "s3", "towards": "XL5"},
        {"do": "put", "section": "s3", "towards": "XT3", "metres": "long"},
        {"do": "speed", "times": 1000},
        {"do": "fail", "kind": "tea", "name": "x", "on": True},
        {"do": "remind", "at": "g:nothing", "text": "x"},
        {"do": "voyage", "name": "none"},
        {"do": "train", "name": "12", "section": "s99"},
        {"do": "train", "name": "12", "section": ""},
        {},
    ],
)
def test_what_cannot_be_done_is_refused_and_nothing_breaks(at_work: tuple[Desk, Any], command: dict[str, Any]) -> None:
    _, browser = at_work
    with browser() as b:
        b.ws.send_json({"re": 7, **command})
        b.until(lambda: b.answers)
        assert b.answers[0]["ok"] is False and b.answers[0]["why"][0][0]


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


def shift(ready: Ready, path: Path) -> None:
    """A short shift with a record: a route, a refusal, a release, an alarm."""
    recorder = Recorder(path, ready)
    with panel(ready, recorder=recorder) as (_, browser), browser(name="Dora") as b:
        b.ask("speed", times=10)
        b.released()
        b.ask("set", route="XB-XI7")
        b.until(lambda: b.state["g:XB"][0] == "clear")
        b.ask("set", route="XL1-XT3")
        b.until(lambda: kinds(b.events, "refusal"))
        b.ask("fail", kind="machine", name="P4", on=True)
        b.until(lambda: any(a[0] == "trailed P4" for a in b.rest["alarms"]) or b.state["m:P4"][0] == "")
        b.ask("cancel", signal="XB")
        b.until(lambda: not b.state["s:s2"][1])


def test_a_shift_is_recorded_printed_and_played(ready: Ready, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "shift.log"
    shift(ready, path)
    found = read_file(path)
    assert found.ended and found.problem is None
    text = page(found)
    assert "route XL1-XT3 is refused" in text and "section s3 is locked for route XB-XI7" in text
    assert "counter 0 before, 1 after" in text and "by Dora" in text and found.chain.digest in text
    states = json.loads(trace(found))["states"]
    proceed = [k for k, s in enumerate(states) if any(v is True and n.startswith("S_R") for n, v in s.items())]
    assert proceed and "route XB-XI7 is set" in " ".join(s["#meta"]["text"] for s in states[: proceed[0] + 1])
    assert not any(v is True and n.startswith("K_") for n, v in states[-1].items())
    for more, file in (([], "shift.html"), (["--journal", "-o", str(tmp_path / "page.html")], "page.html")):
        done = CliRunner().invoke(cli, ["play", str(path), *more])
        assert done.exit_code == 0 and (tmp_path / file).stat().st_size > 1000, done.output
    played = (tmp_path / "shift.html").read_text("utf-8")
    assert "reported occupied" in played and "a train</span>" not in played, "what is reported is no train yet"
    assert "the panel's record, 20" in html.unescape(played) and '<p class="mark"' not in played, "nothing is violated"
    assert all(len(s["#meta"]["text"].split("  ", 1)[1]) > 2 for s in states[:-1]), "every step says what it is"
    for more in (["--from", "tea"], ["--from", "2001-01-01", "--to", "2001-01-02"]):
        assert CliRunner().invoke(cli, ["play", str(path), *more, "-o", str(tmp_path / "x.html")]).exit_code == 1
    shift(ready, path)  # the same file: the count of releases goes on
    again = read_file(path)
    assert "counter 0 before, 2 after" in page(again) and len(again.events) > len(found.events)
    path.write_bytes(path.read_bytes().replace(b"Dora", b"Erna", 1))
    done = CliRunner().invoke(cli, ["play", str(path), "--journal", "-o", str(tmp_path / "x.html")])
    assert done.exit_code == 1 and "something was changed" in done.output
    with pytest.raises(ValueError, match="something was changed"):
        Recorder(path, ready)


def test_nothing_is_left_out_of_a_night_or_where_the_clock_is_set_back(
    ready: Ready, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def recorded(name: str, hours: list[float]) -> Path:
        """One event at each hour after midnight, and the end a minute after the last."""
        now = [datetime(2026, 3, 3).timestamp() + 3600 * hours[0]]
        monkeypatch.setattr("interlock.panel.recorder.time.time", lambda: now[0])
        recorder = Recorder(tmp_path / name, ready)
        for k, hour in enumerate(hours):
            now[0] = datetime(2026, 3, 3).timestamp() + 3600 * hour
            recorder.event(Event("note", f"event {k}"))
        now[0] += 60
        recorder.close()
        return tmp_path / name

    def played(log: Path, *more: str) -> tuple[int, str]:
        made = tmp_path / "page.html"
        done = CliRunner().invoke(cli, ["play", str(log), *more, "-o", str(made)])
        return done.exit_code, made.read_text("utf-8") if done.exit_code == 0 else done.output

    back = recorded("back.log", [8.0, 9.0, 7.0, 7.5])
    for more in ([], ["--journal"]):
        text = played(back, *more)[1]
        assert all(f"event {k}" in text for k in range(4)) and "was set back by 7200 s" in text
    night = recorded("night.log", [22.0, 23.5, 26.0, 29.0])
    text = played(night, "--journal", "--from", "23:00", "--to", "02:30")[1]
    assert [k for k in range(4) if f"event {k}" in text] == [1, 2] and "set back" not in text
    assert played(night, "--from", "23:40", "--to", "23:00") == (1, "error: --to 23:00 is before --from 23:40\n")


def test_a_record_of_something_else_is_not_gone_on_with(ready: Ready, tmp_path: Path) -> None:
    """What is recorded from now on would be told with the plan, and under the digest, of something else."""
    of_a_shift, of_before = tmp_path / "shift.log", tmp_path / "before.log"
    with Log.create(of_a_shift) as log:
        log.add(0, "begin", what="shift", layout="heishan")
    with pytest.raises(ValueError, match=r"shift\.log is no record of a panel: choose another file"):
        Recorder(of_a_shift, ready)
    assert ready.table is not None
    changed = replace(ready, table=replace(ready.table, layout_digest="another"))
    Recorder(of_before, changed).close()
    with pytest.raises(ValueError, match="heishan as it was before its layout was changed: choose another file"):
        Recorder(of_before, ready)
    assert len(read_file(of_a_shift).events) == 1 and len(read_file(of_before).events) == 2


def test_two_panels_do_not_write_one_record(ready: Ready, tmp_path: Path) -> None:
    """Their events would be between each other's, and the digests of neither would hold."""
    path = tmp_path / "one.log"
    path.touch()  # it may be there, and empty
    recorder = Recorder(path, ready)
    with pytest.raises(InUse, match="two may not write the same record"):
        Recorder(path, ready)
    more = ["--panel", "--port", "0", "--record", str(path)]
    done = CliRunner().invoke(cli, ["run", ready.proved.checked.path, *more])
    assert done.exit_code == 2 and "two may not write the same record" in done.output, done.output
    recorder.close()
    Recorder(path, ready).close()
    assert read_file(path).ended


def test_a_record_that_is_moved_away_is_an_alarm_and_begins_anew(
    ready: Ready, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """What goes to a file that nobody can find any more is lost; the new one can be printed and played."""
    now = [100.0]
    monkeypatch.setattr("interlock.panel.recorder.time.monotonic", lambda: now[0])
    recorder = Recorder(tmp_path / "shift.log", ready)
    recorder.cycle(None)
    (tmp_path / "shift.log").rename(tmp_path / "old.log")
    now[0] += 2
    recorder.cycle(None)
    assert "shift.log was moved away or removed" in recorder.lost
    recorder.event(Event("note", "seen meanwhile"))
    now[0] += 2
    recorder.cycle(None)
    recorder.close()
    assert recorder.lost == "" and not read_file(tmp_path / "old.log").ended
    found = read_file(tmp_path / "shift.log")
    assert [e["kind"] for e in found.events] == ["begin", "picture", "gap", "note", "end"]
    assert "seen meanwhile" in page(found) and "set back" not in page(found)
    assert json.loads(trace(found))["states"]


def test_where_nothing_can_be_written_the_panel_works_on_and_nothing_is_lost(
    ready: Ready, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    recorder = Recorder(tmp_path / "full.log", ready)
    write, full = os.write, [False]

    def writes(handle: int, data: bytes) -> int:
        if full[0] and b'"kind"' in data:
            write(handle, data[:9])  # a part of it finds room
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
        return write(handle, data)

    monkeypatch.setattr("interlock.record.log.os.write", writes)
    with panel(ready, recorder=recorder) as (_, browser), browser(name="Fay") as b:
        b.ask("speed", times=10)
        b.released()
        full[0] = True
        b.ask("block", section="s3", on=True)
        b.until(lambda: any(a[0] == "record" for a in b.rest["alarms"]))
        b.ask("block", section="s3", on=False)
        full[0] = False
        b.until(lambda: any(a[0] == "record" and not a[4] for a in b.rest["alarms"]))
    found = read_file(tmp_path / "full.log")
    told = [e.get("text", "") for e in found.events]
    assert found.ended and "block section s3" in told and "free section s3" in told
    assert [e["dropped"] for e in found.events if e["kind"] == "gap"] == [0]


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


def test_why_a_section_cannot_be_blocked_is_told() -> None:
    desk = Desk(unproved(Path("layouts/depot.yaml").read_text("utf-8")))
    answers: list[dict[str, Any]] = []
    for section in ("ap", "sto", "s99"):
        desk.ask(Person("tester", True), {"do": "block", "section": section, "on": True}, answers.append)
    desk._commands()
    assert [a["why"][0][0] for a in answers] == [
        "section ap cannot be blocked: it is an approach section, which no route locks",
        "section sto cannot be blocked: no route and no overlap locks it",
        "there is no such section",
    ]


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


def test_a_command_with_a_locomotive_number_is_carried_out_route_by_route(at_work: tuple[Desk, Any]) -> None:
    _, browser = at_work
    with browser(name="Gus") as b:
        assert "there is no place nowhere" in b.ask("voyage", name="12:W>nowhere")["why"][0][0]
        assert b.ask("voyage", name="12:W>s4_xc1")["ok"]
        b.until(lambda: [v[0] for v in b.rest["sys"]["voyages"]] == ["12"])
        b.ask("bring", boundary="W", train="12", metres=30)
        b.until(lambda: "route XB-XC1 is set" in kinds(b.events, "operation"))
        assert next(e["who"] for e in b.events if "XB-XC1" in e["text"]) == "dispatcher"
        b.until(lambda: not b.rest["sys"]["voyages"])
        assert b.state["s:s4_xc1"][0] == 1
        b.until(lambda: b.rest["sys"]["numbers"] == [["12", ["s4_xc1"]]])
        assert "train 12 is in s2" in kinds(b.events, "note")
        assert b.ask("train", name="14", section="s4_xc1")["ok"]
        b.until(lambda: b.rest["sys"]["numbers"] == [["14", ["s4_xc1"]]])
        b.ask("take away", train="12")
        b.until(lambda: b.state["s:s4_xc1"][0] == 0)
        b.until(lambda: any("train 14: it is lost: s4_xc1 became clear" in a[1] for a in b.rest["alarms"]))


def test_a_train_that_stands_before_the_signal_gets_the_number_of_the_command(ready: Ready) -> None:
    """It was the train from nowhere, and the next one that came in would have borne its number."""
    with panel(ready) as (_, browser), browser(name="Gus") as b:
        b.ask("speed", times=10)
        b.released()
        b.ask("bring", boundary="W", train="x", metres=30)
        b.until(lambda: b.state["s:s1_wait"][0] == 1)
        assert b.ask("voyage", name="12:W>s4_xc1")["ok"]
        b.until(lambda: b.state["s:s4_xc1"][0] == 1 and not b.rest["sys"]["voyages"])
        b.until(lambda: b.rest["sys"]["numbers"] == [["12", ["s4_xc1"]]])
        assert not [a for a in b.rest["alarms"] if a[0].startswith("train")]
        b.ask("bring", boundary="W", train="y", metres=30)
        b.until(lambda: any("no number in s1_wait" in a[1] for a in b.rest["alarms"]))


@pytest.mark.parametrize("metres", [0.2, 0.6, 0.9, 1.2])
def test_a_train_starts_however_far_it_stands_from_where_it_meant_to_stand(metres: float) -> None:
    """Between half a metre and one metre before that place it stood for ever, though its signal was open."""
    ready = proved(Path("layouts/heishan.yaml"))
    assert ready.layout is not None and ready.controller is not None and ready.allocation is not None
    inputs = {i.name: (i.restrictive, i.size or 2) for i in ready.controller.inputs}
    outputs = {o.name: o.restrictive for o in ready.controller.outputs}
    field = SimulatedField(ready.layout, ready.allocation, inputs, outputs, 0.4)
    train, drivers = field.stock.train(field.stock.stand("s7", "XI9", 40.0, "7")), field.world.drivers
    drivers.sight.look(train)
    train.driver.called, train.head = True, train.head + train.view.gap - train.handling.margin - metres
    drivers.sight.look(train)
    clear, *others = drivers.lit[train.view.target]
    field.shown |= {clear: 1} | dict.fromkeys(others, 0)
    for _ in range(300):
        field.step(0.1, {})
    assert train.speed > 1.0 and field.world.track.sections[drivers.track.stretches[train.body[-1]].section] != "s7"


def test_a_train_that_cannot_come_says_why(tmp_path: Path) -> None:
    """After a restart nobody has the direction of a single line: a train before it waits, and no button drives it."""
    with panel(unproved(quick(tmp_path, "passing_loop").read_text("utf-8"))) as (_, browser), browser() as b:
        b.released()
        assert b.ask("bring", boundary="W", metres=40)["ok"]
        b.until(lambda: b.rest["trains"])
        ((name, _, _, _, under, held, _),) = b.rest["trains"]
        assert under == ["before W (the neighbour has not got the direction)"] and held is None
        assert b.ask("take away", train=name)["ok"]
        b.until(lambda: not b.rest["trains"])
