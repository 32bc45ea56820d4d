"""SCL of Siemens S7-1200 and S7-1500: an external source for TIA Portal."""

from __future__ import annotations

from interlock.st.dialects.dialect import Dialect, one_file
from interlock.st.style import Style

STYLE = Style(
    local="#",
    quoted=True,
    attributes=("{ S7_Optimized_Access := 'TRUE' }", "VERSION : 0.1"),
    begin=True,
    timer="TON_TIME",
    timer_note="{InstructionName := 'TON_TIME'; LibVersion := '1.0'}",
    instance="DB_",
)

DIALECT = Dialect("scl1500", "Siemens S7-1200/1500, TIA Portal external source", *one_file(".scl", STYLE))
