"""A reader of the emitted Structured Text (IEC 61131-3), of the subset that may stand in it and of nothing else.

What it does not know it refuses: a statement that is skipped might change a meaning.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from typing import Any

from interlock.verify import Rejected, need

TOKEN = re.compile(
    r"""[ \t\r\n]+ | \(\*(?![ \t\r\n]*[@$\#~{%&])  # what begins so is obeyed by some tool
    (?:[\t\r\n\x20-\x27\x29\x2b-\x7e]              # what an editor shows otherwise than it is, is ASCII never
    | \*(?!\)) | \((?!\*))*\*\)                     # compilers differ on what begins a comment within one
    | (?P<time>T\#[0-9a-z_]+) | (?P<number>(?:0|[1-9][0-9]*)(?![0-9A-Za-z_]))
    | (?P<name>[A-Za-z_][A-Za-z0-9_]*) | (?P<sign>:=|[;:,().=])""",
    re.VERBOSE,
)
UNITS = {"d": 86_400_000, "h": 3_600_000, "m": 60_000, "s": 1000, "ms": 1}
STANDARD = frozenset({"BOOL", "INT", "TIME", "TON"})
"""Types that a text uses and must not define: a compiler would take its own block TON for the timer."""
KEYWORDS = frozenset(
    {
        "AND",
        "OR",
        "NOT",
        "XOR",
        "MOD",
        "TRUE",
        "FALSE",
        "VAR",
        "VAR_INPUT",
        "VAR_OUTPUT",
        "END_VAR",
        "VAR_IN_OUT",
        "TYPE",
        "STRUCT",
        "END_STRUCT",
        "END_TYPE",
        "RETAIN",
        "CONSTANT",
    }
    | {
        "AT",
        "FUNCTION_BLOCK",
        "END_FUNCTION_BLOCK",
        "IF",
        "THEN",
        "ELSE",
        "ELSIF",
        "END_IF",
        "CASE",
        "OF",
        "FOR",
        "WHILE",
    }
    | {"REPEAT", "RETURN", "EXIT"}
)

Expression = tuple[Any, ...]
"""`("name", (word, ...))`, `("bool", value)`, `("int", value)`, `("time", ms)`, `("not", x)`, `("and"|"or", [x, ...])`,
`("=", x, y)`."""


@dataclass
class Variable:
    """A declared variable: its type and initial value."""

    type: str
    initial: Expression | None


@dataclass
class Block:
    """A function block: what it is handed and its own variables in order, and what it does.  It has no parameters."""

    name: str
    parts: dict[str, dict[str, Variable]] = field(default_factory=lambda: {"VAR_IN_OUT": {}, "VAR": {}})
    body: list[tuple[Any, ...]] = field(default_factory=list)
    """`("assign", (word, ...), expression)`, `("call", instance, {argument: expression})`, or
    `("if", [(condition, [statement, ...]), ...])`, of which the last condition is TRUE, for ELSE."""

    @property
    def handed(self) -> dict[str, Variable]:
        """The structures that whoever calls it hands on (VAR_IN_OUT)."""
        return self.parts["VAR_IN_OUT"]

    @property
    def locals(self) -> dict[str, Variable]:
        """What it has of its own: structures, instances, timers (VAR)."""
        return self.parts["VAR"]


@dataclass
class Text:
    """What stands in a text: structures by name with their members, function blocks."""

    structures: dict[str, dict[str, Variable]]
    blocks: list[Block]


def milliseconds(text: str) -> int:
    """A duration such as T#1m30s."""
    found = re.fullmatch("T#" + "".join(f"([0-9]+{u})?" for u in UNITS), text)
    if found is None or not any(found.groups()):
        raise Rejected(f"malformed duration {text}")
    return sum(int(n.removesuffix(u)) * ms for n, (u, ms) in zip(found.groups("0"), UNITS.items(), strict=True))


class Reader:
    """The tokens of a text, and what they say."""

    def __init__(self, text: str) -> None:
        self.tokens: list[tuple[str, str, int]] = []
        at = line = 0
        while at < len(text):
            found = TOKEN.match(text, at)
            if found is None:
                raise Rejected(f"the text, line {line + 1}: {text[at : at + 20]!r} is not known here")
            if found.lastgroup is not None:
                self.tokens.append((found.lastgroup, found.group(), line + 1))
            line += found.group().count("\n")
            at = found.end()
        self.tokens.append(("end", "", line + 1))
        self.at = 0

    def word(self) -> str:
        """The next token's text."""
        return self.tokens[self.at][1]

    def take(self, *wanted: str) -> str:
        """The next token, which must be one of these."""
        kind, word, line = self.tokens[self.at]
        need(kind != "end" and word in wanted, f"the text, line {line}: {' or '.join(wanted)} expected, not {word!r}")
        self.at += 1
        return word

    def kind(self, wanted: str) -> str:
        """The next token, which must be of a kind; keywords are no names."""
        kind, word, line = self.tokens[self.at]
        ok = kind == wanted and (kind != "name" or word.upper() not in KEYWORDS)
        need(ok, f"the text, line {line}: a {wanted} expected, not {word!r}")
        self.at += 1
        return word

    def _own(self) -> str:
        """The name of what is defined here."""
        name = self.kind("name")
        need(name.upper() not in STANDARD, f"the text defines {name} itself")
        return name

    def unit(self) -> Text:
        """Structures, then function blocks, each with a name of its own."""
        found = Text({}, [])
        named: list[str] = []
        while self.tokens[self.at][0] != "end":
            if self.word() == "TYPE" and not found.blocks:
                name, members = self._structure()
                found.structures[name] = members
            else:
                found.blocks.append(self._block())
                name = found.blocks[-1].name
            named.append(name.upper())
        need(found.blocks != [] and len(set(named)) == len(named), "the text has no function block, or a name twice")
        return found

    def _structure(self) -> tuple[str, dict[str, Variable]]:
        """A structure and its members."""
        self.take("TYPE")
        name = self._own()
        self.take(":")
        self.take("STRUCT")
        members = self._declared(name, set(), "END_STRUCT")
        self.take(";")
        self.take("END_TYPE")
        return name, members

    def _block(self) -> Block:
        """One function block."""
        self.take("FUNCTION_BLOCK")
        block = Block(self._own())
        taken: set[str] = set()
        while self.word() in block.parts:
            part = self.take(*block.parts)
            block.parts[part] |= self._declared(block.name, taken, "END_VAR")
        while self.word() != "END_FUNCTION_BLOCK":
            block.body.append(self.statement())
        self.take("END_FUNCTION_BLOCK")
        return block

    def _declared(self, where: str, taken: set[str], end: str) -> dict[str, Variable]:
        """Declarations up to a word; none of a name that is taken, in small letters or large."""
        found: dict[str, Variable] = {}
        while self.word() != end:
            name = self._own()
            need(name.upper() not in taken, f"{where} declares {name} twice")
            taken.add(name.upper())
            self.take(":")
            type_ = self.kind("name")
            found[name] = Variable(type_, self._initial())
            self.take(";")
        self.take(end)
        return found

    def _initial(self) -> Expression | None:
        """The initial value of a declaration, if it has one."""
        if self.word() != ":=":
            return None
        self.take(":=")
        return self._primary()

    def statement(self) -> tuple[Any, ...]:
        """An assignment, a call, or IF with an ELSE."""
        if self.word() == "IF":
            return self._branch()
        name = self.kind("name")
        parts = [name]
        while self.word() == ".":
            self.take(".")
            parts.append(self.kind("name"))
        if self.take(":=", "(") == ":=":
            value = self.expression()
            self.take(";")
            return ("assign", tuple(parts), value)
        need(len(parts) == 1, f"{'.'.join(parts)} is called")
        given: dict[str, Expression] = {}
        while self.word() != ")":
            if given:
                self.take(",")
            argument = self.kind("name")
            self.take(":=")
            need(argument not in given, f"{argument} is given twice to {name}")
            given[argument] = self.expression()
        self.take(")")
        self.take(";")
        return ("call", name, given)

    def _branch(self) -> tuple[Any, ...]:
        """IF, any number of ELSIF, and ELSE, each with at least one statement."""
        arms: list[tuple[Expression, list[tuple[Any, ...]]]] = []
        end = ""
        while end != "END_IF":
            end = self.take("ELSIF", "ELSE") if arms else self.take("IF")
            condition: Expression = ("bool", True)
            if end != "ELSE":
                condition = self.expression()
                self.take("THEN")
            body = []
            while self.word() not in ("ELSIF", "ELSE", "END_IF"):
                body.append(self.statement())
            need(body != [], f"the text, line {self.tokens[self.at][2]}: nothing is done where a condition holds")
            arms.append((condition, body))
            if end == "ELSE":
                end = self.take("END_IF")
        self.take(";")
        return ("if", arms)

    def expression(self) -> Expression:
        """OR binds least."""
        return self._joined("OR", lambda: self._joined("AND", self._comparison))

    def _joined(self, word: str, inner: Any) -> Expression:
        """Operands with one operator between them."""
        found = [inner()]
        while self.word() == word:
            self.take(word)
            found.append(inner())
        return found[0] if len(found) == 1 else (word.lower(), found)

    def _comparison(self) -> Expression:
        """A comparison binds more than AND."""
        left = self._negation()
        if self.word() == "=":
            self.take("=")
            return ("=", left, self._negation())
        return left

    def _negation(self) -> Expression:
        """NOT binds more than a comparison."""
        if self.word() == "NOT":
            self.take("NOT")
            return ("not", self._negation())
        return self._primary()

    def _primary(self) -> Expression:
        """A name, a constant, or an expression in brackets."""
        kind, word, _ = self.tokens[self.at]
        if word == "(":
            self.take("(")
            inner = self.expression()
            self.take(")")
            return inner
        if word in ("TRUE", "FALSE"):
            return ("bool", self.take("TRUE", "FALSE") == "TRUE")
        if kind == "number":
            return ("int", int(self.kind("number")))
        if kind == "time":
            return ("time", milliseconds(self.kind("time")))
        parts = [self.kind("name")]
        while self.word() == ".":
            self.take(".")
            parts.append(self.kind("name"))
        return ("name", tuple(parts))
