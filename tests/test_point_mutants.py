"""Point mutations: what is changed, that each verdict rests on its own evidence, and that nothing survives unlisted."""

from __future__ import annotations

from collections import Counter
from itertools import count
from pathlib import Path
from types import SimpleNamespace

import pytest
from click.testing import CliRunner

from interlock.cli.mutate import command
from interlock.logic.controller import Equation
from interlock.proof.engines.limits import Limits
from interlock.proof.induction.verdict import Verdict as Proved
from interlock.proof.mutation.campaign import Campaign, one_of_each
from interlock.proof.mutation.elsewhere import read_elsewhere, read_late
from interlock.proof.mutation.judge import LATER, Fate, Judge, Verdict
from interlock.proof.mutation.lines import Lines
from interlock.proof.mutation.points import Mutation, mutations
from interlock.proof.mutation.survivors import listed, off_the_list
from interlock.proof.prover import prove
from interlock.proof.system.transition import System
from tests.campaigns.point_mutants import made
from tests.layouts import built

PARTS = ("", "next ", "output ", "timer ", "initial ")


@pytest.fixture(scope="module")
def judge() -> Judge:
    layout, _, controller = built("fig2_2")
    return Judge(layout, controller)


@pytest.fixture(scope="module")
def verdicts(judge: Judge) -> list[tuple[Mutation, Verdict]]:
    """Of every fifth mutant."""
    return [(m, judge.judge(m)) for m in list(mutations(judge.controller))[::5]]


def test_everything_is_mutated(judge: Judge) -> None:
    c = judge.controller
    names = {m.name.removeprefix("next ").removeprefix("initial ").split(" ")[0] for m in mutations(c)}
    parts = {s.name for s in c.steps} | {e.name for e in c.next} | {o.name for o in c.outputs}
    assert names == parts
    forms = Counter(m.form for m in mutations(c))
    assert forms["preset 1 ms"] == len(c.timers) and forms["false"] >= len(
        [s for s in c.steps if isinstance(s, Equation)]
    )


def test_a_sample_has_every_form_of_every_family(judge: Judge) -> None:
    every = list(mutations(judge.controller))
    sample = one_of_each(every)
    assert {(m.family, m.form) for m in sample} == {(m.family, m.form) for m in every}
    assert {part for part in PARTS if any(m.family.startswith(part) for m in sample)} == set(PARTS)


@pytest.mark.parametrize("name", ["fig2_2", "passing_loop"])
def test_of_all_families_no_mutant_survives_unlisted(name: str) -> None:
    found = Campaign(made, {name: False}).run()[name]
    assert len(found) > 400 and all(v is not None for _, v in found)
    assert off_the_list(found) == []
    alive = [m.name for m, v in found if v is not None and v.fate is Fate.SURVIVES]
    assert 100 * len(alive) <= len(found), alive


def test_each_listed_change_survives_and_has_its_reason(judge: Judge) -> None:
    assert all(len(reason) > 80 for reason in listed().values())
    alive = {m.shape for m in mutations(judge.controller) if judge.judge(m).fate is Fate.SURVIVES}
    assert alive <= listed().keys() and alive


def test_a_survivor_that_is_not_listed_is_a_finding(judge: Judge) -> None:
    m = next(mutations(judge.controller))
    assert off_the_list([(m, Verdict(Fate.SURVIVES, LATER))]) == [m.name]
    alive = next(x for x in mutations(judge.controller) if x.shape in listed())
    assert off_the_list([(alive, judge.judge(alive))]) == []
    assert off_the_list([(alive, Verdict(Fate.SURVIVES))]) == [alive.name]


@pytest.mark.parametrize("name", ["fig2_2", "fig2_3_split"])
def test_what_reads_its_neighbours_variable_is_noticed_or_the_same(name: str) -> None:
    layout, _, controller = built(name)
    judge = Judge(layout, controller)
    fates = {m.name: judge.judge(m) for m in read_elsewhere(controller)}
    alive = {n: v for n, v in fates.items() if v.fate in (Fate.SURVIVES, Fate.TRAIN, Fate.OPERATOR)}
    assert len(fates) > 200 and not alive, alive
    assert Counter(v.fate for v in fates.values())[Fate.CLAIM] > len(fates) / 4


@pytest.mark.parametrize(
    ("name", "which", "why"),
    [
        ("crossing_line", "TG_LC2 reads GW_s5_1 for GW_s4_2", "F-POINT at LC2 returns"),
        ("junction", "MAR_102 reads TG_101 for TG_102", "F-OFF at 102 at last"),
    ],
)
def test_what_is_set_elsewhere_keeps_no_machine_from_moving(name: str, which: str, why: str) -> None:
    """A crossing that opens a scan too late, a key that turns nothing: while a route is set that has no part in it."""
    layout, _, controller = built(name)
    mutant = next(m for m in read_elsewhere(controller) if m.name == which)
    assert Judge(layout, controller).judge(mutant) == Verdict(Fate.FUNCTION, why)


@pytest.mark.parametrize("name", ["passing_loop", "../tests/layouts_for_tests/shunt_yard"])
def test_what_is_read_late_fails_a_claim(name: str) -> None:
    layout, _, controller = built(name)
    late = list(read_late(controller))
    assert len(late) > 6
    for m in late:
        result = prove(System(layout, m.make()), Limits(search_depth=0, search_s=0))
        assert any(c.verdict is not Proved.PROVED for c in result.claims), m.name


def test_no_mutant_of_an_output_or_of_a_preset_survives(judge: Judge) -> None:
    some = [m for m in mutations(judge.controller) if m.family.startswith("output ") or m.form.startswith("preset ")]
    assert len(some) > 60
    assert {m.name: v for m in some if (v := judge.judge(m)).fate not in (Fate.CLAIM, Fate.FUNCTION)} == {}


OWN_BITS = ("next TR_P1 false", "next THN_P1 false", "STI_P1 false", "STI_P1 true", "STI_P1 without NOT QN_P1")
OWN_BITS += ("next TR_P1 without ((THN_P1", "NU_DP_1 without OCC_DP", "NU_DP_1 without OCC_SA")
OWN_BITS += ("NU_DP_1 true", "next P_DP true", "next X_X1 true", "next X_X1 with CAN_X1 negated")


@pytest.mark.parametrize("which", OWN_BITS)
def test_the_controllers_own_bits_are_claimed_to_mean_what_claims_read_in_them(judge: Judge, which: str) -> None:
    """A point that is never taken as trailed, an alarm that never waits, a section used without a train: no claim that
    reads such a bit would notice, and no train."""
    those = [m for m in mutations(judge.controller) if m.name.startswith(which)]
    assert those, which
    assert {judge.judge(m).fate for m in those} <= {Fate.CLAIM, Fate.FUNCTION}


def test_the_prover_and_the_witnesses_say_the_same(judge: Judge, verdicts: list[tuple[Mutation, Verdict]]) -> None:
    """What the judge calls a failed claim the prover does not prove; what it calls the same loses no witness."""
    for m, v in verdicts[::11]:
        if v.fate is Fate.REFUSED:
            continue
        result = prove(System(judge.layout, m.make()), Limits(search_depth=0, search_s=0))
        failing = {c.id for c in result.claims if c.verdict is not Proved.PROVED}
        if v.fate is Fate.CLAIM:
            assert v.why.split(" at ")[0] in failing, m.name
        elif v.fate is not Fate.FUNCTION:
            assert not failing, m.name
        if v.fate in (Fate.EQUIVALENT, Fate.SURVIVES):
            assert {w.route for w in result.witnesses if not w.ok} == set(), m.name


def test_a_mutant_that_shares_the_lines_has_the_lines_of_its_own_system(judge: Judge) -> None:
    """Right sides change nothing but definitions and what a restart keeps."""
    for m in [m for m in mutations(judge.controller) if not m.family.startswith(("timer ", "initial "))][::97]:
        try:
            controller = m.make()
        except Exception as e:  # no controller
            assert "reads" in str(e) or "restrictive" in str(e)
            continue
        changed = judge.system.changed(controller)
        assert changed, m.name
        shared = judge.lines.under(judge.system.under(controller, changed))
        assert shared == Lines.of(System(judge.layout, controller)), m.name


def test_a_pattern_fails_only_what_the_solver_fails(judge: Judge) -> None:
    """What is seen to fail in a step that was found before cannot be proved."""
    fresh = Judge(judge.layout, judge.controller)
    tried = 0
    for m in list(mutations(judge.controller))[::23]:
        try:
            changed = judge.system.changed(m.make())
        except Exception as e:
            assert str(e)
            continue
        known = None if changed is None else judge.patterns.broken(changed)
        if known is not None:
            tried += 1
            fresh.patterns = Judge(judge.layout, judge.controller).patterns if tried == 1 else fresh.patterns
            assert fresh.judge(m).fate in (Fate.CLAIM, Fate.FUNCTION), m.name
    assert tried > 20


def test_runs_that_a_change_does_not_reach_are_not_run_again(judge: Judge) -> None:
    """A changed equation with the same values in every recorded scan leaves all runs as they were."""
    c = judge.controller
    same = {e.name: e.expr for e in c.equations}
    assert judge.runs.reached(same) == []
    stuck = next(m for m in mutations(c) if m.name.startswith("G_R1 false"))
    changed = judge.system.changed(stuck.make())
    assert changed is not None and judge.runs.reached(changed)
    noticed = judge.runs.noticed(judge.system.under(stuck.make(), changed).loop, changed)
    assert noticed is not None and noticed[0] and "refused" in noticed[1]


def test_two_timers_whose_inputs_differ_are_not_the_same(judge: Judge) -> None:
    """The supervision of a point that never counts shows only at its alarm."""
    from interlock.proof.mutation.same import Side, same

    m = next(m for m in mutations(judge.controller) if m.name == "STI_P1 false")
    changed = judge.system.changed(m.make())
    assert changed is not None
    system = judge.system.under(m.make(), changed)
    other = Side(m.make(), system.relation.state, judge.lines.under(system), judge.side.invariants)
    assert same(judge.step, judge.side, other, judge.reads) is None


def test_a_campaign_goes_on_where_it_was_broken_off(tmp_path: Path) -> None:
    kept = tmp_path / "verdicts"
    campaign = Campaign(made, {"fig2_2": False}, frozenset({"output YS", "timer ST", "initial K"}))
    halves = [campaign.run(kept, shard=(k, 2))["fig2_2"] for k in (1, 2)]
    assert all(v is not None for _, v in halves[1]) and kept.read_text().count("\n") == len(halves[1])
    before = kept.read_text()
    again = campaign.run(kept)["fig2_2"]
    assert [(m.name, v) for m, v in again] == [(m.name, v) for m, v in halves[1]] and kept.read_text() == before


def test_no_two_mutants_of_a_family_have_one_name() -> None:
    names = Counter((m.family, m.name) for m in mutations(built("junction")[2]))
    assert set(names.values()) == {1}


def test_the_command_counts_by_family_and_fails_on_a_survivor_off_the_list(monkeypatch: pytest.MonkeyPatch) -> None:
    some = ["timer RT", "output YN", "initial PWR", "weakened: point-wrong", "text-time"]
    line = ["layouts/fig2_2.yaml", *(x for f in some for x in ("--family", f))]
    done = CliRunner().invoke(command, line)
    assert done.exit_code == 0, done.output
    assert all(any(out.startswith(f + " ") for out in done.output.splitlines()) for f in some)
    assert "1 survives" in done.output and "restart delay begins with the first scan" in done.output
    monkeypatch.setattr("interlock.proof.mutation.survivors.listed", dict)
    monkeypatch.setattr("interlock.cli.mutate.listed", dict)
    assert "NOT ON THE LIST" in (alive := CliRunner().invoke(command, line)).output and alive.exit_code == 1


def test_searches_for_stories_are_bounded_together_and_what_is_left_is_unknown(monkeypatch: pytest.MonkeyPatch) -> None:
    seconds = count()
    monkeypatch.setattr(
        "interlock.cli.mutate.time", SimpleNamespace(monotonic=lambda: next(seconds))
    )  # each look at it takes one
    line = [
        "layouts/fig2_2.yaml",
        "--family",
        "weakened: cancel-occupied",
        "--family",
        "weakened: two-grants",
        "--stories",
    ]
    done = CliRunner().invoke(command, [*line, "--stories-seconds", "1.5"])
    assert done.output.count("UNKNOWN: no movement to harm was looked for, since 1.5 s were over") == 1
    assert done.exit_code == 3, done.output
    assert CliRunner().invoke(command, [*line, "--search-seconds", "nan"]).exit_code == 2
