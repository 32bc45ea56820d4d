"""SCL of Siemens S7-1200 and S7-1500: external sources for TIA Portal."""

from __future__ import annotations

from interlock.st.dialects.dialect import Dialect
from interlock.st.dialects.siemens import Family
from interlock.st.program import Runs
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
FAMILY = Family(STYLE, STYLE.attributes, (*STYLE.attributes, "NON_RETAIN"), "Void", '"Main"', '"Startup"')

DIALECT = Dialect(
    "scl1500",
    "Siemens S7-1200/1500, TIA Portal external sources",
    FAMILY.write,
    FAMILY.read,
    runs=Runs.CYCLE,
    tags=True,
)
