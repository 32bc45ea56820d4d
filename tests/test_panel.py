"""The panel's desk and server, without a browser: what is asked for is done, shown and ends."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from interlock.panel.desk import Desk
from tests.panels import AUTOMATIC, kinds, panel, quick, unproved


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
        b.send(do="set", re=7, route="XI7-XC3")
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
