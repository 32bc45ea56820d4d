"""Facts of two layouts that differ, and that nothing else which is told of them shows."""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Collection, Iterator, Mapping
from typing import Any

from interlock.model.layout import Layout
from interlock.table.changes import TableChanges

PRINTED = frozenset({"title", "title_block", "labels", "drawing", "anchors"})
"""Facts of a layout that are only printed: titles, what is written at boundaries, places on the plan."""
REASONED = frozenset({"excluded", "barred", "demanded", "waivers"})
"""Facts that come each with the author's `reason`."""

_RULES = frozenset({"principles", "profile"})
"""Facts that are compared whole, and told."""
_OWN = {"edges": "section", "boundaries": "node", "buffers": "node", "points": "id", "blades": "point"}
"""Facts of elements that are told by the name of the element: where in each it stands, if not as `id`."""
_OF_ELEMENTS = frozenset(
    {"sections", "edges", "boundaries", "buffers", "points", "crossings", "blades", "hands", "supervision"}
    | {"signals", "distants", "devices", "conditions", "boards", "stops", "identifiers", "signal_releases"}
    | {"overlaps", "overlap_ways", "overlap_bars", "overlap_releases", "entry_speeds", "zones", "no_berths"}
)

_OF_ROUTES: Mapping[str, Callable[[TableChanges], bool]] = {
    "voyages": lambda t: bool(t.voyages),
    "automatic": lambda t: bool(t.automatic),
    "named_routes": lambda t: any(c.what == "Name" for r in t.routes for c in r.cells),
    "unlisted": lambda t: any(c.what == "Listed" for r in t.routes for c in r.cells),
}
"""Facts of routes, and whether anything is told of them."""


def untold(
    old: Layout, new: Layout, table: TableChanges, elements: Collection[str]
) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """The facts in which two layouts differ beside what is told: those that may matter, and those that are only
    printed.  `elements`: the names of those of which something is told."""
    if old.digest == new.digest:
        return (), ()
    was, now = json.loads(old.to_text()), json.loads(new.to_text())
    differ = sorted(k for k in was.keys() | now.keys() if was.get(k) != now.get(k))
    printed = tuple(k for k in differ if k in PRINTED or _for_reasons(k, was.get(k), now.get(k)))
    told = _Told(table, frozenset(elements))
    return tuple(k for k in differ if k not in printed and not told.is_told(k, was.get(k), now.get(k))), printed


def _for_reasons(key: str, was: Any, now: Any) -> bool:
    """Whether nothing but the reasons that the author gives is different."""
    if key not in REASONED or was is None or now is None:
        return False
    before, after = ([{k: v for k, v in x.items() if k != "reason"} for x in facts] for facts in (was, now))
    return before == after


class _Told:
    """What is told of table and elements."""

    def __init__(self, table: TableChanges, elements: frozenset[str]) -> None:
        self._table, self._elements = table, elements
        cells = [c for r in table.routes for c in r.cells]
        self._said = [f"{c.text} {c.because.text if c.because else ''}" for c in cells]
        self._said += [str(why) for r in (*table.added, *table.removed) for why in _reasons(r)]

    def is_told(self, key: str, was: Any, now: Any) -> bool:
        """Whether a fact differs in nothing but what is told."""
        if key in _RULES:
            return True
        if key in _OF_ROUTES:
            return _OF_ROUTES[key](self._table)
        pairs = list(_pairs(was or (), now or ()))
        if key in REASONED - {"excluded"}:
            reasons = [x["reason"] for pair in pairs for x in pair if x is not None]
            return bool(reasons) and all(any(why in said for said in self._said) for why in reasons)
        return key in _OF_ELEMENTS and bool(pairs) and all(self._of_told(key, x, y) for x, y in pairs)

    def _of_told(self, key: str, was: Any, now: Any) -> bool:
        """Whether an item of a fact belongs to an element of which something is told, or differs in names of such."""
        items = [x for x in (was, now) if x is not None]
        if isinstance(items[0], Mapping):
            own = {str(x.get(_OWN.get(key, "id"), x.get("signal"))) for x in items}
            fields = {k for k in {**items[0], **items[-1]} if len(items) == 1 or was.get(k) != now.get(k)}
            differ = [x.get(k) for x in items for k in fields]
        else:
            own, differ = {str(x[0] if isinstance(x, list) else x) for x in items}, items
        return bool((own | set(_names(differ))) & self._elements)


def _reasons(r: Any) -> Iterator[str]:
    """Why a route is hostile to others by the author's word, and what he has it lock and find clear."""
    yield from (b.because.text for b in r.locking.barred)
    yield from (p.because.text for p in r.locking.added)
    yield from (c.because.text for c in r.clear.demanded or ())


def _pairs(was: Any, now: Any) -> Iterator[tuple[Any, Any]]:
    """Items that differ: each as it was and as it is, None where there is none."""

    def by_key(items: Any) -> dict[str, Any]:
        found: dict[str, Any] = {}
        for x in items:
            name = x.get("id", x.get("node")) if isinstance(x, Mapping) else None
            found[str(name) if name is not None else json.dumps(x, sort_keys=True)] = x
        return found

    before, after = by_key(was), by_key(now)
    for k in {**before, **after}:
        if before.get(k) != after.get(k):
            yield before.get(k), after.get(k)


def _names(value: Any) -> Iterator[str]:
    """The names in a value: nodes at joints are called by the sections that meet there."""
    if isinstance(value, str):
        yield value
        yield from re.split(r"[|@+]|\.(?=\w+$)", value)
    elif isinstance(value, Mapping):
        for x in value.values():
            yield from _names(x)
    elif isinstance(value, (list, tuple)):
        for x in value:
            yield from _names(x)
