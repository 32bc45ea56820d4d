"""How large a text becomes in an S7-300 or S7-400: an estimate, not measured on hardware.

No compiler of these controllers was at hand.  The rule follows what their code looks like: a bit is read or written by
one instruction of two words where its address lies in an instance's data; the rest is rounded up.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

from interlock.st.ast import (
    Assign,
    Block,
    Bool,
    Call,
    Compare,
    Declaration,
    Expression,
    Int,
    Name,
    Not,
    Statement,
    Time,
    Unit,
)

OPERAND, BRACKETS, CALL, HEAD, TIMER = 4, 4, 24, 36, 22
RULE = (
    f"{OPERAND} bytes for each bit that is read or written, {2 * OPERAND} for a parameter, {BRACKETS} for brackets, "
    f"{CALL} for a call, {HEAD} for the head of a block; of data a bit for each BOOL, 2 bytes for an INT, {TIMER} for "
    "a timer"
)
SOURCE = "our assumption: a bit instruction on instance data has two words, as in the instruction list of the S7-300"
CAVEAT = "estimated, not measured on hardware"


@dataclass(frozen=True)
class Size:
    """What a unit takes: bytes of each block's code, and of the data blocks that hold instances and the operator's
    variables."""

    code: Mapping[str, int]
    data: Mapping[str, int]

    @cached_property
    def largest(self) -> tuple[str, int]:
        """The block or data block that takes most, and its bytes."""
        every = {**self.code, **{f"data of {n}": b for n, b in self.data.items()}}
        return max(every.items(), key=lambda x: x[1])

    @property
    def memory(self) -> int:
        """Bytes of work memory."""
        return sum(self.code.values()) + sum(self.data.values())


def size_of(unit: Unit) -> Size:
    """The size of an interlocking with its mapping program."""
    blocks = {b.name: b for b in unit.blocks if b.kind == "FUNCTION_BLOCK"}
    code = {b.name: HEAD + sum(map(_statement, b.body)) for b in unit.blocks}
    data: dict[str, int] = {}
    for program in unit.blocks:
        if program.kind == "PROGRAM":
            held = [d for d in program.locals if d.type in ("BOOL", "INT") and not d.address]
            data["the operator's place"] = HEAD + _held(held, blocks)
            for d in program.locals:
                if d.type in blocks:
                    data[d.name] = HEAD + _data(blocks[d.type], blocks)
    return Size(code, data)


def _statement(s: Statement) -> int:
    if isinstance(s, Assign):
        return _read(s.value) + OPERAND
    if isinstance(s, Call):
        return CALL + sum(_read(x) + OPERAND for _, x in s.params)
    return _read(s.condition) + OPERAND + sum(map(_statement, (*s.then, *s.otherwise)))


def _read(x: Expression) -> int:
    if isinstance(x, Name | Bool | Int | Time):
        return 2 * OPERAND if isinstance(x, Time) else OPERAND
    if isinstance(x, Not):
        return _read(x.arg) + (0 if isinstance(x.arg, Name) else BRACKETS)
    if isinstance(x, Compare):
        return _read(x.left) + _read(x.right) + OPERAND
    return sum(_read(a) + (0 if isinstance(a, Name | Not) else BRACKETS) for a in x.args)


def _data(b: Block, blocks: Mapping[str, Block]) -> int:
    """Bytes of an instance: inputs, outputs and variables each begin at a word."""
    return sum(_held(part, blocks) for part in (b.inputs, b.outputs, b.locals))


def _held(part: Sequence[Declaration], blocks: Mapping[str, Block]) -> int:
    bits = sum(d.type == "BOOL" for d in part)
    words = 2 * sum(d.type == "INT" for d in part) + 2 * -(-bits // 16)
    timers = TIMER * sum(d.type == "TON" for d in part)
    return words + timers + sum(_data(blocks[d.type], blocks) for d in part if d.type in blocks)


__all__ = ["CAVEAT", "RULE", "SOURCE", "Size", "size_of"]
