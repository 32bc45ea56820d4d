"""The specification as data: what is in the files of `interlock/spec`, read once."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

from interlock.checker.reading import loaded
from interlock.checker.schema import explained

FOLDER = Path(__file__).parent.parent / "spec"

Schemas = Sequence[Mapping[str, Any]]


@dataclass(frozen=True)
class Specification:
    """words: those that the specification explains itself.  guards: the sentences of assumptions that are no formulas
    of their own, but conditions of the world's moves.  told: what words say of routes; states, sentences: what
    is published of their codes; unread: how those begin that nobody compares."""

    words: Mapping[str, tuple[list[str], str]]
    assumptions: Schemas
    claims: Schemas
    events: Schemas
    next: Schemas
    initial: Schemas
    guards: Mapping[str, str]
    told: Schemas
    states: Mapping[int, str]
    sentences: Schemas
    unread: Sequence[str]

    @property
    def moves(self) -> Schemas:
        """What the world does, and how it begins."""
        return [*self.events, *self.next, *self.initial]


def under(schema: Mapping[str, str]) -> list[str]:
    """The assumptions that a schema names."""
    return re.findall(r"A-[A-Z-]+", f"{schema.get('free', '')} {schema.get('under', '')}")


def _each(schemas: Sequence[Mapping[str, Any]]) -> Iterator[Mapping[str, Any]]:
    """Schemas one by one: `also` says more under the same name."""
    for s in schemas:
        yield {k: v for k, v in s.items() if k != "also"}
        yield from ({"id": s["id"], **more} for more in s.get("also", ()))


def read(claims: str, plant: str, told: str) -> Specification:
    """A specification from its three texts."""
    said, moves, words = loaded(claims), loaded(plant), loaded(told)
    return Specification(
        explained({**said["words"], **moves["words"]}),
        list(_each(said["assumptions"])),
        list(_each(said["claims"])),
        moves["events"],
        moves["next"],
        moves["initial"],
        moves["guards"],
        list(_each(words["claims"])),
        {int(code): sentence for code, sentence in words["states"].items()},
        words["sentences"],
        words["unread"],
    )


@cache
def shipped() -> Specification:
    """The specification that comes with the package."""
    return read(*((FOLDER / f"{name}.yaml").read_text("utf-8") for name in ("claims", "plant", "told")))
