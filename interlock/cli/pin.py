"""`interlock pin`: addresses that stay."""

from __future__ import annotations

import sys
from collections import Counter

import click

from interlock.app.own import NotOurs, is_ours
from interlock.app.pin import Change, NotReserved, Repinned, pin_file
from interlock.cli.common import FINDINGS, OK, failed, force_option, format_option, put_json, show, told
from interlock.diag import Severity
from interlock.diag.render import as_json


@click.command("pin")
@click.argument("layout", type=click.Path())
@click.option(
    "--release",
    "names",
    multiple=True,
    metavar="NAME",
    help="Release the channels reserved for this element or variable.",
)
@click.option("--yes", is_flag=True, help="Let channels of elements that are kept move where the layout says so.")
@force_option
@format_option
def command(layout: str, names: tuple[str, ...], yes: bool, force: bool, form: str) -> None:
    """Write the channels of LAYOUT's cabinets to the file of pins beside it (NAME.pins), so that they stay.

    What is kept keeps its channel from then on, whatever else changes; what is new is appended; a channel of what is
    gone stays reserved until it is released.  What changes is shown; what would move is not written without --yes.
    """
    try:
        found = pin_file(layout, names)
    except NotReserved as error:
        failed(str(error), form)
        sys.exit(FINDINGS)
    if found.pins is None:
        show(found.diagnostics, found.source.texts, form)
        sys.exit(FINDINGS)
    if form != "json":
        _print(found)
    if found.moves and not yes:
        _refuse(found, "channels of elements that are kept would move: nothing is written without --yes", form)
    taken = force and not found.first and not is_ours(found.source.pins_data or b"")
    changed = bool(found.changes) or found.first or taken
    if changed:
        try:
            found.write(force)
        except (NotOurs, OSError) as error:
            _refuse(found, told(error, found.file), form)
    if form == "json":
        put_json({"ok": True, "written": changed, **_body(found)})
    else:
        count = len(found.pins.channels)
        kept = f", {len(found.pins.reserved)} reserved" if found.pins.reserved else ""
        click.echo(f"{found.file}: {count} channels{kept}{'' if changed else '; nothing has changed'}")
    sys.exit(OK)


def _refuse(found: Repinned, text: str, form: str) -> None:
    if form == "json":
        put_json({"ok": False, "error": text, **_body(found)})
    else:
        failed(text, form)
    sys.exit(FINDINGS)


def _body(found: Repinned) -> dict[str, object]:
    changes = [
        {
            "kind": c.kind,
            "variable": c.pin.variable,
            "element": c.pin.element,
            "substation": c.pin.substation,
            "address": c.pin.address,
            "before": None if c.before is None else c.before.address,
        }
        for c in found.changes
    ]
    return {
        "file": str(found.file),
        "channels": 0 if found.pins is None else len(found.pins.channels),
        "reserved": 0 if found.pins is None else len(found.pins.reserved),
        "changes": changes,
        "diagnostics": as_json(found.diagnostics, found.source.texts),
    }


def _print(found: Repinned) -> None:
    """What is different; of a first file nothing is worth a line."""
    warnings = [d for d in found.diagnostics if d.severity is Severity.WARNING]
    show(warnings, found.source.texts, "concise")
    kinds = Counter(c.kind for c in found.changes)
    for change in () if found.first else found.changes:
        click.echo(_line(change))
    if kinds and not found.first:
        click.echo("  " + ", ".join(f"{n} {kind}" for kind, n in kinds.items()))


def _line(change: Change) -> str:
    colour = {"moved": "red", "released": "yellow", "reserved": "yellow"}.get(change.kind, "green")
    return f"  {click.style(f'{change.kind:8}', fg=colour)} {change.text}"
