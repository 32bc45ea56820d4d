"""How large a text becomes in an S7-300, S7-400 or S7-1500: an estimate, not measured on hardware.

No compiler of these controllers was at hand.  The rule follows what their code looks like: a bit is read or written by
one instruction of two words, and one in a data block by a word more, which opens it; the rest is rounded up.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import cached_property

from interlock.dataclass import dataclass
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

PLAIN = ("BOOL", "INT")
OPERAND, MEMBER, BRACKETS, CALL, HEAD, TIMER, JUMP = 4, 6, 4, 24, 36, 22, 4
RULE = (
    f"{OPERAND} bytes for each bit of a block's own or of a terminal that is read or written, {MEMBER} for one in a "
    f"data block, {OPERAND} more for a parameter or a time, {BRACKETS} for brackets, {2 * JUMP} for a condition of IF, "
    f"{CALL} for a call, {HEAD} for the head of a block; of data a bit for each BOOL, 2 bytes for an INT, {TIMER} for "
    "a timer"
)
SOURCE = (
    "our assumption: a bit instruction has two words, as in the instruction list of the S7-300, and one more opens the "
    "data block, as industrialmonitordirect.com has it of S7-300/400 data block access"
)
TIMES = 4
TIA_RULE = (
    f"{TIMES} times the code that the same blocks would take in an S7-300, which is taken high ({RULE}); of data a "
    "byte for each BOOL instead of a bit"
)
TIA_SOURCE = (
    "industrialmonitordirect.com, S7-300 vs S7-1500 FB memory size: up to four times the work memory; that of a BOOL "
    f"is our assumption; for the S7-300 {SOURCE}"
)
CAVEAT = "estimated, not measured on hardware"


@dataclass(frozen=True)
class Size:
    """What a unit takes: bytes of each block's code, and of the data blocks."""

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


def size_of(unit: Unit, tia: bool = False) -> Size:
    """The size of an interlocking with its mapping program, whose variables lie in data blocks or in instances; `tia`:
    in an S7-1500."""
    blocks = {b.name: b for b in unit.blocks if b.kind == "FUNCTION_BLOCK"}
    written = [b for b in unit.blocks if b.kind in ("FUNCTION", "FUNCTION_BLOCK", "PROGRAM")]
    code = {b.name: (TIMES if tia else 1) * (HEAD + sum(map(_statement, b.body))) for b in written}
    data: dict[str, int] = {}
    for b in unit.blocks:
        if b.kind == "DATA_BLOCK":
            data[b.name] = HEAD + _held(b.locals, blocks, tia)
        elif b.kind == "INSTANCE":
            data[b.name] = HEAD + _instance(blocks[b.locals[0].type], blocks, tia)
        elif b.kind == "PROGRAM":
            own = [d for d in b.locals if d.type in PLAIN and not d.address]
            data["the operator's place"] = HEAD + _held(own, blocks, tia)
            data |= {d.name: HEAD + _instance(blocks[d.type], blocks, tia) for d in b.locals if d.type in blocks}
    return Size(code, data)


def _statement(s: Statement) -> int:
    if isinstance(s, Assign):
        return _read(s.value) + _read(s.target)
    if isinstance(s, Call):
        return CALL + sum(_read(x) + OPERAND for _, x in s.params)
    arms = sum(_read(c) + 2 * JUMP + sum(map(_statement, then)) for c, then in s.arms)
    return arms + sum(map(_statement, s.otherwise))


def _read(x: Expression) -> int:
    if isinstance(x, Name):
        return OPERAND if len(x.parts) == 1 else MEMBER
    if isinstance(x, Bool | Int | Time):
        return 2 * OPERAND if isinstance(x, Time) else OPERAND
    if isinstance(x, Not):
        return _read(x.arg) + (0 if isinstance(x.arg, Name) else BRACKETS)
    if isinstance(x, Compare):
        return _read(x.left) + _read(x.right) + OPERAND
    return sum(_read(a) + (0 if isinstance(a, Name | Not) else BRACKETS) for a in x.args)


def _instance(b: Block, blocks: Mapping[str, Block], tia: bool) -> int:
    """Bytes of an instance, those within it among them."""
    return sum(_held(part, blocks, tia) for part in (b.inputs, b.outputs, b.locals))


def _held(part: Sequence[Declaration], blocks: Mapping[str, Block], tia: bool) -> int:
    """Bytes of variables: inputs, outputs and others each begin at a word."""
    bools = sum(d.type == "BOOL" for d in part)
    bits = 2 * -(-bools // 2) if tia else 2 * -(-bools // 16)
    inner = sum(_instance(blocks[d.type], blocks, tia) for d in part if d.type in blocks)
    return 2 * sum(d.type == "INT" for d in part) + bits + TIMER * sum(d.type == "TON" for d in part) + inner


__all__ = ["CAVEAT", "RULE", "SOURCE", "TIA_RULE", "TIA_SOURCE", "Size", "size_of"]
