"""YAML as a tree of nodes with places; scalars stay text until the schema gives them a type.

Input: the text of a file.  Output: a tree, or diagnostics IL1004-IL1008, IL1018, IL1019.
The tree is built from parser events without recursion, so that no input can exhaust the stack.
"""

from __future__ import annotations

from dataclasses import field
from itertools import islice
from pathlib import PurePath

import yaml

from interlock.dataclass import dataclass
from interlock.diag import Sink, Span
from interlock.frontend.broken import report_broken, report_control, report_indent, shown_otherwise

MAX_DEPTH = 12
_WRITE_OUT = "write the value out; a layout is read by people from top to bottom"
_LOADER = getattr(yaml, "CSafeLoader", yaml.SafeLoader)


@dataclass
class Scalar:
    """A text, exactly as written; `plain` is False for quoted text."""

    text: str
    span: Span
    plain: bool = True


@dataclass
class Sequence:
    """A list of nodes."""

    span: Span
    items: list[Node] = field(default_factory=list)


@dataclass
class Mapping:
    """Keys and values in source order; keys are scalars and unique."""

    span: Span
    items: dict[str, tuple[Scalar, Node]] = field(default_factory=dict)


Node = Scalar | Sequence | Mapping


def _span(file: str, event: yaml.Event, text_lines: list[str]) -> Span:
    start, end = event.start_mark, event.end_mark
    assert start is not None and end is not None
    width = 1
    if end.line == start.line:
        width = max(1, end.column - start.column)
    elif start.line < len(text_lines):
        width = max(1, len(text_lines[start.line]) - start.column)
    return Span(file, start.line + 1, start.column + 1, width)


def _admitted(event: yaml.ScalarEvent | yaml.CollectionStartEvent, span: Span, depth: int, sink: Sink) -> bool:
    """A layout has no anchors, no tags, and few levels of nesting; reports the first of these that there is."""
    if event.anchor:
        sink.add(
            "IL1006",
            f"the anchor &{event.anchor} is not allowed",
            span,
            _WRITE_OUT,
        )
    elif event.tag and event.tag != "!":
        sink.add("IL1019", f"the tag {event.tag} is not allowed", span, "remove the tag")
    elif depth >= MAX_DEPTH:
        sink.add("IL1018", f"more than {MAX_DEPTH} levels of nesting", span, "a layout needs no more than five")
    else:
        return True
    return False


def _node(event: yaml.ScalarEvent | yaml.CollectionStartEvent, span: Span) -> Node:
    if isinstance(event, yaml.ScalarEvent):
        return Scalar(event.value, span, event.style is None)
    return Sequence(span) if isinstance(event, yaml.SequenceStartEvent) else Mapping(span)


def parse(file: str, text: str, sink: Sink) -> Node | None:
    """The tree of the only document in the text, or None when there is none to go on with."""
    lines = text.split("\n")
    if shown_otherwise(text):
        report_control(file, lines, "a line reads otherwise than it is shown", sink)
        return None
    root: Node | None = None
    stack: list[tuple[Node, Scalar | None]] = []  # container, pending key
    documents = 0
    quoted: Span | None = None
    begun: dict[int, None] = {}  # lines in which a text begins with a sign that is no letter, and no space to YAML
    try:
        for event in yaml.parse(text, Loader=_LOADER):
            if isinstance(event, yaml.DocumentStartEvent):
                documents += 1
                if documents > 1:
                    sink.add(
                        "IL1008",
                        "the file holds more than one document",
                        _span(file, event, lines),
                        "put each layout into a file of its own and remove the line `---`",
                    )
                    return None
                continue
            if isinstance(event, yaml.AliasEvent):
                sink.add("IL1006", f"the alias *{event.anchor} is not allowed", _span(file, event, lines), _WRITE_OUT)
                return None
            if isinstance(event, (yaml.ScalarEvent, yaml.CollectionStartEvent)):
                span = _span(file, event, lines)
                if not _admitted(event, span, len(stack), sink):
                    return None
                node = _node(event, span)
                if not _attach(stack, node, sink):
                    return None
                if not stack and root is None:
                    root = node
                if isinstance(node, Scalar) and node.text[:1].isspace():
                    begun[span.line - 1] = None
                if not isinstance(node, Scalar):
                    stack.append((node, None))
                if isinstance(event, yaml.ScalarEvent) and event.style in ("'", '"'):
                    quoted = span
            elif isinstance(event, yaml.CollectionEndEvent):
                _close(stack.pop()[0], _span(file, event, lines))
    except yaml.MarkedYAMLError as error:
        report_broken(file, lines, error, quoted, sink)
        return None
    except yaml.YAMLError as error:
        report_control(file, lines, str(error).splitlines()[0], sink)
        return None
    if report_indent(file, lines, begun, sink):
        return None
    if root is None or (isinstance(root, Scalar) and not root.text.strip()):
        sink.add("IL1007", "the file is empty", Span(file, 1, 1), _IF_EMPTY.get(PurePath(file).suffix, _IF_EMPTY[""]))
        return None
    return root


_IF_EMPTY = {
    ".pins": "take it from where it is kept; where nothing is wired yet, remove it: `interlock pin` makes another",
    ".dispatch": "`interlock explain dispatch` has its keys",
    "": "`interlock explain IL1007` shows a layout",
}
"""What to do about an empty file, by its ending."""


def _close(node: Node, end: Span) -> None:
    """Let a list or mapping that is written in brackets on one line be marked as a whole."""
    if end.line == node.span.line and end.column > node.span.column:
        node.span = node.span._replace(width=end.column + end.width - node.span.column)


_FIRST = 100
"""Entries among which the first of several keys is looked for that stand beside their names."""


def stands_beside(key: Scalar, name: str, sink: Sink) -> None:
    """Report a key that is indented as the name above, to which it belongs, and so is no part of it."""
    said = f"`{key.text}` stands beside `{name}`, and not below it"
    fix = f"indent what belongs to `{name}` by two more spaces"
    sink.add("IL1005", said, key.span, fix, cause="beside", note=f"{key.text} beside {name}")


def _attach(stack: list[tuple[Node, Scalar | None]], node: Node, sink: Sink) -> bool:
    """Put a node into its container; False when the document cannot be followed further."""
    if not stack:
        return True
    container, key = stack[-1]
    if isinstance(container, Sequence):
        container.items.append(node)
        return True
    assert isinstance(container, Mapping)
    if key is None:
        if not isinstance(node, Scalar):
            sink.add("IL1012", "a key must be a plain text", node.span, "write `key: value`")
            return False
        stack[-1] = (container, node)
        return True
    if key.text in container.items:
        first = container.items[key.text][0].span
        name, (above, value) = next(reversed(container.items.items()))
        before = ""
        if isinstance(value, Scalar) and not value.text and above.span.column == key.span.column:
            for n, (k, v) in islice(container.items.items(), _FIRST):  # the one that came first stands so, too
                if k.text == key.text and before:
                    stands_beside(k, before, sink)
                before = n if isinstance(v, Scalar) and not v.text else before
            stands_beside(key, name, sink)
        else:
            said = f"{key.text} is given twice (first in line {first.line})"
            sink.add("IL1005", said, key.span, "keep one of them, or rename one")
    else:
        container.items[key.text] = (key, node)
    stack[-1] = (container, None)
    return True
