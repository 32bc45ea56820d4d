"""Re-check of a table against its layout.

Flank is judged by Hansen's area condition: freeze the points that the route locks, let vehicles come in over every
boundary that admits trains, stop them only at signals that stand clear of the fouling point, and see whether their
area touches a leg or arm that the route does not use.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import product

from interlock.audit.added import added, chosen, declared
from interlock.audit.approach import approach_sections
from interlock.audit.aspect import aspect, route_indicator
from interlock.audit.conditions import conditions
from interlock.audit.flank import flank
from interlock.audit.foul import Foul, across, crossed, foul_neighbours
from interlock.audit.overlaps import onward_over, overlap_speed, overruns, swings, without_speed
from interlock.audit.own_train import own_train_in_the_way
from interlock.audit.voyages import voyages
from interlock.audit.walk import Move, Trip, in_rear, left_standing, past_signals, standing_place, trips
from interlock.dataclass import dataclass
from interlock.model.elements import MachineId, NodeId, Position, RouteId, SectionId, Signal, SignalId
from interlock.model.layout import Layout
from interlock.table.cells import Role
from interlock.table.rows import InterlockingTable, RouteRow

TENTH_MM = 1e-4
"""Lengths that differ by less are one length (metres)."""


@dataclass(frozen=True)
class Finding:
    """A cell that the audit sees differently."""

    route: str
    column: str
    text: str


def audit(layout: Layout, table: InterlockingTable) -> tuple[Finding, ...]:
    """Every disagreement, in the order of the table."""
    found: list[Finding] = []
    matched: dict[str, Trip] = {}
    every = [
        over
        for g in layout.signalling.signals
        for k in _functions(g)
        if g.id not in layout.signalling.boards and (k or g.id not in layout.signalling.stops)
        for t in trips(layout, g, k)
        for over in overruns(layout, t)
    ]
    mine = [t for t in every if not _unwanted(layout, t)]
    told_nothing = without_speed(layout, (t for t in every if not t.shunt))
    called = [t for t in told_nothing if not _unwanted(layout, t)]
    mine += [x for t in called if _calls_on(layout, t) and not _unwanted(layout, x := replace(t, call_on=True))]
    passed = [replace(t, identifier=True) for t in called if t.entry in layout.signalling.identifiers]
    past = _past(layout, [t for t in told_nothing if t.exit in layout.signalling.identifiers], passed)
    mine += [*past, *dict.fromkeys(p for t in past for p in t.parts[1:])]
    between: dict[tuple[str, str], list[Trip]] = {}
    for t in mine:
        between.setdefault((t.entry, t.exit), []).append(t)
    for r in sorted(table.routes, key=lambda r: len(r.path.passed or ())):  # parts beyond a signal first
        left = between.get((r.entry, r.exit), [])
        same = [
            t
            for t in left
            if (t.shunt, t.call_on, t.identifier) == tuple(r.kind == k for k in ("shunt", "call-on", "identifier"))
            and t.onward == (None if r.path.onward is None else matched.get(r.path.onward))
            and t.berth == r.path.berth
            and t.sections == r.path.section_ids
            and _path_positions(r) == dict(t.positions)
            and tuple(s for s, _ in (r.locking.overlap.ways if r.locking.overlap else ())) == _sections(layout, t.over)
            and _overlap_positions(r, t) == dict(t.over_positions)
        ]
        if len(same) != 1:
            found.append(Finding(r.id, "route", f"the audit finds {len(same)} such paths"))
            continue
        matched[r.id] = same[0]
        left.remove(same[0])
    unlisted = [t for those in between.values() for t in those]
    found += [
        Finding(f"{t.entry}-{t.exit}", "route", f"not in the table: over {', '.join(t.sections)}") for t in unlisted
    ]
    movements = _movements(layout, matched.values())
    approaches = {g: approach_sections(layout, g) for g in dict.fromkeys(r.entry for r in table.routes)}
    for r in table.routes:
        if r.id in matched:
            found += _row(layout, r, matched[r.id], approaches[r.entry])
            found += (Finding(r.id, *x) for x in flank(layout, r, matched[r.id], movements))
            if r.kind != "identifier":  # set with a route to its signal, and asked about with that one
                found += [Finding(r.id, "route", why) for why in own_train_in_the_way(layout, r, matched[r.id])]
    found += _driven(layout, table, matched)
    found += _in_the_way(layout, table, matched)
    found += _hostile(layout, table, matched)
    found += [Finding(*x) for x in added(layout, table, matched)]
    found += [Finding(*x) for x in conditions(layout, table, matched)]
    found += (Finding(v, "voyage", text) for v, text in voyages(layout, table, matched))
    found += _swings(layout, table, matched)
    return tuple(found)


def _past(layout: Layout, ahead: list[Trip], last: list[Trip]) -> list[Trip]:
    """Trips past one signal after the other that show their identifier lights, from the last part back to where they
    begin."""
    found: list[Trip] = []
    while last:
        longer = [replace(t, identifier=True) for t in ahead if t.entry in layout.signalling.identifiers]
        every = past_signals(layout, [*ahead, *longer], last)
        every = [t for t in every if not _unwanted(layout, t.run)]
        found += [t for t in every if not t.identifier]
        last = [t for t in every if t.identifier]
    return found


def _swings(layout: Layout, table: InterlockingTable, matched: dict[str, Trip]) -> Iterator[Finding]:
    """The overlaps that may take each other's place: those that every way to the signal has."""
    for g in (o.signal for o in layout.overlaps.all if o.swing):
        rows = [
            r
            for r in table.routes
            if r.locking.overlap is not None and r.locking.overlap.signal == g and r.id in matched
        ]
        beyond: dict[tuple[object, ...], set[tuple[Move, ...]]] = {}
        for r in rows:
            t = matched[r.id]
            beyond.setdefault((t.entry, t.call_on, t.moves), set()).add(t.over)
        common = set.intersection(*beyond.values()) if beyond else set()
        number = {matched[r.id].over: r.locking.overlap.option for r in rows if r.locking.overlap is not None}
        for r in rows:
            mine = {number[o] for o in common if len(common) > 1} - {
                r.locking.overlap.option if r.locking.overlap else 0
            }
            if r.locking.overlap is not None and set(r.locking.overlap.swings) != mine:
                yield Finding(r.id, "swings", f"the overlap may swing to {sorted(mine) or 'none'}")


def _calls_on(layout: Layout, t: Trip) -> bool:
    """Whether a train's trip can be run by calling on, too."""
    return not t.shunt and layout.signalling.signal[SignalId(t.entry)].call_on


def _functions(g: Signal) -> list[bool]:
    return [False] * (g.kind != "shunt") + [True] * (g.kind != "main")


def _unwanted(layout: Layout, t: Trip) -> bool:
    """Whether the layout excludes a path."""
    return any(chosen(x, t) for x in layout.declared.excluded)


def _sections(layout: Layout, moves: tuple[Move, ...]) -> tuple[SectionId, ...]:
    return tuple(dict.fromkeys(layout.track.section_of(m.edge) for m in moves))


def _overlap_positions(r: RouteRow, t: Trip) -> dict[MachineId, Position]:
    """The table's positions of the machines that lie under the audit's overlap."""
    under = {m for m, _ in t.over_positions}
    return {p.machine: p.position for p in r.locking.points if p.machine in under or p.role == "overlap"}


def _path_positions(r: RouteRow) -> dict[MachineId, Position]:
    return {p.machine: p.position for p in r.locking.points if p.role == "path"}


def _row(layout: Layout, r: RouteRow, trip: Trip, come: frozenset[SectionId] | None) -> Iterator[Finding]:
    """A row; `come`: the approach of its signal."""
    wanted = tuple(s for s in trip.sections if s != trip.berth)
    if trip.call_on:
        wanted = tuple(s for s in trip.sections if s == trip.sections[0] or standing_place(layout, s))
    if tuple(c.section for c in r.clear.sections) != wanted:
        yield Finding(r.id, "sections", f"the path lies over {', '.join(trip.sections)}")
    for what, moves, stated in _lengths(r, trip):
        if abs((metres := sum(layout.track.edge[m.edge].length for m in moves)) - stated) > TENTH_MM:
            yield Finding(r.id, "length", f"the {what} is {metres:g} m long, not {stated:g}")
    if tuple(s.section for s in r.locking.release) != trip.sections:
        yield Finding(r.id, "release", "the order is not that of the path")
    boundary = layout.track.boundary_at.get(r.path.entry_node)
    rear = {e.section for e in layout.track.edges_at[r.path.entry_node]} - {trip.sections[0]}
    want = boundary.approach if boundary is not None else next(iter(rear), None)
    if r.locking.approach.section != want:
        yield Finding(r.id, "approach", f"{want} lies in rear of {r.entry}")
    if frozenset(r.locking.approach.sections) != (come or frozenset()):
        where = f"a train may come from {', '.join(sorted(come))}" if come is not None else "it is always locked"
        yield Finding(r.id, "approach", where)
    foul = {(s, w) for s, w, *_ in foul_neighbours(layout, trip)} | crossed(layout, trip, _positions(r))
    if {(c.section, c.when) for c in r.clear.foul} != foul:
        told = sorted(f"{s}{f' with {w[0]} {w[1]}' if w else ''}" for s, w in foul)
        yield Finding(r.id, "foul", f"foul sections are {', '.join(told) or 'none'}")
    taken = {*trip.sections, *_sections(layout, trip.over)}
    secured = {d.id for d in layout.signalling.devices if set(d.over) & taken}
    lies = {(p.machine, p.position) for p in r.locking.points if p.role == "device"}
    if lies != {(m, Position.REVERSE) for m in secured}:
        yield Finding(r.id, "devices", f"to be closed are {', '.join(sorted(secured)) or 'none'}")
    if (r.signal.aspect.shows, r.signal.aspect.next) != (shown := aspect(layout, trip, _slowest(layout, trip))):
        yield Finding(r.id, "aspect", f"an open {r.entry} shows {shown[0]}")
    if bool(r.signal.aspect.indicator) is not route_indicator(layout, trip):
        yield Finding(
            r.id, "aspect", f"the route indicator of {r.entry} is {'dark' if r.signal.aspect.indicator else 'lit'}"
        )
    if r.signal.speed.kmh != (slowest := _slowest(layout, trip)):
        yield Finding(r.id, "speed", f"the lowest speed along the path is {slowest}")
    if r.signal.closing.whole != (left := _left_behind(layout, trip, rear)):
        yield Finding(r.id, "closing", f"{r.entry} closes with {f'{left} clear' if left else 'the first axle'}")


def _positions(r: RouteRow) -> set[tuple[MachineId, Position]]:
    """How the machines lie that a route holds."""
    return {(p.machine, p.position) for p in r.locking.points}


def _lengths(r: RouteRow, trip: Trip) -> Iterator[tuple[str, tuple[Move, ...], float]]:
    """What is stated in metres, over what it leads, and how long it is told to be."""
    yield "path", trip.run.moves, r.path.length
    if r.locking.overlap is not None:
        yield "overlap", trip.over, r.locking.overlap.metres


def _driven(layout: Layout, table: InterlockingTable, matched: dict[str, Trip]) -> Iterator[Finding]:
    """Points beside the path are driven to where the routes that may be set together with it hold them, or do not
    mind a train in the section; to normal where there is none of either."""
    if not layout.principles.drive_points:
        return
    holders: dict[MachineId, dict[RouteId, Position]] = {}
    minding: dict[tuple[SectionId, MachineId], dict[RouteId, set[Position]]] = {}
    for r in table.routes:
        for d in r.locking.points:
            holders.setdefault(d.machine, {})[r.id] = d.position
        trip = matched.get(r.id)
        joints = [(s, w) for s, w, *_ in foul_neighbours(layout, trip)] if trip is not None else []
        for section, when in (*joints, *(crossed(layout, trip, _positions(r)) if trip is not None else ())):
            if when is not None:
                minding.setdefault((section, when[0]), {}).setdefault(r.id, set()).add(when[1].other)
    for r in (r for r in table.routes if r.id in matched):
        apart = {
            r.id,
            *r.locking.hostile.routes,
            *(o.id for o in table.routes if _with(table, o, r) or _with(table, r, o)),
        }
        wanted: dict[MachineId, set[Position]] = {}
        for section in matched[r.id].sections:
            for p in layout.machines.points_in.get(section, ()):
                held, minded = holders.get(p.machine, {}), minding.get((section, p.machine), {})
                ways = wanted.setdefault(p.machine, set())
                ways |= {x for o, x in held.items() if o not in apart}
                ways |= {x for o, those in minded.items() if o not in apart and o not in held for x in those}
        own = frozen_machines(r)
        beside = {m: next(iter(x), Position.NORMAL) for m, x in wanted.items() if m not in own and len(x) < 2}
        if {p.machine: p.position for p in r.locking.driven} != beside:
            where = ", ".join(f"{m} {x}" for m, x in sorted(beside.items()))
            yield Finding(r.id, "driven", f"driven along are {where or 'no points'}")


def _with(table: InterlockingTable, r: RouteRow, part: RouteRow) -> bool:
    """Whether a route leads past a signal, or several one after the other, over another."""
    while r.path.onward is not None:
        r = table.route[r.path.onward]
        if r.id == part.id:
            return True
    return False


def _movements(layout: Layout, trips_: Iterable[Trip]) -> dict[SectionId, set[frozenset[SectionId]]]:
    found: dict[SectionId, set[frozenset[SectionId]]] = {}
    for t in trips_:
        for section in t.sections:
            found.setdefault(section, set()).add(frozenset(t.sections))
        for section in in_rear(layout, t) | ({t.berth} if t.berth is not None else frozenset()):
            found.setdefault(section, set()).add(frozenset())
    return found


def _in_the_way(layout: Layout, table: InterlockingTable, matched: dict[str, Trip]) -> Iterator[Finding]:
    """No flank space lies where a train may be under a route that can be set at the same time, unless it is the one
    that goes on from there."""
    there: dict[SectionId, list[RouteRow]] = {}
    for r in table.routes:
        for section in {*matched[r.id].sections, *in_rear(layout, matched[r.id])} if r.id in matched else ():
            there.setdefault(section, []).append(r)
    for r in table.routes:
        hostile = {*r.locking.hostile.routes} if r.clear.space else set()
        onward = onward_over(layout, matched[r.id]) if r.clear.space and r.id in matched else {}
        for c in r.clear.space:
            for other in there.get(SectionId(c.name), ()) if not c.lamp else ():
                if other.id not in hostile and other is not r and other.entry not in (r.exit, *onward):
                    yield Finding(r.id, "space", f"a train of {other.id} may be in {c.name}")


def _slowest(layout: Layout, trip: Trip) -> int | None:
    """The lowest speed stated along the trip: of its sections, of points passed over their reverse leg, and for the
    overlap that it has."""
    if trip.onward is not None:
        both = (_slowest(layout, replace(trip, onward=None)), _slowest(layout, trip.onward))
        return min((v for v in both if v is not None), default=None)
    limits = [layout.track.section[s].speed for s in trip.sections]
    if trip.over:
        limits.append(overlap_speed(layout, trip))
    over = {m.edge for m in trip.moves}
    here = [p for s in trip.sections for p in layout.machines.points_in.get(s, ())]
    limits += [p.speed for p in here if p.reverse in over and p.toe in over]
    return min((v for v in limits if v is not None), default=None)


def _left_behind(layout: Layout, trip: Trip, rear: set[SectionId]) -> SectionId | None:
    """The section before the signal whose clearing closes it; None where the first axle does."""
    rules = layout.principles
    asked = rules.shunt_closes if trip.shunt else rules.main_closes
    if trip.call_on or trip.identifier or asked != "whole-movement" or not rear:
        return None
    (section,) = rear
    return None if left_standing(layout, section) else section


def frozen_machines(r: RouteRow) -> set[MachineId]:
    """The machines that a route locks."""
    return {p.machine for p in r.locking.points}


_DIGITS = bytes.maketrans(b"\0\1", b"01")


@dataclass(frozen=True)
class _Ground:
    """What a route occupies, so that all pairs can be compared."""

    row: RouteRow
    entry: str
    sections: frozenset[SectionId]
    nodes: frozenset[NodeId]
    foul: frozenset[Foul]
    positions: dict[MachineId, Position]
    exit: str
    shunt: bool
    moves: frozenset[Move]
    over: frozenset[SectionId]
    over_moves: frozenset[Move]
    over_nodes: frozenset[NodeId]
    ways: dict[SectionId, frozenset[Move]]
    onward: dict[str, frozenset[Move]]
    swings: bool


def _ground(layout: Layout, row: RouteRow, trip: Trip) -> _Ground:
    special = (
        m.node for m in trip.moves[:-1] if m.node in layout.pointwork.crossing_at or m.node in layout.pointwork.point_at
    )
    return _Ground(
        row,
        trip.entry,
        frozenset(trip.sections),
        frozenset(special),
        frozenset(foul_neighbours(layout, trip) | across(layout, trip)),
        {p.machine: p.position for p in row.locking.points},
        trip.exit,
        trip.shunt,
        frozenset(trip.moves),
        frozenset(_sections(layout, trip.over)),
        frozenset(trip.over),
        frozenset(m.node for m in trip.over[:-1] if m.node in layout.pointwork.crossing_at),
        _by_section(layout, (*trip.moves, *trip.over)),
        onward_over(layout, trip),
        swings(layout, trip.exit),
    )


def _by_section(layout: Layout, moves: Iterable[Move]) -> dict[SectionId, frozenset[Move]]:
    found: dict[SectionId, set[Move]] = {}
    for m in moves:
        found.setdefault(layout.track.section_of(m.edge), set()).add(m)
    return {s: frozenset(those) for s, those in found.items()}


HeldOver = Mapping[tuple[SectionId, frozenset[Move]], Collection[tuple[MachineId, Position]]]


def _held_over(grounds: Sequence[_Ground]) -> HeldOver:
    """By section and way through it the machines that some route over it holds, but for what the author added."""
    found: dict[tuple[SectionId, frozenset[Move]], set[tuple[MachineId, Position]]] = {}
    for g in grounds:
        holds = {(p.machine, p.position) for p in g.row.locking.points if p.role is not Role.ADDED}
        for way in g.ways.items():
            found.setdefault(way, set()).update(holds)
    return found


def _hostile(layout: Layout, table: InterlockingTable, matched: dict[str, Trip]) -> Iterator[Finding]:
    grounds = [_ground(layout, r, matched[r.id]) for r in table.routes if r.id in matched]
    number = {g.row.id: i for i, g in enumerate(grounds)}
    pairs, certain = _meeting(grounds)
    size, own, held = len(grounds), _onward(grounds, number, pairs, certain), _held_over(grounds)
    lists = bytearray(size * size)  # row by row whom it lists, column by column who lists it
    for i, g in enumerate(grounds):
        for j in map(number.get, g.row.locking.hostile.routes):
            if j is not None:
                lists[i * size + j] = 1
    listed = [_number(lists[i * size : (i + 1) * size]) for i in range(size)]
    for i, a in enumerate(grounds):
        told = _number(lists[i::size])
        agreed = certain[i] & listed[i] & told
        for j in _bits((pairs[i] | listed[i] | told) & ~agreed & -(1 << i + 1)):
            b = grounds[j]
            parts = [[x, *(grounds[n] for n in own.get(k, ()))] for k, x in ((i, a), (j, b))]
            why = next((w for x, y in product(*parts) if (w := _cannot_both(layout, x, y, held)) is not None), None)
            if j in own.get(i, ()) or i in own.get(j, ()):
                why, parts = None, [[a], [b]]
            if why is None and any(declared(layout, matched[x.row.id], matched[y.row.id]) for x, y in product(*parts)):
                why = "declared, with", frozenset({b.row.id})
            for x, y, says in ((a, b, listed[i] >> j & 1), (b, a, listed[j] >> i & 1)):
                if why and not says:
                    text = f"{y.row.id} is hostile: {why[0]} {', '.join(sorted(why[1]))}"
                    yield Finding(x.row.id, "hostile", text)
                if not why and says:
                    yield Finding(x.row.id, "hostile", f"{y.row.id} is not hostile")


def _onward(
    grounds: list[_Ground], number: dict[RouteId, int], pairs: list[int], certain: list[int]
) -> dict[int, list[int]]:
    """Of those that lead past signals, what they lock beyond them: whatever that may clash with, they may, but with
    itself, which is set with them."""
    found: dict[int, list[int]] = {}
    for i in sorted(range(len(grounds)), key=lambda i: len(grounds[i].row.path.passed or ())):
        k = number.get(grounds[i].row.path.onward or RouteId(""))
        if k is None:
            continue
        found[i] = [k, *found.get(k, ())]
        for of in (pairs, certain):
            of[i] |= of[k]
            for j in _bits(of[k]):
                of[j] |= 1 << i
            of[i] &= ~(1 << i)
    for i, those in found.items():
        for x, y in (z for k in those for z in ((i, k), (k, i))):
            certain[x] &= ~(1 << y)
            pairs[x] |= 1 << y
    return found


Thing = tuple[str, str]
"""What routes may have in common: its kind, and its id."""


def _meeting(grounds: list[_Ground]) -> tuple[list[int], list[int]]:
    """For each the others, as bits, that it may clash with, as both read one signal, section or node, or one needs a
    machine otherwise; and those with which it can never be set, as both begin at one signal, or pass a section or node.
    """
    passed: list[set[Thing]] = []
    used: list[set[Thing]] = []
    needed: list[set[Thing]] = []
    barred: list[set[Thing]] = []
    for g in grounds:
        own = {("signal", str(g.entry))}
        own |= {("section", str(s)) for s in g.sections} | {("node", str(n)) for n in g.nodes}
        passed.append(own)
        of = own | {("section", str(s)) for s in (*g.over, *(f[0] for f in g.foul))}
        used.append(of | {("node", str(n)) for n in g.over_nodes})
        needed.append({(str(p), str(m)) for m, p in g.positions.items()})
        barred.append({(str(p.other), str(m)) for m, p in g.positions.items()})
    turned = _all_users(barred, _users(needed))
    return [a | b for a, b in zip(_all_users(used, _users(used)), turned, strict=True)], _all_users(
        passed, _users(passed)
    )


def _users(things: list[set[Thing]]) -> dict[Thing, int]:
    found: dict[Thing, int] = {}
    for i, of in enumerate(things):
        for thing in of:
            found[thing] = found.get(thing, 0) | 1 << i
    return found


def _all_users(things: list[set[Thing]], users: dict[Thing, int]) -> list[int]:
    found = [0] * len(things)
    for i, of in enumerate(things):
        for thing in of:
            found[i] |= users.get(thing, 0)
    return found


def _number(row: bytearray) -> int:
    """The bytes of a row that are 1, as bits."""
    return int(row[::-1].translate(_DIGITS), 2)


def _bits(x: int) -> Iterator[int]:
    """The numbers of the bits that are set, the lowest first."""
    while x:
        low = x & -x
        yield low.bit_length() - 1
        x ^= low


def _same_way(layout: Layout, a: frozenset[Move], b: frozenset[Move], section: SectionId) -> bool:
    """Both pass a section over the same edges in the same direction."""
    return {m for m in a if layout.track.section_of(m.edge) == section} == {
        m for m in b if layout.track.section_of(m.edge) == section
    }


def _shared(x: _Ground, y: _Ground) -> frozenset[Move]:
    """The moves of x's overlap over which y may run while it is held."""
    return x.onward.get(y.entry, frozenset()) if y.row.kind == "main" else frozenset()


def _held_by_both(x: _Ground, y: _Ground) -> frozenset[Move]:
    """The moves over which two overlaps may lie at a time: beyond the signal of the one, past which the other leads."""
    if x.exit == y.exit or x.swings or y.swings:
        return frozenset()
    return (x.onward.get(y.exit, frozenset()) & y.over_moves) | (y.onward.get(x.exit, frozenset()) & x.over_moves)


Clash = tuple[str, Collection[str]]
"""What two routes cannot share, and where."""


def _cannot_both(layout: Layout, a: _Ground, b: _Ground, held: HeldOver) -> Clash | None:
    if a.entry == b.entry:
        return "both begin at", frozenset({a.entry})
    if not a.sections.isdisjoint(b.sections):
        return "both pass", a.sections & b.sections
    if not a.nodes.isdisjoint(b.nodes):
        return "both pass", a.nodes & b.nodes
    for x, y in ((a, b), (b, a)):
        if not x.over:
            continue
        shared, both = _shared(x, y), _held_by_both(x, y)
        if any(not all(m in both for z in (x, y) for m in z.over_moves & z.ways[s]) for s in x.over & y.over):
            return "the overlaps share", x.over & y.over
        for section in sorted(x.over & y.sections):
            mine = x.over_moves & x.ways[section]
            if not mine <= shared or not _same_way(layout, x.over_moves, y.moves, section):
                return "overlap over", frozenset({section})
        nodes, lying = ({m.node for m in those} for those in (shared & y.moves, both))
        if not x.over_nodes.isdisjoint(y.over_nodes - lying) or not x.over_nodes.isdisjoint(y.nodes - nodes):
            return "an overlap crosses", x.over_nodes
    if not a.positions.keys().isdisjoint(b.positions):
        for m in sorted(a.positions.keys() & b.positions.keys()):
            if a.positions[m] is not b.positions[m]:
                return "two positions of machine", frozenset({m})
    for x, y in ((a, b), (b, a)):
        for section, when, near, of in x.foul:
            if section in y.sections | y.over and (
                when is None
                or any(near in (m.node, layout.track.far(m.edge, m.node)) for m in y.ways[section])
                or when in held[section, y.ways[section]]
                or when in held[of, x.ways[of]]
            ):
                return "foul of", frozenset({section})
    return None
