"""What a thing is called in a sentence: its kind and its name."""

from __future__ import annotations


def called(kind: str, name: str) -> str:
    """`signal S5`; only `signal5` or `Signal_5` where the name says its kind itself."""
    says = len(name) > len(kind) and name.lower().startswith(kind.lower())
    return name if says else f"{kind} {name}"
