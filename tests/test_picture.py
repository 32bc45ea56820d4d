"""The picture that a panel shows: while inputs are lost, or without power, nothing is known and nothing is green."""

from __future__ import annotations

from functools import cache
from pathlib import Path

import pytest

from interlock.app.run import Ready
from interlock.field.plc import Cycle, Memory
from interlock.model.elements import Position
from interlock.panel.picture import Picture
from tests.panels import unproved


@cache
def ready(name: str) -> Ready:
    """A layout, ready to run as if it were proved."""
    return unproved(Path(f"{name}.yaml").read_text("utf-8"))


NAMES = ["layouts/flank_lab", "layouts/incline_hoist", "layouts/heishan", "tests/layouts_for_tests/token"]


@pytest.mark.parametrize("name", NAMES)
def test_while_inputs_are_lost_every_section_is_occupied_and_no_machine_lies_anywhere(name: str) -> None:
    r = ready(name)
    assert r.controller is not None and r.layout is not None
    well = {str(i.name): 1 for i in r.controller.inputs if not i.size}
    lies = {str(n): int(x is Position.NORMAL) for (_, x), n in r.controller.symbols.machines.detected.items()}
    asked = {str(n): 0 for n in r.controller.symbols.sections.release.values()}
    inputs, memory = {**well, **lies, **asked}, Memory({}, {})
    known = Picture(r).of(Cycle(inputs, {}, True, (), memory))
    lost = Picture(r).of(Cycle(inputs, {}, False, (), memory))
    for s in r.layout.track.sections:
        if f"s:{s.id}" in lost:
            assert lost[f"s:{s.id}"][0] == 1 and lost[f"s:{s.id}"][7] == 0, s.id
            assert known[f"s:{s.id}"][0] == int(not s.detected), s.id
    for m in r.layout.machines:
        assert lost[f"m:{m}"][0] == "" and known[f"m:{m}"][0] == "N", m
    assert all(v == [None] for k, v in lost.items() if k.startswith("c:"))
    assert all(v[2] is None for k, v in lost.items() if k.startswith("b:"))
    assert all(lost[f"g:{g}"][4] is None for g in r.controller.symbols.lamp_proof.stop)
    assert all(v[0] == "dark" for k, v in lost.items() if k.startswith("g:")), "no lamp is lit"


def test_while_inputs_are_lost_no_detector_counts_as_faulty() -> None:
    """That is not known then; the section shows as occupied."""
    text = Path("layouts/flank_lab.yaml").read_text("utf-8")
    r = unproved(text.replace("principles: {", "principles: {sensor_faults: yes, "))
    assert r.controller is not None and r.controller.symbols.sections.healthy
    faulty = {
        valid: {k for k, v in Picture(r).of(Cycle({}, {}, valid, (), Memory({}, {}))).items() if k[:2] == "s:" and v[7]}
        for valid in (True, False)
    }
    assert faulty == {True: {f"s:{s}" for s in r.controller.symbols.sections.healthy}, False: set()}


@pytest.mark.parametrize("name", NAMES)
def test_every_way_that_is_locked_is_shown(name: str) -> None:
    r = ready(name)
    assert r.controller is not None
    several = 0
    for s, locks in r.controller.symbols.sections.locks_of.items():
        state = {str(n): True for _, n in locks}
        shown = Picture(r).of(Cycle({}, {}, True, (), Memory(state, {})))[f"s:{s}"]
        assert shown[1] == [k for k, _ in locks], s
        several += len(locks) > 1
    assert several


@pytest.mark.parametrize("name", NAMES)
def test_without_power_all_is_occupied_and_dark(name: str) -> None:
    shown = Picture(ready(name)).dark(["nothing"])
    assert all(v[0] == 1 for k, v in shown.items() if k.startswith("s:"))
    assert all(v[0] == "dark" for k, v in shown.items() if k.startswith("g:"))
    assert all(v[0] == "" for k, v in shown.items() if k.startswith("m:"))
    assert all(v == [None] for k, v in shown.items() if k.startswith(("c:", "a:")))
