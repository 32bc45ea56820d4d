"""Turns of a fleet between waiting place, loading places and tippler: who sets out when, by dynamic programming.

Document D takes its dynamic programming stage by stage.  Here a stage is one more *piece*: a movement from where a
train may wait to where it may wait again, without a stop, with what it holds and for how long.  After each stage the
states that a next piece leads to are kept, of all the best `width` (a beam search: with a width without end it is the
whole dynamic programme).  No clock is read: the same question has the same answer.

The cost of a state is the time at which each train will be ready again if nobody is in its way from now on, less the
shortest turn for each train tipped in time, and what the blend is missed by.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import field
from functools import cached_property
from typing import NamedTuple

from interlock.dataclass import dataclass

NEVER = 1 << 40


@dataclass(frozen=True)
class Hold:
    """A resource, and when it is held, in seconds from the setting out.  begin None: since before that; end None: until
    the train's next piece has left it."""

    resource: int
    begin: int | None
    end: int | None


@dataclass(frozen=True, eq=False)
class Piece:
    """A movement.  `seconds`: until the train is there; `work`: seconds there until it may go on.

    enters, leaves: when it comes to count in the zone, and when no more; inside: it counts there before it sets out.
    onward: the train's next piece; None: it is tipped then."""

    holds: tuple[Hold, ...]
    seconds: int
    work: int = 0
    enters: int | None = None
    leaves: int | None = None
    inside: bool = False
    onward: Piece | None = None

    @cached_property
    def rest(self) -> int:
        """Seconds from its setting out until the train is before the tippler, at the soonest."""
        return self.seconds + (0 if self.onward is None else self.work + self.onward.rest)

    @cached_property
    def needs(self) -> tuple[tuple[int, int], ...]:
        """What it comes to hold, and how many seconds after its setting out."""
        return tuple((h.resource, h.begin) for h in self.holds if h.begin is not None)

    @cached_property
    def keeps(self) -> tuple[tuple[int, int], ...]:
        """What it holds, and how many seconds after its setting out it gives it up (`NEVER`: its next piece does)."""
        return tuple((h.resource, NEVER if h.end is None else h.end) for h in self.holds)


@dataclass(frozen=True, eq=False)
class Turn:
    """An order as trains of one kind carry it out: its first piece, seconds to tip, seconds until it is ready again,
    and the tippler, if it takes one train at a time."""

    order: int
    first: Piece
    tips: int
    back: int
    tippler: int | None = None


@dataclass(frozen=True)
class Under:
    """A train: when it may set out, its kind, and its turn with the piece that comes next; None: it has no order.

    At the tippler already: `tipped` is when it will have been tipped."""

    ready: int
    kind: int
    turn: Turn | None = None
    piece: Piece | None = None
    tipped: int | None = None


@dataclass(frozen=True)
class Fleet:
    """What is planned: trains, the turns of each kind, how many trains each order still needs, and how many it had.

    free: when each resource is free, `NEVER` for one that a train holds until its next piece.  limit: trains in the
    zone.  shares: the part of all trains that an order is to have, or None.
    """

    trains: tuple[Under, ...]
    turns: tuple[tuple[Turn, ...], ...]
    left: tuple[int, ...]
    free: tuple[int, ...]
    limit: int = 1 << 20
    given: tuple[int, ...] = ()
    shares: tuple[float | None, ...] = ()


class Start(NamedTuple):
    """A train sets out on a piece of a turn."""

    at: int
    train: int
    turn: Turn
    piece: Piece


@dataclass(frozen=True)
class Staged:
    """A plan: who sets out when, in order of stages, and when trains are tipped.  `states`: how many were looked at."""

    starts: tuple[Start, ...]
    tipped: tuple[int, ...]
    states: int


class _State(NamedTuple):
    """After some stages.  `waiting`: trains under way, (ready, train, turn, piece); `idle`: (ready, train)."""

    free: tuple[int, ...]
    exits: tuple[int, ...]
    waiting: tuple[tuple[int, int, Turn, Piece], ...]
    idle: tuple[tuple[int, int], ...]
    left: tuple[int, ...]
    given: tuple[int, ...]
    tipped: tuple[int, ...]


class _Node(NamedTuple):
    cost: float
    state: _State
    by: tuple[_Node, Start] | None = None


def _ready(waiting: tuple[int, int, Turn, Piece]) -> int:
    return waiting[0]


@dataclass
class _Search:
    fleet: Fleet
    end: int
    width: int
    least: int = field(init=False)
    """Seconds of the shortest turn."""
    entry: tuple[tuple[tuple[int, int], ...], ...] = field(init=False)
    """By kind: what it holds first, and how many seconds after its setting out."""
    blends: bool = field(init=False)
    """An order is to have a share."""
    looked: int = 0

    def __post_init__(self) -> None:
        firsts = [of[0].first.holds[:2] if of else () for of in self.fleet.turns]
        self.blends = any(part is not None for part in self.fleet.shares)
        self.entry = tuple(tuple((h.resource, h.begin or 0) for h in first) for first in firsts)
        turns = [t for of in self.fleet.turns for t in of]
        self.least = min((t.first.rest + t.tips + t.back for t in turns), default=1)

    # --- states --------------------------------------------------------------------------------

    def first(self) -> _State:
        f = self.fleet
        waiting, idle, tipped = [], [], []
        for k, t in enumerate(f.trains):
            if t.tipped is not None:
                tipped.append(t.tipped)
            if t.turn is None or t.piece is None:
                idle.append((t.ready, k))
            else:
                waiting.append((t.ready, k, t.turn, t.piece))
        given = f.given or (0,) * len(f.left)
        return _State(f.free, (), tuple(waiting), tuple(sorted(idle)), f.left, given, tuple(tipped))

    def _soonest(self, s: _State, piece: Piece, ready: int) -> int:
        at, free = ready, s.free
        for x, begin in piece.needs:
            if free[x] - begin > at:
                at = free[x] - begin
        if piece.enters is not None:
            room = self.fleet.limit - sum([w[3].inside for w in s.waiting])
            if room <= 0:
                return NEVER
            if len(s.exits) >= room:
                at = max(at, s.exits[-room] - piece.enters)
        return at

    def _after(self, s: _State, start: Start) -> _State:
        piece, at = start.piece, start.at
        free = list(s.free)
        for x, end in piece.keeps:
            free[x] = NEVER if end == NEVER else at + end
        exits = s.exits if piece.leaves is None else tuple(sorted((*s.exits, at + piece.leaves)))
        waiting = tuple([w for w in s.waiting if w[1] != start.train])
        idle = tuple([x for x in s.idle if x[1] != start.train])
        left, given, tipped = s.left, s.given, s.tipped
        if piece is start.turn.first:
            k = start.turn.order
            left = (*left[:k], left[k] - 1, *left[k + 1 :])
            given = (*given[:k], given[k] + 1, *given[k + 1 :])
        there = at + piece.seconds
        if piece.onward is not None:
            waiting = (*waiting, (there + piece.work, start.train, start.turn, piece.onward))
        else:
            done = self._tips(free, start.turn, there)
            tipped = (*tipped, done)
            idle = tuple(sorted((*idle, (done + start.turn.back, start.train))))
        return _State(tuple(free), exits, waiting, idle, left, given, tipped)

    def _tips(self, free: list[int], turn: Turn, there: int) -> int:
        """When a train that is before the tippler has been tipped."""
        if turn.tippler is None:
            return there + turn.tips
        done = free[turn.tippler] = max(there, free[turn.tippler]) + turn.tips
        return done

    def _next(self, s: _State) -> Iterator[Start]:
        for ready, k, turn, piece in s.waiting:
            at = self._soonest(s, piece, ready)
            if at + piece.rest + turn.tips <= self.end:
                yield Start(at, k, turn, piece)
        kinds = set[int]()
        for ready, k in s.idle:
            kind = self.fleet.trains[k].kind
            if kind in kinds:
                continue  # another one like it is ready sooner
            kinds.add(kind)
            for turn in self.fleet.turns[kind]:
                if s.left[turn.order] > 0:
                    at = self._soonest(s, turn.first, ready)
                    if at + turn.first.rest + turn.tips <= self.end:
                        yield Start(at, k, turn, turn.first)

    # --- costs ---------------------------------------------------------------------------------

    def cost(self, s: _State) -> float:
        """When each train will be ready, less what was tipped in time, and more for a blend that is missed."""
        total, free = 0.0, list(s.free)
        for ready, _, turn, piece in sorted(s.waiting, key=_ready):
            at = ready
            for x, begin in piece.needs:
                if at < s.free[x] - begin < NEVER // 2:
                    at = s.free[x] - begin
            done = self._tips(free, turn, at + piece.rest)
            total += done + turn.back - (self.least if done <= self.end else 0)
        for ready, k in s.idle:
            at = ready
            for x, begin in self.entry[self.fleet.trains[k].kind]:
                if at < s.free[x] - begin and s.free[x] < NEVER:
                    at = s.free[x] - begin
            total += at
        total -= self.least * sum([t <= self.end for t in s.tipped])
        return total + 0.5 * self.least * self._missed(s)

    def _missed(self, s: _State) -> float:
        """Trains by which the blend is missed, more than one of each order."""
        if not self.blends:
            return 0.0
        total = sum(s.given)
        parts = zip(s.given, self.fleet.shares, strict=False)
        return sum(max(0.0, abs(n - part * total) - 1.0) for n, part in parts if part is not None)

    # --- search --------------------------------------------------------------------------------

    def run(self) -> Staged:
        state = self.first()
        beam = [_Node(self.cost(state), state)]
        best = beam[0]
        while beam:
            found: dict[_State, _Node] = {}
            for node in beam:
                last = True
                for start in self._next(node.state):
                    last = False
                    after = self._after(node.state, start)
                    self.looked += 1
                    if after not in found:
                        found[after] = _Node(self.cost(after), after, (node, start))
                if last and (self._rank(node) < self._rank(best) or best.by is None):
                    best = node
            beam = self._kept(found)
        return self._told(best)

    def _rank(self, node: _Node) -> tuple[int, float]:
        """Most trains tipped in time, then the least cost."""
        return -sum(t <= self.end for t in node.state.tipped), node.cost

    def _kept(self, found: dict[_State, _Node]) -> list[_Node]:
        """The best ones, of which no more than some have the same trains in the same places."""
        kept, alike = list[_Node](), dict[object, int]()
        for node in sorted(found.values(), key=lambda n: n.cost):
            where = (tuple(sorted((w[2].order, id(w[3])) for w in node.state.waiting)), len(node.state.tipped))
            if alike.get(where, 0) < max(1, self.width // 10):
                alike[where] = alike.get(where, 0) + 1
                kept.append(node)
                if len(kept) == self.width:
                    break
        return kept

    def _told(self, node: _Node) -> Staged:
        starts, at = list[Start](), node
        while at.by is not None:
            at, start = at.by
            starts.append(start)
        return Staged(tuple(reversed(starts)), tuple(sorted(node.state.tipped)), self.looked)


def staged(fleet: Fleet, end: int, width: int = 50) -> Staged:
    """A plan until some second, in which nothing sets out that could not be tipped by then."""
    return _Search(fleet, end, width).run()
