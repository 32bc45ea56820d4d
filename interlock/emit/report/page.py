"""The report: plan, table, reasons, proof, matrices and files on one page that needs nothing else.

Choosing a route lights up its path, overlap and flank protection on the plan and marks its hostile routes in the table.
Everything that is printed stands in the page itself; scripts only light up, filter and explain.
"""

from __future__ import annotations

import csv
import io
import json
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, field
from functools import lru_cache
from importlib import resources

from jinja2 import Environment, PackageLoader, select_autoescape
from markupsafe import Markup

from interlock.emit.bundle import digest_of
from interlock.emit.io import CROSS_REFERENCE
from interlock.emit.tables.paper import SIGNED, title_block
from interlock.model.layout import Layout
from interlock.model.traversal import Topology, topology
from interlock.table.columns import COLUMNS, VOYAGE_COLUMNS
from interlock.table.matrix import beyond_matrix, matrix
from interlock.table.national import SHEETS, national_sheets
from interlock.table.printed import Printed, PrintedRoute, grouped, parts
from interlock.table.rows import Because, FlankCell, Hostility, InterlockingTable, ProviderKind, RouteRow, TraversalKey

LARGE = 200  # routes: from here on hostile routes are counted in the table, and named when asked for


@lru_cache(maxsize=1)
def environment() -> Environment:
    """Templates of this folder."""
    return Environment(
        loader=PackageLoader("interlock.emit.report", "."),
        autoescape=select_autoescape(default=True, default_for_string=True),
        trim_blocks=True,
        lstrip_blocks=True,
    )


def asset(name: str) -> str:
    """A style sheet or script of this folder."""
    return resources.files("interlock.emit.report").joinpath(name).read_text("utf-8")


def script_json(value: object) -> str:
    """JSON that cannot end the script element in which it stands."""
    text = json.dumps(value, ensure_ascii=False, separators=(",", ":"), sort_keys=True)
    return text.replace("<", "\\u003c").replace(">", "\\u003e").replace("&", "\\u0026")


def report_html(
    layout: Layout,
    table: InterlockingTable,
    plan: str,
    claims: Sequence[Mapping[str, object]],
    texts: Sequence[tuple[str, bool]],
    assumptions: Mapping[str, str],
    files: Mapping[str, bytes],
    watermark: str,
) -> str:
    """The page; `files` are those that it names with their digests."""
    named = matrix(table, named_only=True)
    m = named if named.routes else matrix(table)
    small = len(m.routes) <= 80
    mmt = m.m_mt() if small else ()
    large, printed, shared = len(table.routes) > LARGE, Printed(table), _Shared()
    routes = _routes(layout, table, shared)

    return (
        environment()
        .get_template("index.html.j2")
        .render(
            layout=layout,
            table=table,
            printed=printed,
            plan=plan,
            css=Markup(asset("report.css")),
            js=asset("report.js"),
            place=shared.reason,
            data=lambda: script_json({"routes": routes, **asdict(shared)}),
            title_block=lambda language: title_block(layout, table.layout_digest, language),
            signatures=SIGNED,
            has_forms=layout.profile in SHEETS,
            columns=[c for c in COLUMNS if any(map(c.items, table.routes))],
            empty=[c.en for c in COLUMNS if not any(map(c.items, table.routes))],
            voyage_columns=VOYAGE_COLUMNS,
            claims=claims,
            texts=texts,
            assumptions=assumptions,
            watermark=watermark,
            m=m,
            mmt=mmt,
            most=max((x for row in mmt for x in row), default=1),
            heat=_heat,
            hostile_parts=lambda way: _hostile_parts(way, large),
            beyond=beyond_matrix(table),
            forms=[f.printed() for f in national_sheets(layout, table)] if not large else [],
            kinds_of_routes=sorted({str(r.kind) for r in table.routes}),
            places=sorted({*(s for r in table.routes for s in r.section_ids), *(r.entry for r in table.routes)}),
            references=[(n, _sheet(data)) for n, data in sorted(files.items()) if n.startswith(CROSS_REFERENCE)],
            digests=[(n, digest_of(n, data)) for n, data in sorted(files.items())],
        )
    )


def _hostile_parts(way: PrintedRoute, large: bool) -> list[tuple[RouteRow | None, str]]:
    """The hostile routes of a row by name, or how many they are; of which route of the row, where there are several."""
    if large:
        return [(r if way.several else None, f"{len(r.hostile)} routes") for r in way.rows if r.hostile]
    told = [
        (r, [x.name() for x in grouped(((h.route, None) for h in r.hostile), way.ways, r) if x.way is not way])
        for r in way.rows
    ]
    return [(p.row, ", ".join(p.items)) for p in parts(told) if p.items]


def _sheet(data: bytes) -> list[list[str]]:
    """The rows of a file of cells, its headings first."""
    return list(csv.reader(io.StringIO(data.decode())))


def _heat(value: int, most: int) -> Markup:
    """The colour of a number in a matrix."""
    if not value:
        return Markup("")
    return Markup(' style="background:rgba(0,114,178,{:.2f})"').format(0.12 + 0.5 * value / max(1, most))


@dataclass
class _Shared:
    """What rows of the page share, each once; they tell the place in the list."""

    reasons: list[str] = field(default_factory=list)
    hows: list[list[str]] = field(default_factory=list)
    """How routes are hostile: class and witness, with `{one}` and `{other}` as in `Hostility`."""
    ways: list[list[str]] = field(default_factory=list)
    """Ways through sections: the section, its edges on the plan, then `|` and its points."""
    flanks: list[list[str]] = field(default_factory=list)
    """Signals that protect a leg."""

    def reason(self, because: Because) -> int:
        """The place of a reason."""
        return self._in("reasons", f"{because.rule}: {because.text}")

    def flank(self, cell: FlankCell) -> int:
        """The place of the signals that protect a leg."""
        return self._in("flanks", [p.name for p in cell.providers if p.kind is ProviderKind.SIGNAL])

    def way(self, key: TraversalKey, topo: Topology) -> int:
        """The place of a way."""
        t = topo.traversals[key[0]][key[1] - 1]
        return self._in("ways", [key[0], *t.edges, "|", *(p for p, _ in t.points)])

    def how(self, how: Hostility) -> int:
        """The place of a manner of being hostile."""
        return self._in("hows", [str(how.kind), how.witness])

    def __post_init__(self) -> None:
        self._places: dict[tuple[str, str], int] = {}

    def _in(self, name: str, value: object) -> int:
        shared = getattr(self, name)
        at = self._places.setdefault((name, repr(value)), len(shared))
        if at == len(shared):
            shared.append(value)
        return at


def _routes(layout: Layout, table: InterlockingTable, shared: _Shared) -> list[dict[str, object]]:
    topo = topology(layout)
    line = {r.id: k for k, way in enumerate(Printed(table).all) for r in way.rows}
    routes = []
    for r in table.routes:
        onward = () if r.onward is None else table.route[r.onward].traversals
        providers = [p for c in r.flank for p in c.providers]
        machines = {p.name for p in providers if p.kind is ProviderKind.POINT}
        hostile: dict[int, list[int]] = {}
        for h in r.hostile:
            hostile.setdefault(shared.how(h.how), []).append(table.route[h.route].number - 1)
        routes.append(
            {
                "id": r.id,
                "row": line[r.id],
                "kind": str(r.kind),
                "entry": r.entry,
                "exit": r.exit,
                "path": [shared.way(k, topo) for k in (*r.traversals, *onward)],
                "overlap": [shared.way(k, topo) for k in (r.overlap.ways if r.overlap is not None else ())],
                "flank_points": [str(p.id) for p in layout.points if p.id in machines or p.machine in machines],
                "flank": [shared.flank(c) for c in r.flank],
                "hostile": sorted(hostile.items()),
            }
        )
    return routes
