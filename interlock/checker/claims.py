"""Whether the written system assumes and claims what the specification asks for the layout, no more and no less.

Formulas are compared, not places: a place is a label.  A claim that is missing, weaker or about something else is one
that the specification asks for and the system has not; an assumption that the specification has not is refused.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping

from interlock.checker.formula import CLAUSES, FALSE, TRUE, Formula, clauses, every, names, no, some
from interlock.checker.moves import World
from interlock.checker.schema import instances, places
from interlock.checker.specification import Schemas, Specification, under
from interlock.checker.written import Written
from interlock.verify import need

Clause = frozenset[Formula]


def asked(schemas: Schemas, world: World) -> dict[str, set[Clause]]:
    """What the schemas say of a layout, clause by clause, by name; where nothing is to be said, nothing is."""
    found: dict[str, set[Clause]] = {}
    for s in schemas:
        of = found.setdefault(s["id"], set())
        for x in instances(s, world):
            of |= clauses(x)
    return found


def compare(world: World, spec: Specification, claims: Mapping[str, set[Clause]], w: Written) -> tuple[str, list[str]]:
    """What was compared, in words, and the names of claims that the specification has not.  claims: what it asks."""
    _sentences(spec, w)
    wanted_of_world = asked(spec.assumptions, world)
    _assumptions(wanted_of_world, w)
    theirs: dict[str, set[Clause]] = {}
    for id_, _, x in w.claims:
        theirs.setdefault(id_, set()).update(clauses(x))
    theirs["P-START"] = set(clauses(every(w.start)))  # of the initial states, and so a line of its own
    for id_, wanted in claims.items():
        _same("claim", id_, wanted, theirs.get(id_, set()))
    many = sum(map(len, claims.values()))
    told = sum(map(len, wanted_of_world.values()))
    said = f"{len([1 for x in claims.values() if x])} claims in {many} clauses, assumptions in {told}, as specified"
    return said, sorted(set(theirs) - set(claims))


def assumed(world: World, spec: Specification) -> list[str]:
    """The assumptions under which anything is said of this layout: those that are stated, and those that its world's
    moves are subject to."""
    found = {s["id"] for s in spec.assumptions if any(True for _ in instances(s, world))}
    for s in [*spec.moves, *spec.claims]:
        those = under(s)
        if those and any(True for _ in places(s, world)):
            found.update(those)
    return sorted(found)


def outputs_read(claims: Mapping[str, set[Clause]], outputs: Iterable[str]) -> None:
    """Everything at the terminals is the subject of some claim: else it could say anything."""
    said = (x for those in claims.values() for c in those for x in c)
    read = {n.removesuffix("'") for x in said for n in names(x)}
    unread = sorted(set(outputs) - read)
    need(not unread, f"no claim speaks of the output {unread[0] if unread else ''}")


def _sentences(spec: Specification, w: Written) -> None:
    """Under each name the certificate has the specification's own sentence."""
    for schemas, book in ((spec.assumptions, w.assumed), (spec.claims, w.sentences)):
        told = {s["id"]: s["sentence"] for s in schemas if "sentence" in s}
        for id_, sentence in told.items():
            need(book.get(id_, sentence) == sentence, f"{id_} has another sentence than the specification's")


def _assumptions(wanted: Mapping[str, set[Clause]], w: Written) -> None:
    """What is assumed is what the specification lists, each under its name and in the list."""
    theirs: dict[str, list[Formula]] = {}
    for id_, x in w.assumptions:
        need(id_ in wanted, f"{id_} is assumed, which the specification has not")
        need(id_ in w.assumed, f"{id_} is assumed, but not in the list of assumptions")
        theirs.setdefault(id_, []).append(_events(x, w))
    for id_, those in wanted.items():
        ours = {c for x in those for c in clauses(_events(some(x), w))}
        found = {c for x in theirs.get(id_, ()) for c in clauses(x)}
        _same("assumption", id_, ours, found)


def _events(x: Formula, w: Written) -> Formula:
    """What comes after a step is written out, as far as the world's definitions go, wherever it is named."""
    if x[0] == "v":
        name = x[1]
        world = name.endswith("'") and "." in name and not name.startswith(("cov.", "shut.", "been."))
        return w.definitions.get(name, x) if world else x
    if x[0] == "!":
        return no(_events(x[1], w))
    return every(_events(y, w) for y in x[1]) if x[0] == "&" else x


def _same(kind: str, id_: str, wanted: set[Clause], found: set[Clause]) -> None:
    """Whatever the one says, the other says, or more; so neither is weaker."""
    ours, theirs = missing(wanted, found), missing(found, wanted)
    lacks, more = ([words(some(c)) for c in those] for those in (ours, theirs))
    lacks.sort()
    more.sort()
    large = any("&" in (y[0], no(y)[0]) for c in (*ours, *theirs) for y in c)
    why = f"; one has over {CLAUSES} clauses and is compared as it stands, too large to tell" if large else ""
    instead = f"; it has {more[0]}" if more else ""
    need(not lacks, f"the {kind} {id_} lacks what the specification asks: {lacks[0] if lacks else ''}{instead}{why}")
    need(not more, f"the {kind} {id_} says more than the specification: {more[0] if more else ''}{why}")


def missing(wanted: Iterable[Clause], found: Collection[Clause]) -> list[Clause]:
    """The clauses that are not there, nor any that says more."""
    return [c for c in wanted if c not in found and not any(x <= c for x in found)]


def words(x: Formula, most: int = 160) -> str:
    """A formula for people, cut where it gets long."""

    def go(y: Formula) -> str:
        if y[0] == "v":
            return str(y[1])
        if y[0] == "!":
            inner = y[1]
            if inner[0] == "&":
                return "(" + " or ".join(sorted(go(no(z)) for z in inner[1])) + ")"
            return f"not {go(inner)}"
        if y[0] == "&":
            return "(" + " and ".join(sorted(map(go, y[1]))) + ")"
        return "TRUE" if y == TRUE else "FALSE" if y == FALSE else str(y)

    told = go(x)
    return told if len(told) <= most else told[:most] + " ..."
