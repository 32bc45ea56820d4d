"""Wires and addresses: nothing missing, nothing twice, and the mapping program proved to carry each to its place."""

from __future__ import annotations

import csv
import io
import random
import re
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

import openpyxl
import pytest

from interlock.app.check import check_file
from interlock.derivation import derive
from interlock.diag import Sink
from interlock.emit.io import channels_csv, equipment_csv, tags_xlsx
from interlock.emit.python.runtime import runtime_py
from interlock.field.plc import LATE_CYCLE, SoftPlc, runtime_scan
from interlock.frontend import load_text
from interlock.logic.cabinet import BadAddress, allocate
from interlock.logic.controller import Controller
from interlock.logic.lower import lower
from interlock.model.layout import Layout
from interlock.model.pins import Pin
from interlock.proof.equivalence.cabinet import compare_program
from interlock.st.ast import Unit
from interlock.st.delivery import write_st
from interlock.st.dialects import BY_NAME
from interlock.st.lint import lint
from interlock.st.lower import lower_st
from interlock.st.meaning import Execution, Numbers
from interlock.st.printer import print_unit
from interlock.st.program import CYCLE_MAX_MS, HEARTBEAT_MS, cycle, io_program, watch
from interlock.st.structures import structured
from tests.layouts import SHIPPED, SLIPS, built

MINE = open("layouts/mine11.yaml", encoding="utf-8").read()  # noqa: SIM115


def made(extra: str) -> tuple[Layout, Controller]:
    """mine11 with more lines."""
    sink = Sink()
    layout, _ = load_text("mine11.yaml", MINE + extra, sink)
    assert layout is not None, sink.diagnostics
    return layout, lower(layout, derive(layout, sink))


@pytest.mark.parametrize("name", SHIPPED)
def test_every_variable_has_one_place_and_every_address_one_variable(name: str) -> None:
    layout, _, controller = built(name)
    a = allocate(layout, controller)
    wires = [c.variable for c in a.channels]
    assert len({c.address for c in a.wires}) == len(a.wires)
    inputs, outputs = {i.name for i in controller.inputs}, {o.name for o in controller.outputs}
    assert set(wires) | set(a.written) | set(a.read) | {"VALID"} == inputs | outputs
    assert len(wires) == len(set(wires)) and not set(wires) & {*a.written, *a.read}
    assert {c.variable for c in a.channels if c.direction == "I"} <= inputs
    assert {c.variable for c in a.channels if c.direction == "Q"} <= outputs
    assert all(0 <= c.bit < 8 for c in a.channels)
    for kind in "IQ":
        room = sum(c.size for c in a.cards if c.direction == kind)
        used = sum(c.direction == kind for c in a.wires)
        assert used * 1.1 <= room  # a tenth is spare
    assert all(i.restrictive == 0 for i in controller.inputs if i.name in wires)  # a broken wire reads 0


def test_the_counts_of_the_eleven_section_mine() -> None:
    """The rule of document B 2.2 on mine11 with two lamps a signal: 18 outputs, 31 inputs."""
    layout, controller = made("principles: {lamp_proof: true}\n")
    a = allocate(layout, controller)
    assert sum(c.direction == "Q" for c in a.channels) == 7 * 2 + 2 * 2
    assert sum(c.direction == "I" for c in a.channels) == 7 * 2 + 2 * 2 + 11 + 2


def test_substations_and_stated_addresses() -> None:
    layout, controller = made(
        "substations:\n  west: [ap_W, q1, q2, P1, X7, X1]\n  east: []\naddresses: {CLR_q1: I0.3, YN_P2: Q9.7}\n"
    )
    a = allocate(layout, controller)
    assert [c.variable for c in a.heartbeats] == ["HB_west", "HB_east"]
    assert a.by_variable["CLR_q1"].address == "I0.3" and a.by_variable["CLR_q1"].located == "%IX0.3"
    assert a.by_variable["YN_P2"].address == "Q9.7" and a.by_variable["YN_P2"].substation == "east"
    assert {c.element for c in a.channels if c.substation == "west"} == {"ap_W", "q1", "q2", "P1", "X7", "X1"}
    west = [c.byte for c in a.channels if c.substation == "west" and c.direction == "I" and c.slot]
    east = [c.byte for c in a.channels if c.substation == "east" and c.direction == "I"]
    assert max(west) < min(east)
    assert compare_program(controller, a, print_unit(structured(io_program(controller, a, [])))) == ()
    text = print_unit(structured(io_program(controller, a, [])))
    assert "VALID := CYC.WELL AND W_west.WELL AND W_east.WELL;" in text and "CLR_q1 AT %IX0.3 : BOOL;" in text


@pytest.mark.parametrize(
    ("addresses", "message"),
    [
        ("{CLR_q77: I0.3}", "CLR_q77 is no variable with a wire"),
        ("{CLR_q1: Q0.3}", "CLR_q1 is an input"),
        ("{REQ: I0.0}", "no wire"),
    ],
)
def test_addresses_that_cannot_be(addresses: str, message: str) -> None:
    layout, controller = made(f"addresses: {addresses}\n")
    with pytest.raises(BadAddress, match=message.replace("no wire", "no variable")):
        allocate(layout, controller)


def test_an_address_on_a_card_of_another_substation_is_refused() -> None:
    where = "substations:\n  west: [ap_W, q1, q2, P1, X7, X1]\n  east: []\n"
    layout, controller = made(where + "addresses: {CLR_q1: I3.0}\n")
    with pytest.raises(BadAddress, match=r"CLR_q1 belongs to substation west, but I3\.0 is on a card of east"):
        allocate(layout, controller)


def test_stated_addresses_count_against_the_spare_channels() -> None:
    layout, controller = made("")
    names = [c.variable for c in allocate(layout, controller).channels if c.direction == "I"]
    for count in range(1, len(names)):
        stated = ", ".join(f"{n}: I{k // 8}.{k % 8}" for k, n in enumerate(names[:count]))
        layout, controller = made(f"addresses: {{{stated}}}\n")
        a = allocate(layout, controller)
        room = sum(c.size for c in a.cards if c.direction == "I")
        assert (len(names) + 1) * 1.1 <= room
        assert len({c.address for c in a.wires}) == len(a.wires)


def test_check_tells_of_an_address_that_cannot_be(tmp_path_factory: pytest.TempPathFactory) -> None:
    from interlock.app.check import check_file

    path = tmp_path_factory.mktemp("io") / "mine.yaml"
    path.write_text(MINE + "addresses: {CLR_q1: Q0.3}\n", "utf-8")
    (found,) = [d for d in check_file(str(path)).diagnostics if d.code == "IL2015"]
    assert found.span is not None and "begins with I" in found.message


@pytest.mark.parametrize("name", SHIPPED)
def test_the_mapping_program_is_proved_and_passes_our_checks(name: str) -> None:
    layout, _, controller = built(name)
    a = allocate(layout, controller)
    unit = io_program(controller, a, ["made for a test"])
    text = print_unit(structured(unit))
    assert compare_program(controller, a, text) == ()
    core = lower_st(controller, [])
    whole = Unit((*unit.blocks[:2], *core.blocks, unit.blocks[2]))
    assert {f.rule for f in lint(whole) if f.block not in [b.name for b in unit.blocks[:2]]} <= {
        "ST-SIZE",
        "ST-USED",
        "ST-INIT",
    }
    assert all("is never used" in f.text for f in lint(whole) if f.rule == "ST-USED")


def test_a_changed_mapping_is_refuted() -> None:
    layout, _, controller = built("mine11")
    a = allocate(layout, controller)
    text = print_unit(structured(io_program(controller, a, [])))
    changes = [
        ("%IX0.3", "%IX0.4"),
        ("INP.CLR_q1 := CLR_q1", "INP.CLR_q1 := CLR_q2"),
        ("YN_P1 := OUTP.YN_P1", "YN_P1 := OUTP.YR_P1"),
        ("VALID := CYC.WELL AND W_main.WELL", "VALID := W_main.WELL"),
        ("INTERVAL := T#100ms", "INTERVAL := T#10s"),
        ("TURN1 := TURN0", "TURN1 := TURN2"),
        ("  YS_X1 := OUTP.YS_X1;\n", ""),
        ("BLK_q1 : BOOL := TRUE", "BLK_q1 : BOOL := FALSE"),
        ("T#1s", "T#100s"),
        ("W_main(HB := HB_main)", "W_main(HB := CLR_q1)"),
        ("HB AND LAST", "HB OR LAST"),
        ("BEAT := NOT BEAT", "BEAT := BEAT"),
        ("HO_main := BEAT", "HO_main := TRUE"),
        ("  HO_main := BEAT;\n", ""),
        ("BEAT : BOOL := FALSE", "BEAT : BOOL := TRUE"),
        ("YP_X1 AT %QX0.5 : BOOL", "YP_X1 AT %QX0.5 : BOOL := TRUE"),  # proceed until the first cycle is over
        ("CLR_q1 AT %IX0.3 : BOOL", "CLR_q1 AT %IX0.3 : BOOL := TRUE"),
        ("YT_P1 : BOOL", "YT_P1 : BOOL := TRUE"),
        ("  CYC : ", "  Cyc : BOOL;\n  CYC : "),  # to a controller one name
        ("  CYC : ", "  SPARE : BOOL;\n  CYC : "),
        ("_IO\n", "_IO\nVAR_INPUT\n  SPARE AT %QX0.0 : BOOL := TRUE;\nEND_VAR\n"),
        ("_IO\n", "_IO\nVAR_OUTPUT\n  SPARE AT %QX0.0 : BOOL := TRUE;\nEND_VAR\n"),
    ]
    for old, new in changes:
        assert old in text, old
        assert compare_program(controller, a, text.replace(old, new, 1)), old


def test_cabinet_text_and_runtime_run_alike() -> None:
    """The program with wires, by addresses, against the plain runtime by names."""
    from interlock.logic.eval import Machine

    layout, _, controller = built("fig2_3_split")
    a = allocate(layout, controller)
    core = BY_NAME["iec"].read(write_st(controller, BY_NAME["iec"], []))
    program = io_program(controller, a, [])
    numbers = Numbers(dt_ms=100)
    run: Execution[int] = Execution(Unit((*program.blocks[:2], *core.blocks, program.blocks[2])), numbers)
    machine, rng = Machine(controller), random.Random(4)
    for k in range(400):
        inputs = {i.name: rng.randrange(i.size) if i.size else int(rng.random() < 0.8) for i in controller.inputs}
        cabinet = run.main.values
        cabinet.update({n: v for n, v in inputs.items() if n != "VALID"})
        cabinet["HB_main"] = k % 2
        run.scan({})
        inputs["VALID"] = int(k > 0)  # alive from the second scan on
        expected = machine.scan(inputs, 100)
        assert {o.name: bool(run.main.values[o.name]) for o in controller.outputs} == expected, k


HEALTH = """substations:
  west: [ap_W, q1, q2, P1, X7, X1]
  mid: [q3, q4]
  east: []
health:
  west: {by: both, within: 0.5}
  mid: {by: diagnosis}
addresses: {OK_mid: I90.0}
"""


def test_health_is_declared_proved_and_read_restrictive() -> None:
    """A heartbeat of its own time, a diagnosis bit, or both; a substation without outputs gets no heartbeat of ours."""
    layout, controller = made(HEALTH)
    a = allocate(layout, controller)
    assert [c.variable for c in a.heartbeats] == ["HB_west", "HB_east"]
    assert {c.variable: c.address for c in a.diagnoses}["OK_mid"] == "I90.0"
    assert [c.variable for c in a.sent] == ["HO_west", "HO_east"]
    text = print_unit(structured(io_program(controller, a, [])))
    assert "VALID := CYC.WELL AND W_west.WELL AND W_east.WELL AND OK_west AND OK_mid;" in text
    assert "W_west : IL_mine11_H500;" in text and "W_east : IL_mine11_WATCH;" in text
    assert compare_program(controller, a, text) == ()
    for old, new in (
        (" AND OK_mid;", ";"),
        ("W_west.WELL AND W_east.WELL", "W_east.WELL AND W_east.WELL"),
        ("W_west : IL_mine11_H500", "W_west : IL_mine11_WATCH"),
        ("T#500ms", "T#5s"),
        ("OK_west AND OK_mid", "OK_mid AND OK_mid"),
        ("HO_east := BEAT", "HO_west := BEAT"),
        ("HO_east := BEAT", "HO_east := NOT BEAT"),
        ("HO_west AT %QX", "HO_west AT %QX7"),
    ):
        assert old in text and compare_program(controller, a, text.replace(old, new, 1)), old


@pytest.mark.parametrize(
    ("health", "code", "message"),
    [
        ("{north: {}}", "IL2014", "there is no substation north"),
        ("{main: {by: hope}}", "IL1017", "'hope' is not a sign of health"),
        ("{main: {within: 5}}", "IL1014", "5 s is no time for a heartbeat"),
        ("{main: {with: 0.5}}", "IL1011", "unknown key `with`"),
    ],
)
def test_health_that_cannot_be(health: str, code: str, message: str) -> None:
    sink = Sink()
    assert load_text("mine11.yaml", MINE + f"health: {health}\n", sink)[0] is None
    assert [d.code for d in sink.diagnostics if message in d.message] == [code], sink.diagnostics


def test_mapping_and_soft_plc_see_the_same_health_and_both_tell_that_they_are_alive() -> None:
    """Heartbeats that stand still, diagnosis bits, long cycles: VALID, outputs and our heartbeat, scan by scan."""
    layout, controller = made(HEALTH)
    a = allocate(layout, controller)
    core = BY_NAME["iec"].read(write_st(controller, BY_NAME["iec"], []))
    program, numbers, rng = io_program(controller, a, []), Numbers(), random.Random(7)
    run: Execution[int] = Execution(Unit((*program.blocks[:-1], *core.blocks, program.blocks[-1])), numbers)

    class Wired:
        def __init__(self, station: str) -> None:
            self.own = [c.variable for c in a.wires if c.substation == station and c.direction == "I"]

        def read(self) -> dict[str, int]:
            return {n: wires[n] for n in self.own}

        def write(self, values: Mapping[str, bool], heartbeat: bool) -> None:
            self.heartbeat = heartbeat

        def close(self) -> None:
            pass

    links = {s: Wired(s) for s in a.stations}
    plc = SoftPlc(runtime_scan(runtime_py(controller, [])), a, links)
    wires = dict.fromkeys((c.variable for c in a.wires if c.direction == "I"), 0)
    seen: set[tuple[int, tuple[str, ...]]] = set()
    for k in range(300):
        numbers.dt_ms = rng.choice((100, 100, 100, 300, CYCLE_MAX_MS, CYCLE_MAX_MS + 1 if k % 10 == 0 else 100))
        for n in wires:
            if n.startswith("HB_"):
                wires[n] ^= rng.random() < (0.1 if k // 30 % 3 == 2 else 0.9)
            elif rng.random() < 0.3:
                wires[n] = int(rng.random() < (0.9 if n.startswith("OK_") else 0.8))
        operator = {i.name: rng.randrange(i.size) if i.size else 0 for i in controller.inputs if i.name in a.written}
        run.main.values.update({**wires, **operator})
        run.scan({})
        cycle = plc.cycle(operator, numbers.dt_ms)
        values = run.main.values
        assert bool(values["VALID"]) is cycle.valid, (k, cycle.lost)
        assert {o.name: bool(values[o.name]) for o in controller.outputs} == cycle.outputs, k
        assert {bool(values[c.variable]) for c in a.sent} == {links["west"].heartbeat} == {k % 2 == 0}
        seen |= {(int(cycle.valid), tuple(x.split(":")[0] for x in cycle.lost))}
    assert len(seen) > 6 and (1, ()) in seen and (0, (LATE_CYCLE,)) in seen


def test_a_heartbeat_that_stops_is_noticed_in_time_and_one_that_never_came_too() -> None:
    numbers = Numbers(dt_ms=100)
    run: Execution[int] = Execution(Unit((watch("W"),)), numbers)
    assert [run.scan({"HB": 1})["WELL"] for _ in range(30)] == [0] * 30  # stuck since the restart
    assert [run.scan({"HB": k % 2})["WELL"] for k in range(6)] == [1] * 6
    still = [run.scan({"HB": 1})["WELL"] for _ in range(20)]
    assert still == [1] * 9 + [0] * 11 or still == [1] * 10 + [0] * 10
    assert still.index(0) * 100 <= HEARTBEAT_MS
    assert run.scan({"HB": 0})["WELL"] == 1


def test_a_long_cycle_is_noticed_in_the_very_next_scan() -> None:
    numbers, rng = Numbers(), random.Random(3)
    run: Execution[int] = Execution(Unit((cycle("C"),)), numbers)
    for k in range(500):
        numbers.dt_ms = rng.choice((20, 100, CYCLE_MAX_MS - 1, CYCLE_MAX_MS, 3000))
        assert run.scan({})["WELL"] == int(k == 0 or numbers.dt_ms <= CYCLE_MAX_MS)


def test_the_lists_say_the_same_as_the_allocation() -> None:
    layout, _, controller = built("cn6502")
    a = allocate(layout, controller)
    rows = list(csv.DictReader(io.StringIO(channels_csv(layout, controller, a))))
    by_variable = {r["Variable"]: r for r in rows if r["Variable"]}
    assert {n: r["Address"] for n, r in by_variable.items()} == {c.variable: c.address for c in a.wires}
    assert len({r["Address"] for r in rows}) == len(rows) == sum(c.size for c in a.cards)
    assert by_variable["YS_X"]["At restart"] == "1" and by_variable["YP_X"]["At restart"] == "0"
    assert tags_xlsx(layout, a) == tags_xlsx(layout, a)
    sheet = openpyxl.load_workbook(io.BytesIO(tags_xlsx(layout, a)))["PLC Tags"]
    tags = list(sheet.iter_rows(values_only=True))
    assert tags[0][:4] == ("Name", "Path", "Data Type", "Logical Address")
    assert {t[0]: t[3] for t in tags[1:]} == {f"cn6502_{c.variable}": f"%{c.address}" for c in a.wires}
    assert all(re.fullmatch(r"%[IQ]\d+\.[0-7]", str(t[3])) for t in tags[1:])
    equipment = dict(csv.reader(io.StringIO(equipment_csv(layout, a))))
    assert equipment["point machine"] == str(len(layout.machines))
    assert int(equipment["signal, combined"]) + int(equipment["signal, shunt"]) + int(equipment["signal, main"]) == len(
        layout.signalling.signals
    )


def _equipment(layout: Layout, controller: Controller) -> dict[str, int]:
    rows = list(csv.reader(io.StringIO(equipment_csv(layout, allocate(layout, controller)))))[1:]
    return {item: int(count) for item, count in rows}


def test_what_has_to_be_bought_is_counted_once_and_no_more() -> None:
    """Of cn6502, and of a depot with a track in which nothing detects vehicles."""
    layout, _, controller = built("cn6502")
    counted = _equipment(layout, controller)
    called_on = [g.id for g in layout.signalling.signals if g.call_on]
    assert counted["call-on lamp"] == len(called_on) == 2 and set(called_on) == {"X", "XD"}
    aspects = controller.symbols.aspects
    assert (counted["second yellow lamp"], counted["route indicator"]) == (len(aspects.second), len(aspects.indicator))
    assert (len(aspects.second), len(aspects.indicator)) == (2, 4), "each is wired, and was on no list"
    assert "speed indicator" not in counted, "no speed is stated"
    outside = {b.approach for b in layout.track.boundaries} - {None}
    assert counted["approach section with detection"] == len(outside)
    assert counted["section with detection"] == len(layout.track.sections) - len(outside)
    wires = list(csv.DictReader(io.StringIO(channels_csv(layout, controller, allocate(layout, controller)))))
    assert counted["channel in use"] == sum(bool(r["Variable"]) for r in wires) and counted["channel"] == len(wires)
    layout, _, controller = built("depot")
    approaches = sum(b.approach is not None for b in layout.track.boundaries)
    assert _equipment(layout, controller)["section with detection"] == len(layout.track.sections) - approaches - 1
    layout, _, controller = built("flank_lab")
    shown = {g for g, _ in controller.symbols.aspects.speed}
    assert _equipment(layout, controller)["speed indicator"] == len(shown) < len(controller.symbols.aspects.speed), (
        "one at each signal, for all of its speeds"
    )


@pytest.mark.parametrize(("said", "machines"), [("", 2), (", machines: [7]", 1), (", machines: [7L, 7R]", 2)])
def test_a_double_slip_has_four_ends_however_many_machines_lay_them(said: str, machines: int) -> None:
    """With a machine on either side it counted two ends, with one machine four: the blades are the same."""
    layout, _ = load_text("slips.yaml", SLIPS % said, sink := Sink())
    assert layout is not None
    counted = _equipment(layout, lower(layout, derive(layout, sink)))
    assert (counted["point machine"], counted["point end"]) == (machines, 4)


def test_of_double_acting_points_the_machine_counts_once_and_each_end_is_told() -> None:
    """1/3 is commanded and detected as one; whoever mounts a drive at each end reads how many ends there are."""
    layout, _, controller = built("cn6502")
    counted = _equipment(layout, controller)
    assert counted["point machine"] == len(layout.machines) < counted["point end"] == len(layout.pointwork.points)


def test_the_list_of_a_depot_is_what_its_layout_states() -> None:
    """Sheds behind derailers with machines of their own, a key, a bridge; all on one substation."""
    layout, _, controller = built("depot")
    assert _equipment(layout, controller) == {
        "signal, main": 1,  # E
        "signal, combined": 2,  # A1, A2
        "signal, shunt": 5,  # W, K1 to K3, B1
        "section with detection": 10,
        "approach section with detection": 1,
        "point machine": 3,  # P1 to P3
        "point worked by hand, with key": 1,  # PH
        "point end": 4,
        "derailer machine": 3,  # D1 to D3
        "derailer": 3,
        "interlock": 1,  # the bridge
        "substation": 1,
        "card, 16 digital inputs": 2,
        "card, 16 digital outputs": 3,
        "channel": 80,
        "channel in use": 66,
    }


def test_boards_lights_distant_signals_and_conditions_are_counted_each_by_its_kind() -> None:
    more = """conditions: {gate: {text: gate shut}, key: {text: key in}}
distants: {VA: {of: A}}
"""
    text = Path("tests/layouts_for_tests/boards.yaml").read_text("utf-8")
    text = text.replace("kind: shunt, stops_trains: yes", "kind: board") + more
    layout, _ = load_text("boards.yaml", text, sink := Sink())
    assert layout is not None, sink.diagnostics
    counted = _equipment(layout, lower(layout, derive(layout, sink)))
    assert (counted["stop board"], counted["limit-of-shunt board"]) == (2, 1), "H and D2, LS"
    assert (counted["external condition"], counted["distant signal"]) == (2, 1)
    checked = check_file("tests/layouts_for_tests/identifiers.yaml")
    assert checked.layout is not None and checked.table is not None
    counted = _equipment(checked.layout, lower(checked.layout, checked.table))
    assert counted["identifier light"] == len(checked.layout.signalling.identifiers) > 0


def test_a_wire_at_a_stated_address_beyond_all_cards_is_in_the_wiring_list() -> None:
    layout, controller = made("addresses: {CLR_q1: I90.3, YN_P1: Q91.0}\n")
    rows = csv.DictReader(io.StringIO(channels_csv(layout, controller, allocate(layout, controller))))
    stated = {r["Variable"]: (r["Slot"], r["Card"], r["Address"]) for r in rows if r["Slot"] == "as stated"}
    assert stated == {"CLR_q1": ("as stated", "DI", "I90.3"), "YN_P1": ("as stated", "DO", "Q91.0")}


def _kept(layout: Layout, controller: Controller, *gone: tuple[str, str, str, int, int]) -> Layout:
    """A layout whose cabinets are wired as they are allocated, and with channels of what it no longer has."""
    pins = allocate(layout, controller).pins
    kept = tuple(Pin(variable, station, "gone", d, byte, bit) for variable, station, d, byte, bit in gone)
    return replace(layout, hardware=replace(layout.hardware, pins=replace(pins, reserved=kept)))


def test_channels_in_use_reserved_and_all_of_them_are_counted_as_the_wiring_list_has_them() -> None:
    layout, _, controller = built("depot")
    before = _equipment(layout, controller)
    assert "channel, reserved" not in before
    free = [r for r in _wiring(layout, controller) if r["When 1"] == "spare"]
    assert before["channel"] - before["channel in use"] == len(free) > 2
    a, b = next(r for r in free if r["Card"] == "DI"), next(r for r in free if r["Card"] == "DO")
    gone = [(f"X{k}", r["Substation"], r["Address"][0], int(r["Byte"]), int(r["Bit"])) for k, r in enumerate((a, b))]
    kept = _kept(layout, controller, *gone)
    wires = _wiring(kept, controller)
    assert {r["Address"]: r["When 1"] for r in wires if "reserved" in r["When 1"]} == {
        a["Address"]: "reserved for X0 of gone",
        b["Address"]: "reserved for X1 of gone",
    }
    assert _equipment(kept, controller) == before | {"channel, reserved": 2}, "neither spare nor in use"


def test_a_channel_that_is_kept_in_a_cabinet_that_is_gone_is_on_neither_list() -> None:
    """Its card is not counted either: it is to be bought for no cabinet of the layout."""
    layout, _, controller = built("depot")
    before, pins = _equipment(layout, controller), allocate(layout, controller).pins
    kept = _kept(layout, controller, ("X0", "far", "I", 40, 3))
    cards = (*pins.cards, replace(pins.cards[0], substation="far", slot=1, direction="I", byte=40))
    kept = replace(kept, hardware=replace(kept.hardware, pins=replace(kept.hardware.pins, cards=cards)))
    assert allocate(kept, controller).reserved and not [r for r in _wiring(kept, controller) if "X0" in r["When 1"]]
    assert _equipment(kept, controller) == before


def _wiring(layout: Layout, controller: Controller) -> list[dict[str, str]]:
    """The wiring list."""
    return list(csv.DictReader(io.StringIO(channels_csv(layout, controller, allocate(layout, controller)))))
