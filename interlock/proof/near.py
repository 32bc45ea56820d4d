"""Where on the railway a variable belongs, so that questions about one place can be asked one after the other.

A solver is quickest when a question is like the one before it.  Sections are numbered by a walk over the track that
goes on from a section to its neighbours before it comes back to a branch.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from interlock.logic.controller import Controller, Symbols
from interlock.logic.expr import Expr, variables
from interlock.logic.plant import (
    accepted,
    across,
    came,
    image,
    lamp,
    lies,
    o,
    old_command,
    overran,
    overrunning,
    rests,
    running,
)
from interlock.model.elements import Position, SectionId
from interlock.model.traversal import Topology


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


def places(topo: Topology, sym: Symbols, prime: str) -> Mapping[str, tuple[int, ...]]:
    """The sections of the variables of sections and routes, before and after a step, by their numbers."""
    order = walked(topo)
    found: dict[str, tuple[int, ...]] = {}
    for by_section in (sym.restart, sym.firm, sym.used, sym.passed, sym.stale, sym.train):
        found |= {name: (order[s],) for s, name in by_section.items()}
    found |= {name: (order[s],) for (s, _), name in sym.lock.items()}
    for s in topo.sections:
        events = [o(s), rests(s), *(x for j in topo.ends[s] for x in (came(s, j), across(j, s)))]
        found |= {x.name: (order[s],) for x in events} | {f"been.{s}": (order[s],)}
    for r in sym.routes:
        over = tuple(order[s] for s, _ in r.ways)
        found |= dict.fromkeys((r.active, r.locked, r.want, r.proceed, r.shown, f"shut.R{r.number}"), over)
    return found | {name + prime: over for name, over in found.items()}


def routes_of(controller: Controller, prime: str) -> dict[str, tuple[str, int]]:
    """The variables of routes, before and after a step: what they mean, and the route's number."""
    number = {f"route {r.id}": str(r.number) for r in controller.symbols.routes}
    found: dict[str, tuple[str, int]] = {}
    for e in [*controller.equations, *controller.next]:
        k = number.get(e.group)
        if k is not None and e.name.endswith(f"_R{k}"):
            found[e.name] = e.name[: -len(k)], int(k)
    found |= {f"shut.R{r.number}": ("shut.R", r.number) for r in controller.symbols.routes}
    return found | {name + prime: (family + prime, k) for name, (family, k) in found.items()}


def homes(
    topo: Topology,
    controller: Controller,
    definitions: Mapping[str, Expr],
    inputs: Sequence[str],
    prime: str,
    routes: Mapping[str, object],
) -> dict[str, str]:
    """The element to which names belong, as the groups of the controller's equations are called.

    What the controller does not compute belongs where its section or machine does, and an input to the only element
    that reads it.
    """
    sym = controller.symbols
    found = {e.name: e.group for e in [*controller.equations, *controller.next] if e.name not in routes}
    at = {n: f"section {s}" for s, n in walked(topo).items()}
    for name, where in places(topo, sym, prime).items():
        if name not in routes and len(where) == 1:
            found.setdefault(name, at[where[0]])
    found |= {x.name: f"point {m}" for m, _ in sym.command for p in Position for x in (lies(m, p), old_command(m, p))}
    found |= {name: f"section {s}" for s, name in sym.clear.items()}
    for s in topo.sections:
        found |= {x.name: f"section {s}" for x in (image(s), running(s))}
    names = (name.removesuffix(prime) for name in definitions)
    found |= {overran(g, s).name: f"section {s}" for g, s in overrunning(names, sym.approach_of, topo.ends)}
    for g in sym.approach_of:
        found |= {x.name: f"signal {g}" for k in (False, True) for x in (accepted(g, k), lamp(g, k))}
    found |= _clocks(sym)
    readers: dict[str, set[str]] = {}
    for name, x in definitions.items():
        home = found.get(name.removesuffix(prime))
        if home is not None:
            for v in variables((x,)):
                readers.setdefault(v, set()).add(home)
    for name in inputs:
        those = readers.get(name, ())
        if len(those) == 1:
            found.setdefault(name, next(iter(those)))
    return found | {name + prime: home for name, home in found.items()}


def _clocks(sym: Symbols) -> dict[str, str]:
    """Clocks of the world, what the proof remembers of timers beside them, and what outputs tell of an element."""
    found: dict[str, str] = {}
    for g, timer in sym.approach_timer.items():
        found |= dict.fromkeys((f"long.stop.{g}", f"cov.{timer}", timer), f"signal {g}")
        lamps = [*sym.proceed_lamps(g), *sym.proceed_lamps(g, shunt=True), sym.stop_aspect[g]]
        found |= dict.fromkeys(lamps, f"signal {g}")
    for g, timer in sym.overlap_timer.items():
        home = f"section {sym.approach_of[g]}"
        found |= dict.fromkeys((f"long.stand.{g}", f"cov.{timer}"), home)
    found |= {name: f"point {m}" for (m, _), name in sym.drive.items()}
    return found | {
        name: f"section {what.split(' ', 1)[1]}" for what, name in sym.indication.items() if what[:7] == "locked "
    }
