"""Voyages (航程): chains of routes that one command sets, and where two of them meet head-on (R18, document B 2.1).

A voyage is given once and opened route by route, by an operator or by `interlock.dispatch`; the controller knows
nothing of it.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from heapq import heapify, heappop, heappush
from itertools import groupby, islice

from interlock.diag import Element, Sink
from interlock.model.elements import Lane, RouteId, SectionId, SignalId, Voyage
from interlock.model.layout import Layout
from interlock.table.cells import Because, ExitKind, RouteKind, TraversalKey
from interlock.table.rows import Meeting, RouteRow, TraversalRow, VoyageRow

Locks = Mapping[TraversalKey, TraversalRow]


def priority(layout: Layout, sections: Collection[SectionId], forward: bool) -> int:
    """Document A: an inclined lane first, for the danger of runaways; then the main direction, for fewer stops."""
    inclined = any(s.lane is Lane.INCLINED and s.id in sections for s in layout.track.sections)
    return 1 + 2 * (not inclined) + (not forward)


def derive_voyages(layout: Layout, routes: tuple[RouteRow, ...], locks: Locks, sink: Sink) -> tuple[VoyageRow, ...]:
    """Every voyage as the chain of basic routes that makes it, and its meetings with the others."""
    chains: dict[str, tuple[RouteRow, ...]] = {}
    for v in layout.declared.voyages:
        chain = _chain(v, routes)
        if chain is None:
            kind = "shunt" if v.shunt else "train"
            reached = sorted({c[-1].exit for c in _chains(v, routes, one_of_each=True)})
            hint = f"from {v.entry} the {kind} routes lead to {', '.join(reached) or 'nowhere'}"
            text = f"no chain of {kind} routes makes voyage {v.name} to {v.exit}"
            sink.add("IL2013", text, None, hint, about=Element("voyages", v.name))
            continue
        chains[v.name] = chain
    ways = {n: [locks[k] for r in chain for k in r.path.traversals] for n, chain in chains.items()}
    rows: list[VoyageRow] = []
    for v in layout.declared.voyages:
        if v.name not in chains:
            continue
        meetings = [m for w in chains if w != v.name for m in _meetings(ways[v.name], w, ways[w])]
        order = "from the far end" if v.far_first else "each before its train"
        why = Because("R18", f"{len(chains[v.name])} routes from {v.entry} to {v.exit}, opened {order}")
        ids = tuple(r.id for r in chains[v.name])
        rank = priority(layout, {s for r in chains[v.name] for s in r.path.section_ids}, v.forward)
        rows.append(VoyageRow(v.name, len(rows) + 1, ids, v.far_first, rank, tuple(meetings), why))
    return tuple(rows)


_MOST_CHAINS = 20_000  # looked at, before only one of those that end with one route is followed


_Rank = tuple[int, float, tuple[int, ...]]


def _rank(c: tuple[RouteRow, ...]) -> _Rank:
    return sum(r.path.variant > 1 for r in c), sum(r.path.length for r in c), tuple(r.number for r in c)


def _chains(v: Voyage, routes: Sequence[RouteRow], one_of_each: bool = False) -> Iterator[tuple[RouteRow, ...]]:
    """Every chain of routes from the voyage's entry without a section twice: those with the fewest alternatives first,
    of these the short ones, then by number.  one_of_each: of those that end with one route, over the same of the
    sections that are wanted, only the first; they are few where all of them are more than can be listed."""
    kind = RouteKind.SHUNT if v.shunt else RouteKind.MAIN
    from_: dict[SignalId, list[RouteRow]] = {}
    for r in routes:
        if r.kind is kind and r.path.onward is None:  # past a signal a chain runs over routes that begin there
            from_.setdefault(r.entry, []).append(r)
    todo: list[tuple[_Rank, tuple[RouteRow, ...]]] = [(_rank((r,)), (r,)) for r in from_.get(v.entry, ())]
    heapify(todo)
    seen: set[tuple[RouteId, frozenset[SectionId]]] = set()
    while todo:
        chain = heappop(todo)[1]
        been = {s for r in chain for s in r.path.section_ids}
        at = chain[-1].id, frozenset(been & set(v.via))
        if one_of_each and at in seen:
            continue
        if one_of_each:
            seen.add(at)
        yield chain
        if chain[-1].path.exit_kind is ExitKind.SIGNAL:
            for r in from_.get(SignalId(chain[-1].exit), ()):
                if been.isdisjoint(r.path.section_ids):
                    longer: tuple[RouteRow, ...] = (*chain, r)
                    heappush(todo, (_rank(longer), longer))


def _chain(v: Voyage, routes: Sequence[RouteRow]) -> tuple[RouteRow, ...] | None:
    """The chain with the fewest alternatives, then the shortest, then the first by number."""
    every = _chains(v, routes)
    found = next((c for c in islice(every, _MOST_CHAINS) if _fits(v, c)), None)
    if found is not None or next(every, None) is None:
        return found
    return next((c for c in _chains(v, routes, one_of_each=True) if _fits(v, c)), None)


def _fits(v: Voyage, c: tuple[RouteRow, ...]) -> bool:
    ends = v.exit in (c[-1].exit, c[-1].path.section_ids[-1])
    return ends and set(v.via) <= {s for r in c for s in r.path.section_ids}


def _meetings(mine: Sequence[TraversalRow], other: str, theirs: Sequence[TraversalRow]) -> Iterator[Meeting]:
    """The single lines that another voyage uses the other way round: common sections in a row, one of them opposed."""
    their = {t.section: t for t in theirs}
    for common, run in groupby(mine, lambda t: t.section in their):
        single = tuple(run)
        if common and any(_opposed(t, their[t.section]) for t in single):
            sections = tuple(t.section for t in single)
            yield Meeting(other, sections, Because("R18", f"{other} runs over {', '.join(sections)} the other way"))


def _opposed(t: TraversalRow, u: TraversalRow) -> bool:
    return t.entry == u.exit or t.exit == u.entry
