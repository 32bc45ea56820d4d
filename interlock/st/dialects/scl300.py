"""SCL of Siemens S7-300 and S7-400: sources for STEP 7 classic, with their symbol table.

Its data blocks keep their values over a restart: among the inputs is RESTART (see `interlock.st.restart`), which OB100
and OB101 set.  Blocks are small, since a CPU 313 takes 8 KB a block.
"""

from __future__ import annotations

from interlock.st.dialects.dialect import Dialect
from interlock.st.dialects.siemens import Scl
from interlock.st.program import Runs
from interlock.st.shared import shared
from interlock.st.style import Style

LANGUAGE = Scl(Style(quoted=True, begin=True, timer='"TON"')).language()

DIALECT = Dialect(
    "scl300",
    "Siemens S7-300/400, STEP 7 classic sources",
    LANGUAGE.write,
    LANGUAGE.read_files,
    restart=True,
    runs=Runs.CYCLE,
    form=shared,
)
