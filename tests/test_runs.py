"""Names in a row: every name that is meant can be read back, and no other."""

from __future__ import annotations

import re
from random import Random

from interlock.table.runs import in_runs


def read_back(items: list[str]) -> list[str]:
    """What a reader takes a list with runs for, who knows nothing but what a run means."""
    out = []
    for x in items:
        first, to, last = x.partition(" to ")
        if not to:
            out.append(x)
            continue
        a, b = re.split(r"([0-9]+)", first), re.split(r"([0-9]+)", last)
        (at,) = [k for k in range(len(a)) if a[k] != b[k]]
        out += ["".join([*a[:at], str(k), *a[at + 1 :]]) for k in range(int(a[at]), int(b[at]) + 1)]
    return out


def test_names_in_a_row_are_one_and_fewer_than_five_are_listed() -> None:
    assert in_runs(["X", "S1", "S10", "S2", "S3", "S4", "S5"]) == ["X", "S1 to S5", "S10"]
    assert in_runs([f"S{k}-E1" for k in range(8, 14)]) == ["S8-E1 to S13-E1"]
    assert in_runs(["S1", "S2", "S3", "S4"]) == ["S1", "S2", "S3", "S4"]
    assert in_runs([f"S0{k}" for k in range(1, 8)]) == [f"S0{k}" for k in range(1, 8)], "S01 is not S1"
    odd = ["1 to 9", *(f"S{k}" for k in range(9))]
    assert in_runs(odd) == odd, "a name that reads as a run"


def test_what_is_read_back_is_what_was_said() -> None:
    rng = Random(1)
    for _ in range(300):
        names = {
            f"{rng.choice('AB')}{rng.randrange(12)}-{rng.choice('EW')}{rng.choice((1, 2, 3, '', '04'))}"
            for _ in range(60)
        }
        listed = sorted(names)
        rng.shuffle(listed)
        told = in_runs(listed)
        assert sorted(read_back(told)) == sorted(names) and len(told) <= len(names)
