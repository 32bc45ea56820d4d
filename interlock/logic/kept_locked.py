"""What is said of a section that stays locked because something is reported occupied: first that it is (R2, R9, R16).

The words say by whom a section is locked.  Where no route is set over it, that is past: it waits until it is reported
clear, for which the train has to leave it, or its detector to be repaired.  What a train has left again waits for the
section in rear, as sections are released in order: so do points behind an engine that has left its coaches before them.
"""

from __future__ import annotations

from collections.abc import Iterator

from interlock.dataclass import dataclass
from interlock.diag.called import called
from interlock.logic import names
from interlock.logic.controller import Controller
from interlock.logic.expr import NOT, VAR, variables
from interlock.logic.names import Name
from interlock.logic.symbols import Way
from interlock.model.elements import SectionId


@dataclass(frozen=True, slots=True)
class KeptLocked:
    """What is said by a code while one of these inputs reads 0, none of these routes is set, and all these variables
    are."""

    detection: tuple[Name, ...]
    active: tuple[Name, ...]
    held: tuple[Name, ...]
    text: str


def kept_locked(c: Controller) -> dict[int, tuple[KeptLocked, ...]]:
    """By the code of a refusal by a lock, in the order in which they are asked."""
    out: dict[int, tuple[KeptLocked, ...]] = {}
    for code, kept in _found(c):
        out[code] = (*out.get(code, ()), kept)
    return out


def _detection(c: Controller, s: SectionId) -> tuple[Name, ...]:
    return tuple(of[s] for of in (c.symbols.sections.clear, c.symbols.sections.healthy) if s in of)


def _found(c: Controller) -> Iterator[tuple[int, KeptLocked]]:
    y, equations = c.symbols, {e.name: e for e in c.equations}
    ways: dict[str, Way] = {name: way for way, name in y.sections.lock.items()}
    restart: dict[str, SectionId] = {name: s for s, name in y.sections.restart.items()}
    for r in c.words.reasons.values():
        x = r.condition
        lock = x.args[0].name if x is not None and x.op is NOT and x.args[0].op is VAR else ""
        s = ways[lock][0] if lock in ways else restart.get(lock)
        if s is None or s not in y.sections.clear or not r.text.startswith(called("section", s)):
            continue
        detection = _detection(c, s)
        if lock in ways:
            over = tuple(q.active for q in y.routes.over.get(ways[lock], ()))
            told = "is occupied (by a train, or its detector is out of order), and stays locked until it has been clear"
            yield r.code, KeptLocked(detection, over, (), f"{called('section', s)} {told}")
            release = equations[names.RELEASED_BEHIND(s)]
            led = (variables((t.expr,)) for t in release.terms if t.kind == "rear released")
            for name in dict.fromkeys(n for those in led if lock in those for n in those if n in ways):
                rear = ways[name][0]
                if rear != s and rear in y.sections.clear:
                    held = (y.sections.used[s], y.sections.lock[ways[name]])
                    yield r.code, KeptLocked(_detection(c, rear), over, held, _left_in_rear(s, rear))
        elif there := _there(c, s):
            move = "move what stands there under local rules, then release it"
            yield r.code, KeptLocked(detection, (), (), f"{r.text}: it is occupied and has {there}: {move}")


def _left_in_rear(s: SectionId, rear: SectionId) -> str:
    first = f"{called('section', s)} stays locked until {called('section', rear)} in rear has been clear"
    why = "that is occupied (by what was left there, or its detector is out of order)"
    return f"{first}: {why}; take away what stands there, or move over {s} under local rules"


def _there(c: Controller, s: SectionId) -> str:
    """Why a train that stood in a section at a restart is not called from there (R16); empty where it may be."""
    if len(c.symbols.ways.ends.get(s, ())) <= 2:
        return ""
    points = {m for (of, _), those in c.symbols.ways.demands.items() if of == s for m, _ in those}
    return "points" if points else "a diamond"
