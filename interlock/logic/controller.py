"""The controller as typed data: what the PLC computes in one scan.

One scan: (1) read the inputs; (2) compute the steps, wires and timers, in order, from inputs, old state and
earlier steps; (3) compute the next value of every state variable from the same; (4) commit all next values
at once; (5) compute the outputs from the new state.  Nothing else is remembered from scan to scan.

Built by `logic.lower`, verified here: every name defined once, no use before definition (so no combinational
cycle), every output restrictive in the initial state.
"""

from __future__ import annotations

from dataclasses import field, replace
from enum import StrEnum
from functools import cached_property
from typing import NamedTuple

from interlock.dataclass import dataclass
from interlock.logic.expr import (
    Expr,
    Substitution,
    UniqueTable,
    conj,
    current_table,
    disj,
    evaluate,
    variables,
)
from interlock.logic.names import Name, computed
from interlock.logic.symbols import Symbols
from interlock.logic.words import Words


class MalformedController(Exception):
    """The controller breaks its own rules; always a defect of the lowering."""


class Join(StrEnum):
    """How the terms of an equation are joined."""

    ALL = "all"
    ANY = "any"


class Term(NamedTuple):
    """One operand with its reason; `kind` names the sort of condition, for comments and mutants; `rule`: that of the
    table's cell from which the condition is."""

    expr: Expr
    kind: str
    note: str = ""
    rule: str = ""


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

    def named(self, name: Name, note: str = "") -> Equation:
        """The same under another name, with another meaning; what it reads is not sought again."""
        other = Equation(name, self.join, self.terms, self.group, note)
        vars(other)["reads"] = self.reads
        return other


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
            reads = step.reads if isinstance(step, Equation) else (step.input,)
            if not defined.issuperset(reads):
                name = next(n for n in reads if n not in defined)
                raise MalformedController(f"{step.name} reads {name} before it is computed")
            if step.name in defined:
                raise MalformedController(f"{step.name} is defined twice")
            defined.add(step.name)
        kept = {s.name for s in self.state}
        if [e.name for e in self.next] != [s.name for s in self.state]:
            raise MalformedController("next-state equations and state variables differ")
        for e in self.next:
            if not defined.issuperset(e.reads):
                name = next(n for n in e.reads if n not in defined)
                raise MalformedController(f"the next value of {e.name} reads {name}, which is not defined")
        initial = {s.name: int(s.initial) for s in self.state}
        for o in self.outputs:
            if not set(variables((o.expr,))) <= kept:
                raise MalformedController(f"output {o.name} reads more than the new state")
            if evaluate(o.expr, initial.__getitem__, {}) != o.restrictive:
                raise MalformedController(f"output {o.name} is not restrictive in the initial state")
        self._check_words(defined | {computed(name) for name in kept})

    def _check_words(self, readable: set[str]) -> None:
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
