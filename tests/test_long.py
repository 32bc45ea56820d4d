"""Layouts that are longer than calls may be deep, and rings on which no main signal stands."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Iterator
from fractions import Fraction
from pathlib import Path

import pytest

from interlock.checker.lengths import Lengths
from interlock.checker.railway import Railway
from interlock.checker.reading import loaded
from interlock.cli.main import DEPTH
from interlock.diag import Sink
from interlock.frontend import load_text
from interlock.model.farthest import farthest
from interlock.model.needs import needs

HEAD = """interlock: 1
name: long
principles: {{restart_delay_s: 86400}}
boundaries: {{W: {{approach: aW 600}}, E: {{approach: aE 600}}}}
{more}
"""


def loops(number: int) -> str:
    """So many loops in a row, with signals at the two boundaries alone."""
    tracks, points = ["line0: [W, a0 80]"], []
    for k in range(1, number + 1):
        tracks += [f"main{k}: [m{k} 60]", f"loop{k}: [l{k} 60]", f"line{k}: [a{k} 80{', E' * (k == number)}]"]
        legs = (f"normal: main{k}.{end}, reverse: loop{k}.{end}" for end in ("start", "end"))
        points += [f"P{k}: {{section: p{k}, toe: line{k - 1}.end, {next(legs)}}}"]
        points += [f"Q{k}: {{section: q{k}, toe: line{k}.start, {next(legs)}}}"]
    signals = ["X: {from: W, into: a0}", f"Y: {{from: E, into: a{number}}}"]
    return _text(tracks, points, signals)


def fan(number: int) -> str:
    """So many points in a row in one section, each with a track that ends at a buffer."""
    tracks, points = ["w: [W, a 50]", "e: [z 50, E]"], []
    for k in range(1, number + 1):
        toe, last = "w.end" if k == 1 else f"P{k - 1}.normal", ", normal: e.start" * (k == number)
        points.append(f"P{k}: {{section: p, toe: {toe}{last}, reverse: t{k}.start}}")
        tracks.append(f"t{k}: [t{k} 100, B{k}]")
    buffers = f"buffers: [{', '.join(f'B{k}' for k in range(1, number + 1))}]"
    return _text(tracks, points, ["X: {from: W, into: a}", "Y: {from: E, into: z}"], buffers)


def ring(first: str) -> str:
    """A ring of sections with no main signal, a and A0 among them, which a line reaches and another leaves; `first` is
    the track that is named first."""
    sections = {"a": "a 700", "b": "b 30", "c": "c 900", "r": "A0 500"}
    order = sorted(sections, key=lambda s: s != first)
    tracks = [f"t{s}: [{'W, ' * (s == 'c')}{sections[s]}{', E' * (s == 'b')}]" for s in order]
    points = [
        "P: {section: p, toe: ta.start, normal: tc.end, reverse: tr.start}",
        "Q: {section: q, toe: ta.end, normal: tb.start, reverse: tr.end}",
    ]
    return _text(tracks, points, ["X: {from: W, into: c}", "Y: {from: E, into: b}"])


def _text(tracks: list[str], points: list[str], signals: list[str], more: str = "") -> str:
    parts = {"tracks": tracks, "points": points, "signals": signals}
    rows = [row for part, lines in parts.items() if lines for row in (f"{part}:", *(f"  {line}" for line in lines))]
    return "\n".join([HEAD.format(more=more), *rows, ""])


def both(text: str) -> tuple[int, int]:
    """The time until every train stands after a power cut, by both readers, in milliseconds."""
    sink = Sink()
    layout, _ = load_text("long.yaml", text, sink)
    assert layout is not None, sink.diagnostics
    return needs(layout).restart, Lengths(Railway(loaded(text))).until_all_stand()


@pytest.fixture
def few_calls() -> Iterator[None]:
    """Calls may be hardly deeper than here, so that short layouts are long ones."""
    before, here, depth = sys.getrecursionlimit(), sys._getframe(), 0
    while here is not None:
        here, depth = here.f_back, depth + 1
    sys.setrecursionlimit(depth + 120)
    yield
    sys.setrecursionlimit(before)


@pytest.mark.usefixtures("few_calls")
@pytest.mark.parametrize("text", [loops(60), fan(150)], ids=["loops", "fan"])
def test_a_layout_longer_than_calls_are_deep_is_read_by_both_readers(text: str) -> None:
    ours, theirs = both(text)
    assert ours == theirs


@pytest.mark.parametrize(("depth", "code"), [(DEPTH, 0), (900, 1)])
def test_what_cannot_be_followed_is_said_to_be_too_long(depth: int, code: int, tmp_path: Path) -> None:
    """A signal at the far end of a line without one: from where its trains come is followed back all the way."""
    sections = 1200
    between = ", ".join(f"s{k} 60" for k in range(sections))
    path = tmp_path / "long.yaml"
    signals = ["X: {from: W, into: s0}", "Y: {from: E, into: z}", f"Z: {{from: s{sections - 1}, into: z}}"]
    path.write_text(_text([f"t: [W, {between}, z 50, E]"], [], signals), "utf-8")
    run = f"from interlock.cli import main; main.DEPTH = {depth}; main.main()"
    done = subprocess.run([sys.executable, "-c", run, "check", path], capture_output=True, text=True)
    assert done.returncode == code, done.stdout
    assert "Traceback" not in done.stderr and "internal error" not in done.stderr
    assert ("more sections follow on one another" in done.stderr) is bool(code)


@pytest.mark.parametrize("first", ["a", "b", "c", "r"])
def test_a_ring_is_run_round_whichever_part_is_named_first(first: str) -> None:
    ours, theirs = both(ring(first))
    assert ours == theirs == both(ring("a"))[0]
    assert ours > 1000 * (900 + 700 + 500) / (40 / 3.6)  # from W at half of 80 km/h, round and back to the point


def test_ways_that_lead_round_count_once_each() -> None:
    metres = {"in": Fraction(100), "a": Fraction(10), "b": Fraction(2), "out": Fraction(1)}
    after = {"in": ["b"], "a": ["b"], "b": ["a", "out"], "out": []}
    for order in (["a", "in", "b", "out"], ["in", "out", "a", "b"]):
        assert farthest(metres, {k: after[k] for k in order}) == 113
