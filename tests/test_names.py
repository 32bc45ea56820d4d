"""Names as on the drawing, and what they become in PLC text."""

from __future__ import annotations

import csv
import itertools
import re
from pathlib import Path

from hypothesis import given
from hypothesis import strategies as st

from interlock.app.compile import build
from interlock.checker.railway import safe
from interlock.frontend.scalars import NAME
from interlock.logic.lower import lower
from interlock.model.portable import LONGEST, portable
from tests.layouts import grown

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
WORDS = st.text(st.characters(categories=["L", "N"]), min_size=1, max_size=12)
NAMES = st.lists(WORDS, min_size=1, max_size=3).flatmap(
    lambda words: st.sampled_from("_-/").map(lambda between: between.join(words))
)


@given(NAMES)
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
