"""Trains that must come where they may stay, without what moves them: places, moves, and what keeps a move back.

A train stands in one of its nodes.  A move takes it to another one; it is possible unless another train stands in a
node that blocks the move, or a zone through which it leads is full.  While a train moves all others stand: what was
set beside each other on the ground came one after the other, and trains that are under way arrive.

A zone counts as the controller does (R17), which knows sections and no trains: a train counts as often as sections of
the zone are under it, and when it comes in again, it counts itself.

Every node of every train has a bit, so that a state is one number, and so is what blocks a move.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import field

from interlock.dataclass import dataclass


class GoesRound(Exception):
    """A train's moves lead back to where it was."""


@dataclass(frozen=True)
class Move:
    """A move: its label, the train, source and target bit, the nodes of others that block it, zones it leads into, each
    with how often others may count there; what it costs: of several ways a train is given the cheapest that is free.

    followed: nodes of one train that block it while one of the other nodes, of third trains, is taken, too."""

    label: str
    train: int
    source: int
    target: int
    blocked: int
    zones: tuple[tuple[int, int], ...] = ()
    cost: float = 1.0
    followed: tuple[tuple[int, int], ...] = ()


@dataclass(frozen=True)
class Limit:
    """A zone: the nodes in which a train counts, those in which it counts twice or more often, and so on."""

    name: str
    nodes: tuple[int, ...]

    def count(self, state: int) -> int:
        """How often the trains of a state count."""
        return sum((state & nodes).bit_count() for nodes in self.nodes)

    def beyond(self, room: int) -> int:
        """The nodes in which one train alone counts more often."""
        return self.nodes[room] if room < len(self.nodes) else 0


@dataclass
class Problem:
    """Trains with nodes and moves.  `home`: nodes in which a train may stay; `gone`: those in which it blocks nothing
    and from which it moves no more."""

    trains: list[str] = field(default_factory=list)
    nodes: list[list[int]] = field(default_factory=list)
    """The bits of each train's nodes, every source before its targets."""
    moves: dict[int, list[Move]] = field(default_factory=dict)
    """By source bit."""
    label: dict[int, str] = field(default_factory=dict)
    home: int = 0
    gone: int = 0
    limits: list[Limit] = field(default_factory=list)

    def possible(self, state: int, move: Move) -> bool:
        """Whether a move is possible in a state."""
        if state & move.blocked or any(state & there and state & behind for there, behind in move.followed):
            return False
        others = state & ~move.source
        return all(self.limits[z].count(others) <= room for z, room in move.zones)

    def done(self, state: int) -> bool:
        """Every train is where it may stay."""
        return not state & ~self.home

    def at(self, state: int) -> list[int]:
        """The bit of each train, in the order of trains."""
        return [next(b for b in bits if b & state) for bits in self.nodes]


@dataclass(frozen=True)
class Followed:
    """What a train keeps from others (`things`) while one of the things `behind` it is held by another train."""

    things: frozenset[object]
    behind: frozenset[object]


@dataclass
class Draft:
    """One train while a problem is built: nodes by key, moves between them, and what each holds and needs."""

    name: str
    start: object
    holds: dict[object, frozenset[object]] = field(default_factory=dict)
    """What a train in a node keeps from others."""
    followed: dict[object, Followed] = field(default_factory=dict)
    """What it keeps there besides while another train is behind it."""
    moves: dict[object, list[tuple[str, object, frozenset[object], Mapping[str, int]]]] = field(default_factory=dict)
    """By node: label, target, the things that nobody else may hold, the room that it asks for in zones."""
    costs: dict[tuple[object, str], float] = field(default_factory=dict)
    """By node and label of a move: what it costs, 1 where nothing is stated."""
    home: set[object] = field(default_factory=set)
    gone: set[object] = field(default_factory=set)
    inside: dict[object, Mapping[str, int]] = field(default_factory=dict)
    """How often a train in a node counts in zones."""

    def order(self) -> list[object]:
        """The nodes from the start, sources before targets.  Raises `GoesRound`."""
        done: dict[object, bool] = {}
        found: list[object] = []
        stack: list[tuple[object, int]] = [(self.start, 0)]
        done[self.start] = False
        while stack:
            node, k = stack[-1]
            onward = self.moves.get(node, [])
            if k == len(onward):
                stack.pop()
                done[node] = True
                found.append(node)
                continue
            stack[-1] = (node, k + 1)
            target = onward[k][1]
            if target not in done:
                done[target] = False
                stack.append((target, 0))
            elif not done[target]:
                raise GoesRound(f"{self.name} comes back to {target}")
        return found[::-1]


def in_the_way(things: frozenset[object]) -> Draft:
    """What stands in the way of every train, and never moves."""
    strange = Draft("in the way", "in the way")
    strange.holds["in the way"] = things
    strange.home.add("in the way")
    return strange


@dataclass(frozen=True)
class Built:
    """A problem with the bit of every node of every train, and the state in which all stand at their starts."""

    problem: Problem
    bits: tuple[dict[object, int], ...]
    start: int


def build(drafts: Sequence[Draft], limits: Sequence[tuple[str, int]] = ()) -> Built:
    """Give every node a bit, and find what blocks what: a thing that a move needs and a node holds.  `limits`: zones,
    and how many trains may be there; a move for which a zone would be too small even without others is none."""
    problem = Problem(trains=[d.name for d in drafts])
    bits: list[dict[object, int]] = []
    holders: list[dict[object, int]] = []
    bit = 1
    for d in drafts:
        of: dict[object, int] = {}
        held: dict[object, int] = {}
        for node in d.order():
            of[node] = bit
            problem.label[bit] = str(node)
            for thing in d.holds.get(node, ()):
                held[thing] = held.get(thing, 0) | bit
            if node in d.home or node in d.gone:
                problem.home |= bit
            if node in d.gone:
                problem.gone |= bit
            bit <<= 1
        bits.append(of)
        holders.append(held)
        problem.nodes.append(list(of.values()))
    _limit(problem, drafts, bits, limits)
    _lead(problem, drafts, bits, holders, limits)
    return Built(problem, tuple(bits), sum(of[d.start] for d, of in zip(drafts, bits, strict=True)))


def _limit(
    problem: Problem, drafts: Sequence[Draft], bits: Sequence[Mapping[object, int]], limits: Sequence[tuple[str, int]]
) -> None:
    """The nodes in which trains count in each zone."""
    for name, _ in limits:
        often = [
            (d.inside.get(node, {}).get(name, 0), b)
            for d, of in zip(drafts, bits, strict=True)
            for node, b in of.items()
        ]
        most = max((n for n, _ in often), default=0)
        problem.limits.append(Limit(name, tuple(sum(b for n, b in often if n > k) for k in range(most))))


def _lead(
    problem: Problem,
    drafts: Sequence[Draft],
    bits: Sequence[dict[object, int]],
    holders: Sequence[Mapping[object, int]],
    limits: Sequence[tuple[str, int]],
) -> None:
    """The moves of each train, with the nodes of others that block them."""
    number = {name: i for i, (name, _) in enumerate(limits)}
    keeps = [list(_followed(u, d, bits[u], holders)) for u, d in enumerate(drafts)]
    for t, (d, of) in enumerate(zip(drafts, bits, strict=True)):
        others = [u for u in range(len(drafts)) if u != t]
        mine = sum(of.values())
        for node, b in of.items():
            out = problem.moves[b] = []
            for label, target, needs, zones in d.moves.get(node, []):
                own = d.inside.get(node, {})
                room = tuple((number[z], limits[number[z]][1] - n - own.get(z, 0)) for z, n in zones.items())
                if any(left < 0 for _, left in room):
                    continue
                blocked = 0
                for u in others:
                    for thing in needs:
                        blocked |= holders[u].get(thing, 0)
                more = [k for u in others for k in keeps[u] if not needs.isdisjoint(k[1])]
                for there, _, behind in more:
                    blocked |= there if behind & b else 0  # it is itself behind that train
                followed = tuple((there, behind & ~mine) for there, _, behind in more if not there & blocked)
                cost = d.costs.get((node, label), 1.0)
                out.append(Move(label, t, b, of[target], blocked, room, cost, tuple(x for x in followed if x[1])))


def _followed(
    train: int, d: Draft, of: Mapping[object, int], holders: Sequence[Mapping[object, int]]
) -> Iterator[tuple[int, frozenset[object], int]]:
    """The nodes of a train in which it keeps more while it is followed: what, and the nodes of others behind it."""
    for node, more in d.followed.items():
        behind = 0
        for u, held in enumerate(holders):
            if u != train and node in of:
                for thing in more.behind:
                    behind |= held.get(thing, 0)
        if behind:
            yield of[node], more.things, behind
