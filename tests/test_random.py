"""Properties of layouts that grow at random."""

from __future__ import annotations

from pathlib import Path

import pytest

from interlock.audit import audit
from interlock.audit.flank import open_flanks
from interlock.audit.walk import trips
from interlock.checker import specification
from interlock.checker.check import agree
from interlock.diag import Sink
from interlock.frontend import load_text
from interlock.logic.lower import lower
from interlock.proof.engines.limits import Limits
from interlock.proof.equivalence.structured_text import compare_dialect
from interlock.proof.induction.verdict import Verdict
from interlock.proof.prover import prove
from interlock.proof.system.transition import System
from interlock.st.delivery import write_st
from interlock.st.dialects import BY_NAME
from tests.grow import grow
from tests.grow_all import grow_all, words
from tests.layouts import built, grown
from tests.written import told

REFUSABLE = {"IL4001", "IL4002", "IL4003", "IL4008", "IL4016", "IL4018", "IL3006", "IL3015", "IL3019", "IL3022"}


@pytest.mark.parametrize("block", range(8))
def test_derivation_and_audit_agree(block: int) -> None:
    compared = 0
    for seed in range(block * 40, block * 40 + 40):
        made = grown(grow(seed))
        if made is None:
            continue
        layout, table, sink = made
        errors = {d.code for d in sink.diagnostics if d.severity == "error"}
        assert errors <= REFUSABLE, (seed, errors)
        if errors - {"IL4016"}:
            continue
        barred = [
            f for f in audit(layout, table) if f.column == "route" and ("own train" in f.text or "no room" in f.text)
        ]
        assert audit(layout, table) == tuple(barred) and bool(barred) == bool(errors), seed
        compared += 1
    assert compared >= 12  # eight blocks: at least 100 layouts


def test_derivation_audit_and_second_checker_agree_on_layouts_with_every_kind_of_element() -> None:
    seen: set[str] = set()
    for seed in (*range(20), 21, 59):
        text = grow_all(seed)
        made = grown(text)
        if made is None or made[2].has_errors:
            continue
        assert audit(made[0], made[1]) == (), seed
        assert agree(*told(text), specification.shipped()).left == (), seed
        seen |= words(text)
    assert {"kind: board", "kind: limit", "stops_trains", "tracks end to end", "names of other scripts"} <= seen
    assert {"listed: no", "automatic", "demand", "hostile", "overlaps: entry_speed", "conditions", "health"} <= seen
    assert {"identifier", "hold", "exclude: call-on", "air_lock"} <= seen


def test_what_the_derivation_calls_unprotected_the_audit_reaches_however_points_lie() -> None:
    import itertools

    from interlock.model.elements import Position

    seen = 0
    for seed in range(400):
        made = grown(grow(seed))
        if made is None:
            continue
        layout, _, sink = made
        machines = sorted(layout.machines.ends)
        named = [d.message.split(" from ")[1].split(";")[0] for d in sink.diagnostics if d.code == "IL4001"]
        if not named or len(machines) > 5 or any(d.code == "IL4002" for d in sink.diagnostics):
            continue
        all_trips = [
            t
            for g in layout.signalling.signals
            for k in (False, True)
            if (g.shunt if k else g.main)
            for t in trips(layout, g, k)
        ]
        for requester in named:
            point = requester.split(".")[0]
            if point not in layout.pointwork.point:
                continue
            leg = "N" if requester.endswith("normal") else "R"
            for trip in all_trips:
                if not any(layout.pointwork.point[point].node == m.node for m in trip.moves[:-1]):  # type: ignore[index]
                    continue
                used = dict(trip.positions)
                if used.get(layout.pointwork.point[point].machine) == leg:  # type: ignore[index]
                    continue
                for choice in itertools.product(Position, repeat=len(machines)):
                    frozen = {**dict(zip(machines, choice, strict=True)), **used}
                    assert any(p.name == f"{point}.{leg}" for p in open_flanks(layout, trip, frozen)), (seed, requester)
                seen += 1
    assert seen >= 10


@pytest.mark.parametrize("seed", [8, 20, 27, 41, 43, 82, 90, 95, 106, 128, 222, 232])
def test_random_layouts_are_proved_and_their_text_equals_the_controller(seed: int) -> None:
    made = grown(grow(seed))
    if made is None or made[2].has_errors:
        pytest.fail("choose another seed: this one is not valid")
    layout, table, _ = made
    controller = lower(layout, table)
    result = prove(System(layout, controller), Limits(search_s=10))
    assert {c.verdict for c in result.claims} == {Verdict.PROVED}
    assert result.dropped == ()
    assert compare_dialect(controller, BY_NAME["iec"], write_st(controller, BY_NAME["iec"], [])).proved


@pytest.mark.parametrize("seed", [8, 27, 43, 95, 128])
def test_voyages_and_automatic_working_on_random_layouts_are_proved(seed: int) -> None:
    made = grown(grow(seed))
    assert made is not None and not made[2].has_errors
    table = made[1]
    by_entry = {r.entry: r for r in reversed(table.routes) if r.kind == "main"}
    pairs = [(a, by_entry[a.exit]) for a in table.routes if a.kind == "main" and a.exit in by_entry]  # type: ignore[index]
    apart = [(a, b) for a, b in pairs if set(a.path.section_ids).isdisjoint(b.path.section_ids)]
    chains = [f"  V{i}: {{from: {a.entry}, to: {b.exit}}}" for i, (a, b) in enumerate(apart[:4])]
    assert chains, "choose another seed: no two routes follow each other"
    first = apart[0][0]
    again = grown(
        grow(seed) + "\n".join(["voyages:", *chains, "automatic:", f"  - {{from: {first.entry}, to: {first.exit}}}"])
    )
    assert again is not None and not again[2].has_errors
    layout, table, _ = again
    assert len(table.voyages) == len(chains) and audit(layout, table) == ()
    controller = lower(layout, table)
    result = prove(System(layout, controller), Limits(search_s=10))
    assert {c.verdict for c in result.claims} == {Verdict.PROVED} and not result.dropped
    assert compare_dialect(controller, BY_NAME["iec"], write_st(controller, BY_NAME["iec"], [])).proved


@pytest.mark.parametrize(
    "name",
    [
        *("overlaps_join", "overlap_unused", "overlap_berth", "overlap_head", "balloon", "foul_beyond"),
        *("one_way_rear", "no_calling_on", "overlap_one_way", "foul_of_itself"),
    ],
)
def test_layouts_on_which_random_growth_once_found_a_fault(name: str) -> None:
    layout, table, controller = built(f"../tests/layouts_for_tests/{name}")
    assert audit(layout, table) == ()
    result = prove(System(layout, controller), Limits(search_s=5))
    assert {c.verdict for c in result.claims} == {Verdict.PROVED} and not result.dropped


def test_a_signal_to_which_no_train_comes_is_refused() -> None:
    """Whoever stood before it at a restart would be called on against the only direction of his track."""
    text = Path("tests/layouts_for_tests/one_way_rear.yaml").read_text("utf-8")
    sink = Sink()
    load_text("layout.yaml", f"{text}  M: {{from: l1, into: l2}}\n", sink)
    assert [(d.code, d.message) for d in sink.diagnostics] == [
        ("IL3019", "no train comes to M: the only direction of l1 leads away from it")
    ]


BALLOON = """
interlock: 1
name: balloon
boundaries:
  W: {approach: ap 100}
  W11: {approach: ap12 100, trains: out}
  W13: {approach: ap14 100, trains: out}
buffers: [B10, B15]
tracks:
  t1: [W, s2 90]
points:
  P3: {section: s2, reverse: t1.end, legs: 250}
  P4: {section: s2, normal: P3.toe, reverse: P3.normal}
  P5: {section: s2, toe: P4.toe}
  P6: {section: s7, reverse: P5.reverse, legs: 5, normal: B10, toe: W11}
  P8: {section: s9, toe: P5.normal, normal: W13, reverse: B15}
signals:
  X: {from: W, into: s2, kind: combined}
  G17: {from: s2, into: s9, kind: combined}
"""
ONE_WAY = """
interlock: 1
name: one_way
boundaries:
  W: {approach: ap 100}
  E: {approach: ap26 100, trains: out}
buffers: [B]
tracks:
  t1: [W, s2 20]
  t5: [s6 250, E]
  t11: [s12 5, s13 90, B]
points:
  P3: {section: s4, reverse: t1.end, legs: 12, toe: t5.start, normal: t11.start}
sections:
  s12: {one_way: backward}
signals:
  X: {from: W, into: s2}
  G28: {from: s2, into: s4}
  G32: {from: s12, into: s4}
"""


@pytest.mark.parametrize("text", [BALLOON, ONE_WAY], ids=["balloon", "one_way"])
def test_what_a_long_run_over_random_layouts_showed(text: str) -> None:
    """No train comes through one section over a point in both of its positions (R8); a vehicle may stand foul of a
    point where trains run in one direction only (R7)."""
    made = grown(text)
    assert made is not None and not made[2].has_errors
    assert audit(made[0], made[1]) == ()
    assert agree(*told(text), specification.shipped()).left == ()
