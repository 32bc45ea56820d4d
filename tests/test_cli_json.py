"""What every command says as JSON."""

from __future__ import annotations

import json
import re
import subprocess
import sys
from pathlib import Path

import pytest

from interlock.cli.main import VERBS
from tests.cli_runs import process, run


def test_json_that_does_not_fit_is_said_where_there_is_room() -> None:
    args = (sys.executable, "-m", "interlock", "check", "layouts/fig2_2.yaml", "--format", "json")
    with Path("/dev/full").open("w") as full:
        lost = subprocess.run(args, stdout=full, stderr=subprocess.PIPE, text=True, check=False)
    assert lost.returncode == 1 and "does not fit" in lost.stderr and "Traceback" not in lost.stderr


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
    ("commission", "{}/l.yaml", "-o", "{}/t.csv"),
    ("commission", "{}/bad.yaml", "-o", "{}/t.csv"),
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
    ("diff", "{}/l.yaml", "{}/l.yaml"),
    ("diff", "{}/l.yaml", "layouts/junction.yaml"),
    ("diff", "{}/l.yaml", "{}/bad.yaml"),
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
    wrong, outputs = "layouts/refuted/wrong_waiver.yaml", str(tmp_path / "g")
    assert run("compile", wrong, "-o", outputs, "--unproved").exit_code == 1
    refuted = run("certify", wrong, "--outputs", outputs, "-o", str(tmp_path / "p"), "--format", "json")
    claims = {c["id"]: c for c in json.loads(refuted.stdout)[0]["claims"]}
    assert refuted.exit_code == 1 and claims["T-FLANK"]["verdict"] == "REFUTED" and claims["T-FLANK"]["story"]


def test_pairs_that_fail_are_played_in_json_too(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from interlock.cli import availability as module

    monkeypatch.setattr(module, "write_stories", lambda tried, folder: (folder / "x.html",))
    done = run("availability", "layouts/fig2_2.yaml", "--traces", str(tmp_path), "--format", "json")
    assert json.loads(done.stdout)["pages"] == [str(tmp_path / "x.html")]


NOT_DONE = [
    ("check", "nowhere.yaml"),
    ("compile", "layouts/fig2_2.yaml", "-o", "/proc/x"),
    ("dispatch", "layouts/fig2_2.yaml"),
    ("simulate", "layouts/fig2_2.yaml"),
    ("blocks", "layouts/fig2_2.yaml"),
    ("why", "layouts/fig2_2.yaml", "X9"),
    ("draw", "layouts/fig2_2.yaml", "-o", "nodir/x.svg"),
    ("export", "layouts/fig2_2.yaml", "-o", "nodir/x.aig"),
    ("explain", "R99"),
    ("play", "nowhere.json"),
    ("certify", "layouts/fig2_2.yaml", "--check", "-o", "/proc/x"),
    ("record", "nowhere.jsonl"),
]


@pytest.mark.parametrize("arguments", NOT_DONE, ids=" ".join)
def test_diagnostics_go_to_the_standard_output_and_what_json_calls_an_error_to_the_standard_error(
    arguments: tuple[str, ...],
) -> None:
    """As the README says."""
    asked = run(*arguments, "--format", "json")
    found = json.loads(asked.stdout)
    body = found[0] if isinstance(found, list) else found
    plain = run(*arguments)
    said = [bool(re.search(r"\berror(\[IL\d{4}\])?: ", x)) for x in (plain.stdout, plain.stderr)]
    if body.get("error"):
        assert said == [False, True] and body["error"].splitlines()[0] in plain.stderr
    else:
        assert said == [True, False] and body["diagnostics"][0]["message"] in " ".join(plain.stdout.split())
    assert plain.exit_code == asked.exit_code != 0
