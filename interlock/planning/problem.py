"""Train dispatching: trains that go through operations, each of which holds sections, and what their delays cost.

The form is that of the public library DISPLIB, whose field names stand in brackets.  A train takes one path from its
first operation to its last; it ends an operation in the moment in which it begins the next one.  Times are whole units,
seconds mostly.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from interlock.dataclass import dataclass


@dataclass(frozen=True)
class Use:
    """A resource (a section, say) that is held during an operation, and by no other train until `release` units after
    its end [release_time].  The same train may have it again at once."""

    resource: str
    release: int = 0


@dataclass(frozen=True)
class Operation:
    """A step of a train.

    earliest, latest: when it may begin [start_lb, start_ub]; None: at any later time.
    duration: units that it takes at least [min_duration].
    following: operations of the train of which one comes next, by index, all greater than its own [successors].
    """

    duration: int = 0
    following: tuple[int, ...] = ()
    uses: tuple[Use, ...] = ()
    earliest: int = 0
    latest: int | None = None


@dataclass(frozen=True)
class Delay:
    """What the start of an operation costs, if its train takes it: `rate` for each unit after `due` [coeff, threshold],
    and `once` if it begins at `due` or later [increment]."""

    train: int
    operation: int
    due: int = 0
    rate: int = 0
    once: int = 0

    def of(self, time: int) -> int:
        """The cost of a start at a time."""
        return self.rate * max(0, time - self.due) + (self.once if time >= self.due else 0)


@dataclass(frozen=True)
class Problem:
    """Trains, each with its operations in topological order, the first and the last one being unique."""

    trains: tuple[tuple[Operation, ...], ...]
    delays: tuple[Delay, ...] = ()

    @property
    def operations(self) -> int:
        """How many there are."""
        return sum(len(t) for t in self.trains)


@dataclass(frozen=True)
class Event:
    """The start of an operation."""

    time: int
    train: int
    operation: int


@dataclass(frozen=True)
class Plan:
    """Starts of operations in the order in which they happen.  Events of one time have an order, too: a train that
    takes over a section comes after the one that leaves it, so that two trains can never change places."""

    events: tuple[Event, ...]
    cost: int


def cost(problem: Problem, events: Iterable[Event]) -> int:
    """What all delays cost together."""
    starts = {(e.train, e.operation): e.time for e in events}
    return sum(d.of(starts[d.train, d.operation]) for d in problem.delays if (d.train, d.operation) in starts)


def planned(problem: Problem, events: Sequence[Event]) -> Plan:
    """A plan with its cost."""
    return Plan(tuple(events), cost(problem, events))
