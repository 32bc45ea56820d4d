"""The dialects, in the order in which they are listed."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from interlock.logic.cabinet import Allocation
from interlock.logic.controller import Controller
from interlock.st.ast import Unit
from interlock.st.dialects import awl, iec, ladder, plcopen, scl300, scl1500, twincat
from interlock.st.dialects.dialect import Dialect, Files, Unsupported
from interlock.st.index import index
from interlock.st.lower import lower_st
from interlock.st.program import io_program, joined
from interlock.st.restart import with_restart

DIALECTS: tuple[Dialect, ...] = (
    iec.DIALECT,
    plcopen.CODESYS,
    twincat.DIALECT,
    scl1500.DIALECT,
    scl300.DIALECT,
    awl.DIALECT,
    plcopen.DIALECT,
    ladder.DIALECT,
)
BY_NAME = {d.name: d for d in DIALECTS}


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


__all__ = ["BY_NAME", "DIALECTS", "Dialect", "Files", "Unsupported", "core", "delivered", "write_delivery", "write_st"]
