"""When points and devices may move (R10): commands, and drives that follow them later."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence

from interlock.logic.expr import TRUE, Expr, at_most_one, conj, disj, iff, implies, neg, var
from interlock.logic.names import Name
from interlock.logic.plant import lies, old_command
from interlock.model.elements import MachineId, Position, SectionId
from interlock.model.machines import other_doors
from interlock.proof.claims.kinds import Facts, Invariant


def _held_fast(f: Facts, s: SectionId) -> Expr:
    """Held otherwise than by an overlap that swings away in this step, with the section before its signal clear."""
    held = [f.locking.locked(s)]
    for (g, _), name in f.locking.options(s).items():
        before = f.topo.beyond(
            f.layout.track.section_of(f.layout.signalling.signal[g].into), f.layout.signalling.signal[g].node
        )
        close = neg(f.seen.steadily_clear(before)) if g in f.sym.overlaps.swings and before is not None else TRUE
        held.append(conj((var(name), disj((close, f.after(var(name)))))))
    return disj(held)


def points(f: Facts) -> Iterator[tuple[str, str, Expr]]:
    """P-LOCKED, P-BLOCKED and P-AIR-LOCK."""
    after = f.after

    def stays(m: MachineId, x: Position) -> Expr:
        """It lies there already and was never commanded elsewhere: nothing will move."""
        never = conj(neg(var(f.sym.machines.command[m, y])) for y in Position)
        return conj((var(f.sym.machines.detected[m, x]), after(lies(m, x)), never))

    for m in f.layout.machines:
        yield from _air_lock(f, m, other_doors(f.layout.machines, m))
    for m in f.layout.machines:
        secs = f.layout.machines.sections[m]
        moves = {
            x: conj(
                (neg(var(f.sym.machines.command[m, x])), after(var(f.sym.machines.command[m, x])), neg(stays(m, x)))
            )
            for x in Position
            if m not in f.layout.machines.device or x is Position.NORMAL
        }
        blocked = [n for s in secs if (n := f.sym.sections.blocked.get(s)) is not None]
        by_hand = [implies(moved, var(f.sym.machines.by_hand[m, x])) for x, moved in moves.items()]
        free = conj(
            [
                *(neg(_held_fast(f, s)) for s in secs),
                *(f.seen.steadily_clear(s) for s in secs),
                var(f.sym.valid),
            ]
        )
        yield "P-LOCKED", m, implies(disj(moves.values()), free)
        if m not in f.layout.machines.device:
            yield "P-BLOCKED", m, implies(disj(map(var, blocked)), conj(by_hand))
        if m in f.sym.machines.kept_off:
            yield from _driven(f, m, conj((*map(f.seen.steadily_clear, secs), var(f.sym.valid))), blocked, stays)


def _air_lock(f: Facts, m: MachineId, others: Sequence[MachineId]) -> Iterator[tuple[str, str, Expr]]:
    """A door of an air lock is commanded open only while all others are reported shut, and never beside another."""
    opens = f.after(var(f.sym.machines.command[m, Position.REVERSE]))
    begins = conj((opens, neg(var(f.sym.machines.command[m, Position.REVERSE]))))
    for other in others:
        shut, open_ = (var(f.sym.machines.detected[other, x]) for x in Position)
        yield "P-AIR-LOCK", f"{m}, {other} shut", implies(begins, conj((shut, neg(open_))))
        if m < other:
            also = f.after(var(f.sym.machines.command[other, Position.REVERSE]))
            yield "P-AIR-LOCK", f"{m} and {other}", neg(conj((opens, also)))


def _driven(
    f: Facts, m: MachineId, clear: Expr, blocked: Sequence[Name], stays: Callable[[MachineId, Position], Expr]
) -> Iterator[tuple[str, str, Expr]]:
    """What P-LOCKED and P-BLOCKED say of commands, of the drive of a point: it begins to run only while the sections
    are clear, and runs in a blocked one only while it is moved by hand, or turns as an overlap swings."""
    swings = disj(
        var(name)
        for g, name in f.sym.overlaps.swings.items()
        if any(m == n for o, ways in f.sym.overlaps.ways.items() if o[0] == g for n in _machines_of(f, ways))
    )
    for x in Position:
        drive, by_hand = var(f.sym.machines.drive[m, x]), var(f.sym.machines.by_hand[m, x])
        begins = conj((neg(drive), f.after(drive), neg(stays(m, x))))
        yield "P-LOCKED", f"{m} driven {x}", implies(begins, clear)
        there = conj((disj(map(var, blocked)), f.after(drive)))
        yield "P-BLOCKED", f"{m} driven {x}", implies(there, disj((by_hand, swings)))


def _machines_of(f: Facts, ways: Iterable[tuple[SectionId, int]]) -> set[MachineId]:
    """The machines of the points on ways."""
    return {f.layout.pointwork.point[p].machine for s, n in ways for p, _ in f.topo.traversals[s][n - 1].points}


def machine_invariants(f: Facts) -> Iterator[Invariant]:
    """No machine lies or is commanded both ways, drives follow commands, and of an air lock no two doors are commanded
    open."""
    opens = {m: var(f.sym.machines.command[m, Position.REVERSE]) for m in f.layout.machines}
    for m in f.layout.machines:
        one = [at_most_one(lies(m, x) for x in Position)]
        one += [at_most_one(var(f.sym.machines.command[m, x]) for x in Position)]
        one += [at_most_one(old_command(m, x) for x in Position)]
        yield Invariant("P-ONE", m, conj(one))
        turn, off = f.sym.machines.turn.get(m), f.sym.machines.kept_off.get(m)
        runs = [*([] if turn is None else [var(turn)]), *([] if off is None else [neg(var(off))])]
        driven = conj(
            iff(var(f.sym.machines.drive[m, x]), conj((var(f.sym.machines.command[m, x]), *runs))) for x in Position
        )
        yield Invariant("P-DRIVEN", m, driven)
        for other in other_doors(f.layout.machines, m):
            if m < other:
                yield Invariant(f"P-APART:{other}", m, neg(conj((opens[m], opens[other]))))
