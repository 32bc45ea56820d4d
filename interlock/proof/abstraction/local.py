"""Local abstractions: small systems that follow from a large one, with routes taken together that a place cannot tell
apart.

**Theorem.**  Let the routes be partitioned, and read the variable of a block as the disjunction of that variable over
its routes; then every line of a local abstraction holds in the large system, whichever partition and names were
chosen, so that a goal which follows from the lines follows from the system.  (Existential abstraction: Clarke,
Grumberg and Long, *Model Checking and Abstraction*, 1994; the cases below.  `tests/test_abstraction.py` asks a
solver for each line.)

- a disjunction over routes is the disjunction over their blocks;
- what a variable of each route implies, its block's variable implies, if the routes' variables stand in it only as
  true;
- the definition of a route's variable is that of its block's, where the block has no other route;
- of the values that a variable has in the routes of different blocks, it has one at most;
- what is left out, and definitions that are, make an abstraction say less.

A goal that speaks of one route is asked for a representative of its block, which is then a block of its own beside
the rest: the abstraction of any other route of it is the same but for the number.  How large an abstraction is depends
on how many ways there are to pass a place, not on how many routes there are.

Its definitions are those in the cone of influence of its goals.  A *truncated* cone ends at elements that the goals do
not name: of these it has how they are, and not why.  Nor has it far meanings, of names that the goals do not read:
what an approach of ten sections is clear of would bring all of them into the cone of each of its signal's sections,
and no place of a yard would be like another.  Goals that are far themselves share no cone with others; theirs has, of
the elements that they name, what is said in few words.  Nearly all goals follow in a truncated cone; the others are
asked with the whole one.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace

from interlock.dataclass import dataclass
from interlock.logic.expr import AND, NOT, OR, VAR, Expr, var
from interlock.logic.names import NONE, Name, Owner, of_block
from interlock.model.bits import bits, bits_of
from interlock.proof.abstraction.indexed import GuardedClause, IndexedFamilies, Kind
from interlock.proof.system.neighbourhood import Neighbourhood
from interlock.proof.system.relation import TransitionRelation

_KEPT = Kind.KEPT

MAX_SUPPORT = 30  # a fact whose support, the names that it reads, is larger is in no abstraction
MAX_HOMES = 7  # a meaning or goal that names more elements than this is far: that nobody is on a long approach
MAX_DEGREE = 60  # a name of the support of more facts than this leads to none of them


@dataclass(frozen=True, slots=True)
class Focus:
    """Goals that share a local abstraction.

    whole: goals by number.  pieces: an expression over families, and for each member of which it is to hold the goals
    that it is a part of.  homes: elements that the goals name.  far: each goal names many; families: those of which the
    pieces of other goals at its home speak.
    """

    homes: tuple[Owner, ...]
    whole: tuple[tuple[int, Expr], ...] = ()
    pieces: tuple[tuple[Expr, Mapping[int, tuple[int, ...]]], ...] = ()
    far: bool = False
    families: tuple[Name, ...] = ()

    @property
    def goals(self) -> Iterator[int]:
        """The goals by number; one of many pieces more than once."""
        yield from (n for n, _ in self.whole)
        yield from (n for _, by in self.pieces for those in by.values() for n in those)

    def only(self, goals: Collection[int]) -> Focus:
        """The focus of some of the goals."""
        pieces = [
            (x, {i: some for i, those in by.items() if (some := tuple(n for n in those if n in goals))})
            for x, by in self.pieces
        ]
        whole = tuple((n, x) for n, x in self.whole if n in goals)
        return replace(self, whole=whole, pieces=tuple((x, by) for x, by in pieces if by))


@dataclass(frozen=True, slots=True)
class LocalAbstraction:
    """A small system, and what is asked of it: expressions, and the goals that need each.

    blocks: their members, as bits; a block's variable is named by its number and its family.
    """

    definitions: Mapping[Name, Expr]
    facts: Sequence[Expr]
    asked: Sequence[tuple[Expr, tuple[int, ...]]]
    blocks: Sequence[int]


@dataclass(frozen=True, slots=True)
class Occurrences:
    """Routes' variables that a node reads, by family and as bits, and its other operands.

    A disjunction of members and others, a conjunction of members that are false and others, or a member alone.
    """

    node: Expr
    rest: tuple[Expr, ...]
    members: tuple[tuple[Name, int], ...]


@dataclass(frozen=True, slots=True)
class WholeDefinition:
    """Members of which the definition has just these guarded clauses with names."""

    family: Name
    named: tuple[GuardedClause, ...]
    members: int


def families_in(m: IndexedFamilies, x: Expr) -> tuple[Name, ...]:
    """The families that an expression reads."""
    return tuple(dict.fromkeys(f for f, _ in m.read(x)[1]))


class PlaceIndex:
    """The facts of a step that speak of places, by the names that they read; and what names lead to."""

    def __init__(self, state: Iterable[Name], homes: Mapping[Name, Owner], m: IndexedFamilies) -> None:
        self.homes = homes
        self.facts_at: dict[Name, list[int]] = {}
        self.alone_at: dict[Name, list[int]] = {}
        """Facts that speak of one name."""
        self.mixed_at: dict[Name, list[int]] = {}
        self.names_of = [m.read(x)[0] for x, _ in m.plain]
        """What each fact about places reads."""
        for n, names in enumerate(self.names_of):
            if len(names) <= MAX_SUPPORT:
                _note(self.facts_at, names, n)
            if len(names) == 1:
                _note(self.alone_at, names, n)
        self.next_to = [tuple(v for v in names if v not in m.meaning) for names in self.names_of]
        """What facts read that has no meaning: states and inputs."""
        self.leads = {v: (m.read(x)[0], families_in(m, x)) for v, x in m.meaning.items()}
        """What the meaning of a name reads, and the families of which it speaks."""
        self.far = frozenset(v for v, (names, _) in self.leads.items() if self.are_far(names))
        """Names whose meaning is far."""
        self.state_homes = {v: home for v in state if (home := self.homes.get(v)) is not None}
        for n, (x, _) in enumerate(m.mixed):
            _note(self.mixed_at, m.read(x)[0], n)
        for at in (self.facts_at, self.mixed_at):
            for v in [v for v, facts in at.items() if len(facts) > MAX_DEGREE]:
                del at[v]

    def are_far(self, names: Iterable[Name]) -> bool:
        """Whether names belong to many elements."""
        return len({self.homes[v] for v in names if v in self.homes}) > MAX_HOMES


class ClauseIndex:
    """What a system says of routes: its guarded clauses by the names that they read, and the definitions of members."""

    def __init__(self, m: IndexedFamilies, homes: Mapping[Name, Owner]) -> None:
        self.guarded_at: dict[Name, list[GuardedClause]] = {}
        self.families: dict[Name, dict[Name, None]] = {}
        """Those that a family's guarded clauses read."""
        self.names_at: dict[tuple[Name, Owner], dict[Name, None]] = {}
        """The names at an element that a family's guarded clauses read."""
        self.homes_of: dict[GuardedClause, frozenset[Owner]] = {}
        """The elements of which a clause speaks, if all its names belong to some."""
        for t in m.guarded:
            self._enter(t, homes)
        self._of_definitions(m)
        self.apart = _apart(m)
        """By family and member: the members, as bits, of which the variable is false while the member's is true."""

    def _of_definitions(self, m: IndexedFamilies) -> None:
        """Which members have one definition, and of which the same is said without names."""
        self.full_at: dict[GuardedClause | None, list[WholeDefinition]] = {}
        """Definitions of members that an abstraction may have whole, by one of their guarded clauses with names."""
        full: dict[tuple[Name, tuple[GuardedClause, ...]], int] = {}
        bare: dict[int, list[tuple[Name, tuple[int, ...], bool]]] = {}
        for (family, number), defining in m.defining.items():
            if defining is not None:
                named = tuple(t for t in defining if t.names)
                full[family, named] = full.get((family, named), 0) | 1 << number
            unnamed = tuple(t.number for t in defining or () if not t.names)
            bare.setdefault(number, []).append((family, unnamed, defining is None))
        for (family, number), telling in m.telling.items():
            bare.setdefault(number, []).append((family, tuple(t.number for t in telling if not t.names), False))
        for (family, named), members in full.items():
            self.full_at.setdefault(named[-1] if named else None, []).append(WholeDefinition(family, named, members))
        kinds: dict[tuple[object, ...], int] = {}
        for number, of in bare.items():
            kinds[tuple(of)] = kinds.get(tuple(of), 0) | 1 << number
        self.bare = list(kinds.values())
        """Members of which the same is said without names."""

    def _enter(self, t: GuardedClause, homes: Mapping[Name, Owner]) -> None:
        """Note what a clause reads."""
        for v in t.names:
            self.guarded_at.setdefault(v, []).append(t)
            home = homes.get(v)
            if home is not None:
                self.names_at.setdefault((t.family, home), {})[v] = None
        owners = [homes.get(v) for v in t.names]
        if None not in owners:
            self.homes_of[t] = frozenset(h for h in owners if h is not None)
        self.families.setdefault(t.family, {}).update(dict.fromkeys(t.families))


class BlockVariables(dict[tuple[Name, int], Expr]):
    """The variables of blocks, by family and number of the block: all abstractions have the same."""

    def __missing__(self, key: tuple[Name, int]) -> Expr:
        found = self[key] = var(of_block(*key))
        return found


class LocalAbstractions:
    """The local abstractions of a system."""

    def __init__(self, relation: TransitionRelation, where: Neighbourhood, hypotheses: Sequence[Expr]) -> None:
        """`hypotheses`: the invariants; they hold before the step."""
        self.members = IndexedFamilies(relation, where.routes, hypotheses)
        self.homes, self.beside = where.homes, where.beside
        self.places = PlaceIndex(relation.state, self.homes, self.members)
        self.clauses = ClauseIndex(self.members, self.homes)
        self._groups: dict[Expr, list[Occurrences]] = {}
        self.variables = BlockVariables()
        self.of_block: dict[tuple[Expr, int], Expr] = {}
        """Expressions over families, by blocks: what abstractions have in common."""
        self.told: dict[int, dict[GuardedClause, Expr]] = {}
        """Facts about blocks, by clause."""

    def groups(self, root: Expr) -> list[Occurrences]:
        """The nodes below an expression that read members."""
        found = self._groups.get(root)
        if found is None:
            found = self._groups[root] = []
            if self.members.read(root)[1]:
                todo, done = [root], set()
                while todo:
                    x = todo.pop()
                    if x not in done:
                        done.add(x)
                        group = self._group(x)
                        todo.extend(group.rest)
                        if group.members:
                            found.append(group)
        return found

    def _group(self, x: Expr) -> Occurrences:
        if not x.args:
            of = self.members.of(x) if x.name else None
            return Occurrences(x, (), () if of is None else ((of[0], 1 << of[1]),))
        rest: list[Expr] = []
        members: dict[Name, int] = {}
        for a in x.args:
            y = a.args[0] if x.op is AND and a.op is NOT else a
            of = None
            if not y.args and y.name and (y is not a or x.op is OR):
                of = self.members.of(y)
            if of is None:
                rest.append(a)
            else:
                members[of[0]] = members.get(of[0], 0) | 1 << of[1]
        return Occurrences(x, tuple(rest), tuple(members.items()))


def _apart(m: IndexedFamilies) -> dict[Name, dict[int, int]]:
    """What the invariants say of two routes; or each of them implies a name, and not both names are true."""
    against: dict[Name, set[Name]] = {}
    for x, kind in m.plain:
        if kind is _KEPT and x.op is NOT and x.args[0].op is AND and len(x.args[0].args) == 2:
            left, right = ([y.name for y in (a.args if a.op is OR else (a,)) if y.op is VAR] for a in x.args[0].args)
            for a in left:
                against.setdefault(a, set()).update(right)
            for b in right:
                against.setdefault(b, set()).update(left)
    found: dict[Name, dict[int, int]] = {}
    for x, kind in m.mixed:
        sides = _exclusive(m, x) if kind is _KEPT else None
        if sides is not None:
            family, some, rest = sides
            among = found.setdefault(family, {})
            for mine, theirs in ((some, rest), (rest, some)):
                for i in bits_of(mine):
                    among[i] = among.get(i, 0) | theirs
    implied: dict[Name, dict[Name, int]] = {}
    for t in m.guarded:
        if t.kind is _KEPT and t.expr.op is VAR and t.names and t.expr.name in against:
            implied.setdefault(t.family, {})[t.expr.name] = t.members
    for family, names in implied.items():
        of = found.setdefault(family, {})
        for a, members in names.items():
            others = 0
            for b in against[a]:
                others |= names.get(b, 0)
            for i in bits_of(members):
                of[i] = of.get(i, 0) | others
    return found


def _exclusive(m: IndexedFamilies, x: Expr) -> tuple[Name, int, int] | None:
    """A fact that of some members and others, as bits, not both have a variable of one family true."""
    if x.op is not NOT or x.args[0].op is not AND or len(x.args[0].args) != 2:
        return None
    sides = [[m.of(y) for y in (a.args if a.op is OR else (a,))] for a in x.args[0].args]
    families = {NONE if of is None else of[0] for side in sides for of in side}
    if len(families) != 1 or NONE in families:
        return None
    left, right = (bits(of[1] for of in side if of is not None) for side in sides)
    return families.pop(), left, right


def _note(at: dict[Name, list[int]], names: Iterable[Name], n: int) -> None:
    for v in names:
        at.setdefault(v, []).append(n)
