"""The tree as text: the portable subset, one variable a line, at most 150 columns."""

from __future__ import annotations

from interlock.st.ast import (
    Assign,
    Block,
    Bool,
    Call,
    Compare,
    Declaration,
    Expression,
    If,
    Int,
    Name,
    Nary,
    Not,
    Statement,
    Time,
    Unit,
)

MAX_COLUMNS = 150


def comment(text: str) -> str:
    """A comment that no name or note can end early."""
    clean = text.replace("(*", "( *").replace("*)", "* )")
    return "(* " + "".join(c if 32 <= ord(c) < 127 else "?" for c in clean) + " *)"


def print_unit(unit: Unit) -> str:
    """The whole file, newline at the end."""
    out = [comment(line) for line in unit.header]
    for block in unit.blocks:
        out.append("")
        out.extend(_block(block))
    return "\n".join(out) + "\n"


def _block(b: Block) -> list[str]:
    out = [f"FUNCTION_BLOCK {b.name}"]
    if b.note:
        out.append(comment(b.note[: MAX_COLUMNS - 10]))
    for title, part in (("VAR_INPUT", b.inputs), ("VAR_OUTPUT", b.outputs), ("VAR", b.locals)):
        if part:
            out += [title, *(_declaration(d) for d in part), "END_VAR"]
    for s in b.body:
        out.extend(_statement(s, "  "))
    return [*out, "END_FUNCTION_BLOCK"]


def _declaration(d: Declaration) -> str:
    initial = f" := {_expression(d.initial, 0)}" if d.initial is not None else ""
    line = f"  {d.name} : {d.type}{initial};"
    return _noted(line, d.note)


def _noted(line: str, note: str) -> str:
    if not note:
        return line
    room = MAX_COLUMNS - len(line) - 7
    return f"{line} {comment(note[:room])}" if room > 8 else line


def _statement(s: Statement, indent: str) -> list[str]:
    if isinstance(s, Assign):
        return _assign(s, indent)
    if isinstance(s, Call):
        return _call(s, indent)
    out = [f"{indent}IF {_expression(s.condition, 0)} THEN"]
    for x in s.then:
        out.extend(_statement(x, indent + "  "))
    if s.otherwise:
        out.append(f"{indent}ELSE")
        for x in s.otherwise:
            out.extend(_statement(x, indent + "  "))
    return [*out, f"{indent}END_IF;"]


def _assign(s: Assign, indent: str) -> list[str]:
    if not isinstance(s.value, Nary) or not any(s.value.notes):
        text = f"{indent}{s.target} := {_expression(s.value, 0)};"
        return [_noted(text, s.note)] if len(text) <= MAX_COLUMNS - 10 else _wrapped(text, s.note, indent)
    out = [indent + comment(s.note[: MAX_COLUMNS - 12])] if s.note else []
    last = len(s.value.args) - 1
    for i, (x, note) in enumerate(zip(s.value.args, s.value.notes, strict=True)):
        lead = f"{indent}{s.target} := " if i == 0 else f"{indent}  {s.value.op} "
        text = f"{lead}{_expression(x, 2)}{';' if i == last else ''}"
        if len(text) <= MAX_COLUMNS:
            out.append(_noted(text, note))
        else:
            out.extend(_wrapped(text, note, f"{indent}  "))
    return out


def _wrapped(text: str, note: str, indent: str) -> list[str]:
    """A long line cut at spaces, its note before it."""
    out = [indent + comment(note[: MAX_COLUMNS - 12])] if note else []
    while len(text) > MAX_COLUMNS - 10:
        cut = text.rindex(" ", 0, MAX_COLUMNS - 10)
        out.append(text[:cut])
        text = f"{indent}  {text[cut + 1 :]}"
    return [*out, text]


def _call(s: Call, indent: str) -> list[str]:
    params = [f"{n} := {_expression(x, 0)}" for n, x in s.params]
    lines = [f"{indent}{s.instance}("]
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


_RANK = {"OR": 1, "XOR": 1, "AND": 2}


def _expression(x: Expression, outer: int) -> str:
    """Text of an expression; `outer` is the binding strength of what surrounds it."""
    if isinstance(x, Name):
        return str(x)
    if isinstance(x, Bool):
        return "TRUE" if x.value else "FALSE"
    if isinstance(x, Int):
        return str(x.value)
    if isinstance(x, Time):
        return f"T#{x.ms // 1000}s" if x.ms % 1000 == 0 else f"T#{x.ms}ms"
    if isinstance(x, Not):
        return f"NOT {_expression(x.arg, 3)}"
    if isinstance(x, Compare):
        return f"({_expression(x.left, 3)} {x.op} {_expression(x.right, 3)})"
    body = f" {x.op} ".join(_expression(a, _RANK[x.op] + 1) for a in x.args)
    return f"({body})" if outer else body


__all__ = ["If", "comment", "print_unit"]
