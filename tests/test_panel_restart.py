"""The panel without power, after a restart and after inputs were lost: what is known then, and what stays."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from interlock.panel.desk import Desk
from tests.panels import AUTOMATIC, QUICK, all_released, kinds, panel, quick, unproved


def test_without_power_nothing_is_known_and_then_all_is_locked(at_work: tuple[Desk, Any]) -> None:
    _, browser = at_work
    with browser() as b:
        b.ask("set", route="XB-XI7")
        b.until(lambda: b.state["g:XB"][0] == "clear")
        assert b.ask("power", on=False)["ok"]
        b.until(lambda: b.state["g:XB"][0] == "dark" and b.state["s:s2"][0] == 1)
        assert not b.ask("set", route="XB-XI7")["ok"]
        before = b.rest["sys"]["releases"]
        b.ask("power", on=True)
        b.until(lambda: len(b.rest["sys"]["restart"]) == 11)
        assert "restart delay" in b.ask("release all")["why"][0][0] or b.rest["sys"]["delay"] == 0
        b.released()
        assert b.rest["sys"]["releases"] in (before + 1, before + 2)
        assert b.state["g:XB"][3] is None  # nothing is restored by itself (R16)


@pytest.mark.parametrize("name", ["heishan", "passing_loop", ""])
def test_without_power_no_value_of_before_is_left(tmp_path: Path, name: str) -> None:
    """Conditions, zones, directions and automatic working kept what they showed when the power went."""
    text = quick(tmp_path, name).read_text("utf-8") if name else AUTOMATIC
    with panel(unproved(text)) as (desk, browser), browser() as b:
        b.until(lambda: b.rest["sys"]["valid"])
        shown = set(b.state)
        b.ask("power", on=False)
        b.until(lambda: not b.rest["sys"]["power"] and all(v[0] == 1 for k, v in b.state.items() if k[0] == "s"))
        assert shown == set(desk.picture.dark())
        others = {k: v for k, v in b.state.items() if k[0] in "czba"}
        assert others and all(x is None for v in others.values() for x in v)


def test_blocks_outlast_a_power_cut_and_automatic_working_does_not() -> None:
    """Somebody may work on the track: the operator's place holds a block, whatever becomes of the controller."""
    with panel(unproved(AUTOMATIC)) as (_, browser), browser() as b:
        b.ask("speed", times=10)
        b.released()
        s, r = "q2", "A-E"
        assert b.ask("block", section=s, on=True)["ok"] and b.ask("automatic", route=r, on=True)["ok"]
        b.until(lambda: b.state[f"s:{s}"][3] == 1 and b.state[f"a:{r}"][0] == 1)
        b.ask("power", on=False)
        b.until(lambda: not b.rest["sys"]["power"] and b.state[f"s:{s}"][0] == 1)
        assert b.state[f"s:{s}"][3] == 1, "it is known without power, too"
        b.events.clear()
        b.ask("power", on=True)
        b.until(lambda: b.rest["sys"]["valid"])
        for _ in range(10):
            b.hear()
        assert b.state[f"s:{s}"][3] == 1 and b.state[f"a:{r}"][0] == 0
        assert f"section {s} is still blocked" in kinds(b.events, "note")
        assert b.ask("block", section=s, on=False)["ok"]
        b.until(lambda: b.state[f"s:{s}"][3] == 0)


def test_a_section_without_detection_needs_no_release(tmp_path: Path) -> None:
    """It counts as occupied for ever: after a restart it was the last step, which nobody could ever take."""
    text = Path("layouts/depot.yaml").read_text("utf-8") + QUICK
    with panel(unproved(text)) as (desk, browser), browser() as b:
        published: list[set[str]] = []
        desk.publish = lambda cycle, alarms: published.append(set(alarms))
        b.ask("speed", times=10)
        b.until(lambda: b.rest["sys"]["valid"] and b.rest["sys"]["delay"] == 0)
        assert "wsh" not in b.rest["sys"]["restart"] and "p1" in b.rest["sys"]["restart"]
        assert b.state["s:wsh"][:3] == [1, [], 0]
        told = "section wsh has no detection: it counts as occupied, and needs no release"
        assert b.ask("release", section="wsh")["why"] == [[told, ["s:wsh"]]]
        assert "start" in published[-1]
        assert b.ask("release all")["ok"]
        b.until(lambda: not b.rest["sys"]["restart"])
        b.until(lambda: "start" not in published[-1])
        routes = b.rest["still"]["routes"]
        into = next(r for r in routes if r["exit"][1] in ("wsh", "WASH"))
        out = next(r for r in routes if r["entry"] == "W")
        for r in (into, out):
            b.ask("set", route=r["id"])
            b.until(lambda r=r: f"route {r['id']} is set" in kinds(b.events, "operation"))  # type: ignore[misc]
            b.ask("cancel", signal=r["entry"])
            b.until(lambda r=r: b.state[f"g:{r['entry']}"][3] is None)  # type: ignore[misc]
            b.until(lambda: not b.state["s:p1"][1])
        restart = desk.picture.symbols.sections.restart
        assert desk._last.memory.state[restart["wsh"]], "it is locked all the time"  # type: ignore[index]


def test_the_server_says_why_the_detection_of_a_section_is_not_relied_on(single_line: tuple[Desk, Any]) -> None:
    """A page guessed it from what it had seen; one that came later took lost inputs for a train that is called on."""
    _, browser = single_line
    with browser() as b:
        b.ask("set", route="S-S1.c")
        b.until(lambda: b.state["g:S"][0] == "call")
        ways = ("s:IIAG", "s:2DG", "s:IG")
        assert [b.state[s][4] for s in ways] == [2, 2, 2]
        for n in b.rest["still"]["stations"]:
            b.ask("fail", kind="station", name=n, on=True)
        b.until(lambda: not b.rest["sys"]["valid"] and b.state["s:IG"][4] == 1)
        for n in b.rest["still"]["stations"]:
            b.ask("fail", kind="station", name=n, on=False)
        b.until(lambda: b.rest["sys"]["valid"])
        with browser(name="later") as late:
            assert [late.state[s][4] for s in ways] == [1, 1, 1]
        all_released(b, "S")
        assert [b.state[s][4] for s in ways] == [0, 0, 0]
