"""Load, derive and audit a layout file.  No solver is loaded here, so that `check` is quick."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from interlock.diag import Diagnostic, Severity, Sink
from interlock.frontend import Source, load
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
    placed = tuple(_place(d, source, path) for d in sink.diagnostics)
    return Checked(path, source, placed, layout, table)


def second_opinion(checked: Checked) -> tuple[Finding, ...]:
    """What the audit sees differently."""
    from interlock.audit import audit

    if not checked.ok or checked.layout is None or checked.table is None:
        return ()
    return audit(checked.layout, checked.table)


def audited(checked: Checked, findings: Sequence[Finding]) -> Checked:
    """The same with the findings of the audit, each an error."""
    sink = Sink()
    for finding in findings:
        sink.add(
            "IL4007",
            f"route {finding.route}, {finding.column}: {finding.text}",
            None,
            "this is a defect of interlock; please report the layout",
        )
    placed = tuple(_place(d, checked.source, checked.path) for d in sink.diagnostics)
    return replace(checked, diagnostics=(*checked.diagnostics, *placed))


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


def _place(d: Diagnostic, source: Source, path: str) -> Diagnostic:
    """Diagnostics of the derivation point at the element that they speak of."""
    if d.span is not None:
        return d
    if d.code == "IL2008" and source.context is not None:
        for i, w in enumerate(source.context.file.waive):
            if f" {w.flank} " in d.message:
                return replace(d, span=source.context.at("waive", i, "flank"))
    file = source.context.file if source.context else None
    if file is None:
        return replace(d, span=source.at("name"))
    for word in "".join(c if c not in ",:;()" else " " for c in d.message).split():
        for name in (word, word.split(".")[0], word.split("-")[0]):
            for room in ("points", "signals", "routes", "crossings"):
                if name in getattr(file, room):
                    return replace(d, span=source.at(room, name))
            for track, items in file.tracks.items():
                for i, item in enumerate(items):
                    if item.split()[0] == name and source.context is not None:
                        return replace(d, span=source.context.at("tracks", track, i))
    return replace(d, span=source.at("name"))
