"""What is said of a variable while it is false, and while it is true: one sentence a family, with the rule behind it.

A person at the panel reads these, in refusals and in the list of codes of a controller.  `{0}`, `{1}`: what the
variable stands at; `{0:section}`: with its kind; `{lies}`: how the machine is reported (`Machines.lies`); `{trailed}`:
what is said of one that was run through (`Machines.trailed`).
"""

from __future__ import annotations

from interlock.dataclass import dataclass
from interlock.diag.called import called
from interlock.logic import names, rules
from interlock.logic.names import Family, Kind, Name
from interlock.model.elements import MachineId, Position
from interlock.model.machines import Machines

SIGN = {
    Kind.SECTION: "s",
    Kind.MACHINE: "m",
    Kind.SIGNAL: "g",
    Kind.OVERLAP: "g",
    Kind.CONDITION: "c",
    Kind.ZONE: "z",
    Kind.LINE: "b",
}


@dataclass(frozen=True, slots=True)
class Sentence:
    """What is said of a variable of a family; empty where nobody would say it."""

    when_false: str
    when_true: str
    rule: str


SENTENCES: dict[Family, Sentence] = {
    names.VALID.family: Sentence("inputs are not valid: a substation is lost", "", rules.RESTART),
    names.RESTART_OVER.family: Sentence("the restart delay is not over", "", rules.RESTART),
    names.CLEAR: Sentence("{0:section} is occupied", "{0:section} is clear", rules.PROCEED),
    names.LONG_CLEAR: Sentence(
        "{0:section} is not clear for long enough", "{0:section} is steadily clear", rules.LOSS_OF_SHUNT
    ),
    names.OCCUPIED: Sentence("{0:section} is clear", "{0:section} is occupied", rules.PROCEED),
    names.HEALTHY: Sentence("the detector of {0:section} is out of order", "", rules.PROCEED),
    names.BLOCKED: Sentence("", "{0:section} is blocked", rules.PROCEED),
    names.FREE: Sentence("{0:section} is locked", "", rules.HOSTILE_ROUTES),
    names.LOCK: Sentence("", "{0:section} is locked", rules.HOSTILE_ROUTES),
    names.RESTART_LOCK: Sentence("", "{0:section} is not released since the restart", rules.RESTART),
    names.STALE: Sentence(
        "",
        "{0:section}: inputs were lost, or a train was called on; cancel the route, or release the section by hand",
        rules.RESTART,
    ),
    names.USED: Sentence("no train has come into {0:section}", "a train is in {0:section}", rules.SECTIONAL_RELEASE),
    names.TRAIN_LOCK: Sentence("", "{0:section} is locked for a train", rules.KINDS_OF_ROUTES),
    names.TRAILED: Sentence("", "{trailed}", rules.POINTS),
    names.CONTACT: Sentence("{lies}", "{lies}", rules.POINTS),
    names.DETECTED: Sentence("{lies}", "{lies}", rules.POINTS),
    names.CONDITION: Sentence("{0:condition} does not hold", "", rules.EXTERNAL_CONDITIONS),
    names.SHOWING: Sentence("", "its signal shows proceed", rules.SIGNALS),
    names.STOP_LAMP: Sentence("the stop lamp of {0} is out", "", rules.SIGNALS),
    names.CLEAR_LAMP: Sentence("the clear lamp of {0} is out", "", rules.SIGNALS),
    names.IDENTIFIER_LAMP: Sentence("the identifier lamp of {0} is out", "", rules.SIGNALS),
    names.SECOND_LAMP: Sentence("the second yellow lamp of {0} is out", "", rules.SIGNALS),
    names.SPEED_LAMP: Sentence("the speed indicator of {0} is out", "", rules.SIGNALS),
    names.CAUTION_LAMP: Sentence("the caution lamp of {0} is out", "", rules.SIGNALS),
    names.CANCELLING: Sentence("", "the route from {0} is being cancelled", rules.APPROACH_LOCKING),
    names.OVERLAP: Sentence("overlap {1} of {0} is not held", "overlap {1} of {0} is held there", rules.OVERLAPS),
    names.TOKEN_HERE: Sentence("the direction at {0} is not ours", "the direction at {0} is ours", rules.LINE_BEYOND),
    names.TOKEN_GIVEN: Sentence("", "the direction at {0} is being given to the neighbour", rules.LINE_BEYOND),
    names.NEIGHBOUR_GIVES: Sentence("", "the neighbour at {0} gives the direction himself", rules.LINE_BEYOND),
    names.NEIGHBOUR_HAS: Sentence("", "the neighbour at {0} has the direction", rules.LINE_BEYOND),
    names.LINE_CLEAR: Sentence("the line at {0} is not clear", "", rules.LINE_BEYOND),
}

RULES = {
    "flank not held": rules.FLANK_PROTECTION,
    "added point not held": rules.FLANK_PROTECTION,
    "overlap free": rules.OVERLAPS,
    "no train into the berth": rules.KINDS_OF_ROUTES,
    "no overlap in the berth": rules.KINDS_OF_ROUTES,
    "no other movement into the berth": rules.KINDS_OF_ROUTES,
    "rear released": rules.SECTIONAL_RELEASE,
    "rear device closed": rules.RESTART,
    "stands alone": rules.SECTIONAL_RELEASE,
}
"""The rule behind a condition of several variables that is from no cell of the table, by the sort of its term."""


class _Element(str):
    """A name in a sentence: `{0:section}` is `section s5`, or the name alone that says so itself."""

    __slots__ = ()

    def __format__(self, kind: str) -> str:
        return called(kind, str(self)) if kind else str(self)


def sentence(name: Name, is_true: bool, machines: Machines | None = None) -> str:
    """What is said of a variable; empty where nothing is known to say.  Of machines it is said with what they are."""
    found = SENTENCES.get(name.family)
    if found is None:
        return ""
    said = found.when_true if is_true else found.when_false
    positions = [x for x in name.at[1:] if isinstance(x, Position)]
    if machines is None:
        assert not positions and name.family is not names.TRAILED, name
        return said.format(*(_Element(x) for x in name.at))
    lies = [machines.lies(MachineId(str(name.at[0])), x, is_true) for x in positions]
    trailed = machines.trailed(MachineId(str(name.at[0]))) if name.family is names.TRAILED else ""
    return said.format(*(_Element(x) for x in name.at), lies="".join(lies), trailed=trailed)


def about(name: Name) -> tuple[str, ...]:
    """The element to which a variable belongs, as a panel names it."""
    owner = name.owner
    return (f"{SIGN[owner.kind]}:{owner.id}",) if owner is not None and owner.kind in SIGN else ()
