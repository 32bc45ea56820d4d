"""Overlaps (R4): how long one is held, and when the train before its signal stands.

V one bit for each alternative of a signal; VF firm, the route that holds it is locked and its points are detected.
What an overlap must find free is in `routes`, with everything else that a grant needs.
"""

from __future__ import annotations

from interlock.logic.controller import Join, Term
from interlock.logic.expr import conj, disj, neg, var
from interlock.logic.lower import sections
from interlock.logic.lower.draft import Draft
from interlock.model.portable import portable


def standing(d: Draft) -> None:
    """Overlaps are held until no route leads to their signal, or the train before it stands (R4)."""
    signals = sorted({g for g, _ in d.overlaps})
    for g in signals:
        n, b = portable(g), d.before(g)
        node = d.layout.signal[g].node
        to = d.locked_out(b, node)
        terms = [
            *sections.arrived(d, b),
            Term(to, "locked towards it", f"{b} is locked towards {g}"),
            Term(d.occupied(b), "occupied", f"{b} occupied"),
        ]
        d.wire(f"OTI_{n}", Join.ALL, terms, f"overlap {g}", f"the train before {g} is wholly in {b} (R4)")
    for g in signals:
        seconds = d.layout.principles.overlap_release_s
        d.timer(f"OT_{portable(g)}", f"OTI_{portable(g)}", seconds, f"{g}: the train before it stands (R4)")
    for g in signals:
        n, b = portable(g), d.before(g)
        to = d.locked_out(b, d.layout.signal[g].node)
        terms = [Term(neg(to), "no route to it", f"{b} not locked towards {g}"), Term(var(f"OT_{n}"), "train stands")]
        d.wire(f"OR_{n}", Join.ANY, terms, f"overlap {g}", f"the overlap of {g} is not needed any more (R4)")


def keep(d: Draft) -> None:
    """Next values of the overlaps."""
    for o, ways in d.overlaps.items():
        g, k = o
        n = portable(g)
        clear = conj(neg(d.occupied(s)) for s, _ in ways)
        stays = neg(conj((var(f"OR_{n}"), clear)))
        d.kept(
            f"V_{n}_{k}",
            False,
            f"overlap {k} of {g} held",
            Join.ANY,
            (
                Term(var(f"GO_{n}_{k}"), "granted"),
                Term(conj((d.overlap(o), stays)), "held", "until it is not needed and clear"),
            ),
            f"overlap {g}",
        )
    for g in sorted({g for g, _ in d.overlaps}):
        n = portable(g)
        users = [r for r in d.table.routes if r.overlap is not None and r.overlap.signal == g]
        any_ = disj(d.overlap(o) for o in d.overlaps if o[0] == g)
        firm = disj((var(f"VF_{n}"), *(var(f"LK_R{r.number}") for r in users)))
        d.kept(
            f"VF_{n}",
            False,
            f"overlap of {g} firmly held",
            Join.ALL,
            (Term(firm, "held or locked"), Term(any_, "some overlap held")),
            f"overlap {g}",
        )
