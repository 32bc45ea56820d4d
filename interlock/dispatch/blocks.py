"""Lengths of block sections from the traffic: formulas 3-1 to 3-9 of document B, and what they leave out.

    3-1  n = W / (H T Y)           loaded trains a shift: tonnes a year, shifts a day, days a year, tonnes a train
    3-2  N = n + men + waste       trains a shift on the main line; 3-3 on a branch
    3-4  T = n t / 60              hours a shift of the tippler; 3-5 of a loading place
    3-6  h = (T + 0.5) / N * 60    minutes between trains; 0.5 h: change of shift; 3-8 on a branch
    3-7  L = h V                   metres: minutes times metres a minute; 3-9 on a branch

The length is the longest that still lets the trains follow one another; two thirds of it are to be built, for
over-production and special cases.  The formulas know no brakes.  The least length is ours: a train that reads stop at
the far end of a section when it comes in must be able to stop in it, and the coal rules want 100 m between trains in
one direction, which a section of that length keeps, since the second comes in when the first has left.
"""

from __future__ import annotations

import math

from interlock.dataclass import dataclass
from interlock.dispatch.language import LineSpec, TrafficSpec
from interlock.model.elements import SectionId
from interlock.model.layout import Layout
from interlock.model.traversal import topology

BUILT = 2 / 3
"""The part of the computed length that is to be built (document B 3.1-2)."""

GAP_M = 100.0
"""Metres between trains in one direction (coal rules)."""

BRAKING_M = {"goods": 40.0, "men": 20.0}
"""Metres of braking distance that the coal rules permit."""


@dataclass(frozen=True)
class Block:
    """What the formulas say of a line; trains a shift, hours a shift, minutes, metres."""

    name: str
    main: bool
    loaded: float
    trains: float
    hours: float
    headway_min: float
    longest_m: float
    built_m: float
    feasible: bool


@dataclass(frozen=True)
class Length:
    """A section of the layout against a line's figures; `grade`: fine, no reserve, too long, too short."""

    section: SectionId
    line: str
    metres: float
    least_m: float
    grade: str
    advice: str


@dataclass(frozen=True)
class Braking:
    """What a train needs to stop at the highest speed: metres of braking alone, and with delay and reaction."""

    kmh: float
    braking_m: float
    stopping_m: float

    @property
    def least_m(self) -> float:
        """The least length of a section."""
        return max(self.stopping_m, GAP_M)


def loaded_trains(tonnes: float, traffic: TrafficSpec, rounding: str) -> float:
    """3-1.  Whole trains if rounded up, which is on the safe side of capacity; the hand calculation rounds nothing."""
    n = tonnes / (traffic.shifts * traffic.days * traffic.train_t)
    return float(math.ceil(n - 1e-9)) if rounding == "up" else n


def block(name: str, line: LineSpec, traffic: TrafficSpec, main: bool, rounding: str | None = None) -> Block:
    """3-1 to 3-9 for one line; `rounding`: instead of the line's own."""
    n = loaded_trains(line.tonnes, traffic, rounding or line.rounding)
    trains = n + line.men + line.waste
    hours = n * line.minutes / 60
    headway = (hours + traffic.change_h) / trains * 60
    longest = headway * traffic.speed_kmh * 1000 / 60
    return Block(name, main, n, trains, hours, headway, longest, longest * BUILT, hours < traffic.shift_h)


def blocks(traffic: TrafficSpec, rounding: str | None = None) -> tuple[Block, ...]:
    """The main line, then the branches."""
    found = [] if traffic.main is None else [block("main", traffic.main, traffic, True, rounding)]
    return (*found, *(block(n, x, traffic, False, rounding) for n, x in traffic.branches.items()))


def braking(layout: Layout, section: SectionId | None = None) -> Braking:
    """Stopping from the highest speed in a section, or anywhere: v (t + r) + v^2 / 2b."""
    rules = layout.principles
    stated = layout.track.section[section].speed if section is not None else None
    kmh = float(stated if stated is not None else rules.line_speed_kmh)
    v = kmh / 3.6
    brake = v * v / (2 * rules.braking_ms2)
    return Braking(kmh, brake, v * (rules.output_delay_s + rules.reaction_s) + brake)


def section_m(layout: Layout, section: SectionId) -> float:
    """Metres of a section on its longest way."""
    ways = topology(layout).traversals.get(section, ())
    metres = [sum(layout.track.edge[e].length for e in t.edges) for t in ways]
    return max(metres, default=sum(e.length for e in layout.track.edges_in.get(section, ())))


def lengths(layout: Layout, traffic: TrafficSpec, found: tuple[Block, ...]) -> tuple[Length, ...]:
    """The layout's sections of each line against its figures."""
    spec = dict(traffic.branches)
    if traffic.main is not None:
        spec["main"] = traffic.main
    return tuple(_length(layout, SectionId(s), b) for b in found for s in spec[b.name].sections)


def _length(layout: Layout, section: SectionId, b: Block) -> Length:
    metres, least = section_m(layout, section), braking(layout, section).least_m
    if metres > b.longest_m:
        parts = math.ceil(metres / b.built_m)
        carried = b.trains * b.longest_m / metres
        advice = (
            f"trains follow every {b.headway_min * metres / b.longest_m:.1f} min at best, {carried:.1f} of "
            f"{b.trains:.1f} a shift: divide it into {parts} of {metres / parts:.0f} m"
        )
        grade = "too long"
    elif metres > b.built_m:
        grade, advice = "no reserve", f"beyond two thirds ({b.built_m:.1f} m): nothing left for over-production"
    elif layout.machines.points_in.get(section):
        return Length(section, b.name, metres, 0.0, "fine", "its points belong to no place where a train waits")
    elif metres < least:
        grade = "too short"
        advice = f"a train that reads stop at its end needs {least:.0f} m: join it to a neighbour, or run slower"
    else:
        grade, advice = "fine", "long enough to stop in, short enough for the traffic"
    return Length(section, b.name, metres, least, grade, advice)


def advice(layout: Layout, traffic: TrafficSpec, found: tuple[Block, ...]) -> tuple[str, ...]:
    """What follows from the figures, in words."""
    said = []
    for b in found:
        place = "the tippler" if b.main else f"the loading place of {b.name}"
        if not b.feasible:
            said.append(
                f"{place} works {b.hours:.2f} h of a shift of {traffic.shift_h:g} h: "
                + ("loaded wagons pile up before it" if b.main else "empties pile up before it")
            )
        elif b.hours > 0.9 * traffic.shift_h:
            said.append(f"{place} works {b.hours:.2f} h of {traffic.shift_h:g} h: hardly any reserve")
    stop = braking(layout)
    for kind, most in BRAKING_M.items():
        if stop.braking_m > most + 0.05:
            v = math.sqrt(2 * layout.principles.braking_ms2 * most) * 3.6
            said.append(
                f"from {stop.kmh:g} km/h braking takes {stop.braking_m:.1f} m, {most:g} m are permitted with {kind}: "
                f"run at most {v:.1f} km/h"
            )
    return tuple(said)
