"""What follows in several short steps, said once for all goals that need it.

A route that shows proceed has its points where it wants them: that follows from what it shows to what is firm, from
there to the ways that are locked, and from these to how the points lie.  Each claim about a signal would go that way
again for each of its routes.  Instead the end is said as a lemma, which is proved like any other goal.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from interlock.logic.expr import AND, EQ, NOT, OR, VAR, Expr, disj, neg, var, variables
from interlock.proof.system import System

FAR = 7
"""Steps from a route that shows proceed to what a lemma says: by its equations to the contacts of a point."""


@dataclass(frozen=True)
class Lemma:
    """Something about a route: the variable that says it, and the clause."""

    source: str
    clause: Expr


class Chains:
    """Clauses of two or three literals, to go from what is true to what follows.

    A literal is a number, and its negation the same with the last bit changed.
    """

    def __init__(self) -> None:
        self._numbers: dict[Expr, int] = {}
        self._alone: list[list[int]] = []
        self._paired: list[list[tuple[int, int]]] = []

    def number(self, literal: Expr) -> int:
        """The number of a literal."""
        found = self._numbers.get(literal)
        if found is None:
            found = self._numbers[literal] = len(self._alone)
            self._numbers[neg(literal)] = found ^ 1
            self._alone += [], []
            self._paired += [], []
        return found

    def learn(self, clauses: Iterable[Expr]) -> None:
        """More clauses; what is no short clause of literals is passed over."""
        for c in clauses:
            lits = [*map(self.number, _literals(c))]
            if len(lits) == 2:
                a, b = lits
                self._alone[a ^ 1].append(b)
                self._alone[b ^ 1].append(a)
            elif len(lits) == 3:
                for i, a in enumerate(lits):
                    b, then = lits[i - 1], lits[i - 2]
                    self._paired[a ^ 1] += (b ^ 1, then), (then ^ 1, b)

    def implied(self, start: Expr, most: int) -> dict[int, int]:
        """What follows from a literal in so many steps, each with the number of steps to it."""
        first = self.number(start)
        found = {first: 0}
        todo = [first]
        for x in todo:  # grows on the way
            steps = found[x] + 1
            if steps > most:
                break
            new = self._alone[x]
            if self._paired[x]:
                new = new + [then for other, then in self._paired[x] if other in found]
            for y in new:
                if y not in found and y ^ 1 not in found:
                    found[y] = steps
                    todo.append(y)
        return found


def _literals(clause: Expr) -> list[Expr]:
    """The two or three literals of a clause, or none where it has another form."""
    found: list[Expr] = []
    for x in clause.args if clause.op is OR else (clause,):
        inner = x.args[0] if x.op is NOT else x
        if inner.op is VAR or inner.op is EQ:
            found.append(x)
        elif x.op is NOT and inner.op is AND and len(inner.args) < 4:
            if any(a.op is AND or a.op is OR or (a.op is NOT and a.args[0].op is not VAR) for a in inner.args):
                return []
            found += map(neg, inner.args)
        else:
            return []
        if len(found) > 3:
            return []
    return found


def before(system: System, known: Chains) -> list[Lemma]:
    """Before a step is looked at: what a route's state says of a place whose next value depends on it."""
    homes = system.homes
    after = {x: v for v, x in system.later.items()}
    at_home: dict[str, list[str]] = {}
    for v in system.state:
        at_home.setdefault(homes.get(v, ""), []).append(v)
    wanted: dict[str, dict[str, None]] = {}
    for name, x in system.definitions.items():
        if name in after and name not in system.members:
            for v in variables((x,)):
                if v in system.members and v not in system.later:
                    wanted.setdefault(v, {})[homes.get(name, "")] = None
    out: list[Lemma] = []
    for v, places in wanted.items():
        found = known.implied(var(v), 2)
        names = [u for place in places for u in at_home.get(place, ())]
        out += [Lemma(v, disj((neg(var(v)), var(u)))) for u in names if found.get(known.number(var(u))) == 2]
    return out


def shown(system: System, known: Chains, claims: Sequence[Expr]) -> list[Lemma]:
    """After it: what a route that shows proceed says of what stands beside it in a claim."""
    following = {x for x in system.later.values() if x in system.members}
    wanted: dict[str, dict[str, None]] = {}
    for c in claims:
        names = variables((c,))
        beside = [v for v in names if v not in system.members]
        for v in names:
            if v in following:
                wanted.setdefault(v, {}).update(dict.fromkeys(beside))
    out: list[Lemma] = []
    for v, names in wanted.items():
        found = known.implied(var(v), FAR)
        for other in names:
            for y in (var(other), neg(var(other))):
                if found.get(known.number(y), 0) > 1:
                    out.append(Lemma(v, disj((neg(var(v)), y))))
    return out
