"""The neighbour at the other end of a line with a direction token (R12), who follows the same rules as we do.

Words travel by telegram in order, some scans late, and any of them may read 0 (A-NEIGHBOUR).
"""

from __future__ import annotations

from collections import deque
from collections.abc import Mapping
from typing import TYPE_CHECKING

from interlock.model.portable import portable
from interlock.simulate.track import Beyond

if TYPE_CHECKING:
    from interlock.simulate.world import World


class Neighbour:
    """His token: he has it, he gives it, our change is complete; what he wants to send."""

    def __init__(self, world: World, line: Beyond) -> None:
        self.world, self.line = world, line
        n = portable(line.name)
        self._inputs = (f"NR_{n}", f"NG_{n}", f"NN_{n}", f"NH_{n}")
        self._clear, self.hand = f"LC_{n}", f"TKN_{n}"
        self._outputs = (f"YTA_{n}", f"YTG_{n}", f"YTN_{n}", f"YTH_{n}")
        self.have = world.rng.random() < 0.5
        self._give = False
        self._kept = True
        self._seen = True
        self.sends = False
        self._to_us: deque[tuple[int, ...]] = deque([(0, 0, 0, 0)] * 2)
        self._to_him: deque[tuple[int, ...]] = deque([(0, 0, 0, 0)] * 2)
        self._was_clear = True

    def _on_line(self) -> tuple[bool, bool]:
        """Whether trains of his, and of ours, are on the line."""
        by, goes = self.line.comes_by, self.line.goes
        return (
            any(t.body[0] in by for t in self.world.trains),
            any(goes in t.body for t in self.world.trains),
        )

    def may_send(self) -> bool:
        """He has the direction and his signal is open."""
        return self.have and self.sends and not any(self._on_line())

    def step(self, shown: Mapping[str, int]) -> None:
        """One exchange."""
        rng = self.world.rng
        his, ours = self._on_line()
        if his and ours:
            self.world.watch.tell(
                self.world.clock, f"line {self.line.name}", f"trains against each other on the line at {self.line.name}"
            )
        clear = not (his or ours)
        self._to_him.append(tuple(int(shown[o]) for o in self._outputs))
        late = rng.random() < 0.2 and len(self._to_him) < 6
        told = self._to_him[0] if late else self._to_him.popleft()
        asks, gives, keeps, has = (x if rng.random() < 0.97 else 0 for x in told)
        if rng.random() < 0.02:
            self.sends = not self.sends if clear else self.sends
        locked = self.sends or his
        take = bool(gives) and not self.have and not self._give
        yields = bool(asks) and self.have and self._seen and clear and not locked
        giving = self._give or yields
        self.have = (self.have or take) and not yields
        self._seen = (self._seen or bool(keeps)) and not take
        self._kept = not giving or bool(has)
        self._give = giving and not has
        words = (int(self.sends and not self.have), int(self._give), int(self._kept), int(self.have))
        self._to_us.append(words)
        late = rng.random() < 0.2 and len(self._to_us) < 6
        heard = self._to_us[0] if late else self._to_us.popleft()
        for name, word in zip(self._inputs, heard, strict=True):
            self.world.reports.inputs[name] = word if rng.random() < 0.97 else 0
        self.world.reports.inputs[self._clear] = int(clear and (self._was_clear or rng.random() < 0.7))
        self._was_clear = clear

    def agreed(self) -> bool:
        """By telephone: the line is empty, he has no direction and gives none, no such word is under way (A-AGREED)."""
        way = any(w[1] or w[3] for w in self._to_us)
        return not (self.have or self._give or way or any(self._on_line()) or any(w[1] for w in self._to_him))
