"""What the words of the specification mean that tell what lies ahead of a path: overlaps, foul joints, conditions, the
line beyond a boundary."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from typing import Any

from interlock.checker.formula import Formula
from interlock.checker.lengths import FoulBeside, FoulJoint
from interlock.checker.railway import Calling, Path, Signal
from interlock.checker.track import Demand, Way
from interlock.checker.words import Entrance, Topology, fact


@dataclass(frozen=True)
class Overlap:
    """An alternative of a signal's overlap, by its number from 1."""

    signal: Signal
    number: int
    path: Path


class Ahead(Topology):
    """Words of what lies ahead."""

    # --- overlaps ---

    @cached_property
    def overlaps(self) -> list[Overlap]:
        """Every alternative of every signal's overlap."""
        those = self.lengths.overlaps.items()
        return [Overlap(self.r.signals[g], n, p) for g, paths in those for n, p in enumerate(paths, 1)]

    def w_overlapped(self) -> list[Signal]:
        """The signals with an overlap."""
        return [self.r.signals[g] for g in self.lengths.overlaps]

    def w_overlaps_over(self, s: str) -> list[Signal]:
        """The signals of which an overlap lies over a section."""
        those = (o.signal for o in self.overlaps if any(w.section == s for w in o.path.ways))
        return list(dict.fromkeys(those))

    def w_at_end(self, o: Overlap, w: Way) -> Formula:
        """A way of an overlap is its last one, and none of its signal leads on from there."""
        return fact(w == o.path.last and not self._leads(o.signal, w.section, w.exit))

    def w_ways_under(self, o: Overlap) -> tuple[Way, ...]:
        return o.path.ways

    def w_overlaps_held(self, s: str) -> list[Overlap]:
        return [o for o in self.overlaps if any(w.section == s for w in o.path.ways)]

    def w_overlapped_from(self, s: str) -> list[Signal]:
        """The signals with an overlap before which a train in a section may come to a stand."""
        return [g for g in self.r.signals_out(s) if g.name in self.lengths.overlaps]

    def w_before_overlapped(self) -> list[str]:
        return [s for s in self.r.track.sections if self.w_overlapped_from(s)]

    @cached_property
    def _steps(self) -> frozenset[tuple[str, str, str]]:
        """The signal of an overlap, and a section and its end over which the overlap goes on into the neighbour."""
        steps = ((o.signal.name, a, b) for o in self.overlaps for a, b in pairwise(o.path.ways))
        return frozenset(
            (g, a.section, a.exit) for g, a, b in steps if b.section == self.r.track.beyond(a.section, a.exit)
        )

    def _leads(self, h: Signal, s: str, j: str) -> bool:
        """An overlap goes on from a section over its end."""
        return (h.name, s, j) in self._steps

    def w_within_overlap(self, h: Signal, s: str, j: str) -> Formula:
        return fact(self._leads(h, s, j))

    def w_stop_failed(self, h: Signal, s: str, j: str) -> list[Signal]:
        """The signal itself, where it governs leaving the section there."""
        return [h] if (h.node, h.into) == (j, self.r.track.beyond(s, j)) else []

    def w_overrun_at(self, s: str, j: str) -> list[Signal]:
        """The signals that a train may be overrunning that leaves a section there."""
        return [h for h in self.w_overlapped() if self._leads(h, s, j) or self.w_stop_failed(h, s, j)]

    @cached_property
    def _short(self) -> list[tuple[Overlap, int]]:
        """The overlaps inside longer ones that count for slow trains: for which km/h."""
        those = {g.name: self.lengths.short(g) for g in self.w_overlapped()}
        return [(o, round(those[o.signal.name][o.path])) for o in self.overlaps if o.path in those[o.signal.name]]

    def w_short_speeds(self) -> list[int]:
        return sorted({v for _, v in self._short})

    def w_short_ends(self, h: Signal, s: str, j: str) -> list[int]:
        """For which speeds short overlaps of a signal end there."""
        return [v for o, v in self._short if o.signal == h and (o.path.last.section, o.path.last.exit) == (s, j)]

    def w_longer_overlaps(self, p: Path, o: Path) -> list[Path]:
        """Those of the signal beyond a path inside which a short one lies that counts by itself."""
        beyond = self.w_overlaps_beyond(p)
        if not any(x.path == o and x.path in beyond for x, _ in self._short):
            return []
        return [x for x in beyond if len(x.ways) > len(o.ways) and x.ways[: len(o.ways)] == o.ways]

    def w_swings_in_time(self, g: Signal) -> list[str]:
        """The machines of an overlap that swings while no train can come so far."""
        return self.lengths.of_overlap(g) if self.lengths.swings_in_time(g) else []

    def w_overlap_paths(self, c: Calling) -> list[Path]:
        """The paths of trains to a signal with an overlap."""
        return [p for p in self.r.paths.of(c) if not c.shunt and self.w_overlaps_beyond(p)]

    def w_overlaps_beyond(self, p: Path) -> list[Path]:
        g = self.r.main_into.get((p.last.exit, self.r.track.beyond(p.last.section, p.last.exit) or ""))
        return [] if g is None else self.lengths.overlaps.get(g.name, [])

    def entry(self, p: Path, o: Path) -> float | None:
        """The speed (km/h) for which an overlap beyond a path is made; None if for none."""
        g = self.r.main_into.get((p.last.exit, self.r.track.beyond(p.last.section, p.last.exit) or ""))
        return None if g is None else self.lengths.entry_kmh(g, o)

    def w_entry_overlaps(self, p: Path) -> list[Path]:
        """The alternatives of the overlap beyond a path that are made for a speed."""
        return [o for o in self.w_overlaps_beyond(p) if self.entry(p, o) is not None]

    def w_too_slow_for_clear(self, p: Path, o: Path) -> Formula:
        """An overlap is made for a speed at which no signal shows clear (R11)."""
        kmh = self.entry(p, o)
        return fact(kmh is not None and kmh < self.r.drawn.rule("slow_below_kmh"))

    # --- foul joints ---

    def w_foul_joints(self) -> list[FoulJoint]:
        return self.lengths.foul_joints

    def w_foul_of(self, p: Path) -> list[FoulJoint]:
        return [f for f in self.lengths.foul_joints if any(map(f.fouls, p.ways))]

    def w_crossed(self) -> list[FoulJoint]:
        """What lies across diamonds in sections of its own."""
        return self.lengths.crossed

    def w_crossed_anyhow(self) -> list[FoulJoint]:
        """That of which no point leads to the diamond."""
        return [f for f in self.lengths.crossed if f.when is None]

    def w_crossed_by(self, p: Path) -> list[FoulJoint]:
        """What lies across a path on its diamonds, in a section of its own."""
        return [f for f in self.lengths.crossed if any(map(f.fouls, p.ways))]

    def w_foul_beside(self, p: Path) -> list[FoulBeside]:
        """What stands foul of a path that comes too near to a point on one leg, or to a diamond on one arm."""
        return [f for f in self.lengths.beside if any(map(f.fouls, p.ways))]

    def w_fouled(self, f: FoulJoint) -> str:
        return f.section

    def w_beside(self, f: FoulJoint) -> str:
        return f.neighbour

    def w_fouled_ways(self, f: FoulJoint) -> list[Way]:
        return [w for w in self.r.track.ways[f.section] if f.fouls(w)]

    def w_ways_at_joint(self, f: FoulJoint) -> list[Way]:
        return [w for w in self.r.track.ways[f.neighbour] if f.node in (w.entry, w.exit)]

    def w_keeps_away(self, f: FoulJoint) -> list[Demand]:
        """The neighbour's point that leads to the joint, if one does."""
        return [] if f.when is None else [f.when]

    # --- conditions, lines beyond, zones ---

    @property
    def _conditions(self) -> Mapping[str, Mapping[str, Any]]:
        told = dict(self.r.body.get("conditions") or {})
        for b, v in self.r.drawn.boundaries.items():  # R12: the block of a line is a condition of leaving
            if v.get("block", "none") in ("automatic", "semi-automatic") and v.get("trains", "both") != "in":
                told[f"BF/{b}"] = {"exits": [b]}
        return told

    def w_conditions(self, c: Calling, p: Path) -> list[str]:
        out = []
        for name, v in self._conditions.items():
            over, exits = set(v.get("over") or ()), set(v.get("exits") or ())
            leaves = not c.shunt and p.last.exit in exits
            if c.name in (v.get("signals") or ()) or any(w.section in over for w in p.ways) or leaves:
                out.append(name)
        return out

    def w_conditions_over(self, p: Path) -> list[str]:
        """The conditions over the sections of a path, or of an overlap."""
        over = {name: set(v.get("over") or ()) for name, v in self._conditions.items()}
        return [name for name, those in over.items() if any(w.section in those for w in p.ways)]

    def w_line_beyond(self, c: Calling, p: Path) -> list[str]:
        """The line beyond, where a train's path leads over a boundary and the section there is reported."""
        a = self.r.approach.get(p.last.exit)
        return [a] if a is not None and not c.shunt else []

    def w_tokens(self) -> list[str]:
        """The boundaries of lines with a direction token."""
        return [b for b, v in self.r.drawn.boundaries.items() if v.get("block") == "token"]

    def w_token_of(self, b: Entrance) -> list[str]:
        return [b.node] if b.node in self.w_tokens() else []

    def w_token_beyond(self, c: Calling, p: Path) -> list[str]:
        return [p.last.exit] if p.last.exit in self.w_tokens() and not c.shunt else []
