"""Changes of a layout after which its table is known: the same under other names, in another order, written from the
other end, beside a second layout; and what of two tables can be compared.

A layout is a tree of texts, as `interlock.checker.reading.loaded` reads it.  A form of a table is made of values that
do not depend on the order in which things are named or numbered.
"""

from __future__ import annotations

import random
import re
from collections import Counter
from collections.abc import Callable, Iterable, Mapping, Sequence
from copy import deepcopy
from functools import cached_property
from typing import Any

import yaml

from interlock.checker.reading import loaded
from interlock.derivation import derive
from interlock.diag import Sink
from interlock.frontend import load_text
from interlock.frontend.scalars import item_parts
from interlock.model.elements import EdgeId, NodeId, Position, SectionId, SignalId
from interlock.model.layout import Layout
from interlock.model.overlap import overlap_paths
from interlock.model.places import Approach
from interlock.model.traversal import Topology, topology
from interlock.table.cells import FlankCell, FoulCell, PointDemand, TraversalKey
from interlock.table.rows import InterlockingTable, RouteRow, TraversalRow

Tree = dict[str, Any]
Back = Callable[[str], str]
"""From a name of now to what it was before."""

BY_NAME = (
    *("boundaries", "tracks", "points", "crossings", "slips", "derailers", "level_crossings", "interlocks", "signals"),
    *("distants", "sections", "conditions", "zones", "routes", "voyages", "overlaps", "substations", "health"),
    "drawing",
)
"""Keys whose entries have names."""
PLAIN = frozenset(
    ("interlock", "name", "title", "profile", "principles", "telegram", "target", "title_block", "addresses")
)
WORDS = frozenset(
    (
        *("text", "label", "reason", "kind", "lint", "lane", "hand", "work", "speed", "legs", "fouling", "length"),
        *("trains", "block", "button", "indicator", "single", "blades", "order", "direction", "xy", "km", "by"),
        *("within", "falling", "entry_speed", "release", "supervision", "one_way", "detected", "berth", "call_on"),
        *("identifier", "stops_trains", "swing", "successive", "release_by_length", "lies", "hold", "listed"),
    )
)
"""Keys of elements whose values name nothing."""


def tree(text: str) -> Tree:
    """A layout's text as a tree."""
    found: Tree = loaded(text)
    return found


def written(t: Tree) -> str:
    """A tree as a layout's text."""
    return yaml.safe_dump(t, allow_unicode=True, sort_keys=False, width=10_000)


class Made:
    """What is made of a tree: layout, table and diagnostics."""

    def __init__(self, t: Tree) -> None:
        self.tree, self.sink = t, Sink()
        self.layout, _ = load_text("layout.yaml", written(t), self.sink)
        self.table = None if self.layout is None else derive(self.layout, self.sink)

    @property
    def errors(self) -> list[str]:
        """The errors, in words."""
        return [f"{d.code} {d.message}" for d in self.sink.diagnostics if d.severity == "error"]

    @property
    def told(self) -> Counter[str]:
        """How often each diagnostic is given."""
        return Counter(d.code for d in self.sink.diagnostics)

    def form(self, back: Back = str, turned: bool = False) -> Form:
        """What can be compared, under the names of before, points `turned` back."""
        assert self.layout is not None and self.table is not None, self.errors
        return Form(self.layout, self.table, back, turned)


Value = Any


class Form:
    """A table in values that depend on no order; `back` gives each name its name of before, and with `turned` normal is
    reverse of all points, and reverse normal."""

    def __init__(self, layout: Layout, table: InterlockingTable, back: Back, turned: bool) -> None:
        self._layout, self._table, self._back, self._turned = layout, table, back, turned
        self._topo: Topology = topology(layout)
        self.key = {r.id: self._key(r) for r in table.routes}
        """What a route is, by its id: where it begins, what it is for, over which ways it leads, and those beyond."""

    @cached_property
    def routes(self) -> dict[Value, dict[str, Value]]:
        """The cells of each route."""
        found = {self.key[r.id]: self._cells(r) for r in self._table.routes}
        assert len(found) == len(self._table.routes)
        return found

    @cached_property
    def hostile(self) -> set[frozenset[Value]]:
        """The pairs of hostile routes."""
        return {frozenset((self.key[r.id], self.key[o])) for r in self._table.routes for o in r.locking.hostile.routes}

    @cached_property
    def locks(self) -> dict[Value, dict[str, Value]]:
        """What each way that routes lead over demands and excludes."""
        return {self.way(t.key): self._lock(t) for t in self._table.locks}

    @cached_property
    def voyages(self) -> dict[str, Value]:
        """Each voyage as the routes that it opens, in which order, and where it meets others."""
        return {
            self._back(v.name): (
                tuple(self.key[r] for r in v.routes),
                (v.far_first, v.priority),
                frozenset((self._back(m.voyage), self._names(m.sections)) for m in v.meetings),
            )
            for v in self._table.voyages
        }

    @property
    def automatic(self) -> frozenset[Value]:
        """The routes that work by themselves."""
        return frozenset(self.key[r] for r in self._table.automatic)

    def way(self, key: TraversalKey) -> Value:
        """A way through a section: from what to what, and how points lie on it."""
        t = self._topo.traversals[key[0]][key[1] - 1]
        points = tuple((self._back(p), self._lies(self._layout.pointwork.point[p].machine, x)) for p, x in t.points)
        crossings = tuple((self._back(c), arm) for c, arm in t.crossings)
        return self._back(t.section), self._end(t.section, t.entry), self._end(t.section, t.exit), points, crossings

    def _end(self, section: SectionId, node: NodeId) -> str:
        beyond = self._topo.beyond(section, node)
        return self._back(node if beyond is None else beyond)

    def ways(self, keys: Iterable[TraversalKey]) -> Value:
        """Ways in order."""
        return tuple(map(self.way, keys))

    def _names(self, names: Iterable[str]) -> tuple[str, ...]:
        return tuple(map(self._back, names))

    def _key(self, r: RouteRow) -> Value:
        overlap = () if r.locking.overlap is None else self.ways(r.locking.overlap.ways)
        beyond = () if r.path.onward is None else self._key(self._table.route[r.path.onward])
        return self._back(r.entry), str(r.kind), self.ways(r.path.traversals), overlap, beyond

    def _lies(self, machine: str, x: Position) -> str:
        turned = self._turned and machine in self._layout.machines.ends
        return str(x.other if turned else x)

    def _requester(self, name: str) -> str:
        point, _, leg = name.rpartition(".")
        turned = {"normal": "reverse", "reverse": "normal"}.get(leg) if self._turned else None
        return self._back(f"{point}.{turned}" if turned else name)

    def _demands(self, demands: Iterable[PointDemand]) -> Value:
        return frozenset(
            (self._back(d.machine), self._lies(d.machine, d.position), str(d.role), d.hold) for d in demands
        )

    def _flank(self, cells: Iterable[FlankCell]) -> Value:
        return frozenset(
            (
                self._requester(c.requester),
                self._back(c.section),
                frozenset(
                    (str(p.kind), self._back(p.name), p.position and self._lies(p.name, p.position))
                    for p in c.providers
                ),
            )
            for c in cells
        )

    def _foul(self, cells: Iterable[FoulCell]) -> Value:
        def when(c: FoulCell) -> Value:
            return None if c.when is None else (self._back(c.when[0]), self._lies(*c.when))

        def beside(c: FoulCell) -> Value:
            return None if c.crossing is None else self._back(c.crossing)

        return frozenset((self._back(c.section), self._back(c.of), when(c), beside(c)) for c in cells)

    def _approach(self, a: Approach) -> Value:
        """The ways of an approach lead away from each other, and have no order."""
        section = None if a.section is None else self._back(a.section)
        further = frozenset(
            (self.way((a.section, n)) if a.section is not None else n, self._approach(x)) for n, x in a.further
        )
        return section, further, a.unseen

    def _swings(self, r: RouteRow) -> Value:
        overlap = r.locking.overlap
        if overlap is None:
            return frozenset()
        options = overlap_paths(self._layout, overlap.signal)
        return frozenset(self.ways(t.key for t in options[k - 1]) for k in overlap.swings)

    def _cells(self, r: RouteRow) -> dict[str, Value]:
        lock, clear, asked, signal = r.locking, r.clear, r.conditions, r.signal
        overlap, after = lock.overlap, signal.aspect.next
        return {
            "names": frozenset(self._names(r.names)),
            "exit": (self._back(r.exit), str(r.path.exit_kind)),
            "berth": None if r.path.berth is None else self._back(r.path.berth),
            "length": round(r.path.length, 6),
            "points": self._demands(lock.points),
            "driven": self._demands(lock.driven),
            "flank": self._flank(lock.flank),
            "hostile": frozenset((self.key[h.route], str(h.kind), frozenset(map(str, h.kinds))) for h in lock.hostile),
            "barred": frozenset(self.key[b.route] for b in lock.barred),
            "overlap": None if overlap is None else (self._back(overlap.signal), round(overlap.metres, 6)),
            "swings": self._swings(r),
            "approach": (self._approach(lock.approach.coming), lock.approach.delay_s),
            "release": tuple(
                (self._back(s.section), s.after and self._back(s.after), self._back(s.proved_by), s.delay_s)
                for s in lock.release
            ),
            "clear": frozenset(self._back(c.section) for c in clear.sections),
            "foul": self._foul(clear.foul),
            "space": frozenset((self._back(c.name), c.lamp) for c in clear.space),
            "demanded": frozenset(self._back(c.section) for c in clear.demanded or ()),
            "conditions": frozenset(self._back(c.condition) for c in asked.external),
            "zones": frozenset((self._back(z.zone), z.entries) for z in asked.zones),
            "block": frozenset(self._back(b.section) for b in asked.block),
            "token": None if asked.token is None else self._back(asked.token.boundary),
            "aspect": (str(signal.aspect.shows), after and self._back(after), signal.aspect.indicator),
            "closing": None if signal.closing.whole is None else self._back(signal.closing.whole),
            "speed": signal.speed.kmh,
            "listed": r.listed,
        }

    def _lock(self, t: TraversalRow) -> dict[str, Value]:
        return {
            "points": self._demands(t.points),
            "flank": self._flank(t.flank),
            "exclusions": frozenset(
                (self._back(x.section), x.whole, frozenset(self.way((x.section, n)) for n in x.numbers))
                for x in t.exclusions
            ),
            "foul": self._foul(t.foul),
            "space": frozenset((self._back(c.name), c.lamp) for c in t.space),
        }


def differences(was: Form, now: Form, but: Sequence[str] = ()) -> list[str]:
    """What two tables differ in, but for some columns, in words."""
    out = []
    for what in ("routes", "locks"):
        before, after = getattr(was, what), getattr(now, what)
        out += [f"{what}: {way} is gone" for way in before.keys() - after.keys()]
        out += [f"{what}: {way} is new" for way in after.keys() - before.keys()]
        for k in before.keys() & after.keys():
            for column, cell in before[k].items():
                if column not in but and cell != after[k][column]:
                    out.append(f"{what}: {column} of {k}: {cell} is {after[k][column]}")
    if "hostile" not in but:
        out += [f"hostile: {pair}" for pair in was.hostile ^ now.hostile]
    out += [f"voyages: {was.voyages} are {now.voyages}"] if was.voyages != now.voyages else []
    out += ["automatic"] if was.automatic != now.automatic else []
    return sorted(out)


def names(t: Tree) -> set[str]:
    """Every name that a layout gives."""
    found = {n for k in BY_NAME for n in t.get(k) or {}} | {*t.get("buffers", ()), *t.get("traps", ())}
    found |= (
        {item_parts(x)[0] for items in t["tracks"].values() for x in items if item_parts(x)[1]}
        if "tracks" in t
        else set()
    )
    for room in ("points", "slips", "derailers"):
        for v in (t.get(room) or {}).values():
            found |= {v["section"], *v.get("machines", ()), *([v["machine"]] if "machine" in v else [])}
    found |= {a["section"] for c in (t.get("crossings") or {}).values() for a in c["arms"]}
    found |= {item_parts(v["approach"])[0] for v in (t.get("boundaries") or {}).values() if v and "approach" in v}
    found |= {v["air_lock"] for v in (t.get("interlocks") or {}).values() if "air_lock" in v}
    return found


def renamed(t: Tree, to: Mapping[str, str]) -> Tree:
    """A layout under other names; halves of slips are called after these."""
    slips = t.get("slips") or {}

    def text(x: str) -> str:
        if x in to:
            return to[x]
        head, dot, end = x.partition(".")
        section, metres = item_parts(x)
        if dot and head in to:
            return f"{to[head]}.{end}"
        if metres and section in to:
            return f"{to[section]} {metres}"
        for slip in slips:
            if head in (f"{slip}a", f"{slip}b") or head.startswith(f"{slip}/"):
                return f"{to[slip]}{x[len(slip) :]}"
        return x

    def value(x: Any, key: str = "") -> Any:
        if key in WORDS:
            return x
        if isinstance(x, dict):
            return {k: value(v, k) for k, v in x.items()}
        return [value(y) for y in x] if isinstance(x, list) else text(x)

    out = {}
    for k, v in t.items():
        if k in PLAIN:
            out[k] = v
        elif k in BY_NAME:
            out[k] = {to.get(n, n): (x if k == "drawing" else value(x)) for n, x in v.items()}
        else:
            out[k] = value(v)
    return out


NEW = re.compile(r"[QЖ]\d{4}[xя]")


def under_other_names(
    t: Tree, order: Callable[[list[str]], Sequence[str]] = tuple, form: str = "Q{:04d}x"
) -> tuple[Tree, Back]:
    """A layout under names that sort as `order` puts the old ones."""
    to = {n: form.format(i) for i, n in enumerate(order(sorted(names(t))))}
    old = {v: k for k, v in to.items()}
    return renamed(t, to), lambda name: NEW.sub(lambda m: old[m[0]], name)


SETS = frozenset(("buffers", "traps", "over", "signals", "exits", "not_over", "sections", "at"))
"""Lists whose order means nothing."""
LISTS = frozenset(("exclude", "hostile", "demand", "waive", "allow", "substations"))
"""What is told in the order in which it is written."""


def shuffled(t: Tree, seed: int, lists: bool) -> Tree:
    """A layout whose mappings, and lists whose order means nothing, are in another order; with `lists` what is told in
    order, too."""
    rng = random.Random(seed)

    def value(x: Any, key: str = "") -> Any:
        if isinstance(x, dict):
            items = [(k, value(v, k)) for k, v in x.items()]
            if lists or key not in LISTS:
                rng.shuffle(items)
            return dict(items)
        if isinstance(x, list):
            every = [value(y) for y in x]
            if key in SETS or (lists and key in LISTS):
                rng.shuffle(every)
            return every
        return x

    found: Tree = value(t)
    return found


def from_the_other_end(t: Tree) -> Tree:
    """A layout whose tracks are written from their other ends."""
    t = deepcopy(t)
    swap = {f"{n}.{a}": f"{n}.{b}" for n in t.get("tracks") or {} for a, b in (("start", "end"), ("end", "start"))}
    turned = {"forward": "backward", "backward": "forward"}

    def value(x: Any) -> Any:
        if isinstance(x, dict):
            return {k: value(v) if k not in WORDS else x[k] for k, v in x.items()}
        return [value(y) for y in x] if isinstance(x, list) else swap.get(x, x)

    out = {k: v if k in PLAIN else value(v) for k, v in t.items()}
    out["tracks"] = {n: items[::-1] for n, items in (out.get("tracks") or {}).items()}
    for s in (out.get("sections") or {}).values():
        if s and "one_way" in s:
            s["one_way"] = turned[s["one_way"]]
    return out


def stated_once_more(t: Tree) -> Tree:
    """A layout in which what a point's or derailer's end is joined to is said at the other side too."""
    t = deepcopy(t)
    tracks: Tree = t.get("tracks") or {}
    for room, ends in (("points", ("toe", "normal", "reverse")), ("derailers", ("outer", "inner"))):
        for name, p in (t.get(room) or {}).items():
            for end in ends:
                track, dot, side = p.get(end, "").partition(".")
                if not dot or track not in tracks or side not in ("start", "end"):
                    continue
                items = tracks[track]
                if side == "start" and item_parts(items[0])[1]:
                    items.insert(0, f"{name}.{end}")
                    del p[end]
                elif side == "end" and item_parts(items[-1])[1]:
                    items.append(f"{name}.{end}")
    return t


def in_two_pieces(t: Tree) -> Tree:
    """A layout in which the first stretch of every track is two of half its length, in one section."""
    t = deepcopy(t)
    for items in (t.get("tracks") or {}).values():
        for i, x in enumerate(items):
            section, metres = item_parts(x)
            if metres and "+" not in x:
                items[i : i + 1] = [f"{section} {float(metres) / 2!r}"] * 2
                break
    return t


def turned(t: Tree) -> Tree:
    """A layout whose points are called reverse where they were normal."""
    legs = (("normal", "reverse"), ("reverse", "normal"))
    swap = {f"{p}.{a}": f"{p}.{b}" for p in t.get("points") or {} for a, b in legs}

    def value(x: Any) -> Any:
        if isinstance(x, dict):
            return {k: x[k] if k in WORDS else value(v) for k, v in x.items()}
        return [value(y) for y in x] if isinstance(x, list) else swap.get(x, x)

    out = {k: v if k in PLAIN else value(v) for k, v in t.items()}
    for name, p in (out.get("points") or {}).items():
        out["points"][name] = {{"normal": "reverse", "reverse": "normal"}.get(k, k): v for k, v in p.items()}
    return out


def with_points_for_slips(t: Tree) -> Tree | None:
    """A layout with two points, toe to toe, for each double slip with two machines; None where there is none."""
    t, swap = deepcopy(t), dict[str, str]()
    for name, s in [*(t.get("slips") or {}).items()]:
        machines = s.get("machines", [f"{name}a", f"{name}b"])
        if "single" in s or s.get("blades") == "near" or len(set(machines)) == 1:
            continue
        common = {k: v for k, v in s.items() if k in ("section", "legs", "fouling", "supervision")}
        points = t.setdefault("points", {})
        for i, side in enumerate("ab"):
            legs = {"normal": s["arms"][0][i], "reverse": s["arms"][1][i]}
            points[f"{name}{side}"] = {**common, **legs, "machine": machines[i]}
            swap |= {f"{name}.1{side}": f"{name}{side}.normal", f"{name}.2{side}": f"{name}{side}.reverse"}
        points[f"{name}a"]["toe"] = f"{name}b.toe"
        del t["slips"][name]

    def value(x: Any) -> Any:
        if isinstance(x, dict):
            return {k: x[k] if k in WORDS else value(v) for k, v in x.items()}
        return [value(y) for y in x] if isinstance(x, list) else swap.get(x, x)

    return {k: v if k in PLAIN else value(v) for k, v in t.items()} if swap else None


def beside(t: Tree, other: Tree) -> Tree:
    """Two layouts of one profile in one, which have no name in common."""
    out = deepcopy(t)
    for k, v in other.items():
        if k not in PLAIN:
            out[k] = {**(out.get(k) or {}), **v} if isinstance(v, dict) else [*(out.get(k) or []), *v]
    return out


def ruled(t: Tree, **principles: str) -> Tree:
    """A layout with some principles of its own."""
    return {**t, "principles": {**(t.get("principles") or {}), **principles}}


HALF = "_b"
"""What the second half of a section is called after the first."""


def divided(made: Made, section: SectionId) -> Tree | None:
    """A layout in which a plain section is two of half its length, without a signal between; None where it is written
    in pieces, or something other than track, signals and what lies over it speaks of it."""
    assert made.layout is not None
    t = deepcopy(made.tree)
    there = [(n, i) for n, items in t["tracks"].items() for i, x in enumerate(items) if item_parts(x)[0] == section]
    if len(there) != 1 or " " in section:
        return None
    (track, at), second = there[0], section + HALF
    items = t["tracks"][track]
    edge = made.layout.track.edge[EdgeId(f"{track}.{sum(bool(item_parts(x)[1]) for x in items[:at])}")]
    items[at : at + 1] = [f"{name} {edge.length / 2!r}" for name in (section, second)]
    for g, spec in t["signals"].items():
        if made.layout.signalling.signal[SignalId(g)].node == edge.b:
            t["signals"][g] = {k: second if v == section and k in ("from", "into") else v for k, v in spec.items()}
    for room in ("level_crossings", "interlocks", "conditions", "zones"):
        for spec in (t.get(room) or {}).values():
            for k in ("over", "sections"):
                if section in spec.get(k, ()):
                    spec[k].append(second)
    if section in (t.get("sections") or {}):
        t["sections"][second] = dict(t["sections"][section])
    return t


def whole(x: Value) -> Value:
    """A value of a form in which both halves of sections are one, and ways through both are one way."""
    if isinstance(x, str):
        return x.removesuffix(HALF)
    if isinstance(x, frozenset):
        return frozenset(map(whole, x))
    if not isinstance(x, tuple):
        return x
    out: list[Value] = []
    for y in map(whole, x):
        if _way(y) and out and _way(out[-1]) and out[-1][0] == y[0]:
            out[-1] = (*out[-1][:2], *y[2:])
        else:
            out.append(y)
    return tuple(out)


def _way(x: Value) -> bool:
    return isinstance(x, tuple) and len(x) == 5 and isinstance(x[3], tuple) and isinstance(x[1], str)
