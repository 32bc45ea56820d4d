"""Availability: two routes that are not hostile can be used at the same time, and a route opens when it is asked for.

A controller that never lets two signals be open at once is safe and of no use, and no claim of safety would tell.  So
for every two routes that the table does not call hostile runs on the same controller and plant show: both are set, both
signals are open at the same time, both are driven, one after the other in either order and side by side; no signal
closes before its own train has passed it; and afterwards everything is free again.  And for every route: asked for
while its conditions hold, its signal opens within a number of scans that is known beforehand (`opening.py`).

Not every two routes have a train each.  Where one begins in the section in which the other ends, one train takes both.
Where the train of one would stand in a section that the other needs clear, or where both begin in one section, there is
one train at a time: it is driven while the other signal stays open, and the other route is given back.

**Theorem.**  As of witnesses: a run that went well shows that both routes can be used so; that none of those tried went
well shows nothing, and is called a failure.  (Clarke, Grumberg and Peled, *Model Checking*, 1999.)
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from enum import StrEnum
from functools import partial
from itertools import pairwise

from interlock.dataclass import dataclass
from interlock.logic import names
from interlock.logic.symbols import RouteSymbols
from interlock.model.elements import Position, RouteId, SectionId
from interlock.model.foul import Foul
from interlock.proof.induction.search import Frame
from interlock.proof.induction.story import Story, narrated
from interlock.proof.system.loop import ClosedLoop
from interlock.proof.system.relation import TransitionRelation
from interlock.proof.witnesses import opening
from interlock.proof.witnesses.routes import (
    FEEDERS,
    _attempt,
    _before,
    _end,
    _leaves,
    _lying,
    _over_others,
    _stand,
    _start,
)
from interlock.proof.witnesses.together import (
    BEFORE,
    REFUSED,
    How,
    PairRun,
    lone_request,
    opens_alone,
    pair_run,
    settling,
    to_move,
    turned,
)
from interlock.sim.lanes import Driver, Lane, Lanes
from interlock.table.rows import InterlockingTable

ZONE_FULL = f"{REFUSED}not no more than"
BATCH = 2048  # so many runs are carried out side by side


class Manner(StrEnum):
    """What a pair of routes is tried with."""

    BESIDE = "a train each"
    AFTER = "one train for both"
    ALONE = "one train at a time"
    ZONE = "kept apart by a zone"
    CLEAR = "kept apart by a section that the author demands clear"
    NONE = "no train can take one of them"


@dataclass(frozen=True)
class PairResult:
    """What became of two routes; `failure`: what went wrong in the first run that failed, or None; `apart`: why their
    trains cannot be where they would have to be for more than what was run, or None."""

    first: str
    second: str
    manner: Manner
    runs: int
    failure: str | None = None
    failed: PairRun | None = None
    apart: str | None = None


@dataclass(frozen=True)
class Opened:
    """The bound of a route, and what a run showed: scans with every machine in place, and with those moved that the
    train does not stand on; None where no train can stand before the signal since a restart."""

    bound: opening.Opening
    seen: tuple[int, int] | None
    failure: str | None


@dataclass(frozen=True)
class Availability:
    """Every route and every pair."""

    routes: tuple[Opened, ...]
    pairs: tuple[PairResult, ...]
    hostile: int

    @property
    def runs(self) -> int:
        """Runs of pairs."""
        return sum(p.runs for p in self.pairs)

    @property
    def shown(self) -> bool:
        """Nothing failed."""
        return all(p.failure is None for p in self.pairs) and all(r.failure is None for r in self.routes)


def availability(railway: ClosedLoop, table: InterlockingTable) -> Availability:
    """Runs for every route and for every two routes that the table does not call hostile."""
    trial = Trial(railway)
    pairs = list(compatible(railway, table))
    planned = [(a, b, *trial.plan(a, b)) for a, b in pairs]
    results = trial.results(planned)
    for otherwise in (trial.apart, trial.empty):
        unmet = [i for i, x in enumerate(results) if x.failed is not None and not trial.meet(x.failed)]
        for i, x in zip(unmet, trial.results([otherwise(*pairs[i]) for i in unmet]), strict=True):
            results[i] = replace(x, apart=results[i].apart or results[i].failure)
    clear = {r.id: {c.section for c in r.clear.demanded or ()} for r in table.routes}
    asked = {i: p for i, x in enumerate(results) if x.failure and (p := trial.demanded(*pairs[i], clear)) is not None}
    for (i, _), x in zip(asked.items(), trial.results([*asked.values()]), strict=True):
        results[i] = replace(x, apart=results[i].apart or results[i].failure)
    count = len(railway.controller.symbols.routes.whole)
    return Availability(trial.opened(), tuple(results), count * (count - 1) // 2 - len(pairs))


def compatible(railway: ClosedLoop, table: InterlockingTable) -> Iterator[tuple[RouteSymbols, RouteSymbols]]:
    """Every two routes that are not hostile."""
    routes = railway.controller.symbols.routes.whole
    for i, a in enumerate(routes):
        hostile = set(table.route[a.id].locking.hostile.routes)
        yield from ((a, b) for b in routes[i + 1 :] if b.id not in hostile)


Plan = tuple[RouteSymbols, RouteSymbols, Manner, list[PairRun]]
"""Two routes, how they are tried, and the runs."""


@dataclass(frozen=True)
class _Failure:
    """What went wrong in a run."""

    text: str
    standing: bool = False
    """The route was refused because of where the trains stand: it is refused too while the other one is not set."""

    counted: bool = False
    """A zone was full, and a train counts twice there."""

    moved: bool = False
    """The route was refused because of points that a train's way to its signal has left otherwise."""

    @property
    def coming(self) -> bool:
        """It was about how trains came to be where they are: over other routes, or there since a restart."""
        return self.standing or self.counted or self.moved or self.text.startswith(BEFORE) or "the restart" in self.text


class Trial:
    """The runs of one controller with its plant."""

    def __init__(self, railway: ClosedLoop) -> None:
        self.railway = railway
        self._lanes = Lanes(self.railway.controller, self.railway.plant)
        self._comes = self._find_trains()
        self._unmet: set[PairRun] = set()
        self._needs = {r.id: _needs_clear(railway, r) for r in railway.controller.symbols.routes.whole}

    def _find_trains(self) -> dict[RouteId, list[tuple[RouteSymbols, ...]]]:
        """For each route the ways in which its train can come before the signal, each as the routes over which it
        comes; none of them for one that stands there since the restart.  Standing first, then over one route, then over
        as few as it takes."""
        routes = self.railway.controller.symbols.routes.whole
        found: dict[RouteId, list[tuple[RouteSymbols, ...]]] = {r.id: [] for r in routes}
        tried = _attempt(self.railway, self._lanes, [(r, "", ()) for r in routes])
        for r, (failure, _) in zip(routes, tried, strict=True):
            if failure is None:
                found[r.id].append(())
        ends: dict[str, list[RouteSymbols]] = {}
        for r in routes:
            if found[r.id] and not r.call_on and not _leaves(self.railway, r):
                ends.setdefault(_end(self.railway, r)[0], []).append(r)
        runs = [(x, r) for r in routes for x in ends.get(_before(self.railway, r), ())[:FEEDERS] if x is not r]
        for (x, r), (failure, _) in zip(
            runs, _attempt(self.railway, self._lanes, [(x, "", (r,)) for x, r in runs]), strict=True
        ):
            if failure is None:
                found[r.id].append((x,))
        for name, (chain, _) in _over_others(self.railway, self._lanes, [r for r in routes if not found[r.id]]).items():
            found[name].append(chain[:-1])
        return found

    def plan(self, a: RouteSymbols, b: RouteSymbols) -> tuple[Manner, list[PairRun]]:
        """The manner in which two routes are tried, and the runs."""
        railway = self.railway
        if not self._comes[a.id] or not self._comes[b.id]:
            return Manner.NONE, []
        if any(self._full(z, a, b) for z in range(len(railway.layout.declared.zones))):
            return Manner.ZONE, []
        onward = [
            (x, y)
            for x, y in ((a, b), (b, a))
            if _goes_on(railway, x, y) and _before(railway, x) not in self._needs[y.id]
        ]
        if onward:
            return Manner.AFTER, [self._run(x, y, How.ONWARD) for x, y in onward]
        rear = {r.id: _before(railway, r) for r in (a, b)}
        if rear[a.id] == rear[b.id] or self._standing(a, b) is None or len(self._alone(a, b)) < 2:
            return self.apart(a, b)[2:]
        return Manner.BESIDE, [
            self._run(a, b, How.THEN),
            self._run(b, a, How.THEN),
            self._run(a, b, How.TOGETHER),
        ]

    def demanded(self, a: RouteSymbols, b: RouteSymbols, clear: Mapping[RouteId, set[SectionId]]) -> Plan | None:
        """A run without trains, where the author has one of two routes, or what is set with it past signals, find a
        section clear over which the train of the other one comes, so that its signal may fall to stop before it.

        None is run where one calls a train on: vehicles may stand where the other one is to find it clear.
        """
        parts = self.railway.controller.symbols.routes.parts
        for x, y in ((a, b), (b, a)):
            wanted = set[SectionId]().union(*(clear.get(RouteId(p.id), set()) for p in parts(x)))
            over = {_before(self.railway, y), *(s for p in parts(y) for s, _ in p.path.ways)}
            over |= {p.path.berth[0] for p in parts(y) if p.path.berth is not None}
            if wanted & over:
                return a, b, Manner.CLEAR, [] if a.call_on or b.call_on else [self._run(a, b, How.GIVEN_BACK)]
        return None

    def apart(self, a: RouteSymbols, b: RouteSymbols) -> Plan:
        """Runs of two routes with one train at a time."""
        runs = [self._run(x, y, How.ALONE) for x, y in self._alone(a, b)]
        return (a, b, Manner.ALONE, runs) if runs else self.empty(a, b)

    def empty(self, a: RouteSymbols, b: RouteSymbols) -> Plan:
        """A run of two routes without trains."""
        return a, b, Manner.ALONE, [self._run(a, b, How.GIVEN_BACK)]

    def _alone(self, a: RouteSymbols, b: RouteSymbols) -> list[tuple[RouteSymbols, RouteSymbols]]:
        """Those of two routes, first, whose train may stand before its signal while the other one is set."""
        return [
            (x, y)
            for x, y in ((a, b), (b, a))
            if _before(self.railway, x) not in self._needs[y.id] and not self._on_points_of(x, y)
        ]

    def _run(self, first: RouteSymbols, second: RouteSymbols, how: How, choice: tuple[int, int] = (0, 0)) -> PairRun:
        run = PairRun(first, second, how)
        before: list[tuple[RouteSymbols, ...]] = []
        for r, k in zip((first, second), choice, strict=True):
            comes = self._comes[r.id]
            before.append(comes[min(k, len(comes) - 1)] if r in run.trains and comes else ())
        return PairRun(first, second, how, (before[0], before[1]))

    def otherwise(self, run: PairRun) -> list[PairRun]:
        """The same with trains that come before their signals in other ways."""
        first, second = (max(1, len(self._comes[r.id])) if r in run.trains else 1 for r in (run.first, run.second))
        choices = [(i, k) for i in range(first) for k in range(second) if i or k]
        return [self._run(run.first, run.second, run.how, choice) for choice in choices]

    def _full(self, zone: int, a: RouteSymbols, b: RouteSymbols) -> bool:
        """Whether a zone does not admit the trains of both routes, where they stand or are called.

        Where a train is called on, vehicles may stand in each section of its route: all of them count, and so do the
        sections of an overlap (R17).
        """
        z = self.railway.layout.declared.zones[zone]
        trains = 0
        for r in (a, b):
            over = [_before(self.railway, r), *(s for s, _ in r.path.ways)]
            trains += over[0] in z.sections
            trains += sum(y in z.sections and (r.call_on or x not in z.sections) for x, y in pairwise(over))
            trains += sum(s in z.sections for s, _ in self._overlap(r))
        return trains > z.trains

    def _overlap(self, r: RouteSymbols) -> tuple[tuple[SectionId, int], ...]:
        """Of a route that leads past signals the overlaps of those signals, too."""
        symbols = self.railway.controller.symbols.routes
        held = [x.path.overlap for x in symbols.parts(symbols.number[r.number])]
        return tuple(way for o in held if o is not None for way in self.railway.controller.symbols.overlaps.ways[o])

    def _standing(self, *routes: RouteSymbols) -> dict[str, int] | None:
        """Trains before some signals, points lying under them as they stand; None if they would lie both ways."""
        state: dict[str, int] = {}
        for r in routes:
            stands = (
                _stand(self.railway, _before(self.railway, r), self.railway.layout.signalling.signal[r.entry].node)
                or {}
            )
            if any(state.get(name, value) != value for name, value in stands.items()):
                return None
            state |= stands
        return state

    def _on_points_of(self, a: RouteSymbols, b: RouteSymbols) -> bool:
        """Whether the train before one route stands on points that the other one needs otherwise."""
        stands = self._standing(a) or {}
        return any(stands.get(name, value) != value for name, value in _lying(self.railway, b).items())

    def results(self, planned: Sequence[Plan]) -> list[PairResult]:
        """What becomes of pairs."""
        outcomes = iter(self._outcomes([x for _, _, _, runs in planned for x in runs]))
        found = []
        for a, b, manner, runs in planned:
            tried = [(x, next(outcomes)) for x in runs]
            went_wrong = [(x, failure.text) for x, failure in tried if failure is not None]
            failed, why = min(went_wrong, key=lambda y: not self.meet(y[0]), default=(None, None))
            why = str(manner) if manner is Manner.NONE else why
            found.append(PairResult(a.id, b.id, manner, len(runs), why, failed))
        return found

    def meet(self, run: PairRun) -> bool:
        """Whether the trains of a run that failed can be where they have to be at the same time, however they come."""
        return run not in self._unmet

    def _outcomes(self, runs: Sequence[PairRun]) -> list[_Failure | None]:
        """What went wrong in each run, or None.

        A route may be refused because of how its train, or the other one, came to be where it is: one that stands there
        since a restart might stand astride a joint, one that comes later has to pass the other.  Then the run is tried
        with trains that come otherwise.
        """
        found = self._once(runs)
        again = [
            (i, x) for i, why in enumerate(found) if why is not None and why.coming for x in self.otherwise(runs[i])
        ]
        for (i, _), why in zip(again, self._once([x for _, x in again]), strict=True):
            before = found[i]
            if before is not None and before.coming:
                found[i] = why
        self._unmet |= {x for x, why in zip(runs, found, strict=True) if why is not None and why.coming}
        return found

    def _moved_otherwise(self, run: PairRun, r: RouteSymbols, text: str) -> bool:
        """The machine for which the route is refused was left otherwise by the last route that a train came over and
        that demands it: it may not move once the other route has locked its section."""
        symbols = self.railway.controller.symbols
        left = {m: x for chain in run.before for y in chain for m, x in opening.demanded(symbols, y)}
        wanted = opening.demanded(symbols, r)
        return any(left.get(m, x) is not x and f"{REFUSED}not {m} {x}:" in text for m, x in wanted)

    def _counted_twice(self, run: PairRun) -> bool:
        """A train stands in a zone since a restart, or turns about there: it counts where it stands, and where its
        route leads (R17)."""
        zones = self.railway.layout.declared.zones
        chains = zip(run.trains, run.before, strict=False)
        twice = [r for r, chain in chains if not chain or not self._straight_on(chain[-1], r)]
        return any(_before(self.railway, r) in z.sections for r in twice for z in zones)

    def _straight_on(self, a: RouteSymbols, b: RouteSymbols) -> bool:
        """A train that has run one route stands before the signal of the other without turning about."""
        section, number = a.path.ways[-1]
        return (
            self.railway.topo.traversals[section][number - 1].exit
            == self.railway.layout.signalling.signal[b.entry].node
        )

    def _once(self, runs: Sequence[PairRun]) -> list[_Failure | None]:
        found: list[_Failure | None] = []
        for at in range(0, len(runs), BATCH):
            some = runs[at : at + BATCH]
            drivers = [partial(pair_run, self.railway, x) for x in some]
            done = self._lanes.run([self.start(x) for x in some], drivers)
            found += [
                None if text is None else _Failure(text, counted=ZONE_FULL in text and self._counted_twice(x))
                for x, (text, _) in zip(some, done, strict=True)
            ]
        refused = [
            (i, r)
            for i, (run, why) in enumerate(zip(runs, found, strict=True))
            for r in ((run.first, run.second) if why is not None and run.trains else ())
            if why is not None and why.text.startswith(f"{r.id}: {REFUSED}")
        ]
        drivers = [partial(lone_request, self.railway, runs[i], r) for i, r in refused]
        done = self._lanes.run([self.start(runs[i]) for i, _ in refused], drivers)
        for (i, r), (text, _), why in zip(refused, done, [found[i] for i, _ in refused], strict=True):
            if why is not None:
                found[i] = replace(why, standing=text is not None, moved=self._moved_otherwise(runs[i], r, why.text))
        return found

    def story(self, result: PairResult, relation: TransitionRelation) -> Story | None:
        """The run that failed, for the player, with the state and inputs of each step; None where nothing was tried."""
        if result.failed is None or result.failure is None:
            return None
        failed, frames = result.failed, list[Frame]()

        def recorded(lane: Lane) -> Driver:
            run = pair_run(self.railway, failed, lane)
            while True:
                try:
                    wish = next(run)
                except StopIteration as end:
                    failure: str | None = end.value
                    return failure
                yield wish
                last = lane.lanes.last
                state: dict[str, int] = {n: last.get(n, 0) for n in relation.state}
                frames.append(Frame(state, {n: _read(lane, n) for n in relation.inputs}))

        self._lanes.run([self.start(failed)], [recorded])
        frames.append(Frame({n: self._lanes.state.get(n, 0) for n in relation.state}, {}))
        place = f"{result.first} and {result.second}"
        sentence = "Two routes that are not hostile can be set, open, driven and released at the same time."
        ending = [f"{failed.first.id} and {failed.second.id}, {failed.how}: {result.failure}."]
        return narrated(self.railway, frames, ("AVAILABILITY", place, sentence), ending)

    def start(self, run: PairRun) -> dict[str, int]:
        """The restart with the trains of a run, points lying for it where no train stands on them: a point that one
        route needs may not move once the other has locked its section (IL7011)."""
        trains = zip((run.first, run.second), run.before, strict=True)
        from_ = [chain[0] if chain else r for r, chain in trains if r in run.trains]
        state: dict[str, int] = {}
        for r in (*from_, run.first, run.second):
            state = _lying(self.railway, r) | state
        for r in (run.first, run.second):
            state = _lying(self.railway, r, overlap=True) | state
        return self._leading_away(run) | state | (self._standing(*from_) or {})

    def _leading_away(self, run: PairRun) -> dict[str, int]:
        """Points that decide whether something is foul of a route of the run (R6, R7) lead away from it: where neither
        route holds such a point, the two can be used together only while it lies so."""
        ways = [way for r in (run.first, run.second) for way in (*r.path.ways, *self._overlap(r))]
        fouled = [self.railway.topo.traversals[s][n - 1] for s, n in ways]
        beside: list[Foul] = [
            *self.railway.measured.fouls,
            *self.railway.measured.crossed,
            *self.railway.measured.beside,
        ]
        when = [x.when for x in beside if x.when is not None and any(map(x.fouls, fouled))]
        return {names.LIES(m, to): int(to is not x) for m, x in when for to in Position}

    def opened(self) -> tuple[Opened, ...]:
        """For each route its bound, and what runs show: with every machine in place, and with the others moved."""
        railway = self.railway
        routes = [r for r in railway.controller.symbols.routes.whole if () in self._comes[r.id] and not r.call_on]
        seen: dict[RouteId, list[int]] = {r.id: [] for r in routes}
        why: dict[RouteId, str] = {}
        for move in (False, True):
            starts, moved = [], []
            for r in routes:
                start = _start(railway, r, "")
                assert isinstance(start, dict)
                away = turned(railway, r, self._standing(r) or {}) if move else {}
                starts.append(start | away)
                moved.append(to_move(railway, r, start | away))
            drivers = [partial(opens_alone, railway, r, n) for r, n in zip(routes, moved, strict=True)]
            for r, (failure, n) in zip(routes, self._lanes.run(starts, drivers), strict=True):
                seen[r.id].append(n - len(settling(railway, [r])))
                if failure is not None:
                    why[r.id] = failure
        return tuple(
            Opened(
                opening.opening(railway, r),
                (seen[r.id][0], seen[r.id][1]) if r.id in seen else None,
                why.get(r.id) or (None if self._comes[r.id] else "no train can take it"),
            )
            for r in railway.controller.symbols.routes.whole
        )


def _read(lane: Lane, name: str) -> int:
    """What an input or choice was in the last step of a single run."""
    size = lane.lanes.sizes.get(name)
    last = lane.lanes.last
    return last.get(name, 0) if size is None else next((k for k in range(1, size) if last[f"{name}={k}"]), 0)


def _goes_on(railway: ClosedLoop, a: RouteSymbols, b: RouteSymbols) -> bool:
    """Whether a train at the end of one route stands before the other's signal, turned about or not."""
    if _leaves(railway, a) or _end(railway, a)[0] != _before(railway, b):
        return False
    section, number = a.path.ways[-1] if a.path.berth is None else a.path.berth
    t = railway.topo.traversals[section][number - 1]
    return railway.layout.signalling.signal[b.entry].node in (t.entry, t.exit)


def _needs_clear(railway: ClosedLoop, r: RouteSymbols) -> frozenset[str]:
    """The sections in which nothing can stand while a route is set: path, berth, overlap, foul of them, line beyond."""
    over = () if r.path.overlap is None else railway.controller.symbols.overlaps.ways[r.path.overlap]
    ways = [
        railway.topo.traversals[s][n - 1]
        for s, n in (*r.path.ways, *over, *([r.path.berth] if r.path.berth is not None else []))
    ]
    found: set[str] = {t.section for t in ways}
    beside: list[Foul] = [*railway.measured.fouls, *railway.measured.crossed, *railway.measured.beside]
    found |= {x.neighbour for x in beside for t in ways if x.fouls(t)}
    if _leaves(railway, r):
        boundary = railway.layout.track.boundary_at[_end(railway, r)[1]]
        found |= {boundary.approach or names.outside(boundary.node)}
    return frozenset(found)
