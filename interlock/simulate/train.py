"""A vehicle: where it lies in metres, how fast it runs, what its driver has been told, and what lies ahead of him.

`body` lists the stretches under it from tail to head; `head` is how far the head is on the last one, `tail` how far the
tail is on the first.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import field
from math import inf

from interlock.dataclass import dataclass
from interlock.simulate.track import NONE, Track


@dataclass(slots=True)
class Handling:
    """How a train is built and driven; metres, metres per second, m/s^2, seconds."""

    brakes: float = 0.6
    gathers: float = 0.5
    fastest: float = 22.2
    margin: float = 2.0
    """Before a signal at which it stands."""
    clear_view: float = 1.0
    """From which part of the braking distance a signal is seen that was announced as open."""
    patience: float = 600.0
    """For how long it stands until it is taken away."""


@dataclass(slots=True)
class Driver:
    """What a driver has been told and does.  `called`: by a signal, and may run to the next one that he obeys."""

    shunting: bool = False
    called: bool = False
    accepted: bool = False
    """He has seen proceed at the next signal and has not taken note of anything else."""
    expects: bool = False
    """The signal passed last told that the next one shows proceed (clear, where caution announces stop)."""
    announced: bool = False
    """The signal ahead shows that the next one shows proceed."""
    committed: bool = False
    """The signal ahead closed when it was perhaps too late to stop in rear of it."""
    late: bool = False
    """So did the one after it, or what announces it."""
    read: int = NONE
    """The signal that he has last accepted by its lamps."""
    reads_kmh: float = inf
    """The highest speed that the signal ahead has permitted since he accepted it."""
    called_kmh: float = inf
    """The speed that the signal passed last permitted; any, where it told none."""
    reads: float = 0.0
    """Seconds for which proceed has been shown, with nothing between him and the signal."""
    reacts: float = -1.0
    """Seconds until he acts on a stop that he sees; negative: nothing is pending."""
    overruns: float = 0.0
    """Metres by which he fails to stop."""
    stuck: bool = False
    rests: float = 0.0
    """Seconds for which the train has stood."""


@dataclass(slots=True)
class View:
    """What lies ahead of a train, as looked up last."""

    gap: float = 0.0
    """Metres from the head to what it must stop for; `target`: that signal, or NONE."""
    target: int = NONE
    signals: tuple[int, ...] = ()
    """Those that it will meet one after the other, as points lie."""
    further: tuple[float, ...] = ()
    """Metres from the next thing to stop for to those after it."""
    at: int = -1
    """How often rails had been laid otherwise when it was looked up; -1: it is to be looked up again."""


@dataclass(slots=True)
class Under:
    """What lies under a train: edges, sections, and foul ground as bits of points and diamonds, one number a side."""

    edges: frozenset[int] = frozenset()
    sections: tuple[int, ...] = ()
    zones: tuple[int, int] = (0, 0)

    def looks(self, track: Track, body: Sequence[int]) -> None:
        """Edges and sections, after the body has changed."""
        s = track.stretches
        self.edges = frozenset(s[d].edge for d in body)
        self.sections = tuple(dict.fromkeys(x for x in (s[d].section for d in body) if x != NONE))


@dataclass(slots=True, eq=False)
class Train:
    """One train or shunting movement; metres, seconds, metres per second.

    origin: the number of the train of which it was a part; moved: it is where it was not when this was last asked.
    """

    number: int
    body: list[int]
    head: float
    tail: float
    speed: float = 0.0
    origin: int = 0
    moved: bool = True
    handling: Handling = field(default_factory=Handling)
    driver: Driver = field(default_factory=Driver)
    view: View = field(default_factory=View)
    under: Under = field(default_factory=Under)

    def span(self, track: Track, d: int) -> tuple[float, float]:
        """Metres of an edge under it, from the edge's end a, for the stretch `d` of its body."""
        first, last = self.body[0] == d, self.body[-1] == d
        lo, hi = (self.tail if first else 0.0), (self.head if last else track.stretches[d].metres)
        if d & 1:
            m = track.stretches[d].metres
            return m - hi, m - lo
        return lo, hi

    def fouls(self, track: Track) -> None:
        """The foul ground under it: bits of points and diamonds, one number for each side."""
        sides = [0, 0]
        for d in self.body:
            zones = track.zones.get(d >> 1)
            if zones:
                lo, hi = self.span(track, d)
                for zone, side, a, b in zones:
                    if lo < b and hi > a:
                        sides[side] |= 1 << zone
        self.under.zones = (sides[0], sides[1])

    def turned(self, track: Track) -> None:
        """It changes ends."""
        self.driver.called_kmh = inf
        last = track.stretches[self.body[-1]].metres
        first = track.stretches[self.body[0]].metres
        self.body = [d ^ 1 for d in reversed(self.body)]
        self.head, self.tail = first - self.tail, last - self.head
        driver = self.driver
        driver.called = driver.accepted = driver.expects = driver.committed = driver.late = driver.announced = False
        driver.read = NONE
        self.view.at = -1

    def length(self, track: Track) -> float:
        """Its length in metres."""
        if len(self.body) == 1:
            return self.head - self.tail
        between = sum(track.stretches[d].metres for d in self.body[:-1])
        return between - self.tail + self.head
