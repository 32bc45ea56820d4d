"""A problem as constraints for OR-tools CP-SAT: paths, times, and who goes first wherever two trains want the same.

Variables stand only for what is possible in a plan that costs no more than the known one (`windows.py`).  Trains whose
paths are given keep their order among themselves; all times are free.  CP-SAT knows times, not the order of what
happens at one time; an order in which trains change places at one time is found afterwards, and excluded.
"""

from __future__ import annotations

import heapq
import time as clock
from collections.abc import Mapping, Sequence
from dataclasses import field
from itertools import pairwise
from typing import Any

from ortools.sat.python import cp_model

from interlock.dataclass import dataclass
from interlock.planning.problem import Event, Plan, Problem, planned
from interlock.planning.spans import Span, spans, touching
from interlock.planning.windows import Windows, horizon, windows

Literal = Any
"""A Boolean variable of CP-SAT, its negation, or a constant."""


@dataclass(frozen=True)
class Held:
    """A span with its presence (None: always), and the variables of its start and of the end of its release."""

    span: Span
    presence: Literal | None
    start: Any
    end: Any
    soonest: tuple[int, int]
    """Of start and end."""
    latest: tuple[int, int]


@dataclass
class Order:
    """Two spans of two trains, and the literal that says whether the first one comes first; None: it always does."""

    first: Held
    second: Held
    literal: Literal | None


class OutOfTime(Exception):
    """The problem is too large to be written down in time."""


@dataclass
class Model:
    """The constraints of a problem.  `paths`: trains that keep their paths, and their order, in the known plan.

    until: the moment of the monotonic clock after which making it ends with `OutOfTime`."""

    problem: Problem
    known: Plan
    paths: Mapping[int, Sequence[int]] = field(default_factory=dict)
    until: float = float("inf")
    cp: cp_model.CpModel = field(default_factory=cp_model.CpModel)
    present: dict[tuple[int, int], Literal] = field(default_factory=dict)
    """Of operations that are not on every path."""
    start: dict[tuple[int, int], Any] = field(default_factory=dict)
    orders: list[Order] = field(default_factory=list)

    def __post_init__(self) -> None:
        self.windows: Windows = windows(self.problem, self.known, self.paths)
        self.after_all = horizon(self.problem, self.known)
        self._hinted = {(e.train, e.operation): e.time for e in self.known.events}
        self._rank = {(e.train, e.operation): k for k, e in enumerate(self.known.events)}
        self._arcs: dict[tuple[int, int, int], Literal] = {}
        self._ends: dict[tuple[int, int], Any] = {}
        for i in range(len(self.problem.trains)):
            self._train(i)
        self._resources()
        self._objective()

    # --- a train -----------------------------------------------------------------------------------

    def _train(self, i: int) -> None:
        operations, w = self.problem.trains[i], self.windows
        live = set(w.live[i])
        if not {0, len(operations) - 1} <= live:
            self.cp.add_bool_or([])  # the train cannot come through in time
        for k in w.live[i]:
            self.start[i, k] = self.cp.new_int_var(w.earliest[i][k], w.latest[i][k], f"s{i}_{k}")
            if k not in w.must(i):
                self.present[i, k] = self.cp.new_bool_var(f"x{i}_{k}")
        following = {k: [p for p in operations[k].following if p in live] for k in w.live[i]}
        coming: dict[int, list[int]] = {k: [] for k in w.live[i]}
        for k, ps in following.items():
            for p in ps:
                coming[p].append(k)
        for k, ps in following.items():
            for p in ps:
                self._arcs[i, k, p] = self._arc(i, k, p, len(ps), len(coming[p]))
        last = len(operations) - 1
        for k in w.live[i]:
            here = self.present.get((i, k), 1)
            if k != last:
                self.cp.add(sum(self._arcs[i, k, p] for p in following[k]) == here)
            if k != 0:
                self.cp.add(sum(self._arcs[i, q, k] for q in coming[k]) == here)
            for p in following[k]:
                self._only_if(self.start[i, p] >= self.start[i, k] + operations[k].duration, self._arcs[i, k, p])
            self._ends[i, k] = self._end(i, k, following[k])

    def _arc(self, i: int, k: int, p: int, out: int, into: int) -> Literal:
        if out == 1:
            return self.present.get((i, k), 1)
        if into == 1:
            return self.present.get((i, p), 1)
        return self.cp.new_bool_var(f"a{i}_{k}_{p}")

    def _end(self, i: int, k: int, following: Sequence[int]) -> Any:
        """The start of what comes next."""
        if not following:
            return None
        if len(following) == 1:
            return self.start[i, following[0]]
        least = self.windows.earliest[i][k] + self.problem.trains[i][k].duration
        end = self.cp.new_int_var(least, max(self.windows.latest[i][p] for p in following), f"e{i}_{k}")
        self.cp.add(end >= self.start[i, k] + self.problem.trains[i][k].duration)
        for p in following:
            self._only_if(end == self.start[i, p], self._arcs[i, k, p])
        return end

    def _only_if(self, constraint: Any, *literals: Literal | None) -> None:
        """A constraint that holds where all literals do; 1 and None are true."""
        made = self.cp.add(constraint)
        real = [x for x in literals if x is not None and not isinstance(x, int)]
        if real:
            made.only_enforce_if(real)

    def _in_time(self) -> None:
        if clock.monotonic() > self.until:
            raise OutOfTime

    # --- resources ---------------------------------------------------------------------------------

    def _resources(self) -> None:
        by_train, near = [], []
        for i, operations in enumerate(self.problem.trains):
            live = self.windows.live[i]
            found = spans(i, operations, live)
            by_train.append([self._held(s) for s in found])
            near.append(touching(operations, set(live), found, self._in_time))
        by: dict[str, list[tuple[int, int]]] = {}
        for i, helds in enumerate(by_train):
            for n, h in enumerate(helds):
                by.setdefault(h.span.resource, []).append((i, n))
        pairs: dict[tuple[int, int, int, int], Literal] = {}
        same: dict[tuple[int, tuple[int, ...], int, tuple[int, ...]], Literal] = {}
        for users in by.values():
            self._in_time()
            self._kept_order([by_train[i][n] for i, n in users if i in self.paths])
            for x, (i, n) in enumerate(users):
                self._in_time()
                for j, m in users[x + 1 :]:
                    if i != j and not (i in self.paths and j in self.paths):
                        pairs[i, n, j, m] = self._pair(by_train[i][n], by_train[j][m], same)
        self._tied(pairs, by_train, near)

    def _held(self, s: Span) -> Held:
        i, w = s.train, self.windows
        parts = set(s.operations)
        must = parts & w.must(i)
        presence = None if must else self._any(i, s.operations)
        comes = {p for q in w.live[i] if q not in parts for p in self.problem.trains[i][q].following}
        into = [k for k in s.operations if k == 0 or k in comes]
        low, high = min(w.earliest[i][k] for k in into), max(w.latest[i][k] for k in into)
        start = self.start[i, into[0]]
        if len(into) > 1:
            start = self.cp.new_int_var(low, high, "")
            for k in into:
                self._only_if(start <= self.start[i, k], self.present.get((i, k)))
        release = dict(zip(s.operations, s.releases, strict=True))
        over = [k for k in s.operations if not self.problem.trains[i][k].following]
        if over:
            never = self.after_all + 1
            return Held(s, presence, start, never, (low, never), (high, never))
        last = s.operations[-1]
        leaves = [k for k in s.operations if not set(self.problem.trains[i][k].following) <= parts]
        if leaves == [last] and all(release[k] <= release[last] for k in s.operations):
            end: Any = self._ends[i, last] + release[last]
            need = [last]
        else:
            need = list(s.operations)
            end = None
        ends = {k: self._bounds(i, k) for k in need}
        soonest = min(a + release[k] for k, (a, _) in ends.items())
        latest = max(b + release[k] for k, (_, b) in ends.items())
        if end is None:
            end = self.cp.new_int_var(soonest, latest, "")
            for k in need:
                self._only_if(end >= self._ends[i, k] + release[k], self.present.get((i, k)))
        return Held(s, presence, start, end, (low, soonest), (high, latest))

    def _bounds(self, i: int, k: int) -> tuple[int, int]:
        w = self.windows
        live = [p for p in self.problem.trains[i][k].following if (i, p) in self.start]
        return w.earliest[i][k] + self.problem.trains[i][k].duration, max(w.latest[i][p] for p in live)

    def _any(self, i: int, operations: Sequence[int]) -> Literal:
        if len(operations) == 1:
            return self.present[i, operations[0]]
        either = self.cp.new_bool_var("")
        for k in operations:
            self.cp.add_implication(self.present[i, k], either)
        self.cp.add_bool_or([either.negated(), *(self.present[i, k] for k in operations)])
        return either

    def _kept_order(self, users: list[Held]) -> None:
        """Trains with given paths keep their order at a resource."""
        users.sort(key=lambda h: self._rank[h.span.train, h.span.operations[0]])
        for a, b in pairwise(users):
            if a.span.train != b.span.train:
                self.cp.add(a.end <= b.start)
                self.orders.append(Order(a, b, None))

    def _pair(self, a: Held, b: Held, same: dict[Any, Literal]) -> Literal | None:
        """Two spans at one resource; the literal of their order, None where it cannot be chosen."""
        key = a.span.train, a.span.operations, b.span.train, b.span.operations
        if a.latest[1] < b.soonest[0] or b.latest[1] < a.soonest[0]:
            return None
        literal = same.get(key)
        if literal is None:
            literal = same[key] = self.cp.new_bool_var("")
            self.cp.add_hint(literal, int(self._first(a, b)))
        self._only_if(a.end <= b.start, literal, a.presence, b.presence)
        self._only_if(b.end <= a.start, literal.negated(), a.presence, b.presence)
        self.orders.append(Order(a, b, literal))
        return literal

    def _first(self, a: Held, b: Held) -> bool:
        """Whether the known plan has `a` before `b`."""
        ours, theirs = (
            [self._rank[h.span.train, k] for k in h.span.operations if (h.span.train, k) in self._rank] for h in (a, b)
        )
        if ours and theirs:
            return ours[0] < theirs[0]
        return a.soonest[0] <= b.soonest[0]

    def _tied(
        self, pairs: Mapping[tuple[int, int, int, int], Literal], held: list[list[Held]], near: list[list[list[int]]]
    ) -> None:
        """Orders at resources that two trains both go over at once are the same."""
        told = set()
        for (i, n, j, m), literal in pairs.items():
            self._in_time()
            if literal is None:
                continue
            for n2 in near[i][n]:
                for m2 in near[j][m]:
                    other = pairs.get((i, n2, j, m2))
                    if other is None or other.index <= literal.index or (literal.index, other.index) in told:
                        continue
                    told.add((literal.index, other.index))
                    there = [held[i][n].presence, held[i][n2].presence, held[j][m].presence, held[j][m2].presence]
                    self._only_if(literal == other, *there)

    # --- the objective -----------------------------------------------------------------------------

    def _objective(self) -> None:
        terms: list[Any] = []
        for d in self.problem.delays:
            key = d.train, d.operation
            if key not in self.start:
                continue
            start, here = self.start[key], self.present.get(key)
            late = self.windows.latest[d.train][d.operation] - d.due
            if d.rate and late > 0:
                by = self.cp.new_int_var(0, late, "")
                self._only_if(by >= start - d.due, here)
                self.cp.add_hint(by, max(0, self._hinted.get(key, d.due) - d.due))
                terms.append(d.rate * by)
            if d.once and late >= 0:
                too_late = self.cp.new_bool_var("")
                self._only_if(start < d.due, too_late.negated(), here)
                self.cp.add_hint(too_late, int(self._hinted.get(key, d.due - 1) >= d.due))
                terms.append(d.once * too_late)
        for key, variable in self.start.items():
            self.cp.add_hint(variable, self._hinted.get(key, self.windows.earliest[key[0]][key[1]]))
        for key, literal in self.present.items():
            self.cp.add_hint(literal, int(key in self._hinted))
        self.cp.add(sum(terms) <= self.known.cost)
        self.cp.minimize(sum(terms))

    # --- what a solution says ----------------------------------------------------------------------

    def plan(self, solver: cp_model.CpSolver) -> tuple[Plan | None, list[Literal]]:
        """The plan of a solution; or none, and the literals of orders and of paths by which trains would change places:
        wherever all of them are true, they do."""
        path: dict[int, list[int]] = {}
        for i, k in self.start:
            present = self.present.get((i, k))
            if present is None or solver.boolean_value(present):
                path.setdefault(i, []).append(k)
        following = {(i, k): (i, p) for i, ks in path.items() for k, p in pairwise(ks)}
        times = {(i, k): solver.value(self.start[i, k]) for i, ks in path.items() for k in ks}
        here: dict[Node, Literal] = {x: self.present.get(x, 1) for x in times}
        arcs: dict[Node, list[tuple[Node, tuple[Literal, ...]]]] = {x: [] for x in times}
        for x, y in following.items():
            arcs[x].append((y, (here[x], here[y])))
        for o in self.orders:
            a, b, literal = o.first, o.second, o.literal
            if literal is not None and not solver.boolean_value(literal):
                a, b, literal = b, a, literal.negated()
            left = [k for k in a.span.operations if (a.span.train, k) in times]
            comes = [k for k in b.span.operations if (b.span.train, k) in times]
            if left and comes:
                last, first = (a.span.train, left[-1]), (b.span.train, comes[0])
                next_ = following[last]
                left_by = self._arcs[*last, next_[1]]  # by another way it may leave later
                arcs[next_].append((first, (1 if literal is None else literal, left_by, here[first])))
        row = _in_order(times, arcs)
        if len(row) == len(times):
            return planned(self.problem, [Event(times[x], *x) for x in row]), []
        return None, _cycle(times.keys() - set(row), arcs)


Node = tuple[int, int]
Arcs = Mapping[Node, Sequence[tuple[Node, tuple[Literal, ...]]]]
"""By event: those that come after it, each with the literals that make it so; 1 is true."""


def _in_order(times: Mapping[Node, int], arcs: Arcs) -> list[Node]:
    """Events in an order that keeps all arcs; those on and behind a cycle are missing."""
    waits = dict.fromkeys(times, 0)
    for targets in arcs.values():
        for y, _ in targets:
            waits[y] += 1
    ready = [(times[x], x) for x, n in waits.items() if n == 0]
    heapq.heapify(ready)
    row = []
    while ready:
        _, x = heapq.heappop(ready)
        row.append(x)
        for y, _ in arcs[x]:
            waits[y] -= 1
            if waits[y] == 0:
                heapq.heappush(ready, (times[y], y))
    return row


def _cycle(left: set[Node], arcs: Arcs) -> list[Literal]:
    """The literals on one cycle among events that have no order, each once."""
    inverse: dict[Node, list[tuple[Node, tuple[Literal, ...]]]] = {}
    for x in left:
        for y, literals in arcs[x]:
            if y in left:
                inverse.setdefault(y, []).append((x, literals))
    row, seen = list[tuple[Literal, ...]](), dict[Node, int]()
    at = min(left)
    while at not in seen:
        seen[at] = len(row)
        before, literals = inverse[at][0]
        row.append(literals)
        at = before
    return list({x.index: x for literals in row[seen[at] :] for x in literals if not isinstance(x, int)}.values())
