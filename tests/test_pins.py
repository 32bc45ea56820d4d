"""Addresses that stay: no channel of what is kept moves, nothing is put where something is reserved."""

from __future__ import annotations

import csv
import io
import json
import random
import re
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import jsonschema
import pytest
import yaml
from click.testing import CliRunner

from interlock.app.check import check_file
from interlock.app.init import line
from interlock.app.pin import repinned
from interlock.app.writing import _mapping
from interlock.cli.main import cli
from interlock.diag import Sink, render
from interlock.emit.io import channels_csv
from interlock.emit.io.pins import pins_text
from interlock.frontend import load, load_text
from interlock.frontend.pins import PinFile, read_pins
from interlock.frontend.published import json_schema
from interlock.logic.cabinet import allocate
from interlock.logic.controller import Controller
from interlock.model.layout import Layout
from interlock.model.pins import Pin, Pins
from tests.layouts import built, grown
from tests.test_schema import Core, text_keys

MINE = Path("layouts/mine11.yaml").read_text("utf-8")


def made(text: str) -> tuple[Layout, Controller] | None:
    """Layout and controller of a text; None where that is no layout."""
    from interlock.logic.lower import lower

    found = grown(text)
    if found is None or found[2].has_errors:
        return None
    return found[0], lower(found[0], found[1])


class Edited:
    """A line with two cabinets that somebody edits at random."""

    def __init__(self, rng: random.Random) -> None:
        self.rng, self.stations, self.count = rng, 1, 0
        self.data: dict[str, Any] = yaml.load(line(1), yaml.BaseLoader)
        self.data["substations"] = {"west": ["a0", "p1", "P1", "A1"], "east": []}

    def text(self) -> str:
        """JSON is YAML."""
        return json.dumps(self.data, indent=0)

    def add(self) -> None:
        """A shunt signal where trains stand, or another station."""
        if self.rng.random() < 0.2 and self.stations < 2:
            self.stations += 1
            more = yaml.load(line(self.stations), yaml.BaseLoader)
            for room in ("tracks", "points", "signals"):
                self.data[room] = {**more[room], **self.data[room]}
            self.data["tracks"] |= {n: t for n, t in more["tracks"].items() if n.startswith("line")}
            self.data["signals"]["S"] = more["signals"]["S"]
        else:
            self.count += 1
            k = self.rng.randint(1, self.stations)
            joint = self.rng.choice([(f"p{k}", f"m{k}"), (f"q{k}", f"l{k}"), (f"a{k}", f"q{k}")])
            self.data["signals"][f"Z{self.count}"] = {"from": joint[0], "into": joint[1], "kind": "shunt"}

    def remove(self) -> None:
        """A signal."""
        name = self.rng.choice(list(self.data["signals"]))
        del self.data["signals"][name]
        self.forget(name)

    def forget(self, name: str) -> None:
        for elements in self.data["substations"].values():
            if name in elements:
                elements.remove(name)

    def rename(self) -> None:
        """A section, a signal or points, wherever they are named."""
        name = self.rng.choice([*self.data["signals"], *self.data["points"], "m1", "l1", "a0"])
        self.count += 1
        text = re.sub(rf"(?<![\w]){name}(?![\w])", f"{name[0]}x{self.count}", self.text())
        self.data = json.loads(text)

    def reorder(self) -> None:
        """Elements and cabinets in another order."""
        for room in ("signals", "points", "tracks", "substations"):
            names = list(self.data[room])
            self.rng.shuffle(names)
            self.data[room] = {n: self.data[room][n] for n in names}

    def alter(self) -> None:
        """Another kind of signal, or lamps that are reported: elements get other channels."""
        if self.rng.random() < 0.5:
            self.data["principles"] = {"lamp_proof": self.rng.choice(["yes", "no"])}
        else:
            name = self.rng.choice(list(self.data["signals"]))
            self.data["signals"][name]["kind"] = self.rng.choice(["main", "combined"])


def at(pins: tuple[Pin, ...]) -> dict[str, tuple[str, str]]:
    return {p.variable: (p.substation, p.address) for p in pins}


def test_in_100_random_edits_no_channel_of_what_is_kept_moves() -> None:
    rng = random.Random(29)
    edited = Edited(rng)
    first = made(edited.text())
    assert first is not None
    pins, done, kept, back, gone = repinned(*first), 0, 0, 0, 0
    edits: tuple[Callable[[], None], ...] = (edited.add, edited.remove, edited.rename, edited.reorder, edited.alter)
    while done < 100:
        before = edited.text()
        rng.choices(edits, (4, 2, 2, 1, 2))[0]()
        found = made(edited.text())
        if found is None:  # no layout any more: whoever edits it takes that back
            edited.data = json.loads(before)
            continue
        done += 1
        layout, controller = replace(found[0], hardware=replace(found[0].hardware, pins=pins)), found[1]
        allocation = allocate(layout, controller)
        new = allocation.pins
        was, now, reserved = at(pins.channels), at(new.channels), at(new.reserved)
        assert {n: a for n, a in now.items() if n in was} == {n: a for n, a in was.items() if n in now}
        assert {n: a for n, a in was.items() if n not in now}.items() <= reserved.items()
        assert at(pins.reserved).items() <= {**now, **reserved}.items()  # kept, or it has come back to its place
        places = [p.place for p in (*new.channels, *new.reserved)]
        assert len(places) == len(set(places))
        assert set(pins.cards) <= set(new.cards)
        kept += len(was.keys() & now.keys())
        back += len(at(pins.reserved).keys() & now.keys())
        gone += len(was.keys() - now.keys())
        for s in {c.substation for c in new.cards}:
            for d in "IQ":
                on = sum(p.substation == s and p.direction == d for p in (*new.channels, *new.reserved))
                assert on <= 16 * sum(c.substation == s and c.direction == d for c in new.cards)
        if done % 20 == 0:
            verdict, files = _mapping(layout, controller, [])
            assert verdict.equal and f"pins {pins.digest}" in next(iter(files.values())).decode()
            read = read_pins("x.pins", pins_text(layout, new), layout.name, Sink())
            assert read is not None and at(read.pins.channels) == now and at(read.pins.reserved) == reserved
            assert sorted(map(repr, read.pins.cards)) == sorted(map(repr, new.cards))
        pins = new
    assert kept > 3000 and back > 10 and gone > 50, (kept, back, gone)


def test_without_pins_one_more_signal_moves_half_of_the_channels() -> None:
    text = line(2).replace("A1: {from: a0, into: p1}", "A1: {from: a0, into: p1, kind: combined}")
    one, more = made(text), made(text + "  A0: {from: p1, into: m1, kind: shunt}\n")
    assert one is not None and more is not None
    layout, controller = one
    before = at(allocate(layout, controller).pins.channels)
    after = at(allocate(*more).pins.channels)
    assert sum(after[n] != a for n, a in before.items()) > len(before) / 3
    pinned = at(
        allocate(
            replace(more[0], hardware=replace(more[0].hardware, pins=repinned(layout, controller))), more[1]
        ).pins.channels
    )
    assert before.items() <= pinned.items() and len(pinned) > len(before)


@pytest.fixture(scope="module")
def pinned(tmp_path_factory: pytest.TempPathFactory) -> str:
    """The pins of mine11."""
    path = tmp_path_factory.mktemp("pins") / "mine.yaml"
    path.write_text(MINE, "utf-8")
    assert run("pin", path).endswith("mine.pins: 37 channels\n")
    return path.with_suffix(".pins").read_text("utf-8")


@pytest.fixture
def mine(tmp_path: Path, pinned: str) -> Path:
    """mine11 with its pins."""
    path = tmp_path / "mine.yaml"
    path.write_text(MINE, "utf-8")
    path.with_suffix(".pins").write_text(pinned, "utf-8")
    return path


def run(verb: str, path: Path, *args: str, code: int = 0) -> str:
    done = CliRunner().invoke(cli, [verb, str(path), *args])
    assert done.exit_code == code, done.output
    return done.output


def test_what_is_gone_stays_reserved_until_it_is_released(mine: Path) -> None:
    assert "nothing has changed" in run("pin", mine)
    mine.write_text(MINE + "principles: {lamp_proof: yes}\n", "utf-8")
    assert "IL2023" in run("check", mine) and "new      RL_X1: main I2.2" in run("pin", mine)
    assert "IL2023" not in run("check", mine)
    mine.write_text(MINE, "utf-8")
    assert "reserved RL_X1: main I2.2" in run("pin", mine)
    layout, _ = load(str(mine), Sink())
    assert layout is not None
    _, _, controller = built("mine11")
    rows = csv.DictReader(io.StringIO(channels_csv(layout, controller, allocate(layout, controller))))
    assert {r["Address"]: r["When 1"] for r in rows}["I2.2"] == "reserved for RL_X1 of X1"
    assert "did you mean RL_X1?" in run("pin", mine, "--release", "RL_Y1", code=1)
    for kept in ("q1", "CLR_q1"):
        answer = run("pin", mine, "--release", kept, code=1)
        assert f"no channel is reserved for {kept}: the layout has it, and it keeps its channels" in answer
    assert "that is a route, and no wire leads to routes" in run("pin", mine, "--release", "X1-X3", code=1)
    assert "reserved are those of X" in run("pin", mine, "--release", "nothing", code=1)
    assert "2 released" in run("pin", mine, "--release", "X1")
    mine.write_text(MINE + "conditions: {ROPE: {text: rope, over: [q1]}}\n", "utf-8")
    assert "new      E_ROPE: main I2.2" in run("pin", mine)
    mine.write_text(MINE + "principles: {lamp_proof: yes}\n", "utf-8")
    shown = run("pin", mine)
    assert (
        "back     RL_X2: main I2.3" in shown and "new      RL_X1: main" in shown and "I2.2" not in shown.split("res")[0]
    )


def test_what_would_move_is_shown_and_not_done_unless_it_is_allowed(mine: Path) -> None:
    pins = mine.with_suffix(".pins")
    before = pins.read_bytes()
    mine.write_text(MINE + "substations: {main: [], far: [q1]}\naddresses: {CLR_q3: I0.4}\n", "utf-8")
    text = run("check", mine, code=1)
    line_of = {
        n: next(k for k, x in enumerate(before.decode().split("\n"), 1) if n in x) for n in ("CLR_q1:", "CLR_q3:")
    }
    assert f"CLR_q1 is pinned to I0.3 of main ({pins}, line {line_of['CLR_q1:']})" in text
    assert f"CLR_q3 is to lie at I0.4, but it is pinned to I0.7 ({pins}, line {line_of['CLR_q3:']})" in text
    assert run("compile", mine, "-o", str(mine.parent / "g"), code=1) and not (mine.parent / "g").exists()
    shown = run("pin", mine, code=1)
    assert (
        "moved    CLR_q1: main I0.3 -> far I4.1" in shown and "without --yes" in shown and pins.read_bytes() == before
    )
    # q3 goes where q10 is: that it loses its channel is shown too
    assert "moved    CLR_q3: I0.7 -> main I0.4" in shown and "moved    CLR_q10: I0.4 -> main I0.3" in shown
    run("pin", mine, "--yes")
    assert check_file(str(mine)).ok and "nothing has changed" in run("pin", mine)


def test_an_empty_file_of_pins_is_no_layout(mine: Path) -> None:
    """Nor is it to be made anew where a cabinet is wired: the channels stand in it."""
    mine.with_suffix(".pins").write_text("")
    done = CliRunner().invoke(cli, ["check", str(mine)])
    assert done.exit_code == 1 and "take it from where it is kept" in done.output


def test_a_reserved_channel_is_not_given_away_unasked(mine: Path) -> None:
    pins = mine.with_suffix(".pins")
    pins.write_text(pins.read_text("utf-8") + "reserved:\n  main:\n    q99: {CLR_q99: I3.0}\n", "utf-8")
    mine.write_text(
        MINE
        + "addresses: {CLR_q3: I3.0}\n".replace("CLR_q3", "E_ROPE")
        + "conditions: {ROPE: {text: rope, over: [q1]}}\n",
        "utf-8",
    )
    assert "I3.0, but that is pinned to CLR_q99, which is gone" in run("check", mine, code=1)
    assert "released CLR_q99" in run("pin", mine, code=1)


def test_pins_that_somebody_has_changed_are_read_and_not_overwritten(mine: Path) -> None:
    pins = mine.with_suffix(".pins")
    edited = pins.read_text("utf-8").replace("CLR_q1: I0.3", "CLR_q1: I3.3")
    pins.write_text(edited, "utf-8")
    layout, _ = load(str(mine), Sink())
    assert layout is not None and layout.hardware.pins.by_variable["CLR_q1"].address == "I3.3"
    mine.write_text(MINE + "conditions: {ROPE: {text: rope, over: [q1]}}\n", "utf-8")
    assert "not as interlock wrote it" in run("pin", mine, code=1) and pins.read_text("utf-8") == edited
    assert "new      E_ROPE: main I0.3" in run("pin", mine, "--force")


def test_the_digest_and_the_proof_know_nothing_of_pins(mine: Path) -> None:
    pinned, _ = load(str(mine), Sink())
    bare, _ = load_text("mine.yaml", MINE, Sink())
    assert pinned is not None and bare is not None and pinned.hardware.pins and not bare.hardware.pins
    assert pinned.digest == bare.digest and pinned.to_text() == bare.to_text()
    assert pinned.hardware.pins.digest != Pins().digest


BAD = (
    ("layout: mine11", "layout: mine12", "IL2020", "of the layout mine12, not of mine11"),
    ("pins: 1\n", "", "IL2020", "the key `pins` is missing"),
    ("pins: 1", "pins: 2", "IL1015", "version 2 is not supported"),
    ("pins: 1", "pins: [1", "IL1004", ""),
    ("CLR_q1: I0.3", "CLR_q1: I0.8", "IL2021", "'I0.8' is no address"),
    ("CLR_q1: I0.3", "CLR_q1: I10000.3", "IL2021", "'I10000.3' is no address"),
    ("CLR_q1: I0.3", "CLR_q1: I0.4", "IL2021", "I0.4 is given to CLR_q10 and to CLR_q1"),
    ("q1: {CLR_q1: I0.3", "q1: {CLR_q10: I0.3", "IL2021", "CLR_q10 is pinned twice"),
    ("CLR_q1: I0.3", "CLR_q1: Q0.3", "IL2021", "Q0.3 is given to CLR_q1 and to YR_P2"),
    ("CLR_q1: I0.3", "CLR_q1: Q7.3", "IL2022", "CLR_q1 is an input, but it is pinned to Q7.3"),
    ("2: I2", "2: I1", "IL2021", "would lie over the one in slot 1"),
    ("2: I2", "0: I2", "IL2021", "'0' is no slot"),
    ("2: I2", "2: A2", "IL2021", "'A2' is no card"),
    ("cards:", "card:", "IL1011", "unknown key `card`"),
    ("  main: {1", "  other: {1", "IL2021", "hangs on substation main, but I1.6 is on a card of other"),
)


@pytest.mark.parametrize(("old", "new", "code", "text"), BAD, ids=[f"{c}-{n}" for n, (_, _, c, _) in enumerate(BAD)])
def test_pins_that_cannot_be_are_told_with_place_and_fix(mine: Path, old: str, new: str, code: str, text: str) -> None:
    pins = mine.with_suffix(".pins")
    told = pins.read_text("utf-8")
    assert old in told
    pins.write_text(told.replace(old, new, 1), "utf-8")
    checked = check_file(str(mine))
    found = [d for d in checked.diagnostics if d.code == code]
    assert found and not checked.ok and any(text in d.message for d in found)
    for d in found:
        assert d.span is not None and d.span.file == str(pins) and d.span.line >= 1 and d.fix
    shown = render.full(found, checked.source.texts)
    assert f"{pins}:" in shown and "^" in shown


def test_editors_accept_the_file_that_is_written(pinned: str) -> None:
    schema = json_schema(PinFile, "interlock pins")
    body = text_keys(yaml.load(pinned, Core))
    jsonschema.validate(body, schema)
    with pytest.raises(jsonschema.ValidationError):
        jsonschema.validate({**body, "cards": {"main": {"1": "A0"}}}, schema)


def test_channels_exchanged_in_the_file_of_pins_are_told_until_somebody_takes_them(tmp_path: Path) -> None:
    layout = tmp_path / "fig2_2.yaml"
    layout.write_text(Path("layouts/fig2_2.yaml").read_text("utf-8"), "utf-8")
    pins = layout.with_suffix(".pins")

    def told(verb: str, *args: str) -> bool:
        return "IL5011" in CliRunner().invoke(cli, [verb, str(layout), *args]).output

    told("pin")
    assert not told("check")
    one, other = "YN_P1: Q0.0, YR_P1: Q0.1", "YN_P1: Q0.1, YR_P1: Q0.0"
    text = pins.read_text("utf-8")
    assert one in text
    pins.write_text(text.replace(one, other), "utf-8")
    assert told("check")
    told("pin")
    assert told("check")
    told("pin", "--force")
    assert other in pins.read_text("utf-8")
    assert not told("check")


def edited(mine: Path, old: str, new: str) -> Path:
    """The file of pins with something else in one place."""
    pins = mine.with_suffix(".pins")
    told = pins.read_text("utf-8")
    assert old in told
    pins.write_text(told.replace(old, new, 1), "utf-8")
    return pins


SUSPECT = (
    (
        "CLR_q1: I0.3",
        "CLR_q1: I500.3",
        "IL2028",
        "CLR_q1 is pinned to I500.3, and no card has byte I500",
        20,
        "(main has I0, I1, I2, I3)",
    ),
    ("CLR_q1: I0.3", "CRL_q1: I0.3", "IL2029", "CRL_q1 is pinned to I0.3", 20, "write CLR_q1 here"),
    ("q1: {CLR_q1", "qq1: {CLR_q1", "IL2029", "stands under qq1 here, but it is a variable of q1", 20, "under q1"),
    ("4: Q2}", "4: Q2}\n  mian: {1: I8}", "IL2029", "the layout has no substation mian", 6, "did you mean main?"),
    (
        "q1: {CLR_q1: I0.3}",
        "zz: {OLD: I3.7}",
        "IL2029",
        "OLD is pinned to I3.7, but the layout has no such",
        20,
        "reserved",
    ),
)


@pytest.mark.parametrize(("old", "new", "code", "text", "line", "fix"), SUSPECT, ids=[s[1] for s in SUSPECT])
def test_pins_that_nothing_bears_out_are_told_with_place_and_fix(
    mine: Path, old: str, new: str, code: str, text: str, line: int, fix: str
) -> None:
    pins = edited(mine, old, new)
    checked = check_file(str(mine))
    (found,) = [d for d in checked.diagnostics if d.code == code]
    assert checked.ok and text in found.message and fix in found.fix
    assert found.span is not None and (found.span.file, found.span.line) == (str(pins), line)
    shown = CliRunner().invoke(cli, ["pin", str(mine)]).output
    assert (text in shown) is ("OLD" not in new), "what is only gone, `pin` is about to reserve"


@pytest.mark.parametrize(
    ("old", "new", "written"),
    [
        ("CLR_q1: I0.3", "CRL_q1: I0.3", {r" {4}q1: .*": "q1: {CLR_q1: I0.3}"}),
        ("q1: {CLR_q1", "qq1: {CLR_q1", {r" {4}qq1: .*": "q1: {CLR_q1: I0.3}"}),
        ("    q1: {CLR_q1: I0.3}\n", "", None),
        ("4: Q2}", "4: Q2}\n  mian: {1: I8}", {r" {2}mian: .*\n": "", r" {2}main: \{1.*": None}),
    ],
    ids=["misspelt", "another element", "beside another's", "substation"],
)
def test_the_lines_that_are_proposed_do(mine: Path, old: str, new: str, written: dict[str, str | None] | None) -> None:
    """They were to be made out by hand: which element, which variables, which slot."""
    pins = edited(mine, old, new)
    if written is None:  # the variable stands among those of a point
        edited(mine, "P1: {", "P1: {CLR_q1: I0.3, ")
    (found,) = [d for d in check_file(str(mine)).diagnostics if d.code == "IL2029"]
    lines = re.findall(r"`(\w+: \{[^`]*\})`", found.fix)
    text = pins.read_text("utf-8")
    if written is None:
        assert lines[0] == "q1: {CLR_q1: I0.3}" and lines[1].startswith("P1: {DN_P1")
        text = re.sub(r"    P1: .*", f"    {lines[1]}\n    {lines[0]}", text)
    for pattern, wanted in (written or {}).items():
        indent = re.match(r" \{(\d)\}", pattern)
        assert wanted in (None, "", lines[0]) and indent is not None
        text = re.sub(pattern, " " * int(indent[1]) + lines[0] if wanted != "" else "", text, count=1)
    pins.write_text(text, "utf-8")
    done = check_file(str(mine))
    assert done.ok and not {d.code for d in done.diagnostics} & {"IL2020", "IL2021", "IL2028", "IL2029"}, (
        done.diagnostics
    )


def test_an_address_that_the_layout_states_needs_no_card(mine: Path) -> None:
    mine.write_text(MINE + "addresses: {CLR_q1: I500.3}\n", "utf-8")
    run("pin", mine, "--yes")
    assert "I500.3" in mine.with_suffix(".pins").read_text("utf-8") and "IL2028" not in run("check", mine)
    mine.write_text(MINE, "utf-8")
    assert "IL2028" in run("check", mine)


def test_ends_of_lines_as_windows_has_them_are_no_change(mine: Path) -> None:
    pins = mine.with_suffix(".pins")
    pins.write_bytes(pins.read_bytes().replace(b"\n", b"\r\n"))
    assert "IL5011" not in run("check", mine) and "nothing has changed" in run("pin", mine)
    mine.write_text(MINE + "conditions: {ROPE: {text: rope, over: [q1]}}\n", "utf-8")
    assert "new      E_ROPE: main I2.2" in run("pin", mine)
    mine.write_text(MINE, "utf-8")
    pins.write_bytes(pins.read_bytes().replace(b"\n", b"\r\n").replace(b"I0.3", b"I3.3"))
    assert "IL5011" in run("check", mine) and "not as interlock wrote it" in run("pin", mine, code=1)


def test_a_folder_of_the_name_of_the_pins_is_told_as_that(mine: Path) -> None:
    pins = mine.with_suffix(".pins")
    pins.unlink()
    pins.mkdir()
    for verb in ("check", "pin", "compile"):
        said = run(verb, mine, code=1)
        assert f"{pins} is a folder; the channels of {mine} are read from a file of that name" in said
        assert "move the folder away" in said and "name a layout file" not in said


def test_pins_that_are_no_text_are_called_pins(mine: Path) -> None:
    pins = mine.with_suffix(".pins")
    pins.write_bytes(b"%PDF-1.7\xff")
    assert "a file of pins is a text file" in run("check", mine, code=1)
    with open(pins, "wb") as handle:
        handle.truncate(50_000_000)
    assert "a file of pins has at most 4 MB" in run("check", mine, code=1)
