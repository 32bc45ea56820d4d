"""How long a route takes from being asked for until its signal is open, while its conditions hold.

In one scan it is set, in the next its points are found as it needs them and it is locked, and in the third the signal
is open.  Where machines must move first they are commanded when it is set, and found in place one scan after they have
arrived.  A level crossing or bridge that has just begun to open by itself arrives there before it closes again.  With
staggered starts each machine after the first waits for its turn, those that the route drives along among them.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import ceil

from interlock.dataclass import dataclass
from interlock.logic import names
from interlock.logic.expr import variables
from interlock.logic.symbols import RouteSymbols, Symbols
from interlock.model.elements import MachineId, Position
from interlock.model.times import whole_ms
from interlock.proof.system.loop import ClosedLoop

SET, LOCKED, OPEN = 1, 2, 3


@dataclass(frozen=True)
class Opening:
    """Of one route: scans if every machine already lies as needed; scans and seconds if all of them must move; and the
    seconds for which the change of direction must be held where the direction of the line is not ours."""

    route: str
    machines: int
    scans: int
    at_most_scans: int
    seconds: float
    token_s: float

    @property
    def text(self) -> str:
        """In words."""
        text = f"{self.scans} scans"
        if self.machines:
            moved = "its machine moved" if self.machines == 1 else f"its {self.machines} machines moved"
            text += f"; {moved}, {self.at_most_scans} scans and {self.seconds:g} s"
        return f"{text}; with a change of direction {self.token_s:g} s more" if self.token_s else text


def opening(railway: ClosedLoop, r: RouteSymbols) -> Opening:
    """The bound of a route, computed from scans and machine times."""
    rules = railway.layout.principles
    needed = machines_of(railway, r)
    machines = len(needed)
    scans, seconds = OPEN, 0.0
    if machines:
        back = bool(needed & devices(railway))
        scans, seconds = OPEN + 1 + back, rules.point_run_s * (1 + back)
        if rules.point_start_gap_s > 0:  # a turn is given, the start seen, and the gap waited for
            turns = len(needed | along(railway, r))
            scans += 2 * turns - 1
            seconds += (turns - 1) * rules.point_start_gap_s
    exit_ = railway.topo.traversals[r.path.ways[-1][0]][r.path.ways[-1][1] - 1].exit
    token = exit_ in railway.controller.symbols.token and not r.shunt
    return Opening(r.id, machines, OPEN, scans, seconds, rules.token_delay_s if token else 0.0)


def demanded(symbols: Symbols, r: RouteSymbols, overlap: bool = True) -> Iterator[tuple[MachineId, Position]]:
    """The machines of a route with the positions in which it needs them: for its path, its flanks, what the author
    adds, and its overlap."""
    over = symbols.overlaps.ways[r.path.overlap] if overlap and r.path.overlap is not None else ()
    for way in (*r.path.ways, *over):
        yield from symbols.ways.demands[way]
    yield from r.path.demands


def machines_of(railway: ClosedLoop, r: RouteSymbols) -> set[MachineId]:
    """The machines that a route needs to lie somehow."""
    return {m for m, _ in demanded(railway.controller.symbols, r)}


def along(railway: ClosedLoop, r: RouteSymbols) -> set[MachineId]:
    """The machines beside its path that a route drives along, if they are free to move."""
    granted = {names.GRANTED(p.number) for p in railway.controller.symbols.routes.parts(r)}
    found = set()
    for e in railway.controller.equations:
        if e.name.family is names.DEMANDED:
            driven = [t.expr for t in e.terms if t.kind == "driven along"]
            if granted & set(variables(driven)):
                found.add(MachineId(str(e.name.at[0])))
    return found


def devices(railway: ClosedLoop) -> set[MachineId]:
    """Level crossings, bridges and other interlocks: what opens by itself."""
    return {d.id for d in railway.layout.signalling.devices}


def steps(
    railway: ClosedLoop, r: RouteSymbols, dt_ms: int, moved: int | None = None, after: RouteSymbols | None = None
) -> int:
    """The scans of a run, `dt_ms` apart, in which machines need no time to move, until the signal is open; `moved`: so
    many machines of those that it needs have to, else all; `after`: what that route drives along may wait before them.
    """
    needed = machines_of(railway, r)
    n = len(needed) if moved is None else moved
    gap_ms = whole_ms(railway.layout.principles.point_start_gap_s)
    if not n:
        return OPEN
    if gap_ms > 0:
        n += len((along(railway, r) | (along(railway, after) if after is not None else set())) - needed)
    back = bool(needed & devices(railway))
    return OPEN + 1 + back + (1 + (n - 1) * (2 + ceil(gap_ms / dt_ms)) if gap_ms > 0 else 0)
