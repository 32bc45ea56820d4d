"""What the second checker reads of each file of a bundle: a lie there is refused, and the rest is named as not read."""

from __future__ import annotations

import hashlib
import io
import json
import shutil
import zipfile
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path, PurePosixPath

import pytest

from interlock.app.certify import certify_file
from interlock.app.compile import compile_file
from interlock.checker import outputs
from interlock.checker.check import agree, check
from interlock.checker.outputs import Bundle
from interlock.checker.railway import Railway
from interlock.checker.said import Published
from interlock.checker.specification import shipped as specification
from interlock.checker.told import Telling
from interlock.checker.written import written
from interlock.st.dialects import BY_NAME
from interlock.verify import Rejected, check_files
from tests.certified import signed
from tests.layouts import grown
from tests.written import shipped, told

FIG = Path("layouts/fig2_2.yaml")
TOP = PurePosixPath("../../generated/fig2_2")
TEXT, C, CSV = "st/iec/fig2_2.st", "c99/fig2_2.c", "io/words.csv"


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The certificate of a small layout in every form that there is."""
    top = tmp_path_factory.mktemp("made")
    shutil.copy(FIG, top)
    compile_file(str(top / FIG.name), top / "generated", dialects=[*BY_NAME, "c99"])
    assert certify_file(str(top / FIG.name), top / "generated", top / "proofs").ok
    return top / "proofs/fig2_2"


@pytest.fixture(scope="module")
def whole(made: Path) -> Bundle:
    return bundle(made)


def bundle(folder: Path) -> Bundle:
    return outputs.bundle(folder, check_files(folder), str(TOP / TEXT), ["../../fig2_2.yaml"])


def lines(folder: Path) -> str:
    return check(folder.parents[1] / FIG.name, folder).compared[-1]


def test_every_file_of_a_bundle_is_compared_or_named(made: Path) -> None:
    named = lines(made)
    whole, parts = named.removeprefix("not read: ").rpartition("; ")[::2][::-1]
    apart = [x.partition(" ")[0] for x in parts.removeprefix("of ").split("; of ")]
    assert sorted(apart) == sorted([TEXT, C, CSV, "manifest.json", "runtime.py"])
    files = {str(x.relative_to(made.parents[1] / "generated/fig2_2")) for x in _files(made.parents[1] / "generated")}
    assert len(files) > 50 and files == {*apart, *whole.split(", ")} - {"needed.txt of the certificate"}
    own = {x.name for x in _files(made)} - {f"{x.removesuffix(' of the certificate')}" for x in whole.split(", ")}
    assert own == {"manifest.json", "system.txt", "proof.txt.xz"}, "these are read to the end"


def _files(top: Path) -> list[Path]:
    return [x for x in top.rglob("*") if x.is_file()]


def test_no_file_that_is_named_is_another(made: Path, tmp_path: Path) -> None:
    """Read or not, each is the one of which the manifest speaks."""
    shutil.copytree(made.parents[1], tmp_path / "copy")
    folder = tmp_path / "copy/proofs/fig2_2"
    top = tmp_path / "copy/generated/fig2_2"
    for file in (x for x in _files(top) if x.name != "manifest.json"):
        before = file.read_bytes()
        file.write_bytes(before.replace(b"X1", b"X3", 1) if file.suffix != ".xlsx" else _book({"a": b"x"}))
        if before == file.read_bytes():
            file.write_bytes(before + b" ")
        with pytest.raises(Rejected, match="is not the file"):
            bundle(folder)
        file.write_bytes(before)
    bundle(folder)


def _book(parts: Mapping[str, bytes]) -> bytes:
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w", zipfile.ZIP_DEFLATED) as book:
        for name, data in parts.items():
            book.writestr(name, data)
    return out.getvalue()


SAYS = "'section DP is occupied'"
LIES = {
    # the Python runtime
    "numbers of routes exchanged": ("runtime.py", "'X1-A': 1", "'X1-A': 2", "as the number of the route X1-A"),
    "a route by another name": ("runtime.py", "'X1-A': 1", "'X1-C': 1", "the number of the route X1-A"),
    "a route less": ("runtime.py", "    'X1-A': 1,\n", "", "the number of the route X1-A"),
    "a route more": (
        "runtime.py",
        "    'X1-A': 1,",
        "    'X1-A': 1, 'X9-A': 1,",
        "a route that the layout does not call",
    ),
    "a route twice": ("runtime.py", "    'X1-A': 1,", "    'X1-A': 2, 'X1-A': 1,", "two things of one key"),
    "another sentence": ("runtime.py", SAYS, "'section DP is clear'", "says of the code 10008"),
    "of another section": ("runtime.py", SAYS, "'section SA is occupied'", "says of the code 10008"),
    "another rule": ("runtime.py", f"{SAYS}, 'R3'", f"{SAYS}, 'R9'", "says of the code 10008"),
    "another word": ("runtime.py", "3: ('open', '')", "3: ('free', '')", "says of the code 3"),
    "a code less": ("runtime.py", f"    10008: ({SAYS}, 'R3'),\n", "", "explains other codes"),
    "a code more": ("runtime.py", "    1: ('free'", "    9: ('free', ''),\n    1: ('free'", "explains other codes"),
    "a code twice": ("runtime.py", "    1: ('free'", "    1: ('open', ''),\n    1: ('free'", "two things of one key"),
    "sentences that are made later": (
        "runtime.py",
        "class Controller",
        "SAID = {}\n\n\nclass Controller",
        "or several",
    ),
    "within a function": (
        "runtime.py",
        "class Controller",
        "def f():\n    global SAID\n    SAID = 1\n\n\nclass Controller",
        "or several",
    ),
    "as a variable of a loop": (
        "runtime.py",
        "class Controller",
        "for ROUTES in ():\n    pass\n\n\nclass Controller",
        "or several",
    ),
    "sentences that are computed": ("runtime.py", "\nSAID = {", "\nSAID = {} or {", "has no SAID"),
    "sentences in a text alone": ("runtime.py", "\nSAID = {", '\n"""\nSAID = {', "is no Python"),
    "sentences by a call": ("runtime.py", SAYS, "str('section DP is occupied')", "is no Python"),
    "no Python": ("runtime.py", "class Controller", "klass Controller", "is no Python"),
    # the C runtime
    "the name of a route in C": (C, '{ "X1-A", 1', '{ "X1-C", 1', "the number of the route X1-A"),
    "an octal name in C": (C, '{ "X1-A", 1', '{ "X1\\055C", 1', "the number of the route X1-A"),
    "its number": (
        C,
        '"X1-A", 1, &IL_fig2_2_said.YX_R1',
        '"X1-A", 2, &IL_fig2_2_said.YX_R2',
        "number of the route X1-A",
    ),
    "its word": (C, "&IL_fig2_2_said.YX_R1 }", "&IL_fig2_2_said.YX_R2 }", "shows YX_R2 as the word of the route X1-A"),
    "routes exchanged": (
        C,
        '{ "X1-A", 1, &IL_fig2_2_said.YX_R1 },',
        '{ "X1-B", 1, &IL_fig2_2_said.YX_R1 },',
        "X1-B twice",
    ),
    "a route less in C": (C, '  { "X1-A", 1, &IL_fig2_2_said.YX_R1 },\n', "", "has 3 routes, and says that it has 4"),
    "fewer routes than said": (C, "_routes[4] =", "_routes[5] =", "has 4 routes, and says that it has 5"),
    "a table before it": (
        C,
        "const IL_fig2_2_route IL",
        "int z_routes[1] = {0};\nconst IL_fig2_2_route IL",
        "or several",
    ),
    "what is no table": (C, '{ "X1-A", 1', "{ NAME, 1", "that is not known here"),
    "a comment at a code in C": (
        C,
        "10008; /* section DP is occupied",
        "10008; /* section DP is blocked",
        "beside the code 10008",
    ),
    "one of another code": (
        C,
        "10008; /* section DP is occupied",
        "10009; /* section DP is occupied",
        "beside the code 10009",
    ),
    # the text
    "a comment at a code": (
        TEXT,
        "10008; (* section DP is occupied",
        "10008; (* section DP is clear",
        "beside the code 10008",
    ),
    "a route in a comment": (TEXT, "to C for route X2-C *)", "to C for route X1-A *)", "beside the code 10003"),
    "one on the next line": (
        TEXT,
        "10008; (* section DP is occupied",
        "10008;\n(* section DP is clear",
        "beside the code 10008",
    ),
    "a word of another route": (
        TEXT,
        "(* route X1-A: what it does, or",
        "(* route X3-C: what it does, or",
        "calls YX_R1",
    ),
}


@pytest.mark.parametrize("which", LIES)
def test_a_lie_in_a_file_is_refused(whole: Bundle, which: str) -> None:
    file, before, after, why = LIES[which]
    text = (whole.outputs[file] or b"").decode()
    assert before in text
    forged = replace(whole, outputs={**whole.outputs, file: text.replace(before, after).encode()})
    with pytest.raises(Rejected, match=why):
        outputs.compare(forged, table(whole), nobody)


def table(b: Bundle) -> Published:
    found = outputs.published(b)
    assert found is not None
    return found


def nobody() -> Telling:
    raise Rejected("a route that the layout does not call so")


def test_the_truth_is_taken(whole: Bundle) -> None:
    assert set(outputs.compare(whole, table(whole), nobody)) == {TEXT, C, CSV, "manifest.json", "runtime.py"}


def test_signs_that_cannot_stand_in_a_comment_hide_no_lie() -> None:
    like = outputs._like
    assert like("section 22ｲT is occupied", "section 22_T is occupied") and like("a", "a")
    assert like("section 22ｲT is occupied", "section 22IT is occupied")
    for lie in (
        "section 22_T is clear",
        "section 23_T is occupied",
        "section 22 is not what it was, T is occupied",
        "",
    ):
        assert not like("section 22ｲT is occupied", lie)
    assert not like("駅" * 300 + "a", "_" * 900 + "b"), "in a moment"


TABLES = {
    "a code twice": ("\n,1,free,,", "\n,1,free,,\n,1,open,,", "says two things of 1"),
    "a word twice": ("\nYX_R1,,", "\nYX_R1,,route X1-B,,\nYX_R1,,", "says two things of YX_R1"),
    "a row of a word and a code": ("\nYX_R1,,", "\nYX_R1,7,", "a row that is of a word and of a code"),
    "a code that nobody says": ("\n,1,free,,", "\n,9,all clear,,\n,1,free,,", "the code 9, which nobody says"),
    "a refusal that nobody says": ("\n,10001,", "\n,10099,all clear,R3,\n,10001,", "the code 10099, which nobody says"),
    "a code that is not explained": (
        "\n,10008,section DP is occupied,R3,DP",
        "",
        "nothing is published of the code 10008",
    ),
    "a code by another number": ("\n,10008,", "\n,010008,", "writes a code 010008"),
    "a number in other digits": ("\n,10008,", "\n,١٠٠٠٨,", "writes a code"),
    "a column twice": ("Word,Code,Says,Rule,About", "Word,Code,Says,Says,About", "other columns"),
    "a column that is shown before": ("Word,Code,Says", "Word,Code,Says,Shown", "other columns"),
    "a cell more": ("\n,1,free,,", "\n,1,free,,,open", "a row with more or fewer cells"),
    "a rule for a state": ("\n,1,free,,", "\n,1,free,R3,", "a rule is published for the code 1"),
    "a word less": ("\nYX_R1,,route X1-A,,", "", "other words than the text"),
    "a word more": ("\nYX_R1,,", "\nYX_R9,,route X1-C,,\nYX_R1,,", "other words than the text"),
    "a route that begins elsewhere": ("route X1-A", "route X2-A", "calls YX_R1"),
}


@pytest.mark.parametrize("which", TABLES)
def test_a_lie_in_the_table_of_words_is_refused(whole: Bundle, which: str) -> None:
    before, after, why = TABLES[which]
    text = (whole.outputs[CSV] or b"").decode().replace("\r\n", "\n")
    assert before in text
    forged = replace(whole, outputs={**whole.outputs, CSV: text.replace(before, after, 1).encode()})
    with pytest.raises(Rejected, match=why):
        agree(*shipped("fig2_2"), specification(), table(forged))


def test_names_that_the_layout_gives_are_names_of_the_route(whole: Bundle) -> None:
    body, system, _ = shipped("fig2_2")
    text = (whole.outputs["runtime.py"] or b"").decode()
    forged = {n: text.replace("    'X1-A': 1,", f"    'X1-A': 1, 'up main': {n},").encode() for n in (1, 3)}
    named = {**body, "routes": {"up main": {"from": "X1", "to": "A"}}}

    def world() -> Telling:
        return Telling(Railway(named), written(system))

    outputs.compare(replace(whole, outputs={**whole.outputs, "runtime.py": forged[1]}), table(whole), world)
    with pytest.raises(Rejected, match="calls 'up main' a route that the layout does not call so"):
        outputs.compare(replace(whole, outputs={**whole.outputs, "runtime.py": forged[3]}), table(whole), world)


def _named(folder: Path, **more: str) -> None:
    """The manifest of outputs names something else, and the certificate ties it."""
    file = folder / str(TOP) / "manifest.json"
    body = json.loads(file.read_text("utf-8"))
    body["files"] |= more
    file.write_text(json.dumps(body), "utf-8")
    signed(folder)


def _bomb() -> bytes:
    return _book({"xl/a.xml": bytes(120_000_000)})


OTHERS: dict[str, tuple[bytes, str]] = {
    "no workbook": (b"PK no workbook", "is no workbook"),
    "a workbook that grows": (b"", "larger when unpacked"),
}


@pytest.mark.parametrize("which", OTHERS)
def test_a_workbook_that_is_none_is_refused(made: Path, tmp_path: Path, which: str) -> None:
    shutil.copytree(made.parents[1], tmp_path / "copy")
    folder = tmp_path / "copy/proofs/fig2_2"
    raw, why = OTHERS[which]
    (folder / str(TOP) / "table.xlsx").write_bytes(raw or _bomb())
    _named(folder, **{"table.xlsx": hashlib.sha256(raw).hexdigest()})
    with pytest.raises(Rejected, match=why):
        bundle(folder)


@pytest.mark.parametrize("name", ["../../fig2_2.yaml", "/etc/hostname", "io/../../../fig2_2.yaml"])
def test_the_manifest_of_outputs_names_nothing_elsewhere(made: Path, tmp_path: Path, name: str) -> None:
    shutil.copytree(made.parents[1], tmp_path / "copy")
    folder = tmp_path / "copy/proofs/fig2_2"
    _named(folder, **{name: "0" * 64})
    with pytest.raises(Rejected, match="which is elsewhere"):
        bundle(folder)


def test_a_text_that_the_certificate_ties_and_the_manifest_of_outputs_does_not_is_refused(
    made: Path, tmp_path: Path
) -> None:
    """A harmless change of the mapping program, which nobody reads."""
    shutil.copytree(made.parents[1], tmp_path / "copy")
    folder = tmp_path / "copy/proofs/fig2_2"
    file = folder / str(TOP) / "st/iec/fig2_2_io.st"
    file.write_text(file.read_text("utf-8") + "\n", "utf-8")
    signed(folder)
    with pytest.raises(Rejected, match=r"fig2_2_io\.st is not the file that the manifest of outputs names"):
        lines(folder)


def test_what_is_not_there_and_what_nobody_certified_is_named(made: Path, tmp_path: Path) -> None:
    shutil.copytree(made.parents[1], tmp_path / "copy")
    folder = tmp_path / "copy/proofs/fig2_2"
    top = folder / str(TOP)
    (top / "runtime.py").unlink()
    (top / "st/iec/fig2_2_new.st").write_text("the one that is loaded", "utf-8")
    said = lines(folder)
    assert "not there: runtime.py" in said and "of runtime.py" not in said
    assert "certified by nobody: st/iec/fig2_2_new.st" in said


def test_a_name_of_a_route_past_a_signal_is_of_the_whole_route() -> None:
    """X-Y-Z passes Y at identifier light: whoever calls it by a name means the way to Z."""
    source = Path("tests/layouts_for_tests/identifiers.yaml").read_text("utf-8")
    found = grown(source)
    assert found is not None
    body, system, _ = told(source)
    world = Telling(Railway(body), written(system))
    number = next(r.number for r in found[1].routes if str(r.id) == "X-Y-Z")
    assert world.leads_so({"from": "X", "to": "Z"}, number)
    assert not world.leads_so({"from": "X", "to": "Y"}, number)
