"""Slips are told alike whatever script names are in, and signs of East Asian keyboards by what they stand for."""

from __future__ import annotations

import pytest

import interlock

TEXT = """interlock: 1
name: x
boundaries:
  W: {approach: a0 600}
buffers: [B]
tracks:
  t: [W, SECTION 400, SECOND 200, B]
signals:
  SIGNAL: {from: W, into: SECTION}
conditions:
  K: {text: t, over: [SECTION, SECOND]}
"""
LATIN = {"SECTION": "q1", "SECOND": "q2", "SIGNAL": "S1", "TRACK": "T2"}
CHINESE = {"SECTION": "底1", "SECOND": "主2", "SIGNAL": "上行", "TRACK": "道"}
SLIPS = {
    "round brackets for braces": ("{from: W, into: SECTION}", "(from: W, into: SECTION)"),
    "no braces": ("{from: W, into: SECTION}", "from: W, into: SECTION"),
    "no space before a brace": ("SIGNAL: {", "SIGNAL:{"),
    "no colon": ("SIGNAL: {", "SIGNAL {"),
    "no space before a list": ("SECOND 200, B]", "SECOND 200, B]\n  TRACK:[B]"),
    "no comma before a key": ("W, into: SECTION", "W into: SECTION"),
    "no comma behind a name": ("into: SECTION}", "into: SECTION kind: main}"),
    "a semicolon": ("W, into", "W; into"),
    "a room that is closed": ("signals:\n", "signals: {}\n"),
    "a dash": ("  SIGNAL: {", "  - SIGNAL: {"),
    "equals": ("SIGNAL: {", "SIGNAL = {"),
    "two colons": ("  SIGNAL: {", "  SIGNAL:: {"),
    "a colon in a text": ("signals:\n", "sections:\n  SECTION: lane: level\nsignals:\n"),
    "a tab": ("  SIGNAL", "\tSIGNAL"),
    "a bracket that is not closed": ("200, B]", "200, B"),
    "a quote that is not closed": ("into: SECTION}", 'into: "SECTION}'),
    "a quote inside a text": ("into: SECTION}", "into: 'SECTION's'}"),
    "a name with the mark of a track section": ("  SIGNAL: {", "  SIGNAL#:{"),
}


def named(text: str, names: dict[str, str]) -> str:
    for name, called in names.items():
        text = text.replace(name, called)
    return text


def told(text: str) -> list[tuple[str, str, str]]:
    """Code, message and advice of each problem."""
    with pytest.raises(interlock.LayoutError) as caught:
        interlock.loads(text)
    return [(d.code, d.message, d.fix) for d in caught.value.diagnostics]


@pytest.mark.parametrize("slip", SLIPS)
def test_a_slip_is_told_alike_under_latin_and_chinese_names(slip: str) -> None:
    right, wrong = SLIPS[slip]
    assert TEXT.count(right) >= 1
    text = TEXT.replace(right, wrong)
    of_latin, of_chinese = (
        [tuple(named(part, {v: k for k, v in names.items()}) for part in one) for one in told(named(text, names))]
        for names in (LATIN, CHINESE)
    )
    assert of_latin == of_chinese
    assert "the line is indented by" not in of_latin[0][1]


SIGNS = {
    "commas of a list": ("[底1, 主2]", "[底1，主2]", "底1, 主2"),
    "the enumeration comma": ("[底1, 主2]", "[底1、主2]", "底1, 主2"),
    "a semicolon": ("[底1, 主2]", "[底1；主2]", "底1, 主2"),
    "a full stop": ("[底1, 主2]", "[底1。主2]", "底1, 主2"),
    "brackets of a list": ("[底1, 主2]", "（底1，主2）", "over: [底1, 主2]"),
    "square brackets of a list": ("[底1, 主2]", "［底1，主2］", "over: [底1, 主2]"),
    "corner brackets of a list": ("[底1, 主2]", "【底1、主2】", "over: [底1, 主2]"),
    "commas of a track": ("底1 400, 主2 200", "底1 400，主2 200", "底1 400, 主2 200"),
    "the enumeration comma of a mapping": ("W, into", "W、 into", "`,`"),
    "round brackets for braces": ("{from: W, into: 底1}", "（from: W, into: 底1）", "上行: {from: W, into: 底1}"),
    "ascii round brackets for braces": ("{from: W, into: 底1}", "(from: W, into: 底1)", "上行: {from: W, into: 底1}"),
    "round brackets for one value": ("signals:\n", "sections:\n  底1: (lane: level)\nsignals:\n", "底1: {lane: level}"),
    "wide ones for one value": ("signals:\n", "sections:\n  底1: （lane：level）\nsignals:\n", "底1: {lane: level}"),
}


@pytest.mark.parametrize("slip", SIGNS)
def test_a_full_width_sign_is_told_by_what_it_stands_for(slip: str) -> None:
    right, wrong, fix = SIGNS[slip]
    text = named(TEXT, CHINESE)
    assert right in text
    found = told(text.replace(right, wrong))
    assert fix in found[0][2] and "_" not in found[0][2], found
    assert {code for code, _, _ in found[1:]} <= {"IL2004"}, "sections of a track that is not read"


def test_a_full_width_sign_in_a_comment_is_no_slip() -> None:
    text = named(TEXT, CHINESE).replace("signals:\n", "sections:\n  底1: lane: level  # 注：斜巷\nsignals:\n")
    ((_, message, _),) = told(text)
    assert "full-width" not in message


SPACES = {"full-width": "\u3000", "no-break": "\u00a0"}


@pytest.mark.parametrize("space", SPACES)
@pytest.mark.parametrize("before", ["  a: [q1 100]\n", ""])
@pytest.mark.parametrize("after", ["  c: [q3 100]\n", ""])
@pytest.mark.parametrize("plain", ["", "  ", " "])
def test_a_line_that_is_indented_by_another_space_is_named(space: str, before: str, after: str, plain: str) -> None:
    text = f"interlock: 1\nname: x\ntracks:\n{before}{plain}{2 * SPACES[space]}b: [q2 100]\n{after}"
    with pytest.raises(interlock.LayoutError) as caught:
        interlock.loads(text)
    (one,) = caught.value.diagnostics
    assert (one.code, one.message) == (
        "IL1004",
        f"broken YAML: a {space} space stands where a line is indented",
    )
    line = 4 + bool(before)
    assert one.span is not None and one.span[1:] == (line, 1 + len(plain), 2)
    assert one.fix == "indent with plain spaces"


def test_a_text_may_have_lines_that_begin_with_another_space() -> None:
    text = TEXT.replace("name: x\n", "name: x\ntitle: |\n  \u3000\u3000东山矿: 井底\n")
    assert interlock.loads(named(text, CHINESE)).printed.title == "\u3000\u3000东山矿: 井底\n"
