"""What the inputs may show of the railway, with every error that the assumptions allow; and what stop, shown long
enough, says of the train before a signal (A-DETECT, A-ONE-FALSE, A-CONTACT, A-TIMER)."""

from __future__ import annotations

from typing import Protocol

from interlock.logic import names
from interlock.logic.expr import FALSE, TRUE, Expr, conj, disj, implies, neg, var
from interlock.logic.plant.kinds import Plant, Wiring
from interlock.logic.plant.standing import functions
from interlock.logic.plant.words import image, o
from interlock.model.elements import SignalId
from interlock.model.layout import Layout
from interlock.model.traversal import Topology


class Making(Protocol):
    """What this part needs of the plant in the making."""

    layout: Layout
    topo: Topology
    w: Wiring
    p: Plant
    dropped: frozenset[str]

    def clock(self, name: names.Name, hold: Expr, text: str) -> Expr:
        """A clock of the world."""
        ...

    def assume(self, id_: str, expr: Expr) -> None:
        """The world does so."""
        ...

    def shown(self, g: SignalId, shunt: bool) -> Expr:
        """What the controller shows at a signal."""
        ...


def images(b: Making) -> None:
    """Reported sections, contacts, and the delay of approach locking."""
    p, topo = b.p, b.topo
    valid = var(b.w.valid)
    false_: dict[str, Expr] = {}
    for blind in sorted(b.layout.track.undetected):  # always taken as occupied
        p.state[names.IMAGE(blind)] = f"{blind} has no detection"
        p.next[names.IMAGE(blind)] = TRUE
        p.initial.append(image(blind))
    for s, name in b.w.clear.items():
        # a detector that is reported faulty may say anything: it counts as saying occupied
        faulty = neg(var(b.w.healthy[s])) if s in b.w.healthy else FALSE
        reported = disj((neg(var(name)), faulty))
        p.state[names.IMAGE(s)] = f"{s} was reported occupied"
        p.next[names.IMAGE(s)] = disj((reported, neg(valid)))
        if names.STANDS(s) not in p.state:
            continue  # an approach section beyond an outgoing boundary holds no train of this model
        p.initial.append(implies(o(s), image(s)))
        b.assume(
            "A-DETECT",
            implies(conj((o(s), p.next[names.STANDS(s)], valid)), reported),
        )
        false_[s] = conj((reported, neg(o(s)), neg(p.next[names.STANDS(s)]), valid))
    pairs = [(a, b) for _, a, b in topo.joints()] + [
        (x.approach, b.layout.track.section_of(b.layout.track.edges_at[x.node][0].id))
        for x in b.layout.track.boundaries
        if x.approach is not None
    ]
    for a, b_ in pairs:
        if a in false_ and b_ in false_:
            b.assume(
                "A-ONE-FALSE",
                neg(conj((false_[a], false_[b_]))),
            )
    for (m, x), name in b.w.detected.items():
        b.assume(
            "A-CONTACT",
            implies(conj((valid, var(name))), p.next[names.LIES(m, x)]),
        )
    for g, stop in b.w.stop.items():
        others = [b.shown(g, k) for k in functions(b.layout, g)]
        hold = conj((stop, *map(neg, others)))
        gone = [names.accepted(g, k) for k in functions(b.layout, g)]
        if any(go in p.next for go in gone):
            long = b.clock(names.STOP_LONG(g), hold, f"{g} has shown stop for as long as a train needs to stand")
            nobody = conj(neg(x) for go in gone if go in p.next for x in (var(go), p.next[go]))
            b.assume("A-TIMER", implies(long, nobody))
