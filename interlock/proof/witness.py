"""Witnesses: every route can be set, driven and released by a train, from a restart.

A claim about a controller that never opens a signal would hold and mean nothing; this run shows that each route
works, that the assumptions can be met, and that nothing stays locked behind the train (over-locking is invisible
to safety proofs).
"""

from __future__ import annotations

from dataclasses import dataclass

from interlock.logic.controller import RouteSymbols
from interlock.model.elements import MachineId, NodeId, Position, SectionId
from interlock.model.layout import Layout
from interlock.model.traversal import Topology
from interlock.proof.system import System
from interlock.sim.run import Simulator

MAX_STEPS = 400


@dataclass(frozen=True)
class Witness:
    """The outcome for one route: how far the run came, and how many scans it took."""

    route: str
    ok: bool
    steps: int
    text: str


def witnesses(system: System) -> tuple[Witness, ...]:
    """A run for each route."""
    sim = Simulator(system.controller, system.plant)
    return tuple(_drive(system, sim, r) for r in system.symbols.routes)


def _drive(system: System, sim: Simulator, r: RouteSymbols) -> Witness:
    """First with a train that has stood before the signal since the restart; if that is refused, with a train that
    came there under another route."""
    failure = _start(system, sim, r) or _run(system, sim, r)
    if failure is None and r.berth is not None:
        steps = sim.count
        failure = _start(system, sim, r, berth=r.berth[0]) or _run(system, sim, r)
        if failure is not None:
            return Witness(r.id, False, sim.count, f"with vehicles standing in {r.berth[0]}: {failure}")
        sim.count += steps
    if failure is None:
        return Witness(r.id, True, sim.count, "set, driven and released")
    rear = _rear(system.layout, system.topo, system.layout.signal[r.entry].node, r.ways[0][0])
    for before in system.symbols.routes:
        if (before.berth or before.ways[-1])[0] != rear:
            continue
        if (
            _start(system, sim, before) is None
            and _run(system, sim, before) is None
            and _run(system, sim, r, turning=rear) is None
        ):
            return Witness(r.id, True, sim.count, f"set, driven and released, coming over {before.id}")
    return Witness(r.id, False, sim.count, failure)


def _start(system: System, sim: Simulator, r: RouteSymbols, berth: str = "") -> str | None:
    """A restart with one train before the signal (and vehicles standing in a berth), every clear section released;
    says what is impossible."""
    node = system.layout.signal[r.entry].node
    state = _lying(system, r)
    standing = _stand(system, _rear(system.layout, system.topo, node, r.ways[0][0]), node)
    if standing is None:
        return f"no train can stand before {r.entry}"
    if any(state.get(name, value) != value for name, value in standing.items()):
        return f"a train before {r.entry} stands on points that the route needs otherwise"
    there = f"in.{berth}.{system.topo.ends[SectionId(berth)][0]}" if berth else ""
    parked = {f"o.{berth}": 1, f"rest.{berth}": 1, there: 1} if berth else {}
    sim.reset(state | standing | parked)
    sim.step((), {"RELALL": 1})
    sim.step((), {"RELALL": 1})
    return None


def _run(system: System, sim: Simulator, r: RouteSymbols, turning: str = "") -> str | None:
    """Set the route, drive it with the train before its signal, and wait for the release behind it."""
    layout, topo = system.layout, system.topo
    signal = layout.signal[r.entry]

    def until(wanted: str, events: tuple[str, ...] = (), request: int = 0, limit: int = 12) -> bool:
        for _ in range(limit):
            moves = [e for e in sim.possible() if e.startswith("arrive.") or _leaves(sim, e)]
            sim.step((*events, *moves), {system.symbols.request: request})
            if sim.is_on(wanted):
                return True
        return False

    if turning:
        turns = [e for e in sim.possible() if e.startswith(f"turn.{turning}.{signal.node}.")]
        sim.step(turns)
    if not until(r.active, request=r.number, limit=2):
        return "the request is refused: " + _not(sim, f"G_R{r.number}")
    if not until(r.proceed):
        return "the signal does not open: " + _not(sim, f"LK_R{r.number}")
    go, accept = ("gos", "accepts") if r.shunt else ("go", "accept")
    if not until(f"{go}.{r.entry}", (f"{accept}.{r.entry}",)):
        return "no train can accept the signal"
    place, joint = _rear(layout, topo, signal.node, r.ways[0][0]), signal.node
    ways = r.ways if r.berth is None else (*r.ways, r.berth)
    for section, number in ways:
        if not until(f"o.{section}", (f"head.{joint}.{place}",)):
            return f"the train cannot enter {section}"
        if not _until_off(sim, f"x.{joint}.{place}", f"tail.{joint}.{place}"):
            return f"the train's tail does not leave {place}"
        place, joint = section, topo.traversals[section][number - 1].exit
    leaves = joint in layout.boundary_at and not r.shunt
    if leaves:
        if not until(f"x.{joint}.{place}", (f"head.{joint}.{place}",)):
            return f"the train cannot leave at {joint}"
        if not _until_off(sim, f"o.{place}", f"tail.{joint}.{place}"):
            return f"the train's tail does not leave {place}"
    keep = set(layout.undetected) if leaves else {place, *layout.undetected}
    for _ in range(MAX_STEPS):
        left = [s for s in topo.sections if s not in keep and _held(system, sim, s)]
        if not left:
            break
        sim.step(())
    else:
        return f"{', '.join(left)} stay locked behind the train"
    if sim.hazards or sim.broken:
        return f"the run meets {', '.join(sim.hazards + sim.broken)}"
    return None


def _not(sim: Simulator, equation: str) -> str:
    return "; ".join("not " + t for t in sim.missing(equation)) or "a condition came and went"


def _lying(system: System, r: RouteSymbols) -> dict[str, int]:
    """Points as the route needs them, so that none has to move under the waiting train."""
    state: dict[str, int] = {}
    for way in r.ways:
        for m, x in system.symbols.demands[way]:
            state |= {f"at.{m}.N": int(x is Position.NORMAL), f"at.{m}.R": int(x is Position.REVERSE)}
    return state


def _held(system: System, sim: Simulator, s: SectionId) -> bool:
    names = [name for (sec, _), name in system.symbols.lock.items() if sec == s]
    return any(sim.is_on(n) for n in [system.symbols.restart[s], *names])


def _leaves(sim: Simulator, event: str) -> bool:
    """A machine leaves a position because it is commanded away."""
    if not event.startswith("start."):
        return False
    _, m, x = event.split(".")
    return sim.is_on(sim.controller.symbols.command[MachineId(m), Position(x).other])


def _until_off(sim: Simulator, name: str, event: str) -> bool:
    for _ in range(12):
        if not sim.is_on(name):
            return True
        sim.step((event,))
    return not sim.is_on(name)


def _rear(layout: Layout, topo: Topology, node: NodeId, first: SectionId) -> str:
    boundary = layout.boundary_at.get(node)
    if boundary is not None:
        return boundary.approach or f"outside.{node}"
    rear = topo.beyond(first, node)
    assert rear is not None
    return rear


def _stand(system: System, rear: str, node: NodeId) -> dict[str, int] | None:
    """A railway with one train at rest before the signal, points lying for it."""
    if rear not in system.topo.ends:
        return {f"o.{rear}": 1}
    for t in system.topo.traversals[SectionId(rear)]:
        if t.exit == node:
            state = {f"o.{rear}": 1, f"in.{rear}.{t.entry}": 1, f"rest.{rear}": 1}
            for p, x in t.points:
                m = system.layout.point[p].machine
                state |= {f"at.{m}.N": int(x is Position.NORMAL), f"at.{m}.R": int(x is Position.REVERSE)}
            return state
    return None
