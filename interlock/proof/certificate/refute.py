"""A refutation with hints (LRAT without deletions) for a shape.

The clauses of a shape: one unit for each part of the negated goal, then each fact.  A part that is no literal gets a
variable of its own, defined by clauses that come before the clause in which it stands, parts first.  A SAT solver
writes the learned clauses; propagation in their order finds the hints, and what no later clause needs is left out.
"""

from __future__ import annotations

from pysat.solvers import Glucose4

from interlock.proof.certificate.shapes import Shape, Step

Clause = tuple[int, ...]


class Encoder:
    """Clauses of patterns; leaves are the numbers that the caller gives, further variables follow."""

    def __init__(self, leaves: int) -> None:
        self.count = leaves
        self.clauses: list[Clause] = []

    def clause(self, text: str, leaves: tuple[int, ...]) -> None:
        """The pattern as one clause."""
        text = text.split(":", 1)[1]
        self.clauses.append(tuple(dict.fromkeys(self._disjuncts(text, leaves))))

    def negated(self, text: str, leaves: tuple[int, ...]) -> None:
        """The negation of the pattern as units."""
        text = text.split(":", 1)[1]
        for lit in self._disjuncts(text, leaves):
            self.clauses.append((-lit,))

    def _disjuncts(self, text: str, leaves: tuple[int, ...]) -> list[int]:
        if text == "F":
            return []
        sign, op, items = parse(text)
        if op == "|" and not sign:
            return [self._literal(x, leaves) for x in items]
        return [self._literal(text, leaves)]

    def _literal(self, text: str, leaves: tuple[int, ...]) -> int:
        sign, op, items = parse(text)
        if op == "":
            return -leaves[int(items[0]) - 1] if sign else leaves[int(items[0]) - 1]
        args = [self._literal(x, leaves) for x in items]
        self.count += 1
        new = self.count
        if op == "|":
            self.clauses.append((-new, *args))
            self.clauses.extend((new, -a) for a in args)
        else:
            self.clauses.append((new, *(-a for a in args)))
            self.clauses.extend((-new, a) for a in args)
        return -new if sign else new


def parse(text: str) -> tuple[bool, str, list[str]]:
    """Sign, operator ('' for a leaf) and parts of a pattern's text."""
    sign = text.startswith("!")
    body = text[1:] if sign else text
    if not body.startswith("("):
        return sign, "", [body]
    items, depth, start = [], 0, 3
    inner = body[3:-1]
    start = 0
    for i, c in enumerate(inner):
        if c == "(":
            depth += 1
        elif c == ")":
            depth -= 1
        elif c == " " and not depth:
            items.append(inner[start:i])
            start = i + 1
    items.append(inner[start:])
    return sign, body[1], items


def clauses_of(shape: Shape) -> tuple[int, list[Clause]]:
    """The number of variables and the clauses of a shape."""
    leaves = max([shape.arity, *(n + 1 for p in shape.parts for n in p.leaves)])
    out = Encoder(leaves)
    out.negated(shape.goal, tuple(range(1, shape.arity + 1)))
    for p in shape.parts:
        out.clause(p.text, tuple(n + 1 for n in p.leaves))
    return out.count, out.clauses


def refutation(shape: Shape) -> tuple[Step, ...] | None:
    """Steps that end in the empty clause, or None when the shape is satisfiable."""
    _, clauses = clauses_of(shape)
    propagation = Propagation(clauses)
    if (hints := propagation.hints(())) is not None:
        return (((), hints),)
    with Glucose4(bootstrap_with=clauses, with_proof=True) as solver:
        if solver.solve() is not False:
            return None
        lines = solver.get_proof() or []
    learned = [tuple(map(int, x.split()[:-1])) for x in lines if not x.startswith("d")]
    if not learned or learned[-1]:
        learned.append(())
    base = len(clauses)
    steps: list[Step] = []
    for lits in learned:
        hints = propagation.hints(lits)
        if hints is None:
            return None
        steps.append((lits, hints))
        propagation.add(lits)
        if not lits:
            break
    return _needed(base, steps)


class Propagation:
    """Unit propagation over a growing list of clauses, by counting what is not yet false."""

    def __init__(self, clauses: list[Clause]) -> None:
        self.clauses: list[Clause] = []
        self.sizes: list[int] = []
        self.units: list[int] = []
        self.with_: dict[int, list[int]] = {}
        for c in clauses:
            self.add(c)

    def add(self, clause: Clause) -> None:
        """One more clause, without a literal twice."""
        n = len(self.clauses)
        self.clauses.append(clause)
        self.sizes.append(len(clause))
        if len(clause) == 1:
            self.units.append(n)
        for x in clause:
            self.with_.setdefault(x, []).append(n)

    def hints(self, lits: Clause) -> tuple[int, ...] | None:
        """The clauses, in order, that become unit and at last false when the literals are false."""
        true: set[int] = set()
        reason: dict[int, int] = {}
        order: list[int] = []
        left = self.sizes.copy()
        todo = [-x for x in lits]
        forced = [(self.clauses[n][0], n) for n in self.units]
        while True:
            for x, n in forced:
                if -x in true:
                    return self._trace(n, reason, order)
                if x not in true and x not in reason:
                    reason[x] = n
                    order.append(n)
                    todo.append(x)
            forced = []
            if not todo:
                return None
            x = todo.pop()
            if x in true:
                continue
            true.add(x)
            for n in self.with_.get(-x, ()):
                left[n] -= 1
                if left[n] == 0:
                    return self._trace(n, reason, order)
                if left[n] == 1:
                    free = next((y for y in self.clauses[n] if -y not in true), None)
                    if free is None:
                        return self._trace(n, reason, order)
                    if free not in true:
                        forced.append((free, n))

    def _trace(self, last: int, reason: dict[int, int], order: list[int]) -> tuple[int, ...]:
        needed = {last}
        todo = list(self.clauses[last])
        while todo:
            n = reason.get(-todo.pop())
            if n is not None and n not in needed:
                needed.add(n)
                todo += self.clauses[n]
        return (*(n for n in order if n in needed and n != last), last)


def _needed(base: int, steps: list[Step]) -> tuple[Step, ...]:
    """Only the steps that the empty clause needs, numbered anew."""
    used = {len(steps) - 1}
    for i in range(len(steps) - 1, -1, -1):
        if i in used:
            used |= {h - base for h in steps[i][1] if h >= base}
    numbers = {base + i: base + k for k, i in enumerate(sorted(used))}
    return tuple((lits, tuple(numbers.get(h, h) for h in hints)) for i, (lits, hints) in enumerate(steps) if i in used)
