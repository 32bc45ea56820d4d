"""Commands as an operator types them: the name of a voyage, or a locomotive number with origin and destinations.

in                      the voyage `in` of the layout
12:W>E                  locomotive 12 from boundary W to E, over any chain of routes
12:W>E+q4+q6            over sections q4 and q6
12:W>s8_xc3>OUT         to section s8_xc3, where it changes direction if it must, then to OUT
12:q9/X6>W              begins in the layout, standing in q9 before signal X6
12:Gleis 3>22 T+E 1     names may have spaces; spaces around the signs say nothing
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Sequence

from interlock.diag.called import called
from interlock.diag.suggest import did_you_mean, nearest
from interlock.dispatch.plan.errands import OUTSIDE, Errand, Leg, NoVoyage, Place, TooManyPlaces
from interlock.dispatch.plan.railway import Railway
from interlock.exceptions import Whole
from interlock.model.elements import BoundaryKind, BufferKind, SectionId, SignalId
from interlock.model.stopping import MARGIN_M, stands_on
from interlock.table.cells import TraversalKey
from interlock.table.rows import VoyageRow

_COMMAND = re.compile(r"(?P<train>[^:>]+):(?P<start>[^:>]+)(?P<legs>(>[^:>]+)+)")

TRIED = 6
"""Ways that are tried for an example of a command (our choice)."""

_SIGNS = frozenset(":>+/")
_SIGN = re.compile(r"\s*([:>+/])\s*")


class BadOrder(Whole):
    """A command that cannot be carried out: `code`, what is wrong, what would be known, or else what to do."""

    def __init__(self, code: str, text: str, known: Sequence[str] = (), word: str = "", fix: str = "") -> None:
        super().__init__(text)
        self.code, self.text, self.known, self.word, self.fix = code, text, tuple(known), word, fix

    @property
    def advice(self) -> str:
        """What to do: as stated, or the name that is probably meant."""
        return self.fix or (str(did_you_mean(self.word, self.known)) if self.known else "")


def errand(railway: Railway, command: str, length_m: float, train: str = "") -> tuple[Errand, int]:
    """The errand of a command and its class of priority.  Raises `BadOrder`."""
    layout = railway.layout
    voyages = {v.name: v for v in railway.table.voyages}
    if command in voyages:
        v = next(x for x in layout.declared.voyages if x.name == command)
        leg = Leg(v.exit, frozenset(v.via), v.shunt, v.far_first)
        start = _fits(railway, voyage_start(railway, voyages[command]), length_m)
        return Errand(train or command, length_m, start, (leg,)), voyages[command].priority
    found = _COMMAND.fullmatch(_SIGN.sub(r"\1", command.strip()))
    if found is None:
        text = f"'{command}' is neither a voyage nor a command NUMBER:ORIGIN>DESTINATION"
        near = nearest(command, tuple(voyages))
        fix = f"did you mean {near}?" if near else _written(command, railway, length_m)
        raise BadOrder("IL6004", text, tuple(voyages), command, fix)
    legs = tuple(_leg(railway, x) for x in found["legs"].split(">")[1:])
    start = _fits(railway, _start(railway, found["start"]), length_m)
    return Errand(train or found["train"], length_m, start, legs), 0


def _fits(railway: Railway, start: tuple[TraversalKey, ...], length_m: float) -> tuple[TraversalKey, ...]:
    """Where a train begins, if it stands there wholly; one of no length, of which nothing is known, does.

    Raises `BadOrder`."""
    section, metres = start[-1][0], railway.metres.get(start[-1])
    if start[-1][1] != OUTSIDE and metres is not None and length_m and not stands_on(metres, length_m):
        text = f"a train of {length_m:g} m does not stand in {section}, which has {metres:g} m there"
        text += f", {MARGIN_M:g} m of them left by drivers at its end" if length_m <= metres else ""
        raise BadOrder("IL6004", text, fix="take a shorter train, or begin outside")
    return start


def _written(command: str, railway: Railway, length_m: float) -> str:
    """How a command that is none could be written; else the form of one, in names of the layout."""
    origins = _origins(railway)
    plain = "".join(unicodedata.normalize("NFKC", command).split())
    if plain != command and _COMMAND.fullmatch(plain):
        return f"write {plain}"
    words = command.split()
    if len(words) == 3 and not _SIGNS & set(command):
        return "write {}:{}>{}".format(*words)
    number, sign, rest = re.fullmatch(r"\s*(\w*)([\s;,.=-]*)(.*)", command, re.DOTALL).groups()  # type: ignore[union-attr]
    if number and sign and _COMMAND.fullmatch(f"{number}:{rest}") and rest.split(">")[0].strip() in origins:
        return f"write {number}:{rest}"
    if _COMMAND.fullmatch(f"12:{command}"):
        return f"write the locomotive's number before it: 12:{command}"
    if not origins:
        return "name a voyage of the layout"
    like = _possible(railway, origins, length_m)
    return f"write number, origin and destination{f', in quotes for the shell: {like}' if like else ''}"


def _possible(railway: Railway, origins: Sequence[str], length_m: float) -> str:
    """A command that can be carried out: from boundary to boundary, else to where a route ends; empty where none is."""
    ends = [str(b.node) for b in railway.layout.track.boundaries]
    tried = [(a, b) for a in origins for b in ends if a != b][:TRIED]
    for a in origins[:TRIED]:
        outside = Place(0, frozenset(), None, ((SectionId(a), OUTSIDE),))
        tried += [(a, str(r.exit)) for r, _ in railway.routes_on(outside, turns=False)[:TRIED]]
    for start, end in tried:
        try:
            railway.draft(Errand("12", length_m, ((SectionId(start), OUTSIDE),), (Leg(end),)))
        except (NoVoyage, TooManyPlaces):
            continue
        return f"'12:{start}>{end}'"
    return ""


def _origins(railway: Railway) -> list[str]:
    """The boundaries at which trains come in."""
    return [str(b.node) for b in railway.layout.track.boundaries if b.kind is not BoundaryKind.OUT]


def voyage_start(railway: Railway, row: VoyageRow) -> tuple[TraversalKey, ...]:
    """Where a train stands that is commanded a voyage."""
    first = railway.table.route[row.routes[0]]
    if str(first.path.entry_node) in railway.approach:
        return ((SectionId(first.path.entry_node), OUTSIDE),)
    return railway.standing(first)


def _start(railway: Railway, word: str) -> tuple[TraversalKey, ...]:
    layout = railway.layout
    known = _origins(railway)
    sections = [str(s.id) for s in layout.track.sections if not s.approach]
    parts = word.split("/")  # names have a `/`, too
    divided = [("/".join(parts[:k]), "/".join(parts[k:])) for k in range(1, len(parts))]
    if word in known:
        return ((SectionId(word), OUTSIDE),)
    if not divided:
        raise BadOrder("IL6004", f"no train comes in at {word}", known, word)
    section, signal = next((x for x in divided if x[0] in sections and x[1] in layout.signalling.signal), divided[0])
    if section not in sections:
        raise BadOrder("IL6004", f"there is no section {section}", sections, section)
    if signal not in layout.signalling.signal:
        raise BadOrder("IL6004", f"there is no signal {signal}", [str(g.id) for g in layout.signalling.signals], signal)
    node = layout.signalling.signal[SignalId(signal)].node
    ways = [t.key for t in railway.topo.traversals[SectionId(section)] if t.exit == node]
    if not ways:
        raise BadOrder("IL6004", f"{called('signal', signal)} does not stand at an end of {section}", (), signal)
    return (min(ways, key=lambda k: (k not in railway.table.lock, k)),)


def _leg(railway: Railway, text: str) -> Leg:
    layout = railway.layout
    to, *via = text.split("+")
    if "" in via:
        raise BadOrder("IL6004", f"no section is named after a + of '{text}'", (), "", "name it, or leave out the +")
    sections = [str(s.id) for s in layout.track.sections if not s.approach]
    places = [
        *sections,
        *(str(b.node) for b in layout.track.boundaries),
        *(str(g.id) for g in layout.signalling.signals),
    ]
    places += [str(b.node) for b in layout.track.buffers if b.kind is not BufferKind.DERAIL]
    if to not in places:
        raise BadOrder("IL6004", f"there is no place {to}", places, to)
    for s in via:
        if s not in sections:
            raise BadOrder("IL6004", f"there is no section {s}", sections, s)
    return Leg(to, frozenset(SectionId(s) for s in via))
