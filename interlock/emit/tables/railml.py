"""The table as JSON with the element names of railML 3.2 interlocking: a reading aid, not a railML file.

Names used: route, routeEntry, routeExit, hasOverlap, facingSwitchInPosition, trailingSwitchInPosition, hasTvdSection,
routeRelation (requiredSwitchPosition, requiredDerailerPosition, requiredSectionState, requiredSignalAspect,
requiredLevelCrossingState), conflictingRoute (refersToRoute, conflictsWithRoute, reasonForConflict), releaseDelay: of
an overlap, and of what the author has a route hold so many seconds longer.  What railML has no element for that is
known to us stands under additionalRelation in words: doors and bridges, conditions, zones, lamps, the direction of a
line, and points that are driven beside the path.  Points lie normal or reverse here, and not left or right.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from interlock.emit.tables.document import document
from interlock.model.elements import DeviceKind, Position
from interlock.model.layout import Layout
from interlock.model.times import overlap_release_s
from interlock.table.cells import Hostility, ProviderKind, Role
from interlock.table.national.reading import DERAILER, Reading
from interlock.table.rows import InterlockingTable, RouteRow

IN = {Position.NORMAL: "normal", Position.REVERSE: "reverse"}
STATE = {"closed": "secured"}
"""How a bridge or another device is that a route locks, where that is said otherwise than of level crossings."""


def railml_json(layout: Layout, table: InterlockingTable) -> str:
    """Routes, their relations and conflicts."""
    x = Reading(layout, table)
    head = {
        "note": "element names of railML 3.2 interlocking; not a railML document. conflictsWithRoutes tells places in "
        "routeGroups, which name routes by elementNumber; requiredSignalAspect those in signalGroups; counted from 0",
        "layout": table.layout,
    }
    signals, routes = _Groups(), _Groups()
    return document(
        head,
        {
            "routes": [_route(x, r) for r in table.routes],
            "routeRelations": [_relation(x, r, signals) for r in table.routes],
            "conflictingRoutes": [c for r in table.routes for c in _conflicts(table, r, routes)],
            "signalGroups": list(signals),
            "routeGroups": list(routes),
        },
    )


class _Groups(dict[tuple[object, ...], int]):
    """Groups of names or numbers, each once, with their places."""

    def place(self, group: Iterable[object]) -> int:
        """The place of a group."""
        return self.setdefault(tuple(group), len(self))


def _conflicts(table: InterlockingTable, r: RouteRow, groups: _Groups) -> Iterator[dict[str, object]]:
    """The routes that conflict with a route, those together that do for one reason, and, where the author declares
    them, for as long."""
    longer = {c.route for c in r.locking.barred} if r.locking.hold else set()
    found: dict[tuple[Hostility, bool], list[int]] = {}
    for h in r.locking.hostile:
        found.setdefault((h.how, h.route in longer), []).append(table.route[h.route].number)
    kinds: dict[tuple[str, bool], list[int]] = {}
    for (how, held), routes in found.items():
        kinds.setdefault((how.kind, held), []).append(groups.place(routes))
    for (kind, held), places in kinds.items():
        more = {"releaseDelay": r.locking.hold} if held else {}
        yield {"refersToRoute": r.id, "conflictsWithRoutes": places, "reasonForConflict": kind, **more}


def _route(x: Reading, r: RouteRow) -> dict[str, object]:
    facing = {m for m, _ in x.machines.facing(r)}
    path = [p for p in r.locking.points if p.role is Role.PATH]
    exit_: dict[str, object] = {"refersTo": r.exit}
    if r.locking.overlap is not None:
        exit_["hasOverlap"] = {
            "designator": f"{r.locking.overlap.signal}:{r.locking.overlap.option}",
            "length": r.locking.overlap.metres,
            "hasTvdSection": [s for s, _ in r.locking.overlap.ways],
            "switchInPosition": [
                {"refersTo": p.machine, "inPosition": IN[p.position]}
                for p in r.locking.points
                if p.role is Role.OVERLAP and x.machines.is_machine(p)
            ],
            "maySwingTo": [f"{r.locking.overlap.signal}:{k}" for k in r.locking.overlap.swings],
            "releaseDelay": overlap_release_s(x.layout, r.locking.overlap.signal),
        }
    return {
        "id": r.id,
        "elementNumber": r.number,
        "handlesRouteType": r.kind,
        "priorityRank": r.path.variant - 1,
        "approachReleaseDelay": r.locking.approach.delay_s,
        "routeEntry": {"refersTo": r.entry},
        "routeExit": exit_,
        "facingSwitchInPosition": [
            {"refersTo": p.machine, "inPosition": IN[p.position]} for p in path if p.machine in facing
        ],
        "trailingSwitchInPosition": [
            {"refersTo": p.machine, "inPosition": IN[p.position]} for p in path if p.machine not in facing
        ],
        "hasTvdSection": [s.section for s in r.clear.sections],
        **({"continuesAs": r.path.onward} if r.path.onward is not None else {}),
    }


def _relation(x: Reading, r: RouteRow, groups: _Groups) -> dict[str, object]:
    legs = [[p.name for p in c.providers if p.kind is ProviderKind.SIGNAL] for c in r.locking.flank]
    stops = dict.fromkeys(groups.place(names) for names in legs if names)
    devices = x.machines.devices(r).items()
    crossings = {m for m, _ in devices if x.layout.machines.device[m].kind is DeviceKind.LEVEL_CROSSING}
    flank = [p for p in r.locking.points if p.role in (Role.FLANK, Role.ADDED)]
    named = [(m, *(end.id for end in x.layout.machines.ends.get(m, ()))) for m in r.locking.held_longer]
    after = {name: {"releaseDelay": r.locking.hold} for names in named for name in names}
    return {
        "refersToRoute": r.id,
        "requiredSwitchPosition": [
            {"refersTo": p.machine, "inPosition": IN[p.position], **after.get(p.machine, {})}
            for p in flank
            if x.machines.is_machine(p)
        ],
        "requiredDerailerPosition": [
            {"refersTo": d, "inPosition": DERAILER[position], **after.get(d, {})}
            for d, position in x.machines.derailers(r).items()
        ],
        "requiredSectionState": [*_vacant(r)],
        "requiredSignalAspect": [{"refersTo": list(stops), "showsAspect": "closed"}] if stops else [],
        "requiredLevelCrossingState": [
            {"refersTo": m, "inState": x.layout.machines.word(m, at), **after.get(m, {})}
            for m, at in devices
            if m in crossings
        ],
        "additionalRelation": [
            {"refersTo": m, "inState": STATE.get(word := x.layout.machines.word(m, at), word), **after.get(m, {})}
            for m, at in devices
            if m not in crossings
        ]
        + [{"refersTo": name, "inState": state} for name, state in _in_words(r)],
    }


def _vacant(r: RouteRow) -> Iterator[dict[str, object]]:
    """Sections beside or beyond the path and its overlap that are vacant: foul and demanded ones, flank space, the
    line."""
    for c in r.clear.foul:
        when = {"while": f"{c.when[0]} {IN[c.when[1]]}"} if c.when else {}
        yield {"refersTo": c.section, "inState": "vacant", **when}
    others = [*(c.section for c in r.clear.demanded or ()), *(c.name for c in r.clear.space if not c.lamp)]
    for name in dict.fromkeys([*others, *(b.section for b in r.conditions.block)]):
        yield {"refersTo": name, "inState": "vacant"}


def _in_words(r: RouteRow) -> Iterator[tuple[str, str]]:
    """What else a route asks for, and the points that are driven with it."""
    yield from ((str(c.condition), "holds") for c in r.conditions.external)
    yield from ((str(z.zone), "not full") for z in r.conditions.zones)
    yield from ((str(c.name), "stop lamp intact") for c in r.clear.space if c.lamp)
    if r.conditions.token is not None:
        yield str(r.conditions.token.boundary), "direction ours"
    yield from ((str(p.machine), f"driven {IN[p.position]}") for p in r.locking.driven)
