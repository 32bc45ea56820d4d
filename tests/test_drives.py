"""What drives points, in the emitted runtime with motors of its own: nothing starts over a train, nothing runs where
somebody works (R10)."""

from __future__ import annotations

import types
from pathlib import Path
from typing import Any

import pytest

from interlock.emit.python.runtime import runtime_py
from interlock.logic import names
from interlock.logic.expr import variables
from interlock.logic.lower import lower
from interlock.table.cells import Role
from tests.layouts import built, grown

CROSSOVER = """
interlock: 1
name: crossover
profile: {profile}
principles: {{lamp_proof: no}}
boundaries:
  W1: {{approach: wa 1200}}
  E1: {{approach: ea 1200}}
  W2: {{approach: wb 1200}}
  E2: {{approach: eb 1200}}
tracks: {{a: [W1, a1 300], b: [b1 300, E1], c: [W2, c1 300], d: [d1 300, E2]}}
points:
  1A: {{section: s1, toe: a.end, normal: b.start, reverse: 1B.reverse}}
  1B: {{section: s2, toe: d.start, normal: c.end}}
signals:
  X1: {{from: W1, into: a1}}
  X2: {{from: a1, into: s1}}
  Y1: {{from: E1, into: b1}}
  Y2: {{from: b1, into: s1}}
  U1: {{from: W2, into: c1}}
  U2: {{from: c1, into: s2}}
  V1: {{from: E2, into: d1}}
  V2: {{from: d1, into: s2}}
"""
DERAILER = """
interlock: 1
name: shed
boundaries: {W: {approach: wa 1200}, E: {approach: ea 1200}}
buffers: [SB]
tracks: {a: [W, a1 300], b: [b1 300, E], sid: [sp 60], shed: [q1 100, SB]}
derailers: {D: {section: sd, outer: shed.start, inner: sid.end}}
points: {1: {section: s1, toe: a.end, normal: b.start, reverse: sid.start}}
signals: {X1: {from: W, into: a1}, X2: {from: a1, into: s1}, Y1: {from: E, into: b1}, Y2: {from: b1, into: s1}}
exclude: [{from: X2, to: SB, reason: by hand}]
"""


class Yard:
    """A runtime, and motors that turn points in five seconds of a hundred milliseconds a scan."""

    def __init__(self, text: str) -> None:
        if text.startswith("\n"):
            made = grown(text)
            assert made is not None
            controller = lower(made[0], made[1])
        else:
            controller = built(text)[2]
        module = types.ModuleType("runtime")
        exec(compile(runtime_py(controller, []), "runtime.py", "exec"), module.__dict__)
        self.one: Any = module.Controller()  # type: ignore[attr-defined]
        self.inputs = {i.name: i.restrictive for i in controller.inputs} | {controller.symbols.valid: 1}
        self.inputs |= dict.fromkeys([*controller.symbols.sections.clear.values()], 1)
        self.inputs |= dict.fromkeys([*controller.symbols.sections.blocked.values()], 0)
        self.inputs |= {n: 1 for n in self.inputs if n[:3] in ("BF_", "RL_", "GL_", "CL_")}
        self.blades = {n[3:]: 0.0 for n in self.inputs if n.startswith("DN_")}
        self.stuck: set[str] = set()
        self.seconds(660)
        self.seconds(1, RELALL=1)

    def scan(self, **pressed: int) -> dict[str, Any]:
        for m, at in self.blades.items():
            self.inputs |= {f"DN_{m}": int(at == 0), f"DR_{m}": int(at == 1)}
        out: dict[str, Any] = self.one.scan({**self.inputs, **pressed}, 100)
        for m, at in self.blades.items():
            if m not in self.stuck:
                self.blades[m] = min(1.0, max(0.0, at + (out[f"YR_{m}"] - out[f"YN_{m}"]) / 50))
                self.blades[m] = round(self.blades[m], 2)
        return out

    def seconds(self, s: float, **pressed: int) -> list[dict[str, Any]]:
        return [self.scan(**pressed) for _ in range(round(s * 10))]

    def ask(self, route: str) -> None:
        self.scan(**self.one.request(route))

    def again(self, signal: str, route: str) -> None:
        """The route is cancelled and set again; its points turn."""
        self.seconds(1, **{f"CAN_{signal}": 1})
        self.ask(route)
        self.seconds(20)


@pytest.mark.parametrize("lost", ["CLR_s2", "BLK_s2", "VALID"])
def test_a_point_that_waits_for_its_start_does_not_start_where_it_could_not_be_commanded(lost: str) -> None:
    """Machines start one after the other: between command and start a train may come, or somebody to work there."""
    yard = Yard(CROSSOVER.format(profile="cn"))
    yard.ask("X2-E2")
    yard.inputs[lost] = 1 - yard.inputs[lost]
    assert not any(out["YR_1B"] for out in yard.seconds(20))
    yard.inputs[lost] = 1 - yard.inputs[lost]
    yard.seconds(20)
    assert yard.blades == {"1A": 1.0, "1B": 0.0 if lost == "BLK_s2" else 1.0}, "nobody's hand on a block turns points"
    if lost == "BLK_s2":
        yard.again("X2", "X2-E2")
        assert yard.blades == {"1A": 1.0, "1B": 1.0}


def test_no_motor_starts_when_detection_is_lost_under_a_train() -> None:
    yard = Yard(CROSSOVER.format(profile="cn"))
    yard.ask("X2-E2")
    yard.seconds(20)
    yard.inputs["CLR_s2"] = 0
    yard.blades["1B"] = 0.98  # the blades give a little under the wheels
    assert not any(out["YR_1B"] or out["YN_1B"] for out in yard.seconds(5))
    assert yard.scan()["YT_1B"]


@pytest.mark.parametrize("profile", ["generic", "cn"])
def test_a_drive_stops_when_its_section_is_blocked_until_it_is_commanded_anew(profile: str) -> None:
    """Points are obstructed, the operator blocks the section, and somebody takes the stone out."""
    yard = Yard(CROSSOVER.format(profile=profile))
    yard.stuck = {"1A", "1B"}
    yard.ask("X2-E2")
    assert yard.seconds(20)[-1]["YR_1A"]
    yard.inputs["BLK_s1"] = 1
    yard.seconds(1)
    yard.stuck = set()
    assert not any(out["YR_1A"] or out["YN_1A"] for out in yard.seconds(20))
    yard.inputs |= {"BLK_s1": 0, "CLR_s1": 0}  # the trolley of whoever worked there
    assert not any(out["YR_1A"] for out in yard.seconds(20))
    yard.inputs["CLR_s1"] = 1
    assert not any(out["YR_1A"] for out in yard.seconds(20)), "nobody has ordered it since"
    yard.again("X2", "X2-E2")
    assert yard.blades["1A"] == 1.0


def test_what_a_block_has_stopped_starts_one_after_the_other_too() -> None:
    """Two machines of a crossover run, are stopped together, and are commanded anew together."""
    yard = Yard(CROSSOVER.format(profile="cn"))
    yard.ask("X2-E2")
    yard.seconds(1)
    assert yard.seconds(1)[-1]["YR_1A"] and yard.scan()["YR_1B"]
    yard.inputs |= {"BLK_s1": 1, "BLK_s2": 1}
    stopped = yard.seconds(2)
    assert not stopped[-1]["YR_1A"] and not stopped[-1]["YR_1B"]
    yard.inputs |= {"BLK_s1": 0, "BLK_s2": 0}
    yard.seconds(1, CAN_X2=1)
    yard.ask("X2-E2")
    runs = [(bool(out["YR_1A"]), bool(out["YR_1B"])) for out in yard.seconds(20)]
    assert runs.index((True, False)) < runs.index((True, True)) or runs.index((False, True)) < runs.index((True, True))
    assert yard.blades == {"1A": 1.0, "1B": 1.0}


def test_no_route_is_granted_over_points_that_a_block_has_stopped_half_way() -> None:
    """One machine moves both ends of a crossover; it was on its way back to normal when the other track was blocked."""
    text = CROSSOVER.format(profile="generic")
    for end in ("1A", "1B"):
        text = text.replace(f"{end}: {{section", f"{end}: {{machine: 1, section")
    yard = Yard(text)
    yard.again("X2", "X2-E2")
    assert yard.blades == {"1": 1.0}
    yard.seconds(1, CAN_X2=1)
    yard.ask("X2-E1")
    yard.seconds(2)
    yard.inputs["BLK_s2"] = 1
    yard.seconds(2, CAN_X2=1)
    assert 0 < yard.blades["1"] < 1
    yard.ask("X2-E1")
    yard.seconds(10)
    assert yard.one.status("X2-E1") != "SET", "its points would never come to lie"
    yard.scan(**yard.one.request("X2-E1"))
    assert "s2 is blocked" in str(yard.one.why_not("X2-E1"))
    yard.inputs["BLK_s2"] = 0
    yard.again("X2", "X2-E1")
    assert yard.blades == {"1": 0.0}
    assert yard.seconds(1)[-1]["YP_X2"]


def test_a_block_that_is_taken_off_opens_no_signal() -> None:
    """The route waits for points that do not turn; meanwhile somebody blocks its last section, for hours."""
    yard = Yard(CROSSOVER.format(profile="generic"))
    yard.stuck = {"1A"}
    yard.ask("X2-E2")
    yard.seconds(20)
    yard.inputs["BLK_d1"] = 1
    yard.seconds(2)
    yard.stuck = set()
    yard.seconds(10)
    assert yard.blades == {"1A": 1.0, "1B": 1.0}
    yard.inputs["BLK_d1"] = 0
    assert not any(out["YP_X2"] for out in yard.seconds(10)), "whoever takes the block off opens a signal"
    yard.ask("X2-E2")
    assert yard.seconds(2)[-1]["YP_X2"]


@pytest.mark.parametrize("profile", ["generic", "cn"])
def test_in_a_blocked_section_a_point_turns_as_long_as_it_is_moved_by_hand(profile: str) -> None:
    yard = Yard(CROSSOVER.format(profile=profile))
    yard.inputs["BLK_s1"] = 1
    yard.seconds(2)
    yard.seconds(2, MR_1A=1)
    assert 0 < yard.blades["1A"] < 1
    there = yard.blades["1A"]
    yard.seconds(10)
    assert yard.blades["1A"] == pytest.approx(there, abs=0.03)
    yard.seconds(6, MR_1A=1)
    assert yard.blades["1A"] == 1.0


def test_a_section_that_no_route_uses_is_blocked_for_its_derailer() -> None:
    yard = Yard(DERAILER.replace("name: shed", "name: shed\nprinciples: {drive_points: yes}"))
    yard.blades["D"] = 1.0
    yard.inputs["BLK_sd"] = 1
    yard.seconds(1)
    yard.ask("X2-E")
    assert not any(out["YN_D"] or out["YR_D"] for out in yard.seconds(10))


def test_published_hbg_can_block_the_other_end_of_a_crossover() -> None:
    _, _, controller = built("../tests/stations/hbg")
    assert {"BLK_T6", "BLK_T11"} <= {i.name for i in controller.inputs}


@pytest.mark.parametrize("name", ["flank_point", "overlap_flank", "devices", "triangle", "scissors_apart", "detour"])
def test_whatever_a_lock_names_as_flank_protection_stays(name: str) -> None:
    found = grown(Path(f"tests/layouts_for_tests/{name}.yaml").read_text("utf-8"))
    assert found is not None
    layout, table, _ = found
    c = lower(layout, table)
    step = {e.name: e.expr for e in c.steps if hasattr(e, "expr")}
    demands = [(t.key, p.machine) for t in table.locks for p in t.points if p.role is Role.FLANK]
    assert demands
    for key, m in demands:
        lock = c.symbols.sections.lock[key]
        assert lock in set(variables((step[names.MOVABLE(m)],))), f"{m} may turn while {key} is locked"
