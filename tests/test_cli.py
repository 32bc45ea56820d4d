"""The command line as a user meets it."""

from __future__ import annotations

import json
import re
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import pytest
from click.testing import CliRunner

from interlock.app.explain import explain
from interlock.app.init import STARTER
from interlock.cli.main import VERBS, cli
from interlock.diag import Sink
from interlock.diag.codes import CODES
from interlock.frontend import load_text
from interlock.frontend.published import language_keys
from interlock.frontend.schema import LayoutFile
from interlock.logic.plant import ASSUMPTIONS, OF_PLC
from interlock.model.principles import KNOBS
from interlock.proof.claims import CLAIMS
from interlock.proof.functions import FUNCTIONS
from interlock.proof.induction.verdict import Witness
from interlock.proof.system.loop import ClosedLoop
from interlock.proof.witnesses.routes import witnesses
from tests.cli_runs import process, run
from tests.layouts import built


def test_help_names_every_verb_and_the_first_command() -> None:
    done = process("--help")
    assert done.returncode == 0 and "interlock init -o NAME.yaml" in done.stdout
    for verb in VERBS:
        assert f"  {verb} " in done.stdout


@pytest.mark.parametrize("verb", ["check", "compile", "pin", "prove", "draw", "why", "dispatch", "simulate", "blocks"])
def test_a_layout_that_cannot_be_opened_is_a_diagnostic_without_a_line(verb: str) -> None:
    body = json.loads(CliRunner().invoke(cli, [verb, "missing.yaml", "--format", "json"]).stdout)
    (found,) = (body[0] if isinstance(body, list) else body)["diagnostics"]
    assert (found["code"], found["file"]) == ("IL1001", "missing.yaml")
    assert (found["line"], found["column"], found["width"], found["source"]) == (None,) * 4
    assert "error" not in body


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


def test_diagnostics_are_listed_in_the_order_of_their_codes() -> None:
    listed = [line.split()[0] for line in run("explain").output.splitlines()]
    assert [code for code in listed if code in CODES] == sorted(CODES)


def test_pages_are_read_where_the_wheel_is() -> None:
    """What a message sends somebody to is there: a wheel has no folder docs that anybody finds."""
    listed = {line.split()[0] for line in run("explain").output.splitlines()}
    assert {"panel", "dispatch", "language", "plc", "record", "library", "shift"} <= listed
    assert run("explain", "dispatch").output == Path("interlock/docs/dispatch.md").read_text("utf-8")
    assert "`interlock explain dispatch` has its keys" in run("blocks", "layouts/fig2_2.yaml").output


def test_explain_knows_diagnostics_rules_claims_assumptions_and_principles() -> None:
    known = {line.split()[0] for line in run("explain").output.splitlines()}
    assert {*CODES, *CLAIMS, *FUNCTIONS, *ASSUMPTIONS, *OF_PLC, *KNOBS, "R1", "R18"} <= known
    for code, said in (
        ("R5", "Flank protection"),
        ("r6.2", "Hostile routes"),
        ("t-collision", CLAIMS["T-COLLISION"]),
        ("A-SCAN", ASSUMPTIONS["A-SCAN"]),
        ("A-CLOCK", OF_PLC["A-CLOCK"]),
        ("F-GRANT", FUNCTIONS["F-GRANT"]),
        ("release_delay_s", "without a break"),
        ("approach_release_s", "| uk | 120 |"),
    ):
        done = run("explain", code)
        assert done.exit_code == 0 and said in done.output, code
        body = json.loads(run("explain", code, "--format", "json").output)[0]
        assert body["page"] == done.output and body["kind"] in ("rule", "claim", "function", "assumption", "principle")
    assert "at half of `line_speed_kmh` at least" in run("explain", "A-RESTART").output
    assert "no train, is shorter" in run("explain", "A-SCAN").output
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
    assert "did you mean overlaps?" in run("explain", "overlap").output
    assert "document D" in run("explain", "rules").output
    assert "interlock explain language" in run("--help").output and "`interlock explain signals`" in STARTER


def test_explain_knows_the_keys_inside_of_the_keys_of_the_layout() -> None:
    """Each with its meaning wherever it stands, and with the rules and diagnostics that speak of it."""
    done = run("explain", "air_lock")
    assert done.exit_code == 0 and done.output.startswith("# air_lock, a key\n\n`air_lock` is a key of `interlocks`.\n")
    assert "of its doors never more than one is open |\n" in done.output and "interlocks: {" in done.output
    assert all(f"`interlock explain {code}`" in done.output for code in ("R13", "IL3048", "IL4022", "interlocks"))
    assert run("explain", "Air_Lock").output == done.output
    (body,) = json.loads(run("explain", "air_lock", "--format", "json").output)
    assert body["kind"] == "key" and body["code"] == "air_lock" and body["page"] == done.output
    legs = run("explain", "legs").output
    assert "`legs` is a key of `points`, `crossings`" in legs and "## `crossings`" in legs and "explain IL3042" in legs
    words = {w for part in language_keys().split("### ")[1:] for w in re.findall(r"^\| `(\w+)` \|", part, re.MULTILINE)}
    assert len(words) > 60
    for word in sorted(words):
        page = explain(word)
        assert page is not None and f"# {word}, a" in page, word


def test_an_empty_cell_is_told() -> None:
    done = run("why", "layouts/fig2_2.yaml", "X1-A", "overlap")
    assert done.exit_code == 0 and done.output == "X1-A has nothing in the column Overlap\n"


def test_what_cannot_be_played_is_named(tmp_path: Path) -> None:
    done = run("play", "layouts/fig2_2.yaml", "-o", str(tmp_path / "x.html"))
    assert done.exit_code == 1 and "error: layouts/fig2_2.yaml: not an ITF trace" in done.output


def test_a_family_of_mutants_that_is_not_there_is_told() -> None:
    done = run("mutate", "layouts/fig2_2.yaml", "--family", "output YX")
    assert done.exit_code == 2 and "no mutant of the family 'output YX' here; there is output Y" in done.output


def test_a_route_that_no_run_drives_is_told_as_that(monkeypatch: pytest.MonkeyPatch) -> None:
    """Nothing is unsafe: all claims are proved."""

    def one_stands(loop: ClosedLoop) -> tuple[Witness, ...]:
        first, *others = witnesses(loop)
        return (replace(first, ok=False, text="it stands in section q2"), *others)

    monkeypatch.setattr("interlock.proof.prover.witnesses", one_stands)
    done = run("prove", "layouts/fig2_1.yaml")
    assert done.exit_code == 1 and "CANNOT BE DRIVEN" in done.output and "NOT SAFE" not in done.output
    assert "error[IL4006]: route " in done.output and "cannot be driven: it stands in section q2" in done.output
