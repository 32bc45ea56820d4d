"""The panel's desk and server, without a browser: what is asked, refused, told and counted."""

from __future__ import annotations

import json
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from interlock.app.reasons import Moment
from interlock.app.run import Ready
from interlock.panel.asking import ASKED, SWITCHED, in_words
from interlock.panel.desk import Desk
from interlock.panel.operating import Person
from tests.panels import QUICK, all_released, every_command, kinds, panel, quick, unproved


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
