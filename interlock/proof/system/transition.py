"""Controller and plant as one transition system.

`after` turns an expression about a state into one about the state one step later, in terms of the old state and
the free inputs of the step.

**Theorem.**  In every step an expression over the state, with the name of its next value for each variable, has the
value that the expression has in the state after the step, and a definition is true of every step: so a formula that
follows from definitions and assumptions holds in every step of every run.  (Substitution lemma; transition systems:
Manna and Pnueli, *Temporal Verification of Reactive Systems*, 1995.)
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property

from interlock.logic import names
from interlock.logic.controller import Controller, Equation, MalformedController
from interlock.logic.expr import FALSE, TRUE, Expr, Substitution, conj, disj, iff, implies, neg, var, variables
from interlock.logic.names import Kind, Name, Owner
from interlock.logic.plant import OF_TIMERS, Assumption, Plant, TokenWires, Wiring, across, build_plant, o
from interlock.model.elements import NodeId, SectionId, Zone
from interlock.model.layout import Layout
from interlock.model.measured import measured
from interlock.model.traversal import topology, zone_joints
from interlock.proof.system.clocks import arithmetic, history, ties
from interlock.proof.system.neighbourhood import homes, places, routes_of
from interlock.proof.system.restart import Kept, kept_values


def wiring(controller: Controller, layout: Layout) -> Wiring:
    """How the plant sees a controller."""
    s = controller.symbols
    return Wiring(
        proceed={g.id: s.aspects.signal(g.id) for g in layout.signalling.signals},
        call={g.id: s.aspects.signal(g.id, shunt=True) for g in layout.signalling.signals},
        command={k: var(v) for k, v in s.machines.drive.items()},
        valid=s.valid,
        clear=s.sections.clear,
        healthy=s.sections.healthy,
        detected=s.machines.detected,
        stop={g: var(name) for g, name in s.aspects.stop.items()},
        speed={k: var(name) for k, name in s.aspects.speed.items()},
        token={
            b: TokenWires(x.gives, x.keeps, x.has, x.clear, x.tells["has"], x.tells["gives"], x.manual)
            for b, x in s.token.items()
        },
    )


_REMEMBERED = (names.SEEN, names.SHUNT_SEEN, names.OLD_COMMAND)  # what the plant remembers of outputs


class System:
    """State, inputs, initial condition, definitions and assumptions of controller and plant together.

    A step is told by definitions: the controller's wires, the plant's events, and for each state variable `v` its
    next value `v'`.  An expression about a step speaks of all of these names.  The controller's outputs are state too:
    what the last scan has put on the terminals stays there until the next one, and the plant sees nothing else.
    """

    def __init__(self, layout: Layout, controller: Controller, dropped: frozenset[str] = frozenset()) -> None:
        """`layout`: with its lengths, of which nothing but `measured` is kept."""
        self.measured = measured(layout)
        self.layout = layout = layout.bare
        self.controller = controller
        self.topo = topology(layout)
        self.symbols = controller.symbols
        self.plant: Plant = build_plant(layout, self.measured, wiring(controller, layout), dropped)
        self.ties = ties(controller, self.plant, self.measured.needs)
        following = {e.name: e.expr for e in controller.next} | self.plant.next | self._ghosts()
        following |= history(self.ties, self.plant.clocks)
        shown = {x.name: x.expr for x in controller.outputs}
        self.state: tuple[Name, ...] = (*following, *shown)
        self.later = {n: n.next for n in self.state}
        self._after = Substitution({n: var(x) for n, x in self.later.items()})
        self.definitions: dict[Name, Expr] = {e.name: e.expr for e in controller.equations}
        self.definitions |= self.plant.events.definitions
        self.definitions |= {n.next: x for n, x in following.items()}
        self.definitions |= {n.next: self._after(x) for n, x in shown.items()}
        for z in layout.declared.zones:
            self.definitions |= self._zone(z)
        too_full = {z.id: names.OVERFULL(z.id) for z in layout.declared.zones}
        self.overfull: Mapping[str, Expr] = {z: var(name) for z, name in too_full.items() if name in self.definitions}
        self.assumptions: list[Assumption] = list(self.plant.assumptions)
        for t in controller.timers:
            # an on-delay with a positive preset is true only while its input is true
            self.assumptions.append(Assumption("A-TON", OF_TIMERS["A-TON"], implies(var(t.name), var(t.input))))
        self.assumptions += arithmetic(self.ties)
        self._check_closed()

    def changed(self, controller: Controller) -> dict[Name, Expr] | None:
        """The definitions that are others under a controller that differs from this one in right sides of equations and
        outputs alone; None where it differs in anything else."""
        mine = self.controller
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
                found[x.name.next] = self._after(x.expr)
        return found

    def under(self, controller: Controller, changed: Mapping[Name, Expr]) -> System:
        """The system of such a controller: nothing but `changed` depends on right sides."""
        other = System.__new__(System)
        kept = {k: v for k, v in self.__dict__.items() if not isinstance(getattr(System, k, None), cached_property)}
        other.__dict__.update(
            kept, controller=controller, definitions={**self.definitions, **changed}, _start=self._start
        )
        outputs = any(name.base in self._shown for name in changed)
        if not outputs and self._kept.unchanged(changed):
            other.__dict__.update(_kept=self._kept, initial_parts=self.initial_parts)
        return other

    @cached_property
    def _shown(self) -> frozenset[Name]:
        """The names of outputs."""
        return frozenset(x.name for x in self.controller.outputs)

    def _check_closed(self) -> None:
        """Nothing may read a variable that nobody defines: it would be a free choice by accident."""
        known = {*self.state, *self.inputs, *self.definitions}
        if len(known) < len(self.state) + len(self.inputs) + len(self.definitions):
            raise MalformedController("a name stands for two things in the system")
        parts = [
            *self.definitions.values(),
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
        return conj(self.initial_parts)

    @cached_property
    def initial_parts(self) -> list[Expr]:
        """The same, one condition after the other: what the restart delay keeps of the start, trains at a stand."""
        start, kept = self._start, self._kept.names
        known = [var(n) if start[n] is TRUE else neg(var(n)) for n in start if n in kept]
        shown = [iff(var(x.name), x.expr) for x in self.controller.outputs if x.name not in kept]
        return [*known, *shown, *self.plant.initial]

    @cached_property
    def _start(self) -> dict[Name, Expr]:
        """What the controller, its outputs and what is remembered of them are at power-up."""
        start = {x.name: TRUE if x.initial else FALSE for x in self.controller.state}
        start |= {x.name: TRUE if x.restrictive else FALSE for x in self.controller.outputs}
        start |= dict.fromkeys((names.BEEN(s) for s in self.topo.sections), FALSE)
        start |= dict.fromkeys((names.SHUT(r.number) for r in self.symbols.routes), FALSE)
        start |= dict.fromkeys((t.covered for t in self.ties), TRUE)
        start |= dict.fromkeys((n for n in self.plant.state if n.family in _REMEMBERED), FALSE)
        return start

    @cached_property
    def _kept(self) -> Kept:
        """What of that every scan keeps until the restart delay is over."""
        following = {self.later[n]: self.definitions[self.later[n]] for n in self.later if n in self._start}
        return kept_values(self.controller, self._start, following, self.later)

    def after(self, x: Expr) -> Expr:
        """The expression one step later."""
        return self._after(x)

    def _ghosts(self) -> dict[Name, Expr]:
        """History variables of the proof.  They are computed from the run and influence nothing.

        been.s: a train has come into s since it was locked firmly.  shut.Rn: the signal has closed while route n stayed
        set, and nobody has asked for it again.
        """
        out = {}
        for r in self.symbols.routes:
            closes = conj((var(r.proceed), neg(var(r.proceed.next))))
            asked = self.symbols.requests.asked_for(r, self.symbols.routes)
            out[names.SHUT(r.number)] = conj(
                (disj((var(names.SHUT(r.number)), closes)), var(r.active.next), neg(asked))
            )
        for s in self.topo.sections:
            came_in = disj(self.plant.events.get(names.HEAD(j, self._beyond(s, j)), FALSE) for j in self.topo.ends[s])
            out[names.BEEN(s)] = conj((disj((var(names.BEEN(s)), came_in)), var(self.symbols.sections.firm[s].next)))
        return out

    def called_in(self, s: SectionId, j: NodeId) -> Expr:
        """A section is locked for a train that comes in at j and has not come yet."""
        ways = self.symbols.sections.locks_of.get(s, [])
        locked = disj(var(name) for n, name in ways if self.topo.traversals[s][n - 1].entry == j)
        return conj((locked, neg(var(names.BEEN(s)))))

    def _zone(self, z: Zone) -> dict[Name, Expr]:
        """`zone.ID`: a train is called into a zone in this step, and with those that are in it or called into it there
        are more than its maximum.

        A train counts in the rearmost of its sections in the zone.
        """
        joints = zone_joints(self.topo, z)
        items: list[Expr] = []
        for s in z.sections:
            inner = [(j, r) for j in self.topo.ends[s] if (r := self.topo.beyond(s, j)) in z.sections]
            rearmost = conj((o(s), *(neg(across(j, str(r))) for j, r in inner)))
            items.append(disj((rearmost, *(self.called_in(s, j) for t, j in joints if t == s))))
        called = [conj((self._after(self.called_in(s, j)), neg(self.called_in(s, j)))) for s, j in joints]
        items += called
        out: dict[Name, Expr] = {}
        before: list[Expr] = []
        for i, x in enumerate(items, 1):
            now: list[Expr] = []
            for k in range(1, min(i, z.trains + 1) + 1):
                more = x if k == 1 else conj((before[k - 2], x))
                name = names.ZONE_SUM(z.id, i, k)
                out[name] = disj((more, before[k - 1])) if k <= len(before) else more
                now.append(FALSE if out[name] is FALSE else var(name))
            before = now
        out[names.OVERFULL(z.id)] = conj((before[z.trains], disj(called))) if len(before) > z.trains else FALSE
        return {name: x for name, x in out.items() if x is not FALSE}

    def _beyond(self, s: SectionId, j: NodeId) -> str:
        ahead = self.topo.beyond(s, j)
        if ahead is not None:
            return ahead
        b = self.layout.track.boundary_at.get(j)
        return (b.approach if b and b.approach else None) or names.outside(j)

    @cached_property
    def _known(self) -> dict[Name, None]:
        """All names but those of inputs."""
        return dict.fromkeys((*self.state, *self.definitions))

    @cached_property
    def places(self) -> Mapping[Name, tuple[int, ...]]:
        """Variables by the numbers of the sections to which they belong."""
        return places(self.topo, self.symbols, self._known)

    @cached_property
    def indexed(self) -> Mapping[Name, tuple[Name, int]]:
        """The variables of routes: what they mean, and the route's number."""
        return routes_of(self._known)

    @property
    def requests(self) -> tuple[Name, ...]:
        """The inputs that have the numbers of routes for values."""
        return tuple(x for x in (self.symbols.requests.request, self.symbols.requests.local_request) if x is not None)

    @cached_property
    def homes(self) -> Mapping[Name, Owner]:
        """The elements to which other variables belong."""
        known = dict.fromkeys((*self._known, *self.inputs))
        return homes(self.topo, self.controller, known, self.definitions, self.inputs)

    @cached_property
    def beside(self) -> Mapping[Owner, tuple[Owner, ...]]:
        """The sections of each machine, beyond each signal and first in each overlap."""
        found: dict[tuple[Kind, str], tuple[SectionId, ...]] = {}
        found |= {(Kind.MACHINE, m): self.layout.machines.sections[m] for m in self.layout.machines}
        found |= {(Kind.SIGNAL, g.id): (self.layout.track.section_of(g.into),) for g in self.layout.signalling.signals}
        found |= {(Kind.OVERLAP, g): (ways[0][0],) for (g, _), ways in self.symbols.overlaps.ways.items()}
        return {Owner.of(*x): tuple(Owner.of(Kind.SECTION, s) for s in those) for x, those in found.items()}

    @cached_property
    def lamps(self) -> frozenset[Name]:
        """What signals show."""
        return frozenset(self.symbols.aspects.lamps)

    @property
    def waits_for(self) -> Mapping[Name, Name]:
        """What each timer waits for: the name of its input."""
        return {t.name: t.input for t in self.controller.timers}

    @property
    def presets(self) -> Mapping[Name, int]:
        """The preset of every timer, in milliseconds."""
        return {t.name: t.preset_ms for t in self.controller.timers}

    @cached_property
    def inputs(self) -> tuple[Name, ...]:
        """Free variables of a step."""
        names = [i.name for i in self.controller.inputs] + [t.name for t in self.controller.timers]
        return (*names, *self.plant.choices)

    @cached_property
    def sizes(self) -> dict[Name, int]:
        """Small-range inputs."""
        return {i.name: i.size for i in self.controller.inputs if i.size}


__all__ = ["FALSE", "TRUE", "System", "wiring"]
