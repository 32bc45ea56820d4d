"""Flank protection as a whole (R5): scissors, substitutes, flank space; each with a table that goes wrong."""

from __future__ import annotations

import re
from dataclasses import replace
from pathlib import Path

import pytest

from interlock.app.check import check_file
from interlock.audit import audit
from interlock.derivation.flank import requesters, told
from interlock.diag import Element, Sink
from interlock.diag.called import called
from interlock.logic.lower import lower
from interlock.model.elements import Position, RouteId, SectionId
from interlock.model.layout import Layout
from interlock.model.principles import PROFILES
from interlock.model.traversal import topology
from interlock.proof.claims.catalogue import claims
from interlock.proof.claims.kinds import Facts
from interlock.proof.engines.limits import Limits
from interlock.proof.induction.search import search
from interlock.proof.induction.verdict import Verdict
from interlock.proof.mutation.weakenings import KINDS
from interlock.proof.prover import prove
from interlock.proof.system.transition import System
from interlock.table.cells import Because, ClearCell, PointDemand, Provider, ProviderKind, Role
from interlock.table.rows import InterlockingTable
from tests.layouts import built, grown

SCISSORS = {
    "layouts/terminus": {("201", "N"), ("202", "N")},
    "layouts/terminus_slip": {("201", "N"), ("202", "N")},
    "layouts/cn6502": {("9/11", "N"), ("13/15", "N")},
    "tests/layouts_for_tests/scissors_apart": {("1", "N"), ("2", "N")},
}


SCISSORS_BEYOND = """
interlock: 1
name: scissors
principles: {flank_space: yes, overlap_m: 60}
boundaries: {A: {approach: aa 600}, B: {trains: out}, C: {trains: out}, D: {trains: out}}
tracks: {a: [A, a1 300]}
points:
  1A: {machine: 1, section: T1, toe: a.end, normal: 2B.normal}
  2B: {machine: 2, section: T1, toe: B}
  2A: {machine: 2, section: T2, toe: C, normal: 1B.normal}
  1B: {machine: 1, section: T2, toe: D}
crossings: {X: {arms: [{section: T1, ends: [1A.reverse, 1B.reverse]}, {section: T2, ends: [2A.reverse, 2B.reverse]}]}}
signals: {SI: {from: A, into: a1}, SA: {from: a1, into: T1}}
"""
"""A signal before a scissors of two sections, with overlaps over it, and flank space."""


def derived(path: str, profile: str = "") -> tuple[Layout, InterlockingTable, Sink]:
    """A layout under a profile, its own without one."""
    text = Path(f"{path}.yaml").read_text("utf-8")
    if profile:
        text = re.sub(r"(?m)^profile:.*\n", "", text)
        text = re.sub(r"(?m)^(name:.*\n)", rf"\1profile: {profile}\n", text, count=1)
    made = grown(text)
    assert made is not None
    return made


@pytest.mark.parametrize("profile", PROFILES)
@pytest.mark.parametrize("path", SCISSORS)
def test_the_partner_of_a_scissors_lies_normal_in_every_profile(path: str, profile: str) -> None:
    layout, table, sink = derived(path, profile)
    assert not sink.has_errors and audit(layout, table) == ()
    seen = set()
    for r in table.routes:
        over = {c for key in r.path.traversals for t in table.locks if t.key == key for c, _ in t.crossings}
        if not over:
            continue
        partner = {
            (p.machine, str(p.position)) for p in r.locking.points if (p.machine, str(p.position)) in SCISSORS[path]
        }
        assert partner, r.id
        seen |= partner
    assert seen == SCISSORS[path]


@pytest.mark.parametrize("path", SCISSORS)
def test_a_partner_that_may_lie_reverse_is_seen_by_claim_and_audit(path: str) -> None:
    layout, table, _ = derived(path)
    partners = {
        c.requester: str(c.providers[0].name) for t in table.locks for c in t.flank if "partner" in c.because.text
    }

    weak = without_flank(table, {str(x) for x in partners.values()})
    assert any("scissors" in f.text for f in audit(layout, weak))
    result = prove(System(layout, lower(layout, weak)), Limits(search_depth=0))
    assert {"T-SCISSORS", "S-SCISSORS"} <= {c.id for c in result.claims if c.verdict is not Verdict.PROVED}


def test_a_scissors_over_four_sections_is_proved() -> None:
    layout, table, _ = derived("tests/layouts_for_tests/scissors_apart")
    result = prove(System(layout, lower(layout, table)))
    assert result.proved and next(c.places for c in result.claims if c.id == "S-SCISSORS") == 4


@pytest.mark.parametrize("profile", PROFILES)
def test_what_one_route_demands_counts_when_its_next_flank_is_searched(profile: str) -> None:
    layout, table, sink = derived("tests/layouts_for_tests/both_ways", profile)
    assert not sink.has_errors and audit(layout, table) == ()
    main = table.route["X2-E"]  # type: ignore[index]
    assert [str(p) for c in main.locking.flank for p in c.providers] == (
        ["Y2", "Y2"] if profile == "cn" else ["P R", "Y2"]
    )
    assert ("IL4010" in {d.code for d in sink.diagnostics}) == (profile != "cn")
    assert prove(System(layout, lower(layout, table))).proved


def test_a_point_wanted_both_ways_gets_a_substitute_before_routes_become_hostile() -> None:
    # 5/7, 1/3 and 23/25 would turn vehicles away from routes that can be set beside each other
    _, by_point, sink = derived("layouts/cn6502", "generic")
    _, by_signal, _ = derived("layouts/cn6502", "cn")
    assert not sink.has_errors
    assert {r.id: set(r.locking.hostile.routes) for r in by_point.routes} == {
        r.id: set(r.locking.hostile.routes) for r in by_signal.routes
    }
    assert not any(h.kind == "flank" for r in by_point.routes for h in r.locking.hostile)


def test_a_place_that_contradicts_its_own_routes_is_named_once_with_what_would_do() -> None:
    text = Path("tests/diagnostics/IL4002.yaml").read_text("utf-8")
    made = grown(text)
    assert made is not None
    found = [d for d in made[2].diagnostics if d.code == "IL4002" and "cannot be protected" in d.message]
    assert [d.message.split()[0] for d in found] == ["B.reverse"]
    assert "route X2-E" in found[0].message and "Y would do, but stands 60 m away" in found[0].fix
    assert "`points: {B: {fouling: 56.5}}`" in found[0].fix


def test_a_place_that_contradicts_routes_both_ways_is_named_with_all_of_them() -> None:
    text = Path("tests/diagnostics/IL4002.yaml").read_text("utf-8").replace("E: {trains: out}", "E: {approach: ae 600}")
    made = grown(f"{text}  Z1: {{from: E, into: m5}}\n  Z2: {{from: m5, into: m4}}\n")
    assert made is not None
    found = [d.message for d in made[2].diagnostics if d.code == "IL4002" and "cannot be protected" in d.message]
    assert found == [
        "B.reverse cannot be protected in routes X2-E, Z2-W: P would have to lie N, and lies R for A.reverse"
    ]


def test_a_waiver_of_a_place_that_contradicts_its_routes_waives_something() -> None:
    """Without it there is IL4002: who is told to remove it is led round in a circle."""
    text = Path("tests/diagnostics/IL4002.yaml").read_text("utf-8")
    made = grown(f"{text}waive:\n  - {{flank: B.reverse, reason: nobody comes}}\n")
    assert made is not None and "IL2008" not in {d.code for d in made[2].diagnostics}
    assert not any("B.reverse cannot be protected" in d.message for d in made[2].diagnostics)


MOVED_OFF = """interlock: 1
name: spur
boundaries: {W: {approach: wa 600, trains: in}, E: {trains: out}}
buffers: [B]
tracks: {west: [W, w1 200], main: [m1 300, E], spur: [b1 100, B]}
points: {P: {section: p, toe: west.end, reverse: main.start, machine: M, legs: 60}}
derailers: {D: {section: p, inner: P.normal, outer: spur.start, machine: M}}
signals: {X1: {from: W, into: w1}, X2: {from: w1, into: p}}
"""
"""A derailer that the route past it moves off, since one machine works it and the points."""
BARE = Path("tests/diagnostics/IL4001.yaml").read_text("utf-8")
CROSSED = Path("tests/diagnostics/IL4002.yaml").read_text("utf-8")
EXCLUDED = "exclude: [{from: Y, to: E, via: [s2, m2, m3, m4, m5], reason: r}]\n"


@pytest.mark.parametrize(
    ("text", "code", "place", "advice", "applied"),
    [
        (MOVED_OFF, "IL4002", "P.normal", "give D a machine of its own", [("spur.start, machine: M", "spur.start")]),
        (
            MOVED_OFF,
            "IL4002",
            "P.normal",
            "add a signal or stop board, 15.5 m",
            [("signals: {", "signals: {S: {from: b1, into: p, kind: board}, ")],
        ),
        (
            MOVED_OFF,
            "IL4002",
            "P.normal",
            "or a derailer on each way",
            [
                ("spur: [b1 100, B]", "spur: [b1 100], end: [b2 100, B]"),
                ("derailers: {", "derailers: {D2: {section: p2, inner: spur.end, outer: end.start}, "),
            ],
        ),
        (BARE, "IL4001", "P1.normal", "11.5 m are needed: lengthen the track", [("legs: 6", "legs: 11.5")]),
        (BARE, "IL4001", "P1.reverse", "`points: {P1: {fouling: 2.5}}`", [("legs: 6", "legs: 6, fouling: 2.5")]),
        (
            CROSSED,
            "IL4002",
            "B.reverse",
            "73.5 m are needed: lengthen the track",
            [("P.reverse, fouling: 70", "P.reverse, fouling: 70, legs: 33.5"), ("signals:", EXCLUDED + "signals:")],
        ),
        (
            CROSSED,
            "IL4002",
            "B.reverse",
            "`points: {B: {fouling: 56.5}}`",
            [("P.reverse, fouling: 70", "P.reverse, fouling: 56.5"), ("signals:", EXCLUDED + "signals:")],
        ),
        (
            CROSSED,
            "IL4002",
            "the joint",
            "`exclude: [{from: Y, to: E, via: [s2, m2, m3, m4, m5], reason: ...}]`",
            [("P.reverse, fouling: 70", "P.reverse, fouling: 56.5"), ("signals:", EXCLUDED + "signals:")],
        ),
    ],
    ids=["machine", "signal", "derailer", "longer", "fouling", "longer to one", "fouling of one", "excluded"],
)
def test_what_is_advised_where_nothing_protects_is_proved(
    text: str, code: str, place: str, advice: str, applied: list[tuple[str, str]]
) -> None:
    """A waiver was advised beside it, which T-FLANK and S-FLANK refute wherever nothing protects."""
    made = grown(text)
    assert made is not None
    fixes = [
        d.fix
        for d in made[2].diagnostics
        if d.code == code and d.message.removeprefix("nothing keeps vehicles away from ").startswith(place)
    ]
    assert len(fixes) == 1 and advice in fixes[0] and "waive" not in fixes[0], fixes
    for old, new in applied:
        assert text.count(old) == 1
        text = text.replace(old, new)
    done = grown(text)
    assert done is not None and not done[2].has_errors, done and done[2].diagnostics
    assert audit(done[0], done[1]) == ()
    assert prove(System(done[0], lower(done[0], done[1])), Limits(search_depth=0)).proved


@pytest.mark.parametrize("legs", [6.22, 6.47, 8.69, 3.6, 3.5, 3])
def test_the_fouling_point_that_is_advised_is_one_of_which_the_signal_stands_clear(legs: float) -> None:
    """To the last centimetre, whatever floating point makes of 2.72 + 3.5; within the clearance itself none is."""
    text = BARE.replace("legs: 6", f"legs: {legs}")
    made = grown(text)
    assert made is not None
    (fix,) = [d.fix or "" for d in made[2].diagnostics if d.code == "IL4001" and "from P1.normal;" in d.message]
    stated = re.search(r"`points: \{P1: \{fouling: (.*)\}\}`", fix)
    assert (stated is not None) is (legs > 3.5) and "fouling: -" not in fix
    if stated is not None:
        done = grown(text.replace("legs:", f"fouling: {stated[1]}, legs:"))
        assert done is not None and not done[2].has_errors, done and done[2].diagnostics


def test_what_is_waived_is_protected_last_where_one_machine_could_protect_but_one_of_two() -> None:
    """P turns away from A or from B.  The waiver gives A up; that P lay for it all the same would leave B open."""
    text = CROSSED.replace("signals:", EXCLUDED + "signals:")
    made = grown(f"{text}waive:\n  - {{flank: A.reverse, reason: nobody comes}}\n")
    assert made is not None and not made[2].has_errors, made and made[2].diagnostics
    cells = made[1].route[RouteId("X2-E")].locking.flank
    assert {c.requester: [str(p) for p in c.providers] for c in cells} == {
        "A.reverse": ["nobody comes"],
        "B.reverse": ["P N"],
    }
    assert audit(made[0], made[1]) == ()


def test_the_section_of_a_protecting_point_is_no_flank_space() -> None:
    layout, table, sink = derived("tests/layouts_for_tests/parallel")
    assert not sink.has_errors and audit(layout, table) == ()
    assert [c.name for r in table.routes for c in r.clear.space] == []
    assert prove(System(layout, lower(layout, table))).proved


def test_flank_space_that_is_not_asked_for_is_seen_by_claim_and_audit() -> None:
    layout, table, _ = derived("layouts/cn6502", "de")
    assert any(r.clear.space for r in table.routes)
    weak = replace(
        table,
        routes=tuple(replace(r, clear=replace(r.clear, space=())) for r in table.routes),
        locks=tuple(replace(t, space=()) for t in table.locks),
    )
    assert any(f.column == "space" for f in audit(layout, weak))
    result = prove(System(layout, lower(layout, weak)), Limits(search_depth=0))
    assert "S-FLANK-SPACE" in {c.id for c in result.claims if c.verdict is not Verdict.PROVED}


def test_a_name_that_says_its_kind_is_told_without_it() -> None:
    """Not `signal signal5`, in whatever case; a name that is the bare word keeps its kind before it."""
    assert called("signal", "S5") == "signal S5"
    assert (called("signal", "Signal_5"), called("signal", "signal")) == ("Signal_5", "signal signal")
    providers = (
        Provider(ProviderKind.POINT, "point7", Position.REVERSE),
        Provider(ProviderKind.SIGNAL, "signal5"),
        Provider(ProviderKind.BUFFER, "B"),
    )
    assert told(providers) == (
        "point7 R turns vehicles away and signal5 at stop, clear of the fouling point and the track ends at B"
    )
    assert told((Provider(ProviderKind.SIGNAL, "S5"),)) == "signal S5 at stop, clear of the fouling point"


def test_what_has_overrun_a_signal_is_protected_on_its_flanks_whatever_the_controller_holds() -> None:
    layout, table, _ = derived("tests/layouts_for_tests/overlap_flank")
    weaken = next(k for k in KINDS if k.name == "overlap-flank-not-held")
    for controller, harm in ((lower(layout, table), False), (next(weaken.make(layout, table))[1], True)):
        system = System(layout, controller)
        asked = [c for c in claims(Facts(system)) if c.id == "T-FLANK" and "overrun from XN1" in c.place]
        assert {c.place[:4] for c in asked} == {"x:1:", "x:3:"}  # along it, and against it
        run = search(system, asked, 9, 60)
        assert (run is not None) == harm


def without_flank(table: InterlockingTable, machines: set[str]) -> InterlockingTable:
    """A table that demands no flank protection of some machines."""

    def without(points: tuple[PointDemand, ...]) -> tuple[PointDemand, ...]:
        return tuple(p for p in points if not (p.role is Role.FLANK and str(p.machine) in machines))

    return replace(
        table,
        routes=tuple(replace(r, locking=replace(r.locking, points=without(r.locking.points))) for r in table.routes),
        locks=tuple(replace(t, points=without(t.points)) for t in table.locks),
    )


@pytest.mark.parametrize(
    ("old", "new", "warned"),
    [
        ("", "", True),
        ("name: spur", "name: spur\nprinciples: {flank_space: yes}", False),
        ("signals:", "signals:\n  S: {from: b1, into: p, kind: main}", False),
        ("legs: 60", "legs: 5", False),
        ("signals:", "derailers:\n  D: {section: p, inner: P.reverse, outer: spur.start}\nsignals:", False),
        ("signals:", "allow:\n  - {lint: IL4017, at: [B], reason: scotches}\nsignals:", False),
    ],
    ids=["open", "space", "signal", "foul joint", "derailer", "allowed"],
)
def test_a_spur_into_which_vehicles_are_brought_is_told_of_where_only_its_end_protects(
    old: str, new: str, warned: bool, tmp_path: Path
) -> None:
    text = Path("tests/diagnostics/IL4017.yaml").read_text("utf-8").replace(old, new, 1)
    text = text.replace("reverse: spur.start, ", "") if "derailers:" in text else text
    text = text.replace("W: {approach: wa 600, trains: in}", "W: {approach: wa 600}")  # where S leads
    tmp_path.joinpath("x.yaml").write_text(text, "utf-8")
    found = check_file(str(tmp_path / "x.yaml"))
    assert found.ok and ("IL4017" in {d.code for d in found.diagnostics}) == warned, found.diagnostics


def test_a_derailer_in_a_spur_is_laid_for_the_route_past_it() -> None:
    """The end of the track behind it was preferred, as what asks for nothing, and the derailer stayed as it lay."""
    text = Path("tests/diagnostics/IL4017.yaml").read_text("utf-8").replace("reverse: spur.start, ", "")
    made = grown(
        text.replace("signals:", "derailers:\n  D: {section: p, inner: P.reverse, outer: spur.start}\nsignals:")
    )
    assert made is not None and not made[2].has_errors and audit(made[0], made[1]) == ()
    table = made[1]
    assert {(str(p.machine), str(p.position)) for p in table.route[RouteId("X2-E")].locking.points} == {
        ("P", "N"),
        ("D", "N"),
    }
    assert {(str(p.machine), str(p.position)) for p in table.route[RouteId("X2-B")].locking.points} == {
        ("P", "R"),
        ("D", "R"),
    }
    assert prove(System(made[0], lower(made[0], table)), limits=Limits(search_s=0)).proved


@pytest.mark.parametrize(
    ("old", "new", "seen"),
    [
        ("", "", True),
        ("buffers: [B]", "traps: [B]", False),
        ("signals:", "signals:\n  S: {from: b1, into: p, kind: main}", False),
    ],
    ids=["derailer", "trap", "signal"],
)
def test_the_proof_sees_a_derailer_that_is_not_laid_for_the_vehicles_behind_it(old: str, new: str, seen: bool) -> None:
    """They are left there by hand, or stand there on no route: whoever puts a derailer does not trust them to stay."""
    text = Path("tests/diagnostics/IL4017.yaml").read_text("utf-8").replace("reverse: spur.start, ", "")
    text = text.replace("W: {approach: wa 600, trains: in}", "W: {approach: wa 600}").replace(old, new, 1)
    made = grown(
        text.replace("signals:", "derailers:\n  D: {section: p, inner: P.reverse, outer: spur.start}\nsignals:")
    )
    assert made is not None and not made[2].has_errors
    weak = without_flank(made[1], {"D"})
    assert ("a vehicle can reach P.R" in {x.text for x in audit(made[0], weak)}) == seen
    result = prove(System(made[0], lower(made[0], weak)), Limits(search_depth=0))
    assert {"T-FLANK", "S-FLANK"} & {c.id for c in result.claims if c.verdict is not Verdict.PROVED} == (
        {"T-FLANK", "S-FLANK"} if seen else set()
    )


def test_a_derailer_that_its_own_route_moves_off_protects_nothing_nor_does_the_end_of_the_track_behind_it() -> None:
    text = Path("tests/diagnostics/IL4017.yaml").read_text("utf-8").replace("reverse: spur.start, ", "machine: M, ")
    text = text.replace("toe: west.end, normal: main.start", "toe: west.end, reverse: main.start")
    derailer = "derailers:\n  D: {section: p, inner: P.normal, outer: spur.start, machine: M}\nsignals:"
    made = grown(text.replace("signals:", derailer))
    assert made is not None
    assert "P.normal cannot be protected in route X2-E: M would have to lie N, and lies R on the path" in {
        d.message for d in made[2].diagnostics if d.code == "IL4002"
    }


def test_the_flank_space_of_an_overlap_is_kept_where_the_next_section_is_beyond_it() -> None:
    """An overlap may end in a section before the next one: what stands there is beside it, not on it."""
    made = grown(SCISSORS_BEYOND)
    assert made is not None and audit(made[0], made[1]) == ()
    assert "T2" in {c.name for c in made[1].route[RouteId("SI-SA.o2")].clear.space}


def test_an_overlap_whose_flank_space_is_not_asked_for_is_seen_by_a_claim() -> None:
    """S-FLANK-SPACE speaks of proceed over the way, not of proceed to the signal before it."""
    made = grown(SCISSORS_BEYOND)
    assert made is not None
    layout, table, _ = made
    assert prove(System(layout, lower(layout, table)), Limits(search_depth=0)).proved
    weak = replace(table, locks=tuple(replace(t, space=()) if t.section == "T1" else t for t in table.locks))
    assert weak != table
    result = prove(System(layout, lower(layout, weak)), Limits(search_depth=0))
    assert "S-OVERLAP" in {c.id for c in result.claims if c.verdict is not Verdict.PROVED}


SPUR = """
interlock: 1
name: spur
boundaries: {W: {approach: wa 800, trains: in}, E: {trains: out}, V: {approach: va 800, trains: in}}
buffers: [B]
tracks: {main: [W, m1 400, m2 400], east: [m3 400, E], siding: [s1 100, s2 200, B], stub: [V, u1 100, u2 300]}
points:
  1A: {section: p1, toe: main.end, normal: east.start, reverse: 1B.reverse}
  1B: {section: p2, toe: siding.start, normal: stub.end}
signals:
  U: {from: V, into: u1}
  U2: {from: u2, into: p2}
  X1: {from: W, into: m1}
  X2: {from: m2, into: p1}
  H: {from: s1, into: s2}
"""
TRAP = (
    SPUR.replace(", V: {approach: va 800, trains: in}", "")
    .replace("  U: {from: V, into: u1}\n  U2: {from: u2, into: p2}\n", "")
    .replace("buffers: [B]", "buffers: [B]\ntraps: [T]")
    .replace("normal: stub.end", "normal: drag.start")
    .replace("stub: [V, u1 100, u2 300]", "drag: [d1 60, T]")
)


@pytest.mark.parametrize(
    "text",
    [SPUR, SPUR.replace("H: {from: s1, into: s2}", "H: {from: s1, into: s2, kind: board}"), TRAP]
    + [TRAP.replace("drag: [d1 60, T]", "drag: [p2 60, T]"), TRAP.replace("{section: p2,", "{section: p2, work: hand,")]
    + [SPUR.replace("name: spur", f"name: spur\nprofile: {p}\nprinciples: {{restart_delay_s: 999}}") for p in PROFILES],
)
def test_a_point_turns_away_what_stands_before_the_end_of_the_track_behind_it(text: str) -> None:
    """The other end of a crossover, and a trap with a track of its own: the end of the siding was preferred to them."""
    made = grown(text)
    assert made is not None and audit(made[0], made[1]) == ()
    row = next(r for r in made[1].routes if r.id == "X2-E")
    assert ("1B", Position.NORMAL) in {(p.machine, p.position) for p in row.locking.points}


@pytest.mark.parametrize("space", ["no", "yes"])
def test_a_spur_is_told_of_where_another_train_may_be_in_it_as_well(space: str, tmp_path: Path) -> None:
    """Such a section is no flank space, and whoever asked for flank space was told nothing of the spur."""
    text = f"""
interlock: 1
name: both_ways
principles: {{flank_space: {space}}}
boundaries: {{W: {{approach: wa 300}}, E: {{trains: out}}, V: {{approach: va 300}}}}
buffers: [T]
tracks:
  west: [W, m1 200]
  middle: [m3 100]
  east: [m5 200, E]
  side: [s1 200]
  spur: [b1 100, T]
  stub: [V, u1 200]
points:
  A: {{section: m2, toe: middle.start, normal: west.end, reverse: P.normal}}
  B: {{section: m4, toe: east.start, normal: middle.end, reverse: P.reverse}}
  P: {{section: s2, toe: side.end}}
  3: {{section: s3, toe: side.start, normal: spur.start, reverse: stub.end}}
signals:
  X1: {{from: W, into: m1}}
  X2: {{from: m1, into: m2}}
  U1: {{from: V, into: u1}}
  U2: {{from: u1, into: s3}}
  S: {{from: s1, into: s3}}
"""
    tmp_path.joinpath("x.yaml").write_text(text, "utf-8")
    found = check_file(str(tmp_path / "x.yaml"))
    assert found.ok and found.table is not None
    row = next(r for r in found.table.routes if r.id == "X2-E")
    assert "b1" not in {c.name for c in row.clear.space}
    told = [d for d in found.diagnostics if d.code == "IL4017"]
    assert len(told) == 1 and "B.reverse" in told[0].message, found.diagnostics
    assert ("flank_space" in told[0].fix) == (space == "no")


ONE_WAY_LANE = """
interlock: 1
name: lane
profile: mine
boundaries:
  W: {approach: wa 400}
  E: {approach: ea 400}
tracks:
  west: [W, q1 200]
  up: [g1 500]
  loop: [g2 500]
  east: [q9 200, E]
points:
  P1: {section: w1, toe: west.end, normal: up.start, reverse: loop.start, legs: 30}
  P2: {section: w2, toe: east.start, normal: up.end, reverse: loop.end, legs: 30}
sections:
  g1: {one_way: backward}
signals:
  A1: {from: W, into: q1}
  A2: {from: q1, into: w1}
  B1: {from: E, into: q9}
  B2: {from: q9, into: w2}
  N2: {from: g2, into: w2}
  S1: {from: g1, into: w1}
  S2: {from: g2, into: w1}
"""


def test_vehicles_run_away_over_an_inclined_lane_against_its_one_way() -> None:
    """A level track that trains run over one way protects; from an inclined one something must hold what comes back,
    before it comes: the signal beyond the lane does not."""
    protected = {}
    steep = ONE_WAY_LANE.replace("one_way: backward", "one_way: backward, lane: inclined")
    bare = grown(steep)
    assert bare is not None and {d.about for d in bare[2].diagnostics if d.code == "IL4001"} == {
        Element("points", "P2")
    }
    derailer = "derailers: {D2: {section: d2, inner: P2.normal, outer: up.end}}\nsignals:"
    kept = steep.replace("normal: up.end, ", "").replace("signals:", derailer)
    for lane, text in (("level", ONE_WAY_LANE), ("inclined", kept)):
        made = grown(text)
        assert made is not None and not made[2].has_errors and audit(made[0], made[1]) == ()
        assert prove(System(made[0], lower(made[0], made[1]))).proved
        protected[lane] = {
            (c.requester, str(p)) for c in made[1].route[RouteId("N2-E")].locking.flank for p in c.providers
        }
    assert protected == {"level": {("P2.normal", "g1")}, "inclined": {("P2.normal", "D2 N")}}


SAFETY_SIDING = """
interlock: 1
name: siding
profile: cn
boundaries:
  X: {approach: XJG 1000}
  S: {approach: SJG 1000}
buffers: [ZB]
traps: [AQX]
tracks:
  w: [X, IAG 150]
  m: [IG 850]
  e: [m.end, IIAG 150, S]
  zyx: [ZB, ZG 300]
  aq: [AQ 50, AQX]
points:
  1: {section: 1DG, toe: w.end, normal: m.start, reverse: 3.reverse}
  3: {section: 3DG, toe: zyx.end, normal: aq.start}
signals:
  XX: {from: X, into: IAG}
  SS: {from: S, into: IIAG}
  SI: {from: IG, into: 1DG}
  XI: {from: IG, into: IIAG}
  SZ: {from: ZG, into: 3DG, kind: combined}
"""


@pytest.mark.parametrize("kind", ["trap", "derailer"])
def test_what_is_there_to_hold_vehicles_is_laid_whatever_signal_stands_behind_it(kind: str) -> None:
    """In `cn`, where a signal at stop is preferred to other points."""
    text = SAFETY_SIDING
    if kind == "derailer":
        for old, new in (
            ("traps: [AQX]\n", ""),
            ("  aq: [AQ 50, AQX]\n", "  n: [3DG 40]\n"),
            ("reverse: 3.reverse}", "reverse: n.end}"),
            ("  3: {section: 3DG, toe: zyx.end, normal: aq.start}\n", ""),
            ("signals:", "derailers:\n  3: {section: 3DG, inner: n.start, outer: zyx.end}\nsignals:"),
        ):
            text = text.replace(old, new)
    made = grown(text)
    assert made is not None and not made[2].has_errors and audit(made[0], made[1]) == ()
    points = made[1].route[RouteId("XX-XI")].locking.points
    assert [(str(p.machine), str(p.position)) for p in points if p.role is Role.FLANK] == [("3", "N")]


CALLED_OVER = """interlock: 1
name: called_over
principles: {flank_space: yes}
boundaries: {A: {approach: aa 600}, B: {approach: bb 600}, C: {trains: out}, D: {trains: out}}
tracks: {a: [A, a1 300], b: [B, b1 300], c: [c1 300, C], d: [d1 300, D]}
points:
  1A: {machine: 1, section: T1, toe: a.end, normal: 2B.normal}
  2B: {machine: 2, section: T1, toe: c.start}
  2A: {machine: 2, section: T2, toe: b.end, normal: 1B.normal}
  1B: {machine: 1, section: T2, toe: d.start}
crossings: {X: {arms: [{section: T1, ends: [1A.reverse, 1B.reverse]}, {section: T2, ends: [2A.reverse, 2B.reverse]}]}}
signals:
  SI: {from: A, into: a1}
  SA: {from: a1, into: T1, call_on: yes}
  SJ: {from: B, into: b1}
  SB: {from: b1, into: T2, call_on: yes}
"""


def test_a_train_is_called_on_over_a_scissors_whose_arm_lies_in_a_section_beyond() -> None:
    """T2, into which the route leads, must be clear as the flank space of the other arm: the witness had it fail, where
    it may be d1 that fails."""
    made = grown(CALLED_OVER)
    assert made is not None and audit(made[0], made[1]) == ()
    layout, table, _ = made
    called = table.route[RouteId("SA-D.c")]
    assert called.path.section_ids == ("T1", "T2", "d1") and "T2" in {c.name for c in called.clear.space}
    result = prove(System(layout, lower(layout, table)), Limits(search_depth=0))
    assert result.proved and all(w.ok for w in result.witnesses)


def test_a_call_on_route_that_wants_what_is_no_flank_space_clear_has_no_witness() -> None:
    """Sections beside which no vehicle comes in may fail, whatever the controller asks for."""
    made = grown(CALLED_OVER)
    assert made is not None
    layout, table, _ = made
    row = table.route[RouteId("SA-D.c")]
    more = (*row.clear.sections, ClearCell(SectionId("d1"), Because("R2", "by mistake")))
    weak = replace(
        table,
        routes=tuple(replace(r, clear=replace(r.clear, sections=more)) if r is row else r for r in table.routes),
    )
    result = prove(System(layout, lower(layout, weak)), Limits(search_depth=0))
    refused = [("SA-D.c", "the request is refused: not d1 clear")]
    assert [(w.route, w.text) for w in result.witnesses if not w.ok] == refused


def test_of_one_route_it_is_said_that_it_passes_there(tmp_path: Path) -> None:
    text = Path("layouts/refuted/wrong_waiver.yaml").read_text("utf-8").split("waive:")[0] + "exclude:\n"
    file = tmp_path / "one.yaml"
    for entry, end in (("X1", "A"), ("X1", "B"), ("X3", "C")):
        text += f"  - {{from: {entry}, to: {end}, reason: not wanted}}\n"
    file.write_text(text, "utf-8")
    (bare,) = [d.message for d in check_file(str(file)).diagnostics if d.code == "IL4001"]
    assert bare == "nothing keeps vehicles away from P1.reverse; route X2-C passes there"


@pytest.mark.parametrize("name", ["junction", "cn6502", "slip_junction"])
def test_a_signal_protects_from_beyond_the_fouling_point_and_the_clearance_at_points_and_diamonds(name: str) -> None:
    layout, _, _ = built(name)
    rules, seen = layout.principles, set[str]()
    for r in (r for ways in topology(layout).traversals.values() for t in ways for r in requesters(layout, t)):
        point = layout.pointwork.point_at.get(r.node)
        fouling = rules.fouling_m if point is None else point.fouling
        assert r.clear_of == fouling + rules.clearance_m, r.name
        seen.add("diamond" if point is None else "point")
    assert "point" in seen and (name != "junction" or "diamond" in seen)


def test_the_stop_lamps_of_all_signals_behind_a_toe_are_asked_for() -> None:
    """Where a flank is handed on at a toe both legs are looked at, and each signal there protects."""
    text = Path("layouts/heishan.yaml").read_text("utf-8") + "\nprinciples: {flank_lamp: yes, lamp_proof: yes}\n"
    made = grown(text)
    assert made is not None
    lamps = {c.name for c in made[1].route[RouteId("XL1-XT3")].clear.space if c.lamp}
    assert lamps >= {"XT7", "XL2"} and audit(made[0], made[1]) == ()
