"""Seen: whoever could write to the folder of `prove --cache` could have any layout PROVED."""

from __future__ import annotations

import hashlib
import json
from pathlib import Path

from click.testing import CliRunner

from interlock.app import kept
from interlock.app.check import derive_file
from interlock.app.prove import prove_file
from interlock.cli.prove import command
from interlock.proof.claims import CLAIMS
from interlock.proof.engines.cache import Cache
from interlock.proof.engines.limits import Limits

REFUTED = next(str(f) for f in sorted(Path("layouts/refuted").glob("*.yaml")))


def planted(folder: Path) -> str:
    """A proof of a layout that is refuted, made with what everybody can read: name, content, and a digest of both."""
    derived = derive_file(REFUTED)
    assert derived.layout is not None and derived.table is not None
    name = kept.name(Limits(cache=Cache(folder)), derived.layout, derived.table)
    told = {
        "claims": [[i, words, 1] for i, words in CLAIMS.items()],
        "invariants": 1,
        "obligations": 1,
        "witnesses": [[r.id, 1, "driven"] for r in derived.table.routes],
        "texts": ["st/iec/x.st"],
    }
    body = json.dumps(told)
    folder.mkdir(exist_ok=True)
    seal = hashlib.sha256(f"interlock {name} {body}".encode()).hexdigest()
    (folder / name).write_text(f"{body}\n{seal}", encoding="ascii")
    return name


def test_a_planted_cache_file_is_not_believed(tmp_path: Path) -> None:
    planted(tmp_path / "kept")
    result = prove_file(REFUTED, Limits(search_depth=12, cache=Cache(tmp_path / "kept")))
    assert not result.green, "a proof that nobody has made was believed"
    assert result.proof is not None and not result.proof.kept


def test_the_command_says_so_in_one_line(tmp_path: Path) -> None:
    planted(tmp_path / "kept")
    calls = ["--cache", str(tmp_path / "kept"), "--search-depth", "12", "--traces", str(tmp_path / "traces")]
    result = CliRunner().invoke(command, [REFUTED, *calls])
    assert result.exit_code == 1
    assert result.output.count("not sealed with your key, and not believed: asked again") == 1
