"""Controller and plant as one transition system: the closed loop, its transition relation, its initial condition.

Whoever asks something of it takes the part that he needs: runs and stories the loop, induction the relation, what is
asked of one place the neighbourhood, claims the names and not the equations (`claims.Facts`).

**Theorem.**  Every name in the system is state, input or defined, and none is two of these (`_check_closed`), and a
definition reads only what stands before it: so state and inputs determine a step, and a formula that follows from
definitions and assumptions holds in every step of every run.  (Transition systems: Manna and Pnueli, *Temporal
Verification of Reactive Systems*, 1995.)
"""

from __future__ import annotations

from collections.abc import Mapping
from copy import copy
from dataclasses import replace
from functools import cached_property

from interlock.logic.controller import Controller, Equation, MalformedController
from interlock.logic.expr import Expr, variables
from interlock.logic.names import Name
from interlock.model.layout import Layout
from interlock.proof.system.clocks import assumed, ties
from interlock.proof.system.history import history
from interlock.proof.system.loop import ClosedLoop, closed_loop
from interlock.proof.system.neighbourhood import Neighbourhood
from interlock.proof.system.relation import TransitionRelation, primed
from interlock.proof.system.restart import InitialCondition, initial_condition
from interlock.proof.system.zones import Zones


class System:
    """A controller and its plant, composed.

    The controller's outputs are state too: what the last scan has put on the terminals stays there until the next one,
    and the plant sees nothing else.
    """

    def __init__(self, layout: Layout, controller: Controller, dropped: frozenset[str] = frozenset()) -> None:
        """`layout`: with its lengths; `dropped`: assumptions that are not made."""
        self.loop = closed_loop(layout, controller, dropped)
        self.ties = ties(self.loop)
        plant, timers = self.loop.plant, {t.name: t for t in controller.timers}
        following = {e.name: e.expr for e in controller.next} | plant.next | history(self.loop, self.ties)
        shown = {x.name: x.expr for x in controller.outputs}
        state = (*following, *shown)
        after = primed(state)
        self.zones = Zones(self.loop, after)
        definitions: dict[Name, Expr] = {e.name: e.expr for e in controller.equations}
        definitions |= plant.events.definitions
        definitions |= {n.next: x for n, x in following.items()}
        definitions |= {n.next: after(x) for n, x in shown.items()}
        definitions |= self.zones.definitions
        self.relation = TransitionRelation(
            state,
            (*(i.name for i in controller.inputs), *timers, *plant.choices),
            {i.name: i.size for i in controller.inputs if i.size},
            timers,
            definitions,
            (*plant.assumptions, *(x for x in assumed(timers.values(), self.ties) if x.id not in dropped)),
            after,
        )
        self.where = Neighbourhood(self.loop, self.relation)
        _check_closed(self.loop, self.relation)

    @cached_property
    def initial(self) -> InitialCondition:
        """The initial states."""
        return initial_condition(self.loop, self.ties, self.relation)

    def changed(self, controller: Controller) -> dict[Name, Expr] | None:
        """The definitions that are others under a controller that differs from this one in right sides of equations and
        outputs alone; None where it differs in anything else."""
        mine = self.loop.controller
        if controller.state is not mine.state or len(controller.steps) != len(mine.steps):
            return None
        found: dict[Name, Expr] = {}
        for old, new in zip(mine.steps, controller.steps, strict=True):
            if new is not old:
                if not isinstance(old, Equation) or not isinstance(new, Equation) or old.name != new.name:
                    return None
                found[new.name] = new.expr
        found |= {e.name.next: e.expr for old, e in zip(mine.next, controller.next, strict=True) if e is not old}
        for shown, x in zip(mine.outputs, controller.outputs, strict=True):
            if (shown.name, shown.restrictive) != (x.name, x.restrictive):
                return None
            if x.expr is not shown.expr:
                found[x.name.next] = self.relation.after(x.expr)
        return found

    def under(self, controller: Controller, changed: Mapping[Name, Expr]) -> System:
        """The system of such a controller: nothing but `changed` depends on right sides."""
        outputs = {x.name for x in controller.outputs}
        as_before = not any(n.base in outputs for n in changed) and self.initial.kept.unchanged(changed)
        other = copy(self)
        other.loop = replace(self.loop, controller=controller)
        other.relation = self.relation.under(changed)
        other.where = Neighbourhood(other.loop, other.relation)
        if not as_before:
            other.initial = initial_condition(other.loop, other.ties, other.relation)
        return other


def _check_closed(loop: ClosedLoop, relation: TransitionRelation) -> None:
    """Nothing may read a variable that nobody defines: it would be a free choice by accident."""
    known = {*relation.state, *relation.inputs, *relation.definitions}
    if len(known) < len(relation.state) + len(relation.inputs) + len(relation.definitions):
        raise MalformedController("a name stands for two things in the system")
    said = (*(h.expr for h in loop.plant.hazards), *loop.plant.initial, *(a.expr for a in relation.assumptions))
    unknown = sorted(set().union(variables(said), *relation.reads.values()) - known)
    if unknown:
        raise MalformedController(f"undefined variables in the system: {', '.join(unknown[:5])}")
