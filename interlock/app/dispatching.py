"""The dispatcher on the controller with its plant: trains come, are commanded, and run as lamps tell them."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import field

from interlock.dataclass import dataclass
from interlock.dispatch import Dispatcher
from interlock.dispatch.dispatcher import waiting
from interlock.dispatch.plan.errands import OUTSIDE, Errand
from interlock.dispatch.plan.railway import Railway
from interlock.logic.controller import Controller
from interlock.logic.lower import lower
from interlock.logic.names import Name
from interlock.logic.symbols import lamps
from interlock.model.elements import SectionId, SignalId
from interlock.model.layout import Layout
from interlock.proof.system.loop import closed_loop
from interlock.sim.lanes import Driver, Lane, Lanes, Wish
from interlock.sim.line import Lines
from interlock.sim.trains import Rails, Train
from interlock.table.rows import InterlockingTable

DT_MS = 2_000
"""Milliseconds from scan to scan, on which all delays of the controller count."""

QUIET = 400
"""Scans in which no train moves after which all that have not come home stand for ever: longer than any delay."""

SLEEP_MS = 10_000
"""While the panel shows the same and nothing is asked, the dispatcher looks at it so often."""

LONGEST = 20_000
"""Scans after which a run is given up (our choice)."""


@dataclass(frozen=True)
class Coming:
    """A command and the train that it is for: when it is given, when the train comes, in scans; metres a scan."""

    errand: Errand
    commanded: int = 0
    due: int = 0
    speed_m: float = 11.0
    priority: int = 0
    voyage: str = ""


@dataclass
class Outcome:
    """How a run ended.  asked: train and route of each request granted.  stuck: trains that stand for ever, and why."""

    stuck: dict[str, str] = field(default_factory=dict)
    scans: int = 0
    asked: tuple[tuple[str, str], ...] = ()
    said: tuple[str, ...] = ()
    refused: int = 0
    troubles: tuple[str, ...] = ()
    ahead: int = 0
    """The most routes that were set ahead of a train that had not passed their signals."""
    plans: list[tuple[tuple[tuple[str, str], ...], tuple[tuple[str, str], ...]]] = field(default_factory=list)
    """Every plan that was held: what had been granted before, and the plan."""


class Seen(Mapping[str, int]):
    """What a panel sees of a run: inputs as sampled, outputs as shown."""

    def __init__(self, lane: Lane) -> None:
        self.lane = lane

    def __getitem__(self, name: str) -> int:
        lanes = self.lane.lanes
        value = lanes.state[name] if name in lanes.state else lanes.last[name]
        return 1 if value & self.lane.bit else 0

    def get(self, name: str, default: int = 0) -> int:  # type: ignore[override]
        """The same, where it is known."""
        lanes = self.lane.lanes
        value = lanes.state.get(name)
        if value is None:
            value = lanes.last.get(name)
            if value is None:
                return default
        return 1 if value & self.lane.bit else 0

    def __iter__(self) -> Iterator[str]:
        return iter({**self.lane.lanes.last, **self.lane.lanes.state})

    def __len__(self) -> int:
        return len({**self.lane.lanes.last, **self.lane.lanes.state})


class Ground:
    """A layout with its controller and plant, on which runs take their steps side by side.  blocked: sections that the
    operator keeps blocked all the time."""

    def __init__(
        self,
        layout: Layout,
        table: InterlockingTable,
        controller: Controller | None = None,
        blocked: Iterable[str] = (),
    ) -> None:
        self.layout, self.table = layout, table
        self.controller = controller or lower(layout, table)
        self.railway = Railway(table, layout)
        self.rails = Rails(layout)
        self.lines = Lines(layout, self.controller.symbols)
        self.lanes = Lanes(self.controller, closed_loop(layout, self.controller).plant, DT_MS)
        sym = self.controller.symbols
        names: Mapping[str, str] = sym.sections.blocked  # type: ignore[assignment]
        self._blocked = {names[s]: 1 for s in blocked if s in names}
        self._watched = [
            *sym.sections.clear.values(),
            *sym.indication.values(),
            *lamps(sym.aspects),
            sym.requests.seen[sym.requests.request],
        ]
        self._before: dict[str, int] = {}
        self._clock, self._changed = -1, 0

    def run(self, runs: Sequence[Sequence[Coming]], make: Callable[[], Dispatcher] | None = None) -> list[Outcome]:
        """Each set of commands on a railway of its own, from the restart on.  All trains come from outside, or stand in
        the layout at first."""
        found = [Outcome() for _ in runs]
        make = make or (lambda: Dispatcher(self.railway, self.controller.symbols))
        starts: list[dict[str, int]] = []
        for comings in runs:
            state: dict[str, int] = {}
            for c in comings:
                if c.errand.start[0][1] != OUTSIDE:
                    ways = [self.rails.topo.traversals[s][n - 1] for s, n in c.errand.start]
                    state |= self.rails.lying(ways)
            starts.append(state)

        def driver(comings: Sequence[Coming], outcome: Outcome) -> Callable[[Lane], Driver]:
            return lambda lane: self._drive(lane, comings, make(), outcome)

        self.lanes.run(starts, [driver(c, o) for c, o in zip(runs, found, strict=True)])
        return found

    def changed(self, lane: Lane, scan: int) -> bool:
        """Whether a panel shows anything else than in the scan before; compared once for all runs."""
        if scan != self._clock:
            lanes = self.lanes
            now: dict[str, int] = {n: lanes.state[n] if n in lanes.state else lanes.last[n] for n in self._watched}
            self._changed = 0
            for n, v in now.items():
                self._changed |= v ^ self._before.get(n, ~v)
            self._before, self._clock = now, scan
        return bool(self._changed & lane.bit)

    def train(self, c: Coming) -> Train:
        """The train of a command."""
        train = Train(c.errand.train, c.errand.length_m, c.speed_m, due=c.due)
        if c.errand.start[0][1] == OUTSIDE:
            train.under.append(self.rails.before(str(c.errand.start[0][0])))
            train.there = False
        else:
            train.under += [self.rails.spot(self.rails.topo.traversals[s][n - 1]) for s, n in c.errand.start]
            train.done = train.under[-1].metres
        return train

    def _drive(self, lane: Lane, comings: Sequence[Coming], dispatcher: Dispatcher, outcome: Outcome) -> Driver:
        rails = self.rails
        trains = {c.errand.train: self.train(c) for c in comings}
        todo = sorted(comings, key=lambda c: c.commanded)
        yield Wish((), {"RELALL": 1})
        yield Wish((), {"RELALL": 1})
        seen, quiet, held = Seen(lane), 0, None
        slept, inputs = 0, dict[str, int]()
        for scan in range(LONGEST):
            slept += DT_MS
            fresh = self.changed(lane, scan)
            while todo and todo[0].commanded <= scan:
                c = todo.pop(0)
                dispatcher.carry_out(c.errand, c.priority, c.voyage)
                fresh = True
            if fresh or any(inputs.values()) or slept >= SLEEP_MS:
                inputs, slept = dispatcher.step(seen, slept), 0
            if dispatcher.holding.plan != held:
                held = dispatcher.holding.plan
                outcome.plans.append((tuple(dispatcher.journal.asked), held))
            outcome.ahead = max(outcome.ahead, max((r.way.ahead for r in dispatcher.runs), default=0))
            while dispatcher.journal.steps:
                name, section, turned = dispatcher.journal.steps.pop(0)
                run = next(r for r in dispatcher.runs if r.name == name)
                self.changes_ends(trains[name], section, turned, run.way.granted[run.way.at].entry)
            if not dispatcher.runs and not dispatcher.pending and not todo:
                break
            before = [(t.done, t.due, len(t.under)) for t in trains.values()]
            wishes = self._wishes(lane, trains.values())
            events, told = self.lines.scan(lane, [*trains.values()])
            yield Wish((*wishes, *events), {**told, **self._blocked, **{k: v for k, v in inputs.items() if v}})
            for t in trains.values():
                rails.moved(lane, t)
            moves = before != [(t.done, t.due, len(t.under)) for t in trains.values()] or todo
            quiet = 0 if moves else quiet + 1
            if quiet > QUIET:
                break
        outcome.scans = scan
        why = waiting(dispatcher)
        outcome.stuck = {
            r.name: why.get(r.name, "its signal does not open") for r in (*dispatcher.runs, *dispatcher.pending)
        }
        outcome.asked, outcome.said = tuple(dispatcher.journal.asked), tuple(dispatcher.journal.said)
        outcome.refused, outcome.troubles = dispatcher.holding.refused, tuple(lane.troubles())
        return None

    def changes_ends(self, train: Train, section: SectionId, turned: bool, entry: SignalId) -> None:
        """A train changes ends in a section for a route over a signal, or does not; one that stands there looks where
        the signal is, as it may have turned for a route that was taken back, or not yet."""
        head = train.under[-1]
        if train.there and head.section == section:
            turned = head.exit != self.layout.signalling.signal[entry].node
        train.turns = train.turns | {section} if turned else train.turns - {section}

    def _wishes(self, lane: Lane, trains: Iterable[Train]) -> list[Name]:
        """What all trains do; of several that come to one boundary, the first that is not in yet."""
        found: list[Name] = []
        before: set[str] = set()
        for t in trains:
            if not t.there and t.under[0].section in before:
                t.due = max(1, t.due)
            found += self.rails.wishes(lane, t)
            before |= {s.section for s in t.under if s.metres == 0}
        return found
