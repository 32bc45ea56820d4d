"""What becomes of point mutations: one solver that knows the controller, and of each mutant only what it changes.

Every definition, assumption, invariant and condition of the restart has a literal that switches it on.  For a mutant
the changed ones are added and the old ones are left off: clauses that were learnt stay.  A mutant is proved as the
controller is: invariants that are lost, at the restart or in a step, are dropped until none is lost any more, and the
claims are asked with those that are left.  What no claim refuses is compared with the controller, as far as its
terminals show it; what may differ there is driven by trains and operators.

**Theorem.**  A mutant is called proved exactly if base, step and consequence hold for its own lines, as for a
controller (`induction/inductive.py`); lines that are switched off take part in no answer (`switched.py`).  A claim that
fails does not follow by induction; the mutant need not be unsafe.  (Houdini: Flanagan and Leino, 2001.)
"""

from __future__ import annotations

from collections.abc import Sequence
from enum import StrEnum
from functools import cached_property

from interlock.dataclass import dataclass
from interlock.logic import names
from interlock.logic.controller import Controller, MalformedController
from interlock.logic.expr import FALSE, TRUE, Expr, Substitution, variables
from interlock.model.elements import Position
from interlock.model.layout import Layout
from interlock.proof.mutation.lines import Lines
from interlock.proof.mutation.patterns import Patterns
from interlock.proof.mutation.points import Mutation
from interlock.proof.mutation.runs import Runs
from interlock.proof.mutation.same import Side, same, same_after_restart
from interlock.proof.mutation.switched import Switched
from interlock.proof.system.relation import TransitionRelation
from interlock.proof.system.transition import System

RENEWED = 400  # after so many mutants a solver carries more lines that are off than lines that are on
AT_ONCE = 40  # that one of so many goals is false is one question
FLANKS = (names.WAY_DETECTED, names.WAY_AVAILABLE, names.MOVABLE, names.TOUCHED, names.DEMANDED, names.SWINGS_TO)
"""What a demand or a condition of flank protection stands in."""
WAYS = (names.WAY_DETECTED, names.WAY_AVAILABLE)
FLANK_CLAIMS = ("T-FLANK ", "S-FLANK ", "T-SCISSORS ", "S-SCISSORS ", "S-FLANK-SPACE ")
LATER = "the same in every step after the restart delay, from one state"


class Fate(StrEnum):
    """What became of a mutant."""

    REFUSED = "refused"
    """It reads a value before it is computed, or the system has a variable that nobody defines: no controller."""
    CLAIM = "a claim fails"
    FUNCTION = "a function fails"
    """What a rule orders does not happen any more, or without its reason (`proof.functions`)."""
    TRAIN = "a train notices"
    """A route that a train could use can no longer be set, driven and released."""
    OPERATOR = "an operator notices"
    """What an operator could do with a route does not work any more, or works where it must not."""
    TEXT = "refuted as text"
    """An emitted text that does not compute the proved controller (`texts`)."""
    EQUIVALENT = "equivalent"
    """Whatever happens from power-up on, all outputs are the same; of a text: it computes the same."""
    SURVIVES = "survives"


@dataclass(frozen=True, slots=True)
class Verdict:
    """A mutant's fate, and the claim that fails, the run that does not work any more, or in what way it is the same."""

    fate: Fate
    why: str = ""


Named = list[tuple[str, Expr]]
AtStart = tuple[Named, str]


class Judge:
    """Tells the fate of the mutants of one controller."""

    def __init__(self, layout: Layout, controller: Controller) -> None:
        self.layout = layout
        self.controller = controller
        self.system = System(layout, controller)
        self.lines = Lines.of(self.system)
        self.reads = {n: frozenset(names) for n, names in self.system.relation.reads.items()}
        self._renew()
        facts = [*self.lines.assumptions, *(x for _, x in self.lines.invariants)]
        self.patterns = Patterns(self.lines.definitions, facts, (*self.lines.claims, *self.lines.functions))
        kept = self._proved(self.lines, self.system.relation)
        if isinstance(kept, str):
            raise ValueError(f"the controller itself is not proved: {kept}")
        self.side = Side(controller, self.system.relation.state, self.lines, kept)

    @cached_property
    def runs(self) -> Runs:
        """The runs that work with the controller; few mutants come so far."""
        return Runs(self.system.loop)

    def _renew(self) -> None:
        self.step = Switched()
        self.start = Switched()
        self.step.group([self.step.define(n, x) for n, x in self.lines.definitions.items()])
        self.step.group([self.step.fact(x) for x in self.lines.assumptions])
        self.step.group([self.step.fact(x) for _, x in self.lines.invariants])
        self._starts: dict[tuple[object, ...], AtStart] = {}
        self.asked = 0

    def judge(self, mutation: Mutation) -> Verdict:
        """The fate of one mutant."""
        try:
            controller = mutation.make()
            changed = self.system.changed(controller)
            known = None if changed is None else self.patterns.broken(changed)
            if known is not None:
                return _failed(known)
            if changed is None:
                system = System(self.layout, controller)
                lines = Lines.of(system)
            else:
                system = self.system.under(controller, changed)
                lines = self.lines.under(system)
        except MalformedController as e:
            return Verdict(Fate.REFUSED, str(e))
        kept = self._proved(lines, system.relation)
        if isinstance(kept, str):
            return _failed(kept)
        other = Side(controller, system.relation.state, lines, kept)
        how = same(self.step, self.side, other, self.reads)
        if how is not None:
            return Verdict(Fate.EQUIVALENT, how)
        noticed = self.runs.noticed(system.loop, changed)
        if noticed is not None:
            return Verdict(Fate.TRAIN if noticed[0] else Fate.OPERATOR, noticed[1])
        later = same_after_restart(self.step, self.side, other, self.reads)
        return Verdict(Fate.SURVIVES, LATER if later else self._kept_off(other))

    def _kept_off(self, mutant: Side) -> str:
        """In what way nothing can roll in at a flank whose protection the mutant lacks, or leaves; empty where claims
        say nothing of it, or it lacks anything else.

        It has another protection where the claims about the very ways follow although its machines are taken to lie
        nowhere; where they do not, the claims still hold of it, and every movement that could come in is kept off.
        """
        mine = {e.name: e.expr for e in self.controller.equations}
        changed = [e.name for e in mutant.controller.equations if mine.get(e.name) is not e.expr]
        if not changed or any(n.family not in FLANKS for n in changed):
            return ""
        ways = {n.at for n in changed if n.family in WAYS}
        machines = sorted({str(n.at[0]) for n in changed if n.family not in (*WAYS, names.SWINGS_TO)})
        nowhere = {x for m in machines for p in Position for lies in (names.LIES(m, p),) for x in (lies, lies.next)}
        about = [
            (n, x)
            for n, x in mutant.lines.claims
            if n.startswith(FLANK_CLAIMS)
            and x is not TRUE
            and (nowhere & {*variables((x,))} if machines else any(f" {s}:{k}:" in n for s, k in ways))
        ]
        if not about:
            return ""
        s, put = self.step, Substitution(dict.fromkeys(nowhere, FALSE))
        known = [s.define(n, x) for n, x in mutant.lines.definitions.items()]
        known += [s.fact(x) for x in (*mutant.lines.assumptions, *mutant.invariants)]
        here = [(n, x) for n, x in about if not ways or any(f" {s}:{k}:" in n for s, k in ways)]
        alone = machines and here and self._failing(known, [put(x) for _, x in here]) is None
        if not alone and self._failing(known, [x for _, x in about]) is not None:
            return ""
        where = f", wherever {' and '.join(machines)} may lie" if alone else ""
        return f"nothing can roll in at {len(here if alone else about)} claimed places{where}"

    def _proved(self, lines: Lines, relation: TransitionRelation) -> list[Expr] | str:
        """The invariants that are kept, or a claim, or else a function, that does not follow from them."""
        self.asked += 1
        if self.asked > RENEWED:
            self._renew()
        found, unmet = self._at_start(lines)
        if unmet and not unmet.startswith("F-"):
            return unmet
        kept, first = found, True
        s = self.step
        fixed = [s.define(n, x) for n, x in lines.definitions.items()] + [s.fact(x) for x in lines.assumptions]
        claimed = [c for c in lines.claims if c[1] is not TRUE]
        while True:
            known = [*fixed, *(s.fact(x) for _, x in kept)]
            for wanted in (claimed, lines.functions):
                model = self._failing(known, [x for _, x in wanted])
                if model is not None:
                    return self._seen(model, wanted, len(kept) == len(self.lines.invariants))
            after = [(i, relation.after(i[1])) for i in kept]
            model = self._failing(known, [x for _, x in after], again=first)
            if model is None:
                return unmet or [x for _, x in kept]
            kept, first = [i for i, x in after if -s.cnf.literal(x) not in model], False

    def _failing(self, known: Sequence[int], goals: Sequence[Expr], again: bool = True) -> set[int] | None:
        """A model in which one of the goals is false, or None; some of them are asked at once."""
        s = self.step
        for k in range(0, len(goals), AT_ONCE):
            question = s.any_false(goals[k : k + AT_ONCE], again)
            model = s.model(*known, question)
            s.off(question)
            if model is not None:
                return model
        return None

    def _seen(self, model: set[int], wanted: Sequence[tuple[str, Expr]], all_kept: bool) -> str:
        """What fails in a model; where all invariants hold in it, other mutants may fail there too."""
        cnf = self.step.cnf
        if all_kept:
            known = self.step.cnf.known
            self.patterns.add({str(x): cnf.literal(x) in model for x in self.patterns.leaves if known(x)})
        return next(n for n, x in wanted if -cnf.literal(x) in model)

    def _at_start(self, lines: Lines) -> AtStart:
        """The invariants that hold at the restart, and what does not hold there though it must."""
        key = (lines.start, lines.invariants, lines.at_start)
        found = self._starts.get(key)
        if found is None:
            found = self._starts[key] = self._asked_at_start(lines)
        return found

    def _asked_at_start(self, lines: Lines) -> AtStart:
        s = self.start
        known = [s.fact(x) for x in lines.start]
        if s.model(*known) is None:
            return [], "the restart states contradict each other"
        unmet = next((n for n, x in lines.at_start if s.model(*known, s.any_false((x,), again=True)) is not None), "")
        kept = list(lines.invariants)
        while True:
            lost = s.any_false((x for _, x in kept), again=len(kept) == len(lines.invariants))
            model = s.model(*known, lost)
            s.off(lost)
            if model is None:
                return kept, unmet
            kept = [i for i in kept if -s.cnf.literal(i[1]) not in model]


def _failed(what: str) -> Verdict:
    return Verdict(Fate.FUNCTION if what.startswith("F-") else Fate.CLAIM, what)


def judged(layout: Layout, controller: Controller, those: Sequence[Mutation]) -> list[Verdict]:
    """The fates of some mutants of a controller."""
    judge = Judge(layout, controller)
    return [judge.judge(m) for m in those]
