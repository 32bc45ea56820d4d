"""The report and the player in a real browser (Debian's Chromium, driven by Playwright), where one is installed."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner

from interlock.app.init import yard
from interlock.cli.main import cli
from interlock.derivation import derive
from interlock.diag import Sink
from interlock.emit.drawing import opening, plan_svg
from interlock.emit.report import BadTrace, player_html, report_html
from interlock.frontend import load_text
from interlock.model.elements import MachineId
from interlock.table.cells import ProviderKind
from interlock.table.columns import COLUMNS
from interlock.table.printed import Printed
from tests.browsers import crowding, shown
from tests.layouts import built


@pytest.fixture(scope="module")
def traces(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The counterexamples of every layout that the proof refutes."""
    folder = tmp_path_factory.mktemp("counterexamples")
    for path in sorted(Path("layouts/refuted").glob("*.yaml")):
        done = CliRunner().invoke(cli, ["prove", str(path), "--traces", str(folder)])
        assert done.exit_code == 1 and "to play it:" in done.output
    return folder


def test_every_refuted_claim_gets_a_trace_and_a_page_that_needs_nothing_else(traces: Path) -> None:
    pages = sorted(traces.glob("*.html"))
    assert {p.name.split("-")[0] for p in pages} == {p.stem for p in Path("layouts/refuted").glob("*.yaml")}
    for page in pages:
        text = page.read_text("utf-8")
        assert not re.search(r"(src|href)=[\"']?(https?:|//)", text) and "This violates" in text
        trace = json.loads(page.with_suffix(".itf.json").read_text("utf-8"))
        assert trace["#meta"]["format"] == "ITF"
        assert all(set(s) == {"#meta", *trace["vars"]} for s in trace["states"])
        assert player_html(page.with_suffix(".itf.json").read_text("utf-8")) == text


@pytest.mark.parametrize("text", ["", "[]", "{}", '{"#meta": {}, "vars": [], "states": []}', '{"#meta": 1}'])
def test_what_is_no_trace_is_told(text: str, tmp_path_factory: pytest.TempPathFactory) -> None:
    with pytest.raises(BadTrace):
        player_html(text)
    path = tmp_path_factory.mktemp("play") / "x.itf.json"
    path.write_text(text)
    done = CliRunner().invoke(cli, ["play", str(path)])
    assert (done.exit_code == 1 and "not an ITF trace" in done.output) or "no states" in done.output
    assert CliRunner().invoke(cli, ["play", "nowhere.json"]).exit_code == 1


def test_a_trace_cannot_bring_a_script_along(traces: Path) -> None:
    trace = json.loads(next(iter(traces.glob("*.itf.json"))).read_text("utf-8"))
    trace["states"][0]["#meta"]["text"] = "</script><script>alert(1)</script>"
    page = player_html(json.dumps(trace))
    assert "<script>alert" not in page
    trace["#meta"]["plan"] = "<svg><SCRIPT>alert(1)</SCRIPT></svg>"
    with pytest.raises(BadTrace):
        player_html(json.dumps(trace))


@pytest.fixture(scope="module")
def reports(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The report pages of three layouts as they are now, with what their committed proofs say: nothing is proved anew
    for a look at a page."""
    folder = tmp_path_factory.mktemp("reports")
    for name in ("heishan", "cn6502", "mine11"):
        layout, table, _ = built(name)
        made = Path("generated") / name
        files = {str(p.relative_to(made)): p.read_bytes() for p in sorted(made.rglob("*")) if p.is_file()}
        told = json.loads(files["proof.json"])
        texts = [(file, said.startswith("PROVED")) for file, said in told["text"].items()]
        page = report_html(layout, table, plan_svg(layout), told["claims"], texts, told["assumptions"], files, "")
        (folder / name).mkdir()
        (folder / name / "index.html").write_text(page, "utf-8")
    return folder


def data_of(page: Any) -> dict[str, Any]:
    """The data of a report, with what its script puts together for each route."""
    return json.loads(page.evaluate("JSON.stringify(data)"))


def large_report(folder: Path) -> tuple[Path, int]:
    """The report of a yard of a thousand routes, without its proof, and how many rows its table has."""
    sink = Sink()
    layout, _ = load_text("yard.yaml", yard(124), sink)
    assert layout is not None
    table = derive(layout, sink)
    page = folder / "large.html"
    page.write_text(report_html(layout, table, plan_svg(layout), [], [], {}, {}, "NOT PROVED"), "utf-8")
    return page, len(Printed(table).all)


@pytest.mark.parametrize("name", ["heishan", "cn6502", "mine11"])
@pytest.mark.external
def test_a_chosen_route_lights_up_on_plan_and_table(chromium: Any, reports: Path, name: str) -> None:
    with shown(chromium, reports / name / "index.html") as page:
        data = data_of(page)
        for i in (0, len(data["routes"]) // 2, len(data["routes"]) - 1):
            r = data["routes"][i]
            page.select_option("#route", r["id"])
            lit = page.eval_on_selector_all("#plan .lit-path", "es => es.map(e => e.id)")
            assert sorted(lit) == sorted(f"edge-{e}" for e in r["edges"])
            over = page.eval_on_selector_all("#plan .lit-overlap", "es => es.map(e => e.id)")
            assert sorted(over) == sorted({f"edge-{e}" for e in r["over"]})
            assert page.locator("#routes tr.chosen").count() == 1
            assert page.locator("#routes tr.hostile").count() == len(
                {data["routes"][k]["row"] for k, _ in r["against"]}
            )
            assert r["id"] in page.inner_text("#why")
        page.keyboard.press("Escape")
        assert page.locator("#plan .lit-path").count() == 0


@pytest.mark.parametrize("name", ["crossing_line", "depot", "flank_lab", "slip_junction"])
@pytest.mark.external
def test_a_chosen_route_lights_up_what_it_needs_beside_its_way(chromium: Any, tmp_path: Path, name: str) -> None:
    """Devices, ends of track and boundaries that protect, sections that must be clear, and how points must lie."""
    layout, table, _ = built(name)
    (tmp_path / "x.html").write_text(report_html(layout, table, plan_svg(layout), [], [], {}, {}, ""), "utf-8")
    seen: set[str] = set()
    with shown(chromium, tmp_path / "x.html") as page:
        for r in table.routes:
            page.select_option("#route", r.id)
            lit = "e => e.map(x => x.id.replaceAll('\\u00a0', ' ').replace(/^[a-z]+-/, ''))"
            devices = {p.machine for p in r.locking.points if p.machine in layout.machines.device}
            assert set(page.eval_on_selector_all("#plan .lit-device", lit)) == devices, r.id
            assert all(f"{d} closed" in page.inner_text("#why") for d in devices), r.id
            foul = {c.section for c in r.clear.foul} | {c.name for c in r.clear.space if not c.lamp}
            assert set(page.eval_on_selector_all("#plan .lit-foul", lit)) == foul, r.id
            protects = [p for c in r.locking.flank for p in c.providers]
            flank = set(page.eval_on_selector_all("#plan .lit-flank", lit))
            named = page.eval_on_selector_all("#plan text.point", "e => e.map(x => x.textContent)")
            for p in protects:
                if p.kind in (ProviderKind.SIGNAL, ProviderKind.BUFFER, ProviderKind.BOUNDARY):
                    assert p.name in flank, (r.id, p)
                elif p.kind is ProviderKind.POINT and p.position is not None:
                    ends = layout.machines.ends[MachineId(p.name)]
                    word = {"normal": "N", "reverse": "R"}
                    said = layout.machines.word(ends[0].machine, p.position)
                    assert {e.id for e in ends} <= flank, (r.id, p)
                    assert any(t in {f"{e.id}\u00a0{word.get(said, said)}" for e in ends} for t in named), (r.id, named)
                seen.add(str(p.kind))
            seen |= {"device"} if devices else set()
            seen |= {"foul"} if foul else set()
        page.keyboard.press("Escape")
        assert page.locator("#plan .lies, #plan .lit-foul, #plan .lit-device, #plan .lit-flank").count() == 0
    assert seen >= {
        "crossing_line": {"device"},
        "depot": {"device", "point"},
        "flank_lab": {"point", "end of track"},
    }.get(name, {"signal", "point"})


@pytest.mark.external
def test_the_table_is_filtered_and_tells_reasons_and_works_by_keyboard(chromium: Any, reports: Path) -> None:
    with shown(chromium, reports / "cn6502" / "index.html") as page:
        everything = page.locator("#routes tr:visible").count()
        page.select_option("#kind", "shunt")
        shunts = page.locator("#routes tr:visible").count()
        assert 0 < shunts < everything and f"{shunts} of {everything}" in page.inner_text("#shown")
        page.select_option("#over", "5DG")
        assert page.locator("#routes tr:visible").count() < shunts
        page.select_option("#kind", "")
        page.select_option("#over", "")
        page.fill("#text", "nothing like this")
        assert page.locator("#routes tr:visible").count() == 0
        page.fill("#text", "")
        page.locator("#routes button[data-why]").nth(8).click()
        assert re.match(r"R\d+", page.inner_text("#why"))
        page.locator("#routes button[data-hostile]").first.click()
        assert page.inner_text("#why").startswith("Hostile to")
        page.locator("#routes tr").first.focus()
        page.keyboard.press("ArrowDown")
        page.keyboard.press("Enter")
        assert page.locator("#routes tr.chosen").count() == 1
        assert page.evaluate("document.activeElement === document.querySelectorAll('#routes tr')[1]")
        spot = page.evaluate(
            "(() => { const e = document.querySelector('#section-IAG .track'); "
            "e.scrollIntoView({ block: 'center' }); const b = e.getBoundingClientRect(); "
            "return [b.x + b.width / 2, b.y + b.height / 2 + 4]; })()"
        )
        page.mouse.click(*spot)  # a finger's breadth beside the line will do
        assert page.input_value("#over") == "IAG"


@pytest.mark.external
def test_a_route_has_its_own_link_and_its_reasons_stand_where_one_looks(chromium: Any, reports: Path) -> None:
    with shown(chromium, reports / "cn6502" / "index.html") as page:
        data = data_of(page)
        one, two = data["routes"][3]["id"], data["routes"][7]["id"]
        fits = "(() => { const p = document.getElementById('plan'); return p.scrollWidth <= p.clientWidth; })()"
        assert page.evaluate(fits)
        page.select_option("#route", one)
        assert page.evaluate("decodeURIComponent(location.hash)") == f"#route={one}"
        page.evaluate(f"location.hash = 'route=' + encodeURIComponent({json.dumps(two)})")
        page.wait_for_function(f"document.getElementById('route').value === {json.dumps(two)}")
        page.reload()
        assert page.input_value("#route") == two and page.locator("#plan .lit-path").count() > 0
        for _ in range(3):
            page.click("#larger")
        assert not page.evaluate(fits)
        seen = page.evaluate(
            "(() => { const f = document.getElementById('plan').getBoundingClientRect(); "
            "return [...document.querySelectorAll('#plan .lit-path')].some(e => { const b = e.getBoundingClientRect(); "
            "return b.right > f.left && b.left < f.right && b.bottom > f.top && b.top < f.bottom; }); })()"
        )
        assert seen
        page.click("#fit")
        assert page.evaluate(fits)
        button = page.locator("#routes tr:visible button[data-why]").nth(8)
        button.click()
        box, tip = button.bounding_box(), page.locator("#tip").bounding_box()
        below, above = tip["y"] - box["y"] - box["height"], box["y"] - tip["y"] - tip["height"]
        assert min(abs(below), abs(above)) < 40 and page.inner_text("#tip") == page.inner_text("#why")
        page.keyboard.press("Escape")
        assert not page.locator("#tip").is_visible() and page.evaluate("location.hash") == ""
        page.fill("#text", one)
        assert 0 < page.locator("#routes tr:visible").count() < len(data["routes"]) / 2


@pytest.mark.external
def test_the_report_works_on_a_phone(chromium: Any, reports: Path) -> None:
    with shown(chromium, reports / "cn6502" / "index.html") as page:
        page.set_viewport_size({"width": 390, "height": 800})
        page.reload()
        assert page.evaluate("document.documentElement.scrollWidth") <= 392
        assert page.evaluate("document.querySelector('#plan svg').getBoundingClientRect().width") <= 390
        page.locator("#routes button[data-why]").first.click()
        tip = page.locator("#tip").bounding_box()
        assert tip["x"] >= 0 and tip["x"] + tip["width"] <= 390


@pytest.mark.external
def test_a_table_that_fits_on_the_screen_is_not_cut_in_a_window_of_its_own(chromium: Any, reports: Path) -> None:
    with shown(chromium, reports / "heishan" / "index.html") as page:
        for height, whole in ((1800, True), (300, False)):
            page.set_viewport_size({"width": 1280, "height": height})
            box = "document.querySelector('#table .scroll')"
            assert (page.evaluate(f"{box}.scrollHeight - {box}.clientHeight") <= 1) == whole


@pytest.mark.external
@pytest.mark.parametrize("width", [1280, 400])
def test_the_names_of_claims_are_not_broken(chromium: Any, reports: Path, width: int) -> None:
    lines = "e => { const r = document.createRange(); r.selectNodeContents(e); return r.getClientRects().length; }"
    with shown(chromium, reports / "mine11" / "index.html") as page:
        page.set_viewport_size({"width": width, "height": 900})
        names = page.query_selector_all("#proof tbody td:first-child")
        assert len(names) > 40 and {n.evaluate(lines) for n in names} == {1}
        assert page.evaluate("document.documentElement.scrollWidth") <= width


@pytest.mark.external
def test_the_report_prints_on_a3(chromium: Any, reports: Path, tmp_path_factory: pytest.TempPathFactory) -> None:
    with shown(chromium, reports / "heishan" / "index.html") as page:
        data = page.pdf(prefer_css_page_size=True)
    assert data.startswith(b"%PDF") and len(data) > 20_000
    box = re.search(rb"/MediaBox\s*\[\s*0\s+0\s+([\d.]+)\s+([\d.]+)", data)
    if box is not None:  # A3 landscape in points
        assert abs(float(box[1]) - 1190.6) < 3 and abs(float(box[2]) - 841.9) < 3


@pytest.mark.external
def test_in_print_nothing_lies_over_anything_and_nothing_is_cut_off(chromium: Any, reports: Path) -> None:
    with shown(chromium, reports / "cn6502" / "index.html") as page:
        page.emulate_media(media="print")
        boxes = page.evaluate(
            "[...document.querySelectorAll('table')].map(t => [t.getBoundingClientRect().bottom, "
            "t.closest('.scroll, section').getBoundingClientRect().bottom, t.getBoundingClientRect().right])"
        )
        assert len(boxes) > 4
        for bottom, room, right in boxes:
            assert bottom <= room + 1 and right <= 1500


@pytest.mark.external
def test_names_are_no_wider_in_the_browser_than_the_plan_reckons(chromium: Any) -> None:
    for name in ("cn6502", "pit_bottom", "depot"):
        with shown(chromium, Path(f"generated/{name}/plan.svg")) as page:
            boxes = page.evaluate(
                "[...document.querySelectorAll('text:not(.title)')].map(t => "
                "{ const b = t.getBBox(); return [t.textContent, b.x, b.y, b.x + b.width, b.y + b.height]; })"
            )
        for i, (s, *a) in enumerate(boxes):
            for t, *b in boxes[i + 1 :]:
                wide = min(a[2], b[2]) - max(a[0], b[0])
                high = min(a[3], b[3]) - max(a[1], b[1])
                assert wide <= 1.5 or high <= 4, (name, s, t)


@pytest.mark.external
def test_a_counterexample_is_stepped_through(chromium: Any, traces: Path) -> None:
    for path in sorted(traces.glob("*.html")):
        with shown(chromium, path) as page:
            steps = page.locator("#steps li").count()
            assert page.inner_text("#said").startswith(f"1 of {steps}: Restart")
            seen_train = seen_proceed = False
            for k in range(1, steps):
                page.click("#on")
                assert page.inner_text("#said").startswith(f"{k + 1} of {steps}")
                seen_train |= page.locator("#plan .train").count() > 0
                seen_proceed |= page.locator("#plan .signal[data-now~=proceed]").count() > 0
            assert seen_proceed and (seen_train or "-S-" in path.name)
            assert "This violates" in page.inner_text("#said")
            page.keyboard.press("Home")
            assert page.input_value("#slider") == "0"
            page.keyboard.press("ArrowRight")
            assert page.input_value("#slider") == "1"
            page.locator("#steps li").last.click()
            assert page.input_value("#slider") == str(steps - 1)


@pytest.mark.external
def test_a_yard_of_a_thousand_routes_stays_usable(chromium: Any, tmp_path_factory: pytest.TempPathFactory) -> None:
    path, count = large_report(tmp_path_factory.mktemp("large"))
    assert count == 996 and path.stat().st_size < 4_000_000
    with shown(chromium, path) as page:
        assert page.locator("#routes tr").count() == count
        spent = page.evaluate(
            "(() => { const t = performance.now(); const s = document.getElementById('route'); "
            "s.selectedIndex = 500; s.dispatchEvent(new Event('change')); return performance.now() - t; })()"
        )
        assert spent < 2000 * crowding()
        assert page.locator("#plan .lit-path").count() > 3
        assert page.locator("canvas.heat").count() == 1
        frame = page.locator("#plan").bounding_box()
        lit = page.eval_on_selector_all(
            "#plan .lit-path", "es => es.map(e => e.getBoundingClientRect()).map(b => [b.left, b.right])"
        )
        wide = max(right for _, right in lit) - min(left for left, _ in lit)
        assert 0.5 * frame["width"] < wide < frame["width"], "the plan comes as near as the route fills its frame"
        page.locator("#routes tr.chosen").scroll_into_view_if_needed()
        page.wait_for_function("!document.querySelector('#routes tr.chosen [data-why]:not(button)')")  # has its height
        page.locator("#routes tr.chosen button[data-hostile]").first.click()
        told, count = page.inner_text("#why"), page.evaluate("data.routes[chosen].against.length")
        assert told.startswith("Hostile to ") and told.count("(") < count / 3, "what is hostile in one way is told once"


@pytest.mark.external
def test_each_overlap_of_a_printed_row_can_be_chosen(chromium: Any, tmp_path: Path) -> None:
    sink = Sink()
    text = Path("tests/layouts_for_tests/entry_speeds.yaml").read_text("utf-8")
    layout, _ = load_text("speeds.yaml", text, sink)
    assert layout is not None
    path = tmp_path / "speeds.html"
    path.write_text(report_html(layout, derive(layout, sink), plan_svg(layout), [], [], {}, {}, ""), "utf-8")
    with shown(chromium, path) as page:
        assert page.locator("#routes tr").count() == 5 and "5 of 5 routes" in page.inner_text("#shown")
        row = page.locator("#routes tr", has=page.locator("button.of")).first
        for mark, track in (("o2", "edge-drag"), ("o1", "edge-east")):
            row.locator("button.of", has_text=mark).first.click()
            lit = page.eval_on_selector_all("#plan .lit-overlap", "es => es.map(e => e.id)")
            assert any(x.startswith(track) for x in lit), (mark, lit)
            assert page.input_value("#route") == ("X2-X3.o2" if mark == "o2" else "X2-X3")
            assert row.locator("button.of[aria-pressed]").first.inner_text() == mark


@pytest.mark.external
def test_the_page_names_every_hostile_route_of_the_table(chromium: Any, tmp_path: Path) -> None:
    """The page has each group of them once, with routes in a row as their ends."""
    sink = Sink()
    layout, _ = load_text("yard.yaml", yard(8), sink)
    assert layout is not None
    table = derive(layout, sink)
    path = tmp_path / "yard.html"
    path.write_text(report_html(layout, table, plan_svg(layout), [], [], {}, {}, ""), "utf-8")
    with shown(chromium, path) as page:
        told = page.evaluate(
            "data.routes.map((r) => r.against.map(([k, how]) => [data.routes[k].id, ...data.hows[how]]))"
        )
        for row, those in zip(table.routes, told, strict=True):
            assert sorted(map(tuple, those)) == sorted(
                (h.route, str(h.kind), h.how.witness) for h in row.locking.hostile
            )
        row = page.locator("#routes tr").nth(3)
        row.scroll_into_view_if_needed()
        seen = row.locator("button[data-why]").evaluate_all(
            "bs => bs.map(b => [b.textContent, data.reasons[b.dataset.why]])"
        )
        way = Printed(table).all[3]
        items = [(t, b) for c in COLUMNS if c.key != "hostile" for p in c.parts(way) for t, b in p.items]
        assert [(t.removesuffix(","), why) for t, why in seen] == [(t, f"{b.rule}: {b.text}") for t, b in items]


@pytest.mark.external
def test_a_large_plan_opens_where_its_lines_come_in(chromium: Any, tmp_path: Path) -> None:
    layout, _ = load_text("yard.yaml", yard(30), Sink())
    assert layout is not None
    path = tmp_path / "plan.svg"
    path.write_text(opening(plan_svg(layout)), "utf-8")
    with shown(chromium, path) as page:
        page.wait_for_function("scrollY > 0")
        for b in ("W1", "W2"):
            box = page.evaluate(
                f"(e => [e.left, e.top])(document.getElementById('boundary-{b}').getBoundingClientRect())"
            )
            assert 0 <= box[0] <= 1500 and 300 <= box[1] <= 700, (b, box)


BROKEN = """() => {
    const found = [], r = document.createRange();
    for (const td of document.querySelectorAll(".form td")) {
        const all = document.createTreeWalker(td, NodeFilter.SHOW_TEXT);
        let text = "", spots = [];
        for (let n; (n = all.nextNode()); text += n.data)
            for (let k = 0; k < n.data.length; k++) spots.push([n, k]);
        for (const m of text.matchAll(/[^\\s、，；,;]+/g)) {
            const [a, b] = [spots[m.index], spots[m.index + m[0].length - 1]];
            r.setStart(a[0], a[1]); r.setEnd(b[0], b[1] + 1);
            if (new Set([...r.getClientRects()].map(x => Math.round(x.top))).size > 1) found.push(m[0]);
        }
    }
    return found;
}"""
"""The names and words in the cells of forms that stand on two lines."""


@pytest.mark.external
def test_no_name_in_a_national_form_is_broken(chromium: Any, tmp_path: Path) -> None:
    """`17-` stood at the end of a line and `23DG` in the next, and the last character of a track's name by itself."""
    layout, table, _ = built("cn6502")
    path = tmp_path / "cn6502.html"
    path.write_text(report_html(layout, table, plan_svg(layout), [], [], {}, {}, ""), "utf-8")
    with shown(chromium, path) as page:
        for media, width in (("screen", 1500), ("screen", 1100), ("print", 1500)):
            page.emulate_media(media=media)
            page.set_viewport_size({"width": width, "height": 900})
            assert page.locator(".form .scroll tbody tr").count() == 58
            assert page.evaluate(BROKEN) == [], (media, width)
