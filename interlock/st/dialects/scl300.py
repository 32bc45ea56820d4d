"""SCL of Siemens S7-300 and S7-400: a source for STEP 7 classic.

Its data blocks keep their values over a restart: the main block has an input RESTART (see `restart`).  Blocks are
small, since a CPU 313 takes 8 KB a block.
"""

from __future__ import annotations

from interlock.st.dialects.dialect import Dialect, one_file
from interlock.st.style import Style

STYLE = Style(quoted=True, begin=True, timer='"TON"', instance="DB_")

DIALECT = Dialect(
    "scl300", "Siemens S7-300/400, STEP 7 classic source", *one_file(".scl", STYLE), rows=150, restart=True
)
