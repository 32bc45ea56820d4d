"""What a mapping of the language is, and a key of it: with its meaning, and with what is without it."""

from __future__ import annotations

from typing import Any

from pydantic import BaseModel, ConfigDict, Field


class Part(BaseModel):
    """A mapping with these keys and no others."""

    model_config = ConfigDict(extra="forbid", frozen=True, defer_build=True)


def key(text: str, default: Any = ..., *, name: str | None = None, least: int = 0, most: int = 0) -> Any:
    """A key of the language: what it means (shown by editors and by the language page), and what it is without it.

    `name`: how it is written, where Python forbids that; `least` and `most` entries of a list.
    """
    count: Any = {k: v for k, v in (("min_length", least), ("max_length", most)) if v}
    return Field(default, description=text, alias=name, **count)
