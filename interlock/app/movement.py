"""A train's movement without a stop, as a plan by stages counts it: what it holds, and from when until when.

What delays a train on the controller is counted by what demands it, so that a plan can be made with it and without.
Constants are those of the layout (`release_delay_s`, `point_run_s`), of the dispatch file (speed, acceleration,
braking, reaction) and of the drivers who are simulated.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from math import ceil, floor, inf

from interlock.app.setting import CYCLE_MS, Setting
from interlock.app.worked import Trip
from interlock.planning.stages import Hold, Piece
from interlock.simulate.track import LEAVES_M
from interlock.simulate.yard import SETS_OFF_S, SIGHT_M

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
        self.setting, self.demands = setting, demands
        self.inner = {str(s) for z in setting.layout.zones for s in z.sections}
        self.build = setting.orders.file.fleet[train]
        self.speed = self.build.speed / 3.6
        self.principles = setting.layout.principles
        self.metres = {str(k[0]): m for k, m in setting.railway.metres.items()}
        self.seconds = 0.0
        """Until its head is where the last section so far ends."""
        self.held: dict[str, tuple[float | None, float]] = {}
        self.inside = False

    @property
    def tail(self) -> float:
        """Seconds that the train takes to pass a place."""
        return self.build.length / self.speed

    @property
    def released(self) -> float:
        """Seconds from the tail's leaving a section until another train may have it."""
        return self.principles.release_delay_s + RELEASED_MS / 1000 if self.demands.release else 0.0

    @property
    def gathers(self) -> float:
        """Seconds lost until a train that stood runs at full speed."""
        return self.speed / (2 * self.build.acceleration) if self.demands.rides else 0.0

    @property
    def brakes(self) -> float:
        """Seconds lost when it stops."""
        return self.speed / (2 * self.build.braking) if self.demands.rides else 0.0

    @property
    def sets(self) -> float:
        """Seconds from asking for a route until its signal opens."""
        return ASKED_MS / 1000 + self.principles.point_run_s if self.demands.setting else 0.0

    @property
    def sets_off(self) -> float:
        """Seconds from asking for a route until the train has as good as run at full speed from its place."""
        acts = self.build.reaction + SETS_OFF_S if self.demands.setting else 0.0
        return self.sets + acts + self.gathers

    def _hold(self, section: str, begin: float | None, end: float) -> None:
        old = self.held.get(section)
        if old is not None:
            begin = None if begin is None or old[0] is None else min(begin, old[0])
            end = max(end, old[1])
        self.held[section] = begin, end

    def approaches(self, boundary: str) -> None:
        """It comes from the waiting place, over the approach section."""
        line = next(b for b in self.setting.track.beyond if b.name == boundary)
        self.seconds = line.approach_m / self.speed + self.gathers
        self._hold(f"before {boundary}", 0, self.seconds + self.tail + self.released)

    def begins(self, section: str) -> None:
        """It stands wholly in a loading place, and changes direction."""
        self.inside = section in self.inner
        self.seconds = self.sets_off + max(0.0, self.metres[section] - self.build.length) / self.speed
        self._hold(section, None, self.seconds + self.tail + self.released)

    def stands(self, trip: Trip, where: Where | None, now_ms: int, load: str, boundary: str) -> None:
        """It is under way: where it was reported last, and what is set for it from there."""
        run = trip.run
        ahead = [str(x) for stage in run.granted[run.at :] for x in stage.sections]
        if trip.phase != "to load" and (where is None or where.section == load):
            self.begins(load)
        elif where is None or where.section not in self.metres:
            metres = next(b for b in self.setting.track.beyond if b.name == boundary).approach_m
            since = now_ms if where is None else where.since_ms
            self._comes(metres, now_ms - since, bool(ahead))
            self._hold(f"before {boundary}", None, self.seconds + self.tail + self.released)
        else:
            path = [str(x) for stage in run.granted for x in stage.sections]
            since = sum(len(stage.sections) for stage in run.granted[: max(0, run.at - 1)])
            if where.section not in path[since:]:
                path, since = [where.section, *ahead], 0
            here = path.index(where.section, since)
            ahead = path[here + 1 :]
            self._comes(self.metres[where.section], now_ms - where.since_ms, bool(ahead))
            self._behind(path[: here + 1], now_ms - where.since_ms)
        for x in ahead:
            self.seconds += self.metres[x] / self.speed
            self._hold(x, None, self.seconds + self.tail + self.released)
        self.inside = any(x in self.inner for x in self.held)

    def _behind(self, path: Sequence[str], ms: int) -> None:
        """It holds the section in which its head is, and those behind it until its tail has left them."""
        self._hold(path[-1], None, self.seconds + self.tail + self.released)
        metres = 0.0
        for x in path[-2::-1]:
            if metres > self.build.length:
                break
            self._hold(x, None, max(0.0, self.tail + metres / self.speed - ms / 1000) + self.released)
            metres += self.metres[x]

    def _comes(self, metres: float, ms: int, goes_on: bool) -> None:
        """To the end of the section in which it was reported last."""
        left = metres - ms / 1000 * self.speed
        self.seconds = left / self.speed if left > 0 else 1.0 if goes_on else self.sets_off

    def runs(self, sections: Sequence[tuple[str, float]]) -> None:
        """Over a route, which is asked for while its signal is just not in sight yet."""
        sight = self.speed / (2 * self.build.braking) + SIGHT_M / self.speed + self.build.reaction
        asked = max(0.0, self.seconds - (sight + self.sets if self.demands.setting else 0.0))
        for section, metres in sections:
            begin = asked if self.demands.routes else self.seconds
            self.seconds += metres / self.speed
            self._hold(section, begin, self.seconds + self.tail + self.released)

    def arrives(self, section: str) -> None:
        """It comes to a stand at the end of its loading place."""
        self.seconds += self.brakes
        begin, _ = self.held[section]
        self.held[section] = begin, inf

    def piece(self, name: Callable[[str], int], onward: Piece | None, work: int) -> Piece:
        """The same for planning; `name`: the number of a resource."""
        if onward is None:
            self.seconds += LEAVES_M / self.speed
        inner = [self.held[x] for x in self.held if x in self.inner]
        begins = [b for b, _ in inner if b is not None]
        holds = [
            Hold(name(x), None if b is None else floor(b), None if e == inf else ceil(e))
            for x, (b, e) in self.held.items()
        ]
        leaves = ceil(max(e for _, e in inner)) if inner and onward is None else None
        enters = floor(min(begins)) if begins and not self.inside else None
        return Piece(tuple(holds), ceil(self.seconds), work, enters, leaves, self.inside, onward)
