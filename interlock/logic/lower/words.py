"""The word of each route: what it does, what it waits for, why a request is refused.

Nothing is listed here: the conditions are the terms of the equations that grant a route and lock it, in their order,
and those of the wires that they read (a way is free, a section is not locked, ...), which become words of their own,
shared by all routes over the place.  A condition gets one number in the whole controller, wherever it is asked for.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import chain

from interlock.diag.called import called
from interlock.logic import names, rules
from interlock.logic.controller import Equation, Join, Term
from interlock.logic.expr import AND, FALSE, NOT, OR, TRUE, VAR, Expr, conj, disj, neg, parts_of, var, variables
from interlock.logic.lower import overlaps, ways
from interlock.logic.lower.draft import Draft
from interlock.logic.names import Family, Name, computed
from interlock.logic.sentences import RULES, SENTENCES, about, sentence
from interlock.logic.words import (
    CANCELLING,
    FREE,
    LAST,
    OPEN,
    REFUSED,
    SET,
    UNKNOWN,
    WAITING,
    Case,
    Reason,
    Value,
    Word,
    Words,
)
from interlock.model.elements import MachineId, Position, SectionId
from interlock.model.machines import other_doors
from interlock.model.times import whole_ms
from interlock.table.cells import RouteKind, authors_reason
from interlock.table.rows import RouteRow

OWN_WORD: dict[Family, Family] = {
    names.FREE: names.WHY_NOT_FREE,
    names.WAY_AVAILABLE: names.WHY_WAY_HELD,
    names.WAY_FREE: names.WHY_WAY_NOT_FREE,
    names.OVERLAP_FREE: names.WHY_OVERLAP_NOT_FREE,
}
"""Wires that are asked for by many: each has a word that tells which of its terms does not hold."""
MANY = 4
"""So many routes are named at most where a lock may be for each of them."""


class _Writer:
    """Makes words from the equations of a controller."""

    def __init__(self, d: Draft) -> None:
        self.d = d
        self.equations: dict[Name, Equation] = {e.name: e for e in d.steps if isinstance(e, Equation)}
        named = (*(i.name for i in d.inputs), *(x.name for x, _ in d.memory), *(x.name for x in d.steps))
        self.names: dict[str, Name] = {n: n for n in named}
        """Names with their fields: a node may bear the same name as it was read from a text."""
        self.number = {m: i for i, m in enumerate(d.machines.all)}
        self.words: dict[Name, Word] = {}
        self.codes: dict[tuple[object, ...], int] = {}
        self.reasons: dict[int, Reason] = {}

    # --- conditions --------------------------------------------------------------------------------

    def _code(
        self,
        condition: Expr,
        text: str,
        rule: str,
        at: tuple[str, ...],
        of: object = "",
        added: tuple[int, ...] = (),
    ) -> int:
        """The number of a condition; `of`: for whom it is asked, where that is said with it; `added`: the routes for
        whose additions it may be that it does not hold."""
        found = self.codes.get((condition, of))
        if found is None:
            found = self.codes[condition, of] = min(REFUSED + 1 + len(self.codes), LAST)
            if found == LAST:
                text, rule, at = "a condition that has no number of its own: see the equation of the grant", "", ()
                added = ()
            self.reasons.setdefault(found, Reason(found, condition, text, rule, at, added))
        return found

    def _name(self, x: Expr) -> Name:
        """The name of a variable, with its fields."""
        return self.names.get(x.name, x.name)

    def _cases(self, terms: Sequence[Term], held: MachineId | None = None) -> Iterator[Case]:
        """The terms that may fail, each with what it is called then; `held`: they hold this machine."""
        for t in terms:
            for x in conditions(t.expr):
                if x is not TRUE:
                    yield Case(fails(x), self._value(x, t, held))

    def _value(self, x: Expr, t: Term, held: MachineId | None) -> Value:
        """What a condition that does not hold is called: by a word of its own, or by its number."""
        if held is None and x.op is VAR:
            name = self._name(x)
            place = name.at
            if name.family is names.LONG_CLEAR:
                return self._not_clear(name)
            if name.family is names.POINT_AVAILABLE:
                return self._held(MachineId(str(place[0])))
            own = OWN_WORD.get(name.family)
            if own is not None and name in self.equations:
                e = self.equations[name]
                return self._word(own(*place), e, self._cases(e.terms))
        known = self.codes.get((x, held or ""))
        if known is not None:
            return known
        said = self._text(x, t, held)
        if held is None:
            return self._code(x, said, self._rule(x, t), self._at(x), added=self._added(x, t))
        if x.op is VAR and self._name(x).family is names.LONG_CLEAR:
            said = f"{called('section', str(self._name(x).at[0]))} is occupied, or not clear for long enough"
        at, added = (f"m:{held}", *self._at(x)), self._added(x, t)
        return self._code(x, f"{self._cannot_move(held)}: {said}", rules.POINTS, at, held, added)

    def _added(self, x: Expr, t: Term) -> tuple[int, ...]:
        """The routes, by number, that may hold what the author added to them so that a condition does not hold: the one
        that is named, or those that hold another door of the air lock open."""
        of = [self.names.get(y, y) for y in variables([x])]
        if x.op is NOT and of[0].family is names.HOLDS_ADDED:
            return (of[0].number,)
        if t.kind != "other doors shut":
            return ()
        doors = {
            d
            for n in of
            if n.family is names.OTHERS_SHUT
            for d in other_doors(self.d.layout.machines, MachineId(str(n.at[0])))
        }
        opened = [(r, p) for r in self.d.table.routes for p in r.locking.added if p.position is Position.REVERSE]
        return tuple(dict.fromkeys(r.number for r, p in opened if p.machine in doors))

    def _word(self, name: Name, e: Equation, cases: Iterator[Case]) -> Name:
        """A word for a place, made once: which of its conditions does not hold; UNKNOWN while all do."""
        if name not in self.words:
            self.words[name] = Word(name, tuple(cases), UNKNOWN, e.group, f"why not {e.name}")
        return name

    def _not_clear(self, name: Name) -> Value:
        """A section does not count as clear: reported occupied, its detector faulty, or clear not yet for long."""
        s = str(name.at[0])
        word = names.WHY_NOT_CLEAR(s)
        if word in self.words:
            return word
        e = self.equations[names.OCCUPIED(s)]
        wanted = [Term(neg(t.expr), t.kind, t.note, t.rule) for t in e.terms if t.expr is not neg(var(names.VALID))]
        late = self._code(var(name), self._sentence(name, False), SENTENCES[names.LONG_CLEAR].rule, about(name))
        return self._word(word, e, chain(self._cases(wanted), (Case(neg(var(name)), late),)))

    def _held(self, m: MachineId) -> Value:
        """A machine lies otherwise and may not move; that inputs are valid is asked for before it."""
        e = self.equations[names.MOVABLE(m)]
        wanted = [*(t for t in e.terms if t.expr is not var(names.VALID)), *ways.unblocked(self.d, m)]
        return self._word(names.WHY_HELD(m), e, self._cases(wanted, m))

    def _cannot_move(self, m: MachineId) -> str:
        """A machine in a sentence that may not move: points move, a crossing or bridge is worked."""
        machines = self.d.layout.machines
        return f"{machines.named(m)} cannot {'be worked' if m in machines.device else 'move'}"

    def _sentence(self, name: Name, is_true: bool) -> str:
        """What is said of a variable."""
        return sentence(name, is_true, self.d.layout.machines)

    def _text(self, x: Expr, t: Term, held: MachineId | None) -> str:
        """What is said of a condition that does not hold; `held`: what it keeps where it is."""
        inner = x.args[0] if x.op is NOT else x
        said = ""
        if inner.op is VAR:
            name = self._name(inner)
            said = self._sentence(name, x.op is NOT)
            if name.family is names.LOCK:
                return said + self._way(name)
            if name.family is names.TRAIN_LOCK:
                return said + self._until_it_stands(SectionId(str(name.at[0])))
            if name.family is names.HOLDS_ADDED:
                return self._of_added(next(r for r in self.d.table.routes if r.number == name.number), held)
        if t.kind == "zone not full":
            return f"the zone is full: {t.note}"
        return said or self._of_several(x, t) or f"it needs: {t.note or t.kind}"

    def _of_added(self, r: RouteRow, held: MachineId | None) -> str:
        """What is said of a route that holds what the author added to it: a machine, with his reason, or what he
        declares hostile; and for how many seconds longer than it would."""
        hold = r.locking.hold
        which = f"declared hostile (held {hold:g} s longer)" if hold else "declared hostile"
        if held is not None:
            asked = next(p for p in r.locking.added if p.machine == held)
            lies = self.d.layout.machines.word(held, asked.position)
            which = f"which demands {held} {lies} ({authors_reason(asked.because)})"
        return f"route {r.id}, {which}, is set or not yet cleared"

    def _of_several(self, x: Expr, t: Term) -> str:
        """What is said of an overlap that is not free, and of a crossing that is open: one of several would do."""
        parts = {y.args[0] if y.op is NOT else y: y.op is NOT for y in x.args}
        named = [(self._name(y), is_true) for y, is_true in parts.items() if y.op is VAR]
        lock = next((n for n, _ in named if n.family is names.LOCK), None)
        if t.kind == "overlap free" and lock is not None:
            return f"{self._sentence(lock, True)}, and not for a route onward {self._onward(lock)}"
        if t.kind == "rear device closed":
            return ", and ".join(self._sentence(n, is_true) for n, is_true in named)
        return ""

    def _until_it_stands(self, s: SectionId) -> str:
        """How long a berth is locked for a train, where shunting movements may come in towards it."""
        times = sorted({whole_ms(overlaps.stands_s(self.d, g)) for g in self.d.signals.met.get(s, ())})
        seconds = " or ".join(f"{ms / 1000:g}" for ms in times)
        return f", until it stands: {seconds} s after it has come in wholly" if times else ""

    def _onward(self, lock: Name) -> str:
        """Which routes may lie where an overlap is asked for: those from its signal, or from others on its way, too."""
        way = SectionId(str(lock.at[0])), int(lock.at[1])
        return "along the overlap" if way in self.d.overlaps.led_over_past else "from its signal"

    def _way(self, lock: Name) -> str:
        """Between which neighbours a section is locked, and for which routes that may be."""
        way = self.d.table.lock[SectionId(str(lock.at[0])), int(lock.at[1])]
        ends = [self.d.topo.beyond(way.section, node) or node for node in (way.entry, way.exit)]
        over = [r.id for r in self.d.routes.over.get(way.key, ())]
        routes = " or ".join(over if len(over) <= MANY else [*over[: MANY - 1], "another"])
        return f" from {ends[0]} to {ends[1]}" + (f" for route {routes}" if over else "")

    def _rule(self, x: Expr, t: Term) -> str:
        """The page of the rule that asks for a condition: that of its cell in the table, if it is from one."""
        if t.rule:
            return t.rule
        inner = x.args[0] if x.op is NOT else x
        known = SENTENCES.get(self._name(inner).family) if inner.op is VAR else None
        return known.rule if known is not None and t.kind not in RULES else RULES.get(t.kind, rules.HOSTILE_ROUTES)

    def _at(self, x: Expr) -> tuple[str, ...]:
        """The elements that a condition is about."""
        found: dict[str, None] = {}
        stack = [x]
        while stack:
            y = stack.pop()
            stack += y.args
            found.update(dict.fromkeys(about(self._name(y)) if y.op is VAR else ()))
        return tuple(sorted(found))

    # --- routes ------------------------------------------------------------------------------------

    def _waits(self, of: Equation) -> Iterator[Case]:
        """The machines that an equation asks for, itself or by ways, and that are not yet detected as it needs them."""
        for t in of.terms:
            for x in conditions(t.expr):
                e = self.equations.get(x.name) if x.op is VAR else None
                if e is not None and e.name.family is names.DETECTED:
                    yield Case(neg(x), self._waiting(MachineId(str(e.name.at[0]))))
                elif e is not None and e.join is Join.ALL:
                    yield from self._waits(e)

    def _waiting(self, m: MachineId) -> int:
        code = WAITING + 1 + self.number[m]
        self.reasons.setdefault(
            code, Reason(code, None, f"set, waiting for {self.d.layout.machines.named(m)}", rules.POINTS, (f"m:{m}",))
        )
        return code

    def _set(self, r: RouteRow) -> Name:
        """What a route does that is set, and whose signal is at stop."""
        name, group = names.WHAT_IT_DOES(r.number), f"route {r.id}"
        cancelling, locked = (var(computed(n)) for n in (names.CANCELLING(r.entry), names.LOCKED(r.number)))
        waits = dict.fromkeys(self._waits(self.equations[names.LOCKS(r.number)]))
        cases = (Case(cancelling, CANCELLING), Case(locked, SET), *waits)
        self.words[name] = Word(name, cases, SET, group, f"route {r.id}: what it does while it is set")
        return name

    def route(self, r: RouteRow) -> Name:
        """The word of a route: what it does after this scan, or why a request in this scan is refused."""
        name, active = names.STATUS(r.number), var(computed(names.ACTIVE(r.number)))
        whole = (names.SHOWING, names.PASSING) if r.signal.closing.whole is not None else (names.SHOWING,)
        shows = disj(var(computed(family(r.number))) for family in whole)
        grant = self.equations[names.GRANTED(r.number)]
        refused = self._cases([t for t in grant.terms if t.kind != "requested"])
        does = (Case(shows, OPEN), Case(active, self._set(r)))
        said = f"route {r.id}: what it does, or why it would be refused"
        alone: Value = FREE
        if r.kind is RouteKind.IDENTIFIER:
            with_ = " or ".join(x.id for x in self.d.routes.leading_past(r))
            alone = self._code(
                FALSE, f"it is set with route {with_}, never alone", rules.SIGNALS, (f"g:{r.entry}",), r.id
            )
        self.words[name] = Word(name, (*does, *refused), alone, f"route {r.id}", said)
        return name


def conditions(x: Expr) -> Iterator[Expr]:
    """The parts of a term that must all hold."""
    parts = parts_of(x)
    if not parts:
        yield x
    for y in parts:
        yield from conditions(y)


def fails(x: Expr) -> Expr:
    """That a condition does not hold, said of its parts: NOT before a parenthesis in which NOT stands is hard to read,
    and STruC++ makes C++ of it that g++ refuses (`bool | bool` is an int there, and its NOT takes none)."""
    if x.op is OR:
        return conj(fails(y) for y in x.args)
    if x.op is AND:
        return disj(fails(y) for y in x.args)
    return neg(x)


def words(d: Draft) -> Words:
    """The words of a controller that is otherwise complete."""
    w = _Writer(d)
    routes = {r.number: w.route(r) for r in d.table.routes}
    assert all(c.condition is not FALSE for word in w.words.values() for c in word.cases)
    return Words(tuple(w.words.values()), dict(sorted(w.reasons.items())), routes)
