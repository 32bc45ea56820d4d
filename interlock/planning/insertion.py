"""One train through the times that others leave free: the cheapest path and times, exactly.

The others are fixed.  A train may wait wherever it holds what the operation needs, so within one free window of an
operation an earlier arrival with no greater cost is never worse: labels are kept by operation and window.

Time is counted in ticks, `TICK` to a unit, and whatever happens takes at least one: so the order of ticks is the strict
order in which events of one time happen.  A train that takes over a section does so a tick after it was left.
"""

from __future__ import annotations

from bisect import bisect_right, insort
from collections.abc import Iterable
from dataclasses import field
from heapq import heappop, heappush
from typing import Any

from interlock.dataclass import dataclass
from interlock.planning.problem import Delay, Event, Operation, Plan, Problem, planned

TICK = 1 << 20
NEVER = 1 << 62

Path = tuple[tuple[int, int], ...]
"""Operations of a train, and the tick at which each begins."""


def after(tick: int, units: int) -> int:
    """The tick at which something of so many units, begun at a tick, is over at the soonest."""
    return (tick // TICK + units) * TICK if units else tick + 1


@dataclass
class Diary:
    """Who holds what, and when: by resource, in order, (tick of the start, tick of the end for others, train)."""

    problem: Problem
    held: dict[str, list[tuple[int, int, int]]] = field(default_factory=dict)
    paths: dict[int, Path] = field(default_factory=dict)
    known: dict[int, Ways] = field(default_factory=dict)
    """What of a train does not depend on the others."""

    def ways(self, train: int) -> Ways:
        """The ways of a train."""
        found = self.known.get(train)
        if found is None:
            found = self.known[train] = Ways(self.problem, train)
        return found

    def put(self, train: int, path: Path) -> None:
        """A train takes its path; the beginning of one: what comes after it is not known yet."""
        self.paths[train] = path
        for name, start, end in self._spans(train, path):
            insort(self.held.setdefault(name, []), (start, end, train))

    def take(self, train: int) -> None:
        """A train is taken out again."""
        for name in {name for name, _, _ in self._spans(train, self.paths.pop(train))}:
            self.held[name] = [x for x in self.held[name] if x[2] != train]

    def _spans(self, train: int, path: Path) -> Iterable[tuple[str, int, int]]:
        """What a train holds without a break, joined."""
        if not path:
            return
        last = self.problem.trains[train][path[-1][0]]
        over = after(path[-1][1], last.duration) if last.following else NEVER
        ends = [*(tick for _, tick in path[1:]), over]
        held: dict[str, tuple[int, int, int]] = {}
        for (o, start), end in zip(path, ends, strict=True):
            for u in self.problem.trains[train][o].uses:
                until = NEVER if end == NEVER else after(end, u.release)
                old = held.get(u.resource)
                if old is not None and old[1] == start:
                    held[u.resource] = old[0], end, max(old[2], until)
                    continue
                if old is not None:
                    yield u.resource, old[0], old[2]
                held[u.resource] = start, end, until
        for name, (start, _, until) in held.items():
            yield name, start, until

    def stands(self, train: int, until: int = NEVER) -> None:
        """A train without a path is where it begins: its first operation's resources are held until a tick."""
        o = self.problem.trains[train][0]
        for u in o.uses:
            insort(self.held.setdefault(u.resource, []), (o.earliest * TICK, until, train))

    def goes(self, train: int) -> None:
        """What `stands` has written is taken out."""
        for u in self.problem.trains[train][0].uses:
            self.held[u.resource] = [x for x in self.held[u.resource] if x[2] != train]

    def windows(self, train: int, o: Operation) -> list[tuple[int, int]]:
        """When an operation may begin at the soonest, and the last tick at which it may be over, window by window."""
        taken = []
        for u in o.uses:
            for start, end, other in self.held.get(u.resource, ()):
                if other != train:
                    over = (start // TICK - u.release + 1) * TICK - 1 if u.release else start - 1
                    taken.append((over, end))
        taken.sort()
        found, begin = [], 0
        for over, end in taken:
            if over > begin:
                found.append((begin, over))
            begin = max(begin, end)
        if begin < NEVER:
            found.append((begin, NEVER))
        return found

    def plan(self) -> Plan:
        """All paths as a plan."""
        events = sorted((tick, train, o) for train, path in self.paths.items() for o, tick in path)
        return planned(self.problem, [Event(tick // TICK, train, o) for tick, train, o in events])


class Ways:
    """The ways of one train through a diary, as they stand: the best one is searched for by A*.

    A label is (operation, tick, label before).  What could be over soonest at the least cost goes on first; `rest` is
    what is still to be done at least."""

    def __init__(self, problem: Problem, train: int) -> None:
        self.train, self.operations = train, problem.trains[train]
        count = len(self.operations)
        self.following = [o.following for o in self.operations]
        self.duration = [o.duration for o in self.operations]
        self.begin = [o.earliest * TICK for o in self.operations]
        self.latest = [NEVER if o.latest is None else (o.latest + 1) * TICK - 1 for o in self.operations]
        self.delays: list[list[Delay]] = [[] for _ in range(count)]
        for d in problem.delays:
            if d.train == train:
                self.delays[d.operation].append(d)
        self.rest = [0] * count
        for k in range(count - 2, -1, -1):
            self.rest[k] = min(self.duration[k] * TICK + self.rest[p] for p in self.following[k])
        last = self.operations[-1]
        self._at_end = self.delays[-1] if last.following == () else []

    def best(self, diary: Diary, begun: Path = ()) -> Path | None:
        """The cheapest path, the soonest among the cheapest; None: there is none.  begun: how it begins."""
        label: Any
        windows: list[list[tuple[int, int]] | None] = [None] * len(self.operations)
        seen: dict[tuple[int, int], list[tuple[int, int]]] = {}
        heap: list[Any] = []
        serial = 0
        todo: list[tuple[int, int, int, int, Any]] = [(0, 0, NEVER, 0, None)]
        if begun:
            label = None
            for o, tick in begun[:-1]:
                label = o, tick, label
            o, tick = begun[-1]
            todo = [(o, tick, tick, sum(self._price(q, t) for q, t in begun[:-1]), label)]
        while True:
            for p, low, high, price, before in todo:
                found = windows[p]
                if found is None:
                    found = windows[p] = diary.windows(self.train, self.operations[p])
                low, high = max(low, self.begin[p]), min(high, self.latest[p])
                for w in range(bisect_right(found, low, key=_end), len(found)):
                    begin, over = found[w]
                    tick = max(low, begin)
                    if tick > high:
                        break
                    if after(tick, self.duration[p]) > over:
                        continue
                    paid = price + self._price(p, tick)
                    known = seen.setdefault((p, w), [])
                    if any(a <= tick and b <= paid for a, b in known):
                        continue
                    known.append((tick, paid))
                    serial -= 1
                    end = tick + self.rest[p]
                    heappush(heap, (self._least(p, paid, end), end, -p, serial, tick, w, paid, before))
            if not heap:
                return None
            _, _, p, _, tick, w, paid, before = heappop(heap)
            p, label = -p, (-p, tick, before)
            over = windows[p][w][1]
            if not self.following[p]:
                if over == NEVER or not self.operations[p].uses:
                    return _path(label)
                todo = []
                continue
            soonest = after(tick, self.duration[p])
            todo = [(q, soonest, over, paid, label) for q in self.following[p]]

    def _price(self, operation: int, tick: int) -> int:
        ours = self.delays[operation]
        return sum(d.of(tick // TICK) for d in ours) if ours else 0

    def _least(self, operation: int, paid: int, end: int) -> int:
        """What a way costs at least that goes on from an operation."""
        if operation == len(self.operations) - 1:
            return paid
        return paid + sum(d.of(end // TICK) for d in self._at_end)


def _end(window: tuple[int, int]) -> int:
    return window[1]


def _path(label: Any) -> Path:
    found = []
    while label is not None:
        found.append(label[:2])
        label = label[2]
    return tuple(reversed(found))


def inserted(diary: Diary, train: int, begun: Path = ()) -> Path | None:
    """The cheapest path of a train among the others as they are, the soonest among the cheapest; None: there is none.

    begun: how it begins."""
    return diary.ways(train).best(diary, begun)


def diary_of(problem: Problem, plan: Plan, before: Diary | None = None) -> Diary:
    """A plan's paths, in ticks; before: a diary of the same problem."""
    diary, paths, now = Diary(problem), dict[int, list[tuple[int, int]]](), -1
    if before is not None:
        diary.known = before.known
    for e in plan.events:
        now = max(now + 1, e.time * TICK)
        paths.setdefault(e.train, []).append((e.operation, now))
    for train, path in paths.items():
        diary.put(train, tuple(path))
    return diary


def without_waste(problem: Problem, plan: Plan) -> Plan:
    """The same paths and the same order, everything as early as it can be."""
    at: dict[int, tuple[int, int]] = {}
    free: dict[str, dict[int, int]] = {}
    found = []
    for k, e in enumerate(plan.events):
        o = problem.trains[e.train][e.operation]
        time = o.earliest
        if e.train in at:
            before, begun = at[e.train]
            time = max(time, begun + problem.trains[e.train][before].duration)
        for u in o.uses:
            time = max([time, *(t for other, t in free.get(u.resource, {}).items() if other != e.train)])
        if e.train in at:
            for u in problem.trains[e.train][at[e.train][0]].uses:
                mine = free.setdefault(u.resource, {})
                mine[e.train] = max(mine.get(e.train, 0), time + u.release)
        at[e.train] = e.operation, time
        found.append((time, k, e))
    found.sort(key=lambda x: x[:2])
    return planned(problem, [Event(time, e.train, e.operation) for time, _, e in found])
