"""The mutants that no claim, no function, no train and no operator notices, and that are not the same either.

Each is on a published list with the reason why it cannot matter.  What survives and is not on the list is a finding.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from functools import cache
from pathlib import Path

import yaml

from interlock.proof.mutation.judge import Fate, Verdict
from interlock.proof.mutation.points import Mutation

LIST = Path(__file__).with_name("survivors.yaml")


@cache
def listed() -> Mapping[str, str]:
    """The list: shapes of mutations, each with its reason."""
    found = yaml.safe_load(LIST.read_text("utf-8"))
    return {str(row["change"]): str(row["reason"]) for row in found}


def off_the_list(judged: Iterable[tuple[Mutation, Verdict | None]]) -> list[str]:
    """The survivors that are not on the list, or without an equivalence that a solver has checked."""
    alive = [(m, v) for m, v in judged if v is not None and v.fate is Fate.SURVIVES]
    return [m.name for m, v in alive if m.shape not in listed() or not v.why]
