"""What follows from a layout's lengths and speeds: foul joints (R7), approaches (R8), braking, and overlaps (R4)."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from graphlib import CycleError, TopologicalSorter
from math import ceil, isqrt

from interlock.checker.drawing import Diamond, Edge
from interlock.checker.kilometres import item_parts
from interlock.checker.overlaps import Overlaps
from interlock.checker.railway import Path, Signal
from interlock.checker.track import Demand, Way

_Side = tuple[str, str | int, str]
"""A point or diamond, its leg or arm, and the section of the ways over the other one."""


@dataclass(frozen=True)
class FoulJoint:
    """A joint nearer to a point or diamond than a vehicle beyond it stands clear.

    element, side: the point's position or the diamond's arm on which the joint lies; ways over the other one are
    fouled.  when: the first point of the neighbour, if it leads vehicles to the joint in that position, and lies far
    enough away itself.
    """

    element: str
    side: str | int
    section: str
    neighbour: str
    node: str
    when: Demand | None

    def fouls(self, w: Way) -> bool:
        """A vehicle at the joint stands in the way."""
        if isinstance(self.side, str):
            return any(p == self.element and d.position != self.side for p, d in w.points)
        return any(c == self.element and arm != self.side for c, arm in w.arms)


@dataclass(frozen=True)
class FoulBeside(FoulJoint):
    """The same to ways that come as near to the point or diamond on the other leg or arm, over one of some edges.

    section: in which these lie.  element, side, node: of the joint beyond which the neighbour lies.
    """

    edges: frozenset[str] = frozenset()

    def fouls(self, w: Way) -> bool:
        """A vehicle at the joint stands in the way."""
        return w.section == self.section and not self.edges.isdisjoint(w.edges)


@dataclass(frozen=True)
class Approach:
    """A section from which a train may come to a signal, and over which ways from further away; None: unseen.  Where it
    `ends_early`, a train may be on its way beyond it as well, where nothing detects it."""

    section: str | None
    further: tuple[tuple[Way, Approach], ...] = ()
    ends_early: bool = False


def fastest_told(lengths: Lengths, g: Signal) -> float:
    """The highest speed at which a train may run when it is told of a main signal: in rear of it, or anywhere on its
    way to it; unseen, at the line's."""
    fastest, todo = lengths.kmh(lengths.before(g)), [lengths.approach(g)] if g.main else []
    while todo:
        x = todo.pop()
        fastest = max(fastest, lengths.kmh(None if x.ends_early else x.section))
        todo += [y for _, y in x.further]
    return fastest


def until_arrived(lengths: Lengths, g: Signal) -> int:
    """Until a train that is wholly in the section before a signal stands, in milliseconds: one that brakes at once, and
    one that runs through all of it at the highest speed and brakes as late as it can."""
    before = lengths.before(g)
    ways = [w for w in lengths.r.track.ways[before] if w.exit == g.node] if before else []
    metres = max((lengths._exact(w) for w in ways), default=Fraction(0))
    v, b = _a_second(lengths.kmh(before)), _decimal(lengths.r.drawn.rule("braking_ms2"))
    if metres * 2 * b >= v * v:
        return max(lengths.halt(lengths.kmh(before)), ceil(1000 * (metres / v + v / b / 2)))
    needed = 2_000_000 * metres / b  # the square of the milliseconds
    ms = isqrt(int(needed))
    return max(lengths.halt(lengths.kmh(before)), ms if ms * ms >= needed else ms + 1)


def whole_ms(seconds: float) -> int:
    """A delay as the layout states it: a controller counts whole milliseconds, and no fewer."""
    return ceil(_decimal(seconds) * 1000)


def _decimal(number: float) -> Fraction:
    """A number as the layout writes it."""
    return Fraction(repr(float(number)))


def _a_second(kmh: float) -> Fraction:
    """Metres in one second."""
    return _decimal(kmh) * 1000 / 3600


class Lengths(Overlaps):
    """Of one railway."""

    def overlap_release(self, g: Signal) -> int:
        """When the overlap of a signal may be released: as stated, by length, or as the principles have it."""
        told = (self.r.body.get("overlaps") or {}).get(g.name) or {}
        if "release" in told:
            return whole_ms(float(told["release"]))
        if told.get("release_by_length") in ("yes", "true"):
            before = self.before(g)
            kmh = self.kmh(before)
            shown = [x["entry_speed"] for x in (told, *(told.get("ways") or ())) if "entry_speed" in x]
            slowest = min([kmh, *map(float, shown)])  # a train that was shown no more takes longer
            ways = self.r.track.ways[before] if before else []
            longest = max((self._exact(w) for w in ways if w.exit == g.node), default=Fraction(0))
            return 1000 * ceil(2 * longest / _a_second(slowest) + Fraction(self.halt(kmh)) / 1000)
        return whole_ms(self._d.rule("overlap_release_s"))

    # --- foul joints ---

    @cached_property
    def foul_joints(self) -> list[FoulJoint]:
        """Joints nearer to a point or diamond than its fouling point and the clearance."""
        return [f for start in self._starts for f in self._along(*start)]

    @property
    def _starts(self) -> Iterator[tuple[Edge, str, float, str, _Side, float]]:
        """Of a walk out from each leg and arm: the edge, from where, metres gone, the section in which it lies, whose
        other leg or arm it is about, and how far to go."""
        margin = self._d.rule("clearance_m")
        for p in self._d.points.values():
            for side in ("N", "R"):
                yield self._d.edges[p.leg(side)], p.name, 0.0, p.section, (p.name, side, p.section), p.fouling + margin
        for c in self._d.diamonds.values():
            for arm, edges in enumerate(c.arms):
                across = self._d.edges[c.arms[1 - arm][0]].section
                for e in (self._d.edges[n] for n in edges):
                    yield e, c.name, 0.0, e.section, (c.name, arm, across), c.fouling + margin

    @cached_property
    def crossed(self) -> list[FoulJoint]:
        """Of diamonds whose arms lie in two sections the other arm's, for each of its points that lead to the diamond:
        to whoever passes the diamond (`side` is that arm), or what lies too near to it.  Their node is the diamond."""
        found: list[FoulJoint] = []
        for c in self._d.diamonds.values():
            needed = c.fouling + self._d.rule("clearance_m")
            one, two = (self._d.edges[edges[0]].section for edges in c.arms)
            for arm, here in ((0, two), (1, one)) if one != two else ():
                found += self._lying_across(c, arm, (c.name, arm, here), 0.0, needed)
        return list(dict.fromkeys([*found, *(f for start in self._starts for f in self._diamonds_along(*start))]))

    @cached_property
    def beside(self) -> list[FoulBeside]:
        """What stands foul of ways that come too near to a point on its other leg, or to a diamond on its other arm."""
        near: dict[tuple[str, str | int, str], set[str]] = {}
        for start in self._starts:
            for of, section, edge in self._edges_along(*start):
                near.setdefault((of[0], of[1], section), set()).add(edge)
        joints = dict.fromkeys(
            f for start in self._starts for w in (self._along, self._diamonds_along) for f in w(*start)
        )
        return [
            FoulBeside(f.element, f.side, section, f.neighbour, f.node, f.when, frozenset(edges))
            for f in joints
            for (element, side, section), edges in near.items()
            if element == f.element and side != f.side and section != f.neighbour
        ]

    def _edges_along(
        self, e: Edge, node: str, gone: float, home: str, of: _Side, needed: float
    ) -> Iterator[tuple[_Side, str, str]]:
        """Edges of other sections that begin on a walk before it has gone far enough, or lie there on a diamond."""
        far, gone = e.far(node), gone + e.length
        if gone >= needed or far == of[0]:
            return
        c = self._d.diamonds.get(far)
        beyond = list(self._d.onward(far, e))
        across = [] if c is None else [self._d.edges[n] for n in c.arms[1 if e.name in c.arms[0] else 0]]
        yield from ((of, x.section, x.name) for x in (*beyond, *across) if x.section not in (home, of[2]))
        for x in beyond:
            yield from self._edges_along(x, far, gone, home, of, needed)

    def _lying_across(self, c: Diamond, arm: int, of: _Side, gone: float, needed: float) -> list[FoulJoint]:
        ends = [self._d.edges[n] for n in c.arms[arm]]
        leading = [x for e in ends if (x := self._leading(e, c.name)) is not None]
        far = all(gone + metres >= max(needed, own) for _, metres, own in leading)
        whens = dict.fromkeys(d for d, *_ in leading if far)
        return [FoulJoint(*of, ends[0].section, c.name, d) for d in whens or [None]]

    def _diamonds_along(
        self, e: Edge, node: str, gone: float, home: str, of: _Side, needed: float
    ) -> Iterator[FoulJoint]:
        """Diamonds met on a walk before it has gone far enough, whose other arm lies in a section of its own."""
        far, gone = e.far(node), gone + e.length
        if gone >= needed or far == of[0]:
            return
        c = self._d.diamonds.get(far)
        if c is not None:
            arm = 1 if e.name in c.arms[0] else 0
            if self._d.edges[c.arms[arm][0]].section not in (home, of[2], e.section):
                yield from self._lying_across(c, arm, of, gone, needed)
        for x in self._d.onward(far, e):
            yield from self._diamonds_along(x, far, gone, home, of, needed)

    def _along(self, e: Edge, node: str, gone: float, home: str, of: _Side, needed: float) -> Iterator[FoulJoint]:
        far = e.far(node)
        gone += e.length
        if gone >= needed or far == of[0]:
            return
        for x in self._d.onward(far, e):
            if x.section not in (home, of[2], e.section):
                yield FoulJoint(*of, x.section, far, self._decider(x, far, gone, needed))
            yield from self._along(x, far, gone, home, of, needed)

    def _decider(self, e: Edge, node: str, gone: float, needed: float) -> Demand | None:
        """The point that leads to a joint, if it lies far enough away itself: `gone` metres lead to the joint."""
        found = self._leading(e, node)
        return found[0] if found is not None and gone + found[1] >= max(needed, found[2]) else None

    def _leading(self, e: Edge, node: str) -> tuple[Demand, float, float] | None:
        """The first point of the section behind a node, if one of its legs leads there; how far away it lies, and how
        far what stands clear of its legs."""
        seen, gone = {node}, 0.0
        while True:
            node, gone = e.far(node), gone + e.length
            if node in seen or node in self._d.diamonds:
                return None
            seen.add(node)
            p = self._d.points.get(node)
            if p is not None:
                x = p.position(e.name)
                return None if x is None else (Demand(p.machine, x), gone, p.fouling + self._d.rule("clearance_m"))
            onward = [x for x in self._d.at[node] if x.name != e.name and x.section == e.section]
            if len(onward) != 1:
                return None
            e = onward[0]

    # --- speeds, braking, times (milliseconds) ---

    def kmh(self, section: str | None) -> float:
        """The speed permitted in a section, or on the line."""
        told = (self.r.track.told.get(section or "") or {}).get("speed")
        return float(told) if told is not None else self._d.rule("line_speed_kmh")

    def path_kmh(self, p: Path) -> float | None:
        """The lowest speed stated along a path: of its sections, and over reversed points."""
        told = [(self.r.track.told.get(w.section) or {}).get("speed") for w in p.ways]
        over = [self._d.points[n].kmh for w in p.ways for n, d in w.points if d.position == "R"]
        return min((float(v) for v in (*told, *over) if v is not None), default=None)

    def halt(self, kmh: float) -> int:
        """From the command of stop until a train stands: delay of outputs, reaction, braking."""
        waits = [_decimal(self._d.rule(x)) for x in ("output_delay_s", "reaction_s")]
        return ceil(1000 * (sum(waits) + _a_second(kmh) / _decimal(self._d.rule("braking_ms2"))))

    def _exact(self, w: Way) -> Fraction:
        """The metres of a way without the error of a sum."""
        return Fraction(sum(_decimal(self._d.edges[n].length) for n in w.edges))

    def braking(self, kmh: float) -> float:
        """Metres in which it stands."""
        v = kmh / 3.6
        return v * self._wait + v * v / (2 * self._d.rule("braking_ms2"))

    @property
    def _wait(self) -> float:
        return self._d.rule("output_delay_s") + self._d.rule("reaction_s")

    def before(self, g: Signal) -> str | None:
        """The section or approach in rear of a signal, from which it is read."""
        return self.r.approach.get(g.node) if g.node in self.r.drawn.boundaries else self.r.track.beyond(g.into, g.node)

    def until_all_stand(self) -> int:
        """Until every train stands that ran at a power cut: on to the next main signal at half the line's speed, then a
        halt from the highest speed."""
        longest = self._longest_run([w for s in self.r.track.sections for w in self.r.track.ways[s]])
        fastest = max(self.kmh(s) for s in [None, *self.r.track.sections])
        return self.halt(fastest) + ceil(2000 * longest / _a_second(self._d.rule("line_speed_kmh")))

    def _longest_run(self, ways: list[Way]) -> Fraction:
        """The metres of the longest run over some ways that meets no main signal.  A way that comes back to itself
        belongs to a ring, which counts as one way of all its metres: round a loop a train passes no place twice."""
        onward = {w: self._unhindered(w) for w in ways}
        ring = {w: w for w in ways}
        while True:
            order = TopologicalSorter({ring[w]: set() for w in ways})
            for w in ways:
                order.add(ring[w], *(ring[x] for x in onward[w] if ring[x] != ring[w]))
            try:
                last_first = list(order.static_order())
                break
            except CycleError as found:
                one, *others = dict.fromkeys(found.args[1])
                ring = {w: one if x in others else x for w, x in ring.items()}
        metres = dict.fromkeys(last_first, Fraction(0))
        beyond: dict[Way, set[Way]] = {r: set() for r in last_first}
        for w in ways:
            metres[ring[w]] += self._exact(w)
            beyond[ring[w]] |= {ring[x] for x in onward[w]} - {ring[w]}
        for r in last_first:
            metres[r] += max((metres[x] for x in beyond[r]), default=Fraction(0))
        return max(metres.values(), default=Fraction(0))

    def _unhindered(self, w: Way) -> list[Way]:
        """The ways over which a train runs on from the end of one, where no main signal stands."""
        ahead = self.r.track.beyond(w.section, w.exit)
        return [] if ahead is None or (w.exit, ahead) in self.r.main_into else self.r.track.from_end(ahead, w.exit)

    def unseen(self) -> dict[str, float]:
        """Sections, and approaches from which trains come, that may be run through in less than A-SCAN asks for, with
        the seconds: over the shortest way that no buffer ends, at the speed of the section or of reversed points."""
        found: dict[str, float] = {}
        for s in self.r.track.sections:
            for w in self.r.track.ways[s] if s not in self.r.track.undetected else ():
                if not {w.entry, w.exit} & {*self._d.buffers}:
                    reverse = [self._d.points[p].kmh for p, x in w.points if x.position == "R"]
                    kmh = min([self.kmh(s), *(float(v) for v in reverse if v is not None)])
                    found[s] = min(found.get(s, float("inf")), w.length / (kmh / 3.6))
        for b in self.r.drawn.boundaries.values():
            name, metres = item_parts(b.get("approach", ""))
            if name and b.get("trains") != "out":
                found[name] = float(metres) / (self._d.rule("line_speed_kmh") / 3.6)
        return {s: t for s, t in sorted(found.items()) if t < self._d.rule("detection_delay_s")}

    def supervision(self, m: str) -> float:
        """Seconds after which a machine raises an alarm: its own, the longest of its ends, or as the principle says."""
        body, own = self.r.body, []
        for part in ("points", "derailers", "slips", "level_crossings", "interlocks"):
            for name, v in (body.get(part) or {}).items():
                works = {p.machine for k, p in self.r.drawn.points.items() if k == name or _half(k, name, part)}
                if v.get("supervision") is not None and m in (works or {name}):
                    own.append(float(v["supervision"]))
        return max(own, default=self._d.rule("point_supervision_s"))

    def swings_in_time(self, g: Signal) -> bool:
        """A train needs longer through the section before a signal than its swinging overlap may take to turn."""
        told = (self.r.body.get("overlaps") or {}).get(g.name) or {}
        s = self.before(g)
        if told.get("swing") not in ("yes", "true") or s is None or self._d.rule("point_start_gap_s") > 0:
            return False
        metres = min((w.length for w in self.r.track.ways[s] if w.exit == g.node), default=0.0)
        return metres / (self.kmh(s) / 3.6) >= self._d.rule("output_delay_s") + max(
            map(self.supervision, self.of_overlap(g)), default=self._d.rule("point_supervision_s")
        )

    def of_overlap(self, g: Signal) -> list[str]:
        """The machines of points in the overlaps of a signal, and of what lies over them."""
        ways = [w for o in self.overlaps.get(g.name, []) for w in o.ways]
        over = [d for d, those in self.r.devices.items() if any(w.section in those for w in ways)]
        return list(dict.fromkeys([*(d.machine for w in ways for _, d in w.points), *over]))

    # --- from where a train may come to a signal (R8) ---

    def approach(self, g: Signal) -> Approach:
        """Everything in rear of a signal back to the braking distance, and to the first main signal announcing it, with
        the way in rear of that one on which a driver does not act any more on a worse aspect."""
        announced = not g.main or self._d.rules["caution"] == "never"
        found = self._before(g, g.into, g.node, 0.0, 0.0, announced, None, frozenset({g.into}))
        return Approach(None) if found is None else found

    def _before(
        self,
        g: Signal,
        ahead: str,
        node: str,
        gone: float,
        needed: float,
        announced: bool,
        tells: float | None,
        seen: frozenset[str],
    ) -> Approach | None:
        """gone: metres from the signal to the node; needed: the longest distance so far; tells: metres to the signal
        that announces this one, where it stands at the node."""
        if node in self.r.drawn.boundaries:
            b = self.r.drawn.boundaries[node]
            if b.get("trains") == "out" and len(seen) > 1:
                return None
            name, metres = item_parts(b.get("approach", ""))
            far = bool(name) and gone + float(metres) >= max(needed, self._metres_to_act(g, name, tells))
            return Approach(name or None, ends_early=not far)
        s = self.r.track.beyond(ahead, node)
        if s is None or s in seen:
            return None
        needed = max(needed, self._metres_to_act(g, s, tells))
        further = []
        for w in self.r.track.ways[s]:
            teller = self.r.main_into.get((w.entry, s))
            first = not announced and teller is not None and not self._may_be_passed(teller)
            run = gone + w.length
            if w.exit == node and not (announced and run >= needed):
                x = self._before(g, s, w.entry, run, needed, announced or first, run if first else None, seen | {s})
                further += [] if x is None else [(w, x)]
        return Approach(s, tuple(further))

    def _may_be_passed(self, g: Signal) -> bool:
        """A signal at identifier light tells nothing: then the one before it announces."""
        return self.r.body["signals"][g.name].get("identifier") in ("yes", "true")

    def _metres_to_act(self, g: Signal, section: str, tells: float | None) -> float:
        """Until a train stands; from a signal that announces this one, until its driver acts on it."""
        kmh = self.kmh(section) if g.main else min(self.kmh(section), self._d.rule("shunt_speed_kmh"))
        acts = kmh / 3.6 * (self._d.rule("output_delay_s") + self._d.rule("reaction_s"))
        return max(self.braking(kmh), 0.0 if tells is None else tells + acts)


def _half(point: str, slip: str, part: str) -> bool:
    """The point is part of a slip."""
    return part == "slips" and point in (f"{slip}a", f"{slip}b", *(f"{slip}/{e}" for e in ("1a", "1b", "2a", "2b")))
