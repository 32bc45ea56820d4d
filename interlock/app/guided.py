"""A shift whose requests are ordered by a plan of the next hour, made anew whenever something has happened.

The plan knows what a dispatcher knows: orders, where trains were reported last and since when, the minutes of the
file, the trains that zones admit.  It says which idle train takes which order and when a train sets out; until then
nothing is asked for it.  Whatever it says is asked for as before, only if a completion plan exists after it.  Where
there is no plan, or nothing has gone on for a while, the rules order the requests, and that is counted.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import ceil, floor, inf

from interlock.app.setting import CYCLE_MS, Setting
from interlock.app.worked import Trip
from interlock.dispatch.assign import Assigner
from interlock.dispatch.orders import Derived
from interlock.dispatch.plan.railway import Journey, Place, Step
from interlock.dispatch.run import Run
from interlock.planning.stages import NEVER, Fleet, Hold, Piece, Staged, Turn, Under, staged
from interlock.simulate.track import LEAVES_M
from interlock.simulate.yard import SETS_OFF_S, SIGHT_M

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

RELEASED_MS, ASKED_MS = 2 * CYCLE_MS, 4 * CYCLE_MS
"""Milliseconds from a section's release until it is told, and from asking for a route until its points are driven."""


@dataclass
class Where:
    """Where a train was reported last, and since when."""

    section: str
    since_ms: int


class Guide:
    """Of one shift.  `trips`: trains with orders; `where`: where each was reported last."""

    def __init__(self, setting: Setting, trips: Mapping[str, Trip], assigner: Assigner, end_ms: int) -> None:
        self.setting, self.trips, self.assigner, self.end_ms = setting, trips, assigner, end_ms
        self.where: dict[str, Where] = {}
        self.ready: dict[str, int] = {}
        """By train: when it will have been loaded, tipped or back, as far as is known (milliseconds)."""
        self.plan: Staged | None = None
        self.plans = self.by_rules = 0
        self.granted_ms = 0
        self._made_ms = -AGAIN_MS
        self._stale = True
        self._rules_until = 0
        self.now_ms = 0
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
        self.now_ms = now_ms
        if now_ms < self._rules_until:
            return
        if self.plan is not None and now_ms - self.granted_ms > STUCK_MS and self._holds_back():
            self.by_rules += 1
            self._rules_until, self.plan = now_ms + STUCK_MS, None
            self._held.clear()
            return
        if (self._stale or self._due()) and now_ms - self._made_ms >= AGAIN_MS:
            self._make()

    def granted(self, run: str, sections: Sequence[str]) -> None:
        """A route was set for a run."""
        self.granted_ms = self.now_ms
        self._stale = True
        for train in [t for t, trip in self.trips.items() if trip.run.name == run]:
            self._used |= {(train, x) for x in sections}
            if self.trips[train].phase == "away":  # another may come for its loading place
                self.assigner.leaves(train)

    def waits(self, run: Run, step: Step) -> str:
        """Why a train waits by the plan: others use a section of the step before it; empty: it may go."""
        train = next((t for t, trip in self.trips.items() if trip.run is run), "")
        for x in dict.fromkeys(str(s) for r in step.routes for s in r.section_ids):
            users = [] if self.plan is None else self._users.get(x, [])
            if train in users:
                before = users[: users.index(train)]
                first = next((o for o in before if (o, x) not in self._used and not self._caught(o)), None)
                if first is not None:
                    self._held.setdefault(train, self.now_ms)
                    return f"another train goes first by the plan: {first} through {x}"
        self._held.pop(train, None)
        return ""

    def order(self, train: str) -> tuple[bool, Derived | None]:
        """Whether the plan decides about an idle train, and the order that it takes now; None: not yet."""
        if self.plan is None:
            return False, None
        k = self._turn.get(train)
        if k is None:
            return True, None
        if self._order[train] - LEAD_S * 1000 > self.now_ms:
            return True, None
        return True, self.setting.derived[k]

    def _caught(self, train: str) -> bool:
        """No completion plan takes a train on: nobody waits for it."""
        return train in self.trips and self.trips[train].run.caught

    def _holds_back(self) -> bool:
        """A train has been held back by nothing but the plan for as long as nothing was granted."""
        return any(self.now_ms - since > STUCK_MS for since in self._held.values())

    def _due(self) -> bool:
        """A train was to set out a while ago, and has not."""
        return any(self._made_ms < at < self.now_ms - AGAIN_MS for at in self._at.values())

    # --- the plan ------------------------------------------------------------------------------

    def _make(self) -> None:
        self._made_ms, self._stale = self.now_ms, False
        fleet, names = self._fleet()
        window = min(WINDOW_S, max(60, (self.end_ms - self.now_ms) // 1000))
        found = staged(fleet, window, WIDTH)
        self.plans += 1
        self._at, self._turn, self._order = {}, {}, {}
        for s in found.starts:
            name, at = names[s.train], self.now_ms + 1000 * s.at
            if name in self._at or name in self._order:
                continue
            if s.piece is s.turn.first and name not in self.trips:
                self._turn[name], self._order[name] = s.turn.order, at
            else:
                self._at[name] = at
        self._sequence(found, names)
        self.plan = found if found.starts else None

    def _sequence(self, found: Staged, names: Sequence[str]) -> None:
        """In which order trains use the sections.  One that is not in the plan waits for nobody."""
        sections = {n: x for x, n in self._index.items()}
        holds = [(s, h.begin, h.resource) for s in found.starts for h in s.piece.holds if h.begin is not None]
        self._users, self._used = {}, set()
        for _, train, x in sorted((s.at + begin, s.train, x) for s, begin, x in holds):
            self._users.setdefault(sections[x], []).append(names[train])

    def _fleet(self) -> tuple[Fleet, list[str]]:
        file, derived = self.setting.orders.file, self.setting.derived
        kinds: dict[object, int] = {}
        turns: list[tuple[Turn, ...]] = []
        trains: list[Under] = []
        names = list(file.fleet)
        held: set[int] = set()
        free: dict[int, int] = {}
        for name, build in file.fleet.items():
            may = [k for k, d in enumerate(derived) if name in d.journeys]
            alike = build.length, build.speed, build.at, tuple(may)
            if alike not in kinds:
                kinds[alike] = len(turns)
                turns.append(tuple(self._whole(name, k) for k in may))
            trains.append(self._under(name, kinds[alike], held, free))
        for x in held:
            free[x] = NEVER
        limit = min((z.trains for z in self.setting.layout.zones), default=1 << 20)
        given = tuple(self.assigner.given.get(d.name, 0) for d in derived)
        found = Fleet(
            tuple(trains),
            tuple(turns),
            tuple(self.assigner.left(d) for d in derived),
            tuple(free.get(x, 0) for x in range(len(self._index))),
            limit,
            given,
            tuple(d.order.share for d in derived),
        )
        return found, names

    def _whole(self, train: str, k: int) -> Turn:
        found = self._turns.get((train, k))
        if found is None:
            journey = self.setting.derived[k].journeys[train]
            found = self._turns[train, k] = self._pieces(train, k, journey.start, None)
        return found

    def _under(self, name: str, kind: int, held: set[int], free: dict[int, int]) -> Under:
        """A train as it is now."""
        trip, now = self.trips.get(name), self.now_ms
        left = max(0, (self.ready.get(name, now) - now) // 1000)
        if trip is None:
            return Under(left, kind)
        k = self.setting.derived.index(trip.order)
        file = self.setting.orders.file
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
        tips = round(60 * (self.setting.orders.file.places[trip.order.order.to].minutes or 0))
        waiting = [t for t in self.trips.values() if t.phase == "tips" and t.order.order.to == trip.order.order.to]
        ahead = [t for t in self.trips.values() if t.phase == "tipping" and t.order.order.to == trip.order.order.to]
        left = [max(0, (self.ready.get(t.train, 0) - self.now_ms) // 1000) for t in ahead]
        return (min(left) if left else 0) + tips * (1 + waiting.index(trip))

    # --- pieces --------------------------------------------------------------------------------

    def _pieces(self, train: str, k: int, place: Place, trip: Trip | None) -> Turn:
        """What is still to be done of a turn, as movements without a stop."""
        d, file = self.setting.derived[k], self.setting.orders.file
        load, tip = file.places[d.order.from_], file.places[d.order.to]
        tippler = self.name(d.order.to) if tip.capacity == 1 else None
        inner = {str(s) for z in self.setting.layout.zones for s in z.sections}
        made = _Movement(self, train, inner)
        outside = trip is None or not trip.came
        waits = file.places[file.fleet[train].at].at
        if outside:
            made.approaches(waits)
        elif trip is not None:
            made.stands(trip, load.at, waits)
        phase = "to load" if trip is None else trip.phase
        work = round(60 * (load.minutes or 0))
        first: list[tuple[_Movement, int]] = []
        there = phase != "to load"
        journey = d.journeys[train] if trip is None else trip.run.journey
        steps: list[tuple[Step | None, Place]] = [(None, place), *self._steps(journey, place)]
        for step, after in steps:
            if step is not None:
                for r in step.routes:
                    made.runs([(str(key[0]), self.setting.railway.metres[key]) for key in r.traversals])
            if not there and after.leg:
                made.arrives(load.at)
                first.append((made, work))
                there, made = True, _Movement(self, train, inner)
                made.begins(load.at)
        piece = made.piece(None, 0)
        for movement, seconds in reversed(first):
            piece = movement.piece(piece, seconds)
        return Turn(k, piece, round(60 * (tip.minutes or 0)), round(60 * tip.back), tippler)

    def _steps(self, journey: Journey, place: Place) -> list[tuple[Step | None, Place]]:
        """The steps from a place on; the shortest one where there are several."""
        found: list[tuple[Step | None, Place]] = []
        while journey.steps.get(place):
            step = min(journey.steps[place], key=lambda s: sum(r.length for r in s.routes))
            found.append((step, step.after))
            place = step.after
        return found

    def name(self, resource: str) -> int:
        """The number of a resource."""
        return self._index.setdefault(resource, len(self._index))


class _Movement:
    """What a train holds, second by second, while it runs without a stop."""

    def __init__(self, guide: Guide, train: str, inner: set[str]) -> None:
        self.guide, self.inner = guide, inner
        self.build = guide.setting.orders.file.fleet[train]
        self.speed = self.build.speed / 3.6
        self.principles = guide.setting.layout.principles
        self.metres = {str(k[0]): m for k, m in guide.setting.railway.metres.items()}
        self.seconds = 0.0
        """Until its head is where the last section so far ends."""
        self.held: dict[str, tuple[float | None, float]] = {}
        self.inside = False

    @property
    def tail(self) -> float:
        """Seconds that the train takes to pass a place."""
        return self.build.length / self.speed

    @property
    def released(self) -> float:
        """Seconds from the tail's leaving a section until another train may have it."""
        return self.principles.release_delay_s + RELEASED_MS / 1000

    @property
    def sets_off(self) -> float:
        """Seconds from asking for a route until the train has as good as run at full speed from its place."""
        gathers = self.speed / (2 * self.build.acceleration)
        return ASKED_MS / 1000 + self.principles.point_run_s + self.build.reaction + SETS_OFF_S + gathers

    def _hold(self, section: str, begin: float | None, end: float) -> None:
        old = self.held.get(section)
        if old is not None:
            begin = None if begin is None or old[0] is None else min(begin, old[0])
            end = max(end, old[1])
        self.held[section] = begin, end

    def approaches(self, boundary: str) -> None:
        """It comes from the waiting place, over the approach section."""
        line = next(b for b in self.guide.setting.track.beyond if b.name == boundary)
        self.seconds = line.approach_m / self.speed + self.speed / (2 * self.build.acceleration)
        self._hold(f"before {boundary}", 0, self.seconds + self.tail + self.released)

    def begins(self, section: str) -> None:
        """It stands wholly in a loading place, and changes direction."""
        self.inside = section in self.inner
        self.seconds = self.sets_off + max(0.0, self.metres[section] - self.build.length) / self.speed
        self._hold(section, None, self.seconds + self.tail + self.released)

    def stands(self, trip: Trip, load: str, boundary: str) -> None:
        """It is under way: where it was reported last, and what is set for it from there."""
        run, where = trip.run, self.guide.where.get(trip.train)
        ahead = [str(x) for stage in run.granted[run.at :] for x in stage.sections]
        if trip.phase != "to load" and (where is None or where.section == load):
            self.begins(load)
        elif where is None or where.section not in self.metres:
            metres = next(b for b in self.guide.setting.track.beyond if b.name == boundary).approach_m
            since = self.guide.now_ms if where is None else where.since_ms
            self._comes(metres, since, bool(ahead))
            self._hold(f"before {boundary}", None, self.seconds + self.tail + self.released)
        else:
            path = [str(x) for stage in run.granted for x in stage.sections]
            since = sum(len(stage.sections) for stage in run.granted[: max(0, run.at - 1)])
            if where.section not in path[since:]:
                path, since = [where.section, *ahead], 0
            here = path.index(where.section, since)
            ahead = path[here + 1 :]
            self._comes(self.metres[where.section], where.since_ms, bool(ahead))
            self._behind(path[: here + 1], where)
        for x in ahead:
            self.seconds += self.metres[x] / self.speed
            self._hold(x, None, self.seconds + self.tail + self.released)
        self.inside = any(x in self.inner for x in self.held)

    def _behind(self, path: Sequence[str], where: Where) -> None:
        """It holds the section in which its head is, and those behind it until its tail has left them."""
        self._hold(path[-1], None, self.seconds + self.tail + self.released)
        ran = (self.guide.now_ms - where.since_ms) / 1000
        metres = 0.0
        for x in path[-2::-1]:
            if metres > self.build.length:
                break
            self._hold(x, None, max(0.0, self.tail + metres / self.speed - ran) + self.released)
            metres += self.metres[x]

    def _comes(self, metres: float, since_ms: int, goes_on: bool) -> None:
        """To the end of the section in which it was reported last."""
        left = metres - (self.guide.now_ms - since_ms) / 1000 * self.speed
        self.seconds = left / self.speed if left > 0 else 1.0 if goes_on else self.sets_off

    def runs(self, sections: Sequence[tuple[str, float]]) -> None:
        """Over a route, which is asked for while its signal is just not in sight yet."""
        sight = self.speed / (2 * self.build.braking) + SIGHT_M / self.speed + self.build.reaction
        asked = max(0.0, self.seconds - sight - self.principles.point_run_s - ASKED_MS / 1000)
        for section, metres in sections:
            self.seconds += metres / self.speed
            self._hold(section, asked, self.seconds + self.tail + self.released)

    def arrives(self, section: str) -> None:
        """It comes to a stand at the end of its loading place."""
        self.seconds += self.speed / (2 * self.build.braking)
        begin, _ = self.held[section]
        self.held[section] = begin, inf

    def piece(self, onward: Piece | None, work: int) -> Piece:
        """The same for planning."""
        if onward is None:
            self.seconds += LEAVES_M / self.speed
        inner = [self.held[x] for x in self.held if x in self.inner]
        begins = [b for b, _ in inner if b is not None]
        holds = [
            Hold(self.guide.name(x), None if b is None else floor(b), None if e == inf else ceil(e))
            for x, (b, e) in self.held.items()
        ]
        leaves = ceil(max(e for _, e in inner)) if inner and onward is None else None
        enters = floor(min(begins)) if begins and not self.inside else None
        return Piece(tuple(holds), ceil(self.seconds), work, enters, leaves, self.inside, onward)
