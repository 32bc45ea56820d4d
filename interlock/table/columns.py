"""The columns of the printed table, in order: one `Column` drives every export and `interlock why`."""

from __future__ import annotations

from collections.abc import Callable

from interlock.dataclass import dataclass
from interlock.model.elements import RouteId
from interlock.table.cells import Because, FoulCell, Hostile, HostileClass, PointDemand, Role
from interlock.table.printed import Part, PrintedRoute, grouped, joined, parts
from interlock.table.rows import RouteRow, VoyageRow, leads_to
from interlock.table.runs import in_runs

Reasons = list[tuple[str, Because]]


@dataclass(frozen=True)
class Column:
    """Key, headings in English, Chinese and German, the cell's text and the reason of each of its items.

    in_print: the items of a route's cell where all overlaps of its way share a row, if they are not these.  apart: the
    items are one thing, and are never told in two parts.  cell: the text of the printed cell, if it is not its items.
    """

    key: str
    en: str
    zh: str
    de: str
    items: Callable[[RouteRow], Reasons]
    in_print: Callable[[PrintedRoute, RouteRow], Reasons] | None = None
    apart: bool = False
    cell: Callable[[PrintedRoute], str] | None = None

    def text(self, row: RouteRow) -> str:
        """The cell of one route by itself."""
        return ", ".join(t for t, _ in self.items(row))

    def parts(self, way: PrintedRoute) -> tuple[Part[tuple[str, Because]], ...]:
        """The printed cell: what holds with every overlap, and what holds with one."""
        cells = [(r, self.items(r) if self.in_print is None else self.in_print(way, r)) for r in way.rows]
        return parts(cells, lambda item: item[0], self.apart)

    def printed(self, way: PrintedRoute) -> str:
        """The text of the printed cell."""
        if self.cell is not None:
            return self.cell(way)
        return joined([Part(p.row, tuple(t for t, _ in p.items)) for p in self.parts(way)], way.mark)


def _points(*roles: Role) -> Callable[[RouteRow], Reasons]:
    def items(r: RouteRow) -> Reasons:
        return [(_demand(p), p.because) for p in r.locking.points if p.role in roles]

    return items


def _demand(p: PointDemand) -> str:
    why = f" ({p.because.text})" if p.role is Role.ADDED else ""
    return f"{p.machine} {p.position}{why}"


def _why_hostile(h: Hostile) -> str:
    return h.witness if h.kind is HostileClass.ADDED else str(h.kind)


def _hostile(r: RouteRow) -> Reasons:
    return [(f"{h.route} ({_why_hostile(h)})", h.because) for h in r.locking.hostile]


def _said_hostile(way: PrintedRoute, r: RouteRow) -> list[tuple[str, str, RouteId]]:
    """Why, which printed route, and one of its routes."""
    out = []
    for x in grouped([(h.route, _why_hostile(h)) for h in r.locking.hostile], way.ways, r):
        name = f"{way.id} with another overlap" if x.whole and x.way is way else x.name()
        out.append((x.what, name, x.route))
    return out


def _hostile_ways(way: PrintedRoute, r: RouteRow) -> Reasons:
    why = {h.route: h.because for h in r.locking.hostile}
    return [(f"{name} ({what})", why[route]) for what, name, route in _said_hostile(way, r)]


def _hostile_cell(way: PrintedRoute) -> str:
    """Each reason once, with all routes that are hostile for it: `same entry: A-B + A-C, opposing: D-E`."""
    said = [(r, [(what, name) for what, name, _ in _said_hostile(way, r)]) for r in way.rows]
    cell = []
    for p in parts(said):
        by: dict[str, list[str]] = {}
        for what, name in p.items:
            by.setdefault(what, []).append(name)
        cell.append(Part(p.row, tuple(f"{what}: {' + '.join(in_runs(names))}" for what, names in by.items())))
    return joined(cell, way.mark)


def _names(r: RouteRow) -> Reasons:
    return [(n, Because("R1", "named in the layout")) for n in r.names]


def _clear(r: RouteRow) -> Reasons:
    added = [(f"{c.section} ({c.because.text})", c.because) for c in r.clear.demanded or ()]
    return [*((c.section, c.because) for c in r.clear.sections), *added]


def _foul(c: FoulCell) -> str:
    return c.section if c.when is None else f"{c.section} if {c.when[0]} {c.when[1]}"


def _approach(r: RouteRow) -> Reasons:
    where = ", ".join(r.locking.approach.sections) or "always"
    return [(f"{where} ({r.locking.approach.delay_s:g} s)", r.locking.approach.because)]


def _flank(r: RouteRow) -> Reasons:
    out = []
    for c in r.locking.flank:
        providers = " + ".join(in_runs([*map(str, c.providers)])) or "closed ring"
        out.append((f"{c.requester}: {providers}", c.because))
    return out


def _space(r: RouteRow) -> Reasons:
    return [(f"stop lamp of {c.name}" if c.lamp else c.name, c.because) for c in r.clear.space]


def _overlap(r: RouteRow) -> Reasons:
    return [] if r.locking.overlap is None else [(s, r.locking.overlap.because) for s, _ in r.locking.overlap.ways]


def _aspect(r: RouteRow) -> Reasons:
    cell = r.signal.aspect
    text = f"clear if {cell.next} is open, else caution" if cell.next is not None else str(cell.shows)
    return [(f"{text}, with the route indicator" if cell.indicator else text, cell.because)]


def _closing(r: RouteRow) -> Reasons:
    whole = r.signal.closing.whole
    return [("first axle" if whole is None else f"{whole} clear", r.signal.closing.because)]


COLUMNS: tuple[Column, ...] = (
    Column("number", "No.", "进路号码", "Nr.", lambda r: [(str(r.number), r.because)]),
    Column(
        "route",
        "Route",
        "进路",
        "Fahrstraße",
        lambda r: [(r.id, r.because)],
        lambda w, _: [(w.id, w.rows[0].because)],
    ),
    Column("kind", "Kind", "进路性质", "Art", lambda r: [(r.kind, r.because)]),
    Column("names", "Name", "名称", "Name", _names, lambda w, _: [n for r in w.rows for n in _names(r)]),
    Column("entry", "Entry signal", "始端信号机", "Start", lambda r: [(r.entry, r.because)]),
    Column("exit", "Exit", "终端", "Ziel", lambda r: [(leads_to(r), r.because)]),
    Column(
        "variant",
        "Alternative",
        "进路方式",
        "Variante",
        lambda r: [
            (
                str(r.path.variant),
                Because(
                    "R1",
                    "1 is basic: excludes fewest receiving routes of other signals, then departing, other train and "
                    "shunt routes; then shortest, then fewest points",
                ),
            )
        ],
    ),
    Column("length", "Length (m)", "长度 (m)", "Länge (m)", lambda r: [(f"{r.path.length:g}", r.because)]),
    Column("points", "Points", "道岔", "Weichen", _points(Role.PATH)),
    Column("flank_points", "Flank points", "防护道岔", "Flankenschutzweichen", _points(Role.FLANK, Role.ADDED)),
    Column(
        "devices",
        "Secured for trains",
        "道口及外部联锁",
        "Bahnübergänge und Riegel",
        lambda r: [(p.machine, p.because) for p in r.locking.points if p.role is Role.DEVICE],
    ),
    Column("overlap", "Overlap", "保护区段", "Durchrutschweg", _overlap, apart=True),
    Column("overlap_points", "Overlap points", "保护区段道岔", "Weichen im D-Weg", _points(Role.OVERLAP), apart=True),
    Column(
        "swings",
        "Overlap may swing to",
        "保护区段可转换",
        "D-Weg umstellbar auf",
        lambda r: (
            []
            if r.locking.overlap is None
            else [(f".o{k}", r.locking.overlap.because) for k in r.locking.overlap.swings]
        ),
    ),
    Column(
        "driven_points",
        "Driven points",
        "带动道岔",
        "Mitgeführte Weichen",
        lambda r: [(_demand(p), p.because) for p in r.locking.driven],
    ),
    Column(
        "sections",
        "Sections clear",
        "轨道区段",
        "Freimeldeabschnitte",
        _clear,
    ),
    Column(
        "foul",
        "Foul sections clear",
        "侵限区段",
        "Grenzzeichenfreiheit",
        lambda r: [
            (c.section if c.when is None else f"{c.section} if {c.when[0]} {c.when[1]}", c.because)
            for c in r.clear.foul
        ],
    ),
    Column("flank", "Flank protection", "侧面防护", "Flankenschutz", _flank),
    Column("space", "Flank space", "侧面防护区段", "Flankenschutzraum", _space),
    Column(
        "hostile",
        "Hostile routes",
        "敌对进路",
        "Feindliche Fahrstraßen",
        _hostile,
        _hostile_ways,
        cell=_hostile_cell,
    ),
    Column(
        "conditions",
        "External conditions",
        "其他联锁",
        "Bedingungen",
        lambda r: [(c.condition, c.because) for c in r.conditions.external],
    ),
    Column(
        "zones",
        "Zone not full",
        "区域列车数限制",
        "Zone nicht voll",
        lambda r: [(z.zone, z.because) for z in r.conditions.zones],
    ),
    Column("aspect", "Aspect", "信号机显示", "Signalbegriff", _aspect),
    Column(
        "speed",
        "Speed (km/h)",
        "允许速度 (km/h)",
        "Geschwindigkeit (km/h)",
        lambda r: [] if r.signal.speed.kmh is None else [(str(r.signal.speed.kmh), r.signal.speed.because)],
    ),
    Column("closing", "Signal closes", "信号关闭", "Signal fällt auf Halt", _closing),
    Column(
        "block",
        "Line beyond clear",
        "闭塞条件",
        "Streckenblock",
        lambda r: [(c.section, c.because) for c in r.conditions.block],
    ),
    Column(
        "token",
        "Direction token",
        "运行方向",
        "Erlaubnis",
        lambda r: [] if r.conditions.token is None else [(r.conditions.token.boundary, r.conditions.token.because)],
    ),
    Column("approach", "Approach locking", "接近锁闭", "Anrückverschluss", _approach),
    Column(
        "release",
        "Sectional release",
        "分段解锁",
        "Teilauflösung",
        lambda r: [(f"{s.section} by {s.proved_by}", s.because) for s in r.locking.release],
    ),
)


@dataclass(frozen=True)
class VoyageColumn:
    """A column of the list of voyages."""

    key: str
    en: str
    zh: str
    de: str
    text: Callable[[VoyageRow], str]


def _meets(v: VoyageRow) -> str:
    return "; ".join(f"{m.voyage} in {', '.join(m.sections)}" for m in v.meetings)


VOYAGE_COLUMNS: tuple[VoyageColumn, ...] = (
    VoyageColumn("number", "No.", "航程号", "Nr.", lambda v: str(v.number)),
    VoyageColumn("voyage", "Voyage", "航程", "Fahrt", lambda v: v.name),
    VoyageColumn("routes", "Routes", "进路", "Fahrstraßen", lambda v: ", ".join(v.routes)),
    VoyageColumn(
        "order", "Set from", "办理顺序", "Einstellung", lambda v: "far end" if v.far_first else "before the train"
    ),
    VoyageColumn("priority", "Priority", "优先级", "Vorrang", lambda v: str(v.priority)),
    VoyageColumn("meets", "Meets head-on", "敌对航程", "Gegenfahrten", _meets),
)
