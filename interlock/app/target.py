"""Whether what is written may fit into the controller for which it is meant: an estimate with its rule."""

from __future__ import annotations

from interlock.diag import Diagnostic, Severity
from interlock.frontend import Source
from interlock.logic.cabinet import allocate
from interlock.logic.controller import Controller
from interlock.model.layout import Layout
from interlock.model.target import Target
from interlock.st.delivery import delivered
from interlock.st.dialects import BY_NAME
from interlock.st.sizes import CAVEAT, RULE, SOURCE, TIA_RULE, TIA_SOURCE, Size, size_of

DIALECT, TIA_DIALECT = "scl300", "scl1500"
"""The texts whose size is estimated: the rules are for their controllers."""


def estimated(layout: Layout, controller: Controller, tia: bool = False) -> Size:
    """What the text for an S7-300, or for an S7-1500 (`tia`), takes, the mapping program included."""
    dialect = BY_NAME[TIA_DIALECT if tia else DIALECT]
    return size_of(dialect.form(delivered(controller, allocate(layout, controller), dialect, ())), tia)


def too_large(size: Size, target: Target) -> list[str]:
    """What of a target does not suffice, in words; empty if all does."""
    found = []
    name, most = size.largest
    if target.blocks is not None and len(size.code) > target.blocks:
        found.append(f"{len(size.code)} blocks of {target.blocks}")
    if target.block_bytes is not None and most > target.block_bytes:
        found.append(f"{name} of {most} bytes, where {target.block_bytes} are allowed")
    apart = target.data_bytes is not None
    code, data = sum(size.code.values()), sum(size.data.values())
    if target.memory_bytes is not None and (code if apart else size.memory) > target.memory_bytes:
        what = f"{code} bytes of code" if apart else f"{size.memory} bytes of memory"
        found.append(f"{what} of {target.memory_bytes}")
    if target.data_bytes is not None and data > target.data_bytes:
        found.append(f"{data} bytes of data of {target.data_bytes}")
    return found


def target_notes(layout: Layout, controller: Controller, source: Source) -> tuple[Diagnostic, ...]:
    """The estimate for the layout's target as a diagnostic; none without a target."""
    target = layout.hardware.target
    if target is None:
        return ()
    size = estimated(layout, controller, target.tia)
    wrong = too_large(size, target)
    name, most = size.largest
    told = (
        f"{TIA_DIALECT if target.tia else DIALECT}: {len(size.code)} blocks, the largest {name} with {most} bytes, "
        f"{size.memory} bytes of memory; {CAVEAT}"
    )
    rule, whence = (TIA_RULE, TIA_SOURCE) if target.tia else (RULE, SOURCE)
    span = source.at("target")
    fix = f"the rule: {rule} ({whence}); the limits: {target.source}"
    if wrong:
        message = f"{target.name} may not hold it: {'; '.join(wrong)}; {told}"
        return (Diagnostic("IL5009", Severity.WARNING, message, span, fix),)
    return (Diagnostic("IL5010", Severity.INFO, f"fits into {target.name} by estimate; {told}", span, fix),)
