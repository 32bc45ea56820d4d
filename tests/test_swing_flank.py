"""An overlap that swings to an alternative for which a point beside it has to turn, too: it protects its flank (R4)."""

from __future__ import annotations

from interlock.logic.lower import lower
from interlock.proof.claims import Facts, claims
from interlock.proof.engines.limits import Limits
from interlock.proof.induction.search import search
from interlock.proof.induction.story import tell
from interlock.proof.prover import prove
from interlock.proof.system.transition import System
from tests.layouts import grown

TEXT = """
interlock: 1
name: swing_flank
profile: generic
principles: {line_speed_kmh: 10, restart_delay_s: 36000, output_delay_s: 0.1, point_run_s: 0.5, point_supervision_s: 1}
boundaries:
  W: {approach: wa 300, trains: in}
  E: {approach: ea 300}
  F: {approach: fa 300}
  G: {approach: ga 300, trains: out}
tracks:
  west: [W, q1 400]
  odd:  [q3 300, E]
  even: [q4 300, G]
  side: [s1 300, F]
points:
  P1: {section: q2, toe: west.end,   normal: P9.reverse, reverse: even.start}
  P9: {section: q5, toe: odd.start, normal: side.start}
signals:
  X1: {from: W,  into: q1}
  X2: {from: q1, into: q2}
  Y: {from: F, into: s1}
  Z: {from: E, into: q3}
overlaps:
  X2: {length: 30, swing: yes}
"""


def system(text: str) -> System:
    found = grown(text)
    assert found is not None and not found[2].has_errors
    layout, table, _ = found
    beside = {
        (r.locking.overlap.option, p.machine, str(p.position))
        for r in table.routes
        for p in r.locking.points
        if r.locking.overlap is not None and p.role == "flank"
    }
    assert beside == {(2, "P9", "N")}
    return System(layout, lower(layout, table))


def test_while_that_point_still_turns_the_signals_behind_it_protect() -> None:
    result = prove(system(TEXT), Limits(search_s=0))
    assert result.proved and not result.dropped


def test_where_nothing_else_protects_a_train_may_overrun_while_it_turns() -> None:
    """Z stands foul of P1: a train waits for the points under its overlap to have turned (A-SWING), not for P9."""
    text = TEXT.replace("odd:  [q3 300, E]", "odd:  [q3 1, E]").replace("length: 30", "length: 20")
    text = text.replace("reverse: even.start}", "reverse: even.start, legs: 12, fouling: 13}")
    text = text.replace("normal: side.start}", "normal: side.start, legs: 0.5, fouling: 0.1}")
    text = text.replace("principles: {", "principles: {clearance_m: 1.5, ")
    s = system(text)
    result = prove(s, Limits(search_s=0))
    assert {c.id: c.open for c in result.claims if c.open} == {"T-FLANK": ("q2:1:P1.N overrun from X2",)}
    run = search(s, [c for c in claims(Facts(s)) if c.id == "T-FLANK"], 14, 60)
    assert run is not None and any("P1.N overrun from X2" in x for x in tell(s.loop, run).steps)
