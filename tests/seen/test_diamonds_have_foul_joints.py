"""Diamonds had no foul joints: S2J opened over a vehicle that stood three metres from the diamond."""

from __future__ import annotations

from pathlib import Path

from interlock.diag import Sink
from interlock.frontend import load_text
from interlock.logic.lower import lower
from interlock.proof.prover import prove
from interlock.proof.system.transition import System

NEAR = Path("layouts/junction.yaml").read_text("utf-8").replace("legs: 25", "legs: 3")


def test_diamonds_have_foul_joints() -> None:
    from interlock.derivation import derive

    sink = Sink()
    layout, _ = load_text("junction.yaml", NEAR, sink)
    assert layout is not None
    told = [d.message for d in sink.diagnostics if d.code == "IL3018"]
    assert any("BB" in x and "X1" in x for x in told), "the author is told that BB|BC is foul of the diamond"
    table = derive(layout, sink)
    assert table is not None
    over = [
        r
        for r in table.routes
        if r.entry == "S1J" and ("X1", 0) in {c for k in r.path.traversals for c in table.lock[k].crossings}
    ]
    assert over and all("BB" in {c.section for c in r.clear.foul} for r in over), (
        "routes over the diamond require BB clear"
    )
    result = prove(System(layout, lower(layout, table)))
    proved = {c.id: (c.verdict.value, c.places) for c in result.claims}
    assert all(verdict == "PROVED" for verdict, _ in proved.values()), proved
    assert proved["T-FOUL"][1] > 0, "that no train passes the diamond while another stands foul of it is claimed"
