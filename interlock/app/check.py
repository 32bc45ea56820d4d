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
    derived = derive_file(path)
    return audited(derived, second_opinion(derived))


def derive_file(path: str) -> Checked:
    """Load and derive, not yet audited."""
    from interlock.derive import derive

    sink = Sink()
    layout, source = load(path, sink)
    if layout is None:
        return Checked(path, source, sink.diagnostics)
    table = derive(layout, sink)
    if layout.addresses and not sink.has_errors:
        _addresses(layout, table, source, sink)
    if not sink.has_errors:
        source.check_allowed(sink)
    return Checked(path, source, sink.diagnostics, layout, table)


def second_opinion(derived: Checked) -> tuple[Finding, ...]:
    """What the audit sees differently."""
    from interlock.audit import audit

    if not derived.ok or derived.layout is None or derived.table is None:
        return ()
    return audit(derived.layout, derived.table)


def audited(derived: Checked, findings: Sequence[Finding]) -> Checked:
    """The same with the findings of the audit, each an error."""
    if derived.table is None:
        return derived
    sink = Sink()
    for finding in findings:
        row = derived.table.route.get(RouteId(finding.route))
        sink.add(
            "IL4007",
            f"route {finding.route}, {finding.column}: {finding.text}",
            derived.source.at("name") if row is None else derived.source.at("signals", row.entry),
            "this is a defect of interlock; please report the layout",
        )
    return replace(derived, diagnostics=(*derived.diagnostics, *sink.diagnostics))


def _addresses(layout: Layout, table: InterlockingTable, source: Source, sink: Sink) -> None:
    from interlock.logic.cabinet import BadAddress, allocate
    from interlock.logic.lower import lower

    try:
        allocate(layout, lower(layout, table))
    except BadAddress as error:
        fix = "see io/channels.csv of a compiled layout for the variables with a wire"
        sink.add("IL2015", str(error), source.at("addresses", error.variable), fix)
