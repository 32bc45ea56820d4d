"""The book of tests for commissioning: what has to come is read from the table, and comes on the bench."""

from __future__ import annotations

import csv
import html
import json
import re
from dataclasses import replace
from pathlib import Path

import pytest
from click.testing import CliRunner

from interlock.app.check import check_file
from interlock.app.commission import not_in
from interlock.cli.main import cli
from interlock.commissioning.book import book
from interlock.commissioning.page import WITHOUT
from interlock.commissioning.step import Sheet, Step
from interlock.derivation import derive
from interlock.diag import Sink
from interlock.emit.python.runtime import runtime_py
from interlock.frontend import load_text
from interlock.logic.cabinet import allocate
from interlock.logic.controller import Controller
from interlock.logic.expr import var
from interlock.logic.lower import lower
from interlock.model.elements import MachineId, Position
from interlock.model.layout import Layout
from interlock.proof.mutation.weakenings import KINDS
from interlock.table.rows import InterlockingTable
from tests.campaigns.commissioning import noticed
from tests.grow_all import grow_all
from tests.layouts import SHIPPED, built

HERE = Path(__file__).resolve().parent
LARGE = ("cn6502",)
"""Its book takes some seconds; the campaign makes it."""


def of(layout: Layout, table: InterlockingTable, controller: Controller) -> list[Step]:
    return list(book(layout, table, controller, allocate(layout, controller), runtime_py(controller, [])))


def derived(path: str) -> tuple[Layout, InterlockingTable, Controller]:
    found = check_file(path)
    assert found.layout is not None and found.table is not None
    return found.layout, found.table, lower(found.layout, found.table)


@pytest.mark.parametrize("name", [n for n in SHIPPED if n not in LARGE])
def test_on_the_bench_comes_what_the_table_says(name: str) -> None:
    steps = of(*built(name))
    assert [(s.number, s.do, s.expect, s.came) for s in steps if s.came] == []
    assert {s.sheet for s in steps} == set(Sheet) and len({s.number for s in steps}) == len(steps)


@pytest.mark.parametrize(
    "name",
    [
        "air_lock_doors",
        "called_on",
        "identifier",
        "overlaps_join",
        "overlap_past_signals",
        "token",
        "held_apart",
        "boards",
    ],
)
def test_so_it_does_with_air_locks_call_on_routes_past_signals_tokens_and_what_is_held(name: str) -> None:
    steps = of(*derived(f"tests/layouts_for_tests/{name}.yaml"))
    assert [(s.number, s.do, s.expect, s.came) for s in steps if s.came] == []


@pytest.mark.parametrize("seed", [*range(40), 504, 965])
def test_so_it_does_on_layouts_grown_at_random(seed: int) -> None:
    sink = Sink()
    layout, _ = load_text("grown.yaml", grow_all(seed), sink)
    if layout is None:
        return
    table = derive(layout, sink)
    if sink.has_errors or len(table.routes) > 40:
        return
    steps = of(layout, table, lower(layout, table))
    assert [(s.number, s.do, s.expect, s.came) for s in steps if s.came] == []


X1_A = """
all clear, nothing set, machines the other way where they can be moved: ask for route X1-A, by its number 1
  points P1 normal; signal X1 shows clear (YP_X1), every other signal stop; indicated as locked: DP
signal X1 at proceed: section SA reported occupied, and then as before
  it shows stop in the same scan, and stays at stop afterwards
points P1 without detection: ask for route X1-A
  signal X1 stays at stop
signal X1 at proceed: try to move P1 reverse
  nothing moves, and it stays at proceed
signal X1 at proceed: points P1 loses its detection, and then as before: ask for route X1-A again
  stop, before and after; once it is confirmed that points P1 was looked at, signal X1 opens when asked
signal X1 at proceed for route X1-A: ask for hostile route X3-C
  it is refused, and the signal stays at proceed
all clear, nothing set: ask for route X1-A on the spot (LREQ), by its number 1
  signal X1 opens
signal X1 at proceed, no train before it: cancel route X1-A
  stop at once, and the route is given up at once
signal X1 at proceed, a train in SC: cancel route X1-A
  stop at once; DP stays locked for 60 s, and then the route is given up
the train over route X1-A comes into DP, and leaves SC
  signal X1 shows stop at the first axle; DP is locked
"""


def test_a_route_is_tested_cell_by_cell() -> None:
    """Points, signal, track, locking, hostile routes, cancelling and release of a route of the smallest junction."""
    steps = [s for s in of(*built("fig2_2")) if s.of == "X1-A"]
    printed, looked_for = [f"{s.do}\n  {s.expect}\n" for s in steps], X1_A.strip().split("\n")
    pairs = [f"{do}\n{expect}\n" for do, expect in zip(looked_for[::2], looked_for[1::2], strict=True)]
    assert len(steps) == 21 and all(s.tried for s in steps)
    assert [x for x in printed if x in pairs] == pairs


def test_every_wire_is_tested_with_both_values_and_an_open_circuit() -> None:
    layout, table, controller = built("flank_lab")
    wires = [s for s in of(layout, table, controller) if s.sheet is Sheet.WIRES]
    channels = allocate(layout, controller).wires
    assert {s.of for s in wires} == {f"{c.substation} slot {c.slot} {c.address}" for c in channels}
    lamp = [f"{s.do}: {s.expect}" for s in wires if s.of == "main slot 5 Q1.6"]
    assert len(lamp) == 2 and "nothing else" in lamp[0] and not any(s.tried for s in wires)


@pytest.mark.parametrize(
    ("kind", "said"),
    [
        ("section-not-checked", "it opens"),
        ("detection-not-required", "it stays at proceed"),
        ("point-free-while-locked", "reverse"),
        ("two-grants", "is locked"),
        ("clear-before-stop", "lit: YP_S1"),
        ("call-on-unasked", "it is set"),
        ("cancel-with-train", "given up too early"),
        ("restart-unlocked", "is not locked"),
        ("stop-lamp-dark", "does not show stop"),
        ("trailed-unseen", "no alarm"),
        ("trailed-uncommanded", "no alarm"),
        ("hand-beside-grant", ""),  # two requests in one scan: no test of one route from rest shows it, the proof does
    ],
)
def test_a_controller_that_is_wrong_is_noticed(kind: str, said: str) -> None:
    layout, table, _ = built("junction")
    found = [noticed(layout, table, weak) for _, weak in next(k for k in KINDS if k.name == kind).make(layout, table)]
    assert any(said in x for x in found) if said else not any(found)


def test_a_section_given_back_behind_a_train_while_another_comes_is_noticed() -> None:
    """Further back than the section before the signal: only a test with a second train can tell (R9)."""
    layout, table, _ = built("flank_lab")
    kind = next(k for k in KINDS if k.name == "approach-not-asked")
    assert any("is released" in noticed(layout, table, weak) for _, weak in kind.make(layout, table))


def test_points_that_are_driven_when_the_controller_is_switched_on_are_noticed() -> None:
    layout, table, controller = built("junction")
    drive = controller.symbols.machines.drive[MachineId("101"), Position.REVERSE]
    right = next(o for o in controller.outputs if o.name == drive)
    running = var(controller.symbols.start.running)
    wrong = tuple(replace(o, expr=running) if o is right else o for o in controller.outputs)
    assert noticed(layout, table, replace(controller, outputs=wrong)).startswith("S1 switch the controller on")


def test_after_a_change_only_what_is_new_is_tested_again() -> None:
    old = of(*built("fig2_2"))
    assert not_in(old, old) == ()
    text = Path("layouts/fig2_2.yaml").read_text("utf-8")
    layout, _ = load_text("new.yaml", f"{text}\nprinciples: {{approach_release_s: 90}}\n", Sink())
    assert layout is not None
    table = derive(layout, Sink())
    again = not_in(of(layout, table, lower(layout, table)), old)
    assert again and all("for 90 s" in s.expect or s.sheet is Sheet.TIMES for s in again)


def test_the_command_writes_sheets_and_a_table(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    layout = str(Path("layouts/fig2_2.yaml").resolve())
    monkeypatch.chdir(tmp_path)
    run = CliRunner()
    done = run.invoke(cli, ["commission", layout])
    assert done.exit_code == 0 and "all as expected" in done.output
    rows = list(csv.reader(Path("fig2_2_tests.csv").read_text("utf-8").splitlines()))
    page = Path("fig2_2_tests.html").read_text("utf-8")
    assert all(row[0] in page for row in rows[1:-1]) and "not certified" in page
    assert all(html.escape(x) in page for x in WITHOUT)
    digest = re.search(r"Layout fig2_2, (\w+)\.", page)
    assert digest and f'@bottom-left {{ content: "fig2_2, {digest[1]}"' in page, "a sheet by itself says what it is of"
    assert "counter(page)" in page and "counter(pages)" in page
    assert page.count(", tested by: ____") == page.count("<h2>") + 1, "each part is signed, and all of it"
    signed = re.findall(r'<p class="sign">(.*?)</p>', page)
    assert all(re.fullmatch(r"(<span>[^<]*: _+</span> ?){3}", x) for x in signed), "no line stands apart from its word"
    Path("fig2_2_tests.csv").write_text("seen: all right", "utf-8")  # what a tester has filled in is not overwritten
    done = run.invoke(cli, ["commission", layout])
    assert done.exit_code == 1 and "--force" in done.output
    one = run.invoke(cli, ["commission", layout, "--route", "X1-A", "-o", "one.csv", "--format", "json"])
    told = json.loads(one.stdout)
    assert told["ok"] and set(told["tests"]) == {"routes"} and told["files"] == ["one.csv"]
    none = run.invoke(cli, ["commission", layout, "--since", layout, "-o", "none.html"])
    assert none.exit_code == 0 and "no test" in none.output and "every test of the old book applies" in none.output
    longer = Path("longer.yaml")
    longer.write_text(f"{Path(layout).read_text('utf-8')}\nprinciples: {{approach_release_s: 90}}\n", "utf-8")
    since = run.invoke(cli, ["commission", str(longer), "--since", layout, "-o", "since.html", "--route", "X1-A"])
    told = "1 test of the old book no longer applies as it was: X1-A 1"
    assert told in since.output and f"{told}." in Path("since.html").read_text("utf-8")
    as_json = ["commission", str(longer), "--since", layout, "-o", "since.csv", "--format", "json"]
    told_of = json.loads(run.invoke(cli, as_json).stdout)
    assert told_of["gone"]["X1-A"] == 1 and told_of["gone"]["times"] > 0


@pytest.mark.parametrize(
    ("args", "code", "said"),
    [
        (["--route", "X1-Z"], 2, "has no route X1-Z"),
        (["-o", "tests.pdf"], 2, "NAME.html, for printing, or NAME.csv"),
        (["--since", "none.yaml"], 1, "none.yaml"),
    ],
)
def test_what_keeps_it_from_its_work_is_told(args: list[str], code: int, said: str) -> None:
    done = CliRunner().invoke(cli, ["commission", "layouts/fig2_2.yaml", *args])
    assert done.exit_code == code and said in done.output


def test_what_is_not_proved_has_no_book(tmp_path: Path) -> None:
    target = tmp_path / "x.html"
    done = CliRunner().invoke(cli, ["commission", "layouts/refuted/wrong_waiver.yaml", "-o", str(target)])
    assert done.exit_code == 1 and "REFUTED" in done.output and not target.exists()


def test_what_no_test_tries_stands_in_the_documents_as_on_the_page() -> None:
    said = " ".join(Path("interlock/docs/commissioning.md").read_text("utf-8").split())
    assert [x for x in WITHOUT if x not in said] == []
