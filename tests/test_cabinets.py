"""Each wire goes to one cabinet, and whoever is to be seen well is one (document B 2.2)."""

from __future__ import annotations

import pytest

from interlock.diag import Sink
from interlock.frontend import load_text

TEXT = """interlock: 1
name: cabinets
boundaries: {W: {approach: wa 600, trains: in}, E: {trains: out}}
tracks: {line: [W, a 200, b 200, E], side: [s 100, B]}
buffers: [B]
points:
  P: {section: p, toe: line.end, normal: out.start, reverse: side.start}
signals:
  X: {from: W, into: a}
  Y: {from: a, into: b}
sections: {s: {detected: no}}
"""
TEXT = TEXT.replace("b 200, E], side", "b 200], out: [c 200, E], side")


def told(more: str) -> list[str]:
    sink = Sink()
    load_text("cabinets.yaml", TEXT + more, sink)
    return [d.message for d in sink.diagnostics if d.code == "IL2014"]


ALL = "a, b, c, p, wa, P, X, Y"


@pytest.mark.parametrize(
    ("more", "said"),
    [
        (f"substations: {{one: [{ALL}]}}\n", []),
        ("substations: {one: [a, X], two: []}\n", []),
        ("substations: {one: [a], two: [], three: []}\n", ["the substations two, three are all empty"]),
        (
            f"substations: {{one: [{ALL}, s]}}\n",
            ["substation one: s is no section, machine, signal, device or condition"],
        ),
        ("substations: {one: [a], two: [b, a], three: []}\n", ["a is wired to one and to two"]),
        ("substations: {one: [a, b, a], two: []}\n", ["a is wired to one and to one"]),
        (f"substations: {{one: [{ALL.replace(', wa', '')}]}}\n", ["no substation is wired to wa"]),
        (f"substations: {{one: [{ALL.replace(', P', '')}]}}\n", ["no substation is wired to P"]),
        (f"substations: {{one: [{ALL}]}}\ndistants: {{V: {{of: X}}}}\n", ["no substation is wired to V"]),
        (f"substations: {{one: [{ALL}]}}\nhealth: {{main: {{}}}}\n", ["there is no substation main"]),
    ],
)
def test_every_wire_has_one_cabinet(more: str, said: list[str]) -> None:
    """A section without detection has no wire; an approach has one; the one empty list takes the rest; `main` is the
    cabinet of a layout that names none, and of no other."""
    assert told(more) == said
