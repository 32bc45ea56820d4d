"""Answers kept from one run to the next: used for the very same question, never for another, never when damaged."""

from __future__ import annotations

from pathlib import Path

import pytest
from click.testing import CliRunner

from interlock.cli.prove import command
from interlock.proof import parts
from interlock.proof.cache import Cache
from interlock.proof.limits import Limits
from interlock.proof.mutate import KINDS
from interlock.proof.runner import ProofResult, Verdict, prove
from interlock.proof.system import System
from tests.layouts import built


@pytest.fixture
def solvers(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """The engines of the solvers that were made for parts of the induction."""
    made: list[str] = []
    make = parts.solver

    def counted(engine: str, *rest: object) -> object:
        made.append(engine)
        return make(engine, *rest)  # type: ignore[arg-type]

    monkeypatch.setattr(parts, "solver", counted)
    return made


def proved(folder: Path, system: System, engine: str = "minisat") -> ProofResult:
    return prove(system, Limits(search_depth=12, engine=engine, cache=Cache(folder)))


def told(result: ProofResult) -> list[tuple[str, Verdict, tuple[str, ...]]]:
    return [(c.id, c.verdict, c.open) for c in result.claims]


def test_a_second_run_asks_nothing_and_says_the_same(tmp_path: Path, solvers: list[str]) -> None:
    layout, _, controller = built("passing_loop")
    system = System(layout, controller)
    first = proved(tmp_path, system)
    asked = len(solvers)
    assert asked and first.proved
    second = proved(tmp_path, system)
    assert len(solvers) == asked and told(second) == told(first) and second.proved
    proved(tmp_path, system, "z3")
    assert len(solvers) > asked, "another engine is another opinion"


def test_a_weakened_controller_is_refuted_after_the_sound_one_was_kept(tmp_path: Path) -> None:
    layout, table, controller = built("passing_loop")
    assert proved(tmp_path, System(layout, controller)).proved
    _, weak = next(next(k for k in KINDS if k.name == "section-not-checked").make(layout, table))
    result = proved(tmp_path, System(layout, weak))
    assert not result.proved and Verdict.REFUTED in {c.verdict for c in result.claims}
    again = proved(tmp_path, System(layout, weak))
    assert told(again) == told(result), "and what did not follow is asked again"


def test_a_damaged_answer_is_not_believed(tmp_path: Path, solvers: list[str]) -> None:
    """Every single change of a byte, a lost end, and an answer under another question's name."""
    cache = Cache(tmp_path)
    cache.keep("a" * 64, [True, False, True])
    assert cache.known("a" * 64, 3) == [True, False, True]
    assert cache.known("a" * 64, 4) == [False] * 4 and cache.known("b" * 64, 3) == [False] * 3
    file = tmp_path / ("a" * 64)
    whole = file.read_bytes()
    for at in range(len(whole)):
        for other in {ord("0"), ord("1"), whole[at] ^ 1} - {whole[at]}:
            file.write_bytes(whole[:at] + bytes([other]) + whole[at + 1 :])
            assert cache.known("a" * 64, 3) == [False] * 3
        file.write_bytes(whole[:at])
        assert cache.known("a" * 64, 3) == [False] * 3
    (tmp_path / ("b" * 64)).write_bytes(whole)
    assert cache.known("b" * 64, 3) == [False] * 3

    layout, _, controller = built("fig2_2")
    system = System(layout, controller)
    proved(tmp_path, system)
    asked = len(solvers)
    for kept in tmp_path.iterdir():
        kept.write_bytes(kept.read_bytes()[:-1])
    assert proved(tmp_path, system).proved and len(solvers) == 2 * asked


def test_the_command_keeps_answers_where_it_is_told(tmp_path: Path) -> None:
    for _ in range(2):
        result = CliRunner().invoke(command, ["layouts/fig2_2.yaml", "--cache", str(tmp_path / "kept")])
        assert result.exit_code == 0 and "PROVED" in result.output
    assert list((tmp_path / "kept").iterdir())
    (tmp_path / "file").touch()
    assert CliRunner().invoke(command, ["layouts/fig2_2.yaml", "--cache", str(tmp_path / "file")]).exit_code == 2
