"""Golden numbers of the source documents and of the drafts."""

from __future__ import annotations

from pathlib import Path

import pytest

from interlock.app.check import check_file
from interlock.diag import Sink
from interlock.frontend import load_text
from interlock.table.cells import RouteKind
from interlock.table.matrix import beyond_matrix, matrix
from interlock.table.rows import InterlockingTable


def table(name: str) -> InterlockingTable:
    checked = check_file(f"layouts/{name}.yaml")
    assert checked.ok and checked.table is not None, checked.diagnostics
    return checked.table


def test_the_papers_four_routes_give_the_papers_matrices() -> None:
    m = matrix(table("mine11"), named_only=True)
    assert m.routes == ("j1", "j2", "j3", "j4")
    assert m.sections == tuple(f"q{i}" for i in range(1, 12))
    assert ["".join(map(str, row)) for row in m.rows] == ["01010000000", "11100000000", "00001010101", "00000000011"]
    assert m.m_mt() == ((2, 1, 0, 0), (1, 3, 0, 0), (0, 0, 4, 1), (0, 0, 1, 2))
    assert tuple(m.mt_m()[i][i] for i in range(11)) == (1, 2, 1, 1, 1, 0, 1, 0, 1, 1, 2)


def test_the_junctions_diamond_conflict_is_missed_by_the_matrix_and_found_by_the_table() -> None:
    t = table("junction")
    m = matrix(t)
    a, b = m.routes.index("S1J-S5"), m.routes.index("S2J-S6")
    assert m.m_mt()[a][b] == 0
    assert ("S1J-S5", "S2J-S6") in {(x.a, x.b) for x in beyond_matrix(t)}
    hostile = next(h for h in t.route["S1J-S5"].locking.hostile if h.route == "S2J-S6")  # type: ignore[index]
    assert hostile.kind == "crossing" and "diamond X1" in hostile.because.text


@pytest.mark.parametrize(
    ("name", "routes", "sections", "points", "signals"),
    [
        ("mine11", 9, 13, 2, 7),
        ("fig2_1", 10, 12, 2, 8),
        ("fig2_2", 4, 4, 1, 3),
        ("fig2_3_split", 5, 5, 1, 4),
        ("passing_loop", 8, 8, 2, 6),
        ("heishan", 19, 12, 5, 12),
        ("junction", 11, 14, 2, 9),
        ("terminus", 12, 10, 6, 5),
    ],
)
def test_sizes_agree_with_the_drafts(name: str, routes: int, sections: int, points: int, signals: int) -> None:
    checked = check_file(f"layouts/{name}.yaml")
    assert checked.layout is not None and checked.table is not None
    layout = checked.layout
    plain = [r for r in checked.table.routes if r.kind is not RouteKind.CALL_ON]
    assert (len(plain), len(layout.track.sections), len(layout.pointwork.points), len(layout.signalling.signals)) == (
        routes,
        sections,
        points,
        signals,
    )


@pytest.mark.parametrize(("name", "routes"), [("pit_bottom", 16), ("incline_hoist", 9), ("fig2_3_whole", 4)])
def test_sizes_that_differ_from_the_drafts_on_purpose(name: str, routes: int) -> None:
    # pit_bottom: two draft paths run into the one-way tippler; incline_hoist: the draft's exit signal at the
    # boundary governs no track of the layout
    assert len(table(name).routes) == routes


@pytest.mark.parametrize(
    ("name", "hostile"),
    [("mine11", 15), ("fig2_2", 6), ("fig2_3_split", 6), ("heishan", 61), ("passing_loop", 14), ("fig2_1", 8)],
)
def test_hostile_pairs_agree_with_the_drafts(name: str, hostile: int) -> None:
    # the drafts count pairs excluded by points or sharing a section; alternatives from one signal share its
    # first section
    t = table(name)
    plain = {r.id for r in t.routes if r.kind is not RouteKind.CALL_ON}
    assert sum(h.route in plain for r in t.routes if r.id in plain for h in r.locking.hostile) == 2 * hostile


def test_flank_of_the_diamond_is_a_real_demand() -> None:
    t = table("junction")
    up = t.route["S2J-S6"]  # type: ignore[index]
    demands = {(p.machine, p.position, p.role) for p in up.locking.points}
    assert ("101", "N", "flank") in demands and ("102", "N", "path") in demands


def test_both_legs_behind_a_toe_are_protected() -> None:
    t = table("heishan")
    out = t.route["XL1-XT3"]  # type: ignore[index]
    cell = next(c for c in out.locking.flank if c.requester == "P1.normal")
    assert {str(p) for p in cell.providers} == {"XT7", "XL2"}


def test_conditions_are_required_where_the_layout_says() -> None:
    t = table("incline_hoist")
    needs = {c.condition for c in t.route["XU-XM"].conditions.external}  # type: ignore[index]
    assert needs == {"HOIST_STOPPED", "ROPE_ATTACHED", "NO_PERSON", "B1_OPEN", "B2_OPEN"}
    assert {c.condition for c in t.route["XL-XD3"].conditions.external} == set()  # type: ignore[index]


def test_every_cell_carries_its_reason() -> None:
    from interlock.table.columns import COLUMNS

    for name in ("mine11", "junction", "terminus", "pit_bottom"):
        for r in table(name).routes:
            for c in COLUMNS:
                for text, because in c.items(r):
                    assert text and because.rule.startswith("R") and because.text


def test_a_foul_joint_keeps_the_siding_clear_for_the_main_line() -> None:
    checked = check_file("tests/layouts_for_tests/foul_joint.yaml")
    assert checked.ok and checked.table is not None
    main = checked.table.route["X1-E"]  # type: ignore[index]
    assert [c.section for c in main.clear.foul] == ["s"] and "foul of point P" in main.clear.foul[0].because.text
    assert [c.section for c in checked.table.route["X1-B"].clear.foul] == ["m"]  # type: ignore[index]
    assert {d.code for d in checked.diagnostics} == {"IL3018", "IL3045"}


@pytest.mark.parametrize(
    ("old", "new", "told"),
    [
        ("", "", True),
        ("trains: out", "trains: both", True),  # whatever keeps those away that come in
        ("trains: out", "trains: in", True),  # one that waits there
        ("legs: 9", "legs: 9, fouling: 4", False),
        ("normal: W8", "normal: t9.start", False),  # there is a section to be clear
    ],
)
def test_a_boundary_at_which_a_train_stands_foul_is_told(old: str, new: str, told: bool) -> None:
    text = Path("tests/diagnostics/IL3041.yaml").read_text("utf-8").replace(old, new)
    if "t9" in text:
        text = text.replace("tracks:\n", "tracks:\n  t9: [s9 50, W8]\n")
    sink = Sink()
    load_text("demo.yaml", text, sink)
    assert ("IL3041" in {d.code for d in sink.diagnostics}) is told


@pytest.mark.parametrize(
    ("old", "new", "told"),
    [
        ("", "", True),
        ("overlap_release_s: 60", "overlap_release_s: 85", True),  # 1200 m at 60 km/h, the last of them braking: 85.9 s
        ("overlap_release_s: 60", "overlap_release_s: 86", False),
        ("s1 1200", "s1 700", False),  # 55.9 s
        ("s1 1200", "s1 100", False),  # 18.3 s, the whole way braking
        ("line_speed_kmh: 60", "line_speed_kmh: 90", True),  # 68.8 s
        ("overlap_m: 100", "overlap_m: 0", False),
        ("signals:", "overlaps: {X: {length: 100, release_by_length: yes}}\nsignals:", False),
        ("signals:", "overlaps: {X: {length: 100, release: 80}}\nsignals:", True),
    ],
)
def test_an_overlap_that_is_released_while_the_fastest_train_runs_is_told(old: str, new: str, told: bool) -> None:
    text = Path("tests/diagnostics/IL3035.yaml").read_text("utf-8").replace(old, new)
    sink = Sink()
    load_text("demo.yaml", text, sink)
    assert ("IL3035" in {d.code for d in sink.diagnostics}) is told


def test_foul_joints_are_claimed_and_a_missing_exclusion_is_killed() -> None:
    from interlock.logic.lower import lower
    from interlock.proof.engines.limits import Limits
    from interlock.proof.mutation.movements import Fate, run_mutants
    from interlock.proof.prover import prove
    from interlock.proof.system.transition import System

    checked = check_file("tests/layouts_for_tests/foul_joint.yaml")
    assert checked.layout is not None and checked.table is not None
    result = prove(System(checked.layout, lower(checked.layout, checked.table)))
    assert result.proved and next(c.places for c in result.claims if c.id == "T-FOUL") == 2
    outcomes = run_mutants(checked.layout, checked.table, 0, Limits(search_depth=0), only=("diamond-not-excluded",))
    assert any(o.fate is not Fate.REDUNDANT and "T-FOUL" in o.claims for o in outcomes)
