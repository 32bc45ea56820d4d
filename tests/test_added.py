"""What the author adds to the derivation: hostile routes, demanded points, routes that are not printed.

An addition can only restrict: whatever a controller with additions grants, opens or moves in a scan, the controller
without them would, too, from the same state with the same inputs.
"""

from __future__ import annotations

import random
from pathlib import Path

import pytest

from interlock.audit import audit
from interlock.checker import specification
from interlock.checker.check import agree
from interlock.checker.reading import loaded
from interlock.derivation import derive
from interlock.diag import Sink
from interlock.emit.tables.document import table_json
from interlock.emit.tables.export import table_csv
from interlock.frontend import load_text
from interlock.logic.controller import Controller
from interlock.logic.eval import Machine
from interlock.logic.expr import conj, neg, var
from interlock.logic.lower import lower
from interlock.model.elements import RouteId
from interlock.model.layout import Layout
from interlock.model.portable import portable
from interlock.proof.engines import Answer, solver
from interlock.proof.engines.limits import Limits
from interlock.proof.engines.tseitin import Cnf
from interlock.proof.induction.verdict import Verdict
from interlock.proof.mutation import forgotten
from interlock.proof.prover import prove
from interlock.proof.system.loop import closed_loop
from interlock.proof.system.transition import System
from interlock.proof.witnesses.availability import Manner, availability
from interlock.table.cells import RouteKind
from interlock.table.columns import COLUMNS
from interlock.table.national import national_sheets
from interlock.table.printed import Printed
from interlock.table.rows import InterlockingTable
from interlock.verify import Rejected
from tests.grow import grow
from tests.grow_all import hostile_and_demand
from tests.layouts import built, grown
from tests.written import told

TEXT = Path("tests/layouts_for_tests/added.yaml").read_text("utf-8")
PLAIN = TEXT[: TEXT.index("hostile:")]


def made(text: str) -> tuple[Layout, InterlockingTable]:
    """Layout and table of a text without errors."""
    sink = Sink()
    layout, _ = load_text("added.yaml", text, sink)
    assert layout is not None, sink.diagnostics
    table = derive(layout, sink)
    assert not sink.has_errors and audit(layout, table) == (), sink.diagnostics
    return layout, table


DETOUR = Path("tests/layouts_for_tests/detour.yaml").read_text("utf-8")
NOT_LONG, NOT_SHORT = "via: [r1]", "not_via: [r1]"


@pytest.mark.parametrize(("which", "left"), [(NOT_LONG, "t1 t2 m2"), (NOT_SHORT, "t1 r1 r2 t2 m2")])
def test_either_of_two_ways_is_excluded(which: str, left: str) -> None:
    text = f"{DETOUR}exclude:\n  - {{from: S, {which}, reason: one way is enough}}\n"
    layout, table = made(text)
    assert [" ".join(r.path.section_ids) for r in table.routes if r.entry == "S" and r.kind == "main"] == [left]
    assert prove(System(layout, lower(layout, table)), Limits(search_s=0)).proved
    assert agree(*told(text), specification.shipped()).left == ()


ONE_MACHINE = """\
interlock: 1
name: one_machine
boundaries: {W: {approach: ap 600}, E: {trains: out}, F: {trains: out}, G: {trains: out}}
tracks:
  t1: [W, s1 60]
points:
  P1: {section: s1, toe: t1.end, normal: G, machine: M}
  P2: {section: s2, toe: P1.reverse, normal: E, reverse: F, machine: M}
signals:
  X: {from: W, into: s1}
"""


def test_a_path_that_needs_one_machine_in_both_positions_is_claimed_to_be_closed_as_the_second_checker_asks() -> None:
    layout, table = made(ONE_MACHINE)
    assert [" ".join(r.path.section_ids) for r in table.routes] == ["s1 s2", "s1"]
    result = prove(System(layout, lower(layout, table)), Limits(search_s=0))
    assert result.proved and next(c.places for c in result.claims if c.id == "S-EXCLUDED") == 1
    assert agree(*told(ONE_MACHINE), specification.shipped()).left == ()


def test_a_route_that_is_hostile_or_demands_a_point_is_told_by_what_it_does_not_pass() -> None:
    more = "hostile:\n  - {one: {from: S, not_via: [r1]}, other: {from: X}, reason: tight}\n"
    more += "demand:\n  - {point: 2, lies: normal, routes: {from: X, not_via: [r1]}, reason: overrun}\n"
    _, table = made(DETOUR + more)
    barred = {r.id for r in table.routes if r.locking.barred and r.entry == "S"}
    assert barred == {r.id for r in table.routes if r.entry == "S" and "r1" not in r.path.section_ids} != set()
    assert agree(*told(DETOUR + more), specification.shipped()).left == ()
    with pytest.raises(Rejected):
        agree(loaded(DETOUR + more.replace("not_via", "via")), *told(DETOUR + more)[1:], specification.shipped())


def test_additions_stand_in_the_table_with_their_reasons() -> None:
    _, table = made(TEXT)
    cell = {c.key: c for c in COLUMNS}
    route = {str(r.id): r for r in table.routes}
    assert "E2-S2 (declared hostile: the platform between the roads is narrow)" in cell["hostile"].text(route["A2-N1"])
    assert "A2-N1 (declared hostile: the platform" in cell["hostile"].text(route["E2-S2"])
    assert [c.route for c in route["A-A2"].locking.barred] == ["E1-E2"]
    text = "3 N (demanded: vehicles in the siding may be loaded with explosives)"
    assert cell["flank_points"].text(route["S1-W"]) == text
    assert {h.kind for h in route["S1-W"].locking.hostile if h.route == "Y-S2"} == {"added"}, "it turns the point"
    turned = "Y-S2 (3 N is demanded: vehicles in the siding may be loaded with explosives)"
    assert turned in cell["hostile"].text(route["S1-W"])


def test_nothing_derived_is_lost() -> None:
    (_, plain), (_, more) = made(PLAIN), made(TEXT)
    for a, b in zip(plain.routes, more.routes, strict=True):
        assert a.id == b.id and set(a.locking.hostile.routes) <= set(b.locking.hostile.routes)
        assert set(a.locking.points) <= set(b.locking.points) and a.path.traversals == b.path.traversals
    assert plain.locks == more.locks


SLIP = Path("tests/layouts_for_tests/slip.yaml").read_text("utf-8")


@pytest.mark.parametrize(
    ("machines", "point", "fault"),
    [("", "7a", None), ("[M7]", "M7", None), ("[M7]", "7/1a", "known here: M7"), ("[M7]", "7a", "half of a slip")],
)
def test_a_half_of_a_slip_is_demanded_by_the_name_of_its_machine(machines: str, point: str, fault: str | None) -> None:
    text = SLIP.replace("ne.start]]}", f"ne.start]], machines: {machines}}}") if machines else SLIP
    text += f"demand:\n  - {{point: {point}, lies: normal, routes: {{from: A, to: N1}}, reason: a waggon overhangs}}\n"
    if fault is None:
        made(text)
        assert agree(*told(text), specification.shipped()).left == ()
        return
    sink = Sink()
    assert load_text("slip.yaml", text, sink)[0] is None
    (found,) = [d for d in sink.diagnostics if d.code == "IL2001"]
    assert fault in f"{found.message} {found.fix}"


@pytest.mark.parametrize("profile", ["generic", "uk", "de", "cn"])
def test_a_route_that_is_not_listed_is_counted_in_every_printed_table(profile: str) -> None:
    layout, table = made(TEXT.replace("name: added", f"name: added\nprofile: {profile}"))
    (hidden,) = [r for r in table.routes if not r.listed]
    assert hidden.names == ("into_1",) and hidden.id in {r.route for r in table.route["S1-W"].locking.hostile}
    lines = table_csv(table).splitlines()
    assert lines[-1].startswith(",1 more route is not listed,") and len(lines) == len(Printed(table).all) + 1
    sheets = [s for s in national_sheets(layout, table) if s.of_routes]
    kinds = {"de_sslz": RouteKind.MAIN, "de_sslr": RouteKind.SHUNT}
    for s in sheets:
        assert any(n in s.rows[-1][0] for n in ("1 more", "1 条", "1 weitere"))
        if s.key in kinds:
            assert len(s.rows) == sum(w.rows[0].kind is kinds[s.key] for w in Printed(table).listed) + 1
    assert sheets


def test_it_is_proved_and_the_second_checker_asks_for_it() -> None:
    layout, table = made(TEXT)
    result = prove(System(layout, lower(layout, table)), Limits(search_s=0))
    assert {c.verdict for c in result.claims} == {Verdict.PROVED} and not result.dropped
    assert {"S-DECLARED", "S-DEMANDED"} <= {c.id for c in result.claims}
    assert agree(*told(TEXT), specification.shipped()).left == ()
    _, system, text = told(PLAIN)
    with pytest.raises(Rejected):
        agree(loaded(TEXT), system, text, specification.shipped())


# --- to call-on routes alone ------------------------------------------------------------------------

CALLED = Path("tests/layouts_for_tests/called_on.yaml").read_text("utf-8")


def test_what_is_added_to_call_on_routes_alone_is_not_added_to_the_train_route_over_the_same_way() -> None:
    _, table = made(CALLED)
    assert {r.id: [c.route for c in r.locking.barred] for r in table.routes if r.locking.barred} == {
        "A-N1.c": ["N1-E"],
        "N1-E": ["A-N1.c"],
    }
    assert {r.id: [p.machine for p in r.locking.added] for r in table.routes if r.locking.added} == {"A-N2.c": ["2"]}
    hostile = next(c for c in COLUMNS if c.key == "hostile").text(table.route[RouteId("A-N1.c")])
    assert "N1-E (declared hostile: a departure at the far end of the track)" in hostile


def test_it_is_proved_and_the_second_checker_asks_for_it_of_call_on_routes_and_of_no_others() -> None:
    layout, table = made(CALLED)
    result = prove(System(layout, lower(layout, table)), Limits(search_s=0))
    assert {c.verdict for c in result.claims} == {Verdict.PROVED} and not result.dropped
    _, system, text = told(CALLED)
    assert agree(loaded(CALLED), system, text, specification.shipped()).left == ()
    for chosen, claim in (("to: N1", "S-DECLARED"), ("to: N2", "S-DEMANDED")):
        other = CALLED.replace(f"{chosen}, kind: call-on", f"{chosen}, kind: main")
        with pytest.raises(Rejected, match=claim):
            agree(loaded(other), system, text, specification.shipped())


@pytest.mark.parametrize("part", ["hostile:", "demand:"])
def test_a_controller_without_it_is_refused_by_the_second_checker(part: str) -> None:
    at = CALLED.index(part)
    without = CALLED[:at] + (CALLED[CALLED.index("demand:") :] if part == "hostile:" else "")
    _, system, text = told(without)
    with pytest.raises(Rejected, match="S-DECLARED" if part == "hostile:" else "S-DEMANDED"):
        agree(loaded(CALLED), system, text, specification.shipped())


# --- call-on routes that are excluded alone -------------------------------------------------------

CALLED_OFF = CALLED[: CALLED.index("hostile:")] + "exclude:\n  - {from: A, to: N1, kind: call-on, reason: a platform}\n"
NOT_CALLED_OFF = CALLED_OFF[: CALLED_OFF.index("exclude:")]


def test_a_call_on_route_is_excluded_alone() -> None:
    _, every = made(NOT_CALLED_OFF)
    layout, table = made(CALLED_OFF)
    assert {r.id for r in every.routes} - {r.id for r in table.routes} == {"A-N1.c"}
    assert {"A-N1", "A-N2", "A-N2.c"} <= {r.id for r in table.routes} and audit(layout, table) == ()
    assert "A-N1.c" in {f.route for f in audit(layout, every)}


def test_it_is_proved_that_nobody_is_called_on_there_and_the_second_checker_asks_for_it() -> None:
    layout, table = made(CALLED_OFF)
    result = prove(System(layout, lower(layout, table)), Limits(search_s=0))
    assert {c.verdict for c in result.claims} == {Verdict.PROVED} and not result.dropped
    assert next(c.places for c in result.claims if c.id == "S-EXCLUDED") == 1
    _, system, text = told(CALLED_OFF)
    assert agree(loaded(CALLED_OFF), system, text, specification.shipped()).left == ()
    with pytest.raises(Rejected, match="S-EXCLUDED"):  # another one, of the same signal
        agree(loaded(CALLED_OFF.replace("to: N1, kind", "to: N2, kind")), system, text, specification.shipped())
    with pytest.raises(Rejected, match="S-EXCLUDED"):  # the train route with it
        agree(loaded(CALLED_OFF.replace("call-on, reason", "main, reason")), system, text, specification.shipped())


def test_a_controller_that_calls_on_all_the_same_is_refuted_and_refused_by_the_second_checker() -> None:
    layout, table = made(CALLED_OFF)
    ((_, forgets),) = forgotten.more(forgotten.exclusions)(layout, table)
    assert forgets.steps == lower(*made(NOT_CALLED_OFF)).steps
    result = prove(System(layout, forgets), Limits(search_s=60))
    (claim,) = [c for c in result.claims if c.id == "S-EXCLUDED"]
    assert claim.verdict is Verdict.REFUTED and claim.open == ("A call-on:1",)
    _, system, text = told(NOT_CALLED_OFF)
    with pytest.raises(Rejected, match="S-EXCLUDED"):
        agree(loaded(CALLED_OFF), system, text, specification.shipped())


@pytest.mark.parametrize(
    "exclusion", ["{from: A, kind: call-on, reason: none}", "{from: A, to: N1, via: [k1], kind: call-on, reason: none}"]
)
def test_all_call_on_routes_of_a_signal_are_excluded_or_those_over_some_sections(exclusion: str) -> None:
    text = NOT_CALLED_OFF + f"exclude:\n  - {exclusion}\n"
    layout, table = made(text)
    assert {r.id for r in table.routes if r.kind is RouteKind.CALL_ON} == ({"A-N2.c"} if "via" in exclusion else set())
    assert {"A-N1", "A-N2"} <= {r.id for r in table.routes} and audit(layout, table) == ()
    assert prove(System(layout, lower(layout, table)), Limits(search_s=0)).proved
    assert agree(*told(text), specification.shipped()).left == ()


def test_an_exclusion_of_call_on_routes_where_nobody_is_called_on_is_told() -> None:
    sink = Sink()
    text = NOT_CALLED_OFF + "exclude:\n  - {from: B, kind: call-on, reason: none}\n"
    layout, _ = load_text("called_on.yaml", text, sink)
    assert layout is not None
    derive(layout, sink)
    (found,) = [d for d in sink.diagnostics if d.code == "IL2012"]
    assert found.fix is not None and "no train is called on" in found.fix


# --- sections that are demanded clear ---------------------------------------------------------------

CLEAR = Path("tests/layouts_for_tests/clear_beyond.yaml").read_text("utf-8")
BARE = CLEAR[: CLEAR.index("demand:")]


def test_a_section_that_is_demanded_clear_stands_in_the_table_with_its_reason_and_nowhere_else() -> None:
    _, table = made(CLEAR)
    asked = {r.id: [c.section for c in r.clear.demanded] for r in table.routes if r.clear.demanded is not None}
    assert asked == {"A-N1.s": ["T3"], "A-N2.c": ["T2"]}
    cell = next(c for c in COLUMNS if c.key == "sections").text(table.route[RouteId("A-N1.s")])
    assert "T3 (demanded clear: the track is short)" in cell
    assert "demanded_clear" not in table_json(*made(BARE)), "written only where the author demands it"


@pytest.mark.parametrize("profile", ["generic", "uk", "de", "cn"])
def test_a_section_that_is_demanded_clear_stands_in_every_national_form(profile: str) -> None:
    with_, without = (
        [s.rows for s in national_sheets(*made(text + f"profile: {profile}\n")) if s.of_routes]
        for text in (CLEAR, BARE)
    )
    assert with_ != without


def test_it_is_proved_with_what_the_controller_must_do_and_the_second_checker_asks_for_it() -> None:
    layout, table = made(CLEAR)
    system = System(layout, lower(layout, table))
    result = prove(system, Limits(search_s=0))
    assert {c.verdict for c in result.claims} == {Verdict.PROVED} and not result.dropped
    assert agree(*told(CLEAR), specification.shipped()).left == ()
    others = [("kind: shunt}, reason", "kind: main}, reason"), ("clear: T2", "clear: e1")]
    for less in (BARE, *(CLEAR.replace(*x) for x in others)):
        with pytest.raises(Rejected, match="S-DEMANDED"):
            agree(loaded(CLEAR), *told(less)[1:], specification.shipped())


@pytest.mark.parametrize(
    ("demand", "code"),
    [
        ("clear: T3, point: 1, lies: normal", "IL3034"),
        ("point: 1", "IL3034"),
        ("lies: normal", "IL3034"),
        ("clear: nowhere", "IL2004"),
    ],
)
def test_a_demand_is_of_a_point_as_it_lies_or_of_a_section(demand: str, code: str) -> None:
    sink = Sink()
    text = BARE + f"demand:\n  - {{{demand}, routes: {{from: A}}, reason: none}}\n"
    assert load_text("clear.yaml", text, sink)[0] is None
    assert [d.code for d in sink.diagnostics] == [code]


@pytest.mark.parametrize(("section", "why"), [("T1", "on the way"), ("k1", "on the way"), ("w1", "stands there")])
def test_what_cannot_be_clear_while_a_route_is_open_cannot_be_demanded_of_it(section: str, why: str) -> None:
    sink = Sink()
    text = BARE + f"demand:\n  - {{clear: {section}, routes: {{from: A, to: N1, kind: shunt}}, reason: none}}\n"
    layout, _ = load_text("clear.yaml", text, sink)
    assert layout is not None
    derive(layout, sink)
    (found,) = [d for d in sink.diagnostics if d.severity == "error"]
    assert found.code == "IL4019" and why in found.message


@pytest.mark.parametrize(("lies", "codes"), [("reverse", ["IL4011"]), ("normal", [])])
def test_a_hand_worked_point_that_no_way_passes_is_demanded_in_normal_alone(lies: str, codes: list[str]) -> None:
    """Its key locks it there; reversed nothing holds it, and a route that demands it so would never be set."""
    sink = Sink()
    text = BARE.replace("reverse: yard.start}", "reverse: yard.start, work: hand}")
    text = "".join(x for x in text.splitlines(keepends=True) if not x.startswith("  D: "))
    text += f"demand:\n  - {{point: 3, lies: {lies}, routes: {{from: A, to: N2}}, reason: none}}\n"
    layout, _ = load_text("by_hand.yaml", text, sink)
    assert layout is not None
    derive(layout, sink)
    assert list(dict.fromkeys(d.code for d in sink.diagnostics if d.severity == "error")) == codes
    assert all("worked by hand" in d.message for d in sink.diagnostics if d.severity == "error")


# --- adding can only restrict ----------------------------------------------------------------------


def more_than(one: Controller, other: Controller) -> list[str]:
    """What the one does in some scan that the other does not, from the same state with the same inputs: it grants a
    route, lets a machine move, opens a signal, locks a section, or gives one back."""
    cnf, asked = Cnf(), {}
    nothing = conj(neg(other.expanded[f"G_R{r.number}"]) for r in other.symbols.routes)  # a grant locks again
    still = conj(neg(other.next_state[x]) for x in other.symbols.overlaps.swings.values())  # a swing closes its signals
    for r in one.symbols.routes:
        grant = f"G_R{r.number}"
        asked[grant] = conj((one.expanded[grant], neg(other.expanded[grant])))
        asked[r.proceed] = conj((still, one.next_state[r.proceed], neg(other.next_state[r.proceed])))
    for m in dict.fromkeys(m for m, _ in one.symbols.machines.command):
        moves = f"MOV_{portable(m)}"
        asked[moves] = conj((one.expanded[moves], neg(other.expanded[moves])))
    for name in one.symbols.sections.lock.values():
        asked[f"{name} taken"] = conj((one.next_state[name], neg(other.next_state[name])))
        kept = conj((other.next_state[name], neg(one.next_state[name])))
        asked[f"{name} released"] = conj((var(name), nothing, kept))
    literals = {name: cnf.literal(x) for name, x in asked.items()}
    sat = solver("minisat", cnf, 0)
    return [name for name, x in literals.items() if sat.ask(x) is not Answer.UNSAT]


def test_the_shipped_example_restricts_and_the_other_way_round_is_seen() -> None:
    plain, more = (lower(*made(text)) for text in (PLAIN, TEXT))
    assert more_than(more, plain) == []
    number = {r.id: r.number for r in more.symbols.routes}
    kept_back = {f"G_R{number[RouteId(r)]}" for r in ("A-A2", "E1-E2", "A2-N1", "E2-S2", "S1-W")}
    found = set(more_than(plain, more))
    assert kept_back | {"MOV_3"} <= found, "what holds the point keeps back all routes that need it otherwise, too"
    assert f"G_R{number[RouteId('S2-W')]}" not in found


def test_what_is_added_to_call_on_routes_alone_restricts_them_and_no_train_route() -> None:
    plain, more = (lower(*made(text)) for text in (CALLED[: CALLED.index("hostile:")], CALLED))
    assert more_than(more, plain) == []
    found = more_than(plain, more)
    kept_back = {r.id for r in more.symbols.routes if f"G_R{r.number}" in found}
    assert {"A-N1.c", "A-N2.c", "N1-E"} <= kept_back and not {"A-N1", "A-N2"} & kept_back


def test_a_section_demanded_clear_restricts_its_routes_and_no_others() -> None:
    plain, more = (lower(*made(text)) for text in (BARE, CLEAR))
    assert more_than(more, plain) == []
    proceed = {r.proceed: r.id for r in more.symbols.routes}
    assert {proceed.get(x, x) for x in more_than(plain, more)} == {"A-N1.s", "A-N2.c"}


def with_additions(seed: int) -> tuple[str, str] | None:
    """A layout that grew at random, and the same with additions chosen at random."""
    rng, text = random.Random(seed), grow(seed)
    found = grown(text)
    if found is None or found[2].has_errors or len(found[1].routes) < 4:
        return None
    hostile, demand = hostile_and_demand(rng, found[0], found[1])
    added = ["hostile:", *hostile, *(["demand:", *demand] if demand else [])]
    return text, text + "\n".join(added) + "\n"


def test_on_layouts_that_grow_at_random_an_addition_only_restricts() -> None:
    compared = 0
    for seed in range(40):
        texts = with_additions(seed)
        found = grown(texts[1]) if texts else None
        if texts is None or found is None or found[2].has_errors:
            continue
        layout, table, _ = found
        assert audit(layout, table) == (), seed
        before = grown(texts[0])
        assert before is not None
        assert more_than(lower(layout, table), lower(before[0], before[1])) == [], seed
        if not compared:
            result = prove(System(layout, lower(layout, table)), Limits(search_s=0))
            assert {c.verdict for c in result.claims} == {Verdict.PROVED} and not result.dropped, seed
            assert agree(*told(texts[1]), specification.shipped()).left == (), seed
        compared += 1
    assert compared > 2


def test_of_two_doors_of_an_air_lock_only_one_is_open() -> None:
    layout, table, controller = built("../tests/layouts_for_tests/air_lock")
    assert audit(layout, table) == ()
    assert set(table.route["X1-X2"].locking.hostile.routes) == {"X2-E", "Y1-Y2", "Y2-W"}
    result = prove(System(layout, controller), Limits(search_s=0))
    assert result.proved and not result.dropped
    assert (
        agree(*told(Path("tests/layouts_for_tests/air_lock.yaml").read_text("utf-8")), specification.shipped()).left
        == ()
    )
    assert availability(closed_loop(layout, controller), table).shown


def test_by_hand_both_doors_open_since_they_are_tied_through_routes_alone() -> None:
    """What R13 and the page of the language say of them."""
    _, _, controller = built("../tests/layouts_for_tests/air_lock")
    machine = Machine(controller)
    well = {"VALID": 1, **{i.name: 1 for i in controller.inputs if i.name.startswith("CLR_")}}
    shut = {"DN_D1": 1, "DN_D2": 1}
    for _ in range(700):
        machine.scan({**well, **shut}, 1000)
    machine.scan({**well, **shut, "RELALL": 1}, 1000)
    outputs = machine.scan({**well, "DR_D1": 1, "DN_D2": 1, "MR_D1": 1, "MR_D2": 1}, 1000)
    assert outputs["YR_D1"] and outputs["YR_D2"]


def test_a_door_that_could_always_be_opened_to_trains_is_driven_both_ways(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("interlock.logic.lower.added.demanded", lambda d: set())
    layout, table, _ = built("../tests/layouts_for_tests/air_lock")
    result = prove(System(layout, lower(layout, table)), Limits(search_s=0))
    assert {c.id for c in result.claims if c.open} >= {"P-DRIVEN"}


# --- towards a boundary ---------------------------------------------------------------------------

BEFORE = """interlock: 1
name: before
profile: mine
boundaries: {W: {approach: wa 600}}
buffers: [B, C]
tracks:
  m: [W, s2 200]
  n: [s8 200, B]
points:
  1: {section: s4, toe: m.end, normal: n.start, reverse: C}
signals:
  X: {from: W, into: s2}
  Y: {from: s2, into: s4, kind: combined}
  G: {from: s8, into: s4, kind: combined}
"""
"""From G trains leave at W, and shunting movements end before it in s2."""


@pytest.mark.parametrize(
    ("more", "left"),
    [
        ("exclude:\n  - {from: G, to: W, reason: not wanted}\n", set()),
        ("exclude:\n  - {from: G, to: W, kind: main, reason: not wanted}\n", {"G-s2.s"}),
        ("demand:\n  - {point: 1, lies: normal, routes: {from: G, to: W}, reason: a stub}\n", {"G-W", "G-s2.s"}),
    ],
)
def test_to_a_boundary_leads_what_ends_before_it_too_for_all_that_read_the_layout(more: str, left: set[str]) -> None:
    """The claims said so, and the derivation did not: a layout that excludes such a route could not be proved."""
    layout, table = made(BEFORE + more)
    assert {r.id for r in table.routes if r.entry == "G"} == left and audit(layout, table) == ()
    result = prove(System(layout, lower(layout, table)), Limits(search_s=0))
    assert {c.verdict for c in result.claims} == {Verdict.PROVED}
    assert agree(*told(BEFORE + more), specification.shipped()).left == ()


PAST = Path("tests/layouts_for_tests/identifier.yaml").read_text("utf-8")


def test_what_is_hostile_to_a_part_is_hostile_to_the_route_that_is_set_with_it() -> None:
    """X-Y-Z sets what lies past Y, and is refused with it: the table has to say so."""
    _, table = made(PAST + "hostile: [{one: {from: Y, to: Z}, other: {from: Q, to: E}, reason: test}]\n")
    route = {r.id: r for r in table.routes}
    assert (
        "Q-E" in route[RouteId("X-Y-Z")].locking.hostile.routes
        and "X-Y-Z" in route[RouteId("Q-E")].locking.hostile.routes
    )
    assert "Q-E" not in route[RouteId("X-Y")].locking.hostile.routes


def test_a_section_that_a_part_is_to_find_clear_keeps_apart_the_route_that_is_set_with_it() -> None:
    layout, table = made(PAST + "demand: [{clear: e1, routes: {from: Y, to: Z}, reason: test}]\n")
    found = availability(closed_loop(layout, lower(layout, table)), table)
    pairs = {frozenset((p.first, p.second)): p for p in found.pairs}
    assert found.shown, [(p.first, p.second, p.failure) for p in found.pairs if p.failure]
    assert pairs[frozenset(("X-Y-Z", "Q-E"))].manner == pairs[frozenset(("Y-Z", "Q-E"))].manner == Manner.CLEAR


def test_a_section_without_detection_cannot_be_demanded_clear() -> None:
    """Nobody is told whether vehicles stand in it."""
    text = """interlock: 1
name: siding
boundaries: {W: {approach: wa 600, trains: in}, E: {trains: out}}
tracks: {line: [W, a 200, b 200], out: [c 200, E], side: [s 100, B]}
buffers: [B]
points:
  P: {section: p, toe: line.end, normal: out.start, reverse: side.start}
signals:
  X: {from: W, into: a}
  Y: {from: b, into: p, kind: combined}
  L: {from: s, into: p, kind: shunt}
sections: {s: {detected: no}}
demand: [{clear: s, routes: {from: Y, to: E, kind: main}, reason: sand}]
"""
    found = grown(text)
    assert found is not None
    said = [d.message for d in found[2].diagnostics if d.code == "IL4019"]
    assert said == ["s cannot be demanded clear of Y-E: it has no detection"]
