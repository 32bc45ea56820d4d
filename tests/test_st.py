"""The emitted Structured Text: subset, sizes, parsers, and the proof that text equals controller can fail."""

from __future__ import annotations

import itertools
import random
import re
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import pytest
import tree_sitter
import tree_sitter_iec61131_3_st

from interlock.app.init import line
from interlock.derivation import derive
from interlock.diag import Sink
from interlock.frontend import load_text
from interlock.logic.controller import Equation, Input, Step
from interlock.logic.expr import FALSE, TRUE, Substitution, neg, var
from interlock.logic.lower import lower
from interlock.logic.names import spelled
from interlock.logic.order import by_place
from interlock.proof.equivalence.structured_text import Scan, compare_scan, compare_st, kept, wires
from interlock.st.ast import Assign, Expression, Nary, Not
from interlock.st.delivery import write_st
from interlock.st.dialects import BY_NAME
from interlock.st.lower import MAX_OPERANDS, lower_st
from interlock.st.meaning import Execution, Symbol, Symbols, Term
from interlock.st.parser import NotInSubset, parse_block, parse_unit
from interlock.st.printer import MAX_COLUMNS, comment, print_unit, wrapped
from interlock.st.structures import plain, structured
from tests.layouts import SHIPPED, built


def text_of(name: str) -> str:
    _, _, controller = built(name)
    (text,) = write_st(controller, BY_NAME["iec"], ["made for a test"]).values()
    return text


@pytest.mark.parametrize("name", SHIPPED)
def test_text_keeps_to_the_portable_subset(name: str) -> None:
    text = text_of(name)
    assert text.endswith("\n") and text.isascii()
    assert max(map(len, text.splitlines())) <= MAX_COLUMNS
    code = re.sub(r"\(\*.*?\*\)", "", text, flags=re.S)
    assert not re.search(
        r"\b(FOR|WHILE|REPEAT|CASE|EXIT|RETURN|POINTER|REF_TO|VAR_GLOBAL|VAR_EXTERNAL|RETAIN|ARRAY)\b", code
    )
    assert "//" not in code and "/*" not in code and ";;" not in code
    for word in set(re.findall(r"[A-Za-z_]\w*", code)):
        assert len(word) <= 24 and "__" not in word and not word.endswith("_"), word
    for block in text.split("END_FUNCTION_BLOCK")[:-1]:
        inner = block.split("FUNCTION_BLOCK ")[1]
        rows = inner.count("\n")
        assert rows <= 500, (inner.split()[0], rows)
    for statement in code.split(";"):
        depth = 0
        deepest = 0
        for c in statement:
            depth += (c == "(") - (c == ")")
            deepest = max(deepest, depth)
        assert deepest <= 3
    for block_ in parse_unit(text).blocks:
        for assignment in block_.body:
            if isinstance(assignment, Assign):
                assert _widest(assignment.value) <= MAX_OPERANDS, (block_.name, str(assignment.target))


def _widest(x: Expression) -> int:
    """The most operands of any operator in an expression."""
    if isinstance(x, Not):
        return _widest(x.arg)
    if isinstance(x, Nary):
        return max(len(x.args), *(_widest(a) for a in x.args))
    return 1


@pytest.mark.parametrize("name", SHIPPED)
def test_an_independent_parser_accepts_every_text(name: str) -> None:
    parser = tree_sitter.Parser(tree_sitter.Language(tree_sitter_iec61131_3_st.language()))
    assert not parser.parse(text_of(name).encode()).root_node.has_error


def test_an_independent_parser_accepts_every_committed_text() -> None:
    parser = tree_sitter.Parser(tree_sitter.Language(tree_sitter_iec61131_3_st.language()))
    texts = sorted(Path("generated").glob("*/st/iec/*.st"))
    assert {p.stem.split("_")[-1] for p in texts} >= {"io", "telegram"} and len(texts) >= 2 * len(SHIPPED)
    for path in texts:
        assert not parser.parse(path.read_bytes()).root_node.has_error, path


@pytest.mark.parametrize("name", SHIPPED)
def test_parse_and_print_round_trip(name: str) -> None:
    text = text_of(name)
    unit = parse_unit(text)
    assert unit.blocks == structured(lower_st(built(name)[2], [])).blocks
    assert parse_unit(print_unit(unit)) == unit


@pytest.mark.parametrize("name", SHIPPED)
def test_text_equals_controller(name: str) -> None:
    _, _, controller = built(name)
    result = compare_st(controller, text_of(name))
    assert result.proved and result.compared > 2 * len(controller.state)


@pytest.mark.parametrize("name", SHIPPED)
def test_equations_stand_place_by_place_and_after_what_they_read(name: str) -> None:
    """What a block reads of other blocks is called before it, or kept from the last scan; places are not scattered."""
    controller = built(name)[2]
    following = {e.name: replace(e, name=f"N_{e.name}") for e in controller.next}
    steps = by_place(controller.steps, following)
    assert sorted(s.name for s in steps) == sorted(s.name for s in [*controller.steps, *following.values()])
    known = {*(i.name for i in controller.inputs), *(s.name for s in controller.state)}
    for s in steps:
        assert known.issuperset(s.reads if isinstance(s, Equation) else (s.input,)), s.name
        known.add(s.name)


def test_blocks_of_one_place_declare_little_of_others() -> None:
    """Cut kind by kind, as a controller lists them, the equations of a long line would declare far more inputs."""
    sink = Sink()
    layout, _ = load_text("line.yaml", line(40), sink)
    assert layout is not None
    controller = lower(layout, derive(layout, sink))
    following = {e.name: replace(e, name=f"N_{e.name}") for e in controller.next}
    scattered = [*controller.steps, *following.values()]
    assert declared(by_place(controller.steps, following)) < 0.7 * declared(scattered)


def declared(steps: Sequence[Step]) -> int:
    """Inputs of blocks of 50 equations each."""
    equations = [s for s in steps if isinstance(s, Equation)]
    count = 0
    for at in range(0, len(equations), 50):
        block = equations[at : at + 50]
        count += len({n for e in block for n in e.reads} - {e.name for e in block})
    return count


def test_a_text_that_reads_what_a_later_equation_left_in_the_last_scan_is_refuted() -> None:
    """In the first scan it computes the same; from the second on it does not."""
    _, _, controller = built("fig2_2")
    text = re.sub(r"\(\*[^*]*\*\)", "", text_of("fig2_2"))
    assert compare_st(controller, text).proved
    at = text.index("  D.QN_P1 := ")
    end = text.index(";", at)
    block = text[text.rindex("FUNCTION_BLOCK", 0, at) : text.index("END_FUNCTION_BLOCK", at)]
    later = re.findall(r"\n  (D\.\w+) :=", block)[-1]
    stale = text[at:end].replace(":= ", f":= {later} OR (", 1) + ")"
    assert not compare_st(controller, text[:at] + stale + text[end:]).proved
    lines = text.splitlines(keepends=True)  # the same between blocks: a block called before what it reads
    calls = [k for k, line in enumerate(lines) if re.match(r"  B\d+\(", line)]
    first, second = calls[0], calls[1]
    stop = next(k for k in range(second, len(lines)) if ");" in lines[k]) + 1
    swapped = lines[:first] + lines[second:stop] + lines[first:second] + lines[stop:]
    assert not compare_st(controller, "".join(swapped)).proved


def test_what_is_read_before_it_is_written_may_be_anything() -> None:
    """Outputs, what another instance shows, and what an IF leaves as it was: each has an unknown of its own."""
    text = """
FUNCTION_BLOCK A
VAR_OUTPUT q : BOOL; END_VAR
END_FUNCTION_BLOCK
FUNCTION_BLOCK M
VAR_INPUT c : BOOL; END_VAR
VAR_OUTPUT o : BOOL; p : BOOL; r : BOOL; n : BOOL; END_VAR
VAR v : BOOL; w : BOOL; a : A; END_VAR
  o := v;
  IF c THEN w := TRUE; END_IF;
  p := w;
  r := a.q;
  v := c;
END_FUNCTION_BLOCK
"""
    run: Execution[Term] = Execution(parse_unit(text), Symbols(), kept)
    run.main.forget()
    c, v, w, q, n = (var(spelled(x)) for x in ("c", "kept v", "kept w", "kept a.q", "kept n"))
    assert run.scan({"c": c}) == {"o": v, "p": c | (neg(c) & w), "r": q, "n": n}
    assert run.main.values["v"] is c, "what is written is known"


def _edits(text: str, rng: random.Random) -> tuple[str, str]:
    """One random edit of the code that is likely to change its meaning."""
    kind = rng.choice(["and-or", "drop-not", "swap", "drop-line", "initial", "time", "number"])
    if kind == "and-or":
        found = list(re.finditer(r"\bAND\b", text))
        m = rng.choice(found)
        return kind, text[: m.start()] + "OR" + text[m.end() :]
    if kind == "drop-not":
        m = rng.choice(list(re.finditer(r"\bNOT ", text)))
        return kind, text[: m.start()] + text[m.end() :]
    if kind == "swap":
        m = rng.choice(list(re.finditer(r"OCC_(\w+)", text)))
        other = rng.choice([x for x in set(re.findall(r"OCC_\w+", text)) if x != m.group()] or ["VALID"])
        return kind, text[: m.start()] + other + text[m.end() :]
    if kind == "drop-line":
        m = rng.choice(list(re.finditer(r"\n    AND [^;\n]*(?=\n)", text)))
        return kind, text[: m.start()] + text[m.end() :]
    if kind == "initial":
        m = rng.choice(list(re.finditer(r"  (N_)?([A-Z]_\w+) : BOOL := (TRUE|FALSE);", text)))
        if m.group(1):
            return "same", text
        flipped = m.group().replace("TRUE", "X").replace("FALSE", "TRUE").replace("X", "FALSE")
        return kind, text[: m.start()] + flipped + text[m.end() :]
    if kind == "time":
        return kind, text.replace("T#60s", "T#59s", 1) if "T#60s" in text else text.replace("T#180s", "T#18s", 1)
    m = rng.choice(list(re.finditer(r"REQ = (\d+)", text)))
    return kind, text[: m.start()] + f"REQ = {int(m.group(1)) + 1}" + text[m.end() :]


def test_edited_text_is_refuted_unless_the_edit_changes_nothing() -> None:
    """Each edit that the proof accepts must be harmless: the text behaves the same on many random scans."""
    from interlock.st.meaning import BadText, Execution, Numbers
    from tests.test_equal import random_inputs

    rng = random.Random(5)
    _, _, controller = built("fig2_3_split")
    text = text_of("fig2_3_split")
    refuted = 0
    for _ in range(60):
        kind, edited = _edits(text, rng)
        result = compare_st(controller, edited)
        if not result.proved:
            refuted += 1
            assert result.differences[0].name and result.differences[0].text
            continue
        try:
            runs = []
            for t in (text, edited):
                numbers = Numbers(1000)
                run: Execution[int] = Execution(plain(parse_unit(t)), numbers)
                trace = random.Random(1)
                runs.append([run.scan(random_inputs(controller, trace)) for _ in range(60)])
            assert runs[0] == runs[1], kind
        except BadText:
            raise AssertionError(f"a text that cannot run was accepted ({kind})") from None
    assert refuted >= 40


def test_a_wire_is_only_what_its_variable_holds_when_it_is_read() -> None:
    """Written twice, read before it is written, or taken by an input: each is another function, or refused as it is."""
    _, _, controller = built("fig2_2")
    text = text_of("fig2_2")
    assert compare_st(controller, text).proved
    begin = text.index("  D.AVN_P1 := ")
    end = text.index(" (* lies there since the restart *)", begin)
    made, after = text[begin:end] + "\n", text[end:]
    assert made.rstrip().endswith(";") and "AVN_P1" in after
    assert compare_st(controller, text[:begin] + made + after).proved
    for again in (made, "  D.AVN_P1 := D.AVN_P1;\n", "  D.AVN_P1 := NOT D.AVN_P1;\n", "  D.AVN_P1 := FALSE;\n"):
        assert not compare_st(controller, text[:begin] + made + again + after).proved
    denied = made.replace(":= ", ":= NOT (", 1).replace(";", ");")
    assert not compare_st(controller, text[:begin] + denied + after).proved
    reader = after.index("  D.WF_DP_1 := ")  # what it reads of the wire is now older than the wire
    assert not compare_st(controller, text[:begin] + after[:reader] + made + after[reader:]).proved
    a = controller.next[0].name
    shadowed = replace(
        controller, inputs=(*controller.inputs, Input(f"N_{a}", "an input that bears a next value's name"))
    )
    assert f"N_{a}" in wires(controller) and f"N_{a}" not in wires(shadowed)
    right = Scan(
        {s.name: TRUE if s.initial else FALSE for s in controller.state},
        dict(controller.next_state),
        {o.name: Substitution(controller.next_state)(o.expr) for o in controller.outputs},
        {t.name: (controller.expanded[t.input], t.preset_ms) for t in controller.timers},
        {name: Symbol(name) for name in controller.words.routes.values()},
    )
    assert compare_scan(controller, right).proved
    wrong = replace(right, after={**right.after, a: var(f"N_{a}")})
    assert not compare_scan(controller, wrong).proved
    same = Symbols(known={"N_A": (var("b") & var("c"), var("next A"))})
    assert same.assigned("N_A", var("b") & var("c")) is var("next A")
    assert same.assigned("N_A", var("b")) is var("b") and same.assigned("B", var("b") & var("c")) is var("b") & var("c")


def test_text_outside_the_subset_is_refused() -> None:
    with pytest.raises(NotInSubset, match="line 3"):
        parse_unit("FUNCTION_BLOCK A\nVAR X : BOOL; END_VAR\nFOR X := 1 TO 2 DO END_FOR;\nEND_FUNCTION_BLOCK\n")


def test_a_text_that_ends_anywhere_is_refused_with_a_place() -> None:
    text = text_of("fig2_2")
    whole = text.rstrip()
    for end in range(whole.rindex("\nFUNCTION_BLOCK") + 3, len(whole), 17):
        with pytest.raises(NotInSubset, match=r"line \d+, column \d+"):
            parse_unit(whole[:end])


@pytest.mark.parametrize(
    ("text", "place"),
    [
        ("X;\nEND_FUNCTION_BLOCK\n", "line 5"),  # after a block, before another one
        ("(* a comment\nEND_FUNCTION_BLOCK\n*)\n", "line 5"),  # a comment around what looks like an end
        ("FUNCTION_BLOCK C\nA := (\nEND_FUNCTION_BLOCK\n", "line 7"),
    ],
)
def test_what_stands_between_two_blocks_is_read(text: str, place: str) -> None:
    block = "FUNCTION_BLOCK {}\nVAR A : BOOL; END_VAR\nA := A;\nEND_FUNCTION_BLOCK\n"
    assert len(parse_unit(block.format("A") + "(* and *)\n" + block.format("B")).blocks) == 2
    with pytest.raises(NotInSubset, match=place):
        parse_unit(block.format("A") + text + block.format("B"))
    with pytest.raises(NotInSubset):
        parse_block("C", "VAR A : BOOL; END_VAR", f"A := A;\nEND_FUNCTION_BLOCK\n{text}")
    with pytest.raises(NotInSubset):
        parse_block("C", "VAR A : BOOL; END_VAR\nEND_FUNCTION_BLOCK\n", "A := A;")


def test_a_comment_cannot_be_ended_by_a_name() -> None:
    assert comment("a *) b (* c") == "(* a * ) b ( * c *)"
    assert comment("a ＊） b （＊ c") == "(* a * ) b ( * c *)", "full-width signs are read as these"
    assert comment("a ]]> b ］］＞ c") == "(* a ] ]> b ] ]> c *)", "a text in XML may end so"
    assert comment("@END_DECLARATION") == "(* - @END_DECLARATION *)", "no tool obeys what a name says"
    assert comment("  ＄R+") == "(* -   $R+ *)" and comment("", 9) == "(*  *)"
    assert len(comment("门" * 100, 40)) == 46, "a sign may be read as several"


def test_an_index_line_ends_however_long_its_words_are() -> None:
    """A name has no limit of length; a word that does not fit on a line is cut, and nothing of it is lost."""
    for whole in (f"element {'a' * 500}: x, y", "b" * 139 + " c", f"    {'d' * 300}", " ".join(["word"] * 100)):
        pieces = list(itertools.islice(wrapped(whole), 20))
        assert len(pieces) < 20 and all(len(p) <= 140 for p in pieces)
        assert "".join(pieces).replace(" ", "") == whole.replace(" ", "")


def test_the_headline_of_a_block_names_whole_places() -> None:
    """Cut in the middle, `signal X1` would read as another signal."""
    text = text_of("cn6502")
    heads = re.findall(r"^FUNCTION_BLOCK IL_cn6502_B\d+\n\(\* (.*) \*\)$", text, flags=re.M)
    places = set(re.findall(r"^\(\* (\w+ [^:]+|\w+): ", text, flags=re.M))
    assert len(heads) > 20 and any(" more" in h for h in heads)
    for head in heads:
        for place in head.split(", "):
            assert place in places or re.fullmatch(r"and \d+ more", place), head
