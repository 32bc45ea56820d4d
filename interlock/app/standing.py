"""The ways through sections on which a train in metres stands, for a command from there."""

from __future__ import annotations

from collections.abc import Sequence

from interlock.dispatch.plan.railway import Railway
from interlock.model.elements import EdgeId, SectionId
from interlock.simulate.track import NONE, Track
from interlock.simulate.train import Train
from interlock.table.cells import TraversalKey


def ways_under(railway: Railway, track: Track, train: Train, lies: Sequence[int]) -> tuple[TraversalKey, ...]:
    """From the rear; in the section of its head the way that lies before it."""
    parts: dict[int, list[int]] = {}
    for d in train.body:
        if track.stretches[d].section != NONE and not track.stretches[d].outside:
            parts.setdefault(track.stretches[d].section, []).append(d)
    found = []
    for x, under in parts.items():
        d = under[-1]
        while True:  # on to the end of the section, as points lie
            s = track.stretches[d]
            on = s.on if s.facing is None else s.facing[max(lies[s.machine], 0)]
            if on == NONE or track.stretches[on].section != x or track.stretches[on].outside:
                break
            d = on
            under.append(d)
        found.append(_way(railway, track, SectionId(track.sections[x]), under))
    return tuple(found)


def _way(railway: Railway, track: Track, section: SectionId, under: Sequence[int]) -> TraversalKey:
    """The way through a section that has these stretches and is left where the last of them ends."""
    edges = track.layout.track.edges
    covered: set[EdgeId] = {edges[d >> 1].id for d in under}
    last = edges[under[-1] >> 1]
    end = last.a if under[-1] & 1 else last.b
    ways = railway.topo.traversals[section]
    fits = [t for t in ways if covered <= set(t.edges) and t.exit == end]
    fits = fits or [t for t in ways if t.exit == end] or list(ways)
    return min(fits, key=lambda t: (t.key not in railway.table.lock, t.number)).key
