"""What a proof says: verdicts, witnesses, and how far it has come.

**Theorem.**  A claim is PROVED only by induction and REFUTED only by a run; everything else is UNKNOWN, which is
never counted as proved.  (Soundness of the two rules: `inductive.py` and `search.py`.)  Nothing here proves anything.
"""

from __future__ import annotations

from collections.abc import Callable
from enum import StrEnum
from typing import TYPE_CHECKING

from interlock.dataclass import dataclass

if TYPE_CHECKING:
    from interlock.proof.induction.story import Story

Progress = Callable[[str, int, int], None]


def quiet(stage: str, done: int, total: int) -> None:
    """A progress report that goes nowhere."""
    del stage, done, total


class Verdict(StrEnum):
    """UNKNOWN is never green."""

    PROVED = "PROVED"
    REFUTED = "REFUTED"
    UNKNOWN = "UNKNOWN"


@dataclass(frozen=True)
class ClaimResult:
    """One claim over all its places."""

    id: str
    sentence: str
    verdict: Verdict
    places: int
    open: tuple[str, ...]
    seconds: float
    story: Story | None = None


@dataclass(frozen=True)
class Witness:
    """The outcome for one route: how far the run came, and how many scans it took."""

    route: str
    ok: bool
    steps: int
    text: str


@dataclass(frozen=True)
class ProofResult:
    """All claims, the invariants that carried them, and the witnesses."""

    claims: tuple[ClaimResult, ...]
    invariants: int
    dropped: tuple[str, ...]
    obligations: int
    witnesses: tuple[Witness, ...]
    seconds: float
    kept: bool = False
    """The very same proof was made before, and is remembered."""

    @property
    def proved(self) -> bool:
        """Whether every claim is proved and every route has its witness."""
        return all(c.verdict is Verdict.PROVED for c in self.claims) and all(w.ok for w in self.witnesses)
