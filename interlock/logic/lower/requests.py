"""Requests (R14): by hand, on the spot, or automatic; one is taken in a scan.

REQ carries the number of a route, 0 for none; LREQ the same from a place on the spot.  A number counts in the one scan
in which it comes after 0: a panel that holds it asks once, and one that holds it at power-up not at all.  YRQ tells the
panel that a number is seen, and that it may go back to 0 (RQZ: 0 was read in the last scan).  RQ: a route that works
automatically is asked for, by its number or by its switch.
"""

from __future__ import annotations

from interlock.logic import names, rules
from interlock.logic.controller import Input, Join, Output, Term
from interlock.logic.expr import Expr, conj, eq, neg, var
from interlock.logic.lower.draft import Draft
from interlock.logic.symbols import asked_of
from interlock.model.principles import Local
from interlock.table.rows import RouteRow

REQUEST, LOCAL = names.REQUEST, names.LOCAL_REQUEST
FRESH = {REQUEST: names.REQUEST_FRESH, LOCAL: names.LOCAL_FRESH}
SEEN = {REQUEST: names.REQUEST_SEEN, LOCAL: names.LOCAL_SEEN}


def asked(d: Draft, number: int) -> Expr:
    """A route number (0: none) is newly asked for by hand; of two requests in one scan the principle takes one."""
    order = {Local.NONE: (REQUEST,), Local.FIRST: (LOCAL, REQUEST), Local.LAST: (REQUEST, LOCAL)}
    return asked_of(order[d.layout.principles.local_requests], number, FRESH)


def inputs(d: Draft) -> None:
    """Route requests, automatic working."""
    swings = "".join(f"; {d.overlaps.swing_number(g)} = swing the overlap of {g}" for g in d.overlaps.swinging)
    d.inputs.append(Input(REQUEST, f"operator: set route number, 0 = none{swings}", size=d.overlaps.requests))
    if d.layout.principles.local_requests is not Local.NONE:
        note = f"operator on the spot: set route number, 0 = none{swings}"
        d.inputs.append(Input(LOCAL, note, size=d.overlaps.requests))
    for r in d.routes.automatic:
        d.inputs.append(Input(switch(r), f"operator: route {r.id} is set again after every train"))


def switch(r: RouteRow) -> names.Name:
    """The operator's switch for automatic working of a route."""
    return names.AUTOMATIC(r.number)


def requested(d: Draft, r: RouteRow) -> Expr:
    """The route is asked for in this scan.

    By its switch only while nothing is asked for by hand, and in a scan that has granted no automatic route before it:
    two grants in one scan could want the same ground.
    """
    by_hand = asked(d, r.number)
    if r not in d.routes.automatic:
        return by_hand
    before = d.routes.automatic[: d.routes.automatic.index(r)]
    turn = conj((asked(d, 0), var(switch(r)), *(neg(var(names.GRANTED(x.number))) for x in before)))
    terms = (Term(by_hand, "by hand"), Term(turn, "switched on", "automatic, while nothing is asked for by hand"))
    return d.wire(
        names.ASKED(r.number),
        Join.ANY,
        terms,
        f"route {r.id}",
        f"route {r.id} is asked for ({rules.ONE_TRAIN_ONE_ROUTE})",
    )


def inputs_of(d: Draft) -> tuple[names.Name, ...]:
    """The inputs that carry a number of what is asked for."""
    return (REQUEST,) if d.layout.principles.local_requests is Local.NONE else (REQUEST, LOCAL)


def keep(d: Draft) -> None:
    """Next values of what was read last."""
    for x in inputs_of(d):
        quiet = (Term(var(names.VALID), "inputs valid"), Term(eq(x, 0), "nothing asked"))
        d.kept(FRESH[x], False, f"{x} read 0 in the last scan", Join.ALL, quiet, "requests")
        d.outputs.append(Output(SEEN[x], neg(var(FRESH[x])), True, f"acknowledge: {x} is seen, it may go back to 0"))
