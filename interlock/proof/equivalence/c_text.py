"""What the generated C computes, read from its text: parsed by pycparser, then walked over with formulas for values.

pycparser (the extra `c99`) reads C99 but neither comments nor directives.  Comments are taken out here; of directives
the file may have those that are emitted, at their places, and nothing that C's preprocessor would replace may follow.
What all files have in common must have the syntax tree of what the emitter calls fixed; tables, structures, and every
statement of the functions are read one by one.  A construct of any other kind is refused, and so is an object that is
written twice in a call: who looks in between would see what is compared with nothing.

**Theorem.**  The walk gives each variable the formula of the value that the statements, taken in order, leave in it; a
construct whose meaning it does not know is refused: so what is equal to the controller as a formula is equal in every
call.  (Symbolic execution of a text without branches of unknown length: King, 1976; meaning of C: ISO/IEC 9899:1999.)
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any

from interlock.emit.c99.runtime import Fixed, fixed, literal
from interlock.emit.python.runtime import route_numbers
from interlock.logic.controller import Controller, Input
from interlock.logic.expr import FALSE, TRUE, Expr, conj, disj, eq, neg, var
from interlock.logic.names import computed, spelled
from interlock.logic.words import LAST, UNKNOWN
from interlock.proof.equivalence.structured_text import Difference, Scan, Translation, compare_scan, wires, words
from interlock.st.meaning import Constant, Symbol, Symbols, Term


class BadC(Exception):
    """The text is not a C runtime as it is emitted."""


def compare_c(controller: Controller, files: Mapping[str, str]) -> Translation:
    """Compare a C runtime, the file and its header, with its controller; needs the extra `c99`."""
    from pycparser.c_parser import ParseError

    try:
        return compare_scan(controller, _Reader(controller, files).scan())
    except (BadC, ParseError, RecursionError) as error:
        return Translation(0, (Difference("c99", f"cannot be read: {error}"),))


_PIECE = re.compile(r'"(?:[^"\\\n]|\\[0-7]{3})*"|/\*.*?\*/|[\\\'"%?]|/[/*]|<:|:>', re.DOTALL)
_REPLACED = re.compile(r"(U?INT\w*|SIZE|PTRDIFF|WCHAR|WINT|SIG_ATOMIC)_(MAX|MIN|C)|_\w*|errno|asm|unix|linux")
LONGEST_MS = 2**32 - 1  # uint32_t
_FUNCTION = re.compile(r"(inputs|part|timers|words)_[0-9]{3,}|report")  # a name of C's library is none
_OWN_TYPES = (
    "typedef _Bool bool; typedef unsigned char uint8_t; typedef signed short int16_t; typedef unsigned int uint32_t;"
)


def _uncommented(text: str) -> str:
    """Without comments; what the preprocessor would take for something else than it looks like is refused.

    A backslash in a comment is: compilers join lines even where blanks follow it, so `*\\ ` and `/` end a comment.
    """

    def put(found: re.Match[str]) -> str:
        piece = found[0]
        if piece.startswith("/*") and len(piece) > 3 and "\\" not in piece:
            return " " + "\n" * piece.count("\n")
        if piece.startswith('"') and len(piece) > 1:
            return piece
        raise BadC(f"{piece[:40]!r} stands outside strings and comments, or a backslash in a comment")

    if not text.isascii() or any(ch < " " and ch != "\n" for ch in text):
        raise BadC("a character that is no plain text")
    if "\\\n" in text or "??" in text:
        raise BadC("a line that is continued, or a trigraph")
    return _PIECE.sub(put, text)


def _body(text: str, pattern: str, file: str) -> str:
    """What stands between the directives that a file must have."""
    found = re.fullmatch(pattern, _uncommented(text), re.DOTALL)
    if found is None or "#" in found[2]:
        raise BadC(f"{file} has other directives than are emitted")
    return "\n" * found[1].count("\n") + found[2]


def _tree(node: Any) -> object:
    """A syntax tree as a value that can be compared."""
    return (
        type(node).__name__,
        *(getattr(node, a) for a in node.attr_names),
        *((n, _tree(x)) for n, x in node.children()),
    )


class _Reader:
    def __init__(self, controller: Controller, files: Mapping[str, str]) -> None:
        self.controller = controller
        self.fixed: Fixed = fixed(controller)
        self.p = self.fixed.prefix
        self.algebra = Symbols(known=wires(controller), words=words(controller))
        self.told = (f"{self.p}_said", "reason")
        self.values: dict[str, Term] = {}
        self.functions: dict[str, Any] = {}
        self.called: set[str] = set()
        self.written: set[str] = set()
        self.structures: dict[str, dict[str, str]] = {}
        self.tables: dict[str, tuple[object, tuple[tuple[str, ...], ...]]] = {}
        name = self.p.removeprefix("IL_")
        if set(files) != {f"{name}.h", f"{name}.c"}:
            raise BadC(f"not the files {name}.h and {name}.c")
        guard = re.escape(self.fixed.guard)
        include = r"#include <stdbool\.h>\n#include <stdint\.h>\n"
        head = _body(
            files[f"{name}.h"], rf"(\s*#ifndef {guard}\n#define {guard}\n\s*{include})(.*)#endif\s*", f"{name}.h"
        )
        source = _body(files[f"{name}.c"], rf'(\s*#include "{re.escape(name)}\.h"\n)(.*)', f"{name}.c")
        names = set(re.findall(r"[A-Za-z_]\w*", head + source))
        if replaced := sorted(w for w in names if _REPLACED.fullmatch(w) or w == self.fixed.guard):
            raise BadC(f"{replaced[0]} is a name that C or its headers give another meaning")
        self._sort(_parsed(f'# 1 "{name}.h"\n{head}\n# 1 "{name}.c"\n{source}'))

    # --- the parts of the file -------------------------------------------------------------------

    def _sort(self, parts: list[Any]) -> None:
        """Structures, tables and functions by name; what is left must be the fixed parts."""
        own = {f"{self.p}_{x}" for x in ("inputs", "read", "outputs", "state", "wires", "delays", "words", "reasons")}
        left: list[object] = []
        for x in parts:
            kind = type(x).__name__
            if kind == "Typedef" and x.name in own and x.name not in self.structures:
                self.structures[x.name] = self._members(x)
            elif kind == "Decl" and x.init is not None and type(x.type).__name__ == "ArrayDecl":
                self._table(x)
            elif kind == "FuncDef" and x.decl.name != "on_delay":
                emitted = _FUNCTION.fullmatch(x.decl.name) or x.decl.name in (f"{self.p}_init", f"{self.p}_scan")
                if not emitted or x.decl.name in self.functions:
                    raise self._bad(x, f"{x.decl.name} is no function that is emitted, or is defined twice")
                self.functions[x.decl.name] = x
            else:
                left.append(_tree(x))
        f = self.fixed
        stubs = " ".join(f"typedef int {x};" for x in sorted(own))
        text = f"{stubs}\n{f.declared}{f.delay}{f.objects}{f.on_delay}"
        wanted = [_tree(x) for x in _parsed(_uncommented(text))[len(own) :]]
        if left != wanted:
            raise BadC("the fixed parts are changed")
        self._declared()
        self._tabled()

    def _declared(self) -> None:
        """Structures have the controller's names and no others."""
        c = self.controller
        wanted = {
            "inputs": {i.name: "int16_t" if i.size else "uint8_t" for i in c.inputs},
            "read": {i.name: "int16_t" if i.size else "bool" for i in c.inputs},
            "outputs": {o.name: "bool" for o in c.outputs},
            "state": {s.name: "bool" for s in c.state},
            "wires": {s.name: "bool" for s in c.steps},
            "delays": {t.name: f"{self.p}_delay" for t in c.timers},
        }
        shown = set(c.words.routes.values())
        told = {
            "words": {w.name: "int16_t" for w in c.words.words if w.name in shown},
            "reasons": {w.name: "int16_t" for w in c.words.words if w.name not in shown},
        }
        wanted |= {name: members for name, members in told.items() if members}
        if set(self.structures) != {f"{self.p}_{name}" for name in wanted}:
            raise BadC("not the structures that are emitted")
        for name, members in wanted.items():
            if self.structures.get(f"{self.p}_{name}") != members:
                raise BadC(f"the structure of {name} is another")

    def _members(self, x: Any) -> dict[str, str]:
        inner = x.type.type
        if type(x.type).__name__ != "TypeDecl" or type(inner).__name__ != "Struct" or inner.name or x.type.quals:
            raise self._bad(x, "no plain structure")
        found: dict[str, str] = {}
        for d in inner.decls or ():
            kind: list[str] = getattr(getattr(d.type, "type", None), "names", [])
            plain = type(d.type).__name__ == "TypeDecl" and not (d.quals or d.storage or d.bitsize or d.align)
            if not plain or len(kind) != 1 or d.name in found:
                raise self._bad(d, "no plain member of its own name")
            found[d.name] = kind[0]
        return found

    def _table(self, x: Any) -> None:
        if x.name in self.tables or type(x.init).__name__ != "InitList":
            raise self._bad(x, "a table twice, or without a list")
        rows = []
        for row in x.init.exprs:
            if type(row).__name__ != "InitList":
                raise self._bad(x, "a row that is no list")
            rows.append(tuple(self._cell(cell) for cell in row.exprs))
        x.init = None
        self.tables[x.name] = (_tree(x), tuple(rows))

    def _cell(self, x: Any) -> str:
        kind = type(x).__name__
        if kind == "Constant":
            return str(x.value)
        if kind == "UnaryOp" and x.op == "&":
            return "&" + self._place(x.expr)
        raise self._bad(x, "no literal and no address")

    def _tabled(self) -> None:
        """The tables name what they say."""
        c, p, n = self.controller, self.p, self.fixed.counts
        wanted: dict[str, tuple[str, list[tuple[str, ...]]]] = {
            "input_bits": ("input_bit", [(f'"{i.name}"', f"&{p}_in.{i.name}") for i in c.inputs if not i.size]),
            "input_numbers": (
                "input_number",
                [(f'"{i.name}"', f"&{p}_in.{i.name}", str(i.size)) for i in c.inputs if i.size],
            ),
            "output_bits": ("bit", [(f'"{o.name}"', f"&{p}_out.{o.name}") for o in c.outputs]),
            "state_bits": ("bit", [(f'"{s.name}"', f"&now.{s.name}") for s in c.state]),
            "routes": ("route", self._routes()),
        }
        if set(self.tables) != {f"{p}_{name}" for name in wanted}:
            raise BadC("not the tables that are emitted")
        for name, (kind, rows) in wanted.items():
            stub = f"typedef int {p}_{kind}; const {p}_{kind} {p}_{name}[{n[name]}];"
            expected: tuple[tuple[str, ...], ...] = tuple(rows)
            if self.tables[f"{p}_{name}"] != (_tree(_parsed(stub)[1]), expected):
                raise BadC(f"table {name} is another")

    def _routes(self) -> list[tuple[str, ...]]:
        """Each route's name with its number, and its word."""
        c = self.controller
        word = {number: (f"&{self.p}_said.{name}",) for number, name in c.words.routes.items()}
        return [(literal(r), str(number), *word.get(number, ())) for r, number in route_numbers(c).items()]

    # --- what it computes ------------------------------------------------------------------------

    def scan(self) -> Scan:
        """Initial state, and one scan from any state and any memory of wires and outputs."""
        c, p = self.controller, self.p
        self._call(f"{p}_init", self._statements(f"{p}_init"))
        base: dict[str, Term] = {s.name: self.values.get(f"now.{s.name}", Constant(-1)) for s in c.state}
        for i in c.inputs:
            given = self.values.get(f"{p}_in.{i.name}")
            if given != Constant(i.restrictive):
                raise BadC(f"{i.name} does not begin with its restrictive value")
        for o in c.outputs:
            if self.values.get(f"{p}_out.{o.name}") is not (TRUE if o.restrictive else FALSE):
                raise BadC(f"{o.name} does not begin with its restrictive value")
        said = {n: f"{p}_said.{n}" for n in c.words.routes.values()}
        if wrong := [n for n, place in said.items() if self.values.get(place) != Constant(UNKNOWN)]:
            raise BadC(f"{wrong[0]} does not begin with {UNKNOWN}: nothing is known")
        stopped = {f"delay.{t.name}.{x}" for t in c.timers for x in ("runs", "elapsed_ms")}
        if any(self.values.get(x) not in (FALSE, Constant(0)) for x in stopped) or self.values.get("begun") is not TRUE:
            raise BadC("a timer is not stopped at the beginning, or the beginning is not noted")
        self.values = {f"now.{s.name}": var(s.name) for s in c.state}
        self.called, self.written = set(), set()
        name = f"{p}_scan"
        statements = self._begun(self._statements(name), self.fixed.begin)
        statements = self._begun(self._copied(statements), self.fixed.late)  # from here on the copy alone is read
        self._call(name, statements)
        if self.called != set(self.functions) - {f"{p}_init"}:
            raise BadC("a function that no scan calls")
        after: dict[str, Term] = {s.name: self.values[f"now.{s.name}"] for s in c.state}
        outputs: dict[str, Term] = {o.name: self.values.get(f"{p}_out.{o.name}", Constant(-1)) for o in c.outputs}
        told: dict[str, Term] = {n: self.values[place] for n, place in said.items() if place in self.values}
        return Scan(base, after, outputs, dict(self.algebra.timers), told)

    def _begun(self, statements: list[Any], text: str) -> list[Any]:
        """What follows on statements that all files have in common."""
        wanted = _parsed(_uncommented(f"void f(uint32_t ms) {{\n{text}}}"))[-1].body.block_items
        if [_tree(x) for x in statements[: len(wanted)]] != [_tree(x) for x in wanted]:
            raise BadC("a scan does not begin as it should")
        return statements[len(wanted) :]

    def _copied(self, statements: list[Any]) -> list[Any]:
        """What follows on the functions that copy the inputs: every input, as `_copy` says and no other way."""
        c, rest = self.controller, list(statements)
        found: list[Any] = []
        while rest and type(rest[0]).__name__ == "FuncCall" and rest[0].args is None:
            name = str(getattr(rest[0].name, "name", ""))
            if not name.startswith("inputs_"):
                break
            if name in self.called:
                raise BadC(f"{name} is called twice")
            self.called.add(name)
            found += self._statements(name)
            del rest[0]
        text = "\n".join(self._copy(i) for i in c.inputs)
        wanted = _parsed(f"void f(void) {{\n{text}\n}}")[-1].body.block_items or ()
        if [_tree(x) for x in found] != [_tree(x) for x in wanted]:
            raise BadC("not every input is copied so that a byte that is neither 0 nor 1 is restrictive, and noted")
        self.values |= {f"in.{i.name}": Symbol(i.name) if i.size else var(i.name) for i in c.inputs}
        return rest

    def _copy(self, i: Input) -> str:
        """A bit of a byte that is 0 or 1; another byte reads as the restrictive value, and makes all inputs lost.

        That is asked of the text, whatever it was made by: nobody but the caller knows what he writes there.
        """
        given = f"{self.p}_in.{i.name}"
        if i.size:
            return f"in.{i.name} = {given};"
        reads = f"{given} != 0u" if i.restrictive else f"{given} == 1u"
        return f"in.{i.name} = ({reads}); implausible = implausible || ({given} > 1u);"

    def _statements(self, name: str) -> list[Any]:
        """The statements of a function of the emitted shape."""
        found = self.functions.get(name)
        if found is None:
            raise BadC(f"there is no function {name}")
        timed = name.startswith("timers_") or name == f"{self.p}_scan"
        static = "" if name.startswith(f"{self.p}_") else "static "
        head = _parsed(f"{static}void {name}({'uint32_t ms' if timed else 'void'});")[-1]
        if _tree(found.decl) != _tree(head) or found.param_decls:
            raise self._bad(found, f"{name} is no function as it is emitted")
        return list(found.body.block_items or ())

    def _call(self, name: str, statements: list[Any]) -> None:
        """Carry out statements of a function, which none of them may call."""
        if name in self.called:
            raise BadC(f"{name} is called twice, or calls itself")
        self.called.add(name)
        for x in statements:
            kind = type(x).__name__
            if kind == "Assignment" and x.op == "=":
                self._assign(x)
            elif kind == "FuncCall" and type(x.name).__name__ == "ID":
                given = [getattr(a, "name", None) for a in x.args.exprs] if x.args is not None else []
                if given != (["ms"] if x.name.name.startswith("timers_") else []) or x.name.name.startswith(self.p):
                    raise self._bad(x, "a call that is not emitted")
                self._call(x.name.name, self._statements(x.name.name))
            elif kind == "If" and name.startswith("words_"):
                self._say(x)
            else:
                raise self._bad(x, f"a statement that is not emitted: {kind}")

    def _say(self, x: Any) -> None:
        """A word gets the code, or the word, of the first condition that holds."""
        arms: list[tuple[Expr, Term]] = []
        places: set[str] = set()
        at: Any = x
        while type(at).__name__ == "If":
            arms.append((self._value(at.cond), self._said(at.iftrue, places)))
            at = at.iffalse
        found = self._said(at, places)
        for condition, value in reversed(arms):
            found = self.algebra.choose(condition, value, found)
        if len(places) != 1:
            raise self._bad(x, "several words at once")
        (place,) = places
        self._write(x, place)
        self.values[place] = self.algebra.assigned(place.partition(".")[2], found)

    def _said(self, body: Any, places: set[str]) -> Term:
        """What is assigned in a branch that does nothing else."""
        items = list(getattr(body, "block_items", None) or ()) if type(body).__name__ == "Compound" else []
        if len(items) != 1 or type(items[0]).__name__ != "Assignment" or items[0].op != "=":
            raise BadC("a condition under which not one word is said")
        place = self._place(items[0].lvalue)
        places.add(place)
        return self._code(items[0], place)

    def _code(self, x: Any, place: str) -> Term:
        """A code, or the value of another word, which a word gets."""
        if place.partition(".")[0] not in self.told or self._kind(x, place) != "int16_t":
            raise self._bad(x, f"{place} is no word")
        kind = type(x.rvalue).__name__
        if kind == "Constant" and _plain(x.rvalue.value) and int(x.rvalue.value) <= LAST:
            return Constant(int(x.rvalue.value))
        other = self._place(x.rvalue) if kind == "StructRef" else ""
        if other.partition(".")[0] in self.told:
            return self._held(x, other)
        raise self._bad(x, "neither a code nor a word")

    def _assign(self, x: Any) -> None:
        starting = f"{self.p}_init" in self.called
        if starting and type(x.lvalue).__name__ == "ID" and x.lvalue.name == "begun":
            self.values["begun"] = self._value(x.rvalue)
            return
        if type(x.lvalue).__name__ == "ID":
            if (x.lvalue.name, getattr(x.rvalue, "name", None)) != ("now", "next"):
                raise self._bad(x, "a copy that is not emitted")
            self._write(x, "now")
            for s in self.controller.state:
                self.values[f"now.{s.name}"] = self._held(x, f"next.{s.name}")
            return
        place = self._place(x.lvalue)
        self._write(x, place)
        root, _, name = place.partition(".")
        if root in self.told:
            value = self._code(x, place)
            self.values[place] = value if starting else self.algebra.assigned(name, value)
            return
        if type(x.rvalue).__name__ == "FuncCall":
            value = self._timed(x, root, name)
        elif type(x.rvalue).__name__ == "Constant":
            number = str(x.rvalue.value).removesuffix("u")
            wanted = ("int16_t", "uint8_t") if root == f"{self.p}_in" else ("uint32_t",)
            if self._kind(x, place) not in wanted or not _plain(number):
                raise self._bad(x, "a number that is not emitted")
            value = Constant(int(number))
        else:
            if self._kind(x, place) != "bool":
                raise self._bad(x, "a truth value where a number is needed")
            value = self._value(x.rvalue)
        if root == "in" or (root in ("now", "delay", f"{self.p}_in") and not starting):
            raise self._bad(x, f"{root} is written")
        shown = spelled(name) if root == "wire" else computed(spelled(name)) if root == "next" else ""
        self.values[place] = self.algebra.assigned(shown, value) if shown else value

    def _write(self, x: Any, place: str) -> None:
        """Note that an object is written in this call: twice it may not be, since others may see it in between."""
        if place in self.written:
            raise self._bad(x, f"{place} is written twice in a call")
        self.written.add(place)

    def _timed(self, x: Any, root: str, name: str) -> Term:
        """A timer's call gives the wire of its own name."""
        call = x.rvalue
        args = list(call.args.exprs) if call.args is not None else []
        if getattr(call.name, "name", None) != "on_delay" or len(args) != 4 or root != "wire":
            raise self._bad(x, "a call that is not emitted")
        timer, on, preset, ms = args
        own = type(timer).__name__ == "UnaryOp" and timer.op == "&" and self._place(timer.expr) == f"delay.{name}"
        number = str(getattr(preset, "value", "")).removesuffix("u")
        fits = _plain(number) and int(number) <= LONGEST_MS
        if not own or not fits or getattr(ms, "name", None) != "ms" or name in self.algebra.timers:
            raise self._bad(x, "a timer that is not called with its own memory, once")
        self.algebra.timers[name] = (self._value(on), int(number))
        return var(spelled(name))

    def _place(self, x: Any) -> str:
        """An object, or a member of one that there is, as it is written."""
        if type(x).__name__ == "ID":
            return str(x.name)
        if type(x).__name__ == "StructRef" and x.type == "." and type(x.field).__name__ == "ID":
            place = f"{self._place(x.name)}.{x.field.name}"
            self._kind(x, place, x.name)
            return place
        raise self._bad(x, "no member of a structure")

    def _kind(self, x: Any, place: str, inner: object = None) -> str:
        """The type of a member."""
        root, *members = place.split(".")
        own = {"in": "read", "wire": "wires", "now": "state", "next": "state", "delay": "delays"}
        own |= {f"{self.p}_in": "inputs", f"{self.p}_out": "outputs", f"{self.p}_said": "words", "reason": "reasons"}
        kind = f"{self.p}_{own[root]}" if root in own else ""
        fields = {**self.structures, f"{self.p}_delay": {"runs": "bool", "elapsed_ms": "uint32_t"}}
        for m in members:
            kind = fields.get(kind, {}).get(m, "")
        if not kind:
            raise self._bad(x, f"there is no {place}")
        return kind

    def _held(self, x: Any, place: str) -> Term:
        found = self.values.get(place)
        if found is None:
            raise self._bad(x, f"{place} is read before it is written")
        return found

    def _value(self, x: Any) -> Expr:
        """A truth value."""
        kind = type(x).__name__
        if kind == "ID" and x.name in ("true", "false"):
            return TRUE if x.name == "true" else FALSE
        if kind == "StructRef":
            found = self._held(x, self._place(x))
            if isinstance(found, Expr):
                return found
        if kind == "UnaryOp" and x.op == "!":
            return neg(self._value(x.expr))
        if kind == "BinaryOp" and x.op in ("&&", "||"):
            args = [x.right]
            while type(x.left).__name__ == "BinaryOp" and x.left.op == x.op:
                x = x.left
                args.append(x.right)
            values = [self._value(a) for a in (x.left, *reversed(args))]
            return conj(values) if x.op == "&&" else disj(values)
        if kind == "BinaryOp" and x.op == "==" and type(x.right).__name__ == "Constant" and _plain(x.right.value):
            held = self._held(x, self._place(x.left))
            if isinstance(held, Symbol):
                return eq(spelled(held.name), int(x.right.value))
        raise self._bad(x, f"an expression that is not emitted: {kind}")

    def _bad(self, x: Any, what: str) -> BadC:
        return BadC(f"{x.coord}: {what}")


def _plain(number: str) -> bool:
    """Whether a literal is a decimal number as it is printed: a leading zero would make it octal."""
    return number.isdigit() and str(int(number)) == number


def _parsed(text: str) -> list[Any]:
    """The parts of a text in which bool and the numbers of fixed width are types."""
    from pycparser import c_parser

    parts = list(c_parser.CParser().parse(f"{_OWN_TYPES}\n{text}", "c99").ext)
    return parts[_OWN_TYPES.count(";") :]
