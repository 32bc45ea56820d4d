"""Texts of a layout that a spreadsheet would carry out as formulas are shown as they are written."""

from __future__ import annotations

import csv
import io
import json
import zipfile
from pathlib import Path

import pytest

from interlock.emit.tables.export import sheet_csv
from interlock.emit.tables.workbook import table_xlsx
from interlock.spreadsheet import as_text, csv_text
from interlock.table.national import national_sheets
from tests.layouts import grown

FORMULAS = ["=cmd|'/C calc'!A0", "@SUM(1+1)", "+1+1", "-2+3", "\t=1+1", "\n=1+1", " =1+1", "＝1+1", "-x", "--> none"]


@pytest.mark.parametrize("text", FORMULAS)
def test_a_label_that_a_form_prints_is_no_formula(text: str) -> None:
    layout = Path("layouts/fig2_2.yaml").read_text("utf-8").replace("profile: mine", "profile: cn")
    made = grown(layout.replace("SA 200", f"SA 200, label: {json.dumps(text)}, button: {json.dumps(text)}"))
    assert made is not None
    cells = [
        cell
        for sheet in national_sheets(made[0], made[1])
        for row in csv.reader(io.StringIO(sheet_csv(sheet).removeprefix("\ufeff"), newline=""))
        for cell in row
    ]
    assert [c for c in cells if text in c] and not [c for c in cells if c.lstrip()[:1] in tuple("=+-@＝") and c[1:]]
    with zipfile.ZipFile(io.BytesIO(table_xlsx(made[0], made[1]))) as book:
        parts = b"".join(book.read(n) for n in book.namelist())
    assert b"<f>" not in parts and b"hyperlink" not in parts


@pytest.mark.parametrize("text", FORMULAS)
def test_a_cell_that_would_be_a_formula_is_marked_as_a_text(text: str) -> None:
    assert as_text(text) == f"'{text}"
    assert list(csv.reader(io.StringIO(csv_text([[text, "b"]]), newline=""))) == [[f"'{text}", "b"]]


@pytest.mark.parametrize("cell", ["", "-", "+", "=", "-1.5", "+3", "a=1", "X1-C", "'=1", 7, -1.5, None])
def test_other_cells_are_as_they_were(cell: object) -> None:
    assert as_text(cell) is cell
