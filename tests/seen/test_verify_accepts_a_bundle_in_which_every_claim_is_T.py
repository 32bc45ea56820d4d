"""Seen: a certificate in which every claim says nothing was VERIFIED like any other."""

from __future__ import annotations

import hashlib
import json
import lzma
from pathlib import Path

from click.testing import CliRunner

from interlock.app.certify import certify_file
from interlock.app.compile import compile_file
from interlock.cli.verify import command
from interlock.verify import System

LAYOUT = Path("layouts/fig2_2.yaml")


def emptied(top: Path) -> Path:
    """The certificate of a layout with T for every claim: the goals that are owed no more are left out of its proof."""
    compile_file(str(LAYOUT), top / "generated")
    certify_file(str(LAYOUT), top / "generated", top / "proofs")
    folder = top / "proofs" / LAYOUT.stem
    before = (folder / "system.txt").read_text("utf-8")
    told = [" ".join([*x.split(" ")[:3], "T"]) if x.startswith("claim ") else x for x in before.splitlines()]
    after = "\n".join(told) + "\n"
    gone = len(System(before).goals) - len(System(after).goals)
    start = len(System("\n".join(x for x in told if not x.startswith("start ")) + "\n").goals)
    last = len(System(after).goals) - start
    proof = lzma.decompress((folder / "proof.txt.xz").read_bytes()).decode().splitlines()
    ends = [0, *(n for n, x in enumerate(proof) if n and ":" not in x)]  # a goal, with its lemmas before it
    proof = [*proof[: ends[-1 - last - gone] + 1], *proof[ends[-1 - last] + 1 :]]
    (folder / "system.txt").write_text(after, encoding="utf-8")
    (folder / "proof.txt.xz").write_bytes(lzma.compress(("\n".join(proof) + "\n").encode()))
    manifest = json.loads((folder / "manifest.json").read_text("utf-8"))
    manifest.pop("own")
    for name in manifest["files"]:
        manifest["files"][name] = hashlib.sha256((folder / name).read_bytes()).hexdigest()
    own = hashlib.sha256(json.dumps(manifest, sort_keys=True).encode()).hexdigest()
    text = json.dumps({**manifest, "own": own}, indent=1, ensure_ascii=False) + "\n"
    (folder / "manifest.json").write_text(text, encoding="utf-8")
    return folder


def test_a_bundle_in_which_every_claim_is_T_is_not_verified(tmp_path: Path) -> None:
    folder = emptied(tmp_path)
    alone = CliRunner().invoke(command, [str(folder)])
    assert "VERIFIED" not in alone.output, "a certificate that claims nothing was verified"
    with_layout = CliRunner().invoke(command, [str(LAYOUT), str(folder)])
    assert with_layout.exit_code == 1 and "REJECTED" in with_layout.output
    assert "lacks what the specification asks" in with_layout.output
