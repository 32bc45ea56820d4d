"""What is computed and kept lies in several structures: no block gets one that it does not use, and neither reader
takes a text in which a value lies in two of them, or a block gets another one."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from interlock.checker import specification
from interlock.checker.check import agree
from interlock.checker.reading import loaded
from interlock.proof.equivalence.structured_text import compare_dialect, compare_st
from interlock.st import shared, structures
from interlock.st.delivery import write_st
from interlock.st.dialects import BY_NAME
from interlock.st.lower import lower_st
from interlock.st.printer import print_unit
from interlock.st.shared import names_in
from interlock.verify import Rejected
from tests.layouts import built

LAYOUT, _, CONTROLLER = built("fig2_2")
SYSTEM = Path("proofs/fig2_2/system.txt").read_text("utf-8")


@pytest.fixture
def small(monkeypatch: pytest.MonkeyPatch) -> None:
    """As in a large station: more than nine structures, and several groups."""
    monkeypatch.setattr(structures, "MEMBERS", 16)
    monkeypatch.setattr(shared, "GROUP", 3)


def why(text: str) -> tuple[str, str]:
    """Why the proof and the second checker refuse a text; nothing where they take it."""
    told = "; ".join(d.text or d.name for d in compare_st(CONTROLLER, text).differences)
    try:
        agree(loaded(Path("layouts/fig2_2.yaml").read_text("utf-8")), SYSTEM, text, specification.shipped())
    except Rejected as error:
        return told, str(error)
    return told, ""


def test_a_block_gets_the_structures_that_it_uses_and_no_other(small: None) -> None:
    unit = structures.structured(lower_st(CONTROLLER, []))
    held = [b for b in unit.blocks if b.kind == "STRUCT" and b.name.startswith("IL_fig2_2_D")]
    assert [b.name for b in held] == [f"IL_fig2_2_D{k}" for k in range(1, 14)]
    assert all(12 <= len(b.locals) <= 16 for b in held)
    handed = {b.name: {d.name for d in b.handed} for b in unit.blocks}
    for b in unit.blocks:
        used = {n.parts[0] for s in b.body for n in names_in(s)}
        assert b.name == "IL_fig2_2" or handed[b.name] == used & {*structures.named(13)}
        assert [d.name for d in b.handed] == [n for n in structures.named(13) if n in handed[b.name]], "in one order"
    assert why(print_unit(unit)) == ("", "")
    assert sum(map(len, handed.values())) == 95, "blocks get more structures, or fewer, than they did"


def test_few_values_lie_in_one_structure() -> None:
    names = [b.name for b in structures.structured(lower_st(CONTROLLER, [])).blocks if b.kind == "STRUCT"]
    assert names == ["IL_fig2_2_I", "IL_fig2_2_Q", "IL_fig2_2_D"]


@pytest.mark.parametrize("dialect", ["iec", "codesys", "twincat", "plcopen", "ladder"])
def test_every_dialect_reads_them_back(small: None, dialect: str) -> None:
    written = write_st(CONTROLLER, BY_NAME[dialect], [])
    assert any("IL_fig2_2_D13" in text for text in written.values())
    assert not compare_dialect(CONTROLLER, BY_NAME[dialect], written).differences


RSTI = r"  RSTI : BOOL;.*\n"
LAST = r"(TYPE IL_fig2_2_D13 :\n.*\nSTRUCT\n)"

EDITS: dict[str, tuple[str, str]] = {
    "a member of another structure": (r"\bD1\.RSTI :=", "D2.RSTI :="),
    "a member in another structure": (rf"(?s){RSTI}(.*?TYPE IL_fig2_2_D2 :.*?STRUCT\n)", r"\1  RSTI : BOOL;\n"),
    "a member in two": (LAST, r"\1  RSTI : BOOL;\n"),
    "a member in two, in small letters in one": (LAST, r"\1  rsti : BOOL;\n"),
    "a member in two, written in both": (
        r"(?s)(TYPE IL_fig2_2_D2 :.*?STRUCT\n)(.*?  D1\.RSTI := [^;]*;)",
        r"\1  RSTI : BOOL;\n\2\n  D2.RSTI := FALSE;",
    ),
    "another one": (r"B01\(INP := INP, D1 := D1", "B01(INP := INP, D1 := D2"),
    "exchanged at a call": (r"B01\(INP := INP, D1 := D1, D2 := D2", "B01(INP := INP, D1 := D2, D2 := D1"),
    "exchanged in a block": (
        r"  D1 : IL_fig2_2_D1;\n  D2 : IL_fig2_2_D2;\n",
        "  D1 : IL_fig2_2_D2;\n  D2 : IL_fig2_2_D1;\n",
    ),
    "exchanged in the main block": (
        r"VAR\n  D1 : IL_fig2_2_D1;\n  D2 : IL_fig2_2_D2;\n",
        "VAR\n  D1 : IL_fig2_2_D2;\n  D2 : IL_fig2_2_D1;\n",
    ),
    "two of one type": (
        r"VAR\n  D1 : IL_fig2_2_D1;\n  D2 : IL_fig2_2_D2;\n",
        "VAR\n  D1 : IL_fig2_2_D1;\n  D2 : IL_fig2_2_D1;\n",
    ),
    "a second one of a type": (r"(  D13 : IL_fig2_2_D13;\n)(  G01)", r"\1  D14 : IL_fig2_2_D13;\n\2"),
    "one that nobody holds": (r"  D13 : IL_fig2_2_D13;\n(  G01)", r"\1"),
    "one that is not declared": (r"(?s)(IL_fig2_2_G01\n.*?)  D8 : IL_fig2_2_D8;\n", r"\1"),
    "one with values of its own": (r"(  D13 : IL_fig2_2_D13);\n(  G01)", r"\1 := 1;\n\2"),
    "one more type": (
        r"TYPE IL_fig2_2_D13 :",
        "TYPE IL_fig2_2_D14 :\nSTRUCT\n  ZZ : BOOL;\nEND_STRUCT;\nEND_TYPE\n\nTYPE IL_fig2_2_D13 :",
    ),
    "a group holds one of its own": (
        r"(?s)(IL_fig2_2_G02\n.*?)  D13 : IL_fig2_2_D13;\nEND_VAR\nVAR\n(.*?G02\([^)]*), D13 := D13",
        r"\1END_VAR\nVAR\n  D13 : IL_fig2_2_D13;\n\2",
    ),
    "a block holds one of its own": (
        r"(?s)(IL_fig2_2_B03\n.*?)  D12 : IL_fig2_2_D12;\nEND_VAR\nVAR\n(.*? B03\([^)]*), D11 := D11",
        r"\1END_VAR\nVAR\n  D11 : IL_fig2_2_D11;\n\2",
    ),
    "called by its type, without an instance": (
        r"(?s)  B01 : IL_fig2_2_B01;[^\n]*\n(.*?)  B01\([^)]*\);",
        r"\1  IL_fig2_2_B01();",
    ),
    "called a second time by a type in small letters": (
        r"(  B01 : IL_fig2_2_B01;)((?s:.*?)  B01\([^)]*\);)",
        r"\1\n  X : il_fig2_2_b01;\2\n  X();",
    ),
    "a member without its structure": (r"(  G01\(INP := INP)", r"  RSTI := FALSE;\n\1"),
    "an input is written": (r"  (D1\.RSTI := )", r"  INP.VALID := TRUE;\n  \1"),
    "a structure under another name": (
        r"(?s)(IL_fig2_2_T01\n.*?\nVAR\n)(.*?IN := )D1\.",
        r"\1  X : IL_fig2_2_D1;\n\2X.",
    ),
    "a member of a structure that the block does not get": (r"(?s)(IL_fig2_2_T01\n.*?)IN := D1\.", r"\1IN := D2."),
}


@pytest.mark.parametrize("which", EDITS)
def test_neither_reader_takes_another_structure(small: None, which: str) -> None:
    text = print_unit(structures.structured(lower_st(CONTROLLER, [])))
    changed, times = re.subn(*EDITS[which], text, count=1)
    assert times == 1
    told = why(changed)
    assert all(told), told


def test_in_which_order_the_main_block_holds_them_says_nothing(small: None) -> None:
    text = print_unit(structures.structured(lower_st(CONTROLLER, [])))
    changed, times = re.subn(r"(VAR\n)(  D1 : IL_fig2_2_D1;\n)(  D2 : IL_fig2_2_D2;\n)", r"\1\3\2", text)
    assert times == 1 and why(changed) == ("", "")
