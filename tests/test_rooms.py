"""Functions and classes stay small, the modules of the proof begin with their theorem, and the script counts right."""

from __future__ import annotations

import ast
from pathlib import Path

import pytest

from tests.campaigns.rooms import (
    LARGE,
    LINES,
    OPTIMISATION,
    OUT,
    PAGE,
    PUBLIC,
    RECORDS,
    TOP,
    House,
    code_lines,
    counted,
    is_record,
    public_members,
)


@pytest.fixture(scope="module")
def house() -> House:
    return counted(TOP)


def test_no_function_is_too_long(house: House) -> None:
    long = [f for f in house.functions if f.size > LINES]
    assert long == []


def test_no_class_grows(house: House) -> None:
    """Every class with many members is on a list, with its number and a reason; nothing is on it that is small."""
    for listed, record in ((LARGE, False), (RECORDS, True)):
        found = {f"{c.module} {c.name}": c.size for c in house.classes if c.size > PUBLIC and c.record is record}
        assert found == {name: size for name, (size, _) in listed.items()}
        assert all(len(why) > 20 for _, why in listed.values())


def test_the_lists_only_shrink() -> None:
    assert LARGE == {}
    assert sum(size for size, _ in RECORDS.values()) <= 102 and len(RECORDS) <= 3


def test_the_page_is_of_this_version(house: House) -> None:
    """The lists of proofs/house.md are those that are held here."""
    told = PAGE.read_text("utf-8")
    for name, (size, why) in {**LARGE, **RECORDS}.items():
        assert f"| {name} | {size} | {why} |" in told, name


NO_THEOREM = {
    "claims": "says what is claimed, which is read and not derived: the theorem of the package",
    "functions": "says what must happen, which is read and not derived: the theorem of the package",
    "engines/answer.py": "the three answers",
    "engines/limits.py": "numbers that the user gives",
    "engines/pool.py": "who does the work, not what it is",
    "engines/minisat.py": "a foreign solver behind one question",
    "engines/z3_sat.py": "a foreign solver behind one question",
    "engines/cvc5_sat.py": "a foreign solver behind one question",
    "witnesses/opening.py": "a number of scans to which runs are held",
    "mutation/campaign.py": "keeps verdicts; which of them are right is the judge's",
    "mutation/lines.py": "lists what others say of a system",
    "mutation/survivors.py": "a published list",
    **dict.fromkeys(
        [
            f"mutation/{m}.py"
            for m in (
                "asked",
                "blocked",
                "elsewhere",
                "forgotten",
                "points",
                "sharing",
                "swinging",
                "texts",
                "ways",
                "weakenings",
            )
        ],
        "makes mutants: whatever it makes is judged",
    ),
}
"""Modules and rooms of the proof in which nothing is concluded, and why."""

PROOF = TOP / "interlock" / "proof"


@pytest.mark.parametrize("module", sorted(str(p.relative_to(PROOF)) for p in PROOF.glob("*/*.py")))
def test_every_module_of_the_proof_begins_with_the_theorem_that_makes_it_sound(module: str) -> None:
    room, _, name = module.partition("/")
    said = ast.get_docstring(ast.parse((PROOF / module).read_text("utf-8"))) or ""
    theorem = said.partition("**Theorem.**")[2]
    wanted = (room in NO_THEOREM) if name == "__init__.py" else room not in NO_THEOREM and module not in NO_THEOREM
    if wanted:
        assert theorem.count("(") >= 1 and len(theorem) > 120
    elif name != "__init__.py":
        assert not theorem, "it stands on the list of those that have none"


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
    assert (code_lines(TEXT, tree), public_members(made)) == (9, {"x", "z", "v", "told"})
    assert not is_record(made)


def test_a_class_is_counted_with_what_it_inherits(tmp_path: Path) -> None:
    (tmp_path / "interlock").mkdir()
    (tmp_path / "interlock" / "one.py").write_text(
        "class A:\n    x: int\n    y: int\n\n\nclass B(A):\n    y: int\n    z: int\n\n\n"
        "class C(B):\n    def w_word(self): ...\n    def _own(self): ...\n    def told(self): ...\n"
    )
    found = counted(tmp_path)
    assert [(c.name, c.size, c.record) for c in found.classes] == [("A", 2, True), ("B", 3, True), ("C", 4, False)]
    assert found.words == 1


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
