"""Point mutations: what is changed, and that each verdict rests on its own evidence."""

from __future__ import annotations

from collections import Counter

import pytest

from interlock.logic.controller import Equation
from interlock.proof.limits import Limits
from interlock.proof.mutation.judge import Fate, Judge, Verdict
from interlock.proof.mutation.points import Mutation, mutations
from interlock.proof.runner import prove
from interlock.proof.system import System
from interlock.proof.verdict import Verdict as Proved
from tests.layouts import built


@pytest.fixture(scope="module")
def judge() -> Judge:
    layout, _, controller = built("fig2_2")
    return Judge(layout, controller)


@pytest.fixture(scope="module")
def verdicts(judge: Judge) -> list[tuple[Mutation, Verdict]]:
    """Of every ninth mutant."""
    return [(m, judge.judge(m)) for m in list(mutations(judge.controller))[::9]]


def test_everything_is_mutated(judge: Judge) -> None:
    c = judge.controller
    names = {m.name.removeprefix("next ").removeprefix("initial ").split(" ")[0] for m in mutations(c)}
    parts = {s.name for s in c.steps} | {e.name for e in c.next} | {o.name for o in c.outputs}
    assert names == parts
    forms = Counter(m.form for m in mutations(c))
    assert forms["preset 1 ms"] == len(c.timers) and forms["false"] >= len(
        [s for s in c.steps if isinstance(s, Equation)]
    )


def test_no_mutant_of_an_output_or_of_a_preset_survives(judge: Judge) -> None:
    some = [m for m in mutations(judge.controller) if m.family.startswith("output ") or m.form.startswith("preset ")]
    assert len(some) > 60
    assert {m.name: v for m in some if (v := judge.judge(m)).fate is not Fate.CLAIM} == {}


OWN_BITS = ("next TR_P1 false", "next TH_P1 false", "STI_P1 false", "STI_P1 true", "STI_P1 without NOT QN_P1")
OWN_BITS += ("next TR_P1 without TH_P1 AND VALID AND", "NU_DP_1 without OCC_DP", "NU_DP_1 without OCC_SA")
OWN_BITS += ("NU_DP_1 true", "next P_DP true", "next X_X1 true", "next X_X1 with CAN_X1 negated")


@pytest.mark.parametrize("which", OWN_BITS)
def test_the_controllers_own_bits_are_claimed_to_mean_what_claims_read_in_them(judge: Judge, which: str) -> None:
    """A point that is never taken as trailed, an alarm that never waits, a section used without a train: no claim that
    reads such a bit would notice, and no train."""
    those = [m for m in mutations(judge.controller) if m.name.startswith(which)]
    assert those, which
    assert {judge.judge(m).fate for m in those} == {Fate.CLAIM}


def test_most_mutants_are_noticed(verdicts: list[tuple[Mutation, Verdict]]) -> None:
    fates = Counter(v.fate for _, v in verdicts)
    assert all(fates[f] for f in (Fate.CLAIM, Fate.TRAIN, Fate.OPERATOR, Fate.EQUIVALENT))
    assert fates[Fate.SURVIVES] <= 0.12 * len(verdicts)


def test_the_prover_and_the_witnesses_say_the_same(judge: Judge, verdicts: list[tuple[Mutation, Verdict]]) -> None:
    for m, v in verdicts[::6]:
        if v.fate is Fate.REFUSED:
            continue
        result = prove(System(judge.layout, m.make()), Limits(search_depth=0, search_s=0))
        assert (v.fate is Fate.CLAIM) == any(c.verdict is not Proved.PROVED for c in result.claims), m.name
        if v.fate is not Fate.CLAIM:
            lost = {w.route for w in result.witnesses if not w.ok} & judge.driven
            assert (v.fate is Fate.TRAIN) == bool(lost), m.name
