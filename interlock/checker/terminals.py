"""What the words of the specification mean that tell of terminals, of the controller's own bits, and of timers."""

from __future__ import annotations

from collections.abc import Callable
from functools import cached_property
from typing import Any

from interlock.checker.ahead import Overlap
from interlock.checker.formula import FALSE, TRUE, Formula, every, leaf, names, no, some
from interlock.checker.lamps import CALL_ON, IDENTIFIER, MAIN, WHITE, Lamps
from interlock.checker.lengths import fastest_told, whole_ms
from interlock.checker.railway import Calling, Path, Signal, safe
from interlock.checker.track import Way
from interlock.checker.words import fact
from interlock.verify import need

REQUESTS = {"REQ": ("RQZ", "YRQ"), "LREQ": ("LRQZ", "YLRQ")}
"""For each input of numbers the bit that tells that 0 was read there, and the output that acknowledges a number."""
LONGEST = 2**31 - 1
"""The longest TIME, in milliseconds, of a controller that keeps it in 32 bits."""


class Terminals(Lamps):
    """Words at the terminals, and of the controller."""

    # --- what the controller reads ---

    def w_valid(self) -> Formula:
        return leaf("VALID")

    def w_healthy(self, s: str) -> Formula:
        return leaf(f"SH_{safe(s)}") if self.r.drawn.asks("sensor_faults") else TRUE

    def w_detectors(self) -> list[str]:
        """Sections and approaches of which it is reported whether the detector is healthy."""
        return self.w_reported() if self.r.drawn.asks("sensor_faults") else []

    def w_clear(self, s: str) -> Formula:
        """Reported clear by a healthy detector; never, without detection."""
        if s in self.r.track.undetected or s.startswith("outside."):
            return FALSE
        return every((leaf(f"CLR_{safe(s)}"), self.w_healthy(s)))

    def w_steadily_clear(self, s: str) -> Formula:
        """Reported clear, and that without a break for the release delay (R15); never, without detection."""
        return every((self.w_clear(s), leaf(self.w_release_timer(s))))

    def w_falsely(self, s: str) -> Formula:
        """Reported occupied, though nobody is there before or after."""
        o = leaf(f"o.{s}")
        return every((no(self.w_clear(s)), no(o), no(self.after(o)), self.w_valid()))

    def w_detected(self, m: str, x: str) -> Formula:
        return leaf(f"D{x}_{safe(m)}")

    def w_holds(self, c: str) -> Formula:
        return leaf(f"E_{safe(c)}")

    def w_blocked(self, s: str) -> Formula:
        """The input that bars a section; one that is never locked, and has no point, has none."""
        pointed = any(s in self.w_sections_of(m) for m in self.w_point_machines())
        return leaf(f"BLK_{safe(s)}") if pointed or self.w_lockable(s) else FALSE

    def w_cancel(self, g: Signal) -> Formula:
        return leaf(f"CAN_{g.safe}")

    def w_looked_at(self, m: str) -> Formula:
        """Somebody confirms that he has looked at a trailed point."""
        return leaf(f"TC_{safe(m)}")

    def w_moved_by_hand(self, m: str, x: str) -> Formula:
        """The input by which an operator moves a machine."""
        return leaf(f"M{x}_{safe(m)}")

    def w_by_hand(self, s: str) -> Formula:
        return leaf(f"REL_{safe(s)}")

    def w_all_by_hand(self) -> Formula:
        return leaf("RELALL")

    # --- what else it tells ---

    def w_driven(self, m: str, x: str) -> Formula:
        return leaf(f"Y{x}_{safe(m)}")

    def w_told_locked(self, s: str) -> Formula:
        return leaf(f"YL_{safe(s)}")

    def w_told_faulty(self, s: str) -> Formula:
        return leaf(f"YF_{safe(s)}")

    def w_told_late(self, m: str) -> Formula:
        return leaf(f"YA_{safe(m)}")

    def w_told_trailed(self, m: str) -> Formula:
        return leaf(f"YT_{safe(m)}")

    def w_told_full(self, z: str) -> Formula:
        return leaf(f"YZ_{safe(z)}")

    # --- the controller's own bits ---

    def w_locked(self, w: Way) -> Formula:
        return self.known(f"L_{safe(w.section)}_{w.number}")

    def w_locked_overlap(self, o: Overlap) -> Formula:
        return self.known(f"V_{o.signal.safe}_{o.number}")

    def w_firm_overlap(self, o: Overlap) -> Formula:
        """The overlap that is held of its signal is locked and detected."""
        return self.known(f"VF_{o.signal.safe}")

    def w_all_overlaps(self) -> list[Overlap]:
        """Those that some route holds."""
        return [o for o in self.overlaps if f"V_{o.signal.safe}_{o.number}" in self.state]

    def w_swung(self, o: Overlap) -> Formula:
        """The overlap of its signal swings in this scan."""
        return self.known(f"VS_{o.signal.safe}")

    def w_near_train(self, o: Overlap) -> Formula:
        """The overlap may not swing now, or never: the section before its signal is not reported clear."""
        return no(self.w_steadily_clear(self.w_before_of(o.signal))) if f"VS_{o.signal.safe}" in self.state else TRUE

    def w_restart_lock(self, s: str) -> Formula:
        return leaf(f"K_{safe(s)}")

    def w_firm(self, s: str) -> Formula:
        return leaf(f"F_{safe(s)}")

    def w_for_train(self, s: str) -> Formula:
        """The lock is for a train movement, where there are others."""
        return leaf(f"M_{safe(s)}") if self.r.shunting else TRUE

    def w_right_kind(self, c: Calling, s: str) -> Formula:
        return no(self.w_for_train(s)) if c.shunt else self.w_for_train(s)

    def w_used(self, s: str) -> Formula:
        return leaf(f"U_{safe(s)}")

    def w_stale(self, s: str) -> Formula:
        """Inputs were lost while the section was locked, a train may have been missed; or it is for calling on."""
        return leaf(f"D_{safe(s)}")

    def w_passed(self, s: str) -> Formula:
        return leaf(f"P_{safe(s)}")

    def w_cancelled(self, g: Signal) -> Formula:
        """The controller remembers that the signal was cancelled; one without routes is never."""
        return self.known(f"X_{g.safe}")

    def w_trailed(self, m: str) -> Formula:
        return leaf(f"TR_{safe(m)}")

    def w_was_detected(self, m: str, x: str) -> Formula:
        """It was detected there, not commanded elsewhere, nor anew since."""
        return leaf(f"TH{x}_{safe(m)}")

    def w_commanded(self, m: str, x: str) -> Formula:
        return leaf(f"C{x}_{safe(m)}")

    def w_turn_has_come(self, m: str) -> Formula:
        """The machine may run: where machines start one after the other, its turn has come."""
        return leaf(f"Z_{safe(m)}") if self.r.drawn.rule("point_start_gap_s") and m in self.w_powered() else TRUE

    def w_kept_off(self, m: str) -> Formula:
        """The drive of a point is kept off."""
        return leaf(f"ZO_{safe(m)}") if m in self.w_powered() else FALSE

    def w_swinging_over(self, m: str) -> list[Signal]:
        """The signals with an overlap over a machine that may swing."""
        return [g for g in self.w_swinging() if m in self.lengths.of_overlap(g)]

    def w_full(self, z: str) -> Formula:
        return leaf(f"ZF_{safe(z)}")

    # --- its routes, by number; whom one is for is told by the lamp that its proceed lights ---

    def w_routes(self) -> list[int]:
        return sorted(int(n[3:]) for n in self.state if n.startswith("S_R") and n[3:].isdigit())

    @cached_property
    def _lit_by(self) -> dict[str, dict[int, None]]:
        """For each lamp of a signal the routes whose proceed lights it."""
        found: dict[str, dict[int, None]] = {}
        for g in self.w_signals():
            for lamp in self.lamps(g, (*MAIN, *CALL_ON, *WHITE, *IDENTIFIER)):
                need(f"{lamp}'" in self.w.definitions, f"nothing says when {lamp} is lit")
                read = {n.removesuffix("'") for n in names(self.w.definitions[f"{lamp}'"])}
                found[lamp] = dict.fromkeys(int(n[3:]) for n in sorted(read) if n.startswith("S_R"))
        return found

    def _routes_by(self, g: Signal, kinds: tuple[str, ...]) -> list[int]:
        return sorted({r for lamp in self.lamps(g, kinds) for r in self._lit_by[lamp]})

    def train_routes(self, g: Signal) -> list[int]:
        """Those for trains that are not called on."""
        return self._routes_by(g, MAIN)

    def w_proceed_lamp_proved(self) -> list[Signal]:
        """Signals that open for trains, where lamps are reported."""
        asked = self.r.drawn.asks("lamp_proof")
        return [g for g in self.w_opening() if asked and g.main and self.train_routes(g)]

    def w_routes_from(self, g: Signal) -> list[int]:
        return self._routes_by(g, (*MAIN, *CALL_ON, *WHITE, *IDENTIFIER))

    def w_identifier_routes(self) -> list[int]:
        """Those that are set with a route past their signal, and light its identifier."""
        return self._identifier_routes

    @cached_property
    def _identifier_routes(self) -> list[int]:
        lit = {r for g in self.w_opening() if self.w_may_identify(g) == TRUE for r in self._routes_by(g, IDENTIFIER)}
        return sorted(lit - {r for g in self.w_opening() for r in self._routes_by(g, (*MAIN, *CALL_ON, *WHITE))})

    def w_own_routes(self) -> list[int]:
        others = self.w_identifier_routes()
        return [r for r in self.w_routes() if r not in others]

    @cached_property
    def _past(self) -> dict[int, list[int]]:
        """For each route of a main lamp those that it waits for before it opens: of an identifier light."""
        beyond = {f"PR_R{b}": b for b in self.w_identifier_routes()}
        found: dict[int, list[int]] = {}
        for r in self.w_routes() if beyond else ():
            opens = names(self.w.definitions.get(f"PR_R{r}", FALSE))
            found[r] = sorted({beyond[n] for n in opens if n in beyond and beyond[n] != r})
        return found

    def w_leading_past(self, b: int) -> list[int]:
        """The routes that are set with one that lights an identifier."""
        return [r for r, those in self._past.items() if b in those]

    def w_set_with(self, b: int) -> list[int]:
        """Those, and all that is set with them in turn."""
        return _in_turn(b, self.w_leading_past)

    def _beyond(self, r: int) -> list[int]:
        """What a route waits for before it opens, and that in turn."""
        return _in_turn(r, lambda x: self._past.get(x, []))

    def w_passed_with(self, r: int) -> list[Signal]:
        """The signals that a route passes at identifier light."""
        return [g for b in self._beyond(r) for g in self.w_signal_of_route(b)]

    def w_signal_of_route(self, r: int) -> list[Signal]:
        return self._signals_of_routes.get(r, [])

    @cached_property
    def _signals_of_routes(self) -> dict[int, list[Signal]]:
        found: dict[int, list[Signal]] = {}
        for g in self.w_opening():
            for r in self.w_routes_from(g):
                found.setdefault(r, []).append(g)
        return found

    def w_asked_for(self, r: int) -> Formula:
        """A route is asked for by its number, or by that of one with which it is set."""
        if r not in self.w_identifier_routes():
            return self.w_asked(r)
        return some(self.w_asked(x) for x in self.w_set_with(r) if x not in self.w_identifier_routes())

    def w_may_open_again(self, r: int) -> Formula:
        """Its signal opens again when it is asked for: not what calls a train on."""
        return fact(r not in self.w_routes_calling_on())

    def w_routes_calling_on(self) -> list[int]:
        return sorted({r for g in self.w_opening() for r in self._routes_by(g, CALL_ON)})

    def w_routes_for(self, c: Calling) -> list[int]:
        """The routes of trains from a signal, or of shunting movements."""
        return self._routes_by(c.signal, WHITE if c.shunt else (*MAIN, *CALL_ON, *IDENTIFIER))

    def w_passing(self, c: Calling) -> Formula:
        """The signal is still open for a movement that has begun to pass it."""
        return some(self.known(f"PA_R{r}") for r in self.w_routes_for(c))

    # --- over which path a route leads: by the locks that its grant sets, and S-LOCKED is the proof of it ---

    @cached_property
    def _runs(self) -> dict[int, tuple[Calling, Path]]:
        set_by: dict[str, set[Way]] = {}
        for w in (w for s in self.r.track.sections for w in self.w_lockable(s)):
            for name in names(self.w.definitions.get(f"GW_{safe(w.section)}_{w.number}", FALSE)):
                set_by.setdefault(name, set()).add(w)
        found: dict[int, tuple[Calling, Path]] = {}
        for c in (c for g in self.w_opening() for c in g.callings):
            for r in self.w_routes_for(c):
                own = [p for p in self.r.paths.of(c) if set(self.w_kept_clear(p)) <= set_by.get(f"G_R{r}", set())]
                if len(own) == 1:
                    found[r] = c, own[0]
        return found

    def run_of(self, r: int) -> tuple[Calling, Path]:
        """Whom a route calls over which path."""
        need(r in self._runs, f"nothing tells over which path the route with number {r} leads")
        return self._runs[r]

    def w_unhindered(self, r: int) -> Formula:
        """The controller's own wire: nothing in its way is blocked or was trailed."""
        return leaf(f"UH_R{r}")

    def w_path_of_route(self, r: int) -> list[Path]:
        return [self.run_of(r)[1]]

    def w_own_ways(self, r: int) -> list[Way]:
        """The ways over which a route leads that must lie for it."""
        return [w for w in self.w_kept_clear(self.run_of(r)[1]) if w.points]

    def w_opened(self, r: int) -> Formula:
        return leaf(f"S_R{r}")

    def w_been_open(self, r: int) -> Formula:
        return leaf(f"H_R{r}")

    def w_set(self, r: int) -> Formula:
        return leaf(f"A_R{r}")

    def w_lockable_for_a_clear_movement(self, s: str) -> list[Way]:
        """The ways over which nobody is called on, and in which no shunting movement ends."""
        taken = set()
        for g in self.w_opening():
            for c in g.callings:
                calls = g.call_on and bool(self.lamps(g, CALL_ON)) and not c.shunt
                for p in self.r.paths.of(c):
                    if not self.r.paths.excluded(c, p):
                        called = calls and not self.r.paths.called_off(g, p)
                        taken |= {w for w in p.ways if called} | {w for w in p.ways[-1:] if p.berth}
        return [w for w in self.w_lockable(s) if w not in taken]

    def w_automatic(self, r: int) -> Formula:
        """The switch for automatic working of a train route, where the layout names such routes from its signal; there
        are no more of them than it names."""
        return leaf(f"AUTO_R{r}") if r in self._automatic else FALSE

    @cached_property
    def _automatic(self) -> set[int]:
        """The routes that are also asked for by a switch."""
        told, found = self.r.body.get("automatic") or (), set()
        named = [x["from"] for x in told]
        for g in dict.fromkeys(named):
            asked = {k: self.w.definitions.get(f"RQ_R{k}", FALSE) for k in self.train_routes(self.r.signals[g])}
            switched = {k for k, x in asked.items() if f"AUTO_R{k}" in set(names(x))}
            need(len(switched) <= named.count(g), f"more routes from {g} work automatically than the layout names")
            for r in switched:
                chosen = any(self.r.paths.chosen(x, *self._whole(r)) for x in told)
                need(chosen, f"a route from {g} works automatically that the layout does not name")
            found |= switched
        return found

    def _whole(self, r: int) -> tuple[Calling, Path]:
        """Whom a route calls over which path, with what lies past a signal that it passes."""
        c, p = self.run_of(r)
        return c, Path((*p.ways, *(w for b in self._beyond(r) for w in self.run_of(b)[1].ways)), p.berth)

    def w_requests(self) -> list[str]:
        """The inputs at which routes are asked for by number, the one that is heard first before the other."""
        order = {"none": ["REQ"], "first": ["LREQ", "REQ"], "last": ["REQ", "LREQ"]}
        return order[self.r.drawn.rules["local_requests"]]

    def w_asked(self, r: int) -> Formula:
        """The route's number comes after 0, and nothing comes at an input that is heard before."""
        found: list[Formula] = []
        quiet: list[Formula] = []
        for q in self.w_requests():
            found.append(every((*quiet, self.w_waits_for_number(q), leaf(f"{q}={r}"))))
            quiet.append(some((self.w_nothing_asked(q), no(self.w_waits_for_number(q)))))
        return some(found)

    def w_swinging(self) -> list[Signal]:
        """The signals with an overlap that may swing, in the order of their names."""
        return sorted((g for g in self.r.signals.values() if f"VS_{g.safe}" in self.state), key=lambda g: g.name)

    def w_swinging_beyond(self, p: Path) -> list[Signal]:
        """The signal at the end of a path, if its overlap may swing."""
        g = self.r.main_into.get((p.last.exit, self.r.track.beyond(p.last.section, p.last.exit) or ""))
        return [x for x in self.w_swinging() if g is not None and x.name == g.name]

    def w_swings(self, g: Signal) -> Formula:
        """The overlap of a signal is on its way from one alternative to another."""
        return leaf(f"VS_{g.safe}")

    def w_asked_to_swing(self, g: Signal) -> Formula:
        """The numbers of overlaps that swing come after those of all routes."""
        return self.w_asked(len(self.w_routes()) + 1 + self.w_swinging().index(g))

    def w_nothing_asked(self, q: str) -> Formula:
        return leaf(f"{q}=0")

    def w_waits_for_number(self, q: str) -> Formula:
        """The scan before has read 0."""
        return leaf(REQUESTS[q][0])

    def w_acknowledged(self, q: str) -> Formula:
        """The output that tells that a number was read."""
        return leaf(REQUESTS[q][1])

    # --- timers ---

    def w_timers(self) -> list[str]:
        return list(self.w.timers)

    def w_over(self, t: str) -> Formula:
        return leaf(t)

    def w_waits(self, t: str) -> Formula:
        need(t in self.w.timers, f"there is no timer {t}")
        return leaf(self.w.timers[t][0])

    def w_release_timer(self, s: str) -> str:
        return f"RT_{safe(s)}"

    def w_supervision_of(self, m: str) -> int:
        return whole_ms(self.lengths.supervision(m))

    def w_late_timer(self, m: str) -> str:
        return f"ST_{safe(m)}"

    def w_approach_timer(self, g: Signal) -> str:
        return f"AT_{g.safe}"

    def w_approach_timers(self, g: Signal) -> list[str]:
        return [self.w_approach_timer(g)]

    def w_standing_timer(self, g: Signal) -> str:
        return f"OT_{g.safe}"

    def w_standing_timers(self, g: Signal) -> list[str]:
        return [self.w_standing_timer(g)]

    def w_standing_timed(self) -> list[Signal]:
        """The signals whose overlap is released when a train stands."""
        return [g for g in self.w_overlapped() if f"OT_{g.safe}" in self.w.timers]

    def w_hand_timer(self, b: str) -> str:
        return f"BT_{safe(b)}"

    def w_hand_timers(self, b: str) -> list[str]:
        return [self.w_hand_timer(b)]

    def w_hold_timer(self, r: int) -> str:
        return f"AHT_R{r}"

    def w_restart_timer(self) -> str:
        return "RST"

    def w_start_timers(self) -> list[str]:
        return ["SGT"] if "SGT" in self.w.timers else []

    def w_can_be_counted(self, t: str) -> Formula:
        """The preset is a TIME on every controller: with one bit more it would be another duration there."""
        return fact(self.w.timers[t][1] <= LONGEST)

    def w_lasts(self, t: str, ms: int) -> Formula:
        """The timer's preset is no shorter."""
        return fact(t in self.w.timers and self.w.timers[t][1] >= ms)

    def seconds(self, name: str) -> int:
        """A principle that is a time, in milliseconds."""
        return whole_ms(self.r.drawn.rule(name))

    def word(self, name: str) -> Any:
        """Principles that are times are words, too."""
        if name.endswith("_s") and name in self.r.drawn.rules:
            return lambda: self.seconds(name)
        return super().word(name)

    def _kinds(self, g: Signal, trains: int, shunts: int) -> int:
        """The longer of two times, of those movements to which the signal opens."""
        return max(
            trains if self._routes_by(g, (*MAIN, *CALL_ON, *IDENTIFIER)) else 0,
            shunts if self._routes_by(g, WHITE) else 0,
        )

    def w_approach_release(self, g: Signal) -> int:
        own = self.r.body["signals"][g.name].get("release")
        if own is not None:
            return whole_ms(float(own))
        return self._kinds(g, self.seconds("approach_release_s"), self.seconds("shunt_release_s"))

    def w_overlap_release(self, g: Signal) -> int:
        return self.lengths.overlap_release(g)

    def w_until_standing(self, g: Signal) -> int:
        """Until a train in the section before a signal stands: delay of outputs, reaction, braking."""
        return self.lengths.halt(self.lengths.kmh(self.lengths.before(g)))

    def w_until_passed_or_standing(self, g: Signal) -> int:
        """Until whoever saw proceed has passed or stands; a shunting movement is slower."""
        trains = self.lengths.halt(fastest_told(self.lengths, g))
        return self._kinds(g, trains, self.lengths.halt(self.r.drawn.rule("shunt_speed_kmh")))

    def w_until_all_stand(self) -> int:
        return self.lengths.until_all_stand()


def _in_turn(r: int, of: Callable[[int], list[int]]) -> list[int]:
    """What comes after a route, what comes after that, and so on, each once."""
    found: dict[int, None] = {}
    todo = list(of(r))
    while todo:
        x = todo.pop(0)
        todo += of(x) if x not in found else []
        found[x] = None
    return list(found)
