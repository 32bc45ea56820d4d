"""From the controller to Structured Text.

The steps are cut into small function blocks, in an order in which what belongs to one place of the railway stands
together as far as the scan allows; a block gets what it reads as inputs and gives what it
computes as outputs.  Timers stand in blocks of their own, and so do words.  State lives in blocks that are called last,
so that every equation of a scan sees the old state.  The main block calls them all in one fixed order.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence

from interlock.logic.controller import Controller, Equation, Input, Join, StateVar, Term, Timer
from interlock.logic.expr import AND, EQ, FALSE, NOT, TRUE, VAR, Expr
from interlock.logic.names import computed
from interlock.logic.order import together
from interlock.logic.words import UNKNOWN, Value, Word, Words
from interlock.model.portable import portable
from interlock.st.ast import (
    HEADLINE,
    Assign,
    Block,
    Bool,
    Call,
    Compare,
    Declaration,
    Expression,
    If,
    Int,
    Name,
    Nary,
    Not,
    Statement,
    Time,
    Unit,
)

MAX_OPERANDS = 10
MAX_ROWS = 400  # the strictest guide found allows 500
MAX_STATE = 120
SAYING = "words: what is said of routes, in codes (io/words.csv)"


def lower_st(controller: Controller, header: Sequence[str], rows: int = MAX_ROWS) -> Unit:
    """The whole text of a controller as a tree; `rows`: of equations and declarations in a computing block."""
    prefix = f"IL_{portable(controller.name)}"
    ranges = {i.name for i in controller.inputs if i.size}
    following = {e.name: e.named(computed(e.name)) for e in controller.next}  # its meaning: where its state is declared
    pieces = _cut(together(controller.steps, following), rows)
    blocks: list[Block] = []
    where: dict[str, Name] = {i.name: Name((i.name,)) for i in controller.inputs}
    body: list[Statement] = []
    locals_: list[Declaration] = []
    state_blocks = [controller.state[i : i + MAX_STATE] for i in range(0, len(controller.state), MAX_STATE)]
    for k, part in enumerate(state_blocks, 1):
        for s in part:
            where[s.name] = Name((f"S{k:02d}", s.name))
    counts = {"B": 0, "T": 0}
    names, inputs = _Names(), _Inputs(ranges)
    for piece in pieces:
        letter = "T" if isinstance(piece[0], Timer) else "B"
        counts[letter] += 1
        instance = f"{letter}{counts[letter]:02d}"
        timers = [x for x in piece if isinstance(x, Timer)]
        equations = [x for x in piece if isinstance(x, Equation)]
        name = f"{prefix}_{instance}"
        block = _timing(name, timers) if timers else _computing(name, equations, names, inputs)
        blocks.append(block)
        locals_.append(Declaration(instance, block.name, None, block.note[:HEADLINE]))
        body.append(Call(instance, tuple([(d.name, where[d.name]) for d in block.inputs])))
        for x in piece:
            where[x.name] = Name((instance, x.name))
    for instance, block in _words(controller, prefix, rows, where):
        blocks.append(block)
        locals_.append(Declaration(instance, block.name, None, block.note[:HEADLINE]))
        body.append(Call(instance, tuple([(d.name, where[d.name]) for d in block.inputs])))
        where |= {d.name: Name((instance, d.name)) for d in block.outputs}
    for k, part in enumerate(state_blocks, 1):
        block = _keeping(f"{prefix}_S{k:02d}", part)
        blocks.append(block)
        locals_.insert(k - 1, Declaration(f"S{k:02d}", block.name, None, block.note))
        body.append(Call(f"S{k:02d}", tuple((d.name, where[d.name]) for d in block.inputs)))
    for o in controller.outputs:
        body.append(Assign(Name((o.name,)), _expression(o.expr, where), o.note))
    said = [controller.words.by_name[n] for n in controller.words.routes.values()]
    body += [Assign(Name((w.name,)), where[w.name], w.note) for w in said]
    main = Block(
        prefix,
        tuple(_input(i) for i in controller.inputs),
        (
            *(Declaration(o.name, "BOOL", Bool(o.restrictive), o.note) for o in controller.outputs),
            *(Declaration(w.name, "INT", Int(UNKNOWN), w.note) for w in said),
        ),
        tuple(locals_),
        tuple(body),
        f"interlocking {controller.name}: one call per cycle; the order of the calls is part of the proof",
    )
    return Unit((*blocks, main), tuple(header))


def _words(controller: Controller, prefix: str, rows: int, where: Mapping[str, Name]) -> Iterator[tuple[str, Block]]:
    """The blocks that say words, each with the name of its instance; they are called before the state is committed."""
    words = controller.words.words
    ranges = {w.name for w in words}
    pieces: list[list[Word]] = []
    length, reads = 0, set[str]()
    for w in words:
        read = set(w.reads)
        size = 4 + 2 * len(w.cases)
        if not pieces or length + size + len(reads | read) > rows:
            pieces.append([])
            length, reads = 0, set()
        pieces[-1].append(w)
        length += size
        reads |= read
    names, inputs = _Names(), _Inputs(ranges)
    told: set[Value] = set()
    for k, piece in enumerate(pieces, 1):
        block = f"{prefix}_W{k:02d}"
        yield f"W{k:02d}", _saying(block, piece, names, inputs, controller.words, told)


def _saying(name: str, piece: Sequence[Word], where: _Names, inputs: _Inputs, words: Words, told: set[Value]) -> Block:
    """A block of words: IF the first condition THEN its code.  told: the codes whose sentence the text has had."""
    made = {w.name for w in piece}
    reads = {n: None for w in piece for n in w.reads if n not in made}
    extra: list[Declaration] = []
    body: list[Statement] = []
    for w in piece:
        arms: list[tuple[Expression, tuple[Statement, ...]]] = []
        for c in w.cases:
            x = c.condition
            condition = where[x.name] if x.op is VAR else _short(x, where, extra, body)
            arms.append((condition, (_said(where[w.name], c.value, where, words, told),)))
        last = _said(where[w.name], w.otherwise, where, words, told)
        body.append(If(*arms[0], (last,), tuple(arms[1:])) if arms else last)
    return Block(
        name,
        tuple([inputs[n] for n in reads]),
        tuple([Declaration(w.name, "INT", None, w.note) for w in piece]),
        tuple(extra),
        tuple(body),
        SAYING,
    )


def _said(target: Name, value: Value, where: Mapping[str, Name], words: Words, told: set[Value]) -> Assign:
    """A word gets a code, with its sentence where the text has it first, or the value of another word."""
    if isinstance(value, int):
        note = words.said(value) if value and value not in told else ""
        told.add(value)
        return Assign(target, Int(value), note)
    return Assign(target, where[value])


def _input(i: Input) -> Declaration:
    initial: Expression = Int(i.restrictive) if i.size else Bool(bool(i.restrictive))
    return Declaration(i.name, "INT" if i.size else "BOOL", initial, i.note)


def _rows(e: Equation) -> int:
    return 3 + len(e.terms) + sum([len(t.expr.args) // 4 for t in e.terms])


def _cut(steps: Sequence[Equation | Timer], most: int) -> list[list[Equation | Timer]]:
    """Consecutive equations, and consecutive timers, in pieces of limited size."""
    out: list[list[Equation | Timer]] = []
    rows, reads = 0, set[str]()
    for step in steps:
        read = step.reads if isinstance(step, Equation) else (step.input,)
        size = _rows(step) if isinstance(step, Equation) else 4
        if out and type(out[-1][0]) is type(step):
            new = set(read).difference(reads)
            if rows + size + len(reads) + len(new) <= most:
                out[-1].append(step)
                rows += size
                reads |= new
                continue
        out.append([step])
        rows, reads = size, set(read)
    return out


def _timing(name: str, timers: Sequence[Timer]) -> Block:
    """On-delay timers: what they wait for comes in, whether the time is over goes out."""
    body: list[Statement] = []
    for t in timers:
        body.append(Call(f"TON_{t.name}", (("IN", Name((t.input,))), ("PT", Time(t.preset_ms)))))
        body.append(Assign(Name((t.name,)), Name((f"TON_{t.name}", "Q"))))
    return Block(
        name,
        tuple(Declaration(n, "BOOL") for n in dict.fromkeys(t.input for t in timers)),
        tuple(Declaration(t.name, "BOOL", None, t.note) for t in timers),
        tuple(Declaration(f"TON_{t.name}", "TON") for t in timers),
        tuple(body),
        "timers",
    )


class _Names(dict[str, Name]):
    """How a block reads and writes a variable: the same in all blocks."""

    def __missing__(self, name: str) -> Name:
        found = self[name] = Name((name,))
        return found


class _Inputs(dict[str, Declaration]):
    """How a block declares a variable as an input: the same in all blocks."""

    def __init__(self, ranges: Collection[str]) -> None:
        super().__init__()
        self._ranges = ranges

    def __missing__(self, name: str) -> Declaration:
        found = self[name] = Declaration(name, "INT" if name in self._ranges else "BOOL")
        return found


def _listed(names: list[str]) -> str:
    """Names on one line, each whole; how many are left out, where they are too many."""
    for k in range(len(names), 0, -1):
        text = ", ".join([*names[:k], *([f"and {len(names) - k} more"] if k < len(names) else [])])
        if len(text) <= HEADLINE:
            return text
    return f"{len(names)} places"


def _computing(name: str, equations: Sequence[Equation], where: _Names, inputs: _Inputs) -> Block:
    made = {e.name for e in equations}
    reads = {n: None for e in equations for n in e.reads if n not in made}
    extra: list[Declaration] = []
    body: list[Statement] = []
    for e in equations:
        body.extend(_equation(e, where, extra))
    return Block(
        name,
        tuple([inputs[n] for n in reads]),
        tuple([Declaration(e.name, "BOOL") for e in equations]),  # its meaning stands where it is computed
        tuple(extra),
        tuple(body),
        _listed(list(dict.fromkeys(e.group for e in equations))),
    )


def _equation(e: Equation, where: dict[str, Name], extra: list[Declaration]) -> list[Statement]:
    """One equation; more operands than allowed are joined in steps."""
    op = "AND" if e.join is Join.ALL else "OR"
    out: list[Statement] = []
    operands: list[Expression] = []
    notes: list[str] = []
    for t in e.terms:
        x = t.expr
        if (x is TRUE or x is FALSE) and len(e.terms) > 1 and (x is TRUE) == (e.join is Join.ALL):
            continue
        operands.append(_short(x, where, extra, out))
        notes.append(_told(t))
    if not operands:
        operands, notes = [Bool(e.join is Join.ALL)], ["nothing"]
    while len(operands) > MAX_OPERANDS:
        temp = _temp(extra)
        out.append(Assign(temp, Nary(op, tuple(operands[:MAX_OPERANDS]), tuple(notes[:MAX_OPERANDS]))))
        operands[:MAX_OPERANDS], notes[:MAX_OPERANDS] = [temp], [""]
    value = operands[0] if len(operands) == 1 else Nary(op, tuple(operands), tuple(notes))
    out.append(Assign(where[e.name], value, e.note))
    return out


def _told(t: Term) -> str:
    """What an operand says; nothing of a variable alone, whose meaning stands where it is declared or computed."""
    x = t.expr.args[0] if t.expr.op is NOT else t.expr
    return (t.note or t.kind) if x.args else ""


def _temp(extra: list[Declaration]) -> Name:
    extra.append(Declaration(f"T_{len(extra) + 1}", "BOOL"))
    return Name((extra[-1].name,))


def _short(x: Expr, where: dict[str, Name], extra: list[Declaration], out: list[Statement]) -> Expression:
    """An operand: at most two levels deep and ten wide, the rest in temporaries."""
    if x.op is VAR:
        return where[x.name]
    if x.op is NOT:
        return Not(_short(x.args[0], where, extra, out))
    if not x.args:
        return _expression(x, where)
    args: list[Expression] = []
    for a in x.args:
        inner = a.args[0] if a.op is NOT else a
        if inner.args:
            temp = _temp(extra)
            out.append(Assign(temp, _short(inner, where, extra, out)))
            args.append(Not(temp) if a.op is NOT else temp)
        else:
            args.append(_expression(a, where))
    op = "AND" if x.op is AND else "OR"
    while len(args) > MAX_OPERANDS:
        temp = _temp(extra)
        out.append(Assign(temp, Nary(op, tuple(args[:MAX_OPERANDS]))))
        args = [temp, *args[MAX_OPERANDS:]]
    return Nary(op, tuple(args))


def _expression(x: Expr, where: dict[str, Name]) -> Expression:
    if x is TRUE or x is FALSE:
        return Bool(x is TRUE)
    if x.op is VAR:
        return where[x.name]
    if x.op is EQ:
        return Compare("=", where[x.name], Int(x.value))
    if x.op is NOT:
        return Not(_expression(x.args[0], where))
    args = tuple(_expression(a, where) for a in x.args)
    return Nary("AND" if x.op is AND else "OR", args)


def _keeping(name: str, part: Sequence[StateVar]) -> Block:
    return Block(
        name,
        tuple(Declaration(f"N_{s.name}", "BOOL", Bool(s.initial)) for s in part),
        tuple(Declaration(s.name, "BOOL", Bool(s.initial), s.note) for s in part),
        (),
        tuple(Assign(Name((s.name,)), Name((f"N_{s.name}",))) for s in part),
        "state: committed at the end of the scan",
    )
