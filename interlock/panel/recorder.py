"""The panel's record: every event and every change of what the player shows, in a log that tells when it was changed.

Where it cannot be written (no room, a share that is gone), the panel works on (`panel.written`).
"""

from __future__ import annotations

import time
from pathlib import Path
from typing import Any

from interlock import __version__
from interlock.app.alarms import to_release
from interlock.app.run import Ready, since_boot
from interlock.emit.drawing import plan_svg
from interlock.field.alone import hold_file
from interlock.field.plc import Cycle
from interlock.model.machines import shown_by
from interlock.model.traversal import topology
from interlock.panel.event import Event, rules
from interlock.panel.journal import BEGIN, PICTURE, SET_BACK_S, clock, released
from interlock.panel.standing import KEPT, Standing, left_behind, standing
from interlock.panel.written import Written
from interlock.record.log import Log

AGAIN_S = 1.0
"""Seconds after which writing is tried again."""

Views = dict[str, list[list[str]]]


def views(ready: Ready) -> Views:
    """What each recorded variable shows on the plan: kind of element, its id, what is shown, and
    of a machine the word for it."""
    assert ready.controller is not None and ready.layout is not None
    y, layout, topo = ready.controller.symbols, ready.layout, topology(ready.layout)
    out: Views = {name: [["section", str(s), "occupied"]] for s, name in y.sections.clear.items()}
    for (s, n), name in y.sections.lock.items():
        out[name] = [["edge", str(e), "locked"] for e in topo.traversals[s][n - 1].edges]
    for option, name in y.overlaps.held.items():
        ways = y.overlaps.ways[option]
        out[name] = [["edge", str(e), "overlap"] for s, n in ways for e in topo.traversals[s][n - 1].edges]
    out |= {name: [["section", str(s), "restart"]] for s, name in to_release(layout, y).items()}
    for r in y.routes:
        out |= {name: [["signal", str(r.entry), "proceed"]] for name in r.open_while}
    for (m, x), name in y.machines.detected.items():
        out[name] = shown_by(layout.machines, m, x)
    return out


def _kept(now: Standing) -> dict[str, Any]:
    """What stands, as it is written; a copy, since what cannot be written at once is kept."""
    left = {"left": [list(x) for x in now.left]} if now.left else {}
    return {"blocks": list(now.blocks), "reminders": {k: list(v) for k, v in now.reminders.items()}, **left}


def _blocked(there: Standing) -> str:
    """What whoever chooses another file has to block again, in words."""
    if not there.blocks:
        return ""
    several = len(there.blocks) > 1
    names = ", ".join(there.blocks)
    what = f"sections {names} are" if several else f"section {names} is"
    return f"; {what} blocked there: block {'them' if several else 'it'} again"


class Recorder:
    """Writes a panel's record."""

    def __init__(self, path: Path, ready: Ready) -> None:
        """Begin a log, or go on with one.  Raises `ValueError` for one that is damaged or of another layout, `InUse`
        where another panel writes it, and `OSError`."""
        assert ready.controller is not None and ready.layout is not None and ready.table is not None
        y = ready.controller.symbols
        self.path = path
        self._held = hold_file(path)
        self._clear: tuple[str, ...] = tuple(y.sections.clear.values())
        self._contacts: tuple[str, ...] = tuple(y.machines.detected.values())
        self._state: tuple[str, ...] = tuple(n for n in views(ready) if n not in {*self._clear, *self._contacts})
        self._on: frozenset[str] | None = None
        self._tried = 0.0
        self.releases = 0
        """Releases by hand that the log counts already."""
        self.standing = Standing()
        """What is blocked and what reminds, as the log has it."""
        self.left_behind: tuple[tuple[str, str], ...] = ()
        """Where the log begins anew: what was blocked at the end of the one before it."""
        self._broke_off = ""
        """Where the log goes on, and the session before did not come to its end: that, and when."""
        try:
            log = self._open(str(ready.layout.name), ready.table.layout_digest, views(ready))
        except (OSError, ValueError):
            self._let_go()
            raise
        heading = {
            "program": f"interlock {__version__}",
            "layout": ready.layout.name,
            "title": ready.layout.printed.title or ready.layout.name,
            "digest": ready.table.layout_digest,
            "plan": plan_svg(ready.layout),
            "views": views(ready),
        }
        self._written = Written(path, log, heading, None if self.standing == Standing() else _kept(self.standing))
        self._clock = time.time(), since_boot()
        self._put(BEGIN, **heading)
        if self._broke_off:
            self.event(Event("note", self._broke_off))

    @property
    def lost(self) -> str:
        """Why not all is written; empty where it is."""
        return self._written.lost

    def _open(self, layout: str, digest: str, shown: Views) -> Log:
        """Begin the log, or go on with it: one of another kind, or of the layout as it was, would be told wrongly."""
        if not self.path.exists():
            log, self.left_behind = Log.create(self.path), left_behind(self.path, layout, shown)
            return log
        log, found = Log.resume(self.path)
        first = found.events[0] if found.events else None
        if first is not None:
            wrong = ""
            if "views" not in first:
                wrong = f"{self.path} is no record of a panel"
            elif first.get("layout") != layout:
                wrong = f"{self.path} is the record of {first.get('layout')}"
            elif first.get("digest") != digest:
                wrong = f"{self.path} is the record of {layout} as it was before its layout was changed"
            elif first["views"] != shown:
                by = first.get("program", "another program")
                wrong = f"{self.path} is the record of {layout} by {by}, which calls what it shows otherwise"
            if wrong:
                log.close()
                raise ValueError(f"{wrong}: choose another file{_blocked(standing(found.events))}")
        self.releases = sum(released(e) for e in found.events)
        self.standing = standing(found.events)
        if first is not None and not found.ended:
            since = clock(found.events[-1]["t"], True)
            torn = f"; {found.torn} bytes of another were torn off" if found.torn else ""
            self._broke_off = f"the session before did not come to its end: its last event is of {since}{torn}"
        return log

    def _let_go(self) -> None:
        for lock in self._held:
            lock.close()

    def event(self, e: Event) -> None:
        """Something has happened."""
        reasons = [[r.text, list(r.at)] for r in e.reasons]
        self._put(e.kind, text=e.text, who=e.who, at=list(e.at), reasons=reasons, rules=rules(e), time=e.time)

    def stands(self, now: Standing) -> None:
        """What is blocked, and what reminds, before that is told of."""
        if now != self.standing:
            self._put(KEPT, **_kept(now))
            self.standing = now

    def cycle(self, cycle: Cycle | None) -> None:
        """A cycle has ended; None while there is no power."""
        if time.monotonic() - self._tried > AGAIN_S:
            self._tried = time.monotonic()
            self._look_at_the_clock()
            for lock in self._held:
                lock.look()  # the log has a lock of its own, too
            self._written.try_again(_now_ms())
        self._written.some()
        if cycle is None:
            on = frozenset(self._clear)
        else:
            inputs, state = cycle.inputs, cycle.memory.state
            occupied = (n for n in self._clear if not (cycle.valid and inputs.get(n)))
            detected = (n for n in self._contacts if cycle.valid and inputs.get(n))
            on = frozenset((*occupied, *detected, *(n for n in self._state if state.get(n))))
        if on != self._on:
            before = frozenset() if self._on is None else self._on
            self._put(PICTURE, on=sorted(on - before), off=sorted(before - on), whole=self._on is None)
            self._on = on

    def close(self) -> None:
        """The panel ends."""
        self._look_at_the_clock()
        self._written.close(_now_ms())
        self._let_go()

    def _put(self, kind: str, **fields: Any) -> None:
        self._look_at_the_clock()
        before = self.lost
        self._written.put(_now_ms(), kind, fields)
        if self.lost and not before:
            self._tried = time.monotonic()

    def _look_at_the_clock(self) -> None:
        """Somebody has put it forward: from the times of events alone that looks like an hour in which nothing
        happened.  Whoever reads them sees by himself that it was set back."""
        (wall, real), self._clock = self._clock, (time.time(), since_boot())
        ahead = round(self._clock[0] - wall - (self._clock[1] - real))
        if ahead > SET_BACK_S:
            self.event(Event("note", f"the clock of this computer was put forward by {ahead} s"))


def _now_ms() -> int:
    """The time on the wall; of a clock that has lost it, and begins before all time, the beginning."""
    return max(0, round(time.time() * 1000))
