"""What a panel shows: what never changes (`still`), and after each scan one value for each element (`Picture`).

Keys: `s:` section, `m:` machine, `g:` signal, `o:` overlap of a signal, `c:` condition, `z:` zone, `b:` direction at a
boundary, `a:` automatic working of a route.  Values are lists that are compared and sent as they are; the page knows
their order (page/panel.js).
"""

from __future__ import annotations

from collections.abc import Container, Mapping
from math import ceil
from typing import Any

from interlock.app.alarms import to_release
from interlock.app.reasons import Moment, Reasons
from interlock.app.run import Ready
from interlock.emit.drawing import plan_svg
from interlock.emit.drawing.place import place
from interlock.field.plc import Cycle
from interlock.logic.controller import Controller
from interlock.logic.names import Name
from interlock.logic.symbols import Symbols
from interlock.model.elements import BlockKind, MachineId, PointId, Position, SignalId
from interlock.model.layout import Layout
from interlock.model.traversal import topology
from interlock.panel.simulated import SimulatedField
from interlock.simulate.track import Beyond
from interlock.simulate.world import World
from interlock.table.cells import ExitKind
from interlock.table.printed import Printed, PrintedRoute
from interlock.table.rows import InterlockingTable, RouteRow

Shown = dict[str, Any]


def still(ready: Ready, field: SimulatedField | None) -> dict[str, Any]:
    """Everything that never changes while a panel runs."""
    layout, table, controller = ready.layout, ready.table, ready.controller
    assert layout is not None and table is not None and controller is not None and ready.allocation is not None
    drawing, ways_of = place(layout), Printed(table).ways
    topo, y = topology(layout), controller.symbols
    edges = {str(e.id): [e.length, int(drawing.edges[e.id][0] == drawing.at[e.a])] for e in layout.track.edges}
    ways = {
        str(s): {k: [str(e) for e in topo.traversals[s][k - 1].edges] for k, _ in y.sections.locks_of.get(s, [])}
        for s in y.sections.restart
    }
    return {
        "name": layout.name,
        "title": layout.printed.title or layout.name,
        "profile": layout.profile,
        "plan": plan_svg(layout, drawing),
        "edges": edges,
        "sections": {str(s.id): _section(layout, ways, str(s.id)) for s in layout.track.sections},
        "machines": _machines(layout, controller),
        "signals": _signals(layout, controller, table),
        "routes": [_route(r, table, _with_overlap(r, ways_of[r.id])) for r in table.routes],
        "overlaps": {
            f"{g}.{k}": [str(e) for s, n in over for e in topo.traversals[s][n - 1].edges]
            for (g, k), over in y.overlaps.ways.items()
        },
        "conditions": {str(c.id): [c.text, y.condition[c.id]] for c in layout.signalling.conditions},
        "zones": [z.id for z in layout.declared.zones],
        "boundaries": {str(b.node): _boundary(layout, str(b.node)) for b in layout.track.boundaries},
        "stations": list(ready.allocation.stations),
        "voyages": [v.name for v in table.voyages],
        "swings": [str(g) for g in y.overlaps.swing_request],
        "simulated": field is not None,
        "stands": {} if field is None else {s: [x for _, x in p] for s, p in field.stock.places().items()},
        "lamps": {} if field is None else field.faults.lamp_inputs(),
    }


def _section(layout: Layout, ways: Mapping[str, Any], s: str) -> dict[str, Any]:
    one = layout.track.section[s]  # type: ignore[index]
    return {
        "edges": [str(e.id) for e in layout.track.edges if e.section == s],
        "ways": ways.get(s, {}),
        "approach": one.approach,
        "detected": one.detected,
        "label": layout.printed.labels.get(s, ""),
    }


def _machines(layout: Layout, controller: Controller) -> dict[str, dict[str, Any]]:
    found: dict[str, dict[str, Any]] = {}
    for m in layout.machines:
        ends = layout.machines.ends.get(m, ())
        found[str(m)] = {
            "points": [{"id": str(p.id), "toe": str(p.toe), "N": str(p.normal), "R": str(p.reverse)} for p in ends],
            "hand": (m, Position.NORMAL) in controller.symbols.machines.by_hand,
            "device": not ends,
            "called": _called(layout, m),
            "ends": _ends(layout, m),
            "lies": {str(x): layout.machines.word(m, x) for x in Position},
            "move": {str(x): layout.machines.order(m, x) for x in Position},
            "trailed": "run over, or its detection lost" if layout.machines.is_derailer(m) else "trailed",
        }
    return found


def _ends(layout: Layout, m: MachineId) -> list[str]:
    """What a machine works by other names than its own."""
    blades = {b.point for b in layout.pointwork.blades}
    return [str(p.id) for p in layout.machines.ends.get(m, ()) if str(p.id) != m and p.id not in blades]


def _called(layout: Layout, m: MachineId) -> str:
    """A machine with its kind, and with what it works by other names: `points 201 (KP, derailer GD)`."""
    if m in layout.machines.device:
        return f"{layout.machines.device[m].kind} {m}"
    alone, point = layout.machines.is_derailer(m), layout.pointwork.point
    told = [n if alone or not point[PointId(n)].derailer else f"derailer {n}" for n in _ends(layout, m)]
    return f"{'derailer' if alone else 'points'} {m}" + (f" ({', '.join(told)})" if told else "")


def _signals(layout: Layout, controller: Controller, table: InterlockingTable) -> dict[str, dict[str, Any]]:
    entries = {r.entry for r in table.routes}
    found: dict[str, dict[str, Any]] = {
        str(g.id): {
            "kind": str(g.kind),
            "entry": g.id in entries,
            "cancel": g.id in controller.symbols.cancellation.cancel,
            "calls": g.id in controller.symbols.aspects.call_on,
        }
        for g in layout.signalling.signals
    }
    distant = {"kind": "distant", "entry": False, "cancel": False, "calls": False}
    found |= {str(d.id): distant for d in layout.signalling.distants}
    return found


def _boundary(layout: Layout, node: str) -> dict[str, Any]:
    b = layout.track.boundary_at[node]  # type: ignore[index]
    return {"label": layout.printed.labels.get(node, node), "comes": str(b.kind) != "out", "approach": b.approach}


def _with_overlap(r: RouteRow, way: PrintedRoute) -> str:
    """What tells a route from the others over its way, to an operator: its overlap, and the speed that it shows."""
    if not way.several or r.locking.overlap is None:
        return ""
    over = ", ".join(dict.fromkeys(s for s, _ in r.locking.overlap.ways))
    kmh = r.signal.speed.kmh
    return f"overlap {over}" if kmh is None else f"overlap {over}; {kmh} km/h"


def _route(r: RouteRow, table: InterlockingTable, overlap: str) -> dict[str, Any]:
    parts = table.parts(r)
    last = parts[-1]
    kind = {ExitKind.SIGNAL: "signal", ExitKind.BOUNDARY: "boundary", ExitKind.BUFFER: "buffer"}.get(
        last.path.exit_kind
    )
    return {
        "id": str(r.id),
        "names": list(r.names),
        "kind": str(r.kind),
        "entry": str(r.entry),
        "exit": [kind or "section", str(last.exit)],
        "sections": [str(s) for s in dict.fromkeys(s for p in parts for s in p.path.section_ids)],
        "automatic": r.id in table.automatic,
        "overlap": overlap,
    }


class _Held:
    """What holds machines where they lie, as the controller's own condition has it; looked at anew where what is
    remembered has changed."""

    def __init__(self, layout: Layout, controller: Controller) -> None:
        self._reasons = Reasons(layout, controller)
        self._of: dict[str, list[MachineId]] = {}
        for m in layout.machines:
            for name in self._reasons.of_hold_read(m):
                self._of.setdefault(name, []).append(m)
        self._state: Mapping[str, bool] = {}
        self.why: dict[str, str] = {}
        """By machine what holds it; empty where nothing does."""

    def after(self, cycle: Cycle) -> None:
        """A cycle has ended."""
        before, self._state = self._state, cycle.memory.state
        if before == self._state:
            return
        moment = Moment(cycle.inputs, cycle.memory, 0)
        changed = [n for n, is_so in self._state.items() if before.get(n) is not is_so]
        for m in dict.fromkeys(m for n in changed for m in self._of.get(n, ())):
            self.why[str(m)] = "; ".join(r.text for r in self._reasons.of_hold(m, moment))


class _Uncounted:
    """Sections of zones in which somebody stands whom the limit does not count: the controller counts locks (R17), and
    there is none where a train was put on the track, or came into it, without a route."""

    def __init__(self, layout: Layout, y: Symbols) -> None:
        self._clear, over = y.sections.clear, _over(y)
        self._zones: dict[str, dict[str, list[Name]]] = {}
        for z in layout.declared.zones:
            self._zones[z.id] = {
                str(s): [
                    *([y.sections.restart[s]] if s in y.sections.restart else []),
                    *(n for _, n in y.sections.locks_of.get(s, [])),
                    *(n for _, n in over.get(str(s), ())),
                ]
                for s in z.sections
            }

    def unlocked(self, section: str, state: Mapping[str, bool]) -> list[str]:
        """The zones of a section in which nothing is locked."""
        those = [(z, held[section]) for z, held in self._zones.items() if section in held]
        return [z for z, held in those if not any(state.get(n) for n in held)]

    def of(self, zone: str, cycle: Cycle) -> list[str]:
        """Sections of a zone that are reported occupied, and not locked."""
        occupied = [s for s in self._zones[zone] if cycle.valid and not cycle.inputs.get(self._clear.get(s, ""), 1)]  # type: ignore[call-overload]
        return [s for s in occupied if zone in self.unlocked(s, cycle.memory.state)]


LOST, CALLED = 1, 2
"""Why a locked section's detection is not relied on: inputs were lost while it was locked, or a train is called on."""


class _NotReliedOn:
    """Why of each section its detection is not relied on; the controller has one bit for both."""

    def __init__(self, y: Symbols) -> None:
        self._stale = y.sections.stale
        self._called: dict[str, list[Name]] = {}
        for r in y.routes:
            for s, _ in r.path.ways if r.call_on else ():
                self._called.setdefault(str(s), []).append(r.active)
        self._before: Mapping[str, bool] = {}
        self.why: dict[str, int] = {}
        """By section."""

    def after(self, cycle: Cycle) -> None:
        """A cycle has ended."""
        before, now = self._before, cycle.memory.state
        self._before = now
        for s, name in self._stale.items():
            if not now.get(name):
                self.why.pop(str(s), None)
            elif not cycle.valid:
                self.why[str(s)] = LOST
            elif s not in self.why:
                is_called = any(now.get(n) and not before.get(n) for n in self._called.get(str(s), ()))
                self.why[str(s)] = CALLED if is_called else LOST


def _over(y: Symbols) -> dict[str, list[tuple[str, Name]]]:
    """By section the overlaps over it: the signal, and what tells that it is held."""
    over: dict[str, list[tuple[str, Name]]] = {}
    for option, name in y.overlaps.held.items():
        for s in dict.fromkeys(s for s, _ in y.overlaps.ways[option]):
            over.setdefault(str(s), []).append((str(option[0]), name))
    return over


def _awaited(y: Symbols) -> dict[str, list[str]]:
    """By section the approach timers of the signals into it."""
    before: dict[str, list[str]] = {}
    for g, routes in y.routes.of_signal.items():
        if g in y.cancellation.approach_timer:
            before.setdefault(routes[0].path.ways[0][0] if routes[0].path.ways else "", []).append(
                y.cancellation.approach_timer[g]
            )
    return before


_Signal = tuple[
    str,
    tuple[tuple[str, Name], ...],
    Name | None,
    Name | None,
    tuple[tuple[str, Name, Name], ...],
    Name | None,
    tuple[tuple[int, Name], ...],
    tuple[tuple[str, Name], ...],
]
"""A signal, lamps by word, cancellation, approach locking, its routes (name, set, locked), proof of its stop lamp, what
its speed indicator shows in km/h, and other marks beside it: two yellows (UU), the route indicator (B)."""


def _of_signal(y: Symbols, g: SignalId) -> _Signal:
    """What is read of a signal: its lamps, cancellation and approach locking, its routes, its stop lamp, its speeds."""
    return (
        f"g:{g}",
        tuple(
            (word, aspect[g])
            for word, aspect in (
                ("call", y.aspects.call_on),
                ("identifier", y.aspects.identifier),
                ("clear", y.aspects.clear),
                ("caution", y.aspects.caution),
                ("shunt", y.aspects.shunt),
                ("stop", y.aspects.stop),
            )
            if g in aspect
        ),
        y.cancellation.cancelling.get(g),
        y.cancellation.approach_timer.get(g),
        tuple((str(r.id), r.active, r.locked) for r in y.routes.of_signal.get(g, [])),
        y.lamp_proof.stop.get(g),
        tuple((kmh, n) for (of, kmh), n in y.aspects.speed.items() if of == g),
        tuple((mark, of[g]) for mark, of in (("UU", y.aspects.second), ("B", y.aspects.indicator)) if g in of),
    )


class Picture:
    """Makes what is shown from a cycle."""

    def __init__(self, ready: Ready) -> None:
        assert ready.layout is not None and ready.controller is not None and ready.table is not None
        self.layout, self.controller, self.table = ready.layout, ready.controller, ready.table
        y = self.symbols = ready.controller.symbols
        self.presets: dict[str, int] = {t.name: t.preset_ms for t in ready.controller.timers}
        self.to_release = to_release(ready.layout, y)
        """The restart locks that are released by hand."""
        before, over = _awaited(y), _over(y)
        self._sections = [
            (
                f"s:{s}",
                y.sections.clear.get(s),
                self.to_release.get(s),
                y.sections.blocked.get(s),
                tuple(t for t in (y.sections.release_timer.get(s), *before.get(s, [])) if t is not None),
                y.sections.release.get(s),
                tuple(y.sections.locks_of.get(s, [])),
                y.sections.healthy.get(s),
                tuple(over.get(str(s), ())),
            )
            for s in dict.fromkeys((*y.sections.clear, *y.sections.restart))
        ]
        self._held = _Held(ready.layout, ready.controller)
        self._not_relied_on = _NotReliedOn(y)
        self._uncounted = _Uncounted(ready.layout, y)
        self._machines = [
            (
                f"m:{m}",
                tuple(y.machines.detected.get((m, x)) for x in Position),
                tuple(y.machines.command.get((m, x)) for x in Position),
                y.indication.get(f"late {m}"),
                y.machines.trailed.get(m),
            )
            for m in self.layout.machines
        ]
        self._signals = [_of_signal(y, g.id) for g in self.layout.signalling.signals]
        self._distants = [
            (f"g:{d.id}", y.aspects.distant_clear.get(d.id), y.aspects.distant_caution.get(d.id))
            for d in self.layout.signalling.distants
        ]
        self._lamps = [
            f"g:{g}"
            for g in (*(x.id for x in self.layout.signalling.signals), *(x.id for x in self.layout.signalling.distants))
        ]
        self._routes = {r.number: str(r.id) for r in ready.table.routes}
        self._overlaps = [(f"o:{g}.{k}", n) for (g, k), n in y.overlaps.held.items()]

    def left(self, cycle: Cycle, timer: str | None) -> int | None:
        """Seconds until a timer is over; None while it does not run."""
        ran = cycle.memory.elapsed.get(timer or "")
        if timer is None or ran is None:
            return None
        return ceil((self.presets[timer] - ran) / 1000)

    def _longest(self, cycle: Cycle, timers: tuple[str, ...]) -> int | None:
        """Seconds until the last of the timers that run is over."""
        return max((n for t in timers if (n := self.left(cycle, t)) is not None), default=None)

    def of(self, cycle: Cycle, idle: Container[str] = ()) -> Shown:
        """Every element after a cycle; of a lamp, a condition and a line nothing is known while inputs are not valid
        (None).  `idle M` stands in `idle` where machine M is not detected in time, though nobody
        has commanded it."""
        shown: Shown = {}
        self._of_sections(cycle, shown)
        self._of_machines(cycle, shown, idle)
        self._of_signals(cycle, shown)
        state, inputs, y = cycle.memory.state, cycle.inputs, self.symbols
        for key, name in self._overlaps:
            shown[key] = [int(state.get(name, False))]
        for c, name in y.condition.items():
            shown[f"c:{c}"] = [inputs.get(name, 0) if cycle.valid else None]
        for z, name in y.zone_full.items():
            shown[f"z:{z}"] = [int(state.get(name, True)), self._uncounted.of(z, cycle)]
        for b, x in y.token.items():
            clear = inputs.get(x.clear, 0) if cycle.valid else None
            by_hand = [inputs.get(x.manual, 0), self.left(cycle, x.timer)]
            shown[f"b:{b}"] = [int(state.get(x.have, False)), int(state.get(x.give, False)), clear, *by_hand]
        for k, name in y.requests.automatic.items():
            shown[f"a:{self._routes[k]}"] = [inputs.get(name, 0)]
        return shown

    def _of_sections(self, cycle: Cycle, shown: Shown) -> None:
        state, inputs, valid = cycle.memory.state, cycle.inputs, cycle.valid
        self._not_relied_on.after(cycle)
        for key, clear, restart, blocked, timers, release, locks, healthy, over in self._sections:
            occupied = 1 if clear is None or not valid else 1 - inputs.get(clear, 0)
            ways = [k for k, n in locks if state.get(n)]
            releasing = bool(release and inputs.get(release))
            shown[key] = [
                occupied,
                ways,
                int(bool(restart and state.get(restart))),
                int(bool(blocked and inputs.get(blocked))),
                self._not_relied_on.why.get(key[2:], 0) if ways else 0,
                self._longest(cycle, timers) if releasing and not occupied else None,
                int(releasing),
                int(valid and healthy is not None and not inputs.get(healthy, 0)),
                list(dict.fromkeys(g for g, n in over if state.get(n))),
            ]

    def _of_machines(self, cycle: Cycle, shown: Shown, idle: Container[str]) -> None:
        state, inputs, outputs = cycle.memory.state, cycle.inputs, cycle.outputs
        self._held.after(cycle)
        for key, contacts, commands, late, trailed in self._machines:
            lies = "".join(x for x, n in zip("NR", contacts, strict=True) if n and inputs.get(n))
            wanted = "".join(x for x, n in zip("NR", commands, strict=True) if n and state.get(n))
            shown[key] = [
                lies if cycle.valid else "",
                wanted,
                int(bool(self._held.why.get(key[2:]))),
                int(bool(late and outputs.get(late)) or f"idle {key[2:]}" in idle),
                int(bool(trailed and state.get(trailed))),
                self._held.why.get(key[2:], ""),
            ]

    def _of_signals(self, cycle: Cycle, shown: Shown) -> None:
        state, inputs, outputs = cycle.memory.state, cycle.inputs, cycle.outputs
        for key, lamps, cancelling, timer, routes, lamp, speeds, marks in self._signals:
            aspect = next((word for word, n in lamps if outputs.get(n)), "dark")
            going = bool(cancelling and state.get(cancelling))
            left = self.left(cycle, timer)
            active = next(([r, int(bool(state.get(b)))] for r, a, b in routes if state.get(a)), None)
            out = None if lamp is not None and not cycle.valid else int(lamp is not None and not inputs.get(lamp, 0))
            kmh = next((v for v, n in speeds if outputs.get(n)), None)
            shown[key] = [aspect, int(going), left, active, out, kmh, " ".join(x for x, n in marks if outputs.get(n))]
        for key, clear, caution in self._distants:
            aspect = "clear" if outputs.get(clear or "") else "caution" if outputs.get(caution or "") else "dark"
            shown[key] = [aspect, 0, None, None, 0, None]

    def not_counted(self, section: str, cycle: Cycle) -> str:
        """What is to be said of a train that is put on a section of a zone by hand; empty where it is counted."""
        zones = " and ".join(f"zone {z}" for z in self._uncounted.unlocked(section, cycle.memory.state))
        return f"; the limit of {zones} does not count it: nothing is locked there" if zones else ""

    def dark(self, blocks: Container[str] = ()) -> Shown:
        """Without power nothing is known: sections count as occupied, lamps are dark; of
        conditions, zones, directions and automatic working the value is None.  `blocks`: the sections that are
        blocked, which this place knows."""
        shown: Shown = {key: [1, [], 0, int(key[2:] in blocks), 0, None, 0, 0, []] for key, *_ in self._sections}
        shown |= {key: ["", "", 0, 0, 0, ""] for key, *_ in self._machines}
        shown |= {key: ["dark", 0, None, None, 0, None] for key in self._lamps}
        shown |= {key: [0] for key, _ in self._overlaps}
        y = self.symbols
        unknown = [f"c:{c}" for c in y.condition]
        unknown += [f"a:{self._routes[k]}" for k in y.requests.automatic]
        shown |= {key: [None] for key in unknown}
        shown |= {f"z:{z}": [None, None] for z in y.zone_full} | {f"b:{b}": [None] * 5 for b in y.token}
        return shown


def trains(f: SimulatedField) -> list[Any]:
    """Each train of a simulated railway: the metres under it, its speed and length, the sections under it, whether
    somebody holds it, and where it looks; those that are to come in, and why they do not."""
    track, out = f.world.track, []
    for t in f.world.trains:
        spans = []
        for d in t.body:
            s = track.stretches[d]
            if not s.outside:
                lo, hi = t.span(track, d)
                spans.append([str(f.layout.track.edges[s.edge].id), round(lo, 1), round(hi, 1)])
        under = [track.sections[x] for x in t.under.sections]
        head = track.stretches[t.body[-1]]
        way = -1 if t.body[-1] & 1 else 1
        front = None if head.outside else way
        out.append(
            [f.stock.name_of(t), spans, round(t.speed * 3.6), round(t.length(track)), under, f.stock.held(t), front]
        )
    out += [
        [name, [], 0, round(m), [f"before {b.name}{_waits(f.world, b)}"], None, None] for b, m, name in f.stock.coming
    ]
    return out


def _waits(world: World, line: Beyond) -> str:
    """Why a train does not come in from a line yet, in brackets; empty if it is about to come."""
    if any(t.body[0] in line.comes_by for t in world.trains):
        return " (a train is on the line)"
    token = line.block is BlockKind.TOKEN
    return " (the neighbour has not got the direction)" if token and not world.neighbours[line.name].have else ""
