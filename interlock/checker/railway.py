"""What a layout file says: sections with their ends, ways through them, signals and the paths that they lead over.

Read with PyYAML and nothing of the product's own reading.  A joint between sections a and b is named `a|b@` and the end
of a track, point or crossing that lies there first in the alphabet, or the place on a track: only so can the names of a
written system be compared.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from typing import Any

from interlock.verify import Rejected, need

READ = frozenset(
    {
        "interlock",
        "name",
        "title",
        "profile",
        "principles",
        "boundaries",
        "buffers",
        "traps",
        "tracks",
        "points",
        "signals",
    }
    | {"sections", "conditions", "routes", "voyages", "automatic", "substations", "addresses", "drawing", "telegram"}
    | {"exclude", "allow"}
)
"""The keys that this reader understands; `routes` to `allow` say nothing of the world."""


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


@dataclass(frozen=True)
class Demand:
    """A machine and the position in which a way needs it."""

    machine: str
    position: str

    @property
    def opposite(self) -> str:
        return "R" if self.position == "N" else "N"


@dataclass(frozen=True)
class Way:
    """A way through a section from one end to another, numbered from 1 by its ends and edges."""

    section: str
    number: int
    entry: str
    exit: str
    points: tuple[tuple[str, Demand], ...]
    edges: tuple[str, ...]


@dataclass(frozen=True)
class Signal:
    """A main signal at a node, read by trains going into a section."""

    name: str
    node: str
    into: str

    @property
    def safe(self) -> str:
        """The name as part of a variable."""
        return self.name.replace("-", "_").replace("/", "_")


Path = tuple[Way, ...]


def _text(x: Any) -> str:
    return str(x).strip()


class Railway:
    """A layout, read."""

    def __init__(self, body: dict[str, Any]) -> None:
        strange = sorted(set(body) - READ)
        if strange:
            raise Unread(", ".join(strange))
        self.body = body
        self.boundaries: dict[str, dict[str, Any]] = {k: v or {} for k, v in (body.get("boundaries") or {}).items()}
        self.buffers = [_text(b) for b in (*(body.get("buffers") or ()), *(body.get("traps") or ()))]
        self.points: dict[str, dict[str, Any]] = body.get("points") or {}
        self.approach = {b: _text(v["approach"]).split()[0] for b, v in self.boundaries.items() if v.get("approach")}
        self._limits()
        self.tracks = self._tracks()
        self.mates = self._mates()
        self.edges = list(self._edges())
        self.at: dict[str, list[Edge]] = {}
        for e in self.edges:
            for n in (e.a, e.b):
                self.at.setdefault(n, []).append(e)
        self.sections = sorted({e.section for e in self.edges})
        self.ends = {
            s: sorted({n for e in self.edges if e.section == s for n in (e.a, e.b) if self._end(n)})
            for s in self.sections
        }
        self.ways = {s: list(self._through(s)) for s in self.sections}
        self.signals = {str(g): self._signal(str(g), v) for g, v in (body.get("signals") or {}).items()}
        self.signal_into = {(g.node, g.into): g for g in self.signals.values()}

    def _limits(self) -> None:
        """What is read but means more than this reader knows."""
        for b, v in self.boundaries.items():
            if (
                v.get("block", "none") not in ("none", "semi-automatic", "automatic")
                or v.get("block", "none") != "none"
            ):
                raise Unread(f"the block of boundary {b}")
        for g, v in (self.body.get("signals") or {}).items():
            if set(v) - {"from", "into", "at"}:
                raise Unread(f"what signal {g} is beside a main signal")
        for p, v in self.points.items():
            if v.get("work", "power") != "power" or v.get("machine"):
                raise Unread(f"the work or machine of point {p}")
        for s, v in (self.body.get("sections") or {}).items():
            if set(v) - {"lane", "one_way", "speed"}:
                raise Unread(f"what is said of section {s}")
        known = {"approach_release_s", "shunt_release_s", "release_delay_s", "point_supervision_s", "local_requests"}
        known |= {"restart_delay_s", "priorities", "priority_wait_s", "line_speed_kmh", "leg_m", "drive_points"}
        strange = set(self.body.get("principles") or {}) - known
        if strange or self.body.get("profile", "generic") not in ("mine",):
            raise Unread(f"profile {self.body.get('profile', 'generic')} or principles {sorted(strange)}")

    # --- the drawing ------------------------------------------------------------------------------

    def _tracks(self) -> dict[str, tuple[str, list[tuple[str, float]], str]]:
        found = {}
        for name, items in (self.body.get("tracks") or {}).items():
            words = [_text(x).split() for x in items]
            first = words[0][0] if len(words[0]) == 1 else ""
            last = words[-1][0] if len(words[-1]) == 1 else ""
            found[str(name)] = (first, [(w[0], float(w[1])) for w in words if len(w) == 2], last)
        return found

    def _port(self, ref: str) -> str:
        """`track.start` and the like; a boundary or buffer by its name."""
        name = ref.strip()
        if "." not in name:
            need(name in self.boundaries or name in self.buffers, f"the layout knows no end {name}")
        return name

    def _mates(self) -> dict[str, str]:
        found: dict[str, str] = {}

        def join(a: str, b: str) -> None:
            for x, y in ((a, b), (b, a)):
                need(found.setdefault(x, y) == y, f"the layout joins {x} twice")

        for t, (first, _, last) in self.tracks.items():
            if first:
                join(f"{t}.start", self._port(first))
            if last:
                join(f"{t}.end", self._port(last))
        for p, v in self.points.items():
            for end in ("toe", "normal", "reverse"):
                if v.get(end) is not None:
                    join(f"{p}.{end}", self._port(_text(v[end])))
        return found

    def _section_at(self, port: str) -> str:
        name, _, end = port.partition(".")
        if name in self.tracks:
            return self.tracks[name][1][0 if end == "start" else -1][0]
        return str(self.points[name]["section"])

    def _node(self, port: str) -> str:
        other = self.mates.get(port)
        if other is None:
            raise Rejected(f"the layout joins {port} to nothing")
        for x in (port, other):
            if x in self.boundaries or x in self.buffers:
                return x
        a, b = sorted((self._section_at(port), self._section_at(other)))
        first, second = sorted((port, other))
        return f"{a}|{b}@{first}" if a != b else f"{a}@{first}+{second}"

    def _edges(self) -> Iterator[Edge]:
        told = self.body.get("sections") or {}

        def edge(name: str, a: str, b: str, length: float, section: str) -> Edge:
            way = (told.get(section) or {}).get("one_way")
            return Edge(name, *((b, a) if way == "backward" else (a, b)), section, length, way is not None)

        for t, (_, parts, _) in self.tracks.items():
            here = self._node(f"{t}.start")
            for i, (section, metres) in enumerate(parts):
                if i == len(parts) - 1:
                    there = self._node(f"{t}.end")
                elif parts[i + 1][0] == section:
                    there = f"{section}+{t}.{i}"
                else:
                    a, b = sorted((section, parts[i + 1][0]))
                    there = f"{a}|{b}@{t}.{i}"
                yield edge(f"{t}.{i}", here, there, metres, section)
                here = there
        legs = float((self.body.get("principles") or {}).get("leg_m", 20))
        for p, v in self.points.items():
            for end in ("toe", "normal", "reverse"):
                yield edge(
                    f"{p}.{end}", str(p), self._node(f"{p}.{end}"), float(v.get("legs", legs)), str(v["section"])
                )

    # --- sections -----------------------------------------------------------------------------------

    def _end(self, node: str) -> bool:
        if node in self.boundaries or node in self.buffers:
            return True
        return node not in self.points and len({e.section for e in self.at[node]}) > 1

    def beyond(self, section: str, node: str) -> str | None:
        """The neighbour across an end."""
        return next((e.section for e in self.at.get(node, ()) if e.section != section), None)

    def _through(self, section: str) -> Iterator[Way]:
        found: list[tuple[str, str, tuple[str, ...]]] = []

        def go(node: str, path: tuple[Edge, ...], start: str) -> None:
            e = path[-1]
            if e.one_way and e.a != node:
                return
            there = e.b if e.a == node else e.a
            if self._end(there):
                found.append((start, there, tuple(x.name for x in path)))
                return
            for onward in self._onward(there, e):
                if onward.section == section and onward not in path:
                    go(there, (*path, onward), start)

        for start in self.ends[section]:
            for e in self.at[start]:
                if e.section == section:
                    go(start, (e,), start)
        for number, (a, b, names) in enumerate(sorted(found), 1):
            yield Way(section, number, a, b, tuple(self._points(names)), names)

    def _onward(self, node: str, e: Edge) -> list[Edge]:
        """Over a point from the toe to either leg, from a leg to the toe; else straight on."""
        others = [x for x in self.at[node] if x is not e]
        if node in self.points and e.name != f"{node}.toe":
            return [x for x in others if x.name == f"{node}.toe"]
        return others

    def _points(self, names: tuple[str, ...]) -> Iterator[tuple[str, Demand]]:
        for a, b in pairwise(names):
            p = a.partition(".")[0]
            if p in self.points and b.startswith(p + "."):
                leg = b if a.endswith(".toe") else a
                yield p, Demand(p, "N" if leg.endswith(".normal") else "R")

    # --- signals ------------------------------------------------------------------------------------

    def _signal(self, name: str, v: dict[str, Any]) -> Signal:
        rear, into = _text(v["from"]), _text(v["into"])
        if rear in self.boundaries:
            return Signal(name, rear, into)
        nodes = [n for n in self.ends[into] if self.beyond(into, n) == rear]
        if len(nodes) > 1 and v.get("at"):
            nodes = [n for n in nodes if _text(v["at"]) in n]
        need(len(nodes) == 1, f"signal {name} stands nowhere, or in two places")
        return Signal(name, nodes[0], into)

    @cached_property
    def _paths(self) -> dict[str, list[Path]]:
        return {g: list(self._search(s)) for g, s in self.signals.items()}

    def paths(self, g: str) -> list[Path]:
        """Every path from a signal to the next one, a boundary or a buffer."""
        return self._paths[g]

    def _search(self, g: Signal) -> Iterator[Path]:
        def go(section: str, entry: str, path: Path) -> Iterator[Path]:
            for w in self.ways[section]:
                if w.entry != entry:
                    continue
                ahead = self.beyond(section, w.exit)
                if ahead is None or (w.exit, ahead) in self.signal_into:
                    yield (*path, w)
                elif all(x.section != ahead for x in (*path, w)):
                    yield from go(ahead, w.exit, (*path, w))

        return go(g.into, g.node, ())
