"""The report: plan, table, reasons, proof, matrices and files on one page that needs nothing else.

Choosing a route lights up its path, overlap and flank protection on the plan and marks its hostile routes in the table.
Everything that is printed stands in the page itself; the script lights up, filters and explains.
"""

from __future__ import annotations

import csv
import io
import json
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import asdict, field
from functools import lru_cache
from importlib import resources

from jinja2 import Environment, PackageLoader, select_autoescape
from markupsafe import Markup, escape

from interlock.dataclass import dataclass
from interlock.emit.bundle import digest_of
from interlock.emit.io import CROSS_REFERENCE
from interlock.emit.tables.paper import SIGNED, title_block
from interlock.model.layout import Layout
from interlock.model.machines import shown_by
from interlock.model.traversal import Topology, topology
from interlock.table.cells import Because, Hostility, ProviderKind, Role, TraversalKey
from interlock.table.columns import COLUMNS, VOYAGE_COLUMNS, Column, Reasons
from interlock.table.matrix import beyond_matrix, matrix
from interlock.table.national import SHEETS, national_sheets
from interlock.table.printed import Printed, PrintedRoute, grouped, parts
from interlock.table.rows import InterlockingTable, RouteRow

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
            whole=_whole,
            cell=lambda c, way: _cell(c, way, shared, large),
            beyond=beyond_matrix(table),
            forms=[f.printed() for f in national_sheets(layout, table)] if not large else [],
            kinds_of_routes=sorted({str(r.kind) for r in table.routes}),
            places=sorted({*(s for r in table.routes for s in r.path.section_ids), *(r.entry for r in table.routes)}),
            references=[(n, _sheet(data)) for n, data in sorted(files.items()) if n.startswith(CROSS_REFERENCE)],
            digests=[(n, digest_of(n, data)) for n, data in sorted(files.items())],
        )
    )


def _hostile_parts(way: PrintedRoute, large: bool) -> list[tuple[RouteRow | None, str]]:
    """The hostile routes of a row by name, or how many they are; of which route of the row, where there are several."""
    if large:
        return [(r if way.several else None, f"{len(r.locking.hostile)} routes") for r in way.rows if r.locking.hostile]
    told = [
        (r, [x.name() for x in grouped(((h.route, None) for h in r.locking.hostile), way.ways, r) if x.way is not way])
        for r in way.rows
    ]
    return [(p.row, ", ".join(p.items)) for p in parts(told) if p.items]


LONG = 24
"""Letters of a name that may be broken (our choice)."""
OF_A_WIDTH = frozenset({"route", "hostile", "flank", "release", "sections"})
"""Columns that the style sheet speaks of."""


def _cell(c: Column, way: PrintedRoute, shared: _Shared, large: bool) -> Markup:
    """A cell of the table.  `data-why` has the places of the reasons of its items, of which the script makes buttons
    when they are to be seen."""
    name = f' class="c-{c.key}"' if c.key in OF_A_WIDTH else ""
    if c.key == "hostile":
        inner = []
        for row, text in _hostile_parts(way, large):
            of = (row or way.rows[0]).number - 1
            inner.append(f'<div>{_of(way, row)}<button data-hostile="{of}">{escape(text)}</button></div>')
        return Markup(f"<td{name}>{''.join(inner)}</td>")
    told = [(p.row, [_reasoned(run, shared) for run in _runs(p.items)]) for p in c.parts(way) if p.items]
    if len(told) == 1 and told[0][0] is None and len(told[0][1]) == 1:
        return Markup("<td{}{}</td>").format(Markup(name), told[0][1][0])
    parts_ = [f"<div>{_of(way, row)}{', '.join(f'<span{x}</span>' for x in items)}</div>" for row, items in told]
    return Markup(f"<td{name}>{''.join(parts_)}</td>")


def _of(way: PrintedRoute, row: RouteRow | None) -> str:
    """The button that chooses one of the routes of a row."""
    if row is None:
        return ""
    return f'<button class="of" data-route="{row.number - 1}" title="route {escape(row.id)}">{way.mark(row)}</button> '


def _runs(items: Reasons | tuple[tuple[str, Because], ...]) -> list[Reasons]:
    """Items that can be told apart by the comma between them; one that has a comma itself stands alone."""
    out: list[Reasons] = []
    for item in items:
        if out and ", " not in item[0] and ", " not in out[-1][0][0]:
            out[-1].append(item)
        else:
            out.append([item])
    return out


def _reasoned(items: Reasons, shared: _Shared) -> Markup:
    """The rest of a tag, with the places of reasons, and the items in it."""
    places = " ".join([str(shared.reason(because)) for _, because in items])
    return Markup(f' data-why="{places}">{escape(", ".join([text for text, _ in items]))}')


def _whole(cell: str) -> Markup:
    """A cell of a form, whose names are not broken behind their hyphens: `17-23DG` stands on one line."""
    words = re.split(r"([^\s、，；,;]+)", cell)
    return Markup("").join(
        Markup('<span class="whole">{}</span>').format(w) if "-" in w and len(w) <= LONG else w for w in words
    )


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
    beside: list[list[str]] = field(default_factory=list)
    """What a route needs beside its way: the kind of element and its id on the plan, what it is there for (`flank`,
    `device` or `foul`), and how a machine must lie, in a word."""
    groups: list[list[int]] = field(default_factory=list)
    """Routes that are hostile in one way: its place in `hows`, and the routes, counted from 0; `4, -9` is 4 to 9."""

    def reason(self, because: Because) -> int:
        """The place of a reason."""
        return self._in("reasons", f"{because.rule}: {because.text}")

    def needs(self, kind: str, name: str, use: str, word: str = "") -> int:
        """The place of something that a route needs beside its way."""
        return self._in("beside", [kind, name, use, word])

    def way(self, key: TraversalKey, topo: Topology) -> int:
        """The place of a way."""
        t = topo.traversals[key[0]][key[1] - 1]
        return self._in("ways", [key[0], *t.edges, "|", *(p for p, _ in t.points)])

    def how(self, how: Hostility) -> int:
        """The place of a manner of being hostile."""
        return self._in("hows", [str(how.kind), how.witness])

    def group(self, how: int, routes: Sequence[int]) -> int:
        """The place of a group of routes that are hostile in one way."""
        told = list(routes[:1])
        for before, this, after in zip(routes, routes[1:], [*routes[2:], None], strict=False):
            if this == before + 1:
                told += [-this] if after != this + 1 else []
            else:
                told.append(this)
        return self._in("groups", [how, *told])

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
        hostile: dict[int, list[int]] = {}
        for h in r.locking.hostile:
            hostile.setdefault(shared.how(h.how), []).append(table.route[h.route].number - 1)
        routes.append(
            {
                "id": r.id,
                "row": line[r.id],
                "kind": str(r.kind),
                "entry": r.entry,
                "exit": r.exit,
                "path": [shared.way(k, topo) for p in table.parts(r) for k in p.path.traversals],
                "overlap": [
                    shared.way(k, topo) for k in (r.locking.overlap.ways if r.locking.overlap is not None else ())
                ],
                "beside": sorted({k for p in table.parts(r) for k in _beside(layout, p, shared)}),
                "hostile": [shared.group(how, others) for how, others in sorted(hostile.items())],
            }
        )
    return routes


_PROTECTS = {ProviderKind.SIGNAL: "signal", ProviderKind.BUFFER: "buffer", ProviderKind.BOUNDARY: "boundary"}
"""The elements on a plan that protect a flank, and are no points."""


def _beside(layout: Layout, r: RouteRow, shared: _Shared) -> Iterator[int]:
    """What a route needs that does not lie on its way: devices, points and whatever else protects its flanks, sections
    that must be clear."""
    for p in r.locking.points:
        device = p.machine in layout.machines.device
        if not (device or p.role in (Role.FLANK, Role.ADDED)):
            continue
        for kind, name, _, word in shown_by(layout.machines, p.machine, p.position):
            plain = kind == "point" and word in ("normal", "reverse")
            yield shared.needs(kind, name, "device" if device else "flank", str(p.position) if plain else word)
    for provider in (p for c in r.locking.flank for p in c.providers if p.kind in _PROTECTS):
        yield shared.needs(_PROTECTS[provider.kind], provider.name, "flank")
    clear = [*(c.section for c in r.clear.foul), *(c.section for c in r.clear.demanded or ())]
    for section in (*clear, *(c.name for c in r.clear.space if not c.lamp)):
        yield shared.needs("section", section, "foul")
