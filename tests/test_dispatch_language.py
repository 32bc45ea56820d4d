"""The language of dispatch: what a shift needs, every lint with its place, and bad input without a traceback."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest
from click.testing import CliRunner

from interlock.app.turns import STOPS_M
from interlock.cli.dispatch import command
from interlock.diag import Sink
from interlock.dispatch.language import load_text
from interlock.dispatch.orders import Derivation
from interlock.dispatch.plan.railway import Railway
from interlock.model.stopping import END_M, MARGIN_M, SIGNAL_M
from tests.layouts import SHIPPED, built

HEISHAN = Path("layouts/heishan.dispatch").read_text("utf-8")


def told(text: str) -> list[str]:
    """The codes that a dispatch file for heishan leads to, each with its place."""
    layout, table, _ = built("heishan")
    sink = Sink()
    orders = load_text("x.dispatch", text, layout, sink)
    if orders is not None:
        Derivation(Railway(table, layout), orders, sink).run()
    assert all(d.span is not None and d.span.line > 0 for d in sink.diagnostics)
    return [d.code for d in sink.diagnostics]


def test_a_shift_is_derived() -> None:
    layout, table, _ = built("heishan")
    sink = Sink()
    orders = load_text("x.dispatch", HEISHAN, layout, sink)
    assert orders is not None
    found = {d.name: d for d in Derivation(Railway(table, layout), orders, sink).run()}
    assert sink.diagnostics == () and list(found) == ["a", "b", "c"]
    assert [d.trains for d in found.values()] == [6, 8, 4], "480 tonnes are eight trains of sixty"
    for d in found.values():
        assert set(d.journeys) == {"1", "2", "3", "4"}
    assert any(s.turned for steps in found["a"].journeys["1"].steps.values() for s in steps), "it loads and comes back"


@pytest.mark.parametrize(
    ("old", "new", "code"),
    [
        ("at: house}", "at: hose}", "IL6002"),
        ("at: s4_xc1", "at: s4_xc9", "IL6002"),
        ("{from: c1,", "{from: c9,", "IL6002"),
        ("{from: c1, to: crush", "{from: c1, to: c2", "IL6002"),
        ("trains: 6, ore: rich", "trains: 6, ore: lean", "IL6002"),
        ("trains: 6, ore", "trains: 6, tonnes: 360, ore", "IL6003"),
        ("trains: 6, ore", "ore", "IL6003"),
        ("trains: 6, ore", "trains: 6, via: [s99], ore", "IL6002"),
        ("trains: 6, ore", "trains: 6, via: [s9], ore", "IL6005"),
        ("at: OUT, minutes: 6", "at: s2_out, minutes: 6, capacity: 9", "IL6009"),
        ("capacity: 8", "capacity: 4", ""),
        ("capacity: 8", "capacity: 3", "IL6009"),
        ("trains: 6,", "trains: 60,", "IL6010"),
        ("by: 6}", "by: 1}", "IL6010"),
        ("minutes: 6}", "minutes: 60}", "IL6010"),
        ("trains: 6, ore: rich", "trains: 6, only: [9], ore: rich", "IL6002"),
        ("\norders:", "\nblocked: [c1]\n\norders:", "IL6013"),
        ("\norders:", "\nblocked: [s8_xc3]\n\norders:", "IL6013"),
        ("\norders:", "\nblocked: [house]\n\norders:", "IL6013"),
        ("\norders:", "\nblocked: [c9]\n\norders:", "IL6002"),
        ("\norders:", "\nblocked: [c2]\n\norders:", ""),
        ("\norders:", "\nblocked: [s9]\n\norders:", "IL6016"),
        ("at: s5_xc2", "at: s4_xc1", "IL6014"),
        ("  2: {length", "  01: {length", "IL6015"),
        ("minutes: 6}", "minutes: 6, back: 0}", "IL1014"),
        ("trains: 6,", "trains: 0,", "IL1014"),
        ("trains: 6,", "trains: 500,", "IL1014"),
        ("minutes: 20, ores: [rich]", "minutes: 0, ores: [rich]", "IL1014"),
        ("length: 60", "length: 0", "IL1014"),
        ("speed: 10", "speed: fast", "IL1013"),
        ("leads: propelled", "leads: pushed", "IL1017"),
        ("kind: waiting", "kind: resting", "IL1017"),
        ("wagons: 10", "waggons: 10", "IL1011"),
        ("kind: tipping, ", "", "IL1010"),
        ("layout: heishan", "layout: mine11", "IL6001"),
        ("orders:", "orders: [", "IL1004"),
    ],
)
def test_lints_and_bad_files(old: str, new: str, code: str) -> None:
    assert old in HEISHAN
    found = told(HEISHAN.replace(old, new, 1))
    assert (code in found) if code else found == []


def test_more_trains_than_standing_room() -> None:
    lines = HEISHAN.splitlines()
    train = next(x for x in lines if x.startswith("  1: "))
    fleet = [train.replace("  1:", f"  {k}:") for k in range(5, 20)]
    assert "IL6009" in told("\n".join([*lines[:7], *fleet, *lines[7:]]))


def test_more_trains_begin_at_a_place_than_it_holds() -> None:
    assert told(HEISHAN.replace("capacity: 8", "capacity: 4")) == []
    assert told(HEISHAN.replace("capacity: 8", "capacity: 3")) == ["IL6009"]
    assert "IL6013" in told(f"{HEISHAN}\nblocked: [house]\n"), "nobody begins where it is blocked"


def test_a_fleet_of_none_or_too_many() -> None:
    head, _, rest = HEISHAN.partition("fleet:")
    _, places, tail = rest.partition("\nplaces:")
    assert "IL6003" in told(head + "places:" + tail)
    many = "".join(f"  {k}: {{length: 60, at: house}}\n" for k in range(500))
    assert told(head + "fleet:\n" + many + places + tail) == ["IL6009"]


def test_a_place_that_no_train_can_leave() -> None:
    text = HEISHAN.replace("places:\n", "places:\n  dead: {kind: crossing, at: s2}\n")
    assert "IL6008" in told(text)


def test_the_command_carries_out_a_shipped_file() -> None:
    done = CliRunner().invoke(command, ["layouts/heishan.yaml", "--explore"], catch_exceptions=False)
    assert done.exit_code == 0 and "order b: 8 trains from c3 to crush" in done.output
    assert "refuses all" in done.output or "refuses the only" in done.output
    done = CliRunner().invoke(command, ["layouts/fig2_1.yaml"], catch_exceptions=False)
    assert done.exit_code == 1 and "[IL1001]" in done.output
    done = CliRunner().invoke(command, ["layouts/mine11.yaml"], catch_exceptions=False)
    assert done.exit_code == 1 and "[IL6003]" in done.output


def test_orders_that_the_plan_leaves_out_are_told(tmp_path: Path) -> None:
    """Each train has one order: four trains, and a fifth and a sixth order."""
    file = tmp_path / "x.dispatch"
    more = [f"  {x}: {{from: {c}, to: crush, trains: 1}}\n" for x, c in (("d", "c1"), ("e", "c2"), ("f", "c4"))]
    file.write_text(HEISHAN + "".join(more), "utf-8")
    done = CliRunner().invoke(command, ["layouts/heishan.yaml", "--orders", str(file)])
    assert "not in the plan, in which each train has one order: e, f\n" in done.output
    done = CliRunner().invoke(command, ["layouts/heishan.yaml", "--orders", str(file), "--format", "json"])
    assert json.loads(done.stdout)["orders_left"] == ["e", "f"]


def test_a_train_has_an_order_that_is_for_it(tmp_path: Path) -> None:
    file = tmp_path / "x.dispatch"
    file.write_text(
        HEISHAN.replace("trains: 6,", "trains: 6, only: [2],").replace("trains: 4,", "trains: 4, only: [1],")
    )
    done = CliRunner().invoke(command, ["layouts/heishan.yaml", "--orders", str(file)])
    loads = dict(re.findall(r"  ([12])          .*-(XC\d)\n", done.output))
    assert done.exit_code == 0 and loads == {"1": "XC3", "2": "XC1"}, "b is for every train, and a for the second"
    file.write_text(file.read_text("utf-8").replace("tonnes: 480,", "tonnes: 480, only: [1, 2],"))
    done = CliRunner().invoke(command, ["layouts/heishan.yaml", "--orders", str(file)])
    assert done.exit_code == 1 and "error[IL6003]: no order is for train 3\n" in done.output


def test_the_files_that_are_shipped_are_read() -> None:
    files = sorted(Path("layouts").glob("*.dispatch"))
    assert {f.stem for f in files} <= set(SHIPPED) and len(files) >= 2
    for f in files:
        layout, table, _ = built(f.stem)
        sink = Sink()
        orders = load_text(str(f), f.read_text("utf-8"), layout, sink)
        assert orders is not None
        Derivation(Railway(table, layout), orders, sink).run()
        assert sink.diagnostics == () and f.read_text("utf-8").startswith("# ")


def test_what_is_dispatched_changes_no_digest_of_a_layout() -> None:
    one = built("heishan")[0].digest
    assert "dispatch" not in built("heishan")[0].to_text() and built("heishan")[0].digest == one


def test_the_page_names_every_key() -> None:
    from interlock.dispatch.language import DispatchFile, LineSpec, OrderSpec, PlaceSpec, TrafficSpec, TrainSpec

    page = Path("interlock/docs/dispatch.md").read_text("utf-8")
    for name in DispatchFile.model_fields:
        assert f"| `{name}` |" in page
    for name in TrafficSpec.model_fields:
        assert f"`{name}`" in page
    for spec in (TrainSpec, PlaceSpec, OrderSpec, LineSpec):
        for name, field in spec.model_fields.items():
            assert f"{field.alias or name}: " in page or f"`{name}`" in page, name


@pytest.mark.parametrize(
    ("key", "value", "fix"),
    [
        ("shift_h", "８", "write 8, in ASCII digits"),
        ("traffic", "{shifts: 3, days: 300, train_t: 60, change_h: ０.5}", "write 0.5, in ASCII digits"),
        ("traffic", "{shifts: ٣, days: 9, train_t: 6}", "write 3, in ASCII digits"),
        ("fleet", "{1: {length: 60, wagons: ３, at: house}}", "write a whole number, 1 to 200, in ASCII digits"),
    ],
)  # fmt: skip
def test_digits_of_other_scripts_are_refused(key: str, value: str, fix: str, tmp_path: Path) -> None:
    file = tmp_path / "x.dispatch"
    file.write_text(f"dispatch: 1\nlayout: heishan\n{key}: {value}\n", "utf-8")
    done = CliRunner().invoke(command, ["layouts/heishan.yaml", "--orders", str(file)])
    assert done.exit_code == 1 and f"fix: {fix}\n" in done.output, done.output


def test_two_trains_do_not_begin_in_one_section() -> None:
    text = HEISHAN.replace("house: {kind: waiting, at: W, capacity: 8}", "house: {kind: waiting, at: s9, capacity: 1}")
    found = told(text)
    assert found.count("IL6009") == 3 + 1, "the second, third and fourth; and the place holds one"


def test_a_place_is_long_enough_for_a_train_that_stops_before_its_end() -> None:
    """Longer trains stood across the points before a place, were never loaded, and nothing moved any more."""
    assert "IL6009" in told(HEISHAN.replace("length: 60", "length: 257.1"))
    assert "IL6009" not in told(HEISHAN.replace("length: 60", "length: 257"))
    assert SIGNAL_M <= MARGIN_M and END_M <= MARGIN_M < STOPS_M
