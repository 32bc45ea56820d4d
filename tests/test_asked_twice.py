"""What the front end asks of a layout because safety hangs on it, the second checker asks once more, with nothing in
common: a layout that the front end lets pass by mistake is not VERIFIED."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Any

import pytest

from interlock.checker import specification
from interlock.checker.check import Checked, agree
from interlock.checker.railway import Railway
from interlock.checker.reading import loaded
from interlock.diag import Sink
from interlock.frontend import load_text
from interlock.verify import Rejected
from tests.written import told

Unasked = Callable[[str, str], Checked]

STATION = """interlock: 1
name: passing
boundaries: {W: {approach: wa 1200}, E: {approach: ea 1200}}
tracks:
  west: [W, w1 150]
  main: [m 850]
  loop: [l 850]
  east: [e1 150, E]
points:
  1: {section: p1, toe: west.end, normal: main.start, reverse: loop.start}
  2: {section: p2, toe: east.start, normal: main.end, reverse: loop.end}
signals:
  X: {from: W, into: w1}
  S: {from: E, into: e1}
  S1: {from: m, into: p1, kind: combined}
  S3: {from: l, into: p1, kind: combined}
  X1: {from: m, into: p2, kind: combined}
  X3: {from: l, into: p2, kind: combined}
  D1: {from: e1, into: p2, kind: shunt}
"""
X = "  X: {from: W, into: w1}\n"
ENTRANCES = {
    "none": ("", "no signal stands there"),
    "shunt": ("  X: {from: W, into: w1, kind: shunt}\n", "trains pass the shunt signal X whatever it shows"),
    "limit": ("  X: {from: W, into: w1, kind: limit}\n", "trains pass the limit-of-shunt board X whatever it shows"),
    "main": ("  X: {from: W, into: w1}\n", ""),
    "combined": ("  X: {from: W, into: w1, kind: combined}\n", ""),
    "board": ("  X: {from: W, into: w1, kind: board}\n", ""),
    "where trains end": ("  X: {from: W, into: w1, kind: shunt, stops_trains: yes}\n", ""),
}
"""What stands where trains come in, and what is said of it."""


def guarded_by(entry: str) -> str:
    """A layout with that at its boundary."""
    assert X in STATION
    return STATION.replace(X, entry)


def found(text: str) -> list[str]:
    """What the front end finds wrong."""
    sink = Sink()
    load_text("layout.yaml", text, sink)
    return [f"{d.code} {d.message}" for d in sink.diagnostics if d.severity == "error"]


@pytest.mark.parametrize("which", ENTRANCES)
def test_where_trains_come_in_stands_a_signal_that_they_obey(which: str) -> None:
    entry, why = ENTRANCES[which]
    errors = found(guarded_by(entry))
    assert errors == ([f"IL3011 trains can come in at W, and {why}"] if why else [])


@pytest.fixture
def unasked(monkeypatch: pytest.MonkeyPatch) -> Unasked:
    """What the second checker says of a layout where the front end has forgotten one of its codes."""

    def checked(text: str, code: str) -> Checked:
        add = Sink.add

        def others(self: Sink, this: str, *args: Any, **more: Any) -> None:
            if this != code:
                add(self, this, *args, **more)

        monkeypatch.setattr(Sink, "add", others)
        return agree(*told(text), specification.shipped())

    return checked


@pytest.mark.parametrize("which", ENTRANCES)
def test_the_second_checker_asks_for_that_signal_too(which: str, unasked: Unasked) -> None:
    entry, why = ENTRANCES[which]
    if why:
        with pytest.raises(Rejected, match="trains come in at W, and no signal stands there that they obey"):
            unasked(guarded_by(entry), "IL3011")
    else:
        assert unasked(guarded_by(entry), "IL3011").left == ()


SPEEDS = {
    "of a section above the line's": (
        "sections: {w1: {speed: 80}}",
        "X may show 80 km/h over [ml], p1, where none is stated",
    ),
    "of all sections": ("sections: {w1: {speed: 80}, p1: {speed: 80}, m: {speed: 80}, l: {speed: 80}}", ""),
    "of a section below the line's": ("sections: {w1: {speed: 30}}", ""),
    "with an overlap for less": (
        "sections: {w1: {speed: 80}}\noverlaps: {X1: {length: 50, entry_speed: 40}, X3: {length: 50, entry_speed: 40}}",
        "",
    ),
    "of an overlap above the line's": (
        "overlaps: {X1: {length: 50, entry_speed: 80}}",
        "X may show 80 km/h over m, p1, w1, where none",
    ),
}
"""What is stated of a line for 40 km/h, and how the second checker refuses it."""


@pytest.mark.parametrize("which", SPEEDS)
def test_no_speed_above_the_lines_is_shown_over_sections_that_state_none(which: str, unasked: Unasked) -> None:
    stated, why = SPEEDS[which]
    line = "principles: {line_speed_kmh: 40, restart_delay_s: 600, overlap_release_s: 300, slow_below_kmh: 20}\n"
    left = ", ".join(f"{{from: {g}, kind: main, reason: one way}}" for g in ("S", "S1", "S3"))
    text = f"{STATION}{stated}\n{line}exclude: [{left}]\n"
    if why:
        with pytest.raises(Rejected, match=why):
            unasked(text, "IL4021")
    else:
        assert unasked(text, "IL4021").left == ()


NO_OVERLAP = "overlaps: {X1: {length: 50, not_over: [p2]}}\n"
"""An overlap is asked for, and every way that there is for it is barred."""


@pytest.mark.parametrize(("more", "why"), [("", "no way beyond X1 is an overlap"), (", to: X1", "")])
def test_an_overlap_for_which_there_is_no_way_is_not_taken_for_none(more: str, why: str) -> None:
    """A controller that holds none is of a layout that asks for none; where no route leads there, none is missed."""
    assert "IL1014" in found(STATION + NO_OVERLAP)[0]
    chosen = f"exclude: [{{from: X{more}, kind: main, reason: no}}]\n" if more else ""
    _, system, text = told(STATION + chosen)
    body = loaded(STATION + chosen + NO_OVERLAP)
    if why:
        with pytest.raises(Rejected, match=why):
            agree(body, system, text, specification.shipped())
    else:
        assert agree(body, system, text, specification.shipped()).left == ()


NAMED_ALIKE = {
    "a level crossing and a point": "level_crossings: {1: {over: [w1]}}\n",
    "a bridge and a point": "interlocks: {1: {over: [m]}}\n",
    "a level crossing and a machine": "level_crossings: {M: {over: [w1]}}\n",
    "a level crossing and a bridge": "level_crossings: {B: {over: [w1]}}\ninterlocks: {b: {over: [m]}}\n",
}


@pytest.mark.parametrize("machine", ["M", "1"])
@pytest.mark.parametrize("which", NAMED_ALIKE)
def test_nothing_that_is_demanded_bears_the_name_of_something_else(which: str, machine: str) -> None:
    """`demand: [{point: 1, lies: reverse, ...}]` means one thing."""
    named = STATION.replace("{section: p1,", f"{{section: p1, machine: {machine},") if machine != "1" else STATION
    text = named + NAMED_ALIKE[which]
    if machine == "1" and "machine" in which:
        assert found(text) == [] and Railway(loaded(text)).machines["M"] == ["w1"]
        return
    (error,) = found(text)
    assert re.fullmatch(r"IL2002 \w names an? (level crossing|interlock|machine) and, in line \d+, the .*", error)
    with pytest.raises(Rejected, match=r"bears the name of another|are one name in the text"):
        Railway(loaded(text))
