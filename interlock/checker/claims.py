"""Whether the written system assumes and claims what the specification asks for the layout, no more and no less.

Formulas are compared, not places: a place is a label.  A claim that is missing, weaker or about something else is one
that the specification asks for and the system has not; an assumption that the specification has not is refused.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterable, Mapping

from interlock.checker.formula import CLAUSES, FALSE, TRUE, Formula, clauses, every, names, no, some
from interlock.checker.moves import World
from interlock.checker.schema import instances, places
from interlock.checker.specification import Schemas, Specification, under
from interlock.checker.written import Written
from interlock.verify import need

Clause = frozenset[Formula]


def asked(schemas: Schemas, world: World) -> dict[str, set[Formula]]:
    """What the schemas say of a layout, part by part, by name; where nothing is to be said, nothing is."""
    found: dict[str, set[Formula]] = {}
    for s in schemas:
        of = found.setdefault(s["id"], set())
        for x in instances(s, world):
            of |= parts(x)
    return found


def parts(x: Formula) -> frozenset[Formula]:
    """What a formula says one after the other: the operands of a conjunction, nothing of TRUE."""
    return frozenset() if x == TRUE else x[1] if x[0] == "&" else frozenset({x})


def compare(world: World, spec: Specification, claims: Mapping[str, set[Formula]], w: Written) -> tuple[str, list[str]]:
    """What was compared, in words, and the names of claims that the specification has not.  claims: what it asks."""
    _sentences(spec, w)
    wanted_of_world = asked(spec.assumptions, world)
    _assumptions(wanted_of_world, w)
    theirs: dict[str, set[Formula]] = {}
    for id_, _, x in w.claims:
        theirs.setdefault(id_, set()).update(parts(x))
    theirs["P-START"] = set(parts(every(w.start)))  # of the initial states, and so a line of its own
    for id_, wanted in claims.items():
        _same("claim", id_, wanted, theirs.get(id_, set()))
    many = sum(map(len, claims.values()))
    told = sum(map(len, wanted_of_world.values()))
    said = f"{len([1 for x in claims.values() if x])} claims in {many} formulas, assumptions in {told}, as specified"
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


def outputs_read(claims: Mapping[str, set[Formula]], outputs: Iterable[str]) -> None:
    """Everything at the terminals is the subject of some claim: else it could say anything."""
    read = {n.removesuffix("'") for those in claims.values() for x in those for n in names(x)}
    unread = sorted(set(outputs) - read)
    need(not unread, f"no claim speaks of the output {unread[0] if unread else ''}")


def _sentences(spec: Specification, w: Written) -> None:
    """Under each name the certificate has the specification's own sentence."""
    for schemas, book in ((spec.assumptions, w.assumed), (spec.claims, w.sentences)):
        told = {s["id"]: s["sentence"] for s in schemas if "sentence" in s}
        for id_, sentence in told.items():
            need(book.get(id_, sentence) == sentence, f"{id_} has another sentence than the specification's")


def _assumptions(wanted: Mapping[str, set[Formula]], w: Written) -> None:
    """What is assumed is what the specification lists, each under its name and in the list."""
    theirs: dict[str, set[Formula]] = {}
    for id_, x in w.assumptions:
        need(id_ in wanted, f"{id_} is assumed, which the specification has not")
        need(id_ in w.assumed, f"{id_} is assumed, but not in the list of assumptions")
        theirs.setdefault(id_, set()).update(parts(_events(x, w)))
    for id_, those in wanted.items():
        ours = {y for x in those for y in parts(_events(x, w))}
        _same("assumption", id_, ours, theirs.get(id_, set()))


def _events(x: Formula, w: Written) -> Formula:
    """What comes after a step is written out, as far as the world's definitions go, wherever it is named."""
    if x[0] == "v":
        name = x[1]
        world = name.endswith("'") and "." in name and not name.startswith(("cov.", "shut.", "been."))
        return w.definitions.get(name, x) if world else x
    if x[0] == "!":
        return no(_events(x[1], w))
    return every(_events(y, w) for y in x[1]) if x[0] == "&" else x


def _same(kind: str, id_: str, wanted: set[Formula], found: set[Formula]) -> None:
    """Whatever the one says, the other says, or more; so neither is weaker."""
    ours, theirs = unsaid(wanted, found), unsaid(found, wanted)
    lacks, more = ([words(some(c)) for c in those] for those in (ours, theirs))
    lacks.sort()
    more.sort()
    large = any("&" in (y[0], no(y)[0]) for c in (*ours, *theirs) for y in c)
    why = f"; one has over {CLAUSES} clauses and is compared as it stands, too large to tell" if large else ""
    instead = f"; it has {more[0]}" if more else ""
    need(not lacks, f"the {kind} {id_} lacks what the specification asks: {lacks[0] if lacks else ''}{instead}{why}")
    need(not more, f"the {kind} {id_} says more than the specification: {more[0] if more else ''}{why}")


def unsaid(wanted: set[Formula], found: set[Formula]) -> list[Clause]:
    """The clauses that are said here and not there.  A formula that stands in both need not be taken apart: of its
    clauses each would be the same; the others are looked for among each other first."""
    left = [c for x in wanted - found for c in clauses(x)]
    for those in (found - wanted, found):
        left = missing(left, {c for x in those for c in clauses(x)}) if left else []
    return left


def missing(wanted: Iterable[Clause], found: Collection[Clause]) -> list[Clause]:
    """The clauses that are not there, nor any that says more."""
    left = [c for c in wanted if c not in found]
    if not left or frozenset() in found:
        return []
    often = Counter(y for x in found for y in x)
    by_rarest: dict[Formula, list[Clause]] = {}  # what says more than a clause has each of its literals in it
    for x in found:
        by_rarest.setdefault(min(x, key=often.__getitem__), []).append(x)
    return [c for c in left if not any(x <= c for y in c for x in by_rarest.get(y, ()))]


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
