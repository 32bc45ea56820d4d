"""Availability: two routes that are not hostile can be used at the same time, and a route opens when it is asked for.

A controller that never lets two signals be open at once is safe and of no use, and no claim of safety would tell.  So
for every two routes that the table does not call hostile runs on the same controller and plant show: both are set, both
signals are open at the same time, both are driven, one after the other in either order and side by side; no signal
closes before its own train has passed it; and afterwards everything is free again.  And for every route: asked for
while its conditions hold, its signal opens within a number of scans that is known beforehand (`opening.py`).

Not every two routes have a train each.  Where one begins in the section in which the other ends, one train takes both.
Where the train of one would stand in a section that the other needs clear, or where both begin in one section, there is
one train at a time: it is driven while the other signal stays open, and the other route is given back.
"""

from __future__ import annotations

from collections.abc import Generator, Iterator, Sequence
from dataclasses import dataclass
from enum import StrEnum
from functools import partial
from itertools import pairwise

from interlock.logic.controller import RouteSymbols
from interlock.model.elements import NodeId, Position, RouteId, SectionId
from interlock.proof import opening
from interlock.proof.search import Frame
from interlock.proof.story import Story, narrated
from interlock.proof.system import System
from interlock.proof.witness import (
    FEEDERS,
    MAX_STEPS,
    Railway,
    _attempt,
    _before,
    _closing,
    _end,
    _failed_section,
    _kept,
    _leaves,
    _lying,
    _not,
    _over_others,
    _set,
    _stand,
    _start,
    _travel,
    _until,
)
from interlock.sim.lanes import NOTHING, Driver, Lane, Lanes, Wish
from interlock.table.rows import InterlockingTable

BEFORE = "before that, "
BATCH = 2048  # so many runs are carried out side by side


class Manner(StrEnum):
    """What a pair of routes is tried with."""

    BESIDE = "a train each"
    AFTER = "one train for both"
    ALONE = "one train at a time"
    ZONE = "kept apart by a zone"
    NONE = "no train can take one of them"


class How(StrEnum):
    """What happens in one run, once both signals are open."""

    THEN = "the first train, then the second"
    TOGETHER = "both trains at once"
    ONWARD = "one train over the first, then over the second"
    ALONE = "a train on the first; the second is given back"
    GIVEN_BACK = "both are given back"


@dataclass(frozen=True)
class PairRun:
    """One run of two routes.  `before`: routes over which each train comes to its signal from where it can stand."""

    first: RouteSymbols
    second: RouteSymbols
    how: How
    before: tuple[tuple[RouteSymbols, ...], tuple[RouteSymbols, ...]] = ((), ())

    @property
    def trains(self) -> tuple[RouteSymbols, ...]:
        """The routes that have a train of their own."""
        if self.how is How.GIVEN_BACK:
            return ()
        return (self.first,) if self.how in (How.ONWARD, How.ALONE) else (self.first, self.second)


@dataclass(frozen=True)
class PairResult:
    """What became of two routes; `failure`: what went wrong in the first run that failed, or None."""

    first: str
    second: str
    manner: Manner
    runs: int
    failure: str | None = None
    failed: PairRun | None = None


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


def availability(system: System, table: InterlockingTable) -> Availability:
    """Runs for every route and for every two routes that the table does not call hostile."""
    trial = Trial(system)
    pairs = list(compatible(system, table))
    planned = [(a, b, *trial.plan(a, b)) for a, b in pairs]
    results = trial.results(planned)
    unmet = [i for i, x in enumerate(results) if x.failed is not None and not trial.meet(x.failed)]
    for i, x in zip(unmet, trial.results([trial.apart(*pairs[i]) for i in unmet]), strict=True):
        results[i] = x
    count = len(system.symbols.routes)
    return Availability(trial.opened(), tuple(results), count * (count - 1) // 2 - len(pairs))


def compatible(system: System, table: InterlockingTable) -> Iterator[tuple[RouteSymbols, RouteSymbols]]:
    """Every two routes that are not hostile."""
    routes = system.symbols.routes
    for i, a in enumerate(routes):
        hostile = set(table.route[a.id].hostile.routes)
        yield from ((a, b) for b in routes[i + 1 :] if b.id not in hostile)


Plan = tuple[RouteSymbols, RouteSymbols, Manner, list[PairRun]]
"""Two routes, how they are tried, and the runs."""


@dataclass(frozen=True)
class _Failure:
    """What went wrong in a run."""

    text: str

    @property
    def coming(self) -> bool:
        """It was about how trains came to be where they are: over other routes, or there since a restart."""
        return self.text.startswith(BEFORE) or "the restart" in self.text


class Trial:
    """The runs of one system."""

    def __init__(self, system: System) -> None:
        self.system = system
        self.railway = Railway(system.controller, system.plant, system.layout)
        self._lanes = Lanes(self.railway.controller, self.railway.plant)
        self._comes = self._find_trains()
        self._unmet: set[PairRun] = set()
        self._needs = {r.id: _needs_clear(system, self.railway, r) for r in system.symbols.routes}

    def _find_trains(self) -> dict[RouteId, list[tuple[RouteSymbols, ...]]]:
        """For each route the ways in which its train can come before the signal, each as the routes over which it
        comes; none of them for one that stands there since the restart.  Standing first, then over one route, then over
        as few as it takes."""
        routes = self.system.symbols.routes
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
        by_id: dict[str, RouteSymbols] = {r.id: r for r in routes}
        for name, (chain, _) in _over_others(self.railway, self._lanes, [r for r in routes if not found[r.id]]).items():
            found[name].append(tuple(by_id[x] for x in chain))
        return found

    def plan(self, a: RouteSymbols, b: RouteSymbols) -> tuple[Manner, list[PairRun]]:
        """The manner in which two routes are tried, and the runs."""
        railway = self.railway
        if not self._comes[a.id] or not self._comes[b.id]:
            return Manner.NONE, []
        if any(self._full(z, a, b) for z in range(len(railway.layout.zones))):
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

    def apart(self, a: RouteSymbols, b: RouteSymbols) -> Plan:
        """Runs of two routes with one train at a time."""
        runs = [self._run(x, y, How.ALONE) for x, y in self._alone(a, b)]
        return a, b, Manner.ALONE, runs or [self._run(a, b, How.GIVEN_BACK)]

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
        """Whether a zone does not admit the trains of both routes, where they stand or are called."""
        z = self.railway.layout.zones[zone]
        trains = 0
        for r in (a, b):
            over = [_before(self.railway, r), *(s for s, _ in r.ways)]
            trains += over[0] in z.sections
            trains += sum(y in z.sections and x not in z.sections for x, y in pairwise(over))
        return trains > z.trains

    def _standing(self, *routes: RouteSymbols) -> dict[str, int] | None:
        """Trains before some signals, points lying under them as they stand; None if they would lie both ways."""
        state: dict[str, int] = {}
        for r in routes:
            stands = _stand(self.railway, _before(self.railway, r), self.railway.layout.signal[r.entry].node) or {}
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
            failed, why = next(((x, failure.text) for x, failure in tried if failure is not None), (None, None))
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

    def _once(self, runs: Sequence[PairRun]) -> list[_Failure | None]:
        found: list[_Failure | None] = []
        for at in range(0, len(runs), BATCH):
            some = runs[at : at + BATCH]
            drivers = [partial(pair_run, self.system, self.railway, x) for x in some]
            done = self._lanes.run([self.start(x) for x in some], drivers)
            found += [None if text is None else _Failure(text) for text, _ in done]
        return found

    def story(self, result: PairResult) -> Story | None:
        """The run that failed, for the player; None where nothing was tried."""
        if result.failed is None or result.failure is None:
            return None
        failed, frames = result.failed, list[Frame]()

        def recorded(lane: Lane) -> Driver:
            run = pair_run(self.system, self.railway, failed, lane)
            while True:
                try:
                    wish = next(run)
                except StopIteration as end:
                    failure: str | None = end.value
                    return failure
                yield wish
                last = lane.lanes.last
                state = {n: last.get(n, 0) for n in self.system.state}
                frames.append(Frame(state, {n: _read(lane, n) for n in self.system.inputs}))

        self._lanes.run([self.start(failed)], [recorded])
        frames.append(Frame({n: self._lanes.state.get(n, 0) for n in self.system.state}, {}))
        place = f"{result.first} and {result.second}"
        sentence = "Two routes that are not hostile can be set, open, driven and released at the same time."
        ending = [f"{failed.first.id} and {failed.second.id}, {failed.how}: {result.failure}."]
        return narrated(self.system, frames, ("AVAILABILITY", place, sentence), ending)

    def start(self, run: PairRun) -> dict[str, int]:
        """The restart with the trains of a run, points lying for it where no train stands on them."""
        trains = zip((run.first, run.second), run.before, strict=True)
        from_ = [chain[0] if chain else r for r, chain in trains if r in run.trains]
        state: dict[str, int] = {}
        for r in (*from_, run.first, run.second):
            state = _lying(self.railway, r) | state
        return state | (self._standing(*from_) or {})

    def opened(self) -> tuple[Opened, ...]:
        """For each route its bound, and what runs show: with every machine in place, and with the others moved."""
        railway, system = self.railway, self.system
        routes = [r for r in system.symbols.routes if () in self._comes[r.id] and not r.call_on]
        seen: dict[RouteId, list[int]] = {r.id: [] for r in routes}
        why: dict[RouteId, str] = {}
        for turned in (False, True):
            starts, moved = [], []
            for r in routes:
                start = _start(railway, r, "")
                assert isinstance(start, dict)
                away = _turned(system, r, self._standing(r) or {}) if turned else {}
                starts.append(start | away)
                moved.append(_to_move(system, r, start | away))
            drivers = [partial(_opens_alone, system, railway, r, n) for r, n in zip(routes, moved, strict=True)]
            for r, (failure, n) in zip(routes, self._lanes.run(starts, drivers), strict=True):
                seen[r.id].append(n - len(_settling(railway, [r])))
                if failure is not None:
                    why[r.id] = failure
        return tuple(
            Opened(
                opening.opening(system, r),
                (seen[r.id][0], seen[r.id][1]) if r.id in seen else None,
                why.get(r.id) or (None if self._comes[r.id] else "no train can take it"),
            )
            for r in system.symbols.routes
        )


def _read(lane: Lane, name: str) -> int:
    """What an input or choice was in the last step of a single run."""
    size = lane.lanes.sizes.get(name)
    last = lane.lanes.last
    return last.get(name, 0) if size is None else next((k for k in range(1, size) if last[f"{name}={k}"]), 0)


def _goes_on(railway: Railway, a: RouteSymbols, b: RouteSymbols) -> bool:
    """Whether a train at the end of one route stands before the other's signal, turned about or not."""
    if _leaves(railway, a) or _end(railway, a)[0] != _before(railway, b):
        return False
    section, number = a.ways[-1] if a.berth is None else a.berth
    t = railway.topo.traversals[section][number - 1]
    return railway.layout.signal[b.entry].node in (t.entry, t.exit)


def _needs_clear(system: System, railway: Railway, r: RouteSymbols) -> frozenset[str]:
    """The sections in which nothing can stand while a route is set: path, berth, overlap, foul of them, line beyond."""
    over = () if r.overlap is None else system.symbols.overlap_ways[r.overlap]
    ways = [system.topo.traversals[s][n - 1] for s, n in (*r.ways, *over, *([r.berth] if r.berth is not None else []))]
    found: set[str] = {t.section for t in ways}
    found |= {f.neighbour for f in system.measured.fouls for t in ways if f.fouls(t)}
    if _leaves(railway, r):
        boundary = railway.layout.boundary_at[_end(railway, r)[1]]
        found |= {boundary.approach or f"outside.{boundary.node}"}
    return frozenset(found)


# --- runs ----------------------------------------------------------------------------------------


def pair_run(system: System, railway: Railway, run: PairRun, lane: Lane) -> Driver:
    """Release after the restart, bring the trains before their signals, open both, drive, and see all free again."""
    yield from _settling(railway, [r for chain, r in zip(run.before, run.trains, strict=False) for r in (*chain, r)])
    for chain, last in zip(run.before, (run.first, run.second), strict=True):
        if chain:
            yield from _there(railway, lane, chain[0])
        for r, after in pairwise((*chain, last)):
            failure = (yield from _set(railway, lane, r)) or (yield from _travel(railway, lane, r))
            failure = failure or (yield from _freed(railway, lane, (r,), _stays(railway, r)))
            if failure is not None:
                return f"{BEFORE}over {r.id}: {failure}"
            yield from _turn(railway, after)
    for r in run.trains:
        yield from _there(railway, lane, r)
        if not lane.is_on(f"o.{_before(railway, r)}"):
            return f"{BEFORE}both trains have to begin in one place"
    failure = yield from _disturbed_for(railway, (run.first, run.second), _used(system, railway, run, lane))
    troubles = lane.troubles()
    return failure or (f"the run meets {', '.join(troubles)}" if troubles else None)


def _there(railway: Railway, lane: Lane, r: RouteSymbols) -> Generator[Wish, None, None]:
    """Another train comes to a boundary where the one before has gone on."""
    place = _before(railway, r)
    if place not in railway.topo.ends and not lane.is_on(f"o.{place}"):
        yield from _until(lane, f"o.{place}", Wish((f"appear.{place}",)))


def _used(system: System, railway: Railway, run: PairRun, lane: Lane) -> Driver:
    first, second = run.first, run.second
    for r in (first, second):
        failure = yield from _opens(railway, lane, r, opening.steps(system, r, lane.lanes.dt_ms))
        if failure is not None:
            return f"{r.id}: {failure}"
    yield NOTHING
    for r in (first, second):
        if not _is_open(lane, r):
            return f"{r.id}: its signal closes when the other one is open"
    failure = yield from _driven(railway, run, lane)
    if failure is not None:
        return failure
    there = (second,) if run.how is How.ONWARD else run.trains
    keep = set(railway.layout.undetected).union(*(_stays(railway, r, r not in there) for r in (first, second)))
    left = [s for s, locks in railway.symbols.locked_by.items() if s not in keep and any(map(lane.is_on, locks))]
    return f"{', '.join(left)} stay locked in the end" if left else None


def _driven(railway: Railway, run: PairRun, lane: Lane) -> Driver:
    first, second = run.first, run.second
    if run.how is How.TOGETHER:
        both = _merged([_travel(railway, lane, first), _travel(railway, lane, second)])
        failure = yield from _watched(lane, both, (first, second), ())
    elif run.trains:
        failure = yield from _watched(lane, _travel(railway, lane, first), (first,), (second,))
        if failure is None and run.how is not How.ONWARD:
            failure = yield from _watched(lane, _freed(railway, lane, (first,), _stays(railway, first)), (), (second,))
        if failure is None and run.how is How.ONWARD:
            failure = yield from _watched(lane, _turn(railway, second), (), (second,))
    else:
        failure = None
    if failure is None and run.how in (How.THEN, How.ONWARD):
        failure = yield from _watched(lane, _travel(railway, lane, second), (second,), ())
    if failure is not None:
        return failure
    given_back = {How.ALONE: [second], How.GIVEN_BACK: [first, second]}.get(run.how, [])
    for r in given_back:
        yield Wish((), {railway.symbols.cancel[r.entry]: 1})
    there = (second,) if run.how is How.ONWARD else run.trains
    keep = set().union(*(_stays(railway, r, r not in there) for r in (first, second)))
    return (yield from _freed(railway, lane, (first, second), keep))


def _settling(railway: Railway, routes: Sequence[RouteSymbols]) -> list[Wish]:
    """Two scans in which an operator releases everything that is clear, and closes crossings under waiting trains."""
    closing = dict.fromkeys((x for r in routes for x in _closing(railway, _before(railway, r))), 1)
    return [Wish((), {"RELALL": 1, **closing})] * 2


def _broken(railway: Railway, r: RouteSymbols) -> SectionId | None:
    """A section that is reported occupied by mistake while a train is called on."""
    return _failed_section(railway, r) if r.call_on else None


def _disturbed_for(railway: Railway, routes: Sequence[RouteSymbols], run: Driver) -> Driver:
    """A run in which sections are reported occupied by mistake: calling on is for that."""
    broken = {railway.symbols.clear[s]: 0 for r in routes if (s := _broken(railway, r)) is not None}
    while True:
        try:
            wish = next(run)
        except StopIteration as end:
            failure: str | None = end.value
            return failure
        yield Wish(wish.events, {**wish.inputs, **broken})


def _opens(railway: Railway, lane: Lane, r: RouteSymbols, steps: int) -> Driver:
    """Asked for, the route is set at once, and its signal opens within some scans."""
    if not (yield from _until(lane, r.active, Wish((), {railway.symbols.request: r.number}), opening.SET)):
        return "the request is refused: " + _not(lane, f"G_R{r.number}")
    token = railway.symbols.token.get(_exit(railway, r))
    if token is not None and not r.shunt and not lane.is_on(token.have):
        yield from _until(lane, token.have, Wish((), {token.manual: 1}), MAX_STEPS)
    if not (yield from _until(lane, r.proceed, NOTHING, steps - opening.SET)):
        equation = f"CO_R{r.number}" if lane.is_on(r.locked) else f"LK_R{r.number}"
        return f"the signal does not open within {steps} scans: " + _not(lane, equation)
    return None


def _exit(railway: Railway, r: RouteSymbols) -> NodeId:
    section, number = r.ways[-1]
    return railway.topo.traversals[section][number - 1].exit


def _opens_alone(system: System, railway: Railway, r: RouteSymbols, moved: int, lane: Lane) -> Driver:
    yield from _settling(railway, [r])
    return (yield from _opens(railway, lane, r, opening.steps(system, r, lane.lanes.dt_ms, moved)))


def _turned(system: System, r: RouteSymbols, standing: dict[str, int]) -> dict[str, int]:
    """Every machine of a route the other way, but for those on which its train stands."""
    return {
        name: value
        for way in (*r.ways, *(() if r.overlap is None else system.symbols.overlap_ways[r.overlap]))
        for m, x in system.symbols.demands[way]
        for name, value in ((f"at.{m}.{x}", 0), (f"at.{m}.{x.other}", 1))
        if name not in standing
    }


def _to_move(system: System, r: RouteSymbols, start: dict[str, int]) -> int:
    """The machines that a route has to move."""
    over = () if r.overlap is None else system.symbols.overlap_ways[r.overlap]
    wrong = {
        m
        for way in (*r.ways, *over)
        for m, x in system.symbols.demands[way]
        if not start.get(f"at.{m}.{x}", int(x is Position.NORMAL)) or m in opening.devices(system)
    }
    return len(wrong)


def _is_open(lane: Lane, r: RouteSymbols) -> bool:
    return any(map(lane.is_on, r.open_while))


def _watched(lane: Lane, run: Driver, running: Sequence[RouteSymbols], waiting: Sequence[RouteSymbols]) -> Driver:
    """A run in which signals stay open: `running` until their own train has come into the first section."""
    outside = list(running)
    while True:
        try:
            wish = next(run)
        except StopIteration as end:
            failure: str | None = end.value
            return failure
        yield wish
        outside = [r for r in outside if not lane.is_on(f"o.{r.ways[0][0]}")]
        for r in (*outside, *waiting):
            if not _is_open(lane, r):
                why = _not(lane, f"CO_R{r.number}")
                return f"the signal of {r.id} falls to stop before its train: {why}"


def _merged(runs: Sequence[Driver]) -> Driver:
    """Several runs at once, step by step."""
    live = list(runs)
    while True:
        wishes = []
        for run in list(live):
            try:
                wishes.append(next(run))
            except StopIteration as end:
                if end.value is not None:
                    failure: str = end.value
                    return failure
                live.remove(run)
        if not live:
            return None
        inputs = {name: value for w in wishes for name, value in w.inputs.items()}
        yield Wish(tuple(e for w in wishes for e in w.events), inputs)


def _turn(railway: Railway, r: RouteSymbols) -> Generator[Wish, None, str | None]:
    """The train that has come before a signal turns towards it, if it must."""
    place, node = _before(railway, r), railway.layout.signal[r.entry].node
    yield Wish(tuple(e for e in railway.plant.events if e.startswith(f"turn.{place}.{node}.")))
    return None


def _stays(railway: Railway, r: RouteSymbols, empty: bool = False) -> set[SectionId]:
    """Where a route's sections stay locked: under its train, unless none is there, and from a failed section on."""
    broken = _broken(railway, r)
    return set() if empty and broken is None else _kept(railway, r, broken)


def _freed(railway: Railway, lane: Lane, routes: Sequence[RouteSymbols], keep: set[SectionId]) -> Driver:
    """What routes have locked is free again, but for some sections; calling on is given back by hand."""
    sym = railway.symbols
    inputs: dict[str, int] = {}
    for r in routes:
        if r.call_on:
            over = [SectionId(_before(railway, r)), *(s for s, _ in r.ways)]
            inputs |= {sym.cancel[r.entry]: 1, **{sym.release[s]: 1 for s in over if s in sym.release}}
    ways = [*(way for r in routes for way in r.ways), *(r.berth for r in routes if r.berth is not None)]
    mine = {s for s, _ in ways} | {SectionId(_before(railway, r)) for r in routes}
    locks = [(s, sym.locked_by[s]) for s in sorted(mine - keep - set(railway.layout.undetected)) if s in sym.locked_by]
    for _ in range(MAX_STEPS):
        left = [s for s, names in locks if any(map(lane.is_on, names))]
        if not left:
            return None
        yield Wish((), inputs)
    return f"{', '.join(left)} stay locked behind the train"
