"""How a dialect writes the one syntax tree; the printer and the reader follow the same style."""

from __future__ import annotations

from interlock.dataclass import dataclass

SPACE = r"[\x20\t\r\n]+"
"""What every tool takes for space, and nothing else: no form feed, no space of Unicode."""
COMMENT = r"\(\*(?![\x20\t\r\n]*[@$\x23~{%&])[^*(]*(?:(?:\*(?!\))|\((?!\*))[^*(]*)*\*\)"
"""A comment that every tool takes for one and none obeys (`printer.DIRECTIVES`); none begins in another, since some
nest them."""


@dataclass(frozen=True)
class Style:
    """Flags of a text dialect.

    local: mark before a variable inside a body (`#` in SCL).
    quoted: names of blocks stand in double quotes.
    begin: BEGIN stands before the body.
    timer: the type of an on-delay timer; timer_note: what stands between its name and the colon.
    """

    local: str = ""
    quoted: bool = False
    begin: bool = False
    timer: str = "TON"
    timer_note: str = ""

    def block(self, name: str) -> str:
        """The name of a block as it is written."""
        return f'"{name}"' if self.quoted else name


IEC = Style()
