"""The making of one view: names and facts that are near, routes that a place cannot tell apart, what is known of them.

See `views.py`.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from itertools import chain

from interlock.logic.expr import AND, FALSE, NOT, TRUE, Expr, conj, disj, implies, neg, rebuild, var
from interlock.logic.names import Form, Name, Owner, of_class
from interlock.model.bits import bits, bits_of
from interlock.proof.members import Kind, Member, Trait
from interlock.proof.views import Group, Scene, View, Views

_DEFINED = Kind.DEFINED


def _at(where: Mapping[Name, Sequence[int]], names: Iterable[Name]) -> dict[int, None]:
    """The numbers that stand at some names."""
    return dict.fromkeys(chain.from_iterable(filter(None, map(where.get, names))))


def _variable(family: Name, crowd: int) -> Expr:
    return var(of_class(family, crowd))


def _of_crowd(x: Expr, crowd: int) -> Expr:
    if x.args:
        return rebuild(x, tuple(_of_crowd(a, crowd) for a in x.args))
    return _variable(x.name, crowd) if x.name.indexed else x


class _Sight:
    """The making of one view."""

    def __init__(self, views: Views, scene: Scene, narrow: bool) -> None:
        self.views = views
        self.narrow = narrow
        self.members = views.members
        self.scene = scene
        self.seen: dict[Name, None] = {}
        """The names that are seen."""
        self.families: dict[Name, None] = {}
        self.near: dict[Owner, None] = dict.fromkeys(scene.homes)
        self.crowds: list[int] = []
        """The crowds' members, as bits."""
        self.alone: dict[int, int] = {}
        """Crowds of one member that goals speak of, and all members that are like it: the rest is the crowd after."""
        self.traits: dict[Name, list[Trait]] = {}
        """The traits that the view can tell, by their family."""
        self.whole: dict[Name, int] = {}
        """By family the members of which the view can tell the definition, all of it."""
        self.definitions: dict[Name, Expr] = {}
        self.facts: list[Expr] = []
        self.reached: dict[Member, None] = {}
        self.nodes: dict[Expr, Group] = {}
        self.done: dict[Expr, Expr] = {}

    # --- which names ---------------------------------------------------------------------------

    def look(self) -> None:
        """Find the names near the goals."""
        m, homes = self.members, self.views.homes
        names: dict[Name, None] = {}
        families: dict[Name, None] = {}
        for _, x in self.scene.whole:
            names |= dict.fromkeys(m.read(x)[0])
            families |= dict.fromkeys(self.views.families_in(x))
        for x, _ in self.scene.pieces:
            for v in m.read(x)[0]:
                if v.indexed:
                    families[v] = None
                else:
                    names[v] = None
        self.near |= dict.fromkeys(homes[v] for v in names if v in homes)
        self.reach(names, families, self.near)

    def reach(self, names: Iterable[Name], families: Iterable[Name], near: Iterable[Owner]) -> None:
        """See names, what they mean, and what families of which they speak say of the elements that are near; a narrow
        view does not see why something is as it is at an element that is not near."""
        todo, fresh, leads = list(names), list(families), self.views.leads
        far, near_by = self.views.homes if self.narrow else {}, self.near
        while todo or fresh:
            while fresh:
                f = fresh.pop()
                if f not in self.families:
                    self.families[f] = None
                    fresh.extend(self.views.families.get(f, ()))
                    for h in near:
                        todo.extend(self.views.names_at.get((f, h), ()))
            while todo:
                v = todo.pop()
                if v not in self.seen:
                    self.seen[v] = None
                    if v in leads and (v not in far or far[v] in near_by):
                        reads, speaks_of = leads[v]
                        todo += reads
                        fresh += speaks_of

    # --- which facts ---------------------------------------------------------------------------

    def around(self) -> dict[int, None]:
        """Facts that speak of the names."""
        return _at(self.views.facts_at, self.seen)

    def deepen(self, facts: Iterable[int]) -> None:
        """See what names mean that stand in facts of which the view sees all else."""
        homes, next_to, names_of = self.views.homes, self.views.next_to, self.views.names_of
        near = set(map(homes.get, self.seen)) - {None}
        seen, states = set(self.seen), self.views.state_homes
        for n in facts:
            names = names_of[n]
            if not seen.issuperset(names):
                for v in next_to[n]:
                    if v not in self.seen and states.get(v) not in near:
                        break
                else:
                    self.reach(names, (), ())

    def collect(self) -> tuple[list[Expr], list[Expr]]:
        """The facts of places, and those of several members."""
        m = self.members
        found = self.around()
        self.deepen(found)
        seen = set(self.seen)
        names_of = self.views.names_of
        found |= _at(self.views.alone_at, self.seen)
        told = [m.plain[n][0] for n in found if seen.issuperset(names_of[n])]
        wide, mixed = _at(self.views.wide_at, self.seen), _at(self.views.mixed_at, self.seen)
        parts = [x for n in wide if (x := self.said(m.plain[n][0], True)) is not TRUE]
        return [*told, *parts], [m.mixed[n][0] for n in mixed]

    def said(self, x: Expr, side: bool) -> Expr:
        """What a fact says of the names that are seen."""
        if x.op is NOT:
            return neg(self.said(x.args[0], not side))
        if not x.args:
            return x if x.name in self.seen else (TRUE if side else FALSE)
        return rebuild(x, tuple(self.said(a, side) for a in x.args))

    # --- crowds --------------------------------------------------------------------------------

    def part(self, kept: Iterable[Expr]) -> None:
        """Sort the members that are read into crowds."""
        marks: list[int] = []
        for x in kept:
            for group in self.views.groups(x):
                if group.node not in self.nodes:
                    self.nodes[group.node] = group
                    marks += [members for _, members in group.members]
        spoken = 0
        for _, by in self.scene.pieces:
            some = bits(by)
            marks.append(some)
            spoken |= some
        every = 0
        for some in marks:
            every |= some
        told = set(self.telling())
        fulls = list(self.views.full_at.get(None, ()))
        fulls += [f for t in told for f in self.views.full_at.get(t, ()) if told.issuperset(f.named)]
        for f in fulls:
            self.whole[f.family] = self.whole.get(f.family, 0) | f.members
        traits = [t.members for those in self.traits.values() for t in those]
        classes = [every] if every else []
        cuts = dict.fromkeys(
            [some & every for some in (*marks, *traits, *self.views.bare, *(f.members for f in fulls))]
        )
        for some in cuts:
            if any(0 != c & some != c for c in classes):
                classes = [part for c in classes for part in (c & some, c & ~some) if part]
        for members in classes:
            if members & spoken:
                first = members & -members
                self.alone[len(self.crowds)] = members
                self.crowds += [first, members ^ first]
            else:
                self.crowds.append(members)

    def telling(self) -> list[Trait]:
        """The traits of which all names are seen; kept by family.  Of what is not near, a narrow view tells none."""
        hits = Counter(chain.from_iterable(filter(None, map(self.views.traits_at.get, self.seen))))
        found = [t for t, n in hits.items() if n == len(t.names)]
        if self.narrow:
            homes = self.views.homes_of
            found = [t for t in found if t not in homes or not homes[t].isdisjoint(self.near)]
        for t in found:
            self.traits.setdefault(t.family, []).append(t)
        return found

    # --- the small system ----------------------------------------------------------------------

    def variable(self, family: Name, crowd: int) -> Expr:
        """The variable of a crowd."""
        self.reached[family, crowd] = None
        return _variable(family, crowd)

    def merged(self, root: Expr) -> Expr:
        """An expression over crowds instead of members."""
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
                for c, crowd in enumerate(self.crowds)
                if crowd & members
            ]
            if x.op is AND:
                new = conj([*map(self._merge, group.rest), *map(neg, those)])
            else:
                new = disj([*map(self._merge, group.rest), *those])
        self.done[x] = new
        return new

    def tell(self, family: Name, crowd: int) -> None:
        """What is known of a crowd's variable."""
        members = self.crowds[crowd]
        first = members & -members
        i = first.bit_length() - 1
        single = members == first
        x = self.variable(family, crowd)
        mine = [t for t in self.traits.get(family, ()) if t.members & first]
        defining = self.members.defining.get((family, i)) or []
        if self.whole.get(family, 0) & first and (single or self.spread(defining, i)):
            self.definitions[x.name] = conj(self.of_crowd(t.expr, crowd) for t in defining)
        else:
            told = set(mine)
            self.imply([t for t in defining if (t in told or not t.names) and (single or t.lifts)], crowd)
        facts = [t for t in self.members.telling.get((family, i), ()) if not t.names]
        facts += [t for t in mine if t.kind is not _DEFINED]
        self.imply([t for t in facts if single or t.lifts], crowd)

    def spread(self, defining: Sequence[Trait], i: int) -> bool:
        """The definition of a member is that of its crowd too: one trait of it differs from member to member at most,
        and that one is a disjunction."""
        varying = [t for t in defining if not all(self.common(f, i) for f in t.families)]
        return all(t.spreads for t in defining) and len(varying) <= 1

    def common(self, family: Name, i: int) -> bool:
        """The family is defined, and the same for all members of a crowd."""
        defining = self.members.defining.get((family, i))
        return bool(self.whole.get(family, 0) >> i & 1) and not any(t.families for t in defining or ())

    def imply(self, traits: Iterable[Trait], crowd: int) -> None:
        """A crowd's variable implies what is said of its members."""
        known = self.views.told.setdefault(crowd, {})
        for t in traits:
            for f in t.families:
                self.reached[f, crowd] = None
            fact = known.get(t)
            if fact is None:
                fact = known[t] = implies(_variable(t.family, crowd), _of_crowd(t.expr, crowd))
            self.facts.append(fact)

    def of_crowd(self, x: Expr, crowd: int) -> Expr:
        """An expression over families, of a crowd."""
        for f in self.members.families(x):
            self.reached[f, crowd] = None
        known = self.views.of_crowd.get((x, crowd))
        if known is None:
            known = self.views.of_crowd[x, crowd] = _of_crowd(x, crowd)
        return known

    def view(self) -> View:
        """All of it."""
        self.look()
        facts, mixed = self.collect()
        meaning = self.members.meaning
        defined = {v: meaning[v] for v in self.seen if v in meaning}
        self.part([*(x for _, x in self.scene.whole), *defined.values(), *mixed])
        asked: list[tuple[Expr, tuple[int, ...]]] = [(self.merged(x), (n,)) for n, x in self.scene.whole]
        for x, numbers in self.scene.pieces:
            for crowd, those in self.alone.items():
                if (those & -those).bit_length() - 1 in numbers:
                    goals = {n: None for i in bits_of(those) for n in numbers[i]}
                    asked.append((self.of_crowd(x, crowd), tuple(goals)))
        self.definitions |= {v: self.merged(x) for v, x in defined.items()}
        self.facts += [*facts, *map(self.merged, mixed)]
        told: set[Member] = set()
        while len(told) < len(self.reached):
            for key in [k for k in self.reached if k not in told]:
                told.add(key)
                if key[0].form is Form.VALUE:
                    continue
                self.tell(*key)
        self.one_value()
        self.keep_apart()
        return View(self.definitions, self.facts, asked, self.crowds)

    def one_value(self) -> None:
        """Of the values of one variable no two are taken at once."""
        some: dict[Name, Expr] = {}
        for family, crowd in sorted(self.reached, key=lambda k: k[1]):
            if family.form is Form.VALUE:
                x = self.variable(family, crowd)
                before = some.get(family, FALSE)
                if before is not FALSE:
                    self.facts.append(neg(conj((x, before))))
                some[family] = disj((before, x))

    def keep_apart(self) -> None:
        """While the variable of a route that goals speak of is true, those of other crowds are false: where that is so
        for all routes that are like it."""
        for family, of in self.views.apart.items():
            reached = [c for f, c in self.reached if f == family]
            for crowd, those in self.alone.items():
                if crowd not in reached:
                    continue
                others = -1
                for i in bits_of(those):
                    others &= of.get(i, 0) | 1 << i
                false = [self.variable(family, c) for c in reached if c != crowd and self.crowds[c] & ~others == 0]
                if false:
                    self.facts.append(neg(conj((self.variable(family, crowd), disj(false)))))


def view(views: Views, scene: Scene, narrow: bool = False) -> View:
    """What is seen of a scene; `narrow`: of the elements that the goals name, and of others only how they are."""
    return _Sight(views, scene, narrow).view()
