"""interlock: a formally checked interlocking table generator."""

__version__ = "0.1.0"
