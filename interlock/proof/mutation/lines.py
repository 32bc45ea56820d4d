"""What is said of a system, line by line, and which lines a mutant changes."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

from interlock.logic.controller import Controller, Equation
from interlock.logic.expr import Expr
from interlock.proof.invariants import Facts, claims, strengthening
from interlock.proof.runner import start_claim
from interlock.proof.system import System


@dataclass(frozen=True, slots=True)
class Lines:
    """What is said of a system."""

    definitions: Mapping[str, Expr]
    assumptions: tuple[Expr, ...]
    invariants: tuple[tuple[str, Expr], ...]
    claims: tuple[tuple[str, Expr], ...]
    start: tuple[Expr, ...]
    at_start: Expr

    @staticmethod
    def of(system: System) -> Lines:
        """The lines of a system."""
        facts = Facts(system)
        return Lines(
            system.definitions,
            tuple(dict.fromkeys(a.expr for a in system.assumptions)),
            tuple((f"{i.id} at {i.place}", i.expr) for i in strengthening(facts)),
            tuple((f"{c.id} at {c.place}", c.expr) for c in claims(facts)),
            tuple(dict.fromkeys(system.initial_parts)),
            start_claim(system),
        )

    def under(self, system: System) -> Lines:
        """The lines of a system that differs in equations only (`System.with_equations`): what is assumed and claimed
        speaks of names, so that only definitions and the values that a restart keeps can be others."""
        return replace(self, definitions=system.definitions, start=tuple(dict.fromkeys(system.initial_parts)))


def changed_equations(c: Controller, mutant: Controller) -> dict[str, Expr] | None:
    """The right sides that are others in a mutant, by name (`x` a wire, `x'` a next value); None where more than right
    sides has changed."""
    if mutant.state != c.state or mutant.outputs != c.outputs or len(mutant.steps) != len(c.steps):
        return None
    found: dict[str, Expr] = {}
    for old, new in zip(c.steps, mutant.steps, strict=True):
        if new is not old:
            if not isinstance(old, Equation) or not isinstance(new, Equation):
                return None
            found[new.name] = new.expr
    found |= {e.name + "'": e.expr for old, e in zip(c.next, mutant.next, strict=True) if e is not old}
    return found
