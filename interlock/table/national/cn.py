"""The Chinese interlocking table (联锁表) in its printed notation.

    1/3  (1/3)      points on the path, normal and reverse (定位, 反位)
    [1/3] [(1/3)]   protecting points (防护道岔): detected and locked
    {1/3} {(1/3)}   driven points (带动道岔): moved along, never checked
    D1  S5  S5L  S5D    hostile signal; of a combined signal both functions, the train or the shunt function; the other
                    function of the route's own signal, too
    <1>D1           hostile only while 1 is normal; the condition spans what follows up to the next condition, and names
                    the end of a double-acting machine (1/3) at which the hostile signal's routes part
    <25>25DG        the foul section (侵限) is checked only while 25, the end that lies in it, is normal
    17/9            a through route (通过): received on route 17, departing on route 9, with all of their conditions
    X2BA            the button that chooses the second alternative (变更), where no signal on its way tells it

Input: layout and table.  Everything comes from topology, geometry and the table's cells.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Container, Iterator
from dataclasses import replace
from functools import cached_property

from interlock.dataclass import dataclass
from interlock.model.elements import (
    BlockKind,
    MachineId,
    NodeId,
    PointId,
    Position,
    RouteId,
    SectionId,
    SignalId,
    SignalKind,
)
from interlock.model.layout import Layout
from interlock.model.traversal import Traversal
from interlock.table.cells import ExitKind, HostileClass, OverlapCell, Role, RouteKind, Shows
from interlock.table.national.cn_notation import DEVICE, HEADINGS, LEGEND, NOT_PRINTED, OVERLAP, lying, order
from interlock.table.national.reading import Reading
from interlock.table.national.sheet import Cell, Heading, Sheet, route_rows
from interlock.table.printed import Printed, PrintedRoute
from interlock.table.rows import InterlockingTable, RouteRow

Need = tuple[MachineId, Position]


def chinese_table(layout: Layout, table: InterlockingTable) -> Sheet:
    """Train routes first, then through routes, which bear no number of their own, then shunt routes; a signal's routes
    together; of shunt routes only the basic ones, and no call-on routes, of which the legend tells."""
    form = _Form(layout, table)
    number = {w.id: str(k) for k, w in enumerate(form.printed, start=1)}
    rows = route_rows(form.printed, lambda w, r: form.row(r, number[w.id]), separator="、")
    trains = sum(w.rows[0].kind is RouteKind.MAIN for w in form.printed)
    return Sheet(
        "cn",
        "zh",
        Heading("Interlocking table (China)", "联锁表", "Verschlusstabelle (China)"),
        HEADINGS,
        (*rows[:trains], *form.through(number), *rows[trains:]),
        True,
        "after the printed form of Chinese textbooks (联锁表, fifteen columns); no standard was read",
        legend=(*LEGEND, *form.notes()),
    )


@dataclass(frozen=True)
class _Form:
    """What the columns are computed from."""

    layout: Layout
    table: InterlockingTable

    @cached_property
    def _reading(self) -> Reading:
        """What all forms read."""
        return Reading(self.layout, self.table)

    @cached_property
    def printed(self) -> tuple[PrintedRoute, ...]:
        """The routes in print, in order."""
        shown = [w for w in Printed(self.table).listed if self._is_shown(w.rows[0])]
        return tuple(sorted(shown, key=lambda w: self._place(w.rows[0])))

    def notes(self) -> Iterator[tuple[str, str]]:
        """What stands in no column of its own, and the routes that have no row."""
        if any(r.locking.overlap is not None for r in self.table.routes):
            yield OVERLAP
        left = Counter(w.rows[0].kind for w in Printed(self.table).listed if not self._is_shown(w.rows[0]))
        for kind, (sign, text) in NOT_PRINTED.items():
            if left[kind]:
                yield sign, text.format(left[kind])

    def _is_shown(self, r: RouteRow) -> bool:
        return r.kind is RouteKind.MAIN or (r.kind is RouteKind.SHUNT and r.path.variant == 1)

    @cached_property
    def _tracks(self) -> frozenset[SectionId]:
        """Station tracks (股道): where train routes end, or begin inside the station."""
        ends = {
            r.path.traversals[-1][0]
            for r in self.table.routes
            if r.kind is RouteKind.MAIN and self._receiving(r) and self._is_plain(r.path.traversals[-1][0])
        }
        starts = {self._behind(r) for r in self.table.routes if r.kind is RouteKind.MAIN}
        return frozenset(ends | {s for s in starts if s is not None and self._is_plain(s)})

    @cached_property
    def _of_signal(self) -> dict[tuple[SignalId, RouteKind], list[RouteRow]]:
        """Every route of a signal's function."""
        out: dict[tuple[SignalId, RouteKind], list[RouteRow]] = {}
        for r in self.table.routes:
            out.setdefault((r.entry, r.kind), []).append(r)
        return out

    # --- small questions -----------------------------------------------------------------------

    def _is_plain(self, s: SectionId) -> bool:
        return not any(t.points or t.crossings for t in self._reading.topo.traversals[s])

    def _behind(self, r: RouteRow) -> SectionId | None:
        """The section in rear of the route's signal, inside the layout."""
        return self._reading.topo.beyond(r.path.traversals[0][0], r.path.entry_node)

    def _receiving(self, r: RouteRow) -> bool:
        return r.path.entry_node in self.layout.track.boundary_at

    def _departing(self, r: RouteRow) -> bool:
        return r.path.exit_kind is ExitKind.BOUNDARY and not self._receiving(r)

    def _opposing(self, s: SectionId, node: NodeId) -> SignalId | None:
        """The signal that governs leaving a section at the end over which the route came in."""
        rear = self._reading.topo.beyond(s, node)
        return None if rear is None else self._reading.topo.signal_into.get((node, rear))

    def _path(self, r: RouteRow) -> dict[MachineId, Position]:
        return {p.machine: p.position for p in r.locking.points if p.role is Role.PATH}

    def _whole_path(self, r: RouteRow) -> dict[MachineId, Position]:
        """The points of its path, and past the signals that it passes."""
        return {m: x for p in self.table.parts(r) for m, x in self._path(p).items()}

    @cached_property
    def _held(self) -> dict[RouteId, dict[MachineId, Position]]:
        """All points that each route locks, past the signals that it passes, too."""
        parts = self.table.parts
        return {r.id: {q.machine: q.position for p in parts(r) for q in p.locking.points} for r in self.table.routes}

    @cached_property
    def _ways(self) -> dict[RouteId, dict[SectionId, Traversal]]:
        """The sections of each route, past the signals that it passes, too, with its way through them."""
        parts = self.table.parts
        return {
            r.id: {k[0]: self._reading.way(k) for p in parts(r) for k in p.path.traversals} for r in self.table.routes
        }

    # --- order ---------------------------------------------------------------------------------

    def _place(self, r: RouteRow) -> tuple[object, ...]:
        if r.kind is RouteKind.MAIN:
            line = self._direction(r)
            track = self._track_name(self._end(r)) if self._receiving(r) else self._target(r)[1:].removesuffix("股道")
            return (0, line[:-2], not self._receiving(r), order(r.entry), order(track), r.path.variant)
        return (1, "", False, order(r.entry), order(self._target(r)[1:].removesuffix("股道")), r.path.variant)

    def _last(self, r: RouteRow) -> RouteRow:
        """What lies at its destination, where it leads past signals, as a train route."""
        return r if r.path.onward is None else replace(self.table.parts(r)[-1], kind=RouteKind.MAIN)

    def _end(self, r: RouteRow) -> SectionId:
        return r.path.traversals[-1][0]

    # --- columns -------------------------------------------------------------------------------

    def row(self, r: RouteRow, number: str) -> tuple[Cell, ...]:
        """The fifteen cells."""
        if r.path.onward is not None:
            return self._past(r, number)
        facing = self._facing(r)
        return (
            self._direction(r),
            self._target(r),
            self._alternative(r),
            "、".join(self._buttons(r)),
            self._deciding(r),
            r.entry,
            self._aspect(r),
            self._indicator(r),
            tuple(self._points(r)),
            tuple(self._hostile(r)),
            tuple(self._sections(r)),
            facing[0],
            facing[1],
            "、".join(self._other(r)),
            number,
        )

    def _past(self, r: RouteRow, number: str) -> tuple[Cell, ...]:
        """A route that leads past signals: with the points and sections beyond them, in one row."""
        parts, last, passed = self.table.parts(r), self._last(r), "、".join(r.path.passed or ())
        facing, told = self._facing(last), [*(x for p in parts for x in self._other(p)), f"越过{passed}（标志灯）"]
        return (
            self._direction(r),
            f"越过{passed}至{r.path.destination}",
            self._alternative(r),
            "、".join((*self._buttons(r), self._buttons(last)[-1])),
            self._deciding(r),
            r.entry,
            self._aspect(r),
            self._indicator(last),
            tuple(dict.fromkeys(x for p in parts for x in self._points(p))),
            tuple(self._hostile(r)),
            tuple(dict.fromkeys(x for p in parts for x in self._sections(p))),
            facing[0],
            facing[1],
            "、".join(dict.fromkeys(told)),
            number,
        )

    def through(self, number: dict[str, str]) -> list[tuple[str, ...]]:
        """Through routes on main tracks: received and departing over points that all lie normal."""
        straight = [(w.rows[0], number[w.id]) for w in self.printed if self._straight(w.rows[0])]
        out = []
        for r, received in straight:
            for d, departs in straight:
                if (
                    self._receiving(r)
                    and r.path.exit_kind is ExitKind.SIGNAL
                    and r.exit == d.entry
                    and self._departing(d)
                ):
                    out.append(self._through(r, d, received, departs))
        return out

    def _straight(self, r: RouteRow) -> bool:
        plain = r.kind is RouteKind.MAIN and r.path.variant == 1 and r.path.onward is None
        return plain and Position.REVERSE not in self._path(r).values()

    def _through(self, r: RouteRow, d: RouteRow, received: str, departs: str) -> tuple[str, ...]:
        there, on = self._direction(r).removesuffix("接车"), self._direction(d).removesuffix("发车")
        cells = {
            "方向": f"{there}至{on}通过",
            "进路": f"经{self._track_name(self._end(r))}股道",
            "排列进路按下的按钮": f"{r.entry}TA、{self._end_of_train(d)}",
            "信号机名称": f"{r.entry}、{d.entry}",
            "信号机显示": f"L、{self._aspect(d)}",
            "表示器": self._indicator(d),
            "其他联锁": f"进路 {received}、{departs} 的全部条件",
            "进路号码": f"{received}/{departs}",
        }
        return tuple(cells.get(h.zh, "") for h in HEADINGS)

    def _direction(self, r: RouteRow) -> str:
        """The line to or from which a train goes, and whether it is received (接车) or departs (发车)."""
        if r.kind is RouteKind.SHUNT:
            return "调车"
        node = r.path.entry_node if self._receiving(r) else self._reading.way(r.path.traversals[-1]).exit
        name = self.layout.printed.labels.get(node, node).split(" (")[0]
        if self._receiving(r) and r.path.exit_kind is ExitKind.BOUNDARY and self._end(r) not in self._tracks:
            return f"{name}通过"
        return f"{name}{'接车' if self._receiving(r) else '发车'}"

    def _track_name(self, s: SectionId) -> str:
        """5G is track 5 (5股道)."""
        return s[:-1] if s.endswith("G") and len(s) > 1 else s

    def _target(self, r: RouteRow) -> str:
        if self._departing(r):
            start = self._behind(r)
            return f"由{self._track_name(start)}股道" if start is not None else f"由{r.entry}"
        if r.kind is RouteKind.MAIN:
            return f"至{self._track_name(self._end(r))}股道"
        if r.path.exit_kind is ExitKind.SIGNAL and self._end(r) not in self._tracks:
            return f"至{r.exit}"
        facing = self._opposing(self._end(r), self._reading.way(r.path.traversals[-1]).entry)
        if self._end(r) in self._tracks or facing is None:
            return f"至{self._track_name(self._end(r))}股道"
        return f"向{facing}"

    def _alternatives(self, r: RouteRow) -> list[RouteRow]:
        """All routes with the same ends, the basic one first."""
        same = {
            x.path.variant: x
            for x in reversed(self._of_signal[r.entry, r.kind])
            if (x.exit, x.path.passed, x.path.destination) == (r.exit, r.path.passed, r.path.destination)
        }
        return [same[k] for k in sorted(same)]

    def _alternative(self, r: RouteRow) -> str:
        return str(r.path.variant) if r.kind is RouteKind.MAIN and len(self._alternatives(r)) > 1 else ""

    def _deciding(self, r: RouteRow) -> str:
        """The points that tell the route from the others with the same ends, first come first."""
        others = [x for x in self._alternatives(r) if x.path.variant != r.path.variant]
        if r.kind is RouteKind.SHUNT:
            return ""
        out = []
        for m, x in self._path(r).items():
            if any(self._path(o).get(m, x) is not x for o in others):
                out.append(lying(m, x))
                others = [o for o in others if self._path(o).get(m, x) is x]
        return "、".join(out)

    def _buttons(self, r: RouteRow) -> list[str]:
        """Start, what tells an alternative from the routes before it, and end."""
        if r.kind is RouteKind.MAIN:
            out = [f"{r.entry}LA", *self._between(r)]
            return [*out, self._end_of_train(r)]
        last = self._reading.way(r.path.traversals[-1])
        if r.path.berth is not None:
            end = self._opposing(last.section, last.entry)
        else:
            back = self._opposing_at_exit(last)
            end = back or (SignalId(r.exit) if r.path.exit_kind is ExitKind.SIGNAL else None)
        return [self._shunt_button(r.entry), self._shunt_button(end) if end is not None else f"{r.exit}A"]

    def _opposing_at_exit(self, last: Traversal) -> SignalId | None:
        """The signal back to back with the one at which the route ends."""
        return self._reading.topo.signal_into.get((last.exit, last.section))

    def _shunt_button(self, g: SignalId) -> str:
        return f"{g}DA" if self.layout.signalling.signal[g].kind is SignalKind.COMBINED else f"{g}A"

    def _end_of_train(self, r: RouteRow) -> str:
        last = self._reading.way(r.path.traversals[-1])
        if self._departing(r):
            boundary = self.layout.track.boundary_at[last.exit]
            back = self._reading.topo.signal_into.get((last.exit, last.section))
            return boundary.button or (f"{back}LA" if back is not None else f"{last.exit}LA")
        facing = self._opposing(last.section, last.entry)
        if facing is None:
            return f"{r.exit}LA"
        return f"{facing}LA" if self.layout.signalling.signal[facing].main else self._shunt_button(facing)

    def _between(self, r: RouteRow) -> list[str]:
        """For an alternative, a signal along it that no route of a lower number passes, or else a button of its own."""
        if r.path.variant == 1:
            return []
        passed = [self._along(x) for x in self._alternatives(r)[: r.path.variant - 1]]
        for g in self._along(r):
            if all(g not in others for others in passed):
                return [self._shunt_button(g)]
        return [f"{r.entry}{r.path.variant - 1}BA"]

    def _along(self, r: RouteRow) -> list[SignalId]:
        """Shunt signals at the joints within the route, in order."""
        out: list[SignalId] = []
        for a, b in zip(r.path.traversals, r.path.traversals[1:], strict=False):
            node = self._reading.way(a).exit
            for key in ((node, b[0]), (node, a[0])):
                g = self._reading.topo.shunt_into.get(key)
                if g is not None and not self.layout.signalling.signal[g].main:
                    out.append(g)
        return out

    def _aspect(self, r: RouteRow) -> str:
        """Shunt white; received UU over a reversed point, where the signal has a second yellow lamp, else U; departing
        as the block permits."""
        if r.kind is RouteKind.SHUNT:
            return "B"
        if self._departing(r):
            block = self.layout.track.boundary_at[self._reading.way(r.path.traversals[-1]).exit].block
            return "L、U、LU" if block is BlockKind.AUTOMATIC else "L"
        return "UU" if r.signal.aspect.shows is Shows.TWO_YELLOWS else "U"

    def _indicator(self, r: RouteRow) -> str:
        """A route indicator tells a branching direction of departure."""
        return "B" if r.signal.aspect.indicator else ""

    def _points(self, r: RouteRow) -> list[str]:
        """Points in the order of the path; protecting and driven ones with the section that asks for them."""
        on_path, flank = self._path(r), [p for p in r.locking.points if p.role in (Role.FLANK, Role.ADDED)]
        out: dict[MachineId, str] = {}
        for key in r.path.traversals:
            for q, _ in self._reading.way(key).points:
                m = self.layout.pointwork.point[q].machine
                out.setdefault(m, lying(m, on_path[m]))
            for p in flank:
                if p.section == key[0] and p.machine not in self.layout.machines.device:
                    out.setdefault(p.machine, f"[{lying(p.machine, p.position)}]")
            for p in r.locking.driven:
                if p.section == key[0]:
                    out.setdefault(p.machine, f"{{{lying(p.machine, p.position)}}}")
        return list(out.values())

    def _sections(self, r: RouteRow) -> list[str]:
        """Sections to be clear, each foul section behind the one that it fouls; those that foul the overlap stand
        with it."""
        out: list[str] = []
        for cell in r.clear.sections:
            out += [cell.section, *self._foul(r, {cell.section})]
        if r.locking.overlap is None:
            out += self._foul_beyond(r)
        out += [c.name for c in r.clear.space if not c.lamp]
        out += [c.section for c in r.clear.demanded or ()]
        return list(dict.fromkeys(out))

    def _foul_beyond(self, r: RouteRow) -> list[str]:
        """What fouls no section that the path has clear: the overlap."""
        return list(dict.fromkeys(self._foul(r, {f.of for f in r.clear.foul} - r.clear.section_ids)))

    def _foul(self, r: RouteRow, of: Container[SectionId]) -> Iterator[str]:
        """The foul sections of some sections: without condition where the route holds the points so that they foul,
        none where it holds them otherwise; driven points are never checked, and settle nothing."""
        held = self._held[r.id]
        for f in (f for f in r.clear.foul if f.of in of):
            if f.when is None or held.get(f.when[0]) is f.when[1]:
                yield f.section
            elif f.when[0] not in held:
                yield f"<{lying(self._end_in(f.section, f.when[0]), f.when[1])}>{f.section}"

    def _facing(self, r: RouteRow) -> tuple[str, str]:
        """What routes from the other end of the track exclude: train routes, shunt routes."""
        track = self._end(r)
        if track not in self._tracks or self._departing(r):
            return "", ""
        exits = self._opposing(track, self._reading.way(r.path.traversals[-1]).entry)
        trains = track if exits is not None and self.layout.signalling.signal[exits].main else ""
        shunts = r.kind is RouteKind.MAIN or any(self._meet(r, t) for t in self._into[track] if t.kind is r.kind)
        return trains, track if shunts else ""

    @cached_property
    def _into(self) -> dict[SectionId, list[RouteRow]]:
        """The routes that end in each section."""
        out: dict[SectionId, list[RouteRow]] = {}
        for t in self.table.routes:
            out.setdefault(self._end(t), []).append(t)
        return out

    def _meet(self, r: RouteRow, t: RouteRow) -> bool:
        """Both end in one track, into which they come at its two ends, and share nothing else."""
        mine, theirs = (self._reading.way(self._last(x).path.traversals[-1]) for x in (r, t))
        shared = self._ways[r.id].keys() & self._ways[t.id].keys()
        return mine.section == theirs.section and mine.entry != theirs.entry and shared <= {mine.section}

    def _told_as_facing(self, r: RouteRow, t: RouteRow) -> bool:
        """The columns of facing routes tell that the two are hostile."""
        return bool(self._facing(self._last(r))[t.kind is not RouteKind.MAIN]) and self._meet(r, t)

    def _other(self, r: RouteRow) -> list[str]:
        """The block of the line on which a train departs (BS: 闭塞), or what of it must be clear, level crossings and
        other devices, the overlap, which has no column, and what stays locked longer."""
        block = (
            self.layout.track.boundary_at[self._reading.way(r.path.traversals[-1]).exit].block
            if self._departing(r)
            else BlockKind.NONE
        )
        parts = ["BS"] if block is BlockKind.SEMI_AUTOMATIC else [f"{b.section} 空闲" for b in r.conditions.block]
        devices = self._reading.machines.devices(r).items()
        parts += [f"{m} {DEVICE[self.layout.machines.word(m, x)]}" for m, x in devices]
        overlap = [self._overlap(r, r.locking.overlap)] if r.locking.overlap is not None else []
        parts += [*(c for c in r.requirements if not self._is_block(c)), *overlap]
        return parts + [f"{m} 延时 {r.locking.hold:g} s 解锁" for m in r.locking.held_longer]

    def _overlap(self, r: RouteRow, over: OverlapCell) -> str:
        """An overlap's sections, what fouls them, its points, those that protect it, and the speed for which it is
        made."""
        inside = {s for s, _ in over.ways}
        own = [
            lying(p.machine, p.position)
            for p in r.locking.points
            if p.role is Role.OVERLAP and p.machine not in self.layout.machines.device
        ]
        own += [
            f"[{lying(p.machine, p.position)}]"
            for p in r.locking.points
            if p.role is Role.FLANK and p.section in inside
        ]
        kmh = self._reading.entry_kmh(r)
        said = [f"保护区段 {'、'.join(dict.fromkeys(s for s, _ in over.ways))}"]
        said += [f"侵限 {'、'.join(foul)}" for foul in [self._foul_beyond(r)] if foul]
        said += [f"道岔 {'、'.join(dict.fromkeys(own))}"] * bool(own) + [f"限速 {kmh} km/h"] * bool(kmh)
        return "，".join(said)

    def _is_block(self, condition: str) -> bool:
        """Whether a condition is the block beyond a boundary, which is printed as BS or not at all."""
        return any(c.id == condition and c.exits for c in self.layout.signalling.conditions)

    # --- hostile signals -----------------------------------------------------------------------

    def _hostile(self, r: RouteRow) -> list[str]:
        """Hostile signals; first those without condition, then each condition with its signals."""
        found: dict[str, list[tuple[SignalId, str]]] = {}
        told = self._told(r)
        for g in sorted(self.layout.signalling.signals, key=lambda s: order(s.id)):
            functions: dict[str, list[str]] = {}
            for kind, mark in ((RouteKind.MAIN, "L"), (RouteKind.SHUNT, "D")):
                if g.id != r.entry or kind is not r.kind:
                    functions[mark] = self._when_hostile(r, self._of_signal.get((g.id, kind), []), told)
            alike = g.kind is SignalKind.COMBINED and functions.get("L") == functions.get("D")
            for mark, conditions in [("", functions["L"])] if alike else functions.items():
                for condition in conditions:
                    found.setdefault(condition, []).append((g.id, mark if g.kind is SignalKind.COMBINED else ""))
        out: list[str] = []
        for condition in sorted(found, key=lambda c: (c != "", c.strip("<>()"))):
            names = [f"{g}{mark}" for g, mark in found[condition]]
            out += [condition + names[0], *names[1:]]
        return out

    def _told(self, r: RouteRow) -> frozenset[RouteId]:
        """The hostile routes of which the column tells: all but those that points exclude, that the columns of facing
        routes tell, or that are hostile by an overlap alone."""
        mine = self._ways[r.id].keys()
        asked = [t for h in r.locking.hostile.routes if self._agree(r, t := self.table.route[h])]
        asked = [t for t in asked if not self._told_as_facing(r, t)]
        sharing = {t.id for t in asked if mine & self._ways[t.id].keys()}
        beside = {t.id for t in asked} - sharing
        why = {h.route: set(h.kinds) for h in r.locking.hostile} if beside else {}  # told of all, for a few
        return frozenset(sharing | {h for h in beside if why[h] != {HostileClass.OVERLAP}})

    def _when_hostile(self, r: RouteRow, function: list[RouteRow], told: frozenset[RouteId]) -> list[str]:
        """The conditions under which a signal's function is hostile, each of them enough: "" always, none never.

        They tell the signal's hostile routes from its other routes that the points of this one permit.
        """
        routes = [t for t in function if self._agree(r, t)]
        bad = [t for t in routes if t.id in told]
        good = [t for t in routes if t not in bad]
        if not bad or not good:
            return [""] if bad else []
        found = [self._parted(r, bad, good)]
        if found == [""]:  # no positions are common to them alone
            found = [self._parted(r, [t], good) for t in bad]
        return [""] if "" in found else [*dict.fromkeys(found)]

    def _parted(self, r: RouteRow, bad: list[RouteRow], good: list[RouteRow]) -> str:
        """Positions that all of some routes need, and none of others needs all of; empty where there are none."""
        own = self._whole_path(r)
        first = list(self._whole_path(bad[0]).items())
        common = [need for need in first if all(need in self._whole_path(t).items() for t in bad)]
        ranked = sorted(common, key=lambda need: (need[0] not in own, first.index(need)))
        chosen: list[Need] = []
        for need in ranked:
            if not any(need in self._whole_path(t).items() for t in good):
                return f"<{self._named(need, bad[0])}>"
        for need in ranked:
            if any(need not in self._whole_path(t).items() for t in good):
                chosen.append(need)
                good = [t for t in good if need in self._whole_path(t).items()]
            if not good:
                return "<" + "、".join(self._named(n, bad[0]) for n in chosen) + ">"
        return ""

    def _named(self, need: Need, t: RouteRow) -> str:
        """A condition by the end of the machine at which a route parts from others, else the first that it passes."""
        machine, position = need
        passed = [p for key in t.path.traversals for p, _ in self._reading.way(key).points]
        ends = [*(p for p, _ in self._reading.machines.facing_ends(t)), *passed]
        return lying(next((p for p in ends if self.layout.pointwork.point[p].machine == machine), machine), position)

    def _end_in(self, section: SectionId, machine: MachineId) -> PointId | MachineId:
        """The end of a machine that lies in a section; the machine, where none does."""
        return next((p.id for p in self.layout.machines.points_in.get(section, ()) if p.machine == machine), machine)

    def _agree(self, r: RouteRow, t: RouteRow) -> bool:
        """Both can have their points, which keep no longer apart what the author declares hostile."""
        needs, barred = self._held[r.id], {b.route for b in r.locking.barred}
        return t.id in barred or all(needs.get(m, x) is x for m, x in self._held[t.id].items())
