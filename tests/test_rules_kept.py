"""What the pages of the rules say of single cases, on the emitted runtime: R2, R10, R11, R16."""

from __future__ import annotations

from typing import Any

from interlock.emit.python.runtime import runtime_py
from interlock.logic.lower import lower
from tests.layouts import grown
from tests.test_release_behind import SCAN_MS, Bench

LOOP = """interlock: 1
name: loop
profile: mine
principles: {{caution: next{more}}}
boundaries:
  W: {{approach: wa 600}}
  E: {{approach: ea 600, block: automatic}}
tracks:
  west: [W, q1 200]
  odd:  [q3 300]
  even: [q4 300]
  east: [q6 200, E]
points:
  P1: {{section: q2, toe: west.end,   normal: odd.start, reverse: even.start}}
  P2: {{section: q5, toe: east.start, normal: odd.end,   reverse: even.end}}
signals:
  X1: {{from: W,  into: q1}}
  X2: {{from: q1, into: q2, call_on: yes}}
  X3: {{from: q3, into: q5}}
  X4: {{from: q4, into: q5}}
  Y1: {{from: E,  into: q6}}
  Y2: {{from: q6, into: q5}}
  Y3: {{from: q3, into: q2}}
  Y4: {{from: q4, into: q2}}
level_crossings: {{LC: {{over: [q4]}}}}
overlaps: {{X3: {{length: 20}}}}
"""


def bench(more: str = "") -> Bench:
    made = grown(LOOP.format(more=more))
    assert made is not None and not made[2].has_errors
    b = Bench(lower(made[0], made[1]))
    b.go(4, E_BF_E=1)
    return b


def locked(b: Bench) -> list[str]:
    return sorted(n[3:] for n in b.outputs if n.startswith("YL_q") and b.outputs[n])


def test_a_loss_of_inputs_releases_behind_a_train_that_had_been_seen_to_go_on() -> None:
    b = bench()
    b.ask("X2-X3")
    b.go(2, CLR_q1=0)
    b.go(1, CLR_q2=0)
    b.go(2, CLR_q1=1)
    b.go(2, CLR_q3=0)
    b.go(0.2, VALID=0)
    b.go(6, VALID=1, CLR_q2=1)
    assert locked(b) == ["q3", "q5"], "in q2 it had come in, and gone on, before"
    b = bench()
    b.ask("X2-X3")
    b.go(2, CLR_q1=0)
    b.go(1, CLR_q2=0)
    b.go(0.2, VALID=0)
    b.go(2, VALID=1, CLR_q3=0)
    b.go(20, CLR_q2=1)
    assert {"q2", "q3"} <= set(locked(b)), "nobody saw it come into q3"
    b.go(20, CLR_q1=1, CLR_q3=1)
    assert {"q2", "q3"} <= set(locked(b))
    b.go(2, REL_q2=1)
    b.go(6, REL_q2=0)
    assert locked(b) == [], "no train was seen to come into q3, and the lock in rear of it has gone"


def test_after_a_loss_of_inputs_a_cancellation_releases_the_whole_route() -> None:
    b = bench()
    b.ask("X2-X3")
    b.go(0.2, VALID=0)
    b.go(20, VALID=1)
    assert {"q2", "q3"} <= set(locked(b))
    b.go(0.4, CAN_X2=1)
    b.go(8, CAN_X2=0)
    assert locked(b) == []


def test_a_call_on_finds_the_overlap_clear() -> None:
    b = bench()
    b.go(1, CLR_q5=0)
    b.ask("X2-X3.c")
    assert not b.outputs["YO_X2"] and b.controller.status("X2-X3.c")[1].endswith("q5 is occupied")
    b = bench()
    b.go(1, CLR_q3=0)
    b.ask("X2-X3.c")
    assert b.outputs["YO_X2"]


def test_a_signal_returns_to_stop_when_its_caution_lamp_is_out_though_its_clear_lamp_is_lit() -> None:
    b = bench(", lamp_proof: yes")
    b.ask("X3-E")
    assert b.outputs["YP_X3"] and not b.outputs["YS_X3"]
    b.go(0.2, CL_X3=0)
    assert b.outputs["YS_X3"] and not b.outputs["YP_X3"]


def test_a_crossing_is_closed_by_hand_during_the_restart_delay() -> None:
    made = grown(LOOP.format(more=""))
    assert made is not None
    space: dict[str, Any] = {}
    controller = lower(made[0], made[1])
    exec(runtime_py(controller, []), space)
    inputs = {x.name: int(x.name.startswith(("VALID", "CLR_", "DN_"))) for x in controller.inputs} | {"REQ": 0}
    run = space["Controller"]()
    for _ in range(4):
        shown = run.scan({**inputs, "MR_LC": 1}, SCAN_MS)
    assert shown["YR_LC"] and [n for n in shown if shown[n] and n.startswith(("YN_", "YR_"))] == ["YR_LC"]


def test_that_trailed_points_lie_well_counts_only_while_their_section_is_clear() -> None:
    b = bench()
    b.ask("X2-X3")
    b.go(1, DN_P1=0)
    b.go(1, DN_P1=1)
    assert b.outputs["YT_P1"]
    b.go(1, CLR_q2=0)
    b.go(1, TC_P1=1)
    assert b.outputs["YT_P1"]
    b.go(6, TC_P1=0, CLR_q2=1)
    b.go(1, TC_P1=1)
    assert not b.outputs["YT_P1"]
