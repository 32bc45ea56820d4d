"""What the generated Python runtime computes, read from its text: nothing is executed.

The parts that all runtimes share must be word for word what the emitter calls fixed, and its tables are read by
Python's own grammar.  The rest is a list of assignments of a few shapes, one a line: a large layout has a hundred
thousand, and to read them by their syntax tree took twice as long.  A line of any other shape is refused.

**Theorem.**  Each line that is read assigns one formula over names that lines before it, inputs or the state define,
so that the formulas, put one into the other in the order of the lines, are what the runtime computes in every call.
(Symbolic execution of straight-line code: King, 1976; the fixed parts are compared word for word.)
"""

from __future__ import annotations

import ast
import re
from collections.abc import Iterable, Mapping
from functools import cache
from keyword import iskeyword
from typing import Any

from interlock.emit.python.runtime import (
    FIXED,
    cancelled_after,
    held_until,
    left,
    occupied,
    route_numbers,
    said,
    stopped,
)
from interlock.logic.controller import Controller
from interlock.logic.expr import FALSE, TRUE, Expr, conj, disj, eq, neg, var
from interlock.logic.names import spelled
from interlock.proof.equivalence.structured_text import Difference, Scan, Translation, compare_scan, wires, words
from interlock.st.meaning import Cases, Constant, Symbol, Symbols, Term


class BadRuntime(Exception):
    """The text is not a runtime as it is emitted."""


def compare_runtime(controller: Controller, text: str) -> Translation:
    """Compare a Python runtime with its controller."""
    try:
        return compare_scan(controller, _Reader(controller, text).scan())
    except (BadRuntime, SyntaxError, ValueError) as error:
        return Translation(0, (Difference("runtime", f"cannot be read: {error}"),))


def _names(fixed: str) -> frozenset[str]:
    """Every name that the fixed part relies on: assigned once more, the scan would no longer do what it says."""
    nodes = list(ast.walk(ast.parse(fixed)))
    return frozenset(
        {x.id for x in nodes if isinstance(x, ast.Name)} | {x.arg for x in nodes if isinstance(x, ast.arg)}
    )


@cache
def _fixed_tree() -> str:
    return ast.dump(ast.parse(FIXED).body[0])


TABLES = (
    *("INPUTS", "STATE", "TIMERS", "OUTPUTS", "ROUTES", "CANCELLED_AFTER", "HELD_UNTIL", "LEFT"),
    *("OCCUPIED", "CAUSES", "AT_STOP", "SAID"),
)
RESERVED = _names(FIXED) | {"bool", "dict", "map", "zip", "OUTPUTS", "Controller", "__debug__"}


_ASSIGNED = re.compile(r"^ {8}([A-Za-z_][A-Za-z0-9_]*) = ([^#\n]*)(?:  #.*)?$")
_ENTRY = re.compile(r"^ {12}'([A-Za-z_][A-Za-z0-9_]*)': bool\((.*)\),$")
_NAMES = re.compile(r"^ {12}[A-Za-z_][A-Za-z0-9_]*(?:, [A-Za-z_][A-Za-z0-9_]*)*,$")
_READ = "        ) = map(read.__getitem__, INPUTS)"
_OLD = "        ) = map(self.state.__getitem__, STATE)"
_KEPT = "        self.state = dict(zip(STATE, map(bool, ("
_WORD = re.compile(r"^ {12}([A-Za-z_][A-Za-z0-9_]*) = self\._first\(([^#\n]*)\)(?:  #.*)?$")
_TOLD = re.compile(r"^ {16}(0|[1-9][0-9]*): ([A-Za-z_][A-Za-z0-9_]*),$")
_TIMED = re.compile(r"^self\._timer\('([A-Za-z_][A-Za-z0-9_]*)', ([A-Za-z_][A-Za-z0-9_]*), dt_ms\)$")
_NUMBER = re.compile(r"0|[1-9][0-9]{0,8}")
DEEP = 190  # brackets in brackets; Python itself reads 200
_CODING = re.compile(r"[ \t\f]*#.*?coding[:=]")  # in the first two lines (PEP 263), whatever encoding it names


class _Reader:
    def __init__(self, controller: Controller, text: str) -> None:
        self.values: dict[str, Term] = {}
        self.after: dict[str, Term] = {}
        self.timers: dict[str, tuple[Expr, int]] = {}
        self.algebra = Symbols(known=wires(controller), words=words(controller))
        self.words: dict[str, Term] = {}
        self.routes = controller.words.routes
        self.sizes: dict[str, int] = {i.name: i.size for i in controller.inputs}
        head, fixed, own = text.partition(FIXED)
        if any(_CODING.match(line) for line in head.split("\n")[:2]):
            raise BadRuntime("a comment that Python takes for the encoding of the file: it would read other characters")
        self.lines = own.split("\n")  # and nowhere else: what Python takes for the end of a line is not printable
        self.at = 0
        self.before = head.count("\n") + FIXED.count("\n")
        doc, *rest = ast.parse(head + fixed).body
        if not _is_docstring(doc) or len(rest) != len(TABLES) + 1:
            raise BadRuntime("the parts of the module")
        tables = [_table(x, n) for x, n in zip(rest, TABLES, strict=False)]
        inputs, self.state, self.presets, self.restrictive, routes, timers, held, gone, *told, codes = tables
        self.inputs = [*inputs]
        if not _same(inputs, {i.name: (i.restrictive, i.size or 2) for i in controller.inputs}):
            raise BadRuntime("INPUTS are not those of the controller")
        if set(self.state) != {s.name for s in controller.state}:
            raise BadRuntime("STATE has not the names of the controller")
        if not _same(self.restrictive, {o.name: o.restrictive for o in controller.outputs}):
            raise BadRuntime("OUTPUTS are not those of the controller")
        if not _same(routes, route_numbers(controller)):
            raise BadRuntime("ROUTES are not those of the controller")
        if not (_same(timers, cancelled_after(controller)) and _same(held, held_until(controller))):
            raise BadRuntime("CANCELLED_AFTER or HELD_UNTIL are not those of the controller")
        if not _same(gone, left(controller)):
            raise BadRuntime("LEFT is not that of the controller")
        causes, stops = stopped(controller)
        if not (_same(told[0], occupied(controller)) and _same(told[1], causes) and _same(told[2], stops)):
            raise BadRuntime("OCCUPIED, CAUSES or AT_STOP are not those of the controller")
        if not _same(codes, said(controller)):
            raise BadRuntime("SAID is not that of the controller")
        if ast.dump(rest[-1]) != _fixed_tree():
            raise BadRuntime("the fixed part of the class is changed")

    def scan(self) -> Scan:
        """Initial and next state, outputs and timers.

        Line by line: what the scan does after the fixed part is one statement a line, of a few shapes, and two
        dictionaries of one entry a line.  No line that is taken leaves a bracket or a string open, or has a character
        at which Python would begin another.
        """
        base: dict[str, Term] = {n: TRUE if v is True else FALSE for n, v in self.state.items() if type(v) is bool}
        outputs: dict[str, Term] | None = None
        lines = self.lines
        for self.at, line in enumerate(lines if not "".join(lines).isprintable() else ()):
            if not line.isprintable():
                raise self._bad("a character that is not printable")
        self.at = 0
        while self.at < len(lines) - 1:
            line = lines[self.at]
            if outputs is not None:
                raise self._bad("something follows the outputs")
            if line == "        return {":
                outputs = self._dictionary()
            elif line == "        if say:" and not self.words and not self.after:
                self.words = self._told_routes()
            elif line == "        (":
                self._unpacked()
            elif line == _KEPT and not self.after:
                self.after = dict(zip(self.state, self._kept(), strict=True))
            else:
                self._assign(line)
                self.at += 1
        if lines[-1] or outputs is None:
            raise self._bad("the outputs are not returned at the end")
        if set(self.timers) != set(self.presets):
            raise BadRuntime("TIMERS are not those that run")
        return Scan(base, self.after, outputs, self.timers, self.words)

    def _bad(self, what: str) -> BadRuntime:
        return BadRuntime(f"line {self.before + self.at + 1}: {what}")

    def _assign(self, line: str) -> None:
        found = _ASSIGNED.match(line)
        if found is None:
            raise self._bad(f"{line.strip()[:60]!r} is no assignment as it is emitted")
        name, text = found.groups()
        if name in RESERVED or iskeyword(name):
            raise self._bad(f"{name} is a name of the fixed part")
        self.values[name] = self.algebra.assigned(name, self._read(name, text))

    def _read(self, name: str, text: str) -> Term:
        if text.startswith("self.") and (timed := _TIMED.match(text)):
            own, on = timed.groups()
            preset = self.presets.get(name)
            if own == name and type(preset) is int and name not in self.timers:
                self.timers[name] = (self._value(on), preset)
                return var(spelled(name))
        return self._value(text)

    def _listed(self) -> tuple[list[str], str]:
        """The names from the next line on, and the line after them."""
        names: list[str] = []
        for line in self.lines[self.at + 1 :]:
            self.at += 1
            if _NAMES.match(line) is None:
                self.at += 1
                return names, line
            names += line.strip()[:-1].split(", ")
        raise self._bad("a list of names does not end")

    def _unpacked(self) -> None:
        """All inputs, or all of what is remembered, under their names and in the order of their table in the text."""
        names, end = self._listed()
        if self.after:
            raise self._bad("what is remembered is taken again when it has changed")
        if end == _READ and names == self.inputs:
            taken: Iterable[Term] = [Symbol(n) if self.sizes[n] else var(spelled(n)) for n in names]
        elif end == _OLD and names == [*self.state]:
            taken = [var(spelled(n)) for n in names]
        else:
            raise self._bad("names that are not those of INPUTS or STATE, in their order")
        for name, value in zip(names, taken, strict=True):
            if name in RESERVED or iskeyword(name):
                raise self._bad(f"{name} is a name of the fixed part")
            self.values[name] = self.algebra.assigned(name, value)

    def _kept(self) -> list[Term]:
        """What is remembered of a scan, in the order of STATE."""
        names, end = self._listed()
        if end != "        ))))" or len(names) != len(self.state) or any(n not in self.values for n in names):
            raise self._bad("what is remembered is not what is computed, name by name as in STATE")
        return [self.values[n] for n in names]

    def _told_routes(self) -> dict[str, Term]:
        """The words from the next line on, and what is returned of them: each route's own by its number."""
        told: dict[str, Term] = {}
        numbers: dict[int, str] = {}
        lines = iter(self.lines[self.at + 1 :])
        for line in lines:
            self.at += 1
            if line == "            return {":
                break
            found = _WORD.match(line)
            if found is None or found[1] in told or found[1] in self.values or found[1] in RESERVED:
                raise self._bad(f"{line.strip()[:60]!r} is no word as it is emitted")
            told[found[1]] = self.algebra.assigned(found[1], self._cases(found[2], told))
        for line in lines:
            self.at += 1
            if line == "            }":
                break
            entry = _TOLD.match(line)
            if entry is None or int(entry[1]) in numbers or entry[2] not in told:
                raise self._bad("an entry that is no word, or comes twice")
            numbers[int(entry[1])] = entry[2]
        if numbers != self.routes:
            raise self._bad("the words are not those of the routes")
        self.at += 1
        return {name: told[name] for name in numbers.values()}

    def _cases(self, text: str, told: Mapping[str, Term]) -> Term:
        """Conditions and values in turn, and the last value."""
        parts = text.split(", ")
        if len(parts) % 2 == 0:
            raise self._bad("a condition without a value")

        def value(part: str) -> Term:
            if part in told:
                return told[part]
            if not part.isdigit() or str(int(part)) != part:
                raise self._bad(f"{part[:60]!r} is no word and no number")
            return Constant(int(part))

        cases = tuple((self._value(c), value(v)) for c, v in zip(parts[:-1:2], parts[1::2], strict=True))
        return Cases(cases, value(parts[-1]))

    def _dictionary(self) -> dict[str, Term]:
        """The entries from the next line on, and the bracket after them."""
        found: dict[str, Term] = {}
        for line in self.lines[self.at + 1 :]:
            self.at += 1
            if line == "        }":
                self.at += 1
                return found
            entry = _ENTRY.match(line)
            if entry is None or entry[1] in found:
                raise self._bad("an entry that is no truth value, or comes twice")
            found[entry[1]] = self._value(entry[2])
        raise self._bad("a dictionary does not end")

    def _value(self, text: str, deep: int = DEEP) -> Expr:
        """Operands with one operator between them, whatever stands in brackets being one operand.

        By Python's rules, since operators of two kinds never stand beside each other without brackets.
        """
        for word, join in ((" and ", conj), (" or ", disj)):
            parts = text.split(word)
            if len(parts) > 1 and "(" in text:
                parts = _balanced(parts, word)
            if len(parts) > 1:
                args = []
                for part in parts:
                    held = self.values.get(part)  # most often a name
                    args.append(held if type(held) is Expr else self._operand(part, deep))
                return join(args)
        return self._operand(text, deep)

    def _operand(self, text: str, deep: int) -> Expr:
        """A name, `not` before an operand, brackets, a truth value, or a name `==` a number."""
        first = text[:4]
        held = self.values.get(text if first != "not " else text[4:])
        if isinstance(held, Expr):
            return held if first != "not " else neg(held)
        if not deep and (first == "not " or text.startswith("(")):
            why = "main signals on the way shorten the chain of sections that are released one after the other"
            raise self._bad(f"more than {DEEP} brackets stand in each other, which Python may not read: {why}")
        if deep and first == "not ":
            return neg(self._operand(text[4:], deep - 1))
        if deep and text.startswith("(") and text.endswith(")"):
            return self._value(text[1:-1], deep - 1)
        if text == "True" or text == "False":
            return TRUE if text == "True" else FALSE
        name, _, number = text.partition(" == ")
        held = self.values.get(name)
        if isinstance(held, Symbol) and _NUMBER.fullmatch(number):
            return eq(spelled(held.name), int(number))
        raise self._bad(f"{text[:60]!r} is not of the emitted shapes")


def _balanced(parts: Iterable[str], word: str) -> list[str]:
    """What was cut at a word, put together again where it was cut within brackets."""
    found: list[str] = []
    opened = 0
    for part in parts:
        if opened:
            found[-1] = f"{found[-1]}{word}{part}"
        else:
            found.append(part)
        opened += part.count("(") - part.count(")")
    return found


def _is_docstring(x: ast.stmt) -> bool:
    return isinstance(x, ast.Expr) and isinstance(x.value, ast.Constant) and isinstance(x.value.value, str)


def _same(a: Mapping[Any, object], b: Mapping[Any, object]) -> bool:
    """Whether keys and values are the same as written: 1.0 and True equal 1, and the scan does not take them for it."""
    return {repr(k): repr(v) for k, v in a.items()} == {repr(k): repr(v) for k, v in b.items()}


def _table(x: ast.stmt, name: str) -> dict[Any, object]:
    if isinstance(x, ast.Assign) and [ast.unparse(t) for t in x.targets] == [name] and isinstance(x.value, ast.Dict):
        keys = [k.value for k in x.value.keys if isinstance(k, ast.Constant)]
        if len(set(keys)) == len(x.value.keys):
            found: dict[Any, object] = ast.literal_eval(x.value)
            return found
    raise BadRuntime(f"{name} is no table, or has a name twice")
