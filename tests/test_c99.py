"""The C runtime: read back and proved, refuted when it is changed, and compiled: equal to the Python runtime."""

from __future__ import annotations

import random
import re
import shlex
import sys
from collections.abc import Callable
from dataclasses import replace
from functools import cache

import pytest
from click.testing import CliRunner

from interlock.app.texts import writers
from interlock.cli.main import cli
from interlock.emit.c99.runtime import literal, runtime_c
from interlock.logic.controller import Controller, Equation, Input, Join, Output, StateVar, Term, Timer
from interlock.logic.expr import Expr, conj, eq, neg, var
from interlock.logic.names import spelled
from interlock.logic.words import Words
from interlock.proof.equivalence import c_text
from interlock.proof.equivalence.c_text import BadC, compare_c
from tests.c_driver import STRAY, Pair, answers, built_by_gcc, driven, edited
from tests.layouts import SHIPPED, built

SCANS = 600


@cache
def smallest() -> tuple[Controller, dict[str, str]]:
    """A controller of a few equations, with everything that a file can have, and its files."""
    _, _, whole = built("fig2_2")

    def equation(name: str, join: Join, *terms: Expr) -> Equation:
        return Equation(spelled(name), join, tuple(Term(x, "test") for x in terms), "place")

    bits = {n: var(spelled(n)) for n in ("VALID", "A", "K", "L", "GO", "ASK", "RT")}
    inputs = (Input(spelled("VALID"), "valid"), Input(spelled("A"), "", 0, 1), Input(spelled("REQ"), "asked", 4))
    steps = (
        equation("ASK", Join.ANY, eq(spelled("REQ"), 1), conj((bits["A"], bits["L"]))),
        equation("GO", Join.ALL, bits["VALID"], bits["ASK"], neg(bits["K"])),
        Timer(spelled("RT"), spelled("GO"), 2000, "delay"),
    )
    following = (
        equation("K", Join.ALL, bits["K"], neg(bits["RT"])),
        equation("L", Join.ANY, bits["RT"], conj((bits["L"], bits["A"]))),
    )
    state = (StateVar(spelled("K"), True, "locked"), StateVar(spelled("L"), False, "open"))
    outputs = (
        Output(spelled("YS"), bits["K"], True, "stop"),
        Output(spelled("YP"), conj((bits["L"], neg(bits["K"]))), False, "proceed"),
    )
    controller = replace(
        whole, name="small", inputs=inputs, state=state, steps=steps, next=following, outputs=outputs, words=Words()
    )
    return controller, runtime_c(controller, ["made for a test"])


@pytest.mark.parametrize("name", ["fig2_2", "passing_loop", "incline_hoist"])
def test_the_c_file_is_read_back_and_proved(name: str) -> None:
    _, _, controller = built(name)
    files = runtime_c(controller, ["made for a test"])
    assert all(t.endswith("\n") and t.isascii() and "made for a test" in t for t in files.values())
    found = compare_c(controller, files)
    assert found.proved and found.compared > 2 * len(controller.state)


def test_it_is_written_when_it_is_asked_for() -> None:
    layout, _, controller = built("fig2_2")
    for dialects, wanted in (((), False), (("c99",), True)):
        files: dict[str, bytes] = {}
        for task in writers(layout, controller, [], dialects):
            verdict, made = task()
            assert verdict.equal
            files |= made
        assert ("c99/fig2_2.c" in files and "c99/fig2_2.h" in files) is wanted


def test_without_its_parser_it_is_refused_with_advice(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("interlock.cli.compile.find_spec", lambda _: None)
    done = CliRunner().invoke(cli, ["compile", "layouts/fig2_2.yaml", "--dialect", "c99"])
    said = " ".join(done.output.split())
    assert done.exit_code == 2 and f"{shlex.quote(sys.executable)} -m pip install 'interlock[c99]'" in said


CHANGES: list[tuple[str, str | Callable[[re.Match[str]], str]]] = [
    (r"&& !", "&& "),
    (r"\n    && !now\.K\b[^\n;]*", ""),
    (r"(wire\.GO) =", r"\1 = true ||"),
    (r"now\.K = true;", "now.K = false;"),
    (r"  now\.K = true;\n", ""),
    (r"(IL_small_in\.A) = 1u;", r"\1 = 0u;"),
    (r"(on_delay\(&delay\.\w+, wire\.\w+, )(\d+)u", r"\g<1>1u"),
    (r"(on_delay\(&delay\.RT, wire\.)GO", r"\g<1>ASK"),
    (r"(on_delay\(&delay\.)RT", r"\g<1>GO"),
    (r"  delay\.RT\.runs = false;", "  delay.RT.runs = true;"),
    (r"== 1\)", "== 2)"),
    (r"== 1\)", "== 01)"),
    (r"== 1\)", "!= 1)"),
    (r"  now = next;\n", ""),
    (r"  part_001\(\);\n", ""),
    (r"(  part_001\(\);\n)", r"\1\1"),
    (r"  begun = true;\n", ""),
    (r"  report\(\);\n\}\n\nvoid IL_small_scan", "}\n\nvoid IL_small_scan"),
    (r"ms > 1000u", "ms > 9000u"),
    (r"in\.VALID = false;", "in.VALID = true;"),
    (r"timer->elapsed_ms = preset_ms", "timer->elapsed_ms += ms"),
    (r"else if \(!timer->runs\)\n  \{\n    timer->elapsed_ms = 0u;\n  \}\n  else", "else"),
    (r"bool runs;", "bool volatile runs;"),
    (r"static IL_small_state now;", "static IL_small_state now, other;"),
    (r"static bool begun = false;", "static bool begun = true;"),
    (r"\n  wire\.(\w+) = ([^;]*);", r"\n  if (true) { wire.\1 = \2; }"),
    (r"\n  wire\.(\w+) =", r"\n  now.K = false;\n  wire.\1 ="),
    (r"\n  wire\.(\w+) =", r"\n  in.VALID = true;\n  wire.\1 ="),
    (r"\n  wire\.(\w+) =", r"\n  IL_small_in.VALID = 1u;\n  wire.\1 ="),
    (r"\n  wire\.(\w+) =", r"\n  wire.nobody = true;\n  wire.\1 ="),
    (r"\n  wire\.(\w+) =", r"\n  bool in;\n  wire.\1 ="),
    (r"\n  wire\.(\w+) =", r"\n  return;\n  wire.\1 ="),
    (r"\n  wire\.(\w+) =", "\n#define in now\n  wire.\\1 ="),
    (r"\n  wire\.(\w+) =", "\n  /* \\\\\n */ wire.\\1 ="),
    (r"\n  wire\.(\w+) =", "\n  // in.VALID = true;\n  wire.\\1 ="),
    (r"\n  wire\.(\w+) =", "\n  ??/\n  wire.\\1 ="),
    (r"\n  wire\.(\w+) =", "\n  %:define in now\n  wire.\\1 ="),
    (r"\n  wire\.(\w+) =", "\n  wire.INT8_MAX = true; wire.\\1 ="),
    (r'\{ "VALID", &IL_small_in\.VALID \}', '{ "VALID", &IL_small_in.A }'),
    (r'\{ "[^"]*", 1 \}', '{ "X", 1 }'),
    (r"const bool \*bit", "bool *bit"),
    (r"#include <stdint.h>", "#include <stdint.h>\n#include <string.h>"),
    (r"(typedef struct \{\n  bool \w+;)", r"\1\n  bool other;"),
    (r"\Z", "static void unseen(void)\n{\n}\n"),
    (r"\Z", "int other;\n"),
    (r"  now = next;\n", "  now = next;\n  begun = false;\n"),
    (r"  begun = true;\n", "  begun = false;\n"),
    (r"  now = next;\n", "  next = now;\n"),
    (r"  now = next;\n", "  now = next;\n  IL_small_init();\n"),
    (r"  now = next;\n", "  now = next;\n  delay.RT.runs = false;\n"),
]


SAID: list[tuple[str, str]] = [
    (r"IL_fig2_2_said\.YX_R1 = 10001;", "IL_fig2_2_said.YX_R1 = 10002;"),
    (r"IL_fig2_2_said\.YX_R1 = 10001;", "IL_fig2_2_said.YX_R1 = 40001;"),
    (r"IL_fig2_2_said\.YX_R1 = 10001;", "IL_fig2_2_said.YX_R1 = 010001;"),
    (r"IL_fig2_2_said\.YX_R1 = 10001;", "IL_fig2_2_said.YX_R2 = 10001;"),
    (r"IL_fig2_2_said\.YX_R1 = 10001;", "now.K_DP = true;"),
    (r"IL_fig2_2_said\.YX_R1 = 10001;", "IL_fig2_2_said.YX_R1 = 10001;\n    now.K_DP = true;"),
    (r"  else if \(.*\)\n  \{\n    IL_fig2_2_said\.YX_R1 = 10001;.*\n  \}\n", ""),
    (r"  else\n  \{\n    IL_fig2_2_said\.YX_R1 = \S+;.*\n  \}\n", ""),
    (r"= reason\.(\w+);", "= reason.XW_R2;"),
    (r"  IL_fig2_2_said\.YX_R1 = 0;\n", ""),
    (r"  IL_fig2_2_said\.YX_R1 = 0;\n", "  IL_fig2_2_said.YX_R1 = 1;\n"),
    (r"  words_001\(\);\n", ""),
    (r"(  words_001\(\);\n)(.*)(  now = next;\n)", r"\2\3\1"),
    (r"&IL_fig2_2_said\.YX_R1", "&IL_fig2_2_said.YX_R2"),
    (r"(  int16_t) YX_R1;", r"\1 YX_R9;"),
    (r"static IL_fig2_2_reasons reason;", "static IL_fig2_2_words reason;"),
    (r"= now\.", "= reason."),
]


@pytest.mark.parametrize(("old", "new"), SAID)
def test_a_c_file_that_says_something_else_of_a_route_is_refuted(old: str, new: str) -> None:
    _, _, controller = built("fig2_2")
    files = runtime_c(controller, [])
    (name,) = [n for n, text in files.items() if re.search(old, text)]
    changed = re.sub(old, new, files[name], count=1)
    assert changed != files[name] and not compare_c(controller, {**files, name: changed}).proved


@pytest.mark.parametrize(("old", "new"), CHANGES)
def test_a_changed_c_file_is_refuted(old: str, new: str | Callable[[re.Match[str]], str]) -> None:
    controller, files = smallest()
    assert not any(compare_c(controller, x).proved for x in edited(files, old, new))


def test_a_byte_of_a_c_file_changed_is_refused_or_c_reads_the_same() -> None:
    controller, files = smallest()
    rng, same = random.Random(5), 0

    def words(text: str) -> list[str]:
        return re.findall(r"\w+|[^\w\s]", re.sub(r"(\d)u\b", r"\1", c_text._uncommented(text)))

    for _ in range(120):
        name = rng.choice(sorted(files))
        text = files[name]
        at, new = rng.randrange(len(text)), chr(rng.choice((9, 10, *range(32, 127), 0xA0)))
        changed = text[:at] + new + text[at + rng.randrange(2) :]
        if changed != text and compare_c(controller, {**files, name: changed}).proved:
            same += 1
            assert words(changed) == words(text), changed[at - 20 :][:60]
    assert same > 10  # notes


def test_names_of_any_script_are_literals_that_c_reads_as_their_bytes() -> None:
    assert literal("X1-X3") == '"X1-X3"'
    told = literal('东"\\?7')
    assert told.isascii() and "?" not in told
    octal = re.sub(r"\\(\d{3})", lambda m: chr(int(m[1], 8)), told[1:-1])
    assert octal.encode("latin-1").decode() == '东"\\?7'


def test_what_the_preprocessor_might_take_otherwise_is_refused() -> None:
    assert c_text._uncommented('a /* x\ny */ "b/*" c').split() == ["a", '"b/*"', "c"]
    for text in (
        "a ' b",
        'a "b',
        "a \\ b",
        "a // b",
        "a /* b",
        "a\\\nb",
        "a %: b",
        "a <: b",
        "a\tb",
        "\u00e4",
        "a??)b",
    ):
        with pytest.raises(BadC):
            c_text._uncommented(text)


@pytest.mark.external
@pytest.mark.parametrize("name", SHIPPED)
def test_compiled_by_gcc_it_answers_as_the_python_runtime_in_every_scan(
    name: str, tmp_path_factory: pytest.TempPathFactory
) -> None:
    """Trains, stalled cycles, lost inputs, power cuts; outputs, state and words of routes; without a warning."""
    layout, table, controller = built(name)
    files = runtime_c(controller, ["made for a test"])
    assert compare_c(controller, files).proved
    program = built_by_gcc(controller, files, tmp_path_factory.mktemp(name))
    pair, _ = driven(layout, table, controller, SCANS, 7)
    assert pair.scans == 2 * SCANS and pair.stalls > 10
    same = answers(program, bytes(pair.given)) == bytes(pair.told)
    assert same


@pytest.mark.external
def test_gcc_and_the_comparison_notice_a_wrong_c_file(tmp_path_factory: pytest.TempPathFactory) -> None:
    """A timer that counts too early or never ends, a cycle that may be longer: some scan answers otherwise."""
    layout, table, controller = built("mine11")
    files = runtime_c(controller, [])
    pair, movements = driven(layout, table, controller, 3000, 7)
    assert movements > 0 and pair.restarts > 1
    edits = (
        (r"else if \(!timer->runs\)\n  \{\n    timer->elapsed_ms = 0u;\n  \}\n  else", "else"),
        (r"ms > 1000u", "ms > 1001u"),
        (r"timer->elapsed_ms >= preset_ms", "timer->elapsed_ms > preset_ms"),
    )
    for n, (old, new) in enumerate(edits):
        wrong = {f: re.sub(old, new, t, count=1) for f, t in files.items()}
        assert wrong != files
        program = built_by_gcc(controller, wrong, tmp_path_factory.mktemp(f"wrong{n}"))
        same = answers(program, bytes(pair.given)) == bytes(pair.told)
        assert not same, old


@pytest.mark.external
@pytest.mark.parametrize("optimised", ["-O0", "-O1", "-O2"])
def test_whatever_byte_stands_at_an_input_gcc_reads_it_as_the_python_runtime_does(
    optimised: str, tmp_path_factory: pytest.TempPathFactory
) -> None:
    """A process image may have other bytes for true than 1: with such a byte all inputs are lost."""
    layout, table, controller = built("fig2_2")
    files = runtime_c(controller, [])
    pair, movements = driven(layout, table, controller, 3000, 7, stray=0.001)
    assert movements > 0
    folder = tmp_path_factory.mktemp("bytes")
    same = answers(built_by_gcc(controller, files, folder, optimised=optimised), bytes(pair.given)) == bytes(pair.told)
    assert same
    edits = (
        (r"\(IL_fig2_2_in\.(\w+) == 1u\)", r"(IL_fig2_2_in.\1 != 0u)"),
        (r"\(IL_fig2_2_in\.(\w+) != 0u\)", r"(IL_fig2_2_in.\1 == 1u)"),
        (r"implausible \|\| \(ms", "(ms"),
        (r" > 1u\)", " > 2u)"),
    )
    for old, new in edits:
        wrong = {f: re.sub(old, new, t) for f, t in files.items()}
        assert wrong != files
        program = built_by_gcc(controller, wrong, folder, optimised=optimised)
        same = answers(program, bytes(pair.given)) == bytes(pair.told)
        assert not same, old


@pytest.mark.external
@pytest.mark.parametrize("optimised", ["-O0", "-O1", "-O2"])
def test_points_detected_both_ways_and_a_block_close_a_signal_whatever_byte_says_so(
    optimised: str, tmp_path_factory: pytest.TempPathFactory
) -> None:
    """As a programmer writes it who copies a process image in which true is another byte than 1."""
    _, table, controller = built("fig2_2")
    pair = Pair(controller)
    folder = tmp_path_factory.mktemp("image")
    program = built_by_gcc(controller, runtime_c(controller, []), folder, optimised=optimised)
    good = {i.name: int(i.name.startswith("CLR_") or i.name in ("VALID", "DN_P1")) for i in controller.inputs}
    route = next(r.number for r in table.routes if r.entry == "X1")
    proceeds = []
    for byte in (1, *STRAY):
        for name in ("DR_P1", "BLK_DP"):
            pair()
            for _ in range(700):
                pair.scan(good, 1000)
            for _ in range(20):
                pair.scan({**good, "RELALL": 1}, 1000)
            pair.scan(good, 100)
            pair.scan({**good, "REQ": route}, 100)
            before = [pair.scan(good, 100) for _ in range(5)][-1]
            after = pair.scan({**good, name: byte}, 100)
            proceeds.append([n for n in before if n.startswith("YP_") and (before[n], after[n]) == (True, False)])
    same = answers(program, bytes(pair.given)) == bytes(pair.told)
    assert same and all(proceeds)
