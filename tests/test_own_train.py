"""Routes that their own train keeps from being set: refused by the derivation, seen by the audit, and never driven."""

from __future__ import annotations

from pathlib import Path

import pytest

from interlock.audit import audit
from interlock.derivation import derive
from interlock.diag import Diagnostic, Severity, Sink
from interlock.frontend import load_text
from interlock.logic.lower import lower
from interlock.model.elements import RouteId
from interlock.model.layout import Layout
from interlock.proof.system.loop import closed_loop
from interlock.proof.witnesses.routes import witnesses
from interlock.table.rows import InterlockingTable
from tests.grow import grow
from tests.grow_all import grow_all
from tests.layouts import grown

RING = Path("tests/diagnostics/IL4016.yaml").read_text("utf-8")
EXCLUDED = "exclude:\n  - {from: X, to: X, via: [ra], kind: main, reason: it would end in its own rear}\n"
LOOP = """interlock: 1
name: loop
profile: mine
principles: {flank_space: yes}
boundaries: {W: {approach: w0 600}}
tracks:
  west: [W, w1 250]
  loop: [PARTS, y 50]
points:
  P: {section: T, toe: west.end, normal: loop.start, reverse: loop.end}
signals:
  X1: {from: W, into: w1}
  X2: {from: w1, into: T}
  OUT: {from: a, into: y}
"""
"""A balloon loop, whose two ends lie at the legs of one point."""
AHEAD = """interlock: 1
name: ahead
boundaries: {W: {approach: wa 600, trains: in}, E: {trains: out}}
tracks:
  west: [W, w1 100]
  east: [e1 100, E]
  a: [ra 200]
  ring: [rc 200, rd 200]
points:
  P: {section: p, toe: ring.start, normal: a.end, reverse: west.end}
  Q: {section: q, toe: ring.end, normal: a.start, reverse: east.start}
signals:
  X1: {from: W, into: w1}
  X2: {from: w1, into: p}
  X: {from: ra, into: p}
  Z: {from: rd, into: q}
overlaps: {Z: {length: 150}}
"""
"""The overlap of the signal in the ring lies over the section in which the train stands, or over the way out."""


def made(text: str) -> tuple[Layout, InterlockingTable, list[Diagnostic]]:
    """Layout, table, and the errors of a text that the front end admits."""
    found = grown(text)
    assert found is not None
    return found[0], found[1], [d for d in found[2].diagnostics if d.severity == "error"]


def undrivable(layout: Layout, table: InterlockingTable) -> set[str]:
    """The routes that no run can set, drive and release."""
    return {w.route for w in witnesses(closed_loop(layout, lower(layout, table))) if not w.ok}


def own(layout: Layout, table: InterlockingTable) -> set[str]:
    """The routes of which the audit says the same."""
    return {f.route for f in audit(layout, table) if "own train" in f.text or "no room" in f.text}


def test_a_train_cannot_run_round_a_ring_into_the_section_in_which_it_stands() -> None:
    layout, table, errors = made(RING)
    assert [d.code for d in errors] == ["IL4016"]
    assert errors[0].message.startswith(
        "routes X-X, X-X.c can never be set: its train stands before X in ra, and ra must"
    )
    assert {"X-X", "X-X.c"} == undrivable(layout, table) == own(layout, table)


def test_what_is_left_when_it_is_excluded_can_be_driven() -> None:
    layout, table, errors = made(RING + EXCLUDED)
    assert errors == [] and audit(layout, table) == () and undrivable(layout, table) == set()
    assert {"X-X.s", "Y-Y"} <= {r.id for r in table.routes}, "vehicles are shunted round it into the track they left"


@pytest.mark.parametrize("parts", ["a 400", "b 200, a 200"])
def test_the_section_from_which_a_train_runs_is_no_flank_space_of_its_way(parts: str) -> None:
    layout, table, errors = made(LOOP.replace("PARTS", parts))
    assert errors == [] and undrivable(layout, table) == own(layout, table) == set()
    assert "a" not in {c.name for c in table.route[RouteId("OUT-W")].clear.space}


def test_an_overlap_over_the_section_in_which_its_train_stands_is_none_for_the_route() -> None:
    layout, table, errors = made(AHEAD)
    over = {r.id: [s for s, _ in r.locking.overlap.ways] for r in table.routes if r.locking.overlap is not None}
    both = {"X2-Z": ["q", "ra"], "X2-Z.o2": ["q", "e1"]}
    assert over == {"X-Z.o2": ["q", "e1"], **both} and errors == [] and audit(layout, table) == ()


def test_whatever_is_refused_so_no_run_drives_and_the_audit_sees_it() -> None:
    seen = 0
    for seed in (37, 38, 77, 119, 121, 125, 135, 166, 271, -232):  # the last one: across a diamond of its overlap
        layout, table, errors = made(grow(seed) if seed > 0 else grow_all(-seed))
        assert {d.code for d in errors} == {"IL4016"}, seed
        names = {w.rstrip(",") for d in errors for w in d.message.split(" can never")[0].split(" ")[1:]}
        assert names == own(layout, table) and names <= undrivable(layout, table), seed
        seen += len(names)
    assert seen >= 19


ZONE = """interlock: 1
name: zone
boundaries: {W: {approach: wa 600}, E: {trains: out}}
tracks: {line: [W, q1 300, q2 300, q3 300, E]}
signals:
  A: {from: W, into: q1}
  B: {from: q1, into: q2}
zones: {Z: {sections: [q1, q3], trains: 1}}
"""
"""A train before B stands in the zone into which its route leads again."""


@pytest.mark.parametrize(
    ("text", "which", "why", "fix", "seen"),
    [
        (
            RING,
            "routes X-X, X-X.c",
            "its train stands before X in ra, and ra must be free for its way",
            "let the way end before ra, at a signal or board further back",
            ["ra is taken by its own train"],
        ),
        (
            ZONE,
            "route B-E",
            "zone Z has room for 1, and its train stands in it before B",
            "raise the maximum of Z",
            ["no room in Z"],
        ),
        (
            grow(37),
            "route X-B13",
            "zone Z has room for 1, and its train comes in twice",
            "raise the maximum of Z",
            ["no room in Z"],
        ),
        (
            grow(38),
            "route G23-W",
            "its train stands before G23 in s13, and machine M21, on which it stands, must lie R",
            "divide s13 by a joint, so that the train stands clear",
            ["its own train stands on points that it needs otherwise"],
        ),
        (
            grow(119),
            "routes G19-W12, G19-W12.c",
            "its train stands before G19 in s5, and s5 must be free: s5 clear across the diamond D4",
            "move the joint out of the fouling point",
            ["its own train stands foul of it in s5", "its own train stands across its way"],
        ),
        (
            grow(121),
            "route G44-G35",
            "its train stands before G44 in s11, and s11 must be free: the joint s7|s11 is foul of point P8",
            "move the joint out of the fouling point",
            ["its own train stands foul of it in s11"],
        ),
    ],
    ids=["its way", "a zone in which it stands", "a zone twice", "points under it", "a diamond", "a foul joint"],
)
def test_what_is_said_of_each_cause_and_what_helps(text: str, which: str, why: str, fix: str, seen: list[str]) -> None:
    layout, table, errors = made(text)
    told = next(d for d in errors if d.message.startswith(f"{which} "))
    assert told.message == f"{which} can never be set: {why}"
    assert told.fix.partition(", or exclude ")[0] == fix
    for route in which.partition(" ")[2].split(", "):
        assert [f.text for f in audit(layout, table) if (f.route, f.column) == (route, "route")] == seen


TRAP_IN_REAR = """interlock: 1
name: trap_in_rear
profile: mine
principles: {overlap_m: 0}
boundaries: {W: {approach: wa 200}}
traps: [T]
tracks:
  west: [W, w1 100]
  stub: [r 40, T]
  ring: [x1 200]
points:
  P: {section: p, toe: west.end, normal: ring.end, reverse: M.normal, legs: 5}
  M: {section: r, toe: ring.start, reverse: stub.start, legs: 15}
signals:
  A: {from: W, into: w1}
  B: {from: w1, into: p}
  X: {from: r, into: x1}
"""
"""Round the loop a train comes back over P, beside which the section begins in which it has stood."""
SIDING_IN_REAR = TRAP_IN_REAR.replace("traps", "buffers") + "exclude:\n  - {from: B, to: T, reason: not wanted}\n"
DEMAND = "demand:\n  - {point: M, lies: normal, routes: {from: X}, reason: none}\n"
JOINT = "the joint p|r is foul of point P, unless M lies R"


@pytest.mark.parametrize(
    ("text", "why"),
    [
        (TRAP_IN_REAR, JOINT),
        (TRAP_IN_REAR.replace("stub: [r 40", "stub: [s1 40"), "x1 and r are foul beside point P"),
        (SIDING_IN_REAR, "x1 and r are foul beside point P"),
        (SIDING_IN_REAR + DEMAND, JOINT),
    ],
    ids=["out of a trap none comes", "nor out of a section before a trap", "no route over it", "held so by the route"],
)
def test_a_train_stands_foul_by_the_point_under_it_that_no_train_passed_the_other_way(text: str, why: str) -> None:
    """M is under it, and lies normal; nothing tells who is in r that he does not stand at the joint beside P."""
    layout, table, errors = made(text)
    stands = "route X-W can never be set: its train stands before X in r"
    assert [d.message for d in errors] == [f"{stands}, and r must be free: {why}"]
    assert "X-W" in undrivable(layout, table)


def past_k(text: str) -> str:
    """Round the loop the train passes K at identifier light: what lies beyond is set with the route to K."""
    text = text.replace("ring: [x1 200]", "ring: [x1 100, x2 100]").replace(
        "overlap_m: 0", "overlap_m: 0, lamp_proof: yes"
    )
    return text.replace("  X: {", "  K: {from: x1, into: x2, identifier: yes}\n  X: {")


PAST_Z = (
    AHEAD.replace("name: ahead\n", "name: ahead\nprinciples: {lamp_proof: yes}\n")
    .replace("into: q}", "into: q, identifier: yes}\n  Z2: {from: q, into: ra}")
    .replace("Z: {length: 150}", "Z: {length: 0}, Z2: {length: 20}")
)
PAST_C = ZONE.replace("name: zone\n", "name: zone\nprinciples: {lamp_proof: yes}\n").replace(
    "zones:", "  C: {from: q2, into: q3, identifier: yes}\nzones:"
)


@pytest.mark.parametrize(
    ("text", "route", "why"),
    [
        (past_k(TRAP_IN_REAR), "X-K-W", f"r must be free: {JOINT}"),
        (past_k(TRAP_IN_REAR).replace("[r 40", "[s1 40"), "X-K-W", "r must be free: x2 and r are foul beside point P"),
        (past_k(SIDING_IN_REAR + DEMAND.replace("X}", "K}")), "X-K-W", f"r must be free: {JOINT}"),
        (PAST_Z, "X-Z-Z2", "ra must be free for its overlap"),
        (PAST_C, "B-C-E", "zone Z has room for 1, and its train stands in it before B"),
    ],
    ids=["a foul joint", "ways that are foul", "what is demanded", "an overlap", "a zone"],
)
def test_what_is_set_with_a_route_past_a_signal_counts_as_its_own(text: str, route: str, why: str) -> None:
    layout, table, errors = made(text)
    told = next(d for d in errors if d.code == "IL4016" and d.message.startswith(f"route {route} "))
    assert told.message.endswith(why) and route in undrivable(layout, table)


# --- a train that never comes ---------------------------------------------------------------------

NEVER = Path("tests/diagnostics/IL4018.yaml").read_text("utf-8")
BACK = "  H: {from: b1, into: T, kind: shunt}\n"
"""A signal from which shunting movements come to G."""


def checked(text: str) -> tuple[Layout, InterlockingTable, list[str]]:
    """Layout and table of a text, and the errors that `check` tells."""
    sink = Sink()
    layout, source = load_text("never.yaml", text, sink)
    assert layout is not None
    table = derive(layout, sink)
    source.check_allowed(sink)
    return layout, table, [d.code for d in sink.diagnostics if d.severity is Severity.ERROR]


JOINT = NEVER.replace("[c1 200, B]", "[d1 50, c1 150, B]").replace("{from: T,  into: c1", "{from: d1, into: c1")


@pytest.mark.parametrize(
    ("text", "errors"),
    [
        (NEVER, ["IL4018"]),
        (JOINT, []),
        (f"{NEVER}exclude:\n  - {{from: G, reason: not wanted}}\n", []),
        (NEVER.replace("  G: {", f"{BACK}  G: {{"), []),
    ],
)
def test_a_route_to_whose_signal_no_train_comes_is_refused(text: str, errors: list[str]) -> None:
    assert checked(text)[2] == errors


def test_what_is_refused_cannot_be_driven_and_what_is_not_can() -> None:
    """The witness run is the second opinion."""
    for text, good in ((NEVER, False), (NEVER.replace("  G: {", f"{BACK}  G: {{"), True)):
        layout, table, errors = checked(text)
        runs = {w.route: w.ok for w in witnesses(closed_loop(layout, lower(layout, table)))}
        assert (errors == []) is good is runs[RouteId("G-B")]


OTHER_ARM = """interlock: 1
name: other_arm
boundaries: {W: {approach: w0 600, trains: in}, E: {trains: out}, F: {trains: out}}
buffers: [V]
tracks:
  m: [W, a1 600]
  n: [b1 600, E]
  o: [V, o1 600]
  f: [c1 600, F]
crossings:
  D: {arms: [{section: T, ends: [m.end, n.start]}, {section: T, ends: [o.end, f.start]}]}
signals:
  A: {from: W,  into: a1}
  X: {from: a1, into: T}
  H: {from: T,  into: b1}
  G: {from: T,  into: c1}
"""


def test_a_train_in_a_section_leaves_it_by_the_arm_of_the_diamond_on_which_it_stands() -> None:
    """A route leads into T, to H; from there no train comes to G, which stands at the end of the other arm."""
    layout, table, errors = checked(OTHER_ARM)
    assert "IL4018" in errors and undrivable(layout, table) == {"G-F"}


ROUND = """interlock: 1
name: round
boundaries: {W: {approach: wa 600}}
tracks:
  west: [W, w1 100]
  ring: [rc 200, rd 200, ra 200]
points:
  P: {section: p, toe: ring.start, normal: ring.end, reverse: west.end}
signals:
  X1: {from: W, into: w1}
  X2: {from: w1, into: p}
  X: {from: ra, into: p}
  Z: {from: rd, into: ra}
overlaps: {Z: {length: 1000}}
"""


def test_an_overlap_is_never_as_long_as_it_should_be_by_counting_a_section_twice() -> None:
    """Round the ring there are 640 m until it comes to its own beginning: a train that overruns Z is not stopped by
    track that is the same again, so that no route leads to Z."""
    found = grown(ROUND)
    assert found is not None
    assert [d.code for d in found[2].diagnostics if d.severity == "error"] == ["IL4008"]
    assert {r.exit for r in found[1].routes} == {"X2", "X"}
