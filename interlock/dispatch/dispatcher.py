"""One command a train, carried out route by route, so that trains never block one another for ever.

The dispatcher sees what a panel sees: sections as reported, locks and lamps as indicated.  It asks for a route as an
operator would, for a train that stands before its signal or runs towards it, and only if a completion plan exists for
the state after: a sequence of routes after which every train is where it may stay.  So there is always a plan, and
whose turn it is can be decided by anything else.  Where no plan exists (a train without a command stands in the way, a
point fails), the trains that are caught are named and stay where they are, and the others go on if they can.

It can do no harm: whatever it asks for is refused by the interlocking if it is not safe.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Mapping
from dataclasses import replace

from interlock.dispatch.arbiter import Arbiter, Key, Request, Source, key
from interlock.dispatch.commands import errand
from interlock.dispatch.holding import Holding
from interlock.dispatch.journal import Journal
from interlock.dispatch.obstacles import STRANGER_MS, Obstacles
from interlock.dispatch.panel import Indications, Stage, stages
from interlock.dispatch.plan.errands import Errand, Step
from interlock.dispatch.plan.railway import Railway
from interlock.dispatch.plan.search import BUDGET, Verdict
from interlock.dispatch.policy import Policy, enters, past, yields
from interlock.dispatch.run import Run, ran
from interlock.logic.symbols import Symbols
from interlock.model.elements import Lane, SignalId

REOPENS_MS = 15_000
"""A route that is set, and nothing seen keeps shut, is asked for again after this time (our choice)."""

AGAIN_MS = 5_000
"""A route that was refused is asked for again after this time (our choice)."""


class Dispatcher:
    """Carries out commands, and hands on what an operator asks for by hand, which comes first.

    look_ahead: how many routes are set ahead of a train.  priorities: the class of a voyage decides who is served
    first, else the order of the commands; `wait_ms`: one that has waited so long comes first all the same (0: never).
    rule: ask only if a completion plan exists; without it deadlocks can be shown.  guide: why a train is to wait though
    it could go on; whoever gives one sees to it that it ends.  told: what the controller says of a route that it
    refuses.
    """

    def __init__(
        self,
        railway: Railway,
        symbols: Symbols,
        *,
        look_ahead: int = 1,
        priorities: bool = False,
        wait_ms: int = 0,
        rule: bool = True,
        policy: Policy | None = None,
        budget: int = BUDGET,
        guide: Callable[[Run, Step], str] = lambda run, step: "",
        told: Callable[[Stage], str] = lambda stage: "",
    ) -> None:
        if look_ahead < 1:
            raise ValueError("at least one route is set ahead of a train")
        self.railway, self._symbols = railway, symbols
        self.stages = stages(railway.table, symbols)
        self._look_ahead, self._priorities, self._wait_ms = look_ahead, priorities, wait_ms
        self._rule, self._policy = rule, policy
        self._started = 0
        self.runs: list[Run] = []
        self.pending: list[Run] = []
        """Commands kept until a plan exists with them, too; their trains are still outside."""
        self.arbiter = Arbiter(wait_ms, AGAIN_MS)
        """Routes asked for by people; runs compete with them."""
        self.held: dict[str, str] = {}
        """Trains for which nothing is asked, and why: their numbers are in doubt."""
        self.other: deque[int] = deque()
        """Numbers that are asked for by hand and are no routes: overlaps that are to swing."""
        self.journal = Journal()
        self._guide, self._told = guide, told
        self._writes, self._for = 0, None  # type: tuple[int, tuple[Run, Stage] | None]
        self._cancels: dict[str, int] = {}
        self._passing: dict[SignalId, Stage] = {}
        self._obstacles = Obstacles(symbols, railway.held)
        self.holding = Holding(railway, self.runs, rule, budget, self.journal.said)

    # --- commands ------------------------------------------------------------------------------

    def begin(self, name: str, length_m: float = 0.0) -> Run:
        """Command a voyage of the layout.  Raises `KeyError` where there is none of that name."""
        if all(v.name != name for v in self.railway.table.voyages):
            raise KeyError(name)
        return self.carry_out(*errand(self.railway, name, length_m), voyage=name)

    def carry_out(self, order: Errand, priority: int = 0, voyage: str = "") -> Run:
        """Command an errand; `voyage`: which of the layout's.  Raises `NoVoyage` where no chain of routes makes it."""
        taken = {r.name for r in (*self.runs, *self.pending)}
        name = next(n for n in (order.train, *(f"{order.train} {k}" for k in range(2, 10_000))) if n not in taken)
        run = Run(name, self.railway.draft(replace(order, train=name)), priority)
        row = next((v for v in self.railway.table.voyages if v.name == voyage), None)
        if row is not None:
            run.voyage, run.lines = voyage, {m.voyage: frozenset(m.sections) for m in row.meetings}
        self.pending.append(run)
        self.holding.forget()
        return run

    def end(self, name: str) -> bool:
        """Give up a command: nothing more is asked for; what is set stays until it is cancelled or used."""
        before = len(self.runs) + len(self.pending)
        for run in [r for r in self.runs if r.name == name]:
            self._remove(run)
        self.pending = [r for r in self.pending if r.name != name]
        return len(self.runs) + len(self.pending) < before

    def give_up(self) -> list[str]:
        """Give up everything: all commands, whose names it gives, and all that people have asked for."""
        names = [r.name for r in (*self.runs, *self.pending)]
        for name in names:
            self.end(name)
        for request in tuple(self.arbiter.waiting):
            self.arbiter.withdraw(request)
        self.arbiter.asked = None
        self.other.clear()
        self._writes, self._for = 0, None
        return names

    def ask(self, number: int, source: Source = Source.HAND) -> None:
        """A route (or the swing of an overlap) asked for by somebody: by hand once, else kept until it is granted.

        Raises `Full`.
        """
        row = next((r for r in self.railway.table.routes if r.number == number), None)
        if row is None:
            self.other.append(number)
            return
        lanes = {s.id for s in self.railway.layout.track.sections if s.lane is Lane.INCLINED}
        self.arbiter.add(self.stages[row.id], source, self._priorities and not lanes.isdisjoint(row.path.section_ids))

    # --- one scan ------------------------------------------------------------------------------

    def step(self, seen: Indications, dt_ms: int) -> dict[str, int]:
        """What to write after a scan, from what was seen in it; `dt_ms` milliseconds after the step before."""
        for run in self.runs:
            name = self._symbols.cancellation.cancel[run.way.granted[run.way.at].entry] if run.way.ahead else ""
            run.way.by_hand |= bool(name and seen.get(name, 0) and not self._cancels.get(name, 0))
        for name in self._cancels:
            self._cancels[name] = 0
        for run in tuple(self.runs):
            self._follow(run, seen, dt_ms)
            for stage in run.way.granted[run.way.at :] if run.way.cancelling else ():
                self._cancels[self._symbols.cancellation.cancel[stage.entry]] = 1
        self._passing = {g: s for g, s in self._passing.items() if s.shown.stands(seen) and s.entered(seen)}
        near = {s for run in self.runs for s in run.near}
        if self._obstacles.look(seen, dt_ms, near, [ran(run) for run in self.runs]):
            self.holding.obstacles = self._obstacles.things
            self.holding.forget()
        self.arbiter.tick(seen, dt_ms)
        acknowledged = seen.get(self._symbols.requests.seen[self._symbols.requests.request], 0)
        if self._writes and acknowledged:
            self._answered(seen)
        elif not self._writes and not acknowledged:
            if seen.get(self._symbols.valid, 0):
                self._next(seen)
            else:
                self._by_hand(seen)
        return {self._symbols.requests.request: self._writes, **self._cancels}

    def _follow(self, run: Run, seen: Indications, dt_ms: int) -> None:
        """Where the train of a run has come to, and whether what was set for it is open."""
        run.asking.waited_ms += dt_ms
        run.asking.rest_ms = max(0, run.asking.rest_ms - dt_ms)
        if run.way.not_passed(seen):
            run.way.at -= 1
            self._passing.pop(run.way.granted[run.way.at].entry, None)
            self.journal.said.append(
                f"{run.name} has not passed {run.way.granted[run.way.at].entry}: something else was reported"
            )
        if run.way.ahead:
            stage = run.way.granted[run.way.at]
            if stage.shown.open(seen) and run.way.at not in run.way.opened:
                run.way.opened.add(run.way.at)
                self.journal.said.append(f"{run.name}: {stage.route} is open")
                run.asking.waited_ms = run.way.reopened = 0
                run.way.by_hand = False
            if run.way.at in run.way.opened and stage.entered(seen) and stage.shown.stands(seen):
                if stage.shown.rear is not None:  # the train that passes is not yet the next one
                    self._passing[stage.entry] = stage
                run.way.at += 1
                run.way.entering = stage
            elif run.way.cancelling and not any(s.taken(seen) for s in run.way.granted[run.way.at :]):
                self._taken_back(run)
            elif run.way.at in run.way.opened and not stage.shown.held(seen):
                self.journal.said.append(f"{run.name} is given up: {stage.route} was taken back before its train came")
                self._remove(run)
                return
            elif run.way.at not in run.way.opened and not stage.shown.is_set(seen) and not stage.entered(seen):
                self._taken_back(run)  # it was refused, and what was locked there was an overlap
            elif not run.way.cancelling and (why := self._shut(run, stage, seen, dt_ms)):
                self.journal.said.append(f"{run.name}: {stage.route} is taken back, since {why}")
                run.way.cancelling = True
        self._stands(run, seen)
        if run.through(seen):
            self.journal.said.append(f"{run.name} is done")
            self._remove(run)

    def _stands(self, run: Run, seen: Indications) -> None:
        """Plans count on an overlap that was given up, whoever comes behind the train now."""
        if run.way.ahead or run.way.given_up == run.place:
            return
        kept = self.railway.held.overlap_sections(run.place)
        locked = self._symbols.indication
        if kept and not any(seen.get(locked.get(f"locked {s}", ""), 1) for s in kept):
            run.way.given_up = run.place
            self.holding.forget()

    def _shut(self, run: Run, stage: Stage, seen: Indications, dt_ms: int) -> str:
        """Why a route that is set will not take its train on, if it is to be taken back: so that another may come out
        of the way, or the train take another way."""
        run.reason = ""
        if stage.shown.open(seen):
            run.way.shut_ms = 0
            return ""
        run.way.shut_ms += dt_ms
        if stage.shown.waits(seen):  # whoever has the direction may take his time
            run.reason = f"{stage.route} is set; the direction of the line beyond is not here"
            run.way.shut_ms = min(run.way.shut_ms, STRANGER_MS + 1)
        machine = stage.shown.fails(seen)
        if machine is not None:
            return self.railway.layout.machines.undetected(machine)
        full = next((n for n in stage.shown.beyond if not seen.get(n, 1)), None)
        return "a train stands on the line beyond" if full and run.way.shut_ms > STRANGER_MS else ""

    def _taken_back(self, run: Run) -> None:
        """A route that did not open was cancelled: its train stands where it stood."""
        run.place = run.way.places[run.way.at]
        self.journal.taken_back(run.name, [s.route for s in run.way.granted[run.way.at :]])
        del run.way.granted[run.way.at :], run.way.places[run.way.at :]
        run.asking.routes.clear()
        run.way.cancelling = False
        run.way.shut_ms = run.way.reopened = 0
        self.holding.forget()

    def _remove(self, run: Run) -> None:
        self.runs.remove(run)
        if not run.place.under and run.way.granted:
            beyond = self.railway.approach.get(self.railway.table.route[run.way.granted[-1].route].exit)
            if beyond is not None:
                self._obstacles.leaving.add(beyond)
        self.holding.forget()

    # --- asking --------------------------------------------------------------------------------

    def _answered(self, seen: Indications) -> None:
        """The request was read: the route is set, or was refused."""
        self._writes = 0
        asked = self.arbiter.asked
        if not self.arbiter.answered(seen) and asked is not None and asked.source is Source.HAND:
            self.arbiter.withdraw(asked)  # whoever asked is told, and asks again
        if self._for is None:
            return
        run, stage = self._for
        self._for = None
        step = run.asking.step
        if run not in self.runs or step is None:
            return
        if not stage.shown.is_set(seen):
            run.asking.rest_ms = AGAIN_MS
            why = self._told(stage)
            run.reason = f"{stage.route} was refused" + (f": {why}" if why else "")
            if len(run.asking.routes) == len(step.routes):
                run.asking.routes.clear()
            return
        self.journal.asked.append((run.name, stage.route))
        run.reason = ""
        run.asking.routes.remove(stage)
        if run.asking.routes:
            return
        taken = {(run.name, r.id) for r in step.routes}
        self.holding.plan = tuple(x for x in self.holding.plan if x not in taken)
        self.journal.steps.append((run.name, run.place.under[-1][0], step.turned))
        for r in step.routes:
            run.way.granted.append(self.stages[r.id])
            run.way.places.append(run.place)
        run.place = step.after
        if not run.started:
            self._started += 1
            run.started = self._started

    def _next(self, seen: Indications) -> None:
        """Begin to ask for a route, if one is to be set now."""
        if self.other:
            self._writes = self.other.popleft()
            return
        self._admit(seen)
        self.holding.prepare()
        found: list[tuple[Key, Request | Run]] = [(r.key(self._wait_ms), r) for r in self.arbiter.waiting]
        found += [(self._key(run, k), run) for k, run in enumerate(self.runs)]
        for _, one in sorted(found, key=lambda x: x[0]):
            if isinstance(one, Request):
                if self.arbiter.may(one, seen):
                    self._writes = self.arbiter.make(one).stage.number
                    return
            elif self._asks(one, seen):
                return

    def _by_hand(self, seen: Indications) -> None:
        """While inputs are not valid nothing is asked for but by hand: it is refused now, and not granted later."""
        if self.other:
            self._writes = self.other.popleft()
            return
        found = [r for r in self.arbiter.waiting if r.source is Source.HAND]
        if found and self.arbiter.may(found[0], seen):
            self._writes = self.arbiter.make(found[0]).stage.number

    def _key(self, run: Run, k: int) -> Key:
        """Where a run comes among the requests: its class of priority, then the order of the commands."""
        rank = run.priority if self._priorities and run.priority else 4
        waited = run.asking.waited_ms if bool(self._wait_ms) and run.asking.waited_ms >= self._wait_ms else 0
        return key(Source.PLANNED, self.arbiter.numbers + k + 1, rank < 3, rank % 2 == 1, waited, self._wait_ms)

    def _asks(self, run: Run, seen: Indications) -> bool:
        """Begin to ask for what a run wants, if it may."""
        if run.asking.rest_ms or run.way.cancelling:
            return False
        if (
            run.way.ahead
            and not run.way.by_hand
            and run.way.shut_ms >= REOPENS_MS
            and run.way.granted[run.way.at].shown.closed(seen)
        ):
            return self._reopens(run, seen)
        if run.name in self.held:
            run.reason = self.held[run.name]
            return False
        stage = run.asking.routes[0] if run.asking.routes else self._wanted(run, seen)
        if stage is None:
            return False
        why = stage.hindered(seen)
        if why:
            run.reason = f"{stage.route}: {why}"
            return False
        self._for, self._writes = (run, stage), stage.number
        return True

    def _reopens(self, run: Run, seen: Indications) -> bool:
        """A route that has closed is asked for again, twice; then it is taken back.  One of which no more is seen than
        the overlap of its signal, locked, was refused: points in it lie otherwise."""
        stage = run.way.granted[run.way.at]
        run.way.shut_ms = 0
        run.way.reopened += 1
        if run.way.reopened > 2:
            why = "is taken back, since it does not open again" if stage.taken(seen) else "was refused"
            self.journal.said.append(f"{run.name}: {stage.route} {why}")
            run.way.cancelling = True
            return False
        self._for, self._writes = None, stage.number
        return True

    def _wanted(self, run: Run, seen: Indications) -> Stage | None:
        """The first route of the step that a train takes next, if it may; sets `run.asking`."""
        if run.finished or run.way.ahead >= self._look_ahead:
            return None
        if run.caught:
            run.reason = run.caught
            return None
        for step, move in self.holding.steps(run):
            order = [self.stages[r.id] for r in step.routes]
            first = order[0]
            if not run.way.granted and (not first.shown.stands(seen) or first.entry in self._passing):
                run.reason = f"no train stands before {first.entry}"
                continue
            if (why := next((w for s in order if (w := s.hindered(seen))), "")) or (
                why := self.holding.behind(run, move)
            ):
                run.reason = f"{first.route}: {why}"
                continue
            if (why := self._waits(run, step, seen) or self._guide(run, step)) or (
                self._rule and not self.holding.safe(run, move)
            ):
                run.reason = f"{first.route}: {why}" if why else run.reason
                continue
            run.asking.step = step
            run.asking.routes = order[::-1] if self._far_first(run) else order
            return run.asking.routes[0]
        return None

    def _waits(self, run: Run, step: Step, seen: Indications) -> str:
        """For whom a train waits before a single line, by the policy."""
        if self._policy is None:
            return ""
        order = {r.name: k for k, r in enumerate(self.runs)}
        for other in self.runs:
            line = run.lines.get(other.voyage)
            if other is run or line is None or not enters(step, line) or other.way.uses(line) or past(other, line):
                continue
            first = self.stages[other.journey.steps[other.place][0].routes[0].id]
            there = bool(other.way.granted) or first.shown.stands(seen)
            if there and yields(self._policy, run, other, order) and self.holding.passes(other, line):
                return f"{other.name} goes first ({self._policy})"
        return ""

    def _far_first(self, run: Run) -> bool:
        legs = run.journey.errand.legs
        return run.place.leg < len(legs) and legs[run.place.leg].far_first

    def _admit(self, seen: Indications) -> None:
        """Take up the commands with which a plan still exists; one whose train is there is taken up in any case."""
        waits: set[object] = set()
        changed = self.holding.built is None
        for run in tuple(self.pending):
            start, there = run.journey.start.under, self._there(run, seen)
            if start in waits or not (there or changed):
                waits.add(start)
                continue
            self.runs.append(run)
            self.holding.forget()
            if self._rule and not there:
                self.holding.make()
                if self.holding.answer(self.holding.state()).verdict is not Verdict.PLAN:
                    self.runs.remove(run)
                    self.holding.forget()
                    run.reason = "no plan exists with it yet: it waits outside"
                    waits.add(start)
                    continue
            self.pending.remove(run)

    def _there(self, run: Run, seen: Indications) -> bool:
        """The train of a command is in the layout, or stands before its signal: somebody does who is not on the way
        in for a command that was taken up before, and not on the way out."""
        if not run.coming:
            return True
        start = run.journey.start.under
        first = self.stages[run.journey.steps[run.journey.start][0].routes[0].id]
        before = any(not r.way.at and r.journey.start.under == start for r in self.runs)
        out = {r.way.granted[r.way.at - 1].route for r in self.runs if r.way.at}
        exits = {self.railway.table.route[x].exit for x in out}
        leaves = start[0][0] in exits or self.railway.approach.get(str(start[0][0])) in self._obstacles.leaving
        return first.shown.stands(seen) and not (before or leaves or first.entry in self._passing)


def waiting(dispatcher: Dispatcher) -> Mapping[str, str]:
    """Why each train that waits does so."""
    held = {r.name: r.reason for r in dispatcher.pending}
    return held | {r.name: r.reason for r in dispatcher.runs if not r.finished and r.way.ahead == 0}
