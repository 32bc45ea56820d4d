"""Drivers: they appear on lines, run by signals as far as they can see and brake, turn round, divide, and leave.

A driver who runs sees the next signal from where he can still stop before it.  If it closes in his face he acts within
the reaction time and brakes; whether he then stops in rear of it or beyond is physics.  Who has passed a signal that he
had accepted is called and may go on to the next one.
"""

from __future__ import annotations

from collections.abc import Mapping
from math import inf, sqrt
from typing import TYPE_CHECKING

from interlock.model.elements import BlockKind
from interlock.model.portable import portable
from interlock.model.principles import Caution
from interlock.simulate.track import NONE, Beyond
from interlock.simulate.train import Train

if TYPE_CHECKING:
    from interlock.simulate.world import World

LOOK_M = 3000.0
READS_S = 1.0
"""Seconds to read a signal; a second train reads none before the first has passed it (A-HEADWAY)."""


class Drivers:
    """All drivers of a world."""

    def __init__(self, world: World) -> None:
        self.world, self.track, self.rng = world, world.track, world.rng
        layout, rules = world.layout, world.rules
        self.reaction = rules.reaction_s
        self.main = [g.main for g in layout.signals]
        self.three = rules.caution is Caution.NEXT
        names = [portable(str(g.id)) for g in layout.signals]
        self.lit = [(f"YP_{n}", f"YY_{n}", f"YO_{n}", f"YW_{n}") for n in names]
        self.clear_out = [f"GL_{n}" for n in names]
        self.caution_out = [f"CL_{n}" for n in names]
        self.line_speed = rules.line_speed_kmh / 3.6
        self.shunt_speed = min(rules.shunt_speed_kmh / 3.6, self.line_speed)
        stated = [s.speed / 3.6 if s.speed is not None else None for s in layout.sections]
        self.limit = [self.line_speed if v is None else v for v in stated]
        self.overlap = {i: layout.overlap_of.get(g.id, 0.0) for i, g in enumerate(layout.signals)}
        self.sight = (self.line_speed * self.reaction + self.line_speed**2 / (2 * rules.braking_ms2)) * 1.1 + 30.0

    # --- coming and going -----------------------------------------------------------------------

    def new(self, body: list[int], head: float, tail: float) -> Train:
        """A train with a temper of its own."""
        rng, rules = self.rng, self.world.rules
        t = Train(self.world.new_number(), body, head, tail)
        t.origin = t.number
        t.brakes = rules.braking_ms2 * rng.uniform(1.0, 1.5)
        t.gathers = rng.uniform(0.3, 0.8)
        t.fastest = self.line_speed * rng.choice((0.4, 0.8, 1.0, 1.0))
        t.margin = rng.choice((1.0, 2.0, 5.0, 15.0))
        t.patience = rng.uniform(100.0, 500.0)
        t.looks(self.track)
        t.fouls(self.track)
        self.world.trains.append(t)
        return t

    def place(self) -> None:
        """A train stands somewhere in the layout, whatever lies under it (R9 at a restart)."""
        rng, s = self.rng, self.track.stretches
        inside = [i for i, x in enumerate(s) if not x.outside]
        d = rng.choice(inside)
        tail = rng.uniform(0.0, s[d].metres)
        body, left = [d], rng.choice((15.0, 40.0, 80.0, 150.0)) - (s[d].metres - tail)
        while left > 0:
            ends = s[d].facing
            d = rng.choice(ends) if ends is not None else s[d].on
            if d == NONE or s[d].outside or s[d].derails or d in body or d ^ 1 in body:
                return
            body.append(d)
            left -= s[d].metres
        t = self.new(body, s[d].metres + left, tail)
        w = self.world
        if any(o is not t and (not t.edges.isdisjoint(o.edges) or self._foul(t, o)) for o in w.trains):
            w.trains.remove(t)

    @staticmethod
    def _foul(a: Train, b: Train) -> bool:
        return bool((a.zones[0] & b.zones[1]) | (a.zones[1] & b.zones[0]))

    def _comes(self, line: Beyond) -> None:
        """A train appears at the far end of a line, if nothing else is on the part where it appears."""
        w, s = self.world, self.track.stretches
        far = line.comes
        if any(t.body[0] == far for t in w.trains):
            return
        if line.block is BlockKind.TOKEN:
            if not w.token_at[line.name].may_send():
                return
            w.token_at[line.name].sends = False
        elif any(t.body[0] in line.comes_by for t in w.trains) and self.rng.random() < 0.8:
            return
        length = self.rng.choice((12.0, 30.0, 60.0, 120.0, 250.0))
        head = s[far].metres - (self.rng.random() * 100.0 if line.approach_m else 100.0)
        t = self.new([far], head, head - length)
        t.called, t.speed = True, 0.5 * t.fastest
        t.patience = self.rng.uniform(60.0, 400.0)

    # --- looking ahead ---------------------------------------------------------------------------

    def obeys(self, t: Train, signal: int) -> bool:
        """A train obeys main signals, a shunting movement all."""
        return signal != NONE and (self.main[signal] or t.shunting)

    def look(self, t: Train) -> None:
        """How far to the next thing to stop for (a signal, the end of the track), and from there to the next ones."""
        s, w = self.track.stretches, self.world
        d, gap = t.body[-1], -t.head
        first = s[d].section
        t.target, t.further = NONE, ()
        signals: list[int] = []
        t.seen_at = w.machines.version
        called = t.called
        stops: list[float] = []
        while gap < LOOK_M and len(stops) < 3:
            gap += s[d].metres
            on = s[d].on
            ends = s[d].facing
            if ends is not None:
                lies = w.machines.lies[s[d].machine]
                on = ends[lies] if lies != NONE else ends[w.machines.target[s[d].machine]]
            if on == NONE:
                stops.append(gap - 3.0 if called else 0.0)
                break
            signal = s[on].signal
            if signal != NONE and (self.obeys(t, signal) or not called):
                if not stops:
                    t.target = signal
                stops.append(gap)
                signals.append(signal)
                called = True
            elif not called and s[on].section != first:
                stops.append(0.0)
                break
            if s[on].outside and s[on].on == NONE:
                break
            d = on
        t.ahead = tuple(signals)
        t.gap = stops[0] if stops else inf
        t.further = tuple(x - t.gap for x in stops[1:])

    def proceed(self, t: Train, signal: int, shown: Mapping[str, int]) -> bool | None:
        """What a driver reads: None stop, False to trains, True to shunting movements."""
        clear, caution, call, white = self.lit[signal]
        out = self.world.out
        if (shown.get(clear) and self.clear_out[signal] not in out) or (
            shown.get(caution) and self.caution_out[signal] not in out
        ):
            return False
        if shown.get(call):
            return False
        if shown.get(white) and (t.shunting or t.speed == 0.0):
            return True
        return None

    # --- running ---------------------------------------------------------------------------------

    def step(self, dt: float, shown: Mapping[str, int]) -> None:
        """All trains run for a while; others appear."""
        w = self.world
        for t in tuple(w.trains):
            self._drive(t, dt, shown)
        if len(w.trains) < w.most and self.rng.random() < 0.1 * dt:
            lines = [b for b in self.track.beyond if b.comes != NONE]
            full = sum(any(t.body[0] in b.comes_by for t in w.trains) for b in lines)
            if lines and 2 * full < len(lines) + 1 - self.rng.randrange(2):
                self._comes(self.rng.choice(lines))

    def _drive(self, t: Train, dt: float, shown: Mapping[str, int]) -> None:
        t.moved = False
        if t.seen_at != self.world.machines.version:
            self.look(t)
        if t.speed == 0.0:
            t.rests += dt
            if t.stuck or not t.called or t.gap - t.margin < 0.5:
                self._stands(t, dt, shown)
                if not t.accepted:
                    return
            elif t.rests < 1.0 + 3.0 * t.margin and not t.accepted:
                return
        self._reads(t, dt, shown)
        free = self._free(t)
        if t.shunting or self.track.stretches[t.body[-1]].outside:
            free = min(free, self.vehicle(t, 200.0, False) - 3.0)
        top = min(t.fastest, self._limit(t))
        if t.shunting:
            top = min(top, self.shunt_speed)
        wanted = min(top, sqrt(2 * t.brakes * max(0.0, free - t.speed * dt))) if free < inf else top
        before = t.speed
        if wanted >= t.speed:
            t.speed = min(wanted, t.speed + t.gathers * dt)
        else:
            t.speed = max(wanted, t.speed - t.brakes * dt)
        ds = (before + t.speed) / 2 * dt
        if t.speed < 0.15 and free < 1.0:
            ds, t.speed = min(ds, max(free, 0.0)), 0.0
            t.overruns = 0.0
        if ds <= 0.0:
            t.speed = 0.0
            return
        if before == 0.0 and t.rests > 0.0:
            t.rests = 0.0
            self.world.watch.starts(self.world, t)
        self._advance(t, ds)

    def _free(self, t: Train) -> float:
        """Metres in which the driver means to stand, if nothing more is shown to him."""
        if t.stuck:
            return t.overruns
        if not t.accepted:
            return max(0.0, t.gap - t.margin + t.overruns)
        ahead = 1 if not t.announced else 2
        if len(t.further) < ahead:
            return inf if t.target != NONE and not t.further else t.gap + (t.further[-1] if t.further else 0.0)
        return max(0.0, t.gap + t.further[ahead - 1] - t.margin)

    def _limit(self, t: Train) -> float:
        section = self.track.stretches[t.body[-1]].section
        return self.limit[section] if section != NONE else self.line_speed

    def _reads(self, t: Train, dt: float, shown: Mapping[str, int]) -> None:
        """What the driver makes of the next signal."""
        if t.target == NONE:
            t.accepted = False
            return
        if t.gap > self.sight:
            t.accepted = t.expects
            return
        told = self.proceed(t, t.target, shown)
        if told is not None:
            if not t.accepted:
                if t.speed == 0.0:
                    return  # see `_stands`
                t.reads = t.reads + dt if self.vehicle(t, t.gap, True) >= t.gap else 0.0
                if t.reads < READS_S:
                    return
            t.accepted, t.reacts, t.overruns = True, -1.0, 0.0
            t.announced = self.three and bool(shown.get(self.lit[t.target][0]))
            if t.speed == 0.0 or told is False:
                t.shunting = told
            return
        t.reads = 0.0
        if t.accepted:
            if t.reacts < 0.0:
                t.reacts = self.rng.uniform(0.0, self.reaction)
            t.reacts -= dt
            if t.reacts <= 0.0:
                t.accepted, t.expects, t.reacts, t.announced = False, False, -1.0, False
                t.committed = True
        elif t.overruns == 0.0 and t.speed > 1.0 and not t.shunting and t.called and not t.committed:
            self._fails(t)

    def _fails(self, t: Train) -> None:
        """A driver fails to stop, within the overlap; no longer once points are moving (A-OVERRUN, A-SWING)."""
        metres, f = self.overlap[t.target], self.world.faults.overrun
        if metres and t.gap < 60.0 and self.rng.random() < f * 0.1 and NONE not in self.world.machines.lies:
            t.overruns = t.margin + min(metres, 100.0) * self.rng.uniform(0.05, 0.95)

    def vehicle(self, t: Train, reach: float, anywhere: bool) -> float:
        """Metres to the next vehicle ahead within reach: anywhere, or where it is looked out for (lines, berths)."""
        s, w = self.track.stretches, self.world
        if len(w.trains) < 2:
            return inf
        d, gap = t.body[-1], -t.head
        while gap < reach:
            if anywhere or s[d].outside or s[d].section in self.track.berths:
                nearest = inf
                for o in w.trains:
                    if o is not t and d >> 1 in o.edges:
                        nearest = min(nearest, self._on(o, d, gap))
                if nearest < inf:
                    return nearest
            gap += s[d].metres
            on, ends = s[d].on, s[d].facing
            if ends is not None:
                lies = w.machines.lies[s[d].machine]
                on = ends[lies] if lies != NONE else NONE
            if on == NONE:
                return inf
            d = on
        return inf

    def _on(self, o: Train, d: int, gap: float) -> float:
        """Metres to a vehicle on a stretch that begins `gap` metres ahead; infinite where it lies behind."""
        metres, nearest = self.track.stretches[d].metres, inf
        for e in o.body:
            if e >> 1 == d >> 1:
                lo, hi = o.span(self.track, e)
                rear, front = (metres - hi, metres - lo) if d & 1 else (lo, hi)
                if gap + front > 0.0:
                    nearest = min(nearest, max(0.0, gap + rear))
        return nearest

    def _stands(self, t: Train, dt: float, shown: Mapping[str, int]) -> None:
        """A train that may not go: it waits for a signal, turns round, divides, or is taken away in the end."""
        rng, w = self.rng, self.world
        if t.stuck or t.rests > t.patience:
            if t.rests > t.patience:
                w.trains.remove(t)  # moved under local rules
            t.accepted = False
            return
        if t.target != NONE and not t.accepted and rng.random() < 0.3:
            told = self.proceed(t, t.target, shown)
            if told is not None and self.vehicle(t, t.gap, True) >= t.gap:  # the signal calls the vehicle before it
                t.accepted, t.shunting, t.rests = True, told, 0.0
                return
        if not t.accepted and rng.random() < 0.02 * dt:
            self._turns(t)
        if rng.random() < w.faults.divide * dt * 10:
            self.divide(t)

    def _turns(self, t: Train) -> None:
        """It changes ends, wholly within one section at the end of which a signal governs its new way (A-REVERSE)."""
        s = self.track.stretches
        if len(t.sections) != 1 or any(s[d].outside for d in t.body):
            return
        d = t.body[0] ^ 1
        first = s[d].section
        for _ in range(50):
            ends = s[d].facing
            lies = self.world.machines.lies[s[d].machine] if ends is not None else 0
            on = s[d].on if ends is None else ends[lies] if lies != NONE else NONE
            if on == NONE:
                return
            if s[on].section != first:
                if s[on].signal != NONE:
                    t.turned(self.track)
                    t.committed = t.announced = False
                return
            d = on

    def divide(self, t: Train) -> None:
        """It parts: the rear stays and is a vehicle of its own."""
        length = t.length(self.track)
        if length < 25.0 or any(self.track.stretches[d].outside for d in t.body):
            return
        rear, s = length * self.rng.uniform(0.2, 0.8), self.track.stretches
        body, at, d = [t.body[0]], t.tail + rear, 0
        while at > s[t.body[d]].metres:
            at -= s[t.body[d]].metres
            d += 1
            body.append(t.body[d])
        left = self.new(body, at, t.tail)
        left.origin, left.shunting, left.called, left.moved = t.origin, t.shunting, False, False
        left.stuck = not set(left.sections) <= self.track.berths  # wagons without an engine
        t.body, t.tail = t.body[d:], at + 0.5
        if t.tail > s[t.body[0]].metres and len(t.body) > 1:
            t.tail -= s[t.body[0]].metres
            t.body = t.body[1:]
        t.looks(self.track)
        t.fouls(self.track)

    def _advance(self, t: Train, ds: float) -> None:
        """The head goes on over points as they lie, the tail follows."""
        s, w = self.track.stretches, self.world
        changed = False
        t.moved = True
        t.head += ds
        t.gap -= ds
        if t.stuck:
            t.overruns = max(0.0, t.overruns - ds)
        while t.head > s[t.body[-1]].metres:
            here = s[t.body[-1]]
            on = here.on
            if here.machine != NONE:
                lies = w.machines.lies[here.machine]
                if here.facing is not None:
                    if lies == NONE:
                        w.watch.runs_over(w, t, here.machine, "runs onto the moving rails of")
                    on = here.facing[max(lies, 0)]
                elif lies != here.needs:
                    w.watch.runs_over(w, t, here.machine, "runs through")
            if on == NONE:
                if here.derails:
                    w.watch.derails(w, t)
                over = t.head - here.metres
                t.head, ds, t.speed, t.rests = here.metres, ds - over, 0.0, 0.01
                break
            t.head -= here.metres
            t.body.append(on)
            changed = True
            if s[on].signal != NONE and (not t.called or self.obeys(t, s[on].signal)):
                self._passes(t, s[on].signal)
                t.seen_at = -1
        t.tail += ds
        while len(t.body) > 1 and t.tail > s[t.body[0]].metres:
            t.tail -= s[t.body[0]].metres
            t.body.pop(0)
            changed = True
        if changed:
            t.looks(self.track)
        if s[t.body[-1]].outside and s[t.body[0]].outside and t.body[0] == t.body[-1] and s[t.body[0]].on == NONE:
            if t.head > s[t.body[0]].metres - 50.0:
                w.trains.remove(t)
            return
        t.fouls(self.track)
        if t.seen_at == -1:
            self.look(t)

    def _passes(self, t: Train, signal: int) -> None:
        """The head passes a signal that counts: accepted, or closed when it was too late to stop, or overrun."""
        if t.accepted or t.committed:
            self.world.movements += 1
            t.expects, t.called, t.overruns = t.accepted and t.announced, True, 0.0
        else:
            if not t.overruns:
                self.world.passed_at_stop.append(f"train {t.number} at {self.track.signals[signal]}")
            t.overruns, t.stuck = max(1.0, t.overruns - t.margin - t.head), True
        t.accepted, t.reacts, t.committed, t.announced, t.reads = False, -1.0, False, False, 0.0
        t.rests = 0.0
