"""PLCopen XML (TC6): 2.01 for Beremiz, TwinCAT and others; 2.00 as CODESYS itself writes it."""

from __future__ import annotations

import re
import xml.etree.ElementTree as ElementTree
from xml.sax.saxutils import escape, quoteattr

from interlock.st.ast import Block, Bool, Declaration, Expression, Int, Unit
from interlock.st.dialects.dialect import Dialect, Files, Unsupported
from interlock.st.dialects.strict import Rule, expect, parse
from interlock.st.parser import NotInSubset, parse_block
from interlock.st.printer import body

XHTML = "http://www.w3.org/1999/xhtml"
_PARTS = (("inputVars", "VAR_INPUT"), ("outputVars", "VAR_OUTPUT"), ("localVars", "VAR"))
_WHEN = "2000-01-01T00:00:00"  # the same bytes for the same controller


def _rules(space: str) -> dict[str, Rule]:
    """The part of the schema that is written: nothing retained or constant, no address, no action, no instance."""
    note = "documentation"
    rules = {
        "project": Rule(children="fileHeader contentHeader types instances"),
        "fileHeader": Rule("companyName productName productVersion creationDateTime contentDescription"),
        "contentHeader": Rule("name modificationDateTime", "coordinateInfo"),
        "coordinateInfo": Rule(children="fbd ld sfc"),
        **dict.fromkeys(("fbd", "ld", "sfc"), Rule(children="scaling")),
        "scaling": Rule("x y"),
        "types": Rule(children="dataTypes pous"),
        "pous": Rule(children="pou*"),
        "pou": Rule("name pouType", f"interface body {note}"),
        "interface": Rule(children=" ".join(p for p, _ in _PARTS)),
        **dict.fromkeys((p for p, _ in _PARTS), Rule(children="variable*")),
        "variable": Rule("name", f"type initialValue {note}"),
        "type": Rule(children="BOOL INT derived"),
        "derived": Rule("name"),
        "initialValue": Rule(children="simpleValue"),
        "simpleValue": Rule("value"),
        "body": Rule(children="ST"),
        "ST": Rule(children="p"),
        note: Rule(children="p"),
        "instances": Rule(children="configurations"),
        **dict.fromkeys(("dataTypes", "configurations", "BOOL", "INT"), Rule()),
        "p": Rule(text=True),
    }

    def full(name: str) -> str:
        return f"{{{XHTML if name.rstrip('*') == 'p' else space}}}{name}"

    return {full(n): Rule(r.attributes, " ".join(map(full, r.children.split())), r.text) for n, r in rules.items()}


class PlcOpen:
    """Writer and reader for one version of the schema."""

    def __init__(self, version: str) -> None:
        self.space = f"http://www.plcopen.org/xml/tc6_{version}"

    def write(self, unit: Unit) -> dict[str, str]:
        """One project file with a POU for each block."""
        main = unit.blocks[-1].name
        note = " ".join(unit.header)
        lines = [
            '<?xml version="1.0" encoding="utf-8"?>',
            f'<project xmlns="{self.space}" xmlns:xhtml="{XHTML}">',
            f'  <fileHeader companyName="interlock" productName="interlock" productVersion="1" '
            f'creationDateTime="{_WHEN}" contentDescription={quoteattr(note)}/>',
            f'  <contentHeader name="{main}" modificationDateTime="{_WHEN}">',
            "    <coordinateInfo>",
            *(f'      <{x}><scaling x="1" y="1"/></{x}>' for x in ("fbd", "ld", "sfc")),
            "    </coordinateInfo>",
            "  </contentHeader>",
            "  <types>",
            "    <dataTypes/>",
            "    <pous>",
        ]
        for b in unit.blocks:
            lines += _pou(b)
        lines += [
            "    </pous>",
            "  </types>",
            "  <instances>",
            "    <configurations/>",
            "  </instances>",
            "</project>",
            "",
        ]
        return {f"{main.removeprefix('IL_')}.xml": "\n".join(lines)}

    def read(self, files: Files) -> Unit:
        """The blocks of a project file."""
        (text,) = files.values()
        root = parse(text)
        expect(root, _rules(self.space))
        if root.tag != f"{{{self.space}}}project":
            raise NotInSubset("no PLCopen XML project of this version")
        return Unit(tuple(self._block(p) for p in root.findall(self._path("types/pous/pou"))))

    def _path(self, path: str) -> str:
        return "/".join(f"{{{self.space}}}{p}" for p in path.split("/"))

    def _block(self, pou: ElementTree.Element) -> Block:
        name = pou.get("name", "")
        if pou.get("pouType") != "functionBlock":
            raise NotInSubset(f"{name} is no function block")
        interface = pou.find(self._path("interface"))
        text = pou.findtext(f"{self._path('body/ST')}/{{{XHTML}}}p")
        if interface is None or text is None:
            raise NotInSubset(f"{name} has no interface or no text")
        declared = []
        for part in interface:
            title = dict(_PARTS).get(part.tag.rsplit("}", 1)[1])
            if title is None:
                raise NotInSubset(f"{name}: unknown part {part.tag}")
            declared += [title, *(self._variable(v) for v in part), "END_VAR"]
        return parse_block(name, "\n".join(declared), text)

    def _variable(self, v: ElementTree.Element) -> str:
        kind = v.find(self._path("type"))
        if kind is None or len(kind) != 1:
            raise NotInSubset(f"{v.get('name')} has no type")
        own = kind[0].get("name") or kind[0].tag.rsplit("}", 1)[1]
        value = v.find(self._path("initialValue/simpleValue"))
        words = (v.get("name", ""), own, *((value.get("value", ""),) if value is not None else ()))
        if not all(re.fullmatch(r"\w+", w, re.ASCII) for w in words):
            raise NotInSubset(f"{v.get('name')}: a name, type or value that is not one word")
        return f"{words[0]} : {words[1]}" + (f" := {words[2]};" if words[2:] else ";")


def _pou(b: Block) -> list[str]:
    lines = [f'      <pou name="{b.name}" pouType="functionBlock">', "        <interface>"]
    for (tag, _), part in zip(_PARTS, (b.inputs, b.outputs, b.locals), strict=True):
        if part:
            lines += [f"          <{tag}>", *(_variable(d) for d in part), f"          </{tag}>"]
    text = "\n".join(body(b))
    return [
        *lines,
        "        </interface>",
        f"        <body><ST><xhtml:p>{escape(text)}</xhtml:p></ST></body>",
        f"        <documentation><xhtml:p>{escape(b.note)}</xhtml:p></documentation>",
        "      </pou>",
    ]


def _variable(d: Declaration) -> str:
    kind = f"<{d.type}/>" if d.type in ("BOOL", "INT") else f'<derived name="{d.type}"/>'
    value = f'<initialValue><simpleValue value="{_literal(d.initial)}"/></initialValue>' if d.initial else ""
    note = f"<documentation><xhtml:p>{escape(d.note)}</xhtml:p></documentation>" if d.note else ""
    return f'            <variable name="{d.name}"><type>{kind}</type>{value}{note}</variable>'


def _literal(x: Expression) -> str:
    if isinstance(x, Bool):
        return "TRUE" if x.value else "FALSE"
    if isinstance(x, Int):
        return str(x.value)
    raise Unsupported(f"an initial value that is no literal: {x}")


_TC6_201, _TC6_200 = PlcOpen("0201"), PlcOpen("0200")

DIALECT = Dialect("plcopen", "PLCopen XML TC6 2.01: Beremiz, TwinCAT and others", _TC6_201.write, _TC6_201.read)
CODESYS = Dialect("codesys", "CODESYS V3, PLCopen XML TC6 2.00", _TC6_200.write, _TC6_200.read)
