"""`interlock explain`: the page of a diagnostic code."""

from __future__ import annotations

import sys

import click

from interlock.app.why import explain
from interlock.cli.common import FINDINGS, OK
from interlock.diag.codes import CODES
from interlock.diag.suggest import did_you_mean


@click.command("explain")
@click.argument("code", required=False)
def command(code: str | None) -> None:
    """Explain a diagnostic code; without a code, list them all."""
    if code is None:
        for c, (severity, title) in CODES.items():
            click.echo(f"{c}  {severity:8} {title}")
        sys.exit(OK)
    page = explain(code)
    if page is None:
        click.echo(f"error[IL5005]: there is no code {code}\n  fix: {did_you_mean(code.upper(), CODES)}", err=True)
        sys.exit(FINDINGS)
    click.echo(page, nl=False)
    sys.exit(OK)
