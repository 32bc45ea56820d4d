"""What is told of the controller for which a text is meant: limits, an estimate with its rule, and the page."""

from __future__ import annotations

from pathlib import Path

import pytest

from interlock.app.compile import compile_file
from interlock.app.target import estimated, target_notes, too_large
from interlock.diag import Diagnostic, Sink
from interlock.frontend import load_text
from interlock.model.layout import Layout
from interlock.model.target import CPUS, KB, Target
from interlock.st.parser import parse_unit
from interlock.st.shared import shared
from interlock.st.sizes import CALL, HEAD, JUMP, MEMBER, OPERAND, Size, size_of
from tests.campaigns.targets import PAGE, head, row
from tests.layouts import SHIPPED, built

TEXT = Path("layouts/fig2_2.yaml").read_text("utf-8")


def loaded(target: str) -> tuple[Layout | None, tuple[Diagnostic, ...]]:
    sink = Sink()
    layout, _ = load_text("fig2_2.yaml", f"{TEXT}\n{target}\n", sink)
    return layout, sink.diagnostics


def test_a_target_is_a_cpu_or_limits_of_ones_own() -> None:
    plain = loaded("")[0]
    assert plain is not None and plain.hardware.target is None
    for text, wanted in (
        ("target: {cpu: s7-313}", CPUS["s7-313"]),
        ("target: {blocks: 9, block_kb: 2, memory_kb: 3}", Target("the target", 9, 2 * KB, 3 * KB)),
        ("target: {memory_kb: 3}", Target("the target", memory_bytes=3 * KB)),
        ("target: {}", None),
    ):
        layout, _ = loaded(text)
        assert layout is not None and layout.hardware.target == wanted
        assert (layout.digest == plain.digest) is (wanted is None) and layout.bare.digest == plain.bare.digest
    over = loaded("target: {cpu: s7-313, memory_kb: 64}")[0]
    assert over is not None and over.hardware.target is not None
    assert (over.hardware.target.blocks, over.hardware.target.memory_bytes) == (128, 64 * KB)
    small = loaded("target: {cpu: s7-313, block_kb: 4}")[0]
    assert small is not None and small.hardware.target is not None and small.hardware.target.block_bytes == 4 * KB


@pytest.mark.parametrize("text", ["{cpu: s7-9}", "{blocks: 0}", "{blocks: many}", "{memory: 5}", "s7-313"])
def test_a_target_that_cannot_be_is_told(text: str) -> None:
    layout, told = loaded(f"target: {text}")
    assert layout is None and told and all(d.span is not None for d in told)


def test_the_rule_of_the_estimate() -> None:
    unit = parse_unit(
        "FUNCTION_BLOCK A VAR_INPUT X : BOOL; N : INT; END_VAR VAR_OUTPUT Y : BOOL; Z : BOOL; END_VAR\n"
        "VAR T_1 : BOOL; T : TON; END_VAR\n"
        "  T_1 := X AND NOT (X OR Y) AND (N = 1);\n  T(IN := T_1, PT := T#1s);\n  Y := T.Q;\n"
        "  IF X THEN Z := TRUE; ELSIF Y THEN Z := FALSE; ELSE Z := X; END_IF;\nEND_FUNCTION_BLOCK\n"
        "FUNCTION_BLOCK IL_B VAR_INPUT X : BOOL; N : INT; END_VAR VAR_OUTPUT Q : BOOL; END_VAR VAR I : A; END_VAR\n"
        "  I(X := X, N := N);\n  Q := I.Z;\nEND_FUNCTION_BLOCK\n"
        "PROGRAM IL_B_IO VAR P AT %QX0.0 : BOOL; R : BOOL; M : INT; RUN : IL_B; END_VAR\n"
        "  RUN(X := R, N := M);\n  P := RUN.Q;\n  R := FALSE;\nEND_PROGRAM\n"
    )
    size = size_of(shared(unit))
    first = (MEMBER + (2 * MEMBER + 4) + (MEMBER + 2 * OPERAND + 4) + OPERAND) + (CALL + 2 * OPERAND + 3 * OPERAND)
    second = (MEMBER + MEMBER) + 2 * (MEMBER + 2 * JUMP) + 2 * (OPERAND + MEMBER) + 2 * MEMBER
    assert size.code == {
        "A": HEAD + first + second,
        "IL_B_Y01": HEAD + 2 * MEMBER,
        "IL_B_G01": HEAD + 2 * CALL,
        "IL_B": HEAD + CALL,
        "IL_B_IN01": HEAD + 4 * MEMBER,
        "IL_B_OUT01": HEAD + MEMBER + OPERAND,
        "IL_B_IO": HEAD + 3 * CALL + OPERAND + MEMBER,
    }
    assert size.data == {
        "IL_B_I": HEAD + 4,
        "IL_B_Q": HEAD + 2,
        "IL_B_D": HEAD + 2,
        "DB_A": HEAD + 2 + 22,
        "IL_B_HMI": HEAD + 4,
    }
    assert size.largest == ("A", size.code["A"]) and size.memory == sum((*size.code.values(), *size.data.values()))


def test_what_does_not_suffice_is_told_limit_by_limit() -> None:
    size = Size({"A": 100, "B": 50}, {"I": 200})
    assert too_large(size, Target("t", 2, 200, 350)) == []
    assert too_large(size, Target("t")) == []
    assert too_large(size, Target("t", 1, 199, 349)) == [
        "2 blocks of 1",
        "data of I of 200 bytes, where 199 are allowed",
        "350 bytes of memory of 349",
    ]


def test_an_s7_1500_has_memory_for_data_apart() -> None:
    size = Size({"A": 100, "B": 50}, {"I": 200})
    assert too_large(size, Target("t", memory_bytes=150, data_bytes=200)) == []
    assert too_large(size, Target("t", memory_bytes=149, data_bytes=199)) == [
        "150 bytes of code of 149",
        "200 bytes of data of 199",
    ]
    layout, _, controller = built("fig2_2")
    own, other = estimated(layout, controller, True), estimated(layout, controller)
    assert sum(own.code.values()) > 3 * sum(other.code.values()) and own.largest[0] == "IL_fig2_2_B03"
    sink = Sink()
    made, source = load_text("fig2_2.yaml", f"{TEXT}\ntarget: {{cpu: s7-1510sp-1pn}}\n", sink)
    assert made is not None
    (told,) = target_notes(made, controller, source)
    assert told.code == "IL5010" and "scl1500: " in told.message and "four times the work memory" in told.fix


@pytest.mark.parametrize(("target", "code"), [("{cpu: s7-313}", "IL5010"), ("{memory_kb: 1}", "IL5009")])
def test_compile_tells_the_estimate_with_its_rule(target: str, code: str, tmp_path: Path) -> None:
    path = tmp_path / "fig2_2.yaml"
    path.write_text(f"{TEXT}\ntarget: {target}\n", "utf-8")
    done = compile_file(str(path), tmp_path / "out")
    (told,) = [d for d in done.notes if d.code in ("IL5009", "IL5010")]
    assert done.green and told.code == code
    assert "not measured on hardware" in told.message and "12054 bytes of memory" in told.message
    assert "4 bytes for each bit" in told.fix and told.span is not None
    assert (tmp_path / "out" / "fig2_2" / "st" / "iec" / "fig2_2.st").is_file()


def test_the_page_of_targets_is_current() -> None:
    """Head and some rows; `python -m tests.campaigns.targets --write` makes all of it."""
    lines = PAGE.read_text("utf-8").splitlines()
    assert lines[: len(head())] == head()
    assert [x.split(" | ")[0] for x in lines[len(head()) :]] == [f"| {n}" for n in (*SHIPPED, "yard37")]
    for name in ("fig2_2", "mine11"):
        assert row(name) in lines


def test_no_block_is_larger_than_the_smallest_target_allows() -> None:
    """In no shipped layout, and not in a yard of 304 routes: as the page has it, which is current."""
    rows = [x.split(" | ") for x in PAGE.read_text("utf-8").splitlines()[len(head()) :]]
    least = min(t.block_bytes for t in CPUS.values() if t.block_bytes is not None)
    assert least == 8 * KB and all(int(cells[4]) < least for cells in rows) and len(rows) == len(SHIPPED) + 1
