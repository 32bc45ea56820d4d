"""The plant of a layout: points, movements, next states, images, hazards."""

from __future__ import annotations

from collections.abc import Mapping
from itertools import pairwise

from interlock.logic import names
from interlock.logic.expr import FALSE, TRUE, Expr, at_most_one, conj, disj, iff, implies, neg, var
from interlock.logic.plant.block import neighbour, on_the_line
from interlock.logic.plant.called import ShortEnds, speeds_called
from interlock.logic.plant.hazards import hazards
from interlock.logic.plant.images import images
from interlock.logic.plant.kinds import ASSUMPTIONS, Assumption, Plant, Wiring
from interlock.logic.plant.machines import machines
from interlock.logic.plant.reversals import reversals
from interlock.logic.plant.standing import Entries, Standing, functions
from interlock.logic.plant.words import (
    accepted,
    across,
    came,
    image,
    lamp,
    lies,
    line,
    o,
    old_command,
    overran,
    parted,
    rests,
    running,
    shunting,
    was_called,
)
from interlock.model.elements import Boundary, BoundaryKind, MachineId, NodeId, Position, SectionId, Signal, SignalId
from interlock.model.layout import Layout
from interlock.model.measured import Measured
from interlock.model.overlap import ends_at
from interlock.model.traversal import topology


class PlantBuilder:
    """Builds the plant of a layout."""

    def __init__(self, layout: Layout, read: Measured, wiring: Wiring, dropped: frozenset[str]) -> None:
        self.layout = layout
        self._fouls = read.fouls
        self._in_time = read.needs.swings
        self.topo = topology(layout)
        self.w = wiring
        self.dropped = dropped
        self._shunts = any(g.shunt for g in layout.signalling.signals)
        self._overlaps = {g: self.topo.paths(ways) for g, ways in read.overlaps.items()}
        self._shorts = ShortEnds(read, self._overlaps)
        self._overlapped: dict[SectionId, list[SignalId]] = {}
        for g_, paths in self._overlaps.items():
            for s in dict.fromkeys(t.section for path in paths for t in path):
                self._overlapped.setdefault(s, []).append(g_)
        self.standing = Standing(layout, self.topo, self._overlapped)
        self._before = {b: gs for b in self.topo.sections if (gs := self._overlapped_ahead(b))}
        self.p = Plant()
        self.entries = Entries(layout, self.topo, self._overlapped, self.p.events)

    def _overlapped_ahead(self, s: SectionId) -> list[SignalId]:
        """The signals with an overlap before which a train in s may come to a stand."""
        return [g for g in self.topo.signals_out(s) if g in self._overlaps]

    def build(self) -> Plant:
        """All parts in order."""
        machines(self)
        tokens = [b for b in self.layout.track.boundaries if b.node in self.w.token]
        for b in tokens:
            neighbour(self, b)
        self._movements()
        self._states()
        for b in tokens:
            s = self.layout.track.section_of(self.layout.track.edges_at[b.node][0].id)
            on_the_line(self, b, self.p.events.get(names.HEAD(b.node, s), FALSE))
        images(self)
        self.p.hazards.extend(hazards(self, self._fouls))
        return self.p

    # --- small pieces --------------------------------------------------------------------------

    def choice(self, name: names.Name, text: str) -> Expr:
        """A free choice of the world: whether that happens."""
        chosen = names.choice(name)
        self.p.choices[chosen] = text
        return var(chosen)

    def clock(self, long: names.Name, hold: Expr, text: str) -> Expr:
        """A clock of the world: what tells, in this step, that `hold` has held without a break for long enough.

        How long that is the model does not say: from the moment at which `hold` begins to be true the world may choose
        when, and once chosen it stays so while `hold` lasts.  Every real duration is one of these choices.
        """
        self.p.clocks[long] = hold
        self.p.state[long] = text
        over = conj((hold, disj((var(long), self.choice(long, text)))))
        self.p.next[long] = over
        return over

    def _rear(self, g: SignalId) -> tuple[NodeId, SectionId, SectionId | None]:
        """Joint, section beyond and section in rear (None: outside without detection) of a signal."""
        signal = self.layout.signalling.signal[g]
        first = self.layout.track.section_of(signal.into)
        boundary = self.layout.track.boundary_at.get(signal.node)
        if boundary is not None:
            return signal.node, first, boundary.approach
        return signal.node, first, self.topo.beyond(first, signal.node)

    def shown(self, g: SignalId, shunt: bool) -> Expr:
        """What the controller shows at a signal, to trains or to shunting movements."""
        return (self.w.call if shunt else self.w.proceed).get(g, FALSE)

    def seen(self, g: SignalId, shunt: bool) -> Expr:
        """A driver may see proceed: shown in the last scan, or in the one before (A-LATE-OUTPUT)."""
        return disj((self.shown(g, shunt), lamp(g, shunt)))

    # --- movements -----------------------------------------------------------------------------

    def _movements(self) -> None:
        topo = self.topo
        for s in topo.sections:
            for j in topo.ends[s]:
                if j in self.layout.track.buffer_at:
                    continue
                ahead = topo.beyond(s, j)
                g = topo.signal_into.get((j, ahead)) if ahead is not None else None
                self._head(s, j, g)
                self._tail(s, j, ahead)
        for b in self.layout.track.boundaries:
            self._enters(b)
        for g_ in self.layout.signalling.signals:
            self._ready(g_)
        for s in topo.sections:
            reversals(self, s)

    def _enters(self, b: Boundary) -> None:
        """A train comes to a boundary, accepts its signal, and enters, head and tail."""
        topo = self.topo
        if b.kind is BoundaryKind.OUT:
            return
        s = self.layout.track.section_of(self.layout.track.edges_at[b.node][0].id)
        g = topo.signal_into.get((b.node, s))
        if g is None:
            return
        outside = b.approach or names.outside(b.node)
        scanned = image(outside) if b.approach and "A-SCAN" not in self.dropped else TRUE
        free = neg(across(b.node, outside)) if "A-HEADWAY" not in self.dropped else TRUE
        calls = disj(accepted(g, k) for k in functions(self.layout, g))
        self.p.events[names.HEAD(b.node, outside)] = conj(
            (
                o(outside),
                neg(across(b.node, outside)),
                calls if "A-OBEY" not in self.dropped else TRUE,
                scanned,
                self.choice(names.HEAD(b.node, outside), f"a train enters at {b.node}"),
            )
        )
        if True in functions(self.layout, g):
            self.p.events[names.SHUNTS(b.node, outside)] = conj(
                (self.p.events[names.HEAD(b.node, outside)], accepted(g, True))
            )
        self.p.events[names.TAIL(b.node, outside)] = conj(
            (
                across(b.node, outside),
                image(s) if "A-SCAN" not in self.dropped else TRUE,
                self.choice(names.TAIL(b.node, outside), f"its tail enters at {b.node}"),
            )
        )
        sent = line(b.node, "in") if b.node in self.w.token else TRUE
        # none is there, or the tail of the one before is just coming in: so a train may follow close behind another
        room = disj((neg(o(outside)), self.p.events[names.TAIL(b.node, outside)]))
        self.p.events[names.APPEARS(outside)] = conj(
            (room, sent, self.choice(names.APPEARS(outside), f"a train comes to {b.node}"))
        )
        self._accept(g, conj((o(outside), free)))

    def _ready(self, g: Signal) -> None:
        """What stands before a signal inside the layout may accept it."""
        node, first, rear = self._rear(g.id)
        if node in self.layout.track.boundary_at or rear is None:
            return
        ready = conj(
            (
                o(rear),
                TRUE
                if self.standing.berth(rear)
                else disj((self.standing.stood(rear, node), self.standing.heading(rear, node))),
                neg(across(node, rear)) if "A-HEADWAY" not in self.dropped else TRUE,
                neg(across(node, first)),
                neg(self.standing.astray(rear)),  # what has overrun a signal is moved under local rules
                neg(self.standing.parted(rear)),
            )
        )
        self._accept(g.id, ready)

    def _accept(self, g: SignalId, ready: Expr) -> None:
        for k in functions(self.layout, g):
            event = names.accepts(g, k)
            what = "shunt aspect" if k else "proceed"
            accepts = self.choice(event, f"a driver accepts the {what} of {g}")
            self.p.events[event] = conj((ready, self.seen(g, k), accepts))
        self.p.events[names.REFUSES(g)] = self.choice(names.REFUSES(g), f"the train before {g} stops after all")

    def _head(self, s: SectionId, j: NodeId, g: SignalId | None) -> None:
        scanned = image(s) if "A-SCAN" not in self.dropped else TRUE
        heading = self.standing.heading(s, j)
        called_heading = TRUE if self.standing.berth(s) else heading
        called = FALSE if g is None else disj(conj((called_heading, accepted(g, k))) for k in functions(self.layout, g))
        passes: Expr = FALSE  # without a signal to obey
        if g is None or not self.layout.signalling.signal[g].main:
            free = neg(rests(s)) if "A-RESTART" not in self.dropped else TRUE
            if "A-PARTED" not in self.dropped:
                free = conj((free, neg(self.standing.parted(s))))
            obeys = g is not None or self.topo.beyond(s, j) is None
            as_train = neg(shunting(s)) if self._shunts and obeys else TRUE
            passes = conj((free, as_train, heading))
        if g is not None and "A-OBEY" in self.dropped:
            called = called_heading
        running_over = self._overruns(s, j, g, heading)
        overruns = disj(running_over.values())
        head = conj(
            (
                o(s),
                neg(across(j, s)),
                disj((called, passes, overruns)),
                scanned,
                self.choice(names.HEAD(j, s), f"the head of the train in {s} goes {self._to(s, j)}"),
            )
        )
        self.p.events[names.HEAD(j, s)] = head
        for h, x in running_over.items():
            self.p.events[names.OVERRUNS(h, j, s)] = conj((head, x, neg(disj((called, passes)))))
        if self._shunts:
            by_call = FALSE if g is None or not self.layout.signalling.signal[g].shunt else accepted(g, True)
            goes_on = conj((passes, shunting(s))) if g is None else FALSE
            self.p.events[names.SHUNTS(j, s)] = conj((head, disj((by_call, goes_on))))

    def _overruns(self, s: SectionId, j: NodeId, g: SignalId | None, heading: Expr) -> dict[SignalId, Expr]:
        """For each signal: a train fails to stop before it, or runs on within its overlap (A-OVERRUN)."""
        ahead = self.topo.beyond(s, j)
        out: dict[SignalId, Expr] = {}
        for h in self._overlapped.get(s, ()):
            steps = (x for path in self._overlaps[h] for x in pairwise(path))
            if any(a.section == s and a.exit == j and b.section == ahead for a, b in steps):
                out[h] = conj((overran(h, s), rests(s), heading, neg(self._shorts.stops(h, s, j))))
        if g is not None and g in self._overlaps:
            as_train = neg(shunting(s)) if self._shunts else TRUE
            turning = FALSE if "A-SWING" in self.dropped else disj(self._turning(g))
            fails = conj((running(s), neg(rests(s)), neg(self.standing.parted(s)), as_train, heading, neg(turning)))
            self.p.events[names.FAILS(g)] = fails
            out[g] = disj((out.get(g, FALSE), self.p.events[names.FAILS(g)]))
        return out

    def _turning(self, g: SignalId) -> list[Expr]:
        """For each machine of an overlap that swings: it turns since before a train was reported before the signal."""
        if g not in self._in_time:
            return []
        over = [t for path in self._overlaps[g] for t in path]
        machines = [self.layout.pointwork.point[p].machine for t in over for p, _ in t.points]
        machines += [MachineId(d.id) for d in self.layout.signalling.devices if any(t.section in d.over for t in over)]
        return [var(names.TURNS_SINCE(g, m)) for m in dict.fromkeys(machines)]

    def _turns_since(self, g: SignalId, s: SectionId) -> None:
        """Which machines of an overlap were driven away before a train came into the section before its signal."""
        for x in self._turning(g):
            m = MachineId(str(x.name.at[1]))
            towards = [Position.REVERSE] if m in self.layout.machines.device else list(Position)  # a device: it closes
            away = disj(conj((self.w.command[m, p], disj((neg(lies(m, p)), old_command(m, p.other))))) for p in towards)
            self.p.state[x.name] = f"machine {m} turns since before a train was reported in {s}"
            self.p.next[x.name] = conj((away, disj((x, neg(o(s)), neg(image(s))))))
            self.p.initial.append(neg(x))

    def _tail(self, s: SectionId, j: NodeId, ahead: SectionId | None) -> None:
        others = [k for k in self.topo.ends[s] if k != j]
        inside = conj(neg(self.standing.coming(s, k)) for k in others)
        if self.standing.berth(s):  # others may be coming in there, unless one train lies across
            inside = disj((inside, neg(self.standing.astray(s))))
        scanned = image(ahead) if ahead is not None and "A-SCAN" not in self.dropped else TRUE
        leaves = self.choice(names.TAIL(j, s), f"its tail leaves {s}")
        self.p.events[names.TAIL(j, s)] = conj((across(j, s), inside, scanned, leaves))

    def _to(self, s: SectionId, j: NodeId) -> str:
        """Where a train goes over an end, in words."""
        ahead = self.topo.beyond(s, j)
        return f"on into {ahead}" if ahead is not None else f"out at {j}"

    def _staying(self, s: SectionId) -> Expr:
        """Vehicles remain in a berth although a tail leaves it: left behind, or part of another movement."""
        ends = [j for j in self.topo.ends[s] if j not in self.layout.track.buffer_at]
        out = [conj((across(j, s), neg(self.p.events[names.TAIL(j, s)]))) for j in ends]
        out += [self.p.events[names.HEAD(j, s)] for j in ends]
        into = [self.standing.coming(s, j) for j in ends]
        called = [
            x
            for g in self.topo.signals_out(s)
            for k in functions(self.layout, g)
            for x in (accepted(g, k), self.p.events.get(names.accepts(g, k), FALSE))
        ]
        left = conj((self.choice(names.STAYS_BEHIND(s), f"vehicles stay behind in {s}"), neg(self.standing.astray(s))))
        return disj((left, *out, *into, *called))

    # --- next states ---------------------------------------------------------------------------

    def _states(self) -> None:
        for s in self.topo.sections:
            self._section(s)
        for b in self.layout.track.boundaries:
            self._outside(b)
        for g in self.layout.signalling.signals:
            self._signal(g)
        speeds_called(self, self._shorts)

    def _section(self, s: SectionId) -> None:
        """What stands in a section: whether it rests, was called, has parted, has overrun, runs, shunts."""
        topo, p = self.topo, self.p
        out = disj(p.events[names.TAIL(j, s)] for j in topo.ends[s] if j not in self.layout.track.buffer_at)
        enter = {j: self.entries.comes_in(s, j) for j in topo.ends[s]}
        p.state[names.STANDS(s)] = f"a train stands in {s}"
        parts: Expr = FALSE
        if not self.standing.berth(s):
            chance = self.choice(names.PARTS(s), f"the train parts, and its rear stays in {s}")
            p.events[names.PARTS(s)] = conj((out, chance, neg(self.standing.astray(s))))
            parts = p.events[names.PARTS(s)]
            out = conj((out, neg(parts)))
            p.state[names.PARTED(s)] = f"the rear part of a train has been left in {s}"
            p.next[names.PARTED(s)] = disj((conj((parted(s), neg(out))), parts))
            p.initial.append(neg(parted(s)))
        p.state[names.RESTS(s)] = f"the train in {s} has stood there since the restart"
        if self.standing.berth(s):
            stay = self._staying(s)
            left = conj((out, stay, o(s)))
            out = conj((out, neg(stay)))
            joined = disj(self.entries.shunts_in(s, j) for j in topo.ends[s])
            p.state[names.RESTS(s)] = f"what stands in {s} moves only when a signal calls it"
            p.next[names.RESTS(s)] = disj((conj((rests(s), neg(out))), left, joined))
        else:
            p.next[names.RESTS(s)] = conj((rests(s), neg(out)))
            p.state[names.WAS_CALLED(s)] = f"the train in {s} has been called"
            p.next[names.WAS_CALLED(s)] = conj((disj((self.standing.moves(s), *self.standing.drawn(s))), neg(out)))
            p.initial.append(neg(was_called(s)))
        p.next[names.STANDS(s)] = disj((conj((o(s), neg(out))), *enter.values()))
        p.initial.append(iff(rests(s), o(s)))
        if s in self._overlapped:
            for h in self._overlapped[s]:
                came_over = self.entries.overruns_in(h, s)
                p.state[names.OVERRAN(h, s)] = f"what stands in {s} has overrun {h}"
                stays = conj((overran(h, s), neg(out), neg(self._joined(h, s))))
                p.next[names.OVERRAN(h, s)] = disj((stays, came_over))
                p.next[names.RESTS(s)] = disj((p.next[names.RESTS(s)], came_over))
                p.initial.append(neg(overran(h, s)))
        p.gone[s] = out
        if s in self._before:
            self._running(s, disj((out, parts)), disj(enter.values()))
        if self._shunts:
            p.state[names.SHUNTING(s)] = f"the train in {s} shunts"
            p.next[names.SHUNTING(s)] = disj(
                (
                    conj((shunting(s), neg(disj(enter.values())))),
                    *(self.entries.shunts_in(s, j) for j in topo.ends[s]),
                    self.entries.turns(s),
                )
            )
        self._ends(s, out, enter)

    def _joined(self, h: SignalId, s: SectionId) -> Expr:
        """Vehicles are shunted to what has overrun h, in a berth at the end of its overlap: signals call them all."""
        if not self.standing.berth(s):
            return FALSE
        on = [self.standing.heading(s, j) for j in self.topo.ends[s] if not ends_at(self._overlaps[h], s, j)]
        return conj((disj(self.entries.shunts_in(s, j) for j in self.topo.ends[s]), *map(neg, on)))

    def _ends(self, s: SectionId, out: Expr, enter: Mapping[NodeId, Expr]) -> None:
        """At which end a train has come into a section, and across which it stands; `out`: it leaves the section."""
        topo, p = self.topo, self.p
        for j in topo.ends[s]:
            turned_in = disj(p.events[names.TURNS(s, a, j)] for a in topo.ends[s] if names.TURNS(s, a, j) in p.events)
            turned_out = disj(p.events[names.TURNS(s, j, b)] for b in topo.ends[s] if names.TURNS(s, j, b) in p.events)
            p.state[names.CAME(s, j)] = f"the train in {s} came in at {j}"
            p.next[names.CAME(s, j)] = disj((conj((came(s, j), neg(out), neg(turned_out))), enter[j], turned_in))
            if j in self.layout.track.buffer_at:
                continue
            p.state[names.ACROSS(j, s)] = f"a train stands across {j}, going out of {s}"
            p.next[names.ACROSS(j, s)] = disj(
                (conj((across(j, s), neg(p.events[names.TAIL(j, s)]))), p.events[names.HEAD(j, s)])
            )
        p.initial.append(at_most_one(came(s, j) for j in topo.ends[s]))
        p.initial.append(iff(o(s), disj(came(s, j) for j in topo.ends[s])))
        for j in topo.ends[s]:
            if j in self.layout.track.buffer_at:
                continue
            ahead = topo.beyond(s, j)
            standing = conj((o(s), o(ahead), came(ahead, j))) if ahead is not None else o(s)
            p.initial.append(implies(across(j, s), conj((standing, self.standing.heading(s, j)))))

    def _outside(self, b: Boundary) -> None:
        """A train before a boundary, and across it."""
        p = self.p
        outside = b.approach or names.outside(b.node)
        if names.APPEARS(outside) not in p.events:
            return
        left, came_ = p.events[names.TAIL(b.node, outside)], p.events[names.APPEARS(outside)]
        p.state[names.STANDS(outside)] = f"a train stands before {b.node}"
        p.next[names.STANDS(outside)] = disj((conj((o(outside), neg(left))), came_))
        p.state[names.ACROSS(b.node, outside)] = f"a train stands across {b.node}, coming in"
        p.next[names.ACROSS(b.node, outside)] = disj(
            (conj((across(b.node, outside), neg(left))), p.events[names.HEAD(b.node, outside)])
        )
        s = self.layout.track.section_of(self.layout.track.edges_at[b.node][0].id)
        p.initial.append(implies(across(b.node, outside), conj((o(outside), o(s), came(s, b.node)))))

    def _signal(self, g: Signal) -> None:
        """Who has accepted a signal, and what it showed one scan ago."""
        p = self.p
        node, _, rear = self._rear(g.id)
        behind = rear or names.outside(node)
        for k in functions(self.layout, g.id):
            accept = names.accepts(g.id, k)
            if accept not in p.events:
                continue
            go, shows = names.accepted(g.id, k), names.seen(g.id, k)
            who, what = ("a shunting movement", "the shunt aspect") if k else ("a train", "proceed")
            p.state[go] = f"{who} has accepted {g.id}"
            p.next[go] = conj(
                (
                    disj((accepted(g.id, k), p.events[accept])),
                    neg(p.events[names.REFUSES(g.id)]),
                    neg(p.events[names.HEAD(node, behind)]),
                )
            )
            p.initial.append(neg(accepted(g.id, k)))
            p.state[shows] = f"{g.id} showed {what} one scan ago"
            p.next[shows] = self.shown(g.id, k)
            if "A-LATE-OUTPUT" in self.dropped:
                stuck = self.choice((names.SHUNT_STUCK if k else names.STUCK)(g.id), f"{g.id} goes on showing {what}")
                p.next[shows] = disj((p.next[shows], conj((lamp(g.id, k), stuck))))

    def _running(self, s: SectionId, out: Expr, enters: Expr) -> None:
        """A train that came in runs until it stands, turns, or is gone (`out`: or only its rear part is left)."""
        topo, p = self.topo, self.p
        shunts = disj(self.entries.shunts_in(s, j) for j in topo.ends[s]) if self._shunts else FALSE
        stands: Expr = FALSE
        for g in self._before[s]:
            j = self.layout.signalling.signal[g].node
            comes = [
                conj(
                    (
                        self.entries.comes_in(s, k),
                        neg(self.entries.shunts_in(s, k)),
                        neg(self.entries.overrun_over(s, k)),
                    )
                )
                for k in topo.ends[s]
                if k != j
            ]
            long = self.clock(
                names.STAND_LONG(g), neg(disj(comes)), f"the train before {g} has had time to come to a stand"
            )
            if "A-STAND" not in self.dropped:
                stands = disj((stands, long))
                first = self.p.events.get(names.FAILS(g), FALSE)
                over = self.p.events.get(names.OVERRUNS(g, j, s), FALSE)
                self.assume("A-STAND", implies(long, neg(conj((over, first)))))
            self._turns_since(g, s)
        p.state[names.RUNNING(s)] = f"the train in {s} has not come to a stand"
        still = conj((running(s), neg(out), neg(self.entries.turns(s)), neg(stands)))
        p.next[names.RUNNING(s)] = conj((disj((still, enters)), neg(shunts)))
        p.initial.append(neg(running(s)))

    def assume(self, id_: str, expr: Expr) -> None:
        """The world does so, unless the assumption is dropped."""
        if id_ not in self.dropped:
            self.p.assumptions.append(Assumption(id_, ASSUMPTIONS[id_], expr))


def build_plant(layout: Layout, read: Measured, wiring: Wiring, dropped: frozenset[str] = frozenset()) -> Plant:
    """The plant of a layout without lengths, of which `read` tells; `dropped`: assumptions to leave out."""
    return PlantBuilder(layout, read, wiring, dropped).build()
