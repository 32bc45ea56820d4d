"""Many shifts beside each other, in any executor, and how sure one can be of their mean."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import Executor, Future
from contextlib import contextmanager
from functools import lru_cache
from math import cos, pi, sin, sqrt, tan
from statistics import NormalDist, fmean, stdev

from interlock.app.setting import prepared
from interlock.app.shift import Shift
from interlock.app.worked import Options, Worked
from interlock.dataclass import dataclass
from interlock.diag.extras import install
from interlock.proof.engines.pool import processes


def one(path: str, file: str | None, seed: int, options: Options) -> Worked:
    """One shift; in another process, too.  Raises `ValueError` where layout or dispatch file are wrong."""
    return Shift(prepared(path, file), seed, options).run()


def many(
    path: str,
    file: str | None,
    seeds: Sequence[int],
    options: Options,
    executor: Executor | None = None,
    note: Callable[[int], None] = lambda done: None,
) -> list[Worked]:
    """A shift for each seed, in the order of the seeds whatever is done where; `note` is told how many are done.

    executor: any of `concurrent.futures`, or that of a Dask client (`client.get_executor()`); None: here, in turn.
    """
    found = []
    if executor is None:
        for k, seed in enumerate(seeds, 1):
            found.append(one(path, file, seed, options))
            note(k)
        return found
    futures: list[Future[Worked]] = [executor.submit(one, path, file, s, options) for s in seeds]
    for k, f in enumerate(futures, 1):
        found.append(f.result())
        note(k)
    return found


class NoCluster(Exception):
    """There is no Dask, or no cluster at the address; says which."""


@contextmanager
def executing(jobs: int, dask: str | None) -> Iterator[Executor | None]:
    """Processes, or a Dask cluster by its address; None for one process, which is this.  Raises `NoCluster`."""
    if dask is None:
        if jobs == 1:
            yield None
            return
        with processes(jobs, "spawn") as pool:
            yield pool
        return
    try:
        from distributed import Client
    except ImportError:
        raise NoCluster(f"a Dask cluster needs the extra `cluster`: {install('cluster')}") from None
    try:
        client = Client(dask, timeout=5)  # type: ignore[no-untyped-call]
    except (OSError, ValueError) as error:
        raise NoCluster(f"there is no cluster at {dask}: {error}") from None
    with client:
        yield client.get_executor(pure=False)  # type: ignore[no-untyped-call]


@dataclass(frozen=True)
class Mean:
    """The mean of some values, and the half width of its 95 % confidence interval (Student's t)."""

    value: float
    half: float
    count: int

    @property
    def least(self) -> float:
        """The lower end, of what is counted or weighed: nothing is less than nothing."""
        return max(0.0, self.value - self.half)


def mean(values: Sequence[float]) -> Mean:
    """Of at least one value; one alone says nothing of its spread."""
    if len(values) < 2:
        return Mean(fmean(values), float("inf"), len(values))
    return Mean(fmean(values), student(len(values) - 1) * stdev(values) / sqrt(len(values)), len(values))


EXACT = 200
"""Degrees of freedom up to which Student's t is computed exactly; beyond, an expansion is right to ten digits."""


@lru_cache(maxsize=256)
def student(freedom: int, level: float = 0.95) -> float:
    """Student's t: the quantile of a two-sided level.

    Up to `EXACT` from the finite sums for whole degrees of freedom (Abramowitz and Stegun, Handbook of Mathematical
    Functions, 26.7.3 and 26.7.4), beyond by the expansion in 1/freedom (26.7.5).
    """
    z = NormalDist().inv_cdf((1 + level) / 2)
    if freedom > EXACT:
        terms = (
            (z**3 + z) / 4,
            (5 * z**5 + 16 * z**3 + 3 * z) / 96,
            (3 * z**7 + 19 * z**5 + 17 * z**3 - 15 * z) / 384,
            (79 * z**9 + 776 * z**7 + 1482 * z**5 - 1920 * z**3 - 945 * z) / 92160,
        )
        return z + sum(t / float(freedom) ** (k + 1) for k, t in enumerate(terms))
    low, high = 0.0, pi / 2  # of the angle whose tangent is t over the root of the degrees of freedom
    for _ in range(60):
        angle = (low + high) / 2
        low, high = (angle, high) if _within(freedom, angle) < level else (low, angle)
    return tan(low) * sqrt(freedom)


def _within(freedom: int, angle: float) -> float:
    """How likely Student's t is between -t and t, where t over the root of the degrees of freedom is tan(angle)."""
    odd = freedom % 2
    term = cos(angle) if odd else 1.0
    total = 0.0
    for k in range(1 + odd, freedom, 2):  # from the exponent of one term to that of the next
        total += term
        term *= k / (k + 1) * cos(angle) ** 2
    return 2 / pi * (angle + sin(angle) * total) if odd else sin(angle) * total
