"""What is said of a variable while it is false, and while it is true: one sentence a family, with the rule behind it.

A person at the panel reads these, in refusals and in the list of codes of a controller.  `{0}`, `{1}`: what the
variable stands at; `{0:section}`: with its kind.
"""

from __future__ import annotations

from dataclasses import dataclass

from interlock.diag.called import called
from interlock.logic import names
from interlock.logic.names import Family, Kind, Name
from interlock.model.elements import Position

SIGN = {
    Kind.SECTION: "s",
    Kind.MACHINE: "m",
    Kind.SIGNAL: "g",
    Kind.OVERLAP: "g",
    Kind.CONDITION: "c",
    Kind.ZONE: "z",
    Kind.LINE: "b",
}
LIES = {Position.NORMAL: "normal", Position.REVERSE: "reverse"}


@dataclass(frozen=True, slots=True)
class Sentence:
    """What is said of a variable of a family; empty where nobody would say it."""

    when_false: str
    when_true: str
    rule: str


SENTENCES: dict[Family, Sentence] = {
    names.VALID.family: Sentence("inputs are not valid: a substation is lost", "", "R16"),
    names.RESTART_OVER.family: Sentence("the restart delay is not over", "", "R16"),
    names.CLEAR: Sentence("{0:section} is occupied", "{0:section} is clear", "R3"),
    names.LONG_CLEAR: Sentence("{0:section} is not clear for long enough", "{0:section} is steadily clear", "R15"),
    names.OCCUPIED: Sentence("{0:section} is clear", "{0:section} is occupied", "R3"),
    names.HEALTHY: Sentence("the detector of {0:section} is out of order", "", "R3"),
    names.BLOCKED: Sentence("", "{0:section} is blocked", "R3"),
    names.FREE: Sentence("{0:section} is locked", "", "R6"),
    names.LOCK: Sentence("", "{0:section} is locked", "R6"),
    names.RESTART_LOCK: Sentence("", "{0:section} is not released since the restart", "R16"),
    names.STALE: Sentence("", "{0:section}: inputs were lost, or a train was called on; release it by hand", "R16"),
    names.USED: Sentence("no train has come into {0:section}", "a train is in {0:section}", "R9"),
    names.TRAIN_LOCK: Sentence("", "{0:section} is locked for a train", "R2"),
    names.TRAILED: Sentence("", "{0:points} were trailed: look at them, and confirm it", "R10"),
    names.CONTACT: Sentence("{0} is not detected {1}", "{0} is detected {1}", "R10"),
    names.DETECTED: Sentence("{0} is not detected {1}", "{0} is detected {1}", "R10"),
    names.CONDITION: Sentence("{0:condition} does not hold", "", "R17"),
    names.STOP_LAMP: Sentence("the stop lamp of {0} is out", "", "R11"),
    names.CLEAR_LAMP: Sentence("the clear lamp of {0} is out", "", "R11"),
    names.IDENTIFIER_LAMP: Sentence("the identifier lamp of {0} is out", "", "R11"),
    names.CAUTION_LAMP: Sentence("the caution lamp of {0} is out", "", "R11"),
    names.CANCELLING: Sentence("", "the route from {0} is being cancelled", "R8"),
    names.OVERLAP: Sentence("overlap {1} of {0} is not held", "overlap {1} of {0} is held there", "R4"),
    names.TOKEN_HERE: Sentence("the direction at {0} is not ours", "", "R12"),
    names.LINE_CLEAR: Sentence("the line at {0} is not clear", "", "R12"),
}

RULES = {
    "flank not held": "R5",
    "added point not held": "R5",
    "overlap free": "R4",
    "no train into the berth": "R2",
    "no overlap in the berth": "R2",
    "no other movement into the berth": "R2",
    "rear released": "R9",
    "rear device closed": "R16",
    "stands alone": "R9",
}
"""The rule behind a condition of several variables that is from no cell of the table, by the sort of its term."""


class _Element(str):
    """A name in a sentence: `{0:section}` is `section s5`, or the name alone that says so itself."""

    __slots__ = ()

    def __format__(self, kind: str) -> str:
        return called(kind, str(self)) if kind else str(self)


def sentence(name: Name, is_true: bool) -> str:
    """What is said of a variable; empty where nothing is known to say."""
    found = SENTENCES.get(name.family)
    if found is None:
        return ""
    return (found.when_true if is_true else found.when_false).format(
        *(LIES[x] if isinstance(x, Position) else _Element(x) for x in name.at)
    )


def about(name: Name) -> tuple[str, ...]:
    """The element to which a variable belongs, as a panel names it."""
    owner = name.owner
    return (f"{SIGN[owner.kind]}:{owner.id}",) if owner is not None and owner.kind in SIGN else ()
