"""Whether what a text says of routes is so: its words, case by case, and the sentences that are published of its codes.

Nothing in the text reads a word, so the written system knows nothing of them.  In each case in which a word gets a
value the condition of the case holds and none before it; what follows for the text's equations is found by unit
propagation.  A case in which the specification's claim does not follow so is refused, though it might be true.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from typing import Any

from interlock.checker.claims import words
from interlock.checker.formula import FALSE, TRUE, Formula, clauses, leaf, no
from interlock.checker.scan import Scan
from interlock.checker.schema import Sentence, places
from interlock.checker.specification import Specification
from interlock.checker.told import Telling
from interlock.verify import need

UNKNOWN, FREE, SET, OPEN, CANCELLING = range(5)
KINDS = {UNKNOWN: "unknown", FREE: "free", SET: "set", OPEN: "open", CANCELLING: "cancelling"}
WAITING, REFUSED, MANY = 1000, 10_000, 32_767
"""Where the codes of machines begin, and those of conditions; the one that conditions without a number share."""
MOVE, ROUTES = re.compile("(.+? cannot (?:move|be worked)): (.+)", re.DOTALL), " for route "


class _Contradiction(Exception):
    """What was supposed cannot be."""


@dataclass
class Supposed:
    """Formulas that are supposed to be true or false in one scan, and what follows by the text's equations."""

    scan: Scan
    known: dict[Formula, bool] = field(default_factory=dict)
    loose: list[Formula] = field(default_factory=list)
    """Conjunctions that are false, of which nobody knows which part is."""
    open: set[Formula] = field(default_factory=set)
    """What came out as neither since something was last supposed."""

    def with_(self, *xs: Formula) -> Supposed:
        """These supposed, too.  Raises _Contradiction where they cannot be."""
        more = Supposed(self.scan, dict(self.known), list(self.loose))
        for x in xs:
            more._hold(x, True)
        while more._settle():
            pass
        return more

    def _hold(self, x: Formula, is_so: bool) -> None:
        while x[0] == "!":
            x, is_so = x[1], not is_so
        if x in (TRUE, FALSE):
            if (x == TRUE) is not is_so:
                raise _Contradiction
            return
        before = self.known.get(x)
        if before is not None:
            if before is not is_so:
                raise _Contradiction
            return
        self.known[x] = is_so
        self.open.clear()
        if x[0] == "v":
            name = x[1]
            if name in self.scan.definitions:
                self._hold(self.scan.definitions[name], is_so)
            if name in self.scan.timers and is_so:  # A-TON
                self._hold(leaf(self.scan.timers[name][0]), True)
        elif is_so:
            for y in x[1]:
                self._hold(y, True)
        else:
            self.loose.append(x)

    def _settle(self) -> bool:
        """Whether some part of a conjunction that is false is the one."""
        for x in list(self.loose):
            open_: list[Formula] = []
            for y in x[1]:
                part = self.value(y)
                if part is None:
                    open_.append(y)
                if part is False or len(open_) > 1:
                    break
            else:
                if not open_:
                    raise _Contradiction
                self.loose.remove(x)
                self._hold(open_[0], False)
                return True
            if part is False:
                self.loose.remove(x)
        return False

    def value(self, x: Formula) -> bool | None:
        """What a formula comes out as; kept, if that is settled."""
        if x[0] == "!":
            inner = self.value(x[1])
            return None if inner is None else not inner
        if x in (TRUE, FALSE):
            return bool(x == TRUE)
        if x in self.known:
            return self.known[x]
        if x in self.open:
            return None
        found: bool | None = None
        if x[0] == "v":
            if x[1] in self.scan.definitions:
                found = self.value(self.scan.definitions[x[1]])
            elif x[1] in self.scan.timers and self.value(leaf(self.scan.timers[x[1]][0])) is False:
                found = False
        else:
            found = True
            for y in x[1]:
                part = self.value(y)
                if part is False:
                    found = False
                    break
                found = None if part is None else found
        if found is None:
            self.open.add(x)
        else:
            self.known[x] = found
        return found

    def follows(self, x: Formula) -> bool:
        """Whether a formula is true: at once, or since nothing else can be."""
        return self.value(x) is True or all(self._shown(c) for c in clauses(x))

    def _shown(self, clause: frozenset[Formula]) -> bool:
        if any(self.value(y) is True for y in clause):
            return True
        try:
            self.with_(*map(no, clause))
        except _Contradiction:
            return True
        return False


Case = tuple[Supposed, Formula, int]
"""A case in which a word has a code: what holds, the case's own condition, and the code; REFUSED for one of several,
each of them a refusal."""


class Saying:
    """The words of a text, for a layout."""

    def __init__(self, scan: Scan, world: Telling) -> None:
        self.scan, self.world = scan, world
        self.refusing: dict[str, bool] = {}
        for name in scan.words:  # each stands after those that it reads
            self.refusing[name] = self._refuses(name)
        self.complete: set[tuple[str, Formula, bool]] = set()

    def _refuses(self, name: str) -> bool:
        """A word of a place: it names a condition, or, where none fails, nothing."""
        return all(
            self.refusing[x] if isinstance(x, str) else x > REFUSED or (x == UNKNOWN and c == TRUE)
            for c, x in self.scan.words[name]
        )

    def cases(self, name: str, of: Supposed) -> Iterator[Case]:
        """Each case that can be; a word of a place is one, once it is certain to name a condition."""
        rest: Supposed | None = of
        for condition, value in self.scan.words[name]:
            here = self._such(rest, condition)
            if here is not None and isinstance(value, int):
                yield here, condition, value
            elif here is not None and self.refusing[str(value)]:
                yield here, condition, REFUSED if self._names_one(str(value), condition, here) else UNKNOWN
            elif here is not None:
                yield from self.cases(str(value), here)
            rest = self._such(rest, no(condition))

    def _names_one(self, name: str, entered: Formula, here: Supposed) -> bool:
        """Where a condition fails, the word of its place names one of its parts; decided once for each way in."""
        valid = self.world.w_valid()
        key = name, entered, here.value(valid) is True
        if key in self.complete:
            return True
        rest = self._such(Supposed(self.scan), entered, *([valid] if key[2] else ()))
        for condition, value in self.scan.words[name]:
            case = self._such(rest, condition)
            if case is not None and value == UNKNOWN:
                return False
            if case is not None and isinstance(value, str) and not self._names_one(value, condition, case):
                return False
            bears = value == UNKNOWN or self._bears(condition, entered)
            need(bears, f"{name} names {words(condition)}, which has no part in {words(entered)}")
            rest = self._such(rest, no(condition))
        self.complete.add(key)
        return True

    def alone(self, condition: Formula) -> Supposed | None:
        """The condition of a case, whatever was said before; of lost inputs that is said before all else."""
        here = self._such(Supposed(self.scan), condition)
        valid = self.world.w_valid()
        return here if here is None or here.value(valid) is not None else self._such(here, valid)

    def _bears(self, condition: Formula, entered: Formula) -> bool:
        """By itself a condition makes that for which a word is asked, or ends one way in which it could not be so."""
        here = self.alone(condition)
        if here is None or here.follows(entered):
            return True
        wire = entered[1] if entered[0] == "!" else entered
        meant = no(self.scan.definitions.get(str(wire[1]), TRUE)) if wire[0] == "v" else TRUE
        return entered == no(wire) and meant[0] == "&" and any(map(here.follows, meant[1]))

    @staticmethod
    def _such(of: Supposed | None, *xs: Formula) -> Supposed | None:
        """These supposed, too; None where they cannot be."""
        try:
            return None if of is None else of.with_(*xs)
        except _Contradiction:
            return None


@dataclass(frozen=True)
class Published:
    """What a table tells of words: by code its sentence and the rule beside it, and what each word is of."""

    codes: Mapping[int, str]
    words: Mapping[str, str]
    rules: Mapping[int, str]


def compare(world: Telling, spec: Specification, scan: Scan, table: Published | None) -> tuple[str, list[str]]:
    """What was found to be so, in words, and what was not compared.  Raises Rejected at the first lie."""
    saying = Saying(scan, world)
    own = {n for n, type_ in scan.shown.items() if type_ == "INT"}
    routes = world.w_routes()
    need(own == {f"YX_R{r}" for r in routes}, "the words that are shown are not those of the routes, each one")
    claims, because = _claims(world, spec, "must"), _claims(world, spec, "because")
    many = 0
    for r in routes:
        for here, condition, code in saying.cases(f"YX_R{r}", Supposed(scan)):
            many += 1
            told = _kind(code)
            alone = saying.alone(condition)
            for known, those in ((here, claims[r]), (alone, because[r])):
                if known is None:
                    continue
                known.known.update({leaf(f"said.{k}"): k == told for k in (*KINDS.values(), "waiting", "refused")})
                for x in those:
                    need(known.follows(x), f"YX_R{r} says {told}, and it does not follow that {words(x)}")
    used = _codes(scan)
    said = f"{len(routes)} words of routes say what is so, in {many} cases"
    if table is None:
        return f"{said}; no table that says what their {len(used)} codes mean was certified, and none read", []
    world.called = _called(world, routes, table)
    unread, unknown = _sentences(saying, spec, table, used)
    left = f", {len(unread)} not: {_listed(unread)}" if unread else ""
    more = [f"the sentences of the codes {_listed(unknown)} in io/words.csv"] if unknown else []
    return f"{said}; {len(used) - len(unread) - len(unknown)} sentences of io/words.csv read{left}", more


def _claims(world: Telling, spec: Specification, key: str) -> dict[int, list[Formula]]:
    """By route: what must hold in each case of its word."""
    found: dict[int, list[Formula]] = {r: [] for r in world.w_routes()}
    for s in spec.told:
        for at in places(s, world) if key in s else ():
            found[at["r"]].append(Sentence(s[key], world, at).formula())
    return found


def _listed(codes: list[int]) -> str:
    return ", ".join(map(str, codes[:8])) + (", ..." if len(codes) > 8 else "")


def _kind(code: int) -> str:
    need(code in KINDS or code > WAITING, f"a word has the value {code}, which says nothing")
    return KINDS.get(code, "waiting" if code < REFUSED else "refused")


# --- what is published of codes --------------------------------------------------------------------------


def _codes(scan: Scan) -> dict[int, set[Formula]]:
    """For each code from 1001 on the conditions under which it is said; from 10001 on one, everywhere the same."""
    used: dict[int, set[Formula]] = {}
    for word in scan.words.values():
        for condition, value in word:
            if isinstance(value, int) and value > WAITING:
                used.setdefault(value, set()).add(condition)
    for code, those in used.items():
        need(len(those) == 1 or code == MANY or code < REFUSED, f"the code {code} is said of two conditions")
    return used


def _called(world: Telling, routes: list[int], table: Published) -> dict[int, str]:
    """What the table calls each route: where it begins, what it passes, and where it ends."""
    need({*table.words} == {f"YX_R{r}" for r in routes}, "io/words.csv has other words than the text")
    found = {}
    for r in routes:
        text = table.words[f"YX_R{r}"]
        begins, ends = world.from_and_to(r)
        need(
            any(re.fullmatch(f"route {re.escape(begins)}-(.*-)?{re.escape(x)}(\\..+)?", text) for x in ends),
            f"io/words.csv calls YX_R{r} {text!r}, which leads from {begins} to {' or '.join(sorted(ends))}",
        )
        found[r] = text.removeprefix("route ")
    need(len({*found.values()}) == len(found), "io/words.csv calls two routes the same")
    return found


def _sentences(
    saying: Saying, spec: Specification, table: Published, used: Mapping[int, set[Formula]]
) -> tuple[list[int], list[int]]:
    """Codes whose sentences the specification leaves unread, and those that it does not know; of the others each tells
    what is so.  Raises Rejected for one that does not."""
    meant = _meant(saying.world, spec)
    unread: list[int] = []
    unknown: list[int] = []
    for code, sentence in spec.states.items():
        need(table.codes.get(code) == sentence, f"the code {code} is published as {table.codes.get(code)!r}")
        need(table.rules.get(code, "") == "", f"a rule is published for the code {code}")
    for code, those in sorted(used.items()):
        need(code in table.codes, f"nothing is published of the code {code}")
        text = table.codes[code]
        moved = None if text in meant else MOVE.fullmatch(text)
        said = [*moved.groups()] if moved else [text]
        parts = [_of(meant, x) for x in said]
        if not all(parts):
            (unread if text.startswith(tuple(spec.unread)) else unknown).append(code)
            continue
        for condition in those:
            here = saying.alone(condition)
            ok = here is None or all(any(here.follows(x.so) for x in those) for those in parts)
            need(ok, f"the code {code} is published as {text!r}, and said while {words(condition)}")
        rule = table.rules.get(code, "")
        need(
            any(rule in x.rules for x in parts[0]),
            f"the code {code} has the rule {rule!r}, which asks for no such thing",
        )
    more = min(table.codes.keys() - used.keys() - spec.states.keys(), default=None)
    need(more is None, f"io/words.csv explains the code {more}, which nobody says")
    return unread, unknown


def _of(meant: Mapping[str, list[Meaning]], text: str) -> list[Meaning]:
    """What a sentence may mean, by itself or but for the routes that it lists."""
    plain, _, listed = (text, "", "") if text in meant else text.partition(ROUTES)
    found = [x for x in meant.get(plain, ()) if x.lists(listed)]
    need(found != [] or plain not in meant, f"{text!r} lists other routes than lead there")
    return found


@dataclass(frozen=True)
class Meaning:
    """What is so when a sentence is said of a place; the rules of which one asks for it; the routes that it lists, by
    name, None where none are listed."""

    so: Formula
    rules: tuple[str, ...]
    routes: tuple[str, ...] | None

    def lists(self, text: str) -> bool:
        """All of them, or some of the first and `another`."""
        those = self.routes or ()
        some_of = (" or ".join((*those[:n], "another")) for n in range(1, len(those)))
        return text in (" or ".join(those), *some_of)


class _Named(str):
    """A name in a sentence: `{0:section}` is `section s5`, or the name alone that says so itself."""

    def __format__(self, kind: str) -> str:
        own = len(self) > len(kind) and self.lower().startswith(kind.lower())
        return str(self) if not kind or own else f"{kind} {self}"


def _meant(world: Telling, spec: Specification) -> dict[str, list[Meaning]]:
    """By sentence: what is so when it is said, of each place that has the same one."""
    found: dict[str, list[Meaning]] = {}
    for s in spec.sentences:
        for at in places({"for": s.get("for", "")}, world):
            named: dict[str, Any] = {k: _Named(v) if isinstance(v, str) else v for k, v in at.items()}
            over = Sentence(s["routes"], world, at).term() if "routes" in s else None
            routes = None if over is None else tuple(world.called[r] for r in over)
            so = Sentence(s["when"], world, at).formula()
            found.setdefault(s["text"].format(**named), []).append(Meaning(so, tuple(s["rule"].split()), routes))
    return found
