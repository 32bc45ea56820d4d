"""The transition relation: which steps there are.

A step is told by definitions: the controller's wires, the plant's events, and for each state variable `v` its next
value `v'`.  An expression about a step speaks of all of these names.  What is not defined is free, but for what the
assumptions say.

**Theorem.**  With the name of its next value for each variable, an expression has the value in a step that it has in
the state after that step.  (Substitution lemma; priming: Manna and Pnueli, *Temporal Verification of Reactive Systems*,
1995.)
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import field, replace
from functools import cached_property

from interlock.dataclass import dataclass
from interlock.logic.controller import Timer
from interlock.logic.expr import Expr, Substitution, var, variables
from interlock.logic.names import Name
from interlock.logic.plant import Assumption


@dataclass(frozen=True, eq=False)
class TransitionRelation:
    """State, inputs, definitions and assumptions of a step; without any of them there is no step.

    inputs: free variables of a step, timers among them, of which A-TON is assumed.  sizes: how many values those inputs
    have that have more than two.
    """

    state: tuple[Name, ...] = ()
    inputs: tuple[Name, ...] = ()
    sizes: Mapping[Name, int] = field(default_factory=dict)
    timers: Mapping[Name, Timer] = field(default_factory=dict)
    definitions: Mapping[Name, Expr] = field(default_factory=dict)
    assumptions: Sequence[Assumption] = ()
    after: Callable[[Expr], Expr] = field(default_factory=lambda: primed(()))
    """The expression one step later: about a state becomes about the next one."""

    @cached_property
    def later(self) -> Mapping[Name, Name]:
        """The names of next values by those of the state."""
        return {n: n.next for n in self.state}

    @cached_property
    def reads(self) -> Mapping[Name, tuple[Name, ...]]:
        """The names that each definition reads."""
        return {n: tuple(variables((x,))) for n, x in self.definitions.items()}

    def under(self, changed: Mapping[Name, Expr]) -> TransitionRelation:
        """The same with other definitions of some names; what the rest reads is not sought again."""
        other = replace(self, definitions={**self.definitions, **changed})
        vars(other)["reads"] = {**self.reads, **{n: tuple(variables((x,))) for n, x in changed.items()}}
        return other


def primed(state: Sequence[Name]) -> Callable[[Expr], Expr]:
    """Turns expressions about a state into those about the state one step later."""
    return Substitution({n: var(n.next) for n in state})
