"""Something is forgotten: what the author forbids, with all else derived as always; a lamp that tells a driver to run
slower or where he is led; what a release, a berth or a trailed point has to ask; how long an addition is held.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace

from interlock.derivation import derive
from interlock.diag import Sink
from interlock.logic import names
from interlock.logic.controller import Controller, Equation
from interlock.logic.expr import FALSE, TRUE, Substitution, conj, disj, neg, var
from interlock.logic.lower import lower
from interlock.model.elements import BoundaryKind, BufferKind
from interlock.model.layout import Layout
from interlock.proof.mutation.ways import Mutant
from interlock.table.rows import InterlockingTable

Others = Callable[[Layout], Iterator[tuple[str, Layout]]]


def more(others: Others) -> Callable[[Layout, InterlockingTable], Iterator[Mutant]]:
    """The controllers of other layouts, where there are routes, and no others than with them."""

    def make(layout: Layout, table: InterlockingTable) -> Iterator[Mutant]:
        for place, other in others(layout):
            sink = Sink()
            derived = derive(other, sink)
            if derived.routes and not sink.has_errors and len(derived.routes) > len(table.routes):
                yield place, lower(other, derived)

    return make


def exclusions(layout: Layout) -> Iterator[tuple[str, Layout]]:
    """Each `exclude` is forgotten by itself."""
    for i, x in enumerate(layout.declared.excluded):
        yield (
            f"exclude {i + 1}: {x.reason}",
            replace(
                layout,
                declared=replace(
                    layout.declared, excluded=layout.declared.excluded[:i] + layout.declared.excluded[i + 1 :]
                ),
            ),
        )


def traps(layout: Layout) -> Iterator[tuple[str, Layout]]:
    """A trap counts as a buffer, before which routes end."""
    for b in layout.track.buffers:
        if b.kind is BufferKind.TRAP:
            more = tuple(replace(x, kind=BufferKind.STOP) if x is b else x for x in layout.track.buffers)
            yield b.node, replace(layout, track=replace(layout.track, buffers=more))


def entrances(layout: Layout) -> Iterator[tuple[str, Layout]]:
    """Trains leave over a boundary where they only come in."""
    for b in layout.track.boundaries:
        if b.kind is BoundaryKind.IN:
            more = tuple(replace(x, kind=BoundaryKind.BOTH) if x is b else x for x in layout.track.boundaries)
            yield b.node, replace(layout, track=replace(layout.track, boundaries=more))


def calls(layout: Layout) -> Iterator[tuple[str, Layout]]:
    """A signal calls trains on though the layout does not let it."""
    for g in layout.signalling.signals:
        if g.main and not g.call_on and layout.signalling.opens(g.id, False):
            more = tuple(replace(x, call_on=True) if x is g else x for x in layout.signalling.signals)
            yield g.id, replace(layout, signalling=replace(layout.signalling, signals=more))


def to_called_on(layout: Layout, table: InterlockingTable) -> Iterator[Mutant]:
    """Each `hostile` and each `demand` that chooses call-on routes alone is forgotten by itself."""
    others = [
        (
            f"hostile {i}: {x.reason}",
            replace(
                layout,
                declared=replace(layout.declared, barred=layout.declared.barred[: i - 1] + layout.declared.barred[i:]),
            ),
        )
        for i, x in enumerate(layout.declared.barred, 1)
        if x.one.called_on or x.other.called_on
    ]
    others += [
        (
            f"demand {i}: {x.reason}",
            replace(
                layout,
                declared=replace(
                    layout.declared, demanded=layout.declared.demanded[: i - 1] + layout.declared.demanded[i:]
                ),
            ),
        )
        for i, x in enumerate(layout.declared.demanded, 1)
        if x.routes.called_on
    ]
    for place, other in others:
        yield place, lower(other, derive(other, Sink()))


def speeds_dark(layout: Layout, table: InterlockingTable) -> Iterator[Mutant]:
    """A speed indicator is never lit."""
    c: Controller = lower(layout, table)
    for (g, kmh), name in c.symbols.aspects.speed.items():
        dark = tuple(replace(o, expr=FALSE) if o.name == name else o for o in c.outputs)
        yield f"{kmh} km/h at {g}", c.with_outputs(dark)


def second_dark(layout: Layout, table: InterlockingTable) -> Iterator[Mutant]:
    """A second yellow lamp is never lit."""
    c: Controller = lower(layout, table)
    for g, name in c.symbols.aspects.second.items():
        dark = tuple(replace(o, expr=FALSE) if o.name == name else o for o in c.outputs)
        yield str(g), c.with_outputs(dark)


def indicator_dark(layout: Layout, table: InterlockingTable) -> Iterator[Mutant]:
    """A route indicator is never lit."""
    c: Controller = lower(layout, table)
    for g, name in c.symbols.aspects.indicator.items():
        dark = tuple(replace(o, expr=FALSE) if o.name == name else o for o in c.outputs)
        yield str(g), c.with_outputs(dark)


def rear_not_asked(layout: Layout, table: InterlockingTable) -> Iterator[Mutant]:
    """The first section behind a signal is released behind a train whatever is still in rear of the signal."""
    c = lower(layout, table)
    for s, cleared in c.symbols.cancellation.rear_cleared.items():
        leaves = names.LEAVES(s)
        passed = next(x for x in c.steps if isinstance(x, Equation) and x.name == leaves).terms[0]
        seen = passed._replace(expr=Substitution({cleared: TRUE})(passed.expr))
        steps = (
            replace(x, terms=(seen, *x.terms[1:])) if isinstance(x, Equation) and x.name == leaves else x
            for x in c.steps
        )
        yield str(s), replace(c, steps=tuple(steps))


def rear_alone(layout: Layout, table: InterlockingTable) -> Iterator[Mutant]:
    """The first section behind a signal is released behind a train when the section in rear was seen clear since,
    whatever is in the approach before that."""
    c = lower(layout, table)
    timer = c.symbols.sections.release_timer
    for s, cleared in c.symbols.cancellation.rear_cleared.items():
        signals = [g for g in layout.signalling.signals if layout.track.section_of(g.into) == s]
        rear = {g.id: x for g in signals if (x := c.symbols.cancellation.approach_of.get(g.id)) is not None}
        told = Substitution({names.APPROACH_CLEAR(g): var(timer[x]) for g, x in rear.items() if x in timer})
        far = Substitution({t: TRUE for x, t in timer.items() if x not in rear.values()})
        following = tuple(
            replace(e, terms=(e.terms[0]._replace(expr=far(told(e.terms[0].expr))), *e.terms[1:]))
            if e.name == cleared
            else e
            for e in c.next
        )
        if following != tuple(c.next):
            yield str(s), replace(c, next=following)


def berth_read_once(layout: Layout, table: InterlockingTable) -> Iterator[Mutant]:
    """A movement is set into a berth as soon as what is in rear of another one reads clear, were it for one scan."""
    c = lower(layout, table)
    timer = c.symbols.sections.release_timer
    once = Substitution({name: neg(var(names.OCCUPIED(s))) for s, name in timer.items()})
    for e in c.equations:
        for i, t in enumerate(e.terms):
            now = t._replace(expr=once(t.expr))
            if t.kind == "no other movement into the berth" and now != t:
                early = replace(e, terms=(*e.terms[:i], now, *e.terms[i + 1 :]))
                yield str(e.name), replace(c, steps=tuple(early if x is e else x for x in c.steps))


def detection_forgotten(unseen: bool) -> Callable[[Layout, InterlockingTable], Iterator[Mutant]]:
    """That a machine was detected is forgotten with the inputs (`unseen`), or remembered of commanded ones alone."""

    def make(layout: Layout, table: InterlockingTable) -> Iterator[Mutant]:
        c = lower(layout, table)
        for (m, x), name in c.symbols.machines.was_detected.items():
            less = Substitution({name: FALSE}) if unseen else Substitution({})
            for e in (e for e in c.next if e.name == name):
                commanded = TRUE if unseen else disj((var(names.COMMAND(m, x)), neg(var(c.symbols.valid))))
                first = e.terms[0]._replace(expr=conj((less(e.terms[0].expr), commanded)))
                changed = replace(e, terms=(first, *e.terms[1:]))
                yield f"{m} {x}", replace(c, next=tuple(changed if y is e else y for y in c.next))

    return make


def let_go(layout: Layout, table: InterlockingTable) -> Iterator[Mutant]:
    """What the author added is given up when the train has passed its signal."""
    c = lower(layout, table)
    for r in c.symbols.routes:
        for e in c.next:
            if e.name == r.added:
                early = (e.terms[0], e.terms[1]._replace(expr=disj((var(names.GRANTED(r.number)), var(r.active)))))
                following = tuple(replace(e, terms=early) if x is e else x for x in c.next)
                yield r.id, replace(c, next=following)


def no_longer(layout: Layout, table: InterlockingTable) -> Iterator[Mutant]:
    """What the author has held longer is given up without that."""
    c = lower(layout, table)
    for r in c.symbols.routes:
        if r.path.hold_timer is not None:
            at_once = Substitution({r.path.hold_timer: TRUE})
            those = (r.added, r.path.hold_begun)
            shorter = tuple(
                replace(e, terms=tuple(t._replace(expr=at_once(t.expr)) for t in e.terms)) if e.name in those else e
                for e in c.next
            )
            yield r.id, replace(c, next=shorter)


def counted_early(layout: Layout, table: InterlockingTable) -> Iterator[Mutant]:
    """What the author has held longer is held for so long from the grant on, while the train may still be coming."""
    c = lower(layout, table)
    inputs = {t.name: t.input for t in c.timers}
    for r in c.symbols.routes:
        if r.path.hold_timer is not None:
            early = inputs[r.path.hold_timer]
            steps = tuple(
                replace(s, terms=s.terms[:1]) if isinstance(s, Equation) and s.name == early else s for s in c.steps
            )
            yield r.id, replace(c, steps=steps)


def begun_early(layout: Layout, table: InterlockingTable) -> Iterator[Mutant]:
    """That what is held longer would have been let go is remembered while the train may still be coming."""
    c = lower(layout, table)
    for r in c.symbols.routes:
        for e in c.next:
            if r.added is not None and e.name == r.path.hold_begun:
                always = (e.terms[0]._replace(expr=var(r.added)), *e.terms[1:])
                yield r.id, replace(c, next=tuple(replace(x, terms=always) if x is e else x for x in c.next))


def not_anew(layout: Layout, table: InterlockingTable) -> Iterator[Mutant]:
    """What is held longer is not held anew for a train for which the route is set again."""
    c = lower(layout, table)
    inputs = {t.name: t.input for t in c.timers}
    for r in c.symbols.routes:
        if r.path.hold_timer is not None:
            runs = inputs[r.path.hold_timer]
            steps = tuple(
                replace(s, terms=(s.terms[0], *s.terms[2:])) if isinstance(s, Equation) and s.name == runs else s
                for s in c.steps
            )
            yield r.id, replace(c, steps=steps)


def stand(layout: Layout, table: InterlockingTable) -> Iterator[Mutant]:
    """A train counts as arrived although it may still run towards what is shunted into its berth."""
    c = lower(layout, table)
    for e in c.next:
        for g, timer in c.symbols.overlaps.timer.items() if e.name.family is names.TRAIN_LOCK else ():
            over = Substitution({timer: TRUE})
            runs = replace(e, terms=tuple(t._replace(expr=over(t.expr)) for t in e.terms))
            if runs.terms != e.terms:
                yield f"{e.name} before {g}", replace(c, next=tuple(runs if x is e else x for x in c.next))
