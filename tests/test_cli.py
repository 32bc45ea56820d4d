"""The command line as a user meets it."""

from __future__ import annotations

import json
import os
import re
import resource
import signal
import subprocess
import sys
import time
from dataclasses import replace
from pathlib import Path

import click
import pytest
from click.testing import CliRunner, Result

from interlock.app.explain import explain
from interlock.app.init import STARTER, yard
from interlock.cli import common
from interlock.cli.main import VERBS, cli
from interlock.diag import Sink
from interlock.diag.codes import CODES
from interlock.frontend import load_text
from interlock.frontend.schema import LayoutFile
from interlock.logic.plant import ASSUMPTIONS, OF_TIMERS
from interlock.model.principles import KNOBS
from interlock.proof.claims import CLAIMS
from interlock.proof.functions import FUNCTIONS
from interlock.proof.induction.verdict import Witness
from interlock.proof.system.loop import ClosedLoop
from interlock.proof.witnesses.routes import witnesses
from tests.layouts import built


def run(*args: str) -> Result:
    return CliRunner().invoke(cli, list(args))


def process(*args: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run([sys.executable, "-m", "interlock", *args], capture_output=True, text=True, check=False)


def test_help_names_every_verb_and_the_first_command() -> None:
    done = process("--help")
    assert done.returncode == 0 and "interlock init -o NAME.yaml" in done.stdout
    for verb in VERBS:
        assert f"  {verb} " in done.stdout


@pytest.mark.parametrize("closed", [(0,), (1,), (2,), (0, 1, 2)], ids=str)
def test_a_service_that_closes_the_streams_gets_its_answer(closed: tuple[int, ...]) -> None:
    args = (sys.executable, "-m", "interlock", "check", "layouts/fig2_2.yaml")
    done = subprocess.run(
        args, capture_output=True, text=True, check=False, preexec_fn=lambda: [os.close(n) for n in closed]
    )
    assert done.returncode == 0 and "error" not in done.stdout + done.stderr
    assert ("no problems" in done.stdout) is (1 not in closed)


@pytest.mark.parametrize("verb", ["check", "compile", "pin", "prove", "draw", "why", "dispatch", "simulate", "blocks"])
def test_a_layout_that_cannot_be_opened_is_a_diagnostic_without_a_line(verb: str) -> None:
    body = json.loads(CliRunner().invoke(cli, [verb, "missing.yaml", "--format", "json"]).stdout)
    (found,) = (body[0] if isinstance(body, list) else body)["diagnostics"]
    assert (found["code"], found["file"]) == ("IL1001", "missing.yaml")
    assert (found["line"], found["column"], found["width"], found["source"]) == (None,) * 4
    assert "error" not in body


@pytest.mark.parametrize(
    "args",
    [
        ("check", "layouts/cn6502.yaml"),
        ("check", "missing.yaml", "--format", "json"),
        ("why", "layouts/fig2_2.yaml"),
        ("explain",),
        ("schema",),
        ("draw", "missing.yaml"),
        ("--help",),
        ("schema", "--of", "nothing", "--format", "json"),
    ],
    ids=" ".join,
)
def test_a_reader_that_closes_the_pipe_ends_every_command_alike_and_quietly(args: tuple[str, ...]) -> None:
    read, write = os.pipe()
    os.close(read)
    command = (sys.executable, "-m", "interlock", *args)
    done = subprocess.run(command, stdout=write, stderr=subprocess.PIPE, text=True, check=False)
    os.close(write)
    assert done.returncode == 141
    assert "Traceback" not in done.stderr and "rror" not in done.stderr


def test_what_two_options_ask_for_is_not_half_done(tmp_path: Path) -> None:
    done = run("draw", "layouts/fig2_2.yaml", "--sheets", "--fold", "-o", str(tmp_path / "plan.svg"))
    assert done.exit_code == 2 and "choose one" in done.output and not list(tmp_path.iterdir())
    done = run("play", "")
    assert done.exit_code == 2 and "name the trace" in done.output


def test_json_that_does_not_fit_is_said_where_there_is_room() -> None:
    args = (sys.executable, "-m", "interlock", "check", "layouts/fig2_2.yaml", "--format", "json")
    with Path("/dev/full").open("w") as full:
        lost = subprocess.run(args, stdout=full, stderr=subprocess.PIPE, text=True, check=False)
    assert lost.returncode == 1 and "does not fit" in lost.stderr and "Traceback" not in lost.stderr


def test_where_there_is_no_room_what_was_there_stays(tmp_path: Path) -> None:
    """A plan that does not fit leaves the one of before, and nothing half-written."""
    plan = tmp_path / "plan.svg"
    args = (sys.executable, "-m", "interlock", "draw", "layouts/fig2_2.yaml", "-o", str(plan))
    small = lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (2000, 2000))  # noqa: E731
    full = subprocess.run(args, capture_output=True, text=True, check=False, preexec_fn=small)
    assert full.returncode == 1 and "File too large" in full.stderr and not list(tmp_path.iterdir())
    assert subprocess.run(args, capture_output=True, check=False).returncode == 0
    before = plan.read_bytes()
    full = subprocess.run(args, capture_output=True, text=True, check=False, preexec_fn=small)
    assert full.returncode == 1 and plan.read_bytes() == before and list(tmp_path.iterdir()) == [plan]


def test_nothing_said_is_lost_at_the_end(tmp_path: Path) -> None:
    """The process ends at once; what it wrote is there, and its code tells what happened."""
    for args, code, said in (
        (["prove", "layouts/fig2_2.yaml", "--format", "json"], 0, '"text_equals_controller": true'),
        (["check", str(tmp_path / "none.yaml")], 1, "none.yaml"),
        (["prove"], 2, "Usage"),
    ):
        done = process(*args)
        assert done.returncode == code and said in done.stdout + done.stderr
    for verb in ("prove", "check"):
        with Path("/dev/full").open("w") as full:
            args = [sys.executable, "-m", "interlock", verb, "layouts/fig2_2.yaml"]
            lost = subprocess.run(args, stdout=full, stderr=subprocess.PIPE, text=True, check=False)
        assert lost.returncode == 1 and "internal" not in lost.stderr, lost.stderr
    out = tmp_path / "out.json"
    with out.open("w") as file:
        args = [sys.executable, "-m", "interlock", "prove", "layouts/passing_loop.yaml", "--format", "json"]
        subprocess.run(args, stdout=file, check=True)
    assert json.loads(out.read_text())[0]["text_equals_controller"] is True


def test_help_loads_neither_solver_nor_schema() -> None:
    code = "import sys; sys.argv=['interlock','--help']\nfrom interlock.cli.main import cli\n"
    code += "try: cli()\nexcept SystemExit: pass\n"
    code += "print(sorted({'z3', 'pydantic', 'lark', 'rich', 'jinja2'} & set(sys.modules)))"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip().endswith("[]")


@pytest.mark.parametrize("verb", list(VERBS))
def test_every_verb_has_help(verb: str) -> None:
    assert run(verb, "--help").exit_code == 0


def test_usage_errors_end_with_2_and_say_what_to_do() -> None:
    done = process("layouts/mine11.yaml")
    assert done.returncode == 2 and "interlock compile layouts/mine11.yaml" in done.stderr
    done = process("chek", "layouts/mine11.yaml")
    assert done.returncode == 2 and "Did you mean check?" in done.stderr
    assert process("check").returncode == 2


def test_check() -> None:
    done = run("check", "layouts/mine11.yaml", "layouts/junction.yaml")
    assert done.exit_code == 0 and "layouts/junction.yaml: no problems, 11 routes" in done.output
    done = run("check", "tests/diagnostics/IL2004.yaml", "--format", "json")
    body = json.loads(done.stdout)
    assert (
        done.exit_code == 1
        and body[0]["diagnostics"][0]["code"] == "IL2004"
        and body[0]["diagnostics"][0]["line"] == 16
    )


def test_prove_as_json_names_claims_with_verdict_sentence_and_seconds() -> None:
    done = run("prove", "layouts/fig2_2.yaml", "--format", "json")
    body = json.loads(done.stdout)[0]
    assert done.exit_code == 0 and body["ok"] and body["text_equals_controller"]
    for claim in body["claims"]:
        assert {"id", "verdict", "sentence", "seconds", "places"} <= set(claim) and claim["verdict"] == "PROVED"


def test_a_refuted_layout_ends_with_1_and_tells_its_story(tmp_path: Path) -> None:
    done = run("prove", "layouts/refuted/wrong_waiver.yaml", "--traces", str(tmp_path))
    assert done.exit_code == 1
    assert "Counterexample to T-FLANK:" in done.output and "    1. Restart:" in done.output
    assert "NOT SAFE" in done.output


def test_what_cannot_be_decided_ends_with_3() -> None:
    done = run("prove", "layouts/refuted/wrong_waiver.yaml", "--search-depth", "1", "--search-seconds", "5")
    assert done.exit_code == 3 and "COULD NOT BE PROVED" in done.output and "IL5002" in done.output


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


def test_why_without_a_route_lists_those_that_there_are() -> None:
    done = run("why", "layouts/junction.yaml")
    listed = {line.split()[0]: line for line in done.output.splitlines() if " over " in line}
    table = built("junction")[1]
    assert done.exit_code == 0 and listed.keys() == {r.id for r in table.routes}
    assert all(c.section in listed[r.id] for r in table.routes for c in r.clear.sections)
    found = json.loads(run("why", "layouts/junction.yaml", "--format", "json").output)
    assert [r["route"] for r in found["routes"]] == [r.id for r in table.routes]
    assert run("why", "tests/diagnostics/IL4003.yaml").exit_code == 1


def test_why_names_rule_and_reason() -> None:
    done = run("why", "layouts/junction.yaml", "S2J-S6", "flank_points")
    assert done.exit_code == 0 and "101 N" in done.output and "R5" in done.output
    done = run("why", "layouts/mine11.yaml", "j1")
    assert done.exit_code == 0 and "Hostile routes" in done.output
    done = run("why", "layouts/mine11.yaml", "X1-X33")
    assert done.exit_code == 1 and "did you mean X1-X3?" in done.output
    done = run("why", "layouts/mine11.yaml", "j1", "sectoins")
    assert done.exit_code == 1 and "did you mean sections?" in done.output


def test_explain() -> None:
    assert "anchors" in run("explain", "IL1006").output
    assert run("explain", "il1006").exit_code == 0
    done = run("explain", "IL9999")
    assert done.exit_code == 1
    assert json.loads(run("explain", "IL4001", "--format", "json").output)[0]["severity"] == "error"


def test_pages_are_read_where_the_wheel_is() -> None:
    """What a message sends somebody to is there: a wheel has no folder docs that anybody finds."""
    listed = {line.split()[0] for line in run("explain").output.splitlines()}
    assert {"panel", "dispatch", "language", "plc", "record", "library", "shift"} <= listed
    assert run("explain", "dispatch").output == Path("interlock/docs/dispatch.md").read_text("utf-8")
    assert "`interlock explain dispatch` has its keys" in run("blocks", "layouts/fig2_2.yaml").output


def test_explain_knows_diagnostics_rules_claims_assumptions_and_principles() -> None:
    known = {line.split()[0] for line in run("explain").output.splitlines()}
    assert {*CODES, *CLAIMS, *FUNCTIONS, *ASSUMPTIONS, *OF_TIMERS, *KNOBS, "R1", "R18"} <= known
    for code, said in (
        ("R5", "Flank protection"),
        ("r6.2", "Hostile routes"),
        ("t-collision", CLAIMS["T-COLLISION"]),
        ("A-SCAN", ASSUMPTIONS["A-SCAN"]),
        ("A-CLOCK", OF_TIMERS["A-CLOCK"]),
        ("F-GRANT", FUNCTIONS["F-GRANT"]),
        ("release_delay_s", "without a break"),
        ("approach_release_s", "| uk | 120 |"),
    ):
        done = run("explain", code)
        assert done.exit_code == 0 and said in done.output, code
        body = json.loads(run("explain", code, "--format", "json").output)[0]
        assert body["page"] == done.output and body["kind"] in ("rule", "claim", "function", "assumption", "principle")
    assert "did you mean A-SCAN?" in run("explain", "A-SCANN").output


def test_explain_knows_every_key_of_the_layout_with_an_example_that_can_be_read() -> None:
    keys = set(LayoutFile.model_fields)
    listed = {line.split()[0] for line in run("explain").output.splitlines() if line.split()[1] == "key"}
    assert listed == keys
    for key in sorted(keys):
        page = explain(key)
        assert page is not None
        shown = page.split("For instance `")[1].split("`.")[0]
        sink = Sink()
        text = {"interlock": "interlock: 1", "name": "name: x"} | {key: shown}
        load_text("example.yaml", "\n".join((*text.values(), *([] if key == "tracks" else ["tracks: {}"]))), sink)
        assert not [d for d in sink.diagnostics if d.code.startswith("IL1")], (key, shown)
    assert (
        "| `not_over` |" in run("explain", "overlaps").output
        and "## `overlaps.ways`" in run("explain", "overlaps").output
    )
    assert "`legs` is a key of `points`, `crossings`" in run("explain", "legs").output
    assert "did you mean overlaps?" in run("explain", "overlap").output
    assert "document D" in run("explain", "rules").output
    assert "interlock explain language" in run("--help").output and "`interlock explain signals`" in STARTER


@pytest.fixture(scope="module")
def certified_loop(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with a small layout, its outputs, its certificate, and one that is refuted with a trace."""
    folder = tmp_path_factory.mktemp("json")
    (folder / "l.yaml").write_text(Path("layouts/fig2_2.yaml").read_text("utf-8"), "utf-8")
    (folder / "pinned.yaml").write_text(Path("layouts/fig2_2.yaml").read_text("utf-8"), "utf-8")
    (folder / "bad.yaml").write_text("interlock: 1\nname: bad\ncolour: red\n", "utf-8")
    args = ["certify", str(folder / "l.yaml"), "--outputs", str(folder / "g"), "-o", str(folder / "p")]
    assert run("compile", str(folder / "l.yaml"), "-o", str(folder / "g")).exit_code == 0
    assert run(*args).exit_code == 0
    done = run("prove", "layouts/refuted/wrong_waiver.yaml", "--traces", str(folder / "t"), "--format", "json")
    assert done.exit_code == 1 and json.loads(done.stdout)[0]["pages"]
    return folder


JSON = (
    ("init",),
    ("init", "-o", "{}/new.yaml"),
    ("init", "-o", "{}/l.yaml"),
    ("check", "{}/l.yaml", "{}/bad.yaml"),
    ("compile", "{}/l.yaml", "-o", "{}/g2"),
    ("compile", "{}/l.yaml", "{}/l.yaml", "{}/bad.yaml", "-o", "{}/g2"),
    ("pin", "{}/pinned.yaml"),
    ("pin", "{}/pinned.yaml", "--release", "nothing"),
    ("pin", "{}/bad.yaml"),
    ("prove", "{}/l.yaml"),
    ("certify", "{}/l.yaml", "--outputs", "{}/g", "-o", "{}/p", "--check"),
    ("certify", "{}/bad.yaml", "--outputs", "{}/g", "-o", "{}/p"),
    ("verify", "{}/p/fig2_2"),
    ("verify", "{}/g/fig2_2"),
    ("verify", "{}/l.yaml", "{}/p/fig2_2"),
    ("export", "{}/l.yaml", "-o", "{}/x.aig"),
    ("export", "{}/bad.yaml", "-o", "{}/x.aig"),
    ("draw", "{}/l.yaml", "-o", "{}/l.svg"),
    ("draw", "{}/l.yaml", "-o", "{}/l.yaml"),
    ("draw", "{}/bad.yaml"),
    ("play", "{}/t/wrong_waiver-T-FLANK.itf.json", "-o", "{}/x.html"),
    ("play", "{}/none.json"),
    ("why", "{}/l.yaml", "X1-A"),
    ("why", "{}/l.yaml", "nothing"),
    ("explain",),
    ("explain", "nothing"),
    ("mutate", "{}/l.yaml", "--family", "initial RQZ"),
    ("mutate", "{}/bad.yaml"),
    ("schema",),
    ("availability", "{}/l.yaml"),
    ("availability", "{}/bad.yaml"),
    ("dispatch", "{}/l.yaml", "1:X1>A"),
    ("dispatch", "{}/bad.yaml", "1:W>E"),
    ("blocks", "layouts/mine11.yaml"),
    ("blocks", "{}/bad.yaml"),
    ("schedule", "tests/schedules/swap.json"),
    ("schedule", "{}/l.yaml"),
    ("simulate", "layouts/heishan.yaml", "--hours", "1"),
    ("simulate", "{}/bad.yaml"),
    ("record", "{}/l.yaml"),
    ("record", "{}/none.log"),
)


@pytest.mark.parametrize("args", JSON, ids=" ".join)
def test_every_command_speaks_json_and_nothing_else(args: tuple[str, ...], certified_loop: Path) -> None:
    done = run(*(a.format(certified_loop) for a in args), "--format", "json")
    assert done.exit_code in (0, 1, 3), done.output
    json.loads(done.stdout)


@pytest.mark.parametrize(
    ("args", "said"),
    [
        (("check",), "Missing argument 'LAYOUT...'."),
        (("init", "--yard", "3"), "3 is not in the range 4<=x<=2000"),
        (("compile", "l.yaml", "--dialect", "none"), "'none' is not one of"),
        (("verify", "nothing"), "'nothing' does not exist"),
        (("prove", "l.yaml", "--colour"), "No such option"),
        (("mutate", "layouts/fig2_2.yaml", "--family", "output YX"), "no mutant of the family 'output YX'"),
        (("nothing",), "No such command 'nothing'."),
    ],
    ids=" ".join,
)
def test_a_usage_error_is_json_where_json_is_asked_for(args: tuple[str, ...], said: str) -> None:
    done = process(*args, "--format=json")
    body = json.loads(done.stdout)
    assert done.returncode == 2 and not body["ok"] and said in body["error"] and "--help" in body["fix"], done.stdout
    assert "rror" not in done.stderr
    plain = process(*args)
    assert plain.returncode == 2 and said in plain.stderr and not plain.stdout


def test_json_is_asked_of_every_command() -> None:
    assert {args[0] for args in JSON} | {"run"} == set(VERBS)


def test_json_says_what_is_said_to_people(tmp_path: Path, certified_loop: Path) -> None:
    """Where files are, how many runs there were, which claims a certificate lacks; and the pages are written."""
    loop = str(certified_loop / "l.yaml")
    compiled = json.loads(run("compile", loop, "-o", str(tmp_path / "g"), "--format", "json").stdout)
    assert compiled[0]["folder"] == str(tmp_path / "g" / "fig2_2")
    args = ("certify", loop, "--outputs", str(certified_loop / "g"), "-o", str(certified_loop / "p"), "--check")
    certified = json.loads(run(*args, "--format", "json").stdout)
    folder = str(certified_loop / "p" / "fig2_2")
    assert certified[0]["folder"] == folder and folder in run(*args).output
    verified = json.loads(run("verify", folder, "--format", "json").stdout)
    assert verified[0]["ok"] and verified[0]["wall_seconds"] > 0
    tried = run("availability", loop)
    assert f"in {json.loads(run('availability', loop, '--format', 'json').stdout)['runs']} runs" in tried.output
    refuted = run("certify", "layouts/refuted/wrong_waiver.yaml", "-o", str(tmp_path / "p"), "--format", "json")
    claims = {c["id"]: c for c in json.loads(refuted.stdout)[0]["claims"]}
    assert refuted.exit_code == 1 and claims["T-FLANK"]["verdict"] == "REFUTED" and claims["T-FLANK"]["story"]


def test_pairs_that_fail_are_played_in_json_too(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from interlock.cli import availability as module

    monkeypatch.setattr(module, "write_stories", lambda tried, folder: (folder / "x.html",))
    done = run("availability", "layouts/fig2_2.yaml", "--traces", str(tmp_path), "--format", "json")
    assert json.loads(done.stdout)["pages"] == [str(tmp_path / "x.html")]


def test_an_empty_cell_is_told() -> None:
    done = run("why", "layouts/fig2_2.yaml", "X1-A", "overlap")
    assert done.exit_code == 0 and done.output == "X1-A has nothing in the column Overlap\n"


def test_what_cannot_be_played_is_named(tmp_path: Path) -> None:
    done = run("play", "layouts/fig2_2.yaml", "-o", str(tmp_path / "x.html"))
    assert done.exit_code == 1 and "error: layouts/fig2_2.yaml: not an ITF trace" in done.output


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


def test_colour_is_for_terminals(monkeypatch: pytest.MonkeyPatch) -> None:
    args = ["check", "tests/diagnostics/IL2004.yaml"]
    plain = CliRunner().invoke(cli, args)
    assert "\x1b[" not in plain.output and "\x1b[" not in CliRunner().invoke(cli, args, color=True).output  # NO_COLOR
    monkeypatch.delenv("NO_COLOR")
    coloured = CliRunner().invoke(cli, args, color=True).output
    assert "\x1b[31m" in coloured and click.unstyle(coloured).split(",")[0] == plain.output.split(",")[0]


def on_a_terminal(*args: str) -> str:
    """What a command writes to a terminal."""
    controller, terminal = os.openpty()
    command = [sys.executable, "-m", "interlock", *args]
    with subprocess.Popen(command, stdout=terminal, stderr=terminal, env={**os.environ, "TERM": "xterm"}) as running:
        os.close(terminal)
        said = b""
        try:
            while chunk := os.read(controller, 4096):
                said += chunk
        except OSError:  # the other end is closed
            pass
        running.wait()
    os.close(controller)
    return said.decode()


def test_a_terminal_sees_a_bar(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "yard.yaml").write_text(yard(16), "utf-8")
    monkeypatch.chdir(tmp_path)
    said = on_a_terminal("prove", "yard.yaml")
    assert "\x1b[?25l" in said and "yard.yaml: proving" in said and "PROVED" in said


def test_the_bar_moves_in_every_stage() -> None:
    bar = common._Bar("yard.yaml")
    try:
        bar._begin()
        for stage, done, total in (("deriving", 0, 0), ("proving", 7, 40), ("searching", 3, 16)):
            bar.report(stage, done, total)
            (task,) = bar._bar.tasks
            assert (task.description, task.completed, task.total) == (f"yard.yaml: {stage}", done, total or None)
    finally:
        bar.end()


def test_elsewhere_each_stage_is_a_line(tmp_path: Path) -> None:
    done = process("compile", "layouts/fig2_2.yaml", "-o", str(tmp_path))
    stages = [line.removeprefix("layouts/fig2_2.yaml: ") for line in done.stderr.splitlines()]
    assert stages == ["deriving", "proving", "auditing the table", "comparing the texts", "writing tables and plan"]
    loop = "layouts/fig2_2.yaml"
    for stage, args in {
        "running every two routes": ("availability", loop),
        "drawing": ("draw", loop, "-o", str(tmp_path / "l.svg")),
        "making the circuit": ("export", loop, "-o", str(tmp_path / "l.aig")),
        "planning": ("dispatch", loop, "1:X1>A"),
        "judging mutants": ("mutate", loop, "--family", "initial RQZ"),
    }.items():
        assert process(*args).stderr.splitlines()[0] == f"{loop}: {stage}"
    done = process("check", "layouts/fig2_2.yaml")
    assert re.search(r"no problems, 4 routes, \d+\.\d s$", done.stdout.strip())


def test_an_internal_error_gives_no_traceback(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    from interlock.cli import main as module

    def broken(**_: object) -> None:
        raise ZeroDivisionError("one over nothing")

    monkeypatch.setattr(module, "cli", broken)
    with pytest.raises(SystemExit) as stop:
        module.main()
    assert stop.value.code == 70 and "Traceback" not in capsys.readouterr().err
    monkeypatch.setattr(sys, "argv", ["interlock", "check", "x.yaml", "--format", "json"])
    with pytest.raises(SystemExit) as stop:
        module.main()
    said = capsys.readouterr()
    assert stop.value.code == 70 and "one over nothing" in json.loads(said.out)["error"] and not said.err


def test_the_same_layout_gives_the_same_bytes() -> None:
    from interlock.app.compile import build, finish

    a, files_a = build("layouts/fig2_3_split.yaml")
    build("layouts/fig2_2.yaml")
    b, files_b = build("layouts/fig2_3_split.yaml")
    assert finish(a.checked, files_a) == finish(b.checked, files_b)


def test_the_bytes_do_not_depend_on_the_process(tmp_path: Path) -> None:
    import os

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


@pytest.mark.parametrize(("given", "after"), [(("prove", "yard.yaml", "-j", "2"), 2), (("prove", "yard.yaml"), 6)])
def test_an_interrupt_ends_all_processes_without_a_word_of_python(
    given: tuple[str, ...], after: int, tmp_path: Path
) -> None:
    """In the midst of it: with texts and runs beside the proof, and in a solver."""
    (tmp_path / "yard.yaml").write_text(yard(124), encoding="utf-8")
    interrupted(given, after, tmp_path)


def test_an_interrupt_ends_the_proofs_of_several_layouts(tmp_path: Path) -> None:
    for n in range(4):
        (tmp_path / f"y{n}.yaml").write_text(yard(60).replace("name: ", f"name: y{n}_"), encoding="utf-8")
    interrupted(("prove", *sorted(p.name for p in tmp_path.iterdir()), "-j", "2"), 3, tmp_path)


def test_an_interrupt_ends_shifts_that_only_begin(tmp_path: Path) -> None:
    """Processes that are being started are in the midst of reading Python's own modules."""
    for name in ("heishan.yaml", "heishan.dispatch"):
        (tmp_path / name).write_text(Path(f"layouts/{name}").read_text("utf-8"), encoding="utf-8")
    interrupted(("simulate", "heishan.yaml", "--shifts", "2000", "-j", "2"), 2.5, tmp_path)


def interrupted(given: tuple[str, ...], after: float, folder: Path) -> None:
    """Run a command, press Ctrl-C after some seconds, and see that nothing is left of it."""
    program = [sys.executable, "-m", "interlock", *given]
    with subprocess.Popen(
        program, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, start_new_session=True, text=True
    ) as running:
        time.sleep(after)
        os.killpg(running.pid, signal.SIGINT)
        said, _ = running.communicate(timeout=30)
    assert running.returncode == 130 and said.splitlines()[-1] == "interrupted" and "Traceback" not in said
    for _ in range(50):
        try:
            os.killpg(running.pid, 0)
        except ProcessLookupError:
            return
        time.sleep(0.1)
    raise AssertionError("a process is left")


def test_a_family_of_mutants_that_is_not_there_is_told() -> None:
    done = run("mutate", "layouts/fig2_2.yaml", "--family", "output YX")
    assert done.exit_code == 2 and "no mutant of the family 'output YX' here; there is output Y" in done.output


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


def test_a_route_that_no_run_drives_is_told_as_that(monkeypatch: pytest.MonkeyPatch) -> None:
    """Nothing is unsafe: all claims are proved."""

    def one_stands(loop: ClosedLoop) -> tuple[Witness, ...]:
        first, *others = witnesses(loop)
        return (replace(first, ok=False, text="it stands in section q2"), *others)

    monkeypatch.setattr("interlock.proof.prover.witnesses", one_stands)
    done = run("prove", "layouts/fig2_1.yaml")
    assert done.exit_code == 1 and "CANNOT BE DRIVEN" in done.output and "NOT SAFE" not in done.output
    assert "error[IL4006]: route " in done.output and "cannot be driven: it stands in section q2" in done.output
