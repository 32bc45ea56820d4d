"""The dataclasses of `interlock.dataclass` are to whoever uses them what the standard library makes."""

import dataclasses
import operator
import pickle
from typing import Any

import pytest

from interlock.dataclass import dataclass
from interlock.diag import Place, Span

KINDS: list[dict[str, bool]] = [
    {},
    {"frozen": True},
    {"frozen": True, "slots": True},
    {"slots": True},
    {"eq": False},
    {"frozen": True, "eq": False},
    {"frozen": True, "order": True},
    {"unsafe_hash": True, "slots": True},
    {"repr": False},
]


def made(decorate: Any, **options: bool) -> Any:
    """A class with fields that take no part in comparing, hashing or printing, beside such that do."""

    @decorate(**options)
    class Signal:
        name: str
        length: int = 0
        note: str = dataclasses.field(default="", compare=False)
        seen: tuple[str, ...] = dataclasses.field(default=(), repr=False, hash=False)

    return Signal


@pytest.mark.parametrize("options", KINDS, ids=str)
def test_it_compares_hashes_orders_and_prints_as_the_original(options: dict[str, bool]) -> None:
    ours, theirs = made(dataclass, **options), made(dataclasses.dataclass, **options)
    arguments: list[tuple[Any, ...]] = [("X", 1), ("X", 1, "b"), ("X", 2), ("Y", 1), ("X", 1, "", ("q",))]
    for a in arguments:
        if options.get("repr", True):
            assert repr(ours(*a)) == repr(theirs(*a))
        if theirs.__hash__ is None:
            assert ours.__hash__ is None
        elif theirs.__hash__ is object.__hash__:
            assert ours.__hash__ is object.__hash__
        for b in arguments:
            assert (ours(*a) == ours(*b)) == (theirs(*a) == theirs(*b))
            if options.get("order"):
                for says in (operator.lt, operator.le, operator.gt, operator.ge):
                    assert says(ours(*a), ours(*b)) == says(theirs(*a), theirs(*b))
            if theirs.__hash__ not in (None, object.__hash__):
                assert (hash(ours(*a)) == hash(ours(*b))) == (hash(theirs(*a)) == hash(theirs(*b)))
    assert ours("X") != theirs("X"), "another class is never equal"


@pytest.mark.parametrize("slots", [False, True])
def test_a_frozen_one_is_not_changed(slots: bool) -> None:
    x = made(dataclass, frozen=True, slots=slots)("X", 1)
    for change in (lambda: setattr(x, "name", "Y"), lambda: setattr(x, "note", "n"), lambda: delattr(x, "name")):
        with pytest.raises(dataclasses.FrozenInstanceError):
            change()
    assert dataclasses.replace(x, length=3) == type(x)("X", 3)
    assert dataclasses.asdict(x) == {"name": "X", "length": 1, "note": "", "seen": ()}


def test_what_a_class_says_itself_stays() -> None:
    @dataclass(frozen=True)
    class Own:
        name: str

        def __eq__(self, other: object) -> bool:
            return isinstance(other, Own)

        def __hash__(self) -> int:
            return 7

        def __repr__(self) -> str:
            return "own"

    assert Own("a") == Own("b") and hash(Own("a")) == 7 and repr(Own("a")) == "own"


def test_a_class_below_another_adds_fields_and_one_without_any_is_equal_to_itself() -> None:
    @dataclass(frozen=True)
    class Base:
        name: str

    @dataclass(frozen=True)
    class Below(Base):
        length: int = 1

    @dataclass(frozen=True)
    class Empty:
        pass

    assert Below("a", 2) == Below("a", 2) != Below("a", 3)
    assert Below("a") != Base("a")
    assert {Empty(), Empty()} == {Empty()}


def test_values_of_the_package_are_pickled_and_frozen() -> None:
    place = Place(Span("yard.yaml", 3, 1))
    assert pickle.loads(pickle.dumps(place)) == place
    with pytest.raises(dataclasses.FrozenInstanceError):
        place.note = "here"  # type: ignore[misc]
