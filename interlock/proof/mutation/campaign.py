"""A campaign of mutants: which of them, their verdicts kept in a file, pieces side by side, and what is left.

Verdicts are kept one a line, by a digest of all that is said of the system: a campaign goes on where it was broken off,
and asks again only what has changed.  A shard is every n-th piece.
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import lru_cache
from pathlib import Path

from interlock.dataclass import dataclass
from interlock.logic.controller import Controller
from interlock.model.layout import Layout
from interlock.proof.engines.pool import processes
from interlock.proof.mutation.elsewhere import read_elsewhere, read_late
from interlock.proof.mutation.judge import Fate, Judge, Verdict
from interlock.proof.mutation.lines import Lines
from interlock.proof.mutation.points import Mutation, mutations
from interlock.proof.mutation.weakenings import weakenings
from interlock.proof.system.transition import System
from interlock.table.rows import InterlockingTable

PIECE = 200  # mutants that are judged by one task: one judge learns from mutant to mutant

Made = Callable[[str], tuple[Layout, InterlockingTable, Controller]]
"""Layout, table and controller by name, in any process."""
Judged = tuple[Mutation, Verdict | None]
"""A mutant with its verdict, or None where it is not judged yet."""


def one_of_each(every: Sequence[Mutation]) -> list[Mutation]:
    """The first mutant of every form in every family: no family is hidden by a sample."""
    first: dict[tuple[str, str], Mutation] = {}
    for m in every:
        first.setdefault((m.family, m.form), m)
    return list(first.values())


@dataclass(frozen=True)
class Campaign:
    """made: the layouts' controllers, by name.  names: of which, and whether all of their mutants are judged.
    families: only these; none: all.  weakened: the named weakenings of `weakenings` too."""

    made: Made
    names: Mapping[str, bool]
    families: frozenset[str] = frozenset()
    weakened: bool = False

    def chosen(self, name: str) -> list[Mutation]:
        """The mutants of a layout that are judged."""
        return _chosen(self.made, name, self.names[name], self.families, self.weakened)

    def run(
        self, kept: Path | None = None, jobs: int = 1, shard: tuple[int, int] = (1, 1), report: Report | None = None
    ) -> dict[str, list[Judged]]:
        """Judge what is not judged yet.  `kept`: the file of verdicts."""
        known = read(kept) if kept is not None else {}
        digests = {name: digest(self.made, name) for name in self.names}
        of = {name: self.chosen(name) for name in self.names}
        tasks: list[tuple[str, list[Mutation]]] = []
        for name, those in of.items():
            todo = [m for m in those if (digests[name], m.family, m.name) not in known]
            tasks += [(name, todo[k : k + PIECE]) for k in range(0, len(todo), PIECE)]
        tasks = tasks[shard[0] - 1 :: shard[1]]
        for done, (name, piece) in enumerate(self._judged(tasks, jobs), 1):
            rows = [Row(digests[name], family, m, v) for (family, m), v in piece.items()]
            known |= {(r.of, r.family, r.mutation): r.verdict for r in rows}
            if kept is not None:
                with kept.open("a", encoding="utf-8") as out:
                    out.write("".join(r.text for r in rows))
            if report is not None:
                report(done, len(tasks))
        return {name: [(m, known.get((digests[name], m.family, m.name))) for m in those] for name, those in of.items()}

    def _judged(
        self, tasks: Sequence[tuple[str, list[Mutation]]], jobs: int
    ) -> Iterator[tuple[str, dict[tuple[str, str], Verdict]]]:
        asked = [(self, name, frozenset((m.family, m.name) for m in those)) for name, those in tasks]
        if jobs == 1:
            for (name, _), task in zip(tasks, asked, strict=True):
                yield name, _piece(*task)
            return
        with processes(jobs) as pool:
            running = [pool.submit(_piece, *task) for task in asked]
            for (name, _), answer in zip(tasks, running, strict=True):
                yield name, answer.result()


Report = Callable[[int, int], None]
"""Told how many of how many pieces are done."""


@lru_cache(2)
def _chosen(made: Made, name: str, full: bool, families: frozenset[str], weakened: bool) -> list[Mutation]:
    layout, table, controller = made(name)
    every = [*mutations(controller), *read_elsewhere(controller), *read_late(controller)]
    every += weakenings(layout, table, full) if weakened else ()
    some = [m for m in every if not families or m.family in families]
    return some if full else one_of_each(some)


@lru_cache(2)
def _judge(made: Made, name: str) -> Judge:
    layout, _, controller = made(name)
    return Judge(layout, controller)


def _piece(campaign: Campaign, name: str, wanted: frozenset[tuple[str, str]]) -> dict[tuple[str, str], Verdict]:
    """Some verdicts, by family and name of the mutation."""
    judge = _judge(campaign.made, name)
    return {(m.family, m.name): judge.judge(m) for m in campaign.chosen(name) if (m.family, m.name) in wanted}


def digest(made: Made, name: str) -> str:
    """Of all that is said of a system."""
    layout, _, controller = made(name)
    return hashlib.sha256(repr(Lines.of(System(layout, controller))).encode()).hexdigest()[:16]


@dataclass(frozen=True, slots=True)
class Row:
    """A verdict that is kept."""

    of: str
    family: str
    mutation: str
    verdict: Verdict

    @property
    def text(self) -> str:
        """As a line."""
        v = self.verdict
        row = {"of": self.of, "family": self.family, "mutation": self.mutation, "fate": v.fate.value, "why": v.why}
        return json.dumps(row) + "\n"


def read(path: Path) -> dict[tuple[str, str, str], Verdict]:
    """The verdicts that are kept, by digest, family and mutation."""
    rows = map(json.loads, path.read_text("utf-8").splitlines() if path.exists() else ())
    return {(r["of"], r["family"], r["mutation"]): Verdict(Fate(r["fate"]), r["why"]) for r in rows}
