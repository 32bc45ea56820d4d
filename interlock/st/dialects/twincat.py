"""TwinCAT 3: one .TcPOU file for each block, declarations and statements apart; a .TcDUT file for each structure, a
.TcTTO file for the task.

The form of the task's file is that of public projects; no TwinCAT was at hand.
"""

from __future__ import annotations

import re
import uuid
from collections.abc import Sequence
from xml.sax.saxutils import quoteattr

from interlock.st.ast import Block, Task, Unit
from interlock.st.dialects.dialect import Dialect, Files
from interlock.st.dialects.strict import DECLARATION, Rule, expect, parse
from interlock.st.parser import NotInSubset, parse_block, parse_structure
from interlock.st.printer import body, comment, declarations, structure, wrapped
from interlock.st.program import Runs
from interlock.st.structures import plain, structured
from interlock.st.style import COMMENT, SPACE

_RULES = {
    "TcPlcObject": Rule("Version ProductVersion", "POU DUT"),
    "DUT": Rule("Name Id", "Declaration"),
    "POU": Rule("Name Id SpecialFunc", "Declaration Implementation"),
    "Declaration": Rule(text=True),
    "Implementation": Rule(children="ST"),
    "ST": Rule(text=True),
}
_TASK_RULES = {
    "TcPlcObject": Rule("Version ProductVersion", "Task"),
    "Task": Rule("Name Id", "CycleTime Priority PouCall TaskFBGuid"),
    "PouCall": Rule(children="Name"),
    **dict.fromkeys(("CycleTime", "Priority", "Name", "TaskFBGuid"), Rule(text=True)),
}
_HEAD = re.compile(rf"(?:{COMMENT}(?:{SPACE})?)*(FUNCTION_BLOCK|PROGRAM|TYPE) (\w+)(?: :)?\n")
_END = "END_STRUCT"
"""How a structure closes here: without a semicolon."""
_OBJECT = '<TcPlcObject Version="1.1.0.1" ProductVersion="3.1.4024.0">'
PRIORITY = 20  # that of the task in a new project

_SPACE = uuid.UUID("6b1c1d52-3f0e-4c44-8b5e-0d5d6c6f1a11")


def _identity(what: str) -> str:
    """The same for the same name."""
    return "{" + str(uuid.uuid5(_SPACE, what)) + "}"


def _file(b: Block, header: Sequence[str]) -> str:
    note = [comment(b.note)] if b.note else []
    head = [*map(comment, header), f"{b.kind} {b.name}", *note, *declarations(b)]
    identity = _identity(b.name)
    return "\n".join(
        [
            DECLARATION,
            _OBJECT,
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


def _structure(b: Block, header: Sequence[str]) -> str:
    return "\n".join(
        [
            DECLARATION,
            _OBJECT,
            f'  <DUT Name={quoteattr(b.name)} Id="{_identity(b.name)}">',
            "    <Declaration><![CDATA["
            + "\n".join([*map(comment, header), *structure(b, _END)])
            + "\n]]></Declaration>",
            "  </DUT>",
            "</TcPlcObject>",
            "",
        ]
    )


def write(unit: Unit) -> dict[str, str]:
    """A file for each structure, one for each block, and one for the task."""
    main = next(b.name for b in reversed(unit.blocks) if b.kind == "FUNCTION_BLOCK")
    index = [x for line in unit.index for x in wrapped(line)]
    files: dict[str, str] = {}
    for b in structured(unit).blocks:
        if b.kind == "STRUCT":
            files[f"{b.name}.TcDUT"] = _structure(b, unit.header)
        else:
            files[f"{b.name}.TcPOU"] = _file(b, [*unit.header, *(index if b.name == main else ())])
    return files if unit.task is None else files | {f"{unit.task.name}.TcTTO": _task_file(unit.task)}


def _task_file(t: Task) -> str:
    """A task that runs a program; its interval is told in microseconds."""
    return "\n".join(
        [
            DECLARATION,
            _OBJECT,
            f"  <Task Name={quoteattr(t.name)} Id={quoteattr(_identity(t.name))}>",
            f"    <CycleTime>{1000 * t.interval_ms}</CycleTime>",
            f"    <Priority>{PRIORITY}</Priority>",
            "    <PouCall>",
            f"      <Name>{t.program}</Name>",
            "    </PouCall>",
            f"    <TaskFBGuid>{_identity(f'{t.name} block')}</TaskFBGuid>",
            "  </Task>",
            "</TcPlcObject>",
            "",
        ]
    )


def read(files: Files) -> Unit:
    """The blocks of all files."""
    tasks = [_task(name, text) for name, text in files.items() if name.endswith(".TcTTO")]
    if len(tasks) > 1:
        raise NotInSubset("more than one task")
    blocks = [_block(name, text) for name, text in sorted(files.items()) if not name.endswith(".TcTTO")]
    return plain(Unit(tuple(blocks), task=tasks[0] if tasks else None))


def _task(name: str, text: str) -> Task:
    root = parse(text)
    expect(root, _TASK_RULES)
    task = root.find("Task")
    cycle, program = root.findtext("Task/CycleTime", ""), root.findtext("Task/PouCall/Name", "")
    if root.tag != "TcPlcObject" or task is None or name != f"{task.get('Name')}.TcTTO":
        raise NotInSubset(f"{name}: no task of that name")
    if not cycle.isdigit() or int(cycle) % 1000 or root.findtext("Task/Priority") != str(PRIORITY):
        raise NotInSubset(f"{name}: a cycle that is no whole number of milliseconds, or another priority")
    return Task("", "", task.get("Name", ""), int(cycle) // 1000, "", program)


def _block(name: str, text: str) -> Block:
    root = parse(text)
    expect(root, _RULES)
    dut, pou = root.find("DUT"), root.find("POU")
    if dut is not None and pou is None and root.tag == "TcPlcObject":
        return _members(name, dut.get("Name", ""), root.findtext("DUT/Declaration", ""))
    declared, implemented = root.findtext("POU/Declaration"), root.findtext("POU/Implementation/ST")
    if root.tag != "TcPlcObject" or dut is not None or pou is None or declared is None or implemented is None:
        raise NotInSubset(f"{name}: no POU with declaration and implementation")
    own, head = pou.get("Name", ""), _HEAD.match(declared)
    if (
        head is None
        or head[1] == "TYPE"
        or head[2] != own
        or name != f"{own}.TcPOU"
        or pou.get("SpecialFunc") != "None"
    ):
        raise NotInSubset(f"{name}: the names of file, object and block differ, or more than comments stand before")
    return parse_block(own, declared[head.end() :], implemented, head[1])


def _members(name: str, own: str, declared: str) -> Block:
    """A structure."""
    head = _HEAD.match(declared)
    if head is None or head[1] != "TYPE" or head[2] != own or name != f"{own}.TcDUT":
        raise NotInSubset(f"{name}: the names of file, object and structure differ, or more than comments stand before")
    return parse_structure(declared[head.start(1) :], _END)


DIALECT = Dialect("twincat", "Beckhoff TwinCAT 3, .TcPOU files", write, read, runs=Runs.TASK, form=structured)
