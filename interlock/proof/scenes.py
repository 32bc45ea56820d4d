"""Which goals are looked at together, so that one view serves many of them and none is large."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from interlock.logic.expr import Expr
from interlock.proof.members import OF, Member
from interlock.proof.views import Scene, Views

PATHS = 8  # goals about the paths from one signal are taken so many paths at a time


def scenes(views: Views, goals: Iterable[tuple[int, Expr, bool]], rings: int) -> list[Scene]:
    """Scenes of numbered goals; a goal that reads many routes and nothing else is in none.

    With each goal whether it is a part of the induction.  Far around the goals, claims that read many routes now are
    left out: their views are not small.
    """
    whole: dict[str, list[tuple[int, Expr]]] = {}
    shown: dict[object, list[tuple[int, Expr]]] = {}
    pieces: dict[tuple[str, ...], dict[Expr, dict[int, list[int]]]] = {}
    for n, goal, step in goals:
        x = views.members.named(goal)
        names, members = views.members.read(x)
        homes = [views.homes[v] for v in names if v in views.homes]
        if len({number for _, number in members}) == 1:
            number, parts = views.members.pieces(x)
            for part in parts:
                near = pieces.setdefault(_homes(views, part, number), {})
                near.setdefault(part, {}).setdefault(number, []).append(n)
        elif not step and any(f in views.family_before for f, _ in members):
            shown.setdefault(_shown(views, names, members), []).append((n, x))
        elif homes and (rings == 1 or step or not members):
            home = views.system.beside.get(homes[0], homes)[0]
            whole.setdefault(home, []).append((n, x))
    found = [Scene((home,), tuple(those)) for home, those in whole.items()]
    for key, those in shown.items():
        few = [those] if isinstance(key, str) else _by_path(views, those)
        found += [Scene(_beside(views, some), tuple(some), after=rings == 1) for some in few]
    for at, exprs in pieces.items():
        each = tuple((x, {i: tuple(ns) for i, ns in by.items()}) for x, by in exprs.items())
        found.append(Scene(at, pieces=each))
    return found


def _shown(views: Views, names: Iterable[str], members: Iterable[Member]) -> object:
    """What claims about shown signals have in common: a name that reads routes itself, or a signal's first route."""
    for v in names:
        if views.before.get(v) not in views.kept and views.reads_routes(v):
            return v
    return min(of for of in members if of[0] in views.family_before)


def _homes(views: Views, piece: Expr, number: int) -> tuple[str, ...]:
    """The elements that a piece of a goal reads; where it reads none, those that the definitions of the route's
    variables read in it."""
    read = views.members.read(piece)[0]
    names: list[str] = [v for v in read if v[0] != OF]
    if not any(v in views.homes for v in names):
        for f in read:
            for trait in (views.members.defining.get((f[1:], number)) if f[0] == OF else None) or ():
                names += trait.names
    return tuple(dict.fromkeys(views.homes[v] for v in names if v in views.homes))


def _beside(views: Views, goals: Iterable[tuple[int, Expr]]) -> tuple[str, ...]:
    """The elements of which those are parts that goals read."""
    homes = dict.fromkeys(views.homes[v] for _, x in goals for v in views.members.read(x)[0] if v in views.homes)
    return tuple(dict.fromkeys(s for h in homes for s in views.system.beside.get(h, ())))


def _by_path(views: Views, goals: Sequence[tuple[int, Expr]]) -> list[list[tuple[int, Expr]]]:
    """Goals by the elements that they read, some paths that begin alike at a time."""
    paths: dict[tuple[str, ...], list[tuple[int, Expr]]] = {}
    for n, x in goals:
        names = views.members.read(x)[0]
        at = tuple(dict.fromkeys(h for v in names if (h := views.homes.get(v, "")).startswith("point ")))
        paths.setdefault(at, []).append((n, x))
    order = sorted(paths)
    return [[g for at in order[k : k + PATHS] for g in paths[at]] for k in range(0, len(order), PATHS)]
