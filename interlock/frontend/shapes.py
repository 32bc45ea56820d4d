"""What the schema finds wrong, in the words of the file's author: what is there, what is wanted, how it is written.

Input: the errors of pydantic and the tree.  Output: diagnostics IL1010-IL1017, IL2009; a slip that is made in many
places is one diagnostic, and what follows from a slip (a key that is missing because it is misspelt) is none.
"""

from __future__ import annotations

import re
from collections.abc import Mapping as Map
from typing import Any

from pydantic import ValidationError

from interlock.diag import Sink, Span
from interlock.diag.suggest import Suggestion, did_you_mean, nearest
from interlock.frontend.examples import BARE, EXAMPLES, LISTS, WHOLE, example_at
from interlock.frontend.scalars import NAME, QUANTITIES, number_fix, number_text
from interlock.frontend.signs import CLOSING, OPENING, spelled
from interlock.frontend.yaml_tree import Mapping, Node, Scalar, Sequence, stands_beside

Loc = tuple[str | int, ...]

_CODES = {
    "missing": "IL1010",
    "extra_forbidden": "IL1011",
    "number": "IL1013",
    "range": "IL1014",
    "version": "IL1015",
    "sign": "IL1012",
    "name": "IL1016",
    "choice": "IL1017",
    "reason": "IL2009",
    "address": "IL2021",
}
_WANT = {
    "dict_type": "a mapping",
    "model_type": "a mapping",
    "model_attributes_type": "a mapping",
    "list_type": "a list",
    "string_type": "a text",
    "shape": "a text",
    "too_short": "a list of two",
    "too_long": "a list of two",
}
_FIX = {
    "IL1013": "write metres or seconds as a plain decimal number, for instance 350 or 12.5",
    "IL1014": "give a length above 0 and at most 100 km, or a time above 0 and at most a day",
    "IL1015": "this release reads `interlock: 1`",
    "IL1016": "letters and digits, single spaces or _ - / between them, # after them; `title` takes any text",
    "IL2009": "say why",
}
_REASON = {
    "waive": "say why a vehicle can never roll from there",
    "exclude": "say why there shall be no such route",
    "hostile": "say why the routes must not be set together",
    "demand": "say why the routes need the point to lie so",
    "allow": "say why it is meant so here",
}


def span_of(root: Node, path: Loc, *, key: bool = False) -> Span:
    """The place of the value (or key) at a path; the nearest enclosing node when the path ends early."""
    node: Node = root
    span = root.span
    for step in path:
        if isinstance(node, Mapping) and str(step) in node.items:
            k, node = node.items[str(step)]
            span = k.span if key or not isinstance(node, Scalar) or not node.text else node.span
        elif isinstance(node, Sequence) and isinstance(step, int) and step < len(node.items):
            node = node.items[step]
            span = node.span
        else:
            break
    return span


def report_shape(root: Node, error: ValidationError, keys: Map[str, tuple[str, ...]], sink: Sink) -> None:
    """Every error of shape as a diagnostic at its place; `keys`: the known keys of each room, "" for the file's."""
    beside = _beside(root, keys, sink)
    errors = error.errors(include_url=False, include_input=False)
    paths = [(e, tuple(p for p in e["loc"] if not _inner(p))) for e in errors]
    paths = [(e, path) for e, path in paths if path[:2] not in beside]
    misspelt: set[Loc] = set()
    for e, path in paths:
        if e["type"] == "extra_forbidden":
            known = keys.get(str(path[0]) if len(path) > 1 else "", ())
            meant = _unknown_key(root, path, known, keys, sink)
            if meant is not None:
                misspelt.add((*path[:-1], meant))
    for e, path in paths:
        if e["type"] == "missing":
            if path not in misspelt:
                _missing(root, path, sink)
        elif e["type"] != "extra_forbidden":
            _value(root, e["type"], path, "[key]" in e["loc"], e["msg"], e.get("ctx", {}), sink)


def _beside(root: Node, keys: Map[str, tuple[str, ...]], sink: Sink) -> set[Loc]:
    """Report keys of entries that stand beside the name of theirs instead of below it; those places, and the names'."""
    found: set[Loc] = set()
    rooms = root.items.items() if isinstance(root, Mapping) else ()
    for room, (_, part) in rooms:
        name = ""
        for key, (at, value) in part.items.items() if isinstance(part, Mapping) else ():
            if isinstance(value, Scalar) and not value.text:
                name = key
            elif name and key in keys.get(room, ()) and not isinstance(value, Mapping):
                stands_beside(at, name, sink)
                found |= {(room, name), (room, key)}
            else:
                name = ""
    return found


def _inner(part: str | int) -> bool:
    """A step of pydantic's own, not of the file."""
    return part == "[key]" or (isinstance(part, str) and part.startswith("function-"))


def _unknown_key(
    root: Node, path: Loc, known: tuple[str, ...], keys: Map[str, tuple[str, ...]], sink: Sink
) -> str | None:
    """Report a key that nobody knows; the key that was meant, if that is plain."""
    key, span, value = str(path[-1]), span_of(root, path, key=True), node_at(root, path)
    before, _, rest = key.partition(":")
    if rest and before in known:  # `from:q3`
        fix = f"write `{before}: {rest}`"
        sink.add("IL1011", f"a space is missing after `{before}:`", span, fix, cause="space", note=f"`{key}`")
        return before
    if number_text(key) and isinstance(value, Scalar) and not value.text:  # `legs: 30,5`
        whole = _before(root, path)
        if whole is not None and whole[1].text.isdigit():
            name, number = whole
            text = f"{number.text},{key}"
            place = Span(span.file, number.span.line, number.span.column, len(text))
            said = f"{'.'.join(map(str, (*path[:-1], name)))}: '{text}' is not a number"
            sink.add("IL1013", said, place, number_fix(text), cause="a decimal comma", note=text)
            return None
    before, equals, rest = (part.strip() for part in key.partition("="))
    if equals and before in known:  # `from = q3`
        fix = f"write `{before}: {rest}`"
        sink.add("IL1011", f"a colon is wanted after `{before}`, not `=`", span, fix, cause="equals", note=f"`{key}`")
        return before
    before, wide, rest = (part.strip() for part in key.partition("："))
    if wide and before in known:  # `from：q3`
        fix = f"write `{before}: {spelled(rest)}`"
        said = "the full-width sign `：` ends no key"
        sink.add("IL1011", said, span, fix, cause="full-width", note=f"`{key}`")
        return before
    if key.startswith(("//", ";", "--")):
        sink.add("IL1011", "a comment begins with `#`", span, "write `#` before it", cause="comment", note=f"`{key}`")
        return None
    if key.lower() in known:
        said = f"unknown key `{key}`: keys are written in small letters"
        sink.add("IL1011", said, span, f"write `{key.lower()}`", cause="capitals", note=f"`{key}`")
        return key.lower()
    meant = did_you_mean(key, known, _known_keys(path, known))
    words = _before(root, path) if isinstance(value, Scalar) and not value.text else None
    if words is not None and words[0] in TEXTS and nearest(key, known) is None:  # `reason: short, steep`
        said = f"the comma ends the text of `{words[0]}`, and `{key}` is no key"
        quoted = f'put the text in quotes: `{words[0]}: "{words[1].text}, {key}"`'
        sink.add("IL1011", said, span, quoted, cause="a comma in a text", note=f"`{key}`")
        return None
    if SAME.get(key.lower()) in known:
        sink.add("IL1011", f"unknown key `{key}`", span, f"did you mean {SAME[key.lower()]}?")
        return SAME[key.lower()]
    elsewhere = _elsewhere(path, keys)
    sink.add("IL1011", f"unknown key `{key}`", span, elsewhere or meant)
    return None if elsewhere else nearest(key, known)


SAME = {"type": "kind", "entry": "from", "exit": "to", "comment": "reason", "description": "text", "position": "lies"}
"""Words of other languages of layouts, and ours."""


def _elsewhere(path: Loc, keys: Map[str, tuple[str, ...]]) -> str:
    """Where a key belongs that is none at this place, but one of the file, of an entry of another part, or (`overlap`)
    the name of a part."""
    key = str(path[-1])
    part = next((p for p in (key, f"{key}s") if p in keys[""] and p in EXAMPLES), "")
    if len(path) > 1 and part:
        entry = EXAMPLES[part] if part in WHOLE else f"[{EXAMPLES[part]}]"
        if part not in WHOLE | LISTS:
            entry = f"{{{path[1] if len(path) > 2 else 'NAME'}: {EXAMPLES[part]}}}"
        return f"`{part}` is a key of the file: write it there, for instance `{part}: {entry}`"
    if len(path) == 1:
        if key in keys.get("principles", ()):
            return f"write it under `principles`, for instance `principles: {{{key}: ...}}`"
        return ""
    if key in keys.get("principles", ()):
        return f"`{key}` is a principle of the whole layout: write it under `principles`"
    rooms = [f"`{room}`" for room, known in keys.items() if room and key in known]
    where = "the file" if key in keys[""] else f"an entry of {' or '.join(rooms)}" if 0 < len(rooms) <= 3 else ""
    return f"{_known_keys(path, keys.get(str(path[0]), ()))}; `{key}` belongs to {where}" if where else ""


TEXTS = frozenset({"label", "reason", "text", "title", "button", "company", "author", "number", "revision", "date"})
"""Keys whose values are free text."""


def _known_keys(path: Loc, known: tuple[str, ...]) -> str:
    where = "the file" if len(path) == 1 else f"`{path[0]}`" if path[0] in WHOLE else f"an entry of `{path[0]}`"
    return f"the keys of {where}: {', '.join(known)}"


def _before(root: Node, path: Loc) -> tuple[str, Scalar] | None:
    """The key before the one at a path, with its value, if that is a scalar."""
    room = node_at(root, path[:-1])
    if not isinstance(room, Mapping):
        return None
    names = list(room.items)
    at = names.index(str(path[-1]))
    value = room.items[names[at - 1]][1] if at else None
    return (names[at - 1], value) if isinstance(value, Scalar) else None


def _missing(root: Node, path: Loc, sink: Sink) -> None:
    where, key = ".".join(map(str, path[:-1])) or "the file", str(path[-1])
    fix = "add `interlock: 1` as the first line" if path == ("interlock",) else f"add `{key}: ...`"
    room = str(path[0]) if len(path) > 1 else ""
    span = span_of(root, path[:-1], key=True)
    sink.add("IL1010", f"{where} lacks the key `{key}`", span, fix, cause=f"{room} {key}", note=where)


def _value(root: Node, kind: str, path: Loc, on_key: bool, text: str, ctx: Map[str, Any], sink: Sink) -> None:
    """Report a value (or key) that has the wrong shape, or cannot be."""
    code, where = _CODES.get(kind, "IL1012"), ".".join(map(str, path))
    if code == "IL1012" and kind != "sign":
        want = "a list of at least one" if ctx.get("min_length") == 1 else _WANT.get(kind, "another shape")
        node = node_at(root, path)
        fix = _shape_fix(path, want, node)
        said = f"{where}: {want} is expected here, not {_told(node)}"
        cause = "brackets" if want == "a text" and isinstance(node, Sequence) and len(node.items) == 1 else ""
        sink.add(code, said, _shown(root, path, node), fix, cause=cause, note=where)
        return
    value = str(ctx.get("v", ""))
    advice: str | Suggestion = ctx.get("fix", _FIX.get(code, ""))
    if code == "IL1017":
        advice = _one_of(value, ctx.get("known", ()))
    elif kind == "number" and (wanted := _quantity(path)):
        advice = number_fix(value, wanted) or QUANTITIES[wanted]
    elif code == "IL2009":
        advice = _REASON.get(str(path[0]), advice)
    cause = ctx.get("cause", "")
    if code in ("IL1016", "IL1017") and value:  # one name or word that cannot be, wherever it is used
        cause = f"{text} {value}"
    sink.add(code, f"{where}: {text}", span_of(root, path, key=on_key), advice, cause=cause, note=f"{where}: {value}")


def _quantity(path: Loc) -> str:
    """What a principle counts, as its name says; empty for others."""
    of = {"m": "metres", "s": "seconds", "kmh": "km/h"}
    return of.get(str(path[-1]).rpartition("_")[2], "") if path[0] == "principles" else ""


_PAIR = re.compile(r"[12][ab]-[12][ab]")
"""Two ends of a slip: in whichever order, and no other pair is as good as them."""


def _one_of(value: str, known: tuple[str, ...]) -> str | Suggestion:
    """Which word is meant; all of them where there are few, and none is the very one in other letters."""
    pairs = {frozenset(k.split("-")): k for k in known if _PAIR.fullmatch(k)}
    meant = pairs.get(frozenset(value.strip().lower().split("-"))) if pairs else nearest(value, known)
    if pairs and meant is None:
        return f"known here: {', '.join(sorted(known))}"
    if meant is None or meant.lower() == value.strip().lower() or len(known) > 8:
        return did_you_mean(value, known)
    return f"did you mean {meant}?  Known here: {', '.join(sorted(known))}"


def _shown(root: Node, path: Loc, node: Node) -> Span:
    """The value itself where it is something written in one line, else its key."""
    key = span_of(root, path)
    return node.span if not isinstance(node, Scalar) and node.span.line == key.line else key


def _shape_fix(path: Loc, want: str, node: Node) -> str:
    """How a value of another shape is written."""
    key = next((str(p) for p in reversed(path) if isinstance(p, str)), "")
    in_list = bool(path) and isinstance(path[-1], int)
    if want == "a list of two":
        return f"write two: `{key}: [one, other]`"
    if want == "a list of at least one":
        return f"write `{key}: [one]`, or several with commas"
    if want == "a text" and isinstance(node, Sequence) and node.items and isinstance(node.items[0], Scalar):
        one = node.items[0].text
        second = node.items[1] if len(node.items) == 2 else None
        measured = in_list or key == "approach"
        if measured and isinstance(second, Scalar) and number_text(second.text):  # `approach: [ap_W, 600]`
            one, only = f"{one} {second.text}", ""
        else:
            one_thing = "; one signal is expected here" if key == "of" else "; only one can stand here"
            only = "" if len(node.items) == 1 else one_thing
        return f"write `{one if in_list else f'{key}: {one}'}`, without the brackets{only}"
    if want == "a text" and isinstance(node, Mapping) and len(node.items) == 1:
        ((name, (_, value)),) = node.items.items()
        if isinstance(value, Scalar):
            return f"write `{name} {value.text}` as one text, without the braces"
    if want == "a text":
        return "write one text"
    if want == "a list":
        inside = _bare(node.text) if isinstance(node, Scalar) else _listed(path, node)
        return f"write `{key}: [{inside}]`, in square brackets" if inside else f"write `{key}: [{_item_of(path)}]`"
    if isinstance(node, Scalar) and not node.text:
        return (
            f"write its entries below, indented by two more spaces, or remove `{key}`"
            if len(path) < 2
            else _filled(path, key)
        )
    if isinstance(node, Sequence) and len(path) < 2:
        first = node.items[0] if node.items else node
        named = first.items.get("name") if isinstance(first, Mapping) else None
        called = named[1] if named is not None else first
        shown = called.text if isinstance(called, Scalar) and NAME.fullmatch(called.text) else "name"
        return f"write `{shown}: {{...}}` lines below `{key}`: the name of each before its values, no dashes"
    if isinstance(node, Scalar) and node.text[:1] in OPENING and node.text[-1:] in CLOSING:
        inner = spelled(node.text)
        if all(": " in part for part in inner.split(", ")):
            return f"write `{key}: {{{inner}}}`, in braces"
    example = example_at(path) or f"{key}: {{key: value, ...}}"
    return f"write it like `{example}`; `interlock explain IL1012` shows the shapes"


def _item_of(path: Loc) -> str:
    """What may stand in a list that was left empty."""
    return {"tracks": "q1 400", "substations": "q1, X1"}.get(str(path[0]), "...") if len(path) == 2 else "..."


def _filled(path: Loc, key: str) -> str:
    """How an entry is written that was left empty."""
    example = example_at(path)
    if example and len(path) == 2 and path[0] in BARE:
        return f"write `{key}: {{}}`, or with what there is to say, for instance `{example}`"
    return f"write it like `{example}`, below the name or in braces" if example else f"write `{key}: {{}}`"


def _listed(path: Loc, node: Node) -> str:
    """What a mapping says where a list is wanted, in one line: an entry of its own, names, or the items of a track."""
    if not isinstance(node, Mapping) or not node.items:
        return ""
    if len(path) == 2 and path[0] == "tracks":  # `{W: , q1: 400}`
        flat = {k: v.text for k, (_, v) in node.items.items() if isinstance(v, Scalar)}
        return ", ".join(f"{k} {v}".strip() for k, v in flat.items()) if len(flat) == len(node.items) else ""
    if path[0] in EXAMPLES:  # one entry, of which there may be several
        return _flow(node)
    return ", ".join(node.items) if all(not isinstance(v, Sequence) for _, v in node.items.values()) else ""


def _flow(node: Node) -> str:
    """A node in one line, as it would be written in brackets."""
    if isinstance(node, Scalar):
        return f'"{node.text}"' if set(node.text) & set(",:#[]{}") else node.text
    if isinstance(node, Sequence):
        return f"[{', '.join(map(_flow, node.items))}]"
    return f"{{{', '.join(f'{k}: {_flow(v)}' for k, (_, v) in node.items.items())}}}"


def _bare(text: str) -> str:
    """A text without brackets of another kind around it, and with the commas of YAML."""
    return text[1:-1].strip() if text[:1] + text[-1:] == "<>" else spelled(text)


def node_at(root: Node, path: Loc) -> Node:
    """The node at a path, or the nearest one that encloses it."""
    node: Node = root
    for step in path:
        if isinstance(node, Mapping) and str(step) in node.items:
            node = node.items[str(step)][1]
        elif isinstance(node, Sequence) and isinstance(step, int) and step < len(node.items):
            node = node.items[step]
        else:
            break
    return node


def _told(node: Node) -> str:
    if isinstance(node, Scalar):
        return f"the text '{node.text[:40]}'" if node.text else "nothing"
    if isinstance(node, Mapping):
        return "a mapping"
    items = [n.text for n in node.items if isinstance(n, Scalar)]
    if len(items) == len(node.items) and 0 < len(items) <= 3:
        return f"the list [{', '.join(items)}]"
    return f"a list of {len(node.items)}"
