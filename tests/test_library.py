"""The library keeps to its page where it is used in ways that nobody shows: frozen values, wrong arguments, pools."""

from __future__ import annotations

import multiprocessing
import pickle
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

import pytest

import interlock
from interlock.emit.bundle import write_folder
from interlock.proof.engines.pool import run

SMALLEST = "layouts/fig2_2.yaml"


@cache
def compiled() -> interlock.Compiled:
    return interlock.compile(interlock.load(SMALLEST))


def test_outputs_cannot_be_changed_after_their_proof() -> None:
    files: Any = compiled().files
    with pytest.raises(TypeError):
        files["runtime.py"] = b"def scan(): ..."
    with pytest.raises(TypeError):
        del files["manifest.json"]
    made = {"a": b"1"}
    taken = replace(compiled(), files=made)
    made["a"] = b"2"
    assert taken.files == {"a": b"1"}


def test_outputs_go_from_one_process_to_another() -> None:
    again = pickle.loads(pickle.dumps(compiled()))
    assert (again.layout.digest, again.files) == (compiled().layout.digest, compiled().files)
    assert (again.proof, again.proved, again.diagnostics) == (compiled().proof, True, ())
    with pytest.raises(TypeError):
        again.files["runtime.py"] = b""


@pytest.mark.parametrize("name", ["../evil.txt", "st/../../evil.txt", "/tmp/evil.txt", "..", "", "."])
def test_nothing_is_written_beside_a_folder_of_outputs(name: str, tmp_path: Path) -> None:
    target = tmp_path / "out" / "mine"
    with pytest.raises(ValueError, match="no place in a folder"):
        write_folder(target, {"a.txt": b"", name: b"x"})
    assert not [p for p in tmp_path.rglob("*") if p.is_file()] and not target.exists()


WRONG: list[tuple[dict[str, Any], type[Exception], str]] = [
    ({"jobs": "2"}, TypeError, "jobs is a whole number, and '2' is of type str"),
    ({"jobs": 1.5}, TypeError, "jobs is a whole number, and 1.5 is of type float"),
    ({"jobs": None}, TypeError, "jobs is a whole number, and None is of type NoneType"),
    ({"jobs": 0}, ValueError, "jobs is 0; it must be above 0"),
    ({"search_depth": "a"}, TypeError, "search_depth is a whole number, and 'a' is of type str"),
    ({"search_seconds": "x"}, TypeError, "search_seconds is a number, and 'x' is of type str"),
    ({"search_seconds": float("nan")}, ValueError, "search_seconds is nan; it must be above 0"),
    ({"progress": 3}, TypeError, r"progress is a function \(stage, done, total\), and 3 is of type int"),
]


@pytest.mark.parametrize(("arguments", "kind", "said"), WRONG, ids=lambda x: str(x))
def test_an_argument_of_another_kind_is_named(arguments: dict[str, Any], kind: type[Exception], said: str) -> None:
    layout = interlock.load(SMALLEST)
    with pytest.raises(kind, match=f"^{said}$"):
        interlock.prove(layout, interlock.lower(layout, interlock.derive(layout)), **arguments)
    if not arguments.keys() & {"search_depth", "search_seconds"}:
        with pytest.raises(kind, match=f"^{said}$"):
            interlock.compile(layout, **arguments)


def in_a_worker(jobs: int) -> tuple[bool, list[int]]:
    """Whether this process may begin none itself, and what two tasks return."""
    return multiprocessing.current_process().daemon, run([lambda: 1, lambda: 2], jobs)


def test_a_worker_that_may_begin_no_process_does_all_itself() -> None:
    with multiprocessing.get_context("fork").Pool(1) as pool:
        assert pool.apply_async(in_a_worker, (2,)).get(timeout=60) == (True, [1, 2])
