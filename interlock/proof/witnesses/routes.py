"""Witnesses: every route can be set, driven and released by a train, from a restart.

A claim about a controller that never opens a signal would hold and mean nothing; this run shows that each route
works, that the assumptions can be met, and that nothing stays locked behind the train (over-locking is invisible
to safety proofs).

**Theorem.**  A run of the closed loop that begins in an initial state and in which every assumption held shows that its
last state is reachable; it says nothing of any other run.  (Witnesses of existential properties: Clarke, Grumberg and
Peled, *Model Checking*, 1999.)  Runs that are computed side by side, a bit for each, are the runs that each would be
alone, since no operation joins two bits.
"""

from __future__ import annotations

from collections.abc import Callable, Generator, Mapping, Sequence
from dataclasses import replace
from functools import partial
from itertools import pairwise

from interlock.dataclass import dataclass
from interlock.logic import names
from interlock.logic.expr import FALSE, Substitution
from interlock.logic.names import Name
from interlock.logic.symbols import RouteSymbols
from interlock.model.elements import NodeId, Position, RouteId, SectionId
from interlock.model.layout import Layout
from interlock.model.traversal import Topology
from interlock.proof.induction.verdict import Witness
from interlock.proof.system.loop import ClosedLoop
from interlock.proof.witnesses import opening
from interlock.sim.lanes import NOTHING, Driver, Lane, Lanes, Record, Wish

MAX_STEPS = 400
FEEDERS = 3  # so many routes are tried, one after the other, over which a train may come to another


@dataclass(frozen=True)
class Trial:
    """A run of one train or operator, from a restart: what it tries, and how; the same on every controller whose
    variables mean the same."""

    name: str
    start: Mapping[str, int]
    driver: Callable[[Lane], Driver]


class Trials:
    """Runs of one controller with its plant."""

    def __init__(self, railway: ClosedLoop, record: Record | None = None) -> None:
        """`record`: is given what each step computes of the controller."""
        self._lanes = Lanes(railway.controller, railway.plant, record=record)

    def run(self, trials: Sequence[Trial], first: bool = False) -> list[str | None]:
        """What goes wrong in each, or None; `first`: nothing is done any more after the first that goes wrong."""
        found = self._lanes.run([t.start for t in trials], [t.driver for t in trials], first)
        return [failure for failure, _ in found]


def witnesses(railway: ClosedLoop) -> tuple[Witness, ...]:
    """A run for each route, all of them side by side.

    First with a train that has stood before the signal since the restart (into a berth a second time, with vehicles
    standing there); where that fails, with a train that came there under another route.
    """
    found = {w.route: w for w, _ in _tried(railway)}
    sym = railway.controller.symbols
    for r in sym.routes:
        if r.path.identifier:  # it is set, driven and released with the routes that lead past its signal
            by = [found[x.id] for x in sym.routes.set_with(r) if not x.path.identifier]
            w = next((w for w in by if w.ok), by[0])
            found[r.id] = replace(w, route=r.id, text=f"{w.text}, with {w.route}")
    return tuple(found[r.id] for r in sym.routes)


def journeys(railway: ClosedLoop) -> list[Trial]:
    """The runs by which routes can be used: those that went well."""
    found = []
    for w, runs in _tried(railway):
        for run in runs if w.ok else ():
            start = _start(railway, run[0], run[1])
            assert isinstance(start, dict)
            found.append(Trial(w.route, start, partial(_journey, railway, *run)))
    return found


def _tried(railway: ClosedLoop) -> list[tuple[Witness, list[Run]]]:
    """Each route's witness, and its runs."""
    routes = railway.controller.symbols.routes.whole
    lanes = Lanes(railway.controller, railway.plant)
    first = _attempt(railway, lanes, [(r, "", ()) for r in routes])
    again = [r for r, (failure, _) in zip(routes, first, strict=True) if failure is None and r.path.berth is not None]
    second = dict(
        zip((r.id for r in again), _attempt(railway, lanes, [(r, _berth(r), ()) for r in again]), strict=True)
    )
    came = _over_others(
        railway, lanes, [r for r, (failure, _) in zip(routes, first, strict=True) if failure is not None]
    )
    out: list[tuple[Witness, list[Run]]] = []
    for r, (failure, steps) in zip(routes, first, strict=True):
        stand: Run = (r, "", ())
        if failure is not None and r.id in came:
            chain, n = came[r.id]
            over = " and ".join(x.id for x in chain[:-1])
            text = f"set, driven and released, coming over {over}"
            out.append((Witness(r.id, True, n, text), [(chain[0], "", chain[1:])]))
        elif failure is not None:
            out.append((Witness(r.id, False, steps, failure), [stand]))
        elif r.id in second and second[r.id][0] is not None:
            text = f"with vehicles standing in {_berth(r)}: {second[r.id][0]}"
            out.append((Witness(r.id, False, steps, text), [stand]))
        else:
            text, steps = "set, driven and released", steps + second.get(r.id, (None, 0))[1]
            out.append((Witness(r.id, True, steps, text), [stand, *([(r, _berth(r), ())] if r.id in second else [])]))
    return out


def _over_others(
    railway: ClosedLoop, lanes: Lanes, failed: Sequence[RouteSymbols]
) -> dict[RouteId, tuple[tuple[RouteSymbols, ...], int]]:
    """For routes that no train can take from a stand since the restart: the routes over which one comes to them, as few
    as possible, with the route itself, and the number of scans."""
    ends: dict[str, list[RouteSymbols]] = {}
    for x in railway.controller.symbols.routes.whole:
        ends.setdefault((x.path.berth or x.path.ways[-1])[0], []).append(x)
    chains: list[tuple[RouteSymbols, ...]] = [(r,) for r in failed]
    found: dict[RouteId, tuple[tuple[RouteSymbols, ...], int]] = {}
    for _ in range(FEEDERS):
        chains = [
            (x, *chain)
            for chain in chains
            if chain[-1].id not in found
            for x in ends.get(_before(railway, chain[0]), ())
            if x not in chain
        ]
        for chain, (why, n) in zip(chains, _attempt(railway, lanes, [(c[0], "", c[1:]) for c in chains]), strict=True):
            if why is None:
                found.setdefault(chain[-1].id, (chain, n))
    return found


def _berth(r: RouteSymbols) -> str:
    return r.path.berth[0] if r.path.berth is not None else ""


def _before(railway: ClosedLoop, r: RouteSymbols) -> str:
    return _rear(railway.layout, railway.topo, railway.layout.signalling.signal[r.entry].node, r.path.ways[0][0])


Run = tuple[RouteSymbols, str, tuple[RouteSymbols, ...]]
"""A route, a berth in which vehicles stand, and routes that the same train takes afterwards."""


def _attempt(railway: ClosedLoop, lanes: Lanes, runs: list[Run]) -> list[tuple[str | None, int]]:
    """What went wrong in each run, or None, and the number of scans."""
    starts = [_start(railway, r, berth) for r, berth, _ in runs]
    drivable = [n for n, s in enumerate(starts) if not isinstance(s, str)]
    found = lanes.run(
        [s for s in starts if not isinstance(s, str)], [partial(_journey, railway, *runs[n]) for n in drivable]
    )
    done = dict(zip(drivable, found, strict=True))
    return [done.get(n, (s if isinstance(s, str) else None, 0)) for n, s in enumerate(starts)]


def _journey(railway: ClosedLoop, r: RouteSymbols, berth: str, onward: tuple[RouteSymbols, ...], lane: Lane) -> Driver:
    """Release every clear section after the restart, then drive."""
    del berth
    rear = _before(railway, r)
    closing = dict.fromkeys(_closing(railway, rear), 1)
    for _ in range(2):
        yield Wish((), {names.RELEASE_ALL: 1, **closing})
    failure = yield from _run(railway, lane, r)
    for before, after in pairwise((r, *onward)):
        if failure is None:
            yield from _given_up(railway, lane, before)
            failure = yield from _run(railway, lane, after, turning=_before(railway, after))
    return failure


def _given_up(railway: ClosedLoop, lane: Lane, r: RouteSymbols) -> Generator[Wish, None, None]:
    """A train that stands at the end of its route needs its overlap no more (R4): it goes after the time of release."""
    held = [
        v
        for (g, _), v in railway.controller.symbols.overlaps.held.items()
        if r.path.overlap is not None and g == r.path.overlap[0]
    ]
    for _ in range(MAX_STEPS):
        if not any(map(lane.is_on, held)):
            return
        yield NOTHING


def _closing(railway: ClosedLoop, section: str) -> list[str]:
    """The inputs by which an operator closes the crossings and bridges over a section."""
    over = [d.id for d in railway.layout.signalling.devices if section in d.over]
    return [railway.controller.symbols.machines.by_hand[m, Position.REVERSE] for m in over]


def _start(railway: ClosedLoop, r: RouteSymbols, berth: str) -> dict[str, int] | str:
    """A restart with one train before the signal (and vehicles standing in a berth), or what is impossible."""
    node = railway.layout.signalling.signal[r.entry].node
    state = _lying(railway, r)
    standing = _stand(railway, _before(railway, r), node)
    if standing is None:
        return f"no train can stand before {r.entry}"
    if any(state.get(name, value) != value for name, value in standing.items()):
        return f"a train before {r.entry} stands on points that the route needs otherwise"
    there = names.CAME(berth, railway.topo.ends[SectionId(berth)][0]) if berth else ""
    parked = {names.STANDS(berth): 1, names.RESTS(berth): 1, there: 1} if berth else {}
    return state | standing | parked


def _run(railway: ClosedLoop, lane: Lane, r: RouteSymbols, turning: str = "") -> Driver:
    """Set the route, drive it with the train before its signal, and wait for the release behind it."""
    signal = railway.layout.signalling.signal[r.entry]
    if turning:
        turns = tuple(e for e in railway.plant.events if e.family is names.TURNS and e.at[:2] == (turning, signal.node))
        yield Wish(turns)
    if r.call_on and (failed := _failed_section(railway, r)):
        fault: dict[str, int] = {railway.controller.symbols.sections.clear[failed]: 0}
        return (yield from _disturbed(_drive(railway, lane, r, failed), fault))
    return (yield from _drive(railway, lane, r))


def _failed_section(railway: ClosedLoop, r: RouteSymbols) -> SectionId | None:
    """A section of a call-on route that may be reported occupied by mistake: not one that the route must find clear as
    its flank space, too (R5)."""
    berths, clear = railway.topo.berths, railway.controller.symbols.sections.clear
    those = [s for s, _ in r.path.ways[1:] if s not in berths and s in clear]
    beside = _beside(railway, r) if railway.layout.principles.flank_space and those else frozenset[SectionId]()
    return next((s for s in those if s not in beside or not _wants_clear(railway, r, s)), None)


def _beside(railway: ClosedLoop, r: RouteSymbols) -> frozenset[SectionId]:
    """The sections between the places at which a vehicle might come into a route and the next signals there."""
    found = set[SectionId]()
    works, beyond = railway.layout.pointwork, railway.measured.beyond
    for t in (railway.topo.traversals[SectionId(s)][n - 1] for s, n in r.path.ways):
        todo = [beyond[p.node, p.leg(x.other)] for p, x in ((works.point[p], x) for p, x in t.points)]
        todo += [
            beyond[c.node, e]
            for c, arm in ((works.crossing[c], arm) for c, arm in t.crossings)
            for e in c.arms[1 - arm]
        ]
        while todo:
            b = todo.pop()
            found.add(b.section)
            todo += b.onward
    return frozenset(found)


def _wants_clear(railway: ClosedLoop, r: RouteSymbols, section: SectionId) -> bool:
    """Whether a route's signal never opens while a section is reported occupied, and so has not been clear for long."""
    conditions = railway.controller.expanded[names.CONDITIONS(r.number)]
    of = railway.controller.symbols.sections
    occupied = {of.clear[section]: FALSE, of.release_timer[section]: FALSE}
    return Substitution(occupied)(conditions) is FALSE


def _disturbed(run: Driver, inputs: dict[str, int]) -> Driver:
    """The same run with inputs that stay as given."""
    wish = next(run)
    while True:
        yield Wish(wish.events, {**wish.inputs, **inputs})
        try:
            wish = run.send(None)
        except StopIteration as end:
            failure: str | None = end.value
            return failure


def _drive(railway: ClosedLoop, lane: Lane, r: RouteSymbols, failed: SectionId | None = None) -> Driver:
    """Drive a route; `failed` is reported occupied all the time and stays locked."""
    failure = yield from _set(railway, lane, r)
    if failure is None:
        failure = yield from _travel(railway, lane, r)
    if failure is not None:
        return failure
    keep = _kept(railway, r, failed)
    after = NOTHING
    if r.call_on:
        by_hand: dict[str, int] = {
            i.name: 1
            for i in railway.controller.inputs
            if i.name == names.RELEASE_ALL or i.name.family is names.RELEASE_BY_HAND
        }
        after = Wish((), {railway.controller.symbols.cancellation.cancel[r.entry]: 1, **by_hand})
    for _ in range(MAX_STEPS):
        locked = [s for s in lane.held() if s not in keep]
        if not locked:
            break
        yield after
    else:
        return f"{', '.join(locked)} stay locked behind the train"
    troubles = lane.troubles()
    return f"the run meets {', '.join(troubles)}" if troubles else None


def _set(railway: ClosedLoop, lane: Lane, r: RouteSymbols) -> Driver:
    """Ask for a route until its signal is open, and for the direction of the line beyond where that has a token."""
    symbols = railway.controller.symbols
    if not (yield from _until(lane, r.active, Wish((), {symbols.requests.request: r.number}), opening.SET)):
        return "the request is refused: " + _not(lane, names.GRANTED(r.number))
    token = symbols.token.get(railway.topo.traversals[r.path.ways[-1][0]][r.path.ways[-1][1] - 1].exit)
    if token is not None and not r.shunt and not lane.is_on(token.have):
        yield from _until(lane, token.have, Wish((), {token.manual: 1}), MAX_STEPS)
    if not (yield from _until(lane, r.proceed)):
        return "the signal does not open: " + _not(lane, names.LOCKS(r.number))
    return None


def _travel(railway: ClosedLoop, lane: Lane, r: RouteSymbols) -> Driver:
    """Drive the train that stands before an open signal to the end of its route."""
    layout, topo = railway.layout, railway.topo
    signal = layout.signalling.signal[r.entry]
    if not (yield from _until(lane, names.accepted(r.entry, r.shunt), Wish((names.accepts(r.entry, r.shunt),)))):
        return "no train can accept the signal"
    place, joint = _rear(layout, topo, signal.node, r.path.ways[0][0]), signal.node
    for section, number in r.path.ways if r.path.berth is None else (*r.path.ways, r.path.berth):
        passed = topo.main_into.get((joint, section)) if section != r.path.ways[0][0] else None
        if passed is not None and not (yield from _until(lane, names.accepted(passed), Wish((names.accepts(passed),)))):
            return f"no train can pass {passed}"
        if not (yield from _until(lane, names.STANDS(section), Wish((names.HEAD(joint, place),)))):
            return f"the train cannot enter {section}"
        if not (yield from _until_off(lane, names.ACROSS(joint, place), names.TAIL(joint, place))):
            return f"the train's tail does not leave {place}"
        place, joint = section, topo.traversals[section][number - 1].exit
    if _leaves(railway, r):
        if not (yield from _until(lane, names.ACROSS(joint, place), Wish((names.HEAD(joint, place),)))):
            return f"the train cannot leave at {joint}"
        if not (yield from _until_off(lane, names.STANDS(place), names.TAIL(joint, place))):
            return f"the train's tail does not leave {place}"
    return None


def _end(railway: ClosedLoop, r: RouteSymbols) -> tuple[SectionId, NodeId]:
    """The last section of a route, and its end there."""
    section, number = r.path.ways[-1] if r.path.berth is None else r.path.berth
    return section, railway.topo.traversals[section][number - 1].exit


def _leaves(railway: ClosedLoop, r: RouteSymbols) -> bool:
    """Whether a train leaves the layout at the end of a route."""
    return _end(railway, r)[1] in railway.layout.track.boundary_at and not r.shunt


def _kept(railway: ClosedLoop, r: RouteSymbols, failed: SectionId | None) -> set[SectionId]:
    """Sections that stay locked behind the train: where it stands, and from one on that is reported occupied."""
    last = set() if _leaves(railway, r) else {_end(railway, r)[0]}
    if failed is not None:
        last |= {s for s, _ in r.path.ways[[s for s, _ in r.path.ways].index(failed) :]}
    return last | set(railway.layout.track.undetected)


def _until(lane: Lane, wanted: str, wish: Wish = NOTHING, limit: int = 12) -> Generator[Wish, None, bool]:
    for _ in range(limit):
        yield wish
        if lane.is_on(wanted):
            return True
    return False


def _until_off(lane: Lane, name: Name, event: Name) -> Generator[Wish, None, bool]:
    for _ in range(12):
        if not lane.is_on(name):
            return True
        yield Wish((event,))
    return not lane.is_on(name)


def _not(lane: Lane, equation: str) -> str:
    return "; ".join("not " + t for t in lane.missing(equation)) or "a condition came and went"


def _lying(railway: ClosedLoop, r: RouteSymbols, overlap: bool = False) -> dict[str, int]:
    """Points as the route needs them, so that none has to move under the waiting train."""
    state: dict[str, int] = {}
    for m, x in opening.demanded(railway.controller.symbols, r, overlap):
        state |= {
            names.LIES(m, Position.NORMAL): int(x is Position.NORMAL),
            names.LIES(m, Position.REVERSE): int(x is Position.REVERSE),
        }
    return state


def _rear(layout: Layout, topo: Topology, node: NodeId, first: SectionId) -> str:
    boundary = layout.track.boundary_at.get(node)
    if boundary is not None:
        return boundary.approach or names.outside(node)
    rear = topo.beyond(first, node)
    assert rear is not None
    return rear


def _stand(railway: ClosedLoop, rear: str, node: NodeId) -> dict[str, int] | None:
    """A railway with one train at rest before the signal, points lying for it."""
    if rear not in railway.topo.ends:
        return {names.STANDS(rear): 1}
    for t in railway.topo.traversals[SectionId(rear)]:
        if t.exit == node:
            state: dict[str, int] = {names.STANDS(rear): 1, names.CAME(rear, t.entry): 1, names.RESTS(rear): 1}
            for p, x in t.points:
                m = railway.layout.pointwork.point[p].machine
                state |= {
                    names.LIES(m, Position.NORMAL): int(x is Position.NORMAL),
                    names.LIES(m, Position.REVERSE): int(x is Position.REVERSE),
                }
            return state
    return None
