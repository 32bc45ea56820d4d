"""`interlock verify`: check certificates again, with nothing of what made them."""

from __future__ import annotations

import sys
from pathlib import Path

import click

from interlock.verify import main


@click.command("verify")
@click.argument("given", nargs=-1, required=True, metavar="[LAYOUT] FOLDER...", type=click.Path(exists=True))
def command(given: tuple[str, ...]) -> None:
    """Check certificates (folders written by `certify`) again: digests, refutations, and that every claim is covered.

    That is said of the written system alone.  With LAYOUT before a FOLDER the emitted Structured Text is read and
    compared with that system, too, by code that shares nothing with what made it, and so are plant, assumptions and
    claims with the specification for the layout; the exit code is 3 while something has not been compared.
    """
    files = [g for g in given if not Path(g).is_dir()]
    if not files:
        sys.exit(main(list(given)))
    if len(given) != 2 or files != [given[0]]:
        raise click.UsageError("one layout, then the folder of its certificate")
    from interlock.checker.check import report

    sys.exit(report(Path(given[0]), Path(given[1])))
