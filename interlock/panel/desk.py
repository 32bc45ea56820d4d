"""The desk behind all browsers: it runs the controller, carries out what is asked, and tells what has changed.

One thread runs cycles; commands wait in a queue and are carried out between two of them.  After each cycle what has
changed goes to whoever listens, as one text.  The desk never stops because of a browser.
"""

from __future__ import annotations

import os
import threading
import time
import traceback
from collections.abc import Callable, Iterable, Mapping
from contextlib import closing, suppress
from dataclasses import field
from typing import Any

from interlock.app.alarms import HAZARD, RECORD, TRAIN, Watch
from interlock.app.reasons import Moment, Reason
from interlock.app.run import LATE_S, Ready, run, since_boot
from interlock.dataclass import dataclass
from interlock.field.plc import Cycle, Link
from interlock.field.polling import Beside, InTurn
from interlock.panel.alarms import Alarm
from interlock.panel.asking import in_words
from interlock.panel.browsers import Browsers, now_s
from interlock.panel.clock import MOST_S, SPEEDS, Clock
from interlock.panel.commands import Refused
from interlock.panel.entry import LONGEST, WHY, Command, NotKnown, cleaned, line, never_late
from interlock.panel.event import Event, stamp
from interlock.panel.operating import Operating, Person
from interlock.panel.picture import Picture, still, trains
from interlock.panel.recorder import Recorder
from interlock.panel.simulated import SimulatedField
from interlock.panel.stock import LENGTH_M, Impossible
from interlock.panel.turns import LOOKS, Reply, Turn, Turns


@dataclass
class Ran:
    """How the cycles went: the longest, and the substations that could not be written at the end, and why."""

    longest_s: float = 0.0
    unwritten: dict[str, str] = field(default_factory=dict)


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
        self.ready, self._cycle_ms, self._recorder = ready, cycle_ms, recorder
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
        self.picture = Picture(ready)
        self.operating = Operating(
            ready,
            self.picture.dark(),
            0 if recorder is None else recorder.releases,
            self._note,
            (lambda now: None) if recorder is None else recorder.stands,
        )
        self._watch = self._watching()
        self.power = True
        self.ran = Ran()
        self._turns = Turns(LOOKS * cycle_ms / 1000)
        self._last = Cycle({}, {}, False, ())
        self._dt_ms = cycle_ms
        self._hazards = 0
        self.browsers = Browsers(still(ready, self.field), self.picture.dark(), self._rest(None))
        self._stop = threading.Event()
        self.publish: Callable[[Cycle | None, Iterable[str]], None] = lambda cycle, alarms: None
        """Told of every cycle, and of one without power (None), with the keys of the alarms that stand."""
        self.ended: Callable[[], None] = lambda: None
        """Called when the cycles have ended."""
        self.broken = ""
        """Why the thread ended, where it should not have."""
        self._restore()

    # --- browsers ----------------------------------------------------------------------------------

    def ask(self, who: Person, command: dict[str, Any], reply: Reply, why_not: str = "") -> None:
        """A command for the next cycle, or why it is refused then; `reply` is told what became of it, in the thread of
        the cycles."""
        self._turns.put(who, command, reply, why_not)

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
            if self._recorder is not None:
                self._recorder.close()
            self.ended()

    def _powered(self) -> None:
        now, sleep = (since_boot, time.sleep) if self.field is None else (self.clock.now, self.clock.sleep)
        self._last = Cycle({}, {}, False, ())
        self._watch = self._watching()
        self._once("the controller starts: every section stays locked until it is released")
        for s in self.operating.stands.blocks:
            self._note(Event("note", f"section {s} is still blocked", at=(f"s:{s}",)))
        poll = InTurn() if self.field is not None else Beside()
        left, ms = self.ran.unwritten.update, self._cycle_ms
        with closing(run(self.ready, self.links, ms, None, self._inputs, now, sleep, poll, left)) as cycles:
            for cycle, _ in cycles:
                self._after(cycle)
                if self._stop.is_set() or not self.power:
                    break

    def _without_power(self) -> None:
        assert self.field is not None
        self.field.dark()
        self.operating.begins_again()
        while not self.power and not self._stop.is_set():
            began = self.clock.now()
            self._commands()
            self.field.step(self._cycle_ms / 1000, {})
            if self._recorder is not None:
                self._recorder.cycle(None)
            self.publish(None, ())
            self.browsers.tell(self.picture.dark(self.operating.stands.blocks), lambda: self._rest(None))
            self.clock.sleep(max(0.0, self._cycle_ms / 1000 - (self.clock.now() - began)))

    def _inputs(self, last: Cycle | None, dt_ms: int) -> Mapping[str, int]:
        self._began = time.monotonic()
        self._dt_ms = dt_ms
        self._commands()
        found = self.operating.operator.inputs(last, dt_ms)
        for gone in self.operating.withdrawn():
            self._note(gone)
        for news in self.operating.operator.news():
            self._note(Event("note", news))
        for name in self.operating.operator.presses.let_go():
            self._note(Event("note", f"{name} is 0 again"))
        if self.field is not None:
            self.field.step(dt_ms / 1000, found)
        return found

    def _after(self, cycle: Cycle) -> None:
        before, self._last = self._last, cycle
        for text in self.operating.buttons.holds.let_go(cycle, self._dt_ms):
            self._note(Event("note", text))
        moment = Moment(cycle.inputs, before.memory, self._dt_ms)
        for answer in self.operating.answers(before, cycle, moment):
            self._note(answer)
        for x in self._watch.after(cycle, self._dt_ms):
            reasons = tuple(self.operating.reasons.of_loss(x.route.number, moment))
            self._alarm(self.operating.alarms.once(x.text, x.at, stamp()), reasons)
        found = dict(self._watch.causes)
        if self._watch.settled:
            found |= {f"{TRAIN} {n}": told for n, told in self.operating.operator.numbers.alarms.items()}
            if self._recorder is not None and self._recorder.lost:
                found[RECORD] = (self._recorder.lost, ())
            new, over = self.operating.alarms.stand(found, stamp())
            for a in over:
                self._note(Event("cleared", f"over: {a.text}", at=a.at))
            for a in new:
                self._alarm(a)
        if self.field is not None:
            hazards = self.field.world.watch.found
            for text in hazards[self._hazards :]:
                self._once(f"the bystander sees: {text}")
            self._hazards = len(hazards)
        if self._recorder is not None:
            self._recorder.cycle(cycle)
        self.publish(cycle, (*found, *self._watch.past, *([HAZARD] if self._hazards else [])))
        self.browsers.tell(self.picture.of(cycle, self._watch.idle), lambda: self._rest(cycle))
        self.ran.longest_s = max(self.ran.longest_s, time.monotonic() - self._began)

    # --- telling -----------------------------------------------------------------------------------

    def _watching(self) -> Watch:
        """A watch over the alarms from a start of the controller on."""
        layout, controller, allocation = self.ready.layout, self.ready.controller, self.ready.allocation
        assert layout is not None and controller is not None and allocation is not None
        return Watch(layout, controller, allocation)

    def _restore(self) -> None:
        """What was blocked when the server ended is blocked again, and reminders stand; what the record does not say
        because another one has begun is an alarm, and stays with the record until somebody has seen to it."""
        if self._recorder is None:
            return
        for a in self.operating.restore(self._recorder.standing, self._recorder.left_behind):
            self._alarm(a)
        self._recorder.stands(self.operating.stands)
        self.browsers.tell(self.picture.dark(self.operating.stands.blocks), lambda: self._rest(None))

    def _once(self, text: str, *at: str) -> None:
        self._alarm(self.operating.alarms.once(text, at, stamp()))

    def _alarm(self, a: Alarm, reasons: tuple[Reason, ...] = ()) -> None:
        self._note(Event("alarm", a.text, at=a.at, reasons=reasons))

    def _note(self, event: Event) -> None:
        self.browsers.note(event)
        if self._recorder is not None:
            self._recorder.event(event)

    def _rest(self, cycle: Cycle | None) -> dict[str, Any]:
        """What belongs to no element."""
        y, dispatcher = self.picture.symbols, self.operating.operator.dispatcher
        state: Mapping[str, bool] = {} if cycle is None else cycle.memory.state
        locked = [str(s) for s, n in self.picture.to_release.items() if state.get(n)]
        timer = None if cycle is None else self.picture.left(cycle, y.start.restart_timer)
        return {
            "sys": {
                "day": stamp()[:10],
                "power": self.power,
                "valid": cycle is not None and cycle.valid,
                "lost": [] if cycle is None else list(cycle.lost),
                "restart": locked,
                "delay": timer if locked else None,
                "releasing": cycle is not None and bool(cycle.inputs.get(y.sections.release_all)),
                "releases": self.operating.releases,
                "speed": self.clock.speed if self.field is not None else 0,
                "minutes": int(self.clock.now() // 60) if self.field is not None else 0,
                "failed": [] if self.field is None else sorted(map(list, self.field.faults.failed)),
                "voyages": [[r.name, r.reason] for r in (*dispatcher.runs, *dispatcher.pending)],
                "numbers": [[n, under] for n, under in self.operating.operator.numbers.sections.items()],
            },
            "alarms": [a.told() for a in self.operating.alarms.all.values()],
            "reminders": {k: list(v) for k, v in self.operating.reminders.items()},
            "trains": [] if self.field is None else trains(self.field),
        }

    # --- commands ----------------------------------------------------------------------------------

    def _commands(self) -> None:
        for turn in self._turns.due():
            answer = self._answer(turn)
            with suppress(Exception):  # whoever cannot be told has gone
                turn.reply(answer)

    def _answer(self, turn: Turn) -> dict[str, Any]:
        """What becomes of a command; whatever is wrong with it, or with us, the cycles go on."""
        who = turn.who
        try:
            command = cleaned(turn.command)
            try:
                return {"ok": True, **(self._do(turn, command) or {})}
            except (Refused, Impossible) as no:
                at = tuple(getattr(no, "at", ()))
                asked = in_words(command, self.picture.layout.machines)
                self._note(Event("refusal", f"{asked}: refused: {no}", who.name, at))
                return {"ok": False, "why": [[str(no), list(at)]]}
        except NotKnown as no:
            return {"ok": False, "why": [[str(no), []]]}
        except Exception as error:
            if os.environ.get("INTERLOCK_DEBUG"):
                traceback.print_exc()
            text = line(f"{DEFECT}: {type(error).__name__}: {error}", LONGEST)
            with suppress(Exception):  # the record may be what fails: browsers are told before it
                self._note(Event("note", text, who.name))
            return {"ok": False, "why": [[text, []]]}

    def _do(self, turn: Turn, command: Command) -> dict[str, Any] | None:
        who, what = turn.who, command["do"]
        if what == WHY:
            found = self.operating.waits(command["route"], self._last, self._dt_ms)
            return {"why": [[r.text, list(r.at)] for r in found]}
        if not who.operates:
            raise Refused("this browser may only look")
        if not never_late(what, command) and (why_not := turn.why_not or _late(turn, command)):
            raise Refused(why_not)
        if what in SIMULATED:
            if self.field is None:
                raise Refused("the railway is real: this can only be done where it is simulated")
            text = self._simulate(self.field, what, command)
        else:
            if not self.power and what not in WITHOUT_POWER:
                raise Refused("the controller has no power")
            text = self.operating.carry_out(who, what, command, self._last)
        if text:
            self._note(Event("release" if what in ("release", "release all") else "operation", text, who.name))
        return None

    def _simulate(self, f: SimulatedField, what: str, c: Command) -> str:
        name = c.get("train", "")
        match what:
            case "put":
                made = f.stock.stand(c["section"], c["towards"], _metres(c), name)
                return f"train {made} stands in {c['section']}{self.picture.not_counted(c['section'], self._last)}"
            case "bring":
                return f"train {f.stock.bring(c['boundary'], _metres(c), name)} comes to {c['boundary']}"
            case "drive":
                f.stock.drive(name, c["go"])
                return f"train {name} {'goes on' if c['go'] else 'is stopped'}"
            case "turn train":
                f.stock.turn(name)
                return f"train {name} changes ends"
            case "divide":
                return f"train {name} is divided: {f.stock.divide(name)} stays"
            case "take away":
                f.stock.take_away(name)
                return f"train {name} is taken away"
            case "fail":
                f.faults.fail(c["kind"], c["name"], c["on"])
                found = f.faults.called(c["kind"], c["name"])
                return f"fault {'of' if c['on'] else 'put right:'} {found}"
            case "power":
                self.power = c["on"]
                return f"power {'on' if self.power else 'off'}"
            case "speed":
                if c["times"] not in SPEEDS:
                    raise Refused(f"time runs {', '.join(map(str, SPEEDS))} times as fast")
                self.clock.speed = int(c["times"])
                return f"time runs {self.clock.speed} times as fast"
        raise NotKnown


DEFECT = "a defect of this program, please report it"
"""What is said where a command fails for no reason that the program knows."""

AHEAD_S = 1.0
"""Seconds from now that a browser may say it asks at (our choice): it knows our clock to within the time that a message
takes, and one that takes longer is old."""


def _late(turn: Turn, command: Command) -> str:
    """Why what was asked for is not done any more; empty where it is not late."""
    age = max(age_s(command), since_boot() - turn.since)
    if age_s(command) < -AHEAD_S:
        return f"it says that it is asked for in {-age_s(command):.0f} s: when that was is not known, ask again"
    return f"it was asked for {age:.0f} s ago, and is not done now: ask again" if age > LATE_S else ""


def age_s(command: Command) -> float:
    """Seconds since a browser asked: when it had heard from here last, by the clock here, and how long after that the
    click was, in milliseconds by its own.  0 where it does not say."""
    heard, after = command.get("heard"), command.get("after")
    if heard is None or after is None:
        return 0.0
    return float(now_s() - heard - after / 1000)


SIMULATED = ("put", "bring", "drive", "turn train", "divide", "take away", "fail", "power", "speed")
"""Commands that are about the simulated railway."""

WITHOUT_POWER = ("acknowledge", "remind", "lamp test", "block")
"""Commands that are about this place, and not about the controller."""


def _metres(c: Command) -> float:
    metres = float(c.get("metres", LENGTH_M))
    if not 5.0 <= metres <= 1000.0:
        raise Refused("a train is between 5 and 1000 m long")
    return metres
