"""Why a route that is set has its signal at stop, and what is to be done, told from inputs and memory alone.

The conditions of proceed (R3, R4, R11 to R13, R16) are followed through the wires of which all terms must hold, down to
what was read; what is one of several (which overlap lies) is not followed, and nothing is told of it.  A signal that
nobody wants open any more is asked for again (R14).  Neither panel nor runtime has sentences of its own for it.
"""

from __future__ import annotations

from collections.abc import Iterator

from interlock.dataclass import dataclass
from interlock.logic import names, rules
from interlock.logic.controller import Controller, Equation, Input, Join, Step, Term, Timer
from interlock.logic.expr import AND, NOT, OR, TRUE, VAR, Expr
from interlock.logic.names import Name
from interlock.logic.sentences import SENTENCES, sentence
from interlock.logic.symbols import RouteSymbols
from interlock.logic.words import WAITING

LOST = "inputs were lost while it was set: cancel it, and set it again"
_OWN = ("active", "locked", "wanted", "conditions", "stays", "not cancelling", "not cancelled")
"""Terms of the proceed that are told otherwise: by the words, or by what follows here."""

_CONTACTS = (names.CONTACT, names.DETECTED)


@dataclass(frozen=True, slots=True)
class Cause:
    """A condition that does not hold while none of some variables is as it should; what is said then, and the rule."""

    wanted: tuple[tuple[Name, bool], ...]
    text: str
    rule: str


@dataclass(frozen=True, slots=True)
class AtStop:
    """The causes of one route, in the order in which they are told; `asked`: whether it is to be asked for again where
    nobody wants its signal open (`been` open, or not yet)."""

    causes: tuple[Cause, ...]
    active: Name
    """It was set before the scan: in that in which it is set nothing is at stop yet."""
    wants: Name
    shown: Name
    been: Cause
    hindered: Cause


def again(been: bool, call_on: bool) -> str:
    """What is said of a signal that nobody wants open: it was open, or something came in its way before."""
    hindered = "its way was blocked, a point in it trailed, or inputs were lost: it"
    hindered = hindered if call_on else "its way was blocked, or a point in it trailed: it"
    how = "once it is cancelled and set again" if call_on else "when it is asked for again"
    return f"{'it has closed once, and' if been else hindered} opens only {how}"


def at_stop(c: Controller) -> dict[int, AtStop]:
    """By the number of each route that can be set and opened alone: of one that leads past a signal, and of what lies
    past that, more has to be known."""
    finder, found = _Causes(c), {}
    for r in c.symbols.routes:
        if r.path.onward is None and not r.path.identifier:
            been, not_yet = (Cause((), again(x, r.call_on), rules.ONE_TRAIN_ONE_ROUTE) for x in (True, False))
            found[r.number] = AtStop(finder.of(r), r.active, r.want, r.shown, been, not_yet)
    return found


class _Causes:
    """Follows the conditions of proceed of one controller."""

    def __init__(self, c: Controller) -> None:
        self.steps: dict[str, Step] = {s.name: s for s in c.steps}
        self.read: dict[str, Input] = {i.name: i for i in c.inputs}
        named = (*(s.name for s in c.state), *(s.name for s in c.steps), *(i.name for i in c.inputs))
        self.names: dict[str, Name] = {n: n for n in named}
        self.kept: set[str] = {s.name for s in c.state}
        self.reasons = {r.condition: r for r in c.words.reasons.values() if r.condition is not None}
        self.waits = {r.at: r for r in c.words.reasons.values() if r.code // WAITING == 1}

    def of(self, r: RouteSymbols) -> tuple[Cause, ...]:
        """The causes of a route: whatever lies with others, before what is asked of those who work here."""
        found: dict[Cause, None] = {}
        for wire in (names.CONDITIONS(r.number), names.OPENS(r.number)):
            e = self.steps[wire]
            assert isinstance(e, Equation)
            for t in e.terms:
                if t.kind not in _OWN:
                    found.update(dict.fromkeys(self._of(t.expr, t)))
        return tuple(sorted(found, key=lambda x: x.text == LOST))

    def _of(self, x: Expr, t: Term) -> Iterator[Cause]:
        """The causes by which an expression does not hold that stands in a term."""
        if x.op is AND:
            for y in x.args:
                yield from self._of(y, t)
        elif x.op is VAR and x.name in self.steps:
            yield from self._wire(self.names[x.name], t)
        elif x is not TRUE:
            yield from self._leaf(x, t)

    def _wire(self, name: Name, t: Term) -> Iterator[Cause]:
        """The causes by which what is computed in the scan does not hold."""
        step = self.steps[name]
        if name.family is names.LONG_CLEAR:
            for family in (names.CLEAR, names.HEALTHY):
                if family(name.at[0]) in self.read:
                    yield self._said(family(name.at[0]), True)
            yield self._said(name, True)
        elif isinstance(step, Equation) and step.join is Join.ALL:
            for own in step.terms:
                yield from self._of(own.expr, own)

    def _leaf(self, x: Expr, t: Term) -> Iterator[Cause]:
        """A variable, or several of which one would do; nothing where one is computed otherwise."""
        parts = x.args if x.op is OR else (x,)
        plain = [(y.args[0] if y.op is NOT else y, y.op is not NOT) for y in parts]
        if not all(y.op is VAR and self._known(y.name) for y, _ in plain):
            return
        wanted = tuple((self.names[y.name], on) for y, on in plain)
        known = self.reasons.get(x)
        name, on = wanted[0]
        if t.kind == "inputs never lost":
            yield Cause(wanted, LOST, rules.RESTART)
        elif len(wanted) == 1 and name.family is names.TOKEN_HERE:
            yield from _direction(name)
        elif len(wanted) == 1 and name.family in _CONTACTS and (f"m:{name.at[0]}",) in self.waits:
            waits = self.waits[f"m:{name.at[0]}",]
            yield Cause(wanted, waits.text.removeprefix("set, "), waits.rule)
        elif len(wanted) == 1 and name.family in SENTENCES and name.family not in (*_CONTACTS, names.TRAILED):
            yield self._said(name, on, t.rule)
        elif known is not None:
            yield Cause(wanted, known.text, t.rule or known.rule)
        else:
            yield Cause(wanted, f"it needs: {t.note or t.kind}", t.rule)

    def _known(self, name: str) -> bool:
        return name in self.read or name in self.kept or isinstance(self.steps.get(name), Timer)

    @staticmethod
    def _said(name: Name, on: bool, rule: str = "") -> Cause:
        return Cause(((name, on),), sentence(name, not on), rule or SENTENCES[name.family].rule)


def _direction(here: Name) -> Iterator[Cause]:
    """The direction of a line is not ours: the neighbour has it, or, as after a restart, nobody tells that he has."""
    line = here.at[0]
    theirs, said = names.NEIGHBOUR_HAS(line), sentence(here, False)
    wait = f"{said}: the neighbour has it, wait until he gives it"
    yield Cause(((here, True), (theirs, False)), wait, rules.LINE_BEYOND)
    by_hand = f"special manual change (hold {names.TAKE_BY_HAND(line)})"
    text = f"{said}, and the neighbour does not have it: after a restart agree with him, then {by_hand}"
    yield Cause(((here, True), (theirs, True)), text, rules.LINE_BEYOND)
