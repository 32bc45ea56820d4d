"""Why a request is refused, or a signal stays at stop: in words, from the controller's own equations.

The equation that did not come true is followed down to what was read or remembered; each of those is told as a person
at the panel would say it, with the elements that it is about.  Nothing is decided here.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property

from interlock.field.plc import Memory
from interlock.logic.controller import Controller, Equation, Input, Step, Symbols, Term, Timer
from interlock.logic.expr import AND, EQ, FALSE, NOT, TRUE, VAR, Expr, evaluate
from interlock.model.elements import Position, SectionId
from interlock.model.layout import Layout
from interlock.model.portable import portable

LIES = {Position.NORMAL: "normal", Position.REVERSE: "reverse"}


@dataclass(frozen=True)
class Reason:
    """One thing that stands in the way, and the elements (`s:`, `m:`, `g:`, `c:`, `z:`, `b:` and the name) to show."""

    text: str
    at: tuple[str, ...] = ()


@dataclass(frozen=True)
class Moment:
    """One scan: inputs as read, what was remembered before it, and the milliseconds since the scan before."""

    inputs: Mapping[str, int]
    before: Memory
    dt_ms: int


class Reasons:
    """Tells reasons for one controller."""

    def __init__(self, layout: Layout, controller: Controller) -> None:
        self.layout, self.controller = layout, controller
        self.symbols: Symbols = controller.symbols
        self._steps: dict[str, Step] = {s.name: s for s in controller.steps}
        self._inputs: dict[str, Input] = {i.name: i for i in controller.inputs}
        self._notes: dict[str, str] = {s.name: s.note for s in controller.state}
        self._notes |= {i.name: i.note for i in controller.inputs}

    # --- what is asked -----------------------------------------------------------------------------

    def of_request(self, number: int, moment: Moment) -> list[Reason]:
        """Why a route was not set when its number was read."""
        r = next((x for x in self.symbols.routes if x.number == number), None)
        if r is None:
            return [Reason("the overlap cannot swing now: a train is near, or what it would lie over is not free")]
        if moment.before.state.get(r.shown) and any(moment.before.state.get(n) for n in r.open_while):
            return [Reason("the route is set, and its signal open", (f"g:{r.entry}",))]
        return self._told(f"G_R{number}", moment, {"requested"}) or [Reason("it was asked for in a scan too short")]

    def of_stop(self, number: int, moment: Moment) -> list[Reason]:
        """What a route that is set still waits for before its signal opens."""
        state = moment.before.state
        wire = f"PR_R{number}" if state.get(f"B_R{number}") else f"LK_R{number}"
        wanted = not state.get(f"B_R{number}") or state.get(f"W_R{number}")
        found = self._told(wire, moment, {"active", "wanted"})
        return found if wanted else [*found, Reason("it has closed once, and opens only when it is asked for again")]

    def of_loss(self, number: int, moment: Moment) -> list[Reason]:
        """Which condition of proceed was lost (R14)."""
        return self._told(f"CO_R{number}", moment, set())

    def _told(self, wire: str, moment: Moment, leave: set[str]) -> list[Reason]:
        step = self._steps[wire]
        assert isinstance(step, Equation)
        look = _Look(self, moment)
        found: dict[str, Reason] = {}
        for t in step.terms:
            if t.kind not in leave and not look.true(t.expr):
                for reason in look.term(t):
                    found.setdefault(reason.text, reason)
        return list(found.values())

    # --- names ---------------------------------------------------------------------------------------

    @cached_property
    def words(self) -> dict[str, tuple[str, str, str]]:
        """By name of an input or state variable: what is said when it is 0, when it is 1, and the element."""
        y = self.symbols
        out: dict[str, tuple[str, str, str]] = {}
        for s, n in y.clear.items():
            out[n] = (f"section {s} is occupied", f"section {s} is clear", f"s:{s}")
        for s, n in y.healthy.items():
            out[n] = (f"the detector of section {s} is out of order", "", f"s:{s}")
        for s, n in y.blocked.items():
            out[n] = ("", f"section {s} is blocked", f"s:{s}")
        for s, n in y.restart.items():
            out[n] = ("", f"section {s} is not released since the restart", f"s:{s}")
        for s, n in y.stale.items():
            out[n] = ("", f"section {s}: inputs were lost, or a train was called on; release it by hand", f"s:{s}")
        for s, n in y.used.items():
            out[n] = (f"no train has come into section {s}", f"a train is in section {s}", f"s:{s}")
        for s, n in y.train.items():
            out[n] = ("", f"section {s} is locked for a train", f"s:{s}")
        for m, n in y.trailed.items():
            out[n] = ("", f"points {m} were trailed: look at them, and confirm it", f"m:{m}")
        for (m, x), n in y.detected.items():
            out[n] = (f"{m} is not detected {LIES[x]}", f"{m} is detected {LIES[x]}", f"m:{m}")
        for c, n in y.condition.items():
            text = next((k.text for k in self.layout.conditions if k.id == c and k.text), "")
            out[n] = (f"condition {c} does not hold{': ' + text if text else ''}", "", f"c:{c}")
        for lamps, what in ((y.stop_lamp, "stop"), (y.clear_lamp, "clear"), (y.caution_lamp, "caution")):
            for g, n in lamps.items():
                out[n] = (f"the {what} lamp of {g} is out", "", f"g:{g}")
        for g, n in y.cancelling.items():
            out[n] = ("", f"the route from {g} is being cancelled", f"g:{g}")
        for (g, _), n in y.overlap.items():
            out[n] = ("no overlap is held", f"the overlap of {g} is held there", f"g:{g}")
        for b, x_ in y.token.items():
            out[x_.have] = (f"the direction at {b} is not ours", "", f"b:{b}")
            out[x_.clear] = (f"the line at {b} is not clear", "", f"b:{b}")
        out[y.valid] = ("inputs are not valid: a substation is lost", "", "")
        out[y.restart_timer] = ("the restart delay is not over", "", "")
        return out

    def holders(self, section: str, way: int, state: Mapping[str, bool]) -> tuple[str, ...]:
        """The routes that are set over a way."""
        over = self.symbols.routes_over.get((SectionId(section), way), ())
        return tuple(str(r.id) for r in over if state.get(r.active))

    @cached_property
    def locks(self) -> dict[str, tuple[str, int]]:
        """By variable of a lock: section and way."""
        return {n: (str(s), k) for (s, k), n in self.symbols.lock.items()}

    @cached_property
    def moves(self) -> dict[str, tuple[str, str]]:
        """By wire that tells whether a machine can be demanded in a position: the machine and the position."""
        return {f"AV{x}_{portable(m)}": (str(m), LIES[x]) for m in self.layout.machines for x in Position}


class _Look:
    """Follows equations in one moment."""

    def __init__(self, reasons: Reasons, moment: Moment) -> None:
        self.r, self.moment = reasons, moment
        self._values: dict[str, int] = {}
        self._memo: dict[int, bool] = {}
        self._seen: set[tuple[str, bool]] = set()

    def value(self, name: str) -> int:
        """Of an input, a wire, a timer or a state variable."""
        if name not in self._values:
            self._values[name] = self._find(name)
        return self._values[name]

    def _find(self, name: str) -> int:
        step = self.r._steps.get(name)
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

    def term(self, t: Term) -> Iterator[Reason]:
        """Why a term does not hold."""
        if t.kind == "zone not full":
            zone = next((z.id for z in self.r.layout.zones if z.id in t.note.replace(":", " ").split()), "")
            yield Reason(f"zone {zone} is full: {t.note}", (f"z:{zone}",))
            return
        yield from self.why(t.expr, True)

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
        if wanted and name in self.r.moves:
            yield from self._cannot_move(*self.r.moves[name], name)
            return
        step = self.r._steps.get(name)
        if isinstance(step, Timer):
            yield from self._timer(step, wanted)
        elif isinstance(step, Equation):
            self._seen.add((name, wanted))
            for t in step.terms:
                if self.true(t.expr) is (not wanted):
                    yield from self.term(t) if wanted else self.why(t.expr, False)
        else:
            yield from self._leaf(name, not wanted)

    def _timer(self, step: Timer, wanted: bool) -> Iterator[Reason]:
        if not wanted:
            return
        ran = self.moment.before.elapsed.get(step.name)
        if ran is None:
            yield from self.why(self.r._steps[step.input].expr, True)  # type: ignore[union-attr]
            return
        left = max(0, step.preset_ms - ran) / 1000
        yield Reason(f"{step.note.split(' (')[0]}: {left:.0f} s to go")

    def _cannot_move(self, machine: str, position: str, name: str) -> Iterator[Reason]:
        """A machine lies elsewhere and may not move: for what holds it, unless that has been told already."""
        self._seen.add((name, True))
        at = f"m:{machine}"
        move = self.r._steps[f"MOV_{portable(machine)}"]
        assert isinstance(move, Equation)
        causes: dict[str, Reason] = {}
        for t in move.terms:
            if not self.true(t.expr):
                for c in self.why(t.expr, True):
                    causes.setdefault(c.text, c)
        for c in causes.values():
            yield Reason(f"points {machine} cannot go {position}: {c.text}", (at, *c.at))

    def _leaf(self, name: str, is_true: bool) -> Iterator[Reason]:
        if is_true and name in self.r.locks:
            section, way = self.r.locks[name]
            routes = self.r.holders(section, way, self.moment.before.state)
            of = f" for route {', '.join(routes)}" if routes else " for a train that has passed its signal"
            yield Reason(f"section {section} is locked{of}", (f"s:{section}",))
            return
        said = self.r.words.get(name)
        text = said[is_true] if said is not None else ""
        if text:
            yield Reason(text, (said[2],) if said is not None and said[2] else ())
        elif said is None or not any(said[:2]):
            note = self.r._notes.get(name, name)
            yield Reason(note if is_true else f"not: {note}")
