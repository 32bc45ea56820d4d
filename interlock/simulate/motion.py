"""How a train runs, in closed form: it gathers speed, keeps it, and brakes so as to stand where its driver means to.

Metres are counted from where the train was put on the rails; seconds are those of the world's clock.
"""

from __future__ import annotations

from math import inf, sqrt

from interlock.dataclass import dataclass

STANDS = 1e-9


@dataclass(frozen=True)
class Phase:
    """From a time on: at `metres`, with `speed` and `rate` (metres, m/s, m/s^2), until the next phase."""

    since: float
    metres: float
    speed: float
    rate: float


@dataclass(frozen=True)
class Motion:
    """A train's way through the next minutes: phases in the order of time, the last of which goes on for ever."""

    phases: tuple[Phase, ...]

    def at(self, time: float) -> tuple[float, float]:
        """Metres and speed at a time not before the first phase."""
        p = next((p for p in reversed(self.phases) if p.since <= time), self.phases[0])
        dt = max(0.0, time - p.since)
        return p.metres + p.speed * dt + p.rate * dt * dt / 2, max(0.0, p.speed + p.rate * dt)

    def when(self, metres: float) -> float:
        """The time at which the train has run so many metres; infinite where it stands before."""
        ends = [q.metres for q in self.phases[1:]]
        for p, end in zip(self.phases, [*ends, inf], strict=True):
            if metres <= p.metres:
                return p.since
            if metres <= end:
                return p.since + _takes(p, metres - p.metres)
        return inf

    @property
    def stands(self) -> float:
        """The time from which on it stands; infinite where it runs on."""
        last = self.phases[-1]
        return last.since if last.speed < STANDS and last.rate <= 0 else inf


def _takes(p: Phase, metres: float) -> float:
    """Seconds for the first so many metres of a phase."""
    if abs(p.rate) < STANDS:
        return metres / p.speed if p.speed > STANDS else inf
    under = p.speed**2 + 2 * p.rate * metres
    if under < 0:
        return inf if under < -1e-6 else -p.speed / p.rate
    return (sqrt(under) - p.speed) / p.rate


def standing(time: float, metres: float) -> Motion:
    """It stands."""
    return Motion((Phase(time, metres, 0.0, 0.0),))


def runs(time: float, metres: float, speed: float, to: float, top: float, gathers: float, brakes: float) -> Motion:
    """It runs on from so many metres and stands at `to` (infinite: nowhere), at `top` speed at most.

    One that cannot stop there brakes all the same, and stands as soon as it can.
    """
    if to - metres <= 0.01 and speed < 0.01:
        return standing(time, metres)
    phases = [Phase(time, metres, speed, -brakes)]
    if speed > top:  # down to what is allowed
        dt = (speed - top) / brakes
        time, metres, speed = time + dt, metres + (speed + top) / 2 * dt, top
    room = to - metres
    if room < speed**2 / (2 * brakes):
        first = phases[0]
        dt = first.speed / brakes
        return Motion((first, Phase(first.since + dt, first.metres + first.speed * dt / 2, 0.0, 0.0)))
    if phases[0].since == time:
        phases.clear()
    peak = (
        top if room == inf else min(top, sqrt((2 * gathers * brakes * room + brakes * speed**2) / (gathers + brakes)))
    )
    if peak > speed:
        phases.append(Phase(time, metres, speed, gathers))
        dt = (peak - speed) / gathers
        time, metres = time + dt, metres + (speed + peak) / 2 * dt
    phases.append(Phase(time, metres, peak, 0.0))
    if room == inf:
        return Motion(tuple(phases))
    begins = to - peak**2 / (2 * brakes)
    time += max(0.0, begins - metres) / peak
    phases.append(Phase(time, max(metres, begins), peak, -brakes))
    phases.append(Phase(time + peak / brakes, to, 0.0, 0.0))
    return Motion(tuple(phases))
