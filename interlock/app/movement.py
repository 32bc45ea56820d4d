"""A train's movement without a stop, as a plan by stages counts it: what it holds, and from when until when.

What delays a train on the controller is counted by what demands it, so that a plan can be made with it and without.
Constants are those of the layout (`release_delay_s`, `point_run_s`), of the dispatch file (speed, acceleration,
braking, reaction) and of the drivers who are simulated.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from math import ceil, floor, inf

from interlock.app.setting import CYCLE_MS, Setting
from interlock.app.worked import Trip
from interlock.dataclass import dataclass
from interlock.planning.stages import Hold, Piece
from interlock.simulate.driving import SETS_OFF_S, SIGHT_M
from interlock.simulate.track import LEAVES_M

RELEASED_MS, ASKED_MS = 2 * CYCLE_MS, 4 * CYCLE_MS
"""Milliseconds from a section's release until it is told, and from asking for a route until its points are driven."""


@dataclass(frozen=True)
class Demands:
    """What a movement takes account of.

    rides: trains gather speed and brake.  release: a section is released some time after the tail has left it.
    setting: a route is asked for so early that nobody brakes before its signal; who stands sets off when it is open.
    routes: all sections of a route are set at once, else each when the head comes to it.
    """

    rides: bool = True
    release: bool = True
    setting: bool = True
    routes: bool = True


@dataclass
class Where:
    """Where a train was reported last, and since when."""

    section: str
    since_ms: int


class Movement:
    """What a train holds, second by second, while it runs without a stop."""

    def __init__(self, setting: Setting, train: str, demands: Demands) -> None:
        self._setting, self._demands = setting, demands
        self._inner = {str(s) for z in setting.layout.declared.zones for s in z.sections}
        self._build = setting.orders.file.fleet[train]
        self._speed = self._build.speed / 3.6
        self._principles = setting.layout.principles
        self._metres = {str(k[0]): m for k, m in setting.railway.metres.items()}
        self._seconds = 0.0
        """Until its head is where the last section so far ends."""
        self._held: dict[str, tuple[float | None, float]] = {}
        self._inside = False

    @property
    def _tail(self) -> float:
        """Seconds that the train takes to pass a place."""
        return self._build.length / self._speed

    @property
    def _released(self) -> float:
        """Seconds from the tail's leaving a section until another train may have it."""
        return self._principles.release_delay_s + RELEASED_MS / 1000 if self._demands.release else 0.0

    @property
    def _gathers(self) -> float:
        """Seconds lost until a train that stood runs at full speed."""
        return self._speed / (2 * self._build.acceleration) if self._demands.rides else 0.0

    @property
    def _brakes(self) -> float:
        """Seconds lost when it stops."""
        return self._speed / (2 * self._build.braking) if self._demands.rides else 0.0

    @property
    def _sets(self) -> float:
        """Seconds from asking for a route until its signal opens."""
        return ASKED_MS / 1000 + self._principles.point_run_s if self._demands.setting else 0.0

    @property
    def _sets_off(self) -> float:
        """Seconds from asking for a route until the train has as good as run at full speed from its place."""
        acts = self._build.reaction + SETS_OFF_S if self._demands.setting else 0.0
        return self._sets + acts + self._gathers

    def _hold(self, section: str, begin: float | None, end: float) -> None:
        old = self._held.get(section)
        if old is not None:
            begin = None if begin is None or old[0] is None else min(begin, old[0])
            end = max(end, old[1])
        self._held[section] = begin, end

    def approaches(self, boundary: str) -> None:
        """It comes from the waiting place, over the approach section."""
        line = next(b for b in self._setting.track.beyond if b.name == boundary)
        self._seconds = line.approach_m / self._speed + self._gathers
        self._hold(f"before {boundary}", 0, self._seconds + self._tail + self._released)

    def begins(self, section: str) -> None:
        """It stands wholly in a loading place, and changes direction."""
        self._inside = section in self._inner
        self._seconds = self._sets_off + max(0.0, self._metres[section] - self._build.length) / self._speed
        self._hold(section, None, self._seconds + self._tail + self._released)

    def stands(self, trip: Trip, where: Where | None, now_ms: int, load: str, boundary: str) -> None:
        """It is under way: where it was reported last, and what is set for it from there."""
        run = trip.run
        ahead = [str(x) for stage in run.way.granted[run.way.at :] for x in stage.sections]
        if trip.phase != "to load" and (where is None or where.section == load):
            self.begins(load)
        elif where is None or where.section not in self._metres:
            metres = next(b for b in self._setting.track.beyond if b.name == boundary).approach_m
            since = now_ms if where is None else where.since_ms
            self._comes(metres, now_ms - since, bool(ahead))
            self._hold(f"before {boundary}", None, self._seconds + self._tail + self._released)
        else:
            path = [str(x) for stage in run.way.granted for x in stage.sections]
            since = sum(len(stage.sections) for stage in run.way.granted[: max(0, run.way.at - 1)])
            if where.section not in path[since:]:
                path, since = [where.section, *ahead], 0
            here = path.index(where.section, since)
            ahead = path[here + 1 :]
            self._comes(self._metres[where.section], now_ms - where.since_ms, bool(ahead))
            self._behind(path[: here + 1], now_ms - where.since_ms)
        self._led(ahead)
        self._inside = any(x in self._inner for x in self._held)

    def comes_in(self, trip: Trip) -> None:
        """It has not come yet, and runs over what is set for it."""
        self._led([str(x) for stage in trip.run.way.granted[trip.run.way.at :] for x in stage.sections])

    def _led(self, sections: Iterable[str]) -> None:
        """Over sections that are locked for it."""
        for x in sections:
            self._seconds += self._metres[x] / self._speed
            self._hold(x, None, self._seconds + self._tail + self._released)

    def _behind(self, path: Sequence[str], ms: int) -> None:
        """It holds the section in which its head is, and those behind it until its tail has left them."""
        self._hold(path[-1], None, self._seconds + self._tail + self._released)
        metres = 0.0
        for x in path[-2::-1]:
            if metres > self._build.length:
                break
            self._hold(x, None, max(0.0, self._tail + metres / self._speed - ms / 1000) + self._released)
            metres += self._metres[x]

    def _comes(self, metres: float, ms: int, goes_on: bool) -> None:
        """To the end of the section in which it was reported last."""
        left = metres - ms / 1000 * self._speed
        self._seconds = left / self._speed if left > 0 else 1.0 if goes_on else self._sets_off

    def runs(self, sections: Sequence[tuple[str, float]]) -> None:
        """Over a route, which is asked for while its signal is just not in sight yet."""
        sight = self._speed / (2 * self._build.braking) + SIGHT_M / self._speed + self._build.reaction
        asked = max(0.0, self._seconds - (sight + self._sets if self._demands.setting else 0.0))
        for section, metres in sections:
            begin = asked if self._demands.routes else self._seconds
            self._seconds += metres / self._speed
            self._hold(section, begin, self._seconds + self._tail + self._released)

    def arrives(self, section: str) -> None:
        """It comes to a stand at the end of its loading place."""
        self._seconds += self._brakes
        begin, _ = self._held[section]
        self._held[section] = begin, inf

    def piece(self, name: Callable[[str], int], onward: Piece | None, work: int) -> Piece:
        """The same for planning; `name`: the number of a resource."""
        if onward is None:
            self._seconds += LEAVES_M / self._speed
        inner = [self._held[x] for x in self._held if x in self._inner]
        begins = [b for b, _ in inner if b is not None]
        holds = [
            Hold(name(x), None if b is None else floor(b), None if e == inf else ceil(e))
            for x, (b, e) in self._held.items()
        ]
        leaves = ceil(max(e for _, e in inner)) if inner and onward is None else None
        enters = floor(min(begins)) if begins and not self._inside else None
        return Piece(tuple(holds), ceil(self._seconds), work, enters, leaves, self._inside, onward)
