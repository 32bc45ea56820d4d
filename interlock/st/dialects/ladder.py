"""Ladder in PLCopen XML (TC6 2.01): a rung for each equation, timer and bit of state; calls and words in ST.

Before it is drawn an equation is brought into a form that a rung has: contacts in a row, or rows beside each other, of
variables alone; what is nested deeper, a comparison, or a negated bracket gets a rung and a variable of its own.  A
constant is a coil at the rail, negated for FALSE.  Rungs stand one below the other in the order of the text, and the
reader takes them in this order only, each at least a row below the one before: Beremiz carries out coils that are less
than 10 apart from left to right, whatever their order.
"""

from __future__ import annotations

import re
import xml.etree.ElementTree as ElementTree
from collections.abc import Iterator, Sequence
from dataclasses import replace
from xml.sax.saxutils import escape

from interlock.dataclass import dataclass
from interlock.st.ast import (
    Assign,
    Block,
    Bool,
    Call,
    Compare,
    Declaration,
    Expression,
    Int,
    Name,
    Nary,
    Not,
    Statement,
    Time,
)
from interlock.st.dialects.dialect import Dialect, Unsupported
from interlock.st.dialects.plcopen import XHTML, PlcOpen, rules
from interlock.st.dialects.strict import Rule
from interlock.st.parser import NotInSubset, parse_block
from interlock.st.printer import print_expression
from interlock.st.structures import structured

_DRAWN = re.compile(r"IL_\w+_[BTSY][0-9]+", re.ASCII)
"""Blocks of equations, timers, state, outputs."""
WIDE, HIGH = 120, 40
"""From contact to contact, from row to row."""
SIDE = 60
"""Of a block."""
_OUTPUTS = {"EQ": ("ENO", "OUT"), "TON": ("Q", "ET")}
"""Of the blocks that are drawn, from above."""
_NUMBER = re.compile("[0-9]+")
_POINT = "connectionPointIn"
_RULES = {
    "body": Rule(children="ST LD"),
    "LD": Rule(children="leftPowerRail* contact* coil* block* inVariable* rightPowerRail* comment*"),
    "leftPowerRail": Rule("localId width height", "position connectionPointOut*"),
    "rightPowerRail": Rule("localId width height", f"position {_POINT}*"),
    "contact": Rule("localId negated width height", f"position {_POINT} connectionPointOut variable documentation"),
    "coil": Rule("localId negated width height", f"position {_POINT} connectionPointOut variable documentation"),
    "block": Rule(
        "localId typeName instanceName width height", "position inputVariables inOutVariables outputVariables"
    ),
    "inVariable": Rule("localId width height negated", "position connectionPointOut expression"),
    "comment": Rule("localId width height", "position content"),
    "position": Rule("x y"),
    _POINT: Rule(children="connection*"),
    "connection": Rule("refLocalId formalParameter", "position*"),
    "connectionPointOut": Rule("formalParameter", "relPosition"),
    "relPosition": Rule("x y"),
    "inputVariables": Rule(children="variable*"),
    "outputVariables": Rule(children="variable*"),
    "inOutVariables": Rule(),
    "variable": Rule(
        "name address formalParameter", f"type initialValue documentation {_POINT} connectionPointOut", True
    ),
    "expression": Rule(text=True),
    "content": Rule(children="p"),
}


# --- the form that a rung has --------------------------------------------------------------------


def rungs(b: Block) -> Block:
    """A block whose assignments are rungs, with further variables of its own."""
    made = _Rungs(b)
    for s in b.body:
        made.statement(s)
    return replace(b, locals=tuple(made.locals), body=tuple(made.body))


class _Rungs:
    """The rungs of a block as they are found."""

    def __init__(self, b: Block) -> None:
        self.name, self.locals, self.body = b.name, list(b.locals), list[Statement]()
        self.count = sum(d.type == "BOOL" for d in b.locals)

    def statement(self, s: Statement) -> None:
        """An assignment as a rung, after those that it needs."""
        if isinstance(s, Assign) and isinstance(s.value, Nary):
            notes = s.value.notes or ("",) * len(s.value.args)
            inner = self._row if s.value.op == "OR" else self._literal
            if s.value.op not in ("AND", "OR"):
                raise Unsupported(f"{self.name}: a rung of {s.value.op}")
            args = tuple(inner(a) for a in s.value.args)
            self.body.append(replace(s, value=Nary(s.value.op, args, notes)))
        elif isinstance(s, Assign) and not isinstance(s.value, Bool | Compare):
            self.body.append(replace(s, value=self._literal(s.value)))
        else:
            self.body.append(s)

    def _row(self, x: Expression) -> Expression:
        """Contacts in a row."""
        if isinstance(x, Nary) and x.op == "AND":
            return Nary("AND", tuple(self._literal(a) for a in x.args))
        return self._literal(x)

    def _literal(self, x: Expression) -> Expression:
        """A contact."""
        inner = x.arg if isinstance(x, Not) else x
        if not isinstance(inner, Name):
            self.count += 1
            own = Name((f"T_{self.count}",))
            self.locals.append(Declaration(own.parts[0], "BOOL"))
            self.statement(Assign(own, inner))
            inner = own
        return Not(inner) if isinstance(x, Not) else inner


# --- drawing -------------------------------------------------------------------------------------


class _Sheet:
    """The elements of a body, each with an id of its own."""

    def __init__(self) -> None:
        self.lines: list[str] = []
        self.last, self.y = 0, HIGH

    def body(self, b: Block) -> list[str]:
        """The rungs of a block."""
        todo = list(b.body)
        while todo:
            s = todo.pop(0)
            if isinstance(s, Call):
                after = todo.pop(0)
                assert isinstance(after, Assign) and after.value == Name((s.instance, "Q"))
                self._timer(s, after)
            else:
                assert isinstance(s, Assign)
                self._rung(s)
        return self.lines

    def _add(self, tag: str, x: int, inner: str, attributes: str = "", y: int | None = None, size: str = "") -> int:
        self.last += 1
        where = f'<position x="{x}" y="{self.y if y is None else y}"/>'
        size = size or 'width="20" height="20"'
        self.lines.append(f'          <{tag} localId="{self.last}" {size}{attributes}>{where}{inner}</{tag}>')
        return self.last

    def _begin(self, note: str, rows: int) -> int:
        if note:
            text = f"<content><xhtml:p>{escape(note)}</xhtml:p></content>"
            self._add("comment", 0, text, size='width="800" height="20"')
            self.y += HIGH
        size = f'width="10" height="{HIGH * rows}"'
        return self._add("leftPowerRail", 0, '<connectionPointOut formalParameter=""/>', size=size)

    def _contact(self, x: Expression, column: int, before: int, note: str, y: int) -> int:
        inner = x.arg if isinstance(x, Not) else x
        assert isinstance(inner, Name)
        negated = ' negated="true"' if isinstance(x, Not) else ""
        told = f"<documentation><xhtml:p>{escape(note)}</xhtml:p></documentation>" if note else ""
        text = f"{_joined([(before, '')])}<connectionPointOut/><variable>{inner}</variable>{told}"
        return self._add("contact", column * WIDE, text, negated, y)

    def _end(self, target: Name, column: int, ends: Sequence[tuple[int, str]], negated: bool = False) -> None:
        sign = ' negated="true"' if negated else ""
        line = ""
        if ends[0][1]:  # from a block's output
            out = SIDE // 3 * (2 if ends[0][1] == "OUT" else 1)
            corners = ((column * WIDE, self.y), (2 * WIDE + SIDE, self.y + out))
            line = "".join(f'<position x="{x}" y="{y}"/>' for x, y in corners)
        text = f"{_joined(ends, line)}<connectionPointOut/><variable>{target}</variable>"
        coil = self._add("coil", column * WIDE, text, sign)
        self._add("rightPowerRail", (column + 1) * WIDE, _joined([(coil, "")]), size='width="10" height="40"')

    def _rung(self, s: Assign) -> None:
        value = s.value
        if isinstance(value, Compare):
            return self._compare(s, value)
        rows: tuple[Expression, ...] = value.args if isinstance(value, Nary) and value.op == "OR" else (value,)
        notes = value.notes if isinstance(value, Nary) and value.op == "OR" and value.notes else ("",) * len(rows)
        rail = self._begin(s.note, len(rows))
        if isinstance(value, Bool):
            self._end(s.target, 1, [(rail, "")], not value.value)
            self.y += HIGH
            return None
        ends, widest, top = list[tuple[int, str]](), 1, self.y
        for k, (row, note) in enumerate(zip(rows, notes, strict=True)):
            contacts = row.args if isinstance(row, Nary) else (row,)
            told = row.notes if isinstance(row, Nary) and row.notes else (note, *("",) * (len(contacts) - 1))
            at = rail
            for column, (x, text) in enumerate(zip(contacts, told, strict=True), 1):
                at = self._contact(x, column, at, text, top + k * HIGH)
            ends.append((at, ""))
            widest = max(widest, len(contacts))
        self._end(s.target, widest + 1, ends)
        self.y += HIGH * len(rows)
        return None

    def _given(self, x: Expression, y: int) -> int:
        text = f"<connectionPointOut/><expression>{print_expression(x)}</expression>"
        return self._add("inVariable", WIDE, text, y=y)

    def _compare(self, s: Assign, x: Compare) -> None:
        if x.op != "=":
            raise Unsupported(f"a comparison by {x.op}")
        rail = self._begin(s.note, 2)
        left, right = self._given(x.left, self.y), self._given(x.right, self.y + HIGH)
        block = self._block("EQ", "", {"EN": rail, "IN1": left, "IN2": right})
        self._end(s.target, 3, [(block, "OUT")])
        self.y += 2 * HIGH

    def _timer(self, call: Call, s: Assign) -> None:
        given = dict(call.params)
        rail = self._begin(call.note, 2)
        contact = self._contact(given["IN"], 1, rail, "", self.y)
        inputs = {"IN": contact, "PT": self._given(given["PT"], self.y + HIGH)}
        block = self._block("TON", f' instanceName="{call.instance}"', inputs)
        self._end(s.target, 3, [(block, "Q")])
        self.y += 2 * HIGH

    def _block(self, kind: str, instance: str, inputs: dict[str, int]) -> int:
        given = "".join(f'<variable formalParameter="{n}">{_joined([(x, "")])}</variable>' for n, x in inputs.items())
        told = "".join(
            f'<variable formalParameter="{n}"><connectionPointOut><relPosition x="{SIDE}" y="{k * SIDE // 3}"/>'
            "</connectionPointOut></variable>"
            for k, n in enumerate(_OUTPUTS[kind], 1)
        )
        text = f"<inputVariables>{given}</inputVariables><inOutVariables/><outputVariables>{told}</outputVariables>"
        return self._add(
            "block", 2 * WIDE, text, f' typeName="{kind}"{instance}', size=f'width="{SIDE}" height="{SIDE}"'
        )


def _joined(ends: Sequence[tuple[int, str]], line: str = "") -> str:
    """The connections to elements, or to an output of a block; `line`: the corners of the line."""
    found = []
    for n, out in ends:
        output = f' formalParameter="{out}"' if out else ""
        found.append(f'<connection refLocalId="{n}"{output}>{line}</connection>')
    return f"<{_POINT}>{''.join(found)}</{_POINT}>"


# --- reading -------------------------------------------------------------------------------------


@dataclass(frozen=True)
class _Element:
    """An element of a body: what leads to it, by its inputs' names.

    at: x and y.  outputs: those of a block, and where they are.  end: where the line to it comes from, if it is drawn.
    """

    tag: str
    at: tuple[int, int]
    inputs: dict[str, tuple[tuple[str, str], ...]]
    outputs: tuple[tuple[str, tuple[int, int]], ...]
    end: tuple[int, int] | None
    negated: bool
    variable: str
    kind: str
    instance: str


class _Reader:
    """The elements of a body as statements; each is used once."""

    def __init__(self, space: str, ladder: ElementTree.Element, name: str) -> None:
        self.space, self.name = space, name
        self.found: dict[str, _Element] = {}
        self.used: set[str] = set()
        for x in ladder:
            number = x.get("localId", "")
            if not number.isdigit() or number in self.found:
                raise self._bad(f"an element without an id of its own: {number!r}")
            self.found[number] = self._element(x)

    def _bad(self, what: str) -> NotInSubset:
        return NotInSubset(f"{self.name}: {what}")

    def _path(self, *parts: str) -> str:
        return "/".join(f"{{{self.space}}}{p}" for p in parts)

    def _element(self, x: ElementTree.Element) -> _Element:
        tag = x.tag.rsplit("}", 1)[1]
        at = self._place(x.find(self._path("position")))
        if x.get("negated", "false") not in ("true", "false"):
            raise self._bad(f"a {tag} with another sign")
        inputs = {"": self._connections(x)}
        for v in x.findall(self._path("inputVariables", "variable")):
            own = v.get("formalParameter", "")
            if own in inputs or set(v.attrib) != {"formalParameter"}:
                raise self._bad(f"an input {own!r} twice, or with a sign of its own")
            inputs[own] = self._connections(v)
        variable = x.findtext(self._path("variable")) or x.findtext(self._path("expression")) or ""
        kind, instance = x.get("typeName", ""), x.get("instanceName", "")
        corners = x.findall(self._path(_POINT, "connection", "position"))
        end = self._place(corners[-1]) if corners else None
        negated = x.get("negated") == "true"
        return _Element(tag, at, inputs, self._outputs(x, at), end, negated, variable, kind, instance)

    def _outputs(self, x: ElementTree.Element, at: tuple[int, int]) -> tuple[tuple[str, tuple[int, int]], ...]:
        """The outputs of a block, from above, and where they are."""
        found = []
        for v in x.findall(self._path("outputVariables", "variable")):
            if set(v.attrib) != {"formalParameter"}:
                raise self._bad("an output with a sign of its own")
            right, below = self._place(v.find(self._path("connectionPointOut", "relPosition")))
            found.append((v.get("formalParameter", ""), (at[0] + right, at[1] + below)))
        return tuple(found)

    def _place(self, x: ElementTree.Element | None) -> tuple[int, int]:
        """The x and y that an element says."""
        said = (x.get("x", ""), x.get("y", "")) if x is not None else ("", "")
        if not all(_NUMBER.fullmatch(n) for n in said):
            raise self._bad(f"no place is said by x {said[0]!r} and y {said[1]!r}")
        return int(said[0]), int(said[1])

    def _connections(self, x: ElementTree.Element) -> tuple[tuple[str, str], ...]:
        found = x.findall(self._path(_POINT, "connection"))
        return tuple((c.get("refLocalId", ""), c.get("formalParameter", "")) for c in found)

    def body(self) -> Iterator[Statement]:
        """A rung for each coil, from above."""
        above = -HIGH
        for number, x in self.found.items():
            if x.tag == "comment":
                self.used.add(number)
            elif x.tag == "coil":
                if x.at[1] < above + HIGH:
                    raise self._bad(f"the rung of {x.variable} does not stand a row below the one before")
                above = x.at[1]
                self.used.add(number)
                yield from self._rung(x)
            elif x.tag == "rightPowerRail":
                ends = [self.found[n].tag for n, _ in x.inputs[""] if n in self.found]
                if ends != ["coil"]:
                    raise self._bad("a right rail that does not stand behind one coil")
                self.used.add(number)
        if left := sorted(set(self.found) - self.used):
            raise self._bad(f"{self.found[left[0]].tag} {left[0]} belongs to no rung")

    def _take(self, number: str, *tags: str) -> _Element:
        x = self.found.get(number)
        if x is None or x.tag not in tags or (number in self.used and x.tag != "leftPowerRail"):
            raise self._bad(f"{number} is no {' or '.join(tags)}, or stands in two rungs")
        self.used.add(number)
        return x

    def _rung(self, coil: _Element) -> Iterator[Statement]:
        target, ends = self._name(coil.variable), coil.inputs[""]
        first = self.found.get(ends[0][0]) if len(ends) == 1 else None
        if first is not None and first.tag == "block" and not coil.negated:
            block = self._take(ends[0][0], "block")
            if coil.end is None or coil.end != dict(block.outputs).get(ends[0][1]):
                raise self._bad(f"the line to {target} does not come from the output {ends[0][1]!r}")
            yield from self._block(block, ends[0][1], target)
        elif first is not None and first.tag == "leftPowerRail":
            self._take(ends[0][0], "leftPowerRail")
            yield Assign(target, Bool(not coil.negated))
        else:
            rows = [self._row(n) for n, out in ends if not out]
            if coil.negated or len(rows) != len(ends) or not rows:
                raise self._bad(f"a coil {target} that is negated, or at nothing")
            yield Assign(target, rows[0] if len(rows) == 1 else Nary("OR", tuple(rows)))

    def _row(self, number: str) -> Expression:
        """Contacts from the coil back to the rail."""
        found: list[Expression] = []
        while True:
            x = self._take(number, "contact") if found == [] else self._take(number, "contact", "leftPowerRail")
            if x.tag == "leftPowerRail":
                break
            own = self._name(x.variable)
            found.append(Not(own) if x.negated else own)
            if len(x.inputs[""]) != 1 or x.inputs[""][0][1]:
                raise self._bad(f"a contact {own} behind several others")
            number = x.inputs[""][0][0]
        found.reverse()
        return found[0] if len(found) == 1 else Nary("AND", tuple(found))

    def _block(self, b: _Element, output: str, target: Name) -> Iterator[Statement]:
        heights = [y for _, (_, y) in b.outputs]
        if tuple(n for n, _ in b.outputs) != _OUTPUTS.get(b.kind) or heights != sorted(set(heights)):
            raise self._bad(f"a block {b.kind} with other outputs, or not from above")
        ends = {n: x[0] for n, x in b.inputs.items() if len(x) == 1 and not x[0][1]}
        if b.kind == "TON" and output == "Q" and set(ends) == {"IN", "PT"}:
            timer = str(self._name(b.instance))
            on, preset = self._row(ends["IN"][0]), self._take(ends["PT"][0], "inVariable")
            given = re.fullmatch(r"T#([0-9]+)(m?s)", preset.variable)
            if not isinstance(on, Name) or given is None or preset.negated:
                raise self._bad(f"the timer {timer} does not wait for one variable, or for no time")
            ms = int(given[1]) * (1 if given[2] == "ms" else 1000)
            yield Call(timer, (("IN", on), ("PT", Time(ms))))
            yield Assign(target, Name((timer, "Q")))
        elif b.kind == "EQ" and output == "OUT" and set(ends) == {"EN", "IN1", "IN2"} and not b.instance:
            left, right = (self._take(ends[n][0], "inVariable") for n in ("IN1", "IN2"))
            if left.negated or right.negated or not _NUMBER.fullmatch(right.variable):
                raise self._bad(f"a comparison of {left.variable} with {right.variable}")
            self._take(ends["EN"][0], "leftPowerRail")
            yield Assign(target, Compare("=", self._name(left.variable), Int(int(right.variable))))
        else:
            raise self._bad(f"a block {b.kind} that is not written")

    def _name(self, text: str) -> Name:
        if not re.fullmatch(r"[A-Za-z_]\w*(\.[A-Za-z_]\w*)?", text, re.ASCII) or text.upper() in ("TRUE", "FALSE"):
            raise self._bad(f"{text!r} is no variable")
        return Name(tuple(text.split(".")))


class Ladder(PlcOpen):
    """The project file whose equations are drawn."""

    def __init__(self) -> None:
        super().__init__("0201", False)
        self.rules = rules(self.space, self.shown, _RULES)
        xhtml, own = f"{{{XHTML}}}p", f"{{{self.space}}}content"
        self.rules[own] = replace(self.rules[own], children=xhtml)

    def _pou(self, b: Block) -> list[str]:
        return super()._pou(rungs(b) if _DRAWN.fullmatch(b.name) else b)

    def _body(self, b: Block) -> list[str]:
        if not _DRAWN.fullmatch(b.name):
            return super()._body(b)
        return ["        <body><LD>", *_Sheet().body(b), "        </LD></body>"]

    def _read_body(self, pou: ElementTree.Element, name: str, declared: str, kind: str) -> Block:
        ladder = pou.find(self._path("body/LD"))
        if ladder is None:
            return super()._read_body(pou, name, declared, kind)
        if pou.find(self._path("body/ST")) is not None or not _DRAWN.fullmatch(name):
            raise NotInSubset(f"{name} is no block that is drawn, or also written")
        return replace(parse_block(name, declared, "", kind), body=tuple(_Reader(self.space, ladder, name).body()))


_LADDER = Ladder()

DIALECT = Dialect("ladder", "PLCopen XML TC6 2.01, equations in ladder", _LADDER.write, _LADDER.read, form=structured)
