"""The controller as one Python file without any dependency; same scan, same names as the Structured Text."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Iterator, Sequence
from itertools import groupby

from interlock.logic.at_stop import LOST, Cause, at_stop
from interlock.logic.behind import left_behind
from interlock.logic.controller import Controller, Equation, Join
from interlock.logic.expr import AND, EQ, FALSE, NOT, TRUE, VAR, Expr
from interlock.logic.kept_locked import kept_locked
from interlock.logic.names import LOCK, Kind, Name, computed
from interlock.logic.on_delay import CYCLE_MAX_MS
from interlock.logic.words import CANCELLING, REFUSED, SAID, SET

WIDTH = 120  # columns of lines that hold several names


def _code(x: Expr, outer: bool = False, kept: Collection[Name] = ()) -> str:
    """An expression; outer: something stands before or behind it that binds more strongly than `and` and `or`; kept:
    the state, where its value after the scan is meant."""
    if x.op is VAR:
        return computed(x.name) if x.name in kept else x.name
    if x is TRUE or x is FALSE:
        return str(x is TRUE)
    if x.op is EQ:
        return f"({x.name} == {x.value})"
    if x.op is NOT:
        return f"not {_code(x.args[0], True, kept)}"
    body = (" and " if x.op is AND else " or ").join([_code(a, True, kept) for a in x.args])
    return f"({body})" if outer else body


def _equation(e: Equation, name: str) -> str:
    """What a variable means stands above, by its family; here is how it is computed."""
    neutral = TRUE if e.join is Join.ALL else FALSE
    terms = [_code(t.expr, True) for t in e.terms if t.expr is not neutral] or [str(neutral is TRUE)]
    return f"        {name} = {(' and ' if e.join is Join.ALL else ' or ').join(terms)}"


def _filled(indent: str, items: Iterable[str]) -> Iterator[str]:
    """Items with commas behind them, on as few lines as they need."""
    line = ""
    for item in items:
        if line and len(line) + len(item) + 2 > WIDTH:
            yield line
            line = ""
        line = f"{line} {item}," if line else f"{indent}{item},"
    if line:
        yield line


def _state(c: Controller) -> Iterator[str]:
    """What is remembered, place by place; a lock of a way with the ends of the way."""
    place = {e.name: e.group for e in c.next}
    for locks, part in groupby(c.state, lambda s: (s.name.family is LOCK and s.name, place[s.name])):
        mine = list(part)
        *lines, last = _filled("    ", [f"{s.name!r}: {s.initial}" for s in mine])
        yield from lines
        yield f"{last}  # {_plain(mine[0].note if locks[0] else place[mine[0].name])}"


def _families(c: Controller) -> Iterator[str]:
    """What the names of variables mean, by their families."""
    yield "# Names: `*` is an element, a number or a position; N_ before a name is its value after the scan."
    named = [*(s.name for s in c.state), *(e.name for e in c.equations), *(w.name for w in c.words.words)]
    for family in dict.fromkeys(n.family for n in named if n.family.key):
        of = f" ({family.kind})" if family.kind is not Kind.NOTHING else ""
        yield f"# {re.sub('{[0-9]?}', '*', family.pattern)}{of}: {family.meaning}"


def _plain(text: str) -> str:
    return text if text.isprintable() else "".join(c if c.isprintable() else "?" for c in text)


def route_numbers(c: Controller) -> dict[str, int]:
    """The number that asks for each route, by its id and by the names that the author gives to it."""
    found = {str(r.id): r.number for r in c.symbols.routes}
    for r in c.symbols.routes:
        for name in r.names:
            found.setdefault(name, r.number)
    return found


def cancelled_after(c: Controller) -> dict[int, str]:
    """The timer of approach locking by the number of each route."""
    return {r.number: str(c.symbols.cancellation.approach_timer[r.entry]) for r in c.symbols.routes}


def held_until(c: Controller) -> dict[int, tuple[tuple[str, str | None], ...]]:
    """By the code of a refusal what may tell that a route holds what keeps this one out, and the timer at whose end it
    lets go; None where it does at once."""
    found = c.words.let_go(t.name for t in c.timers)
    return {
        code: tuple((str(held), None if timer is None else str(timer)) for held, timer in those)
        for code, those in found.items()
    }


def left(c: Controller) -> dict[int, tuple[str, str, str, str, str, str]]:
    """By the code of a refusal by a section behind a signal from which a movement has gone: the signal, what tells that
    something came in, and that it went on, the timers of the release and of approach locking, and the input that
    releases by hand."""
    behind = {x.lock: x for x in left_behind(c)}
    found = {}
    for r in c.words.reasons.values():
        x = r.condition
        of = behind.get(x.args[0].name) if x is not None and x.op is NOT and x.args[0].op is VAR else None
        if of is not None:
            found[r.code] = str(of.signal), str(of.used), str(of.gone), str(of.clear), str(of.delay), str(of.release)
    return found


Kept = tuple[tuple[str, ...], tuple[str, ...], tuple[str, ...], str]


def occupied(c: Controller) -> dict[int, tuple[Kept, ...]]:
    """By the code of a refusal by a lock: the inputs that detect the section, or one in rear, what tells that a route
    is set over it, what must be held, and what is said while one of the first reads 0, none of the second is so and all
    of the third are."""
    return {
        code: tuple((_each(x.detection), _each(x.active), _each(x.held), _plain(x.text)) for x in those)
        for code, those in kept_locked(c).items()
    }


def _each(those: tuple[Name, ...]) -> tuple[str, ...]:
    return tuple(map(str, those))


Told = tuple[tuple[tuple[str, bool], ...], str, str]
"""What is wanted of variables, one of which would do, what is said otherwise, and the rule."""


def stopped(c: Controller) -> tuple[dict[int, Told], dict[int, tuple[tuple[int, ...], str, str, str, int, int]]]:
    """Why a signal is at stop: every cause by a number; by the number of a route its causes, what tells that it is set,
    that somebody wants its signal open, and that it has been open, and what is said where nobody does after that, and
    before."""
    numbers: dict[Cause, int] = {}
    routes = {}
    for route, x in at_stop(c).items():
        *causes, been, hindered = (numbers.setdefault(k, len(numbers)) for k in (*x.causes, x.been, x.hindered))
        routes[route] = tuple(causes), str(x.active), str(x.wants), str(x.shown), been, hindered
    told = {n: (tuple((str(v), on) for v, on in k.wanted), _plain(k.text), k.rule) for k, n in numbers.items()}
    return told, routes


def said(c: Controller) -> dict[int, tuple[str, str]]:
    """What the words of a controller say by their codes, and the rule behind each."""
    return {k: (x, "") for k, x in SAID.items()} | {r.code: (_plain(r.text), r.rule) for r in c.words.reasons.values()}


FIXED = f'''class Controller:
    """A running controller; `state` and `elapsed` are all that it remembers."""

    cycle_max_ms = {CYCLE_MAX_MS}

    def __init__(self):
        self.state = dict(STATE)
        self.elapsed = dict.fromkeys(TIMERS)
        self._last = None

    def _timer(self, name, on, dt_ms):
        """An on-delay timer: in the scan in which `on` becomes true no time has passed yet."""
        if not on:
            self.elapsed[name] = None
            return False
        before = self.elapsed[name]
        self.elapsed[name] = 0 if before is None else min(before + dt_ms, TIMERS[name])
        return self.elapsed[name] >= TIMERS[name]

    @staticmethod
    def request(route):
        """What asks for a route by its name, for one scan: `scan({{**inputs, **request('X1-X3')}}, dt_ms)`."""
        if route not in ROUTES:
            raise ValueError(f'there is no route {{route}}; ROUTES has the names of all')
        return {{'REQ': ROUTES[route]}}

    @staticmethod
    def _first(*cases):
        """The value after the first condition that holds; the last value where none does."""
        for i in range(0, len(cases) - 1, 2):
            if cases[i]:
                return cases[i + 1]
        return cases[-1]

    def words(self):
        """What the last scan says of every route by its number, as a code; 0 before the first scan."""
        if self._last is None:
            return dict.fromkeys(ROUTES.values(), 0)
        before = Controller()
        before.state, before.elapsed, inputs, dt_ms = self._last
        before.elapsed = dict(before.elapsed)
        return before.scan(inputs, dt_ms, True)

    def status(self, route):
        """What the last scan says of a route by its name: its code, and what that means."""
        number = self.request(route)['REQ']
        code = self.words()[number]
        return code, self._told(number, code)[0]

    def why_not(self, route):
        """Why the route was refused, or would have been, if it was not set: the first condition that did not hold; of
        one that is set and at stop what its signal waits for, or what is to be done.

        Its code, the sentence, and the rule that asks for it; None while it is free, open, being cancelled or waiting
        for points, or nothing is known that keeps its signal at stop.
        """
        number = self.request(route)['REQ']
        code = self.words()[number]
        sentence, rule = self._told(number, code)
        return (code, sentence, rule) if code > {REFUSED} or (code == {SET} and rule) else None

    def _told(self, number, code):
        """What a code says of a route in this moment, and the rule."""
        sentence, rule = SAID[code]
        if code == {SET} and number in AT_STOP and self._last[0][AT_STOP[number][1]]:
            causes, _, wants, shown, been, hindered = AT_STOP[number]
            told = [c for c in causes if not any(self._is(name) == on for name, on in CAUSES[c][0])][:1]
            if not self.state[wants] and not (told and CAUSES[told[0]][1] == {LOST!r}):
                told.append(been if self._last[0][shown] else hindered)
            if told:
                return f"{{sentence}}: {{'; '.join(CAUSES[c][1] for c in told)}}", CAUSES[told[0]][2]
        for detection, active, held, instead in OCCUPIED.get(code, ()):
            if not all(map(self._is, detection)) and not any(map(self._is, active)) and all(map(self._is, held)):
                return instead, rule
        return sentence + self._left(code), rule

    def _is(self, name):
        """An input of the last scan, what was remembered before it, or whether a timer has run out."""
        if name in TIMERS:
            return self.elapsed[name] is not None and self.elapsed[name] >= TIMERS[name]
        return bool(self._last[2][name] if name in INPUTS else self._last[0][name])

    def _left(self, code):
        """How a section is released from which a movement has gone, and when; empty where something else holds it."""
        if code not in LEFT:
            return ''
        signal, used, gone, clear, delay, release = LEFT[code]
        if not self._last[0][used] or self.elapsed[clear] is None:
            return ''
        counted = self.elapsed[delay] is not None
        seconds = -(-max(TIMERS[t] - (self.elapsed[t] or 0) for t in (clear, delay)) // 1000)
        if self._last[0][gone]:
            told = f'it is released when no other train can be on its way to {{signal}}: {{seconds}} s to go'
            return f': {{told}}' if counted else ''
        told = f': nothing was seen to go on from there; hold {{release}}'
        if counted and seconds:
            return f'{{told}}, for {{seconds}} s or more'
        told = f'{{told}} until it is released'
        delayed = TIMERS[delay] and not counted
        return f'{{told}} ({{seconds}} s while a train may be on its way to {{signal}})' if delayed else told

    def countdown_ms(self, route):
        """How long it takes until the cancelled route is given up, or until no other one holds any longer what keeps
        this one out, as `why_not` tells it, or a section behind a train is released at the latest: None while nothing
        is counted, or is released by hand alone.  A door that is held open shuts after that.
        """
        number = self.request(route)['REQ']
        code = self.words()[number]
        if code == {CANCELLING}:
            timers = [CANCELLED_AFTER[number]]
        elif code in LEFT:
            _, used, gone, clear, delay, _ = LEFT[code]
            timers = [clear, delay] if self._last[0][used] and self._last[0][gone] else []
        else:
            timers = [timer for held, timer in HELD_UNTIL.get(code, ()) if self._last[0][held]]
        if not timers or any(timer is None or self.elapsed[timer] is None for timer in timers):
            return None
        return max(TIMERS[timer] - self.elapsed[timer] for timer in timers)

    def scan(self, inputs, dt_ms, say=False):
        """One scan, `dt_ms` milliseconds after the last; returns the outputs.

        `say`: nothing is changed but timers, and the words are returned instead (`words` asks for it).

        After a cycle longer than `cycle_max_ms`, or with a bit that is neither 0 nor 1, the inputs count as lost:
        nobody knows what happened meanwhile, or what was meant.
        Raises ValueError for a name that is no input and a time that cannot be, and TypeError for inputs that are no
        dictionary, one that is no whole number or truth value, and a time that is no number; nothing has changed then.
        """
        if not isinstance(inputs, dict):
            raise TypeError(f'inputs are {{inputs!r}}: no dictionary of names and values')
        unknown = inputs.keys() - INPUTS.keys()
        if unknown:
            raise ValueError(f'no inputs of this interlocking: {{sorted(map(str, unknown))}}')
        if isinstance(dt_ms, bool) or not isinstance(dt_ms, (int, float)):
            raise TypeError(f'dt_ms is {{dt_ms!r}}: no number of milliseconds')
        if not 0 <= dt_ms < float('inf'):
            raise ValueError(f'dt_ms is {{dt_ms}}: no time since the last scan')
        read, doubtful = {{}}, False
        for name, (restrictive, size) in INPUTS.items():
            value = inputs.get(name, restrictive)
            if not isinstance(value, int):
                raise TypeError(f'input {{name}} is {{value!r}}: neither a whole number nor a truth value')
            value = int(value)
            impossible = size - 1 if size > 2 else restrictive  # a number that names nothing
            read[name] = value if 0 <= value < size else impossible
            doubtful = doubtful or (size == 2 and read[name] != value)  # no bit: nobody knows what was meant
        self._last = self.state, dict(self.elapsed), read, dt_ms
        if doubtful or dt_ms > self.cycle_max_ms:
            read['VALID'] = 0
'''
"""What every runtime has in common, up to the first line that depends on the controller."""


def _words(c: Controller) -> list[str]:
    """The words, computed only where they are asked for."""
    lines = ["        if say:"]
    for w in c.words.words:
        cases = "".join([f"{_code(x.condition)}, {x.value}, " for x in w.cases])
        lines.append(f"            {w.name} = self._first({cases}{w.otherwise})")
    lines.append("            return {")
    lines += [f"                {number}: {name}," for number, name in c.words.routes.items()]
    lines.append("            }")
    return lines


def _tables(c: Controller) -> list[str]:
    """What there is, by name, number and code."""
    causes, routes = stopped(c)
    return [
        "# name: (restrictive value, number of values), meaning",
        "INPUTS = {",
        *(f"    {i.name!r}: ({i.restrictive}, {i.size or 2}),  # {_plain(i.note)}" for i in c.inputs),
        "}",
        "# name: value at a restart; behind them the place to which they belong",
        "STATE = {",
        *_state(c),
        "}",
        "# name: time in milliseconds, meaning",
        "TIMERS = {",
        *(f"    {t.name!r}: {t.preset_ms},  # {_plain(t.note)}" for t in c.timers),
        "}",
        "# name: restrictive value, meaning",
        "OUTPUTS = {",
        *(f"    {o.name!r}: {o.restrictive},  # {_plain(o.note)}" for o in c.outputs),
        "}",
        "# name of a route: the number that asks for it",
        "ROUTES = {",
        *(f"    {name!r}: {number}," for name, number in route_numbers(c).items()),
        "}",
        "# number of a route: the timer that runs while it is being cancelled",
        "CANCELLED_AFTER = {",
        *(f"    {number}: {timer!r}," for number, timer in cancelled_after(c).items()),
        "}",
        "# code of a refusal: what tells that another route holds what was added to it, and the timer that runs while",
        "# it does so longer",
        "HELD_UNTIL = {",
        *(f"    {code}: {those!r}," for code, those in held_until(c).items()),
        "}",
        "# code of a refusal by a section behind a signal: the signal, what tells that something came in, and that it",
        "# went on, the timers of the release and of approach locking, the input that releases by hand",
        "LEFT = {",
        *(f"    {code}: {those!r}," for code, those in left(c).items()),
        "}",
        "# code of a refusal by a lock: what detects the section (or one in rear that is released first), what tells",
        "# that a route is set over it, what must be held, and what is said where it is occupied, none is and all are",
        "OCCUPIED = {",
        *(f"    {code}: {those!r}," for code, those in occupied(c).items()),
        "}",
        "# why a signal is at stop: what is wanted of variables, one of which would do, what is said, and the rule",
        "CAUSES = {",
        *(f"    {number}: {told!r}," for number, told in causes.items()),
        "}",
        "# number of a route: its causes in order, what tells that it is set, that its signal is wanted open, that it",
        "# has been, and what is said where it is not wanted any more after that, and before",
        "AT_STOP = {",
        *(f"    {number}: {those!r}," for number, those in routes.items()),
        "}",
        "# code: what a word says by it, and the rule behind it",
        "SAID = {",
        *(f"    {code}: ({_plain(text)!r}, {rule!r})," for code, (text, rule) in said(c).items()),
        "}",
    ]


def runtime_py(controller: Controller, header: Sequence[str]) -> str:
    """The text of the runtime."""
    c = controller
    lines = [f"# {_plain(h)}" for h in header]
    lines += [
        f'"""Interlocking {c.name}: call `Controller().scan(inputs, dt_ms)` once per cycle.',
        "",
        "Inputs and outputs are dictionaries of names; a missing input takes its restrictive value.  ROUTES has the",
        "number of each route by its name: `request(name)` asks for it, `status(name)` and `why_not(name)` tell of it.",
        '"""',
        "",
        *_families(c),
        "",
        *_tables(c),
        "",
        "",
        *FIXED.splitlines(),
    ]
    for names, held in ((c.inputs, "read.__getitem__, INPUTS"), (c.state, "self.state.__getitem__, STATE")):
        lines += ["        (", *_filled(" " * 12, [str(x.name) for x in names]), f"        ) = map({held})"]
    for step in c.steps:
        if isinstance(step, Equation):
            lines.append(_equation(step, step.name))
        else:
            lines.append(f"        {step.name} = self._timer({step.name!r}, {step.input}, dt_ms)")
    lines += [_equation(e, f"N_{e.name}") for e in c.next]
    lines += _words(c)
    kept = {s.name for s in c.state}
    lines += [
        "        self.state = dict(zip(STATE, map(bool, (",
        *_filled(" " * 12, [str(computed(s.name)) for s in c.state]),
        "        ))))",
        "        return {",
        *(f"            {o.name!r}: bool({_code(o.expr, kept=kept)})," for o in c.outputs),
        "        }",
    ]
    return "\n".join(lines) + "\n"
