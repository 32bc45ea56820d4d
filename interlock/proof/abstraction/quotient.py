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

from interlock.logic.expr import AND, FALSE, Expr, conj, disj, implies, neg, rebuild, var
from interlock.logic.names import Form, Name, Owner, of_block
from interlock.model.bits import bits, bits_of
from interlock.proof.abstraction.indexed import GuardedClause, IndexedVariable, Kind
from interlock.proof.abstraction.local import Focus, LocalAbstraction, LocalAbstractions, Occurrences

_DEFINED = Kind.DEFINED


def _at(where: Mapping[Name, Sequence[int]], names: Iterable[Name]) -> dict[int, None]:
    """The numbers that stand at some names."""
    return dict.fromkeys(chain.from_iterable(filter(None, map(where.get, names))))


def _variable(family: Name, block: int) -> Expr:
    return var(of_block(family, block))


def _of_block(x: Expr, block: int) -> Expr:
    if x.args:
        return rebuild(x, tuple(_of_block(a, block) for a in x.args))
    return _variable(x.name, block) if x.name.indexed else x


class _Quotient:
    """The making of one abstraction."""

    def __init__(self, local: LocalAbstractions, focus: Focus, truncated: bool) -> None:
        self.local = local
        self.truncated = truncated
        self.members = local.members
        self.focus = focus
        self.cone: dict[Name, None] = {}
        """The names in the cone of influence."""
        self.families: dict[Name, None] = {}
        self.near: dict[Owner, None] = dict.fromkeys(focus.homes)
        self.blocks: list[int] = []
        """The blocks' members, as bits."""
        self.alone: dict[int, int] = {}
        """Blocks of one member that goals speak of, and all members that are like it: the rest is the block after."""
        self.guarded: dict[Name, list[GuardedClause]] = {}
        """The guarded clauses of which the abstraction has all names, by their family."""
        self.whole: dict[Name, int] = {}
        """By family the members of which the abstraction can tell the definition, all of it."""
        self.definitions: dict[Name, Expr] = {}
        self.facts: list[Expr] = []
        self.reached: dict[IndexedVariable, None] = {}
        self.nodes: dict[Expr, Occurrences] = {}
        self.done: dict[Expr, Expr] = {}

    # --- which names ---------------------------------------------------------------------------

    def grow(self) -> None:
        """Find the names near the goals."""
        m, homes = self.members, self.local.homes
        names: dict[Name, None] = {}
        families: dict[Name, None] = {}
        for _, x in self.focus.whole:
            names |= dict.fromkeys(m.read(x)[0])
            families |= dict.fromkeys(self.local.families_in(x))
        for x, _ in self.focus.pieces:
            for v in m.read(x)[0]:
                if v.indexed:
                    families[v] = None
                else:
                    names[v] = None
        self.near |= dict.fromkeys(homes[v] for v in names if v in homes)
        self.reach(names, families, self.near)

    def reach(self, names: Iterable[Name], families: Iterable[Name], near: Iterable[Owner]) -> None:
        """Add names to the cone, what they mean, and what families of which they speak say of what is near.

        A truncated cone has no reasons for what is at an element that is not near.
        """
        todo, fresh, leads = list(names), list(families), self.local.leads
        far, near_by = self.local.homes if self.truncated else {}, self.near
        while todo or fresh:
            while fresh:
                f = fresh.pop()
                if f not in self.families:
                    self.families[f] = None
                    fresh.extend(self.local.families.get(f, ()))
                    for h in near:
                        todo.extend(self.local.names_at.get((f, h), ()))
            while todo:
                v = todo.pop()
                if v not in self.cone:
                    self.cone[v] = None
                    if v in leads and (v not in far or far[v] in near_by):
                        reads, speaks_of = leads[v]
                        todo += reads
                        fresh += speaks_of

    # --- which facts ---------------------------------------------------------------------------

    def around(self) -> dict[int, None]:
        """Facts that speak of the names."""
        return _at(self.local.facts_at, self.cone)

    def deepen(self, facts: Iterable[int]) -> None:
        """See what names mean that stand in facts of which the abstraction sees all else."""
        homes, next_to, names_of = self.local.homes, self.local.next_to, self.local.names_of
        near = set(map(homes.get, self.cone)) - {None}
        cone, states = set(self.cone), self.local.state_homes
        for n in facts:
            names = names_of[n]
            if not cone.issuperset(names):
                for v in next_to[n]:
                    if v not in self.cone and states.get(v) not in near:
                        break
                else:
                    self.reach(names, (), ())

    def collect(self) -> tuple[list[Expr], list[Expr]]:
        """The facts of places, and those of several members."""
        m = self.members
        found = self.around()
        self.deepen(found)
        cone = set(self.cone)
        names_of = self.local.names_of
        found |= _at(self.local.alone_at, self.cone)
        told = [m.plain[n][0] for n in found if cone.issuperset(names_of[n])]
        return told, [m.mixed[n][0] for n in _at(self.local.mixed_at, self.cone)]

    # --- blocks --------------------------------------------------------------------------------

    def refine(self, kept: Iterable[Expr]) -> None:
        """Sort the members that are read into blocks."""
        marks: list[int] = []
        for x in kept:
            for group in self.local.groups(x):
                if group.node not in self.nodes:
                    self.nodes[group.node] = group
                    marks += [members for _, members in group.members]
        spoken = 0
        for _, by in self.focus.pieces:
            some = bits(by)
            marks.append(some)
            spoken |= some
        every = 0
        for some in marks:
            every |= some
        told = set(self.telling())
        fulls = list(self.local.full_at.get(None, ()))
        fulls += [f for t in told for f in self.local.full_at.get(t, ()) if told.issuperset(f.named)]
        for f in fulls:
            self.whole[f.family] = self.whole.get(f.family, 0) | f.members
        guarded = [t.members for those in self.guarded.values() for t in those]
        classes = [every] if every else []
        cuts = dict.fromkeys(
            [some & every for some in (*marks, *guarded, *self.local.bare, *(f.members for f in fulls))]
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

    def telling(self) -> list[GuardedClause]:
        """The guarded clauses of which all names are in the cone; kept by family.

        Of what is not near, a truncated cone has none.
        """
        hits = Counter(chain.from_iterable(filter(None, map(self.local.guarded_at.get, self.cone))))
        found = [t for t, n in hits.items() if n == len(t.names)]
        if self.truncated:
            homes = self.local.homes_of
            found = [t for t in found if t not in homes or not homes[t].isdisjoint(self.near)]
        for t in found:
            self.guarded.setdefault(t.family, []).append(t)
        return found

    # --- the small system ----------------------------------------------------------------------

    def variable(self, family: Name, block: int) -> Expr:
        """The variable of a block."""
        self.reached[family, block] = None
        return _variable(family, block)

    def merged(self, root: Expr) -> Expr:
        """An expression over blocks instead of members."""
        return self._merge(root) if self.members.read(root)[1] else root

    def _merge(self, x: Expr) -> Expr:
        known = self.done.get(x)
        if known is not None:
            return known
        group = self.nodes.get(x)
        if group is None:
            new = x
            if x.args:
                nodes, merge = self.nodes, self._merge
                new = rebuild(x, tuple([merge(a) if a.args or a in nodes else a for a in x.args]))
        else:
            those = [
                self.variable(family, c)
                for family, members in group.members
                for c, block in enumerate(self.blocks)
                if block & members
            ]
            if x.op is AND:
                new = conj([*map(self._merge, group.rest), *map(neg, those)])
            else:
                new = disj([*map(self._merge, group.rest), *those])
        self.done[x] = new
        return new

    def tell(self, family: Name, block: int) -> None:
        """What is known of a block's variable."""
        members = self.blocks[block]
        first = members & -members
        i = first.bit_length() - 1
        single = members == first
        x = self.variable(family, block)
        mine = [t for t in self.guarded.get(family, ()) if t.members & first]
        defining = self.members.defining.get((family, i)) or []
        if single and self.whole.get(family, 0) & first:
            self.definitions[x.name] = conj(self.of_block(t.expr, block) for t in defining)
        else:
            told = set(mine)
            self.imply([t for t in defining if (t in told or not t.names) and (single or t.lifts)], block)
        facts = [t for t in self.members.telling.get((family, i), ()) if not t.names]
        facts += [t for t in mine if t.kind is not _DEFINED]
        self.imply([t for t in facts if single or t.lifts], block)

    def imply(self, guarded: Iterable[GuardedClause], block: int) -> None:
        """A block's variable implies what is said of its members."""
        known = self.local.told.setdefault(block, {})
        for t in guarded:
            for f in t.families:
                self.reached[f, block] = None
            fact = known.get(t)
            if fact is None:
                fact = known[t] = implies(_variable(t.family, block), _of_block(t.expr, block))
            self.facts.append(fact)

    def of_block(self, x: Expr, block: int) -> Expr:
        """An expression over families, of a block."""
        for f in self.members.families(x):
            self.reached[f, block] = None
        known = self.local.of_block.get((x, block))
        if known is None:
            known = self.local.of_block[x, block] = _of_block(x, block)
        return known

    def abstraction(self) -> LocalAbstraction:
        """All of it."""
        self.grow()
        facts, mixed = self.collect()
        meaning = self.members.meaning
        defined = {v: meaning[v] for v in self.cone if v in meaning}
        self.refine([*(x for _, x in self.focus.whole), *defined.values(), *mixed])
        asked: list[tuple[Expr, tuple[int, ...]]] = [(self.merged(x), (n,)) for n, x in self.focus.whole]
        for x, numbers in self.focus.pieces:
            for block, those in self.alone.items():
                if (those & -those).bit_length() - 1 in numbers:
                    goals = {n: None for i in bits_of(those) for n in numbers[i]}
                    asked.append((self.of_block(x, block), tuple(goals)))
        self.definitions |= {v: self.merged(x) for v, x in defined.items()}
        self.facts += [*facts, *map(self.merged, mixed)]
        told: set[IndexedVariable] = set()
        while len(told) < len(self.reached):
            for key in [k for k in self.reached if k not in told]:
                told.add(key)
                if key[0].form is Form.VALUE:
                    continue
                self.tell(*key)
        self.one_value()
        self.keep_apart()
        return LocalAbstraction(self.definitions, self.facts, asked, self.blocks)

    def one_value(self) -> None:
        """Of the values of one variable no two are taken at once."""
        some: dict[Name, Expr] = {}
        for family, block in sorted(self.reached, key=lambda k: k[1]):
            if family.form is Form.VALUE:
                x = self.variable(family, block)
                before = some.get(family, FALSE)
                if before is not FALSE:
                    self.facts.append(neg(conj((x, before))))
                some[family] = disj((before, x))

    def keep_apart(self) -> None:
        """While the variable of a route that goals speak of is true, those of other blocks are false: where that is so
        for all routes that are like it."""
        for family, of in self.local.apart.items():
            reached = [c for f, c in self.reached if f == family]
            for block, those in self.alone.items():
                if block not in reached:
                    continue
                others = -1
                for i in bits_of(those):
                    others &= of.get(i, 0) | 1 << i
                false = [self.variable(family, c) for c in reached if c != block and self.blocks[c] & ~others == 0]
                if false:
                    self.facts.append(neg(conj((self.variable(family, block), disj(false)))))


def abstraction(local: LocalAbstractions, focus: Focus, truncated: bool = False) -> LocalAbstraction:
    """What is cone of a focus; `truncated`: the cone ends at elements that the goals do not name."""
    return _Quotient(local, focus, truncated).abstraction()
