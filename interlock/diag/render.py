"""Diagnostics as text with a caret, as one line each, or as JSON.  One function per format."""

from __future__ import annotations

import unicodedata
from collections.abc import Callable, Iterable, Mapping

from interlock.diag.diagnostic import Diagnostic, Severity

_MAX_LINE = 160

Paint = Callable[[str, Severity], str]
"""Colours a text."""


def plain(text: str, severity: Severity) -> str:
    """No colour."""
    del severity
    return text


def _columns(text: str) -> int:
    """Terminal columns that a text takes: East Asian wide characters take two."""
    return sum(2 if unicodedata.east_asian_width(c) in "WF" else 1 for c in text)


def _printable(text: str) -> str:
    """The text without control characters, so that a hostile file cannot write on the terminal."""
    return "".join(c if c.isprintable() else ("    " if c == "\t" else "?") for c in text)


def _excerpt(d: Diagnostic, lines: list[str]) -> list[str]:
    if d.span is None or not 1 <= d.span.line <= len(lines):
        return []
    raw = lines[d.span.line - 1]
    start = max(0, d.span.column - 1)
    shift = max(0, start - _MAX_LINE // 2) if start + d.span.width > _MAX_LINE else 0
    before = _printable(raw[shift:start])
    shown = _printable(raw[shift : shift + _MAX_LINE]).rstrip()
    marked = _printable(raw[start : start + max(1, d.span.width)])
    gutter = str(d.span.line)
    pad = " " * len(gutter)
    carets = "^" * max(1, min(_columns(marked), _MAX_LINE - _columns(before)))
    return [f"{pad} |", f"{gutter} | {shown}", f"{pad} | {' ' * _columns(before)}{carets}"]


def _where(d: Diagnostic) -> str:
    """File, line and column; nothing for a file that could not be opened (its name stands in the message)."""
    return f"{d.span.file}:{d.span.line}:{d.span.column}: " if d.span and d.span.line else ""


def _label(d: Diagnostic, paint: Paint) -> str:
    return paint(f"{d.severity}[{d.code}]", d.severity)


def full(diagnostics: Iterable[Diagnostic], sources: Mapping[str, str], paint: Paint = plain) -> str:
    """Every diagnostic with its line, caret and fix.  `sources` maps file name to text."""
    out: list[str] = []
    split: dict[str, list[str]] = {}
    for d in diagnostics:
        where = _where(d)
        out.append(f"{where}{_label(d, paint)}: {_printable(d.message)}")
        if d.span is not None:
            if d.span.file not in split:
                split[d.span.file] = sources.get(d.span.file, "").split("\n")
            out.extend("  " + line for line in _excerpt(d, split[d.span.file]))
        if d.fix:
            out.append(f"  fix: {_printable(d.fix)}")
        out.append("")
    return "\n".join(out)


def concise(diagnostics: Iterable[Diagnostic], sources: Mapping[str, str], paint: Paint = plain) -> str:
    """One line for each diagnostic."""
    del sources
    rows = []
    for d in diagnostics:
        where = _where(d)
        rows.append(f"{where}{_label(d, paint)}: {_printable(d.message)}\n")
    return "".join(rows)


def as_json(diagnostics: Iterable[Diagnostic]) -> list[dict[str, object]]:
    """Plain data for `--format json`."""
    return [
        {
            "code": d.code,
            "severity": str(d.severity),
            "message": d.message,
            "file": d.span.file if d.span else None,
            "line": d.span.line if d.span else None,
            "column": d.span.column if d.span else None,
            "fix": d.fix or None,
        }
        for d in diagnostics
    ]


def summary(diagnostics: Iterable[Diagnostic]) -> str:
    """'2 errors, 1 warning', or an empty text."""
    found = list(diagnostics)
    parts = []
    for severity in (Severity.ERROR, Severity.WARNING):
        n = sum(1 for d in found if d.severity is severity)
        if n:
            parts.append(f"{n} {severity}{'s' if n > 1 else ''}")
    return ", ".join(parts)
