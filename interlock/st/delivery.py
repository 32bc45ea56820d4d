"""What a dialect makes of a controller: its interlocking, alone or with the mapping program and what runs it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from interlock.logic.cabinet import Allocation
from interlock.logic.controller import Controller
from interlock.st.ast import Unit
from interlock.st.dialects.dialect import Dialect
from interlock.st.index import index
from interlock.st.lower import lower_st
from interlock.st.program import io_program, joined
from interlock.st.restart import with_restart


def write_st(controller: Controller, dialect: Dialect, header: Sequence[str]) -> dict[str, str]:
    """The files of a controller in a dialect."""
    return dialect.write(core(controller, dialect, header))


def write_delivery(
    controller: Controller, allocation: Allocation, dialect: Dialect, header: Sequence[str]
) -> dict[str, str]:
    """The same with the mapping program, and with what runs it."""
    return dialect.write(delivered(controller, allocation, dialect, header))


def delivered(controller: Controller, allocation: Allocation, dialect: Dialect, header: Sequence[str]) -> Unit:
    """The interlocking of a dialect with its mapping program, as a tree."""
    io = io_program(controller, allocation, header, dialect.runs, dialect.restart)
    return joined(core(controller, dialect, header), io)


def core(controller: Controller, dialect: Dialect, header: Sequence[str]) -> Unit:
    """The interlocking of a dialect as a tree of function blocks."""
    unit = lower_st(controller, header, dialect.rows)
    unit = replace(unit, index=index(controller, unit))
    return with_restart(unit) if dialect.restart else unit
