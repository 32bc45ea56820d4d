"""What the words of the specification mean: topology from the layout, variables from the written system."""

from __future__ import annotations

from collections.abc import Callable
from functools import cached_property
from itertools import pairwise
from typing import Any

from interlock.checker.formula import FALSE, TRUE, Formula, every, leaf, no, some
from interlock.checker.railway import Demand, Edge, Path, Railway, Signal, Way
from interlock.checker.written import Written
from interlock.verify import Rejected

MINE = {"line_speed_kmh": 20.0, "braking_ms2": 0.4, "reaction_s": 4.0, "output_delay_s": 1.0, "restart_delay_s": 600.0}
MINE |= {"approach_release_s": 60.0, "release_delay_s": 3.0, "point_supervision_s": 13.0, "point_run_s": 6.0}
MINE |= {"fouling_m": 8.0, "clearance_m": 3.5}
"""The principles of the profile `mine`, where a layout states no others."""

LAMPS = ("YP", "YY")
"""Outputs that show clear and caution at a main signal."""


def safe(name: str) -> str:
    """A layout's name as part of a variable."""
    return name.replace("-", "_").replace("/", "_")


class Terms:
    """The words, for a layout and a written system.  `w_` before a word keeps it apart from what is not one."""

    def __init__(self, railway: Railway, written: Written) -> None:
        self.r, self.w = railway, written
        self.state = frozenset(written.state)

    def word(self, name: str) -> Callable[..., Any]:
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

    def _known(self, name: str) -> Formula:
        """A variable of the written system's state, or FALSE where it has none of that name."""
        return leaf(name) if name in self.state else FALSE

    # --- topology ---

    def w_sections(self) -> list[str]:
        return self.r.sections

    def w_detected_sections(self) -> list[str]:
        """Sections inside, and the approaches from which trains come."""
        return [*self.r.sections, *(a for b, a in self.r.approach.items() if self._comes_from(b))]

    def _comes_from(self, b: str) -> bool:
        return str(self.r.boundaries[b].get("trains", "both")) != "out"

    def w_neighbours(self) -> list[tuple[str, str]]:
        pairs = set()
        for s in self.r.sections:
            for j in self.r.ends[s]:
                o = self.r.beyond(s, j) or self.r.approach.get(j)
                if o is not None:
                    pairs.add((min(s, o), max(s, o), j))
        inside = set(self.w_detected_sections())
        return [(a, b) for a, b, _ in sorted(pairs) if {a, b} <= inside]

    def w_rear(self, n: tuple[str, str]) -> str:
        return n[0]

    def w_front(self, n: tuple[str, str]) -> str:
        return n[1]

    def w_machines(self) -> list[str]:
        return [str(p) for p in self.r.points]

    def w_positions(self) -> list[str]:
        return ["N", "R"]

    def w_signals(self) -> list[Signal]:
        return list(self.r.signals.values())

    def w_paths(self, g: Signal) -> list[Path]:
        return self.r.paths(g.name)

    def w_ways(self, p: Path) -> Path:
        return p

    def w_section(self, w: Way) -> str:
        return w.section

    def w_entry(self, w: Way) -> str:
        return w.entry

    def w_demands(self, p: Path) -> list[Demand]:
        return [d for w in p for _, d in w.points]

    def w_machine(self, d: Demand) -> str:
        return d.machine

    def w_position(self, d: Demand) -> str:
        return d.position

    def w_opposite(self, d: Demand) -> str:
        return d.opposite

    def w_ends(self, s: str) -> list[str]:
        return self.r.ends[s]

    def w_from(self, s: str, j: str) -> list[Way]:
        """The ways through a section from one of its ends."""
        return [w for w in self.r.ways[s] if w.entry == j]

    def w_sections_of(self, m: str) -> list[str]:
        return [str(self.r.points[m]["section"])]

    def w_comings(self, s: str) -> list[tuple[str, str]]:
        """Where heads may come into a section: joint, and the section that they come from."""
        found = []
        for j in self.r.ends[s]:
            if j in self.r.buffers:
                continue
            o = self.r.beyond(s, j) or self.r.approach.get(j) or f"outside.{j}"
            if f"head.{j}.{o}" in self.w.definitions:
                found.append((j, o))
        return found

    def w_joint(self, c: tuple[str, str]) -> str:
        return c[0]

    def w_leaving(self, s: str) -> list[Signal]:
        """The signals before which what stands in a section stands."""
        found = [(j, self.r.beyond(s, j)) for j in self.r.ends[s]]
        return [g for j, o in found if o is not None and (g := self.r.signal_into.get((j, o))) is not None]

    def w_entering(self, s: str, j: str) -> list[Signal]:
        g = self.r.signal_into.get((j, s))
        return [] if g is None else [g]

    def w_locked_from(self, s: str, j: str) -> list[Way]:
        return [w for w in self.w_from(s, j) if f"L_{safe(s)}_{w.number}" in self.state]

    def w_leading(self, s: str) -> list[Way]:
        """The ways that can be locked and lead into a section past no main signal."""
        found = []
        for j in self.r.ends[s]:
            o = self.r.beyond(s, j)
            if o is not None and (j, s) not in self.r.signal_into:
                found += [w for w in self.r.ways[o] if w.exit == j and f"L_{safe(o)}_{w.number}" in self.state]
        return found

    def w_ends_without_signal(self, s: str) -> list[str]:
        """The ends at which another section joins and no signal leads into this one."""
        return [j for j in self.r.ends[s] if self.r.beyond(s, j) is not None and (j, s) not in self.r.signal_into]

    def w_leading_over(self, s: str, j: str) -> list[Way]:
        """The ways of the section beyond an end that can be locked and lead over it."""
        return [w for w in self.w_leading(s) if w.exit == j]

    def w_conditions(self, g: Signal, p: Path) -> list[str]:
        out = []
        for name, v in (self.r.body.get("conditions") or {}).items():
            over, exits = set(v.get("over") or ()), set(v.get("exits") or ())
            if g.name in (v.get("signals") or ()) or any(w.section in over for w in p) or p[-1].exit in exits:
                out.append(str(name))
        return out

    def w_beyond(self, p: Path) -> list[str]:
        """The line beyond, where the path leads over a boundary and the approach section is reported."""
        a = self.r.approach.get(p[-1].exit)
        return [a] if a is not None else []

    def w_routes(self) -> list[int]:
        """The controller's routes, by number."""
        return sorted(int(n[3:]) for n in self.state if n.startswith("S_R") and n[3:].isdigit())

    def w_timers(self) -> list[str]:
        return list(self.w.timers)

    # --- who shows proceed over what ---

    @cached_property
    def _over(self) -> dict[tuple[str, int], Formula]:
        found: dict[tuple[str, int], list[Formula]] = {}
        for g in self.r.signals.values():
            for p in self.r.paths(g.name):
                there = every((self.w_shows(g), self.w_lies(p)))
                for w in p:
                    found.setdefault((w.section, w.number), []).append(there)
        return {k: some(xs) for k, xs in found.items()}

    def _pairs(self, s: str, opposing: bool) -> list[tuple[Way, Way]]:
        ways = [w for w in self.r.ways[s] if (s, w.number) in self._over]
        return [
            (a, b)
            for i, a in enumerate(ways)
            for b in ways[i + 1 :]
            if (a.entry == b.exit or a.exit == b.entry) is opposing
        ]

    def w_opposing(self, s: str) -> list[tuple[Way, Way]]:
        return self._pairs(s, True)

    def w_following(self, s: str) -> list[tuple[Way, Way]]:
        return self._pairs(s, False)

    def w_first(self, c: tuple[Way, Way]) -> Way:
        return c[0]

    def w_second(self, c: tuple[Way, Way]) -> Way:
        return c[1]

    def w_shown_over(self, w: Way) -> Formula:
        return self._over[w.section, w.number]

    def w_past(self, g: Signal) -> Formula:
        """Some signal shows proceed over a path that passes this one."""
        found = []
        for h in self.r.signals.values():
            for p in self.r.paths(h.name):
                if any((a.exit, b.section) == (g.node, g.into) for a, b in pairwise(p)):
                    found.append(every((self.w_shows(h), self.w_lies(p))))
        return some(found)

    # --- flanks ---

    def w_lockable(self, s: str) -> list[Way]:
        """The ways through a section for which it can be locked."""
        return [w for w in self.r.ways[s] if f"L_{safe(s)}_{w.number}" in self.state]

    def w_points_on(self, w: Way) -> list[tuple[str, Demand]]:
        return list(w.points)

    def w_through(self, s: str, m: str) -> list[Way]:
        """The ways through a section that lead over a machine's point."""
        return [w for w in self.r.ways[s] if any(d.machine == m for _, d in w.points)]

    def w_shown_by(self, w: Way) -> Formula:
        """Some signal from which a path leads over a way shows proceed."""
        return some(self.w_shows(g) for g in self.r.signals.values() if any(w in p for p in self.r.paths(g.name)))

    def w_exposed(self, x: tuple[str, Demand]) -> Formula:
        """A vehicle could roll over the other leg of a point, from beyond the next signal that could hold it, as the
        points really lie."""
        point, d = x
        told = self.r.points[point].get("fouling")
        needed = (float(told) if told is not None else self._rule("fouling_m")) + self._rule("clearance_m")
        leg = f"{point}.{'normal' if d.opposite == 'N' else 'reverse'}"
        return self._rolls(next(e for e in self.r.edges if e.name == leg), point, 0.0, needed, frozenset({point}))

    def _rolls(self, e: Edge, node: str, gone: float, needed: float, seen: frozenset[str]) -> Formula:
        if e.one_way and e.a == node:
            return FALSE
        far = e.b if e.a == node else e.a
        gone += e.length
        if far in seen or far in self.r.buffers:
            return FALSE
        g = self.r.signal_into.get((far, e.section))
        if g is not None and gone >= needed:
            return some((self.w_shows(g), leaf(f"lamp.{g.name}"), self.w_accepted(g)))
        if far in self.r.boundaries:
            return TRUE if self._comes_from(far) else FALSE
        others = [x for x in self.r.at[far] if x is not e]
        if far not in self.r.points or e.name == f"{far}.toe":
            return some(self._rolls(x, far, gone, needed, seen | {far}) for x in others)
        toe = next(x for x in others if x.name == f"{far}.toe")
        away = "R" if e.name == f"{far}.normal" else "N"
        return every((no(leaf(f"at.{far}.{away}")), self._rolls(toe, far, gone, needed, seen | {far})))

    # --- the world ---

    def w_occupied(self, s: str) -> Formula:
        return leaf(f"o.{s}")

    def w_standing(self, s: str) -> Formula:
        """What is in the section has stood there since the restart and was not called."""
        return leaf(f"rest.{s}")

    def w_came(self, s: str, j: str) -> Formula:
        return leaf(f"in.{s}.{j}")

    def w_comes(self, c: tuple[str, str]) -> Formula:
        return leaf(f"head.{c[0]}.{c[1]}")

    def w_comes_at(self, s: str, j: str) -> Formula:
        """A head comes into a section at one of its ends."""
        return some(self.w_comes(c) for c in self.w_comings(s) if c[0] == j)

    def w_starts(self, m: str, x: str) -> Formula:
        """A machine begins to leave a position."""
        return leaf(f"start.{m}.{x}")

    def w_accepted(self, g: Signal) -> Formula:
        return leaf(f"go.{g.name}")

    def w_lies(self, x: Any, position: str | None = None) -> Formula:
        """A machine really lies so; all machines of a way or a path do."""
        if isinstance(x, str):
            return leaf(f"at.{x}.{position}")
        ways = (x,) if isinstance(x, Way) else x
        return every(leaf(f"at.{d.machine}.{d.position}") for w in ways for _, d in w.points)

    def w_heading(self, s: str, g: Signal) -> Formula:
        """The train in a section heads for a signal, as the points lie."""
        ways = [w for w in self.r.ways[s] if w.exit == g.node]
        return some(every((self.w_came(s, w.entry), self.w_lies(w))) for w in ways)

    # --- terminals ---

    def w_valid(self) -> Formula:
        return leaf("VALID")

    def w_clear(self, s: str) -> Formula:
        return leaf(f"CLR_{safe(s)}")

    def w_falsely(self, s: str) -> Formula:
        """Reported occupied, though nobody is there before or after."""
        o = self.w_occupied(s)
        return every((no(self.w_clear(s)), no(o), no(self.after(o)), self.w_valid()))

    def w_detected(self, m: str, x: str) -> Formula:
        return leaf(f"D{x}_{safe(m)}")

    def w_holds(self, c: str) -> Formula:
        return leaf(f"E_{safe(c)}")

    def w_blocked(self, s: str) -> Formula:
        return leaf(f"BLK_{safe(s)}")

    def w_cancel(self, g: Signal) -> Formula:
        return leaf(f"CAN_{safe(g.name)}")

    def w_lamps(self, g: Signal) -> list[str]:
        return [f"{k}_{safe(g.name)}" for k in LAMPS if f"{k}_{safe(g.name)}" in self.state]

    def w_lit(self, lamp: str) -> Formula:
        return leaf(lamp)

    def w_shows(self, g: Signal) -> Formula:
        return some(map(leaf, self.w_lamps(g)))

    def w_open(self, g: Signal) -> Formula:
        return self.w_shows(g)

    def w_stop(self, g: Signal) -> Formula:
        return leaf(f"YS_{safe(g.name)}")

    def w_driven(self, m: str, x: str) -> Formula:
        return leaf(f"Y{x}_{safe(m)}")

    def w_told_locked(self, s: str) -> Formula:
        return leaf(f"YL_{safe(s)}")

    def w_told_late(self, m: str) -> Formula:
        return leaf(f"YA_{safe(m)}")

    def w_told_trailed(self, m: str) -> Formula:
        return leaf(f"YT_{safe(m)}")

    # --- clocks and timers ---

    def w_stopped(self, g: Signal) -> Formula:
        """Stop has been shown without a break for the time that a train needs."""
        return leaf(f"long.stop.{g.name}")

    def w_cancelled_long(self, g: Signal) -> Formula:
        """The controller's own approach locking delay is over."""
        return leaf(f"AT_{safe(g.name)}")

    def w_covered(self, g: Signal) -> Formula:
        """History: since that delay began, stop was shown."""
        return leaf(f"cov.AT_{safe(g.name)}")

    def w_over(self, t: str) -> Formula:
        return leaf(t)

    def w_waits(self, t: str) -> Formula:
        return leaf(self.w.timers[t][0])

    def w_late(self, m: str) -> Formula:
        return leaf(f"ST_{safe(m)}")

    def w_long_enough(self, g: Signal) -> bool:
        return self.w.timers[f"AT_{safe(g.name)}"][1] >= self.need_of_stop(g)

    def need_of_stop(self, g: Signal) -> int:
        """Until a train that saw proceed has passed or stands: delay of outputs, reaction, braking (milliseconds)."""
        rear = self.r.approach.get(g.node) if g.node in self.r.boundaries else self.r.beyond(g.into, g.node)
        return self._halt(self._speed(rear))

    def _rule(self, name: str) -> float:
        return float((self.r.body.get("principles") or {}).get(name, MINE[name]))

    def _speed(self, section: str | None) -> float:
        told = (self.r.body.get("sections") or {}).get(section or "", {}).get("speed")
        return float(told) if told is not None else self._rule("line_speed_kmh")

    def _halt(self, kmh: float) -> int:
        wait = self._rule("output_delay_s") + self._rule("reaction_s")
        return round(1000 * (wait + kmh / 3.6 / self._rule("braking_ms2")))

    def _need_of_restart(self) -> int:
        """Until every train stands that ran at a power cut: on to the next signal at half the speed, then a halt."""
        metres = {e.name: e.length for e in self.r.edges}
        known: dict[tuple[str, int], float] = {}

        def run(w: Way) -> float:
            key = w.section, w.number
            if key not in known:
                known[key] = 0.0  # round a loop a train passes no place twice
                ahead = self.r.beyond(w.section, w.exit)
                on = ahead is not None and (w.exit, ahead) not in self.r.signal_into
                further = [run(x) for x in self.r.ways[ahead] if x.entry == w.exit] if on and ahead else []
                known[key] = sum(metres[e] for e in w.edges) + max(further, default=0.0)
            return known[key]

        longest = max((run(w) for s in self.r.sections for w in self.r.ways[s]), default=0.0)
        fastest = max(self._speed(s) for s in [None, *self.r.sections])
        return self._halt(fastest) + round(1000 * longest / (self._rule("line_speed_kmh") / 3.6 / 2))

    def w_lasts(self, t: str) -> Formula:
        """A timer's preset is as long as the principles order, and as the world needs."""
        kind, _, element = t.partition("_")
        signals = {safe(g): s for g, s in self.r.signals.items()}
        wanted: dict[str, Callable[[], tuple[float, int]]] = {
            "RST": lambda: (self._rule("restart_delay_s"), self._need_of_restart()),
            "AT": lambda: (self._rule("approach_release_s"), self.need_of_stop(signals[element])),
            "RT": lambda: (self._rule("release_delay_s"), 0),
            "ST": lambda: (self._rule("point_supervision_s"), round(1000 * self._rule("point_run_s"))),
        }
        if kind not in wanted or (kind == "AT" and element not in signals):
            return FALSE  # nothing says how long this timer must be
        rule, need_ms = wanted[kind]()
        return TRUE if self.w.timers[t][1] >= max(round(1000 * rule), need_ms) else FALSE

    # --- the controller's own bits ---

    def w_locked(self, w: Way) -> Formula:
        return self._known(f"L_{safe(w.section)}_{w.number}")

    def w_held(self, s: str) -> Formula:
        locks = [self._known(f"L_{safe(s)}_{w.number}") for w in self.r.ways[s]]
        return some([leaf(f"K_{safe(s)}"), *locks])

    def w_used(self, s: str) -> Formula:
        return leaf(f"U_{safe(s)}")

    def w_passed(self, s: str) -> Formula:
        return leaf(f"P_{safe(s)}")

    def w_by_hand(self, s: str) -> Formula:
        return leaf(f"REL_{safe(s)}")

    def w_all_by_hand(self) -> Formula:
        return leaf("RELALL")

    def w_cancelled(self, g: Signal) -> Formula:
        """The controller remembers that the signal was cancelled."""
        return leaf(f"X_{safe(g.name)}")

    def w_restart_lock(self, s: str) -> Formula:
        return leaf(f"K_{safe(s)}")

    def w_firm(self, s: str) -> Formula:
        return leaf(f"F_{safe(s)}")

    def w_trailed(self, m: str) -> Formula:
        return leaf(f"TR_{safe(m)}")

    def w_commanded(self, m: str, x: str) -> Formula:
        return leaf(f"C{x}_{safe(m)}")

    def w_opened(self, r: int) -> Formula:
        return leaf(f"S_R{r}")

    def w_shut(self, r: int) -> Formula:
        return leaf(f"shut.R{r}")
