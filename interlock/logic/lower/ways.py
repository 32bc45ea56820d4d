"""What a way through a section asks for: one set of wires that every route and overlap over it reads.

Per way: WA it could be locked, whatever stands in its section; WF a route may lock it now; WD its points and devices
are detected and nothing is foul of it; WL it is clear besides; WP proceed may be shown over it.  GW it is granted to
a route in this scan, GB the same for the berth of a shunting movement.  Per overlap: OF it may be held; GO it is
granted with a route.  What is always true has no wire.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from interlock.logic import names, rules
from interlock.logic.controller import Join, Term
from interlock.logic.expr import Expr, conj, disj, neg, var
from interlock.logic.lower import added
from interlock.logic.lower.draft import Draft
from interlock.model.elements import MachineId, Position, SectionId, SignalId
from interlock.table.cells import Role, RouteKind, TraversalKey
from interlock.table.rows import RouteRow, TraversalRow


def _wire(d: Draft, family: names.Family, t: TraversalRow, terms: Sequence[Term], note: str) -> None:
    if terms:
        group = f"section {t.section}"
        d.wire(family(*t.key), Join.ALL, terms, group, _way(t, note))


def _way(t: TraversalRow, note: str) -> str:
    """A way by its number: from where to where it leads is told where its lock is declared."""
    return f"way {t.key[1]} of {t.section}: {note}"


def _of_routes(d: Draft) -> set[TraversalKey]:
    """The ways that routes go through, not only overlaps, nor only as a berth."""
    return {key for r in d.table.routes for key in r.path.locked}


# --- what is looked at ---------------------------------------------------------------------------


def availability(d: Draft) -> None:
    """Whether ways can be locked (R6, R10), and whether overlaps can be held (R4)."""
    routes = _of_routes(d)
    for t in d.table.locks:
        _wire(d, names.WAY_AVAILABLE, t, _availability(d, t), "could be locked")
        free = [Term(var(names.FREE(t.section)), "section free", f"{t.section} not locked")]
        if t.key in routes:
            _wire(d, names.WAY_FREE, t, [*free, *_unlocked(d, t.key)], f"free for a route ({rules.HOSTILE_ROUTES})")
    for (g, k), over in d.overlaps.ways.items():
        terms = [x for key in over for x in _overlap_terms(d, (g, k), key)]
        d.wire(
            names.OVERLAP_FREE(g, k),
            Join.ALL,
            terms,
            f"overlap {g}",
            f"overlap {k} of {g} may be held ({rules.OVERLAPS})",
        )


def _availability(d: Draft, t: TraversalRow) -> list[Term]:
    terms = []
    for ex in t.exclusions:
        if ex.section not in d.sections.locks_of:
            continue
        if ex.whole:
            held = neg(var(names.FREE(ex.section)))
        else:
            held = disj(
                [*(d.overlaps.holding((ex.section, n)) for n in ex.numbers), var(names.RESTART_LOCK(ex.section))]
            )
        terms.append(Term(neg(held), "exclusion", f"{ex.section}: {ex.because.text}"))
    for p in t.points:
        free = var(names.POINT_AVAILABLE(p.machine, p.position))
        terms.append(
            Term(free, f"{p.role} point available", f"{p.machine} {p.position}: {p.because.text}", p.because.rule)
        )
        terms += added.others_shut(d, p.machine, p.position)
    return [*terms, *_trailed(d, t), *_foul(d, t), *_space(d, t)]


def _unlocked(d: Draft, key: TraversalKey, clear: bool = True) -> list[Term]:
    """What a route asks for besides its section being free."""
    s = key[0]
    reported = [Term(d.sections.clear(s), "section clear", f"{s} clear")] if clear else []
    return [*reported, *not_blocked(s), *available(d, key)]


def available(d: Draft, key: TraversalKey) -> list[Term]:
    """The way could be locked."""
    terms = _availability(d, d.table.lock[key])
    return [Term(var(names.WAY_AVAILABLE(*key)), "way available", f"way through {key[0]} available")] if terms else []


def not_blocked(s: SectionId) -> list[Term]:
    """Nobody has blocked the section."""
    return [Term(neg(var(names.BLOCKED(s))), "not blocked", f"{s} not blocked")]


def unblocked(d: Draft, m: MachineId) -> list[Term]:
    """Nobody has blocked a section of a point: whoever works there is not to have it move for a route elsewhere."""
    if m in d.layout.machines.device:
        return []
    return [t for s in d.machines.sections_of(m) if s in d.sections.blockable for t in not_blocked(s)]


def _trailed(d: Draft, t: TraversalRow) -> list[Term]:
    """A trailed point is not used before somebody has looked at it (R10)."""
    machines = dict.fromkeys(p.machine for p in t.points if p.machine in d.machines.powered)
    return [Term(neg(var(names.TRAILED(m))), "not trailed", f"{m} was not trailed") for m in machines]


def _foul(d: Draft, t: TraversalRow) -> list[Term]:
    out = []
    for c in t.foul:
        clear = d.sections.clear(c.section)
        if c.when is not None:
            clear = disj((clear, d.machines.detected(c.when[0], c.when[1].other)))
        out.append(Term(clear, "foul section clear", c.because.text, c.because.rule))
    return out


def _space(d: Draft, t: TraversalRow) -> list[Term]:
    """The flank space is clear, and protecting signals show stop, where the principles ask for it (R5)."""
    out = []
    for c in t.space:
        if c.lamp:
            out.append(Term(var(names.STOP_LAMP(c.name)), "flank lamp intact", c.because.text, c.because.rule))
        else:
            out.append(Term(d.sections.clear(SectionId(c.name)), "flank space clear", c.because.text, c.because.rule))
    return out


def _overlap_terms(d: Draft, option: tuple[SignalId, int], key: TraversalKey) -> list[Term]:
    """The overlap's way is free, or lies over the route that is already set onward from the signal, or from one past
    which the overlap leads, and with the overlap of such a one (R4)."""
    s, g = key[0], option[0]
    onward = disj(var(names.ACTIVE(r.number)) for r in d.routes.over.get(key, ()) if option in _held_under(d, r, key))
    free = [neg(var(names.RESTART_LOCK(s))), *(neg(d.overlaps.held(o)) for o in d.overlaps.apart_from(option, s))]
    for t in d.sections.locks_of[s]:
        lock = neg(d.sections.lock(*t.key))
        free.append(disj((lock, onward)) if t.key == key else lock)
    clear = Term(d.sections.clear(s), "overlap clear", f"{s} clear: overlap")
    return [Term(conj(free), "overlap free", f"{s} free as overlap of {g}"), clear, *not_blocked(s), *available(d, key)]


def _held_under(d: Draft, r: RouteRow, key: TraversalKey) -> list[tuple[SignalId, int]]:
    """The overlaps that may be held where a route leads over a way: under train routes alone, as nobody knows what
    stands in an overlap that a call-on would run over."""
    return d.overlaps.led_over.get((r.entry, key), []) if r.kind is RouteKind.MAIN else []


def detection(d: Draft) -> None:
    """Whether ways lie and are clear, checked in every scan (R3)."""
    routes = _of_routes(d)
    for t in d.table.locks:
        _wire(d, names.WAY_DETECTED, t, _detection(d, t), "its points lie, nothing is foul of it")
        clear = Term(d.sections.clear(t.section), "section clear", f"{t.section} clear")
        _wire(d, names.WAY_LIES, t, [clear, *_detected(d, t.key)], "lies and is clear")
        if t.key in routes:
            terms = [*_lying(t.key, "way lies"), *not_blocked(t.section)]
            _wire(d, names.WAY_IN_ORDER, t, terms, f"proceed may be shown over it ({rules.PROCEED})")


def _detection(d: Draft, t: TraversalRow) -> list[Term]:
    terms = [
        Term(
            d.machines.detected(p.machine, p.position), f"{p.role} point detected", f"{p.machine} {p.position} detected"
        )
        for p in t.points
    ]
    return [*terms, *_trailed(d, t), *_foul(d, t), *_space(d, t)]


def _detected(d: Draft, key: TraversalKey) -> list[Term]:
    terms = _detection(d, d.table.lock[key])
    return [Term(var(names.WAY_DETECTED(*key)), "way detected", f"points of the way through {key[0]}")] if terms else []


def _lying(key: TraversalKey, kind: str) -> list[Term]:
    return [Term(var(names.WAY_LIES(*key)), kind, f"way through {key[0]} lies and is clear")]


# --- what routes ask for -------------------------------------------------------------------------


def free_terms(d: Draft, r: RouteRow, key: TraversalKey) -> list[Term]:
    """A way is free for a route; a train may run over the overlap of its own entry signal, or of one before (R4)."""
    s = key[0]
    own = _held_under(d, r, key)
    clear = s in r.clear.section_ids
    if not own and not clear:
        free = var(names.FREE(s))
        return [Term(free, "section free", f"{s} not locked"), *_unlocked(d, key, clear)]
    if not own:
        return [Term(var(names.WAY_FREE(*key)), "way free", f"way through {s} free")]
    others = [neg(d.overlaps.held(o)) for o in d.overlaps.over(s) if o not in own]
    free = conj(
        [neg(var(names.RESTART_LOCK(s))), *(neg(d.sections.lock(*t.key)) for t in d.sections.locks_of[s]), *others]
    )
    return [Term(free, "section free", f"{s} not locked, but for the own overlap"), *_unlocked(d, key, clear)]


def overlap_terms(d: Draft, r: RouteRow) -> list[Term]:
    """The route's overlap may be held."""
    if r.locking.overlap is None:
        return []
    g, k = r.locking.overlap.signal, r.locking.overlap.option
    return [Term(var(names.OVERLAP_FREE(g, k)), "overlap free", f"overlap of {g} may be held")]


def lying_terms(d: Draft, r: RouteRow) -> list[Term]:
    """Everything lies and is clear; vehicles may stand in the berth."""
    out = [
        x for k in r.path.locked for x in (_lying(k, "way lies") if k[0] in r.clear.section_ids else _detected(d, k))
    ]
    if r.path.berth is not None:
        out += _detected(d, r.path.traversals[-1])
    return [*out, *_some_overlap_lies(d, r)]


def proceed_terms(d: Draft, r: RouteRow) -> list[Term]:
    """Proceed may be shown over every way, and the overlap lies and is clear."""
    out = []
    for k in r.path.locked:
        if k[0] in r.clear.section_ids:
            out.append(Term(var(names.WAY_IN_ORDER(*k)), "way in order", f"way through {k[0]} in order"))
        else:
            out += [*_detected(d, k), *not_blocked(k[0])]
    if r.path.berth is not None:
        out += [*_detected(d, r.path.traversals[-1]), *not_blocked(r.path.berth)]
    return [*out, *_some_overlap_lies(d, r), *_overlap_not_blocked(d, r)]


def unhindered(d: Draft) -> None:
    """Nobody has blocked a section in the way of a route that is set, and no point in it was trailed: what was asked
    for before comes to nothing then, so that nobody opens a signal who takes a block off, or has looked at a point
    (R14).  Nor were inputs lost: of a call-on route, on whose sections nobody relies, nothing else tells (R16)."""
    for r in d.table.routes:
        keys = [*r.path.locked, *([r.path.traversals[-1]] if r.path.berth is not None else [])]
        terms = [x for k in keys for x in (*not_blocked(k[0]), *_trailed(d, d.table.lock[k]))]
        terms += [*_overlap_not_blocked(d, r), *_overlap_not_trailed(d, r)]
        terms += [x for p in r.locking.added for x in added.not_trailed(d, p.machine)]
        terms += [Term(var(names.VALID), "inputs valid")] if r.kind is RouteKind.CALL_ON else []
        terms = list({t.expr: t for t in terms}.values())
        lost = ", nor are inputs lost" if r.kind is RouteKind.CALL_ON else ""
        note = f"nothing in the way of route {r.id} is blocked or was trailed{lost} ({rules.ONE_TRAIN_ONE_ROUTE})"
        d.wire(names.UNHINDERED(r.number), Join.ALL, terms, f"route {r.id}", note)


def _overlap_not_trailed(d: Draft, r: RouteRow) -> list[Term]:
    """No point of the overlap of the route was trailed, or of the one to which it has swung."""
    cell = r.locking.overlap
    if cell is None or not cell.swings:
        return [x for k in (cell.ways if cell is not None else ()) for x in _trailed(d, d.table.lock[k])]
    out = []
    for o in ((cell.signal, k) for k in sorted({cell.option, *cell.swings})):
        lie = conj(x.expr for k in d.overlaps.ways[o] for x in _trailed(d, d.table.lock[k]))
        note = f"no point of overlap {o[1]} of {o[0]} was trailed, or it is not held"
        out.append(Term(disj((lie, neg(d.overlaps.held(o)))), "overlap not trailed", note))
    return out


def passing_terms(d: Draft, r: RouteRow) -> list[Term]:
    """Proceed may go on being shown to the movement that has begun to pass the signal."""
    out = []
    for k in r.path.traversals:
        out += [*_detected(d, k), *not_blocked(k[0])]
    return [*out, *_some_overlap_lies(d, r), *_overlap_not_blocked(d, r)]


def _overlap_not_blocked(d: Draft, r: RouteRow) -> list[Term]:
    """Nobody has blocked the overlap of the route, or the one to which it has swung."""
    cell = r.locking.overlap
    if cell is None or not cell.swings:
        return [x for s, _ in (cell.ways if cell is not None else ()) for x in not_blocked(s)]
    out = []
    for o in ((cell.signal, k) for k in sorted({cell.option, *cell.swings})):
        free = conj(neg(var(names.BLOCKED(s))) for s, _ in d.overlaps.ways[o])
        note = f"overlap {o[1]} of {o[0]} not blocked, or not held"
        out.append(Term(disj((free, neg(d.overlaps.held(o)))), "overlap not blocked", note))
    return out


def _some_overlap_lies(d: Draft, r: RouteRow) -> list[Term]:
    """The overlap of the route, or the one to which it has swung."""
    if r.locking.overlap is None or not r.locking.overlap.swings:
        return _overlap_lies(r)
    note = f"an overlap of {r.locking.overlap.signal} lies and is clear"
    return [Term(var(names.OVERLAP_LIES(r.locking.overlap.signal)), "overlap lies", note)]


def not_swinging(d: Draft, r: RouteRow) -> list[Term]:
    """The overlap of the route does not begin to swing in this scan: its points are driven from where they lie (R4)."""
    cell = r.locking.overlap
    if cell is None or not cell.swings:
        return []
    begins = disj(var(swing_wire(d, cell.signal, k)) for k in d.overlaps.swinging[cell.signal])
    return [Term(neg(begins), "overlap stays", f"the overlap of {cell.signal} does not swing")]


def swung(d: Draft) -> None:
    """For each signal whose overlap swings: the alternative that is held lies and is clear."""
    for g in d.overlaps.swinging:
        terms = []
        for o in d.overlaps.of_signal[g]:
            lies = conj(x.expr for key in d.overlaps.ways[o] for x in _lying(key, "overlap lies"))
            terms.append(Term(conj((d.overlaps.held(o), lies)), "overlap lies", f"overlap {o[1]} of {g}"))
        d.wire(
            names.OVERLAP_LIES(g),
            Join.ANY,
            terms,
            f"overlap {g}",
            f"the overlap of {g} lies and is clear ({rules.OVERLAPS})",
        )


def _overlap_lies(r: RouteRow) -> list[Term]:
    return [x for key in (r.locking.overlap.ways if r.locking.overlap else ()) for x in _lying(key, "overlap lies")]


# --- what grants reach ---------------------------------------------------------------------------


def granted(d: Draft) -> None:
    """Which ways and overlaps are granted in this scan."""
    for t in d.table.locks:
        over = d.routes.over.get(t.key, ())
        for family, routes in (
            (names.WAY_GRANTED, [r for r in over if r.path.berth != t.section]),
            (names.BERTH_GRANTED, [r for r in over if r.path.berth == t.section]),
        ):
            if routes:
                terms = [Term(var(names.GRANTED(r.number)), "granted", f"route {r.id}") for r in routes]
                d.wire(family(*t.key), Join.ANY, terms, f"section {t.section}", _way(t, "granted"))
    for (g, k), _ in d.overlaps.ways.items():
        terms = [Term(var(names.GRANTED(r.number)), "granted", f"route {r.id}") for r in overlap_users(d, (g, k))]
        d.wire(names.OVERLAP_GRANTED(g, k), Join.ANY, terms, f"overlap {g}", f"overlap {k} of {g}: granted")


def overlap_users(d: Draft, option: tuple[SignalId, int]) -> list[RouteRow]:
    """The routes that lock an overlap."""
    return list(d.routes.to.get(option, ()))


def grant_of(d: Draft, key: TraversalKey, berth: bool = False) -> Expr:
    """The way is granted in this scan: to a route that goes through it, or to one that ends in it as a berth."""
    s = key[0]
    ends = any((r.path.berth == s) is berth for r in d.routes.over.get(key, ()))
    return var((names.BERTH_GRANTED if berth else names.WAY_GRANTED)(*key)) if ends else disj(())


def demands(d: Draft) -> tuple[Mapping[MachineId, Expr], Mapping[tuple[MachineId, Position], Expr]]:
    """A grant in this scan touches each machine (it lies over it, or demands it), and demands it in a position."""
    touched: dict[MachineId, dict[Expr, None]] = {m: {} for m in d.machines.all}
    demanded: dict[tuple[MachineId, Position], dict[Expr, None]] = {
        (m, x): {} for m in d.machines.all for x in Position
    }
    machines_in: dict[SectionId, list[MachineId]] = {}
    for m in d.machines.all:
        for s in d.machines.sections_of(m):
            machines_in.setdefault(s, []).append(m)
    for t in d.table.locks:
        grants = dict.fromkeys(_grants(d, t.key))
        for m in machines_in.get(t.section, ()):
            touched[m] |= grants
        for p in t.points:
            touched[p.machine] |= grants
            demanded[p.machine, p.position] |= grants
    for m, x, grant in added.granted(d):
        touched[m] |= {grant: None}
        demanded[m, x] |= {grant: None}
    return {m: disj(xs) for m, xs in touched.items()}, {k: disj(xs) for k, xs in demanded.items()}


def _grants(d: Draft, key: TraversalKey) -> Iterator[Expr]:
    yield grant_of(d, key)
    yield grant_of(d, key, berth=True)
    for g, k in d.overlaps.over(key[0]):
        if key in d.overlaps.ways[g, k]:
            yield var(names.OVERLAP_GRANTED(g, k))
            if k in d.overlaps.swinging.get(g, ()):
                yield var(swing_wire(d, g, k))


def swing_wire(d: Draft, g: SignalId, option: int) -> names.Name:
    """The wire that tells that the overlap of a signal swings to an alternative in this scan."""
    return names.SWINGS_TO(g, list(d.overlaps.swinging).index(g) + 1, option)


def swing_terms(d: Draft, g: SignalId, key: TraversalKey) -> list[Term]:
    """A way can be held as overlap instead of another alternative of the same signal (R4)."""
    s, t = key[0], d.table.lock[key]
    others = [neg(d.overlaps.held(o)) for o in d.overlaps.over(s) if o[0] != g]
    free = conj([neg(var(names.RESTART_LOCK(s))), *others])
    terms = [Term(free, "overlap free", f"{s} free for another overlap of {g}"), *not_blocked(s)]
    for ex in t.exclusions:
        if ex.section in d.sections.locks_of:
            held: list[Expr] = [var(names.RESTART_LOCK(ex.section))]
            if ex.whole:
                held += [d.sections.lock(*x.key) for x in d.sections.locks_of[ex.section]]
                held += [d.overlaps.held(o) for o in d.overlaps.over(ex.section) if o[0] != g]
            else:
                held += [d.overlaps.holding((ex.section, n), but=g) for n in ex.numbers]
            terms.append(Term(neg(disj(held)), "exclusion", f"{ex.section}: {ex.because.text}"))
    for p in t.points:
        there = conj(
            (d.machines.detected(p.machine, p.position), *(neg(d.machines.command(p.machine, y)) for y in Position))
        )
        runs = [*(t.expr for t in unblocked(d, p.machine)), neg(d.machines.kept_off(p.machine))]
        lies = d.machines.detected(p.machine, p.position)
        turns = conj((d.machines.command(p.machine, p.position), disj((lies, conj(runs)))))
        free = disj((turns, _may_swing(d, g, p.machine), there))
        terms.append(
            Term(free, f"{p.role} point available", f"{p.machine} {p.position}: {p.because.text}", p.because.rule)
        )
        terms += added.others_shut(d, p.machine, p.position)
    return [*terms, *_trailed(d, t), *_foul(d, t), *_space(d, t)]


def _may_swing(d: Draft, g: SignalId, m: MachineId) -> Expr:
    """A machine that nobody holds but the overlap of one signal, and nothing stands over."""
    terms: list[Expr] = [var(names.VALID)]
    for s in d.machines.sections_of(m):
        terms += [
            neg(var(names.RESTART_LOCK(s))),
            *(neg(d.sections.lock(*x.key)) for x in d.sections.locks_of[s]),
            d.sections.clear(s),
        ]
        terms += [neg(d.overlaps.held(o)) for o in d.overlaps.over(s) if o[0] != g]
    for t in d.table.locks:
        if any(p.machine == m and p.role is Role.FLANK for p in t.points):
            terms.append(neg(d.overlaps.holding(t.key, but=g)))
    terms += (t.expr for t in unblocked(d, m))
    terms += map(neg, added.held(d, m))
    return conj(terms)
