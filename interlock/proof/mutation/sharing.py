"""Weakenings of track that is held as overlap: shared with what must not lie there, let go with the first holder, or
under a train."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations, permutations

from interlock.logic import names
from interlock.logic.controller import Controller
from interlock.logic.expr import FALSE, TRUE, Substitution, conj, disj, neg, var, variables
from interlock.logic.lower import lower
from interlock.model.elements import SectionId, SignalId
from interlock.model.layout import Layout
from interlock.model.shared_overlap import may_meet
from interlock.proof.mutation.points import with_values
from interlock.proof.mutation.ways import Mutant
from interlock.table.rows import InterlockingTable

Option = tuple[SignalId, int]


def overlap_flank_not_held(layout: Layout, table: InterlockingTable) -> Iterator[Mutant]:
    """A machine is held as flank protection of locked ways, not of overlaps."""
    c = lower(layout, table)
    put = Substitution(dict.fromkeys(c.symbols.overlaps.held.values(), FALSE))
    for e in c.equations:
        terms = [put(t.expr) if t.kind == "flank not held" else t.expr for t in e.terms]
        if e.name.family is names.MOVABLE and terms != [t.expr for t in e.terms]:
            yield e.name, with_values(c, False, {e.name: conj(terms)})


def beside_another(layout: Layout, table: InterlockingTable) -> Iterator[Mutant]:
    """An overlap is granted beside one that lies the other way, over other points, or from no signal on its way."""
    c = lower(layout, table)
    for a, b in permutations(c.symbols.overlaps.held, 2):
        if a[0] == b[0] or _meet(layout, c, a, b) or not _common(c, a, b):
            continue
        e = next(e for e in c.equations if e.name == names.OVERLAP_FREE(*a))
        put = Substitution({c.symbols.overlaps.held[b]: FALSE})
        terms = [put(t.expr) if t.kind == "overlap free" else t.expr for t in e.terms]
        yield f"{a[0]} {a[1]} beside {b[0]} {b[1]}", with_values(c, False, {e.name: conj(terms)})


def let_go_with_another(layout: Layout, table: InterlockingTable) -> Iterator[Mutant]:
    """An overlap is given up when another that is held over the same track is not needed any more."""
    c = lower(layout, table)
    for a, b in permutations(c.symbols.overlaps.held, 2):
        if _meet(layout, c, a, b):
            held, other = c.symbols.overlaps.held[a], c.symbols.overlaps.held[b]
            e = next(e for e in c.next if e.name == held)
            over = conj((var(other), var(names.OVERLAP_OVER(b[0]))))
            put = Substitution({names.OVERLAP_OVER(a[0]): disj((var(names.OVERLAP_OVER(a[0])), over))})
            terms = disj(put(t.expr) for t in e.terms)
            yield f"{a[0]} {a[1]} with {b[0]} {b[1]}", with_values(c, True, {held: terms})


def given_up_under_train(layout: Layout, table: InterlockingTable) -> Iterator[Mutant]:
    """An overlap in whose last section a train stands is given up though no route onward keeps it there, or it is not
    wholly in it."""
    c = lower(layout, table)
    for o, held in c.symbols.overlaps.held.items():
        *before, last = c.symbols.overlaps.ways[o]
        e = next(e for e in c.next if e.name == held)
        used = names.USED(last[0])
        if used not in variables(t.expr for t in e.terms):
            continue
        for what in (used, *(names.LONG_CLEAR(s) for s, _ in before)):
            put = Substitution({what: TRUE})
            yield f"{o[0]} {o[1]}: {what}", with_values(c, True, {held: disj(put(t.expr) for t in e.terms)})


def free_of_one(layout: Layout, table: InterlockingTable) -> Iterator[Mutant]:
    """A section over which two overlaps are held counts as free when one of them is given up."""
    c = lower(layout, table)
    for a, b in combinations(c.symbols.overlaps.held, 2):
        for s in _common(c, a, b) if _meet(layout, c, a, b) else ():
            e = next(e for e in c.equations if e.name == names.FREE(s))
            those = [neg(var(c.symbols.overlaps.held[o])) for o in (a, b)]
            terms = [t.expr for t in e.terms if t.expr not in those]
            yield f"{s}: {a[0]} {a[1]} and {b[0]} {b[1]}", with_values(c, False, {e.name: conj((*terms, disj(those)))})


def _meet(layout: Layout, c: Controller, a: Option, b: Option) -> bool:
    ways = c.symbols.overlaps.ways
    return bool(_common(c, a, b)) and may_meet(layout, (a[0], tuple(ways[a])), (b[0], tuple(ways[b])))


def _common(c: Controller, a: Option, b: Option) -> list[SectionId]:
    """The sections over which two overlaps lie."""
    one, other = ({s for s, _ in c.symbols.overlaps.ways[o]} for o in (a, b))
    return sorted(one & other)
