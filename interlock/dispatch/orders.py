"""Orders carried into voyages, and what of them cannot be done.

A train of an order runs from its waiting place to the loading place, and from there to the tipping place, over any
chain of routes.  Checked before anything moves: every order has such voyages for every train of the fleet; every place
can be left again; there is standing room for the fleet; tippler and loading places have the hours.
"""

from __future__ import annotations

import math
import unicodedata
from collections.abc import Iterator, Sequence
from functools import cached_property

from interlock.dataclass import dataclass
from interlock.diag import Sink
from interlock.diag.suggest import did_you_mean
from interlock.dispatch.language import DispatchFile, Orders, OrderSpec, TrainSpec
from interlock.dispatch.plan.errands import OUTSIDE, Errand, Leg, NoVoyage, Place, TooManyPlaces
from interlock.dispatch.plan.held import Lies
from interlock.dispatch.plan.railway import Journey, Railway
from interlock.model.elements import RouteId, SectionId
from interlock.model.stopping import MARGIN_M, stands_on
from interlock.table.cells import TraversalKey
from interlock.table.rows import RouteRow


@dataclass(frozen=True)
class Derived:
    """An order with the journeys that carry it out, by train, and how many of them are needed at most: of tonnes that
    many of those that carry least, `carried` tonnes each."""

    name: str
    order: OrderSpec
    journeys: dict[str, Journey]
    trains: int
    carried: float = 0.0


def metres_to(journey: Journey, section: str) -> float:
    """Metres of route from a journey's start until a train has come into a section; by the shortest way."""
    best: dict[Place, float] = {journey.start: 0.0}
    todo, found = [journey.start], float("inf")
    while todo:
        place = min(todo, key=lambda p: best[p])
        todo.remove(place)
        for s in journey.steps[place]:
            metres = best[place] + sum(r.path.length for r in s.routes)
            if any(section in r.path.section_ids for r in s.routes):
                found = min(found, metres)
            elif metres < best.get(s.after, float("inf")):
                best[s.after] = metres
                todo.append(s.after)
    return found


def read_alike(number: str) -> str:
    """What people read of a locomotive number: without zeros before it, in one case, in plain digits."""
    return unicodedata.normalize("NFKC", number).casefold().lstrip("0")


class Derivation:
    """Orders against a railway; problems go into the sink with their places."""

    def __init__(self, railway: Railway, orders: Orders, sink: Sink) -> None:
        self.railway, self.orders, self.sink = railway, orders, sink
        self.file: DispatchFile = orders.file
        layout = railway.layout
        self.sections = {str(s.id) for s in layout.track.sections if not s.approach}
        self.boundaries = {str(b.node) for b in layout.track.boundaries}

    def run(self) -> tuple[Derived, ...]:
        """All orders; none where names are wrong."""
        self._names()
        self._twice()
        if self.sink.has_errors:
            return ()
        found = tuple(d for n, o in self.file.orders.items() for d in self._derive(n, o))
        self._rooms()
        self._hours()
        self._turns(found)
        return found

    # --- names ---------------------------------------------------------------------------------

    def _names(self) -> None:
        file = self.file
        for name, place in file.places.items():
            if place.at not in self.sections | self.boundaries:
                self._unknown(f"there is no section or boundary {place.at}", place.at,
                              sorted(self.sections | self.boundaries), "places", name, "at")  # fmt: skip
        for number, train in file.fleet.items():
            waiting = [n for n, p in file.places.items() if p.kind == "waiting"]
            if train.at not in waiting:
                self._unknown(f"there is no waiting place {train.at}", train.at, waiting, "fleet", number, "at")
            elif train.at in file.blocked or file.places[train.at].at in file.closed & self.sections:
                here = self.orders.at("fleet", number, "at")
                text = f"train {number} begins at {train.at}, which is blocked"
                self.sink.add("IL6013", text, here, "open it, or let the train begin elsewhere")
        for i, word in enumerate(file.blocked):
            known = [*file.places, *sorted(self.sections)]
            if word not in known:
                self._unknown(f"there is no place or section {word}", word, known, "blocked", i)
        for name, order in file.orders.items():
            for key, word, kind in (("from", order.from_, "loading"), ("to", order.to, "tipping")):
                known = [n for n, p in file.places.items() if p.kind == kind]
                if word not in known:
                    self._unknown(f"there is no {kind} place {word}", word, known, "orders", name, key)
            for i, s in enumerate(order.via):
                if s not in self.sections:
                    self._unknown(f"there is no section {s}", s, sorted(self.sections), "orders", name, "via", i)
            for i, number in enumerate(order.only):
                if number not in file.fleet:
                    text = f"there is no locomotive {number}"
                    self._unknown(text, number, list(file.fleet), "orders", name, "only", i)
            for key, word in (("from", order.from_), ("to", order.to)):
                at = file.places[word].at if word in file.places else word
                if word in file.blocked or at in file.blocked:
                    here = self.orders.at("orders", name, key)
                    self.sink.add("IL6013", f"order {name} is for {word}, which is blocked", here, "open it, or wait")
            loads = file.places.get(order.from_)
            if order.ore is not None and loads is not None and loads.kind == "loading" and order.ore not in loads.ores:
                self._ore(name, order)
            if (order.trains is None) == (order.tonnes is None):
                here = self.orders.at("orders", name, key=True)
                says = "neither trains nor tonnes" if order.trains is None else "both trains and tonnes"
                self.sink.add("IL6003", f"order {name} says {says}", here, "say one of them")
        if file.orders and not file.fleet:
            self.sink.add("IL6003", "there are orders and no fleet", self.orders.at("orders", key=True), "add `fleet`")

    def _ore(self, name: str, order: OrderSpec) -> None:
        """Ordered from a place that does not load it."""
        ores = {x for p in self.file.places.values() for x in p.ores}
        there = [n for n, p in self.file.places.items() if order.ore in p.ores]
        text = f"{order.from_} does not load {order.ore}"
        own = f"it is loaded at {', '.join(there)}" if there else did_you_mean(order.ore or "", ores)
        self.sink.add("IL6002", text, self.orders.at("orders", name, "ore"), own)

    def _twice(self) -> None:
        """One thing under two names, or one name twice."""
        file, at = self.file, self.orders.at
        numbers: dict[str, str] = {}
        for number in file.fleet:
            first = numbers.setdefault(read_alike(number), number)
            if first != number:
                text = f"{number} and {first} read as one locomotive number"
                self.sink.add("IL6015", text, at("fleet", number, key=True), "number one of them otherwise")
        for name, order in file.orders.items():
            for i, number in enumerate(order.only):
                if number in order.only[:i]:
                    self.sink.add("IL6015", f"{number} is named twice", at("orders", name, "only", i), "name it once")
        places: dict[tuple[str, str], str] = {}
        for name, p in file.places.items():
            if p.kind not in ("loading", "tipping") or p.at not in self.sections:
                continue
            first = places.setdefault((p.kind, p.at), name)
            if first != name:
                text = f"{name} lies in {p.at}, where {first} is a {p.kind} place already"
                fix = "make one place of them, with the `capacity` and `ores` of both, or name another section"
                self.sink.add("IL6014", text, at("places", name, "at"), fix)

    def _unknown(self, text: str, word: str, known: list[str], *path: str | int) -> None:
        self.sink.add("IL6002", text, self.orders.at(*path), did_you_mean(word, known) or "known: " + ", ".join(known))

    # --- voyages -------------------------------------------------------------------------------

    def start(self, train: TrainSpec) -> tuple[TraversalKey, ...]:
        """Where a train begins: outside a boundary, or in a section on any way through it."""
        at = self.file.places[train.at].at
        if at in self.boundaries:
            return ((SectionId(at), OUTSIDE),)
        return (self.railway.topo.traversals[SectionId(at)][0].key,)

    def errand(self, number: str, order: OrderSpec) -> Errand:
        """What a train does for an order."""
        places, train = self.file.places, self.file.fleet[number]
        via = frozenset(SectionId(s) for s in order.via)
        legs = (Leg(places[order.from_].at, wholly=True), Leg(places[order.to].at, via, wholly=True))
        return Errand(number, train.length, self.start(train), legs)

    def _derive(self, name: str, order: OrderSpec) -> Iterator[Derived]:
        journeys: dict[str, Journey] = {}
        for number in order.only or self.file.fleet:
            try:
                journeys[number] = self.railway.draft(self.errand(number, order))
            except (NoVoyage, TooManyPlaces) as error:
                why = f"order {name}: {error}"
                fix = error.fix if isinstance(error, NoVoyage) else "name sections on the way with `via`"
                self.sink.add("IL6005", why, self.orders.at("orders", name, key=True), fix)
                return
            if not self._open(name, journeys[number]):
                return
        carried = min(self.file.fleet[n].tonnes for n in journeys)
        trains = order.trains or math.ceil((order.tonnes or 0) / carried)
        yield Derived(name, order, journeys, trains, carried)

    def _open(self, name: str, journey: Journey) -> bool:
        """Some chain of routes leads past whatever is blocked."""
        todo, came, met = [journey.start], {journey.start}, dict[str, None]()
        while todo:
            steps = journey.steps[todo.pop()]
            if not steps:
                return True
            for s in steps:
                shut = self._shut(s.routes)
                met |= dict.fromkeys(shut)
                if not shut and s.after not in came:
                    came.add(s.after)
                    todo.append(s.after)
        text = f"order {name} has no way that does not {', or '.join(sorted(met))}"
        self.sink.add("IL6016", text, self.orders.at("orders", name, key=True), "open it, or leave the order out")
        return False

    def _shut(self, routes: Sequence[RouteRow]) -> list[str]:
        """What of routes is blocked: of their path; or else of their overlap, or points that have to be moved."""
        closed, machines = self.file.closed, self.railway.layout.machines
        on = sorted({str(x) for r in routes for x in r.path.section_ids} & closed)
        if on or not closed:
            return [f"lead through {', '.join(on)}, which is blocked"] if on else []
        beyond = {s for r in routes if r.locking.overlap is not None for s, _ in r.locking.overlap.ways}
        found = [f"have {s}, which is blocked, as its overlap" for s in sorted(beyond & closed)]
        needed = {x for r in routes for x in self.railway.held.needs(r)}
        for _, m, x in sorted(self._stay & needed) if not found else ():
            off = ", ".join(s for s in machines.sections[m] if s in closed)
            found.append(f"need {m} {machines.word(m, x.other)}, which is not moved while {off} is blocked")
        return found

    @property
    def shut(self) -> frozenset[RouteId]:
        """The routes that lead over what is blocked, or need it."""
        return frozenset(r.id for r in self.railway.table.routes if self._shut((r,)))

    @cached_property
    def _stay(self) -> frozenset[Lies]:
        """The points in what is blocked, where they lie when the trains begin."""
        held = self.railway.held
        under = (key for t in self.file.fleet.values() for key in self.start(t))
        return held.stay(self.file.closed, held.at_first(under))

    # --- room and time -------------------------------------------------------------------------

    def _rooms(self) -> None:
        """A place inside the layout must be left again; the fleet must have somewhere to be."""
        longest = max((t.length for t in self.file.fleet.values()), default=0.0)
        for name, p in self.file.places.items():
            if p.at not in self.sections:
                continue
            section = SectionId(p.at)
            ways = [(t.key,) for t in self.railway.topo.traversals[section]]
            if not any(self._leaves(w) for w in ways):
                text = f"no train can leave {name}: no route begins at a signal of {p.at}"
                self.sink.add("IL6008", text, self.orders.at("places", name, key=True), "put a signal at its end")
            metres = max((self.railway.metres[k] for (k,) in ways), default=0.0)
            if not stands_on(metres, p.capacity * longest):
                trains = f"{p.capacity} trains" if p.capacity > 1 else "a train"
                text = f"{name} is to hold {trains} of {longest:g} m, and {p.at} has {metres:g} m"
                text += f", {MARGIN_M:g} m of them left by drivers at its end" if p.capacity * longest <= metres else ""
                fix = "lower its capacity" if p.capacity > 1 else "take shorter trains"
                self.sink.add("IL6009", text, self.orders.at("places", name), fix)
        for name, p in self.file.places.items():
            begin = sum(train.at == name for train in self.file.fleet.values())
            if begin > p.capacity:
                text = f"{begin} trains begin at {name}, which holds {p.capacity}"
                fix = "raise its `capacity`, or let some trains begin elsewhere"
                self.sink.add("IL6009", text, self.orders.at("places", name), fix)
        first: dict[str, str] = {}
        for number, train in self.file.fleet.items():
            at = self.file.places[train.at].at
            if at in self.sections and first.setdefault(at, number) != number:
                text = f"{number} begins in {at}, where {first[at]} stands: plans know one train in a section"
                fix = "let it begin in another section, or outside"
                self.sink.add("IL6009", text, self.orders.at("fleet", number, "at"), fix)

    def _leaves(self, under: tuple[TraversalKey, ...]) -> bool:
        return bool(self.railway.routes_on(Place(0, frozenset(), None, under), True))

    def _hours(self) -> None:
        """The time that each place works for all orders, against the shift; tonnes in the largest trains."""
        needed: dict[str, float] = {}
        for o in self.file.orders.values():
            carried = max((self.file.fleet[n].tonnes for n in o.only or self.file.fleet), default=1.0)
            trains = o.trains or math.ceil((o.tonnes or 0) / carried)
            for place in (o.from_, o.to):
                needed[place] = needed.get(place, 0.0) + trains * (self.file.places[place].minutes or 0.0) / 60
            hours = trains * (self.file.places[o.from_].minutes or 0.0) / 60
            name = next(n for n, x in self.file.orders.items() if x is o)
            if o.by is not None and o.by > self.file.shift_h:
                text = f"order {name} is due after {o.by:g} h, and the shift has {self.file.shift_h:g} h"
                self.sink.add("IL6010", text, self.orders.at("orders", name, "by"), "`by` counts from its beginning")
            if o.by is not None and hours > o.by:
                text = f"order {name} takes {hours:.2f} h of loading and is due after {o.by:g} h"
                self.sink.add(
                    "IL6010", text, self.orders.at("orders", name, "by"), "give it more time, or fewer trains"
                )
        for place, hours in needed.items():
            if hours > self.file.shift_h * self.file.places[place].capacity:
                text = f"{place} works {hours:.2f} h for these orders, in a shift of {self.file.shift_h:g} h"
                self.sink.add("IL6010", text, self.orders.at("places", place, key=True), "order less, or spread it")
        shares = [(n, o.share) for n, o in self.file.orders.items() if o.share is not None]
        total = sum(x for _, x in shares)
        if total > 1 + 1e-9:
            text = f"the shares of {', '.join(n for n, _ in shares)} add up to {total:g}, more than the whole blend"
            self.sink.add("IL6010", text, self.orders.at("orders", shares[-1][0], "share"), "write parts of 1")

    def _turns(self, found: tuple[Derived, ...]) -> None:
        """A train that runs to its loading place at full speed without a stop is there within the shift."""
        for number, train in self.file.fleet.items():
            own = [d for d in found if number in d.journeys]
            far = [(metres_to(d.journeys[number], self.file.places[d.order.from_].at), d.name, d) for d in own]
            for metres, _, d in sorted(far, reverse=True, key=lambda f: f[:2])[:1]:
                hours = metres / 1000 / train.speed
                if hours > self.file.shift_h:
                    text = f"at {train.speed:g} km/h train {number} takes {hours:.1f} h to {d.order.from_}"
                    fix = f"the shift has {self.file.shift_h:g} h; speeds are km/h"
                    self.sink.add("IL6010", text, self.orders.at("fleet", number, "speed"), fix)
