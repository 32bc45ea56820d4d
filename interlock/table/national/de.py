"""German planning tables: train routes (Sslz), shunt routes (Sslr), overlaps (Ssld), flank protection (Sslf) and
two-way protection points (Sslw).

Columns as in the public data model of the planning tables; those that the table does not hold stay empty.
"""

from __future__ import annotations

from math import isinf

from interlock.model.elements import MachineId, Position
from interlock.model.layout import Layout
from interlock.model.overlap import entry_speed, own_way
from interlock.table.national.reading import Reading
from interlock.table.national.sheet import Cell, Heading, Sheet, route_rows
from interlock.table.printed import PrintedRoute
from interlock.table.rows import FlankCell, InterlockingTable, ProviderKind, Role, RouteKind, RouteRow

LAGE = {Position.NORMAL: "+", Position.REVERSE: "−"}


def _headings(*names: tuple[str, str, str]) -> tuple[Heading, ...]:
    return tuple(Heading(en, zh, de) for de, en, zh in names)


SSLZ = _headings(
    ("Bezeichnung", "Route", "进路"),
    ("Start", "Start", "始端"),
    ("Ziel", "Destination", "终端"),
    ("Nr.", "No.", "号码"),
    ("Entscheidungsweichen", "Deciding points", "决定道岔"),
    ("D-Weg", "Overlap", "保护区段"),
    ("Art", "Kind", "性质"),
    ("Fahrwegweichen", "Points", "道岔"),
    ("Flankenschutzweichen", "Flank points", "防护道岔"),
    ("Freimeldung", "Sections clear", "轨道区段"),
    ("Abhängiger BÜ", "Level crossings", "道口"),
    ("Gleissperren", "Derailers", "脱轨器"),
    ("Annäherungsverschluss", "Approach locking", "接近锁闭"),
    ("Ausschlüsse", "Conflicts", "敌对进路"),
    ("Bemerkung", "Remarks", "备注"),
)
SSLR = _headings(
    ("Bezeichnung", "Route", "进路"),
    ("Start", "Start", "始端"),
    ("Ziel", "Destination", "终端"),
    ("Nr.", "No.", "号码"),
    ("Entscheidungsweichen", "Deciding points", "决定道岔"),
    ("Gegenfahrtausschluss", "Opposing movements excluded", "迎面进路"),
    ("Gleisfreimeldung", "Sections clear", "轨道区段"),
    ("Fahrwegweichen", "Points", "道岔"),
    ("Flankenschutzweichen", "Flank points", "防护道岔"),
    ("Abhängiger BÜ", "Level crossings", "道口"),
    ("Auflösung nicht angefahrener Fahrstraßen", "Release when not used", "未使用解锁"),
    ("Bemerkung", "Remarks", "备注"),
)
SSLD = _headings(
    ("von", "From", "始端"),
    ("Bezeichnung", "Overlap", "名称"),
    ("v Ziel möglich (km/h)", "Entry speed (km/h)", "允许速度"),
    ("Länge soll (m)", "Length needed (m)", "要求长度"),
    ("Länge freigemeldet (m)", "Length proved clear (m)", "检查长度"),
    ("Weichen mit Verschluss", "Points locked", "锁闭道岔"),
    ("relevante FmA", "Sections", "区段"),
    ("Auflöseabschnitt", "Release section", "解锁区段"),
    ("Verzögerung (s)", "Delay (s)", "延时"),
)
SSLF = _headings(
    ("Anforderer Weiche", "Requester", "请求道岔"),
    ("Lage", "Position", "位置"),
    ("unmittelbar Weiche/Gleissperre", "Protecting points or derailer", "防护道岔"),
    ("Lage", "Position", "位置"),
    ("Signal", "Signal", "信号机"),
    ("Gleisabschluss", "End of track or line", "线路终端"),
    ("Technischer Verzicht", "Waiver", "免除"),
    ("Bemerkung", "Remarks", "备注"),
)
SSLW = _headings(
    ("Weiche", "Points", "道岔"),
    ("angefordert +", "Wanted normal by", "定位请求"),
    ("angefordert −", "Wanted reverse by", "反位请求"),
    ("Art", "Kind", "种类"),
)


def _lying(x: Reading, r: RouteRow, *roles: Role) -> str:
    return ", ".join(f"{p.machine}{LAGE[p.position]}" for p in r.points if p.role in roles and x.is_machine(p))


def _deciding(x: Reading, r: RouteRow) -> str:
    return ", ".join(f"{m}{LAGE[p]}" for m, p in x.facing(r))


def _devices(x: Reading, r: RouteRow) -> str:
    return ", ".join(p.machine for p in r.points if p.machine in x.layout.device)


def _d_way(way: PrintedRoute, r: RouteRow) -> str:
    """The name of a route's overlap."""
    return f"D{r.overlap.option}" if r.overlap is not None else ""


def train_routes(layout: Layout, table: InterlockingTable) -> Sheet:
    """Sslz."""
    x = Reading(layout, table)
    ways = [w for w in x.printed.listed if w.rows[0].kind is RouteKind.MAIN]
    rows = route_rows(ways, lambda way, r: _train_route(x, way, r), _d_way)
    return Sheet("de_sslz", "de", Heading("Train routes", "列车进路", "Sslz Zugstraßen"), SSLZ, rows, True)


def _train_route(x: Reading, way: PrintedRoute, r: RouteRow) -> tuple[Cell, ...]:
    derailers = [p for p in r.points if x.is_derailer(p.machine)]
    return (
        way.id,
        r.entry,
        r.exit,
        str(r.number),
        _deciding(x, r),
        tuple(f"{_d_way(way, o)}{' *' if o.overlap.option == 1 else ''}" for o in way.rows if o.overlap is not None),
        "R" if r.variant == 1 else "U",
        _lying(x, r, Role.PATH, Role.OVERLAP),
        _lying(x, r, Role.FLANK, Role.ADDED),
        tuple(x.sections(r)),
        _devices(x, r),
        ", ".join(f"{p.machine} {x.layout.word(p.machine, p.position)}" for p in derailers),
        f"{', '.join(r.approach.sections) or 'immer'}, {r.approach.delay_s:g} s",
        x.named((h.route for h in r.hostile), by=r),
        ", ".join([*r.requirements, *([f"{r.speed.kmh} km/h"] if r.speed.kmh is not None else [])]),
    )


def shunt_routes(layout: Layout, table: InterlockingTable) -> Sheet:
    """Sslr."""
    x = Reading(layout, table)
    rows = [
        (
            r.id,
            r.entry,
            r.exit,
            str(r.number),
            _deciding(x, r),
            ", ".join(x.named(h.route for h in r.hostile if h.kind.value == "opposing")),
            ", ".join(x.sections(r)),
            _lying(x, r, Role.PATH),
            _lying(x, r, Role.FLANK, Role.ADDED),
            _devices(x, r),
            f"{r.approach.delay_s:g} s",
            f"Zielgleis {r.berth} darf besetzt sein" if r.berth else "",
        )
        for way in x.printed.listed
        if (r := way.rows[0]).kind is RouteKind.SHUNT
    ]
    return Sheet("de_sslr", "de", Heading("Shunt routes", "调车进路", "Sslr Rangierstraßen"), SSLR, tuple(rows), True)


def overlaps(layout: Layout, table: InterlockingTable) -> Sheet:
    """Ssld: every alternative once."""
    x = Reading(layout, table)
    rows = {}
    for r in table.routes:
        if r.overlap is None:
            continue
        o, ways = r.overlap, [x.way(key) for key in r.overlap.ways]
        own = own_way(layout, o.signal, ways)
        length = layout.overlap_of[o.signal] if own is None else own.length
        kmh = entry_speed(layout, o.signal, ways)
        rows[o.signal, o.option] = (
            o.signal,
            f"D{o.option}",
            "" if kmh is None else str(kmh),
            "" if isinf(length) else f"{length:g}",
            f"{o.metres:g}",
            _lying(x, r, Role.OVERLAP),
            ", ".join(s for s, _ in o.ways),
            r.traversals[-1][0],
            f"{layout.overlap_release_s(o.signal):g}",
        )
    title = Heading("Overlaps", "保护区段", "Ssld Durchrutschwege")
    return Sheet("de_ssld", "de", title, SSLD, tuple(rows[k] for k in sorted(rows)))


def _by_kind(c: FlankCell, *kinds: ProviderKind) -> str:
    return ", ".join(p.name for p in c.providers if p.kind in kinds)


def flank(layout: Layout, table: InterlockingTable) -> Sheet:
    """Sslf: every requester with what protects it."""
    cells = dict.fromkeys(c for t in table.locks for c in t.flank)
    rows = []
    for c in sorted(cells, key=lambda c: (c.requester, [str(p) for p in c.providers])):
        point, _, leg = c.requester.partition(".")
        used = {"normal": "−", "reverse": "+"}.get(leg, "")
        turned = [p for p in c.providers if p.position is not None]
        rows.append(
            (
                point if used else c.requester,
                used,
                ", ".join(p.name for p in turned),
                ", ".join(LAGE[p.position] for p in turned if p.position is not None),
                _by_kind(c, ProviderKind.SIGNAL),
                _by_kind(c, ProviderKind.BUFFER, ProviderKind.BOUNDARY, ProviderKind.ONE_WAY),
                _by_kind(c, ProviderKind.WAIVED),
                "" if c.providers else "Ringschluss",
            )
        )
    return Sheet("de_sslf", "de", Heading("Flank protection", "侧面防护", "Sslf Flankenschutz"), SSLF, tuple(rows))


def two_way(layout: Layout, table: InterlockingTable) -> Sheet:
    """Sslw: points wanted as flank protection in both positions, by different ways: those exclude each other."""
    wanted: dict[MachineId, dict[Position, list[str]]] = {}
    for t in table.locks:
        for p in t.points:
            if p.role is Role.FLANK:
                wanted.setdefault(p.machine, {}).setdefault(p.position, []).append(f"{t.section}:{t.number}")
    rows = [
        (m, ", ".join(w[Position.NORMAL]), ", ".join(w[Position.REVERSE]), "echt")
        for m, w in sorted(wanted.items())
        if len(w) == 2
    ]
    title = Heading("Two-way protection points", "双向防护道岔", "Sslw Zwieschutzweichen")
    return Sheet("de_sslw", "de", title, SSLW, tuple(rows))
