"""SCL of Siemens S7-300 and S7-400: sources for STEP 7 classic, with their symbol table.

Its data blocks keep their values over a restart: among the inputs is RESTART (see `interlock.st.restart`), which OB100
sets.  Variables lie in data blocks, blocks are small, since a CPU 313 takes 8 KB a block.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace

from interlock.st.ast import Block, Declaration, Statement
from interlock.st.dialects.classic import Language, wrapped
from interlock.st.dialects.dialect import Dialect
from interlock.st.dialects.siemens import uncommented
from interlock.st.parser import NotInSubset, parse_unit
from interlock.st.printer import body, comment, declarations
from interlock.st.program import Runs
from interlock.st.shared import Frame, frame, names_in, shared
from interlock.st.style import Style

STYLE = Style(quoted=True, begin=True, timer='"TON"')
_MARKED = Style(local="#")
_QUOTED = re.compile(r'"(\w+)"(?:(\()|\."(\w+)"\(|\.(\w+))?', re.ASCII)


def _block(b: Block, known: Frame) -> list[str]:
    """The lines of a block."""
    if b.kind == "INSTANCE":
        return [f'DATA_BLOCK "{b.name}"', f'"{b.locals[0].type}"', "BEGIN", "END_DATA_BLOCK"]
    note = [comment(x) for x in wrapped(b.note)] if b.note else []
    declared = declarations(b, STYLE)
    if b.kind == "DATA_BLOCK":
        return [f'DATA_BLOCK "{b.name}"', *note, "STRUCT", *declared[1:-1], "END_STRUCT;", "BEGIN", "END_DATA_BLOCK"]
    own = {d.name for d in (*b.inputs, *b.outputs, *b.locals)}
    void = " : VOID" if b.kind == "FUNCTION" else ""
    if b.kind == "FUNCTION":
        declared = ["VAR_TEMP" if x == "VAR" else x for x in declared]
    lines = [_put(line, own, known) for s in b.body for line in _printed(s)]
    return [f'{b.kind} "{b.name}"{void}', *note, *declared, "BEGIN", *lines, f"END_{b.kind}"]


def _printed(s: Statement) -> list[str]:
    """The lines of a statement with marked names."""
    return body(Block("", (), (), (), (s,)), _MARKED)


def _put(line: str, own: set[str], known: Frame) -> str:
    """A line with marked names, each as it is written in SCL."""

    def put(m: re.Match[str]) -> str:
        name, after = m[1], m[2] or ""
        if name in own:
            return f"{name}{after}"
        if name in known.instances and after == "(":
            return f'"{known.instances[name]}"."{name}"('
        return f'"{name}"{after}'

    return re.sub(r"(?<!\w)#(\w+)(\(|\.\w+)?", put, line, flags=re.ASCII)


def _cycle(function: str) -> list[str]:
    return _organization("OB1", f'"{function}"();')


def _startup(data: str, variable: str) -> list[str]:
    return _organization("OB100", f'"{data}".{variable} := TRUE;')


def _organization(name: str, statement: str) -> list[str]:
    taken = ["VAR_TEMP", "  START_INFO : ARRAY[0..19] OF BYTE;", "END_VAR"]
    return [f"ORGANIZATION_BLOCK {name}", *taken, "BEGIN", f"  {statement}", "END_ORGANIZATION_BLOCK"]


def _read(text: str, elsewhere: Sequence[Block]) -> list[Block]:
    """The blocks of a source in their order."""
    found: list[Block] = []
    sections = []
    text, at = uncommented(text), 0
    for m in re.finditer(r"(DATA_BLOCK|FUNCTION_BLOCK|FUNCTION) \"(\w+)\"(.*?)\nEND_\1\n", text, re.DOTALL | re.ASCII):
        if m.start() != at:
            break
        sections.append((m[1], m[2], m[3]))
        at = m.end()
    if at != len(text) or not sections:
        raise NotInSubset(f"something that is no block: {text[at : at + 40]!r}")
    for kind, name, rest in sections:
        if kind == "DATA_BLOCK":
            found.append(_data(name, rest))
        else:
            found.append(Block(name, (), (), (), (), rest, kind))
    known = frame([*elsewhere, *found])
    return [_body(b, known) if b.kind in ("FUNCTION", "FUNCTION_BLOCK") else b for b in found]


def _data(name: str, text: str) -> Block:
    """An instance, or a data block of its own."""
    if m := re.fullmatch(r"\n\"(\w+)\"\nBEGIN", text, re.ASCII):
        return Block(name, (), (), (Declaration("OF", m[1]),), (), kind="INSTANCE")
    if m := re.fullmatch(r"\nSTRUCT\n(.*)END_STRUCT;\nBEGIN", text, re.DOTALL):
        (held,) = parse_unit(f'FUNCTION_BLOCK "X"\nVAR\n{m[1]}END_VAR\nBEGIN\nEND_FUNCTION_BLOCK\n', STYLE).blocks
        if any(d.type not in ("BOOL", "INT") for d in held.locals):
            raise NotInSubset(f"{name} holds what is neither BOOL nor INT")
        return Block(name, (), (), held.locals, (), kind="DATA_BLOCK")
    raise NotInSubset(f"{name} is neither an instance nor a data block as it is written")


def _body(b: Block, known: Frame) -> Block:
    """A block whose text stands in its note; a name in quotes is a member, a call, or a terminal."""
    text, void = b.note, b.kind == "FUNCTION"
    if (void and not text.startswith(" : VOID\n")) or (void and re.search(r"\bVAR(_INPUT|_OUTPUT)?\n", text)):
        raise NotInSubset(f"{b.name} is no function as it is written")
    head, begin, rest = (
        text.removeprefix(" : VOID")
        .replace("VAR_TEMP\n", "VAR\n" if void else "VAR_TEMP\n")
        .partition("BEGIN\n" if "\nBEGIN\n" in text else "\0")
    )
    wires: set[str] = set()

    def put(m: re.Match[str]) -> str:
        name, called, data, member = m.groups()
        if called and name in known.functions:
            return f"{name}("
        if data and known.instances.get(data) == name:
            return f"{data}("
        if member and (name in known.data or name in known.instances):
            return f"{name}.{member}"
        if called or data or member:
            raise NotInSubset(f"{b.name}: {m[0]} is not known")
        wires.add(name)
        return name

    bare = set(re.findall(r"\w+", _QUOTED.sub("", rest)))
    if not begin or bare & {*known.data, *known.instances, *known.functions, *known.instances.values()}:
        raise NotInSubset(f"{b.name}: a name of a block without quotes, or no statement")
    lines = [f'FUNCTION_BLOCK "{b.name}"', f"{head}BEGIN", _QUOTED.sub(put, rest), "END_FUNCTION_BLOCK", ""]
    (made,) = parse_unit("\n".join(lines), STYLE).blocks
    own = {d.name for d in (*made.inputs, *made.outputs, *made.locals)}
    read = {n.parts[0] for s in made.body for n in names_in(s) if len(n.parts) == 1}
    if wires & own or read - own - wires:
        raise NotInSubset(f"{b.name}: {min(wires & own | (read - own - wires))} is not declared, or twice")
    return replace(made, kind=b.kind)


LANGUAGE = Language(".scl", comment, _block, _cycle, _startup, _read, uncommented)

DIALECT = Dialect(
    "scl300",
    "Siemens S7-300/400, STEP 7 classic sources",
    LANGUAGE.write,
    LANGUAGE.read_files,
    restart=True,
    runs=Runs.CYCLE,
    form=shared,
    places=True,
)
