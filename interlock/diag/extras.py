"""How an extra is installed: by the very Python that runs.

The pip that a shell finds may be that of another Python, which has no interlock and would look for some program of that
name elsewhere.
"""

from __future__ import annotations

import shlex
import sys


def install(extra: str) -> str:
    """The command that installs an extra beside what is installed."""
    return f"{shlex.quote(sys.executable or 'python3')} -m pip install 'interlock[{extra}]'"
