"""Derailers and trap points that no route lays: which of the slips it is, and where nothing is said."""

from __future__ import annotations

from pathlib import Path

import pytest

from interlock.app.check import check_file

YARD = """interlock: 1
name: yard
principles: {{line_speed_kmh: 60{principles}}}
boundaries:
  W: {{approach: wa 400}}
  E: {{approach: ea 400}}
buffers: [B]
{traps}tracks:
  west: [W, a 300]
  east: [c 300, E]
  siding: [{siding}]
points:
  P: {{section: b, toe: west.end, normal: east.start, legs: {legs}}}
{derailer}signals:
  XW: {{from: W, into: a}}
  XE: {{from: E, into: c}}
  A: {{from: a, into: b}}
  C: {{from: c, into: b}}
  {shunt}
"""
ON = "derailers:\n  D: {section: b, inner: P.reverse, outer: siding.start}\n"
OFF = "derailers:\n  D: {section: b, outer: P.reverse, inner: siding.start}\n"
TRAP = "  T: {section: t, toe: siding.start, reverse: P.reverse, normal: drag, legs: 30}\n"
WRONG = "  T: {section: t, reverse: siding.start, toe: P.reverse, normal: drag, legs: 30}\n"


def found(
    folder: Path, derailer: str, *, principles: str = "", siding: str = "s 100, B", shunt: str = "", legs: int = 30
) -> list[str]:
    """What is said of a yard whose siding is kept off by a derailer or a trap point."""
    traps = "traps: [drag]\n" if "drag" in derailer else ""
    into = "t" if traps else "b"
    shunt = shunt or f"S: {{from: s, into: {into}, kind: combined}}"
    text = YARD.format(principles=principles, traps=traps, siding=siding, derailer=derailer, shunt=shunt, legs=legs)
    path = folder / "yard.yaml"
    path.write_text(text, "utf-8")
    done = check_file(str(path))
    assert done.ok and done.table is not None, done.diagnostics
    said = [d for d in done.diagnostics if d.code == "IL7016"]
    laid = {(d.machine, str(d.position)) for r in done.table.routes for d in r.locking.points}
    assert bool(said) == (not laid & {("D", "N"), ("T", "N")}), (
        "in these yards it is warned of where it protects nothing"
    )
    assert all(d.about is not None and d.span is not None for d in said)
    return [f"{d.message} | {d.fix}" for d in said]


@pytest.mark.parametrize("principles", ["", ", flank_by: signal"])
@pytest.mark.parametrize("right", [ON, TRAP])
def test_one_that_routes_lay_is_passed_over(tmp_path: Path, right: str, principles: str) -> None:
    assert found(tmp_path, right, principles=principles) == []


def test_a_derailer_the_wrong_way_round(tmp_path: Path) -> None:
    (said,) = found(tmp_path, OFF)
    assert "seen from P.reverse it is the wrong way round" in said and "exchange `inner` and `outer` of D" in said
    assert found(tmp_path, OFF, principles=", flank_by: signal") == [said], "no principle turns it round"


def test_a_trap_point_the_wrong_way_round(tmp_path: Path) -> None:
    (said,) = found(tmp_path, WRONG)
    assert "leads into the trap what runs out" in said and "exchange `toe` and `reverse` of T" in said


def test_a_signal_between_the_points_and_the_derailer(tmp_path: Path) -> None:
    """No principle helps there: the search ends at the signal."""
    inside = "derailers:\n  D: {section: d, inner: near.end, outer: siding.start}\n"
    shunt = "S: {from: n, into: b, kind: combined}\n  SS: {from: s, into: d, kind: shunt}"
    (said,) = found(tmp_path, inside, siding="s 100, B]\n  near: [P.reverse, n 60", shunt=shunt)
    assert "signal S stands between it and P.reverse" in said and "set S further out than D" in said


def test_a_signal_too_near_to_the_points_is_not_the_one_that_is_trusted(tmp_path: Path) -> None:
    """S stands 10 m from P, where 15.5 m are needed: it is past S2, which protects, that the derailer lies idle."""
    inside = "derailers:\n  D: {section: d, inner: near.end, outer: siding.start}\n"
    shunt = "S: {from: n, into: b, kind: combined}\n  S2: {from: n2, into: n}\n  SS: {from: s, into: d, kind: shunt}"
    (said,) = found(tmp_path, inside, siding="s 100, B]\n  near: [P.reverse, n 60, n2 60", shunt=shunt, legs=10)
    assert "signal S2 stands between it and P.reverse" in said and "set S2 further out than D" in said


def test_the_trap_of_a_running_line_is_for_those_that_come_to_its_toe() -> None:
    """A sand drag behind a signal, which only an overlap would lay: not the wrong way round."""
    done = check_file("tests/layouts_for_tests/devices.yaml")
    assert done.table is not None and not any(d.code == "IL7016" for d in done.diagnostics)
    assert not any((d.machine, str(d.position)) == ("P6", "R") for r in done.table.routes for d in r.locking.points)
