"""Sections: locks, the three-point check, release (R8, R9, R16).

Per section: K restart lock (nobody may use it after power-up until it is released by hand, R16); L one bit for
each way through it; F firm, the route is locked and its points detected; U used, a train came in from the rear;
P passed, a train went on into the next section; D stale, inputs were lost while locked or the lock is for a call-on, so
that automatic release is off and the lock is released by hand.
"""

from __future__ import annotations

from interlock.diag.called import called
from interlock.logic import names, rules
from interlock.logic.controller import Input, Join, Output, Term
from interlock.logic.expr import FALSE, TRUE, Expr, conj, disj, neg, var
from interlock.logic.lower import come_in, ways
from interlock.logic.lower.draft import Draft
from interlock.model.elements import NodeId, SectionId, SignalId
from interlock.table.cells import RouteKind
from interlock.table.rows import RouteRow


def inputs(d: Draft) -> None:
    """Detection (1 = clear, so that a broken wire reads occupied), manual release and blocking."""
    for s in d.layout.track.sections:
        if s.id in d.layout.track.undetected:
            continue
        d.inputs.append(Input(names.CLEAR(s.id), f"{called('section', s.id)} reported clear"))
    for s_, name in d.sections.healthy.items():
        d.inputs.append(Input(name, f"detector of {s_} healthy"))
    for s_ in d.sections.all:
        said = f"operator: release {called('section', s_)} (hold until released)"
        d.inputs.append(Input(names.RELEASE_BY_HAND(s_), said))
    for s_ in d.sections.blockable:
        d.inputs.append(Input(names.BLOCKED(s_), f"operator: {called('section', s_)} is blocked", restrictive=1))
    d.inputs.append(
        Input(names.RELEASE_ALL, "operator: release all clear sections after a restart or a loss of inputs")
    )


def alarms(d: Draft) -> None:
    """A detector that is not healthy raises an alarm (document B 2.1)."""
    for s, name in d.sections.healthy.items():
        d.kept(
            names.FAULTY(s),
            False,
            f"alarm: detector of {s} faulty",
            Join.ALL,
            (Term(neg(var(name)), "fault"),),
            "alarms",
        )
        d.outputs.append(Output(names.FAULT_SHOWN(s), var(names.FAULTY(s)), False, f"alarm: detector of {s} faulty"))


def image(d: Draft) -> None:
    """A section counts as occupied unless it is validly reported clear (R3, R16)."""
    for s in d.layout.track.sections:
        if s.id in d.layout.track.undetected:
            continue
        d.wire(
            names.OCCUPIED(s.id),
            Join.ANY,
            (
                Term(neg(var(names.CLEAR(s.id))), "not reported clear"),
                *([Term(neg(var(d.sections.healthy[s.id])), "detector faulty")] if s.id in d.sections.healthy else []),
                Term(neg(var(names.VALID)), "inputs lost"),
            ),
            f"section {s.id}",
            f"{s.id} counts as occupied",
        )
    for s_ in d.sections.all:
        d.wire(
            names.FREE(s_),
            Join.ALL,
            (
                Term(neg(var(names.RESTART_LOCK(s_))), "no restart lock"),
                *(Term(neg(d.sections.lock(*t.key)), "not locked") for t in d.sections.locks_of[s_]),
                *(Term(neg(d.overlaps.held(o)), "no overlap", f"no overlap of {o[0]}") for o in d.overlaps.over(s_)),
            ),
            f"section {s_}",
            f"{s_} is not locked by anybody",
        )


def _new_use(section: SectionId, index: int) -> names.Name:
    return names.ENTERED(section, index)


def three_point(d: Draft) -> None:
    """A train has come in: occupied together with the section in rear, which was itself used (R9)."""
    for s in d.sections.all:
        for i, node in enumerate(d.topo.ends[s], start=1):
            locked = d.sections.locked_in(s, node)
            if locked is FALSE:
                continue
            rear = d.sections.rear(s, node)
            if s in d.routes.berths and d.signals.signal_at(s, node) is None:
                locked = disj(
                    d.sections.lock(*t.key) for t in d.sections.locks_of[s]
                )  # whichever movement locked it first
            terms = [
                Term(var(names.VALID), "inputs valid"),
                Term(var(names.FIRM(s)), "firmly locked"),
                Term(neg(var(names.STALE(s))), "inputs never lost"),
                Term(neg(var(names.USED(s))), "not used yet"),
                Term(locked, "locked from here"),
                Term(d.sections.occupied(s), "occupied"),
                Term(d.sections.occupied(rear), "rear occupied", f"{rear or 'no detection'} in rear occupied"),
            ]
            if d.signals.main_at(s, node) is None and rear is not None and rear in d.sections.locks_of:
                # outside, at a boundary, nothing is locked
                own = neg(d.sections.train(s)) if d.signals.signal_at(s, node) is not None else FALSE
                # a train that has overrun a signal runs on within the overlap
                own = disj([own, *(d.overlaps.held(x) for x in d.overlaps.along(rear, node, s))])
                used, leads = var(names.USED(rear)), d.sections.locked_out(rear, node)
                terms.append(Term(disj((own, used)), "rear used", f"{rear} itself was used"))
                terms.append(Term(disj((own, leads)), "rear leads here", f"{rear} is locked towards {s}"))
            d.wire(
                _new_use(s, i),
                Join.ALL,
                terms,
                f"section {s}",
                f"a train comes into {s} at {node} ({rules.SECTIONAL_RELEASE})",
            )


def _granted_into(d: Draft, s: SectionId) -> list[Expr]:
    """A further shunting movement is granted into a berth in this scan; none, where none can be."""
    into = disj(var(names.GRANTED(r.number)) for r in d.routes.into.get(s, ()))
    return [] if into is FALSE else [into]


def rear_free(d: Draft, s: SectionId) -> list[Term]:
    """No lock in rear still leads into the section, and none is granted in this scan."""
    out = [Term(neg(x), "nothing granted into it") for x in _granted_into(d, s)]
    for node in d.topo.ends[s]:
        rear = d.topo.beyond(s, node)
        if rear is None or d.signals.main_at(s, node) is not None:
            continue
        locked, leading = d.sections.locked_in(s, node), d.sections.locked_out(rear, node)
        if locked is FALSE or leading is FALSE:
            continue
        if s in d.routes.berths and d.signals.signal_at(s, node) is None:
            locked = TRUE  # a shunting movement may lead into a berth that another one has locked
        on = d.signals.passing(s, node, rear)
        out.append(Term(neg(conj((locked, leading, *on))), "rear released", f"{rear} in rear is released"))
    return out


def _closed(d: Draft, s: SectionId) -> list[Term]:
    """A signal that stays open while a movement passes it has closed (R3)."""
    signals = [g for node in d.topo.ends[s] if (g := d.signals.signal_at(s, node)) is not None]
    open_ = disj(d.signals.passing_signal(g) for g in signals)
    return [] if open_ is FALSE else [Term(neg(open_), "signal closed", f"{' and '.join(signals)} closed")]


RESTART_DELAY = names.RESTART_OVER


def restart_delay(d: Draft) -> None:
    """After power-up nothing is released until whatever still ran has had time to come to a stand (R16)."""
    on = (Term(TRUE, "running", "since the first scan"),)
    d.kept(names.POWERED, False, "the controller has run a scan since power-up", Join.ALL, on, "restart")
    d.wire(
        names.RESTART_RUNS,
        Join.ALL,
        (Term(var(names.POWERED), "running"),),
        "restart",
        f"the restart delay runs ({rules.RESTART})",
    )
    d.timer(
        RESTART_DELAY,
        names.RESTART_RUNS,
        d.layout.principles.restart_delay_s,
        f"the restart delay is over ({rules.RESTART})",
    )


def detected(d: Draft) -> list[SectionId]:
    """Sections inside and approaches that are reported."""
    return [s.id for s in d.layout.track.sections if s.id not in d.layout.track.undetected]


def clear_time(d: Draft) -> None:
    """How long a section has been reported clear without a break: a single clear reading is never relied on (R15)."""
    timed = list(dict.fromkeys((*d.sections.all, *detected(d))))
    for s in timed:
        clear = Term(neg(d.sections.occupied(s)), "section clear", f"{s} clear")
        d.wire(names.CLEAR_RUNS(s), Join.ALL, (clear,), f"section {s}", f"{s} is reported clear")
    for s in timed:
        d.timer(
            names.LONG_CLEAR(s),
            names.CLEAR_RUNS(s),
            d.layout.principles.release_delay_s,
            f"{s}: release delay ({rules.LOSS_OF_SHUNT})",
        )


def long_clear(d: Draft, s: SectionId) -> Term:
    """The section has been clear, inputs valid, for the release delay."""
    return Term(d.sections.clear(s), "long clear", f"{s} clear without a break for the release delay")


def _signals_into(d: Draft, s: SectionId) -> list[tuple[SignalId, Expr]]:
    """The signals with routes into a section, and that it is locked for one of them.

    Where there is an overlap alone, nothing is locked for a train.
    """
    found = [(d.signals.signal_at(s, node), d.sections.locked_in(s, node)) for node in d.topo.ends[s]]
    return [(g, locked) for g, locked in found if g is not None and locked is not FALSE and d.routes.of_signal[g]]


def _by_hand(d: Draft, s: SectionId) -> list[Term]:
    """What releasing a section by hand asks for, besides that it is clear."""
    asked = disj((var(names.RELEASE_BY_HAND(s)), conj((var(names.RELEASE_ALL), var(names.STALE(s))))))
    out = [
        Term(asked, "by hand", f"{s} alone, or all sections in which a train may have been missed"),
        Term(disj(d.sections.lock(*t.key) for t in d.sections.locks_of[s]), "locked"),
    ]
    for g, locked in _signals_into(d, s):
        safe = conj((neg(d.signals.any_active(g)), d.signals.approach_safe(g)))
        note = f"no route from {g} is set and no train is about to pass it"
        out.append(Term(disj((neg(locked), safe)), "no train about to come", note))
    return out


def _after_restart(d: Draft, s: SectionId, ready: list[Term], rear: list[Term]) -> None:
    """The release of the restart lock by an operator, when the restart delay is over."""
    d.wire(
        names.RELEASED_AFTER_RESTART(s),
        Join.ALL,
        (
            *ready,
            Term(var(names.RESTART_LOCK(s)), "restart lock"),
            Term(var(RESTART_DELAY), "restart delay over"),
            Term(disj((var(names.RELEASE_BY_HAND(s)), var(names.RELEASE_ALL))), "operator"),
            *(rear if s in d.routes.berths else ()),
        ),
        f"section {s}",
        f"{s} released after a restart ({rules.RESTART})",
    )


def _unsignalled(d: Draft, s: SectionId) -> Expr:
    """A section is locked from another one, over a joint at which no signal calls whoever it is locked for."""
    return disj(
        conj(
            (
                d.sections.locked_in(s, node),
                *([d.sections.train(s)] if d.signals.signal_at(s, node) is not None else []),
            )
        )
        for node in d.topo.ends[s]
        if d.signals.main_at(s, node) is None and d.topo.beyond(s, node) is not None
    )


def release(d: Draft) -> None:
    """All the ways in which a section is released; none of them before it has been clear for the release delay."""
    valid = Term(var(names.VALID), "inputs valid")
    for s in d.sections.all:
        group = f"section {s}"
        clear = long_clear(d, s)
        rear = rear_free(d, s)
        d.wire(
            names.LEAVES(s), Join.ANY, _exits(d, s), group, f"a train in {s} leaves over a boundary, or has passed on"
        )
        used, went_on = Term(var(names.USED(s)), "was used"), Term(var(names.LEAVES(s)), "went on")
        behind = (valid, used, clear, *_closed(d, s), *rear, went_on)
        note = f"{s} is released behind the train ({rules.SECTIONAL_RELEASE})"
        d.wire(names.RELEASED_BEHIND(s), Join.ALL, behind, group, note)
        if s in d.routes.berths:
            note = f"a train has arrived in {s}, wholly ({rules.KINDS_OF_ROUTES})"
            d.wire(names.ARRIVED(s), Join.ALL, _arrival(d, s, rear), group, note)
        inside = (Term(neg(var(names.USED(s))), "not used"), Term(_unsignalled(d, s), "locked from inside"))
        d.wire(
            names.WITHDRAWN(s),
            Join.ALL,
            (valid, clear, *inside, *rear),
            group,
            f"the lock before {s} was withdrawn ({rules.APPROACH_LOCKING})",
        )
        by_hand = [valid, clear, *_closed(d, s), *rear, *_by_hand(d, s)]
        cancelled = [
            Term(var(names.CANCELLED(g)), "cancelled", f"route from {g} cancelled") for g, _ in _signals_into(d, s)
        ]
        d.wire(
            names.RELEASED_BY_HAND(s),
            Join.ALL,
            by_hand,
            group,
            f"{s} released by hand ({rules.APPROACH_LOCKING}, section fault release)",
        )
        _after_restart(d, s, [valid, clear], rear)
        d.wire(
            names.RELEASED(s),
            Join.ANY,
            (
                Term(var(names.RELEASED_BEHIND(s)), "behind the train"),
                Term(var(names.WITHDRAWN(s)), "withdrawn"),
                *cancelled,
                Term(var(names.RELEASED_BY_HAND(s)), "by hand"),
                Term(var(names.RELEASED_AFTER_RESTART(s)), "after restart"),
            ),
            group,
            f"{s} is released",
        )


def arrived(d: Draft, s: SectionId) -> list[Term]:
    """A train has come into a section, wholly."""
    return wholly_in(d, s, rear_free(d, s))


def wholly_in(d: Draft, s: SectionId, rear: list[Term], alone: bool = False) -> list[Term]:
    """The section was used, and nothing stands in rear of it that may still come in; where a signal leads a train into
    it, no one was on its way there since, or what reads as a train may be a joint that failed (R9).  That is seen once:
    who comes to the signal later is another train, for which it does not open.  `alone`: nor is another one there."""
    terms = [Term(var(names.VALID), "inputs valid"), Term(var(names.USED(s)), "was used"), *rear]
    come = come_in.from_signals(d, s)
    for node in d.topo.ends[s]:
        g = d.signals.main_at(s, node)
        if g is None:
            continue
        stands = conj((d.sections.locked_in(s, node), neg(d.sections.clear(d.sections.rear(s, node)))))
        if alone or g not in (h for h, _ in come):
            terms.append(Term(neg(stands), "wholly in", f"nothing stands before {g}"))
        elif d.signals.shunting:
            left = conj((stands, neg(d.sections.train(s)), neg(var(names.REAR_CLEARED(s)))))
            terms.append(Term(neg(left), "nothing left", f"no part of a shunting movement stands before {g}"))
    for g, locked in come:
        came = disj((neg(locked), var(names.REAR_CLEARED(s))))
        terms.append(Term(came, "approach seen clear", f"no other train is on its way past {g}"))
    return terms


def _arrival(d: Draft, s: SectionId, rear: list[Term]) -> list[Term]:
    """A train is in its last section: from now on vehicles may be shunted to it, or from when it stands.  Until then
    the next train may come to the signal in rear."""
    terms = wholly_in(d, s, rear, alone=s not in d.signals.met)
    for node in d.topo.ends[s]:
        ahead = d.topo.beyond(s, node)
        if ahead is None or d.signals.main_at(ahead, node) is not None:
            continue
        leads, taken = d.sections.locked_out(s, node), d.sections.locked_in(ahead, node)
        if leads is not FALSE and taken is not FALSE:
            going = conj((leads, taken, *d.signals.passing(ahead, node, s)))
            terms.append(Term(neg(going), "ends here", f"the train does not go on into {ahead}"))
    for r in d.table.routes:
        if r.kind is RouteKind.IDENTIFIER and d.signals.before(r.entry) == s:
            note = f"the train does not go on past {r.entry}"
            terms.append(Term(neg(var(names.SHOWING(r.number))), "ends here", note))
    return terms


def _exits(d: Draft, s: SectionId) -> list[Term]:
    out = [
        Term(
            come_in.passed_on(d, s),
            "passed on",
            "the next section was occupied together with this one, and rear cleared",
        )
    ]
    by_entry: dict[NodeId, list[Expr]] = {}
    for t in d.sections.locks_of[s]:
        if t.exit in d.layout.track.boundary_at:
            by_entry.setdefault(t.entry, []).append(d.sections.lock(*t.key))
    for node, locks in by_entry.items():
        g = d.signals.signal_at(s, node)
        leaves = disj(locks)
        if g is None:
            out.append(Term(leaves, "leaves at a boundary"))
        else:
            out.append(
                Term(
                    conj((leaves, d.signals.approach_safe(g))),
                    "leaves at a boundary",
                    f"and no train is about to pass {g}",
                )
            )
    for t in d.sections.locks_of[s]:
        into = d.sections.into_berth(t)
        if into is not FALSE:
            g = d.signals.signal_at(s, t.entry)
            safe = d.signals.approach_safe(g) if g is not None else TRUE
            ahead = d.topo.beyond(s, t.exit)
            gone = conj((into, d.sections.occupied(ahead), safe))
            out.append(Term(gone, "gone into a berth", f"a shunting movement has gone into {ahead}"))
    return out


def _keep_locks(d: Draft, s: SectionId, locks: Expr, stays: Term) -> None:
    """The locks of a section for its ways and for trains, and whether they are firm."""
    group = f"section {s}"
    firmer: list[Expr] = []
    for t in d.sections.locks_of[s]:
        name = names.LOCK(s, t.number)
        # a shunting movement locks its berth only if nobody has
        berth = conj((ways.grant_of(d, t.key, berth=True), var(names.FREE(s))))
        grants = [ways.grant_of(d, t.key), berth]
        for r in d.routes.over.get(t.key, ()):
            lock = var(names.LOCKS(r.number))
            firmer.append(conj((lock, locks)) if r.path.berth == s else lock)
        held = Term(disj((var(name), *grants)), "held or granted")
        d.kept(name, False, f"{s} locked from {t.entry} to {t.exit}", Join.ALL, (held, stays), group)
    if d.signals.shunting:
        over = [r for t in d.sections.locks_of[s] for r in d.routes.over.get(t.key, ()) if r.train]
        arrived = [_runs(d, s)] if s in d.routes.berths else []
        name = names.TRAIN_LOCK(s)
        held = Term(disj((var(name), *(var(names.GRANTED(r.number)) for r in over))), "held or granted")
        d.kept(name, False, f"{s} locked for a train movement", Join.ALL, (held, stays, *arrived), group)
    held = Term(disj((var(names.FIRM(s)), *firmer)), "held or locked")
    d.kept(names.FIRM(s), False, f"{s} firmly locked", Join.ALL, (held, stays), group)


def _runs(d: Draft, s: SectionId) -> Term:
    """A train has not come to its end: it is not wholly in the berth, or not proved at a stand by time, where shunting
    movements may come towards it (R2)."""
    stands, timed = [var(names.ARRIVED(s))], d.signals.met.get(s, ())
    for g in timed:
        towards = d.sections.locked_out(s, d.layout.signalling.signal[g].node)
        stands.append(disj((neg(towards), var(names.STANDING(g)))))
    note = f"wholly in, and standing before {' or '.join(timed)} by time" if timed else ""
    return Term(neg(conj(stands)), "not arrived", note)


def _keep_passage(d: Draft, s: SectionId, stays: Term) -> None:
    """What a section remembers of the train over it: it came in, it went on (R9)."""
    group = f"section {s}"
    uses = [
        var(_new_use(s, i)) for i, node in enumerate(d.topo.ends[s], 1) if d.sections.locked_in(s, node) is not FALSE
    ]
    held = Term(disj((var(names.USED(s)), *uses)), "held or new")
    d.kept(names.USED(s), True, f"{s} used by a train ({rules.SECTIONAL_RELEASE})", Join.ALL, (held, stays), group)
    if come_in.in_order(d, s):
        new = conj((disj(uses), disj(on for _, on in come_in.ahead_of(d, s))))
        held = Term(disj((var(names.AT_ONCE(s)), new)), "held or new")
        note = f"{s}: occupied in the scan in which what is ahead of it was, too ({rules.SECTIONAL_RELEASE})"
        d.kept(names.AT_ONCE(s), False, note, Join.ALL, (held, stays), group)
    seen = come_in.seen_whole(d, s)
    if seen is not FALSE:
        held = Term(disj((var(names.REAR_CLEARED(s)), conj((var(names.USED(s)), seen)))), "held or new")
        note = f"{s}: used, and that by a movement: no other is on its way, or it was alone ({rules.SECTIONAL_RELEASE})"
        alone = (Term(neg(x), "nothing granted into it") for x in _granted_into(d, s))
        d.kept(names.REAR_CLEARED(s), False, note, Join.ALL, (held, stays, *alone), group)
    gone = []
    for node in d.topo.ends[s]:
        ahead = d.topo.beyond(s, node)
        if ahead is not None and d.sections.locked_in(ahead, node) is not FALSE:
            gone.append(var(_new_use(ahead, d.topo.ends[ahead].index(node) + 1)))
    going = conj((var(names.USED(s)), d.sections.occupied(s), disj(gone)))
    held = Term(disj((var(names.PASSED(s)), going)), "held or new")
    d.kept(
        names.PASSED(s), False, f"{s}: the train went on ({rules.SECTIONAL_RELEASE})", Join.ALL, (held, stays), group
    )


def keep(d: Draft) -> None:
    """Next values of every section's state."""
    called: dict[SectionId, list[RouteRow]] = {}
    for r in d.table.routes:
        for s in r.path.section_ids if r.kind is RouteKind.CALL_ON else ():
            called.setdefault(s, []).append(r)
    for s in d.sections.all:
        group = f"section {s}"
        stays = Term(neg(var(names.RELEASED(s))), "not released")
        locks = disj(d.sections.lock(*t.key) for t in d.sections.locks_of[s])
        d.kept(
            names.RESTART_LOCK(s),
            True,
            f"{s}: restart lock ({rules.RESTART})",
            Join.ALL,
            (Term(var(names.RESTART_LOCK(s)), "held"), stays),
            group,
        )
        _keep_locks(d, s, locks, stays)
        _keep_passage(d, s, stays)
        lost = conj((neg(var(names.VALID)), locks))
        d.kept(
            names.STALE(s),
            False,
            f"{s}: detection is not relied on, inputs were lost or a train is called on",
            Join.ALL,
            (
                Term(
                    disj((var(names.STALE(s)), lost, *(var(names.GRANTED(r.number)) for r in called.get(s, ())))),
                    "held or lost",
                ),
                stays,
            ),
            group,
        )
        held = disj((var(names.RESTART_LOCK(s)), locks, *(d.overlaps.held(o) for o in d.overlaps.over(s))))
        d.outputs.append(Output(names.LOCKED_SHOWN(s), held, True, f"indication: {s} is locked"))
