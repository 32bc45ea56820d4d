"""SCL of Siemens: sources for STEP 7 classic (S7-300, S7-400) and for TIA Portal (S7-1200, S7-1500).

Variables lie in data blocks (`interlock.st.shared`).  A name in quotation marks stands for a block, for a member of a
data block, or in the mapping program for a terminal.  The forms are those of public manuals and of exported sources;
the tools were not at hand.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace

from interlock.dataclass import dataclass
from interlock.st.ast import Block, Declaration, Statement
from interlock.st.dialects.classic import Language, unprintable
from interlock.st.parser import NotInSubset, parse_unit
from interlock.st.printer import body, comment, declarations, wrapped
from interlock.st.shared import Frame, frame, names_in
from interlock.st.style import COMMENT, Style

_MARKED = Style(local="#")
_COMMENT = re.compile(COMMENT)
_QUOTED = re.compile(r'"(\w+)"(?:(\()|\."(\w+)"\(|\.(\w+))?', re.ASCII)


@dataclass(frozen=True)
class Scl:
    """What a tool wants.

    style: of declarations and names.  void: the type of a function without a result.  attributes: after the name of a
    block; data: after that of a data block.  named: a call of an instance names its block too.  cycle:
    what the organization block of each cycle is called; taken: what such blocks declare.
    """

    style: Style
    void: str = "VOID"
    attributes: tuple[str, ...] = ()
    data: tuple[str, ...] = ()
    named: bool = True
    cycle: str = "OB1"
    taken: tuple[str, ...] = ("VAR_TEMP", "  START_INFO : ARRAY[0..19] OF BYTE;", "END_VAR")

    def language(self) -> Language:
        """The language, for the files in which it stands."""
        return Language(".scl", comment, self.block, self.called, self.set, self.read, uncommented)

    # --- writing ---------------------------------------------------------------------------------

    def block(self, b: Block, known: Frame) -> list[str]:
        """The lines of a block."""
        if b.kind == "INSTANCE":
            return [f'DATA_BLOCK "{b.name}"', *self.data, f'"{b.locals[0].type}"', "BEGIN", "END_DATA_BLOCK"]
        note = [comment(x) for x in wrapped(b.note)] if b.note else []
        declared = declarations(b, self.style)
        if b.kind == "DATA_BLOCK":
            held = ["STRUCT", *declared[1:-1], "END_STRUCT;"]
            return [f'DATA_BLOCK "{b.name}"', *self.data, *note, *held, "BEGIN", "END_DATA_BLOCK"]
        own = {d.name for d in (*b.inputs, *b.outputs, *b.locals)}
        void = f" : {self.void}" if b.kind == "FUNCTION" else ""
        if b.kind == "FUNCTION":
            declared = ["VAR_TEMP" if x == "VAR" else x for x in declared]
        lines = [self._put(line, own, known) for s in b.body for line in _printed(s)]
        head = [f'{b.kind} "{b.name}"{void}', *self.attributes, *note]
        return [*head, *declared, "BEGIN", *lines, f"END_{b.kind}"]

    def _put(self, line: str, own: set[str], known: Frame) -> str:
        """A line with marked names, each as it is written in SCL."""

        def put(m: re.Match[str]) -> str:
            name, after = m[1], m[2] or ""
            if name in own:
                return f"{self.style.local}{name}{after}"
            if name in known.instances and after == "(" and self.named:
                return f'"{known.instances[name]}"."{name}"('
            return f'"{name}"{after}'

        return re.sub(r"(?<!\w)#(\w+)(\(|\.\w+)?", put, line, flags=re.ASCII)

    def called(self, function: str) -> list[str]:
        """What calls a function in each cycle."""
        return self._organization(self.cycle, f'"{function}"();')

    def set(self, number: int, data: str, variable: str, reset: Sequence[Declaration]) -> list[str]:
        """What sets a variable after a restart, and resets others: an organization block of a number."""
        to = {d.name: "0" if d.type == "INT" else "FALSE" for d in reset}
        values = {variable: "TRUE", **to}
        return self._organization(f"OB{number}", *(f'"{data}".{n} := {x};' for n, x in values.items()))

    def _organization(self, name: str, *statements: str) -> list[str]:
        head = [f"ORGANIZATION_BLOCK {name}", *self.attributes, *self.taken]
        return [*head, "BEGIN", *(f"  {x}" for x in statements), "END_ORGANIZATION_BLOCK"]

    # --- reading ---------------------------------------------------------------------------------

    def read(self, text: str, elsewhere: Sequence[Block]) -> list[Block]:
        """The blocks of a source in their order."""
        found: list[Block] = []
        text, at = uncommented(text), 0
        form = re.compile(r"(DATA_BLOCK|FUNCTION_BLOCK|FUNCTION) \"(\w+)\"(.*?)\nEND_\1\n", re.DOTALL | re.ASCII)
        for m in form.finditer(text):
            if m.start() != at:
                break
            kind, name, rest = m[1], m[2], m[3]
            found.append(self._data(name, rest) if kind == "DATA_BLOCK" else Block(name, (), (), (), (), rest, kind))
            at = m.end()
        if at != len(text) or not found:
            raise NotInSubset(f"something that is no block: {text[at : at + 40]!r}")
        known = frame([*elsewhere, *found])
        return [self._body(b, known) if b.kind in ("FUNCTION", "FUNCTION_BLOCK") else b for b in found]

    def _data(self, name: str, text: str) -> Block:
        """An instance, or a data block of its own."""
        data = "".join(f"{re.escape(x)}\n" for x in self.data)
        if m := re.fullmatch(rf"\n{data}\"(\w+)\"\nBEGIN", text, re.ASCII):
            return Block(name, (), (), (Declaration("OF", m[1]),), (), kind="INSTANCE")
        if m := re.fullmatch(rf"\n{data}STRUCT\n(.*)END_STRUCT;\nBEGIN", text, re.DOTALL):
            made = f'FUNCTION_BLOCK "X"\nVAR\n{m[1]}END_VAR\nBEGIN\nEND_FUNCTION_BLOCK\n'
            (held,) = parse_unit(made, self.style).blocks
            if any(d.type not in ("BOOL", "INT") for d in held.locals):
                raise NotInSubset(f"{name} holds what is neither BOOL nor INT")
            return Block(name, (), (), held.locals, (), kind="DATA_BLOCK")
        raise NotInSubset(f"{name} is neither an instance nor a data block as it is written")

    def _body(self, b: Block, known: Frame) -> Block:
        """A block whose text stands in its note; a name in quotes is a member, a call, or a terminal."""
        void = b.kind == "FUNCTION"
        start = "".join((f" : {self.void}" if void else "", "\n", *(f"{x}\n" for x in self.attributes)))
        text = b.note.removeprefix(start)
        if not b.note.startswith(start) or (void and re.search(r"\bVAR(_INPUT|_OUTPUT)?\n", text)):
            raise NotInSubset(f"{b.name} is no block as it is written")
        if void:
            text = text.replace("VAR_TEMP\n", "VAR\n")
        head, begin, rest = f"\n{text}".partition("\nBEGIN\n")
        wires: set[str] = set()

        def put(m: re.Match[str]) -> str:
            shown, name = self._resolved(b, m, known)
            if name:
                wires.add(name)
            return f"{self.style.local}{shown}"

        bare = set(re.findall(r"\w+", _QUOTED.sub("", rest)))
        if not begin or bare & {*known.data, *known.instances, *known.functions, *known.instances.values()}:
            raise NotInSubset(f"{b.name}: a name of a block without quotes, or no statement")
        lines = [f'FUNCTION_BLOCK "{b.name}"{head}', "BEGIN", _QUOTED.sub(put, rest), "END_FUNCTION_BLOCK", ""]
        (made,) = parse_unit("\n".join(lines), self.style).blocks
        own = {d.name for d in (*made.inputs, *made.outputs, *made.locals)}
        read = {n.parts[0] for s in made.body for n in names_in(s) if len(n.parts) == 1}
        if wires & own or read - own - wires:
            raise NotInSubset(f"{b.name}: {min(wires & own | (read - own - wires))} is not declared, or twice")
        return replace(made, kind=b.kind)

    def _resolved(self, b: Block, m: re.Match[str], known: Frame) -> tuple[str, str]:
        """What a name in quotes is in the tree, and the terminal that it stands for, if it does."""
        name, called, data, member = m.groups()
        if called and (name in known.functions or (not self.named and name in known.instances)):
            return f"{name}(", ""
        if data and self.named and known.instances.get(data) == name:
            return f"{data}(", ""
        if member and (name in known.data or name in known.instances):
            return f"{name}.{member}", ""
        if called or data or member or {name} & {*known.data, *known.instances, *known.functions}:
            raise NotInSubset(f"{b.name}: {m[0]} is not known")
        return name, name


def _printed(s: Statement) -> list[str]:
    """The lines of a statement with marked names."""
    return body(Block("", (), (), (), (s,)), _MARKED)


def uncommented(text: str) -> str:
    """Without comments and empty lines; what other tools might take for a comment is refused."""
    text = re.sub(r"[ \t]+$", "", _COMMENT.sub("", text), flags=re.MULTILINE)
    if not text.isascii() or any(x in text for x in ("//", "/*", "(*", "*)")) or unprintable(text, "\t"):
        raise NotInSubset("a comment of another kind")
    return re.sub(r"\n\n+", "\n", text).lstrip("\n")
