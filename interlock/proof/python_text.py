"""What the generated Python runtime computes, read from its syntax tree: nothing is executed.

The parts that all runtimes share must be word for word what the emitter calls fixed; the rest is a list of
assignments of a few shapes.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator

from interlock.emit.python.runtime import FIXED
from interlock.logic.controller import Controller
from interlock.logic.expr import FALSE, TRUE, Expr, conj, disj, eq, neg, var
from interlock.proof.translation import Difference, Scan, Translation, compare_scan, wires
from interlock.st.meaning import Symbol, Symbols, Term


class BadRuntime(Exception):
    """The text is not a runtime as it is emitted."""


def compare_runtime(controller: Controller, text: str, query_ms: int = 20_000) -> Translation:
    """Compare a Python runtime with its controller."""
    try:
        return compare_scan(controller, _Reader(controller, text).scan(), query_ms)
    except (BadRuntime, SyntaxError, ValueError) as error:
        return Translation(0, (Difference("runtime", f"cannot be read: {error}"),))


def _names(fixed: str) -> frozenset[str]:
    """Every name that the fixed part relies on: assigned once more, the scan would no longer do what it says."""
    nodes = list(ast.walk(ast.parse(fixed)))
    return frozenset(
        {x.id for x in nodes if isinstance(x, ast.Name)} | {x.arg for x in nodes if isinstance(x, ast.arg)}
    )


RESERVED = _names(FIXED) | {"bool", "OUTPUTS", "Controller"}


PIECE = 200_000  # characters that are read at a time
_STATEMENT = re.compile(r"^ {8}(?=[A-Za-z_])", re.MULTILINE)


class _Reader:
    def __init__(self, controller: Controller, text: str) -> None:
        self.values: dict[str, Term] = {}
        self.after: dict[str, Term] = {}
        self.timers: dict[str, tuple[Expr, int]] = {}
        self.algebra = Symbols(known=wires(controller))
        self.sizes = {i.name: i.size for i in controller.inputs}
        head, fixed, self.own = text.partition(FIXED)
        self.before = head.count("\n") + FIXED.count("\n")
        doc, *rest = ast.parse(head + fixed).body
        if not _is_docstring(doc) or len(rest) != 5:
            raise BadRuntime("the parts of the module")
        tables = [_table(x, n) for x, n in zip(rest, ("INPUTS", "STATE", "TIMERS", "OUTPUTS"), strict=False)]
        inputs, self.state, self.presets, self.restrictive = tables
        if inputs != {i.name: (i.restrictive, i.size or 2) for i in controller.inputs}:
            raise BadRuntime("INPUTS are not those of the controller")
        if self.restrictive != {o.name: o.restrictive for o in controller.outputs}:
            raise BadRuntime("OUTPUTS are not those of the controller")
        if ast.dump(rest[4]) != ast.dump(ast.parse(FIXED).body[0]):
            raise BadRuntime("the fixed part of the class is changed")

    def scan(self) -> Scan:
        """Initial and next state, outputs and timers."""
        base: dict[str, Term] = {n: TRUE if v is True else FALSE for n, v in self.state.items() if type(v) is bool}
        outputs: dict[str, Term] | None = None
        for s in self._statements():
            if outputs is not None:
                raise BadRuntime(f"{self._line(s)}: something follows the outputs")
            if isinstance(s, ast.Return) and isinstance(s.value, ast.Dict):
                outputs = self._dictionary(s.value)
            else:
                self._assign(s)
        if outputs is None:
            raise BadRuntime("the outputs are not returned at the end")
        if set(self.timers) != set(self.presets):
            raise BadRuntime("TIMERS are not those that run")
        return Scan(base, self.after, outputs, self.timers)

    def _statements(self) -> Iterator[ast.stmt]:
        """What the scan does after the fixed part, read in pieces: the tree of a large text takes a gigabyte.

        A piece begins with a statement of the scan's own depth.  As it is read whole as the body of one function, each
        bracket and string in it ends in it, and no line leaves the function: pieces one after the other are read as
        they would be together.
        """
        starts = [m.start() for m in _STATEMENT.finditer(self.own)]
        if not starts or starts[0]:
            raise BadRuntime("nothing follows the fixed part")
        begin = 0
        for end in (*starts[1:], len(self.own)):
            if end - begin < PIECE and end < len(self.own):
                continue
            piece = self.own[begin:end]
            try:
                function, *more = ast.parse("def scan():\n" + piece).body
            except SyntaxError as error:
                raise BadRuntime(f"line {self.before + (error.lineno or 1) - 1}: {error.msg}") from None
            if more or not isinstance(function, ast.FunctionDef):
                raise BadRuntime(f"{self._line(more[0] if more else function)}: the scan ends")
            yield from function.body
            begin = end
            self.before += piece.count("\n")

    def _line(self, x: ast.stmt | ast.expr) -> str:
        return f"line {self.before + x.lineno - 1}"

    def _assign(self, s: ast.stmt) -> None:
        if not isinstance(s, ast.Assign) or len(s.targets) != 1:
            raise BadRuntime(f"{self._line(s)}: no assignment")
        target, value = s.targets[0], s.value
        if isinstance(target, ast.Name):
            if target.id in RESERVED:
                raise BadRuntime(f"{self._line(s)}: {target.id} is a name of the fixed part")
            self.values[target.id] = self.algebra.assigned(target.id, self._read(target.id, value))
        elif _dotted(target) == "self.state" and isinstance(value, ast.Dict) and not self.after:
            self.after = self._dictionary(value)
        else:
            raise BadRuntime(f"{self._line(s)}: {ast.unparse(target)} is assigned")

    def _read(self, name: str, x: ast.expr) -> Term:
        if isinstance(x, ast.Subscript) and isinstance(x.slice, ast.Constant):
            where, key = _dotted(x.value), str(x.slice.value)
            if where == "read" and key in self.sizes:
                return Symbol(key) if self.sizes[key] else var(key)
            if where == "old" and key in self.state:
                return var(key)
            if where == "self.state" and key in self.after:
                return self.after[key]
        if isinstance(x, ast.Call) and _dotted(x.func) == "self._timer" and len(x.args) == 3 and not x.keywords:
            own, on, dt = x.args
            if isinstance(own, ast.Constant) and own.value == name and _dotted(dt) == "dt_ms":
                preset = self.presets.get(name)
                if type(preset) is int and name not in self.timers:
                    self.timers[name] = (self._value(on), preset)
                    return var(name)
        return self._value(x)

    def _dictionary(self, x: ast.Dict) -> dict[str, Term]:
        found: dict[str, Term] = {}
        for key, value in zip(x.keys, x.values, strict=True):
            plain = (
                isinstance(value, ast.Call)
                and _dotted(value.func) == "bool"
                and len(value.args) == 1
                and not value.keywords
            )
            if not isinstance(key, ast.Constant) or not plain or key.value in found:
                raise BadRuntime(f"{self._line(x)}: an entry that is no truth value, or comes twice")
            assert isinstance(value, ast.Call)
            found[str(key.value)] = self._value(value.args[0])
        return found

    def _value(self, x: ast.expr) -> Expr:
        if isinstance(x, ast.Constant) and type(x.value) is bool:
            return TRUE if x.value else FALSE
        if isinstance(x, ast.Name):
            found = self.values.get(x.id)
            if isinstance(found, Expr):
                return found
        if isinstance(x, ast.UnaryOp) and isinstance(x.op, ast.Not):
            return neg(self._value(x.operand))
        if isinstance(x, ast.BoolOp):
            join = conj if isinstance(x.op, ast.And) else disj
            return join([self._value(v) for v in x.values])
        if isinstance(x, ast.Compare) and isinstance(x.left, ast.Name) and len(x.ops) == 1:
            symbol, right = self.values.get(x.left.id), x.comparators[0]
            number = right.value if isinstance(right, ast.Constant) and type(right.value) is int else None
            if isinstance(symbol, Symbol) and isinstance(x.ops[0], ast.Eq) and number is not None:
                return eq(symbol.name, number)
        raise BadRuntime(f"{self._line(x)}: {ast.unparse(x)} is not of the emitted shapes")


def _dotted(x: ast.expr) -> str:
    """A plain name, or an attribute of one; nothing of what is built otherwise."""
    if isinstance(x, ast.Name):
        return x.id
    if isinstance(x, ast.Attribute) and isinstance(x.value, ast.Name):
        return f"{x.value.id}.{x.attr}"
    return ""


def _is_docstring(x: ast.stmt) -> bool:
    return isinstance(x, ast.Expr) and isinstance(x.value, ast.Constant) and isinstance(x.value.value, str)


def _table(x: ast.stmt, name: str) -> dict[str, object]:
    if isinstance(x, ast.Assign) and [ast.unparse(t) for t in x.targets] == [name] and isinstance(x.value, ast.Dict):
        keys = [k.value for k in x.value.keys if isinstance(k, ast.Constant)]
        if len(set(keys)) == len(x.value.keys):
            found: dict[str, object] = ast.literal_eval(x.value)
            return found
    raise BadRuntime(f"{name} is no table, or has a name twice")
