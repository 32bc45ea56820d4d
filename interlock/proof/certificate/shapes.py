"""Shapes: what is left of an obligation when its variables lose their names.

A shape is a goal and the facts that refute its negation, with numbers for variables.  An obligation is an instance
when its goal and facts are the shape's clauses under one renaming of the numbers; the refutation of the shape then
refutes it too, whether or not the renaming keeps different numbers apart.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from zlib import crc32

from interlock.logic.expr import AND, EQ, FALSE, NOT, TRUE, VAR, Expr
from interlock.proof.certificate.facts import Fact

ROUNDS, MASK = 2, (1 << 64) - 1

Leaf = str
"""A variable's name, or `name=value` for a comparison."""

Tree = int | list["Tree | str"]
"""A leaf's number (negative when negated), or `[op, part, ...]` with op one of `&`, `|`, `!&`, `!|`."""

Step = tuple[tuple[int, ...], tuple[int, ...]]
"""A clause that follows, and the numbers of the earlier clauses that show it."""


@dataclass(frozen=True)
class Pattern:
    """A clause without names: its text with leaves numbered from 1 in order of appearance, and the leaves."""

    text: str
    leaves: tuple[Leaf, ...]


class Patterns:
    """Patterns of expressions, each computed once."""

    def __init__(self) -> None:
        self._of: dict[tuple[int, str], tuple[Expr, Pattern]] = {}

    def __call__(self, x: Expr, tag: str) -> Pattern:
        """The pattern of an expression; `tag` says where it comes from, so that only like is compared with like."""
        found = self._of.get((id(x), tag))
        if found is None:
            numbers: dict[Leaf, int] = {}
            text = f"{tag}:{_text(x, numbers)}"
            found = self._of[id(x), tag] = (x, Pattern(text, tuple(numbers)))
        return found[1]


def _text(x: Expr, numbers: dict[Leaf, int], sign: str = "") -> str:
    while x.op is NOT:
        x, sign = x.args[0], "" if sign else "!"
    if x.op is VAR:
        return f"{sign}{numbers.setdefault(x.name, len(numbers) + 1)}"
    if x.op is EQ:
        return f"{sign}{numbers.setdefault(f'{x.name}={x.value}', len(numbers) + 1)}"
    if x is TRUE or x is FALSE:
        return f"{sign}{'T' if x is TRUE else 'F'}"
    op = "&" if x.op is AND else "|"
    return f"{sign}({op} {' '.join(_text(a, numbers) for a in x.args)})"


@dataclass(frozen=True)
class Part:
    """A fact of a shape: the pattern's text, and the shape's number for each leaf of the pattern."""

    text: str
    leaves: tuple[int, ...]


@dataclass
class Shape:
    """A goal's pattern, facts and refutation; `number` tells it from the others of its library.

    steps: a word for each clause that follows, `literals:hints` with commas between numbers, as files have them.
    """

    goal: str
    arity: int
    parts: tuple[Part, ...]
    steps: str = ""
    number: int = field(default=-1, compare=False)


class Index:
    """The facts of a system, found by pattern, place in it and leaf."""

    def __init__(self, facts: Sequence[Fact], patterns: Patterns) -> None:
        self.patterns = [patterns(f.clause, f.tag) for f in facts]
        self._by_text: dict[str, list[int]] = {}
        for n, p in enumerate(self.patterns):
            self._by_text.setdefault(p.text, []).append(n)
        self._at: dict[str, list[dict[Leaf, list[int]]]] = {}
        self._first = len(self.patterns)

    def add(self, pattern: Pattern) -> None:
        """One more fact, with the next number."""
        n = len(self.patterns)
        self.patterns.append(pattern)
        self._by_text.setdefault(pattern.text, []).append(n)
        for table, leaf in zip(self._at.get(pattern.text, ()), pattern.leaves, strict=False):
            table.setdefault(leaf, []).append(n)

    def places(self, text: str) -> Sequence[Mapping[Leaf, Sequence[int]]]:
        """For each place in a pattern its facts by the leaf that they have there; none without facts."""
        found = self._at.get(text)
        if found is None:
            facts = self._by_text.get(text)
            if facts is None:
                return ()
            found = self._at[text] = self._places(facts)
        return found

    def _places(self, facts: Sequence[int]) -> list[dict[Leaf, list[int]]]:
        found: list[dict[Leaf, list[int]]] = [{} for _ in self.patterns[facts[0]].leaves]
        for n in facts:
            for table, leaf in zip(found, self.patterns[n].leaves, strict=True):
                table.setdefault(leaf, []).append(n)
        return found

    def all(self, text: str) -> Sequence[int]:
        """All facts of a pattern."""
        return self._by_text.get(text, ())

    @cached_property
    def _colours(self) -> dict[Leaf, int]:
        """A number for each leaf that tells in what of the first facts, and beside what, it stands; alike stands the
        same."""
        colour: dict[Leaf, int] = {}
        kinds = {p.text: crc32(p.text.encode()) for p in self.patterns[: self._first]}
        for _ in range(ROUNDS):
            following: dict[Leaf, int] = {}
            for p in self.patterns[: self._first]:
                here = hash((kinds[p.text], *[colour.get(x, 0) for x in p.leaves]))
                for place, x in enumerate(p.leaves):
                    following[x] = (following.get(x, 0) + hash((here, place))) & MASK
            colour = following
        return colour

    def surroundings(self, goal: Pattern) -> str:
        """What a goal's leaves are surrounded by: the same for goals that are likely to be of one shape."""
        colours = self._colours
        return f"{hash(tuple(colours.get(x, 0) for x in goal.leaves)) & MASK:x}"


def shape_of(goal: Pattern, core: Sequence[int], index: Index) -> tuple[Shape, tuple[int, ...]]:
    """The shape of an obligation and its facts in the shape's order: next comes the fact that is easiest to find, of
    which the fewest others have the same pattern and a leaf that is known already."""
    numbers = {name: n for n, name in enumerate(goal.leaves)}
    having: dict[Leaf, list[tuple[int, int]]] = {}
    for n in core:
        for place, name in enumerate(index.patterns[n].leaves):
            having.setdefault(name, []).append((n, place))
    left = dict.fromkeys(core)
    alike: dict[int, tuple[int, int, int]] = {}

    def know(name: Leaf) -> None:
        for n, place in having.get(name, ()):
            if n in left:
                pattern = index.patterns[n]
                found = len(index.places(pattern.text)[place].get(name, ())), len(pattern.leaves), n
                alike[n] = min(found, alike.get(n, found))

    for name in goal.leaves:
        know(name)
    parts: list[Part] = []
    order: list[int] = []
    while left:
        best = min(alike.values())[2] if alike else min(left, key=lambda n: (len(index.patterns[n].leaves), n))
        del left[best]
        alike.pop(best, None)
        order.append(best)
        pattern = index.patterns[best]
        for name in pattern.leaves:
            if name not in numbers:
                numbers[name] = len(numbers)
                know(name)
        parts.append(Part(pattern.text, tuple(numbers[x] for x in pattern.leaves)))
    return Shape(goal.text, len(goal.leaves), tuple(parts)), tuple(order)
