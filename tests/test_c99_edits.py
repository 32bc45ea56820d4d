"""Edits of the emitted C that change its meaning for a compiler, not only for who reads it: none is accepted."""

from __future__ import annotations

import re
from dataclasses import replace

import pytest

from interlock.emit.c99.runtime import runtime_c
from interlock.logic.controller import Timer
from interlock.proof.equivalence.c_text import compare_c
from tests.c_driver import answers, built_by_gcc, driven, edited
from tests.layouts import built
from tests.test_c99 import smallest

GO = r"\n  wire\.GO =\n    in\.VALID"
"""Where an equation begins."""

PREPROCESSED = [
    (GO, "\n#define wire next\n  wire.GO =\n    in.VALID"),
    (GO, "\n#define VALID A\n  wire.GO =\n    in.VALID"),
    (GO, "\n  # define VALID A\n  wire.GO =\n    in.VALID"),
    (r"\A", "#define on_delay(a, b, c, d) (b)\n"),
    (r"\A", "#define true false\n"),
    (r"(#include \"small\.h\"\n)", r"\1#undef bool\n#define bool char\n"),
    (r"(#include \"small\.h\"\n)", r"\1#include <string.h>\n"),
    (r"(#include \"small\.h\")\n", r'\1 /*\n*/ #include "other.h"\n'),
    (r"\"small\.h\"", "<small.h>"),
    (r"(#define IL_SMALL_H)\n", r"\1 int16_t\n"),
    (r"(#define) IL_SMALL_H\n", r"\1 IL_small_in\n"),
    (r"(    && !now\.K; /\* test \*/)", r"#if 0\n\1\n#endif\n;"),
    (r"(\n  part_003\(\);)", r"\n#ifdef NEVER\1\n#endif"),
    (r"\A", "#pragma pack(1)\n"),
    (r"(typedef struct \{\n  (bool|uint8_t) VALID)", r'_Pragma("pack(1)")\1'),
    (r"\A", "#line 7\n"),
    (r"    && wire\.ASK /\* test \*/\n", "    // note \\\\\n    && wire.ASK\n"),
    (r"    && wire\.ASK /\* test \*/\n", "    // && wire.ASK\n"),
    (r"    && wire\.ASK /\* test \*/\n", "    // note ??/\n    && wire.ASK\n"),
    (r"    && wire\.ASK /\* test \*/\n", "    /* && wire.ASK */\n"),
    (r"    && wire\.ASK /\* test \*/\n", "    /* note *\\\\\n/ || true /* test */ && wire.ASK\n"),
    (r"    && wire\.ASK /\* test \*/\n", "    && wire.ASK /* note *\\\\ \n/ || now.L /* test */\n"),
    (r"    && wire\.ASK /\* test \*/\n", "    && wire.ASK /* note *??/\n/ || now.L /* test */\n"),
    (r"\"VALID\", (&IL_small_in\.VALID \},\n  \{) \"A\"", r'"VALID/*", \1 "*/A"'),
    (r"\{ \"VALID\"", '{ "VAL" "IE"'),
    (r"\{ \"VALID\"", '{ L"VALID"'),
    (r"\{ \"VALID\"", r'{ "\\126ALIE"'),
    (r"in\.REQ == 1", "in.REQ == '1'"),
    (r"wire\.ASK =", "wire.\u0410SK ="),
    (r"wire\.ASK =", r"wire.\\u0041SK ="),
    (r"(    && !now\.K; )", r"    <:0:>\1"),
]

DECLARED = [
    (r"uint32_t elapsed_ms;", "uint16_t elapsed_ms;"),
    (r"uint32_t elapsed_ms;", "uint8_t elapsed_ms;"),
    (r"uint32_t elapsed_ms;", "int16_t elapsed_ms;"),
    (r"uint32_t elapsed_ms;", "uint32_t elapsed_ms : 10;"),
    (r"uint32_t elapsed_ms;", "float elapsed_ms;"),
    (r"bool runs;", "char runs;"),
    (r"bool GO;", "volatile bool GO;"),
    (r"bool GO;", "unsigned char GO;"),
    (r"bool GO;", "bool GO : 1;"),
    (r"bool GO;", "union { bool GO; bool OTHER; };"),
    (r"int16_t REQ;", "int8_t REQ;"),
    (r"typedef struct (\{\n  (bool|uint8_t) VALID)", r"typedef union \1"),
    (r"typedef struct (\{\n  bool K)", r"typedef const struct \1"),
    (r"typedef struct (\{\n  bool ASK)", r"typedef struct __attribute__((packed)) \1"),
    (r"(typedef struct \{\n  bool ASK)", r"typedef char bool;\n\1"),
    (r"static bool begun", "static char begun"),
    (r"static bool begun", "static volatile bool begun"),
    (r"static bool begun = false", "bool begun = false"),
    (r"static bool begun = false", "static bool begun"),
    (r"static IL_small_wires wire;", "IL_small_wires wire;"),
    (r"static IL_small_state now;", "static IL_small_state now = { true, true };"),
    (r"static IL_small_state next;", "extern IL_small_state next;"),
    (r"static IL_small_delays delay;", "static IL_small_delays delay;\nstatic int count = 7;"),
    (r"\{ \"K\", &now\.K \}", '{ "K", &next.K }'),
    (r"\{ \"K\", &now\.K \}", '[0] = { "K", &now.K }'),
    (r"\{ \"K\", &now\.K \}", "{ .bit = &now.K }"),
    (r"const IL_small_bit IL_small_state_bits", "static const IL_small_bit IL_small_state_bits"),
    (r"&IL_small_in\.REQ, 4", "&IL_small_in.REQ, 04"),
    (r"\{ \"X1-B\", 2 \}", '{ "X1-B", 0x1 }'),
    (r"static void part_001\(void\)", "static inline void part_001(void)"),
    (r"static void part_001\(void\)", "static void part_001()"),
    (r"static void part_001\(void\)", "static void part_001(void);\nstatic void part_001(void)"),
    (r"static void part_001\(void\)", "static void part_001(void)\n{\n}\nstatic void part_001(void)"),
    (r"static void part_001\(void\)", "static int part_001(void)"),
    (r"static void (timers_002\()uint32_t ms", r"static void \1uint16_t ms"),
    (r"(?s)part_001\b(.*)part_001\b", r"abort\1abort"),
    (r"uint32_t preset_ms, uint32_t ms", "uint16_t preset_ms, uint32_t ms"),
    (r"void IL_small_scan\(uint32_t ms\)\n", "void IL_small_scan(uint16_t ms)\n"),
]

COMPUTED = [
    (r"in\.VALID /\* test", "IL_small_in.VALID /* test"),
    (r"now\.L && in\.A", "now.L && IL_small_in.A"),
    (r"in\.REQ == 1", "IL_small_in.REQ == 1"),
    (r"in\.REQ == 1", "in.REQ = 1"),
    (r"in\.REQ == 1", "in.REQ == 65537"),
    (r"in\.REQ == 1", "in.REQ == 0x2"),
    (r"in\.REQ == 1", "in.REQ == 1.5"),
    (r"in\.REQ == 1", "in.REQ & 1"),
    (r"in\.REQ == 1", "1 == in.VALID"),
    (r"in\.REQ == 1", "!in.REQ == 1"),
    (r"in\.REQ == 1", "(int8_t)in.REQ == 1"),
    (r"in\.A && now\.L\)", "in.A & now.L)"),
    (r"in\.A && now\.L\)", "in.A, now.L)"),
    (r"in\.A && now\.L\)", "in.A ? now.L : true)"),
    (r"in\.A && now\.L\)", "in.A && (now.L = true))"),
    (r"in\.A && now\.L\)", "in.A && on_delay(&delay.RT, true, 1u, 1u))"),
    (r"in\.VALID( /\* test \*/\n    && wire)", r"in.VALID || now.L\1"),
    (r"!now\.K; /", "!(now.K && now.L); /"),
    (r"!now\.K; /", "!!now.K; /"),
    (r"!now\.K; /", "~now.K; /"),
    (r"!now\.K; /", "!&now.K; /"),
    (r"wire\.GO =", "wire.GO |="),
    (r"wire\.GO =", "wire.GO = wire.ASK ="),
    (r"2000u, ms", "2000u + 1u, ms"),
    (r"2000u, ms", "02000u, ms"),
    (r"2000u, ms", "2000u, ms * 2u"),
    (r"2000u, ms", "4294969296u, ms"),
    (r"2000u, ms", "2000.5, ms"),
    (r"(  timers_002\(ms\);\n)(  part_003\(\);\n)", r"\2\1"),
    (r"(  part_001\(\);\n)(  timers_002\(ms\);\n)", r"\2\1"),
    (r"(  wire\.RT = on_delay.*\n)", r"\1\1"),
    (r"(  timers_002\()ms", r"\g<1>0u"),
    (r"(  part_003\(\);\n)", r"  if (now.K) {\n\1  }\n"),
    (r"(  part_003\(\);\n)", r"  if (now.K) return;\n\1"),
    (r"(  part_003\(\);\n)", r"  goto end;\n\1  end:\n"),
    (r"(  part_003\(\);\n)", r"  while (now.K) {\n\1  }\n"),
    (r"(  wire\.RT =)", r"  uint32_t ms = 9u;\n\1"),
    (r"(  wire\.RT =)", r"  { IL_small_wires wire; }\n\1"),
    (r"(  part_001\(\);\n)", r"  IL_small_wires wire = { true, true, true };\n\1"),
    (r"(  part_001\(\);\n)", r"  ms = 0u;\n\1"),
    (r"(  part_001\(\);\n)", r"  in = IL_small_in;\n\1"),
    (r"(  now = next;\n)(  report\(\);\n)", r"\2\1"),
    (r"(  now = next;\n)", r"\1\1  now.K = false;\n"),
    (r"  report\(\);\n\}\n\Z", "}\n"),
    (r"  delay\.RT\.elapsed_ms = 0u;\n", ""),
    (r"  delay\.RT\.elapsed_ms = 0u;", "  delay.RT.elapsed_ms = 5u;"),
    (r"  delay\.RT\.elapsed_ms = 0u;", "  delay.RT.elapsed_ms = 4294967296u + 5u;"),
    (r"  IL_small_in\.REQ = 0;", "  IL_small_in.REQ = 65537;"),
    (r"  IL_small_in\.VALID = 0u;", "  IL_small_in.VALID = 256u;"),
    (r"  IL_small_in\.A = 1u;", "  IL_small_in.A = 2u;"),
    (r"  now\.K = true;", "  now.K = 1;"),
    (r"  now\.K = true;", "  now.K == true;"),
    (r"timer->runs = on;", "timer->runs = true;"),
    (r"(  if \(!begun\)\n  \{\n)", r"\1    begun = true;\n"),
]

COPIED = [
    (r"\(IL_small_in\.VALID == 1u\)", "IL_small_in.VALID"),
    (r"\(IL_small_in\.VALID == 1u\)", "(bool)IL_small_in.VALID"),
    (r"\(IL_small_in\.VALID == 1u\)", "!!IL_small_in.VALID"),
    (r"\(IL_small_in\.VALID == 1u\)", "(IL_small_in.VALID != 0u)"),
    (r"\(IL_small_in\.VALID == 1u\)", "(IL_small_in.VALID >= 1u)"),
    (r"\(IL_small_in\.VALID == 1u\)", "(IL_small_in.VALID & 1u)"),
    (r"\(IL_small_in\.VALID == 1u\)", "(IL_small_in.VALID == 0u)"),
    (r"\(IL_small_in\.VALID == 1u\)", "(IL_small_in.VALID == 257u)"),
    (r"\(IL_small_in\.VALID == 1u\)", "(IL_small_in.VALID == true) || now.L"),
    (r"\(IL_small_in\.VALID == 1u\)", "(IL_small_in.A == 1u)"),
    (r"\(IL_small_in\.VALID == 1u\)", "true"),
    (r"\(IL_small_in\.A != 0u\)", "(IL_small_in.A == 1u)"),
    (r"\(IL_small_in\.A != 0u\)", "(IL_small_in.A != 1u)"),
    (r"\(IL_small_in\.A != 0u\)", "(IL_small_in.A & 1u)"),
    (r"\(IL_small_in\.A != 0u\)", "(IL_small_in.VALID != 0u)"),
    (r"\(IL_small_in\.A != 0u\)", "(in.VALID != 0u)"),
    (r"= IL_small_in\.REQ;", "= (IL_small_in.REQ == 1u);"),
    (r"= IL_small_in\.REQ;", "= (int8_t)IL_small_in.REQ;"),
    (r"= IL_small_in\.REQ;", "= IL_small_in.A;"),
    (r"  in\.A = .*\n", ""),
    (r"(  in\.A = .*\n)", r"\1\1"),
    (r"(  in\.A = .*\n)", r"\1  in.A = false;\n"),
    (r"(  in\.A = .*\n)", r"\1  now.K = false;\n"),
    (r"(  in\.A =)", r"  if (now.K) in.A ="),
    (r"  in\.A =", "  in.A |="),
    (r"  inputs_001\(\);\n", ""),
    (r"(  inputs_001\(\);\n)", r"\1\1"),
    (r"(  inputs_001\(\);\n)(  if \(implausible(?:.*\n){4})", r"\2\1"),
    (r"(  inputs_001\(\);\n)((?:.*\n)*?)(  part_001)", r"\2\1\3"),
    (r"(  now = next;\n)", r"  inputs_001();\n\1"),
    (r"(  inputs_001\(\);\n)", r"  if (now.K) {\n\1  }\n"),
    (r"inputs_001\(void\)", "inputs_001(uint32_t ms)"),
    (r"uint8_t VALID;", "bool VALID;"),
    (r"uint8_t VALID;", "int8_t VALID;"),
    (r"uint8_t VALID;", "char VALID;"),
    (r"uint8_t VALID;", "uint32_t VALID;"),
    (r"uint8_t VALID;", "uint8_t VALID : 1;"),
    (r"bool VALID;", "uint8_t VALID;"),
    (r"  implausible = implausible \|\| \(IL_small_in\.A > 1u\);\n", ""),
    (r"implausible \|\| \(IL_small_in\.A > 1u\)", "(IL_small_in.A > 1u)"),
    (r"implausible \|\| \(IL_small_in\.A > 1u\)", "implausible && (IL_small_in.A > 1u)"),
    (r"implausible \|\| \(IL_small_in\.A > 1u\)", "implausible || (IL_small_in.A > 2u)"),
    (r"implausible \|\| \(IL_small_in\.A > 1u\)", "implausible || (in.A > 1u)"),
    (r"implausible \|\| \(IL_small_in\.A > 1u\)", "implausible || (IL_small_in.VALID > 1u)"),
    (r"(?<=\n)  implausible = false;\n", ""),
    (r"  implausible = false;\n(  inputs_001\(\);\n)", r"\1  implausible = false;\n"),
    (r"implausible \|\| \(ms", "(ms"),
    (r"implausible \|\| \(ms", "implausible && (ms"),
    (r"static bool implausible", "static uint8_t implausible"),
    (r"(  part_001\(\);\n)", r"  implausible = false;\n\1"),
    (r"in\.VALID /\* test", "(in.VALID || implausible) /* test"),
    (r"static IL_small_read in;", "static IL_small_inputs in;"),
    (r"uint8_t \*bit;", "bool *bit;"),
    (r"in\.VALID /\* test", "(IL_small_in.VALID == 1u) /* test"),
    (r"in\.VALID /\* test", "(in.VALID == 1) /* test"),
]
"""How a scan reads its inputs: a byte that is neither 0 nor 1 is restrictive, whatever it is of, and all are lost."""


@pytest.mark.parametrize(("old", "new"), [*PREPROCESSED, *DECLARED, *COMPUTED, *COPIED])
def test_no_edit_that_c_takes_otherwise_is_accepted(old: str, new: str) -> None:
    controller, files = smallest()
    assert not any(compare_c(controller, x).proved for x in edited(files, old, new))


def test_a_time_that_no_timer_can_count_is_refused() -> None:
    """Milliseconds in 32 bits are 49 days; the compiler would take the rest of a longer time."""
    controller, _ = smallest()
    for preset, fits in ((2**32 - 1, True), (2**32 + 2000, False)):
        steps = tuple(replace(x, preset_ms=preset) if isinstance(x, Timer) else x for x in controller.steps)
        timed = replace(controller, steps=steps)
        assert compare_c(timed, runtime_c(timed, [])).proved is fits


@pytest.mark.external
def test_compiled_by_gcc_such_edits_answer_otherwise(
    tmp_path_factory: pytest.TempPathFactory,
) -> None:
    """A comment that ends where blanks follow a backslash, an input read past a stalled cycle, a short timer."""
    layout, table, controller = built("mine11")
    files = runtime_c(controller, [])
    pair, _ = driven(layout, table, controller, 3000, 7)
    assert pair.stalls > 10
    edits = (
        (r"(void report\(void\)\n\{\n)", r"\1  /* *\\ \n/ now = next; return; /* */\n"),
        (r"\bin\.VALID\b(?! = false)", r"IL_mine11_in.VALID"),
        (r"uint32_t elapsed_ms;", "uint8_t elapsed_ms;"),
    )
    for n, (old, new) in enumerate(edits):
        wrong = {f: re.sub(old, new, t) for f, t in files.items()}
        assert wrong != files and not compare_c(controller, wrong).proved
        program = built_by_gcc(controller, wrong, tmp_path_factory.mktemp(f"wrong{n}"), warnings=())
        same = answers(program, bytes(pair.given)) == bytes(pair.told)
        assert not same, old
