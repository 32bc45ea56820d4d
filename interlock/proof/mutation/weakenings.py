"""Weakenings with a name: each kind weakens the table or the controller in one place.

A proof that cannot fail proves nothing: what becomes of each is told by `movements.py`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import partial
from itertools import islice

from interlock.dataclass import dataclass
from interlock.logic import names
from interlock.logic.controller import Controller, Equation, Join, StateVar, Term
from interlock.logic.expr import FALSE, TRUE, Expr, Substitution
from interlock.logic.lower import lower
from interlock.model.layout import Layout
from interlock.model.traversal import path_speed, topology
from interlock.proof.mutation import asked, blocked, forgotten, sharing
from interlock.proof.mutation.points import Mutation
from interlock.proof.mutation.swinging import swings_at_another_number, swung_at_once
from interlock.proof.mutation.ways import (
    Mutant,
    nothing_beyond,
    other_direction,
    overlap_inside,
    overlap_shorter,
    past_the_board,
    shorter,
)
from interlock.table.cells import PointDemand, RouteKind
from interlock.table.rows import InterlockingTable, RouteRow, TraversalRow

Make = Callable[[Layout, InterlockingTable], Iterator[Mutant]]


@dataclass(frozen=True)
class Kind:
    """A kind of weakening: its name, what it does, and its mutants."""

    name: str
    text: str
    make: Callable[[Layout, InterlockingTable], Iterator[Mutant]]


# --- weakenings of the controller ----------------------------------------------------------------


def _with(c: Controller, old: Equation, new: Equation) -> Controller:
    steps = tuple(new if s is old else s for s in c.steps)
    following = tuple(new if e is old else e for e in c.next)
    return replace(c, steps=steps, next=following)


def without(prefixes: str, *kinds: str) -> Callable[[Layout, InterlockingTable], Iterator[Mutant]]:
    """Drop one term of the given kinds from an equation whose name has one of the prefixes (separated by spaces)."""

    def make(layout: Layout, table: InterlockingTable) -> Iterator[Mutant]:
        c = lower(layout, table)
        for e in (*c.equations, *c.next):
            if e.name.sort not in prefixes.split():
                continue
            for i, t in enumerate(e.terms):
                if t.kind in kinds and t.expr is not TRUE:
                    less = replace(e, terms=e.terms[:i] + e.terms[i + 1 :])
                    yield f"{e.name} without {t.note or t.kind}", _with(c, e, less)

    return make


def _not_locked_at_restart(layout: Layout, table: InterlockingTable) -> Iterator[Mutant]:
    c = lower(layout, table)
    for i, s in enumerate(c.state):
        if s.name.family is names.RESTART_LOCK:
            changed = StateVar(s.name, False, s.note)
            outputs = tuple(o for o in c.outputs if o.name.family is not names.LOCKED_SHOWN)
            yield s.name, replace(c, state=(*c.state[:i], changed, *c.state[i + 1 :]), outputs=outputs)


def _validity_not_wired(layout: Layout, table: InterlockingTable) -> Iterator[Mutant]:
    c = lower(layout, table)
    always = Substitution({c.symbols.valid: TRUE})

    def blind(e: Equation) -> Equation:
        return replace(e, terms=tuple(t._replace(expr=always(t.expr)) for t in e.terms))

    steps = tuple(blind(s) if isinstance(s, Equation) else s for s in c.steps)
    yield names.VALID, replace(c, steps=steps, next=tuple(blind(e) for e in c.next))


# --- weakenings of the table ---------------------------------------------------------------------


def _relower(layout: Layout, table: InterlockingTable, key: tuple[str, int], row: TraversalRow) -> Controller:
    locks = tuple(row if t.key == key else t for t in table.locks)
    by_key = {t.key: t for t in locks}
    routes = []
    for r in table.routes:
        points: dict[str, PointDemand] = {}
        over = r.locking.overlap.ways if r.locking.overlap else ()
        for k in (*r.path.traversals, *over):
            for p in by_key[k].points:
                points.setdefault(p.machine, p)
        points |= {p.machine: p for p in r.locking.added}
        held = replace(r.locking, points=tuple(points.values()))
        routes.append(replace(r, locking=held) if key in (*r.path.traversals, *over) else r)
    return lower(layout, replace(table, locks=locks, routes=tuple(routes)))


def _points(role: str, wrong: bool) -> Callable[[Layout, InterlockingTable], Iterator[Mutant]]:
    def make(layout: Layout, table: InterlockingTable) -> Iterator[Mutant]:
        for t in table.locks:
            for i, p in enumerate(t.points):
                if p.role != role:
                    continue
                other = (replace(p, position=p.position.other),) if wrong else ()
                row = replace(t, points=t.points[:i] + other + t.points[i + 1 :])
                yield f"{t.section}:{t.number} {p.machine} {p.position}", _relower(layout, table, t.key, row)

    return make


def _exclusions(layout: Layout, table: InterlockingTable) -> Iterator[Mutant]:
    for t in table.locks:
        for i, e in enumerate(t.exclusions):
            row = replace(t, exclusions=t.exclusions[:i] + t.exclusions[i + 1 :])
            yield f"{t.section}:{t.number} against {e.section}", _relower(layout, table, t.key, row)


def _unguarded(kind: str) -> Callable[[Layout, InterlockingTable], Iterator[Mutant]]:
    """A machine follows a driven demand, or opens by itself, whether it may move or not."""

    def make(layout: Layout, table: InterlockingTable) -> Iterator[Mutant]:
        c = lower(layout, table)
        for e in c.equations:
            for i, t in enumerate(e.terms):
                if t.kind == kind and e.name.family is names.DEMANDED:
                    free = Substitution({names.MOVABLE(e.name.at[0]): TRUE})
                    more = replace(e, terms=(*e.terms[:i], t._replace(expr=free(t.expr)), *e.terms[i + 1 :]))
                    yield f"{e.name} although {t.note or t.kind}", _with(c, e, more)

    return make


def _blind_call_on(layout: Layout, table: InterlockingTable) -> Iterator[Mutant]:
    for r in table.routes:
        for i, c in enumerate(r.clear.sections if r.kind is RouteKind.CALL_ON else ()):
            less = replace(r, clear=replace(r.clear, sections=r.clear.sections[:i] + r.clear.sections[i + 1 :]))
            rows = tuple(less if x is r else x for x in table.routes)
            yield f"{r.id} without {c.section}", lower(layout, replace(table, routes=rows))


def _call_on_trusted(layout: Layout, table: InterlockingTable) -> Iterator[Mutant]:
    c = lower(layout, table)
    granted = Substitution({names.GRANTED(r.number): FALSE for r in c.symbols.routes if r.call_on})
    for e in c.next:
        terms = tuple(t._replace(expr=granted(t.expr)) for t in e.terms)
        if e.name.family is names.STALE and terms != e.terms:
            yield e.name, _with(c, e, replace(e, terms=terms))


def _closes_late(layout: Layout, table: InterlockingTable) -> Iterator[Mutant]:
    """A signal stays open for the whole movement although another may follow: vehicles stand before it."""
    passing = {r.entry for r in table.routes if r.signal.closing.whole is not None}
    for r in table.routes:
        if r.kind is RouteKind.CALL_ON or r.entry in passing or r.locking.approach.section is None:
            continue
        late = replace(r, signal=replace(r.signal, closing=replace(r.signal.closing, whole=r.locking.approach.section)))
        yield r.id, lower(layout, replace(table, routes=tuple(late if x is r else x for x in table.routes)))


def _short_approach(layout: Layout, table: InterlockingTable) -> Iterator[Mutant]:
    """Cancelling looks at the section in rear alone, whatever the braking distance."""
    coming = ((r.entry, r.locking.approach.coming) for r in table.routes)
    for g in {entry: None for entry, x in coming if x.further or x.unseen}:
        rows = tuple(_in_rear_alone(r) if r.entry == g else r for r in table.routes)
        yield g, lower(layout, replace(table, routes=rows))


def _in_rear_alone(r: RouteRow) -> RouteRow:
    approach = r.locking.approach
    approach = replace(approach, coming=replace(approach.coming, further=(), unseen=False))
    return replace(r, locking=replace(r.locking, approach=approach))


def _at_speed(layout: Layout, table: InterlockingTable, r: RouteRow, kmh: int | None) -> Controller:
    """A route shows another speed."""
    faster = replace(r, signal=replace(r.signal, speed=replace(r.signal.speed, kmh=kmh)))
    return lower(layout, replace(table, routes=tuple(faster if x is r else x for x in table.routes)))


def _entry_speed_forgotten(layout: Layout, table: InterlockingTable) -> Iterator[Mutant]:
    """A route shows the speed of its path, whatever its overlap is made for."""
    for r in table.routes:
        along = path_speed(layout, [topology(layout).traversals[s][n - 1] for s, n in r.path.traversals])
        if r.kind is RouteKind.MAIN and r.signal.speed.kmh != along:
            yield r.id, _at_speed(layout, table, r, along)


def _too_fast(layout: Layout, table: InterlockingTable) -> Iterator[Mutant]:
    """A route shows the speed of another one from the same signal."""
    for r in table.routes:
        others = {x.signal.speed.kmh for x in table.routes if x.entry == r.entry and x.kind is r.kind is RouteKind.MAIN}
        for kmh in sorted(v for v in others if v is not None and v > (r.signal.speed.kmh or v)):
            yield f"{r.id} at {kmh}", _at_speed(layout, table, r, kmh)


SWINGS = "SW"


def _outputs(change: Callable[[Controller], Iterator[tuple[str, str, Expr]]]) -> Make:
    """One output shows something else."""

    def make(layout: Layout, table: InterlockingTable) -> Iterator[Mutant]:
        c = lower(layout, table)
        for place, name, expr in change(c):
            shown = tuple(replace(o, expr=expr) if o.name == name else o for o in c.outputs)
            yield place, c.with_outputs(shown)

    return make


def _dark(c: Controller) -> Iterator[tuple[str, str, Expr]]:
    for g, name in c.symbols.aspects.stop.items():
        yield f"stop lamp of {g}", name, FALSE


def _undriven(c: Controller) -> Iterator[tuple[str, str, Expr]]:
    for (m, x), name in c.symbols.machines.drive.items():
        yield f"{m} {x}", name, FALSE


def _untold(c: Controller) -> Iterator[tuple[str, str, Expr]]:
    for what, name in c.symbols.indication.items():
        yield what, name, FALSE


def _preset(of: Callable[[int], int]) -> Make:
    """A delay of other milliseconds than those that are ordered."""

    def make(layout: Layout, table: InterlockingTable) -> Iterator[Mutant]:
        c = lower(layout, table)
        for t in c.timers:
            other = replace(t, preset_ms=of(t.preset_ms))
            yield t.name, replace(c, steps=tuple(other if s is t else s for s in c.steps))

    return make


def _held_number(layout: Layout, table: InterlockingTable) -> Iterator[Mutant]:
    """A number that is held asks in every scan."""
    c = lower(layout, table)
    for x, fresh in c.symbols.requests.fresh.items():
        e = next(e for e in c.next if e.name == fresh)
        always = replace(e, join=Join.ALL, terms=(Term(TRUE, "always"),))
        yield x, _with(c, e, always)


KINDS: tuple[Kind, ...] = (
    Kind("stop-lamp-dark", "a stop lamp is never lit", _outputs(_dark)),
    Kind("machine-not-driven", "a machine is never driven to a position", _outputs(_undriven)),
    Kind("indication-dark", "an indication or alarm is never lit", _outputs(_untold)),
    Kind("delay-too-short", "a delay is a millisecond shorter than ordered", _preset(lambda ms: ms - 1)),
    Kind("delay-beyond-count", "a delay of which a clock of 32 bits counts a part", _preset(lambda ms: ms + 2**31)),
    Kind("number-held", "a route number that is held asks again and again", _held_number),
    Kind(
        "set-while-occupied", "a route is set over a section that is reported occupied", without("WF", "section clear")
    ),
    Kind("released-by-nobody", "a section is given back although nobody asks for it", without("HR", "by hand")),
    Kind(
        "hostile-not-excluded",
        "a route is granted over a section that another holds",
        without("WF G AD", "section free"),
    ),
    Kind(
        "declared-not-excluded",
        "a route is granted beside one that the author declares hostile",
        without("G", "declared hostile"),
    ),
    Kind(
        "added-point-not-detected",
        "proceed is shown without detection of a point that the author has the route lock",
        without("CO", "added point detected"),
    ),
    Kind("added-not-clear", "proceed although a section demanded clear is not", without("CO", "added section clear")),
    Kind("diamond-not-excluded", "the exclusion over a diamond or foul joint is missing", _exclusions),
    Kind("board-passed", "a shunt route locks beyond its limit-of-shunt board", past_the_board),
    Kind("two-grants", "a route is granted without having been asked for, beside another", without("G", "requested")),
    Kind("point-missing", "a point demand of the path is missing", _points("path", False)),
    Kind("point-wrong", "a point demand of the path is in the wrong position", _points("path", True)),
    Kind("flank-missing", "a flank demand is missing", _points("flank", False)),
    Kind("flank-wrong", "a flank demand is in the wrong position", _points("flank", True)),
    Kind("section-missing", "the last section of a route is left out", shorter),
    Kind(
        "detection-not-required",
        "locked, and proceed shown, without detection of a point",
        without("WD", "path point detected", "flank point detected"),
    ),
    Kind(
        "lock-without-detection",
        "locked before the points of a way are detected",
        without("LK", "way lies"),
    ),
    Kind("way-not-supervised", "proceed stays whatever becomes of a way", without("CO", "way in order")),
    Kind("way-not-available", "a route is granted over a way that cannot be had", without("WF", "way available")),
    Kind("section-not-checked", "locked, and proceed shown, without a section clear", without("WL", "section clear")),
    Kind(
        "condition-not-checked",
        "proceed without an external condition or the line beyond",
        without("CO", "condition", "line beyond clear"),
    ),
    Kind("blocked-not-checked", "proceed over a blocked section", without("WP CO", "not blocked")),
    Kind("proceed-before-lock", "proceed before the route is locked", without("PR", "locked")),
    Kind("signal-not-dropped", "proceed stays when a condition is lost", without("PR", "conditions")),
    Kind("signal-open-behind-train", "the signal is not closed by the train", without("PR", "stays")),
    Kind("closes-late", "a signal stays open behind the first axle where another movement may follow", _closes_late),
    Kind(
        "stays-open",
        "a signal that is open for the movement that passes it stays so",
        without("PA", "still passing", "first section occupied"),
    ),
    Kind(
        "open-while-released", "a signal is still open when its locks are released", without("BT HR", "signal closed")
    ),
    Kind(
        "passing-not-supervised",
        "a signal stays open behind the first axle whatever happens",
        without("PA", "path point detected", "way detected", "not cancelled", "inputs valid", "not blocked"),
    ),
    Kind("cancel-not-obeyed", "proceed stays after a cancellation", without("PR", "not cancelled", "not cancelling")),
    Kind("cancel-with-train", "a route is cancelled while a train approaches", without("CD", "no train about to come")),
    Kind("approach-one-section", "nothing further back than the section in rear is looked at", _short_approach),
    Kind("cancel-occupied", "a route is cancelled with its first section occupied", without("CD", "long clear")),
    Kind("release-occupied", "a section is released under a train", without("HR", "long clear")),
    Kind(
        "release-by-hand-early",
        "a section is released by hand before a train that may come",
        without("HR", "no train about to come"),
    ),
    Kind("release-out-of-order", "a section is released before the one in rear", without("HR", "rear released")),
    Kind("withdraw-occupied", "a withdrawn lock goes under a train", without("CA", "long clear")),
    Kind("withdraw-early", "a withdrawn lock goes before the one in rear", without("CA", "rear released")),
    Kind("release-one-early", "automatic release before the train has gone on", without("BT", "went on")),
    Kind("release-unused", "automatic release without the section having been used", without("BT", "was used")),
    Kind("release-under-train", "automatic release of an occupied section", without("BT", "long clear")),
    Kind("clear-not-counted", "the release delay runs in an occupied section", without("RTI", "section clear")),
    Kind("restart-release-occupied", "an occupied section is released after a restart", without("SR", "long clear")),
    Kind("restart-unlocked", "a section is not locked at a restart", _not_locked_at_restart),
    Kind("use-without-rear", "a section counts as used although the rear is clear", without("NU", "rear occupied")),
    Kind("use-while-stale", "the three-point check goes on after inputs were lost", without("NU", "inputs never lost")),
    Kind("point-free-while-locked", "a machine may move in a locked section", without("MOV", "point section free")),
    Kind("point-free-under-train", "a machine may move in an occupied section", without("MOV", "point section clear")),
    Kind(
        "overlap-flank-not-held",
        "a machine may move although it protects the flank of an overlap",
        sharing.overlap_flank_not_held,
    ),
    Kind("flank-not-held", "a machine may move although it protects a flank", without("MOV", "flank not held")),
    Kind(
        "hand-beside-grant",
        "a machine is moved by hand in the scan of a grant",
        without("MAN", "no grant in this scan"),
    ),
    Kind("wrong-direction", "a lock stands for the wrong direction of travel", other_direction),
    Kind("fault-ignored", "a faulty detector is believed", without("OCC", "detector faulty")),
    Kind("lost-input-ignored", "lost inputs do not read as occupied", without("OCC", "inputs lost")),
    Kind("validity-not-wired", "the health of the inputs is not looked at", _validity_not_wired),
    Kind(
        "berth-under-train",
        "a shunting movement is set into a berth to which a train runs",
        without("G AD", "no train into the berth"),
    ),
    Kind(
        "berth-from-both-ends",
        "two shunting movements are set into one berth",
        without("G AD", "no other movement into the berth"),
    ),
    Kind("berth-read-once", "in rear of one who comes in clear is read once", forgotten.berth_read_once),
    Kind("arrived-early", "a train has arrived before it is wholly in", without("AR", "wholly in", "rear released")),
    Kind("arrived-running", "a train has arrived while it may run on to where others come in", forgotten.stand),
    Kind(
        "berth-released-early",
        "a berth is released in the scan in which a movement is set into it",
        without("CA", "nothing granted into it"),
    ),
    Kind("device-missing", "a level crossing or interlock is not demanded", _points("device", False)),
    Kind("device-wrong", "a level crossing or interlock is demanded open", _points("device", True)),
    Kind("opens-under-train", "a level crossing opens by itself while locked or occupied", _unguarded("returns")),
    Kind("driven-while-locked", "a driven point moves while it is locked", _unguarded("driven along")),
    Kind("blocked-point-moves", "a point of a blocked section moves for a route", blocked.point_moves),
    Kind("blocked-drive-runs", "the drive of a point runs on in a blocked section", blocked.drive_runs),
    Kind("door-beside-open", "a door of an air lock opens beside an open one", without("WA MAR", "other doors shut")),
    Kind("doors-at-once", "two doors of an air lock are opened in one scan", without("MAR", "no other door opens")),
    Kind("starts-under-train", "a point starts over a train that came since", without("ZS", "point section clear")),
    Kind("foul-not-checked", "proceed although a foul section is occupied", without("WD", "foul section clear")),
    Kind(
        "flank-space-not-checked",
        "proceed although something stands in the flank space, or a protecting signal is dark",
        without("WD", "flank space clear", "flank lamp intact"),
    ),
    Kind("zone-not-checked", "a route into a full zone is granted", without("G AD", "zone not full")),
    Kind("zone-miscounted", "a train in a zone does not count", without("ZB", "locked", "restart lock")),
    Kind("direction-not-checked", "proceed onto a line whose direction is not ours", without("CO", "direction ours")),
    Kind(
        "direction-given-early",
        "the direction is given away while a train leaves, is on the line, or has not been given before",
        without("BV", "line clear", "no departure"),
    ),
    Kind("direction-in-a-hurry", "the direction is given while it still changes", without("BV", "change complete")),
    Kind("direction-not-handed-over", "the direction stays here although it was given", without("BH", "not given")),
    Kind("identifier-unlocked", "an identifier light although nothing leads to it", without("PR", "rear locked")),
    Kind("identifier-not-shown", "a route past a signal opens at stop there", without("PR", "identifier shown")),
    Kind("identifier-nothing-beyond", "a route past a signal locks nothing beyond it", nothing_beyond),
    Kind("excluded-offered", "a route is offered that the author excludes", forgotten.more(forgotten.exclusions)),
    Kind("trap-entered", "a route leads into a trap", forgotten.more(forgotten.traps)),
    Kind("entrance-left-by", "a route leaves where trains only come in", forgotten.more(forgotten.entrances)),
    Kind("call-on-unasked", "a signal calls on that the layout does not let call on", forgotten.more(forgotten.calls)),
    Kind("added-let-go", "what the author added is given up when the train has passed the signal", forgotten.let_go),
    Kind("held-no-longer", "what is to be held longer is given up when the train is wholly in", forgotten.no_longer),
    Kind("held-from-the-grant", "what is to be held longer is held so from the grant on", forgotten.counted_early),
    Kind("hold-begun-under-way", "what is to be held longer counts as let go while under way", forgotten.begun_early),
    Kind("hold-not-begun-anew", "a route set again lets go with the seconds of its last train", forgotten.not_anew),
    Kind("added-to-called-on-forgotten", "what is added to call-on routes alone is forgotten", forgotten.to_called_on),
    Kind("rear-not-asked", "what is in rear of a signal is not asked for", forgotten.rear_not_asked),
    Kind("approach-not-asked", "of the approach the section in rear alone is asked for", forgotten.rear_alone),
    Kind(
        "order-not-asked",
        "a movement counts although it was not alone",
        without("OAI", "alone", "occupied", "not gone on yet"),
    ),
    Kind("arrived-unseen", "arrived while another may come", without("AR OTI", "approach seen clear")),
    Kind("speed-not-shown", "a speed is not shown", forgotten.speeds_dark),
    Kind("route-not-indicated", "a route indicator is not lit", forgotten.indicator_dark),
    Kind("one-yellow", "a second yellow lamp is not lit", forgotten.second_dark),
    Kind("speed-too-high", "a signal shows the speed of another route", _too_fast),
    Kind("entry-speed-forgotten", "a route shows more than its overlap is made for", _entry_speed_forgotten),
    Kind("lamp-not-proved", "a signal opens with its stop lamp out", without("PR", "stop lamp proved")),
    Kind("opens-by-itself", "a signal opens again when a lost condition returns", without("W", "conditions kept")),
    Kind("opens-after-block", "a signal opens when a block in its way is taken off", without("W", "unhindered")),
    Kind("call-on-after-loss", "a call-on opens after inputs were lost", without("UH", "inputs valid")),
    Kind("request-kept", "what is asked for while a condition is lost opens the signal later", asked.request_kept),
    Kind("trailed-not-kept-back", "proceed over a trailed point", without("WD", "not trailed")),
    Kind("trailed-unseen", "detection is forgotten as inputs are lost", forgotten.detection_forgotten(True)),
    Kind("trailed-uncommanded", "only what was commanded can be trailed", forgotten.detection_forgotten(False)),
    Kind("lamp-not-lit", "proceed with its lamp out", without("CO", "proceed lamp intact")),
    Kind("clear-lamp-not-lit", "clear with its lamp out", without("C", "clear lamp intact")),
    Kind("call-on-blind", "a train is called on without looking at its first section or at berths", _blind_call_on),
    Kind("call-on-again", "a signal that called a train on can be opened again", asked.call_on_again),
    Kind(
        "call-on-released-by-detection",
        "the three-point check goes on where a train was called on over a section that may report anything",
        _call_on_trusted,
    ),
    Kind("clear-before-stop", "clear although the next signal is at stop", without("C", "next signal open")),
    Kind("overlap-not-free", "a route is granted although its overlap is held", without("OF", "overlap free")),
    Kind("overlap-not-clear", "locked although the overlap is not in order", without("LK", "overlap lies")),
    Kind("overlap-not-checked", "proceed although the overlap is not in order", without("CO", "overlap lies")),
    Kind("overlap-not-held", "the overlap is given up at once", without("V", "held")),
    Kind("overlap-shorter", "an overlap without its last section", overlap_shorter),
    Kind("overlap-inside", "the short overlap inside a longer one is held for a fast train", overlap_inside),
    Kind(
        "overlap-timed-early",
        "the overlap's time runs before the train is wholly in",
        without("OTI", "wholly in", "rear released", "was used"),
    ),
    Kind("swing-unasked", "an overlap swings although nobody asks for it", without(SWINGS, "requested")),
    Kind("swing-misread", "an overlap swings at a number that names nothing", swings_at_another_number),
    Kind("swing-before-train", "an overlap swings while a train is close", without(SWINGS, "no train close")),
    Kind(
        "swing-into-held",
        "an overlap swings to track that others hold or stand on",
        without(SWINGS, "overlap free", "overlap clear", "not run over", "exclusion"),
    ),
    Kind("swing-at-once", "a swung overlap counts before it lies", swung_at_once),
    Kind("overlap-beside", "an overlap is held beside one that lies otherwise", sharing.beside_another),
    Kind("overlap-let-go", "an overlap is given up with another over the same track", sharing.let_go_with_another),
    Kind("overlap-under-train", "an overlap is given up under a train", sharing.given_up_under_train),
    Kind("overlap-free-of-one", "track that two overlaps hold is free when one is given up", sharing.free_of_one),
    Kind("overlap-taken", "a route is set over a section that is held as overlap", without("FREE", "no overlap")),
    Kind("proceed-on-lost-input", "proceed stays when inputs are lost", without("CO", "inputs valid")),
)


def weakenings(layout: Layout, table: InterlockingTable, every: bool) -> Iterator[Mutation]:
    """The mutants of each kind as mutations: all of them, or the first of each kind."""
    for kind in KINDS:
        for place, controller in islice(kind.make(layout, table), None if every else 1):
            family = f"weakened: {kind.name}"
            yield Mutation(family, kind.name, (place,), partial(_made, controller), alike=family)


def _made(controller: Controller) -> Controller:
    return controller
