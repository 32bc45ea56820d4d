"""Run a layout's proved runtime as a soft PLC."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Generator, Iterable, Mapping
from dataclasses import replace
from math import floor

from interlock.app.check import Checked, derive_file
from interlock.app.numbers import Numbers
from interlock.app.presses import Presses
from interlock.app.prove import prove_derived
from interlock.app.proved import Proved
from interlock.dataclass import dataclass
from interlock.diag.called import called
from interlock.diag.suggest import did_you_mean
from interlock.dispatch import Dispatcher
from interlock.dispatch.by_hand import waits, withdraw
from interlock.dispatch.commands import BadOrder, errand
from interlock.dispatch.plan.errands import NoVoyage, TooManyPlaces
from interlock.dispatch.plan.railway import Railway
from interlock.field.modbus import MOST_BYTE, beyond
from interlock.field.plc import Cycle, Link, SoftPlc, runtime_scan
from interlock.field.polling import InTurn, Poll
from interlock.logic.cabinet import Allocation, allocate
from interlock.logic.controller import Controller, Input
from interlock.logic.expr import interning
from interlock.logic.lower import lower
from interlock.logic.names import BLOCKED
from interlock.model.elements import SignalId
from interlock.model.layout import Layout
from interlock.model.times import whole_ms
from interlock.proof.engines.limits import Limits
from interlock.proof.induction.verdict import Progress, quiet
from interlock.table.rows import InterlockingTable


@dataclass(frozen=True)
class Ready:
    """A proved layout, ready to run; everything but `proved` is None when it is not proved."""

    proved: Proved
    layout: Layout | None = None
    table: InterlockingTable | None = None
    controller: Controller | None = None
    allocation: Allocation | None = None
    runtime: str = ""


def prepare(
    path: str,
    limits: Limits | None = None,
    progress: Progress = quiet,
    checked: Callable[[Checked], None] = lambda found: None,
) -> Ready:
    """Check, prove, and compare the runtime that is going to run; `checked` is told what is going to be proved."""
    began = time.monotonic()
    derived = derive_file(path)
    if derived.ok:
        checked(derived)
    proved, files = prove_derived(derived, limits, progress)
    proved = replace(proved, seconds=time.monotonic() - began)
    found = proved.checked
    if not proved.green or found.layout is None or found.table is None:
        return Ready(proved)
    with interning():
        controller = lower(found.layout, found.table)
        allocation = allocate(found.layout, controller)
    return Ready(proved, found.layout, found.table, controller, allocation, files["runtime.py"].decode())


def beyond_modbus(found: Checked) -> str:
    """What is wrong with the first address for which Modbus has no number, and where it stands; empty if all have."""
    assert found.layout is not None and found.table is not None
    with interning():
        far = beyond(allocate(found.layout, lower(found.layout, found.table)))
    if not far:
        return ""
    c, pins, fix = far[0], found.source.pins, f"give {far[0].variable} another address"
    at, where = found.source.at("addresses", c.variable), f"`addresses: {{{c.variable}: {c.address}}}`"
    if c.variable not in dict(found.layout.hardware.addresses) and pins is not None:
        at, where = pins.on_card(c.substation, c.slot), f"`cards`, slot {c.slot} of {c.substation}, for {c.variable}"
        if c.variable in pins.pins.by_variable:
            at, where = pins.at(c.variable), f"`channels`, {c.element}, `{c.variable}: {c.address}`"
        else:
            fix = "give the card other bytes"
    more = f" (and {len(far) - 1} more)" if len(far) > 1 else ""
    why = f"Modbus numbers the bits of bytes 0 to {MOST_BYTE}, and does not reach {c.address}"
    return f"{at.file}:{at.line}: {where}{more}: {why}; {fix}"


class BadCommand(Exception):
    """What the operator typed cannot be carried out; the message says why."""


LATE_S = 5.0
"""Seconds after which what somebody has asked for is not done any more (our choice): whoever asked has seen no answer,
and gone on to something else."""


@dataclass(frozen=True)
class Withdrawn:
    """A route, or the swing of an overlap, that was asked for by hand and is not any more: its number and name, and
    why."""

    number: int
    name: str
    why: str


class Operator:
    """The operator's place: commands hold for one cycle, VARIABLE=VALUE as long as a button is pressed, or until a
    switch is set to 0.

    Routes are asked for by the dispatcher, one after the other as the controller acknowledges them; it carries out
    voyages, and commands of a locomotive number with origin and destination (`dispatch.commands`).  What waits is
    withdrawn when its signal is cancelled, and when it has waited too long.
    """

    def __init__(self, ready: Ready, clock: Callable[[], float] = time.monotonic) -> None:
        assert ready.table is not None and ready.controller is not None and ready.layout is not None
        self._ready = ready
        self._once: dict[str, int] = {}
        self._clock, self._since, self._withdrawn = clock, dict[int, float](), list[Withdrawn]()
        self._last: Cycle | None = None
        self.held: dict[str, int] = {}
        """The switches that are on."""
        rules, symbols = ready.layout.principles, ready.controller.symbols
        self.presses = Presses(ready.layout, symbols)
        self.voyages = tuple(v.name for v in ready.table.voyages)
        self.dispatcher = Dispatcher(
            Railway(ready.table, ready.layout),
            symbols,
            priorities=rules.priorities,
            wait_ms=whole_ms(rules.priority_wait_s),
        )
        self.numbers = Numbers(ready.layout, symbols, self.dispatcher)

    def type(self, line: str) -> tuple[str, ...]:
        """Take one line of input; the routes that no longer work automatically because of it.  Raises `BadCommand`."""
        assert self._ready.controller is not None
        symbols = self._ready.controller.symbols
        verb, rest = spoken(line)
        if verb == "voyage":
            self._voyage(rest)
            return ()
        if verb == "train":
            self._train(rest)
            return ()
        if (verb, rest) == ("stop", ""):
            return self._stop()
        if (verb, rest) == ("free", ""):
            self.held = {n: v for n, v in self.held.items() if n not in symbols.sections.blocked.values()}
            return ()
        found = operate(self._ready, line)
        number = found.get(symbols.requests.request)
        switched_off: tuple[str, ...] = ()
        if "=" in line:
            for name, value in found.items():
                self._set(name, value)
        elif number is not None:
            self.dispatcher.ask(number)
            self._since[number] = self._clock()
        else:
            self._once |= found
            signal = next((g for g, name in symbols.cancellation.cancel.items() if name in found), None)
            if signal is not None:
                self._withdraw(self._numbers(signal), f"{called('signal', signal)} was cancelled after it")
                switched_off = self._switch_off(self.automatic(signal))
        return switched_off

    def _numbers(self, signal: SignalId) -> set[int]:
        """The routes from a signal and those that lead past it, and the swing of its overlap."""
        assert self._ready.controller is not None
        y = self._ready.controller.symbols
        own = y.routes.of_signal.get(signal, ())
        swing = {n for g, n in y.overlaps.swing_request.items() if g == signal}
        return swing | {x.number for r in own for x in (r, *y.routes.set_with(r))}

    def waits(self, signal: SignalId) -> bool:
        """Whether a route from a signal, or past it, or its overlap's swing is asked for and not yet answered."""
        return not waits(self.dispatcher).isdisjoint(self._numbers(signal))

    def _withdraw(self, numbers: Iterable[int], why: str) -> None:
        """What was asked for by hand and was not made yet is not asked for any more."""
        assert self._ready.controller is not None
        y = self._ready.controller.symbols
        swings = {n: f"the swing of the overlap of {g}" for g, n in y.overlaps.swing_request.items()}
        for n in withdraw(self.dispatcher, set(numbers)):
            self._withdrawn.append(Withdrawn(n, swings[n] if n in swings else f"route {y.routes.number[n].id}", why))

    def withdrawn(self) -> list[Withdrawn]:
        """What was withdrawn since this was last asked."""
        found, self._withdrawn = self._withdrawn, []
        return found

    def _set(self, name: str, value: int) -> None:
        """Set a switch, or press a button."""
        if not self.presses.is_switch(name):
            self.presses.press(name, value)
        elif value:
            self.held[name] = value
        else:
            self.held.pop(name, None)

    def block_all(self) -> dict[str, str]:
        """Every section is blocked, as the text for a PLC starts; the switch of each."""
        assert self._ready.controller is not None
        blocked = self._ready.controller.symbols.sections.blocked
        self.held |= dict.fromkeys(blocked.values(), 1)
        return {str(s): str(name) for s, name in blocked.items()}

    def automatic(self, signal: SignalId | None = None) -> tuple[int, ...]:
        """Routes that work automatically, by number: those from a signal and those that lead past it, or all."""
        assert self._ready.controller is not None
        y = self._ready.controller.symbols
        on = tuple(number for number, name in y.requests.automatic.items() if self.held.get(name))
        return on if signal is None else tuple(number for number in on if number in self._numbers(signal))

    def _switch_off(self, numbers: Iterable[int]) -> tuple[str, ...]:
        """Routes work automatically no longer: what is cancelled would be set again at once."""
        assert self._ready.controller is not None
        y = self._ready.controller.symbols
        for number in numbers:
            self.held.pop(y.requests.automatic[number], None)
        return tuple(str(y.routes.number[number].id) for number in numbers)

    def _stop(self) -> tuple[str, ...]:
        """All signals to stop: every route is cancelled, and nothing opens by itself or for a command any more."""
        assert self._ready.controller is not None
        symbols = self._ready.controller.symbols
        self._withdraw(waits(self.dispatcher), "all signals were put to stop after it")
        for name in self.dispatcher.give_up():
            self.numbers.ends(name)
        self._once = dict.fromkeys(symbols.cancellation.cancel.values(), 1)
        return self._switch_off(self.automatic())

    def _voyage(self, told: str) -> None:
        ended = told.removesuffix(" end") if told.endswith(" end") else ""
        under_way = {r.name for r in (*self.dispatcher.runs, *self.dispatcher.pending)}
        if told in self.voyages and ended in {*self.voyages, *under_way}:
            raise BadCommand(f"there are voyages {ended} and {told}: name one of them otherwise")
        if told in self.voyages or (":" in told and not ended):
            try:
                if told in self.voyages:
                    run = self.dispatcher.begin(told)
                else:
                    run = self.dispatcher.carry_out(*errand(self.dispatcher.railway, told, 0.0))
                if told not in self.voyages or self.numbers.kept:
                    self.numbers.expects(run)
            except BadOrder as error:
                raise BadCommand(": ".join(filter(None, (str(error), error.advice)))) from error
            except (NoVoyage, TooManyPlaces) as error:
                raise BadCommand(str(error)) from error
        elif ended and self.dispatcher.end(ended):
            self.numbers.ends(ended)
        else:
            known = ", ".join(self.voyages) or "this layout names none"
            how = "write voyage NAME, voyage NUMBER:ORIGIN>DESTINATION, or voyage NAME end for one under way"
            raise BadCommand(f"{how}; voyages: {known}")

    def _train(self, told: str) -> None:
        """Somebody says which train stands in a section."""
        assert self._ready.layout is not None
        number, _, section = told.partition(" ")
        if not section:
            raise BadCommand("write train NUMBER SECTION for a train that stands there")
        if all(str(s.id) != section for s in self._ready.layout.track.sections):
            raise BadCommand(f"there is no section {section}")
        if self._last is None or not self._last.valid:
            why = "; ".join(self._last.lost) if self._last is not None else ""
            lost = f"inputs are lost ({why})" if why else "no inputs have been read yet"
            raise BadCommand(
                f"{lost}: whether a train stands in {section} is not known; say it again when they are valid"
            )
        if not self.numbers.stands(number, section):
            raise BadCommand(f"{section} is clear: no train stands there")

    def inputs(self, last: Cycle | None, dt_ms: int) -> dict[str, int]:
        """What the next cycle reads, `dt_ms` milliseconds after the last; commands are used up."""
        assert self._ready.allocation is not None
        self._last = last
        seen = {} if last is None else {**last.inputs, **last.outputs}
        self.numbers.cycle(seen, last is not None and last.valid)
        late = [n for n, at in self._since.items() if self._clock() - at > LATE_S]
        self._withdraw(late, f"it was asked for more than {LATE_S:.0f} s ago, and is not done now: ask again")
        asked = self.dispatcher.step(seen, dt_ms)
        waiting = waits(self.dispatcher)
        self._since = {n: at for n, at in self._since.items() if n in waiting}
        pressed = self.presses.inputs({} if last is None else last.memory.state, dt_ms)
        found = dict.fromkeys(self._ready.allocation.written, 0) | asked | self.held | pressed | self._once
        self._once = {}
        return found

    def news(self) -> list[str]:
        """What became of the voyages, and of the numbers of trains, since this was last asked."""
        said = [*self.dispatcher.journal.said, *self.numbers.news()]
        self.dispatcher.journal.said.clear()
        return said


def spoken(line: str) -> tuple[str, str]:
    """The verb of a line that an operator typed, and the rest: a name, which may have single spaces."""
    verb, *rest = line.split() or [""]
    return verb, " ".join(rest)


def operate(ready: Ready, line: str) -> dict[str, int]:
    """The operator's inputs that a line asks for.  Raises `BadCommand`."""
    assert ready.table is not None and ready.controller is not None and ready.allocation is not None
    verb, name = spoken(line)
    if "=" in line:
        return _by_hand(ready, line)
    if name and verb == "set":
        row = next((r for r in ready.table.routes if name in (r.id, *r.names)), None)
        if row is None:
            names = [x for r in ready.table.routes for x in (str(r.id), *r.names)]
            raise BadCommand(f"there is no route {name}: {did_you_mean(name, names)}")
        return {ready.controller.symbols.requests.request: row.number}
    if name and verb == "swing":
        number = next((k for g, k in ready.controller.symbols.overlaps.swing_request.items() if g == name), None)
        if number is None:
            raise BadCommand(f"the overlap of {name} cannot swing")
        return {ready.controller.symbols.requests.request: number}
    if name and verb == "cancel":
        cancel = next((n for g, n in ready.controller.symbols.cancellation.cancel.items() if g == name), None)
        if cancel is None:
            raise BadCommand(f"no route begins at {name}")
        return {cancel: 1}
    if verb == "release" and not name:
        return {"RELALL": 1}
    if verb in ALONE and not name:
        raise BadCommand(f"write {verb} {ALONE[verb]}")
    raise BadCommand(
        "write set ROUTE, swing SIGNAL, voyage NAME, voyage NAME end, train NUMBER SECTION, cancel SIGNAL, stop, "
        "release, free, or VARIABLE=VALUE"
    )


ALONE = {"set": "ROUTE", "swing": "SIGNAL", "cancel": "SIGNAL"}
"""What has to be named with a verb."""


def _by_hand(ready: Ready, line: str) -> dict[str, int]:
    """VARIABLE=VALUE.  Raises `BadCommand`, which says what is wrong with either."""
    assert ready.layout is not None and ready.controller is not None and ready.allocation is not None
    written, _, value = (part.strip() for part in line.partition("="))
    inputs: dict[str, Input] = {i.name: i for i in ready.controller.inputs}
    given = inputs.get(written) if written in ready.allocation.written else None
    if given is None:
        if written in {*inputs, *ready.allocation.read} | {c.variable for c in ready.allocation.wires}:
            whose = "is read from a substation" if written in inputs else "is written by the controller"
            whose = "says whether inputs are valid" if written == ready.controller.symbols.valid else whose
            raise BadCommand(f"{written} {whose}: it is not set by hand")
        for s in ready.layout.track.sections:
            if written == BLOCKED(s.id) and (why := not_blocked(ready, s.id)):
                raise BadCommand(f"there is no variable {written}: {why}")
        raise BadCommand(f"there is no variable {written}: {did_you_mean(written, ready.allocation.written)}")
    # the largest number of an input stands for all that name nothing
    most = given.size - 2 if given.size else 1
    if value.isdecimal() and len(value) < 9 and int(value) <= most:
        return {written: int(value)}
    allowed = f"a number from 0 to {most}" if most > 1 else "0 or 1"
    if written == ready.controller.symbols.requests.request:
        allowed += " (0 asks for nothing; `set ROUTE` asks for a route by its name)"
    raise BadCommand(f"{written}={value}: {written} is {allowed}")


def not_blocked(ready: Ready, section: str) -> str:
    """Why a section has no block; empty where there is no such section, or it has one."""
    assert ready.layout is not None and ready.controller is not None
    blocked = ready.controller.symbols.sections.blocked
    if section not in {s.id for s in ready.layout.track.sections} - blocked.keys():
        return ""
    outside = section in {b.approach for b in ready.layout.track.boundaries}
    why = "it is an approach section, which no route locks" if outside else "no route and no overlap locks it"
    return f"{called('section', section)} cannot be blocked: {why}"


def since_boot() -> float:
    """Seconds that have passed since the computer was started, with those in which it slept where the system counts
    them (Linux): a cycle that it slept through was too long, and what happened meanwhile was not seen (R16)."""
    if sys.platform == "linux":
        return time.clock_gettime(time.CLOCK_BOOTTIME)
    return time.monotonic()


def run(
    ready: Ready,
    links: Mapping[str, Link],
    cycle_ms: int,
    cycles: int | None,
    ask: Callable[[Cycle | None, int], Mapping[str, int]],
    now: Callable[[], float] = since_boot,
    sleep: Callable[[float], None] = time.sleep,
    poll: Poll | None = None,
    left: Callable[[Mapping[str, str]], None] = lambda stations: None,
) -> Generator[tuple[Cycle, float], None, None]:
    """Cycles in their time, each with the seconds that it took.

    The milliseconds of all cycles together are never more than have passed since the first began: what is rounded away
    in one is counted in the next, so that no time is told longer than it was by a whole millisecond (A-CLOCK).

    `ask` gives the inputs of the operator's place, from the cycle before and the milliseconds since it.  `now` and
    `sleep`: the clock in seconds, another one where time is simulated, too.  `poll`: how substations are asked.  When
    the generator is closed, or anything is thrown, every output is written restrictive; `left` is told of the
    substations that could not be written then, and why.
    """
    assert ready.controller is not None and ready.allocation is not None
    plc = SoftPlc(
        runtime_scan(ready.runtime), ready.allocation, links, ready.controller.symbols.valid, poll or InTurn()
    )
    try:
        done = counted = 0
        start = 0.0
        result: Cycle | None = None
        while cycles is None or done < cycles:
            began = now()
            if done:
                passed = max(0, floor((began - start) * 1000) - counted)
                counted += passed
            else:
                start, passed = began, cycle_ms  # no timer runs yet
            result = plc.cycle(ask(result, passed), passed)
            done += 1
            took = now() - began
            yield result, took
            sleep(max(0.0, cycle_ms / 1000 - (now() - began)))
    finally:
        left(plc.close())
