"""Why a request is refused, or a signal stays at stop: as the controller says it, or as its own equations tell.

A refusal is the word that the controller has for the route; after it, the other conditions of that word that do not
hold either.  Where there is no word, the equation that did not come true is followed down to what was read or
remembered; each of those is told as a person at the panel would say it, with the elements that it is about.  Nothing is
decided here.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import cached_property
from math import ceil
from types import MappingProxyType

from interlock.dataclass import dataclass
from interlock.diag.called import called
from interlock.field.plc import Memory
from interlock.logic import names
from interlock.logic.at_stop import LOST, again, at_stop
from interlock.logic.behind import left_behind
from interlock.logic.controller import Controller, Equation, Input, Step, Timer
from interlock.logic.expr import AND, EQ, FALSE, NOT, TRUE, VAR, Expr, evaluate, variables
from interlock.logic.kept_locked import kept_locked
from interlock.logic.names import Name, computed
from interlock.logic.sentences import about, sentence
from interlock.logic.symbols import RouteSymbols, Symbols
from interlock.logic.words import REFUSED
from interlock.model.elements import MachineId, NodeId, Position, SectionId, SignalId
from interlock.model.layout import Layout


@dataclass(frozen=True)
class Reason:
    """One thing that stands in the way, and the elements (`s:`, `m:`, `g:`, `c:`, `z:`, `b:` and the name) to show."""

    text: str
    at: tuple[str, ...] = ()
    rule: str = ""
    """The page of the rule that asks for it, where the controller names one."""


@dataclass(frozen=True)
class Moment:
    """One scan: inputs as read, what was remembered before it, and the milliseconds since the scan before."""

    inputs: Mapping[str, int]
    before: Memory
    dt_ms: int


FROM_OUTSIDE = frozenset(
    (
        *(names.CLEAR, names.HEALTHY, names.CONTACT, names.CONDITION),
        *(names.LINE_CLEAR, names.NEIGHBOUR_GIVES, names.NEIGHBOUR_HAS),
        *(names.STOP_LAMP, names.CLEAR_LAMP, names.CAUTION_LAMP, names.IDENTIFIER_LAMP),
        *(names.SECOND_LAMP, names.SPEED_LAMP),
    )
)
"""Inputs that tell of the railway: while inputs are not valid nothing is known of what they stand for."""


_UNDER_WAY = frozenset(("inputs valid", "long clear", "signal closed", "locked"))
"""While one of these conditions of a release does not hold, nobody knows when the section is released."""


class Reasons:
    """Tells reasons for one controller."""

    def __init__(self, layout: Layout, controller: Controller) -> None:
        self._layout, self._controller = layout, controller
        self.symbols: Symbols = controller.symbols
        self._steps: dict[str, Step] = {s.name: s for s in controller.steps}
        self._inputs: dict[str, Input] = {i.name: i for i in controller.inputs}
        named = (*(s.name for s in controller.steps), *(s.name for s in controller.state), *self._inputs)
        self._names: dict[str, Name] = {n: n for n in named if isinstance(n, Name)}
        self._following: dict[str, Equation] = {computed(e.name): e for e in controller.next}
        self._held_until = controller.words.let_go(t.name for t in controller.timers)
        self._left = {str(x.lock): x for x in left_behind(controller)}
        self._at_stop, self._kept_locked = at_stop(controller), kept_locked(controller)
        self._notes: dict[str, str] = {s.name: s.note for s in controller.state}
        self._notes |= {i.name: i.note for i in controller.inputs}

    # --- what is asked -----------------------------------------------------------------------------

    def of_request(self, number: int, moment: Moment, code: int) -> list[Reason]:
        """Why a route was not set when its number was read; `code`: what the controller says of it."""
        r = next((x for x in self.symbols.routes if x.number == number), None)
        if r is None:
            return [self._no_swing(number, moment)]
        if moment.before.state.get(r.shown) and any(moment.before.state.get(n) for n in r.open_while):
            return [Reason("the route is set, and its signal open", (f"g:{r.entry}",))]
        if code <= REFUSED:
            return [Reason(f"the route is {self._controller.words.said(code)}", (f"g:{r.entry}",))]
        look = _Look(self, moment)
        lost = not look.value(self.symbols.valid)  # then nothing else is known
        others = [] if lost else self._controller.words.failing(self._controller.words.routes[number], look.true)
        codes = dict.fromkeys((code, *(k for k in others if k > REFUSED)))
        found: dict[str, Reason] = {}
        for reason in map(self._of_code, codes, [moment] * len(codes)):
            found.setdefault(reason.text, reason)
        return list(found.values())

    def _no_swing(self, number: int, moment: Moment) -> Reason:
        """Why an overlap does not swing."""
        g = next((g for g, n in self.symbols.overlaps.swing_request.items() if n == number), None)
        held = (name for (of, _), name in self.symbols.overlaps.held.items() if of == g)
        if g is not None and not any(moment.before.state.get(name) for name in held):
            return Reason(f"no overlap of {g} is held: there is nothing to swing", (f"g:{g}",))
        return Reason("the overlap cannot swing now: a train is near, or what it would lie over is not free")

    def swing(self, number: int, before: Memory, after: Memory) -> tuple[SignalId, bool] | None:
        """The signal whose overlap a number asks to swing, and whether another alternative is held after the scan; None
        for a number that asks for something else."""
        asked = self.symbols.overlaps.swing_request
        g = next((g for g, n in asked.items() if n == number), None)
        held = [n for (of, _), n in self.symbols.overlaps.held.items() if of == g]
        return None if g is None else (g, any(before.state.get(n) != after.state.get(n) for n in held))

    def _of_code(self, code: int, moment: Moment) -> Reason:
        """What a code says; of a lock, by whom it is held in this moment."""
        said = self._controller.words.reasons[code]
        state, read = moment.before.state, _Look(self, moment).value
        for kept in self._kept_locked.get(code, ()):
            past = not any(map(state.get, kept.active)) and all(map(state.get, kept.held))
            if past and not all(map(read, kept.detection)):
                return Reason(kept.text, said.at, said.rule)
        x = said.condition
        if x is not None and x.op is NOT and x.args[0].op is VAR and x.args[0].name in self.locks:
            return Reason(self.held(x.args[0].name, moment), said.at, said.rule)
        return Reason(f"{said.text}{self._to_go(code, moment)}", said.at, said.rule)

    def _to_go(self, code: int, moment: Moment) -> str:
        """For how long a route still holds what the author added to it; empty where that is not counted (yet)."""
        timers = [timer for held, timer in self._held_until.get(code, ()) if moment.before.state.get(held)]
        left = []
        for timer in timers:
            ran = None if timer is None else moment.before.elapsed.get(timer)
            if timer is None or ran is None:
                return ""
            step = self._steps[timer]
            assert isinstance(step, Timer)
            left.append(max(0, step.preset_ms - ran))
        return f": {ceil(max(left) / 1000)} s to go" if left else ""

    def of_stop(self, number: int, moment: Moment) -> list[Reason]:
        """What a route that is set still waits for before its signal opens."""
        gone = self._gone(number, moment)
        if gone is not None:
            return [gone]
        state = moment.before.state
        wire = names.OPENS(number) if state.get(names.LOCKED(number)) else names.LOCKS(number)
        on_the_way = self._on_the_way(number, state)
        leave = {"active", "wanted", *(["identifier wanted", "rear locked"] if on_the_way else ())}
        own = self._own(number, moment)
        found = [*self._told(wire, moment, leave, own), *self._drives(number, moment)]
        if on_the_way is not None:
            return [*found, on_the_way]
        if _Look(self, moment).value(computed(names.WANTED(number))) or LOST in (r.text for r in found):
            return found
        return [*found, Reason(again(bool(state.get(names.SHOWN(number))), self.symbols.routes.number[number].call_on))]

    def _own(self, number: int, moment: Moment) -> dict[tuple[str, bool], str]:
        """What is said of variables for a signal at stop, with what is to be done, by what each of them is."""
        look, stop = _Look(self, moment), self._at_stop.get(number)
        causes = stop.causes if stop is not None else ()
        fails = [x for x in causes if not any(bool(look.value(n)) is on for n, on in x.wanted)]
        firsts = {(str(x.wanted[0][0]), not x.wanted[0][1]): x.text for x in reversed(fails)}
        return {k: text for k, text in firsts.items() if self._names[k[0]].family in (names.STALE, names.TOKEN_HERE)}

    def _drives(self, number: int, moment: Moment) -> list[Reason]:
        """Drives that a block has stopped, which a route that is set does not command again, and those that have not
        started yet (R10)."""
        found = {}
        for m, x in self._demanded(number, moment):
            reason = None if _Look(self, moment).value(names.DETECTED(m, x)) else self._drive(m, x, moment)
            if reason is not None:
                found[m] = reason
        return [*found.values()]

    def _demanded(self, number: int, moment: Moment) -> Iterator[tuple[MachineId, Position]]:
        """The machines that a route needs, with those of the overlap that is held beyond it."""
        y, path = self.symbols, self.symbols.routes.number[number].path
        ways = [*path.ways, *([path.berth] if path.berth is not None else [])]
        for o, over in y.overlaps.ways.items():
            if path.overlap is not None and o[0] == path.overlap[0] and moment.before.state.get(y.overlaps.held[o]):
                ways += over
        yield from (d for way in ways for d in y.ways.demands[way])
        yield from path.demands

    def _drive(self, m: MachineId, x: Position, moment: Moment) -> Reason | None:
        """Why a machine that is not where it is needed does not turn."""
        y, state = self.symbols.machines, moment.before.state
        if m in y.kept_off and state.get(y.kept_off[m]):
            return Reason(f"the drive of {m} was stopped by a block: cancel the route and set it again", (f"m:{m}",))
        if m not in y.turn or state.get(y.turn[m]) or not state.get(names.COMMAND(m, x)):
            return None
        holds = "; ".join(reason.text for reason in self._told(names.MAY_START(m), moment, set()))
        text = (
            f"the drive of {m} has not started: {holds}" if holds else f"the drive of {m} waits for its turn to start"
        )
        return Reason(text, (f"m:{m}",))

    def _on_the_way(self, number: int, state: Mapping[str, bool]) -> Reason | None:
        """Past a signal whose identifier light is out: the train of the longer route is on its way, so that nobody can
        ask for that again, and the train stops there."""
        r = self.symbols.routes.number[number]
        longer = [x for x in self.symbols.routes if x.path.onward == number]
        if not longer or any(state.get(x.active) for x in longer):
            return None
        return Reason(
            f"its train has passed the signal before {r.entry}: cancel {r.entry}, then set a route from {r.entry}",
            (f"g:{r.entry}",),
        )

    def _gone(self, number: int, moment: Moment) -> Reason | None:
        """What lies past a signal that a route leads past was cancelled or used, and comes back only with the whole."""
        route = part = self.symbols.routes.number[number]
        while part.path.onward is not None:
            part = self.symbols.routes.number[part.path.onward]
            if not moment.before.state.get(part.active):
                way = f"what lies past {part.entry} is no longer set"
                return Reason(f"{way}: cancel {route.entry}, then set {route.id} again", (f"g:{part.entry}",))
        return None

    def of_loss(self, number: int, moment: Moment) -> list[Reason]:
        """Which condition of proceed was lost (R14)."""
        return self._told(names.CONDITIONS(number), moment, set())

    def of_move(self, machine: MachineId, to: Position, moment: Moment) -> list[Reason]:
        """Why a machine cannot be moved by hand; nothing where it can, as a device can always be closed (R13)."""
        by_hand = self._steps[names.MOVED_BY_HAND(machine, to)]
        assert isinstance(by_hand, Equation)
        if all(t.kind != "point free by hand" for t in by_hand.terms):
            return []
        look = _Look(self, moment)
        apart = (t.expr for t in by_hand.terms if t.kind == "other doors shut" and not look.true(t.expr))
        return [*self._not_free(machine, moment, ()), *(reason for x in apart for reason in look.why(x, True))]

    def of_hold(self, machine: MachineId, moment: Moment) -> list[Reason]:
        """What holds a machine where it lies, whether or not something stands over it: routes and overlaps, flank
        protection, and the restart."""
        return self._not_free(machine, moment, ("inputs valid", "point section clear"))

    def of_hold_read(self, machine: MachineId) -> frozenset[str]:
        """All that is remembered of which `of_hold` tells."""
        found: dict[str, None] = {}
        waiting: list[str] = [names.MOVABLE(machine)]
        while waiting:
            name = waiting.pop()
            step = self._steps.get(name)
            if name not in found and isinstance(step, Equation):
                waiting += variables([t.expr for t in step.terms])
            found[name] = None
        over = self.symbols.routes.over
        ways = [(SectionId(self.locks[n][0]), self.locks[n][1]) for n in found if n in self.locks]
        return frozenset((*found, *(r.active for way in ways for r in over.get(way, ()))))

    def _not_free(self, machine: MachineId, moment: Moment, leave: tuple[str, ...]) -> list[Reason]:
        """Why a machine is not free to move, but for conditions of some kinds."""
        free, look = self._steps[names.MOVABLE(machine)], _Look(self, moment)
        assert isinstance(free, Equation)
        found: dict[str, Reason] = {}
        for t in free.terms:
            for reason in look.why(t.expr, True) if t.kind not in leave and not look.true(t.expr) else ():
                flank = f"{machine} is held as flank protection: " if t.kind == "flank not held" else ""
                found.setdefault(flank + reason.text, Reason(flank + reason.text, reason.at))
        return list(found.values())

    def of_direction(self, boundary: NodeId, moment: Moment) -> list[Reason]:
        """Why the special manual change of direction does not run while it is asked for (R12); that the direction is
        given, is no reason: it is taken back first."""
        return self._told(names.MANUAL_RUNS(boundary), moment, {"operator", "not given away"})

    def of_release(self, section: SectionId, moment: Moment) -> list[Reason]:
        """Why a section is not released by hand, however long that is asked for: a route is set over it, or what lies
        in rear is locked towards it."""
        restart = moment.before.state.get(names.RESTART_LOCK(section))
        step = self._steps[names.RELEASED_AFTER_RESTART(section) if restart else names.RELEASED_BY_HAND(section)]
        assert isinstance(step, Equation)
        look, active = _Look(self, moment), {r.active: r for r in self.symbols.routes}
        found: dict[str, Reason] = {}
        for t in step.terms:
            if t.kind not in ("rear released", "no train about to come") or look.true(t.expr):
                continue
            for name in (n for n in variables((t.expr,)) if moment.before.state.get(n)):
                told = [active[name]] if name in active else []
                if name in self.locks and self.locks[name][0] != section:
                    in_rear = self.symbols.routes.over.get((SectionId(self.locks[name][0]), self.locks[name][1]), ())
                    told = [r for r in in_rear if moment.before.state.get(r.active)]
                    if not told:
                        text = f"{self.locked(name, moment)}: release it first"
                        found.setdefault(text, Reason(text, (f"s:{self.locks[name][0]}",)))
                for reason in map(self._cancel_first, told, [moment] * len(told)):
                    found.setdefault(reason.text, reason)
        return list(found.values())

    def _cancel_first(self, r: RouteSymbols, moment: Moment) -> Reason:
        """A route that is set keeps what it leads over."""
        going = moment.before.state.get(self.symbols.cancellation.cancelling[r.entry])
        text = f"route {r.id} is {'being cancelled: wait for that' if going else 'set: cancel it first'}"
        return Reason(text, (f"g:{r.entry}",))

    def _told(
        self, wire: str, moment: Moment, leave: set[str], own: Mapping[tuple[str, bool], str] = MappingProxyType({})
    ) -> list[Reason]:
        step = self._steps[wire]
        assert isinstance(step, Equation)
        look = _Look(self, moment, own)
        found: dict[str, Reason] = {}
        for t in step.terms:
            if t.kind not in leave and not look.true(t.expr):
                for reason in look.why(t.expr, True):
                    found.setdefault(reason.text, reason)
        return list(found.values())

    # --- names ---------------------------------------------------------------------------------------

    def said(self, name: str, is_true: bool) -> tuple[str, tuple[str, ...]]:
        """What is said of an input or state variable, empty where nothing is, and the element that it is about."""
        known = self._names.get(name)
        if known is None:
            return "", ()
        more = self._conditions.get(known, "") if not is_true else ""
        return sentence(known, is_true, self._layout.machines) + more, about(known)

    @cached_property
    def _conditions(self) -> dict[str, str]:
        texts = {c.id: c.text for c in self._layout.signalling.conditions if c.text}
        return {n: f": {texts[c]}" for c, n in self.symbols.condition.items() if c in texts}

    def locked(self, lock: str, moment: Moment) -> str:
        """By whom a section is locked."""
        section, way = self.locks[lock]
        routes = self.holders(section, way, moment.before.state)
        of = f" for route {', '.join(routes)}" if routes else " for a train that has passed its signal"
        return f"{called('section', section)} is locked{of}"

    def held(self, lock: str, moment: Moment) -> str:
        """By whom a section is locked, and how it is released from which the movement has gone."""
        section, way = self.locks[lock]
        step, look = self._steps[names.RELEASED_BY_HAND(section)], _Look(self, moment)
        assert isinstance(step, Equation)
        failing = {t.kind: t.expr for t in step.terms if not look.true(t.expr)}
        gone = not self.holders(section, way, moment.before.state)
        told = self._lets_go(lock, moment, failing) if gone and not failing.keys() & _UNDER_WAY else ""
        return self.locked(lock, moment) + told

    def _lets_go(self, lock: str, moment: Moment, failing: Mapping[str, Expr]) -> str:
        """What lets go of a section that reads clear, and when; `failing`: what its release by hand still asks for."""
        if "rear released" in failing:
            locked = [n for n in variables((failing["rear released"],)) if moment.before.state.get(n)]
            rear = {self.locks[n][0] for n in locked if n in self.locks}
            first = " and ".join(sorted(rear - {self.locks[lock][0]}))
            return f": {first} in rear is released first" if first else ""
        x = self._left.get(lock)
        if x is None or not moment.before.state.get(x.used):
            return ""
        delay, ran = self._steps[x.delay], moment.before.elapsed.get(x.delay)
        assert isinstance(delay, Timer)
        seconds = ceil(max(0, delay.preset_ms - (ran or 0)) / 1000)
        if moment.before.state.get(x.gone):
            told = f": it is released when no other train can be on its way to {x.signal}: {seconds} s to go"
            return told if ran is not None else ""
        told = f": nothing was seen to go on from there; release {called('section', str(x.section))} by hand"
        if "no train about to come" not in failing or not seconds:
            return told
        waits = f"{seconds} s to go" if ran is not None else f"it takes {seconds} s"
        return f"{told}: {waits}, as a train may be on its way to {x.signal}"

    def holders(self, section: str, way: int, state: Mapping[str, bool]) -> tuple[str, ...]:
        """The routes that are set over a way."""
        over = self.symbols.routes.over.get((SectionId(section), way), ())
        return tuple(str(r.id) for r in over if state.get(r.active))

    @cached_property
    def locks(self) -> dict[str, tuple[str, int]]:
        """By variable of a lock: section and way."""
        return {n: (str(s), k) for (s, k), n in self.symbols.sections.lock.items()}


class _Look:
    """Follows equations in one moment."""

    def __init__(
        self, reasons: Reasons, moment: Moment, own: Mapping[tuple[str, bool], str] = MappingProxyType({})
    ) -> None:
        self.r, self.moment, self.own = reasons, moment, own
        self._values: dict[str, int] = {}
        self._memo: dict[int, bool] = {}
        self._seen: set[tuple[str, bool]] = set()

    def value(self, name: str) -> int:
        """Of an input, a wire, a timer or a state variable."""
        if name not in self._values:
            self._values[name] = self._find(name)
        return self._values[name]

    def _find(self, name: str) -> int:
        step = self.r._steps.get(name) or self.r._following.get(name)
        if isinstance(step, Equation):
            return int(self.true(step.expr))
        if isinstance(step, Timer):
            ran = self.moment.before.elapsed.get(name)
            return int(bool(self.value(step.input)) and ran is not None and ran + self.moment.dt_ms >= step.preset_ms)
        given = self.r._inputs.get(name)
        if given is not None:
            return given.read(int(self.moment.inputs.get(name, given.restrictive)))
        return int(self.moment.before.state.get(name, False))

    def true(self, x: Expr) -> bool:
        """Whether an expression holds; wires below it are evaluated first, so that no stack grows."""
        return evaluate(x, self.value, self._memo)

    def why(self, x: Expr, wanted: bool) -> Iterator[Reason]:
        """What makes an expression other than wanted."""
        if x is TRUE or x is FALSE:
            return
        if x.op is NOT:
            yield from self.why(x.args[0], not wanted)
        elif x.op is VAR:
            yield from self._name(x.name, wanted)
        elif x.op is EQ:
            yield from self._leaf(x.name, not wanted)
        elif (x.op is AND) is wanted:
            for a in x.args:
                if self.true(a) is not wanted:
                    yield from self.why(a, wanted)
        else:  # each of several would do: the one that asks for least
            ways = [self._apart(a, wanted) for a in x.args]
            told, self._seen = min((w for w in ways if w[0]), key=lambda w: len(w[0]), default=([], self._seen))
            yield from told

    def _apart(self, x: Expr, wanted: bool) -> tuple[list[Reason], set[tuple[str, bool]]]:
        """One of several ways, and what has been told after it."""
        before, self._seen = self._seen, set(self._seen)
        told = list(self.why(x, wanted))
        after, self._seen = self._seen, before
        return told, after

    def _name(self, name: str, wanted: bool) -> Iterator[Reason]:
        if (name, wanted) in self._seen:
            return
        step = self.r._steps.get(name)
        if isinstance(step, Timer):
            yield from self._timer(step, wanted)
        elif isinstance(step, Equation) and wanted and step.name.family is names.OVERLAP_LIES:
            yield from self._overlap(step)
        elif isinstance(step, Equation):
            self._seen.add((name, wanted))
            for t in step.terms:
                if self.true(t.expr) is (not wanted):
                    yield from self.why(t.expr, wanted)
        else:
            yield from self._leaf(name, not wanted)

    @property
    def _valid(self) -> bool:
        return bool(self.value(self.r.symbols.valid))

    def _overlap(self, step: Equation) -> Iterator[Reason]:
        """Of an overlap that swings the alternative that is held has to lie and be clear: no other is told of."""
        g = SignalId(str(step.name.at[0]))
        held = [n for (of, _), n in self.r.symbols.overlaps.held.items() if of == g and self.value(n)]
        if not held:
            yield Reason(f"no overlap of {g} is held", (f"g:{g}",))
        for t in step.terms:
            if any(n in held for n in variables((t.expr,))):
                for reason in self.why(t.expr, True):
                    yield Reason(f"the overlap of {g}: {reason.text}", reason.at) if self._valid else reason

    def _timer(self, step: Timer, wanted: bool) -> Iterator[Reason]:
        if not wanted:
            return
        if not self.value(step.input):
            yield from self.why(self.r._steps[step.input].expr, True)  # type: ignore[union-attr]
            return
        left = max(0, step.preset_ms - (self.moment.before.elapsed.get(step.name) or 0)) / 1000
        yield Reason(f"{step.note.split(' (')[0]}: {left:.0f} s to go", about(step.name))

    def _leaf(self, name: str, is_true: bool) -> Iterator[Reason]:
        known = self.r._names.get(name)
        if known is not None and known.family in FROM_OUTSIDE and not self._valid:
            yield Reason(sentence(names.VALID, False, self.r._layout.machines))
            return
        if is_true and name in self.r.locks:
            yield Reason(self.r.held(name, self.moment), (f"s:{self.r.locks[name][0]}",))
            return
        text, at = self.r.said(name, is_true)
        text = self.own.get((name, is_true), text)
        if text:
            yield Reason(text, at)
        elif not any(self.r.said(name, x)[0] for x in (False, True)):
            note = self.r._notes.get(name, name)
            yield Reason(note if is_true else f"not: {note}")
