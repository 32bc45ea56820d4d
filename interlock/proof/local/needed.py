"""What the proof rests on: for each claim, the terms of the controller and the assumptions that its proof used.

A claim needs the facts of its own obligations and, with every invariant among them, those of the invariant's step.
A term that no claim needs is not thereby superfluous: it may serve availability, or protect where a claim is silent.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from interlock.logic.controller import Controller, Equation, Join
from interlock.logic.expr import Expr, disj, neg, var
from interlock.proof.local.engine import LocalProof
from interlock.proof.local.facts import GoalKind, Kind, split


@dataclass(frozen=True)
class Need:
    """A term of an equation and the claims whose proof used it."""

    equation: str
    term: str
    claims: tuple[str, ...]


def claims_of_facts(proof: LocalProof) -> dict[int, set[str]]:
    """For every fact of the step, the claims that rest on it."""
    base = proof.base
    invariant_of: dict[int, int] = {}
    at = 0
    counts = [len(split(i.expr)) for i in base.invariants]
    first = next((n for n, f in enumerate(base.steps) if f.kind is Kind.INVARIANT), len(base.steps))
    for n, count in enumerate(counts):
        for _ in range(count):
            invariant_of[first + at] = n
            at += 1
    uses: dict[int, set[int]] = {n: set() for n in range(len(base.invariants))}
    wanted: dict[str, set[int]] = {}
    for o in proof.obligations:
        if o.goal.kind is GoalKind.STEP:
            uses[o.goal.index] |= set(o.facts)
        elif o.goal.kind is GoalKind.CLAIM:
            wanted.setdefault(o.goal.source, set()).update(o.facts)
    found: dict[int, set[str]] = {}
    for claim, facts in wanted.items():
        todo, done = list(facts), set[int]()
        while todo:
            f = todo.pop()
            if f in done:
                continue
            done.add(f)
            found.setdefault(f, set()).add(claim)
            if f in invariant_of:
                todo.extend(uses[invariant_of[f]] - done)
    return found


def needs(proof: LocalProof, controller: Controller) -> tuple[Need, ...]:
    """Every term of every equation, in order, with the claims that rest on it."""
    by_fact = claims_of_facts(proof)
    position: dict[tuple[str, int], list[int]] = {}
    for n, f in enumerate(proof.base.steps):
        if f.kind is Kind.DEFINITION:
            position.setdefault((f.source, id(f.clause)), []).append(n)
    out = []
    for e, name in _equations(controller):
        for t in e.terms:
            facts = [n for c in _part(name, e, t.expr) for n in position.get((name, id(c)), ())]
            claims = {c for n in facts for c in by_fact.get(n, ())}
            out.append(Need(e.name, t.note or t.kind, tuple(sorted(claims))))
    return tuple(out)


def _equations(c: Controller) -> Iterator[tuple[Equation, str]]:
    for e in c.equations:
        yield e, e.name
    for e in c.next:
        yield e, e.name + "'"


def _part(name: str, e: Equation, term: Expr) -> list[Expr]:
    """The clauses in which a term stands: an AND implies it; it implies an OR."""
    if e.join is Join.ALL:
        return split(disj((neg(var(name)), term)))
    return split(disj((var(name), neg(term))))


def needs_text(found: tuple[Need, ...]) -> str:
    """The sets of claims that occur, numbered; then one line for each term: equation, term, number of its set."""
    sets = sorted({n.claims for n in found}, key=lambda c: (len(c), c))
    number = {c: k for k, c in enumerate(sets)}
    none = sum(not n.claims for n in found)
    out = [f"# {len(found)} terms of the controller; {none} that no claim rests on (set 0)", "# sets of claims"]
    out += [f"{k}: {', '.join(c) or 'none'}" for c, k in number.items()]
    out.append("# equation | term | set")
    return "\n".join([*out, *(f"{n.equation} | {n.term} | {number[n.claims]}" for n in found)]) + "\n"
