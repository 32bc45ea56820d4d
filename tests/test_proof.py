"""The shipped layouts are proved; refuted ones are refuted; every assumption matters."""

from __future__ import annotations

import re
from dataclasses import replace
from itertools import chain
from pathlib import Path

import pytest

from interlock.app.check import check_file
from interlock.model.elements import SectionId
from interlock.model.traversal import Topology
from interlock.proof.claims import CLAIMS, Facts, claims
from interlock.proof.engines.limits import Limits
from interlock.proof.induction.inductive import inductive, open_claims
from interlock.proof.induction.parts import Goal, Parts
from interlock.proof.induction.search import search
from interlock.proof.induction.verdict import Verdict
from interlock.proof.prover import prove
from interlock.proof.system.neighbourhood import walked
from interlock.proof.system.transition import System
from tests.campaigns.assumptions import CASES, OTHERS, SENTENCES, harm
from tests.certified import accepted, certified
from tests.layouts import SHIPPED, built

SHORT = Limits(search_depth=12, search_s=60)


@pytest.mark.parametrize("name", SHIPPED)
def test_every_claim_is_proved_and_every_route_driven(name: str) -> None:
    layout, _, controller = built(name)
    result = prove(System(layout, controller), SHORT)
    assert [c.id for c in result.claims] == list(CLAIMS)
    assert {c.verdict for c in result.claims} == {Verdict.PROVED}, [c for c in result.claims if c.open]
    assert result.dropped == ()
    assert all(w.ok for w in result.witnesses) and len(result.witnesses) == len(controller.symbols.routes)
    assert result.proved


@pytest.mark.parametrize("engine", ["z3", "cvc5"])
@pytest.mark.parametrize("name", SHIPPED)
def test_other_engines_come_to_the_same_verdicts(name: str, engine: str) -> None:
    layout, _, controller = built(name)
    system = System(layout, controller)
    limits = Limits(engine=engine)
    kept, dropped, _ = inductive(system, limits)
    assert not dropped and not open_claims(system, kept, claims(Facts(system)), limits)


@pytest.mark.parametrize(
    "name",
    [
        "token_unused",
        "token_berth",
        "token_excluded",
        "token_one_track",
        "limits_of_shunt",
        "identifier_whole",
        "foul_siding",
    ],
)
def test_what_was_unknown_is_proved_and_certified(name: str, tmp_path: Path) -> None:
    """A token that no route needs, or one excluded route: T-LINE; limits of shunt on both sides of a berth: T-COLLISION
    and more; a point over one leg of which no route leads: T-FOUL and T-DERAIL."""
    assert accepted(certified(Path(f"tests/layouts_for_tests/{name}.yaml"), tmp_path))


def test_an_overlap_that_comes_round_lies_foul_of_itself_alone() -> None:
    """Its own lock was taken for one that it excludes: what is held by nobody else was not proved of it."""
    layout, _, controller = built("../tests/layouts_for_tests/overlap_foul_of_itself")
    result = prove(System(layout, controller), SHORT)
    assert result.proved and result.dropped == ()


def test_a_line_with_a_token_over_which_no_route_leads_out_is_told_what_helps() -> None:
    told = check_file("tests/layouts_for_tests/token_unused.yaml").diagnostics
    fix = next(d.fix for d in told if d.code == "IL7004")
    assert fix == "add a signal that leads there, or say `trains: in`, without a direction token"


def test_a_wrong_waiver_is_refuted_with_a_story() -> None:
    layout, _, controller = built("refuted/wrong_waiver")
    result = prove(System(layout, controller), SHORT)
    flank = next(c for c in result.claims if c.id == "T-FLANK")
    assert not result.proved and flank.verdict is Verdict.REFUTED and flank.story is not None
    steps = flank.story.steps
    assert steps[0].startswith("Restart: everything is locked")
    assert any("shows proceed" in s for s in steps) and any("A train enters at" in s for s in steps)
    assert steps[-1].startswith("This violates T-FLANK at DP:")


@pytest.mark.parametrize(("assumption", "name", "claim"), CASES)
def test_dropping_an_assumption_gives_a_train_movement_to_harm(assumption: str, name: str, claim: str) -> None:
    story = harm(assumption, name, claim)
    assert story is not None and story.claim == claim, f"{assumption} could be dropped"


def test_the_ledger_names_every_assumption() -> None:
    assert {a for a, _, _ in CASES} | set(OTHERS) == set(SENTENCES)
    ledger = Path("proofs/assumptions.md").read_text("utf-8")
    assert all(f"## {a}\n\n{text}" in ledger for a, text in SENTENCES.items())
    told = {a for a, _, _ in CASES if f"## {a}\n\n{SENTENCES[a]}\n\nWithout it, on `" in ledger}
    assert told == {a for a, _, _ in CASES}


@pytest.mark.parametrize("assumption", OTHERS)
def test_of_an_assumption_without_a_movement_to_harm_there_is_nothing_to_drop(assumption: str) -> None:
    # what has a switch gets its movement to harm searched for, and none is said of it unsearched
    for name in {name for _, name, _ in CASES}:
        layout, _, controller = built(name)
        whole, without = (System(layout, controller, x) for x in (frozenset(), frozenset({assumption})))
        assert without.relation.definitions == whole.relation.definitions
        assert without.relation.inputs == whole.relation.inputs
        assert without.relation.assumptions == whole.relation.assumptions
        assert without.loop.plant.hazards == whole.loop.plant.hazards


def test_the_proof_page_tells_which_assumptions_tests_drop() -> None:
    page = Path("interlock/docs/proof.md").read_text("utf-8")
    dropped = page.split("Tests drop each of ")[1].split(", and find a train movement to harm")[0]
    assert set(re.findall(r"A-[A-Z-]+[A-Z]", dropped)) == {a for a, _, _ in CASES}


def test_without_scanning_before_moving_the_proof_does_not_hold() -> None:
    # A-SCAN: a train that leaves sections before they were scanned defeats the three-point check
    layout, _, controller = built("fig2_2")
    system = System(layout, controller, frozenset({"A-SCAN"}))
    kept, dropped, _ = inductive(system, SHORT)
    open_ = open_claims(system, kept, claims(Facts(system)), SHORT)
    assert dropped and "T-COLLISION" in open_


def test_claims_have_sentences_and_places() -> None:
    layout, _, controller = built("junction")
    found = claims(Facts(System(layout, controller)))
    assert {c.id for c in found} <= set(CLAIMS)
    assert {"T-COLLISION", "T-DIAMOND", "T-FLANK", "S-FLANK", "S-HOSTILE", "L-RELEASE"} <= {c.id for c in found}
    assert len({(c.id, c.place) for c in found}) == len(found)


def test_the_counterexample_replays_on_the_reference_interpreter() -> None:
    from interlock.logic.eval import Machine
    from interlock.logic.expr import conj, evaluate, neg, var

    layout, _, controller = built("refuted/wrong_waiver")
    system = System(layout, controller)
    machine = Machine(controller)
    for _ in range(2):
        machine.scan({}, 100)
    here = conj(var(n) if v else neg(var(n)) for n, v in machine.state.items())
    system.initial = replace(system.initial, parts=(*system.initial.parts, here))
    run = search(system, [c for c in claims(Facts(system)) if c.id == "T-FLANK"], 12, 60)
    assert run is not None
    for frame, following in zip(run.frames, run.frames[1:], strict=False):
        assert all(machine.state[s.name] == frame.state[s.name] for s in controller.state)
        for t in controller.timers:  # the run chose when delays are over: give the timer its time
            machine.elapsed[t.name] = t.preset_ms if frame.inputs[t.name] else None
        machine.scan(frame.inputs, 0)
        assert all(machine.state[s.name] == following.state[s.name] for s in controller.state)
    last = {**run.frames[-1].state, **run.frames[-1].inputs}
    for name, x in system.relation.definitions.items():
        last[name] = int(evaluate(x, last.__getitem__, {}))
    assert not evaluate(run.claim.expr, last.__getitem__, {})


def test_a_claim_sees_no_equation() -> None:
    """What claims and invariants are written in leads neither to the controller nor to the relation of its steps."""
    system = System(*(lambda x: (x[0], x[2]))(built("fig2_2")))
    facts = Facts(system)
    seen = [
        *vars(facts).values(),
        *(x for part in (facts.track, facts.locking, facts.seen) for x in vars(part).values()),
    ]
    seen += vars(facts.zones).values()
    assert len(seen) > 20 and facts.zones is system.zones
    hidden = (system, system.loop, system.loop.controller, system.relation, system.relation.definitions)
    assert not any(x is y for x in seen for y in hidden)


@pytest.mark.parametrize("name", SHIPPED)
def test_questions_are_asked_place_by_place(name: str) -> None:
    """Every question once; each section of the walk touches one before it, but where a part of the railway begins."""
    layout, _, controller = built(name)
    system = System(layout, controller)
    topo = system.loop.topo
    seen: set[str] = set()
    for s in walked(topo):
        touches = {topo.beyond(s, j) for j in topo.ends[s]} - {None}
        assert touches & seen or not _reached(topo, s) & seen
        seen.add(s)
    goals = [Goal(c.expr) for c in claims(Facts(system))]
    assert sorted(chain.from_iterable(Parts(system.relation, system.where, []).places(goals))) == list(
        range(len(goals))
    )


def _reached(topo: Topology, start: str) -> set[str]:
    found, todo = set[str](), [start]
    while todo:
        s = todo.pop()
        if s not in found:
            found.add(s)
            todo += [t for j in topo.ends[SectionId(s)] if (t := topo.beyond(SectionId(s), j)) is not None]
    return found
