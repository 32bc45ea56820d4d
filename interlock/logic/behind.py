"""What still holds the first section behind a signal from which a movement has gone, and how it is released (R8, R9).

Behind a movement that was seen to go on it is released when nobody else can be on the way to the signal: at the latest
at the end of the delay of approach locking.  Where nothing was seen to go on, as after a section that read occupied for
a moment behind an open signal, it is released by hand, after that delay if somebody may be on the way.
"""

from __future__ import annotations

from collections.abc import Iterator

from interlock.dataclass import dataclass
from interlock.logic import names
from interlock.logic.controller import Controller, Equation
from interlock.logic.expr import variables
from interlock.logic.names import Name
from interlock.model.elements import SectionId, SignalId


@dataclass(frozen=True)
class Left:
    """The variables that tell it of one lock: while `used` and not `gone` it waits for its release by hand."""

    lock: Name
    section: SectionId
    signal: SignalId
    used: Name
    """Something came in."""
    gone: Name
    """It was seen to go on; at a boundary that is not asked for, and this is `used`."""
    clear: Name
    """The timer of the release delay: it runs while the section reads clear."""
    delay: Name
    """The timer of approach locking: it runs from when the signal has closed, or the release is held."""
    release: Name
    """The input that releases it by hand."""


def left_behind(c: Controller) -> Iterator[Left]:
    """One for every lock that begins at a signal, where section and release are of the kind that is told above: nothing
    lies in rear that must be released first, and no movement ends by going into a berth."""
    y = c.symbols
    equations = {s.name: s for s in c.steps if isinstance(s, Equation)}
    first = {r.path.ways[0]: r.entry for r in y.routes if r.path.ways}
    for way, signal in sorted(first.items()):
        section, lock = way[0], y.sections.lock[way]
        if section not in y.sections.clear or signal not in y.cancellation.approach_timer:
            continue
        behind, leaves = equations[names.RELEASED_BEHIND(section)], equations[names.LEAVES(section)]
        own = {t.kind for t in (*behind.terms, *leaves.terms) if lock in variables((t.expr,))}
        if own & {"rear released", "gone into a berth"}:
            continue
        used = y.sections.used[section]
        gone = used if "leaves at a boundary" in own else y.sections.passed[section]
        timers = y.sections.release_timer[section], y.cancellation.approach_timer[signal]
        yield Left(lock, section, signal, used, gone, *timers, y.sections.release[section])
