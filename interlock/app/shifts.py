"""Many shifts beside each other, in any executor, and how sure one can be of their mean."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import Executor, Future
from contextlib import contextmanager
from math import pi, sqrt, tan
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


def student(freedom: int, level: float = 0.95) -> float:
    """Student's t: the quantile of a two-sided level, by the expansion in 1/freedom (exact for one and two)."""
    p = (1 + level) / 2
    if freedom == 1:
        return tan(pi * (p - 0.5))
    if freedom == 2:
        return float((2 * p - 1) * sqrt(2 / (4 * p * (1 - p))))
    z = NormalDist().inv_cdf(p)
    terms = (
        (z**3 + z) / 4,
        (5 * z**5 + 16 * z**3 + 3 * z) / 96,
        (3 * z**7 + 19 * z**5 + 17 * z**3 - 15 * z) / 384,
        (79 * z**9 + 776 * z**7 + 1482 * z**5 - 1920 * z**3 - 945 * z) / 92160,
    )
    return z + sum(t / float(freedom) ** (k + 1) for k, t in enumerate(terms))
