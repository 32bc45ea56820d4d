"""Names with spaces, as on drawings: in every kind of element, from the layout's text to what is typed."""

from __future__ import annotations

import csv
import io
import json
import re
import shutil
import xml.etree.ElementTree as ET
from pathlib import Path
from typing import Any

import pytest
import yaml

from interlock.app.compile import build
from interlock.app.export import aiger_file
from interlock.app.run import BadCommand, Operator, Ready
from interlock.checker.check import check
from interlock.derivation import derive
from interlock.diag import Severity, Sink
from interlock.dispatch.commands import BadOrder, errand
from interlock.emit.c99.runtime import runtime_c
from interlock.emit.drawing import plan_svg
from interlock.emit.io import tags_xlsx
from interlock.frontend import load_text
from interlock.frontend.scalars import NAME, item_parts
from interlock.logic import names
from interlock.logic.cabinet import allocate
from interlock.logic.lower import lower
from interlock.logic.sentences import sentence
from interlock.model.machines import Machines
from interlock.model.portable import beside, portable
from interlock.proof.equivalence.c_text import compare_c
from interlock.proof.equivalence.cabinet import compare_delivery
from interlock.st.delivery import write_delivery
from interlock.st.dialects import BY_NAME
from tests.certified import certified

SPACES = Path("tests/layouts_for_tests/spaces.yaml")


@pytest.fixture(scope="module")
def made() -> tuple[Ready, dict[str, bytes]]:
    """The layout with spaces, proved and written."""
    proved, files = build(str(SPACES))
    checked = proved.checked
    assert proved.green and checked.layout is not None and checked.table is not None
    controller = lower(checked.layout, checked.table)
    allocation = allocate(checked.layout, controller)
    return Ready(proved, checked.layout, checked.table, controller, allocation, files["runtime.py"].decode()), files


def test_every_name_of_the_layout_has_spaces(made: tuple[Ready, dict[str, bytes]]) -> None:
    """So that no kind of element is forgotten here; what the layout does not name itself is the track's graph."""
    layout = made[0].layout
    assert layout is not None
    named = [
        *(s.id for s in layout.track.sections),
        *(g.id for g in layout.signalling.signals),
        *(p.id for p in layout.pointwork.points),
    ]
    named += [
        *(b.node for b in layout.track.boundaries),
        *(c.id for c in layout.signalling.conditions),
        *(z.id for z in layout.declared.zones),
    ]
    named += [
        *(d.id for d in layout.signalling.devices),
        *(d.id for d in layout.signalling.distants),
        *layout.signalling.boards,
        *layout.signalling.stops,
    ]
    named += [
        *(p.machine for p in layout.pointwork.points),
        *(r.name for r in layout.declared.named_routes),
        layout.name,
    ]
    named += [*(v.name for v in layout.declared.voyages), *(s.name for s in layout.hardware.substations)]
    assert named and all(" " in n for n in named if not n.startswith("BF/"))


def test_it_is_proved_and_its_texts_are_plain(made: tuple[Ready, dict[str, bytes]]) -> None:
    ready, files = made
    for place, data in files.items():
        if place.startswith("st/iec/"):
            assert " " not in place and place.isascii() and data.isascii(), place
    rows = list(csv.DictReader(io.StringIO(files["io/names.csv"].decode())))
    assert {"Kind": "section", "Name": "Ladegleis Süd 3", "Name in PLC text": portable("Ladegleis Süd 3")} in rows
    channels = files["io/channels.csv"].decode()
    assert "CLR_22_T" in channels and f"CLR_{portable('Ladegleis Süd 3')}" in channels
    assert "Signal 1 W-Signal 11 P" in files["table.csv"].decode()
    assert {r["id"] for r in json.loads(files["table.json"])["routes"]} == {str(r.id) for r in ready.table.routes}


def test_plan_and_report_are_well_formed_and_no_id_has_a_space(made: tuple[Ready, dict[str, bytes]]) -> None:
    files = made[1]
    tree = ET.fromstring(files["plan.svg"].decode())
    ids = [x for e in tree.iter() if (x := e.get("id"))]
    assert len(set(ids)) == len(ids) and not any(c in x for x in ids for c in " \t\n")
    assert (
        "section-22\u00a0T" in ids and "signal-Signal\u00a01\u00a0W" in ids and "device-BÜ\u00a07\u00a0Mühlweg" in ids
    )
    assert 'value="Signal 1 W-Signal 11 P"' not in files["index.html"].decode()
    assert "<option>Signal 1 W-Signal 11 P</option>" in files["index.html"].decode()


@pytest.mark.parametrize("dialect", [n for n in BY_NAME if n != "iec"])
def test_every_dialect_is_read_back_and_proved(made: tuple[Ready, dict[str, bytes]], dialect: str) -> None:
    ready, _ = made
    assert ready.controller is not None and ready.allocation is not None and ready.layout is not None
    files = write_delivery(ready.controller, ready.allocation, BY_NAME[dialect], ["made for a test"])
    tags = tags_xlsx(ready.layout, ready.allocation)
    assert compare_delivery(ready.controller, ready.allocation, BY_NAME[dialect], files, tags) == ()
    assert all(" " not in n and (t.isascii() or n.endswith(".xml")) for n, t in files.items())
    for name, text in files.items():
        if name.endswith(".xml"):
            ids = [v for e in ET.fromstring(text).iter() for k, v in e.attrib.items() if k in ("name", "instanceName")]
            assert ids and not any(" " in v for v in ids)


def test_the_c_file_is_read_back_and_proved(made: tuple[Ready, dict[str, bytes]]) -> None:
    ready, _ = made
    assert compare_c(ready.controller, runtime_c(ready.controller, ["made for a test"])).proved


def test_the_runtime_takes_routes_by_name(made: tuple[Ready, dict[str, bytes]]) -> None:
    space: dict[str, Any] = {}
    exec(compile(made[1]["runtime.py"], "runtime.py", "exec"), space)
    controller = space["Controller"]()
    assert controller.request("Einfahrt Gleis 1") == controller.request("Signal 1 W-Signal 11 P")
    inputs = {
        n: size - 1 if size == 2 else 0 for n, (_, size) in space["INPUTS"].items() if n.startswith(("CLR_", "VALID"))
    }
    controller.scan(inputs, 100)
    controller.scan({**inputs, **controller.request("Einfahrt Gleis 1")}, 100)
    assert controller.status("Signal 1 W-Signal 11 P")[1] and controller.why_not("Einfahrt Gleis 1") is not None


def test_typed_commands_take_names_with_spaces(made: tuple[Ready, dict[str, bytes]]) -> None:
    operator = Operator(made[0])
    operator.type("set Einfahrt  Gleis 1")
    operator.type("cancel Signal 1 W")
    operator.type("voyage Durchfahrt Ost")
    assert [r.name for r in operator.dispatcher.pending] == ["Durchfahrt Ost"]
    operator.type("voyage Durchfahrt Ost")
    operator.type("voyage Durchfahrt Ost 2 end")
    operator.type("voyage Durchfahrt Ost end")
    operator.type("voyage Lok 7: Strecke W > Gleis 1")
    assert [r.name for r in operator.dispatcher.pending] == ["Lok 7"]
    for wrong in ("set Einfahrt", "cancel Signal 1", "voyage Durchfahrt", "set", "voyage Durchfahrt Ost end"):
        with pytest.raises(BadCommand):
            operator.type(wrong)


def test_a_voyage_that_another_one_could_end_is_not_guessed(made: tuple[Ready, dict[str, bytes]]) -> None:
    operator = Operator(made[0])
    operator.voyages = (*operator.voyages, "Durchfahrt Ost end")
    with pytest.raises(BadCommand, match="there are voyages Durchfahrt Ost and Durchfahrt Ost end"):
        operator.type("voyage Durchfahrt Ost end")


def test_commands_of_the_dispatcher(made: tuple[Ready, dict[str, bytes]]) -> None:
    railway = Operator(made[0]).dispatcher.railway
    found, _ = errand(railway, "12: Strecke W > Gleis 1 + 22 T > Strecke O", 60.0)
    assert [(leg.to, set(leg.via)) for leg in found.legs] == [("Gleis 1", {"22 T"}), ("Strecke O", set())]
    inside, _ = errand(railway, "12:Gleis 1/Signal 11 P>Strecke O", 60.0)
    assert inside.start[0][0] == "Gleis 1"
    for wrong in ("12:Strecke  W>Gleis 1", "12:Gleis>Strecke O", "12:Gleis 1/Signal>Strecke O"):
        with pytest.raises(BadOrder):
            errand(railway, wrong, 60.0)


PREFIX = "Zz "


class _Renamed:
    """A layout's tree with a word before every name."""

    def __init__(self, body: dict[str, Any]) -> None:
        self.names = {n for k in ROOMS for n in body.get(k) or {}} | {*body.get("buffers", ()), *body.get("traps", ())}
        self.names |= {item_parts(x)[0] for items in body["tracks"].values() for x in items}
        self.names |= {v["section"] for k in ("points", "slips", "derailers") for v in (body.get(k) or {}).values()}
        self.names |= {a["section"] for c in (body.get("crossings") or {}).values() for a in c["arms"]}
        self.names |= {v["approach"].split()[0] for v in body["boundaries"].values() if v and "approach" in v}
        self.names |= {v["machine"] for v in (body.get("points") or {}).values() if "machine" in v}
        self.names |= {m for v in (body.get("slips") or {}).values() for m in v.get("machines", ())}
        self.body = {k: v if k in PLAIN else self.tree(v) for k, v in body.items()}

    def tree(self, x: Any, key: str = "") -> Any:
        if isinstance(x, dict):
            return {self.text(k): v if k in PLAIN else self.tree(v, k) for k, v in x.items()}
        return [self.tree(y, key) for y in x] if isinstance(x, list) else self.text(x)

    def text(self, x: str) -> str:
        known = x in self.names or item_parts(x)[0] in self.names or x.partition(".")[0] in self.names
        return PREFIX + x if known else x


ROOMS = (
    *("boundaries", "tracks", "points", "crossings", "slips", "derailers", "level_crossings", "interlocks", "signals"),
    *("distants", "sections", "conditions", "zones", "routes", "voyages"),
)
PLAIN = (
    *("interlock", "name", "title", "profile", "principles", "text", "label", "reason", "kind", "lint", "lane", "hand"),
    *("speed", "legs", "length", "telegram", "target", "title_block", "trains", "block", "single", "order"),
)


@pytest.mark.parametrize("name", ["depot", "slip_junction", "terminus", "flank_lab", "pit_bottom"])
def test_a_space_in_every_name_changes_nothing_but_the_names(name: str) -> None:
    """The same table, route by route and cell by cell, and a plan in which the same lines lie at the same places."""
    body = yaml.load(Path(f"layouts/{name}.yaml").read_text("utf-8"), yaml.BaseLoader)
    renamed = _Renamed(body).body
    told = renamed.setdefault("sections", {})
    for items in renamed["tracks"].values():
        for section, metres in map(item_parts, items):
            told.setdefault(section, {}) if metres else None
    sink = Sink()
    layout, _ = load_text(name, yaml.safe_dump(renamed, allow_unicode=True, sort_keys=False), sink)
    before, _ = load_text(name, Path(f"layouts/{name}.yaml").read_text("utf-8"), Sink())
    assert layout is not None and before is not None, [d.message for d in sink.diagnostics]
    now, then = derive(layout, Sink()), derive(before, Sink())
    assert all(PREFIX in r.id for r in now.routes)
    cells, wanted = (re.sub(" at 0x[0-9a-f]+", "", repr(t.routes)) for t in (now, then))
    assert cells.replace(PREFIX, "") == wanted


@pytest.mark.parametrize("name", ["22 T", "Signal 12 A", "Gleis 3", "Ж 1#", "北 1/2 3", "a b c d"])
def test_names_with_single_spaces_are_names(name: str) -> None:
    assert NAME.fullmatch(name)
    assert " " not in portable(name)


LINE = """interlock: 1
name: demo
boundaries: {W: {approach: wa 600}, E: {trains: out}}
tracks:
  main: [W, %s, q2 200, E]
signals:
  X1: {from: W, into: %s}
  X2: {from: %s, into: q2}
"""


@pytest.mark.parametrize(
    ("name", "why"),
    [
        ("Gleis  3", "two spaces stand beside each other"),
        ("Gleis\t3", "it has a tab in it"),
        ("Gleis\u00a03", "it has a no-break space in it"),
        ("Gleis\u30003", "it has a ideographic space in it"),
        ("Gleis\u200b3", "it has a zero width space in it"),
        ("Gleis\u31643", "it has a hangul filler in it"),
        (" Gleis 3", "it begins or ends with a space"),
        ("Gleis 3 ", "it begins or ends with a space"),
    ],
)
def test_what_nobody_sees_is_refused_with_a_fix(name: str, why: str) -> None:
    sink = Sink()
    load_text("t", LINE % ("q1 200", json.dumps(name, ensure_ascii=False), "q1"), sink)
    (found,) = [d for d in sink.diagnostics if d.code == "IL1016"]
    near = "Gleis3" if "\u200b" in name or "\u3164" in name else "Gleis 3"
    assert why in found.message and f"write `{near}`" in found.fix


@pytest.mark.parametrize("sign", ["\\0", "\\a", "\\r", "\\e", "\\x7f", "\\N", "\\uFFFE", "\\uFFFF"])
@pytest.mark.parametrize("where", ["title: %s", "title_block: {author: %s}", "exclude: [{from: X1, reason: %s}]"])
def test_a_text_that_not_every_output_can_hold_is_refused(where: str, sign: str) -> None:
    sink = Sink()
    load_text("t", LINE % ("q1 200", "q1", "q1") + where % f'"halt{sign} 1"' + "\n", sink)
    (found,) = sink.diagnostics
    assert found.code == "IL1012" and found.span is not None and found.span.line == 9, found
    assert "has the character U+" in found.message and found.fix.startswith("leave it out")


def test_a_text_of_several_lines_with_tabs_stands() -> None:
    sink = Sink()
    layout, _ = load_text("t", LINE % ("q1 200", "q1", "q1") + 'title: "halt\\n\\tat km 12"\n', sink)
    assert layout is not None and layout.printed.title == "halt\n\tat km 12"


@pytest.mark.parametrize(
    ("item", "section", "metres"),
    [
        ("Gleis 3 200", "Gleis 3", 200.0),
        ("Gleis 3   200.5", "Gleis 3", 200.5),
        ("Gleis 3 0200", "Gleis 3", 200.0),
        ("22 T 200", "22 T", 200.0),
        ("1 200", "1", 200.0),
        ("Gleis Nord 200", "Gleis Nord", 200.0),
    ],
)
def test_the_last_word_is_the_length(item: str, section: str, metres: float) -> None:
    sink = Sink()
    layout, _ = load_text("t", LINE % (item, section, section), sink)
    assert layout is not None, sink.diagnostics
    assert {e.section: e.length for e in layout.track.edges}[section] == metres  # type: ignore[index]


@pytest.mark.parametrize(
    ("item", "section", "fix"),
    [
        ("q1 1 200", "q1", "write `q1 1200`, or"),  # thousands
        ("q1 400 q3 300", "q1", "write `q1 400, q3 300`"),  # a comma
        ("q1 q3 300", "q1", "divide what follows one another by commas"),
        ("Gleis 3", "Gleis 3", "write `Gleis 3 100`"),  # a length
        ("Gleis 3", "Gleis", "write `Gleis 3 100`"),  # as Gleis 4 beside it
        ("Nord 3", "Nord", "write `Nord 3.0` if the section is meant"),  # a buffer
    ],
)
def test_what_can_be_read_in_two_ways_is_refused(item: str, section: str, fix: str) -> None:
    text = LINE % (item, section, section) + "sections: {Gleis 4: {}}\nbuffers: [Nord 3]\n"
    text = text.replace("q2 200, E]", "q2 200, E]\n  other: [Gleis 4 100, Nord 3]")
    sink = Sink()
    layout, _ = load_text("t", text, sink)
    assert layout is None
    assert fix in next(d for d in sink.diagnostics if d.code == "IL1021").fix


def test_a_length_in_two_words_is_no_approach() -> None:
    sink = Sink()
    load_text("t", (LINE % ("q1 200", "q1", "q1")).replace("wa 600", "wa 1 200"), sink)
    assert [d.code for d in sink.diagnostics if d.severity is Severity.ERROR] == ["IL1021"]


def test_names_of_ends_and_positions_may_have_spaces() -> None:
    text = """interlock: 1
name: demo
boundaries: {Ort A 1: {approach: 1 AT 600}, Ort B: {trains: out}}
tracks:
  im Westen: [Ort A 1, 9+000, Gleis Nord, 9+200, Gleis 2 0300, 9+500]
  im Osten: [Gleis 4 200, Ort B]
  Stumpf: [Gleis 5 100, Prellbock 1]
points:
  Weiche 1: {section: 3 T, toe: im Westen.end, normal: im Osten.start, reverse: Stumpf.start}
buffers: [Prellbock 1]
signals:
  Signal 1: {from: Ort A 1, into: Gleis Nord}
  Signal 2: {from: Gleis Nord, into: Gleis 2}
sections: {Gleis 4: {}, Gleis 5: {}}
"""
    sink = Sink()
    layout, _ = load_text("t", text, sink)
    assert layout is not None, sink.diagnostics
    assert {e.section: e.length for e in layout.track.edges if "." in e.id and e.id[-1].isdigit()} == {
        "Gleis Nord": 200.0,
        "Gleis 2": 300.0,
        "Gleis 4": 200.0,
        "Gleis 5": 100.0,
    }
    assert "section-Gleis\u00a0Nord" in plan_svg(layout)


def test_a_layout_with_spaces_is_certified_and_verified(tmp_path: Path) -> None:
    """The checker reads the layout with code of its own, and finds the same."""
    text = (
        (LINE % ("Gleis 1 200", "Gleis 1", "Gleis 1")).replace("q2", "2 T").replace("demo", "Halt 1").replace("X", "X ")
    )
    text = (
        text.replace("W:", "Ort W:").replace("[W", "[Ort W").replace("from: W", "from: Ort W").replace("wa ", "1 AT ")
    )
    path = tmp_path / "Halt 1.yaml"
    path.write_text(text, encoding="utf-8")
    found = check(path, certified(path, tmp_path))
    text_of_it = f"{portable('Halt 1')}.st"
    assert found.left == () and found.compared[1].startswith(f"{text_of_it} says") and " " not in text_of_it
    _, circuit = aiger_file(str(path))
    assert circuit is not None
    symbols = re.findall(rb"^[ilo][0-9]+ .*$", circuit, re.MULTILINE)
    assert len(symbols) > 50 and all(len(x.decode().replace(" first ", " ").split()) == 2 for x in symbols)


@pytest.mark.external
def test_the_report_opens_a_route_by_its_link(
    chromium: Any, made: tuple[Ready, dict[str, bytes]], tmp_path: Path
) -> None:
    from tests.browsers import shown
    from tests.test_browser import data_of

    path = tmp_path / "index.html"
    path.write_bytes(made[1]["index.html"])
    with shown(chromium, path) as page:
        page.goto(f"{path.as_uri()}#route=Signal%201%20W-Signal%2011%20P")
        page.reload()
        route = next(r for r in data_of(page)["routes"] if r["id"] == "Signal 1 W-Signal 11 P")
        lit = page.eval_on_selector_all("#plan .lit-path", "es => es.map(e => e.id)")
        assert sorted(lit) == sorted(f"edge-{e}".replace(" ", "\u00a0") for e in route["edges"]) and lit
        page.select_option("#route", "信号 9-Signal 11 N")
        assert page.url.endswith("%E4%BF%A1%E5%8F%B7%209-Signal%2011%20N")
        assert page.eval_on_selector_all("#plan .lit-entry", "es => es.map(e => e.id)") == ["signal-信号\u00a09"]


@pytest.mark.external
def test_the_panel_takes_names_with_spaces(chromium: Any, tmp_path: Path) -> None:
    from tests.pages import closing_pages, is_, opened, release_all, serving_process, typed
    from tests.panels import QUICK

    text = SPACES.read_text("utf-8").replace("principles: {shunt_release_s: 60}", QUICK.strip())
    (tmp_path / "spaces.yaml").write_text(text, "utf-8")
    with serving_process(tmp_path / "spaces.yaml") as server, closing_pages(chromium) as b:
        page, wrong = opened(b, server.url)
        release_all(page)
        page.wait_for_selector("#restart", state="hidden")
        typed(page, "Signal 11 P Strecke O")
        is_(page, "[id='signal-Signal\u00a011\u00a0P']", "clear")
        typed(page, "Lok 7:Strecke W>Gleis 1")
        page.wait_for_selector("#rest:has-text('Lok 7 is under way')")
        typed(page, "Signal 99")
        page.wait_for_selector("#said:has-text('nothing on the plan is called Signal 99')")
        assert wrong == []


@pytest.mark.external
def test_the_c_file_compiles(made: tuple[Ready, dict[str, bytes]], tmp_path: Path) -> None:
    from tests.test_c99 import built_by_gcc

    assert shutil.which("gcc")
    controller = made[0].controller
    assert controller is not None
    built_by_gcc(controller, runtime_c(controller, ["made for a test"]), tmp_path)


def test_a_name_that_says_its_kind_is_told_without_it(made: tuple[Ready, dict[str, bytes]]) -> None:
    """In lists of wires, in what the runtime says of a refused route, in what the panel shows."""
    files = made[1]
    channels, said = files["io/channels.csv"].decode(), files["runtime.py"].decode()
    assert "Signal 1 W: stop" in channels and "signal Signal 1 W: stop" not in channels
    assert "section 22 T reported clear" in channels
    assert "section 22 T is occupied" in said and "section Sperr" not in said
    assert sentence(names.CLEAR("section4"), False, Machines([], [], {})) == "section4 is occupied"
    assert (
        sentence(names.TRAILED("Points 2"), True, Machines([], [], {}))
        == "Points 2 were trailed: look at them, and confirm it"
    )
    report = files["index.html"].decode()
    assert "found from Signal" in report and "signal Signal" not in report


def test_names_in_one_cell_are_told_apart() -> None:
    assert beside(("AB", "BC")) == "AB BC" and beside(("22 T", "23 T")) == "22 T, 23 T"
