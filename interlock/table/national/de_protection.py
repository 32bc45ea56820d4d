"""German tables of protection after the planning tables PT1: overlaps (Ssld), flank protection (Sslf) and two-way
protection points (Sslw).

Columns and their letters as the public table code of Eclipse SET names them (eclipse-set/set, SsldColumns.java,
SslfColumns.java, SslwColumns.java); Ril 819.0102 itself was not read.
"""

from __future__ import annotations

from math import isinf

from interlock.dataclass import dataclass
from interlock.model.elements import MachineId, PointId, Position
from interlock.model.layout import Layout
from interlock.model.overlap import own_way
from interlock.table.cells import FlankCell, OverlapCell, Provider, ProviderKind, Role
from interlock.table.national.de import LAGE, SOURCE, end_lage, heading, lage, lying, overlap_name
from interlock.table.national.protection import Protection
from interlock.table.national.reading import Reading
from interlock.table.national.sheet import Field, Heading, Sheet, filled
from interlock.table.rows import InterlockingTable, RouteRow


def overlaps(layout: Layout, table: InterlockingTable) -> Sheet:
    """Ssld: every alternative once, with the track in which trains stand whose overlap it is."""
    x = Reading(layout, table)
    found = {
        (r.locking.overlap.signal, r.locking.overlap.option): (r.locking.overlap, r)
        for r in table.routes
        if r.locking.overlap is not None
    }
    fields: tuple[Field[tuple[OverlapCell, RouteRow]], ...] = (
        Field(heading("A", "von", "From", "始端"), lambda o: o[0].signal),
        Field(heading("E", "Bezeichnung", "Overlap", "名称"), lambda o: overlap_name(o[1])),
        Field(
            heading("F", "v Ziel möglich (km/h)", "Entry speed (km/h)", "允许速度 (km/h)"), lambda o: x.entry_kmh(o[1])
        ),
        Field(heading("G", "Länge soll (m)", "Length needed (m)", "要求长度 (m)"), lambda o: _needed(x, o[0])),
        Field(heading("H", "Länge ist (m)", "Length (m)", "实际长度 (m)"), lambda o: f"{o[0].metres:g}"),
        Field(heading("I", "Länge freigemeldet (m)", "Proved clear (m)", "检查长度 (m)"), lambda o: f"{o[0].metres:g}"),
        Field(
            heading("K", "Weichen mit Verschluss", "Points locked", "锁闭道岔"), lambda o: lying(x, o[1], Role.OVERLAP)
        ),
        Field(heading("M", "relevante FmA", "Sections", "区段"), lambda o: ", ".join(s for s, _ in o[0].ways)),
        Field(heading("Q", "Auflöseabschnitt", "Release section", "解锁区段"), lambda o: o[1].path.traversals[-1][0]),
        Field(heading("R", "Länge (m)", "Its length (m)", "区段长度 (m)"), lambda o: _track_m(x, o[1])),
        Field(heading("S", "Verzögerung (s)", "Delay (s)", "延时 (s)"), lambda o: f"{x.overlap_release_s(o[1]):g}"),
        Field(
            heading("T", "Bemerkung", "Remarks", "备注"),
            lambda o: f"umstellbar auf {', '.join(f'D{k}' for k in o[0].swings)}" if o[0].swings else "",
        ),
    )
    headings, rows = filled(fields, [found[k] for k in sorted(found)])
    return Sheet(
        "de_ssld",
        "de",
        Heading("Overlaps", "保护区段", "Ssld Durchrutschwege"),
        headings,
        rows,
        False,
        SOURCE.format("Ssld"),
        (
            *("B bis", "C Gefahrpunkt", "D PZB-Schutzpunkt", "J maßgebende Neigung"),
            *("L Weichen ohne Verschluss", "N v-Aufwertung Verzicht", "O Erlaubnisabhängig", "P Auflösung manuell"),
        ),
        legend=(*LAGE, ("H = I", "ein D-Weg endet an einer Abschnittsgrenze und ist ganz freigemeldet")),
    )


def _needed(x: Reading, o: OverlapCell) -> str:
    own = own_way(x.layout, o.signal, x.overlap_ways(o))
    metres = x.layout.overlaps.length[o.signal] if own is None else own.length
    return "bis zum nächsten Hauptsignal" if isinf(metres) else f"{metres:g}"


def _track_m(x: Reading, r: RouteRow) -> str:
    """Metres of the section in which the train stands."""
    return f"{sum(x.layout.track.edge[e].length for e in x.way(r.path.traversals[-1]).edges):g}"


@dataclass(frozen=True)
class _Asked:
    """What protects one requester, in words; `two_way`: machines that are wanted in both positions."""

    x: Reading
    protection: Protection
    two_way: frozenset[MachineId]
    cells: tuple[FlankCell, ...]

    @property
    def _turned(self) -> list[Provider]:
        return [p for p in dict.fromkeys(p for c in self.cells for p in c.providers) if p.position is not None]

    def points(self) -> str:
        return ", ".join(p.name for p in self._turned)

    def sides(self) -> str:
        return ", ".join(lage(self.x, MachineId(p.name), p.position) for p in self._turned if p.position is not None)

    def both_ways(self) -> str:
        return ", ".join("ja" if p.name in self.two_way else "nein" for p in self._turned)

    def by(self, *kinds: ProviderKind) -> str:
        return ", ".join(dict.fromkeys(p.name for c in self.cells for p in c.providers if p.kind in kinds))

    def transfer(self) -> str:
        return ", ".join(dict.fromkeys(t for c in self.cells if (t := self.protection.reach(c).transfer) is not None))

    def clear(self) -> str:
        return ", ".join(dict.fromkeys(s for c in self.cells for s in self.protection.space(c)[0]))

    def not_clear(self) -> str:
        return ", ".join(dict.fromkeys(s for c in self.cells for s in self.protection.space(c)[1]))


ENDS = (ProviderKind.BUFFER, ProviderKind.BOUNDARY, ProviderKind.ONE_WAY)


def flank(layout: Layout, table: InterlockingTable) -> Sheet:
    """Sslf: every requester with what protects it, directly or beyond a point that hands the request on."""
    x, protection = Reading(layout, table), Protection(layout, table)
    two_way = frozenset(_wanted(protection))
    rows = [
        _Asked(x, protection, two_way, (c,))
        for c in sorted(protection.cells, key=lambda c: (c.requester, [str(p) for p in c.providers]))
    ]
    fields: tuple[Field[_Asked], ...] = (
        Field(heading("A", "Anforderer", "Requester", "请求者"), lambda a: _requester(x, a.cells[0])[0]),
        Field(heading("B", "Fahrt über", "Position passed", "经由位置"), lambda a: _requester(x, a.cells[0])[1]),
        Field(heading("C", "Weiche/Gleissperre", "Points or derailer", "防护道岔"), _Asked.points),
        Field(heading("D", "Lage", "Position", "位置"), _Asked.sides),
        Field(heading("E", "Zwieschutz", "Two-way", "双向防护"), _Asked.both_ways),
        Field(heading("F", "Signal", "Signal", "信号机"), lambda a: a.by(ProviderKind.SIGNAL)),
        Field(heading("", "Gleisabschluss", "End of track or line", "线路终端"), lambda a: a.by(*ENDS)),
        Field(heading("H", "Weitergabe an", "Handed on to", "转至道岔"), _Asked.transfer),
        Field(heading("I", "wie Fahrt über", "As for", "同经由"), lambda a: "L+R" if a.transfer() else ""),
        Field(heading("J", "Technischer Verzicht", "Waiver", "免除"), lambda a: a.by(ProviderKind.WAIVED)),
        Field(heading("K", "Schutzraum freigemeldet", "Space proved clear", "检查区段"), _Asked.clear),
        Field(heading("L", "nicht freigemeldet", "Space not proved", "不检查区段"), _Asked.not_clear),
        Field(
            heading("M", "Bemerkung", "Remarks", "备注"),
            lambda a: "" if a.cells[0].providers else "Ringschluss: von außen kommt nichts",
        ),
    )
    headings, cells = filled(fields, rows)
    return Sheet(
        "de_sslf",
        "de",
        Heading("Flank protection", "侧面防护", "Sslf Flankenschutz"),
        headings,
        cells,
        False,
        SOURCE.format("Sslf"),
        ("G Zielsperrung",),
        legend=(*LAGE, ("H, I", "der Schutz liegt hinter dieser Weiche; C bis F nennen ihn")),
    )


def _requester(x: Reading, c: FlankCell) -> tuple[str, str]:
    """Its name, and over which position the movement runs that asks."""
    name, _, leg = c.requester.rpartition(".")
    used = {"normal": Position.REVERSE, "reverse": Position.NORMAL}.get(leg)
    return (c.requester, "") if used is None else (x.machines.called(PointId(name)), end_lage(x, PointId(name), used))


def _movement(x: Reading, c: FlankCell) -> str:
    """The movement that asks, in words."""
    name, over = _requester(x, c)
    return f"{name} bei Fahrt über {over}" if over else name


Wanted = dict[MachineId, dict[Position, list[FlankCell]]]


def _wanted(protection: Protection) -> Wanted:
    """The machines that stand first before requesters and would have to lie both ways, with those requesters."""
    found: Wanted = {}
    for c in protection.cells:
        first = protection.reach(c).first
        if first is not None:
            found.setdefault(first[0], {}).setdefault(first[1], []).append(c)
    return {m: w for m, w in sorted(found.items()) if len(w) == 2}


@dataclass(frozen=True)
class _TwoWay:
    """One position of a two-way protection point."""

    machine: MachineId
    position: Position
    asked: _Asked
    substitute: _Asked
    own: bool
    true: bool


def two_way(layout: Layout, table: InterlockingTable) -> Sheet:
    """Sslw: two rows for each point that would have to protect both ways: locked, or replaced by what stands beyond."""
    x, protection = Reading(layout, table), Protection(layout, table)
    wanted = _wanted(protection)
    both = frozenset(wanted)
    rows = []
    for m, by in wanted.items():
        own, true = _shares(table, by)
        for position in sorted(Position, key=lambda p: lage(x, m, p)):
            cells = by[position]
            other = tuple(c for c in cells if all((p.name, p.position) != (m, position) for p in c.providers))
            asked, substitute = _Asked(x, protection, both, tuple(cells)), _Asked(x, protection, both, other)
            rows.append(_TwoWay(m, position, asked, substitute, own, true))
    fields: tuple[Field[_TwoWay], ...] = (
        Field(heading("A", "Weiche in Stellung", "Points in position", "道岔位置"), lambda w: _side(x, w)),
        Field(heading("B", "Art Eigen", "Same route", "同一进路"), lambda w: "x" if w.own else ""),
        Field(heading("C", "Art Echt", "Different routes", "不同进路"), lambda w: "x" if w.true else ""),
        Field(
            heading("D", "Verschluss", "Locked", "锁闭"),
            lambda w: "x" if len(w.substitute.cells) < len(w.asked.cells) else "",
        ),
        Field(
            heading("E", "Ersatz: Weiche/Gleissperre", "Substitute points", "代替道岔"), lambda w: w.substitute.points()
        ),
        Field(heading("F", "Lage", "Position", "位置"), lambda w: w.substitute.sides()),
        Field(heading("G", "Zwieschutz", "Two-way", "双向防护"), lambda w: w.substitute.both_ways()),
        Field(
            heading("H", "Ersatz: Signal", "Substitute signal", "代替信号"),
            lambda w: w.substitute.by(ProviderKind.SIGNAL),
        ),
        Field(heading("", "Ersatz: Gleisabschluss", "Substitute: end", "代替终端"), lambda w: w.substitute.by(*ENDS)),
        Field(heading("J", "Weitergabe an", "Handed on to", "转至道岔"), lambda w: w.substitute.transfer()),
        Field(heading("K", "wie Fahrt über", "As for", "同经由"), lambda w: "L+R" if w.substitute.transfer() else ""),
        Field(heading("L", "Technischer Verzicht", "Waiver", "免除"), lambda w: w.asked.by(ProviderKind.WAIVED)),
        Field(heading("M", "Schutzraum freigemeldet", "Space proved clear", "检查区段"), lambda w: w.asked.clear()),
        Field(heading("N", "nicht freigemeldet", "Space not proved", "不检查区段"), lambda w: w.asked.not_clear()),
        Field(
            heading("P", "Bemerkung", "Remarks", "备注"),
            lambda w: "für " + ", ".join(dict.fromkeys(_movement(x, c) for c in w.asked.cells)),
        ),
    )
    headings, cells_ = filled(fields, rows)
    return Sheet(
        "de_sslw",
        "de",
        Heading("Two-way protection points", "双向防护道岔", "Sslw Zwieschutzweichen"),
        headings,
        cells_,
        False,
        SOURCE.format("Sslw"),
        ("I Zielsperrung", "O Nachlaufverhinderung"),
        legend=(
            *LAGE,
            ("Eigen", "dieselbe Fahrstraße braucht beide Lagen"),
            ("Echt", "verschiedene Fahrstraßen brauchen sie"),
        ),
    )


def _side(x: Reading, w: _TwoWay) -> str:
    return f"{w.machine}{lage(x, w.machine, w.position)}"


def _shares(table: InterlockingTable, by: dict[Position, list[FlankCell]]) -> tuple[bool, bool]:
    """Whether one route asks for both positions, and whether different routes do."""
    names = {x: {c.requester for c in cells} for x, cells in by.items()}
    asking = [[x for x in by if any(c.requester in names[x] for c in r.locking.flank)] for r in table.routes]
    own = any(len(a) == 2 for a in asking)
    each = [{i for i, a in enumerate(asking) if x in a} for x in by]
    return own, any(i != j for i in each[0] for j in list(each[1])[:2])
