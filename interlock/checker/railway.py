"""The railway of a layout: signals with their paths over the track, machines, berths.

Made from the drawing, in the field's terms.
"""

from __future__ import annotations

import hashlib
import re
import unicodedata
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import Any

from interlock.checker.drawing import Drawing, Unread, drawing
from interlock.checker.kilometres import item_parts
from interlock.checker.language import elements
from interlock.checker.track import Track, Way
from interlock.verify import need


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
    def callings(self) -> list[Calling]:
        """Whom it speaks to."""
        return [*([Calling(self, False)] if self.main else []), *([Calling(self, True)] if self.shunt else [])]

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
        """The signal's."""
        return self.signal.name

    @property
    def go(self) -> str:
        """A movement has accepted it (state)."""
        return "gos" if self.shunt else "go"

    @property
    def accept(self) -> str:
        """A driver accepts it in this step (event)."""
        return "accepts" if self.shunt else "accept"

    @property
    def lamp(self) -> str:
        """It was shown a scan ago (state)."""
        return "lamps" if self.shunt else "lamp"


@dataclass(frozen=True)
class Path:
    """Ways one after the other; `berth`: a shunting movement ends in the last one, where vehicles may stand."""

    ways: tuple[Way, ...]
    berth: bool = False

    @property
    def last(self) -> Way:
        """The way through its last section."""
        return self.ways[-1]


@dataclass(frozen=True)
class Run:
    """Paths of a train one after the other, and the signals at identifier light between them."""

    parts: tuple[Path, ...]
    passed: tuple[Signal, ...]

    @property
    def last(self) -> Path:
        """The path past the last signal."""
        return self.parts[-1]

    @property
    def whole(self) -> Path:
        """Over all parts."""
        return Path(tuple(w for p in self.parts for w in p.ways))


@lru_cache(1 << 16)
def safe(name: str) -> str:
    """A layout's name as part of a variable: what the page of the language says under "Names in PLC text"."""
    text = re.sub("[-/ ]", "_", name)
    return text if re.fullmatch("(?!(?i:trig|edge)$)[A-Za-z0-9_]{1,14}", text) else _read(name, text)


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
    """A layout, read: its track, the signals and devices that stand on it, and the paths between signals."""

    def __init__(self, body: Mapping[str, Any]) -> None:
        self.body = body
        self.drawn: Drawing = drawing(body)
        boundaries = self.drawn.boundaries
        self.approach = {b: item_parts(v["approach"])[0] for b, v in boundaries.items() if v.get("approach")}
        self.track = Track(self.drawn, body.get("sections") or {})
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
        self._guarded()
        self._limits()
        self.paths = Paths(self)

    def _distinct(self) -> None:
        """No variable is of two elements; to a compiler small and capital letters are the same."""
        machines = {p.machine for p in self.drawn.points.values()} | set(self.devices)
        for kind, those in {**elements(self.body), "machine": machines}.items():
            need(len({safe(n).upper() for n in those}) == len(those), f"two names of a {kind} are one name in the text")
        taken = {n.upper() for p in self.drawn.points.values() for n in (p.name, p.machine)}
        for n in (str(k).upper() for part in ("level_crossings", "interlocks") for k in self.body.get(part) or ()):
            need(
                n not in taken,
                f"the level crossing or interlock {n} bears the name of another, or of a point or machine",
            )
            taken.add(n)

    def _guarded(self) -> None:
        """Where trains come in stands a signal that they obey: past another they come whatever it shows, and nothing is
        asked of a train that no signal has let in."""
        for b, v in self.drawn.boundaries.items():
            guarded = (b, self.drawn.at[b][0].section) in self.main_into
            need(
                v.get("trains", "both") == "out" or guarded,
                f"trains come in at {b}, and no signal stands there that they obey",
            )

    def _limits(self) -> None:
        """What is read but could mean more than this reader knows."""
        for b, v in self.drawn.boundaries.items():
            if v.get("block", "none") not in ("none", "semi-automatic", "automatic", "token"):
                raise Unread(f"the block of boundary {b}")
        for g, v in (self.body.get("signals") or {}).items():
            known = {"from", "into", "at", "km", "xy", "kind", "call_on", "stops_trains", "release", "identifier"}
            if set(v) - known:
                raise Unread(f"something of signal {g}")
        for g, v in (self.body.get("overlaps") or {}).items():
            known = {"length", "speed", "falling", "successive", "swing", "entry_speed", "release", "release_by_length"}
            own = [set(x) - {"over", "length", "falling", "entry_speed"} for x in v.get("ways") or ()]
            falls = [x for x in (v, *(v.get("ways") or ())) if float(x.get("falling", 0))]
            passed_over = any("length" in x or x.get("successive") in ("yes", "true") for x in falls)
            if set(v) - {*known, "ways", "not_over"} or any(own) or passed_over:
                raise Unread(f"something of the overlap of {g}")
        for s, v in (self.body.get("sections") or {}).items():
            if set(v) - {"lane", "one_way", "speed", "detected", "berth"}:
                raise Unread(f"something of section {s}")

    def _signal(self, name: str, v: Mapping[str, str]) -> Signal:
        rear, into, kind = v["from"], v["into"], v.get("kind", "main")
        joints = [n for n in self.track.ends[into] if self.track.beyond(into, n) == rear]
        nodes = [rear] if rear in self.drawn.boundaries else joints
        near = v.get("at")
        if near:
            p = self.drawn.points.get(near)
            legs = set() if p is None else {p.toe, p.normal, p.reverse}
            nodes = [n for n in nodes if any(e.name in legs for e in self.drawn.at[n])]
        need(len(nodes) == 1, f"signal {name} stands nowhere, or in two places")
        need(kind in ("main", "shunt", "combined", "board", "limit"), f"signal {name} is of an unknown kind")
        kind = {"board": "main", "limit": "shunt"}.get(kind, kind)  # whose routes end there
        if v.get("stops_trains") in ("yes", "true"):
            kind = "combined"
        return Signal(name, nodes[0], into, kind, v.get("call_on") in ("yes", "true"))

    def signals_out(self, s: str) -> list[Signal]:
        """The signals that govern leaving a section over its joints."""
        found = [self.signal_into.get((j, self.track.beyond(s, j) or "")) for j in self.track.ends[s]]
        return [g for g in found if g is not None]

    @cached_property
    def standing(self) -> frozenset[str]:
        """Plain sections that are left over their joints only on a signal, one of them a shunt signal."""

        def stands(s: str) -> bool:
            joints = [j for j in self.track.ends[s] if self.track.beyond(s, j) is not None]
            out = self.signals_out(s)
            plain = not any(w.points or w.arms for w in self.track.ways[s])
            return plain and len(out) == len(joints) and any(g.shunt for g in out)

        return frozenset(s for s in self.track.sections if stands(s))

    @cached_property
    def berths(self) -> frozenset[str]:
        """Where shunting movements end and may find vehicles: not under a door, on a bridge, or over a crossing, nor
        where the layout says no."""
        return self.standing - {*self.track.denied("berth")} - {s for over in self.devices.values() for s in over}

    @cached_property
    def turning(self) -> frozenset[str]:
        """Roads that the layout denies to be berths: before a boundary shunting movements end in them, too."""
        return self.standing & {*self.track.denied("berth")} - {s for over in self.devices.values() for s in over}

    @cached_property
    def machines(self) -> dict[str, list[str]]:
        """Machines of points and devices, each with the sections of its ends, or over which it stands."""
        found: dict[str, set[str]] = {d: set(over) for d, over in self.devices.items()}
        for p in self.drawn.points.values():
            found.setdefault(p.machine, set()).add(p.section)
        return {m: sorted(found[m]) for m in sorted(found)}


def air_locks(r: Railway) -> dict[str, str]:
    """The air lock of each device that is a door of one."""
    listed = r.body.get("interlocks") or {}
    return {str(m): str(v["air_lock"]) for m, v in listed.items() if v.get("air_lock")}


class Paths:
    """Over which a movement may run from a signal, and on which of them the author wants a route."""

    def __init__(self, railway: Railway) -> None:
        self._r, self._track = railway, railway.track

    @cached_property
    def _paths(self) -> dict[Calling, list[Path]]:
        return {c: list(self._search(c)) for g in self._r.signals.values() for c in g.callings}

    def of(self, c: Calling) -> list[Path]:
        """Every path to the next signal that the movement obeys, to a boundary or the end of the track.

        A shunting movement obeys every signal, ends in the first berth, and does not leave over a boundary: it ends
        before one in a road that the layout denies to be a berth, and elsewhere there is no path.
        """
        return self._paths[c]

    def _search(self, c: Calling) -> Iterator[Path]:
        stops = self._r.signal_into if c.shunt else self._r.main_into

        def go(section: str, entry: str, before: tuple[Way, ...]) -> Iterator[Path]:
            for w in self._track.from_end(section, entry):
                ways, ahead = (*before, w), self._track.beyond(section, w.exit)
                berth = c.shunt and section in self._r.berths
                ends = berth or section in self._r.turning
                if ahead is None and c.shunt and not ends and w.exit in self._r.drawn.boundaries:
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
        out = c.shunt or self._r.drawn.boundaries.get(p.last.exit, {}).get("trains", "both") != "in"
        leads_on = out and p.last.exit not in (self._r.body.get("traps") or ())
        return (leads_on or p.berth) and self._opens(c) and self.can_be_run(p)

    def unwanted(self, c: Calling, p: Path) -> bool:
        """The author excludes a route over this path; not the call-on route alone."""
        told = self._r.body.get("exclude") or ()
        return any(self.chosen(x, c, p) for x in told if x.get("kind") != "call-on")

    def called_off(self, g: Signal, p: Path) -> bool:
        """The author excludes the call-on route alone over this path of trains."""
        told = self._r.body.get("exclude") or ()
        return any(self.chosen(x, Calling(g, False), p) for x in told if x.get("kind") == "call-on")

    def barred(self, c: Calling, p: Path, called_on: bool) -> bool:
        """The author excludes every route of trains over this path; `called_on`: those that call a train on, too."""
        told = self._r.body.get("exclude") or ()
        every = [x for x in told if "kind" not in x or (x["kind"] == "main" and not called_on)]
        return any(self.chosen(x, c, p) for x in every)

    def can_be_run(self, p: Path) -> bool:
        """Every machine is needed in one position, as its key permits; a diamond is passed once; all is detected."""
        demands = {d for w in p.ways for _, d in w.points}
        once = len({d.machine for d in demands}) == len(demands)
        arms = [d for w in p.ways for d, _ in w.arms]
        locked = {x.machine for x in self._r.drawn.points.values() if x.keyed}
        keyed = any(d.machine in locked and d.position == "R" for d in demands)
        seen = all(w.section not in self._track.undetected for w in p.ways[: -1 if p.berth else None])
        return once and len(set(arms)) == len(arms) and not keyed and seen

    def _opens(self, c: Calling) -> bool:
        """Nothing begins at a board, and no train at a shunt signal at which trains end."""
        v = self._r.body["signals"][c.name]
        return v.get("kind") not in ("board", "limit") and (c.shunt or v.get("stops_trains") not in ("yes", "true"))

    def chosen(self, x: Mapping[str, Any], c: Calling, p: Path) -> bool:
        """A route over this path begins, ends and passes as the author says, and may be of the kind: whether it is one
        over which trains are called on, no path tells, but the lamp."""
        ahead = self._r.signal_into.get((p.last.exit, self._track.beyond(p.last.section, p.last.exit) or ""))
        ends = {p.last.section, p.last.exit, *([ahead.name] if ahead is not None else [])}
        return (
            x.get("from", c.name) == c.name
            and x.get("to", p.last.exit) in ends
            and set(x.get("via") or ()) <= {w.section for w in p.ways}
            and not set(x.get("not_via") or ()) & {w.section for w in p.ways}
            and x.get("kind") in ((None, "shunt") if c.shunt else (None, "main", "call-on"))
        )

    def passed_after(self, p: Path) -> list[Signal]:
        """The signal at the end of a path, where the layout gives it an identifier light."""
        g = self._r.main_into.get((p.last.exit, self._track.beyond(p.last.section, p.last.exit) or ""))
        return [g] if g is not None and self._r.body["signals"][g.name].get("identifier") in ("yes", "true") else []

    def runs(self, p: Path) -> Iterator[Run]:
        """From a train's path on past one signal after the other, none twice, that has an identifier light."""
        found = [Run((p,), ())]
        while found:
            u = found.pop()
            for g in self.passed_after(u.last):
                for q in () if g in u.passed else self.of(Calling(g, False)):
                    found.append(Run((*u.parts, q), (*u.passed, g)))
                    yield found[-1]
