"""Two readers of the text that share nothing: what the proof of text = controller refuses after a random edit, the
second checker refuses as well.  Of the codes of words, which say something and decide nothing, it does not speak.
"""

from __future__ import annotations

import random
import re
from functools import cache
from pathlib import Path

import pytest

from interlock.checker import specification
from interlock.checker.check import agree
from interlock.checker.reading import loaded
from interlock.proof.equivalence.structured_text import compare_st
from interlock.st import shared, structures
from interlock.st.lower import lower_st
from interlock.st.printer import print_unit
from interlock.verify import Rejected
from tests.layouts import built

NAME = re.compile(r"[A-Za-z_]\w*")
SYSTEM = Path("proofs/fig2_2/system.txt").read_text("utf-8")
LAYOUT = loaded(Path("layouts/fig2_2.yaml").read_text("utf-8"))


@cache
def lines_of(members: int) -> list[str]:
    """The lines of a text without comments, with so many members in each structure, and three blocks in each group."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(structures, "MEMBERS", members)
        patch.setattr(shared, "GROUP", 3)
        text = print_unit(structures.structured(lower_st(built("fig2_2")[2], [])))
    return [re.sub(r"\(\*.*?\*\)", "", line) for line in text.split("\n")]


@cache
def forms_of(members: int) -> list[list[int]]:
    """Lines by what stands in them but for names, so that a form that is rare is edited as often as any."""
    found: dict[str, list[int]] = {}
    for i, line in enumerate(lines_of(members)):
        if line.strip() and line != "FUNCTION_BLOCK IL_fig2_2":  # a main block may have another name for the checker
            found.setdefault(NAME.sub("n", line), []).append(i)
    return list(found.values())


@cache
def names_of(members: int) -> list[str]:
    """All names in it."""
    return sorted({n for line in lines_of(members) for n in NAME.findall(line)})


EDITS = ("another name", "another name in two lines", "left out", "twice", "swapped", "moved")


def edited(members: int, kind: str, rng: random.Random) -> str:
    """The text after a random edit."""
    lines = lines_of(members).copy()
    i = rng.choice(rng.choice(forms_of(members)))
    j = min(len(lines) - 1, max(0, i + rng.randrange(-6, 7)))
    if kind == "left out":
        del lines[i]
    elif kind == "twice":
        lines.insert(i, lines[i])
    elif kind == "swapped":
        lines[i], lines[j] = lines[j], lines[i]
    elif kind == "moved":
        lines.insert(j, lines.pop(i))
    else:
        names = names_of(members)
        near = sorted({n for line in lines[max(0, i - 20) : i + 20] for n in NAME.findall(line)})
        both = [n for n in NAME.findall(lines[i]) if n in NAME.findall(lines[min(i + 1, len(lines) - 1)])]
        old = rng.choice((both if "two" in kind else []) or NAME.findall(lines[i]) or names)
        kin = [n for n in near if n[:4] == old[:4] and n != old] or names
        new = rng.choice(kin if rng.random() < 0.7 else names)
        for k in range(i, min(len(lines), i + EDITS.index(kind) + 1)):
            lines[k] = re.sub(rf"\b{old}\b", new, lines[k])
    return "\n".join(lines)


def accepted(text: str) -> bool:
    """Whether the second checker takes the text for the written system of the shipped layout."""
    try:
        agree(LAYOUT, SYSTEM, text, specification.shipped())
    except Rejected:
        return False
    return True


@pytest.mark.parametrize("members", [500, 16])
@pytest.mark.parametrize("kind", EDITS)
def test_what_the_proof_refuses_the_second_checker_refuses(kind: str, members: int) -> None:
    _, _, controller = built("fig2_2")
    words = {str(w.name) for w in controller.words.words} | set(map(str, controller.words.routes.values()))
    assert accepted("\n".join(lines_of(members)))
    refused = 0
    for seed in range(45):
        text = edited(members, kind, random.Random(seed))
        differences = compare_st(controller, text).differences
        if not {d.name.partition(" = ")[0] for d in differences} <= words:
            refused += 1
            assert not accepted(text), differences
    assert refused > 10
