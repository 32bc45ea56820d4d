"""What is proposed for a misspelt name or word: the one that is meant, and never its opposite."""

from __future__ import annotations

import pytest

from interlock.diag import Sink
from interlock.diag.suggest import did_you_mean, nearest
from interlock.frontend import load_text

DIAMOND = ("1a", "1b", "2a", "2b")
POINT = ("toe", "normal", "reverse")
TRACK = ("start", "end")


@pytest.mark.parametrize(
    ("end", "ends", "meant"),
    [
        ("a2", DIAMOND, "2a"),
        ("b1", DIAMOND, "1b"),
        ("1A", DIAMOND, "1a"),
        ("2", DIAMOND, None),
        ("1c", DIAMOND, None),
        ("begin", TRACK, "start"),
        ("beginning", TRACK, "start"),
        ("strat", TRACK, "start"),
        ("e", TRACK, "end"),
        ("bend", TRACK, "end"),
        ("middle", TRACK, None),
        ("revers", POINT, "reverse"),
        ("n", POINT, "normal"),
        ("minus", POINT, None),
        ("abnormal", POINT, None),
        ("in", ("outer", "inner"), "inner"),
        ("other", ("outer", "inner"), "outer"),
    ],
)
@pytest.mark.parametrize("name", ["X", "Weiche 1234"])
def test_of_the_ends_of_an_element_the_one_that_is_meant(
    name: str, end: str, ends: tuple[str, ...], meant: str | None
) -> None:
    """`X.a2` and `X.b1` were taken for X.2b, `b.begin` for b.end: nearest to all of the name, and the other end."""
    known = tuple(f"{name}.{e}" for e in ends)
    assert nearest(f"{name}.{end}", known) == (None if meant is None else f"{name}.{meant}")


@pytest.mark.parametrize(
    ("word", "known"),
    [
        ("abnormal", ("normal", "reverse")),
        ("not-normal", ("normal", "reverse")),
        ("not normal", ("normal", "reverse")),
        ("unhand", ("motor", "hand")),
        ("tokenless", ("none", "semi-automatic", "automatic", "token")),
        ("non-automatic", ("none", "semi-automatic", "automatic", "token")),
        ("non_automatic", ("none", "semi-automatic", "automatic", "token")),
        ("ward", ("forward", "backward")),
        ("fear", ("far", "near")),
    ],
)
def test_no_opposite_is_proposed(word: str, known: tuple[str, ...]) -> None:
    assert nearest(word, known) is None
    assert str(did_you_mean(word, known)).startswith("known here: ")


@pytest.mark.parametrize(
    ("word", "known", "meant"),
    [
        ("norml", ("normal", "reverse"), "normal"),
        ("semiautomatic", ("none", "semi-automatic", "automatic", "token"), "semi-automatic"),
        ("autmatic", ("none", "semi-automatic", "automatic", "token"), "automatic"),
        ("foreward", ("forward", "backward"), "forward"),
        ("backwards", ("forward", "backward"), "backward"),
        ("unlistd", ("unlisted", "listed"), "unlisted"),
        ("nrth", ("north", "south"), "north"),
        ("X1-X55", ("X1-X5", "X2-X4"), "X1-X5"),
    ],
)
def test_what_is_misspelt_is_still_told(word: str, known: tuple[str, ...], meant: str) -> None:
    assert nearest(word, known) == meant


SLIP = """interlock: 1
name: x
boundaries: {A: {approach: a0 600}, B: {approach: b0 600}, C: {approach: c0 600}, D: {approach: d0 600}}
slips: {K: {section: T, arms: [[A, B], [C, D]], single: PAIR}}
"""


@pytest.mark.parametrize(
    ("pair", "fix"),
    [
        ("1b-2a", "did you mean 2a-1b?  Known here: 1a-2b, 2a-1b"),
        ("2b-1a", "did you mean 1a-2b?  Known here: 1a-2b, 2a-1b"),
        ("1A-2B", "did you mean 1a-2b?"),
        ("1a-2a", "known here: 1a-2b, 2a-1b"),
    ],
)
def test_the_slip_rails_of_a_single_slip_are_the_same_from_either_end(pair: str, fix: str) -> None:
    """`1b-2a` was taken for 1a-2b, the other diagonal: a slip of the other hand, whose routes are others."""
    sink = Sink()
    load_text("x.yaml", SLIP.replace("PAIR", pair), sink)
    (told,) = [d for d in sink.diagnostics if d.code == "IL1017"]
    assert str(told.fix).startswith(fix)
