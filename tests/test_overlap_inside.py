"""A short overlap inside a longer one of the same signal: told apart by how the train was called (R4)."""

from __future__ import annotations

import random
from collections.abc import Iterator
from dataclasses import replace
from math import inf
from pathlib import Path

import pytest

from interlock.app.run import prepare
from interlock.audit import audit
from interlock.audit import overlaps as audit_overlaps
from interlock.checker import specification
from interlock.checker.check import agree
from interlock.checker.lengths import Lengths
from interlock.checker.railway import Railway
from interlock.checker.reading import loaded
from interlock.derivation import derive
from interlock.diag import Severity, Sink
from interlock.emit.python.runtime import runtime_py
from interlock.frontend import load_text
from interlock.logic.controller import Controller
from interlock.logic.lower import lower
from interlock.logic.plant import assumed_of
from interlock.model.elements import OverlapWay, SectionId, SignalId
from interlock.model.layout import Layout
from interlock.model.measured import measured
from interlock.model.overlap import entry_speed, overlap_paths
from interlock.model.traversal import topology
from interlock.panel import picture
from interlock.proof.claims import Facts, claims
from interlock.proof.engines.limits import Limits
from interlock.proof.induction.search import search
from interlock.proof.induction.story import tell
from interlock.proof.mutation.movements import Fate, judge
from interlock.proof.mutation.weakenings import KINDS
from interlock.proof.prover import prove
from interlock.proof.system.transition import System
from interlock.simulate import simulate
from interlock.simulate.world import World
from interlock.table.columns import COLUMNS
from interlock.table.matrix import beyond_matrix
from interlock.table.national import national_sheets
from interlock.table.printed import Printed
from interlock.table.rows import InterlockingTable
from interlock.verify import Rejected
from tests.campaigns.simulate import Case, drive
from tests.grow import grow
from tests.layouts import grown
from tests.written import told

PATH = "tests/layouts_for_tests/overlap_inside.yaml"
TEXT = Path(PATH).read_text("utf-8")
SHORT = "{length: 60, entry_speed: 40, ways: [{over: [T], length: 150}]}"


def made(text: str) -> tuple[Layout, InterlockingTable]:
    """Layout and table of a text without errors, which the audit finds, too."""
    found = grown(text)
    assert found is not None
    layout, table, sink = found
    assert not sink.has_errors and audit(layout, table) == (), sink.diagnostics
    return layout, table


def wrong(kind: str) -> dict[str, Controller]:
    """Controllers with a weakening, by what is weak in them."""
    return dict(next(k for k in KINDS if k.name == kind).make(*made(TEXT)))


def test_the_short_one_has_its_speed_its_end_and_its_points_and_the_long_one_others() -> None:
    layout, table = made(TEXT)
    assert measured(layout).apart == {"X": {1: 40}, "Z": {1: 40}}
    way = Printed(table).ways[next(r.id for r in table.routes if r.exit == "X")]
    cell = {c.key: c.printed(way) for c in COLUMNS}
    assert cell["overlap"] == "o1: a2; o2: a2, T" and cell["overlap_points"] == "o2: 1 N" and cell["speed"] == "o1: 40"
    hostile = {r.id: {*r.locking.hostile.routes} for r in table.routes}
    assert "B-Z" not in hostile["A-X"] and {"B-Z.o2", "Z-E"} <= hostile["A-X.o2"] and "Z-E" not in hostile["A-X"]


def test_the_chinese_form_tells_each_overlap_though_it_has_no_column_for_them() -> None:
    layout, table = made(TEXT.replace("profile: de", "profile: cn"))
    (form,) = national_sheets(layout, table)
    other = [h.zh for h in form.headings].index("其他联锁")
    row = next(r for r in form.rows if "A" in r[5])
    assert row[other] == "o1: 保护区段 a2，限速 40 km/h; o2: 保护区段 a2、T，道岔 1"
    assert any("保护区段" in sign for sign, _ in form.legend)
    plain = national_sheets(*made(TEXT.replace("profile: de", "profile: cn").replace(SHORT, "{length: 0}")))[0]
    assert not any("保护区段" in x for r in plain.rows for x in r) and len(plain.legend) < len(form.legend)


def test_an_operator_is_told_which_route_has_which_overlap_and_speed() -> None:
    """Both lead over a1 to X: without it the panel offers the same way twice."""
    ready = prepare(PATH)
    offered = {r["id"]: r["overlap"] for r in picture.still(ready, None)["routes"]}
    assert offered["A-X"] == "overlap a2; 40 km/h" and offered["A-X.o2"] == "overlap a2, T" and offered["X-E"] == ""
    for name in ("acts.js", "panel.js"):
        assert "r.overlap ?" in (Path(picture.__file__).parent / "page" / name).read_text("utf-8")


def test_hostile_pairs_beside_the_matrix_say_with_which_overlaps_they_are() -> None:
    """`A-X` would mean both of its overlaps; with the short one it is hostile to nobody of the other line."""
    _, table = made(TEXT)
    assert {(x.a, x.b) for x in beyond_matrix(table)} == {("A-X.o2", "B-Z.o2"), ("A-X.o2", "Z-E"), ("B-Z.o2", "X-E")}
    _, alone = made(TEXT.replace(SHORT, "{length: 150}"))
    assert {(x.a, x.b) for x in beyond_matrix(alone)} == {("A-X", "B-Z"), ("A-X", "Z-E"), ("B-Z", "X-E")}


def test_it_is_proved_and_the_second_checker_asks_for_the_same() -> None:
    layout, table = made(TEXT)
    result = prove(System(layout, lower(layout, table)), Limits(search_s=0))
    assert result.proved and not result.dropped
    assert {c.id: c.places for c in result.claims}["S-ENTRY"] == 2
    system = told(TEXT)
    found = agree(*system, specification.shipped())
    assert found.left == () and "A-SLOW" in found.compared[3]
    for old, new in (("speed: 40", "speed: 30"), ("length: 60, ", "length: 90, "), ("length: 150", "length: 300")):
        with pytest.raises(Rejected):
            agree(loaded(TEXT.replace(old, new)), *system[1:], specification.shipped())


CLEAR_ABOVE = ("profile: de\n", "profile: de\nprinciples: {slow_below_kmh: 60}\n")


@pytest.mark.parametrize(
    ("file", "old", "new"),
    [
        ("plant", "accepted(c) and not fast(c, v) and not shows_more(c, v)", "accepted(c)"),
        ("plant", " and not shows_more(c, v)))", "))"),
        ("plant", " and not stops_short(h, s, j)", ""),
        ("plant", "(unprotected_into(s, j) or overruns_in(s, j))", "unprotected_into(s, j)"),
        ("plant", "slow(s, v) and not gone(s) and not turns(s)", "slow(s, v) and not turns(s)"),
        ("plant", 'says: "not slow(s, v)"', 'says: "true"'),
        ("claims", "-> longer_ready(p, o) or (some l in slow_lamps", "-> (some l in slow_lamps"),
        ("claims", "not too_slow_for_clear(p, o) or longer_ready(p, o)", "not too_slow_for_clear(p, o)"),
    ],
)
def test_a_specification_that_says_something_else_is_noticed(file: str, old: str, new: str) -> None:
    texts = {n: (specification.FOLDER / f"{n}.yaml").read_text("utf-8") for n in ("claims", "plant", "told")}
    assert old in texts[file]
    texts[file] = texts[file].replace(old, new)
    with pytest.raises(Rejected):
        agree(*told(TEXT.replace(*CLEAR_ABOVE)), specification.read(texts["claims"], texts["plant"], texts["told"]))


def test_a_layout_without_them_assumes_nothing_of_speeds() -> None:
    layout, _ = made(TEXT.replace(SHORT, "{length: 60, entry_speed: 40}"))
    assert measured(layout).apart == {} and "A-SLOW" not in assumed_of(layout)
    assert "A-SLOW" in assumed_of(made(TEXT)[0])
    _, written, _ = told(TEXT.replace(SHORT, "{length: 60, entry_speed: 40}"))
    assert "slow.40" not in written and "fast.40" not in written


@pytest.mark.parametrize("kind", ["overlap-inside", "entry-speed-forgotten", "overlap-not-held"])
def test_the_proof_kills_a_short_one_for_a_fast_train_one_that_is_not_shown_and_a_long_one_that_is_given_up(
    kind: str,
) -> None:
    layout, _ = made(TEXT)
    mutants = wrong(kind)
    places = [p for p in mutants if "X" in p][-1:]
    assert places
    for place in places:
        outcome = judge(layout, kind, place, mutants[place], Limits(search_depth=10, search_s=20))
        assert outcome.fate is Fate.KILLED and "T-COLLISION" in outcome.claims, outcome


def collision(system: System) -> Iterator[str]:
    """The shortest run to a collision, step by step."""
    run = search(system, [c for c in claims(Facts(system)) if c.id == "T-COLLISION"], 14, 60)
    assert run is not None
    yield from tell(system.loop, run).steps


@pytest.mark.parametrize("kind", ["overlap-inside", "entry-speed-forgotten", ""])
def test_trains_come_to_harm_by_it(kind: str) -> None:
    """A fast train runs on past the end of the short overlap; so would a slow one without A-SLOW."""
    layout, table = made(TEXT)
    if kind:
        controller = next(c for place, c in wrong(kind).items() if place.startswith("A-X"))
        steps = list(collision(System(layout, controller)))
    else:
        steps = list(collision(System(layout, lower(layout, table), frozenset({"A-SLOW"}))))
    short = ["in a2 goes on into T"] if kind else ["in a2 goes on into T", "in c2 goes on into T"]
    assert any(x in s for s in steps for x in short) and "T-COLLISION at T" in steps[-1], steps


def test_trains_in_metres_run_on_as_they_were_called() -> None:
    case = Case.of(PATH)
    worlds: list[World] = []
    simulate(case.layout, case.runtime, scans=1, seed=1, hostile=False, watch=lambda world, _: worlds.append(world))
    drivers = worlds[0].drivers
    at = drivers.track.signals.index("X")
    assert [drivers.overlap(at, v).metres for v in (30.0, 40.0, 60.0, inf)] == [60, 60, 150, 150]
    assert drive(case, 3000, 1, False).hazards == [] and drive(case, 3000, 1, True).hazards == []
    for kind, seed in (("overlap-inside", 2), ("entry-speed-forgotten", 1)):
        controller = next(c for place, c in wrong(kind).items() if place.startswith("A-X"))
        bad = drive(replace(case, runtime=runtime_py(controller, [])), 6000, seed, False)
        assert any("A calls train" in h and "to an overlap" in h for h in bad.hazards), bad.hazards


RICH = """
interlock: 1
name: rich
profile: de
principles: {flank_space: no, main_closes: whole-movement}
boundaries:
  W: {approach: w0 1200}
  E: {approach: e0 1200, trains: out}
  F: {approach: f0 1200, trains: out}
tracks:
  m: [W, z1 600, a1 300, a3 400, a2 60, k 60, l 110]
  n: [d1 700, E]
  o: [c1 700, F]
points:
  1: {section: T, legs: 40, toe: m.end, normal: n.start, reverse: o.start}
signals:
  A: {from: W,  into: z1}
  B: {from: z1, into: a1, call_on: yes, kind: combined}
  D: {from: a1, into: a3, kind: shunt}
  X: {from: a3, into: a2}
  M: {from: a2, into: a3, kind: combined}
overlaps:
  X: {length: 50, entry_speed: 40, ways: [{over: [T], length: 270}, {over: [l], length: 200, entry_speed: 60}]}
  B: {length: 0}
  M: {length: 0}
"""


def test_three_of_one_signal_with_shunting_and_a_train_that_is_called_on() -> None:
    """Whoever is called on is told no speed, so that the longest is held for him."""
    layout, table = made(RICH)
    held = {r.id: r.locking.overlap.option for r in table.routes if r.exit == "X" and r.locking.overlap is not None}
    assert measured(layout).apart == {"X": {1: 40, 2: 60}}
    assert held == {"B-X": 1, "B-X.o2": 2, "B-X.o3": 3, "B-X.o4": 4, "B-X.c.o3": 3, "B-X.c.o4": 4}
    result = prove(System(layout, lower(layout, table)), Limits(search_s=0))
    assert result.proved and not result.dropped
    assert agree(*told(RICH), specification.shipped()).left == ()


def test_a_train_that_has_arrived_where_vehicles_may_stand_may_still_fail_to_stop() -> None:
    """The section before X is a berth: its lock is for a train only until that has arrived."""
    text = RICH.replace("X: {from: a3, into: a2}", "X: {from: a3, into: a2, kind: combined}")
    text = text.replace("  M: {from: a2", "  N: {from: a3, into: a1, kind: combined}\n  M: {from: a2")
    text = text.replace("  M: {length: 0}", "  M: {length: 0}\n  N: {length: 0}")
    layout, table = made(text)
    assert "a3" in topology(layout).berths and measured(layout).apart == {"X": {1: 40, 2: 60}}
    result = prove(System(layout, lower(layout, table)), Limits(search_s=0))
    assert result.proved and not result.dropped


def test_past_a_signal_at_identifier_light_the_longer_one_is_held() -> None:
    """The driver is told nothing there; and what a route past it was shown counts for its far end."""
    text = Path("tests/layouts_for_tests/identifier.yaml").read_text("utf-8")
    text = text.replace("one: [p1 150, p2 150]", "one: [p1 150, p2 60, p3 90]").replace("from: p2, ", "from: p3, ")
    text = text.replace("Y: {length: 50}", "Y: {length: 50, entry_speed: 30, ways: [{over: [p3], length: 120}]}")
    layout, table = made(text)
    held = {r.id: r.locking.overlap.option for r in table.routes if r.exit == "Y" and r.locking.overlap is not None}
    assert held.pop("X-Y") == 1 and set(held.values()) == {2} and any(r.path.onward is not None for r in table.routes)
    assert prove(System(layout, lower(layout, table)), Limits(search_s=0)).proved


WITHIN = Path("tests/diagnostics/IL2026.yaml").read_text("utf-8")
OF_X = "{length: 60, ways: [{over: [T], length: 150}]}"
N, R = ["a2", "T"], ["a2", "T"]


INSIDE = OF_X.replace("60,", "60, entry_speed: 40,")
BOTH: list[tuple[list[str], int | None]] = [(["a2"], 40), (N, None), (R, None)]


@pytest.mark.parametrize(
    ("overlap", "codes", "held"),
    [
        (OF_X, {"IL2026"}, []),
        (INSIDE, set(), BOTH),
        (INSIDE.replace("150", "150, entry_speed: 40"), {"IL2026"}, []),
        (INSIDE.replace("150", "150, entry_speed: 60"), set(), [(["a2"], 40), (N, 60), (R, 60)]),
        (
            INSIDE.replace("[{", "[{over: [b1], length: 300, entry_speed: 60}, {").replace(
                "150}", "150, entry_speed: 40}"
            ),
            {"IL2026"},
            [],
        ),
        (
            INSIDE.replace("[{", "[{over: [b1], length: 300, entry_speed: 60}, {").replace(
                "150}", "150, entry_speed: 50}"
            ),
            set(),
            [(["a2"], 40), (N, 50), ([*N, "b1"], 60), (R, 50)],
        ),
        ("{length: 150, ways: [{over: [T], length: 150}, {over: [a2], length: 60, entry_speed: 40}]}", set(), BOTH),
        ("{length: 150, ways: [{over: [a2], length: 60, entry_speed: 40}]}", {"IL2027"}, []),
        ("{length: 60, entry_speed: 40}", set(), [(["a2"], 40)]),
        ("{length: 140, entry_speed: 40}", set(), [(N, 40), (R, 40)]),
        ("{length: 140, ways: [{over: [b1], length: 300}]}", set(), [([*N, "b1"], None), (R, None)]),
        (
            "{length: 140, entry_speed: 40, ways: [{over: [b1], length: 300}]}",
            set(),
            [(N, 40), ([*N, "b1"], None), (R, 40)],
        ),
    ],
)
def test_what_is_told_apart_and_what_is_refused(
    overlap: str, codes: set[str], held: list[tuple[list[str], int | None]]
) -> None:
    sink = Sink()
    layout, _ = load_text("within.yaml", WITHIN.replace(OF_X, overlap), sink)
    assert {d.code for d in sink.diagnostics if d.severity is Severity.ERROR} == codes
    x = SignalId("X")
    found = [] if layout is None else overlap_paths(layout, x)
    assert [([t.section for t in w], entry_speed(layout, x, w)) for w in found if layout is not None] == held


IN_T = "ways: [{over: [T], length: 150"


@pytest.mark.parametrize(
    ("overlap", "code", "words", "fix"),
    [
        (
            f"{{successive: yes, entry_speed: 40, {IN_T}}}]}}",
            "IL2027",
            "the successive overlap of X would",
            "length: 460",
        ),
        (f"{{length: 150, entry_speed: 40, {IN_T}, entry_speed: 60}}]}}", "IL2027", "for up to 40 km/h", "before T"),
        (f"{{speed: 60, entry_speed: 40, {IN_T}}}]}}", "IL2027", "of 100 m for up to 40 km/h", "ends with a2"),
        (
            f"{{length: 60, entry_speed: 40, {IN_T}}}, {{over: [T, d1], length: 300}}]}}",
            "IL1014",
            "entry over T",
            "first",
        ),
        (f"{{length: 60, entry_speed: 40, {IN_T}}}, {{over: [T], length: 300}}]}}", "IL1014", "entry over T", "first"),
        ("{length: 60, entry_speed: 40, ways: [{over: [], length: 150}]}", "IL1012", "of at least one", "[one]"),
    ],
)
def test_what_would_count_for_nothing_is_told_with_what_to_write(overlap: str, code: str, words: str, fix: str) -> None:
    sink = Sink()
    assert load_text("x.yaml", TEXT.replace(f"X: {SHORT}", f"X: {overlap}"), sink)[0] is None
    (shown,) = [d for d in sink.diagnostics if d.severity is Severity.ERROR]
    assert shown.code == code and words in shown.message and fix in shown.fix, (shown.message, shown.fix)
    assert "inf" not in shown.message.split() and "inf" not in shown.fix


def test_an_own_speed_that_a_way_repeats_is_not_lost() -> None:
    text = TEXT.replace(
        f"X: {SHORT}", "X: {length: 150, entry_speed: 60, ways: [{over: [T], length: 150, entry_speed: 60}]}"
    )
    assert load_text("x.yaml", text, Sink())[0] is not None


BESIDE = """
interlock: 1
name: beside
profile: de
boundaries:
  W: {trains: in, approach: wa 1200}
  E: {trains: out, approach: ea 300}
tracks:
  west: [W, q1 600]
  main: [n1 100]
  loop: [r1 300]
  east: [d 250, f 100, E]
points:
  P: {section: a, toe: west.end, normal: main.start, reverse: loop.start}
  Q: {section: c, toe: east.start, normal: main.end, reverse: loop.end}
signals:
  X: {from: W, into: q1}
  Y: {from: q1, into: a}
overlaps:
  Y: {length: 420, entry_speed: 40, ways: [{over: [n1, f], length: 500}, {over: [n1], length: 420, entry_speed: 30}]}
"""


def test_where_two_ways_come_together_nobody_knows_how_many_metres_a_train_has_run() -> None:
    """Over the loop a train has come farther, where the short overlap over the main ends."""
    sink = Sink()
    assert load_text("beside.yaml", BESIDE, sink)[0] is None
    (shown,) = [d for d in sink.diagnostics if d.code == "IL2026"]
    assert "comes to its sections on another way" in shown.message


TWO_WAYS = """
interlock: 1
name: two_ways
profile: de
principles: {flank_space: no}
boundaries:
  W: {approach: w0 1200, trains: in}
  F: {approach: f0 1200, trains: in}
  E: {approach: e0 1200, trains: out}
tracks:
  m: [W, a1 700]
  long: [a2 80]
  k: [a2 15]
  o: [F, c1 700, c2 80]
  n: [d1 300, E]
points:
  2: {section: a2, toe: m.end, normal: long.start, reverse: 3.reverse, legs: 8, fouling: 3}
  3: {section: a2, toe: k.start, normal: long.end, legs: 8, fouling: 3}
  1: {section: T, legs: 40, toe: n.start, normal: k.end, reverse: o.end}
signals:
  A: {from: W,  into: a1}
  B: {from: F,  into: c1}
  X: {from: a1, into: a2}
  Z: {from: c1, into: c2}
overlaps:
  X: {length: 60, entry_speed: 40}
  Z: {length: 60, entry_speed: 40}
"""


def test_where_two_ways_lead_through_its_section_a_train_may_have_run_fewer_metres() -> None:
    """Over 2 and 3 reverse the end of a2 is 47 m from X: a train that needs 60 m runs on into T."""
    text = TWO_WAYS.replace("X: {length: 60, entry_speed: 40}", f"X: {SHORT}")
    sink = Sink()
    assert load_text("two_ways.yaml", text, sink)[0] is None
    (shown,) = [d for d in sink.diagnostics if d.code == "IL2026"]
    assert "two ways lead through a2" in shown.message and "cut a2" in (shown.fix or "")
    lengths = Lengths(Railway(loaded(text)))
    assert lengths.short(lengths.r.signals["X"]) == {}
    layout, _ = made(TWO_WAYS)
    way = OverlapWay(SignalId("X"), (SectionId("T"),), 150.0, None)
    layout = replace(layout, overlaps=replace(layout.overlaps, ways=(way,)))
    assert audit_overlaps.short(layout, SignalId("X")) == {} and measured(layout).apart == {}


def inside_at_random(seed: int) -> str:
    """A layout that has grown at random, where each overlap of several sections has a short one inside it."""
    text, rng = grow(seed), random.Random(seed)
    found = grown(text)
    assert found is not None
    out = []
    line = int(found[0].principles.line_speed_kmh)
    for o in found[0].overlaps.all:
        long = max(overlap_paths(found[0], o.signal), key=len, default=())
        if len(long) < 2:
            out.append(f"  {o.signal}: {{length: {min(o.length, 300):g}}}")
            continue
        k = rng.randrange(1, len(long))
        short, whole = (sum(t.length for t in ways) for ways in (long[:k], long))
        entry = f", entry_speed: {min(rng.choice([50, 80]), line)}" if rng.random() < 0.3 else ""
        said = f"length: {short:g}, entry_speed: {min(rng.choice([25, 40]), line - 5)}"
        ways = f"{{over: [{long[k].section}], length: {min(whole, 2000):g}{entry}}}"
        out.append(f"  {o.signal}: {{{said}, ways: [{ways}]}}")
    lines = text.splitlines()
    first = lines.index("overlaps:")
    last = next((i for i in range(first + 1, len(lines)) if not lines[i].startswith(" ")), len(lines))
    return "\n".join([*lines[: first + 1], *out, *lines[last:], ""])


SEEDS = (20, 33, 93)


@pytest.mark.parametrize("seed", SEEDS)
def test_on_layouts_that_grow_at_random_all_agree_and_it_is_proved(seed: int) -> None:
    text = inside_at_random(seed)
    layout, table = made(text)
    lengths = Lengths(Railway(loaded(text)))
    apart = measured(layout).apart
    theirs = {
        g: {k: v for k, p in enumerate(lengths.overlaps[g], 1) if (v := lengths.short(lengths.r.signals[g]).get(p))}
        for g in lengths.overlaps
    }
    assert apart == {g: those for g, those in theirs.items() if those}
    assert any(
        r.locking.overlap.option in apart.get(r.locking.overlap.signal, {})
        for r in table.routes
        if r.locking.overlap is not None
    )
    result = prove(System(layout, lower(layout, derive(layout, Sink()))), Limits(search_s=0))
    assert result.proved and not result.dropped
