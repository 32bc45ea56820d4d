"""Where on the railway a variable belongs, so that questions about one place can be asked one after the other.

A solver is quickest when a question is like the one before it.  Sections are numbered by a walk over the track that
goes on from a section to its neighbours before it comes back to a branch.
"""

from __future__ import annotations

from collections.abc import Mapping

from interlock.logic.controller import Symbols
from interlock.logic.plant import across, came, o, rests
from interlock.model.elements import SectionId
from interlock.model.traversal import Topology


def walked(topo: Topology) -> dict[SectionId, int]:
    """The sections in the order of the walk."""
    order: dict[SectionId, int] = {}
    for start in topo.sections:
        todo = [start]
        while todo:
            s = todo.pop()
            if s not in order:
                order[s] = len(order)
                todo += [t for j in topo.ends[s] if (t := topo.beyond(s, j)) is not None]
    return order


def places(topo: Topology, sym: Symbols, prime: str) -> Mapping[str, tuple[int, ...]]:
    """The sections of the variables of sections and routes, before and after a step, by their numbers."""
    order = walked(topo)
    found: dict[str, tuple[int, ...]] = {}
    for by_section in (sym.restart, sym.firm, sym.used, sym.passed, sym.stale, sym.train):
        found |= {name: (order[s],) for s, name in by_section.items()}
    found |= {name: (order[s],) for (s, _), name in sym.lock.items()}
    for s in topo.sections:
        events = [o(s), rests(s), *(x for j in topo.ends[s] for x in (came(s, j), across(j, s)))]
        found |= {x.name: (order[s],) for x in events} | {f"been.{s}": (order[s],)}
    for r in sym.routes:
        over = tuple(order[s] for s, _ in r.ways)
        found |= dict.fromkeys((r.active, r.locked, r.want, r.proceed, r.shown, f"shut.R{r.number}"), over)
    return found | {name + prime: over for name, over in found.items()}
