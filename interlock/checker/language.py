"""Whether a layout is one: nothing stands in it that `spec/language.yaml` does not admit.

A key, a name or a number that the other modules would pass over says something to whoever reads the layout.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from interlock.checker.kilometres import item_parts
from interlock.checker.reading import TURNING, loaded
from interlock.verify import need

FORMS = Path(__file__).parent.parent / "spec" / "language.yaml"
NAME = re.compile(r"[^\W_]+#?([ _/-][^\W_]+#?)*")
NUMBER = re.compile(r"[+-]?([0-9]+(\.[0-9]*)?|\.[0-9]+)")
WHOLE = re.compile(r"[+-]?[0-9]{1,9}")
KM = re.compile(r"[0-9]{1,4}\+[0-9]{3}(\.[0-9]{1,3})?")
ENDS = frozenset(["start", "end", "toe", "normal", "reverse", "1a", "1b", "2a", "2b", "outer", "inner"])
FLAGS = frozenset({"yes", "no", "true", "false"})
LONGEST = 100_000
"""Metres that a section may have."""


def admitted(body: Mapping[str, Any]) -> None:
    """Raises Rejected where something stands in a layout that may not stand there."""
    reader = _Reader(loaded(FORMS.read_text("utf-8")))
    reader.form("layout", body, "the layout")
    reader.look_up(body)


class _Reader:
    def __init__(self, forms: Mapping[str, Mapping[str, str]]) -> None:
        self.forms = forms
        self.used: list[tuple[str, str, str]] = []
        """Names of elements that are spoken of: what they must be, the name, and where."""

    def form(self, form: str, x: Any, where: str) -> None:
        """A mapping of a form."""
        need(isinstance(x, Mapping) or x == "", f"{where} is no mapping")
        given = x or {}
        kinds = self.forms[form]
        for key, value in given.items():
            need(key in kinds, f"{where} has the key {key}, which says nothing there")
            self.kind(kinds[key].removeprefix("! "), value, f"{key} of {where}")
        for key, kind in kinds.items():
            need(key in given or not kind.startswith("! "), f"{where} lacks {key}")

    def kind(self, kind: str, x: Any, where: str) -> None:
        """A value of a kind."""
        word, _, rest = kind.partition(" ")
        if word in ("each", "of"):
            if word == "of":
                said, _, rest = rest.partition(" ")
                self.used += [(said, n, where) for n in x or ()]
            need(isinstance(x, Mapping) or x == "", f"{where} is no mapping of names")
            for n, value in dict(x or {}).items():
                _name(n, where)
                self.kind(rest, value, f"{n} in {where}")
        elif word == "list":
            need(isinstance(x, list) or x == "", f"{where} is no list")
            for value in x or ():
                self.kind(rest, value, where)
        elif word in self.forms:
            self.form(word, x, where)
        elif word == "addresses":
            need(isinstance(x, Mapping) and all(isinstance(v, str) for v in x.values()), f"{where}: no addresses")
        else:
            need(isinstance(x, str), f"{where} is more than a word")
            self.scalar(word, rest.split(), x, where)

    def scalar(self, word: str, rest: list[str], x: str, where: str) -> None:
        """A single word, number or text."""
        if word in ("number", "whole"):
            _number(x, rest, WHOLE if word == "whole" else NUMBER, where)
        elif word == "one":
            need(x in rest, f"{where} is {x!r}, not one of {', '.join(rest)}")
        elif word == "flag":
            need(x in FLAGS, f"{where} is {x!r}, neither yes nor no")
        elif word == "km":
            need(KM.fullmatch(x) is not None, f"{where} is {x!r}, no position")
        elif word == "end":
            name, dot, end = x.partition(".")
            _name(name, where)
            need(not dot or end in ENDS, f"{where} is {x!r}, no end")
        elif word in ("item", "approach"):
            _stretch(x, where, word == "item")
        elif word == "text":
            need(not {*TURNING} & {*x}, f"{where} turns the direction of what is shown")
        else:
            _name(x, where)
            if word != "name":
                self.used.append((word, x, where))

    def look_up(self, body: Mapping[str, Any]) -> None:
        """Every element that is spoken of is there."""
        known = elements(body)
        ends = {*(body.get("buffers") or ()), *(body.get("traps") or ())}
        known["place"] = known["section"] | known["signal"] | known["boundary"] | ends
        for kind, name, where in self.used:
            need(name in known[kind], f"{where}: there is no {kind} {name}")


def elements(body: Mapping[str, Any]) -> dict[str, set[str]]:
    """The names of a layout by what they name, as far as variables are called after them."""
    slips = body.get("slips") or {}
    points = {*(body.get("points") or ()), *(body.get("derailers") or ())}
    points |= {m for s, v in slips.items() for m in v.get("machines") or (f"{s}a", f"{s}b")}
    devices = {*(body.get("level_crossings") or ()), *(body.get("interlocks") or ())}
    found = {"section": _sections(body), "machine": points, "held": points | devices}
    for kind, key in (("signal", "signals"), ("boundary", "boundaries"), ("zone", "zones"), ("distant", "distants")):
        found[kind] = {*(body.get(key) or ())}
    return {**found, "condition": {*(body.get("conditions") or ())}}


def _sections(body: Mapping[str, Any]) -> set[str]:
    ends = {*(body.get("boundaries") or ()), *(body.get("buffers") or ()), *(body.get("traps") or ())}
    parts = (x for t in (body.get("tracks") or {}).values() for x in t if x not in ends)
    said = ((x, *item_parts(x)) for x in parts)
    found = {name for x, name, metres in said if metres or not ("+" in x or "." in x)}
    found |= {str(v["section"]) for k in ("points", "slips", "derailers") for v in (body.get(k) or {}).values()}
    found |= {str(arm["section"]) for v in (body.get("crossings") or {}).values() for arm in v["arms"]}
    outside = [(v or {}).get("approach", "") for v in (body.get("boundaries") or {}).values()]
    return found | {item_parts(x)[0] for x in outside if x}


def _name(x: Any, where: str) -> None:
    ok = isinstance(x, str) and NAME.fullmatch(x) is not None and unicodedata.normalize("NFC", x) == x
    need(ok, f"{where}: {x!r} is no name")


def _number(x: str, rest: list[str], form: re.Pattern[str], where: str) -> None:
    """Within its bounds, and written as people write numbers."""
    need(form.fullmatch(x) is not None, f"{where} is {x!r}, no number")
    low, high = (float(y.removeprefix(">")) for y in rest)
    above = float(x) > low if rest[0].startswith(">") else float(x) >= low
    need(above and float(x) <= high, f"{where} is {x}, not {rest[0]} to {rest[1]}")


def _stretch(x: str, where: str, alone: bool) -> None:
    """A section and its length; within a track also a name, an end or a position by itself."""
    name, metres = item_parts(x)
    bare = alone and not metres
    if bare and KM.fullmatch(name):
        return
    part, dot, end = name.partition(".")
    _name(part, where)
    need(not dot or (bare and end in ENDS), f"{where}: {x!r} is no part of a track")
    need(bare or metres != "", f"{where}: {x!r} is no section with its length")
    if metres:
        _number(metres, [">0", str(LONGEST)], NUMBER, where)
