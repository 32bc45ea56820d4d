"""SCL of Siemens S7-300 and S7-400: sources for STEP 7 classic, with their symbol table.

Its data blocks keep their values over a restart: the main block has an input RESTART (see `interlock.st.restart`),
which OB100 sets.  Blocks are small, since a CPU 313 takes 8 KB a block.
"""

from __future__ import annotations

from interlock.st.dialects.dialect import Dialect
from interlock.st.dialects.siemens import Family
from interlock.st.program import Runs
from interlock.st.style import Style

STYLE = Style(quoted=True, begin=True, timer='"TON"', instance="DB_")
FAMILY = Family(STYLE, classic=True)

DIALECT = Dialect(
    "scl300",
    "Siemens S7-300/400, STEP 7 classic sources",
    FAMILY.write,
    FAMILY.read,
    rows=150,
    restart=True,
    runs=Runs.CYCLE,
)
