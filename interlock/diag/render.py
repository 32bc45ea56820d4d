"""Diagnostics as text with a caret, as one line each, or as JSON.  One function per format.

All three show the same: at most `LIMIT` problems of a file, errors first, and how many there are beside them.
"""

from __future__ import annotations

import textwrap
import unicodedata
from collections.abc import Callable, Iterable, Mapping, Sequence

from interlock.diag.codes import severity_of
from interlock.diag.diagnostic import Diagnostic, Place, Severity

LIMIT = 20
"""Problems shown of one file, and places shown of one problem: enough to find what they have in common."""

_MAX_LINE = 160
_RANK = {Severity.ERROR: 0, Severity.WARNING: 1, Severity.INFO: 2}

Paint = Callable[[str, Severity], str]
"""Colours a text."""


def bare(text: str, severity: Severity) -> str:
    """No colour."""
    del severity
    return text


def limited(diagnostics: Iterable[Diagnostic]) -> tuple[Diagnostic, ...]:
    """The first `LIMIT`, errors before warnings before notes, in the order of the source; last, how many are not."""
    found = list(diagnostics)
    chosen = sorted(sorted(range(len(found)), key=lambda i: _RANK[found[i].severity])[:LIMIT])
    shown = [found[i] for i in chosen]
    if len(shown) == len(found):
        return tuple(shown)
    rest = set(range(len(found))).difference(chosen)
    words = _count([found[i] for i in sorted(rest)], (*_RANK,))
    fix = "mend those above and check again"
    span = shown[-1].span
    return (*shown, Diagnostic("IL1020", severity_of("IL1020"), f"{words} more, not shown", span, fix))


def full(
    diagnostics: Iterable[Diagnostic], sources: Mapping[str, str], width: int | None = None, paint: Paint = bare
) -> str:
    """Every diagnostic with its line, caret, other places and fix.  `sources` maps file name to text; sentences are
    wrapped to `width` columns, and a long source line is cut to them around the place."""
    out: list[str] = []
    lines = _Lines(sources)
    for d in limited(diagnostics):
        beyond = d.code == "IL1020"
        head = f"{d.severity}[{d.code}]"
        where = "" if beyond else _where(d)
        first, *further = _wrapped(f"{where}{head}: {_printable(d.message)}", width, "  ")
        out.append(first.replace(head, paint(head, d.severity), 1))
        out.extend(further)
        if not beyond:
            out.extend("  " + line for line in _excerpt(d, lines.of(d), (width or _MAX_LINE) - 2))
        if d.also:
            out.extend(_wrapped(f"  also: {_places(d)}", width, "    "))
        if d.fix:
            out.extend(_wrapped(f"  fix: {_printable(d.fix)}", width, "    "))
        out.append("")
    return "\n".join(out)


def concise(diagnostics: Iterable[Diagnostic], sources: Mapping[str, str], paint: Paint = bare) -> str:
    """One line for each diagnostic."""
    del sources
    rows = []
    for d in limited(diagnostics):
        where = "" if d.code == "IL1020" else _where(d)
        also = f" (also: {_places(d)})" if d.also else ""
        head = paint(f"{d.severity}[{d.code}]", d.severity)
        rows.append(f"{where}{head}: {_printable(d.message)}{also}\n")
    return "".join(rows)


def as_json(diagnostics: Iterable[Diagnostic], sources: Mapping[str, str] | None = None) -> list[dict[str, object]]:
    """Plain data for `--format json`: what the text shows, the source line included."""
    lines = _Lines(sources or {})
    return [
        {
            "code": d.code,
            "severity": str(d.severity),
            "message": d.message,
            "file": d.span.file if d.span else None,
            **_spot(d),
            "source": lines.at(d),
            "element": {"kind": d.about.room, "name": d.about.name} if d.about else None,
            "also": [
                {"line": p.span.line if p.span else None, "column": p.span.column if p.span else None, "note": p.note}
                for p in d.also
            ],
            "fix": d.fix or None,
        }
        for d in limited(diagnostics)
    ]


def _spot(d: Diagnostic) -> dict[str, object]:
    """Line, column and width; null for a file that could not be opened, as for what has no place."""
    known = d.span is not None and d.span.line > 0
    return {name: getattr(d.span, name) if known else None for name in ("line", "column", "width")}


def summary(diagnostics: Iterable[Diagnostic]) -> str:
    """'2 errors, 1 warning', or an empty text."""
    return _count(diagnostics, (Severity.ERROR, Severity.WARNING))


class _Lines:
    """The lines of the sources, each split once."""

    def __init__(self, sources: Mapping[str, str]) -> None:
        self._sources = sources
        self._split: dict[str, list[str]] = {}

    def of(self, d: Diagnostic) -> Sequence[str]:
        """The lines of the file in which a diagnostic stands."""
        if d.span is None:
            return ()
        if d.span.file not in self._split:
            self._split[d.span.file] = self._sources.get(d.span.file, "").split("\n")
        return self._split[d.span.file]

    def at(self, d: Diagnostic) -> str | None:
        """The line of a diagnostic."""
        lines = self.of(d)
        return lines[d.span.line - 1][:_MAX_LINE] if d.span is not None and 1 <= d.span.line <= len(lines) else None


def _count(diagnostics: Iterable[Diagnostic], severities: Iterable[Severity]) -> str:
    found = [d.severity for d in diagnostics]
    words = {Severity.ERROR: "error", Severity.WARNING: "warning", Severity.INFO: "note"}
    counts = [(found.count(s), words[s]) for s in severities]
    return ", ".join(f"{n} {word}{'s' if n > 1 else ''}" for n, word in counts if n)


def _columns(text: str) -> int:
    """Terminal columns that a text takes: East Asian wide characters take two."""
    return sum(2 if unicodedata.east_asian_width(c) in "WF" else 1 for c in text)


def _printable(text: str) -> str:
    """The text without control characters, so that a hostile file cannot write on the terminal."""
    return "".join(c if c.isprintable() else ("    " if c == "\t" else "?") for c in text)


def _wrapped(text: str, width: int | None, indent: str) -> list[str]:
    """The text in lines of at most `width` columns; words, and names with hyphens, stay whole."""
    if width is None or _columns(text) <= width:
        return [text]
    room = max(20, width)
    own = text[: len(text) - len(text.lstrip())]
    return textwrap.wrap(
        text.strip(), room, initial_indent=own, subsequent_indent=indent, break_long_words=False, break_on_hyphens=False
    )


def _excerpt(d: Diagnostic, lines: Sequence[str], room: int) -> list[str]:
    """The source line with carets under the place; of a long line, as much around the place as there is room for."""
    if d.span is None or not 1 <= d.span.line <= len(lines):
        return []
    raw = lines[d.span.line - 1]
    gutter = str(d.span.line)
    room = max(20, min(_MAX_LINE, room - len(gutter) - 3))
    start = max(0, d.span.column - 1)
    length = max(1, d.span.width)
    shift = max(0, start - room // 2) if _columns(_printable(raw[: start + length])) > room else 0
    before = _printable(raw[shift:start])
    shown = _fitting(_printable(raw[shift:]), room).rstrip()
    marked = _printable(raw[start : start + length])
    pad = " " * len(gutter)
    carets = "^" * max(1, min(_columns(marked), room - _columns(before)))
    return [f"{pad} |", f"{gutter} | {shown}", f"{pad} | {' ' * _columns(before)}{carets}"]


def _fitting(text: str, room: int) -> str:
    """As much of a text as fits into some columns."""
    used = 0
    for i, c in enumerate(text[: room + 1]):
        used += _columns(c)
        if used > room:
            return text[:i]
    return text[:room]


def _where(d: Diagnostic) -> str:
    """File, line and column; nothing for a file that could not be opened (its name stands in the message)."""
    return f"{d.span.file}:{d.span.line}:{d.span.column}: " if d.span and d.span.line else ""


def _places(d: Diagnostic) -> str:
    """The other places: line and column, and what is particular there."""

    def told(p: Place) -> str:
        at = f"{p.span.line}:{p.span.column}" if p.span is not None and p.span != d.span else ""
        return f"{at} ({_printable(p.note)})" if at and p.note else at or _printable(p.note)

    shown = [told(p) for p in d.also[: LIMIT - 1]]
    rest = len(d.also) - len(shown)
    return ", ".join(shown) + (f", and at {rest} other places" if rest else "")
