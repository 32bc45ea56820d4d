"""SCL of Siemens S7-1200 and S7-1500: external sources for TIA Portal, with their table of tags.

Its data blocks forget their values over a restart, as they are declared; `#` marks the variables of a block itself.
"""

from __future__ import annotations

from dataclasses import replace
from functools import partial

from interlock.st.dialects.dialect import Dialect
from interlock.st.dialects.siemens import Scl
from interlock.st.program import Runs
from interlock.st.shared import shared
from interlock.st.style import Style

STYLE = Style(
    local="#",
    quoted=True,
    begin=True,
    timer="TON_TIME",
    timer_note="{InstructionName := 'TON_TIME'; LibVersion := '1.0'}",
)
ATTRIBUTES = ("{ S7_Optimized_Access := 'TRUE' }", "VERSION : 0.1")
_SCL = Scl(STYLE, "Void", ATTRIBUTES, (*ATTRIBUTES, "NON_RETAIN"), False, '"Main"', ())
LANGUAGE = replace(_SCL.language(), tags=True)

DIALECT = Dialect(
    "scl1500",
    "Siemens S7-1200/1500, TIA Portal external sources",
    LANGUAGE.write,
    LANGUAGE.read_files,
    runs=Runs.CYCLE,
    tags=True,
    form=partial(shared, several=True),
)
