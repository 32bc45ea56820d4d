"""Layouts that grow at random, in the product's own language.

Growth starts at a boundary and works on open ends: extend by a track, split at a point (facing or trailing), merge
two ends, cross two ends on a diamond, and close every end with a boundary or a buffer.  Sections may hold several
points; machines may work two ends; signals stand at random joints, and at every boundary where trains come in.
"""

from __future__ import annotations

import random
from dataclasses import dataclass, field


@dataclass
class End:
    """An open end: how to refer to it, its section, and the point next to it, if any."""

    ref: str
    section: str
    point: str = ""


@dataclass
class Grown:
    """A layout in the making."""

    rng: random.Random
    tracks: dict[str, list[str]] = field(default_factory=dict)
    points: dict[str, dict[str, str]] = field(default_factory=dict)
    crossings: list[str] = field(default_factory=list)
    boundaries: dict[str, str] = field(default_factory=dict)
    buffers: list[str] = field(default_factory=list)
    joints: list[tuple[str, str, str]] = field(default_factory=list)
    signals: list[str] = field(default_factory=list)
    count: int = 0

    def name(self, prefix: str) -> str:
        self.count += 1
        return f"{prefix}{self.count}"

    def length(self) -> int:
        return self.rng.choice([5, 12, 20, 40, 90, 250])

    def joint(self, a: End, section: str) -> None:
        if a.section != section:
            self.joints.append((a.section, section, a.point))

    def track(self, at: End) -> End:
        """A track from a point's end; tracks join only to points and boundaries."""
        name = self.name("t")
        items: list[str] = []
        section = at.section if self.rng.random() < 0.2 else self.name("s")
        self.joint(at, section)
        for i in range(self.rng.choice([1, 1, 2, 3])):
            if i and self.rng.random() < 0.9:
                new = self.name("s")
                self.joints.append((section, new, ""))
                section = new
            items.append(f"{section} {self.length()}")
        self.tracks[name] = items
        self.join(at, f"{name}.start")
        return End(f"{name}.end", section)

    def join(self, at: End, ref: str) -> None:
        """A point's open end gets its partner."""
        point, end = at.ref.split(".")
        self.points[point][end] = ref

    def point(self, at: End, as_end: str) -> dict[str, End]:
        """A new point joined to an open end with one of its own ends."""
        name = self.name("P")
        section = at.section if self.rng.random() < 0.3 else self.name("s")
        self.joint(at, section)
        self.points[name] = {"section": section, as_end: at.ref}
        if self.rng.random() < 0.4:
            self.points[name]["legs"] = str(self.length())
        return {e: End(f"{name}.{e}", section, name) for e in ("toe", "normal", "reverse") if e != as_end}

    def close(self, at: End) -> None:
        """A boundary or a buffer."""
        if self.rng.random() < 0.35:
            name = self.name("B")
            self.buffers.append(name)
        else:
            name = self.name("W")
            kind = self.rng.choice(["both"] * 6 + ["out"] * 3 + ["in"])
            approach = f"approach: {self.name('ap')} 100, " if self.rng.random() < 0.8 else ""
            self.boundaries[name] = f"{{{approach}trains: {kind}}}"
            if kind != "out":
                self.signals.append(f"  {self.name('X')}: {{from: {name}, into: {at.section}}}")
        track, end = at.ref.split(".")
        if track in self.tracks:
            if end == "end":
                self.tracks[track].append(name)
            else:
                self.tracks[track].insert(0, name)
        else:
            self.points[track][end] = name

    def is_track(self, at: End) -> bool:
        return at.ref.split(".")[0] in self.tracks

    def cross(self, a: End, b: End) -> list[End]:
        name = self.name("D")
        arms = []
        out = []
        for at in (a, b):
            section = self.name("s")
            self.joint(at, section)
            far = self.name("t")
            beyond = self.name("s")
            self.tracks[far] = [f"{beyond} {self.length()}"]
            self.joints.append((section, beyond, ""))
            arms.append(f"{{section: {section}, ends: [{at.ref}, {far}.start]}}")
            out.append(End(f"{far}.end", beyond))
        self.crossings.append(f"  {name}: {{arms: [{arms[0]}, {arms[1]}]}}")
        return out

    def grow(self, steps: int) -> None:
        first = self.name("t")
        section = self.name("s")
        self.tracks[first] = [f"{section} {self.length()}"]
        self.boundaries["W"] = f"{{approach: ap 100, trains: {self.rng.choice(['both'] * 9 + ['in'])}}}"
        self.tracks[first].insert(0, "W")
        self.signals.append(f"  X: {{from: W, into: {section}}}")
        open_ = [End(f"{first}.end", section)]
        for _ in range(steps):
            self.rng.shuffle(open_)
            at = open_.pop()
            choice = self.rng.random()
            if choice < 0.25 and not self.is_track(at):
                open_.append(self.track(at))
            elif choice < 0.6:
                open_.extend(self.point(at, "toe").values())
            elif choice < 0.75:
                open_.extend(self.point(at, self.rng.choice(["normal", "reverse"])).values())
            elif choice < 0.9 and open_:
                other = open_.pop()
                ends = self.point(at, "normal")
                point = ends["reverse"].ref.split(".")[0]
                self.points[point]["reverse"] = other.ref
                self.joint(End(other.ref, other.section, point), self.points[point]["section"])
                open_.append(ends["toe"])
            elif open_:
                open_.extend(self.cross(at, open_.pop()))
            else:
                open_.append(at)
        for at in open_:
            self.close(at)

    def pair_machines(self) -> None:
        """Sometimes one machine works two ends."""
        names = list(self.points)
        if len(names) > 1 and self.rng.random() < 0.3:
            machine = self.name("M")
            for p in self.rng.sample(names, 2):
                self.points[p]["machine"] = machine

    def place_signals(self) -> None:
        for a, b, point in self.joints:
            for x, y in ((a, b), (b, a)):
                if self.rng.random() < 0.45:
                    at = f", at: {point}" if point and self.rng.random() < 0.5 else ""
                    self.signals.append(f"  {self.name('G')}: {{from: {x}, into: {y}{at}}}")

    def text(self) -> str:
        out = ["interlock: 1", "name: grown", f"profile: {self.rng.choice(['mine', 'generic'])}", "boundaries:"]
        out += [f"  {n}: {b}" for n, b in self.boundaries.items()]
        if self.buffers:
            out.append(f"buffers: [{', '.join(self.buffers)}]")
        out.append("tracks:")
        out += [f"  {n}: [{', '.join(items)}]" for n, items in self.tracks.items()]
        if self.points:
            out.append("points:")
            for n, spec in self.points.items():
                out.append(f"  {n}: {{{', '.join(f'{k}: {v}' for k, v in spec.items())}}}")
        if self.crossings:
            out += ["crossings:", *self.crossings]
        out += ["signals:", *self.signals]
        return "\n".join(out) + "\n"


def grow(seed: int, steps: int | None = None) -> str:
    """The text of a layout; most, not all, are valid."""
    rng = random.Random(seed)
    g = Grown(rng)
    g.grow(steps if steps is not None else rng.randint(1, 9))
    g.pair_machines()
    g.place_signals()
    return g.text()
