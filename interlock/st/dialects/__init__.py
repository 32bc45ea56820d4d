"""The dialects, in the order in which they are listed."""

from __future__ import annotations

from collections.abc import Sequence

from interlock.logic.controller import Controller
from interlock.st.dialects import iec, plcopen, scl300, scl1500, twincat
from interlock.st.dialects.dialect import Dialect, Files, Unsupported
from interlock.st.dialects.restart import with_restart
from interlock.st.lower import lower_st

DIALECTS: tuple[Dialect, ...] = (
    iec.DIALECT,
    plcopen.CODESYS,
    twincat.DIALECT,
    scl1500.DIALECT,
    scl300.DIALECT,
    plcopen.DIALECT,
)
BY_NAME = {d.name: d for d in DIALECTS}


def write_st(controller: Controller, dialect: Dialect, header: Sequence[str]) -> dict[str, str]:
    """The files of a controller in a dialect."""
    unit = lower_st(controller, header, dialect.rows)
    return dialect.write(with_restart(unit) if dialect.restart else unit)


__all__ = ["BY_NAME", "DIALECTS", "Dialect", "Files", "Unsupported", "write_st"]
