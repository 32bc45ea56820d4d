"""What a shift is run on: a layout with its runtime as emitted, and the fleet, places and orders of a dispatch file."""

from __future__ import annotations

from collections.abc import Mapping
from functools import lru_cache
from typing import Any

from interlock.app.check import Checked, derive_file
from interlock.dataclass import dataclass
from interlock.diag import Diagnostic, Sink
from interlock.dispatch.language import Orders, beside, load
from interlock.dispatch.orders import Derivation, Derived
from interlock.dispatch.plan.errands import OUTSIDE
from interlock.dispatch.plan.railway import Railway
from interlock.emit.python.runtime import runtime_py
from interlock.logic.lower import lower
from interlock.logic.symbols import Symbols
from interlock.model.elements import BlockKind, Boundary, BoundaryKind, RouteId, SectionId
from interlock.model.layout import Layout
from interlock.model.portable import portable
from interlock.simulate.run import load as load_runtime
from interlock.simulate.track import Track

CYCLE_MS = 500
"""Milliseconds from scan to scan of a shift."""


@dataclass(frozen=True)
class Setting:
    """All that shifts on one layout with one dispatch file share."""

    layout: Layout
    railway: Railway
    symbols: Symbols
    names: Mapping[str, Any]
    track: Track
    orders: Orders
    derived: tuple[Derived, ...]
    release: Mapping[SectionId, str]
    confirms: tuple[str, ...]
    shut: frozenset[RouteId] = frozenset()
    """Routes that need something blocked: none of them is ever set in this shift."""

    @property
    def blocked(self) -> tuple[SectionId, ...]:
        """Sections closed to trains in this shift."""
        at, known = self.orders.file.closed, self.symbols.sections.blocked
        return tuple(s.id for s in self.layout.track.sections if s.id in at and s.id in known)

    def heading(self, seed: int, hours: float) -> dict[str, Any]:
        """The first event of a shift."""
        file = self.orders.file
        return {
            "what": "shift",
            "layout": self.layout.name,
            "layout_digest": self.layout.digest,
            "seed": seed,
            "hours": hours,
            "fleet": {n: {"length": t.length, "tonnes": t.tonnes} for n, t in file.fleet.items()},
            "places": {n: {"kind": p.kind, "at": p.at, "capacity": p.capacity} for n, p in file.places.items()},
            "orders": {d.name: {"trains": d.trains, "ore": d.order.ore or ""} for d in self.derived},
            "metres": distances(self.layout),
            "main": longest(self.layout),
        }


def _first(layout: Layout) -> tuple[Boundary, ...]:
    """The first boundary over which trains come in; none where there is none."""
    return tuple(b for b in layout.track.boundaries if b.kind is not BoundaryKind.OUT)[:1]


def _metres(layout: Layout) -> tuple[dict[str, float], dict[str, str]]:
    """By node: metres from the first boundary along the shortest way, and the node before it."""
    at = {str(b.node): 0.0 for b in _first(layout)}
    before: dict[str, str] = {}
    todo = list(at)
    while todo:
        node = min(todo, key=lambda n: at[n])
        todo.remove(node)
        for e in layout.track.edges_at[node]:  # type: ignore[index]
            far = str(e.b if e.a == node else e.a)
            if at[node] + e.length < at.get(far, float("inf")):
                at[far], before[far] = at[node] + e.length, node
                todo.append(far)
    return at, before


def longest(layout: Layout) -> list[str]:
    """The sections on the way from the first boundary, with its approach section, to the place that is farthest."""
    at, before = _metres(layout)
    if not at:
        return []
    node = max(at, key=lambda n: (at[n], n))
    found: dict[str, None] = {}
    while node in before:
        joined = next(e for e in layout.track.edges_at[node] if before[node] in (e.a, e.b))  # type: ignore[index]
        found[str(joined.section)] = None
        node = before[node]
    approach = [str(b.approach) for b in _first(layout) if b.approach is not None]
    return [*approach, *reversed(found)]


def distances(layout: Layout) -> dict[str, list[float]]:
    """By section: metres from the first boundary to where it begins and where it ends, along the shortest way."""
    at, _ = _metres(layout)
    found: dict[str, list[float]] = {}
    for e in layout.track.edges:
        ends = sorted(at.get(str(n), 0.0) for n in (e.a, e.b))
        low, high = found.get(str(e.section), ends)
        found[str(e.section)] = [min(low, ends[0]), max(high, ends[1])]
    for b in layout.track.boundaries:
        if b.approach is not None:
            here = at.get(str(b.node), 0.0)
            metres = b.approach_m or 400.0
            found[str(b.approach)] = [here - metres, here] if here == 0.0 else [here, here + metres]
    return {s: [round(a, 1), round(b, 1)] for s, (a, b) in sorted(found.items())}


def prepare(
    path: str, file: str | None = None
) -> tuple[Checked, tuple[Diagnostic, ...], Setting | None, Mapping[str, str]]:
    """A layout and its dispatch file (by default that beside it), or what is wrong with them; the texts of both."""
    checked = derive_file(path)
    texts = dict(checked.source.texts)
    if not checked.ok or checked.layout is None or checked.table is None:
        return checked, checked.diagnostics, None, texts
    layout, sink = checked.layout, Sink()
    orders = load(file or beside(path), layout, sink, texts)
    if orders is None:
        return checked, sink.diagnostics, None, texts
    railway = Railway(checked.table, layout)
    derivation = Derivation(railway, orders, sink)
    derived = derivation.run()
    _simulable(orders, layout, derived, sink)
    if sink.has_errors:
        return checked, sink.diagnostics, None, texts
    controller = lower(layout, checked.table)
    names = load_runtime(runtime_py(controller, []))
    release = {s.id: n for s in layout.track.sections if (n := f"REL_{portable(s.id)}") in names["INPUTS"]}
    confirms = tuple(n for n in names["INPUTS"] if n.startswith("TC_"))
    on = railway, controller.symbols, names, Track.of(layout)
    return checked, (), Setting(layout, *on, orders, derived, release, confirms, derivation.shut), texts


def _simulable(orders: Orders, layout: Layout, derived: tuple[Derived, ...], sink: Sink) -> None:
    """Trains begin and end outside; a neighbour with a direction token is not simulated."""
    if sink.has_errors:
        return
    if not derived:
        sink.add(
            "IL6003", "there is nothing to do in this shift", orders.root.span, "add `fleet`, `places` and `orders`"
        )
    for d in derived:
        for key, name in (("from", d.order.from_), ("to", d.order.to)):
            at, inside = orders.file.places[name].at, key == "from"
            if any(str(s.id) == at for s in layout.track.sections) != inside:
                where = "inside the layout" if inside else "beyond a boundary"
                text = f"in a simulated shift {name} must lie {where}"
                sink.add("IL6012", text, orders.at("orders", d.name, key), "see the page of shifts")
    for name in dict.fromkeys(n for d in derived for n in (d.order.from_, d.order.to)):
        if orders.file.places[name].minutes is None:
            place = orders.at("places", name, key=True)
            sink.add("IL6003", f"{name} does not say how long a train is there", place, "add `minutes`")
    for number in orders.file.fleet:
        if any(j.errand.start[0][1] != OUTSIDE for d in derived for n, j in d.journeys.items() if n == number):
            text = f"in a simulated shift train {number} must wait outside a boundary"
            sink.add("IL6012", text, orders.at("fleet", number, "at"), "see the page of shifts")
    for b in layout.track.boundaries:
        if b.block is BlockKind.TOKEN:
            text = f"a direction token is exchanged at {b.node}: on such lines no shift is simulated"
            sink.add("IL6012", text, orders.root.span, "leave out `block: token` in a copy of the layout")


@lru_cache(maxsize=8)
def prepared(path: str, file: str | None) -> Setting:
    """The same, once for all shifts of a process.  Raises `ValueError` where something is wrong."""
    _, problems, setting, _ = prepare(path, file)
    if setting is None:
        raise ValueError("; ".join(f"{d.code} {d.message}" for d in problems))
    return setting
