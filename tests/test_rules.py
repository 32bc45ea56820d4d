"""The pages of the rules: each shows its rule on a small layout, and the table must have the cells that it shows."""

from __future__ import annotations

import ast
import re
from pathlib import Path

import pytest

from interlock.derivation import derive
from interlock.diag import Severity, Sink
from interlock.diag.codes import LINTS
from interlock.frontend import load_text
from interlock.logic import rules
from interlock.table.columns import COLUMNS, VOYAGE_COLUMNS

FOLDER = Path("interlock/docs/rules")
PAGES = sorted(p.stem for p in FOLDER.glob("R*.md") if p.stem != "README")


@pytest.mark.parametrize("name", PAGES)
def test_the_page_shows_what_the_derivation_gives(name: str) -> None:
    page = (FOLDER / f"{name}.md").read_text("utf-8")
    assert page.startswith(f"# {name} ") and "\nSource: " in page
    layouts = re.findall(r"```yaml\n(.*?)```", page, flags=re.S)
    cells = re.findall(r"```cells\n(.*?)```", page, flags=re.S)
    assert layouts and len(layouts) == len(cells)
    columns = {c.key: c for c in COLUMNS}
    voyage_columns = {c.key: c for c in VOYAGE_COLUMNS}
    for text, shown in zip(layouts, cells, strict=True):
        sink = Sink()
        layout, _ = load_text(f"{name}.md", text, sink)
        assert layout is not None, sink.diagnostics
        table = derive(layout, sink)
        # the smallest layout that shows a rule is no station: practice is not asked of it
        assert [d for d in sink.diagnostics if d.severity is not Severity.INFO and d.code not in LINTS] == []
        assert shown.strip()
        for line in shown.strip().splitlines():
            route, column, cell = (x.strip() for x in line.split("|"))
            voyage = next((v for v in table.voyages if v.name == route), None)
            if voyage is not None:
                assert voyage_columns[column].text(voyage) == cell, line
                continue
            assert columns[column].text(table.route[route]) == cell, line  # type: ignore[index]


def test_every_rule_has_a_page() -> None:
    assert {f"R{n}" for n in range(1, 19)} <= set(PAGES)


def test_the_logic_names_rules_by_the_titles_of_their_pages() -> None:
    named = {k: v for k, v in vars(rules).items() if k.isupper()}
    titles = {p: (FOLDER / f"{p}.md").read_text("utf-8").splitlines()[0].removeprefix(f"# {p} ") for p in PAGES}
    for name, number in named.items():
        words = re.findall(r"\w+", titles[number].upper())
        assert words[: name.count("_") + 1] == name.split("_"), (name, titles[number])
    assert len(set(named.values())) == len(named)


def test_no_number_of_a_rule_is_typed_in_what_is_said_of_a_variable() -> None:
    """It comes from the cell in the table, or by name from `logic/rules.py`; docstrings may say it."""
    for path in sorted(Path("interlock/logic").rglob("*.py")):
        tree = ast.parse(path.read_text("utf-8"))
        said = {id(n.value) for n in ast.walk(tree) if isinstance(n, ast.Expr)}
        typed = [n.value for n in ast.walk(tree) if isinstance(n, ast.Constant) and id(n) not in said]
        found = [x for x in typed if isinstance(x, str) and re.search(r"\bR\d+\b", x)]
        assert path.name == "rules.py" or not found, (path, found)
