"""PLCopen XML (TC6): 2.01 for Beremiz, TwinCAT and others; 2.00, as CODESYS itself writes it, is `codesys.py`."""

from __future__ import annotations

import re
import xml.etree.ElementTree as ElementTree
from collections.abc import Mapping
from dataclasses import replace
from types import MappingProxyType
from xml.sax.saxutils import escape, quoteattr

from interlock.st.ast import Block, Bool, Declaration, Expression, Int, Task, Unit
from interlock.st.dialects.dialect import Dialect, Files, Unsupported
from interlock.st.dialects.strict import DECLARATION, Rule, expect, parse
from interlock.st.parser import NotInSubset, parse_block, parse_structure
from interlock.st.printer import body
from interlock.st.structures import plain, structured

XHTML = "http://www.w3.org/1999/xhtml"
_PARTS = (("inputVars", "VAR_INPUT"), ("outputVars", "VAR_OUTPUT"), ("inOutVars", "VAR_IN_OUT"), ("localVars", "VAR"))
_KINDS = {"FUNCTION_BLOCK": "functionBlock", "PROGRAM": "program"}
_RUN = ("resource", "task", "pouInstance")
_WHEN = "2000-01-01T00:00:00"  # the same bytes for the same controller


def rules(space: str, shown: str, more: Mapping[str, Rule] = MappingProxyType({})) -> dict[str, Rule]:
    """The part of the schema that is written: nothing retained or constant, no action, one configuration at most.

    `shown`: the element of XHTML that holds a text; `more`: what a further language of bodies has.
    """
    note = "documentation"
    found = {
        "project": Rule(children="fileHeader contentHeader types instances"),
        "fileHeader": Rule("companyName productName productVersion creationDateTime contentDescription"),
        "contentHeader": Rule("name modificationDateTime", "coordinateInfo"),
        "coordinateInfo": Rule(children="fbd ld sfc"),
        **dict.fromkeys(("fbd", "ld", "sfc"), Rule(children="scaling")),
        "scaling": Rule("x y"),
        "types": Rule(children="dataTypes pous"),
        "dataTypes": Rule(children="dataType*"),
        "dataType": Rule("name", "baseType documentation"),
        "baseType": Rule(children="struct"),
        "struct": Rule(children="variable*"),
        "pous": Rule(children="pou*"),
        "pou": Rule("name pouType", f"interface body {note}"),
        "interface": Rule(children=" ".join(p for p, _ in _PARTS)),
        **dict.fromkeys((p for p, _ in _PARTS), Rule(children="variable*")),
        "variable": Rule("name address", f"type initialValue {note}"),
        "type": Rule(children="BOOL INT derived"),
        "derived": Rule("name"),
        "initialValue": Rule(children="simpleValue"),
        "simpleValue": Rule("value"),
        "body": Rule(children="ST"),
        "ST": Rule(children=shown),
        note: Rule(children=shown),
        "instances": Rule(children="configurations"),
        "configurations": Rule(children="configuration"),
        "configuration": Rule("name", "resource"),
        "resource": Rule("name", "task"),
        "task": Rule("name interval priority", "pouInstance"),
        "pouInstance": Rule("name typeName"),
        **dict.fromkeys(("BOOL", "INT"), Rule()),
        shown: Rule(text=True),
    }

    found |= more

    def full(name: str) -> str:
        return f"{{{XHTML if name.rstrip('*') == shown else space}}}{name}"

    return {full(n): Rule(r.attributes, " ".join(map(full, r.children.split())), r.text) for n, r in found.items()}


class PlcOpen:
    """Writer and reader for one version of the schema.

    `whole`: a text stands in an element `xhtml`, as CODESYS writes it; else in a paragraph, as Beremiz does.
    """

    def __init__(self, version: str, whole: bool, more: Mapping[str, Rule] = MappingProxyType({})) -> None:
        self.space = f"http://www.plcopen.org/xml/tc6_{version}"
        self.shown = "xhtml" if whole else "p"
        self.rules = rules(self.space, self.shown, more)

    def write(self, unit: Unit) -> dict[str, str]:
        """One project file with a POU for each block, and the configuration that runs a program."""
        main = next(b.name for b in reversed(unit.blocks) if b.kind == "FUNCTION_BLOCK")
        blocks = structured(unit).blocks
        note = " ".join(unit.header)
        lines = [
            DECLARATION,
            f'<project xmlns="{self.space}" xmlns:xhtml="{XHTML}">',
            f'  <fileHeader companyName="interlock" productName="interlock" productVersion="1" '
            f'creationDateTime="{_WHEN}" contentDescription={quoteattr(note)}/>',
            f'  <contentHeader name="{main}" modificationDateTime="{_WHEN}">',
            "    <coordinateInfo>",
            *(f'      <{x}><scaling x="1" y="1"/></{x}>' for x in ("fbd", "ld", "sfc")),
            "    </coordinateInfo>",
            "  </contentHeader>",
            "  <types>",
            "    <dataTypes>",
            *(line for b in blocks if b.kind == "STRUCT" for line in self._structure(b)),
            "    </dataTypes>",
            "    <pous>",
        ]
        index = "\n".join(("", *unit.index)) if unit.index else ""
        for b in blocks:
            if b.kind == "STRUCT":
                continue
            lines += self._pou(replace(b, note=b.note + index) if b.name == main else b)
        lines += [
            "    </pous>",
            "  </types>",
            "  <instances>",
            *(self._configurations(unit.task) if unit.task is not None else ["    <configurations/>"]),
            "  </instances>",
            "</project>",
            "",
        ]
        return {f"{main.removeprefix('IL_')}.xml": "\n".join(lines)}

    def read(self, files: Files) -> Unit:
        """The blocks of a project file."""
        (text,) = files.values()
        root = parse(text)
        expect(root, self.rules)
        if root.tag != f"{{{self.space}}}project":
            raise NotInSubset("no PLCopen XML project of this version")
        found = root.find(self._path("instances/configurations/configuration"))
        task = self._task(found) if found is not None else None
        structures = [self._members(x) for x in root.findall(self._path("types/dataTypes/dataType"))]
        blocks = [self._block(p) for p in root.findall(self._path("types/pous/pou"))]
        return plain(Unit((*structures, *blocks), task=task))

    def _members(self, x: ElementTree.Element) -> Block:
        """A structure; its members are plain."""
        name, members = x.get("name", ""), x.findall(self._path("baseType/struct/variable"))
        if not re.fullmatch(r"\w+", name, re.ASCII):
            raise NotInSubset(f"a data type without a name: {name!r}")
        return parse_structure(
            "\n".join([f"TYPE {name} : STRUCT", *map(self._variable, members), "END_STRUCT;", "END_TYPE"])
        )

    def _task(self, configuration: ElementTree.Element) -> Task:
        """The one task of a configuration, and the program that it runs."""
        found = [configuration, *(configuration.find(self._path("/".join(_RUN[: n + 1]))) for n in range(len(_RUN)))]
        wanted = {"name"}, {"name"}, {"name", "interval", "priority"}, {"name", "typeName"}
        for x, attributes in zip(found, wanted, strict=True):
            if (
                x is None
                or set(x.attrib) != attributes
                or not all(re.fullmatch(r"[\w#]+", v) for v in x.attrib.values())
            ):
                raise NotInSubset("a configuration that is not one task with one program")
        parts = [dict(x.attrib) for x in found if x is not None]
        interval = re.fullmatch(r"T#([0-9]+)ms", parts[2]["interval"])
        if interval is None or parts[2]["priority"] != "0":
            raise NotInSubset("a task without an interval in milliseconds, or of another priority")
        names = [p["name"] for p in parts]
        return Task(names[0], names[1], names[2], int(interval[1]), names[3], parts[3]["typeName"])

    def _configurations(self, t: Task) -> list[str]:
        """What runs a program."""
        return [
            "    <configurations>",
            f'      <configuration name="{t.configuration}"><resource name="{t.resource}">',
            f'        <task name="{t.name}" interval="T#{t.interval_ms}ms" priority="0">',
            f'          <pouInstance name="{t.instance}" typeName="{t.program}"/>',
            "        </task>",
            "      </resource></configuration>",
            "    </configurations>",
        ]

    def _path(self, path: str) -> str:
        return "/".join(f"{{{self.space}}}{p}" for p in path.split("/"))

    def _block(self, pou: ElementTree.Element) -> Block:
        name = pou.get("name", "")
        kind = {text: k for k, text in _KINDS.items()}.get(pou.get("pouType", ""))
        if kind is None:
            raise NotInSubset(f"{name} is no function block and no program")
        interface = pou.find(self._path("interface"))
        if interface is None:
            raise NotInSubset(f"{name} has no interface")
        declared = []
        for part in interface:
            title = dict(_PARTS).get(part.tag.rsplit("}", 1)[1])
            if title is None:
                raise NotInSubset(f"{name}: unknown part {part.tag}")
            declared += [title, *(self._variable(v) for v in part), "END_VAR"]
        return self._read_body(pou, name, "\n".join(declared), kind)

    def _read_body(self, pou: ElementTree.Element, name: str, declared: str, kind: str) -> Block:
        """The block with its statements."""
        text = pou.findtext(f"{self._path('body/ST')}/{{{XHTML}}}{self.shown}")
        if text is None:
            raise NotInSubset(f"{name} has no text")
        return parse_block(name, declared, text, kind)

    def _variable(self, v: ElementTree.Element) -> str:
        kind = v.find(self._path("type"))
        if kind is None or len(kind) != 1:
            raise NotInSubset(f"{v.get('name')} has no type")
        own = kind[0].get("name") or kind[0].tag.rsplit("}", 1)[1]
        value = v.find(self._path("initialValue/simpleValue"))
        words = (v.get("name", ""), own, *((value.get("value", ""),) if value is not None else ()))
        if not all(re.fullmatch(r"\w+", w, re.ASCII) for w in words):
            raise NotInSubset(f"{v.get('name')}: a name, type or value that is not one word")
        address = v.get("address")
        if address is not None and not re.fullmatch(r"%[IQ]X[0-9]+\.[0-7]", address):
            raise NotInSubset(f"{v.get('name')}: an address that is no bit of an input or output")
        where = f" AT {address}" if address is not None else ""
        return f"{words[0]}{where} : {words[1]}" + (f" := {words[2]};" if words[2:] else ";")

    def _structure(self, b: Block) -> list[str]:
        members = [f"      {self._declared(d)}" for d in b.locals]
        note = f"<documentation>{self._text(b.note)}</documentation>"
        head = f'      <dataType name="{b.name}"><baseType><struct>'
        return [head, *members, f"      </struct></baseType>{note}</dataType>"]

    def _pou(self, b: Block) -> list[str]:
        lines = [f'      <pou name="{b.name}" pouType="{_KINDS[b.kind]}">', "        <interface>"]
        for (tag, _), part in zip(_PARTS, (b.inputs, b.outputs, b.handed, b.locals), strict=True):
            if part:
                lines += [f"          <{tag}>", *(self._declared(d) for d in part), f"          </{tag}>"]
        return [
            *lines,
            "        </interface>",
            *self._body(b),
            f"        <documentation>{self._text(b.note)}</documentation>",
            "      </pou>",
        ]

    def _body(self, b: Block) -> list[str]:
        """The statements of a block as Structured Text."""
        return [f"        <body><ST>{self._text(chr(10).join(body(b)))}</ST></body>"]

    def _text(self, text: str) -> str:
        if self.shown == "p":
            return f"<xhtml:p>{escape(text)}</xhtml:p>"
        return f'<xhtml xmlns="{XHTML}">{escape(text)}</xhtml>'

    def _declared(self, d: Declaration) -> str:
        kind = f"<{d.type}/>" if d.type in ("BOOL", "INT") else f'<derived name="{d.type}"/>'
        value = f'<initialValue><simpleValue value="{_literal(d.initial)}"/></initialValue>' if d.initial else ""
        note = f"<documentation>{self._text(d.note)}</documentation>" if d.note else ""
        where = f' address="{d.address}"' if d.address else ""
        return f'            <variable name="{d.name}"{where}><type>{kind}</type>{value}{note}</variable>'


def _literal(x: Expression) -> str:
    if isinstance(x, Bool):
        return "TRUE" if x.value else "FALSE"
    if isinstance(x, Int):
        return str(x.value)
    raise Unsupported(f"an initial value that is no literal: {x}")


_TC6_201 = PlcOpen("0201", False)

DIALECT = Dialect("plcopen", "PLCopen XML TC6 2.01: Beremiz and others", _TC6_201.write, _TC6_201.read, form=structured)
