"""Numbers step with trains; a swapped, lost, doubled or unknown one is an alarm that names it, and nothing is asked."""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache
from itertools import permutations
from random import Random

import pytest

from interlock.dispatch import Dispatcher
from interlock.dispatch.commands import errand
from interlock.dispatch.describer import Describer
from interlock.model.elements import SectionId
from tests.layouts import built
from tests.test_dispatch import Panel


@lru_cache
def ground(name: str) -> tuple[object, ...]:
    return built(name)


class Yard:
    """Sections of a layout that are occupied by hand, and a describer that sees them.  `ways`: routes that are set."""

    def __init__(self, fleet: tuple[str, ...] = ("7", "8", "9"), name: str = "mine11") -> None:
        layout, _, controller = ground(name)
        self.symbols = controller.symbols  # type: ignore[attr-defined]
        self.d = Describer(layout, self.symbols, frozenset(fleet))  # type: ignore[arg-type]
        self.d.expected = {SectionId("ap_W"): ["7", "8"], SectionId("ap_E"): ["9"]}
        self.at: dict[str, list[str]] = {}
        self.ways: list[tuple[SectionId, ...]] = []

    def see(self) -> None:
        occupied = {s for x in self.at.values() for s in x}
        self.d.step({n: int(s not in occupied) for s, n in self.symbols.sections.clear.items()}, self.ways)

    def drive(self, train: str, *sections: str) -> None:
        """Into each section with the head, then out of the one before with the tail."""
        for s in sections:
            self.at.setdefault(train, []).append(s)
            self.see()
            self.at[train] = [s]
            self.see()


IN, OUT = ("ap_W", "q1", "q2", "q4", "q6"), ("ap_E", "q11", "q9", "q7", "q5")


def test_numbers_step_with_their_trains() -> None:
    y = Yard()
    y.drive("7", *IN)
    y.drive("9", *OUT)
    y.drive("8", "ap_W", "q1")
    assert [y.d.where(n) for n in "789"] == ["q6", "q1", "q5"] and y.d.alarms == {}
    for n, s in (("7", "q6"), ("8", "q1"), ("9", "q5")):
        y.d.read(SectionId(s), n)
    assert y.d.alarms == {}
    y.drive("7", "q8", "q10", "q11", "ap_E")
    y.at.pop("7")
    y.see()
    assert y.d.where("7") is None and y.d.alarms == {}, "it has left"


def adit(*expected: str) -> Yard:
    """Heishan: train 2 has come to the points behind the approach section, on which others are expected."""
    y = Yard(("2", "5", "6"), "heishan")
    y.d.expected = {SectionId("s1_wait"): ["2"]}
    y.drive("2", "s1_wait", "s2", "s3")
    y.d.expected[SectionId("s1_wait")] = list(expected)
    y.ways = [(SectionId("s3"), SectionId("s2"), SectionId("s2_out"))]
    y.drive("2", "s2")
    return y


def test_a_train_comes_in_beside_one_that_runs_elsewhere() -> None:
    """The one that runs out was taken for the one that came in, and every number after it was that of another train."""
    y = adit("5", "6")
    y.drive("5", "s1_wait")
    y.drive("2", "s2_out")
    assert y.d.alarms == {} and (y.d.where("5"), y.d.where("2")) == ("s1_wait", "s2_out")
    assert y.d.expected[SectionId("s1_wait")] == ["6"]


def test_a_train_that_nobody_expects_beside_one_that_runs_elsewhere_is_told() -> None:
    y = adit()
    y.drive("x", "s1_wait")
    assert y.d.alarms == {"?s1_wait": "no number in s1_wait"} and y.d.where("2") == "s2"


def test_two_that_may_have_come_into_an_approach_section_are_named() -> None:
    """No route leads the one on: it may have run back."""
    y = adit("5")
    y.ways = []
    y.drive("x", "s1_wait")
    assert set(y.d.alarms) == {"2", "5"}
    y = adit()
    y.ways = []
    y.at["2"].append("s1_wait")
    y.see()
    assert y.d.where("2") == "s1_wait" and y.d.alarms == {}, "nobody else is expected"


def test_a_number_that_is_confirmed_is_not_expected_any_more() -> None:
    """Else one mistake makes every number after it that of another train."""
    y = adit()
    y.drive("5", "s1_wait")
    y.d.expected[SectionId("s1_wait")] = ["5", "6"]
    assert y.d.confirm(SectionId("s1_wait"), "5") and y.d.expected[SectionId("s1_wait")] == ["6"]
    y = adit()
    y.drive("5", "s1_wait")
    y.d.expected[SectionId("s1_wait")] = ["5", "6"]
    y.d.read(SectionId("s1_wait"), "5")
    assert y.d.alarms == {} and y.d.expected[SectionId("s1_wait")] == ["6"]


def test_swapped_numbers_name_both() -> None:
    y = Yard()
    y.drive("7", *IN)
    y.drive("9", *OUT)
    y.d.read(SectionId("q6"), "9")
    assert set(y.d.alarms) == {"7", "9"} and "q5" in y.d.alarms["9"]
    assert y.d.confirm(SectionId("q6"), "9") and y.d.where("9") == "q6"
    assert set(y.d.alarms) >= {"?q5"} and "7" not in y.d.alarms
    assert y.d.confirm(SectionId("q5"), "7") and y.d.alarms == {} and y.d.where("7") == "q5"


def test_a_lost_train_is_named() -> None:
    y = Yard()
    y.drive("7", *IN)
    y.at.clear()
    y.see()
    assert y.d.alarms == {"7": "it is lost: q6 became clear, and nothing beside it is occupied"}


@pytest.mark.parametrize("sections", [IN[:2], IN[:3], IN])
def test_of_sections_that_become_clear_at_once_the_first_in_its_direction_decides(sections: tuple[str, ...]) -> None:
    """Whatever the order in which a set is gone through: a train that was inside has not left over the boundary."""
    for order in permutations(sections):
        y = Yard()
        y.drive("7", sections[0])
        for s in sections[1:]:
            y.at["7"].append(s)
            y.see()
        y.d.occupied = _Ordered(order)
        y.at.clear()
        y.see()
        assert y.d.alarms == {"7": f"it is lost: {sections[-1]} became clear, and nothing beside it is occupied"}
        assert y.d.trains == []


def test_a_train_that_leaves_over_the_boundary_in_one_scan_is_not_lost() -> None:
    for order in permutations(("q1", "ap_W")):
        y = Yard()
        y.d.expected = {SectionId("ap_E"): ["9"]}
        y.drive("9", "ap_E", "q11", "q9", "q7", "q5", "q3", "q2", "q1")
        y.at["9"].append("ap_W")
        y.see()
        y.d.occupied = _Ordered(order)
        y.at.clear()
        y.see()
        assert y.d.alarms == {} and y.d.trains == []


class _Ordered(set[SectionId]):
    """A set that is gone through in a given order, as another seed of hashes would do."""

    def __init__(self, order: tuple[str, ...]) -> None:
        super().__init__(map(SectionId, order))
        self.order = order

    def __sub__(self, other: object) -> _Ordered:
        return _Ordered(tuple(s for s in self.order if s not in other))  # type: ignore[operator]

    def __iter__(self) -> Iterator[SectionId]:
        return iter(map(SectionId, self.order))


def test_a_doubled_number_is_named() -> None:
    y = Yard()
    y.drive("7", *IN)
    y.drive("8", "ap_W", "q1")
    y.d.read(SectionId("q1"), "7")
    assert set(y.d.alarms) == {"7", "8"}


def test_unknown_numbers_and_trains_from_nowhere() -> None:
    y = Yard()
    y.drive("7", *IN)
    y.d.read(SectionId("q6"), "55")
    assert set(y.d.alarms) == {"7", "55"} and "no train has this number" in y.d.alarms["55"]
    y = Yard()
    y.at["x"] = ["q7"]
    y.see()
    assert set(y.d.alarms) == {"?q7"}
    y.d.read(SectionId("q7"), "8")
    assert y.d.alarms == {} and y.d.where("8") == "q7"
    y.d.read(SectionId("q9"), "8")
    assert set(y.d.alarms) == {"8"}
    assert not y.d.confirm(SectionId("q9"), "8")


@pytest.mark.parametrize("seed", range(40))
def test_whatever_is_confused_the_train_is_named(seed: int) -> None:
    """A hundred steps of two trains on two tracks; at a random moment readers begin to tell something else."""
    rng, y = Random(seed), Yard()
    ways = {"7": list(IN[1:]), "9": list(OUT[1:])}
    for n, s in (("7", "ap_W"), ("9", "ap_E")):
        y.drive(n, s)
    kind = rng.choice(("swapped", "doubled", "unknown", "none"))
    moment, step = rng.randrange(1, 7), 0
    while any(ways.values()):
        n = rng.choice([k for k, w in ways.items() if w])
        y.drive(n, ways[n].pop(0))
        step += 1
        if step < moment:
            y.d.read(SectionId(y.at[n][-1]), n)
            continue
        told = {"swapped": {"7": "9", "9": "7"}[n], "doubled": "7", "unknown": "66", "none": n}[kind]
        y.d.read(SectionId(y.at[n][-1]), told)
        wrong = set() if told == n else {n, told}
        assert wrong <= set(y.d.alarms)
    assert (kind == "none") == (not y.d.alarms) or kind == "doubled"


def test_lost_wagons_keep_the_sections_between_blocked() -> None:
    y = Yard()
    y.drive("7", "ap_W", "q1")
    y.d.counted(SectionId("q1"), 12)
    y.drive("7", "q2", "q4", "q6", "q8")
    y.d.counted(SectionId("q8"), 11)
    assert y.d.alarms == {"7": "12 wagons went in and 11 came out"}
    assert y.d.writes() == {"BLK_q1": 1, "BLK_q2": 1, "BLK_q4": 1, "BLK_q6": 1}
    y.d.looked(SectionId("q4"))
    assert y.d.writes() == {"BLK_q1": 1, "BLK_q2": 1, "BLK_q6": 1}
    even = Yard()
    even.drive("7", "ap_W", "q1")
    even.d.counted(SectionId("q1"), 12)
    even.drive("7", "q2", "q4", "q6", "q8")
    even.d.counted(SectionId("q8"), 12)
    assert even.d.alarms == {} and even.d.writes() == {}


def test_nothing_is_asked_for_a_train_with_an_alarm() -> None:
    p = Panel(*built("mine11"))
    order, _ = errand(p.dispatcher.railway, "7:W>E", 60.0)
    p.dispatcher.carry_out(order)
    assert isinstance(p.dispatcher, Dispatcher)
    p.dispatcher.held["7"] = "in q1 the number 9 was read"
    p.stand("ap_W")
    p.run(60)
    assert p.asked == [] and p.dispatcher.runs[0].reason == "in q1 the number 9 was read"
    p.dispatcher.held.clear()
    p.run(60)
    assert p.opened() == {"X7"}
