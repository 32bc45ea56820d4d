"""Structured Text back to the tree, by our own LALR grammar."""

from __future__ import annotations

from functools import lru_cache
from importlib import resources

from lark import Lark, Token, Transformer, v_args
from lark.exceptions import UnexpectedInput

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

_UNITS = {"ms": 1, "s": 1000, "m": 60_000, "h": 3_600_000}


class NotInSubset(Exception):
    """The text is not in the subset; the message names line and column."""


@v_args(inline=True)
class _Build(Transformer[Token, Unit]):
    """Parse tree to syntax tree."""

    def start(self, *blocks: Block) -> Unit:
        return Unit(tuple(blocks))

    def block(self, name: Token, *rest: object) -> Block:
        parts: dict[str, list[Declaration]] = {"VAR_INPUT": [], "VAR_OUTPUT": [], "VAR": []}
        body: list[Statement] = []
        for x in rest:
            if isinstance(x, tuple):
                parts[x[0]].extend(x[1])
            elif isinstance(x, Assign | Call | If):
                body.append(x)
        return Block(str(name), tuple(parts["VAR_INPUT"]), tuple(parts["VAR_OUTPUT"]), tuple(parts["VAR"]), tuple(body))

    def var_part(self, kind: Token, *declarations: Declaration) -> tuple[str, list[Declaration]]:
        return str(kind).upper(), list(declarations)

    def declaration(self, name: Token, kind: Token, initial: Expression | None = None) -> Declaration:
        return Declaration(str(name), str(kind), initial)

    def assign(self, target: Name, value: Expression) -> Assign:
        return Assign(target, value)

    def call(self, instance: Token, *params: tuple[str, Expression]) -> Call:
        return Call(str(instance), tuple(p for p in params if p is not None))

    def if_(
        self, condition: Expression, then: tuple[Statement, ...], otherwise: tuple[Statement, ...] | None = None
    ) -> If:
        return If(condition, then, otherwise or ())

    def then_part(self, *body: Statement) -> tuple[Statement, ...]:
        return body

    else_part = then_part

    def param(self, name: Token, value: Expression) -> tuple[str, Expression]:
        return str(name), value

    def or_expr(self, *args: Expression) -> Nary:
        return Nary("OR", args)

    def xor_expr(self, *args: Expression) -> Nary:
        return Nary("XOR", args)

    def and_expr(self, *args: Expression) -> Nary:
        return Nary("AND", args)

    def comparison(self, left: Expression, op: Token | None = None, right: Expression | None = None) -> Expression:
        return left if op is None or right is None else Compare(str(op), left, right)

    def not_(self, arg: Expression) -> Not:
        return Not(arg)

    def bool(self, token: Token) -> Bool:
        return Bool(token.upper() == "TRUE")

    def int(self, token: Token) -> Int:
        return Int(int(token))

    def time(self, token: Token) -> Time:
        digits = token.split("#")[1]
        unit = digits.lstrip("0123456789").lower()
        return Time(int(digits[: len(digits) - len(unit)]) * _UNITS[unit])

    def name(self, *parts: Token) -> Name:
        return Name(tuple(map(str, parts)))


@lru_cache(maxsize=1)
def _parser() -> Lark:
    grammar = resources.files("interlock.st").joinpath("st.lark").read_text("utf-8")
    return Lark(grammar, parser="lalr", maybe_placeholders=True, transformer=_Build())


def parse_unit(text: str) -> Unit:
    """The tree of a text; raises `NotInSubset`."""
    try:
        unit = _parser().parse(text)
    except UnexpectedInput as error:
        raise NotInSubset(f"line {error.line}, column {error.column}: {str(error).splitlines()[0]}") from None
    assert isinstance(unit, Unit)
    return unit
