"""What the words of the specification mean that tell what signals show: lamps, speeds, aspects (R11)."""

from __future__ import annotations

from functools import cached_property

from interlock.checker.ahead import Ahead
from interlock.checker.formula import FALSE, Formula, leaf, some
from interlock.checker.railway import Calling, Path, Run, Signal, safe
from interlock.checker.words import fact
from interlock.verify import need

MAIN, CALL_ON, WHITE, IDENTIFIER, SECOND, BRANCH = ("YP", "YY"), ("YO",), ("YW",), ("YI",), ("YU",), ("YB",)
"""Outputs of clear and caution, of the call-on aspect beside stop, of the shunt aspect, of the identifier light, of the
second yellow lamp beside caution, of the route indicator."""


class Lamps(Ahead):
    """Words of lamps."""

    def lamps(self, g: Signal, kinds: tuple[str, ...]) -> list[str]:
        """The outputs of a signal with these beginnings, of those that the written system has."""
        return [f"{k}_{g.safe}" for k in kinds if f"{k}_{g.safe}" in self.state]

    def w_lit(self, lamp: str) -> Formula:
        return leaf(lamp)

    def w_shows(self, c: Calling) -> Formula:
        """Whom it speaks to may pass it: trains by main lamps, called on, or at the identifier light, shunting
        movements by the white one."""
        return some(map(leaf, self.lamps(c.signal, WHITE if c.shunt else (*MAIN, *CALL_ON, *IDENTIFIER))))

    def w_opens(self, c: Calling) -> Formula:
        """Proceed, but not by calling on."""
        return some(map(leaf, self.lamps(c.signal, WHITE if c.shunt else MAIN)))

    def w_calls_past(self, c: Calling) -> Formula:
        """The identifier light: a train passes without being told anything."""
        return FALSE if c.shunt else self.w_identifies(c.signal)

    def w_opens_to_train(self, c: Calling) -> Formula:
        """Clear or caution."""
        return self.w_opens_main(c.signal)

    def w_identifies(self, g: Signal) -> Formula:
        return some(map(leaf, self.lamps(g, IDENTIFIER)))

    def w_may_identify(self, g: Signal) -> Formula:
        """The layout gives it an identifier light."""
        return fact(self.r.body["signals"][g.name].get("identifier") in ("yes", "true"))

    def w_passed_by(self, c: Calling, p: Path) -> list[Signal]:
        """The signal at the end of a train's path, if it may be passed at identifier light."""
        return [] if c.shunt else self.r.paths.passed_after(p)

    def w_runs_for_clear(self, p: Path) -> list[Run]:
        """How a train may run on from a path, where clear may be shown over all that comes before the last part."""
        return [u for u in self.r.paths.runs(p) if all(map(self.w_next_open_for_clear, u.parts[:-1]))]

    def w_opens_main(self, g: Signal) -> Formula:
        return some(map(leaf, self.lamps(g, MAIN)))

    def w_shows_any(self, g: Signal) -> Formula:
        return some(self.w_shows(c) for c in g.callings)

    def w_shows_clear(self, g: Signal) -> Formula:
        return some(map(leaf, self.lamps(g, ("YP",))))

    def w_calls_on(self, g: Signal) -> Formula:
        return some(map(leaf, self.lamps(g, CALL_ON)))

    def w_lamps_instead_of_stop(self, g: Signal) -> list[str]:
        return self.lamps(g, (*MAIN, *WHITE, *IDENTIFIER))

    def w_lamps_for_others(self, g: Signal) -> list[str]:
        """Lamps that speak to movements of which the layout does not let a signal speak."""
        trains = [*self.lamps(g, (*MAIN, *SECOND, *BRANCH)), *self.w_speed_lamps(g)]
        return [*([] if g.main else trains), *([] if g.shunt else self.lamps(g, WHITE))]

    def w_lamps_but_identifier(self, g: Signal) -> list[str]:
        return self.lamps(g, ("YS", *MAIN, *WHITE, *CALL_ON))

    @cached_property
    def _speeds(self) -> dict[str, dict[str, float]]:
        """The speed indicators by signals: outputs YV and the speed."""
        known = {g.safe: g.name for g in self.w_signals()}
        found: dict[str, dict[str, float]] = {g: {} for g in known.values()}
        for name in self.state:
            head, _, element = name.partition("_")
            if head.startswith("YV") and head[2:].isdigit() and element in known:
                found[known[element]][name] = float(head[2:])
        return found

    def w_speed_lamps(self, g: Signal) -> list[str]:
        return sorted(self._speeds[g.name])

    def w_faster_lamps(self, c: Calling, p: Path) -> list[str]:
        """Indicators of more than a path permits."""
        kmh = self.lengths.path_kmh(p)
        return [n for n, v in self._speeds[c.name].items() if kmh is not None and v > kmh and not c.shunt]

    def w_second_lamps(self, g: Signal) -> list[str]:
        return self.lamps(g, SECOND)

    def w_caution_lamps(self, g: Signal) -> list[str]:
        return self.lamps(g, ("YY",))

    def w_branch_lamps(self, g: Signal) -> list[str]:
        return self.lamps(g, BRANCH)

    def w_branching(self, g: Signal) -> list[Path]:
        """The paths of trains out in a direction that has a route indicator."""
        return [p for p in self.w_train_paths(g) if self._indicated(p)]

    def w_departing_otherwise(self, g: Signal) -> list[Path]:
        """Those out in a direction that has none."""
        return [p for p in self.w_train_paths(g) if self._out(p) and not self._indicated(p)]

    def w_runs_branching(self, g: Signal) -> list[Run]:
        return [u for u in self.w_runs(g) if self._indicated(u.last)]

    def w_runs_otherwise(self, g: Signal) -> list[Run]:
        return [u for u in self.w_runs(g) if self._out(u.last) and not self._indicated(u.last)]

    def _out(self, p: Path) -> bool:
        return p.last.exit in self.r.drawn.boundaries

    def _indicated(self, p: Path) -> bool:
        return self._out(p) and self.r.drawn.boundaries[p.last.exit].get("indicator") in ("yes", "true", True)

    def w_turned_inside(self, g: Signal) -> list[Path]:
        """The paths of trains over a reversed point into a track inside the layout that ask for two yellows (R11)."""
        return [p for p in self.w_train_paths(g) if self._two_yellows(p)]

    def w_runs_turned(self, g: Signal) -> list[Run]:
        """How trains may run past identifier lights, where some part asks for two yellows."""
        return [u for u in self.w_runs(g) if any(map(self._two_yellows, u.parts))]

    def _two_yellows(self, p: Path) -> bool:
        turned = any(d.position == "R" for w in p.ways for _, d in w.points)
        return turned and not self._onto_checked_line(p) and self.r.drawn.rules["caution"] == "turnout"

    def _onto_checked_line(self, p: Path) -> bool:
        v = self.r.drawn.boundaries.get(p.last.exit)
        return v is not None and (v.get("block", "none") != "none" or bool(v.get("approach")))

    def w_limited_paths(self, g: Signal) -> list[Path]:
        """The paths of trains for which the layout states a speed."""
        return [p for p in self.w_train_paths(g) if self.lengths.path_kmh(p) is not None]

    def w_limited_last(self, u: Run) -> list[Path]:
        """The last part, where the layout states a speed for it."""
        return [u.last] if self.lengths.path_kmh(u.last) is not None else []

    def w_lamps_within(self, g: Signal, p: Path) -> list[str]:
        """Indicators of no more than a path permits."""
        kmh = self.lengths.path_kmh(p)
        return [n for n, v in self._speeds[g.name].items() if kmh is not None and v <= kmh]

    def w_slow_lamps(self, g: Signal, p: Path, o: Path) -> list[str]:
        """Indicators of no more than an overlap beyond a path is made for."""
        kmh = self.entry(p, o)
        return [n for n, v in self._speeds[g.name].items() if kmh is not None and v <= kmh]

    def w_too_fast_lamps(self, g: Signal, p: Path, o: Path) -> list[str]:
        """Indicators of more than that."""
        kmh = self.entry(p, o)
        return [n for n, v in self._speeds[g.name].items() if kmh is not None and v > kmh]

    def w_lamps_up_to(self, c: Calling, kmh: int) -> list[str]:
        """Indicators of no more than a speed."""
        return [n for n, v in self._speeds[c.name].items() if v <= kmh]

    def w_lamps_above(self, c: Calling, kmh: int) -> list[str]:
        return [n for n, v in self._speeds[c.name].items() if v > kmh]

    def w_stop(self, g: Signal) -> Formula:
        return leaf(f"YS_{g.safe}")

    def w_opening(self) -> list[Signal]:
        """The signals from which some route leads, so that they have lamps at all; each has one for stop."""
        return self._opening

    @cached_property
    def _opening(self) -> list[Signal]:
        for g in self.w_signals():
            dark = self.lamps(g, (*MAIN, *CALL_ON, *WHITE, *IDENTIFIER)) and f"YS_{g.safe}" not in self.state
            need(not dark, f"signal {g.name} has lamps, and none for stop")
        return [g for g in self.w_signals() if f"YS_{g.safe}" in self.state]

    def w_calling_on(self) -> list[Signal]:
        return [g for g in self.w_signals() if g.call_on]

    def w_never_calling_on(self) -> list[Signal]:
        return [g for g in self.w_signals() if not g.call_on]

    def w_main_signals(self) -> list[Signal]:
        return [g for g in self.w_signals() if g.main]

    def w_cautioning(self) -> list[Signal]:
        """Main signals, where the principles have a caution aspect."""
        return self.w_main_signals() if self.r.drawn.rules["caution"] != "never" else []

    def w_lamp_proved(self) -> list[Calling]:
        return self.w_all_callings() if self.r.drawn.asks("lamp_proof") else []

    def w_stop_intact(self, c: Calling) -> Formula:
        return leaf(f"RL_{c.signal.safe}")

    def w_clear_intact(self, g: Signal) -> Formula:
        return leaf(f"GL_{g.safe}")

    def w_identifier_intact(self, g: Signal) -> Formula:
        return leaf(f"NL_{g.safe}")

    def w_identifier_lamp_proved(self) -> list[Signal]:
        """Signals with an identifier light, where lamps are reported."""
        return [g for g in self.w_opening() if self.r.drawn.asks("lamp_proof") and self.lamps(g, IDENTIFIER)]

    def w_second_intact(self, g: Signal) -> Formula:
        return leaf(f"UL_{g.safe}")

    def w_second_lamp_proved(self) -> list[Signal]:
        """Signals with a second yellow lamp, where lamps are reported."""
        return [g for g in self.w_opening() if self.r.drawn.asks("lamp_proof") and self.w_second_lamps(g)]

    def w_speed_intact(self, g: Signal) -> Formula:
        return leaf(f"VL_{g.safe}")

    def w_speed_lamp_proved(self) -> list[Signal]:
        """Signals with a speed indicator, where lamps are reported."""
        return [g for g in self.w_opening() if self.r.drawn.asks("lamp_proof") and self.w_speed_lamps(g)]

    def w_last_intact(self, g: Signal) -> Formula:
        """The lamp of the most restrictive proceed: caution, if there is one."""
        return leaf(f"{'GL' if self.r.drawn.rules['caution'] == 'never' else 'CL'}_{g.safe}")

    def w_line_checked(self, p: Path) -> Formula:
        """A departure is tied to the line beyond (R12), and is not too slow for clear (R11)."""
        return fact(self._onto_checked_line(p) and not self._slow(p))

    def _slow(self, p: Path) -> bool:
        kmh = self.lengths.path_kmh(p)
        return kmh is not None and kmh < self.r.drawn.rule("slow_below_kmh")

    def w_next_open_for_clear(self, p: Path) -> list[Calling]:
        """What the next main signal calls, which clear needs; under `turnout` no way over a reversed point is (R11)."""
        if p.last.exit in self.r.drawn.boundaries or self._slow(p):
            return []
        turned = any(d.position == "R" for w in p.ways for _, d in w.points)
        g = self.r.main_into.get((p.last.exit, self.r.track.beyond(p.last.section, p.last.exit) or ""))
        return [] if g is None or (turned and self.r.drawn.rules["caution"] == "turnout") else [Calling(g, False)]

    def w_distants(self) -> list[str]:
        return list(self.r.body.get("distants") or {})

    def w_announced(self, d: str) -> Signal:
        return self.r.signals[self.r.body["distants"][d]["of"]]

    def w_distant_clear(self, d: str) -> Formula:
        return leaf(f"YD_{safe(d)}")

    def w_distant_caution(self, d: str) -> Formula:
        return leaf(f"YC_{safe(d)}")
