"""Trains with length and speed on a running controller: each reads the lamps before it and knows nothing else.

A train runs to the end of the section in which its head is, goes on where no signal forbids it, over points as they
lie, and accepts what a signal shows it.  All that happens is an event of the plant, so that the plant's assumptions
hold and its hazards are seen.  Lengths in metres, speeds in metres a scan.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import field

from interlock.dataclass import dataclass
from interlock.logic import names
from interlock.logic.names import Name
from interlock.model.elements import BoundaryKind, NodeId, Position, SectionId
from interlock.model.layout import Layout
from interlock.model.traversal import Traversal, topology
from interlock.sim.lanes import Lane

BEYOND = "beyond"
"""The section of a head that has passed a boundary."""


@dataclass(frozen=True)
class Spot:
    """A section under a train: where it came in, where it goes on, how long it is on that way."""

    section: str
    entry: NodeId
    exit: NodeId
    metres: float


@dataclass
class Train:
    """A train: the sections under it from the rear to the head, and how far its head has come in the last of them.

    due: scans until it comes to its boundary.  turns: sections in which it changes direction when it stands there.
    """

    name: str
    length_m: float
    speed_m: float
    under: list[Spot] = field(default_factory=list)
    done: float = 0.0
    due: int = 0
    turns: set[str] = field(default_factory=set)
    there: bool = True
    """False while it has not yet come to its boundary."""
    comes: bool = False
    gone: bool = False

    @property
    def past_rear(self) -> float:
        """Metres from the joint before its rear section to its head."""
        return self.done + sum(s.metres for s in self.under[1:-1])

    @property
    def leaves_at(self) -> NodeId | None:
        """The boundary across which it stands with its head beyond; None where there is none."""
        head = self.under[-1] if self.under and not self.gone else None
        return head.entry if head is not None and head.section == BEYOND else None


class Rails:
    """Where trains can go on a layout (with its lengths)."""

    def __init__(self, layout: Layout) -> None:
        self.layout, self.topo = layout, topology(layout)
        self.machine = {p.id: p.machine for p in layout.pointwork.points}
        self.boundary = {b.node: b for b in layout.track.boundaries}

    def before(self, boundary: str) -> Spot:
        """The place of a train that comes to a boundary.  Raises `KeyError` where none comes in."""
        b = self.boundary[NodeId(boundary)]
        if b.kind is BoundaryKind.OUT:
            raise KeyError(boundary)
        return Spot(b.approach or names.outside(b.node), b.node, b.node, 0.0)

    def beyond(self, spot: Spot) -> SectionId | None:
        """What lies beyond the joint to which a train runs."""
        if spot.entry == spot.exit and spot.metres == 0:
            return self.layout.track.section_of(self.layout.track.edges_at[spot.exit][0].id)
        return self.topo.beyond(SectionId(spot.section), spot.exit)

    def spot(self, way: Traversal) -> Spot:
        """A section under a train on a way."""
        return Spot(way.section, way.entry, way.exit, way.length)

    def into(self, lane: Lane, section: SectionId, joint: NodeId) -> Spot:
        """The way on which a train is that came in at a joint, as the points lie."""
        for t in self.topo.through(section, joint):
            if all(lane.is_on(names.LIES(self.machine[p], x)) for p, x in t.points):
                return self.spot(t)
        return Spot(section, joint, joint, 1e9)  # on points that lie nowhere it never comes to the end

    def lying(self, ways: Sequence[Traversal]) -> dict[str, int]:
        """The plant's state with a train that has stood on some ways since the restart, the rear first."""
        state: dict[str, int] = {}
        for t in ways:
            state |= {names.STANDS(t.section): 1, names.CAME(t.section, t.entry): 1, names.RESTS(t.section): 1}
            for p, x in t.points:
                m = self.machine[p]
                state |= {
                    names.LIES(m, Position.NORMAL): int(x is Position.NORMAL),
                    names.LIES(m, Position.REVERSE): int(x is Position.REVERSE),
                }
        return state | {names.ACROSS(t.exit, t.section): 1 for t in ways[:-1]}

    # --- a scan --------------------------------------------------------------------------------

    def wishes(self, lane: Lane, train: Train) -> Iterator[Name]:
        """What a train does in the next scan, if it can; `moved` says afterwards what it did."""
        if train.gone:
            return
        if train.due > 0:
            train.due -= 1
            return
        head = train.under[-1]
        if not train.there:
            if not lane.is_on(names.STANDS(head.section)):
                yield names.APPEARS(head.section)
                train.comes = True
            return
        train.done += train.speed_m
        if head.section != BEYOND:
            train.done = min(train.done, head.metres)
        if len(train.under) > 1 and train.past_rear >= train.length_m:
            yield names.TAIL(train.under[0].exit, train.under[0].section)
        elif head.section != BEYOND and train.done >= head.metres:
            yield from self._on(lane, train, head)

    def _on(self, lane: Lane, train: Train, head: Spot) -> Iterator[Name]:
        if head.section in train.turns and len(train.under) == 1:
            yield names.TURNS(head.section, head.entry, head.exit)
            return
        beyond = self.beyond(head)
        signal = None if beyond is None else self.topo.main_into.get((head.exit, beyond))
        if signal is not None and not lane.is_on(names.ACCEPTED(signal)):
            yield names.ACCEPTS(signal)
        elif beyond is not None or head.exit in self.boundary:
            yield names.HEAD(head.exit, head.section)

    def moved(self, lane: Lane, train: Train) -> None:
        """Take over what happened in the scan."""
        if not train.there:
            train.there = train.comes and lane.is_on(names.STANDS(train.under[0].section))
            train.comes = False
            return
        if train.gone or not train.under:
            return
        head, rear = train.under[-1], train.under[0]
        if len(train.under) > 1 and not lane.is_on(names.ACROSS(rear.exit, rear.section)):
            train.under.pop(0)
            train.gone = train.under[0].section == BEYOND
        if head.section == BEYOND:
            return
        beyond = self.beyond(head)
        leads_on = beyond is not None or head.exit in self.boundary
        if leads_on and lane.is_on(names.ACROSS(head.exit, head.section)):
            out = Spot(BEYOND, head.exit, head.exit, 1e9)
            train.under.append(out if beyond is None else self.into(lane, beyond, head.exit))
            train.done = 0.0
        elif head.section in train.turns and len(train.under) == 1:
            berth = SectionId(head.section) in self.topo.berths
            if (berth and train.done >= head.metres) or lane.is_on(names.CAME(head.section, head.exit)):
                train.turns.discard(head.section)
                train.under[:] = [Spot(head.section, head.exit, head.entry, head.metres)]
                train.done = min(head.metres, train.length_m)
