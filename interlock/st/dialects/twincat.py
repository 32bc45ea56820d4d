"""TwinCAT 3: one .TcPOU file for each block, declarations and statements apart."""

from __future__ import annotations

import re
import uuid
from xml.sax.saxutils import quoteattr

from interlock.st.ast import Block, Unit
from interlock.st.dialects.dialect import Dialect, Files
from interlock.st.dialects.strict import Rule, expect, parse
from interlock.st.parser import NotInSubset, parse_block
from interlock.st.printer import body, comment, declarations

_RULES = {
    "TcPlcObject": Rule("Version ProductVersion", "POU"),
    "POU": Rule("Name Id SpecialFunc", "Declaration Implementation"),
    "Declaration": Rule(text=True),
    "Implementation": Rule(children="ST"),
    "ST": Rule(text=True),
}
_HEAD = re.compile(r"(?:\(\*(?:[^*]|\*(?!\)))*\*\)\s*)*FUNCTION_BLOCK (\w+)\n")

_SPACE = uuid.UUID("6b1c1d52-3f0e-4c44-8b5e-0d5d6c6f1a11")


def _file(b: Block, header: tuple[str, ...]) -> str:
    note = [comment(b.note)] if b.note else []
    head = [*map(comment, header), f"FUNCTION_BLOCK {b.name}", *note, *declarations(b)]
    identity = "{" + str(uuid.uuid5(_SPACE, b.name)) + "}"
    return "\n".join(
        [
            '<?xml version="1.0" encoding="utf-8"?>',
            '<TcPlcObject Version="1.1.0.1" ProductVersion="3.1.4024.0">',
            f'  <POU Name={quoteattr(b.name)} Id="{identity}" SpecialFunc="None">',
            "    <Declaration><![CDATA[" + "\n".join(head) + "\n]]></Declaration>",
            "    <Implementation>",
            "      <ST><![CDATA[" + "\n".join(body(b)) + "\n]]></ST>",
            "    </Implementation>",
            "  </POU>",
            "</TcPlcObject>",
            "",
        ]
    )


def write(unit: Unit) -> dict[str, str]:
    """A file for each block."""
    return {f"{b.name}.TcPOU": _file(b, unit.header) for b in unit.blocks}


def read(files: Files) -> Unit:
    """The blocks of all files; the one that no other declares an instance of comes last."""
    blocks = [_block(name, text) for name, text in sorted(files.items())]
    used = {d.type for b in blocks for d in b.locals}
    mains = [b for b in blocks if b.name not in used]
    if len(mains) != 1:
        raise NotInSubset(f"{len(mains)} blocks that no other block calls")
    return Unit((*(b for b in blocks if b is not mains[0]), mains[0]))


def _block(name: str, text: str) -> Block:
    root = parse(text)
    expect(root, _RULES)
    pou = root.find("POU")
    declared, implemented = root.findtext("POU/Declaration"), root.findtext("POU/Implementation/ST")
    if root.tag != "TcPlcObject" or pou is None or declared is None or implemented is None:
        raise NotInSubset(f"{name}: no POU with declaration and implementation")
    own, head = pou.get("Name", ""), _HEAD.match(declared)
    if head is None or head[1] != own or name != f"{own}.TcPOU" or pou.get("SpecialFunc") != "None":
        raise NotInSubset(f"{name}: the names of file, object and block differ, or more than comments stand before")
    return parse_block(own, declared[head.end() :], implemented)


DIALECT = Dialect("twincat", "Beckhoff TwinCAT 3, .TcPOU files", write, read)
