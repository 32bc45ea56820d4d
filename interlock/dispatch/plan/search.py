"""Completion plans by search: moves after which every train is where it may stay, or the reason why there are none.

Depth first, with three ways to see early that a state leads nowhere.  Two trains alone: for each pair of trains that
meet, the pairs of nodes from which the two cannot both finish are computed once, exactly; more trains only make it
worse.  Reasons: when a state leads nowhere, the trains that show it (each of their moves is blocked by one of them, or
leads where nothing leads on) are remembered, and every state with these trains in these places is left at once.  And a
train that can leave the railway alone does so first: nothing is ever worse for it.

NONE is said only when everything was searched: it is a proof, and the reason names the trains that are caught.  When
the budget of states is used up, UNKNOWN is said.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import field, replace
from enum import StrEnum
from functools import cached_property
from heapq import heappop, heappush
from itertools import count

from interlock.dataclass import dataclass
from interlock.dispatch.plan.problem import Move, Problem

BUDGET = 200_000
"""States that a search looks at before it gives up (our choice)."""

FIRST = 250
"""States after which a search begins again in another order; it goes on for four times as long when all were tried."""

ORDERS = ("open", "near", "far")
"""Which moves are tried first: those after which most moves are possible, or those of trains near their end, or far."""


class Verdict(StrEnum):
    """Whether all trains can finish."""

    PLAN = "PLAN"
    NONE = "NONE"
    UNKNOWN = "UNKNOWN"


@dataclass(frozen=True)
class Answer:
    """A plan, or the bits of the trains that are caught; `states`: how many were looked at."""

    verdict: Verdict
    plan: tuple[Move, ...] = ()
    caught: int = 0
    states: int = 0


@dataclass
class _Frame:
    """A state on the way: its moves still to be tried, and why those that were tried lead nowhere."""

    state: int
    todo: Iterator[tuple[Move, ...]]
    by: tuple[Move, ...]
    forced: bool
    why: dict[Move, int] = field(default_factory=dict)


def _way(came: dict[int, tuple[float, Move | None]], goal: int) -> tuple[Move, ...]:
    """The moves to a goal, from the last move to each node."""
    way: list[Move] = []
    step = came[goal][1]
    while step is not None:
        way.append(step)
        step = came[step.source][1]
    return tuple(way[::-1])


class OutOfBudget(Exception):
    """Too many states."""


class Planner:
    """Answers for one problem; what was found out about it is kept from question to question."""

    def __init__(self, problem: Problem, budget: int = BUDGET) -> None:
        self.problem, self.budget = problem, budget
        self._reasons: dict[int, list[int]] = {}
        """By bit: the sets of nodes, as bits, from which nothing leads on, that contain it."""
        self._mask = [sum(bits) for bits in problem.nodes]
        self._seen, self._share, self._order = 0, budget, ORDERS[0]

    def solve(self, state: int) -> Answer:
        """A plan from a state, or why there is none."""
        p = self.problem
        if p.done(state):
            return Answer(Verdict.PLAN)
        known = self._known(state, state)
        if known:
            return Answer(Verdict.NONE, caught=known)
        lost = self._lost_from(state)
        if lost:
            return Answer(Verdict.NONE, caught=lost)
        looked, share = 0, FIRST
        while looked < self.budget:
            for order in ORDERS:
                self._seen, self._share, self._order = 0, min(share, self.budget - looked), order
                try:
                    answer = self._search(state)
                    return replace(answer, states=looked + self._seen)
                except OutOfBudget:
                    looked += self._share
            share *= 4
        return Answer(Verdict.UNKNOWN, states=looked)

    # --- pairs ---------------------------------------------------------------------------------

    @cached_property
    def dead(self) -> int:
        """The nodes from which a train does not come home even alone."""
        found = 0
        for bits in self.problem.nodes:
            for n in reversed(bits):
                if not n & self.problem.home and all(m.target & found for m in self.problem.moves[n]):
                    found |= n
        return found

    @cached_property
    def lost(self) -> dict[int, int]:
        """By node: the nodes of other trains with which the two trains alone cannot both finish."""
        found: dict[int, int] = {b: 0 for bits in self.problem.nodes for b in bits}
        for t in range(len(self._mask)):
            for u in range(t + 1, len(self._mask)):
                if self._meet(t, u):
                    self._pair(t, u, found)
        return found

    def _meet(self, t: int, u: int) -> bool:
        for a, b in ((t, u), (u, t)):
            for bit in self.problem.nodes[a]:
                if any(m.blocked & self._mask[b] or m.zones for m in self.problem.moves[bit]):
                    return True
        return False

    def _pair(self, t: int, u: int, found: dict[int, int]) -> None:
        """From the last nodes back to the first: moves never lead back."""
        p = self.problem
        ours, theirs = p.nodes[t], p.nodes[u]
        home = p.home & self._mask[u]
        back = [m for b in reversed(theirs) for m in p.moves[b]]
        good: dict[int, int] = {}
        for n in reversed(ours):
            row = home if n & p.home else 0
            for m in p.moves[n]:
                row |= good[m.target] & ~m.blocked & ~self._full(m)
            for m in back:
                if row & m.target and not m.blocked & n and not self._full(m) & n:
                    row |= m.source
            good[n] = row
        for n in ours:
            bad = 0 if n & self.dead else self._mask[u] & ~good[n] & ~self.dead
            found[n] |= bad
            while bad:
                low = bad & -bad
                found[low] |= n
                bad ^= low

    def _full(self, m: Move) -> int:
        """The nodes in which one other train alone fills a zone."""
        found = 0
        for z, room in m.zones:
            found |= self.problem.limits[z].beyond(room)
        return found

    # --- search --------------------------------------------------------------------------------

    def _search(self, start: int) -> Answer:
        p = self.problem
        stack = [self._frame(start, ())]
        while stack:
            frame = stack[-1]
            moves = next(frame.todo, None)
            if moves is None:
                stack.pop()
                reason = self._learn(frame)
                if stack:
                    self._blame(stack[-1], frame.by, reason)
                    continue
                return Answer(Verdict.NONE, caught=reason)
            state = frame.state
            for m in moves:
                state = state & ~m.source | m.target
            self._seen += 1
            if self._seen > self._share:
                raise OutOfBudget
            if p.done(state):
                plan = tuple(m for f in stack for m in f.by) + moves
                return Answer(Verdict.PLAN, plan)
            known = self._known(state, moves[-1].target)
            if known:
                self._blame(frame, moves, known)
                continue
            stack.append(self._frame(state, moves))
        raise AssertionError("the first state was left without a reason")

    def _frame(self, state: int, by: tuple[Move, ...]) -> _Frame:
        leaves = self._leaves(state)
        if leaves is not None:
            return _Frame(state, iter((leaves,)), by, True)
        return _Frame(state, iter(self._moves(state)), by, False)

    def _leaves(self, state: int) -> tuple[Move, ...] | None:
        """Moves by which one train leaves the railway while all others stand."""
        p = self.problem
        if not p.gone:
            return None
        for mask in self._mask:
            here = state & mask
            if here and not here & p.gone:
                way = self.alone(state, here, p.gone)
                if way:
                    return way
        return None

    def alone(self, state: int, here: int, goal: int) -> tuple[Move, ...] | None:
        """The cheapest moves of one train to a goal while all others stand."""
        p = self.problem
        others = state & ~here
        came: dict[int, tuple[float, Move | None]] = {here: (0.0, None)}
        turn, todo = count(1), [(0.0, 0, here)]
        while todo:
            cost, _, n = heappop(todo)
            if n & goal:
                return _way(came, n)
            for m in p.moves[n] if cost <= came[n][0] else ():
                after = cost + m.cost
                if (m.target not in came or after < came[m.target][0]) and p.possible(others, m):
                    came[m.target] = after, m
                    heappush(todo, (after, next(turn), m.target))
        return None

    def _moves(self, state: int) -> list[tuple[Move, ...]]:
        """The moves that are possible and not known to lead nowhere; those first that leave most ways open."""
        p = self.problem
        found: list[tuple[bool, int, int, Move]] = []
        for mask in self._mask:
            for m in p.moves[state & mask]:
                if m.target & self.dead or state & ~m.source & self.lost[m.target]:
                    continue
                if p.possible(state, m):
                    after = state & ~m.source | m.target
                    found.append((not m.target & p.home, self._rank(after, m), len(found), m))
        return [(m,) for *_, m in sorted(found, key=lambda x: x[:3])]

    def _rank(self, after: int, m: Move) -> int:
        p = self.problem
        if self._order == "open":
            return -sum(p.possible(after, x) for k in self._mask for x in p.moves[after & k])
        return self._left[m.target] if self._order == "near" else -self._left[m.target]

    @cached_property
    def _left(self) -> dict[int, int]:
        """By node: the moves to a place where its train may stay."""
        found: dict[int, int] = {}
        for bits in self.problem.nodes:
            for n in reversed(bits):
                onward = [1 + found[m.target] for m in self.problem.moves[n]]
                found[n] = 0 if n & self.problem.home else min(onward, default=len(bits))
        return found

    # --- reasons -------------------------------------------------------------------------------

    def _lost_from(self, state: int) -> int:
        for mask in self._mask:
            here = state & mask
            if here & self.dead:
                return here
            caught = state & self.lost[here]
            if caught:
                return here | caught & -caught
        return 0

    def _known(self, state: int, new: int) -> int:
        """A reason why a state leads nowhere; `new`: bits of which one must be part of it."""
        while new:
            low = new & -new
            for reason in self._reasons.get(low, ()):
                if reason & state == reason:
                    return reason
            new ^= low
        return 0

    def _blame(self, frame: _Frame, moves: tuple[Move, ...], reason: int) -> None:
        frame.why[moves[0]] = reason
        if frame.forced or not reason & moves[-1].target:
            # who has left, or moved, has no part in the reason: so it holds before, too
            frame.todo = iter(())
            frame.why = {moves[0]: reason}
            frame.forced = True

    def _learn(self, frame: _Frame) -> int:
        """The smallest set of trains that shows why a state leads nowhere; remembered."""
        if frame.forced:
            return next(iter(frame.why.values()))
        state = frame.state
        best = 0
        for mask in self._mask:
            here = state & mask
            if here & self.problem.home:
                continue
            reason = self._closure(frame, here)
            if not best or reason.bit_count() < best.bit_count():
                best = reason
        rest = best
        while rest:
            low = rest & -rest
            self._reasons.setdefault(low, []).append(best)
            rest ^= low
        return best

    def _closure(self, frame: _Frame, first: int) -> int:
        """Trains from `first` on, so that each of their moves is blocked by one of them or leads nowhere with them."""
        p, state = self.problem, frame.state
        reason, todo = first, [first]
        while todo:
            here = todo.pop()
            for m in p.moves[here]:
                new = self._why(frame, m, reason, state) & ~reason
                reason |= new
                while new:
                    low = new & -new
                    todo.append(low)
                    new ^= low
        return reason

    def _why(self, frame: _Frame, m: Move, reason: int, state: int) -> int:
        """The nodes of others that keep a move from leading on."""
        p = self.problem
        others = state & ~m.source
        if m.target & self.dead:
            return 0
        for blocked in (m.blocked, self.lost[m.target]):
            shown = others & blocked
            if shown:
                return 0 if shown & reason else shown & -shown
        for there, behind in m.followed:
            if others & there and others & behind:
                shown = others & behind
                return others & there | (0 if shown & reason else shown & -shown)
        for z, room in m.zones:
            if p.limits[z].count(others) > room:
                return others & p.limits[z].nodes[0]
        return frame.why[m] & ~m.target
