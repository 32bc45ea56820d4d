"""The text of a file's bytes: UTF-8, or what else they seem to be.  IL1002."""

from __future__ import annotations

import re

from interlock.diag import Sink, Span

_BOMS = {b"\xff\xfe": "utf-16", b"\xfe\xff": "utf-16", b"\x00\x00\xfe\xff": "utf-32"}
_NAMES = {
    "utf-16": "UTF-16",
    "utf-16le": "UTF-16",
    "utf-16be": "UTF-16",
    "utf-32": "UTF-32",
    "gb18030": "GBK",
    "cp1252": "Windows-1252 (Western European)",
}
_KINDS = {b"%PDF": "a PDF", b"PK\x03\x04": "a workbook or another zip", b"\x89PNG": "a picture", b"AC10": "a drawing"}


def _without_mark(data: bytes) -> str | None:
    """UTF-16 without a byte order mark: every other byte of its first line is zero."""
    head = data[:64]
    for coding, zeros in (("utf-16le", head[1::2]), ("utf-16be", head[::2])):
        if (
            len(zeros) > 3
            and len(data) % 2 == 0
            and zeros.count(0) > 0.9 * len(zeros)
            and head.count(0) == zeros.count(0)
        ):
            return coding
    return None


def decode(path: str, data: bytes, sink: Sink, what: str = "layout") -> tuple[str | None, str]:
    """The text, or None with IL1002; and what to show of the file: the text as its author probably sees it.

    `what`: what the file is to be.
    """
    unmarked, at = _without_mark(data), 0
    try:
        text = _lines(data.decode("utf-8-sig"))
        if unmarked is None:
            return text, text
    except UnicodeDecodeError as error:
        at = error.start
    for head, kind in _KINDS.items():
        if data.startswith(head):
            _report(sink, f"{path} is not UTF-8 text: it is {kind}", Span(path, 0, 0), f"a {what} is a text file")
            return None, ""
    coding = _coding(data) or unmarked
    if coding is None:
        return None, _no_text(path, data, at, sink, what)
    shown = _lines(data.decode(coding, "replace"))
    fix = f"save it as UTF-8 (`Save as`, encoding UTF-8), or run `iconv -f {coding.upper()} -t UTF-8 {path} > new.yaml`"
    said = f"the file is not UTF-8 text; it looks like {_NAMES[coding]}"
    if coding.startswith("utf"):
        _report(sink, said, Span(path, 1, 1, max(1, len(shown.split("\n")[0]))), fix)
        return None, shown
    for i, line in enumerate(shown.split("\n")):
        for found in re.finditer(r"[^\x00-\x7f]+", line):
            _report(sink, said, Span(path, i + 1, found.start() + 1, len(found[0])), fix)
    return None, shown


def _no_text(path: str, data: bytes, at: int, sink: Sink, what: str) -> str:
    """Report bytes of no coding that is known here, at the first that is not UTF-8; what to show of the file."""
    if b"\x00" in data:
        said = f"{path} is not UTF-8 text: it holds zero bytes, as drawings and programs do, and no text"
        _report(
            sink,
            said,
            Span(path, 0, 0),
            f"a {what} is a text file; name that, or save this one as text, encoding UTF-8",
        )
        return ""
    before, shown = (_lines(part.decode("utf-8-sig", "replace")) for part in (data[:at], data))
    said = f"the file is not UTF-8 text: the byte {data[at]} here (hexadecimal {data[at]:02X}) is no character of it"
    fix = "open it in the editor that wrote it, and save it as UTF-8 (`Save as`, encoding UTF-8)"
    _report(sink, said, Span(path, before.count("\n") + 1, len(before.rpartition("\n")[2]) + 1), fix)
    return shown


def _report(sink: Sink, said: str, span: Span, fix: str) -> None:
    sink.add("IL1002", said, span, fix)


def _lines(text: str) -> str:
    """With ends of lines of one kind.  A carriage return alone ends a line where all lines end so; among others it is
    kept, as editors and terminals disagree about it."""
    text = text.replace("\r\n", "\n")
    return text if "\n" in text else text.replace("\r", "\n")


def _coding(data: bytes) -> str | None:
    """What an editor of another language may have saved: a guess by byte order mark, zeros, and pairs of high bytes."""
    for mark, coding in _BOMS.items():
        if data.startswith(mark):
            return coding
    if b"\x00" in data:
        return None
    runs = re.findall(rb"[\x80-\xff]+", data)
    for coding, plausible in (("gb18030", all(len(r) % 2 == 0 for r in runs)), ("cp1252", True)):
        try:
            data.decode(coding)
        except UnicodeDecodeError:
            continue
        if plausible:
            return coding
    return None
