"""Numbers with units, in whatever script: the advice is in the unit that the key takes, or none is given."""

from __future__ import annotations

from importlib import import_module
from pathlib import Path

import pytest
from click.testing import CliRunner

import interlock
from interlock.diag import Sink
from interlock.diag.suggest import nearest
from interlock.dispatch.language import load_text

TEXT = """interlock: 1
name: x
boundaries: {W: {approach: a0 600}}
buffers: [B]
tracks: {t: [W, q1 400, B]}
signals: {X1: {from: W, into: q1}}
"""
UNITS = {
    "q1 850米": "write 850: lengths are metres, without the unit",
    "q1 ８５０米": "write 850: lengths are metres, without the unit",
    "q1 0.5公里": "write 500: lengths are metres, without the unit",
    "q1 850 米": "write `q1 850`: lengths are metres, without the unit",
    "line_speed_kmh: 20公里": "write 20: speeds are km/h, without the unit",
    "line_speed_kmh: 20km": "write 20: speeds are km/h, without the unit",
    "line_speed_kmh: 20公里/小时": "write 20: speeds are km/h, without the unit",
    "line_speed_kmh: 5米/秒": "write 18: speeds are km/h, without the unit",
    "line_speed_kmh: 20 km/h": "write 20: speeds are km/h, without the unit",
    "line_speed_kmh: 20分": "write km/h as a plain decimal number, for instance 25",
    "line_speed_kmh: fast": "write km/h as a plain decimal number, for instance 25",
    "approach_release_s: 10分钟": "write 600: times are seconds, without the unit",
    "approach_release_s: １５分": "write 900: times are seconds, without the unit",
    "approach_release_s: 2小时": "write 7200: times are seconds, without the unit",
    "approach_release_s: 30秒": "write 30: times are seconds, without the unit",
    "approach_release_s: 10m": "write seconds as a plain decimal number, for instance 30",
    "approach_release_s: long": "write seconds as a plain decimal number, for instance 30",
    "fouling_m: 3米": "write 3: lengths are metres, without the unit",
    "fouling_m: wide": "write metres as a plain decimal number, for instance 350 or 12.5",
    "fouling_m: 3秒": "write metres as a plain decimal number, for instance 350 or 12.5",
    "speed: 20公里": "write 20: speeds are km/h, without the unit",
    "speed: 20km": "write 20: speeds are km/h, without the unit",
    "speed: 20分": "write whole km/h, from 5 to 400",
    "speed: fast": "write whole km/h, from 5 to 400",
    "speed: 20 km/h": "write 20: speeds are km/h, without the unit",
}


@pytest.mark.parametrize("written", UNITS)
def test_a_number_with_a_unit_is_shown_as_its_key_takes_it(written: str) -> None:
    if written.startswith("q1"):
        text = TEXT.replace("q1 400", written)
    elif written.startswith("speed"):
        text = TEXT + f"sections: {{q1: {{{written}}}}}\n"
    else:
        text = TEXT + f"principles: {{{written}}}\n"
    with pytest.raises(interlock.LayoutError) as caught:
        interlock.loads(text)
    assert [(d.code, d.fix) for d in caught.value.diagnostics if d.code != "IL2004"] == [("IL1013", UNITS[written])]


DISPATCH = """dispatch: 1
layout: x
shift_h: SHIFT
fleet:
  1: {length: 50, wagons: 10, tonnes: 30, speed: SPEED, at: L}
places:
  L: {kind: loading, at: q1, minutes: MINUTES}
"""
OF_DISPATCH = {
    ("SHIFT", "8小时"): "write 8: hours",
    ("SPEED", "10公里/小时"): "write 10: km/h",
    ("SPEED", "10公里"): "write 10: km/h",
    ("MINUTES", "15分钟"): "write 15: minutes",
    ("MINUTES", "15分"): "write 15: minutes",
    ("MINUTES", "１５分"): "write 15: minutes",
    ("MINUTES", "30秒"): "write 0.5: minutes",
    ("MINUTES", "１５"): "write 15, in ASCII digits",
}


@pytest.mark.parametrize("what", OF_DISPATCH, ids=" ".join)
def test_so_it_is_in_a_dispatch_file(what: tuple[str, str]) -> None:
    text = DISPATCH.replace(*what)
    for name, plain in (("SHIFT", "8"), ("SPEED", "10"), ("MINUTES", "15")):
        text = text.replace(name, plain)
    sink = Sink()
    load_text("x.dispatch", text, interlock.loads(TEXT), sink)
    (one,) = sink.diagnostics
    assert one.code == "IL1013" and one.fix.startswith(OF_DISPATCH[what])


def test_full_width_letters_and_digits_are_meant_as_those_that_they_look_like() -> None:
    assert nearest("X２", ("A", "X2", "Y２")) == "X2"
    assert nearest("X2", ("A", "X２")) == "X２"
    assert nearest("Ｗ", ("W", "q1")) == "W"
    assert nearest("x2", ("X2", "X２")) == "X2" and nearest("x２", ("X2", "X２")) == "X２"


@pytest.mark.parametrize(
    ("verb", "option"), [("dispatch", "--orders"), ("simulate", "--dispatch"), ("blocks", "--dispatch")]
)
def test_where_no_dispatch_file_is_the_option_that_names_one_is_told(verb: str, option: str, tmp_path: Path) -> None:
    command = import_module(f"interlock.cli.{verb}").command
    (tmp_path / "x.yaml").write_text(TEXT, "utf-8")
    told = CliRunner().invoke(command, [str(tmp_path / "x.yaml")]).output
    assert f"or name another one with `{option} FILE`" in " ".join(told.split())
