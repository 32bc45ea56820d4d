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
    entering: Stage | None = None
    """The route into which its head has come, until the section in rear is clear."""
    by_hand: bool = False
    """What is set for it is being taken back by somebody else: it is not asked for again."""
    reopened: int = 0
    """How often a route that had closed was asked for again."""
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
        found |= {s for stage in self.granted[max(0, self.at - 1) : self.at] for s in stage.out}  # it runs out there
        for p in (*self.places[:1], self.place):
            for b, n in p.under:
                approach = self.journey.railway.approach.get(b) if n == OUTSIDE else None
                if approach is not None and self.at < 2:
                    found.add(approach)
        return found

    def not_passed(self, seen: Indications) -> bool:
        """What was taken for its head was none: its route is clear again, and the section in rear was never clear
        meanwhile.  A train leaves that first, and is in the next section when the first becomes clear."""
        stage = self.entering
        if stage is None or stage.entered(seen):
            if stage is not None and not stage.shown.stands(seen):
                self.entering = None
            return False
        self.entering = None
        on = self.granted[self.at].entered(seen) if self.ahead else False
        there = on or not all(seen.get(n, 0) for n in stage.shown.clear.values())
        return stage.shown.rear is not None and stage.shown.stands(seen) and bool(self.at) and not there

    def wanted(self, seen: Indications) -> set[SectionId]:
        """The sections ahead of its train in the route over which it runs, and those of routes set for it and not being
        taken back."""
        end = self.at if self.cancelling else len(self.granted)
        found = {s for stage in self.granted[self.at : end] for s in stage.sections}
        if self.at:
            last = self.granted[self.at - 1]
            there = [k for k, s in enumerate(last.sections) if not seen.get(last.shown.clear.get(s, ""), 1)]
            found |= set(last.sections[max(there) + 1 :] if there else last.sections)
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
        last = [stage.shown for stage in self.granted[-2:]]
        left = all(seen.get(n, 0) for told in last for s, n in told.clear.items() if s not in stay)
        return left and not any(seen.get(n, 0) for told in last for s, n in told.locked.items() if s not in stay)
