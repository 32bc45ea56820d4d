"""What a route has locked by `demand` stays held so many seconds longer (`hold`): beyond the end of a route a train may
still be running when it is wholly in."""

from __future__ import annotations

import json
import re
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
from interlock.emit.tables.document import table_json
from interlock.emit.tables.railml import railml_json
from interlock.frontend import load_text
from interlock.logic.lower import lower
from interlock.proof.engines.limits import Limits
from interlock.proof.induction.verdict import Verdict
from interlock.proof.prover import prove
from interlock.proof.system.transition import System
from interlock.simulate.run import load
from interlock.table.columns import COLUMNS
from interlock.table.national import national_sheets
from interlock.table.rows import RouteLocking
from interlock.verify import Rejected
from tests.campaigns.simulate import Case
from tests.layouts import grown
from tests.test_added import made
from tests.test_coupled_derailer import SPUR
from tests.written import told

FILE = "tests/layouts_for_tests/held_longer.yaml"
TEXT = Path(FILE).read_text("utf-8")
AT_ONCE = TEXT.replace("hold: 30, ", "")
HOLD = "{point: 2, lies: normal, routes: {from: A}, hold: 30, reason: overrun}"
A, B, N, Y = 1, 2, 3, 4
"""The routes A-N, B-Y, N-E and Y-E, by number."""


class Line:
    """The emitted runtime with a point, which turns in a second; each scan half a second."""

    def __init__(self, file: str = FILE, point: int = 2) -> None:
        names = load(Case.of(file).runtime)
        self.controller: Any = names["Controller"]()
        self.inputs = {n: int(n.startswith(("CLR_", "VALID"))) for n in names["INPUTS"]}
        self.lies, self.point = "N", point
        self.run(700)

    def run(self, seconds: float, **inputs: int) -> None:
        """So many seconds with these inputs, which stay; a request lasts for one scan."""
        number = inputs.pop("REQ", 0)
        self.inputs |= inputs
        for _ in range(round(2 * seconds)):
            detected = {f"D{x}_{self.point}": int(x == self.lies) for x in "NR"}
            self.controller.scan(self.inputs | detected | {"REQ": number}, 500)
            number = 0
            turned = [x for x in "NR" if self.controller.state[f"C{x}_{self.point}"]]
            self.lies = turned[0] if turned else self.lies

    def until_in(self) -> None:
        """A train comes in from W, and is wholly in the last section; the lock that it leaves is gone a scan later."""
        self.run(5, RELALL=1)
        self.run(5, RELALL=0, REQ=A)
        assert self.controller.state["S_R1"]
        self.run(5, CLR_w0=0)
        self.run(5, CLR_w1=0)
        self.run(5, CLR_w0=1, CLR_k1=0)
        self.run(0.5, CLR_w1=1)
        for _ in range(20):
            self.run(0.5)
            if not self.controller.state["L_w1_1"]:
                return
        raise AssertionError("w1 is not released")

    def set(self, number: int) -> bool:
        """Whether a route is set when it is asked for."""
        self.run(1, REQ=number)
        return bool(self.controller.state[f"A_R{number}"])


def turned(number: int, after_s: float, hand: bool = False) -> bool:
    """Whether the point turns so many seconds after the train is wholly in, for a route or by hand."""
    line = Line()
    line.until_in()
    line.run(after_s)
    if hand:
        line.run(1, MR_2=1)
    elif not line.set(number):
        return False
    return line.lies == "R"


@pytest.mark.parametrize("hand", [False, True])
def test_a_point_beyond_the_end_does_not_move_while_the_train_may_be_running(hand: bool) -> None:
    assert not turned(Y, 1, hand) and not turned(Y, 28, hand)
    assert turned(Y, 31, hand)


def test_what_is_declared_hostile_to_the_route_is_kept_out_as_long() -> None:
    for after_s, free in ((1, False), (28, False), (31, True)):
        line = Line()
        line.until_in()
        line.run(after_s)
        assert line.set(N) is free


def test_lost_inputs_do_not_shorten_it_and_a_restart_forgets_it_as_it_does_the_rest() -> None:
    line = Line()
    line.until_in()
    line.run(10)
    line.run(5, VALID=0)
    line.run(13, VALID=1)
    assert not line.set(Y)
    line.run(3)
    assert line.set(Y)
    assert Line().controller.state["AH_R1"] is False


def test_it_counts_from_a_cancellation_too() -> None:
    line = Line()
    line.run(5, RELALL=1)
    line.run(5, RELALL=0, REQ=A)
    line.run(1, CAN_A=1)
    line.run(28, CAN_A=0)
    assert not line.controller.state["A_R1"] and line.controller.state["AH_R1"]
    line.run(3)
    assert not line.controller.state["AH_R1"]


def test_a_grant_of_the_same_route_meanwhile_begins_anew() -> None:
    line = Line()
    line.run(5, RELALL=1)
    line.run(5, RELALL=0, REQ=A)
    line.run(1, CAN_A=1)
    line.run(20, CAN_A=0)
    assert line.set(A)
    line.run(1, CAN_A=1)
    line.run(28, CAN_A=0)
    assert not line.controller.state["A_R1"] and line.controller.state["AH_R1"]


@pytest.mark.parametrize(("route", "lies"), [("Y-E", "points 2 cannot move"), ("N-E", "declared hostile (held 30 s")])
def test_the_runtime_tells_for_how_long_a_route_is_kept_out(route: str, lies: str) -> None:
    """The train is in: from then on it counts, to the scan in which nothing is in the way any more."""
    line = Line()
    line.run(5, RELALL=1)
    line.run(5, RELALL=0, REQ=A)
    assert lies in line.controller.why_not(route)[1] and line.controller.countdown_ms(route) is None
    line.until_in()
    line.run(0.5)
    left = []
    while lies in (line.controller.why_not(route) or ("", ""))[1]:
        left.append(line.controller.countdown_ms(route))
        line.run(0.5)
    assert left[:1] == [30_000] and left == [*range(30_000, -1, -500)], left
    assert line.controller.why_not(route) is None and line.controller.countdown_ms(route) is None


# --- what other routes lock meanwhile -------------------------------------------------------------

APART = Path("tests/layouts_for_tests/held_apart.yaml").read_text("utf-8")
THROUGH = (
    APART.replace("  N: {from: k1, into: e1}\n", "").replace("overlaps:\n  N: {length: 20}\n", "")
    + "automatic:\n  - {from: B, to: E, via: [T1, e1]}\n"
)
"""Nobody stops at N: routes lead out over the boundary, those from B by themselves."""
BEHIND_ALL = APART.replace("_kmh: 40", "_kmh: 40, main_closes: whole-movement").replace("{from: A}", "{from: N}")
"""What is held longer is held for those from N, which closes behind the whole movement."""


class Apart(Line):
    """Trains from W and from X, each over its own route over the same last sections."""

    def __init__(self, folder: Path, text: str) -> None:
        file = folder / "held_apart.yaml"
        file.write_text(text, "utf-8")
        self.joins = "N"
        super().__init__(str(file), 5)
        self.run(5, RELALL=1)
        self.run(5, RELALL=0)

    def run(self, seconds: float, **inputs: int) -> None:
        """So many seconds; the point at which the lines come together turns at once, too."""
        for i in range(round(2 * seconds)):
            state = self.controller.state
            self.joins = next((x for x in "NR" if state.get(f"C{x}_1")), self.joins)
            detected = {f"D{x}_1": int(x == self.joins) for x in "NR"}
            super().run(0.5, **(inputs if i == 0 else {}), **detected)

    def comes(self, side: str, route: int) -> None:
        """A train comes in from one side as far as k1."""
        self.run(4, REQ=route)
        assert self.controller.state[f"S_R{route}"]
        self.run(5, **{f"CLR_{side}0": 0})
        self.run(3, **{f"CLR_{side}1": 0})
        self.run(3, **{f"CLR_{side}0": 1, "CLR_T1": 0})
        self.run(3, **{f"CLR_{side}1": 1, "CLR_k1": 0})
        self.run(1, CLR_T1=1)

    def goes(self) -> None:
        """It leaves for E."""
        self.run(3, CLR_e1=0)
        self.run(3, CLR_k1=1)
        self.run(1, CLR_e1=1)

    def holds(self, *locks: str) -> bool:
        """Whether what was added to the first route is held, by these locks or after them."""
        state = self.controller.state
        return bool(state["AH_R1"]) and (not locks or any(state[x] for x in locks))

    def until_last(self, *locks: str) -> None:
        """Until the last of these locks is gone."""
        for _ in range(1000):
            if not self.holds(*locks):
                assert self.holds()
                return
            self.run(0.5)
        raise AssertionError(f"{locks} stay locked")


def lets_go(line: Apart, since_s: float, *locks: str) -> bool:
    """Whether the first route lets go within its 100 s, and no sooner, though others lock the same again meanwhile."""
    others = kept = 0
    for _ in range(round(2 * (98 - since_s))):
        assert line.holds()
        others += line.holds(*locks)
        line.run(0.5)
    for _ in range(10):
        kept += line.holds()
        line.run(0.5)
    assert others and any(line.controller.state[x] for x in locks)  # they still do
    return kept < 10


def test_an_automatic_route_over_the_same_last_section_does_not_begin_it_anew(tmp_path: Path) -> None:
    line = Apart(tmp_path, THROUGH)
    line.comes("w", 1)
    line.run(1, AUTO_R2=1)
    line.goes()
    line.until_last("A_R1", "L_e1_2")
    assert lets_go(line, 0, "L_e1_2") and line.controller.state["A_R2"]
    line.run(10, REQ=5)
    assert line.controller.state["A_R5"] and line.lies == "R"


def test_an_overlap_of_the_same_signal_does_not_begin_it_anew(tmp_path: Path) -> None:
    line = Apart(tmp_path, APART)
    line.comes("w", 1)
    line.until_last("A_R1", "L_T1_3", "V_N_1")
    line.run(3, REQ=3)
    line.goes()
    line.run(20)
    line.run(3, REQ=2)
    assert line.controller.state["A_R2"]
    assert lets_go(line, 33, "V_N_1")
    line.run(10, REQ=6)
    assert line.controller.state["A_R6"] and line.lies == "R"


@pytest.mark.parametrize("text", [APART, THROUGH])
def test_a_grant_of_the_same_route_begins_it_anew_whatever_others_did(tmp_path: Path, text: str) -> None:
    """After others locked the same, too: the train of the new grant has its own seconds."""
    line = Apart(tmp_path, text)
    line.run(4, REQ=1)
    line.run(1, CAN_A=1)
    line.run(10, CAN_A=0)
    line.run(4, REQ=2)
    assert line.controller.state["A_R2"] and line.controller.state["AHE_R1"]
    line.run(1, CAN_B=1)
    line.run(20, CAN_B=0)
    line.run(4, REQ=1)
    assert line.controller.state["A_R1"] and not line.controller.state["AHE_R1"]
    line.run(200)
    assert line.holds("A_R1")
    line.run(1, CAN_A=1)
    line.run(97, CAN_A=0)
    assert line.holds()
    line.run(5)
    assert not line.holds() and not line.controller.state["AHE_R1"]


@pytest.mark.parametrize("text", [APART, THROUGH, BEHIND_ALL])
def test_it_is_proved_where_others_lock_the_same(text: str) -> None:
    layout, table = made(text)
    result = prove(System(layout, lower(layout, table)), Limits(search_s=0))
    assert {c.verdict for c in result.claims} == {Verdict.PROVED} and not result.dropped
    assert agree(*told(text), specification.shipped()).left == ()


# --- table, proof, second checker -----------------------------------------------------------------


def test_it_stands_in_the_table_with_its_seconds_and_the_audit_looks_for_them() -> None:
    layout, table = made(TEXT)
    (route,) = [r for r in table.routes if r.locking.added]
    cell = next(c for c in COLUMNS if c.key == "flank_points").text(route)
    assert cell == "2 N (demanded: overrun; held 30 s longer)" and route.locking.hold == 30
    assert '"hold":30.0' in table_json(layout, table) and '"hold"' not in table_json(*made(AT_ONCE))
    short = tuple(replace(p, hold=29.0) for p in route.locking.points)
    rows = tuple(replace(r, locking=_with(r.locking, short)) if r is route else r for r in table.routes)
    assert [x.column for x in audit(layout, replace(table, routes=rows))] == ["points"]


@pytest.mark.parametrize("profile", ["generic", "uk", "de", "cn"])
def test_it_stands_in_every_national_form(profile: str) -> None:
    with_, without = (
        [s.rows for s in national_sheets(*made(text.replace("_kmh: 40", "_kmh: 40, overlap_m: 0"))) if s.of_routes]
        for text in (f"{x}profile: {profile}\n" for x in (TEXT, AT_ONCE))
    )
    assert with_ != without


@pytest.mark.parametrize("text", [TEXT, AT_ONCE])
def test_the_locking_table_has_a_column_for_it_where_the_layout_asks_for_it(text: str) -> None:
    table = made(text.replace("_kmh: 40", "_kmh: 40, overlap_m: 0") + "profile: de\n")
    (sheet,) = [s for s in national_sheets(*table) if s.key == "de_verschluss"]
    headings = [h.de for h in sheet.headings]
    told = {row[0]: row[headings.index(LONGER)] for row in sheet.rows} if LONGER in headings else {}
    assert {r: x for r, x in told.items() if x} == ({"A-N": "2 30 s"} if text is TEXT else {})
    assert bool(told) is (text is TEXT)


LONGER = "Länger verschlossen"


def relations(text: str) -> dict[str, dict[str, Any]]:
    """What each route requires, with the names of railML."""
    found = json.loads(railml_json(*made(text)))["routeRelations"]
    return {x["refersToRoute"]: x for x in found}


def test_the_names_of_railml_tell_the_seconds_of_what_is_held_and_of_nothing_else() -> None:
    asked = {"refersTo": "2", "inPosition": "normal"}
    assert relations(TEXT)["A-N"]["requiredSwitchPosition"] == [{**asked, "releaseDelay": 30}]
    assert relations(AT_ONCE)["A-N"]["requiredSwitchPosition"] == [asked]
    assert "releaseDelay" not in str([x for r, x in relations(TEXT).items() if r != "A-N"])


@pytest.mark.parametrize("part", ["additionalRelation", "requiredDerailerPosition"])
def test_the_names_of_railml_tell_them_of_doors_and_derailers(part: str) -> None:
    spur = SPUR + "demand:\n  - {point: 3, lies: normal, routes: {from: L}, hold: 12.5, reason: overrun}\n"
    text = longer("air_lock") if part == "additionalRelation" else spur
    told = [y for x in relations(text).values() for y in x[part]]
    assert {y["releaseDelay"] for y in told if "releaseDelay" in y} == {12.5}
    assert relations(text.replace("hold: 12.5, ", "")) == without_delay(relations(text))


def without_delay(told: Any) -> Any:
    """The same without seconds of release."""
    if isinstance(told, dict):
        return {k: without_delay(v) for k, v in told.items() if k != "releaseDelay"}
    return [without_delay(v) for v in told] if isinstance(told, list) else told


def test_the_names_of_railml_tell_for_how_long_declared_routes_stay_hostile() -> None:
    body = json.loads(railml_json(*made(TEXT)))
    number = {r["id"]: r["elementNumber"] for r in body["routes"]}
    told = {
        (c["refersToRoute"], n): c.get("releaseDelay")
        for c in body["conflictingRoutes"]
        for g in c["conflictsWithRoutes"]
        for n in body["routeGroups"][g]
    }
    assert {k: x for k, x in told.items() if x is not None} == {("A-N", number["N-E"]): 30}


def _with(locking: RouteLocking, points: Any) -> RouteLocking:
    return replace(locking, points=points)


def test_it_is_proved_and_the_second_checker_agrees() -> None:
    layout, table = made(TEXT)
    result = prove(System(layout, lower(layout, table)), Limits(search_s=0))
    assert {c.verdict for c in result.claims} == {Verdict.PROVED} and not result.dropped
    assert agree(*told(TEXT), specification.shipped()).left == ()


@pytest.mark.parametrize(
    ("controller", "why"),
    [
        (AT_ONCE, "there is no timer AHT_R1"),
        (TEXT.replace("hold: 30", "hold: 29.999"), "claim D-PRESET lacks"),
    ],
)
def test_a_controller_that_lets_go_sooner_is_refused_by_the_second_checker(controller: str, why: str) -> None:
    _, system, text = told(controller)
    with pytest.raises(Rejected, match=why):
        agree(loaded(TEXT), system, text, specification.shipped())


def test_a_time_that_nobody_asks_for_is_refused_by_the_second_checker() -> None:
    _, system, text = told(TEXT)
    with pytest.raises(Rejected, match=r"S-DECLARED|S-DEMANDED|D-PRESET"):
        agree(loaded(AT_ONCE), system, text, specification.shipped())


def test_the_longest_of_the_demands_of_a_route_counts() -> None:
    text = TEXT + "  - " + HOLD.replace("30", "45").replace("overrun", "a steep grade") + "\n"
    for layout_text in (text, TEXT.replace(f"  - {HOLD}\n", text[len(TEXT) :] + f"  - {HOLD}\n")):
        layout, table = made(layout_text)
        (route,) = [r for r in table.routes if r.locking.added]
        assert [p.hold for p in route.locking.added] == [45]
        assert {t.name: t.preset_ms for t in lower(layout, table).timers}["AHT_R1"] == 45_000
        assert agree(*told(layout_text), specification.shipped()).left == ()


@pytest.mark.parametrize("first", ["", "hold: 30, "])
def test_the_reasons_of_two_demands_of_one_machine_are_told_both(first: str) -> None:
    text = (
        TEXT.replace("hold: 30, ", first) + "  - " + HOLD.replace("30", "45").replace("overrun", "a steep grade") + "\n"
    )
    _, table = made(text)
    (demand,) = [p for r in table.routes for p in r.locking.added]
    assert demand.because.text == "demanded: overrun; a steep grade; held 45 s longer"
    _, same = made(text.replace("a steep grade", "overrun"))
    assert [p.because.text for r in same.routes for p in r.locking.added] == ["demanded: overrun; held 45 s longer"]


@pytest.mark.parametrize("second", ["hold: 20, ", "hold: 30, ", ""])
def test_the_reason_of_a_demand_that_holds_no_longer_is_told_too(second: str) -> None:
    """It was dropped; what is held, and for how long, is the same without it (IL4012)."""
    text = TEXT + "  - " + HOLD.replace("hold: 30, ", second).replace("overrun", "a steep grade") + "\n"
    _, table = made(text)
    (demand,) = [p for r in table.routes for p in r.locking.added]
    assert demand.hold == 30 and demand.because.text == "demanded: overrun; a steep grade; held 30 s longer"


@pytest.mark.parametrize(("second", "idle"), [(45, False), (30, True), (20, True)])
def test_a_second_demand_adds_something_where_it_holds_longer(second: int, idle: bool) -> None:
    found = grown(TEXT + "  - " + HOLD.replace("30", f"{second}").replace("overrun", "a steep grade") + "\n")
    assert found is not None and not found[2].has_errors
    assert any(d.code == "IL4012" for d in found[2].diagnostics) is idle


def test_zero_seconds_are_none() -> None:
    one, other = grown(TEXT.replace("hold: 30", "hold: 0")), grown(AT_ONCE)
    assert one is not None and other is not None and one[0].digest == other[0].digest
    assert lower(*one[:2]).steps == lower(*other[:2]).steps


# --- what cannot be -------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("hold", "code", "said"),
    [
        ("-1", "IL1014", "-1 s is no time to hold points (0 to 3600 s)"),
        ("3601", "IL1014", "3601 s is no time to hold points (0 to 3600 s)"),
        ("30 s", "IL1013", "'30 s' is not a number"),
        ("[30]", "IL1013", "a number is expected"),
    ],
)
def test_a_hold_is_a_number_of_seconds(hold: str, code: str, said: str) -> None:
    sink, text = Sink(), TEXT.replace("hold: 30", f"hold: {hold}")
    assert load_text("held_longer.yaml", text, sink)[0] is None
    (found,) = [d for d in sink.diagnostics if d.severity == "error"]
    assert (found.code, said in found.message) == (code, True), found
    with pytest.raises(Rejected):
        agree(loaded(text), *told(TEXT)[1:], specification.shipped())


def test_a_section_that_is_demanded_clear_is_not_held() -> None:
    sink, text = Sink(), TEXT.replace("point: 2, lies: normal", "clear: T2")
    assert load_text("held_longer.yaml", text, sink)[0] is None
    (found,) = [d for d in sink.diagnostics if d.severity == "error"]
    assert found.code == "IL3034" and "never held" in found.message
    with pytest.raises(Rejected, match="clear is held longer"):
        agree(loaded(text), *told(TEXT)[1:], specification.shipped())


def test_a_point_that_lies_so_anyway_cannot_be_held_longer() -> None:
    """On the path, as flank protection or in an overlap it goes with the sections that ask for it."""
    sink = Sink()
    layout, _ = load_text("held_longer.yaml", TEXT.replace("from: A}, hold", "from: N}, hold"), sink)
    assert layout is not None
    derive(layout, sink)
    (found,) = [d for d in sink.diagnostics if d.severity == "error"]
    assert found.code == "IL4011" and "2 N cannot be held 30 s longer for N-E" in found.message


# --- of other routes ------------------------------------------------------------------------------

OVERLAP = (
    TEXT.replace("_kmh: 40", "_kmh: 40, overlap_m: 20")
    .replace("side: [S, s1 300]", "side: [S, s1 300]\n  near: [u1 100]\n  stub: [v1 60, V]")
    .replace(
        "reverse: side.end}",
        "reverse: near.end}\n  3: {section: T3, toe: side.end, normal: near.start, reverse: stub.start}",
    )
    .replace("\ntracks:", "\nbuffers: [V]\ntracks:")
    .replace("into: T2}\nhostile", "into: T3}\nhostile")
    .replace("point: 2, lies: normal", "point: 3, lies: reverse")
)
"""The point 2 lies in the overlap beyond N; held longer is another one, which leads away whoever overruns Y."""


def longer(name: str) -> str:
    """A layout of the tests, all of whose demands of points are held longer."""
    text = Path(f"tests/layouts_for_tests/{name}.yaml").read_text("utf-8")
    return re.sub(r"(\{point: [^\n]*), reason", r"\1, hold: 12.5, reason", text)


@pytest.mark.parametrize(
    ("text", "routes"), [(longer("added"), 1), (longer("called_on"), 1), (longer("air_lock"), 4), (OVERLAP, 1)]
)
def test_it_is_proved_of_routes_to_a_boundary_of_call_on_routes_of_doors_and_with_an_overlap(
    text: str, routes: int
) -> None:
    layout, table = made(text)
    controller = lower(layout, table)
    assert sum(str(t.name).startswith("AHT_") for t in controller.timers) == routes
    result = prove(System(layout, controller), Limits(search_s=0))
    assert {c.verdict for c in result.claims} == {Verdict.PROVED} and not result.dropped
    assert agree(*told(text), specification.shipped()).left == ()
