"""What the lowering collects."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction

from interlock.logic.controller import Equation, Input, Join, Output, StateVar, Step, Term, Timer
from interlock.logic.expr import Expr, var
from interlock.logic.lower.index import MachineIndex, OverlapIndex, RouteIndex, SectionIndex, SignalIndex
from interlock.logic.names import Name
from interlock.model.elements import SignalId
from interlock.model.foul import FoulJoint
from interlock.model.layout import Layout
from interlock.model.times import whole_ms
from interlock.model.traversal import Topology, topology
from interlock.table.rows import InterlockingTable


class Draft:
    """A controller in the making, with what it is made from."""

    def __init__(
        self, layout: Layout, table: InterlockingTable, fouls: Sequence[FoulJoint], arrive: Mapping[SignalId, int]
    ) -> None:
        """`layout`, `table`: without lengths, of which `fouls` tells the foul joints, and `arrive` how long a train
        runs on to a signal at the end of a berth."""
        self.layout = layout
        self.table = table
        self.topo: Topology = topology(layout)
        self.routes = RouteIndex(layout, table)
        self.overlaps = OverlapIndex(layout, table)
        self.sections = SectionIndex(layout, table, fouls, self.topo, self.routes)
        self.machines = MachineIndex(layout)
        self.signals = SignalIndex(layout, table, self.topo, self.routes, self.sections, arrive)
        self.inputs: list[Input] = []
        self.memory: list[tuple[StateVar, Equation]] = []
        """State variables, each with the equation of its next value."""
        self.steps: list[Step] = []
        self.outputs: list[Output] = []

    def wire(self, name: Name, join: Join, terms: Iterable[Term], group: str, note: str = "") -> Expr:
        """Add a wire; returns its variable."""
        self.steps.append(Equation(name, join, tuple(terms), group, note))
        return var(name)

    def timer(self, name: Name, input_: Name, seconds: float | Fraction, note: str) -> Expr:
        """Add an on-delay timer, never shorter than so many seconds; returns its output."""
        self.steps.append(Timer(name, input_, whole_ms(seconds), note))
        return var(name)

    def kept(self, name: Name, initial: bool, note: str, join: Join, terms: Iterable[Term], group: str) -> None:
        """Add a state variable with its next-state equation."""
        self.memory.append((StateVar(name, initial, note), Equation(name, join, tuple(terms), group, note)))
