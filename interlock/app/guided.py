"""A shift whose requests are ordered by a plan of the next hour, made anew whenever something has happened.

The plan knows what a dispatcher knows: orders, where trains were reported last and since when, the minutes of the
file, the trains that zones admit.  It says which idle train takes which order and when it sets out, and in which order
trains use each section: who comes later waits, by the order and not by the clock, since plans are late.  Whatever it
says is asked for as before, only if a completion plan exists after it.  Where there is no plan, or nothing has gone on
for a while, the rules order the requests, and that is counted.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from math import ceil, floor

from interlock.app.movement import Demands, Movement, Where
from interlock.app.setting import Setting
from interlock.app.worked import Trip
from interlock.dispatch.assign import Assigner
from interlock.dispatch.orders import Derived
from interlock.dispatch.plan.errands import Place, Step
from interlock.dispatch.plan.railway import Journey
from interlock.dispatch.run import Run
from interlock.planning.stages import NEVER, Fleet, Staged, Turn, Under, staged

WINDOW_S = 5400
"""Seconds for which is planned (our choice): more than two turns of heishan."""

WIDTH = 20
"""States that are kept from stage to stage (our choice)."""

AGAIN_MS = 15_000
"""A plan is kept for so long at least."""

LEAD_S = 3
"""Seconds by which a train may be asked for before the plan's time."""

STUCK_MS = 300_000
"""When nothing was granted for so long though a train is held back by the plan, the rules take over for as long."""


class Guide:
    """Of one shift.  `trips`: trains with orders; `where`: where each was reported last."""

    def __init__(
        self,
        setting: Setting,
        trips: Mapping[str, Trip],
        assigner: Assigner,
        end_ms: int,
        demands: Demands = Demands(),  # noqa: B008 - frozen
    ) -> None:
        self._demands = demands
        self._setting, self.trips, self._assigner, self._end_ms = setting, trips, assigner, end_ms
        self.where: dict[str, Where] = {}
        self.ready: dict[str, int] = {}
        """By train: when it will have been loaded, tipped or back, as far as is known (milliseconds)."""
        self._plan: Staged | None = None
        self.plans = self.by_rules = 0
        self._granted_ms = 0
        self._made_ms = -AGAIN_MS
        self._stale = True
        self._rules_until = 0
        self._now_ms = 0
        """Milliseconds since the shift began."""
        self._order: dict[str, int] = {}
        self._at: dict[str, int] = {}
        self._users: dict[str, list[str]] = {}
        """By section: which trains use it by the plan, in order."""
        self._used: set[tuple[str, str]] = set()
        """Trains with sections that were set for them since the plan was made."""
        self._held: dict[str, int] = {}
        self._turn: dict[str, int] = {}
        self._index: dict[str, int] = {}
        self._turns: dict[tuple[str, int], Turn] = {}

    # --- what is asked of it -------------------------------------------------------------------

    def happened(self) -> None:
        """Something has changed: the plan is made anew when it is due."""
        self._stale = True

    def look(self, now_ms: int) -> None:
        """Time has passed."""
        self._now_ms = now_ms
        if now_ms < self._rules_until:
            return
        if self._plan is not None and now_ms - self._granted_ms > STUCK_MS and self._holds_back():
            self.by_rules += 1
            self._rules_until, self._plan = now_ms + STUCK_MS, None
            self._held.clear()
            return
        if (self._stale or self._due()) and now_ms - self._made_ms >= AGAIN_MS:
            self._make()

    def granted(self, run: str, sections: Sequence[str]) -> None:
        """A route was set for a run."""
        self._granted_ms = self._now_ms
        self._stale = True
        for train in [t for t, trip in self.trips.items() if trip.run.name == run]:
            self._used |= {(train, x) for x in sections}
            if self.trips[train].phase == "away":  # another may come for its loading place
                self._assigner.leaves(train)

    def waits(self, run: Run, step: Step) -> str:
        """Why a train waits by the plan: others use a section of the step before it; empty: it may go."""
        train = next((t for t, trip in self.trips.items() if trip.run is run), "")
        for x in dict.fromkeys(str(s) for r in step.routes for s in r.path.section_ids):
            users = [] if self._plan is None else self._users.get(x, [])
            if train in users:
                before = users[: users.index(train)]
                first = next((o for o in before if (o, x) not in self._used and not self._caught(o)), None)
                if first is not None:
                    self._held.setdefault(train, self._now_ms)
                    return f"another train goes first by the plan: {first} through {x}"
        self._held.pop(train, None)
        return ""

    def order(self, train: str) -> tuple[bool, Derived | None]:
        """Whether the plan decides about an idle train, and the order that it takes now; None: not yet."""
        if self._plan is None:
            return False, None
        k = self._turn.get(train)
        if k is None:
            return True, None
        if self._order[train] - LEAD_S * 1000 > self._now_ms:
            return True, None
        return True, self._setting.derived[k]

    def _caught(self, train: str) -> bool:
        """No completion plan takes a train on: nobody waits for it."""
        return train in self.trips and bool(self.trips[train].run.caught)

    def _holds_back(self) -> bool:
        """A train has been held back by nothing but the plan for as long as nothing was granted."""
        return any(self._now_ms - since > STUCK_MS for since in self._held.values())

    def _due(self) -> bool:
        """A train was to set out a while ago, and has not."""
        return any(self._made_ms < at < self._now_ms - AGAIN_MS for at in self._at.values())

    # --- the plan ------------------------------------------------------------------------------

    def _make(self) -> None:
        self._made_ms, self._stale = self._now_ms, False
        fleet, names = self.fleet()
        window = min(WINDOW_S, max(60, (self._end_ms - self._now_ms) // 1000))
        found = staged(fleet, window, WIDTH)
        self.plans += 1
        self._at, self._turn, self._order = {}, {}, {}
        for s in found.starts:
            name, at = names[s.train], self._now_ms + 1000 * s.at
            if name in self._at or name in self._order:
                continue
            if s.piece is s.turn.first and name not in self.trips:
                self._turn[name], self._order[name] = s.turn.order, at
            else:
                self._at[name] = at
        self._sequence(found, names)
        self._plan = found if found.starts else None

    def _sequence(self, found: Staged, names: Sequence[str]) -> None:
        """In which order trains use the sections.  One that is not in the plan waits for nobody."""
        sections = {n: x for x, n in self._index.items()}
        holds = [(s, h.begin, h.resource) for s in found.starts for h in s.piece.holds if h.begin is not None]
        self._users, self._used = {}, set()
        for _, train, x in sorted((s.at + begin, s.train, x) for s, begin, x in holds):
            self._users.setdefault(sections[x], []).append(names[train])

    def fleet(self) -> tuple[Fleet, list[str]]:
        """All trains as they are now, with their names; of trains alike who has been ready longest comes first."""
        file, derived = self._setting.orders.file, self._setting.derived
        kinds: dict[object, int] = {}
        turns: list[tuple[Turn, ...]] = []
        trains: list[Under] = []
        names = sorted(file.fleet, key=lambda n: self.ready.get(n, 0))
        held: set[int] = set()
        free: dict[int, int] = {}
        for name in names:
            build = file.fleet[name]
            may = [k for k, d in enumerate(derived) if name in d.journeys]
            alike = build.length, build.speed, build.at, tuple(may)
            if alike not in kinds:
                kinds[alike] = len(turns)
                turns.append(tuple(self._whole(name, k) for k in may))
            trains.append(self._under(name, kinds[alike], held, free))
        for x in held:
            free[x] = NEVER
        limit = min((z.trains for z in self._setting.layout.declared.zones), default=1 << 20)
        given = tuple(self._assigner.given.get(d.name, 0) for d in derived)
        found = Fleet(
            tuple(trains),
            tuple(turns),
            tuple(self._assigner.left(d) for d in derived),
            tuple(free.get(x, 0) for x in range(len(self._index))),
            limit,
            given,
            tuple(d.order.share for d in derived),
        )
        return found, names

    def _whole(self, train: str, k: int) -> Turn:
        found = self._turns.get((train, k))
        if found is None:
            journey = self._setting.derived[k].journeys[train]
            found = self._turns[train, k] = self._pieces(train, k, journey.start, None)
        return found

    def _under(self, name: str, kind: int, held: set[int], free: dict[int, int]) -> Under:
        """A train as it is now."""
        trip, now = self.trips.get(name), self._now_ms
        left = max(0, (self.ready.get(name, now) - now) // 1000)
        if trip is None:
            return Under(left, kind)
        k = self._setting.derived.index(trip.order)
        file = self._setting.orders.file
        tip = file.places[trip.order.order.to]
        whole = self._whole(name, k)
        if trip.phase in ("tips", "tipping"):
            if trip.phase == "tipping" and whole.tippler is not None:
                free[whole.tippler] = max(free.get(whole.tippler, 0), left)
            done = left if trip.phase == "tipping" else self._queue(trip)
            return Under(done + ceil(60 * tip.back), kind, tipped=done)
        turn = self._pieces(name, k, trip.run.place, trip)
        for h in turn.first.holds:
            if h.begin is None:
                held.add(h.resource)
        ready = left if trip.phase == "loads" else 0
        return Under(ready, kind, turn, turn.first)

    def _queue(self, trip: Trip) -> int:
        """Seconds until a train that stands before the tippler has been tipped."""
        tips = round(60 * (self._setting.orders.file.places[trip.order.order.to].minutes or 0))
        waiting = [t for t in self.trips.values() if t.phase == "tips" and t.order.order.to == trip.order.order.to]
        ahead = [t for t in self.trips.values() if t.phase == "tipping" and t.order.order.to == trip.order.order.to]
        left = [max(0, (self.ready.get(t.train, 0) - self._now_ms) // 1000) for t in ahead]
        return (min(left) if left else 0) + tips * (1 + waiting.index(trip))

    # --- pieces --------------------------------------------------------------------------------

    def _pieces(self, train: str, k: int, place: Place, trip: Trip | None) -> Turn:
        """What is still to be done of a turn, as movements without a stop."""
        d, file = self._setting.derived[k], self._setting.orders.file
        load, tip = file.places[d.order.from_], file.places[d.order.to]
        tippler = self._name(d.order.to) if tip.capacity == 1 else None
        made = Movement(self._setting, train, self._demands)
        outside = trip is None or not trip.came
        waits = file.places[file.fleet[train].at].at
        if outside:
            made.approaches(waits)
            if trip is not None:
                made.comes_in(trip)
        elif trip is not None:
            made.stands(trip, self.where.get(train), self._now_ms, load.at, waits)
        phase = "to load" if trip is None else trip.phase
        work = round(60 * (load.minutes or 0))
        first: list[tuple[Movement, int]] = []
        there = phase != "to load"
        journey = d.journeys[train] if trip is None else trip.run.journey
        steps: list[tuple[Step | None, Place]] = [(None, place), *self._steps(journey, place)]
        for step, after in steps:
            if step is not None:
                for r in step.routes:
                    made.runs([(str(key[0]), self._setting.railway.metres[key]) for key in r.path.traversals])
            if not there and after.leg:
                made.arrives(load.at)
                first.append((made, work))
                there, made = True, Movement(self._setting, train, self._demands)
                made.begins(load.at)
        piece = made.piece(self._name, None, 0)
        for movement, seconds in reversed(first):
            piece = movement.piece(self._name, piece, seconds)
        return Turn(k, piece, round(60 * (tip.minutes or 0)), round(60 * tip.back), tippler)

    def _steps(self, journey: Journey, place: Place) -> list[tuple[Step | None, Place]]:
        """The steps from a place on, past what is blocked; the shortest one where there are several."""
        found: list[tuple[Step | None, Place]] = []
        steps = journey.past(self._setting.shut)
        while steps.get(place):
            step = min(steps[place], key=lambda s: sum(r.path.length for r in s.routes))
            found.append((step, step.after))
            place = step.after
        return found

    def _name(self, resource: str) -> int:
        """The number of a resource."""
        return self._index.setdefault(resource, len(self._index))


def demanded(setting: Setting, hours: float, demands: Demands, widths: Sequence[int]) -> Staged:
    """The best plan from the beginning of a shift with work of fixed length, as the guide counts movements."""
    assigner = Assigner(setting.orders.file, setting.derived)
    fleet, _ = Guide(setting, {}, assigner, round(3_600_000 * hours), demands).fleet()
    return min((staged(fleet, floor(3600 * hours), w) for w in widths), key=lambda s: (-len(s.tipped), s.tipped[-1:]))
