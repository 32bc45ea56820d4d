"""What one call of the main function block computes: wires, next values, outputs and timers.

All values lie in structures: the main block is handed inputs and outputs, and alone holds others; each block is handed
those that it uses, under the same names, and is called once.  The statements are taken in the order of calls.
A variable that the certificate knows by name stands for itself once it is written; any other is what was written to
it.  What is read before it is written in a scan has the value of the scan before, so it must be state.
"""

from __future__ import annotations

from collections.abc import Container
from dataclasses import dataclass, field
from typing import Any

from interlock.checker.formula import FALSE, TRUE, Formula, every, leaf, no, some
from interlock.checker.structured_text import Block, Expression, Reader, Variable
from interlock.verify import Rejected, need

PRIME = "'"
Value = Formula
"""A formula, `("number", name)` for an input with a small range, `("timer", instance)`, or `("word", name)` for a
number that says something of a route: it may be handed on and shown, and nothing else may read it."""
NUMBERS = ("number", "timer", "word")
LARGEST = 32_767
"""The largest number of an INT."""


@dataclass
class Scan:
    """What a text says, by names.  `definitions`: wires by their names, next values and outputs with a prime; `shown`:
    outputs and words of routes, with their types."""

    inputs: dict[str, str] = field(default_factory=dict)
    outputs: dict[str, bool] = field(default_factory=dict)
    shown: dict[str, str] = field(default_factory=dict)
    initial: dict[str, bool] = field(default_factory=dict)
    definitions: dict[str, Formula] = field(default_factory=dict)
    timers: dict[str, tuple[str, int]] = field(default_factory=dict)
    words: dict[str, Word] = field(default_factory=dict)


Word = tuple[tuple[Formula, int | str], ...]
"""Conditions and codes, or other words, in order; the last condition is TRUE."""


@dataclass
class _Own:
    """A block that is carried out: what its own variables hold, its timers that were called, but not read, and all that
    were called."""

    block: Block
    values: dict[str, Value] = field(default_factory=dict)
    timers: dict[str, tuple[Value, int]] = field(default_factory=dict)
    timed: set[str] = field(default_factory=set)


class Execution:
    """The main block and those that it calls, carried out once with formulas for values."""

    def __init__(self, text: str, state: Container[str], defined: Container[str]) -> None:
        """`state`, `defined`: the names of state variables and of definitions in the certificate."""
        unit = Reader(text).unit()
        self.kinds = {b.name: b for b in unit.blocks}
        self.state, self.defined = state, defined
        self.found = Scan()
        self.values: dict[str, Value] = {}
        """What members of structures hold, by their names, once they are written in this scan."""
        self.called: set[str] = set()
        self._main(unit.blocks[-1], unit.structures)

    def _main(self, main: Block, structures: dict[str, dict[str, Variable]]) -> None:
        handed = list(main.handed.items())
        held = [(n, v) for n, v in main.locals.items() if v.type in structures]
        every = [*handed, *held]
        need(len(handed) == 2 and held != [], "the main block is not handed two structures, or holds none")
        need(all(v.initial is None for _, v in every), "a structure begins otherwise than it is declared")
        self.types = {n: v.type for n, v in every}
        once = sorted(self.types.values()) == sorted(structures)
        need(once, "the structures are not those of the main block, each once")
        self.given, self.shown = (structures[v.type] for _, v in handed)
        self.held = {m: x for _, v in held for m, x in structures[v.type].items()}
        self.members = {n: structures[v.type] for n, v in every}
        names = [m.upper() for members in structures.values() for m in members]
        need(len(set(names)) == len(names), "two structures have a member of one name")
        self._begin()
        self._carry(main, {n for n, _ in held})
        need(self.called == set(self.kinds), "a function block is used by nobody")
        left = [n for n in self.shown if n not in self.values]
        need(not left, f"{min(left, default='')} is never written")

    def _begin(self) -> None:
        """Inputs, and what outputs and words are before the first scan."""
        found = self.found
        for name, v in self.given.items():
            need(v.type in ("BOOL", "INT"), f"{name} is an input of type {v.type}")
            found.inputs[name] = v.type
            if v.type == "INT":
                need(v.initial in (None, ("int", 0)), f"{name} does not begin with 0: somebody asks")
            else:
                need(
                    not (self._start(name, v.initial) and name == "VALID"), "inputs count as valid before they are read"
                )
            self.values[name] = leaf(name) if v.type == "BOOL" else ("number", name)
        for name, v in self.shown.items():
            need(v.type in ("BOOL", "INT"), f"{name} is an output of type {v.type}")
            found.shown[name] = v.type
            if v.type == "INT":
                need(v.initial in (None, ("int", 0)), f"{name} does not begin with 0: nothing is known")
            else:
                found.outputs[name] = found.initial[name] = self._start(name, v.initial)
        for name, v in self.held.items():
            need(v.type in ("BOOL", "INT"), f"{name} is of type {v.type}")

    @staticmethod
    def _start(name: str, x: Expression | None) -> bool:
        need(x is None or x[0] == "bool", f"{name} has an initial value that is not TRUE or FALSE")
        return False if x is None else bool(x[1])

    def _carry(self, block: Block, holds: Container[str] = ()) -> None:
        """Carry out a function block once; `holds`: structures of its own, which the main block alone has."""
        need(block.name not in self.called, f"{block.name} is called twice")
        self.called.add(block.name)
        for n, v in block.handed.items():
            known = self.types.get(n) == v.type and v.initial is None
            need(known, f"{block.name} is handed {n}, which is no structure of that name")
        for n, v in block.locals.items():
            own = v.type in self.types.values() and n not in holds
            need(not own, f"{block.name} holds a structure {n}, which nobody else sees")
        b = _Own(block)
        inner = {n: v.type for n, v in block.locals.items() if v.type in self.kinds}
        for statement in block.body:
            if statement[0] == "call" and statement[1] in inner:
                self._call(block, self.kinds[inner.pop(statement[1])], statement[1], statement[2])
            elif statement[0] == "call":
                self._time(b, statement[1], statement[2])
            elif statement[0] == "if":
                self._say(b, statement[1])
            else:
                self._assign(b, statement[1], statement[2])
        need(not inner, f"{min(inner, default='')} of {block.name} is never called")
        need(not b.timers, f"{block.name} has a timer whose output nobody reads")

    def _call(self, outer: Block, block: Block, instance: str, given: dict[str, Expression]) -> None:
        """A block gets the structures that it declares, each under its own name."""
        mine = {*outer.handed, *(n for n, v in outer.locals.items() if self.types.get(n) == v.type)}
        need(list(given) == list(block.handed), f"{instance} is called without one of its structures, or with another")
        need(all(x == ("name", (n,)) and n in mine for n, x in given.items()), f"{instance} is handed something else")
        self._carry(block)

    def _assign(self, b: _Own, target: tuple[str, ...], x: Expression) -> None:
        """A member of a structure, or a variable of the block's own, is written."""
        name = target[-1]
        where = f"{b.block.name} writes {'.'.join(target)}"
        if len(target) == 1:
            need(name in b.block.locals and b.block.locals[name].type == "BOOL", f"{where}, which is not its own")
            need(name not in b.values, f"{where} twice")
            b.values[name] = self._bool(x, b)
            return
        variable = self._written(b, target)
        need(variable.type == "BOOL", f"{name} is of type {variable.type}")
        if x[0] == "name" and len(x[1]) == 2 and x[1][0] in b.timers and x[1][1] == "Q":
            self._timer(name, *b.timers.pop(x[1][0]))
            self.values[name] = leaf(name)
            return
        value = self._value(x, b)
        if name in self.shown:
            self._define(name, value)
            self.values[name] = value
            return
        if name in self.state:
            self.found.initial[name] = self._start(name, variable.initial)
        self.values[name] = self._define(name, value)

    def _written(self, b: _Own, target: tuple[str, ...]) -> Variable:
        """The member that may be written now; an input never, anything else once."""
        structure, name = target[0], target[-1]
        where = f"{b.block.name} writes {'.'.join(target)}"
        need(
            len(target) == 2 and structure in b.block.handed and name in self.members[structure], f"{where}: not known"
        )
        need(name not in self.given, f"{where}, which is an input")
        need(name not in self.values, f"{name} is written twice")
        return self.members[structure][name]

    def _say(self, b: _Own, arms: list[tuple[Expression, list[tuple[Any, ...]]]]) -> None:
        """A number gets the code, or the word, of the first condition that holds."""
        said: list[tuple[Formula, int | str]] = []
        targets = set()
        for condition, body in arms:
            need(len(body) == 1 and body[0][0] == "assign", f"{b.block.name}: more than one thing is said at once")
            targets.add(body[0][1])
            said.append((self._bool(condition, b), self._code(b, body[0][2])))
        need(len(targets) == 1, f"{b.block.name}: an IF writes several variables")
        (target,) = targets
        name = target[-1]
        need(self._written(b, target).type == "INT", f"{name} of {b.block.name} is no word")
        need(name not in self.state and name not in self.defined, f"{name} is a word, and in the written system")
        need(said[-1][0] == TRUE, f"{name} is not written where no condition holds")
        self.found.words[name] = tuple(said)
        self.values[name] = ("word", name)

    def _code(self, b: _Own, x: Expression) -> int | str:
        if x[0] == "int":
            need(0 <= x[1] <= LARGEST, f"{b.block.name}: {x[1]} is no INT")
            return int(x[1])
        value = self._value(x, b)
        need(value[0] == "word", f"{b.block.name}: a word gets what is neither a code nor a word")
        return str(value[1])

    def _time(self, b: _Own, name: str, given: dict[str, Expression]) -> None:
        """The call of an on-delay timer, the only one of this instance: it counts for one input alone."""
        known = name in b.block.locals and b.block.locals[name].type == "TON"
        need(name not in b.timed, f"{name} is called twice")
        b.timed.add(name)
        need(known and set(given) == {"IN", "PT"}, f"{b.block.name} calls {name}, which is no timer of its own")
        source, preset = given["IN"], given["PT"]
        need(preset[0] == "time", f"the preset of {name} is no duration")
        need(source[0] == "name", f"the input of {name} is no name")
        b.timers[name] = (self._read(source[1], b), preset[1])

    def _timer(self, name: str, source: Value, preset: int) -> None:
        need(name in self.held and name not in self.found.timers, f"{name} is no timer of its own")
        need(source[0] == "v", f"the input of the timer {name} is no wire")
        self.found.timers[name] = (source[1], preset)

    def _define(self, name: str, x: Value) -> Value:
        """A value is written to a member; what stands for it from now on."""
        need(x[0] not in NUMBERS, f"{name} is written with a number")
        own = name + PRIME if name in self.state else name
        if own == name and name not in self.defined:
            return x
        need(own not in self.found.definitions, f"{name} is written by two blocks")
        self.found.definitions[own] = x
        return leaf(own)

    def _value(self, x: Expression, b: _Own) -> Value:
        """What an expression is worth at this point of the scan."""
        kind = x[0]
        if kind == "bool":
            return TRUE if x[1] else FALSE
        if kind == "name":
            return self._read(x[1], b)
        if kind == "not":
            return no(self._bool(x[1], b))
        if kind == "and":
            return every([self._bool(y, b) for y in x[1]])
        if kind == "or":
            return some([self._bool(y, b) for y in x[1]])
        if kind == "=" and x[2][0] == "int":
            number = self._value(x[1], b)
            need(number[0] == "number", "a comparison with what is no number")
            return leaf(f"{number[1]}={x[2][1]}")
        raise Rejected(f"an expression that is not known here: {kind}")

    def _bool(self, x: Expression, b: _Own) -> Formula:
        found = self._value(x, b)
        need(found[0] not in NUMBERS, "a number where TRUE or FALSE is meant")
        return found

    def _read(self, name: tuple[str, ...], b: _Own) -> Value:
        if len(name) == 1:
            need(name[0] in b.values, f"{name[0]} is read before it is written")
            return b.values[name[0]]
        structure, member = name[0], name[-1]
        if len(name) != 2 or structure not in b.block.handed or member not in self.members[structure]:
            raise Rejected(f"{'.'.join(name)} is not known")
        if member in self.values:
            return self.values[member]
        known = member in self.held and member in self.state
        need(known, f"{'.'.join(name)} is read before it is computed, and is no state")
        return leaf(member)


def execute(text: str, state: Container[str], defined: Container[str]) -> Scan:
    """What a text says; raises Rejected where it says what cannot be followed."""
    found = Execution(text, state, defined).found
    for name, (source, _) in found.timers.items():
        known = source in found.definitions or source in found.inputs or source in found.initial
        need(known, f"the timer {name} waits for {source}, which is not known")
    return found


__all__ = ["PRIME", "Scan", "execute"]
