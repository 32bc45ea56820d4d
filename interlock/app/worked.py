"""What a shift is run with, and what it showed."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field

from interlock.dataclass import dataclass
from interlock.dispatch.assign import Assigning
from interlock.dispatch.orders import Derived
from interlock.dispatch.run import Run
from interlock.simulate.mishaps import Rates


@dataclass(eq=False)
class Trip:
    """A train with an order.  `turned`: the section in which it changed ends last."""

    train: str
    order: Derived
    run: Run
    since_ms: int
    phase: str = "to load"
    came: bool = False
    turned: str = ""


@dataclass
class Wrong:
    """What must not come about in a shift."""

    standstill: bool = False
    stood: dict[str, str] = field(default_factory=dict)
    """Why each train stood, that had an order, when all stood for ever."""
    places: int = 0
    """Trains that the dispatcher had elsewhere than they were."""
    hazards: list[str] = field(default_factory=list)
    passed_at_stop: list[str] = field(default_factory=list)

    @property
    def texts(self) -> list[str]:
        """What was wrong, in words."""
        stood = [f"{train} stands for ever: {why}" for train, why in self.stood.items()]
        return [*stood, *self.hazards, *self.passed_at_stop]

    def counts(self) -> Mapping[str, int]:
        """The counts that must be 0."""
        return {
            "standstills": int(self.standstill),
            "wrong places": self.places,
            "hazards": len(self.hazards),
            "passed at stop": len(self.passed_at_stop),
        }


@dataclass
class Planning:
    """Plans that were made in a shift."""

    made: int = 0
    by_rules: int = 0
    """How often the plan was given up, so that the rules took over for a while."""


@dataclass
class Delays:
    """What held trains up."""

    refused: int = 0
    """Requests that the rule held back."""
    longest_wait_s: float = 0.0


@dataclass
class Worked:
    """What a shift showed."""

    seed: int
    tipped: dict[str, int] = field(default_factory=dict)
    """Trains by order."""
    late: dict[str, int] = field(default_factory=dict)
    """Of them, by order with a time until when (`by`): those after it."""
    tonnes: dict[str, float] = field(default_factory=dict)
    """By kind of ore."""
    brought: dict[str, float] = field(default_factory=dict)
    """Tonnes by order."""
    seconds: float = 0.0
    scans: int = 0
    movements: int = 0
    wrong: Wrong = field(default_factory=Wrong)
    alarms: list[str] = field(default_factory=list)
    delays: Delays = field(default_factory=Delays)
    planning: Planning = field(default_factory=Planning)
    chain: str = ""
    log: bytes = b""

    @property
    def trains(self) -> int:
        """Trains tipped."""
        return sum(self.tipped.values())


@dataclass(frozen=True)
class Options:
    """How shifts are run.  rule: ask only if a completion plan exists after it.  keep: the record's bytes, too.

    steady: work takes exactly the minutes of the file.  planned: a plan orders the requests."""

    hours: float | None = None
    how: Assigning = Assigning.IN_TURN
    rule: bool = True
    look_ahead: int = 1
    faults: Rates = field(default_factory=Rates)
    keep: bool = True
    steady: bool = False
    planned: bool = False
