"""The controller as one C99 file and its header: the equations of the Structured Text, in its order, memory all static.

MISRA C was kept in mind (no allocation, recursion, loop or pointer arithmetic, fixed-width types, one exit a
function), but its text was not at hand: no compliance is claimed.  The only headers are stdbool.h and stdint.h, so
that it needs no library.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from itertools import groupby
from string import ascii_letters, digits

from interlock.dataclass import dataclass
from interlock.emit.python.runtime import route_numbers
from interlock.logic.controller import Controller, Equation, Join, Step, Timer
from interlock.logic.expr import AND, EQ, FALSE, NOT, TRUE, VAR, Expr
from interlock.logic.names import Name, computed
from interlock.logic.on_delay import CYCLE_MAX_MS
from interlock.logic.order import by_place
from interlock.logic.words import UNKNOWN, Value, Word, Words
from interlock.model.portable import portable

ROWS = 200
"""Equations or timers in a function, at most: our choice; compilers for small controllers take long over long ones."""

NUMBER = "int16_t"
"""What a number is, as INT in Structured Text."""

BYTE = "uint8_t"
"""What a bit is that somebody else writes: of a `bool` C says nothing once a byte in it is neither 0 nor 1."""

_PLAIN = f"{ascii_letters}{digits} _-+.,:>()"


@dataclass(frozen=True)
class Fixed:
    """What all files have in common but for names and counts: types of tables, declarations, the timer, the cycle."""

    prefix: str
    counts: Mapping[str, int]
    valid: Name
    words: bool
    reasons: bool

    @property
    def guard(self) -> str:
        """The name that keeps the header from being read twice."""
        return f"{self.prefix.upper()}_H"

    @property
    def declared(self) -> str:
        """In the header, after the structures."""
        p, n = self.prefix, self.counts
        word = f"\n  const {NUMBER} *word;" if self.words else ""
        said = f"\nextern {p}_words {p}_said;" if self.words else ""
        told, shown = (" and its word", f" and {p}_said") if self.words else ("", "")
        return f"""\
/* A bit that may be written, by name: 0 or 1.  While a byte of one is neither, all inputs count as lost. */
typedef struct {{
  const char *name;
  {BYTE} *bit;
}} {p}_input_bit;

/* A number that may be written, by name, with the number of its values. */
typedef struct {{
  const char *name;
  {NUMBER} *number;
  {NUMBER} values;
}} {p}_input_number;

/* A bit to be read, by name. */
typedef struct {{
  const char *name;
  const bool *bit;
}} {p}_bit;

/* A route by name, the number that asks for it{told}. */
typedef struct {{
  const char *name;
  {NUMBER} number;{word}
}} {p}_route;

extern {p}_inputs {p}_in;
extern {p}_outputs {p}_out;{said}
extern const {p}_input_bit {p}_input_bits[{n["input_bits"]}];
extern const {p}_input_number {p}_input_numbers[{n["input_numbers"]}];
extern const {p}_bit {p}_output_bits[{n["output_bits"]}];
extern const {p}_bit {p}_state_bits[{n["state_bits"]}];
extern const {p}_route {p}_routes[{n["routes"]}];

/* As after a restart: everything locked, signals at stop, timers stopped, inputs restrictive. */
void {p}_init(void);

/* One scan, so many milliseconds after the last: reads {p}_in, writes {p}_out{shown}. */
void {p}_scan(uint32_t ms);
"""

    @property
    def delay(self) -> str:
        """The type of a timer's memory."""
        return f"""\
/* An on-delay timer: whether its input was true in the last scan, and for how long it has been. */
typedef struct {{
  bool runs;
  uint32_t elapsed_ms;
}} {self.prefix}_delay;
"""

    @property
    def objects(self) -> str:
        """All memory."""
        p = self.prefix
        said = f"\n{p}_words {p}_said;" if self.words else ""
        reason = f"\nstatic {p}_reasons reason;" if self.reasons else ""
        return f"""\
{p}_inputs {p}_in;
{p}_outputs {p}_out;{said}

static bool begun = false;
static bool implausible = false;
static {p}_read in;
static {p}_wires wire;
static {p}_state now;
static {p}_state next;
static {p}_delays delay;{reason}
"""

    @property
    def on_delay(self) -> str:
        """TON of IEC 61131-3: in the scan in which the input rises no time has passed yet."""
        return f"""\
/* TON of IEC 61131-3: in the scan in which the input rises no time has passed yet. */
static bool on_delay({self.prefix}_delay *timer, bool on, uint32_t preset_ms, uint32_t ms)
{{
  if (!on)
  {{
    timer->elapsed_ms = 0u;
  }}
  else if (!timer->runs)
  {{
    timer->elapsed_ms = 0u;
  }}
  else if (ms < (preset_ms - timer->elapsed_ms))
  {{
    timer->elapsed_ms += ms;
  }}
  else
  {{
    timer->elapsed_ms = preset_ms;
  }}
  timer->runs = on;
  return on && (timer->elapsed_ms >= preset_ms);
}}
"""

    @property
    def begin(self) -> str:
        """How a scan begins; after that it copies the inputs."""
        return f"""\
  if (!begun)
  {{
    {self.prefix}_init();
  }}
  implausible = false;
"""

    @property
    def late(self) -> str:
        """What has been copied is lost if a byte of it is neither 0 nor 1, and after a cycle that was too long."""
        return f"""\
  if (implausible || (ms > {CYCLE_MAX_MS}u))
  {{
    in.{self.valid} = false; /* nobody knows what happened meanwhile */
  }}
"""


def fixed(c: Controller) -> Fixed:
    """The fixed parts for a controller."""
    numbers = sum(i.size > 0 for i in c.inputs)
    counts = {
        "input_bits": len(c.inputs) - numbers,
        "input_numbers": numbers,
        "output_bits": len(c.outputs),
        "state_bits": len(c.state),
        "routes": len(route_numbers(c)),
    }
    shown, inner = _told(c)
    return Fixed(f"IL_{portable(c.name)}", counts, c.symbols.valid, bool(shown), bool(inner))


def _told(c: Controller) -> tuple[list[Word], list[Word]]:
    """The words of routes, and those that only other words read."""
    shown = set(c.words.routes.values())
    return [w for w in c.words.words if w.name in shown], [w for w in c.words.words if w.name not in shown]


def runtime_c(controller: Controller, header: Sequence[str]) -> dict[str, str]:
    """The C file and its header, by name."""
    c, parts = controller, fixed(controller)
    name = parts.prefix.removeprefix("IL_")
    top = [_comment(h) for h in header]
    return {f"{name}.h": _header(c, parts, top), f"{name}.c": _source(c, parts, top, name)}


def literal(text: str) -> str:
    """A string literal of C: what is no plain character is an octal escape of its UTF-8 bytes."""
    return '"' + "".join(chr(b) if chr(b) in _PLAIN else f"\\{b:03o}" for b in text.encode()) + '"'


def _comment(text: str) -> str:
    kept = "".join(ch if 32 <= ord(ch) < 127 and ch not in "\\?" else "_" for ch in text)
    return f"/* {kept.replace('*/', '* /').replace('/*', '/ *')} */"


def _noted(line: str, note: str) -> str:
    return f"{line} {_comment(note)}" if note else line


def _struct(name: str, members: Sequence[tuple[str, str, str]], note: str) -> list[str]:
    """A structure of type, name and note of each member."""
    lines = [_noted(f"  {kind} {member};", said) for kind, member, said in members]
    return [_comment(note), "typedef struct {", *lines, f"}} {name};", ""]


def _header(c: Controller, parts: Fixed, top: list[str]) -> str:
    p = parts.prefix
    inputs = [(NUMBER if i.size else BYTE, i.name, i.note) for i in c.inputs]
    lines = [
        *top,
        _comment(f"Interlocking {c.name}: call {p}_init once, then {p}_scan once in each cycle."),
        f"#ifndef {parts.guard}",
        f"#define {parts.guard}",
        "",
        "#include <stdbool.h>",
        "#include <stdint.h>",
        "",
        *_struct(f"{p}_inputs", inputs, "What a scan reads: of each bit 0 or 1."),
        *_struct(f"{p}_outputs", [("bool", o.name, o.note) for o in c.outputs], "What a scan writes."),
        *_struct(f"{p}_state", [("bool", s.name, s.note) for s in c.state], "What is kept from scan to scan."),
        *_numbers(f"{p}_words", _told(c)[0], "What is said of each route after a scan; 0 before the first."),
        parts.declared,
        "#endif",
    ]
    return "\n".join(lines) + "\n"


def _numbers(name: str, words: Sequence[Word], note: str) -> list[str]:
    """A structure of words, where there are any."""
    return _struct(name, [(NUMBER, w.name, w.note) for w in words], note) if words else []


def _source(c: Controller, parts: Fixed, top: list[str], name: str) -> str:
    p = parts.prefix
    where: dict[str, str] = {i.name: f"in.{i.name}" for i in c.inputs}
    where |= {s.name: f"now.{s.name}" for s in c.state}
    where |= {s.name: f"wire.{s.name}" for s in c.steps}
    wires = [("bool", s.name, "") for s in c.steps]
    delays = [(f"{p}_delay", t.name, t.note) for t in c.timers]
    following = {e.name: e.named(computed(e.name), e.note) for e in c.next}
    targets = {e.name: f"next.{state}" for state, e in following.items()}
    lines = [
        *top,
        f'#include "{name}.h"',
        "",
        *_struct(f"{p}_read", [(NUMBER if i.size else "bool", i.name, "") for i in c.inputs], "What was read."),
        *_struct(f"{p}_wires", wires, "What is computed anew in each scan."),
        parts.delay,
        *_struct(f"{p}_delays", delays, "Timers."),
        *_numbers(f"{p}_reasons", _told(c)[1], "What words of routes read of each other."),
        parts.objects,
        *_tables(c, p),
        parts.on_delay,
    ]
    copies, copied = _copies(c, p)
    lines += copied
    calls = []
    for n, piece in enumerate(_cut(by_place(c.steps, following)), 1):
        timed = isinstance(piece[0], Timer)
        calls.append(f"  {'timers' if timed else 'part'}_{n:03d}({'ms' if timed else ''});")
        lines.append(f"static void {'timers' if timed else 'part'}_{n:03d}({'uint32_t ms' if timed else 'void'})")
        lines.append("{")
        for step in piece:
            lines += _timer(step, where) if isinstance(step, Timer) else _equation(step, targets, where)
        lines += ["}", ""]
    shown, inner = _told(c)
    where |= {str(e.name): targets[e.name] for e in following.values()}
    where |= {w.name: f"{p}_said.{w.name}" for w in shown}
    where |= {w.name: f"reason.{w.name}" for w in inner}
    for n, at in enumerate(range(0, len(c.words.words), ROWS // 4), 1):
        calls.append(f"  words_{n:03d}();")
        lines += [f"static void words_{n:03d}(void)", "{"]
        lines += [line for w in c.words.words[at : at + ROWS // 4] for line in _word(w, where, c.words)]
        lines += ["}", ""]
    lines += ["static void report(void)", "{"]
    lines += [f"  {p}_out.{o.name} = {_code(o.expr, where)};" for o in c.outputs]
    lines += ["}", "", f"void {p}_init(void)", "{", "  begun = true;"]
    lines += [f"  {p}_in.{i.name} = {i.restrictive}{'' if i.size else 'u'};" for i in c.inputs]
    lines += [f"  {where[w.name]} = {UNKNOWN};" for w in shown]
    lines += [f"  now.{s.name} = {_bool(s.initial)};" for s in c.state]
    for t in c.timers:
        lines += [f"  delay.{t.name}.runs = false;", f"  delay.{t.name}.elapsed_ms = 0u;"]
    lines += ["  report();", "}", "", f"void {p}_scan(uint32_t ms)", "{", parts.begin.rstrip("\n")]
    lines += [*copies, parts.late.rstrip("\n"), *calls, "  now = next;", "  report();", "}"]
    return "\n".join(lines) + "\n"


def _copies(c: Controller, p: str) -> tuple[list[str], list[str]]:
    """Calls of the functions that copy the inputs, and these.

    A byte is true only if it is 1; where true is restrictive it is false only if it is 0.  That there was one of
    another value is noted: where points are detected neither value is restrictive by itself.
    """
    calls, lines = [], []
    for n, at in enumerate(range(0, len(c.inputs), ROWS), 1):
        calls.append(f"  inputs_{n:03d}();")
        lines += [f"static void inputs_{n:03d}(void)", "{"]
        for i in c.inputs[at : at + ROWS]:
            given = f"{p}_in.{i.name}"
            if i.size:
                lines.append(f"  in.{i.name} = {given};")
                continue
            lines.append(f"  in.{i.name} = ({given} {'!= 0u' if i.restrictive else '== 1u'});")
            lines.append(f"  implausible = implausible || ({given} > 1u);")
        lines += ["}", ""]
    return calls, lines


def _tables(c: Controller, p: str) -> Iterator[str]:
    """Names with what they stand for."""
    bits = [f'"{i.name}", &{p}_in.{i.name}' for i in c.inputs if not i.size]
    numbers = [f'"{i.name}", &{p}_in.{i.name}, {i.size}' for i in c.inputs if i.size]
    rows = {
        f"{p}_input_bit {p}_input_bits": bits,
        f"{p}_input_number {p}_input_numbers": numbers,
        f"{p}_bit {p}_output_bits": [f'"{o.name}", &{p}_out.{o.name}' for o in c.outputs],
        f"{p}_bit {p}_state_bits": [f'"{s.name}", &now.{s.name}' for s in c.state],
        f"{p}_route {p}_routes": [", ".join(row) for row in route_rows(c, p)],
    }
    for kind, entries in rows.items():
        yield f"const {kind}[{len(entries)}] = {{"
        yield from (f"  {{ {e} }}{',' if n < len(entries) else ''}" for n, e in enumerate(entries, 1))
        yield "};"
        yield ""


def route_rows(c: Controller, p: str) -> list[tuple[str, ...]]:
    """A route's name, number and word, as the table has them."""
    words = {n: (f"&{p}_said.{name}",) for n, name in c.words.routes.items()}
    return [(literal(name), str(number), *words.get(number, ())) for name, number in route_numbers(c).items()]


def _word(w: Word, where: Mapping[str, str], words: Words) -> list[str]:
    """IF the first condition, its code."""

    def said(value: Value) -> str:
        if not isinstance(value, int):
            return f"{where[w.name]} = {where[value]};"
        return _noted(f"{where[w.name]} = {value};", words.said(value) if value else "")

    lines = [f"  {_comment(w.note)}"] if w.note else []
    for n, case in enumerate(w.cases):
        lead = "else if" if n else "if"
        lines += [f"  {lead} ({_code(case.condition, where)})", "  {", f"    {said(case.value)}", "  }"]
    if not w.cases:
        return [*lines, f"  {said(w.otherwise)}"]
    return [*lines, "  else", "  {", f"    {said(w.otherwise)}", "  }"]


def _cut(steps: Sequence[Step]) -> Iterator[list[Step]]:
    """Consecutive equations, and consecutive timers, a function each."""
    for _, run in groupby(steps, key=type):
        whole = list(run)
        yield from (whole[i : i + ROWS] for i in range(0, len(whole), ROWS))


def _timer(t: Timer, where: Mapping[str, str]) -> list[str]:
    call = f"on_delay(&delay.{t.name}, {where[t.input]}, {t.preset_ms}u, ms)"
    return [_noted(f"  {where[t.name]} = {call};", t.note)]


def _equation(e: Equation, targets: Mapping[Name, str], where: Mapping[str, str]) -> list[str]:
    """An assignment, an operand a line."""
    neutral = TRUE if e.join is Join.ALL else FALSE
    terms = [t for t in e.terms if t.expr is not neutral]
    op = "&&" if e.join is Join.ALL else "||"
    lead = f"  {targets.get(e.name) or where[e.name]} ="
    if not terms:
        return [_noted(f"{lead} {_bool(e.join is Join.ALL)};", e.note)]
    single = len(terms) == 1
    texts = [_code(t.expr, where, not single) for t in terms]
    notes = [t.note or t.kind for t in terms]
    if single:
        return [_noted(f"{lead} {texts[0]};", e.note)]
    lines = [_noted(lead, e.note)]
    for n, (text, note) in enumerate(zip(texts, notes, strict=True)):
        ending = ";" if n == len(texts) - 1 else ""
        lines.append(_noted(f"    {op + ' ' if n else ''}{text}{ending}", note))
    return lines


def _bool(x: bool) -> str:
    return "true" if x else "false"


def _code(x: Expr, where: Mapping[str, str], inner: bool = False) -> str:
    if x is TRUE or x is FALSE:
        return _bool(x is TRUE)
    if x.op is VAR:
        return where[x.name]
    if x.op is EQ:
        return f"({where[x.name]} == {x.value})"
    if x.op is NOT:
        return f"!{_code(x.args[0], where, True)}"
    body = (" && " if x.op is AND else " || ").join(_code(a, where, True) for a in x.args)
    return f"({body})" if inner else body
