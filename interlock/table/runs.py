"""Names in a row: `S1 to S9` for nine names that differ in one number, and in which order they are printed.

A cell of a large yard has hundreds of names, which nobody reads and no sheet of paper holds.  A run stands for every
name between its ends, and is written only where all of them are meant: whoever reads it needs no list of what there is.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from functools import lru_cache

LEAST = 5  # names: fewer are listed one by one
TO = " to "
_NUMBER = re.compile(r"(?<![0-9])(?:0|[1-9][0-9]{0,8})(?![0-9])")
MEANING = ("S1 to S9", "every name from the first to the last, which differ in this one number: S1, S2, S3 and so on")
"""A run and what it means, for a legend."""


def natural(name: str) -> tuple[tuple[int, int, str], ...]:
    """Sort key in which S2 comes before S10, as things are numbered on the ground."""
    parts = re.findall(r"\d+|\D+", name)
    return tuple((0, int(p), "") if p.isdigit() else (1, 0, p) for p in parts)


def legend(rows: Iterable[Sequence[str]]) -> tuple[tuple[str, str], ...]:
    """What a run means, where a cell has one."""
    return (MEANING,) if any(TO in cell for row in rows for cell in row) else ()


def in_runs(names: Sequence[str]) -> list[str]:
    """The names, those in a row as one, at the place of the one with the lowest number; in all else the order stays.

    The last number of a name counts first, then the one before it.  Names of which one could be read as a run are
    listed as they are.
    """
    if len(names) < LEAST or any(TO in n for n in names):
        return list(names)
    left = dict.fromkeys(names)
    said = dict[str, str]()
    for place in range(max(len(_numbered(n)) for n in names)):
        for (head, tail), numbers in _by_number(left, place).items():
            for run in _consecutive(sorted(numbers)) if len(numbers) >= LEAST else ():
                if len(run) >= LEAST:
                    said[numbers[run[0]]] = f"{head}{run[0]}{tail}{TO}{head}{run[-1]}{tail}"
                    for k in run:
                        del left[numbers[k]]
    return [said.get(n, n) for n in dict.fromkeys(names) if n in left or n in said]


@lru_cache(maxsize=1 << 16)
def _numbered(name: str) -> tuple[tuple[tuple[str, str], int], ...]:
    """The numbers of a name, the last one first, each with what stands before and after it."""
    return tuple(((name[: m.start()], name[m.end() :]), int(m[0])) for m in _NUMBER.finditer(name))[::-1]


def _by_number(names: Iterable[str], place: int) -> dict[tuple[str, str], dict[int, str]]:
    """Names by what stands before and after one of their numbers, and by that number."""
    found: dict[tuple[str, str], dict[int, str]] = {}
    for n in names:
        numbers = _numbered(n)
        if len(numbers) > place:
            around, k = numbers[place]
            found.setdefault(around, {})[k] = n
    return found


def _consecutive(numbers: Sequence[int]) -> list[list[int]]:
    runs: list[list[int]] = []
    for k in numbers:
        if runs and runs[-1][-1] == k - 1:
            runs[-1].append(k)
        else:
            runs.append([k])
    return runs
