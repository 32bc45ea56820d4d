"""What a driver is called over: looked at once, when he takes a proceed for himself.

Harm that an accident would show later, if it came to one: proceed into track that is occupied or blocked, over points
and devices that are not detected, against an external condition, onto an overlap that is not clear, clear before a
signal at stop, or a speed that the path does not permit.  What was shown may be one scan old (A-LATE-OUTPUT): only what
was wrong in the inputs of the last two scans counts.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from math import inf, isinf
from typing import TYPE_CHECKING

from interlock.model.elements import Position
from interlock.model.portable import portable
from interlock.simulate.track import NONE
from interlock.simulate.train import Train

if TYPE_CHECKING:
    from interlock.simulate.world import World

LONGEST = 60
"""Stretches of a path at most, so that a loop ends."""


def told_kmh(speeds: Sequence[tuple[int, Sequence[str]]], signal: int, shown: Mapping[str, int]) -> float:
    """The speed (km/h) that a signal's indicators permit; without one any.  `speeds`: outputs by speed, by signal."""
    return max((kmh for kmh, names in speeds if shown.get(names[signal])), default=inf)


class Called:
    """Looks at the paths over which signals call trains."""

    def __init__(self, world: World) -> None:
        self.world, self.track = world, world.track
        layout, t = world.layout, world.track
        section = {s: i for i, s in enumerate(t.sections)}
        signal = {s: i for i, s in enumerate(t.signals)}
        self.blocked = [f"BLK_{portable(s)}" for s in t.sections]
        self.over_section: dict[int, list[str]] = {}
        self.at_signal: dict[int, list[str]] = {}
        self.at_exit: dict[int, list[str]] = {}
        goes = {b.name: b.goes for b in t.beyond}
        for c in layout.signalling.conditions:
            name = f"E_{portable(str(c.id))}"
            for places, by, number in (
                (c.over, self.over_section, section),
                (c.signals, self.at_signal, signal),
                (c.exits, self.at_exit, goes),
            ):
                for x in places:
                    by.setdefault(number[str(x)], []).append(name)
        self.devices: dict[int, list[tuple[int, str]]] = {}
        """By section, the devices over it, and how each is said to be when no train may pass."""
        for d in layout.signalling.devices:
            for x in d.over:
                told = t.machines.index(str(d.id)), layout.machines.word(d.id, Position.NORMAL)
                self.devices.setdefault(section[str(x)], []).append(told)
        edge = {str(e.id): i for i, e in enumerate(layout.track.edges)}
        self.slow = {edge[str(p.reverse)]: p.speed for p in layout.pointwork.points if p.speed is not None}
        self.permits = [s.speed for s in layout.track.sections]

    def over(self, t: Train, signal: int, shown: Mapping[str, int]) -> None:
        """A driver accepts a signal."""
        w = self.world
        if len(w.reports.past) < 2:
            return
        (now, _), (before, _) = w.reports.past

        def lacking(name: str) -> bool:
            return not now.get(name, 1) and not before.get(name, 1)

        clear, caution, *_, identifier = w.drivers.lit[signal]
        trusts = not t.driver.shunting and any(map(shown.get, (clear, caution, identifier)))
        wrong: list[str] = []
        if lacking("VALID"):
            wrong.append("while inputs are lost")
        wrong += [f"against {n}" for n in self.at_signal.get(signal, ()) if lacking(n)]
        path, end = self._path(t, signal)
        wrong += self._ground(t, path, trusts, lacking)
        wrong += self._zones(t, path)
        if trusts:
            wrong += self._overlap(t, end, told_kmh(w.drivers.speeds, signal, shown))
            wrong += self._aspects(t, path, end, signal, shown)
        for what in wrong:
            name = self.track.signals[signal]
            w.watch.tell(w.clock, f"called {t.number} {name} {what}", f"{name} calls train {t.number} {what}")

    def _path(self, t: Train, signal: int) -> tuple[list[int], int]:
        """The stretches from a signal to the next one that counts, as points lie, and that signal or NONE."""
        s, sight = self.track.stretches, self.world.sight
        d = self.track.begins[signal]
        found = [d]
        while not s[d].outside and len(found) < LONGEST:
            d = sight.follows(s[d])
            if d == NONE or d in found:
                break
            if s[d].signal != NONE and (sight.main[s[d].signal] or t.driver.shunting):
                return found, s[d].signal
            found.append(d)
        return found, NONE

    def _ground(self, t: Train, path: list[int], trusts: bool, lacking: Callable[[str], bool]) -> list[str]:
        s, wrong = self.track.stretches, []
        sections = dict.fromkeys(s[d].section for d in path if s[d].section != NONE and not s[d].outside)
        for n, x in enumerate(sections):
            name = self.track.sections[x]
            wrong += [f"against {e}" for e in self.over_section.get(x, ()) if lacking(e)]
            wrong += [
                f"over {self.track.machines[m]}, {w}" for m, w in self.devices.get(x, ()) if self._undetected(m, 1)
            ]
            if all(past.get(self.blocked[x], 0) for past, _ in self.world.reports.past):
                wrong.append(f"into {name}, blocked")
            berth = t.driver.shunting and x in self.track.berths
            if self._occupied(t, x, trusts or n == 0) and not berth:
                wrong.append(f"into {name}, occupied")
        wrong += self._points(path)
        last = s[path[-1]]
        if last.outside and not t.driver.shunting:
            wrong += [f"against {e}" for e in self.at_exit.get(path[-1], ()) if lacking(e)]
            if last.section != NONE and self._occupied(t, last.section, True):
                wrong.append(f"onto {self.track.sections[last.section]}, occupied")
        return wrong

    def _zones(self, t: Train, path: list[int]) -> list[str]:
        """Zones on the path in which there are as many other trains as there may be."""
        s, wrong = self.track.stretches, []
        over = {s[d].section for d in path}
        for name, most, inside in self.world.watch.limits:
            if over.isdisjoint(inside) or not inside.isdisjoint(t.under.sections):
                continue
            others = {o.origin for o in self.world.trains if not inside.isdisjoint(o.under.sections)} - {t.origin}
            if len(others) >= most:
                wrong.append(f"into {name}, where {len(others)} are")
        return wrong

    def _points(self, path: list[int]) -> list[str]:
        """Points of a path that were not detected as it needs them."""
        s, machines, wrong = self.track.stretches, self.world.machines, []
        for d in path:
            m = s[d].machine
            if m == NONE:
                continue
            ends = s[d].facing
            needs = s[d].needs if ends is None else machines.lies[m]
            if machines.hand[m]:
                needs = 0 if machines.lies[m] == 0 else needs
            if needs != NONE and self._undetected(m, needs):
                wrong.append(f"over {self.track.machines[m]}, not detected")
        return wrong

    def _undetected(self, m: int, position: int) -> bool:
        """Whether a machine was not reported in a position, in both scans."""
        names = self.world.machines.contacts.names[m]
        yes, no = names[position], names[1 - position]
        return all(not past[yes] or past[no] for past, _ in self.world.reports.past)

    def _occupied(self, t: Train, x: int, trusts: bool) -> bool:
        """Whether another vehicle was in a section in both scans; where reports are trusted, and was reported."""
        if x in t.under.sections:
            return False
        clear = self.world.reports.clear[x]
        return all(count[x] and not (trusts and past.get(clear)) for past, count in self.world.reports.past)

    def _overlap(self, t: Train, end: int, told: float) -> list[str]:
        """What stands in the overlap of the signal at the end, for the speed that he is told, and which points of it
        were not detected."""
        if end == NONE:
            return []
        metres = self.world.drivers.overlap(end, told).metres
        endless = isinf(metres)
        s, sight, d, found = self.track.stretches, self.world.sight, self.track.begins[end], []
        while metres > 0.0 and d != NONE and not s[d].outside and d not in found:
            found.append(d)
            metres -= s[d].metres
            d = sight.follows(s[d])
            if endless and d != NONE and s[d].signal != NONE and sight.main[s[d].signal]:
                break
        last = found[:-1] if metres <= 0.0 else found  # points at its far end are beyond it
        wrong = [f"to an overlap {x}" for x in self._points(last)]
        for x in dict.fromkeys(s[d].section for d in found):
            if self._occupied(t, x, True):
                wrong.append(f"to an overlap in {self.track.sections[x]}, occupied")
        return wrong

    def _aspects(self, t: Train, path: list[int], end: int, signal: int, shown: Mapping[str, int]) -> list[str]:
        """Clear before a signal at stop; a speed that the path does not permit, or the overlap at its end."""
        w, s, wrong = self.world, self.track.stretches, []
        clear, *_, identifier = w.drivers.lit[signal]
        if shown.get(identifier):
            return []  # it tells a driver nothing: the signal before has
        for _ in range(LONGEST):  # he passes those at identifier light
            if end == NONE or not shown.get(w.drivers.lit[end][-1]):
                break
            beyond, end = self._path(t, end)
            path = [*path, *beyond]
        if shown.get(clear) and w.drivers.three and end != NONE:
            after = w.drivers.lit[end]
            if not any(shown.get(x) for x in after[:2]):
                wrong.append(f"by clear, though {self.track.signals[end]} is at stop")
        told = [kmh for kmh, names in w.drivers.speeds if shown.get(names[signal])]
        made = w.drivers.overlap(end, told_kmh(w.drivers.speeds, signal, shown)).kmh if end != NONE else None
        if made is not None and (not told or max(told) > made):
            wrong.append(f"at {max(told, default='any')} km/h to an overlap for {made} km/h")
        for d in path:
            for most in (self.slow.get(s[d].edge), self.permits[s[d].section] if s[d].section != NONE else None):
                if most is not None and told and max(told) > most:
                    wrong.append(f"at {max(told)} km/h over track for {most} km/h")
        return wrong
