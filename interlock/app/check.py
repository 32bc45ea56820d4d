"""Load, derive and audit a layout file.  No solver is loaded here, so that `check` is quick."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from interlock.app.own import is_changed
from interlock.dataclass import dataclass
from interlock.diag import Diagnostic, Severity, Sink
from interlock.frontend import Source, load
from interlock.frontend.pins import beside
from interlock.model.elements import RouteId
from interlock.model.layout import Layout
from interlock.table.rows import InterlockingTable

if TYPE_CHECKING:
    from interlock.audit import Finding
    from interlock.logic.cabinet import Clash


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
    if (layout.hardware.addresses or layout.hardware.pins) and not sink.has_errors:
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
    from interlock.app.pinned import check_pins
    from interlock.logic.cabinet import BadAddress, allocate, clashes, wires
    from interlock.logic.expr import interning
    from interlock.logic.lower import lower

    with interning():
        controller = lower(layout, table)
        found = clashes(layout, controller)
        for clash in found:
            _contradicted(layout, clash, source, sink)
        if found:
            return
        try:
            made = allocate(layout, controller)
        except BadAddress as error:
            fix = "see io/channels.csv of a compiled layout for the variables with a wire"
            sink.add("IL2015", str(error), source.at("addresses", error.variable), fix)
            return
    _changed_by_hand(source, sink)
    check_pins(layout, wires(layout, controller), source, sink)
    new = [c for c in made.wires if c.variable not in layout.hardware.pins.by_variable]
    if layout.hardware.pins and new:
        shown = ", ".join(f"{c.variable} {c.address}" for c in new[:8]) + (" ..." if len(new) > 8 else "")
        said = f"{shown}: not pinned yet, so that the next change may move {'it' if len(new) == 1 else 'them'}"
        sink.add("IL2023", said, source.at("name"), f"run `interlock pin {source.file}` when it is wired so")


def _changed_by_hand(source: Source, sink: Sink) -> None:
    """Channels that were exchanged in the file of pins are exchanged in every text, and nothing else can tell."""
    file = Path(beside(source.file))
    if source.pins is not None and source.pins_data is not None and is_changed(source.pins_data):
        said = (
            f"{file.name} was changed by hand since interlock wrote it: what was moved there is expected on other wires"
        )
        fix = f"compare it with the cabinet; `interlock pin {source.file} --force` then takes it as it is"
        sink.add("IL5011", said, source.at("name"), fix)


def _contradicted(layout: Layout, clash: Clash, source: Source, sink: Sink) -> None:
    """A pin that the layout contradicts, with both places."""
    pinned = None if source.pins is None else source.pins.at(clash.pin.variable)
    if clash.where == "pin":
        sink.add("IL2022", clash.text, pinned, f"correct it, or run `interlock pin {source.file} --yes`")
        return
    holder = {e: (s.name, i) for s in layout.hardware.substations for i, e in enumerate(s.elements)}
    place = (clash.variable,) if clash.where == "addresses" else holder.get(clash.pin.element, ())
    at = (
        source.at(clash.where, *place)
        if layout.hardware.substations or clash.where == "addresses"
        else source.at("name")
    )
    line = "" if pinned is None else f" ({pinned.file}, line {pinned.line})"
    fix = f"undo that here, or let it move: `interlock pin {source.file} --yes`"
    sink.add("IL2022", clash.text + line, at, fix)
