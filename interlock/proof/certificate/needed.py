"""What the proof rests on: for each claim, the terms of the controller and the assumptions that its proof used.

A claim needs the facts of its own obligations and, with every invariant among them, those of the invariant's step, and
of whatever else was proved of the step.
A term that no claim needs is not thereby superfluous: it may serve availability, or protect where a claim is silent.

**Theorem.**  What is marked for a claim is closed under "is shown by", and for an invariant that is used under what its
step is shown by: so the proof of the claim stands without any term that is not marked for it.  (Reachability in a
proof's graph of hints; trimming of proofs: Heule, Hunt and Wetzler, 2013.)
"""

from __future__ import annotations

from collections.abc import Iterator

from interlock.dataclass import dataclass
from interlock.logic.controller import Controller, Equation, Join
from interlock.logic.expr import Expr, disj, neg, var
from interlock.logic.names import Name
from interlock.proof.certificate.engine import LocalProof, Obligation
from interlock.proof.certificate.facts import GoalKind, Kind, split


@dataclass(frozen=True)
class Need:
    """A term of an equation and the claims whose proof used it."""

    equation: str
    term: str
    claims: tuple[str, ...]


def claims_of_facts(proof: LocalProof) -> dict[int, frozenset[str]]:
    """For every fact of the step, the claims that rest on it.

    A claim is a bit; what a clause that was shown, or an invariant's step, is needed for goes on to the clauses that
    show it, last ones first, until nothing is new.
    """
    base = proof.base
    steps = [o for o in proof.obligations if o.goal.of_step]
    named = {c: 1 << k for k, c in enumerate(dict.fromkeys(c.id for c in base.claims))}
    shown = [(n, hints) for o in reversed(steps) for n, hints in _shown(o)]
    mask = [0] * (1 + max((n for n, _ in shown), default=max(proof.facts, default=0)))
    of_invariant: list[list[int]] = [[] for _ in base.invariants]
    for o in steps:
        if o.goal.kind is GoalKind.CLAIM:
            mask[o.number] = named[o.goal.source]
        elif o.goal.kind is GoalKind.STEP:
            of_invariant[o.goal.index].append(o.number)
    invariants = [n for n, f in zip(proof.facts, base.steps, strict=True) if f.kind is Kind.INVARIANT]
    told = [0] * len(mask)
    again = True
    while again:
        again = False
        for n, hints in shown:
            bits = mask[n]
            if bits != told[n]:
                again, told[n] = True, bits
                for h in hints:
                    mask[h] |= bits
        at = 0
        for those in of_invariant:  # as facts they stand in the order in which their steps are goals
            bits = 0
            for _ in those:
                bits |= mask[invariants[at]]
                at += 1
            for n in those:
                mask[n] |= bits
    sets: dict[int, frozenset[str]] = {}
    for bits in {mask[n] for n in proof.facts}:
        sets[bits] = frozenset(c for c, bit in named.items() if bits & bit)
    return {n: sets[mask[at]] for n, at in enumerate(proof.facts) if mask[at]}


def _shown(o: Obligation) -> Iterator[tuple[int, tuple[int, ...]]]:
    """Each clause that an obligation writes, last first, and the numbers of those that show it."""
    yield o.number, o.hints
    for n, lemma in enumerate(reversed(o.lemmas), 1):
        yield o.number - n, lemma.hints


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


def _equations(c: Controller) -> Iterator[tuple[Equation, Name]]:
    for e in c.equations:
        yield e, e.name
    for e in c.next:
        yield e, e.name.next


def _part(name: Name, e: Equation, term: Expr) -> list[Expr]:
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
