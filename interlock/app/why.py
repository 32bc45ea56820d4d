"""Why a cell is as it is."""

from __future__ import annotations

from interlock.app.check import Checked, check_file
from interlock.dataclass import dataclass
from interlock.diag import Diagnostic, Severity
from interlock.diag.suggest import did_you_mean
from interlock.table.columns import COLUMNS


@dataclass(frozen=True)
class Reason:
    """One item of a cell with its reason."""

    column: str
    item: str
    rule: str
    text: str


def why(path: str, route: str, column: str | None) -> tuple[Checked, tuple[Reason, ...], tuple[Diagnostic, ...]]:
    """The reasons of a route's cells."""
    checked = check_file(path)
    if checked.table is None:
        return checked, (), ()
    rows = [r for r in checked.table.routes if route in (r.id, str(r.number), *r.names)]
    if not rows:
        known = [n for r in checked.table.routes for n in (r.id, *r.names)]
        return (
            checked,
            (),
            (
                Diagnostic(
                    "IL5005",
                    Severity.ERROR,
                    f"{path} has no route {route}",
                    None,
                    did_you_mean(route, known, "known: " + ", ".join(known[:40])),
                ),
            ),
        )
    picked = [c for c in COLUMNS if column in (None, c.key, c.en)]
    if not picked:
        return (
            checked,
            (),
            (
                Diagnostic(
                    "IL5005",
                    Severity.ERROR,
                    f"there is no column {column}",
                    None,
                    did_you_mean(column or "", [c.key for c in COLUMNS]),
                ),
            ),
        )
    reasons = [Reason(c.en, item, b.rule, b.text) for c in picked for r in rows for item, b in c.items(r)]
    return checked, tuple(reasons), ()
