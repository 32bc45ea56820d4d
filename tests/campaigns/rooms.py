"""Count the rooms of the house: lines of essential logic and of optimisation in each room of a version, arrows between
rooms, and the longest functions and largest classes.

python -m tests.campaigns.rooms [OLDER] [--write]

OLDER is a folder with an older version of the project (`git archive COMMIT | tar x -C OLDER`), counted by the same
rules; --write writes proofs/house.md.  A line is one with code: no blank line, no comment, no docstring.
*Optimisation* is what decides only how soon an answer is there: `OPTIMISATION` lists its modules, by the names of both
versions; a module on it could be deleted, with the callers that choose it, and every verdict would be the same.
"""

from __future__ import annotations

import argparse
import ast
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path

from tests.campaigns.origin import origin

TOP = Path(__file__).resolve().parents[2]
PAGE = TOP / "proofs" / "house.md"
PUBLIC = 15
"""Members of a class that are no surprise."""
LINES = 60
"""Lines of a function, with its docstring."""
WORD = "w_"
"""How the methods of the second checker begin that are words of its specification: they are looked up by the word as it
stands in `spec/*.yaml`, and are no interface of a class."""

OPTIMISATION = frozenset(
    f"proof/{name}.py"
    for name in (
        *("abstraction/canonical", "abstraction/focus", "abstraction/indexed", "abstraction/local"),
        *(
            "abstraction/queries",
            "abstraction/quotient",
            "engines/batch",
            "engines/by_kind",
            "engines/cache",
            "engines/plaisted_greenbaum",
        ),
        *("engines/pool", "induction/one_state", "induction/parts", "system/neighbourhood"),
        *("certificate/library", "certificate/shapes", "mutation/patterns", "mutation/switched"),
        *("alike", "scenes", "members", "views", "looks", "sight", "asking", "cache", "onesided", "pool", "states"),
        *("parts", "near", "local/library", "local/shapes"),
    )
) | {"logic/bits.py", "logic/compile.py"}

OUT = frozenset({"logic/compile.py", "proof/certificate/library.py", "proof/certificate/shapes.py"})
"""Those of them that this version has no more."""


RECORDS = {
    "frontend/schema.py LayoutFile": (
        36,
        "the keys of a layout file, each with its meaning: the schema is made from it",
    ),
    "frontend/principles.py PrinciplesSpec": (33, "the keys under `principles`, each with its meaning"),
    "model/principles.py Principles": (33, "the same keys with their values, as a profile has them"),
}
"""Records with more than PUBLIC fields, and what flat form each has outside of the program.  Numbers only fall."""

LARGE: dict[str, tuple[int, str]] = {}
"""Classes with more than PUBLIC members that are more than fields, each with its reason.  Numbers only fall."""


@dataclass
class Room:
    """A folder with what it holds; `arrows`: rooms that it imports, and by how many modules."""

    modules: int = 0
    essential: int = 0
    optimisation: int = 0
    arrows: Counter[str] = field(default_factory=Counter)


@dataclass(frozen=True, slots=True)
class Size:
    """A function by its lines, or a class by its public members, inherited ones too.

    record: all of them are fields, whose names are its purpose; what has a method or property beside them is none.
    """

    module: str
    name: str
    size: int
    record: bool = False


@dataclass
class House:
    """A version of the project."""

    rooms: dict[str, Room] = field(default_factory=dict)
    functions: list[Size] = field(default_factory=list)
    classes: list[Size] = field(default_factory=list)
    words: int = 0

    @property
    def essential(self) -> int:
        """Lines of essential logic."""
        return sum(r.essential for r in self.rooms.values())

    @property
    def optimisation(self) -> int:
        """Lines of optimisation."""
        return sum(r.optimisation for r in self.rooms.values())


def room_of(module: str) -> str:
    """The room of a module: its folder; in the proof a folder of that."""
    parts = module.split("/")
    return "/".join(parts[:2]) if parts[0] == "proof" and len(parts) > 2 else parts[0] if len(parts) > 1 else "."


def code_lines(text: str, tree: ast.Module) -> int:
    """Lines that hold code."""
    told: set[int] = set()
    for node in ast.walk(tree):
        if isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant) and isinstance(node.value.value, str):
            told.update(range(node.lineno, (node.end_lineno or node.lineno) + 1))
    lines = enumerate(text.splitlines(), 1)
    return sum(1 for n, line in lines if n not in told and line.strip() and not line.strip().startswith("#"))


def imported(tree: ast.Module, modules: set[str]) -> Iterator[str]:
    """The modules of the project that a module imports."""
    for node in ast.walk(tree):
        names = [a.name for a in node.names] if isinstance(node, ast.Import) else []
        if isinstance(node, ast.ImportFrom) and node.module and not node.level:
            names = [node.module, *(f"{node.module}.{a.name}" for a in node.names)]
        for name in names:
            path = name.removeprefix("interlock.").replace(".", "/")
            for found in (f"{path}.py", f"{path}/__init__.py"):
                if name.startswith("interlock.") and found in modules:
                    yield found


def _put_into_self(method: ast.FunctionDef) -> Iterator[str]:
    for node in ast.walk(method):
        targets: list[ast.expr] = []
        if isinstance(node, ast.AnnAssign):
            targets = [node.target]
        elif isinstance(node, ast.Assign):
            targets = [y for x in node.targets for y in (x.elts if isinstance(x, ast.Tuple) else [x])]
        for x in targets:
            if isinstance(x, ast.Attribute) and isinstance(x.value, ast.Name) and x.value.id == "self":
                yield x.attr


def public_members(node: ast.ClassDef) -> set[str]:
    """Methods and attributes of a class that others may use: of its body, and what they put into `self`."""
    names: set[str] = set()
    for x in node.body:
        if isinstance(x, ast.FunctionDef | ast.AsyncFunctionDef):
            names |= {x.name, *_put_into_self(x)}
        elif isinstance(x, ast.AnnAssign) and isinstance(x.target, ast.Name):
            names.add(x.target.id)
    return {n for n in names if not n.startswith(("_", WORD))}


def is_record(node: ast.ClassDef) -> bool:
    """All that the body of a class has is fields: no method, no property."""
    return not any(isinstance(x, ast.FunctionDef | ast.AsyncFunctionDef) for x in node.body)


def _inherited(node: ast.ClassDef, known: dict[str, ast.ClassDef]) -> Iterator[ast.ClassDef]:
    """A class and those of the project from which it inherits."""
    yield node
    for base in node.bases:
        name = base.attr if isinstance(base, ast.Attribute) else base.id if isinstance(base, ast.Name) else ""
        if name in known and known[name] is not node:
            yield from _inherited(known[name], known)


def sizes(trees: dict[str, ast.Module], house: House) -> None:
    """The functions and classes of all modules."""
    classes = [(m, n) for m, tree in trees.items() for n in ast.walk(tree) if isinstance(n, ast.ClassDef)]
    times = Counter(n.name for _, n in classes)
    for module, node in classes:
        here = {n.name: n for m, n in classes if m == module or times[n.name] == 1}
        line = list(_inherited(node, here))
        members = {name for x in line for name in public_members(x)}
        house.classes.append(Size(module, node.name, len(members), all(map(is_record, line))))
        house.words += sum(isinstance(x, ast.FunctionDef) and x.name.startswith(WORD) for x in node.body)
    for module, tree in trees.items():
        for f in ast.walk(tree):
            if isinstance(f, ast.FunctionDef | ast.AsyncFunctionDef):
                house.functions.append(Size(module, f.name, (f.end_lineno or f.lineno) - f.lineno + 1))


def counted(top: Path) -> House:
    """A version of the project, counted."""
    root = top / "interlock"
    paths = {str(p.relative_to(root)): p for p in sorted(root.rglob("*.py"))}
    house = House()
    trees: dict[str, ast.Module] = {}
    for module, path in paths.items():
        text = path.read_text("utf-8")
        tree = trees[module] = ast.parse(text)
        here = room_of(module)
        room = house.rooms.setdefault(here, Room())
        room.modules += 1
        lines = code_lines(text, tree)
        if module in OPTIMISATION:
            room.optimisation += lines
        else:
            room.essential += lines
        room.arrows.update({room_of(m) for m in imported(tree, set(paths))} - {here, "."})
    sizes(trees, house)
    return house


def _arrows(house: House, within: str) -> Iterator[str]:
    for name, room in sorted(house.rooms.items()):
        if name.startswith(within) and room.arrows:
            yield f"| {name} | {', '.join(sorted(room.arrows))} |"


_COUNTED = (
    "A class is counted with what it inherits; a member is a method or an attribute whose name has no underscore",
    "before it.  A *record* has fields and nothing else.  The words of the second checker's specification, methods",
    "`w_...` that are looked up by name as `spec/*.yaml` writes them, are no members.  `tests/test_rooms.py` holds",
    "the lists of what is larger: they only shrink.",
)


def page(before: House | None, now: House) -> str:
    """proofs/house.md."""
    out = [
        "# The house, counted",
        "",
        f"`python -m tests.campaigns.rooms OLDER --write` {origin()}; *before*: version 302fa70.",
        "Lines with code: no blank lines, comments, docstrings.  *Optimisation* decides only how soon an answer is",
        "there; the script lists its modules.",
        "",
        "| room | modules | essential | optimisation | before: modules | essential | optimisation |",
        "|---|--:|--:|--:|--:|--:|--:|",
    ]
    older = before or House()
    for name in sorted({*now.rooms, *older.rooms}):
        a, b = now.rooms.get(name), older.rooms.get(name)
        cells = [f"{x.modules} | {x.essential} | {x.optimisation}" if x else "- | - | -" for x in (a, b)]
        out.append(f"| {name} | {' | '.join(cells)} |")
    totals = [f"{sum(r.modules for r in h.rooms.values())} | {h.essential} | {h.optimisation}" for h in (now, older)]
    out += [f"| **all** | {' | '.join(totals)} |", "", "## Arrows", ""]
    for title, house in (("now", now), ("before", older)):
        arrows = sum(len(r.arrows) for r in house.rooms.values())
        inside = sum(
            1 for n, r in house.rooms.items() if n.startswith("proof/") for m in r.arrows if m.startswith("proof/")
        )
        out.append(f"- {title}: {arrows} between rooms, {inside} of them between rooms of the proof")
    out += ["", "| room of the proof | imports |", "|---|---|", *_arrows(now, "proof"), "", "## Sizes", ""]
    out += ["| | now | before |", "|---|--:|--:|"]
    for words, of in (("in `proof/` and `logic/`", ("proof/", "logic/")), ("in all rooms", ("",))):
        long = [sum(f.size > LINES for f in h.functions if f.module.startswith(of)) for h in (now, older)]
        large = [
            sum(c.size > PUBLIC for c in h.classes if not c.record and c.module.startswith(of)) for h in (now, older)
        ]
        out.append(f"| functions over {LINES} lines {words} | {long[0]} | {long[1]} |")
        out.append(f"| classes with more than {PUBLIC} public members {words} | {large[0]} | {large[1]} |")
    flat = [sum(c.size > PUBLIC for c in h.classes if c.record) for h in (now, older)]
    out.append(f"| records with more than {PUBLIC} fields | {flat[0]} | {flat[1]} |")
    out.append(f"| words of the second checker's specification | {now.words} | {older.words} |")
    out += ["", *_COUNTED, ""]
    if LARGE:
        out += ["| class | members | why |", "|---|--:|---|"]
        out += [f"| {name} | {size} | {why} |" for name, (size, why) in sorted(LARGE.items())]
    else:
        out.append(f"No class that is more than a record has more than {PUBLIC} members.")
    out += ["", "| record | fields | what it is |", "|---|--:|---|"]
    out += [f"| {name} | {size} | {why} |" for name, (size, why) in sorted(RECORDS.items())]
    return "\n".join(out) + "\n"


def main() -> None:
    """Count, and say or write it."""
    parser = argparse.ArgumentParser()
    parser.add_argument("older", nargs="?", type=Path)
    parser.add_argument("--write", action="store_true")
    given = parser.parse_args()
    text = page(counted(given.older) if given.older else None, counted(TOP))
    if given.write:
        PAGE.write_text(text, "utf-8")
    else:
        print(text)


if __name__ == "__main__":
    main()
