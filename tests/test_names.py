"""Names as on the drawing, and what they become in PLC text."""

from __future__ import annotations

import csv
import hashlib
import itertools
import random
import re
import string
import sys
import unicodedata
from pathlib import Path

import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from interlock.app.compile import build
from interlock.checker.railway import safe
from interlock.diag import Severity, Sink
from interlock.emit.io import names_csv
from interlock.frontend import load_text
from interlock.frontend.scalars import NAME
from interlock.logic.cabinet import allocate
from interlock.logic.lower import lower
from interlock.logic.names import Kind, families
from interlock.model.portable import LONGEST, OWN_ENDING, portable
from interlock.st.delivery import write_delivery
from interlock.st.dialects import BY_NAME
from interlock.st.lint import AVOID
from interlock.st.telegram import telegram_unit
from tests.layouts import built, grown

TEXT = """interlock: 1
name: demo
boundaries:
  W: {{approach: {0} 100}}
  E: {{trains: out}}
tracks:
  main: [W, {1} 100]
points:
  {2}: {{section: {3}, toe: main.end, normal: E, reverse: stub.start}}
signals:
  {4}: {{from: W, into: {1}}}
buffers: [Z]
conditions:
  {5}: {{signals: [{4}]}}
"""


def test_kinds_may_share_names_even_awkward_ones() -> None:
    """Every PLC name begins with a prefix of its kind, so that even these names do not clash."""
    awkward = ["ALL", "R1", "1", "VALID"]
    for words in itertools.permutations(awkward, 3):
        a, b, c = words
        text = TEXT.format("ap", a, a, b, a, c).replace("reverse: stub.start", "reverse: Z")
        made = grown(text)
        assert made is not None
        layout, table, _ = made
        controller = lower(layout, table)  # raises MalformedController on a clash
        names = [i.name for i in controller.inputs] + [s.name for s in controller.state]
        names += [s.name for s in controller.steps] + [o.name for o in controller.outputs]
        assert len({n.upper() for n in names}) == len(names)
        assert max(map(len, names)) <= 24


SCRIPTS = Path("tests/layouts_for_tests/scripts.yaml")
FILLERS = "\u115f\u1160\u3164\uffa0"  # letters that nobody sees
WORDS = st.text(st.characters(categories=["L", "N"]), min_size=1, max_size=12).filter(
    lambda w: not set(w) & set(FILLERS)
)
NAMES = st.lists(WORDS, min_size=1, max_size=3).flatmap(
    lambda words: st.sampled_from("_-/ ").map(lambda between: between.join(words))
)


LINE = """interlock: 1
name: demo
boundaries:
  {0}: {{approach: wa 300, block: token}}
  E: {{trains: out}}
tracks:
  main: [{0}, {1} 200, q2 200, E]
signals:
  X1: {{from: {0}, into: {1}}}
  X2: {{from: {1}, into: q2}}
substations:
  {2}: [X1]
  {3}: []
"""


@pytest.mark.parametrize(
    ("names", "code"),
    [
        (("a", "a_b", "s-1", "s2"), ""),
        (("a-b", "a_b", "s1", "s2"), "IL2010"),  # BT_a_b: released behind the train, and the hand that takes the token
        (("a-b", "A_b", "s1", "s2"), "IL2010"),
        (("a b", "a_b", "s1", "s2"), "IL2010"),
        (("a", "b", "s-1", "s_1"), "IL2010"),  # HB_s_1: whose heartbeat?
        (("a", "b", "s1", "S1"), "IL2002"),
    ],
)
def test_whatever_shares_a_variable_in_plc_text_is_told_apart(names: tuple[str, ...], code: str) -> None:
    sink = Sink()
    layout, _ = load_text("line.yaml", LINE.format(*names), sink)
    assert {d.code for d in sink.diagnostics if d.severity is Severity.ERROR} == ({code} if code else set())
    assert (layout is None) == bool(code)


def test_families_that_are_written_alike_belong_to_elements_that_never_are() -> None:
    """Sections and boundaries have one room of names; whatever else is written alike would need one, too."""
    written: dict[str, set[Kind]] = {}
    for f in families():
        if f.portable:
            written.setdefault(f.pattern, set()).add(f.kind)
    assert {frozenset(kinds) for kinds in written.values() if len(kinds) > 1} == {frozenset((Kind.SECTION, Kind.LINE))}


def test_no_variable_of_an_element_is_a_word_that_tools_use() -> None:
    """Whatever the element is called: a section called TRIG would have the variable F_TRIG."""
    tails = {word[k:] for word in AVOID for k in range(len(word)) if NAME.fullmatch(word[k:])}
    for f in families():
        if f.portable and f.pattern.count("{") == 1:
            assert not {f.pattern.format(portable(tail)).upper() for tail in (*tails, "trig")} & AVOID, f
    assert portable("TRIG") == safe("TRIG") != "TRIG" and portable("edge") == safe("edge") != "edge"


@given(NAMES)
@example("TRIG")
@example("\u2474")  # (1) in one sign
@example("7\u2488")  # 1 and a full stop in one sign
def test_any_letters_become_a_short_identifier_and_both_writers_agree(name: str) -> None:
    """The prover's and the checker's are two pieces of code for the same paragraph of `language.md`."""
    written = portable(name)
    assert NAME.fullmatch(name)
    assert re.fullmatch(r"[A-Za-z0-9]+(_[A-Za-z0-9]+)*", written.replace("__", "_").strip("_")), written
    assert len(written) <= LONGEST
    assert written == safe(name)


def test_plain_names_stay_as_they_are() -> None:
    assert [portable(x) for x in ("X1", "1-3", "2/4WG", "IIAG", "a_b")] == ["X1", "1_3", "2_4WG", "IIAG", "a_b"]


def test_long_or_foreign_names_keep_what_can_be_read_of_them_and_do_not_clash() -> None:
    names = ("22ｲT", "22イT", "1#", "1", "Gleis_Nord_sehr_lang_1", "Gleis_Nord_sehr_lang_2", "Ä")
    written = [portable(x) for x in names]
    assert [x.rpartition("_")[0] for x in written] == ["22IT", "22IT", "1", "", "Gleis_Nor", "Gleis_Nor", "A"]
    assert len(set(written)) == len(written)


def test_a_layout_in_five_scripts_is_compiled_proved_and_written_in_ascii() -> None:
    proved, files = build(str(SCRIPTS))
    assert proved.green
    for place, data in files.items():
        if place.startswith("st/iec/"):
            assert place.isascii() and data.isascii(), place
    rows = list(csv.DictReader(files["io/names.csv"].decode().splitlines()))
    assert {"Kind": "section", "Name": "22ｲT", "Name in PLC text": portable("22ｲT")} in rows
    assert f"CLR_{portable('22ｲT')}" in files["io/channels.csv"].decode()
    assert "22ｲT" in files["table.csv"].decode()


ALIKE = """interlock: 1
name: demo
boundaries:
  W: {{approach: wa 600}}
  E: {{trains: out}}
tracks:
  main: [W, q1 200, q2 200, q3 200, E]
signals:
  {0}: {{from: W, into: q1}}
  {1}: {{from: q1, into: q2}}
  {2}: {{from: q2, into: q3}}
"""


@pytest.mark.parametrize(
    ("one", "other"),
    [
        ("S10", "S1O"),
        ("S1", "SI"),
        ("S1", "Sl"),
        ("Sl1", "S11"),
        ("\uff331", "S1"),
        ("A1", "\u04101"),
        ("\u0421\u041d2", "CH2"),
        ("\u03912", "\u04102"),
        ("22\uff72", "22\u30a4"),
        ("S\u2161", "SII"),
        ("SII_1", "SII_I"),
        ("22 T", "22T"),
        ("2 2T", "22 T"),
        ("Gleis Nord 10 A", "Gleis_Nord 1O A"),
        ("p1", "\u03c11"),
        ("U1", "\u054d1"),
        ("W1", "\u13b31"),
        ("d1", "\u05011"),
        ("i1", "\u01311"),
        ("X1", "X\u0661"),
        ("22\u30ed", "22\u53e3"),
        ("22\uff8a", "22\u516b"),
        ("3\u30fc", "3\u4e00"),
    ],
)
def test_names_of_one_kind_that_look_alike_are_told(one: str, other: str) -> None:
    sink = Sink()
    layout, _ = load_text("t", ALIKE.format(one, other, "Z"), sink)
    (found,) = sink.diagnostics
    assert layout is not None and (found.code, found.severity) == ("IL7010", Severity.WARNING)
    assert f"the signal {other} looks like the signal {one} of line 9" in found.message
    assert found.span is not None and found.span.line == 10

    allowed = f"allow: [{{lint: IL7010, at: [{other}], reason: as on the signs}}]\n"
    sink = Sink()
    load_text("t", ALIKE.format(one, other, "Z") + allowed, sink)
    assert sink.diagnostics == ()


@pytest.mark.parametrize(
    ("one", "other"),
    [("S 1", "S 2"), ("SII", "S11"), ("SIII", "S111"), ("q1O", "S10"), ("S-1", "S1"), ("S2", "SZ"), ("SIIa", "S11a")],
)
def test_names_that_differ_otherwise_are_not_told(one: str, other: str) -> None:
    """Roman and Arabic numbers of tracks; another kind (`q10` is a section); signs between; letters that only rhyme."""
    sink = Sink()
    load_text("t", ALIKE.replace("q1", "q10").format(one, other, "Z"), sink)
    assert sink.diagnostics == ()


@pytest.mark.parametrize("name", ["CON", "con", "Nul", "aux", "PRN", "COM1", "lpt9", "COM\u00b2"])
def test_a_layout_is_not_called_as_a_device(name: str) -> None:
    """Its outputs could not be copied to a computer with Windows, where the tools of PLCs run."""
    sink = Sink()
    assert load_text("t", ALIKE.replace("name: demo", f"name: {name}").format("S1", "S2", "Z"), sink)[0] is None
    (found,) = sink.diagnostics
    assert found.code == "IL1016" and "a device" in found.message and f"`{name}_1`" in found.fix


@pytest.mark.parametrize(
    "name",
    ["north Q", "north-i", "north_D", "north D2", "north IO", "north hmi", "n B01", "n-OUT02", "n TRY", "n H500"],
)
def test_a_layout_is_not_called_as_a_block_of_another(name: str) -> None:
    """`IL_north_Q` would be two things in one controller, and a tool may take the second for the first anew."""
    sink = Sink()
    assert load_text("t", ALIKE.replace("name: demo", f"name: {name}").format("S1", "S2", "Z"), sink)[0] is None
    (found,) = sink.diagnostics
    assert found.code == "IL1016" and "would be its block" in found.message and f"`{name}_1`" in found.fix
    sink = Sink()
    load_text("t", ALIKE.replace("name: demo", f"name: {name}_1").format("S1", "S2", "Z"), sink)
    assert not sink.has_errors


@pytest.mark.parametrize("name", ["north", "quai Q1", "north B1", "NIO", "Q", "west-W"])
def test_other_endings_are_free(name: str) -> None:
    sink = Sink()
    assert load_text("t", ALIKE.replace("name: demo", f"name: {name}").format("S1", "S2", "Z"), sink)[0] is not None


def test_every_block_of_a_layout_ends_as_no_other_layouts_name_may() -> None:
    """In each dialect, with mapping program and telegram; instances begin with `DB_`, and bear no name of a layout."""
    ends = set()
    for own in ("fig2_2", "heishan", "cn6502"):
        layout, _, controller = built(own)
        for dialect in BY_NAME.values():
            files = write_delivery(controller, allocate(layout, controller), dialect, [])
            names = [b.name for b in telegram_unit(own, list(layout.machines), False, []).blocks]
            text = "\n".join([*files.values(), *names])
            ends |= set(re.findall(rf"\bIL_{own}(_[A-Z]+\d*)\b", text))
    assert {"_I", "_Q", "_D", "_IO", "_HMI", "_WATCH", "_CYCLE", "_B01", "_OUT01", "_TASK", "_TRY"} <= ends
    assert [e for e in sorted(ends) if not OWN_ENDING.fullmatch(e) and e not in ("_CYC", "_W")] == []


def test_two_of_three_names_that_look_alike_are_told() -> None:
    """`S1l` looks like both others, which are Roman and Arabic; two warnings would be one too many."""
    sink = Sink()
    load_text("t", ALIKE.format("SII", "S11", "S1l"), sink)
    (found,) = sink.diagnostics
    assert found.message.startswith("the signal S1l looks like the signal SII of line 9: digit one here")


@pytest.mark.parametrize("path", sorted(Path("layouts").glob("*.yaml")), ids=lambda p: p.stem)
def test_no_shipped_layout_has_names_that_look_alike(path: Path) -> None:
    sink = Sink()
    load_text(path.name, path.read_text("utf-8"), sink)
    assert not sink.has("IL7010")


def test_names_are_listed_where_a_written_one_is_as_long_as_its_name() -> None:
    """Ladegleis Sü 3 is Ladegleis_c6nm, of 14 signs as well: the list was left out."""
    made = grown(TEXT.format("ap", "a", "1", "d", "X", "c").replace("reverse: stub.start", "reverse: Z"))
    other = grown(TEXT.format("ap", "Ladegleis Sü 3", "1", "d", "X", "c").replace("reverse: stub.start", "reverse: Z"))
    underlined = grown(TEXT.format("ap", "a-b c", "1", "d", "X", "c").replace("reverse: stub.start", "reverse: Z"))
    assert made is not None and other is not None and underlined is not None
    assert names_csv(made[0]) == names_csv(underlined[0]) == ""
    assert "section,Ladegleis Sü 3,Ladegleis_c6nm" in names_csv(other[0])


def as_the_page_says(name: str) -> str:
    """A name in PLC text, from "Names in PLC text" of the language's page alone."""
    if re.fullmatch("[A-Za-z0-9/ _-]{1,14}", name) and name.lower() not in ("trig", "edge"):
        return name.translate(dict.fromkeys(map(ord, "-/ "), "_"))
    read = []
    for sign in unicodedata.normalize("NFKD", re.sub("[-/ ]", "_", name)):
        words = unicodedata.name(sign, "").split()
        if not sign.isalnum() or sign.isascii():
            read.append(sign if sign.isalnum() or sign == "_" else "")
        elif "LETTER" in words[:-1] and set(words[-1]) <= set(string.ascii_uppercase):
            small = words[words.index("LETTER") - 1] == "SMALL"
            read.append(words[-1].lower() if small else words[-1])
        else:
            read.append(f"{ord(sign):X}")
    first, second, third = hashlib.sha256(name.encode()).digest()[:3]
    number = f"{first * 65536 + second * 256 + third:024b}"
    groups = [number[-5:], number[-10:-5], number[-15:-10], number[-20:-15]]
    signs = "".join("abcdefghijkmnpqrstuvwxyz23456789"[int(g, 2)] for g in groups)
    return "".join(read)[:9].strip("_") + "_" + signs


def test_names_in_plc_text_are_as_the_page_says() -> None:
    """Of every letter and digit of Unicode, and of names with what joins them, is decomposed or left out."""
    for number in range(sys.maxunicode + 1):
        sign = chr(number)
        if sign.isalnum():
            assert portable(f"A{sign}") == as_the_page_says(f"A{sign}") == safe(f"A{sign}"), ascii(sign)
    parts = [*"北主斜ЖжßéÄｲア㈱αΩاא한²³ⅣñØøłĐıİ#Ab1-/ _٣ᄀ𝔄x７①½ªǆ", "ｶﾞ", "e\u0301", "ＴＲＩＧ", "trig"]
    chance = random.Random(5)
    for _ in range(20_000):
        name = "".join(chance.choices(parts, k=chance.randint(1, 17)))
        assert portable(name) == as_the_page_says(name) == safe(name), ascii(name)
