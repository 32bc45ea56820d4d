"""`interlock schema`: the JSON Schema of the layout language."""

from __future__ import annotations

import click

from interlock.cli.common import put_json
from interlock.frontend.schema import json_schema


@click.command("schema")
def command() -> None:
    """Print the JSON Schema (draft-07) of the layout language, for completion in editors."""
    put_json(json_schema())
