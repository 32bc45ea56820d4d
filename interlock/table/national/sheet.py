"""A printed sheet: headings in three languages and rows of text."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Heading:
    """A column's heading in English, Chinese and German."""

    en: str
    zh: str
    de: str


@dataclass(frozen=True)
class Sheet:
    """One table as a railway prints it; `key` is part of its file name, `language` (en, zh, de) that of its cells.

    `of_routes`: it has rows for routes, and says how many of them are not listed.
    """

    key: str
    language: str
    title: Heading
    headings: tuple[Heading, ...]
    rows: tuple[tuple[str, ...], ...]
    of_routes: bool = False
