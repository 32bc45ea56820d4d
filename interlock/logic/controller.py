"""The controller as typed data: what the PLC computes in one scan.

One scan: (1) read the inputs; (2) compute the steps, wires and timers, in order, from inputs, old state and
earlier steps; (3) compute the next value of every state variable from the same; (4) commit all next values
at once; (5) compute the outputs from the new state.  Nothing else is remembered from scan to scan.

Built by `logic.lower`, verified here: every name defined once, no use before definition (so no combinational
cycle), every output restrictive in the initial state.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from enum import StrEnum
from functools import cached_property

from interlock.logic.expr import (
    FALSE,
    Expr,
    Substitution,
    UniqueTable,
    conj,
    current_table,
    disj,
    eq,
    evaluate,
    neg,
    var,
    variables,
)
from interlock.logic.names import Name, computed
from interlock.logic.words import Words
from interlock.model.elements import (
    ConditionId,
    MachineId,
    NodeId,
    Position,
    RouteId,
    SectionId,
    SignalId,
)


class MalformedController(Exception):
    """The controller breaks its own rules; always a defect of the lowering."""


class Join(StrEnum):
    """How the terms of an equation are joined."""

    ALL = "all"
    ANY = "any"


@dataclass(frozen=True, slots=True)
class Term:
    """One operand with its reason; `kind` names the sort of condition, for comments and mutants."""

    expr: Expr
    kind: str
    note: str = ""


@dataclass(frozen=True)
class Equation:
    """`name := AND/OR of terms`, as it is printed.  `group` is the block in which it is computed."""

    name: Name
    join: Join
    terms: tuple[Term, ...]
    group: str
    note: str = ""

    @cached_property
    def expr(self) -> Expr:
        """The equation's right side."""
        join = conj if self.join is Join.ALL else disj
        return join(t.expr for t in self.terms)

    @cached_property
    def reads(self) -> tuple[Name, ...]:
        """The names in its terms, in order of appearance."""
        return tuple(variables(t.expr for t in self.terms))


LONGEST_MS = 2**31 - 1
"""The longest preset that every controller can count: a TIME of 32 bits, as in Step 7; a longer one begins anew."""


@dataclass(frozen=True, slots=True)
class Timer:
    """On-delay: `name` becomes true when `input` has been true for `preset_ms` without a break."""

    name: Name
    input: Name
    preset_ms: int
    note: str = ""


Step = Equation | Timer


@dataclass(frozen=True, slots=True)
class Input:
    """A process or operator input; `size` 0 is Boolean, otherwise a number from 0 to size-1.

    `restrictive` is the value that permits least; a missing input takes it.  The largest number stands for every number
    that names nothing: the text, which compares a number with those that it knows, cannot tell them apart.
    """

    name: Name
    note: str
    size: int = 0
    restrictive: int = 0

    def read(self, given: int) -> int:
        """What the controller takes a value for."""
        if 0 <= given < max(self.size, 2):
            return given
        return self.size - 1 if self.size else self.restrictive


@dataclass(frozen=True, slots=True)
class StateVar:
    """A bit that is kept from scan to scan."""

    name: Name
    initial: bool
    note: str


@dataclass(frozen=True, slots=True)
class Output:
    """A process output or indication, computed from the new state; `restrictive` is its safe value."""

    name: Name
    expr: Expr
    restrictive: bool
    note: str


@dataclass(frozen=True)
class BlockSymbols:
    """Names of a line's direction token: the neighbour asks, gives, gives not, has; the line is clear; the manual
    change; the token is here, is given, its last change is complete; the delay of the manual change; the outputs that
    tell the neighbour (`asks`, `gives`, `keeps`, `has`)."""

    asks: Name
    gives: Name
    keeps: Name
    has: Name
    clear: Name
    manual: Name
    have: Name
    give: Name
    seen: Name
    timer: Name
    tells: Mapping[str, Name] = field(default_factory=dict, kw_only=True)


@dataclass(frozen=True)
class RouteSymbols:
    """Names of the variables of one route, and what it locks."""

    id: RouteId
    number: int
    entry: SignalId
    shunt: bool
    call_on: bool
    ways: tuple[tuple[SectionId, int], ...]
    berth: tuple[SectionId, int] | None
    overlap: tuple[SignalId, int] | None
    active: Name
    locked: Name
    want: Name
    proceed: Name
    shown: Name
    passing: Name | None = None
    names: tuple[str, ...] = ()
    """Names that the author gives to it, beside its id."""
    identifier: bool = False
    """Its signal shows its identifier light, for a train that passes it under a route that leads past it."""
    onward: int | None = None
    """The number of the route, of kind identifier, that is set with it past the signal at its end."""
    parts_of: tuple[int, ...] = ()
    """The numbers of the routes that lead past its signal: it is set with one of them, never alone."""
    added: Name | None = None
    """The variable that tells that it holds what the author has added to it: hostile routes and points."""
    barred: tuple[int, ...] = ()
    """Numbers of the routes that the author declares hostile."""
    demands: tuple[tuple[MachineId, Position], ...] = ()
    """Machines that the author has it lock."""

    @property
    def open_while(self) -> tuple[Name, ...]:
        """The variables while which the signal is open for this route."""
        return (self.proceed,) if self.passing is None else (self.proceed, self.passing)


def asked_of(inputs: tuple[Name, ...], number: int, fresh: Mapping[Name, Name]) -> Expr:
    """A number is newly asked for at one of some inputs, of which the first that asks is heard; 0: at none of them.

    `fresh`: by input, the bit that tells that it read 0 in the last scan.  An input that holds its value asks once.
    """
    quiet = [disj((eq(x, 0), neg(var(fresh[x])))) for x in inputs]
    if not number:
        return conj(quiet)
    return disj(conj((*quiet[:i], var(fresh[x]), eq(x, number))) for i, x in enumerate(inputs))


@dataclass(frozen=True)
class Symbols:
    """What the variables of a controller mean; claims speak through these names alone."""

    valid: Name
    request: Name
    local_request: Name | None
    local_first: bool
    fresh: Mapping[Name, Name]
    seen: Mapping[Name, Name]
    automatic: Mapping[int, Name]
    clear: Mapping[SectionId, Name]
    healthy: Mapping[SectionId, Name]
    blocked: Mapping[SectionId, Name]
    detected: Mapping[tuple[MachineId, Position], Name]
    command: Mapping[tuple[MachineId, Position], Name]
    by_hand: Mapping[tuple[MachineId, Position], Name]
    trailed: Mapping[MachineId, Name]
    seen_right: Mapping[MachineId, Name]
    looked_at: Mapping[MachineId, Name]
    condition: Mapping[ConditionId, Name]
    stop_lamp: Mapping[SignalId, Name]
    clear_lamp: Mapping[SignalId, Name]
    identifier_lamp: Mapping[SignalId, Name]
    caution_lamp: Mapping[SignalId, Name]
    drive: Mapping[tuple[MachineId, Position], Name]
    turn: Mapping[MachineId, Name]
    started: Name | None
    late_timer: Mapping[MachineId, Name]
    release_timer: Mapping[SectionId, Name]
    running: Name
    restart_timer: Name
    start_timer: Name | None
    clear_aspect: Mapping[SignalId, Name]
    caution_aspect: Mapping[SignalId, Name]
    call_aspect: Mapping[SignalId, Name]
    identifier_aspect: Mapping[SignalId, Name]
    shunt_aspect: Mapping[SignalId, Name]
    stop_aspect: Mapping[SignalId, Name]
    distant_clear: Mapping[SignalId, Name]
    distant_caution: Mapping[SignalId, Name]
    speed_shown: Mapping[tuple[SignalId, int], Name]
    indication: Mapping[str, Name]
    zone_full: Mapping[str, Name]
    restart: Mapping[SectionId, Name]
    train: Mapping[SectionId, Name]
    lock: Mapping[tuple[SectionId, int], Name]
    firm: Mapping[SectionId, Name]
    used: Mapping[SectionId, Name]
    passed: Mapping[SectionId, Name]
    stale: Mapping[SectionId, Name]
    release: Mapping[SectionId, Name]
    release_all: Name
    cancel: Mapping[SignalId, Name]
    cancelling: Mapping[SignalId, Name]
    approach_timer: Mapping[SignalId, Name]
    approach_of: Mapping[SignalId, SectionId | None]
    overlap: Mapping[tuple[SignalId, int], Name]
    overlap_ways: Mapping[tuple[SignalId, int], tuple[tuple[SectionId, int], ...]]
    overlap_firm: Mapping[SignalId, Name]
    overlap_timer: Mapping[SignalId, Name]
    swings: Mapping[SignalId, Name]
    swing_request: Mapping[SignalId, int]
    token: Mapping[NodeId, BlockSymbols]
    routes: tuple[RouteSymbols, ...]
    demands: Mapping[tuple[SectionId, int], tuple[tuple[MachineId, Position], ...]]
    excluded: Mapping[tuple[SectionId, int], tuple[tuple[SectionId, bool, tuple[int, ...]], ...]]
    ends: Mapping[SectionId, tuple[NodeId, ...]]

    @cached_property
    def routes_over(self) -> dict[tuple[SectionId, int], list[RouteSymbols]]:
        """The routes that lock each way, or end in it as a berth."""
        out: dict[tuple[SectionId, int], list[RouteSymbols]] = {}
        for r in self.routes:
            for way in dict.fromkeys((*r.ways, *([r.berth] if r.berth is not None else []))):
                out.setdefault(way, []).append(r)
        return out

    @cached_property
    def locks_of(self) -> dict[SectionId, list[tuple[int, Name]]]:
        """The locks of each section: number and name."""
        out: dict[SectionId, list[tuple[int, Name]]] = {}
        for (s, n), name in self.lock.items():
            out.setdefault(s, []).append((n, name))
        return out

    @cached_property
    def locked_by(self) -> dict[SectionId, tuple[Name, ...]]:
        """The variables that lock each section: restart lock and locks."""
        return {s: (k, *(name for _, name in self.locks_of.get(s, ()))) for s, k in self.restart.items()}

    def proceed_lamps(self, g: SignalId, shunt: bool = False) -> tuple[Name, ...]:
        """The outputs at which a movement may pass a signal: a train (called on, or past an identifier light, too), or
        a shunting movement."""
        trains = (self.clear_aspect, self.caution_aspect, self.call_aspect, self.identifier_aspect)
        aspects = (self.shunt_aspect,) if shunt else trains
        return tuple(aspect[g] for aspect in aspects if g in aspect)

    @property
    def lamps(self) -> Iterator[Name]:
        """The outputs that are lit at signals and distants, stop lamps among them."""
        for aspect in (self.clear_aspect, self.caution_aspect, self.call_aspect, self.shunt_aspect, self.stop_aspect):
            yield from aspect.values()
        yield from self.identifier_aspect.values()
        yield from (*self.distant_clear.values(), *self.distant_caution.values())

    def main_lamps(self, g: SignalId) -> tuple[Name, ...]:
        """The outputs that show clear or caution at a main signal."""
        return tuple(aspect[g] for aspect in (self.clear_aspect, self.caution_aspect) if g in aspect)

    def signal(self, g: SignalId, shunt: bool = False) -> Expr:
        """Whether a movement may pass a signal, by its lamps: a train (called on, or past an identifier light, too), or
        a shunting movement."""
        return disj(var(name) for name in self.proceed_lamps(g, shunt))

    def opened(self, g: SignalId, shunt: bool = False) -> Expr:
        """Whether the controller has opened a signal for one of its routes: state, not yet a lamp."""
        return self._opened.get((g, shunt), FALSE)

    @cached_property
    def _opened(self) -> dict[tuple[SignalId, bool], Expr]:
        open_: dict[tuple[SignalId, bool], list[Expr]] = {}
        for r in self.routes:
            open_.setdefault((r.entry, r.shunt), []).extend(var(name) for name in r.open_while)
        return {who: disj(xs) for who, xs in open_.items()}

    def passing(self, g: SignalId, shunt: bool = False) -> Expr:
        """Whether a signal is still open for a movement that has begun to pass it."""
        routes = self.routes_from.get(g, ())
        return disj(var(r.passing) for r in routes if r.shunt is shunt and r.passing is not None)

    def identifies(self, g: SignalId) -> Expr:
        """Whether a signal shows its identifier light."""
        return var(self.identifier_aspect[g]) if g in self.identifier_aspect else FALSE

    def asked_for(self, r: RouteSymbols) -> Expr:
        """A route is newly asked for by hand: what lies past a signal with a route that leads past it."""
        return disj(map(self.asked, r.parts_of)) if r.identifier else self.asked(r.number)

    def asked(self, number: int) -> Expr:
        """A route number (0: none) is newly asked for by hand, from the control centre or on the spot."""
        if self.local_request is None:
            return asked_of((self.request,), number, self.fresh)
        order = (self.request, self.local_request)
        return asked_of(order[::-1] if self.local_first else order, number, self.fresh)

    def opens(self, g: SignalId, shunt: bool = False) -> Expr:
        """Whether a signal is open for a movement before it, other than by calling a train on."""
        own = (r for r in self.routes_from.get(g, ()) if not r.call_on and not r.identifier)
        return disj(var(r.proceed) for r in own if r.shunt is shunt)

    def called(self, g: SignalId) -> Expr:
        """Whether a signal calls a train on."""
        return disj(var(r.proceed) for r in self.routes_from.get(g, ()) if r.call_on)

    @cached_property
    def whole(self) -> tuple[RouteSymbols, ...]:
        """Routes as trains run over them: one that leads past a signal with what it locks beyond it, which is no route
        by itself."""
        out = []
        for r in self.routes:
            if r.onward is not None:
                beyond = self.number[r.onward]
                demands = (*r.demands, *beyond.demands)
                out.append(replace(r, ways=(*r.ways, *beyond.ways), overlap=beyond.overlap, demands=demands))
            elif not r.identifier:
                out.append(r)
        return tuple(out)

    @cached_property
    def number(self) -> dict[int, RouteSymbols]:
        """Routes by number."""
        return {r.number: r for r in self.routes}

    @cached_property
    def routes_from(self) -> dict[SignalId, list[RouteSymbols]]:
        """The routes of each signal."""
        out: dict[SignalId, list[RouteSymbols]] = {}
        for r in self.routes:
            out.setdefault(r.entry, []).append(r)
        return out

    def shows(self, g: SignalId) -> Expr:
        """Whether the controller shows anything but stop at a signal."""
        return disj((self.signal(g), self.signal(g, shunt=True)))


@dataclass(frozen=True)
class Controller:
    """The whole controller.  See the module's docstring for the meaning of one scan."""

    name: str
    inputs: tuple[Input, ...]
    state: tuple[StateVar, ...]
    steps: tuple[Step, ...]
    next: tuple[Equation, ...]
    outputs: tuple[Output, ...]
    symbols: Symbols = field(repr=False)
    words: Words = field(default=Words(), repr=False)
    """What it says of routes as numbers, in every scan; nothing above reads one."""
    nodes: UniqueTable = field(default_factory=current_table, repr=False, compare=False)
    """The table with which its expressions are made, and others that are to be compared with them."""

    def __post_init__(self) -> None:
        defined: set[str] = set()
        for name in [*(i.name for i in self.inputs), *(s.name for s in self.state)]:
            if name in defined:
                raise MalformedController(f"{name} is defined twice")
            defined.add(name)
        for step in self.steps:
            for name in step.reads if isinstance(step, Equation) else (step.input,):
                if name not in defined:
                    raise MalformedController(f"{step.name} reads {name} before it is computed")
            if step.name in defined:
                raise MalformedController(f"{step.name} is defined twice")
            defined.add(step.name)
        kept = {s.name for s in self.state}
        if [e.name for e in self.next] != [s.name for s in self.state]:
            raise MalformedController("next-state equations and state variables differ")
        for e in self.next:
            for name in e.reads:
                if name not in defined:
                    raise MalformedController(f"the next value of {e.name} reads {name}, which is not defined")
        initial = {s.name: int(s.initial) for s in self.state}
        for o in self.outputs:
            if not set(variables((o.expr,))) <= kept:
                raise MalformedController(f"output {o.name} reads more than the new state")
            if evaluate(o.expr, initial.__getitem__, {}) != o.restrictive:
                raise MalformedController(f"output {o.name} is not restrictive in the initial state")
        self._look_at_words(defined | {computed(name) for name in kept})

    def _look_at_words(self, readable: set[str]) -> None:
        """Words read what a scan reads and computes, and words before them; nothing else can read a word."""
        told: set[str] = set()
        for w in self.words.words:
            if w.name in readable or w.name in told:
                raise MalformedController(f"the word {w.name} is defined twice")
            for name in variables(c.condition for c in w.cases):
                if name not in readable:
                    raise MalformedController(f"the word {w.name} reads {name}, which is not computed")
            for value in (*(c.value for c in w.cases), w.otherwise):
                if not isinstance(value, int) and value not in told:
                    raise MalformedController(f"the word {w.name} reads the word {value} before it is computed")
            told.add(w.name)

    def with_outputs(self, outputs: tuple[Output, ...]) -> Controller:
        """The same controller with other outputs, restrictive at the restart or not: for weakenings."""
        other = replace(self, outputs=())
        object.__setattr__(other, "outputs", outputs)
        return other

    @cached_property
    def timers(self) -> tuple[Timer, ...]:
        """The timers in order."""
        return tuple(s for s in self.steps if isinstance(s, Timer))

    @cached_property
    def equations(self) -> tuple[Equation, ...]:
        """The wires in order."""
        return tuple(s for s in self.steps if isinstance(s, Equation))

    @cached_property
    def expanded(self) -> dict[Name, Expr]:
        """Every wire as an expression over inputs, old state and timer outputs alone."""
        known: dict[Name, Expr] = {}
        put = Substitution(known)  # a wire is known before it is read
        for e in self.equations:
            known[e.name] = put(e.expr)
        return known

    @cached_property
    def next_state(self) -> dict[Name, Expr]:
        """Every next value as an expression over inputs, old state and timer outputs alone."""
        sub = Substitution(self.expanded)
        return {e.name: sub(e.expr) for e in self.next}
