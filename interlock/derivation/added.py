"""What the author adds to a table: hostile routes, points and clear sections (R3, R5, R6), for reasons that no
layout tells.

Everything else is derived as if nothing had been added, so that an addition can only restrict: a route gets further
conditions, and loses none.  Diagnostics IL2019, IL4011, IL4012, IL4019.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from itertools import product

from interlock.derivation.ends import over_which, where_routes_lead
from interlock.derivation.routes import Path
from interlock.diag import Element, Sink
from interlock.model.elements import Choice, Demanded, MachineId, Position, RouteId, SectionId, of_points
from interlock.model.layout import Layout
from interlock.table.cells import DEMANDED, BarredCell, Because, ClearCell, PointDemand, Role, RouteKind, authors_reason

Barred = Mapping[RouteId, tuple[BarredCell, ...]]
Demands = Mapping[RouteId, tuple[PointDemand, ...]]


def chosen(choice: Choice, paths: Sequence[Path]) -> list[Path]:
    """The routes that the author chooses; to a boundary leads, of whatever kind, what ends in the section before it."""
    return [
        p
        for p in paths
        if choice.fits(
            p.entry,
            {p.exit, p.ways[-1].section, p.ways[-1].exit},
            {t.section for t in p.ways},
            p.kind is RouteKind.SHUNT,
            p.kind is RouteKind.CALL_ON,
        )
    ]


def _led(choice: Choice, paths: Sequence[Path]) -> str:
    alike = chosen(replace(choice, via=(), not_via=()), paths)
    if alike and (choice.via or choice.not_via):
        return f": {over_which([t.section for t in p.ways] for p in alike)}"
    return where_routes_lead(choice.entry, choice.exit, ((p.entry, p.exit) for p in paths))


def derive_barred(layout: Layout, paths: Sequence[Path], sink: Sink) -> Barred:
    """For each route those that are declared hostile to it, in order of number."""
    found: dict[RouteId, dict[int, BarredCell]] = {}
    for i, b in enumerate(layout.declared.barred):
        why = Because("R6", f"declared hostile: {b.reason}")
        pairs = [(p, q) for p, q in product(chosen(b.one, paths), chosen(b.other, paths)) if p is not q]
        if not pairs:
            text = f"no two routes are declared hostile ({b.reason})"
            sides = [("one", b.one), ("other", b.other)]
            empty = [f"`{side}`{_led(x, paths)}" for side, x in sides if not chosen(x, paths)]
            fix = "`one` and `other` each choose routes by `from`, `to`, `via` and `kind`: correct " + (
                ", and ".join(empty) or "them, since both choose one and the same route"
            )
            sink.add("IL2019", text, None, fix, about=Element("hostile", i))
        for p, q in pairs:
            found.setdefault(p.id, {}).setdefault(q.number, BarredCell(q.id, why))
            found.setdefault(q.id, {}).setdefault(p.number, BarredCell(p.id, why))
    return {r: tuple(cells[n] for n in sorted(cells)) for r, cells in found.items()}


def with_added(layout: Layout, paths: Sequence[Path], derived: Demands, sink: Sink) -> Demands:
    """The demands of all routes with those that the author adds."""
    found = {r: list(demands) for r, demands in derived.items()}
    _of_air_locks(layout, paths, found)
    for i, d in enumerate(layout.declared.demanded):
        if not isinstance(d, Demanded) or d.air_lock:
            continue
        those, idle = chosen(d.routes, paths), []
        for p in those:
            lies = {x.role: x for x in found[p.id] if x.machine == d.machine}
            added, other = lies.get(Role.ADDED), next((x for x in lies.values() if x.position is not d.position), None)
            if other is not None or (not lies and _against_key(layout, d)):
                _contradicts(layout, d, p, other, i, sink)
            elif added is not None:
                found[p.id][found[p.id].index(added)] = _cell(d, p, added)
                idle += [p] if d.hold <= (added.hold or 0) else []
            elif Role.PATH not in lies:  # flanks, overlaps and devices are let go sooner than what the author adds
                found[p.id].append(_cell(d, p))
            elif d.hold:
                _never_longer(d, p, lies[Role.PATH], i, sink)
            else:
                idle.append(p)
        if not those:
            text = f"no route demands {d.machine} {d.position} ({d.reason})"
            fix = f"`routes` chooses them by `from`, `to`, `via` and `kind`: correct it{_led(d.routes, paths)}"
            sink.add("IL2019", text, None, fix, about=Element("demand", i))
        elif len(idle) == len(those):
            those_ids = ", ".join(p.id for p in idle)
            text = f"the demand of {d.machine} {d.position} adds nothing: it lies so for {those_ids} anyway"
            sink.add("IL4012", text, None, "remove it", about=Element("demand", i))
    _check_air_locks(layout, paths, found, sink)
    return {r: tuple(demands) for r, demands in found.items()}


def _of_air_locks(layout: Layout, paths: Sequence[Path], found: Mapping[RouteId, list[PointDemand]]) -> None:
    """A route over a door of an air lock demands the others shut (R13)."""
    for d in of_points(layout.declared.demanded):
        for p in chosen(d.routes, paths) if d.air_lock else ():
            if d.machine not in {x.machine for x in found[p.id]}:
                found[p.id].append(_cell(d, p))


def _check_air_locks(
    layout: Layout, paths: Sequence[Path], found: Mapping[RouteId, list[PointDemand]], sink: Sink
) -> None:
    """Report routes that need two doors of an air lock open: over both of them, by their overlap or by what the author
    adds, too; or over one while their train waits under another."""
    doors = [d for d in layout.signalling.devices if d.air_lock]
    for p in paths if doors else ():
        rear = {e.section for e in layout.track.edges_at[p.entry_node]} - {p.ways[0].section}
        needs = [x.machine for x in found[p.id] if x.position is Position.REVERSE]
        for lock in sorted({_air_lock(layout, m) for m in needs} - {""}):
            open_ = sorted({m for m in needs if _air_lock(layout, m) == lock})
            under = [d.id for d in doors if d.air_lock == lock and rear & {*d.over} and d.id not in open_]
            only = f"of the doors of air lock {lock} only one may be open"
            about = Element("signals", p.entry)
            if len(open_) > 1:
                fix = "end it at a signal between the doors, shorten its overlap, or exclude it: `exclude:`"
                sink.add("IL4022", f"{p.id} needs {' and '.join(open_)} open: {only}", None, fix, about=about)
            elif under:
                waits = f"its train waits in {', '.join(sorted(rear))} under {under[0]}"
                fix = f"give the part under {under[0]} a section of its own, and let trains wait beyond it"
                sink.add("IL4022", f"{p.id} needs {open_[0]} open while {waits}: {only}", None, fix, about=about)


def _air_lock(layout: Layout, m: MachineId) -> str:
    return layout.machines.device[m].air_lock if m in layout.machines.device else ""


def _cell(d: Demanded, p: Path, before: PointDemand | None = None) -> PointDemand:
    """The demand in a route's row; before: another of the same, of which the reason is told, too.  The longer one
    holds."""
    rule, reasons, hold = "R13" if d.air_lock else "R5", [d.reason], d.hold
    if before is not None:
        first = authors_reason(before.because).removesuffix(_longer(before.hold))
        reasons = [first, *(reasons if d.reason not in first.split("; ") else [])]
        rule, hold = before.because.rule, max(hold, before.hold or 0)
    why = Because(rule, f"{DEMANDED}{'; '.join(reasons)}{_longer(hold)}")
    return PointDemand(d.machine, d.position, Role.ADDED, p.ways[0].section, why, hold or None)


def _longer(hold: float | None) -> str:
    return f"; held {hold:g} s longer" if hold else ""


def demanded_clear(layout: Layout, paths: Sequence[Path], sink: Sink) -> Mapping[RouteId, tuple[ClearCell, ...]]:
    """For each route the sections beside or beyond its path that the author has it find clear, as they are written."""
    found: dict[RouteId, dict[SectionId, ClearCell]] = {}
    for i, d in enumerate(layout.declared.demanded):
        if isinstance(d, Demanded):
            continue
        those, about = chosen(d.routes, paths), Element("demand", i)
        for p in those:
            if why := _never_clear(layout, p, d.section):
                text = f"{d.section} cannot be demanded clear of {p.id}: {why}"
                sink.add("IL4019", text, None, "remove the demand, or choose fewer routes", about=about)
            cell = ClearCell(d.section, Because("R3", f"demanded clear: {d.reason}"))
            found.setdefault(p.id, {}).setdefault(d.section, cell)
        if not those:
            text = f"no route demands {d.section} clear ({d.reason})"
            fix = f"`routes` chooses them by `from`, `to`, `via` and `kind`: correct it{_led(d.routes, paths)}"
            sink.add("IL2019", text, None, fix, about=about)
    return {r: tuple(cells.values()) for r, cells in found.items()}


def _never_clear(layout: Layout, p: Path, s: SectionId) -> str:
    """Why a section cannot be clear while a route is open; empty where it can."""
    if s in layout.track.undetected:
        return "it has no detection"
    if any(t.section == s for t in p.ways):
        return "it lies on the way, where what must be clear is known and its own movement comes to stand"
    rear = {e.section for e in layout.track.edges_at[p.entry_node]}
    return "the movement stands there when its signal opens" if s in rear else ""


def _against_key(layout: Layout, d: Demanded) -> bool:
    return d.machine in layout.machines.by_hand and d.position is Position.REVERSE


def _contradicts(layout: Layout, d: Demanded, p: Path, lies: PointDemand | None, i: int, sink: Sink) -> None:
    says = f"{d.machine} is worked by hand, and locked by its key in normal"
    if lies is not None:
        says = f"{d.machine} lies {lies.position} there: {lies.because.text}"
    text = f"{d.machine} {d.position} cannot be demanded of {p.id}: {says}"
    fix = "remove the demand, choose fewer routes, or exclude the route: `exclude:`"
    sink.add("IL4011", text, None, fix, about=Element("demand", i))


def _never_longer(d: Demanded, p: Path, lies: PointDemand, i: int, sink: Sink) -> None:
    text = f"{d.machine} {d.position} cannot be held {d.hold:g} s longer for {p.id}: it lies so there anyway"
    fix = "remove `hold`, or choose fewer routes: a point of the path goes with its section"
    sink.add(
        "IL4011",
        f"{text}, and is let go with what asks for it: {lies.because.text}",
        None,
        fix,
        about=Element("demand", i),
    )


def idle_barred(layout: Layout, paths: Sequence[Path], hostile: Mapping[RouteId, int], sink: Sink) -> None:
    """Reports declarations of which all routes are hostile anyway; `hostile`: those of each route as derived, as bits
    by number less one."""
    for i, b in enumerate(layout.declared.barred):
        pairs = [(p, q) for p, q in product(chosen(b.one, paths), chosen(b.other, paths)) if p is not q]
        if pairs and all(hostile[p.id] >> (q.number - 1) & 1 for p, q in pairs):
            text = f"the declaration adds nothing ({b.reason}): these routes are hostile anyway"
            sink.add("IL4012", text, None, "remove it", about=Element("hostile", i))
