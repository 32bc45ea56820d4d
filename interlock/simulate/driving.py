"""Trains of a shift as they run: in closed form, from joint to joint, from the sight of a signal to a stand.

Drivers run by signals as those of `driver` do: they see one from where they can still stop before it, act on what has
changed within their reaction time, and stand before one at stop.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial
from math import inf
from typing import TYPE_CHECKING

from interlock.dataclass import dataclass
from interlock.model.portable import portable
from interlock.model.stopping import SIGNAL_M
from interlock.simulate.agenda import not_before
from interlock.simulate.motion import Motion, runs, standing
from interlock.simulate.track import NONE
from interlock.simulate.train import Train

if TYPE_CHECKING:
    from interlock.simulate.yard import Yard

SIGHT_M = 30.0
"""Metres more than its braking distance from which a signal is read (our choice)."""

ROUNDED_M = 1e-6
"""Metres by which a sum of lengths may be rounded: a train that near to where it sees a signal sees it."""

SETS_OFF_S = 3.0
"""Seconds until a standing train moves, once its driver has acted (our choice)."""


@dataclass(frozen=True)
class Build:
    """How a train is built: metres, m/s, m/s^2, seconds."""

    length: float
    speed: float
    gathers: float
    brakes: float
    reaction: float


@dataclass(eq=False)
class Rolling:
    """A train on the rails: `ran` metres so far; where its head and tail would be on their stretches at 0 metres."""

    name: str
    build: Build
    train: Train
    motion: Motion
    head_0: float
    tail_0: float
    accepted: bool = False
    sections: tuple[int, ...] = ()


class Driving:
    """How the trains of a yard run: what their drivers read and do, from joint to joint.

    stopped, entered, gone: told of a train that stands, comes into a section, or leaves over a boundary.
    """

    def __init__(self, yard: Yard) -> None:
        self._yard = yard
        self.stopped: Callable[[Rolling], None] = lambda r: None
        self.entered: Callable[[Rolling, str], None] = lambda r, section: None
        self.gone: Callable[[Rolling, str], None] = lambda r, where: None
        self.movements = 0
        """Signals passed at proceed."""
        self.passed_at_stop: list[str] = []
        track = yard.track
        self._lit = [tuple(f"{x}_{portable(g)}" for x in ("YP", "YY", "YO")) for g in track.signals]
        self._open = [False] * len(track.signals)
        self._line_speed = track.layout.principles.line_speed_kmh / 3.6
        self._limit = [None if s.speed is None else s.speed / 3.6 for s in track.layout.track.sections]

    def shown(self, outputs: Mapping[str, int]) -> None:
        """The signals of a scan are seen."""
        for g, names in enumerate(self._lit):
            now = any(outputs.get(n) for n in names)
            if now != self._open[g]:
                self._open[g] = now
                self._yard.say("signal", signal=self._yard.track.signals[g], open=now)
                for r in self._yard.rolling.values():
                    if r.train.view.target == g:
                        self._yard.agenda.after(r.build.reaction, partial(self._read, r), f"reads {r.name}")

    def turns(self, r: Rolling) -> None:
        """A standing train changes ends."""
        self._sync(r)
        r.train.turned(self._yard.track)
        ran = r.motion.at(self._yard.clock)[0]
        r.head_0, r.tail_0 = ran - r.train.head, ran - r.train.tail
        r.accepted = False
        self.drives(r)

    def _sync(self, r: Rolling) -> None:
        """Where a train is now."""
        ran, speed = r.motion.at(self._yard.clock)
        t = r.train
        t.head, t.tail, t.speed = ran - r.head_0, ran - r.tail_0, speed
        t.moved = speed > 0.0

    def _read(self, r: Rolling) -> None:
        """A driver looks at the signal ahead, and acts."""
        t = r.train
        if r.name not in self._yard.rolling or t.view.target == NONE:
            return
        self._sync(r)
        self._yard.sight.look(t)
        if t.view.target == NONE:
            return
        told = self._open[t.view.target]
        if told == r.accepted or (told and t.speed > 0 and not self._in_sight(r)):
            return
        if not told and t.speed**2 / (2 * t.handling.brakes) >= t.view.gap - 0.2:
            return  # too late: he passes it, and the route behind it must hold
        if told and t.speed == 0.0:
            r.accepted = True
            self._yard.agenda.after(SETS_OFF_S, lambda: self.drives(r), f"train {r.name}")
            return
        r.accepted = told
        self.drives(r)

    def _in_sight(self, r: Rolling) -> bool:
        """Whether a driver is so near to the signal ahead that he reads it."""
        return r.train.view.gap <= self._view(r) + ROUNDED_M

    def _view(self, r: Rolling) -> float:
        top = min(r.build.speed, self._line_speed)
        return top * r.build.reaction + top**2 / (2 * r.build.brakes) + SIGHT_M

    def drives(self, r: Rolling) -> None:
        """A driver decides how he runs on."""
        t, now = r.train, self._yard.clock
        self._sync(r)
        ran = r.motion.at(now)[0]
        self._yard.sight.look(t)
        near = t.view.target != NONE and (t.speed == 0.0 or self._in_sight(r))
        if near and not r.accepted and self._open[t.view.target]:
            r.accepted = True
        to = self._until(r)
        top = min([r.build.speed, self._line_speed, *self._limits(t, to)])
        before = t.speed
        r.motion = runs(now, ran, t.speed, ran + to, top, r.build.gathers, r.build.brakes)
        if before == 0.0 and to > 0.01:
            self._yard.watch.starts(self._yard, t)
            self._yard.say("runs", train=r.name, section=self._where(r))
        self._plan(r)

    def _until(self, r: Rolling) -> float:
        """Metres in which a driver means to stand."""
        t = r.train
        if r.accepted:
            return max(0.0, t.view.gap + t.view.further[0] - SIGNAL_M) if t.view.further else inf
        if t.view.target == NONE:
            return max(0.0, t.view.gap) if t.driver.called else 0.0
        return max(0.0, t.view.gap - SIGNAL_M) if t.driver.called else 0.0

    def _limits(self, t: Train, metres: float) -> list[float]:
        found = []
        for d, _ in self._yard.sight.ahead(t, min(metres, 3000.0)):
            x = self._yard.track.stretches[d].section
            limit = self._limit[x] if x != NONE else None
            if limit is not None:
                found.append(limit)
        return found

    def _plan(self, r: Rolling) -> None:
        """When something happens to a train next: never, where it stands, be it at the joint at which it derailed."""
        t, s, m = r.train, self._yard.track.stretches, r.motion
        if t.speed == 0.0 and m.stands <= self._yard.clock:
            self._yard.agenda.forget(f"train {r.name}")
            return
        times = [m.when(r.head_0 + s[t.body[-1]].metres), m.when(r.tail_0 + s[t.body[0]].metres)]
        if t.view.target != NONE and not r.accepted and not self._in_sight(r):
            times.append(m.when(m.at(self._yard.clock)[0] + t.view.gap - self._view(r)))
        stands = m.stands
        if stands > self._yard.clock or t.speed > 0.0:
            times.append(stands)
        at = min(times)
        if at < inf:
            self._yard.agenda.at(not_before(at), lambda: self._happens(r), f"train {r.name}")
        else:
            self._yard.agenda.forget(f"train {r.name}")

    def _happens(self, r: Rolling) -> None:
        """A train has come to a joint, or into sight of a signal, or to a stand."""
        t, s = r.train, self._yard.track.stretches
        was = t.speed
        self._sync(r)
        changed = passed = False
        while t.head >= s[t.body[-1]].metres - 1e-9:
            on = self._onto(t)
            if on == NONE:
                if s[t.body[-1]].outside:
                    self._goes(r)
                    return
                self._yard.watch.derails(self._yard, t)
                r.motion, r.accepted = standing(self._yard.clock, r.motion.at(self._yard.clock)[0]), False
                self._sync(r)
                break
            r.head_0 += s[t.body[-1]].metres
            t.head -= s[t.body[-1]].metres
            section = s[t.body[-1]].section
            t.body.append(on)
            changed = True
            if s[on].signal != NONE and (not t.driver.called or self._yard.sight.obeys(t, s[on].signal)):
                self._passes(r, s[on].signal)
                passed = True
            if s[on].section != section and s[on].section != NONE:
                self._comes_in(r, s[on].section, s[on].outside)
        while len(t.body) > 1 and t.tail >= s[t.body[0]].metres - 1e-9:
            r.tail_0 += s[t.body[0]].metres
            t.tail -= s[t.body[0]].metres
            t.body.pop(0)
            changed = True
        if changed:
            t.under.looks(self._yard.track, t.body)
            t.fouls(self._yard.track)
            self.recount(r)
            for o in self._yard.rolling.values():
                self._sync(o)
            self._yard.watch.trains(self._yard)
        if t.speed == 0.0 and r.motion.stands <= self._yard.clock:
            if was > 0.0 or changed:
                self._yard.say("stands", train=r.name, section=self._where(r))
                self.stopped(r)
            self._plan(r)
        elif passed or (not r.accepted and t.view.target != NONE):
            self.drives(r)
        else:
            self._plan(r)

    def _onto(self, t: Train) -> int:
        here = self._yard.track.stretches[t.body[-1]]
        if here.machine == NONE:
            return here.on
        lies = self._yard.machines.lies[here.machine]
        if here.facing is None:
            if lies != here.needs:
                self._yard.watch.runs_over(self._yard, t, here.machine, "runs through")
            return here.on
        if lies == NONE:
            self._yard.watch.runs_over(self._yard, t, here.machine, "runs onto the moving rails of")
        return here.facing[max(lies, 0)]

    def _passes(self, r: Rolling, signal: int) -> None:
        name = self._yard.track.signals[signal]
        if r.accepted:
            self.movements += 1
            r.train.driver.called = True
        else:
            self.passed_at_stop.append(f"{self._yard.clock:.1f} s: train {r.name} at {name}")
        r.accepted = False
        self._yard.say("passes", train=r.name, signal=name)

    def _comes_in(self, r: Rolling, section: int, outside: bool) -> None:
        name = self._yard.track.sections[section]
        if not outside:
            self._yard.watch.comes_in(self._yard, r.train, section)
        self._yard.say("enters", train=r.name, section=name)
        self.entered(r, name)

    def _where(self, r: Rolling) -> str:
        x = self._yard.track.stretches[r.train.body[-1]].section
        return self._yard.track.sections[x] if x != NONE else ""

    def _goes(self, r: Rolling) -> None:
        where = next(b.name for b in self._yard.track.beyond if b.goes == r.train.body[-1])
        self._yard.taken_away(r)
        self._yard.say("leaves", train=r.name, at=where)
        self.gone(r, where)

    def recount(self, r: Rolling) -> None:
        """Sections as occupied by a train now and before."""
        s = self._yard.track.stretches
        now = tuple(dict.fromkeys(s[d].section for d in r.train.body if s[d].section != NONE))
        left = [x for x in r.sections if x not in now]
        for x in left:
            self._yard.say("clears", train=r.name, section=self._yard.track.sections[x])
        self._yard.inputs.occupy(left, -1)
        self._yard.inputs.occupy([x for x in now if x not in r.sections], 1)
        r.sections = now
