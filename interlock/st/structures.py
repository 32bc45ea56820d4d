"""The same text with its variables in three structures: a block is handed what it reads and writes as a whole.

A main block that hands each value on grows with the station.  Here inputs, outputs and words, and all that is computed
or kept are members of a structure each (`_I`, `_Q`, `_D`); every block gets those that it uses as VAR_IN_OUT, and none
a value.  What belongs where, and which group calls what, is as in the data blocks of `interlock.st.shared`.  The main
block gets inputs and outputs from whoever calls it, and holds the rest.

What is computed or kept lies in several structures (`_D1`, `_D2`, ...) where one would have more than MEMBERS members:
a compiler that carries out VAR_IN_OUT by copying keeps a copy of each structure in each block that gets it.  What the
same blocks use lies together, so that a block gets few of them.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

from interlock.st.ast import HEADLINE, Assign, Block, Call, Declaration, Expression, Name, Not, Statement, Unit
from interlock.st.meaning import STANDARD
from interlock.st.parser import NotInSubset
from interlock.st.program import INSTANCE
from interlock.st.shared import (
    INNER,
    INPUTS,
    NOTES,
    OUTPUTS,
    PLAIN,
    Renaming,
    members,
    names_in,
    pair,
    placed,
    settings,
    writes,
)

GIVEN, SHOWN, HELD = "INP", "OUTP", "D"
"""By which names the blocks know the structures: inputs, outputs and words, all else."""
MEMBERS = 500
"""Members that one structure of all else has, at most."""


def named(count: int) -> dict[str, str]:
    """The names of all structures, in the order in which they are handed on, and what each is called after the main
    block, where all else lies in so many of them."""
    held = {f"{HELD}{k}": f"{INNER}{k}" for k in range(1, count + 1)} if count > 1 else {HELD: INNER}
    return {GIVEN: INPUTS, SHOWN: OUTPUTS, **held}


# --- from parameters to structures ---------------------------------------------------------------


def structured(unit: Unit) -> Unit:
    """An interlocking, its mapping program, or both, in this form."""
    *blocks, last = unit.blocks
    if last.kind != "PROGRAM":
        return replace(unit, blocks=tuple(_interlocking(unit.blocks)))
    types = {d.name: d.type for d in last.locals}
    main = types[INSTANCE]
    watches = [b for b in blocks if b.name in types.values() and b.name != main]
    core = [b for b in blocks if b not in watches]
    made = _interlocking(core) if core else ()
    return replace(unit, blocks=(*made, *watches, _program(last, main)))


def _interlocking(blocks: Sequence[Block]) -> Iterator[Block]:
    """Structures, the blocks in the order in which they are called, groups, and the main block."""
    *callees, main = blocks
    data = members(callees, main)
    lies, names = _parted(callees, main, data)
    yield from _structures(main.name, data, lies, names)
    declared = {b.name: (*b.inputs, *b.outputs) for b in callees}
    handed: dict[str, tuple[str, ...]] = {}
    instances: dict[str, str] = {}
    for b in placed(callees, main, lies):
        if b.kind == "INSTANCE":
            instances[b.name] = b.locals[0].type
            continue
        if b.name in declared:
            used = {lies[d.name] for d in declared[b.name]}
        else:
            called = [instances.get(s.instance, s.instance) for s in b.body if isinstance(s, Call)]
            used = {n.parts[0] for s in b.body for n in names_in(s)}.union(*map(handed.__getitem__, called))
        handed[b.name] = (GIVEN, SHOWN) if b.name == main.name else tuple(n for n in names if n in used)
        made = b if b.name in declared else _calling(b, main.name, handed, instances)
        yield _handing(made, main.name, names, handed[b.name])


def _parted(
    callees: Sequence[Block], main: Block, data: Mapping[str, Sequence[Declaration]]
) -> tuple[dict[str, str], dict[str, str]]:
    """In which structure each variable lies, and the names of all structures as `named` has them.

    All else is sorted by the blocks that use it, in the order of calls, and cut into parts of one size.
    """
    users: dict[str, list[int]] = {}
    for k, b in enumerate(callees):
        for d in (*b.inputs, *b.outputs):
            users.setdefault(d.name, []).append(k)
    for k, part in enumerate(settings(main), len(callees)):
        for name in dict.fromkeys(n.parts[-1] for s in part for n in names_in(s)):
            users.setdefault(name, []).append(k)
    inner = sorted((d.name for d in data[INNER]), key=lambda n: users.get(n, []))
    names = named(-(-len(inner) // MEMBERS))
    given, shown, *held = names
    lies = {d.name: n for n, ending in ((given, INPUTS), (shown, OUTPUTS)) for d in data[ending]}
    return lies | {n: held[i * len(held) // len(inner)] for i, n in enumerate(inner)}, names


def _structures(
    main: str, data: Mapping[str, Sequence[Declaration]], lies: Mapping[str, str], names: Mapping[str, str]
) -> Iterator[Block]:
    """What the structures hold, in the order in which it is declared."""
    parts: dict[str, list[Declaration]] = {n: [] for n in names}
    for d in (d for part in data.values() for d in part):
        parts[lies[d.name]].append(d)
    told = {GIVEN: NOTES[INPUTS], SHOWN: NOTES[OUTPUTS]}
    for n, part in parts.items():
        note = f"{NOTES[INNER]}, part {n.removeprefix(HELD)} of {len(names) - 2}" if len(names) > 3 else NOTES[INNER]
        yield Block(main + names[n], (), (), tuple(part), (), told.get(n, note), "STRUCT")


def _handing(b: Block, main: str, names: Mapping[str, str], handed: Sequence[str]) -> Block:
    """A block with its structures; the main block holds those that it does not get."""
    inner = [Declaration(n, main + e) for n, e in names.items() if b.name == main and n not in handed]
    declared = tuple(Declaration(n, main + names[n]) for n in handed)
    note = b.note[:HEADLINE] if b.name != main else b.note
    return Block(b.name, (), (), (*inner, *b.locals), b.body, note, handed=declared)


def _calling(b: Block, main: str, handed: Mapping[str, Sequence[str]], instances: Mapping[str, str]) -> Block:
    """A block that calls others, with an instance of each, and what it sets."""
    inner: list[Declaration] = []
    body: list[Statement] = []
    for s in b.body:
        if isinstance(s, Call):
            kind = instances.get(s.instance, s.instance)
            own = kind.removeprefix(f"{main}_")
            inner.append(Declaration(own, kind, None, s.note))
            s = Call(own, tuple((n, Name((n,))) for n in handed[kind]))
        body.append(s)
    return Block(b.name, (), (), tuple(inner), tuple(body), b.note)


def _program(program: Block, main: str) -> Block:
    """The mapping program: it writes the inputs, calls the interlocking, reads the outputs."""
    body: list[Statement] = []
    put = Renaming(lambda parts: pair(SHOWN, *parts[1:]) if parts[0] == INSTANCE else pair(*parts))
    for s in program.body:
        if isinstance(s, Call) and s.instance == INSTANCE:
            body += [Assign(Name((GIVEN, n)), x) for n, x in s.params]
            body.append(Call(INSTANCE, tuple((n, Name((n,))) for n in (GIVEN, SHOWN))))
        else:
            body.append(put(s))
    own = (Declaration(GIVEN, main + INPUTS, None, "inputs"), Declaration(SHOWN, main + OUTPUTS, None, "outputs"))
    return replace(program, locals=(*program.locals, *own), body=tuple(body))


# --- and back ------------------------------------------------------------------------------------


def plain(unit: Unit) -> Unit:
    """What a unit of this form does, its main block with inputs and outputs as parameters, with its mapping program, or
    the mapping program alone; raises `NotInSubset`.

    The blocks that the main block calls stay as they are, and so do the structures: each has one name everywhere, and
    its members are the variables of the main block.
    """
    names = [b.name.upper() for b in unit.blocks]
    if twice := [n for n, times in Counter(names).items() if times > 1 or n in STANDARD]:
        raise NotInSubset(f"{twice[0]} is there twice, or a type that every tool has")
    programs = [b for b in unit.blocks if b.kind == "PROGRAM"]
    structures = {b.name: b for b in unit.blocks if b.kind == "STRUCT"}
    helpers: list[Block] = []
    main = ""
    if programs:
        types = {d.name: d.type for d in programs[0].locals}
        main = types.get(INSTANCE, "")
        watches = {t for n, t in types.items() if n != INSTANCE}
        helpers = [b for b in unit.blocks if b.name in watches and b.kind == "FUNCTION_BLOCK"]
    core = [b for b in unit.blocks if b.kind == "FUNCTION_BLOCK" and b not in helpers]
    if len(programs) > 1 or any(b.handed for b in helpers):
        raise NotInSubset("two programs, or a watch that is handed a structure")
    program = [_mapping(programs[0], main)] if programs else []
    if programs and not core and not structures:
        return replace(unit, blocks=(*helpers, *program))
    main = next((n.removesuffix(INPUTS) for n in structures if n.endswith(INPUTS)), "")
    if set(structures) != {main + x for x in named(len(structures) - 2).values()}:
        raise NotInSubset("structures are not those of inputs, outputs and all else")
    there = {n: structures[main + ending] for n, ending in named(len(structures) - 2).items()}
    known = {n: Declaration(n, s.name) for n, s in there.items()}
    blocks = {b.name: b for b in core}
    _each_once(main, blocks)
    made = {b.name: _Released(b, b.name == main, blocks, known).block() for b in core}
    whole = made.pop(main)
    given, shown, *rest = (s.locals for s in there.values())
    own = (*(d for part in rest for d in part), *whole.locals)
    whole = Block(main, given, shown, own, whole.body, handed=whole.handed)
    return Unit((*helpers, *there.values(), *made.values(), whole, *program), task=unit.task)


def _each_once(main: str, blocks: Mapping[str, Block]) -> None:
    """Each block but the main one has one instance, in one other block; raises `NotInSubset`."""
    if main not in blocks:
        raise NotInSubset(f"no block {main}")
    called = {main}
    todo = [main]
    while todo:
        for d in blocks[todo.pop()].locals:
            if d.type in called:
                raise NotInSubset(f"{d.type} is called twice")
            if d.type in blocks:
                called.add(d.type)
                todo.append(d.type)
    if left := [n for n in blocks if n not in called]:
        raise NotInSubset(f"{left[0]} is never called")


class _Released:
    """A block of this form on its way back; `main`: it is the one that holds the rest.

    known: all structures, in the order in which they are handed on.
    """

    def __init__(self, b: Block, main: bool, blocks: Mapping[str, Block], known: Mapping[str, Declaration]) -> None:
        self.b, self.main, self.blocks = b, main, blocks
        own = [d for n, d in known.items() if main and n not in (GIVEN, SHOWN)]
        self.seen = (*b.handed, *own)
        self.structures = {d.name for d in self.seen}
        self.instances = {d.name: d.type for d in b.locals if d.type in blocks}
        self.own = [d for d in b.locals if d not in own and d.name not in self.instances]
        names = [d.name.upper() for d in (*b.handed, *b.locals)]
        handed = {d.name for d in b.handed}
        if (
            b.inputs
            or b.outputs
            or list(b.handed) != [d for n, d in known.items() if n in handed]
            or len(set(names)) != len(names)
            or {d.name for d in b.locals if known.get(d.name) == d} != {d.name for d in own}
            or any(d.initial is not None or d.address for d in b.locals)
            or any(d.type not in PLAIN for d in self.own)
        ):
            raise NotInSubset(f"{b.name}: declared otherwise than as a block of this form")

    def block(self) -> Block:
        """It, without saying at each call that all structures are handed on."""
        body = tuple([self._called(s) if isinstance(s, Call) else s for s in self.b.body])
        called = [s.instance for s in self.b.body if isinstance(s, Call)]
        if left := [n for n in self.instances if called.count(n) != 1]:
            raise NotInSubset(f"{self.b.name}: {left[0]} is not called once")
        if self.main and len(self.instances) < len(body):  # members would be variables of its own there
            raise NotInSubset(f"{self.b.name} does something else than call blocks")
        own = (*self.own, *(Declaration(n, kind) for n, kind in self.instances.items()))
        return Block(self.b.name, (), (), own, body, handed=self.seen)

    def _called(self, s: Call) -> Call:
        if s.instance not in self.instances:
            return s
        handed = [d.name for d in self.blocks[self.instances[s.instance]].handed]
        if s.params != tuple((n, Name((n,))) for n in handed) or not self.structures.issuperset(handed):
            raise NotInSubset(f"{self.b.name}: {s.instance} is handed something else than its structures")
        return Call(s.instance, ())


def _mapping(program: Block, main: str) -> Block:
    """The mapping program with the inputs as parameters of its one call of the interlocking."""
    held = {GIVEN: main + INPUTS, SHOWN: main + OUTPUTS}
    mine = [d for d in program.locals if d.name in held]
    if sorted((d.name, d.type, d.initial, d.address) for d in mine) != [(n, t, None, "") for n, t in held.items()]:
        raise NotInSubset(f"{program.name}: inputs and outputs are not declared as structures")
    if program.inputs or program.outputs or program.handed:
        raise NotInSubset(f"{program.name} is given something, or gives something")

    def name(parts: tuple[str, ...]) -> tuple[Name, Not]:
        if parts[0] == SHOWN and len(parts) == 2:
            return pair(INSTANCE, parts[1])
        if parts[0] in (GIVEN, SHOWN, INSTANCE):
            raise NotInSubset(f"{program.name}: {Name(parts)} is read or written")
        return pair(*parts)

    body: list[Statement] = []
    put = Renaming(name)
    given: list[tuple[str, Expression]] = []
    for s in program.body:
        if isinstance(s, Assign) and s.target.parts[0] == GIVEN and len(s.target.parts) == 2:
            given.append((s.target.parts[1], put.expression(s.value)))
        elif isinstance(s, Call) and s.instance == INSTANCE:
            if s.params != tuple((n, Name((n,))) for n in (GIVEN, SHOWN)):
                raise NotInSubset(f"{program.name}: the interlocking is handed something else than its structures")
            body.append(Call(INSTANCE, tuple(given)))
            given = []
        elif given:
            raise NotInSubset(f"{program.name}: something stands between the inputs and the call of the interlocking")
        elif any(n.parts[0] == SHOWN for n in writes(s)):
            raise NotInSubset(f"{program.name} writes an output of the interlocking")
        else:
            body.append(put(s))
    if given:
        raise NotInSubset(f"{program.name}: an input is written after the interlocking was called")
    return replace(program, locals=tuple(d for d in program.locals if d.name not in held), body=tuple(body))
