"""The same layout in lengths and in kilometres is the same layout; positions that contradict each other are told."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
import yaml

from interlock.checker.drawing import drawing
from interlock.checker.reading import loaded
from interlock.derivation import derive
from interlock.diag import Sink
from interlock.frontend import load_text
from interlock.frontend.scalars import position, written_km
from interlock.model.layout import Layout
from interlock.verify import Rejected
from tests.layouts import SHIPPED

START = 12_345.6


def layout_of(text: str) -> tuple[Layout | None, list[str]]:
    sink = Sink()
    layout, _ = load_text("x.yaml", text, sink)
    return layout, [f"{d.code}: {d.message}" for d in sink.diagnostics if d.severity == "error"]


def written(body: Any) -> str:
    return str(yaml.safe_dump(body, allow_unicode=True, sort_keys=False, default_flow_style=None, width=1000))


def with_posts(body: dict[str, Any], rising: bool = True) -> dict[str, Any]:
    """The same with a position before and after each section of every track, and no length."""
    tracks = {}
    for k, (name, items) in enumerate((body.get("tracks") or {}).items()):
        here, out = START + 1000.0 * k, []
        seen = False
        for item in items:
            words = item.split()
            if len(words) == 2:
                if not seen:
                    out.append(written_km(here))
                here += float(words[1]) if rising else -float(words[1])
                out += [words[0], written_km(here)]
                seen = True
            else:
                out.append(item)
        tracks[name] = out
    return {**body, "tracks": tracks}


@pytest.mark.parametrize("name", SHIPPED)
def test_a_layout_in_kilometres_is_the_layout_in_lengths(name: str) -> None:
    text = Path(f"layouts/{name}.yaml").read_text("utf-8")
    plain, _ = layout_of(text)
    for rising in (True, False):
        posted = written(with_posts(loaded(text), rising))
        other, errors = layout_of(posted)
        assert errors == [] and plain is not None and other is not None
        assert other.digest == plain.digest and other.track.edges == plain.track.edges
    assert drawing(loaded(posted)).edges == drawing(loaded(text)).edges, "the checker reads the same"


LINE = """interlock: 1
name: line
boundaries: {W: {approach: aw 600}, E: {approach: ae 600}}
tracks:
  west: [W, %s]
  main: [%s]
  side: [s2 300]
  east: [%s, E]
points:
  1: {section: T1, toe: west.end, normal: main.start, reverse: side.start, legs: 40%s}
  2: {section: T2, toe: east.start, normal: main.end, reverse: side.end, legs: 40%s}
signals:
  A: {from: W, into: w1%s}
  B: {from: w2, into: T1%s}
  C: {from: E, into: e1}
  D: {from: e1, into: T2}
  N1: {from: m1, into: T2}
  N2: {from: s2, into: T2}
  S1: {from: m1, into: T1}
  S2: {from: s2, into: T1}
"""
PLAIN = LINE % ("w1 200, w2 400", "m1 300", "e1 250", "", "", "", "")
FORMS = {
    "posts in tracks": LINE % ("9+000, w1, 9+200, w2, 9+600", "m1 300", "e1 250", "", "", "", ""),
    "signals": LINE % ("w1 200, w2", "m1 300", "e1 250", "", "", ", km: 9+000", ", km: 9+600"),
    "points, and a length that is left over": LINE
    % ("9+000, w1, 9+200, w2", "m1", "e1, 10+310", ", km: 9+640", ", km: 10+020", "", ""),
    "all of it, twice": LINE
    % ("9+000, w1 200, 9+200, w2 400", "m1 300", "e1 250", ", km: 9+640", ", km: 10+020", ", km: 9+000", ", km: 9+600"),
}


@pytest.mark.parametrize("form", FORMS)
def test_positions_stand_in_tracks_at_signals_and_at_points(form: str) -> None:
    plain, _ = layout_of(PLAIN)
    text = FORMS[form]
    other, errors = layout_of(text)
    assert errors == [] and plain is not None and other is not None and other.digest == plain.digest
    assert drawing(loaded(text)).edges == drawing(loaded(PLAIN)).edges
    assert other.track.edges == plain.track.edges and derive(other, Sink()).routes == derive(plain, Sink()).routes


def change(old: str, new: str) -> Callable[[str], str]:
    return lambda text: text.replace(old, new)


WRONG = {
    "IL3028: signal A says 9+001, where a position of the track says 9+000": change(
        "A: {from: W, into: w1, km: 9+000", "A: {from: W, into: w1, km: 9+001"
    ),
    "IL3028: between 9+000 and 9+200 lie 200 m, but w1 has 201 m": change("w1 200", "w1 201"),
    "IL3028: point 1, 40 m from it, says 9+601, where signal B says 9+600": change("km: 9+640", "km: 9+641"),
    "IL3028: track west: 9+600 (signal B) does not lie beyond 9+200 (a position of the track)": lambda text: (
        text.replace("9+000", "9+300")
    ),
    "IL3029: section m1 has no length, and the positions of its ends do not give it": lambda text: text.replace(
        "m1 300", "m1"
    ).replace(", km: 10+020", ""),
    "IL1013: '9+20' is not a position along the line": change("9+200", "9+20"),
}


@pytest.mark.parametrize("said", WRONG)
def test_positions_that_contradict_each_other_are_told(said: str) -> None:
    text = WRONG[said](FORMS["all of it, twice"])
    layout, errors = layout_of(text)
    assert layout is None and any(e.startswith(said) for e in errors), errors
    with pytest.raises(Rejected):
        drawing(loaded(text))


def test_positions_are_read_as_they_are_written() -> None:
    for text in ("0+000", "12+345.6", "9999+999.999", "7+040"):
        assert written_km(position(text)) == text
