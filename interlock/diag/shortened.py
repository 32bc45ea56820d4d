"""What a message quotes, in a length that a person reads: a name of a hundred thousand signs is no message."""

from __future__ import annotations

import re

LONGEST = 200
"""Signs of a word, or of what stands in quotation marks, that are shown whole: paths of files are such words."""
ENDS = 60
"""Signs at its either end that are shown of a longer one."""
WHOLE = 6000
"""Signs of a message that are shown, whatever stands in it."""

_QUOTED = re.compile(rf"(?<!\w)(['`\"])((?:(?!\1).){{{LONGEST + 1},}})\1", re.DOTALL)
_WORD = re.compile(rf"\S{{{LONGEST + 1},}}")


def shortened(text: str) -> str:
    """A message as it is shown; how many signs there are, is said where some are left out."""
    if len(text) <= LONGEST:
        return text
    text = _WORD.sub(lambda m: _ends(m[0]), text)
    if len(text) <= WHOLE:
        return text
    text = _QUOTED.sub(lambda m: f"{m[1]}{_ends(m[2])}{m[1]}", text)
    return text if len(text) <= WHOLE else _ends(text, 10 * ENDS)


def _ends(text: str, signs: int = ENDS) -> str:
    return f"{text[:signs]}…{text[-signs:]} ({len(text)} signs)"
