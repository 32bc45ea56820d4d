"""The files for Siemens: data blocks, functions, organization blocks; for STEP 7 classic the symbol table.

Variables lie in data blocks (`interlock.st.shared`), so that no block hands one to another: an FB that hands thousands
of values to others is larger than these controllers allow.  The forms are those of public manuals (S7-SCL and STL for
S7-300/400: sources, a call by the names of block and data block, 20 bytes of start information in an organization
block; Programming with STEP 7: the symbol table); the tool was not at hand.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence

from interlock.dataclass import dataclass
from interlock.st.ast import Block, Bool, Declaration, Int, Task, Unit
from interlock.st.dialects.dialect import Files
from interlock.st.dialects.symbols import read_symbols, symbol_table
from interlock.st.parser import NotInSubset
from interlock.st.printer import wrapped
from interlock.st.program import Runs
from interlock.st.restart import RESTART
from interlock.st.shared import INPUTS, OPERATOR, Frame, flat, frame, names_in, shared

_ABSOLUTE = re.compile(r"(?:[TCZMIQEA]|DB|DI|FB|FC|OB|SFB|SFC|UDT|P[IQEA])[BWDX]?[0-9]+")
"""What STEP 7 takes for an address, a timer or a block, whoever declares it."""


def unprintable(text: str, also: str = "") -> bool:
    """Whether signs stand in a text that end no line and are no print: tools differ on them."""
    return any(not x.isprintable() for x in set(text) - {"\n", *also})


WARM, HOT = 100, 101
"""The organization blocks that a controller calls before it begins anew, and before it goes on where it was cut."""
ONLY_400 = (
    "For an S7-400 alone, whose hot restart goes on with all values where the power was cut; better allow none.  "
    "An S7-300 has no OB101."
)
ONLY = "One interlocking in one controller: the symbol table of another gives the same numbers to its blocks."


@dataclass(frozen=True)
class Language:
    """How a language of Siemens is written.

    suffix: of a source.  comment: a line of it.  block: the lines of a block.  cycle: the lines of OB1, which calls a
    function.  startup: those of an organization block of a number, which sets a variable, and resets others.  read: the
    blocks of a source, given what is defined elsewhere.  uncommented: its text without comments.  tags: for TIA Portal,
    where addresses stand in a table of tags beside the text, data blocks forget their values over a restart, and a
    controller may hold several interlockings.
    """

    suffix: str
    comment: Callable[[str], str]
    block: Callable[[Block, Frame], list[str]]
    cycle: Callable[[str], list[str]]
    startup: Callable[[int, str, str, Sequence[Declaration]], list[str]]
    read: Callable[[str, Sequence[Block]], list[Block]]
    uncommented: Callable[[str], str]
    tags: bool = False

    def write(self, unit: Unit) -> dict[str, str]:
        """The interlocking; with a mapping program that too, the organization blocks, and the symbol table."""
        made = shared(unit, several=self.tags)
        name, core, rest = _parted(made.blocks)
        known = frame(made.blocks)
        head = [self.comment(x) for x in unit.header]
        index = [self.comment(x) for line in made.index for x in wrapped(line)]
        files = {f"{name}{self.suffix}": self._text([*head, *index], core, known)}
        if not rest:
            return files
        assert unit.task == self._task(f"IL_{name}_IO")
        *program, wires = rest
        files[f"{name}_io{self.suffix}"] = self._text(head, program, known)
        only = [] if self.tags else [self.comment(ONLY)]
        for ending, note, lines in self._organization(f"IL_{name}", made.blocks):
            notes = [*head, *only, *map(self.comment, note)]
            files[f"{name}{ending}{self.suffix}"] = "\n".join([*notes, "", *lines, ""])
        return files if self.tags else files | {f"{name}.sdf": symbol_table((*core, *program), wires)}

    def _text(self, head: Sequence[str], blocks: Sequence[Block], known: Frame) -> str:
        lines = [*head]
        for b in blocks:
            lines += ["", *self.block(b, known)]
        return "\n".join([*lines, ""])

    def _organization(self, main: str, blocks: Sequence[Block]) -> list[tuple[str, Sequence[str], list[str]]]:
        """The files with organization blocks: ending, notes at the head, lines."""
        cycle = self.cycle(f"{main}_IO")
        if self.tags:
            return [("_ob", (), cycle)]
        warm, hot = (self.startup(k, main + OPERATOR, RESTART, _buttons(main, blocks)) for k in (WARM, HOT))
        return [("_ob", (), [*cycle, "", *warm]), (f"_ob{HOT}", (ONLY_400,), hot)]

    def _task(self, program: str) -> Task:
        """OB1 runs the program; OB100, or OB101, tells it of a restart, where data outlive one."""
        return Task("", "", Runs.CYCLE.value, 0, "", program, "" if self.tags else RESTART)

    def read_files(self, files: Files) -> Unit:
        """What the files do, as in all dialects; a mapping program is last."""
        source = min((n for n in files if n.endswith(self.suffix)), key=len, default="")
        if not source:
            raise NotInSubset("no file with the interlocking")
        core = self.read(files[source], ())
        name = core[0].name.removeprefix("IL_").removesuffix(INPUTS)
        if len(files) == 1:
            self._check_names(core)
            return flat(Unit(tuple(core)), self.tags)
        endings = ("", "_io", "_ob", *(() if self.tags else (f"_ob{HOT}",)))
        expected = {f"{name}{x}{self.suffix}" for x in endings} | (set() if self.tags else {f"{name}.sdf"})
        if set(files) != expected:
            raise NotInSubset(f"files are not {', '.join(sorted(expected))}")
        program = self.read(files[f"{name}_io{self.suffix}"], core)
        self._check_names((*core, *program))
        _, mine, rest = _parted((*core, *program))
        if [*mine] != core or [*rest] != program:
            raise NotInSubset("blocks that do not stand in their own file")
        for ending, _, lines in self._organization(f"IL_{name}", (*core, *program)):
            if self.uncommented(files[f"{name}{ending}{self.suffix}"]) != self.uncommented("\n".join([*lines, ""])):
                raise NotInSubset("organization blocks that do something else")
        tagged = _terminals(program)
        held = tagged if self.tags else read_symbols(files[f"{name}.sdf"], (*core, *program))
        wires = Block("", (), (), held, (), kind="WIRES")
        return flat(Unit((*core, *program, wires), task=self._task(f"IL_{name}_IO")), self.tags)

    def _check_names(self, blocks: Sequence[Block]) -> None:
        if not self.tags:
            _no_addresses(blocks)


def _buttons(main: str, blocks: Sequence[Block]) -> tuple[Declaration, ...]:
    """What the operator's place writes and a restart resets: all inputs there that begin with 0.  Blocks begin with 1,
    and stay as they were."""
    held = {b.name: b.locals for b in blocks if b.kind == "DATA_BLOCK"}
    read = {d.name for d in held.get(main + INPUTS, ())}
    return tuple(d for d in held.get(main + OPERATOR, ()) if d.name in read and d.initial in (Bool(False), Int(0)))


def _terminals(program: Sequence[Block]) -> tuple[Declaration, ...]:
    """What the functions of a mapping program name that no block holds: terminals, without an address."""
    functions = [b for b in program if b.kind == "FUNCTION"]
    names = dict.fromkeys(n.parts[0] for b in functions for s in b.body for n in names_in(s) if len(n.parts) == 1)
    return tuple(Declaration(n, "BOOL") for n in names)


def _parted(blocks: Sequence[Block]) -> tuple[str, Sequence[Block], Sequence[Block]]:
    """The name of the layout, the blocks of the interlocking, its main block last, and all others."""
    main = blocks[0].name.removesuffix(INPUTS)
    at = next((k for k, b in enumerate(blocks, 1) if b.name == main), 0)
    if not at or main == blocks[0].name:
        raise NotInSubset("no interlocking that begins with its data blocks and ends with its main block")
    return main.removeprefix("IL_"), blocks[:at], blocks[at:]


def _no_addresses(blocks: Sequence[Block]) -> None:
    """Raise `NotInSubset` at a name that STEP 7 would take for an address."""
    for b in blocks:
        for d in (*b.inputs, *b.outputs, *b.locals):
            if _ABSOLUTE.fullmatch(d.name.upper()):
                raise NotInSubset(f"{b.name}: {d.name} is an address in STEP 7")
