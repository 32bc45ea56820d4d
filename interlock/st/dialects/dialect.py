"""What a dialect is: how the one syntax tree becomes files, and how the files are read back."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from interlock.dataclass import dataclass
from interlock.st.ast import Unit
from interlock.st.parser import parse_unit
from interlock.st.printer import print_unit
from interlock.st.program import Runs
from interlock.st.structures import plain, structured
from interlock.st.style import Style

Files = Mapping[str, str]
"""Texts by file name."""


class Unsupported(Exception):
    """The dialect cannot say something that the tree says."""


def as_it_is(unit: Unit) -> Unit:
    """No other form."""
    return unit


@dataclass(frozen=True)
class Dialect:
    """One way to write a controller for a vendor's tool.

    write: files of a unit, which may end with the mapping program; read: the unit of files, the program last.
    rows: most rows of a computing block.  restart: the tool keeps variables over a restart, so that the main block
    has an input RESTART that sets every state variable to its initial value.  runs: what runs the mapping program.
    tags: its addresses stand in a table of tags beside the text.  form: what becomes of a unit before it is written.
    """

    name: str
    title: str
    write: Callable[[Unit], dict[str, str]]
    read: Callable[[Files], Unit]
    rows: int = 400
    restart: bool = False
    runs: Runs = Runs.CONFIGURATION
    tags: bool = False
    form: Callable[[Unit], Unit] = as_it_is


def one_file(suffix: str, style: Style) -> tuple[Callable[[Unit], dict[str, str]], Callable[[Files], Unit]]:
    """A dialect that is one text file with structures, named after the last block: the interlocking, or its mapping
    program, or both."""

    def write(unit: Unit) -> dict[str, str]:
        name = unit.blocks[-1].name.removeprefix("IL_")
        return {f"{name}{suffix}": print_unit(structured(unit), style)}

    def read(files: Files) -> Unit:
        (text,) = files.values()
        return plain(parse_unit(text, style))

    return write, read
