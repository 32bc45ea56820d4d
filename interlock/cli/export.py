"""`interlock export`: the system for other engines."""

from __future__ import annotations

import sys
from pathlib import Path

import click

from interlock.app.export import aiger_file
from interlock.cli.common import FINDINGS, OK, show


@click.command("export")
@click.argument("layout", type=click.Path(exists=True))
@click.option("--aiger", "form", flag_value="aiger", default="aiger", help="Binary AIGER (the default).")
@click.option("-o", "--output", type=click.Path(path_type=Path, dir_okay=False), required=True, help="The file.")
def command(layout: str, form: str, output: Path) -> None:
    """Write controller, physics and claims as a circuit; its output is true when some claim is violated."""
    del form
    checked, data = aiger_file(layout)
    if data is None:
        show(checked.diagnostics, {checked.source.file: checked.source.text}, "text")
        sys.exit(FINDINGS)
    try:
        output.write_bytes(data)
    except OSError as error:
        click.echo(f"{output}: {error.strerror}", err=True)
        sys.exit(FINDINGS)
    click.echo(f"{output}: {data.split(maxsplit=6)[1].decode()} variables, {len(data)} bytes")
    sys.exit(OK)
