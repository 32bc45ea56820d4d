"""What browsers send, cleaned where it comes in: whatever it is, all behind this gets fields of known kinds, numbers
that can be reckoned with, and texts that can be shown, sent and recorded."""

from __future__ import annotations

import unicodedata
from collections.abc import Mapping
from typing import Any

from interlock.exceptions import Whole
from interlock.panel.commands import TEXT

TEXTS = frozenset(
    ("do", "route", "signal", "section", "machine", "to", "boundary", "name", "train", "at", "text", "towards", "kind")
)
NUMBERS = frozenset(("heard", "after", "metres", "times"))
TIMES = frozenset(("heard", "after"))
"""When it was asked for, which is not asked of what is done however late it comes."""
FLAGS = frozenset(("on", "go", "end"))
ALARMS = "alarms"
"""The fields of commands by kind; the last is a list of pairs of texts."""

LONGEST = 1000
"""Characters of a text at most: a command of a locomotive number names many places."""

LARGEST = 10**12
"""The largest number, either way: more than the seconds of any clock."""

MOST_ALARMS = 10_000
"""Alarms that are acknowledged at once: more than there can be."""

ACKNOWLEDGE = "acknowledge"
"""The command that names alarms, and may be so long."""

CLOCK = "clock"
"""Asks for the clock here, which is answered at once and not by the cycle."""

WHY = "why"
"""Asks why a route is not set, or its signal at stop."""

STOP = "stop"
NEVER_LATE = (STOP, "cancel", ACKNOWLEDGE, "remind", "lamp test")
"""Commands that do no harm however late they come; so does to block a section."""

NOT_KNOWN = "this panel does not know such a command"

_JOIN = "\u200c\u200d"
"""Signs that join letters, or do not: nobody sees them, and some scripts need them."""


class NotKnown(Whole):
    """This is no command of a panel; the message says why."""

    def __init__(self, why: str = "") -> None:
        super().__init__(f"{NOT_KNOWN}: {why}" if why else NOT_KNOWN)


class Command(dict[str, Any]):
    """A command whose fields are of their kinds; one that is missing is no command."""

    def __missing__(self, key: str) -> Any:
        raise NotKnown(f"it has no {key}")


def line(text: str, most: int = TEXT) -> str:
    """A text as one line, without half surrogates, which cannot be sent, and signs that nobody sees."""
    return "".join(map(_sign, text[: 4 * most])).strip()[:most].rstrip()


def _sign(sign: str) -> str:
    match unicodedata.category(sign):
        case "Cc" | "Zl" | "Zp":
            return " "
        case "Cs":
            return "\ufffd"
        case "Cf" if sign not in _JOIN:
            return ""
    return sign


def name(given: Any) -> str:
    """Who somebody says he is."""
    return (line(given) if isinstance(given, str) else "") or "operator"


def mark(given: Any) -> int | str | None:
    """The mark that a browser knows its command by: a number or a short text."""
    if isinstance(given, str):
        return line(given)
    return given if isinstance(given, int) and abs(given) <= LARGEST else None


def cleaned(given: Mapping[str, Any]) -> Command:
    """A command with the fields that there are; one that is null is missing.  Raises `NotKnown`, but for stop: that is
    taken whatever stands beside it, and what is never late whatever its times are."""
    found = Command()
    what = _text("do", given["do"]) if isinstance(given.get("do"), str) else ""
    if what == STOP:
        return Command(do=STOP)
    timeless = never_late(what, given)
    for key, value in given.items():
        if timeless and key in TIMES:
            continue
        if value is None and key != ALARMS:  # no alarms named are all of them
            continue
        if key in TEXTS:
            found[key] = _text(key, value)
        elif key in NUMBERS:
            found[key] = _number(key, value)
        elif key in FLAGS:
            found[key] = _flag(key, value)
        elif key == ALARMS:
            found[key] = _pairs(value)
    return found


def verb(given: Mapping[str, Any]) -> str:
    """What is asked for, as far as that can be told."""
    do = given.get("do")
    return line(do) if isinstance(do, str) else ""


def dated(given: Mapping[str, Any]) -> bool:
    """Whether it says when it was asked for, or need not."""
    what = verb(given)
    return what == WHY or never_late(what, given) or all(given.get(k) is not None for k in TIMES)


def never_late(what: str, command: Mapping[str, Any]) -> bool:
    """Whether it is done however long ago it was asked for."""
    return what in NEVER_LATE or (what == "block" and bool(command.get("on")))


def _text(key: str, value: Any) -> str:
    if not isinstance(value, str):
        raise NotKnown(f"{key} is no text")
    if len(value) > LONGEST:
        raise NotKnown(f"{key} is longer than {LONGEST} characters")
    return line(value, LONGEST)


def _number(key: str, value: Any) -> int | float:
    if isinstance(value, bool) or not isinstance(value, int | float):
        raise NotKnown(f"{key} is no number")
    if not -LARGEST <= value <= LARGEST:  # nor is what is not a number
        raise NotKnown(f"{key} is too large a number")
    return value


def _flag(key: str, value: Any) -> bool:
    if not isinstance(value, int) or value not in (0, 1):
        raise NotKnown(f"{key} is neither true nor false")
    return bool(value)


def _pairs(value: Any) -> list[tuple[str, str]]:
    if not isinstance(value, list) or len(value) > MOST_ALARMS:
        raise NotKnown(f"{ALARMS} is no list of alarms")
    found = []
    for pair in value:
        if not isinstance(pair, list | tuple) or len(pair) != 2:
            raise NotKnown(f"{ALARMS} is no list of alarms")
        found.append((_text(ALARMS, pair[0]), _text(ALARMS, pair[1])))
    return found
