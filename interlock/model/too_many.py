"""How many ways are listed before a layout is refused.  IL3049.

Every loop without a signal doubles the ways that lead over it, so that forty in a row have more than anybody can list.
What is asked of a layout is asked of pairs of its routes: ten times as many take a hundred times as long.  A track
plan that is meant stays far below these bounds: from a signal before the ladder of a yard lead as many ways as the
yard has tracks, and the largest interlockings have a few thousand routes.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import TypeVar

from interlock.exceptions import Whole

MOST_THROUGH = 256
"""Ways through a section from one of its ends."""
MOST_OVERLAPS = 256
"""Ways on which the overlap of one signal is looked for."""
MOST_FROM_SIGNAL = 1024
"""Ways on which the routes of one kind from one signal are looked for."""
MOST_ROUTES = 20_000
"""Ways of all routes of a layout, each with each of its overlaps."""

T = TypeVar("T")


class TooManyWays(Whole):
    """There are more ways than are listed; `room` and `name`: of which element of the layout file, `text`: what leads
    where, `fix`: what to do."""

    def __init__(self, room: str, name: str, text: str, fix: str) -> None:
        super().__init__(text)
        self.room = room
        self.name = name
        self.text = text
        self.fix = fix


class Counted:
    """Lets so many ways pass, and raises TooManyWays at the next one."""

    def __init__(self, most: int, beyond: TooManyWays) -> None:
        self._left = most
        self._beyond = beyond

    def one(self) -> None:
        """Count a way.  Raises TooManyWays."""
        self._left -= 1
        if self._left < 0:
            raise self._beyond

    def each(self, ways: Iterable[T]) -> Iterator[T]:
        """The ways, each counted.  Raises TooManyWays."""
        for way in ways:
            self.one()
            yield way


def through(section: str) -> Counted:
    """Counts the ways through a section from one of its ends."""
    text = f"more than {MOST_THROUGH} ways lead through section {section} from one of its ends"
    fix = "cut it into several sections, as track circuits or axle counters are"
    return Counted(MOST_THROUGH, TooManyWays("sections", section, text, fix))


def overlaps(signal: str) -> Counted:
    """Counts the ways of a signal's overlap."""
    text = f"the overlap of {signal} would lead over more than {MOST_OVERLAPS} ways"
    fix = f"shorten it: `overlaps: {{{signal}: {{length: ...}}}}`, or bar what it is not to lead over (`not_over`)"
    return Counted(MOST_OVERLAPS, TooManyWays("overlaps", signal, text, fix))


def from_signal(signal: str, shunt: bool) -> Counted:
    """Counts the ways from a signal to where its routes of one kind end."""
    kind = "shunt" if shunt else "train"
    text = f"from {signal} more than {MOST_FROM_SIGNAL:,} ways lead to where its {kind} routes end"
    stops = "shunt or combined signals" if shunt else "main signals"
    fix = f"place {stops} on the way, at which its routes end: each loop without one doubles their number"
    return Counted(MOST_FROM_SIGNAL, TooManyWays("signals", signal, text, fix))


def in_all() -> Counted:
    """Counts the ways of all routes, each with each of its overlaps."""
    text = f"the routes of the layout have more than {MOST_ROUTES:,} ways, each overlap counted"
    fix = "place signals where many ways branch and meet again, shorten overlaps, or divide it into several layouts"
    return Counted(MOST_ROUTES, TooManyWays("name", "", text, fix))


def past_signals() -> Counted:
    """Counts the ways of routes past signals that show their identifier lights."""
    text = f"past signals with an identifier light routes have more than {MOST_ROUTES:,} ways"
    fix = "remove `identifier` of signals that no train needs to pass, or exclude ways to them"
    return Counted(MOST_ROUTES, TooManyWays("name", "", text, fix))
