"""A large induction in parts: proof obligations that lie together, and the facts that speak of what they read.

A part has the definitions in the cone of influence of its goals within the step, and every invariant and assumption
that shares a variable with them.

**Theorem.**  Each goal follows from all facts if it follows from some of them, so that the conjunction of the parts'
answers is the induction step of the whole, whatever facts a part leaves out.  (Cone of influence: Clarke, Grumberg and
Peled, *Model Checking*, 1999; the step of a conjunction is the conjunction of the steps.)
"""

from __future__ import annotations

from collections import Counter, deque
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import cached_property, partial
from itertools import chain
from typing import NamedTuple

from interlock.dataclass import dataclass
from interlock.logic.expr import TRUE, Expr, variables
from interlock.logic.names import Name
from interlock.proof.abstraction.canonical import CanonicalForms
from interlock.proof.abstraction.queries import Batch, LocalQueries
from interlock.proof.engines.batch import Decision, decided
from interlock.proof.engines.limits import Limits
from interlock.proof.engines.pool import run
from interlock.proof.induction.one_state import OfState, States
from interlock.proof.system.neighbourhood import Neighbourhood
from interlock.proof.system.relation import TransitionRelation

SMALL = 9_500  # so many goals are asked with all facts
TOGETHER = 2_000  # goals at most of a question with all facts: its solver reads the denials of all of them
GOALS = 4000  # in a part: fewer would encode the same definitions more often
FEW = 800  # at first a part of fewer goals is joined with the next place: neighbours share what they depend on
LEFT = 8  # afterwards one of fewer: more facts lie around each, and few goals are left at a place
NEAR = 3000  # a part of a place that depends on more names than this is joined with those of the next places
LARGE = 8000  # goals of a part that depends on more names than this are first asked of one state, or of one place
SAMPLE = 16  # one goal of so many tells how much the goals of a system depend on
HUB = 60  # a variable in more facts than this says nothing about what lies together


class Goal(NamedTuple):
    """What is to be shown: an expression about a step, or about the state one step later."""

    expr: Expr
    later: bool = False


class Parts:
    """The facts of a step, by the variables that they read."""

    def __init__(self, relation: TransitionRelation, where: Neighbourhood, hypotheses: Sequence[Expr]) -> None:
        self.relation = relation
        self.where = where
        self.hypotheses = hypotheses
        self.facts = [*hypotheses, *(a.expr for a in relation.assumptions)]
        self._forms = CanonicalForms(relation.definitions)
        self._names: dict[Expr, tuple[Name, ...]] = {}

    def names_in(self, x: Expr) -> tuple[Name, ...]:
        """What a fact or goal reads, looked up once."""
        found = self._names.get(x)
        if found is None:
            found = self._names[x] = tuple(variables((x,)))
        return found

    @cached_property
    def reads(self) -> list[tuple[Name, ...]]:
        """What each fact reads."""
        return [self.names_in(x) for x in self.facts]

    @cached_property
    def readers(self) -> dict[Name, list[int]]:
        """The facts by what they read."""
        found: dict[Name, list[int]] = {}
        for n, names in enumerate(self.reads):
            for v in names:
                found.setdefault(v, []).append(n)
        return found

    def prepare(self) -> None:
        """Read everything once, so that processes inherit it."""
        _ = self.readers, self.relation.reads

    def read_by(self, goal: Goal) -> tuple[Name, ...]:
        """What a goal reads."""
        names, later = self.names_in(goal.expr), self.relation.later
        return tuple([later.get(v, v) for v in names]) if goal.later else names

    def places(self, goals: Sequence[Goal]) -> list[list[int]]:
        """The goals place by place, and in a place those that share variables near each other."""
        reads = [self.read_by(g) for g in goals]
        order = _sharing(reads)
        at = [self._at(names) for names in reads]
        block = Counter(p for those in at for p in those)
        place = 0
        found: dict[int, list[int]] = {}
        for n in order:  # what belongs nowhere follows what it shares a variable with
            place = min(at[n], key=lambda p: (block[p], p), default=place)
            found.setdefault(place, []).append(n)
        return [found[p] for p in sorted(found)]

    def _at(self, names: Iterable[Name]) -> set[int]:
        """Where names belong, or else the nearest of what they depend on."""
        while not (at := _places(names, self.where.places)):
            names = dict.fromkeys(chain.from_iterable(self.relation.reads.get(v, ()) for v in names))
            if not names:
                break
        return at

    def cone(self, names: Iterable[Name], seen: dict[Name, None]) -> None:
        """Everything that the names depend on within the step."""
        todo, reads = list(names), self.relation.reads
        while todo:
            v = todo.pop()
            if v not in seen:
                seen[v] = None
                todo += reads.get(v, ())

    def around(self, seen: dict[Name, None], rings: int) -> list[int]:
        """The facts so many steps around what is seen, which grows by what they depend on; 0 rings: all facts."""
        facts: dict[int, None] = {}
        for ring in range(rings):
            if ring:
                self.cone([v for n in facts for v in self.reads[n]], seen)
            for v in list(seen):
                near = self.readers.get(v, ())
                if len(near) <= 4 * HUB:
                    facts.update(dict.fromkeys(near))
        return sorted(facts) if rings else list(range(len(self.facts)))

    def form(self, goals: Sequence[Goal], facts: Iterable[int]) -> str:
        """What is left of a question when names are numbered."""
        order = "".join("'" if g.later else "." for g in goals)
        later = [g.expr for g in goals if g.later]
        now = [g.expr for g in goals if not g.later]
        return self._forms.digest(
            order, ((later, self.relation.later), (now, {}), ([self.facts[n] for n in facts], {}))
        )

    def decide(self, goals: Sequence[Goal], limits: Limits, rings: int) -> list[Decision]:
        """Which of the goals follow from the facts so many steps around."""
        seen: dict[Name, None] = {}
        if rings:
            self.cone(chain.from_iterable(map(self.read_by, goals)), seen)
        facts = self.around(seen, rings)
        asked = [self.relation.after(g.expr) if g.later else g.expr for g in goals]
        known = [self.facts[n] for n in facts]
        return decided(asked, known, self.relation.definitions, limits, lambda: self.form(goals, facts))


def _places(names: Iterable[Name], known: Mapping[Name, tuple[int, ...]]) -> set[int]:
    """Where an expression over some variables may belong: to sections, or else where its routes run."""
    where = [known[v] for v in names if v in known]
    return {p[0] for p in where if len(p) == 1} or {q for p in where for q in p}


def _sharing(reads: Sequence[tuple[Name, ...]]) -> list[int]:
    """Numbers of expressions, those that share variables near each other."""
    having: dict[Name, list[int]] = {}
    for n, names in enumerate(reads):
        for v in names:
            having.setdefault(v, []).append(n)
    done = [False] * len(reads)
    seen: set[Name] = set()
    out: list[int] = []
    for start in range(len(reads)):
        if done[start]:
            continue
        done[start] = True
        todo = deque([start])
        while todo:
            n = todo.popleft()
            out.append(n)
            for v in reads[n]:
                near = having[v]
                if v not in seen and len(near) <= HUB:
                    seen.add(v)
                    for m in near:
                        if not done[m]:
                            done[m] = True
                            todo.append(m)
    return out


@dataclass(frozen=True)
class Question:
    """Goals that are asked of one solver, by number, and the rings of facts around them.

    `equal`: the goals of parts that are this one under other names, in the same order.
    """

    goals: Sequence[int]
    rings: int
    equal: Sequence[Sequence[int]] = ()

    def __len__(self) -> int:
        return len(self.goals) * (1 + len(self.equal))


Asked = Question | OfState | Batch
"""What is asked at once."""


class Inquiry:
    """Which goals follow from the hypotheses, the assumptions and the definitions of the step.

    Part by part; what a part leaves open is asked again with more facts around it, and at last with all of them.  The
    goals of parts that are very large are asked before of one state, or of local abstractions.

    A goal that is not about the state one step later may be shown with the hypotheses about that state, too: it counts
    only if the step keeps all hypotheses.
    """

    def __init__(
        self,
        relation: TransitionRelation,
        where: Neighbourhood,
        hypotheses: Sequence[Expr],
        goals: Sequence[Goal],
        limits: Limits,
    ) -> None:
        self.parts = Parts(relation, where, hypotheses)
        self.goals = goals
        self.limits = limits
        self.found = [Decision(g.expr is TRUE, 0.0) for g in goals]
        self.asked_locally: dict[int, None] = {}
        self.unseen: set[int] = set()

    @cached_property
    def local(self) -> LocalQueries:
        """The local abstractions of the step."""
        return LocalQueries(self.parts.relation, self.parts.where, self.parts.hypotheses, self.limits)

    @cached_property
    def states(self) -> States:
        """What is known of one state."""
        return States(self.parts.relation, self.parts.where, self.parts.hypotheses, self.limits)

    @cached_property
    def places(self) -> list[list[int]]:
        """The goals place by place."""
        return self.parts.places(self.goals)

    def questions(self, rings: int, large: int | None = None) -> list[Asked]:
        """What is still open, one question for all parts of one canonical form.

        large: the goals of a part with more names are asked of one state or of local abstractions.
        """
        left = [n for n, d in enumerate(self.found) if not d.follows]
        if not left or not rings:
            count = max(self.limits.jobs, -(-len(left) // TOGETHER))
            size = max(1, -(-len(left) // count))
            return [Question(left[k : k + size], 0) for k in range(0, len(left), size)]
        self.parts.prepare()
        found: dict[str, list[list[int]]] = {}
        wide: list[int] = []
        most = max(1, min(GOALS, -(-len(left) // self.limits.jobs)))
        for goals, seen in self._parts(self.places, FEW if rings == 1 else LEFT, most):
            if large is not None and len(seen) > large:
                wide += goals
                continue
            key = f"{len(found)}"  # a large part has no like
            if len(seen) <= NEAR:
                key = self.parts.form([self.goals[n] for n in goals], self.parts.around(seen, rings))
            found.setdefault(key, []).append(goals)
        return [*self._wide(wide), *(Question(first, rings, equal) for first, *equal in found.values())]

    def _is_wide(self, goals: Sequence[int]) -> bool:
        """Most goals of a large system, as far as some tell, depend on too much to lie in a part of their own.

        Where none is asked place by place, the places of all goals need not be found.
        """
        if len(self.parts.relation.definitions) <= LARGE:
            return False
        some = goals[::SAMPLE]
        places = [[some[n] for n in those] for those in self.parts.places([self.goals[n] for n in some])]
        wide = [len(those) for those, seen in self._parts(places, FEW // SAMPLE, GOALS // SAMPLE) if len(seen) > LARGE]
        return 2 * sum(wide) > len(some)

    def _wide(self, wide: Sequence[int]) -> list[Asked]:
        """Claims about one state, and local abstractions for all other goals."""
        if not wide:
            return []
        claims = [(n, self.goals[n].expr) for n in sorted(wide) if not self.goals[n].later]
        of_states, others = self.states.questions(claims)
        return [*of_states, *self._batches([*(n for n in wide if self.goals[n].later), *others])]

    def _batches(self, wide: Sequence[int]) -> list[Batch]:
        """Goals by number, in batches for local abstractions."""
        after = self.parts.relation.after
        goals = [(n, self.goals[n]) for n in sorted(wide)]  # in one order everywhere, so that like places have one form
        return self.local.batches([(n, after(g.expr) if g.later else g.expr) for n, g in goals]) if wide else []

    def _parts(
        self, places: Iterable[Sequence[int]], few: int, most: int
    ) -> Iterator[tuple[list[int], dict[Name, None]]]:
        """The open goals of places that lie together, and what they depend on."""
        goals: list[int] = []
        seen: dict[Name, None] = {}
        for place in places:
            new = [n for n in place if not self.found[n].follows]
            self.parts.cone(chain.from_iterable(self.parts.read_by(self.goals[n]) for n in new), seen)
            goals += new
            while len(goals) >= most:
                yield goals[:most], seen
                goals = goals[most:]
            if len(seen) <= NEAR and (len(goals) >= few or 2 * len(seen) >= NEAR):
                yield goals, seen
                goals, seen = [], {}
        if goals:
            yield goals, seen

    def first(self) -> list[Asked]:
        """The questions to begin with: with all facts where the goals are few."""
        left = [n for n, d in enumerate(self.found) if not d.follows]
        if self._is_wide(left):
            return self._wide(left)
        return self.questions(0 if len(self.goals) <= SMALL else 1, LARGE)

    def ask(self, question: Asked) -> list[Decision]:
        """Decide the goals of a question; of a batch those that it leaves open do not follow."""
        if isinstance(question, Batch):
            left = frozenset(self.local.left(question))
            return [Decision(n not in left, 0.0) for n in question.goals]
        goals = [self.goals[n] for n in question.goals]
        if isinstance(question, OfState):
            return self.states.decide([g.expr for g in goals], question.after)
        return self.parts.decide(goals, self.limits, question.rings)

    def note(self, question: Asked, answers: Sequence[Decision]) -> None:
        """Keep the answers to a question; what batches show counts when all are done."""
        if isinstance(question, Batch):
            self.asked_locally |= dict.fromkeys(question.goals)
            self.unseen.update(n for n, d in zip(question.goals, answers, strict=True) if not d.follows)
            return
        for n, answer in zip(question.goals, answers, strict=True):
            self.found[n] = answer
        for goals in question.equal if isinstance(question, Question) else ():
            for n, answer in zip(goals, answers, strict=True):
                self.found[n] = Decision(answer.follows, 0.0)

    def _conclude(self) -> None:
        """What all batches have shown follows."""
        for n in self.asked_locally:
            if n not in self.unseen:
                self.found[n] = Decision(True, 0.0)
        self.asked_locally, self.unseen = {}, set()

    def finish(self, progress: Callable[[int, int], None]) -> list[Decision]:
        """All answers: what the first questions left open is asked again."""
        if self.asked_locally:
            self._conclude()
        for rings in (2, 0) if len(self.goals) > SMALL else ():
            self.settle(self.questions(rings), progress)
        return self.found

    def settle(self, questions: Sequence[Asked], progress: Callable[[int, int], None]) -> None:
        """Decide questions, beside each other."""
        done = sum(d.follows for d in self.found)

        def report(n: int) -> None:
            nonlocal done
            done += len(questions[n])
            progress(min(done, len(self.goals)), len(self.goals))

        answers = run([partial(self.ask, q) for q in questions], self.limits.jobs, report)
        for question, found in zip(questions, answers, strict=True):
            self.note(question, found)


def decide(
    relation: TransitionRelation,
    where: Neighbourhood,
    hypotheses: Sequence[Expr],
    goals: Sequence[Goal],
    limits: Limits,
    progress: Callable[[int, int], None],
) -> list[Decision]:
    """Which goals follow; see `Inquiry`."""
    inquiry = Inquiry(relation, where, hypotheses, goals, limits)
    inquiry.settle(inquiry.first(), progress)
    return inquiry.finish(progress)
