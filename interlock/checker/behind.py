"""Approach locking, and what has come in behind a signal (R8, R9), in the words of the specification."""

from __future__ import annotations

from functools import cached_property

from interlock.checker.formula import FALSE, TRUE, Formula, every, no, some
from interlock.checker.lamps import CALL_ON, IDENTIFIER, MAIN, WHITE
from interlock.checker.lengths import Approach, until_arrived
from interlock.checker.railway import Signal, safe
from interlock.checker.terminals import Terminals
from interlock.checker.words import fact


class Behind(Terminals):
    """What the specification says of trains before a signal and behind it."""

    def w_nobody_on_the_way(self, g: Signal) -> Formula:
        """No train can be about to pass the signal: back to the braking distance, and to the first main signal that
        announces it, nothing is reported, where a way on from there is locked."""
        return no(self._on_the_way(self.lengths.approach(g), TRUE))

    def w_nobody_reported_on_the_way(self, g: Signal) -> Formula:
        """The same as far as there is detection."""
        return no(self._on_the_way(self.lengths.approach(g), FALSE))

    def _on_the_way(self, x: Approach, unseen: Formula) -> Formula:
        if x.section is None or x.section in self.r.track.undetected:
            return unseen
        further = (every((self.w_locked(w), self._on_the_way(y, unseen))) for w, y in x.further)
        return some((no(self.w_steadily_clear(x.section)), *further, *([unseen] if x.ends_early else [])))

    def w_rear_cleared(self, s: str) -> Formula:
        """The controller remembers that it was used, and seen that it was by a movement."""
        return self.known(f"RC_{safe(s)}")

    def w_at_once(self, s: str) -> Formula:
        """The controller remembers that it was read occupied in one scan with what is ahead of it."""
        return self.known(f"AO_{safe(s)}")

    def w_with_rear_detected(self) -> list[Signal]:
        """The signals that trains obey, where what comes to them is seen in the section in rear."""
        undetected = {None, *self.r.track.undetected}
        return [g for g in self.w_opening() if g.main and self.lengths.before(g) not in undetected]

    def w_with_rear_detected_into(self, s: str) -> list[Signal]:
        return [g for g in self.w_with_rear_detected() if g.into == s]

    def w_alone_timer(self, s: str) -> str:
        return f"OA_{safe(s)}"

    def w_seen_alone(self) -> list[str]:
        """First sections where what is in rear does not tell whether all has come in."""
        into = [g.into for g in (*self.w_shunting_from(), *self.w_from_undetected())]
        return list(dict.fromkeys(into))

    def w_shunting_from(self) -> list[Signal]:
        """The signals from which shunting movements are set."""
        return [g for g in self.w_opening() if self._routes_by(g, WHITE)]

    def w_shunting_from_into(self, s: str) -> list[Signal]:
        return [g for g in self.w_shunting_from() if g.into == s]

    def w_from_undetected(self) -> list[Signal]:
        """The signals that trains obey, where nothing is seen in the section in rear."""
        undetected = {None, *self.r.track.undetected}
        mains = [g for g in self.w_opening() if g.main and self._routes_by(g, (*MAIN, *CALL_ON, *IDENTIFIER))]
        return [g for g in mains if self.lengths.before(g) in undetected]

    def w_from_undetected_into(self, s: str) -> list[Signal]:
        return [g for g in self.w_from_undetected() if g.into == s]

    def w_rear_detected(self, g: Signal) -> Formula:
        return fact(self.lengths.before(g) not in {None, *self.r.track.undetected})

    @cached_property
    def _met(self) -> list[Signal]:
        """See `w_met`."""
        those = [self.run_of(r) for r in self.w_routes()]
        ends = {(p.last.section, p.last.exit) for c, p in those if not c.shunt}
        begins = {(p.last.section, p.last.entry) for _, p in those if p.berth}
        return [g for g in self.w_signals() if g.main and (self.lengths.before(g), g.node) in ends & begins]

    def w_met(self) -> list[Signal]:
        """The signals before which train routes end in a berth, and over whose joint shunt routes end there."""
        return self._met

    def w_met_without_overlap(self) -> list[Signal]:
        return [g for g in self._met if g.name not in self.lengths.overlaps]

    def w_until_arrived(self, g: Signal) -> int:
        return until_arrived(self.lengths, g)

    def w_is_one_of_these(self, t: str) -> Formula:
        """Something says how long the timer must be."""
        sections = (*self.w_sections(), *self.w_approaches())
        known = {self.w_restart_timer(), *self.w_start_timers(), *map(self.w_release_timer, sections)}
        known |= {*map(self.w_alone_timer, self.w_seen_alone())}
        known |= {*map(self.w_late_timer, self.w_machines()), *map(self.w_approach_timer, self.w_opening())}
        known |= {
            *map(self.w_standing_timer, (*self.w_standing_timed(), *self._met)),
            *map(self.w_hand_timer, self.w_tokens()),
        }
        return fact(t in known)
