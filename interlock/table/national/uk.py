"""British control tables: routes, and points in two halves.

The columns of the route table are those of the control tables of the IRSE examination as its study forum describes
them (irseexam.signalpost.org, "2009 CTs, to IRSE CT format"): nomenclature, destination, class, points, opposing
locking with its tracks and its time, tracks in the aspect, aspect sequence, approach locking.  NR/L2/SIG/11201 itself
was not read.  A point's entry names the routes that hold it with the tracks of route locking.
"""

from __future__ import annotations

from collections.abc import Callable

from interlock.model.elements import Hand, MachineId, Position, RouteId
from interlock.model.layout import Layout
from interlock.model.portable import beside
from interlock.table.cells import HostileClass, PointDemand, Role, RouteKind, Shows
from interlock.table.national.reading import NOT_CHECKED, ON_PATH, Opposing, Reading
from interlock.table.national.sheet import Field, Heading, Sheet, by_way, filled
from interlock.table.printed import PrintedRoute
from interlock.table.rows import InterlockingTable, RouteRow
from interlock.table.runs import natural

SOURCE = "after the columns of the IRSE examination's control tables, as its study forum describes them"
CLASS = {RouteKind.MAIN: "M", RouteKind.SHUNT: "S", RouteKind.CALL_ON: "C", RouteKind.IDENTIFIER: "part"}


Naming = Callable[[PrintedRoute], str]
"""The British name of a printed route."""


def uk_names(x: Reading) -> Naming:
    """Route names: signal, letter of the way, counted from the left as the driver sees it, and class: 1A(M).

    A main, call-on or shunt route over the same way shares the letter.  Where the layout does not state the hand of
    points, the normal leg counts as the left one.
    """
    ways: dict[str, dict[tuple[object, ...], tuple[object, ...]]] = {}
    for r in x.table.routes:
        ways.setdefault(r.entry, {}).setdefault((r.exit, r.path.traversals), (_turns(x, r), r.path.length, r.number))
    letters = {
        (entry, way): _letter(k)
        for entry, found in ways.items()
        for k, way in enumerate(sorted(found, key=lambda w: found[w]))
    }

    def name(way: PrintedRoute) -> str:
        r = way.rows[0]
        past = "" if r.path.passed is None else f" past {', '.join(r.path.passed)} to {_variant(x.table.parts(r)[-1])}"
        return f"{r.entry}{letters[r.entry, (r.exit, r.path.traversals)]}({CLASS[r.kind]}){past}"

    return name


def _variant(r: RouteRow) -> str:
    """Where a route ends that is part of another, told from those that end there, too."""
    mark = f".{r.path.variant}" if r.path.variant > 1 else ""
    return f"{r.exit}{mark}" + (
        f".o{r.locking.overlap.option}" if r.locking.overlap is not None and r.locking.overlap.option > 1 else ""
    )


def _turns(x: Reading, r: RouteRow) -> tuple[int, ...]:
    return tuple(_turn(x.machines.side(p, position), position) for p, position in x.machines.facing_ends(r))


def _turn(side: Hand | None, position: Position) -> int:
    return int(position is Position.REVERSE if side is None else side is Hand.RIGHT)


def _letter(k: int) -> str:
    return (_letter(k // 26 - 1) if k >= 26 else "") + chr(ord("A") + k % 26)


def _by_normal(x: Reading) -> list[str]:
    """Facing points of unknown hand at which ways part, so that the normal leg was counted as the left one."""
    return sorted(
        {p for r in x.table.routes for p, position in x.machines.choices(r) if x.machines.side(p, position) is None}
    )


def _opposing(x: Reading, name: Naming, r: RouteRow) -> tuple[str, ...]:
    """`118A(M) – CK CN [or CM occ 60 s]`, for each opposing route that the points do not exclude; those with the same
    tracks together."""
    found: dict[str, list[RouteId]] = {}
    for o in x.opposing(r):
        found.setdefault(_tracks(x, o), []).append(o.hostile.route)
    return _held_by(x, name, found)


def _held_by(x: Reading, name: Naming, found: dict[str, list[RouteId]]) -> tuple[str, ...]:
    return tuple(f"{' + '.join(x.named(routes, name))} – {tracks}" for tracks, routes in found.items())


def _tracks(x: Reading, o: Opposing) -> str:
    other = x.table.route[o.hostile.route]
    if o.into is not None:
        stands = "" if o.stands_s is None else f" and {o.into} occ {o.stands_s:g} s"
        return f"until wholly in {o.into}{stands}"
    return beside(o.tracks) + (f" [or {o.end} occ {x.overlap_release_s(other):g} s]" if o.by_overlap else "")


def _normal(x: Reading, name: Naming, r: RouteRow) -> tuple[str, ...]:
    """Routes that must be normal: hostile ones that neither points nor opposing locking exclude, and those that the
    author declares hostile: they stay so for longer (R6)."""
    told = {HostileClass.POINTS, HostileClass.OPPOSING}
    longer = {b.route for b in r.locking.barred}
    return x.named((h.route for h in r.locking.hostile if h.route in longer or not told & set(h.kinds)), name, r)


def _sequence(r: RouteRow) -> str:
    shows, ahead = r.signal.aspect.shows, r.signal.aspect.next
    if shows is Shows.NEXT:
        return f"Y → {ahead} at R; G → {ahead} at Y or G"
    told = {
        Shows.CLEAR: "G",
        Shows.CAUTION: "Y",
        Shows.TWO_YELLOWS: "Y with a second lamp",
        Shows.SHUNT: "PL",
        Shows.CALL_ON: "R with PL",
    }
    return told.get(shows, "identifier")


def _remarks(x: Reading, r: RouteRow) -> tuple[str, ...]:
    said = x.machines.devices_lie(r)
    said += x.machines.derailers_lie(r)
    said += [*r.requirements] + [f"{b.section} clear (line)" for b in r.conditions.block]
    if r.signal.closing.whole is not None:
        said.append(f"replaced by last wheel: {r.signal.closing.whole} clear")
    said += [f"{m} held {r.locking.hold:g} s longer" for m in r.locking.held_longer]
    if r.path.berth is not None:
        said.append(f"{r.path.berth} may be occupied")
    if r.locking.overlap is not None and r.locking.overlap.swings:
        said.append(f"overlap may swing to {', '.join(f'o{k}' for k in r.locking.overlap.swings)}")
    stops = x.stops(r)
    if stops:
        said.append(f"{', '.join(stops)} at stop")
    return tuple(said)


def _approach(r: RouteRow) -> str:
    rear = ", ".join(r.locking.approach.sections)
    return f"when cleared, {rear} occ" if rear else "when cleared"


def _approach_release(r: RouteRow) -> str:
    rear = ", ".join(r.locking.approach.sections)
    return f"{rear} clear, or {r.locking.approach.delay_s:g} s" if rear else f"{r.locking.approach.delay_s:g} s"


def route_table(layout: Layout, table: InterlockingTable) -> Sheet:
    """One line per route, with its overlaps."""
    x = Reading(layout, table)
    name = uk_names(x)
    normal, reverse = Position.NORMAL, Position.REVERSE
    flank = (Role.FLANK, Role.ADDED)
    fields: tuple[Field[RouteRow], ...] = (
        Field(Heading("Route", "进路", "Fahrstraße", "1"), lambda r: name(x.printed.ways[r.id])),
        Field(Heading("Destination", "终端", "Ziel", "2"), lambda r: r.exit),
        Field(Heading("Class", "类别", "Art", "3"), lambda r: CLASS[r.kind]),
        Field(Heading("Points N", "道岔定位", "Weichen +", "4"), lambda r: x.machines.points(r, normal, *ON_PATH)),
        Field(Heading("Points R", "道岔反位", "Weichen −", "5"), lambda r: x.machines.points(r, reverse, *ON_PATH)),
        Field(Heading("Flank N", "防护道岔定位", "Flankenschutz +"), lambda r: x.machines.points(r, normal, *flank)),
        Field(Heading("Flank R", "防护道岔反位", "Flankenschutz −"), lambda r: x.machines.points(r, reverse, *flank)),
        Field(
            Heading("Opposing locking: routes – tracks [or time]", "迎面锁闭", "Gegenfahrten", "6–8"),
            lambda r: _opposing(x, name, r),
        ),
        Field(Heading("Requires normal", "敌对进路", "Feindliche Fahrstraßen"), lambda r: _normal(x, name, r)),
        Field(
            Heading("Tracks clear (route, foul, overlap, flank)", "轨道区段", "Freimeldung"),
            lambda r: tuple(x.sections(r)),
        ),
        Field(
            Heading("Overlap", "保护区段", "Durchrutschweg"),
            lambda r: ", ".join(s for s, _ in r.locking.overlap.ways) if r.locking.overlap is not None else "",
        ),
        Field(
            Heading("Overlap released after", "保护区段解锁", "Auflösung D-Weg"),
            lambda r: (
                f"{r.path.traversals[-1][0]} occ {x.overlap_release_s(r):g} s" if r.locking.overlap is not None else ""
            ),
        ),
        Field(Heading("Aspect sequence", "信号显示", "Signalbegriffe"), _sequence),
        Field(
            Heading("Speed (km/h)", "速度 (km/h)", "Geschwindigkeit (km/h)"),
            lambda r: "" if r.signal.speed.kmh is None else str(r.signal.speed.kmh),
        ),
        Field(Heading("Approach locked", "接近锁闭", "Anrückverschluss"), _approach),
        Field(Heading("Approach locking released", "接近解锁", "Auflösung"), _approach_release),
        Field(Heading("Remarks", "备注", "Bemerkung"), lambda r: _remarks(x, r)),
        Field(Heading("In the other tables", "进路名", "Fahrstraße"), lambda r: x.printed.ways[r.id].id),
    )
    headings, rows = by_way(fields, x.printed.listed)
    title = Heading("Control table: routes", "控制表：进路", "Kontrolltabelle: Fahrstraßen")
    return Sheet("uk_routes", "en", title, headings, rows, True, SOURCE, ROUTES_LEAVE_OUT, legend=_legend(x))


ROUTES_LEAVE_OUT = (
    *("tracks occupied for a time (approach release)", "route indicators", "AWS, TPWS", "stick, TORR"),
    "warning class",
)


def _legend(x: Reading) -> tuple[tuple[str, str], ...]:
    unknown = ", ".join(_by_normal(x))
    by_normal = ("Letters", f"the normal leg counts as the left one, as no hand is stated of {unknown}")
    return (
        ("M, C, S", "main, call-on, shunt"),
        ("1A, 1B", "ways from signal 1, counted from the left as the driver sees them"),
        *((by_normal,) if unknown else ()),
        (
            "X + Z – AB AC",
            "X and Z are normal, or their train has cleared AB and AC, beyond the last of its points",
        ),
        ("[or AB occ 60 s]", "or it has come to a stand: only its overlap is in the way"),
        (
            "X – until wholly in AB and AB occ 60 s",
            "X is normal, or its train wholly in AB and come to a stand; AB need not be clear",
        ),
        ("Not listed", "routes that points in another position exclude"),
        *([NOT_CHECKED] if x.drives else []),
    )


def points_table(layout: Layout, table: InterlockingTable) -> Sheet:
    """One line per set of points: a route that needs a position locks against leaving it."""
    x = Reading(layout, table)
    name = uk_names(x)
    needs = _needs(table)

    def called(m: MachineId, position: Position) -> tuple[str, ...]:
        return x.named((r.id for r, _ in needs.get((m, position), ())), name)

    def locked(m: MachineId, position: Position) -> tuple[str, ...]:
        found: dict[str, list[RouteId]] = {}
        for r, p in needs.get((m, position), ()):
            found.setdefault(_held(x, r, p), []).append(r.id)
        return _held_by(x, name, found)

    normal, reverse = Position.NORMAL, Position.REVERSE
    fields: tuple[Field[MachineId], ...] = (
        Field(Heading("Points", "道岔", "Weiche"), lambda m: m),
        Field(Heading("N to R: called by", "定位到反位：进路", "+ nach −: durch"), lambda m: called(m, reverse)),
        Field(
            Heading("N to R: locked by routes – tracks", "定位到反位：锁闭", "+ nach −: verschlossen"),
            lambda m: locked(m, normal),
        ),
        Field(Heading("R to N: called by", "反位到定位：进路", "− nach +: durch"), lambda m: called(m, normal)),
        Field(
            Heading("R to N: locked by routes – tracks", "反位到定位：锁闭", "− nach +: verschlossen"),
            lambda m: locked(m, reverse),
        ),
        Field(
            Heading("Tracks that lock both ways", "锁闭区段", "verschließende Abschnitte"),
            lambda m: ", ".join(layout.machines.sections[m]),
        ),
    )
    headings, rows = filled(fields, sorted(layout.machines.ends, key=natural))
    title = Heading("Control table: points", "控制表：道岔", "Kontrolltabelle: Weichen")
    return Sheet(
        "uk_points",
        "en",
        title,
        headings,
        rows,
        False,
        SOURCE,
        ("foul tracks with conditions", "time of operation locking", "points–points locking", "self-restoration"),
        legend=(
            (
                "X + Z – AB AC",
                "locked while X or Z is set or approach locked, and until its train has cleared AB and AC",
            ),
            ("[or AB occ 60 s]", "or until it has come to a stand, where only its overlap needs the points"),
        ),
    )


Needs = dict[tuple[MachineId, Position], list[tuple[RouteRow, PointDemand]]]


def _needs(table: InterlockingTable) -> Needs:
    """The routes that need points in a position, each once."""
    out: Needs = {}
    for r in table.routes:
        for p in {(p.machine, p.position): p for p in reversed(r.locking.points)}.values():
            out.setdefault((p.machine, p.position), []).append((r, p))
    return out


def _held(x: Reading, r: RouteRow, p: PointDemand) -> str:
    """The tracks of a route up to the last one that demands the points; over its overlap, also the time."""
    path = list(r.path.section_ids)
    over = [] if r.locking.overlap is None else [s for s, _ in r.locking.overlap.ways]
    asking = {q.section for q in r.locking.points if q.machine == p.machine}
    last = max((i for i, s in enumerate(path) if s in asking), default=-1)
    if asking & set(over) and r.locking.overlap is not None:
        ahead = [*path, *over[: 1 + max(i for i, s in enumerate(over) if s in asking)]]
        after = "" if last >= 0 else f" [or {path[-1]} occ {x.overlap_release_s(r):g} s]"
        return beside(dict.fromkeys(ahead)) + after
    return beside(dict.fromkeys(path[: last + 1] if last >= 0 else path))
