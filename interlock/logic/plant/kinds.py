"""What a plant consists of, and the assumptions about the world in words."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field
from functools import cached_property

from interlock.dataclass import dataclass
from interlock.logic import names
from interlock.logic.expr import FALSE, TRUE, Expr, Substitution, var
from interlock.logic.names import Name
from interlock.model.elements import MachineId, NodeId, Position, SectionId, SignalId
from interlock.model.layout import Layout
from interlock.model.overlap import told_apart


@dataclass(frozen=True)
class TokenWires:
    """How a line's direction token ends on the controller: inputs that tell of the neighbour and the line, the outputs
    that tell the neighbour, the operator's hand on the special manual change."""

    gives: Name
    keeps: Name
    has: Name
    clear: Name
    have: Name
    give: Name
    manual: Name


@dataclass(frozen=True)
class Wiring:
    """All that the plant sees of a controller, its terminals.  proceed, call, stop: lamps; speed: those that show a
    speed (km/h); command: drives."""

    proceed: Mapping[SignalId, Expr]
    call: Mapping[SignalId, Expr]
    command: Mapping[tuple[MachineId, Position], Expr]
    valid: Name
    clear: Mapping[SectionId, Name]
    healthy: Mapping[SectionId, Name]
    detected: Mapping[tuple[MachineId, Position], Name]
    stop: Mapping[SignalId, Expr]
    speed: Mapping[tuple[SignalId, int], Expr]
    token: Mapping[NodeId, TokenWires]


@dataclass(frozen=True, slots=True)
class Assumption:
    """A named sentence about the world, and what it says of one step."""

    id: str
    text: str
    expr: Expr


@dataclass(frozen=True, slots=True)
class Hazard:
    """A bad event of one step; `expr` speaks of old state and choices."""

    id: str
    place: str
    expr: Expr


class Events(dict[Name, Expr]):
    """Events by name.  What is stored is the definition; what is read is the event's variable (or a constant)."""

    def __init__(self) -> None:
        super().__init__()
        self.definitions: dict[Name, Expr] = {}

    def __setitem__(self, name: Name, definition: Expr) -> None:
        if definition is TRUE or definition is FALSE:
            super().__setitem__(name, definition)
            return
        self.definitions[name] = definition
        super().__setitem__(name, var(name))


@dataclass
class Plant:
    """State, choices, next-state functions, assumptions and hazards; expressions may name events."""

    state: dict[Name, str] = field(default_factory=dict)
    choices: dict[Name, str] = field(default_factory=dict)
    next: dict[Name, Expr] = field(default_factory=dict)
    initial: list[Expr] = field(default_factory=list)
    assumptions: list[Assumption] = field(default_factory=list)
    hazards: list[Hazard] = field(default_factory=list)
    waits: dict[NodeId, Name] = field(default_factory=dict)
    gone: dict[SectionId, Expr] = field(default_factory=dict)
    """What stands in a section leaves it wholly, in this step."""
    clocks: dict[Name, Expr] = field(default_factory=dict)
    """Clocks of the world, by state variable: what must hold without a break; true when it has held long enough."""
    events: Events = field(default_factory=Events)

    def on_line(self, b: NodeId) -> tuple[Name, ...]:
        """The state variables that tell that a train is on the line beyond a boundary with a direction token."""
        return (names.ON_LINE(b, "out"), names.ON_LINE(b, "in"), self.waits[b])

    @cached_property
    def flat(self) -> FlatPlant:
        """Everything over state, choices and inputs alone, for a finished plant."""
        known: dict[Name, Expr] = {}
        flat = Substitution(known)  # an event is known before it is read
        for name, x in self.events.definitions.items():
            known[name] = flat(x)
        return FlatPlant(
            {n: flat(x) for n, x in self.events.items()},
            {n: flat(x) for n, x in self.next.items()},
            [(a.id, flat(a.expr)) for a in self.assumptions],
            [(f"{h.id} {h.place}", flat(h.expr)) for h in self.hazards],
        )


@dataclass(frozen=True)
class FlatPlant:
    """Events, next states, assumptions and hazards without names of events."""

    events: dict[Name, Expr]
    next: dict[Name, Expr]
    assumptions: list[tuple[str, Expr]]
    hazards: list[tuple[str, Expr]]


ASSUMPTIONS: dict[str, str] = {
    "A-OBEY": "A train passes a main signal, and a shunting movement any signal, only after its driver has accepted a "
    "proceed that was shown to it.",
    "A-SIGHT": "A shunting movement runs on sight: it stops short of vehicles in the plain section where its route "
    "ends, those that stand and those that have come wholly in and still run, and moves on from there only on a "
    "signal.",
    "A-OVERRUN": "A train that fails to stop at a main signal with an overlap stops within the overlap, undivided, "
    "and is moved from there under local rules; it fails only while it is coming to a stand before that signal, and "
    "elsewhere no train passes a signal at stop.",
    "A-SLOW": "A train that was called at no more than the speed for which a short overlap inside a longer one of the "
    "same signal is made, and was shown nothing else from when it accepted that call until it passed the signal, stops "
    "within the short one; every other train within the longer one.",
    "A-SWING": "A train does not overrun a signal while points of its overlap still turn that were driven away "
    "before it was reported in the section before the signal: they have turned before one can have come so far.",
    "A-STAND": "When no train has come into the section before a signal for the time that one needs to come to a stand "
    "there, the train in it stands.",
    "A-SCAN": "A head leaves a section, and a tail leaves it, only after the occupation that it causes has been "
    "scanned (or while inputs are lost).",
    "A-HEADWAY": "A signal is accepted by one movement at a time: by no second one before it has been passed, nor from "
    "when the head of the one that passes has passed it until its tail has, the scan of the tail included.",
    "A-DETECT": "A train that stands in a section before and after a step is reported; one that just came in or "
    "left may be reported either way (no loss of shunt beyond one scan).",
    "A-ONE-FALSE": "No two neighbouring sections are falsely reported occupied in the same scan.",
    "A-CONTACT": "A point or device is never reported in a position in which it does not lie; a missing report is "
    "always possible.",
    "A-POINT": "A point or device moves only when commanded, at most one scan late.",
    "A-TIMER": "When a signal has shown stop without a break for the time that a train needs to come to a stand from "
    "the highest speed in its approach, a train on its way to it has passed it or stands.",
    "A-RESTART": "At a restart trains stand anywhere, across a joint only as the points beside it lie, and points lie "
    "anyhow; a train moves again only when a signal calls it (others are moved under local rules before their section "
    "is released).",
    "A-TRAILED": "Vehicles that are moved under local rules do not run through points that lie against them.",
    "A-BUFFER": "No train runs through a buffer: none stands where the track goes on.",
    "A-PARTED": "The rear part of a train that parts stays where it is until it is moved under local rules.",
    "A-REVERSE": "A train changes direction only at a standstill, wholly within one section, where a signal governs "
    "its new direction.",
    "A-LATE-OUTPUT": "Signals and machines follow the outputs of the last scan or of the scan before, not older.",
    "A-BEYOND": "Beyond a boundary the neighbour protects trains; nothing is proved there.",
    "A-NEIGHBOUR": "The neighbour at the other end of a line with a direction token follows the token's rules; what he "
    "tells comes late, or reads as nothing, but in order: no word arrives that the last telegram did not have.",
    "A-AGREED": "The hand of the special manual change of direction is held for the agreed time only as agreed by "
    "telephone: the line is empty, no train of the neighbour for which a signal towards it was open is on its way, he "
    "holds no hand of his own, has no direction, gives none and reads none as given to him, and no telegram that gives "
    "it, or that says he has it, is under way.",
    "A-LINE": "A line is not reported clear while a train is on it before and after a step.",
    "A-STANDS": "A vehicle inside the layout that is not on a route stands still, except behind a derailer or on an "
    "inclined lane, from where it may roll at any time; others may roll in only from beyond the next stop signal; a "
    "signal at stop stops them all.",
}


OF_PLC: dict[str, str] = {
    "A-TON": "An on-delay timer is true only while its input is true.",
    "A-CLOCK": "A timer counts the same time as the world: if it has run for as long as the world needs while "
    "something held without a break, then that has held for so long.",
    "A-INITIAL": "At a start and at each restart, after a power cut too, every variable has the value that it is "
    "declared with, a member of a structure and what lies in an inner block as any other, and no timer has run.",
}
"""What is assumed of whatever runs the text, where all else is assumed of the railway."""


def assumed_of(layout: Layout) -> dict[str, str]:
    """The assumptions that a layout's proof may rest on: A-SLOW where short overlaps lie inside longer ones, the others
    always."""
    nested = any(told_apart(layout, o.signal) for o in layout.overlaps.all)
    return {k: sentence for k, sentence in ASSUMPTIONS.items() if k != "A-SLOW" or nested} | OF_PLC
