"""Routes (R1, R2 main): search from every main signal, no length cap, all alternatives kept.

A path follows the signal's direction to the next main signal of that direction, a boundary or a buffer.
A path that meets itself, or that needs one machine in two positions, cannot be run and is reported.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from interlock.diag import Sink
from interlock.model.elements import BoundaryKind, MachineId, NodeId, Position, RouteId, SectionId, Signal, SignalId
from interlock.model.layout import Layout
from interlock.model.traversal import Topology, Traversal, topology
from interlock.table.rows import ExitKind


@dataclass(frozen=True)
class Path:
    """A path from a signal to its exit, as traversals in order."""

    id: RouteId
    number: int
    entry: SignalId
    entry_node: NodeId
    exit: str
    exit_kind: ExitKind
    variant: int
    ways: tuple[Traversal, ...]

    @property
    def length(self) -> float:
        """Metres from the entry signal to the exit."""
        return sum(t.length for t in self.ways)


def machine_positions(layout: Layout, ways: tuple[Traversal, ...]) -> dict[MachineId, Position] | None:
    """Positions of the machines on a path, or None when one is needed in both."""
    found: dict[MachineId, Position] = {}
    for t in ways:
        for point, position in t.points:
            if found.setdefault(layout.point[point].machine, position) is not position:
                return None
    return found


def _crosses_itself(ways: tuple[Traversal, ...]) -> bool:
    """Whether a path runs over both arms of a diamond."""
    over = [c for t in ways for c, _ in t.crossings]
    return len(over) != len(set(over))


def find_routes(layout: Layout, sink: Sink) -> tuple[Path, ...]:
    """Every route, ordered by signal, then exit, then rank of the alternative."""
    topo = topology(layout)
    paths: list[Path] = []
    for g in layout.signals:
        by_exit: dict[tuple[ExitKind, str], list[tuple[Traversal, ...]]] = {}
        dropped = 0
        for kind, name, ways in _search(layout, topo, g):
            if kind is None or machine_positions(layout, ways) is None or _crosses_itself(ways):
                dropped += 1
            else:
                by_exit.setdefault((kind, name), []).append(ways)
        if dropped:
            sink.add(
                "IL4005",
                f"{dropped} path{'s' if dropped > 1 else ''} from {g.id} cannot be run: "
                "a section is met twice, a machine is needed in two positions, or no train may run that way",
            )
        if not by_exit:
            sink.add(
                "IL4003",
                f"no route leads from signal {g.id}",
                None,
                "check its direction (`from`, `into`) and where the track goes",
            )
        for (kind, name), alternatives in sorted(by_exit.items(), key=lambda x: x[0][1]):
            alternatives.sort(key=lambda w: _rank(layout, w))
            for variant, ways in enumerate(alternatives, start=1):
                suffix = f".{variant}" if variant > 1 else ""
                paths.append(
                    Path(RouteId(f"{g.id}-{name}{suffix}"), len(paths) + 1, g.id, g.node, name, kind, variant, ways)
                )
    return tuple(paths)


def _rank(layout: Layout, ways: tuple[Traversal, ...]) -> tuple[int, float, int, tuple[tuple[str, int], ...]]:
    """Basic before alternative: fewer points reversed, shorter, fewer points (R1)."""
    del layout
    points = [p for t in ways for _, p in t.points]
    return (points.count(Position.REVERSE), sum(t.length for t in ways), len(points), tuple(t.key for t in ways))


def _search(layout: Layout, topo: Topology, g: Signal) -> Iterator[tuple[ExitKind | None, str, tuple[Traversal, ...]]]:
    """Depth first over traversals; yields (None, "", path) for a path that cannot be run to its end."""
    stack: list[tuple[SectionId, NodeId, tuple[Traversal, ...]]] = [(layout.section_of(g.into), g.node, ())]
    while stack:
        section, entry, ways = stack.pop()
        onward_ways = topo.through(section, entry)
        if not onward_ways:
            yield None, "", ways
        for t in reversed(onward_ways):
            path = (*ways, t)
            if t.exit in layout.boundary_at:
                leaves = layout.boundary_at[t.exit].kind is not BoundaryKind.IN
                yield (ExitKind.BOUNDARY if leaves else None), t.exit, path
                continue
            if t.exit in layout.buffer_at:
                yield ExitKind.BUFFER, t.exit, path
                continue
            onward = topo.beyond(section, t.exit)
            assert onward is not None
            ahead = topo.signal_into.get((t.exit, onward))
            if ahead is not None:
                yield ExitKind.SIGNAL, ahead, path
            elif any(w.section == onward for w in path):
                yield None, "", path
            else:
                stack.append((onward, t.exit, path))
