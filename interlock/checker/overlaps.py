"""Overlaps (R4): from the signal to the first joint at or beyond their length, and for which speed each is made."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise

from interlock.checker.drawing import Unread
from interlock.checker.railway import Calling, Path, Railway, Run, Signal
from interlock.checker.track import Way
from interlock.verify import need


@dataclass(frozen=True)
class Wanted:
    """What is asked of the alternatives of an overlap over some sections; `kmh`: it is made for that speed."""

    over: frozenset[str]
    metres: float
    kmh: float | None


class Overlaps:
    """Of one railway."""

    def __init__(self, railway: Railway) -> None:
        self.r, self._d = railway, railway.drawn

    @cached_property
    def overlaps(self) -> dict[str, list[Path]]:
        """For each signal with an overlap its alternatives: those over fewest reversed points first."""
        found = {}
        for g in self.r.signals.values():
            wanted = self._wanted(g)
            if not g.main or g.node in self.r.drawn.boundaries or wanted[-1].metres <= 0:
                need(len(wanted) == 1, f"overlaps of {g.name} are stated, and it has none")
                continue
            plain = self._those(g, wanted)
            # where a shorter alternative joins a longer one, it goes on as far: nobody knows how a train came there;
            # but for one inside a longer one that counts for trains that were shown no more than its speed
            steps = frozenset((a.section, a.exit, b.section) for ways in plain for a, b in pairwise(ways))
            those = self._those(g, wanted, steps, self._short(g, plain))
            those.sort(key=lambda ws: (_reversed(ws), [(w.section, w.number) for w in ws]))
            counts = [self._counts(wanted, ways) for ways in those]
            for x in wanted[:-1]:
                over = ", ".join(sorted(x.over))
                need(x in counts, f"what is stated of the overlap of {g.name} over {over} is said of no way")
            missing = f"routes lead to {g.name}, and no way beyond {g.name} is an overlap"
            need(those != [] or not self._led_to(g), missing)
            if those:
                found[g.name] = [Path(ways) for ways in those]
        return found

    def _led_to(self, g: Signal) -> bool:
        """A route of trains may end at a signal: the author does not exclude all that could."""
        paths = self.r.paths
        for c in (Calling(x, False) for x in self.r.signals.values() if x.main):
            runs = (u for p in paths.of(c) for u in (Run((p,), ()), *paths.runs(p)))
            for p in (u.whole for u in runs if self._ends_at(u.last, g)):
                if paths.can_be(c, p) and not paths.barred(c, p, c.signal.call_on):
                    return True
        return False

    def _ends_at(self, p: Path, g: Signal) -> bool:
        return p.last.exit == g.node and self.r.track.beyond(p.last.section, p.last.exit) == g.into

    @staticmethod
    def _counts(wanted: list[Wanted], ways: tuple[Way, ...]) -> Wanted:
        """What is asked of an alternative: the first that fits it."""
        passed = {w.section for w in ways}
        return next(x for x in wanted if x.over <= passed)

    def short(self, g: Signal) -> dict[Path, float]:
        """The alternatives of a signal's overlap that lie inside longer ones and count by themselves: the speed."""
        return {Path(ways): v for ways, v in self._short(g, self._those(g, self._wanted(g))).items()}

    def _short(self, g: Signal, plain: list[tuple[Way, ...]]) -> dict[tuple[Way, ...], float]:
        """A short one is for less than every longer one, and whoever comes to its sections has come along it, as
        through each of them one way alone leads to where it leaves them."""
        found = {}
        for a in plain:
            kmh = self.entry_kmh(g, Path(a))
            longer = [self.entry_kmh(g, Path(b)) for b in plain if b != a and b[: len(a)] == a]
            mine = {w.section: n for n, w in enumerate(a)}
            elsewhere = any(
                w.section in mine and (n != mine[w.section] or b[:n] != a[:n]) for b in plain for n, w in enumerate(b)
            )
            elsewhere |= any(
                len([x for x in self.r.track.from_end(w.section, w.entry) if x.exit == w.exit]) > 1 for w in a
            )
            if kmh is not None and longer and not elsewhere and not any(v is not None and v <= kmh for v in longer):
                found[a] = kmh
        return found

    def _wanted(self, g: Signal) -> list[Wanted]:
        """What is asked of the alternatives of a signal's overlap: the first that fits counts, the last fits all."""
        told = (self.r.body.get("overlaps") or {}).get(g.name)
        own = (
            []
            if told is None
            else [Wanted(frozenset(x["over"]), self._metres(x), _entry(x)) for x in told.get("ways") or ()]
        )
        return [*own, Wanted(frozenset(), self._metres(told), _entry(told or {}))]

    def entry_kmh(self, g: Signal, overlap: Path) -> float | None:
        """The speed for which an alternative of a signal's overlap is made."""
        return self._counts(self._wanted(g), overlap.ways).kmh

    def _those(
        self,
        g: Signal,
        wanted: list[Wanted],
        steps: frozenset[tuple[str, str, str]] = frozenset(),
        short: Mapping[tuple[Way, ...], float] | None = None,
    ) -> list[tuple[Way, ...]]:
        """The alternatives, each as long as the entry says that is the first to fit it."""
        found = []
        for x in wanted:
            ends = frozenset(a for a in short or () if self._counts(wanted, a) is x)
            reached = self._reach(g, x.metres, steps, ends)
            found += [ways for ways in reached if _agrees(ways) and self._counts(wanted, ways) is x]
        return found

    def _metres(self, told: dict[str, str] | None) -> float:
        """As stated; or as German examples have it: 50, 100 or 200 m to 40, 60 km/h or above, 10 % more for each
        permille falling, 5 % less for each rising."""
        if told is None:
            return self._d.rule("overlap_m")
        if told.get("successive") in ("yes", "true"):
            return float("inf")
        if "length" in told:
            return float(told["length"])
        kmh, falling = float(told.get("speed") or told["entry_speed"]), float(told.get("falling", 0))
        need(falling > -20, f"nothing is left of an overlap where the track rises by {-falling:g} permille")
        base = 50.0 if kmh <= 40 else 100.0 if kmh <= 60 else 200.0
        return base * max(0.0, 1.0 + (0.10 if falling > 0 else 0.05) * falling)

    def _reach(
        self, g: Signal, metres: float, steps: frozenset[tuple[str, str, str]], ends: frozenset[tuple[Way, ...]]
    ) -> Iterator[tuple[Way, ...]]:
        barred = self._barred(g)

        def go(ways: tuple[Way, ...], gone: float) -> Iterator[tuple[Way, ...]]:
            last = ways[-1]
            if barred & {last.section, *last.edges}:
                return
            ahead = self.r.track.beyond(last.section, last.exit)
            enough = gone >= metres or (metres == float("inf") and (last.exit, ahead) in self.r.main_into)
            if ahead is None or (enough and ((last.section, last.exit, ahead) not in steps or ways in ends)):
                yield ways
            elif all(w.section != ahead for w in ways):
                for w in self.r.track.from_end(ahead, last.exit):
                    yield from go((*ways, w), gone + w.length)

        for w in self.r.track.from_end(g.into, g.node):
            yield from go((w,), w.length)

    def _barred(self, g: Signal) -> frozenset[str]:
        """Sections, and ends of points and the like, over which no alternative of the overlap shall lead."""
        told = ((self.r.body.get("overlaps") or {}).get(g.name) or {}).get("not_over") or ()
        for x in told:
            if x not in self._d.edges and x not in self.r.track.sections:
                raise Unread(f"the overlap of {g.name}: {x} is no section and no end")
        return frozenset(told)


def _entry(told: dict[str, str]) -> float | None:
    return float(told["entry_speed"]) if "entry_speed" in told else None


def _agrees(ways: tuple[Way, ...]) -> bool:
    """No machine is wanted both ways."""
    wanted: dict[str, str] = {}
    return all(wanted.setdefault(d.machine, d.position) == d.position for w in ways for _, d in w.points)


def _reversed(ways: tuple[Way, ...]) -> int:
    return sum(d.position == "R" for w in ways for _, d in w.points)
