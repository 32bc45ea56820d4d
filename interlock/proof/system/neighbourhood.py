"""Where on the railway a variable belongs, so that questions about one place can be asked one after the other.

A solver is quickest when a question is like the one before it.  Sections are numbered by a walk over the track that
goes on from a section to its neighbours before it comes back to a branch.

**Theorem.**  Each question is asked of lines of the system, whatever is said here of places: order and grouping of
questions decide how long they take, never what follows.  (Weakening of premises; as in `abstraction/focus.py`.)
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property

from interlock.dataclass import dataclass
from interlock.logic import names
from interlock.logic.names import Form, Kind, Name, Owner
from interlock.logic.symbols import lamps
from interlock.model.elements import SectionId, SignalId
from interlock.model.traversal import Topology
from interlock.proof.system.loop import ClosedLoop
from interlock.proof.system.relation import TransitionRelation

_AT_SECTIONS = frozenset(
    (
        *(
            names.RESTART_LOCK,
            names.FIRM,
            names.USED,
            names.PASSED,
            names.AT_ONCE,
            names.STALE,
            names.TRAIN_LOCK,
            names.LOCK,
        ),
        *(names.STANDS, names.RESTS, names.CAME, names.ACROSS, names.BEEN, names.SLOW),
    )
)
"""What is known of a section and the train in it: the places of the induction."""

_AT_HOME = _AT_SECTIONS | frozenset(
    (
        *(names.CLEAR, names.IMAGE, names.RUNNING, names.OVERRAN, names.LOCKED_SHOWN),
        *(names.LIES, names.OLD_COMMAND, names.DRIVE),
        *(names.ACCEPTED, names.SHUNT_ACCEPTED, names.SEEN, names.SHUNT_SEEN, names.FAST),
        *(names.STOP_LONG, names.APPROACH_OVER),
        *(
            names.CLEAR_ASPECT,
            names.CAUTION_ASPECT,
            names.CALL_ASPECT,
            names.IDENTIFIER_ASPECT,
            names.SHUNT_ASPECT,
            names.STOP_ASPECT,
        ),
    )
)
"""What belongs to its element although no equation of the controller computes it."""


def walked(topo: Topology) -> dict[SectionId, int]:
    """The sections in the order of the walk."""
    order: dict[SectionId, int] = {}
    for start in topo.sections:
        todo = [start]
        while todo:
            s = todo.pop()
            if s not in order:
                order[s] = len(order)
                todo += [t for j in topo.ends[s] if (t := topo.beyond(s, j)) is not None]
    return order


@dataclass(frozen=True)
class RouteVariables:
    """Which variables are those of routes.

    indexed: what each means, and the route's number.  requests: inputs that have the numbers of routes for values.
    """

    indexed: Mapping[Name, tuple[Name, int]]
    requests: tuple[Name, ...] = ()


class Neighbourhood:
    """To which routes and elements of the railway the variables of a step belong."""

    def __init__(self, loop: ClosedLoop, relation: TransitionRelation) -> None:
        self._loop, self._relation, self._symbols = loop, relation, loop.controller.symbols

    @cached_property
    def _known(self) -> dict[Name, None]:
        """All names but those of inputs."""
        return dict.fromkeys((*self._relation.state, *self._relation.definitions))

    @cached_property
    def routes(self) -> RouteVariables:
        """The variables of routes, before and after a step."""
        asked = self._symbols.requests
        return RouteVariables(
            {name: (names.each(name), name.number) for name in self._known if name.family.kind is Kind.ROUTE},
            tuple(x for x in (asked.request, asked.local_request) if x is not None),
        )

    @cached_property
    def lamps(self) -> frozenset[Name]:
        """What signals show: names of the state."""
        return frozenset(x for x in lamps(self._symbols.aspects) if x in self._known)

    @cached_property
    def places(self) -> Mapping[Name, tuple[int, ...]]:
        """The sections of the variables of sections and routes, before and after a step, by their numbers: near ones
        have numbers that lie together."""
        order: dict[str, int] = {str(s): n for s, n in walked(self._loop.topo).items()}
        routes = self._symbols.routes
        kept = {r.number: (r.active, r.locked, r.want, r.proceed, r.shown, names.SHUT(r.number)) for r in routes}
        over = {name: tuple(order[s] for s, _ in r.path.ways) for r in routes for name in kept[r.number]}
        found: dict[Name, tuple[int, ...]] = {}
        for name in self._known:
            state = name.base if name.primed else name
            if state in over:
                found[name] = over[state]
            elif state.form is None and state.family in _AT_SECTIONS and (owner := state.owner) is not None:
                at = order.get(owner.id)
                if at is not None:
                    found[name] = (at,)
        return found

    @cached_property
    def homes(self) -> Mapping[Name, Owner]:
        """The element to which names belong, as the groups of the controller's equations are called; none of routes.

        What the controller computes and what is known of an element belong to it, what is remembered of a timer where
        it does, and an input to the only element that reads it.
        """
        controller, topo, inputs = self._loop.controller, self._loop.topo, self._relation.inputs
        computed = {e.name for e in (*controller.equations, *controller.next)}
        before = self._symbols.cancellation.approach_of
        found: dict[Name, Owner] = {}
        for name in dict.fromkeys((*self._known, *inputs)):
            state = name.base if name.primed else name
            covered = state.form is Form.COVERED
            own = state.base if covered else state
            if own.family is names.STAND_LONG or (covered and own.family is names.STANDING):
                found[name] = Owner.of(Kind.SECTION, str(before.get(SignalId(str(own.at[0])))))
                continue
            owner = own.owner
            if owner is None or owner.kind is Kind.ROUTE or own.form is not None:
                continue
            if own in computed or (
                own.family in _AT_HOME and (owner.kind is not Kind.SECTION or owner.id in topo.ends)
            ):
                found[name] = owner
        readers: dict[Name, set[Owner]] = {}
        for name, read in self._relation.reads.items():
            home = found.get(name)
            if home is not None:
                for v in read:
                    readers.setdefault(v, set()).add(home)
        for name in inputs:
            those = readers.get(name, ())
            if len(those) == 1:
                found.setdefault(name, next(iter(those)))
        return found

    @cached_property
    def beside(self) -> Mapping[Owner, tuple[Owner, ...]]:
        """The elements of which another is a part: the sections of each machine, beyond each signal and first in each
        overlap."""
        layout = self._loop.layout
        found: dict[tuple[Kind, str], tuple[SectionId, ...]] = {}
        found |= {(Kind.MACHINE, m): layout.machines.sections[m] for m in layout.machines}
        found |= {(Kind.SIGNAL, g.id): (layout.track.section_of(g.into),) for g in layout.signalling.signals}
        found |= {(Kind.OVERLAP, g): (ways[0][0],) for (g, _), ways in self._symbols.overlaps.ways.items()}
        return {Owner.of(*x): tuple(Owner.of(Kind.SECTION, s) for s in those) for x, those in found.items()}
