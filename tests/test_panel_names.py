"""Who asked for what: the record names whoever did, and nobody else."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from interlock.app.run import Ready
from interlock.panel.desk import Desk
from interlock.panel.recorder import Recorder
from interlock.record.log import read_file
from tests.panels import flank_lab, in_cycles

SET: dict[str, Any] = {"do": "set", "route": "XB-XI7"}
RELEASED = 30
"""A cycle after the restart."""


def recorded(ready: Ready, path: Path, cycles: int, script: dict[int, Any]) -> tuple[list[tuple[str, str, str]], Any]:
    """Kind, who and text of what a record says of routes, and what people were answered."""
    desk = Desk(ready, None, 100, Recorder(path, ready))
    answers = in_cycles(desk, cycles, {RELEASED: [("Ann", {"do": "release all"})], **script})
    events = read_file(path).events
    return [(e["kind"], e["who"], e["text"]) for e in events if "route" in e.get("text", "")], answers


def test_who_repeats_a_request_in_time_is_named_with_it(ready: Ready, tmp_path: Path) -> None:
    both = {40: [("Ann", SET), ("Bob", SET), ("Ann", SET)]}
    said, _ = recorded(ready, tmp_path / "x.log", 60, both)
    assert said == [("operation", "Ann, Bob", "route XB-XI7 is set")]


def test_who_repeats_a_request_that_is_answered_is_told_so(ready: Ready, tmp_path: Path) -> None:
    script = {40: [("Ann", SET)], 41: [("Bob", SET)], 90: [("Zoe", {"do": "stop"})]}
    said, answers = recorded(ready, tmp_path / "x.log", 100, script)
    why = "route XB-XI7 is asked for already by Ann"
    assert ("Bob", {"ok": False, "why": [[why, ["g:XB"]]]}) in answers
    assert said[:2] == [
        ("operation", "Ann", "route XB-XI7 is set"),
        ("refusal", "Bob", f"set route XB-XI7: refused: {why}"),
    ]
    assert [x for x in said[2:] if x[0] == "refusal"] == [], "nothing of theirs waits any more"


def test_what_a_dispatcher_asks_for_bears_nobodys_name(ready: Ready, tmp_path: Path) -> None:
    script = {
        40: [("Ann", SET)],
        41: [("Bob", SET)],
        80: [("Ann", {"do": "cancel", "signal": "XB"})],
        200: [("Zoe", {"do": "release all"})],
        220: [("Zoe", {"do": "bring", "boundary": "W"})],
        230: [("Zoe", {"do": "voyage", "name": "12:W>s8_xc3"})],
    }
    said, _ = recorded(ready, tmp_path / "x.log", 900, script)
    assert [x[1] for x in said if x == (*x[:2], "route XB-XI7 is set")] == ["Ann", "dispatcher"], said


def test_a_request_is_refused_once_where_inputs_are_lost(ready: Ready, tmp_path: Path) -> None:
    cut: dict[str, Any] = {"do": "fail", "kind": "station", "name": "main", "on": True}
    script = {40: [("Ann", SET), ("Bob", SET), ("Cy", cut)], 60: [("Zoe", {"do": "stop"})]}
    said, _ = recorded(ready, tmp_path / "x.log", 80, script)
    assert [x[:2] for x in said if x[0] == "refusal"] == [("refusal", "Ann"), ("refusal", "Bob")], said


@pytest.mark.parametrize("people", [["Ann"], ["Ann", "Bob"]])
def test_each_who_asks_for_a_swing_is_answered(people: list[str], tmp_path: Path) -> None:
    ready = flank_lab()
    assert ready.controller is not None
    signal = next(iter(ready.controller.symbols.overlaps.swing_request))
    path = tmp_path / "x.log"
    asked = [(who, {"do": "swing", "signal": str(signal)}) for who in people]
    in_cycles(Desk(ready, None, 100, Recorder(path, ready)), 80, {RELEASED: asked})
    told = [e["who"] for e in read_file(path).events if e.get("text", "").endswith(("does not swing", " swings"))]
    assert told == people
