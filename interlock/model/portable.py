"""How a layout's names are written in PLC text.

Identifiers of IEC 61131-3 have ASCII letters, digits and single underscores, and the oldest tools take few characters:
a name that is not of that kind is written by what can be read of it, and a check that tells it from all others.  It
depends on the name alone, so that no other element changes it.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterable
from functools import lru_cache
from hashlib import sha256

TAKEN = frozenset({"TRIG", "EDGE"})
"""What no name is written as, in any case: with the F_ of a section it is a word of IEC 61131-3."""
OWN_ENDING = re.compile(
    r"_(?:I|Q|D\d*|IO|HMI|WATCH|CYCLE|H\d+|IN\d+|OUT\d+|[GBTWSY]\d{2,}|TASK|CONF|RES|MAIN|SEND|RECV|TRY)$",
    re.IGNORECASE,
)
"""With what the blocks of a layout end whose own names begin with its: `IL_north_Q` is one of `north`."""
LONGEST = 14  # characters: a name of this length with what stands around it is an identifier in every dialect
_CHECK = 4
_SIGNS = "abcdefghijkmnpqrstuvwxyz23456789"  # 32, none like another


SPACE = "\u2423"
"""Stands for a space of a layout's name where the name is to be one word; no layout name has it."""


def joined(name: str) -> str:
    """A layout's name in one word, and otherwise as it is."""
    return name.replace(" ", SPACE)


def beside(names: Iterable[str]) -> str:
    """Names beside each other in a cell: divided by spaces, and by commas where one of them has a space itself."""
    those = tuple(names)
    return (", " if any(" " in n for n in those) else " ").join(those)


def portable(name: str) -> str:
    """The name with `-`, `/` and spaces as `_`, if short, ASCII and not taken; else what can be read, and a check.

    `22ｲT` is written `22IT_` with four signs of its digest.  Names that become equal are reported by the front end.
    """
    plain = name.replace("-", "_").replace("/", "_").replace(" ", "_")
    if len(plain) <= LONGEST and plain.isascii() and "#" not in plain and plain.upper() not in TAKEN:
        return plain
    return _shortened(name, plain)


@lru_cache(maxsize=1024)
def _shortened(name: str, plain: str) -> str:
    """What can be read of a name, and a check of it."""
    read = "".join(map(readable, unicodedata.normalize("NFKD", plain)))
    letters = "".join(x for x in read if x.isalnum() or x == "_")  # (1) in one sign leaves brackets
    near = letters[: LONGEST - _CHECK - 1].strip("_")
    number = int.from_bytes(sha256(name.encode()).digest()[:3], "big")
    return f"{near}_{''.join(_SIGNS[number >> 5 * k & 31] for k in range(_CHECK))}"


def readable(sign: str) -> str:
    """A character in ASCII: as it is, by the end of its Unicode name, which never changes, or by its number.

    A sign that is no letter or digit is `?`.
    """
    if sign.isascii():
        return sign if sign.isprintable() else "?"
    if unicodedata.combining(sign):
        return ""
    base = unicodedata.normalize("NFKD", sign)
    if base != sign:
        return "".join(map(readable, base))
    if not sign.isalnum():
        return "?"
    called = unicodedata.name(sign, "")
    letter = called.rpartition(" LETTER ")[2].rpartition(" ")[2] if " LETTER " in called else ""
    if letter.isalpha() and letter.isascii():
        return letter.lower() if " SMALL LETTER " in called else letter
    return f"{ord(sign):X}"
