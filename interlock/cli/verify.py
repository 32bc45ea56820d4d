"""`interlock verify`: check certificates again, with nothing of what made them."""

from __future__ import annotations

import sys

import click

from interlock.verify import main


@click.command("verify")
@click.argument("bundles", nargs=-1, required=True, type=click.Path(exists=True, file_okay=False))
def command(bundles: tuple[str, ...]) -> None:
    """Check certificates (folders written by `certify`) again: files, refutations, and that every claim is covered."""
    sys.exit(main(list(bundles)))
