"""Canonical forms: which questions are the same but for the names, along a line of stations or in a layout seen before.

A question is some lists of expressions, with the definitions of the names that they read, of those that these read,
and so on.  Its canonical form is what is left when names are numbered in order of appearance.

**Theorem.**  Two questions of one form are equal under a renaming that keeps different names apart, and consequence
is closed under such renaming, so that what follows in the one follows in the other.  (Substitution theorem of
propositional logic; symmetry as in Ip and Dill, *Better Verification Through Symmetry*, 1996.)
"""

from __future__ import annotations

import hashlib
from array import array
from collections.abc import Iterable, Mapping, Sequence
from itertools import chain, count

from interlock.logic.expr import AND, EQ, NOT, OR, TRUE, VAR, Expr
from interlock.logic.names import Name, spelled

KEPT = 200_000  # expressions whose form is remembered: parts that follow each other share most of theirs


class CanonicalForms:
    """Canonical forms of questions over names that have a meaning."""

    def __init__(self, meaning: Mapping[Name, Expr]) -> None:
        """`meaning`: what names stand for."""
        self._meaning = meaning
        self._of: dict[Expr, tuple[int, list[Name]]] = {}
        self._texts: dict[str, int] = {}
        self._compared: dict[str, str] = {}

    def digest(self, head: str, lists: Iterable[tuple[Sequence[Expr], Mapping[Name, Name]]]) -> str:
        """The digest of the form of some lists of expressions, each with other names for some of what it reads."""
        if len(self._of) > KEPT:
            self._of.clear()
        sizes: list[int] = []
        texts: list[int] = []
        leaves: list[Name] = []
        for some, renamed in lists:
            before = len(leaves)
            sizes.append(self._note(some, texts, leaves))
            if renamed:
                leaves[before:] = [renamed.get(x, x) for x in leaves[before:]]
        names = dict(zip(dict.fromkeys(leaves), count()))
        meaning, told, fresh = self._meaning, [], list(names)
        while new := [x for x in fresh if x in meaning]:
            told += [names[x] for x in new]
            before = len(leaves)
            sizes.append(self._note([meaning[x] for x in new], texts, leaves))
            fresh = [x for x in dict.fromkeys(leaves[before:]) if x not in names]
            names.update(zip(fresh, count(len(names))))
        every = list(self._texts)
        kinds = dict(zip(dict.fromkeys(texts), count()))
        digest = hashlib.sha256("\n".join([head, *(every[n] for n in kinds), ""]).encode())
        group: dict[str, int] = {}
        values = [(names[x], group.setdefault(self._compared[x], len(group))) for x in names if x in self._compared]
        uses = map(names.__getitem__, leaves)
        for numbers in (sizes, [kinds[n] for n in texts], [*uses], told, [*chain.from_iterable(values)]):
            digest.update(array("q", [len(numbers), *numbers]).tobytes())
        return digest.hexdigest()

    def of(self, meaning: Mapping[Name, Expr], *lists: Sequence[Expr]) -> str:
        """The digest of the form of lists of expressions over names with another meaning."""
        self._meaning = meaning
        return self.digest("", [(some, {}) for some in lists])

    def _note(self, some: Iterable[Expr], texts: list[int], leaves: list[Name]) -> int:
        """Add the expressions' texts and leaves; how many they are."""
        of, before = self._of, len(texts)
        for x in some:
            number, those = of.get(x) or self._read(x)
            texts.append(number)
            leaves += those
        return len(texts) - before

    def _read(self, x: Expr) -> tuple[int, list[Name]]:
        leaves: list[Name] = []
        text = self._text(x, leaves)
        found = self._of[x] = self._texts.setdefault(text, len(self._texts)), leaves
        return found

    def _text(self, x: Expr, leaves: list[Name]) -> str:
        """An expression with a `v` for each leaf, in an order in which it can be read again; adds the leaves."""
        op = x.op
        if op is AND or op is OR:
            text = "&" if op is AND else "|"
            for a in x.args:  # most are variables, or denied ones
                kind = a.op
                if kind is VAR:
                    leaves.append(a.name)
                    text += "v"
                elif kind is NOT and a.args[0].op is VAR:
                    leaves.append(a.args[0].name)
                    text += "!v"
                else:
                    text += self._text(a, leaves)
            return text + "."
        if op is VAR:
            leaves.append(x.name)
            return "v"
        if op is NOT:
            return "!" + self._text(x.args[0], leaves)
        if op is EQ:
            leaf = spelled(f"{x.name}={x.value}")
            self._compared[leaf] = x.name
            leaves.append(leaf)
            return "v"
        return "T" if x is TRUE else "F"
