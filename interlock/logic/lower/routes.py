"""Routes and signals: request, locking, proceed, cancellation (R3, R8, R11, R14).

Per route: A active, set and not yet entered; B locked, points detected; W wanted, the signal shall open; S proceed;
H shown, the signal has been open.  Per signal: X cancelling.
Who asks for a route is in `requests`.
"""

from __future__ import annotations

from interlock.logic.controller import Input, Join, Term
from interlock.logic.expr import FALSE, Expr, conj, disj, eq, neg, var
from interlock.logic.lower import aspects, requests
from interlock.logic.lower.draft import Draft
from interlock.model.elements import SectionId
from interlock.model.portable import portable
from interlock.table.rows import RouteKind, RouteRow


def inputs(d: Draft) -> None:
    """Route request, cancellations and external conditions."""
    d.inputs.append(Input("VALID", "all input devices healthy"))
    for g in d.layout.signals:
        d.inputs.append(Input(f"CAN_{portable(g.id)}", f"operator: cancel the route from {g.id}"))
    if d.layout.principles.lamp_proof:
        for g in d.layout.signals:
            d.inputs.append(Input(f"RL_{portable(g.id)}", f"stop lamp of {g.id} intact"))
        for lit in d.open_for_trains:
            d.inputs.append(Input(f"GL_{portable(lit)}", f"clear lamp of {lit} intact, or not lit"))
            if aspects.cautions(d):
                d.inputs.append(Input(f"CL_{portable(lit)}", f"caution lamp of {lit} intact, or not lit"))
    for c in d.layout.conditions:
        d.inputs.append(Input(f"E_{portable(c.id)}", f"external condition {c.id}: {c.text or 'holds'}"))


def _clear_terms(d: Draft, r: RouteRow) -> list[Term]:
    out = [Term(neg(d.occupied(c.section)), "section clear", f"{c.section} clear") for c in r.sections]
    for s, _ in r.overlap.ways if r.overlap else ():
        out.append(Term(neg(d.occupied(s)), "overlap clear", f"{s} clear: overlap"))
    for c in r.foul:
        clear = neg(d.occupied(c.section))
        if c.when is not None:
            clear = disj((clear, d.detected(c.when[0], c.when[1].other)))
        out.append(Term(clear, "foul section clear", c.because.text))
    return out


def _berth_terms(d: Draft, r: RouteRow) -> list[Term]:
    """Vehicles may stand in the berth, but no train is about to come in, nor another shunting movement (R2, R6.6)."""
    if r.berth is None:
        return []
    s = r.berth
    into = r.traversals[-1]
    entry = d.table.lock[into].entry
    out = [Term(neg(d.train(s)), "no train into the berth", f"{s} is not locked for a train")]
    out += [Term(neg(d.overlap(o)), "no overlap in the berth", f"no overlap of {o[0]}") for o in d.overlaps_over(s)]
    for node in d.topo.ends[s]:
        rear = d.topo.beyond(s, node)
        if node == entry:
            continue
        if d.signal_at(s, node) is not None:
            waits = disj((neg(var(f"U_{portable(s)}")), d.occupied(d.rear(s, node))))
            coming = conj((d.locked_in(s, node), waits))
        else:
            coming = FALSE if rear is None else d.locked_out(rear, node)
        if coming is not FALSE:
            out.append(Term(neg(coming), "no other movement into the berth", f"nothing is set into {s} at {node}"))
    return out


def _block_terms(d: Draft, r: RouteRow) -> list[Term]:
    return [Term(neg(var(f"BLK_{portable(s)}")), "not blocked", f"{s} not blocked") for s in r.section_ids]


def _detection_terms(d: Draft, r: RouteRow) -> list[Term]:
    return [
        Term(
            d.detected(p.machine, p.position), f"{p.role} point detected", f"{p.machine} {p.position}: {p.because.text}"
        )
        for p in r.points
    ]


def _free(d: Draft, r: RouteRow, s: SectionId, n: int) -> Expr:
    """A section is free for a route; the overlap of its own entry signal over the same way is no hindrance (R4)."""
    own = [o for o in d.overlaps_over(s) if o[0] == r.entry and (s, n) in d.overlaps[o]]
    if not own or r.kind is RouteKind.SHUNT:
        return var(f"FREE_{portable(s)}")
    others = [neg(d.overlap(o)) for o in d.overlaps_over(s) if o not in own]
    return conj([neg(var(f"K_{portable(s)}")), *(neg(d.lock(*t.key)) for t in d.locks_of[s]), *others])


def _overlap_terms(d: Draft, r: RouteRow) -> list[Term]:
    """The overlap is free, or lies over the route that is already set onward from the exit signal (R4)."""
    out = []
    for s, n in r.overlap.ways if r.overlap else ():
        onward = disj(
            var(f"A_R{t.number}")
            for t in d.routes_over.get((s, n), ())
            if r.overlap and t.entry == r.overlap.signal and t.kind is RouteKind.MAIN
        )
        terms = [neg(var(f"K_{portable(s)}")), *(neg(d.overlap(o)) for o in d.overlaps_over(s))]
        for t in d.locks_of[s]:
            lock = neg(d.lock(*t.key))
            terms.append(disj((lock, onward)) if t.key == (s, n) else lock)
        out.append(Term(conj(terms), "overlap free", f"{s} free as overlap of {r.exit}"))
    return out


def _trailed_terms(d: Draft, r: RouteRow) -> list[Term]:
    """A trailed point is not used before somebody has looked at it (R10)."""
    machines = dict.fromkeys(p.machine for p in r.points if p.machine in d.powered)
    return [Term(neg(var(f"TR_{portable(m)}")), "not trailed", f"{m} was not trailed") for m in machines]


def grants(d: Draft) -> None:
    """A route is granted when everything it needs is free (R6, R3)."""
    for r in d.table.routes:
        terms = [Term(requests.requested(d, r), "requested"), Term(var("VALID"), "inputs valid")]
        for s, n in r.locked:
            terms.append(Term(_free(d, r, s, n), "section free", f"{s} not locked"))
        terms += _overlap_terms(d, r)
        terms += _berth_terms(d, r)
        terms += _clear_terms(d, r)
        terms += _block_terms(d, r)
        for key in (*r.traversals, *(r.overlap.ways if r.overlap else ())):
            for ex in d.table.lock[key].exclusions:
                if ex.section not in d.sections:
                    continue
                if ex.whole:
                    held = neg(var(f"FREE_{portable(ex.section)}"))
                else:
                    held = disj([*(d.holding((ex.section, n)) for n in ex.numbers), var(f"K_{portable(ex.section)}")])
                terms.append(Term(neg(held), "exclusion", f"{ex.section}: {ex.because.text}"))
        for p in r.points:
            terms.append(
                Term(
                    var(f"AV{p.position}_{portable(p.machine)}"),
                    f"{p.role} point available",
                    f"{p.machine} {p.position}: {p.because.text}",
                )
            )
        terms += _trailed_terms(d, r)
        d.wire(f"G_R{r.number}", Join.ALL, terms, f"route {r.id}", f"grant of route {r.id} (R6)")


def locking(d: Draft) -> None:
    """Locked firmly once all points are detected; the signal's conditions, checked in every scan (R3)."""
    for r in d.table.routes:
        g = portable(r.entry)
        group = f"route {r.id}"
        first = portable(r.section_ids[0])
        d.wire(
            f"LK_R{r.number}",
            Join.ALL,
            (
                Term(var(f"A_R{r.number}"), "active"),
                Term(neg(var(f"B_R{r.number}")), "not locked yet"),
                Term(var("VALID"), "inputs valid"),
                Term(neg(var(f"X_{g}")), "not cancelling"),
                Term(neg(var(f"CAN_{g}")), "not cancelled"),
                *_clear_terms(d, r),
                *_detection_terms(d, r),
            ),
            group,
            f"route {r.id} becomes locked (R3)",
        )
        d.wire(
            f"CO_R{r.number}",
            Join.ALL,
            (
                Term(var("VALID"), "inputs valid"),
                *_clear_terms(d, r),
                *_block_terms(d, r),
                *_detection_terms(d, r),
                *_trailed_terms(d, r),
                *(Term(var(f"E_{portable(c.condition)}"), "condition", c.because.text) for c in r.conditions),
                *(Term(neg(d.occupied(b.section)), "line beyond clear", b.because.text) for b in r.block),
                Term(neg(var(f"D_{first}")), "inputs never lost"),
                *aspects.lamp_terms(d, r),
                *(
                    [Term(d.overlap((r.overlap.signal, r.overlap.option)), "overlap held", r.overlap.because.text)]
                    if r.overlap
                    else []
                ),
            ),
            group,
            f"conditions of proceed for route {r.id} (R3)",
        )


def cancellation(d: Draft) -> None:
    """Cancel: at once while nobody has seen the signal or the approach is clear, else after the delay (R8)."""
    signals = [g for g in d.layout.signals if d.routes_from[g.id]]
    seconds = {g.id: d.routes_from[g.id][0].approach.delay_s for g in signals}
    for g in signals:
        n = portable(g.id)
        first = d.first_section(g.id)
        f = portable(first)
        leaving = disj(
            d.lock(*t.key) if t.exit in d.layout.boundary_at else d.into_berth(t)
            for t in d.locks_of[first]
            if t.entry == g.node
        )
        waiting = conj(
            (
                neg(d.any_active(g.id)),
                d.locked_in(first, g.node),
                disj((var(f"REL_{f}"), conj((leaving, var(f"U_{f}"), neg(d.occupied(first)))))),
            )
        )
        d.wire(
            f"ATI_{n}",
            Join.ANY,
            (
                Term(var(f"X_{n}"), "cancelling"),
                Term(waiting, "release waits"),
            ),
            f"signal {g.id}",
            f"{g.id} at stop, waiting for a train that may still come (R8)",
        )
    for g in signals:
        n = portable(g.id)
        d.timer(f"AT_{n}", f"ATI_{n}", seconds[g.id], f"{g.id}: approach locking delay (R8)")
    for g in signals:
        n = portable(g.id)
        first = d.first_section(g.id)
        seen = disj(var(f"H_R{r.number}") for r in d.routes_from[g.id])
        d.wire(
            f"CD_{n}",
            Join.ALL,
            (
                Term(var(f"X_{n}"), "cancelling"),
                Term(d.any_active(g.id), "active"),
                Term(var("VALID"), "inputs valid"),
                Term(neg(d.occupied(first)), "section clear", f"{first} clear"),
                Term(
                    disj((d.approach_safe(g.id), neg(seen))),
                    "no train about to come",
                    "approach clear, or delay over, or the signal was never open",
                ),
            ),
            f"signal {g.id}",
            f"the route from {g.id} is cancelled (R8)",
        )


def _lamp_terms(d: Draft, r: RouteRow) -> list[Term]:
    """A signal opens only while its stop lamp is intact; an open one stays open (R11)."""
    if not d.layout.principles.lamp_proof:
        return []
    proved = disj((var(f"S_R{r.number}"), var(f"RL_{portable(r.entry)}")))
    return [Term(proved, "stop lamp proved", f"stop lamp of {r.entry} intact before it opens")]


def keep(d: Draft) -> None:
    """Next values of routes and signals."""
    for r in d.table.routes:
        k = r.number
        g = portable(r.entry)
        group = f"route {r.id}"
        first = r.section_ids[0]
        used = var(f"NU_{portable(first)}_{d.topo.ends[first].index(r.entry_node) + 1}")
        d.wire(
            f"KP_R{k}",
            Join.ALL,
            (
                Term(neg(used), "not entered", f"no train has entered {first}"),
                Term(neg(var(f"CD_{g}")), "not cancelled"),
            ),
            group,
            f"route {r.id} stays set",
        )
        stays = Term(var(f"KP_R{k}"), "stays")
        stop = (Term(neg(var(f"X_{g}")), "not cancelling"), Term(neg(var(f"CAN_{g}")), "not cancelled"))
        d.wire(
            f"PR_R{k}",
            Join.ALL,
            (
                Term(var(f"A_R{k}"), "active"),
                Term(var(f"B_R{k}"), "locked"),
                Term(var(f"W_R{k}"), "wanted"),
                Term(var(f"CO_R{k}"), "conditions"),
                stays,
                *stop,
                *_lamp_terms(d, r),
            ),
            group,
            f"proceed for route {r.id} (R3, R11)",
        )
        d.wire(
            f"LS_R{k}",
            Join.ALL,
            (
                Term(var(f"S_R{k}"), "showing"),
                Term(neg(var(f"CO_R{k}")), "conditions lost"),
            ),
            group,
            f"route {r.id}: a condition was lost; no reopening by itself (R14)",
        )
        d.kept(
            f"A_R{k}",
            False,
            f"route {r.id} active",
            Join.ALL,
            (Term(disj((var(f"A_R{k}"), var(f"G_R{k}"))), "held or granted"), stays),
            group,
        )
        d.kept(
            f"B_R{k}",
            False,
            f"route {r.id} locked",
            Join.ALL,
            (Term(disj((var(f"B_R{k}"), var(f"LK_R{k}"))), "held or locked"), stays),
            group,
        )
        again = conj((eq("REQ", k), var(f"B_R{k}")))
        d.kept(
            f"W_R{k}",
            False,
            f"route {r.id}: proceed wanted",
            Join.ALL,
            (
                Term(disj((var(f"W_R{k}"), var(f"LK_R{k}"), again)), "wanted"),
                Term(neg(var(f"LS_R{k}")), "conditions kept"),
                stays,
                *stop,
            ),
            group,
        )
        d.kept(f"S_R{k}", False, f"route {r.id}: proceed", Join.ALL, (Term(var(f"PR_R{k}"), "proceed"),), group)
        d.kept(
            f"H_R{k}",
            False,
            f"route {r.id}: signal has been open",
            Join.ALL,
            (Term(disj((var(f"H_R{k}"), var(f"PR_R{k}"))), "held or shown"), stays),
            group,
        )
    for signal in d.layout.signals:
        n = portable(signal.id)
        if not d.routes_from[signal.id]:
            continue
        d.kept(
            f"X_{n}",
            False,
            f"{signal.id}: cancelling",
            Join.ALL,
            (
                Term(disj((var(f"X_{n}"), var(f"CAN_{n}"))), "held or asked"),
                Term(d.any_active(signal.id), "active"),
                Term(neg(var(f"CD_{n}")), "not done"),
            ),
            f"signal {signal.id}",
        )
