"""`interlock explain`: the page of a diagnostic code."""

from __future__ import annotations

import sys

import click

from interlock.app.why import explain
from interlock.cli.common import FINDINGS, OK, format_option, put_json
from interlock.diag.codes import CODES
from interlock.diag.suggest import did_you_mean


@click.command("explain")
@click.argument("code", required=False)
@format_option
def command(code: str | None, form: str) -> None:
    """Explain a diagnostic code or a rule (R5); without one, list all codes."""
    if form == "json":
        wanted = [c for c in CODES if code is None or c == code.upper()]
        if not wanted and code is not None and explain(code) is not None:
            put_json([{"code": code.upper(), "severity": None, "title": "rule", "page": explain(code)}])
            sys.exit(OK)
        put_json([{"code": c, "severity": str(CODES[c][0]), "title": CODES[c][1], "page": explain(c)} for c in wanted])
        sys.exit(OK if wanted else FINDINGS)
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
