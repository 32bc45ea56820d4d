"""Words: what a controller says of a route, as a number.

A word is a list of cases, the first whose condition holds; its value is a code, or that of another word, which several
routes over one place share.  Words are computed from what one scan reads and computes, and nothing reads one: no
equation, timer or output depends on a word, so that what is proved of the controller is proved with and without them.

    0      nothing is known: no scan was run since the restart
    1      free: it would be granted if it were asked for now
    2      set, its signal at stop
    3      open: set or being passed, and its signal shows proceed
    4      being cancelled
    1001   and on: set, and waiting until machine 1, 2, ... is detected as it needs it
    10001  and on: a request is refused by condition 1, 2, ..., the first of its own that does not hold
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import field
from functools import cached_property
from typing import NamedTuple

from interlock.dataclass import dataclass
from interlock.logic.expr import TRUE, Expr, conj, disj, neg, variables
from interlock.logic.names import HOLD_OVER, HOLDS_ADDED, WHY_NOT_CLEAR, Name

UNKNOWN, FREE, SET, OPEN, CANCELLING = range(5)
SAID = {
    UNKNOWN: "not known: no scan since the restart",
    FREE: "free",
    SET: "set, its signal at stop",
    OPEN: "open",
    CANCELLING: "being cancelled",
}
WAITING = 1000
REFUSED = 10_000
LAST = 32_767  # the largest number of an INT

Value = int | Name
"""A code, or the word that has it."""


class Case(NamedTuple):
    """The value of a word while a condition holds, if none before it does."""

    condition: Expr
    value: Value


@dataclass(frozen=True)
class Word:
    """`name` has the value of the first case that holds, else `otherwise`."""

    name: Name
    cases: tuple[Case, ...]
    otherwise: Value
    group: str
    note: str

    @cached_property
    def reads(self) -> tuple[Name, ...]:
        """Variables and words that it reads, in order of appearance."""
        read = dict.fromkeys(variables(c.condition for c in self.cases))
        return (
            *read,
            *dict.fromkeys(v for v in (*(c.value for c in self.cases), self.otherwise) if isinstance(v, Name)),
        )

    def value(self, true: Callable[[Expr], bool], of: Mapping[Name, int]) -> int:
        """The code, where `true` tells what holds and `of` has the words before it."""
        found = next((c.value for c in self.cases if true(c.condition)), self.otherwise)
        return found if isinstance(found, int) else of[found]


@dataclass(frozen=True, slots=True)
class Reason:
    """What a code says: the condition of a grant (None: nothing is refused, a machine is waited for), what is said
    while it does not hold, the rule that asks for it, the elements (`s:`, `m:`, `g:`, `c:`, `z:`, `b:` and the name)
    that it is about, and the routes by number for whose additions it may be that it does not hold."""

    code: int
    condition: Expr | None
    text: str
    rule: str
    at: tuple[str, ...] = ()
    added: tuple[int, ...] = ()


@dataclass(frozen=True)
class Words:
    """All words in order, each after those that it reads; what codes say; the word of each route by its number."""

    words: tuple[Word, ...] = ()
    reasons: Mapping[int, Reason] = field(default_factory=dict)
    routes: Mapping[int, Name] = field(default_factory=dict)

    @cached_property
    def by_name(self) -> dict[Name, Word]:
        """Words by name."""
        return {w.name: w for w in self.words}

    def when(self) -> dict[Name, dict[int, Expr]]:
        """By word and code: when it is said."""
        found: dict[Name, dict[int, Expr]] = {}
        for w in self.words:
            said: dict[int, list[Expr]] = {}
            before: list[Expr] = []
            for c in (*w.cases, Case(TRUE, w.otherwise)):
                inner = {c.value: TRUE} if isinstance(c.value, int) else found[c.value]
                for code, x in inner.items():
                    said.setdefault(code, []).append(conj((*before, c.condition, x)))
                before.append(neg(c.condition))
            found[w.name] = {code: disj(xs) for code, xs in said.items()}
        return found

    def told(self, true: Callable[[Expr], bool]) -> dict[Name, int]:
        """Every word's code, where `true` tells what holds in the scan."""
        found: dict[Name, int] = {}
        for w in self.words:
            found[w.name] = w.value(true, found)
        return found

    def said(self, code: int) -> str:
        """What a code says."""
        return self.reasons[code].text if code in self.reasons else SAID.get(code, f"no word has the value {code}")

    def let_go(self, timers: Iterable[Name]) -> dict[int, tuple[tuple[Name, Name | None], ...]]:
        """By the code of a refusal, for every route for whose additions it may be: what tells that it holds them, and
        the one of these timers at whose end it holds them no longer; None where it lets go at once.  Only where one of
        them has a timer."""
        after = {t.number: t for t in timers if t.family is HOLD_OVER}
        return {
            r.code: tuple((HOLDS_ADDED(n), after.get(n)) for n in r.added)
            for r in self.reasons.values()
            if not after.keys().isdisjoint(r.added)
        }

    def failing(self, name: Name, true: Callable[[Expr], bool]) -> list[int]:
        """Every code that a word could have by the cases that hold now, in order: the first is its value."""
        found: dict[int, None] = {}
        for c in self.by_name[name].cases:
            if true(c.condition):
                codes = [c.value] if isinstance(c.value, int) else self.failing(c.value, true)
                if not isinstance(c.value, int) and c.value.family is WHY_NOT_CLEAR:
                    del codes[1:]  # what is occupied is not clear for long enough either
                found.update(dict.fromkeys(codes))
        return list(found)
