"""Signs of East Asian keyboards, and spaces that are none to YAML: what its author means by them.

To YAML and to the language they are letters of a text, so that a whole list becomes one name.
"""

from __future__ import annotations

import re

WIDE = dict(zip("：，、；｛｝［］（）【】＂＇“”‘’　", ":,,;{}[](){}\"'\"\"'' ", strict=True))
"""Full-width signs, and the ASCII one that each looks like or stands for."""
DIRECTIONS = "\u202a\u202b\u202c\u202d\u202e\u2066\u2067\u2068\u2069"
"""What turns the direction of the text after it, so that a line is shown otherwise than it is read."""
OPENING, CLOSING = "([{（［｛【", ")]}）］｝】"
_ODD = "\u00a0\u1680\u2000-\u200a\u202f\u205f\u3000"
_INDENTED = re.compile(rf" *([{_ODD}][{_ODD} ]*)(?=-\s|[^\s:]+:(?:\s|[\[{{]|$))")
_DIVIDES = re.compile(r"\s*[，、；;]\s*")
_BETWEEN = re.compile(r"\s*[，、；。]\s*")


def odd_indent(line: str) -> tuple[int, int, str] | None:
    """Of a line of a list or mapping whose indentation has spaces in it that are none to YAML: where they begin, from
    0, how many signs they are, and of what kind the first is."""
    found = _INDENTED.match(line)
    if found is None:
        return None
    kind = {"\u3000": "full-width", "\u00a0": "no-break"}.get(found[1][0], "special")
    return found.start(1), len(found[1]), kind


def spelled(text: str) -> str:
    """What stands between brackets, with the commas and colons of YAML and without the brackets."""
    bare = text.strip()
    if bare[:1] in OPENING and bare[:1] and bare[-1:] in CLOSING:
        bare = bare[1:-1].strip()
    return re.sub(r"\s*：\s*", ": ", _DIVIDES.sub(", ", bare))


def parted(text: str) -> tuple[str, ...]:
    """The names that full-width signs divide; empty where none does."""
    parts = _BETWEEN.split(text.strip())
    return tuple(parts) if len(parts) > 1 and all(parts) else ()
