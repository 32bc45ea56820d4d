"""What the documents say is true of the code."""

from __future__ import annotations

import importlib
import inspect
import json
import re
import tomllib
from pathlib import Path
from typing import Any

import pytest

import interlock
from interlock.app.check import check_file
from interlock.diag import Sink
from interlock.frontend import load_text
from interlock.logic.plant import ASSUMPTIONS, OF_PLC
from interlock.proof.claims import CLAIMS, Claim, Facts, claims
from interlock.proof.prover import prove
from interlock.proof.system.transition import System
from interlock.st.dialects import BY_NAME
from tests.layouts import built

README = Path("README.md").read_text("utf-8")


def test_the_readmes_two_commands_are_single_lines() -> None:
    for name in ("compile", "test"):
        block = README.split(f"<!-- command: {name} -->\n```sh\n")[1].split("```")[0]
        assert len(block.strip().splitlines()) == 1


def test_the_readmes_layout_is_proved() -> None:
    from interlock.derivation import derive
    from interlock.logic.lower import lower

    text = README.split("```yaml\n")[1].split("```")[0]
    sink = Sink()
    layout, _ = load_text("README.md", text, sink)
    assert layout is not None, sink.diagnostics
    assert prove(System(layout, lower(layout, derive(layout, sink)))).proved


def test_the_readme_names_every_claim() -> None:
    for claim in CLAIMS:
        assert claim in README, claim


def test_the_readme_counts_the_claims() -> None:
    found = re.search(r"no two trains meet, that no point moves under a train, and (\d+) further claims", README)
    assert found is not None and int(found[1]) == len(CLAIMS) - 2


def test_the_readme_counts_the_dialects_and_the_plc_page_has_a_line_for_each() -> None:
    """Ladder diagrams are one of them, and no Structured Text."""
    words = ["one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten", "eleven", "twelve"]
    found = re.search(r"Structured Text in (\w+) dialects and ladder", README)
    assert found is not None and found[1] == words[len(BY_NAME) - 2]
    page = Path("interlock/docs/plc.md").read_text("utf-8")
    for name in BY_NAME:
        assert re.search(rf"^\| `{name}` ", page, re.MULTILINE), name


def test_committed_outputs_are_of_the_layouts_as_they_are_read_now() -> None:
    """A key that layouts do not state changes no digest: it stands in every text, and ties every certificate."""
    for path in Path("layouts").glob("*.yaml"):
        manifest = json.loads(Path(f"generated/{path.stem}/manifest.json").read_text("utf-8"))
        assert interlock.load(str(path)).digest == manifest["layout_digest"], path


def test_the_readme_tells_of_what_shipped_layouts_have_nothing_to_claim() -> None:
    """Places as the committed proofs have them; those of three layouts for tests counted anew."""
    where: dict[str, list[str]] = {c: [] for c in CLAIMS}
    for path in Path("generated").glob("*/proof.json"):
        proof = json.loads(path.read_text("utf-8"))
        for c in proof["claims"]:
            where[c["id"]] += [proof["layout"]] if c["places"] else []
    told = README.split("there is nothing to claim.")[1].split("\n\n")[0]
    none, one = (re.findall(r"[A-Z]+-[A-Z-]*[A-Z]", x) for x in told.split(": `spaces`", 1))
    assert set(none) == {c for c, layouts in where.items() if not layouts}
    groups = re.findall(r"([A-Z-]+(?: and [A-Z-]+)?) \(`(\w+)`\)", told)
    assert {c: [layout] for names, layout in groups for c in names.split(" and ")} == {
        c: layouts for c, layouts in where.items() if len(layouts) == 1
    }
    assert len(one) == sum(len(names.split(" and ")) for names, _ in groups)
    placed = {
        c.id for x in ("spaces", "identifier", "air_lock_doors") for c in places_of(f"../tests/layouts_for_tests/{x}")
    }
    assert set(none) <= placed


def places_of(name: str) -> list[Claim]:
    layout, _, controller = built(name)
    return claims(Facts(System(layout, controller)))


def test_the_proof_page_gives_every_assumption_in_its_words() -> None:
    page = Path("interlock/docs/proof.md").read_text("utf-8")
    for id_, sentence in (ASSUMPTIONS | OF_PLC).items():
        assert f"- **{id_}**: {sentence}" in page


def test_the_readme_names_every_assumption() -> None:
    told = README.split("**Assumptions**")[1].split("**Engines.**")[0]
    for id_ in ASSUMPTIONS | OF_PLC:
        assert f"({id_})" in told, id_


def test_links_in_the_documents_lead_somewhere() -> None:
    for page in [*Path().glob("*.md"), *Path("interlock/docs").glob("*.md"), *Path("proofs").glob("*.md")]:
        for target in re.findall(r"\]\(([^)#:]+)\)", page.read_text("utf-8")):
            assert page.parent.joinpath(target).exists(), f"{page}: {target}"


def test_every_shipped_layout_says_where_it_comes_from() -> None:
    for path in Path("layouts").rglob("*.yaml"):
        assert path.read_text("utf-8").startswith("# "), path
        if "rejected" not in path.parts:
            assert check_file(str(path)).ok, path


def test_the_mine_takes_about_forty_lines() -> None:
    lines = [x for x in Path("layouts/mine11.yaml").read_text("utf-8").splitlines() if x.strip() and x[0] != "#"]
    assert len(lines) <= 45


def test_no_module_is_long() -> None:
    for path in Path("interlock").rglob("*.py"):
        assert len(path.read_text("utf-8").splitlines()) <= 560, path


def test_every_rule_that_a_cell_names_is_explained() -> None:
    from interlock.app.explain import explain
    from interlock.table.columns import COLUMNS
    from tests.layouts import SHIPPED, built

    cited = {b.rule for n in SHIPPED for r in built(n)[1].routes for c in COLUMNS for _, b in c.items(r)}
    for n in SHIPPED:
        for e in (*built(n)[2].equations, *built(n)[2].next):
            cited |= set(re.findall(r"\bR\d+\b", e.note))
    assert {"R1", "R5", "R6.1", "R8", "R9"} <= cited
    for rule in cited:
        assert explain(rule) is not None, rule


def test_the_examples_of_the_library_page_run(capsys: pytest.CaptureFixture[str]) -> None:
    page = Path("interlock/docs/library.md").read_text("utf-8")
    names: dict[str, object] = {}
    examples = re.findall(r"^```python\n(.*?)^```", page, re.MULTILINE | re.DOTALL)
    assert len(examples) >= 6
    for text in examples:
        exec(compile(text, "library.md", "exec"), names)
    assert "R5" in capsys.readouterr().out


def test_the_library_refuses_what_it_would_pass_over() -> None:
    """An engine or a dialect that is none, a number that asks for nothing, and what was made of another layout."""
    loop, mine = (interlock.load(f"layouts/{n}.yaml") for n in ("fig2_2", "mine11"))
    table = interlock.derive(loop)
    controller = interlock.lower(loop, table)
    refused = (
        ("engine", lambda: interlock.prove(loop, controller, engine="minisatt")),
        ("jobs", lambda: interlock.prove(loop, controller, jobs=0)),
        ("search_depth", lambda: interlock.prove(loop, controller, search_depth=0)),
        ("search_seconds", lambda: interlock.prove(loop, controller, search_seconds=float("nan"))),
        ("another layout", lambda: interlock.prove(mine, controller)),
        ("another layout", lambda: interlock.lower(mine, table)),
        ("no dialect 'all'", lambda: interlock.compile(loop, dialects=("codesys", "all"))),
        ("jobs", lambda: interlock.compile(loop, jobs=-1)),
    )
    for said, call in refused:
        with pytest.raises(ValueError, match=said):
            call()


def test_the_library_says_of_a_value_of_another_kind_what_is_wanted() -> None:
    loop = interlock.load("layouts/fig2_2.yaml")
    table = interlock.derive(loop)
    wrong: Any = "x.yaml"
    refused = (
        (
            r"loads takes a layout's text \(str\), and it is of type bytes: `load` reads",
            lambda: interlock.loads(wrong.encode()),
        ),
        (
            r"derive takes a layout \(Layout\), and 'x.yaml' is of type str: `load\(path\)`",
            lambda: interlock.derive(wrong),
        ),
        ("compile takes a layout", lambda: interlock.compile(wrong)),
        ("lower takes a layout", lambda: interlock.lower(wrong, table)),
        (
            r"lower takes a table \(InterlockingTable\), and .*: `derive\(layout\)` makes",
            lambda: interlock.lower(loop, wrong),
        ),
        (r"prove takes a controller .*: `lower\(layout, table\)` makes", lambda: interlock.prove(loop, wrong)),
        ("not int", lambda: interlock.load(len(wrong))),  # type: ignore[arg-type]
    )
    for said, call in refused:
        with pytest.raises(TypeError, match=said):
            call()
    assert interlock.load(wrong.replace("x.yaml", "layouts/fig2_2.yaml").encode()).name == loop.name


def test_the_library_says_which_extra_is_missing(monkeypatch: pytest.MonkeyPatch) -> None:
    loop = interlock.load("layouts/fig2_2.yaml")
    controller = interlock.lower(loop, interlock.derive(loop))
    monkeypatch.setattr("interlock.app.library.find_spec", lambda module: None)
    with pytest.raises(ModuleNotFoundError, match=r"the engine cvc5 needs the extra `recheck`: .*interlock\[recheck\]"):
        interlock.prove(loop, controller, engine="cvc5")
    with pytest.raises(ModuleNotFoundError, match=r"the dialect c99 needs the extra `c99`: .*interlock\[c99\]"):
        interlock.compile(loop, dialects=("c99",))


@pytest.mark.parametrize("dialects", [("foo",), ("scl300", "all"), "scl300"])
def test_the_library_leaves_out_no_dialect_without_a_word(dialects: tuple[str, ...]) -> None:
    layout = interlock.load("layouts/fig2_2.yaml")
    with pytest.raises(ValueError, match=r"there is no dialect '(foo|all)'; there are iec, codesys|write a tuple"):
        interlock.compile(layout, dialects=dialects)


def test_the_library_page_names_every_function() -> None:
    page = Path("interlock/docs/library.md").read_text("utf-8")
    for name in interlock.__all__:
        value = getattr(interlock, name)
        assert value is getattr(importlib.import_module("interlock.app.library"), name, value)
        assert not inspect.isfunction(value) or f"`{name}(" in page, name


def test_the_house_has_every_room_in_its_layer_and_the_module_with_which_it_begins() -> None:
    page = Path("interlock/docs/house.md").read_text("utf-8")
    rows = re.findall(r"^\| (\d+) \| `(\w+)/` \| [^|]+ \| ([^|]+) \|$", page, re.MULTILINE)
    settings = tomllib.loads(Path("pyproject.toml").read_text("utf-8"))
    contract = next(c for c in settings["tool"]["importlinter"]["contracts"] if "interlock.cli" in c.get("layers", ()))
    layers = [{x.removeprefix("interlock.") for x in re.split(r"[ |]+", layer)} for layer in contract["layers"]]
    assert [{room for n, room, _ in rows if int(n) == k} for k in range(1, len(layers) + 1)] == layers
    for _, room, begins in rows:
        for module in re.findall(r"`([\w/]+\.py)`", begins):
            assert Path("interlock", room, module).is_file(), (room, module)


def test_the_recipes_name_files_that_are_there() -> None:
    page = Path("CONTRIBUTING.md").read_text("utf-8")
    named = re.findall(r"`((?:interlock|tests)/[^`]+)`", page)
    assert len(named) > 30 and [n for n in named if not Path(n).is_file()] == []
    recipes = page.split("\n## ")[1:]
    assert len(recipes) == 4 and "abstraction/" not in page
    (assumed,) = re.findall(r"`ASSUMPTIONS` of `([^`]+)`", page)
    assert "\nASSUMPTIONS: " in Path(assumed).read_text("utf-8")
    for word, recipe in zip(("speed", "speed", "scl300", "IL3024"), recipes, strict=True):
        for file in re.findall(r"^\| `([^`]+)`", recipe, re.MULTILINE):
            if not file.endswith((".yaml", "load.py", "wiring.py", "strengthening.py", "pipeline.py")):
                assert re.search(word, Path(file).read_text("utf-8"), re.IGNORECASE), (word, file)


def test_the_first_output_that_a_reader_sees_is_the_one_that_comes() -> None:
    """Counted from the committed proof of the layout that the README compiles."""
    proof = json.loads(Path("generated/mine11/proof.json").read_text("utf-8"))
    places = [c["places"] for c in proof["claims"]]
    claimed, silent = sum(map(bool, places)), places.count(0)
    told = f"PROVED  {claimed} claims at {sum(places)} places, all proved; {silent} claims have nothing to claim here; "
    assert told + f"{len(proof['witnesses'])} routes, {len(proof['witnesses'])} driven by a witness" in README
