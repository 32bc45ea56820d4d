"""The texts of a controller: written, read back, and compared with it; each a piece of work of its own."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial

from interlock.app.proved import TextVerdict
from interlock.emit.python.runtime import runtime_py
from interlock.logic.cabinet import allocate
from interlock.logic.controller import Controller
from interlock.model.elements import TelegramForm
from interlock.model.layout import Layout
from interlock.proof.equivalence.cabinet import compare_program
from interlock.proof.equivalence.python_text import compare_runtime
from interlock.proof.equivalence.structured_text import compare_dialect
from interlock.proof.equivalence.telegram import compare_telegram
from interlock.st.dialects import DIALECTS, Dialect, write_st
from interlock.st.printer import print_unit
from interlock.st.program import io_program
from interlock.st.telegram import telegram_unit

Written = tuple[TextVerdict, dict[str, bytes]]
"""A verdict and the very files that it speaks of."""


def writers(
    layout: Layout, controller: Controller, header: list[str], dialects: Sequence[str], keep: bool = True
) -> list[Callable[[], Written]]:
    """What writes and compares each text: the portable one, other dialects that are asked for, the mapping program,
    the telegrams, and the runtime; `keep`: the files themselves are wanted too."""
    wanted = [d for d in DIALECTS if d.name == "iec" or d.name in dialects]
    out: list[Callable[[], Written]] = [partial(_structured_text, controller, d, header) for d in wanted]
    out.append(partial(_mapping, layout, controller, header))
    if layout.telegram is not TelegramForm.NONE and controller.symbols.trailed:
        out.append(partial(_telegrams, layout, controller, header))
    out.append(partial(_runtime, controller, header))
    return out if keep else [partial(_compared, task) for task in out]


def _compared(task: Callable[[], Written]) -> Written:
    return task()[0], {}


def _structured_text(controller: Controller, dialect: Dialect, header: list[str]) -> Written:
    written = write_st(controller, dialect, header)
    found = compare_dialect(controller, dialect, written)
    folder = f"st/{dialect.name}"
    name = f"{folder}/{next(iter(written))}" if len(written) == 1 else folder
    return TextVerdict(name, found.differences), {f"{folder}/{n}": text.encode() for n, text in written.items()}


def _mapping(layout: Layout, controller: Controller, header: list[str]) -> Written:
    allocation = allocate(layout, controller)
    header = [*header, f"pins {layout.pins.digest}"] if layout.pins else header
    text, place = print_unit(io_program(controller, allocation, header)), f"st/iec/{layout.name}_io.st"
    return TextVerdict(place, compare_program(controller, allocation, text)), {place: text.encode()}


def _telegrams(layout: Layout, controller: Controller, header: list[str]) -> Written:
    sent = tuple(controller.symbols.trailed)  # the machines that are driven
    tagged = layout.telegram is TelegramForm.TAGGED
    text, place = print_unit(telegram_unit(layout.name, sent, tagged, header)), f"st/iec/{layout.name}_telegram.st"
    return TextVerdict(place, compare_telegram(layout.name, sent, tagged, text)), {place: text.encode()}


def _runtime(controller: Controller, header: list[str]) -> Written:
    text = runtime_py(controller, header)
    return TextVerdict("runtime.py", compare_runtime(controller, text).differences), {"runtime.py": text.encode()}
