"""A vehicle: where it lies in metres, how fast it runs, and what its driver knows.

`body` lists the stretches under it from tail to head; `head` is how far the head is on the last one, `tail` how far the
tail is on the first.  `called`: it was called by a signal and may run to the next one that it obeys.
"""

from __future__ import annotations

from dataclasses import dataclass

from interlock.simulate.track import NONE, Track


@dataclass
class Train:
    """One train or shunting movement; metres, seconds, metres per second."""

    number: int
    body: list[int]
    head: float
    tail: float
    speed: float = 0.0
    shunting: bool = False
    called: bool = False
    accepted: bool = False
    """The driver has seen proceed at the next signal and has not taken note of anything else."""
    expects: bool = False
    """The signal passed last told that the next one shows proceed (clear, where caution announces stop)."""
    announced: bool = False
    """The signal ahead shows that the next one shows proceed."""
    committed: bool = False
    """The signal ahead closed when it was perhaps too late to stop in rear of it."""
    late: bool = False
    """So did the one after it, or what announces it."""
    read: int = NONE
    """The signal that it has last accepted by its lamps."""
    clear_view: float = 1.0
    """From which part of the braking distance a signal is seen that was announced as open."""
    further: tuple[float, ...] = ()
    """Metres from the next thing to stop for to those after it."""
    reads: float = 0.0
    """Seconds for which proceed has been shown, with nothing between the driver and the signal."""
    reacts: float = -1.0
    """Seconds until the driver acts on a stop that he sees; negative: nothing is pending."""
    brakes: float = 0.6
    gathers: float = 0.5
    fastest: float = 22.2
    margin: float = 2.0
    overruns: float = 0.0
    stuck: bool = False
    rests: float = 0.0
    """Seconds for which it has stood."""
    patience: float = 600.0
    origin: int = 0
    gap: float = 0.0
    """Metres from the head to what it must stop for, as looked up last; `target`: that signal, or NONE."""
    target: int = NONE
    ahead: tuple[int, ...] = ()
    """The signals ahead that it will meet one after the other, as points lie."""
    seen_at: int = -1
    moved: bool = True
    edges: frozenset[int] = frozenset()
    sections: tuple[int, ...] = ()
    zones: tuple[int, int] = (0, 0)

    def looks(self, track: Track) -> None:
        """Edges and sections under it, after its body has changed."""
        s = track.stretches
        self.edges = frozenset(s[d].edge for d in self.body)
        self.sections = tuple(dict.fromkeys(x for x in (s[d].section for d in self.body) if x != NONE))

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
        self.zones = (sides[0], sides[1])

    def turned(self, track: Track) -> None:
        """It changes ends."""
        last = track.stretches[self.body[-1]].metres
        first = track.stretches[self.body[0]].metres
        self.body = [d ^ 1 for d in reversed(self.body)]
        self.head, self.tail = first - self.tail, last - self.head
        self.called = self.accepted = self.expects = self.committed = self.late = self.announced = False
        self.read = NONE
        self.seen_at = -1

    def length(self, track: Track) -> float:
        """Its length in metres."""
        if len(self.body) == 1:
            return self.head - self.tail
        between = sum(track.stretches[d].metres for d in self.body[:-1])
        return between - self.tail + self.head
