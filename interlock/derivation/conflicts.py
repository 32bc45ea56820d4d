"""Hostile routes with class, witness and reason (R6).

Two routes are hostile when they cannot be set together: they share a section, need a machine in two
positions, cross on a diamond, or foul each other.  The first class that applies names the reason.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from functools import partial
from itertools import chain, product

from interlock.dataclass import dataclass
from interlock.derivation.added import Barred
from interlock.derivation.routes import Path
from interlock.model.bits import bits_of
from interlock.model.elements import MachineId, Position, RouteId, SectionId, SignalId
from interlock.model.layout import Layout
from interlock.model.shared_overlap import Ways, may_meet, shared_from
from interlock.model.traversal import Traversal
from interlock.table.cells import (
    Because,
    Hostile,
    HostileClass,
    HostileRoutes,
    Hostility,
    PointDemand,
    Role,
    RouteKind,
    TraversalKey,
)
from interlock.table.rows import TraversalRow


class Conflicts:
    """Which routes are hostile, and why."""

    def __init__(
        self,
        layout: Layout,
        paths: Sequence[Path],
        locks: Mapping[TraversalKey, TraversalRow],
        demands: Mapping[RouteId, Sequence[PointDemand]],
        barred: Barred,
    ) -> None:
        """Paths in order of number.  barred: for each route those that the author declares hostile."""
        self._layout, self._locks = layout, locks
        self._path = {p.id: p for p in paths}
        self._needs = _needs(paths, demands)
        self._ids = [p.id for p in paths]
        self._barred = _with_parts(paths, barred)
        self.derived = dict(zip(self._ids, _hostile(layout, paths, locks, self._needs), strict=True))
        """For each route the hostile ones but for those that are only declared so, as bits by number less one."""
        self._hostile = dict(self.derived)
        self._told: dict[tuple[RouteId, RouteId], Hostility] = {}
        self._alike: dict[Hostility, Hostility] = {}
        for r, cells in self._barred.items():
            for other in cells:
                self._hostile[r] |= 1 << self._path[other].number - 1

    def between_parts(self, path: Path, onward: Path) -> str | None:
        """Why a route that leads past a signal is hostile to what it locks beyond it; None where it is not."""
        declared = self._barred.get(path.id, {}).get(onward.id)
        if declared is not None:
            return declared.text
        as_train = replace(onward, kind=RouteKind.MAIN)
        held = {t.section for t in path.overlap}  # all at once: past the next signal nothing is shared
        meets = [f"both need {t.section} as overlap" for t in onward.overlap if t.section in held]
        if onward.entry != path.exit:
            meets += [f"{t.section} is the overlap of {{one}}" for t in onward.ways if t.section in held]
        told = reasons(self._layout, replace(path, onward=None), as_train, self._locks, self._needs)
        found = next(chain((x[1] for x in told), meets), None)
        return None if found is None else found.format(one=path.id, other=onward.id)

    def bits(self, route: RouteId) -> int:
        """The hostile routes of a route, as bits by number less one."""
        return self._hostile[route]

    def of(self, path: Path) -> HostileRoutes:
        """The hostile routes of a route."""
        return HostileRoutes(self._ids, self._hostile[path.id], partial(self.tell, path.id))

    def tell(self, one: RouteId, other: RouteId) -> Hostile:
        """Why a route is hostile to another."""
        first = self._path[one].number < self._path[other].number
        return Hostile(one, other, first, self._how(*((one, other) if first else (other, one))))

    def _how(self, a: RouteId, b: RouteId) -> Hostility:
        """How a pair is hostile, the route of the lower number first."""
        if (a, b) not in self._told:
            parts = [self._path[a].parts, self._path[b].parts]
            found = [x for p, q in product(*parts) for x in reasons(self._layout, p, q, self._locks, self._needs)]
            found.sort(key=lambda x: list(HostileClass).index(x[0])) if len(parts[0]) + len(parts[1]) > 2 else None
            declared = self._barred.get(a, {}).get(b)
            if declared is not None:
                found.append((HostileClass.ADDED, _written(declared.text), "R6"))
            kind, witness, rule = found[0]
            how = Hostility(kind, tuple(dict.fromkeys(k for k, _, _ in found)), witness, rule)
            self._told[a, b] = self._alike.setdefault(how, how)
        return self._told[a, b]


def _with_parts(paths: Sequence[Path], barred: Barred) -> dict[RouteId, dict[RouteId, Because]]:
    """For each route those that are declared hostile to it, or to what is set with it past signals."""
    having: dict[RouteId, list[Path]] = {}
    for p in paths:
        for part in p.parts:
            having.setdefault(part.id, []).append(p)
    found = {r: {c.route: c.because for c in cells} for r, cells in barred.items()}
    for r, cells in barred.items():
        for c in cells:
            for p, q in product(having[r], having[c.route]):
                if p not in q.parts and q not in p.parts:
                    found.setdefault(p.id, {}).setdefault(q.id, c.because)
    return found


def set_apart(
    layout: Layout,
    paths: Sequence[Path],
    locks: Mapping[TraversalKey, TraversalRow],
    demands: Mapping[RouteId, Sequence[PointDemand]],
) -> list[int]:
    """For each route those that cannot be set together with it, as bits; paths in order of number."""
    return _hostile(layout, paths, locks, _needs(paths, demands))


def _needs(paths: Sequence[Path], demands: Mapping[RouteId, Sequence[PointDemand]]) -> dict[RouteId, Needs]:
    return {
        p.id: Needs(
            {t.section: t for t in p.ways},
            _positions(demands[p.id], (Role.PATH,)),
            _positions(demands[p.id], _HELD),
            {d.machine: d for d in demands[p.id] if d.role is Role.ADDED},
        )
        for p in paths
    }


def _hostile(
    layout: Layout,
    paths: Sequence[Path],
    locks: Mapping[TraversalKey, TraversalRow],
    needs: Mapping[RouteId, Needs],
) -> list[int]:
    """For each route the hostile ones, as bits: those pairs of which `classify` tells a class."""
    users = _Users(layout, paths, needs)
    both = [users.alike(p, needs[p.id]) & ~(1 << i) for i, p in enumerate(paths)]
    found = list(both)
    for i, p in enumerate(paths):  # what one of a pair says of the other, the first of what it excludes
        told = users.of_overlap(p, locks) | users.excluded(p, locks) >> (i + 1) << (i + 1)
        found[i] |= told & ~(1 << i)
        for j in bits_of(told & ~both[i] & ~(1 << i)):
            found[j] |= 1 << i
    return _led_on(paths, found)


def _led_on(paths: Sequence[Path], found: list[int]) -> list[int]:
    """A route that leads past signals is hostile to all that is hostile to what it locks beyond them, not to that."""
    for p in (p for p in paths if p.onward is not None):
        i, beyond = p.number - 1, [q.number - 1 for q in p.parts[1:]]
        for k in beyond:
            found[i] |= found[k]
        for j in bits_of(found[i]):
            found[j] |= 1 << i
    for p in paths:
        for i, q in product([p.number - 1], p.parts):
            found[i] &= ~(1 << q.number - 1)
            found[q.number - 1] &= ~(1 << i)
    return found


class _Users:
    """By what it uses, the routes that do, as bits."""

    def __init__(self, layout: Layout, paths: Sequence[Path], needs: Mapping[RouteId, Needs]) -> None:
        self._layout = layout
        self._lying: dict[SectionId, dict[tuple[SignalId, Ways], None]] = {}
        """By section the overlaps that lie over it."""
        self._of_overlap: dict[tuple[SignalId, Ways], int] = {}
        by: dict[object, int] = {}
        for i, p in enumerate(paths):
            uses: list[object] = [("from", p.entry)]
            uses += [("train from", p.entry)] if p.kind is RouteKind.MAIN else []
            uses += [x for t in p.ways for x in (("path", t.section), ("path", t.key))]
            uses += [x for t in p.overlap for x in (("overlap", t.section), ("overlap", t.key))]
            uses += [("lies", m, x) for m, x in needs[p.id].path.items()]
            uses += [("held", m, x) for m, x in needs[p.id].held.items()]
            uses += [("whole overlap", _held_beyond(p))] if p.overlap else []
            for t in p.overlap:
                self._lying.setdefault(t.section, {})[_held_beyond(p)] = None
            for use in uses:
                by[use] = by.get(use, 0) | 1 << i
        self._by = by

    def _any(self, *uses: object) -> int:
        found = 0
        for use in uses:
            found |= self._by.get(use, 0)
        return found

    def alike(self, p: Path, needs: Needs) -> int:
        """Those that share its entry or a section of its path, or want its points to lie otherwise."""
        found = self._any(("from", p.entry))
        found |= self._any(*(("lies", m, x.other) for m, x in needs.path.items()))
        found |= self._any(*(("held", m, x.other) for m, x in needs.held.items()))
        return found | self._any(*(("path", t.section) for t in p.ways))

    def excluded(self, p: Path, locks: Mapping[TraversalKey, TraversalRow]) -> int:
        """Those over ways that its path excludes."""
        return self._any(*(("path", x) for t in p.ways for x in _excluded(locks[t.key])))

    def of_overlap(self, p: Path, locks: Mapping[TraversalKey, TraversalRow]) -> int:
        """Those that are hostile to the overlap of a route."""
        own = _held_beyond(p)
        if own not in self._of_overlap:
            self._of_overlap[own] = self._hostile_to(p, own, locks) if p.overlap else 0
        return self._of_overlap[own]

    def _hostile_to(self, p: Path, own: tuple[SignalId, Ways], locks: Mapping[TraversalKey, TraversalRow]) -> int:
        found, shared = 0, shared_from(self._layout, *own)
        for t in p.overlap:
            from_ = self._any(*(("train from", g) for g, ways in shared.items() if t.key in ways))
            onward = from_ & self._any(("path", t.key))
            found |= self._any(("path", t.section)) & ~onward
            others = (o for o in self._lying[t.section] if not may_meet(self._layout, own, o))
            found |= self._any(*(("whole overlap", o) for o in others))
            for x in _excluded(locks[t.key]):
                found |= self._any(("path", x), ("overlap", x))
        return found


def _held_beyond(p: Path) -> tuple[SignalId, Ways]:
    """The overlap of a route: its signal, and its ways."""
    return SignalId(p.exit), tuple(t.key for t in p.overlap)


def _excluded(lock: TraversalRow) -> Iterator[object]:
    """The sections and ways that a lock excludes."""
    for ex in lock.exclusions:
        yield from (ex.section,) if ex.whole else ((ex.section, number) for number in ex.numbers)


_HELD = (Role.FLANK, Role.PATH, Role.OVERLAP, Role.ADDED, Role.DEVICE)


def _positions(demands: Sequence[PointDemand], roles: tuple[Role, ...]) -> dict[MachineId, Position]:
    return {d.machine: d.position for d in demands if d.role in roles}


@dataclass(frozen=True)
class Needs:
    """The ways of a route by section, and how machines lie for it: those of its path, and all that it holds; which of
    these the author demands."""

    ways: Mapping[SectionId, Traversal]
    path: Mapping[MachineId, Position]
    held: Mapping[MachineId, Position]
    added: Mapping[MachineId, PointDemand]


Reason = tuple[HostileClass, str, str]
"""Class, witness (`{one}` and `{other}`: the pair, as in `Hostility`) and rule."""


def classify(
    layout: Layout, a: Path, b: Path, locks: Mapping[TraversalKey, TraversalRow], needs: Mapping[RouteId, Needs]
) -> Reason | None:
    """Class, witness and rule of a hostile pair, the first in the order of R6; None when both may be set together."""
    return next(reasons(layout, a, b, locks, needs), None)


def reasons(
    layout: Layout, a: Path, b: Path, locks: Mapping[TraversalKey, TraversalRow], needs: Mapping[RouteId, Needs]
) -> Iterator[Reason]:
    """All that makes a pair hostile, in the order in which a reason is named; a class may come more than once."""
    if a.entry == b.entry:
        yield HostileClass.SAME_ENTRY, f"both begin at {a.entry}", "R6.5"
    path_a, path_b = needs[a.id].path, needs[b.id].path
    for m, x in path_a.items():
        if path_b.get(m, x) is not x:
            yield HostileClass.POINTS, f"machine {m} lies {x} for {{one}} and {path_b[m]} for {{other}}", "R6.1"
    yield from _shared(a, needs[b.id].ways)
    yield from sorted(_excluding(a, b, locks), key=lambda x: x[0] is HostileClass.FOUL)
    overlap = _overlap(layout, a, b, locks, "{one}") or _overlap(layout, b, a, locks, "{other}")
    if overlap is not None:
        yield overlap
    all_a, all_b = needs[a.id].held, needs[b.id].held
    for m, x in all_a.items():
        if all_b.get(m, x) is not x and not (m in path_a and m in path_b):
            demand = needs[a.id].added.get(m) or needs[b.id].added.get(m)
            if demand is not None:
                yield HostileClass.ADDED, _written(f"{m} {demand.position} is {demand.because.text}"), "R6"
                continue
            yield HostileClass.FLANK, f"machine {m} must lie {x} for {{one}} and {all_b[m]} for {{other}}", "R6.9"


def _excluding(a: Path, b: Path, locks: Mapping[TraversalKey, TraversalRow]) -> Iterator[Reason]:
    """The ways of b that those of a exclude: on a diamond, or at a foul joint."""
    for t in a.ways:
        for ex in locks[t.key].exclusions:
            for o in b.ways:
                if o.section == ex.section and (ex.whole or o.number in ex.numbers):
                    kind = HostileClass.CROSSING if ex.because.rule == "R6" else HostileClass.FOUL
                    rule = "R6.4" if kind is HostileClass.CROSSING else "R6.10"
                    yield kind, f"{t.section} and {o.section}: {ex.because.text}", rule


def _written(text: str) -> str:
    """The author's words within a witness."""
    return text.replace("{", "{{").replace("}", "}}")


def _overlap(layout: Layout, a: Path, b: Path, locks: Mapping[TraversalKey, TraversalRow], of: str) -> Reason | None:
    """The overlap of a (named as `of`) against the path and overlap of b; what leads on over the same ways, from a's
    exit or from a signal past which the overlap leads, may lie there, too."""
    onward = shared_from(layout, *_held_beyond(a)).get(b.entry, ()) if a.overlap and b.kind is RouteKind.MAIN else ()
    meets = a.overlap and b.overlap and may_meet(layout, _held_beyond(a), _held_beyond(b))
    for t in a.overlap:
        for o in b.overlap:
            if o.section == t.section and not meets:
                return HostileClass.OVERLAP, f"both need {t.section} as overlap", "R6.8"
        for o in b.ways:
            if o.section == t.section and not (o.key == t.key and o.key in onward):
                return HostileClass.OVERLAP, f"{t.section} is the overlap of {of}", "R6.7"
        for ex in locks[t.key].exclusions:
            for o in (*b.ways, *b.overlap):
                if o.section == ex.section and (ex.whole or o.number in ex.numbers):
                    return HostileClass.OVERLAP, f"overlap {t.section} and {o.section}: {ex.because.text}", "R6.7"
    return None


def _shared(a: Path, of_b: Mapping[SectionId, Traversal]) -> Iterator[Reason]:
    ways: dict[HostileClass, list[SectionId]] = {}
    for t in a.ways:
        if t.section in of_b:
            ways.setdefault(_meeting(t, of_b[t.section]), []).append(t.section)
    for kind, rule, told in (
        (HostileClass.OPPOSING, "R6.2", "opposite directions in {}"),
        (HostileClass.CONVERGING, "R6.3", "both lead out of {} the same way"),
        (HostileClass.CROSSING, "R6.4", "both pass {}"),
    ):
        if kind in ways:
            yield kind, told.format(ways[kind][0]), rule
    if HostileClass.FOLLOWING in ways:
        yield HostileClass.FOLLOWING, f"share {', '.join(ways[HostileClass.FOLLOWING])}", "R6.5"


def _meeting(t: Traversal, o: Traversal) -> HostileClass:
    """How two ways through one section meet."""
    if t.exit == o.entry or t.entry == o.exit:
        return HostileClass.OPPOSING
    if t.entry == o.entry:
        return HostileClass.FOLLOWING
    return HostileClass.CONVERGING if t.exit == o.exit else HostileClass.CROSSING
