"""Our own checks of an emitted text, on its tree.

Numbers after "PLCopen" are those of the PLCopen coding guidelines as far as we know them by name; the guidelines'
text was not at hand, so no compliance is claimed.  Sizes are those of the strictest guide found.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator

from interlock.dataclass import dataclass
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
)
from interlock.st.printer import print_block

MOST_ROWS, MOST_DEPTH, MOST_OPERANDS, LONGEST = 500, 3, 10, 24


def _words(text: str) -> frozenset[str]:
    return frozenset(text.split())


KEYWORDS = _words("ON TASK STEP ACTION FROM TO AT LEFT RIGHT LEN LIMIT SEL DT EN ENO")
S7_SCL = _words(
    """
    AND ANY ARRAY AT BEGIN BLOCK_DB BLOCK_FB BLOCK_FC BLOCK_SDB BLOCK_SFB BLOCK_SFC BOOL BY BYTE CASE CHAR CONST
    CONTINUE COUNTER DATA_BLOCK DATE DATE_AND_TIME DINT DIV DO DT DWORD ELSE ELSIF EN END_CASE END_CONST END_DATA_BLOCK
    END_FOR END_FUNCTION END_FUNCTION_BLOCK END_IF END_LABEL END_ORGANIZATION_BLOCK END_REPEAT END_STRUCT END_TYPE
    END_VAR END_WHILE ENO EXIT FALSE FOR FUNCTION FUNCTION_BLOCK GOTO IF INT LABEL MOD NIL NOT OF OK OR
    ORGANIZATION_BLOCK POINTER PROGRAM REAL REPEAT RETURN S5TIME STRING STRUCT THEN THIS TIME TIME_OF_DAY TIMER TO TOD
    TRUE TYPE UNTIL VAR VAR_IN_OUT VAR_INPUT VAR_OUTPUT VAR_TEMP VOID WHILE WORD XOR
    """
)
"""Reserved words of S7-SCL for S7-300 and S7-400, in any case: OK is its flag of a computation that went well."""
STANDARD = _words("F_EDGE F_TRIG R_EDGE R_TRIG RS SR CTU CTD S_CD S_CU S_CUD S_ODT S_ODTS S_OFFDT S_PEXT S_PULSE")
"""What tools call by a name of their own."""
AVOID = KEYWORDS | S7_SCL | STANDARD | _words("IN S1 P Q PT TON TOF TP BOOL INT TIME NEW")


@dataclass(frozen=True)
class Finding:
    """A place where a text breaks a rule."""

    rule: str
    block: str
    text: str


@dataclass(frozen=True)
class Rule:
    """One rule: its id, what it asks for, and how a block is checked."""

    id: str
    text: str
    check: Callable[[Block, Unit], Iterator[str]]


def lint(unit: Unit) -> tuple[Finding, ...]:
    """Every finding in every block."""
    return tuple(Finding(r.id, b.name, t) for b in unit.blocks for r in RULES for t in r.check(b, unit))


# --- walking -------------------------------------------------------------------------------------


def _flat(body: tuple[Statement, ...]) -> Iterator[Statement]:
    for s in body:
        yield s
        if isinstance(s, If):
            for _, then in s.arms:
                yield from _flat(then)
            yield from _flat(s.otherwise)


def _expressions(s: Statement) -> Iterator[Expression]:
    if isinstance(s, Assign):
        yield s.value
    elif isinstance(s, Call):
        for _, x in s.params:
            yield x
    else:
        for condition, _ in s.arms:
            yield condition


def _parts(x: Expression) -> Iterator[Expression]:
    yield x
    if isinstance(x, Not):
        yield from _parts(x.arg)
    elif isinstance(x, Nary):
        for a in x.args:
            yield from _parts(a)
    elif isinstance(x, Compare):
        yield from _parts(x.left)
        yield from _parts(x.right)


def _reads(s: Statement) -> Iterator[str]:
    for x in _expressions(s):
        for part in _parts(x):
            if isinstance(part, Name):
                yield part.parts[0]


def _declared(b: Block) -> dict[str, str]:
    return {d.name: d.type for d in (*b.inputs, *b.outputs, *b.locals)}


# --- rules ---------------------------------------------------------------------------------------


def _used(b: Block, unit: Unit) -> Iterator[str]:
    reads = {n for s in _flat(b.body) for n in _reads(s)}
    called = {s.instance for s in _flat(b.body) if isinstance(s, Call)}
    for d in b.inputs:
        if d.name not in reads:
            yield f"input {d.name} is never read"
    for d in b.locals:
        if d.name not in reads | called:
            yield f"{d.name} is never used"
    if b is not unit.blocks[-1] and all(d.type != b.name for c in unit.blocks for d in c.locals):
        yield "no block has an instance of it"
    for d in b.locals:
        if d.type not in ("BOOL", "INT") and [s.instance for s in b.body if isinstance(s, Call)].count(d.name) != 1:
            yield f"{d.name} is not called once"


def _written_before_read(b: Block, unit: Unit) -> Iterator[str]:
    keeps = {d.name for d in b.outputs if d.initial is not None}
    ready = {d.name for d in b.inputs} | keeps
    kinds = _declared(b)
    state = {x.name for x in unit.blocks if all(d.initial is not None for d in x.outputs)}
    ready |= {n for n, kind in kinds.items() if kind in state}  # its state of the last scan
    for s in b.body:
        for n in (n for x in _flat((s,)) for n in _reads(x)):
            if n not in ready:
                yield f"{n} is read before it is written"
        ready |= {str(t.target) for t in _flat((s,)) if isinstance(t, Assign)}
        ready |= {t.instance for t in _flat((s,)) if isinstance(t, Call)}


def _written_once(b: Block, unit: Unit) -> Iterator[str]:
    del unit
    inputs = {d.name for d in b.inputs}
    found: dict[str, int] = {}
    for s in b.body:
        branches = ((s,),) if not isinstance(s, If) else (*(then for _, then in s.arms), s.otherwise)
        names = {str(t.target) for part in branches for t in _flat(part) if isinstance(t, Assign)}
        for n in names:
            found[n] = found.get(n, 0) + 1
    for n, count in found.items():
        if n in inputs:
            yield f"input {n} is written"
        if count > 1:
            yield f"{n} is written {count} times"
    for d in b.outputs:
        if d.name not in found:
            yield f"output {d.name} is never written"


def _size(b: Block, unit: Unit) -> Iterator[str]:
    rows = rows_of(b)
    if rows > MOST_ROWS and b is not unit.blocks[-1]:
        yield f"{rows} rows"
    for s in _flat(b.body):
        for x in _expressions(s):
            if _depth(x) > MOST_DEPTH:
                yield f"an expression {_depth(x)} levels deep"
            widest = max((len(p.args) for p in _parts(x) if isinstance(p, Nary)), default=0)
            if widest > MOST_OPERANDS:
                yield f"{widest} operands"


def rows_of(b: Block) -> int:
    """Rows of a block as it is printed in the portable dialect."""
    return len(print_block(b))


def _depth(x: Expression) -> int:
    if isinstance(x, Not):
        return _depth(x.arg)
    if isinstance(x, Nary):
        return 1 + max(map(_depth, x.args))
    return 1 if isinstance(x, Compare) else 0


def _no_recursion(b: Block, unit: Unit) -> Iterator[str]:
    before = {x.name for x in unit.blocks[: unit.blocks.index(b)]}
    for d in b.locals:
        if d.type not in ("BOOL", "INT", "TON") and d.type not in before:
            yield f"{d.name} is an instance of {d.type}, which is not declared above"


def _types(b: Block, unit: Unit) -> Iterator[str]:
    kinds = _declared(b)
    blocks = {x.name: x for x in unit.blocks}

    def kind(x: Expression) -> str:
        if isinstance(x, Bool | Not | Nary | Compare):
            return "BOOL"
        if isinstance(x, Int):
            return "INT"
        if isinstance(x, Time):
            return "TIME"
        own = kinds.get(x.parts[0], "?")
        if len(x.parts) == 1:
            return own
        inner = {d.name: d.type for d in blocks[own].outputs} if own in blocks else {"Q": "BOOL"}
        return inner.get(x.parts[1], "?")

    for s in _flat(b.body):
        if isinstance(s, Assign) and kind(s.value) != kinds.get(str(s.target)):
            yield f"{s.target} gets a {kind(s.value)}"
        if isinstance(s, Call) and kinds.get(s.instance) in blocks:
            wanted = {d.name: d.type for d in blocks[kinds[s.instance]].inputs}
            for n, x in s.params:
                if kind(x) != wanted.get(n):
                    yield f"{s.instance}: parameter {n} gets a {kind(x)}"
            missing = sorted(set(wanted) - {n for n, _ in s.params})
            if missing:
                yield f"{s.instance}: {', '.join(missing)} not given"
        for x in _expressions(s):
            for part in _parts(x):
                inner = part.args if isinstance(part, Nary) else (part.arg,) if isinstance(part, Not) else ()
                if any(kind(a) != "BOOL" for a in inner):
                    yield f"{part} joins what is no truth value"
                if isinstance(part, Compare) and (kind(part.left), kind(part.right)) != ("INT", "INT"):
                    yield f"{part} compares what are no integers"
        if isinstance(s, Call):
            for n, x in s.params:
                if isinstance(x, Not | Nary | Compare):
                    yield f"{s.instance}: parameter {n} is an expression"


def _names(b: Block, unit: Unit) -> Iterator[str]:
    types = {x.name.upper() for x in unit.blocks}
    seen: set[str] = set()
    for n in (b.name, *_declared(b)):
        if len(n) > LONGEST and n != b.name:
            yield f"{n} has {len(n)} characters"
        if not re.fullmatch(r"[A-Za-z](?:_?[A-Za-z0-9])*", n):
            yield f"{n} is no portable name"
        if n.upper() in AVOID:
            yield f"{n} is a word that tools use"
        if n.upper() in seen:
            yield f"{n} is declared twice"
        if n != b.name and n.upper() in types:
            yield f"{n} bears the name of a block"
        seen.add(n.upper())


RULES: tuple[Rule, ...] = (
    Rule("ST-USED", "everything declared is used, every instance is called once (PLCopen CP2)", _used),
    Rule("ST-INIT", "every variable is written before it is read in a scan (PLCopen CP3)", _written_before_read),
    Rule("ST-SIZE", "blocks of few rows, shallow and narrow expressions (PLCopen CP9)", _size),
    Rule("ST-ONCE", "each output is written once in a scan, inputs never (PLCopen CP12)", _written_once),
    Rule("ST-CALL", "no block calls itself or what stands below it (PLCopen CP13)", _no_recursion),
    Rule("ST-TYPE", "no implicit conversion, no expression as parameter (PLCopen CP25)", _types),
    Rule("ST-NAME", "portable names, none that tools use, none twice (PLCopen N3, N6, N8, N9)", _names),
)
