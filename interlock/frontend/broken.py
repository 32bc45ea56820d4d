"""What is wrong with text that is no YAML, in the words of a layout's author.  IL1004.

A parser says where it could not go on; an unclosed quote or bracket, a missing space and a full-width sign stand before
that place.  Each rule here looks at the parser's error and at the lines, and points at the slip itself.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence

import yaml

from interlock.diag import Sink, Span
from interlock.frontend.signs import CLOSING, DIRECTIONS, OPENING, WIDE, odd_indent, spelled

LINE_ENDS = "\x85\u2028\u2029"
"""Characters that end a line for YAML, and for no editor: whoever reads the file would not see where a line begins."""
_KEY = r"([\w/-]+#?)"
_NO_SPACE = re.compile(rf"(?:^|[{{,\[]\s*|-\s+)\s*{_KEY}:(?=[^\s,}}\]/])")

_UNFIT = re.compile(r"[^\t\x20-\x7e\xa0-\u2027\u202a-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")
_SHOWN_OTHERWISE = re.compile(rf"[{LINE_ENDS}{DIRECTIONS}]|\r(?![\r\n])")

Found = tuple[str, Span, str]


def shown_otherwise(text: str) -> bool:
    """Whether a text has characters for which an editor shows other lines than YAML reads."""
    return _SHOWN_OTHERWISE.search(text) is not None


def report_broken(
    file: str, lines: Sequence[str], error: yaml.MarkedYAMLError, quoted: Span | None, sink: Sink
) -> None:
    """Report a parser's error where the slip is.  `quoted`: the last text in quotes before the error."""
    tabs = [i for i, line in enumerate(lines) if "\t" in line[: len(line) - len(line.lstrip())]]
    if tabs and _line(error) in tabs:
        for i in tabs:
            span = Span(file, i + 1, lines[i].index("\t") + 1)
            sink.add(
                "IL1004",
                "broken YAML: a tab stands where a line is indented",
                span,
                "indent with spaces, never with tabs",
            )
        return
    if report_indent(file, lines, range(min(_line(error) + 1, len(lines))), sink):
        return
    for rule in _RULES:
        for message, span, fix in rule(file, lines, error, quoted):
            sink.add("IL1004", f"broken YAML: {message}", span, fix)
            return
    mark = error.problem_mark or error.context_mark
    what = error.problem or error.context or "it cannot be read"
    span = Span(file, mark.line + 1, mark.column + 1) if mark else Span(file, 1, 1)
    sink.add(
        "IL1004", f"broken YAML: {what}", span, "check the indentation, the colons and the brackets up to this place"
    )


def report_indent(file: str, lines: Sequence[str], which: Iterable[int], sink: Sink) -> bool:
    """Report those of some lines, counted from 0, that are indented with spaces that are none to YAML; whether there
    are any."""
    any_ = False
    for i in which:
        found = odd_indent(lines[i])
        if found is not None:
            start, width, kind = found
            said = f"broken YAML: a {kind} space stands where a line is indented"
            sink.add("IL1004", said, Span(file, i + 1, start + 1, width), "indent with plain spaces")
            any_ = True
    return any_


def report_control(file: str, lines: Sequence[str], what: str, sink: Sink) -> None:
    """Report the first character that no text has."""
    for i, line in enumerate(lines):
        found = _SHOWN_OTHERWISE.search(line.removesuffix("\r")) or _UNFIT.search(line.removesuffix("\r"))
        if found is not None:
            said = f"broken YAML: the character U+{ord(found[0]):04X} cannot stand in a text"
            fix = "remove it; is this a text file?"
            if found[0] in DIRECTIONS:
                said += ": it turns the direction of what follows, so that the line reads otherwise than it is shown"
                fix = "remove it, and look at what the line says without it"
            elif found[0] in f"{LINE_ENDS}\r":
                fix = "begin a new line in its place"
            sink.add("IL1004", said, Span(file, i + 1, found.start() + 1), fix)
            return
    sink.add("IL1004", f"broken YAML: {what}", Span(file, 1, 1), "save the file as plain UTF-8 text")


def _line(error: yaml.MarkedYAMLError) -> int:
    """The line of the error, from 0."""
    mark = error.problem_mark or error.context_mark
    return mark.line if mark is not None else 0


def _lines(lines: Sequence[str], error: yaml.MarkedYAMLError) -> Iterator[int]:
    """The lines in which the slip may be: where the parser began with what it could not finish, where it stopped."""
    for mark in (error.context_mark, error.problem_mark):
        if mark is not None and mark.line < len(lines):
            yield mark.line


def _conflict(file: str, lines: Sequence[str], error: yaml.MarkedYAMLError, quoted: Span | None) -> Iterator[Found]:
    """What a version control program has written around two versions that it could not join."""
    for i, line in enumerate(lines):
        mark = re.match(r"(<{7}|>{7})( |$)", line)
        if mark is not None:
            span = Span(file, i + 1, 1, len(line))
            fix = "keep one of the two versions, and remove the lines `<<<<<<<`, `=======` and `>>>>>>>`"
            yield "two versions of the file are left here by a version control program", span, fix
            return


def _round(file: str, lines: Sequence[str], error: yaml.MarkedYAMLError, quoted: Span | None) -> Iterator[Found]:
    """`q1: (lane: inclined)`: the braces of a mapping, round or full-width."""
    for i in _lines(lines, error):
        found = re.match(rf"\s*(?:- )?\s*{_KEY}\s*[:：]\s*(.*)$", lines[i].split(" #")[0].rstrip())
        value = found[2] if found is not None else ""
        if found is None or value[:1] not in set(OPENING) - set("[{［") or value[-1:] not in CLOSING:
            continue
        inner = spelled(value)
        if all(re.match(r"[a-z_]+: ", part) for part in inner.split(", ")):
            span = Span(file, i + 1, found.start(2) + 1, len(value))
            fix = f"write `{found[1]}: {{{inner}}}`"
            yield f"the values of `{found[1]}` stand in braces, not in `{value[0]} {value[-1]}`", span, fix


def _wide(file: str, lines: Sequence[str], error: yaml.MarkedYAMLError, quoted: Span | None) -> Iterator[Found]:
    """A sign of an East Asian keyboard where YAML wants an ASCII one."""
    for i in _lines(lines, error):
        for k, c in enumerate(lines[i].split(" #")[0]):
            if c in WIDE and '"' not in lines[i][:k]:
                plain = "a space" if WIDE[c] == " " else f"`{WIDE[c]}`"
                yield f"the full-width sign `{c}` means nothing here", Span(file, i + 1, k + 1), f"write {plain}"


def _no_break(file: str, lines: Sequence[str], error: yaml.MarkedYAMLError, quoted: Span | None) -> Iterator[Found]:
    """A space that a word processor keeps from being broken: to YAML it is a letter."""
    for i in _lines(lines, error):
        found = re.search("(?::|^ *)(\u00a0+)", lines[i])
        if found is not None:
            span = Span(file, i + 1, found.start(1) + 1, len(found[1]))
            yield "a no-break space stands where a space is wanted", span, "write a plain space"


def _other_sign(file: str, lines: Sequence[str], error: yaml.MarkedYAMLError, quoted: Span | None) -> Iterator[Found]:
    """`X3 = {...`, and a comment that begins with `//`: signs of programming languages."""
    for k in range(min(_line(error) + 1, len(lines))):
        begun = re.match(r"\s*(//|;|--\s)", lines[k])
        if begun is not None:
            span = Span(file, k + 1, begun.start(1) + 1, len(begun[1].rstrip()))
            yield "a comment begins with `#`", span, f"write `#` for `{begun[1].rstrip()}`"
    for i in _lines(lines, error):
        found = re.match(rf"\s*{_KEY}\s*(=)\s*([{{\[].*)$", lines[i])
        if found is not None:
            span = Span(file, i + 1, found.start(2) + 1)
            yield "a colon is wanted here, not `=`", span, f"write `{found[1]}: {found[3][:40].rstrip()}`"
        comment = re.search(r"[}\]]\s+(//|;|--)", lines[i])
        if comment is not None:
            span = Span(file, i + 1, comment.start(1) + 1, len(comment[1]))
            yield "a comment begins with `#`", span, f"write `#` for `{comment[1]}`"


def _closed_room(file: str, lines: Sequence[str], error: yaml.MarkedYAMLError, quoted: Span | None) -> Iterator[Found]:
    """`signals: {}` with entries below."""
    above = [k for k in range(min(_line(error), len(lines))) if lines[k].strip() and lines[k].lstrip()[0] != "#"]
    found = re.match(r"\s*(\S+):\s*(\{\s*\}|\[\s*\])\s*(?:#.*)?$", lines[above[-1]]) if above else None
    if found is not None and _line(error) < len(lines) and _depth(lines[_line(error)]) > _depth(lines[above[-1]]):
        span = Span(file, above[-1] + 1, found.start(2) + 1, len(found[2]))
        yield f"`{found[1]}` ends here, and entries follow below it", span, f"write `{found[1]}:` alone in the line"


def _unclosed_quote(
    file: str, lines: Sequence[str], error: yaml.MarkedYAMLError, quoted: Span | None
) -> Iterator[Found]:
    mark = error.context_mark
    if mark is not None and "quoted scalar" in (error.context or "") and "end of" in (error.problem or ""):
        text = lines[mark.line][mark.column :]
        sign = text[:1]
        word = re.split(r"[,}\]#]", text[1:])[0].strip()
        span = Span(file, mark.line + 1, mark.column + 1, len(word) + 1)
        yield f"the quote {sign} is opened here and never closed", span, f"write {sign}{word}{sign}"


def _unclosed_bracket(
    file: str, lines: Sequence[str], error: yaml.MarkedYAMLError, quoted: Span | None
) -> Iterator[Found]:
    mark = error.context_mark
    if mark is None or "while parsing a flow" not in (error.context or "") or _line(error) == mark.line:
        return
    sign = lines[mark.line][mark.column : mark.column + 1]
    if sign in "{[" and not _NO_SPACE.search(lines[_line(error)] if _line(error) < len(lines) else ""):
        closing = "}" if sign == "{" else "]"
        text = lines[mark.line][mark.column :].rstrip()
        before, comment, rest = text.partition(" #")
        if comment and closing in rest:
            span = Span(file, mark.line + 1, mark.column + len(before) + 2, len(rest) + 1)
            yield (
                f"a comment reaches to the end of its line, beyond the `{closing}`",
                span,
                "put it behind the brackets",
            )
            return
        span = Span(file, mark.line + 1, mark.column + 1, len(text))
        yield f"`{sign}` is opened here and not closed before line {_line(error) + 1}", span, f"write `{text}{closing}`"


def _open_at_the_end(
    file: str, lines: Sequence[str], error: yaml.MarkedYAMLError, quoted: Span | None
) -> Iterator[Found]:
    """The file ends within brackets, of which the parser says nothing but where the file ends."""
    if "expected node content" not in (error.problem or "") or "".join(lines[_line(error) :]).strip():
        return
    opened: list[tuple[int, int, str]] = []
    for i, line in enumerate(lines):
        text = re.sub(r"(?:^|\s)#.*", "", re.sub(r"'[^']*'|\"[^\"]*\"", lambda m: " " * len(m[0]), line))
        for k, sign in enumerate(text):
            if sign in "{[":
                opened.append((i, k, sign))
            elif sign in "}]" and opened:
                opened.pop()
    if opened:
        i, k, sign = opened[-1]
        closing = "}" if sign == "{" else "]"
        yield (
            f"`{sign}` is opened here and not closed before the file ends",
            Span(file, i + 1, k + 1),
            f"add `{closing}`",
        )


def _no_space(file: str, lines: Sequence[str], error: yaml.MarkedYAMLError, quoted: Span | None) -> Iterator[Found]:
    """`name:halt`, `X3:{...`."""
    for i in [*_lines(lines, error), *_text_before(lines, error)]:
        found = _NO_SPACE.search(lines[i])
        if found is not None:
            key, rest = found[1], lines[i][found.end() :].strip()
            span = Span(file, i + 1, found.start(1) + 1, len(key) + 1)
            yield f"a space is missing after `{key}:`", span, f"write `{key}: {rest[:40]}`"


def _text_before(lines: Sequence[str], error: yaml.MarkedYAMLError) -> Iterator[int]:
    """The line above one whose colon is not wanted: `interlock:1` is a text, which goes on below."""
    above = [k for k in range(min(_line(error), len(lines))) if lines[k].strip() and lines[k].lstrip()[0] != "#"]
    if above and "mapping values are not allowed" in (error.problem or "") and re.match(r"\w+:\S+$", lines[above[-1]]):
        yield above[-1]


def _apostrophe(file: str, lines: Sequence[str], error: yaml.MarkedYAMLError, quoted: Span | None) -> Iterator[Found]:
    """A text in quotes that goes on after a quote in it: 'driver's side'."""
    mark = error.problem_mark
    if mark is None or quoted is None or mark.line >= len(lines) or quoted.line != mark.line + 1:
        return
    line = lines[mark.line]
    sign = line[quoted.column - 1 : quoted.column]
    end = line.rfind(sign)
    if quoted.column + quoted.width - 1 == mark.column and end > mark.column:
        text = line[quoted.column : end]
        other = '"' if sign == "'" else "'"
        span = Span(file, quoted.line, quoted.column, end + 2 - quoted.column)
        yield f"the text in quotes ends at the {sign} inside it", span, f"write {other}{text}{other}"


def _dash(file: str, lines: Sequence[str], error: yaml.MarkedYAMLError, quoted: Span | None) -> Iterator[Found]:
    i = _line(error)
    mixed = error.context_mark is not None and "expected '-' indicator" in (error.problem or "")
    if mixed and i < len(lines) and error.context_mark is not None and re.match(r"\s*[^\s:]+:\s", lines[i]):
        above = error.context_mark.line  # where the list began
        i = above if re.match(r"\s*-\s+[^\s:]+:\s", lines[above]) else i
    if i < len(lines) and re.match(r"\s*-\s", lines[i]):
        rest = lines[i].lstrip()[1:].strip()
        span = Span(file, i + 1, lines[i].index("-") + 1)
        yield "a line that begins with `-` stands among `key: value` lines", span, f"write `{rest}`, without the dash"


def _long_quote(file: str, lines: Sequence[str], error: yaml.MarkedYAMLError, quoted: Span | None) -> Iterator[Found]:
    """A quote that was closed by the next one, lines below."""
    if quoted is None or quoted.line - 1 >= _line(error):
        return
    text = lines[quoted.line - 1][quoted.column - 1 :]
    if text.count(text[:1]) == 1:
        word = text[1:].split("#")[0].rstrip(" ,}]")
        sign = text[:1]
        span = Span(file, quoted.line, quoted.column, len(word) + 1)
        yield f"the quote {sign} that is opened here ends in another line", span, f"write {sign}{word}{sign}"


def _indent(file: str, lines: Sequence[str], error: yaml.MarkedYAMLError, quoted: Span | None) -> Iterator[Found]:
    """A line that begins at another column than the lines beside it."""
    i = _line(error)
    above = next((k for k in range(i - 1, -1, -1) if lines[k].strip() and not lines[k].lstrip().startswith("#")), None)
    if above is None or i >= len(lines) or ":" not in lines[i] or ":" not in lines[above]:
        return
    own, theirs = _depth(lines[i]), _depth(lines[above])
    key, value = (x.split("#")[0].strip() for x in lines[above].split(":", 1))
    if own > theirs == 0 and value.startswith("["):  # a list beside a key, and its entries below
        span = Span(file, above + 1, lines[above].index("[") + 1, len(value))
        fix = f"remove `{value}`: what stands in the lines below belongs to `{key}` then"
        yield f"`{key}` has a list beside it, and entries of its own in the lines below", span, fix
        return
    if own != theirs and (value or own < theirs):
        span = Span(file, i + 1, 1, max(1, own))
        further = "write above it the key to which it belongs" if own > theirs else "as what it belongs to"
        yield f"the line is indented by {own}, the line above by {theirs}", span, f"indent it by {theirs}, or {further}"


def _no_comma(file: str, lines: Sequence[str], error: yaml.MarkedYAMLError, quoted: Span | None) -> Iterator[Found]:
    """`{from: q3 into: q5}`."""
    mark = error.problem_mark
    if mark is None or mark.line >= len(lines) or "expected ','" not in (error.problem or ""):
        return
    line = lines[mark.line]
    found = re.search(rf"([^\s,{{\[]+)\s+{_KEY}$", line[: mark.column])
    if found is not None and line[mark.column : mark.column + 1] == ":":
        rest = re.split(r"[,}]", line[mark.column + 1 :])[0].strip()
        span = Span(file, mark.line + 1, found.start(2) + 1, len(found[2]))
        before = found[1].rstrip(";")
        wrong = "a comma is missing" if before == found[1] else "a semicolon stands for a comma"
        yield f"{wrong} before `{found[2]}`", span, f"write `{before}, {found[2]}: {rest}`"


def _mismatch(file: str, lines: Sequence[str], error: yaml.MarkedYAMLError, quoted: Span | None) -> Iterator[Found]:
    """A closing bracket that closes nothing, or another kind of bracket."""
    mark, begun = error.problem_mark, error.context_mark
    sign = lines[mark.line][mark.column : mark.column + 1] if mark is not None and mark.line < len(lines) else ""
    if mark is None or sign not in ("]", "}"):
        return
    span = Span(file, mark.line + 1, mark.column + 1)
    opened = lines[begun.line][begun.column : begun.column + 1] if begun is not None and begun.line < len(lines) else ""
    if begun is not None and opened in ("[", "{") and {"[": "]", "{": "}"}[opened] != sign:
        closing = {"[": "]", "{": "}"}[opened]
        yield f"`{sign}` cannot close the `{opened}` of column {begun.column + 1}", span, f"write `{closing}`"
    else:
        yield f"`{sign}` closes nothing", span, "remove it, or open the bracket before it"


def _no_colon(file: str, lines: Sequence[str], error: yaml.MarkedYAMLError, quoted: Span | None) -> Iterator[Found]:
    """A line of which the parser expected that it is a key."""
    mark = error.context_mark
    if mark is None or "expected ':'" not in (error.problem or "") or mark.line >= len(lines):
        return
    text = lines[mark.line].split(" #")[0].strip()
    if text and ":" not in text:
        words = text.split(None, 1)
        fix = f"write `{words[0]}: {words[1]}`" if len(words) > 1 else f"write `{words[0]}:`"
        yield "a colon is missing in this line", Span(file, mark.line + 1, mark.column + 1, len(text)), fix


def _two_colons(file: str, lines: Sequence[str], error: yaml.MarkedYAMLError, quoted: Span | None) -> Iterator[Found]:
    """`X1: from: W, into: q1}`, `title: Halt: the new one`."""
    mark = error.problem_mark
    if mark is None or "mapping values are not allowed" not in (error.problem or "") or mark.line >= len(lines):
        return
    line = lines[mark.line]
    found = re.match(rf"\s*(?:- )?\s*{_KEY}:\s+(.+)$", line.split(" #")[0].rstrip())
    if found is None:
        return
    span = Span(file, mark.line + 1, found.start(2) + 1, len(found[2]))
    values = found[2].strip("{} ")
    if all(":" in part for part in values.split(",")) and re.match(r"[a-z_]+:\s", values) and values.count(":") > 1:
        yield f"the values of `{found[1]}` stand without braces", span, f"write `{found[1]}: {{{values}}}`"
    else:
        yield "a colon inside a text ends the text", span, f'write `{found[1]}: "{found[2]}"`'


def _depth(line: str) -> int:
    return len(line) - len(line.lstrip())


_RULES = (
    _conflict,
    _round,
    _wide,
    _no_break,
    _other_sign,
    _closed_room,
    _unclosed_quote,
    _no_comma,
    _mismatch,
    _unclosed_bracket,
    _open_at_the_end,
    _no_space,
    _apostrophe,
    _dash,
    _long_quote,
    _no_colon,
    _two_colons,
    _indent,
)
"""In this order: the first that fits tells what is wrong."""
