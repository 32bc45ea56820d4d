"""`release` of a signal: how long its routes are held after a cancellation, instead of the principles' times (R8)."""

from __future__ import annotations

from pathlib import Path

import pytest

from interlock.audit import audit
from interlock.checker import specification
from interlock.checker.check import agree
from interlock.checker.lengths import Lengths, fastest_told
from interlock.checker.railway import Railway
from interlock.checker.reading import loaded
from interlock.diag import Sink
from interlock.frontend import load_text
from interlock.logic.lower import lower
from interlock.proof.engines.limits import Limits
from interlock.proof.induction.verdict import Verdict
from interlock.proof.prover import prove
from interlock.proof.system.transition import System
from interlock.verify import Rejected
from tests.layouts import grown
from tests.seen.test_wrong_timers import with_presets
from tests.written import told

YARD = Path("tests/layouts_for_tests/shunt_yard.yaml").read_text("utf-8")
S1, D1 = "S1: {from: g1, into: p1, kind: combined", "D1: {from: l1, into: l2, kind: shunt"


def own(seconds: str, signal: str = S1) -> str:
    """The yard with a time of its own at a signal."""
    return YARD.replace(signal, f"{signal}, release: {seconds}")


def delays(text: str) -> dict[str, float]:
    """The delay of each signal's routes in the table."""
    made = grown(text)
    assert made is not None and audit(made[0], made[1]) == ()
    return {str(r.entry): r.locking.approach.delay_s for r in made[1].routes}


def test_a_time_of_its_own_is_the_delay_of_all_routes_of_a_signal() -> None:
    assert delays(own("60")) == {**delays(YARD), "S1": 60.0}
    assert delays(YARD)["S1"] == delays(YARD)["X"] == 180.0 and delays(own("240", D1))["D1"] == 240.0


def test_it_is_proved_and_the_second_checker_agrees() -> None:
    made = grown(own("60"))
    assert made is not None
    controller = lower(made[0], made[1])
    name = controller.symbols.cancellation.approach_timer[
        next(g.id for g in made[0].signalling.signals if g.id == "S1")
    ]
    assert {t.preset_ms for t in controller.timers if t.name == name} == {60_000}
    assert prove(System(made[0], controller), limits=Limits(search_s=0)).proved
    assert agree(*told(own("60")), specification.shipped()).left == ()
    shorter = with_presets(controller, 59_999, name)
    refuted = prove(System(made[0], shorter), limits=Limits(search_s=0))
    assert {c.id for c in refuted.claims if c.verdict is not Verdict.PROVED} == {"D-PRESET"}


@pytest.mark.parametrize(("one", "other"), [(own("60"), YARD), (YARD, own("240"))])
def test_a_controller_that_holds_routes_for_less_is_not_accepted(one: str, other: str) -> None:
    _, system, text = told(one)
    with pytest.raises(Rejected):
        agree(loaded(other), system, text, specification.shipped())


def codes(text: str) -> list[str]:
    """What is said of a layout."""
    sink = Sink()
    load_text("yard.yaml", text, sink)
    return [f"{d.code} {d.message}" for d in sink.diagnostics if d.severity == "error"]


def test_no_time_is_shorter_than_a_train_needs_to_stand() -> None:
    (said,) = codes(own("20"))
    assert said.startswith("IL3023 the routes of S1 are held for 20 s, and 42.1 s are needed")
    (said,) = codes(own("20", D1))
    assert said.startswith("IL3023 the routes of D1 are held for 20 s, and 23.6 s are needed")
    assert codes(own("24", D1)) == [], "no train obeys it"


FAST = """
interlock: 1
name: fast
principles: {line_speed_kmh: 160, caution: never, restart_delay_s: 240}
boundaries: {W: {approach: wa 3000, trains: in}, F: {approach: fa 3000, trains: in}, E: {trains: out}}
tracks: {west: [W, far 2500, rear 30, stub 60], loop: [F, l 300], main: [m 300, E]}
points:
  P: {section: p, toe: main.start, normal: west.end, reverse: loop.end, legs: 20}
sections: {rear: {speed: 30}}
signals:
  X: {from: W, into: far}
  S: {from: rear, into: stub, release: RELEASE}
  V: {from: F, into: l}
  T: {from: l, into: p}
"""
"""The last 30 m before S are run at 30 km/h, and what comes there begins to brake from 160."""


def test_a_train_that_is_told_far_away_brakes_from_the_speed_there() -> None:
    """5 s and 160 / 3.6 / 0.6: only the last section's 30 km/h counted, 18.9 s, and a train that kept to everything ran
    past S after its route had been given up."""
    (said,) = codes(FAST.replace("RELEASE", "79"))
    assert "79.1 s are needed" in said and "braking from 160 km/h, the highest speed in its approach" in said
    text = FAST.replace("RELEASE", "80")
    made = grown(text)
    assert codes(text) == [] and made is not None
    controller = lower(made[0], made[1])
    name = next(n for g, n in controller.symbols.cancellation.approach_timer.items() if g == "S")
    short = with_presets(controller, 79_000, name)
    refuted = prove(System(made[0], short), limits=Limits(search_s=0))
    assert {"D-PRESET", "T-COLLISION"} <= {c.id for c in refuted.claims if c.verdict is not Verdict.PROVED}


def test_the_second_checker_asks_for_the_speed_far_away_too() -> None:
    text = FAST.replace("RELEASE", "80")
    lengths = Lengths(Railway(loaded(text)))
    signal = next(g for g in lengths.r.signals.values() if g.name == "S")
    assert lengths.halt(fastest_told(lengths, signal)) == 79_075
    assert agree(*told(text), specification.shipped()).left == ()


def test_a_board_holds_nothing() -> None:
    text = YARD.replace("D3: {from: l2, into: l1, kind: shunt", "D3: {from: l2, into: l1, kind: limit, release: 60")
    assert codes(text) == ["IL3027 no route begins at D3: `release` says nothing of it"]


TOLD = """interlock: 1
name: told
principles: {line_speed_kmh: 80, restart_delay_s: 300}
boundaries: {W: {approach: wa 900, trains: in}, E: {approach: ea 900, trains: out}}
tracks: {line: [W, a 600, r 50, q 1500, z 300, E]}
signals: {X: {from: W, into: a}, S1: {from: r, into: q}, S: {from: q, into: z}}
"""


def test_a_driver_whom_the_signal_before_told_runs_on_until_he_acts_over_short_sections_too() -> None:
    """At 80 km/h he is farther off than r is long when S falls back: a is part of the approach of S, too."""
    made = grown(TOLD)
    assert made is not None and audit(made[0], made[1]) == ()
    rules = made[0].principles
    assert 50 < rules.line_speed_kmh / 3.6 * (rules.reaction_s + rules.output_delay_s) < 650
    (row,) = (r for r in made[1].routes if r.entry == "S")
    assert row.locking.approach.sections == ("q", "r", "a")
