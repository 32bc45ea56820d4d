"""German route tables after the planning tables PT1: train routes (Sslz), shunt routes (Sslr), and, after the classic
Verschlusstafel, what every route locks.

Columns and their letters as the public table code of Eclipse SET names them (eclipse-set/set, SslzColumns.java and
SslrColumns.java); Ril 819.0102 itself was not read.  What a layout says nothing of is named below each table.
"""

from __future__ import annotations

from collections.abc import Iterable
from itertools import islice, pairwise

from interlock.model.elements import DeviceKind, Hand, MachineId, PointId, Position
from interlock.model.layout import Layout
from interlock.table.cells import PointDemand, ProviderKind, Role, RouteKind
from interlock.table.national.reading import Reading
from interlock.table.national.sheet import Field, Heading, Sheet, by_way
from interlock.table.printed import PrintedRoute
from interlock.table.rows import InterlockingTable, RouteRow

SOURCE = "after {} of the PT1 planning tables; columns as named in the public code of Eclipse SET"
SIDES = {Hand.LEFT: "L", Hand.RIGHT: "R"}
SIGNS = {Position.NORMAL: "+", Position.REVERSE: "−"}
AUF = {Position.NORMAL: "aufgelegt", Position.REVERSE: "abgelegt"}
LAGE = (
    ("L, R", "Lage links, rechts, vom Weichenanfang gesehen"),
    ("+, −", "Grundstellung, umgestellt (Hand nicht angegeben)"),
)


MITLAUFEND = ("mitlaufende Weichen", "werden umgestellt und sind keine Bedingung für das Signal: siehe table.csv")

GESTELLT = {"open": "offen", "closed": "geschlossen", "shut": "geschlossen"}
"""How a device is, by the word for it."""


def heading(mark: str, de: str, en: str, zh: str) -> Heading:
    """A heading; `mark` is the letter of the column in PT1."""
    return Heading(en, zh, de, mark)


def lage(x: Reading, m: MachineId, position: Position) -> str:
    """L or R where the layout states the hand of the points, else + or −; of a derailer, whether it lies on."""
    if x.machines.is_derailer(m):
        return AUF[position]
    side = x.machines.machine_side(m, position)
    return SIGNS[position] if side is None else SIDES[side]


def end_lage(x: Reading, p: PointId, position: Position) -> str:
    """The same of one point end."""
    side = x.machines.side(p, position)
    return SIGNS[position] if side is None else SIDES[side]


def lying(x: Reading, r: RouteRow, *roles: Role) -> str:
    """Points of a route with their positions, without derailers and devices."""
    return ", ".join(
        f"{p.machine}{lage(x, p.machine, p.position)}" for p in r.locking.points if p.role in roles and _is_w(x, p)
    )


def _is_w(x: Reading, p: PointDemand) -> bool:
    return x.machines.is_machine(p) and p.machine not in x.layout.machines.by_hand


def _name(r: RouteRow) -> str:
    """As PT1 prints it: start/destination, [U2] for the second way; the overlaps stand in their column."""
    other = f" [U{r.path.variant}]" if r.path.variant > 1 else ""
    return f"{r.entry}/{_destination(r)}{other}"


def _next_signal(r: RouteRow) -> str:
    return r.signal.aspect.next or ""


def _destination(r: RouteRow) -> str:
    """Where the train stops or leaves."""
    return r.exit if r.path.destination is None else r.path.destination


def _last(x: Reading, r: RouteRow) -> RouteRow:
    """The row that tells what lies at the destination."""
    return x.table.parts(r)[-1]


def overlap_name(r: RouteRow) -> str:
    """The overlap that a route locks: D1, D2."""
    return "" if r.locking.overlap is None else f"D{r.locking.overlap.option}"


def _d_way(way: PrintedRoute, r: RouteRow) -> str:
    return overlap_name(r) if way.several else ""


def _overlaps(x: Reading, r: RouteRow) -> tuple[str, ...]:
    """All overlaps of the way, the preferred one with an asterisk."""
    if r.path.onward is not None:
        return tuple(filter(None, (overlap_name(_last(x, r)),)))
    found = (o for o in x.printed.ways[r.id].rows if o.locking.overlap is not None)
    return tuple(
        overlap_name(o) + "*" * (o.locking.overlap is not None and o.locking.overlap.option == 1) for o in found
    )


def _deciding(x: Reading, r: RouteRow) -> str:
    return ", ".join(f"{x.machines.called(p)}{end_lage(x, p, position)}" for p, position in x.machines.deciding(r))


def _crossings(x: Reading, r: RouteRow) -> list[str]:
    """The level crossings that are closed for a route, past the signals that it passes, too."""
    devices = (d for p in x.table.parts(r) for d in x.machines.devices(p).items())
    return list(dict.fromkeys(str(m) for m, at in devices if _closed(x, m, at)))


def _closed(x: Reading, m: MachineId, at: Position) -> bool:
    return x.layout.machines.device[m].kind is DeviceKind.LEVEL_CROSSING and at is Position.REVERSE


def _other_devices(x: Reading, r: RouteRow) -> list[str]:
    """Bridges, doors and what else a route locks, and level crossings that must be open."""
    others = ((m, at) for m, at in x.machines.devices(r).items() if not _closed(x, m, at))
    return [f"{m} {GESTELLT[x.layout.machines.word(m, at)]}" for m, at in others]


def _clear(x: Reading, r: RouteRow) -> tuple[str, ...]:
    """The sections that must be clear: `[BC oder 102L]` only while 102 is not detected there (Grenzzeichen)."""

    def unless(m: MachineId, at: Position) -> str:
        return f"oder {m}{' ' * x.machines.is_derailer(m)}{lage(x, m, at)}"

    return tuple(x.sections(r, unless))


def _signs(x: Reading, ways: Iterable[PrintedRoute], routes: bool = False) -> tuple[tuple[str, str], ...]:
    """What a section means that is foul in some positions only, and (`routes`) a route with one of its overlaps: the
    first of each stands for all."""
    listed = [r for w in ways for r in w.rows]
    whole = {w.id for w in x.printed.all}
    foul = (c for r in listed for c in _clear(x, r) if c.startswith("["))
    excluded = (n for r in listed if routes for n in x.named(r.locking.hostile.routes, by=r) if n not in whole)
    return (
        *((c, f"{c[1:].partition(' ')[0]} ist frei, oder die Weiche liegt nachweislich so") for c in islice(foul, 1)),
        *(
            (n, f"die Fahrstraße mit D-Weg D{n.rpartition('.o')[2]}; mit einem anderen schließt sie nicht aus")
            for n in islice(excluded, 1)
        ),
    )


def _derailers(x: Reading, r: RouteRow) -> str:
    return ", ".join(f"{d} {AUF[position]}" for d, position in x.machines.derailers(r).items())


def _keys(x: Reading, r: RouteRow) -> str:
    held = (q.machine for p in x.table.parts(r) for q in p.locking.points)
    return ", ".join(dict.fromkeys(m for m in held if m in x.layout.machines.by_hand))


def _asked(x: Reading, r: RouteRow) -> list[str]:
    """What a route asks besides points and clear track, and where its overlap may swing."""
    notes = _other_devices(x, r)
    notes += [str(c.condition) for c in r.conditions.external]
    notes += [f"{z.zone} nicht voll" for z in r.conditions.zones]
    notes += [f"{b.section} frei (Strecke)" for b in r.conditions.block]
    notes += [f"Haltlicht von {c.name}" for c in r.clear.space if c.lamp]
    if (token := r.conditions.token) is not None:
        notes.append(f"Erlaubnis für {x.layout.printed.labels.get(token.boundary, token.boundary)}")
    if r.signal.closing.whole is not None:
        notes.append(f"Haltfall erst, wenn {r.signal.closing.whole} frei")
    if r.locking.overlap is not None and r.locking.overlap.swings:
        notes.append(f"D-Weg umstellbar auf {', '.join(f'D{k}' for k in r.locking.overlap.swings)}")
    return notes


def _remarks(x: Reading, r: RouteRow) -> tuple[str, ...]:
    """Of a route past signals all that is asked beyond them, too: trains have no row there."""
    parts = x.table.parts(r)
    notes = list(dict.fromkeys(note for p in parts for note in _asked(x, p)))
    for before, past in pairwise(parts):
        notes.append(f"{before.exit} zeigt Kennlicht; Fahrweg dahinter wie {past.id} in der Verschlusstafel")
        if before.locking.overlap is not None:
            notes.append(f"{overlap_name(before)} von {before.exit} mitverschlossen")
    notes += [f"{m} {p.locking.hold:g} s länger verschlossen" for p in parts for m in p.locking.held_longer]
    if r.kind is RouteKind.CALL_ON:
        notes.append("Ersatzsignal: besetzte Abschnitte erlaubt")
    if r.kind is RouteKind.SHUNT and (kmh := x.path_kmh(r)):
        notes.append(f"v Fahrweg {kmh} km/h")
    if r.path.berth is not None:
        notes.append(f"Zielgleis {r.path.berth} darf besetzt sein")
    return tuple(notes)


def _kind(r: RouteRow) -> str:
    return "E" if r.kind is RouteKind.CALL_ON else "R" if r.path.variant == 1 else "U"


_IDENTIFIER = Field[RouteRow](
    heading("AD", "Kennlicht", "Signals passed at identifier light", "无效标志灯"),
    lambda r: ", ".join(r.path.passed or ()),
)


def train_routes(layout: Layout, table: InterlockingTable) -> Sheet:
    """Sslz."""
    x, automatic = Reading(layout, table), set(table.automatic)
    fields: tuple[Field[RouteRow], ...] = (
        Field(heading("A", "Bezeichnung", "Route", "进路"), _name),
        Field(heading("B", "Start", "Start", "始端"), lambda r: r.entry),
        Field(heading("C", "Ziel", "Destination", "终端"), _destination),
        Field(heading("D", "Nr.", "No.", "号码"), lambda r: str(r.path.variant) if r.path.variant > 1 else ""),
        Field(heading("E", "Entscheidungsweiche", "Deciding points", "决定道岔"), lambda r: _deciding(x, r)),
        Field(heading("F", "D-Weg", "Overlap", "保护区段"), lambda r: _overlaps(x, r)),
        Field(heading("G", "Art", "Kind", "性质"), _kind),
        Field(heading("H", "Autom. Einstellung", "Automatic", "自动"), lambda r: "x" if r.id in automatic else ""),
        Field(heading("K", "Überwachte Ssp", "Keys supervised", "钥匙锁"), lambda r: _keys(x, r)),
        Field(
            heading("L", "Abhängiger BÜ", "Level crossings", "道口"),
            lambda r: ", ".join(_crossings(x, r)),
        ),
        Field(
            heading("O", "Anrückverschluss", "Approach locking", "接近锁闭"),
            lambda r: ", ".join(r.locking.approach.sections) or "immer",
        ),
        Field(
            heading("Q", "v Fahrweg (km/h)", "Speed of the path (km/h)", "进路速度 (km/h)"),
            x.path_kmh,
        ),
        Field(
            heading("R", "v D-Weg (km/h)", "Speed of the overlap (km/h)", "保护区段速度 (km/h)"),
            lambda r: x.entry_kmh(_last(x, r)),
        ),
        *([_IDENTIFIER] if layout.signalling.identifiers else []),
        Field(heading("AE", "Vorsignalisierung Ziel", "Next signal shown", "预告信号"), _next_signal),
        Field(heading("AF", "Bemerkung", "Remarks", "备注"), lambda r: _remarks(x, r)),
        Field(heading("", "Fahrstraße", "Route in the other tables", "进路名"), lambda r: x.printed.ways[r.id].id),
    )
    listed = [w for w in x.printed.listed if w.rows[0].train and w.rows[0].kind is not RouteKind.IDENTIFIER]
    headings, rows = by_way(fields, listed, _d_way)
    return Sheet(
        "de_sslz",
        "de",
        Heading("Train routes", "列车进路", "Sslz Zugstraßen"),
        headings,
        rows,
        True,
        SOURCE.format("Sslz"),
        (
            *("I F-Bedienung", "J Inselgleis", "M Nichthaltfallabschnitt", "N 2. Haltfallkriterium", "P Hg"),
            *("S v Besonders", "T Zs3", "U Aufwertung Mwtfstr", "V Zl", "W Zs3v", "X Zs2", "Y Zs2v"),
            *("Z Zs6", "AA Zs13", "AB Zs3 im Fahrweg", "AC Zs6 im Fahrweg"),
            *(() if layout.signalling.identifiers else ("AD Kennlicht",)),
        ),
        legend=(
            *LAGE,
            ("R, U, E", "Regelfahrstraße, Umfahrstraße, Ersatzsignal (Fahrt auf besetzte Abschnitte)"),
            ("D1*", "Vorzugs-D-Weg"),
            (
                "immer",
                "Anrückabschnitte werden nicht erfasst: der Anrückverschluss gilt, sobald das Signal Fahrt zeigt",
            ),
        ),
    )


def _onto(x: Reading, r: RouteRow) -> str:
    """Whether opposing shunt routes onto the same track are excluded; empty where there is none."""
    last = x.way(r.path.traversals[-1])
    against = {
        t.id
        for t in x.table.routes
        if t.kind is RouteKind.SHUNT and (way := x.way(t.path.traversals[-1])).section == last.section
        if way.entry != last.entry
    }
    return ("ja" if against <= set(r.locking.hostile.routes) else "nein") if against else ""


def _with_flank(x: Reading, r: RouteRow) -> str:
    """The points of the path for which the route asks for flank protection."""
    found = (c for c in r.locking.flank if all(p.kind is not ProviderKind.WAIVED for p in c.providers))
    names = (c.requester.rpartition(".") for c in found)
    return ", ".join(
        dict.fromkeys(x.machines.called(PointId(name)) for name, _, leg in names if leg in ("normal", "reverse"))
    )


def shunt_routes(layout: Layout, table: InterlockingTable) -> Sheet:
    """Sslr."""
    x, automatic = Reading(layout, table), set(table.automatic)
    fields: tuple[Field[RouteRow], ...] = (
        Field(heading("A", "Bezeichnung", "Route", "进路"), _name),
        Field(heading("B", "Start", "Start", "始端"), lambda r: r.entry),
        Field(heading("C", "Ziel", "Destination", "终端"), lambda r: r.exit),
        Field(heading("D", "Nr.", "No.", "号码"), lambda r: str(r.path.variant) if r.path.variant > 1 else ""),
        Field(heading("E", "Entscheidungsweiche", "Deciding points", "决定道岔"), lambda r: _deciding(x, r)),
        Field(heading("F", "Art", "Kind", "性质"), _kind),
        Field(heading("G", "Autom. Einstellung", "Automatic", "自动"), lambda r: "x" if r.id in automatic else ""),
        Field(heading("J", "Gegenfahrtausschluss", "Opposing excluded", "迎面进路"), lambda r: _onto(x, r)),
        Field(heading("K", "Gleisfreimeldung", "Sections clear", "轨道区段"), lambda r: _clear(x, r)),
        Field(
            heading("L", "Fahrwegweichen mit Flankenschutz", "Points with flank", "要求防护道岔"),
            lambda r: _with_flank(x, r),
        ),
        Field(heading("M", "Überwachte Ssp", "Keys supervised", "钥匙锁"), lambda r: _keys(x, r)),
        Field(
            heading("N", "Abhängiger BÜ", "Level crossings", "道口"),
            lambda r: ", ".join(_crossings(x, r)),
        ),
        Field(
            heading("O", "Ziel erlaubnisabhängig", "Token at the end", "终端方向闭锁"),
            lambda r: "x" if r.conditions.token is not None else "",
        ),
        Field(
            heading("P", "Auflösung nicht angefahrener Fahrstraßen", "Release when not used", "未使用解锁"),
            lambda r: f"{r.locking.approach.delay_s:g} s",
        ),
        Field(heading("Q", "Bemerkung", "Remarks", "备注"), lambda r: _remarks(x, r)),
        Field(heading("", "Fahrstraße", "Route in the other tables", "进路名"), lambda r: x.printed.ways[r.id].id),
    )
    listed = [w for w in x.printed.listed if w.rows[0].kind is RouteKind.SHUNT]
    headings, rows = by_way(fields, listed, _d_way)
    return Sheet(
        "de_sslr",
        "de",
        Heading("Shunt routes", "调车进路", "Sslr Rangierstraßen"),
        headings,
        rows,
        True,
        SOURCE.format("Sslr"),
        ("H F-Bedienung", "I Inselgleis"),
        legend=(
            *LAGE,
            ("R, U", "Regelfahrstraße, Umfahrstraße"),
            *_signs(x, listed),
            ("J", "ja: gleichzeitige Rangierfahrten von der anderen Seite in das Zielgleis sind ausgeschlossen"),
        ),
    )


_ART = {RouteKind.MAIN: "Zug", RouteKind.SHUNT: "Rangier", RouteKind.CALL_ON: "Ersatz"}
_ART |= {RouteKind.IDENTIFIER: "Zug, hinter Kennlicht"}


_HELD_LONGER = Field[RouteRow](
    heading("", "Länger verschlossen", "Held longer", "延时解锁"),
    lambda r: tuple(f"{m} {r.locking.hold:g} s" for m in r.locking.held_longer),
)


def locking(layout: Layout, table: InterlockingTable) -> Sheet:
    """Verschlusstafel: what each route locks and excludes."""
    x = Reading(layout, table)
    fields: tuple[Field[RouteRow], ...] = (
        Field(heading("", "Fahrstraße", "Route", "进路"), lambda r: x.printed.ways[r.id].id),
        Field(
            heading("", "Art", "Kind", "性质"),
            lambda r: _ART[r.kind],
        ),
        Field(heading("", "Fahrwegweichen", "Points", "道岔"), lambda r: lying(x, r, Role.PATH)),
        Field(heading("", "Weichen im D-Weg", "Overlap points", "保护区段道岔"), lambda r: lying(x, r, Role.OVERLAP)),
        Field(
            heading("", "Flankenschutzweichen", "Flank points", "防护道岔"),
            lambda r: lying(x, r, Role.FLANK, Role.ADDED),
        ),
        Field(heading("", "Gleissperren", "Derailers", "脱轨器"), lambda r: _derailers(x, r)),
        Field(heading("", "Signale in Halt", "Signals at stop", "禁止信号"), lambda r: tuple(x.stops(r))),
        Field(heading("", "Freimeldung", "Sections clear", "轨道区段"), lambda r: _clear(x, r)),
        Field(
            heading("", "Ausschlüsse", "Routes excluded", "敌对进路"), lambda r: x.named(r.locking.hostile.routes, by=r)
        ),
        Field(
            heading("", "Verzögerung bei Rücknahme (s)", "Release delay (s)", "解锁延时 (s)"),
            lambda r: f"{r.locking.approach.delay_s:g}",
        ),
        *([_HELD_LONGER] if any(r.locking.hold for r in table.routes) else []),
    )
    headings, rows = by_way(fields, x.printed.listed, _d_way)
    title = Heading("Locking table", "联锁表", "Verschlusstafel")
    return Sheet(
        "de_verschluss",
        "de",
        title,
        headings,
        rows,
        True,
        "after the classic Verschlusstafel (routes against what they lock); no worked example was at hand",
        legend=(*LAGE, *_signs(x, x.printed.listed, routes=True), *([MITLAUFEND] if x.drives else [])),
    )
