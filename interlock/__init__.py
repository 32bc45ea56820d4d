"""interlock: a formally checked interlocking table generator.

    layout = interlock.load("layouts/mine11.yaml")
    table = interlock.derive(layout)
    controller = interlock.lower(layout, table)
    proof = interlock.prove(layout, controller)

The names are those of `interlock.app.library`, which is loaded when one of them is first asked for: the command line
does without it.  `docs/library.md` tells what they do.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from interlock.app.library import (
        Checked,
        ClaimResult,
        Compiled,
        Controller,
        Diagnostic,
        InterlockingTable,
        Layout,
        LayoutError,
        NotProved,
        ProofResult,
        Severity,
        Verdict,
        Witness,
        check,
        compile,
        derive,
        load,
        loads,
        lower,
        prove,
    )

__version__ = "0.1.0"

__all__ = [
    "Checked",
    "ClaimResult",
    "Compiled",
    "Controller",
    "Diagnostic",
    "InterlockingTable",
    "Layout",
    "LayoutError",
    "NotProved",
    "ProofResult",
    "Severity",
    "Verdict",
    "Witness",
    "__version__",
    "check",
    "compile",
    "derive",
    "load",
    "loads",
    "lower",
    "prove",
]


def __getattr__(name: str) -> Any:
    if name not in __all__:
        raise AttributeError(f"module 'interlock' has no attribute {name!r}")
    from importlib import import_module

    return getattr(import_module("interlock.app.library"), name)


def __dir__() -> list[str]:
    return __all__
