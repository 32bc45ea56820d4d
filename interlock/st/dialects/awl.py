"""STL (AWL) of Siemens S7-300 and S7-400: sources for controllers without S7-SCL, in English mnemonics.

An assignment is a network: A and AN, O and ON, brackets, then = ; numbers by L, T and ==I; a condition ends in JCN, a
branch in JU, each label stands at a NOP.  So every statement has one form, and the reader takes each back to the
statement that it was.  Variables lie in data blocks, as in the SCL for these controllers, and are named, not addressed.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

from interlock.dataclass import dataclass
from interlock.model.portable import readable
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
)
from interlock.st.dialects.classic import Language, unprintable
from interlock.st.dialects.dialect import Dialect, Unsupported
from interlock.st.parser import NotInSubset, parse_unit
from interlock.st.printer import declarations, print_expression, wrapped
from interlock.st.program import Runs
from interlock.st.shared import Frame, frame, shared
from interlock.st.style import Style

STYLE = Style(quoted=True, begin=True, timer='"TON"')
TITLE = 64
"""Characters of a title."""
_JOIN = {"AND": "A", "OR": "O"}


def _plain(text: str) -> str:
    """In ASCII, with nothing that begins or ends a comment of another kind."""
    return "".join(map(readable, text)).replace("*", " * ")


def _comment(text: str) -> str:
    """A comment to the end of the line."""
    return f"// {_plain(text)}"


# --- writing -------------------------------------------------------------------------------------


def _block(b: Block, known: Frame) -> list[str]:
    """The lines of a block."""
    if b.kind == "INSTANCE":
        return [f'DATA_BLOCK "{b.name}"', f'"{b.locals[0].type}"', "BEGIN", "END_DATA_BLOCK"]
    note = [_comment(x) for x in wrapped(b.note)] if b.note else []
    declared = [re.sub(r" \(\* (.*) \*\)$", lambda m: f" {_comment(m[1])}", x) for x in declarations(b, STYLE)]
    if b.kind == "DATA_BLOCK":
        return [f'DATA_BLOCK "{b.name}"', *note, "STRUCT", *declared[1:-1], "END_STRUCT;", "BEGIN", "END_DATA_BLOCK"]
    void = " : VOID" if b.kind == "FUNCTION" else ""
    if b.kind == "FUNCTION":
        declared = ["VAR_TEMP" if x == "VAR" else x for x in declared]
    lines = list(_Writer(b, known).lines())
    return [f'{b.kind} "{b.name}"{void}', *note, *declared, "BEGIN", *lines, f"END_{b.kind}"]


class _Writer:
    """The statements of a block as instructions."""

    def __init__(self, b: Block, known: Frame) -> None:
        self.block, self.known = b, known
        self.own = {d.name for d in (*b.inputs, *b.outputs, *b.locals)}
        self.numbers = {d.name for d in (*b.inputs, *b.outputs, *b.locals) if d.type == "INT"}
        self.labels = 0

    def lines(self) -> Iterator[str]:
        """Networks."""
        for s in self.block.body:
            yield "NETWORK"
            if s_note := getattr(s, "note", ""):
                yield f"TITLE = {_plain(s_note)[:TITLE]}"
            yield from self._statement(s)

    def _place(self, n: Name) -> str:
        first, *rest = n.parts
        if first in self.own:
            return "#" + ".".join(n.parts)
        return ".".join([f'"{first}"', *rest])

    def _label(self) -> str:
        self.labels += 1
        if self.labels > 999:
            raise Unsupported(f"{self.block.name}: more than 999 jumps in a block")
        return f"M{self.labels:03d}"

    def _is_number(self, n: Name) -> bool:
        first = n.parts[0]
        if first in self.own:
            return first in self.numbers
        return (first, n.parts[-1]) in self.known.numbers

    def _statement(self, s: Statement) -> Iterator[str]:
        if isinstance(s, Call):
            yield self._call(s)
        elif isinstance(s, If):
            yield from self._branch(s)
        elif self._is_number(s.target):
            yield _line("L", self._number(s.value))
            yield _line("T", self._place(s.target))
        else:
            yield from self._logic(s.value)
            yield _line("=", self._place(s.target))

    def _number(self, x: Expression) -> str:
        if isinstance(x, Int):
            return str(x.value)
        if isinstance(x, Name):
            return self._place(x)
        raise Unsupported("a number that is computed")

    def _call(self, s: Call) -> str:
        if s.instance in self.own:
            called = f"#{s.instance}"
        elif s.instance in self.known.instances:
            called = f'"{self.known.instances[s.instance]}", "{s.instance}"'
        else:
            called = f'"{s.instance}"'
        if not s.params:
            return _line("CALL", called)
        params = ", ".join(f"{n} := {self._given(x)}" for n, x in s.params)
        return _line("CALL", f"{called} ({params})")

    def _given(self, x: Expression) -> str:
        if isinstance(x, Name):
            return self._place(x)
        if isinstance(x, Time):
            return print_expression(x)
        raise Unsupported("a parameter that is computed")

    def _branch(self, s: If) -> Iterator[str]:
        end = self._label()
        for k, (condition, then) in enumerate(s.arms, 1):
            last = k == len(s.arms) and not s.otherwise
            after = end if last else self._label()
            yield from self._logic(condition)
            yield _line("JCN", after)
            for x in then:
                yield from self._statement(x)
            if not last:
                yield _line("JU", end)
                yield _line("NOP", "0", after)
        for x in s.otherwise:
            yield from self._statement(x)
        yield _line("NOP", "0", end)

    def _logic(self, x: Expression) -> Iterator[str]:
        """What leaves the value in the RLO."""
        if isinstance(x, Bool):
            yield _line("SET" if x.value else "CLR")
        elif isinstance(x, Compare):
            yield from self._compare(x)
        elif isinstance(x, Nary):
            notes = x.notes or ("",) * len(x.args)
            for a, note in zip(x.args, notes, strict=True):
                yield from self._operand(_JOIN[x.op], a, note)
        else:
            yield from self._operand("A", x, "")

    def _operand(self, letter: str, x: Expression, note: str) -> Iterator[str]:
        inner, letter = (x.arg, f"{letter}N") if isinstance(x, Not) else (x, letter)
        if isinstance(inner, Name):
            yield _line(letter, self._place(inner), note=note)
        elif isinstance(inner, Nary | Compare | Bool):
            yield _line(f"{letter}(", note=note)
            yield from self._logic(inner)
            yield _line(")")
        else:
            raise Unsupported("an operand that is neither a variable nor a condition")

    def _compare(self, x: Compare) -> Iterator[str]:
        if x.op != "=":
            raise Unsupported(f"a comparison by {x.op}")
        yield _line("L", self._number(x.left))
        yield _line("L", self._number(x.right))
        yield _line("==I")


def _line(instruction: str, operand: str = "", label: str = "", note: str = "") -> str:
    text = f"{label + ':' if label else '':6}{instruction:5} {operand}".rstrip() + ";"
    return f"{text} {_comment(note)}" if note else text


def _cycle(function: str) -> list[str]:
    return _organization("OB 1", _line("CALL", f'"{function}"'))


def _startup(number: int, data: str, variable: str, reset: Sequence[Declaration]) -> list[str]:
    numbers = [d.name for d in reset if d.type == "INT"]
    lines = [_line("SET"), _line("=", f'"{data}".{variable}'), _line("CLR")]
    lines += [_line("=", f'"{data}".{d.name}') for d in reset if d.type != "INT"]
    lines += [x for n in numbers for x in (_line("L", "0"), _line("T", f'"{data}".{n}'))]
    return _organization(f"OB {number}", *lines)


def _organization(name: str, *lines: str) -> list[str]:
    taken = ["VAR_TEMP", "  START_INFO : ARRAY [0 .. 19] OF BYTE;", "END_VAR"]
    return [f"ORGANIZATION_BLOCK {name}", *taken, "BEGIN", "NETWORK", *lines, "END_ORGANIZATION_BLOCK"]


# --- reading -------------------------------------------------------------------------------------


def _uncommented(text: str) -> str:
    """Without comments, titles, empty lines and space that says nothing."""
    if not text.isascii() or any(x in text for x in ("(*", "*)", "/*", "*/")) or unprintable(text):
        raise NotInSubset("a comment of another kind")
    lines = (line.partition("//")[0].rstrip() for line in text.split("\n"))
    return "\n".join(x for x in lines if x and not x.startswith("TITLE =")) + "\n"


def _read(text: str, elsewhere: Sequence[Block]) -> list[Block]:
    """The blocks of a source in their order."""
    found: list[Block] = []
    text, at = _uncommented(text), 0
    for m in re.finditer(r"(DATA_BLOCK|FUNCTION_BLOCK|FUNCTION) \"(\w+)\"(.*?)\nEND_\1\n", text, re.DOTALL | re.ASCII):
        if m.start() != at:
            break
        at = m.end()
        found.append(_data(m[2], m[3]) if m[1] == "DATA_BLOCK" else _declared(m[1], m[2], m[3]))
    if at != len(text) or not found:
        raise NotInSubset(f"something that is no block: {text[at : at + 40]!r}")
    known = frame([*elsewhere, *found])
    return [replace(b, note="", body=_Reader(b, known).body()) if b.note else b for b in found]


def _held(text: str) -> Block:
    """The variables that a text declares."""
    return parse_unit(f'FUNCTION_BLOCK "X"\n{text}BEGIN\nEND_FUNCTION_BLOCK\n', STYLE).blocks[0]


def _data(name: str, text: str) -> Block:
    """An instance, or a data block of its own."""
    if m := re.fullmatch(r"\n\"(\w+)\"\nBEGIN", text, re.ASCII):
        return Block(name, (), (), (Declaration("OF", m[1]),), (), kind="INSTANCE")
    if m := re.fullmatch(r"\nSTRUCT\n(.*)END_STRUCT;\nBEGIN", text, re.DOTALL):
        held = _held(f"VAR\n{m[1]}END_VAR\n").locals
        if all(d.type in ("BOOL", "INT") for d in held):
            return Block(name, (), (), held, (), kind="DATA_BLOCK")
    raise NotInSubset(f"{name} is neither an instance nor a data block as it is written")


def _declared(kind: str, name: str, text: str) -> Block:
    """A block without its statements, whose text stands in its note."""
    void = kind == "FUNCTION"
    head, begin, rest = text.partition("\nBEGIN\n")
    if not begin or head.startswith(" : VOID") is not void or (void and re.search(r"\nVAR(_INPUT|_OUTPUT)?\n", head)):
        raise NotInSubset(f"{name} is no block as it is written")
    head = head.removeprefix(" : VOID").replace("VAR_TEMP\n", "VAR\n" if void else "VAR_TEMP\n").lstrip("\n")
    held = _held(f"{head}\n" if head else "")
    return Block(name, held.inputs, held.outputs, held.locals, (), rest, kind)


@dataclass(frozen=True)
class _Instruction:
    """One line: a label, what is done, and to what."""

    label: str
    what: str
    operand: str


_LINE = re.compile(r"(?:(M[0-9]{3}): | {6})([AO]N?\(|[A-Z]+|\)|==I|=) *([^;]*);", re.ASCII)
_PLACE = re.compile(r'#(\w+)(?:\.(Q))?|"(\w+)"(?:\.(\w+))?', re.ASCII)
_CALLED = re.compile(r'(?:#(\w+)|"(\w+)"(?:, "(\w+)")?)(?: \((.*)\))?', re.ASCII)
_TIME = re.compile(r"T#[0-9]+m?s")


class _Reader:
    """The instructions of a block as statements."""

    def __init__(self, b: Block, known: Frame) -> None:
        self.block, self.known = b, known
        own = (*b.inputs, *b.outputs, *b.locals)
        self.own: Mapping[str, str] = {d.name: d.type for d in own}
        if len(self.own) != len(own):
            raise NotInSubset(f"{b.name} declares a variable twice")
        self.at = 0
        self.labels: set[str] = set()
        self.todo: list[_Instruction] = []
        for line in b.note.split("\n"):
            if line == "NETWORK":
                continue
            m = _LINE.fullmatch(line)
            if m is None:
                raise self._bad(f"{line.strip()!r} is no instruction that is written")
            self.todo.append(_Instruction(m[1] or "", m[2], m[3]))

    def _bad(self, what: str) -> NotInSubset:
        return NotInSubset(f"{self.block.name}: {what}")

    def _next(self) -> _Instruction:
        if self.at == len(self.todo):
            raise self._bad("ends within a statement")
        return self.todo[self.at]

    def _take(self, what: str, operand: str | None = None, label: str = "") -> str:
        i = self._next()
        if i.what != what or i.label != label or (operand is not None and i.operand != operand):
            raise self._bad(f"{what} {operand or ''} is expected, here is {i.label} {i.what} {i.operand}")
        self.at += 1
        return i.operand

    def body(self) -> tuple[Statement, ...]:
        """All statements."""
        out = []
        while self.at < len(self.todo):
            out.append(self._statement())
        return tuple(out)

    def _statement(self) -> Statement:
        i = self._next()
        if i.what == "CALL":
            return self._call(self._take("CALL"))
        if self._moves():
            value = self._number(self._take("L"))
            return Assign(self._variable(self._take("T"), "INT"), value)
        value = self._logic(("=", "JCN"))
        if self._next().what == "JCN":
            return self._branch(value)
        return Assign(self._variable(self._take("="), "BOOL"), value)

    def _branch(self, condition: Expression) -> If:
        """An IF whose first condition is read; all of its branches leap to one end."""
        after = self._take("JCN")
        then = self._until("JU", "NOP")
        arms = [(condition, then)]
        if self._next().what == "NOP":  # no other branch
            self._close(after)
            return self._made(arms, ())
        end = self._take("JU")
        self._close(after)
        while (arm := self._arm(end)) is not None:
            arms.append((arm[0], arm[1]))
            if arm[2]:
                return self._made(arms, ())
        otherwise = self._until("NOP")
        self._close(end)
        return self._made(arms, otherwise)

    def _until(self, *ends: str) -> tuple[Statement, ...]:
        out = []
        while self._next().what not in ends:
            out.append(self._statement())
        return tuple(out)

    def _arm(self, end: str) -> tuple[Expression, tuple[Statement, ...], bool] | None:
        """A further condition with its branch, and whether it is the last; None where no branch to this end follows."""
        before, labels = self.at, set(self.labels)
        if self._next().what not in ("CALL", "NOP") and not self._moves():
            condition = self._logic(("=", "JCN"))
            if self._next().what == "JCN":
                after = self._take("JCN")
                then = self._until("JU", "NOP")
                if self._next() == _Instruction("", "JU", end):
                    self._take("JU", end)
                    self._close(after)
                    return condition, then, False
                if after == end and self._next() == _Instruction(end, "NOP", "0"):
                    self._close(end)
                    return condition, then, True
        self.at, self.labels = before, labels
        return None

    def _moves(self) -> bool:
        """Whether a number is moved next."""
        return [i.what for i in self.todo[self.at : self.at + 2]] == ["L", "T"]

    def _close(self, label: str) -> None:
        self._take("NOP", "0", label)
        if not label or label in self.labels:
            raise self._bad(f"{label} is there twice")
        self.labels.add(label)

    def _made(self, arms: list[tuple[Expression, tuple[Statement, ...]]], otherwise: tuple[Statement, ...]) -> If:
        if not all(then for _, then in arms):
            raise self._bad("a branch that does nothing")
        return If(*arms[0], otherwise, tuple(arms[1:]))

    def _logic(self, ends: tuple[str, ...]) -> Expression:
        """What the RLO is when one of the ends follows."""
        i = self._next()
        if i.what in ("SET", "CLR"):
            self._take(i.what, "")
            return self._ended(Bool(i.what == "SET"), ends)
        if i.what == "L":
            left = self._number(self._take("L"))
            right = self._number(self._take("L"))
            self._take("==I", "")
            return self._ended(Compare("=", left, right), ends)
        letters, args = set(), []
        while self._next().what not in ends:
            letter, x = self._operand()
            letters.add(letter)
            args.append(x)
        if len(letters) != 1:
            raise self._bad("A and O are mixed without brackets, or nothing is asked")
        if len(args) == 1:
            return args[0]
        return Nary("AND" if letters == {"A"} else "OR", tuple(args))

    def _ended(self, x: Expression, ends: tuple[str, ...]) -> Expression:
        if self._next().what not in ends:
            raise self._bad("something is joined to a constant or a comparison")
        return x

    def _operand(self) -> tuple[str, Expression]:
        i = self._next()
        m = re.fullmatch(r"([AO])(N?)(\(?)", i.what)
        if m is None:
            raise self._bad(f"{i.what} where A or O is expected")
        operand = self._take(i.what)
        x: Expression
        if m[3]:
            if operand:
                raise self._bad("something stands behind a bracket")
            x = self._logic((")",))
            self._take(")", "")
        else:
            x = self._variable(operand, "BOOL")
        return m[1], Not(x) if m[2] else x

    def _number(self, text: str) -> Expression:
        if text.isdigit() and str(int(text)) == text:
            return Int(int(text))
        return self._variable(text, "INT")

    def _variable(self, text: str, kind: str) -> Name:
        """A variable of a type: of the block itself, of a data block, an output of an instance, or a terminal."""
        m = _PLACE.fullmatch(text)
        if m is None:
            raise self._bad(f"{text} is no variable")
        own, output, first, member = m.groups()
        if own:
            found = self.own.get(own)
            if found is None or (found == "TON") is not bool(output) or (found not in ("TON", kind)):
                raise self._bad(f"{text} is not declared as {kind}")
            return Name((own, "Q") if output else (own,))
        if first in self.own:
            raise self._bad(f"{text} is a name of the block's own")
        if member is None:
            if kind != "BOOL" or first in self.known.data or first in self.known.instances:
                raise self._bad(f"{text} is no terminal")
            return Name((first,))
        if first in self.known.data:
            if ((first, member) in self.known.numbers) is not (kind == "INT"):
                raise self._bad(f"{text} is no {kind}")
        elif first not in self.known.instances:
            raise self._bad(f"{text} is no member of a data block")
        return Name((first, member))

    def _call(self, text: str) -> Call:
        m = _CALLED.fullmatch(text)
        if m is None:
            raise self._bad(f"{text} cannot be called")
        own, block, data, given = m.groups()
        params = tuple(self._param(x) for x in given.split(", ")) if given is not None else ()
        if own:
            if self.own.get(own) != "TON":
                raise self._bad(f"{own} is no timer")
            return Call(own, params)
        if data:
            if self.known.instances.get(data) != block:
                raise self._bad(f"{data} is no instance of {block}")
            return Call(data, params)
        if block not in self.known.functions or params:
            raise self._bad(f"{block} is no function without parameters")
        return Call(block, ())

    def _param(self, text: str) -> tuple[str, Expression]:
        name, sign, value = text.partition(" := ")
        if not sign or not name.isidentifier():
            raise self._bad(f"{text} is no parameter")
        if _TIME.fullmatch(value):
            ms = int(value.strip("T#ms"))
            return name, Time(ms if value.endswith("ms") else ms * 1000)
        return name, self._variable(value, "BOOL")


LANGUAGE = Language(".awl", _comment, _block, _cycle, _startup, _read, _uncommented)

DIALECT = Dialect(
    "awl",
    "Siemens S7-300/400, STEP 7 classic sources in STL",
    LANGUAGE.write,
    LANGUAGE.read_files,
    restart=True,
    runs=Runs.CYCLE,
    form=shared,
)
