"""PLCopen XML (TC6) 2.00, as CODESYS itself writes it."""

from __future__ import annotations

from interlock.st.dialects.dialect import Dialect
from interlock.st.dialects.plcopen import PlcOpen
from interlock.st.structures import structured

_TC6_200 = PlcOpen("0200", True)

DIALECT = Dialect(
    "codesys", "CODESYS V3 and TwinCAT, PLCopen XML TC6 2.00", _TC6_200.write, _TC6_200.read, form=structured
)
