"""Certificates: accepted as shipped, rejected after any change, and sound in themselves."""

from __future__ import annotations

import hashlib
import json
import lzma
import random
import shutil
from pathlib import Path

import pytest

from interlock.logic.expr import conj, disj, implies, neg, var
from interlock.logic.lower import lower
from interlock.proof.certificate.bundle import proof_text, system_text
from interlock.proof.certificate.engine import prove_locally
from interlock.proof.certificate.facts import FactBase, split
from interlock.proof.claims import Facts, claims, strengthening
from interlock.proof.mutation.weakenings import KINDS
from interlock.proof.prover import start_claim
from interlock.proof.system.transition import System
from interlock.verify import Form, Part, Rejected, Shape, main, verify
from interlock.verify import System as Written
from tests.campaigns.certificates import COMMITTED
from tests.layouts import SHIPPED, built

ROOT = Path(__file__).resolve().parent.parent


@pytest.mark.parametrize("name", COMMITTED)
def test_every_committed_proof_is_accepted(name: str) -> None:
    assert "claims" in verify(ROOT / "proofs" / name)


@pytest.mark.parametrize("name", SHIPPED)
def test_every_digest_is_of_the_system_that_the_layout_gives(name: str) -> None:
    layout, _, controller = built(name)
    system = System(layout, controller)
    facts = Facts(system)
    base = FactBase(system, strengthening(facts), claims(facts), start_claim(system))
    text = system_text(base)
    digest = hashlib.sha256(text.encode()).hexdigest()
    assert f"{name} system.txt {digest}\n" in (ROOT / "proofs/digests.txt").read_text("utf-8")
    if name in COMMITTED:
        assert (ROOT / "proofs" / name / "system.txt").read_text("utf-8") == text


def test_the_checker_is_short_and_stands_alone() -> None:
    text = (ROOT / "interlock" / "verify.py").read_text("utf-8")
    assert len(text.splitlines()) < 450
    modules = {line.split()[1] for line in text.splitlines() if line.startswith(("import ", "from "))}
    assert modules <= {
        "__future__",
        "collections.abc",
        "functools",
        "itertools",
        "hashlib",
        "json",
        "lzma",
        "pathlib",
        "sys",
        "typing",
        "unicodedata",
    }


@pytest.fixture
def copy(tmp_path: Path) -> Path:
    """A shipped bundle with everything that it names, to be spoiled."""
    for part in ("proofs/fig2_2", "generated/fig2_2"):
        shutil.copytree(ROOT / part, tmp_path / part)
    (tmp_path / "layouts").mkdir()
    shutil.copy(ROOT / "layouts/fig2_2.yaml", tmp_path / "layouts")
    assert verify(tmp_path / "proofs/fig2_2")
    return tmp_path / "proofs/fig2_2"


def files_of(folder: Path) -> list[Path]:
    """Every file of a bundle: those that the manifest names, and the manifest."""
    named = json.loads((folder / "manifest.json").read_text("utf-8"))["files"]
    return [folder / "manifest.json", *((folder / n).resolve() for n in named)]


def test_any_change_of_one_byte_is_rejected(copy: Path) -> None:
    rng = random.Random(5)
    for path in files_of(copy):
        data = path.read_bytes()
        for _ in range(6):
            spoiled = bytearray(data)
            spoiled[rng.randrange(len(data))] ^= rng.randrange(1, 256)
            path.write_bytes(spoiled)
            assert main([str(copy)]) == 1, path
        path.write_bytes(data)
    assert main([str(copy)]) == 0


def signed(folder: Path) -> None:
    """Make the digests of a bundle agree again: what is left must be found by reasoning."""
    manifest = json.loads((folder / "manifest.json").read_text("utf-8"))
    manifest.pop("own")
    for name in manifest["files"]:
        manifest["files"][name] = hashlib.sha256((folder / name).read_bytes()).hexdigest()
    own = hashlib.sha256(json.dumps(manifest, sort_keys=True).encode()).hexdigest()
    text = json.dumps({**manifest, "own": own}, indent=1, ensure_ascii=False) + "\n"
    (folder / "manifest.json").write_text(text, encoding="utf-8")


@pytest.mark.parametrize(("lines", "share"), [(("claim", "inv", "start"), 1.0), (("def", "asm", "ini"), 0.6)])
def test_a_system_that_was_changed_and_signed_again_is_rejected(
    copy: Path, lines: tuple[str, ...], share: float
) -> None:
    """What is claimed cannot be changed; of the rest, only what no goal needs (an alarm, say) may differ."""
    text = (copy / "system.txt").read_text("utf-8").splitlines()
    rng = random.Random(7)
    places = [n for n, line in enumerate(text) if line.split()[0] in lines and "(" in line]
    tried = rejected = 0
    for n in rng.sample(places, min(50, len(places))):
        head, _, x = text[n].partition("(")
        x = x.replace("&", "|", 1) if "&" in x else x.replace("!", "", 1) if "!" in x else "& T " + x.split(" ", 1)[1]
        (copy / "system.txt").write_text("\n".join([*text[:n], f"{head}({x}", *text[n + 1 :]]) + "\n", encoding="utf-8")
        signed(copy)
        tried += 1
        rejected += main([str(copy)]) == 1
    assert tried >= 15 and rejected >= share * tried


@pytest.mark.parametrize("kind", ["pattern", "part", "shape", "steps", "goals", ""])
def test_a_proof_without_one_of_its_lines_is_rejected(copy: Path, kind: str) -> None:
    lines = lzma.decompress((copy / "proof.txt.xz").read_bytes()).decode().splitlines()
    rng = random.Random(9)
    places = [n for n, line in enumerate(lines) if (line.split()[0] == kind if kind else line[0].isdigit())]
    for n in rng.sample(places, min(8, len(places))):
        less = "\n".join([*lines[:n], *lines[n + 1 :]]) + "\n"
        (copy / "proof.txt.xz").write_bytes(lzma.compress(less.encode()))
        signed(copy)
        assert main([str(copy)]) == 1, lines[n]


def test_a_satisfiable_shape_has_no_refutation() -> None:
    either = Form("(| 1 2)")
    shape = Shape(either, [Part(either, [1, 3])])
    shape.steps = [([], [0, 2])]
    with pytest.raises(Rejected):
        shape.check()
    shape = Shape(either, [Part(either, [1, 2])])
    shape.steps = [([], [0, 1, 2])]
    shape.check()


def test_definitions_in_a_circle_are_rejected() -> None:
    for circle in ("def w (| a v)\ndef v (& w a)\ndef a' w\n", "def a' (| a a')\n"):
        with pytest.raises(Rejected, match="comes after"):
            Written(f"interlock-system 2\nstate a\n{circle}")


@pytest.mark.parametrize("word", ["!", "!!a", "(& a !)", "a b", "(a b)", "(& a", "& a", "()", "(| )( a)"])
def test_a_malformed_expression_is_rejected(word: str) -> None:
    with pytest.raises(Rejected, match="malformed"):
        Written(f"interlock-system 2\nstate a\ndef a' {word}\n")


@pytest.mark.parametrize("invariant", ["(| a u)", "(| !a a')", "(| a w)", "(| a u=1)"])
def test_an_invariant_that_speaks_of_more_than_the_state_is_rejected(invariant: str) -> None:
    """The induction would take what is given in one step for what is given in the next."""
    with pytest.raises(Rejected, match="more than the state"):
        Written(f"interlock-system 2\nstate a\ndef w u\ndef a' !a\ninv I p {invariant}\n")


@pytest.mark.parametrize("line", ["inv I a", "claim C a", "asm A", "def w", "val r"])
def test_a_line_without_all_its_words_is_rejected(line: str) -> None:
    with pytest.raises(Rejected, match="without all its words"):
        Written(f"interlock-system 2\nstate a\ndef a' a\n{line}\n")


def test_values_of_what_is_computed_exclude_nothing() -> None:
    """That it has one value at a time would have to be proved."""
    with pytest.raises(Rejected, match="is no input"):
        Written("interlock-system 2\nstate a\ndef r=1 a\ndef r=2 a\ndef a' a\nval r 3\n")


TINY = """interlock-system 2
state a
ini a
def a' a
lemma (| !a a')
inv I p a
claim C p a'
claim D p b
claim D q b
"""
"""Facts of the step: 0 !a' or a, 1 a' or !a, 2 the invariant; from 3 on the lemma, the step, and the claims."""


@pytest.mark.parametrize(
    ("lemma", "step", "first", "second", "good"),
    [
        ("1 1", "2 3 2", "0 4", "", True),  # from the definition; from the lemma; from the step
        ("1 1", "2 1 2", "0 4", "", True),
        ("1 3", "2 3 2", "0 4", "", False),  # a lemma that rests on itself
        ("1 1", "2 3 4", "0 4", "", False),  # a step that rests on itself
        ("1 1", "2 3 5", "0 4", "", False),  # a step that rests on a claim
        ("1 1", "2 3 2", "0 4", "0 6", False),  # a false claim that rests on itself
        ("1 1", "2 3 2", "0 4", "0 7", False),  # and on another false claim, which rests on it
        ("1 1", "2 3 2", "0 4", "0 -1", False),
    ],
)
def test_a_goal_rests_only_on_what_is_proved_before_it(
    copy: Path, lemma: str, step: str, first: str, second: str, good: bool
) -> None:
    system = TINY if second else "\n".join(x for x in TINY.splitlines() if " b" not in x) + "\n"
    goals = ["0 0", lemma, step, first, *([second, "0 6"] if second else [])]
    proof = ["interlock-proof 3", "pattern 1", "pattern (| !1 2)", "part 0 1", "part 1 1 2", "part 1 2 1", "part 0 2"]
    for facts, steps in (("0 0", ":0,1"), ("1 1", ":0,1,2"), ("0 2 3", ":0,1,2")):
        proof += [f"shape {facts}", f"steps {steps}"]
    proof += [f"goals {len(goals)}", *goals]
    (copy / "system.txt").write_text(system, encoding="utf-8")
    (copy / "proof.txt.xz").write_bytes(lzma.compress(("\n".join(proof) + "\n").encode()))
    signed(copy)
    assert (main([str(copy)]) == 0) is good


def test_splitting_says_the_same() -> None:
    a, b, c, d = map(var, "abcd")
    x = implies(a, conj((b, disj((c, d)), neg(disj((c, conj((a, d))))))))
    from itertools import product

    from interlock.logic.expr import evaluate

    for values in product((0, 1), repeat=4):
        env = dict(zip("abcd", values, strict=True))
        parts = [evaluate(y, env.__getitem__, {}) for y in split(x)]
        assert all(parts) == evaluate(x, env.__getitem__, {})


def local(name: str, controller=None):  # type: ignore[no-untyped-def]
    layout, _, own = built(name)
    system = System(layout, controller or own)
    facts = Facts(system)
    return prove_locally(FactBase(system, strengthening(facts), claims(facts), start_claim(system)))


def test_the_same_proof_gives_the_same_bytes() -> None:
    assert proof_text(local("fig2_2")) == proof_text(local("fig2_2"))


@pytest.mark.parametrize("kind", ["point-missing", "release-occupied", "cancel-with-train", "restart-unlocked"])
def test_no_certificate_for_a_mutant(kind: str) -> None:
    layout, table, _ = built("fig2_2")
    made = next(k for k in KINDS if k.name == kind)
    _, controller = next(made.make(layout, table))
    proof = local("fig2_2", controller)
    assert proof.open
    with pytest.raises(ValueError, match="not proved"):
        proof_text(proof)


def test_lower_is_what_is_certified() -> None:
    layout, table, controller = built("fig2_2")
    assert lower(layout, table) == controller


def test_a_certificate_that_is_not_current_is_named(tmp_path: Path) -> None:
    from click.testing import CliRunner

    from interlock.cli.certify import command
    from interlock.cli.compile import command as compile_

    outputs = str(tmp_path / "generated")
    assert CliRunner().invoke(compile_, ["layouts/fig2_2.yaml", "-o", outputs]).exit_code == 0
    check = ["layouts/fig2_2.yaml", "--check", "--outputs", outputs]
    run = CliRunner().invoke(command, [*check, "-o", str(tmp_path / "nothing")])
    assert run.exit_code == 1 and "IL5007" in run.output
    run = CliRunner().invoke(command, check)
    assert run.exit_code == 0 and "CURRENT" in run.output
    run = CliRunner().invoke(command, ["layouts/fig2_2.yaml", "--outputs", str(tmp_path)])
    assert run.exit_code == 1 and "IL5003" in run.output


def test_a_certificate_ties_the_texts_of_every_dialect_that_was_written(tmp_path: Path) -> None:
    from click.testing import CliRunner

    from interlock.cli.certify import command
    from interlock.cli.compile import command as compile_

    outputs, proofs = tmp_path / "generated", tmp_path / "proofs"
    wanted = ["layouts/fig2_2.yaml", "-o", str(outputs), "--dialect", "scl300", "--dialect", "c99"]
    assert CliRunner().invoke(compile_, wanted).exit_code == 0
    made = CliRunner().invoke(command, ["layouts/fig2_2.yaml", "--outputs", str(outputs), "-o", str(proofs)])
    assert made.exit_code == 0, made.output
    written = (proofs / "fig2_2" / "manifest.json").read_text()
    assert "st/iec/fig2_2.st" in written and "c99/fig2_2.c" in written
    source = next((outputs / "fig2_2" / "st").rglob("*.scl"))
    assert str(source.relative_to(outputs)) in written
    source.write_text(source.read_text() + "\n")
    with pytest.raises(Rejected, match=source.name):
        verify(proofs / "fig2_2")
