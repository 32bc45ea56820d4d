"""Point machines and devices: they start when they are driven away, arrive when they are driven there (A-POINT)."""

from __future__ import annotations

from typing import Protocol

from interlock.logic import names
from interlock.logic.expr import FALSE, TRUE, Expr, at_most_one, conj, disj, neg
from interlock.logic.plant.kinds import Plant, Wiring
from interlock.logic.plant.words import lies, o, old_command, rests
from interlock.model.elements import MachineId, Position
from interlock.model.layout import Layout
from interlock.model.traversal import Topology


class Making(Protocol):
    """What this part needs of the plant in the making."""

    layout: Layout
    topo: Topology
    w: Wiring
    p: Plant
    dropped: frozenset[str]

    def choice(self, name: names.Name, text: str) -> Expr:
        """A free choice of the world."""
        ...


def trail(b: Making, m: MachineId) -> Expr:
    """A vehicle that is moved under local rules runs through a point that lies against it."""
    here = sorted({b.layout.track.section_of(e.toe) for e in b.layout.machines.ends.get(m, ())})
    under = disj(conj((o(s), rests(s))) for s in here)
    chance = b.choice(names.RUN_THROUGH(m), f"a vehicle that is moved under local rules runs through {m}")
    b.p.events[names.RUN_THROUGH(m)] = conj((under, chance))
    return b.p.events[names.RUN_THROUGH(m)]


def machines(b: Making) -> None:
    """State, events and next states of every machine."""
    for m in b.layout.machines:
        starts = {}
        for x in Position:
            b.p.state[names.LIES(m, x)] = f"machine {m} lies {b.layout.machines.word(m, x)}"
            b.p.state[names.OLD_COMMAND(m, x)] = f"machine {m} was commanded {b.layout.machines.word(m, x)}"
            b.p.next[names.OLD_COMMAND(m, x)] = b.w.command[m, x]
            away = disj((b.w.command[m, x.other], old_command(m, x.other)))
            if "A-POINT" in b.dropped:
                away = TRUE
            starts[x] = conj(
                (
                    lies(m, x),
                    away,
                    b.choice(
                        names.MACHINE_STARTS(m, x),
                        f"{m} starts to leave its position: {b.layout.machines.word(m, x)}",
                    ),
                )
            )
            b.p.events[names.MACHINE_STARTS(m, x)] = starts[x]
        trailed = FALSE if "A-TRAILED" not in b.dropped else trail(b, m)
        moving = conj(neg(lies(m, x)) for x in Position)
        for x in Position:
            may = disj((b.w.command[m, x], old_command(m, x)))
            if m in b.layout.machines.by_hand:
                may = TRUE  # whoever has the key turns it as he likes, once it is released
            arrives = conj(
                (
                    moving,
                    may,
                    b.choice(names.MACHINE_ARRIVES(m, x), f"{m} arrives: {b.layout.machines.word(m, x)}"),
                )
            )
            # both commands may be pending in one step: normal wins, so that it never lies both ways
            if x is Position.REVERSE:
                arrives = conj((arrives, neg(b.p.events[names.MACHINE_ARRIVES(m, Position.NORMAL)])))
            b.p.events[names.MACHINE_ARRIVES(m, x)] = arrives
            forced = conj((trailed, lies(m, x.other)))
            b.p.next[names.LIES(m, x)] = disj((conj((lies(m, x), neg(starts[x]), neg(trailed))), arrives, forced))
        b.p.initial.append(at_most_one(lies(m, x) for x in Position))
