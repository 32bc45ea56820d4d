"""Overlaps with speeds (R4): alternatives of one signal, each with its length, its points and its entry speed; overlaps
with times of their own after which they are released."""

from __future__ import annotations

import random
from dataclasses import replace
from pathlib import Path

import pytest

from interlock.audit import audit
from interlock.checker import specification
from interlock.checker.check import agree
from interlock.checker.drawing import Unread
from interlock.checker.lengths import Lengths
from interlock.checker.railway import Railway
from interlock.checker.reading import loaded
from interlock.derivation import derive
from interlock.diag import Severity, Sink
from interlock.emit.python.runtime import runtime_py
from interlock.emit.tables.export import table_csv
from interlock.frontend import load_text
from interlock.logic.lower import lower
from interlock.model.elements import SignalId
from interlock.model.layout import Layout
from interlock.model.overlap import entry_speed, overlap_paths, own_way
from interlock.proof.engines.limits import Limits
from interlock.proof.induction.verdict import Verdict
from interlock.proof.mutation.movements import Fate, judge
from interlock.proof.mutation.weakenings import KINDS
from interlock.proof.prover import prove
from interlock.proof.system.transition import System
from interlock.table.columns import COLUMNS
from interlock.table.national import national_sheets
from interlock.table.printed import Printed
from interlock.table.rows import InterlockingTable
from interlock.verify import Rejected
from tests.campaigns.simulate import Case, drive
from tests.grow import grow
from tests.layouts import built, grown
from tests.written import told

PATH = "tests/layouts_for_tests/entry_speeds.yaml"
TEXT = Path(PATH).read_text("utf-8")
SPEEDS = ("v Fahrweg (km/h)", "v D-Weg (km/h)")


def made(text: str) -> tuple[Layout, InterlockingTable]:
    """Layout and table of a text that has no errors."""
    found = grown(text)
    assert found is not None
    layout, table, sink = found
    assert not sink.has_errors and audit(layout, table) == (), sink.diagnostics
    return layout, table


def refused(old: str, new: str) -> list[tuple[str, str]]:
    """What the front end says of the text with something else in it: codes and messages."""
    assert old in TEXT
    sink = Sink()
    assert load_text("x.yaml", TEXT.replace(old, new), sink)[0] is None
    return [(d.code, d.message) for d in sink.diagnostics]


def test_each_overlap_has_its_speed_its_points_and_its_end_in_one_printed_row() -> None:
    layout, table = made(TEXT)
    way = Printed(table).ways[next(r.id for r in table.routes if r.exit == "X3")]
    cell = {c.key: c.printed(way) for c in COLUMNS}
    assert cell["speed"] == "o2: 40" and cell["overlap"] == "o1: q4, q5, q6; o2: q4, q7"
    assert cell["overlap_points"] == "o1: P2 N, P3 N; o2: P2 R"
    assert cell["aspect"] == "o1: clear if X3 is open, else caution; o2: caution"
    reasons = dict(next(c for c in COLUMNS if c.key == "speed").items(way.rows[1]))
    assert reasons["40"].rule == "R4" and reasons["40"].text == "the overlap of X3 over q4, q7 is made for 40 km/h"
    assert sum(",X2,X3," in line for line in table_csv(table).splitlines()) == 1
    form = {s.key: s for s in national_sheets(layout, table)}
    assert form["de_ssld"].rows[:2] == (
        ("X3", "D1", "", "200", "330", "330", "P2+, P3+", "q4, q5, q6", "q3", "500", "133", ""),
        ("X3", "D2", "40", "60", "100", "100", "P2−", "q4, q7", "q3", "500", "133", ""),
    )
    # the lower of two speeds counts: the points permit 60 km/h, the overlap 50; the German form has a column for each
    assert {r.signal.speed.kmh for r in table.routes if r.exit == "X8"} == {50}
    fields = [h.de for h in form["de_sslz"].headings]
    speeds = {r[0]: tuple(r[fields.index(c)] for c in SPEEDS) for r in form["de_sslz"].rows}
    assert speeds["X2/X8"] == ("60", "50") and speeds["X2/X3"] == ("", "D2: 40"), speeds


def test_an_overlap_that_ends_within_a_section_holds_all_of_it() -> None:
    """The 60 m end in q7, 20 m before its end; the section is held, and must be clear."""
    _, table = made(TEXT)
    (short,) = [
        r for r in table.routes if r.exit == "X3" and r.locking.overlap is not None and r.locking.overlap.option == 2
    ]
    assert short.locking.overlap is not None
    assert [s for s, _ in short.locking.overlap.ways] == ["q4", "q7"] and short.locking.overlap.metres == 100
    assert "100 m to the next joint, made for 40 km/h" in short.locking.overlap.because.text


def test_a_layout_without_speeds_of_overlaps_is_as_it_was() -> None:
    keys = ("overlap_ways", "overlap_bars", "entry_speeds", "overlap_releases")
    for name in ("flank_lab", "junction", "mine11"):
        assert not any(key in built(name)[0].to_text() for key in keys)


def test_it_is_proved_and_the_second_checker_asks_for_it() -> None:
    layout, table = made(TEXT)
    result = prove(System(layout, lower(layout, table)), Limits(search_s=0))
    assert {c.verdict for c in result.claims} == {Verdict.PROVED} and not result.dropped
    assert {c.id: c.places for c in result.claims}["S-ENTRY"] == 2
    system = told(TEXT)
    assert agree(*system, specification.shipped()).left == ()
    for old, new in (
        ("entry_speed: 40", "entry_speed: 30"),
        ("entry_speed: 50, falling: 2", "length: 120"),
        ("release: 62", "release: 70"),
        ("release_by_length: yes", "release: 140"),
    ):
        with pytest.raises(Rejected):
            agree(loaded(TEXT.replace(old, new)), *system[1:], specification.shipped())


BARRED = (
    TEXT.replace("length: 200\n", "length: 200\n    not_over: [NOT]\n").split("    ways:")[0] + "  X8: {length: 0}\n"
)


@pytest.mark.parametrize(("what", "left"), [("P2.reverse", "q4, q5, q6"), ("q5", "q4, q7"), ("P2.normal", "q4, q7")])
def test_an_alternative_that_is_not_wanted_is_none_for_all_who_ask(what: str, left: str) -> None:
    """Of an overlap over a facing point one way is used, as the drawing says; derivation, audit, proof and the second
    checker know no other, and each refuses what was made with both."""
    if left.endswith("q7"):  # 80 m are all that there is
        text = BARRED.replace("NOT", what).replace("length: 200", "length: 60")
    else:
        text = BARRED.replace("NOT", what)
    layout, table = made(text)
    (route,) = [r for r in table.routes if r.exit == "X3"]
    assert route.locking.overlap is not None and ", ".join(s for s, _ in route.locking.overlap.ways) == left
    assert prove(System(layout, lower(layout, table)), Limits(search_s=0)).proved
    system = told(text)
    assert agree(*system, specification.shipped()).left == ()
    both, more = made(text.replace(f"    not_over: [{what}]\n", ""))
    assert len([r for r in more.routes if r.exit == "X3"]) == 2
    assert audit(layout, more) != () and audit(both, table) != ()
    with pytest.raises(Rejected):
        agree(loaded(text.replace(f"    not_over: [{what}]\n", "")), *system[1:], specification.shipped())
    with pytest.raises(Unread):
        Lengths(Railway(loaded(text.replace(f"[{what}]", "[P9.reverse]")))).overlaps  # noqa: B018


def test_bars_that_leave_no_overlap_are_refused() -> None:
    sink = Sink()
    assert load_text("x.yaml", BARRED.replace("NOT", "q4"), sink)[0] is None
    assert [(d.code, d.message) for d in sink.diagnostics] == [
        ("IL1014", "`not_over` leaves X3 no overlap: every way of that length leads over q4")
    ]


def test_the_clear_aspect_is_claimed_of_slow_overlaps_too() -> None:
    layout, table = made(TEXT)
    next_ = next(r.signal.aspect for r in table.routes if r.exit == "X3" and r.signal.speed.kmh is None)
    next_ = replace(next_, next=SignalId("X8"))
    rows = tuple(replace(r, signal=replace(r.signal, aspect=next_)) if r.exit == "X8" else r for r in table.routes)
    result = prove(System(layout, lower(layout, replace(table, routes=rows))), Limits(search_s=0, search_depth=0))
    assert [c.id for c in result.claims if c.verdict is not Verdict.PROVED] == ["S-ASPECT"]


def test_a_forgotten_entry_speed_is_killed_by_proof_and_by_trains_in_metres() -> None:
    layout, table = made(TEXT)
    kind = next(k for k in KINDS if k.name == "entry-speed-forgotten")
    mutants = dict(kind.make(layout, table))
    assert set(mutants) == {"X2-X3.o2", "X2-X8"}
    outcome = judge(layout, kind.name, "X2-X3.o2", mutants["X2-X3.o2"], Limits(search_depth=8, search_s=10))
    assert "S-ENTRY" in outcome.claims and outcome.fate is Fate.KILLED, outcome
    case = Case.of(PATH)
    assert drive(case, 2000, 1, False).hazards == []
    wrong = drive(replace(case, runtime=runtime_py(mutants["X2-X8"], [])), 12_000, 2, False)
    assert any("60 km/h to an overlap for 50 km/h" in h for h in wrong.hazards), wrong.hazards


@pytest.mark.parametrize(
    ("old", "new", "code", "words"),
    [
        ("[q7]", "[q2]", "IL1014", "no overlap of X3 of 60 m"),
        ("[q7]", "[nowhere]", "IL2004", "nowhere"),
        ("length: 200\n", "length: 200\n    not_over: [nowhere]\n", "IL2004", "no section, and no end"),
        ("length: 200\n", "length: 200\n    not_over: [P2.revers]\n", "IL2003", "no section, and no end"),
        ("length: 200\n", "length: 200\n    not_over: [main.end]\n", "IL2003", "no section, and no end"),
        ("length: 200\n", "length: 200\n    not_over: [P1.reverse]\n", "IL1014", "bars nothing"),
        ("length: 200\n", "length: 200\n    not_over: [q5, drag.start]\n", "IL2003", "no section, and no end"),
        ("length: 60, entry_speed: 40", "falling: 1", "IL1014", "an `entry_speed`"),
        ("length: 200", "length: 200\n    swing: yes", "IL1014", "does not swing"),
        ("length: 200", "length: 0", "IL1014", "no overlap of 0 m"),
        ("X2: {length: 0}", "X2: {length: 0, release: 60}", "IL1014", "no overlap of 0 m"),
        ("length: 200", "length: 200\n    falling: 3", "IL1014", "`falling` counts only where the length follows"),
        ("length: 60, entry_speed: 40", "length: 60, entry_speed: 40, falling: 3", "IL1014", "counts only where"),
        ("length: 200", "successive: yes\n    falling: 3", "IL1014", "counts only where"),
        ("entry_speed: 50, falling: 2, release: 62", "speed: 40, falling: -20", "IL1014", "nothing is left"),
        ("entry_speed: 50, falling: 2", "entry_speed: 50, falling: -25", "IL1014", "nothing is left"),
        ("entry_speed: 50, falling: 2", "speed: 40, entry_speed: 50", "IL1014", "are shown up to 50"),
        ("release_by_length: yes", "release_by_length: yes\n    release: 60", "IL1014", "two times"),
        ("release: 62", "release: 41", "IL3023", "42.1 s are needed"),
        ("length: 200", "speed: 60\n    falling: -1000.5", "IL1014", "no gradient"),
        ("X2: {length: 0}", "X2: {speed: 60, falling: -20}", "IL1014", "rise of 20 permille"),
    ],
)
def test_what_cannot_be_is_said(old: str, new: str, code: str, words: str) -> None:
    found = refused(old, new)
    assert [c for c, _ in found] == [code] and words in found[0][1], found


@pytest.mark.parametrize("falling", ["-20", "-1000.5", "-1000000"])
def test_no_overlap_is_lost_by_a_gradient(falling: str) -> None:
    """The second checker refuses it, too: none is what `length: 0` says."""
    system = told(TEXT)
    with pytest.raises(Rejected, match=r"falling|rises"):
        agree(
            loaded(TEXT.replace("X2: {length: 0}", f"X2: {{speed: 60, falling: {falling}}}")),
            *system[1:],
            specification.shipped(),
        )


def test_a_gradient_that_counts_for_nothing_is_not_read_by_the_second_checker() -> None:
    for old, new in (
        ("length: 200", "length: 200\n    falling: 3"),
        ("length: 200", "successive: yes\n    falling: 3"),
        ("length: 60, entry_speed: 40", "length: 60, entry_speed: 40, falling: 3"),
    ):
        assert old in TEXT
        with pytest.raises(Unread):
            Railway(loaded(TEXT.replace(old, new)))


def test_the_release_by_length_follows_section_and_speed() -> None:
    """Through 500 m at half of the 40 km/h that the slowest train is shown, then 5 s and the braking of one that has
    80 km/h: 90 s and 42 s; where no entry speed is stated, at half of 80 km/h: 45 s and 42 s."""
    layout, _ = made(TEXT)
    assert dict(layout.overlaps.releases) == {"X3": 133.0, "X8": 62.0}
    timers = {t.name: t.preset_ms for t in lower(layout, derive(layout, Sink())).timers}
    assert timers["OT_X3"] == 133_000 and timers["OT_X8"] == 62_000
    whole, _ = made(TEXT.replace("length: 60, entry_speed: 40", "length: 60"))
    assert dict(whole.overlaps.releases)["X3"] == 88.0
    slow, _ = made(TEXT + "sections:\n  q3: {speed: 40}\n")
    assert dict(slow.overlaps.releases)["X3"] == 114.0


TOGETHER = """
interlock: 1
name: together
boundaries:
  W: {trains: in, approach: wa 1200}
  E: {trains: out, approach: ea 300}
tracks:
  west: [W, q1 300]
  main: [n1 100]
  loop: [r1 100]
  east: [d 250, E]
points:
  P: {section: a, toe: west.end, normal: main.start, reverse: loop.start}
  Q: {section: c, toe: east.start, normal: main.end, reverse: loop.end}
signals:
  X: {from: W, into: q1}
  Y: {from: q1, into: a}
overlaps:
  Y: {length: 200, ways: [{over: [r1], length: 150, entry_speed: 40}]}
"""


def test_alternatives_that_come_together_go_on_as_far_as_the_longest() -> None:
    """Over r1 the 150 m end at c; the way over n1 goes on, and nobody knows over which of them a train came."""
    layout, table = made(TOGETHER)
    over = {r.id: [s for s, _ in r.locking.overlap.ways] for r in table.routes if r.locking.overlap is not None}
    assert over == {"X-Y": ["a", "n1", "c", "d"], "X-Y.o2": ["a", "r1", "c", "d"]}
    assert [entry_speed(layout, SignalId("Y"), p) for p in overlap_paths(layout, SignalId("Y"))] == [None, 40]
    assert {r.id: r.signal.speed.kmh for r in table.routes if r.locking.overlap is not None} == {
        "X-Y": None,
        "X-Y.o2": 40,
    }
    alone, _ = made(TOGETHER.replace("length: 200", "length: 100"))
    assert [t.section for t in overlap_paths(alone, SignalId("Y"))[1]] == ["a", "r1", "c"]


COUPLED = """
interlock: 1
name: coupled
boundaries:
  W: {trains: in, approach: wa 1200}
  V: {trains: in, approach: va 1200}
  E: {trains: out}
  F: {trains: out}
tracks:
  west: [W, q1 300]
  other: [V, o1 300]
  mid: [n1 60]
  side: [s1 300, F]
  east: [d 250, E]
points:
  P: {machine: M, section: a, toe: west.end, normal: mid.start, reverse: side.start}
  Q: {machine: M, section: c, toe: east.start, normal: other.end, reverse: mid.end}
signals:
  X: {from: W, into: q1}
  Y: {from: q1, into: a}
  U: {from: V, into: o1}
  Z: {from: o1, into: c}
overlaps:
  Y: {length: 200}
  Z: {length: 0}
"""


def test_an_overlap_that_needs_one_machine_both_ways_is_none() -> None:
    """Over n1 it would have P normal and Q reverse, which one machine works: whoever runs on over n1 trails Q."""
    _, table = made(COUPLED)
    over = {r.id: [s for s, _ in r.locking.overlap.ways] for r in table.routes if r.locking.overlap is not None}
    assert over == {"X-Y": ["a", "s1"]}
    apart, _ = made(COUPLED.replace("P: {machine: M, ", "P: {"))
    assert [t.section for t in overlap_paths(apart, SignalId("Y"))[0]] == ["a", "n1", "c", "d"]


def speeds_at_random(seed: int) -> str | None:
    """A layout that has grown at random, where each overlap with several alternatives states length and speed of one of
    them; None where none has several."""
    text, rng = grow(seed), random.Random(seed)
    found = grown(text) if "overlaps:" in text else None
    if found is None:
        return None
    out, some = [], False
    line = int(found[0].principles.line_speed_kmh)
    for o in found[0].overlaps.all:
        paths = overlap_paths(found[0], o.signal)
        parts = [
            f"length: {min(o.length, 150):g}",
            *([f"entry_speed: {min(rng.choice([30, 60]), line)}"] if rng.random() < 0.5 else []),
        ]
        own = [
            s for s in (t.section for t in (paths or ((),))[-1]) if any(s not in {t.section for t in p} for p in paths)
        ]
        if own:
            some = True
            before = sum(t.length for t in paths[-1][: [t.section for t in paths[-1]].index(own[0])])
            beyond = before + rng.choice([5, 40, 200])
            parts.append(f"ways: [{{over: [{own[0]}], length: {beyond}, entry_speed: {min(25, line)}}}]")
        out.append(f"  {o.signal}: {{{', '.join(parts)}}}")
    lines = text.splitlines()
    first = lines.index("overlaps:")
    last = next((i for i in range(first + 1, len(lines)) if not lines[i].startswith(" ")), len(lines))
    return "\n".join([*lines[: first + 1], *out, *lines[last:], ""]) if some else None


def test_on_layouts_that_grow_at_random_derivation_audit_and_second_checker_agree() -> None:
    several = 0
    for seed in range(240):
        text = speeds_at_random(seed)
        found = None if text is None else grown(text)
        if text is None or found is None:
            continue
        layout, table, sink = found
        if any(d.severity is Severity.ERROR for d in sink.diagnostics):
            continue
        assert audit(layout, table) == (), (seed, text)
        lengths = Lengths(Railway(loaded(text)))
        for o in layout.overlaps.all:
            paths = overlap_paths(layout, o.signal)
            theirs = lengths.overlaps.get(o.signal, [])
            assert [[t.key for t in p] for p in paths] == [[(w.section, w.number) for w in p.ways] for p in theirs], (
                seed
            )
            speeds = [entry_speed(layout, SignalId(o.signal), p) for p in paths]
            assert speeds == [lengths.entry_kmh(lengths.r.signals[o.signal], p) for p in theirs], seed
            several += len({own_way(layout, o.signal, p) for p in paths}) > 1
    assert several >= 5
