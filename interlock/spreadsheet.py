"""CSV that a spreadsheet shows as it is written.

Spreadsheets carry a cell out that begins as a formula, and free texts come from files that others have sent: such a
cell gets an apostrophe before it, which is how a spreadsheet marks a text.
"""

from __future__ import annotations

import csv
import io
import re
from collections.abc import Iterable

_FORMULA = re.compile(r"\s*[=+\-@\uff0b\uff0d\uff1d\uff20].*\S", re.DOTALL)
"""How a formula begins, with full-width signs, too; a sign alone is none."""
_NUMBER = re.compile(r"[+-]?\d+(\.\d+)?")


def as_text(cell: object) -> object:
    """A cell that no spreadsheet takes for a formula."""
    formula = isinstance(cell, str) and _FORMULA.fullmatch(cell) and not _NUMBER.fullmatch(cell)
    return f"'{cell}" if formula else cell


def csv_text(rows: Iterable[Iterable[object]]) -> str:
    """Rows as CSV: commas, and a line feed at the end of each row."""
    out = io.StringIO()
    csv.writer(out, lineterminator="\n").writerows(map(as_text, row) for row in rows)
    return out.getvalue()
