"""Functions and classes stay small, the modules of the proof begin with their theorem, and the script counts right."""

from __future__ import annotations

import ast
from pathlib import Path

import pytest

from tests.campaigns.rooms import (
    LINES,
    OPTIMISATION,
    OUT,
    PUBLIC,
    TOP,
    House,
    code_lines,
    counted,
    public_members,
)

LARGE = {
    "proof/system/transition.py": {"System": 28},
}
"""Classes of logic and proof with more public members than a reader takes in at once.  Numbers only fall."""


@pytest.fixture(scope="module")
def house() -> House:
    return counted(TOP)


def test_no_function_is_too_long(house: House) -> None:
    long = [f for f in house.functions if f.size > LINES]
    assert long == []


def test_no_class_of_logic_and_proof_grows(house: House) -> None:
    found: dict[str, dict[str, int]] = {}
    for c in house.classes:
        if c.size > PUBLIC and c.module.startswith(("logic/", "proof/")):
            found.setdefault(c.module, {})[c.name] = c.size
    assert found == LARGE


@pytest.mark.parametrize("room", ["abstraction", "induction"])
def test_every_module_begins_with_the_theorem_that_makes_it_sound(room: str) -> None:
    for path in sorted((TOP / "interlock" / "proof" / room).glob("*.py")):
        said = ast.get_docstring(ast.parse(path.read_text("utf-8"))) or ""
        if path.name != "__init__.py":
            theorem = said.partition("**Theorem.**")[2]
            assert theorem.count("(") >= 1 and len(theorem) > 120, path.name


def test_every_module_of_optimisation_is_there(house: House) -> None:
    """Of each module on the list there is the one of this version, or it is a name of an older one."""
    there = [m for m in OPTIMISATION if (TOP / "interlock" / m).exists()]
    older = [m for m in OPTIMISATION if (m.count("/") == 1 and m.startswith("proof/")) or m.startswith("proof/local/")]
    assert len(there) + len(older) + len(OUT) == len(OPTIMISATION) and not OUT & {*there}
    assert sum(r.optimisation for r in house.rooms.values()) > 1000


TEXT = '''"""What it is."""

# a comment
import os


class A:
    """Some."""

    x: int
    _y: int

    def __init__(self) -> None:
        self.z, self._w = 1, 2
        self.v: int = 3

    def told(self) -> str:
        """More."""
        return "text"
'''


def test_lines_and_members_are_counted() -> None:
    tree = ast.parse(TEXT)
    (made,) = (x for x in tree.body if isinstance(x, ast.ClassDef))
    assert (code_lines(TEXT, tree), public_members(made)) == (9, 4)


def test_rooms_and_arrows_are_counted(tmp_path: Path) -> None:
    for name, text in {
        "a/one.py": "from interlock.b.two import x\n",
        "b/two.py": "x = 1\n",
        "proof/c/three.py": "import interlock.a.one\nfrom interlock.b import two\n",
        "proof/alike.py": "y = 2\n",
    }.items():
        path = tmp_path / "interlock" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
    found = counted(tmp_path)
    assert {n: sorted(r.arrows) for n, r in found.rooms.items()} == {
        "a": ["b"],
        "b": [],
        "proof": [],
        "proof/c": ["a", "b"],
    }
    assert (found.essential, found.optimisation) == (4, 1)
