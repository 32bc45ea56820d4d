"""Requests for routes, and what became of them: one is answered in the scan in which its number is read."""

from __future__ import annotations

from collections.abc import Iterator

from interlock.app.reasons import Moment, Reason, Reasons
from interlock.app.run import Operator, Withdrawn
from interlock.dispatch.arbiter import Request, Source
from interlock.field.plc import Cycle
from interlock.logic.symbols import Symbols
from interlock.logic.words import UNKNOWN
from interlock.panel.commands import Refused
from interlock.panel.event import Event


class Asked:
    """Who has asked for which number; a dispatcher that asks has no name here."""

    def __init__(self, symbols: Symbols, operator: Operator) -> None:
        self._symbols, self._operator = symbols, operator
        self._waiting: dict[int, list[str]] = {}
        self._answered: tuple[Request | None, str] = (None, "")
        """The request that a person has made and a scan has answered last, and who that was."""

    def ask(self, number: int, who: str) -> None:
        """Somebody has asked for a number: one of a route once for all who ask while it waits, one of a swing for each.
        Raises `Refused` where a scan has answered that request before it was asked for again: nothing answers twice."""
        answered, by = self._answered
        if answered is not None and answered.stage.number == number and answered in self._waits(number):
            name = answered.stage.route
            raise Refused(f"route {name} is asked for already by {by}", f"g:{answered.stage.entry}")
        self._waiting.setdefault(number, []).append(who)

    def _waits(self, number: int) -> list[Request]:
        """Requests of people for a route that wait, or are being made."""
        waiting = self._operator.dispatcher.arbiter.waiting
        return [r for r in waiting if r.stage.number == number and r.source is Source.HAND]

    def _who(self, number: int, is_route: bool) -> str:
        """Whose request a scan has read: people's, if it is theirs that was made, and not one of a dispatcher."""
        if not is_route:
            names = self._waiting.get(number, [])
            return names.pop(0) if names else ""
        made = self._operator.dispatcher.arbiter.asked
        if made is None or made.stage.number != number or made.source is not Source.HAND:
            return ""
        who = ", ".join(dict.fromkeys(self._waiting.pop(number, ())))
        self._answered = made, who
        return who

    def answers(self, reasons: Reasons, before: Cycle, cycle: Cycle, moment: Moment) -> Iterator[Event]:
        """What the scan has answered: a route is set, or refused; a request of a person is made once."""
        y = self._symbols
        number = cycle.inputs.get(y.requests.request, 0)
        if not cycle.valid:
            yield from self.given_up("inputs are not valid")
        if not number or before.inputs.get(y.requests.request, 0) or not cycle.valid:
            return
        route = next((r for r in y.routes if r.number == number), None)
        who = self._who(number, route is not None)
        if route is None:
            yield from self._swing(reasons, before, cycle, moment, who)
            return
        was, now = before.memory.state, cycle.memory.state
        name, signal = str(route.id), f"g:{route.entry}"
        if now.get(route.active) and not was.get(route.active):
            yield Event("operation", f"route {name} is set", who or "dispatcher", (signal,))
        elif was.get(route.active) and not any(was.get(n) for n in route.open_while):
            told = () if any(now.get(n) for n in route.open_while) else tuple(reasons.of_stop(number, moment))
            yield Event(
                "operation", f"route {name}: its signal is asked for again", who or "dispatcher", (signal,), told
            )
        else:
            told = tuple(reasons.of_request(number, moment, cycle.words().get(number, UNKNOWN)))
            yield Event("refusal", f"route {name} is refused", who or "dispatcher", (signal,), told)

    def by_itself(self, before: Cycle, cycle: Cycle) -> Iterator[Event]:
        """Routes that have been set since they work automatically: nobody has asked for them."""
        y = self._symbols
        was, now = before.memory.state, cycle.memory.state
        asked = cycle.inputs.get(y.requests.request, 0) if not before.inputs.get(y.requests.request, 0) else 0
        for number, switch in y.requests.automatic.items():
            r = y.routes.number[number]
            if cycle.inputs.get(switch) and number != asked and now.get(r.active) and not was.get(r.active):
                yield Event("operation", f"route {r.id} is set, automatically", at=(f"g:{r.entry}",))

    def _swing(self, reasons: Reasons, before: Cycle, cycle: Cycle, moment: Moment, who: str) -> Iterator[Event]:
        """Whether an overlap swings, where that was asked for."""
        number = cycle.inputs[self._symbols.requests.request]
        swings = reasons.swing(number, before.memory, cycle.memory)
        if swings is None:
            return
        name, at = f"the overlap of {swings[0]}", (f"g:{swings[0]}",)
        if swings[1]:
            yield Event("operation", f"{name} swings", who or "dispatcher", at)
        else:
            told = tuple(reasons.of_request(number, moment, UNKNOWN))
            yield Event("refusal", f"{name} does not swing", who or "dispatcher", at, told)

    def withdrawn(self, gone: Withdrawn) -> Iterator[Event]:
        """A number is not asked for any more: whoever has asked for it is told."""
        for who in dict.fromkeys(self._waiting.pop(gone.number, ())):
            yield Event("refusal", f"{gone.name} is refused", who, (), (Reason(gone.why),))

    def given_up(self, why: str) -> Iterator[Event]:
        """What was asked for before is not to come true some time after: inputs are lost, or signals put to stop."""
        for number, names in self._waiting.items():
            name = next((f"route {r.id}" for r in self._symbols.routes if r.number == number), "the overlap's swing")
            self._withdraw(number)
            for who in dict.fromkeys(names):
                yield Event("refusal", f"{name} is refused", who, (), (Reason(why),))
        self._waiting.clear()

    def _withdraw(self, number: int) -> None:
        dispatcher = self._operator.dispatcher
        for r in self._waits(number):
            dispatcher.arbiter.withdraw(r)
        while number in dispatcher.other:
            dispatcher.other.remove(number)
