"""Two readers of the text that share nothing: what the proof of text = controller refuses after a random edit, the
second checker refuses as well.  Of the codes of words, which say something and decide nothing, it does not speak.
"""

from __future__ import annotations

import random
import re
from pathlib import Path

import pytest

from interlock.checker import specification
from interlock.checker.check import agree
from interlock.checker.reading import loaded
from interlock.proof.equivalence.structured_text import compare_st
from interlock.verify import Rejected
from tests.layouts import built

NAME = re.compile(r"[A-Za-z_]\w*")
TEXT = Path("generated/fig2_2/st/iec/fig2_2.st").read_text("utf-8")
SYSTEM = Path("proofs/fig2_2/system.txt").read_text("utf-8")
LAYOUT = loaded(Path("layouts/fig2_2.yaml").read_text("utf-8"))
LINES = [re.sub(r"\(\*.*?\*\)", "", line) for line in TEXT.split("\n")]
FORMS: dict[str, list[int]] = {}
"""Lines by what stands in them but for names, so that a form that is rare is edited as often as any."""
for _i, _line in enumerate(LINES):
    if _line.strip() and _line != "FUNCTION_BLOCK IL_fig2_2":  # a main block may have another name for the checker
        FORMS.setdefault(NAME.sub("n", _line), []).append(_i)
NAMES = sorted({n for line in LINES for n in NAME.findall(line)})
EDITS = ("another name", "another name in two lines", "left out", "twice", "swapped", "moved")


def edited(kind: str, rng: random.Random) -> str:
    """The text after a random edit, without comments."""
    lines = LINES.copy()
    i = rng.choice(rng.choice(list(FORMS.values())))
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
        near = sorted({n for line in lines[max(0, i - 20) : i + 20] for n in NAME.findall(line)})
        both = [n for n in NAME.findall(lines[i]) if n in NAME.findall(lines[min(i + 1, len(lines) - 1)])]
        old = rng.choice((both if "two" in kind else []) or NAME.findall(lines[i]) or NAMES)
        kin = [n for n in near if n[:4] == old[:4] and n != old] or NAMES
        new = rng.choice(kin if rng.random() < 0.7 else NAMES)
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


@pytest.mark.parametrize("kind", EDITS)
def test_what_the_proof_refuses_the_second_checker_refuses(kind: str) -> None:
    _, _, controller = built("fig2_2")
    words = {str(w.name) for w in controller.words.words} | set(map(str, controller.words.routes.values()))
    assert accepted("\n".join(LINES))
    refused = 0
    for seed in range(60):
        text = edited(kind, random.Random(seed))
        differences = compare_st(controller, text).differences
        if not {d.name.partition(" = ")[0] for d in differences} <= words:
            refused += 1
            assert not accepted(text), differences
    assert refused > 20
