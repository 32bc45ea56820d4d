"""Trains on the panel: put, driven, commanded by number, and why one cannot come."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from interlock.app.run import Ready
from interlock.panel.desk import Desk
from interlock.panel.simulated import SimulatedField
from tests.panels import all_released, kinds, panel, proved, quick, unproved


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
