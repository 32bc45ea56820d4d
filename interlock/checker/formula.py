"""Formulas in one form, so that what differs in order, nesting or De Morgan's rule alone is equal.

A formula is TRUE, FALSE, `("v", name)`, `("!", formula)`, or `("&", frozenset of formulas)`; a disjunction is the
negation of a conjunction of negations.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from functools import lru_cache
from typing import Any

from interlock.verify import Rejected, need

Formula = tuple[Any, ...]
TRUE: Formula = ("T",)
FALSE: Formula = ("F",)


def leaf(name: str) -> Formula:
    """A variable."""
    return ("v", name)


def spaced(name: str) -> str:
    """A name as the layout has it: a written system has one word for it, with a sign of its own for a space."""
    return name.replace("\u2423", " ")


def no(x: Formula) -> Formula:
    """NOT."""
    return FALSE if x == TRUE else TRUE if x == FALSE else x[1] if x[0] == "!" else ("!", x)


def every(xs: Iterable[Formula]) -> Formula:
    """AND: flat, without order or repetition, FALSE when two operands contradict each other."""
    flat: set[Formula] = set()
    for x in xs:
        if x == FALSE:
            return FALSE
        if x[0] == "&":
            flat |= x[1]
        elif x != TRUE:
            flat.add(x)
    if any(x[0] == "!" and x[1] in flat for x in flat):
        return FALSE
    return TRUE if not flat else next(iter(flat)) if len(flat) == 1 else ("&", frozenset(flat))


def some(xs: Iterable[Formula]) -> Formula:
    """OR."""
    return no(every(no(x) for x in xs))


def implies(a: Formula, b: Formula) -> Formula:
    """If a, then b."""
    return some((no(a), b))


def same(a: Formula, b: Formula) -> Formula:
    """Both or neither."""
    return every((implies(a, b), implies(b, a)))


def one_at_most(xs: Iterable[Formula]) -> Formula:
    """No two of them."""
    those = list(xs)
    return every(no(every((a, b))) for i, a in enumerate(those) for b in those[i + 1 :])


CLAUSES = 4000
"""A formula with more clauses is compared as it stands."""


def clauses(x: Formula) -> frozenset[frozenset[Formula]]:
    """The same as a conjunction of disjunctions, none of which follows from another alone.

    So two formulas that say the same in another order, nesting or distribution have the same clauses.  An operand that
    would make too many stays whole.
    """
    found = _clauses(x, True)
    return frozenset({frozenset({x})}) if found is None else found


@lru_cache(1 << 18)
def _clauses(x: Formula, sign: bool) -> frozenset[frozenset[Formula]] | None:
    if x[0] == "!":
        return _clauses(x[1], not sign)
    if x[0] != "&":
        return frozenset() if (x == TRUE) is sign and x[0] != "v" else _one(x, sign)
    if sign:
        return _shortest(frozenset().union(*(clauses(y) for y in x[1])))
    made: frozenset[frozenset[Formula]] = frozenset({frozenset()})
    parts = [_clauses(y, False) for y in x[1]]
    for those in sorted(parts, key=lambda p: CLAUSES if p is None else len(p)):
        if those is None or len(made) * len(those) > CLAUSES:
            return None
        joined = (a | b for a in made for b in those)
        made = _shortest(frozenset(c for c in joined if not any(no(y) in c for y in c)))
    return made


def _one(x: Formula, sign: bool) -> frozenset[frozenset[Formula]]:
    return frozenset({frozenset() if x[0] in "TF" else frozenset({x if sign else no(x)})})


def _shortest(those: frozenset[frozenset[Formula]]) -> frozenset[frozenset[Formula]]:
    """Without clauses that contain another one."""
    kept: list[frozenset[Formula]] = []
    shorter = 0  # how many of these are shorter than the clause at hand: only they can be part of it
    for c in sorted(those, key=len):
        while shorter < len(kept) and len(kept[shorter]) < len(c):
            shorter += 1
        if not any(k <= c for k in kept[:shorter]):
            kept.append(c)
    return frozenset(kept)


def names(x: Formula) -> Iterator[str]:
    """The variables of a formula, with repetition."""
    if x[0] == "v":
        yield x[1]
    elif x[0] == "!":
        yield from names(x[1])
    elif x[0] == "&":
        for y in x[1]:
            yield from names(y)


def value(x: Formula, known: dict[str, bool]) -> bool | None:
    """What a formula comes out as, if what is known settles it."""
    if x[0] == "v":
        return known.get(x[1])
    if x[0] == "!":
        inner = value(x[1], known)
        return None if inner is None else not inner
    if x[0] == "&":
        found = [value(y, known) for y in x[1]]
        return False if False in found else None if None in found else True
    return bool(x == TRUE)


@lru_cache(1 << 18)
def read(text: str) -> Formula:
    """A formula as the written system has it: `a`, `!a`, `(& a b)`, `(| a b)`, `T`, `F`."""
    stack: list[tuple[str, bool, list[Formula]]] = [("", False, [])]
    for word in text.replace("(", " ( ").replace(")", " ) ").replace("! ", "!").split():
        if word in ("(", "!("):
            stack.append(("", word == "!(", []))
        elif word in ("&", "|") and len(stack) > 1 and not stack[-1][0] and not stack[-1][2]:
            stack[-1] = (word, *stack[-1][1:])
        elif word == ")":
            need(len(stack) > 1 and stack[-1][0] != "", f"malformed formula {text[:60]}")
            op, sign, args = stack.pop()
            made = every(args) if op == "&" else some(args)
            stack[-1][2].append(no(made) if sign else made)
        else:
            sign, name = word.startswith("!"), word.lstrip("!")
            if not name or len(word) - len(name) > 1:
                raise Rejected(f"malformed formula {text[:60]}")
            x = TRUE if name == "T" else FALSE if name == "F" else leaf(spaced(name))
            stack[-1][2].append(no(x) if sign else x)
    need(len(stack) == 1 and len(stack[0][2]) == 1, f"malformed formula {text[:60]}")
    return stack[0][2][0]
