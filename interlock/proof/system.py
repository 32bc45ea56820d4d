"""Controller and plant as one transition system.

`after` turns an expression about a state into one about the state one step later, in terms of the old state and
the free inputs of the step.
"""

from __future__ import annotations

from functools import cached_property

from interlock.logic.controller import Controller, MalformedController
from interlock.logic.expr import FALSE, TRUE, Expr, Substitution, conj, disj, implies, neg, var, variables
from interlock.logic.plant import Assumption, Plant, Wiring, build_plant
from interlock.model.layout import Layout
from interlock.model.traversal import topology


def wiring(controller: Controller, layout: Layout) -> Wiring:
    """How the plant sees a controller."""
    s = controller.symbols
    return Wiring(
        proceed={g.id: s.signal(g.id) for g in layout.signals},
        call={g.id: s.signal(g.id, shunt=True) for g in layout.signals},
        command={k: var(v) for k, v in s.command.items()},
        valid=s.valid,
        clear=s.clear,
        detected=s.detected,
        approach_timer=s.approach_timer,
        overlap_timer=s.overlap_timer,
    )


class System:
    """State, inputs, initial condition, next states and assumptions of controller and plant together."""

    def __init__(self, layout: Layout, controller: Controller, dropped: frozenset[str] = frozenset()) -> None:
        self.layout = layout
        self.controller = controller
        self.topo = topology(layout)
        self.symbols = controller.symbols
        self.plant: Plant = build_plant(layout, wiring(controller, layout), dropped)
        self.next: dict[str, Expr] = {**controller.next_state, **self.plant.next}
        self.state: tuple[str, ...] = tuple(self.next)
        self.assumptions: list[Assumption] = list(self.plant.assumptions)
        for t in controller.timers:
            # an on-delay with a positive preset is true only while its input is true
            self.assumptions.append(
                Assumption(
                    "A-TON",
                    "An on-delay timer is true only while its input is true.",
                    implies(var(t.name), controller.expanded[t.input]),
                )
            )
        self._ghosts()
        self._check_closed()

    def _check_closed(self) -> None:
        """Nothing may read a variable that nobody defines: it would be a free choice by accident."""
        known = {*self.next, *self.inputs}
        parts = [
            *self.next.values(),
            *(h.expr for h in self.plant.hazards),
            *self.plant.initial,
            *(a.expr for a in self.assumptions),
        ]
        unknown = sorted(set(variables(parts)) - known)
        if unknown:
            raise MalformedController(f"undefined variables in the system: {', '.join(unknown[:5])}")

    @cached_property
    def initial(self) -> Expr:
        """The initial states: the controller's start-up, trains and points anyhow."""
        start = [var(s.name) if s.initial else neg(var(s.name)) for s in self.controller.state]
        ghosts = [neg(var(f"been.{s}")) for s in self.topo.sections]
        return conj([*start, *ghosts, *self.plant.initial])

    @cached_property
    def _step(self) -> Substitution:
        return Substitution(self.next)

    def after(self, x: Expr) -> Expr:
        """The expression one step later."""
        return self._step(x)

    def _ghosts(self) -> None:
        """History variables of the proof: been.s, a train has come into s since it was locked firmly.

        They are computed from the run and influence nothing.
        """
        for s in self.topo.sections:
            came_in = disj(self.plant.events.get(f"head.{j}.{self._beyond(s, j)}", FALSE) for j in self.topo.ends[s])
            self.next[f"been.{s}"] = conj((disj((var(f"been.{s}"), came_in)), self.next[self.symbols.firm[s]]))
        self.state = tuple(self.next)

    def _beyond(self, s: str, j: str) -> str:
        from interlock.model.elements import NodeId, SectionId

        ahead = self.topo.beyond(SectionId(s), NodeId(j))
        if ahead is not None:
            return ahead
        b = self.layout.boundary_at.get(NodeId(j))
        return (b.approach if b and b.approach else None) or f"outside.{j}"

    def output(self, name: str) -> Expr:
        """An output of the controller, by name."""
        return next(o.expr for o in self.controller.outputs if o.name == name)

    @cached_property
    def inputs(self) -> tuple[str, ...]:
        """Free variables of a step."""
        names = [i.name for i in self.controller.inputs] + [t.name for t in self.controller.timers]
        return (*names, *self.plant.choices)

    @cached_property
    def sizes(self) -> dict[str, int]:
        """Small-range inputs."""
        return {i.name: i.size for i in self.controller.inputs if i.size}


__all__ = ["FALSE", "TRUE", "System", "wiring"]
