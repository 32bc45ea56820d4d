"""What an operator presses and what he switches: a button that is forgotten must not act later.

The controller reads its operator's buttons by level: a release, a confirmation or a move that stays set acts again as
soon as its conditions hold, after a restart as if somebody had just pressed it.  So what is typed presses a button, for
so long as one press takes.  Blocks and automatic working are switches, and so is the closing of a level crossing or of
another device by hand: it opens by itself when that is let go of.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field

from interlock.dataclass import dataclass
from interlock.logic.symbols import Symbols
from interlock.model.elements import Position
from interlock.model.layout import Layout
from interlock.model.times import supervision_s, whole_ms

PRESS_MS = 2000
"""Milliseconds for which a button is pressed: more than one cycle, however long cycles are."""


@dataclass
class Press:
    """A button that is pressed: to what value, and for how many milliseconds yet.  `begun`: a cycle has read it."""

    value: int
    left_ms: float
    begun: bool = False


@dataclass
class Presses:
    """The buttons that are pressed, cycle by cycle."""

    layout: Layout
    symbols: Symbols
    pressed: dict[str, Press] = field(default_factory=dict, init=False)
    _over: list[str] = field(default_factory=list, init=False)

    def __post_init__(self) -> None:
        y, device = self.symbols, self.layout.machines.device
        closes = (n for (m, x), n in y.machines.by_hand.items() if m in device and x is Position.REVERSE)
        self._switches = {*y.sections.blocked.values(), *y.requests.automatic.values(), *closes}
        self._token = {t.manual: t for t in y.token.values()}
        self._moves = {n: m for (m, _), n in y.machines.by_hand.items() if m in y.machines.kept_off}

    def is_switch(self, name: str) -> bool:
        """Whether it stays as it is set."""
        return name in self._switches

    def press_ms(self, name: str) -> int:
        """For how long it is pressed at most: the special manual change of direction for its delay, too (R12); a move
        of points for their supervision, since in a blocked section they turn as long as they are ordered to (R10)."""
        if (m := self._moves.get(name)) is not None:  # type: ignore[call-overload]
            return whole_ms(supervision_s(self.layout, m))
        return PRESS_MS + (whole_ms(self.layout.principles.token_delay_s) if name in self._token else 0)

    def press(self, name: str, value: int) -> None:
        """Press a button, or with 0 let go of it."""
        if self.pressed.pop(name, None) is not None and not value:
            self._over.append(name)
        if value:
            self.pressed[name] = Press(value, self.press_ms(name))

    def inputs(self, state: Mapping[str, bool], dt_ms: int) -> dict[str, int]:
        """What is pressed in the next cycle, `dt_ms` milliseconds after the last; `state`: what that one left."""
        for name, press in tuple(self.pressed.items()):
            if press.begun:
                press.left_ms -= dt_ms
            token = self._token.get(name)  # type: ignore[call-overload]
            if press.left_ms <= 0 or (token is not None and state.get(token.have)):
                del self.pressed[name]
                self._over.append(name)
            press.begun = True
        return {name: press.value for name, press in self.pressed.items()}

    def let_go(self) -> list[str]:
        """The buttons that have been let go of since this was last asked."""
        over, self._over = self._over, []
        return over
