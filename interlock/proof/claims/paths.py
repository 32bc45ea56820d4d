"""The paths of signals, found on the layout by the proof's own search, and who shows proceed over which way."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import pairwise

from interlock.dataclass import dataclass
from interlock.logic.expr import Expr, conj, disj
from interlock.logic.plant import lies
from interlock.model.elements import NodeId, SectionId, SignalId
from interlock.model.traversal import Traversal
from interlock.proof.claims.kinds import Facts


@dataclass(frozen=True)
class SignalPath:
    """A path from a signal to the next, found on the layout by its own search."""

    signal: SignalId
    shunt: bool
    ways: tuple[Traversal, ...]
    berth: SectionId | None

    @property
    def kept_clear(self) -> tuple[Traversal, ...]:
        """The ways in which nothing may stand: all but the berth of a shunting movement."""
        return self.ways if self.berth is None else self.ways[:-1]


def signal_paths(f: Facts, g: SignalId, shunt: bool = False) -> list[SignalPath]:
    """Every path from a signal to the next one that the movement obeys, a boundary or a buffer.

    A shunting movement obeys every signal, stops in the first berth, and does not leave over a boundary: it ends before
    one in a road that the layout denies to be a berth, and elsewhere there is no path.
    """
    known = f.paths.get((g, shunt))
    if known is None:
        known = f.paths[g, shunt] = _search_paths(f, g, shunt)
    return known


def _search_paths(f: Facts, g: SignalId, shunt: bool) -> list[SignalPath]:
    signal = f.layout.signalling.signal[g]
    stops = f.topo.signal_into if shunt else f.topo.main_into
    found: list[SignalPath] = []

    def go(section: SectionId, entry: NodeId, ways: tuple[Traversal, ...]) -> None:
        for t in f.topo.through(section, entry):
            path = (*ways, t)
            ahead = f.topo.beyond(section, t.exit)
            stands = shunt and f.track.berth(section)
            ends = stands or section in f.topo.turning
            if ahead is None and shunt and not ends and t.exit in f.layout.track.boundary_at:
                continue
            if ahead is None or (t.exit, ahead) in stops or stands:
                found.append(SignalPath(g, shunt, path, section if stands and len(path) > 1 else None))
            elif all(w.section != ahead for w in path):
                go(ahead, t.exit, path)

    go(f.layout.track.section_of(signal.into), signal.node, ())
    return found


@dataclass(frozen=True)
class Run:
    """A train's path from a signal, and on from one signal after the other, none twice, that shows its identifier
    light."""

    parts: tuple[SignalPath, ...]
    called: str = ""

    @property
    def passed(self) -> tuple[SignalId, ...]:
        """The signals at identifier light, in order."""
        return tuple(p.signal for p in self.parts[1:])

    @property
    def ways(self) -> tuple[Traversal, ...]:
        """The ways of all its parts."""
        return tuple(t for p in self.parts for t in p.ways)

    def lit(self, f: Facts) -> Expr:
        """The signals that it passes show their identifier lights, and its points lie."""
        return conj((*map(f.sym.aspects.identifies, self.passed), lie(f, self.ways)))


def exit_of(f: Facts, path: SignalPath) -> SignalId | None:
    """The main signal at the end of a path."""
    last = path.ways[-1]
    ahead = f.topo.beyond(last.section, last.exit)
    return None if ahead is None else f.topo.main_into.get((last.exit, ahead))


def runs_past(f: Facts, path: SignalPath) -> Iterator[Run]:
    """The runs that begin with a train's path and pass at least one signal to which the layout gives the light."""
    todo = [Run((path,))]
    while todo:
        run = todo.pop()
        passed = exit_of(f, run.parts[-1])
        if passed is None or passed not in f.layout.signalling.identifiers or passed in run.passed:
            continue
        for k, onward in enumerate(signal_paths(f, passed), 1):
            todo.append(Run((*run.parts, onward), f"{run.called} past {passed}:{k}"))
            yield todo[-1]


def lie(f: Facts, ways: tuple[Traversal, ...]) -> Expr:
    """All points of a path really lie for it."""
    return conj(lies(f.layout.pointwork.point[p].machine, x) for t in ways for p, x in t.points)


Shown = tuple[SignalId, bool]


@dataclass
class Ground:
    """Who shows proceed over which way, and past which signal."""

    over: dict[tuple[SectionId, int], dict[Shown, list[Expr]]]
    past: dict[SignalId, list[Expr]]


def ground_of(f: Facts) -> Ground:
    """What every signal shows to trains, and to shunting movements, over each way of each of its paths."""
    ground = Ground({}, {})
    for who in ((g.id, k) for g in f.layout.signalling.signals for k in f.track.functions(g.id)):
        for path in signal_paths(f, *who):
            there = conj((f.sym.aspects.signal(*who), lie(f, path.ways)))
            for t in path.ways:
                ground.over.setdefault(t.key, {}).setdefault(who, []).append(there)
            for a, b in pairwise(path.ways):
                passed = f.topo.signal_into.get((a.exit, b.section))
                if passed is not None:
                    ground.past.setdefault(passed, []).append(there)
    return ground


def shown_over(ground: Ground, ways: Iterable[Traversal]) -> dict[Shown, Expr]:
    """Each signal that shows proceed over one of the ways."""
    found: dict[Shown, list[Expr]] = {}
    for t in ways:
        for who, there in ground.over.get(t.key, {}).items():
            found.setdefault(who, []).extend(there)
    return {who: disj(there) for who, there in found.items()}
