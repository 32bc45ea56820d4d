"""Track that is held as overlap: what may lead over it meanwhile, and what overlaps may lie there beside it (R4)."""

from __future__ import annotations

from interlock.model.elements import SignalId
from interlock.proof.functions.words import Way, Words

Option = tuple[SignalId, int]


def over_held(w: Words, o: Option) -> dict[SignalId, set[Way]]:
    """By signal the ways of an overlap over which its train routes may lead: all from the overlap's own signal; unless
    it swings, from each that a train meets further on over it what then follows."""
    ways = w.sym.overlaps.ways[o]
    found = {o[0]: {*ways}}
    for i, (s, n) in enumerate(ways[1:], 1):
        met = w.topo.main_into.get((w.f.track.way(s, n)[0], s))
        if met is not None and not _swings(w, o):
            found[met] = {*ways[i:]}
    return found


def held_beside(w: Words, a: Option, b: Option) -> bool:
    """Of two overlaps, one is met over the other, and lies from there on as that does; neither swings."""
    if a[0] == b[0] or _swings(w, a) or _swings(w, b):
        return False
    for far, near in ((a, b), (b, a)):
        there = {s for s, _ in w.sym.overlaps.ways[far]}
        follows = over_held(w, far).get(near[0], set())
        if follows and {x for x in w.sym.overlaps.ways[near] if x[0] in there} <= follows:
            return True
    return False


def _swings(w: Words, o: Option) -> bool:
    return any(x.swing for x in w.layout.overlaps.all if x.signal == o[0])
