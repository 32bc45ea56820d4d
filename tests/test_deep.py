"""Many sections in a row without a main signal: their locks are given up one after the other, each a bracket in the one
before."""

from __future__ import annotations

import pytest

from interlock.emit.python.runtime import runtime_py
from interlock.logic.lower import lower
from interlock.proof.equivalence.python_text import compare_runtime
from tests.layouts import grown


def line(sections: int) -> str:
    """A line of so many sections between its entry signal and the next one."""
    between = ", ".join(f"s{i} 50" for i in range(sections))
    return (
        "interlock: 1\nname: deep\nprinciples: {restart_delay_s: 3600}\n"
        "boundaries: {W: {approach: w0 900}, E: {trains: out}}\n"
        f"tracks:\n  a: [W, a0 100, {between}, z 100, E]\n"
        f"signals:\n  A: {{from: W, into: a0}}\n  B: {{from: s{sections - 1}, into: z}}\n"
    )


@pytest.mark.parametrize("sections", [40, 90])
def test_a_runtime_of_many_sections_in_a_row_is_read(sections: int) -> None:
    found = grown(line(sections))
    assert found is not None and not found[2].has_errors
    controller = lower(*found[:2])
    text = runtime_py(controller, [])
    assert compare_runtime(controller, text).differences == ()
    names: dict[str, object] = {}
    exec(text, names)  # Python reads it, too


def test_one_that_python_does_not_read_is_refused_and_told_why() -> None:
    found = grown(line(120))
    assert found is not None and not found[2].has_errors
    controller = lower(*found[:2])
    (one,) = compare_runtime(controller, runtime_py(controller, [])).differences
    assert "more than 190 brackets stand in each other" in one.text and "main signals on the way" in one.text
