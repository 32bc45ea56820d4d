"""What the words of the specification mean that tell how the world moves: heads, tails, drivers, points, reports."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

from interlock.checker.formula import FALSE, TRUE, Formula, every, leaf, names, no, some
from interlock.checker.railway import Signal, Way
from interlock.checker.words import Terms, safe

REQUESTS = {"REQ": ("RQZ", "YRQ"), "LREQ": ("LRQZ", "YLRQ")}
"""For each input of numbers the bit that tells that 0 was read there, and the output that acknowledges a number."""


@dataclass(frozen=True)
class Entrance:
    """A boundary over which trains come in: its node, the approach or what stands for it, and the first section."""

    node: str
    outside: str
    inside: str
    signal: Signal


class World(Terms):
    """All words: those of the terms, and those of the world's steps."""

    def w_true(self) -> Formula:
        return TRUE

    def w_other(self, x: str) -> str:
        return "R" if x == "N" else "N"

    def w_before(self, x: str | Signal) -> Any:
        """Positions that come first where both would; the section or approach in rear of a signal."""
        if isinstance(x, Signal):
            if x.node in self.r.boundaries:
                return self._entrance(x.node).outside
            return self.r.beyond(x.into, x.node)
        return ["N"] if x == "R" else []

    def w_was_driven(self, m: str, x: str) -> Formula:
        return leaf(f"cmd.{m}.{x}")

    def w_was_shown(self, g: Signal) -> Formula:
        return leaf(f"lamp.{g.name}")

    def w_arrives(self, m: str, x: str) -> Formula:
        return leaf(f"arrive.{m}.{x}")

    def w_open_ends(self, s: str) -> list[str]:
        return [j for j in self.r.ends[s] if j not in self.r.buffers]

    def w_other_ends(self, s: str, j: str) -> list[str]:
        return [k for k in self.r.ends[s] if k != j]

    def w_beyond_end(self, s: str, j: str) -> list[str]:
        o = self.r.beyond(s, j)
        return [] if o is None else [o]

    def w_across(self, j: str, s: str) -> Formula:
        return leaf(f"x.{j}.{s}")

    def w_coming(self, s: str, j: str) -> Formula:
        """A train stands across an end on its way in, from the neighbour or from outside."""
        sides = [o for o in [self.r.beyond(s, j)] if o is not None] or [
            b.outside for b in self.entrances if b.node == j
        ]
        return some(self.w_across(j, o) for o in sides)

    def w_scanned(self, s: str) -> Formula:
        return leaf(f"img.{s}")

    def w_heading_to(self, s: str, j: str) -> Formula:
        return some(every((self.w_came(s, w.entry), self.w_lies(w))) for w in self.r.ways[s] if w.exit == j)

    def w_governing(self, s: str, j: str) -> list[Signal]:
        g = self.r.signal_into.get((j, self.r.beyond(s, j) or ""))
        return [] if g is None else [g]

    def w_ungoverned(self, s: str, j: str) -> list[str]:
        return [] if self.w_governing(s, j) else [j]

    def w_goes(self, j: str, s: str) -> Formula:
        return leaf(f"head.{j}.{s}")

    def w_leaves(self, j: str, s: str) -> Formula:
        return leaf(f"tail.{j}.{s}")

    def w_left(self, s: str) -> Formula:
        """A tail leaves the section."""
        return some(self.w_leaves(j, s) for j in self.w_open_ends(s))

    @cached_property
    def entrances(self) -> list[Entrance]:
        """The boundaries over which trains come in, on a signal."""
        found = []
        for b in self.r.boundaries:
            inside = self.r.at[b][0].section
            g = self.r.signal_into.get((b, inside))
            if self._comes_from(b) and g is not None:
                found.append(Entrance(b, self.r.approach.get(b) or f"outside.{b}", inside, g))
        return found

    def _entrance(self, node: str) -> Entrance:
        return next(b for b in self.entrances if b.node == node)

    def w_entrances(self) -> list[Entrance]:
        return self.entrances

    def w_outside(self, b: Entrance) -> str:
        return b.outside

    def w_node(self, b: Entrance) -> str:
        return b.node

    def w_inside(self, b: Entrance) -> str:
        return b.inside

    def w_entry_signal(self, b: Entrance) -> Signal:
        return b.signal

    def w_approach(self, b: Entrance) -> list[str]:
        return [self.r.approach[b.node]] if b.node in self.r.approach else []

    def w_appears(self, outside: str) -> Formula:
        return leaf(f"appear.{outside}")

    def w_joint_of(self, g: Signal) -> str:
        return g.node

    def w_first_of(self, g: Signal) -> str:
        return g.into

    def w_inner(self, g: Signal) -> list[Signal]:
        return [] if g.node in self.r.boundaries else [g]

    def w_seen_before(self, g: Signal) -> list[str]:
        return self.w_approach(self._entrance(g.node)) if g.node in self.r.boundaries else [self.w_before(g)]

    def w_seen(self, g: Signal) -> Formula:
        return some((self.w_shows(g), self.w_was_shown(g)))

    def w_stood_or_heading(self, g: Signal) -> Formula:
        """What stands before a signal could go on over its joint: since the restart, whatever lies under it."""
        s = self.w_before(g)
        could = some(self.w_came(s, j) for j in self.r.ends[s] if any(w.exit == g.node for w in self.w_from(s, j)))
        return some((every((self.w_standing(s), could)), self.w_heading(s, g)))

    def w_accepts(self, g: Signal) -> Formula:
        return leaf(f"accept.{g.name}")

    def w_refuses(self, g: Signal) -> Formula:
        return leaf(f"refuse.{g.name}")

    def w_turns(self) -> list[Way]:
        """Where a train that came in at an end may turn back, as if it had come in at another: once for each pair."""
        found: dict[tuple[str, str, str], Way] = {}
        for s in self.r.sections:
            for w in self.r.ways[s]:
                back = any(x.entry == w.exit and x.exit == w.entry for x in self.r.ways[s])
                if back and w.entry != w.exit and self.w_governing(s, w.entry):
                    found.setdefault((s, w.entry, w.exit), w)
        return list(found.values())

    def w_lies_some(self, t: Way) -> Formula:
        """The points lie for some way with the same ends."""
        return some(self.w_lies(w) for w in self.r.ways[t.section] if (w.entry, w.exit) == (t.entry, t.exit))

    def _turned(self, s: str, a: str | None, b: str | None) -> Formula:
        those = [t for t in self.w_turns() if t.section == s and a in (None, t.entry) and b in (None, t.exit)]
        return some(leaf(f"turn.{s}.{t.entry}.{t.exit}") for t in those)

    def w_turned_from(self, s: str, j: str) -> Formula:
        return self._turned(s, j, None)

    def w_turned_to(self, s: str, j: str) -> Formula:
        return self._turned(s, None, j)

    def w_reported(self) -> list[str]:
        """Sections and approaches that are reported."""
        return [*self.r.sections, *self.r.approach.values()]

    def w_stops_long(self, g: Signal) -> Formula:
        return leaf(f"?long.stop.{g.name}")

    def w_clear_for_long(self, s: str) -> Formula:
        """The section's release delay is over, a timer of the controller's."""
        return leaf(f"RT_{safe(s)}")

    def w_counts_as_clear(self, s: str) -> Formula:
        """The section's release delay runs."""
        return leaf(self.w.timers[f"RT_{safe(s)}"][0])

    def w_lighting(self, g: Signal) -> list[int]:
        """The routes whose proceed lights a lamp of the signal."""
        lamps = [self.w.definitions[f"{lamp}'"] for lamp in self.w_lamps(g)]
        return [r for r in self.w_routes() if any(f"S_R{r}'" in names(x) for x in lamps)]

    def w_been_open(self, r: int) -> Formula:
        """The route's signal has been open (the controller's own bit)."""
        return leaf(f"H_R{r}")

    def w_nobody_on_the_way(self, g: Signal) -> Formula:
        """No train can be about to pass the signal: back to the braking distance nothing is reported, where a way on
        from there is locked.  (Signals here have no caution, so that none announces another.)"""
        return no(self._on_the_way(g.into, g.node, 0.0, 0.0, frozenset({g.into})))

    def _on_the_way(self, ahead: str, node: str, gone: float, needed: float, seen: frozenset[str]) -> Formula:
        if node in self.r.boundaries:
            if len(seen) > 1 and self.r.boundaries[node].get("trains") == "out":
                return FALSE
            words = str(self.r.boundaries[node].get("approach", "")).split()
            if len(words) != 2 or gone + float(words[1]) < max(needed, self._braking(words[0])):
                return TRUE  # a train may always be on its way unseen
            return no(self.w_clear(words[0]))
        s = self.r.beyond(ahead, node)
        if s is None or s in seen:
            return TRUE if s is None and len(seen) == 1 else FALSE
        needed = max(needed, self._braking(s))
        metres = {e.name: e.length for e in self.r.edges}
        found = [no(self.w_clear(s))]
        for w in self.r.ways[s]:
            run = gone + sum(metres[e] for e in w.edges)
            if w.exit == node and run < needed and f"L_{safe(s)}_{w.number}" in self.state:
                found.append(every((self.w_locked(w), self._on_the_way(s, w.entry, run, needed, seen | {s}))))
        return some(found)

    def _braking(self, section: str) -> float:
        """Metres in which a train stands that runs as fast as it may."""
        v = self._speed(section) / 3.6
        wait = self._rule("output_delay_s") + self._rule("reaction_s")
        return v * wait + v * v / (2 * self._rule("braking_ms2"))

    def w_cancelling(self, g: Signal) -> Formula:
        """The controller's approach locking delay runs."""
        return leaf(self.w.timers[f"AT_{safe(g.name)}"][0])

    def w_been(self, s: str) -> Formula:
        return leaf(f"been.{s}")

    def w_set(self, r: int) -> Formula:
        return leaf(f"A_R{r}")

    def w_asked(self, r: int) -> Formula:
        """The route's number comes after 0: on the spot, or, if nothing comes there, from the control centre.

        `LRQZ` and `RQZ`: the scan before has read 0 there (the controller's own bits; S-AGAIN cannot do without).
        """
        local, nothing = every((leaf("LRQZ"), leaf(f"LREQ={r}"))), some((leaf("LREQ=0"), no(leaf("LRQZ"))))
        return some((local, every((nothing, leaf("RQZ"), leaf(f"REQ={r}")))))

    def w_automatic(self, r: int) -> Formula:
        """The switch for automatic working of the route; a layout that names no automatic route has none."""
        return leaf(f"AUTO_R{r}") if self.r.body.get("automatic") else FALSE

    def w_requests(self) -> list[str]:
        """The inputs at which routes are asked for by number."""
        return list(self.w.ranges)

    def w_nothing_asked(self, q: str) -> Formula:
        return leaf(f"{q}=0")

    def w_waits_for_number(self, q: str) -> Formula:
        """The scan before has read 0."""
        return leaf(REQUESTS[q][0])

    def w_acknowledged(self, q: str) -> Formula:
        """The output that tells that a number was read."""
        return leaf(REQUESTS[q][1])
