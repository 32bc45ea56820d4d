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
    return [every[k] for k in _by_place(every, _numbered(every), following)]


def together(steps: Sequence[Step], following: Mapping[Name, Equation]) -> list[Step]:
    """The same, what belongs to one place in as few pieces as may be: as long as anything more of a place can be
    computed, it is.

    For a text in which a block may read what any other computes, whatever that costs elsewhere.
    """
    every: list[Step] = [*steps, *following.values()]
    reads = _numbered(every)
    order = _by_place(every, reads, following)
    at = [0] * len(every)  # where a step stands in this order
    readers: list[list[int]] = [[] for _ in every]
    for k, step in enumerate(order):
        at[step] = k
        for n in reads[step]:
            readers[n].append(step)
    waits = [len(read) for read in reads]
    ready: dict[str, list[int]] = {"timers": [], **{s.group: [] for s in every if isinstance(s, Equation)}}
    here = [ready[s.group if isinstance(s, Equation) else "timers"] for s in every]
    first: list[int] = []  # what is ready anywhere, and what was

    def enter(step: int) -> None:
        heappush(here[step], at[step])
        heappush(first, at[step])

    for step in order:
        if not waits[step]:
            enter(step)
    out: list[Step] = []
    while first:
        k = heappop(first)
        mine = here[order[k]]
        if k not in mine[:1]:
            continue  # it is done
        while mine:
            step = order[heappop(mine)]
            out.append(every[step])
            for n in readers[step]:
                waits[n] -= 1
                if not waits[n]:
                    enter(n)
    return out


def _reads(s: Step) -> tuple[Name, ...]:
    return s.reads if isinstance(s, Equation) else (s.input,)


def _numbered(every: Sequence[Step]) -> list[list[int]]:
    """By the number of each step those of the steps that it reads."""
    at = {s.name: k for k, s in enumerate(every)}
    return [[at[n] for n in _reads(s) if n in at] for s in every]


def _by_place(every: Sequence[Step], reads: Sequence[Sequence[int]], following: Mapping[Name, Equation]) -> list[int]:
    place = _places(every, following)
    wires: list[list[int]] = []  # by the number of timers that stand one behind the other before them
    timers: list[list[int]] = []
    behind: list[int] = []  # a timer closes the stage of what it waits for
    for k, s in enumerate(every):
        stage = max([behind[n] for n in reads[k]], default=0)
        behind.append(stage + isinstance(s, Timer))
        while len(wires) <= stage:
            wires.append([])
            timers.append([])
        (timers if isinstance(s, Timer) else wires)[stage].append(k)
    out: list[int] = []
    left = [False] * len(every)
    for those, waiting in zip(wires, timers, strict=True):
        for k in those:
            left[k] = True
        for k in sorted(those, key=lambda k: place[k]):
            _after_inputs(k, reads, left, out)
        out += waiting
    return out


def _after_inputs(root: int, reads: Sequence[Sequence[int]], left: list[bool], out: list[int]) -> None:
    """Add a step that is left to those that are done, what is left of what it reads before it."""
    stack = [root]
    while stack:
        k = stack[-1]
        waiting = [n for n in reads[k] if left[n]] if left[k] else []
        if waiting:
            stack.extend(reversed(waiting))
        elif left[stack.pop()]:
            left[k] = False
            out.append(k)


def _places(every: Sequence[Step], following: Mapping[Name, Equation]) -> list[int]:
    """By the number of each step the place of its group in the order in which a walk over groups that read each other
    comes to them; a state variable is of the group of its next value."""
    group = {s.name: s.group for s in every if isinstance(s, Equation)}
    group |= {n: e.group for n, e in following.items()}
    adjacent: dict[str, dict[str, None]] = {g: {} for g in group.values()}
    for s in every:
        if isinstance(s, Equation):
            here, beside = s.group, adjacent[s.group]
            for n in s.reads:
                there = group.get(n, here)
                if there not in beside and there != here:
                    beside[there] = adjacent[there][here] = None
    place: dict[str, int] = {}
    for start in adjacent:
        todo = deque([start])
        while todo:
            g = todo.popleft()
            if g not in place:
                place[g] = len(place)
                if len(adjacent[g]) <= MAX_DEGREE:
                    todo.extend(adjacent[g])
    return [place[s.group] if isinstance(s, Equation) else 0 for s in every]
