"""The order in which a text computes: what belongs to one place of the railway stands together.

A controller lists its equations kind by kind.  In a text that is cut into blocks, each block would read something of
every place, and declare it.  Here the equations are listed place by place, each after what it reads, and timers
stand together.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Mapping, Sequence
from heapq import heappop, heappush

from interlock.logic.controller import Equation, Step, Timer
from interlock.logic.names import Name

MAX_DEGREE = 60  # the walk goes on from no group that reads, or is read by, more groups than this


def by_place(steps: Sequence[Step], following: Mapping[Name, Equation]) -> list[Step]:
    """The steps of a scan and, by state variable, the equations of the next values, place by place.

    Every step comes after those that it reads.  Timers stand after what they wait for and before what waits for them.
    """
    every: list[Step] = [*steps, *following.values()]
    reads = {s.name: _reads(s) for s in every}
    stage = _stages(every, reads)
    group = {s.name: s.group for s in every if isinstance(s, Equation)}
    place = _places(reads, group | {n: e.group for n, e in following.items()})
    of = {s.name: s for s in every}
    out: list[Step] = []
    for k in range(max(stage.values(), default=0) + 1):
        here = [s for s in every if stage[s.name] == k]
        wires = [s for s in here if isinstance(s, Equation)]
        done: dict[Name, None] = {}
        names = {e.name for e in wires}
        for root in sorted(wires, key=lambda e: place[e.group]):
            _after_inputs(root.name, reads, names, done)
        out += [of[n] for n in done]
        out += [s for s in here if isinstance(s, Timer)]
    return out


def together(steps: Sequence[Step], following: Mapping[Name, Equation]) -> list[Step]:
    """The same, what belongs to one place in as few pieces as may be: as long as anything more of a place can be
    computed, it is.

    For a text in which a block may read what any other computes, whatever that costs elsewhere.
    """
    every = by_place(steps, following)
    at = {s.name: k for k, s in enumerate(every)}
    place = {s.name: s.group if isinstance(s, Equation) else "timers" for s in every}
    waits = {s.name: sum(n in at for n in dict.fromkeys(_reads(s))) for s in every}
    readers: dict[Name, list[Name]] = {}
    for s in every:
        for n in dict.fromkeys(_reads(s)):
            readers.setdefault(n, []).append(s.name)
    ready: dict[str, list[int]] = {p: [] for p in place.values()}
    first: list[int] = []  # what is ready anywhere, and what was

    def enter(k: int) -> None:
        heappush(ready[place[every[k].name]], k)
        heappush(first, k)

    for n, k in at.items():
        if not waits[n]:
            enter(k)
    out: list[Step] = []
    while first:
        k = heappop(first)
        here = ready[place[every[k].name]]
        if k not in here[:1]:
            continue  # it is done
        while here:
            s = every[heappop(here)]
            out.append(s)
            for n in readers.get(s.name, ()):
                waits[n] -= 1
                if not waits[n]:
                    enter(at[n])
    return out


def _reads(s: Step) -> tuple[Name, ...]:
    return s.reads if isinstance(s, Equation) else (s.input,)


def _stages(every: Sequence[Step], reads: dict[Name, tuple[Name, ...]]) -> dict[Name, int]:
    """How many timers stand one behind the other before each step; a timer closes the stage of what it waits for."""
    stage: dict[Name, int] = {}
    behind: dict[Name, int] = {}  # by a timer, or what stands behind one: the stage of what reads it
    for s in every:
        late = [behind[n] for n in reads[s.name] if n in behind]
        stage[s.name] = k = max(late) if late else 0
        if k or isinstance(s, Timer):
            behind[s.name] = k + isinstance(s, Timer)
    return stage


def _after_inputs(root: Name, reads: dict[Name, tuple[Name, ...]], among: set[Name], done: dict[Name, None]) -> None:
    """Add a step to those that are done, what it reads before it."""
    stack = [root]
    while stack:
        name = stack[-1]
        waiting = [n for n in reads[name] if n in among and n not in done] if name not in done else []
        if waiting:
            stack.extend(reversed(waiting))
        else:
            done.setdefault(stack.pop())


def _places(reads: dict[Name, tuple[Name, ...]], group: dict[Name, str]) -> dict[str, int]:
    """Groups of equations by the order in which a walk over what reads each other comes to them.

    `group`: of each equation, and of each state variable.
    """
    adjacent: dict[str, dict[str, None]] = {g: {} for g in group.values()}
    for name, read in reads.items():
        here = group.get(name)
        for n in read:
            there = group.get(n, here)
            if here is not None and there is not None and here != there:
                adjacent[here].setdefault(there)
                adjacent[there].setdefault(here)
    place: dict[str, int] = {}
    for start in adjacent:
        todo = deque([start])
        while todo:
            g = todo.popleft()
            if g not in place:
                place[g] = len(place)
                if len(adjacent[g]) <= MAX_DEGREE:
                    todo.extend(adjacent[g])
    return place
