"""Turns of a train between waiting place, loading place and tippler, with seconds and what is held meanwhile."""

from __future__ import annotations

from collections.abc import Iterator
from math import floor

from interlock.app.setting import Setting
from interlock.dispatch.orders import Derived
from interlock.dispatch.plan.errands import Step
from interlock.dispatch.plan.railway import Journey
from interlock.exceptions import Whole
from interlock.planning.problem import Operation, Use
from interlock.planning.stages import Hold, Piece, Turn
from interlock.simulate.track import LEAVES_M

STOPS_M = 5.0
"""Metres before the end of a section within which a train is taken to stop: more than any driver keeps
(`model/stopping.py`)."""


class NoHorizon(Whole, ValueError):
    """The shift is not of the kind that can be compared; says why, and `at` what of the dispatch file."""

    def __init__(self, text: str, *at: str) -> None:
        super().__init__(text)
        self.at = at


class Way:
    """A turn over one loading place, with a place in a zone.

    `operations`: the last one begins when the train is tipped; `out`: seconds until then; `back`: from there until it
    is ready again."""

    def __init__(self, setting: Setting, order: Derived, train: str, slot: str) -> None:
        file = setting.orders.file
        self.order = setting.derived.index(order)
        build, load, tip = file.fleet[train], file.places[order.order.from_], file.places[order.order.to]
        self.speed, self.length = build.speed / 3.6, build.length
        journey = order.journeys[train]
        inner = {str(s) for z in setting.layout.declared.zones if slot.rpartition(" ")[0] == z.id for s in z.sections}
        line = next(b for b in setting.track.beyond if b.name == file.places[build.at].at)
        found = [Operation(self._seconds(line.approach_m))]
        for section, metres, turned in _sections(journey, order.name):
            seconds = self._seconds(metres)
            if section == load.at:
                self.load = len(found)
                inside = metres - STOPS_M
                work = floor(60 * (load.minutes or 0))
                seconds = self._seconds(inside) + work + self._seconds(inside - self.length)
            elif turned:
                raise NoHorizon(
                    f"a train of the order {order.name} turns in {section}, and is not loaded there",
                    "orders",
                    order.name,
                )
            held = [section, *([slot] if slot and section in inner else [])]
            found.append(Operation(seconds, (), tuple(Use(x, self._seconds(self.length)) for x in held)))
        found.append(Operation(self._seconds(LEAVES_M)))
        found.append(Operation(floor(60 * (tip.minutes or 0)), (), (Use(order.order.to),) if tip.capacity == 1 else ()))
        self.back = floor(60 * tip.back)
        self.out = sum(o.duration for o in found)
        self.operations = (*found, Operation(self.back))
        self.slot = slot

    def times(self, began: int, away: int) -> list[int]:
        """When each operation begins if the train sets out then, and from its loading place then."""
        found, at = [], began
        for k, o in enumerate(self.operations):
            at = max(at, away) if k == self.load + 1 else at
            found.append(at)
            at += o.duration
        return found

    def turn(self, index: dict[str, int]) -> Turn:
        """The same as pieces without a stop; `index`: the resources' numbers, which grow."""
        there, pieces = 0, list[tuple[int, list[Hold], list[int]]]()
        holds, inner = list[Hold](), list[int]()
        for k, o in enumerate(self.operations[:-2]):
            for u in o.uses:
                if u.resource == self.slot:
                    inner += [there, there + o.duration + u.release]
                    continue
                x = index.setdefault(u.resource, len(index))
                holds.append(Hold(x, there, None if k == self.load else there + o.duration + u.release))
            there += o.duration
            if k == self.load:
                pieces.append((there, holds, inner))
                back = [u for u in o.uses if u.resource != self.slot]
                holds = [Hold(index[u.resource], None, u.release) for u in back]
                there, inner = 0, []
        tip = self.operations[-2]
        tippler = index.setdefault(tip.uses[0].resource, len(index)) if tip.uses else None
        zone = inner[-1] if inner else None
        away = Piece(tuple(holds), there, leaves=zone, inside=zone is not None)
        seconds, into, entered = pieces[0]
        first = Piece(tuple(into), seconds, enters=entered[0] if entered else None, onward=away)
        return Turn(self.order, first, tip.duration, self.back, tippler)

    def _seconds(self, metres: float) -> int:
        """At full speed, rounded down."""
        return max(0, floor(metres / self.speed))


def _sections(journey: Journey, order: str) -> Iterator[tuple[str, float, bool]]:
    """The sections of a journey that has one way, with metres, and whether the train turns there."""
    place = journey.start
    found: list[tuple[str, float, bool]] = []
    while journey.steps[place]:
        if len(journey.steps[place]) > 1:
            beyond = f"from {place.under[-1][0]} on" if place.under else "there"
            raise NoHorizon(
                f"train {journey.errand.train} has several ways {beyond} for the order {order}", "orders", order
            )
        step: Step = journey.steps[place][0]
        if step.turned and found:
            found[-1] = (*found[-1][:2], True)
        for r in step.routes:
            found += [(str(key[0]), journey.railway.metres[key], False) for key in r.path.traversals]
        place = step.after
    yield from found
