"""Functional tests of the routes (control table tests): each row of the interlocking table, cell by cell.

What has to come is read from the row alone; where something else comes on the bench, the step says what.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from interlock.commissioning.approach import Place, further, settings
from interlock.commissioning.bench import (
    FEW,
    SCAN_MS,
    Bench,
    Moment,
    locked,
    locked_up,
    not_at_stop,
    not_locked_up,
    occupied,
    undetected,
)
from interlock.commissioning.needs import Need, needs, to_open
from interlock.commissioning.row import Row
from interlock.commissioning.step import SLACK_S, Sheet, Step, started
from interlock.diag.called import called
from interlock.logic.names import Name
from interlock.model.elements import MachineId, SectionId, SignalId
from interlock.model.figures import exact
from interlock.table.cells import RouteKind
from interlock.table.rows import InterlockingTable, RouteRow


class RouteTests:
    """The tests of one route, on a bench where nothing is set."""

    def __init__(self, bench: Bench, table: InterlockingTable, row: RouteRow, rest: Moment) -> None:
        """`rest`: a moment of the bench in which all is clear and released, and nothing is set."""
        self._bench, self._table, self._rest = bench, table, rest
        self._row = Row(bench, table, row)
        self._seconds = 0.0

    def steps(self) -> Iterator[Step]:
        """All of them, in the order in which they are done; only the first where the signal does not open."""
        row = self._row
        yield self._set()
        if not self._open():
            return
        opened = self._bench.moment()
        yield from (self._falls(opened, x) for x in needs(row))
        yield from (self._stays(x) for x in (*needs(row), *to_open(row)))
        yield from (self._held(opened, m) for m in row.demands)
        if not row.calls_on:
            yield from (self._kept_back(opened, m) for m in row.demands if m in self._bench.symbols.machines.looked_at)
        yield from (self._refused(opened, self._table.route[h]) for h in row.row.locking.hostile.routes)
        yield from self._on_the_spot()
        yield from self._cancelled(opened)
        yield from self._kept_out(opened)
        if not row.calls_on:
            yield from self._driven(opened)

    def power_cut(self) -> Iterator[Step]:
        """The controller loses its power while the signal is open, and forgets all of it; none where it does not
        open."""
        bench, row, y = self._bench, self._row, self._bench.symbols
        if row.calls_on or not self._open():
            return
        bench.restart()
        bench.scans(FEW)
        do = f"{self._at_proceed()} for {row.name}: cut the power of the controller, and switch it on again"
        yield started(do, locked_up(bench), not_locked_up(bench))
        delay = bench.layout.principles.restart_delay_s
        bench.scans(FEW, {str(y.sections.release_all): 1})
        bench.scan({str(y.requests.request): row.row.number})
        bench.scans(FEW)
        came = [f"{s} is released" for s in y.sections.restart if not locked(bench, s)]
        came += [f"{row.name} is set"] if bench.on(row.symbols.active) else []
        do = f"then at once, before the restart delay of {exact(delay)} s is over: release all clear sections"
        expect = f"every section stays locked, {row.name} is refused"
        if delay * 1000 > (3 * FEW + 1) * SCAN_MS:
            yield started(f"{do}, and ask for {row.name}", expect, came)

    # --- setting it ---

    def _longest_s(self) -> float:
        """Seconds within which the signal opens, if it opens at all."""
        row, rules = self._row, self._bench.layout.principles
        seconds = 2 * FEW * SCAN_MS / 1000 + (rules.token_delay_s if row.tokens else 0)
        return seconds + len(row.demands) * (rules.point_start_gap_s + 2 * SCAN_MS / 1000)

    def _open(self, lost: Need | None = None, at: str = "") -> bool:
        """The route is asked for at rest, with machines the other way; whether its signal opens: where something is
        lost, in the time in which it opened without.  `at`: where it is asked for, if not at the centre."""
        bench, row = self._bench, self._row
        bench.back(self._rest)
        before, devices = dict(bench.lies), bench.layout.machines.device
        for m, p in row.demands.items():
            if row.turnable(m):
                bench.lies[m] = p.position.other
            elif row.calls_on and m not in devices:
                bench.lies[m] = p.position
        _looked_at(bench, (m for m, x in before.items() if bench.lies[m] is not x))
        for m, p in row.demands.items():
            if not row.turnable(m) and row.calls_on and m in devices:
                by_hand = bench.symbols.machines.by_hand.get((m, p.position))
                if bench.lies[m] is not p.position and by_hand is not None:
                    bench.scans(FEW, {str(by_hand): 1})  # a door opens before a train stands at it
                bench.lies[m] = p.position
        if row.calls_on:
            bench.inputs |= occupied(bench.symbols, *row.rear)
        if lost is not None:
            bench.inputs |= lost.inputs
        bench.scans(2)
        bench.scan({at or str(bench.symbols.requests.request): row.row.number})
        asks = [str(bench.symbols.token[b].manual) for b in row.tokens]
        inputs = {name: 1 for name in asks if lost is None or name not in lost.inputs}
        longest = self._longest_s() if lost is None else self._seconds + FEW * SCAN_MS / 1000
        begun = bench.seconds
        opens = bench.until(self._proceed, longest, inputs)
        if lost is None:
            self._seconds = bench.seconds - begun
        return opens

    def _proceed(self) -> bool:
        """Whether the signal shows more than stop."""
        return bool(self._bench.proceeds([self._row.row.entry]))

    def _set(self) -> Step:
        row, machines = self._row, self._bench.layout.machines
        lamps, words = row.aspect()
        moves = "".join(f"{machines.named(m)} {machines.word(m, p.position)}; " for m, p in row.demands.items())
        do = "all clear, nothing set"
        if row.demands:
            do += ", machines as it needs them" if row.calls_on else ", machines the other way where they can be moved"
        if row.calls_on and row.rear:
            do += f", a train before it ({called('section', row.rear[0])} occupied)"
        if row.tokens:
            do += f", the direction at {', '.join(row.tokens)} asked for by the manual change"
        expect = f"{moves}{row.signal} shows {words} ({', '.join(lamps)}), every other signal stop"
        expect += f"; indicated as locked: {', '.join(dict.fromkeys(s for p in row.parts for s, _ in p.path.locked))}"
        expect += self._announced()
        came = self._not_as_set() if self._open() else [f"it does not open: {self._bench.why_not(row.symbols)}"]
        return self._step(f"{do}: ask for {row.name}, by its number {row.row.number}", expect, "R3", came)

    def _distants(self) -> dict[SignalId, bool]:
        """The distants, and whether each shows clear while the signal is open."""
        a, clear = self._bench.symbols.aspects, self._bench.symbols.aspects.clear.get(self._row.row.entry)
        shown = clear is not None and clear in self._row.aspect()[0]
        distants = self._bench.layout.signalling.distants
        return {d.id: shown and d.of == self._row.row.entry for d in distants if d.id in a.distant_clear}

    def _announced(self) -> str:
        """What the distants show then, in words; nothing where there are none."""
        shown = self._distants()
        own = [f"{called('distant', d)} shows clear" for d, clear in shown.items() if clear]
        others = "every other distant caution" if own else "every distant caution"
        return "; ".join(["", *own, *([others] if len(own) < len(shown) else [])])

    def _not_as_set(self) -> list[str]:
        """What is otherwise than the row says, some scans after the signal has opened."""
        bench, row, machines = self._bench, self._row, self._bench.layout.machines
        bench.scans(FEW)
        lit = {n for n in self._lamps() if bench.on(n)}
        came = [] if lit == {*row.aspect()[0]} else [f"lit: {', '.join(sorted(lit)) or 'nothing'}"]
        wrong = [m for m, p in row.demands.items() if bench.lies[m] is not p.position]
        came += [f"{machines.named(m)} {machines.word(m, bench.lies[m])}" for m in wrong]
        if others := [x for x in not_at_stop(bench) if x not in {p.entry for p in row.parts}]:
            came.append(f"not at stop: {', '.join(others)}")
        if free := [s for part in row.parts for s, _ in part.path.locked if not locked(bench, s)]:
            came.append(f"not locked: {', '.join(free)}")
        a = bench.symbols.aspects
        told = [d for d, clear in self._distants().items() if clear is not bench.on(a.distant_clear[d])]
        told += [d for d, clear in self._distants().items() if clear is bench.on(a.distant_caution[d])]
        return [*came, *(f"{called('distant', d)} shows otherwise" for d in dict.fromkeys(told))]

    def _lamps(self) -> tuple[Name, ...]:
        """All lamps of the signal."""
        a, g = self._bench.symbols.aspects, self._row.row.entry
        speeds = (n for (s, _), n in a.speed.items() if s == g)
        second = tuple(of[g] for of in (a.second, a.indicator) if g in of)
        return (*a.proceed_lamps(g), *a.proceed_lamps(g, True), *second, *speeds, a.stop[g])

    # --- what it needs, what it locks, what it excludes ---

    def _falls(self, opened: Moment, need: Need) -> Step:
        bench, row = self._bench, self._row
        bench.back(opened)
        bench.scan(need.inputs)
        came = ["it stays at proceed"] if self._proceed() else []
        came += [] if came or row.row.entry not in not_at_stop(bench) else ["it is dark"]
        bench.scans(FEW)
        came += ["it opens again by itself"] if self._proceed() else []
        expect = "it shows stop in the same scan, and stays at stop afterwards"
        return self._step(f"{self._at_proceed()}: {need.lost}, and then as before", expect, need.rule, came)

    def _stays(self, need: Need) -> Step:
        came = ["it opens"] if self._open(need) else []
        return self._step(
            f"{need.lost}: ask for {self._row.name}", f"{self._row.signal} stays at stop", need.rule, came
        )

    def _held(self, opened: Moment, m: MachineId) -> Step:
        bench, machines, x = self._bench, self._bench.layout.machines, self._row.demands[m].position
        by_hand = bench.symbols.machines.by_hand.get((m, x.other))
        if by_hand is None:
            return self._step(f"{self._at_proceed()}: try to turn {machines.named(m)}", "it is locked", "R10", None)
        bench.back(opened)
        bench.scans(FEW, {str(by_hand): 1})
        came = [] if bench.lies[m] is x else [f"{machines.named(m)} {machines.word(m, bench.lies[m])}"]
        do = f"{self._at_proceed()}: try to {machines.to_move(m, x.other)}"
        return self._step(do, "nothing moves, and it stays at proceed", "R10", [*came, *self._closed()])

    def _kept_back(self, opened: Moment, m: MachineId) -> Step:
        """Points that were trailed are not used before somebody has looked at them."""
        bench, row, machines = self._bench, self._row, self._bench.symbols.machines
        bench.back(opened)
        bench.scans(2, undetected(bench.symbols, m))
        bench.scans(2)
        asked = {str(bench.symbols.requests.request): row.row.number}
        bench.scans(FEW, asked)
        came = ["it opens"] if self._proceed() else []
        bench.scan({str(machines.looked_at[m]): 1})
        bench.scan()
        bench.scans(FEW, asked)
        came += (
            [] if came or self._proceed() else [f"it does not open when asked afterwards: {bench.why_not(row.symbols)}"]
        )
        named = bench.layout.machines.named(m)
        do = f"{self._at_proceed()}: {named} loses its detection, and then as before: ask for {row.name} again"
        expect = (
            f"stop, before and after; once it is confirmed that {named} was looked at, {row.signal} opens when asked"
        )
        return self._step(do, expect, "R10", came)

    def _refused(self, opened: Moment, other: RouteRow) -> Step:
        bench = self._bench
        bench.back(opened)
        bench.scan({str(bench.symbols.requests.request): other.number})
        bench.scans(FEW)
        came = ["it is set"] if bench.on(bench.symbols.routes.number[other.number].active) else []
        do = f"{self._at_proceed()} for {self._row.name}: ask for hostile {called('route', other.id)}"
        return self._step(do, "it is refused, and the signal stays at proceed", "R6", [*came, *self._closed()])

    def _closed(self) -> list[str]:
        return [] if self._proceed() else [f"{self._row.signal} shows stop"]

    def _at_proceed(self) -> str:
        return f"{self._row.signal} at proceed"

    def _on_the_spot(self) -> Iterator[Step]:
        """Asked for at the place on the spot, where there is one; and who is heard where both ask in one scan."""
        bench, row, y = self._bench, self._row, self._bench.symbols.requests
        if y.local_request is None:
            return
        here, centre = str(y.local_request), str(y.request)
        came = [] if self._open(at=here) else [f"it does not open: {bench.why_not(row.symbols)}"]
        do = f"all clear, nothing set: ask for {row.name} on the spot ({here}), by its number {row.row.number}"
        yield self._step(do, f"{row.signal} opens", "R14", came)
        others = (r for r in self._table.routes if r.id != row.row.id and r.kind is not RouteKind.IDENTIFIER)
        other = next(others, None)
        if other is None:
            return
        first = row.row if y.local_first else other
        bench.back(self._rest)
        bench.scans(2)
        bench.scan({here: row.row.number, centre: other.number})
        active = {r.id: bench.on(bench.symbols.routes.number[r.number].active) for r in (row.row, other)}
        second = other if first is row.row else row.row
        came = [f"{called('route', second.id)} is set"] if active[second.id] else []
        asked = f"ask for {row.name} on the spot and for {called('route', other.id)} at the control centre in one scan"
        heard = "what is asked on the spot" if y.local_first else "what is asked at the control centre"
        expect = f"{called('route', second.id)} is not set: {heard} is heard alone"
        yield self._step(f"all clear, nothing set: {asked}", expect, "R14", came)

    # --- giving it up, and driving over it ---

    def _cancelled(self, opened: Moment) -> Iterator[Step]:
        bench, row = self._bench, self._row
        coming, blind = row.row.locking.approach.coming, bench.layout.track.undetected
        if not row.always_locked and not row.calls_on:
            bench.back(opened)
            bench.scan(self._cancel)
            came = ["it stays at proceed"] if self._proceed() else []
            bench.wait(SLACK_S + self._hold)
            came += ["it stays locked"] if bench.on(row.symbols.active) else []
            do = f"{self._at_proceed()}, no train before it: cancel {row.name}"
            yield self._step(do, "stop at once, and the route is given up at once", "R8", came)
        elif row.rear and not row.calls_on and (coming.unseen or row.rear[0] in blind):
            bench.back(opened)
            yield self._given_up_late(", no train before it")
        bench.back(opened)
        bench.inputs |= occupied(bench.symbols, *row.rear)
        bench.scans(FEW)
        yield self._given_up_late(f", a train in {row.rear[0]}" if row.rear else "")
        if not row.calls_on:
            for place in further(coming, frozenset(blind)):
                yield from self._from(opened, place)

    def _from(self, opened: Moment, place: Place) -> Iterator[Step]:
        """The same with a train farther off, for which the way is locked up to the signal; none where no routes lock
        it while this one is set."""
        bench, y = self._bench, self._bench.symbols
        for routes in settings(self._table, self._row.row, place.ways):
            bench.back(opened)
            for r in routes:
                self._ask(r)
            if not all(bench.on(y.sections.lock.get(way)) for way in place.ways) or not self._proceed():
                continue
            if place.section is not None:
                bench.inputs |= occupied(y, place.section)
            bench.scans(FEW)
            before = " and ".join(called("route", r.id) for r in routes)
            train = "no train to be seen" if place.section is None else f"a train in {place.section} alone"
            both = bench.moment()
            yield self._given_up_late(f", {before} set before it, {train}")
            trains = all(r.kind is RouteKind.MAIN for r in (self._row.row, *routes))  # others may leave vehicles behind
            if trains and place.section is not None and len(self._row.path) > 1 and self._row.rear:
                bench.back(both)
                yield self._followed(before, place.section)
            return

    def _followed(self, before: str, other: SectionId) -> Step:
        """What a train leaves first is kept while another may still come towards the signal (R9)."""
        bench, row, y = self._bench, self._row, self._bench.symbols
        (rear, first, second), came = (row.rear[0], *row.path[:2]), list[str]()
        for left, into in ((None, rear), (rear, first), (first, second)):
            bench.inputs |= occupied(y, into)
            bench.scans(FEW)
            bench.inputs |= dict.fromkeys(occupied(y, left), 1) if left is not None else {}
            bench.scans(FEW)
        bench.wait(max(x.delay_s for part in row.parts for x in part.locking.release) + SLACK_S)
        came += [] if locked(bench, first) else [f"{first} is released"]
        do = f"{before} set before it, a train in {other}: another drives over {row.name} into {second}"
        return self._step(do, f"{first} stays locked behind it while {other} is occupied", "R9", came)

    def _ask(self, r: RouteRow) -> None:
        """Ask for a further route, and wait until its machines lie."""
        bench = self._bench
        bench.scan({str(bench.symbols.requests.request): r.number})
        gap = bench.layout.principles.point_start_gap_s + 2 * SCAN_MS / 1000
        machines = sum(len(part.locking.points) for part in self._table.parts(r))
        bench.wait(2 * FEW * SCAN_MS / 1000 + machines * gap)

    @property
    def _cancel(self) -> dict[str, int]:
        return {str(self._bench.symbols.cancellation.cancel[self._row.row.entry]): 1}

    @property
    def _hold(self) -> float:
        """Seconds for which what was added to the route is held after it would let it go."""
        return max(part.locking.hold for part in self._row.parts)

    def _given_up_late(self, before: str) -> Step:
        """It is cancelled while a train may come, and given up after its delay.  `before`: what stands before it."""
        bench, row, delay = self._bench, self._row, self._row.row.locking.approach.delay_s
        bench.scan(self._cancel)
        came = ["it stays at proceed"] if self._proceed() else []
        bench.wait(max(0.0, delay - SLACK_S))
        came += [] if locked(bench, row.path[0]) and bench.on(row.symbols.active) else ["it is given up too early"]
        bench.wait(2 * SLACK_S + self._hold)
        came += ["it stays locked"] if bench.on(row.symbols.active) else []
        expect = f"stop at once; {row.path[0]} stays locked for {exact(delay)} s, and then the route is given up"
        return self._step(f"{self._at_proceed()}{before}: cancel {row.name}", expect, "R8", came)

    def _kept_out(self, opened: Moment) -> Iterator[Step]:
        """Routes that the author declares hostile are kept out until the train is wholly in the last section, and
        longer where he asks for it; those of each route that leads past a signal, and of what is set beyond it, until
        the train is in the last section of that."""
        way = list(self._row.rear)
        for part in self._row.parts if not self._row.calls_on else ():
            way += [s for s in part.path.section_ids if s not in way]
            if part.locking.barred:
                yield from self._kept_out_until(opened, part, way)

    def _kept_out_until(self, opened: Moment, part: RouteRow, way: Sequence[SectionId]) -> Iterator[Step]:
        """`way`: the sections in which the train is up to the end of a part, that before the signal first."""
        bench, y, hold = self._bench, self._bench.symbols, part.locking.hold
        others = [self._table.route[b.route] for b in part.locking.barred]
        bench.back(opened)
        for k, s in enumerate(way):
            bench.inputs |= occupied(y, s)
            bench.scans(FEW)
            if 0 < k < len(way) - 1:
                bench.inputs |= dict.fromkeys(occupied(y, way[k - 1]), 1)
                bench.scans(FEW)
        bench.wait(part.locking.release[0].delay_s + SLACK_S)
        both = bench.moment()
        yield from (self._not_beside(both, r, f"its train in {' and '.join(way[-2:])}") for r in others)
        if hold > SLACK_S and len(way) > 1:
            bench.back(both)
            bench.inputs |= dict.fromkeys(occupied(y, way[-2]), 1)
            bench.wait(hold - SLACK_S)
            gone, where = bench.moment(), f"its train wholly in {way[-1]} for less than {exact(hold)} s"
            yield from (self._not_beside(gone, r, where) for r in others)

    def _not_beside(self, now: Moment, other: RouteRow, where: str) -> Step:
        bench = self._bench
        bench.back(now)
        bench.scan({str(bench.symbols.requests.request): other.number})
        bench.scans(FEW)
        came = ["it is set"] if bench.on(bench.symbols.routes.number[other.number].active) else []
        do = f"{self._row.name} set, {where}: ask for {called('route', other.id)}, declared hostile"
        return self._step(do, "it is refused", "R6", came)

    def _driven(self, opened: Moment) -> Iterator[Step]:
        """A train drives over the route; what it leaves is released behind it, after its delay."""
        bench, row = self._bench, self._row
        bench.back(opened)
        bench.inputs |= occupied(bench.symbols, *row.rear)
        bench.scans(FEW)
        delay = {x.section: x.delay_s for part in row.parts for x in part.locking.release}
        left = row.rear[0] if row.rear else None
        for k, s in enumerate(row.path):
            bench.inputs |= occupied(bench.symbols, s)
            bench.scans(FEW)
            expect, came = list[str](), list[str]()
            if k == 0:
                closes, came = self._passed(left)
                expect.append(closes)
            if left is not None:
                bench.inputs |= dict.fromkeys(occupied(bench.symbols, left), 1)
                bench.scan()
            if k == 0:
                came += ["it stays at proceed"] if self._proceed() else []
            elif left in delay and left not in row.overlap:
                expect.append(f"{left} is released after {exact(delay[left])} s")
                came += self._released(left, delay[left])
            expect.append(f"{s} is locked")
            came += [] if locked(bench, s) else [f"{s} is not locked"]
            leaves = "" if left is None else f", and leaves {left}"
            yield self._step(f"the train over {row.name} comes into {s}{leaves}", "; ".join(expect), "R9", came)
            left = s

    def _passed(self, rear: SectionId | None) -> tuple[str, list[str]]:
        """When the signal closes behind the first axle, in words, and what is otherwise while both sections are
        occupied."""
        row = self._row
        if rear is None or row.row.signal.closing.whole is None:
            at_once = ["it stays at proceed behind the first axle"] if self._proceed() else []
            return f"{row.signal} shows stop at the first axle", at_once
        closed = [] if self._proceed() else ["it shows stop at the first axle"]
        return f"{row.signal} stays at proceed while {rear} is occupied, too, and then shows stop", closed

    def _released(self, s: SectionId, delay_s: float) -> list[str]:
        """What is wrong with the release of a section that was left now."""
        bench, came = self._bench, list[str]()
        if delay_s > SLACK_S:
            bench.wait(delay_s - SLACK_S)
            came += [] if locked(bench, s) else [f"{s} is released too early"]
        bench.wait(2 * SLACK_S)
        return [*came, f"{s} stays locked"] if locked(bench, s) else came

    def _step(self, do: str, expect: str, rule: str, came: list[str] | None) -> Step:
        """`came`: None where it was not tried."""
        return Step(Sheet.ROUTES, self._row.row.id, do, expect, rule, came is not None, "; ".join(came or ()))


def _looked_at(bench: Bench, turned: Iterable[MachineId]) -> None:
    """Points that were turned without a command count as trailed: somebody has looked at them, and says so."""
    looks = {str(n): 1 for m in turned if (n := bench.symbols.machines.looked_at.get(m)) is not None}
    if looks:
        bench.scan()
        bench.scan(looks)
