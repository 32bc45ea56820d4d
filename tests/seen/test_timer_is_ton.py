"""Timers count as TON does: in the scan in which the input rises no time has passed."""

from __future__ import annotations

import types

from interlock.emit.python.runtime import runtime_py
from interlock.field.plc import Watch
from interlock.st.meaning import Numbers
from interlock.st.program import HEARTBEAT_MS
from tests.layouts import built


def runtime(name: str):  # type: ignore[no-untyped-def]
    _, _, controller = built(name)
    module = types.ModuleType("runtime")
    exec(compile(runtime_py(controller, []), "runtime.py", "exec"), module.__dict__)
    return module.Controller(), controller


def test_the_runtime_counts_no_time_in_the_scan_in_which_the_input_rises() -> None:
    machine, controller = runtime("fig2_2")
    timer = controller.timers[-1].name
    preset = next(t.preset_ms for t in controller.timers if t.name == timer)
    assert machine._timer(timer, True, preset) is False
    assert machine._timer(timer, True, preset) is True


def test_the_interpreter_of_the_text_counts_alike() -> None:
    numbers = Numbers(dt_ms=1000)
    assert [numbers.timer("T", on, 2000) for on in (1, 1, 1, 0, 1)] == [0, 0, 1, 0, 0]


def test_the_watch_of_the_field_link_counts_alike() -> None:
    watch = Watch()
    beats = [watch.step(k % 2, HEARTBEAT_MS // 2) for k in range(4)]
    assert beats[-1]
    still = [watch.step(1, HEARTBEAT_MS // 2) for _ in range(4)]
    assert still == [True, True, False, False]


def test_one_long_cycle_releases_nothing_on_a_single_clear_reading() -> None:
    """Suspended for 3 s between two scans, which both read clear: nobody knows what was there meanwhile."""
    machine, controller = runtime("fig2_2")
    release = next(t for t in controller.timers if t.name.startswith("RT_"))
    clear = {i.name: 1 for i in controller.inputs if i.name.startswith(("CLR_", "VALID", "DN_"))}
    machine.state = machine.state | {"K_DP": False, "L_DP_1": True, "F_DP": True, "U_DP": True, "P_DP": True}
    machine.scan(clear, 100)
    machine.scan(clear, release.preset_ms)
    assert machine.state["L_DP_1"]
