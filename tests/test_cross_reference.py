"""Where a variable is written and read, as the cross-reference has it, is where it stands in the emitted text."""

from __future__ import annotations

import csv
import io
import re
from pathlib import Path

import pytest

from interlock.app.certify import certify_file
from interlock.app.compile import compile_file
from interlock.app.texts import writers
from interlock.app.writing import written_for
from interlock.emit.io import CROSS_REFERENCE
from tests.layouts import built


def sheets(name: str, *dialects: str) -> dict[str, bytes]:
    """What is written for a layout in dialects."""
    layout, _, controller = built(name)
    files: dict[str, bytes] = {}
    for task in writers(layout, controller, [], dialects):
        verdict, made = task()
        assert verdict.equal
        files |= made
    return files


def rows(files: dict[str, bytes], dialect: str) -> dict[str, dict[str, str]]:
    text = files[f"{CROSS_REFERENCE}{dialect}.csv"].decode()
    return {row["Variable"]: row for row in csv.DictReader(io.StringIO(text))}


def test_a_row_tells_place_meaning_terminal_and_blocks() -> None:
    files = sheets("fig2_2", "iec", "scl300")
    row = rows(files, "scl300")["DN_P1"]
    assert list(row.values())[2:] == ["machine P1 detected normal", "I0.5", "IN01", "B01 IN01"]
    assert rows(files, "iec")["DN_P1"] == {**row, "Written in": "IO", "Read in": "B01 IO"}
    lock = rows(files, "iec")["L_DP_1"]
    assert lock["Place"] == "section DP" and lock["Written in"] == "S01" and "B01" in lock["Read in"]
    assert rows(files, "scl300")["REQ"]["Terminal"] == "operator"
    assert not [n for n in sheets("fig2_2") if n.startswith(CROSS_REFERENCE)]


@pytest.mark.parametrize("dialects", [(), ("iec",), ("iec", "twincat", "c99")])
def test_what_was_compiled_for_some_dialects_is_certified_as_it_is(tmp_path: Path, dialects: tuple[str, ...]) -> None:
    """With the portable text asked for by name, too, the report page shows its cross-reference."""
    compile_file("layouts/fig2_2.yaml", tmp_path, dialects=dialects)
    assert written_for(tmp_path / "fig2_2") == dialects
    assert "iec" not in dialects or certify_file("layouts/fig2_2.yaml", tmp_path, tmp_path / "proofs").ok


@pytest.mark.parametrize("name", ["mine11", "incline_hoist"])
def test_it_says_what_the_text_says(name: str) -> None:
    """Found again by looking for words in the blocks of the text of an S7-300, where a variable has one name."""
    files = sheets(name, "scl300")
    found = rows(files, "scl300")
    text = "".join(files[f"st/scl300/{name}{x}.scl"].decode() for x in ("", "_io"))
    written: dict[str, set[str]] = {n: set() for n in found}
    read: dict[str, set[str]] = {n: set() for n in found}
    for block, body in re.findall(r'FUNCTION(?:_BLOCK)? "(\w+)".*?\nBEGIN\n(.*?)\nEND_FUNCTION', text, re.DOTALL):
        short = block.removeprefix(f"IL_{name}_")
        body = re.sub(r"\(\*.*?\*\)", "", body, flags=re.DOTALL)
        body = re.sub(r'RESTART := "\w+"\.RESTART(ING)?(?=[,)])', "", body)  # handed on
        for n in re.findall(r'(?:^ *|THEN |ELSE )(?:"\w+"\.)?"?(\w+)"? :=', body, re.MULTILINE):
            written[n].add(short) if n in found else None
        for n in re.findall(r"\w+", re.sub(r'[\w."]+ :=', "", body)):
            read[n].add(short) if n in found else None
    for n, row in found.items():
        assert (set(row["Written in"].split()), set(row["Read in"].split())) == (written[n], read[n]), n
    assert len(found) > 300 and all(r["Written in"] for r in found.values())
