"""Folders and layouts made to deceive, or to hang, whoever checks them: refused in words, in a moment."""

from __future__ import annotations

import hashlib
import json
import lzma
import os
import shutil
import unicodedata
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from interlock.checker.check import check, report
from interlock.checker.language import FORMS
from interlock.checker.railway import Railway
from interlock.checker.reading import loaded
from interlock.checker.specification import shipped as specified
from interlock.diag import Sink
from interlock.frontend import load, load_text
from interlock.frontend.encoding import decode
from interlock.frontend.published import json_schema
from interlock.verify import LARGEST, Rejected, judge
from tests.certified import certified, signed

FIG, MINE = Path("layouts/fig2_2.yaml"), Path("layouts/mine11.yaml").read_text("utf-8")


@pytest.fixture(scope="module")
def whole(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A small layout with its certificate."""
    top = tmp_path_factory.mktemp("whole")
    shutil.copy(FIG, top)
    certified(top / FIG.name, top)
    return top


@pytest.fixture
def made(whole: Path, tmp_path: Path) -> Path:
    """A copy of the certificate, to be spoiled."""
    shutil.copytree(whole, tmp_path / "copy")
    return tmp_path / "copy/proofs/fig2_2"


def layout_of(folder: Path) -> Path:
    return folder.parent.parent / "fig2_2.yaml"


def manifest(folder: Path, change: Callable[[dict[str, Any]], object]) -> None:
    """Change the manifest, and sign it as it should be."""
    file = folder / "manifest.json"
    body = json.loads(file.read_text("utf-8"))
    change(body)
    file.write_text(json.dumps(body), "utf-8")
    signed(folder)


def _pipe(folder: Path) -> None:
    (folder / "needed.txt").unlink()
    os.mkfifo(folder / "needed.txt")


def _bomb(folder: Path) -> None:
    (folder / "proof.txt.xz").write_bytes(lzma.compress(b"interlock-proof 3\n" + bytes(70_000_000), preset=0))
    signed(folder)


def _values(folder: Path) -> None:
    text = (folder / "system.txt").read_text("utf-8")
    (folder / "system.txt").write_text(text + "val OTHER 500000\n", "utf-8")
    signed(folder)


def _twins(folder: Path) -> None:
    (folder / "NEEDED.txt").write_text("another", "utf-8")
    manifest(folder, lambda m: m["files"].update({"NEEDED.txt": ""}))


def _absolute(name: str) -> Callable[[Path], object]:
    return lambda folder: manifest_as_it_is(folder, name)


def manifest_as_it_is(folder: Path, name: str) -> None:
    """Name a file, which need not be there, and sign the manifest."""
    file = folder / "manifest.json"
    body = json.loads(file.read_text("utf-8"))
    body.pop("own")
    body["files"][name] = ""
    own = hashlib.sha256(json.dumps(body, sort_keys=True).encode()).hexdigest()
    file.write_text(json.dumps({**body, "own": own}, indent=1, ensure_ascii=False) + "\n", "utf-8")


def _endless(folder: Path) -> None:
    with (folder / "needed.txt").open("wb") as file:
        file.truncate(LARGEST + 1)


BUNDLES: dict[str, tuple[Callable[[Path], object], str]] = {
    "a manifest that is a text": (lambda f: (f / "manifest.json").write_text('"abc"'), "of another kind"),
    "one that is a list": (lambda f: (f / "manifest.json").write_text("[1]"), "of another kind"),
    "one with a key more": (lambda f: manifest(f, lambda m: m.update(more=float("nan"))), "of another kind"),
    "a pipe among the files": (_pipe, "needed.txt is not the file proved"),
    "a proof that grows when it is unpacked": (_bomb, "larger than its system can need"),
    "an input of half a million values": (_values, "more values than anything"),
    "a file that lies somewhere on the reader's computer": (_absolute("/etc/hostname"), "in no place of its own"),
    "the same on Windows": (_absolute("C:x.txt"), "in no place of its own"),
    "a file that never ends": (_endless, "has more bytes than any file of a certificate"),
    "names that differ in capitals alone": (_twins, "one name on some computers"),
}


@pytest.mark.parametrize("what", BUNDLES)
def test_a_hostile_bundle_is_refused_in_words(made: Path, what: str, capsys: pytest.CaptureFixture[str]) -> None:
    spoil, why = BUNDLES[what]
    spoil(made)
    accepted, said = judge(str(made))
    assert not accepted and why in said
    assert report(layout_of(made), made) == 1
    assert why in capsys.readouterr().out


def test_a_controller_that_offers_what_the_author_excludes_is_refused(made: Path) -> None:
    """A good controller of the layout without its `exclude`, with its own text and proof, signed for the layout."""
    layout = layout_of(made)
    wanted = "exclude: [{from: X1, to: A, reason: the road is closed}]\n"
    layout.write_text(layout.read_text("utf-8") + wanted, "utf-8")
    signed(made)
    with pytest.raises(Rejected, match="the claim S-EXCLUDED lacks what the specification asks"):
        check(layout, made)


def test_a_folder_that_is_a_link_is_told(made: Path, tmp_path: Path) -> None:
    """A tool that takes in all sources of a folder follows it."""
    (tmp_path / "elsewhere").mkdir()
    (made.parents[1] / "generated/fig2_2/st/more").symlink_to(tmp_path / "elsewhere")
    assert check(layout_of(made), made).compared[-1].endswith("; certified by nobody: st/more")


def test_no_file_is_read_twice(made: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """What is checked is what was compared with its digest, though the file be another one by then."""
    specified()
    read: list[Path] = []
    for way in ("read_bytes", "read_text"):
        plain = getattr(Path, way)

        def told_of(self: Path, *a: str, plain: Callable[..., Any] = plain) -> Any:
            read.append(self.resolve())
            return plain(self, *a)

        monkeypatch.setattr(Path, way, told_of)
    assert not check(layout_of(made), made).left
    ours = [p for p in read if made.parents[1] in p.parents and p != layout_of(made)]
    assert len(ours) == len(set(ours)) > 5


@pytest.mark.parametrize("text", ["title: &a x", "title: !!str x", "title: x\nname: *a", "%TAG ! x\n--- \ntitle: !a x"])
def test_a_text_that_says_other_than_it_shows_is_read_by_nobody(made: Path, text: str) -> None:
    layout_of(made).write_text(text + "\n" + FIG.read_text("utf-8"), "utf-8")
    with pytest.raises(Rejected, match="no YAML"):
        check(layout_of(made), made)


SHOWN_OTHERWISE = {
    "an override in a comment": "# \u202e the road is closed\n",
    "an isolate in a comment": "# \u2066 the road is closed\n",
    "one in a text": 'title: "closed \u202e road"\n',
    "a line that ends for no editor": "# the road is closed\u2028",
    "a carriage return alone": "# the road is closed\rtitle: x\n",
}


@pytest.mark.parametrize("what", SHOWN_OTHERWISE)
def test_a_layout_that_reads_otherwise_than_it_is_shown_is_read_by_nobody(made: Path, what: str) -> None:
    """What an editor shows as a comment would be a line of the layout, or a line would be shown as another one."""
    text = SHOWN_OTHERWISE[what] + FIG.read_text("utf-8").replace("title:", "#title:")
    layout_of(made).write_bytes(text.encode())
    with pytest.raises(Rejected, match="no YAML"):
        check(layout_of(made), made)
    sink = Sink()
    assert load(str(layout_of(made)), sink)[0] is None
    (found,) = sink.diagnostics
    assert found.code == "IL1004" and found.span is not None and found.span.line == 1 and found.fix


@pytest.mark.parametrize("sign", ["\u202a", "\u202e", "\u2069"])
def test_what_turns_the_direction_of_a_text_is_refused_as_an_escape_too(sign: str) -> None:
    text = FIG.read_text("utf-8").replace("title: ", f'title: "a\\u{ord(sign):04x}b" # ')
    sink = Sink()
    assert load_text("a.yaml", text, sink)[0] is None
    (found,) = sink.diagnostics
    assert found.code == "IL1012" and f"U+{ord(sign):04X}" in found.message and found.span is not None
    with pytest.raises(Rejected, match="direction"):
        Railway(loaded(text))


def test_ends_of_lines_of_any_system_are_read() -> None:
    for end in ("\n", "\r\n", "\r"):
        text, sink = FIG.read_text("utf-8").replace("\n", end), Sink()
        decoded, _ = decode("a.yaml", text.encode(), sink)
        assert decoded is not None and load_text("a.yaml", decoded, sink)[0] is not None
        assert Railway(loaded(text)).body["name"] == "fig2_2"


EDITS = {
    "q1 400": ["q1 nan", "q1 1e400", "q1 -5", "q1 0", "q1 4_00", "q1 ٤٠٠", "q1 400 m"],
    "legs: 30": ["leg: 30", "legs: .inf", "legs: 0", "legs: long"],
    "{from: W,   into: q1}": ["{from: W, into: q1, callon: yes}", "{from: W, into: q1, call_on: maybe}"],
    "q1: {lane: inclined}": ["q1: {lane: steep}", "q99: {lane: inclined}", "<<: {lane: level}"],
    "  j1: {from: X1, to: X5}": ["  j1: {from: X1, to: X55}", "  j1: {form: X1, to: X5}"],
    "profile: mine": [
        "profile: mine\nconditions: {H: {text: t, over: [q99]}}",
        "profile: mine\nconditions: {H: {text: t, signal: [X1]}}",
        "profile: mine\nzones: {Z: {sections: [q1, q22], trains: 2}}",
        "profile: mine\nprinciples: {release_delay_s: nan}",
        "profile: mine\nprinciples: {lamp_proof: 0}",
    ],
    "interlock: 1": ["interlock: 2"],
}


@pytest.mark.parametrize(("before", "after"), [(b, a) for b, those in EDITS.items() for a in those])
def test_a_layout_in_which_something_says_nothing_is_refused(before: str, after: str) -> None:
    Railway(loaded(MINE))
    assert before in MINE
    with pytest.raises(Rejected):
        Railway(loaded(MINE.replace(before, after, 1)))


@pytest.mark.parametrize("name", [unicodedata.normalize("NFD", "É1"), "q1\u200b", "P2", "X5", "q9"])
def test_a_name_that_is_none_or_that_a_compiler_takes_for_another_is_refused(name: str) -> None:
    body = loaded(MINE)
    other = {"P2": "p1", "X5": "x6", "q9": "Q7"}.get(name, name)
    old = name if name in ("P2", "X5", "q9") else "q4"
    edited = json.loads(json.dumps(body).replace(f'"{old}', f'"{other}'))
    with pytest.raises(Rejected, match="name"):
        Railway(edited)


def test_what_the_checker_admits_is_what_the_language_has() -> None:
    schema, forms = json_schema(), loaded(FORMS.read_text("utf-8"))
    named = {"BoundarySpec": "boundary_form", "SignalSpec": "signal_form", "SectionSpec": "section_form"}
    named |= {"OverlapWaySpec": "overlap_way", "TitleBlockSpec": "title_block"}
    parts = {"layout": schema} | {
        named.get(n, n.removesuffix("Spec").lower()): d for n, d in schema["definitions"].items() if "properties" in d
    }
    assert set(parts) == set(forms)
    for name, part in parts.items():
        assert set(part["properties"]) == set(forms[name]), name
        must = {k for k, kind in forms[name].items() if kind.startswith("! ")}
        assert must == set(part.get("required", ())), name
        for key, value in part["properties"].items():
            _same(forms[name][key].removeprefix("! "), value, schema, f"{key} of {name}")


def _same(kind: str, value: dict[str, Any], schema: dict[str, Any], where: str) -> None:
    """Words, bounds and flags agree."""
    value = {**value, **schema["definitions"].get(value.get("allOf", [{}])[0].get("$ref", "").split("/")[-1], {})}
    word, *rest = kind.split()
    enum = value.get("enum") or ([str(value["const"])] if "const" in value else None)
    if enum is not None and where != "lint of allow":
        words = {str(x).lower() for x in enum}
        assert words == (set(rest) if word == "one" else {"yes", "no", "true", "false"}), where
    if value.get("type") in ("number", "integer"):
        assert word == ("number" if value["type"] == "number" else "whole"), where
        low, high = rest
        if "maximum" in value:
            assert float(high) == value["maximum"], where
        if "exclusiveMinimum" in value:
            assert low == f">{value['exclusiveMinimum']:g}", where
        if "minimum" in value:
            assert float(low) == value["minimum"], where
