"""Which train is where: numbers step with the sections that become occupied and clear, and are checked by readers.

A number is a suspicion until a reader confirms it.  What does not fit (a section occupied next to no train, a train
whose sections have all become clear inside the layout, a reader that sees another number, or one that stands elsewhere)
is an alarm that names the train, and for a train with an alarm nothing is asked until an operator says what is there.

Wagons are counted at places: as many must come out of a stretch as went into it.  Where fewer do, the sections between
stay blocked (BLK inputs) until somebody has looked.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import field
from itertools import pairwise

from interlock.dataclass import dataclass
from interlock.dispatch.panel import Indications
from interlock.logic.symbols import Symbols
from interlock.model.elements import SectionId
from interlock.model.layout import Layout
from interlock.model.traversal import topology

DOUBT = "its number is in doubt"
"""Why nothing is asked for a train with an alarm."""

UNKNOWN = "?"
"""The number of a train of which nothing is known; several of them are told apart by where they are."""


@dataclass
class Described:
    """A train: the sections under it in the order in which they became occupied, and its last count of wagons."""

    number: str
    under: list[SectionId]
    wagons: int | None = None
    since: list[SectionId] = field(default_factory=list)
    """The sections that it has run over since wagons were counted."""


class Describer:
    """Numbers of trains by section.  `fleet`: the numbers that exist (empty: any)."""

    def __init__(self, layout: Layout, symbols: Symbols, fleet: frozenset[str] = frozenset()) -> None:
        self._symbols, self._fleet = symbols, fleet
        topo = topology(layout)
        self._next_to: dict[SectionId, set[SectionId]] = {s: set() for s in symbols.sections.clear}
        for _, a, b in topo.joints():
            if a in self._next_to and b in self._next_to:
                self._next_to[a].add(b)
                self._next_to[b].add(a)
        self._first: dict[str, SectionId] = {}
        """By boundary: where trains first appear and from where they vanish; the approach section, if one reports."""
        for at in layout.track.boundaries:
            inside = layout.track.section_of(layout.track.edges_at[at.node][0].id)
            self._first[str(at.node)] = inside
            if at.approach is not None and at.approach in self._next_to:
                self._first[str(at.node)] = at.approach
                if inside in self._next_to:
                    self._next_to[inside].add(at.approach)
                    self._next_to[at.approach].add(inside)
        self._edge = set(self._first.values())
        self.trains: list[Described] = []
        self.alarms: dict[str, str] = {}
        """By number: what is wrong with it."""
        self.blocked: dict[SectionId, str] = {}
        """Sections kept blocked for lost wagons: the train that lost them."""
        self.expected: dict[SectionId, list[str]] = {}
        """By section in which trains first appear: the numbers that are to come there, in order."""
        self.occupied: set[SectionId] = set()
        """As in the scan before."""
        self._leads: set[tuple[SectionId, SectionId]] = set()

    def expects(self, boundary: str, number: str) -> None:
        """A train with this number is to come over a boundary, after those that were told before."""
        self.expected.setdefault(self._first[boundary], []).append(number)

    # --- events --------------------------------------------------------------------------------

    def step(self, seen: Indications, ways: Iterable[Sequence[SectionId]] = ()) -> None:
        """A scan: sections that became occupied are entered, then those that became clear are left.

        ways: the sections of routes that are set, each from the section in rear of its signal on.  Where several
        trains are beside a section that became occupied, the one for which a route leads there has come into it.
        """
        self._leads = {(a, b) for way in ways for a, b in pairwise(way)}
        now = {s for s, n in self._symbols.sections.clear.items() if not seen.get(n, 0)}
        entered, left = sorted(now - self.occupied), self.occupied - now
        self.occupied = now
        while entered:
            some = next((s for s in entered if self._heads(s)), entered[0])
            entered.remove(some)
            self._enter(some)
        for t in [t for t in self.trains if not left.isdisjoint(t.under)]:
            head = t.under[-1]
            t.under[:] = [s for s in t.under if s not in left]
            if not t.under:
                self._vanished(t, head)

    def _heads(self, s: SectionId) -> list[Described]:
        """The trains that may have come into a section: at the edge none that a route leads elsewhere."""
        beside = [t for t in self.trains if t.under and t.under[-1] in self._next_to.get(s, ())]
        led = [t for t in beside if (t.under[-1], s) in self._leads]
        if len(led) == 1:
            return led
        elsewhere = {a for a, b in self._leads if b != s}
        return beside if s not in self._edge else [t for t in beside if t.under[-1] not in elsewhere]

    def _enter(self, s: SectionId) -> None:
        heads = self._heads(s)
        row = self.expected.get(s, []) if s in self._edge else []
        doubt = f"it may have come into {s}, or another train has"
        if len(heads) > 1 or (heads and row and (heads[0].under[-1], s) not in self._leads):
            for number in (*(t.number for t in heads), *row[:1]):
                self._alarm(number, doubt)
            heads = [] if row else heads
        if heads:
            heads[0].under.append(s)
            heads[0].since.append(s)
        else:
            self.trains.append(Described(row.pop(0) if row else self._unknown(s), [s], None, [s]))

    def _unknown(self, s: SectionId) -> str:
        number = f"{UNKNOWN}{s}"
        self._alarm(
            number, f"something stands in {s} that came from nowhere" if s not in self._edge else f"no number in {s}"
        )
        return number

    def _vanished(self, t: Described, s: SectionId) -> None:
        self.trains.remove(t)
        if s not in self._edge:
            self._alarm(t.number, f"it is lost: {s} became clear, and nothing beside it is occupied")
        elif t.number.startswith(UNKNOWN):
            self.alarms.pop(t.number, None)

    # --- readers and operators -----------------------------------------------------------------

    def read(self, section: SectionId, number: str) -> None:
        """A reader in a section has seen a number."""
        here = next((t for t in self.trains if section in t.under), None)
        there = next((t for t in self.trains if t.number == number and t is not here), None)
        if self._fleet and number not in self._fleet:
            self._alarm(number, f"read in {section}: no train has this number")
            if here is not None:
                self._alarm(here.number, f"in {section} the unknown number {number} was read")
        elif there is not None:
            self._alarm(number, f"read in {section}, and described in {there.under[-1]}")
            if here is not None:
                self._alarm(here.number, f"in {section} the number {number} was read")
        elif here is None:
            self._alarm(number, f"read in {section}, which is clear")
        elif here.number.startswith(UNKNOWN):
            self.alarms.pop(here.number, None)
            self._is_here(here, number)
        elif here.number != number:
            self._alarm(here.number, f"in {section} the number {number} was read")
            self._alarm(number, f"read in {section}, where {here.number} is described")

    def _alarm(self, number: str, text: str) -> None:
        """Something is wrong with a number; the first thing that is, is told until an operator says what is there."""
        self.alarms.setdefault(number, text)

    def confirm(self, section: SectionId, number: str) -> bool:
        """An operator has looked: this number stands in a section.  False where the section is clear."""
        here = next((t for t in self.trains if section in t.under), None)
        if here is None:
            return False
        self.alarms.pop(here.number, None)
        for t in [t for t in self.trains if t.number == number and t is not here]:
            t.number = self._unknown(t.under[-1])
        self._is_here(here, number)
        self.alarms.pop(number, None)
        return True

    def takes(self, section: SectionId, number: str) -> bool:
        """A train that stands in an approach section, and of which nothing is known, is the one that a command is for:
        it is the first to pass the signal there.  False where none is, another is to come before, or the number is
        described elsewhere."""
        here = [t for t in self.trains if t.under == [section] and t.number == f"{UNKNOWN}{section}"]
        free = not self.expected.get(section) and self.where(number) is None
        return free and bool(here) and self.confirm(section, number)

    def _is_here(self, t: Described, number: str) -> None:
        """A train has this number, and is not to come any more."""
        t.number = number
        for row in self.expected.values():
            if number in row:
                row.remove(number)

    def counted(self, section: SectionId, wagons: int) -> None:
        """A counter in a section has counted the wagons of the train there."""
        here = next((t for t in self.trains if section in t.under), None)
        if here is None:
            return
        if here.wagons is not None and wagons != here.wagons:
            self._alarm(here.number, f"{here.wagons} wagons went in and {wagons} came out")
            for s in here.since:
                if s not in here.under:
                    self.blocked[s] = here.number
        else:
            here.since = [s for s in here.under if s == section]
        here.wagons = wagons

    def looked(self, section: SectionId) -> None:
        """An operator has looked: nothing is left in a section."""
        self.blocked.pop(section, None)

    def writes(self) -> Mapping[str, int]:
        """The operator inputs that keep sections blocked."""
        names = self._symbols.sections.blocked
        return {names[s]: 1 for s in self.blocked if s in names}

    def where(self, number: str) -> SectionId | None:
        """The section in which a train's head is described."""
        return next((t.under[-1] for t in self.trains if t.number == number and t.under), None)
