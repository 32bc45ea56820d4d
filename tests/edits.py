"""Random single edits of an emitted text: one token or one statement, anywhere in the code, never in a comment."""

from __future__ import annotations

import random
import re
from bisect import bisect_right
from collections.abc import Callable

_ST = re.compile(r"\(\*.*?\*\)|<documentation>.*?</documentation>|<\?xml.*?\?>|<fileHeader.*?/>", re.S)
_PYTHON = re.compile(r"^#.*$|  # .*$|\"\"\"[^\"]*\"\"\"", re.M)


def _code_spans(text: str, python: bool) -> list[tuple[int, int]]:
    """Where there is code."""
    spans, at = [], 0
    for m in (_PYTHON if python else _ST).finditer(text):
        spans.append((at, m.start()))
        at = m.end()
    return [*spans, (at, len(text))]


def _found(pattern: str, text: str, python: bool) -> list[re.Match[str]]:
    spans = _code_spans(text, python)
    starts = [a for a, _ in spans]
    out = []
    for m in re.finditer(pattern, text):
        k = bisect_right(starts, m.start()) - 1
        if m.end() <= spans[k][1]:
            out.append(m)
    return out


SORTS = "CLR|OCC|L|K|U|FREE|QN|QR|CN|CR|G|A|B|WF|WL|S"
Edit = Callable[[str, random.Random, bool], str | None]


def _replaced(pattern: str, new: Callable[[re.Match[str], random.Random], str]) -> Edit:
    def edit(text: str, rng: random.Random, python: bool) -> str | None:
        found = _found(pattern, text, python)
        if not found:
            return None
        m = rng.choice(found)
        return text[: m.start()] + new(m, rng) + text[m.end() :]

    return edit


def _swapped_name(text: str, rng: random.Random, python: bool) -> str | None:
    """Another variable of the same sort in the place of one."""
    found = _found(rf"(?<![\w.\"'#])#?(?:{SORTS})_\w+(?=[ )\n;,])", text, python)
    if not found:
        return None
    m = rng.choice(found)
    others = sorted({x.group() for x in found if x.group() != m.group()})
    return text[: m.start()] + rng.choice(others) + text[m.end() :] if others else None


def _dropped_statement(text: str, rng: random.Random, python: bool) -> str | None:
    """One whole statement less."""
    pattern = r"\n        \w+ = [^\n]*" if python else r"\n  #?\w+ := [^;]*;"
    found = [m for m in re.finditer(pattern, text) if " : " not in m.group()]
    if not found:
        return None
    m = rng.choice(found)
    return text[: m.start()] + text[m.end() :]


def _exchanged_statements(text: str, rng: random.Random, python: bool) -> str | None:
    """Two neighbouring statements in the other order."""
    one = r"(\n        \w+ = [^\n]*)" if python else r"(\n  #?\w+ := [^;\n(]*;)"
    pattern = one + one
    found = list(re.finditer(pattern, text))
    if not found:
        return None
    m = rng.choice(found)
    return text[: m.start()] + m[2] + m[1] + text[m.end() :]


ST_EDITS: dict[str, Edit] = {
    "AND for OR": _replaced(r"\bOR\b", lambda m, r: "AND"),
    "OR for AND": _replaced(r"\bAND\b", lambda m, r: "OR"),
    "NOT dropped": _replaced(r"\bNOT ", lambda m, r: ""),
    "NOT added": _replaced(r"(?<=AND )(?=#?[A-Z])(?!NOT)", lambda m, r: "NOT "),
    "operand swapped": _swapped_name,
    "operand dropped": _replaced(r"\n    AND [^;\n]*(?=\n)", lambda m, r: ""),
    "statement dropped": _dropped_statement,
    "statements exchanged": _exchanged_statements,
    "initial value": _replaced(r"(?:TRUE|FALSE)(?=;|\")", lambda m, r: "FALSE" if m.group() == "TRUE" else "TRUE"),
    "time": _replaced(r"T#(\d+)s", lambda m, r: f"T#{int(m[1]) + r.choice((-1, 1))}s"),
    "number": _replaced(r"(?<=REQ = )\d+", lambda m, r: str(int(m.group()) + r.choice((-1, 1)))),
}

PYTHON_EDITS: dict[str, Edit] = {
    "and for or": _replaced(r"\bor\b", lambda m, r: "and"),
    "or for and": _replaced(r"\band\b", lambda m, r: "or"),
    "not dropped": _replaced(r"\bnot ", lambda m, r: ""),
    "operand swapped": _swapped_name,
    "statement dropped": _dropped_statement,
    "statements exchanged": _exchanged_statements,
    "initial value": _replaced(r"\b(?:True|False)\b(?=,)", lambda m, r: "False" if m.group() == "True" else "True"),
    "time": _replaced(r"(?<=': )\d{4,}(?=,)|(?<=\": )\d{4,}(?=,)", lambda m, r: str(int(m.group()) + 1000)),
    "number": _replaced(r"(?<=REQ == )\d+", lambda m, r: str(int(m.group()) + r.choice((-1, 1)))),
}
