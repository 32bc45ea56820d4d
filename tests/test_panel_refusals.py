"""What the panel refuses: why, where, and in which words."""

from __future__ import annotations

import time
from pathlib import Path
from typing import Any

import pytest

from interlock.panel.asking import ASKED, SWITCHED, in_words
from interlock.panel.browsers import now_s
from interlock.panel.desk import Desk
from interlock.panel.operating import Person
from tests.panels import every_command, kinds, unproved


def test_a_refusal_says_why_and_where(at_work: tuple[Desk, Any]) -> None:
    _, browser = at_work
    with browser(name="Bert") as b:
        b.ask("set", route="XI7-XC3")
        b.until(lambda: b.state["g:XI7"][3])
        b.ask("set", route="XT9-XT7")
        b.until(lambda: kinds(b.events, "refusal"))
        told = b.events[-1]["reasons"] if b.events[-1]["kind"] == "refusal" else []
        told = told or next(e["reasons"] for e in b.events if e["kind"] == "refusal")
        assert ["section s7 is locked for route XI7-XC3", ["s:s7"]] in told
        assert "points P3 cannot move: section s7 is locked" in [text for text, _ in told] or len(told) == 1
        refusal = next(e for e in b.events if e["kind"] == "refusal")
        assert len(refusal["rules"]) == len(refusal["reasons"]) and refusal["rules"][0] == "R6"
        assert b.ask("cancel", signal="XI7")["ok"]
        b.until(lambda: not b.state["g:XI7"][3])
        no = b.ask("cancel", signal="XI7")
        assert not no["ok"] and "no route from XI7 is set" in no["why"][0][0]
        b.until(lambda: b.state["m:P3"][:2] == ["R", "R"])  # a block would stop it half-way
        b.ask("block", section="s7", on=True)
        b.ask("fail", kind="section", name="s8_xc3", on=True)
        b.until(lambda: b.state["s:s8_xc3"][0] == 1 and b.state["s:s7"][3] == 1)
        b.events.clear()
        b.ask("set", route="XI7-XC3")
        b.until(lambda: kinds(b.events, "refusal"))
        told = next(e["reasons"] for e in b.events if e["kind"] == "refusal")
        assert sorted(text for text, _ in told) == ["section s7 is blocked", "section s8_xc3 is occupied"]
        b.ask("block", section="s7", on=False)
        b.ask("fail", kind="section", name="s8_xc3", on=False)
        b.until(lambda: b.state["s:s8_xc3"][0] == 0 and b.state["s:s7"][3] == 0)


def test_a_move_that_flank_protection_forbids_is_refused_and_a_crossing_always_closes(lab: tuple[Desk, Any]) -> None:
    _, browser = lab
    with browser() as b:
        b.ask("set", route="L5-N8")
        b.until(lambda: b.state["g:L5"][3] == ["L5-N8", 1])
        no = b.ask("turn", machine="1", to="R")["why"][0][0]
        assert no == "1 cannot be moved: 1 is held as flank protection: section w5 is locked for route L5-N8"
        b.ask("cancel", signal="L5")
        b.until(lambda: b.state["g:L5"][3] is None and not b.state["s:w5"][1])
        b.ask("fail", kind="section", name="g4", on=True)
        b.until(lambda: b.state["s:g4"][0] == 1)
        assert b.state["m:LC1"][0] == "N"
        assert b.ask("turn", machine="LC1", to="R")["ok"]
        b.until(lambda: b.state["m:LC1"][0] == "R")
        assert "close level crossing LC1 by hand" in kinds(b.events, "operation")
        no = b.ask("turn", machine="LC1", to="R")["why"][0][0]
        assert no == "level crossing LC1 is closed already"
        b.events.clear()
        no = b.ask("turn", machine="LC1", to="N")["why"][0][0]
        assert no == "level crossing LC1 cannot be opened: section g4 is occupied"
        told = f"open level crossing LC1: refused: {no}"
        b.until(lambda: told in kinds(b.events, "refusal"))
        b.ask("fail", kind="section", name="g4", on=False)
        b.until(lambda: b.state["m:LC1"][0] == "N")


def test_where_no_overlap_is_held_there_is_nothing_to_swing(lab: tuple[Desk, Any]) -> None:
    _, browser = lab
    with browser() as b:
        b.events.clear()
        b.ask("swing", signal="F")
        b.until(lambda: kinds(b.events, "refusal"))
        no = next(e for e in b.events if e["kind"] == "refusal")
        assert no["text"] == "the overlap of F does not swing"
        assert no["reasons"] == [["no overlap of F is held: there is nothing to swing", ["g:F"]]]


@pytest.mark.parametrize(
    "command",
    [
        {"do": "set", "route": "nowhere"},
        {"do": "cancel"},
        {"do": "fly"},
        {"do": "block", "section": ["s3"], "on": 1},
        {"do": "bring", "boundary": "OUT"},
        {"do": "put", "section": "s3", "towards": "XL5"},
        {"do": "put", "section": "s3", "towards": "XT3", "metres": "long"},
        {"do": "speed", "times": 1000},
        {"do": "fail", "kind": "tea", "name": "x", "on": True},
        {"do": "remind", "at": "g:nothing", "text": "x"},
        {"do": "voyage", "name": "none"},
        {"do": "train", "name": "12", "section": "s99"},
        {"do": "train", "name": "12", "section": ""},
        {},
    ],
)
def test_what_cannot_be_done_is_refused_and_nothing_breaks(at_work: tuple[Desk, Any], command: dict[str, Any]) -> None:
    _, browser = at_work
    with browser() as b:
        b.send(re=7, **command)
        b.until(lambda: b.answers)
        assert b.answers[0]["ok"] is False and b.answers[0]["why"][0][0]


def test_why_a_section_cannot_be_blocked_is_told() -> None:
    desk = Desk(unproved(Path("layouts/depot.yaml").read_text("utf-8")))
    answers: list[dict[str, Any]] = []
    for section in ("ap", "sto", "s99"):
        desk.ask(Person("tester", True), {"do": "block", "section": section, "on": True}, answers.append)
    desk._commands()
    assert [a["why"][0][0] for a in answers] == [
        "section ap cannot be blocked: it is an approach section, which no route locks",
        "section sto cannot be blocked: no route and no overlap locks it",
        "there is no such section",
    ]


def test_what_was_asked_for_long_ago_is_not_done_any_more(at_work: tuple[Desk, Any]) -> None:
    """The computer was busy: whoever clicked has seen no answer, and done something else."""
    _, browser = at_work
    with browser(name="Jo") as b:
        late = {"heard": now_s() - 12, "after": 3000}
        no = b.ask("set", route="XI9-XC4", **late)
        assert not no["ok"] and no["why"][0][0] == "it was asked for 9 s ago, and is not done now: ask again"
        assert b.ask("set", route="XI9-XC4", heard=now_s() - 12, after=11_900)["ok"]
        b.until(lambda: b.state["g:XI9"][0] == "clear")
        assert b.ask("cancel", signal="XI9", **late)["ok"], "late is better than never"
        b.until(lambda: not b.state["s:s9"][1])


def test_an_age_is_no_matter_of_a_clock_that_is_set(at_work: tuple[Desk, Any], monkeypatch: pytest.MonkeyPatch) -> None:
    """A section that was to be freed half a minute ago was freed, since the clock had been set back by one."""
    _, browser = at_work
    with browser(name="Jo") as b:
        asked = {"heard": now_s() - 30, "after": 0}
        monkeypatch.setattr("time.time", lambda at=time.time: at() - 60)
        no = b.ask("block", section="s9", on=False, **asked)
        assert not no["ok"] and no["why"][0][0] == "it was asked for 30 s ago, and is not done now: ask again"
        ahead = b.ask("block", section="s9", on=False, heard=now_s() + 30, after=0)
        assert ahead["why"][0][0] == "it says that it is asked for in 30 s: when that was is not known, ask again"
        for undated in ({"heard": None}, {"after": None}):
            no = b.ask("block", section="s9", on=False, **undated)
            assert no["why"] == [["it does not say when it was asked for, and is not done", []]]
        assert b.ask("block", section="s9", on=True, heard=None)["ok"] and b.ask("stop", heard=None)["ok"]
        assert b.ask("block", section="s9", on=False)["ok"]


def test_the_record_says_what_was_refused_and_which_lamp_failed(lab: tuple[Desk, Any]) -> None:
    """`section s6 is occupied` told nobody what was asked for."""
    _, browser = lab
    with browser() as b:
        b.events.clear()
        b.ask("release", section="g4")
        b.ask("cancel", signal="SA")
        b.ask("turn", machine="6", to="N")
        b.ask("take away", train="nobody")
        b.ask("speed", times=1000)
        b.ask("drive", train="x", go=True)
        b.until(lambda: len(kinds(b.events, "refusal")) == 6)
        assert kinds(b.events, "refusal") == [
            "release section g4: refused: section g4 is not locked",
            "cancel the route from SA: refused: no route from SA is set that a train has not entered",
            "move 6 normal: refused: 6 lies there already",
            "take away train nobody: refused: there is no train nobody",
            "time runs 1000 times as fast: refused: time runs 1, 2, 5, 10, 60 times as fast",
            "let train x go on: refused: there is no train x",
        ]
        lamp = b.rest["still"]["lamps"]["F"]["stop"]
        b.ask("fail", kind="lamp", name=lamp, on=True)
        b.ask("fail", kind="lamp", name=lamp, on=False)
        b.until(lambda: len(kinds(b.events, "operation")) == 2)
        told = ["fault of the stop lamp of F", "fault put right: the stop lamp of F"]
        assert kinds(b.events, "operation") == told


def test_every_command_has_words_for_its_refusal(lab: tuple[Desk, Any]) -> None:
    desk, _ = lab
    for command in every_command(desk.browsers.still):
        told = in_words(command, desk.picture.layout.machines)
        assert command["do"] in {**ASKED, **SWITCHED} and "  " not in told and told
