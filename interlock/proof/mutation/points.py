"""The point mutations of a controller: every equation, operand, output, timer and initial value, one change at a time.

Of an equation, and of an output: it is true, false, or negated; each of its operands, however deep, is dropped or
negated; it changes places with the next one of its family.  Of a timer: its input is true, false, negated, or that of
the next timer; its preset is one millisecond, or half.  Of the state: each initial value is the other one.  A change
that leaves an expression what it was is none.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import partial

from interlock.dataclass import dataclass
from interlock.logic.controller import Controller, Equation, Join, StateVar, Step, Term, Timer
from interlock.logic.expr import AND, FALSE, NOT, TRUE, VAR, Expr, conj, disj, neg, text, var
from interlock.logic.names import Name, spelled

Words = tuple[str | Expr, ...]
"""What is said of a change: words, names, and expressions."""


@dataclass(frozen=True, slots=True)
class Mutation:
    """One change.

    family: what kind of value is changed: where it is, and what the names of its kind begin with.  form: how it is
    changed.  words: what is changed, and how.  make: the controller with the change; MalformedController where
    the changed controller would read a value before it is computed.
    """

    family: str
    form: str
    words: Words
    make: Callable[[], Controller]
    again: int = 1
    """The same words may be said of several places; they are numbered."""
    alike: str = ""
    """What many have in common, where the words do not say it."""

    @property
    def name(self) -> str:
        """The words as text."""
        said = "".join(w if isinstance(w, str) else text(w) for w in self.words)
        return said if self.again == 1 else f"{said} ({self.again})"

    @property
    def shape(self) -> str:
        """The words without names of elements and numbers: what many mutants have in common."""
        return self.alike or "".join(
            w.sort if isinstance(w, Name) else w if isinstance(w, str) else _shape(w) for w in self.words
        )


def _shape(x: Expr) -> str:
    return text(x, lambda y: y.name.sort if y.op is VAR else f"{y.name.sort} = n")


def mutations(c: Controller) -> Iterator[Mutation]:
    """All of them, in the order of the controller; no two of a family have one name."""
    met: Counter[tuple[str, str]] = Counter()
    for m in _all(c):
        met[m.family, m.name] += 1
        again = met[m.family, m.name]
        yield m if again == 1 else replace(m, again=again)  # the same operand in another place


def _all(c: Controller) -> Iterator[Mutation]:
    wires = {s.name: s.expr for s in c.steps if isinstance(s, Equation)}
    for where, those in (("", wires), ("next ", {e.name: e.expr for e in c.next})):
        for name, form, words, put in _of_values(those):
            kind = f"{where}{name.sort}"
            yield Mutation(kind, form, (where, name, " ", *words), partial(with_values, c, where != "", put))
    for name, form, words, put in _of_values({o.name: o.expr for o in c.outputs}):
        yield Mutation(f"output {name.sort}", form, (name, " ", *words), partial(with_outputs, c, put))
    yield from _of_timers(c)
    for i, s in enumerate(c.state):
        state = (*c.state[:i], replace(s, initial=not s.initial), *c.state[i + 1 :])
        yield Mutation(
            f"initial {s.name.sort}", "negated", ("initial ", s.name, " negated"), partial(_with_state, c, state)
        )


Change = tuple[Name, str, Words, Mapping[Name, Expr]]
"""The name that is changed, the form of the change, the change in words, and the changed values by name."""


def _of_values(values: Mapping[Name, Expr]) -> Iterator[Change]:
    """The changes of named expressions."""
    after = following(list(values))
    for name, x in values.items():
        seen: set[Expr] = {x}
        for form, words, new in (
            ("true", ("true",), TRUE),
            ("false", ("false",), FALSE),
            ("negated", ("negated",), neg(x)),
            *_operands(x),
        ):
            if new not in seen:
                seen.add(new)
                yield name, form, words, {name: new}
        other = after.get(name)
        if other is not None and values[other] is not x:
            yield name, "exchanged", ("exchanged with ", other), {name: values[other], other: x}


def _operands(x: Expr) -> Iterator[tuple[str, Words, Expr]]:
    """The expression without one of its operands, or with one negated, however deep."""
    if x.op is NOT:
        yield from ((form, words, neg(y)) for form, words, y in _operands(x.args[0]))
        return
    joined = conj if x.op is AND else disj
    for i, a in enumerate(x.args):
        before, behind = x.args[:i], x.args[i + 1 :]
        yield "operand dropped", ("without ", a), joined((*before, *behind))
        yield "operand negated", ("with ", a, " negated"), joined((*before, neg(a), *behind))
        yield from ((form, words, joined((*before, y, *behind))) for form, words, y in _operands(a))


def _of_timers(c: Controller) -> Iterator[Mutation]:
    timers = {t.name: t for t in c.timers}
    after = following(list(timers))
    for t in c.timers:
        kind = f"timer {t.name.sort}"
        inputs = [("input true", TRUE), ("input false", FALSE), ("input negated", neg(var(t.input)))]
        for form, x in inputs:
            yield Mutation(kind, form, (t.name, f" {form}"), partial(_with_input, c, t, x))
        other = after.get(t.name)
        if other is not None:
            words = (t.name, " with the input of ", other)
            yield Mutation(kind, "input exchanged", words, partial(_with_input, c, t, var(timers[other].input)))
        for form, preset in (("preset 1 ms", 1), ("preset halved", t.preset_ms // 2)):
            if 0 < preset < t.preset_ms:
                new = replace(t, preset_ms=preset)
                yield Mutation(kind, form, (t.name, f" {form}"), partial(_with_step, c, t, (new,)))


def following(names: Sequence[Name]) -> dict[Name, Name]:
    """The next name of the family, after each; after the last the first, if there are more; where a family has one
    name only, the next name of all."""
    families: dict[str, list[Name]] = {}
    for n in names:
        families.setdefault(n.sort, []).append(n)
    found: dict[Name, Name] = {}
    for i, n in enumerate(names):
        those = families[n.sort]
        ring = those if len(those) > 1 else names
        k = those.index(n) if len(those) > 1 else i
        other = ring[(k + 1) % len(ring)]
        if other != n:
            found[n] = other
    return found


def _new(e: Equation, x: Expr) -> Equation:
    return replace(e, join=Join.ALL, terms=(Term(x, "changed"),))


def with_values(c: Controller, later: bool, put: Mapping[Name, Expr]) -> Controller:
    """The controller with other expressions for some wires, or next values."""
    if later:
        return replace(c, next=tuple(_new(e, put[e.name]) if e.name in put else e for e in c.next))
    steps = (_new(s, put[s.name]) if isinstance(s, Equation) and s.name in put else s for s in c.steps)
    return replace(c, steps=tuple(steps))


def with_outputs(c: Controller, put: Mapping[Name, Expr]) -> Controller:
    """The controller with other expressions for some outputs."""
    return c.with_outputs(tuple(replace(o, expr=put.get(o.name, o.expr)) for o in c.outputs))


def _with_state(c: Controller, state: tuple[StateVar, ...]) -> Controller:
    return replace(c, state=state, outputs=()).with_outputs(c.outputs)


def _with_step(c: Controller, old: Step, new: tuple[Step, ...]) -> Controller:
    return replace(c, steps=tuple(x for s in c.steps for x in (new if s is old else (s,))))


def _with_input(c: Controller, t: Timer, x: Expr) -> Controller:
    """A timer that reads another value: by a wire of its own."""
    wire = Equation(spelled(f"{t.input}_{t.name}"), Join.ALL, (Term(x, "changed"),), "changed")
    return _with_step(c, t, (wire, replace(t, input=wire.name)))
