"""Layouts that grow at random, in the product's own language.

Growth starts at a boundary and works on open ends: extend by a track, split at a point (facing or trailing), merge
two ends, cross two ends on a diamond, and close every end with a boundary or a buffer.  Sections may hold several
points; machines may work two ends; signals stand at random joints, and at every boundary where trains come in.
"""

from __future__ import annotations

import random
import re
from dataclasses import dataclass, field

from interlock.model.principles import PROFILES
from tests.layouts import grown


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
    shunting: bool = False
    tracks: dict[str, list[str]] = field(default_factory=dict)
    points: dict[str, dict[str, str]] = field(default_factory=dict)
    crossings: list[str] = field(default_factory=list)
    boundaries: dict[str, str] = field(default_factory=dict)
    buffers: list[str] = field(default_factory=list)
    joints: list[tuple[str, str, str]] = field(default_factory=list)
    slips: list[str] = field(default_factory=list)
    derailers: dict[str, dict[str, str]] = field(default_factory=dict)
    traps: list[str] = field(default_factory=list)
    signals: list[str] = field(default_factory=list)
    main: list[str] = field(default_factory=list)
    count: int = 0
    end_to_end = False
    """Whether tracks are joined to tracks, too."""

    def name(self, prefix: str) -> str:
        self.count += 1
        return f"{prefix}{self.count}"

    def length(self) -> int:
        return self.rng.choice([5, 12, 20, 40, 90, 250])

    def joint(self, a: End, section: str) -> None:
        if a.section != section:
            self.joints.append((a.section, section, a.point))

    def track(self, at: End) -> End:
        """A track from an open end; one that goes on from another track names its end."""
        name = self.name("t")
        items = [at.ref] if self.is_track(at) else []
        section = at.section if self.rng.random() < 0.2 else self.name("s")
        self.joint(at, section)
        for i in range(self.rng.choice([1, 1, 2, 3])):
            if i and self.rng.random() < 0.9:
                new = self.name("s")
                self.joints.append((section, new, ""))
                section = new
            items.append(f"{section} {self.length()}")
        self.tracks[name] = items
        if not self.is_track(at):
            self.join(at, f"{name}.start")
        return End(f"{name}.end", section)

    def join(self, at: End, ref: str) -> None:
        """The open end of a point or derailer gets its partner."""
        name, end = at.ref.split(".")
        (self.derailers if name in self.derailers else self.points)[name][end] = ref

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
            (self.traps if self.rng.random() < 0.2 else self.buffers).append(name)
        else:
            name = self.name("W")
            kind = self.rng.choice(["both"] * 6 + ["out"] * 3 + ["in"])
            approach = f"approach: {self.name('ap')} 100, " if self.rng.random() < 0.8 else ""
            if self.rng.random() < 0.1:
                approach += f"block: {'token' if kind == 'both' else 'automatic'}, "
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
            self.join(at, name)

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

    def slip(self, a: End, b: End) -> list[End]:
        """A single or double slip across two open ends."""
        name, section = self.name("Z"), self.name("s")
        out, arms = [], []
        for at in (a, b):
            self.joint(at, section)
            far, beyond = self.name("t"), self.name("s")
            self.tracks[far] = [f"{beyond} {self.length()}"]
            self.joints.append((section, beyond, ""))
            arms.append(f"[{at.ref}, {far}.start]")
            out.append(End(f"{far}.end", beyond))
        single = self.rng.choice(["", "", ", single: 1a-2b", ", single: 2a-1b"])
        self.slips.append(f"  {name}: {{section: {section}, arms: [{', '.join(arms)}]{single}}}")
        return out

    def derailer(self, at: End) -> End:
        """A derailer that protects what has been grown from what will be."""
        name = self.name("R")
        section = at.section if self.rng.random() < 0.6 else self.name("s")
        self.joint(at, section)
        self.derailers[name] = {"section": section, "inner": at.ref}
        return End(f"{name}.outer", section)

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
            if choice < 0.25 and (self.end_to_end or not self.is_track(at)):
                open_.append(self.track(at))
            elif choice < 0.6:
                open_.extend(self.point(at, "toe").values())
            elif choice < 0.75:
                open_.extend(self.point(at, self.rng.choice(["normal", "reverse"])).values())
            elif choice < 0.84 and open_:
                other = open_.pop()
                ends = self.point(at, "normal")
                point = ends["reverse"].ref.split(".")[0]
                self.points[point]["reverse"] = other.ref
                self.joint(End(other.ref, other.section, point), self.points[point]["section"])
                open_.append(ends["toe"])
            elif choice < 0.91 and open_:
                other = open_.pop()
                a, b = (x if self.is_track(x) else self.track(x) for x in (at, other))
                open_.extend(self.slip(a, b))
            elif choice < 0.94:
                open_.append(self.derailer(at))
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

    def blind(self) -> list[str]:
        """Now and then a siding without detection, with the shunt signal that it needs."""
        for name, items in self.tracks.items():
            if self.shunting and len(items) > 2 and items[-1] in self.buffers and self.rng.random() < 0.6:
                last, before = items[-2].split()[0], items[-3].split()[0]
                if "." in before:  # the end of another track
                    continue
                others = [n for n, rest in self.tracks.items() if n != name and any(last in x.split() for x in rest)]
                if last == before or others or any(last in s for s in self.signals):
                    continue
                self.signals.append(f"  {self.name('G')}: {{from: {last}, into: {before}, kind: shunt}}")
                return ["sections:", f"  {last}: {{detected: no}}"]
        return []

    def furnish(self) -> list[str]:
        """Level crossings, interlocks, hand-worked points and overlaps here and there."""
        out: list[str] = []
        sections = sorted({s for a, b, _ in self.joints for s in (a, b)})
        for room in ("level_crossings", "interlocks"):
            if sections and self.rng.random() < 0.2:
                over = self.rng.sample(sections, self.rng.choice([1, 1, min(2, len(sections))]))
                out += [f"{room}:", f"  {self.name('L')}: {{over: [{', '.join(over)}]}}"]
        for p in self.points:
            if "machine" not in self.points[p] and self.rng.random() < 0.06:
                self.points[p]["work"] = "hand"
            elif self.rng.random() < 0.2:
                self.points[p]["speed"] = self.rng.choice(["40", "80"])
        if sections and self.rng.random() < 0.15:
            inside = self.rng.sample(sections, self.rng.randint(1, len(sections)))
            out += ["zones:", f"  Z: {{sections: [{', '.join(inside)}], trains: {self.rng.choice([1, 2, 2, 3])}}}"]
        if self.main and self.rng.random() < 0.5:
            out.append("overlaps:")
            for g in self.rng.sample(self.main, max(1, len(self.main) // 2)):
                far = self.rng.choice(["length: 5", "length: 30", "length: 60", "length: 150", "successive: yes"])
                swing = ", swing: yes" if self.rng.random() < 0.4 else ""
                out.append(f"  {g}: {{{far}{swing}}}")
        return out

    @property
    def kinds(self) -> list[str]:
        """The kinds of signals to choose from: half of the layouts have main signals alone."""
        return ["", "", "shunt", "combined"] if self.shunting else [""]

    def place_signals(self) -> None:
        for a, b, point in self.joints:
            for x, y in ((a, b), (b, a)):
                if self.rng.random() < 0.45:
                    at = f", at: {point}" if point and self.rng.random() < 0.5 else ""
                    kind = self.rng.choice(self.kinds)
                    name = self.name("G")
                    if kind in ("", "combined"):
                        self.main.append(name)
                    self.signals.append(f"  {name}: {{from: {x}, into: {y}{at}{f', kind: {kind}' if kind else ''}}}")

    def rule(self, swings: bool) -> str:
        """Principles of the layout's own, if any."""
        rules = [
            "",
            "",
            "principles: {flank_space: yes, sensor_faults: yes}",
            "principles: {flank_lamp: yes, lamp_proof: yes}",
            "principles: {slow_below_kmh: 60, sensor_faults: yes}",
            "principles: {main_closes: whole-movement, shunt_closes: whole-movement}",
        ]
        rule = self.rng.choice(rules)
        if swings:  # slow trains, and machines that start at once, or no overlap could swing in time
            slow = "line_speed_kmh: 10, restart_delay_s: 36000, output_delay_s: 0.1"
            slow += ", point_run_s: 0.1, point_supervision_s: 0.2, point_start_gap_s: 0"
            rule = f"{rule[:-1]}, {slow}}}" if rule else f"principles: {{{slow}}}"
        return rule

    def text(self) -> str:
        more = [*self.furnish(), *self.blind()]
        profile = self.rng.choice(["mine", "generic", "cn", "de"])
        rule = self.rule(any("swing: yes" in x for x in more))
        out = ["interlock: 1", "name: grown", f"profile: {profile}", rule, "boundaries:"]
        out += [f"  {n}: {b}" for n, b in self.boundaries.items()]
        if self.buffers:
            out.append(f"buffers: [{', '.join(self.buffers)}]")
        if self.traps:
            out.append(f"traps: [{', '.join(self.traps)}]")
        out.append("tracks:")
        out += [f"  {n}: [{', '.join(items)}]" for n, items in self.tracks.items()]
        if self.points:
            out.append("points:")
            for n, spec in self.points.items():
                out.append(f"  {n}: {{{', '.join(f'{k}: {v}' for k, v in spec.items())}}}")
        if self.crossings:
            out += ["crossings:", *self.crossings]
        if self.slips:
            out += ["slips:", *self.slips]
        if self.derailers:
            out.append("derailers:")
            for n, spec in self.derailers.items():
                out.append(f"  {n}: {{{', '.join(f'{k}: {v}' for k, v in spec.items())}}}")
        calling = tuple(f"  {g}:" for g in self.main if self.rng.random() < 0.15)
        signals = [f"{s[:-1]}, call_on: yes}}" if s.startswith(calling) else s for s in self.signals]
        out += [*more, "signals:", *signals]
        announced = [g for g in self.main if self.rng.random() < 0.2]
        if announced:
            out += ["distants:", *(f"  V{g}: {{of: {g}}}" for g in announced)]
        return "\n".join(out) + "\n"


def grow(seed: int, steps: int | None = None) -> str:
    """The text of a layout; most, not all, are valid."""
    rng = random.Random(seed)
    g = Grown(rng, rng.random() < 0.5)
    g.grow(steps if steps is not None else rng.randint(1, 9))
    g.pair_machines()
    g.place_signals()
    return driven(within_line(g.text()))


def within_line(text: str) -> str:
    """The same with no speed of sections and points above the line's: over sections that state none it would be shown
    as well (IL4021)."""
    stated, profile = re.search(r"line_speed_kmh: (\d+)", text), re.search(r"(?m)^profile: (\w+)", text)
    line = int(stated[1] if stated else PROFILES[profile[1] if profile else "generic"].line_speed_kmh)
    return re.sub(r"\bspeed: (\d+)", lambda m: f"speed: {min(int(m[1]), line)}", text)


def driven(text: str) -> str:
    """A text without routes to whose signal no train comes: they are excluded."""
    found = grown(text)
    never = [d.about.name for d in found[2].diagnostics if d.code == "IL4018" and d.about] if found else []
    lines = "".join(f"  - {{from: {g}, reason: no train comes there}}\n" for g in never)
    return f"{text}exclude:\n{lines}" if lines else text
