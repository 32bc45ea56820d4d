"""What the variables of a controller mean: claims, plant, runtime and panel speak through these names alone.

Each record names the variables of one kind of element.  None of them is read by the controller itself.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import field, replace
from functools import cached_property

from interlock.dataclass import dataclass
from interlock.logic.expr import FALSE, Expr, conj, disj, eq, neg, var
from interlock.logic.names import Name
from interlock.model.elements import ConditionId, MachineId, NodeId, Position, RouteId, SectionId, SignalId

Way = tuple[SectionId, int]
"""A way through a section, by its number."""


@dataclass(frozen=True)
class StartSymbols:
    """Names of the start-up: the bit that tells that the program has run before, and the restart delay (R12)."""

    running: Name
    restart_timer: Name


@dataclass(frozen=True)
class SectionSymbols:
    """Names of sections: what is reported of each, its release delay, its locks, and what is remembered of the train
    for which it is locked; where its locks can be released by hand."""

    clear: Mapping[SectionId, Name]
    healthy: Mapping[SectionId, Name]
    blocked: Mapping[SectionId, Name]
    release: Mapping[SectionId, Name]
    release_all: Name
    release_timer: Mapping[SectionId, Name]
    restart: Mapping[SectionId, Name]
    lock: Mapping[Way, Name]
    train: Mapping[SectionId, Name]
    firm: Mapping[SectionId, Name]
    used: Mapping[SectionId, Name]
    passed: Mapping[SectionId, Name]
    stale: Mapping[SectionId, Name]

    @cached_property
    def locks_of(self) -> dict[SectionId, list[tuple[int, Name]]]:
        """The locks of each section: number and name."""
        out: dict[SectionId, list[tuple[int, Name]]] = {}
        for (s, n), name in self.lock.items():
            out.setdefault(s, []).append((n, name))
        return out

    @cached_property
    def locked_by(self) -> dict[SectionId, tuple[Name, ...]]:
        """The variables that lock each section: restart lock and locks."""
        return {s: (k, *(name for _, name in self.locks_of.get(s, ()))) for s, k in self.restart.items()}


@dataclass(frozen=True)
class WaySymbols:
    """What a lock of each way through a section demands and excludes; the ends of each section."""

    demands: Mapping[Way, tuple[tuple[MachineId, Position], ...]]
    excluded: Mapping[Way, tuple[tuple[SectionId, bool, tuple[int, ...]], ...]]
    ends: Mapping[SectionId, tuple[NodeId, ...]]


@dataclass(frozen=True)
class MachineSymbols:
    """Names of point machines and devices: detection, commands, what drives them, and when they are late."""

    detected: Mapping[tuple[MachineId, Position], Name]
    command: Mapping[tuple[MachineId, Position], Name]
    by_hand: Mapping[tuple[MachineId, Position], Name]
    drive: Mapping[tuple[MachineId, Position], Name]
    trailed: Mapping[MachineId, Name]
    was_detected: Mapping[tuple[MachineId, Position], Name]
    looked_at: Mapping[MachineId, Name]
    late_timer: Mapping[MachineId, Name]
    turn: Mapping[MachineId, Name]
    """Where machines start one after the other: it may run."""
    kept_off: Mapping[MachineId, Name]
    """The drive of a point is kept off."""
    started: Name | None
    start_timer: Name | None


@dataclass(frozen=True)
class LampProofSymbols:
    """Names of the inputs that prove lamps intact."""

    stop: Mapping[SignalId, Name]
    clear: Mapping[SignalId, Name]
    caution: Mapping[SignalId, Name]
    identifier: Mapping[SignalId, Name]
    second: Mapping[SignalId, Name]
    speed: Mapping[SignalId, Name]


@dataclass(frozen=True)
class AspectSymbols:
    """Names of the outputs that are lit at signals and distants."""

    clear: Mapping[SignalId, Name]
    caution: Mapping[SignalId, Name]
    second: Mapping[SignalId, Name]
    indicator: Mapping[SignalId, Name]
    call_on: Mapping[SignalId, Name]
    identifier: Mapping[SignalId, Name]
    shunt: Mapping[SignalId, Name]
    stop: Mapping[SignalId, Name]
    speed: Mapping[tuple[SignalId, int], Name]
    distant_clear: Mapping[SignalId, Name]
    distant_caution: Mapping[SignalId, Name]

    def proceed_lamps(self, g: SignalId, shunt: bool = False) -> tuple[Name, ...]:
        """The outputs at which a movement may pass a signal: a train (called on, or past an identifier light, too), or
        a shunting movement."""
        trains = (self.clear, self.caution, self.call_on, self.identifier)
        aspects = (self.shunt,) if shunt else trains
        return tuple(aspect[g] for aspect in aspects if g in aspect)

    def main_lamps(self, g: SignalId) -> tuple[Name, ...]:
        """The outputs that show clear or caution at a main signal."""
        return tuple(aspect[g] for aspect in (self.clear, self.caution) if g in aspect)

    def signal(self, g: SignalId, shunt: bool = False) -> Expr:
        """Whether a movement may pass a signal, by its lamps: a train (called on, or past an identifier light, too), or
        a shunting movement."""
        return disj(var(name) for name in self.proceed_lamps(g, shunt))

    def identifies(self, g: SignalId) -> Expr:
        """Whether a signal shows its identifier light."""
        return var(self.identifier[g]) if g in self.identifier else FALSE


def lamps(a: AspectSymbols) -> Iterator[Name]:
    """The outputs that are lit at signals and distants, stop lamps among them; not the speeds."""
    for aspect in (a.clear, a.caution, a.second, a.indicator, a.call_on, a.shunt, a.stop, a.identifier):
        yield from aspect.values()
    yield from (*a.distant_clear.values(), *a.distant_caution.values())


@dataclass(frozen=True)
class CancelSymbols:
    """Names of cancellation and approach locking (R8), by the signal at which routes begin; `approach_of`: the section
    in rear of it; `rear_cleared`: by the first section behind a signal, that a movement was seen to have come
    in, `alone`: the timer that tells by its order, and `at_once`: that it was read occupied in the scan in which
    what is ahead was, too (R9)."""

    cancel: Mapping[SignalId, Name]
    cancelling: Mapping[SignalId, Name]
    approach_timer: Mapping[SignalId, Name]
    approach_of: Mapping[SignalId, SectionId | None]
    rear_cleared: Mapping[SectionId, Name]
    alone: Mapping[SectionId, Name]
    at_once: Mapping[SectionId, Name]


@dataclass(frozen=True)
class OverlapSymbols:
    """Names of overlaps (R4): each alternative that is held, and over which ways it lies; of a signal's overlaps, that
    one is firm, that the train before it stands, that it swings, and the number that asks for it."""

    held: Mapping[tuple[SignalId, int], Name]
    ways: Mapping[tuple[SignalId, int], tuple[Way, ...]]
    firm: Mapping[SignalId, Name]
    timer: Mapping[SignalId, Name]
    swings: Mapping[SignalId, Name]
    swing_request: Mapping[SignalId, int]


@dataclass(frozen=True)
class BlockSymbols:
    """Names of a line's direction token: the neighbour asks, gives, gives not, has; the line is clear; the manual
    change; the token is here, is given, its last change is complete; the delay of the manual change; the outputs that
    tell the neighbour (`asks`, `gives`, `keeps`, `has`)."""

    asks: Name
    gives: Name
    keeps: Name
    has: Name
    clear: Name
    manual: Name
    have: Name
    give: Name
    seen: Name
    timer: Name
    tells: Mapping[str, Name] = field(default_factory=dict, kw_only=True)


@dataclass(frozen=True)
class RoutePath:
    """Where a route leads, and what it locks."""

    ways: tuple[Way, ...]
    berth: Way | None
    overlap: tuple[SignalId, int] | None
    identifier: bool = False
    """Its signal shows its identifier light, for a train that passes it under a route that leads past it."""
    onward: int | None = None
    """The number of the route, of kind identifier, that is set with it past the signal at its end."""
    parts_of: tuple[int, ...] = ()
    """The numbers of the routes that lead past its signal, on over it: it is set with one of them, never alone."""
    barred: tuple[int, ...] = ()
    """Numbers of the routes that the author declares hostile."""
    demands: tuple[tuple[MachineId, Position], ...] = ()
    """Machines that the author has it lock."""
    hold_timer: Name | None = None
    """The timer that runs while it holds longer what the author has added to it, and is not under way any more."""
    hold_begun: Name | None = None
    """That timer runs, whatever others lock: it would have let go what the author has added to it."""


@dataclass(frozen=True)
class RouteSymbols:
    """A route, and the names of its variables."""

    id: RouteId
    number: int
    names: tuple[str, ...]
    """Names that the author gives to it, beside its id."""
    entry: SignalId
    shunt: bool
    call_on: bool
    path: RoutePath
    active: Name
    locked: Name
    want: Name
    proceed: Name
    shown: Name
    passing: Name | None = None
    added: Name | None = None
    """The variable that tells that it holds what the author has added to it: hostile routes and points."""

    @property
    def open_while(self) -> tuple[Name, ...]:
        """The variables while which the signal is open for this route."""
        return (self.proceed,) if self.passing is None else (self.proceed, self.passing)


class Routes(tuple[RouteSymbols, ...]):
    """The routes of a controller in the order of the table, and found by what they are asked for."""

    @cached_property
    def over(self) -> dict[Way, list[RouteSymbols]]:
        """The routes that lock each way, or end in it as a berth."""
        out: dict[Way, list[RouteSymbols]] = {}
        for r in self:
            for way in dict.fromkeys((*r.path.ways, *([r.path.berth] if r.path.berth is not None else []))):
                out.setdefault(way, []).append(r)
        return out

    @cached_property
    def number(self) -> dict[int, RouteSymbols]:
        """Routes by number."""
        return {r.number: r for r in self}

    @cached_property
    def of_signal(self) -> dict[SignalId, list[RouteSymbols]]:
        """The routes of each signal."""
        out: dict[SignalId, list[RouteSymbols]] = {}
        for r in self:
            out.setdefault(r.entry, []).append(r)
        return out

    @cached_property
    def whole(self) -> tuple[RouteSymbols, ...]:
        """Routes as trains run over them: one that leads past a signal with what it locks beyond it, which is no route
        by itself."""
        out = []
        for r in self:
            if r.path.identifier:
                continue
            parts = [p.path for p in self.parts(r)]
            ways, demands = tuple(w for p in parts for w in p.ways), tuple(m for p in parts for m in p.demands)
            path = replace(r.path, ways=ways, overlap=parts[-1].overlap, demands=demands)
            out.append(r if len(parts) == 1 else replace(r, path=path))
        return tuple(out)

    def parts(self, r: RouteSymbols) -> tuple[RouteSymbols, ...]:
        """A route, and what is set with it past one signal after the other."""
        return (r,) if r.path.onward is None else (r, *self.parts(self.number[r.path.onward]))

    def set_with(self, r: RouteSymbols) -> tuple[RouteSymbols, ...]:
        """All that is set with a route of kind identifier and lies before it, back to the routes that are asked for."""
        those = (self.number[n] for n in r.path.parts_of)
        return tuple({y.number: y for x in those for y in (x, *self.set_with(x))}.values())

    def opened(self, g: SignalId, shunt: bool = False) -> Expr:
        """Whether the controller has opened a signal for one of its routes: state, not yet a lamp."""
        return self._opened.get((g, shunt), FALSE)

    @cached_property
    def _opened(self) -> dict[tuple[SignalId, bool], Expr]:
        open_: dict[tuple[SignalId, bool], list[Expr]] = {}
        for r in self:
            open_.setdefault((r.entry, r.shunt), []).extend(var(name) for name in r.open_while)
        return {who: disj(xs) for who, xs in open_.items()}

    def passing(self, g: SignalId, shunt: bool = False) -> Expr:
        """Whether a signal is still open for a movement that has begun to pass it."""
        routes = self.of_signal.get(g, ())
        return disj(var(r.passing) for r in routes if r.shunt is shunt and r.passing is not None)

    def opens(self, g: SignalId, shunt: bool = False) -> Expr:
        """Whether a signal is open for a movement before it, other than by calling a train on."""
        own = (r for r in self.of_signal.get(g, ()) if not r.call_on and not r.path.identifier)
        return disj(var(r.proceed) for r in own if r.shunt is shunt)

    def called(self, g: SignalId) -> Expr:
        """Whether a signal calls a train on."""
        return disj(var(r.proceed) for r in self.of_signal.get(g, ()) if r.call_on)


def asked_of(inputs: tuple[Name, ...], number: int, fresh: Mapping[Name, Name]) -> Expr:
    """A number is newly asked for at one of some inputs, of which the first that asks is heard; 0: at none of them.

    `fresh`: by input, the bit that tells that it read 0 in the last scan.  An input that holds its value asks once.
    """
    quiet = [disj((eq(x, 0), neg(var(fresh[x])))) for x in inputs]
    if not number:
        return conj(quiet)
    return disj(conj((*quiet[:i], var(fresh[x]), eq(x, number))) for i, x in enumerate(inputs))


@dataclass(frozen=True)
class RequestSymbols:
    """Names of the requests by hand: from the control centre and on the spot (`local_first`: that is heard first), the
    bits that tell that each asks anew and has been seen; the switches for automatic working, by route number."""

    request: Name
    local_request: Name | None
    local_first: bool
    fresh: Mapping[Name, Name]
    seen: Mapping[Name, Name]
    automatic: Mapping[int, Name]

    def asked(self, number: int) -> Expr:
        """A route number (0: none) is newly asked for by hand, from the control centre or on the spot."""
        if self.local_request is None:
            return asked_of((self.request,), number, self.fresh)
        order = (self.request, self.local_request)
        return asked_of(order[::-1] if self.local_first else order, number, self.fresh)

    def asked_for(self, r: RouteSymbols, routes: Routes) -> Expr:
        """A route is newly asked for by hand: what lies past a signal with a route that leads past it."""
        by = (x for x in routes.set_with(r) if not x.path.identifier)
        return disj(self.asked(x.number) for x in by) if r.path.identifier else self.asked(r.number)


@dataclass(frozen=True)
class Symbols:
    """What the variables of a controller mean, by what they belong to."""

    valid: Name
    """All inputs are valid in this scan."""
    start: StartSymbols
    requests: RequestSymbols
    routes: Routes
    sections: SectionSymbols
    ways: WaySymbols
    machines: MachineSymbols
    aspects: AspectSymbols
    lamp_proof: LampProofSymbols
    cancellation: CancelSymbols
    overlaps: OverlapSymbols
    token: Mapping[NodeId, BlockSymbols]
    condition: Mapping[ConditionId, Name]
    zone_full: Mapping[str, Name]
    indication: Mapping[str, Name]
    """What tells an operator something: the output by what it is about (`locked S`, `late M`, ...)."""
