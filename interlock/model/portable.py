"""Layout names as portable identifiers: ASCII letters, digits and single underscores."""

from __future__ import annotations


def portable(name: str) -> str:
    """The name with `-` and `/` as `_`.  Names that become equal are reported by the front end."""
    return name.replace("-", "_").replace("/", "_")
