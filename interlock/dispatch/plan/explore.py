"""Every state that trains can come to when nobody holds them back, and which of them lead nowhere."""

from __future__ import annotations

from interlock.dataclass import dataclass
from interlock.dispatch.plan.problem import Move, Problem

MOST_STATES = 500_000
"""States that are looked at (our choice)."""


class TooManyStates(Exception):
    """More states than can be looked at."""


@dataclass(frozen=True)
class Explored:
    """What there is: states reachable without the rule, which are where each train stands and by which route it came
    there; unsafe ones, from which not all can finish; deadlocks, in which no train can move; moves between safe states,
    all of which the rule allows; those into unsafe ones, none of which it allows.

    standing: deadlocks told apart by where the trains stand alone.  shortest: moves to the nearest deadlock;
    `last_safe`: how many of them lead to states that are safe.
    """

    states: int
    unsafe: frozenset[int]
    deadlocks: frozenset[int]
    standing: int
    safe_moves: int
    refused_moves: int
    shortest: tuple[Move, ...] | None
    last_safe: int


def explore(p: Problem, start: int, most: int = MOST_STATES) -> Explored:
    """All states from a start.  Raises `TooManyStates`."""
    came: dict[int, Move | None] = {start: None}
    before: dict[int, list[int]] = {}
    order = [start]
    stuck: list[int] = []
    for state in order:  # grows while it is read
        moves = _possible(p, state)
        if not moves and not p.done(state):
            stuck.append(state)
        for m in moves:
            after = state & ~m.source | m.target
            before.setdefault(after, []).append(state)
            if after not in came:
                came[after] = m
                order.append(after)
                if len(order) > most:
                    raise TooManyStates(f"more than {most} states")
    safe = {s for s in order if p.done(s)}
    todo = list(safe)
    while todo:
        for s in before.get(todo.pop(), ()):
            if s not in safe:
                safe.add(s)
                todo.append(s)
    inner = sum(s in safe for after in safe for s in before.get(after, ()))
    refused = sum(s in safe for after, ss in before.items() if after not in safe for s in ss)
    path: list[Move] = []
    states: list[int] = []
    if stuck:
        at = stuck[0]
        while (by := came[at]) is not None:
            path.append(by)
            states.append(at)
            at = at & ~by.target | by.source
    last_safe = sum(s in safe for s in states)
    return Explored(
        len(order),
        frozenset(order) - safe,
        frozenset(stuck),
        len({tuple(p.label[b] for b in p.at(s)) for s in stuck}),
        inner,
        refused,
        tuple(path[::-1]) if stuck else None,
        last_safe,
    )


def _possible(p: Problem, state: int) -> list[Move]:
    return [m for b in p.at(state) for m in p.moves[b] if p.possible(state, m)]
