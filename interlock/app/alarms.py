"""Every alarm that there can be, and those that stand: what a panel shows, a record holds and a SCADA reads.

`possible` lists them for a layout; nothing else is an alarm.  A `Watch` says after each scan which of them stand.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping

from interlock.dataclass import dataclass
from interlock.diag.called import called
from interlock.field.plc import LATE_CYCLE, Cycle
from interlock.logic.cabinet import Allocation
from interlock.logic.controller import Controller
from interlock.logic.names import Name
from interlock.logic.symbols import RouteSymbols, Symbols
from interlock.model.elements import DeviceKind, MachineId, Position, SectionId, SignalId
from interlock.model.layout import Layout
from interlock.model.portable import portable
from interlock.model.times import supervision_s, whole_ms

Causes = dict[str, tuple[str, tuple[str, ...]]]
"""By key: what is wrong, and the elements that it is about."""

SETTLES_MS = 1000
"""Milliseconds after a start in which heartbeats are not yet missed."""

CLOSED_LONG_S = 300
"""Seconds for which a level crossing is closed to its road before that is an alarm (our choice): people who wait longer
at an open line walk or drive round barriers, and what keeps it closed, a train that waits within a route, is for the
operator to find."""

START, HAZARD, RECORD, TRAIN, LOST, CYCLE, FALLEN = "start", "hazard", "record", "train", "lost", "cycle", "fallen"
"""Keys, or what they begin with."""


@dataclass(frozen=True)
class Possible:
    """An alarm that there can be: its key, its variable for a SCADA, what is wrong, and the elements that it is about.
    `is_so`: whether it stands after a scan; None where more is asked than one scan."""

    key: str
    variable: str
    text: str
    at: tuple[str, ...] = ()
    is_so: Callable[[Cycle], bool] | None = None


def possible(layout: Layout, controller: Controller, allocation: Allocation) -> tuple[Possible, ...]:
    """All of them: of the controller and its operator's place, of substations, machines, signals, and sections."""
    y = controller.symbols
    found = [
        Possible(START, "ALARM_START", "the controller has started, and sections are locked until they are released"),
        Possible(HAZARD, "ALARM_HAZARD", "the bystander of a simulated railway has seen harm"),
        Possible(RECORD, "ALARM_RECORD", "the panel's record cannot be written"),
        Possible(TRAIN, "ALARM_TRAIN", "the number of a train is in doubt"),
        Possible(CYCLE, "ALARM_CYCLE", "a cycle came too late"),
    ]
    for s in allocation.stations:
        found.append(Possible(f"{LOST} {s}", f"ALARM_LOST_{portable(s)}", f"substation {s} is lost"))
    found += [x for m in layout.machines for x in _of_machine(layout, y, m)]
    found += _of_lamps(y)
    for g in y.routes.of_signal:
        text = f"{called('signal', g)} has returned to stop, and has not opened since"
        found.append(Possible(f"{FALLEN} {g}", f"ALARM_FALLEN_{portable(g)}", text, (f"g:{g}",)))
    for s, name in y.sections.healthy.items():
        text = f"the detector of {called('section', s)} is out of order"
        found.append(Possible(f"detector {s}", f"ALARM_DETECTOR_{portable(s)}", text, (f"s:{s}",), _missing(name)))
    return tuple(found)


def to_release(layout: Layout, symbols: Symbols) -> dict[SectionId, Name]:
    """The restart locks of the sections that an operator releases after a restart.  A section without detection counts
    as occupied for ever: it is never released, and shunting movements end in it all the same."""
    return {s: n for s, n in symbols.sections.restart.items() if s not in layout.track.undetected}


def listed(alarms: Iterable[Possible]) -> list[tuple[str, str, str]]:
    """Key, variable and meaning of each."""
    return [(p.key, p.variable, p.text) for p in alarms]


def _of_machine(layout: Layout, y: Symbols, m: MachineId) -> Iterator[Possible]:
    """What can be wrong with a machine."""
    late, trailed, at = y.indication.get(f"late {m}"), y.machines.trailed.get(m), (f"m:{m}",)
    if late is not None:
        text = layout.machines.undetected(m)
        if m not in layout.machines.device:
            it = "it is" if layout.machines.is_derailer(m) else "they are"
            text = f"{_not_detected(layout, m)} where {it} commanded"
        yield Possible(f"late {m}", f"ALARM_LATE_{portable(m)}", text, at, lambda c: bool(c.outputs.get(late)))
    if trailed is not None:
        text = f"{layout.machines.named(m)} were trailed: look at them"
        if layout.machines.is_derailer(m):
            text = f"{layout.machines.named(m)} was run over, or has lost its detection where it lay: look at it"
        yield Possible(
            f"trailed {m}", f"ALARM_TRAILED_{portable(m)}", text, at, lambda c: bool(c.memory.state.get(trailed))
        )
    yield Possible(f"idle {m}", f"ALARM_IDLE_{portable(m)}", _idle(layout, m), at)
    if _is_crossing(layout, m):
        yield Possible(f"closed {m}", f"ALARM_CLOSED_{portable(m)}", _closed_long(layout, m), at)


def _is_crossing(layout: Layout, m: MachineId) -> bool:
    """Whether people at a road wait while it is closed."""
    device = layout.machines.device.get(m)
    return device is not None and device.kind is DeviceKind.LEVEL_CROSSING


def _closed_long(layout: Layout, m: MachineId) -> str:
    """What is said of a level crossing whose road waits."""
    return f"{layout.machines.named(m)} has been closed to its road for more than {CLOSED_LONG_S // 60} minutes"


def _idle(layout: Layout, m: MachineId) -> str:
    """What is said of a machine that nobody has commanded."""
    if m in layout.machines.device:
        words = " nor ".join(layout.machines.word(m, x) for x in Position)
        return f"{layout.machines.named(m)} is proved neither {words}, and was not commanded"
    were = "was" if layout.machines.is_derailer(m) else "were"
    return f"{_not_detected(layout, m)}, and {were} not commanded"


def _not_detected(layout: Layout, m: MachineId) -> str:
    """`points 2 are not detected`, `derailer Gs1 is not detected`."""
    return f"{layout.machines.named(m)} {'is' if layout.machines.is_derailer(m) else 'are'} not detected"


def _of_lamps(y: Symbols) -> Iterator[Possible]:
    """Lamps that are out."""
    lamps = y.lamp_proof
    for word, of in (("stop", lamps.stop), ("clear", lamps.clear), ("caution", lamps.caution)):
        for g, name in of.items():
            yield _lamp(word, g, name)
    for g, name in lamps.identifier.items():
        yield _lamp("identifier", g, name)
    for g, name in lamps.second.items():
        yield _lamp("second yellow", g, name)
    for g, name in lamps.speed.items():
        yield Possible(
            f"speed indicator {g}",
            f"ALARM_SPEED_LAMP_{portable(g)}",
            f"the speed indicator of {g} is out",
            (f"g:{g}",),
            _missing(name),
        )


def _lamp(word: str, g: str, proof: str) -> Possible:
    variable = f"ALARM_{word.upper().replace(' ', '_')}_LAMP_{portable(g)}"
    return Possible(f"{word} lamp {g}", variable, f"the {word} lamp of {g} is out", (f"g:{g}",), _missing(proof))


def _missing(name: str) -> Callable[[Cycle], bool]:
    """An input that says that something is well does not say so, though the inputs are valid."""
    return lambda c: c.valid and not c.inputs.get(name, 0)


@dataclass(frozen=True)
class Fallen:
    """A signal that has closed before its train came, without being cancelled: its route, and what is said of it."""

    route: RouteSymbols
    text: str
    at: tuple[str, ...]


class Watch:
    """Which alarms stand, scan by scan, from a start of the controller on."""

    def __init__(self, layout: Layout, controller: Controller, allocation: Allocation) -> None:
        self._symbols = controller.symbols
        self.possible = possible(layout, controller, allocation)
        self._start = next(p for p in self.possible if p.key == START)
        self._restart = to_release(layout, controller.symbols)
        self._idle = Idle(layout, controller.symbols)
        self._closed_long = ClosedLong(layout, controller.symbols)
        self._fallen: dict[SignalId, Fallen] = {}
        self._before: Mapping[str, bool] = {}
        self._read: Mapping[str, int] = {}
        self._ran_ms = 0
        self.settled = False
        """The controller runs long enough that a missing heartbeat means something."""
        self.causes: Causes = {}
        """What is wrong now."""
        self.past: Causes = {}
        """What has happened and is not over: a start, signals that have closed by themselves."""

    @property
    def idle(self) -> Causes:
        """Machines that are not detected, though nobody has commanded them, from the first scan on."""
        return self._idle.causes

    def after(self, cycle: Cycle, dt_ms: int) -> list[Fallen]:
        """A scan has ended, `dt_ms` milliseconds after the one before; the signals that have closed in it."""
        fallen = list(self._closed(cycle))
        state = cycle.memory.state
        self._idle.after(cycle, dt_ms)
        self._closed_long.after(cycle, dt_ms)
        self._ran_ms += dt_ms
        self.settled = self._ran_ms > SETTLES_MS
        if self.settled:
            self.causes = self._lost(cycle) | self._idle.causes | self._closed_long.causes
            self.causes |= {p.key: (p.text, p.at) for p in self.possible if p.is_so is not None and p.is_so(cycle)}
        self.past = {f"{FALLEN} {g}": (x.text, x.at) for g, x in self._fallen.items()}
        if any(state.get(n) for n in self._restart.values()):
            self.past[START] = (self._start.text, ())
        self._before, self._read = state, cycle.inputs
        return fallen

    def _lost(self, cycle: Cycle) -> Causes:
        """Substations that do not answer, and a cycle that came too late."""
        found: Causes = {}
        for text in cycle.lost:
            what = text.partition(":")[0]
            key, said = (CYCLE, text) if what == LATE_CYCLE else (f"{LOST} {what}", f"substation {text}")
            found[key] = (said, ())
        return found

    def _closed(self, cycle: Cycle) -> Iterator[Fallen]:
        was, now, cancelling = self._before, cycle.memory.state, self._symbols.cancellation.cancelling
        for r in self._symbols.routes:
            if now.get(r.proceed):
                self._fallen.pop(r.entry, None)
            elif was.get(r.proceed) and now.get(r.active) and not now.get(cancelling[r.entry]):
                if self._passed(r, cycle):
                    continue
                found = Fallen(r, f"{called('signal', r.entry)} has returned to stop", (f"g:{r.entry}",))
                self._fallen[r.entry] = found
                yield found

    def _passed(self, r: RouteSymbols, cycle: Cycle) -> bool:
        """The train that a signal has called on passes it: its first section becomes occupied, while what lies before
        the signal is.  Nothing in the controller tells it, since there is no detection that is relied on (R2)."""
        if not r.call_on or not cycle.valid:
            return False
        clear = self._symbols.sections.clear
        first, rear = r.path.ways[0][0], self._symbols.cancellation.approach_of.get(r.entry)
        comes = first in clear and bool(self._read.get(clear[first])) and not cycle.inputs.get(clear[first])
        return comes and (rear is None or rear not in clear or not cycle.inputs.get(clear[rear]))


class Idle:
    """Machines that nobody has commanded since the restart and that are not detected: the controller supervises what it
    commands, and these are supervised here for as long (R10)."""

    def __init__(self, layout: Layout, symbols: Symbols) -> None:
        y = symbols.machines
        self._machines = [
            (
                str(m),
                _idle(layout, m),
                whole_ms(supervision_s(layout, m)),
                tuple(y.detected[m, x] for x in Position if (m, x) in y.detected),
                tuple(y.command[m, x] for x in Position if (m, x) in y.command),
            )
            for m in layout.machines
        ]
        self._lost_ms: dict[str, int] = {}
        self.causes: Causes = {}
        """By key: what is not detected for longer than the supervision time."""

    def after(self, cycle: Cycle, dt_ms: int) -> None:
        """A cycle has ended, `dt_ms` milliseconds after the one before."""
        self.causes = {}
        for m, text, allowed_ms, contacts, commands in self._machines:
            lies = sum(bool(cycle.inputs.get(n)) for n in contacts) == 1
            if not cycle.valid or lies or any(cycle.memory.state.get(n) for n in commands):
                self._lost_ms.pop(m, None)
                continue
            self._lost_ms[m] = lost_ms = self._lost_ms.get(m, -dt_ms) + dt_ms
            if lost_ms >= allowed_ms:
                self.causes[f"idle {m}"] = (text, (f"m:{m}",))


class ClosedLong:
    """Level crossings that have been commanded or reported closed for longer than `CLOSED_LONG_S`."""

    def __init__(self, layout: Layout, symbols: Symbols) -> None:
        y, closed = symbols.machines, Position.REVERSE
        self._crossings = [
            (m, _closed_long(layout, m), y.detected.get((m, closed)), y.command.get((m, closed)))
            for m in layout.machines
            if _is_crossing(layout, m)
        ]
        self._closed_ms: dict[MachineId, int] = {}
        self.causes: Causes = {}
        """By key: roads that wait for longer."""

    def after(self, cycle: Cycle, dt_ms: int) -> None:
        """A cycle has ended, `dt_ms` milliseconds after the one before.  While inputs are lost, time runs on for a
        crossing that was closed."""
        self.causes = {}
        for m, text, detected, command in self._crossings:
            closed = bool(cycle.memory.state.get(command or "") or cycle.inputs.get(detected or ""))
            if not closed and (cycle.valid or m not in self._closed_ms):
                self._closed_ms.pop(m, None)
                continue
            self._closed_ms[m] = closed_ms = self._closed_ms.get(m, -dt_ms) + dt_ms
            if closed_ms >= CLOSED_LONG_S * 1000:
                self.causes[f"closed {m}"] = (text, (f"m:{m}",))
