"""Completion plans replayed on the controller with its plant: what is said of deadlocks is believed only after this.

A plan is a list of trains, where they stand, and routes in order.  Nothing of the planner, of the derivation or of the
dispatcher is imported here.  Each route is asked for when its train stands before the signal, as an operator would; the
controller must grant it within `GRANT` scans, and the train must then run, by lamps alone, until it stands again or has
left.  At the end every train must be where the plan says that it may stay, and nothing may have met a hazard or broken
an assumption of the plant.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any

from interlock.dataclass import dataclass
from interlock.logic.controller import Controller
from interlock.logic.names import Name
from interlock.logic.plant import Plant
from interlock.logic.symbols import RouteSymbols
from interlock.model.layout import Layout
from interlock.sim.lanes import Driver, Lane, Lanes, Wish
from interlock.sim.line import Lines
from interlock.sim.trains import Rails, Train

GRANT = 60
"""Scans within which a route of a plan must be granted, and then its signal be open, beside the longest delay of the
controller (our choice)."""

RUN = 2_000
"""Scans within which a train must have run over its route (our choice)."""

STILL = 5
"""Scans in which nothing of a train moves after which it stands: at a joint it waits for two at most."""

GONE = "gone"


class BadPlan(Exception):
    """A plan file that cannot be read, or that is for another layout; says where."""


@dataclass(frozen=True)
class PlanTrain:
    """A train of a plan.  start: a boundary, or the ways under it from the rear as (section, number).

    ends: a section, or `gone`.  comes: the number of moves after which it comes to its boundary.
    """

    name: str
    length_m: float
    start: str | tuple[tuple[str, int], ...]
    ends: str
    comes: int = 0


@dataclass(frozen=True)
class Plan:
    """Trains, in the order in which they come to a boundary, and routes for them."""

    layout: str
    trains: tuple[PlanTrain, ...]
    moves: tuple[tuple[str, str], ...]


@dataclass
class Replayed:
    """What a replay showed: what is wrong, if anything; the most scans until a route was granted, and until open."""

    wrong: str | None = None
    grant: int = 0
    opened: int = 0
    scans: int = 0


def to_text(plan: Plan) -> str:
    """A plan as a file."""
    trains = [
        {"name": t.name, "length_m": t.length_m, "start": t.start, "ends": t.ends, "comes": t.comes}
        for t in plan.trains
    ]  # fmt: skip
    body = {"interlock_plan": 1, "layout": plan.layout, "trains": trains, "moves": plan.moves}
    return json.dumps(body, indent=1, ensure_ascii=False) + "\n"


def from_text(text: str) -> Plan:
    """Read a plan.  Raises `BadPlan`."""
    try:
        body: Any = json.loads(text)
    except json.JSONDecodeError as error:
        raise BadPlan(f"line {error.lineno}, column {error.colno}: this is no plan file: {error.msg}") from error
    except (ValueError, RecursionError) as error:
        raise BadPlan("this is no plan file: it has a number or a nesting that no plan has") from error
    if not isinstance(body, dict) or "interlock_plan" not in body:
        raise BadPlan("this is no plan file: the key `interlock_plan` is missing")
    if body["interlock_plan"] != 1:
        raise BadPlan(f"version {body['interlock_plan']} of plan files is not read here")
    trains, moves = _list(body, "trains"), _list(body, "moves")
    plan = Plan(
        str(body.get("layout", "")),
        tuple(_train(t, f"trains[{k}]") for k, t in enumerate(trains)),
        tuple(_pair(m, f"moves[{k}]") for k, m in enumerate(moves)),
    )
    names = [t.name for t in plan.trains]
    twice = next((n for n in names if names.count(n) > 1), None)
    if twice is not None:
        raise BadPlan(f"train {twice} is there twice")
    return plan


def _list(body: Mapping[str, Any], key: str) -> list[Any]:
    if not isinstance(body.get(key), list):
        raise BadPlan(f"{key}: a list is expected")
    return list(body[key])


def _train(value: Any, where: str) -> PlanTrain:
    """A train of a plan file.  Raises `BadPlan`."""
    missing = {"name", "length_m", "start", "ends", "comes"} - (value.keys() if isinstance(value, dict) else set())
    if missing:
        raise BadPlan(f"{where}: `{min(missing)}` is missing")
    length, comes, start = value["length_m"], value["comes"], value["start"]
    if isinstance(length, bool) or not isinstance(length, int | float) or not 1 <= length <= 2000:
        raise BadPlan(f"{where}.length_m: a number of metres is expected, 1 to 2000, not {_short(length)}")
    if isinstance(comes, bool) or not isinstance(comes, int) or comes < 0:
        raise BadPlan(f"{where}.comes: a whole number is expected, not {_short(comes)}")
    if not isinstance(start, str | list):
        raise BadPlan(f"{where}.start: a boundary, or a list of ways, is expected, not {_short(start)}")
    under = start if isinstance(start, str) else tuple(_way(w, f"{where}.start[{k}]") for k, w in enumerate(start))
    return PlanTrain(str(value["name"]), float(length), under, str(value["ends"]), comes)


def _way(value: Any, where: str) -> tuple[str, int]:
    section, number = _two(value, where)
    if not isinstance(number, int):
        raise BadPlan(f"{where}: the number of a way is expected, not {_short(number)}")
    return str(section), number


def _pair(value: Any, where: str) -> tuple[str, str]:
    train, route = _two(value, where)
    return str(train), str(route)


def _two(value: Any, where: str) -> tuple[Any, Any]:
    if not isinstance(value, list) or len(value) != 2:
        raise BadPlan(f"{where}: a list of two is expected, not {_short(value)}")
    return value[0], value[1]


def _short(value: Any) -> str:
    text = json.dumps(value, ensure_ascii=False)
    return text if len(text) <= 40 else text[:37] + "..."


class Replay:
    """A layout's controller and plant, on which plans are replayed side by side.  blocked: sections that the operator
    keeps blocked all the time."""

    def __init__(
        self, layout: Layout, controller: Controller, plant: Plant, dt_ms: int = 2_000, blocked: Iterable[str] = ()
    ) -> None:
        self.layout, self.controller = layout, controller
        names: Mapping[str, str] = controller.symbols.sections.blocked  # type: ignore[assignment]
        self._blocked = {names[s]: 1 for s in blocked if s in names}
        self.rails, self.lines = Rails(layout), Lines(layout, controller.symbols)
        self.lanes = Lanes(controller, plant, dt_ms)
        restart = controller.symbols.start.restart_timer  # it is over when a replay begins
        delays = (-(-t.preset_ms // dt_ms) for t in controller.timers if t.name != restart)
        self.grant = GRANT + max(delays, default=0)
        self.route: dict[str, RouteSymbols] = {r.id: r for r in controller.symbols.routes}

    def check(self, plans: Sequence[Plan], speed_m: float = 11.0) -> list[Replayed]:
        """What is wrong with each plan.  Raises `BadPlan` for one that speaks of something else than this layout."""
        for plan in plans:
            self._fits(plan)
        found = [Replayed() for _ in plans]
        starts = [self._lying(p) for p in plans]
        drivers = [self._driver(p, f, speed_m) for p, f in zip(plans, found, strict=True)]
        for f, (wrong, scans) in zip(found, self.lanes.run(starts, drivers), strict=True):
            f.wrong, f.scans = wrong, scans
        return found

    def _fits(self, plan: Plan) -> None:
        if plan.layout != self.layout.digest:
            raise BadPlan("the plan is for another layout, or for an earlier version of this one")
        names = {t.name for t in plan.trains}
        for k, (train, route) in enumerate(plan.moves, 1):
            if train not in names:
                raise BadPlan(f"move {k} is for {train}, which is no train of the plan")
            if route not in self.route:
                raise BadPlan(f"move {k} is over {route}, which is no route of the layout")
        for t in plan.trains:
            ways = () if isinstance(t.start, str) else t.start
            traversals: Mapping[str, Sequence[object]] = self.rails.topo.traversals  # type: ignore[assignment]
            known = all(s in traversals and 1 <= n <= len(traversals[s]) for s, n in ways)
            if (isinstance(t.start, str) and t.start not in self.rails.boundary) or not known or not t.start:
                raise BadPlan(f"{t.name} starts at {t.start}, which is no place of the layout")

    def _lying(self, plan: Plan) -> dict[str, int]:
        state: dict[str, int] = {}
        for t in plan.trains:
            if not isinstance(t.start, str):
                state |= self.rails.lying([self.rails.topo.traversals[s][n - 1] for s, n in t.start])  # type: ignore[index]
        return state

    def _driver(self, plan: Plan, found: Replayed, speed_m: float) -> Callable[[Lane], Driver]:
        return lambda lane: self._drive(lane, plan, found, speed_m)

    def _train(self, t: PlanTrain, speed_m: float) -> Train:
        train = Train(t.name, t.length_m, speed_m)
        if isinstance(t.start, str):
            train.under.append(self.rails.before(t.start))
            train.there = False
        else:
            train.under += [self.rails.spot(self.rails.topo.traversals[s][n - 1]) for s, n in t.start]  # type: ignore[index]
            train.done = train.under[-1].metres
        return train

    def _drive(self, lane: Lane, plan: Plan, found: Replayed, speed_m: float) -> Driver:
        trains = {t.name: self._train(t, speed_m) for t in plan.trains}
        yield Wish((), {"RELALL": 1})
        yield Wish((), {"RELALL": 1})
        for k, (name, route) in enumerate(plan.moves, 1):
            train, r = trains[name], self.route[route]
            rest = [trains[t.name] for t in plan.trains if t.comes < k]
            joint = self.layout.signalling.signal[r.entry].node
            head = train.under[-1] if train.under else None
            if train.gone or head is None:
                return f"move {k}: {name} has left"
            if head.exit != joint:
                if head.entry != joint or len(train.under) > 1:
                    return f"move {k}: {name} does not stand before {r.entry}"
                train.turns.add(head.section)
            for scan in range(self.grant):
                if lane.is_on(r.active):
                    found.grant = max(found.grant, scan)
                    break
                ask: dict[str, int] = {self.controller.symbols.requests.request: r.number} if scan % 2 else {}
                yield from self._scan(lane, rest, ask)
            else:
                return f"move {k}: {route} is not granted to {name}: " + "; ".join(lane.missing(f"G_R{r.number}"))
            for scan in range(self.grant):
                if any(lane.is_on(x) for x in r.open_while):
                    found.opened = max(found.opened, scan)
                    break
                yield from self._scan(lane, rest, {})
            else:
                return f"move {k}: {r.entry} does not open for {name}: " + "; ".join(lane.missing(f"CO_R{r.number}"))
            still = 0
            for _ in range(RUN):
                if not lane.is_on(r.active) and still > STILL:
                    break
                before = (len(train.under), train.done)
                yield from self._scan(lane, rest, {})
                still = still + 1 if train.gone or before == (len(train.under), train.done) else 0
            else:
                return f"move {k}: {name} does not come to the end of {route}"
        for t in plan.trains:
            at = GONE if trains[t.name].gone else trains[t.name].under[-1].section
            if at != t.ends:
                return f"at the end {t.name} is in {at}, not in {t.ends}"
        troubles = lane.troubles()
        return f"the run meets {', '.join(troubles)}" if troubles else None

    def _scan(self, lane: Lane, trains: Sequence[Train], inputs: Mapping[str, int]) -> Driver:
        """One scan in which every train does what it can."""
        wishes: list[Name] = []
        taken: set[str] = set()
        for t in trains:
            if t.there or t.under[0].section not in taken:
                wishes += self.rails.wishes(lane, t)
            taken |= {s.section for s in t.under if s.metres == 0}
        events, told = self.lines.scan(lane, trains)
        yield Wish((*wishes, *events), {**told, **self._blocked, **inputs})
        for t in trains:
            self.rails.moved(lane, t)
        return None
