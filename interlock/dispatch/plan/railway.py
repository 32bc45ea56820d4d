"""The trains of a railway as a problem: where each may be between two routes, and which routes take it on.

Made from the table alone (and the lengths of sections and trains).  A train that has come to the end of a route stands
before the next signal; under it lie the last sections of its way, as many as it is long.  It holds them with their
locks: their machines, and what they exclude (diamonds, foul joints).  A route needs what the table says: its sections
and flank space clear, its overlap, the line beyond clear, machines that are not held otherwise, room in zones, no route
under way that the author declares hostile.  What the interlocking asks for besides (external conditions, detection,
lamps, a direction token) is assumed to come.

Nothing here depends on names: where several routes are possible they are ordered by their shape.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import field, replace
from functools import cached_property
from heapq import heappop, heappush
from itertools import count, takewhile
from math import inf

from interlock.dataclass import dataclass
from interlock.dispatch.plan.errands import OUTSIDE, Errand, Leg, NoVoyage, Place, Step, TooManyPlaces
from interlock.dispatch.plan.held import Held
from interlock.dispatch.plan.problem import Draft, Followed
from interlock.model.elements import NodeId, Position, RouteId, SectionId
from interlock.model.layout import Layout
from interlock.model.stopping import MARGIN_M, stands_on
from interlock.model.traversal import topology
from interlock.table.cells import ExitKind, Role, RouteKind, TraversalKey
from interlock.table.rows import InterlockingTable, RouteRow, last_left

MOST_NODES = 20_000
"""Places of one train that are looked at (our choice)."""

DIVERGES_S = 10.0
"""Seconds that points on the curved leg cost: they have to be run, and trains are slow there (our choice)."""

TURNS_S = 60.0
"""Seconds that a change of direction costs (our choice)."""

KEEPS_S = 60.0
"""Seconds that it costs to run over a track on which a long train could stand, where others are too short for it:
somebody may have to wait there of whom nobody knows yet (our choice)."""


class Railway:
    """A table with what planning asks of it."""

    def __init__(self, table: InterlockingTable, layout: Layout) -> None:
        self.table, self.layout, self.topo = table, layout, topology(layout)
        self.metres = {t.key: t.length for s in self.topo.sections for t in self.topo.traversals[s]}
        self._ends = {t.key: (t.entry, t.exit) for s in self.topo.sections for t in self.topo.traversals[s]}
        self.approach = {str(b.node): b.approach for b in layout.track.boundaries}
        self.held = Held(table, layout)
        self._from: dict[tuple[NodeId, SectionId], list[RouteRow]] = {}
        for r in sorted(table.routes, key=lambda r: (self._rank[r.id], r.number)):
            one_by_one = r.path.onward is None  # past one signal after another
            if one_by_one and r.kind not in (RouteKind.CALL_ON, RouteKind.IDENTIFIER):
                self._from.setdefault((r.path.entry_node, r.path.section_ids[0]), []).append(r)

    def _seconds(self, r: RouteRow) -> float:
        """What a route costs a train: the time at its speed, and something for each of its points that lies reverse."""
        kmh = r.signal.speed.kmh or self.layout.principles.line_speed_kmh
        curved = sum(d.role is Role.PATH and d.position is Position.REVERSE for d in r.locking.points)
        return round(r.path.length / (kmh / 3.6), 1) + DIVERGES_S * curved

    @cached_property
    def _rank(self) -> dict[RouteId, int]:
        """Routes by shape: what they look like, then what follows, precedes and excludes them, round after round."""
        rows = self.table.routes
        ends: dict[str, list[RouteRow]] = {}
        starts: dict[str, list[RouteRow]] = {}
        for r in rows:
            ends.setdefault(r.exit, []).append(r)
            starts.setdefault(r.entry, []).append(r)
        near = len(rows) <= 500
        look: dict[RouteId, object] = {
            r.id: (r.kind, round(p.length, 1), len(p.traversals), p.exit_kind, len(x.points), len(x.hostile))
            for r, p, x in ((r, r.path, r.locking) for r in rows)
        }
        found: dict[RouteId, int] = {}
        for _ in range(8):
            order = {x: i for i, x in enumerate(sorted(set(look.values()), key=repr))}
            now = {r: order[x] for r, x in look.items()}
            if len(set(now.values())) == len(set(found.values())):
                break
            found = now
            look = {
                r.id: (
                    found[r.id],
                    tuple(sorted(found[x.id] for x in starts.get(r.exit, ()))),
                    tuple(sorted(found[x.id] for x in ends.get(r.entry, ()))),
                    tuple(sorted(found[x] for x in r.locking.hostile.routes)) if near else (),
                )
                for r in rows
            }
        return found

    def standing(self, r: RouteRow) -> tuple[TraversalKey, ...]:
        """A way on which a train stands before a route's signal."""
        rear = self.topo.beyond(r.path.section_ids[0], r.path.entry_node)
        ways = [] if rear is None else [t.key for t in self.topo.traversals[rear] if t.exit == r.path.entry_node]
        return (min(ways, key=lambda k: (k not in self.table.lock, k)),)

    # --- errands -------------------------------------------------------------------------------

    def _lies(self, ways: Sequence[TraversalKey], length: float) -> tuple[TraversalKey, ...]:
        """The last of some ways that a train of a length covers with its head short of the end."""
        covered = 0.0
        for k in range(len(ways) - 1, -1, -1):
            covered += self.metres.get(ways[k], float("inf"))
            if stands_on(covered, length):
                return tuple(ways[k:])
        return tuple(ways)

    def routes_on(self, place: Place, turns: bool) -> list[tuple[RouteRow, bool]]:
        """The routes before which a train stands, and whether it changes direction for it."""
        if not place.under:
            return []
        section, number = place.under[-1]
        if number == OUTSIDE:
            node = NodeId(section)
            first = self.layout.track.section_of(self.layout.track.edges_at[node][0].id)
            return [(r, False) for r in self._from.get((node, first), ())]
        entry, exit_ = self._ends[section, number]
        found = [(r, False) for r in self._ahead(section, exit_)]
        if turns and len(place.under) == 1:
            found += [(r, True) for r in self._ahead(section, entry)]
        return found

    def _ahead(self, section: SectionId, joint: NodeId) -> list[RouteRow]:
        ahead = self.topo.beyond(section, joint)
        return [] if ahead is None else self._from.get((joint, ahead), [])

    def still(
        self,
        name: str,
        place: Place,
        coming: bool,
        back: Iterable[TraversalKey] = (),
        given_up: Place | None = None,
    ) -> Draft:
        """A train that goes nowhere.  coming: it is outside yet; back: where it stands besides, until its route is
        taken back; given_up: as in `Journey.nodes`."""
        found = Draft(name, place)
        queue = {("queue", name)} if coming else set[object]()
        found.holds[place] = self.held.holds(place.under) | self.held.kept(place) | self.held.holds(back) | queue
        found.home.add(place)
        found.inside[place] = self.held.inside(place.under)
        if place != given_up:
            found.followed.update(self.followed(place))
        return found

    def followed(self, place: Place) -> dict[object, Followed]:
        """What a train keeps in a place while another is behind it, by the place."""
        more = self.held.followed(place)
        return {place: more} if more is not None else {}

    def draft(self, errand: Errand) -> Journey:
        """Where an errand can lead.  Raises `NoVoyage`, `TooManyPlaces`."""
        start = Place(0, frozenset(), None, errand.start)
        steps: dict[Place, list[Step]] = {}
        todo, homes = [start], set()
        while todo:
            place = todo.pop()
            if place in steps:
                continue
            if len(steps) > MOST_NODES:
                raise TooManyPlaces(f"{errand.train} can come to more than {MOST_NODES} places")
            if place.leg == len(errand.legs):
                homes.add(place)
                steps[place] = []
                continue
            steps[place] = self._steps(errand, place)
            todo.extend(s.after for s in steps[place])
        kept = _leading(steps, homes)
        if start not in kept:
            raise self._none(errand, steps)
        found = straight(self._cheap_first(_within(steps, kept), errand.length_m), start)
        return Journey(errand, start, found, self)

    def _none(self, errand: Errand, steps: Mapping[Place, Sequence[Step]]) -> NoVoyage:
        """Why no chain of routes makes an errand: the first leg that none makes, and where routes lead on it."""
        far = min(max(p.leg for p in steps), len(errand.legs) - 1)
        start, to = errand.legs[far - 1].to if far else str(errand.start[-1][0]), errand.legs[far].to
        over = f"over {', '.join(sorted(errand.legs[far].via))} " if errand.legs[far].via else ""
        if far < len(errand.legs) - 1 and NodeId(to) in self.layout.track.boundary_at:
            why = f"{errand.train} leaves at {to}, and does not come back in the same command"
            return NoVoyage(why, f"end the command at {to}, and give another one from there")
        if errand.length_m > 1 and self._goes(replace(errand, length_m=1.0)):
            long = f"{errand.train}, {errand.length_m:g} m long,"
            why, fix = self._too_short(errand)
            return NoVoyage(f"no chain of routes takes {long} from {start} to {to}{why}", fix)
        on = [r for p in steps if p.leg == far for r, _ in self.routes_on(p, self._turns(errand, p))]
        exits = sorted({str(r.exit) for r in on if (r.kind is RouteKind.SHUNT) == errand.legs[far].shunt})
        leads = f"routes lead from {start} to {', '.join(exits[:8])}{', ...' if exits[8:] else ''}; name another place"
        no = f"no route leads on from {start}: put a signal there, or name another place"
        why = f"no chain of routes takes {errand.train} from {start} {over}to {to}"
        kept = [p for p, out in steps.items() if p.leg == far and not out and self._keeps_its_overlap(p)]
        if kept and kept[0].route is not None:
            section, g = kept[0].under[0][0], self.table.route[kept[0].route].exit
            fix = f"give trains an `approach` section, or detection, before {section}, or shorten the overlap of {g}"
            return NoVoyage(
                f"{why}: it keeps the overlap of {g}, as nothing reports that all of it is in {section}", fix
            )
        return NoVoyage(why, leads if exits else no)

    def _keeps_its_overlap(self, place: Place) -> bool:
        """A train stands before a signal over which routes lead on, none of which goes with the overlap that it keeps
        for ever."""
        overlap = place.route is not None and self.table.route[place.route].locking.overlap
        alone = bool(overlap) and len(place.under) == 1 and self.held.unseen(place)
        return alone and bool(self.routes_on(place, False))

    def _too_short(self, errand: Errand) -> tuple[str, str]:
        """In which sections the longest train that could go stands, and a longer one does not; and what to do.  Lengths
        are tried with which a train just stands in some section."""
        tried = sorted({m - MARGIN_M for m in self.metres.values() if 1 < m - MARGIN_M < errand.length_m})
        goes, fails = 0, len(tried) + 1  # of (1 m, *tried, errand.length_m)
        while fails - goes > 1:
            k = (goes + fails) // 2
            goes, fails = (k, fails) if self._goes(replace(errand, length_m=tried[k - 1])) else (goes, k)
        longest = tried[goes - 1] if goes else 1.0
        under = [p.under for p in self.draft(replace(errand, length_m=longest)).steps]
        short = {str(w[0][0]): m for w in under if len(w) == 1 and (m := self.metres.get(w[0])) is not None}
        at = [f"{s}, which has {m:g} m there" for s, m in short.items() if m - MARGIN_M == longest]
        why = f": it does not stand in {' and '.join(at)}; {errand.length_m + MARGIN_M:g} m are needed" if at else ""
        return why, f"take a shorter train: one of {longest:g} m could go"

    def _goes(self, errand: Errand) -> bool:
        try:
            self.draft(errand)
        except (NoVoyage, TooManyPlaces):
            return False
        return True

    def _cheap_first(self, steps: dict[Place, list[Step]], length_m: float) -> dict[Place, list[Step]]:
        """The same steps, those first with which a train that is alone comes to its end soonest."""
        before: dict[Place, list[tuple[Place, float]]] = {}
        for p, out in steps.items():
            for s in out:
                before.setdefault(s.after, []).append((p, self.cost(s, length_m)))
        left = {p: 0.0 for p, out in steps.items() if not out}
        turn = count()
        todo = [(0.0, next(turn), p) for p in left]
        while todo:
            cost, _, place = heappop(todo)
            for p, more in before.get(place, ()) if cost <= left[place] else ():
                if cost + more < left.get(p, inf):
                    left[p] = cost + more
                    heappush(todo, (cost + more, next(turn), p))
        return {p: sorted(out, key=lambda s: self.cost(s, length_m) + left[s.after]) for p, out in steps.items()}

    def cost(self, step: Step, length_m: float) -> float:
        """Seconds that a step costs a train of a length."""
        keeps = sum(self._keeps(r, length_m) for r in step.routes)
        return sum(map(self._seconds, step.routes)) + TURNS_S * step.turned + KEEPS_S * keeps

    def _keeps(self, r: RouteRow, length_m: float) -> bool:
        """A route runs over a track on which such a train could stand, and does not end there, while elsewhere tracks
        are too short for it."""
        long = [sections for sections, metres in self._standing.values() if stands_on(metres, length_m)]
        own, _ = self._standing.get(r.id, (frozenset(), 0.0))
        return len(long) < len(self._standing) and any(x != own and not x.isdisjoint(r.path.section_ids) for x in long)

    @cached_property
    def _standing(self) -> dict[RouteId, tuple[frozenset[SectionId], float]]:
        """Where trains stand clear of points before the signals at which routes end: the sections, and the metres."""
        found: dict[RouteId, tuple[frozenset[SectionId], float]] = {}
        for r in self.table.routes:
            clear = list(takewhile(lambda k: not self.layout.machines.points_in.get(k[0]), reversed(r.path.traversals)))
            if r.path.exit_kind is ExitKind.SIGNAL and clear:
                found[r.id] = frozenset(s for s, _ in clear), sum(self.metres[k] for k in clear)
        return found

    def _steps(self, errand: Errand, place: Place) -> list[Step]:
        leg, turns = errand.legs[place.leg], self._turns(errand, place)
        if leg.far_first:
            return self._whole(errand, place, turns)
        found = []
        for r, turned in self.routes_on(place, turns):
            besides = self._besides(place, r, turned)
            if (r.kind is RouteKind.SHUNT) == leg.shunt and besides is not None and not self._own(place, (r,)):
                after = self._after(errand, place, (r,), turned)
                if after is not None:
                    found.append(Step((r,), after, turned, besides))
        return found

    def _besides(self, place: Place, r: RouteRow, turned: bool) -> frozenset[object] | None:
        """What else must be free for a route from where a train stands; None where it cannot be set."""
        return frozenset() if place.route is None or turned else self.held.released(place, r)

    def _turns(self, errand: Errand, place: Place) -> bool:
        """The train begins, or has just ended a leg: it may change direction."""
        if place.route is None:
            return True
        ended = errand.legs[place.leg - 1] if place.leg and not place.passed else None
        return ended is not None and self._reached(self.table.route[place.route], ended)

    def _reached(self, r: RouteRow, leg: Leg) -> bool:
        return leg.to in (r.exit, r.path.section_ids[-1])

    def _whole(self, errand: Errand, place: Place, turns: bool) -> list[Step]:
        """All routes of a leg in one step."""
        leg = errand.legs[place.leg]
        found: list[Step] = []
        todo: list[tuple[tuple[RouteRow, ...], bool]] = [((r,), t) for r, t in self.routes_on(place, turns)]
        while todo:
            chain, turned = todo.pop(0)
            besides = self._besides(place, chain[0], turned)
            if (chain[-1].kind is RouteKind.SHUNT) != leg.shunt or besides is None or self._own(place, chain):
                continue
            after = self._after(errand, place, chain, turned)
            if after is not None and after.leg > place.leg:
                found.append(Step(chain, after, turned, besides))
            elif chain[-1].path.exit_kind is ExitKind.SIGNAL and len(chain) < 12:
                been = {s for r in chain for s in r.path.section_ids}
                end = Place(0, frozenset(), chain[-1].id, chain[-1].path.traversals)
                onward = [r for r, _ in self.routes_on(end, False) if been.isdisjoint(r.path.section_ids)]
                todo += [((*chain, r), turned) for r in onward if all(self.held.goes_with(x, r) for x in chain)]
        return found

    def _own(self, place: Place, chain: Sequence[RouteRow]) -> bool:
        """The train itself is in the way."""
        mine = self.held.holds(place.under) | self.held.under_way(place)
        if not all(self.held.goes_with(self.table.route[x], r) for x in place.inside for r in chain):
            return True
        full, inside = dict(self.held.zones), self.held.inside(place.under)
        return any(mine & self.held.needs(r) for r in chain) or any(
            inside.get(z, 0) + n > full[z] for z, n in self.held.entering(chain).items()
        )

    def _after(self, errand: Errand, place: Place, chain: Sequence[RouteRow], turned: bool) -> Place | None:
        leg, last = errand.legs[place.leg], chain[-1]
        passed = place.passed | (leg.via & {s for r in chain for s in r.path.section_ids})
        done = self._reached(last, leg) and passed == leg.via
        if last.path.exit_kind is ExitKind.BOUNDARY:
            at = place.leg + done
            return Place(at, frozenset(), last.id, ()) if at == len(errand.legs) else None
        rear = () if turned else place.under
        under = self._lies((*rear, *(k for r in chain for k in r.path.traversals)), errand.length_m)
        done = done and not (leg.wholly and len(under) > 1)
        at = place.leg + done
        firm = last.id if last.locking.overlap is not None and len(under) > 1 else None
        added = place.under_way | {r.id for r in chain if r.locking.barred or r.locking.added}
        under_way = frozenset(x for x in added if x == firm or last_left(self.table.route[x]) in under)
        inside = self.held.still_inside(place, chain, turned, under)
        return Place(at, frozenset() if done else passed, last.id, under, under_way, inside)


@dataclass
class Journey:
    """An errand with all its places and the steps between them."""

    errand: Errand
    start: Place
    steps: dict[Place, list[Step]]
    railway: Railway = field(repr=False)

    @cached_property
    def sections(self) -> frozenset[SectionId]:
        """All sections over which some of its ways leads."""
        return frozenset(x for out in self.steps.values() for s in out for r in s.routes for x in r.path.section_ids)

    def past(self, shut: frozenset[RouteId]) -> dict[Place, list[Step]]:
        """The steps without those that need a route that is shut, or lead on by such ones alone; all, where none does
        without."""
        free = {p: [s for s in out if shut.isdisjoint(r.id for r in s.routes)] for p, out in self.steps.items()}
        kept = _leading(free, [p for p, out in self.steps.items() if not out]) if shut else set()
        found = {p: [s for s in out if s.after in kept] for p, out in free.items()}
        return {p: found[p] or out for p, out in self.steps.items()}

    def nodes(self, before: Sequence[str] = (), given_up: Place | None = None) -> Draft:
        """The same as nodes and moves; a move's label is the number of its step.

        before: the trains that come in over the same boundary before this one.  given_up: where it is known to have
        given up the overlap before which it stands, whoever comes behind it now.
        """
        d = Draft(self.errand.train, self.start)
        for place, steps in self.steps.items():
            outside = place.under[:1] == self.errand.start and place.route is None and place.under[0][1] == OUTSIDE
            own = {("queue", self.errand.train)} if outside else set()
            behind = {("queue", t) for t in before} if outside else set()
            d.holds[place] = self.railway.held.holds(place.under) | self.railway.held.kept(place) | own
            d.inside[place] = self.railway.held.inside(place.under)
            if place != given_up:
                d.followed.update(self.railway.followed(place))
            if not steps:
                (d.home if place.under else d.gone).add(place)
            for k, s in enumerate(steps):
                besides = s.besides if place != given_up else ()
                needs = behind.union(besides, *(self.railway.held.needs(r) for r in s.routes))
                d.moves.setdefault(place, []).append(
                    (str(k), s.after, frozenset(needs), self.railway.held.entering(s.routes))
                )
                d.costs[place, str(k)] = self.railway.cost(s, self.errand.length_m)
        return d


def _leading(steps: Mapping[Place, Sequence[Step]], homes: Iterable[Place]) -> set[Place]:
    """The places from which an errand can be completed."""
    before: dict[Place, list[Place]] = {}
    for p, out in steps.items():
        for s in out:
            before.setdefault(s.after, []).append(p)
    found, todo = set(homes), list(homes)
    while todo:
        for p in before.get(todo.pop(), ()):
            if p not in found:
                found.add(p)
                todo.append(p)
    return found


def _within(steps: Mapping[Place, Sequence[Step]], kept: set[Place]) -> dict[Place, list[Step]]:
    """The steps from some places to one another."""
    return {p: [s for s in out if s.after in kept] for p, out in steps.items() if p in kept}


def straight(steps: Mapping[Place, Sequence[Step]], start: Place) -> dict[Place, list[Step]]:
    """Without the steps that lead back to where the train was, and the places from which no others lead to an end: it
    never goes round."""
    done: dict[Place, bool] = {start: False}
    stack = [(start, 0)]
    out: dict[Place, list[Step]] = {start: []}
    while stack:
        place, k = stack[-1]
        if k == len(steps[place]):
            done[place] = True
            stack.pop()
            continue
        stack[-1] = (place, k + 1)
        step = steps[place][k]
        if step.after not in done:
            done[step.after] = False
            out[step.after] = []
            stack.append((step.after, 0))
        elif not done[step.after]:
            continue
        out[place].append(step)
    return _within(out, _leading(out, [p for p in out if not steps[p]]))
