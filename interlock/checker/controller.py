"""Whether a certificate's written system says what the emitted text says: wires, next values, outputs, initial values,
timers and ranges, each by its name.

Then the refutations, which speak of the written system, speak of this text.
"""

from __future__ import annotations

from collections.abc import Iterable

from interlock.checker.formula import Formula, every, implies, leaf, names, no, same, value
from interlock.checker.scan import PRIME, Scan
from interlock.checker.written import Written
from interlock.verify import Rejected, need

RESTART_DELAY = "RST"
"""The timer that is false until the restart delay is over."""


def compare(text: Scan, w: Written) -> str:
    """What was compared, in words; raises Rejected at the first difference."""
    for name, x in text.definitions.items():
        need(name in w.definitions, f"the text computes {name}, of which the written system knows nothing")
        need(w.definitions[name] == x, f"the text computes {_said(name)} otherwise than the written system")
    _names(text, w)
    _timers(text, w)
    _ranges(text, w)
    _initial(text, w)
    _kept(text, w)
    presets = len(text.timers)
    said = f", {len(text.words)} words that nothing reads" if text.words else ""
    return f"{len(text.definitions)} equations, {len(text.initial)} initial values, {presets} timers with presets{said}"


def _said(name: str) -> str:
    return f"the next value of {name[:-1]}" if name.endswith(PRIME) else name


def _names(text: Scan, w: Written) -> None:
    """What the text computes, nobody else defines; what it is given, nobody defines at all."""
    free, state = [*text.inputs, *text.timers], frozenset(w.state)
    for name in free:
        taken = name in w.definitions or name in state or f"{name}{PRIME}" in w.definitions
        need(not taken, f"the written system defines {name}, which is an input or timer of the text")
    for name in (*text.outputs, *text.initial):
        need(name in state, f"{name} of the text is no state of the written system")
        need(f"{name}{PRIME}" in text.definitions, f"the text never computes {name}")


def _timers(text: Scan, w: Written) -> None:
    """The same inputs and presets; and of a timer nothing but A-TON is assumed that is not told by its name."""
    for name in sorted({*text.timers, *w.timers}):
        ours, theirs = text.timers.get(name), w.timers.get(name)
        if ours is None or theirs is None:
            raise Rejected(f"the timer {name} is only in the {'text' if theirs is None else 'written system'}")
        need(ours[0] == theirs[0], f"the timer {name} waits for {ours[0]} in the text, for {theirs[0]} as written")
        need(ours[1] == theirs[1], f"the timer {name} has {ours[1]} ms in the text, {theirs[1]} ms as written")
        need(ours[1] > 0, f"the timer {name} has no delay")
    told = [x for id_, x in w.assumptions if id_ == "A-TON"]
    wanted = [implies(leaf(name), leaf(source)) for name, (source, _) in text.timers.items()]
    need(set(told) == set(wanted), "A-TON is assumed of other timers, or of other inputs")


def _ranges(text: Scan, w: Written) -> None:
    numbers = {name for name, type_ in text.inputs.items() if type_ == "INT"}
    need(set(w.ranges) == numbers, "the inputs that are numbers are others in the text")


def _literals(text: Scan, parts: Iterable[Formula]) -> dict[str, bool]:
    """The controller's variables that have one value in every initial state."""
    found: dict[str, bool] = {}
    for x in parts:
        inner = x[1] if x[0] == "!" else x
        if inner[0] == "v" and inner[1] in text.initial:
            need(found.setdefault(inner[1], x[0] == "v") is (x[0] == "v"), "the initial states contradict each other")
    return found


def _initial(text: Scan, w: Written) -> None:
    """The text's start is an initial state: what is said there of the controller is true of it."""
    for x in w.initial:
        about = set(names(x))
        if about <= text.initial.keys():
            need(value(x, text.initial) is True, f"the text starts otherwise than written: {min(about)}")
        else:  # each condition is of the controller or of the world, so that neither narrows the other
            need(about.isdisjoint(text.initial), f"an initial condition ties {min(about)} to the world")


def _kept(text: Scan, w: Written) -> None:
    """Until the restart delay is over every scan keeps what is said of the controller, whatever its inputs are: so the
    written initial states hold all in which it can be when the delay ends, too."""
    start = _literals(text, w.initial)
    known = {**start, RESTART_DELAY: False}
    need(RESTART_DELAY in text.timers, "the text has no restart delay")
    waiting = {source: name for name, (source, _) in text.timers.items()}
    for name, (source, _) in text.timers.items():
        if known.get(source) is False:
            known[name] = False
    for name, x in text.definitions.items():
        found = value(x, known)
        if found is not None:
            known[name] = found
            if not found and name in waiting:
                known[waiting[name]] = False
    for name, wanted in start.items():
        kept = known.get(name + PRIME) is wanted
        need(kept, f"{name} may change before the restart delay is over, but has one value as written")
    tied = [x for x in w.initial if set(names(x)) <= text.initial.keys() and (x[1] if x[0] == "!" else x)[0] != "v"]
    shown = {same(leaf(y), _before(text.definitions[y + PRIME])) for y in text.outputs}
    need(all(x in shown for x in tied), "an initial condition of the controller is kept by no scan")


def _before(x: Formula) -> Formula:
    """What an output shows, in terms of the state that it shows."""
    if x[0] == "v":
        return leaf(x[1].removesuffix(PRIME))
    if x[0] == "!":
        return no(_before(x[1]))
    return every(_before(y) for y in x[1]) if x[0] == "&" else x
