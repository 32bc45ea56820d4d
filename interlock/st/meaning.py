"""What a parsed text means: one walk over the statements, with numbers for execution or expressions for proof.

`Algebra` says what the operators do.  With `Numbers` the walk is an interpreter with TON timers; with `Symbols` it
is symbolic execution and gives every state variable's next value as an expression.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import field
from typing import Generic, Protocol, TypeVar

from interlock.dataclass import dataclass
from interlock.logic.expr import FALSE, TRUE, Expr, conj, disj, eq, neg, var
from interlock.logic.names import spelled
from interlock.logic.on_delay import on_delay
from interlock.st.ast import (
    Assign,
    Block,
    Bool,
    Call,
    Compare,
    Expression,
    If,
    Int,
    Name,
    Nary,
    Not,
    Statement,
    Time,
    Unit,
    node,
)

V = TypeVar("V")
STANDARD = frozenset(("BOOL", "INT", "TIME", "TON", "TON_TIME"))
"""Types that a text uses and must not define: a tool would take its own block TON for the timer."""


class BadText(Exception):
    """The text does something that the subset does not allow (unknown name, wrong type, second write)."""


class Algebra(Protocol[V]):
    """Operators over some kind of value (numbers, formulas).  `choose`: a where c, else b; `timer`: Q of the TON at a
    path; `assigned`: what a variable holds from then on, when x was assigned to it."""

    def literal(self, x: Bool | Int | Time) -> V: ...
    def neg(self, x: V) -> V: ...
    def nary(self, op: str, xs: list[V]) -> V: ...
    def compare(self, op: str, a: V, b: V) -> V: ...
    def choose(self, c: V, a: V, b: V) -> V: ...
    def timer(self, path: str, on: V, preset: V) -> V: ...
    def assigned(self, name: str, x: V) -> V: ...


@dataclass
class Instance(Generic[V]):
    """A function block instance: its variables with the values that they begin with, and inner instances.

    values: what the variables hold now; of those that are not among them nobody knows it.  holder: where members of
    structures lie that are handed to it (`handed`): itself, or whoever calls it.
    """

    block: Block
    start: dict[str, V]
    inner: dict[str, Instance[V]]
    path: str
    handed: frozenset[str]
    values: dict[str, V] = field(init=False)
    holder: Instance[V] = field(init=False)

    def __post_init__(self) -> None:
        self.values = dict(self.start)
        self.holder = self

    def forget(self) -> None:
        """Forget the values that this instance and those in it hold."""
        self.values.clear()
        for inner in self.inner.values():
            inner.forget()


class Execution(Generic[V]):
    """Runs scans of the last block of a unit over an algebra.

    kept: a value for a variable that is read while nobody knows what it holds, by its path and what it begins with.
    With it a scan is carried out for proof, and `BadText` is raised where it writes a variable twice: others may see it
    in between (a signal that shows proceed until a later statement takes it back).
    """

    def __init__(self, unit: Unit, algebra: Algebra[V], kept: Callable[[str, V], V] | None = None) -> None:
        self.algebra = algebra
        self.kept = kept
        self._written: set[tuple[str, str]] = set()
        self.blocks = {b.name.upper(): b for b in unit.blocks}
        if len(self.blocks) != len(unit.blocks):
            raise BadText("two blocks of one name")
        if own := STANDARD & set(self.blocks):
            raise BadText(f"the text defines {min(own)} itself")
        self.lies = self._lies(unit)
        self.main = self._instance(unit.blocks[-1], "")

    def _lies(self, unit: Unit) -> dict[str, str]:
        """By each member of the structures that are handed on the one name that its structure has everywhere."""
        types: dict[str, str] = {}
        for d in (d for b in unit.blocks for d in b.handed):
            kind = d.type.upper()
            if types.setdefault(d.name, kind) != kind or kind not in self.blocks or self.blocks[kind].kind != "STRUCT":
                raise BadText(f"{d.name} is no structure, or several")
        members = [(d.name, n) for n, kind in types.items() for d in self.blocks[kind].locals]
        lies = dict(members)
        if len(lies) < len(members):
            raise BadText("two members of one name")
        return lies

    def _instance(self, block: Block, path: str) -> Instance[V]:
        values: dict[str, V] = {}
        inner: dict[str, Instance[V]] = {}
        declared = (*block.inputs, *block.outputs, *block.locals)
        names = [d.name.upper() for d in declared]
        if len(set(names)) < len(names):
            twice = next(d.name for n, d in enumerate(declared) if names[n] in names[:n])
            raise BadText(f"{block.name}: {twice} is declared twice")
        off = self.algebra.literal(Bool(False))
        for d in declared:
            if d.type == "BOOL" and d.initial is None:
                values[d.name] = off
                continue
            kind = d.type.upper()
            if kind == "TON":
                values[f"{d.name}.Q"] = self.algebra.literal(Bool(False))
            elif kind in ("BOOL", "INT"):
                default: Bool | Int = Bool(False) if kind == "BOOL" else Int(0)
                if d.initial is not None and not isinstance(d.initial, Bool | Int):
                    raise BadText(f"{block.name}: the initial value of {d.name} is no literal")
                values[d.name] = self.algebra.literal(d.initial if d.initial is not None else default)
            elif kind in self.blocks and self.blocks[kind].kind != "STRUCT":
                inner[d.name] = self._instance(self.blocks[kind], f"{path}{d.name}.")
            else:
                raise BadText(f"{block.name}: unknown type {d.type}")
        made = Instance(block, values, inner, path, frozenset(d.name for d in block.handed))
        _hold(made, made)
        return made

    def scan(self, inputs: Mapping[str, V]) -> dict[str, V]:
        """One call of the main block."""
        self._written = set()
        self._call(self.main, inputs)
        return {d.name: self._held(self.main, d.name) for d in self.main.block.outputs}

    def _call(self, inst: Instance[V], inputs: Mapping[str, V]) -> None:
        names = inst.block.input_names
        for n, v in inputs.items():
            if n not in names:
                raise BadText(f"{inst.block.name} has no input {n}")
            inst.values[n] = v
        self._run(inst, inst.block.body)

    def _run(self, inst: Instance[V], body: tuple[Statement, ...]) -> None:
        for s in body:
            if isinstance(s, Assign):
                holder, name = self._place(inst, s.target)
                self._write(holder, name)
                holder.values[name] = self.algebra.assigned(name, self._value(inst, s.value))
            elif isinstance(s, Call):
                self._invoke(inst, s)
            else:
                self._branch(inst, s)

    def _write(self, holder: Instance[V], name: str) -> None:
        """Note that a variable is written in this scan."""
        variable = holder.path, name
        if self.kept is not None and variable in self._written:
            raise BadText(f"{''.join(variable)} is written twice in a scan")
        self._written.add(variable)

    def _place(self, inst: Instance[V], target: Name) -> tuple[Instance[V], str]:
        """What is assigned to: a variable of the block, or a member of a structure that is no input."""
        parts, last, holder = target.parts, target.parts[-1], inst.holder
        if len(parts) == 1 and last in inst.start:
            return inst, last
        member = len(parts) == 2 and parts[0] in inst.handed and self.lies.get(last) == parts[0]
        if member and last in holder.start and last not in holder.block.input_names:
            return holder, last
        raise BadText(f"{inst.block.name}: cannot assign to {target}")

    def _invoke(self, inst: Instance[V], s: Call) -> None:
        given = {n: self._value(inst, x) for n, x in s.params}
        if len(given) != len(s.params):
            raise BadText(f"{inst.block.name}: a parameter of {s.instance} is given twice")
        if s.instance in inst.inner:
            self._call(inst.inner[s.instance], given)
        elif f"{s.instance}.Q" in inst.start and set(given) == {"IN", "PT"}:
            path = f"{inst.path}{s.instance}"
            inst.values[f"{s.instance}.Q"] = self.algebra.timer(path, given["IN"], given["PT"])
        else:
            raise BadText(f"{inst.block.name}: cannot call {s.instance}")

    def _branch(self, inst: Instance[V], s: If) -> None:
        """Each arm is carried out from where all begin; of what they leave behind the first that holds has its way."""
        a = self.algebra
        conditions = [self._value(inst, c) for c, _ in s.arms]
        places = [self._place(inst, n) for n in _targets(inst.block, s).values()]
        before = [self._held(holder, n) for holder, n in places]
        for holder, n in places:
            self._write(holder, n)
        left: list[list[V]] = []
        written = self._written
        for body in (*(then for _, then in s.arms), s.otherwise):
            self._written = set()  # one of the arms is carried out
            self._run(inst, body)
            left.append([holder.values[n] for holder, n in places])
            for (holder, n), v in zip(places, before, strict=True):
                holder.values[n] = v
        self._written = written
        found = left.pop()
        for condition, then in zip(reversed(conditions), reversed(left), strict=True):
            found = [v if x is v else a.choose(condition, x, v) for x, v in zip(then, found, strict=True)]
        for (holder, n), v in zip(places, found, strict=True):
            holder.values[n] = a.assigned(n, v)

    def _value(self, inst: Instance[V], x: Expression) -> V:
        a = self.algebra
        if isinstance(x, Name):
            return self._named(inst, x)
        if isinstance(x, Not):
            return a.neg(self._value(inst, x.arg))
        if isinstance(x, Nary):
            args: list[V] = []
            for y in x.args:
                z = y.arg if isinstance(y, Not) else y
                known = self._named(inst, z) if isinstance(z, Name) else self._value(inst, z)
                args.append(known if z is y else a.neg(known))
            return a.nary(x.op, args)
        if isinstance(x, Compare):
            return a.compare(x.op, self._value(inst, x.left), self._value(inst, x.right))
        return a.literal(x)

    def _named(self, inst: Instance[V], x: Name) -> V:
        """The value of a variable, of a member of a structure, or of an output of an instance."""
        parts = x.parts
        first, last = parts[0], parts[-1]
        holder = inst
        if len(parts) == 2 and first in inst.handed:
            holder, last = inst.holder, last if self.lies.get(last) == first else str(x)
        elif len(parts) == 2 and first in inst.inner:
            holder = inst.inner[first]
            if last not in holder.block.output_names:
                raise BadText(f"{inst.block.name}: {x} is no output")
        elif len(parts) > 1:
            last = str(x)
        found = holder.values.get(last)
        if found is not None:
            return found
        if last not in holder.start:
            raise BadText(f"{inst.block.name}: unknown name {x}")
        return self._held(holder, last)

    def _held(self, inst: Instance[V], name: str) -> V:
        """What a variable of an instance holds."""
        if name not in inst.values:
            assert self.kept is not None, "only who tells what a variable may have kept has them forgotten"
            inst.values[name] = self.kept(f"{inst.path}{name}", inst.start[name])
        return inst.values[name]


def _hold(inst: Instance[V], holder: Instance[V]) -> None:
    """What is handed on to a block that an instance calls lies where what is handed to the instance does."""
    for inner in inst.inner.values():
        if inst.handed and inner.handed:
            inner.holder = holder
            _hold(inner, holder)


def _targets(block: Block, s: If) -> dict[tuple[str, ...], Name]:
    """What is written under an IF, where nothing may be called."""
    found: dict[tuple[str, ...], Name] = {}
    for x in (*(x for _, then in s.arms for x in then), *s.otherwise):
        if isinstance(x, Assign):
            found[x.target.parts] = x.target
        elif isinstance(x, If):
            found |= _targets(block, x)
        else:
            raise BadText(f"{block.name}: nothing may be called under IF")
    return found


@dataclass
class Numbers:
    """Execution: Booleans as 0 and 1, integers, and timers that count the time given to each scan."""

    dt_ms: int = 0
    elapsed: dict[str, int | None] = field(default_factory=dict)

    def literal(self, x: Bool | Int | Time) -> int:
        """The value of a literal."""
        return x.ms if isinstance(x, Time) else int(x.value)

    def neg(self, x: int) -> int:
        """NOT."""
        return int(not x)

    def nary(self, op: str, xs: list[int]) -> int:
        """AND, OR, XOR."""
        if op == "AND":
            return int(all(xs))
        return int(any(xs)) if op == "OR" else sum(map(bool, xs)) % 2

    def compare(self, op: str, a: int, b: int) -> int:
        """A comparison."""
        return int({"=": a == b, "<>": a != b, "<": a < b, ">": a > b, "<=": a <= b, ">=": a >= b}[op])

    def choose(self, c: int, a: int, b: int) -> int:
        """a if c else b."""
        return a if c else b

    def timer(self, path: str, on: int, preset: int) -> int:
        """On-delay."""
        self.elapsed[path], over = on_delay(self.elapsed.get(path), bool(on), preset, self.dt_ms)
        return int(over)

    def assigned(self, name: str, x: int) -> int:
        """What a variable holds after an assignment."""
        return x


@node
class Constant:
    """An integer or time constant in symbolic execution."""

    value: int


@node
class Symbol:
    """A named integer in symbolic execution."""

    name: str


@node
class Cases:
    """An integer by cases in symbolic execution: the value beside the first condition that holds, else the last."""

    cases: tuple[tuple[Expr, Term], ...]
    otherwise: Term


Term = Expr | Constant | Symbol | Cases


@dataclass
class Symbols:
    """Symbolic execution; `timers` collects input and preset of every timer by its name.

    `known`: by a variable's name an expression, and what stands for it in what follows once the variable got this very
    expression, so that what is computed from it stays short.
    """

    timers: dict[str, tuple[Expr, int]] = field(default_factory=dict)
    timer_names: dict[str, str] = field(default_factory=dict)
    known: Mapping[str, tuple[Expr, Expr]] = field(default_factory=dict)
    words: Mapping[str, Term] = field(default_factory=dict)
    """By a word's name its cases; its name stands for it once a variable of this name got these very cases."""

    def assigned(self, name: str, x: Term) -> Term:
        """What a variable holds after an assignment."""
        found = self.known.get(name)
        if found is not None and found[0] is x:
            return found[1]
        return Symbol(name) if isinstance(x, Cases) and self.words.get(name) == x else x

    def literal(self, x: Bool | Int | Time) -> Term:
        """Constants."""
        if isinstance(x, Bool):
            return TRUE if x.value else FALSE
        return Constant(x.ms if isinstance(x, Time) else x.value)

    def _bool(self, x: Term) -> Expr:
        if not isinstance(x, Expr):
            raise BadText("an integer stands where a truth value is needed")
        return x

    def neg(self, x: Term) -> Term:
        """NOT."""
        return neg(self._bool(x))

    def nary(self, op: str, xs: list[Term]) -> Term:
        """AND, OR, XOR."""
        args = [x if type(x) is Expr else self._bool(x) for x in xs]
        if op == "AND":
            return conj(args)
        if op == "OR":
            return disj(args)
        out = args[0]
        for y in args[1:]:
            out = disj((conj((out, neg(y))), conj((neg(out), y))))
        return out

    def compare(self, op: str, a: Term, b: Term) -> Term:
        """Equality of a named integer with a constant; nothing else occurs in the subset."""
        if isinstance(a, Symbol) and isinstance(b, Constant) and op in ("=", "<>"):
            same = eq(spelled(a.name), b.value)
            return same if op == "=" else neg(same)
        raise BadText(f"a comparison outside the subset: {op}")

    def choose(self, c: Term, a: Term, b: Term) -> Term:
        """a if c else b; integers stay apart case by case."""
        x = self._bool(c)
        if x is TRUE or x is FALSE:
            return a if x is TRUE else b
        if not isinstance(a, Expr) and not isinstance(b, Expr):
            return Cases(((x, a), *b.cases), b.otherwise) if isinstance(b, Cases) else Cases(((x, a),), b)
        y, z = self._bool(a), self._bool(b)
        return disj((conj((x, y)), conj((neg(x), z))))

    def timer(self, path: str, on: Term, preset: Term) -> Term:
        """A fresh variable for the output; its input and preset are compared separately."""
        own = path.rsplit(".", 1)[-1]
        name = self.timer_names.get(own, f"timer {own}")
        if not isinstance(preset, Constant) or name in self.timers:
            raise BadText(f"timer {own} is called twice or without a constant time")
        self.timers[name] = (self._bool(on), preset.value)
        return var(spelled(name))
