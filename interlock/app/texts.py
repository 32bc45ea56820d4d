"""Which texts a controller is written as; what writes and compares one, `writing.py`, is loaded where that is done."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial

from interlock.app.proved import TextVerdict
from interlock.dataclass import dataclass
from interlock.logic.controller import Controller
from interlock.model.elements import TelegramForm
from interlock.model.layout import Layout
from interlock.st.dialects import BY_NAME

MAPPING, TELEGRAMS, RUNTIME = "mapping", "telegrams", "runtime"
"""Texts that are no dialect's."""
C99 = "c99"
"""The C runtime among the texts that are asked for: no form of Structured Text."""

Written = tuple[TextVerdict, dict[str, bytes]]
"""A verdict and the very files that it speaks of."""


@dataclass(frozen=True)
class Text:
    """A text that is wanted: its name, which is a dialect's or one of the above; `header`: the comments at its head;
    `referred`: it is asked for by name, and with it the cross-reference of its dialect."""

    name: str
    layout: Layout
    controller: Controller
    header: Sequence[str]
    referred: bool


def writers(
    layout: Layout, controller: Controller, header: Sequence[str], dialects: Sequence[str], keep: bool = True
) -> list[Callable[[], Written]]:
    """What writes and compares each text: the portable one, other dialects that are asked for, the mapping program,
    the telegrams, the runtime, and the C runtime if it is asked for; `keep`: the files themselves are wanted too."""
    names = [n for n in BY_NAME if n == "iec" or n in dialects]
    names.append(MAPPING)
    if layout.hardware.telegram is not TelegramForm.NONE and controller.symbols.machines.trailed:
        names.append(TELEGRAMS)
    names.append(RUNTIME)
    if C99 in dialects:
        names.append(C99)
    return [partial(_written, Text(n, layout, controller, header, n in dialects), keep) for n in names]


def _written(text: Text, keep: bool) -> Written:
    from interlock.app.writing import write  # a process that only proves does without

    verdict, files = write(text)
    return verdict, files if keep else {}
