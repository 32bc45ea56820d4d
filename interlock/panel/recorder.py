"""The panel's record: every event and every change of what the player shows, in a log that tells when it was changed.

Where it cannot be written (no room, a share that is gone), the panel works on: what happens meanwhile is kept, and
written when that is possible again.
"""

from __future__ import annotations

import time
from collections import deque
from pathlib import Path
from typing import Any

from interlock import __version__
from interlock.app.alarms import to_release
from interlock.app.run import Ready
from interlock.emit.drawing import plan_svg
from interlock.field.alone import hold_file
from interlock.field.plc import Cycle
from interlock.model.machines import shown_by
from interlock.model.traversal import topology
from interlock.panel.event import Event, rules
from interlock.panel.journal import PICTURE
from interlock.panel.standing import KEPT, Standing, left_behind, standing
from interlock.record.log import END, Log

WAITING = 100_000
"""Lines that are kept at most while nothing can be written."""

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
    return {"blocks": list(now.blocks), "reminders": {k: list(v) for k, v in now.reminders.items()}}


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
        self.path, self.lost = path, ""
        self._held = hold_file(path)
        self._clear: tuple[str, ...] = tuple(y.sections.clear.values())
        self._contacts: tuple[str, ...] = tuple(y.machines.detected.values())
        self._state: tuple[str, ...] = tuple(n for n in views(ready) if n not in {*self._clear, *self._contacts})
        self._on: frozenset[str] | None = None
        self._base: frozenset[str] | None = None
        """What was on when writing had to stop."""
        self._waiting: deque[tuple[int, str, dict[str, Any]]] = deque(maxlen=WAITING)
        self._dropped = 0
        self._tried = 0.0
        self.releases = 0
        """Releases by hand that the log counts already."""
        self.standing = Standing()
        """What is blocked and what reminds, as the log has it."""
        self.left_behind: tuple[str, tuple[str, ...]] = ("", ())
        """Where the log begins anew: the one before it, and what is blocked there."""
        self._log: Log | None = None
        self._left: Log | None = None
        """Where writing had to stop."""
        try:
            self._open(str(ready.layout.name), ready.table.layout_digest, views(ready))
        except (OSError, ValueError):
            self._let_go()
            raise
        self._heading = {
            "program": f"interlock {__version__}",
            "layout": ready.layout.name,
            "title": ready.layout.printed.title or ready.layout.name,
            "digest": ready.table.layout_digest,
            "plan": plan_svg(ready.layout),
            "views": views(ready),
        }
        self._put("begin", **self._heading)

    def _open(self, layout: str, digest: str, shown: Views) -> None:
        """Begin the log, or go on with it: one of another kind, or of the layout as it was, would be told wrongly."""
        if not self.path.exists():
            self._log, self.left_behind = Log.create(self.path), left_behind(self.path, layout, shown)
            return
        self._log, found = Log.resume(self.path)
        first = found.events[0] if found.events else None
        if first is not None:
            wrong = ""
            if "views" not in first:
                wrong = f"{self.path} is no record of a panel"
            elif first.get("layout") != layout:
                wrong = f"{self.path} is the record of {first.get('layout')}"
            elif first.get("digest") != digest:
                wrong = f"{self.path} is the record of {layout} as it was before its layout was changed"
            if wrong:
                self._log.close()
                raise ValueError(f"{wrong}: choose another file{_blocked(standing(found.events))}")
        self.releases = sum(e["kind"] == "release" for e in found.events)
        self.standing = standing(found.events)

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
            self._look()
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
        self._put(END)
        self._let_go()
        if self._log is not None:
            self._log.close()
            self._log = None

    def _put(self, kind: str, **fields: Any) -> None:
        t_ms = round(time.time() * 1000)
        if self._log is None:
            self._keep(t_ms, kind, fields)
            return
        try:
            self._log.add(t_ms, kind, **fields)
        except OSError as error:
            self._broken(error)
            self._keep(t_ms, kind, fields)

    def _keep(self, t_ms: int, kind: str, fields: dict[str, Any]) -> None:
        self._dropped += len(self._waiting) == WAITING
        self._waiting.append((t_ms, kind, fields))

    def _look(self) -> None:
        """Once in a while: go on where nothing could be written; a file that is gone takes nothing any more."""
        self._tried = time.monotonic()
        if self._log is None:
            self._again()
        elif not self._log.lies_at(self.path):
            self._broken(OSError(0, f"{self.path} was moved away or removed"))

    def _broken(self, error: OSError) -> None:
        self.lost = f"the record cannot be written: {error.strerror or error}"
        self._tried = time.monotonic()
        if not self._waiting:
            self._base = self._on
        if self._log is not None:
            self._log.close()
            self._left, self._log = self._log, None

    def _again(self) -> None:
        """Try to go on: what was torn off is cut away, what was kept is written, in a file that begins anew if the
        other one is gone."""
        since = self._waiting[0][0] if self._waiting else round(time.time() * 1000)
        try:
            left = self._left if self.path.exists() else None
            self._log = Log.create(self.path) if left is None else Log.again(self.path, left)
            if left is None:
                self._log.add(since, "begin", **self._heading)
                self._log.add(since, PICTURE, on=sorted(self._base or ()), off=[], whole=True)
                if self.standing != Standing():
                    self._log.add(since, KEPT, **_kept(self.standing))
            self._log.add(since, "gap", text=self.lost, dropped=self._dropped)
            while self._waiting:
                t_ms, kind, fields = self._waiting[0]
                self._log.add(t_ms, kind, **fields)
                self._waiting.popleft()
        except (OSError, ValueError) as error:
            self._broken(error if isinstance(error, OSError) else OSError(str(error)))
            return
        self.lost, self._dropped = "", 0
