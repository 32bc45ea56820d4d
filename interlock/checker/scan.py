"""What one call of the main function block computes: wires, next values, outputs and timers.

The statements are taken in their order.  A variable that the certificate knows by name stands for itself once it is
written; any other is what was written to it.  What is read before it is written in a scan has the value of the scan
before, so it must be state.
"""

from __future__ import annotations

from collections.abc import Container
from dataclasses import dataclass, field
from typing import Any

from interlock.checker.formula import FALSE, TRUE, Formula, every, leaf, no, some
from interlock.checker.structured_text import Block, Expression, Reader
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
    """What a text says, by names.  `definitions`: wires by their names, next values and outputs with a prime."""

    inputs: dict[str, str] = field(default_factory=dict)
    outputs: dict[str, bool] = field(default_factory=dict)
    initial: dict[str, bool] = field(default_factory=dict)
    definitions: dict[str, Formula] = field(default_factory=dict)
    timers: dict[str, tuple[str, int]] = field(default_factory=dict)
    words: dict[str, Word] = field(default_factory=dict)


Word = tuple[tuple[Formula, int | str], ...]
"""Conditions and codes, or other words, in order; the last condition is TRUE."""


class Execution:
    """The main block and those that it calls, carried out once with formulas for values."""

    def __init__(self, text: str, state: Container[str], defined: Container[str]) -> None:
        """`state`, `defined`: the names of state variables and of definitions in the certificate."""
        blocks = Reader(text).unit()
        self.kinds = {b.name: b for b in blocks}
        self.main = blocks[-1]
        self.state, self.defined = state, defined
        self.found = Scan()
        self.called: dict[str, dict[str, Value]] = {}
        self._main()

    def _main(self) -> None:
        main, found = self.main, self.found
        env: dict[str, Value] = {}
        for name, v in main.inputs.items():
            need(v.type in ("BOOL", "INT"), f"{name} is an input of type {v.type}")
            found.inputs[name] = v.type
            env[name] = leaf(name) if v.type == "BOOL" else ("number", name)
        for name, v in main.outputs.items():
            need(v.type in ("BOOL", "INT"), f"{name} is an output of type {v.type}")
            if v.type == "INT":
                need(v.initial in (None, ("int", 0)), f"{name} does not begin with 0: nothing is known")
                continue
            found.outputs[name] = found.initial[name] = self._start(name, v.initial)
        self.instances = {n: self._kind(n, v.type) for n, v in main.locals.items()}
        used = [b.name for b in self.instances.values()]
        need(len(set(used)) == len(used), "a function block is used twice")
        need(len(used) == len(self.kinds) - 1, "a function block is used by nobody")
        written: set[str] = set()
        for statement in main.body:
            if statement[0] == "call":
                self._call(statement[1], statement[2], env)
                continue
            _, name, x = statement
            need(statement[0] == "assign", "the main block decides something by IF")
            need(name in main.outputs and name not in written, f"{name} is written twice, or is no output")
            written.add(name)
            value = self._value(x, env)
            if main.outputs[name].type == "INT":
                need(value == ("word", name), f"{name} shows what is no word of this name")
            else:
                self._define(name, value)
        need(written == set(main.outputs), f"{min(set(main.outputs) - written, default='')} is never written")
        need(set(self.called) == set(self.instances), "a function block is never called")

    def _kind(self, name: str, type_: str) -> Block:
        need(type_ in self.kinds and type_ != self.main.name, f"{name} is of an unknown type {type_}")
        return self.kinds[type_]

    @staticmethod
    def _start(name: str, x: Expression | None) -> bool:
        need(x is None or x[0] == "bool", f"{name} has an initial value that is not TRUE or FALSE")
        return False if x is None else bool(x[1])

    def _call(self, instance: str, given: dict[str, Expression], outer: dict[str, Value]) -> None:
        """Carry out a function block once; its inputs are all given, so that no old one remains."""
        block = self.instances.get(instance)
        if block is None or instance in self.called:
            raise Rejected(f"{instance} is called twice, or is no function block")
        need(list(given) == list(block.inputs), f"{instance} is called without one of its inputs, or with another")
        env = {name: self._value(x, outer) for name, x in given.items()}
        for name, v in block.inputs.items():
            number = env[name][0] in ("number", "word")
            need(v.type == ("INT" if number else "BOOL"), f"{name} of {instance} has another type")
        timers: dict[str, tuple[Value, int]] = {}
        for statement in block.body:
            if statement[0] == "call":
                self._time(block, statement[1], statement[2], env, timers)
                continue
            if statement[0] == "if":
                self._say(block, statement[1], env)
                continue
            _, name, x = statement
            need(name in block.outputs or name in block.locals, f"{instance} writes {name}, which is not its own")
            need(name not in env, f"{instance} writes {name} twice")
            variable = block.outputs.get(name) or block.locals[name]
            need(variable.type == "BOOL", f"{name} is of type {variable.type}")
            if x[0] == "name" and len(x[1]) == 2 and x[1][0] in timers and x[1][1] == "Q":
                self._timer(block, name, *timers.pop(x[1][0]))
                env[name] = leaf(name)
                continue
            value = self._value(x, env)
            if name in block.outputs:
                if name in self.state:
                    self.found.initial[name] = self._start(name, variable.initial)
                value = self._define(name, value)
            env[name] = value
        need(not timers, f"{instance} has a timer whose output nobody reads")
        left = [n for n in block.outputs if n not in env]
        need(not left, f"{instance} never writes {left[:1]}")
        self.called[instance] = {n: env[n] for n in block.outputs}

    def _say(self, block: Block, arms: list[tuple[Expression, list[tuple[Any, ...]]]], env: dict[str, Value]) -> None:
        """A number gets the code, or the word, of the first condition that holds."""
        said: list[tuple[Formula, int | str]] = []
        targets = set()
        for condition, body in arms:
            need(len(body) == 1 and body[0][0] == "assign", f"{block.name}: more than one thing is said at once")
            targets.add(body[0][1])
            said.append((self._bool(condition, env), self._code(block, body[0][2], env)))
        need(len(targets) == 1, f"{block.name}: an IF writes several variables")
        (name,) = targets
        need(name in block.outputs and block.outputs[name].type == "INT", f"{name} of {block.name} is no word")
        need(name not in env and name not in self.found.words, f"{block.name} writes {name} twice")
        need(name not in self.state and name not in self.defined, f"{name} is a word, and in the written system")
        need(said[-1][0] == TRUE, f"{name} is not written where no condition holds")
        self.found.words[name] = tuple(said)
        env[name] = ("word", name)

    def _code(self, block: Block, x: Expression, env: dict[str, Value]) -> int | str:
        if x[0] == "int":
            need(0 <= x[1] <= LARGEST, f"{block.name}: {x[1]} is no INT")
            return int(x[1])
        value = self._value(x, env)
        need(value[0] == "word", f"{block.name}: a word gets what is neither a code nor a word")
        return str(value[1])

    @staticmethod
    def _time(
        block: Block,
        name: str,
        given: dict[str, Expression],
        env: dict[str, Value],
        timers: dict[str, tuple[Value, int]],
    ) -> None:
        """A call of an on-delay timer, which is read next."""
        known = name in block.locals and block.locals[name].type == "TON" and name not in timers
        need(known and set(given) == {"IN", "PT"}, f"{block.name} calls {name}, which is no timer of its own")
        source, preset = given["IN"], given["PT"]
        need(preset[0] == "time", f"the preset of {name} is no duration")
        need(source[0] == "name" and len(source[1]) == 1 and source[1][0] in env, f"the input of {name} is no name")
        timers[name] = (env[source[1][0]], preset[1])

    def _timer(self, block: Block, name: str, source: Value, preset: int) -> None:
        need(name in block.outputs and name not in self.found.timers, f"{name} is no timer of its own")
        need(source[0] == "v", f"the input of the timer {name} is no wire")
        self.found.timers[name] = (source[1], preset)

    def _define(self, name: str, x: Value) -> Value:
        """A value is written to an output of a block; what stands for it from now on."""
        need(x[0] not in NUMBERS, f"{name} is written with a number")
        own = name + PRIME if name in self.state else name
        if own == name and name not in self.defined:
            return x
        need(own not in self.found.definitions, f"{name} is written by two blocks")
        self.found.definitions[own] = x
        return leaf(own)

    def _value(self, x: Expression, env: dict[str, Value]) -> Value:
        """What an expression is worth at this point of the scan."""
        kind = x[0]
        if kind == "bool":
            return TRUE if x[1] else FALSE
        if kind == "name":
            return self._read(x[1], env)
        if kind == "not":
            return no(self._bool(x[1], env))
        if kind == "and":
            return every([self._bool(y, env) for y in x[1]])
        if kind == "or":
            return some([self._bool(y, env) for y in x[1]])
        if kind == "=" and x[2][0] == "int":
            number = self._value(x[1], env)
            need(number[0] == "number", "a comparison with what is no number")
            return leaf(f"{number[1]}={x[2][1]}")
        raise Rejected(f"an expression that is not known here: {kind}")

    def _bool(self, x: Expression, env: dict[str, Value]) -> Formula:
        found = self._value(x, env)
        need(found[0] not in NUMBERS, "a number where TRUE or FALSE is meant")
        return found

    def _read(self, name: tuple[str, ...], env: dict[str, Value]) -> Value:
        if len(name) == 1:
            need(name[0] in env, f"{name[0]} is read before it is written")
            return env[name[0]]
        instance, member = name[0], name[-1]
        block = self.instances.get(instance)
        if len(name) != 2 or block is None or member not in block.outputs:
            raise Rejected(f"{'.'.join(name)} is not known")
        if instance in self.called:
            return self.called[instance][member]
        need(member in self.state, f"{'.'.join(name)} is read before it is computed, and is no state")
        return leaf(member)


def execute(text: str, state: Container[str], defined: Container[str]) -> Scan:
    """What a text says; raises Rejected where it says what cannot be followed."""
    found = Execution(text, state, defined).found
    for name, (source, _) in found.timers.items():
        known = source in found.definitions or source in found.inputs or source in found.initial
        need(known, f"the timer {name} waits for {source}, which is not known")
    return found


__all__ = ["PRIME", "Scan", "execute"]
