"""Forms on paper: title block, filters, legend, signatures, letters that can be read; the same from the same layout."""

from __future__ import annotations

import io
import zipfile
from functools import cache
from pathlib import Path

import openpyxl
import pytest

from interlock.emit.bundle import differences, digest_of
from interlock.emit.drawing import place, plan_svg
from interlock.emit.report import report_html
from interlock.emit.tables.paper import BUDGET_PT, LONGEST, points, shortened, widths
from interlock.emit.tables.workbook import table_xlsx
from interlock.model.layout import Layout
from interlock.table.rows import InterlockingTable
from tests.layouts import built, grown

BLOCK = (
    "title_block: {company: Upper & Lower Valley, author: J. Doe, number: UV-17, revision: B, date: 25 November 2026}\n"
)


@cache
def stated() -> tuple[Layout, InterlockingTable]:
    """A German collection with a title block."""
    made = grown(Path("layouts/flank_lab.yaml").read_text("utf-8") + BLOCK)
    assert made is not None
    return made[0], made[1]


def test_a_sheet_has_title_block_filter_legend_and_signatures() -> None:
    layout, table = stated()
    book = openpyxl.load_workbook(io.BytesIO(table_xlsx(layout, table)))
    assert book.sheetnames[0] == "Table" and {"de_sslz", "de_sslf", "Reasons", "Matrices"} <= set(book.sheetnames)
    page = book["de_sslz"]
    block = page["A2"].value
    for fact in ("Firma: Upper & Lower Valley", "Erstellt: J. Doe", "Revision: B", "Datum: 25 November 2026", "UV-17"):
        assert fact in block
    assert page["A3"].value.startswith("Ausgabe eines Programms, nicht zertifiziert; after Sslz of the PT1")
    heads = [c.value for c in page[4] if c.value]
    assert heads[0] == "Bezeichnung\nRoute\nA" and "Überwachte Ssp" not in " ".join(heads)  # no column is empty
    assert page.auto_filter.ref == f"A4:{openpyxl.utils.get_column_letter(len(heads))}10"
    assert page.freeze_panes == "C5" and page.print_title_rows == "$1:$4"
    below = [str(c.value) for row in page.iter_rows(min_row=11) for c in row if c.value]
    assert any(t.startswith("Spalten, von denen ein Layout nichts sagt: I F-Bedienung") for t in below)
    assert any(t.startswith("In jeder Zeile leer: ") and "Überwachte Ssp" in t for t in below)
    assert {"Geprüft", "Freigegeben", "Unterschrift"} <= set(below)
    assert "&C" in page.oddFooter.center.text or "UV-17 B" in page.oddFooter.center.text


@pytest.mark.parametrize("name", ["cn6502", "flank_lab", "junction", "mine11", "passing_loop"])
def test_every_sheet_fits_an_a3_page_with_letters_that_can_be_read(name: str) -> None:
    layout, table, _ = built(name)
    book = openpyxl.load_workbook(io.BytesIO(table_xlsx(layout, table)))
    for page in book:
        if page.title in ("Reasons", "Matrices"):
            continue
        setup = page.page_setup
        assert (int(setup.paperSize), setup.orientation) == (8, "landscape")
        assert page.sheet_properties.pageSetUpPr.fitToPage and setup.fitToWidth in (None, 1) and setup.fitToHeight == 0
        count = max((c.column for c in page[4] if c.value), default=0)
        if not count:
            assert page.title == "de_sslw" and page["A6"].value == "keine"
            continue
        columns = {(d.min, d.max): d.width for d in page.column_dimensions.values() if d.min}
        assert sum(b - a + 1 for a, b in columns) == count
        total = sum(points(w - 0.71) * (b - a + 1) for (a, b), w in columns.items())
        assert total <= BUDGET_PT * 1.02, (page.title, total, BUDGET_PT)
        assert all(
            c.value and any(r[x].value for r in page.iter_rows(min_row=5)) for x, c in enumerate(page[4][:count])
        )


def test_widths_leave_room_for_words_and_give_the_rest_to_those_that_have_most() -> None:
    narrow, wide = widths(["No.", "Hostile"], [["1", ", ".join(f"S{k}-X{k}" for k in range(300))], ["2", ""]])
    assert narrow < 8 and wide == 60
    many = widths([f"heading{k}" for k in range(40)], [["word " * 30] * 40])
    assert sum(map(points, many)) <= BUDGET_PT * 1.001


def test_a_cell_too_long_for_paper_says_what_is_missing_and_where_it_is() -> None:
    cell = ", ".join(f"S{k}-X{k}" for k in range(900))
    short = shortened(cell, "table.csv")
    shown, note = short.rsplit(", … +", 1)
    assert len(short) <= LONGEST and cell.startswith(shown + ", ")
    assert int(note.split(":")[0]) + len(shown.split(", ")) == 900 and note.endswith(": table.csv")
    assert shortened("a, b", "table.csv") == "a, b"


def test_the_digest_of_a_workbook_is_that_of_its_parts(tmp_path: Path) -> None:
    layout, table = stated()
    data = table_xlsx(layout, table)
    assert data == table_xlsx(layout, table)
    out = io.BytesIO()
    with zipfile.ZipFile(io.BytesIO(data)) as old, zipfile.ZipFile(out, "w") as stored:
        for item in old.infolist():
            stored.writestr(item.filename, old.read(item))
    assert len(data) < len(out.getvalue()) / 3
    assert digest_of("table.xlsx", data) == digest_of("table.xlsx", out.getvalue())
    (tmp_path / "table.xlsx").write_bytes(out.getvalue())
    assert differences(tmp_path, {"table.xlsx": data}) == []
    (tmp_path / "table.xlsx").write_bytes(data[: len(data) // 2])
    assert differences(tmp_path, {"table.xlsx": data}) == ["table.xlsx differs"]


def test_the_page_has_block_and_signatures_for_print_and_no_day_of_its_own() -> None:
    layout, table = stated()
    page = report_html(layout, table, plan_svg(layout, place(layout)), [], [], {}, {}, "")
    assert page.count("Upper &amp; Lower Valley") >= 8 and "25 November 2026" in page
    form = page[page.index('<section class="form" lang="de">') :]
    assert form.index('class="block paper"') < form.index("<table>") < form.index('class="paper signed"')
    assert "@page { size: A3 landscape" in page
    plain, _, _ = built("flank_lab")
    assert plain.printed.title_block is None and "Upper" not in report_html(plain, table, "", [], [], {}, {}, "")
    assert layout.bare.to_text() == plain.bare.to_text()  # nothing that is proved reads it
