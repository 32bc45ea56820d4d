"""What the audit sees of voyages: that each is a chain of routes, and whom it meets."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

from interlock.audit.walk import Move, Trip
from interlock.model.layout import Layout
from interlock.table.rows import InterlockingTable


def voyages(layout: Layout, table: InterlockingTable, matched: dict[str, Trip]) -> Iterator[tuple[str, str]]:
    """Each voyage is a chain from its entry to its exit; whom it meets head-on is seen from the moves of both.

    What is wrong: the name of the voyage, and a sentence.
    """
    moves: dict[str, list[Move]] = {}
    for v in layout.declared.voyages:
        row = next((x for x in table.voyages if x.name == v.name), None)
        chain = [matched[r] for r in row.routes if r in matched] if row is not None else []
        if row is None or len(chain) != len(row.routes):
            yield v.name, "its routes are not those of the layout"
            continue
        joined = all(a.exit == b.entry for a, b in pairwise(chain))
        ends = chain[0].entry == v.entry and v.exit in (chain[-1].exit, chain[-1].sections[-1])
        over = [s for t in chain for s in t.sections]
        if not (joined and ends and set(v.via) <= set(over) and len(set(over)) == len(over)):
            yield v.name, f"the routes do not lead from {v.entry} to {v.exit}"
        if any(t.shunt != v.shunt for t in chain):
            yield v.name, "a route is of another kind"
        moves[v.name] = [m for t in chain for m in t.moves]
    for row in table.voyages:
        back = {(m.edge, layout.track.far(m.edge, m.node)): m.edge for m in moves.get(row.name, ())}
        met = {
            name: {layout.track.section_of(back[m.edge, m.node]) for m in theirs if (m.edge, m.node) in back}
            for name, theirs in moves.items()
            if name != row.name
        }
        listed = {m.voyage: set(m.sections) for m in row.meetings}
        for name, sections in met.items():
            if not sections <= {s for m in row.meetings if m.voyage == name for s in m.sections}:
                yield row.name, f"meets {name} in {', '.join(sorted(sections))}"
        for name in listed:
            if not met.get(name):
                yield row.name, f"does not meet {name}"
