"""Air locks (R13): never more than one of its doors is open, for a train, for an overlap or by hand."""

from __future__ import annotations

import random
from pathlib import Path
from typing import Any

import pytest

from interlock.app.reasons import Moment, Reasons
from interlock.audit import audit
from interlock.checker import specification
from interlock.checker.check import agree
from interlock.derivation import derive
from interlock.diag import Sink
from interlock.emit.python.runtime import runtime_py
from interlock.emit.tables.railml import railml_json
from interlock.field.plc import Memory
from interlock.frontend import load_text
from interlock.logic.eval import Machine
from interlock.logic.lower import lower
from interlock.model.elements import MachineId, Position, RouteId
from interlock.model.layout import Layout
from interlock.proof.engines.limits import Limits
from interlock.proof.prover import prove
from interlock.proof.system.loop import closed_loop
from interlock.proof.system.transition import System
from interlock.proof.witnesses.availability import availability
from interlock.table.national import national_sheets
from interlock.table.rows import InterlockingTable
from tests.layouts import built, grown
from tests.written import told

FILE = Path("tests/layouts_for_tests/air_lock_doors.yaml")
TEXT = FILE.read_text("utf-8")
DOORS = ("D1", "D2")


def derived(text: str) -> tuple[Layout, InterlockingTable]:
    """Layout and table of a text that is in order."""
    found = grown(text)
    assert found is not None and not found[2].has_errors
    return found[0], found[1]


class Drift:
    """The controller with its doors: each takes two scans to turn, and is reported by both of its contacts."""

    def __init__(self) -> None:
        self.controller = built("../tests/layouts_for_tests/air_lock_doors")[2]
        self.machine = Machine(self.controller)
        self.open: dict[str, int] = dict.fromkeys(DOORS, 0)
        """How far each door stands open, of 2."""
        names = [str(i.name) for i in self.controller.inputs]
        self.clear = {n: int(n.startswith("CLR_")) for n in names if n.startswith(("CLR_", "BLK_"))}
        self.scan()
        for _ in range(700):
            self.scan()
        self.scan(RELALL=1)

    def scan(self, **pressed: int) -> dict[str, bool]:
        """One second: doors move as they were driven, the controller scans."""
        contacts = {f"DN_{d}": int(n == 0) for d, n in self.open.items()}
        contacts |= {f"DR_{d}": int(n == 2) for d, n in self.open.items()}
        out = {
            str(k): bool(v)
            for k, v in self.machine.scan({"VALID": 1, **self.clear, **contacts, **pressed}, 1000).items()
        }
        for d in DOORS:
            if out[f"YR_{d}"] or out[f"YN_{d}"]:
                self.open[d] = min(2, self.open[d] + 1) if out[f"YR_{d}"] else max(0, self.open[d] - 1)
        return out


def test_the_proof_the_audit_and_the_second_checker_agree() -> None:
    layout, table, its = built("../tests/layouts_for_tests/air_lock_doors")
    assert audit(layout, table) == ()
    result = prove(System(layout, its), Limits(search_s=0))
    assert result.proved and not result.dropped
    assert "P-AIR-LOCK" in {c.id for c in result.claims}
    assert agree(*told(TEXT), specification.shipped()).left == ()


def test_routes_over_one_door_demand_the_other_one_shut_without_a_demand_in_the_file() -> None:
    _, table, _ = built("../tests/layouts_for_tests/air_lock_doors")
    lies = {r.id: {p.machine: p.position for p in r.locking.points} for r in table.routes}
    assert lies["X1-X2"] == {"D1": Position.REVERSE, "D2": Position.NORMAL}
    assert lies["Y0-Y1"] == {"D2": Position.REVERSE}, "for its overlap"
    assert {"X2-E", "Y0-Y1"} <= set(table.route["X1-X2"].locking.hostile.routes)


def test_by_hand_one_door_opens_at_a_time() -> None:
    drift = Drift()
    for _ in range(4):
        out = drift.scan(MR_D1=1, MR_D2=1)
    assert out["YR_D1"] and not out["YR_D2"], "of two that are ordered at once the first"
    for _ in range(4):
        out = drift.scan(MR_D2=1)
        assert not (drift.open["D1"] and drift.open["D2"])
    assert out["YR_D2"] and drift.open == {"D1": 0, "D2": 2}, "the first has shut by itself, then the second opens"


def test_a_route_waits_for_the_other_door() -> None:
    drift = Drift()
    for _ in range(4):
        drift.scan(MR_D2=1)
    x1_x2 = next(r for r in drift.controller.symbols.routes if r.id == "X1-X2")
    out = drift.scan(REQ=x1_x2.number, MR_D2=1)
    assert not out["YR_D1"] and drift.open == {"D1": 0, "D2": 2}
    words = drift.controller.words
    said = words.reasons[drift.machine.words()[words.routes[x1_x2.number]]]
    assert (said.text, said.rule) == ("it needs: D2 shut before D1 opens", "R13")


@pytest.mark.parametrize("seed", range(6))
def test_whatever_is_pressed_and_wherever_trains_stand_no_two_doors_are_open(seed: int) -> None:
    """A world of doors that nobody else here wrote: in every scan no more than one is not shut."""
    drift, rng = Drift(), random.Random(seed)
    most = 0
    inputs = [i for i in drift.controller.inputs if not str(i.name).startswith(("DN_", "DR_", "VALID"))]
    held: dict[str, int] = {}
    for _ in range(1500):
        for i in inputs:
            if rng.random() < 0.1:
                size = max(2, i.size)
                usual = int(str(i.name).startswith("CLR_"))
                by_lot = str(i.name).startswith(("CLR_", "BLK_")) and rng.random() < 0.8
                held[str(i.name)] = usual if by_lot else rng.randrange(size)
        drift.scan(**held)
        opened = sum(n > 0 for n in drift.open.values())
        assert opened < 2, held
        most = max(most, opened)
    assert most == 1, "doors have opened"


def test_the_operator_is_told_why_a_door_stays_shut() -> None:
    layout, _, its = built("../tests/layouts_for_tests/air_lock_doors")
    drift = Drift()
    for _ in range(4):
        drift.scan(MR_D1=1)
    memory = Memory(drift.machine.state, drift.machine.elapsed)
    inputs = {"VALID": 1, **drift.clear, "DN_D1": 0, "DR_D1": 1, "DN_D2": 1, "DR_D2": 0}
    found = Reasons(layout, its).of_move(MachineId("D2"), Position.REVERSE, Moment(inputs, memory, 1000))
    assert "D1 is not proved shut" in [reason.text for reason in found]


def test_words_of_a_door_say_open_and_shut() -> None:
    machines = built("../tests/layouts_for_tests/air_lock_doors")[0].machines
    d = MachineId("D1")
    assert [machines.lie(d, x) for x in Position] == ["D1 is shut", "D1 is open"]
    assert [machines.to_move(d, x) for x in Position] == ["shut D1", "open D1"]
    assert [machines.moved(d, x) for x in Position] == ["shut", "opened"]


def national(profile: str, text: str = TEXT) -> str:
    """All forms of a railway, as one text."""
    layout, table = derived(text.replace("profile: mine", f"profile: {profile}"))
    return "\n".join("|".join(map(str, row)) for sheet in national_sheets(layout, table) for row in sheet.rows)


FORMS = [("uk", "D1 open", "D2 shut"), ("cn", "D1 开启", "D2 关闭"), ("de", "D1 offen", "D2 geschlossen")]


@pytest.mark.parametrize(("profile", "open_", "shut"), FORMS)
def test_national_forms_tell_which_door_is_open(profile: str, open_: str, shut: str) -> None:
    said = national(
        profile, TEXT.replace("principles: {overlap_m: 0}", "principles: {overlap_m: 0, restart_delay_s: 600}")
    )
    assert open_ in said and shut in said


def test_the_form_for_railml_tells_it_too() -> None:
    layout, table, _ = built("../tests/layouts_for_tests/air_lock_doors")
    said = railml_json(layout, table)
    assert '{"refersTo":"D1","inState":"open"},{"refersTo":"D2","inState":"shut"}' in said


WRONG = {
    "an air lock of one door": (TEXT.replace("air door 2, air_lock: north", "air door 2, air_lock: nort"), "IL3048"),
    "a door that is none": (TEXT.replace("air door 2, air_lock", "air door 2, kind: device, air_lock"), "IL3048"),
    "an overlap over both doors": (TEXT.replace("Y1: {length: 60}", "Y1: {length: 210}"), "IL4022"),
    "a demand of the other door open": (
        f"{TEXT}demand:\n  - {{point: D1, lies: reverse, routes: {{from: Y0}}, reason: air}}\n",
        "IL4022",
    ),
    "doors of the second air lock on its way alone": (
        TEXT.replace(
            "signals:",
            "  D3: {over: [lock], text: air door 3, air_lock: south}\n"
            "  D4: {over: [b], text: air door 4, air_lock: south}\nsignals:",
        ),
        "IL4022",
    ),
    "a train that waits under the other door": (TEXT.replace("over: [a]", "over: [a, lock]"), "IL4022"),
    "no signal between the doors": (
        "\n".join(x for x in TEXT.splitlines() if not x.startswith(("  X2", "  Y2"))),
        "IL4022",
    ),
}


@pytest.mark.parametrize("mistake", WRONG)
def test_mistakes_are_told(mistake: str) -> None:
    text, code = WRONG[mistake]
    sink = Sink()
    layout, _ = load_text("air_lock_doors.yaml", text, sink)
    if layout is not None:
        derive(layout, sink)
    assert code in {d.code for d in sink.diagnostics}


def test_a_third_door_is_kept_apart_from_both_others() -> None:
    text = TEXT.replace("d 100, E]", "d 100, f 50, E]").replace(
        "interlocks:", "interlocks:\n  D3: {over: [f], text: air door 3, air_lock: north}"
    )
    ends = "Y0: {from: E, into: f}\n  Y9: {from: f, into: d}\n  X9: {from: d, into: f}"
    text = text.replace("Y0: {from: E, into: d}", ends).split("overlaps:")[0]
    layout, table = derived(text)
    lies = {p.machine: p.position for p in table.route[RouteId("X1-X2")].locking.points}
    assert lies == {"D1": Position.REVERSE, "D2": Position.NORMAL, "D3": Position.NORMAL}
    result = prove(System(layout, lower(layout, table)), Limits(search_s=0))
    assert result.proved
    assert sum(c.id == "P-AIR-LOCK" for c in result.claims) == 1


def test_every_route_is_used_beside_the_others() -> None:
    """No other door of its lock stands open when a route is asked for: it would be refused until that is shut."""
    layout, table, its = built("../tests/layouts_for_tests/air_lock_doors")
    assert availability(closed_loop(layout, its), table).shown


def test_a_demand_of_a_door_of_the_way_itself_is_held_as_the_second_checker_asks() -> None:
    text = f"{TEXT}demand:\n  - {{point: D1, lies: reverse, routes: {{from: X1}}, reason: a long train}}\n"
    _, table = derived(text)
    roles = [(p.machine, p.role) for p in table.route["X1-X2"].locking.points]
    assert roles == [("D1", "device"), ("D2", "added"), ("D1", "added")]
    assert agree(*told(text), specification.shipped()).left == ()


HELD_OPEN = """interlock: 1
name: held_open
profile: mine
principles: {overlap_m: 0}
boundaries: {W: {approach: w0 100}, E: {approach: e0 100}}
tracks:
  drift: [W, a 60, lock 90, b 60, d 100, E]
interlocks:
  D1: {over: [a], air_lock: north}
  D2: {over: [b], air_lock: north}
signals:
  X1: {from: W, into: a}
  X2: {from: lock, into: b}
  Y0: {from: E, into: d}
  Y1: {from: d, into: b}
  Y2: {from: lock, into: a}
demand:
  - {point: D2, lies: reverse, routes: {from: Y0}, hold: 10, reason: the fan needs it}
"""


def test_a_door_that_another_route_holds_open_longer_is_counted_down() -> None:
    """D1 opens when D2 is shut, and D2 is held open for ten seconds more: runtime and panel tell for how long."""
    layout, table = derived(HELD_OPEN)
    its = lower(layout, table)
    names: dict[str, Any] = {}
    exec(runtime_py(its, []), names)
    runtime, number = names["Controller"](), {str(r.id): r.number for r in table.routes}
    open_ = dict.fromkeys(DOORS, 0)
    inputs = {n: int(n.startswith(("CLR_", "VALID"))) for n in names["INPUTS"]}

    def scan(**pressed: int) -> None:
        contacts = {f"D{x}_{d}": int(open_[d] == (2 if x == "R" else 0)) for x in "NR" for d in DOORS}
        out = runtime.scan({**inputs, **contacts, **pressed}, 1000)
        for d in DOORS:
            if out[f"YR_{d}"] or out[f"YN_{d}"]:
                open_[d] = min(2, open_[d] + 1) if out[f"YR_{d}"] else max(0, open_[d] - 1)

    for _ in range(700):
        scan()
    scan(RELALL=1)
    scan(RELALL=0, REQ=number["Y0-Y1"])
    for _ in range(5):
        scan()
    assert open_ == {"D1": 0, "D2": 2}
    why = "it needs: D2 shut before D1 opens"
    assert runtime.why_not("X1-X2")[1] == why and runtime.countdown_ms("X1-X2") is None, "the route is set"
    scan(CAN_Y0=1)
    left = []
    reasons = Reasons(layout, its)
    for _ in range(200):
        scan()
        refused = runtime.why_not("X1-X2")
        if refused is None:
            break
        assert refused[1] == why
        left.append(runtime.countdown_ms("X1-X2"))
        before = Memory(*runtime._last[:2])
        told_ = reasons.of_request(number["X1-X2"], Moment(runtime._last[2], before, 1000), refused[0])
        assert ("s to go" in told_[0].text) == (before.state["AH_R3"] and before.elapsed["AHT_R3"] is not None)
    counted = [x for x in left if x is not None]
    assert counted == [*range(10_000, -1, -1000)] and left[-1] is None, left
    assert not any(left[: left.index(10_000)]), "nothing is counted yet"


def test_a_train_waits_under_a_door_that_is_over_several_sections_too() -> None:
    """The door's other section does not matter: the train stands in one of them."""
    sink = Sink()
    layout, _ = load_text("air_lock_doors.yaml", TEXT.replace("over: [a]", "over: [a, lock]"), sink)
    assert layout is not None
    derive(layout, sink)
    waits = [d.message for d in sink.diagnostics if d.code == "IL4022" and "waits" in d.message]
    assert [x.split(":")[0] for x in waits] == ["X2-E needs D2 open while its train waits in lock under D1"]
