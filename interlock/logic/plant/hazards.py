"""The bad events of one step: collision, derailment, points that move, diamonds, foul joints."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Protocol

from interlock.logic import names
from interlock.logic.expr import FALSE, Expr, at_most_one, conj, disj, neg
from interlock.logic.plant.kinds import Hazard, Plant
from interlock.logic.plant.standing import Entries, Standing
from interlock.logic.plant.words import came, lies, o, rests
from interlock.model.elements import Position, SectionId
from interlock.model.foul import FoulJoint
from interlock.model.layout import Layout
from interlock.model.traversal import Topology


class Railway(Protocol):
    """What the hazards see of the plant in the making: its events and who stands where."""

    layout: Layout
    topo: Topology
    p: Plant
    dropped: frozenset[str]
    standing: Standing
    entries: Entries

    def choice(self, name: names.Name, text: str) -> Expr:
        """A free choice of the world."""
        ...


def hazards(b: Railway, fouls: Sequence[FoulJoint]) -> list[Hazard]:
    """All hazards, by kind and place."""
    out: list[Hazard] = []
    for s in b.topo.sections:
        enter = [b.entries.comes_in(s, j) for j in b.topo.ends[s]]
        enter = [e for e in enter if e is not FALSE]
        out.append(Hazard("COLLISION", s, _collision(b, s, enter)))
        out.append(Hazard("DERAIL", s, _derailment(b, s)))
    return [*out, *_points_move(b), *_open_roads(b), *_diamonds(b), *_fouls(b, fouls)]


def _derailment(b: Railway, s: SectionId) -> Expr:
    """A head over points that lie for no way on, or through a buffer."""
    p, topo, layout = b.p, b.topo, b.layout
    wrong: list[Expr] = []
    for j in topo.ends[s]:
        good = disj(b.standing.lie(t) for t in b.standing.ways(s, j))
        wrong.append(conj((o(s), neg(rests(s)), came(s, j), neg(good))))
    for j, called in (
        b.standing.calls(s) if not b.standing.berth(s) else ()
    ):  # one that stood there is called, whatever lies under it
        wrong.append(conj((o(s), rests(s), called, neg(b.standing.heading(s, j)))))
    if not b.standing.berth(s):  # so does what lies under the whole of its train
        good = disj(b.standing.heading(s, j) for j in topo.ends[s])
        wrong.append(conj((o(s), rests(s), b.standing.moves(s), neg(good))))
    for j in topo.ends[s]:
        good = disj(b.standing.lie(t) for t in b.standing.ways(s, j))
        if b.standing.ways(s, j):
            wrong.append(conj((b.entries.comes_in(s, j), neg(good))))
    if "A-BUFFER" in b.dropped:
        for j in topo.ends[s]:
            if j in layout.track.buffer_at:
                chance = b.choice(names.THROUGH(j), f"the train in {s} runs through buffer {j}")
                p.events[names.THROUGH(j)] = conj((o(s), neg(rests(s)), b.standing.heading(s, j), chance))
                wrong.append(p.events[names.THROUGH(j)])
    return disj(wrong)


def _points_move(b: Railway) -> Iterator[Hazard]:
    """A machine starts under a train, or before one that comes in."""
    p, topo, layout = b.p, b.topo, b.layout
    for m, ends in sorted(layout.machines.ends.items()):
        starts = disj(p.events[names.MACHINE_STARTS(m, x)] for x in Position)
        bad = []
        for s_ in sorted({layout.track.section_of(e.toe) for e in ends}):
            mine = {e.id for e in ends}
            over = [t for t in topo.traversals[s_] if mine & {q for q, _ in t.points}]
            # under a train, as the points lie; anywhere under one that has stood there since the restart
            under = disj((standing(b, s_), *(conj((came(s_, t.entry), b.standing.lie(t))) for t in over)))
            coming = disj(conj((b.entries.comes_in(s_, t.entry), b.standing.lie(t))) for t in over)
            bad.append(conj((starts, disj((conj((o(s_), under)), coming)))))
        yield Hazard("POINT-MOVES", m, disj(bad))


def _open_roads(b: Railway) -> Iterator[Hazard]:
    """A train over a level crossing or bridge that is not closed."""
    for d in b.layout.signalling.devices:
        closed = lies(d.id, Position.REVERSE)
        for s_ in d.over:
            entering = disj(b.entries.comes_in(s_, j) for j in b.topo.ends[s_])
            moves = disj((neg(rests(s_)), b.standing.moves(s_)))
            there = disj((conj((o(s_), moves)), entering))
            yield Hazard("ROAD", f"{d.id}/{s_}", conj((there, neg(closed))))


def _diamonds(b: Railway) -> Iterator[Hazard]:
    """Trains on both arms of a diamond."""
    topo, layout = b.topo, b.layout
    for c in layout.pointwork.crossings:
        sides = []
        for arm in (0, 1):
            sec = layout.track.section_of(c.arms[arm][0])
            sides.append(
                (
                    sec,
                    disj(
                        conj((o(sec), came(sec, t.entry), b.standing.lie(t)))
                        for t in topo.traversals[sec]
                        if (c.id, arm) in t.crossings
                    ),
                )
            )
        if sides[0][0] != sides[1][0]:
            both = conj((sides[0][1], sides[1][1], neg(conj(_still(b, s) for s, _ in sides))))
            yield Hazard("DIAMOND", c.id, both)


def _fouls(b: Railway, fouls: Sequence[FoulJoint]) -> Iterator[Hazard]:
    """Trains foul of each other at a joint."""
    topo = b.topo
    for f in fouls:
        crossing = disj(
            conj((came(f.section, t.entry), b.standing.lie(t))) for t in topo.traversals[f.section] if f.fouls(t)
        )
        near = disj(
            (
                standing(b, f.neighbour),
                *(
                    conj((came(f.neighbour, t.entry), b.standing.lie(t)))
                    for t in topo.traversals[f.neighbour]
                    if f.node in (t.entry, t.exit)
                ),
            )
        )
        moves = neg(conj((_still(b, f.section), _still(b, f.neighbour))))
        yield Hazard("FOUL", f"{f.section}/{f.neighbour}", conj((o(f.section), crossing, o(f.neighbour), near, moves)))


def _still(b: Railway, s: SectionId) -> Expr:
    """What is in s has stood there since the restart, and nobody has called it, nor a train of which it is part."""
    return conj((rests(s), neg(b.standing.moves(s))))


def standing(b: Railway, s: SectionId) -> Expr:
    """What is in s has stood there, somewhere, since the restart; what has overrun a signal is where its points lie."""
    return conj((rests(s), neg(b.standing.astray(s))))


def _collision(b: Railway, s: SectionId, enter: list[Expr]) -> Expr:
    """Entry into an occupied section, or two entries at once; in a berth shunting movements run on sight."""
    if not b.standing.berth(s):
        return disj((conj((o(s), disj(enter))), neg(at_most_one(enter))))
    ends = b.topo.ends[s]
    shunts = [b.entries.shunts_in(s, j) for j in ends]
    trains = [conj((b.entries.comes_in(s, j), neg(b.entries.shunts_in(s, j)))) for j in ends]
    train = disj(trains)
    coming = disj(b.standing.coming(s, j) for j in ends if j not in b.layout.track.buffer_at)
    running_in = conj((o(s), neg(rests(s)), coming))
    return disj(
        (
            conj((train, o(s))),
            conj((train, disj(shunts))),
            neg(at_most_one(trains)),
            conj((disj(shunts), running_in)),
        )
    )
