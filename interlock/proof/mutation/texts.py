"""Single edits of the emitted texts: the proof that text equals controller must refute each that changes the meaning.

An edit is one token, name or statement, anywhere in the code, never in a comment.  A text that is not read any more
counts as refuted: nothing is emitted from it.
"""

from __future__ import annotations

import re
from bisect import bisect_right
from collections.abc import Callable, Iterator

from interlock.dataclass import dataclass
from interlock.emit.python.runtime import runtime_py
from interlock.logic.controller import Controller
from interlock.proof.equivalence.python_text import compare_runtime
from interlock.proof.equivalence.structured_text import compare_dialect
from interlock.proof.mutation.judge import Fate, Verdict
from interlock.proof.mutation.points import Mutation
from interlock.st.delivery import write_st
from interlock.st.dialects import BY_NAME

_ST = re.compile(r"\(\*.*?\*\)|<documentation>.*?</documentation>|<\?xml.*?\?>|<fileHeader.*?/>", re.S)
_PYTHON = re.compile(r"^#.*$|  # .*$|\"\"\"[^\"]*\"\"\"", re.M)
_SORTS = "CLR|OCC|L|K|U|FREE|QN|QR|CN|CR|G|A|B|WF|WL|S"


@dataclass(frozen=True)
class Place:
    """Where a text can be edited, and what may stand there instead."""

    start: int
    end: int
    instead: tuple[str, ...]

    def edited(self, text: str, new: str) -> str:
        """The text with the replacement."""
        return text[: self.start] + new + text[self.end :]


Edit = Callable[[str, bool], list[Place]]
"""All places of one kind of edit in a text (True: Python)."""


def _matches(pattern: str, text: str, python: bool) -> list[re.Match[str]]:
    """Matches that lie in code."""
    spans, at = [], 0
    for m in (_PYTHON if python else _ST).finditer(text):
        spans.append((at, m.start()))
        at = m.end()
    spans.append((at, len(text)))
    starts = [a for a, _ in spans]
    found = re.finditer(pattern, text)
    return [m for m in found if m.end() <= spans[bisect_right(starts, m.start()) - 1][1]]


def _replaced(pattern: str, new: Callable[[re.Match[str]], tuple[str, ...]]) -> Edit:
    def places(text: str, python: bool) -> list[Place]:
        return [Place(m.start(), m.end(), new(m)) for m in _matches(pattern, text, python)]

    return places


def _swapped_name(text: str, python: bool) -> list[Place]:
    """Another variable of the same sort in the place of one."""
    found = _matches(rf"(?<![\w.\"'#])#?(?:D\.|INP\.)?(?:{_SORTS})_\w+(?=[ )\n;,])", text, python)
    names = sorted({m.group() for m in found})
    out = []
    for n, m in enumerate(found):
        others = [x for x in names if x != m.group()]
        turned = others[n % len(others) :] + others[: n % len(others)] if others else []
        out.append(Place(m.start(), m.end(), tuple(turned)))
    return [p for p in out if p.instead]


def _dropped_statement(text: str, python: bool) -> list[Place]:
    """One whole statement less."""
    pattern = r"\n        \w+ = [^\n]*" if python else r"\n  #?[\w.]+ := [^;]*;"
    return [Place(m.start(), m.end(), ("",)) for m in re.finditer(pattern, text) if " : " not in m.group()]


def _exchanged_statements(text: str, python: bool) -> list[Place]:
    """Two neighbouring statements in the other order."""
    one = r"(\n        \w+ = [^\n]*)" if python else r"(\n  #?[\w.]+ := [^;\n(]*;)"
    return [Place(m.start(), m.end(), (m[2] + m[1],)) for m in re.finditer(one + one, text)]


def _other(word: str, a: str, b: str) -> tuple[str, ...]:
    return (b if word == a else a,)


ST_EDITS: dict[str, Edit] = {
    "text-and-for-or": _replaced(r"\bOR\b", lambda m: ("AND",)),
    "text-or-for-and": _replaced(r"\bAND\b", lambda m: ("OR",)),
    "text-not-dropped": _replaced(r"\bNOT ", lambda m: ("",)),
    "text-not-added": _replaced(r"(?<=AND )(?=#?[A-Z])(?!NOT)", lambda m: ("NOT ",)),
    "text-operand-swapped": _swapped_name,
    "text-operand-dropped": _replaced(r"\s+AND (?:NOT )?#?[A-Z][\w.]*(?=[\s;)])", lambda m: ("",)),
    "text-statement-dropped": _dropped_statement,
    "text-statements-exchanged": _exchanged_statements,
    "text-initial-value": _replaced(r"(?:TRUE|FALSE)(?=;|\")", lambda m: _other(m.group(), "TRUE", "FALSE")),
    "text-time": _replaced(r"T#(\d+)s", lambda m: (f"T#{int(m[1]) - 1}s", f"T#{int(m[1]) + 1}s")),
    "text-number": _replaced(r"(?<=REQ = )\d+", lambda m: (str(int(m.group()) - 1), str(int(m.group()) + 1))),
}

PYTHON_EDITS: dict[str, Edit] = {
    "runtime-and-for-or": _replaced(r"\bor\b", lambda m: ("and",)),
    "runtime-or-for-and": _replaced(r"\band\b", lambda m: ("or",)),
    "runtime-not-dropped": _replaced(r"\bnot ", lambda m: ("",)),
    "runtime-operand-swapped": _swapped_name,
    "runtime-statement-dropped": _dropped_statement,
    "runtime-statements-exchanged": _exchanged_statements,
    "runtime-initial-value": _replaced(r"\b(?:True|False)\b(?=,)", lambda m: _other(m.group(), "True", "False")),
    "runtime-time": _replaced(r"(?<=': )\d{4,}(?=,)|(?<=\": )\d{4,}(?=,)", lambda m: (str(int(m.group()) + 1000),)),
    "runtime-number": _replaced(r"(?<=REQ == )\d+", lambda m: (str(int(m.group()) - 1), str(int(m.group()) + 1))),
}

TEXT_KINDS: tuple[str, ...] = (*ST_EDITS, *PYTHON_EDITS)


TEXT_FAMILIES = frozenset([*ST_EDITS, *PYTHON_EDITS])
"""The families of `text_mutants`."""


def text_mutants(controller: Controller, sample: int) -> Iterator[tuple[Mutation, Verdict]]:
    """Up to `sample` evenly spread edits of each kind (0: all), in the portable text and in the Python runtime."""
    iec = BY_NAME["iec"]
    files = write_st(controller, iec, ["edited"])
    runtime = runtime_py(controller, ["edited"])
    for kind, edit in (*ST_EDITS.items(), *PYTHON_EDITS.items()):
        python = kind in PYTHON_EDITS
        texts = {"runtime.py": runtime} if python else files
        for file, place in _spread([(f, p) for f in sorted(texts) for p in edit(texts[f], python)], sample):
            changed = place.edited(texts[file], place.instead[0])
            found = (
                compare_runtime(controller, changed)
                if python
                else compare_dialect(controller, iec, {**files, file: changed})
            )
            line = texts[file].count("\n", 0, place.start) + 1
            differs = ", ".join(f"differs at {d.name}" for d in found.differences[:3])
            fate = Fate.EQUIVALENT if found.proved else Fate.TEXT
            yield Mutation(kind, kind, (f"{file}:{line}",), lambda: controller), Verdict(fate, differs)


def _spread(places: list[tuple[str, Place]], sample: int) -> Iterator[tuple[str, Place]]:
    step = max(1, -(-len(places) // sample)) if sample else 1
    yield from places[::step]
