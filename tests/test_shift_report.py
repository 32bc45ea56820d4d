"""The report of a shift against its record; the graph; the replay of a span."""

from __future__ import annotations

import csv
import json
import re
from dataclasses import replace
from functools import lru_cache
from itertools import pairwise
from pathlib import Path
from xml.etree import ElementTree

import pytest
from click.testing import CliRunner, Result

from interlock.app.replaying import trace
from interlock.app.shifts import one
from interlock.app.worked import Options, Worked
from interlock.cli.play import command as play
from interlock.cli.record import command as record
from interlock.record import Recorded, read
from interlock.record.graph import MOST_LINES, graph_svg
from interlock.record.log import LATEST_MS
from interlock.record.report import shift_html
from interlock.record.shift import LOADS, TIPS, NoShift, figures, to_csv
from interlock.simulate.mishaps import TRIAL
from tests.layouts import built


@lru_cache
def shift() -> tuple[Worked, Recorded]:
    w = one("layouts/heishan.yaml", None, 5, Options(faults=TRIAL))
    return w, read(w.log)


def test_every_second_of_every_train_is_accounted_for() -> None:
    w, r = shift()
    f = figures(r.events)
    assert f.seconds == w.seconds == 8 * 3600 and set(f.states) == {"1", "2", "3", "4"}
    for of in f.states.values():
        assert sum(of.values()) == pytest.approx(f.seconds, abs=1e-6)
    assert f.trains == w.tipped and f.tonnes == pytest.approx(w.tonnes)
    assert (
        len(f.alarms) == len(w.alarms) > 0
        and f.requests.held_back == w.delays.refused
        and not f.hazards
        and not f.standstill
    )
    at_work = sum(of.get(LOADS, 0.0) + of.get(TIPS, 0.0) for of in f.states.values())
    assert sum(f.places.values()) == pytest.approx(at_work)
    loads = [e["t"] for e in r.events if e["kind"] == "loads"]
    assert sum(f.utilisation(p) for p in ("c1", "c2", "c3", "c4", "c5")) * f.seconds <= 1.4 * 1200 * len(loads)
    assert list(f.waiting.values()) == sorted(f.waiting.values(), reverse=True)


def test_the_table_and_the_page_say_the_same() -> None:
    w, r = shift()
    rows = list(csv.DictReader(to_csv(figures(r.events)).splitlines()))
    of = {(x["figure"], x["of"]): x["value"] for x in rows}
    assert int(of["trains tipped", "b"]) == w.tipped["b"] and int(of["alarms", ""]) == len(w.alarms)
    page = shift_html(r)
    assert f"<b>{w.trains}</b> trains tipped" in page and r.chain.digest in page and "breaks off" not in page
    for cause in figures(r.events).waiting:
        assert f"<td>{cause}</td>" in page
    assert "<script" not in page and "http" not in page.replace("http://www.w3.org/2000/svg", "")


def test_a_record_that_breaks_off_has_a_report_too() -> None:
    w, _ = shift()
    half = read(w.log[: len(w.log) // 2])
    f = figures(half.events)
    assert "breaks off" in shift_html(half) and 0 < f.seconds < 8 * 3600
    assert "held back" not in shift_html(half) and "\nrequests held back,,,\n" in to_csv(f), "told at the end alone"
    for of in f.states.values():
        assert sum(of.values()) == pytest.approx(f.seconds, abs=1e-6)
    with pytest.raises(NoShift):
        figures(half.events[1:])


@pytest.mark.parametrize("key", ["fleet", "seed", "metres", "layout_digest"])
def test_a_record_that_lacks_what_a_shift_writes_is_none(key: str) -> None:
    _, r = shift()
    heading = {k: v for k, v in r.events[0].items() if k != key}
    with pytest.raises(NoShift, match=key):
        shift_html(replace(r, events=(heading, *r.events[1:])))


def test_the_graph_has_a_line_for_each_train_that_never_goes_back_in_time() -> None:
    _, r = shift()
    root = ElementTree.fromstring(graph_svg(r.events))
    space = {"s": "http://www.w3.org/2000/svg"}
    trains = root.findall("s:g", space)
    titles = [g.findtext("s:title", namespaces=space) for g in trains]
    assert titles == ["train 1", "train 2", "train 3", "train 4"]
    box = [float(x) for x in root.attrib["viewBox"].split()]
    for g in trains:
        lines = [p for p in g.findall("s:path", space) if "stroke-width" not in p.attrib]
        last = 0.0
        for p in lines:
            spots = [tuple(map(float, x.split())) for x in re.split("[ML]", p.attrib["d"]) if x]
            assert [x for x, _ in spots] == sorted(x for x, _ in spots) and spots[0][0] >= last - 0.1
            last = spots[-1][0]
            assert all(0 <= x <= box[2] and 0 <= y <= box[3] for x, y in spots)
    loads = sum(e["kind"] == "loaded" for e in r.events)
    assert sum(p.attrib.get("stroke-width") == "5" for p in root.iter(f"{{{space['s']}}}path")) == loads


def test_the_legend_of_a_graph_is_whole_and_tells_every_train_apart() -> None:
    """Names stood on each other and beyond the edge, and the eleventh train looked like the first."""
    _, r = shift()
    entries = [e for e in r.events if e.get("train") == "1"]
    names = [f"loco{n}" for n in range(101, 124)]
    many = [{**e, "train": name} for e in entries for name in names]
    root = ElementTree.fromstring(graph_svg((r.events[0], *many, r.events[-1])))
    space = {"s": "http://www.w3.org/2000/svg"}
    width, height = (float(x) for x in root.attrib["viewBox"].split()[2:])
    legend = [t for t in root.iterfind("s:text", space) if t.get("class") == "legend"]
    assert [t.text for t in legend] == [f"train {name}" for name in names]
    spots = [(float(t.get("x", "nan")), float(t.get("y", "nan"))) for t in legend]
    assert all(x + 5.5 * len("train loco101") < width and y < height for x, y in spots)
    for (x, y), (u, v) in pairwise(spots):
        assert v > y + 10 or u > x + 5.5 * len("train loco101"), "none over another"
    looks = {(g.get("stroke"), g.get("stroke-dasharray")) for g in root.iterfind("s:g", space)}
    assert len(looks) == len(names)
    at_lines = [t for t in root.iterfind("s:text", space) if t.get("class") == "train"]
    assert {t.text for t in at_lines} == set(names), "each line has its name where it begins"


def test_the_graph_of_a_log_that_reaches_a_distant_year_is_no_larger() -> None:
    """A line was drawn every quarter of an hour, 277 million of them."""
    _, r = shift()
    far = graph_svg((*r.events[:-1], {**r.events[-1], "t": LATEST_MS}))
    width = float(ElementTree.fromstring(far).attrib["viewBox"].split()[2])
    assert MOST_LINES / 4 <= far.count(" V") <= MOST_LINES + 2 and width < 45_000
    assert ">0 h<" in far and ">1048576 h<" in far


def test_a_span_is_played_as_it_was() -> None:
    layout = built("heishan")[0]
    w = one("layouts/heishan.yaml", None, 1, Options(hours=24.0))
    events = read(w.log).events
    whole = json.loads(trace(layout, events, 0, 1e9))
    last = whole["states"][-1]
    assert not any(last[f"o.{s.id}"] for s in layout.track.sections if not s.approach), "all have gone home"
    part = json.loads(trace(layout, events, 3600, 7200))
    assert 50 < len(part["states"]) < len(whole["states"])
    assert [s["#meta"]["text"] for s in whole["states"] if "1:00:00" <= s["#meta"]["text"][:7] < "2:00:00"] == [
        s["#meta"]["text"] for s in part["states"]
    ]
    occupied = {k for k, v in part["states"][0].items() if k.startswith("o.") and v}
    assert occupied, "what stood there before the span is there"
    with pytest.raises(NoShift, match="nothing happened"):
        trace(layout, events, 1e8, 1e9)
    with pytest.raises(NoShift, match="interlock play LOG --journal"):
        figures([{"kind": "begin", "what": "panel"}])
    with pytest.raises(NoShift, match="no record of a shift on mine11"):
        trace(built("mine11")[0], events, 0, 1e9)


def test_the_commands(tmp_path: Path) -> None:
    w, _ = shift()
    log, other = tmp_path / "a.log", tmp_path / "rep"
    log.write_bytes(w.log)

    def run(command: object, *arguments: str) -> Result:
        done = CliRunner().invoke(command, arguments, catch_exceptions=False)  # type: ignore[arg-type]
        assert "Traceback" not in done.output
        return done

    assert run(record, str(log), "--report", str(other)).exit_code == 0
    assert run(record, str(log), "--report", str(other)).exit_code == 0, "what it wrote itself, it may write again"
    assert {p.name for p in other.iterdir()} == {"a.html", "a.csv", "a.svg"}
    (other / "a.csv").write_text("mine")
    assert run(record, str(log), "--report", str(other)).exit_code == 1
    done = run(play, str(log), "--layout", "layouts/heishan.yaml", "--from", "1:00", "--to", "1:30")
    assert done.exit_code == 0 and "comes into" in (tmp_path / "a.html").read_text("utf-8")
    assert run(play, str(log), "--layout", "layouts/heishan.yaml", "--from", "soon").exit_code == 2
    assert run(play, str(log), "--layout", "layouts/mine11.yaml").exit_code == 1
    back = run(play, str(log), "--layout", "layouts/heishan.yaml", "--from", "1:30", "--to", "1:00")
    assert back.exit_code == 1 and "--to 1:00 is before --from 1:30" in back.output
    assert run(play, str(log), "--layout", "layouts/heishan.yaml", "--journal").exit_code == 2
    assert "name its layout with --layout" in run(play, str(log)).output
    log.write_bytes(w.log.replace(b'"t":', b'"t": ', 1))
    done = run(play, str(log), "--layout", "layouts/heishan.yaml")
    assert done.exit_code == 1 and "[IL6011]" in done.output


def test_logs_whose_reports_would_have_one_name_are_refused_before_anything_is_written(tmp_path: Path) -> None:
    """The second report overwrote the first."""
    logs = [tmp_path / x / "heishan-0.log" for x in ("a", "b", "c")]
    logs[2] = logs[2].with_name("heishan-1.log")
    for log in logs:
        log.parent.mkdir()
        log.write_bytes(shift()[0].log)
    done = CliRunner().invoke(record, [*map(str, logs), "--report", str(tmp_path / "r")], catch_exceptions=False)
    assert done.exit_code == 1 and not (tmp_path / "r").exists()
    told = " ".join(done.output.split())
    assert f"{logs[0]} and {logs[1]} would both be reported as heishan-0" in told and str(logs[2]) not in told
    assert CliRunner().invoke(record, [*map(str, logs[1:]), "--report", str(tmp_path / "r")]).exit_code == 0
    assert sorted(f.name for f in (tmp_path / "r").glob("*.csv")) == ["heishan-0.csv", "heishan-1.csv"]
