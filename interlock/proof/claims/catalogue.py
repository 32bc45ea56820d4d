"""The claims, in the field's words.  Each class has a stable id, a sentence and its instances.

Train level: T-...; signal level: S-...; locking level: L-...; points: P-....
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import chain, starmap

from interlock.logic import names
from interlock.logic.expr import FALSE, TRUE, Expr, at_most_one, conj, disj, eq, iff, implies, neg, var
from interlock.logic.plant import accepted, came, has_token, o, rests, shunting
from interlock.logic.symbols import RouteSymbols
from interlock.model.elements import SectionId, SignalId
from interlock.model.principles import Caution
from interlock.model.traversal import zone_joints
from interlock.proof.claims.added import declared, demanded, held
from interlock.proof.claims.aspects import (
    allows_clear,
    at_speed,
    branching,
    clear_aspect,
    devices_closed,
    distants,
    entry,
    nothing_foul,
    overlap_ready,
    past_identifier,
    shows_open,
    two_yellows,
)
from interlock.proof.claims.excluded import excluded
from interlock.proof.claims.flank import flank, scissors
from interlock.proof.claims.identifiers import identifiers
from interlock.proof.claims.kinds import Claim, Facts
from interlock.proof.claims.paths import Shown, SignalPath, exit_of, ground_of, lie, shown_over, signal_paths
from interlock.proof.claims.points import points
from interlock.proof.claims.reasons import reasons
from interlock.proof.claims.space import flank_space
from interlock.proof.claims.terminals import terminals

CLAIMS: dict[str, str] = {
    "T-COLLISION": "No train comes into a section in which another train stands, nor two at once, shunting on sight in "
    "a berth apart.",
    "T-DIAMOND": "No two trains are on the two arms of a diamond crossing, unless both have stood there since the "
    "restart and nobody has called either.",
    "T-FOUL": "No train passes a point while another stands foul of it, unless both have stood there since the restart "
    "and nobody has called either.",
    "T-DERAIL": "No train meets a point that is moving or set against it.",
    "T-POINT-MOVES": "No point moves under a train, and no train comes to a point that moves.",
    "T-ROAD": "No train is on a level crossing, bridge or other interlock that is not closed for it, but one that has "
    "stood there since the restart and that nobody has called.",
    "T-FLANK": "While a train uses a point or diamond, or may overrun a signal over it, no vehicle can roll into it "
    "from the flank.",
    "T-SCISSORS": "While a train uses one crossover of a scissors, the other one lies normal.",
    "T-ZONE": "A train comes into a zone only where it was called in, and is called in only while the trains in it or "
    "called into it, this one too, are no more than the zone's maximum.",
    "T-LINE": "On a line with a direction token no train leaves against one that is on the line or about to come in.",
    "S-OPPOSING": "No two signals that lead towards each other over the same track show proceed.",
    "S-HOSTILE": "No two signals show proceed onto paths that share a section, a diamond or a foul joint.",
    "S-CLEAR": "A signal opens, and stays open until a movement begins to pass it, only when every section of the "
    "path, as the points lie, is steadily clear: reported clear without a break for the release delay; but for the "
    "berth in which a shunting movement ends, and for calling on.",
    "S-PASSING": "A signal that stays open until the whole movement has passed does so only while the sections "
    "before and beyond it are not reported clear, and no second movement can take it for itself.",
    "S-CALL-ON": "A train is called on only where the layout lets the signal call on, only beside stop, once only, "
    "into a steadily clear first section, and onto no track in which vehicles may stand unless it is steadily clear.",
    "S-DETECTED": "Proceed is shown only when every point and device of the path is detected in that very scan.",
    "S-TRAILED": "No proceed is shown over a point that was trailed and has not been looked at since.  One that is "
    "driven counts as trailed when its detection is lost without a command, commanded before or not, or is not there "
    "again when lost inputs come back; nothing is remembered of it until the restart delay is over.",
    "S-LOCKED": "Proceed is shown only when every section of the path is locked for it and its points really lie so, "
    "as they must for the route for which the signal opens.",
    "S-FLANK": "Proceed is shown over a point or diamond only when no vehicle can roll into it from the flank.",
    "S-SCISSORS": "Proceed is shown over one crossover of a scissors only while the other one lies normal.",
    "S-FLANK-SPACE": "Where the principles ask for it: proceed is shown only while the flank space is steadily clear, "
    "but for sections over which, or from which, another movement may be called meanwhile, and the stop lamps of the "
    "signals that protect it are intact.",
    "S-OVERLAP": "Proceed to a signal with an overlap is shown only when one is steadily clear and not blocked, lies "
    "and is detected, its devices are closed, the conditions over it hold, nothing can stand foul of it, and where the "
    "principles ask for it its flank space is steadily clear and protecting stop lamps are intact.",
    "S-CONDITION": "Proceed is shown only when every condition of the path holds, the line beyond is steadily "
    "clear, and nothing can stand foul of the path.",
    "S-EXCLUDED": "No proceed is shown over a path that no route may take: that the author excludes, alone or past a "
    "signal at identifier light, that ends in a trap or leaves where trains only come in, that begins at a board, or "
    "that leads over a hand-worked point against its key, twice over one diamond, or through a section without "
    "detection; and no train is called on over a path of which the author excludes the call-on route.",
    "S-DECLARED": "No two signals show proceed for routes that the author declares hostile, and no two such routes are "
    "held at once, each from proceed on until its train is wholly in its last section.",
    "S-DEMANDED": "Proceed is shown only while the points that the author has the route lock are detected so in that "
    "very scan, and were not trailed; they stay commanded so until the train is wholly in its last section; "
    "and only while the sections that it has the route find clear are steadily clear.",
    "S-DIRECTION": "Proceed onto a line with a direction token is shown only while the direction is ours, and then the "
    "neighbour has it not.",
    "S-BLOCKED": "No proceed is shown over a blocked section.",
    "S-LOST-INPUT": "When inputs are lost, every signal shows stop at once, and nothing is granted or released.",
    "S-ASPECT": "Where signals have a caution aspect, clear is shown only when the next signal is open or the line "
    "beyond is checked; a distant shows clear only when its signal does; where the principles ask for two yellows, a "
    "main signal that opens shows the second one over every path with a reversed point that does not lead out onto a "
    "checked line, and a route indicator is lit for a departure by a main signal exactly where the layout has one for "
    "that direction.",
    "S-SPEED": "No signal shows a higher speed than its path permits, as the points lie; where the layout states a "
    "speed for the path, a main signal that opens shows one.",
    "S-ENTRY": "A main signal that is open to a signal with an overlap that is made for a speed shows a speed, and "
    "none above that one, as the overlap's points lie.",
    "S-LAMP": "Where lamps are reported: a signal opens only while its stop lamp is intact, shows a main aspect only "
    "while a lamp for it is, its identifier light only while that is, a second yellow lamp only while it "
    "is intact, and a speed only while its indicator is.  (White and call-on lamps, route indicators, and the lamps of "
    "distants are not reported.)",
    "S-STOP": "At every signal stop is lit exactly when no main, white or identifier lamp is; no two of these are lit "
    "at once, a speed only beside a main lamp, a second yellow only beside the first, a route indicator only beside a "
    "main lamp, none that speaks to movements of which the layout does not let the signal speak, and a distant signal "
    "shows either clear or caution.",
    "S-AGAIN": "A signal that closed while its route stayed set, or in whose path a section was blocked or a point was "
    "trailed meanwhile, opens only in the scan after one in which it was asked for again; one that calls on not at "
    "all, nor when inputs were lost meanwhile, before its route is set anew.",
    "S-REQUEST": "A route is set only in the scan in which its number comes after 0, or while its switch for automatic "
    "working is on, and an overlap swings only when its number comes so; a number that is held asks once.  What is "
    "locked past a signal that a route passes is set with that route alone.  A signal is open only for a route that is "
    "set, or for the movement that passes it.",
    "S-CANCELLED": "A cancelled signal shows stop in the same scan.",
    "S-SET": "A section is locked for a movement only when inputs are valid, it is not blocked or locked, and it is "
    "steadily clear; for calling on, and where a shunting movement ends, it need be neither clear nor unlocked.  A "
    "shunting movement is set into vehicles only while no train is called in, nothing is set in at another end, and "
    "all is steadily clear in rear of what came in there past a signal.",
    "S-BOARD": "No section is locked past the place where a movement must end: past a stop board for nobody, past a "
    "limit-of-shunt board for trains only, past a shunt signal at which trains end for shunting movements only.",
    "S-IDENTIFIER": "A signal shows its identifier light alone, neither stop nor proceed beside it, and only while the "
    "section before it is firmly locked, with its points detected, towards it for a train; for a route that leads "
    "past it proceed is shown only while it does.",
    "L-REASON": "No lock ends without its reason: a train has used the section, the lock before it was withdrawn, its "
    "signal was cancelled, or somebody releases it by hand, alone or with all that may have missed a train; after a "
    "restart by hand, or behind a train that stood there.  No reason is recorded unless its event happened; what a "
    "section remembers of its train ends with its lock, and a lock once firm, with its points detected, stays so; and "
    "none ends, but by its own signal, before the one in rear that leads into it; and a berth into which shunting "
    "movements come towards a train stays locked for the train until it has stood by time, or the berth is released.",
    "L-CLEAR": "No section is released, however it is, before it has been reported clear with valid inputs, without a "
    "break, for the release delay.",
    "L-APPROACH": "A route whose signal has been open is not given up before its train came, unless none can be on "
    "its way: all is steadily clear within the braking distance and back to the first signal that announces this "
    "one, over ways that are locked; or stop has been shown without a break for as long as a train needs to stand; "
    "nor is the first section behind it released behind its train without that, unless it was so since the train came "
    "in, or a shunting movement, or one from where there is no detection, was seen in it alone first; nor does the "
    "train count as arrived there before, or is the overlap beyond let go.  (Whether it has been open is the "
    "controller's own bit, which is set with proceed and stays while the route does, and until its train has come or "
    "the lock behind its signal ends.)",
    "L-RELEASE": "No section is released while a train stands in it, comes into it, or has been called into it.",
    "L-HELD": "A section in which a train moves is locked.",
    "P-LOCKED": "A point is commanded to move only when the sections of all its ends are steadily clear and unlocked, "
    "or held by nothing but an overlap that may swing, with the section before its signal steadily clear; its drive "
    "begins to run only while they are steadily clear.  (The command is the controller's own bit; P-DRIVEN ties the "
    "drives to it.)  A level crossing or bridge may always be closed.",
    "P-BLOCKED": "A point, a section of which is blocked, is commanded to move only by hand, and driven only as long "
    "as it is moved by hand, or until it has turned where an overlap swings: whoever works there is not to have it "
    "move for a route.",
    "P-AIR-LOCK": "Of the doors of an air lock never more than one is commanded open, and one begins to be commanded "
    "open only in a scan in which all others are reported shut.  (The command is the controller's own bit; P-DRIVEN "
    "ties the drives to it.)",
    "P-DRIVEN": "A machine is driven to where it is commanded, and never both ways: at once, or where machines start "
    "one after the other, when its turn has come; but not while its drive is kept off for a blocked section; nor is it "
    "commanded both ways.",
    "I-TOLD": "Every indication and alarm tells what is: a section is locked, a detector is faulty, a machine is not "
    "where it was commanded or was trailed, a zone is full.",
    "D-PRESET": "No delay is shorter than the principles order, nor than the world needs: by speeds, braking, reaction "
    "and the delay of outputs, running times of machines, and what is agreed with the neighbour; and none longer than "
    "a TIME of 32 bits counts, some 24 days: a clock that begins anew runs out at once.",
    "P-START": "When the restart delay is over, whatever happened meanwhile, nothing is commanded but crossings and "
    "bridges to close, all signals show stop, every section is locked, and of no train it is said that it went on, or "
    "was missed.",
}


def claims(f: Facts) -> tuple[Claim, ...]:
    """Every instance of every claim, but for places at which there is nothing to claim."""
    found = chain(
        ((f"T-{h.id}", h.place, neg(h.expr)) for h in f.plant.hazards),
        flank(f),
        scissors(f),
        _zones(f),
        flank_space(f),
        _pairs(f),
        excluded(f),
        declared(f),
        demanded(f),
        held(f),
        _signals(f),
        terminals(f),
        distants(f),
        _again(f),
        _requests(f),
        _set(f),
        _boards(f),
        identifiers(f),
        reasons(f),
        _locks(f),
        points(f),
    )
    order = {id_: n for n, id_ in enumerate(CLAIMS)}
    return tuple(sorted(filter(_says, starmap(Claim, found)), key=lambda c: (order[c.id], c.place)))


def _says(c: Claim) -> bool:
    """Whether something is claimed: an overlap without a signal before it, say, leaves nothing to be claimed of it.

    A preset is compared with what it has to be when the claim is written, so that one that is long enough leaves T.
    """
    return c.expr is not TRUE or c.id == "D-PRESET"


def _zones(f: Facts) -> Iterator[tuple[str, str, Expr]]:
    for z in f.layout.declared.zones:
        yield "T-ZONE", z.id, neg(f.zones.overfull.get(z.id, FALSE))
        for s, j in zone_joints(f.topo, z):
            rear = f.topo.beyond(s, j)
            boundary = f.layout.track.boundary_at.get(j)
            where = rear or (boundary.approach if boundary and boundary.approach else names.outside(j))
            comes = f.plant.events.get(names.HEAD(j, where), FALSE)
            yield "T-ZONE", f"{z.id} at {j}", implies(comes, f.zones.called_in(s, j))


# --- signals -------------------------------------------------------------------------------------


def _apart(a: dict[Shown, Expr], b: dict[Shown, Expr]) -> Expr:
    """No signal of the one and another of the other show proceed at once."""
    both = a.keys() & b.keys()
    out = [neg(conj((disj(x for w, x in a.items() if w not in both), disj(b.values()))))]
    out += [neg(conj((a[w], disj(x for v, x in b.items() if v != w)))) for w in sorted(both)]
    return conj(out)


def _pairs(f: Facts) -> Iterator[tuple[str, str, Expr]]:
    """No two signals show proceed over the same track, place by place.

    Two paths that share track differ somewhere: in the way through a section, where they meet; or the one begins at a
    signal that the other passes; or they are of one signal for trains and for shunting movements.  So a claim for each
    section and for each signal says it of all pairs, and their number grows with the layout, not with its square.
    """
    ground = ground_of(f)
    for s in f.topo.sections:
        ways = [t for t in f.topo.traversals[s] if t.key in ground.over]
        shown = {t.key: disj(shown_over(ground, [t]).values()) for t in ways}
        bad: dict[str, list[Expr]] = {}
        for i, t in enumerate(ways):
            for x in ways[i + 1 :]:
                opposing = t.entry == x.exit or t.exit == x.entry
                kind = "S-OPPOSING" if opposing else "S-HOSTILE"
                bad.setdefault(kind, []).append(conj((shown[t.key], shown[x.key])))
        for kind, cases in sorted(bad.items()):
            yield kind, s, neg(disj(cases))
    for g in f.layout.signalling.signals:
        one = [f.sym.aspects.signal(g.id, k) for k in f.track.functions(g.id)] + [disj(ground.past.get(g.id, ()))]
        yield "S-HOSTILE", f"signal {g.id}", at_most_one(one)
    for c in f.layout.pointwork.crossings:
        arms = [
            shown_over(ground, (t for s in f.topo.sections for t in f.topo.traversals[s] if (c.id, arm) in t.crossings))
            for arm in (0, 1)
        ]
        yield "S-HOSTILE", f"diamond {c.id}", _apart(*arms)
    for fj in f.track.fouls:
        section, beside = f.topo.traversals[fj.section], f.topo.traversals[fj.neighbour]
        over, near = shown_over(ground, filter(fj.fouls, section)), shown_over(ground, filter(fj.touches, beside))
        yield "S-HOSTILE", f"joint {fj.section}/{fj.neighbour} foul of {fj.element}", _apart(over, near)


def _who(g: SignalId, shunt: bool) -> str:
    return f"{g} shunt" if shunt else g


def _signals(f: Facts) -> Iterator[tuple[str, str, Expr]]:
    """Claims about the scan that shows proceed: new outputs against the inputs of that scan."""
    for signal, shunt in ((g.id, k) for g in f.layout.signalling.signals for k in f.track.functions(g.id)):
        shows = f.after(f.sym.aspects.signal(signal, shunt))
        paths = signal_paths(f, signal, shunt)
        yield from _signal(f, signal, shunt, shows, paths)
        for k, path in enumerate(paths, 1):
            here = conj((shows, f.after(lie(f, path.ways))))
            if here is not FALSE:
                for id_, what, x in _path(f, signal, shunt, path, here):
                    yield id_, f"{_who(signal, shunt)}:{k}{what}", x


def _signal(
    f: Facts, signal: SignalId, shunt: bool, shows: Expr, paths: Sequence[SignalPath]
) -> Iterator[tuple[str, str, Expr]]:
    """Claims about a signal that shows proceed, whichever path lies before it."""
    after, who = f.after, _who(signal, shunt)
    yield "S-LOST-INPUT", who, implies(neg(var(f.sym.valid)), neg(shows))
    yield "S-LOCKED", who, implies(shows, after(disj(lie(f, p.ways) for p in paths)))
    passing = after(f.sym.routes.passing(signal, shunt))
    if passing is not FALSE:
        alone = FALSE if f.sym.cancellation.approach_of[signal] in f.topo.standing else _still_passing(f, signal, shunt)
        yield "S-PASSING", who, implies(passing, alone)
    if signal in f.sym.lamp_proof.stop:
        opens = conj((shows, neg(f.sym.aspects.signal(signal, shunt))))
        yield "S-LAMP", who, implies(opens, var(f.sym.lamp_proof.stop[signal]))
    if signal in f.sym.lamp_proof.clear and not shunt:
        last = f.sym.lamp_proof.caution.get(signal, f.sym.lamp_proof.clear[signal])
        lit = implies(clear_aspect(f, signal), var(f.sym.lamp_proof.clear[signal]))
        main = after(disj(map(var, f.sym.aspects.main_lamps(signal))))
        yield "S-LAMP", f"{who} proceed", conj((implies(main, var(last)), lit))
    if signal in f.sym.lamp_proof.identifier and not shunt:
        lit = implies(after(f.sym.aspects.identifies(signal)), var(f.sym.lamp_proof.identifier[signal]))
        yield "S-LAMP", f"{who} identifier", lit
    if signal in f.sym.lamp_proof.second and not shunt:
        lit = implies(after(var(f.sym.aspects.second[signal])), var(f.sym.lamp_proof.second[signal]))
        yield "S-LAMP", f"{who} second yellow", lit
    if signal in f.sym.lamp_proof.speed and not shunt:
        told = after(disj(var(n) for (g, _), n in f.sym.aspects.speed.items() if g == signal))
        yield "S-LAMP", f"{who} speed", implies(told, var(f.sym.lamp_proof.speed[signal]))
    if signal in f.sym.cancellation.cancelling:
        yield "S-CANCELLED", who, implies(var(f.sym.cancellation.cancel[signal]), neg(shows))


def _path(f: Facts, signal: SignalId, shunt: bool, path: SignalPath, here: Expr) -> Iterator[tuple[str, str, Expr]]:
    """Claims about a path while its signal shows proceed and its points lie (`here`): id, what of the path, claim."""
    after = f.after
    lit = FALSE if shunt else f.sym.aspects.identifies(signal)
    opened = conj((after(disj((shows_open(f, signal, shunt), lit))), after(lie(f, path.ways))))
    yield "S-CLEAR", "", implies(opened, conj(f.seen.steadily_clear(t.section) for t in path.kept_clear))
    if signal in f.sym.aspects.call_on and f.layout.signalling.signal[signal].call_on and not shunt:
        called = conj((after(var(f.sym.aspects.call_on[signal])), here))
        yield "S-CALL-ON", "", implies(called, _may_call_on(f, path))
    yield "S-DETECTED", "", implies(here, _points_detected(f, path))
    if not shunt:
        for what, x in at_speed(f, signal, path, here):
            yield "S-SPEED", what, x
    machines = (f.layout.pointwork.point[p].machine for t in path.ways for p, _ in t.points)
    trailed = [neg(var(f.sym.machines.trailed[m])) for m in dict.fromkeys(machines) if m in f.sym.machines.trailed]
    if trailed:
        yield "S-TRAILED", "", implies(here, conj(trailed))
    exit_ = exit_of(f, path)
    over = () if exit_ is None or shunt else f.track.overlap_paths(exit_)
    if over and exit_ is not None:
        yield "S-OVERLAP", "", implies(here, disj(overlap_ready(f, ways) for ways in over))
        if exit_ in f.sym.overlaps.swings:
            yield "S-OVERLAP", "stays", implies(here, neg(after(var(f.sym.overlaps.swings[exit_]))))
        yield from entry(f, signal, path, exit_, over)
    if not shunt and f.layout.principles.caution is not Caution.NEVER:
        clear = conj((clear_aspect(f, signal), after(lie(f, path.ways))))
        yield "S-ASPECT", "", implies(clear, allows_clear(f, path))
        yield from two_yellows(f, signal, path)
    if not shunt:
        yield from branching(f, signal, path)
    if not shunt:
        yield from past_identifier(f, signal, path, here)
    secured = devices_closed(f, path.ways)
    if secured:
        yield "S-DETECTED", " devices", implies(here, conj(secured))
    barred = [neg(var(f.sym.sections.blocked[t.section])) for t in path.ways if t.section in f.sym.sections.blocked]
    yield "S-BLOCKED", "", implies(here, conj(barred))
    yield "S-LOCKED", "", implies(here, after(_path_locked(f, shunt, path)))
    yield from _beyond_the_path(f, signal, shunt, path, here)


def _points_detected(f: Facts, path: SignalPath) -> Expr:
    """Every point of a path is detected as it must lie, and not otherwise."""
    ends = [(f.layout.pointwork.point[p].machine, x) for t in path.ways for p, x in t.points]
    return conj(
        conj((var(f.sym.machines.detected[m, x]), neg(var(f.sym.machines.detected[m, x.other])))) for m, x in ends
    )


def _path_locked(f: Facts, shunt: bool, path: SignalPath) -> Expr:
    """Every section of a path is firmly locked for its way, and for what the signal calls."""
    own = path.kept_clear
    locked = [f.locking.lock(t.section, t.number) for t in own if (t.section, t.number) in f.sym.sections.lock]
    kind = [neg(f.locking.train(t.section)) if shunt else f.locking.train(t.section) for t in own]
    ok = conj([*locked, *kind, *(f.locking.firm(t.section) for t in own)]) if len(locked) == len(own) else FALSE
    return ok if path.berth is None else conj((ok, f.locking.held(path.berth), neg(f.locking.train(path.berth))))


def _beyond_the_path(
    f: Facts, signal: SignalId, shunt: bool, path: SignalPath, here: Expr
) -> Iterator[tuple[str, str, Expr]]:
    """External conditions, the direction of the line beyond, and what may stand foul of the path."""
    needed = [
        var(f.sym.condition[c.id])
        for c in f.layout.signalling.conditions
        if signal in c.signals
        or any(t.section in c.over for t in path.ways)
        or (not shunt and path.ways[-1].exit in c.exits)
    ]
    boundary = f.layout.track.boundary_at.get(path.ways[-1].exit)
    if boundary is not None and boundary.node in f.sym.token and not shunt:
        ours = conj((var(f.sym.token[boundary.node].have), neg(has_token(boundary.node, "has"))))
        yield "S-DIRECTION", "", implies(here, f.after(ours))
    if boundary is not None and boundary.approach is not None and not shunt:
        needed.append(f.seen.steadily_clear(boundary.approach))
    needed += nothing_foul(f, path.ways)
    if needed:
        yield "S-CONDITION", "", implies(here, conj(needed))


def _still_passing(f: Facts, g: SignalId, shunt: bool) -> Expr:
    """A signal stays open for one movement alone: it was open, that movement occupies the sections before and beyond
    it, and none in rear of it may take the signal for itself."""
    first, rear = f.layout.track.section_of(f.layout.signalling.signal[g].into), f.sym.cancellation.approach_of[g]
    assert rear is not None
    occupied = [neg(f.seen.clear(s)) for s in (first, rear) if s in f.sym.sections.clear]
    name = names.accepted(g, shunt)
    second = conj((f.after(f.seen.been(first)), f.after(var(name)))) if name in f.plant.state else FALSE
    return conj([f.sym.aspects.signal(g, shunt), *occupied, neg(second)])


def _may_call_on(f: Facts, path: SignalPath) -> Expr:
    """A train may be called on over a path: R2."""
    stop = f.after(var(f.sym.aspects.stop[path.signal]))
    standing = [t.section for i, t in enumerate(path.ways) if i == 0 or t.section in f.topo.berths]
    return conj([stop, *map(f.seen.steadily_clear, standing)])


def _requests(f: Facts) -> Iterator[tuple[str, str, Expr]]:
    """`fresh` is the controller's own bit; what it may mean is claimed too."""
    after, valid = f.after, var(f.sym.valid)
    for x, fresh in f.sym.requests.fresh.items():
        yield "S-REQUEST", x, iff(after(var(fresh)), conj((valid, eq(x, 0))))
        yield "S-REQUEST", f"{x} seen", iff(after(var(f.sym.requests.seen[x])), neg(after(var(fresh))))
    for sig, number in f.sym.overlaps.swing_request.items():
        swings = var(f.sym.overlaps.swings[sig])
        yield (
            "S-REQUEST",
            f"{sig} swings",
            implies(conj((after(swings), neg(swings))), f.sym.requests.asked(number)),
        )
    for g, shunt in ((h.id, k) for h in f.layout.signalling.signals for k in f.track.functions(h.id)):
        shown = implies(after(f.sym.aspects.signal(g, shunt)), after(f.sym.routes.opened(g, shunt)))
        yield "S-REQUEST", f"{_who(g, shunt)} shown", shown
    for r in f.sym.routes:
        lying = after(lie(f, tuple(f.topo.traversals[s][n - 1] for s, n in r.path.ways)))
        yield "S-LOCKED", f"{r.id} lies", implies(after(var(r.proceed)), lying)
        yield "S-REQUEST", f"{r.id} open", implies(after(var(r.proceed)), after(var(r.active)))
        new = conj((after(var(r.active)), neg(var(r.active))))
        if r.path.identifier:
            with_ = (f.sym.routes.number[n] for n in r.path.parts_of)
            together = disj(conj((after(var(x.active)), neg(var(x.active)))) for x in with_)
            yield "S-REQUEST", r.id, implies(new, together)
            continue
        switch = [var(f.sym.requests.automatic[r.number])] if r.number in f.sym.requests.automatic else []
        yield "S-REQUEST", r.id, implies(new, disj((f.sym.requests.asked(r.number), *switch)))


def _set(f: Facts) -> Iterator[tuple[str, str, Expr]]:
    """R6, way by way, in the scan in which it is locked."""
    for (s, n), name in f.sym.sections.lock.items():
        new = conj((f.after(var(name)), neg(var(name))))
        blocked = [neg(var(f.sym.sections.blocked[s]))] if s in f.sym.sections.blocked else []
        occupied = any(r.call_on or r.path.berth == (s, n) for r in f.sym.routes.over.get((s, n), ()))
        free = (
            []
            if occupied
            else [neg(f.locking.locked(s)), *([f.seen.steadily_clear(s)] if s in f.sym.sections.clear else [])]
        )
        yield "S-SET", f"{s} {n}", implies(new, conj((var(f.sym.valid), *blocked, *free)))
    for r in f.sym.routes:
        if r.path.berth is not None:
            new = conj((f.after(var(r.active)), neg(var(r.active))))
            yield "S-SET", f"{r.id} into a berth", implies(new, _nobody_comes_in(f, *r.path.berth))


def _nobody_comes_in(f: Facts, s: SectionId, n: int) -> Expr:
    """R2: no train is called into a berth, and of what comes in at another end than a movement all has come in: a
    reading of clear in rear of it that does not last is none (R15)."""
    out = [neg(f.locking.train(s)), *map(neg, f.locking.overlaps(s))]
    for j in f.topo.ends[s]:
        rear = f.topo.beyond(s, j)
        if j == f.track.way(s, n)[0]:
            continue
        if (j, s) in f.topo.signal_into:
            boundary = f.layout.track.boundary_at.get(j)
            behind = rear if boundary is None else boundary.approach
            came = conj((f.seen.used(s), FALSE if behind is None else f.seen.steadily_clear(behind)))
            out.append(implies(f.locking.locked_in(s, j), came))
        elif rear is not None:
            out.append(neg(f.locking.locked_out(rear, j)))
    return conj(out)


def _boards(f: Facts) -> Iterator[tuple[str, str, Expr]]:
    """Way by way past a board, or past a shunt signal at which trains end, in the scan in which it is locked."""
    for g in sorted({*f.layout.signalling.boards, *f.layout.signalling.stops}):
        signal = f.layout.signalling.signal[g]
        s = f.layout.track.section_of(signal.into)
        train = f.after(f.locking.train(s))
        past = (
            FALSE
            if g in f.layout.signalling.boards and g in f.layout.signalling.stops
            else train
            if g in f.layout.signalling.boards
            else neg(train)
        )
        for n, name in f.sym.sections.locks_of.get(s, ()):
            if f.topo.traversals[s][n - 1].entry == signal.node:
                new = conj((f.after(var(name)), neg(var(name))))
                yield "S-BOARD", f"{g}:{s}:{n}", implies(new, past)


def _hindered(f: Facts, r: RouteSymbols) -> Expr:
    """A section in the path of a route is blocked, or a point in it was trailed; or inputs are lost, where it is to
    call a train on."""
    ways = [*r.path.ways, *([r.path.berth] if r.path.berth is not None else [])]
    points = [p for s, n in ways for p, _ in f.topo.traversals[s][n - 1].points]
    machines = dict.fromkeys(f.layout.pointwork.point[p].machine for p in points)
    hinder = [var(f.sym.sections.blocked[s]) for s, _ in ways if s in f.sym.sections.blocked]
    hinder += [neg(var(f.sym.valid))] if r.call_on else []
    return disj((*hinder, *(var(f.sym.machines.trailed[m]) for m in machines if m in f.sym.machines.trailed)))


def _again(f: Facts) -> Iterator[tuple[str, str, Expr]]:
    for r in f.sym.routes:
        yield "S-AGAIN", r.id, implies(f.seen.shut(r.number), neg(f.after(var(r.proceed))))
        yield "S-AGAIN", f"{r.id} hindered", implies(_hindered(f, r), neg(var(names.UNHINDERED(r.number))))
        if r.call_on:
            seen = conj((var(r.shown), var(r.active), neg(var(r.proceed))))
            yield "S-CALL-ON", f"{r.id} once", implies(seen, neg(f.after(var(r.proceed))))


# --- locks and points ----------------------------------------------------------------------------


def _locks(f: Facts) -> Iterator[tuple[str, str, Expr]]:
    after = f.after
    valid = var(f.sym.valid)
    for s in f.topo.sections:
        held = f.locking.held(s)
        gone = conj((held, neg(after(held))))
        coming = []
        for j in f.topo.ends[s]:
            g = f.topo.signal_into.get((j, s))
            for k in f.track.functions(g) if g is not None else ():
                coming.append(conj((f.locking.locked_in(s, j), after(accepted(SignalId(str(g)), k)))))
        for j, a, past in f.track.passed_into(s):
            as_train = neg(shunting(a)) if past else TRUE
            for n, x in f.locking.of(a):
                if f.track.way(a, n)[1] == j:
                    coming.append(after(conj((o(a), came(a, f.track.way(a, n)[0]), x, neg(rests(a)), as_train))))
        yield "L-RELEASE", s, implies(gone, conj((valid, neg(after(o(s))), neg(disj(coming)))))
        yield "L-HELD", s, implies(o(s), held)
        yield (
            "S-LOST-INPUT",
            s,
            implies(neg(valid), conj((implies(held, after(held)), implies(neg(held), after(neg(held)))))),
        )
