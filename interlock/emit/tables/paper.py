"""How a table is laid out on paper: A3 landscape, no letter below 7 points, columns as wide as what is in them.

Widths are in characters of the workbook's standard type (Calibri 11: 7 pixels a character and 5 beside them, 96 to the
inch).
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from math import sqrt

from interlock.model.layout import Layout

PAPER_A3 = 8
MARGIN_IN = 0.4
TYPE_PT = 9  # type in a cell, before the sheet is scaled down to the page
LEAST_PT = 7  # type on paper
_PAGE_PT = 420 / 25.4 * 72 - 2 * MARGIN_IN * 72
BUDGET_PT = _PAGE_PT * TYPE_PT / LEAST_PT  # width of all columns at which the type is just large enough
NARROWEST, WIDEST = 5.0, 60.0  # characters
LONGEST = 1200  # characters that are printed of a cell: more is no table that a person reads


def points(characters: float) -> float:
    """The width of a column in points."""
    return (characters * 7 + 5) * 0.75


def widths(headings: Sequence[str], rows: Sequence[Sequence[str]]) -> list[float]:
    """Widths of columns that fit on the page together: no narrower than their longest word, and the wider the more
    there is in them."""
    columns = list(zip(headings, *rows, strict=True))
    least = [min(WIDEST / 2, max(NARROWEST, *(1.1 * w + 1 for c in column for w in _words(c)))) for column in columns]
    wish = [min(WIDEST, max(a, *(1.1 * len(c) + 1 for c in column))) for a, column in zip(least, columns, strict=True)]
    room = (BUDGET_PT / 0.75 - 5 * len(columns)) / 7
    if sum(wish) <= room:
        return wish
    spare, load = room - sum(least), [_load(a, column) for a, column in zip(least, columns, strict=True)]
    if spare <= 0:
        return [a * room / sum(least) for a in least]
    whole = sum(load) or 1.0
    return [a + spare * x / whole for a, x in zip(least, load, strict=True)]


def _words(cell: str) -> list[int]:
    return [_size(w) for w in re.split(r"[\s、]", cell)] or [0]


def _size(word: str) -> int:
    """Characters, of which a Chinese one is as wide as two."""
    return sum(2 if ord(c) > 0x2E80 else 1 for c in word)


def _load(least: float, column: Sequence[str]) -> float:
    longest = max(map(_size, column))
    return sqrt(longest) if longest > least else 0.0


def shortened(cell: str, where: str) -> str:
    """A cell that a person can read on paper; of a longer list it says how much there is, and where all of it is."""
    if len(cell) <= LONGEST:
        return cell
    separator = "、" if "、" in cell else ", "
    items = cell.split(separator)
    kept = separator.join(items)[: LONGEST - 100].rsplit(separator, 1)[0]
    more = len(items) - len(kept.split(separator))
    return f"{kept}{separator}… +{more}: {where}"


LABELS = {
    "en": ("Station", "Company", "Drawn by", "Drawing", "Revision", "Date", "Layout"),
    "zh": ("车站", "单位", "编制", "图号", "版次", "日期", "布置图"),
    "de": ("Betriebsstelle", "Firma", "Erstellt", "Zeichnung", "Revision", "Datum", "Layout"),
}
SIGNED = {
    "en": (("Drawn", "Checked", "Approved"), ("Name", "Date", "Signature")),
    "zh": (("编制", "校核", "批准"), ("姓名", "日期", "签字")),
    "de": (("Erstellt", "Geprüft", "Freigegeben"), ("Name", "Datum", "Unterschrift")),
}
NOT_CERTIFIED = {
    "en": "Standard program output, not certified",
    "zh": "程序标准输出，未经认证",
    "de": "Ausgabe eines Programms, nicht zertifiziert",
}


def title_block(layout: Layout, digest: str, language: str) -> list[tuple[str, str]]:
    """The title block: what the layout states, and from which layout the form was made."""
    block, labels = layout.printed.title_block, LABELS[language]
    stated = ("",) * 5 if block is None else (block.company, block.author, block.number, block.revision, block.date)
    facts = (layout.printed.title or layout.name, *stated, f"{layout.name} {digest[:16]}")
    return [(label, fact) for label, fact in zip(labels, facts, strict=True) if fact]
