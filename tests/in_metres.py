"""Steps of the simulator in metres, told in the words of the specification of the world (interlock/spec/plant.yaml).

Positions in metres become what the specification speaks of: which sections are occupied, from which end their train
came, across which joints one stands, who has accepted which signal, how points lie.  A step is allowed when every event
that is seen in it was free to happen, every next value is the one specified, and every assumption holds.

Kept out of these runs, since the specification does not tell them so: a vehicle that is taken away on the spot (moved
under local rules), a train that parts with its rear across a joint, contacts that report both positions at once, shunt
lost for more than a scan, a cycle in which a train runs through a section.  A train on its way out over an approach
section is a false report there (A-ONE-FALSE): such steps may have a second one beside it.  At a restart nobody stands
across a joint of a section with points, on a leg for which they do not lie.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from itertools import pairwise
from math import inf
from random import Random

from interlock.checker import plant
from interlock.checker.formula import Formula, names
from interlock.checker.moves import World as Words
from interlock.checker.railway import Railway
from interlock.checker.schema import instances
from interlock.checker.specification import Specification
from interlock.checker.written import Written, written
from interlock.model.elements import SignalId
from interlock.model.needs import needs
from interlock.simulate.faults import Faults
from interlock.simulate.run import Life, Outcome, load
from interlock.simulate.track import NONE, Track
from interlock.simulate.train import Train
from interlock.simulate.world import World
from tests.campaigns.simulate import Case
from tests.written import shipped

FAULTS = replace(
    Faults(), stall=0, power=0, divide=0, shunt=0, trail=0, sensor=0, contradict=0, overrun=0, inputs=0.004
)

Values = dict[str, bool]
Function = Callable[[Values], bool]
Pair = tuple[str, str]
Body = tuple[Pair, ...]
"""Sections under a train from tail to head, each with the end at which it came in; "" outside."""


@dataclass
class Step:
    """One step: the state before, inputs, what the controller had and has, the state after, seconds of stop shown."""

    before: Values
    after: Values
    inputs: dict[str, int]
    timers: Values
    controller: Values
    controller_after: Values
    outputs: Values
    outputs_after: Values
    heads: frozenset[tuple[str, str]]
    tails: frozenset[tuple[str, str]]
    turned: frozenset[tuple[str, str, str]]
    appeared: frozenset[str]
    arrived: frozenset[str]
    stopped: Values
    stood: Values
    departing: frozenset[str]
    histories: Values = field(default_factory=dict)
    """What the specification remembers of the steps before, once they have been looked at."""


class Specified:
    """What a specification says of a layout, as formulas over names."""

    def __init__(self, name: str, spec: Specification) -> None:
        body, system, _ = shipped(name)
        self.written: Written = written(system)
        self.words = Words(Railway(body), self.written)
        defined = plant.define(self.words, spec)
        self.next = {n[:-1]: x for n, x in defined.items() if n.endswith("'")}
        self.events = {n: x for n, x in defined.items() if not n.endswith("'")}
        self.chosen = tuple(n for n, x in self.events.items() if f"?{n}" in names(x))
        """Events that happen or do not, as the world likes; `free`: those of them that are looked at."""
        self.free = list(self.chosen)
        self.assumptions = [
            (str(a["id"]), x) for a in spec.assumptions if a["id"] != "A-TON" for x in instances(a, self.words)
        ]
        self.initial = [x for s in spec.initial for x in instances({**s, "must": s["says"]}, self.words)]
        self._next = {n: function(x) for n, x in self.next.items()}
        self._assumptions = [(n, function(x), frozenset(names(x))) for n, x in self.assumptions]
        self._computed: dict[str, Function] = {}
        self.histories: Values = {}

    def other_than(self, spec: Specified) -> None:
        """What is said otherwise than in another specification is all that is looked at: the rest is known to hold."""
        self.free = [n for n in self.free if self.events[n] != spec.events.get(n)]
        self._next = {n: f for n, f in self._next.items() if self.next[n] != spec.next.get(n)}
        known = set(spec.assumptions)
        those = zip(self.assumptions, self._assumptions, strict=True)
        self._assumptions = [made for said, made in those if said not in known]
        self.initial = [x for x in self.initial if x not in spec.initial]

    def begin(self, first: Step) -> bool:
        """Histories, and what follows from outputs and inputs of the scan before; whether a run may begin so."""
        self.histories = {n: n.startswith(("cov.", "img.")) for n in self.next if n not in first.before}
        known = self._known(first, {})
        return all(function(x)(known) for x in self.initial)

    def broken(self, step: Step) -> Iterator[str]:
        """What the specification does not allow in a step."""
        if step.histories:
            self.histories = step.histories
        step.histories = self.histories
        free = {f"?{e}": self._seen(e, step) for e in self.chosen}
        free |= {f"?long.stop.{g}": x for g, x in step.stopped.items()}
        free |= {f"?long.stand.{g}": x for g, x in step.stood.items()}
        known = self._known(step, free)
        for name in self.free:
            if free[f"?{name}"] and not known[name]:
                yield f"{name} was not free to happen"
        after = {name: bool(f(known)) for name, f in self._next.items()}
        for name, value in after.items():
            if name in step.after and value != step.after[name]:
                yield f"{name} is {step.after[name]}, specified as {value}"
        known.update((f"{n}'", v) for n, v in (after | step.after).items())
        for name, f, about in self._assumptions:
            if not f(known) and not (name == "A-ONE-FALSE" and step.departing & about):
                yield f"{name} does not hold"
        self.histories = {n: after.get(n, v) for n, v in self.histories.items()}

    def _known(self, step: Step, free: Values) -> _Known:
        values = {**step.outputs, **step.controller, **step.timers, **self.histories, **step.before, **free}
        known = _Known(values)
        known.specified, known.step = self, step
        return known

    def compute(self, name: str) -> Function:
        """How an event or a definition of the written system is computed."""
        found = self._computed.get(name)
        if found is None:
            found = self._computed[name] = function(self.events.get(name) or self.written.definitions[name])
        return found

    def _seen(self, event: str, step: Step) -> bool:
        kind, _, rest = event.partition(".")
        before, after = step.before, step.after
        if kind == "start":
            return before[f"at.{rest}"] and not after[f"at.{rest}"]
        if kind == "arrive":
            return f"at.{rest}" in step.arrived
        if kind in ("head", "tail"):
            joint, section = rest.rsplit(".", 1)
            return (joint, section) in (step.heads if kind == "head" else step.tails)
        if kind == "appear":
            return rest in step.appeared
        if kind == "turn":
            return any(rest == ".".join(t) for t in step.turned)
        if kind == "accept":
            return after[f"go.{rest}"] and not before[f"go.{rest}"]
        if kind == "refuse":
            return before[f"go.{rest}"] and not after[f"go.{rest}"] and not self._passed(rest, step)
        if kind == "parts":
            return False
        raise AssertionError(f"an event of a new kind: {event}")

    def _passed(self, signal: str, step: Step) -> bool:
        g = self.words.r.signals[signal]
        return (g.node, self.words.w_before_of(g)) in step.heads


class _Known(Values):
    """Values of names in a step: given, or computed when they are asked for from what they are defined as."""

    specified: Specified
    step: Step

    def __missing__(self, name: str) -> bool:
        step = self.step
        number, equal, value = name.partition("=")
        if name in step.inputs:
            found = bool(step.inputs[name])
        elif equal:
            found = step.inputs.get(number, 0) == int(value)
        elif name.startswith("?"):
            found = False
        elif name[-1] == "'" and name[:-1] in step.controller_after:
            found = step.controller_after[name[:-1]]
        elif name[-1] == "'" and name[:-1] in step.outputs_after:
            found = step.outputs_after[name[:-1]]
        else:
            found = self.specified.compute(name)(self)
        self[name] = found
        return found


def function(x: Formula) -> Function:
    """A formula as a function of the values of its names."""
    found: Function = eval(f"lambda k: {_text(x)}")
    return found


def _text(x: Formula) -> str:
    if x[0] == "v":
        return f"k[{x[1]!r}]"
    if x[0] == "!":
        return f"(not {_text(x[1])})"
    if x[0] == "&":
        return f"({' and '.join(_text(y) for y in sorted(x[1], key=str))})"
    return str(x[0] == "T")


class Reader:
    """Reads steps off a running world."""

    def __init__(self, life: Life, words: Words) -> None:
        self.life, self.words, self.world = life, words, life.world
        self.track: Track = self.world.track
        self.edges = self.world.layout.track.edges
        names = {b.name: b for b in self.track.beyond}
        self.comes_over = {names[e.node].comes_by[-1]: e.outside for e in words.w_entrances()}
        self.outside = {e.outside: e.node for e in words.w_entrances()}
        self.goes_over = {b.goes: b.name for b in self.track.beyond if b.goes != NONE}
        self.before_signal = {g.name: words.w_before_of(g) for g in words.w_opening()}
        self.bodies: dict[int, Body] = {}
        self.earlier: dict[int, Body] = {}
        """Bodies a step ago: what a driver was told farther back he accepts in the section before the signal."""
        self.stood: dict[int, set[str]] = {}
        """By train that has not moved since the restart delay was over: the sections that it stood in."""
        self.facing: dict[int, int] = {}
        self.last: Values = {}
        self.controller: Values = {}
        self.outputs: Values = {}
        self.clock = 0.0
        self.stop_s = dict.fromkeys(self.before_signal, 0.0)
        self.alone_s = {g.name: 0.0 for g in words.w_overlapped()}
        """By signal with an overlap: seconds for which no train has come into the section before it."""
        self.needs = needs(self.world.layout)

    def _places(self, t: Train) -> list[tuple[str, str]]:
        """Sections under a train from tail to head, each with the node at which it came into it."""
        s, found = self.track.stretches, list[tuple[str, str]]()
        for d in t.body:
            if d in self.comes_over:
                found.append((self.comes_over[d], ""))
            elif d in self.goes_over:
                found.append(("", self.goes_over[d]))
            elif not s[d].outside:
                section, e = self.track.sections[s[d].section], self.edges[d >> 1]
                if not found or found[-1][0] != section:
                    found.append((section, str(e.b if d & 1 else e.a)))
        return found

    def _came_from(self, t: Train) -> str:
        """The end of the section under its tail from which a train must have come that is not known from before."""
        s, d = self.track.stretches, t.body[0] ^ 1
        section = s[d].section
        while True:
            on = self.world.sight.follows(s[d], moving=True)
            if on == NONE or s[on].section != section or s[on].outside:
                e = self.edges[d >> 1]
                return str(e.a if d & 1 else e.b)
            d = on

    def _body(self, t: Train) -> Body:
        turned = self.facing.get(t.number) == t.body[0] ^ 1
        self.facing[t.number] = t.body[-1]
        known = {} if turned else dict(self.bodies.get(t.number, ()))
        found = self._places(t)
        if found and found[0][0] and found[0][1]:
            section = found[0][0]
            found[0] = section, known.get(section) or self._came_from(t)
        return tuple(found)

    def _state(self) -> Values:
        """The world as the specification sees it."""
        out = {n: False for n in self.words.w.state if n.split(".")[0] in ("o", "in", "x", "rest", "go")}
        for m, name in enumerate(self.track.machines):
            out |= {f"at.{name}.{x}": self.world.machines.lies[m] == k for k, x in enumerate("NR")}
        for t in self.world.trains:
            body = self.bodies[t.number]
            for k, (section, entry) in enumerate(body):
                if section:
                    out[f"o.{section}"] = True
                if section and entry:
                    out[f"in.{section}.{entry}"] = True
                    out[f"rest.{section}"] = section in self.stood.get(t.number, ())
                if section and k + 1 < len(body):
                    out[f"x.{body[k + 1][1]}.{section}"] = True
            called = t.view.target != NONE and (t.driver.accepted or t.driver.committed)
            g = self.track.signals[t.view.target] if called else ""
            near = self.before_signal.get(g)
            if near and body and body[-1][0] == near and any(s == near for s, _ in self.earlier.get(t.number, ())):
                out[f"go.{g}"] = True
        return out

    def begin(self, outputs: Mapping[str, int]) -> None:
        """The restart delay is over: whoever is inside stands."""
        inside = [t for t in self.world.trains if not self.track.stretches[t.body[0]].outside]
        kept = next((t for t in inside if t.view.target != NONE and self._plain(t)), None)
        for t in inside:
            if t is not kept:
                self.world.trains.remove(t)  # moved under local rules before the restart
        self.world.traffic.most = 4
        self.bodies = self.earlier = {t.number: self._body(t) for t in self.world.trains}
        self.stood = {n: {s for s, e in body if s and e} for n, body in self.bodies.items()}
        self.last = self._state()
        self._keep(outputs)

    def _into(self, head: Pair) -> str:
        joint, section = head
        inside = {e.node: e.inside for e in self.words.w_entrances() if e.outside == section}
        return inside.get(joint) or self.words.r.track.beyond(section, joint) or ""

    def _departing(self) -> Iterator[str]:
        """Reports of approach sections that are occupied by trains on their way out."""
        s = self.track.stretches
        for t in self.world.trains:
            for d in t.body:
                if d in self.goes_over and s[d].section != NONE:
                    yield self.world.reports.clear[s[d].section]

    def _plain(self, t: Train) -> bool:
        """No points under a train that stands across a joint."""
        pointed = {s.section for s in self.track.stretches if s.machine != NONE}
        return len(t.under.sections) == 1 or pointed.isdisjoint(t.under.sections)

    def _keep(self, outputs: Mapping[str, int]) -> None:
        self.controller = {n: bool(v) for n, v in self.life.controller.state.items()}
        self.outputs = {n: bool(v) for n, v in outputs.items()}
        self.clock = self.world.clock

    def step(self, outputs: Mapping[str, int]) -> Step:
        """The step that has just been made."""
        heads, tails, turned, appeared = set[Pair](), set[Pair](), set[tuple[str, str, str]](), set[str]()
        now = {t.number: self._body(t) for t in self.world.trains}
        for n in now.keys() | self.bodies.keys():
            old, new = self.bodies.get(n, ()), now.get(n, ())
            if len(old) == len(new) == 1 and old[0][0] == new[0][0] and old != new:
                turned.add((old[0][0], old[0][1], new[0][1]))
                continue
            first = new[0][0] if new else ""
            gone = next((k for k, x in enumerate(old) if x in new or (first and x[0] == first)), len(old))
            tails |= {(old[k + 1][1], old[k][0]) for k in range(gone) if old[k][0] and k + 1 < len(old)}
            tails |= {(new[0][1], old[k][0]) for k in range(gone) if old[k][0] and k + 1 == len(old) and new}
            whole = (*old[:gone], *new)
            heads |= {(b[1], a[0]) for a, b in pairwise(whole) if b not in old}
        self.earlier, self.bodies = self.bodies, now
        self.stood = {n: {s for s, _ in now[n]} & stood for n, stood in self.stood.items() if n in now}
        dt = self.world.clock - self.clock
        for g in self.stop_s:
            self.stop_s[g] = self.stop_s[g] + dt if self.outputs[f"YS_{g}"] else 0.0
        for g in self.alone_s:
            came = any(self._into(h) == self.before_signal[g] for h in heads)
            self.alone_s[g] = 0.0 if came else self.alone_s[g] + dt
        state = self._state()
        for place, node in self.outside.items():  # one that comes close behind another appears when that has left
            if state[f"o.{place}"] and (not self.last[f"o.{place}"] or (node, place) in tails):
                appeared.add(place)
        arrived = {n for n, v in state.items() if v and n.startswith("at.") and not self.last[n]}
        elapsed, presets = self.life.controller.elapsed, self.life.names["TIMERS"]
        step = Step(
            before=self.last,
            after=state,
            inputs=dict(self.world.reports.inputs),
            timers={n: elapsed[n] is not None and elapsed[n] >= ms for n, ms in presets.items()},
            controller=self.controller,
            controller_after={n: bool(v) for n, v in self.life.controller.state.items()},
            outputs=self.outputs,
            outputs_after={n: bool(v) for n, v in outputs.items()},
            heads=frozenset(heads),
            tails=frozenset(tails),
            turned=frozenset(turned),
            appeared=frozenset(appeared),
            arrived=frozenset(arrived),
            stopped={g: 1000 * s >= self.needs.stop[SignalId(g)] for g, s in self.stop_s.items()},
            stood={g: 1000 * s >= self.needs.stand[SignalId(g)] for g, s in self.alone_s.items()},
            departing=frozenset(self._departing()),
        )
        self.last = state
        self._keep(outputs)
        return step


def steps(case: Case, words: Words, seed: int, scans: int, hostile: bool) -> list[Step]:
    """The steps of a run from when the restart delay was over."""
    track, names = Track.of(case.layout), load(case.runtime)
    life = Life(case.layout, track, names, Random(f"{seed} {hostile}"), hostile, case.routes, FAULTS)
    if case.layout.principles.line_speed_kmh > 40.0:
        life.cycle = 0.25  # a short train clears a joint in half a second
    reader, found = Reader(life, words), list[Step]()
    _as_specified(life, reader)
    restart = names["TIMERS"]["RST"]

    def watch(world: World, outputs: Mapping[str, int]) -> None:
        for t in world.trains:
            t.handling.patience = inf
        elapsed = life.controller.elapsed["RST"]
        if elapsed is None or elapsed < restart - 1000:
            return
        if not reader.last:
            reader.begin(outputs)
            return
        found.append(reader.step(outputs))

    total = Outcome()
    life.run(scans, total, lambda o: bool(o.hazards), watch)
    assert not total.hazards, total.hazards
    return found


def _as_specified(life: Life, reader: Reader) -> None:
    """Nobody turns round that has not been called since the restart."""
    traffic = life.world.traffic
    turns = traffic.turns

    def called(t: Train) -> None:
        if not reader.stood.get(t.number):
            turns(t)

    traffic.turns = called  # type: ignore[method-assign]
