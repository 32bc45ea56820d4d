"""A command being carried out: where its train has come to, what is set for it, what is asked for."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping
from dataclasses import field

from interlock.dataclass import dataclass
from interlock.dispatch.panel import Indications, Stage
from interlock.dispatch.plan.errands import OUTSIDE, Place, Step
from interlock.dispatch.plan.railway import Journey
from interlock.model.elements import SectionId, SignalId


@dataclass(eq=False)
class SetRoutes:
    """The routes set for a train: `granted` so far, in the order of travel; `places`: where it stands before each;
    `at`: how many of their signals it has passed; `opened`: which of them have shown proceed."""

    granted: list[Stage] = field(default_factory=list)
    places: list[Place] = field(default_factory=list)
    at: int = 0
    opened: set[int] = field(default_factory=set)
    entering: Stage | None = None
    """The route into which its head has come, until the section in rear is clear."""
    shut_ms: int = 0
    """For how long the next one has not shown proceed."""
    reopened: int = 0
    """How often a route that had closed was asked for again."""
    cancelling: bool = False
    by_hand: bool = False
    """What is set is being taken back by somebody else: it is not asked for again."""
    given_up: Place | None = None
    """Where its train stands and was seen to have given up its overlap, which who comes behind it does not undo."""

    @property
    def ahead(self) -> int:
        """Routes set whose signals the train has not passed."""
        return len(self.granted) - self.at

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
        """Its train is on a line, or to run over it."""
        return any(not line.isdisjoint(s.sections) for s in self.granted[max(0, self.at - 1) :])

    def left(self, seen: Indications, stay: set[SectionId]) -> bool:
        """The last two are clear and unlocked, but where the train may stay."""
        last = [stage.shown for stage in self.granted[-2:]]
        clear = all(seen.get(n, 0) for told in last for s, n in told.clear.items() if s not in stay)
        return clear and not any(seen.get(n, 0) for told in last for s, n in told.locked.items() if s not in stay)


@dataclass(eq=False)
class Asking:
    """What is asked for a train: `step`: the step that it takes next; `routes`: those that belong to a step of which
    some are set, in the order in which they are asked for."""

    routes: list[Stage] = field(default_factory=list)
    step: Step | None = None
    waited_ms: int = 0
    rest_ms: int = 0
    """For how long nothing is asked, since a route was refused."""


@dataclass(eq=False)
class Run:
    """A journey under way.  `place`: where its train stands when it has run over all that is set for it."""

    name: str
    journey: Journey
    priority: int = 0
    place: Place = field(init=False)
    way: SetRoutes = field(default_factory=SetRoutes)
    asking: Asking = field(default_factory=Asking)
    reason: str = ""
    caught: str = ""
    """That no plan exists with it, and why, as long as it is so."""
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
        return not self.journey.steps[self.place] and not self.asking.routes

    @property
    def coming(self) -> bool:
        """Nothing is set for it yet, and it comes from outside."""
        return not self.way.granted and bool(self.place.under) and self.place.under[0][1] == OUTSIDE

    @property
    def near(self) -> set[SectionId]:
        """The sections in which its train may be, or that are set for it."""
        way = self.way
        found = {s for p in (way.places[max(0, way.at - 2) :], [self.place]) for x in p for s, n in x.under if n}
        found |= {s for stage in way.granted[max(0, way.at - 1) :] for s in stage.sections}
        found |= {s for stage in way.granted[max(0, way.at - 1) : way.at] for s in stage.out}  # it runs out there
        for p in (*way.places[max(0, way.at - 1) :], self.place):  # the first of them: where it comes from
            for b, n in p.under:
                approach = self.journey.railway.approach.get(b) if n == OUTSIDE else None
                if approach is not None:
                    found.add(approach)
        return found

    def through(self, seen: Indications) -> bool:
        """The train has passed all its signals and left all but the place where it may stay."""
        return self.finished and not self.way.ahead and self.way.left(seen, {s for s, _ in self.place.under})


def ran(run: Run) -> list[SectionId]:
    """The sections over which a train has run that is of no known length, in order: its tail may be in any of them.  Of
    one that is known `near` tells where it is."""
    if run.journey.errand.length_m:
        return []
    approach = run.journey.railway.approach
    at = [approach.get(s) if n == OUTSIDE else s for p in run.way.places[:1] for s, n in p.under]
    return [s for s in at if s is not None] + [s for g in run.way.granted[: run.way.at] for s in g.sections]


def ways(
    runs: Iterable[Run], rear: Mapping[SignalId, SectionId | None], occupied: Collection[SectionId]
) -> list[tuple[SectionId, ...]]:
    """The sections of routes that are set and not yet run over, and those beyond a boundary to which they lead.

    rear: by signal, the section from which a route over it begins; one whose signal is passed begins where its train
    was last.  occupied: as seen in the scan before."""
    found = []
    for way in (r.way for r in runs):
        for k, stage in enumerate(way.granted[max(0, way.at - 1) :], max(0, way.at - 1)):
            sections = (*stage.sections, *stage.out)
            if k < way.at:
                here = max((i for i, s in enumerate(sections) if s in occupied), default=len(sections))
                found.append(sections[here:])
                continue
            before = rear.get(stage.entry)
            found.append(sections if before is None else (before, *sections))
    return found
