"""Writing a text of a controller, reading it back, and comparing it with the controller."""

from __future__ import annotations

from collections.abc import Sequence
from os.path import exists  # which is false where nobody may look, too
from pathlib import Path

from interlock.app.proved import TextVerdict
from interlock.app.texts import C99, MAPPING, RUNTIME, TELEGRAMS, Text, Written
from interlock.emit.io import CROSS_REFERENCE, cross_reference_csv, tags_xlsx
from interlock.emit.python.runtime import runtime_py
from interlock.logic.cabinet import Allocation, allocate
from interlock.logic.controller import Controller
from interlock.model.elements import TelegramForm
from interlock.model.layout import Layout
from interlock.model.portable import portable
from interlock.proof.equivalence.cabinet import compare_delivery, compare_program
from interlock.proof.equivalence.python_text import compare_runtime
from interlock.proof.equivalence.structured_text import compare_dialect
from interlock.st.delivery import delivered, write_delivery, write_st
from interlock.st.dialects import BY_NAME
from interlock.st.dialects.dialect import Dialect
from interlock.st.index import HEADINGS, cross_reference
from interlock.st.printer import print_unit
from interlock.st.program import io_program
from interlock.st.structures import structured


def written_for(folder: Path) -> tuple[str, ...]:
    """The dialects that were asked for when a folder of outputs was written: the portable one, whose text is always
    there, brings its cross-reference then."""
    asked = {n: folder / "st" / n for n in BY_NAME} | {"iec": folder / f"{CROSS_REFERENCE}iec.csv"}
    return tuple(n for n, place in {**asked, C99: folder / C99}.items() if exists(place))


def write(text: Text) -> Written:
    """Write and compare a text."""
    layout, controller, header = text.layout, text.controller, text.header
    if text.name == MAPPING:
        return _mapping(layout, controller, header)
    if text.name == TELEGRAMS:
        return _telegrams(layout, controller, header)
    if text.name == RUNTIME:
        return _runtime(controller, header)
    if text.name == C99:
        return _c_runtime(controller, header)
    if text.name == "iec":
        return _structured_text(layout, controller, BY_NAME["iec"], header, text.referred)
    return _delivery(layout, controller, BY_NAME[text.name], header)


def _structured_text(
    layout: Layout, controller: Controller, dialect: Dialect, header: Sequence[str], referred: bool
) -> Written:
    """The portable text; with its cross-reference where it is asked for by name."""
    written = write_st(controller, dialect, header)
    found = compare_dialect(controller, dialect, written)
    folder = f"st/{dialect.name}"
    name = f"{folder}/{next(iter(written))}" if len(written) == 1 else folder
    files = {f"{folder}/{n}": text.encode() for n, text in written.items()}
    more = _cross_reference(controller, allocate(layout, controller), dialect) if referred else {}
    return TextVerdict(name, found.differences), files | more


def _delivery(layout: Layout, controller: Controller, dialect: Dialect, header: Sequence[str]) -> Written:
    """The interlocking in a vendor's form with its mapping program, and the table of tags that this reads."""
    folder, allocation = f"st/{dialect.name}", allocate(layout, controller)
    header = _with_pins(layout, header)
    texts = write_delivery(controller, allocation, dialect, header)
    files = {f"{folder}/{n}": text.encode() for n, text in texts.items()}
    book = tags_xlsx(layout, allocation) if dialect.tags else None
    if book is not None:
        files[f"{folder}/{portable(layout.name)}_tags.xlsx"] = book
    found = compare_delivery(controller, allocation, dialect, texts, book)
    place = next(iter(files)) if len(files) == 1 else folder
    return TextVerdict(place, found), files | _cross_reference(controller, allocation, dialect)


def _cross_reference(controller: Controller, allocation: Allocation, dialect: Dialect) -> dict[str, bytes]:
    """Where each variable is written and read, block by block as the dialect has them."""
    unit = dialect.form(delivered(controller, allocation, dialect, ()))
    rows = cross_reference(controller, allocation, unit)
    return {f"{CROSS_REFERENCE}{dialect.name}.csv": cross_reference_csv(HEADINGS, rows).encode()}


def _with_pins(layout: Layout, header: Sequence[str]) -> Sequence[str]:
    return [*header, f"pins {layout.hardware.pins.digest}"] if layout.hardware.pins else header


def _mapping(layout: Layout, controller: Controller, header: Sequence[str]) -> Written:
    allocation = allocate(layout, controller)
    header = _with_pins(layout, header)
    text, place = (
        print_unit(structured(io_program(controller, allocation, header))),
        f"st/iec/{portable(layout.name)}_io.st",
    )
    return TextVerdict(place, compare_program(controller, allocation, text)), {place: text.encode()}


def _telegrams(layout: Layout, controller: Controller, header: Sequence[str]) -> Written:
    from interlock.proof.equivalence.telegram import compare_telegram
    from interlock.st.telegram import telegram_unit

    sent = tuple(controller.symbols.machines.trailed)  # the machines that are driven
    tagged = layout.hardware.telegram is TelegramForm.TAGGED
    text = print_unit(telegram_unit(layout.name, sent, tagged, header))
    place = f"st/iec/{portable(layout.name)}_telegram.st"
    return TextVerdict(place, compare_telegram(layout.name, sent, tagged, text)), {place: text.encode()}


def _runtime(controller: Controller, header: Sequence[str]) -> Written:
    text = runtime_py(controller, header)
    return TextVerdict("runtime.py", compare_runtime(controller, text).differences), {"runtime.py": text.encode()}


def _c_runtime(controller: Controller, header: Sequence[str]) -> Written:
    from interlock.emit.c99.runtime import runtime_c
    from interlock.proof.equivalence.c_text import compare_c

    written = runtime_c(controller, header)
    found = compare_c(controller, written)
    files = {f"{C99}/{n}": text.encode() for n, text in written.items()}
    return TextVerdict(next(n for n in files if n.endswith(".c")), found.differences), files
