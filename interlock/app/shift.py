"""One shift: the fleet of a dispatch file on the emitted runtime, commanded by the dispatcher, event by event.

Trains wait outside their boundary, are given orders, run by signals to where they are loaded, are loaded, run out, are
tipped, and come back.  All is written to the record.  The same seed gives the same bytes.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import partial
from random import Random
from typing import Any

from interlock.app.attending import OPERATOR_S, Attendant
from interlock.app.guided import Guide
from interlock.app.movement import Where
from interlock.app.setting import CYCLE_MS, Setting
from interlock.app.standing import ways_under
from interlock.app.worked import Options, Planning, Trip, Worked
from interlock.dispatch import Dispatcher
from interlock.dispatch.assign import Assigner
from interlock.dispatch.causes import cause
from interlock.dispatch.describer import DOUBT, Describer
from interlock.dispatch.dispatcher import REOPENS_MS, waiting
from interlock.dispatch.orders import Derived
from interlock.dispatch.panel import Stage
from interlock.dispatch.plan.errands import NoVoyage, TooManyPlaces
from interlock.dispatch.run import ways
from interlock.model.elements import RouteId, SectionId
from interlock.record.log import END, Chain
from interlock.simulate.agenda import Agenda
from interlock.simulate.driving import Build, Rolling
from interlock.simulate.mishaps import Mishaps
from interlock.simulate.scans import Scans
from interlock.simulate.yard import Yard

TO_BE_LOADED = "it is to be loaded"

LOOKS_S = 10.0
"""Seconds after which the dispatcher looks at a panel on which nothing has changed."""

QUIET_S = 1800.0
"""Seconds beside the longest work in which nothing happens, after which all that have orders stand for ever."""


class StaysLocked(Exception):
    """Sections that nobody can release after the restart; says which."""


class Shift:
    """A shift under way."""

    def __init__(self, setting: Setting, seed: int, options: Options) -> None:
        self._setting, self._options = setting, options
        self._file = setting.orders.file
        self.agenda = Agenda()
        self.scans = Scans(setting.names, CYCLE_MS)
        self.worked = Worked(seed)
        self._chain, self._lines = Chain(), list[bytes]()
        self._zero_ms = 0
        self._telling = False
        self._work = Random(f"{seed} work")
        self.yard = Yard(setting.track, self.scans.inputs, self.agenda, Random(f"{seed} yard"), self._say)
        driving = self.yard.driving
        driving.stopped, driving.gone, driving.entered = self._stopped, self._gone, self._entered
        fleet = frozenset(self._file.fleet)
        self._describer = Describer(setting.layout, setting.symbols, fleet)
        self._assigner = Assigner(self._file, setting.derived, options.how)
        self._idle = list(self._file.fleet)
        self._trips: dict[str, Trip] = {}
        self._tipping: dict[str, list[str]] = {}
        self._lost = dict.fromkeys(self._file.fleet, 0)
        self._waits: dict[str, tuple[str, int]] = {}
        self._progress_ms = 0
        self._stepped_ms = 0
        self._fresh = True
        hours = options.hours or self._file.shift_h
        self._guide = Guide(setting, self._trips, self._assigner, round(3_600_000 * hours)) if options.planned else None
        self._dispatcher = Dispatcher(
            setting.railway,
            setting.symbols,
            rule=options.rule,
            look_ahead=options.look_ahead,
            guide=self._guide.waits if self._guide is not None else lambda run, step: "",
            told=self._said,
        )
        self._attendant = Attendant(
            setting,
            self.yard,
            self._dispatcher,
            self._describer,
            self._trips,
            lambda: self.scans.seen,
            self._alarm,
            self._look,
        )
        self._mishaps = Mishaps(self.yard, Random(f"{seed} faults"), options.faults, self._lost_wagon)
        work = [p.minutes or 0.0 for p in self._file.places.values()]
        self._quiet_ms = round(1000 * (QUIET_S + 120 * max([*work, *(p.back for p in self._file.places.values())])))

    # --- the record --------------------------------------------------------------------------------

    def _say(self, kind: str, **fields: Any) -> None:
        if self._telling:
            line = self._chain.line(self.agenda.now_ms - self._zero_ms, kind, fields)
            if self._options.keep:
                self._lines.append(line)
        if kind in ("enters", "stands", "comes", "leaves", "loaded", "tipped", "mended"):
            self._progress_ms = self.agenda.now_ms

    # --- the run -----------------------------------------------------------------------------------

    def run(self) -> Worked:
        """From the restart to the end of the shift."""
        self._restart()
        hours = self._options.hours or self._file.shift_h
        self._say("begin", **self._setting.heading(self.worked.seed, hours))
        end = self._zero_ms + round(3_600_000 * hours)
        self.agenda.after(OPERATOR_S, self._attendant.operate)
        self._mishaps.begin()
        if self._guide is not None:
            self._guide.look(0)
        self._give()
        self._advance(end)
        self._end()
        return self.worked

    def _restart(self) -> None:
        """Nobody is in yet: everything is released, then the shift begins.  Raises `StaysLocked`."""
        self.yard.inputs.write("RELALL", 1)
        latest = round(1000 * QUIET_S) + sum(self.scans.presets.values())
        while (locked := self._locked()) or not self.scans.runs:
            if not self._scan(latest):
                raise StaysLocked(f"{' and '.join(locked)} cannot be released after the restart: no shift begins")
        self.yard.inputs.write("RELALL", 0)
        for s in self._setting.blocked:
            self.yard.inputs.write(self._setting.symbols.sections.blocked[s], 1)
        self._zero_ms = self._progress_ms = self._stepped_ms = self.agenda.now_ms
        self._telling = True

    def _locked(self) -> list[str]:
        """The sections that are shown locked."""
        named, shown = self._setting.symbols.indication, self.scans.outputs
        return [str(s.id) for s in self._setting.layout.track.sections if shown.get(named.get(f"locked {s.id}", ""))]

    def _advance(self, end: int) -> None:
        while self._scan(end):
            if self._fresh:
                self._dispatch()
            if self.agenda.now_ms - self._progress_ms > self._quiet_ms and self._trips:
                self.worked.wrong.standstill = True
                stood = {n: self._why(trip) or "its signal is open" for n, trip in sorted(self._trips.items())}
                self.worked.wrong.stood = stood
                self._say("standstill", waiting=stood)
                return

    def _scan(self, end: int) -> bool:
        """What happens next: an event of the world, or a scan; False where the end comes first."""
        event, due = self.agenda.next_ms(), self.scans.due(self.yard.inputs.changed_ms)
        times = [t for t in (event, due) if t is not None]
        if not times or min(times) > end:
            self.agenda.now_ms = end
            return False
        self.agenda.now_ms = min(times)
        if event is not None and event == self.agenda.now_ms:
            self.agenda.step()
            return True
        self.yard.inputs.changed_ms = None
        if self.scans.scan(self.agenda.now_ms):
            self._fresh = True
            self.yard.shown(self.scans.outputs)
            rear = self._setting.symbols.cancellation.approach_of
            self._describer.step(self.scans.seen, ways(self._dispatcher.runs, rear, self._describer.occupied))
        return True

    # --- the dispatcher ----------------------------------------------------------------------------

    def _dispatch(self) -> None:
        self._fresh = False
        d = self._dispatcher
        dt = self.agenda.now_ms - self._stepped_ms
        self._stepped_ms = self.agenda.now_ms
        before, asked, said = d.holding.refused, len(d.journal.asked), len(d.journal.said)
        self._attendant.in_doubt()
        if self._guide is not None:
            self._guide.look(self._now)
            self._give()
        for name, value in d.step(self.scans.seen, dt).items():
            self.yard.inputs.write(name, value)
        for name, value in self._describer.writes().items():
            self.yard.inputs.write(name, value)  # taken back by whoever has looked
        if d.holding.refused != before:
            self.worked.delays.refused += d.holding.refused - before
        for train, route in d.journal.asked[asked:]:
            if self._guide is not None:
                self._guide.granted(train, [str(x) for x in self._dispatcher.stages[RouteId(route)].sections])
            self._say("granted", train=train, route=route)
        for text in d.journal.said[said:]:
            if text.startswith(("no plan", "UNKNOWN")) or "taken back" in text:
                self._alarm(text)
        self._holds()
        self._turn()
        self._come()
        self._wait()
        rests = [r.asking.rest_ms / 1000 for r in d.runs if r.asking.rest_ms]
        if d.runs or d.pending or self._guide is not None:
            self.agenda.after(min([LOOKS_S, *rests]), self._look, "dispatch")

    def _look(self) -> None:
        self._fresh = True

    def _holds(self) -> None:
        """Nothing is asked for a train that is to be loaded first; one that was given up is commanded again."""
        for trip in self._trips.values():
            run = trip.run
            if trip.phase == "to load" and run.place.leg:
                self._dispatcher.held.setdefault(run.name, TO_BE_LOADED)
            elif self._dispatcher.held.get(run.name) == TO_BE_LOADED:
                del self._dispatcher.held[run.name]
            if trip.train not in self._describer.alarms and self._dispatcher.held.get(run.name, "").startswith(DOUBT):
                del self._dispatcher.held[run.name]
            r = self.yard.rolling.get(trip.train)
            live = run in self._dispatcher.runs or run in self._dispatcher.pending
            if (
                r is not None
                and not live
                and (run.way.ahead or not run.finished)
                and r.motion.stands <= self.yard.clock
            ):
                self._again(trip, r)

    def _again(self, trip: Trip, r: Rolling) -> None:
        """A command from where a train stands."""
        legs = trip.run.journey.errand.legs
        start = ways_under(self._setting.railway, self._setting.track, r.train, self.yard.machines.lies)
        here = trip.order.order.from_
        left = legs[1:] if trip.phase == "away" else legs
        if trip.phase == "to load" and self._file.places[here].at == start[-1][0]:
            left, trip.phase = legs[1:], "at place"
        errand = replace(trip.run.journey.errand, start=start, legs=left)
        try:
            trip.run = self._dispatcher.carry_out(errand)
        except (NoVoyage, TooManyPlaces) as error:
            self._alarm(f"{trip.train}: {error}")
            return
        self._say("commanded", train=trip.train, order=trip.order.name, at=str(start[-1][0]))
        self._fresh = True

    def _turn(self) -> None:
        """Trains change ends for a route that was granted; or back again, where one the other way was taken back."""
        while self._dispatcher.journal.steps:
            name, section, turned = self._dispatcher.journal.steps.pop(0)
            trip = next(t for t in self._trips.values() if t.run.name == name)
            if not turned and trip.turned != section:
                continue
            r = self.yard.rolling[trip.train]
            if r.train.view.target == self._setting.track.signals.index(trip.run.way.granted[-1].entry):
                continue  # it has turned for a route that was taken back
            trip.turned = section
            self._say("turns", train=trip.train, section=section)
            self.yard.driving.turns(r)

    def _come(self) -> None:
        """The next of those that were commanded comes towards each boundary, once the dispatcher counts on it, while
        no other is to run out there, or runs out."""
        rows, ways = self._setting.railway.table.route, [r.way for r in self._dispatcher.runs]
        before = {str(rows[x.route].exit) for way in ways for x in way.granted[max(0, way.at - 1) :]}
        for trip in self._trips.values():
            if trip.came:
                continue
            at = self._file.places[self._file.fleet[trip.train].at].at
            if at not in before and trip.run in self._dispatcher.runs and self.yard.room(at):
                trip.came = True
                self._waits.pop(trip.train, None)
                self.yard.comes(trip.train, self._build(trip.train), at)
            before.add(at)

    def _build(self, train: str) -> Build:
        """A train of the fleet in m/s."""
        t = self._file.fleet[train]
        return Build(t.length, t.speed / 3.6, t.acceleration, t.braking, t.reaction)

    def _wait(self) -> None:
        """Why trains stand, wherever that has changed."""
        why = waiting(self._dispatcher)
        for trip in self._trips.values():
            r = self.yard.rolling.get(trip.train)
            stands = not trip.came or (r is not None and r.motion.stands <= self.yard.clock)
            if not stands or trip.phase in ("loads", "tips"):
                self._ends_wait(trip.train)
                continue
            text = why.get(trip.run.name, "") or (self._why(trip) if trip.run.way.shut_ms >= REOPENS_MS else "")
            if not text:
                continue
            kind = cause(text) if trip.came else "another train goes first" if "before" in text else cause(text)
            old = self._waits.get(trip.train)
            if old is None or old[0] != kind:
                self._ends_wait(trip.train)
                self._waits[trip.train] = (kind, self.agenda.now_ms)
                self._say("waits", train=trip.train, cause=kind, text=text)

    def _why(self, trip: Trip) -> str:
        """Why a train stands; empty while its signal is open."""
        way, place = trip.run.way, self._file.places[trip.order.order.from_].at
        if trip.phase in ("loads", "tips", "tipping"):
            return f"it {'is being loaded' if trip.phase == 'loads' else 'tips'}"
        if way.ahead:
            stage = way.granted[way.at]
            shut = not stage.shown.open(self.scans.seen)
            return f"{stage.entry} does not open for {stage.route}: {self._said(stage) or 'it is set'}" if shut else ""
        said = waiting(self._dispatcher).get(trip.run.name, "")
        return said or (f"it is to stand in {place}" if trip.phase == "to load" else "nothing more is asked for it")

    def _said(self, stage: Stage) -> str:
        """What the controller says of a route: why it is refused, or what it waits for."""
        _, text = self.scans.controller.status(stage.route)
        return str(text)

    def _ends_wait(self, train: str) -> None:
        old = self._waits.pop(train, None)
        if old is not None:
            delays = self.worked.delays
            delays.longest_wait_s = max(delays.longest_wait_s, (self.agenda.now_ms - old[1]) / 1000)

    # --- work --------------------------------------------------------------------------------------

    def _give(self) -> None:
        """Orders for the trains that have none."""
        for train in tuple(self._idle):
            order = self._order(train)
            if order is None:
                if train not in self._waits:
                    self._waits[train] = ("no order", self.agenda.now_ms)
                    self._say("waits", train=train, cause="no order", text=self._assigner.why(train))
                continue
            self._idle.remove(train)
            self._ends_wait(train)
            run = self._dispatcher.carry_out(order.journeys[train].errand)
            self._trips[train] = Trip(train, order, run, self.agenda.now_ms)
            self._say("ordered", train=train, order=order.name, load=order.order.from_, tip=order.order.to)
            self._describer.expects(str(order.journeys[train].errand.start[0][0]), train)
            self._fresh = True

    def _order(self, train: str) -> Derived | None:
        """The order for an idle train: that of the plan, if there is one."""
        decides, order = self._guide.order(train) if self._guide is not None else (False, None)
        if not decides:
            return self._assigner.next(train)
        return order if order is not None and self._assigner.takes(train, order) else None

    @property
    def _now(self) -> int:
        """Milliseconds since the shift began."""
        return self.agenda.now_ms - self._zero_ms

    def _entered(self, r: Rolling, section: str) -> None:
        trip = self._trips[r.name]
        if self._guide is not None:
            self._guide.where[r.name] = Where(section, self._now)
        place = self._file.places[trip.order.order.from_]
        loading = {p.at for p in self._file.places.values() if p.kind == "loading"}
        if section in loading and section != place.at and section not in trip.run.journey.sections:
            self.worked.wrong.places += 1
            self._alarm(f"{r.name} comes into {section}, and is ordered to {place.at}")

    def _stopped(self, r: Rolling) -> None:
        trip = self._trips[r.name]
        place = trip.order.order.from_
        at = self._file.places[place].at
        under = {self._setting.track.sections[x] for x in r.sections}
        if trip.phase in ("to load", "at place") and under == {at}:
            trip.phase = "loads"
            self._dispatcher.held[trip.run.name] = "it is being loaded"
            self._describer.read(SectionId(at), r.name)
            self._say("loads", train=r.name, place=place, ore=trip.order.order.ore or "")
            self._works(trip, place, lambda: self._loaded(trip))
        self._fresh = True

    def _works(self, trip: Trip, place: str, what: Callable[[], None]) -> None:
        """Work begins; the dispatcher expects that it takes the minutes of the file."""
        self.agenda.after(self._time(place), what)
        self._expects(trip.train, self._file.places[place].minutes or 0.0)

    def _expects(self, train: str, minutes: float) -> None:
        if self._guide is not None:
            self._guide.ready[train] = self._now + round(60_000 * minutes)
            self._guide.happened()

    def _time(self, place: str) -> float:
        """Seconds of work at a place: between four fifths and seven fifths of what the file says, most often that."""
        spread = 1.0 if self._options.steady else self._work.triangular(0.8, 1.4, 1.0)
        return 60.0 * (self._file.places[place].minutes or 0.0) * spread

    def _loaded(self, trip: Trip) -> None:
        trip.phase = "away"
        trip.run.reason = ""
        self._expects(trip.train, 0)
        self._dispatcher.held.pop(trip.run.name, None)
        self._say("loaded", train=trip.train, place=trip.order.order.from_)
        self._fresh = True

    def _gone(self, r: Rolling, where: str) -> None:
        trip = self._trips[r.name]
        place = trip.order.order.to
        self._assigner.leaves(r.name)
        if trip.phase != "away" or self._file.places[place].at != where:
            self.worked.wrong.places += 1
            self._alarm(f"{r.name} leaves over {where}, and is ordered to {self._file.places[place].at}")
        trip.phase = "tips"
        queue = self._tipping.setdefault(place, [])
        queue.append(r.name)
        self._give()
        self._tips(place)

    def _tips(self, place: str) -> None:
        """The next train at a tippler that has room."""
        queue = self._tipping[place]
        for train in queue[: self._file.places[place].capacity]:
            trip = self._trips[train]
            if trip.phase == "tips":
                trip.phase = "tipping"
                self._say("tips", train=train, place=place)
                self._works(trip, place, partial(self._tipped, trip))

    def _tipped(self, trip: Trip) -> None:
        place, order = trip.order.order.to, trip.order
        self._tipping[place].remove(trip.train)
        whole = self._file.fleet[trip.train]
        tonnes = whole.tonnes * (1 - self._lost[trip.train] / whole.wagons)
        self._lost[trip.train] = 0
        self._assigner.short(order, whole.tonnes - tonnes)
        self.worked.tipped[order.name] = self.worked.tipped.get(order.name, 0) + 1
        if order.order.by is not None:
            late = self._now > order.order.by * 3_600_000
            self.worked.late[order.name] = self.worked.late.get(order.name, 0) + late
        self.worked.brought[order.name] = self.worked.brought.get(order.name, 0.0) + tonnes
        ore = order.order.ore or "ore"
        self.worked.tonnes[ore] = self.worked.tonnes.get(ore, 0.0) + tonnes
        self._say(
            "tipped",
            train=trip.train,
            place=place,
            order=order.name,
            ore=order.order.ore or "",
            tonnes=round(tonnes, 3),
        )
        del self._trips[trip.train]
        self._dispatcher.end(trip.run.name)
        self._dispatcher.held.pop(trip.run.name, None)
        self._expects(trip.train, self._file.places[place].back)
        if self._guide is not None:
            self._guide.where.pop(trip.train, None)
        self.agenda.after(60.0 * self._file.places[place].back, lambda: self._back(trip.train))
        self._tips(place)

    def _back(self, train: str) -> None:
        self._say("back", train=train)
        self._expects(train, 0)
        self._idle.append(train)
        self._give()

    # --- what goes wrong ---------------------------------------------------------------------------

    def _alarm(self, text: str) -> None:
        self.worked.alarms.append(text)
        self._say("alarm", text=text)

    def _lost_wagon(self, train: str, section: str) -> None:
        self._lost[train] += 1

    # --- the end -----------------------------------------------------------------------------------

    def _end(self) -> None:
        w, yard = self.worked, self.yard
        for train in tuple(self._waits):
            self._ends_wait(train)
        wrong = w.wrong
        wrong.hazards, wrong.passed_at_stop = list(yard.watch.found), list(yard.driving.passed_at_stop)
        if self._guide is not None:
            w.planning = Planning(self._guide.plans, self._guide.by_rules)
        w.scans, w.movements = self.scans.runs, yard.driving.movements
        w.seconds = (self.agenda.now_ms - self._zero_ms) / 1000
        for text in (*wrong.hazards, *wrong.passed_at_stop):
            self._say("hazard", text=text)
        self._say(END, trains=w.trains, scans=w.scans, movements=w.movements, held_back=w.delays.refused)
        w.chain = self._chain.digest
        w.log = b"".join(self._lines)
