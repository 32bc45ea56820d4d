"""The desk behind all browsers: it runs the controller, carries out what is asked, and tells what has changed.

One thread runs cycles; commands wait in a queue and are carried out between two of them.  After each cycle what has
changed goes to whoever listens, as one text.  The desk never stops because of a browser.
"""

from __future__ import annotations

import json
import os
import queue
import threading
import time
from collections import deque
from collections.abc import Callable, Mapping
from contextlib import closing
from dataclasses import dataclass
from typing import Any

from interlock.app.run import Operator, Ready, run
from interlock.field.plc import Cycle, Link
from interlock.field.polling import Beside, InTurn
from interlock.logic.words import UNKNOWN
from interlock.model.elements import BlockKind
from interlock.panel.alarms import Alarm, Alarms
from interlock.panel.asked import Asked
from interlock.panel.causes import Idle, causes, fallen_back
from interlock.panel.clock import MOST_S, SPEEDS, Clock
from interlock.panel.commands import TEXT, Buttons, Refused
from interlock.panel.event import Event, stamp
from interlock.panel.picture import Picture, Shown, still
from interlock.panel.reasons import Moment, Reason, Reasons
from interlock.panel.recorder import Recorder
from interlock.panel.simulated import LENGTH_M, Impossible, SimulatedField
from interlock.simulate.track import Beyond
from interlock.simulate.world import World

EVENTS = 200
"""Events that a browser is told when it comes."""

TELL_S = 0.05
"""Seconds between two messages at least, where simulated time runs fast."""

SETTLES_MS = 1000
"""Milliseconds after a start in which heartbeats are not yet missed."""

Reply = Callable[[dict[str, Any]], None]
Listener = Callable[[str], None]


@dataclass(frozen=True)
class Person:
    """Who asks: a name as given, and whether he may operate or only look."""

    name: str
    operates: bool


class Desk:
    """One interlocking at work."""

    def __init__(
        self,
        ready: Ready,
        links: Mapping[str, Link] | None = None,
        cycle_ms: int = 100,
        recorder: Recorder | None = None,
    ) -> None:
        """`links` to real substations; without them a railway is simulated."""
        assert ready.layout is not None and ready.controller is not None and ready.allocation is not None
        self.ready, self.cycle_ms, self.recorder = ready, cycle_ms, recorder
        self.field: SimulatedField | None = None
        self.clock = Clock(max(MOST_S, cycle_ms / 1000))
        if links is None:
            c = ready.controller
            inputs: dict[str, tuple[int, int]] = {i.name: (i.restrictive, i.size or 2) for i in c.inputs}
            self.field = SimulatedField(
                ready.layout,
                ready.allocation,
                inputs,
                {o.name: o.restrictive for o in c.outputs},
                self.clock.most_s,
            )
        self.links: Mapping[str, Link] = self.field.links if self.field is not None else links or {}
        self.still = still(ready, self.field)
        self.picture, self.reasons = Picture(ready), Reasons(ready.layout, ready.controller)
        self.operator = Operator(ready)
        self.buttons = Buttons(ready, self.operator)
        self.alarms, self._idle = Alarms(), Idle(ready)
        self.reminders: dict[str, list[str]] = {}
        self.releases = 0 if recorder is None else recorder.releases
        """Releases by hand, counted; the count goes on with a record that goes on."""
        self.power = True
        self.events: deque[Event] = deque(maxlen=EVENTS)
        self.longest_s = 0.0
        self._numbers = 0
        self._asked = Asked()
        self._queue: queue.SimpleQueue[tuple[Person, dict[str, Any], Reply]] = queue.SimpleQueue()
        self._lock = threading.Lock()
        self._shown: Shown = self.picture.dark()
        self._fresh: list[Event] = []
        self._listeners: set[Listener] = set()
        self._last = Cycle({}, {}, False, ())
        self._dt_ms = cycle_ms
        self._told_at = 0.0
        self._hazards = 0
        self._ran_ms = 0
        self._other = self._rest(None)
        self._stop = threading.Event()
        self.publish: Callable[[Cycle | None], None] = lambda cycle: None
        """Told of every cycle, and of one without power (None)."""
        self.ended: Callable[[], None] = lambda: None
        """Called when the cycles have ended."""
        self.broken = ""
        """Why the thread ended, where it should not have."""

    # --- browsers ----------------------------------------------------------------------------------

    def ask(self, who: Person, command: dict[str, Any], reply: Reply) -> None:
        """A command for the next cycle; `reply` is told what became of it, in the thread of the cycles."""
        self._queue.put((who, command, reply))

    def listen(self, listener: Listener) -> dict[str, Any]:
        """From now on tell somebody what changes; everything as it is now."""
        with self._lock:
            self._listeners.add(listener)
            return {
                "still": self.still,
                "t": time.time(),
                "c": self._shown,
                "events": [e.told() for e in self.events],
                **self._other,
            }

    def forget(self, listener: Listener) -> None:
        """Tell somebody nothing more."""
        with self._lock:
            self._listeners.discard(listener)

    # --- the thread --------------------------------------------------------------------------------

    def start(self) -> None:
        """Begin to run."""
        self._thread = threading.Thread(target=self._run, name="cycles", daemon=True)
        self._thread.start()

    def stop(self) -> None:
        """End; every output that can be reached is restrictive then."""
        self._stop.set()
        self._thread.join(5.0)

    def _run(self) -> None:
        try:
            while not self._stop.is_set():
                if self.power:
                    self._powered()
                else:
                    self._without_power()
        except Exception as error:  # whatever it is: outputs are restrictive, browsers turn grey, the command tells it
            self.broken = f"{type(error).__name__}: {error}"
            if os.environ.get("INTERLOCK_DEBUG"):
                raise
        finally:
            self._stop.set()
            if self.recorder is not None:
                self.recorder.close()
            self.ended()

    def _powered(self) -> None:
        now, sleep = (time.monotonic, time.sleep) if self.field is None else (self.clock.now, self.clock.sleep)
        self._last = Cycle({}, {}, False, ())
        self._ran_ms, self._idle = 0, Idle(self.ready)
        self._once("the controller starts: every section stays locked until it is released")
        poll = InTurn() if self.field is not None else Beside()
        with closing(run(self.ready, self.links, self.cycle_ms, None, self._inputs, now, sleep, poll)) as cycles:
            for cycle, _ in cycles:
                self._after(cycle)
                if self._stop.is_set() or not self.power:
                    break

    def _without_power(self) -> None:
        assert self.field is not None
        self.field.dark()
        self.operator = Operator(self.ready)
        self.buttons = Buttons(self.ready, self.operator)
        self._asked = Asked()
        while not self.power and not self._stop.is_set():
            began = self.clock.now()
            self._commands()
            self.field.step(self.cycle_ms / 1000, {})
            if self.recorder is not None:
                self.recorder.cycle(None)
            self.publish(None)
            self._tell(self.picture.dark(), None)
            self.clock.sleep(max(0.0, self.cycle_ms / 1000 - (self.clock.now() - began)))

    def _inputs(self, last: Cycle | None, dt_ms: int) -> Mapping[str, int]:
        self._began = time.monotonic()
        self._dt_ms = dt_ms
        self._commands()
        found = self.operator.inputs(last, dt_ms)
        for news in self.operator.news():
            self._note(Event("note", news))
        if self.field is not None:
            self.field.step(dt_ms / 1000, found)
        return found

    def _after(self, cycle: Cycle) -> None:
        before, self._last = self._last, cycle
        self.buttons.let_go(cycle, self._dt_ms)
        moment = Moment(cycle.inputs, before.memory, self._dt_ms)
        for answer in self._asked.answers(self.buttons, self.reasons, before, cycle, moment):
            self._note(answer)
        for text, at, reasons in fallen_back(self.ready, self.reasons, before, cycle, moment):
            self._alarm(self.alarms.once(text, at, stamp()), reasons)
        self._ran_ms += self._dt_ms
        self._idle.after(cycle, self._dt_ms)
        if self._ran_ms > SETTLES_MS:
            found = causes(self.ready, cycle) | self._idle.causes
            found |= {f"train {n}": told for n, told in self.operator.numbers.alarms.items()}
            if self.recorder is not None and self.recorder.lost:
                found["record"] = (self.recorder.lost, ())
            for a in self.alarms.stand(found, stamp()):
                self._alarm(a)
        if self.field is not None:
            hazards = self.field.world.watch.found
            for text in hazards[self._hazards :]:
                self._once(f"the bystander sees: {text}")
            self._hazards = len(hazards)
        if self.recorder is not None:
            self.recorder.cycle(cycle)
        self.publish(cycle)
        self._tell(self.picture.of(cycle, self._idle.causes), cycle)
        self.longest_s = max(self.longest_s, time.monotonic() - self._began)

    # --- telling -----------------------------------------------------------------------------------

    def _once(self, text: str) -> None:
        self._alarm(self.alarms.once(text, (), stamp()))

    def _alarm(self, a: Alarm, reasons: tuple[Reason, ...] = ()) -> None:
        self._note(Event("alarm", a.text, at=a.at, reasons=reasons))

    def _note(self, event: Event) -> None:
        self._numbers += 1
        event.number = self._numbers
        self._fresh.append(event)
        if self.recorder is not None:
            self.recorder.event(event)

    def _tell(self, shown: Shown, cycle: Cycle | None) -> None:
        now = time.monotonic()
        if now - self._told_at < TELL_S:
            return
        self._told_at = now
        other = self._rest(cycle)
        with self._lock:
            message: dict[str, Any] = {k: v for k, v in other.items() if self._other.get(k) != v}
            message["c"] = {k: v for k, v in shown.items() if self._shown.get(k) != v}
            message["t"] = time.time()
            if self._fresh:
                message["events"] = [e.told() for e in self._fresh]
                self.events.extend(self._fresh)
                self._fresh = []
            self._shown, self._other = shown, other
            if self._listeners:
                text = json.dumps(message, ensure_ascii=False, separators=(",", ":"))
                for listener in self._listeners:
                    listener(text)

    def _rest(self, cycle: Cycle | None) -> dict[str, Any]:
        """What belongs to no element."""
        y, dispatcher = self.picture.symbols, self.operator.dispatcher
        state: Mapping[str, bool] = {} if cycle is None else cycle.memory.state
        locked = [str(s) for s, n in y.sections.restart.items() if state.get(n)]
        timer = None if cycle is None else self.picture.left(cycle, y.start.restart_timer)
        return {
            "sys": {
                "power": self.power,
                "valid": cycle is not None and cycle.valid,
                "lost": [] if cycle is None else list(cycle.lost),
                "restart": locked,
                "delay": timer if locked else None,
                "releasing": cycle is not None and bool(cycle.inputs.get(y.sections.release_all)),
                "releases": self.releases,
                "speed": self.clock.speed if self.field is not None else 0,
                "minutes": int(self.clock.now() // 60) if self.field is not None else 0,
                "failed": [] if self.field is None else sorted(map(list, self.field.failed)),
                "voyages": [[r.name, r.reason] for r in (*dispatcher.runs, *dispatcher.pending)],
                "numbers": [[n, under] for n, under in self.operator.numbers.sections.items()],
            },
            "alarms": [a.told() for a in self.alarms.all.values()],
            "reminders": {k: list(v) for k, v in self.reminders.items()},
            "trains": [] if self.field is None else self._trains(self.field),
        }

    @staticmethod
    def _trains(f: SimulatedField) -> list[Any]:
        track, out = f.world.track, []
        for t in f.world.trains:
            spans = []
            for d in t.body:
                s = track.stretches[d]
                if not s.outside:
                    lo, hi = t.span(track, d)
                    spans.append([str(f.layout.edges[s.edge].id), round(lo, 1), round(hi, 1)])
            under = [track.sections[x] for x in t.sections]
            head = track.stretches[t.body[-1]]
            way = -1 if t.body[-1] & 1 else 1
            front = None if head.outside else way
            out.append([f.name_of(t), spans, round(t.speed * 3.6), round(t.length(track)), under, f.held(t), front])
        out += [
            [name, [], 0, round(m), [f"before {b.name}{_waits(f.world, b)}"], None, None] for b, m, name in f.coming
        ]
        return out

    # --- commands ----------------------------------------------------------------------------------

    def _commands(self) -> None:
        while True:
            try:
                who, command, reply = self._queue.get_nowait()
            except queue.Empty:
                return
            try:
                reply({"ok": True, **(self._do(who, command) or {})})
            except (Refused, Impossible) as no:
                at = getattr(no, "at", ())
                self._note(Event("refusal", str(no), who.name, tuple(at)))
                reply({"ok": False, "why": [[str(no), list(at)]]})
            except (LookupError, TypeError, ValueError, AttributeError):
                reply({"ok": False, "why": [["this panel does not know such a command", []]]})

    def _do(self, who: Person, command: dict[str, Any]) -> dict[str, Any] | None:
        what = str(command["do"])
        if what == "why":
            return {"why": [[r.text, list(r.at)] for r in self._waits(str(command["route"]))]}
        if not who.operates:
            raise Refused("this browser may only look")
        if what in SIMULATED:
            if self.field is None:
                raise Refused("the railway is real: this can only be done where it is simulated")
            text = self._simulate(self.field, what, command)
        else:
            if not self.power and what not in ("acknowledge", "remind", "lamp test"):
                raise Refused("the controller has no power")
            text = self._operate(who, what, command)
        if text:
            self._note(Event("release" if what in ("release", "release all") else "operation", text, who.name))
        return None

    def _waits(self, route: str) -> list[Reason]:
        row = self.buttons.routes[route]
        moment = Moment(self._last.inputs, self._last.memory, self._dt_ms)
        active = next(r.active for r in self.picture.symbols.routes if r.number == row.number)
        if not self._last.memory.state.get(active):
            return self.reasons.of_request(row.number, moment, self._last.words().get(row.number, UNKNOWN))
        return self.reasons.of_stop(row.number, moment)

    def _operate(self, who: Person, what: str, c: Mapping[str, Any]) -> str:
        b, last = self.buttons, self._last
        match what:
            case "set":
                self._asked.ask(b.set(str(c["route"]), last), who.name)
                return ""
            case "swing":
                self._asked.ask(b.swing(str(c["signal"])), who.name)
                return f"swing the overlap of {c['signal']}"
            case "cancel":
                b.cancel(str(c["signal"]), last)
                return f"cancel the route from {c['signal']}"
            case "release":
                b.release(str(c["section"]), last)
                self.releases += 1
                return f"release section {c['section']} by hand (release {self.releases})"
            case "release all":
                b.release_all(last)
                self.releases += 1
                return f"release all clear sections (release {self.releases})"
            case "block":
                b.block(str(c["section"]), bool(c["on"]))
                return f"{'block' if c['on'] else 'free'} section {c['section']}"
            case "turn":
                b.turn(str(c["machine"]), str(c["to"]), last)
                return f"move {c['machine']} {'normal' if c['to'] == 'N' else 'reverse'} by hand"
            case "looked":
                b.looked(str(c["machine"]), last)
                return f"{c['machine']} was looked at after it was trailed"
            case "automatic":
                b.automatic(str(c["route"]), bool(c["on"]))
                return f"route {c['route']} {'works' if c['on'] else 'does not work'} automatically"
            case "direction":
                b.direction(str(c["boundary"]), bool(c["on"]))
                return f"special manual change of direction at {c['boundary']}: {'on' if c['on'] else 'off'}"
            case "voyage":
                b.voyage(str(c["name"]), bool(c.get("end")))
                return f"{'give up' if c.get('end') else 'begin'} voyage {c['name']}"
            case "train":
                b.train(str(c["name"]), str(c["section"]))
                return f"train {c['name']} stands in {c['section']}"
            case "acknowledge":
                those = [(str(key), str(since)) for key, since in c["alarms"]] if "alarms" in c else None
                for a in self.alarms.acknowledge(those, who.name):
                    self._note(Event("acknowledged", f"seen: {a.text}", who.name, a.at))
                return ""
            case "remind":
                return self._remind(str(c["at"]), str(c.get("text", "")), who)
            case "lamp test":
                return "lamp test"
        raise KeyError(what)

    def _remind(self, at: str, text: str, who: Person) -> str:
        if at not in self._shown:
            raise Refused(f"there is nothing called {at.partition(':')[2]}")
        text = text.strip()[:TEXT]
        if text:
            self.reminders[at] = [text, who.name, stamp()]
            return f"reminder on {at.partition(':')[2]}: {text}"
        if self.reminders.pop(at, None) is None:
            return ""
        return f"reminder on {at.partition(':')[2]} taken away"

    def _simulate(self, f: SimulatedField, what: str, c: Mapping[str, Any]) -> str:
        name = str(c.get("train", ""))
        match what:
            case "put":
                made = f.stand(str(c["section"]), str(c["towards"]), _metres(c), name)
                return f"train {made} stands in {c['section']}"
            case "bring":
                return f"train {f.bring(str(c['boundary']), _metres(c), name)} comes to {c['boundary']}"
            case "drive":
                f.drive(name, bool(c["go"]))
                return f"train {name} {'goes on' if c['go'] else 'is stopped'}"
            case "turn train":
                f.turn(name)
                return f"train {name} changes ends"
            case "divide":
                return f"train {name} is divided: {f.divide(name)} stays"
            case "take away":
                f.take_away(name)
                return f"train {name} is taken away"
            case "fail":
                f.fail(str(c["kind"]), str(c["name"]), bool(c["on"]))
                return f"fault {'of' if c['on'] else 'put right:'} {c['kind']} {c['name']}"
            case "power":
                self.power = bool(c["on"])
                return f"power {'on' if self.power else 'off'}"
            case "speed":
                if c["times"] not in SPEEDS:
                    raise Refused(f"time runs {', '.join(map(str, SPEEDS))} times as fast")
                self.clock.speed = int(c["times"])
                return f"time runs {self.clock.speed} times as fast"
        raise KeyError(what)


SIMULATED = ("put", "bring", "drive", "turn train", "divide", "take away", "fail", "power", "speed")
"""Commands that are about the simulated railway."""


def _metres(c: Mapping[str, Any]) -> float:
    metres = float(c.get("metres", LENGTH_M))
    if not 5.0 <= metres <= 1000.0:
        raise Refused("a train is between 5 and 1000 m long")
    return metres


def _waits(world: World, line: Beyond) -> str:
    """Why a train does not come in from a line yet, in brackets; empty if it is about to come."""
    if any(t.body[0] in line.comes_by for t in world.trains):
        return " (a train is on the line)"
    token = line.block is BlockKind.TOKEN
    return " (the neighbour has not got the direction)" if token and not world.token_at[line.name].have else ""
