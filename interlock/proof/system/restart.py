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

from collections.abc import Mapping
from dataclasses import dataclass

from interlock.logic.controller import Controller, Timer
from interlock.logic.expr import FALSE, TRUE, Expr, Substitution
from interlock.logic.names import Name


@dataclass(frozen=True, slots=True)
class Kept:
    """The variables whose start value every scan keeps, and what was known in each round in which they were found."""

    names: frozenset[Name]
    rounds: tuple[Mapping[Name, Expr], ...]

    def unchanged(self, changed: Mapping[Name, Expr]) -> bool:
        """Whether the same is found where some names stand for other expressions: these have in each round the value
        that was known, or none as before."""
        for known in self.rounds:
            put = Substitution(known)
            for name, x in changed.items():
                value = put(x)
                if known.get(name) is not (value if value is TRUE or value is FALSE else None):
                    return False
        return True


def kept_values(
    controller: Controller, start: Mapping[Name, Expr], following: Mapping[Name, Expr], later: Mapping[Name, Name]
) -> Kept:
    """The variables of `start` (constants by name) whose value every scan keeps while the restart delay runs.

    `following`: the definitions of next values that are to be looked at, by `later[name]`, in an order in which each
    reads only next values before it.
    """
    kept, rounds = dict(start), []
    while True:
        known = dict(kept)
        rounds.append(known)
        put = Substitution(known)
        known[controller.symbols.start.restart_timer] = FALSE
        for step in controller.steps:
            if not isinstance(step, Timer):
                _note(known, step.name, put(step.expr))
            elif known.get(step.input) is FALSE:
                known[step.name] = FALSE
        for name, x in following.items():
            _note(known, name, put(x))
        lost = [name for name, value in kept.items() if known.get(later[name]) is not value]
        if not lost:
            return Kept(frozenset(kept), tuple(rounds))
        for name in lost:
            del kept[name]


def _note(known: dict[Name, Expr], name: Name, value: Expr) -> None:
    if value is TRUE or value is FALSE:
        known[name] = value
