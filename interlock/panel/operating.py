"""What people do at a panel: buttons, requests, alarms that they acknowledge, reminders, releases by hand."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator, Mapping

from interlock.app.reasons import Moment, Reason, Reasons
from interlock.app.run import Operator, Ready
from interlock.dataclass import dataclass
from interlock.field.plc import Cycle
from interlock.logic.words import UNKNOWN
from interlock.panel.alarms import Alarm, Alarms
from interlock.panel.asked import Asked
from interlock.panel.commands import Buttons, Refused, block_of
from interlock.panel.entry import Command, NotKnown, line
from interlock.panel.event import Event, stamp
from interlock.panel.standing import BLOCK, FREE, Standing, told


@dataclass(frozen=True)
class Person:
    """Who asks: a name as given, and whether he may operate or only look."""

    name: str
    operates: bool


class Operating:
    """One operator's place.  elements: keys of all that is shown; note: whom events are told; keep: told what stands,
    before that is so."""

    def __init__(
        self,
        ready: Ready,
        elements: Collection[str],
        releases: int,
        note: Callable[[Event], None],
        keep: Callable[[Standing], None],
    ) -> None:
        assert ready.layout is not None and ready.controller is not None
        self._ready, self._elements, self._note, self._keep = ready, elements, note, keep
        self.reasons = Reasons(ready.layout, ready.controller)
        self.alarms = Alarms()
        self.reminders: dict[str, list[str]] = {}
        self._left: dict[str, tuple[str, str]] = {}
        """What records have left, by the key of its alarm."""
        self.releases = releases
        """Releases by hand, counted; the count goes on with a record that goes on."""
        self._symbols = ready.controller.symbols
        self._begin()

    def begins_again(self) -> None:
        """The controller has lost its power: nothing is asked for any more, and nothing is held but what bars sections
        to routes: that is held at this place, and somebody may work on the track."""
        stands = self.stands
        self._begin()
        self._block(stands.blocks)

    @property
    def stands(self) -> Standing:
        """What is blocked, and what reminds."""
        return self._standing(self.reminders, {})

    def _standing(self, reminders: Mapping[str, list[str]], switched: Mapping[str, bool]) -> Standing:
        """The same, with these reminders, and when these blocks are switched."""
        held = {**self.operator.held, **switched}
        blocks = tuple(str(s) for s, n in self._symbols.sections.blocked.items() if held.get(n))
        left = tuple(x for x in self._left.values() if x[0] not in blocks)
        return Standing(blocks, {k: list(v) for k, v in reminders.items()}, left)

    def restore(self, before: Standing, left: Iterable[tuple[str, str]] = ()) -> list[Alarm]:
        """The server has started again: what was blocked in a record that goes on is blocked, and reminders stand.  The
        alarms of what another record has left, and of what this one has of that."""
        self.reminders |= {k: list(v) for k, v in before.reminders.items() if k in self._elements}
        self._block(before.blocks)
        found = {self.alarms.once(told(*x), (f"s:{x[0]}",) if x[0] else (), stamp()): x for x in (*before.left, *left)}
        self._left = {a.key: x for a, x in found.items()}
        return list(found)

    def _block(self, sections: Iterable[str]) -> None:
        """Block again what was blocked; what cannot be is an alarm."""
        for s in sections:
            try:
                self.buttons.block(s, True)
            except Refused as no:
                a = self.alarms.once(f"the block of section {s} cannot be restored: {no}", (), stamp())
                self._note(Event("alarm", a.text))

    def _begin(self) -> None:
        self.operator = Operator(self._ready)
        self.buttons = Buttons(self._ready, self.operator, self.reasons)
        self._asked = Asked(self._symbols, self.operator)

    def answers(self, before: Cycle, cycle: Cycle, moment: Moment) -> Iterator[Event]:
        """What a cycle has answered to what was asked, and the routes that were set without that."""
        yield from self._asked.answers(self.reasons, before, cycle, moment)
        yield from self._asked.by_itself(before, cycle)

    def withdrawn(self) -> Iterator[Event]:
        """What people have asked for and is not asked for any more."""
        for gone in self.operator.withdrawn():
            yield from self._asked.withdrawn(gone)

    def waits(self, route: str, last: Cycle, dt_ms: int) -> list[Reason]:
        """Why a route is not set, or does not open."""
        row = self.buttons.routes.get(route)
        if row is None:
            raise Refused(f"there is no route {route}")
        moment = Moment(last.inputs, last.memory, dt_ms)
        active = next(r.active for r in self._symbols.routes if r.number == row.number)
        if not last.memory.state.get(active):
            return self.reasons.of_request(row.number, moment, last.words().get(row.number, UNKNOWN))
        return self.reasons.of_stop(row.number, moment)

    def carry_out(self, who: Person, what: str, c: Command, last: Cycle) -> str:
        """What somebody asks for after a cycle; what is told of it, or nothing.  Raises `Refused`, `NotKnown`."""
        b = self.buttons
        match what:
            case "set":
                self._asked.ask(b.set(c["route"], last), who.name)
                return ""
            case "swing":
                self._asked.ask(b.swing(c["signal"]), who.name)
                return f"swing the overlap of {c['signal']}"
            case "cancel":
                return _cancelled(c["signal"], *b.cancel(c["signal"], last))
            case "stop":
                b.stop()
                for event in self._asked.given_up("all signals were put to stop"):
                    self._note(event)
                return "all signals to stop: every route is cancelled, every voyage given up"
            case "release":
                b.release(c["section"], last)
                self.releases += 1
                return f"release section {c['section']} by hand (release {self.releases})"
            case "release all":
                b.release_all(last)
                self.releases += 1
                return f"release all clear sections (release {self.releases})"
            case "block":
                self._keep(self._standing(self.reminders, {block_of(self._ready, c["section"]): c["on"]}))
                b.block(c["section"], c["on"])
                if c["on"]:
                    self._left = {key: x for key, x in self._left.items() if x[0] != c["section"]}
                return f"{BLOCK if c['on'] else FREE}{c['section']}"
            case "turn":
                return b.turn(c["machine"], c["to"], last)
            case "looked":
                b.looked(c["machine"], last)
                return f"{c['machine']} was looked at after it was trailed"
            case "automatic":
                b.automatic(c["route"], c["on"])
                return f"route {c['route']} {'works' if c['on'] else 'does not work'} automatically"
            case "direction":
                seconds = b.direction(c["boundary"], c["on"], last)
                what = f"on, complete in {seconds:.0f} s" if c["on"] else "taken off"
                return f"special manual change of direction at {c['boundary']}: {what}"
            case "voyage":
                b.voyage(c["name"], c.get("end", False))
                return f"{'give up' if c.get('end') else 'begin'} voyage {c['name']}"
            case "train":
                b.train(c["name"], c["section"])
                return f"train {c['name']} stands in {c['section']}"
            case "acknowledge":
                for a in self.alarms.acknowledge(c.get("alarms"), who.name):
                    self._note(Event("acknowledged", f"seen: {a.said}", who.name, a.at))
                    self._left.pop(a.key, None)
                self._keep(self.stands)
                return ""
            case "remind":
                return self._remind(c["at"], c.get("text", ""), who)
            case "lamp test":
                return "lamp test"
        raise NotKnown

    def _remind(self, at: str, text: str, who: Person) -> str:
        if at not in self._elements:
            raise Refused(f"there is nothing called {at.partition(':')[2]}")
        text, reminders = line(text), dict(self.reminders)
        if text:
            reminders[at] = [text, who.name, stamp()]
        elif reminders.pop(at, None) is None:
            return ""
        self._keep(self._standing(reminders, {}))
        self.reminders = reminders
        return f"reminder on {at.partition(':')[2]}{f': {text}' if text else ' taken away'}"


def _cancelled(signal: str, is_set: bool, switched_off: tuple[str, ...]) -> str:
    """What is told of a cancellation: what is set again by itself would be set again at once."""
    if not is_set and not switched_off:
        return f"cancel at {signal}, where none is set yet"
    if not is_set:
        return f"cancel at {signal}, where none is set; no longer automatic: {', '.join(switched_off)}"
    more = "; it no longer works automatically" if switched_off else ""
    return f"cancel the route from {signal}{more}"
