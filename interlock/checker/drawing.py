"""What a layout file draws: stretches of track between nodes, points, diamonds, and where the track ends.

Read with PyYAML as plain text, and with nothing of the product's own reading.  A joint between sections a and b is
named `a|b@` and the end of a track, point or crossing that lies there first in the alphabet, or the place on a track:
only so can the names of a written system be compared.  A slip is two points toe to toe, or a diamond with a point at
each end of its slip rails; a derailer is a point whose normal leg leads off the rails.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from interlock.checker.kilometres import Measures, Parts, item_parts, parted
from interlock.checker.language import admitted
from interlock.checker.reading import loaded
from interlock.verify import Rejected, need

_KEYS = """
interlock name title profile principles boundaries buffers traps tracks points crossings slips derailers
level_crossings interlocks signals distants sections conditions zones overlaps waive exclude hostile demand automatic
routes voyages substations addresses health drawing telegram target allow title_block
"""
KEYS = frozenset(_KEYS.split())
"""The keys that are known; those of the last line say nothing of what is claimed."""

PRINCIPLES = Path(__file__).parent.parent / "spec" / "principles.yaml"


class Unread(Exception):
    """The layout has something of which this reader knows nothing."""


@dataclass(frozen=True)
class Edge:
    """A stretch of track between two nodes."""

    name: str
    a: str
    b: str
    section: str
    length: float
    one_way: bool
    inclined: bool

    def none_to(self, node: str) -> bool:
        """Nothing comes over it to that end: it runs one way, and no vehicle runs away over it."""
        return self.one_way and not self.inclined and self.a == node

    def far(self, node: str) -> str:
        """The other end."""
        return self.b if self.a == node else self.a


@dataclass(frozen=True)
class Point:
    """A point with the names of its three edges.  kmh: over the reverse leg."""

    name: str
    machine: str
    section: str
    toe: str
    normal: str
    reverse: str
    fouling: float
    keyed: bool = False
    kmh: float | None = None

    def leg(self, position: str) -> str:
        """The edge to which the point leads in a position."""
        return self.normal if position == "N" else self.reverse

    def position(self, edge: str) -> str | None:
        """The position that leads to an edge; None for the toe."""
        return {self.normal: "N", self.reverse: "R"}.get(edge)


@dataclass(frozen=True)
class Diamond:
    """Two arms, each a pair of edges, that cross at one node."""

    name: str
    arms: tuple[tuple[str, str], tuple[str, str]]
    fouling: float


@dataclass
class Drawing:
    """The layout as a graph.  off_rails: nodes behind derailers."""

    body: Mapping[str, Any]
    rules: Mapping[str, str]
    boundaries: dict[str, Mapping[str, str]] = field(default_factory=dict)
    buffers: set[str] = field(default_factory=set)
    off_rails: set[str] = field(default_factory=set)
    edges: dict[str, Edge] = field(default_factory=dict)
    points: dict[str, Point] = field(default_factory=dict)
    diamonds: dict[str, Diamond] = field(default_factory=dict)
    at: dict[str, list[Edge]] = field(default_factory=dict)

    def rule(self, name: str) -> float:
        """A principle that is a number."""
        return float(self.rules[name])

    def asks(self, name: str) -> bool:
        """A principle that is yes or no."""
        return self.rules[name] in ("yes", "true")

    def onward(self, node: str, e: Edge) -> list[Edge]:
        """Whereto a vehicle can go on that comes over an edge: over a point from the toe to either leg, from a leg to
        the toe; over a diamond and a joint straight on."""
        point, diamond = self.points.get(node), self.diamonds.get(node)
        if point is not None:
            names = [point.normal, point.reverse] if e.name == point.toe else [point.toe]
            return [self.edges[n] for n in names]
        if diamond is not None:
            return [self.edges[b if a == e.name else a] for a, b in diamond.arms if e.name in (a, b)]
        return [x for x in self.at[node] if x.name != e.name]


def drawing(body: Mapping[str, Any]) -> Drawing:
    """The graph of a layout."""
    strange = sorted(set(body) - KEYS)
    if strange:
        raise Unread(", ".join(strange))
    rules = _rules(body)
    admitted(body)
    return _Drawer(body, rules).drawn


def _rules(body: Mapping[str, Any]) -> dict[str, str]:
    """The principles of the layout's profile, with what it states itself."""
    book = loaded(PRINCIPLES.read_text("utf-8"))
    elsewhere = book.pop("elsewhere")
    profile, own = body.get("profile", "generic"), body.get("principles") or {}
    strange = sorted(set(own) - set(book["generic"]) - set(elsewhere))
    if profile not in book or strange:
        raise Unread(f"profile {profile} or principles {strange}")
    return {**book["generic"], **book[profile], **own}


class _Drawer:
    def __init__(self, body: Mapping[str, Any], rules: Mapping[str, str]) -> None:
        self.body = body
        self.drawn = d = Drawing(body, rules)
        d.boundaries = {b: v or {} for b, v in self._part("boundaries")}
        d.buffers = {*(body.get("buffers") or ()), *(body.get("traps") or ())}
        self.tracks = {name: self._track(items) for name, items in self._part("tracks")}
        self.mates: dict[str, str] = {}
        self._join_all()
        tracks = {name: (parts, places) for name, (_, parts, places, _) in self.tracks.items()}
        sides = {name: (self._beyond(f"{name}.start"), self._beyond(f"{name}.end")) for name in self.tracks}
        measures = Measures(body, tracks, sides, float(d.rules["leg_m"]))
        for name in self.tracks:
            self._draw_track(name, measures.lengths(name))
        for name, v in self._part("points"):
            self._draw_point(name, v)
        for name, v in self._part("crossings"):
            self._draw_crossing(name, v)
        for name, v in self._part("slips"):
            self._draw_slip(name, v)
        for name, v in self._part("derailers"):
            self._draw_derailer(name, v)
        for e in d.edges.values():
            for n in (e.a, e.b):
                d.at.setdefault(n, []).append(e)

    def _part(self, key: str) -> Iterator[tuple[str, Any]]:
        yield from (self.body.get(key) or {}).items()

    def _track(self, items: list[str]) -> tuple[str, Parts, dict[int, float], str]:
        ends = {*self.drawn.boundaries, *self.drawn.buffers}
        stated = [(x.strip(), "") if x.strip() in ends else item_parts(x) for x in items]
        outer = ("" if metres else name for name, metres in (stated[0], stated[-1]))
        first, last = (x if x in ends or ("." in x and "+" not in x) else "" for x in outer)
        return first, *parted(stated, ends), last

    # --- what is joined to what: `track.start`, `point.toe`, `crossing.1a`, the name of a boundary or buffer ---

    def _join_all(self) -> None:
        for t, (first, _, _, last) in self.tracks.items():
            self._join(f"{t}.start", first)
            self._join(f"{t}.end", last)
        for part, ends in (("points", ("toe", "normal", "reverse")), ("derailers", ("outer", "inner"))):
            for p, v in self._part(part):
                for end in ends:
                    self._join(f"{p}.{end}", v.get(end))
        for c, v in self._part("crossings"):
            self._join_arms(c, [arm["ends"] for arm in v["arms"]])
        for c, v in self._part("slips"):
            self._join_arms(c, v["arms"])

    def _join_arms(self, name: str, arms: list[list[str]]) -> None:
        for i, arm in enumerate(arms, 1):
            for side, ref in zip("ab", arm, strict=True):
                self._join(f"{name}.{i}{side}", ref)

    def _join(self, a: str, b: str | None) -> None:
        if not b:
            return
        known = "." in b or b in self.drawn.boundaries or b in self.drawn.buffers
        need(known, f"the layout knows no end {b}")
        for x, y in ((a, b), (b, a)):
            need(self.mates.setdefault(x, y) == y, f"the layout joins {x} twice")

    def _beyond(self, port: str) -> tuple[str, str]:
        """What lies beyond an end of track: its section, or the boundary or buffer; and what is joined there."""
        other = self.mates.get(port, "")
        return (self._section_at(other) if "." in other else other), other

    def _section_at(self, port: str) -> str:
        name, _, end = port.partition(".")
        if name in self.tracks:
            return self.tracks[name][1][0 if end == "start" else -1][0]
        if name in (self.body.get("crossings") or {}):
            return str(self.body["crossings"][name]["arms"][int(end[0]) - 1]["section"])
        parts = (v for k in ("points", "slips", "derailers") for p, v in self._part(k) if p == name)
        found = next(parts, None)
        if found is None:
            raise Rejected(f"the layout knows no {name}")
        return str(found["section"])

    def _node(self, port: str) -> str:
        other = self.mates.get(port)
        if other is None:
            raise Rejected(f"the layout joins {port} to nothing")
        for x in (port, other):
            if x in self.drawn.boundaries or x in self.drawn.buffers:
                return x
        a, b = sorted((self._section_at(port), self._section_at(other)))
        first, second = sorted((port, other))
        return f"{a}|{b}@{first}" if a != b else f"{a}@{first}+{second}"

    # --- edges ---------------------------------------------------------------------------------------

    def _edge(self, name: str, a: str, b: str, length: float, section: str) -> str:
        of = (self.body.get("sections") or {}).get(section) or {}
        way, inclined = of.get("one_way"), of.get("lane") == "inclined"
        a, b = (b, a) if way == "backward" else (a, b)
        self.drawn.edges[name] = Edge(name, a, b, section, length, way is not None, inclined)
        return name

    def _draw_track(self, name: str, parts: list[tuple[str, float]]) -> None:
        here = self._node(f"{name}.start")
        for i, (section, metres) in enumerate(parts):
            if i == len(parts) - 1:
                there = self._node(f"{name}.end")
            elif parts[i + 1][0] == section:
                there = f"{section}+{name}.{i}"
            else:
                a, b = sorted((section, parts[i + 1][0]))
                there = f"{a}|{b}@{name}.{i}"
            self._edge(f"{name}.{i}", here, there, metres, section)
            here = there

    def _leg(self, v: Mapping[str, Any]) -> float:
        return float(v.get("legs", self.drawn.rules["leg_m"]))

    def _fouling(self, v: Mapping[str, Any]) -> float:
        return float(v.get("fouling", self.drawn.rules["fouling_m"]))

    def _across(self, slip: Mapping[str, Any]) -> float:
        """From the middle of a slip, whose fouling points are counted from its points: not less than from a diamond."""
        return max(self._fouling(slip), self._fouling({}))

    def _outward(self, name: str, node: str, end: str, v: Mapping[str, Any], section: str) -> str:
        return self._edge(f"{name}.{end}", node, self._node(f"{name}.{end}"), self._leg(v), section)

    def _draw_point(self, p: str, v: Mapping[str, Any]) -> None:
        s = str(v["section"])
        toe, normal, reverse = (self._outward(p, p, end, v, s) for end in ("toe", "normal", "reverse"))
        work, kmh = v.get("work", "motor"), v.get("speed")
        need(work in ("motor", "hand"), f"point {p} is worked in an unknown way")
        machine = str(v.get("machine") or p)
        self.drawn.points[p] = Point(
            p, machine, s, toe, normal, reverse, self._fouling(v), work == "hand", None if kmh is None else float(kmh)
        )

    def _draw_crossing(self, c: str, v: Mapping[str, Any]) -> None:
        arms = []
        for i, arm in enumerate(v["arms"], 1):
            a, b = (self._outward(c, c, f"{i}{side}", v, str(arm["section"])) for side in "ab")
            arms.append((a, b))
        self.drawn.diamonds[c] = Diamond(c, (arms[0], arms[1]), self._fouling(v))

    def _draw_slip(self, c: str, v: Mapping[str, Any]) -> None:
        s, ends = str(v["section"]), (f"{c}a", f"{c}b")
        machines = list(v.get("machines") or ends)
        alone = not v.get("single") and bool(v.get("machines")) and len(set(machines)) == 1

        def point(side: int, toe: str, normal: str, reverse: str, name: str = "") -> None:
            name = name or ends[side]
            machine = machines[side % len(machines)]
            self.drawn.points[name] = Point(name, machine, s, toe, normal, reverse, self._fouling(v))

        if alone:  # one machine: straight on over the diamond, or over the slip rails
            legs = {}
            for k, (x, y) in enumerate((("1a", "2b"), ("2a", "1b")), 1):
                curve = self._edge(f"{c}.s{k}", f"{c}/{x}", f"{c}/{y}", self._leg(v), s)
                for e in (x, y):
                    legs[e] = self._edge(f"{c}.{e}x", f"{c}/{e}", c, self._leg(v) / 2, s)
                    point(0, self._outward(c, f"{c}/{e}", e, v, s), legs[e], curve, f"{c}/{e}")
            self.drawn.diamonds[c] = Diamond(c, ((legs["1a"], legs["1b"]), (legs["2a"], legs["2b"])), self._across(v))
            return
        if not v.get("single"):
            middle = self._edge(f"{c}.m", *ends, 1.0, s)
            for i, side in enumerate("ba" if v.get("blades") == "near" else "ab"):
                point(i, middle, *(self._outward(c, ends[i], f"{n}{side}", v, s) for n in (1, 2)))
            return
        curve = self._edge(f"{c}.s", *ends, self._leg(v), s)
        arms = {}
        for i, end in enumerate(str(v["single"]).split("-")):
            straight = self._edge(f"{c}.{end}x", ends[i], c, self._leg(v) / 2, s)
            point(i, self._outward(c, ends[i], end, v, s), straight, curve)
            other = f"{end[0]}{'b' if end[1] == 'a' else 'a'}"
            arms[end[0]] = straight, self._outward(c, c, other, v, s)
        self.drawn.diamonds[c] = Diamond(c, (arms["1"], arms["2"]), self._across(v))

    def _draw_derailer(self, d: str, v: Mapping[str, Any]) -> None:
        s, off = str(v["section"]), f"{d}.off"
        outer, inner = (self._outward(d, d, end, v, s) for end in ("outer", "inner"))
        rails = self._edge(f"{d}.off", d, off, 1.0, s)
        self.drawn.buffers.add(off)
        self.drawn.off_rails.add(off)
        self.drawn.points[d] = Point(d, str(v.get("machine") or d), s, outer, rails, inner, 1.0)
