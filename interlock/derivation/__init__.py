"""From a layout to its interlocking table.  One column family a file; `pipeline` shows the order."""

from interlock.derivation.pipeline import derive

__all__ = ["derive"]
