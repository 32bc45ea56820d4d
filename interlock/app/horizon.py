"""A span of a shift as a problem of train dispatching, to which what a dispatcher brings out can be compared.

Trains run in turns from their waiting place over the loading place that they choose to the tippler and back.  What
costs is each turn that a train does not make within the span.  Where shift and problem differ the problem allows more:
trains run at full speed at once and never brake, nobody waits for signals, points or the rule, a section is free when
the tail has left it.  So no dispatcher brings out more trains than a bound on the problem says.
What the drivers of the simulator always do is in it: they run to the end of a loading place, and stop 2 m before it.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from math import floor

from interlock.app.setting import Setting
from interlock.dispatch.orders import Derived
from interlock.dispatch.plan.railway import Journey, Step
from interlock.planning.planner import Planned, schedule
from interlock.planning.problem import Delay, Operation, Problem, Use
from interlock.simulate.track import LEAVES_M

STOPS_M = 5.0
"""Metres before the end of a section within which a train is taken to stop: more than the drivers keep."""


class NoHorizon(ValueError):
    """The shift is not of the kind that can be compared; says why."""


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


def compared(setting: Setting, hours: float, seconds: float, workers: int = 1) -> Compared:
    """The best that is found in some seconds, and the bound.  Raises `NoHorizon`.

    Where a zone may be full half of the time goes to the problem without its limit, whose bound holds all the same."""
    h = horizon(setting, hours)
    slots = _slots(setting)
    found: Planned = schedule(h.problem, seconds / 2 if slots else seconds, workers)
    most, spent = h.turns - found.bound, found.seconds
    if slots:
        found = schedule(horizon(setting, hours, zones=True).problem, seconds / 2, workers)
        most, spent = min(most, h.turns - found.bound), spent + found.seconds
    planned = 0 if found.plan is None else h.turns - found.plan.cost
    return Compared(planned, most, found.by, spent)


def _slots(setting: Setting) -> tuple[str, ...]:
    """The zone that the fleet can fill, as so many places of which each train inside has one; none: there is no such
    zone.  Of several zones the tightest one is looked at."""
    full = [z for z in setting.layout.zones if z.trains < len(setting.orders.file.fleet)]
    tight = min(full, key=lambda z: (z.trains, str(z.id)), default=None)
    return () if tight is None else tuple(f"{tight.id} {k}" for k in range(1, tight.trains + 1))


def horizon(setting: Setting, hours: float, zones: bool = False) -> Horizon:
    """The problem of some hours.  zones: with the limit of a zone, by as many ways as it has places.  Raises
    `NoHorizon`."""
    slots = _slots(setting) if zones else ("",)
    end = floor(3600 * hours)
    trains, delays, total = [], [], 0
    for number, train in enumerate(setting.orders.file.fleet):
        ways = [_Way(setting, d, train, s) for d in setting.derived if train in d.journeys for s in slots]
        if not ways:
            raise NoHorizon(f"{train} has no order")
        turns = _turns(ways, end)
        total += turns
        operations, quits = _train(ways, turns, end)
        trains.append(operations)
        delays += [Delay(number, k, 0, 0, left) for k, left in quits]
    return Horizon(Problem(tuple(trains), tuple(delays)), total)


def _turns(ways: Sequence[_Way], end: int) -> int:
    """Turns that a train alone can make in time: the last one needs no way back."""
    once = min(w.out for w in ways)
    again = min(w.out + w.back for w in ways)
    return 0 if once > end else 1 + (end - once) // again


def _train(ways: Sequence[_Way], turns: int, end: int) -> tuple[tuple[Operation, ...], list[tuple[int, int]]]:
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


class _Way:
    """A turn over one loading place, with a place in a zone.

    `operations`: the last one begins when the train is tipped; `out`: seconds until then; `back`: from there until it
    is ready again."""

    def __init__(self, setting: Setting, order: Derived, train: str, slot: str) -> None:
        file = setting.orders.file
        build, load, tip = file.fleet[train], file.places[order.order.from_], file.places[order.order.to]
        self.speed, self.length = build.speed / 3.6, build.length
        journey = order.journeys[train]
        inner = {str(s) for z in setting.layout.zones if slot.startswith(f"{z.id} ") for s in z.sections}
        line = next(b for b in setting.track.beyond if b.name == file.places[build.at].at)
        found = [Operation(self._seconds(line.approach_m))]
        for section, metres, turned in _sections(journey):
            seconds = self._seconds(metres)
            if section == load.at:
                inside = metres - STOPS_M
                work = floor(60 * (load.minutes or 0))
                seconds = self._seconds(inside) + work + self._seconds(inside - self.length)
            elif turned:
                raise NoHorizon(f"{order.name} turns in {section}, where nothing is loaded")
            held = [section, *([slot] if slot and section in inner else [])]
            found.append(Operation(seconds, (), tuple(Use(x, self._seconds(self.length)) for x in held)))
        found.append(Operation(self._seconds(LEAVES_M)))
        found.append(Operation(floor(60 * (tip.minutes or 0)), (), (Use(order.order.to),) if tip.capacity == 1 else ()))
        self.back = floor(60 * tip.back)
        self.out = sum(o.duration for o in found)
        self.operations = (*found, Operation(self.back))

    def _seconds(self, metres: float) -> int:
        """At full speed, rounded down."""
        return max(0, floor(metres / self.speed))


def _sections(journey: Journey) -> Iterator[tuple[str, float, bool]]:
    """The sections of a journey that has one way, with metres, and whether the train turns there."""
    place = journey.start
    found: list[tuple[str, float, bool]] = []
    while journey.steps[place]:
        if len(journey.steps[place]) > 1:
            raise NoHorizon(f"{journey.errand.train} has several ways from {place}")
        step: Step = journey.steps[place][0]
        if step.turned and found:
            found[-1] = (*found[-1][:2], True)
        for r in step.routes:
            found += [(str(key[0]), journey.railway.metres[key], False) for key in r.traversals]
        place = step.after
    yield from found
