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


def test_why_the_detection_of_a_locked_section_is_not_relied_on() -> None:
    """Inputs were lost while it was locked (1), which stays so when they are back, or a train is called on (2); nothing
    is told of a section that is not locked."""
    r = ready("layouts/passing_loop")
    assert r.controller is not None
    y = r.controller.symbols
    route = next(x for x in y.routes if x.call_on)
    section = route.path.ways[-1][0]
    lock, stale = y.sections.locks_of[section][0][1], y.sections.stale[section]
    picture = Picture(r)

    def why(valid: bool, *state: str) -> int:
        cycle = Cycle({}, {}, valid, (), Memory(dict.fromkeys(map(str, state), True), {}))
        told: int = picture.of(cycle)[f"s:{section}"][4]
        return told

    assert why(True, lock) == 0 and why(False, lock, stale) == why(True, lock, stale) == 1
    assert why(True, lock) == 0 and why(True, lock, stale, route.active) == 2
    assert why(True, lock, stale, route.active) == 2 and why(False, lock, stale, route.active) == 1
    assert why(True, stale) == 0
    assert why(True) == 0 and why(True, route.active) == 0 and why(True, lock, stale, route.active) == 1, (
        "the route was active before: it is not for it that the detection is not relied on"
    )


def test_a_section_is_released_when_the_last_of_its_timers_is_over() -> None:
    """The time that is shown is that until its button does something."""
    r = ready("layouts/passing_loop")
    assert r.controller is not None
    y, picture = r.controller.symbols, Picture(r)
    shown = []
    for s, button in y.sections.release.items():
        timers = [t for t in (y.sections.release_timer.get(s),) if t is not None]
        timers += [t for g, t in y.cancellation.approach_timer.items() if y.routes.of_signal[g][0].path.ways[0][0] == s]
        inputs = {str(button): 1, str(y.sections.clear.get(s, "")): 1}
        ran = {str(t): 1000 * k for k, t in enumerate(timers, start=1)}
        seconds = picture.of(Cycle(inputs, {}, True, (), Memory({}, ran)))[f"s:{s}"][5]
        left = [picture.presets[t] / 1000 - k for k, t in enumerate(timers, start=1)]
        assert seconds == (max(left) if left else None), s
        shown.append(len(timers))
    assert max(shown) > 1


def test_a_zone_counts_as_full_where_nothing_is_known_of_it() -> None:
    """And without power nothing at all is told of it, nor of who stands there uncounted."""
    r = ready("layouts/heishan")
    assert r.controller is not None
    zones, picture = [f"z:{z}" for z in r.controller.symbols.zone_full], Picture(r)
    shown, dark = picture.of(Cycle({}, {}, True, (), Memory({}, {}))), picture.dark()
    assert zones and all(shown[z][0] == 1 and dark[z] == [None, None] for z in zones)
    lost = picture.of(Cycle({str(i.name): 0 for i in r.controller.inputs}, {}, False, (), Memory({}, {})))
    assert all(lost[z][1] == [] for z in zones), "while inputs are lost nobody knows who stands there"


def test_a_section_that_is_blocked_stays_so_without_power() -> None:
    r = ready("layouts/heishan")
    assert r.controller is not None
    section = str(next(iter(r.controller.symbols.sections.clear)))
    dark = Picture(r).dark([section])
    assert {k for k, v in dark.items() if k.startswith("s:") and v[3]} == {f"s:{section}"}


def test_a_machine_that_nobody_commanded_is_late_too() -> None:
    r = ready("layouts/heishan")
    assert r.layout is not None
    m, other = list(r.layout.machines)[:2]
    shown = Picture(r).of(Cycle({}, {}, True, (), Memory({}, {})), (f"idle {m}",))
    assert (shown[f"m:{m}"][3], shown[f"m:{other}"][3]) == (1, 0)


def test_a_distant_signal_shows_what_its_lamps_do() -> None:
    """Clear, caution, or dark; never clear where its clear lamp is not lit."""
    r = ready("tests/layouts_for_tests/overlaps_join")
    assert r.controller is not None
    y, picture = r.controller.symbols.aspects, Picture(r)
    distant = next(iter(y.distant_clear))
    clear, caution = str(y.distant_clear[distant]), str(y.distant_caution[distant])
    for lit, said in (({clear: True}, "clear"), ({caution: True}, "caution"), ({}, "dark")):
        assert picture.of(Cycle({}, lit, True, (), Memory({}, {})))[f"g:{distant}"][0] == said
