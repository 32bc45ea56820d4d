"""Certificates made for a test, with everything that they name, in a folder of its own."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any, cast

from interlock.app.certify import certify_file
from interlock.app.compile import compile_file
from interlock.logic.expr import FALSE, TRUE, Expr, Op, var
from interlock.proof.certificate.bundle import proof_bytes
from interlock.proof.certificate.engine import prove_locally
from interlock.proof.certificate.facts import Fact, FactBase, Goal, GoalKind, Kind
from interlock.verify import System, main, read


def certified(layout: Path, top: Path) -> Path:
    """Compile and certify a layout below a folder; the certificate's folder."""
    compile_file(str(layout), top / "generated")
    done = certify_file(str(layout), top / "generated", top / "proofs")
    assert done.ok, done.notes
    return top / "proofs" / layout.stem


def signed(folder: Path) -> None:
    """Make the digests of a certificate agree again: what is left must be found by reasoning."""
    manifest = json.loads((folder / "manifest.json").read_text("utf-8"))
    manifest.pop("own")
    for name in manifest["files"]:
        manifest["files"][name] = hashlib.sha256((folder / name).read_bytes()).hexdigest()
    own = hashlib.sha256(json.dumps(manifest, sort_keys=True).encode()).hexdigest()
    text = json.dumps({**manifest, "own": own}, indent=1, ensure_ascii=False) + "\n"
    (folder / "manifest.json").write_text(text, encoding="utf-8")


def accepted(folder: Path) -> bool:
    """The certificate proves its written system, whatever that says."""
    return main([str(folder)]) == 0


def forge_proof(folder: Path) -> None:
    """A proof of what a written system says, whatever it says: what an able forger would add to it."""
    system = System((folder / "system.txt").read_text("utf-8"))
    local = prove_locally(cast(FactBase, _Told(system)))
    (folder / "proof.txt.xz").write_bytes(proof_bytes(local))


class _Told:
    """Facts and goals of a system as the certificate's checker reads them, for the prover."""

    def __init__(self, system: System) -> None:
        self.steps = [Fact(Kind.INVARIANT, "told", _clause(c)) for c in system.steps]
        self.initial = [Fact(Kind.INITIAL, "told", _clause(c)) for c in system.initial]
        self.owed = system.goals

    def goals(self) -> Iterator[Goal]:
        for n, (c, step) in enumerate(self.owed):
            yield Goal(GoalKind.CLAIM if step else GoalKind.BASE, n, _clause(c), "told")

    def facts(self, kind: GoalKind) -> list[Fact]:
        return self.initial if kind is GoalKind.BASE else self.steps


def _clause(c: tuple[str, tuple[str, ...]]) -> Expr:
    text, leaves = c

    def made(x: tuple[Any, ...]) -> Expr:
        """As written: nothing is left out, not even a constant."""
        if x[0] == "v":
            return var(leaves[int(x[1]) - 1])
        if x[0] == "!":
            return Expr(Op.NOT, (made(x[1]),))
        if x[0] in "&|":
            return Expr(Op.AND if x[0] == "&" else Op.OR, tuple(made(y) for y in x[1]))
        return TRUE if x[0] == "T" else FALSE

    return made(read(text))
