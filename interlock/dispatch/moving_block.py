"""Moving block as supervision over the fixed sections: zones that go with trains, and positions that are not sure.

Document D, rules 2 and 3: 60 m are kept free before and behind an empty train, 70 m a loaded one; all is measured at
the beacon reader on the locomotive, which is behind the wagons when they are propelled.  The document does not say
whether a margin holds for a standing train, nor whether two margins may overlap; both are parameters.  Positions come
from inertia (document C): their error grows with the time since the last beacon, so a train is an interval, and so are
its ends.

Nothing here opens a signal: it tells what is too close, and parameters that contradict one another.
"""

from __future__ import annotations

from collections.abc import Sequence

from interlock.dataclass import dataclass


@dataclass(frozen=True)
class Margins:
    """Metres kept free before and behind a train.

    standing: whether they hold for a train that stands.  disjoint: whether the margins of two trains add up, else only
    no train may be within the other's.
    """

    empty_m: float = 60.0
    loaded_m: float = 70.0
    standing: bool = True
    disjoint: bool = False

    def of(self, train: MovingTrain) -> float:
        """The margin of a train as it is now."""
        if not self.standing and train.speed_ms == 0:
            return 0.0
        return self.loaded_m if train.loaded else self.empty_m


@dataclass(frozen=True)
class Position:
    """Where a beacon reader is: metres along the line, measured `age_s` ago, with an error that grows.

    error_m: at the beacon.  drift_ms: metres a second by which inertia errs at most.
    """

    at_m: float
    age_s: float = 0.0
    error_m: float = 0.5
    drift_ms: float = 0.05

    @property
    def bound_m(self) -> float:
        """The most by which it can be wrong now."""
        return self.error_m + self.drift_ms * self.age_s


@dataclass(frozen=True)
class MovingTrain:
    """A train on a line: towards higher metres (+1) or lower (-1).  propelled: the locomotive is at the rear."""

    number: str
    position: Position
    length_m: float
    direction: int
    speed_ms: float = 0.0
    loaded: bool = False
    propelled: bool = False
    reaction_s: float = 2.0
    braking_ms2: float = 0.4

    @property
    def body(self) -> tuple[float, float]:
        """The lowest and highest metre that it may cover."""
        ahead = self.direction if self.propelled else -self.direction
        ends = sorted((self.position.at_m, self.position.at_m + ahead * self.length_m))
        return ends[0] - self.position.bound_m, ends[1] + self.position.bound_m

    @property
    def stopping_m(self) -> float:
        """Metres until it stands: v t + v^2 / 2b."""
        return self.speed_ms * self.reaction_s + self.speed_ms**2 / (2 * self.braking_ms2)


@dataclass(frozen=True)
class TooClose:
    """Two trains nearer than their margins allow: metres between them, and metres that are missing."""

    first: str
    second: str
    gap_m: float
    missing_m: float


def gap_m(a: MovingTrain, b: MovingTrain) -> float:
    """Metres between two trains at the least; negative where they may overlap."""
    (low_a, high_a), (low_b, high_b) = a.body, b.body
    return max(low_b - high_a, low_a - high_b)


def too_close(trains: Sequence[MovingTrain], margins: Margins) -> tuple[TooClose, ...]:
    """Every pair that is nearer than it may be."""
    found = []
    for k, a in enumerate(trains):
        for b in trains[k + 1 :]:
            own = (margins.of(a), margins.of(b))
            need = sum(own) if margins.disjoint else max(own)
            gap = gap_m(a, b)
            if gap < need:
                found.append(TooClose(a.number, b.number, gap, need - gap))
    return tuple(found)


def free(section: tuple[float, float], trains: Sequence[MovingTrain]) -> bool:
    """No train can be in a section: it is free only when the whole interval of a tail has left it."""
    low, high = section
    return all(t.body[1] <= low or t.body[0] >= high for t in trains)


def stops_before(train: MovingTrain, limit_m: float) -> bool:
    """A train can still stop with its leading end before a limit point."""
    low, high = train.body
    ahead = limit_m - high if train.direction > 0 else low - limit_m
    return ahead >= train.stopping_m


def contradictions(
    margins: Margins, *, empty_limit_m: float, loaded_limit_m: float, length_m: float, propelled_empties: bool = True
) -> tuple[str, ...]:
    """Limit points before a fork against the margins: what a train that waits there keeps from others.

    The limits are measured from the fork to the beacon reader.  Empty where nothing is wrong.
    """
    if not margins.standing:
        return ()
    said = []
    over = margins.loaded_m - loaded_limit_m
    if over > 0:
        said.append(
            f"a loaded train at its limit of {loaded_limit_m:g} m with {margins.loaded_m:g} m in front reaches "
            f"{over:g} m past the fork: it closes the section for which it waits"
        )
    ahead = length_m if propelled_empties else 0.0
    over = margins.empty_m - (empty_limit_m - ahead)
    if over > 0:
        how = f"propelled, {length_m:g} m long, " if propelled_empties else ""
        said.append(
            f"an empty train, {how}at its limit of {empty_limit_m:g} m with {margins.empty_m:g} m in front reaches "
            f"{over:g} m past the fork"
        )
    return tuple(said)
