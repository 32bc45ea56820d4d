"""A span of a shift as a problem of train dispatching, to which what a dispatcher brings out can be compared.

Trains run in turns from their waiting place over the loading place that they choose to the tippler and back.  What
costs is each turn that a train does not make within the span.  Where shift and problem differ the problem allows more:
trains run at full speed at once and never brake, nobody waits for signals, points or the rule, a section is free when
the tail has left it.  So no dispatcher brings out more trains than a bound on the problem says.
What the drivers of the simulator always do is in it: they run to the end of a loading place, and stop 2 m before it.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import floor

from interlock.app.setting import Setting
from interlock.app.turns import NoHorizon, Way
from interlock.dataclass import dataclass
from interlock.planning.planner import Planned, schedule
from interlock.planning.problem import Delay, Event, Operation, Plan, Problem, planned
from interlock.planning.stages import Fleet, Staged, Turn, Under, staged


@dataclass(frozen=True)
class Horizon:
    """The problem, and how many turns its trains could make if each were alone."""

    problem: Problem
    turns: int


@dataclass(frozen=True)
class Compared:
    """Trains that a plan brings out, and that no dispatcher can exceed."""

    planned: int
    most: int
    by: str
    seconds: float


MANY = 1 << 20
"""More trains than there are."""

WIDTHS = (50, 200, 800)
"""States that are kept from stage to stage, one width after the other."""


def compared(setting: Setting, hours: float, seconds: float, workers: int = 1) -> Compared:
    """The best that is found in some seconds, and the bound.  Raises `NoHorizon`.

    The first plans are made by stages.  Where a zone may be full half of the time goes to the problem without its
    limit, whose bound holds all the same."""
    h, slots = horizon(setting, hours), _slots(setting)
    known = by_stages(setting, hours)
    found: Planned = schedule(h.problem, seconds / 2 if slots else seconds, workers, known=known, by="stages")
    most, spent = h.turns - found.bound, found.seconds
    if slots:
        known = by_stages(setting, hours, zones=True)
        problem = horizon(setting, hours, zones=True).problem
        found = schedule(problem, seconds / 2, workers, known=known, by="stages")
        most, spent = min(most, h.turns - found.bound), spent + found.seconds
    made = 0 if found.plan is None else h.turns - found.plan.cost
    return Compared(made, most, found.by, spent)


def by_stages(setting: Setting, hours: float, zones: bool = False, widths: Sequence[int] = WIDTHS) -> Plan:
    """A plan of the same problem by dynamic programming (`planning/stages.py`)."""
    end = floor(3600 * hours)
    fleet = _fleet(setting, _slots(setting) if zones else ())
    found = [staged(fleet, end, width) for width in widths]
    best = max(found, key=lambda x: sum(t <= end for t in x.tipped))
    return _Steps(setting, horizon(setting, hours, zones).problem, _slots(setting) if zones else ("",), end).plan(best)


def _fleet(setting: Setting, slots: Sequence[str]) -> Fleet:
    """The fleet before its first turns."""
    index: dict[str, int] = {}
    kinds: dict[object, int] = {}
    trains, turns = [], list[tuple[Turn, ...]]()
    for number, build in setting.orders.file.fleet.items():
        may = [(k, d) for k, d in enumerate(setting.derived) if number in d.journeys]
        alike = build.length, build.speed, build.at, tuple(k for k, _ in may)
        if alike not in kinds:
            kinds[alike] = len(turns)
            slot = slots[0] if slots else ""
            turns.append(tuple(Way(setting, d, number, slot).turn(index) for _, d in may))
        trains.append(Under(0, kinds[alike]))
    many = tuple(MANY for _ in setting.derived)
    return Fleet(tuple(trains), tuple(turns), many, (0,) * len(index), len(slots) or MANY)


class _Steps:
    """A plan by stages, told as starts of the operations of the problem."""

    def __init__(self, setting: Setting, problem: Problem, slots: Sequence[str], end: int) -> None:
        self.problem, self.slots, self.end = problem, slots, end
        self.ways: list[list[list[Way]]] = []
        """By train and order, the ways with each place in the zone."""
        for number in setting.orders.file.fleet:
            may = [d for d in setting.derived if number in d.journeys]
            self.ways.append([[Way(setting, d, number, s) for s in slots] for d in may])
        self.events: list[tuple[int, int, int, int]] = []
        self.taken, self.tippler = [0] * len(slots), 0
        self.ready = [0] * len(self.ways)

    def plan(self, found: Staged) -> Plan:
        """All turns that are made in time."""
        turns: list[list[tuple[int, int, int]]] = [[] for _ in self.ways]
        begun: dict[int, int] = {}
        for s in found.starts:
            if s.piece is s.turn.first:
                begun[s.train] = s.at
            if s.piece.onward is None:
                turns[s.train].append((s.turn.order, begun[s.train], s.at))
        at = sorted((away, train, n) for train, of in enumerate(turns) for n, (_, _, away) in enumerate(of))
        made = [0] * len(turns)
        for _, train, n in at:
            made[train] += self._turn(train, n, *turns[train][n])
        for train, count in enumerate(made):
            self._rest(train, count)
        return planned(self.problem, [Event(time, t, o) for time, _, t, o in sorted(self.events)])

    def _turn(self, train: int, n: int, order: int, began: int, away: int) -> bool:
        """One turn: times of all its operations, and a place in the zone that is free; whether it is made in time."""
        ways = self.ways[train]
        may = [w[0].order for w in ways]
        k = may.index(order)
        way = ways[k][0]
        times = way.times(began, away)
        tips = way.operations[-2].uses
        times[-2] = max(times[-2], self.tippler) if tips else times[-2]
        times[-1] = times[-2] + way.operations[-2].duration
        if times[-1] > self.end:
            return False
        inner = [j for j, o in enumerate(way.operations) if any(u.resource in self.slots for u in o.uses)]
        slot = 0
        if inner:
            slot = next(j for j, until in enumerate(self.taken) if until <= times[inner[0]])
            self.taken[slot] = times[inner[-1] + 1] + max(u.release for u in way.operations[inner[-1]].uses)
        base = n * self._size(train)
        head = base + 2 + sum(len(w.operations) for of in ways[:k] for w in of)
        head += sum(len(w.operations) for w in ways[k][:slot])
        self.tippler = times[-1] if tips else self.tippler
        self.events.append((began, 1, train, base))
        for j, time in enumerate(times):
            self.events.append((time, int(j + 1 < len(times)), train, head + j))
        self.ready[train] = times[-1] + way.back
        return True

    def _size(self, train: int) -> int:
        return 2 + sum(len(w.operations) for of in self.ways[train] for w in of)

    def _rest(self, train: int, made: int) -> None:
        """It stops after its last turn."""
        turns = (len(self.problem.trains[train]) - 2) // self._size(train)
        time, last = self.ready[train], turns * self._size(train) + 1
        steps = [made * self._size(train), *([made * self._size(train) + 1] if made < turns else []), last]
        self.events += [(time, 1, train, o) for o in steps]


def _slots(setting: Setting) -> tuple[str, ...]:
    """The zone that the fleet can fill, as so many places of which each train inside has one; none: there is no such
    zone.  Of several zones the tightest one is looked at."""
    full = [z for z in setting.layout.declared.zones if z.trains < len(setting.orders.file.fleet)]
    tight = min(full, key=lambda z: (z.trains, str(z.id)), default=None)
    return () if tight is None else tuple(f"{tight.id} {k}" for k in range(1, tight.trains + 1))


def horizon(setting: Setting, hours: float, zones: bool = False) -> Horizon:
    """The problem of some hours.  zones: with the limit of a zone, by as many ways as it has places.  Raises
    `NoHorizon`."""
    slots = _slots(setting) if zones else ("",)
    end = floor(3600 * hours)
    trains, delays, total = [], [], 0
    for number, train in enumerate(setting.orders.file.fleet):
        ways = [Way(setting, d, train, s) for d in setting.derived if train in d.journeys for s in slots]
        if not ways:
            raise NoHorizon(f"no order is for train {train}", "fleet", train)
        turns = _turns(ways, end)
        total += turns
        operations, quits = _train(ways, turns, end)
        trains.append(operations)
        delays += [Delay(number, k, 0, 0, left) for k, left in quits]
    return Horizon(Problem(tuple(trains), tuple(delays)), total)


def _turns(ways: Sequence[Way], end: int) -> int:
    """Turns that a train alone can make in time: the last one needs no way back."""
    once = min(w.out for w in ways)
    again = min(w.out + w.back for w in ways)
    return 0 if once > end else 1 + (end - once) // again


def _train(ways: Sequence[Way], turns: int, end: int) -> tuple[tuple[Operation, ...], list[tuple[int, int]]]:
    """All turns one after the other; before each the train may stop.  The second result: where it stops, and how many
    turns it then has not made."""
    width = sum(len(w.operations) for w in ways)
    size = width + 2
    """Of a turn: the train is ready, it stops, or one of the ways."""
    last = turns * size + 1
    made: list[Operation] = []
    quits = []
    for turn in range(turns):
        base = turn * size
        heads = []
        at = base + 2
        for w in ways:
            heads.append(at)
            at += len(w.operations)
        made.append(Operation(0, (base + 1, *heads)))
        made.append(Operation(0, (last,)))
        quits.append((base + 1, turns - turn))
        for w, head in zip(ways, heads, strict=True):
            for k, o in enumerate(w.operations[:-1]):
                made.append(Operation(o.duration, (head + k + 1,), o.uses))
            made.append(Operation(w.operations[-1].duration, (base + size,), (), 0, end))
    made.append(Operation(0, (last,)))
    made.append(Operation())
    return tuple(made), quits
