"""One run of two routes: trains come before their signals, both are opened and driven, and all is free again.

**Theorem.**  As of witnesses: the run shows one order of movements to be possible, and no other.  (Clarke, Grumberg and
Peled, *Model Checking*, 1999.)  That both signals were open at once is read off the states of this very run.
"""

from __future__ import annotations

from collections.abc import Generator, Sequence
from enum import StrEnum
from itertools import pairwise

from interlock.dataclass import dataclass
from interlock.logic import names
from interlock.logic.symbols import RouteSymbols
from interlock.model.elements import NodeId, Position, RouteId, SectionId
from interlock.model.machines import other_doors
from interlock.proof.system.loop import ClosedLoop
from interlock.proof.witnesses import opening
from interlock.proof.witnesses.routes import (
    MAX_STEPS,
    _before,
    _closing,
    _failed_section,
    _given_up,
    _kept,
    _not,
    _set,
    _travel,
    _until,
)
from interlock.sim.lanes import NOTHING, Driver, Lane, Wish

BEFORE = "before that, "
REFUSED = "the request is refused: "


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

    def reported(self, railway: ClosedLoop) -> dict[RouteId, SectionId]:
        """By route, where a train is called on, a section that is reported occupied by mistake: calling on is for that.

        Of two that adjoin the first alone, since not both are (A-ONE-FALSE); the other train is called on without.
        """
        found = {r.id: s for r in (self.first, self.second) if r.call_on and (s := _failed_section(railway, r))}
        if len(found) == 2 and {*found.values()} in [{a, b} for _, a, b in railway.topo.joints()]:
            del found[self.second.id]
        return found


def pair_run(railway: ClosedLoop, run: PairRun, lane: Lane) -> Driver:
    """Release after the restart, bring the trains before their signals, open both, drive, and see all free again."""
    failure = yield from _placed(railway, run, lane)
    if failure is not None:
        return failure
    failure = yield from _disturbed(railway, run, _used(railway, run, lane))
    troubles = lane.troubles()
    return failure or (f"the run meets {', '.join(troubles)}" if troubles else None)


def lone_request(railway: ClosedLoop, run: PairRun, r: RouteSymbols, lane: Lane) -> Driver:
    """One of two routes is asked for with the trains of a run before their signals, while the other is not set."""
    failure = yield from _placed(railway, run, lane)
    if failure is not None:
        return failure
    asking = _until(lane, r.active, Wish((), {railway.controller.symbols.requests.request: r.number}), opening.SET)
    return (yield from _disturbed(railway, run, _granted(lane, r, asking)))


def _granted(lane: Lane, r: RouteSymbols, asking: Generator[Wish, None, bool]) -> Driver:
    return None if (yield from asking) else REFUSED + _not(lane, names.GRANTED(r.number))


def _placed(railway: ClosedLoop, run: PairRun, lane: Lane) -> Driver:
    """Release after the restart, and bring the trains before their signals."""
    yield from settling(railway, [r for chain, r in zip(run.before, run.trains, strict=False) for r in (*chain, r)])
    for chain, last in zip(run.before, (run.first, run.second), strict=True):
        if chain:
            yield from _there(railway, lane, chain[0])
        for r, after in pairwise((*chain, last)):
            failure = (yield from _set(railway, lane, r)) or (yield from _travel(railway, lane, r))
            failure = failure or (yield from _freed(railway, lane, (r,), _kept(railway, r, None)))
            if failure is not None:
                return f"{BEFORE}over {r.id}: {failure}"
            yield from _given_up(railway, lane, r)
            yield from _turn(railway, after)
    for r in run.trains:
        yield from _there(railway, lane, r)
        if not lane.is_on(names.STANDS(_before(railway, r))):
            return f"{BEFORE}both trains have to begin in one place"
    return None


def _there(railway: ClosedLoop, lane: Lane, r: RouteSymbols) -> Generator[Wish, None, None]:
    """Another train comes to a boundary where the one before has gone on."""
    place = _before(railway, r)
    if place not in railway.topo.ends and not lane.is_on(names.STANDS(place)):
        yield from _until(lane, names.STANDS(place), Wish((names.APPEARS(place),)))


def _used(railway: ClosedLoop, run: PairRun, lane: Lane) -> Driver:
    first, second = run.first, run.second
    for r in (first, second):
        after = first if r is second else None
        failure = yield from _opens(railway, lane, r, opening.steps(railway, r, lane.lanes.dt_ms, after=after))
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
    keep = {*railway.layout.track.undetected, *_stays(railway, run, there)}
    left = [
        s
        for s, locks in railway.controller.symbols.sections.locked_by.items()
        if s not in keep and any(map(lane.is_on, locks))
    ]
    return f"{', '.join(left)} stay locked in the end" if left else None


def _driven(railway: ClosedLoop, run: PairRun, lane: Lane) -> Driver:
    first, second = run.first, run.second
    if run.how is How.TOGETHER:
        both = _merged([_travel(railway, lane, first), _travel(railway, lane, second)])
        failure = yield from _watched(lane, both, (first, second), ())
    elif run.trains:
        failure = yield from _watched(lane, _travel(railway, lane, first), (first,), (second,))
        if failure is None and run.how is not How.ONWARD:
            failure = yield from _watched(
                lane, _freed(railway, lane, (first,), _stays(railway, run, (first,), (first,))), (), (second,)
            )
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
        yield Wish((), {railway.controller.symbols.cancellation.cancel[r.entry]: 1})
    there = (second,) if run.how is How.ONWARD else run.trains
    return (yield from _freed(railway, lane, (first, second), _stays(railway, run, there)))


def settling(railway: ClosedLoop, routes: Sequence[RouteSymbols]) -> list[Wish]:
    """Two scans in which an operator releases everything that is clear, and closes crossings under waiting trains."""
    closing = dict.fromkeys((x for r in routes for x in _closing(railway, _before(railway, r))), 1)
    return [Wish((), {names.RELEASE_ALL: 1, **closing})] * 2


def _disturbed(railway: ClosedLoop, run: PairRun, driver: Driver) -> Driver:
    """A run in which sections are reported occupied by mistake."""
    broken: dict[str, int] = {railway.controller.symbols.sections.clear[s]: 0 for s in run.reported(railway).values()}
    while True:
        try:
            wish = next(driver)
        except StopIteration as end:
            failure: str | None = end.value
            return failure
        yield Wish(wish.events, {**wish.inputs, **broken})


def _opens(railway: ClosedLoop, lane: Lane, r: RouteSymbols, steps: int) -> Driver:
    """Asked for, the route is set at once, and its signal opens within some scans."""
    if not (
        yield from _until(
            lane, r.active, Wish((), {railway.controller.symbols.requests.request: r.number}), opening.SET
        )
    ):
        return REFUSED + _not(lane, names.GRANTED(r.number))
    token = railway.controller.symbols.token.get(_exit(railway, r))
    if token is not None and not r.shunt and not lane.is_on(token.have):
        yield from _until(lane, token.have, Wish((), {token.manual: 1}), MAX_STEPS)
    if not (yield from _until(lane, r.proceed, NOTHING, steps - opening.SET)):
        equation = names.CONDITIONS(r.number) if lane.is_on(r.locked) else names.LOCKS(r.number)
        return f"the signal does not open within {steps} scans: " + _not(lane, equation)
    return None


def _exit(railway: ClosedLoop, r: RouteSymbols) -> NodeId:
    section, number = r.path.ways[-1]
    return railway.topo.traversals[section][number - 1].exit


def opens_alone(railway: ClosedLoop, r: RouteSymbols, moved: int, lane: Lane) -> Driver:
    """A route is asked for with nothing else set; `moved`: machines that it has to move.  Ends with why its signal does
    not open within the scans that this may take, or None."""
    yield from settling(railway, [r])
    return (yield from _opens(railway, lane, r, opening.steps(railway, r, lane.lanes.dt_ms, moved)))


def turned(railway: ClosedLoop, r: RouteSymbols, standing: dict[str, int]) -> dict[str, int]:
    """Every machine of a route the other way, but for those on which its train stands, and for other doors of an air
    lock: the route is refused until they are shut (R13)."""
    machines = railway.layout.machines
    return {
        name: value
        for m, x in opening.demanded(railway.controller.symbols, r)
        if x is Position.REVERSE or not other_doors(machines, m)
        for name, value in ((names.LIES(m, x), 0), (names.LIES(m, x.other), 1))
        if name not in standing
    }


def to_move(railway: ClosedLoop, r: RouteSymbols, start: dict[str, int]) -> int:
    """The machines that a route has to move."""
    wrong = {
        m
        for m, x in opening.demanded(railway.controller.symbols, r)
        if not start.get(names.LIES(m, x), int(x is Position.NORMAL)) or m in opening.devices(railway)
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
        outside = [r for r in outside if not lane.is_on(names.STANDS(r.path.ways[0][0]))]
        for r in (*outside, *waiting):
            if not _is_open(lane, r):
                why = _not(lane, names.CONDITIONS(r.number))
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


def _turn(railway: ClosedLoop, r: RouteSymbols) -> Generator[Wish, None, str | None]:
    """The train that has come before a signal turns towards it, if it must."""
    place, node = _before(railway, r), railway.layout.signalling.signal[r.entry].node
    yield Wish(tuple(e for e in railway.plant.events if e.family is names.TURNS and e.at[:2] == (place, node)))
    return None


def _stays(
    railway: ClosedLoop, run: PairRun, there: Sequence[RouteSymbols], routes: Sequence[RouteSymbols] = ()
) -> set[SectionId]:
    """Where sections stay locked: under the trains that are `there`, and from one on that is reported occupied; of both
    routes, or of some."""
    reported = run.reported(railway)
    of = routes or (run.first, run.second)
    return set().union(*(_kept(railway, r, reported.get(r.id)) for r in of if r in there or r.id in reported))


def _freed(railway: ClosedLoop, lane: Lane, routes: Sequence[RouteSymbols], keep: set[SectionId]) -> Driver:
    """What routes have locked is free again, but for some sections; calling on is given back by hand."""
    sym = railway.controller.symbols
    inputs: dict[str, int] = {}
    for r in routes:
        if r.call_on:
            over = [SectionId(_before(railway, r)), *(s for s, _ in r.path.ways)]
            inputs |= {
                sym.cancellation.cancel[r.entry]: 1,
                **{sym.sections.release[s]: 1 for s in over if s in sym.sections.release},
            }
    ways = [*(way for r in routes for way in r.path.ways), *(r.path.berth for r in routes if r.path.berth is not None)]
    mine = {s for s, _ in ways} | {SectionId(_before(railway, r)) for r in routes}
    locks = [
        (s, sym.sections.locked_by[s])
        for s in sorted(mine - keep - set(railway.layout.track.undetected))
        if s in sym.sections.locked_by
    ]
    for _ in range(MAX_STEPS):
        left = [s for s, names in locks if any(map(lane.is_on, names))]
        if not left:
            return None
        yield Wish((), inputs)
    return f"{', '.join(left)} stay locked behind the train"
