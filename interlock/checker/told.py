"""What the words of the specification mean that tell what is said of routes: codes of a word, and whom they name."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from itertools import combinations, pairwise
from math import comb
from typing import Any

from interlock.checker.ahead import Overlap
from interlock.checker.formula import CLAUSES, Formula, leaf
from interlock.checker.moves import World
from interlock.checker.railway import Signal, safe
from interlock.checker.track import Way


@dataclass(frozen=True)
class Wish:
    """A machine that the author has a route lock, how it lies then, in words, and why."""

    machine: str
    lies: str
    reason: str


class Telling(World):
    """Words of words."""

    called: Mapping[int, str] = {}
    """What a table calls the routes, by number, where one is read."""

    def w_name_of_route(self, r: int) -> list[str]:
        return [self.called[r]] if r in self.called else []

    def w_wishes_of(self, r: int) -> list[Wish]:
        """What the author, or an air lock, has a route lock: a machine of several demands with all of their reasons, as
        long as the longest of them holds it."""
        c, p = self.run_of(r)
        kinds = (False, True) if r in self.w_routes_calling_on() else (False,)
        asked = {id(x) for called_on in kinds for x in self._demands(c, p, called_on)}
        found: dict[tuple[str, bool], tuple[str, float]] = {}
        for x in (x for x in self.demands if id(x) in asked and "point" in x):
            key, longer = (self._machine_of(x["point"]), x["lies"] == "normal"), float(x.get("hold", 0))
            before, held = found.get(key, ("", 0.0))
            told = str(x["reason"]) not in before.split("; ")
            found[key] = "; ".join(filter(None, (before, str(x["reason"]) * told))), max(held, longer)
        return [Wish(m, self._lies(m, so), f"{x}{_longer(s)}") for (m, so), (x, s) in found.items()]

    def w_routes_declared_at_once(self) -> list[int]:
        """The routes that are declared hostile, and let that go as soon as their train is wholly in."""
        return [r for r in self.w_routes_declared() if not self.w_hold_of(r)]

    def w_seconds_held_longer(self, r: int) -> list[str]:
        return [f"{longest:g}"] if (longest := self.longest_hold(r)) else []

    def w_seconds_until_standing(self, s: str) -> list[str]:
        """How long a train must have been in a berth, wholly, until it stands before a signal from where shunting comes
        towards it; one text, of every time that there is."""
        times = {self.w.timers[self.w_standing_timer(g)][1] for g in self.w_met() if self.lengths.before(g) == s}
        return [" or ".join(f"{ms / 1000:g}" for ms in sorted(times))] if times else []

    def _lies(self, m: str, normal: bool) -> str:
        """What a machine is said to do that lies normal or reverse."""
        ends = [p for p in self.r.drawn.points.values() if p.machine == m]
        if not ends:
            told = ("shut", "open") if m in self.w_doors() else ("open", "closed")
            return told[0 if normal else 1]
        if any(p.keyed for p in ends):
            return "locked by its key" if normal else "released by its key"
        if self._derails(m):
            return "on" if normal else "off"
        return "normal" if normal else "reverse"

    def _derails(self, m: str) -> bool:
        """A machine works derailers alone."""
        ends = [p for p in self.r.drawn.points.values() if p.machine == m]
        return bool(ends) and all(p.name in (self.r.body.get("derailers") or {}) for p in ends)

    def w_told_as_points(self) -> list[str]:
        return [m for m in self.w_point_machines() if not self._derails(m)]

    def w_told_as_derailers(self) -> list[str]:
        return [m for m in self.w_point_machines() if self._derails(m)]

    def w_trailed_as_points(self) -> list[str]:
        return [m for m in self.w_powered() if not self._derails(m)]

    def w_trailed_as_derailers(self) -> list[str]:
        return [m for m in self.w_powered() if self._derails(m)]

    def w_maximum_of(self, z: str) -> list[str]:
        most = self._most(z)
        return ["one train" if most == 1 else f"{most} trains"]

    def w_entries_into(self, z: str) -> list[int]:
        """How often a route leads into a zone, of those that do."""
        inside, found = self._inside(z), set()
        for r in self.w_routes():
            _, p = self._whole(r)
            over = [self.r.track.beyond(p.ways[0].section, p.ways[0].entry), *(w.section for w in p.ways)]
            found.add(sum(b in inside and a not in inside for a, b in pairwise(over)))
        return sorted(found - {0})

    def w_groups_of(self, z: str, entries: int) -> list[tuple[str, ...]]:
        """Sections of a zone: where one of each group counts, a route that leads in so often is one too many.  Where
        there would be too many groups, some of them, in which every section stands."""
        inside = self._inside(z)
        n = len(inside)
        size = max(n - max(self._most(z) - entries, -1), 0)
        if comb(n, size) <= CLAUSES:
            return [*combinations(inside, size)]
        return [tuple((inside * 2)[i : i + size]) for i in range(n)]

    def w_each_of(self, sections: tuple[str, ...]) -> tuple[str, ...]:
        return sections

    def w_routes_over(self, w: Way) -> list[int]:
        """The routes that lead over a way themselves, in the order of their numbers."""
        return [r for r in self.w_routes() if w in self.run_of(r)[1].ways]

    def w_level_crossings(self) -> list[str]:
        """Devices that the layout lists as such; the others are bridges, doors, hoists."""
        return [str(m) for m in self.r.body.get("level_crossings") or ()]

    def w_other_devices(self) -> list[str]:
        return [str(m) for m in self.r.body.get("interlocks") or ()]

    def w_doors(self) -> list[str]:
        """Devices that are told as doors: open for trains."""
        listed = self.r.body.get("interlocks") or {}
        return [str(m) for m, v in listed.items() if v.get("kind") == "door" or v.get("air_lock")]

    def w_named_beside(self, m: str) -> list[str]:
        """The other doors of its air lock in a sentence."""
        return [" and ".join(sorted(self.w_other_doors(m)))]

    def w_devices_closed(self) -> list[str]:
        """The others: closed for trains."""
        return [m for m in self.w_other_devices() if m not in self.w_doors()]

    def w_movable(self, m: str) -> Formula:
        """The machine may be commanded elsewhere."""
        return leaf(f"MOV_{safe(m)}")

    def w_said_unknown(self) -> Formula:
        return leaf("said.unknown")

    def w_said_free(self) -> Formula:
        return leaf("said.free")

    def w_said_set(self) -> Formula:
        return leaf("said.set")

    def w_said_open(self) -> Formula:
        return leaf("said.open")

    def w_said_cancelling(self) -> Formula:
        return leaf("said.cancelling")

    def w_said_waiting(self) -> Formula:
        return leaf("said.waiting")

    def w_said_refused(self) -> Formula:
        return leaf("said.refused")

    def w_stays_open(self, r: int) -> Formula:
        """Open for the movement that has begun to pass the signal."""
        return self.known(f"PA_R{r}")

    def w_ways_locked(self, r: int) -> Formula:
        """Its ways lie and are locked, and so is its overlap."""
        return leaf(f"B_R{r}")

    def w_could_be_locked(self, r: int) -> Formula:
        """All its ways lie and are clear, and so does its overlap, in this scan."""
        return leaf(f"LK_R{r}")

    def w_granted(self, r: int) -> Formula:
        """A request for it is granted in this scan."""
        return leaf(f"G_R{r}")

    def w_side_of_entry(self, w: Way) -> list[str]:
        """What lies before a way: the neighbour, or what stands at its end."""
        return [self.r.track.beyond(w.section, w.entry) or w.entry]

    def w_side_of_exit(self, w: Way) -> list[str]:
        return [self.r.track.beyond(w.section, w.exit) or w.exit]

    def w_signal_of_overlap(self, o: Overlap) -> list[Signal]:
        return [o.signal]

    def w_number_of_overlap(self, o: Overlap) -> list[int]:
        return [o.number]

    def w_lamps_reported(self) -> list[Signal]:
        return [*self.r.signals.values()] if self.r.drawn.asks("lamp_proof") else []

    def w_stop_lamp(self, g: Signal) -> Formula:
        """The stop lamp is reported intact."""
        return leaf(f"RL_{g.safe}")

    def from_and_to(self, r: int) -> tuple[str, set[str]]:
        """The signal from which a route leads, and what its end is called: the signal, boundary or buffer there, or the
        section in which it ends."""
        c, p = self._whole(r)
        ahead = self.r.signal_into.get((p.last.exit, self.r.track.beyond(p.last.section, p.last.exit) or ""))
        return c.name, {p.last.exit, p.last.section, *([ahead.name] if ahead is not None else [])}

    def leads_so(self, x: Mapping[str, Any], r: int) -> bool:
        """A route leads from where to where the author says, past signals with an identifier light, too."""
        return self.r.paths.chosen(x, *self._whole(r))


def _longer(seconds: float) -> str:
    """For how long a machine is held after the route's train has come in."""
    return f"; held {seconds:g} s longer" if seconds else ""
