"""What came in behind a signal: that it was a movement, and no joint or card that failed (R9).

OA what is in the first section was there alone for longer than detectors take; AO it was read occupied in the scan in
which what is ahead of it was, too.  What a section remembers of it (RC) is in `sections`.
"""

from __future__ import annotations

from interlock.logic import names, rules
from interlock.logic.controller import Join, Term
from interlock.logic.expr import FALSE, TRUE, Expr, conj, disj, neg, var
from interlock.logic.lower.draft import Draft
from interlock.model.elements import SectionId, SignalId


def from_signals(d: Draft, s: SectionId) -> list[tuple[SignalId, Expr]]:
    """The main signals with routes behind which a section is the first, where the section in rear is detected, each
    with that the section is locked from there for a train (R9)."""
    found = []
    for node in d.topo.ends[s]:
        g, rear, locked = d.signals.main_at(s, node), d.sections.rear(s, node), d.sections.locked_in(s, node)
        if g is None or rear is None or rear in d.layout.track.undetected or locked is FALSE:
            continue
        if d.routes.of_signal[g]:
            found.append((g, conj((locked, d.sections.train(s)))))
    return found


def in_order(d: Draft, s: SectionId) -> list[tuple[SignalId, Expr]]:
    """The signals with routes behind which a section is the first, where what is in rear does not tell whether all has
    come in, each with that the section is locked for such a movement from there: shunting movements leave vehicles
    behind, and of trains where the section in rear has no detection nobody knows (R9)."""
    found = []
    for node in d.topo.ends[s]:
        g, rear, locked = d.signals.signal_at(s, node), d.sections.rear(s, node), d.sections.locked_in(s, node)
        if g is None or locked is FALSE:
            continue
        kinds = {r.train for r in d.routes.of_signal[g]}
        train = d.sections.train(s)
        if False in kinds:
            found.append((g, conj((locked, neg(train)))))
        if True in kinds and d.signals.main_at(s, node) == g and (rear is None or rear in d.layout.track.undetected):
            found.append((g, conj((locked, train))))
    return found


def passed_on(d: Draft, s: SectionId) -> Expr:
    """A movement has gone on into the next section, and that was no joint that failed: such a one reports both sections
    beside it occupied, as if a train had run over it, and a card all of its sections, while one stands or runs before
    the open signal.  Or the delay of approach locking is over."""
    left = [disj((neg(locked), d.signals.approach_safe(g))) for g, locked in (*from_signals(d, s), *in_order(d, s))]
    return conj((var(names.PASSED(s)), disj((var(names.REAR_CLEARED(s)), conj(left))) if left else TRUE))


def seen_alone(d: Draft) -> None:
    """What came in stood or ran in its first section alone, for longer than two detectors may differ (A-SCAN), before
    it was read in the next one, too (R9)."""
    for s in d.sections.all:
        if not in_order(d, s):
            continue
        terms = [
            Term(var(names.USED(s)), "was used"),
            Term(d.sections.occupied(s), "occupied"),
            Term(
                neg(var(names.PASSED(s))), "not gone on yet"
            ),  # a joint that recovers on one side leaves the other alone
            Term(neg(var(names.AT_ONCE(s))), "not at once", "nothing ahead occupied when it came in"),
            *(Term(neg(on), "alone", f"{ahead} ahead not occupied") for ahead, on in ahead_of(d, s)),
        ]
        note = f"{s}: a movement is in it, and not yet ahead ({rules.SECTIONAL_RELEASE})"
        d.wire(names.ALONE_RUNS(s), Join.ALL, terms, f"section {s}", note)
        seconds = d.layout.principles.detection_delay_s
        note = f"{s}: a movement was in it alone for longer than detectors take ({rules.SECTIONAL_RELEASE})"
        d.timer(names.SEEN_ALONE(s), names.ALONE_RUNS(s), seconds, note)


def ahead_of(d: Draft, s: SectionId) -> list[tuple[SectionId, Expr]]:
    """The sections ahead of one, each with that it is occupied and the lock leads to it."""
    found = []
    for t in d.sections.locks_of[s]:
        ahead = d.topo.beyond(s, t.exit)
        if ahead is not None:
            found.append((ahead, conj((d.sections.lock(*t.key), d.sections.occupied(ahead)))))
    return found


def seen_whole(d: Draft, s: SectionId) -> Expr:
    """What came into a first section is seen to be a movement: nobody else is on the way to its signal, which has
    closed, or it was in the section alone."""
    seen = [
        conj((locked, d.signals.approach_reads_clear(g), neg(d.signals.passing_signal(g))))
        for g, locked in from_signals(d, s)
    ]
    for g, locked in in_order(d, s):
        rear = d.sections.rear(s, d.layout.signalling.signal[g].node)
        told = rear is not None and rear not in d.layout.track.undetected
        seen.append(
            conj((locked, disj((var(names.SEEN_ALONE(s)), d.signals.approach_reads_clear(g) if told else FALSE))))
        )
    return disj(seen)
