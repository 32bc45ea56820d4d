"""Who attends a shift: looks where a number is in doubt, releases by hand, confirms, takes back what nobody needs."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial

from interlock.app.setting import Setting
from interlock.app.worked import Trip
from interlock.dispatch import Dispatcher
from interlock.dispatch.describer import DOUBT, Describer
from interlock.dispatch.run import Run
from interlock.model.elements import SectionId
from interlock.simulate.yard import Yard

OPERATOR_S = 60.0
"""Seconds from one look of the operator at what was left locked to the next."""

RELEASE_S = 200.0
"""Seconds for which a release by hand is held: longer than any approach locking delay (our choice)."""

CONFIRMS_S = 300.0
"""Seconds until somebody has looked where a number is in doubt, or wagons are missing."""


class Attendant:
    """One for a shift.  `seen`: what the panel shows; `alarm`: who is told; `look`: the dispatcher is to look."""

    def __init__(
        self,
        setting: Setting,
        yard: Yard,
        dispatcher: Dispatcher,
        describer: Describer,
        trips: Mapping[str, Trip],
        seen: Callable[[], Mapping[str, int]],
        alarm: Callable[[str], None],
        look: Callable[[], None],
    ) -> None:
        self.setting, self.yard, self.dispatcher, self.describer = setting, yard, dispatcher, describer
        self.trips, self.seen, self.alarm, self.look = trips, seen, alarm, look
        self._told: set[str] = set()

    def in_doubt(self) -> None:
        """Alarms of the describer: nothing is asked for their trains until somebody has looked."""
        for number, text in self.describer.alarms.items():
            if number not in self._told:
                self._told.add(number)
                self.alarm(f"{number}: {text}")
                self.yard.agenda.after(CONFIRMS_S, partial(self._looked, number))
            trip = self.trips.get(number)
            if trip is not None:
                self.dispatcher.held.setdefault(trip.run.name, f"{DOUBT}: {text}")

    def _looked(self, number: str) -> None:
        """Somebody has looked: what is there is described, what was left behind is taken away."""
        self._told.discard(number)
        self.describer.alarms.pop(number, None)
        r = self.yard.rolling.get(number)
        if r is not None and r.sections:
            self.describer.confirm(SectionId(self.setting.track.sections[r.sections[-1]]), number)
        for s in [s for s, n in self.describer.blocked.items() if n == number]:
            self.describer.looked(s)
            self.yard.inputs.write(self.setting.symbols.sections.blocked[s], 0)
        self.look()

    def operate(self) -> None:
        """What stays locked for nobody is cancelled and released by hand, points that were trailed are confirmed."""
        seen = self.seen()
        near = {s for run in self.dispatcher.runs for s in run.way.wanted(seen) | self._beyond(run)}
        for s in self.setting.layout.track.sections:
            name = self.setting.release.get(s.id)
            locked = self.setting.symbols.indication.get(f"locked {s.id}")
            if name is None or locked is None:
                continue
            clear = seen.get(self.setting.symbols.sections.clear[s.id], 0)
            if seen.get(locked) and clear and s.id not in near:
                self._press(name, RELEASE_S)
                self._cancel(s.id)
        ahead = {s.entry for run in self.dispatcher.runs for s in run.way.granted[run.way.at :]}
        opened = {s.entry for s in self.dispatcher.stages.values() if s.entry not in ahead and s.shown.open(seen)}
        for g in sorted(opened):
            self._press(self.setting.symbols.cancellation.cancel[g], 1.0)
        for name in self.setting.confirms:
            if seen.get(name.replace("TC_", "YT_", 1)):
                self._press(name, 1.0)
        self.yard.agenda.after(OPERATOR_S, self.operate)

    def _beyond(self, run: Run) -> set[SectionId]:
        """The sections of the overlaps of its routes: they are given up when its train stands, or has gone on."""
        rows = [self.setting.railway.table.route[s.route] for s in run.way.granted[max(0, run.way.at - 1) :]]
        return {s for r in rows if r.locking.overlap is not None for s, _ in r.locking.overlap.ways}

    def _cancel(self, first: SectionId) -> None:
        """A route that begins in a section may still be set, since nobody was seen to pass its signal."""
        for g in sorted({x.entry for x in self.dispatcher.stages.values() if x.sections[0] == first}):
            self._press(self.setting.symbols.cancellation.cancel[g], 1.0)

    def _press(self, name: str, seconds: float) -> None:
        self.yard.inputs.write(name, 1)
        self.yard.say("pressed", button=name)
        self.yard.agenda.after(seconds, lambda: self.yard.inputs.write(name, 0), name)
