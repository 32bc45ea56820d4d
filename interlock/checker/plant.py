"""Whether the written system's world moves as the specification says: events, next values and initial states.

Every definition that the text does not make must be one of the specification's, and the other way round; of the initial
states the system may say less, never more.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from interlock.checker.claims import missing, words
from interlock.checker.formula import FALSE, Formula, clauses, every, leaf, names, no
from interlock.checker.moves import World
from interlock.checker.scan import PRIME, Scan
from interlock.checker.schema import instances, places
from interlock.checker.specification import Schemas, Specification
from interlock.checker.written import Written
from interlock.verify import need


def define(world: World, spec: Specification) -> dict[str, Formula]:
    """The events and next values that the specification defines for a layout; the events become words of the world.
    Raises Rejected where two elements would share one: a layout in which two have the same name is none.
    """
    world.meanings = dict(spec.words)
    wanted: dict[str, Formula] = {}
    for name, x in _defined(spec.events, world):
        need(name not in wanted, f"two elements of the layout have the same name: {name} would be defined twice")
        world.events[name] = x
        wanted[name] = x
    for name, x in _defined(spec.next, world):
        need(
            name + PRIME not in wanted, f"two elements of the layout have the same name: {name} would be defined twice"
        )
        wanted[name + PRIME] = x
    return {name: x for name, x in wanted.items() if name.endswith(PRIME) or x != FALSE}


def compare(world: World, spec: Specification, wanted: Mapping[str, Formula], w: Written, text: Scan) -> str:
    """What was compared, in words; raises Rejected at the first difference."""
    theirs = {n: x for n, x in w.definitions.items() if n not in text.definitions}
    for name in sorted(wanted.keys() | theirs.keys()):
        need(name in theirs, f"the written system lacks {name}, which the specification defines")
        need(name in wanted, f"the written system defines {name}, of which the specification knows nothing")
        same = _alike(wanted[name], theirs[name], wanted)
        need(same, f"{name} is specified as {words(wanted[name])}; as written it is {words(theirs[name])}")
    known = {c for s in spec.initial for x in instances({**s, "must": s["says"]}, world) for c in clauses(x)}
    told = [x for x in w.initial if text.initial.keys().isdisjoint(names(x))]
    for x in told:
        need(not missing(clauses(x), known), f"the initial states are narrower than specified: {words(x)}")
    return f"{len(wanted)} events and next values of the world, {len(told)} initial conditions as specified"


def _alike(x: Formula, y: Formula, events: Mapping[str, Formula]) -> bool:
    """Whether two definitions say the same: a written one may name an event or write out what it is."""
    if x == y:
        return True
    x, y = _written_out(x, events), _written_out(y, events)
    return x == y or clauses(x) == clauses(y)


def _written_out(x: Formula, events: Mapping[str, Formula]) -> Formula:
    """A formula with events written out; they are defined without circle."""
    if x[0] == "v":
        event = events.get(x[1])
        return x if event is None or x[1].endswith(PRIME) else _written_out(event, events)
    if x[0] == "!":
        return no(_written_out(x[1], events))
    return every(_written_out(y, events) for y in x[1]) if x[0] == "&" else x


def _defined(schemas: Schemas, world: World) -> Iterator[tuple[str, Formula]]:
    for s in schemas:
        for at in places(s, world):
            name = str(s["name"]).format(**at)
            (x,) = instances({"must": s["says"]}, world, at)
            yield name, every((x, leaf(f"?{name}"))) if s.get("free") else x
