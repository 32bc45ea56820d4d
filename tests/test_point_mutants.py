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
