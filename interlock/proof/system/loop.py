"""The closed loop: a controller, the plant that it controls, and the railway of both.

What is said of the two alone, with no step encoded: runs of trains and stories need no more.

**Theorem.**  The plant reads of the controller what its terminals show, and nothing else (`wiring`): whoever shows the
same lamps and commands lets the same trains run.  (Composition over shared variables: Abadi and Lamport, *Conjoining
Specifications*, 1995.)
"""

from __future__ import annotations

from interlock.dataclass import dataclass
from interlock.logic.controller import Controller
from interlock.logic.expr import var
from interlock.logic.plant import Plant, TokenWires, Wiring, build_plant
from interlock.model.layout import Layout
from interlock.model.measured import Measured, measured
from interlock.model.traversal import Topology, topology


@dataclass(frozen=True, eq=False)
class ClosedLoop:
    """A controller with its plant.  `layout`: without its lengths, of which nothing but `measured` is kept."""

    layout: Layout
    measured: Measured
    topo: Topology
    controller: Controller
    plant: Plant


def closed_loop(layout: Layout, controller: Controller, dropped: frozenset[str] = frozenset()) -> ClosedLoop:
    """A controller with the plant of a layout; `layout`: with its lengths; `dropped`: assumptions that are not made."""
    lengths, bare = measured(layout), layout.bare
    plant = build_plant(bare, lengths, wiring(controller, bare), dropped)
    return ClosedLoop(bare, lengths, topology(bare), controller, plant)


def wiring(controller: Controller, layout: Layout) -> Wiring:
    """How the plant sees a controller."""
    s = controller.symbols
    return Wiring(
        proceed={g.id: s.aspects.signal(g.id) for g in layout.signalling.signals},
        call={g.id: s.aspects.signal(g.id, shunt=True) for g in layout.signalling.signals},
        command={k: var(v) for k, v in s.machines.drive.items()},
        valid=s.valid,
        clear=s.sections.clear,
        healthy=s.sections.healthy,
        detected=s.machines.detected,
        stop={g: var(name) for g, name in s.aspects.stop.items()},
        speed={k: var(name) for k, name in s.aspects.speed.items()},
        token={
            b: TokenWires(x.gives, x.keeps, x.has, x.clear, x.tells["has"], x.tells["gives"], x.manual)
            for b, x in s.token.items()
        },
    )
