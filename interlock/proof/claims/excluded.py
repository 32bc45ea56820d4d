"""Where no route may lead, whatever else is in order: S-EXCLUDED (R1, R2).

The author excludes routes, or of those of trains the call-on routes alone; a trap takes none; over a boundary where
trains only come in none leaves; none begins at a board; none leads over a hand-worked point against its key, over both
arms of a diamond, or without detection.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from interlock.logic.expr import FALSE, Expr, conj, disj, implies, neg, var
from interlock.model.elements import BoundaryKind, BufferKind, Position, SignalId
from interlock.model.traversal import Traversal
from interlock.proof.claims.added import fits
from interlock.proof.claims.kinds import Facts
from interlock.proof.claims.paths import SignalPath, exit_of, lie, runs_past, signal_paths


def excluded(f: Facts) -> Iterator[tuple[str, str, Expr]]:
    """Claim, place and expression for each path of a signal, and for each row of them where the signals between them
    show their identifier lights, that no route may take."""
    after = f.after
    for g, shunt in ((h.id, k) for h in f.layout.signalling.signals for k in f.track.functions(h.id)):
        who = f"{g} shunt" if shunt else g
        for k, path in enumerate(signal_paths(f, g, shunt), 1):
            here = after(conj((f.sym.aspects.signal(g, shunt), lie(f, path.ways))))
            passed = None if shunt else _passed(f, path)
            calls = after(disj((*map(var, f.sym.aspects.main_lamps(g)), f.sym.aspects.identifies(g))))
            if not _can_be(f, g, shunt, path):
                yield "S-EXCLUDED", f"{who}:{k}", neg(here)
            elif _unwanted(f, g, shunt, path):
                past = FALSE if passed is None else conj((calls, after(f.sym.aspects.identifies(passed))))
                yield "S-EXCLUDED", f"{who}:{k}", implies(here, past)
            if not shunt and g in f.sym.aspects.call_on and _unwanted(f, g, shunt, path, called_on=True):
                called = after(conj((var(f.sym.aspects.call_on[g]), lie(f, path.ways))))
                yield "S-EXCLUDED", f"{who} call-on:{k}", neg(called)
            for run in () if shunt else runs_past(f, path):
                can, further = _can_be_run(f, run.ways, run.ways), _passed(f, run.parts[-1])
                if not can or _unwanted(f, g, False, SignalPath(g, False, run.ways, None)):
                    on = FALSE if further is None or not can else after(f.sym.aspects.identifies(further))
                    yield "S-EXCLUDED", f"{who}:{k}{run.called}", implies(conj((calls, after(run.lit(f)))), on)


def _passed(f: Facts, path: SignalPath) -> SignalId | None:
    """The signal at the end of a train's path, where the layout gives it an identifier light."""
    signal = exit_of(f, path)
    return signal if signal in f.layout.signalling.identifiers else None


def _unwanted(f: Facts, g: SignalId, shunt: bool, path: SignalPath, called_on: bool = False) -> bool:
    """The author excludes a route over the path, or (`called_on`) the call-on route alone."""
    told = (x for x in f.layout.declared.excluded if x.called_on is called_on)
    return any(fits(f, x, g, shunt, path.ways, not shunt) for x in told)


def _can_be(f: Facts, g: SignalId, shunt: bool, path: SignalPath) -> bool:
    """A route may begin at the signal, run over the path, and end or leave where it does."""
    end = path.ways[-1].exit
    buffer, boundary = f.layout.track.buffer_at.get(end), f.layout.track.boundary_at.get(end)
    trap = buffer is not None and buffer.kind is BufferKind.TRAP
    against = boundary is not None and boundary.kind is BoundaryKind.IN and not shunt
    leads_on = not (trap or against) or path.berth is not None
    return leads_on and f.layout.signalling.opens(g, shunt) and _can_be_run(f, path.ways, path.kept_clear)


def _can_be_run(f: Facts, ways: Sequence[Traversal], clear: Sequence[Traversal]) -> bool:
    """No machine is needed in both positions, no key is turned, no diamond is passed twice, and what must be clear is
    detected."""
    arms = [c for t in ways for c, _ in t.crossings]
    lie_so = {(f.layout.pointwork.point[p].machine, x) for t in ways for p, x in t.points}
    turned = {machine for machine, x in lie_so if x is Position.REVERSE}
    once = len({machine for machine, _ in lie_so}) == len(lie_so)
    seen = not any(t.section in f.layout.track.undetected for t in clear)
    return once and len(arms) == len(set(arms)) and not turned & f.layout.machines.by_hand and seen
