"""A change of the layout that the book of tests has to notice: with the controller of before, and in what is new."""

from __future__ import annotations

from pathlib import Path

import pytest

from interlock.app.check import check_file
from interlock.app.commission import not_in
from interlock.commissioning.book import book
from interlock.commissioning.step import Sheet, Step
from interlock.emit.python.runtime import runtime_py
from interlock.logic.cabinet import allocate
from interlock.logic.controller import Controller
from interlock.logic.lower import lower
from interlock.model.layout import Layout
from interlock.table.rows import InterlockingTable
from tests.test_diff import BASE

RULES = "{line_speed_kmh: 60}"


class Changed:
    """A layout with some of its text replaced, and its books of before and after."""

    def __init__(self, folder: Path, *edits: tuple[str, str], before: str = BASE) -> None:
        text = before
        for was, now in edits:
            assert was in text
            text = text.replace(was, now)
        self.old, self.new = _derived(folder / "old.yaml", before), _derived(folder / "new.yaml", text)
        self.before, self.after = _book(self.old, self.old[2]), _book(self.new, self.new[2])
        assert [(s.do, s.expect, s.came) for s in (*self.before, *self.after) if s.came] == []

    @property
    def again(self) -> tuple[Step, ...]:
        """What is tested again."""
        return not_in(self.after, self.before)

    def not_loaded(self) -> list[Step]:
        """The tests that come out otherwise where the controller of before still runs."""
        return [s for s in _book(self.new, self.old[2]) if s.came]


def _derived(path: Path, text: str) -> tuple[Layout, InterlockingTable, Controller]:
    path.write_text(text, "utf-8")
    found = check_file(str(path))
    assert found.layout is not None and found.table is not None, found.diagnostics
    return found.layout, found.table, lower(found.layout, found.table)


def _book(of: tuple[Layout, InterlockingTable, Controller], runs: Controller) -> list[Step]:
    layout, table, controller = of
    return list(book(layout, table, controller, allocate(layout, controller), runtime_py(runs, [])))


@pytest.mark.parametrize(
    ("was", "now", "do"),
    [
        ("{line_speed_kmh: 60}", "{line_speed_kmh: 100}", "signal A at proceed, no train before it: cancel route A-AA"),
        (
            "{line_speed_kmh: 60}",
            "{line_speed_kmh: 100}",
            "signal N1 at proceed, route AA-N1 and route A-AA set before it, a train in wa alone: cancel route N1-E",
        ),
        ("wa 400", "wa 100", "signal A at proceed, no train before it: cancel route A-AA"),
    ],
)
def test_from_where_a_train_may_come_is_tested(tmp_path: Path, was: str, now: str, do: str) -> None:
    """Approach locking of a signal before which nobody sees far enough, and of sections beyond the first."""
    changed = Changed(tmp_path, (was, now))
    assert do in [s.do for s in changed.again] and do in [s.do for s in changed.not_loaded()]


SHARED = BASE.replace("P1: {section: w1,", "P1: {section: w1, machine: MP,")
DISTANT = BASE.replace("signals:", "distants:\n  DX: {of: N1}\nsignals:")


@pytest.mark.parametrize(
    ("before", "edits", "variables"),
    [
        (
            BASE,
            [("N1: {from: g1, into: w2}", "N1: {from: g1, into: g1b}"), ("g1 500", "g1 300, g1b 200")],
            "YS_N1 CLR_g1",
        ),
        (BASE, [("g1 500", "g1 300, g1b 200"), ("N1: {from: g1,", "N1: {from: g1b,")], "CLR_g1 YS_N1"),
        (BASE, [("g1 500", "g1a 300, g1 200"), ("S1: {from: g1,", "S1: {from: g1a,")], "CLR_g1 YS_S1"),
        (BASE, [("west: [W, q1 200]", "west: [W, q1 160, w1 40]")], "CLR_q1 CLR_w1"),
        (BASE, [("wa 400", "wa 401")], "CLR_wa"),
        (BASE, [("N1:", "NX:"), ("N2:", "N1:"), ("NX:", "N2:")], "YS_N1 YP_N1 YS_N2 YP_N2"),
        (BASE, [("g1", "gq"), ("g2", "g1"), ("gq", "g2")], "CLR_g1 CLR_g2"),
        (BASE, [("P1", "PX"), ("P2", "P1"), ("PX", "P2")], "DN_P1 DR_P1 YN_P1 YR_P1 DN_P2 CLR_w1"),
        (BASE, [("normal: main.start, reverse: loop.start", "normal: loop.start, reverse: main.start")], "DN_P1 YR_P1"),
        (SHARED, [("P2: {section: w2,", "P2: {section: w2, machine: MP,")], "DN_MP DR_MP YN_MP YR_MP"),
        (DISTANT, [("DX: {of: N1}", "DX: {of: N2}")], "YD_DX YC_DX"),
    ],
)
def test_a_wire_that_means_another_place_is_tested_again(
    tmp_path: Path, before: str, edits: list[tuple[str, str]], variables: str
) -> None:
    wires = [s for s in Changed(tmp_path, *edits, before=before).again if s.sheet is Sheet.WIRES]
    said = {word.strip(":") for s in wires for word in (s.do + " " + s.expect).split()}
    assert [x for x in variables.split() if x not in said] == []


LOCAL = BASE.replace("kmh: 60", "kmh: 60, local_requests: last")
LAMPS = BASE.replace("{line_speed_kmh: 60}", "{line_speed_kmh: 60, lamp_proof: yes}")


@pytest.mark.parametrize(
    ("before", "was", "now", "said"),
    [
        (LAMPS, "lamp_proof: yes", "lamp_proof: yes, flank_lamp: yes", "which protects a flank, out: ask for"),
        (BASE, "kmh: 60", "kmh: 60, main_closes: whole-movement", "stays at proceed while g1 is occupied, too"),
        (LOCAL, "local_requests: last", "local_requests: first", "what is asked on the spot is heard alone"),
        (DISTANT, "DX: {of: N1}", "DX: {of: N2}", "distant DX shows clear"),
    ],
)
def test_a_cell_of_each_kind_is_tried(tmp_path: Path, before: str, was: str, now: str, said: str) -> None:
    changed = Changed(tmp_path, (was, now), before=before)
    for steps in (changed.again, changed.not_loaded()):
        assert [s for s in steps if said in f"{s.do}: {s.expect}"] != []


def test_requests_on_the_spot_are_tried_of_every_route(tmp_path: Path) -> None:
    changed = Changed(tmp_path, ("kmh: 60", "kmh: 60, local_requests: first"))
    said = "all clear, nothing set: ask for route {} on the spot (LREQ), by its number {}"
    assert {said.format(r.id, r.number) for r in changed.new[1].routes} <= {s.do for s in changed.again}


def test_what_closes_at_the_first_axle_again_is_tried(tmp_path: Path) -> None:
    whole = BASE.replace("kmh: 60", "kmh: 60, main_closes: whole-movement")
    changed = Changed(tmp_path, (", main_closes: whole-movement", ""), before=whole)
    for steps in (changed.again, changed.not_loaded()):
        assert [s for s in steps if "signal N1 shows stop at the first axle" in s.expect] != []


APART = """interlock: 1
name: apart
principles: {line_speed_kmh: 40}
boundaries:
  W: {approach: w0 300}
  S: {approach: s0 300}
  E: {trains: out}
  T: {trains: out}
tracks:
  main: [W, w1 150, k1 300, e1 200, E]
  side: [S, s1 300, t1 200, T]
signals:
  A: {from: W, into: w1}
  N: {from: k1, into: e1}
  B: {from: S, into: s1}
"""
HOSTILE = f"{APART}hostile:\n  - {{one: {{from: A}}, other: {{from: B}}, reason: r}}\n"


def test_a_declared_hostile_route_is_kept_out_as_long_as_is_asked_for(tmp_path: Path) -> None:
    """Until the train is wholly in the last section, where sections behind it are released already."""
    changed = Changed(tmp_path, (APART, HOSTILE), before=APART)
    said = "route A-N set, its train in w1 and k1: ask for route B-T, declared hostile"
    for steps in (changed.again, changed.not_loaded()):
        assert said in [s.do for s in steps]


def test_a_number_that_another_route_has_now_is_tried(tmp_path: Path) -> None:
    excluded = "exclude: [{from: A, to: AA, reason: r}]\nsignals:"
    changed = Changed(tmp_path, ("signals:", excluded))
    said = [s.do for s in changed.again if s.sheet is Sheet.ROUTES]
    routes = changed.new[1].routes
    assert [r.id for r in routes if not any(f"ask for route {r.id}, by its number {r.number}" in x for x in said)] == []


def test_a_time_is_told_with_all_its_digits(tmp_path: Path) -> None:
    before = BASE.replace("kmh: 60", "kmh: 60, approach_release_s: 1234.567")
    changed = Changed(tmp_path, ("1234.567", "1234.569"), before=before)
    assert [s for s in changed.again if "1234.569 s" in s.expect] != []


def test_a_restart_delay_that_changes_brings_the_release_of_what_is_clear_again(tmp_path: Path) -> None:
    changed = Changed(tmp_path, ("kmh: 60", "kmh: 60, restart_delay_s: 700"))
    start = [s for s in changed.again if s.sheet is Sheet.START]
    refused = "every section stays locked, route A-AA is refused"  # after a power cut
    assert [s.expect for s in start] == ["every section stays locked", "no section with detection is locked", refused]
