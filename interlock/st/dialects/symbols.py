"""The symbol table of STEP 7 classic (.sdf): what each name in the sources is, terminals with their addresses.

The form is that of the manual "Programming with STEP 7" (A5E02789666-01, 8.6): strings in quotation marks, parts
separated by commas: symbol, address, data type, comment.  Addresses are in English mnemonics (I, Q).  Numbers of blocks
count from 1.
"""

from __future__ import annotations

import csv
import io
import re
from collections.abc import Sequence

from interlock.st.ast import Block, Declaration
from interlock.st.parser import NotInSubset

LONGEST = 24
"""Characters of a symbol, at most."""
_KINDS = {"FUNCTION_BLOCK": "FB", "FUNCTION": "FC", "DATA_BLOCK": "DB", "INSTANCE": "DB"}


def symbol_table(blocks: Sequence[Block], wires: Block) -> str:
    """The table: blocks in their order, then terminals."""
    rows = [*_blocks(blocks), *_wires(wires)]
    return _written(rows)


def _written(rows: Sequence[Sequence[str]]) -> str:
    out = io.StringIO()
    csv.writer(out, quoting=csv.QUOTE_ALL, lineterminator="\n").writerows(rows)
    return out.getvalue()


def read_symbols(text: str, blocks: Sequence[Block]) -> tuple[Declaration, ...]:
    """The terminals with their addresses as IEC writes them; raises `NotInSubset`.

    Everything else must be the blocks that there are.
    """
    try:
        rows = list(csv.reader(io.StringIO(text)))
    except csv.Error as error:
        raise NotInSubset(str(error)) from None
    if any(len(r) != 4 for r in rows) or not text.isascii():
        raise NotInSubset("a symbol table whose rows have not four parts")
    if _written(rows) != text or any('"' in x or not x.isprintable() for r in rows for x in r):
        raise NotInSubset("a symbol table that may be read otherwise line by line")
    names = [r[0] for r in rows]
    if len({n.upper() for n in names}) != len(names) or len({r[1] for r in rows}) != len(rows):
        raise NotInSubset("a symbol table with a name or an address twice")
    if long := [n for n in names if len(n) > LONGEST]:
        raise NotInSubset(f"{long[0]} has {len(long[0])} characters; a symbol has {LONGEST} at most")
    wanted = [r[:3] for r in _blocks(blocks)]
    if [r[:3] for r in rows[: len(wanted)]] != wanted:
        raise NotInSubset("a symbol table with other blocks")
    found = []
    for name, address, kind, _ in rows[len(wanted) :]:
        place = re.fullmatch(r"([IQ]) ([0-9]+\.[0-7])", address)
        if place is None or kind != "BOOL":
            raise NotInSubset(f"{name} is no bit of an input or output")
        found.append(Declaration(name, "BOOL", address=f"%{place[1]}X{place[2]}"))
    return tuple(found)


def _blocks(blocks: Sequence[Block]) -> list[list[str]]:
    """A row for each block, numbered kind by kind; an instance names its block."""
    number: dict[str, str] = {}
    count = dict.fromkeys(_KINDS.values(), 0)
    rows = [["TON", "SFB 4", "SFB 4", "on-delay timer"]]
    for b in blocks:
        kind = _KINDS[b.kind]
        count[kind] += 1
        number[b.name] = own = f"{kind} {count[kind]}"
        rows.append([b.name, own, number.get(b.locals[0].type, own) if b.kind == "INSTANCE" else own, ""])
    return rows


def _wires(wires: Block) -> list[list[str]]:
    plain = re.compile(r"[^ -~]|\"")
    return [
        [d.name, f"{d.address[1]} {d.address[3:]}", "BOOL", plain.sub("_", d.note)[:80]]
        for d in wires.locals
        if d.address
    ]
