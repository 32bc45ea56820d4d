"""The railway of a layout: sections with their ends and ways through them, signals with their paths, machines, berths.

Made from the drawing, in the field's terms.
"""

from __future__ import annotations

import hashlib
import re
import unicodedata
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property, lru_cache
from itertools import pairwise
from typing import Any

from interlock.checker.drawing import Drawing, Edge, Unread, drawing
from interlock.checker.kilometres import item_parts
from interlock.checker.language import elements
from interlock.verify import need


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
    """A way through a section from one end to another, numbered from 1 by its ends and edges.

    points: each point on it, and how it must lie.  arms: each diamond on it, and over which arm (0 or 1).
    """

    section: str
    number: int
    entry: str
    exit: str
    points: tuple[tuple[str, Demand], ...]
    arms: tuple[tuple[str, int], ...]
    edges: tuple[str, ...]
    length: float


@dataclass(frozen=True)
class Signal:
    """A signal at a node, read by trains going into a section."""

    name: str
    node: str
    into: str
    kind: str = "main"
    call_on: bool = False

    @property
    def main(self) -> bool:
        """Trains obey it; they pass a shunt signal whatever it shows."""
        return self.kind != "shunt"

    @property
    def shunt(self) -> bool:
        """It calls shunting movements, too; these obey every signal."""
        return self.kind != "main"

    @property
    def safe(self) -> str:
        """The name as part of a variable."""
        return safe(self.name)


@dataclass(frozen=True)
class Calling:
    """What a signal shows to trains, or to shunting movements; `go`, `accept`, `lamp` begin the names of variables."""

    signal: Signal
    shunt: bool

    @property
    def name(self) -> str:
        return self.signal.name

    @property
    def go(self) -> str:
        return "gos" if self.shunt else "go"

    @property
    def accept(self) -> str:
        return "accepts" if self.shunt else "accept"

    @property
    def lamp(self) -> str:
        return "lamps" if self.shunt else "lamp"


@dataclass(frozen=True)
class Path:
    """Ways one after the other; `berth`: a shunting movement ends in the last one, where vehicles may stand."""

    ways: tuple[Way, ...]
    berth: bool = False

    @property
    def last(self) -> Way:
        return self.ways[-1]


@dataclass(frozen=True)
class Run:
    """Paths of a train one after the other, and the signals at identifier light between them."""

    parts: tuple[Path, ...]
    passed: tuple[Signal, ...]

    @property
    def last(self) -> Path:
        return self.parts[-1]

    @property
    def whole(self) -> Path:
        """Over all parts."""
        return Path(tuple(w for p in self.parts for w in p.ways))


def safe(name: str) -> str:
    """A layout's name as part of a variable: what the page of the language says under "Names in PLC text"."""
    text = re.sub("[-/ ]", "_", name)
    return text if re.fullmatch("[A-Za-z0-9_]{1,14}", text) else _read(name, text)


@lru_cache(maxsize=1024)
def _read(name: str, text: str) -> str:
    """What can be read of a name, and four signs that depend on all of it."""
    read = ""
    for sign in unicodedata.normalize("NFKD", text):
        told = unicodedata.name(sign, "").split(" LETTER ")
        last = told[-1].split(" ")[-1]
        if sign == "_" or (sign < "\x80" and sign.isalnum()):
            read += sign
        elif sign >= "\x80" and sign.isalnum():
            if len(told) > 1 and re.fullmatch("[A-Z]+", last):
                read += last.lower() if told[0].endswith(" SMALL") else last
            else:
                read += format(ord(sign), "X")
    bits = int(hashlib.sha256(name.encode()).hexdigest()[:6], 16)
    check = ["abcdefghijkmnpqrstuvwxyz23456789"[bits // 32**k % 32] for k in range(4)]
    return read[:9].strip("_") + "_" + "".join(check)


class Railway:
    """A layout, read."""

    def __init__(self, body: Mapping[str, Any]) -> None:
        self.body = body
        self.drawn: Drawing = drawing(body)
        d = self.drawn
        self.boundaries, self.buffers, self.points = d.boundaries, d.buffers, d.points
        self.approach = {b: item_parts(v["approach"])[0] for b, v in self.boundaries.items() if v.get("approach")}
        self.sections = sorted({e.section for e in d.edges.values()})
        self.told: Mapping[str, Mapping[str, str]] = body.get("sections") or {}
        self.undetected = sorted(s for s in self.sections if self._told(s, "detected") in ("no", "false"))
        touch: dict[str, set[str]] = {}
        for e in d.edges.values():
            for n in (e.a, e.b):
                touch.setdefault(n, set()).add(e.section)
        self._touch = touch
        self.ends = {s: sorted(n for n, those in touch.items() if s in those and self._end(n)) for s in self.sections}
        self.ways = {s: list(self._through(s)) for s in self.sections}
        self.signals = {g: self._signal(g, v) for g, v in (body.get("signals") or {}).items()}
        self.signal_into = {(g.node, g.into): g for g in self.signals.values()}
        self.main_into = {k: g for k, g in self.signal_into.items() if g.main}
        self.shunting = any(g.shunt for g in self.signals.values())
        self.devices = {
            str(k): sorted(v["over"])
            for part in ("level_crossings", "interlocks")
            for k, v in (body.get(part) or {}).items()
        }
        self._distinct()
        self._limits()

    def _distinct(self) -> None:
        """No variable is of two elements; to a compiler small and capital letters are the same."""
        machines = {p.machine for p in self.points.values()} | set(self.devices)
        for kind, those in {**elements(self.body), "machine": machines}.items():
            need(len({safe(n).upper() for n in those}) == len(those), f"two names of a {kind} are one name in the text")

    def _limits(self) -> None:
        """What is read but could mean more than this reader knows."""
        for b, v in self.boundaries.items():
            if v.get("block", "none") not in ("none", "semi-automatic", "automatic", "token"):
                raise Unread(f"the block of boundary {b}")
        for g, v in (self.body.get("signals") or {}).items():
            known = {"from", "into", "at", "km", "xy", "kind", "call_on", "stops_trains", "release", "identifier"}
            if set(v) - known:
                raise Unread(f"something of signal {g}")
        for g, v in (self.body.get("overlaps") or {}).items():
            known = {"length", "speed", "falling", "successive", "swing", "entry_speed", "release", "release_by_length"}
            own = [set(x) - {"over", "length", "falling", "entry_speed"} for x in v.get("ways") or ()]
            if set(v) - {*known, "ways", "not_over"} or any(own):
                raise Unread(f"something of the overlap of {g}")
        for s, v in self.told.items():
            if set(v) - {"lane", "one_way", "speed", "detected", "berth"}:
                raise Unread(f"something of section {s}")

    def _told(self, section: str, key: str) -> str | None:
        return (self.told.get(section) or {}).get(key)

    # --- sections -----------------------------------------------------------------------------------

    def _end(self, node: str) -> bool:
        if node in self.boundaries or node in self.buffers:
            return True
        return node not in self.points and node not in self.drawn.diamonds and len(self._touch[node]) > 1

    def beyond(self, section: str, node: str) -> str | None:
        """The neighbour across an end."""
        return next((s for s in sorted(self._touch.get(node, ())) if s != section), None)

    def _through(self, section: str) -> Iterator[Way]:
        d = self.drawn
        found: list[tuple[str, str, tuple[str, ...]]] = []

        def go(node: str, path: tuple[Edge, ...], start: str, seen: frozenset[str]) -> None:
            e = path[-1]
            there = e.far(node)
            if (e.one_way and e.a != node) or there in d.off_rails:
                return
            if self._end(there):
                found.append((start, there, tuple(x.name for x in path)))
                return
            for onward in d.onward(there, e) if there not in seen else ():
                if onward.section == section:
                    go(there, (*path, onward), start, seen | {there})

        for start in self.ends[section]:
            for e in d.at[start]:
                if e.section == section:
                    go(start, (e,), start, frozenset({start}))
        for number, (a, b, names) in enumerate(sorted(found), 1):
            metres = sum(d.edges[n].length for n in names)
            yield Way(section, number, a, b, *self._passed(a, names), names, metres)

    def _passed(
        self, node: str, names: tuple[str, ...]
    ) -> tuple[tuple[tuple[str, Demand], ...], tuple[tuple[str, int], ...]]:
        """The points and diamonds over which edges lead."""
        d, points, arms = self.drawn, [], []
        for a, b in pairwise(names):
            node = d.edges[a].far(node)
            point, diamond = d.points.get(node), d.diamonds.get(node)
            if point is not None:
                x = point.position(b if a == point.toe else a)
                need(x is not None, f"a way leads over point {node} from leg to leg")
                points.append((node, Demand(point.machine, str(x))))
            if diamond is not None:
                arms.append((node, 0 if a in diamond.arms[0] else 1))
        return tuple(points), tuple(arms)

    def from_end(self, section: str, node: str) -> list[Way]:
        """The ways through a section from one of its ends."""
        return [w for w in self.ways[section] if w.entry == node]

    def signals_out(self, s: str) -> list[Signal]:
        """The signals that govern leaving a section over its joints."""
        found = [self.signal_into.get((j, self.beyond(s, j) or "")) for j in self.ends[s]]
        return [g for g in found if g is not None]

    @cached_property
    def standing(self) -> frozenset[str]:
        """Plain sections that are left over their joints only on a signal, one of them a shunt signal."""

        def stands(s: str) -> bool:
            joints = [j for j in self.ends[s] if self.beyond(s, j) is not None]
            out = self.signals_out(s)
            plain = not any(w.points or w.arms for w in self.ways[s])
            return plain and len(out) == len(joints) and any(g.shunt for g in out)

        return frozenset(s for s in self.sections if stands(s))

    @cached_property
    def berths(self) -> frozenset[str]:
        """Where shunting movements end and may find vehicles: not under a door, on a bridge, or over a crossing, nor
        where the layout says no."""
        return self.standing - self._denied - {s for over in self.devices.values() for s in over}

    @cached_property
    def turning(self) -> frozenset[str]:
        """Roads that the layout denies to be berths: before a boundary shunting movements end in them, too."""
        return self.standing & self._denied - {s for over in self.devices.values() for s in over}

    @property
    def _denied(self) -> frozenset[str]:
        return frozenset(s for s in self.told if self._told(s, "berth") in ("no", "false"))

    @cached_property
    def machines(self) -> dict[str, list[str]]:
        """Machines of points and devices, each with the sections of its ends, or over which it stands."""
        found: dict[str, set[str]] = {d: set(over) for d, over in self.devices.items()}
        for p in self.points.values():
            found.setdefault(p.machine, set()).add(p.section)
        return {m: sorted(found[m]) for m in sorted(found)}

    # --- signals ------------------------------------------------------------------------------------

    def _signal(self, name: str, v: Mapping[str, str]) -> Signal:
        rear, into, kind = v["from"], v["into"], v.get("kind", "main")
        nodes = [rear] if rear in self.boundaries else [n for n in self.ends[into] if self.beyond(into, n) == rear]
        near = v.get("at")
        if near:
            p = self.points.get(near)
            legs = set() if p is None else {p.toe, p.normal, p.reverse}
            nodes = [n for n in nodes if any(e.name in legs for e in self.drawn.at[n])]
        need(len(nodes) == 1, f"signal {name} stands nowhere, or in two places")
        need(kind in ("main", "shunt", "combined", "board", "limit"), f"signal {name} is of an unknown kind")
        kind = {"board": "main", "limit": "shunt"}.get(kind, kind)  # whose routes end there
        if v.get("stops_trains") in ("yes", "true"):
            kind = "combined"
        return Signal(name, nodes[0], into, kind, v.get("call_on") in ("yes", "true"))

    def callings(self, g: Signal) -> list[Calling]:
        """Whom a signal speaks to."""
        return [*([Calling(g, False)] if g.main else []), *([Calling(g, True)] if g.shunt else [])]

    @cached_property
    def _paths(self) -> dict[Calling, list[Path]]:
        return {c: list(self._search(c)) for g in self.signals.values() for c in self.callings(g)}

    def paths(self, c: Calling) -> list[Path]:
        """Every path to the next signal that the movement obeys, to a boundary or the end of the track.

        A shunting movement obeys every signal, ends in the first berth, and does not leave over a boundary: it ends
        before one in a road that the layout denies to be a berth, and elsewhere there is no path.
        """
        return self._paths[c]

    def _search(self, c: Calling) -> Iterator[Path]:
        stops = self.signal_into if c.shunt else self.main_into

        def go(section: str, entry: str, before: tuple[Way, ...]) -> Iterator[Path]:
            for w in self.from_end(section, entry):
                ways, ahead = (*before, w), self.beyond(section, w.exit)
                berth = c.shunt and section in self.berths
                ends = berth or section in self.turning
                if ahead is None and c.shunt and not ends and w.exit in self.boundaries:
                    continue
                if ahead is None or (w.exit, ahead) in stops or berth:
                    yield Path(ways, berth and len(ways) > 1)
                elif all(x.section != ahead for x in ways):
                    yield from go(ahead, w.exit, ways)

        return go(c.signal.into, c.signal.node, ())

    def excluded(self, c: Calling, p: Path) -> bool:
        """No route runs over this path: none can, or the author does not want one."""
        return not self.can_be(c, p) or self.unwanted(c, p)

    def can_be(self, c: Calling, p: Path) -> bool:
        """A route may begin here, run over this path, and end or leave where it does."""
        out = c.shunt or self.boundaries.get(p.last.exit, {}).get("trains", "both") != "in"
        leads_on = out and p.last.exit not in (self.body.get("traps") or ())
        return (leads_on or p.berth) and self._opens(c) and can_be_run(self, p)

    def unwanted(self, c: Calling, p: Path) -> bool:
        """The author excludes a route over this path."""
        return any(self.chosen(x, c, p) for x in self.body.get("exclude") or ())

    def _opens(self, c: Calling) -> bool:
        """Nothing begins at a board, and no train at a shunt signal at which trains end."""
        v = self.body["signals"][c.name]
        return v.get("kind") not in ("board", "limit") and (c.shunt or v.get("stops_trains") not in ("yes", "true"))

    def chosen(self, x: Mapping[str, Any], c: Calling, p: Path) -> bool:
        """A route over this path begins, ends and passes as the author says."""
        ahead = self.signal_into.get((p.last.exit, self.beyond(p.last.section, p.last.exit) or ""))
        ends = {p.last.section, p.last.exit, *([ahead.name] if ahead is not None else [])}
        return (
            x.get("from", c.name) == c.name
            and x.get("to", p.last.exit) in ends
            and set(x.get("via") or ()) <= {w.section for w in p.ways}
            and not set(x.get("not_via") or ()) & {w.section for w in p.ways}
            and x.get("kind") in (None, "shunt" if c.shunt else "main")
        )


def runs(r: Railway, p: Path) -> Iterator[Run]:
    """From a train's path on past one signal after the other, none twice, that has an identifier light."""
    found = [Run((p,), ())]
    while found:
        u = found.pop()
        for g in passed_after(r, u.last):
            for q in () if g in u.passed else r.paths(Calling(g, False)):
                found.append(Run((*u.parts, q), (*u.passed, g)))
                yield found[-1]


def passed_after(r: Railway, p: Path) -> list[Signal]:
    """The signal at the end of a path, where the layout gives it an identifier light."""
    g = r.main_into.get((p.last.exit, r.beyond(p.last.section, p.last.exit) or ""))
    return [g] if g is not None and r.body["signals"][g.name].get("identifier") in ("yes", "true") else []


def can_be_run(r: Railway, p: Path) -> bool:
    """Every machine is needed in one position, as its key permits; a diamond is passed once; all is detected."""
    demands = {d for w in p.ways for _, d in w.points}
    once = len({d.machine for d in demands}) == len(demands)
    arms = [d for w in p.ways for d, _ in w.arms]
    locked = {x.machine for x in r.points.values() if x.keyed}
    keyed = any(d.machine in locked and d.position == "R" for d in demands)
    seen = all(w.section not in r.undetected for w in p.ways[: -1 if p.berth else None])
    return once and len(set(arms)) == len(arms) and not keyed and seen
