"""What each way through a section demands and excludes when it is locked (R1, R5, R6, R7).

Only ways that some route uses become locks.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from types import MappingProxyType

from interlock.derivation.conflicts import set_apart
from interlock.derivation.flank import Options, Requester, cell, point_demands, requesters, space
from interlock.derivation.routes import Path
from interlock.derivation.settle import Place, Settlement, beside
from interlock.derivation.unsettled import report_flanks
from interlock.diag import Sink
from interlock.model.bits import bits_of
from interlock.model.elements import MachineId, Position, SectionId
from interlock.model.foul import CrossedSection, FoulBeside, FoulJoint, crossed_sections, foul_beside, foul_joints
from interlock.model.layout import Layout
from interlock.model.traversal import Traversal, topology
from interlock.table.cells import (
    Because,
    Exclusion,
    FlankCell,
    FoulCell,
    PointDemand,
    Provider,
    ProviderKind,
    Role,
    SpaceCell,
    TraversalKey,
)
from interlock.table.rows import TraversalRow

Locks = Mapping[TraversalKey, TraversalRow]
Held = Mapping[TraversalKey, frozenset[tuple[MachineId, Position]]]
"""By way, machines with positions."""
NOTHING_HELD: Held = MappingProxyType({})


def derive_locks(layout: Layout, paths: Sequence[Path], sink: Sink) -> tuple[TraversalRow, ...]:
    """Every lock, ordered by section and number; reports flanks that are unprotected (IL4001), that cannot be protected
    without a contradiction (IL4002), or that have substitute protection (IL4010)."""
    used: dict[TraversalKey, Traversal] = {}
    over: dict[TraversalKey, int] = {}
    for i, path in enumerate(paths):
        for t in (*path.ways, *path.overlap):
            used[t.key] = t
            over[t.key] = over.get(t.key, 0) | 1 << i
    fouls, options = (foul_joints(layout), crossed_sections(layout), foul_beside(layout)), Options(layout)
    bare = {key: _row(layout, t, (), used, fouls) for key, t in sorted(used.items())}
    demands = {p.id: route_demands(p, bare) for p in paths}
    hostile = set_apart(layout, paths, bare, demands)
    every = (1 << len(paths)) - 1
    beside_ = {bits: beside(bits, hostile, every) for bits in {*over.values()}}
    places = [Place(k, r, over[k], beside_[over[k]]) for k in bare for r in requesters(layout, used[k])]
    asked = [p for p in places if options.preferred(p.requester) is not None]
    needs = [{d.machine: d.position for d in demands[p.id]} for p in paths]
    settled = Settlement(asked, needs, options)
    cells: dict[TraversalKey, dict[Requester, tuple[Provider, ...]]] = {}
    for at, option in settled.chosen.items():
        cells.setdefault(asked[at].key, {})[asked[at].requester] = option
    for p in places:
        if p.requester.waiver is not None:
            waived = (Provider(ProviderKind.WAIVED, p.requester.waiver),)
            cells.setdefault(p.key, {}).setdefault(p.requester, waived)
    rows: dict[TraversalKey, TraversalRow] = {}
    for key in bare:
        mine = cells.get(key, {})
        flank = tuple(cell(r, mine[r]) for r in requesters(layout, used[key]) if r in mine)
        rows[key] = _row(layout, used[key], flank, used, fouls)
    if any(f.when is not None for those in fouls for f in those):
        held = _held(paths, rows)
        rows = {key: _row(layout, used[key], row.flank, used, fouls, held) for key, row in rows.items()}
    report_flanks(layout, paths, places, settled, options, sink)
    if not any(_space(layout, used[key], row.flank, frozenset()) for key, row in rows.items()):
        return tuple(rows.values())
    hostile = set_apart(layout, paths, rows, {p.id: route_demands(p, rows) for p in paths})
    there, stands = [_taken(layout, p) for p in paths], [_standing(layout, p) for p in paths]
    run_over: dict[TraversalKey, int] = {}  # by path: a train that has its overlap there comes from elsewhere
    for i, path in enumerate(paths):
        for t in path.ways:
            run_over[t.key] = run_over.get(t.key, 0) | 1 << i
    busy: dict[tuple[int, int], frozenset[SectionId]] = {}
    for every_one, own in {(over[key], run_over.get(key, 0)) for key in rows}:
        others = beside(every_one, hostile, every) & ~own
        where = [there[i] for i in bits_of(others)] + [stands[i] for i in bits_of(own)]
        busy[every_one, own] = frozenset().union(*where)
    return tuple(
        replace(row, space=_space(layout, used[key], row.flank, busy[over[key], run_over.get(key, 0)]))
        for key, row in rows.items()
    )


def _taken(layout: Layout, path: Path) -> frozenset[SectionId]:
    """The sections in which a train may be that runs a route, or is about to."""
    return frozenset(t.section for t in path.ways) | _standing(layout, path)


def _standing(layout: Layout, path: Path) -> frozenset[SectionId]:
    """Where the train of a route stands before it, and where vehicles may stand at its end."""
    rear = topology(layout).beyond(path.ways[0].section, path.entry_node)
    return frozenset(s for s in (rear, path.berth) if s is not None)


def route_demands(path: Path, locks: Locks) -> tuple[PointDemand, ...]:
    """How a route needs machines to lie: for its path first, then for its overlap and its flanks."""
    found: dict[MachineId, PointDemand] = {}
    demands = [d for t in path.ways for d in locks[t.key].points]
    for t in path.overlap:
        demands += [replace(d, role=Role.OVERLAP) if d.role is Role.PATH else d for d in locks[t.key].points]
    for d in demands:
        first = found.setdefault(d.machine, d)
        if first.role is not d.role and d.role is Role.PATH:
            found[d.machine] = d
    return tuple(found.values())


def _held(paths: Sequence[Path], locks: Locks) -> Held:
    """By way the machines that some route over it holds, in which position."""
    found: dict[TraversalKey, frozenset[tuple[MachineId, Position]]] = {}
    for p in paths:
        holds = frozenset((d.machine, d.position) for d in route_demands(p, locks))
        for t in (*p.ways, *p.overlap):
            found[t.key] = found.get(t.key, frozenset()) | holds
    return found


def _at_joint(f: FoulJoint, t: Traversal, held: Held) -> bool:
    """A train on a way of the neighbour counts as standing at a foul joint: its way leads there, or the point that
    decides is held towards the joint (R7), for the flank of the train's own route."""
    return f.touches(t) or (t.section == f.neighbour and f.when in held.get(t.key, ()))


def _apart_at(f: FoulJoint, t: Traversal, o: Traversal, held: Held) -> bool:
    """Whether a way that a joint fouls, and one of the neighbour, exclude each other."""
    return f.fouls(t) and (_at_joint(f, o, held) or (o.section == f.neighbour and f.when in held.get(t.key, ())))


def _space(
    layout: Layout, t: Traversal, flank: tuple[FlankCell, ...], busy: frozenset[SectionId]
) -> tuple[SpaceCell, ...]:
    """The flank space of every requester of a way that is protected, not waived.

    `busy`: where trains are that may run at the same time, each on a route of its own; they are not waited for.
    """
    cells = {c.requester: c.providers for c in flank}
    found: dict[tuple[str, bool], str] = {}
    for r in requesters(layout, t):
        providers = cells.get(r.name, ())
        if r.name in cells and not any(p.kind is ProviderKind.WAIVED for p in providers):
            found = space(layout, r, providers) | found
    return tuple(
        SpaceCell(name, lamp, Because("R5", why))
        for (name, lamp), why in sorted(found.items())
        if lamp or name not in busy
    )


def _foul_cell(x: CrossedSection | FoulBeside) -> FoulCell:
    """A section that must be clear, since what is there may stand on a diamond (R6), or as near to a point or diamond
    as a way comes on the other leg or arm (R7)."""
    unless = f", unless {x.when[0]} lies {x.when[1].other}" if x.when is not None else ""
    if isinstance(x, CrossedSection):
        why = Because("R6", f"{x.neighbour} clear across the diamond {x.crossing}{unless}")
        return FoulCell(x.neighbour, x.section, x.when, why, x.crossing)
    why = Because("R7", f"the joint of {x.section} beside {x.name} is foul of {x.neighbour}{unless}")
    return FoulCell(x.neighbour, x.section, x.when, why, x.element)


def _across(
    crossed: Sequence[CrossedSection], t: Traversal, used: Mapping[TraversalKey, Traversal], held: Held
) -> list[Exclusion]:
    """Ways through a section that lies across on a diamond, and the other way round, on which a train would make the
    other one's signal show stop: it runs over a diamond that lies too near to this way, or no point tells that it is
    not on the diamond, or the one that does is held towards it, for the flank of either route."""
    found = []
    for x in (x for x in crossed if t.section in (x.section, x.neighbour)):
        over = t.section == x.section
        beyond = [o for o in used.values() if o.section == (x.neighbour if over else x.section)]
        numbers = sorted(o.number for o in beyond if _apart_across(x, *((t, o) if over else (o, t)), held))
        if numbers:
            why = Because("R6", f"a train in {x.neighbour} counts as one on the diamond {x.crossing}")
            found.append(Exclusion(beyond[0].section, False, tuple(numbers), why))
    return found


def _apart_across(x: CrossedSection, t: Traversal, o: Traversal, held: Held) -> bool:
    """Whether a way that a diamond's other arm fouls, and one of the section across, exclude each other: but for two
    ways over the diamond itself, which do so anyhow."""
    if not x.fouls(t):
        return False
    if any(c == x.crossing for c, _ in o.crossings):
        return x.element != x.crossing
    return x.when is None or x.when in held.get(o.key, ()) or x.when in held.get(t.key, ())


def _apart_beside(
    facing: Sequence[FoulBeside], t: Traversal, used: Mapping[TraversalKey, Traversal], held: Held
) -> list[Exclusion]:
    """Ways that come foul of each other beside a point or diamond, or where nothing tells that they do not."""
    numbers: dict[tuple[SectionId, str], set[int]] = {}
    for x in (x for x in facing if t.section in (x.section, x.neighbour)):
        other = x.neighbour if t.section == x.section else x.section
        for o in (o for o in used.values() if o.section == other):
            one, two = (t, o) if t.section == x.section else (o, t)
            towards = x.when is not None and (x.when in held.get(one.key, ()) or x.when in held.get(two.key, ()))
            if x.fouls(one) and (x.touches(two) or towards):
                numbers.setdefault((other, x.name), set()).add(o.number)
    return [
        Exclusion(other, False, tuple(sorted(those)), Because("R7", f"{t.section} and {other} are foul beside {name}"))
        for (other, name), those in numbers.items()
    ]


def _row(
    layout: Layout,
    t: Traversal,
    flank: tuple[FlankCell, ...],
    used: Mapping[TraversalKey, Traversal],
    beside: tuple[tuple[FoulJoint, ...], tuple[CrossedSection, ...], tuple[FoulBeside, ...]],
    held: Held = NOTHING_HELD,
) -> TraversalRow:
    fouls, crossed, facing = beside
    demands = {
        layout.pointwork.point[p].machine: PointDemand(
            layout.pointwork.point[p].machine,
            x,
            Role.PATH,
            t.section,
            Because("R1", f"point {p} lies on the way through {t.section}"),
        )
        for p, x in t.points
    }
    for c in flank:
        for machine, position in (point_demands(c.providers) or {}).items():
            demands.setdefault(machine, PointDemand(machine, position, Role.FLANK, t.section, c.because))
    for device in layout.signalling.devices:
        if t.section in device.over:
            why = Because("R13", f"{device.kind} {device.id} lies over {t.section}")
            demands[device.id] = PointDemand(device.id, Position.REVERSE, Role.DEVICE, t.section, why)
    exclusions: list[Exclusion] = []
    for cid, arm in t.crossings:
        across = layout.track.section_of(layout.pointwork.crossing[cid].arms[1 - arm][0])
        if across != t.section:
            numbers = tuple(sorted(n for (s, n), o in used.items() if s == across and (cid, 1 - arm) in o.crossings))
            exclusions.append(Exclusion(across, False, numbers, Because("R6", f"the ways cross on the diamond {cid}")))
    exclusions += _across(crossed, t, used, held) + _apart_beside(facing, t, used, held)
    foul_cells = [*dict.fromkeys(_foul_cell(x) for x in crossed if x.fouls(t))]
    for f in fouls:
        unless = f", unless {f.when[0]} lies {f.when[1].other}" if f.when is not None else ""
        why = Because("R7", f"the joint {f.section}|{f.neighbour} is foul of {f.name}{unless}")
        if f.fouls(t):
            foul_cells.append(FoulCell(f.neighbour, f.section, f.when, why))
            there = tuple(sorted(n for (s, n), o in used.items() if s == f.neighbour and _apart_at(f, t, o, held)))
            exclusions.append(Exclusion(f.neighbour, f.when is None, () if f.when is None else there, why))
        if t.section == f.neighbour:
            numbers = tuple(sorted(n for (s, n), o in used.items() if s == f.section and _apart_at(f, o, t, held)))
            if numbers or f.touches(t):
                exclusions.append(Exclusion(f.section, False, numbers, why))
    asked = {(c.section, c.when) for c in foul_cells}
    cells = dict.fromkeys(_foul_cell(x) for x in facing if x.fouls(t))
    foul_cells += [c for c in cells if (c.section, c.when) not in asked]
    return TraversalRow(
        t.section,
        t.number,
        t.entry,
        t.exit,
        tuple(demands.values()),
        t.crossings,
        flank,
        tuple(exclusions),
        tuple(foul_cells),
        (),
    )
