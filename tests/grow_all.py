"""Layouts that grow at random with every word of the language that says something of control.

To what `tests.grow` grows come names of any script, tracks joined end to end, slips with one machine, boards and shunt
signals at which trains end, conditions, speeds, single directions, supervision of each machine, substations and their
health, and single knobs of the profile.  What speaks of routes, signals or overlaps by name is chosen once these are
known: overlaps of several lengths and speeds, identifier lights, additions of the author, exclusions, waivers, names,
automatic routes and voyages.  What the layout does not bear is left out again.
"""

from __future__ import annotations

import random
import re
from collections.abc import Callable
from dataclasses import dataclass, field

from interlock.checker.reading import loaded
from interlock.diag import Sink
from interlock.model.layout import Layout
from interlock.model.overlap import overlap_paths
from interlock.table.cells import RouteKind
from interlock.table.rows import InterlockingTable, RouteRow
from tests.grow import Grown, driven, within_line
from tests.layouts import grown

SCRIPTS = ("{p}{n}", "{p}{n}", "{p}-{n}", "{n}{p}#", "{p}_{n}/{n}", "Ж{p}{n}", "北{p}{n}", "ﾂ{p}{n}", "é{n}{p}")
"""How names are written: `p` is a letter for the kind, `n` a number."""

KNOBS = (
    *("flank_by: point", "flank_by: signal", "flank_space: yes", "drive_points: yes", "sensor_faults: yes"),
    *("lamp_proof: yes", "lamp_proof: no", "caution: never", "caution: next", "caution: turnout", "overlap_m: 40"),
    *("local_requests: first", "local_requests: last", "point_start_gap_s: 0.5", "slow_below_kmh: 60"),
    *("main_closes: whole-movement", "shunt_closes: whole-movement", "release_delay_s: 5", "leg_m: 30", "fouling_m: 9"),
    *("clearance_m: 5", "overlap_release_s: 40", "approach_release_s: 240", "shunt_release_s: 40", "token_delay_s: 90"),
)


@dataclass
class Everything(Grown):
    """A layout in the making, with every kind of element."""

    end_to_end = True
    script: str = "{p}{n}"
    swings: bool = field(default=False, init=False)

    def some(self, chance: float) -> bool:
        return self.rng.random() < chance

    def name(self, prefix: str) -> str:
        self.count += 1
        return self.script.format(p=prefix, n=self.count)

    @property
    def kinds(self) -> list[str]:
        """Half of the layouts have no shunt signals."""
        return ["", "", "shunt", "combined", "board", "limit"] if self.shunting else ["", "", "", "board"]

    def slip(self, a, b):  # type: ignore[no-untyped-def]
        """A slip, now and then with one machine, or named after its blades."""
        found = super().slip(a, b)
        if "single" not in self.slips[-1]:
            name = self.slips[-1].split(":")[0].strip()
            more = self.rng.choice(
                ["", "", f", machines: [m{name}]", ", blades: near", f", machines: [a{name}, b{name}]"]
            )
            self.slips[-1] = f"{self.slips[-1][:-1]}{more}{self._supervision()}}}"
        return found

    def _supervision(self) -> str:
        return ", supervision: 20" if self.some(0.15) else ""

    def pair_machines(self) -> None:
        super().pair_machines()
        alone = [p for p, spec in self.points.items() if "machine" not in spec]
        rng = random.Random(f"coupled {' '.join([*self.points, *self.derailers])}")
        if alone and self.derailers and rng.random() < 0.5:
            p, d = rng.choice(alone), rng.choice(list(self.derailers))
            self.points[p]["machine"] = self.derailers[d]["machine"] = f"{p}/{d}"

    def place_signals(self) -> None:
        super().place_signals()
        for i, g in enumerate(self.signals):
            if "kind: shunt" in g and self.some(0.3):
                self.signals[i] = f"{g[:-1]}, stops_trains: yes}}"
            elif "kind" not in g and self.shunting and self.some(0.1):
                self.signals[i] = f"{g[:-1]}, kind: combined}}"

    def furnish(self) -> list[str]:
        out = super().furnish()
        for those in (self.points, self.derailers):
            for spec in those.values():
                if spec.get("work") != "hand" and "machine" not in spec and self.some(0.1):
                    spec["supervision"] = "20"
        for spec in self.points.values():
            if self.some(0.1):
                spec["hand"] = self.rng.choice(["left", "right"])
            if self.some(0.1):
                spec["fouling"] = self.rng.choice(["6", "25"])
        sections = sorted({s for a, b, _ in self.joints for s in (a, b)})
        if sections and self.some(0.25):
            out += self._conditions(sections)
        if self.some(0.2):
            out += self._substations(sections)
        if self.points and self.some(0.15):
            out.append(f"telegram: {self.rng.choice(['plain', 'tagged'])}")
        self.swings = any("swing: yes" in x for x in out)
        return [x if not x.startswith("  L") else x[:-1] + self._supervision() + "}" for x in out]

    def _conditions(self, sections: list[str]) -> list[str]:
        what = self.rng.choice(["over", "signals", "exits"])
        named = [s.split(":")[0].strip() for s in self.signals]
        whom = {"over": sections, "signals": named, "exits": list(self.boundaries)}[what]
        return ["conditions:", f"  {self.name('C')}: {{text: by chance, {what}: [{self.rng.choice(whom)}]}}"]

    def _substations(self, sections: list[str]) -> list[str]:
        one, rest = self.name("U"), self.name("U")
        wired = self.rng.sample(sections, len(sections) // 2) if sections else []
        if not wired:
            return []
        health = self.rng.choice(["by: diagnosis", "by: both", "by: heartbeat, within: 0.5"])
        return ["substations:", f"  {one}: [{', '.join(wired)}]", f"  {rest}: []", "health:", f"  {one}: {{{health}}}"]

    def blind(self) -> list[str]:
        """Sections of their own: speeds, single directions, inclined lanes, and sidings without detection."""
        out = super().blind()
        inside = [x.split()[0] for items in self.tracks.values() for x in items if " " in x]
        told = {s: "" for s in inside if not any(f"  {s}:" in line for line in out)}
        for s in told:
            if self.some(0.1):
                told[s] = self.rng.choice(
                    ["speed: 30", "speed: 70", "one_way: forward", "one_way: backward", "lane: inclined"]
                )
        lines = [f"  {s}: {{{x}}}" for s, x in told.items() if x]
        return [*(out or (["sections:"] if lines else [])), *lines]

    def rule(self, swings: bool) -> str:
        first = super().rule(swings)
        own = [k for k in self.rng.sample(KNOBS, 3) if self.some(0.5) and k.split(":")[0] not in first]
        if any("flank_lamp" in x for x in (first, *own)):
            own = [k for k in own if not k.startswith("lamp_proof")]
        own = [k for i, k in enumerate(own) if k.split(":")[0] not in {x.split(":")[0] for x in own[:i]}]
        said = [*([first[len("principles: {") : -1]] if first else []), *own]
        return f"principles: {{{', '.join(said)}}}" if said else ""


def words(text: str) -> frozenset[str]:
    """What a layout has of the elements that only this module grows."""
    body = loaded(text)
    found = set(body.get("principles") or {}) & {k.split(":")[0] for k in KNOBS}
    found |= {part for part in PARTS if body.get(part)}
    signals = list((body.get("signals") or {}).values())
    overlaps = list((body.get("overlaps") or {}).values())
    slips = list((body.get("slips") or {}).values())
    machines = [x for part in MACHINES for x in (body.get(part) or {}).values()]
    sections = list((body.get("sections") or {}).values())
    tracks = [x for items in (body.get("tracks") or {}).values() for x in items]
    found |= {f"kind: {k}" for k in ("board", "limit") if any(g.get("kind") == k for g in signals)}
    found |= {"stops_trains" for g in signals if "stops_trains" in g}
    found |= {f"overlaps: {k}" for o in overlaps for k in OVERLAPS if k in o}
    found |= {"one machine" for s in slips if len(s.get("machines", ())) == 1}
    found |= {"blades: near" for s in slips if "blades" in s}
    found |= {"derailer with points" for d in (body.get("derailers") or {}).values() if "machine" in d}
    found |= {"supervision of a machine" for x in machines if "supervision" in x}
    found |= {f"sections: {k}" for x in sections for k in ("speed", "one_way", "lane") if k in x}
    found |= {"tracks end to end" for x in tracks if re.search(r"\.end$", str(x))}
    found |= {"identifier" for g in signals if "identifier" in g}
    found |= {"exclude: call-on" for x in body.get("exclude") or () if x.get("kind") == "call-on"}
    found |= {"air_lock" for x in (body.get("interlocks") or {}).values() if "air_lock" in x}
    found |= {"hold" for x in body.get("demand") or () if "hold" in x}
    found |= {"listed: no" for x in (body.get("routes") or {}).values() if "listed" in x}
    found |= {"names with spaces" for g in body.get("signals") or {} if " " in g}
    found |= {"names of other scripts" for g in body.get("signals") or {} if not g.isascii()}
    return frozenset(found)


PARTS = (
    *(
        "conditions",
        "substations",
        "health",
        "telegram",
        "exclude",
        "hostile",
        "demand",
        "waive",
        "routes",
        "automatic",
    ),
    "voyages",
)
HOLDS = ("0.5", "12.5", "30", "90")
"""Seconds for which what a route demands is held longer."""
MACHINES = ("points", "slips", "derailers", "level_crossings", "interlocks")
OVERLAPS = ("ways", "entry_speed", "release", "release_by_length", "falling")

Added = Callable[[random.Random, Layout, InterlockingTable], list[str]]
"""Lines that may be added to a layout's text, once its routes are known."""


def routes_text(r: RouteRow) -> str:
    """A route as the language names it."""
    return f"from: {r.entry}, to: {r.path.destination or r.exit}, via: [{', '.join(r.path.section_ids)}]"


def hostile_and_demand(rng: random.Random, layout: Layout, table: InterlockingTable) -> tuple[list[str], list[str]]:
    """Additions of the author, chosen at random."""
    hostile, demand = [], []
    for _ in range(3):
        one, other = rng.sample(table.routes, 2)
        choices = [f"{{from: {r.entry}, to: {r.exit}, kind: {_kind(r)}}}" for r in (one, other)]
        hostile.append(f"  - {{one: {choices[0]}, other: {choices[1]}, reason: by chance}}")
    free = [
        (r, p)
        for r in table.routes
        for p in layout.pointwork.points
        if all(d.machine != p.machine for d in r.locking.points)
    ]
    halves = {b.point for b in layout.pointwork.blades}
    for r, p in rng.sample(free, min(2, len(free))):
        lies = rng.choice(("normal", "reverse"))
        name = p.machine if p.id in halves else p.id
        alone = ", kind: call-on" if r.kind is RouteKind.CALL_ON else ""
        demand.append(f"  - {{point: {name}, lies: {lies}, routes: {{{routes_text(r)}{alone}}}, reason: by chance}}")
    for r in rng.sample(table.routes, 2):  # not under its movement, nor where it stands before
        entry = {e.section for e in layout.track.edges_at[r.path.entry_node]}
        no = {*r.path.section_ids, *entry, *layout.track.undetected, *(b.approach for b in layout.track.boundaries)}
        beside = [s.id for s in layout.track.sections if s.id not in no]
        if beside and r.path.onward is None and r.kind is not RouteKind.IDENTIFIER:
            clear = f"clear: {rng.choice(beside)}, routes: {{{routes_text(r)}, kind: {_kind(r)}}}"
            demand.append(f"  - {{{clear}, reason: by chance}}")
    return hostile, demand


def _kind(r: RouteRow) -> str:
    return "call-on" if r.kind is RouteKind.CALL_ON else "main" if r.train else "shunt"


def _additions(rng: random.Random, layout: Layout, table: InterlockingTable) -> list[str]:
    if len(table.routes) < 4:
        return []
    hostile, demand = hostile_and_demand(rng, layout, table)
    return ["hostile:", *hostile[: rng.choice([0, 1, 3])], *(["demand:", *demand] if demand else [])]


def _overlaps(rng: random.Random, layout: Layout, table: InterlockingTable) -> list[str]:
    """Overlaps whose alternatives have lengths and entry speeds of their own, and times of release."""
    out = []
    for o in layout.overlaps.all:
        paths = overlap_paths(layout, o.signal)
        line = int(layout.principles.line_speed_kmh)
        speed = [f"entry_speed: {min(rng.choice([30, 60]), line)}"] if rng.random() < 0.5 else []
        parts = [f"length: {min(o.length, 150):g}", *speed]
        if rng.random() < 0.4:
            parts.append(rng.choice(["release: 75", "release_by_length: yes"]))
        if rng.random() < 0.2:
            parts = ["speed: 40, falling: 3"]
        last = [t.section for t in (paths or ((),))[-1]]
        own = [s for s in last if any(s not in {t.section for t in p} for p in paths)]
        if own:
            before = sum(t.length for t in paths[-1][: last.index(own[0])])
            beyond = before + rng.choice([5, 40, 200])
            parts.append(f"ways: [{{over: [{own[0]}], length: {beyond}, entry_speed: {min(25, line)}}}]")
        out.append(f"  {o.signal}: {{{', '.join(parts)}}}")
    return ["overlaps:", *out] if out else []


def _names(rng: random.Random, layout: Layout, table: InterlockingTable) -> list[str]:
    chosen = rng.sample(table.routes, min(2, len(table.routes)))
    listed = [rng.choice(["", ", listed: no"]) for _ in chosen]
    lines = [f"  J{i}: {{{routes_text(r)}{x}}}" for i, (r, x) in enumerate(zip(chosen, listed, strict=True))]
    return ["routes:", *lines]


def _automatic(rng: random.Random, layout: Layout, table: InterlockingTable) -> list[str]:
    main = [r for r in table.routes if r.kind is RouteKind.MAIN]
    return ["automatic:", f"  - {{{routes_text(rng.choice(main))}}}"] if main else []


def _voyages(rng: random.Random, layout: Layout, table: InterlockingTable) -> list[str]:
    after = {r.entry: r for r in table.routes if r.kind is RouteKind.MAIN}
    pairs = [(r, after[r.exit]) for r in after.values() if r.exit in after]  # type: ignore[index]
    if not pairs:
        return []
    a, b = rng.choice(pairs)
    return ["voyages:", f"  V: {{from: {a.entry}, to: {b.exit}, direction: {rng.choice(['forward', 'reverse'])}}}"]


def _exclude(rng: random.Random, layout: Layout, table: InterlockingTable) -> list[str]:
    r = rng.choice(table.routes)
    return ["exclude:", f"  - {{{routes_text(r)}, reason: by chance}}"]


LATER: tuple[tuple[float, Added], ...] = (
    *((0.7, _overlaps), (0.2, _exclude), (0.3, _additions)),
    *((0.3, _names), (0.2, _automatic), (0.2, _voyages)),
)
"""What is added once routes are known, in this order, each with its chance."""


def with_part(text: str, lines: list[str]) -> str:
    """A text with a part of its own instead of the one of that name, if it had one."""
    if not lines:
        return text
    if lines[0] == "exclude:" and "\nexclude:\n" in text:  # beside what is excluded already
        return text.replace("\nexclude:\n", "\n" + "\n".join(lines) + "\n", 1)
    key = re.escape(lines[0])
    rest = re.sub(rf"(?m)^{key}\n(?: .*\n)*", "", text)
    return rest + "\n".join(lines) + "\n"


def waived(text: str, sink: Sink) -> str:
    """A text with waivers of the flanks that nothing protects."""
    named = [d.message.split(" from ")[1].split(";")[0] for d in sink.diagnostics if d.code == "IL4001"]
    flanks = sorted({x for x in named if re.fullmatch(r"\S+\.(normal|reverse)", x)})
    return with_part(text, ["waive:", *(f"  - {{flank: {x}, reason: by chance}}" for x in flanks)] if flanks else [])


def with_lights(rng: random.Random, text: str, table: InterlockingTable) -> str:
    """A text in which main signals to which a train route leads, and from which one leads on, may be passed."""
    trains = [r for r in table.routes if r.kind is RouteKind.MAIN]
    for g in sorted({r.exit for r in trains} & {str(r.entry) for r in trains}):
        if rng.random() < 0.6:
            text = re.sub(rf"(?m)^(  {re.escape(g)}: {{from: .*)}}$", r"\1, identifier: yes}", text)
    return text


def without_idle(text: str, sink: Sink) -> str:
    """A text without the signals from which no route leads."""
    idle = {str(d.about.name) for d in sink.diagnostics if d.code == "IL4003" and d.about}
    dropped = tuple(x for g in idle for x in (f"  {g}:", f"  V{g}:"))
    return "".join(x for x in text.splitlines(keepends=True) if not x.startswith(dropped)) if dropped else text


def called_off(seed: int, text: str, layout: Layout, table: InterlockingTable) -> str:
    """A text that excludes a call-on route alone."""
    rng = random.Random(f"called off {seed}")
    calling = [r for r in table.routes if r.kind is RouteKind.CALL_ON]
    if not calling or rng.random() < 0.6:
        return text
    chosen = routes_text(rng.choice(calling))
    return with_part(text, ["exclude:", f"  - {{{chosen}, kind: call-on, reason: by chance}}"])


def held_longer(seed: int, text: str, layout: Layout, table: InterlockingTable) -> str:
    """A text some of whose demands of points are held longer."""
    rng = random.Random(f"held {seed}")

    def some(found: re.Match[str]) -> str:
        return f"{found[1]}, hold: {rng.choice(HOLDS)}, reason" if rng.random() < 0.7 else found[0]

    return re.sub(r"(?m)^(  - \{point: .*), reason", some, text)


def with_air_lock(seed: int, text: str, layout: Layout, table: InterlockingTable) -> str:
    """A text with doors over two or three sections, those of one air lock; now and then with one of them held open, or
    shut, for longer by some route that does not lead over them.  No route leads over two of them, or has its train
    wait in the one while it needs the other."""
    rng = random.Random(f"air lock {seed}")
    if rng.random() < 0.4:
        return text
    needed = [
        {
            *r.path.section_ids,
            *(s for s, _ in (r.locking.overlap.ways if r.locking.overlap else ())),
            *(e.section for e in layout.track.edges_at[r.path.entry_node]),
        }
        for r in table.routes
    ]
    sections = sorted({s for r in table.routes for s in r.path.section_ids})
    for _ in range(20):
        chosen = rng.sample(sections, min(len(sections), rng.choice((2, 2, 2, 3))))
        if len(chosen) > 1 and all(len(x & {*chosen}) < 2 for x in needed):
            break
    else:
        return text
    part = ["interlocks:", *(f"  AL{i}: {{over: [{s}], air_lock: lock}}" for i, s in enumerate(chosen))]
    text = _with_more(text, part)
    beside = [r for r in table.routes if r.kind is RouteKind.MAIN and not {*r.path.section_ids} & {*chosen}]
    if beside and rng.random() < 0.3:
        route, lies = routes_text(rng.choice(beside)), rng.choice(("normal", "reverse"))
        held = f"  - {{point: AL0, lies: {lies}, routes: {{{route}}}, hold: {rng.choice(HOLDS)}, reason: by chance}}"
        text = _with_more(text, ["demand:", held])
    return text


def _with_more(text: str, lines: list[str]) -> str:
    """A text with more entries of a part that it may have already."""
    head = f"\n{lines[0]}\n"
    more = "\n".join(lines) + "\n"
    return text.replace(head, f"\n{more}", 1) if head in text else text + more


def with_indicators(seed: int, text: str, layout: Layout, table: InterlockingTable) -> str:
    """Some directions of departure have a route indicator."""
    rng = random.Random(f"indicators {seed}")
    head, rest = text.split("boundaries:\n", 1)
    lines = rest.splitlines(keepends=True)
    for i, line in enumerate(lines):
        if not line.startswith("  "):
            break
        if "trains: in}" not in line and rng.random() < 0.3:
            lines[i] = line.replace(": {", ": {indicator: yes, ", 1)
    return f"{head}boundaries:\n{''.join(lines)}"


LAST = (called_off, held_longer, with_air_lock, with_indicators)
"""What is chosen by the seed alone, so that what grew before stays as it was."""


def spaced(text: str, sign: str) -> str:
    """A layout with a space after the first word of its names, `Gl G34`, where these began with a sign."""
    text = text.replace(sign, "Gl ")
    body = loaded(text)
    names = dict.fromkeys(x.rsplit(None, 1)[0] for items in body["tracks"].values() for x in items if x.count(" ") > 1)
    more = "".join(f"  {n}: {{}}\n" for n in names if n not in (body.get("sections") or {}))
    head, key, rest = f"\n{text}".partition("\nsections:\n")
    return (head + key + more + rest if key else f"{text}sections:\n{more}").lstrip("\n")


def grow_all(seed: int) -> str:
    """The text of a layout with every kind of element; most, not all, are valid."""
    rng = random.Random(f"all {seed}")
    g = Everything(rng, rng.random() < 0.6, script=rng.choice(SCRIPTS))
    g.grow(rng.randint(1, 9))
    g.pair_machines()
    g.place_signals()
    text = within_line(g.text())
    if g.script[0] in "Ж\u00e9" and random.Random(f"spaces {seed}").random() < 0.5:
        text = spaced(text, g.script[0])
    found = grown(text)
    for _ in range(3):
        if found is not None and any(d.code == "IL4003" for d in found[2].diagnostics):
            text = without_idle(text, found[2])
            found = grown(text)
    text = driven(text)
    found = grown(text)
    if found is not None and found[2].has_errors and rng.random() < 0.5:
        text = waived(text, found[2])
        found = grown(text)
    lights = random.Random(f"lights {seed}")
    if found is not None and not found[2].has_errors and lights.random() < 0.4:
        more = with_lights(lights, text, found[1])
        again = grown(more)
        if again is not None and not again[2].has_errors:
            text, found = more, again
    for chance, part in LATER:
        if found is None or found[2].has_errors or not found[1].routes or rng.random() >= chance:
            continue
        more = with_part(text, part(rng, found[0], found[1]))
        again = grown(more)
        if again is not None and not again[2].has_errors and again[1].routes:
            text, found = more, again
    for part in LAST if found is not None and not found[2].has_errors else ():
        more = part(seed, text, found[0], found[1])
        again = grown(more) if more != text else None
        if again is not None and not again[2].has_errors and again[1].routes:
            text = more
    return text
