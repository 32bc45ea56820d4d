"""Controllers that are wrong as a class: what a simulator worth its name must turn into an accident.

Each weakening is made on the controller, wherever it applies; the runtime is then emitted from it.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace

from interlock.logic.controller import Controller, Equation, Step, Term, Timer
from interlock.logic.expr import FALSE, TRUE, Expr, Substitution, disj, var

Change = Callable[[Equation], Equation]


def _changed(c: Controller, change: Change) -> Controller:
    steps: list[Step] = [change(s) if isinstance(s, Equation) else s for s in c.steps]
    outputs, plain = c.outputs, replace(c, outputs=())
    following = tuple(change(e) for e in plain.next)
    return replace(plain, steps=tuple(steps), next=following).with_outputs(outputs)


def _is(e: Equation, *prefixes: str) -> bool:
    return e.name.split("_", 1)[0] in prefixes


def _constant(value: Expr, *prefixes: str) -> Callable[[Controller], Controller]:
    """Wires of these families have a constant value."""
    return lambda c: _changed(c, lambda e: replace(e, terms=(Term(value, "wrong"),)) if _is(e, *prefixes) else e)


def _read_as(values: Callable[[Controller], Mapping[str, Expr]], *prefixes: str) -> Callable[[Controller], Controller]:
    """Equations of these families (all where none is named) read some names as constants."""

    def weaken(c: Controller) -> Controller:
        put = Substitution(dict(values(c)))

        def change(e: Equation) -> Equation:
            if prefixes and not _is(e, *prefixes):
                return e
            return replace(e, terms=tuple(replace(t, expr=put(t.expr)) for t in e.terms))

        return _changed(c, change)

    return weaken


def _wires(c: Controller, prefix: str, value: Expr) -> dict[str, Expr]:
    return {s.name: value for s in c.steps if s.name.startswith(prefix)}


def _early_release(c: Controller) -> Controller:
    """A section is released behind a train as soon as one has come in, occupied or not."""

    def change(e: Equation) -> Equation:
        if not _is(e, "BT"):
            return e
        section = e.name.split("_", 1)[1]
        return replace(e, terms=(Term(var(f"U_{section}"), "used"), Term(var("RST"), "not at a restart")))

    return _changed(c, change)


def _no_delay(c: Controller) -> Controller:
    """Delays of cancellation are over at once."""
    steps = tuple(replace(s, preset_ms=0) if isinstance(s, Timer) and s.name.startswith("AT_") else s for s in c.steps)
    outputs = c.outputs
    return replace(replace(c, outputs=()), steps=steps).with_outputs(outputs)


def _stays_open(c: Controller) -> Controller:
    """Proceed, once shown, is not taken back: not by a train that passes, nor by what is lost."""

    def change(e: Equation) -> Equation:
        if not _is(e, "S"):
            return e
        return replace(e, terms=(Term(disj((e.expr, var(e.name))), "stays"),))

    return _changed(c, change)


WEAKENED: dict[str, tuple[str, Callable[[Controller], Controller]]] = {
    "locks ignored": (
        "every section counts as free of locks",
        _constant(TRUE, "FREE"),
    ),
    "detection ignored": (
        "no section counts as occupied",
        _constant(FALSE, "OCC"),
    ),
    "early release": ("a section is released as soon as a train has come into it", _early_release),
    "ungated grant": (
        "a route is granted whatever is locked, occupied or wanted otherwise",
        _read_as(lambda c: _wires(c, "WF_", TRUE), "G"),
    ),
    "points moved while locked": ("a machine always counts as free to move", _constant(TRUE, "MOV")),
    "cancel without delay": ("the approach locking delay is over at once", _no_delay),
    "signal not closed": ("a signal that shows proceed goes on showing it", _stays_open),
}
"""Name: what is wrong, and how a controller is made so."""
