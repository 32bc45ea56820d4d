"""Vehicles left under a door do not follow: the road is no berth, and says so, yet its signal closes as if it were."""

from __future__ import annotations

from interlock.diag import Sink
from interlock.frontend import load_text
from interlock.logic.eval import Machine
from interlock.logic.lower import lower
from tests.layouts import grown

SHED = """
interlock: 1
name: shed
profile: cn
boundaries:
  M: {approach: ma 600}
buffers: [B1, B2]
tracks:
  lead: [M, l1 220]
  r1: [k1 180, B1]
  r2: [k2 180, B2]
points:
  P1: {section: t1, toe: lead.end, normal: r1.start, reverse: r2.start}
interlocks:
  DOOR: {over: [k2], text: shed door}
signals:
  X:  {from: M,  into: l1}
  XD: {from: l1, into: t1, kind: combined}
  Y:  {from: t1, into: l1}
  S1: {from: k1, into: t1, kind: combined}
  S2: {from: k2, into: t1, kind: combined}
"""


def test_the_signal_closes_with_the_first_axle_while_something_stands_under_the_door() -> None:
    made = grown(SHED)
    assert made is not None
    layout, table, _ = made
    machine = Machine(lower(layout, table))
    number = next(r.number for r in table.routes if r.entry == "S2" and r.kind.value == "shunt")

    def drive(scans: int, **inputs: int) -> dict[str, bool]:
        out: dict[str, bool] = {}
        for _ in range(scans):
            up = ("CLR_", "VALID", "RL_", "GL_", "CL_", "DR_")
            given = {i.name: int(i.name.startswith(up)) for i in machine.controller.inputs}
            out = machine.scan(given | inputs, 500)
        return out

    drive(2 * 600 + 4)
    drive(20, RELALL=1)
    drive(2, CLR_k2=0)  # two vehicles stand in k2
    drive(1, CLR_k2=0, REQ=number)
    assert drive(20, CLR_k2=0)["YW_S2"]
    out = drive(6, CLR_k2=0, CLR_t1=0)  # the first has come out, the second is still there
    assert not out["YW_S2"] and out["YS_S2"], "the second vehicle would follow at proceed"


def test_check_says_that_the_road_is_no_berth() -> None:
    sink = Sink()
    load_text("shed.yaml", SHED, sink)
    assert [d.message for d in sink.diagnostics if "berth" in d.message] == ["k2 is no berth: DOOR lies over it"]
