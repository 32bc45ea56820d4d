"""History variables of the proof: computed from the run, they influence nothing.

been.s     a train has come into s since it was locked firmly
shut.Rn    the signal has been open for route n, or its path was blocked or a point in it trailed; the route stays set,
           the signal is closed, and nobody asks for it in this step
cov.TIMER  since the timer's input rose, what the world's clock looks at has held (`clocks.py`)

**Theorem.**  A variable that nothing else reads, and that has exactly one next value in every step, changes no run of
the others and forbids none: what is proved with it of the others holds without it.  (Auxiliary variables: Owicki and
Gries, 1976; history variables: Abadi and Lamport, *The Existence of Refinement Mappings*, 1991.)
"""

from __future__ import annotations

from collections.abc import Iterable

from interlock.logic import names
from interlock.logic.expr import FALSE, Expr, conj, disj, neg, var
from interlock.logic.names import Name
from interlock.model.elements import NodeId, SectionId
from interlock.proof.system.clocks import Tie
from interlock.proof.system.loop import ClosedLoop


def history(loop: ClosedLoop, ties: Iterable[Tie]) -> dict[Name, Expr]:
    """Next values of the history variables."""
    symbols, plant = loop.controller.symbols, loop.plant
    out: dict[Name, Expr] = {}
    for r in symbols.routes:
        hindered = conj((var(r.active), neg(var(names.UNHINDERED(r.number)))))  # S-AGAIN tells what that comes to
        was_open = disj((var(names.SHUT(r.number)), var(r.proceed), var(r.shown), hindered))
        asked = FALSE if r.call_on else symbols.requests.asked_for(r, symbols.routes)
        out[names.SHUT(r.number)] = conj((was_open, neg(var(r.proceed.next)), var(r.active.next), neg(asked)))
    for s in loop.topo.sections:
        came_in = disj(plant.events.get(names.HEAD(j, _beyond(loop, s, j)), FALSE) for j in loop.topo.ends[s])
        out[names.BEEN(s)] = conj((disj((var(names.BEEN(s)), came_in)), var(symbols.sections.firm[s].next)))
    for t in ties:
        out[t.covered] = disj((neg(var(t.timer.input)), conj((plant.clocks[t.clock], var(t.covered)))))
    return out


def _beyond(loop: ClosedLoop, s: SectionId, j: NodeId) -> str:
    """From where a train comes in over an end of a section."""
    ahead = loop.topo.beyond(s, j)
    if ahead is not None:
        return ahead
    b = loop.layout.track.boundary_at.get(j)
    return (b.approach if b and b.approach else None) or names.outside(j)
