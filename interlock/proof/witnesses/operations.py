"""Operations: what an operator may do with every route, and what has to work then.

Witnesses (`routes`) show that trains get through.  These runs show the rest of what the rules promise, on the
same controller and plant: a route that lost a condition stays at stop until it is asked for again (R14); a trailed
point keeps its routes back until somebody has looked at it (R10); a cancelled route is given back after its delay,
asked for by one touch of a button (R8); sections whose detection is not relied on any more are given back by hand
behind the train (R8, R9); a section that is blocked, locked or reported occupied refuses the route (R6).

**Theorem.**  As of witnesses: a run shows that what it ends with is reachable, and what a step of it did is what every
step does from that state with those inputs, since the controller is deterministic.  (Clarke, Grumberg and Peled,
*Model Checking*, 1999.)
"""

from __future__ import annotations

from collections.abc import Callable, Generator, Iterator
from functools import partial

from interlock.logic import names
from interlock.logic.plant import lies
from interlock.logic.symbols import RouteSymbols
from interlock.model.elements import Position, RouteId
from interlock.model.times import whole_ms
from interlock.proof.system.loop import ClosedLoop
from interlock.proof.witnesses.routes import (
    MAX_STEPS,
    Trial,
    _before,
    _closing,
    _rear,
    _start,
    _until,
    _until_off,
)
from interlock.sim.lanes import NOTHING, Driver, Lane, Lanes, Wish

Part = Generator[Wish, None, str | None]
"""A part of a run: what went wrong, or None."""


def operations(railway: ClosedLoop) -> dict[RouteId, dict[str, str | None]]:
    """For each route that a train can take from a stand: by operation what went wrong, or None where it worked."""
    lanes = Lanes(railway.controller, railway.plant)
    found: dict[RouteId, dict[str, str | None]] = {}
    for (r, name), failure in _tried(railway, lanes, _opening(railway, lanes)):
        found.setdefault(r, {})[name] = failure
    return found


def operated(railway: ClosedLoop) -> list[Trial]:
    """The runs by which operations work: those that went well."""
    lanes = Lanes(railway.controller, railway.plant)
    starts = _opening(railway, lanes)
    worked = {key for key, failure in _tried(railway, lanes, starts) if failure is None}
    return [
        Trial(f"{r.id}: {name}", start, partial(_after_restart, railway, r, operation))
        for name, operation in OPERATIONS.items()
        for r, start in starts
        if (r.id, name) in worked
    ]


Starts = list[tuple[RouteSymbols, dict[str, int]]]
"""Routes, each with a restart at which a train stands before its signal."""


def _opening(railway: ClosedLoop, lanes: Lanes) -> Starts:
    """The routes whose signal a train can be shown from a stand."""
    routes = [r for r in railway.controller.symbols.routes.whole if not r.call_on]
    starts = [(r, s) for r in routes if isinstance(s := _start(railway, r, ""), dict)]
    runs = [partial(_after_restart, railway, r, _opened) for r, _ in starts]
    tried = lanes.run([s for _, s in starts], runs)
    return [x for x, (failure, _) in zip(starts, tried, strict=True) if failure is None]


def _tried(railway: ClosedLoop, lanes: Lanes, starts: Starts) -> Iterator[tuple[tuple[RouteId, str], str | None]]:
    """What went wrong with each route and operation, or None."""
    for name, operation in OPERATIONS.items() if starts else ():
        runs = [partial(_after_restart, railway, r, operation) for r, _ in starts]
        for (r, _), (failure, _) in zip(starts, lanes.run([s for _, s in starts], runs), strict=True):
            yield (r.id, name), failure


def _after_restart(railway: ClosedLoop, r: RouteSymbols, operation: Operation, lane: Lane) -> Driver:
    closing = dict.fromkeys(_closing(railway, _before(railway, r)), 1)
    for _ in range(2):
        yield Wish((), {names.RELEASE_ALL: 1, **closing})
    failure = yield from operation(railway, r, lane)
    if failure is not None:
        return failure
    troubles = lane.troubles()
    return f"the run meets {', '.join(troubles)}" if troubles else None


def _asked(railway: ClosedLoop, r: RouteSymbols, **inputs: int) -> Wish:
    return Wish((), {railway.controller.symbols.requests.request: r.number, **inputs})


def _opened(railway: ClosedLoop, r: RouteSymbols, lane: Lane) -> Part:
    """Set, and open."""
    yield NOTHING
    if not (yield from _until(lane, r.active, _asked(railway, r), 2)):
        return "it cannot be set"
    exit_ = railway.topo.traversals[r.path.ways[-1][0]][r.path.ways[-1][1] - 1].exit
    token = railway.controller.symbols.token.get(exit_)
    if token is not None and not r.shunt and not lane.is_on(token.have):
        yield from _until(lane, token.have, Wish((), {token.manual: 1}), MAX_STEPS)
    return None if (yield from _until(lane, r.proceed)) else "its signal does not open"


def _refused(railway: ClosedLoop, r: RouteSymbols, lane: Lane) -> Part:
    """A section that is blocked, or reported occupied, refuses the route; then it is set."""
    sym = railway.controller.symbols
    for s, _ in r.path.ways:
        for name, value in ((sym.sections.blocked.get(s), 1), (sym.sections.clear.get(s), 0)):
            if name is not None:
                yield Wish((), {name: value})
                yield _asked(railway, r, **{name: value})
                yield Wish((), {name: value})
                if lane.is_on(r.active):
                    return f"it is set although {name} is {value}"
                if name == sym.sections.clear.get(s):
                    yield from _steadily_clear(railway, lane)
    return (yield from _opened(railway, r, lane))


def _steadily_clear(railway: ClosedLoop, lane: Lane) -> Generator[Wish, None, None]:
    """Until what is reported clear has been so for the release delay (R15)."""
    for _ in range(-(-whole_ms(railway.layout.principles.release_delay_s) // lane.lanes.dt_ms) + 1):
        yield NOTHING


def _reopened(railway: ClosedLoop, r: RouteSymbols, lane: Lane) -> Part:
    """A condition is lost and comes back: stop, until the route is asked for again."""
    failure = yield from _opened(railway, r, lane)
    if failure is not None:
        return failure
    lost = railway.controller.symbols.sections.blocked[r.path.ways[0][0]]
    yield Wish((), {lost: 1})
    for _ in range(3):
        yield NOTHING
        if lane.is_on(r.proceed):
            return "it opens again by itself"
    return None if (yield from _until(lane, r.proceed, _asked(railway, r), 2)) else "it does not open again"


def _trailed(railway: ClosedLoop, r: RouteSymbols, lane: Lane) -> Part:
    """A point of the route loses its detection: the route is kept back until somebody has looked at the point."""
    failure = yield from _opened(railway, r, lane)
    sym = railway.controller.symbols
    demands = [
        (m, x)
        for way in r.path.ways
        for m, x in sym.ways.demands[way]
        if m in sym.machines.trailed and lane.is_on(sym.machines.command[m, x])
    ]
    if failure is not None or not demands:
        return failure
    m, x = demands[0]
    yield Wish((), {sym.machines.detected[m, x]: 0})
    yield NOTHING
    if not lane.is_on(sym.machines.trailed[m]):
        return f"{m} does not count as trailed"
    yield _asked(railway, r)
    yield NOTHING
    if lane.is_on(r.proceed):
        return f"it opens over the trailed {m}"
    look = sym.machines.looked_at[m]
    yield Wish((), {look: 1})
    yield NOTHING
    if lane.is_on(sym.machines.trailed[m]):
        return f"{m} counts as trailed after somebody has looked at it"
    return None if (yield from _until(lane, r.proceed, _asked(railway, r), 2)) else "it does not open again"


def _cancelled(railway: ClosedLoop, r: RouteSymbols, lane: Lane) -> Part:
    """Cancelled by one touch, with a train before the signal: given back after the delay, and not before."""
    failure = yield from _opened(railway, r, lane)
    if failure is not None:
        return failure
    yield Wish((), {railway.controller.symbols.cancellation.cancel[r.entry]: 1})
    yield NOTHING
    if lane.is_on(r.proceed):
        return "its signal does not close"
    return (yield from _free(railway, r, lane, NOTHING))


def _by_hand(railway: ClosedLoop, r: RouteSymbols, lane: Lane) -> Part:
    """Inputs are lost while the train is in the route: its sections are given back by hand behind it."""
    failure = yield from _opened(railway, r, lane)
    if failure is not None:
        return failure
    sym, topo, layout = railway.controller.symbols, railway.topo, railway.layout
    signal = layout.signalling.signal[r.entry]
    if not (yield from _until(lane, names.accepted(r.entry, r.shunt), Wish((names.accepts(r.entry, r.shunt),)))):
        return "no train can accept the signal"
    place, joint = _rear(layout, topo, signal.node, r.path.ways[0][0]), signal.node
    ways = r.path.ways if r.path.berth is None else (*r.path.ways, r.path.berth)
    for section, number in ways:
        if not (yield from _until(lane, names.STANDS(section), Wish((names.HEAD(joint, place),)))):
            return f"the train cannot enter {section}"
        yield Wish((), {sym.valid: 0})
        if not (yield from _until_off(lane, names.ACROSS(joint, place), names.TAIL(joint, place))):
            return f"the train's tail does not leave {place}"
        place, joint = section, topo.traversals[section][number - 1].exit
    hands: dict[str, int] = {name: 1 for s, name in sym.sections.release.items() if s != place}
    yield Wish((), {sym.cancellation.cancel[r.entry]: 1})
    return (yield from _free(railway, r, lane, Wish((), hands), place))


def _free(railway: ClosedLoop, r: RouteSymbols, lane: Lane, wish: Wish, place: str = "") -> Part:
    """Nothing of the route stays locked but where the train is."""
    keep = {place, *railway.layout.track.undetected}
    for _ in range(MAX_STEPS):
        locked = [s for s, _ in r.path.ways if s in lane.held() and s not in keep]
        if not locked:
            return None
        yield wish
    return f"{', '.join(locked)} stay locked"


def _turned(railway: ClosedLoop, r: RouteSymbols, lane: Lane) -> Part:
    """Every point of the route is turned by hand and back before it is set; not both ways at once."""
    sym = railway.controller.symbols
    for way in r.path.ways:
        for m, x in sym.ways.demands[way]:
            if m not in sym.machines.trailed:  # a device, or a point without a machine
                continue
            yield Wish((), {sym.machines.by_hand[m, p]: 1 for p in Position})
            yield NOTHING
            if lane.is_on(sym.machines.command[m, x.other]):
                return f"{m} moves when both positions are asked for"
            for p in (x.other, x):
                if not (yield from _until(lane, lies(m, p).name, Wish((), {sym.machines.by_hand[m, p]: 1}), MAX_STEPS)):
                    return f"{m} is not moved {p} by hand"
                yield NOTHING
    return (yield from _opened(railway, r, lane))


Operation = Callable[[ClosedLoop, RouteSymbols, Lane], Part]

OPERATIONS: dict[str, Operation] = {
    "refused": _refused,
    "reopened": _reopened,
    "trailed": _trailed,
    "cancelled": _cancelled,
    "released by hand": _by_hand,
    "turned by hand": _turned,
}
"""By what they try."""
