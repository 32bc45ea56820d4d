"""Load, derive and audit a layout file.  No solver is loaded here, so that `check` is quick."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from interlock.diag import Diagnostic, Severity, Sink
from interlock.frontend import Source, load
from interlock.model.elements import RouteId
from interlock.model.layout import Layout
from interlock.table.rows import InterlockingTable

if TYPE_CHECKING:
    from interlock.audit import Finding


@dataclass(frozen=True)
class Checked:
    """A layout file with its diagnostics; layout and table are None when there are errors."""

    path: str
    source: Source
    diagnostics: tuple[Diagnostic, ...]
    layout: Layout | None = None
    table: InterlockingTable | None = None

    @property
    def ok(self) -> bool:
        """No errors."""
        return self.layout is not None and not any(d.severity is Severity.ERROR for d in self.diagnostics)


def check_file(path: str) -> Checked:
    """Load and derive; audit the derived table."""
    found = derive_file(path)
    return audited(found, second_opinion(found))


def derive_file(path: str) -> Checked:
    """Load and derive, not yet audited."""
    sink = Sink()
    layout, source = load(path, sink)
    return Checked(path, source, sink.diagnostics) if layout is None else derived(path, layout, source, sink)


def derived(path: str, layout: Layout, source: Source, sink: Sink) -> Checked:
    """Derive what was loaded, not yet audited; `sink` has what was found while it was."""
    from interlock.derivation import derive

    table = derive(layout, sink)
    if layout.addresses and not sink.has_errors:
        _addresses(layout, table, source, sink)
    if not sink.has_errors:
        source.check_allowed(sink)
    return Checked(path, source, sink.diagnostics, layout, table)


def second_opinion(checked: Checked) -> tuple[Finding, ...]:
    """What the audit sees differently."""
    from interlock.audit import audit

    if not checked.ok or checked.layout is None or checked.table is None:
        return ()
    return audit(checked.layout, checked.table)


def audited(checked: Checked, findings: Sequence[Finding]) -> Checked:
    """The same with the findings of the audit, each an error."""
    if checked.table is None:
        return checked
    sink = Sink()
    for finding in findings:
        row = checked.table.route.get(RouteId(finding.route))
        sink.add(
            "IL4007",
            f"route {finding.route}, {finding.column}: {finding.text}",
            checked.source.at("name") if row is None else checked.source.at("signals", row.entry),
            "this is a defect of interlock; please report the layout",
        )
    return replace(checked, diagnostics=(*checked.diagnostics, *sink.diagnostics))


def _addresses(layout: Layout, table: InterlockingTable, source: Source, sink: Sink) -> None:
    from interlock.logic.cabinet import BadAddress, allocate
    from interlock.logic.expr import interning
    from interlock.logic.lower import lower

    try:
        with interning():
            allocate(layout, lower(layout, table))
    except BadAddress as error:
        fix = "see io/channels.csv of a compiled layout for the variables with a wire"
        sink.add("IL2015", str(error), source.at("addresses", error.variable), fix)
