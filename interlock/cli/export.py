"""`interlock export`: the system for other engines, and registers for a SCADA."""

from __future__ import annotations

import sys
from pathlib import Path

import click

from interlock.app.export import aiger_file, registers_file
from interlock.app.own import NotOurs, write_own
from interlock.cli.common import FINDINGS, OK, failed, force_option, format_option, progress, put_json, show, told


@click.command("export")
@click.argument("layout", type=click.Path())
@click.option("--aiger", "engine", flag_value="aiger", default="aiger", help="Binary AIGER (the default).")
@click.option(
    "--registers", "engine", flag_value="registers", help="The registers of `run --operator-modbus`, as a table (CSV)."
)
@click.option(
    "-o", "--output", type=click.Path(path_type=Path, dir_okay=False), required=True, help="The file to write."
)
@force_option
@format_option
def command(layout: str, engine: str, output: Path, force: bool, form: str) -> None:
    """Write controller, physics and claims as a circuit; its output is true when some claim is violated.  With
    --registers: what stands where for a SCADA that reads the operator's place."""
    if engine == "aiger" and output.suffix != ".aig":
        raise click.UsageError(f"{output}: a circuit in binary AIGER is called NAME.aig")
    if engine == "registers" and output.suffix != ".csv":
        raise click.UsageError(f"{output}: a table of registers is called NAME.csv")
    with progress(layout) as report:
        report("making the circuit" if engine == "aiger" else "numbering registers", 0, 0)
        checked, data = (aiger_file if engine == "aiger" else registers_file)(layout)
    if data is None:
        show(checked.diagnostics, checked.source.texts, form)
        sys.exit(FINDINGS)
    try:
        size = write_own(output, data, Path(layout), force)
    except (NotOurs, OSError) as error:
        failed(told(error, output), form)
        sys.exit(FINDINGS)
    if engine == "registers":
        rows = data.count(b"\n") - 1
        if form == "json":
            put_json({"ok": True, "file": str(output), "bytes": size, "rows": rows})
        else:
            click.echo(f"{output}: {rows} rows, {size} bytes")
        sys.exit(OK)
    variables = int(data.split(maxsplit=6)[1])
    if form == "json":
        put_json({"ok": True, "file": str(output), "bytes": size, "variables": variables})
    else:
        click.echo(f"{output}: {variables} variables, {size} bytes")
    sys.exit(OK)
