"""What the player shows of points and devices, and when: nothing that is not detected looks as if it were."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

import pytest

from interlock.emit.drawing import plan_svg
from interlock.emit.report import BadTrace, player_html, report_html
from interlock.model.elements import Position
from interlock.model.layout import Layout
from interlock.model.machines import shown_by
from interlock.model.traversal import topology
from interlock.panel.journal import TOGETHER_MS, trace
from interlock.record.log import Chain, Recorded, read_file
from tests.browsers import shown
from tests.layouts import built, grown


def views(layout: Layout) -> dict[str, list[list[str]]]:
    """A variable for each position of each machine."""
    return {f"{m}.{x}": shown_by(layout.machines, m, x) for m in layout.machines for x in Position}


def played(layout: Layout, states: list[tuple[str, set[str]]]) -> str:
    """The page of a trace of positions."""
    names = sorted(views(layout))
    those = [{"#meta": {"text": text}, **{n: n in on for n in names}} for text, on in states]
    meta = {"plan": plan_svg(layout), "views": views(layout)}
    return player_html(json.dumps({"#meta": meta, "vars": names, "states": those}))


@pytest.mark.external
def test_what_is_not_detected_is_marked_and_each_position_has_its_own_word_and_look(
    chromium: Any, tmp_path: Path
) -> None:
    layout, _, _ = built("crossing_line")
    crossing = next(m for m in layout.machines if m in layout.machines.device)
    point = next(p for p in layout.pointwork.points)
    lie = {f"{m}.N" for m in layout.machines}
    closed = lie - {f"{crossing}.N"} | {f"{crossing}.R"}
    moving = lie - {f"{crossing}.N", f"{point.machine}.N"}
    path = tmp_path / "play.html"
    path.write_text(played(layout, [("open", lie), ("both move", moving), ("closed", closed)]), "utf-8")
    looks = []
    with shown(chromium, path) as page:
        for step in range(3):
            page.evaluate(f"show({step})")
            marks = f"#device-{crossing} .mark"
            looks.append(
                (
                    page.locator(f"#device-{crossing} .lost").count(),
                    page.locator(f"#point-{point.id} .lost").count(),
                    page.eval_on_selector(
                        marks, "e => { const s = getComputedStyle(e); return s.stroke + s.strokeWidth }"
                    ),
                    page.inner_text("#changes"),
                )
            )
        assert page.locator("#devices").is_visible()
    assert [x[:2] for x in looks] == [(0, 0), (1, 1), (0, 0)]
    assert len({x[2] for x in looks}) == 3, "open, moving and closed are told apart"
    assert f"{crossing} not detected" in looks[1][3] and f"{crossing} no longer open" in looks[1][3]
    assert f"{crossing} closed" in looks[2][3] and "reverse" not in looks[2][3] and "not detected" not in looks[2][3]


def test_a_variable_that_a_trace_does_not_have_says_nothing_of_a_point() -> None:
    """A counterexample has the variables of its neighbourhood alone; of other points nothing is known."""
    layout, _, _ = built("junction")
    meta = {"plan": plan_svg(layout), "views": views(layout)}
    page = player_html(json.dumps({"#meta": meta, "vars": [], "states": [{"#meta": {"text": "x"}}]}))
    data = re.search(r'<script type="application/json" id="data">(.*?)</script>', page)
    assert data is not None and json.loads(data[1])["views"] == {}


def recorded(path: Path, events: list[tuple[float, str, dict[str, Any]]]) -> Recorded:
    """A panel's record, with seconds after noon."""
    chain, noon = Chain(), 1_772_539_200_000
    begin: dict[str, Any] = {
        "title": "a",
        "program": "b",
        "digest": "c",
        "plan": "<svg></svg>",
        "views": {"x": [["point", "P", "N"]]},
    }
    lines = [chain.line(round(noon + 1000 * t), kind, x) for t, kind, x in [(0, "begin", begin), *events]]
    path.write_bytes(b"".join(lines))
    return read_file(path)


def test_every_sentence_of_a_record_has_its_own_time(tmp_path: Path) -> None:
    whole = {"on": ["x"], "off": [], "whole": True}
    found = recorded(
        tmp_path / "a.log",
        [
            (0, "picture", whole),
            (10, "refusal", {"text": "route A-B is refused"}),
            (40, "operation", {"text": "points P reverse"}),
            (40 + TOGETHER_MS / 1000, "picture", {"on": [], "off": ["x"], "whole": False}),
            (50, "alarm", {"text": "P is late"}),
            (51, "note", {"text": "called"}),
        ],
    )
    states = json.loads(trace(found))["states"]
    told = [re.sub(r"\b\d\d:\d\d:(\d\d)\b", r"\1", s["#meta"]["text"]) for s in states]
    assert told == [
        "00  begin",
        "10  route A-B is refused",
        "40  points P reverse; 42  the plan changes",
        "50  P is late; 51  called",
    ]
    assert [s["x"] for s in states] == [True, True, False, False], "what is said before the plan changes is shown so"


@pytest.mark.external
@pytest.mark.parametrize("name", ["slip_junction", "terminus_slip"])
def test_a_way_over_a_slip_rail_is_shown_where_trains_run(chromium: Any, tmp_path: Path, name: str) -> None:
    """In the report and in the player: the rail and its legs up to the blades, not the middle of the diamond."""
    layout, table, _ = built(name)
    topo = topology(layout)
    (tmp_path / "report.html").write_text(report_html(layout, table, plan_svg(layout), [], [], {}, {}, ""), "utf-8")
    slipped = 0
    with shown(chromium, tmp_path / "report.html") as page:
        rails = page.eval_on_selector_all("#plan .rail[data-from]", "e => e.map(x => [x.id, {...x.dataset}])")
        assert rails
        for r in table.routes:
            page.select_option("#route", r.id)
            lit = set(page.eval_on_selector_all("#plan .lit-path", "e => e.map(x => x.id)"))
            seen = "e => e.filter(x => getComputedStyle(x).display !== 'none').map(x => x.id)"
            arms = set(page.eval_on_selector_all("#plan .arm", seen))
            wanted: set[str] = set()
            for s, n in (key for p in table.parts(r) for key in p.path.traversals):
                edges = {str(e) for e in topo.traversals[s][n - 1].edges}
                rail = next((x for x in rails if {x[1]["from"], x[1]["to"]} <= edges), None)
                slipped += rail is not None
                if rail is not None:
                    edges -= {rail[1]["from"], rail[1]["to"], rail[1]["past"]}
                    wanted |= {rail[0], f"arm-{rail[1]['from']}", f"arm-{rail[1]['to']}"}
                wanted |= {f"edge-{e}" for e in edges}
            over = set(page.eval_on_selector_all("#plan .lit-overlap", "e => e.map(x => x.id)"))
            assert lit == wanted, r.id
            assert arms == {x for x in lit | over if x.startswith("arm-")}, r.id
        page.keyboard.press("Escape")
        assert page.eval_on_selector_all("#plan .arm", seen) == []
    assert slipped
    from_, to, past = (rails[0][1][k] for k in ("from", "to", "past"))
    views_ = {"slip": [["edge", e, "locked"] for e in (from_, past, to)], "straight": [["edge", from_, "locked"]]}
    states = [{"#meta": {"text": n}, **{m: m == n for m in views_}} for n in ("slip", "straight")]
    trace_ = {"#meta": {"plan": plan_svg(layout), "views": views_}, "vars": sorted(views_), "states": states}
    (tmp_path / "play.html").write_text(player_html(json.dumps(trace_)), "utf-8")
    with shown(chromium, tmp_path / "play.html") as page:
        for step, those in enumerate(({rails[0][0], f"arm-{from_}", f"arm-{to}"}, {f"edge-{from_}"})):
            page.evaluate(f"show({step})")
            assert set(page.eval_on_selector_all("#plan [data-now~=locked]", "e => e.map(x => x.id)")) == those
            arms = set(page.eval_on_selector_all("#plan .arm", seen))
            assert arms == {x for x in those if x.startswith("arm-")}


@pytest.mark.external
def test_a_door_is_open_only_where_it_is_detected_so(chromium: Any, tmp_path: Path) -> None:
    """Its leaf goes; where nothing is detected it is framed, and in the report it is open for the route over it."""
    text = Path("tests/layouts_for_tests/air_lock_doors.yaml").read_text("utf-8")
    made = grown(text)
    assert made is not None
    layout, table = made[0], made[1]
    shut = {f"{m}.N" for m in layout.machines}
    states = [("shut", shut), ("moves", shut - {"D1.N"}), ("open", shut - {"D1.N"} | {"D1.R"})]
    (tmp_path / "play.html").write_text(played(layout, states), "utf-8")
    with shown(chromium, tmp_path / "play.html") as page:
        leaf, frame = page.locator("#device-D1 .leaf"), page.locator("#device-D1 .lost")
        seen = []
        for step in range(3):
            page.evaluate(f"show({step})")
            seen.append((leaf.is_visible(), frame.count(), page.inner_text("#changes")))
    assert [x[:2] for x in seen] == [(True, 0), (False, 1), (False, 0)] and seen[2][2] == "D1 open"
    (tmp_path / "report.html").write_text(report_html(layout, table, plan_svg(layout), [], [], {}, {}, ""), "utf-8")
    with shown(chromium, tmp_path / "report.html") as page:
        route = next(r.id for r in table.routes if any(p.machine == "D1" for p in r.locking.points))
        assert page.locator("#device-D1 .leaf").is_visible()
        page.select_option("#route", route)
        assert not page.locator("#device-D1 .leaf").is_visible() and "D1 open" in page.inner_text("#why")
        page.keyboard.press("Escape")
        assert page.locator("#device-D1 .leaf").is_visible()


BROUGHT = {
    "what runs when it is loaded": ("<svg ", '<svg onload="alert(1)" '),
    "what runs when it is clicked": ('role="img"', 'role="img" OnClick="alert(1)"'),
    "a picture from elsewhere": ("</svg>", '<image href="https://example.org/x.png"/></svg>'),
    "a page in the plan": ("</svg>", "<foreignObject><iframe srcdoc='x'/></foreignObject></svg>"),
    "what changes an attribute": ("</svg>", '<set attributeName="href" to="javascript:alert(1)"/></svg>'),
    "a link": ("</svg>", '<a href="javascript:alert(1)"><text>A</text></a></svg>'),
    "a script of another name space": ("</svg>", '<x:script xmlns:x="http://www.w3.org/1999/xhtml">1</x:script></svg>'),
    "what follows the plan": ("</svg>", "</svg><img src=x onerror=alert(1)>"),
    "what follows it within its element": ("</svg>", "</svg></div><p>VERIFIED</p>"),
    "a comment that ends sooner than it seems": ("</svg>", "<!--><img src=x onerror=alert(1)>--></svg>"),
    "text that is none to a page": ("</svg>", "<title><![CDATA[<img src=x onerror=alert(1)>]]></title></svg>"),
    "a style sheet from elsewhere": ("</style>", "@import 'https://example.org/x.css';</style>"),
    "a picture from elsewhere in a style": ("</style>", ".plan { background: url(https://example.org/x.png) }</style>"),
    "the same, disguised": ("</style>", ".plan { background: u\\72l(https://example.org/x.png) }</style>"),
    "a colour from elsewhere": ('fill="#fff"/>', 'fill="url(https://example.org/x.svg#a)"/>'),
}


@pytest.mark.parametrize("what", BROUGHT)
def test_a_trace_brings_a_drawing_along_and_nothing_else(what: str) -> None:
    """Traces and records come by mail: what stands in their plan must not run, nor load, in the reader's browser."""
    layout, _, _ = built("fig2_2")
    before, after = BROUGHT[what]
    plan = plan_svg(layout)
    assert before in plan
    body = {"#meta": {"plan": plan, "views": {}}, "vars": [], "states": [{"#meta": {"text": "1"}}]}
    assert "<svg" in player_html(json.dumps(body))
    body["#meta"]["plan"] = plan.replace(before, after, 1)  # type: ignore[index]
    with pytest.raises(BadTrace, match="its plan is no drawing"):
        player_html(json.dumps(body))
