"""From a layout file to a `Layout`: YAML tree, schema, wiring, checks."""

from interlock.frontend.load import Source, load, load_text

__all__ = ["Source", "load", "load_text"]
