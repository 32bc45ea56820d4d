"""Hostile routes with class, witness and reason (R6).

Two routes are hostile when they cannot be set together: they share a section, need a machine in two
positions, cross on a diamond, or foul each other.  The first class that applies names the reason.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from interlock.derive.routes import Path
from interlock.model.elements import MachineId, Position, RouteId, SectionId
from interlock.model.traversal import Traversal
from interlock.table.rows import (
    Because,
    Hostile,
    HostileClass,
    PointDemand,
    Role,
    RouteKind,
    TraversalKey,
    TraversalRow,
)


def derive_hostile(
    paths: Sequence[Path],
    locks: Mapping[TraversalKey, TraversalRow],
    demands: Mapping[RouteId, Sequence[PointDemand]],
) -> dict[RouteId, tuple[Hostile, ...]]:
    """For every route, its hostile routes in order of number."""
    out: dict[RouteId, list[Hostile]] = {p.id: [] for p in paths}
    needs = {
        p.id: Needs(
            {t.section: t for t in p.ways},
            _positions(demands[p.id], (Role.PATH,)),
            _positions(demands[p.id], _HELD),
        )
        for p in paths
    }
    for i, j in _candidates(paths, locks, demands):
        a, b = paths[i], paths[j]
        found = classify(a, b, locks, needs)
        if found is None:
            continue
        kind, witness, rule = found
        for x, y in ((a, b), (b, a)):
            out[x.id].append(Hostile(y.id, kind, witness, Because(rule, f"{x.id} and {y.id}: {kind}, {witness}")))
    number = {p.id: p.number for p in paths}
    return {r: tuple(sorted(hs, key=lambda h: number[h.route])) for r, hs in out.items()}


def _candidates(
    paths: Sequence[Path],
    locks: Mapping[TraversalKey, TraversalRow],
    demands: Mapping[RouteId, Sequence[PointDemand]],
) -> Iterator[tuple[int, int]]:
    """Pairs that meet in some resource, in order: without a common one there is no conflict, and most have none."""
    users: dict[tuple[str, str], list[int]] = {}
    for i, p in enumerate(paths):
        over = (*p.ways, *p.overlap)
        uses = {("section", t.section) for t in over} | {("machine", d.machine) for d in demands[p.id]}
        uses |= {("section", e.section) for t in over for e in locks[t.key].exclusions}
        for resource in uses:
            users.setdefault(resource, []).append(i)
    meets = [0] * len(paths)
    for those in users.values():
        together = sum(1 << i for i in those)
        for i in those:
            meets[i] |= together
    for i, others in enumerate(meets):
        left = others >> (i + 1) << (i + 1)
        while left:
            lowest = left & -left
            yield i, lowest.bit_length() - 1
            left ^= lowest


_HELD = (Role.FLANK, Role.PATH, Role.OVERLAP)


def _positions(demands: Sequence[PointDemand], roles: tuple[Role, ...]) -> dict[MachineId, Position]:
    return {d.machine: d.position for d in demands if d.role in roles}


@dataclass(frozen=True)
class Needs:
    """The ways of a route by section, and how machines lie for it: those of its path, and all that it holds."""

    ways: Mapping[SectionId, Traversal]
    path: Mapping[MachineId, Position]
    held: Mapping[MachineId, Position]


def classify(
    a: Path, b: Path, locks: Mapping[TraversalKey, TraversalRow], needs: Mapping[RouteId, Needs]
) -> tuple[HostileClass, str, str] | None:
    """Class, witness and rule of a hostile pair, or None when both may be set together."""
    if a.entry == b.entry:
        return HostileClass.SAME_ENTRY, f"both begin at {a.entry}", "R6.5"
    path_a, path_b = needs[a.id].path, needs[b.id].path
    for m, x in path_a.items():
        if path_b.get(m, x) is not x:
            return HostileClass.POINTS, f"machine {m} lies {x} for {a.id} and {path_b[m]} for {b.id}", "R6.1"
    shared = _shared(a, needs[b.id].ways)
    if shared is not None:
        return shared
    for t in a.ways:
        for ex in locks[t.key].exclusions:
            for o in b.ways:
                if o.section == ex.section and (ex.whole or o.number in ex.numbers):
                    kind = HostileClass.CROSSING if ex.because.rule == "R6" else HostileClass.FOUL
                    rule = "R6.4" if kind is HostileClass.CROSSING else "R6.10"
                    return kind, f"{t.section} and {o.section}: {ex.because.text}", rule
    overlap = _overlap(a, b, locks) or _overlap(b, a, locks)
    if overlap is not None:
        return overlap
    all_a, all_b = needs[a.id].held, needs[b.id].held
    for m, x in all_a.items():
        if all_b.get(m, x) is not x:
            return HostileClass.FLANK, f"machine {m} must lie {x} for {a.id} and {all_b[m]} for {b.id}", "R6.9"
    return None


def _overlap(a: Path, b: Path, locks: Mapping[TraversalKey, TraversalRow]) -> tuple[HostileClass, str, str] | None:
    """The overlap of a against the path and overlap of b; a route onward from a's exit may lie over the same ways."""
    for t in a.overlap:
        for o in b.overlap:
            if o.section == t.section:
                return HostileClass.OVERLAP, f"both need {t.section} as overlap", "R6.8"
        for o in b.ways:
            if o.section == t.section and not (b.kind is RouteKind.MAIN and b.entry == a.exit and o.key == t.key):
                return HostileClass.OVERLAP, f"{t.section} is the overlap of {a.id}", "R6.7"
        for ex in locks[t.key].exclusions:
            for o in (*b.ways, *b.overlap):
                if o.section == ex.section and (ex.whole or o.number in ex.numbers):
                    return HostileClass.OVERLAP, f"overlap {t.section} and {o.section}: {ex.because.text}", "R6.7"
    return None


def _shared(a: Path, of_b: Mapping[SectionId, Traversal]) -> tuple[HostileClass, str, str] | None:
    common = [(t, of_b[t.section]) for t in a.ways if t.section in of_b]
    if not common:
        return None
    for t, o in common:
        if t.exit == o.entry or t.entry == o.exit:
            return HostileClass.OPPOSING, f"opposite directions in {t.section}", "R6.2"
    for t, o in common:
        if t.exit == o.exit and t.entry != o.entry:
            return HostileClass.CONVERGING, f"both lead out of {t.section} the same way", "R6.3"
    for t, o in common:
        if t.exit != o.exit and t.entry != o.entry:
            return HostileClass.CROSSING, f"both pass {t.section}", "R6.4"
    return HostileClass.FOLLOWING, f"share {', '.join(t.section for t, _ in common)}", "R6.5"
