"""A railway with a fleet, event by event: trains in closed form, points that take their time, sections that report.

Drivers run by signals as those of `driver` do: they see one from where they can still stop before it, act on what has
changed within their reaction time, and stand before one at stop.  Every harm that `hazards` knows is looked for
whenever a train comes to a joint or rails begin to move.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import partial
from math import inf
from random import Random

from interlock.model.layout import Layout
from interlock.model.portable import portable
from interlock.simulate.agenda import Agenda, not_before
from interlock.simulate.hazards import Watch
from interlock.simulate.motion import Motion, runs, standing
from interlock.simulate.points import Points
from interlock.simulate.sight import Sight
from interlock.simulate.track import NONE, Track
from interlock.simulate.train import Handling, Train

MARGIN_M = 2.0
"""Metres before a signal in which a driver stands (our choice)."""

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


class Yard:
    """The world of a shift.  `inputs`: those of the controller, written here; `say`: whom events are told."""

    def __init__(
        self,
        layout: Layout,
        track: Track,
        inputs: dict[str, int],
        agenda: Agenda,
        rng: Random,
        say: Callable[..., None],
    ) -> None:
        self.layout, self.track, self.agenda, self.rng, self.say = layout, track, agenda, rng, say
        self._inputs = inputs
        self.changed_ms: int | None = None
        """Since when an input is other than the controller has read it."""
        for name in inputs:  # nothing is pressed, blocked or out of order
            inputs[name] = int(name.startswith(("RL_", "GL_", "CL_", "NL_", "E_", "SH_", "VALID", "CLR_")))
        self.trains: list[Train] = []
        self.rolling: dict[str, Rolling] = {}
        self.machines = Points(self)
        self.sight = Sight(self)
        self.watch = Watch(layout, track)
        self._count = [0] * len(track.sections)
        self._held: dict[int, int] = {}
        """Sections that report occupied whatever stands there, and how many things make them."""
        self.stopped: Callable[[Rolling], None] = lambda r: None
        self.gone: Callable[[Rolling, str], None] = lambda r, where: None
        self.entered: Callable[[Rolling, str], None] = lambda r, section: None
        self.movements = 0
        self._closed_before = 0
        self.passed_at_stop: list[str] = []
        self._lit = [tuple(f"{x}_{portable(g)}" for x in ("YP", "YY", "YO")) for g in track.signals]
        self._open = [False] * len(track.signals)
        self._clear = [f"CLR_{portable(s)}" for s in track.sections]
        rules = layout.principles
        self.line_speed = rules.line_speed_kmh / 3.6
        self._limit = [None if s.speed is None else s.speed / 3.6 for s in layout.sections]
        self._numbers = 0

    @property
    def clock(self) -> float:
        """Seconds."""
        return self.agenda.clock

    # --- inputs and outputs ------------------------------------------------------------------------

    def write(self, name: str, value: int) -> None:
        """An input of the controller."""
        if self._inputs.get(name, value) != value:
            self._inputs[name] = value
            if self.changed_ms is None:
                self.changed_ms = self.agenda.now_ms

    def hold(self, section: int, more: int) -> None:
        """One thing more (or less) makes a section report occupied."""
        self._held[section] = self._held.get(section, 0) + more
        self._report(section)

    def _report(self, section: int) -> None:
        occupied = bool(self._count[section] or self._held.get(section))
        self.write(self._clear[section], int(not occupied))

    def shown(self, outputs: Mapping[str, int]) -> None:
        """The outputs of a scan reach the ground."""
        self.machines.drive(outputs)
        for g, names in enumerate(self._lit):
            now = any(outputs.get(n) for n in names)
            if now != self._open[g]:
                self._open[g] = now
                self.say("signal", signal=self.track.signals[g], open=now)
                for r in self.rolling.values():
                    if r.train.view.target == g:
                        self.agenda.after(r.build.reaction, partial(self._read, r), f"reads {r.name}")

    # --- trains come, turn, go ---------------------------------------------------------------------

    def room(self, boundary: str) -> bool:
        """No train is on the line by which trains come in over a boundary."""
        by = next(b.comes_by for b in self.track.beyond if b.name == boundary)
        return not any(d in by for t in self.trains for d in t.body)

    def comes(self, name: str, build: Build, boundary: str) -> Rolling:
        """A train comes towards a boundary, over the approach section if there is one."""
        line = next(b for b in self.track.beyond if b.name == boundary)
        first = line.comes_by[0]
        metres = self.track.stretches[first].metres
        self._numbers += 1
        t = Train(self._numbers, [first], metres - 1.0, metres - 1.0 - build.length, origin=self._numbers)
        t.driver.called = True
        t.handling = Handling(build.brakes, build.gathers, build.speed, MARGIN_M)
        t.under.looks(self.track, t.body)
        r = Rolling(name, build, t, standing(self.clock, 0.0), -t.head, -t.tail)
        self.trains.append(t)
        self.rolling[name] = r
        self.say("comes", train=name, at=boundary)
        self._drives(r)
        return r

    def turns(self, r: Rolling) -> None:
        """A standing train changes ends."""
        self._sync(r)
        r.train.turned(self.track)
        ran = r.motion.at(self.clock)[0]
        r.head_0, r.tail_0 = ran - r.train.head, ran - r.train.tail
        r.accepted = False
        self._drives(r)

    def taken_away(self, r: Rolling) -> None:
        """A train is moved off under local rules."""
        self.trains.remove(r.train)
        del self.rolling[r.name]
        self.agenda.forget(f"train {r.name}")
        self.agenda.forget(f"reads {r.name}")
        r.train.body = []
        self._recount(r)

    def _goes(self, r: Rolling) -> None:
        where = next(b.name for b in self.track.beyond if b.goes == r.train.body[-1])
        self.taken_away(r)
        self.say("leaves", train=r.name, at=where)
        self.gone(r, where)

    # --- driving -----------------------------------------------------------------------------------

    def _sync(self, r: Rolling) -> None:
        """Where a train is now."""
        ran, speed = r.motion.at(self.clock)
        t = r.train
        t.head, t.tail, t.speed = ran - r.head_0, ran - r.tail_0, speed
        t.moved = speed > 0.0

    def _read(self, r: Rolling) -> None:
        """A driver looks at the signal ahead, and acts."""
        t = r.train
        if r.name not in self.rolling or t.view.target == NONE:
            return
        self._sync(r)
        self.sight.look(t)
        if t.view.target == NONE:
            return
        told = self._open[t.view.target]
        if told == r.accepted or (told and t.speed > 0 and not self._in_sight(r)):
            return
        if not told:
            if t.speed**2 / (2 * t.handling.brakes) >= t.view.gap - 0.2:
                return  # too late: he passes it, and the route behind it must hold
            self._closed_before += 1
        if told and t.speed == 0.0:
            r.accepted = True
            self.agenda.after(SETS_OFF_S, lambda: self._drives(r), f"train {r.name}")
            return
        r.accepted = told
        self._drives(r)

    def _in_sight(self, r: Rolling) -> bool:
        """Whether a driver is so near to the signal ahead that he reads it."""
        return r.train.view.gap <= self._view(r) + ROUNDED_M

    def _view(self, r: Rolling) -> float:
        top = min(r.build.speed, self.line_speed)
        return top * r.build.reaction + top**2 / (2 * r.build.brakes) + SIGHT_M

    def _drives(self, r: Rolling) -> None:
        """A driver decides how he runs on."""
        t, now = r.train, self.clock
        self._sync(r)
        ran = r.motion.at(now)[0]
        self.sight.look(t)
        near = t.view.target != NONE and (t.speed == 0.0 or self._in_sight(r))
        if near and not r.accepted and self._open[t.view.target]:
            r.accepted = True
        to = self._until(r)
        top = min([r.build.speed, self.line_speed, *self._limits(t, to)])
        before = t.speed
        r.motion = runs(now, ran, t.speed, ran + to, top, r.build.gathers, r.build.brakes)
        if before == 0.0 and to > 0.01:
            self.watch.starts(self, t)
            self.say("runs", train=r.name, section=self._where(r))
        self._plan(r)

    def _until(self, r: Rolling) -> float:
        """Metres in which a driver means to stand."""
        t = r.train
        if r.accepted:
            return max(0.0, t.view.gap + t.view.further[0] - MARGIN_M) if t.view.further else inf
        if t.view.target == NONE:
            return max(0.0, t.view.gap) if t.driver.called else 0.0
        return max(0.0, t.view.gap - MARGIN_M) if t.driver.called else 0.0

    def _limits(self, t: Train, metres: float) -> list[float]:
        found = []
        for d, _ in self.sight.ahead(t, min(metres, 3000.0)):
            x = self.track.stretches[d].section
            limit = self._limit[x] if x != NONE else None
            if limit is not None:
                found.append(limit)
        return found

    def _plan(self, r: Rolling) -> None:
        """When something happens to a train next: never, where it stands, be it at the joint at which it derailed."""
        t, s, m = r.train, self.track.stretches, r.motion
        if t.speed == 0.0 and m.stands <= self.clock:
            self.agenda.forget(f"train {r.name}")
            return
        times = [m.when(r.head_0 + s[t.body[-1]].metres), m.when(r.tail_0 + s[t.body[0]].metres)]
        if t.view.target != NONE and not r.accepted and not self._in_sight(r):
            times.append(m.when(m.at(self.clock)[0] + t.view.gap - self._view(r)))
        stands = m.stands
        if stands > self.clock or t.speed > 0.0:
            times.append(stands)
        at = min(times)
        if at < inf:
            self.agenda.at(not_before(at), lambda: self._happens(r), f"train {r.name}")
        else:
            self.agenda.forget(f"train {r.name}")

    def _happens(self, r: Rolling) -> None:
        """A train has come to a joint, or into sight of a signal, or to a stand."""
        t, s = r.train, self.track.stretches
        was = t.speed
        self._sync(r)
        changed = passed = False
        while t.head >= s[t.body[-1]].metres - 1e-9:
            on = self._onto(t)
            if on == NONE:
                if s[t.body[-1]].outside:
                    self._goes(r)
                    return
                self.watch.derails(self, t)
                r.motion, r.accepted = standing(self.clock, r.motion.at(self.clock)[0]), False
                self._sync(r)
                break
            r.head_0 += s[t.body[-1]].metres
            t.head -= s[t.body[-1]].metres
            section = s[t.body[-1]].section
            t.body.append(on)
            changed = True
            if s[on].signal != NONE and (not t.driver.called or self.sight.obeys(t, s[on].signal)):
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
            t.under.looks(self.track, t.body)
            t.fouls(self.track)
            self._recount(r)
            for o in self.rolling.values():
                self._sync(o)
            self.watch.trains(self)
        if t.speed == 0.0 and r.motion.stands <= self.clock:
            if was > 0.0 or changed:
                self.say("stands", train=r.name, section=self._where(r))
                self.stopped(r)
            self._plan(r)
        elif passed or (not r.accepted and t.view.target != NONE):
            self._drives(r)
        else:
            self._plan(r)

    def _onto(self, t: Train) -> int:
        here = self.track.stretches[t.body[-1]]
        if here.machine == NONE:
            return here.on
        lies = self.machines.lies[here.machine]
        if here.facing is None:
            if lies != here.needs:
                self.watch.runs_over(self, t, here.machine, "runs through")
            return here.on
        if lies == NONE:
            self.watch.runs_over(self, t, here.machine, "runs onto the moving rails of")
        return here.facing[max(lies, 0)]

    def _passes(self, r: Rolling, signal: int) -> None:
        name = self.track.signals[signal]
        if r.accepted:
            self.movements += 1
            r.train.driver.called = True
        else:
            self.passed_at_stop.append(f"{self.clock:.1f} s: train {r.name} at {name}")
        r.accepted = False
        self.say("passes", train=r.name, signal=name)

    def _comes_in(self, r: Rolling, section: int, outside: bool) -> None:
        name = self.track.sections[section]
        if not outside:
            self.watch.comes_in(self, r.train, section)
        self.say("enters", train=r.name, section=name)
        self.entered(r, name)

    def _where(self, r: Rolling) -> str:
        x = self.track.stretches[r.train.body[-1]].section
        return self.track.sections[x] if x != NONE else ""

    def _recount(self, r: Rolling) -> None:
        """Sections as occupied by a train now and before."""
        s = self.track.stretches
        now = tuple(dict.fromkeys(s[d].section for d in r.train.body if s[d].section != NONE))
        for x in r.sections:
            if x not in now:
                self._count[x] -= 1
                self.say("clears", train=r.name, section=self.track.sections[x])
                self._report(x)
        for x in now:
            if x not in r.sections:
                self._count[x] += 1
                self._report(x)
        r.sections = now
