"""Drivers: they run by signals as far as they can see and brake, and stand where nothing calls them.

A driver who runs sees the next signal from where he can still stop before it; one to whom it was announced as open may
see it later, as in fog.  If it closes in his face he acts within the reaction time and brakes; whether he then stops in
rear of it or beyond is physics.  Who has passed a signal that he had accepted is called and may go on to the next one.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from math import inf, sqrt
from typing import TYPE_CHECKING

from interlock.dataclass import dataclass
from interlock.model.portable import portable
from interlock.model.principles import Caution
from interlock.simulate.called import Called, told_kmh
from interlock.simulate.sight import Sight
from interlock.simulate.track import NONE
from interlock.simulate.train import Train

if TYPE_CHECKING:
    from interlock.simulate.world import World

NEAR_M = 1.0
"""Metres before the place where he means to stand at which a driver stands: nearer he does not draw up (our choice)."""

READS_S = 1.0
"""Seconds to read a signal; a second train reads none before the first has passed it (A-HEADWAY)."""


@dataclass(frozen=True)
class Ground:
    """An overlap, or what holds of it over all of some sections: metres, and km/h for which it is made (None: any)."""

    over: frozenset[int]
    metres: float
    kmh: int | None


class Drivers:
    """All drivers of a world."""

    def __init__(self, world: World, outputs: Iterable[str]) -> None:
        self._world, self.track, self._rng = world, world.track, world.rng
        self.sight: Sight = world.sight
        layout, rules = world.layout, world.layout.principles
        self.called = Called(world)
        self.movements = 0
        """Signals passed at proceed."""
        self.passed_at_stop: list[str] = []
        self.scan_s = 0.1
        """Seconds from one scan to the next, at most, while something moves and nothing is wrong."""
        kmh = sorted({int(n.split("_", 1)[0][2:]) for n in outputs if n.startswith("YV")})
        self.speeds = [(v, [f"YV{v}_{portable(g)}" for g in self.track.signals]) for v in kmh]
        """By km/h: the outputs that show it, by signal."""
        self._reaction = rules.reaction_s
        self.three = rules.caution is not Caution.NEVER
        names = [portable(str(g.id)) for g in layout.signalling.signals]
        self.lit = [(f"YP_{n}", f"YY_{n}", f"YO_{n}", f"YW_{n}", f"YS_{n}", f"YI_{n}") for n in names]
        self._clear_out = [f"GL_{n}" for n in names]
        self._identifier_out = [f"NL_{n}" for n in names]
        self._caution_out = [f"CL_{n}" for n in names]
        self._speed_out = [f"VL_{n}" for n in names]
        line_speed = rules.line_speed_kmh / 3.6
        self._shunt_speed = min(rules.shunt_speed_kmh / 3.6, line_speed)
        self._line_speed = line_speed
        self.limit = [line_speed if s.speed is None else s.speed / 3.6 for s in layout.track.sections]
        self.fastest = max([line_speed, *self.limit])
        entry = dict(layout.overlaps.entry_speeds)
        section = {s: i for i, s in enumerate(self.track.sections)}
        self._overlaps = [
            [
                *(
                    Ground(frozenset(section[str(s)] for s in w.over), w.length, w.entry)
                    for w in layout.overlaps.ways
                    if w.signal == g.id
                ),
                Ground(frozenset(), layout.overlaps.length.get(g.id, 0.0), entry.get(g.id)),
            ]
            for g in layout.signalling.signals
        ]
        self._view = (self.fastest * self._reaction + self.fastest**2 / (2 * rules.braking_ms2)) * 1.1 + 30.0

    def overlap(self, signal: int, called: float = inf) -> Ground:
        """The overlap of a signal, as its points lie: what counts of those that may be stated.  Inside it a shorter
        one may be stated for trains that were called at no more than some km/h; `called`: how this one was."""
        stated = self._overlaps[signal]
        if len(stated) == 1:
            return stated[0]
        s, d, gone = self.track.stretches, self.track.begins[signal], 0.0
        begins: list[tuple[float, int]] = []
        while d != NONE and gone <= max(x.metres for x in stated) and not s[d].outside:
            begins.append((gone, s[d].section))
            gone += s[d].metres
            d = self.sight.follows(s[d])

        def counts(over: set[int]) -> Ground:
            return next(x for x in stated if x.over <= over)

        whole = counts({section for _, section in begins})
        short = [x for x in stated if x.kmh is not None and called <= x.kmh and x.metres < whole.metres]
        short = [x for x in short if counts({section for at, section in begins if at < x.metres}) is x]
        return min((whole, *short), key=lambda x: x.metres)

    def proceed(self, t: Train, signal: int, shown: Mapping[str, int]) -> bool | None:
        """What a driver reads: None stop, False to trains (an identifier light: nothing is meant for them here), True
        to shunting movements."""
        clear, caution, call, white, stop, identifier = self.lit[signal]
        out = self._world.reports.out
        green = shown.get(clear) and self._clear_out[signal] not in out
        yellow = shown.get(caution) and self._caution_out[signal] not in out
        if ((green or yellow or shown.get(white)) and shown.get(stop)) or (shown.get(clear) and shown.get(caution)):
            self._world.watch.contradicts(self._world, signal)
        passes = shown.get(identifier) and self._identifier_out[signal] not in out
        if passes and any(map(shown.get, (clear, caution, call, white, stop))):
            self._world.watch.contradicts(self._world, signal)
        if green or yellow or shown.get(call) or passes:
            return False
        if shown.get(white) and (t.driver.shunting or t.speed == 0.0):
            return True
        return None

    def step(self, dt: float, shown: Mapping[str, int]) -> None:
        """All trains run for a while."""
        for t in tuple(self._world.trains):
            self._drive(t, dt, shown)

    # --- running ---------------------------------------------------------------------------------

    def _drive(self, t: Train, dt: float, shown: Mapping[str, int]) -> None:
        driver = t.driver
        t.moved = False
        if t.view.at != self._world.machines.version:
            self.sight.look(t)
        if t.speed == 0.0:
            driver.rests += dt
            if driver.stuck or not driver.called or t.view.gap - t.handling.margin < NEAR_M:
                self._stands(t, dt, shown)
                if not driver.accepted:
                    return
            elif driver.rests < 1.0 + 3.0 * t.handling.margin and not driver.accepted:
                return
        self._reads(t, dt, shown)
        before, ds, free = t.speed, *self._runs(t, dt)
        if t.speed < 0.15 and free < NEAR_M:
            ds, t.speed = min(ds, max(free, 0.0)), 0.0
            driver.overruns = 0.0
        if ds <= 0.0:
            t.speed = 0.0
            return
        if before == 0.0 and driver.rests > 0.0:
            driver.rests = 0.0
            self._world.watch.starts(self._world, t)
        self._advance(t, ds)
        if self._rng.random() < self._world.faults.divide * dt:
            self._world.traffic.divide(t)

    def _runs(self, t: Train, dt: float) -> tuple[float, float]:
        """Changes its speed; the metres that it runs, and those in which its driver means to stand."""
        how = t.handling
        free = self._free(t)
        if t.driver.shunting or self.track.stretches[t.body[-1]].outside:
            free = min(free, self.sight.vehicle(t, 200.0, False) - 3.0)
        seen = t.length(self.track) / self.scan_s  # no faster than a scan can see it (A-SCAN)
        top = min(how.fastest, self._limit(t), seen)
        if t.driver.shunting:
            top = min(top, self._shunt_speed)
        before = t.speed
        wanted = min(top, sqrt(2 * how.brakes * max(0.0, free - before * dt))) if free < inf else top
        if wanted >= before:
            t.speed = min(wanted, before + how.gathers * dt)
            return (before + t.speed) / 2 * dt, free
        t.speed = max(wanted, before - how.brakes * dt)
        slows = (before - t.speed) / how.brakes
        return (before + t.speed) / 2 * slows + t.speed * (dt - slows), free

    def _free(self, t: Train) -> float:
        """Metres in which the driver means to stand, if nothing more is shown to him."""
        driver, view = t.driver, t.view
        if driver.stuck:
            return driver.overruns
        if not driver.accepted:
            return max(0.0, view.gap - t.handling.margin + driver.overruns)
        ahead = 1 if not driver.announced else 2
        if len(view.further) < ahead:
            open_ended = view.target != NONE and not view.further
            return inf if open_ended else view.gap + (view.further[-1] if view.further else 0.0)
        return max(0.0, view.gap + view.further[ahead - 1] - t.handling.margin)

    def _limit(self, t: Train) -> float:
        section = self.track.stretches[t.body[-1]].section
        return self.limit[section] if section != NONE else self._line_speed

    # --- reading signals -------------------------------------------------------------------------

    def _reads(self, t: Train, dt: float, shown: Mapping[str, int]) -> None:
        """What the driver makes of the next signal."""
        driver, view = t.driver, t.view
        if view.target == NONE:
            driver.accepted = False
            return
        if view.gap > self._view * (t.handling.clear_view if driver.expects else 1.0):
            driver.accepted = driver.expects
            return
        driver.accepted = driver.accepted or driver.expects
        told = self.proceed(t, view.target, shown)
        if told is None:
            self._closed(t, dt)
            return
        if not driver.accepted:
            if t.speed == 0.0:
                return  # see `_stands`
            driver.reads = driver.reads + dt if self.sight.vehicle(t, view.gap, True) >= view.gap else 0.0
            if driver.reads < READS_S:
                return
        announced = self.three and bool(shown.get(self.lit[view.target][0]))
        if shown.get(self.lit[view.target][5]):  # what the signal before has told him goes on
            announced = self.three and driver.expects
        if driver.announced and not announced and driver.accepted and driver.read == view.target:
            if not self._reacted(t, dt):
                return
            # clear has gone back to caution before him
            driver.late = not self._stops_within(t, view.gap + sum(view.further[:1]))
        self.accepts(t, told, shown)
        driver.announced = announced

    def accepts(self, t: Train, shunting: bool, shown: Mapping[str, int]) -> None:
        """A driver takes proceed for himself; the first time it is looked at what he is called over."""
        driver, view = t.driver, t.view
        driver.accepted, driver.reacts, driver.overruns = True, -1.0, 0.0
        if t.speed == 0.0 or not shunting:
            driver.shunting = shunting
        if not shown.get(self.lit[view.target][5]):  # what the signal before has told him goes on
            dark = self._speed_out[view.target] in self._world.reports.out
            told = inf if dark else told_kmh(self.speeds, view.target, shown)
            driver.reads_kmh = told if driver.read != view.target else max(driver.reads_kmh, told)
        elif driver.read != view.target:
            driver.reads_kmh = driver.called_kmh
        if driver.read != view.target:
            driver.read = view.target
            self.called.over(t, view.target, shown)

    def _reacted(self, t: Train, dt: float) -> bool:
        """Whether the time is over that a driver needs to act on what has changed before him."""
        driver = t.driver
        if driver.reacts < 0.0:
            driver.reacts = self._rng.uniform(0.0, self._reaction)
        driver.reacts -= dt
        if driver.reacts <= 0.0:
            driver.reacts = -1.0
            return True
        return False

    def _closed(self, t: Train, dt: float) -> None:
        """The signal ahead shows stop: to one who had accepted it, to one who brakes for it, or fails to."""
        driver, view = t.driver, t.view
        driver.reads = 0.0
        if driver.accepted:
            if self._reacted(t, dt):
                driver.late |= driver.announced and not self._stops_within(t, view.gap + sum(view.further[:1]))
                driver.committed = not self._stops_within(t, view.gap)
                driver.accepted = driver.expects = driver.announced = False
                driver.read = NONE
        elif driver.called and not driver.committed and not driver.overruns and t.speed > 1.0 and not driver.shunting:
            self._fails(t)

    @staticmethod
    def _stops_within(t: Train, metres: float) -> bool:
        return t.speed**2 / (2 * t.handling.brakes) < metres - 0.2

    def _fails(self, t: Train) -> None:
        """A driver fails to stop, within the overlap; not while points of it turn (A-OVERRUN, A-SWING)."""
        view = t.view
        metres = self.overlap(view.target, t.driver.called_kmh).metres
        if metres == inf and view.further:  # a successive one ends at the next signal
            metres = view.further[0]
        metres = min(metres, 400.0)
        near = metres and view.gap < 60.0 and self._rng.random() < self._world.faults.overrun * 0.1
        if near and self.sight.rails_lie(t, view.gap + metres):
            t.driver.overruns = t.handling.margin + metres * self._rng.uniform(0.05, 0.95)

    # --- standing --------------------------------------------------------------------------------

    def _stands(self, t: Train, dt: float, shown: Mapping[str, int]) -> None:
        """A train that may not go: it waits for a signal, turns round, divides, or is taken away in the end."""
        driver, view = t.driver, t.view
        rng, w = self._rng, self._world
        if driver.stuck or driver.rests > t.handling.patience:
            if driver.rests > t.handling.patience:
                w.traffic.taken_away(t)
            driver.accepted = False
            return
        if view.target != NONE and not driver.accepted and rng.random() < 0.3:
            told = self.proceed(t, view.target, shown)
            if told is not None and self.sight.vehicle(t, view.gap, True) >= view.gap:  # it calls the vehicle before it
                self.accepts(t, told, shown)
                driver.rests = 0.0
                return
        if not driver.accepted and rng.random() < 0.02 * dt:
            w.traffic.turns(t)
        if rng.random() < w.faults.divide * dt * 10:
            w.traffic.divide(t)

    # --- going on --------------------------------------------------------------------------------

    def _advance(self, t: Train, ds: float) -> None:
        """The head goes on over points as they lie, the tail follows."""
        driver, view = t.driver, t.view
        s, w = self.track.stretches, self._world
        changed = False
        t.moved = True
        t.head += ds
        view.gap -= ds
        if driver.stuck:
            driver.overruns = max(0.0, driver.overruns - ds)
        while t.head > s[t.body[-1]].metres:
            here = s[t.body[-1]]
            on = self._onto(t, t.body[-1])
            if on == NONE:
                if here.derails:
                    w.watch.derails(w, t)
                over = t.head - here.metres
                t.head, ds, t.speed, driver.rests = here.metres, ds - over, 0.0, 0.01
                break
            t.head -= here.metres
            t.body.append(on)
            changed = True
            if s[on].signal != NONE and (not driver.called or self.sight.obeys(t, s[on].signal)):
                self._passes(t, s[on].signal)
                view.at = -1
            if s[on].section != here.section and not s[on].outside:
                w.watch.comes_in(w, t, s[on].section)
        t.tail += ds
        while len(t.body) > 1 and t.tail > s[t.body[0]].metres:
            t.tail -= s[t.body[0]].metres
            t.body.pop(0)
            changed = True
        if changed:
            t.under.looks(self.track, t.body)
        if s[t.body[-1]].outside and s[t.body[0]].outside and t.body[0] == t.body[-1] and s[t.body[0]].on == NONE:
            if t.head > s[t.body[0]].metres - 50.0:
                w.trains.remove(t)
            return
        t.fouls(self.track)
        if view.at == -1:
            self.sight.look(t)

    def _onto(self, t: Train, d: int) -> int:
        """The stretch that follows for a train at the end of one, over points as they lie."""
        here, w = self.track.stretches[d], self._world
        if here.machine == NONE:
            return here.on
        lies = w.machines.lies[here.machine]
        if here.facing is None:
            if lies != here.needs:
                w.watch.runs_over(w, t, here.machine, "runs through")
            return here.on
        if lies == NONE:
            w.watch.runs_over(w, t, here.machine, "runs onto the moving rails of")
        return here.facing[max(lies, 0)]

    def _passes(self, t: Train, signal: int) -> None:
        """The head passes a signal that counts: accepted, or closed when it was too late to stop, or overrun."""
        driver = t.driver
        if driver.accepted or driver.committed:
            self.movements += driver.accepted
            driver.called_kmh = driver.reads_kmh
            driver.expects, driver.called, driver.overruns = driver.accepted and driver.announced, True, 0.0
        else:
            if not driver.overruns:
                self.passed_at_stop.append(f"train {t.number} at {self.track.signals[signal]}")
            driver.overruns, driver.stuck = max(1.0, driver.overruns - t.handling.margin - t.head), True
        driver.accepted = driver.announced = False
        driver.reacts, driver.reads, driver.read = -1.0, 0.0, NONE
        driver.committed, driver.late = driver.late, False
        driver.rests = 0.0
