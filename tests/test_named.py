"""Names of routes and switches for automatic working: which route each of them means."""

from __future__ import annotations

import pytest

from interlock.diag import Sink
from interlock.frontend import load_text
from tests.layouts import grown
from tests.published import text_of

YARD = """interlock: 1
name: yard
boundaries:
  W: {approach: wa 300}
  E: {trains: out}
tracks:
  west: [W, q1 200]
  odd:  [q3 300]
  even: [q4 300]
  east: [q6 200, E]
points:
  P1: {section: q2, toe: west.end,   normal: odd.start, reverse: even.start}
  P2: {section: q5, toe: east.start, normal: odd.end,   reverse: even.end}
signals:
  X1: {from: W,  into: q1}
  X2: {from: q1, into: q2, kind: combined}
  X3: {from: q3, into: q5, kind: shunt}
"""


STRAIGHT = "routes:\n  through: {from: X2, to: E}\n  loop: {from: X2, to: E, via: [q4]}\n"


def names(text: str) -> tuple[dict[str, str], list[str]]:
    """Each name with the route that bears it, and what is said of the names."""
    made = grown(YARD + text)
    assert made is not None
    _, table, sink = made
    said = [f"{d.code} {d.message}" for d in sink.diagnostics if d.code in ("IL2007", "IL2024")]
    return {n: r.id for r in table.routes for n in r.names}, said


def test_train_route_and_shunt_route_between_the_same_ends_have_names_of_their_own() -> None:
    both = "  X4: {from: q4, into: q5, kind: combined}\nroutes:\n"
    text = both + "  run: {from: X2, to: X4, kind: main}\n  shunt: {from: X2, to: X4, kind: shunt}\n"
    named, said = names(text)
    assert (named, said) == ({"run": "X2-X4", "shunt": "X2-X4.s"}, [])
    assert names(text.replace(", kind: main", "")) == (named, []), "without a kind, the train route"


def test_a_call_on_route_has_a_name_of_its_own() -> None:
    both = "  X4: {from: q4, into: q5, call_on: yes}\nroutes:\n  run: {from: X4, to: E}\n"
    assert names(both) == ({"run": "X4-E"}, [])
    named, said = names(both + "  called: {from: X4, to: E, kind: call-on}\n  main: {from: X4, to: E, kind: main}\n")
    assert (named, said) == ({"run": "X4-E", "main": "X4-E", "called": "X4-E.c"}, [])
    _, (none,) = names(both + "  called: {from: X2, to: X4, kind: call-on}\n")
    assert none == "IL2007 there is no call-on route from X2 to X4 (named called)"


def test_a_name_fits_the_only_kind_there_is() -> None:
    assert names("routes:\n  a: {from: X2, to: X3}\n") == ({"a": "X2-X3.s"}, [])
    assert names("routes:\n  a: {from: X2, to: X3, kind: main}\n") == (
        {},
        ["IL2007 there is no train route from X2 to X3 (named a)"],
    )


def test_a_route_is_named_by_its_last_section_as_the_language_says() -> None:
    assert (
        names("routes:\n  a: {from: X2, to: q6, via: [q3]}\n")[0]
        == names("routes:\n  a: {from: X2, to: E, via: [q3]}\n")[0]
    )


def test_a_switch_for_automatic_working_fits_by_the_last_section_too() -> None:
    made = grown(YARD + "automatic:\n  - {from: X2, to: q6, via: [q4]}\n")
    assert made is not None
    _, table, sink = made
    (route,) = table.automatic
    assert [s.section for s in table.route[route].clear.sections] == ["q2", "q4", "q5", "q6"]
    assert "IL2007" not in {d.code for d in sink.diagnostics}


@pytest.mark.parametrize("what", ["routes:\n  a: {from: X2, to: E}\n", "automatic:\n  - {from: X2, to: E}\n"])
def test_that_more_routes_fit_than_one_is_said(what: str) -> None:
    _, (said,) = names(what)
    assert said.startswith("IL2024") and said.endswith("fits 2 routes from X2 to E, and means X2-E")
    via = what.replace("to: E}", "to: E, via: [q4]}")
    assert names(via)[1] == []


def test_the_way_without_a_section_of_its_own_is_meant_by_none() -> None:
    """Two points that meet without track between them, beside a loop: no section tells the straight way."""
    straight = YARD.replace("  odd:  [q3 300]\n", "").replace("odd.start", "P2.normal").replace(", normal: odd.end", "")
    made = grown(straight.replace("  X3: {from: q3, into: q5, kind: shunt}\n", "") + STRAIGHT)
    assert made is not None
    _, table, sink = made
    named = {n: [s.section for s in r.clear.sections] for r in table.routes for n in r.names}
    assert named == {"through": ["q2", "q5", "q6"], "loop": ["q2", "q4", "q5", "q6"]}
    assert "IL2024" not in {d.code for d in sink.diagnostics}


@pytest.mark.parametrize(
    ("first", "second", "fix"),
    [
        (
            "main",
            "shunt",
            "one signal gives both: `A: {..., kind: combined}`; remove B, or turn it round: swap `from` and `into`",
        ),
        (
            "shunt",
            "combined",
            "one signal gives both: `A: {..., kind: combined}`; remove B, or turn it round: swap `from` and `into`",
        ),
        ("main", "main", "remove one of them, or turn it round: swap `from` and `into`"),
        ("main", "board", "remove one of them, or turn it round: swap `from` and `into`"),
    ],
)
def test_a_shunt_signal_at_a_main_signal_is_one_combined_signal(first: str, second: str, fix: str) -> None:
    """As drawings of many railways have them: 5R and 13R on one post."""
    text = YARD.replace(
        "X3: {from",
        f"A: {{from: q4, into: q5, kind: {first}}}\n  B: {{from: q4, into: q5, kind: {second}}}\n  X3: {{from",
    )
    sink = Sink()
    load_text("yard.yaml", text, sink)
    (found,) = (d for d in sink.diagnostics if d.code == "IL3007")
    assert str(found.fix) == fix


def test_where_no_section_tells_a_way_from_all_others_the_fix_names_those_that_do_together() -> None:
    """Tatehama: the short way to track 3 lies on one of the two others."""
    text = text_of("tatehama")
    found = grown(text[: text.index("exclude:")])
    assert found is not None
    (told,) = [x for x in found[2].diagnostics if x.code == "IL2024"]
    assert told.message.startswith("the name 5LC fits 3 routes") and "via: [24T]" in str(told.fix)
    found = grown(text[: text.index("exclude:")].replace("{from: 5L, to: B3}", "{from: 5L, to: B3, via: [24T]}"))
    assert found is not None and not [x for x in found[2].diagnostics if x.code == "IL2024"]
    assert found[1].route["5L-B3"].names == ("5LC",)


def called_twice(text: str) -> list[str]:
    """What is said of names that mean two routes."""
    made = grown(text)
    assert made is not None
    return [d.message for d in made[2].diagnostics if d.code == "IL2002"]


def test_a_name_of_one_route_is_no_name_of_another_one() -> None:
    """Whoever asks for X2-E gets the route from X2 to E; upper and lower case are one."""
    assert called_twice(YARD + "routes:\n  x2-e: {from: X1, to: X2}\n") == [
        "x2-e names the route X1-X2, and X2-E is the route from X2 to E"
    ]
    assert called_twice(YARD + "routes:\n  R: {from: X1, to: X2}\n  r: {from: X2, to: E, via: [q3]}\n") == [
        "r names the route X2-E, and R is the route from X1 to X2"
    ]
    assert not called_twice(YARD + "routes:\n  X1-X2: {from: X1, to: X2}\n"), "its own name"


def test_two_routes_never_bear_one_name() -> None:
    text = """interlock: 1
name: line
boundaries: {W: {approach: wa 300}, E: {approach: ea 300}}
tracks:
  line: [W, q1 200, q2 200, E]
signals:
  A-B: {from: W,  into: q1}
  C:   {from: q1, into: q2}
  A:   {from: E,  into: q2}
  B-C: {from: q2, into: q1}
"""
    assert called_twice(text) == ["the routes from A to B-C and from A-B to C would both be called A-B-C"]
    assert not called_twice(text.replace("  A: ", "  Y: "))


@pytest.mark.parametrize(
    ("text", "fix"),
    [
        ("routes:\n  a: {from: X2, to: X3, kind: main}\n", "known here: E"),
        ("routes:\n  a: {from: X2, to: W, kind: shunt}\n", "known here: X3"),
        ("routes:\n  a: {from: X2, to: W}\n", "known here: E, X3"),
        ("routes:\n  a: {from: X2, to: W, kind: call-on}\n", "correct `from`: no call-on route begins at X2"),
        ("automatic:\n  - {from: X2, to: X3}\n", "known here: E"),
        ("automatic:\n  - {from: X3, to: E}\n", "correct `from`: no train route begins at X3"),
        ("automatic:\n  - {from: X2, to: X3, via: [q4]}\n", "known here: E"),
    ],
)
def test_ends_are_offered_of_the_kind_of_route_that_is_wanted(text: str, fix: str) -> None:
    """At X3, a shunt signal, no train route ends, and none begins there."""
    made = grown(YARD + text)
    assert made is not None
    (found,) = (d for d in made[2].diagnostics if d.code == "IL2007")
    assert str(found.fix) == fix
