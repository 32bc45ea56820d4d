"""Controllers that are wrong as a class: what a simulator worth its name must turn into an accident.

Each weakening is made on the controller, wherever it applies; the runtime is then emitted from it.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace

from interlock.logic.controller import Controller, Equation, Join, Output, Step, Term, Timer
from interlock.logic.expr import FALSE, TRUE, Expr, Substitution, disj, var
from interlock.model.portable import portable

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
            return replace(e, terms=tuple(t._replace(expr=put(t.expr)) for t in e.terms))

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


def _presets(prefix: str, milliseconds: int) -> Callable[[Controller], Controller]:
    """Timers whose names begin so have another preset."""

    def weaken(c: Controller) -> Controller:
        def change(s: Step) -> Step:
            timed = isinstance(s, Timer) and s.name.startswith(prefix)
            return replace(s, preset_ms=milliseconds) if isinstance(s, Timer) and timed else s

        return _steps(c, change)

    return weaken


def _steps(c: Controller, change: Callable[[Step], Step]) -> Controller:
    outputs = c.outputs
    return replace(replace(c, outputs=()), steps=tuple(map(change, c.steps))).with_outputs(outputs)


def _from_setting(c: Controller) -> Controller:
    """The approach locking delay of a signal runs from the setting of its route, not from its cancellation."""
    names = {portable(str(g)): disj(var(r.active) for r in routes) for g, routes in c.symbols.routes.of_signal.items()}

    def change(e: Equation) -> Equation:
        if not _is(e, "ATI"):
            return e
        return replace(e, join=Join.ANY, terms=(Term(disj((e.expr, names[e.name[4:]])), "set"),))

    return _changed(c, change)


def _outputs(change: Callable[[str], str | None]) -> Callable[[Controller], Controller]:
    """Outputs show what belongs to others: `change` names the other one, or nothing where it stays."""

    def weaken(c: Controller) -> Controller:
        known = {o.name: o.expr for o in c.outputs}
        other = {o.name: change(o.name) for o in c.outputs}
        return c.with_outputs(tuple(replace(o, expr=known.get(other[o.name] or "", o.expr)) for o in c.outputs))

    return weaken


def _shows(values: Mapping[str, Expr]) -> Callable[[Controller], Controller]:
    """Outputs of these families have a constant value."""

    def weaken(c: Controller) -> Controller:
        return c.with_outputs(tuple(replace(o, expr=values.get(o.name.split("_", 1)[0], o.expr)) for o in c.outputs))

    return weaken


def _lamps_of_neighbours(c: Controller) -> Controller:
    """Every signal has the lamps of the next one in the list."""
    names = sorted(o.name[3:] for o in c.outputs if o.name.startswith("YS_"))
    after = dict(zip(names, [*names[1:], names[0]], strict=True))
    lamps = ("YS", "YP", "YY", "YO", "YW")
    return _outputs(lambda n: f"{n[:3]}{after[n[3:]]}" if n[:2] in lamps and n[3:] in after else None)(c)


def _clear_always(c: Controller) -> Controller:
    """Every main signal that is open shows clear, whatever the next one shows."""
    known = {o.name: o.expr for o in c.outputs}

    def change(o: Output) -> Output:
        if o.name.startswith("YP_"):
            return replace(o, expr=disj((o.expr, known.get("YY_" + o.name[3:], FALSE))))
        return replace(o, expr=FALSE) if o.name.startswith("YY_") else o

    return c.with_outputs(tuple(map(change, c.outputs)))


def _inputs(value: Expr, *prefixes: str) -> Callable[[Controller], Controller]:
    """Inputs of these families are read as a constant."""
    return _read_as(lambda c: {i.name: value for i in c.inputs if i.name.startswith(prefixes)})


def _devices_closed(c: Controller) -> Controller:
    """Crossings and bridges count as closed."""
    outputs = {o.name for o in c.outputs}
    devices = [
        n[3:] for n in outputs if n.startswith("YN_") and "YT_" + n[3:] not in outputs
    ]  # never trailed: no points
    return _read_as(lambda _: {f"QR_{n}": TRUE for n in devices})(c)


def _mirrored(c: Controller) -> Controller:
    """Drives and contacts are exchanged.  Drives alone do no harm: the point is not detected where it is commanded."""
    driven = _outputs(lambda n: {"YN": "YR", "YR": "YN"}[n[:2]] + n[2:] if n[:3] in ("YN_", "YR_") else None)(c)
    contacts = [i.name for i in c.inputs if i.name.startswith(("DN_", "DR_"))]
    return _read_as(lambda _: {n: var(f"D{'R' if n[1] == 'N' else 'N'}{n[2:]}") for n in contacts})(driven)


def _overlap_ignored(c: Controller) -> Controller:
    """An overlap counts as in order, is granted whatever it finds, and held by nothing."""
    wires = _changed(c, lambda e: replace(e, terms=(Term(TRUE, "wrong"),)) if _is(e, "OL", "OF", "OR") else e)
    return _changed(wires, lambda e: replace(e, terms=(Term(FALSE, "wrong"),)) if _is(e, "V") else e)


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
    "cancel without delay": ("the approach locking delay is over at once", _presets("AT_", 0)),
    "signal not closed": ("a signal that shows proceed goes on showing it", _stays_open),
    "points wired the wrong way round": ("every machine is driven, and detected, the other way", _mirrored),
    "lamps swapped": ("every signal has the lamps of another one", _lamps_of_neighbours),
    "all signals clear": ("every signal shows clear and no stop", _shows({"YP": TRUE, "YY": FALSE, "YS": FALSE})),
    "stop beside proceed": ("stop stays lit at every signal", _shows({"YS": TRUE})),
    "driven both ways": ("both drives of every machine are on", _shows({"YN": TRUE, "YR": TRUE})),
    "clear before stop": ("an open signal shows clear, whatever the next one shows", _clear_always),
    "delay from setting": ("the approach locking delay counts from the setting of the route", _from_setting),
    "delay always running": ("the approach locking delay counts all the time", _constant(TRUE, "ATI")),
    "presets of a millisecond": ("every delay is a millisecond", _presets("", 1)),
    "one clear reading": ("a section is released on a single clear reading", _presets("RT_", 0)),
    "restart without delay": ("after a restart sections are released at once", _presets("RST", 0)),
    "overlap ignored": ("overlaps are neither looked at nor held", _overlap_ignored),
    "points not detected": ("every point counts as detected in either position", _constant(TRUE, "QN", "QR")),
    "trailing forgotten": ("no point counts as trailed", _constant(FALSE, "TR")),
    "blocks ignored": ("no section counts as blocked", _inputs(FALSE, "BLK_")),
    "conditions ignored": ("every external condition counts as fulfilled", _inputs(TRUE, "E_")),
    "lost inputs ignored": ("inputs count as valid when they are lost", _inputs(TRUE, "VALID")),
    "health ignored": ("every detector counts as healthy", _inputs(TRUE, "SH_")),
    "devices count as closed": ("crossings and bridges count as closed", _devices_closed),
    "zone never full": ("a zone takes any number of trains", _constant(FALSE, "ZB1", "ZB2", "ZB3", "ZB4", "ZB5")),
    "direction always given": ("the neighbour is always told that he has the direction", _shows({"YTG": TRUE})),
}
"""Name: what is wrong, and how a controller is made so."""
