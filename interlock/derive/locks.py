"""What each way through a section demands and excludes when it is locked (R1, R5, R6, R7).

Only ways that some route uses become locks.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from interlock.derive.flank import Options, Requester, point_demands, protect, requesters, space
from interlock.derive.routes import Path, machine_positions
from interlock.diag import Element, Sink
from interlock.model.elements import Position, SectionId
from interlock.model.foul import FoulJoint, foul_joints
from interlock.model.layout import Layout
from interlock.model.traversal import Traversal
from interlock.table.rows import (
    Because,
    Exclusion,
    FlankCell,
    FoulCell,
    PointDemand,
    ProviderKind,
    Role,
    SpaceCell,
    TraversalRow,
)


def derive_locks(layout: Layout, paths: Sequence[Path], sink: Sink) -> tuple[TraversalRow, ...]:
    """Every lock, ordered by section and number; reports unprotected flanks (IL4001)."""
    used: dict[tuple[SectionId, int], Traversal] = {}
    over: dict[tuple[SectionId, int], list[Path]] = {}
    for path in paths:
        for t in (*path.ways, *path.overlap):
            used[t.key] = t
            over.setdefault(t.key, []).append(path)
    demands = {p.id: machine_positions(layout, (*p.ways, *p.overlap)) or {} for p in paths}
    fouls, options = foul_joints(layout), Options(layout)
    missing: dict[Requester, list[str]] = {}
    rows = []
    for key, t in sorted(used.items()):
        own = machine_positions(layout, (t,)) or {}
        cells, unprotected = protect(layout, t, own, [demands[p.id] for p in over[key]], options)
        for r in unprotected:
            missing.setdefault(r, []).extend(p.id for p in over[key])
        rows.append(replace(_row(layout, t, cells, used, fouls), space=_space(layout, t, cells)))
    for r, routes_ in sorted(missing.items(), key=lambda x: x[0].name):
        sink.add(
            "IL4001",
            f"nothing keeps vehicles away from {r.name}; routes {', '.join(sorted(set(routes_)))} pass there",
            None,
            f"add a signal or a protecting point, or waive it: `waive: [{{flank: {r.name}, reason: ...}}]`",
            about=Element("points" if r.node in layout.point_at else "crossings", r.node),
        )
    needed = {c.requester for r in rows for c in r.flank for p in c.providers if p.kind.value == "waived"}
    for w in layout.waivers:
        name = f"{w.point}.{'normal' if w.leg == 'N' else 'reverse'}"
        if name not in needed:
            sink.add(
                "IL2008",
                f"the waiver of {name} waives nothing: it is protected, or no route passes there",
                None,
                "remove the waiver",
                about=Element("waive", name),
            )
    return tuple(rows)


def _space(layout: Layout, t: Traversal, flank: tuple[FlankCell, ...]) -> tuple[SpaceCell, ...]:
    """The flank space of every requester of a way that is protected, not waived."""
    cells = {c.requester: c.providers for c in flank}
    found: dict[tuple[str, bool], str] = {}
    for r in requesters(layout, t):
        providers = cells.get(r.name, ())
        if r.name in cells and not any(p.kind is ProviderKind.WAIVED for p in providers):
            found = space(layout, r, providers) | found
    return tuple(SpaceCell(name, lamp, Because("R5", why)) for (name, lamp), why in sorted(found.items()))


def _row(
    layout: Layout,
    t: Traversal,
    flank: tuple[FlankCell, ...],
    used: dict[tuple[SectionId, int], Traversal],
    fouls: tuple[FoulJoint, ...],
) -> TraversalRow:
    demands = {
        layout.point[p].machine: PointDemand(
            layout.point[p].machine,
            x,
            Role.PATH,
            t.section,
            Because("R1", f"point {p} lies on the way through {t.section}"),
        )
        for p, x in t.points
    }
    for cell in flank:
        for machine, position in (point_demands(cell.providers) or {}).items():
            demands.setdefault(machine, PointDemand(machine, position, Role.FLANK, t.section, cell.because))
    for device in layout.devices:
        if t.section in device.over:
            why = Because("R13", f"{device.kind} {device.id} lies over {t.section}")
            demands[device.id] = PointDemand(device.id, Position.REVERSE, Role.DEVICE, t.section, why)
    exclusions: list[Exclusion] = []
    for cid, arm in t.crossings:
        across = layout.section_of(layout.crossing[cid].arms[1 - arm][0])
        if across != t.section:
            numbers = tuple(sorted(n for (s, n), o in used.items() if s == across and (cid, 1 - arm) in o.crossings))
            exclusions.append(Exclusion(across, False, numbers, Because("R6", f"the ways cross on the diamond {cid}")))
    foul_cells: list[FoulCell] = []
    for f in fouls:
        unless = f", unless {f.when[0]} lies {f.when[1].other}" if f.when is not None else ""
        why = Because("R7", f"the joint {f.section}|{f.neighbour} is foul of {f.name}{unless}")
        if f.fouls(t):
            foul_cells.append(FoulCell(f.neighbour, f.section, f.when, why))
            touching = tuple(
                sorted(n for (s, n), o in used.items() if s == f.neighbour and f.node in (o.entry, o.exit))
            )
            exclusions.append(Exclusion(f.neighbour, f.when is None, () if f.when is None else touching, why))
        if f.touches(t):
            numbers = tuple(sorted(n for (s, n), o in used.items() if s == f.section and f.fouls(o)))
            exclusions.append(Exclusion(f.section, False, numbers, why))
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
