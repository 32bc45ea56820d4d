"""What is said twice, and parts that say nothing: neither has an effect, and something else was probably meant.
IL1022, IL1023."""

from __future__ import annotations

from collections.abc import Iterator

from interlock.frontend.context import Context
from interlock.frontend.examples import EXAMPLES, WHOLE
from interlock.frontend.yaml_tree import Mapping, Node, Scalar, Sequence
from interlock.model.layout import Layout

NAMES = frozenset(
    {"sections", "over", "via", "not_via", "not_over", "at", "signals", "exits", "machines", "buffers", "traps"}
)
"""Keys with lists of names, each of which counts once."""
ENTRIES = ("exclude", "hostile", "demand", "waive")
"""Keys of the layout with entries in a list; of `automatic` it counts which routes are meant: `derivation/named.py`."""


def check_repeated(ctx: Context, layout: Layout) -> None:
    """Report names that stand twice in a list, entries that are given twice, and parts of the file that are empty."""
    del layout
    if not isinstance(ctx.root, Mapping):
        return
    for key, where, names in _lists(ctx.root):
        first: dict[str, Scalar] = {}
        for x in names.items:
            if isinstance(x, Scalar) and first.setdefault(x.text, x) is not x:
                said = f"{where}: {x.text} is named twice"
                ctx.add("IL1022", said, x.span, "name it once, or correct one of the two", cause=f"{key} {where}")
    for room in ENTRIES:
        part = ctx.root.items.get(room)
        seen: dict[str, int] = {}
        for i, entry in enumerate(part[1].items if part is not None and isinstance(part[1], Sequence) else ()):
            if seen.setdefault(_told(entry), i) != i:
                said = f"`{room}`: this entry says what the one in line {ctx.at(room, seen[_told(entry)]).line} says"
                ctx.add("IL1022", said, ctx.at(room, i), "remove one of them, or correct what was meant otherwise")
    for room in sorted(WHOLE):
        part = ctx.root.items.get(room)
        if part is not None and isinstance(part[1], Mapping) and not part[1].items:
            fix = f"write what there is to say, for instance `{room}: {EXAMPLES[room]}`, or remove it"
            ctx.add("IL1023", f"`{room}` says nothing", ctx.at_key(room), fix)


def _lists(root: Mapping) -> Iterator[tuple[str, str, Sequence]]:
    """Every list of names: its key, where it is, and what stands in it."""
    left: list[tuple[str, str, Node]] = [("", "", root)]
    while left:
        key, where, node = left.pop()
        if isinstance(node, Mapping):
            left += [(k, f"{where}.{k}" if where else k, x) for k, (_, x) in reversed(node.items.items())]
        elif isinstance(node, Sequence):
            if key in NAMES:
                yield key, where, node
            left += [("", where, x) for x in reversed(node.items) if not isinstance(x, Scalar)]


def _told(node: Node) -> str:
    """What an entry says, but for its reason, in whatever order."""
    if isinstance(node, Scalar):
        return repr(node.text)
    if isinstance(node, Sequence):
        return f"[{', '.join(sorted(map(_told, node.items)))}]"
    return f"{{{', '.join(sorted(f'{k}: {_told(x)}' for k, (_, x) in node.items.items() if k != 'reason'))}}}"
