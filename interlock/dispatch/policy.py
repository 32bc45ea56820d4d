"""Who goes first on a single line that two voyages use in opposite directions (document B 2.1, figure 2-1).

Plans keep trains from blocking one another; a policy only says who waits where either could go first.  The book: when
train 2 starts and train 1 has not passed V, train 2 goes and train 1 waits before V.  It can be read in three ways:

    literal            whoever started last goes first, as long as the other is not on the line, nor set to run over it
    first_to_reach     whoever stands before the line first
    first_to_request   whoever was commanded first

Nobody waits for a train that has not come, or that could not run over the line now.
"""

from __future__ import annotations

from enum import StrEnum

from interlock.dispatch.plan.errands import Step
from interlock.dispatch.run import Run
from interlock.model.elements import SectionId


class Policy(StrEnum):
    """Readings of the rule."""

    LITERAL = "literal"
    FIRST_TO_REACH = "first_to_reach"
    FIRST_TO_REQUEST = "first_to_request"


def enters(step: Step, line: frozenset[SectionId]) -> bool:
    """A step leads onto a line."""
    return any(not line.isdisjoint(r.path.section_ids) for r in step.routes)


def past(run: Run, line: frozenset[SectionId]) -> bool:
    """A train has run over a line and does not come to it any more."""
    todo, seen = [run.place], {run.place}
    while todo:
        for step in run.journey.steps[todo.pop()]:
            if enters(step, line):
                return False
            if step.after not in seen:
                seen.add(step.after)
                todo.append(step.after)
    return not run.way.uses(line)


def yields(policy: Policy, run: Run, other: Run, order: dict[str, int]) -> bool:
    """Of two trains of which neither is on the line that they share, the first waits for the second.

    order: the place of each command among all.
    """
    line = run.lines[other.voyage]
    if policy is Policy.FIRST_TO_REQUEST:
        return order[other.name] < order[run.name]
    if policy is Policy.LITERAL:
        return other.started > run.started
    reached = any(enters(s, line) for s in other.journey.steps[other.place])
    return reached and order[other.name] < order[run.name]
