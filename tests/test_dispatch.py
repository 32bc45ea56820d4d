"""Voyages carried out above the runtime: each route for the train that stands before it, and nothing else changed.

The runtime is the emitted one; a train here is the section in which it stands, moved on by hand where its signal shows
proceed.
"""

from __future__ import annotations

import types
from itertools import pairwise
from pathlib import Path

import pytest

from interlock.dispatch import Dispatcher
from interlock.dispatch.commands import errand
from interlock.dispatch.dispatcher import waiting
from interlock.dispatch.plan.errands import Place, Step
from interlock.dispatch.plan.explore import explore
from interlock.dispatch.plan.problem import build, in_the_way
from interlock.dispatch.plan.railway import Railway, straight
from interlock.emit.python.runtime import runtime_py
from interlock.logic.controller import Controller
from interlock.logic.lower import lower
from interlock.model.elements import SectionId
from interlock.model.layout import Layout
from interlock.proof.claims import Facts, claims
from interlock.proof.system.transition import System
from interlock.table.rows import InterlockingTable
from tests.layouts import built, grown

SCAN_MS = 200


class Panel:
    """A runtime among sections that are occupied by hand; machines arrive two scans after they are driven."""

    def __init__(self, layout: Layout, table: InterlockingTable, controller: Controller) -> None:
        module = types.ModuleType("runtime")
        exec(compile(runtime_py(controller, []), "runtime.py", "exec"), module.__dict__)
        self.scan = module.Controller().scan
        self.inputs: dict[str, int] = {n: restrictive for n, (restrictive, _) in module.INPUTS.items()}
        well = ("CLR_", "GL_", "RL_", "CL_", "E_", "SH_", "VALID", "DN_")
        self.inputs |= {n: int(n.startswith(well)) for n in self.inputs if not n.endswith("REQ")}
        self.dispatcher = Dispatcher(Railway(table, layout), controller.symbols)
        self.shown: dict[str, int] = {}
        self.read = dict(self.inputs)
        self.table, self.asked = table, []  # type: tuple[InterlockingTable, list[int]]
        self.sticks: dict[str, str] = {}
        """Machines that do not leave a position."""
        self.driven: dict[str, tuple[int, int]] = {}
        self.run(1, RELALL=0)
        while any(self.shown[n] for n in self.shown if n.startswith("YL_")):
            self.run(1, RELALL=1)

    def run(self, scans: int, **inputs: int) -> None:
        """So many scans."""
        for _ in range(scans):
            wanted = self.dispatcher.step({**self.read, **self.shown}, SCAN_MS)
            if wanted["REQ"] and wanted["REQ"] not in self.asked[-1:]:
                self.asked.append(wanted["REQ"])
            self.inputs |= wanted
            self.read = {**self.inputs, **inputs}
            self.shown = self.scan(self.read, SCAN_MS)
            for n, on in self.shown.items():
                if on and n.startswith(("YN_", "YR_")):
                    self._drive(n[3:], n[1])

    def _drive(self, machine: str, to: str) -> None:
        to = self.sticks.get(machine, to)
        before, left = self.driven.get(machine, ("", 0))
        left = left - 1 if before == to else 2
        self.driven[machine] = (to, left)  # type: ignore[assignment]
        for x in "NR":
            self.inputs[f"D{x}_{machine}"] = int(x == to and left <= 0)

    def stand(self, *sections: str) -> None:
        """Exactly these sections are occupied."""
        for n in self.inputs:
            if n.startswith("CLR_"):
                self.inputs[n] = int(n[4:] not in sections)

    def drive(self, *sections: str) -> None:
        """A train from the first of these to the last, never in more than two."""
        for a, b in pairwise(sections):
            for at in ((a, b), (b,)):
                self.stand(*at)
                self.run(20)

    def opened(self) -> set[str]:
        """The signals at proceed."""
        return {n.split("_", 1)[1] for n, v in self.shown.items() if v and n.startswith(("YP_", "YY_", "YW_", "YO_"))}

    def number(self, route: str) -> int:
        """Its number."""
        return next(r.number for r in self.table.routes if r.id == route)


def panel(name: str) -> Panel:
    return Panel(*built(name))


def test_each_route_of_a_voyage_is_opened_for_the_train_that_stands_before_it() -> None:
    p = panel("mine11")
    p.dispatcher.begin("in")
    p.run(20)
    assert p.asked == [], "no train is there yet"
    p.stand("ap_W")
    p.run(20)
    assert p.opened() == {"X7"} and p.asked == [p.number("X7-X1")]
    p.stand("ap_W", "q1")
    p.run(20)
    assert p.opened() == {"X1"}, "the train has passed X7 and comes before X1"
    p.drive("q1", "q2", "q4")
    assert p.opened() == {"X5"} and len(p.asked) == 3
    p.drive("q4", "q6", "q8", "q10", "q11", "ap_E", "")
    assert p.dispatcher.runs == [] and p.dispatcher.journal.said[-1] == "in is done"
    assert len(p.asked) == 3, "each route was asked for once"


def test_a_voyage_whose_route_is_taken_back_is_given_up() -> None:
    p = panel("mine11")
    p.dispatcher.begin("in")
    p.stand("ap_W")
    p.run(20)
    p.run(1, CAN_X7=1)
    p.run(1200)
    assert p.dispatcher.runs == [] and p.opened() == set() and len(p.asked) == 1


def test_a_route_that_is_refused_is_asked_for_again() -> None:
    p = panel("mine11")
    p.dispatcher.begin("in")
    p.stand("ap_W", "q1")
    p.run(100)
    assert p.opened() == set() and p.dispatcher.runs
    p.stand("ap_W")
    p.run(40)
    assert p.opened() == {"X7"}


def test_a_request_by_hand_comes_first_and_the_same_train_is_no_second_one() -> None:
    p = panel("mine11")
    p.stand("ap_W", "ap_E")
    p.dispatcher.begin("in")
    p.dispatcher.ask(p.number("X4-X6"))
    p.run(20)
    assert p.asked == [p.number("X4-X6"), p.number("X7-X1")]
    p.dispatcher.begin("in")  # for a train that is not there yet
    p.stand("ap_W", "q1")
    p.run(60)
    p.stand("q1", "q2")
    p.run(60)
    assert p.asked.count(p.number("X7-X1")) == 1
    p.stand("q4")
    p.run(60)
    p.stand("q4", "ap_W")
    p.run(60)
    assert p.asked.count(p.number("X7-X1")) == 2


def test_an_opposing_voyage_waits_outside_the_single_line() -> None:
    p = panel("fig2_1")
    p.dispatcher.begin("V1")
    p.dispatcher.begin("V2")
    p.stand("A", "H")
    p.run(20)
    p.stand("ap_I", "H")
    p.run(60)
    p.stand("ap_I", "A", "H")  # it passes the signal
    p.run(5)
    p.stand("A", "H")
    p.run(60)
    held = {n for n, v in p.shown.items() if v and n.startswith("YL_")}
    assert "SV" in p.opened() and "SE" not in p.opened() and "YL_E" not in held


def test_who_is_caught_by_a_train_without_a_command_is_named_and_goes_on_when_it_is_away() -> None:
    p = panel("mine11")
    p.stand("ap_W", "q4")
    p.run(20)
    p.dispatcher.begin("in")
    p.run(60)
    assert p.asked == [] and p.opened() == set()
    assert p.dispatcher.journal.said[-1] == "no plan exists: in cannot go on, with q4 in the way"
    assert waiting(p.dispatcher) == {"in": p.dispatcher.journal.said[-1]}
    p.stand("ap_W")
    p.run(60)
    assert p.opened() == {"X7"}


def test_a_point_that_fails_makes_another_plan() -> None:
    p = panel("mine11")
    p.inputs |= {"DN_P1": 0, "DR_P1": 1}
    p.run(1)
    p.run(2, TC_P1=1)  # it was turned by nobody's command, and somebody has looked at it
    p.sticks = {"P1": "-"}  # commanded normal it leaves reverse, and does not arrive
    order, _ = errand(p.dispatcher.railway, "7:W>E", 60.0)
    p.dispatcher.carry_out(order)
    p.stand("ap_W")
    p.run(20)
    p.drive("ap_W", "q1")
    p.run(500)
    taken_back = [x for x in p.dispatcher.journal.said if "is taken back, since P1 is not detected" in x]
    assert len(taken_back) == 1 and p.opened() == set()
    assert p.dispatcher.journal.said[-1] == "no plan exists: 7 cannot go on, with P1 in the way"
    p.sticks = {}
    p.run(400)
    assert p.opened() & {"X1"}


ROUND = (
    "w0 w1", "w0 w1 w2", "w1 w2 T", "w2 T a", "T a", "T a b", "a b", "b c", "b c T", "c T w2", "T w2 w1", "w1 w0",
)  # fmt: skip
"""The sections under a long train that goes round the turning loop."""


def test_the_tail_of_a_train_whose_length_nobody_knows_is_not_in_its_way() -> None:
    """At a panel commands tell no length: T, in which its tail was, was told to be in its way."""
    found = grown(Path("tests/layouts_for_tests/turning_loop.yaml").read_text("utf-8"))
    assert found is not None
    p = Panel(*found[:2], lower(*found[:2]))
    p.dispatcher.carry_out(errand(p.dispatcher.railway, "7:W>c>W", 0.0)[0])
    p.stand("w0")
    p.run(30)
    for under in ROUND:
        p.stand(*under.split())
        p.run(60)
        assert p.dispatcher.holding.obstacles == frozenset(), under
    p.stand()
    p.run(60)
    assert p.dispatcher.journal.said[-1] == "7 is done" and not any("no plan" in x for x in p.dispatcher.journal.said)


def test_a_stranger_behind_a_train_is_in_the_way_as_soon_as_there_is_a_gap() -> None:
    found = grown(Path("tests/layouts_for_tests/turning_loop.yaml").read_text("utf-8"))
    assert found is not None
    p = Panel(*found[:2], lower(*found[:2]))
    p.dispatcher.carry_out(errand(p.dispatcher.railway, "7:W>c>W", 0.0)[0])
    for under in ("w0", "w0 w1", "w1 w2", "w2 T a", "w0 a", "w0 a b"):
        p.stand(*under.split())
        p.run(60)
    assert p.dispatcher.holding.obstacles == {("section", "w0")}


def test_points_in_a_section_that_an_operator_blocks_are_known_to_stay() -> None:
    """X8-E has P2 reverse for flank protection; it was asked for, and refused, every five seconds."""
    found = grown(Path("tests/layouts_for_tests/swing_condition.yaml").read_text("utf-8"))
    assert found is not None
    p = Panel(*found[:2], lower(*found[:2]))
    p.dispatcher.carry_out(errand(p.dispatcher.railway, "7:q8/X8>E", 60.0)[0])
    p.stand("q8")
    p.run(100, BLK_q4=1)
    assert p.asked == []
    assert p.dispatcher.journal.said == ["no plan exists: 7 cannot go on, with P2, q4 in the way"]
    p.run(100)
    assert p.opened() == {"X8"}


def test_a_train_that_runs_out_is_not_in_the_way_of_plans() -> None:
    """Its head is beyond the boundary for longer than it takes to see a stranger, its tail still within."""
    p = panel("mine11")
    for command in ("7:W>E", "8:W>E"):
        p.dispatcher.carry_out(errand(p.dispatcher.railway, command, 60.0)[0])
    p.stand("ap_W")
    p.run(20)
    for way in (("ap_W", "q1"), ("q1", "q2", "q3"), ("q3", "q5", "q7", "q9", "q11")):
        p.drive(*way)
    p.stand("q11", "ap_E", "ap_W")
    p.run(100)
    assert not [x for x in p.dispatcher.journal.said if "no plan exists" in x], p.dispatcher.journal.said


def test_a_route_waits_for_the_direction_of_the_line_beyond_and_is_not_taken_back() -> None:
    p = panel("passing_loop")
    p.dispatcher.carry_out(errand(p.dispatcher.railway, "7:IG/S1>W", 60.0)[0])
    p.stand("IG")
    p.run(400, LC_W=1)
    assert p.dispatcher.journal.said == [] and p.opened() == set() and len(p.asked) == 1
    assert p.dispatcher.runs[0].reason == "S1-W is set; the direction of the line beyond is not here"
    p.run(400, LC_W=1, TKN_W=1)
    assert p.dispatcher.journal.said == ["7: S1-W is open"] and p.opened() == {"S1"}
    assert p.dispatcher.runs[0].reason == "" and len(p.asked) == 1


def driven_to_the_points(falsely: tuple[str, ...] = (), stays: str = "") -> Panel:
    """Train 7 on mine11 from W before P1, bound for E over any way.  falsely: sections reported occupied; stays: a
    position that P1 does not leave."""
    p = panel("mine11")
    p.sticks = {"P1": stays} if stays else {}
    p.dispatcher.carry_out(errand(p.dispatcher.railway, "7:W>E", 60.0)[0])
    for at in (("ap_W",), ("ap_W", "q1"), ("q1",)):
        p.stand(*at, *falsely)
        p.run(20)
    p.run(400)
    return p


OVER_Q4 = ["7: X7-X1 is open", "7: X1-X5 is open"]
OVER_Q3 = ["7: X7-X1 is open", "7: X1-X3 is open"]


@pytest.mark.parametrize(
    ("falsely", "stays", "said"),
    [
        ((), "", OVER_Q3),
        ((), "N", OVER_Q3),
        ((), "R", [*OVER_Q4[:1], "7: X1-X3 is taken back, since P1 is not detected", *OVER_Q4[1:]]),
        (("q4",), "", OVER_Q3),
        (("q3",), "", OVER_Q4),
        (("q2",), "", [*OVER_Q3[:1], "no plan exists: 7 cannot go on, with q2 in the way"]),
        (("q3", "q4"), "", [*OVER_Q3[:1], "no plan exists: 7 cannot go on, with q3, q4 in the way"]),
        (("q9",), "N", ["7: X7-X1 is open", "7: X1-X5 is taken back, since P1 is not detected",
                        "no plan exists: 7 cannot go on, with P1, q9 in the way"]),
    ],
)  # fmt: skip
def test_a_failed_point_or_a_lost_detection_makes_another_plan_or_says_who_is_caught(
    falsely: tuple[str, ...], stays: str, said: list[str]
) -> None:
    """What is told, word for word; where no plan is said to exist, every state was searched by something else."""
    p = driven_to_the_points(falsely, stays)
    assert p.dispatcher.journal.said == said
    assert p.opened() == ({"X1"} if said[-1].endswith("is open") else set())
    if said[-1].startswith("no plan"):
        run, things = p.dispatcher.runs[0], p.dispatcher.holding.obstacles
        built = build([run.journey.nodes(), in_the_way(things)])
        start = sum(x[key] for x, key in zip(built.bits, (run.place, "in the way"), strict=True))
        assert start in explore(built.problem, start).unsafe


def test_what_was_not_searched_to_its_end_is_unknown_and_nothing_is_asked() -> None:
    p = panel("mine11")
    p.dispatcher.holding.budget = 0
    p.dispatcher.carry_out(errand(p.dispatcher.railway, "7:W>E", 60.0)[0])
    p.stand("ap_W")
    p.run(60)
    assert p.dispatcher.journal.said == ["UNKNOWN: whether all trains can go on was not found out"] and p.asked == []
    assert p.dispatcher.runs[0].reason == "X7-X1: whether all could go on then was not found out"


def test_combined_shunt_routes_are_asked_for_from_the_far_end() -> None:
    p = panel("cn6502")
    row = next(v for v in p.table.voyages if v.name == "D1-IG")
    assert row.far_first and len(row.routes) > 1
    p.dispatcher.begin("D1-IG")
    rear = p.dispatcher.stages[row.routes[0]].shown.rear
    assert rear is not None
    p.stand(rear[4:])
    p.run(200)
    assert p.asked == [p.number(r) for r in reversed(row.routes)]


@pytest.mark.parametrize("name", ["mine11", "fig2_1", "cn6502"])
def test_voyages_change_neither_controller_nor_proof(name: str) -> None:
    text = Path(f"layouts/{name}.yaml").read_text(encoding="utf-8")
    begin = text.index("\nvoyages:") + 1
    rest = text[begin:].split("\n", 1)[1]
    kept = rest[len("".join(f"{x}\n" for x in _block(rest))) :]
    without, with_ = grown(text[:begin] + kept), grown(text)
    assert without is not None and with_ is not None
    assert with_[1].voyages and not without[1].voyages
    one, two = (lower(x[0], x[1]) for x in (without, with_))
    assert runtime_py(one, []) == runtime_py(two, [])
    said = [claims(Facts(System(x[0], c))) for x, c in ((without, one), (with_, two))]
    assert said[0] == said[1] and said[0]


def _block(rest: str) -> list[str]:
    """The indented lines at the beginning."""
    found = []
    for line in rest.split("\n"):
        if not line.startswith(" "):
            break
        found.append(line)
    return found


def test_a_journey_has_no_place_that_leads_only_back() -> None:
    """From the siding a train goes on over the track by which it came there alone: without a step from there it counted
    as done, and stood for ever."""
    start, track, siding, end = (Place(0, frozenset(), None, ((SectionId(s), 1),)) for s in ("a", "b", "c", "d"))
    steps = {start: [track], track: [siding, end], siding: [track], end: []}
    found = straight({p: [Step((), x, False) for x in out] for p, out in steps.items()}, start)
    assert {p: [s.after for s in out] for p, out in found.items()} == {start: [track], track: [end], end: []}
