"""What is said of a system, line by line, and which lines a mutant changes."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from interlock.dataclass import dataclass
from interlock.logic.expr import Expr
from interlock.logic.names import Name
from interlock.proof.claims import Facts, claims, strengthening
from interlock.proof.functions import function_start, functions
from interlock.proof.prover import start_claim
from interlock.proof.system.transition import System


@dataclass(frozen=True, slots=True)
class Lines:
    """What is said of a system."""

    definitions: Mapping[Name, Expr]
    assumptions: tuple[Expr, ...]
    invariants: tuple[tuple[str, Expr], ...]
    claims: tuple[tuple[str, Expr], ...]
    functions: tuple[tuple[str, Expr], ...]
    start: tuple[Expr, ...]
    at_start: tuple[tuple[str, Expr], ...]

    @staticmethod
    def of(system: System) -> Lines:
        """The lines of a system."""
        facts = Facts(system)
        return Lines(
            system.relation.definitions,
            tuple(dict.fromkeys(a.expr for a in system.relation.assumptions)),
            tuple((f"{i.id} at {i.place}", i.expr) for i in strengthening(facts)),
            tuple((f"{c.id} at {c.place}", c.expr) for c in claims(facts)),
            tuple((f"{name} at {place}", x) for name, place, x in functions(facts, system.loop.controller)),
            tuple(dict.fromkeys(system.initial.parts)),
            (("P-START", start_claim(system.loop)), ("F-START", function_start(facts))),
        )

    def under(self, system: System) -> Lines:
        """The lines of a system that differs in right sides only (`System.changed`): what is assumed and claimed speaks
        of names, so that only definitions and the values that a restart keeps can be others."""
        return replace(self, definitions=system.relation.definitions, start=tuple(dict.fromkeys(system.initial.parts)))
