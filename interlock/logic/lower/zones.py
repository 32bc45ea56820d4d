"""Zones with a maximum of trains (R17): a route into one is granted only while fewer are in it or called into it.

Per zone k and section: ZBk the section counts, it holds a train or may; a section that is only the unused way ahead of
a lock in rear does not count beside it.  ZNk_i_j: at least j of the first i sections count.
"""

from __future__ import annotations

from interlock.diag.called import called
from interlock.logic import names
from interlock.logic.controller import Join, Output, Term
from interlock.logic.expr import FALSE, Expr, conj, disj, neg, var
from interlock.logic.lower.draft import Draft
from interlock.model.elements import SectionId, Zone
from interlock.table.rows import RouteRow


def count(d: Draft) -> None:
    """How many trains there may be in each zone."""
    for k, z in enumerate(d.layout.declared.zones, 1):
        before: list[Expr] = []
        for i, s in enumerate(z.sections, 1):
            busy = d.wire(
                names.ZONE_BUSY(z.id, k, s), Join.ANY, _busy(d, z, s), f"zone {z.id}", f"{s} counts in {z.id}"
            )
            now: list[Expr] = []
            for j in range(1, min(i, z.trains) + 1):
                fewer = before[j - 2] if j > 1 else None
                more = busy if fewer is None else conj((fewer, busy))
                terms = [Term(more, "one more")]
                if j <= len(before):
                    terms.append(Term(before[j - 1], "before it"))
                now.append(d.wire(names.ZONE_COUNT(z.id, k, i, j), Join.ANY, terms, f"zone {z.id}"))
            before = now


def _busy(d: Draft, z: Zone, s: SectionId) -> list[Term]:
    unseen = conj((neg(var(names.USED(s))), neg(var(names.STALE(s)))))
    terms = [Term(var(names.RESTART_LOCK(s)), "restart lock")]
    for t in d.sections.locks_of[s]:
        rear = d.topo.beyond(s, t.entry)
        leads = d.sections.locked_out(rear, t.entry) if rear is not None and rear in z.sections else FALSE
        terms.append(Term(conj((d.sections.lock(*t.key), neg(conj((leads, unseen))))), "locked"))
    return [*terms, *(Term(d.overlaps.held(o), "overlap") for o in d.overlaps.over(s))]


def _at_least(d: Draft, number: int, trains: int) -> Expr:
    """At least so many trains may be in a zone."""
    k, z = number, d.layout.declared.zones[number - 1]
    if trains <= 0:
        return neg(FALSE)
    return var(names.ZONE_COUNT(z.id, k, len(z.sections), trains)) if trains <= len(z.sections) else FALSE


def terms(d: Draft, r: RouteRow) -> list[Term]:
    """There is room in every zone into which the route leads."""
    out = []
    number = {z.id: k for k, z in enumerate(d.layout.declared.zones, 1)}
    for c in r.conditions.zones:
        z = d.layout.declared.zones[number[c.zone] - 1]
        full = _at_least(d, number[c.zone], z.trains - c.entries + 1)
        out.append(Term(neg(full), "zone not full", c.because.text, c.because.rule))
    return out


def outputs(d: Draft) -> None:
    """Full zones are shown, a scan late."""
    for k, z in enumerate(d.layout.declared.zones, 1):
        name = names.ZONE_FULL(z.id)
        full = [Term(_at_least(d, k, z.trains), "full")]
        d.kept(name, True, f"{called('zone', z.id)} is full", Join.ALL, full, f"zone {z.id}")
        d.outputs.append(
            Output(names.ZONE_FULL_SHOWN(z.id), disj((var(name),)), True, f"indication: {called('zone', z.id)} is full")
        )
