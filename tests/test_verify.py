"""Certificates: accepted as shipped, rejected after any change, and sound in themselves."""

from __future__ import annotations

import hashlib
import json
import lzma
import random
import shutil
from dataclasses import dataclass
from itertools import pairwise, product
from pathlib import Path

import pytest

from interlock.logic.expr import FALSE, Expr, conj, disj, evaluate, implies, neg, var
from interlock.logic.lower import lower
from interlock.proof.certificate import engine
from interlock.proof.certificate.bundle import proof_bytes, proof_text, system_text
from interlock.proof.certificate.bundle import text as written
from interlock.proof.certificate.engine import prove_locally
from interlock.proof.certificate.facts import Fact, FactBase, Goal, GoalKind, Kind, split
from interlock.proof.certificate.refute import Search
from interlock.proof.claims import Facts, claims, strengthening
from interlock.proof.mutation.weakenings import KINDS
from interlock.proof.prover import start_claim
from interlock.proof.system.transition import System
from interlock.verify import Known, Rejected, main, pattern, read, verify
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
    base = FactBase(system.relation, system.initial, strengthening(facts), claims(facts), start_claim(system.loop))
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


def test_a_certificate_away_from_what_it_names_says_what_is_missing_and_where_it_was_looked_for(
    copy: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    away = tmp_path / "far" / "away" / "fig2_2"
    shutil.copytree(copy, away)
    assert main([str(away)]) == 1
    said = capsys.readouterr().out
    first = tmp_path / "far" / "generated/fig2_2/manifest.json"
    assert f"../../generated/fig2_2/manifest.json is not there (looked for at {first})" in said
    assert ", nor are 3 more of the 7 files" in said and "back as they lay to each other" in said
    assert "changed or written anew" not in said
    (copy / "needed.txt").unlink()
    assert main([str(copy)]) == 1
    said = capsys.readouterr().out
    assert f"needed.txt is not there (looked for at {copy / 'needed.txt'}): copy the certificate whole" in said


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


@pytest.mark.parametrize("lemma", [True, False])
@pytest.mark.parametrize("how", ["a line less", "a hint less", "another hint", "another literal"])
def test_a_proof_with_a_change_in_one_of_its_lines_is_rejected(copy: Path, lemma: bool, how: str) -> None:
    lines = lzma.decompress((copy / "proof.txt.xz").read_bytes()).decode().splitlines()
    rng = random.Random(9)
    places = [n for n, line in enumerate(lines) if n and (":" in line) is lemma]
    rejected = tried = 0
    for n in rng.sample(places, min(12, len(places))):
        clause, colon, hints = lines[n].rpartition(":")
        if how == "a line less":
            new = []
        elif how == "another literal":
            first, *rest = clause.split() or hints.split()
            changed = " ".join([str(-int(first) if clause else int(first) + 1), *rest])
            new = [f"{changed}{colon}{hints}" if clause else changed]
        else:
            first, *rest = hints.split()
            new = [f"{clause}{colon}{' '.join(rest if how == 'a hint less' else [str(int(first) + 1), *rest])}"]
        (copy / "proof.txt.xz").write_bytes(
            lzma.compress(("\n".join([*lines[:n], *new, *lines[n + 1 :]]) + "\n").encode())
        )
        signed(copy)
        tried += 1
        rejected += main([str(copy)]) == 1
    assert tried > 5 and rejected >= (0.5 if how == "another hint" else 1.0) * tried  # another may show it, too


EITHER = ("(| 1 2)", ("a", "b"))


def test_what_does_not_follow_is_shown_by_no_hints() -> None:
    known = Known([EITHER, ("(| !1 2)", ("a", "c"))])
    for goal, hints in ((("1", ("b",)), [0, 1]), (("(| 1 2)", ("b", "c")), [0]), (("(| 1 2)", ("a", "c")), [0, 1])):
        with pytest.raises(Rejected):
            known.check(known.literals(goal), hints)
    known.check(known.literals(("(| 1 2)", ("b", "c"))), [0, 1])


def test_a_lemma_speaks_of_what_has_a_number() -> None:
    known = Known([EITHER])
    known.lemma("1 2:0")
    for line in ("0:0", "1 2 3:0", "1 2 -3:0", "1:0", ":0", "1 2:2", "1 2:-1"):
        with pytest.raises(Rejected):
            known.lemma(line)


def test_constants_mean_what_they_say() -> None:
    known = Known([("(| (& 1 T) (| 2 F))", ("a", "b"))])
    goal = known.literals(("(| 1 2)", ("a", "b")))
    known.check(goal, [2, 4, 5, 8])
    for less in ([2, 5, 8], [4, 5, 8], [2, 4, 8]):
        with pytest.raises(Rejected):
            known.check(goal, less)


def test_what_stands_for_a_part_means_that_part() -> None:
    """Clause 0 to 2 say what 3 is: a and b; 3 the fact that a and b, or c.  Nobody may say otherwise of 3."""
    known = Known([("(| (& 1 2) 3)", ("a", "b", "c"))])
    assert [*map(sorted, known.clauses)] == [[-2, -1, 4], [-4, 1], [-4, 2], [3, 4]]
    known.check(known.literals(("(| 1 2)", ("a", "c"))), [3, 1])
    assert known.literals(("(| (& 1 2) 3)", ("a", "b", "d"))) == {4, 5} and len(known.clauses) == 4
    with pytest.raises(Rejected):
        known.check(known.literals(("1", ("a",))), [3, 1])


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
"""Clauses of the step: 0 !a' or a, 1 a' or !a, 2 the invariant; from 3 on the lemma, the step, and the claims."""


@pytest.mark.parametrize(
    ("lemma", "step", "first", "second", "good"),
    [
        ("1", "2 3", "4", "", True),  # from the definition; from the lemma; from the step
        ("1", "2 1", "4", "", True),
        ("3", "2 3", "4", "", False),  # a lemma that rests on itself
        ("1", "2 4", "4", "", False),  # a step that rests on itself
        ("1", "2 5", "4", "", False),  # a step that rests on a claim
        ("1", "2 3", "4", "6", False),  # a false claim that rests on itself
        ("1", "2 3", "4", "7", False),  # and on another false claim, which rests on it
        ("1", "2 3", "4", "-1", False),
        ("1", "2 3", "3:3\n4", "", False),  # what is learnt on the way and does not follow
        ("1", "2 3", "4", "3:6\n6", False),
        ("1", "2 3", "1:4\n5", "", True),  # what follows, and the claim from it
    ],
)
def test_a_goal_rests_only_on_what_is_proved_before_it(
    copy: Path, lemma: str, step: str, first: str, second: str, good: bool
) -> None:
    system = TINY if second else "\n".join(x for x in TINY.splitlines() if " b" not in x) + "\n"
    proof = ["interlock-proof 4", "0", lemma, step, first, *([second, "6"] if second else [])]
    (copy / "system.txt").write_text(system, encoding="utf-8")
    (copy / "proof.txt.xz").write_bytes(lzma.compress(("\n".join(proof) + "\n").encode()))
    signed(copy)
    assert (main([str(copy)]) == 0) is good


@dataclass
class Told:
    """Facts, and what is asked of them."""

    steps: list[Fact]
    asked: list[Expr]

    def goals(self) -> list[Goal]:
        return [Goal(GoalKind.CLAIM, 0, c, "told") for x in self.asked for c in split(x)]

    def facts(self, kind: GoalKind) -> list[Fact]:
        return self.steps


@pytest.mark.parametrize("seed", range(40))
def test_what_follows_is_shown_and_nothing_else(seed: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """Random clauses with conjunctions in them, at times contradictory: truth tables tell what follows."""
    monkeypatch.setattr(engine, "AT_ONCE", 1 + seed % 9)  # goals are asked in parts
    monkeypatch.setattr(engine, "PARTS", 31)
    rng = random.Random(seed)
    names = "abcdefg"

    def clause(size: int) -> Expr:
        def literal() -> Expr:
            x: Expr = var(rng.choice(names))
            if rng.random() < 0.25:
                x = (conj if rng.random() < 0.7 else disj)((x, neg(var(rng.choice(names)))))
            return x if rng.random() < 0.5 else neg(x)

        return disj([literal() for _ in range(size)])

    facts = [clause(rng.choice((1, 2, 3, 3, 3))) for _ in range(rng.randrange(4, 26))]
    goals = [*(clause(rng.choice((1, 2))) for _ in range(30)), FALSE]

    told = Told([Fact(Kind.INVARIANT, "told", c) for x in facts for c in split(x)], goals)
    proof = prove_locally(told)  # type: ignore[arg-type]
    rows = [dict(zip(names, v, strict=True)) for v in product((0, 1), repeat=len(names))]
    models = [row for row in rows if all(evaluate(f.clause, row.__getitem__, {}) for f in told.steps)]
    follows = [g.clause for g in told.goals() if all(evaluate(g.clause, row.__getitem__, {}) for row in models)]
    assert [o.goal.clause for o in proof.obligations] == follows
    known = Known([_said(f.clause) for f in told.steps])
    shown = iter(proof.obligations)
    for g in told.goals():
        goal = known.literals(_said(g.clause))
        if g.clause not in follows:
            continue
        o = next(shown)
        for lemma in o.lemmas:
            known.lemma(f"{' '.join(map(str, lemma.clause))}:{' '.join(map(str, lemma.hints))}")
        known.check(goal, [*o.hints])
        known.clauses.append(goal)
    assert all(
        n < o.number - k for o in proof.obligations for k, x in enumerate(reversed(o.lemmas), 1) for n in x.hints
    )
    assert all(n < o.number for o in proof.obligations for n in o.hints)


def test_a_goal_names_no_more_than_it_needs() -> None:
    """A chain of implications among others, goals that rest on each other, and one that needs two cases."""
    chain = [var(f"a{n}") for n in range(60)]
    facts = [implies(x, y) for n in range(20) for x, y in pairwise(var(f"{c}{n}") for c in "bcdefgh")]
    facts += [implies(x, y) for x, y in pairwise(chain)]
    p, q, r, s = map(var, "pqrs")
    facts += [disj(x) for x in ((p, q, r), (p, q, neg(r)), (p, neg(q), s), (p, neg(q), neg(s)))]
    goals = [implies(chain[0], chain[40]), implies(chain[0], chain[59]), p]
    told = Told([Fact(Kind.INVARIANT, "told", x) for x in facts], goals)
    first, second, third = prove_locally(told).obligations  # type: ignore[arg-type]
    assert (len(first.hints), len(second.hints)) == (40, 20)
    assert not first.lemmas and not second.lemmas and len(third.lemmas) <= 2
    named = {*third.hints, *(n for x in third.lemmas for n in x.hints)}
    assert named == {*range(len(facts) - 4, len(facts)), *range(third.number - len(third.lemmas), third.number)}


def test_a_clause_that_the_solver_numbers_otherwise_makes_no_certificate(monkeypatch: pytest.MonkeyPatch) -> None:
    """Whatever became of the numbers: what is written is accepted by its checker, or there is no certificate."""
    real = Search.settle

    def unnoticed(self: Search, first: int, last: int) -> None:
        self._solver.add_clause([self._top + 100, self._top + 101])
        real(self, first, last)

    monkeypatch.setattr(Search, "settle", unnoticed)
    system = System(*built("fig2_2")[::2])
    facts = Facts(system)
    base = FactBase(system.relation, system.initial, strengthening(facts), claims(facts), start_claim(system.loop))
    with pytest.raises((Rejected, ValueError, LookupError)):
        files = {"system.txt": system_text(base).encode(), "proof.txt.xz": proof_bytes(prove_locally(base))}
        verify(Path("nowhere"), files)


def _said(x: Expr) -> tuple[str, tuple[str, ...]]:
    numbers: dict[str, int] = {}
    return pattern(read(written(x)), numbers), tuple(numbers)


def test_splitting_says_the_same() -> None:
    a, b, c, d = map(var, "abcd")
    x = implies(a, conj((b, disj((c, d)), neg(disj((c, conj((a, d))))))))
    for values in product((0, 1), repeat=4):
        env = dict(zip("abcd", values, strict=True))
        parts = [evaluate(y, env.__getitem__, {}) for y in split(x)]
        assert all(parts) == evaluate(x, env.__getitem__, {})


def local(name: str, controller=None):  # type: ignore[no-untyped-def]
    layout, _, own = built(name)
    system = System(layout, controller or own)
    facts, start = Facts(system), start_claim(system.loop)
    return prove_locally(FactBase(system.relation, system.initial, strengthening(facts), claims(facts), start))


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
