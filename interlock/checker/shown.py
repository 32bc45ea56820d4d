"""What the words of the specification mean that tell who shows proceed over what, what is hostile, and what could roll
in from a flank (R5, R6)."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise

from interlock.checker.added import Added
from interlock.checker.drawing import Diamond, Edge
from interlock.checker.formula import FALSE, TRUE, Formula, every, leaf, no, some
from interlock.checker.railway import Calling, Path, Signal
from interlock.checker.track import Way

_Past = tuple[bool, bool]
"""Whether a derailer, or an inclined lane, has been passed, behind which nothing is trusted to stand; and whether a
section that runs the other way."""


@dataclass(frozen=True)
class Shown:
    """Proceed is shown over a way, as the points lie; by whom."""

    by: Calling
    so: Formula


@dataclass(frozen=True)
class Flank:
    """A track over which a vehicle could come to a point or diamond on a way: its edge at the place, and how far away a
    vehicle must stand that is held there.  own: the section of the way.  waived: the author gives the protection up,
    with a reason."""

    edge: Edge
    node: str
    needed: float
    own: str
    waived: bool = False


class Protection(Added):
    """Words of hostile signals and of flanks."""

    def w_lies(self, x: str | Way | Path, position: str | None = None) -> Formula:
        """A machine really lies so; all machines of a way or a path do."""
        if isinstance(x, str):
            return leaf(f"at.{x}.{position}")
        ways = (x,) if isinstance(x, Way) else x.ways
        return every(leaf(f"at.{d.machine}.{d.position}") for w in ways for _, d in w.points)

    @cached_property
    def _over(self) -> dict[Way, list[Shown]]:
        found: dict[Way, list[Shown]] = {}
        for c in (c for g in self.w_signals() for c in g.callings):
            for p in self.r.paths.of(c):
                so = every((self.w_shows(c), self.w_lies(p)))
                for w in p.ways:
                    found.setdefault(w, []).append(Shown(c, so))
        return found

    def _pairs(self, s: str, opposing: bool) -> list[tuple[Way, Way]]:
        ways = [w for w in self.r.track.ways[s] if w in self._over]
        pairs = [(a, b) for i, a in enumerate(ways) for b in ways[i + 1 :]]
        return [(a, b) for a, b in pairs if (a.entry == b.exit or a.exit == b.entry) is opposing]

    def w_opposing(self, s: str) -> list[tuple[Way, Way]]:
        """Ways of a section that lead towards each other."""
        return self._pairs(s, True)

    def w_following(self, s: str) -> list[tuple[Way, Way]]:
        """Other pairs of its ways."""
        return self._pairs(s, False)

    def w_first(self, c: tuple[Way, Way]) -> Way:
        return c[0]

    def w_second(self, c: tuple[Way, Way]) -> Way:
        return c[1]

    def w_shown_over(self, w: Way) -> Formula:
        """Some signal shows proceed over a path with the way, as the points lie."""
        return some(x.so for x in self._over.get(w, ()))

    def w_shown_over_way(self, w: Way) -> list[Formula]:
        return [x.so for x in self._over.get(w, ())]

    def w_after_scan(self, x: Formula) -> Formula:
        return self.after(x)

    def w_callings_over(self, w: Way) -> list[Calling]:
        """Whatever has a path with the way, however the points lie."""
        return list(dict.fromkeys(x.by for x in self._over.get(w, ())))

    def w_past(self, g: Signal) -> Formula:
        """Some signal shows proceed over a path that passes this one."""
        found = []
        for c in (c for h in self.w_signals() for c in h.callings):
            for p in self.r.paths.of(c):
                if any((a.exit, b.section) == (g.node, g.into) for a, b in pairwise(p.ways)):
                    found.append(every((self.w_shows(c), self.w_lies(p))))
        return some(found)

    # --- diamonds and foul joints ---

    def _over_arm(self, d: Diamond, arm: int) -> list[Way]:
        return [w for s in self.r.track.sections for w in self.r.track.ways[s] if (d.name, arm) in w.arms]

    def w_diamonds_of_two(self) -> list[Diamond]:
        """Diamonds whose arms lie in two sections."""
        return [d for d in self.r.drawn.diamonds.values() if self.w_section_one(d) != self.w_section_two(d)]

    def w_section_one(self, d: Diamond) -> str:
        return self.r.drawn.edges[d.arms[0][0]].section

    def w_section_two(self, d: Diamond) -> str:
        return self.r.drawn.edges[d.arms[1][0]].section

    def w_over_arm_one(self, d: Diamond) -> list[Way]:
        return self._over_arm(d, 0)

    def w_over_arm_two(self, d: Diamond) -> list[Way]:
        return self._over_arm(d, 1)

    def _by_whom(self, ways: Iterable[Way]) -> dict[Calling, Formula]:
        """Who shows proceed over one of these ways, and when."""
        found: dict[Calling, list[Formula]] = {}
        for x in (x for w in ways for x in self._over.get(w, ())):
            found.setdefault(x.by, []).append(x.so)
        return {who: some(so) for who, so in found.items()}

    def _between(self, a: Iterable[Way], b: Iterable[Way]) -> list[tuple[Formula, Formula]]:
        """Two callings that show proceed, the one over one of the ways of `a`, the other over one of `b`.

        They are not told pair by pair, whose number is the product of theirs: all that have ways of `a` alone are
        against all of `b`, and whoever has ways of both against all others of `b`.
        """
        one, other = self._by_whom(a), self._by_whom(b)
        found = [(some(x for who, x in one.items() if who not in other), some(other.values()))]
        for who, x in one.items():
            if who in other:
                found.append((x, some(y for they, y in other.items() if they != who)))
        return found

    def w_hostile_at_diamonds(self) -> list[tuple[Formula, Formula]]:
        those = self.r.drawn.diamonds.values()
        return [x for d in those for x in self._between(self._over_arm(d, 0), self._over_arm(d, 1))]

    def w_hostile_at_foul_joints(self) -> list[tuple[Formula, Formula]]:
        """Over a fouled way, and over a way beside that leads to the joint; over any, where no point tells."""
        found = []
        for f in self.lengths.foul_joints:
            beside = [w for w in self.r.track.ways[f.neighbour] if f.when is None or f.node in (w.entry, w.exit)]
            found += self._between(self.w_fouled_ways(f), beside)
        return found

    def w_declared_hostile(self) -> list[tuple[Formula, Formula]]:
        """Routes of two signals that the author declares hostile: each shown along its path, call-on routes by calling
        on."""
        found = []
        those = [(c, p) for g in self.w_signals() for c in g.callings for p in self.r.paths.of(c)]

        def so(kind: str | None, c: Calling, p: Path) -> Formula:
            return every((self.w_calls_on(c.signal) if kind == "call-on" else self.w_shows(c), self.w_lies(p)))

        for x in self.r.body.get("hostile") or ():
            one, other = ([(c, p) for c, p in those if self.r.paths.chosen(x[k], c, p)] for k in ("one", "other"))
            for c, p in one:
                for b, q in other:
                    if b.signal != c.signal:
                        found.append((so(x["one"].get("kind"), c, p), so(x["other"].get("kind"), b, q)))
        return found

    def w_shown_first(self, h: tuple[Formula, Formula]) -> Formula:
        return h[0]

    def w_shown_second(self, h: tuple[Formula, Formula]) -> Formula:
        return h[1]

    # --- flanks ---

    def w_flanks(self, w: Way) -> list[Flank]:
        """The other leg of each point on a way, and both edges of the other arm of each diamond."""
        d, found = self.r.drawn, []
        margin = d.rule("clearance_m")
        waived = {str(x["flank"]) for x in self.r.body.get("waive") or ()}
        for name, demand in w.points:
            p = d.points[name]
            leg = f"{name}.{'normal' if demand.opposite == 'N' else 'reverse'}"
            found.append(Flank(d.edges[p.leg(demand.opposite)], name, p.fouling + margin, w.section, leg in waived))
        for name, arm in w.arms:
            for e in d.diamonds[name].arms[1 - arm]:
                found.append(Flank(d.edges[e], name, d.diamonds[name].fouling + margin, w.section))
        return found

    def w_spaced_flanks(self, w: Way) -> list[Flank]:
        """Those not waived, where the principles ask for clear flank space or intact stop lamps."""
        asked = self.r.drawn.asks("flank_space") or self.r.drawn.asks("flank_lamp")
        return [x for x in self.w_flanks(w) if asked and not x.waived]

    def w_exposed(self, x: Flank) -> Formula:
        """A vehicle could roll over a flank, from beyond the next signal that could hold it, from an inclined lane, or
        from a buffer or round a ring behind a derailer, as everything lies."""
        return self._rolls(x, x.edge, x.node, 0.0, frozenset({x.node}), False, False)

    def _rolls(
        self, x: Flank, e: Edge, node: str, gone: float, seen: frozenset[str], derailer: bool, against: bool
    ) -> Formula:
        """derailer: one, or an inclined lane, has been passed, behind which nothing is trusted to stand.  against: past
        a section that runs the other way, over which nothing else comes."""
        far, gone, derailer, against = e.far(node), gone + e.length, derailer or e.inclined, against or e.none_to(node)
        if against and not derailer and (e.name, node) not in self._untrusted:
            return FALSE
        if e.inclined and e.section not in (x.own, x.edge.section):
            return no(self._empty(e, node, seen))
        if far in seen or far in self.r.drawn.buffers:
            return TRUE if derailer and (far in seen or far in self._stops) else FALSE
        g = self._holding(e, far, gone, x.needed)
        if g is not None:
            return self._lets_pass(g)
        if far in self.r.drawn.boundaries:
            return FALSE if self.r.drawn.boundaries[far].get("trains") == "out" and not derailer else TRUE
        kept = self.r.drawn.points[far].position(e.name) if far in self._derailers else None
        derailer = derailer or kept is not None
        onward = self.r.drawn.onward(far, e)
        rolls = some(self._rolls(x, b, far, gone, seen | {far}, derailer, against) for b in onward)
        return every((rolls, no(self._turned_away(e, far))))

    @cached_property
    def _untrusted(self) -> set[tuple[str, str]]:
        """Edges, each from one end, over which one comes sooner or later to an inclined lane or past a derailer."""
        d, found = self.r.drawn, set[tuple[str, str]]()
        runs = [(e, node) for e in d.edges.values() for node in (e.a, e.b)]
        grown = True
        while grown:
            before = len(found)
            for e, node in runs:
                far = e.far(node)
                kept = far in self._derailers and d.points[far].position(e.name) is not None
                if e.inclined or kept or any((b.name, far) in found for b in d.onward(far, e)):
                    found.add((e.name, node))
            grown = len(found) > before
        return found

    def _empty(self, e: Edge, node: str, seen: frozenset[str]) -> Formula:
        """Nothing can be on an inclined lane: it ends in a trap."""
        far = e.far(node)
        if far in seen or far in self.r.drawn.boundaries or far in self._stops:
            return FALSE
        if far in self.r.drawn.buffers:
            return TRUE
        out = [
            self._empty(b, far, seen | {far}) if b.section == e.section else FALSE for b in self.r.drawn.onward(far, e)
        ]
        return every(out)

    @cached_property
    def _stops(self) -> frozenset[str]:
        return frozenset(str(x) for x in self.r.body.get("buffers") or ())

    @cached_property
    def _derailers(self) -> frozenset[str]:
        return frozenset(str(x) for x in self.r.body.get("derailers") or ())

    def _turned_away(self, e: Edge, node: str) -> Formula:
        """A point that would be trailed lies for its other leg."""
        p = self.r.drawn.points.get(node)
        x = None if p is None else p.position(e.name)
        return FALSE if p is None or x is None else leaf(f"at.{p.machine}.{'R' if x == 'N' else 'N'}")

    def _lets_pass(self, g: Signal) -> Formula:
        """It shows proceed, or did a scan ago, or somebody has accepted it; a train passes a shunt signal on a lock."""
        found = [self.w_shows(c) for c in g.callings]
        found += [leaf(f"{x}.{g.name}") for c in g.callings for x in (c.lamp, c.go)]
        if not g.main:
            locked = some(self.w_locked(w) for w in self.w_locked_from(g.into, g.node))
            found.append(every((self.w_for_train(g.into), self.w_firm(g.into), locked)))
        return some(found)

    def w_quiet(self, own: str, x: Flank) -> Formula:
        """Nothing stands along a flank up to what stops a vehicle, as everything lies; stop lamps there are intact.

        Where another movement may be called meanwhile that does not use the section, a train stands on its own route.
        """
        beside = frozenset(s for s, those in self._movements.items() if any(own not in over for over in those))
        looked_at = frozenset(self.r.track.sections) - {own, *self.r.track.undetected, *beside}
        asked = looked_at if self.r.drawn.asks("flank_space") else frozenset()
        return self._silent(asked, x.edge, x.node, 0.0, x.needed, frozenset({x.node}), (False, False))

    @cached_property
    def _movements(self) -> dict[str, list[frozenset[str]]]:
        """For each section the paths over it, as sections; none at all for what stands there before its path or at the
        end of one.  Nobody is called into a trap."""
        found: dict[str, list[frozenset[str]]] = {}
        traps = set(self.r.body.get("traps") or ())
        for c in (c for g in self.w_signals() for c in g.callings):
            rear = self.r.track.beyond(c.signal.into, c.signal.node)
            for p in (x for x in self.r.paths.of(c) if x.last.exit not in traps):
                over = frozenset(w.section for w in p.ways)
                for s in over:
                    found.setdefault(s, []).append(over)
                for s in [*([] if rear is None else [rear]), *self.w_berth_of(p)]:
                    found.setdefault(s, []).append(frozenset())
        return found

    def _silent(
        self, asked: frozenset[str], e: Edge, node: str, gone: float, needed: float, seen: frozenset[str], past: _Past
    ) -> Formula:
        """asked: the sections that must be clear.  That of a point which turns vehicles away is no flank space."""
        d, far = self.r.drawn, e.far(node)
        if not self._comes(e, node, past):
            return TRUE
        clear = self.w_steadily_clear(e.section) if e.section in asked else TRUE
        if far in seen or far in self.r.drawn.buffers:
            return clear
        g = self._holding(e, far, gone + e.length, needed)
        if g is not None:
            intact = d.asks("flank_lamp") and d.asks("lamp_proof")
            return every((clear, leaf(f"RL_{g.safe}"))) if intact else clear
        if far in self.r.drawn.boundaries:
            return clear
        beyond, run = self._passed(e, node, past), gone + e.length
        onward = (self._silent(asked, x, far, run, needed, seen | {far}, beyond) for x in self.r.drawn.onward(far, e))
        return some((self._points_turn_away(e, node, gone, needed, seen, past), every((clear, *onward))))

    def _points_turn_away(
        self, e: Edge, node: str, gone: float, needed: float, seen: frozenset[str], past: _Past
    ) -> Formula:
        """Points of the very section turn a vehicle away, wherever it could come from."""
        far = e.far(node)
        if not self._comes(e, node, past):
            return TRUE
        held = self._holding(e, far, gone + e.length, needed) is not None
        if far in seen or far in self.r.drawn.buffers or far in self.r.drawn.boundaries or held:
            return FALSE
        beyond, run = self._passed(e, node, past), gone + e.length
        inside = every(
            self._points_turn_away(x, far, run, needed, seen | {far}, beyond) if x.section == e.section else FALSE
            for x in self.r.drawn.onward(far, e)
        )
        return some((self.after(self._turned_away(e, far)), inside))

    def _comes(self, e: Edge, node: str, past: _Past) -> bool:
        """Something comes over an edge: against its one way, or from beyond a section that runs so, only what runs away
        from an inclined lane, or from behind a derailer."""
        derailer, against = past
        return derailer or not (against or e.none_to(node)) or (e.name, node) in self._untrusted

    def _passed(self, e: Edge, node: str, past: _Past) -> _Past:
        derailer, against = past
        kept = e.far(node) in self._derailers and self.r.drawn.points[e.far(node)].position(e.name) is not None
        return derailer or e.inclined or kept, against or e.none_to(node)

    def _holding(self, e: Edge, node: str, gone: float, needed: float) -> Signal | None:
        """The signal that holds a vehicle there, far enough away."""
        g = self.r.signal_into.get((node, e.section))
        return g if g is not None and gone >= needed else None

    # --- scissors ---

    def w_partners(self, w: Way) -> list[str]:
        """The machines of the other crossover of a scissors on a way: plain track leads from both ends of the other arm
        to the reverse leg of a point."""
        found: list[str] = []
        for name, arm in w.arms:
            ends = [self._crossover_end(e, name) for e in self.r.drawn.diamonds[name].arms[1 - arm]]
            found += [m for m in ends if m is not None] if None not in ends else []
        return list(dict.fromkeys(found))

    def _crossover_end(self, edge: str, node: str) -> str | None:
        d, seen = self.r.drawn, {node}
        e = d.edges[edge]
        node = e.far(node)
        while node not in d.points:
            onward = [x for x in d.at[node] if x.name != e.name]
            if node in seen or len(onward) != 1:
                return None
            seen.add(node)
            e = onward[0]
            node = e.far(node)
        p = d.points[node]
        return p.machine if p.reverse == e.name else None
