"""What a table of tags for TIA Portal says, read from the workbook itself by Python's standard library.

A workbook is an archive of files that name each other, and a spreadsheet follows these names: so whatever could lead it
to another sheet, text or cell than is read here is refused.

**Theorem.**  Each part of the archive that is followed has one name, one place and one reading, and whatever else could
be followed is refused: so a spreadsheet that keeps to the format shows the names and addresses that are read here.
(Determinism of the reading; format: ECMA-376.)
"""

from __future__ import annotations

import io
import re
import xml.etree.ElementTree as ElementTree
import zipfile
from itertools import pairwise

_MAIN = "{http://schemas.openxmlformats.org/spreadsheetml/2006/main}"
_OFFICE = "http://schemas.openxmlformats.org/officeDocument/2006/relationships"
_BOOK, _SHEET, _STRINGS = "xl/workbook.xml", "worksheets/sheet1.xml", "sharedStrings.xml"


class BadTags(Exception):
    """The workbook is not a table of tags as it is written."""


def read_tags(data: bytes, before: str) -> dict[str, str]:
    """The addresses by variable, as IEC writes them, of bits of inputs and outputs; `before` stands before the name of
    each.  Raises `BadTags`."""
    try:
        with zipfile.ZipFile(io.BytesIO(data)) as book:
            _check_parts(book)
            strings = [_text(si) for si in _parsed(book, f"xl/{_STRINGS}")]
            sheet = _parsed(book, f"xl/{_SHEET}")
    except (zipfile.BadZipFile, KeyError, ElementTree.ParseError, UnicodeDecodeError) as error:
        raise BadTags(str(error)) from None
    rows = [_cells(row, number, strings) for number, row in enumerate(sheet.iter(f"{_MAIN}row"), 1)]
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


def _check_parts(book: zipfile.ZipFile) -> None:
    """One workbook with one sheet of its name, and the files from which these are read are those that they name."""
    names = sorted(n.casefold() for n in book.namelist())
    if any(a == b for a, b in pairwise(names)):
        raise BadTags("a part of the workbook is there twice")
    sheets = list(_parsed(book, _BOOK).iter(f"{_MAIN}sheet"))
    if [s.get("name") for s in sheets] != ["PLC Tags"]:
        raise BadTags("not the one sheet PLC Tags")
    links = _links(book, "xl/_rels/workbook.xml.rels")
    shown = sheets[0].get(f"{{{_OFFICE}}}id", "")
    held = {kind: [x for x, (k, _) in links.items() if k == kind] for kind in ("worksheet", "sharedStrings")}
    if held["worksheet"] != [shown] or links[shown][1] != _SHEET:
        raise BadTags("the sheet that is shown is another")
    if [links[x][1] for x in held["sharedStrings"]] != [_STRINGS]:
        raise BadTags("the texts are those of another file")
    if [x for k, x in _links(book, "_rels/.rels").values() if k == "officeDocument"] != [_BOOK]:
        raise BadTags("the workbook is another")


def _links(book: zipfile.ZipFile, name: str) -> dict[str, tuple[str, str]]:
    """The kind and the target of each relationship, by its name."""
    found: dict[str, tuple[str, str]] = {}
    for x in _parsed(book, name):
        if set(x.attrib) != {"Id", "Type", "Target"} or x.attrib["Id"] in found:
            raise BadTags(f"a relationship in {name} that is not understood")
        found[x.attrib["Id"]] = x.attrib["Type"].rpartition("/")[2], x.attrib["Target"]
    return found


def _parsed(book: zipfile.ZipFile, name: str) -> ElementTree.Element:
    text = book.read(name).decode()
    if "<!" in text or not text.startswith('<?xml version="1.0" encoding="UTF-8"'):
        raise BadTags(f"{name} is of another encoding, or has a document type")
    return ElementTree.fromstring(text.encode())


def _text(si: ElementTree.Element) -> str:
    """A text that is one piece, and no other is read aloud."""
    if [x.tag for x in si] != [f"{_MAIN}t"] or len(si[0]):
        raise BadTags("a text in pieces")
    return si[0].text or ""


def _cells(row: ElementTree.Element, number: int, strings: list[str]) -> dict[str, str]:
    """The texts of a row by column."""
    found: dict[str, str] = {}
    for cell in row:
        place = re.fullmatch(rf"([A-Z]+){number}", cell.get("r", ""))
        plain = cell.tag == f"{_MAIN}c" and [x.tag for x in cell] == [f"{_MAIN}v"] and cell.get("t") == "s"
        if place is None or not plain or place[1] in found:
            raise BadTags(f"row {number} has a cell twice, one that computes, or one of another row")
        value = cell.findtext(f"{_MAIN}v", "")
        if not re.fullmatch("[0-9]+", value) or int(value) >= len(strings):
            raise BadTags("a cell without its text")
        found[place[1]] = strings[int(value)]
    if row.get("r") != str(number):
        raise BadTags(f"row {number} is called {row.get('r')}")
    return found
