"""Known shapes, found by what they say: those that ship with the package, and those made on the way.

The shapes of a goal's pattern stand in a tree, a fact on each branch, so that shapes which begin alike are tried
together; those that were met in the same surroundings stand in a tree of their own, which is tried first.  A library
is a hint and no more: what it names is an instance because the facts are there, and the refutations of shapes are
checked by whoever reads the certificate.
"""

from __future__ import annotations

import lzma
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cache
from itertools import chain
from pathlib import Path

from interlock.proof.certificate.shapes import Index, Leaf, Part, Pattern, Shape

SHIPPED = Path(__file__).parent / "shapes.txt.xz"
HEAD = "interlock-shapes 1"
NEAR, FAR = 4000, 400  # facts tried for one goal, in the same surroundings and in any
DEEP = 600  # facts of a shape that is looked for; a larger one is proved anew


class End:
    """Where a shape ends: its steps as they stand in the file, and the shape once it was used."""

    __slots__ = ("shape", "steps")

    def __init__(self, steps: str) -> None:
        self.steps = steps
        self.shape: Shape | None = None


class Node:
    """What may follow a fact: other facts by their text in the file, and the shape that ends here.

    key, rank: the fact itself, and which of those that could stand there it was, where that is known.
    """

    __slots__ = ("end", "key", "onward", "part", "rank")

    def __init__(self, word: str = "") -> None:
        self.key, _, rank = word.partition("@")
        self.rank = int(rank) if rank else 0
        self.part: Part | None = None
        self.onward: dict[str, Node] = {}
        self.end: End | None = None


@dataclass(frozen=True, slots=True)
class Way:
    """How a shape was found in some surroundings: its facts, which of those that could stand there each was where it
    was not the first, where it ends, and all of it in words."""

    parts: Sequence[Part]
    ranks: Mapping[int, int]
    end: End
    hint: str


@dataclass(frozen=True)
class Known:
    """A file of shapes, a line each: the patterns by number, the lines by goal, and by goal and surroundings."""

    patterns: Sequence[str] = ()
    lines: Mapping[str, Sequence[str]] = field(default_factory=dict)
    near: Mapping[tuple[str, str], Sequence[tuple[str, str]]] = field(default_factory=dict)
    """With each line the ranks of the facts that were not the first to be found."""


def read(text: str) -> Known:
    """The text of a library; raises ValueError or IndexError when it is of another kind."""
    lines = text.splitlines()
    if lines[:1] != [HEAD]:
        raise ValueError("another kind of file")
    patterns: list[str] = []
    shapes: dict[str, list[str]] = {}
    near: dict[tuple[str, str], list[tuple[str, str]]] = {}
    for line in lines[1:]:
        kind, _, rest = line.partition(" ")
        if kind == "pattern":
            patterns.append(rest)
            continue
        goal = patterns[int(kind)]
        where, _, shape = rest.partition("/")
        shapes.setdefault(goal, []).append(shape)
        for hint in where.split():
            around, _, ranks = hint.partition(":")
            near.setdefault((goal, around), []).append((shape, ranks))
    return Known(patterns, shapes, near)


@cache
def _shipped() -> Known:
    return read(lzma.decompress(SHIPPED.read_bytes()).decode())


class Library:
    """Shapes by the pattern of their goal."""

    def __init__(self, known: Known | None = None) -> None:
        self._known = known or Known()
        self._patterns = list(self._known.patterns)
        self._numbers = {p: n for n, p in enumerate(self._patterns)}
        self._parts: dict[str, Part] = {}
        self._roots: dict[tuple[str, str], Node] = {}
        self._ends: dict[tuple[str, str], End] = {}
        self._ways: dict[tuple[str, str], list[Way]] = {}
        self._used = 0

    @classmethod
    def shipped(cls) -> Library:
        """The shapes that ship with the package; none where the file cannot be read."""
        try:
            return cls(_shipped())
        except (OSError, ValueError, IndexError, lzma.LZMAError):
            return cls()

    def _number(self, pattern: str) -> int:
        if pattern not in self._numbers:
            self._numbers[pattern] = len(self._patterns)
            self._patterns.append(pattern)
        return self._numbers[pattern]

    def _root(self, goal: str, around: str = "") -> Node:
        root = self._roots.get((goal, around))
        if root is None:
            root = self._roots[goal, around] = Node()
            if around:
                known = self._known.near.get((goal, around), ())
            else:
                known = [(line, "") for line in self._known.lines.get(goal, ())]
            for line, ranks in known:
                facts, _, steps = line.partition("/")
                keys = _ranked(facts.split(), _told(ranks))
                self._place(root, keys).end = self._ends.setdefault((goal, line), End(steps))
        return root

    @staticmethod
    def _place(node: Node, keys: Iterable[str]) -> Node:
        for key in keys:
            found = node.onward.get(key)
            if found is None:
                found = node.onward[key] = Node(key)
            node = found
        return node

    def part(self, key: str) -> Part:
        """A fact of a shape from its text in the file."""
        part = self._parts.get(key)
        if part is None:
            pattern, _, leaves = key.partition(":")
            part = Part(self._patterns[int(pattern)], tuple(map(int, leaves.split(","))) if leaves else ())
            self._parts[key] = part
        return part

    def _key(self, part: Part) -> str:
        return f"{self._number(part.text)}:{','.join(map(str, part.leaves))}"

    def add(self, shape: Shape) -> Shape:
        """The library's own copy of a shape."""
        node = self._place(self._root(shape.goal), map(self._key, shape.parts))
        node.end = node.end or End("")
        if node.end.shape is None:
            node.end.shape = self._numbered(shape)
        return node.end.shape

    def learn(self, shape: Shape, goal: Pattern, facts: Sequence[int], index: Index) -> tuple[Shape, str]:
        """Keep a new shape; the library's own copy, and how to find it again."""
        mine = self.add(shape)
        search = Search(self, index, goal, 0)
        search.follow(mine.parts, facts)
        keys = [*map(self._key, mine.parts)]
        end = self._place(self._root(goal.text), keys).end
        assert end is not None
        return mine, self._near(goal, keys, search.ranks, index, end)

    def _near(self, goal: Pattern, keys: Sequence[str], ranks: Sequence[int], index: Index, end: End) -> str:
        """Place a shape among those of a goal's surroundings; how to find it again."""
        around, told = index.surroundings(goal), {i: r for i, r in enumerate(ranks) if r}
        self._place(self._root(goal.text, around), _ranked(keys, told)).end = end
        hint = _hint(around, ranks)
        self._straight(goal.text, around).insert(0, Way([*map(self.part, keys)], told, end, hint))
        return hint

    def _numbered(self, shape: Shape) -> Shape:
        shape.number, self._used = self._used, self._used + 1
        return shape

    def _straight(self, goal: str, around: str) -> list[Way]:
        """The ways that led to shapes in a goal's surroundings; what led there last comes first."""
        found = self._ways.get((goal, around))
        if found is None:
            found = self._ways[goal, around] = []
            known = self._parts
            for line, ranks in self._known.near.get((goal, around), ()):
                facts, _, steps = line.partition("/")
                end = self._ends.setdefault((goal, line), End(steps))
                hint = f"{around}:{ranks}" if ranks else around
                parts = [known.get(key) or self.part(key) for key in facts.split()]
                found.append(Way(parts, _told(ranks), end, hint))
        return found

    def find(self, goal: Pattern, index: Index) -> tuple[Shape, tuple[int, ...], str] | None:
        """A shape of which the goal is an instance, the facts in its order, and how to find it again."""
        around = index.surroundings(goal)
        ways = self._straight(goal.text, around)
        for n, way in enumerate(ways):
            search = Search(self, index, goal, 0)
            if search.along(way):
                if n:
                    ways.insert(0, ways.pop(n))
                if way.end.shape is None:
                    shape = Shape(goal.text, len(goal.leaves), tuple(way.parts), way.end.steps)
                    way.end.shape = self._numbered(shape)
                return way.end.shape, tuple(search.found), way.hint
        for place, tries in ((around, NEAR), ("", FAR)):
            search = Search(self, index, goal, tries)
            end = search.descend(self._root(goal.text, place))
            if end is not None:
                if end.shape is None:
                    parts = tuple(search.parts)
                    end.shape = self._numbered(Shape(goal.text, len(goal.leaves), parts, end.steps))
                keys = [] if place else [*map(self._key, search.parts)]
                near = "" if place else self._near(goal, keys, search.ranks, index, end)
                return end.shape, tuple(search.found), near or _hint(place, search.ranks)
        return None

    def text(self, shapes: Iterable[tuple[Shape, Iterable[str]]]) -> str:
        """Shapes, with how they were found in what surroundings, as the text of a library."""
        lines = []
        for s, around in shapes:
            facts = " ".join(map(self._key, s.parts))
            lines.append(f"{self._number(s.goal)} {' '.join(sorted(around))}/{facts}/{s.steps}")
        return "\n".join([HEAD, *(f"pattern {p}" for p in self._patterns), *sorted(lines)]) + "\n"


def _ranked(keys: Sequence[str], ranks: Mapping[int, int]) -> list[str]:
    """Facts with the rank of the one that was right, where it was not the first."""
    return [f"{key}@{ranks[i]}" if i in ranks else key for i, key in enumerate(keys)]


def _hint(around: str, ranks: Sequence[int]) -> str:
    """Surroundings, and the ranks that are not 0."""
    told = ",".join(f"{i}={r}" for i, r in enumerate(ranks) if r)
    return f"{around}:{told}" if told else around


def _told(ranks: str) -> dict[int, int]:
    """The ranks of a hint, by the place of the fact."""
    return dict(map(_pair, ranks.split(","))) if ranks else {}


def _pair(text: str) -> tuple[int, int]:
    place, _, rank = text.partition("=")
    return int(place), int(rank)


class Search:
    """Looks for facts of a system that make a goal an instance of some shape."""

    def __init__(self, library: Library, index: Index, goal: Pattern, tries: int) -> None:
        self.library, self.index = library, index
        self.names: list[Leaf] = [*goal.leaves]
        self.found: list[int] = []
        self.parts: list[Part] = []
        self.ranks: list[int] = []
        self.left = tries

    def descend(self, node: Node) -> End | None:
        """Where a shape ends, all of whose facts are found on the way from the node."""
        if node.end is not None:
            return node.end
        if len(self.found) >= DEEP:
            return None
        names, patterns = self.names, self.index.patterns
        for word, onward in reversed(node.onward.items()):  # what matched last stands last
            part = onward.part
            if part is None:
                part = onward.part = self.library.part(onward.key)
            candidates, rank = self._candidates(part), onward.rank
            order: Iterable[int] = range(len(candidates))
            for k in chain((rank,), order) if 0 < rank < len(candidates) else order:
                self.left -= 1
                if self.left < 0:
                    return None
                before = len(names)
                if self._bind(part, patterns[candidates[k]].leaves):
                    self.found.append(candidates[k])
                    self.parts.append(part)
                    self.ranks.append(k)
                    end = self.descend(onward)
                    if end is not None:
                        if len(node.onward) > 1:
                            node.onward[word] = node.onward.pop(word)
                        return end
                    self.found.pop()
                    self.parts.pop()
                    self.ranks.pop()
                del names[before:]
        return None

    def along(self, way: Way) -> bool:
        """Whether the facts are found as they were before: `_candidates` and `_bind` in one, as most goals end here."""
        names, found, patterns, ranks = self.names, self.found, self.index.patterns, way.ranks
        for n, part in enumerate(way.parts):
            known, most = len(names), 0
            some: Sequence[int] | None = None
            for number, table in zip(part.leaves, self.index.places(part.text), strict=False):
                if number < known:
                    those = table.get(names[number])
                    if those is None:
                        return False
                    if some is None or len(those) < most:
                        some, most = those, len(those)
                        if most == 1:
                            break
            if some is None:
                some = self.index.all(part.text)
            k = ranks.get(n, 0) if ranks else 0
            if k >= len(some):
                return False
            for number, name in zip(part.leaves, patterns[some[k]].leaves, strict=True):
                if number < known:
                    if names[number] != name:
                        return False
                elif number == known:
                    names.append(name)
                    known += 1
            found.append(some[k])
        return True

    def follow(self, parts: Sequence[Part], facts: Sequence[int]) -> None:
        """Note the rank of each fact among those that could stand in its place."""
        for part, n in zip(parts, facts, strict=True):
            self.ranks.append(self._candidates(part).index(n))
            self._bind(part, self.index.patterns[n].leaves)

    def _candidates(self, part: Part) -> Sequence[int]:
        """The facts of a part's pattern that have some known leaf where the part has it, the fewest."""
        best: Sequence[int] | None = None
        names, at = self.names, self.index.places(part.text)
        known = len(names) if at else 0
        for place, number in enumerate(part.leaves):
            if number < known:
                some = at[place].get(names[number], ())
                if best is None or len(some) < len(best):
                    if len(some) <= 1:
                        return some
                    best = some
        return self.index.all(part.text) if best is None else best

    def _bind(self, part: Part, leaves: tuple[Leaf, ...]) -> bool:
        """New numbers of a part come in order, so that they extend the list."""
        names = self.names
        for number, name in zip(part.leaves, leaves, strict=True):
            if number < len(names):
                if names[number] != name:
                    return False
            else:
                names.append(name)
        return True
