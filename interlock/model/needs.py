"""The times that the world needs, in milliseconds: what the presets of the controller's timers are compared with.

A train that saw proceed when a signal went to stop has stood still or passed the signal after the output's delay, the
driver's reaction and the time of a brake application from the highest speed anywhere in the approach, v / b: he may
have been told far away, where trains run faster than before the signal.  That holds whether it stops in rear of the
signal or not, so it needs no length (R8).  The same time from the speed in the section before a signal, counted from
when a train is wholly in it, brings it to a stand there (R4).
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from fractions import Fraction
from math import ceil, isqrt

from interlock.dataclass import dataclass
from interlock.model.approach import TooManyWays, approach
from interlock.model.elements import BoundaryKind, MachineId, Position, SectionId, SignalId
from interlock.model.farthest import farthest
from interlock.model.layout import Layout
from interlock.model.overlap import overlap_paths, through
from interlock.model.principles import Principles
from interlock.model.times import stated, supervision_s, whole_ms
from interlock.model.traversal import Topology, Traversal, topology

PLACES = 10_000
"""So many places are looked at from where trains may come to one signal."""


@dataclass(frozen=True, slots=True)
class Needs:
    """Least times, in milliseconds.

    stop: by signal, until a train that was told of it has passed it or stands once stop is shown without a break.
    shunt: the same for shunting movements, anywhere.  stand: by signal, until a train wholly in the section before it
    stands.  arrive: by main signal without overlap at the end of a berth, the same, if that train runs on to the signal
    (`arrival`).  agreed: how long the hand of the special manual change of direction is held, as agreed by telephone.
    run: the running time of a point machine.  restart: until whatever ran at a power cut stands.  swings: the signals
    with an overlap that swings of which a train cannot come through the section before them while the points of the
    overlap turn, which may take until supervision ends.
    """

    stop: Mapping[SignalId, int]
    shunt: int
    stand: Mapping[SignalId, int]
    arrive: Mapping[SignalId, int]
    agreed: int
    run: int
    restart: int
    swings: frozenset[SignalId]


@dataclass(frozen=True, slots=True)
class Passage:
    """How fast a train may run through a section, or an approach: in metres, over its shortest way at its speed."""

    section: SectionId
    metres: float
    kmh: float

    @property
    def seconds(self) -> float:
        """The least time from when its head comes in until it leaves."""
        return self.metres / (self.kmh / 3.6)


def passages(layout: Layout) -> Iterator[Passage]:
    """The fastest passage of each section that is reported, approaches too; none over a way that ends at a buffer."""
    line = layout.principles.line_speed_kmh
    for s, ways in topology(layout).traversals.items():
        through = [t for t in ways if not {t.entry, t.exit} & layout.track.buffer_at.keys()]
        if s not in layout.track.undetected and through:
            yield min((_passage(layout, t, line) for t in through), key=lambda x: x.seconds)
    for b in layout.track.boundaries:
        if b.approach is not None and b.kind is not BoundaryKind.OUT:
            yield Passage(b.approach, b.approach_m, line)


def _passage(layout: Layout, t: Traversal, line: float) -> Passage:
    """At the section's speed, or at that of reversed points where it is lower."""
    own = layout.track.section[t.section].speed if t.section in layout.track.section else None
    over = [layout.pointwork.point[p].speed for p, x in t.points if x is Position.REVERSE]
    kmh = min([line if own is None else float(own), *(float(v) for v in over if v is not None)])
    return Passage(t.section, sum(layout.track.edge[e].length for e in t.edges), kmh)


def halt_ms(rules: Principles, kmh: float) -> int:
    """From the command of stop until a train that runs at so many km/h stands: delay, reaction, braking."""
    braking = stated(kmh) / Fraction(18, 5) / stated(rules.braking_ms2)
    return whole_ms(stated(rules.output_delay_s) + stated(rules.reaction_s) + braking)


def needs(layout: Layout) -> Needs:
    """The least times of a layout, from its speeds and principles."""
    rules = layout.principles
    signals = [g.id for g in layout.signalling.signals]
    return Needs(
        stop={g: halt_ms(rules, told_at(layout, g)) for g in signals},
        shunt=halt_ms(rules, rules.shunt_speed_kmh),
        stand={g: halt_ms(rules, _speed(layout, _rear(layout, g))) for g in signals},
        arrive=arrival(layout),
        agreed=whole_ms(rules.token_agreed_s),
        run=whole_ms(rules.point_run_s),
        restart=_restart(layout),
        swings=frozenset(o.signal for o in layout.overlaps.all if o.swing and _turns_in_time(layout, o.signal)),
    )


def _rear(layout: Layout, g: SignalId) -> SectionId | None:
    """The section, or approach, in rear of a signal."""
    signal = layout.signalling.signal[g]
    boundary = layout.track.boundary_at.get(signal.node)
    if boundary is not None:
        return boundary.approach
    rear = [layout.track.section_of(e.id) for e in layout.track.edges_at[signal.node] if e.id != signal.into]
    return rear[0] if rear else None


def told_at(layout: Layout, g: SignalId) -> float:
    """The highest speed (km/h) at which a train may run that was told that a signal is open: of its whole approach,
    where a driver begins to brake for a stop that he is told of, the section in rear of it first (R8)."""
    rear = _speed(layout, _rear(layout, g))
    if not layout.signalling.signal[g].main:
        return rear
    try:
        found = approach(layout, g, PLACES)
    except TooManyWays:  # the highest speed anywhere; such a layout is refused anyway (IL3049)
        return max(_speed(layout, s) for s in (None, *layout.track.section))
    return max([rear, _speed(layout, None) if found.blind else 0.0, *(_speed(layout, s) for s in found.sections())])


def _speed(layout: Layout, section: SectionId | None) -> float:
    """The highest speed (km/h) in a section, or on an approach."""
    stated = layout.track.section[section].speed if section is not None and section in layout.track.section else None
    return layout.principles.line_speed_kmh if stated is None else float(stated)


def _restart(layout: Layout) -> int:
    """Until every train stands that ran at a power cut: all signals show stop, so that it runs to the next one it meets
    at most, at half the highest speed at least, and brakes there."""
    rules, topo = layout.principles, topology(layout)
    ways = {t.key: t for s in topo.sections for t in topo.traversals[s]}
    metres = farthest({k: exact_m(layout, t) for k, t in ways.items()}, {k: _on(topo, t) for k, t in ways.items()})
    fastest = max([rules.line_speed_kmh, *(float(s.speed) for s in layout.track.sections if s.speed is not None)])
    return halt_ms(rules, fastest) + whole_ms(through(metres, rules.line_speed_kmh))


def _on(topo: Topology, t: Traversal) -> list[tuple[SectionId, int]]:
    """The ways that go on from one where no main signal stands."""
    ahead = topo.beyond(t.section, t.exit)
    if ahead is None or (t.exit, ahead) in topo.main_into:
        return []
    return [x.key for x in topo.through(ahead, t.exit)]


def exact_m(layout: Layout, t: Traversal) -> Fraction:
    """The metres of a way, as they were stated."""
    return sum((stated(layout.track.edge[e].length) for e in t.edges), Fraction(0))


def _ways_to(layout: Layout, g: SignalId) -> tuple[SectionId, list[float]] | None:
    """The section before a signal, and the metres of each way through it to the signal; None at a boundary."""
    signal, topo = layout.signalling.signal[g], topology(layout)
    section = topo.beyond(layout.track.section_of(signal.into), signal.node)
    return None if section is None else (section, [t.length for t in topo.traversals[section] if t.exit == signal.node])


def before(layout: Layout, g: SignalId) -> Passage | None:
    """The shortest way through the section before a signal, at the highest speed there; None at a boundary."""
    found = _ways_to(layout, g)
    return None if found is None else Passage(found[0], min(found[1], default=0.0), _speed(layout, found[0]))


def standing_s(layout: Layout, g: SignalId) -> float:
    """How long a train is in the section before a signal, until it stands there: one that comes in at the highest
    speed, runs its longest way and brakes as late as it can (R4); 0 at a boundary."""
    found = _ways_to(layout, g)
    if found is None:
        return 0.0
    metres, speed = max(found[1], default=0.0), _speed(layout, found[0]) / 3.6
    braking = layout.principles.braking_ms2
    if metres < speed**2 / (2 * braking):  # it has begun to brake before
        return float((2 * metres / braking) ** 0.5)
    return metres / speed + speed / (2 * braking)


def arrival(layout: Layout) -> dict[SignalId, int]:
    """Milliseconds until a train stands that has come wholly into a berth and is to stop before a main signal at its
    end that has no overlap: it may still run through all of it at the highest speed there, and brake as late as it can
    (R2).  Of a signal with an overlap that is what `overlap_release_s` is for, and what is said of it (R4)."""
    overlapped = {o.signal for o in layout.overlaps.all}
    found = {}
    for g in (x.id for x in layout.signalling.signals if x.main and x.id not in overlapped):
        way = _ways_to(layout, g)
        if way is not None and way[0] in topology(layout).berths:
            found[g] = max(halt_ms(layout.principles, _speed(layout, way[0])), _running_ms(layout, g, way[0]))
    return found


def _running_ms(layout: Layout, g: SignalId, before: SectionId) -> int:
    """The same time as `standing_s`, of numbers as they are stated, rounded up."""
    node, braking = layout.signalling.signal[g].node, stated(layout.principles.braking_ms2)
    ways = (exact_m(layout, t) for t in topology(layout).traversals[before] if t.exit == node)
    metres, speed = max(ways, default=Fraction(0)), stated(_speed(layout, before)) / Fraction(18, 5)
    if metres >= speed**2 / (2 * braking):
        return whole_ms(metres / speed + speed / (2 * braking))
    squared = 2 * metres / braking * 1_000_000
    return isqrt(max(ceil(squared) - 1, 0)) + (squared > 0)


def turning_s(layout: Layout, g: SignalId) -> float:
    """How long what lies in the overlaps of a signal, or over them, may turn once they swing: the output's delay and
    the longest supervision of these machines."""
    ways = [t for path in overlap_paths(layout, g) for t in path]
    over = {MachineId(d.id) for d in layout.signalling.devices if any(t.section in d.over for t in ways)}
    machines = over | {layout.pointwork.point[p].machine for t in ways for p, _ in t.points}
    rules = layout.principles
    return rules.output_delay_s + max((supervision_s(layout, m) for m in machines), default=rules.point_supervision_s)


def _turns_in_time(layout: Layout, g: SignalId) -> bool:
    """No train comes through the section before a signal while points that were commanded before it came in turn.

    With `point_start_gap_s` a machine may wait for others to start, and begin to turn before a train that has come in.
    """
    way = before(layout, g)
    return layout.principles.point_start_gap_s <= 0 and way is not None and way.seconds >= turning_s(layout, g)
