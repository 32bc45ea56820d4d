"""Every code has a page, a trigger and an exact screen; bad input never gives a traceback."""

from __future__ import annotations

import ast
import json
import re
import resource
import subprocess
import sys
from dataclasses import fields, is_dataclass, replace
from pathlib import Path
from typing import Any

import pytest

from interlock.app.check import check_file
from interlock.app.explain import explain
from interlock.derivation import derive
from interlock.diag import Severity, Sink, render
from interlock.diag.codes import CODES, LINTS
from interlock.frontend import load, load_text
from interlock.frontend.examples import BARE, EXAMPLES, LISTS, WHOLE
from interlock.frontend.schema import LayoutFile
from tests.screens import FOLDER, MISTAKES, screen

TRIGGERS = sorted(p.stem for p in FOLDER.glob("*.yaml"))
# shown elsewhere: files that are no text (below), proof and output (test_cli, test_proof)
ELSEWHERE = {
    "IL1001",
    "IL1002",
    "IL1003",
    "IL4006",
    "IL4007",
    "IL5001",
    "IL5007",
    "IL5002",
    "IL5003",
    "IL5004",
    "IL5005",
    "IL5006",
    "IL5008",
    "IL5009",
    "IL5010",
    "IL5012",
    "IL5013",
    *(c for c in CODES if c.startswith("IL6")),  # test_dispatch_language, test_record
}


def test_every_code_is_triggered_somewhere() -> None:
    assert set(TRIGGERS) | ELSEWHERE == set(CODES)
    assert len(TRIGGERS) >= 40


def test_every_warning_of_usual_practice_names_the_element_at_which_it_can_be_allowed() -> None:
    """`allow` finds a warning by the element that it is about: one about none could never be taken away."""
    given = [
        (path, call)
        for path in Path("interlock").rglob("*.py")
        for call in ast.walk(ast.parse(path.read_text("utf-8")))
        if isinstance(call, ast.Call) and isinstance(call.func, ast.Attribute) and call.func.attr == "add"
        if call.args and isinstance(call.args[0], ast.Constant) and call.args[0].value in LINTS
    ]
    assert len(given) >= len(LINTS)
    for path, call in given:
        assert "about" in {k.arg for k in call.keywords}, f"{path}:{call.lineno}"


@pytest.mark.parametrize("code", sorted(CODES))
def test_every_code_has_a_page(code: str) -> None:
    page = explain(code)
    assert page is not None and page.startswith(f"# {code}: {CODES[code][1]}\n")
    assert "**What to do.**" in page


@pytest.mark.parametrize("code", TRIGGERS)
def test_screen(code: str) -> None:
    shown = screen(FOLDER / f"{code}.yaml")
    assert f"[{code}]" in shown
    assert shown == FOLDER.joinpath(f"{code}.txt").read_text("utf-8")


@pytest.mark.parametrize("code", [c for c in TRIGGERS if CODES[c][0] == "error"])
def test_a_layout_with_an_error_gives_no_plc_text(code: str, tmp_path: Path) -> None:
    from interlock.app.compile import compile_file

    done = compile_file(str(FOLDER / f"{code}.yaml"), tmp_path)
    assert not done.green and list(tmp_path.rglob("*.st")) == [] and list(tmp_path.rglob("*.py")) == []


def codes_of(path: Path) -> set[str]:
    return {d.code for d in check_file(str(path)).diagnostics}


def test_files_that_are_no_layout(tmp_path: Path) -> None:
    assert codes_of(tmp_path / "missing.yaml") == {"IL1001"}
    assert codes_of(tmp_path) == {"IL1001"}
    (tmp_path / "pdf.yaml").write_bytes(b"%PDF-1.7\n\xff\xfe\x00\x80")
    assert codes_of(tmp_path / "pdf.yaml") == {"IL1002"}
    big = tmp_path / "big.yaml"
    with open(big, "wb") as handle:
        handle.truncate(50_000_000)
    assert codes_of(big) == {"IL1003"}
    big.write_text("a: " + "x" * 3_000_000)
    assert codes_of(big) == {"IL1009"}


def test_bytes_of_no_known_encoding_are_told_with_place_and_how_to_save(tmp_path: Path) -> None:
    path = tmp_path / "odd.yaml"
    path.write_bytes(b"interlock: 1\r\nname: demo\r\ntitle: \xc3\x9cber \x81 x\r\n")
    (found,) = check_file(str(path)).diagnostics
    assert found.code == "IL1002" and "the byte 129 here (hexadecimal 81)" in found.message
    assert found.span is not None and (found.span.line, found.span.column) == (3, 13)
    assert "save it as UTF-8" in found.fix and "^" in screen(path)
    path.write_bytes(b"\x00\x01\x81program\x00")
    (found,) = check_file(str(path)).diagnostics
    assert found.code == "IL1002" and "zero bytes" in found.message and "text file" in found.fix


def test_a_file_that_may_not_be_read(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def refused(path: str) -> int:
        raise PermissionError(13, "Permission denied", path)

    path = tmp_path / "secret.yaml"
    path.write_text("interlock: 1\n")
    monkeypatch.setattr("os.path.getsize", refused)
    assert codes_of(path) == {"IL1001"}


@pytest.mark.parametrize(
    "text",
    [
        "\0",
        "\ufeffinterlock: 1",
        "&a [*a]",
        "a: &a {b: *a}",
        "? [x]\n: y",
        "- - - -",
        "interlock: 1\nname: x\ntracks: 5",
        "interlock: 1\nname: x\ntracks: {t: [[a]]}",
        "interlock: 1\nname: x\npoints: {P: {}}",
        "{" * 5000,
        "a: |\n  \t x",
        "interlock: 1\nname: x\nsignals: {X: {from: , into: }}",
        "%YAML 9.9\n---\na",
        "interlock: !!float 1\nname: x",
        "interlock: 1\nname: x\ntracks: {t: ['q1 1e400']}",
        "interlock: 1\nname: x\ntracks: {t: ['q1 nan', 'q1 inf']}",
        "interlock: 1\nname: x\ntracks: {t: []}\nsignals: {}",
        "interlock: 1\nname: x\nwaive: [{flank: , reason: }]",
    ],
)
def test_odd_texts_give_diagnostics(text: str) -> None:
    sink = Sink()
    layout, _ = load_text("odd.yaml", text, sink)
    assert layout is None and sink.has_errors


def test_every_problem_of_a_phase_is_reported_at_once() -> None:
    text = Path("layouts/mine11.yaml").read_text("utf-8")
    text = (
        text.replace("into: q2}", "into: q99}").replace("into: q5}", "into: q98}").replace("W, q1 400", "W, q1 400, q1")
    )
    sink = Sink()
    load_text("many.yaml", text, sink)
    assert len([d for d in sink.diagnostics if d.severity == "error"]) >= 3


def test_every_track_without_a_section_is_told_though_another_one_is_wrong_as_well() -> None:
    sink = Sink()
    text = """interlock: 1
name: demo
tracks: {top: [A.normal, C.normal], bot: [A.reverse, C.reverse], c: [C.toe, Q3 300, E], a: [Q1 30 0, A.toe]}
boundaries: {E: {trains: out}}
points: {A: {section: T}, C: {section: U}}
signals: {}
"""
    load_text("demo.yaml", text, sink)
    assert [d.message for d in sink.diagnostics if d.code == "IL3017"] == [
        f"the track {x} has no section" for x in ("top", "bot")
    ]
    assert len({d.code for d in sink.diagnostics}) > 1


def test_line_ends_and_a_byte_order_mark_do_not_matter(tmp_path: Path) -> None:
    text = Path("layouts/fig2_2.yaml").read_bytes()
    path = tmp_path / "dos.yaml"
    path.write_bytes(b"\xef\xbb\xbf" + text.replace(b"\n", b"\r\n"))
    a, _ = load(str(path), Sink())
    b, _ = load("layouts/fig2_2.yaml", Sink())
    assert a is not None and b is not None and a.digest == b.digest


def test_the_digest_ignores_the_order_of_the_source() -> None:
    lines = Path("layouts/fig2_2.yaml").read_text("utf-8")
    swapped = lines.replace(
        "  X1: {from: C, into: DP}\n  X2: {from: A, into: DP}\n",
        "  X2: {from: A, into: DP}\n  X1: {from: C, into: DP}\n",
    )
    assert swapped != lines
    a, _ = load_text("a", lines, Sink())
    b, _ = load_text("b", swapped, Sink())
    assert a is not None and b is not None and a.digest == b.digest


def test_every_fact_of_a_layout_is_in_its_digest() -> None:
    """Whatever part it stands in, under a key of its own; only addresses that stay are no fact about the railway."""
    sink = Sink()
    layout, _ = load("layouts/passing_loop.yaml", sink)
    assert layout is not None
    texts = {}
    for part in fields(layout):
        value = getattr(layout, part.name)
        if not is_dataclass(value) or part.name == "principles":
            texts[part.name] = replace(layout, **{part.name: "other"}).to_text()
            continue
        for fact in fields(value):
            changed: Any = replace(value, **{fact.name: ("other",)})  # type: ignore[type-var]
            texts[f"{part.name}.{fact.name}"] = replace(layout, **{part.name: changed}).to_text()
    assert texts.pop("hardware.pins") == layout.to_text()
    assert len({layout.to_text(), *texts.values()}) == 1 + len(texts) > 45


@pytest.mark.parametrize("path", sorted(Path("layouts/rejected").glob("*.yaml")), ids=lambda p: p.stem)
def test_rejected_layouts_are_rejected_for_the_reason_that_they_state(path: Path) -> None:
    wanted = path.read_text("utf-8").splitlines()[0].split("[")[1].rstrip("]")
    done = check_file(str(path))
    assert {d.code for d in done.diagnostics if d.severity is Severity.ERROR} == {wanted}


MISTAKEN = sorted(p.stem for p in MISTAKES.glob("*.yaml"))
KINDS = ("list_for", "comma_in", "capital", "no_space", "quote", "gbk|utf16|latin1|full_width", "twice", "tab", "unit")


def test_newcomers_mistakes_are_planted_of_each_kind() -> None:
    assert len(MISTAKEN) >= 80
    for kind in (*KINDS, "misspelt"):
        assert sum(re.match(kind, m) is not None for m in MISTAKEN) >= 5, kind


@pytest.mark.parametrize("name", MISTAKEN)
def test_a_mistake_has_a_screen_with_place_line_caret_and_fix(name: str) -> None:
    shown = screen(MISTAKES / f"{name}.yaml")
    assert shown == MISTAKES.joinpath(f"{name}.txt").read_text("utf-8")
    problems = shown.split("\n\n")
    for problem in problems:
        assert re.match(
            rf"{name}\.yaml:\d+:\d+: (error|warning)\[IL\d{{4}}\]: .+\n +\|\n +\d+ \| .+\n +\| +\^+\n", problem
        )
        assert re.search(r"^  fix: \S.+$", problem, re.MULTILINE)
    assert len(problems) == 1, "one mistake is said once"


@pytest.mark.parametrize("part", sorted({x.partition(".")[0] for x in EXAMPLES}))
def test_the_example_of_an_entry_that_messages_show_can_be_written(part: str) -> None:
    entry = EXAMPLES[part] if part in WHOLE else f"[{EXAMPLES[part]}]"
    entry = entry if part in WHOLE | LISTS else f"{{A: {EXAMPLES[part]}}}"
    sink = Sink()
    load_text("example.yaml", f"interlock: 1\nname: x\ntracks: {{}}\n{part}: {entry}\n", sink)
    assert not [d for d in sink.diagnostics if d.code.startswith("IL1")], "the shape is right"
    assert EXAMPLES[part] in Path("interlock/docs/codes/IL1012.md").read_text("utf-8")


def test_the_layout_that_an_empty_file_is_shown_is_silent(tmp_path: Path) -> None:
    page = explain("IL1007")
    assert page is not None and "interlock init -o" in page, "no folder of layouts is where a wheel is installed"
    path = tmp_path / "smallest.yaml"
    path.write_text(page.split("```yaml\n")[1].split("```")[0], "utf-8")
    assert check_file(str(path)).diagnostics == ()


@pytest.mark.parametrize("part", sorted(x for x in EXAMPLES if "." not in x))
def test_an_unknown_key_anywhere_is_told_those_that_there_are(part: str) -> None:
    entry = EXAMPLES[part].replace("}", ", qqqqq: 1}", 1) if "}}" not in EXAMPLES[part] else "{qqqqq: 1}"
    entry = entry if part in WHOLE else f"[{entry}]" if part in LISTS else f"{{A: {entry}}}"
    sink = Sink()
    load_text("unknown.yaml", f"interlock: 1\nname: x\ntracks: {{}}\n{part}: {entry}\n", sink)
    (fix,) = (str(d.fix) for d in sink.diagnostics if d.code == "IL1011")
    assert fix.startswith("the keys of ") and len(fix.partition(": ")[2].split(", ")) >= 1 and not fix.endswith(": ")


def test_every_part_of_the_language_with_entries_has_an_example() -> None:
    keyed = {n for n, f in LayoutFile.model_fields.items() if "Spec" in str(f.annotation)}
    assert keyed == {x for x in EXAMPLES if "." not in x}


def test_the_same_information_as_json(tmp_path: Path) -> None:
    from click.testing import CliRunner

    from interlock.cli.check import command

    for name in MISTAKEN:
        path = MISTAKES / f"{name}.yaml"
        (found,) = json.loads(CliRunner().invoke(command, [str(path), "--format", "json"]).stdout)
        (one,) = (d for d in found["diagnostics"] if d["severity"] != "info")
        shown = path.with_suffix(".txt").read_text("utf-8")
        assert f":{one['line']}:{one['column']}: {one['severity']}[{one['code']}]: {one['message']}\n" in shown
        assert one["source"] and one["fix"] and one["width"] >= 1
        assert ("  also: " in shown) == bool(one["also"])


def test_a_long_line_is_cut_and_sentences_are_wrapped_to_the_terminal(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(FOLDER)  # a place, `file:line:column`, is never wrapped, so that it can be clicked
    checked = check_file("IL4002.yaml")
    shown = render.full(checked.diagnostics, {checked.source.file: checked.source.text}, 60)
    assert max(map(len, shown.splitlines())) <= 60
    wide = render.full(checked.diagnostics, {checked.source.file: checked.source.text})
    assert max(map(len, wide.splitlines())) > 100 and "\x1b" not in shown + wide


def broken(kind: str, n: int) -> str:
    """A large file with one mistake, or as many mistakes as elements."""
    head = "interlock: 1\nname: big\nboundaries:\n  W: {}\n  E: {}\n"
    tracks = "".join(f"  t{i}: [q{i} 100]\n" for i in range(n))
    signal = {"keys": "FORM: q{0}, into: q{1}", "names": "from: qq{0}x, into: r{1}", "comma": "from: q{0}, into: q{1}"}
    signals = "".join(f"  s{i}: {{{signal[kind].format(i, i + 1)}}}\n" for i in range(n))
    return (
        head + "tracks:\n" + (tracks.replace("100]", "100,5]") if kind == "comma" else tracks) + "signals:\n" + signals
    )


@pytest.mark.parametrize(("kind", "messages"), [("names", 20), ("comma", 2)])
def test_a_broken_file_of_3_mb_gives_twenty_messages_and_a_count(kind: str, messages: int, tmp_path: Path) -> None:
    path = tmp_path / "big.yaml"
    path.write_text(broken(kind, 60_000))
    assert 3e6 < path.stat().st_size < 4e6
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    args = [sys.executable, "-m", "interlock", "check", str(path)]
    shown = subprocess.run(args, capture_output=True, text=True, check=False).stdout
    assert resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before < 30
    assert shown.count("error[") == messages and len(shown.splitlines()) < 140
    assert "239982 errors more, not shown" in shown if messages == 20 else "and at 59980 other places" in shown


def told_of(text: str) -> list[str]:
    """Each error and warning of a layout as a line: code, message and fix."""
    sink = Sink()
    layout, _ = load_text("x.yaml", text, sink)
    if layout is not None:
        derive(layout, sink)
    return [f"{d.code} {d.message} | {d.fix}" for d in sink.diagnostics if d.severity != "info"]


LOOP = Path("layouts/passing_loop.yaml").read_text("utf-8")
FITTING = (
    (LOOP.replace("X1: {from: IG, into: 2DG}", "X1:"), "write it like `X1: {from: q1, into: q2}`"),
    (LOOP.replace("main: [IG 850]", "main:"), "write `main: [q1 400]`"),
    (LOOP + "overlaps:\n  X1:\n", "write it like `X1: {length: 180}`"),
    (LOOP + "sections:\n  IG:\n", "write `IG: {}`, or with what there is to say, for instance `IG: {speed: 60}`"),
    (
        LOOP + "exclude: [{from: X, to: X1, via: [3G], reason: x}]\n",
        "remove it, or correct `via`: the routes between these ends lead over IAG, 1DG, IG",
    ),
    (LOOP + "exclude: [{from: X, to: S3, via: [3G], reason: x}]\n", "from X routes lead to X1, X3"),
    (
        LOOP + "routes: {R: {from: X, to: X1, via: [3G]}}\n",
        "there is no route from X to X1 (named R) over 3G | correct `via`: the routes between these ends lead over IAG",
    ),
    (
        LOOP + "demand: [{point: 1, lies: normal, routes: {from: X, to: X1, via: [3G]}, reason: x}]\n",
        "correct it: the routes between these ends lead over IAG, 1DG, IG",
    ),
    (
        LOOP + "overlaps: {X1: {speed: 999999}}\n",
        "overlaps.X1.speed: 999999 is no speed (above 0, to 400 km/h) | write km/h",
    ),
    (
        LOOP + "overlaps: {X1: {speed: 200, falling: 100}}\n",
        "from `speed: 200` and `falling: 100` 2200 m follow, and an overlap has at most 2000 m | correct the two",
    ),
    (
        LOOP + "overlaps: {X1: {length: 50, ways: [{over: [2DG], entry_speed: 80, falling: 100}]}}\n",
        "overlaps.X1.ways: from `entry_speed: 80` and `falling: 100` 2200 m follow",
    ),
    (
        LOOP + "overlaps: {X1: {length: 0, swing: yes}}\n",
        "IL1014 overlaps.X1: there is no overlap of 0 m that could have `swing` | state its length, or remove `swing`",
    ),
    (LOOP + "zones: {Z: {sections: [IG, IG], trains: 2}}\n", "IL1022 zones.Z.sections: IG is named twice"),
    (
        LOOP
        + "exclude: [{from: X, to: X1, via: [IG, IAG], reason: a}, {from: X, to: X1, via: [IAG, IG], reason: b}]\n",
        "IL1022 `exclude`: this entry says what the one in line 29 says",
    ),
    (
        LOOP + "automatic: [{from: X, to: X3}, {from: X, to: X1}, {from: X, to: X1, via: [IG]}]\n",
        "IL1022 `automatic`: this entry means X-X1, as entry 2 does",
    ),
    (LOOP + "target: {}\n", "IL1023 `target` says nothing | write what there is to say"),
    (
        LOOP + "principles: {release_delay_s: -1}\n",
        "-1 is out of range (above 0, to 86400) | write a number above 0",
    ),
    (
        LOOP + "principles: {release_delay_s: 0}\n",
        "0 is out of range (above 0, to 86400) | write a number above 0",
    ),
    (LOOP + "principles: {point_start_gap_s: -1}\n", "-1 is out of range (0 to 86400) | write a number, 0 or more"),
    (LOOP + "principles: {release_delay_s: 99999}\n", "at most 86400; a time is in seconds, and a day has so many"),
    (
        LOOP + "principles: {point_supervision_s: 0.1}\n",
        "`point_supervision_s: 6` under `principles`, or a shorter `point_run_s` if the machines run so fast",
    ),
)


@pytest.mark.parametrize(("text", "said"), FITTING, ids=[said[:40] for _, said in FITTING])
def test_the_fix_is_of_what_is_wrong(text: str, said: str) -> None:
    told = told_of(text)
    assert any(said in x for x in told), told


@pytest.mark.parametrize("room", sorted(BARE))
def test_entries_that_may_say_nothing_may(room: str) -> None:
    entry = {"boundaries": "Z", "sections": "IG", "health": "main"}[room]
    more = f"  {entry}: {{}}\n"
    text = LOOP.replace("boundaries:\n", f"boundaries:\n{more}") if room == "boundaries" else f"{LOOP}{room}:\n{more}"
    assert not any(x.startswith(("IL1010", "IL1012")) for x in told_of(text))


def test_a_signal_beside_a_section_in_two_pieces_does_not_hide_that() -> None:
    """Both tracks of a loop called by one section: the signals at it stand at two joints, since it is split."""
    text = Path("layouts/passing_loop.yaml").read_text("utf-8").replace("3G", "IG")
    text = re.sub(r"^  [SX]3:.*\n", "", text, flags=re.MULTILINE)
    sink = Sink()
    layout, _ = load_text("loop.yaml", text, sink)
    assert layout is None
    assert [(d.code, d.message) for d in sink.diagnostics] == [
        ("IL3009", "section IG is split into 2 pieces that do not touch")
    ]
