"""Indexed families: what a system says of each route, apart from what it says of places.

Every route has the same variables (set, locked, proceed, ...), and the definitions of places read those of many
routes. A variable of a route is an *indexed family* with the route's number as its index.  What is said of a member of
the family is kept as *guarded clauses*, expressions over names and families: the variable of a route implies what the
clause says of the same route.  A clause is kept once, with the set of all routes that have it.

**Theorem.**  A formula over one route is equivalent to the conjunction of its clauses, and a clause in which a
variable of the route is denied is an implication with that variable as guard; so guarded clauses, each read for every
route of its set, say no more than the system does.  (Conjunctive normal form; families and their quotient: Clarke,
Grumberg and Long, 1994.)
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from enum import IntEnum

from interlock.dataclass import dataclass
from interlock.logic.expr import AND, EQ, NOT, OR, VAR, WIDE, Expr, Substitution, disj, neg, parts_of, rebuild, var
from interlock.logic.names import Name, each_value
from interlock.proof.system.neighbourhood import RouteVariables
from interlock.proof.system.relation import TransitionRelation

MANY = 64  # clauses of one expression

IndexedVariable = tuple[Name, int]
"""A variable of any route, or that a variable has the number of any, and the number of the route."""


class Kind(IntEnum):
    """Where a clause is from: a definition, an assumption, or an invariant."""

    DEFINED = 0
    ASSUMED = 1
    KEPT = 2


@dataclass(eq=False, slots=True)
class GuardedClause:
    """A variable of the family implies the expression, for each of the members.

    families: those that it reads.  lifts: it reads them only as true, so that what holds of each of some members holds
    of them all together.
    """

    number: int
    family: Name
    kind: Kind
    expr: Expr
    names: tuple[Name, ...]
    families: tuple[Name, ...]
    lifts: bool
    members: int = 0
    """By number, as bits: one that is told the same twice counts once."""


class IndexedFamilies:
    """The definitions and facts of a step, sorted into those of routes and those of places."""

    def __init__(self, relation: TransitionRelation, routes: RouteVariables, hypotheses: Sequence[Expr]) -> None:
        """`hypotheses`: the invariants; they hold before the step."""
        self._member = routes.indexed
        self._numbers = {number for _, number in self._member.values()}
        self._requests = frozenset(routes.requests)
        self._read: dict[Expr, tuple[tuple[Name, ...], tuple[IndexedVariable, ...]]] = {}
        self._families: dict[Expr, tuple[Name, ...]] = {}
        self._guarded: dict[tuple[Name, Kind, Expr], GuardedClause] = {}
        self.defining: dict[IndexedVariable, list[GuardedClause] | None] = {}
        """The guarded clauses that together are the definition of a member's variable; None where no clauses are."""
        self.telling: dict[IndexedVariable, list[GuardedClause]] = {}
        """What facts say of a member's variable."""
        self.meaning: dict[Name, Expr] = {}
        """The definitions of all other names."""
        self.plain: list[tuple[Expr, Kind]] = []
        """Facts that read no routes."""
        self.mixed: list[tuple[Expr, Kind]] = []
        """Facts that read several routes."""
        same = self._same_names(relation)
        self._same = {self._member[name] for name in same}
        self._put = Substitution({name: var(other) for name, other in same.items()})
        for name, x in relation.definitions.items():
            member = self._member.get(name)
            if member is None:
                self.meaning[name] = self.named(x)
            elif name in same:
                continue
            else:
                meant = self.named(relation.definitions[x.name] if x.op is VAR and same.get(x.name) == name else x)
                parts = [self.abstract(a, member[1]) for a in _all(meant)]
                guarded = [self._guard(member, Kind.DEFINED, x) for x in parts if x is not None]
                self.defining[member] = guarded if len(guarded) == len(parts) else None
        for kind, facts in ((Kind.KEPT, hypotheses), (Kind.ASSUMED, [a.expr for a in relation.assumptions])):
            for x in facts:
                for fact in _all(self.named(x)):
                    self._sort(fact, kind)
        self.guarded = list(self._guarded.values())

    def _same_names(self, relation: TransitionRelation) -> dict[Name, Name]:
        """Variables of routes that others are defined to be, and these."""
        found: dict[Name, Name] = {}
        for name in self._member:
            x = relation.definitions.get(name)
            if x is not None and x.op is VAR and x.name in self._member and x.name in relation.definitions:
                found.setdefault(x.name, name)
        return {name: other for name, other in found.items() if other not in found}

    def named(self, x: Expr) -> Expr:
        """The expression with one name for what has two."""
        return x if self._same.isdisjoint(self.read(x)[1]) else self._put(x)

    def read(self, x: Expr) -> tuple[tuple[Name, ...], tuple[IndexedVariable, ...]]:
        """The names and the members that an expression reads."""
        found = self._read.get(x)
        if found is None:
            names: dict[Name, None] = {}
            members: dict[IndexedVariable, None] = {}
            todo, done, member = [x], set(), self._member
            while todo:
                y = todo.pop()
                op = y.op
                if op is NOT:
                    y = y.args[0]
                    op = y.op
                if op is VAR:
                    name = y.name
                    if name in member:
                        members[member[name]] = None
                    else:
                        names[name] = None
                elif y.args:
                    if y in done:
                        continue
                    done.add(y)
                    if len(y.args) > WIDE and y is not x:
                        inner, of_inner = self.read(y)  # many share it
                        names |= dict.fromkeys(inner)
                        members |= dict.fromkeys(of_inner)
                    else:
                        todo += y.args
                elif y.name:
                    of = self.of(y)
                    if of is None:
                        names[y.name] = None
                    else:
                        members[of] = None
            found = self._read[x] = tuple(names), tuple(members)
        return found

    def families(self, x: Expr) -> tuple[Name, ...]:
        """The families that an expression over families reads."""
        found = self._families.get(x)
        if found is None:
            found = self._families[x] = tuple(n for n in self.read(x)[0] if n.indexed)
        return found

    def of(self, x: Expr) -> IndexedVariable | None:
        """Family and member of a variable or comparison, if it belongs to a route."""
        if x.op is VAR:
            return self._member.get(x.name)
        numbered = x.op is EQ and x.name in self._requests and x.value in self._numbers
        return (each_value(x.name), x.value) if numbered else None

    def _sort(self, fact: Expr, kind: Kind) -> None:
        """A fact of one member becomes guarded clauses."""
        _, members = self.read(fact)
        if not members:
            self.plain.append((fact, kind))
        elif len({number for _, number in members}) > 1:
            self.mixed.append((fact, kind))
        else:
            number = members[0][1]
            whole = self.abstract(fact, number)
            assert whole is not None  # the fact reads no other member
            for clause in clauses(whole):
                self._tell(clause, number, kind)

    def _tell(self, clause: Sequence[Expr], number: int, kind: Kind) -> None:
        """A clause in which some variable of the member is false tells of that one; another is left out."""
        for n, x in enumerate(clause):
            if x.op is NOT and x.args[0].name.indexed:
                member = x.args[0].name, number
                guarded = self._guard(member, kind, disj([*clause[:n], *clause[n + 1 :]]))
                self.telling.setdefault(member, []).append(guarded)
                return

    def _guard(self, member: IndexedVariable, kind: Kind, expr: Expr) -> GuardedClause:
        """What is said of one member, over families."""
        family, number = member
        clause = self._guarded.get((family, kind, expr))
        if clause is None:
            names = self.read(expr)[0]
            families = tuple(n for n in names if n.indexed)
            clause = self._guarded[family, kind, expr] = GuardedClause(
                len(self._guarded),
                family,
                kind,
                expr,
                tuple(n for n in names if not n.indexed),
                families,
                _positive(expr, True),
            )
        clause.members |= 1 << number
        return clause

    def abstract(self, x: Expr, number: int) -> Expr | None:
        """The expression over families instead of a member's variables; None where it reads another member."""
        if x.args:
            args: list[Expr] = []
            for a in x.args:
                y = a if a.op is VAR and a.name not in self._member else self.abstract(a, number)
                if y is None:
                    return None
                args.append(y)
            return rebuild(x, tuple(args))
        member = self.of(x) if x.name else None
        if member is None:
            return x
        return var(member[0]) if member[1] == number else None

    def pieces(self, goal: Expr) -> tuple[int, list[Expr]]:
        """The only member that a goal reads, and expressions over families that together are the goal."""
        _, members = self.read(goal)
        number = members[0][1]
        whole = self.abstract(goal, number)
        assert whole is not None  # the goal reads no other member
        return number, [disj(clause) for fact in _all(whole) for clause in clauses(fact)]


def _all(x: Expr) -> tuple[Expr, ...]:
    return x.args if x.op is AND else (x,)


def clauses(x: Expr) -> Iterator[list[Expr]]:
    """Disjunctions that together are the expression; where they would be too many, some are not taken apart."""
    todo, left = [(_alternatives(x), 0)], MANY
    while todo:
        clause, begin = todo.pop()
        n = next((n for n in range(begin, len(clause)) if parts_of(clause[n])), None) if left > 0 else None
        if n is None:
            yield clause
            continue
        parts, before, behind = parts_of(clause[n]), clause[:n], clause[n + 1 :]
        left -= len(parts)
        todo.extend([([*before, *_alternatives(p), *behind], n) for p in reversed(parts)])


def _alternatives(x: Expr) -> list[Expr]:
    """The parts of a disjunction, and of those of them that are one."""
    if x.op is OR:
        return [b for a in x.args for b in (_alternatives(a) if a.args else (a,))]
    if x.op is NOT and x.args[0].op is AND:
        return [b for a in x.args[0].args for b in _alternatives(neg(a))]
    return [x]


def _positive(x: Expr, side: bool) -> bool:
    """No family is read as false."""
    if x.op is NOT:
        return _positive(x.args[0], not side)
    if x.args:
        return all(_positive(a, side) for a in x.args)
    return side or not x.name.indexed
