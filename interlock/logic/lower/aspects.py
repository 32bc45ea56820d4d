"""Aspects of main, shunt and distant signals (R11).

C: the main signal shows clear, not caution.  It is kept as a bit of its own, computed in the scan in which the signal
opens: clear only while the next main signal shows proceed, where the principle asks for that, and its lamp is intact.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from interlock.diag.called import called
from interlock.logic import names
from interlock.logic.controller import Join, Output, Term
from interlock.logic.expr import Expr, conj, disj, neg, var
from interlock.logic.lower.draft import Draft
from interlock.logic.symbols import AspectSymbols
from interlock.model.elements import Signal, SignalId
from interlock.model.principles import Caution
from interlock.table.cells import RouteKind, Shows
from interlock.table.rows import RouteRow


def cautions(d: Draft) -> bool:
    """Whether main signals have a caution aspect."""
    return d.layout.principles.caution is not Caution.NEVER


def lamp_terms(d: Draft, r: RouteRow) -> list[Term]:
    """Proceed needs a lamp to show it; the most restrictive proceed lamp is the last.  Two yellows need both lamps, and
    a speed its indicator (R11)."""
    if d.layout.principles.lamp_proof and r.kind is RouteKind.IDENTIFIER:
        note = f"identifier lamp of {r.entry} intact"
        return [Term(var(names.IDENTIFIER_LAMP(r.entry)), "proceed lamp intact", note)]
    if not d.layout.principles.lamp_proof or r.kind is not RouteKind.MAIN:
        return []
    lamp, word = (names.CAUTION_LAMP, "caution") if cautions(d) else (names.CLEAR_LAMP, "clear")
    terms = [Term(var(lamp(r.entry)), "proceed lamp intact", f"{word} lamp of {r.entry} intact")]
    if r.signal.aspect.shows is Shows.TWO_YELLOWS:
        note = f"second yellow lamp of {r.entry} intact"
        terms.append(Term(var(names.SECOND_LAMP(r.entry)), "second yellow intact", note))
    if r.signal.speed.kmh is not None:
        note = f"speed indicator of {r.entry} intact"
        terms.append(Term(var(names.SPEED_LAMP(r.entry)), "speed indicator intact", note))
    return terms


def _opens(d: Draft, g: SignalId, family: names.Family) -> Expr:
    return disj(var(family(r.number)) for r in d.routes.of_signal[g] if r.kind is RouteKind.MAIN)


def keep(d: Draft) -> None:
    """Next values of the clear aspects."""
    for g in d.routes.open_for_trains if cautions(d) else ():
        ways = []
        for r in d.routes.of_signal[g]:
            if r.kind is RouteKind.MAIN and r.signal.aspect.shows in (Shows.CLEAR, Shows.NEXT):
                onward = [_opens(d, r.signal.aspect.next, names.OPENS)] if r.signal.aspect.next is not None else []
                ways.append(conj((var(names.OPENS(r.number)), *onward)))
        terms = [
            Term(_opens(d, g, names.OPENS), "open"),
            Term(disj(ways), "next signal open", "the way beyond is open"),
        ]
        if d.layout.principles.lamp_proof:
            terms.append(Term(var(names.CLEAR_LAMP(g)), "clear lamp intact", f"clear lamp of {g} intact"))
        d.kept(names.SHOWS_CLEAR(g), False, f"{g} shows clear", Join.ALL, terms, f"signal {g}")


def symbols(d: Draft) -> AspectSymbols:
    """The outputs of each signal's lamps."""
    signals = [g for g in d.layout.signalling.signals if d.routes.of_signal[g.id]]
    calls = [g for g in signals if any(r.kind is RouteKind.CALL_ON for r in d.routes.of_signal[g.id])]

    def each(family: names.Family, shown_by: Sequence[Signal]) -> dict[SignalId, names.Name]:
        return {g.id: family(g.id) for g in shown_by}

    mains = [g for g in signals if g.main and d.layout.signalling.opens(g.id, False)]
    return AspectSymbols(
        clear=each(names.CLEAR_ASPECT, mains),
        caution=each(names.CAUTION_ASPECT, mains if cautions(d) else []),
        second={g: names.SECOND_YELLOW(g) for g in two_yellows(d)},
        indicator={g: names.ROUTE_INDICATOR(g) for g in d.routes.open_for_trains if _indicated(d, g)},
        call_on=each(names.CALL_ASPECT, calls),
        identifier=each(names.IDENTIFIER_ASPECT, [g for g in signals if d.routes.identifies(g.id)]),
        shunt=each(names.SHUNT_ASPECT, [g for g in signals if g.shunt]),
        stop=each(names.STOP_ASPECT, signals),
        speed={(g, kmh): name for g in d.routes.open_for_trains for kmh, name in speeds(d, g).items()},
        distant_clear={x.id: names.DISTANT_CLEAR(x.id) for x in d.layout.signalling.distants},
        distant_caution={x.id: names.DISTANT_CAUTION(x.id) for x in d.layout.signalling.distants},
    )


def two_yellows(d: Draft) -> list[SignalId]:
    """The signals that show two yellows for some route."""
    shown = {r.entry for r in d.table.routes if r.signal.aspect.shows is Shows.TWO_YELLOWS}
    return [g for g in d.routes.open_for_trains if g in shown]


def _indicated(d: Draft, g: SignalId) -> list[RouteRow]:
    """The routes from a signal for which its route indicator is lit."""
    return [r for r in d.routes.of_signal[g] if r.signal.aspect.indicator]


def speeds(d: Draft, g: SignalId) -> dict[int, names.Name]:
    """The speeds that a signal can show, each with the name of its output."""
    found = {
        r.signal.speed.kmh for r in d.routes.of_signal[g] if r.kind is RouteKind.MAIN and r.signal.speed.kmh is not None
    }
    return {kmh: names.SPEED_ASPECT(g, kmh) for kmh in sorted(found)}


def outputs(d: Draft) -> None:
    """The lamps of every signal from which a route leads, and what distant signals show."""
    for signal in d.layout.signalling.signals:
        if routes := d.routes.of_signal[signal.id]:
            d.outputs += _lamps(d, signal, routes)
    for distant in d.layout.signalling.distants:
        clear = _clear(d, distant.of)
        d.outputs.append(
            Output(names.DISTANT_CLEAR(distant.id), clear, False, f"distant {distant.id}: {distant.of} shows clear")
        )
        d.outputs.append(Output(names.DISTANT_CAUTION(distant.id), neg(clear), True, f"distant {distant.id}: caution"))


def _lamps(d: Draft, signal: Signal, routes: Sequence[RouteRow]) -> Iterator[Output]:
    """The lamps of a signal, stop last: it is lit when no main, white or identifier lamp is."""
    g, said = signal.id, called("signal", signal.id)
    main, white = (_lit(_of_kind(routes, kind)) for kind in (RouteKind.MAIN, RouteKind.SHUNT))
    identified = disj(_showing(_of_kind(routes, RouteKind.IDENTIFIER)))
    if signal.main and d.layout.signalling.opens(g, False):
        clear = _clear(d, g)
        yield Output(names.CLEAR_ASPECT(g), clear, False, f"{said}: clear (green)")
        if cautions(d):
            yield Output(names.CAUTION_ASPECT(g), conj((main, neg(clear))), False, f"{said}: caution (yellow)")
    yield from _beside_main(d, g, routes)
    if signal.shunt:
        yield Output(names.SHUNT_ASPECT(g), white, False, f"{said}: shunt (white)")
    if calls := _of_kind(routes, RouteKind.CALL_ON):
        yield Output(names.CALL_ASPECT(g), disj(_showing(calls)), False, f"{said}: call-on, beside stop")
    if d.routes.identifies(g):
        note = f"{said}: identifier light, neither stop nor proceed"
        yield Output(names.IDENTIFIER_ASPECT(g), identified, False, note)
    yield Output(names.STOP_ASPECT(g), neg(disj((main, white, identified))), True, f"{said}: stop")


def _beside_main(d: Draft, g: SignalId, routes: Sequence[RouteRow]) -> Iterator[Output]:
    """What is lit beside a main lamp for some routes alone: second yellow, route indicator, speed indicators."""
    said = called("signal", g)
    if turned := [r for r in routes if r.signal.aspect.shows is Shows.TWO_YELLOWS]:
        note = f"{said}: second yellow lamp, over points reversed"
        yield Output(names.SECOND_YELLOW(g), _lit(turned), False, note)
    if branching := _indicated(d, g):
        yield Output(names.ROUTE_INDICATOR(g), _lit(branching), False, f"{said}: route indicator")
    for kmh, name in speeds(d, g).items():
        over = [r for r in _of_kind(routes, RouteKind.MAIN) if r.signal.speed.kmh == kmh]
        yield Output(name, _lit(over), False, f"{said}: speed indicator {kmh} km/h")


def _showing(routes: Sequence[RouteRow]) -> list[Expr]:
    """The signal shows its aspect for one of these routes."""
    return [var(names.SHOWING(r.number)) for r in routes]


def _lit(routes: Sequence[RouteRow]) -> Expr:
    """The same, or stays open for the movement that passes over one."""
    return disj((*_showing(routes), *_passing(routes)))


def _of_kind(routes: Sequence[RouteRow], kind: RouteKind) -> list[RouteRow]:
    return [r for r in routes if r.kind is kind]


def _clear(d: Draft, g: SignalId) -> Expr:
    if g not in d.routes.open_for_trains:
        return disj(())
    if cautions(d):
        return var(names.SHOWS_CLEAR(g))
    return _lit(_of_kind(d.routes.of_signal[g], RouteKind.MAIN))


def _passing(routes: Sequence[RouteRow]) -> list[Expr]:
    """Open for the movement that passes: a main signal with three aspects shows caution."""
    return [var(names.PASSING(r.number)) for r in routes if r.signal.closing.whole is not None]
