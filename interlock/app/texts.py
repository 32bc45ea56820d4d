"""The texts of a controller: written, read back, and compared with it; each a piece of work of its own."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path

from interlock.app.proved import TextVerdict
from interlock.emit.c99.runtime import runtime_c
from interlock.emit.io import CROSS_REFERENCE, cross_reference_csv, tags_xlsx
from interlock.emit.python.runtime import runtime_py
from interlock.logic.cabinet import Allocation, allocate
from interlock.logic.controller import Controller
from interlock.model.elements import TelegramForm
from interlock.model.layout import Layout
from interlock.model.portable import portable
from interlock.proof.equivalence.c_text import compare_c
from interlock.proof.equivalence.cabinet import compare_delivery, compare_program
from interlock.proof.equivalence.python_text import compare_runtime
from interlock.proof.equivalence.structured_text import compare_dialect
from interlock.proof.equivalence.telegram import compare_telegram
from interlock.st.dialects import DIALECTS, Dialect, delivered, write_delivery, write_st
from interlock.st.index import HEADINGS, cross_reference
from interlock.st.printer import print_unit
from interlock.st.program import io_program
from interlock.st.structures import structured
from interlock.st.telegram import telegram_unit

C99 = "c99"
"""The C runtime among the texts that are asked for: no form of Structured Text."""

Written = tuple[TextVerdict, dict[str, bytes]]
"""A verdict and the very files that it speaks of."""


def written_for(folder: Path) -> tuple[str, ...]:
    """The dialects that were asked for when a folder of outputs was written: the portable one, whose text is always
    there, brings its cross-reference then."""
    asked = {d.name: folder / "st" / d.name for d in DIALECTS} | {"iec": folder / f"{CROSS_REFERENCE}iec.csv"}
    return tuple(n for n, place in {**asked, C99: folder / C99}.items() if place.exists())


def writers(
    layout: Layout, controller: Controller, header: list[str], dialects: Sequence[str], keep: bool = True
) -> list[Callable[[], Written]]:
    """What writes and compares each text: the portable one, other dialects that are asked for, the mapping program,
    the telegrams, the runtime, and the C runtime if it is asked for; `keep`: the files themselves are wanted too."""
    wanted = [d for d in DIALECTS if d.name == "iec" or d.name in dialects]
    out: list[Callable[[], Written]] = []
    for d in wanted:
        if d.name == "iec":
            out.append(partial(_structured_text, layout, controller, d, header, d.name in dialects))
        else:
            out.append(partial(_delivery, layout, controller, d, header))
    out.append(partial(_mapping, layout, controller, header))
    if layout.hardware.telegram is not TelegramForm.NONE and controller.symbols.machines.trailed:
        out.append(partial(_telegrams, layout, controller, header))
    out.append(partial(_runtime, controller, header))
    if C99 in dialects:
        out.append(partial(_c_runtime, controller, header))
    return out if keep else [partial(_compared, task) for task in out]


def _compared(task: Callable[[], Written]) -> Written:
    return task()[0], {}


def _structured_text(
    layout: Layout, controller: Controller, dialect: Dialect, header: list[str], referred: bool
) -> Written:
    """The portable text; with its cross-reference where it is asked for by name."""
    written = write_st(controller, dialect, header)
    found = compare_dialect(controller, dialect, written)
    folder = f"st/{dialect.name}"
    name = f"{folder}/{next(iter(written))}" if len(written) == 1 else folder
    files = {f"{folder}/{n}": text.encode() for n, text in written.items()}
    more = _cross_reference(controller, allocate(layout, controller), dialect) if referred else {}
    return TextVerdict(name, found.differences), files | more


def _delivery(layout: Layout, controller: Controller, dialect: Dialect, header: list[str]) -> Written:
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


def _with_pins(layout: Layout, header: list[str]) -> list[str]:
    return [*header, f"pins {layout.hardware.pins.digest}"] if layout.hardware.pins else header


def _mapping(layout: Layout, controller: Controller, header: list[str]) -> Written:
    allocation = allocate(layout, controller)
    header = _with_pins(layout, header)
    text, place = (
        print_unit(structured(io_program(controller, allocation, header))),
        f"st/iec/{portable(layout.name)}_io.st",
    )
    return TextVerdict(place, compare_program(controller, allocation, text)), {place: text.encode()}


def _telegrams(layout: Layout, controller: Controller, header: list[str]) -> Written:
    sent = tuple(controller.symbols.machines.trailed)  # the machines that are driven
    tagged = layout.hardware.telegram is TelegramForm.TAGGED
    text = print_unit(telegram_unit(layout.name, sent, tagged, header))
    place = f"st/iec/{portable(layout.name)}_telegram.st"
    return TextVerdict(place, compare_telegram(layout.name, sent, tagged, text)), {place: text.encode()}


def _runtime(controller: Controller, header: list[str]) -> Written:
    text = runtime_py(controller, header)
    return TextVerdict("runtime.py", compare_runtime(controller, text).differences), {"runtime.py": text.encode()}


def _c_runtime(controller: Controller, header: list[str]) -> Written:
    written = runtime_c(controller, header)
    found = compare_c(controller, written)
    files = {f"{C99}/{n}": text.encode() for n, text in written.items()}
    return TextVerdict(next(n for n in files if n.endswith(".c")), found.differences), files
