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
    return [every[k] for k in _by_place(every, *_numbered(every, following))]


def together(steps: Sequence[Step], following: Mapping[Name, Equation]) -> list[Step]:
    """The same, what belongs to one place in as few pieces as may be: as long as anything more of a place can be
    computed, it is.

    For a text in which a block may read what any other computes, whatever that costs elsewhere.
    """
    every: list[Step] = [*steps, *following.values()]
    reads, near = _numbered(every, following)
    order = _by_place(every, reads, near)
    at = [0] * len(every)  # where a step stands in this order
    readers: list[list[int]] = [[] for _ in every]
    for k, step in enumerate(order):
        at[step] = k
        for n in reads[step]:
            readers[n].append(step)
    waits = [len(read) for read in reads]
    ready: dict[str, list[int]] = {"timers": [], **{s.group: [] for s in every if isinstance(s, Equation)}}
    here = [ready[s.group if isinstance(s, Equation) else "timers"] for s in every]
    for step in order:
        if not waits[step]:
            here[step].append(at[step])  # in their order: a heap
    out: list[Step] = []
    for k, first in enumerate(order):  # all that it reads is done, since that stands before it in this order
        mine = here[first]
        if mine[:1] != [k]:
            continue  # it is done
        while mine:
            step = order[heappop(mine)]
            out.append(every[step])
            for n in readers[step]:
                waits[n] -= 1
                if not waits[n]:
                    heappush(here[n], at[n])
    return out


def _numbered(every: Sequence[Step], following: Mapping[Name, Equation]) -> tuple[list[list[int]], list[list[int]]]:
    """By the number of each step those of the steps that it reads; and these with those of the next values of the
    state variables that it reads."""
    at = {s.name: k for k, s in enumerate(every)}
    wires = len(every)
    near = dict(at)
    near |= {n: wires + at[e.name] for n, e in following.items()}  # told apart by more than their number
    found = [[near[n] for n in (s.reads if isinstance(s, Equation) else (s.input,)) if n in near] for s in every]
    return [[k for k in read if k < wires] for read in found], [[k % wires for k in read] for read in found]


def _by_place(every: Sequence[Step], reads: Sequence[Sequence[int]], near: Sequence[Sequence[int]]) -> list[int]:
    place = _places(every, near)
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


def _places(every: Sequence[Step], near: Sequence[Sequence[int]]) -> list[int]:
    """By the number of each step the place of its group in the order in which a walk over groups that read each other
    comes to them; a state variable is of the group of its next value."""
    group = [s.group if isinstance(s, Equation) else None for s in every]
    adjacent: dict[str, dict[str, None]] = {g: {} for g in group if g is not None}
    for here, those in zip(group, near, strict=True):
        if here is not None:
            beside = adjacent[here]
            for n in those:
                there = group[n]
                if there not in beside and there != here and there is not None:
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
    return [0 if g is None else place[g] for g in group]
