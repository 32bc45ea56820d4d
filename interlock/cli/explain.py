"""`interlock explain`: what a code means."""

from __future__ import annotations

import sys

import click

from interlock.app.explain import explain, topic, topics
from interlock.cli.common import FINDINGS, OK, failed, format_option, put_json
from interlock.diag.suggest import did_you_mean


@click.command("explain")
@click.argument("code", required=False)
@format_option
def command(code: str | None, form: str) -> None:
    """Explain a diagnostic (IL4001), a rule (R5), a claim (T-COLLISION), a function (F-GRANT), an assumption (A-SCAN),
    a principle (release_delay_s) or a key of the layout (overlaps), or show a page of the documents (panel); without a
    code, list all of them.
    """
    if code is None:
        found = topics()
        if form == "json":
            put_json([{"code": t.code, "kind": t.kind, "severity": t.severity, "title": t.title} for t in found])
        else:
            for t in found:
                click.echo(f"{t.code:22} {t.severity or t.kind:10} {t.title}")
        sys.exit(OK)
    one, page = topic(code), explain(code)
    if one is None or page is None:
        fix = did_you_mean(code, [t.code for t in topics()], "`interlock explain` lists all of them")
        failed(f"there is no code {code}", form, code="IL5005", fix=str(fix))
        sys.exit(FINDINGS)
    if form == "json":
        put_json([{"code": one.code, "kind": one.kind, "severity": one.severity, "title": one.title, "page": page}])
    else:
        click.echo(page, nl=False)
    sys.exit(OK)
