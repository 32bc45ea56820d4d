"""What those who look at a world see of it, however its trains are moved."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Protocol

from interlock.simulate.track import Track
from interlock.simulate.train import Train

if TYPE_CHECKING:
    from interlock.simulate.sight import Sight


class Rails(Protocol):
    """How machines lie: their contacts, their rails, where they move to; `version` grows with every change."""

    position: list[int]
    lies: list[int]
    target: list[int]
    version: int


class Scene(Protocol):
    """A world at a moment."""

    @property
    def track(self) -> Track: ...
    @property
    def machines(self) -> Rails: ...
    @property
    def trains(self) -> Sequence[Train]: ...
    @property
    def sight(self) -> Sight: ...
    @property
    def clock(self) -> float:
        """Seconds."""
        ...
