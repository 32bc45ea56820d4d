"""Whether the written system assumes and claims what the specification asks for the layout, no more and no less.

Formulas are compared, not places: a place is a label.  A claim that is missing, weaker or about something else is one
that the specification asks for and the system has not; an assumption that the specification has not is refused.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any

import yaml

from interlock.checker.formula import FALSE, TRUE, Formula, every, names, no
from interlock.checker.moves import World
from interlock.checker.schema import instances
from interlock.checker.written import Written
from interlock.verify import Rejected, need

SPECIFICATION = Path(__file__).parent.parent / "spec" / "claims.yaml"


def specification() -> Mapping[str, Sequence[Mapping[str, Any]]]:
    """The schemas, as data."""
    body: Mapping[str, Sequence[Mapping[str, Any]]] = yaml.safe_load(SPECIFICATION.read_text("utf-8"))
    return body


def asked(schemas: Sequence[Mapping[str, Any]], world: World) -> dict[str, list[Formula]]:
    """What the schemas say of a layout, by name; where nothing is to be said, nothing is."""
    found: dict[str, list[Formula]] = {}
    for s in schemas:
        found.setdefault(s["id"], []).extend(x for x in instances(s, world) if x != TRUE)
    return found


def compare(world: World, w: Written) -> tuple[str, list[str]]:
    """What was compared, in words, and the names of claims that the specification has not."""
    spec = specification()
    _sentences(spec, w)
    assumed = asked(spec["assumptions"], world)
    _assumptions(assumed, w)
    claims = asked(spec["claims"], world)
    theirs: dict[str, list[Formula]] = {}
    for id_, _, x in w.claims:
        theirs.setdefault(id_, []).append(x)
    theirs["P-START"] = [every(w.start)]  # of the initial states, and so a line of its own
    for id_, wanted in claims.items():
        _equal("claim", id_, wanted, theirs.get(id_, []))
    places = sum(map(len, claims.values()))
    told = sum(map(len, assumed.values()))
    said = f"{len([1 for x in claims.values() if x])} claims at {places} places, {told} assumptions as specified"
    return said, sorted(set(theirs) - set(claims))


def outputs_read(world: World, outputs: Iterable[str]) -> None:
    """Everything at the terminals is the subject of some claim: else it could say anything."""
    read = {
        n.removesuffix("'")
        for those in asked(specification()["claims"], world).values()
        for x in those
        for n in names(x)
    }
    unread = sorted(set(outputs) - read)
    need(not unread, f"no claim speaks of the output {unread[0] if unread else ''}")


def _sentences(spec: Mapping[str, Sequence[Mapping[str, Any]]], w: Written) -> None:
    """Under each name the certificate has the specification's own sentence."""
    for part, book in (("assumptions", w.assumed), ("claims", w.sentences)):
        told = {s["id"]: s["sentence"] for s in spec[part] if "sentence" in s}
        for id_, sentence in told.items():
            need(book.get(id_, sentence) == sentence, f"{id_} has another sentence than the specification's")


def _assumptions(wanted: Mapping[str, list[Formula]], w: Written) -> None:
    """What is assumed is what the specification lists, each under its name and in the list."""
    theirs: dict[str, list[Formula]] = {}
    for id_, x in w.assumptions:
        need(id_ in wanted, f"{id_} is assumed, which the specification has not")
        need(id_ in w.assumed, f"{id_} is assumed, but not in the list of assumptions")
        theirs.setdefault(id_, []).append(_events(x, w))
    for id_, those in wanted.items():
        _equal("assumption", id_, [_events(x, w) for x in those], theirs.get(id_, []))


def _events(x: Formula, w: Written) -> Formula:
    """What comes after a step is written out, as far as the world's definitions go, wherever it is named."""
    if x[0] == "v":
        name = x[1]
        world = name.endswith("'") and "." in name and not name.startswith(("cov.", "shut.", "been."))
        return w.definitions.get(name, x) if world else x
    if x[0] == "!":
        return no(_events(x[1], w))
    return every(_events(y, w) for y in x[1]) if x[0] == "&" else x


def _equal(kind: str, id_: str, wanted: Sequence[Formula], found: Sequence[Formula]) -> None:
    missing = Counter(wanted) - Counter(found)
    if missing:
        one = next(iter(missing))
        other = next(iter(Counter(found) - Counter(wanted)), None)
        instead = "" if other is None else f"; it has {words(other)}"
        raise Rejected(f"the {kind} {id_} lacks what the specification asks: {words(one)}{instead}")
    extra = [x for x in Counter(found) - Counter(wanted) if x != TRUE]
    if extra and kind == "assumption":
        raise Rejected(f"the assumption {id_} says more than the specification: {words(extra[0])}")


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
