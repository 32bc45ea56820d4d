"""The shipped shapes: each is refuted, they serve, and a spoiled file does no harm."""

from __future__ import annotations

import lzma
from dataclasses import replace
from functools import cache
from pathlib import Path

import pytest

from interlock.app.certify import certify_file
from interlock.app.compile import compile_file
from interlock.logic.lower import lower
from interlock.proof.certificate import library
from interlock.proof.certificate.engine import LocalProof, prove_locally
from interlock.proof.certificate.facts import FactBase
from interlock.proof.certificate.library import SHIPPED, Library, read
from interlock.proof.claims import Facts, claims, strengthening
from interlock.proof.prover import start_claim
from interlock.proof.system.transition import System
from interlock.verify import Form, Part, Shape
from tests.layouts import built

TEXT = lzma.decompress(SHIPPED.read_bytes()).decode()


def local(name: str, known: Library) -> LocalProof:
    layout, table, _ = built(name)
    system = System(layout, lower(layout, table))
    facts = Facts(system)
    return prove_locally(FactBase(system, strengthening(facts), claims(facts), start_claim(system)), known)


def test_every_shipped_shape_is_refuted_by_the_checker() -> None:
    known = read(TEXT)
    form = cache(Form)
    count = 0
    for goal, lines in known.lines.items():
        for line in lines:
            facts, _, steps = line.partition("/")
            parts = []
            for word in facts.split():
                number, _, leaves = word.partition(":")
                pattern = known.patterns[int(number)].split(":", 1)[1]
                parts.append(Part(form(pattern), [int(n) + 1 for n in leaves.split(",") if n]))
            shape = Shape(form(goal.split(":", 1)[1]), parts)
            for word in steps.split():
                lits, _, hints = word.partition(":")
                shape.steps.append(([int(x) for x in lits.split(",") if x], [*map(int, hints.split(","))]))
            shape.check()
            count += 1
    assert count > 2_000


@pytest.mark.parametrize("name", ["mine11", "heishan", "terminus"])
def test_what_layouts_have_in_common_serves_for_most_obligations(name: str) -> None:
    proof = local(name, Library.shipped())
    assert not proof.open and proof.solved <= 0.25 * len(proof.obligations), "python -m tests.campaigns.shape_library"


def test_a_layout_that_is_new_finds_shapes_of_others() -> None:
    alone, helped = local("../tests/layouts_for_tests/foul_joint", Library()), Library.shipped()
    proof = local("../tests/layouts_for_tests/foul_joint", helped)
    assert not proof.open and len(proof.obligations) == len(alone.obligations)
    assert proof.solved < alone.solved / 2


def test_what_is_too_deep_to_be_looked_for_is_proved_anew(monkeypatch: pytest.MonkeyPatch) -> None:
    """Where nothing tells how a shape was found: the tree of all shapes is gone through only so far."""
    monkeypatch.setattr(library, "DEEP", 3)
    proof = local("fig2_2", Library(replace(library._shipped(), near={})))
    assert not proof.open and proof.solved > 0
    assert all(len(o.facts) == len(o.shape.parts) for o in proof.obligations)


def spoiled(how: str) -> bytes:
    """A library that lies, or is none."""
    if how == "no shapes":
        return b"nothing"
    lines = TEXT.splitlines()
    out = []
    for line in lines:
        head, _, steps = line.rpartition("/")
        if line.startswith(("pattern", "interlock")) or not steps:
            out.append(line)
        elif how == "steps":  # the end of the refutation, as if it came by itself
            out.append(f"{head}/:0")
        else:  # every fact but the first is left out
            where, facts = head.split("/")
            out.append(f"{where.split()[0]} /{' '.join(facts.split()[:1])}/{steps}")
    return lzma.compress(("\n".join(out) + "\n").encode(), preset=0)


@pytest.mark.parametrize("how", ["no shapes", "steps", "facts"])
def test_a_spoiled_library_is_not_believed(how: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    file = tmp_path / "shapes.txt.xz"
    file.write_bytes(spoiled(how))
    monkeypatch.setattr(library, "SHIPPED", file)
    library._shipped.cache_clear()
    compile_file("layouts/fig2_2.yaml", tmp_path / "generated")
    try:
        found = certify_file("layouts/fig2_2.yaml", tmp_path / "generated", tmp_path / "proofs")
    finally:
        library._shipped.cache_clear()
    assert found.ok, found.notes
