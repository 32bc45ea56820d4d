"""A change of the layout that the book of tests has to notice: on the controller of before, and in what is tested again."""

from __future__ import annotations

from pathlib import Path

import pytest

from interlock.app.check import check_file
from interlock.app.commission import not_in
from interlock.commissioning.book import book
from interlock.commissioning.step import Step
from interlock.emit.python.runtime import runtime_py
from interlock.logic.cabinet import allocate
from interlock.logic.controller import Controller
from interlock.logic.lower import lower
from interlock.model.layout import Layout
from interlock.table.rows import InterlockingTable
from tests.test_diff import BASE

RULES = "{line_speed_kmh: 60}"


class Changed:
    """A layout with some of its text replaced, and its books of before and after."""

    def __init__(self, folder: Path, *edits: tuple[str, str], before: str = BASE) -> None:
        text = before
        for was, now in edits:
            assert was in text
            text = text.replace(was, now)
        self.old, self.new = _derived(folder / "old.yaml", before), _derived(folder / "new.yaml", text)
        self.before, self.after = _book(self.old, self.old[2]), _book(self.new, self.new[2])
        assert [(s.do, s.expect, s.came) for s in (*self.before, *self.after) if s.came] == []

    @property
    def again(self) -> tuple[Step, ...]:
        """What is tested again."""
        return not_in(self.after, self.before)

    def not_loaded(self) -> list[Step]:
        """The tests that come out otherwise where the controller of before still runs."""
        return [s for s in _book(self.new, self.old[2]) if s.came]


def _derived(path: Path, text: str) -> tuple[Layout, InterlockingTable, Controller]:
    path.write_text(text, "utf-8")
    found = check_file(str(path))
    assert found.layout is not None and found.table is not None, found.diagnostics
    return found.layout, found.table, lower(found.layout, found.table)


def _book(of: tuple[Layout, InterlockingTable, Controller], runs: Controller) -> list[Step]:
    layout, table, controller = of
    return list(book(layout, table, controller, allocate(layout, controller), runtime_py(runs, [])))


@pytest.mark.parametrize(
    ("was", "now", "do"),
    [
        ("{line_speed_kmh: 60}", "{line_speed_kmh: 100}", "signal A at proceed, no train before it: cancel route A-AA"),
        (
            "{line_speed_kmh: 60}",
            "{line_speed_kmh: 100}",
            "signal N1 at proceed, route AA-N1 and route A-AA set before it, a train in wa alone: cancel route N1-E",
        ),
        ("wa 400", "wa 100", "signal A at proceed, no train before it: cancel route A-AA"),
    ],
)
def test_from_where_a_train_may_come_is_tested(tmp_path: Path, was: str, now: str, do: str) -> None:
    """Approach locking of a signal before which nobody sees far enough, and of sections beyond the first."""
    changed = Changed(tmp_path, (was, now))
    assert do in [s.do for s in changed.again] and do in [s.do for s in changed.not_loaded()]
