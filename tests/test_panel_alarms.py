"""The panel's alarms: what is wrong, what has closed a signal, and what is said while inputs are lost."""

from __future__ import annotations

import json
from typing import Any

import pytest
from starlette.websockets import WebSocketDisconnect

from interlock.app.reasons import Moment
from interlock.app.run import Ready
from interlock.panel.alarms import MORE, MOST, Alarms
from interlock.panel.desk import Desk
from tests.panels import all_released, kinds, panel


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
        assert b.rest["alarms"][1][1:3] == ["points P4 are not detected, and were not commanded", ["m:P4"]]
        b.ask("fail", kind="machine", name="P4", on=False)
        b.until(lambda: b.state["m:P4"][0] == "N" and not b.rest["alarms"][1][4])
        assert not b.state["m:P4"][3]
        assert {"start"} in published and {"start", "idle P4"} in published and "idle P4" not in published[-1]


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
        assert why == [lost, ["inputs were lost while it was set: cancel it, and set it again", ["s:w2"]]]
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


@pytest.mark.parametrize("count", [100, 900])
def test_all_alarms_are_acknowledged_at_once_however_many(ready: Ready, count: int) -> None:
    """From some eighty on the message was too long for the server, which let the browser go."""
    with panel(ready) as (desk, browser), browser(name="Ann") as b:
        for k in range(count):
            desk.operating.alarms.once(
                f"signal XB has returned to stop {k}", ("g:XB",), "2026-09-21T14:13:20.000+00:00"
            )
        b.until(lambda: any(a[0].endswith(f" {count - 1}") for a in b.rest["alarms"]))
        assert b.ask("acknowledge", alarms=[[a[0], a[3]] for a in b.rest["alarms"]])["ok"]
        b.until(lambda: not [a for a in b.rest["alarms"] if not a[5]])
        with pytest.raises(WebSocketDisconnect):  # whatever else is so long is none of a browser's
            b.ask("remind", at="s:s3", text="x", more=[0] * 5000)


def test_what_happens_again_and_again_is_one_alarm_with_its_count() -> None:
    """A detector that flickered at night left ten thousand alarms, and every message was longer than the last."""
    alarms = Alarms()
    for k in range(3):
        alarms.once("signal XB has returned to stop", ("g:XB",), f"2026-09-21T14:13:2{k}.000+00:00")
        alarms.once("signal XC has returned to stop", ("g:XC",), f"2026-09-21T14:13:2{k}.000+00:00")
    first, second = (a.told() for a in alarms.all.values())
    assert first[1] == "signal XB has returned to stop (3 times since 2026-09-21 14:13:20)"
    assert first[3] == "2026-09-21T14:13:22.000+00:00" and second[2] == ["g:XC"]
    assert not alarms.acknowledge([(first[0], "2026-09-21T14:13:21.000+00:00")], "Ann"), "the last one was not seen"
    assert [a.count for a in alarms.acknowledge([(first[0], first[3])], "Ann")] == [3]
    assert alarms.once("signal XB has returned to stop", ("g:XB",), "").said == "signal XB has returned to stop"


def test_a_cause_that_comes_and_goes_is_counted_and_its_end_is_told() -> None:
    alarms, cause = Alarms(), {"lost main": ("substation main is lost", ())}
    new, over = alarms.stand(cause, "2026-09-21T14:13:20.000+00:00")
    assert len(new) == 1 and not over
    assert alarms.stand({}, "")[1] == new and alarms.stand({}, "") == ([], [])
    ((again,), _) = alarms.stand(cause, "2026-09-21T14:14:20.000+00:00")
    assert again.said == "substation main is lost (2 times since 2026-09-21 14:13:20)" and len(alarms.all) == 1


def test_alarms_of_different_things_have_an_end_too() -> None:
    alarms = Alarms()
    for k in range(MOST + 50):
        alarms.once(f"the bystander sees {k}", (), "2026-09-21T14:13:20.000+00:00")
    assert len(alarms.all) == MOST + 1
    assert list(alarms.all.values())[-1].said == f"{MORE} (50 times since 2026-09-21 14:13:20)"


def test_the_end_of_an_alarm_is_told(ready: Ready) -> None:
    with panel(ready) as (_, browser), browser() as b:
        b.ask("speed", times=10)
        b.released()
        b.ask("fail", kind="station", name="main", on=True)
        b.until(lambda: kinds(b.events, "alarm"))
        b.ask("fail", kind="station", name="main", on=False)
        b.until(lambda: "over: substation main: no answer" in kinds(b.events, "cleared"))


def test_an_alarm_that_came_again_is_not_acknowledged_by_who_saw_it_the_first_time() -> None:
    alarms = Alarms()
    alarms.stand({"x": ("points x are not detected", ())}, "06:00")
    alarms.stand({}, "06:01")
    alarms.stand({"x": ("points x are not detected", ())}, "06:02")
    assert alarms.acknowledge([("x", "06:00")], "Ada") == [] and not alarms.all["x"].by
    (seen,) = alarms.acknowledge([("x", "06:02")], "Ada")
    assert seen.since == "06:02" and alarms.all["x"].by == "Ada"


def test_an_alarm_that_was_acknowledged_is_counted_anew_when_it_comes_again() -> None:
    alarms, cause = Alarms(), {"x": ("points x are not detected", ())}
    alarms.stand(cause, "06:00")
    alarms.acknowledge(None, "Ada")
    alarms.stand({}, "06:01")
    ((again,), _) = alarms.stand(cause, "06:02")
    assert again.said == "points x are not detected" and not again.by
    alarms.once("a train collides", (), "06:03")
    alarms.acknowledge(None, "Ada")
    assert alarms.once("a train collides", (), "06:04").count == 1
