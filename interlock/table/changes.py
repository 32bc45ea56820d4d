"""What has changed from one table to another: routes that are gone, new or called otherwise, and of the others each
item of a cell, in the words of the printed columns."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

from interlock.dataclass import dataclass
from interlock.model.elements import RouteId
from interlock.table.cells import Because
from interlock.table.columns import COLUMNS, VOYAGE_COLUMNS, Column
from interlock.table.rows import InterlockingTable, RouteRow, VoyageRow

_OF_NAME = frozenset({"number", "route", "names", "entry", "exit", "hostile", "aspect"})
"""Columns in which routes may differ that are one route under two names: they name routes and signals."""
_TOLD_APART = frozenset({"number", "route"})
"""Columns that are told for all routes together."""
_YES_NO = {True: "yes", False: "no"}


@dataclass(frozen=True)
class Change:
    """What something was and what it is; None where there was or is none.

    because: why it is so in the new table, or, of what is gone, why it was so in the old one.
    """

    what: str
    was: str | None
    now: str | None
    because: Because | None = None

    @property
    def text(self) -> str:
        """In words: `Flank points: P3 N added`."""
        if self.was is None:
            return f"{self.what}: {self.now} added"
        return f"{self.what}: {self.was} removed" if self.now is None else f"{self.what}: {self.now}, was {self.was}"


@dataclass(frozen=True)
class RouteChange:
    """A route of both tables, by its name in the new one, with what is different of it; was: its name in the old one.

    number: its number in both tables, where they differ.
    """

    route: RouteId
    was: RouteId
    cells: tuple[Change, ...]
    number: tuple[int, int] | None


@dataclass(frozen=True)
class TableChanges:
    """What has changed from one table to another."""

    removed: tuple[RouteRow, ...]
    added: tuple[RouteRow, ...]
    routes: tuple[RouteChange, ...]
    voyages: tuple[Change, ...]
    automatic: tuple[Change, ...]

    @property
    def none(self) -> bool:
        """Whether no cell differs.  The number of a route is none of its own: it follows from the routes before it."""
        several = (self.removed, self.added, self.voyages, self.automatic)
        return not any(several) and not any(r.cells or r.was != r.route for r in self.routes)


def table_changes(old: InterlockingTable, new: InterlockingTable) -> TableChanges:
    """Compare two tables."""
    called = {r.id: r.id for r in old.routes if r.id in new.route} | _renamed(old, new)
    back = {now: was for was, now in called.items()}
    pairs = [(old.route[back[r.id]], r) for r in new.routes if r.id in back]
    found = (
        RouteChange(n.id, o.id, tuple(_cells(o, n, called)), (o.number, n.number) if o.number != n.number else None)
        for o, n in pairs
    )
    return TableChanges(
        removed=tuple(r for r in old.routes if r.id not in called),
        added=tuple(r for r in new.routes if r.id not in back),
        routes=tuple(c for c in found if c.cells or c.number or c.was != c.route),
        voyages=tuple(_voyages(old.voyages, new.voyages)),
        automatic=tuple(_automatic(old, new, called)),
    )


def named_changes(what: str, old: Mapping[str, Sequence[str]], new: Mapping[str, Sequence[str]]) -> list[Change]:
    """Things with a name and a description each: which are gone, new, or described otherwise."""
    out = [Change(what, _described(n, old[n]), None) for n in old if n not in new]
    out += [Change(what, None, _described(n, new[n])) for n in new if n not in old]
    for n in new:
        was, now = dict.fromkeys(old.get(n, ())), dict.fromkeys(new[n])
        if n not in old or was == now:
            continue
        gone, come = [x for x in was if x not in now], [x for x in now if x not in was]
        pairs = {come[0]: gone[0]} if len(gone) == len(come) == 1 else _paired(gone, come)
        out += _told(f"{what} {n}", gone, come, pairs)
    return out


def _described(name: str, parts: Sequence[str]) -> str:
    return f"{name} ({', '.join(parts)})" if parts else name


def _renamed(old: InterlockingTable, new: InterlockingTable) -> dict[RouteId, RouteId]:
    """Routes of which one of the other table, and one alone, differs in nothing but names."""

    def by_cells(one: InterlockingTable, other: InterlockingTable) -> dict[tuple[str, ...], list[RouteId]]:
        found: dict[tuple[str, ...], list[RouteId]] = {}
        for r in one.routes:
            if r.id not in other.route:
                found.setdefault(tuple(c.text(r) for c in COLUMNS if c.key not in _OF_NAME), []).append(r.id)
        return found

    before, after = by_cells(old, new), by_cells(new, old)
    alike = ((were, after.get(cells, ())) for cells, were in before.items())
    return {were[0]: now[0] for were, now in alike if len(were) == len(now) == 1}


def _cells(old: RouteRow, new: RouteRow, called: Mapping[RouteId, RouteId]) -> list[Change]:
    """Every item that one of two rows has and the other has not.

    A hostile route that is itself gone or new is told with the routes that are.
    """
    out = []
    names, kept = {str(was): now for was, now in called.items()}, {str(now): now for now in called.values()}
    before, after = names.get, kept.get
    for c in COLUMNS:
        if c.key in _TOLD_APART:
            continue
        if c.key == "hostile":
            was, now = _hostile(c, old, before), _hostile(c, new, after)
        else:
            was, now = c.items(old), c.items(new)
        out += _items(c.en, was, now)
    out += _items("Also hostile", _declared(old, before), _declared(new, after))
    if old.listed != new.listed:
        out.append(Change("Listed", _YES_NO[old.listed], _YES_NO[new.listed]))
    return out


def _declared(r: RouteRow, name: Callable[[str], RouteId | None]) -> list[tuple[str, Because]]:
    """What the author declares hostile although it is so for another reason, which is the one that its item names.
    Further reasons that are derived follow from what other cells tell."""
    named = {h.route: h.witness for h in r.locking.hostile}
    own = [(name(x.route), x.because) for x in r.locking.barred if named.get(x.route) != x.because.text]
    return sorted(((f"{other} ({why.text})", why) for other, why in own if other is not None), key=lambda x: x[0])


def _hostile(c: Column, r: RouteRow, name: Callable[[str], RouteId | None]) -> list[tuple[str, Because]]:
    """The items of the hostile routes that are in both tables, by their names in the new one."""
    out = []
    for (text, why), h in zip(c.items(r), r.locking.hostile, strict=True):
        other = name(h.route)
        if other is not None:
            out.append((f"{other}{text.removeprefix(h.route)}", why))
    return sorted(out, key=lambda item: item[0])  # in order of number, which may have changed


def _items(what: str, old: Sequence[tuple[str, Because]], new: Sequence[tuple[str, Because]]) -> list[Change]:
    was, now = dict(old), dict(new)
    if [*was] == [*now]:
        return []
    gone, come = [x for x in was if x not in now], [x for x in now if x not in was]
    if not gone and not come:
        return [Change(f"{what}, in order", ", ".join(was), ", ".join(now), next(iter(now.values())))]
    pairs = dict(zip(come, gone, strict=False)) if len(was) == len(now) == 1 else _paired(gone, come)
    return _told(what, gone, come, pairs, was | now)


def _told(
    what: str,
    gone: Sequence[str],
    come: Sequence[str],
    pairs: Mapping[str, str],
    why: Mapping[str, Because] | None = None,
) -> list[Change]:
    """What is another now, what is gone, what has come."""
    of = {} if why is None else why
    out = [Change(what, pairs[x], x, of.get(x)) for x in come if x in pairs]
    out += [Change(what, x, None, of.get(x)) for x in gone if x not in pairs.values()]
    return out + [Change(what, None, x, of.get(x)) for x in come if x not in pairs]


def _paired(gone: Sequence[str], come: Sequence[str]) -> dict[str, str]:
    """New items with the old ones that speak of the same: `P3 R` with `P3 N`."""

    def first(items: Sequence[str]) -> dict[str, list[str]]:
        found: dict[str, list[str]] = {}
        for x in items:
            found.setdefault(x.partition(" ")[0], []).append(x)
        return found

    before, after = first(gone), first(come)
    return {now[0]: before[word][0] for word, now in after.items() if len(now) == len(before.get(word, ())) == 1}


def _voyages(old: Sequence[VoyageRow], new: Sequence[VoyageRow]) -> list[Change]:
    def texts(voyages: Sequence[VoyageRow]) -> dict[str, list[str]]:
        shown = [c for c in VOYAGE_COLUMNS if c.key not in ("number", "voyage")]
        return {v.name: [f"{c.en}: {c.text(v)}" for c in shown if c.text(v)] for v in voyages}

    return named_changes("voyage", texts(old), texts(new))


def _automatic(old: InterlockingTable, new: InterlockingTable, called: Mapping[RouteId, RouteId]) -> list[Change]:
    was, now = [called.get(x, x) for x in old.automatic], new.automatic
    return named_changes("automatic working", dict.fromkeys(was, ()), dict.fromkeys(now, ()))
