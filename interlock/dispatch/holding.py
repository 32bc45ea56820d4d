"""The completion plan that is held: the problem of all trains with commands, its answers, and what they allow."""

from __future__ import annotations

from collections.abc import Sequence

from interlock.dispatch.plan.errands import Step
from interlock.dispatch.plan.problem import Built, Draft, Move, build, in_the_way
from interlock.dispatch.plan.railway import Railway
from interlock.dispatch.plan.search import Answer, Planner, Verdict
from interlock.dispatch.policy import enters
from interlock.dispatch.run import Run
from interlock.model.elements import SectionId


class Holding:
    """Plans for runs.  `runs`: those of the dispatcher, who changes them and then says `forget`."""

    def __init__(self, railway: Railway, runs: list[Run], rule: bool, budget: int, said: list[str]) -> None:
        self._railway, self.runs, self._rule, self.budget = railway, runs, rule, budget
        self._said = said
        self.refused = 0
        self.plan: tuple[tuple[str, str], ...] = ()
        self.obstacles: frozenset[object] = frozenset()
        self.built: Built | None = None
        self._planner: Planner | None = None
        self._answers: dict[int, Answer] = {}

    def forget(self) -> None:
        """Trains or what is in their way have changed: the problem is another one."""
        self.built = None

    def passes(self, run: Run, line: frozenset[SectionId]) -> bool:
        """A train could run over a line now, while all others stand."""
        assert self._planner is not None and self.built is not None
        beyond = 0
        for place, bit in self.built.bits[self.runs.index(run)].items():
            ahead = run.journey.steps[place]  # type: ignore[index]
            if not any(enters(s, line) for s in ahead) and place is not run.place:
                beyond |= bit
        return self._planner.alone(self.state(), self._bit(run), beyond & ~self._bit(run)) is not None

    def steps(self, run: Run) -> list[tuple[Step, Move]]:
        """The steps that a train could take next, that of the held plan first."""
        assert self.built is not None
        steps = run.journey.steps[run.place]
        moves = self.built.problem.moves[self._bit(run)]
        pairs = [(steps[int(m.label)], m) for m in moves]
        planned = next((r for t, r in self.plan if t == run.name), None)
        return sorted(pairs, key=lambda x: x[0].routes[0].id != planned)

    def behind(self, run: Run, move: Move) -> str:
        """Which train stands, or will stand, where a move leads; or what else is in its way."""
        assert self.built is not None
        p = self.built.problem
        if any(b & move.blocked for x in self.built.bits[len(self.runs) :] for b in x.values()):
            return self._obstacle(run, move)
        for other in self.runs:
            if other is not run and not other.coming and self._certain(other) & move.blocked:
                return f"{other.name} is in the way"
        state = self.state() & ~move.source
        if any(state & there and state & behind for there, behind in move.followed):
            return "an overlap is kept while another train is behind the one that stands before it"
        inside = self.state({r.name for r in self.runs if r.coming}) & ~move.source
        for z, room in move.zones:
            if p.limits[z].count(inside) > room:
                return f"{p.limits[z].name} is full"
        earlier = [r for r in self.runs if r.coming and r is not run and self._bit(r) & move.blocked]
        same = [r.name for r in earlier if run.coming and r.place.under == run.place.under]
        return f"{same[0]} comes in before it" if same else ""

    def _obstacle(self, run: Run, move: Move) -> str:
        """What is in the way of a move, of all that is in the way."""
        step = run.journey.steps[run.place][int(move.label)]
        needed = self.obstacles & step.besides.union(*map(self._railway.held.needs, step.routes))
        kind, name = min((str(x[0]), str(x[1])) for x in needed if isinstance(x, tuple))
        if kind == "lies":
            return f"{name} is not moved from where it lies"
        return f"{name} is {'blocked' if kind == 'blocked' else 'not clear'}"

    def safe(self, run: Run, move: Move) -> bool:
        """A completion plan exists for the state after; it is then the one that is held."""
        answer = self.answer(self.state({run.name}) | move.target)
        routes = run.journey.steps[run.place][int(move.label)].routes
        if answer.verdict is Verdict.PLAN:
            self.plan = (*((run.name, r.id) for r in routes), *self._told(answer))
            return True
        self.refused += 1
        route = routes[0].id
        if answer.verdict is Verdict.NONE:
            run.reason = f"{route}: then {', '.join(self._names(answer.caught))} could not all go on"
        else:
            run.reason = f"{route}: whether all could go on then was not found out"
        return False

    def answer(self, state: int) -> Answer:
        """Whether all can go on from a state (`state`), as the planner has it; each is asked once."""
        assert self._planner is not None
        if state not in self._answers:
            self._answers[state] = self._planner.solve(state)
        return self._answers[state]

    def _told(self, answer: Answer) -> tuple[tuple[str, str], ...]:
        """A plan as train and route."""
        assert self.built is not None
        by_name = {r.name: r for r in self.runs}
        found: list[tuple[str, str]] = []
        for m in answer.plan:
            name = self.built.problem.trains[m.train]
            options = by_name[name].journey.steps
            source = next(p for p, b in self.built.bits[m.train].items() if b == m.source)
            step = options[source][int(m.label)]  # type: ignore[index]
            found += [(name, r.id) for r in step.routes]
        is_set = {(r.name, stage.route) for r in self.runs for stage in r.way.granted[r.way.at :]}
        return tuple(x for x in found if x not in is_set)

    def _names(self, bits: int) -> list[str]:
        assert self.built is not None
        p = self.built.problem
        return [n for n, nodes in zip(p.trains, p.nodes, strict=True) if any(b & bits for b in nodes)]

    def _bit(self, run: Run) -> int:
        assert self.built is not None
        return self.built.bits[self.runs.index(run)][run.place]

    def _certain(self, run: Run) -> int:
        """Where a train will come for certain: a route that leads out is taken back if a train comes in there first.

        One that is being taken back takes it nowhere.
        """
        way = run.way
        out = (k for k, stage in enumerate(way.granted) if k >= way.at and (way.cancelling or stage.shown.beyond))
        before = next(out, None)  # of all that are set, the first that may be taken back
        if before is None:
            return self._bit(run)
        assert self.built is not None
        nodes = self.built.bits[self.runs.index(run)]
        return nodes.get(way.places[before], nodes[run.place])  # one that is caught has one node

    def state(self, without: Sequence[str] | set[str] = ()) -> int:
        """Where every train will come for certain, and what is in the way: a bit for each of their nodes."""
        assert self.built is not None
        own = sum(self._certain(r) for r in self.runs if r.name not in without)
        return own | sum(b for x in self.built.bits[len(self.runs) :] for b in x.values())

    def prepare(self) -> None:
        """The problem of all trains with commands and of what is in the way; who is caught is told and left out."""
        if self.built is not None:
            return
        for run in self.runs:
            run.caught = ""
        if not self._rule:
            self.make()
            return
        while True:
            self.make()
            answer = self.answer(self.state())
            if answer.verdict is Verdict.PLAN:
                self.plan = self._told(answer)
                return
            caught = [r for r in self.runs if r.name in self._names(answer.caught) and not r.caught]
            if answer.verdict is Verdict.UNKNOWN or not caught:
                self._tell("UNKNOWN: whether all trains can go on was not found out")
                return
            names = ", ".join(r.name for r in caught)
            text = f"no plan exists: {names} cannot go on{self._because()}"
            self._tell(text)
            for r in caught:
                r.caught = text

    def _tell(self, text: str) -> None:
        """Once, until something else is said."""
        if self._said[-1:] != [text]:
            self._said.append(text)

    def _because(self) -> str:
        things = sorted(str(x[1]) for x in self.obstacles if isinstance(x, tuple))
        return f", with {', '.join(dict.fromkeys(things))} in the way" if things else ""

    def make(self) -> None:
        """The problem as it is now; who is caught is in it as one that stands still."""
        drafts: list[Draft] = []
        for k, run in enumerate(self.runs):
            if run.caught:
                back = run.way.places[run.way.at].under if run.way.ahead and run.way.cancelling else ()
                drafts.append(self._railway.still(run.name, run.place, run.coming, back, run.way.given_up))
            else:
                same = [r.name for r in self.runs[:k] if r.coming and r.journey.start.under == run.journey.start.under]
                drafts.append(run.journey.nodes(same, run.way.given_up))
        if self.obstacles:
            drafts.append(in_the_way(self.obstacles))
        self.built = build(drafts, self._railway.held.zones)
        self._planner = Planner(self.built.problem, self.budget)
        self._answers = {}
