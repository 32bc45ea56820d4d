"""What a controller certainly is when the restart delay is over.

From power-up until the restart delay is over the controller scans with any inputs, and trains that ran at the power cut
may still run.  The start values that every such scan keeps, whatever is read, are what is known of the controller
afterwards; nothing else is, and the induction begins there, with trains standing anywhere (A-RESTART).  The set is the
greatest one that a scan keeps: values are dropped until none is lost (Kleene's three values: a value that is not
determined by those that are kept counts as lost).

**Theorem.**  What holds of the start values, and is kept by every scan while the restart delay runs, whatever it reads,
holds when the delay is over, after however many scans; and what three values determine is so under every value of what
they leave open.  (Induction over scans; greatest fixed point: Tarski, 1955; Kleene, *Introduction to Metamathematics*,
1952.)
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from functools import cached_property

from interlock.dataclass import dataclass
from interlock.logic import names
from interlock.logic.controller import Controller, Timer
from interlock.logic.expr import Expr, conj, iff, neg, settled, var
from interlock.logic.names import Name
from interlock.proof.system.clocks import Tie
from interlock.proof.system.loop import ClosedLoop
from interlock.proof.system.relation import TransitionRelation

_REMEMBERED = (names.SEEN, names.SHUNT_SEEN, names.OLD_COMMAND)  # what the plant remembers of outputs


@dataclass(frozen=True, slots=True)
class Kept:
    """The variables whose start value every scan keeps, and what was known in each round in which they were found."""

    names: frozenset[Name]
    rounds: tuple[Mapping[Name, bool], ...]

    def unchanged(self, changed: Mapping[Name, Expr]) -> bool:
        """Whether the same is found where some names stand for other expressions: these have in each round the value
        that was known, or none as before."""
        return all(known.get(name) is settled(x, known) for known in self.rounds for name, x in changed.items())


@dataclass(frozen=True)
class InitialCondition:
    """The initial states: the controller's start-up, trains at a stand and points anyhow.

    parts: one condition after the other.  kept: what the restart delay keeps of the values at power-up.
    """

    parts: tuple[Expr, ...]
    kept: Kept

    @cached_property
    def whole(self) -> Expr:
        """All of it."""
        return conj(self.parts)


def initial_condition(loop: ClosedLoop, ties: Iterable[Tie], relation: TransitionRelation) -> InitialCondition:
    """What is known when the restart delay is over."""
    start = _at_power_up(loop, ties)
    following = {x: relation.definitions[x] for n, x in relation.later.items() if n in start}
    kept = kept_values(loop.controller, start, following)
    known = [var(n) if start[n] else neg(var(n)) for n in start if n in kept.names]
    shown = [iff(var(x.name), x.expr) for x in loop.controller.outputs if x.name not in kept.names]
    return InitialCondition((*known, *shown, *loop.plant.initial), kept)


def _at_power_up(loop: ClosedLoop, ties: Iterable[Tie]) -> dict[Name, bool]:
    """What the controller, its outputs and what is remembered of them are at power-up."""
    controller = loop.controller
    start = {x.name: x.initial for x in controller.state} | {x.name: x.restrictive for x in controller.outputs}
    start |= dict.fromkeys((names.BEEN(s) for s in loop.topo.sections), False)
    start |= dict.fromkeys((names.SHUT(r.number) for r in controller.symbols.routes), False)
    start |= dict.fromkeys((t.covered for t in ties), True)
    start |= dict.fromkeys((n for n in loop.plant.state if n.family in _REMEMBERED), False)
    return start


def kept_values(controller: Controller, start: Mapping[Name, bool], following: Mapping[Name, Expr]) -> Kept:
    """The variables of `start` whose value there every scan keeps while the restart delay runs.

    `following`: the definitions of their next values, in an order in which each reads only next values before it.
    """
    kept, rounds = dict(start), []
    while True:
        known = dict(kept)
        rounds.append(known)
        known[controller.symbols.start.restart_timer] = False
        for step in controller.steps:
            if not isinstance(step, Timer):
                _note(known, step.name, settled(step.expr, known))
            elif known.get(step.input) is False:
                known[step.name] = False
        for name, x in following.items():
            _note(known, name, settled(x, known))
        lost = [name for name, value in kept.items() if known.get(name.next) is not value]
        if not lost:
            return Kept(frozenset(kept), tuple(rounds))
        for name in lost:
            del kept[name]


def _note(known: dict[Name, bool], name: Name, value: bool | None) -> None:
    if value is not None:
        known[name] = value
