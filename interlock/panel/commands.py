"""What an operator may ask for: a button is held as long as its purpose needs, and no longer.

Whatever is asked goes the way of the commands that are typed (`app.run.Operator`); nothing reaches the controller
otherwise.
"""

from __future__ import annotations

from collections.abc import Callable

from interlock.app.alarms import to_release
from interlock.app.reasons import Moment, Reasons
from interlock.app.run import BadCommand, Operator, Ready, not_blocked
from interlock.dataclass import dataclass
from interlock.diag.called import called
from interlock.dispatch.arbiter import Full
from interlock.exceptions import Whole
from interlock.field.plc import Cycle
from interlock.model.elements import MachineId, NodeId, Position, SectionId, SignalId
from interlock.model.times import supervision_s

Done = Callable[[Cycle], bool]

TURN_S = 15.0
"""Seconds for which the key of a point is held at most, or for as long as it may take."""

RELEASE_S = 600.0
"""Seconds for which the release of a section is held at most."""

TEXT = 80
"""Characters of a reminder, or of a name, at most."""


class Refused(Whole):
    """What was asked for cannot be done; the message says why, `at` the elements to show."""

    def __init__(self, text: str, *at: str) -> None:
        super().__init__(text)
        self.at = at


def block_of(ready: Ready, section: str) -> str:
    """The switch that blocks a section.  Raises `Refused`."""
    assert ready.controller is not None
    name = ready.controller.symbols.sections.blocked.get(section)  # type: ignore[call-overload]
    if name is None:
        raise Refused(not_blocked(ready, section) or "there is no such section")
    return str(name)


@dataclass
class Hold:
    """An input that is held: until something is so, for so many milliseconds at most.  `fails`: why it is let go of
    before that, empty while it is not; `late`: what is said when its time is over, `over`: when it is so."""

    done: Done
    left_ms: float
    fails: Callable[[Cycle], str] = lambda c: ""
    late: str = ""
    over: str = ""


class Holds:
    """The inputs that people hold."""

    def __init__(self, operator: Operator) -> None:
        self._operator = operator
        self._held: dict[str, Hold] = {}

    def hold(self, name: str, hold: Hold) -> None:
        """Hold an input."""
        self._operator.held[name] = 1
        self._held[name] = hold

    def let_go(self, cycle: Cycle, dt_ms: float) -> list[str]:
        """After a cycle: inputs are not held any more whose purpose is fulfilled, cannot be fulfilled, or was not in
        time; what is to be said of it."""
        told = []
        for name, hold in tuple(self._held.items()):
            hold.left_ms -= dt_ms
            done = hold.done(cycle)
            why = "" if done else hold.fails(cycle)
            if done or why or hold.left_ms <= 0:
                self.drop(name)
                told.append(hold.over if done else why or hold.late)
        return [text for text in told if text]

    def holds(self, name: str) -> bool:
        """Whether somebody holds an input."""
        return name in self._held

    def drop(self, name: str) -> None:
        """Let go of an input."""
        self._held.pop(name, None)
        self._operator.held.pop(name, None)


class Buttons:
    """What an operator may ask for, a method each; all raise `Refused`."""

    def __init__(self, ready: Ready, operator: Operator, reasons: Reasons) -> None:
        assert ready.layout is not None and ready.controller is not None and ready.table is not None
        self._ready, self._layout, self._reasons = ready, ready.layout, reasons
        self.holds = Holds(operator)
        self._operator = operator
        self._symbols, self._timers = ready.controller.symbols, ready.controller.timers
        self.routes = {str(r.id): r for r in ready.table.routes}

    def _typed(self, line: str) -> tuple[str, ...]:
        """The routes that no longer work automatically because of it."""
        try:
            return self._operator.type(line)
        except (BadCommand, Full) as error:
            raise Refused(str(error)) from None

    def set(self, route: str, last: Cycle) -> int:
        """Ask for a route; its number."""
        row = self.routes.get(route)
        if row is None:
            raise Refused(f"there is no route {route}")
        if not last.valid:
            raise Refused("inputs are not valid: nothing can be set")
        self._typed(f"set {route}")
        return row.number

    def swing(self, signal: str) -> int:
        """Ask for another overlap; the number of the request."""
        number = self._symbols.overlaps.swing_request.get(signal)  # type: ignore[call-overload]
        if number is None:
            raise Refused(f"the overlap of {signal} cannot swing")
        self._typed(f"swing {signal}")
        return int(number)

    def cancel(self, signal: str, last: Cycle) -> tuple[bool, tuple[str, ...]]:
        """Take back the route from a signal, or the request for one: whether one is set, and those that no longer work
        automatically."""
        state = last.memory.state
        is_set = any(state.get(r.active) for r in self._symbols.routes.of_signal.get(SignalId(signal), []))
        waits = self._operator.waits(SignalId(signal))
        if not is_set and not waits and not self._operator.automatic(SignalId(signal)):
            raise Refused(f"no route from {signal} is set that a train has not entered", f"g:{signal}")
        return is_set, self._typed(f"cancel {signal}")

    def stop(self) -> None:
        """All signals to stop, whatever is set."""
        self._typed("stop")

    def release(self, section: str, last: Cycle) -> None:
        """Release a section by hand: held until it is free."""
        name = self._symbols.sections.release.get(section)  # type: ignore[call-overload]
        if name is None:
            raise Refused(f"{called('section', section)} is never locked")
        if section in self._layout.track.undetected:
            what = f"{called('section', section)} has no detection: it counts as occupied, and needs no release"
            raise Refused(what, f"s:{section}")
        locked = self._symbols.sections.locked_by[section]  # type: ignore[index]
        if not any(last.memory.state.get(n) for n in locked):
            raise Refused(f"{called('section', section)} is not locked", f"s:{section}")
        clear = self._symbols.sections.clear.get(SectionId(section), "")
        if not last.inputs.get(clear, 0):
            raise Refused(f"{called('section', section)} is occupied", f"s:{section}")
        if found := self._reasons.of_release(SectionId(section), Moment(last.inputs, last.memory, 0)):
            raise Refused("; ".join(r.text for r in found), *(x for r in found for x in r.at))
        given_up = f"the release of {called('section', section)} is given up:"
        self.holds.hold(
            name,
            Hold(
                lambda c: not any(c.memory.state.get(n) for n in locked),
                RELEASE_S * 1000,
                lambda c: (
                    "" if c.inputs.get(clear, 0) else f"{given_up} it {'is' if c.valid else 'counts as'} occupied"
                ),
                f"{given_up} it has not become free in {RELEASE_S:.0f} s",
            ),
        )

    def release_all(self, last: Cycle) -> None:
        """Release all sections that are clear, after a restart or a loss of inputs."""
        y = self._symbols

        restart = to_release(self._layout, y)

        def open_(c: Cycle) -> list[str]:
            state, clear = c.memory.state, {s for s, n in y.sections.clear.items() if c.inputs.get(n)}
            found = [str(s) for s, n in restart.items() if state.get(n) and s in clear]
            locked = {s for (s, _), n in y.sections.lock.items() if state.get(n)}
            return found + [str(s) for s, n in y.sections.stale.items() if state.get(n) and s in clear & locked]

        if not open_(last):
            raise Refused("no section that is clear waits for its release")
        ran = last.memory.elapsed.get(y.start.restart_timer)
        preset = next(t.preset_ms for t in self._timers if t.name == y.start.restart_timer)
        if any(last.memory.state.get(n) for n in restart.values()) and (ran is None or ran < preset):
            raise Refused(f"the restart delay runs: {(preset - (ran or 0)) / 1000:.0f} s to go")
        self.holds.hold(y.sections.release_all, Hold(lambda c: not open_(c), 30_000))

    def block(self, section: str, on: bool) -> None:
        """Bar a section to routes, or free it."""
        self._typed(f"{block_of(self._ready, section)}={int(on)}")

    def turn(self, machine: str, to: str, last: Cycle) -> str:
        """Move points or a device by hand: held until it is detected there; what is done, in words.  What is locked
        now is not moved later."""
        x = Position.NORMAL if to == "N" else Position.REVERSE
        key = (MachineId(machine), x)
        name, command = self._symbols.machines.by_hand.get(key), self._symbols.machines.command.get(key)
        if name is None or command is None:
            raise Refused(f"{machine} is not moved by hand")
        there = self._symbols.machines.detected[key]
        machines = self._layout.machines
        word, device = machines.word(*key), key[0] in machines.device
        it, moved = machines.named(key[0]) if device else machine, machines.moved(*key)
        if last.inputs.get(there):
            raise Refused(f"{it} {f'is {word}' if device else 'lies there'} already", f"m:{machine}")
        if found := self._reasons.of_move(*key, Moment(last.inputs, last.memory, 0)):
            at = (f"m:{machine}", *(x for reason in found for x in reason.at))
            done = "moved" if moved == f"moved {word}" else moved
            raise Refused(f"{it} cannot be {done}: {'; '.join(reason.text for reason in found)}", *at)
        lies = f"proved {word}" if device else "detected there"
        by = "" if key[0] in machines.by_hand else " by hand"
        for y in Position:
            self.holds.drop(self._symbols.machines.by_hand[key[0], y])
        seconds = max(TURN_S, supervision_s(self._layout, key[0]))
        self.holds.hold(
            name,
            Hold(
                lambda c: bool(c.inputs.get(there)),
                seconds * 1000,
                lambda c: "" if c.memory.state.get(command) else f"{it} is not {moved}: it is not free any more",
                f"{it} was to be {moved}{by}, and is not {lies} after {seconds:.0f} s",
            ),
        )
        return machines.to_move(*key) + by

    def looked(self, machine: str, last: Cycle) -> None:
        """Confirm that trailed points were looked at."""
        name = self._symbols.machines.looked_at.get(machine)  # type: ignore[call-overload]
        if name is None or not last.memory.state.get(self._symbols.machines.trailed[machine]):  # type: ignore[index]
            raise Refused(f"{machine} was not trailed")
        trailed = self._symbols.machines.trailed[MachineId(machine)]
        self.holds.hold(name, Hold(lambda c: not c.memory.state.get(trailed), 1000))

    def automatic(self, route: str, on: bool) -> None:
        """Let a route be set again after every train, or not."""
        number = self.routes[route].number if route in self.routes else 0
        name = self._symbols.requests.automatic.get(number)
        if name is None:
            raise Refused(f"route {route} does not work automatically")
        self._typed(f"{name}={int(on)}")

    def direction(self, boundary: str, on: bool, last: Cycle) -> float:
        """The special manual change of direction, as agreed with the neighbour by telephone (R12): held until the
        direction is ours, and given up as soon as it cannot become so; the seconds that it takes."""
        b = NodeId(boundary)
        token, change = self._symbols.token.get(b), f"the special manual change of direction at {boundary}"
        if token is None:
            raise Refused(f"no direction changes at {boundary}")
        at, seconds = f"b:{boundary}", self._layout.principles.token_delay_s
        if not on:
            if not self.holds.holds(token.manual):
                raise Refused(f"{change} is not on", at)
            self.holds.drop(token.manual)
            return seconds
        if self.holds.holds(token.manual):
            raise Refused(f"{change} is on already", at)

        def fails(c: Cycle) -> str:
            return "; ".join(r.text for r in self._reasons.of_direction(b, Moment(c.inputs, c.memory, 0)))

        if why := fails(last):
            raise Refused(why, at)
        self.holds.hold(
            token.manual,
            Hold(
                lambda c: bool(c.memory.state.get(token.have)),
                (seconds + TURN_S) * 1000,
                lambda c: f"{change} is given up: {why}" if (why := fails(c)) else "",
                f"{change} has not come to its end, and is given up",
                f"{change} is complete, and no longer on: the direction is ours",
            ),
        )
        return seconds

    def voyage(self, name: str, end: bool) -> None:
        """Carry out a voyage, or give it up."""
        self._typed(f"voyage {name}{' end' if end else ''}")

    def train(self, number: str, section: str) -> None:
        """Say which train stands in a section."""
        self._typed(f"train {number} {section}")
