"""Functional tests of the routes (control table tests): each row of the interlocking table, cell by cell.

What has to come is read from the row alone; where something else comes on the bench, the step says what.
"""

from __future__ import annotations

from collections.abc import Iterator

from interlock.commissioning.bench import FEW, SCAN_MS, Bench, Moment, not_at_stop, occupied
from interlock.commissioning.needs import Need, needs, to_open
from interlock.commissioning.row import Row
from interlock.commissioning.step import SLACK_S, Sheet, Step
from interlock.diag.called import called
from interlock.logic.names import Name
from interlock.model.elements import MachineId, SectionId
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
        yield from (self._refused(opened, self._table.route[h]) for h in row.row.locking.hostile.routes)
        yield from self._cancelled(opened)
        if not row.calls_on:
            yield from self._driven(opened)

    # --- setting it ---

    def _longest_s(self) -> float:
        """Seconds within which the signal opens, if it opens at all."""
        row, rules = self._row, self._bench.layout.principles
        seconds = 2 * FEW * SCAN_MS / 1000 + (rules.token_delay_s if row.tokens else 0)
        return seconds + len(row.demands) * (rules.point_start_gap_s + 2 * SCAN_MS / 1000)

    def _open(self, lost: Need | None = None) -> bool:
        """The route is asked for at rest, with machines the other way; whether its signal opens: where something is
        lost, in the time in which it opened without."""
        bench, row = self._bench, self._row
        bench.back(self._rest)
        for m, p in row.demands.items():
            if row.turnable(m):
                bench.lies[m] = p.position.other
            elif row.calls_on:
                bench.lies[m] = p.position
        if row.calls_on:
            bench.inputs |= occupied(bench.symbols, *row.rear)
        if lost is not None:
            bench.inputs |= lost.inputs
        bench.scans(2)
        bench.scan({str(bench.symbols.requests.request): row.row.number})
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
        came = self._not_as_set() if self._open() else [f"it does not open: {self._bench.why_not(row.symbols)}"]
        return self._step(f"{do}: ask for {row.name}", expect, "R3", came)

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
        if free := [s for part in row.parts for s, _ in part.path.locked if not bench.locked(s)]:
            came.append(f"not locked: {', '.join(free)}")
        return came

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

    # --- giving it up, and driving over it ---

    def _cancelled(self, opened: Moment) -> Iterator[Step]:
        bench, row = self._bench, self._row
        delay, hold = row.row.locking.approach.delay_s, max(part.locking.hold for part in row.parts)
        cancel = {str(bench.symbols.cancellation.cancel[row.row.entry]): 1}
        if not row.always_locked and not row.calls_on:
            bench.back(opened)
            bench.scan(cancel)
            came = ["it stays at proceed"] if self._proceed() else []
            bench.wait(SLACK_S + hold)
            came += ["it stays locked"] if bench.on(row.symbols.active) else []
            do = f"{self._at_proceed()}, no train before it: cancel {row.name}"
            yield self._step(do, "stop at once, and the route is given up at once", "R8", came)
        bench.back(opened)
        bench.inputs |= occupied(bench.symbols, *row.rear)
        bench.scans(FEW)
        bench.scan(cancel)
        came = ["it stays at proceed"] if self._proceed() else []
        bench.wait(max(0.0, delay - SLACK_S))
        came += [] if bench.locked(row.path[0]) else ["it is given up too early"]
        bench.wait(2 * SLACK_S + hold)
        came += ["it stays locked"] if bench.on(row.symbols.active) else []
        before = f", a train in {row.rear[0]}" if row.rear else ""
        expect = f"stop at once; {row.path[0]} stays locked for {delay:g} s, and then the route is given up"
        yield self._step(f"{self._at_proceed()}{before}: cancel {row.name}", expect, "R8", came)

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
            if left is not None:
                bench.inputs |= dict.fromkeys(occupied(bench.symbols, left), 1)
                bench.scan()
            expect, came = [], []
            if k == 0:
                expect.append(f"{row.signal} shows stop")
                came += ["it stays at proceed"] if self._proceed() else []
            elif left in delay and left not in row.overlap:
                expect.append(f"{left} is released after {delay[left]:g} s")
                came += self._released(left, delay[left])
            expect.append(f"{s} is locked")
            came += [] if bench.locked(s) else [f"{s} is not locked"]
            leaves = "" if left is None else f", and leaves {left}"
            yield self._step(f"the train over {row.name} comes into {s}{leaves}", "; ".join(expect), "R9", came)
            left = s

    def _released(self, s: SectionId, delay_s: float) -> list[str]:
        """What is wrong with the release of a section that was left now."""
        bench, came = self._bench, list[str]()
        if delay_s > SLACK_S:
            bench.wait(delay_s - SLACK_S)
            came += [] if bench.locked(s) else [f"{s} is released too early"]
        bench.wait(2 * SLACK_S)
        return [*came, f"{s} stays locked"] if bench.locked(s) else came

    def _step(self, do: str, expect: str, rule: str, came: list[str] | None) -> Step:
        """`came`: None where it was not tried."""
        return Step(Sheet.ROUTES, self._row.row.id, do, expect, rule, came is not None, "; ".join(came or ()))
