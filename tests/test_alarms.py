"""Alarms scan by scan, on a layout that has every lamp, a siding without detection and a call-on: what stands, and what
does not."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from interlock.app.alarms import START, Watch, possible, to_release
from interlock.field.plc import Cycle, Memory
from interlock.logic.cabinet import allocate
from interlock.logic.lower import lower
from interlock.logic.symbols import Symbols
from interlock.model.elements import Position
from tests.layouts import built, grown


def watching(name: str) -> tuple[Watch, Symbols, Any]:
    layout, _, controller = built(name)
    return Watch(layout, controller, allocate(layout, controller)), controller.symbols, layout


def at_rest(y: Symbols) -> dict[str, int]:
    """Inputs by which all is well."""
    lamps = y.lamp_proof
    well = [*y.sections.clear.values(), *y.sections.healthy.values()]
    for of in (lamps.stop, lamps.clear, lamps.caution, lamps.second, lamps.identifier, lamps.speed):
        well += of.values()
    well += [n for (_, x), n in y.machines.detected.items() if x is Position.NORMAL]
    return {str(n): 1 for n in well}


def scan(watch: Watch, inputs: dict[str, int], valid: bool = True, dt_ms: int = 2000, **state: bool) -> set[str]:
    watch.after(Cycle(inputs, {}, valid, (), Memory(state, {})), dt_ms)
    return {*watch.causes, *watch.past}


@pytest.mark.parametrize("name", ["layouts/flank_lab", "layouts/cn6502", "tests/layouts_for_tests/identifier"])
def test_every_lamp_that_is_reported_and_every_detector_that_is_has_its_alarm(name: str) -> None:
    """Found by the inputs themselves, not by the list of alarms."""
    text = Path(f"{name}.yaml").read_text("utf-8")
    made = grown(text.replace("principles: {", "principles: {sensor_faults: yes, "))
    assert made is not None
    controller = lower(made[0], made[1])
    watch, y = Watch(made[0], controller, allocate(made[0], controller)), controller.symbols
    assert y.sections.healthy or "cn6502" in name
    lies = {str(n) for n in (*y.sections.clear.values(), *y.machines.detected.values())}
    reports = at_rest(y).keys() - lies
    assert reports and scan(watch, at_rest(y)) == set()
    for n in reports:
        (found,) = scan(watch, {**at_rest(y), n: 0})
        assert found.startswith(("detector ", "speed indicator ")) or " lamp " in found, (n, found)


def test_while_inputs_are_lost_nothing_is_said_of_lamps_and_detectors() -> None:
    watch, _, _ = watching("flank_lab")
    assert scan(watch, {}, valid=False) == set()


def test_a_siding_without_detection_keeps_no_restart_alarm_standing() -> None:
    layout, _, controller = built("../tests/layouts_for_tests/undetected")
    y, hidden = controller.symbols, layout.track.undetected
    assert hidden and hidden & set(y.sections.restart), "a lock since the restart that nobody ever releases"
    assert not hidden & set(to_release(layout, y))
    watch = Watch(layout, controller, allocate(layout, controller))
    left = {str(y.sections.restart[s]): True for s in hidden if s in y.sections.restart}
    assert START not in scan(watch, at_rest(y), **left)


def test_the_start_stands_until_the_last_section_is_released() -> None:
    watch, y, layout = watching("depot")
    locks = [str(n) for n in to_release(layout, y).values()]
    for k in range(len(locks)):
        assert START in scan(watch, at_rest(y), **dict.fromkeys(locks[k:], True))
    assert START not in scan(watch, at_rest(y))


def test_points_that_are_commanded_one_way_are_supervised_by_the_controller_alone() -> None:
    watch, y, _ = watching("depot")
    m, command = next((m, n) for (m, x), n in y.machines.command.items() if x is Position.REVERSE)
    lost = {**at_rest(y), **{str(n): 0 for (o, _), n in y.machines.detected.items() if o == m}}
    assert f"idle {m}" not in scan(watch, lost, dt_ms=1_000) | scan(watch, lost, dt_ms=600_000, **{str(command): True})
    assert f"idle {m}" in scan(watch, lost, dt_ms=1_000) | scan(watch, lost, dt_ms=600_000)


def test_a_signal_that_falls_back_before_a_waiting_train_is_an_alarm_but_for_a_train_that_was_called_on() -> None:
    """Its first section becomes occupied, and the section before it is: of a call-on that is the train."""
    for called_on in (False, True):
        layout, _, controller = built("../tests/layouts_for_tests/called_on")
        watch, y = Watch(layout, controller, allocate(layout, controller)), controller.symbols
        r = next(
            r
            for r in y.routes
            if bool(r.call_on) is called_on and r.path.ways and y.cancellation.approach_of.get(r.entry)
        )
        first, rear = r.path.ways[0][0], y.cancellation.approach_of[r.entry]
        before = {**at_rest(y), str(y.sections.clear[rear]): 0}
        scan(watch, before, **{str(r.proceed): True, str(r.active): True})
        stands = scan(watch, {**before, str(y.sections.clear[first]): 0}, **{str(r.active): True})
        assert (f"fallen {r.entry}" in stands) is not called_on, r.id


def test_the_list_of_alarms_names_each_kind_of_lamp() -> None:
    layout, _, controller = built("flank_lab")
    keys = {p.key for p in possible(layout, controller, allocate(layout, controller))}
    lamps = controller.symbols.lamp_proof
    for word, of in (("stop", lamps.stop), ("clear", lamps.clear), ("caution", lamps.caution)):
        assert of and {f"{word} lamp {g}" for g in of} <= keys
