"""The claims about pairs of signals are stated place by place; here they are shown to speak of every pair."""

from __future__ import annotations

from itertools import combinations

import pytest

from interlock.logic.expr import at_most_one, conj
from interlock.logic.lower import lower
from interlock.logic.plant import lies
from interlock.model.elements import Position
from interlock.model.layout import Layout
from interlock.proof.claims import Facts, claims
from interlock.proof.claims.paths import SignalPath, lie, signal_paths
from interlock.proof.engines import Answer, solver
from interlock.proof.engines.tseitin import Cnf
from interlock.proof.system.transition import System
from interlock.table.rows import InterlockingTable
from tests.grow import grow
from tests.layouts import SHIPPED, built, grown


def _share(f: Facts, a: SignalPath, b: SignalPath) -> bool:
    """Two paths take the same section, cross on a diamond, or one touches a joint that is foul of the other's way."""
    crossings = {c for t in a.ways for c in t.crossings}
    if {t.section for t in a.ways} & {t.section for t in b.ways}:
        return True
    if any((c, 1 - arm) in crossings for t in b.ways for c, arm in t.crossings):
        return True
    for over, beside in ((a, b), (b, a)):
        for fj in f.track.fouls:
            passes = any(p == fj.element and x is not fj.side for t in over.ways for p, x in t.points)
            passes |= any(c == fj.element and arm != fj.side for t in over.ways for c, arm in t.crossings)
            touches = any(
                t.section == fj.neighbour and (fj.when is None or fj.node in (t.entry, t.exit)) for t in beside.ways
            )
            if passes and touches:
                return True
    return False


def _every_pair_is_told_apart(layout: Layout, table: InterlockingTable) -> int:
    f = Facts(System(layout, lower(layout, table)))
    cnf = Cnf()
    for c in claims(f):
        if c.id in ("S-OPPOSING", "S-HOSTILE"):
            cnf.require(c.expr)
    for m in layout.machines:
        cnf.require(at_most_one(lies(m, x) for x in Position))
    shown = [(g.id, k) for g in layout.signalling.signals for k in f.track.functions(g.id)]
    pairs = [
        (a, b)
        for x, y in combinations(shown, 2)
        for a in signal_paths(f, *x)
        for b in signal_paths(f, *y)
        if _share(f, a, b)
    ]
    both = [
        cnf.literal(
            conj(
                (
                    f.sym.aspects.signal(a.signal, a.shunt),
                    f.sym.aspects.signal(b.signal, b.shunt),
                    lie(f, a.ways),
                    lie(f, b.ways),
                )
            )
        )
        for a, b in pairs
    ]
    sat = solver("minisat", cnf, 1000)
    assert sat.ask() is Answer.SAT
    for (a, b), x in zip(pairs, both, strict=True):
        assert sat.ask(x) is Answer.UNSAT, (a.signal, b.signal)
    return len(pairs)


@pytest.mark.parametrize("name", SHIPPED)
def test_every_hostile_pair_of_signals_is_told_apart_at_some_place(name: str) -> None:
    layout, table, _ = built(name)
    assert _every_pair_is_told_apart(layout, table) > 0


def test_so_it_is_on_layouts_that_grow_at_random() -> None:
    seen = 0
    for seed in range(60):
        made = grown(grow(seed))
        if made is not None and not any(d.severity == "error" for d in made[2].diagnostics):
            seen += _every_pair_is_told_apart(made[0], made[1])
    assert seen > 300


def test_without_the_claims_of_one_place_a_pair_is_not_told_apart() -> None:
    f = Facts(System(*(lambda x: (x[0], x[2]))(built("junction"))))
    pair = [x for x in claims(f) if x.id in ("S-OPPOSING", "S-HOSTILE")]
    assert any(c.place.startswith("diamond") for c in pair)
    cnf = Cnf()
    for c in pair:
        if not c.place.startswith("diamond"):
            cnf.require(c.expr)
    diamond = next(c for c in pair if c.place.startswith("diamond"))
    assert solver("minisat", cnf, 1000).ask(-cnf.literal(diamond.expr)) is Answer.SAT
