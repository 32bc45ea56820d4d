"""Requests (R14, R18): by hand, noted for a voyage, or automatic; one is taken in a scan.

REQ carries the number of a route, 0 for none; LREQ the same from a place on the spot.  VOY notes the routes of a
voyage; N stays until its route is granted or cancelled.  A ring of bits T, one of them set, offers the noted routes one
after the other: no more than one request in a scan, and none waits for ever behind another.  Where noted routes have
classes of priority: NT noted; WT could be granted besides; PC one of a class waits; PW a class has waited long enough.
"""

from __future__ import annotations

from interlock.logic.controller import Input, Join, Term, asked_of
from interlock.logic.expr import FALSE, TRUE, Expr, conj, disj, eq, neg, var
from interlock.logic.lower.draft import Draft
from interlock.model.elements import SectionId
from interlock.model.portable import portable
from interlock.model.principles import Local
from interlock.table.rows import RouteRow, VoyageRow

REQUEST, LOCAL = "REQ", "LREQ"


def asked(d: Draft, number: int) -> Expr:
    """A route number (0: none) is asked for by hand; of two requests in one scan the principle takes one."""
    order = {Local.NONE: (REQUEST,), Local.FIRST: (LOCAL, REQUEST), Local.LAST: (REQUEST, LOCAL)}
    return asked_of(order[d.layout.principles.local_requests], number)


def inputs(d: Draft) -> None:
    """Route request, voyage, automatic working."""
    swings = "".join(f"; {d.swing_number(g)} = swing the overlap of {g}" for g in d.swinging)
    d.inputs.append(Input(REQUEST, f"operator: set route number, 0 = none{swings}", size=d.requests))
    if d.layout.principles.local_requests is not Local.NONE:
        note = f"operator on the spot: set route number, 0 = none{swings}"
        d.inputs.append(Input(LOCAL, note, size=d.requests))
    if d.table.voyages:
        d.inputs.append(Input("VOY", "operator: voyage number, 0 = none", size=len(d.table.voyages) + 1))
    for r in d.table.routes:
        if r.id in d.table.automatic:
            d.inputs.append(Input(f"AUTO_R{r.number}", f"operator: route {r.id} is set again after every train"))


def requested(d: Draft, r: RouteRow) -> Expr:
    """The route is asked for in this scan."""
    return var(f"RQ_R{r.number}") if r.id in d.noted_ids else asked(d, r.number)


def offers(d: Draft) -> None:
    """The request that is taken: by hand, or the noted one whose turn it is."""
    classes = sorted({c for _, c in d.table.priority})
    of_class = dict(d.table.priority)
    wants: dict[int, Expr] = {}
    for r in d.noted:
        k = r.number
        mine = [v for v in d.table.voyages if r.id in v.routes]
        wanted = []
        if mine:
            waits = [x for v in mine for x in (*_nearer(d, v, r), *_against(d, v, r))]
            wanted.append(conj((var(f"N_R{k}"), *waits)))
        if r.id in d.table.automatic:
            wanted.append(var(f"AUTO_R{k}"))
        wants[k] = disj(wanted)
        if classes:
            wants[k] = d.wire(f"NT_R{k}", Join.ANY, [Term(x, "noted") for x in wanted], f"route {r.id}")
            could = [Term(wants[k], "noted"), Term(var(f"AD_R{k}"), "could be granted")]
            d.wire(f"WT_R{k}", Join.ALL, could, f"route {r.id}", f"route {r.id} is noted and could be set")
    held = _held_back(d, classes)
    for r in d.noted:
        k = r.number
        first = neg(held[of_class[r.id]]) if classes else TRUE
        turn = conj((asked(d, 0), var(f"T_R{k}"), wants[k], first))
        terms = (Term(asked(d, k), "by hand"), Term(turn, "noted", "its turn, while nothing is asked for by hand"))
        d.wire(f"RQ_R{k}", Join.ANY, terms, f"route {r.id}", f"route {r.id} is asked for (R14, R18)")


def _held_back(d: Draft, classes: list[int]) -> dict[int, Expr]:
    """For each class of priority: another waits that comes before it (R14).

    An earlier class comes first, but one that has waited long enough comes before those.
    """
    waits: dict[int, Expr] = {}
    aged: dict[int, Expr] = dict.fromkeys(classes, FALSE)
    seconds = d.layout.principles.priority_wait_s
    for c in classes:
        terms = [Term(var(f"WT_R{n}"), "waits") for n in _of_class(d, c)]
        waits[c] = d.wire(f"PC_{c}", Join.ANY, terms, "priority", f"a route of class {c} waits that could be set")
    for c in classes[1:] if seconds else ():
        terms = [
            Term(disj(var(f"NT_R{n}") for n in _of_class(d, c)), "noted"),
            Term(neg(var(f"PG_{c}")), "none granted in the last scan"),
        ]
        d.wire(f"PWI_{c}", Join.ALL, terms, "priority", f"class {c} has been waiting")
    for c in classes[1:] if seconds else ():
        aged[c] = d.timer(f"PW_{c}", f"PWI_{c}", seconds, f"class {c} has waited long enough (R14)")
    return {
        c: disj(
            [
                conj((neg(aged[c]), disj(waits[k] for k in classes if k < c))),
                *(conj((aged[k], waits[k])) for k in classes if k > c),
            ]
        )
        for c in classes
    }


def _of_class(d: Draft, c: int) -> list[int]:
    return [d.table.route[i].number for i, k in d.table.priority if k == c]


def _nearer(d: Draft, v: VoyageRow, r: RouteRow) -> list[Expr]:
    """A combined route is set from its far end: the next one is no longer noted."""
    i = v.routes.index(r.id)
    if not v.far_first or i + 1 == len(v.routes):
        return []
    return [neg(var(f"N_R{d.table.route[v.routes[i + 1]].number}"))]


def _against(d: Draft, v: VoyageRow, r: RouteRow) -> list[Expr]:
    """Any part of a single line only while nothing in it is locked for an opposing voyage: the first one has it all."""
    by_name = {w.name: w for w in d.table.voyages}
    own = {k for i in v.routes for k in d.table.route[i].traversals}
    out: list[Expr] = []
    for m in v.meetings:
        single: set[SectionId] = set(m.sections)
        if single.isdisjoint(r.section_ids):
            continue
        keys = {k for i in by_name[m.voyage].routes for k in d.table.route[i].traversals if k[0] in single}
        out += [neg(d.lock(*k)) for k in sorted(keys - own)]
    return out


def keep(d: Draft) -> None:
    """Next values of the notes and of the ring."""
    for i, r in enumerate(d.noted):
        k = r.number
        asked = [eq("VOY", v.number) for v in d.table.voyages if r.id in v.routes]
        if asked:
            d.kept(
                f"N_R{k}",
                False,
                f"route {r.id} is noted",
                Join.ALL,
                (
                    Term(disj((var(f"N_R{k}"), *asked)), "noted"),
                    Term(neg(var(f"G_R{k}")), "not granted"),
                    Term(neg(var(f"CAN_{portable(r.entry)}")), "not cancelled"),
                ),
                f"route {r.id}",
            )
        before = d.noted[i - 1].number
        turn = Term(var(f"T_R{before}"), "turn", "after the one before")
        d.kept(f"T_R{k}", i == 0, f"it is the turn of route {r.id}", Join.ALL, (turn,), f"route {r.id}")
    for c in sorted({k for _, k in d.table.priority})[1:] if d.layout.principles.priority_wait_s else ():
        terms = [Term(var(f"G_R{n}"), "granted") for n in _of_class(d, c)]
        d.kept(f"PG_{c}", False, f"a route of class {c} was granted in the last scan", Join.ANY, terms, "priority")
