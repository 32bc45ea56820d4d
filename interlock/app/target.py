"""Whether what is written may fit into the controller for which it is meant: an estimate with its rule."""

from __future__ import annotations

from interlock.diag import Diagnostic, Severity
from interlock.frontend import Source
from interlock.logic.cabinet import allocate
from interlock.logic.controller import Controller
from interlock.model.layout import Layout
from interlock.model.target import Target
from interlock.st.dialects import BY_NAME, delivered
from interlock.st.sizes import CAVEAT, RULE, SOURCE, Size, size_of

DIALECT = "scl300"
"""The text whose size is estimated: the rule is one for its controllers."""


def estimated(layout: Layout, controller: Controller) -> Size:
    """What the text for an S7-300 takes, the mapping program included."""
    dialect = BY_NAME[DIALECT]
    return size_of(dialect.form(delivered(controller, allocate(layout, controller), dialect, ())))


def too_large(size: Size, target: Target) -> list[str]:
    """What of a target does not suffice, in words; empty if all does."""
    found = []
    name, most = size.largest
    if target.blocks is not None and len(size.code) > target.blocks:
        found.append(f"{len(size.code)} blocks of {target.blocks}")
    if target.block_bytes is not None and most > target.block_bytes:
        found.append(f"{name} of {most} bytes, where {target.block_bytes} are allowed")
    if target.memory_bytes is not None and size.memory > target.memory_bytes:
        found.append(f"{size.memory} bytes of memory of {target.memory_bytes}")
    return found


def target_notes(layout: Layout, controller: Controller, source: Source) -> tuple[Diagnostic, ...]:
    """The estimate for the layout's target as a diagnostic; none without a target."""
    target = layout.target
    if target is None:
        return ()
    size = estimated(layout, controller)
    wrong = too_large(size, target)
    name, most = size.largest
    told = (
        f"{DIALECT}: {len(size.code)} blocks, the largest {name} with {most} bytes, {size.memory} bytes of memory; "
        f"{CAVEAT}"
    )
    rule = f"the rule: {RULE} ({SOURCE}); the limits: {target.source}"
    span = source.at("target")
    if wrong:
        message = f"{target.name} may not hold it: {'; '.join(wrong)}; {told}"
        return (Diagnostic("IL5009", Severity.WARNING, message, span, rule),)
    return (Diagnostic("IL5010", Severity.INFO, f"fits into {target.name} by estimate; {told}", span, rule),)
