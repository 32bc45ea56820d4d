"""What the words of the specification mean that tell of topology: elements of the layout, and lists of them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import Any

from interlock.checker.formula import FALSE, TRUE, Formula, every, leaf, no
from interlock.checker.lengths import Lengths
from interlock.checker.railway import Calling, Path, Railway, Run, Signal, air_locks, safe
from interlock.checker.track import Demand, Way
from interlock.checker.written import Written
from interlock.verify import Rejected


def fact(x: bool) -> Formula:
    """TRUE or FALSE."""
    return TRUE if x else FALSE


@dataclass(frozen=True)
class Entrance:
    """A boundary over which trains come in: its node, the approach or what stands for it, and the first section."""

    node: str
    outside: str
    inside: str
    signal: Signal


class Topology:
    """The words, for a layout and a written system.  `w_` before a word keeps it apart from what is not one."""

    def __init__(self, railway: Railway, written: Written) -> None:
        self.r, self.w = railway, written
        self.lengths = Lengths(railway)
        self.state = frozenset(written.state)
        self.meanings: dict[str, tuple[list[str], str]] = {}
        """Words that the specification itself explains: names of what is given, and the sentence."""

    def word(self, name: str) -> Callable[..., Any]:
        """A word by its name; raises Rejected for one that is not known."""
        found: Callable[..., Any] | None = getattr(self, f"w_{name}", None)
        if found is None:
            raise Rejected(f"the specification's word {name} is not known")
        return found

    def after(self, x: Formula) -> Formula:
        """Every state variable after the scan; what the scan has read stays."""
        if x[0] == "v":
            return leaf(x[1] + "'") if x[1] in self.state else x
        if x[0] == "!":
            return no(self.after(x[1]))
        return every(self.after(y) for y in x[1]) if x[0] == "&" else x

    def known(self, name: str) -> Formula:
        """A variable of the written system's state, or FALSE where it has none of that name."""
        return leaf(name) if name in self.state else FALSE

    def w_true(self) -> Formula:
        return TRUE

    # --- sections and their ends ---

    def w_sections(self) -> list[str]:
        return self.r.track.sections

    def w_berths(self) -> list[str]:
        return sorted(self.r.berths)

    def w_single_sections(self) -> list[str]:
        """Where one train stands at most."""
        return [s for s in self.r.track.sections if s not in self.r.berths]

    def w_berth(self, s: str) -> Formula:
        return fact(s in self.r.berths)

    def w_may_stand_in(self, s: str) -> Formula:
        """Vehicles may be left there, so that a signal at its end is closed by the first axle."""
        return fact(s in self.r.standing)

    def w_undetected(self) -> list[str]:
        return self.r.track.undetected

    def w_without_detection(self, s: str) -> Formula:
        return fact(s in self.r.track.undetected)

    def w_reported(self) -> list[str]:
        """Sections and approaches that are reported."""
        return [*(s for s in self.r.track.sections if s not in self.r.track.undetected), *self.r.approach.values()]

    def w_approaches(self) -> list[str]:
        """Sections on the lines, from which trains come or to which they go."""
        return [*self.r.approach.values()]

    def w_detected_sections(self) -> list[str]:
        """Sections inside, and the approaches from which trains come."""
        inside = [s for s in self.r.track.sections if s not in self.r.track.undetected]
        return [*inside, *(b.outside for b in self.entrances if b.node in self.r.approach)]

    def w_neighbours(self) -> list[tuple[str, str]]:
        """Sections with a joint between them, as often as they have one."""
        pairs = set()
        for s in self.r.track.sections:
            for j in self.r.track.ends[s]:
                o = self.r.track.beyond(s, j) or self.r.approach.get(j)
                if o is not None:
                    pairs.add((min(s, o), max(s, o), j))
        inside = set(self.w_detected_sections())
        return [(a, b) for a, b, _ in sorted(pairs) if {a, b} <= inside]

    def w_rear(self, n: tuple[str, str]) -> str:
        return n[0]

    def w_front(self, n: tuple[str, str]) -> str:
        return n[1]

    def w_ends(self, s: str) -> list[str]:
        return self.r.track.ends[s]

    def w_open_ends(self, s: str) -> list[str]:
        """The ends over which a train can leave: all but buffers."""
        return [j for j in self.r.track.ends[s] if j not in self.r.drawn.buffers]

    def w_joints_with_ways(self, s: str) -> list[str]:
        return [j for j in self.r.track.ends[s] if self.r.track.from_end(s, j)]

    def w_lockable_ends(self, s: str) -> list[str]:
        """The ends at which a way begins for which the section can be locked."""
        return [j for j in self.r.track.ends[s] if self.w_locked_from(s, j)]

    def w_rear_at(self, s: str, j: str) -> str:
        return self.across_of(s, j)

    def w_other_ends(self, s: str, j: str) -> list[str]:
        return [k for k in self.r.track.ends[s] if k != j]

    def w_beyond_end(self, s: str, j: str) -> list[str]:
        o = self.r.track.beyond(s, j)
        return [] if o is None else [o]

    def outside(self, j: str) -> str:
        """What lies across a boundary: its approach, or nothing that is detected."""
        return self.r.approach.get(j) or f"outside.{j}"

    def across_of(self, s: str, j: str) -> str:
        """What lies across an end of a section."""
        return self.r.track.beyond(s, j) or self.outside(j)

    @cached_property
    def entrances(self) -> list[Entrance]:
        """The boundaries over which trains come in, on a signal that they obey."""
        found = []
        for b, v in self.r.drawn.boundaries.items():
            inside = self.r.drawn.at[b][0].section
            if v.get("trains", "both") != "out":
                found.append(Entrance(b, self.outside(b), inside, self.r.main_into[b, inside]))
        return found

    def w_entrances(self) -> list[Entrance]:
        return self.entrances

    def w_outside(self, b: Entrance | str) -> str:
        return b.outside if isinstance(b, Entrance) else self.outside(b)

    def w_inside(self, b: Entrance) -> str:
        return b.inside

    def w_entry_signal(self, b: Entrance) -> Signal:
        return b.signal

    def w_approach(self, b: Entrance) -> list[str]:
        return [b.outside] if b.node in self.r.approach else []

    def w_node(self, x: Entrance | Signal) -> str:
        return x.node

    # --- ways and paths ---

    def w_ways_of(self, s: str) -> list[Way]:
        return self.r.track.ways[s]

    def w_from(self, s: str, j: str) -> list[Way]:
        return self.r.track.from_end(s, j)

    def w_leading_to(self, s: str, j: str) -> list[Way]:
        return [w for w in self.r.track.ways[s] if w.exit == j]

    def w_lockable(self, s: str) -> list[Way]:
        """The ways through a section for which it can be locked."""
        return [w for w in self.r.track.ways[s] if f"L_{safe(s)}_{w.number}" in self.state]

    def w_locked_from(self, s: str, j: str) -> list[Way]:
        return [w for w in self.w_lockable(s) if w.entry == j]

    def w_ways_out_at(self, b: str) -> list[Way]:
        """The ways that can be locked and lead over a boundary."""
        return [
            w for s in self.r.track.sections if b in self.r.track.ends[s] for w in self.w_lockable(s) if w.exit == b
        ]

    def w_section(self, w: Way) -> str:
        return w.section

    def w_entry(self, w: Way) -> str:
        return w.entry

    def w_paths(self, c: Calling) -> list[Path]:
        return self.r.paths.of(c)

    def w_train_paths(self, g: Signal) -> list[Path]:
        return self.r.paths.of(Calling(g, False))

    def w_impossible_paths(self, c: Calling) -> list[Path]:
        """The paths over which no route can lead."""
        return [p for p in self.r.paths.of(c) if not self.r.paths.can_be(c, p)]

    def w_unwanted_paths(self, c: Calling) -> list[Path]:
        """The paths of routes that the author excludes."""
        return [p for p in self.r.paths.of(c) if self.r.paths.can_be(c, p) and self.r.paths.unwanted(c, p)]

    def w_called_off_paths(self, g: Signal) -> list[Path]:
        """The paths of trains over which the author excludes the call-on route, and no other."""
        return [p for p in self.w_train_paths(g) if self.r.paths.called_off(g, p)]

    def w_runs(self, g: Signal) -> list[Run]:
        """How trains may run from a signal past others at identifier light."""
        return [u for p in self.w_train_paths(g) for u in self.r.paths.runs(p)]

    def w_runs_of(self, c: Calling) -> list[Run]:
        return [] if c.shunt else self.w_runs(c.signal)

    def w_unwanted_runs(self, g: Signal) -> list[Run]:
        """Those that no route may take, by what the author excludes or because none can."""
        c = Calling(g, False)
        return [u for u in self.w_runs(g) if self.r.paths.unwanted(c, u.whole) or not self.r.paths.can_be_run(u.whole)]

    def w_parts_of(self, u: Run) -> tuple[Path, ...]:
        return u.parts

    def w_last_part(self, u: Run) -> list[Path]:
        return [u.last]

    def w_passed_in(self, u: Run) -> tuple[Signal, ...]:
        return u.passed

    def w_passed_after(self, u: Run) -> list[Signal]:
        """The signal that a train might pass next, which can have come so far."""
        return self.r.paths.passed_after(u.last) if self.r.paths.can_be_run(u.whole) else []

    def w_ways(self, p: Path) -> tuple[Way, ...]:
        return p.ways

    def w_kept_clear(self, p: Path) -> tuple[Way, ...]:
        return p.ways[:-1] if p.berth else p.ways

    def w_berth_of(self, p: Path) -> list[str]:
        return [p.last.section] if p.berth else []

    def w_ends_beside(self, p: Path) -> list[str]:
        """The ends of the last section but that at which a path comes in."""
        return self.w_other_ends(p.last.section, p.last.entry)

    def w_first_way_and_berths(self, p: Path) -> list[Way]:
        return [w for i, w in enumerate(p.ways) if i == 0 or w.section in self.r.berths]

    def w_demands(self, p: Path) -> list[Demand]:
        return [d for w in p.ways for _, d in w.points]

    def w_powered_demands(self, p: Path) -> list[Demand]:
        return [d for d in self.w_demands(p) if d.machine in self.w_powered()]

    def w_machine(self, d: Demand) -> str:
        return d.machine

    def w_position(self, d: Demand) -> str:
        return d.position

    def w_opposite(self, d: Demand) -> str:
        return d.opposite

    # --- signals ---

    def w_signals(self) -> list[Signal]:
        return list(self.r.signals.values())

    def w_callings(self, g: Signal) -> list[Calling]:
        return g.callings

    def w_all_callings(self) -> list[Calling]:
        """Of signals that a train or movement can come to: at a boundary only where trains come in."""
        come = {b.node for b in self.entrances}
        those = [g for g in self.w_signals() if g.node not in self.r.drawn.boundaries or g.node in come]
        return [c for g in those for c in g.callings]

    def w_train_callings(self) -> list[Calling]:
        return [c for c in self.w_all_callings() if not c.shunt]

    def w_to_shunt(self, c: Calling) -> Formula:
        return fact(c.shunt)

    def w_joint_of(self, c: Calling) -> str:
        return c.signal.node

    def w_first_of(self, c: Calling) -> str:
        return c.signal.into

    def _told_so(self, key: str, values: tuple[str, ...]) -> list[Signal]:
        told = self.r.body["signals"]
        return [g for g in self.r.signals.values() if told[g.name].get(key) in values]

    def w_stop_boards(self) -> list[Signal]:
        """Where everybody's movement ends."""
        return self._told_so("kind", ("board",))

    def w_limit_boards(self) -> list[Signal]:
        """Where shunting movements end, and trains pass."""
        return self._told_so("kind", ("limit",))

    def w_shunt_signals_that_end_trains(self) -> list[Signal]:
        return self._told_so("stops_trains", ("yes", "true"))

    def w_into_of(self, g: Signal) -> str:
        return g.into

    def w_before_of(self, g: Signal) -> str:
        """The section in rear of a signal, or what lies outside."""
        return self.across_of(g.into, g.node)

    def w_before(self, c: Calling) -> str:
        return self.w_before_of(c.signal)

    def w_inside_before(self, c: Calling) -> list[str]:
        """The section in rear, where the signal stands inside the layout."""
        return [] if c.signal.node in self.r.drawn.boundaries else [self.w_before(c)]

    def w_rear_of(self, c: Calling) -> list[str]:
        """The section in rear, if it is detected at all."""
        s = self.w_before(c)
        return [] if s.startswith("outside.") else [s]

    def w_entering(self, s: str, j: str) -> list[Signal]:
        g = self.r.signal_into.get((j, s))
        return [] if g is None else [g]

    def w_callings_into(self, s: str, j: str) -> list[Calling]:
        return [c for g in self.w_entering(s, j) for c in g.callings]

    def w_trains_into(self, s: str, j: str) -> list[Calling]:
        """What a main signal there shows to trains."""
        return [c for c in self.w_callings_into(s, j) if not c.shunt and c in self.w_train_callings()]

    def w_calls_over(self, s: str, j: str) -> list[Calling]:
        """What a signal at an end of a section can show to what leaves it there."""
        return self.w_callings_into(self.r.track.beyond(s, j) or "", j)

    def w_calls_from(self, s: str) -> list[Calling]:
        return [c for g in self.r.signals_out(s) for c in g.callings]

    def w_signalless(self, s: str, j: str) -> Formula:
        """No signal governs leaving a section there."""
        return fact(not self.w_calls_over(s, j))

    def w_signalless_into(self, s: str, j: str) -> Formula:
        return fact(not self.w_entering(s, j))

    def w_unprotected(self, s: str, j: str) -> Formula:
        """No main signal governs leaving a section there."""
        return fact((j, self.r.track.beyond(s, j)) not in self.r.main_into)

    def w_unprotected_into(self, s: str, j: str) -> Formula:
        """No main signal governs entry into a section there."""
        return fact((j, s) not in self.r.main_into)

    def w_for_trains_only(self, s: str, j: str) -> Formula:
        """At a signal and at a boundary a shunting movement goes on only when it is called."""
        return fact(bool(self.w_calls_over(s, j)) or self.r.track.beyond(s, j) is None)

    def w_passed_ends(self, s: str) -> list[str]:
        """The ends at which another section joins, from which locks lead on: no main signal leads into this one."""
        return [
            j for j in self.r.track.ends[s] if self.r.track.beyond(s, j) is not None and (j, s) not in self.r.main_into
        ]

    def w_leading_over(self, s: str, j: str) -> list[Way]:
        """The ways of the section beyond an end that can be locked and lead over it."""
        o = self.r.track.beyond(s, j)
        return [] if o is None else [w for w in self.w_lockable(o) if w.exit == j]

    def w_turning_ways(self) -> list[Way]:
        """Where a train that came in at an end may turn back, as if it had come in at another: once for each pair."""
        return self._turning_ways

    @cached_property
    def _turning_ways(self) -> list[Way]:
        found: dict[tuple[str, str, str], Way] = {}
        for s in self.w_single_sections():
            for w in self.r.track.ways[s]:
                back = any(x.entry == w.exit and x.exit == w.entry for x in self.r.track.ways[s])
                if back and w.entry != w.exit and self.w_calls_over(s, w.entry):
                    found.setdefault((s, w.entry, w.exit), w)
        return list(found.values())

    # --- machines ---

    def w_machines(self) -> list[str]:
        return list(self.r.machines)

    def w_devices(self) -> list[str]:
        """Level crossings, bridges, doors: closed is reverse."""
        return list(self.r.devices)

    def w_air_lock_doors(self) -> list[str]:
        """Devices that are doors of an air lock: open is reverse."""
        return list(air_locks(self.r))

    def w_other_doors(self, m: str) -> list[str]:
        """The other doors of the same air lock."""
        locks = air_locks(self.r)
        return [d for d, lock in locks.items() if d != m and lock == locks.get(m)]

    def w_point_machines(self) -> list[str]:
        return [m for m in self.r.machines if m not in self.r.devices]

    @cached_property
    def keyed(self) -> frozenset[str]:
        """Machines that are keys of points worked by hand."""
        return frozenset(p.machine for p in self.r.drawn.points.values() if p.keyed)

    def w_keyed(self, m: str) -> Formula:
        return fact(m in self.keyed)

    def w_powered(self) -> list[str]:
        return [m for m in self.w_point_machines() if m not in self.keyed]

    def w_positions(self) -> list[str]:
        return ["N", "R"]

    def w_N(self) -> str:
        return "N"

    def w_R(self) -> str:
        return "R"

    def w_other(self, x: str) -> str:
        return "R" if x == "N" else "N"

    def w_before_position(self, x: str) -> list[str]:
        """Positions that come first where both would."""
        return ["N"] if x == "R" else []

    def w_guarded_positions(self, m: str) -> list[str]:
        """All but that a device closes."""
        return ["N"] if m in self.r.devices else ["N", "R"]

    def w_leaves_open(self, m: str, x: str) -> Formula:
        """Towards a position that may leave an overlap unready: any of a point, closed of a device."""
        return fact(m not in self.r.devices or x == "R")

    def w_sections_of(self, m: str) -> list[str]:
        return self.r.machines[m]

    def w_under(self, d: str) -> list[str]:
        return self.r.devices[d]

    def w_devices_over(self, p: Path) -> list[str]:
        return [d for d, over in self.r.devices.items() if any(w.section in over for w in p.ways)]

    def w_through(self, s: str, m: str) -> list[Way]:
        """The ways through a section that lead over a machine's points."""
        return [w for w in self.r.track.ways[s] if any(d.machine == m for _, d in w.points)]
