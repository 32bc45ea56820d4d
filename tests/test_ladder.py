"""A ladder is read as Beremiz carries it out: by where its elements stand, not only by what they are joined to."""

from __future__ import annotations

import re
from itertools import pairwise

import pytest

from interlock.proof.equivalence.structured_text import compare_dialect
from interlock.st.delivery import write_st
from interlock.st.dialects import BY_NAME
from tests.layouts import built

LADDER = BY_NAME["ladder"]
COIL = re.compile(r'<coil [^>]*><position x="(\d+)" y="(\d+)"/>.*?<variable>([^<]*)</variable></coil>')


def refused(text: str) -> bool:
    return not compare_dialect(built("fig2_2")[2], LADDER, {"fig2_2.xml": text}).proved


def drawn() -> str:
    (text,) = write_st(built("fig2_2")[2], LADDER, ["made for a test"]).values()
    return text


@pytest.mark.parametrize("apart", [1, 9, 10, 39])
def test_a_coil_less_than_a_row_below_the_one_before_is_refused(apart: int) -> None:
    """Beremiz takes coils less than 10 apart from left to right: the one that reads the other would come first."""
    text, left = drawn(), 0
    assert not refused(text)
    for body in re.finditer(r"<LD>.*?</LD>", text, re.DOTALL):
        coils = list(COIL.finditer(text, body.start(), body.end()))
        for above, below in pairwise(coils):
            if int(below[1]) < int(above[1]):
                own = f' y="{int(above[2]) + apart}"'
                edited = text[: below.start()] + below[0].replace(f' y="{below[2]}"', own, 1) + text[below.end() :]
                assert refused(edited), (above[3], below[3])
                left += 1
    assert left > 5


PINS = ('x="60" y="20"/>', 'x="60" y="40"/>')


def block(text: str, kind: str) -> tuple[str, str]:
    """A block's line, and that of the coil behind it."""
    at = text.rindex("\n", 0, text.index(f'typeName="{kind}"'))
    one, two = text[at:].split("\n")[1:3]
    return one, two


@pytest.mark.parametrize(("kind", "first", "second"), [("EQ", "ENO", "OUT"), ("TON", "Q", "ET")])
def test_a_block_has_its_own_outputs_where_they_are_drawn(kind: str, first: str, second: str) -> None:
    """Tools tell by name, or by the place where the line ends, from which output it comes."""
    text = drawn()
    own, coil = block(text, kind)
    swapped = own.replace(PINS[0], "@").replace(PINS[1], PINS[0]).replace("@", PINS[1])
    moved = own.replace(PINS[0], 'x="60" y="60"/>')
    used = PINS[kind == "EQ"]
    beside = own.replace(used, used.replace("60", "40", 1))
    renamed = own.replace(f'"{second}"', f'"{first}"')
    other = own.replace(f'"{first}"', '"X"')
    pins = re.findall(r'<variable formalParameter="\w+"><connectionPointOut>.*?</variable>', own)
    dropped = [own.replace(p, "") for p in pins]
    further = own.replace(pins[1], pins[1] + pins[1].replace(second, "X"))
    bare = own.replace(re.findall("<connectionPointOut>.*?</connectionPointOut>", pins[1])[0], "")
    placeless = own.replace(re.findall("<relPosition[^>]*>", pins[0])[0], "")
    turned = own.replace(pins[0] + pins[1], pins[1] + pins[0])
    named = own.replace(pins[0], pins[0].replace("<variable ", '<variable name="X" '))
    edits = [swapped, moved, beside, renamed, other, *dropped, further, bare, placeless, turned, named]
    for edited in edits:
        assert edited != own and refused(text.replace(own, edited)), edited
    (x, y) = re.findall(r'<position x="(\d+)" y="(\d+)"/>', coil)[-1]
    for line in (f'x="{x}" y="{int(y) + 20}"', f'x="{x}" y="{int(y) - 20}"', f'x="{int(x) + 1}" y="{y}"', 'x="x" y=""'):
        assert refused(text.replace(coil, coil.replace(f'x="{x}" y="{y}"', line))), line
    lines = re.findall(r'<position x="\d+" y="\d+"/>', coil)[-2:]
    assert refused(text.replace(coil, coil.replace("".join(lines), "")))
    assert refused(text.replace(coil, coil.replace("".join(lines), "".join(reversed(lines)))))


def test_what_is_drawn_by_hand_elsewhere_stays_what_it_is() -> None:
    """Rungs further apart, and a block that was moved with the line that comes from it."""
    text = drawn()
    own, coil = block(text, "EQ")
    at = re.findall(r'<position x="240" y="(\d+)"/>', own)[0]
    end = re.findall(r'<position x="(\d+)" y="(\d+)"/>', coil)[-1]
    moved = own.replace(f'x="240" y="{at}"', f'x="250" y="{int(at) + 6}"')
    line = coil.replace(f'x="{end[0]}" y="{end[1]}"', f'x="{int(end[0]) + 10}" y="{int(end[1]) + 6}"')
    assert not refused(text.replace(own, moved).replace(coil, line))
