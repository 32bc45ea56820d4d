"""Answers kept from one run to the next: used for the very same question, never for another, never when damaged."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest
from click.testing import CliRunner

from interlock.app import kept
from interlock.app.init import yard
from interlock.app.prove import prove_file
from interlock.app.proved import Proved
from interlock.cli.prove import command
from interlock.model.contents import digest
from interlock.model.elements import Position, SectionId
from interlock.proof.engines import batch
from interlock.proof.engines.cache import Cache, key_file
from interlock.proof.engines.limits import Limits
from interlock.proof.induction.verdict import ProofResult, Verdict
from interlock.proof.mutation.weakenings import KINDS
from interlock.proof.prover import prove
from interlock.proof.system.transition import System
from interlock.table.cells import Because, ClearCell, FlankCell
from tests.layouts import built


@pytest.fixture
def solvers(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """The engines of the solvers that were made for parts of the induction."""
    made: list[str] = []
    make = batch.solver

    def counted(engine: str, *rest: object) -> object:
        made.append(engine)
        return make(engine, *rest)  # type: ignore[arg-type]

    monkeypatch.setattr(batch, "solver", counted)
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
    for file in tmp_path.iterdir():
        file.write_bytes(file.read_bytes()[:-1])
    assert proved(tmp_path, system).proved and len(solvers) == 2 * asked


def moved(text: str) -> str:
    """A layout with one length changed, which no rule of it depends on."""
    assert text.count("[W1, Wa1 300]") == 1
    return text.replace("[W1, Wa1 300]", "[W1, Wa1 310]")


@pytest.fixture
def layout(tmp_path: Path) -> Path:
    file = tmp_path / "yard.yaml"
    file.write_text(yard(4))
    return file


def again(file: Path) -> Proved:
    return prove_file(str(file), Limits(search_depth=12, cache=Cache(file.parent / "kept")))


def test_a_change_that_changes_nothing_that_is_proved_asks_nothing(
    layout: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    first = again(layout)
    assert first.green and first.proof is not None and not first.proof.kept

    def never(*given: object) -> None:
        raise AssertionError("a question, a run or a text")

    monkeypatch.setattr("interlock.app.making.prove", never)
    monkeypatch.setattr("interlock.app.making.writers", never)
    layout.write_text(moved(yard(4)))
    second = again(layout)
    assert second.green and second.proof is not None and second.proof.kept
    assert told(second.proof) == told(first.proof) and second.texts == first.texts
    assert second.proof.witnesses == first.proof.witnesses
    assert (second.proof.invariants, second.proof.obligations) == (first.proof.invariants, first.proof.obligations)


def test_another_controller_another_program_and_a_damaged_file_are_proved_anew(
    layout: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def kept(result: Proved) -> bool:
        assert result.green and result.proof is not None
        return result.proof.kept

    assert not kept(again(layout)) and kept(again(layout))
    text = layout.read_text()
    for before, after in (("overlap_release_s: 45", "overlap_release_s: 50"), ("name: yard4", "name: other")):
        assert before in text
        layout.write_text(text.replace(before, after))
        assert not kept(again(layout)), after
    layout.write_text(text)
    monkeypatch.setattr("interlock.app.kept._program", lambda: "another")
    assert not kept(again(layout)) and kept(again(layout))
    for file in (layout.parent / "kept").iterdir():
        body = file.read_bytes()
        file.write_bytes(body[:20] + bytes([body[20] ^ 1]) + body[21:] if len(body) > 20 else body)
    assert not kept(again(layout))


@pytest.mark.parametrize("file", ["junction", "flank_lab", "depot", "cn6502"])
def test_a_proof_is_named_by_the_lengths_that_matter(file: str) -> None:
    """A metre far from everything changes nothing; a joint that fouls a point does."""
    layout, table, _ = built(file)

    def name(scale: float, foul: float = 1.0) -> str:
        edges = tuple(replace(e, length=e.length * scale) for e in layout.track.edges)
        points = tuple(replace(p, fouling=p.fouling * foul) for p in layout.pointwork.points)
        return kept.name(
            Limits(cache=Cache(Path("x"))),
            replace(
                layout, track=replace(layout.track, edges=edges), pointwork=replace(layout.pointwork, points=points)
            ),
            table,
        )

    assert name(1.0) == name(1.0 - 1e-9) != name(0.001)  # a nanometre more may take the next whole millisecond
    assert name(1.0) != name(1.0, foul=100.0)


def test_what_is_not_proved_is_not_kept(tmp_path: Path) -> None:
    file = tmp_path / "refuted.yaml"
    file.write_text(next(Path("layouts/refuted").glob("*.yaml")).read_text())
    for _ in range(2):
        result = again(file)
        assert not result.green and result.proof is not None and not result.proof.kept


def test_values_that_differ_have_other_digests() -> None:
    values: list[object] = [
        "a", ("a",), "ab", ("ab",), ("a", "b"), (("a",), "b"), ("a", ("b",)), {"a": "b"}, {"b": "a"}, 1, "1", True, 1.0,
        None, (), 5.5, frozenset({"a"}), Because("R1", "a"), Because("R1", "b"), ClearCell(SectionId("a"), Because("R1",
        "a")), FlankCell("a", SectionId("b"), (), Because("R1", "a")), Limits(), Limits(jobs=2), "s1:a", ("s1:a", "b"),
    ]  # fmt: skip
    digests = [digest(x) for x in values]
    assert len(set(digests)) == len(values)
    assert digest(["a", "b"]) == digest(("a", "b")) != digest("a", "b")
    assert digest(Position.NORMAL) == digest("N")
    with pytest.raises(TypeError):
        digest(object())


def test_the_command_keeps_answers_where_it_is_told(tmp_path: Path) -> None:
    for _ in range(2):
        result = CliRunner().invoke(command, ["layouts/fig2_2.yaml", "--cache", str(tmp_path / "kept")])
        assert result.exit_code == 0 and "PROVED" in result.output
    assert list((tmp_path / "kept").iterdir())
    (tmp_path / "file").touch()
    assert CliRunner().invoke(command, ["layouts/fig2_2.yaml", "--cache", str(tmp_path / "file")]).exit_code == 2


def test_a_folder_that_keeps_nothing_is_told(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "file").touch()
    assert Cache(tmp_path / "file" / "kept").useless() == "Not a directory"
    assert Cache(tmp_path / "kept").useless() == "" and Cache().useless() == ""

    def homeless() -> Path:
        raise RuntimeError("Could not determine home directory.")

    monkeypatch.delenv("XDG_CONFIG_HOME", raising=False)
    monkeypatch.setattr(Path, "home", homeless)
    told = CliRunner().invoke(command, ["layouts/fig2_2.yaml", "--cache", str(tmp_path / "kept")])
    assert told.exit_code == 0 and "nothing is kept: no key of your own" in told.output
    assert not any((tmp_path / "kept").iterdir())


def test_the_key_is_the_users_own(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Made at first use, for this user alone, beside no answer; another user's answers are not believed, and with a key
    that others can read nothing is kept or believed."""
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path / "mine"))
    cache, name = Cache(tmp_path / "kept"), "a" * 64
    cache.keep(name, [True])
    key = key_file()
    assert key.is_relative_to(tmp_path / "mine") and key.stat().st_mode & 0o777 == 0o600
    assert cache.known(name, 1) == [True] and cache.foreign() == 0
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path / "another"))
    assert cache.known(name, 1) == [False] and cache.foreign() == 1 and key_file() != key
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path / "open"))
    key_file().parent.mkdir(parents=True)
    key_file().write_bytes(key.read_bytes())
    key_file().chmod(0o644)
    assert cache.known(name, 1) == [False]
    cache.keep("b" * 64, [True])
    assert not (tmp_path / "kept" / ("b" * 64)).exists()
