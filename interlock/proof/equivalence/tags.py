"""What a table of tags for TIA Portal says, read from the workbook itself by Python's standard library."""

from __future__ import annotations

import io
import re
import xml.etree.ElementTree as ElementTree
import zipfile

_MAIN = "{http://schemas.openxmlformats.org/spreadsheetml/2006/main}"


class BadTags(Exception):
    """The workbook is not a table of tags as it is written."""


def read_tags(data: bytes, before: str) -> dict[str, str]:
    """The addresses by variable, as IEC writes them, of bits of inputs and outputs; `before` stands before the name of
    each.  Raises `BadTags`."""
    try:
        with zipfile.ZipFile(io.BytesIO(data)) as book:
            strings = ["".join(t.itertext()) for t in _parsed(book, "xl/sharedStrings.xml").iter(f"{_MAIN}si")]
            sheet = _parsed(book, "xl/worksheets/sheet1.xml")
            names = [s.get("name") for s in _parsed(book, "xl/workbook.xml").iter(f"{_MAIN}sheet")]
    except (zipfile.BadZipFile, KeyError, ElementTree.ParseError) as error:
        raise BadTags(str(error)) from None
    if names[:1] != ["PLC Tags"]:
        raise BadTags("the first sheet is not PLC Tags")
    rows = [_cells(row, strings) for row in sheet.iter(f"{_MAIN}row")]
    if not rows or [rows[0].get(c) for c in "ABCD"] != ["Name", "Path", "Data Type", "Logical Address"]:
        raise BadTags("other columns than a table of tags has")
    found: dict[str, str] = {}
    for row in rows[1:]:
        place = re.fullmatch(r"%([IQ])([0-9]+\.[0-7])", row.get("D", ""))
        if place is None or row.get("C") != "Bool" or not (name := row.get("A", "")).startswith(before):
            raise BadTags(f"{row.get('A')}: no bit of an input or output of this station")
        variable = name.removeprefix(before)
        if variable in ("", *found):
            raise BadTags(f"{name} is there twice")
        found[variable] = f"%{place[1]}X{place[2]}"
    return found


def _parsed(book: zipfile.ZipFile, name: str) -> ElementTree.Element:
    return ElementTree.fromstring(book.read(name))


def _cells(row: ElementTree.Element, strings: list[str]) -> dict[str, str]:
    """The texts of a row by column."""
    found = {}
    for cell in row.iter(f"{_MAIN}c"):
        value = cell.findtext(f"{_MAIN}v", "")
        column = re.sub(r"[0-9]", "", cell.get("r", ""))
        if cell.get("t") == "s":
            if not value.isdigit() or int(value) >= len(strings):
                raise BadTags("a cell without its text")
            value = strings[int(value)]
        found[column] = value
    return found
