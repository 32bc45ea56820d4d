"""`interlock verify`: check certificates, with code that shares nothing with the prover."""

from __future__ import annotations

import sys
import time
from pathlib import Path

import click

from interlock.cli.common import FINDINGS, NOT_PROVED, OK, format_option, progress, put_json, took
from interlock.verify import ERRORS, judge, why


@click.command("verify")
@click.argument("given", nargs=-1, required=True, metavar="[LAYOUT] FOLDER...", type=click.Path(exists=True))
@format_option
def command(given: tuple[str, ...], form: str) -> None:
    """Check certificates (folders written by `certify`) again: digests, refutations, and that every claim is covered.

    That is said of the written system alone.  With LAYOUT before a FOLDER the emitted Structured Text is read and
    compared with that system, too, by code that shares nothing with what made it, and so are plant, assumptions and
    claims with the specification for the layout; the exit code is 3 while something has not been compared.  One line
    tells which files of the bundle nobody reads.
    """
    files = [g for g in given if not Path(g).is_dir()]
    if files and (len(given) != 2 or files != [given[0]]):
        raise click.UsageError("one layout, then the folder of its certificate")
    if files:
        sys.exit(_compare(Path(given[0]), Path(given[1]), form))
    found = []
    for folder in given:
        began = time.monotonic()
        accepted, text = judge(folder)
        verdict = "ACCEPTED" if accepted else "REJECTED"
        found.append({"folder": folder, "ok": accepted, "verdict": verdict, "text": text, **_took(began)})
        if form != "json":
            mark = click.style(verdict, fg="green" if accepted else "red")
            click.echo(f"{folder}: {mark}  {text}, {took(began)}")
    if form == "json":
        put_json(found)
    sys.exit(OK if all(f["ok"] for f in found) else FINDINGS)


def _took(began: float) -> dict[str, float]:
    return {"wall_seconds": round(time.monotonic() - began, 3)}


def _compare(layout: Path, folder: Path, form: str) -> int:
    """With the layout and the emitted text; 3 when something was not compared."""
    from interlock.checker.check import Checked, check, report

    def checked(layout: Path, folder: Path) -> Checked:
        with progress(str(layout)) as said:
            said(f"comparing with {folder}", 0, 0)
            return check(layout, folder)

    if form != "json":
        return report(layout, folder, checked)
    body: dict[str, object] = {"layout": str(layout), "folder": str(folder)}
    began = time.monotonic()
    try:
        found = checked(layout, folder)
    except ERRORS as error:
        put_json([{**body, "ok": False, "verdict": "REJECTED", "text": why(error), **_took(began)}])
        return FINDINGS
    body |= {"ok": not found.left, "verdict": "CHECKED" if found.left else "VERIFIED"}
    put_json([{**body, "compared": list(found.compared), "not_compared": list(found.left), **_took(began)}])
    return NOT_PROVED if found.left else OK
