"""How many trains a zone holds: the claim's own count, which shares nothing with the controller's.

**Theorem.**  After i of the things to be counted, the k-th bit says that at least k of them are so: by induction over
i, since at least k are so if at least k of those before are, or at least k - 1 of them and the i-th.  (Sequential
counter: Sinz, *Towards an Optimal CNF Encoding of Boolean Cardinality Constraints*, 2005.)
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

from interlock.logic import names
from interlock.logic.expr import FALSE, Expr, conj, disj, neg, var
from interlock.logic.names import Name
from interlock.logic.plant import across, o
from interlock.model.elements import NodeId, SectionId, Zone
from interlock.model.traversal import zone_joints
from interlock.proof.system.loop import ClosedLoop


class Zones:
    """The count of every zone in a step."""

    def __init__(self, loop: ClosedLoop, after: Callable[[Expr], Expr]) -> None:
        self._topo, self._after = loop.topo, after
        self._ways = loop.controller.symbols.sections.locks_of
        zones = loop.layout.declared.zones
        self.definitions: dict[Name, Expr] = {}
        """The wires of the counts."""
        for z in zones:
            self.definitions |= self._count(z)
        too_full = {z.id: names.OVERFULL(z.id) for z in zones}
        self.overfull: Mapping[str, Expr] = {z: var(name) for z, name in too_full.items() if name in self.definitions}
        """Of each zone that can be so: a train is called into it, and then there are more than its maximum."""

    def called_in(self, s: SectionId, j: NodeId) -> Expr:
        """A section is locked for a train that comes in at j and has not come yet."""
        locked = disj(var(name) for n, name in self._ways.get(s, []) if self._topo.traversals[s][n - 1].entry == j)
        return conj((locked, neg(var(names.BEEN(s)))))

    def _count(self, z: Zone) -> dict[Name, Expr]:
        """`zone.ID`: a train is called into a zone in this step, and with those that are in it or called into it there
        are more than its maximum.

        A train counts in the rearmost of its sections in the zone.
        """
        joints = zone_joints(self._topo, z)
        items: list[Expr] = []
        for s in z.sections:
            inner = [(j, r) for j in self._topo.ends[s] if (r := self._topo.beyond(s, j)) in z.sections]
            rearmost = conj((o(s), *(neg(across(j, str(r))) for j, r in inner)))
            items.append(disj((rearmost, *(self.called_in(s, j) for t, j in joints if t == s))))
        called = [conj((self._after(self.called_in(s, j)), neg(self.called_in(s, j)))) for s, j in joints]
        items += called
        out: dict[Name, Expr] = {}
        before: list[Expr] = []
        for i, x in enumerate(items, 1):
            now: list[Expr] = []
            for k in range(1, min(i, z.trains + 1) + 1):
                more = x if k == 1 else conj((before[k - 2], x))
                name = names.ZONE_SUM(z.id, i, k)
                out[name] = disj((more, before[k - 1])) if k <= len(before) else more
                now.append(FALSE if out[name] is FALSE else var(name))
            before = now
        out[names.OVERFULL(z.id)] = conj((before[z.trains], disj(called))) if len(before) > z.trains else FALSE
        return {name: x for name, x in out.items() if x is not FALSE}
