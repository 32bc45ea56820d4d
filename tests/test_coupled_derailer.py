"""A derailer that one machine works together with points: on while they lie normal, off while they lie reverse."""

from __future__ import annotations

import csv
import io
import json
from pathlib import Path

import pytest

from interlock.app.alarms import possible
from interlock.audit import audit
from interlock.checker import specification
from interlock.checker.check import agree
from interlock.diag import Sink
from interlock.emit.io import equipment_csv
from interlock.emit.tables.railml import railml_json
from interlock.frontend import load_text
from interlock.logic.cabinet import allocate
from interlock.logic.lower import lower
from interlock.model.elements import Hand, MachineId, Position
from interlock.panel.picture import still
from interlock.proof.engines.limits import Limits
from interlock.proof.prover import prove
from interlock.proof.system.transition import System
from interlock.table.national import national_sheets
from interlock.table.national.reading import Reading
from tests.layouts import grown
from tests.panels import unproved
from tests.written import told

SPUR = """interlock: 1
name: spur
boundaries:
  W: {approach: wa 300}
  E: {approach: ea 300}
buffers: [B]
tracks:
  west: [W, q1 100]
  east: [q3 100, E]
  side: [s1 100, B]
points:
  3: {section: q2, toe: west.end, normal: east.start, reverse: Vk1.inner, machine: 3/Vk1}
derailers:
  Vk1: {section: q2, outer: side.start, machine: 3/Vk1}
signals:
  L: {from: W, into: q1}
  L1: {from: q1, into: q2, kind: combined}
  S: {from: E, into: q3}
  S1: {from: q3, into: q2}
  S2: {from: s1, into: q2, kind: combined}
"""

ON_IT = """interlock: 1
name: on_it
boundaries:
  W: {approach: wa 600}
  E: {trains: out}
buffers: [B]
tracks:
  west: [W, q1 100]
  mid: [m1 100]
  east: [e1 100, E]
  side: [s1 100, B]
points:
  3: {section: p, toe: mid.end, normal: east.start, reverse: side.start, machine: M}
derailers:
  Vk1: {section: q2, inner: west.end, outer: mid.start, machine: M}
signals:
  L: {from: W, into: q1}
  L1: {from: q2, into: m1}
"""


def test_it_is_proved_and_the_second_checker_reads_it_so() -> None:
    made = grown(SPUR)
    assert made is not None and not made[2].has_errors
    layout, table, _ = made
    assert list(layout.machines.ends) == ["3/Vk1"]
    assert prove(System(layout, lower(layout, table)), Limits(search_s=0)).proved
    assert agree(*told(SPUR), specification.shipped()).left == ()
    over = {str(p.position) for r in table.routes if r.entry == "S2" for p in r.locking.points}
    past = {str(p.position) for r in table.routes if r.entry == "S1" for p in r.locking.points}
    assert (over, past) == ({"R"}, {"N"})


def forms(profile: str) -> dict[str, list[dict[str, str]]]:
    """The national sheets of SPUR by key: rows by English heading."""
    made = grown(SPUR.replace("name: spur", f"name: spur\nprofile: {profile}"))
    assert made is not None
    return {
        s.key: [dict(zip([h.en for h in s.headings], row, strict=True)) for row in s.rows]
        for s in national_sheets(made[0], made[1])
    }


def test_every_form_tells_how_it_lies() -> None:
    """By its own name; its machine stands among the points."""
    sheet = forms("generic")
    locked = {
        r["Entering signal"]: (r["Derails"], r["Switches normal"], r["Switches reverse"]) for r in sheet["us_locking"]
    }
    assert (locked["S1"], locked["S2"]) == (("Vk1 on", "3/Vk1", ""), ("Vk1 off", "", "3/Vk1"))
    assert {r["Switch"]: r["Kind"] for r in sheet["us_switches"]} == {"3/Vk1": "switch, with derail"}
    over = {r["Entering signal"]: r["Switches in order"] for r in sheet["us_aspects"]}
    assert over["S2"].split(", ")[0] == "Vk1 off", over
    remarks = {r["Route"][:2]: r["Remarks"] for r in forms("uk")["uk_routes"]}
    assert "Vk1 on" in remarks["S1"] and "Vk1 off" in remarks["S2"]
    lying = {r["Route"][:2]: r["Derailers"] for r in forms("de")["de_verschluss"]}
    assert (lying["S1"], lying["S2"]) == ("Vk1 aufgelegt", "Vk1 abgelegt")
    made = grown(SPUR)
    assert made is not None
    told = {
        r["refersToRoute"]: r["requiredDerailerPosition"]
        for r in json.loads(railml_json(made[0], made[1]))["routeRelations"]
    }
    assert told["S1-W"] == [{"refersTo": "Vk1", "inPosition": "on"}]


def test_the_hand_of_its_points_is_told() -> None:
    made = grown(SPUR.replace("machine: 3/Vk1}\nderail", "machine: 3/Vk1, hand: left}\nderail"))
    assert made is not None
    assert Reading(made[0], made[1]).machines.machine_side(MachineId("3/Vk1"), Position.REVERSE) is Hand.LEFT


@pytest.mark.parametrize(
    ("text", "counted"),
    [
        (SPUR, {"point machine": "1", "point end": "1", "derailer": "1"}),
        (
            SPUR.replace(", machine: 3/Vk1", ""),
            {"point machine": "1", "derailer machine": "1", "point end": "1", "derailer": "1"},
        ),
        (
            SPUR.replace("q2, toe", "q2, work: hand, toe"),
            {"point worked by hand, with key": "1", "point end": "1", "derailer": "1"},
        ),
    ],
)
def test_the_list_of_equipment_counts_it_beside_the_machine(text: str, counted: dict[str, str]) -> None:
    made = grown(text)
    assert made is not None
    layout, table, _ = made
    told = dict(csv.reader(io.StringIO(equipment_csv(layout, allocate(layout, lower(layout, table))))))
    assert {k: n for k, n in told.items() if k.startswith(("point", "derailer"))} == counted


ALONE, BY_KEY = SPUR.replace(", machine: 3/Vk1", ""), SPUR.replace("q2, toe", "q2, work: hand, toe")


@pytest.mark.parametrize(
    ("text", "machine", "called", "off", "move"),
    [
        (SPUR, "3/Vk1", "points 3/Vk1 (3, derailer Vk1)", "reverse", "Move reverse"),
        (ALONE, "Vk1", "derailer Vk1", "off", "Take off"),
        (ALONE, "3", "points 3", "reverse", "Move reverse"),
        (BY_KEY, "3/Vk1", "points 3/Vk1 (3, derailer Vk1)", "released by its key", "Release by its key"),
    ],
)
def test_the_panel_calls_it_what_it_is(text: str, machine: str, called: str, off: str, move: str) -> None:
    one = still(unproved(text), None)["machines"][machine]
    assert (one["called"], one["lies"]["R"], one["move"]["R"]) == (called, off, move)
    assert one["trailed"] == ("trailed" if "points" in called else "run over, or its detection lost")


def test_of_a_derailer_nobody_is_told_that_it_was_trailed() -> None:
    ready = unproved(ALONE)
    assert ready.layout is not None and ready.controller is not None and ready.allocation is not None
    told = [p.text for p in possible(ready.layout, ready.controller, ready.allocation)]
    assert "points 3 were trailed: look at them" in told and not any("Vk1 were trailed" in x for x in told)
    assert "derailer Vk1 was run over, or has lost its detection where it lay: look at it" in told


@pytest.mark.parametrize(
    ("machine", "said", "moved"),
    [("3", "move 3 reverse", "moved reverse"), ("Vk1", "take Vk1 off", "taken off")],
)
def test_what_is_asked_of_it_is_said_in_its_words(machine: str, said: str, moved: str) -> None:
    ready = unproved(ALONE)
    assert ready.layout is not None
    those, m = ready.layout.machines, MachineId(machine)
    assert (those.to_move(m, Position.REVERSE), those.moved(m, Position.REVERSE)) == (said, moved)


def test_a_layout_whose_derailer_has_a_machine_of_its_own_is_another() -> None:
    assert agree(*told(SPUR), specification.shipped()).left == ()
    apart = SPUR.replace("side.start, machine: 3/Vk1}", "side.start}")
    made = grown(apart)
    assert made is not None and list(made[0].machines.ends) == ["3/Vk1", "Vk1"]


def test_forms_and_lists_tell_its_machine_as_points() -> None:
    """It stood in no column of points: what has a derailer was taken for nothing else."""
    made = grown(SPUR)
    assert made is not None
    layout, table, _ = made
    reading = Reading(layout, table).machines
    r = next(r for r in table.routes if r.entry == "S1")
    assert reading.points(r, Position.NORMAL) == "3/Vk1" and reading.derailers_lie(r) == ["Vk1 on"]
    assert layout.machines.word(MachineId("3/Vk1"), Position.REVERSE) == "reverse"


def test_a_machine_that_works_three_ends_is_told_where_it_is_written() -> None:
    sink = Sink()
    text = SPUR.replace("outer: side.start", "outer: P.normal").replace("points:", "  two: [s2 100, C]\npoints:")
    text = text.replace("[B]", "[B, C]").replace(
        "derailers:", "  P: {section: q2, toe: side.start, reverse: two.start, machine: 3/Vk1}\nderailers:"
    )
    load_text("a.yaml", text, sink)
    found = next(d for d in sink.diagnostics if d.code == "IL3014")
    line = text.splitlines()[found.span.line - 1]
    assert line[found.span.column - 1 :].startswith("3/Vk1") and "Vk1: {" in line


WITH_A_SLIP = """interlock: 1
name: with_a_slip
buffers: [V]
boundaries: {NW: {approach: a1 800}, SW: {approach: a2 800}, NE: {approach: a3 800}, SE: {approach: a4 800}}
tracks: {nw: [NW, b1 150], sw: [SW, b2 150], mid: [b5 100], out: [V, b6 100], ne: [b3 150, NE], se: [b4 150, SE]}
points: {9: {machine: M7, section: T9, toe: mid.start, normal: sw.end, reverse: out.end}}
slips: {7: {section: T7, arms: [[nw.end, se.start], [mid.end, ne.start]], machines: [M7]}}
signals:
  A: {from: NW, into: b1}
  B: {from: SW, into: b2}
  C: {from: NE, into: b3}
  D: {from: SE, into: b4}
"""
PAIR = Path("tests/diagnostics/IL3014.yaml").read_text("utf-8").replace("machine: M", "machine: P1")


@pytest.mark.parametrize(
    ("text", "code", "about"),
    [
        (WITH_A_SLIP, "IL3014", "the machine M7 works 5 ends: 7"),
        (PAIR, "IL2002", "the machine of P2 bears the name of the point P1"),
    ],
    ids=["a slip and a point", "a pair that is named after one of its points"],
)
def test_a_machine_that_cannot_be_meant_is_refused(text: str, code: str, about: str) -> None:
    """Points beside a slip turn with it; and of P1 nobody knows whether it is the pair or the point."""
    sink = Sink()
    load_text("a.yaml", text, sink)
    assert any(d.message.startswith(about) for d in sink.diagnostics if d.code == code), sink.diagnostics


def test_a_route_whose_train_stands_on_the_derailer_that_must_turn_is_refused() -> None:
    """No train comes from off the rails; that way counted as one on which it might stand there, so that such a route
    was only found when no witness could drive it."""
    made = grown(ON_IT)
    assert made is not None
    told = [d.message for d in made[2].diagnostics if d.code == "IL4016"]
    assert len(told) == 1 and "route L1-E can never be set" in told[0]
    assert "machine M, on which it stands, must lie N" in told[0]
    assert [f.text for f in audit(made[0], made[1])] == ["its own train stands on points that it needs otherwise"]
