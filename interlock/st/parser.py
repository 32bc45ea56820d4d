"""Structured Text back to the tree: one regular expression for the tokens, one function for each rule.

    unit        = (structure | block)+
    structure   = TYPE name : STRUCT (name : name [:= expr] ;)* END_STRUCT ; END_TYPE
    block       = FUNCTION_BLOCK name part* statement* END_FUNCTION_BLOCK, or the same with PROGRAM
    part        = (VAR_INPUT | VAR_OUTPUT | VAR_IN_OUT | VAR) (name [AT address] : name [:= expr] ;)* END_VAR
    statement   = name := expr ; | name ( [name := expr {, name := expr}] ) ; | IF expr THEN body {ELSIF expr THEN body}
                  [ELSE body] END_IF ;
    expr        = xor {OR xor}        xor = and {XOR and}        and = comparison {AND comparison}
    comparison  = unary [(= | <> | < | > | <= | >=) unary]       unary = NOT unary | literal | name {. name} | ( expr )

Keywords in any case; comments (* *) are not nested.  A file of a large layout has a million tokens: a general parser
generator took five times as long.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from itertools import islice
from typing import NoReturn

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
    Task,
    Time,
    Unit,
)
from interlock.st.style import COMMENT, IEC, SPACE, Style

_UNITS = {"ms": 1, "s": 1000, "m": 60_000, "h": 3_600_000}
_GOOD = r"""
    [Tt](?:[Ii][Mm][Ee])?\#[0-9]+(?:ms|s|m|h)\b
    | (?:[A-Za-z_]|\#[A-Za-z0-9_])[A-Za-z0-9_]*+(?:\.[A-Za-z_][A-Za-z0-9_]*+)*+
    | := | <> | <= | >= | [-+*/=<>();:.,\[\]&]
    | (?:0|[1-9][0-9]*)(?:\.[0-9]+)?(?![A-Za-z0-9_]) | %[IQ]X[0-9]+\.[0-7] | "[A-Za-z0-9_]+" | \{[^{}]*\}"""
_TOKEN = re.compile(
    rf"""(?: {SPACE} )?+ (?: {COMMENT} (?: {SPACE} )?+ )*+  # space and comments before it
    ( {_GOOD} | \Z | .+ )                               # what is nothing of this is one token with all that follows""",
    re.VERBOSE | re.DOTALL,
)
_WELL = re.compile(_GOOD, re.VERBOSE)
_CLOSED = re.compile(r"\nEND_(?:FUNCTION_BLOCK|PROGRAM|TYPE)[ \t]*(?=\n)")
_COMPARE = frozenset(("=", "<>", "<", ">", "<=", ">="))
_JOINING = ("AND", "OR", "XOR")
_OPERATORS = (*_JOINING, "NOT", "TRUE", "FALSE")
_DECLARING = ("VAR_INPUT", "VAR_OUTPUT", "VAR", "VAR_IN_OUT")
_STRUCTURES = ("TYPE", "STRUCT", "END_STRUCT", "END_TYPE")
_BLOCKS = ("FUNCTION_BLOCK", "END_FUNCTION_BLOCK", "PROGRAM", "END_PROGRAM", *_STRUCTURES)
_RESERVED = frozenset((*_DECLARING, *_BLOCKS, "AT", "END_VAR", "IF", "THEN", "ELSIF", "ELSE", "END_IF", *_OPERATORS))
_AFTER = frozenset((";", ",", ")", "THEN", "AND", "OR"))
_PLAIN = [":", "BOOL", ";"]
_END = ""
_Rule = Callable[[], Expression]


class NotInSubset(Exception):
    """The text is not in the subset; the message names line and column."""


def parse_unit(text: str, style: Style = IEC) -> Unit:
    """The tree of a text in a style; raises `NotInSubset`."""
    return _Reader(text, style).unit()


def parse_block(name: str, declarations: str, body: str, kind: str = "FUNCTION_BLOCK") -> Block:
    """A block, or a program (`kind`), whose declarations and statements come in two texts; raises `NotInSubset`."""
    head = _Reader(declarations, IEC)
    *parts, handed = head.declarations()
    head.end()
    rest = _Reader(body, IEC)
    statements = rest.body(_END)
    rest.end()
    return _made(name, kind, (*parts, handed), statements)


def parse_structure(text: str, end: str = "END_STRUCT;") -> Block:
    """A structure that is a text of its own, which closes as `end` has it; raises `NotInSubset`."""
    whole = text.rstrip("\n").replace(f"\n{end}\nEND_TYPE", "\nEND_STRUCT;\nEND_TYPE")
    head = _Reader(whole, IEC)
    if not head.next_is("TYPE"):
        raise NotInSubset("no structure")
    found = head.structure()
    head.end()
    return found


_Parts = tuple[tuple[Declaration, ...], ...]


def _made(name: str, kind: str, parts: _Parts, body: tuple[Statement, ...]) -> Block:
    """A block of its parts, in the order in which they are listed above."""
    inputs, outputs, locals_, handed = parts
    if any(d.address for part in (inputs, outputs, handed) for d in part):
        raise NotInSubset(f"{name}: an address of what is handed on")
    if kind != "PROGRAM" and any(d.address for d in locals_):
        raise NotInSubset(f"{name}: an address in a function block")
    return Block(name, inputs, outputs, locals_, body, kind=kind, handed=handed)


def _tokens(text: str, begin: int, end: int) -> list[str]:
    """The tokens from one place to another, and the end of them."""
    found: list[str] = _TOKEN.findall(text, begin, end)
    while len(found) > 1 and not found[-2]:
        del found[-1]
    return found


class _Reader:
    """Reads a text window by window, so that the tokens of one block are kept at a time."""

    def __init__(self, text: str, style: Style) -> None:
        self.text = text
        self.style = style
        self._windows = [0, *(m.end() for m in _CLOSED.finditer(text)), len(text)]
        self.tokens: list[str] = []
        self.at = 0
        self._variables: dict[str, tuple[Name, Not]] = {}
        """By its token each variable that was met, as it is and negated."""
        self._good: dict[str, str] = {}
        self._plain: dict[str, Declaration] = {}
        self._scan()

    def _scan(self) -> None:
        """Go on to the next window."""
        self._window = self._windows[0], self._windows[1]
        del self._windows[0]
        self.tokens = _tokens(self.text, *self._window)
        last = self.tokens[-2] if len(self.tokens) > 1 else _END
        if last and not _WELL.fullmatch(last):
            at = self._start(len(self.tokens) - 2)
            raise NotInSubset(f"{self._place(at)}: {self.text[at : at + 10]!r} is not in the subset")
        self.tokens.append(_END)  # one may look at the token after this
        self.at = 0

    def _start(self, number: int) -> int:
        """Where a token of the window stands in the text."""
        starts = (m.start(1) for m in _TOKEN.finditer(self.text, *self._window) if m[1])
        return next(islice(starts, number, None), self._window[1])

    def _place(self, offset: int) -> str:
        before = self.text[:offset]
        return f"line {before.count(chr(10)) + 1}, column {offset - before.rfind(chr(10))}"

    def _fail(self, wanted: str) -> NoReturn:
        found = self.tokens[self.at] or "the end"
        raise NotInSubset(f"{self._place(self._start(self.at))}: {wanted} is expected, here is {found}")

    def _take(self, token: str) -> None:
        if self.tokens[self.at] != token:
            self._fail(f"'{token}'")
        self.at += 1

    def _is(self, keyword: str) -> bool:
        return self.tokens[self.at].upper() == keyword

    def _word(self, keyword: str) -> None:
        if not self._is(keyword):
            self._fail(keyword)
        self.at += 1

    def _name(self) -> str:
        found = self._checked(self.tokens[self.at])
        self.at += 1
        return found

    def _checked(self, name: str) -> str:
        """A name, the same object wherever it stands."""
        found = self._good.get(name)
        if found is None:
            if not name.isidentifier() or name.upper() in _RESERVED:
                self._fail("a name")
            found = self._good[name] = name
        return found

    def end(self) -> None:
        """Nothing may follow."""
        self._end_of_window()
        if len(self._windows) > 1:
            self._scan()
            self._fail("the end")

    def _end_of_window(self) -> None:
        if self.tokens[self.at]:
            self._fail("the end")

    def unit(self) -> Unit:
        blocks = []
        while True:
            while self._is("FUNCTION_BLOCK") or self._is("PROGRAM") or self._is("TYPE"):
                blocks.append(self.structure() if self._is("TYPE") else self._block())
            if len(self._windows) == 1:
                break
            self._end_of_window()
            self._scan()
        if not blocks:
            self._fail("FUNCTION_BLOCK")
        task = self._task() if self._is("CONFIGURATION") else None
        self.end()
        return Unit(tuple(blocks), task=task)

    def _task(self) -> Task:
        """A configuration of the one form that is written."""
        self.at += 1
        configuration = self._name()
        self._word("RESOURCE")
        resource = self._name()
        for token in ("ON", "PLC", "TASK"):
            self._word(token)
        name = self._name()
        for token in ("(", "INTERVAL", ":="):
            self._take(token)
        interval = self.expression()
        if not isinstance(interval, Time):
            self._fail("a time")
        for token in (",", "PRIORITY", ":=", "0", ")", ";", "PROGRAM"):
            self._take(token)
        instance = self._name()
        for token in ("WITH", name, ":"):
            self._take(token)
        program = self._name()
        for token in (";", "END_RESOURCE", "END_CONFIGURATION"):
            self._take(token)
        return Task(configuration, resource, name, interval.ms, instance, program)

    def _block_name(self) -> str:
        token = self.tokens[self.at]
        if self.style.quoted:
            if token[:1] != '"':
                self._fail("a name in double quotes")
            self.at += 1
            return token[1:-1]
        return self._name()

    def _block(self) -> Block:
        kind = self.tokens[self.at].upper()
        self.at += 1
        name = self._block_name()
        parts = self.declarations()
        if self.style.begin:
            self._word("BEGIN")
        body = self.body(f"END_{kind}")
        self.at += 1
        return _made(name, kind, parts, body)

    def next_is(self, keyword: str) -> bool:
        """Whether a keyword is next."""
        return self._is(keyword)

    def structure(self) -> Block:
        """A structure; its members are plain."""
        self.at += 1
        name = self._name()
        self._take(":")
        self._word("STRUCT")
        members = []
        while not self._is("END_STRUCT"):
            members.append(self._declaration())
        self.at += 1
        self._take(";")
        self._word("END_TYPE")
        if not members or any(d.address or d.type not in ("BOOL", "INT") for d in members):
            raise NotInSubset(f"{name} is empty, or has a member that is neither BOOL nor INT")
        return Block(name, (), (), tuple(members), (), kind="STRUCT")

    def declarations(self) -> _Parts:
        """What is declared: inputs, outputs, a block's own, what is handed on."""
        parts: dict[str, list[Declaration]] = {kind: [] for kind in _DECLARING}
        while self.tokens[self.at].upper() in parts:
            part = parts[self.tokens[self.at].upper()]
            self.at += 1
            while not self._is("END_VAR"):
                known = self._plain.get(self.tokens[self.at])
                if known is not None and self.tokens[self.at + 1 : self.at + 4] == _PLAIN:
                    self.at += 4
                    part.append(known)
                else:
                    part.append(self._declaration())
            self.at += 1
        return tuple(tuple(parts[kind]) for kind in _DECLARING)

    def _declaration(self) -> Declaration:
        name = self._name()
        if self.tokens[self.at : self.at + 3] == _PLAIN:
            self.at += 3
            found = self._plain[name] = Declaration(name, "BOOL")
            return found
        address = ""
        if self._is("AT"):
            address = self.tokens[self.at + 1]
            if not address.startswith("%"):
                self._fail("an address")
            self.at += 2
        timer = self.style.timer_note and self.tokens[self.at] == self.style.timer_note
        if timer:
            self.at += 1
        self._take(":")
        kind = self._kind()
        if self.style.timer_note and (kind == "TON") is not timer:
            self._fail(f"{self.style.timer_note} with a timer, and only there,")
        initial = None
        if self.tokens[self.at] == ":=":
            self.at += 1
            initial = self.expression()
        self._take(";")
        return Declaration(name, kind, initial, address=address)

    def _kind(self) -> str:
        token = self.tokens[self.at]
        if token == self.style.timer:
            self.at += 1
            return "TON"
        if self.style.quoted and token.upper() not in ("BOOL", "INT"):
            return self._block_name()
        return self._name()

    def _variable(self) -> Name:
        """A variable in a body, with its mark; or an output of an instance, or a member: most often one token."""
        token, mark = self.tokens[self.at], self.style.local
        if not token.startswith(mark):
            self._fail(f"a variable with {mark}")
        first, *rest = token[len(mark) :].split(".")
        parts = [first if mark else self._checked(first), *map(self._checked, rest)]
        self.at += 1
        if self.tokens[self.at] != ".":
            name = Name(tuple(parts))
            self._variables[token] = name, Not(name)
            return name
        while self.tokens[self.at] == ".":
            self.at += 1
            parts += map(self._checked, self.tokens[self.at].split("."))
            self.at += 1
        return Name(tuple(parts))

    def body(self, *ends: str) -> tuple[Statement, ...]:
        out = []
        while self.tokens[self.at].upper() not in ends:
            out.append(self._statement())
        return tuple(out)

    def _statement(self) -> Statement:
        known = self._variables.get(self.tokens[self.at])
        if known is not None and self.tokens[self.at + 1] == ":=":
            self.at += 2
            return self._assigned(known[0])
        if self._is("IF"):
            return self._branch()
        name = self._variable()
        if len(name.parts) == 1 and self.tokens[self.at] == "(":
            self.at += 1
            params: list[tuple[str, Expression]] = []
            while self.tokens[self.at] != ")":
                if params:
                    self._take(",")
                param = self._name()
                self._take(":=")
                params.append((param, self.expression()))
            self.at += 1
            self._take(";")
            return Call(name.parts[0], tuple(params))
        self._take(":=")
        return self._assigned(name)

    def _assigned(self, target: Name) -> Assign:
        value = self.expression()
        self._take(";")
        return Assign(target, value)

    def _branch(self) -> If:
        arms: list[tuple[Expression, tuple[Statement, ...]]] = []
        while not arms or self._is("ELSIF"):
            self.at += 1
            condition = self.expression()
            self._word("THEN")
            arms.append((condition, self.body("ELSIF", "ELSE", "END_IF", _END)))
        otherwise: tuple[Statement, ...] = ()
        empty = not all(then for _, then in arms)
        if self._is("ELSE"):
            self.at += 1
            otherwise = self.body("END_IF", _END)
            empty = empty or not otherwise
        self._word("END_IF")
        self._take(";")
        if empty:
            self._fail("a statement in each branch of the IF above")
        return If(*arms[0], otherwise, tuple(arms[1:]))

    def expression(self) -> Expression:
        tokens, variables = self.tokens, self._variables
        began = at = self.at
        op = ""
        args: list[Expression] = []
        while True:
            negated = tokens[at] == "NOT"
            known = variables.get(tokens[at + negated])
            word = tokens[at + negated + 1]
            if known is not None and word in _AFTER:  # most of a text: a variable that was met, negated or not
                at += negated + 1
                args.append(known[negated])
            else:
                self.at = at
                args.append(self._comparison())
                at = self.at
                word = tokens[at]
            if word != op or not op:
                word = word.upper()
                if word not in _JOINING:
                    self.at = at
                    return Nary(op, tuple(args)) if op else args[0]
                if op and word != op:
                    self.at = began  # several kinds without brackets between them
                    return self._joined("OR", self._exclusive)
                op = word
            at += 1

    def _exclusive(self) -> Expression:
        return self._joined("XOR", self._all)

    def _all(self) -> Expression:
        return self._joined("AND", self._comparison)

    def _joined(self, op: str, operand: _Rule) -> Expression:
        first = operand()
        if self.tokens[self.at].upper() != op:
            return first
        args = [first]
        while self.tokens[self.at].upper() == op:
            self.at += 1
            args.append(operand())
        return Nary(op, tuple(args))

    def _comparison(self) -> Expression:
        left = self._unary()
        op = self.tokens[self.at]
        if op not in _COMPARE:
            return left
        self.at += 1
        return Compare(op, left, self._unary())

    def _unary(self) -> Expression:
        token = self.tokens[self.at]
        word = token.upper()
        if word == "NOT":
            self.at += 1
            return Not(self._unary())
        if token == "(":
            self.at += 1
            inner = self.expression()
            self._take(")")
            return inner
        if word == "TRUE" or word == "FALSE":
            self.at += 1
            return Bool(word == "TRUE")
        if token.isdigit():
            self.at += 1
            return Int(int(token))
        if "#" in token and token[0] != "#":
            self.at += 1
            digits = token.split("#")[1]
            unit = digits.lstrip("0123456789")
            return Time(int(digits[: len(digits) - len(unit)]) * _UNITS[unit])
        return self._variable()
