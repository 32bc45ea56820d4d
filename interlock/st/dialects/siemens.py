"""The files for Siemens S7-1200 and S7-1500: the interlocking, the mapping program as a function, OB1.

The function reads terminals by their names in the table of tags; what the operator's place writes and reads
lies in one global data block; each block that keeps something has an instance data block.  In the tree it is the same
program as in all dialects: a name in double quotes stands for a wire, a member of the global block for a variable of
the operator's place, an instance data block for an instance.

The forms are those of exported sources of TIA Portal; the tool was not at hand.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

from interlock.st.ast import Block, Call, Declaration, Statement, Task, Unit
from interlock.st.dialects.dialect import Files
from interlock.st.parser import NotInSubset, parse_block, parse_unit
from interlock.st.printer import body, comment, declarations, print_block, print_unit
from interlock.st.program import INSTANCE, Runs
from interlock.st.restart import RESTART
from interlock.st.style import Style

OPERATOR = "HMI"
"""The global data block: what the operator's place writes and reads, and VALID."""
_MARKED = Style(local="#")
_COMMENT = re.compile(r"\(\*(?:[^*]|\*(?!\)))*\*\)")
_QUOTED = re.compile(r'"\w+"(?:\."\w+")?(?:\(|\.\w+)?', re.ASCII)


@dataclass(frozen=True)
class Family:
    """What a tool of this family wants.

    attributes: after the name of a block; data: after that of the global data block.  void: the type of a function
    without a result.  cycle, startup: what the organization blocks are called.
    """

    style: Style
    attributes: tuple[str, ...] = ()
    data: tuple[str, ...] = ()
    void: str = "VOID"
    cycle: str = "OB1"
    startup: str = "OB100"

    def write(self, unit: Unit) -> dict[str, str]:
        """The interlocking; with a mapping program that too, and the organization blocks."""
        if unit.blocks[-1].kind != "PROGRAM":
            return {f"{_name(unit.blocks[-1].name)}.scl": print_unit(unit, self.style)}
        *blocks, program = unit.blocks
        instances = _instances(program)
        main = instances[INSTANCE]
        helpers = [b for b in blocks if b.name in instances.values() and b.name != main]
        core = Unit(tuple(b for b in blocks if b not in helpers), header=unit.header)
        name = _name(main)
        files = self.write(core)
        files[f"{name}_io.scl"] = self._mapping(program, helpers, unit.header, main)
        files[f"{name}_ob.scl"] = self._organization(unit.task, main, unit.header)
        return files

    def _mapping(self, program: Block, helpers: Sequence[Block], header: Sequence[str], main: str) -> str:
        lines = [comment(x) for x in header]
        for b in helpers:
            lines += ["", *print_block(b, self.style)]
        for n, kind in _instances(program).items():
            if n != INSTANCE:
                lines += [
                    "",
                    f'DATA_BLOCK "{self._data(main, n)}"',
                    *self.attributes,
                    f'"{kind}"',
                    "BEGIN",
                    "END_DATA_BLOCK",
                ]
        members = declarations(Block("", (), (), _operators(program), ()))[1:-1]
        lines += ["", f'DATA_BLOCK "{main}_{OPERATOR}"', *self.data, "STRUCT", *members, "END_STRUCT;"]
        lines += ["BEGIN", "END_DATA_BLOCK"]
        lines += ["", f'FUNCTION "{program.name}" : {self.void}', *self.attributes, comment(program.note), "BEGIN"]
        shown = self._shown(program, main)
        for s in program.body:
            lines += [_put(x, shown) for x in _printed(s)]
        return "\n".join([*lines, "END_FUNCTION", ""])

    def _organization(self, task: Task | None, main: str, header: Sequence[str]) -> str:
        """The blocks that call the program, and tell it of a restart."""
        assert task is not None
        lines = [*map(comment, header), "", *self._block(self.cycle, f'"{task.program}"();')]
        if task.startup:
            lines += ["", *self._block(self.startup, f'"{main}_{OPERATOR}".{task.startup} := TRUE;')]
        return "\n".join([*lines, ""])

    def _block(self, name: str, statement: str) -> list[str]:
        lines = [f"ORGANIZATION_BLOCK {name}", *self.attributes, "BEGIN", f"  {statement}"]
        return [*lines, "END_ORGANIZATION_BLOCK"]

    def _data(self, main: str, instance: str) -> str:
        """The data block of an instance; that of the interlocking itself stands with it."""
        return f"DB_{main}" if instance == INSTANCE else f"{main}_{instance}"

    def _shown(self, program: Block, main: str) -> dict[str, str]:
        """How each name of the program is written; that of an instance with a bracket is its call."""
        shown: dict[str, str] = {}
        operators = {d.name for d in _operators(program)}
        for d in program.locals:
            if d.type not in ("BOOL", "INT"):
                shown[d.name] = f'"{self._data(main, d.name)}"'
                shown[f"{d.name}("] = f"{shown[d.name]}("
            else:
                shown[d.name] = f'"{main}_{OPERATOR}".{d.name}' if d.name in operators else f'"{d.name}"'
        return shown

    def read(self, files: Files) -> Unit:
        """The blocks of the files; a mapping program is last.

        Each wire is declared without an address: that stands in the table of tags.
        """
        sources = [t for n, t in files.items() if n.endswith(".scl") and not n.endswith(("_io.scl", "_ob.scl"))]
        if len(sources) != 1:
            raise NotInSubset("not one file with the interlocking")
        core = parse_unit(sources[0], self.style)
        main = core.blocks[-1].name
        if len(files) == 1:
            return core
        name = _name(main)
        sections = _sections(uncommented(files[f"{name}_io.scl"]))
        helpers = parse_unit("\n".join(sections["FUNCTION_BLOCK"]), replace(self.style, instance="")).blocks
        (function,) = sections["FUNCTION"]
        held = [self._held(x, main) for x in sections["DATA_BLOCK"]]
        declared = (*(d for part in held for d in part), Declaration(INSTANCE, main))
        program = self._function(function, main, declared)
        task = self._task(uncommented(files[f"{name}_ob.scl"]), program.name, main)
        expected = {f"{name}{x}" for x in (".scl", "_io.scl", "_ob.scl")}
        if set(files) != expected:
            raise NotInSubset(f"files are not {', '.join(sorted(expected))}")
        return Unit((*helpers, *core.blocks, program), task=task)

    def _held(self, text: str, main: str) -> tuple[Declaration, ...]:
        """An instance, or the variables of the operator's place."""
        own = "".join(f"{re.escape(x)}\n" for x in self.attributes)
        prefix = self._data(main, "")
        frame = rf'DATA_BLOCK "{prefix}(\w+)"\n{own}"(\w+)"\nBEGIN\nEND_DATA_BLOCK\n'
        if found := re.fullmatch(frame, text, re.ASCII):
            return (Declaration(found[1], found[2]),)
        data = "".join(f"{re.escape(x)}\n" for x in self.data)
        frame = rf'DATA_BLOCK "{main}_{OPERATOR}"\n{data}STRUCT\n(.*)END_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n'
        if found := re.fullmatch(frame, text, re.DOTALL):
            return parse_block(main, f"VAR\n{found[1]}END_VAR\n", "").locals
        raise NotInSubset("a data block that is neither an instance nor the operator's")

    def _function(self, text: str, main: str, declared: tuple[Declaration, ...]) -> Block:
        """The mapping program; a name in quotes that nothing else has is a wire."""
        own = "".join(f"{re.escape(x)}\n" for x in self.attributes)
        found = re.fullmatch(rf'FUNCTION "({main}_IO)" : {self.void}\n{own}BEGIN\n(.*)END_FUNCTION\n', text, re.DOTALL)
        if found is None or "#" in found[2]:
            raise NotInSubset("no function as it is written")
        program = Block(found[1], (), (), declared, (), kind="PROGRAM")
        names = {shown: f"#{n}" for n, shown in self._shown(program, main).items()}
        taken = {d.name for d in declared}
        wires: dict[str, None] = {}

        def put(m: re.Match[str]) -> str:
            if m[0] in names:
                return names[m[0]]
            instance, _, output = m[0].rpartition(".")
            if instance in names:
                return f"{names[instance]}.{output}"
            if not re.fullmatch(r'"\w+"', m[0]) or m[0][1:-1] in taken:
                raise NotInSubset(f"{m[0]} is not declared")
            wires[m[0][1:-1]] = None
            return f"#{m[0][1:-1]}"

        marked = parse_unit(f"PROGRAM X\n{_QUOTED.sub(put, found[2])}END_PROGRAM\n", _MARKED)
        locals_ = (*(Declaration(n, "BOOL") for n in wires), *declared)
        return replace(program, locals=locals_, body=marked.blocks[0].body)

    def _task(self, text: str, program: str, main: str) -> Task:
        """What the organization blocks do: exactly as they are written, or it is refused."""
        for startup in ("", RESTART):
            task = Task("", "", Runs.CYCLE.value, 0, "", program, startup)
            if text == uncommented(self._organization(task, main, ())):
                return task
        raise NotInSubset("organization blocks that do something else")


def _name(main: str) -> str:
    return main.removeprefix("IL_")


def _instances(program: Block) -> dict[str, str]:
    return {d.name: d.type for d in program.locals if d.type not in ("BOOL", "INT")}


def _operators(program: Block) -> tuple[Declaration, ...]:
    """The variables of the operator's place, and those of the program itself: what has no address."""
    return tuple(d for d in program.locals if d.type in ("BOOL", "INT") and not d.address)


def _printed(s: Statement) -> list[str]:
    """The lines of a statement with marked names; a call has a line for each parameter."""
    if not isinstance(s, Call) or len(s.params) < 3:
        return body(Block("", (), (), (), (s,)), _MARKED)
    lines = [f"    {n} := #{x}," for n, x in s.params]
    return [f"  #{s.instance}(", *lines[:-1], f"{lines[-1].removesuffix(',')});"]


def _put(line: str, shown: Mapping[str, str]) -> str:
    """A line with marked names, each as the function writes it."""
    return re.sub(r"#(\w+\(?)", lambda m: shown[m[1]], line, flags=re.ASCII)


def uncommented(text: str) -> str:
    """Without comments and empty lines; what other tools might take for a comment is refused."""
    text = re.sub(r"[ \t]+$", "", _COMMENT.sub("", text), flags=re.MULTILINE)
    if not text.isascii() or any(x in text for x in ("//", "/*", "(*", "*)", "\r", "\f", "\v")):
        raise NotInSubset("a comment of another kind")
    return re.sub(r"\n\n+", "\n", text).lstrip("\n")


def _sections(text: str) -> dict[str, list[str]]:
    """What a source defines, by kind."""
    found: dict[str, list[str]] = {"FUNCTION_BLOCK": [], "DATA_BLOCK": [], "FUNCTION": []}
    at = 0
    for m in re.finditer(rf"({'|'.join(found)}) .*?\nEND_\1\n", text, re.DOTALL):
        if m.start() != at:
            break
        found[m[1]].append(m[0])
        at = m.end()
    if at != len(text) or len(found["FUNCTION"]) != 1 or not found["FUNCTION_BLOCK"]:
        raise NotInSubset(f"something that is no block of a mapping program: {text[at : at + 40]!r}")
    return found
