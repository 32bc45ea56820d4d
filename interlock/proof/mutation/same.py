"""Whether nobody at the terminals can tell a mutant from the controller, whatever happens.

Both scan the same inputs side by side.  Of each state variable and each timer it is supposed that where the one has it
the other has it, and the reverse; what a scan does not keep is dropped, until the rest is kept (a greatest relation,
found as invariants are).  As long as no output is among what was dropped, all outputs are the same in every run, from
power-up on.  Before the restart delay is over nothing is known but the start values that every scan keeps; afterwards
the invariants of both hold.

**Theorem.**  If the initial states are related, and related states go under the same inputs to related states and show
the same outputs, then all runs show the same outputs.  (Bisimulation: Park, 1981; Milner, *Communication and
Concurrency*, 1989; as signal correspondence: van Eijk, 2000.)  That no such relation is found shows nothing.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from interlock.dataclass import dataclass
from interlock.logic.controller import Controller
from interlock.logic.expr import NOT, TRUE, VAR, Expr, Substitution, implies, neg, var, variables
from interlock.logic.names import Form, Name
from interlock.proof.mutation.lines import Lines
from interlock.proof.mutation.switched import Switched


@dataclass(frozen=True)
class Side:
    """A controller, the state variables of its system, the lines of that, and the invariants that it keeps."""

    controller: Controller
    state: Sequence[Name]
    lines: Lines
    invariants: Sequence[Expr]


def same(s: Switched, one: Side, other: Side, reads: Mapping[Name, frozenset[Name]]) -> str | None:
    """In what way a mutant (`other`) is the same as the controller (`one`); None where an output may differ.

    `reads`: what the controller's definitions read.
    """
    timers = {t.name: t for t in one.controller.timers}
    if {t.name: t.preset_ms for t in other.controller.timers} != {n: t.preset_ms for n, t in timers.items()}:
        return None
    if set(other.lines.assumptions) - set(one.lines.assumptions) - set(_on_delays(other.controller)):
        return None
    starts = {x.name: x.initial for x in one.controller.state}
    if starts.keys() != {x.name for x in other.controller.state}:
        return None
    dropped: set[tuple[Name, Name]] = set()
    others = {x.name for x in other.controller.state if x.initial is not starts[x.name]}
    if others:
        apart = {(a, b) for n in others for a, b in ((n, n.copy), (n.copy, n))}
        first = ([*_first(one)], [*_first(other)])
        while new := _lost(s, one, other, reads, apart, dropped, [first]):
            dropped |= new
    phases = [
        ([*one.lines.assumptions, *one.invariants], [*other.lines.assumptions, *other.invariants]),
        (_at_power_up(one), _at_power_up(other)),
    ]
    inside = _inside(one)
    while all(_plain(a) in inside for a, _ in dropped):
        new = _lost(s, one, other, reads, dropped, dropped, phases)
        if not new:
            return f"other only inside, in {len(dropped)} values" if dropped else "the same states and outputs"
        dropped |= new
    return None


def same_after_restart(s: Switched, one: Side, other: Side, reads: Mapping[Name, frozenset[Name]]) -> bool:
    """Whether in every step after the restart delay, from one state, both come to the same state and outputs."""
    timers = {t.name: t.preset_ms for t in one.controller.timers}
    if {t.name: t.preset_ms for t in other.controller.timers} != timers:
        return False
    known = ([*one.lines.assumptions, *one.invariants], [*other.lines.assumptions, *other.invariants])
    return not _lost(s, one, other, reads, set(), set(), [known])


Phase = tuple[Sequence[Expr], Sequence[Expr]]
"""What is known of the controller, and of the mutant, in a scan."""


def _first(side: Side) -> Iterator[Expr]:
    """What is known in the first scan after power-up."""
    yield from (var(x.name) if x.initial else neg(var(x.name)) for x in side.controller.state)
    yield from (neg(var(t.name)) for t in side.controller.timers)


def _plain(name: Name) -> Name:
    """The controller's own variable, of which the mutant's is a copy."""
    return name.base if name.form is Form.COPY else name


def _inside(one: Side) -> set[Name]:
    """What nobody sees: state of the controller, timers, what the proof remembers of runs."""
    names = {x.name for x in one.controller.state} | {t.name for t in one.controller.timers}
    return names | {n for n in one.state if n.family.history or n.form is Form.COVERED}


def _on_delays(c: Controller) -> Iterator[Expr]:
    """A timer is true only while its input is."""
    return (implies(var(t.name), var(t.input)) for t in c.timers)


def _lost(
    s: Switched,
    one: Side,
    other: Side,
    reads: Mapping[Name, frozenset[Name]],
    before: set[tuple[Name, Name]],
    dropped: set[tuple[Name, Name]],
    phases: Sequence[Phase],
) -> set[tuple[Name, Name]]:
    """Implications that a scan in one of the phases loses, if there are any.

    `before`: those that do not hold before the scan.  `dropped`: those of which nothing is asked after it.
    """
    free = {_plain(a) for a, _ in before}
    mine, its = one.lines.definitions, other.lines.definitions
    below: dict[Name, None] = {}
    apart = set(free)
    for n, x in its.items():  # in an order in which each reads only what is before it
        old = mine.get(n)
        names = reads[n] if old is x else frozenset(variables((x,)))
        if old is not x or not apart.isdisjoint(names):
            below[n] = None
            apart.add(n)
    put = Substitution({n: var(n.copy) for n in apart})
    goals: dict[tuple[Name, Name], Expr] = {}
    for n, (x, its_own) in _watched(one, other, below).items():
        y = put(its_own)
        for a, b, goal in ((n, n.copy, implies(x, y)), (n.copy, n, implies(y, x))):
            if (a, b) not in dropped and goal is not TRUE:
                goals[a, b] = goal
    if not goals:
        return set()
    known = [s.define(n, x) for n, x in mine.items()]
    known += [s.define(n.copy, put(its[n])) for n in below]
    for n in free:
        known += [s.fact(implies(var(a), var(b))) for a, b in ((n, n.copy), (n.copy, n)) if (a, b) not in before]
    for mine_too, its_too in phases:
        wrong = s.any_false(goals.values())
        model = s.model(*known, *map(s.fact, dict.fromkeys((*mine_too, *map(put, its_too)))), wrong)
        s.off(wrong)
        if model is not None:
            return {k for k, x in goals.items() if -s.cnf.literal(x) in model}
    return set()


def _watched(one: Side, other: Side, below: Mapping[Name, None]) -> dict[Name, tuple[Expr, Expr]]:
    """For each state variable and timer that may differ: its next value in both, or what it waits for in both."""
    found = {n: (var(n.next), var(n.next)) for n in one.state if n.next in below}
    inputs = {t.name: t.input for t in other.controller.timers}
    for t in one.controller.timers:
        if t.input != inputs[t.name] or t.input in below:
            found[t.name] = (var(t.input), var(inputs[t.name]))
    return found


def _at_power_up(side: Side) -> list[Expr]:
    """What is known in each scan before the restart delay is over."""
    kept = {x.name for x in side.controller.state} | {x.name for x in side.controller.outputs}
    values = [x for x in side.lines.start if (y := x.args[0] if x.op is NOT else x).op is VAR and y.name in kept]
    return [*values, neg(var(side.controller.symbols.start.restart_timer)), *_on_delays(side.controller)]


__all__ = ["Side", "same"]
