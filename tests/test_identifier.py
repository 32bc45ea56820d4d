"""Signals that a longer route passes while they show an identifier light (German Kennlicht)."""

from __future__ import annotations

import types
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from interlock.audit import audit
from interlock.checker import specification
from interlock.checker.check import agree
from interlock.checker.reading import loaded
from interlock.derivation import derive
from interlock.diag import Sink
from interlock.emit.drawing.svg import plan_svg
from interlock.emit.io import equipment_csv
from interlock.emit.python.runtime import runtime_py
from interlock.frontend import load_text
from interlock.logic.cabinet import allocate
from interlock.logic.lower import lower
from interlock.model.elements import Position, RouteId
from interlock.proof.engines.limits import Limits
from interlock.proof.mutation.movements import run_mutants
from interlock.proof.system.loop import closed_loop
from interlock.proof.witnesses.availability import availability
from interlock.simulate.run import simulate
from interlock.simulate.world import World
from interlock.table.columns import COLUMNS
from interlock.table.national import national_sheets
from interlock.verify import Rejected
from tests.campaigns.simulate import Case
from tests.scenarios import Scenario, run_to
from tests.test_stations import proved, said
from tests.written import told

PATH = Path("tests/layouts_for_tests/identifier.yaml")
TEXT = PATH.read_text("utf-8")
BOTH = Path("tests/layouts_for_tests/identifiers.yaml")
TWO = BOTH.read_text("utf-8")
"""Two signals in a row, Y and Z, before W."""


def routes(text: str) -> dict[str, str | None]:
    """The routes of a text, each with what it locks past the signal at its end."""
    return {str(r.id): r.path.onward for r in said(text)[1].routes}


def without(line: str) -> str:
    """The layout without some routes."""
    return f"{TEXT}exclude:\n  - {{{line}, reason: not wanted}}\n"


# --- which routes there are -----------------------------------------------------------------------


def test_trains_stop_at_the_signal_or_run_past_it() -> None:
    layout, table, codes = said(TEXT)
    assert codes == set() and proved(layout, table)
    assert {r.id: r.path.onward for r in table.routes if r.entry in ("X", "Y")} == {
        "X-Q": None,
        "X-Y": None,
        "X-Y-Z": "Y-Z.i",
        "Y-Z": None,
        "Y-Z.i": None,
    }
    long, beyond = table.route[RouteId("X-Y-Z")], table.route[RouteId("Y-Z.i")]
    assert long.locking.overlap is not None and long.locking.overlap.ways == beyond.path.traversals, (
        "the overlap of Y lies on its way"
    )
    assert long.signal.aspect.next == "Z" and beyond.kind == "identifier" and beyond.signal.closing.whole is None
    assert set(long.locking.hostile.routes) == {"X-Q", "X-Y", "Y-Z"} and long.path.length == 340
    assert [c.text(long) for c in COLUMNS if c.key == "exit"] == ["Z past Y"]


def test_the_approach_of_the_next_signal_goes_back_past_the_light() -> None:
    """Whoever has seen X clear because Z is open learns nothing at Y (R8)."""
    for text, sections in ((TEXT, {"p2", "p1", "T1", "w1"}), (TEXT.replace(", identifier: yes", ""), {"p2", "p1"})):
        _, table, _ = said(text)
        assert set(table.route[RouteId("Z-E")].locking.approach.sections) == sections


def test_a_route_may_end_there_or_run_past_or_both() -> None:
    every = set(routes(TEXT))
    assert every - set(routes(without("from: X, to: Y"))) == {"X-Y"}
    assert every - set(routes(without("from: X, to: Q"))) == {"X-Q"}
    nothing = "exclude:\n  - {from: X, to: Z, reason: not wanted}\n"
    sink = Sink()
    layout, _ = load_text("none.yaml", TEXT + nothing, sink)
    assert layout is not None
    left = {str(r.id) for r in derive(layout, sink).routes}
    assert every - left == {"X-Y-Z", "Y-Z.i"} and {d.code for d in sink.diagnostics} == {"IL4013"}
    named = f"{TEXT}routes:\n  long: {{from: X, to: Z}}\n  short: {{from: X, to: Y}}\nautomatic: [{{from: X, to: Z}}]\n"
    _, table, _ = said(named)
    assert {n: r.id for r in table.routes for n in r.names} == {"long": "X-Y-Z", "short": "X-Y"}
    assert table.automatic == ("X-Y-Z",)


# --- what stands against it -----------------------------------------------------------------------


def test_the_audit_misses_the_way_beyond() -> None:
    layout, table, _ = said(TEXT)
    row = table.route[RouteId("X-Y-Z")]
    for wrong in (
        replace(row, path=replace(row.path, onward=None)),
        replace(row, signal=replace(row.signal, aspect=table.route[RouteId("X-Y")].signal.aspect)),
    ):
        found = audit(layout, replace(table, routes=tuple(wrong if r is row else r for r in table.routes)))
        assert found, wrong


def test_the_second_checker_agrees_and_takes_no_light_that_the_layout_does_not_give() -> None:
    assert agree(*told(TEXT), specification.shipped()).left == ()
    _, system, text = told(TEXT)
    with pytest.raises(Rejected):
        agree(loaded(TEXT.replace(", identifier: yes", "")), system, text, specification.shipped())


OTHERWISE = {
    "of two aspects, in a mine": ("profile: de", "profile: mine"),
    "closing behind the whole movement, by turns": ("lamp_proof: yes", "main_closes: whole-movement, flank_space: yes"),
    "where trains are called on": ("identifier: yes", "identifier: yes, call_on: yes"),
    "at slow sections, to an overlap for a speed": (
        "signals:",
        "sections: {p2: {speed: 30}}\nsignals:",
        "  Z: {length: 0}",
        "  Z: {length: 30, entry_speed: 25}",
    ),
    "with points and hostile routes that the author adds": (
        "overlaps:",
        "demand:\n  - {point: 2, lies: normal, routes: {from: Y, to: Z}, reason: wagons}\n"
        "hostile:\n  - {one: {from: Y, to: Z}, other: {from: X, to: Q}, reason: narrow}\noverlaps:",
    ),
    "past a gate, into a zone": (
        "overlaps:",
        "level_crossings: {LC: {over: [p2]}}\nconditions: {C: {over: [p2]}}\n"
        "zones: {N: {sections: [p1, p2], trains: 1}}\noverlaps:",
    ),
}


@pytest.mark.parametrize("which", OTHERWISE)
def test_it_is_proved_beside_other_words(which: str) -> None:
    text = TEXT
    for before, after in zip(OTHERWISE[which][::2], OTHERWISE[which][1::2], strict=True):
        assert before in text
        text = text.replace(before, after)
    layout, table, _ = said(text)
    assert proved(layout, table) and agree(*told(text), specification.shipped()).left == ()


def test_every_two_routes_can_be_used_together() -> None:
    layout, table, _ = said(TEXT)
    result = availability(closed_loop(layout, lower(layout, table)), table)
    assert {r.failure for r in result.pairs} == {None} and len(result.pairs) == 16


# --- what the controller does ---------------------------------------------------------------------


class Desk:
    """The emitted runtime with an operator; all sections clear, all points lie normal."""

    def __init__(self, text: str = TEXT, signals: str = "XY") -> None:
        layout, table, _ = said(text)
        self.lamps = {f"{lamp}_{g}" for lamp in ("YP", "YY", "YS", "YI") for g in signals}
        controller = lower(layout, table)
        module = types.ModuleType("runtime")
        exec(compile(runtime_py(controller, []), "runtime.py", "exec"), module.__dict__)
        self.one: Any = module.__dict__["Controller"]()
        sym = controller.symbols
        lying = [name for (_, x), name in sym.machines.detected.items() if x is Position.NORMAL]
        lamps = [
            n
            for those in (
                sym.lamp_proof.stop,
                sym.lamp_proof.clear,
                sym.lamp_proof.caution,
                sym.lamp_proof.identifier,
            )
            for n in those.values()
        ]
        self.reads: dict[str, int] = dict.fromkeys([sym.valid, *sym.sections.clear.values(), *lying, *lamps], 1)
        self.reads |= dict.fromkeys(sym.sections.blocked.values(), 0)
        for _ in range(4000):
            self.scan(RELALL=1)
            self.scan()

    def scan(self, **inputs: int) -> set[str]:
        """One scan; the lamps of these signals that are lit."""
        shown: Mapping[str, int] = self.one.scan({**self.reads, **inputs}, 100)
        return {n for n in self.lamps if shown.get(n)}

    def ask(self, route: str) -> set[str]:
        """A route is asked for."""
        self.scan(**self.one.request(route))
        return [self.scan() for _ in range(4)][-1]

    def held(self, section: str = "p2") -> bool:
        """What lies past Y is locked."""
        return any(self.one.state[n] for n in self.one.state if n.startswith(f"L_{section}_"))

    def occupied(self, *sections: str) -> set[str]:
        """These sections read occupied, and no others."""
        self.reads |= {n: int(n.removeprefix("CLR_") not in sections) for n in self.reads if n.startswith("CLR_")}
        return [self.scan() for _ in range(50)][-1]


def test_the_light_is_lit_exactly_for_the_route_past_the_signal() -> None:
    desk = Desk()
    desk.occupied("w1")
    assert desk.ask("X-Y") == {"YY_X", "YS_Y"}
    desk.scan(CAN_X=1)
    assert [desk.scan() for _ in range(2000)][-1] == {"YS_X", "YS_Y"}
    assert desk.ask("X-Y-Z") == {"YY_X", "YI_Y"}
    assert desk.ask("Y-Z") == {"YY_X", "YI_Y"}, "Y opens for no route of its own meanwhile"
    assert desk.ask("Y-Z.i") == {"YY_X", "YI_Y"} and desk.one.status("Y-Z")[0] > 10000
    assert desk.occupied("w1", "T1") == {"YS_X", "YI_Y"}, "it stays for the train that has passed X"
    assert desk.occupied("p1") == {"YS_X", "YI_Y"}
    assert desk.occupied("p1", "p2") == {"YS_X", "YS_Y"}, "the first axle puts it out"
    assert desk.occupied("p2") == {"YS_X", "YS_Y"}


def test_with_its_lamp_out_neither_signal_opens() -> None:
    desk = Desk()
    desk.occupied("w1")
    desk.reads["NL_Y"] = 0
    assert desk.ask("X-Y-Z") == {"YS_X", "YS_Y"}
    desk.reads["NL_Y"] = 1
    assert desk.scan() == {"YS_X", "YI_Y"} or desk.scan() == {"YY_X", "YI_Y"}
    desk.reads["NL_Y"] = 0
    assert desk.scan() == {"YS_X", "YS_Y"}, "it goes out: both fall to stop"


def test_a_route_that_is_asked_for_alone_is_never_what_lies_beyond() -> None:
    desk = Desk()
    desk.occupied("p1")
    assert desk.ask("Y-Z.i") == {"YS_X", "YS_Y"} and "never alone" in desk.one.status("Y-Z.i")[1]


def test_when_the_route_is_taken_back_both_signals_fall_to_stop_in_the_same_scan() -> None:
    desk = Desk()
    desk.occupied("w1")
    desk.ask("X-Y-Z")
    assert desk.scan(CAN_X=1) == {"YS_X", "YS_Y"}
    assert desk.held(), "what lies beyond is held until the delay is over"


def test_between_the_two_signals_a_lost_condition_leaves_stop_until_a_new_route_is_set() -> None:
    desk = Desk()
    desk.occupied("w1")
    desk.ask("X-Y-Z")
    desk.occupied("w1", "T1")
    assert desk.occupied("T1", "p1") == {"YS_X", "YI_Y"}
    assert desk.occupied("p1", "e1") == {"YS_X", "YI_Y"}
    desk.reads["VALID"] = 0
    assert desk.scan() == {"YS_X", "YS_Y"}
    desk.reads["VALID"] = 1
    assert desk.occupied("p1") == {"YS_X", "YS_Y"} and desk.ask("X-Y-Z") == {"YS_X", "YS_Y"}
    assert desk.held(), "it stays locked for a train that may not have stopped"
    desk.scan(CAN_Y=1)
    assert desk.scan() == {"YS_X", "YS_Y"} and desk.held()
    for _ in range(1900):
        desk.scan()
    assert not desk.held(), "given back after the delay of approach locking"
    assert desk.ask("Y-Z") == {"YS_X", "YY_Y"}


def test_in_the_world_of_the_proof_a_driver_passes_the_light() -> None:
    """And X, by which he came, is at stop behind him."""
    passes = Scenario(
        "A driver takes the light for himself.", f"../{PATH.with_suffix('')}", ("accept.Y", "YI_Y", "YS_X")
    )
    assert run_to(passes) is not None


# --- past several signals, one after the other -----------------------------------------------------


def variant(*words: str) -> str:
    """The layout of two such signals in a row, otherwise."""
    text = TWO
    for before, after in zip(words[::2], words[1::2], strict=True):
        assert before in text
        text = text.replace(before, after)
    return text


def excluding(start: str, end: str) -> str:
    return f"{TWO}exclude:\n  - {{from: {start}, to: {end}, reason: not wanted}}\n"


def test_a_train_may_stop_at_either_signal_or_run_past_both() -> None:
    layout, table, codes = said(TWO)
    assert codes == set()
    assert {r.id: r.path.onward for r in table.routes if r.path.onward or r.kind == "identifier"} == {
        "X-Y-Z": "Y-Z.i",
        "X-Y-Z-W": "Y-Z-W.i",
        "Y-Z-W": "Z-W.i",
        "Y-Z-W.i": "Z-W.i",
        "Y-Z.i": None,
        "Z-W.i": None,
    }
    long = table.route[RouteId("X-Y-Z-W")]
    assert (long.path.passed, long.path.destination, long.signal.aspect.next, long.path.length) == (
        ("Y", "Z"),
        "W",
        "W",
        400,
    )
    assert {*long.locking.hostile.routes} == {"X-Q", "X-Y", "X-Y-Z", "Y-Z", "Y-Z-W", "Y-Z.i", "Z-W"}
    assert [c.text(long) for c in COLUMNS if c.key == "exit"] == ["W past Y, Z"]
    result = availability(closed_loop(layout, lower(layout, table)), table)
    assert {r.failure for r in result.pairs} == {None} and len(result.pairs) == 31


IN_A_ROW = {
    "two": (),
    "three, the last with no overlap": (
        *("p3 120]", "p3 60, p4 60]", "  W: {from: p3, into: T2}", "  V: {from: p3, into: p4, identifier: yes}"),
        *(
            "overlaps:",
            "  W: {from: p4, into: T2}\noverlaps:",
            "  W: {length: 0}",
            "  V: {length: 0}\n  W: {length: 0}",
        ),
    ),
    "to the line": ("  W: {from: p3, into: T2}", "  W: {from: p3, into: T2, identifier: yes}"),
    "caution over turnouts, by turns": ("lamp_proof: yes", "caution: turnout, main_closes: whole-movement"),
    "at slow sections, to an overlap for a speed": (
        *("signals:", "sections: {p2: {speed: 30}, p3: {speed: 20}}\nsignals:"),
        *("  W: {length: 0}", "  W: {length: 30, entry_speed: 15}"),
    ),
}


@pytest.mark.parametrize("which", IN_A_ROW)
def test_past_several_signals_all_is_proved(which: str) -> None:
    text = variant(*IN_A_ROW[which])
    layout, table, _ = said(text)
    assert any(len(r.path.passed or ()) > 1 for r in table.routes)
    assert proved(layout, table) and agree(*told(text), specification.shipped()).left == ()


def test_each_length_of_such_a_route_is_excluded_by_its_own_ends() -> None:
    every = set(routes(TWO))
    assert every - set(routes(excluding("X", "W"))) == {"X-Y-Z-W", "Y-Z-W.i"}
    assert every - set(routes(excluding("X", "Z"))) == {"X-Y-Z", "Y-Z.i"}
    assert every - set(routes(excluding("Y", "Z"))) == {"Y-Z", "Y-Z.i", "X-Y-Z"}


@pytest.mark.parametrize("ends", ["XW", "XZ"])
def test_one_that_is_excluded_and_offered_all_the_same_is_found_out(ends: str) -> None:
    layout, table, _ = said(excluding(*ends))
    found = list(run_mutants(layout, table, 0, Limits(search_depth=0), only=("excluded-offered",)))
    assert found and all(o.claims == ("S-EXCLUDED",) for o in found)
    _, system, text = told(TWO)
    with pytest.raises(Rejected):
        agree(loaded(excluding(*ends)), system, text, specification.shipped())


@pytest.mark.parametrize("kind", ["identifier-not-shown", "identifier-unlocked", "identifier-nothing-beyond"])
def test_no_light_of_a_row_may_be_left_out(kind: str) -> None:
    layout, table, _ = said(TWO)
    found = list(run_mutants(layout, table, 0, Limits(search_depth=0), only=(kind,)))
    assert len(found) >= 3 and all(o.claims for o in found)


def test_the_audit_misses_what_lies_past_the_second_signal() -> None:
    layout, table, _ = said(TWO)
    for r in (x for x in table.routes if x.path.passed is not None and "Z" in x.path.passed):
        wrong = replace(r, path=replace(r.path, onward="Y-Z.i" if r.path.passed == ("Y", "Z") else None))
        assert audit(layout, replace(table, routes=tuple(wrong if x is r else x for x in table.routes))), r.id


def test_overlaps_of_two_signals_in_a_row_do_not_meet() -> None:
    sink = Sink()
    layout, _ = load_text("long.yaml", variant("  Y: {length: 50}", "  Y: {length: 200}"), sink)
    assert layout is not None
    derive(layout, sink)
    assert {d.code for d in sink.diagnostics} == {"IL4014", "IL4015"}


def test_the_lights_are_lit_from_the_last_and_fall_from_it() -> None:
    desk = Desk(TWO, "XYZ")
    desk.occupied("e1")
    assert desk.ask("X-Y-Z") == {"YY_X", "YI_Y", "YS_Z"}
    desk.scan(CAN_X=1)
    assert [desk.scan() for _ in range(2000)][-1] == {"YS_X", "YS_Y", "YS_Z"}
    assert desk.ask("X-Y-Z-W") == {"YY_X", "YI_Y", "YI_Z"}
    desk.reads["NL_Z"] = 0
    assert desk.scan() == {"YS_X", "YS_Y", "YS_Z"}, "with the lamp of the last one all fall"
    desk.reads["NL_Z"] = 1
    assert desk.ask("X-Y-Z-W") == {"YY_X", "YI_Y", "YI_Z"}, "asked for again, all are lit again"
    assert desk.occupied("e1", "T1") == {"YS_X", "YI_Y", "YI_Z"}
    assert desk.occupied("p1") == {"YS_X", "YI_Y", "YI_Z"}
    assert desk.occupied("p1", "p2") == {"YS_X", "YS_Y", "YI_Z"}, "each goes out with the first axle that passes it"
    assert desk.occupied("p2", "p3") == {"YS_X", "YS_Y", "YS_Z"}


@pytest.mark.parametrize("signal", "XY")
def test_a_cancellation_puts_out_all_lights_beyond_in_the_same_scan(signal: str) -> None:
    desk = Desk(TWO, "XYZ")
    desk.occupied("e1")
    desk.ask("X-Y-Z-W")
    if signal == "Y":
        desk.occupied("p1")
    assert desk.scan(**{f"CAN_{signal}": 1}) == {"YS_X", "YS_Y", "YS_Z"}
    assert [desk.scan() for _ in range(20)][-1] == {"YS_X", "YS_Y", "YS_Z"}
    assert desk.held("p2") and desk.held("p3"), "until the delays are over"
    for _ in range(4000):
        desk.scan()
    assert not desk.held("p2") and not desk.held("p3")


@pytest.mark.parametrize("profile", ["de", "cn", "uk", "generic"])
def test_every_form_names_all_signals_that_are_passed(profile: str) -> None:
    layout, table, _ = said(TWO.replace("profile: de", f"profile: {profile}"))
    cells = [str(c) for s in national_sheets(layout, table) for row in s.rows for c in row]
    past = {"de": "Y, Z", "cn": "越过Y、Z至W", "uk": "past Y, Z to W", "generic": "W past Y, Z"}[profile]
    assert any(past in c for c in cells)


# --- trains in metres, and what is printed --------------------------------------------------------


@pytest.mark.parametrize(("path", "hostile"), [(PATH, False), (PATH, True), (BOTH, True)])
def test_trains_pass_the_light_and_stop_at_stop(path: Path, hostile: bool) -> None:
    case, lit, astride, passed = Case.of(str(path)), [False] * 5, False, 0
    last = "YI_Y" if path is PATH else "YI_Z"
    joint = {"p1", "p2"} if path is PATH else {"p2", "p3"}

    def watch(world: World, shown: Mapping[str, int]) -> None:
        nonlocal astride, passed
        under = [{world.track.sections[s] for s in t.under.sections} for t in world.trains]
        before, astride = astride, any(joint <= x for x in under)
        passed += astride and not before and any(lit)
        lit[:] = [*lit[1:], bool(shown.get(last))]

    outcome = simulate(case.layout, case.runtime, scans=12000, seed=4, hostile=hostile, watch=watch, routes=case.routes)
    assert outcome.hazards == [] and outcome.passed_at_stop == []
    assert passed, "a train ran past it"


def test_plan_lists_and_german_form_tell_of_it() -> None:
    layout, table, _ = said(TEXT)
    controller = lower(layout, table)
    assert "YI_Y" in {o.name for o in controller.outputs}
    assert "identifier light,1" in equipment_csv(layout, allocate(layout, controller)).splitlines()
    assert plan_svg(layout).count('class="lamp identifier"') == 1
    sheet = next(s for s in national_sheets(layout, table) if s.key == "de_sslz")
    marks = [h.mark for h in sheet.headings]
    column = marks.index("AD")
    told_of = {row[0].text if hasattr(row[0], "text") else str(row[0]): str(row[column]) for row in sheet.rows}
    chinese = said(TEXT.replace("profile: de", "profile: cn"))
    form = next(s for s in national_sheets(*chinese[:2]) if s.key == "cn")
    past = [row for row in form.rows if "越过Y至Z" in map(str, row)]
    assert len(past) == 1 and "p2" in str(past[0]), "with what lies beyond, in one row"
    assert told_of["X/Z"] == "Y" and told_of["X/Y"] == "" and len(told_of) == 7


@pytest.mark.parametrize(
    ("chosen", "said"),
    [
        ("from: X, to: E", "from X routes lead to Q, Y, Z"),
        ("to: Z, from: Q", "from Q routes lead to E"),
        ("to: X, from: Y", "from Y routes lead to Z"),
        ("to: Z, via: [q1]", "lead over p2, or over T1, p1, p2"),
    ],
)
def test_an_exclusion_that_fits_nothing_is_told_where_routes_past_signals_lead(chosen: str, said: str) -> None:
    sink = Sink()
    text = TEXT + f"exclude:\n  - {{{chosen}, reason: none}}\n"
    layout, _ = load_text("identifier.yaml", text, sink)
    assert layout is not None
    derive(layout, sink)
    (found,) = [d for d in sink.diagnostics if d.code == "IL2012"]
    assert said in str(found.fix)
