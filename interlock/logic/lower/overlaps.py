"""Overlaps (R4): how long one is held, and when the train before its signal stands, which is asked of berths, too (R2).

V one bit for each alternative of a signal; VF firm, the route that holds it is locked and its points are detected.
What an overlap must find free is in `routes`, with everything else that a grant needs.
"""

from __future__ import annotations

from fractions import Fraction

from interlock.logic import names, rules
from interlock.logic.controller import Join, Term
from interlock.logic.expr import Expr, conj, disj, neg, var
from interlock.logic.lower import requests, sections, ways
from interlock.logic.lower.draft import Draft
from interlock.model.elements import SignalId
from interlock.model.overlap import may_be_short
from interlock.model.times import overlap_release_s, stated


def timed(d: Draft) -> list[SignalId]:
    """The signals before which a train is timed until it stands: those with an overlap, and those at the end of a berth
    into which shunting movements come from there, towards the train."""
    met = (g for those in d.signals.met.values() for g in those)
    return sorted({*(g for g, _ in d.overlaps.ways), *met})


def stands_s(d: Draft, g: SignalId) -> Fraction:
    """Seconds for which a train must have been before a signal until it counts as standing."""
    return max(stated(overlap_release_s(d.layout, g)), Fraction(d.signals.arrive.get(g, 0), 1000))


def standing(d: Draft) -> None:
    """Overlaps are held until no route leads to their signal, or the train before it stands (R4); before that nobody is
    shunted towards it either (R2)."""
    signals = sorted(d.overlaps.of_signal)
    for g in timed(d):
        b = d.signals.before(g)
        node = d.layout.signalling.signal[g].node
        to = d.sections.locked_out(b, node)
        terms = [
            *sections.arrived(d, b),
            Term(to, "locked towards it", f"{b} is locked towards {g}"),
            Term(d.sections.occupied(b), "occupied", f"{b} occupied"),
        ]
        d.wire(
            names.STANDING_RUNS(g),
            Join.ALL,
            terms,
            f"overlap {g}" if g in signals else f"signal {g}",
            f"the train before {g} is wholly in {b} ({rules.OVERLAPS if g in signals else rules.KINDS_OF_ROUTES})",
        )
    for g in timed(d):
        rule = rules.OVERLAPS if g in signals else rules.KINDS_OF_ROUTES
        note = f"{g}: the train before it stands ({rule})"
        d.timer(names.STANDING(g), names.STANDING_RUNS(g), stands_s(d, g), note)
    for g in signals:
        b = d.signals.before(g)
        to = d.sections.locked_out(b, d.layout.signalling.signal[g].node)
        terms = [
            Term(neg(to), "no route to it", f"{b} not locked towards {g}"),
            Term(var(names.STANDING(g)), "train stands"),
        ]
        d.wire(
            names.OVERLAP_OVER(g),
            Join.ANY,
            terms,
            f"overlap {g}",
            f"the overlap of {g} is not needed any more ({rules.OVERLAPS})",
        )


def swing(d: Draft) -> None:
    """An overlap swings to another alternative when that is fully available and no train is close (R4)."""
    for g, options in d.overlaps.swinging.items():
        b = d.signals.before(g)
        every = dict.fromkeys(s for o in d.overlaps.of_signal[g] for s, _ in d.overlaps.ways[o])
        before: list[Expr] = []
        for k in options:
            others = disj(d.overlaps.held(o) for o in d.overlaps.of_signal[g] if o[1] != k)
            terms = [
                Term(var(names.VALID), "inputs valid"),
                Term(requests.asked(d, d.overlaps.swing_number(g)), "requested"),
                Term(others, "another held"),
                Term(var(names.OVERLAP_FIRM(g)), "firmly held"),
                Term(neg(var(names.OVERLAP_OVER(g))), "still needed"),
                Term(d.sections.clear(b), "no train close", f"{b} clear: no train is close"),
                *(Term(neg(x), "first alternative") for x in before),
                *(Term(d.sections.clear(s), "overlap clear", f"{s} long clear: overlap") for s in every),
                *(
                    Term(
                        neg(disj(d.sections.lock(*t.key) for t in d.sections.locks_of[s])),
                        "not run over",
                        f"no route over {s}",
                    )
                    for s in every
                ),
                *(x for key in d.overlaps.ways[g, k] for x in ways.swing_terms(d, g, key)),
            ]
            name = ways.swing_wire(d, g, k)
            before.append(
                d.wire(name, Join.ALL, terms, f"overlap {g}", f"the overlap of {g} swings to {k} ({rules.OVERLAPS})")
            )


def _swings(d: Draft, g: SignalId, but: int | None = None) -> list[Expr]:
    return [var(ways.swing_wire(d, g, k)) for k in d.overlaps.swinging.get(g, ()) if k != but]


def _empty(d: Draft, o: tuple[SignalId, int]) -> list[Expr]:
    """Every section of an overlap is clear; or all but the last are, and that one stays locked, the same way, for the
    train that has come into it: what is used is locked, and nothing else is set over what is held.  Where another
    alternative leads on from there, what has overrun the signal may."""
    *before, last = d.overlaps.ways[o]
    clear = d.sections.clear(last[0])
    lies = [d.topo.traversals[s][n - 1] for s, n in d.overlaps.ways[o]]
    if any(r.train for r in d.routes.over.get(last, ())) and not may_be_short(d.layout, o[0], lies):
        clear = disj((clear, var(names.USED(last[0]))))
    return [*(d.sections.clear(s) for s, _ in before), clear]


def keep(d: Draft) -> None:
    """Next values of the overlaps."""
    note = "until it is not needed, and clear without a break, or its train stands locked in its last section"
    for o in d.overlaps.ways:
        g, k = o
        away = _swings(d, g, but=k)
        stays = conj((neg(conj((var(names.OVERLAP_OVER(g)), *_empty(d, o)))), *map(neg, away)))
        to = [var(ways.swing_wire(d, g, k))] if k in d.overlaps.swinging.get(g, ()) else []
        d.kept(
            names.OVERLAP(g, k),
            False,
            f"overlap {k} of {g} held",
            Join.ANY,
            (
                Term(disj((var(names.OVERLAP_GRANTED(g, k)), *to)), "granted"),
                Term(conj((d.overlaps.held(o), stays)), "held", note),
            ),
            f"overlap {g}",
        )
    for g in sorted({g for g, _ in d.overlaps.ways}):
        users = d.routes.with_overlap[g]
        any_ = disj(map(d.overlaps.held, d.overlaps.of_signal[g]))
        swings = _swings(d, g)
        turned = [conj((var(names.OVERLAP_SWINGS(g)), var(names.OVERLAP_LIES(g))))] if swings else []
        firm = disj((var(names.OVERLAP_FIRM(g)), *turned, *(var(names.LOCKS(r.number)) for r in users)))
        d.kept(
            names.OVERLAP_FIRM(g),
            False,
            f"overlap of {g} firmly held",
            Join.ALL,
            (
                Term(firm, "held or locked"),
                Term(any_, "some overlap held"),
                *(Term(neg(x), "not swung", "it does not swing") for x in swings),
            ),
            f"overlap {g}",
        )
        if swings:
            going = conj((var(names.OVERLAP_SWINGS(g)), neg(var(names.OVERLAP_LIES(g)))))
            d.kept(
                names.OVERLAP_SWINGS(g),
                False,
                f"the overlap of {g} swings",
                Join.ALL,
                (
                    Term(disj((going, *swings)), "swings", "until the other alternative lies and is clear"),
                    Term(any_, "some overlap held"),
                ),
                f"overlap {g}",
            )
