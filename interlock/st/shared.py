"""The same text with its variables in data blocks: no block hands a value to another, it lies where all can see it.

A controller whose blocks hand each wire on as a parameter needs one calling block that is larger than a small
controller allows.  Here three data blocks hold inputs (`_I`), outputs and words (`_Q`), and all that is computed or
kept (`_D`); blocks without parameters are called, in the same order, by a few group blocks (`_G..`), and these by one
block.  Timers keep something of their own: their blocks are function blocks with an instance data block each.

A unit in this form has blocks of these kinds, callees first: DATA_BLOCK (its locals are its members), INSTANCE (its
one local is of the type of which it is an instance), FUNCTION (its locals are temporary), FUNCTION_BLOCK, and last
WIRES, the terminals with their addresses.  A name of two parts is a member of a data block; one of one part is a
block's own variable, or in the mapping program a terminal.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import TypeVar

from interlock.dataclass import dataclass
from interlock.st.ast import (
    HEADLINE,
    Assign,
    Block,
    Call,
    Compare,
    Declaration,
    Expression,
    If,
    Name,
    Nary,
    Not,
    Statement,
    Unit,
)
from interlock.st.parser import NotInSubset
from interlock.st.program import INSTANCE

INPUTS, OUTPUTS, INNER, OPERATOR = "_I", "_Q", "_D", "_HMI"
"""What a data block is called after the main block: inputs, outputs and words, all else, the operator's variables."""
GROUP = 24
"""Blocks that one group block calls, at most."""
MOST = 150
"""Wires that one block of the mapping program carries, and outputs that one block sets, at most."""
PLAIN = ("BOOL", "INT", "TON")


@dataclass(frozen=True)
class Frame:
    """By name what is data block, number in one, instance (with its block) and function in a unit of this form."""

    data: frozenset[str]
    numbers: frozenset[tuple[str, str]]
    instances: Mapping[str, str]
    functions: frozenset[str]


def frame(blocks: Sequence[Block]) -> Frame:
    """What the blocks are."""
    return Frame(
        frozenset(b.name for b in blocks if b.kind == "DATA_BLOCK"),
        frozenset((b.name, d.name) for b in blocks if b.kind == "DATA_BLOCK" for d in b.locals if d.type == "INT"),
        {b.name: b.locals[0].type for b in blocks if b.kind == "INSTANCE"},
        frozenset(b.name for b in blocks if b.kind == "FUNCTION"),
    )


def pair(*parts: str) -> tuple[Name, Not]:
    """A name as it is, and negated."""
    name = Name(parts)
    return name, Not(name)


class Renaming(dict[tuple[str, ...], tuple[Name, Not]]):
    """Statements with other names.  Each name is asked for once: most of a text are names that it has had."""

    def __init__(self, name: Callable[[tuple[str, ...]], tuple[Name, Not]]) -> None:
        """`name`: what stands for a name of such parts, and negated; it may raise `NotInSubset`."""
        super().__init__()
        self._name = name

    def __missing__(self, parts: tuple[str, ...]) -> tuple[Name, Not]:
        found = self[parts] = self._name(parts)
        return found

    def expression(self, x: Expression) -> Expression:
        """An expression with other names."""
        if isinstance(x, Name):
            return self[x.parts][0]
        if isinstance(x, Nary):
            args: list[Expression] = []
            for a in x.args:
                if isinstance(a, Name):
                    args.append(self[a.parts][0])
                elif isinstance(a, Not) and isinstance(a.arg, Name):
                    args.append(self[a.arg.parts][1])
                else:
                    args.append(self.expression(a))
            return Nary(x.op, tuple(args), x.notes)
        if isinstance(x, Not):
            return Not(self.expression(x.arg))
        return Compare(x.op, self.expression(x.left), self.expression(x.right)) if isinstance(x, Compare) else x

    def __call__(self, s: Statement) -> Statement:
        """A statement with other names."""
        if isinstance(s, Assign):
            return Assign(self[s.target.parts][0], self.expression(s.value), s.note)
        if isinstance(s, Call):
            return Call(s.instance, tuple([(n, self.expression(x)) for n, x in s.params]), s.note)
        arms = [(self.expression(c), tuple(map(self, then))) for c, then in s.arms]
        return If(*arms[0], tuple(map(self, s.otherwise)), tuple(arms[1:]))


def instance(block: str) -> str:
    """The data block of a block that keeps something."""
    return f"DB_{block}"


# --- from parameters to data blocks --------------------------------------------------------------


def label(main: str) -> str:
    """What stands before the name of a terminal, where a controller holds several interlockings."""
    return f"{main.removeprefix('IL_')}_"


def shared(unit: Unit, several: bool = False) -> Unit:
    """An interlocking, which may end with its mapping program, in this form.

    several: a controller may hold several, so that instances and terminals bear its name, too.
    """
    if unit.blocks[-1].kind != "PROGRAM":
        return replace(unit, blocks=tuple(in_data_blocks(unit.blocks)))
    *blocks, program = unit.blocks
    types = {d.name: d.type for d in program.locals}
    main = types[INSTANCE]
    helpers = [b for b in blocks if b.name in types.values() and b.name != main]
    core = in_data_blocks([b for b in blocks if b not in helpers])
    return replace(unit, blocks=(*core, *helpers, *_mapping(program, main, several)))


NOTES = {INPUTS: "inputs", OUTPUTS: "outputs, and what is said of routes", INNER: "what is computed and kept"}
"""What is told of each part of an interlocking's data."""


def members(callees: Sequence[Block], main: Block) -> dict[str, list[Declaration]]:
    """The variables of an interlocking by the part of its data to which they belong."""
    shown = main.input_names | main.output_names
    inner = [d for b in callees for d in b.outputs if d.name not in shown]
    return {INPUTS: [*main.inputs], OUTPUTS: [*main.outputs], INNER: inner}


def in_data_blocks(blocks: Sequence[Block]) -> Iterator[Block]:
    """Data blocks, and the blocks that read and write them.  What a variable means stands at its place in a data block,
    too, not only where it is computed."""
    *callees, main = blocks
    data = members(callees, main)
    lies = {d.name: main.name + ending for ending, part in data.items() for d in part}
    notes = {s.target.parts[-1]: s.note for b in callees for s in b.body if isinstance(s, Assign)}
    data[INNER] = [replace(d, note=d.note or notes.get(d.name, "")) for d in data[INNER]]
    for ending, part in data.items():
        yield Block(main.name + ending, (), (), tuple(part), (), NOTES[ending], "DATA_BLOCK")
    yield from placed(callees, main, lies)


def settings(main: Block) -> list[Sequence[Assign]]:
    """What sets the outputs that no block computes under their own names, in parts of one block each."""
    found = [s for s in main.body if isinstance(s, Assign)]
    found = [s for s in found if not isinstance(s.value, Name) or s.value.parts[-1] != s.target.parts[-1]]
    return _parts(found, MOST)


def placed(callees: Sequence[Block], main: Block, lies: Mapping[str, str]) -> Iterator[Block]:
    """The blocks in the order in which they are called, those that set outputs, group blocks, and the one that calls
    these; one with timers has an instance.  Each reads and writes variables where they lie: `lies`, by their names."""
    assert not any(d.name in lies for b in callees for d in b.locals), "a block's own has the name of a variable"
    kinds = {b.name: b for b in callees}
    types = {d.name: d.type for d in main.locals}
    put = Renaming(lambda parts: pair(lies[parts[0]], parts[0]) if parts[0] in lies else pair(*parts))
    calls: list[Call] = []
    for s in main.body:
        if isinstance(s, Call):
            b = kinds[types[s.instance]]
            timed = any(d.type == "TON" for d in b.locals)
            body = tuple(map(put, b.body))
            yield Block(b.name, (), (), b.locals, body, b.note, "FUNCTION_BLOCK" if timed else "FUNCTION")
            if timed:
                yield Block(instance(b.name), (), (), (Declaration("OF", b.name),), (), "", "INSTANCE")
            calls.append(Call(instance(b.name) if timed else b.name, (), b.note[:HEADLINE]))
    outer = Renaming(lambda parts: pair(lies[parts[-1]], parts[-1]))  # the names of the main block: outputs of others
    for k, part in enumerate(settings(main), 1):
        yield Block(f"{main.name}_Y{k:02d}", (), (), (), tuple(map(outer, part)), "outputs", "FUNCTION")
        calls.append(Call(f"{main.name}_Y{k:02d}", (), "outputs"))
    groups = _parts(calls, GROUP)
    for k, called in enumerate(groups, 1):
        yield Block(f"{main.name}_G{k:02d}", (), (), (), tuple(called), "calls in the order of the proof", "FUNCTION")
    whole = tuple(Call(f"{main.name}_G{k:02d}", ()) for k in range(1, len(groups) + 1))
    yield Block(main.name, (), (), (), whole, main.note, "FUNCTION")


_S = TypeVar("_S", bound=Statement)


def _parts(xs: Sequence[_S], most: int) -> list[Sequence[_S]]:
    return [xs[i : i + most] for i in range(0, len(xs), most)]


def _mapping(program: Block, main: str, several: bool) -> Iterator[Block]:
    """Instances, the operator's variables, the blocks that carry wires in and out, the program, and the terminals."""
    instances = {d.name: d.type for d in program.locals if d.type not in PLAIN and d.name != INSTANCE}
    operators = tuple(d for d in program.locals if d.type in PLAIN and not d.address)
    own, before = (f"{main}_", label(main)) if several else ("", "")
    wires = tuple(replace(d, name=before + d.name) for d in program.locals if d.address)
    for n, kind in instances.items():
        yield Block(instance(own + n), (), (), (Declaration("OF", kind),), (), "", "INSTANCE")
    yield Block(main + OPERATOR, (), (), operators, (), "the operator's place", "DATA_BLOCK")
    data = {d.name: main + OPERATOR for d in operators}

    def place(parts: tuple[str, ...]) -> tuple[Name, Not]:
        first = parts[0]
        if first == INSTANCE:
            return pair(main + OUTPUTS, parts[1])
        if first in instances:
            return pair(instance(own + first), *parts[1:])
        return pair(data[first], first) if first in data else pair(before + first)

    body: list[Statement] = []
    out: list[Statement] = []
    put = Renaming(place)
    for s in program.body:
        made = put(s)
        if isinstance(s, Call) and s.instance == INSTANCE:
            assert isinstance(made, Call)
            carried: list[Statement] = [Assign(Name((main + INPUTS, n)), x) for n, x in made.params]
            for k, part in enumerate(_parts(carried, MOST), 1):
                yield Block(f"{main}_IN{k:02d}", (), (), (), tuple(part), "wires to inputs", "FUNCTION")
                body.append(Call(f"{main}_IN{k:02d}", ()))
            body.append(Call(main, ()))
        elif isinstance(s, Call):
            assert isinstance(made, Call)
            body.append(replace(made, instance=instance(own + s.instance)))
        elif isinstance(s, Assign) and isinstance(s.value, Name) and s.value.parts[0] == INSTANCE:
            out.append(made)
        else:
            if out:
                for k, part in enumerate(_parts(out, MOST), 1):
                    yield Block(f"{main}_OUT{k:02d}", (), (), (), tuple(part), "outputs to wires", "FUNCTION")
                    body.append(Call(f"{main}_OUT{k:02d}", ()))
                out = []
            body.append(made)
    assert not out
    yield Block(program.name, (), (), (), tuple(body), program.note, "FUNCTION")
    yield Block("", (), (), wires, (), "", "WIRES")


# --- and back ------------------------------------------------------------------------------------


def flat(unit: Unit, several: bool = False) -> Unit:
    """What a unit of this form does, as one function block, and its mapping program if there is one; raises
    `NotInSubset`.  several: as in `shared`.

    The blocks' statements stand in the order in which they are carried out; what is temporary in a block has a name
    that no text can have, so that nobody else reads it.
    """
    by_name: dict[str, Block] = {}
    for b in unit.blocks:
        if by_name.setdefault(b.name.upper(), b) is not b:
            raise NotInSubset(f"{b.name} is there twice")
    main = unit.blocks[0].name.removesuffix(INPUTS)
    called: set[str] = set()
    core = _Core(unit, main, called)
    block = core.block()
    programs = [b for b in unit.blocks if b.name == f"{main}_IO"]
    rest = [b for b in unit.blocks if b.kind == "WIRES"]
    known = {main + x for x in (INPUTS, OUTPUTS, INNER, *((OPERATOR,) if programs else ()))}
    if {b.name for b in unit.blocks if b.kind == "DATA_BLOCK"} != known:
        raise NotInSubset(f"data blocks are not {', '.join(sorted(known))}")
    if not programs and not rest:
        _all_called(unit, called)
        return Unit((block,), task=unit.task)
    if len(programs) != 1 or len(rest) != 1:
        raise NotInSubset("not one mapping program with its terminals")
    program = _Program(unit, main, called, rest[0].locals, several).block(programs[0])
    _all_called(unit, called | {programs[0].name})
    helpers = [b for b in unit.blocks if b.kind == "FUNCTION_BLOCK" and b.name not in core.timing]
    return Unit((*helpers, block, program), task=unit.task)


def _all_called(unit: Unit, called: set[str]) -> None:
    left = [b.name for b in unit.blocks if b.kind in ("FUNCTION", "INSTANCE") and b.name not in called]
    if left:
        raise NotInSubset(f"{left[0]} is never called")


def names_in(s: Statement) -> list[Name]:
    """Every name that a statement reads or writes."""
    found: list[Name] = []
    todo = [s]
    while todo:
        s = todo.pop()
        if isinstance(s, Assign):
            found.append(s.target)
            found += _names(s.value)
        elif isinstance(s, Call):
            for _, x in s.params:
                found += _names(x)
        else:
            for c, then in s.arms:
                found += _names(c)
                todo += then
            todo += s.otherwise
    return found


def _names(x: Expression) -> list[Name]:
    found: list[Name] = []
    todo = [x]
    while todo:
        x = todo.pop()
        if isinstance(x, Name):
            found.append(x)
        elif isinstance(x, Not):
            todo.append(x.arg)
        elif isinstance(x, Nary):
            todo += x.args
        elif isinstance(x, Compare):
            todo += (x.left, x.right)
    return found


def writes(s: Statement) -> Iterator[Name]:
    """Every name that a statement writes."""
    if isinstance(s, Assign):
        yield s.target
    elif isinstance(s, If):
        for t in (*(t for _, then in s.arms for t in then), *s.otherwise):
            yield from writes(t)


def reads(s: Statement) -> Iterator[Name]:
    """Every name that a statement reads; what a call only hands on, as a parameter of the same name, is not read."""
    if isinstance(s, Assign):
        yield from _names(s.value)
    elif isinstance(s, Call):
        for n, x in s.params:
            yield from (y for y in _names(x) if y.parts[-1] != n)
    else:
        for c, then in s.arms:
            yield from _names(c)
            for t in then:
                yield from reads(t)
        for t in s.otherwise:
            yield from reads(t)


class _Walk:
    """The calls of a unit, each carried out once."""

    def __init__(self, unit: Unit, main: str, called: set[str]) -> None:
        self.main, self.called = main, called
        self.functions = {b.name: b for b in unit.blocks if b.kind == "FUNCTION"}
        self.blocks = {b.name: b for b in unit.blocks if b.kind == "FUNCTION_BLOCK"}
        self.instances = {b.name: b.locals[0].type for b in unit.blocks if b.kind == "INSTANCE"}
        self.data = {b.name: b.locals for b in unit.blocks if b.kind == "DATA_BLOCK"}

    def once(self, name: str) -> None:
        """Raises `NotInSubset` at a second call."""
        if name in self.called:
            raise NotInSubset(f"{name} is called twice")
        self.called.add(name)


class _Core(_Walk):
    """The interlocking as one function block."""

    def __init__(self, unit: Unit, main: str, called: set[str]) -> None:
        super().__init__(unit, main, called)
        try:
            self.inputs, self.outputs, inner = (self.data[main + x] for x in NOTES)
        except KeyError as missing:
            raise NotInSubset(f"no data block {missing}") from missing
        self.members = {d.name: (main + x, pair(d.name)) for x in NOTES for d in self.data[main + x]}
        if len(self.members) != len(self.inputs) + len(self.outputs) + len(inner):
            raise NotInSubset("two variables of one name")
        self.given = {d.name for d in self.inputs}
        self.locals = list(inner)
        self.timing: set[str] = set()
        self.body: list[Statement] = []

    def block(self) -> Block:
        """The function block."""
        if self.main not in self.functions:
            raise NotInSubset(f"no block {self.main}")
        self._carry(self.main, self.functions[self.main])
        return Block(self.main, self.inputs, self.outputs, tuple(self.locals), tuple(self.body))

    def _carry(self, name: str, b: Block) -> None:
        """The statements of a block, those of what it calls in their place."""
        self.once(name)
        if b.inputs or b.outputs:
            raise NotInSubset(f"{b.name} has parameters")
        own: dict[str, str] = {}
        for d in b.locals:
            if d.name in own or d.initial is not None or (d.type == "TON") > (b.kind == "FUNCTION_BLOCK"):
                raise NotInSubset(f"{b.name}: {d.name} is declared twice, or otherwise than as its own")
            own[d.name] = d.name if d.type == "TON" else f"{b.name} {d.name}"
            self.locals.append(Declaration(own[d.name], d.type, None, d.note, d.address))
        members = self.members

        def place(parts: tuple[str, ...]) -> tuple[Name, Not]:
            first, last = parts[0], parts[-1]
            if first in own and (len(parts) == 1 or last == "Q"):
                return pair(own[first], *parts[1:])
            if len(parts) == 2 and last in members and members[last][0] == first:
                return members[last][1]
            raise NotInSubset(f"{b.name}: {Name(parts)} is not declared")

        put = Renaming(place)
        for s in b.body:
            if isinstance(s, Call) and s.instance in self.functions and not s.params:
                self._carry(s.instance, self.functions[s.instance])
            elif isinstance(s, Call) and s.instance in self.instances and not s.params:
                kind = self.instances[s.instance]
                if kind not in self.blocks or kind in self.timing:
                    raise NotInSubset(f"{s.instance} is no instance of a block, or a second one")
                self.timing.add(kind)
                self._carry(s.instance, self.blocks[kind])
            elif isinstance(s, Call):
                if s.instance not in own:
                    raise NotInSubset(f"{b.name} calls {s.instance}")
                self.body.append(put(s))
            else:
                made = put(s)
                if wrong := [str(n) for n in writes(made) if str(n) in self.given]:
                    raise NotInSubset(f"{b.name} writes {wrong[0]}, which is an input")
                self.body.append(made)


class _ProgramNames:
    """What variables of the mapping program are called in all forms: terminals, the operator's, those of instances."""

    def __init__(self, main: str, wires: Sequence[Declaration], held: Iterable[str], several: bool) -> None:
        self._main = main
        self._own, self._before = (f"DB_{main}_", label(main)) if several else ("DB_", "")
        self._terminals = {d.name for d in wires}
        self._held = frozenset(held)

    @staticmethod
    def _after(name: str, before: str) -> str:
        """A name without what must stand before it."""
        if not name.startswith(before):
            raise NotInSubset(f"{name} does not begin with {before}")
        return name.removeprefix(before)

    def instance(self, name: str) -> str:
        """An instance, by the name of its data block."""
        return self._after(name, self._own)

    def terminal(self, name: str) -> str:
        """A terminal without the interlocking's label."""
        return self._after(name, self._before)

    def of(self, parts: tuple[str, ...], instances: Mapping[str, str]) -> tuple[Name, Not]:
        """Any of them; raises `NotInSubset` for what is not declared."""
        first, last = parts[0], parts[-1]
        if len(parts) == 1 and first in self._terminals:
            return pair(first.removeprefix(self._before))
        if first == self._main + OPERATOR and last in self._held:
            return pair(last)
        if first == self._main + OUTPUTS:
            return pair(INSTANCE, last)
        if first in instances:
            return pair(self.instance(first), last)
        raise NotInSubset(f"{Name(parts)} is not declared")


class _Program(_Walk):
    """The mapping program as it is in all forms."""

    def __init__(self, unit: Unit, main: str, called: set[str], wires: Sequence[Declaration], several: bool) -> None:
        super().__init__(unit, main, called)
        self.operators = self.data.get(main + OPERATOR, ())
        self.names = _ProgramNames(main, wires, (d.name for d in self.operators), several)
        self.wires = [replace(d, name=self.names.terminal(d.name)) for d in wires]
        self.given: list[tuple[str, Expression]] = []
        self.body: list[Statement] = []

    def block(self, program: Block) -> Block:
        """The program."""
        self._carry(program)
        if self.given:
            raise NotInSubset("an input is written after the interlocking was called")
        names = {d.name for d in (*self.wires, *self.operators)}
        used = {self.names.instance(n): kind for n, kind in self.instances.items() if kind in self._helpers()}
        if len(names) != len(self.wires) + len(self.operators) or names & {*used, INSTANCE}:
            raise NotInSubset("two variables of one name")
        instances = (*(Declaration(n, kind) for n, kind in used.items()), Declaration(INSTANCE, self.main))
        locals_ = (*self.wires, *self.operators, *instances)
        return Block(program.name, (), (), locals_, tuple(self.body), kind="PROGRAM")

    def _helpers(self) -> set[str]:
        return {self.instances[n] for n in self.instances if n.removeprefix("DB_") not in self.blocks}

    def _carry(self, b: Block) -> None:
        if b.locals or b.inputs or b.outputs:
            raise NotInSubset(f"{b.name} has variables of its own")
        put = Renaming(self._name)
        for s in b.body:
            if isinstance(s, Call) and s.instance == self.main and not s.params:
                self.body.append(Call(INSTANCE, tuple(self.given)))
                self.given = []
            elif isinstance(s, Call) and s.instance in self.functions and not s.params:
                self.once(s.instance)
                self._carry(self.functions[s.instance])
            elif isinstance(s, Assign) and s.target.parts[0] == self.main + INPUTS:
                self.given.append((s.target.parts[1], put.expression(s.value)))
            elif self.given:
                raise NotInSubset("something else stands between the inputs and the call of the interlocking")
            elif isinstance(s, Call):
                if s.instance not in self.instances:
                    raise NotInSubset(f"{b.name} calls {s.instance}")
                self.once(s.instance)
                self.body.append(put(replace(s, instance=self.names.instance(s.instance))))
            else:
                if any(len(n.parts) == 2 and n.parts[0] != self.main + OPERATOR for n in writes(s)):
                    raise NotInSubset(f"{b.name} writes what is not the operator's")
                self.body.append(put(s))

    def _name(self, parts: tuple[str, ...]) -> tuple[Name, Not]:
        return self.names.of(parts, self.instances)
