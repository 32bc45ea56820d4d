"""The tree as text: the portable subset, one variable a line, at most 150 columns."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import chain

from interlock.model.portable import readable
from interlock.st.ast import (
    HEADLINE,
    Assign,
    Block,
    Bool,
    Call,
    Compare,
    Declaration,
    Expression,
    Int,
    Name,
    Nary,
    Not,
    Statement,
    Task,
    Time,
    Unit,
)
from interlock.st.style import IEC, Style

MAX_COLUMNS = 150
DIRECTIVES = frozenset("@$#~{%&")
"""With these a comment begins that some tool obeys: `(*~ (OPC:1:visible) ~*)` in TwinCAT 2, `(* @END_DECLARATION *)` in
CODESYS 2.3, `(*$...*)` in compilers of the Pascal family."""


def comment(text: str, room: int | None = None) -> str:
    """A comment of so many characters at most that no note can end early, nor the part of an XML file where it stands.

    What counts is what is read of a text: a full-width `＊）` is read as `*)`.  None is a directive to a tool, either.
    """
    if not (text.isascii() and text.isprintable()):
        text = "".join(map(readable, text))
    if text.lstrip()[:1] in DIRECTIVES:
        text = f"- {text}"
    text = text[:room]
    if "*" in text or "]]>" in text:
        text = text.replace("(*", "( *").replace("*)", "* )").replace("]]>", "] ]>")
    return f"(* {text} *)"


def wrapped(line: str) -> Iterator[str]:
    """A long line of a comment in pieces, those after the first indented; a word that is longer is cut."""
    room, indent = MAX_COLUMNS - 10, "    "
    while len(line) > room:
        cut = line.rfind(" ", len(indent), room)
        cut = cut if cut > len(indent) else room
        yield line[:cut]
        line = f"{indent}{line[cut:].lstrip()}"
    yield line


def print_unit(unit: Unit, style: Style = IEC) -> str:
    """The whole file, newline at the end."""
    out = [comment(line) for line in (*unit.header, *chain.from_iterable(map(wrapped, unit.index)))]
    for block in unit.blocks:
        out.append("")
        out.extend(print_block(block, style))
    if unit.task is not None:
        out += ["", *_task(unit.task)]
    return "\n".join(out) + "\n"


def _task(t: Task) -> list[str]:
    """Says how often the program runs."""
    return [
        f"CONFIGURATION {t.configuration}",
        f"  RESOURCE {t.resource} ON PLC",
        f"    TASK {t.name}(INTERVAL := T#{t.interval_ms}ms, PRIORITY := 0);",
        f"    PROGRAM {t.instance} WITH {t.name} : {t.program};",
        "  END_RESOURCE",
        "END_CONFIGURATION",
    ]


def print_block(b: Block, style: Style = IEC) -> list[str]:
    """The lines of a block."""
    if b.kind == "STRUCT":
        return structure(b)
    return [*_head(b, style), *declarations(b, style), *_begin(style), *body(b, style), f"END_{b.kind}"]


def structure(b: Block, end: str = "END_STRUCT;") -> list[str]:
    """The lines of a structure."""
    note = [comment(b.note, HEADLINE)] if b.note else []
    return [f"TYPE {b.name} :", *note, "STRUCT", *declarations(b)[1:-1], end, "END_TYPE"]


def _head(b: Block, style: Style) -> list[str]:
    note = [comment(b.note, HEADLINE)] if b.note else []
    return [f"{b.kind} {style.block(b.name)}", *note]


def _begin(style: Style) -> list[str]:
    return ["BEGIN"] if style.begin else []


def declarations(b: Block, style: Style = IEC) -> list[str]:
    """The lines that declare a block's variables."""
    out: list[str] = []
    # one VAR part may not mix variables with and without an address
    located = tuple(d for d in b.locals if d.address)
    plain = tuple(d for d in b.locals if not d.address)
    handed = ("VAR_IN_OUT", b.handed)
    parts = (("VAR_INPUT", b.inputs), ("VAR_OUTPUT", b.outputs), handed, ("VAR", located), ("VAR", plain))
    for title, part in parts:
        if part:
            out += [title, *(_declaration(d, style) for d in part), "END_VAR"]
    return out


def body(b: Block, style: Style = IEC) -> list[str]:
    """The lines of a block's statements."""
    written = _Body(style)
    return [line for s in b.body for line in written.statement(s, "  ")]


def print_expression(x: Expression) -> str:
    """An expression as the portable text has it."""
    return _Body(IEC).expression(x, 0)


def _declaration(d: Declaration, style: Style) -> str:
    if d.type == "BOOL" and d.initial is None and not d.address:
        return _noted(f"  {d.name} : BOOL;", d.note)
    initial = f" := {_Body(IEC).expression(d.initial, 0)}" if d.initial is not None else ""
    note = ""
    if d.type == "TON":
        kind, note = style.timer, style.timer_note and f" {style.timer_note}"
    else:
        kind = d.type if d.type in ("BOOL", "INT") else style.block(d.type)
    where = f" AT {d.address}" if d.address else ""
    return _noted(f"  {d.name}{where}{note} : {kind}{initial};", d.note)


def _noted(line: str, note: str) -> str:
    if not note:
        return line
    room = MAX_COLUMNS - len(line) - 7
    return f"{line} {comment(note, room)}" if room > 8 else line


_RANK = {"OR": 1, "XOR": 1, "AND": 2}


class _Body:
    """Statements and expressions in one style."""

    def __init__(self, style: Style) -> None:
        self.local = style.local

    def statement(self, s: Statement, indent: str) -> list[str]:
        """The lines of a statement."""
        if isinstance(s, Assign):
            return self.assign(s, indent)
        if isinstance(s, Call):
            return self.call(s, indent)
        out: list[str] = []
        for condition, then in s.arms:
            head = f"{indent}{'ELSIF' if out else 'IF'} {self.expression(condition, 0)} THEN"
            out += self._arm(head, then, indent)
        if s.otherwise:
            out += self._arm(f"{indent}ELSE", s.otherwise, indent)
        return [*out, f"{indent}END_IF;"]

    def _arm(self, head: str, then: Sequence[Statement], indent: str) -> list[str]:
        """A condition and what is done: on one line where that is one short statement."""
        lines = [line for x in then for line in self.statement(x, indent + "  ")]
        if len(lines) == 1 and len(head) + len(lines[0]) - len(indent) - 1 <= MAX_COLUMNS - 10:
            return [f"{head} {lines[0].lstrip()}"]
        return [head, *lines]

    def assign(self, s: Assign, indent: str) -> list[str]:
        """An assignment; operands with notes stand on lines of their own."""
        head = f"{indent}{self.expression(s.target, 0)} :="
        notes = s.value.notes if isinstance(s.value, Nary) else ()
        line = "" if any(notes) else f"{head} {self.expression(s.value, 0)};"
        told = f" {comment(s.note)}" if s.note else ""
        if line and len(line) + len(told) <= MAX_COLUMNS - 10:
            return [line + told]
        before = [indent + comment(s.note, MAX_COLUMNS - 12)] if s.note else []
        if line and (len(line) <= MAX_COLUMNS - 10 or not isinstance(s.value, Nary)):
            return [*before, *_wrapped(line, "", indent)]
        assert isinstance(s.value, Nary)
        return [*before, *self._filled(head, s.value, indent)]

    def _filled(self, head: str, x: Nary, indent: str) -> list[str]:
        """Operands on as few lines as they need; one with a note ends its line."""
        out = [head]
        last = len(x.args) - 1
        for i, (arg, note) in enumerate(zip(x.args, x.notes or ("",) * (last + 1), strict=True)):
            text = f"{f'{x.op} ' if i else ''}{self.expression(arg, _RANK[x.op] + 1)}{';' if i == last else ''}"
            told = f" {comment(note)}" if note else ""
            if len(out[-1]) + len(text) + len(told) > MAX_COLUMNS - 10 or out[-1].endswith("*)"):
                out.append(f"{indent} ")
            out[-1] += f" {text}"
            out[-1:] = (
                [out[-1] + told] if len(out[-1] + told) <= MAX_COLUMNS else _wrapped(out[-1], note, f"{indent}  ")
            )
        return out

    def call(self, s: Call, indent: str) -> list[str]:
        """A call, as many parameters a line as there is room for."""
        params = [f"{n} := {self.expression(x, 0)}" for n, x in s.params]
        lines = [f"{indent}{self.local}{s.instance}("]
        for i, p in enumerate(params):
            text = p + ("" if i == len(params) - 1 else ", ")
            if len(lines[-1]) + len(text) > MAX_COLUMNS - 4:
                lines.append(indent + "  ")
            lines[-1] += text
        lines[-1] += ");"
        lines = [line.rstrip() for line in lines]
        if len(lines) == 1:
            lines[0] = _noted(lines[0], s.note)
        return lines

    def expression(self, x: Expression, outer: int) -> str:
        """Text of an expression; `outer` is the binding strength of what surrounds it."""
        if isinstance(x, Name):
            return self.local + ".".join(x.parts)
        if isinstance(x, Not):
            return f"NOT {self.expression(x.arg, 3)}"
        if isinstance(x, Bool):
            return "TRUE" if x.value else "FALSE"
        if isinstance(x, Int):
            return str(x.value)
        if isinstance(x, Time):
            return f"T#{x.ms // 1000}s" if x.ms % 1000 == 0 else f"T#{x.ms}ms"
        if isinstance(x, Compare):
            return f"({self.expression(x.left, 3)} {x.op} {self.expression(x.right, 3)})"
        inner = _RANK[x.op] + 1
        text = f" {x.op} ".join([self.expression(a, inner) for a in x.args])
        return f"({text})" if outer else text


def _wrapped(text: str, note: str, indent: str) -> list[str]:
    """A long line cut at spaces, its note before it."""
    out = [indent + comment(note, MAX_COLUMNS - 12)] if note else []
    while len(text) > MAX_COLUMNS - 10:
        cut = text.rindex(" ", 0, MAX_COLUMNS - 10)
        out.append(text[:cut])
        text = f"{indent}  {text[cut + 1 :]}"
    return [*out, text]
