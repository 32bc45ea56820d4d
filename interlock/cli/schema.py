"""`interlock schema`: what the layout language and table.json look like, for programs and for people."""

from __future__ import annotations

import click

from interlock.cli.common import format_option, put_json


@click.command("schema")
@click.option(
    "--of",
    "what",
    type=click.Choice(["layout", "pins", "table", "keys"]),
    default="layout",
    show_default=True,
    help="The layout language and the file of pins (draft-07), table.json (2020-12), or every key as Markdown.",
)
@format_option
def command(what: str, form: str) -> None:
    """Print the JSON Schema of the layout language, for completion in editors, or of table.json."""
    from interlock.emit.tables.schema import table_schema
    from interlock.frontend.pins import PinFile
    from interlock.frontend.published import json_schema, language_keys

    if what == "keys" and form != "json":
        click.echo(language_keys(), nl=False)
    elif what == "keys":
        put_json({"markdown": language_keys()})
    elif what == "pins":
        put_json(json_schema(PinFile, "interlock pins"))
    else:
        put_json(json_schema() if what == "layout" else table_schema())
