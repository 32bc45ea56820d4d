"""Whether the written system's world moves as the specification says: events, next values and initial states.

Every definition that the text does not make must be one of the specification's, and the other way round; of the initial
states the system may say less, never more.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

import yaml

from interlock.checker.claims import words
from interlock.checker.formula import Formula, every, leaf, names, no
from interlock.checker.moves import World
from interlock.checker.scan import PRIME, Scan
from interlock.checker.schema import instances, places
from interlock.checker.written import Written
from interlock.verify import need

SPECIFICATION = Path(__file__).parent.parent / "spec" / "plant.yaml"


def compare(world: World, w: Written, text: Scan) -> str:
    """What was compared, in words; raises Rejected at the first difference."""
    spec: Mapping[str, Sequence[Mapping[str, Any]]] = yaml.safe_load(SPECIFICATION.read_text("utf-8"))
    wanted = dict(_defined(spec["events"], world, ""))
    wanted |= dict(_defined(spec["next"], world, PRIME))
    theirs = {n: x for n, x in w.definitions.items() if n not in text.definitions}
    for name in sorted(wanted.keys() | theirs.keys()):
        need(name in theirs, f"the written system lacks {name}, which the specification defines")
        need(name in wanted, f"the written system defines {name}, of which the specification knows nothing")
        same = _written_out(wanted[name], wanted) == _written_out(theirs[name], wanted)
        need(same, f"{name} is specified as {words(wanted[name])}; as written it is {words(theirs[name])}")
    known = {x for s in spec["initial"] for x in instances({**s, "must": s["says"]}, world)}
    told = [x for x in w.initial if not set(names(x)) & set(text.initial)]
    for x in told:
        missing = [y for y in _parts(x) if y not in known and not any(y in _parts(k) for k in known)]
        need(not missing, f"the initial states are narrower than specified: {words(missing[0]) if missing else ''}")
    return f"{len(wanted)} events and next values of the world, {len(told)} initial conditions as specified"


def _written_out(x: Formula, events: Mapping[str, Formula]) -> Formula:
    """A formula with the moves of points written out, as next values may have them by name or not."""
    if x[0] == "v":
        return _written_out(events[x[1]], events) if x[1].startswith(("start.", "arrive.")) else x
    if x[0] == "!":
        return no(_written_out(x[1], events))
    return every(_written_out(y, events) for y in x[1]) if x[0] == "&" else x


def _parts(x: Formula) -> frozenset[Formula]:
    return frozenset(x[1]) if x[0] == "&" else frozenset({x})


def _defined(schemas: Sequence[Mapping[str, Any]], world: World, prime: str) -> Iterator[tuple[str, Formula]]:
    for s in schemas:
        body = {"for": s["for"], "must": str(s["says"]).replace("True", "true")}
        for at in places(body, world):
            name = str(s["name"]).format(**at)
            (x,) = instances({"must": body["must"]}, world, at)
            yield name + prime, every((x, leaf(f"?{name}"))) if s.get("free") else x
