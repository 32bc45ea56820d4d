"""What lengths and speeds need, by numbers: the shorter way where a train must not come sooner, the longer one where it
must not run on; the faster speed, and the slower slope."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from interlock.app.check import check_file
from interlock.derivation import derive
from interlock.diag import Sink
from interlock.frontend import load_text
from interlock.model.elements import SignalId
from interlock.model.layout import Layout
from interlock.model.needs import before, needs, standing_s, turning_s
from interlock.model.overlap import overlap_length

LAYOUTS = "tests/layouts_for_tests"


def read(text: str) -> Layout:
    sink = Sink()
    layout, _ = load_text("needs.yaml", text, sink)
    assert layout is not None, sink.diagnostics
    return layout


@pytest.mark.parametrize(
    ("kmh", "falling", "metres"),
    [
        (40, 0, 50),
        (41, 0, 100),
        (60, 0, 100),
        (61, 0, 200),
        (60, 5, 150),
        (60, -5, 75),
        (100, 10, 400),
        (100, -10, 100),
    ],
)
def test_an_overlap_is_longer_where_the_track_falls_and_no_shorter_than_half_as_much_where_it_rises(
    kmh: float, falling: float, metres: float
) -> None:
    assert overlap_length(kmh, falling) == pytest.approx(metres)


def test_of_two_ways_to_a_signal_the_shorter_counts_for_who_comes_and_the_longer_for_who_still_runs() -> None:
    found = check_file(f"{LAYOUTS}/overlaps_join.yaml").layout
    assert found is not None
    way = before(found, SignalId("G47"))
    assert way is not None and (way.section, way.metres) == ("s21", 40.0)
    quick = replace(found, principles=replace(found.principles, braking_ms2=100.0))  # it stands nearly at once
    v = way.kmh / 3.6  # m/s
    assert standing_s(quick, SignalId("G47")) == pytest.approx(60.0 / v + v / 200.0)


LINE = """interlock: 1
name: line
principles: {line_speed_kmh: 40}
boundaries: {W: {approach: wa 900, trains: in}, E: {trains: out}}
tracks: {line: [W, a 200, b 200, E]}
signals: {X: {from: W, into: a}, S: {from: a, into: b}}
"""


def test_whatever_ran_at_a_power_cut_may_have_run_as_fast_as_the_fastest_section_permits() -> None:
    slow, fast = read(LINE), read(LINE + "sections: {b: {speed: 100}}\n")
    more = (100 - 40) / 3.6 / slow.principles.braking_ms2
    assert needs(fast).restart - needs(slow).restart == pytest.approx(1000 * more, abs=2)


def test_points_of_an_overlap_turn_until_the_supervision_of_the_slowest_and_its_output_are_over() -> None:
    text = (
        Path(f"{LAYOUTS}/swing.yaml").read_text("utf-8")
        + "principles: {line_speed_kmh: 20, restart_delay_s: 400, overlap_release_s: 90}\n"
    )
    layout = read(text.replace("P3: {section: q5,", "P3: {section: q5, supervision: 47,"))
    g, rules = SignalId("X3"), layout.principles
    assert turning_s(layout, g) == rules.output_delay_s + 47
    assert turning_s(read(text), g) == rules.output_delay_s + rules.point_supervision_s


def test_a_signal_closes_with_the_first_axle_where_vehicles_can_stand_before_it_though_none_are_left_there() -> None:
    """`berth: no` keeps shunting movements out of an occupied road; those that come in stand there still (R3)."""
    text = Path(f"{LAYOUTS}/closing.yaml").read_text("utf-8") + "sections: {g1: {berth: no}}\n"
    sink = Sink()
    table = derive(read(text), sink)
    closing = {r.id: r.signal.closing.whole for r in table.routes if r.entry == "S1"}
    assert closing and set(closing.values()) == {None}, closing
    assert any(r.signal.closing.whole is not None for r in table.routes), "others stay open"
