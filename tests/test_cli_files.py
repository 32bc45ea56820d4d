"""What commands write, and what they leave alone."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest

from interlock.app.init import STARTER
from tests.cli_runs import process, run


def test_what_two_options_ask_for_is_not_half_done(tmp_path: Path) -> None:
    done = run("draw", "layouts/fig2_2.yaml", "--sheets", "--fold", "-o", str(tmp_path / "plan.svg"))
    assert done.exit_code == 2 and "choose one" in done.output and not list(tmp_path.iterdir())
    done = run("play", "")
    assert done.exit_code == 2 and "name the trace" in done.output


def test_compile_writes_everything_and_check_tells_whether_it_is_current(tmp_path: Path) -> None:
    args = ("compile", "layouts/fig2_2.yaml", "-o", str(tmp_path))
    assert run(*args, "--check").exit_code == 1
    done = run(*args)
    assert done.exit_code == 0, done.output
    folder = tmp_path / "fig2_2"
    names = {str(p.relative_to(folder)) for p in folder.rglob("*") if p.is_file()}
    assert names == {
        "manifest.json",
        "matrix.csv",
        "proof.json",
        "runtime.py",
        "st/iec/fig2_2.st",
        "st/iec/fig2_2_io.st",
        "io/channels.csv",
        "io/equipment.csv",
        "io/tags_tia.xlsx",
        "io/words.csv",
        "table.csv",
        "index.html",
        "plan.svg",
        "table.json",
        "table_railml.json",
        "table.xlsx",
    }
    assert run(*args, "--check").exit_code == 0
    (folder / "table.csv").write_text("tampered")
    done = run(*args, "--check")
    assert done.exit_code == 1 and "IL5003" in done.output and "table.csv differs" in done.output
    assert run(*args).exit_code == 0 and run(*args, "--check").exit_code == 0
    assert [p.name for p in tmp_path.iterdir()] == ["fig2_2"]  # nothing half-written stays behind


def test_no_plc_text_without_a_proof_unless_marked(tmp_path: Path) -> None:
    args = ("compile", "layouts/refuted/wrong_waiver.yaml", "-o", str(tmp_path))
    done = run(*args)
    assert done.exit_code == 1 and "IL5006" in done.output
    folder = tmp_path / "wrong_waiver"
    assert not list(folder.rglob("*.st")) and not list(folder.rglob("*.py"))
    assert "NOT PROVED" in (folder / "index.html").read_text("utf-8")
    assert run(*args, "--unproved").exit_code == 1
    assert "NOT PROVED" in (folder / "st/iec/wrong_waiver.st").read_text("utf-8").splitlines()[0]
    assert "NOT PROVED" in (folder / "runtime.py").read_text("utf-8").splitlines()[0]


def test_everything_that_people_read_says_that_nothing_is_proved(tmp_path: Path) -> None:
    """Marked are texts, report, plan and printed sheets; files that other programs read as data cannot be."""
    args = ("compile", "layouts/refuted/wrong_waiver.yaml", "-o", str(tmp_path), "--unproved")
    assert run(*args, "--dialect", "all", "--dialect", "c99").exit_code == 1
    folder = tmp_path / "wrong_waiver"
    left = {
        str(p.relative_to(folder))
        for p in folder.rglob("*")
        if p.is_file() and b"NOT PROVED" not in p.read_bytes() and p.parent.name != "counterexamples"
    }
    assert {Path(x).suffix for x in left} == {".csv", ".json", ".sdf", ".xlsx", ".TcTTO"}
    with zipfile.ZipFile(folder / "table.xlsx") as book:
        pages = [book.read(n).decode() for n in book.namelist() if n.startswith("xl/worksheets/sheet")]
    printed = [x for x in pages if "Not certified" in x or "NOT PROVED" in x]
    assert printed and all("NOT PROVED" in x for x in printed)
    plan = (folder / "plan.svg").read_text("utf-8")
    assert ">NOT PROVED: for study only, never for a railway<" in plan
    proved = run("compile", "layouts/fig2_2.yaml", "-o", str(tmp_path / "proved"))
    assert proved.exit_code == 0 and "NOT PROVED" not in (tmp_path / "proved/fig2_2/plan.svg").read_text("utf-8")


def test_a_folder_that_is_not_ours_is_left_alone(tmp_path: Path) -> None:
    precious = tmp_path / "fig2_2"
    precious.mkdir()
    (precious / "thesis.txt").write_text("years of work")
    done = run("compile", "layouts/fig2_2.yaml", "-o", str(tmp_path))
    assert done.exit_code == 1 and "IL5004" in done.output
    assert [p.name for p in precious.iterdir()] == ["thesis.txt"]


@pytest.mark.parametrize(
    ("name", "text"),
    [("notes.txt", "what I noticed"), ("st/old.st", "(* mine *)"), ("manifest.json", '{"name": "mine"}')],
)
def test_what_somebody_keeps_among_the_outputs_is_left_alone(tmp_path: Path, name: str, text: str) -> None:
    """A folder is replaced as a whole: not one with a file in it that interlock has not written."""
    assert run("compile", "layouts/fig2_2.yaml", "-o", str(tmp_path)).exit_code == 0
    mine = tmp_path / "fig2_2" / name
    mine.write_text(text)
    done = run("compile", "layouts/fig2_2.yaml", "-o", str(tmp_path))
    assert done.exit_code == 1 and "IL5004" in done.output and mine.read_text() == text
    assert "is not replaced: interlock has not written" in done.output


def test_a_certificate_leaves_alone_what_somebody_keeps_beside_it(tmp_path: Path) -> None:
    outputs, proofs = tmp_path / "generated", tmp_path / "proofs"
    assert run("compile", "layouts/fig2_2.yaml", "-o", str(outputs)).exit_code == 0
    mine = proofs / "fig2_2" / "remarks.txt"
    mine.parent.mkdir(parents=True)
    mine.write_text("checked by two")
    done = run("certify", "layouts/fig2_2.yaml", "--outputs", str(outputs), "-o", str(proofs))
    assert done.exit_code == 1 and "remarks.txt" in done.output and mine.read_text() == "checked by two"


def test_a_folder_with_a_name_that_is_too_long_is_told(tmp_path: Path) -> None:
    """What was written there before is looked for first; that ended in an internal error."""
    done = run("compile", "layouts/fig2_2.yaml", "-o", str(tmp_path / ("x" * 300)))
    assert done.exit_code == 1 and "IL5004" in done.output and "internal" not in done.output


def test_the_longest_name_of_a_layout_is_that_of_a_folder(tmp_path: Path) -> None:
    layout = tmp_path / "long.yaml"
    named = "name: " + "\U00020000" * 60  # four bytes each
    layout.write_text(Path("layouts/fig2_2.yaml").read_text("utf-8").replace("name: fig2_2", named), encoding="utf-8")
    for _ in range(2):
        assert run("compile", str(layout), "-o", str(tmp_path / "out")).exit_code == 0
    assert run("certify", str(layout), "--outputs", str(tmp_path / "out"), "-o", str(tmp_path / "p")).exit_code == 0


def test_a_file_where_the_folder_should_be_is_told(tmp_path: Path) -> None:
    (tmp_path / "fig2_2").write_text("a note")
    done = run("compile", "layouts/fig2_2.yaml", "-o", str(tmp_path))
    assert done.exit_code == 1 and "IL5004" in done.output and (tmp_path / "fig2_2").read_text() == "a note"


def test_compile_says_what_to_open(tmp_path: Path) -> None:
    said = run("compile", "layouts/fig2_2.yaml", "-o", str(tmp_path)).output
    page = Path(said.split("open in a browser: ")[1].split("\n")[0])
    assert page == tmp_path / "fig2_2" / "index.html" and page.is_file()
    assert "open in a browser" not in run("compile", "layouts/fig2_2.yaml", "-o", str(tmp_path), "--check").output
    readme = Path("README.md").read_text("utf-8")
    assert "open in a browser: generated/mine11/index.html" in readme


def test_check_asks_for_the_texts_that_are_there_and_compile_says_which_are_gone(tmp_path: Path) -> None:
    args = ("compile", "layouts/fig2_2.yaml", "-o", str(tmp_path))
    assert run(*args, "--dialect", "scl300").exit_code == 0
    done = run(*args, "--check")
    assert done.exit_code == 0, done.output
    done = run(*args)
    assert done.exit_code == 0 and "IL5012" in done.output and "scl300" in done.output
    assert not (tmp_path / "fig2_2/st/scl300").exists() and "IL5012" not in run(*args).output
    run(*args, "--dialect", "iec", "--dialect", "awl")
    said = " ".join(run(*args).output.split())
    assert "the text for awl and io/xref_iec.csv are not written any more" in said, "the text for iec always is"


def test_two_layouts_of_one_name_do_not_overwrite_each_other(tmp_path: Path) -> None:
    twin = tmp_path / "twin.yaml"
    twin.write_text(Path("layouts/fig2_2.yaml").read_text("utf-8"), encoding="utf-8")
    done = run("compile", "layouts/fig2_2.yaml", str(twin), "-o", str(tmp_path / "out"))
    assert done.exit_code == 1 and "IL5004" in done.output and not (tmp_path / "out").exists()


def test_several_layouts_on_two_processes(tmp_path: Path) -> None:
    done = process("compile", "layouts/fig2_2.yaml", "layouts/fig2_3_whole.yaml", "-o", str(tmp_path), "-j", "2")
    assert done.returncode == 0, done.stdout + done.stderr
    assert sorted(p.name for p in tmp_path.iterdir()) == ["fig2_2", "fig2_3_whole"]


def test_what_interlock_has_not_written_stays(tmp_path: Path) -> None:
    """No picture, circuit, page or layout replaces a file of somebody else, nor one that somebody has changed."""
    layout = tmp_path / "base.yaml"
    layout.write_text(Path("layouts/fig2_2.yaml").read_text("utf-8"), "utf-8")
    before = layout.read_bytes()
    for force in ((), ("--force",)):
        done = run("draw", str(layout), "-o", str(layout), *force)
        assert done.exit_code == 1 and layout.read_bytes() == before
    for verb, name in (("draw", "base.svg"), ("export", "base.aig")):
        target = tmp_path / name
        assert run(verb, str(layout), "-o", str(target)).exit_code == 0
        assert run(verb, str(layout), "-o", str(target)).exit_code == 0  # what it wrote itself, it may write again
        target.write_bytes(target.read_bytes().replace(b"\n", b"\n\n", 1))
        edited = target.read_bytes()
        done = run(verb, str(layout), "-o", str(target))
        assert done.exit_code == 1 and "--force" in done.output and target.read_bytes() == edited
        assert run(verb, str(layout), "-o", str(target), "--force").exit_code == 0
        assert target.read_bytes() != edited
    assert run("init", "-o", str(layout)).exit_code == 1 and layout.read_bytes() == before
    (tmp_path / "s.yaml").write_text(STARTER, "utf-8")
    plan = ("dispatch", str(tmp_path / "s.yaml"), "1:W>E", "--plan", str(layout))
    assert run(*plan).exit_code == 1 and layout.read_bytes() == before
    plan = (*plan[:-1], str(tmp_path / "plan.json"))
    assert run(*plan).exit_code == 0 and run(*plan).exit_code == 0


def test_the_same_layout_gives_the_same_bytes() -> None:
    from interlock.app.compile import build, finish

    a, files_a = build("layouts/fig2_3_split.yaml")
    build("layouts/fig2_2.yaml")
    b, files_b = build("layouts/fig2_3_split.yaml")
    assert finish(a.checked, files_a) == finish(b.checked, files_b)


def test_the_bytes_do_not_depend_on_the_process(tmp_path: Path) -> None:

    for seed in ("1", "2"):
        args = [sys.executable, "-m", "interlock", "compile", "layouts/passing_loop.yaml", "-o", str(tmp_path)]
        check = ["--check"] if seed == "2" else []
        done = subprocess.run(
            [*args, *check], env={**os.environ, "PYTHONHASHSEED": seed}, capture_output=True, text=True
        )
        assert done.returncode == 0, done.stdout


def test_the_workbook_opens_and_holds_the_table() -> None:
    import io

    import openpyxl

    from interlock.app.compile import build

    _, files = build("layouts/fig2_2.yaml")
    book = openpyxl.load_workbook(io.BytesIO(files["table.xlsx"]))
    assert book.sheetnames == ["Table", "Reasons", "Matrices"]
    assert [c.value for c in book["Table"]["B"]][4:8] == ["X1-A", "X1-B", "X2-C", "X3-C"]


def test_the_runtime_stands_alone(tmp_path: Path) -> None:
    from interlock.app.compile import build

    _, files = build("layouts/fig2_2.yaml")
    (tmp_path / "runtime.py").write_bytes(files["runtime.py"])
    code = (
        "import runtime; c = runtime.Controller(); o = c.scan({}, 100); print(o['YS_X1'], o['YP_X1'], c.state['K_DP'])"
    )
    done = subprocess.run(
        [sys.executable, "-I", "-c", f"import sys; sys.path.insert(0, {str(tmp_path)!r}); {code}"],
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.stdout.split() == ["True", "False", "True"], done.stderr


def test_slips_with_files_are_told_with_the_way_out(tmp_path: Path) -> None:
    """A name that is nearly right, a plan that is to be no SVG, a port that there is not."""
    layout = tmp_path / "halt.yaml"
    layout.write_text(Path("layouts/fig2_2.yaml").read_text("utf-8"), "utf-8")
    missed = run("check", str(tmp_path / "halt.yml"))
    assert missed.exit_code == 1 and f"did you mean {layout}?" in missed.output
    drawn = run("draw", str(layout), "-o", str(tmp_path / "halt.pdf"))
    assert drawn.exit_code == 2 and "call it halt.svg" in drawn.output and not (tmp_path / "halt.pdf").exists()
    far = run("run", str(layout), "--modbus", "localhost:99999")
    assert far.exit_code == 2 and "between 1 and 65535" in far.output


def test_a_certificate_without_outputs_is_refused_before_the_proof(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def never(*args: object, **more: object) -> None:
        raise AssertionError("proved")

    monkeypatch.setattr("interlock.app.certify.build_derived", never)
    args = ("certify", "layouts/fig2_2.yaml", "--outputs", str(tmp_path / "g"), "-o", str(tmp_path / "p"))
    done = run(*args)
    said = " ".join(done.stdout.split())
    assert done.exit_code == 1 and "IL5003" in said and f"{tmp_path}/g/fig2_2: there are no outputs" in said
    assert f"run `interlock compile layouts/fig2_2.yaml -o {tmp_path}/g`" in said
    (body,) = json.loads(run(*args, "--format", "json").stdout)
    assert not body["ok"] and [d["code"] for d in body["diagnostics"]] == ["IL5003"]


@pytest.mark.parametrize(
    ("asked", "again"),
    [
        (("all",), "--dialect all"),
        (("all", "iec", "codesys"), "--dialect all"),
        (("codesys", "codesys"), "--dialect codesys"),
    ],
)
def test_the_command_that_writes_outputs_again_names_each_dialect_once(
    asked: tuple[str, ...], again: str, tmp_path: Path
) -> None:
    options = [x for d in asked for x in ("--dialect", d)]
    done = run("compile", "layouts/fig2_2.yaml", "-o", str(tmp_path), "--check", "--format", "json", *options)
    (body,) = json.loads(done.stdout)
    fixes = {d["fix"] for d in body["diagnostics"] if d["code"] == "IL5003"}
    assert fixes == {f"run `interlock compile layouts/fig2_2.yaml -o {tmp_path} {again}`"}
