"""A process that goes on does not grow: nothing of a layout, a controller or a proof is kept (`benchmarks.memory`)."""

from __future__ import annotations

import ast
import gc
import sys
import threading
from pathlib import Path

import pytest

import interlock
from benchmarks.memory import lowered, proved
from interlock.diag import Sink
from interlock.frontend import load_text
from interlock.logic.expr import current_table, interning, var
from tests.layouts import built

ONE_LAYOUT = 500
"""Blocks of memory: ten small layouts alone, not derived, have more."""


def blocks() -> int:
    """Blocks of memory in use."""
    gc.collect()
    return sys.getallocatedblocks()


@pytest.mark.parametrize(("task", "count"), [(lowered, 100), (proved, 12)])
def test_memory_is_given_back(task: object, count: int) -> None:
    assert callable(task)
    for n in range(8):
        task(10_000 + n)
    before, nodes = blocks(), len(current_table())
    for n in range(count):
        task(n)
    assert blocks() - before < ONE_LAYOUT and len(current_table()) == nodes


def test_ten_layouts_that_are_kept_would_be_seen() -> None:
    text = Path("layouts/fig2_2.yaml").read_text("utf-8")
    load_text("l.yaml", text, Sink())

    def grown() -> int:
        before = blocks()
        kept = [load_text("l.yaml", text, Sink()) for _ in range(10)]
        return blocks() - before if kept else 0

    assert any(grown() > ONE_LAYOUT for _ in range(5))  # what other threads give back meanwhile may hide it once


def test_expressions_are_of_the_table_in_use() -> None:
    outside = var("a")
    with interning() as table:
        inside = var("a")
        assert inside is not outside and inside is var("a") and len(table) == 1
        with interning(table):
            assert var("a") is inside
    assert var("a") is outside


def test_threads_take_turns() -> None:
    """Two proofs begun at once, each with its own table, are those that would be made one after the other."""
    found: dict[int, bool] = {}

    def work(n: int) -> None:
        layout = interlock.load("layouts/fig2_2.yaml")
        found[n] = interlock.prove(layout, interlock.lower(layout, interlock.derive(layout))).proved

    threads = [threading.Thread(target=work, args=(n,)) for n in range(2)]
    for t in threads:
        t.start()
    for t in threads:
        t.join()
    assert found == {0: True, 1: True}


def test_a_controller_is_proved_with_the_table_that_it_was_made_with() -> None:
    layout, table, _ = built("fig2_2")
    controller = interlock.lower(layout, table)
    assert controller.nodes is not current_table() and len(controller.nodes) > 100
    before = len(current_table())
    assert interlock.prove(layout, controller).proved and len(current_table()) == before


def test_nothing_is_remembered_without_a_bound() -> None:
    """No function of values is cached without a limit, and no module begins with an empty collection to be filled."""
    found = set()
    for path in Path("interlock").rglob("*.py"):
        tree = ast.parse(path.read_text("utf-8"))
        for x in ast.walk(tree):
            if isinstance(x, ast.FunctionDef) and x.args.args:
                for d in map(ast.unparse, x.decorator_list):
                    if d in ("cache", "functools.cache") or ("lru_cache" in d and ("None" in d or "(" not in d)):
                        found.add(f"{path}:{x.name}")
            if isinstance(x, ast.Call) and ast.unparse(x.func).endswith("cache") and "None" in map(ast.unparse, x.args):
                found.add(f"{path}:{x.lineno}")
        for x in tree.body:
            value = x.value if isinstance(x, (ast.Assign, ast.AnnAssign)) else None
            if value is not None and ast.unparse(value) in ("{}", "[]", "set()", "dict()", "list()"):
                found.add(f"{path}:{x.lineno}")
    assert found == set()
