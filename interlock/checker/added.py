"""What the words of the specification mean that tell of additions: hostile routes, points and clear sections."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import cached_property
from typing import Any

from interlock.checker.behind import Behind
from interlock.checker.formula import FALSE, Formula, some
from interlock.checker.lengths import whole_ms
from interlock.checker.railway import Calling, Path, Signal, air_locks
from interlock.checker.track import Demand, Way
from interlock.checker.words import fact
from interlock.verify import need


class Added(Behind):
    """Words of additions."""

    @cached_property
    def demands(self) -> list[Mapping[str, Any]]:
        """What air locks demand, and then what the author does."""
        return [*self._air_locks(), *(self.r.body.get("demand") or ())]

    def _air_locks(self) -> Iterator[Mapping[str, Any]]:
        """Who runs through one door of an air lock has the others shut."""
        for m, lock in air_locks(self.r).items():
            for other in self.w_other_doors(m):
                reason = f"of the doors of air lock {lock} only one may be open"
                for s in self.r.devices[m]:
                    yield {"point": other, "lies": "normal", "routes": {"via": [s]}, "reason": reason}

    def chosen_routes(self, choice: Mapping[str, Any]) -> list[int]:
        """The routes that the author chooses; over which trains are called on, by the lamp that is lit for them."""
        among = self.w_routes_calling_on() if choice.get("kind") == "call-on" else self.w_routes()
        return [r for r in among if self.r.paths.chosen(choice, *self.run_of(r))]

    def w_declared_routes(self) -> list[tuple[int, int]]:
        """Each two routes that the author declares hostile."""
        told = [(x["one"], x["other"]) for x in self.r.body.get("hostile") or ()]
        pairs = {(r, q) for a, b in told for r in self.chosen_routes(a) for q in self.chosen_routes(b)}
        return sorted((r, q) for r, q in pairs if r != q)

    def w_routes_declared(self) -> list[int]:
        return sorted({r for pair in self.w_declared_routes() for r in pair})

    def w_routes_demanding(self) -> list[int]:
        """Others that hold what was added to them: points that do not lie so for them anyway."""
        told = {r for x in self.demands if "point" in x for r in self.chosen_routes(x["routes"])}
        return [r for r in self.w_holding_routes() if r in told and r not in self.w_routes_declared()]

    def w_holding_routes(self) -> list[int]:
        return [r for r in self.w_routes() if f"AH_R{r}" in self.state]

    def w_routes_held_longer(self) -> list[int]:
        """The routes that hold what was added to them for longer than until their train is wholly in."""
        return [r for r in self.w_routes() if self.w_hold_of(r)]

    def w_hold_of(self, r: int) -> int:
        """For how many milliseconds."""
        return whole_ms(self.longest_hold(r))

    def longest_hold(self, r: int) -> float:
        """For how many seconds a route holds what was added to it longer: the longest that some demand has it do."""
        wishes = (x for x in self.demands if "hold" in x and r in self.chosen_routes(x["routes"]))
        return max((float(x["hold"]) for x in wishes), default=0.0)

    def w_is_one_of_these(self, t: str) -> Formula:
        """Something says how long the timer must be."""
        return some((super().w_is_one_of_these(t), fact(t in map(self.w_hold_timer, self.w_routes_held_longer()))))

    def w_demanded_of(self, r: int) -> list[Demand]:
        """The points that the author has a route lock, but those on its own path."""
        c, p = self.run_of(r)
        called = self.w_called_on_demands(c.signal, p) if r in self.w_routes_calling_on() else []
        return [d for d in (*self.w_added_demands(c, p), *called) if d not in self.w_demands(p)]

    def w_added_demands(self, c: Calling, p: Path) -> list[Demand]:
        """The points that the author has every route of a kind over this path lock."""
        return self._added(c, p, called_on=False)

    def w_called_on_demands(self, g: Signal, p: Path) -> list[Demand]:
        """The points that the author has call-on routes alone over this path lock."""
        return self._added(Calling(g, False), p, called_on=True)

    def _added(self, c: Calling, p: Path, called_on: bool) -> list[Demand]:
        return [
            Demand(self._machine_of(x["point"]), "N" if x["lies"] == "normal" else "R")
            for x in self._demands(c, p, called_on)
            if "point" in x
        ]

    def w_demanded_clear(self, c: Calling, p: Path) -> list[str]:
        """The sections that the author has every route of a kind over this path find clear."""
        return [x["clear"] for x in self._demands(c, p, called_on=False) if "clear" in x]

    def w_called_on_demanded_clear(self, g: Signal, p: Path) -> list[str]:
        """The sections that the author has call-on routes alone over this path find clear."""
        return [x["clear"] for x in self._demands(Calling(g, False), p, called_on=True) if "clear" in x]

    def _demands(self, c: Calling, p: Path, called_on: bool) -> Iterator[Mapping[str, Any]]:
        """What the author demands of routes over this path: of call-on routes alone, or of others."""
        for x in self.demands:
            whole = [k for k in ("point", "lies", "clear") if k in x] in (["point", "lies"], ["clear"])
            need(whole, "a demand names a point and how it lies, or a section that is clear")
            need("point" in x or not float(x.get("hold", 0)), "no section that is demanded clear is held longer")
            if self.r.paths.chosen(x["routes"], c, p) and (x["routes"].get("kind") == "call-on") is called_on:
                yield x

    def _machine_of(self, name: str) -> str:
        """The machine of a point; a level crossing or another interlock is its own."""
        return self.r.drawn.points[name].machine if name in self.r.drawn.points else name

    def w_added_powered_demands(self, c: Calling, p: Path) -> list[Demand]:
        return [d for d in self.w_added_demands(c, p) if d.machine in self.w_powered()]

    def w_called_on_powered_demands(self, g: Signal, p: Path) -> list[Demand]:
        return [d for d in self.w_called_on_demands(g, p) if d.machine in self.w_powered()]

    def w_holds_added(self, r: int) -> Formula:
        return self.known(f"AH_R{r}")

    def w_hold_begun(self, r: int) -> Formula:
        """The route would have let go what was added to it, and has not been set since; nobody else's bit tells it."""
        return self.known(f"AHE_R{r}") if self.w_hold_of(r) else FALSE

    def w_last_held(self, r: int) -> Way:
        """The way whose lock a train leaves behind when it is wholly in the last section; where a route leads out over
        a boundary, as no shunting movement does, or has one section, the last one."""
        c, p = self.run_of(r)
        own = self.w_kept_clear(p)
        leaves = not c.shunt and p.last.exit in self.r.drawn.boundaries
        through = own if p.berth or leaves else own[:-1]
        return (through or own)[-1]
