"""Which goals share a local abstraction, so that one serves many of them and none is large.

**Theorem.**  Each goal is asked on its own, of lines that hold in the large system (`local.py`), so that any grouping
of goals is sound; grouping decides time, never a verdict.  (Weakening of premises.)
"""

from __future__ import annotations

from collections.abc import Iterable

from interlock.logic.expr import Expr
from interlock.logic.names import Kind, Name, Owner
from interlock.proof.abstraction.local import Focus, LocalAbstractions


def foci(local: LocalAbstractions, goals: Iterable[tuple[int, Expr]]) -> list[Focus]:
    """Foci of numbered goals; a goal that reads many routes and nothing else is in none.

    A goal's abstraction begins at the element that it names first, or last if it speaks of an overlap that lies ahead
    of it.  Goals that are far share none with those that are not.
    """
    whole: dict[tuple[Owner, bool], list[tuple[int, Expr]]] = {}
    pieces: dict[tuple[Owner, ...], dict[Expr, dict[int, list[int]]]] = {}
    named: dict[Expr, tuple[Owner, ...]] = {}
    for n, goal in goals:
        x = local.members.named(goal)
        names, members = local.members.read(x)
        if len({number for _, number in members}) == 1:
            number, parts = local.members.pieces(x)
            for part in parts:
                at = named.get(part)
                if at is None:
                    at = named[part] = _named(local, local.members.read(part)[0])
                here = pieces.setdefault(at or _of_route(local, part, number), {})
                here.setdefault(part, {}).setdefault(number, []).append(n)
            continue
        homes = [local.homes[v] for v in names if v in local.homes]
        if homes:
            ahead = any(h.kind is Kind.OVERLAP and homes[-1] not in local.beside.get(h, ()) for h in homes)
            home = homes[0 if ahead else -1]
            home = local.beside.get(home, (home,))[0]
            whole.setdefault((home, local.places.are_far(names)), []).append((n, x))
    found: list[Focus] = []
    each = {
        at: tuple((x, {i: tuple(ns) for i, ns in by.items()}) for x, by in exprs.items())
        for at, exprs in pieces.items()
    }
    for (home, far), those in whole.items():
        pieces_here = each.get((home,), ())
        if far:
            families = dict.fromkeys(f for x, _ in pieces_here for f in local.members.families(x))
            found.append(Focus((home,), tuple(those), far=True, families=tuple(families)))
        else:
            found.append(Focus((home,), tuple(those), pieces_here))
    shared = {f.homes for f in found if f.pieces}
    return [*found, *(Focus(at, pieces=those) for at, those in each.items() if at not in shared)]


def _named(local: LocalAbstractions, names: Iterable[Name]) -> tuple[Owner, ...]:
    """The elements to which names belong, in one order."""
    return tuple(sorted({local.homes[v] for v in names if v in local.homes}))


def _of_route(local: LocalAbstractions, piece: Expr, number: int) -> tuple[Owner, ...]:
    """The elements that the definitions of the route's variables read in a piece of a goal that reads none itself."""
    members = local.members
    families = (f for f in members.read(piece)[0] if f.indexed)
    return _named(local, (v for f in families for t in members.defining.get((f, number)) or () for v in t.names))
