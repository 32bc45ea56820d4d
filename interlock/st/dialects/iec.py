"""The portable subset of IEC 61131-3 Structured Text: the reference dialect."""

from __future__ import annotations

from interlock.st.dialects.dialect import Dialect, one_file
from interlock.st.structures import structured
from interlock.st.style import IEC

DIALECT = Dialect("iec", "IEC 61131-3, any tool that reads .st", *one_file(".st", IEC), form=structured)
