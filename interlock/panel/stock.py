"""The trains of the simulated railway, as a person at the panel handles them."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from math import inf
from random import Random

from interlock.model.elements import BlockKind
from interlock.model.layout import Layout
from interlock.simulate.faults import NO_FAULTS
from interlock.simulate.neighbour import Neighbour
from interlock.simulate.track import NONE, Beyond, Track
from interlock.simulate.traffic import Traffic
from interlock.simulate.train import Handling, Train
from interlock.simulate.world import World

LENGTH_M = 40.0
"""Metres of a train of which nothing else is said."""


class Impossible(Exception):
    """What is asked of the railway cannot be done; the message says why."""


class _Steady(Random):
    """Draws that make nothing happen by chance: telegrams arrive in order and whole."""

    def random(self) -> float:
        return 0.5


class _Neighbour(Neighbour):
    """A neighbour whose telegrams arrive, and who wants to send when a train is to come from him."""

    def __init__(self, world: World, line: Beyond) -> None:
        self.steady = _Steady(1)
        super().__init__(world, line)
        self.have = False

    def step(self, shown: Mapping[str, int]) -> None:
        """One exchange."""
        rng, self.world.rng = self.world.rng, self.steady
        try:
            super().step(shown)
        finally:
            self.world.rng = rng


class _OnCommand(Traffic):
    """Trains come, turn round and are taken away only when somebody says so."""

    def new(self, body: list[int], head: float, tail: float) -> Train:
        """A train whose driver is as all others here, and waits as long as he has to."""
        t = super().new(body, head, tail)
        t.handling = Handling(
            brakes=1.2 * self.world.layout.principles.braking_ms2, gathers=0.6, fastest=self.fastest, patience=inf
        )
        return t

    def come(self, dt: float) -> None:
        """By itself nothing comes."""

    def turns(self, t: Train) -> None:
        """By itself nothing turns."""

    def taken_away(self, t: Train) -> None:
        """By itself nothing is taken away."""

    def turn(self, t: Train) -> bool:
        """Turn a train round where it may (A-REVERSE); whether it did."""
        before = list(t.body)
        super().turns(t)
        return t.body != before


class CommandedWorld(World):
    """A world without chance."""

    def __init__(self, layout: Layout, inputs: Mapping[str, tuple[int, int]], outputs: Iterable[str]) -> None:
        track = Track.of(layout)
        super().__init__(layout, track, inputs, outputs, Random(layout.name), NO_FAULTS)
        self.trains.clear()
        self.watch.found.clear()
        for m in range(len(self.machines.names)):
            self.machines.position[m] = self.machines.target[m] = 0
            self.machines.lay(m, 0)
        self.commanded = _OnCommand(self, self.drivers.fastest)
        self.traffic = self.commanded
        self.neighbours = {b.name: _Neighbour(self, b) for b in track.beyond if b.block is BlockKind.TOKEN}


class Stock:
    """The trains of a railway, by the names that people give them: put down, brought, held, turned, divided."""

    def __init__(self, world: CommandedWorld) -> None:
        self._world = world
        self.names: dict[int, str] = {}
        self.coming: list[tuple[Beyond, float, str]] = []
        """Trains that wait to come in: over which boundary, metres, name."""
        self._fastest: dict[int, float] = {}

    def train(self, name: str) -> Train:
        """A train by its name.  Raises `Impossible`."""
        for t in self._world.trains:
            if self.names.get(t.number) == name:
                return t
        raise Impossible(f"there is no train {name}")

    def name_of(self, t: Train) -> str:
        """What a train is called; one that nobody has named by its number."""
        if t.number not in self.names:
            self.names[t.number] = self._free(f"T{t.number}")
        return self.names[t.number]

    def _free(self, wanted: str) -> str:
        taken = {self.names.get(t.number) for t in self._world.trains} | {n for _, _, n in self.coming}
        return next(n for n in (wanted, *(f"{wanted}.{k}" for k in range(2, 10_000))) if n not in taken)

    def _named(self, name: str) -> str:
        return self._free(name.strip()[:12] or f"T{self._world.traffic.numbers + len(self.coming) + 1}")

    def stand(self, section: str, towards: str, metres: float, name: str) -> str:
        """Put a train on a section, standing, with its head in one of the directions of `places`; its name.

        Raises `Impossible`.
        """
        d = next((d for d, x in self.places().get(section, ()) if x == towards), None)
        if d is None:
            raise Impossible(f"no train can stand in {section} towards {towards or 'nothing'}")
        s = self._world.track.stretches[d]
        head = s.metres - min(5.0, s.metres / 4)
        length = min(metres, head - min(1.0, s.metres / 8))
        if any(s.edge in t.under.edges and self._near(t, d, head - length, head) for t in self._world.trains):
            raise Impossible(f"another train stands there in {section}")
        t = self._world.traffic.new([d], head, head - length)
        self.names[t.number] = name = self._named(name)
        return name

    def _near(self, t: Train, d: int, lo: float, hi: float) -> bool:
        m = self._world.track.stretches[d].metres
        low, high = (m - hi, m - lo) if d & 1 else (lo, hi)
        spans = [t.span(self._world.track, e) for e in t.body if e >> 1 == d >> 1]
        return any(a < high + 1.0 and low - 1.0 < b for a, b in spans)

    def places(self) -> dict[str, list[tuple[int, str]]]:
        """By section: where a train can be put, as stretch and the name of what it looks to."""
        track, layout = self._world.track, self._world.layout
        found: dict[str, list[tuple[int, str]]] = {}
        longest: dict[int, int] = {}
        for d, s in enumerate(track.stretches):
            if not s.outside and not d & 1 and s.metres > track.stretches[longest.get(s.section, d)].metres - 1e-9:
                longest.setdefault(s.section, d)
                if s.metres > track.stretches[longest[s.section]].metres:
                    longest[s.section] = d
        for section, d in longest.items():
            both = [(x, self._towards(x)) for x in (d, d ^ 1)]
            if both[0][1] == both[1][1]:
                both = [(x, f"{n} ({way})") for (x, n), way in zip(both, ("one way", "the other way"), strict=True)]
            name = track.sections[section]
            if not layout.track.section[name].approach:  # type: ignore[index]
                found[name] = both
        return found

    def _towards(self, d: int) -> str:
        track = self._world.track
        s = track.stretches
        for _ in range(60):
            here = s[d]
            on = here.on if here.facing is None else here.facing[0]
            if on == NONE:
                edge = self._world.layout.track.edges[here.edge]
                node = edge.a if d & 1 else edge.b
                return "the end of the track" if node not in self._world.layout.track.buffer_at else str(node)
            if s[on].signal != NONE:
                return track.signals[s[on].signal]
            if s[on].outside:
                return next((b.name for b in track.beyond if b.goes == on), "the boundary")
            if s[on].section != here.section:
                return track.sections[s[on].section]
            d = on
        return "round"

    def bring(self, boundary: str, metres: float, name: str) -> str:
        """A train comes in over a boundary, as soon as the line is free; its name.  Raises `Impossible`."""
        line = next((b for b in self._world.track.beyond if b.name == boundary), None)
        if line is None or line.comes == NONE:
            raise Impossible(f"no train comes in at {boundary}")
        if any(b is line for b, _, _ in self.coming):
            raise Impossible(f"a train waits already to come in at {boundary}")
        name = self._named(name)
        self.coming.append((line, metres, name))
        return name

    def arrive(self) -> None:
        """Whoever waits comes in, where the line is free."""
        for one in tuple(self.coming):
            line, metres, name = one
            w = self._world
            if any(t.body[0] in line.comes_by for t in w.trains):
                continue
            if line.block is BlockKind.TOKEN:
                neighbour = w.neighbours[line.name]
                neighbour.sends = True
                if not neighbour.may_send():
                    continue
                neighbour.sends = False
            far = line.comes
            head = w.track.stretches[far].metres - 60.0
            t = w.traffic.new([far], head, head - metres)
            t.driver.called, t.speed = True, 0.4 * t.handling.fastest
            self.names[t.number] = name
            self.coming.remove(one)

    def drive(self, name: str, go: bool) -> None:
        """Let a train run as signals permit, or bring it to a stand."""
        t = self.train(name)
        if go:
            t.handling.fastest = self._fastest.pop(t.number, t.handling.fastest)
            t.driver.stuck = False
        elif t.number not in self._fastest:
            self._fastest[t.number], t.handling.fastest = t.handling.fastest, 0.0

    def held(self, t: Train) -> bool:
        """Whether somebody holds a train."""
        return t.number in self._fastest

    def turn(self, name: str) -> None:
        """Let a train change ends.  Raises `Impossible`."""
        t = self.train(name)
        if t.speed:
            raise Impossible(f"{name} runs: stop it first")
        if not self._world.commanded.turn(t):
            raise Impossible(
                f"{name} cannot change ends here: only wholly within one section, before a signal for the way back"
            )

    def divide(self, name: str) -> str:
        """Part a train; the name of what stays.  Raises `Impossible`."""
        t, before = self.train(name), len(self._world.trains)
        self._world.traffic.divide(t)
        if len(self._world.trains) == before:
            raise Impossible(f"{name} cannot be divided here: it is too short, or not wholly inside")
        rear = self._world.trains[-1]
        self.names[rear.number] = self._free(f"{name}.2")
        return self.names[rear.number]

    def take_away(self, name: str) -> None:
        """Take a train off the track."""
        waiting = [x for x in self.coming if x[2] == name]
        if waiting:
            self.coming.remove(waiting[0])
            return
        self._world.trains.remove(self.train(name))
