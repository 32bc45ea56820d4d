"""The specification's sentences: read, and made formulas for a layout.

a -> b      a <-> b      a or b      a and b      not a      (each x in xs: a)      (some x in xs: a)
one_at_most(x in xs: a)      word(arguments)      word'(arguments): after the scan
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Mapping
from functools import lru_cache
from typing import Any, Protocol

from interlock.checker.formula import FALSE, Formula, every, implies, no, one_at_most, same, some
from interlock.verify import Rejected, need

TOKEN = re.compile(r"\s*(<->|->|[(),:']|[A-Za-z_][A-Za-z0-9_]*)")


class Words(Protocol):
    """What the words of a specification mean for a layout."""

    def word(self, name: str) -> Callable[..., Any]:
        """A word of topology, which gives elements, or of the system, which gives a formula."""
        ...

    def after(self, x: Formula) -> Formula:
        """The formula after the scan."""
        ...

    @property
    def meanings(self) -> Mapping[str, tuple[list[str], str]]:
        """Words that the specification explains itself: names of what is given, and the sentence."""
        ...


class Sentence:
    """A sentence under some values for its names."""

    def __init__(self, text: str, words: Words, names: Mapping[str, Any]) -> None:
        self.tokens = _tokens(text)
        self.words, self.text, self.at = words, text, 0
        self.names = dict(names)

    def formula(self) -> Formula:
        """The whole sentence."""
        x = self._same()
        need(self.tokens[self.at] == "", f"the specification has more than a sentence: {self.text}")
        return x

    def term(self) -> Any:
        """The whole text as a term: elements, or whether something is so."""
        x = self._word()
        need(self.tokens[self.at] == "", f"the specification has more than a term: {self.text}")
        return x

    def _take(self, *wanted: str) -> str:
        word = self.tokens[self.at]
        if wanted and word not in wanted:
            raise Rejected(f"the specification says {word!r} for {wanted} in: {self.text}")
        self.at += 1
        return word

    def _same(self) -> Formula:
        x = self._implies()
        while self.tokens[self.at] == "<->":
            self._take()
            x = same(x, self._implies())
        return x

    def _implies(self) -> Formula:
        x = self._or()
        if self.tokens[self.at] == "->":
            self._take()
            return implies(x, self._implies())
        return x

    def _or(self) -> Formula:
        found = [self._and()]
        while self.tokens[self.at] == "or":
            self._take()
            found.append(self._and())
        return some(found)

    def _and(self) -> Formula:
        found = [self._not()]
        while self.tokens[self.at] == "and":
            self._take()
            found.append(self._not())
        return every(found)

    def _not(self) -> Formula:
        if self.tokens[self.at] == "not":
            self._take()
            return no(self._not())
        return self._atom()

    def _atom(self) -> Formula:
        word = self.tokens[self.at]
        if word in ("each", "some"):
            return {"each": every, "some": some}[self._take()](self._over())
        if word == "one_at_most":
            self._take()
            self._take("(")
            x = one_at_most(self._over())
            self._take(")")
            return x
        if word == "(":
            self._take()
            x = self._same()
            self._take(")")
            return x
        found: Formula = self._word()
        return found

    def _over(self) -> Iterable[Formula]:
        """The formula after the colon for each element; its tokens are read once for each."""
        name = self._take()
        self._take("in")
        those = list(self._word())
        self._take(":")
        begin, found, before = self.at, [], self.names.get(name)
        for x in those:
            self.at, self.names[name] = begin, x
            found.append(self._same())
        if not those:
            self._skip()
        self.names[name] = before
        return found

    def _skip(self) -> None:
        """To the end of what would be said of elements that there are none of."""
        depth = 0
        while self.tokens[self.at] and (depth or self.tokens[self.at] != ")"):
            depth += {"(": 1, ")": -1}.get(self.tokens[self.at], 0)
            self.at += 1

    def _word(self) -> Any:
        name = self._take()
        if not name.isidentifier():
            raise Rejected(f"the specification says {name!r} in: {self.text}")
        if name in self.names:
            return self.names[name]
        later = self.tokens[self.at] == "'"
        if later:
            self._take()
        given = []
        if self.tokens[self.at] == "(":
            self._take()
            while self.tokens[self.at] != ")":
                given.append(self._word())
                if self.tokens[self.at] == ",":
                    self._take()
            self._take(")")
        found = self._meaning(name, given)
        return self.words.after(found) if later else found

    def _meaning(self, name: str, given: list[Any]) -> Any:
        explained = self.words.meanings.get(name)
        if explained is None:
            return self.words.word(name)(*given)
        names, text = explained
        need(len(names) == len(given), f"the specification's word {name} stands for {len(names)} things")
        return Sentence(text, self.words, dict(zip(names, given, strict=True))).formula()


@lru_cache(1 << 12)
def _tokens(text: str) -> list[str]:
    """The tokens, and an empty one at the end."""
    at, tokens = 0, []
    while text[at:].strip():
        found = TOKEN.match(text, at)
        if found is None:
            raise Rejected(f"the specification cannot be read: {text[at : at + 30]!r}")
        tokens.append(found.group(1))
        at = found.end()
    return [*tokens, ""]


def explained(words: Mapping[str, str]) -> dict[str, tuple[list[str], str]]:
    """What a specification says of its own words: `word(a, b): sentence`."""
    found = {}
    for head, text in words.items():
        name, _, rest = head.partition("(")
        found[name] = [x.strip() for x in rest.rstrip(")").split(",") if x.strip()], text
    return found


def instances(schema: Mapping[str, str], words: Words, at: Mapping[str, Any] | None = None) -> Iterator[Formula]:
    """What a schema says of a layout: a formula for each place at which there is something to say."""
    for names in places(schema, words, at):
        yield Sentence(schema["must"], words, names).formula()


def places(schema: Mapping[str, str], words: Words, at: Mapping[str, Any] | None = None) -> Iterator[dict[str, Any]]:
    """The places of which a schema speaks: values for its names."""
    ranges = [part.strip() for part in re.split(r",\s*(?=\w+ in )", schema.get("for", "")) if part.strip()]

    def go(rest: list[str], names: dict[str, Any]) -> Iterator[dict[str, Any]]:
        if not rest:
            if "when" not in schema or Sentence(schema["when"], words, names).formula() != FALSE:
                yield names
            return
        name, _, those = rest[0].partition(" in ")
        for x in Sentence(those, words, names).term():
            yield from go(rest[1:], {**names, name.strip(): x})

    return go(ranges, dict(at or {}))
