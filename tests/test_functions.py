"""Functions: every shipped controller has them all, by induction; where something is cut, the function tells."""

from __future__ import annotations

import pytest

from interlock.logic.expr import FALSE, TRUE, Expr
from interlock.proof.claims import Facts
from interlock.proof.functions import FUNCTIONS, functions
from interlock.proof.mutation.judge import Fate, Judge
from interlock.proof.mutation.lines import Lines
from interlock.proof.mutation.points import Mutation
from interlock.proof.mutation.switched import Switched
from interlock.proof.mutation.weakenings import KINDS
from interlock.proof.system.transition import System
from tests.layouts import SHIPPED, built
from tests.test_operations import put

OTHERS = (
    "added",
    "air_lock_doors",
    "clear_beyond",
    "closing",
    "devices",
    "driven",
    "entry_speeds",
    "foul_joint",
    "foul_siding",
    "held_apart",
    "held_longer",
    "overlap_condition",
    "overlaps",
    "overlap_past_signals",
    "overlaps_join",
    "overlap_berth",
    "shunt_yard",
    "speeds",
)
OTHERS = (
    *OTHERS,
    "clear_beyond",
    "swing",
    "swing_condition",
    "token",
    "boards",
    "closing_next",
    "bare_signal",
    "berth_before",
    "dead_end",
    "branches",
    "identifier",
    "air_lock",
)


@pytest.mark.parametrize("name", [*SHIPPED, *(f"../tests/layouts_for_tests/{x}" for x in OTHERS)])
def test_every_controller_has_every_function(name: str) -> None:
    """They follow, in every step, from the invariants, which the proofs of these layouts keep."""
    layout, _, controller = built(name)
    system = System(layout, controller)
    lines, step, start = Lines.of(system), Switched(), Switched()
    known = [step.define(n, x) for n, x in lines.definitions.items()]
    known += [step.fact(x) for x in (*lines.assumptions, *(x for _, x in lines.invariants))]
    assert len(lines.functions) > 40 and step.model(*known) is not None
    assert [n for n, x in lines.functions if step.model(*known, step.any_false((x,))) is not None] == []
    begin = [start.fact(x) for x in lines.start]
    assert [n for n, x in lines.at_start if start.model(*begin, start.any_false((x,))) is not None] == []


def test_each_function_is_asked_somewhere() -> None:
    found = {"F-START"}
    others = (f"../tests/layouts_for_tests/{x}" for x in OTHERS)
    for name in ("passing_loop", "heishan", "flank_lab", "cn6502", *others):
        layout, _, controller = built(name)
        found |= {what for what, _, _ in functions(Facts(System(layout, controller)), controller)}
    assert found == set(FUNCTIONS)


@pytest.mark.parametrize(
    ("name", "wire", "value", "function"),
    [
        ("fig2_2", "HR_DP", FALSE, "F-RELEASE"),
        ("fig2_2", "H_R1", TRUE, "F-SHOWN"),
        ("fig2_2", "WA_DP_1", TRUE, "F-GRANT"),
        ("junction", "C_S1", FALSE, "F-CLEAR"),
        ("crossing_line", "GPN_LC1", FALSE, "F-POINT"),
    ],
)
def test_a_function_tells_what_no_claim_asks(name: str, wire: str, value: Expr, function: str) -> None:
    layout, _, controller = built(name)
    verdict = Judge(layout, controller).judge(Mutation("", "", (wire,), lambda: put(controller, wire, value)))
    assert verdict.fate is Fate.FUNCTION and verdict.why.startswith(function)


def test_a_signal_that_closes_later_than_the_layout_has_it_fails_a_function() -> None:
    """Nobody can come to harm by it where nothing follows, so no claim tells; and the mutant has a state more."""
    layout, table, controller = built("mine11")
    closes = next(k for k in KINDS if k.name == "closes-late")
    name, late = next(closes.make(layout, table))
    verdict = Judge(layout, controller).judge(Mutation("", str(name), (), lambda: late))
    assert len(late.state) > len(controller.state)
    assert verdict.fate is Fate.FUNCTION and verdict.why.startswith("F-PASSING")
