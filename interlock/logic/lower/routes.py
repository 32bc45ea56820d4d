"""Routes and signals: request, locking, proceed, cancellation (R3, R8, R11, R14).

Per route: A active, set and not yet entered; B locked, points detected; W wanted, the signal shall open; S proceed;
H shown, the signal has been open; PA the signal is still open for the movement that passes it.
Per signal: X cancelling.
Who asks for a route is in `requests`.

A route that leads past a signal is set with the route of kind identifier beyond it, and its signal is open only while
the passed one shows its identifier light.  That light shows first while such a route is set, and from then on while the
section before the signal is firmly locked towards it: for the train that is on its way.
"""

from __future__ import annotations

from collections.abc import Iterator

from interlock.diag.called import called
from interlock.logic import names, rules
from interlock.logic.controller import Input, Join, Term
from interlock.logic.expr import FALSE, Expr, conj, disj, neg, var
from interlock.logic.lower import added, aspects, block, come_in, requests, sections, ways, zones
from interlock.logic.lower.draft import Draft
from interlock.model.elements import Position, Signal, SignalId
from interlock.table.cells import RouteKind
from interlock.table.rows import RouteRow


def inputs(d: Draft) -> None:
    """Route request, cancellations and external conditions."""
    d.inputs.append(Input(names.VALID, "all input devices healthy"))
    for g in d.layout.signalling.signals:
        d.inputs.append(Input(names.CANCEL(g.id), f"operator: cancel the route from {g.id}"))
    if d.layout.principles.lamp_proof:
        for g in d.layout.signalling.signals:
            d.inputs.append(Input(names.STOP_LAMP(g.id), f"stop lamp of {g.id} intact"))
        for lit in d.routes.open_for_trains:
            d.inputs.append(Input(names.CLEAR_LAMP(lit), f"clear lamp of {lit} intact, or not lit"))
            if aspects.cautions(d):
                d.inputs.append(Input(names.CAUTION_LAMP(lit), f"caution lamp of {lit} intact, or not lit"))
        for passed in filter(d.routes.identifies, d.routes.of_signal):
            d.inputs.append(Input(names.IDENTIFIER_LAMP(passed), f"identifier lamp of {passed} intact, or not lit"))
        for yellow in aspects.two_yellows(d):
            d.inputs.append(Input(names.SECOND_LAMP(yellow), f"second yellow lamp of {yellow} intact, or not lit"))
        for told in filter(lambda g: aspects.speeds(d, g), d.routes.open_for_trains):
            d.inputs.append(Input(names.SPEED_LAMP(told), f"speed indicator of {told} intact, or not lit"))
    for c in d.layout.signalling.conditions:
        d.inputs.append(Input(names.CONDITION(c.id), f"external {called('condition', c.id)}: {c.text or 'holds'}"))


def _berth_terms(d: Draft, r: RouteRow) -> list[Term]:
    """Vehicles may stand in the berth, but no train is about to come in, nor another shunting movement (R2, R6.6)."""
    if r.path.berth is None:
        return []
    s = r.path.berth
    into = r.path.traversals[-1]
    entry = d.table.lock[into].entry
    out = [*ways.not_blocked(s), *ways.available(d, into)]
    out += [Term(neg(d.sections.train(s)), "no train into the berth", f"{s} is not locked for a train")]
    out += [
        Term(neg(d.overlaps.held(o)), "no overlap in the berth", f"no overlap of {o[0]}") for o in d.overlaps.over(s)
    ]
    for node in d.topo.ends[s]:
        rear = d.topo.beyond(s, node)
        if node == entry:
            continue
        g = d.signals.signal_at(s, node)
        if g is not None:
            behind = neg(d.sections.clear(d.sections.rear(s, node)))
            waits = disj((neg(var(names.USED(s))), behind, d.signals.passing_signal(g)))
            coming = conj((d.sections.locked_in(s, node), waits))
        else:
            coming = FALSE if rear is None else d.sections.locked_out(rear, node)
        if coming is not FALSE:
            out.append(Term(neg(coming), "no other movement into the berth", f"nothing is set into {s} at {node}"))
    return out


def _needs(d: Draft, r: RouteRow) -> list[Term]:
    """Everything that a route needs to be granted but that it is asked for."""
    terms = [Term(var(names.VALID), "inputs valid")]
    for key in r.path.locked:
        terms += ways.free_terms(d, r, key)
    terms += [*_rear_terms(d, r), *ways.overlap_terms(d, r), *_berth_terms(d, r), *zones.terms(d, r)]
    return [*terms, *added.free(d, r)]


def grants(d: Draft) -> None:
    """A route is granted when everything it needs is free (R6, R3); automatic ones in the order of their classes."""
    own = [r for r in d.table.routes if r.kind is not RouteKind.IDENTIFIER]
    by_hand = [r for r in own if r not in d.routes.automatic]
    for r in [*d.routes.automatic, *by_hand]:
        beyond = [t for p in d.routes.onward(r) for t in _needs(d, p)]
        terms = [Term(requests.requested(d, r), "requested"), *_needs(d, r), *beyond]
        terms = list({t.expr: t for t in reversed(terms)}.values())[::-1] if beyond else terms
        d.wire(
            names.GRANTED(r.number), Join.ALL, terms, f"route {r.id}", f"grant of route {r.id} ({rules.HOSTILE_ROUTES})"
        )
    for r in sorted(d.table.routes, key=lambda r: -len(r.path.passed or ())):
        if r.kind is RouteKind.IDENTIFIER:  # what leads over it is before it
            with_ = [Term(var(names.GRANTED(x.number)), "requested", f"route {x.id}") for x in d.routes.leading_past(r)]
            d.wire(names.GRANTED(r.number), Join.ANY, with_, f"route {r.id}", f"grant of route {r.id}, with another")


def locking(d: Draft) -> None:
    """Locked firmly once all points are detected; the signal's conditions, checked in every scan (R3)."""
    for r in d.table.routes:
        group = f"route {r.id}"
        d.wire(
            names.LOCKS(r.number),
            Join.ALL,
            (
                Term(var(names.ACTIVE(r.number)), "active"),
                Term(neg(var(names.LOCKED(r.number))), "not locked yet"),
                Term(var(names.VALID), "inputs valid"),
                Term(neg(var(names.CANCELLING(r.entry))), "not cancelling"),
                Term(neg(var(names.CANCEL(r.entry))), "not cancelled"),
                *(Term(neg(_withdrawn(x)), "not cancelled", f"{x.id} is not cancelled") for x in d.routes.set_with(r)),
                *ways.lying_terms(d, r),
                *added.detected(d, r),
            ),
            group,
            f"route {r.id} becomes locked ({rules.PROCEED})",
        )
        d.wire(
            names.CONDITIONS(r.number),
            Join.ALL,
            (
                Term(var(names.VALID), "inputs valid"),
                *ways.proceed_terms(d, r),
                *_beside(d, r),
            ),
            group,
            f"conditions of proceed for route {r.id} ({rules.PROCEED})",
        )


def _rear_terms(d: Draft, r: RouteRow) -> list[Term]:
    """No train is called from a section in which it may have stood since the restart on points that lie anyhow, or on
    a crossing or bridge that is open (R9, R16): such a train is moved under local rules."""
    rear = d.topo.beyond(r.path.section_ids[0], r.path.entry_node)
    if rear is None:
        return []
    released = neg(var(names.RESTART_LOCK(rear)))
    out = []
    if any(t.points or t.crossings for t in d.topo.traversals[rear]):
        out.append(Term(released, "rear released", f"{rear}, with points or a diamond, is released after the restart"))
    for device in d.layout.signalling.devices:
        if rear in device.over:
            closed = d.machines.detected(device.id, Position.REVERSE)
            lies = d.layout.machines.word(device.id, Position.REVERSE)
            out.append(Term(disj((released, closed)), "rear device closed", f"{device.id} over {rear} is {lies}"))
    beyond = {d.topo.beyond(rear, node) for node in d.topo.ends[rear] if node != r.path.entry_node}
    for other in sorted({*(s for s in beyond if s is not None), *d.sections.foul_of.get(rear, ())}):
        alone = disj((released, neg(var(names.RESTART_LOCK(other))), d.sections.clear(other)))
        out.append(
            Term(
                alone,
                "stands alone",
                f"{other} clear, or released since the restart: whoever stands there too is moved under local rules",
            )
        )
    return out


def _beside(d: Draft, r: RouteRow) -> list[Term]:
    """What proceed needs besides the ways themselves."""
    terms = _rear_terms(d, r)
    terms += [
        Term(var(names.CONDITION(c.condition)), "condition", c.because.text, c.because.rule)
        for c in r.conditions.external
    ]
    terms += [
        Term(d.sections.clear(b.section), "line beyond clear", b.because.text, b.because.rule)
        for b in r.conditions.block
    ]
    terms += block.terms(d, r)
    terms += [*added.detected(d, r), *added.clear(d, r)]
    if r.kind is not RouteKind.CALL_ON:
        terms.append(Term(neg(var(names.STALE(r.path.section_ids[0]))), "inputs never lost"))
    terms += aspects.lamp_terms(d, r)
    if r.locking.overlap:
        some = {r.locking.overlap.option, *r.locking.overlap.swings}
        options = disj(d.overlaps.held(o) for o in d.overlaps.of_signal[r.locking.overlap.signal] if o[1] in some)
        terms.append(Term(options, "overlap held", r.locking.overlap.because.text, r.locking.overlap.because.rule))
    return terms


def approaches(d: Draft) -> None:
    """Whether a train may be on its way to a signal, where more than one section tells (R8)."""
    for g in d.layout.signalling.signals:
        if d.routes.of_signal[g.id] and (x := (cell := d.routes.of_signal[g.id][0].locking.approach).coming).further:
            rule = cell.because.rule
            nobody = (Term(neg(d.signals.coming(x)), "nobody comes", "nothing in the approach, nor called into it"),)
            d.wire(
                names.APPROACH_CLEAR(g.id),
                Join.ALL,
                nobody,
                f"signal {g.id}",
                f"no train is on its way to {g.id} ({rule})",
            )


def _release_waits(d: Draft, g: Signal) -> Expr:
    """What is locked behind a signal is to be released, by hand or behind what has come in, while another train may be
    on its way: stop stands since then, and so long the delay counts."""
    first = d.signals.first_section(g.id)
    leaving = disj(
        d.sections.lock(*t.key) if t.exit in d.layout.track.boundary_at else d.sections.into_berth(t)
        for t in d.sections.locks_of[first]
        if t.entry == g.node
    )
    begun = (*come_in.from_signals(d, first), *come_in.in_order(d, first))
    behind = disj(locked for h, locked in begun if h == g.id)
    waits = conj((behind, neg(var(names.REAR_CLEARED(first))))) if behind is not FALSE else FALSE
    return conj(
        (
            neg(d.signals.any_active(g.id)),
            neg(d.signals.passing_signal(g.id)),
            d.sections.locked_in(first, g.node),
            disj((var(names.RELEASE_BY_HAND(first)), conj((disj((leaving, waits)), var(names.USED(first)))))),
        )
    )


def cancellation(d: Draft) -> None:
    """Cancel: at once while nobody has seen the signal or the approach is clear, else after the delay (R8)."""
    signals = [g for g in d.layout.signalling.signals if d.routes.of_signal[g.id]]
    approach = {g.id: d.routes.of_signal[g.id][0].locking.approach for g in signals}
    for g in signals:
        rule = approach[g.id].because.rule
        d.wire(
            names.APPROACH_RUNS(g.id),
            Join.ANY,
            (
                Term(var(names.CANCELLING(g.id)), "cancelling"),
                Term(_release_waits(d, g), "release waits"),
            ),
            f"signal {g.id}",
            f"{g.id} at stop, waiting for a train that may still come ({rule})",
        )
    for g in signals:
        rule = approach[g.id].because.rule
        d.timer(
            names.APPROACH_OVER(g.id),
            names.APPROACH_RUNS(g.id),
            approach[g.id].delay_s,
            f"{g.id}: approach locking delay ({rule})",
        )
    for g in signals:
        first = d.signals.first_section(g.id)
        rule = approach[g.id].because.rule
        seen = disj(var(names.SHOWN(r.number)) for r in d.routes.of_signal[g.id])
        d.wire(
            names.CANCELLED(g.id),
            Join.ALL,
            (
                Term(var(names.CANCELLING(g.id)), "cancelling"),
                Term(d.signals.any_active(g.id), "active"),
                Term(var(names.VALID), "inputs valid"),
                sections.long_clear(d, first),
                Term(
                    disj((d.signals.approach_safe(g.id), neg(seen))),
                    "no train about to come",
                    "approach clear, or delay over, or the signal was never open",
                ),
            ),
            f"signal {g.id}",
            f"the route from {g.id} is cancelled ({rule})",
        )


def _lamp_terms(d: Draft, r: RouteRow) -> list[Term]:
    """A signal opens only while its stop lamp is intact; an open one stays open (R11)."""
    if not d.layout.principles.lamp_proof:
        return []
    proved = disj((var(names.SHOWING(r.number)), var(names.STOP_LAMP(r.entry))))
    return [Term(proved, "stop lamp proved", f"stop lamp of {r.entry} intact before it opens")]


def _entered(d: Draft, r: RouteRow) -> Expr:
    """A train comes into the first section in this scan."""
    first = r.path.section_ids[0]
    return var(names.ENTERED(first, d.topo.ends[first].index(r.path.entry_node) + 1))


def _passing(d: Draft, r: RouteRow) -> None:
    """The signal stays open until the whole movement has passed it (R3): where the table says so."""
    whole, first = r.signal.closing.whole, r.path.section_ids[0]
    if whole is None:
        return
    name = names.PASSING(r.number)
    begins = conj((var(names.SHOWING(r.number)), _entered(d, r)))
    d.kept(
        name,
        False,
        f"route {r.id}: open for the movement that passes {r.entry}",
        Join.ALL,
        (
            Term(disj((var(name), begins)), "held or entered"),
            Term(var(names.VALID), "inputs valid"),
            Term(neg(var(names.CANCEL(r.entry))), "not cancelled"),
            Term(d.sections.occupied(whole), "still passing", f"{whole} occupied"),
            Term(d.sections.occupied(first), "first section occupied", f"{first} occupied"),
            *ways.passing_terms(d, r),
            *ways.not_swinging(d, r),
            *_beside(d, r),
            *_identifier(d, r),
        ),
        f"route {r.id}",
    )


def keep(d: Draft) -> None:
    """Next values of routes and signals."""
    for r in d.routes.parts_first:
        stays = Term(var(names.STAYS(r.number)), "stays")
        stop = (
            Term(neg(var(names.CANCELLING(r.entry))), "not cancelling"),
            Term(neg(var(names.CANCEL(r.entry))), "not cancelled"),
            *(Term(neg(_withdrawn(x)), "not cancelled", f"{x.id} is not cancelled") for x in d.routes.set_with(r)),
        )
        _opens(d, r, stays, stop)
        _keep_route(d, r, stays, stop)
    for signal in d.layout.signalling.signals:
        if d.routes.of_signal[signal.id]:
            _keep_cancelling(d, signal.id)


def _withdrawn(r: RouteRow) -> Expr:
    """A route that is set is being cancelled."""
    return conj((var(names.ACTIVE(r.number)), disj((var(names.CANCEL(r.entry)), var(names.CANCELLING(r.entry))))))


def _identifier(d: Draft, r: RouteRow) -> list[Term]:
    """The signal that a route leads past shows its identifier light."""
    return [
        Term(var(names.OPENS(x.number)), "identifier shown", f"{x.entry} shows its identifier light")
        for x in d.routes.onward(r)[:1]
    ]


def _past(d: Draft, r: RouteRow) -> list[Term]:
    """Past a signal: a route that leads past it opens while it shows its identifier light; that shows first while such
    a route is set, and then while the section before it stays firmly locked towards it."""
    shown = _identifier(d, r)
    if r.kind is not RouteKind.IDENTIFIER:
        return shown
    before = d.signals.before(r.entry)
    leads = conj((d.sections.locked_out(before, r.path.entry_node), var(names.FIRM(before)), d.sections.train(before)))
    set_ = disj((var(names.SHOWING(r.number)), *(var(names.ACTIVE(x.number)) for x in d.routes.leading_past(r))))
    return [
        *shown,
        Term(leads, "rear locked", f"{before} is firmly locked towards {r.entry}"),
        Term(neg(var(names.RELEASED(before))), "rear locked", f"{before} is not released"),
        Term(set_, "identifier wanted", f"a route past {r.entry} is set, or its train is on its way"),
    ]


def _opens(d: Draft, r: RouteRow, stays: Term, stop: tuple[Term, ...]) -> None:
    """Whether a route stays set, whether its signal opens, and whether a condition of that was lost."""
    k, group, past = r.number, f"route {r.id}", _past(d, r)
    used = _entered(d, r)
    d.wire(
        names.STAYS(k),
        Join.ALL,
        (
            Term(neg(used), "not entered", f"no train has entered {r.path.section_ids[0]}"),
            Term(neg(var(names.CANCELLED(r.entry))), "not cancelled"),
        ),
        group,
        f"route {r.id} stays set",
    )
    d.wire(
        names.OPENS(k),
        Join.ALL,
        (
            Term(var(names.ACTIVE(k)), "active"),
            Term(var(names.LOCKED(k)), "locked"),
            Term(var(names.WANTED(k)), "wanted"),
            Term(var(names.CONDITIONS(k)), "conditions"),
            stays,
            *stop,
            *_lamp_terms(d, r),
            *ways.not_swinging(d, r),
            *past,
        ),
        group,
        f"proceed for route {r.id} ({rules.PROCEED}, {rules.SIGNALS})",
    )
    needed = (*_lamp_terms(d, r), *ways.not_swinging(d, r))
    kept = conj((var(names.CONDITIONS(k)), *(t.expr for t in needed), *_kept_past(d, r, past)))
    d.wire(
        names.CONDITION_LOST(k),
        Join.ALL,
        (
            Term(var(names.SHOWN(k)), "has been open"),
            Term(neg(kept), "conditions lost"),
        ),
        group,
        f"route {r.id}: a condition is lost; no reopening by itself ({rules.ONE_TRAIN_ONE_ROUTE})",
    )


def _kept_past(d: Draft, r: RouteRow, past: list[Term]) -> Iterator[Expr]:
    """What has to be so past a signal that has been open.  In the scan in which a route is asked for again, the signal
    that it leads past may have closed: that one is asked for as well, and opens before it."""
    reopens = conj((_asked_again(d, r), *(neg(var(names.CONDITION_LOST(x.number))) for x in d.routes.onward(r)[:1])))
    for t in past:
        yield disj((t.expr, reopens)) if t.kind == "identifier shown" else t.expr


def _keep_route(d: Draft, r: RouteRow, stays: Term, stop: tuple[Term, ...]) -> None:
    """Set, locked, proceed wanted, proceed shown, proceed once shown."""
    k, group = r.number, f"route {r.id}"
    d.kept(
        names.ACTIVE(k),
        False,
        f"route {r.id} active",
        Join.ALL,
        (Term(disj((var(names.ACTIVE(k)), var(names.GRANTED(k)))), "held or granted"), stays),
        group,
    )
    d.kept(
        names.LOCKED(k),
        False,
        f"route {r.id} locked",
        Join.ALL,
        (Term(disj((var(names.LOCKED(k)), var(names.LOCKS(k)))), "held or locked"), stays),
        group,
    )
    # what calls a train on closes for good: nothing tells whether the train has passed
    again = [conj((_asked_again(d, r), var(names.ACTIVE(k))))] if r.kind is not RouteKind.CALL_ON else []
    d.kept(
        names.WANTED(k),
        False,
        f"route {r.id}: proceed wanted",
        Join.ALL,
        (
            Term(disj((var(names.WANTED(k)), var(names.GRANTED(k)), *again)), "wanted"),
            Term(neg(var(names.CONDITION_LOST(k))), "conditions kept"),
            Term(var(names.UNHINDERED(k)), "unhindered"),
            stays,
            *stop,
        ),
        group,
    )
    _passing(d, r)
    proceed = (Term(var(names.OPENS(k)), "proceed"),)
    d.kept(names.SHOWING(k), False, f"route {r.id}: proceed", Join.ALL, proceed, group)
    d.kept(
        names.SHOWN(k),
        False,
        f"route {r.id}: signal has been open",
        Join.ALL,
        (Term(disj((var(names.SHOWN(k)), var(names.OPENS(k)))), "held or shown"), stays),
        group,
    )


def _asked_again(d: Draft, r: RouteRow) -> Expr:
    """A route is asked for by its number; one of kind identifier by that of a route with which it is still set."""
    if r.kind is not RouteKind.IDENTIFIER:
        return requests.asked(d, r.number)
    return disj(conj((_asked_again(d, x), var(names.ACTIVE(x.number)))) for x in d.routes.leading_past(r))


def _keep_cancelling(d: Draft, g: SignalId) -> None:
    """A route from a signal is being cancelled."""
    withdrawn = [
        conj((var(names.ACTIVE(r.number)), _withdrawn(x))) for r in d.routes.of_signal[g] for x in d.routes.set_with(r)
    ]
    terms = (
        Term(disj((var(names.CANCELLING(g)), var(names.CANCEL(g)), *withdrawn)), "held or asked"),
        Term(d.signals.any_active(g), "active"),
        Term(neg(var(names.CANCELLED(g))), "not done"),
    )
    d.kept(names.CANCELLING(g), False, f"{g}: cancelling", Join.ALL, terms, f"signal {g}")
