"""Structured Text: syntax tree, lowering, printer, parser and meaning of the portable subset."""
