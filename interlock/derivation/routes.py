"""Routes (R1, R2): search from every signal, no length cap, all alternatives kept.

A call-on route runs like a train route; it exists where its signal can call on.
A train route follows the signal's direction to the next main signal of that direction, a boundary or a buffer.
A shunt route ends at the next signal of either kind, at a buffer, or in the first berth: a plain section that is left
only on a signal, where vehicles may stand.  It never leaves over a boundary; before one it ends in a road that is no
berth only because the layout says so.
Past a signal with an identifier light a train route may lead on, to where one that begins there ends: it is made of the
path to that signal and of a route of kind identifier beyond it, which may lead past the next signal in the same way.
A path that meets itself, or that needs one machine in two positions, cannot be run and is reported.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

from interlock.dataclass import dataclass
from interlock.derivation.ends import over_which, where_routes_lead
from interlock.diag import Element, Sink
from interlock.diag.called import called
from interlock.model.elements import (
    BoundaryKind,
    BufferKind,
    CrossingId,
    Exclude,
    MachineId,
    NodeId,
    Position,
    RouteId,
    SectionId,
    Signal,
    SignalId,
    SignalKind,
)
from interlock.model.layout import Layout
from interlock.model.overlap import overlap_paths, told_apart
from interlock.model.too_many import TooManyWays, from_signal, in_all, past_signals
from interlock.model.traversal import Topology, Traversal, topology
from interlock.table.cells import ExitKind, RouteKind

Ways = tuple[Traversal, ...]


@dataclass(frozen=True)
class Path:
    """A path from a signal to its exit, as traversals in order."""

    id: RouteId
    number: int
    kind: RouteKind
    entry: SignalId
    entry_node: NodeId
    exit: str
    exit_kind: ExitKind
    variant: int
    ways: Ways
    berth: SectionId | None
    overlap: Ways = ()
    option: int = 0
    onward: Path | None = None
    """Past the signal at its exit, which shows its identifier light, it leads on over this one."""

    @property
    def parts(self) -> tuple[Path, ...]:
        """Itself, and what is set with it past one signal after the other."""
        return (self,) if self.onward is None else (self, *self.onward.parts)

    @property
    def run(self) -> Ways:
        """All ways over which its train runs, those past the signal at its exit among them."""
        return tuple(t for p in self.parts for t in p.ways)


@dataclass(frozen=True)
class _Found:
    """A path before it has a name."""

    signal: Signal
    kind: RouteKind
    exit: str
    exit_kind: ExitKind
    ways: Ways
    beyond: _Found | None = None

    @property
    def leads(self) -> str:
        """Where it ends, and which signals it passes before."""
        return self.exit if self.beyond is None else f"{self.exit}-{self.beyond.leads}"

    @property
    def end(self) -> str:
        """Where its train stops or leaves."""
        return self.exit if self.beyond is None else self.beyond.end

    @property
    def run(self) -> Ways:
        """All ways over which its train runs."""
        return self.ways if self.beyond is None else (*self.ways, *self.beyond.run)

    @property
    def beyond_it(self) -> tuple[_Found, ...]:
        """What is set with it past one signal after the other."""
        return () if self.beyond is None else (self.beyond, *self.beyond.beyond_it)


def machine_positions(layout: Layout, ways: Ways) -> dict[MachineId, Position] | None:
    """Positions of the machines on a path, or None when one is needed in both."""
    found: dict[MachineId, Position] = {}
    for t in ways:
        for point, position in t.points:
            if found.setdefault(layout.pointwork.point[point].machine, position) is not position:
                return None
    return found


def obstacle(layout: Layout, ways: Ways, clear: Ways) -> str | None:
    """Why no movement can run the path: a contradiction of points, both arms of one diamond, no detection where it must
    be clear, a hand-worked point against its key.  None where it can be run."""
    positions: dict[MachineId, Position] = {}
    for t in ways:
        for point, position in t.points:
            machine = layout.pointwork.point[point].machine
            if positions.setdefault(machine, position) is not position:
                return f"machine {machine} is needed in both positions"
    over: set[CrossingId] = set()
    for t in ways:
        for c, _ in t.crossings:
            if c in over:
                return f"it runs over both arms of the diamond {c}"
            over.add(c)
    for t in clear:
        if t.section in layout.track.undetected:
            return f"{t.section} must be clear and has no detection"
    against = [m for m in sorted(layout.machines.by_hand) if positions.get(m) is Position.REVERSE]
    return f"{against[0]} is worked by hand, and locked by its key the other way" if against else None


def find_routes(layout: Layout, sink: Sink) -> tuple[Path, ...]:
    """Every route, ordered by signal, train before shunt, then exit, then rank of the alternative; none where there are
    too many (IL3049)."""
    try:
        return _listed(layout, sink)
    except TooManyWays as beyond:
        _tell_too_many(beyond, sink)
        return ()


def _tell_too_many(beyond: TooManyWays, sink: Sink) -> None:
    about = Element(beyond.room, beyond.name)
    sink.add("IL3049", beyond.text, None, beyond.fix, about=about, cause=beyond.room, note=beyond.text)


def _listed(layout: Layout, sink: Sink) -> tuple[Path, ...]:
    """Every route in order.  Raises TooManyWays."""
    topo = topology(layout)
    every = in_all()
    found: list[_Found] = []
    ahead: list[_Found] = []  # to signals that can be passed, whether or not a route may end there
    led: list[_Found] = []  # those that are excluded too
    fits = [0] * len(layout.declared.excluded)
    for g in layout.signalling.signals:
        reached: set[str] = set()
        dropped: list[_Dropped] = []
        for kind in RouteKind:
            passed = g.id in layout.signalling.identifiers
            of = {RouteKind.MAIN: g.main, RouteKind.SHUNT: g.shunt, RouteKind.CALL_ON: g.call_on}
            if not of.get(kind, passed):
                continue
            if not layout.signalling.opens(g.id, kind is RouteKind.SHUNT):
                continue
            for exit_kind, name, ways in every.each(_bounded(layout, topo, g, kind, sink)):
                berth = kind is RouteKind.SHUNT and len(ways) > 1 and ways[-1].section in topo.berths
                why = name if exit_kind is None else obstacle(layout, ways, ways[:-1] if berth else ways)
                if exit_kind is None or why is not None:
                    dropped.append(_Dropped(why or name, "" if exit_kind is None else name, ways))
                    continue
                path = _Found(g, kind, name, exit_kind, ways)
                out = [i for i, x in enumerate(layout.declared.excluded) if _excludes(x, path)]
                reached.add(name)
                led.append(path)
                if kind in (RouteKind.MAIN, RouteKind.IDENTIFIER) and name in layout.signalling.identifiers:
                    ahead.append(path)
                if not out:
                    found.append(path)
                for i in out:
                    fits[i] += 1
        _tell_dropped(layout, g.id, dropped, reached, sink)
        if not reached and g.id not in layout.signalling.boards:
            _tell_none(g.id, dropped, sink)
    if sink.has("IL3049"):
        return ()
    past = _past(layout, found, ahead, fits, led, sink)
    found = [f for f in found if f.kind is not RouteKind.IDENTIFIER] + past
    _tell_idle(layout, fits, [f for f in led if f.kind is not RouteKind.IDENTIFIER], sink)
    return _numbered(layout, found, sink)


def _tell_idle(layout: Layout, fits: Sequence[int], led: Sequence[_Found], sink: Sink) -> None:
    """IL2012 of exclusions that fit no route: what of them is to be corrected."""
    for i, (x, n) in enumerate(zip(layout.declared.excluded, fits, strict=True)):
        if n:
            continue
        alike = [f for f in led if _excludes(replace(x, via=(), not_via=()), f)]
        if any(_excludes(replace(x, called_on=False), f) for f in led):
            fix = "remove it: over these routes no train is called on, with which it deals alone (`kind: call-on`)"
        elif alike and (x.via or x.not_via):
            fix = "remove it, or correct `via`: " + over_which([t.section for t in f.run] for f in alike)
        else:
            ends = where_routes_lead(x.entry, x.exit, ((f.signal.id, f.end) for f in led))
            fix = f"remove it, or correct its ends{ends}"
        sink.add("IL2012", f"the exclusion ({x.reason}) fits no route", None, fix, about=Element("exclude", i))


def _tell_none(g: SignalId, dropped: Sequence[_Dropped], sink: Sink) -> None:
    """IL4003 of a signal from which no route leads, with what kept those that there would be."""
    whys = list(dict.fromkeys(d.why for d in dropped))
    fix = "check its direction (`from`, `into`) and where the track goes"
    if whys:
        fix = "check its direction; the notes name each way left out, `interlock explain IL4005` what to do"
    if whys and all(w.startswith(SHUNT_STAYS) for w in whys):
        last = ", ".join(dict.fromkeys(d.ways[-1].section for d in dropped if d.ways))
        fix = (
            f"let it end before the boundary: give the last metres of {last} a section of their own, since a board "
            "stands at a joint, and put one there (`kind: limit`, or `kind: board` if trains end there, too); or say "
            "`berth: no` of a road there that it leaves at a shunt signal on the way back; `interlock explain IL4005`"
        )
    elif whys and all(w.startswith(COMES_BACK) for w in whys):
        fix = (
            "check its direction; if that is right, a signal is missing on the way, at which its route ends before it "
            "comes there again"
        )
    why = f": {'; '.join(whys)}" if whys else ""
    text = f"no route leads from {called('signal', g)}{why}"
    sink.add("IL4003", text, None, fix, about=Element("signals", g))


SHUNT_STAYS = "a shunting movement does not leave"
"""Why a shunting movement does not run on over a boundary; at which one follows."""
COMES_BACK = "it meets "
"""Why a way ends that comes to a section again; to which one follows."""


@dataclass(frozen=True)
class _Dropped:
    """A path that cannot be run, and why; `exit`: where it would have ended, empty where it ends nowhere."""

    why: str
    exit: str
    ways: Ways


def _tell_dropped(layout: Layout, g: SignalId, dropped: Sequence[_Dropped], reached: set[str], sink: Sink) -> None:
    """IL4005 of every path of a signal that was left out; IL4020 where one machine is wanted in both positions, and no
    other way leads there."""
    about = Element("signals", g)
    for d in dict.fromkeys(dropped):
        over = ", ".join(t.section for t in d.ways) or "nothing"
        if d.exit and d.exit not in reached and machine_positions(layout, d.ways) is None:
            text = f"no route leads from {g} to {d.exit}: {d.why}, over {over}"
            fix = "give one of the ends that it works a machine of its own, or exchange `normal` and `reverse` of one"
            sink.add("IL4020", text, None, fix, about=about, cause=d.why, note=f"{g} to {d.exit}")
        else:
            text = f"{g} over {over}"
            sink.add("IL4005", f"no route from {text}: {d.why}", about=about, cause=d.why, note=text)


def _past(
    layout: Layout, found: Sequence[_Found], ahead: Sequence[_Found], fits: list[int], led: list[_Found], sink: Sink
) -> list[_Found]:
    """Train routes past signals that show their identifier lights, each the path to the first of them and a part that
    leads on; and the parts that such routes have.  Of all of them, excluded or not, `led` is told."""
    for o in layout.overlaps.all:
        if o.swing and o.signal in layout.signalling.identifiers:
            text = f"the overlap of {o.signal} swings: no route can pass {o.signal} at identifier light"
            fix = f"remove `swing` of the overlap, or `identifier` of {o.signal}"
            sink.add("IL3032", text, None, fix, about=Element("overlaps", o.signal))
    parts = {
        g: [f for f in found if f.kind is RouteKind.IDENTIFIER and f.signal.id == g]
        for g in layout.signalling.identifiers
    }
    last = [b for those in parts.values() for b in those]
    long: list[_Found] = []
    every = past_signals()
    while last:
        pairs = every.each((a, b) for b in last for a in ahead if a.exit == b.signal.id)
        last = [x for a, b in pairs for x in _led_past(layout, a, b, fits, led, sink)]
        long += [x for x in last if x.kind is RouteKind.MAIN]
        last = [x for x in last if x.kind is RouteKind.IDENTIFIER]
    used = {b: None for f in long for b in f.beyond_it}
    for g in layout.signalling.identifiers:
        if not any(b.signal.id == g for b in used):
            text = f"no route passes {g}: it never shows its identifier light"
            fix = f"remove `identifier` of {g}; a route must lead to it, and another one on from it"
            sink.add("IL4013", text, None, fix, about=Element("signals", g))
    return [*used, *long]


def _led_past(layout: Layout, a: _Found, b: _Found, fits: list[int], led: list[_Found], sink: Sink) -> Iterator[_Found]:
    """A path to a signal with a part that leads on from there, unless it is excluded or cannot be run."""
    long = replace(a, beyond=b)
    barred = [i for i, x in enumerate(layout.declared.excluded) if _excludes(x, long)]
    for i in barred:
        fits[i] += 1
    why = _why_not_past(layout, a, b)
    if why is None:
        led.append(long)
    if not barred and why is None:
        yield long
    elif not barred and a.kind is RouteKind.MAIN:  # what begins at the signal is the same for a part
        text = (
            f"no route from {a.signal.id} past {' and '.join(b.signal.id for b in long.beyond_it)} to {long.end}: {why}"
        )
        fix = "exclude it: `exclude: [{from: ..., to: ..., via: [...], reason: ...}]`, or change what it tells"
        sink.add("IL4014", text, None, fix, about=Element("signals", a.exit), cause=a.exit, note=text)


def _why_not_past(layout: Layout, a: _Found, b: _Found) -> str | None:
    """Why one route cannot run over both paths; None where it can."""
    twice = sorted({t.section for t in a.ways} & {t.section for t in b.run})
    if twice:
        return f"it meets {twice[0]} again"
    rear = topology(layout).beyond(a.ways[0].section, a.signal.node)
    if rear in {t.section for t in b.run}:
        return f"its train stands in {rear} before {a.signal.id}"
    if layout.overlaps.length.get(SignalId(a.exit), 0.0) > 0 and _overlap_along(layout, a.exit, b.run) is None:
        return f"no overlap of {a.exit} lies along it"
    ways = (*a.ways, *b.run)
    return obstacle(layout, ways, ways)


def _overlap_along(layout: Layout, signal: str, ways: Ways) -> tuple[int, Ways] | None:
    """The longest alternative of a signal's overlap that lies wholly on the way beyond it, for whatever speed."""
    keys, apart = {t.key for t in ways}, told_apart(layout, SignalId(signal))
    along = [
        (k, over)
        for k, over in enumerate(overlap_paths(layout, SignalId(signal)), start=1)
        if all(t.key in keys for t in over) and over not in apart
    ]
    return max(along, key=lambda x: (len(x[1]), -x[0]), default=None)


def _excludes(x: Exclude, path: _Found) -> bool:
    last, sections = path.run[-1], {t.section for t in path.run}
    ends = {path.end, last.section, last.exit}  # before a boundary a shunting movement ends in the last section
    shunt, called_on = (path.kind is k for k in (RouteKind.SHUNT, RouteKind.CALL_ON))
    return x.fits(path.signal.id, ends, sections, shunt, called_on)


def _numbered(layout: Layout, found: Sequence[_Found], sink: Sink) -> tuple[Path, ...]:
    effect = _Effect(layout, found)
    groups: dict[tuple[SignalId, RouteKind, str], list[_Found]] = {}
    for f in found:
        groups.setdefault((f.signal.id, f.kind, f.leads), []).append(f)
    kinds = list(RouteKind)
    paths: list[tuple[_Found, Path]] = []
    in_order = sorted(groups.items(), key=lambda x: (x[0][0], kinds.index(x[0][1]), x[0][2]))
    for (g, kind, leads), those in in_order:
        ranked = sorted(those, key=effect.rank) if len(those) > 1 else those
        mark = ".s" if kind is RouteKind.SHUNT and those[0].signal.kind is SignalKind.COMBINED else ""
        mark = {RouteKind.CALL_ON: ".c", RouteKind.IDENTIFIER: ".i"}.get(kind, mark)
        for variant, f in enumerate(ranked, start=1):
            suffix = f"{mark}.{variant}" if variant > 1 else mark
            berth = f.ways[-1].section if _ends_in_berth(layout, f) else None
            options = _overlaps(layout, f, f"{g}-{leads}{suffix}", sink)
            for option, overlap in options:
                over = f".o{option}" if option > 1 and f.beyond is None else ""
                id_ = RouteId(f"{g}-{leads}{suffix}{over}")
                to, at = f.exit_kind, f.signal.node
                path = Path(id_, 0, kind, g, at, f.exit, to, variant, f.ways, berth, overlap, option)
                paths.append((f, path))
    single: dict[_Found, list[Path]] = {}
    every = in_all()
    for f, p in paths:
        if f.kind is RouteKind.IDENTIFIER:
            single.setdefault(f, []).append(p)
    named = _told_apart([x for f, p in paths for x in every.each(_led_on(p, f.beyond, single))], sink)
    number = {p.id: n for n, p in enumerate(named, start=1)}
    return tuple(_with_number(p, number) for p in named)


def _told_apart(paths: Sequence[Path], sink: Sink) -> list[Path]:
    """The paths without those that would bear the name of another one."""
    by_id: dict[str, Path] = {}
    for p in paths:
        first = by_id.setdefault(p.id.casefold(), p)
        if first is not p:
            ends = " and ".join(f"from {x.entry} to {x.exit}" for x in (first, p))
            text = f"the routes {ends} would both be called {p.id}"
            sink.add("IL2002", text, None, "rename one of the signals", about=Element("signals", p.entry))
    return [*by_id.values()]


def _led_on(p: Path, beyond: _Found | None, single: Mapping[_Found, Sequence[Path]]) -> list[Path]:
    """A route past signals, with each overlap that the last part may have."""
    if beyond is None:
        return [p]
    out = []
    for q in (x for b in single[beyond] for x in _led_on(b, beyond.beyond, single)):
        option = q.parts[-1].option
        out.append(replace(p, id=RouteId(p.id + (f".o{option}" if option > 1 else "")), onward=q))
    return out


def _with_number(p: Path, number: Mapping[RouteId, int]) -> Path:
    onward = None if p.onward is None else _with_number(p.onward, number)
    return replace(p, number=number[p.id], onward=onward)


def _overlaps(layout: Layout, f: _Found, name: str, sink: Sink) -> list[tuple[int, Ways]]:
    """The alternatives of a train route's overlap that its own path permits; (0, ()) where it needs none (R4).

    A short one inside a longer one is for routes that show its speed: not for one that calls a train on, or past a
    signal at identifier light.
    """
    if f.kind is RouteKind.SHUNT or f.exit_kind is not ExitKind.SIGNAL:
        return [(0, ())]
    if SignalId(f.exit) not in layout.overlaps.length:
        return [(0, ())]
    if f.beyond is not None:
        along = _overlap_along(layout, f.exit, f.beyond.run)
        return [] if along is None else [along]
    options = overlap_paths(layout, SignalId(f.exit))
    rear = topology(layout).beyond(f.ways[0].section, f.signal.node)
    mine = {rear, *(t.section for t in f.ways)}  # in rear its own train stands until it runs
    apart = told_apart(layout, SignalId(f.exit)) if f.kind is not RouteKind.MAIN else {}
    fits = [
        (k, ways)
        for k, ways in enumerate(options, start=1)
        if ways not in apart
        and all(t.section not in mine for t in ways)
        and obstacle(layout, (*f.ways, *ways), ways) is None
    ]
    if not fits:
        sink.add(
            "IL4008",
            f"{called('route', name)} finds no overlap beyond {f.exit}: wanted is {_wanted(layout, f.exit)}"
            f"{_hindered(layout, f, [ways for ways in options if ways not in apart])}",
            None,
            f"shorten it: `overlaps: {{{f.exit}: {{length: ...}}}}`; 0 for none",
            about=Element("signals", f.signal.id),
            cause=f.exit,
            note=name,
        )
    return list(fits)


def _hindered(layout: Layout, f: _Found, options: Sequence[Ways]) -> str:
    """Why the first alternative of an overlap is none for a route."""
    mine = {t.section for t in f.ways}
    for ways in options:
        again = next((f"it meets {t.section} again" for t in ways if t.section in mine), None)
        why = again or obstacle(layout, (*f.ways, *ways), ways)
        return f"; over {', '.join(dict.fromkeys(t.section for t in ways))}: {why}"
    return ""


def _wanted(layout: Layout, g: str) -> str:
    own = [f"{w.length:g} m over {', '.join(w.over)}" for w in layout.overlaps.ways if w.signal == g]
    return " or ".join([next(o.text for o in layout.overlaps.all if o.signal == g), *own])


def _ends_in_berth(layout: Layout, f: _Found) -> bool:
    """A route over the berth alone asks for it clear (R2): the ways before a berth tell that a movement is under way
    into it, since the berth may be locked for what stands there, and nothing else would be locked for this one."""
    return f.kind is RouteKind.SHUNT and len(f.ways) > 1 and f.ways[-1].section in topology(layout).berths


class _Effect:
    """Basic before alternative (R1): least effect on parallel routes, then shorter, then fewer points.

    The effect counts the routes of other signals that cannot be set beside: receiving, departing, shunting, in this
    order of weight.
    """

    def __init__(self, layout: Layout, found: Sequence[_Found]) -> None:
        self.layout = layout
        self.found = found
        self.over: dict[SectionId, set[int]] = {}
        self.needs: dict[tuple[MachineId, Position], set[int]] = {}
        for i, f in enumerate(found):
            for t in f.ways:
                self.over.setdefault(t.section, set()).add(i)
            for need in (machine_positions(layout, f.ways) or {}).items():
                self.needs.setdefault(need, set()).add(i)

    def rank(self, f: _Found) -> tuple[int, int, int, int, float, int, tuple[tuple[str, int], ...]]:
        """The sort key of an alternative."""
        against: set[int] = set()
        positions = machine_positions(self.layout, f.ways) or {}
        for t in f.ways:
            against |= self.over[t.section]
        for m, x in positions.items():
            against |= self.needs.get((m, x.other), set())
        others = [self.found[i] for i in against if self.found[i].signal is not f.signal]
        receiving = sum(o.kind is RouteKind.MAIN and o.signal.node in self.layout.track.boundary_at for o in others)
        departing = sum(o.kind is RouteKind.MAIN and o.exit_kind is ExitKind.BOUNDARY for o in others)
        trains = sum(o.kind is RouteKind.MAIN for o in others)
        points = [p for t in f.ways for p in t.points]
        length = sum(t.length for t in f.ways)
        key = tuple(t.key for t in f.run)
        return (receiving, departing, trains, len(others) - trains, length, len(points), key)


def _bounded(
    layout: Layout, topo: Topology, g: Signal, kind: RouteKind, sink: Sink
) -> Iterator[tuple[ExitKind | None, str, Ways]]:
    """What is found from a signal, as long as it is not too much, which is told: IL3049."""
    try:
        yield from from_signal(g.id, kind is RouteKind.SHUNT).each(_search(layout, topo, g, kind))
    except TooManyWays as beyond:
        _tell_too_many(beyond, sink)


def _search(layout: Layout, topo: Topology, g: Signal, kind: RouteKind) -> Iterator[tuple[ExitKind | None, str, Ways]]:
    """Depth first over traversals; yields (None, why, path) for a path that cannot be run to its end."""
    stops = topo.signal_into if kind is RouteKind.SHUNT else topo.main_into
    stack: list[tuple[SectionId, NodeId, Ways]] = [(layout.track.section_of(g.into), g.node, ())]
    while stack:
        section, entry, ways = stack.pop()
        onward_ways = topo.through(section, entry)
        if not onward_ways:
            yield None, f"no train runs into {section} that way", ways
        for t in reversed(onward_ways):
            path = (*ways, t)
            berth = kind is RouteKind.SHUNT and section in topo.berths
            if t.exit in layout.track.buffer_at:
                if layout.track.buffer_at[t.exit].kind is BufferKind.STOP:  # no route leads into a trap
                    yield ExitKind.BUFFER, t.exit, path
                continue
            onward = topo.beyond(section, t.exit)
            ahead = stops.get((t.exit, onward)) if onward is not None else None
            if ahead is not None:
                yield ExitKind.SIGNAL, ahead, path
            elif berth or (onward is None and kind is RouteKind.SHUNT and section in topo.turning):
                yield ExitKind.BERTH, section, path
            elif onward is None:
                leaves = layout.track.boundary_at[t.exit].kind is not BoundaryKind.IN and kind is not RouteKind.SHUNT
                stays = f"{SHUNT_STAYS if kind is RouteKind.SHUNT else 'a train does not leave'} at {t.exit}"
                yield (ExitKind.BOUNDARY, t.exit, path) if leaves else (None, stays, path)
            elif any(w.section == onward for w in path):
                yield None, f"{COMES_BACK}{onward} again", path
            else:
                stack.append((onward, t.exit, path))
