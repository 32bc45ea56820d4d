"""A command being carried out: where its train has come to, what is set for it, what is asked for."""

from __future__ import annotations

from dataclasses import dataclass, field

from interlock.dispatch.panel import Indications, Stage
from interlock.dispatch.plan.railway import OUTSIDE, Journey, Place, Step
from interlock.model.elements import SectionId


@dataclass(eq=False)
class Run:
    """A journey under way.  `place`: where its train stands when it has run over all that is set for it.

    granted: the routes set so far, in the order of travel; `at`: how many of their signals the train has passed.
    asking: routes that belong to a step of which some are set, in the order in which they are asked for.
    """

    name: str
    journey: Journey
    priority: int = 0
    place: Place = field(init=False)
    granted: list[Stage] = field(default_factory=list)
    places: list[Place] = field(default_factory=list)
    at: int = 0
    opened: set[int] = field(default_factory=set)
    asking: list[Stage] = field(default_factory=list)
    step: Step | None = None
    cancelling: bool = False
    waited_ms: int = 0
    rest_ms: int = 0
    shut_ms: int = 0
    reason: str = ""
    caught: bool = False
    lines: dict[str, frozenset[SectionId]] = field(default_factory=dict)
    """By voyage that it meets: the single line that it shares with it."""
    voyage: str = ""
    started: int = 0
    """In which place it began to run, among all; 0: not yet."""

    def __post_init__(self) -> None:
        self.place = self.journey.start

    @property
    def finished(self) -> bool:
        """Nothing more is to be asked for."""
        return not self.journey.steps[self.place] and not self.asking

    @property
    def ahead(self) -> int:
        """Routes set whose signals the train has not passed."""
        return len(self.granted) - self.at

    @property
    def set_out(self) -> bool:
        """A route has been set for it."""
        return bool(self.granted)

    @property
    def coming(self) -> bool:
        """Nothing is set for it yet, and it comes from outside."""
        return not self.granted and bool(self.place.under) and self.place.under[0][1] == OUTSIDE

    @property
    def near(self) -> set[SectionId]:
        """The sections in which its train may be, or that are set for it."""
        found = {s for p in (self.places[max(0, self.at - 2) :], [self.place]) for x in p for s, n in x.under if n}
        found |= {s for stage in self.granted[max(0, self.at - 1) :] for s in stage.sections}
        for p in (*self.places[:1], self.place):
            for b, n in p.under:
                approach = self.journey.railway.approach.get(b) if n == OUTSIDE else None
                if approach is not None and self.at < 2:
                    found.add(approach)
        return found

    def uses(self, line: frozenset[SectionId]) -> bool:
        """It is on a line, or set to run over it."""
        return any(not line.isdisjoint(s.sections) for s in self.granted[max(0, self.at - 1) :])

    def past(self, line: frozenset[SectionId]) -> bool:
        """It has run over a line and does not come to it any more."""
        todo, seen = [self.place], {self.place}
        while todo:
            for step in self.journey.steps[todo.pop()]:
                if any(not line.isdisjoint(r.section_ids) for r in step.routes):
                    return False
                if step.after not in seen:
                    seen.add(step.after)
                    todo.append(step.after)
        return not self.uses(line)

    def through(self, seen: Indications) -> bool:
        """The train has passed all its signals and left all but the place where it may stay."""
        if not self.finished or self.ahead:
            return False
        stay = {s for s, _ in self.place.under}
        return all(
            seen.get(n, 0) for stage in self.granted[-2:] for s, n in stage.clear.items() if s not in stay
        ) and not any(seen.get(n, 0) for stage in self.granted[-2:] for s, n in stage.locked.items() if s not in stay)
