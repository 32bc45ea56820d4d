"""One test of a book: what is done, what has to come, and what came on the bench."""

from __future__ import annotations

from collections.abc import Collection
from enum import StrEnum

from interlock.dataclass import dataclass

SLACK_S = 2
"""Seconds before and after the end of a delay at which a tester looks (our choice)."""


class Sheet(StrEnum):
    """The parts of a book."""

    WIRES = "wires"
    START = "start"
    MACHINES = "machines"
    ROUTES = "routes"
    TIMES = "times"


@dataclass(frozen=True)
class Step:
    """A test.

    `of`: the route, channel or delay that it is about.  `rule`: the rule (R1-R18) that asks for what has to come, empty
    where none does.  `tried`: it was tried on the bench.  `came`: what came there instead, empty if it was as it has to
    be.  `number`: its place in the book (`R12.3` is the third of the route with number 12).
    """

    sheet: Sheet
    of: str
    do: str
    expect: str
    rule: str = ""
    tried: bool = False
    came: str = ""
    number: str = ""

    @property
    def words(self) -> tuple[str, str, str, str]:
        """What a tester reads: equal in two books, it is the same test."""
        return self.sheet, self.of, self.do, self.expect

    @property
    def bench(self) -> str:
        """What is said of it on the sheet."""
        return self.came or ("as expected" if self.tried else "on the ground only")


def started(do: str, expect: str, came: Collection[str]) -> Step:
    """A test of how the controller begins, which was tried."""
    return Step(Sheet.START, "controller", do, expect, "R16", True, "; ".join(came))
