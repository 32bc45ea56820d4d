"""What the words of the specification mean that tell how the world moves: heads, tails, drivers, points, reports, the
line beyond a boundary with its neighbour; and which of its events there are at all."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from interlock.checker.formula import FALSE, Formula, every, leaf, no, some
from interlock.checker.railway import Calling, Signal, safe
from interlock.checker.shown import Protection
from interlock.checker.track import Way


@dataclass(frozen=True)
class Count:
    """A step in counting what is in a zone: of its first items so many."""

    zone: str
    item: int
    count: int


@dataclass(frozen=True)
class WayIn:
    """A section of a zone and an end beyond which the zone does not lie."""

    zone: str
    section: str
    joint: str


class World(Protection):
    """All words: those of topology, of terminals, of protection, and those of the world's steps."""

    def __init__(self, *given: Any) -> None:
        super().__init__(*given)
        self.events: dict[str, Formula] = {}
        """The world's events, as far as the specification has defined them; what can never happen is FALSE."""

    def event(self, name: str) -> Formula:
        """An event by its name; FALSE where there is none, or where it can never happen."""
        x = self.events.get(name, FALSE)
        return x if x[0] in "TF" else leaf(name)

    # --- who stands where ---

    def w_occupied(self, s: str) -> Formula:
        return leaf(f"o.{s}")

    def w_standing(self, s: str) -> Formula:
        """What is in the section has stood there since the restart and was not called."""
        return leaf(f"rest.{s}")

    def w_came(self, s: str, j: str) -> Formula:
        return leaf(f"in.{s}.{j}")

    def w_across(self, j: str, s: str) -> Formula:
        return leaf(f"x.{j}.{s}")

    def w_coming(self, s: str, j: str) -> Formula:
        """A train stands across an end on its way in, from the neighbour or from outside."""
        if j in self.r.drawn.buffers or (j in self.r.drawn.boundaries and (j, s) not in self.r.signal_into):
            return FALSE
        return self.w_across(j, self.across_of(s, j))

    def w_heading_to(self, s: str, j: str) -> Formula:
        """The train in a section heads for one of its ends, as the points lie."""
        return some(every((self.w_came(s, w.entry), self.w_lies(w))) for w in self.w_leading_to(s, j))

    def w_lies_some(self, t: Way) -> Formula:
        """The points lie for some way with the same ends."""
        return some(self.w_lies(w) for w in self.r.track.ways[t.section] if (w.entry, w.exit) == (t.entry, t.exit))

    def w_shunting(self, s: str) -> Formula:
        return leaf(f"sh.{s}") if self.r.shunting else FALSE

    def w_shunting_sections(self) -> list[str]:
        return self.r.track.sections if self.r.shunting else []

    def w_running(self, s: str) -> Formula:
        return leaf(f"run.{s}")

    def w_overran(self, h: Signal, s: str) -> Formula:
        return leaf(f"over.{h.name}.{s}")

    def w_slow(self, s: str, kmh: int) -> Formula:
        """The train in a section was called at no more than a speed."""
        return leaf(f"slow.{kmh}.{s}")

    def w_fast(self, c: Calling, kmh: int) -> Formula:
        """Whoever accepts the signal may have been shown that more is permitted."""
        return leaf(f"fast.{kmh}.{c.name}")

    def w_was_called(self, s: str) -> Formula:
        return leaf(f"called.{s}")

    def w_was_parted(self, s: str) -> Formula:
        """The rear part of a train that parted has been left in the section."""
        return leaf(f"part.{s}")

    def w_turning(self, g: Signal, m: str) -> Formula:
        return leaf(f"turns.{g.name}.{m}")

    def w_been(self, s: str) -> Formula:
        return leaf(f"been.{s}")

    def w_shut(self, r: int) -> Formula:
        return leaf(f"shut.R{r}")

    # --- heads and tails ---

    def w_goes(self, j: str, s: str) -> Formula:
        return self.event(f"head.{j}.{s}")

    def w_leaves(self, j: str, s: str) -> Formula:
        return self.event(f"tail.{j}.{s}")

    def w_into(self, s: str, j: str) -> Formula:
        """A head comes into a section at one of its ends."""
        return FALSE if j in self.r.drawn.buffers else self.event(f"head.{j}.{self.across_of(s, j)}")

    def w_shunts_into(self, s: str, j: str) -> Formula:
        return FALSE if j in self.r.drawn.buffers else self.event(f"shunts.{j}.{self.across_of(s, j)}")

    def w_overruns_into(self, h: Signal, s: str, j: str) -> Formula:
        return FALSE if j in self.r.drawn.buffers else self.event(f"overruns.{h.name}.{j}.{self.across_of(s, j)}")

    def w_overruns_at(self, h: Signal, s: str, j: str) -> Formula:
        """What leaves a section there has overrun a signal."""
        return self.event(f"overruns.{h.name}.{j}.{s}")

    def w_comings(self, s: str) -> list[tuple[str, str]]:
        """Where heads may come into a section: joint, and the section that they come from."""
        return [(j, self.across_of(s, j)) for j in self.r.track.ends[s] if self.w_into(s, j) != FALSE]

    def w_comes(self, c: tuple[str, str]) -> Formula:
        return self.event(f"head.{c[0]}.{c[1]}")

    def w_comes_shunting(self, c: tuple[str, str]) -> Formula:
        return self.event(f"shunts.{c[0]}.{c[1]}")

    def w_appears(self, outside: str) -> Formula:
        return self.event(f"appear.{outside}")

    def w_fails(self, g: Signal) -> Formula:
        return self.event(f"fails.{g.name}")

    def _turned(self, s: str, a: str | None, b: str | None) -> Formula:
        those = [t for t in self.w_turning_ways() if t.section == s and a in (None, t.entry) and b in (None, t.exit)]
        return some(self.event(f"turn.{s}.{t.entry}.{t.exit}") for t in those)

    def w_turns(self, s: str) -> Formula:
        return self._turned(s, None, None)

    def w_turned_from(self, s: str, j: str) -> Formula:
        return self._turned(s, j, None)

    def w_turned_to(self, s: str, j: str) -> Formula:
        return self._turned(s, None, j)

    def w_parts(self, s: str) -> Formula:
        """The train parts, and its rear stays in the section."""
        return self.event(f"parts.{s}")

    def w_left_behind(self, s: str) -> Formula:
        return leaf(f"?stay.{s}")

    # --- drivers, points, reports ---

    def w_seen(self, c: Calling) -> Formula:
        return some((self.w_shows(c), self.w_was_shown(c)))

    def w_was_shown(self, c: Calling) -> Formula:
        return leaf(f"{c.lamp}.{c.name}")

    def w_accepts(self, c: Calling) -> Formula:
        return self.event(f"{c.accept}.{c.name}")

    def w_accepted(self, c: Calling) -> Formula:
        return leaf(f"{c.go}.{c.name}")

    def w_refuses(self, c: Calling) -> Formula:
        return self.event(f"refuse.{c.name}")

    def w_starts(self, m: str, x: str) -> Formula:
        """A machine begins to leave a position."""
        return self.event(f"start.{m}.{x}")

    def w_arrives(self, m: str, x: str) -> Formula:
        return self.event(f"arrive.{m}.{x}")

    def w_was_driven(self, m: str, x: str) -> Formula:
        return leaf(f"cmd.{m}.{x}")

    def w_scanned(self, s: str) -> Formula:
        return leaf(f"img.{s}")

    # --- clocks of the world, and what is remembered of the controller's delays ---

    def w_stopped(self, g: Signal) -> Formula:
        return leaf(f"long.stop.{g.name}")

    def w_stood_long(self, g: Signal) -> Formula:
        return leaf(f"long.stand.{g.name}")

    def w_held_long(self, b: str) -> Formula:
        return leaf(f"long.agreed.{b}")

    def w_chance_stop(self, g: Signal) -> Formula:
        return leaf(f"?long.stop.{g.name}")

    def w_chance_stand(self, g: Signal) -> Formula:
        return leaf(f"?long.stand.{g.name}")

    def w_chance_held(self, b: str) -> Formula:
        return leaf(f"?long.agreed.{b}")

    def w_cancelling(self, g: Signal) -> Formula:
        return self.w_waits(self.w_approach_timer(g))

    def w_standing_runs(self, g: Signal) -> Formula:
        return self.w_waits(self.w_standing_timer(g))

    def w_hand_runs(self, b: str) -> Formula:
        return self.w_waits(self.w_hand_timer(b))

    def w_covered(self, g: Signal) -> Formula:
        return leaf(f"cov.{self.w_approach_timer(g)}")

    def w_stand_covered(self, g: Signal) -> Formula:
        return leaf(f"cov.{self.w_standing_timer(g)}")

    def w_hand_covered(self, b: str) -> Formula:
        return leaf(f"cov.{self.w_hand_timer(b)}")

    # --- zones: each train counts in the rearmost of its sections, and where it has been called in ---

    def w_zones(self) -> list[str]:
        return list(self.r.body.get("zones") or {})

    def _inside(self, z: str) -> list[str]:
        return sorted(set(self.r.body["zones"][z]["sections"]))

    def w_ways_in(self, z: str) -> list[WayIn]:
        inside = self._inside(z)
        ends = [(s, j) for s in inside for j in self.w_open_ends(s)]
        return [WayIn(z, s, j) for s, j in ends if self.r.track.beyond(s, j) not in inside]

    def w_way_section(self, i: WayIn) -> str:
        return i.section

    def w_way_joint(self, i: WayIn) -> str:
        return i.joint

    def _items(self, z: str) -> list[Formula]:
        """One for each train that may be there or has been called in, those called in this step last."""
        inside, ways_in = self._inside(z), self.w_ways_in(z)
        called = {i: self.w_called_in(i) for i in ways_in}
        found = []
        for s in inside:
            rear = [(j, o) for j in self.r.track.ends[s] if (o := self.r.track.beyond(s, j)) in inside]
            rearmost = every((self.w_occupied(s), *(no(self.w_across(j, str(o))) for j, o in rear)))
            found.append(some((rearmost, *(called[i] for i in ways_in if i.section == s))))
        return found + [every((self.after(called[i]), no(called[i]))) for i in ways_in]

    def w_called_in(self, i: WayIn) -> Formula:
        """A section is locked for a train that comes into a zone and has not come yet."""
        locked = some(self.w_locked(w) for w in self.w_locked_from(i.section, i.joint))
        return every((locked, no(self.w_been(i.section))))

    def _most(self, z: str) -> int:
        return int(self.r.body["zones"][z]["trains"])

    def w_counts(self) -> list[Count]:
        those = [(z, i) for z in self.w_zones() for i in range(1, len(self._items(z)) + 1)]
        return [Count(z, i, k) for z, i in those for k in range(1, min(i, self._most(z) + 1) + 1)]

    def w_counted(self, n: Count) -> Formula:
        return self._items(n.zone)[n.item - 1]

    def w_one_fewer_before(self, n: Count) -> Formula:
        """Of the items before it one fewer."""
        return self.event(f"zone.{n.zone}.{n.item - 1}.{n.count - 1}") if n.count > 1 else self.w_true()

    def w_as_many_before(self, n: Count) -> Formula:
        """Of the items before it as many already."""
        return self.event(f"zone.{n.zone}.{n.item - 1}.{n.count}") if n.count < n.item else FALSE

    def w_too_many(self, z: str) -> Formula:
        most, items = self._most(z), len(self._items(z))
        return self.event(f"zone.{z}.{items}.{most + 1}") if items > most else FALSE

    def w_too_full(self, z: str) -> Formula:
        return self.event(f"zone.{z}")

    # --- a line with a direction token, and the neighbour at its other end (R12) ---

    def w_has(self) -> str:
        return "has"

    def w_gives(self) -> str:
        return "gives"

    def w_tidings(self) -> list[str]:
        """What either end tells the other: he has the direction, he gives it."""
        return ["has", "gives"]

    def w_he(self, b: str, word: str) -> Formula:
        """The neighbour has the direction, or gives it."""
        return leaf(f"token.{word}.{b}")

    def w_he_is_ready(self, b: str) -> Formula:
        """He has seen the direction not given since he last took it."""
        return leaf(f"token.fresh.{b}")

    def w_told(self, b: str, word: str) -> Formula:
        """The last telegram from him said so."""
        return leaf(f"tel.{word}.{b}")

    def w_he_saw(self, b: str, word: str) -> Formula:
        """The last telegram that reached him said so of us."""
        return leaf(f"saw.{word}.{b}")

    def w_we(self, b: str, word: str) -> Formula:
        """Our words to him, at the terminals."""
        return leaf(f"{'YTH' if word == 'has' else 'YTG'}_{safe(b)}")

    def w_told_kept(self, b: str) -> Formula:
        return leaf(f"YTN_{safe(b)}")

    def w_told_asked(self, b: str) -> Formula:
        return leaf(f"YTA_{safe(b)}")

    def w_we_have(self, b: str) -> Formula:
        """The controller's own bit."""
        return leaf(f"BH_{safe(b)}")

    def w_we_give(self, b: str) -> Formula:
        return leaf(f"BG_{safe(b)}")

    def w_reads_gives(self, b: str) -> Formula:
        return leaf(f"NG_{safe(b)}")

    def w_reads_keeps(self, b: str) -> Formula:
        return leaf(f"NN_{safe(b)}")

    def w_reads_has(self, b: str) -> Formula:
        return leaf(f"NH_{safe(b)}")

    def w_reads_clear(self, b: str) -> Formula:
        return leaf(f"LC_{safe(b)}")

    def w_hand_held(self, b: str) -> Formula:
        return leaf(f"TKN_{safe(b)}")

    def w_line_out(self, b: str) -> Formula:
        return leaf(f"line.out.{b}")

    def w_line_in(self, b: str) -> Formula:
        return leaf(f"line.in.{b}")

    def w_sent(self, b: str) -> Formula:
        """A train of his is on the line, or before our entry signal."""
        return some((self.w_line_in(b), self.w_occupied(self.outside(b))))

    def w_departs(self, b: str) -> Formula:
        return self.event(f"head.{b}.{self.r.drawn.at[b][0].section}")

    def w_sends(self, b: str) -> Formula:
        return self.event(f"sends.{b}")

    def w_he_takes(self, b: str) -> Formula:
        return self.event(f"neighbour.takes.{b}")

    def w_takes_by_hand(self, b: str) -> Formula:
        return self.event(f"neighbour.manual.{b}")

    def w_he_gives_now(self, b: str) -> Formula:
        return self.event(f"neighbour.gives.{b}")

    def w_he_restarts(self, b: str) -> Formula:
        return self.event(f"neighbour.lost.{b}")

    def w_chance_telegram(self, b: str) -> Formula:
        return leaf(f"?telegram.{b}")

    def w_chance_tells(self, b: str) -> Formula:
        return leaf(f"?tells.{b}")

    def w_chance_arrived(self, b: str) -> Formula:
        return leaf(f"?arrived.{b}")

    def w_chance_last(self, b: str) -> Formula:
        return leaf(f"?last.{b}")
