"""One local abstraction: the cone of some goals, the coarsest partition of routes that its lines allow, each block.

**Theorem.**  The partition is refined by every set of routes that occurs in a line that is kept, so that each of
these sets is a union of blocks and its disjunction is one over blocks; by the theorem of `local.py` every line then
holds in the large system.  (Partition refinement by splitters: Paige and Tarjan, *Three Partition Refinement
Algorithms*, 1987.)
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from itertools import chain

from interlock.logic.expr import AND, FALSE, Expr, conj, disj, implies, neg, rebuild
from interlock.logic.names import Form, Name, Owner
from interlock.logic.names import Kind as ElementKind
from interlock.model.bits import bits, bits_of
from interlock.proof.abstraction.indexed import GuardedClause, IndexedVariable
from interlock.proof.abstraction.local import Focus, LocalAbstraction, LocalAbstractions, Occurrences, families_in

SHORT = 3  # names that a meaning reads which is there for goals that name many elements


def _at(where: Mapping[Name, Sequence[int]], names: Iterable[Name]) -> dict[int, None]:
    """The numbers that stand at some names."""
    return dict.fromkeys(chain.from_iterable(filter(None, map(where.get, names))))


class _Cone:
    """The cone of influence of a focus; `truncated`: it ends at elements that the goals do not name."""

    def __init__(self, local: LocalAbstractions, focus: Focus, truncated: bool) -> None:
        self._local, self._truncated, self._far = local, truncated, focus.far
        self.names: dict[Name, None] = {}
        self._families: dict[Name, None] = {}
        self._elements: dict[Owner, None] = dict.fromkeys(focus.homes)
        self._grow(focus)

    def _grow(self, focus: Focus) -> None:
        """Begin with the names in the goals, and the elements to which they belong."""
        m, homes = self._local.members, self._local.places.homes
        names: dict[Name, None] = {}
        families: dict[Name, None] = {} if self._truncated else dict.fromkeys(focus.families)
        for _, x in focus.whole:
            names |= dict.fromkeys(m.read(x)[0])
            families |= dict.fromkeys(families_in(self._local.members, x))
        for x, _ in focus.pieces:
            for v in m.read(x)[0]:
                if v.indexed:
                    families[v] = None
                else:
                    names[v] = None
        if not self._truncated or not self._far:
            self._elements |= dict.fromkeys(homes[v] for v in names if v in homes)
        self._named = frozenset(names)
        self._reach(names, families, self._elements)

    def _reach(self, names: Iterable[Name], families: Iterable[Name], elements: Iterable[Owner]) -> None:
        """Add names to the cone, what they mean, and what families of which they speak say of the elements.

        A truncated cone has no reasons for what is at an element that the goals do not name.
        """
        todo, fresh, leads = list(names), list(families), self._local.places.leads
        while todo or fresh:
            while fresh:
                f = fresh.pop()
                if f not in self._families:
                    self._families[f] = None
                    fresh.extend(self._local.clauses.families.get(f, ()))
                    for h in elements:
                        todo.extend(self._local.clauses.names_at.get((f, h), ()))
            while todo:
                v = todo.pop()
                if v not in self.names:
                    self.names[v] = None
                    if v in leads and (not self._truncated or self._is_near(v)):
                        reads, speaks_of = leads[v]
                        todo += reads
                        fresh += speaks_of

    def _is_near(self, name: Name) -> bool:
        """Whether a truncated cone has the meaning of a name."""
        places = self._local.places
        home = places.homes.get(name)
        if self._far:
            return home is None or self._is_here(name) or len(places.leads[name][0]) <= SHORT
        return (name not in places.far or name in self._named) and (home is None or home in self._elements)

    def _around(self) -> dict[int, None]:
        """Facts that speak of the names."""
        return _at(self._local.places.facts_at, self.names)

    def _deepen(self, facts: Iterable[int]) -> None:
        """See what names mean that stand in facts of which the abstraction sees all else."""
        homes, next_to, names_of = self._local.places.homes, self._local.places.next_to, self._local.places.names_of
        inside = set(map(homes.get, self.names)) - {None}
        mine, states = self.names, self._local.places.state_homes
        for n in facts:
            for v in next_to[n]:
                if v not in mine and states.get(v) not in inside:
                    break
            else:
                self._reach([v for v in names_of[n] if v not in mine], (), ())

    def _is_told(self, names: Sequence[Name]) -> bool:
        """Whether a fact about names in a truncated cone for far goals is told: of elements where the cone ends, what
        is said in few words of a name that has a meaning."""
        leads = self._local.places.leads
        return any(self._is_here(v) or (v in leads and len(names) <= SHORT) for v in names)

    def _is_here(self, name: Name) -> bool:
        """Whether a name belongs to an element at which a truncated cone for far goals does not end: a home of the
        focus, or a signal."""
        home = self._local.places.homes.get(name)
        return home is not None and (home in self._elements or home.kind is ElementKind.SIGNAL)

    def collect(self) -> tuple[list[Expr], list[Expr]]:
        """The facts of places, and those of several members."""
        m = self._local.members
        found = self._around()
        self._deepen(found)
        cone = set(self.names)
        names_of = self._local.places.names_of
        found |= _at(self._local.places.alone_at, self.names)
        told = [n for n in found if cone.issuperset(names_of[n])]
        if self._truncated and self._far:
            told = [n for n in told if self._is_told(names_of[n])]
        return [m.plain[n][0] for n in told], [m.mixed[n][0] for n in _at(self._local.places.mixed_at, self.names)]

    def clauses(self) -> list[GuardedClause]:
        """The guarded clauses of which all names are in the cone.

        A truncated cone has none that speaks of other elements than the goals name.
        """
        hits = Counter(chain.from_iterable(filter(None, map(self._local.clauses.guarded_at.get, self.names))))
        found = [t for t, n in hits.items() if n == len(t.names)]
        if self._truncated:
            homes = self._local.clauses.homes_of
            found = [t for t in found if t not in homes or not homes[t].isdisjoint(self._elements)]
        return found


class _Partition:
    """The coarsest partition of the members that the lines of an abstraction read, in blocks of members as bits."""

    def __init__(
        self, local: LocalAbstractions, focus: Focus, kept: Iterable[Expr], clauses: Sequence[GuardedClause]
    ) -> None:
        """`kept`: expressions of the abstraction; `clauses`: those of which it has all names."""
        self._local = local
        self.blocks: list[int] = []
        self.alone: dict[int, int] = {}
        """Blocks of one member that goals speak of, and all members that are like it: the rest is the block after."""
        self.told = frozenset(clauses)
        """The guarded clauses of which the abstraction has all names."""
        self.whole: dict[Name, int] = {}
        """By family the members of which the abstraction can tell the definition, all of it."""
        self.nodes: dict[Expr, Occurrences] = {}
        self._refine(focus, kept, clauses)

    def _refine(self, focus: Focus, kept: Iterable[Expr], clauses: Sequence[GuardedClause]) -> None:
        """Sort the members that are read into blocks."""
        marks: list[int] = []
        for x in kept:
            for group in self._local.groups(x):
                if group.node not in self.nodes:
                    self.nodes[group.node] = group
                    marks += [members for _, members in group.members]
        spoken = 0
        for _, by in focus.pieces:
            some = bits(by)
            marks.append(some)
            spoken |= some
        every = 0
        for some in marks:
            every |= some
        told, full_at = self.told, self._local.clauses.full_at
        fulls = [f for t in (None, *clauses) for f in full_at.get(t, ()) if told.issuperset(f.named)]
        for f in fulls:
            self.whole[f.family] = self.whole.get(f.family, 0) | f.members
        guarded = [t.members for t in clauses]
        classes = [every] if every else []
        cuts = dict.fromkeys(
            [some & every for some in (*marks, *guarded, *self._local.clauses.bare, *(f.members for f in fulls))]
        )
        for some in cuts:
            if any(0 != c & some != c for c in classes):
                classes = [part for c in classes for part in (c & some, c & ~some) if part]
        for members in classes:
            if members & spoken:
                first = members & -members
                self.alone[len(self.blocks)] = members
                self.blocks += [first, members ^ first]
            else:
                self.blocks.append(members)


class _Quotient:
    """The making of one abstraction."""

    def __init__(self, local: LocalAbstractions) -> None:
        self._local, self._members = local, local.members
        self._definitions: dict[Name, Expr] = {}
        self._facts: list[Expr] = []
        self._reached: dict[IndexedVariable, None] = {}
        self._done: dict[Expr, Expr] = {}

    def abstraction(self, focus: Focus, truncated: bool) -> LocalAbstraction:
        """All of it."""
        cone = _Cone(self._local, focus, truncated)
        facts, mixed = cone.collect()
        meaning = self._members.meaning
        defined = {v: meaning[v] for v in cone.names if v in meaning}
        speak = [v for v in defined if self._local.places.leads[v][1]]
        kept = [*(x for _, x in focus.whole), *(defined[v] for v in speak), *mixed]
        self._parts = _Partition(self._local, focus, kept, cone.clauses())
        asked: list[tuple[Expr, tuple[int, ...]]] = [(self._merged(x), (n,)) for n, x in focus.whole]
        for x, numbers in focus.pieces:
            for block, those in self._parts.alone.items():
                if (those & -those).bit_length() - 1 in numbers:
                    goals = {n: None for i in bits_of(those) for n in numbers[i]}
                    asked.append((self._over(x, block), tuple(goals)))
        self._definitions |= defined
        self._definitions |= {v: self._merge(defined[v]) for v in speak}
        self._facts += [*facts, *map(self._merge, mixed)]
        told: set[IndexedVariable] = set()
        while len(told) < len(self._reached):
            for key in [k for k in self._reached if k not in told]:
                told.add(key)
                if key[0].form is Form.VALUE:
                    continue
                self._tell(*key)
        self._one_value()
        self._keep_apart()
        return LocalAbstraction(self._definitions, self._facts, asked, self._parts.blocks)

    def _use(self, family: Name, block: int) -> Expr:
        """The variable of a block."""
        self._reached[family, block] = None
        return self._local.variables[family, block]

    def _merged(self, root: Expr) -> Expr:
        """An expression over blocks instead of members."""
        return self._merge(root) if self._members.read(root)[1] else root

    def _merge(self, x: Expr) -> Expr:
        known = self._done.get(x)
        if known is not None:
            return known
        group = self._parts.nodes.get(x)
        if group is None:
            new = x
            if x.args:
                nodes, merge = self._parts.nodes, self._merge
                new = rebuild(x, tuple([merge(a) if a.args or a in nodes else a for a in x.args]))
        else:
            those = [
                self._use(family, c)
                for family, members in group.members
                for c, block in enumerate(self._parts.blocks)
                if block & members
            ]
            if x.op is AND:
                new = conj([*map(self._merge, group.rest), *map(neg, those)])
            else:
                new = disj([*map(self._merge, group.rest), *those])
        self._done[x] = new
        return new

    def _tell(self, family: Name, block: int) -> None:
        """What is known of a block's variable."""
        members = self._parts.blocks[block]
        first = members & -members
        i = first.bit_length() - 1
        single = members == first
        x = self._use(family, block)
        said = [*self._members.telling.get((family, i), ())]
        defining = self._members.defining.get((family, i)) or ()
        if single and self._parts.whole.get(family, 0) & first:
            self._definitions[x.name] = conj(self._over(t.expr, block) for t in defining)
        else:
            said += defining
        told = self._parts.told
        self._imply([t for t in said if (t in told or not t.names) and (single or t.lifts)], block)

    def _imply(self, guarded: Iterable[GuardedClause], block: int) -> None:
        """A block's variable implies what is said of its members."""
        known = self._local.told.setdefault(block, {})
        for t in guarded:
            for f in t.families:
                self._reached[f, block] = None
            fact = known.get(t)
            if fact is None:
                fact = known[t] = implies(self._local.variables[t.family, block], self._of_block(t.expr, block))
            self._facts.append(fact)

    def _over(self, x: Expr, block: int) -> Expr:
        """An expression over families, of a block."""
        for f in self._members.families(x):
            self._reached[f, block] = None
        known = self._local.of_block.get((x, block))
        if known is None:
            known = self._local.of_block[x, block] = self._of_block(x, block)
        return known

    def _of_block(self, x: Expr, block: int) -> Expr:
        if x.args:
            return rebuild(x, tuple([self._of_block(a, block) for a in x.args]))
        return self._local.variables[x.name, block] if x.name.indexed else x

    def _one_value(self) -> None:
        """Of the values of one variable no two are taken at once."""
        some: dict[Name, Expr] = {}
        for family, block in sorted(self._reached, key=lambda k: k[1]):
            if family.form is Form.VALUE:
                x = self._use(family, block)
                before = some.get(family, FALSE)
                if before is not FALSE:
                    self._facts.append(neg(conj((x, before))))
                some[family] = disj((before, x))

    def _keep_apart(self) -> None:
        """While the variable of a route that goals speak of is true, those of other blocks are false: where that is so
        for all routes that are like it."""
        for family, of in self._local.clauses.apart.items():
            reached = [c for f, c in self._reached if f == family]
            for block, those in self._parts.alone.items():
                if block not in reached:
                    continue
                others = -1
                for i in bits_of(those):
                    others &= of.get(i, 0) | 1 << i
                false = [self._use(family, c) for c in reached if c != block and self._parts.blocks[c] & ~others == 0]
                if false:
                    self._facts.append(neg(conj((self._use(family, block), disj(false)))))


def abstraction(local: LocalAbstractions, focus: Focus, truncated: bool = False) -> LocalAbstraction:
    """What is cone of a focus; `truncated`: the cone ends at elements that the goals do not name."""
    return _Quotient(local).abstraction(focus, truncated)
