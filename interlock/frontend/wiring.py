"""Pass 2: tracks, points and crossings become edges and nodes.

Every end of a track, point or crossing arm is a *port*; the file joins ports in pairs.  Each pair becomes
one node.  Output: edges, points, crossings, boundaries, buffers; diagnostics IL2001-IL2005, IL3001-IL3004,
IL3015, IL3017.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from functools import partial

from interlock.diag import Span
from interlock.diag.called import called
from interlock.diag.suggest import did_you_mean
from interlock.frontend.context import Context
from interlock.frontend.kilometres import Kilometres, Measured, Stretch, has_positions, is_section, measured
from interlock.frontend.mistaken import for_an_end
from interlock.frontend.parts import build_derailer, build_slip
from interlock.frontend.ports import Port, Wiring
from interlock.frontend.scalars import (
    NAME,
    item_parts,
    length_behind,
    name_fix,
    no_name,
    number_fix,
    slip_of,
)
from interlock.frontend.spaces import section_and_length, spoken_of, sure, sure_approach
from interlock.model.elements import (
    BlockKind,
    Boundary,
    BoundaryKind,
    Buffer,
    BufferKind,
    Crossing,
    CrossingId,
    Edge,
    EdgeId,
    MachineId,
    NodeId,
    Point,
    PointId,
    SectionId,
    Work,
)
from interlock.model.principles import Principles


def _after_comma(items: Sequence[str], i: int) -> bool:
    """Whether an item is what follows the decimal comma of the length before it: `[q3 600,5]` are two items."""
    return i > 0 and items[i].strip().isdigit() and re.fullmatch(r".*\S\s+\d+", items[i - 1].strip()) is not None


_DECIMAL_KM = re.compile(r"\d{1,4}[.,]\d{3}")
"""A position along the line as others write it: `12.345`."""


def _as_section_or_end(name: str) -> str:
    """How a name that stands alone in a track is written as a section, and where it is declared as an end."""
    end = f"declare {name} under `boundaries`, or under `buffers` if the track ends there"
    return f"write `{name} 100`, or {end}" if NAME.fullmatch(name) else f"write a section as `q1 100`; or {end}"


class Wirer:
    """Builds the graph; one instance per file."""

    def __init__(self, ctx: Context, principles: Principles) -> None:
        self.ctx = ctx
        self.principles = principles
        self.out = Wiring()
        self.mate: dict[Port, tuple[Port, Span]] = {}
        self.tracks: dict[str, Measured] = {}
        f = ctx.file
        self._read_into = dict.fromkeys(n for g in f.signals.values() for n in (g.from_, g.into) if not n.isdigit())
        joinable = [*f.tracks, *f.points, *f.crossings, *f.slips, *f.derailers, *f.boundaries, *f.buffers, *f.traps]
        self._joinable = dict.fromkeys(joinable)
        self._positions = has_positions(f)
        self._spoken_of = spoken_of(f, self._positions)
        self.lengths: dict[str, tuple[str, float]] = {}
        """Approach section and its metres, by boundary."""

    def run(self) -> Wiring:
        """All steps; the graph is complete only when no error was reported."""
        self._read_approaches()
        self._read_tracks()
        self._read_sections_of_points()
        self._join_points()
        self._join_crossings()
        self._join_slips()
        self._join_derailers()
        self._check_complete()
        if self._positions and not self.ctx.sink.has_errors:
            beyond = {p: self._side(other) for p, (other, _) in self.mate.items()}
            Kilometres(self.ctx, self.tracks, self.mate, beyond, self.principles.leg_m).resolve()
        if not self.ctx.sink.has_errors:
            self._build()
        return self.out

    # --- reading -------------------------------------------------------------------------------

    def _read_approaches(self) -> None:
        for name, b in self.ctx.file.boundaries.items():
            if b.approach is None:
                continue
            span = self.ctx.at("boundaries", name, "approach")
            got = section_and_length(self.ctx, b.approach, span, f"ap_{name}")
            if got is not None and sure_approach(self.ctx, b.approach, span, self._spoken_of):
                if got[0] in self.out.approaches:
                    self.ctx.add(
                        "IL2002",
                        f"{got[0]} is already the approach of another boundary",
                        span,
                        "every boundary has an approach section of its own",
                    )
                self.out.approaches[got[0]] = span
                self.lengths[name] = got

    def _read_tracks(self) -> None:
        f = self.ctx.file
        ends = set(f.boundaries) | set(f.buffers) | set(f.traps)
        for name, items in f.tracks.items():
            track, readable = Measured([]), 0
            head: Port | None = None
            for i, item in enumerate(items):
                span = self.ctx.at("tracks", name, i)
                if measured(self.ctx, track, item.strip(), span):
                    readable += 1
                    continue
                if not sure(self.ctx, name, i, self._spoken_of):
                    continue
                whole = " " not in item or item in self._spoken_of.sections
                if self._positions and item not in ends and is_section(item) and whole:
                    track.stretches.append(Stretch(item, None, span))
                    self.out.sections.setdefault(item, span)
                    continue
                if self._alone(item.strip(), ends):
                    if self._decimals(items, i, span):
                        continue
                    port = self._terminal(name, item.strip(), ends, span, first=i == 0, last=i == len(items) - 1)
                    if port is None:
                        continue
                    readable += 1
                    if i == 0:
                        head = port
                    elif track.stretches:
                        self._join(Port("track", name, "end"), port, span)
                    continue
                if i + 1 < len(items) and _after_comma(items, i + 1):
                    continue  # reported with what follows
                got = section_and_length(self.ctx, item, span)
                if got is None:
                    continue
                track.stretches.append(Stretch(*got, span))
                self.out.sections.setdefault(got[0], span)
            if not track.stretches:
                if readable == len(items):  # else some of them could not be read
                    self.ctx.add(
                        "IL3017",
                        f"the {called('track', name)} has no section",
                        self.ctx.at_key("tracks", name),
                        "give it a section with a length, or join the boundary to the point directly",
                    )
                continue
            if head is not None:
                self._join(Port("track", name, "start"), head, self.ctx.at("tracks", name, 0))
            self.tracks[name] = track

    def _alone(self, item: str, ends: set[str]) -> bool:
        """Whether an item of a track is a name without a length, in which spaces may be."""
        name, metres = item_parts(item)
        known = item in self._spoken_of.sections or name.partition(".")[0] in self._joinable
        return len(item.split()) < 2 or item in ends or (not metres and known)

    def _decimals(self, items: Sequence[str], i: int, span: Span) -> bool:
        """Report `q3 600,5`, which YAML reads as two items, at what stands after the comma."""
        if not _after_comma(items, i):
            return False
        text = f"{items[i - 1].strip()},{items[i].strip()}"
        name, length = text.rsplit(None, 1)
        self.ctx.add(
            "IL1013",
            f"the length of {name}, '{length}', is not a number",
            span._replace(column=max(1, span.column - len(length) + len(items[i].strip())), width=len(length)),
            number_fix(length),
            cause=slip_of(length),
            note=text,
        )
        return True

    def _terminal(self, track: str, name: str, ends: set[str], span: Span, *, first: bool, last: bool) -> Port | None:
        """What a track begins or ends with: a boundary, a buffer, or an end of something else (`west.end`)."""
        if "." in name and (first or last) and name.partition(".")[0] in self._joinable:
            return self.resolve(name, span)
        if name not in ends:
            joined = [s for s in self._read_into if length_behind(name, s)]
            if joined:
                said = f"{name}: a space is missing between the section and its length"
                self.ctx.add("IL2005", said, span, f"write `{joined[0]} {length_behind(name, joined[0])}`")
                return None
            if _DECIMAL_KM.fullmatch(name):
                fix = f"write `{re.sub('[.,]', '+', name)}`: kilometres, a plus, and three digits of metres"
                said = f"{name} is no position along the line"
                self.ctx.add("IL2005", said, span, fix, cause="decimal kilometres", note=name)
                return None
            if any(_DECIMAL_KM.fullmatch(x.strip()) for x in self.ctx.file.tracks[track]) and NAME.fullmatch(name):
                return None  # its length follows from positions, which are reported
            self.ctx.add(
                "IL2005",
                f"{name} is neither a boundary nor a buffer, and a section needs a length",
                span,
                did_you_mean(name, ends, _as_section_or_end(name)),
            )
            return None
        if not (first or last):
            self.ctx.add(
                "IL3015",
                f"{name} stands in the middle of a track",
                span,
                "a boundary or buffer is the first or the last thing on a track",
            )
            return None
        return self._end_port(name)

    def _end_port(self, name: str) -> Port:
        return Port("boundary" if name in self.ctx.file.boundaries else "buffer", name)

    def _read_sections_of_points(self) -> None:
        for name, slip in self.ctx.file.slips.items():
            self.out.sections.setdefault(slip.section, self.ctx.at("slips", name, "section"))
        for name, derailer in self.ctx.file.derailers.items():
            self.out.sections.setdefault(derailer.section, self.ctx.at("derailers", name, "section"))
        for name, p in self.ctx.file.points.items():
            self.out.sections.setdefault(p.section, self.ctx.at("points", name, "section"))
        for name, c in self.ctx.file.crossings.items():
            for i, arm in enumerate(c.arms):
                self.out.sections.setdefault(arm.section, self.ctx.at("crossings", name, "arms", i, "section"))

    # --- joining -------------------------------------------------------------------------------

    def _join_points(self) -> None:
        for name, p in self.ctx.file.points.items():
            for end, ref in (("toe", p.toe), ("normal", p.normal), ("reverse", p.reverse)):
                if ref is None:
                    continue
                span = self.ctx.at("points", name, end)
                target = self.resolve(ref, span)
                if target is not None:
                    self._join(Port("point", name, end), target, span)

    def _join_crossings(self) -> None:
        for name, c in self.ctx.file.crossings.items():
            for i, arm in enumerate(c.arms):
                for k, ref in enumerate(arm.ends):
                    span = self.ctx.at("crossings", name, "arms", i, "ends", k)
                    target = self.resolve(ref, span)
                    if target is not None:
                        self._join(Port("crossing", name, f"{i + 1}{'ab'[k]}"), target, span)

    def _join_slips(self) -> None:
        for name, slip in self.ctx.file.slips.items():
            for i, arm in enumerate(slip.arms):
                span = self.ctx.at("slips", name, "arms", i)
                if len(arm) != 2:
                    self.ctx.add(
                        "IL1012",
                        f"slips.{name}.arms.{i}: a list of two is expected here, not a list of {len(arm)}",
                        span,
                        "an arm joins two ends",
                    )
                    continue
                for k, ref in enumerate(arm):
                    target = self.resolve(ref, self.ctx.at("slips", name, "arms", i, k))
                    if target is not None:
                        self._join(Port("slip", name, f"{i + 1}{'ab'[k]}"), target, span)

    def _join_derailers(self) -> None:
        for name, d in self.ctx.file.derailers.items():
            for end, ref in (("outer", d.outer), ("inner", d.inner)):
                if ref is not None:
                    span = self.ctx.at("derailers", name, end)
                    target = self.resolve(ref, span)
                    if target is not None:
                        self._join(Port("derailer", name, end), target, span)

    def resolve(self, ref: str, span: Span) -> Port | None:
        """A reference as a port; reports IL2001 and IL2003."""
        f = self.ctx.file
        name, dot, end = ref.strip().partition(".")
        if not dot:
            if name in f.boundaries or name in f.buffers or name in f.traps:
                return self._end_port(name)
            ends = "toe, normal or reverse" if name in f.points else "start or end"
            if name in f.points or name in f.tracks:
                first = "toe" if name in f.points else "start"
                self.ctx.add("IL2003", f"{name} has several ends", span, f"say which: {name}.{first}, ... ({ends})")
                return None
        for kind, names, ends_ in (
            ("track", f.tracks, ("start", "end")),
            ("point", f.points, ("toe", "normal", "reverse")),
            ("crossing", f.crossings, ("1a", "1b", "2a", "2b")),
            ("slip", f.slips, ("1a", "1b", "2a", "2b")),
            ("derailer", f.derailers, ("outer", "inner")),
        ):
            if name in names:
                if end in ends_:
                    return Port(kind, name, end)
                self.ctx.add(
                    "IL2003",
                    f"the {kind} {name} has no end `{end}`" if dot else f"{name} has several ends",
                    span,
                    did_you_mean(
                        ref.strip(),
                        [f"{name}.{e}" for e in ends_],
                        f"write {name}. and one of its ends: " + ", ".join(ends_),
                    ),
                )
                return None
        if name in f.boundaries or name in f.buffers or name in f.traps:
            self.ctx.add("IL2003", f"{name} has only one end", span, f"write `{name}`")
            return None
        if not NAME.fullmatch(name):
            self.ctx.add("IL1016", no_name(name), span, name_fix(name))
            return None
        hint = did_you_mean(name, self._joinable, of_another_kind=partial(for_an_end, f))
        self.ctx.add("IL2001", f"there is no track, point, boundary or buffer {name}", span, hint)
        return None

    def _join(self, a: Port, b: Port, span: Span) -> None:
        if a == b or (a.kind == b.kind in ("track", "point", "crossing", "slip", "derailer") and a.name == b.name):
            self.ctx.add(
                "IL3001",
                f"{a} is wired to {b}, the same element",
                span,
                "an end leads to another track, point or boundary",
            )
            return
        for x, y in ((a, b), (b, a)):
            if x in self.mate and self.mate[x][0] != y:
                other, where = self.mate[x]
                if x is a:
                    self.ctx.add(
                        "IL3004",
                        f"{a} is joined to {b} here, but {other} says otherwise in line {where.line}",
                        span,
                        "make both ends agree, or leave one of them out",
                    )
                elif other.kind == a.kind == "point" and other.name == a.name:
                    self.ctx.add(
                        "IL3002",
                        f"{a.name} is wired to {x} twice ({other.end} and {a.end})",
                        span,
                        "toe, normal and reverse lead to three different ends",
                    )
                else:
                    self.ctx.add(
                        "IL3002",
                        f"{x} is joined to {other} already (line {where.line})",
                        span,
                        "exactly two ends meet in one place" + self._other_end(x),
                    )
                return
        self.mate[a] = (b, span)
        self.mate[b] = (a, span)

    def _other_end(self, taken: Port) -> str:
        """Of a track with an end that is taken: whether the other one is meant, if nothing is joined there yet."""
        other = Port("track", taken.name, "start" if taken.end == "end" else "end")
        return f": is {other} meant?" if taken.kind == "track" and other not in self.mate else ""

    def _check_complete(self) -> None:
        f = self.ctx.file
        wanted: list[tuple[Port, Span, str]] = []
        for name in self.tracks:
            for end in ("start", "end"):
                wanted.append(
                    (
                        Port("track", name, end),
                        self.ctx.at_key("tracks", name),
                        "join it to a point, put a boundary there, or a buffer if the track ends",
                    )
                )
        for name in f.points:
            for end in ("toe", "normal", "reverse"):
                wanted.append((Port("point", name, end), self.ctx.at_key("points", name), f"add `{end}: ...`"))
        for name in f.derailers:
            for end in ("outer", "inner"):
                wanted.append((Port("derailer", name, end), self.ctx.at_key("derailers", name), f"add `{end}: ...`"))
        for name in f.boundaries:
            wanted.append(
                (
                    Port("boundary", name),
                    self.ctx.at_key("boundaries", name),
                    "name it at the start or the end of a track",
                )
            )
        for i, name in enumerate(f.buffers):
            wanted.append(
                (Port("buffer", name), self.ctx.at("buffers", i), "name it at the start or the end of a track")
            )
        for i, name in enumerate(f.traps):
            wanted.append((Port("buffer", name), self.ctx.at("traps", i), "name it at the end of a track"))
        if self.ctx.sink.has("IL2001", "IL2003", "IL2005", "IL3001", "IL3002", "IL3004", "IL3017", "IL1"):
            return  # what is missing may only be misspelt
        loose = [(port, span, fix) for port, span, fix in wanted if port not in self.mate]
        if len(loose) == 2 and loose[0][0].name != loose[1][0].name:
            self._loose_pair((loose[0][0], loose[0][1]), (loose[1][0], loose[1][1]))
            return
        for port, span, fix in loose:
            self.ctx.add("IL3003", f"{port} is joined to nothing", span, fix)
        for port, (other, span) in sorted(self.mate.items()):
            if port.kind in ("boundary", "buffer") and other.kind in ("boundary", "buffer") and port < other:
                self.ctx.add(
                    "IL3015",
                    f"{port} and {other} are joined without a track between",
                    span,
                    "put a section between them",
                )

    def _loose_pair(self, *ends: tuple[Port, Span]) -> None:
        """Report the only two ends that are joined to nothing: they are probably meant for each other."""
        order = ("track", "point", "crossing", "slip", "derailer", "boundary", "buffer")
        (a, at), (b, beside) = sorted(ends, key=lambda x: -order.index(x[0].kind))
        fix = f"is {b} joined to {a}? then write " + (f"`{a.end}: {b}` at {a.name}" if a.end else f"{a} into its track")
        if b.kind == "track" and not a.end:
            fix = f"put {a} {'first' if b.end == 'start' else 'last'} into the track {b.name}, if it ends there"
        elif a.kind == "track":
            fix = (
                f"does {b.name} go on at {a.name}? then put {a} {'first' if b.end == 'start' else 'last'} into {b.name}"
            )
        for port, span, other in ((a, at, b), (b, beside, a)):
            said = f"{port} is joined to nothing, and neither is {other}"
            self.ctx.add("IL3003", said, span, fix, cause="pair", note=str(port))

    # --- building ------------------------------------------------------------------------------

    def node(self, port: Port) -> NodeId:
        """The node of an end and of what it is joined to, one name whichever is asked for."""
        other = self.mate[port][0]
        for p in (port, other):
            if p.kind in ("boundary", "buffer"):
                return NodeId(p.name)
        a, b = sorted((self._section_at(port), self._section_at(other)))
        first, second = sorted((str(port), str(other)))
        return NodeId(f"{a}|{b}@{first}") if a != b else NodeId(f"{a}@{first}+{second}")

    def _side(self, port: Port) -> str:
        """What lies at an end: a section, or the boundary or buffer itself."""
        return port.name if port.kind in ("boundary", "buffer") else self._section_at(port)

    def _section_at(self, port: Port) -> str:
        f = self.ctx.file
        if port.kind == "track":
            return self.tracks[port.name].stretches[0 if port.end == "start" else -1].section
        if port.kind == "point":
            return f.points[port.name].section
        if port.kind == "slip":
            return f.slips[port.name].section
        if port.kind == "derailer":
            return f.derailers[port.name].section
        return f.crossings[port.name].arms[int(port.end[0]) - 1].section

    def edge(self, name: str, a: NodeId, b: NodeId, length: float, section: str) -> EdgeId:
        """Adds an edge of so many metres; where the section is one way backward, from b to a."""
        spec = self.ctx.file.sections.get(section)
        one_way = spec.one_way if spec is not None else None
        inclined = spec is not None and spec.lane == "inclined"
        if one_way == "backward":
            a, b = b, a
        self.out.edges.append(Edge(EdgeId(name), a, b, length, SectionId(section), one_way is not None, inclined))
        return EdgeId(name)

    def _build(self) -> None:
        f = self.ctx.file
        self._build_tracks()
        self._build_points()
        self._build_crossings()
        self._build_boundaries()
        self.out.buffers.extend(Buffer(NodeId(name)) for name in f.buffers)
        self.out.buffers.extend(Buffer(NodeId(name), BufferKind.TRAP) for name in f.traps)
        for name, slip in f.slips.items():
            build_slip(self, name, slip)
        for name, d in f.derailers.items():
            build_derailer(self, name, d)

    def _build_tracks(self) -> None:
        for name, track in self.tracks.items():
            here, stretches = self.node(Port("track", name, "start")), track.stretches
            for i, s in enumerate(stretches):
                if i == len(stretches) - 1:
                    there = self.node(Port("track", name, "end"))
                elif stretches[i + 1].section == s.section:
                    there = NodeId(f"{s.section}+{name}.{i}")
                else:
                    a, b = sorted((s.section, stretches[i + 1].section))
                    there = NodeId(f"{a}|{b}@{name}.{i}")
                assert s.length is not None
                self.edge(f"{name}.{i}", here, there, s.length, s.section)
                here = there

    def _build_points(self) -> None:
        for name, p in self.ctx.file.points.items():
            length = p.legs if p.legs is not None else self.principles.leg_m
            legs = {
                end: self.edge(f"{name}.{end}", NodeId(name), self.node(Port("point", name, end)), length, p.section)
                for end in ("toe", "normal", "reverse")
            }
            fouling = p.fouling if p.fouling is not None else self.principles.fouling_m
            self.out.points.append(
                Point(
                    PointId(name),
                    MachineId(p.machine or name),
                    NodeId(name),
                    legs["toe"],
                    legs["normal"],
                    legs["reverse"],
                    fouling,
                    Work(p.work),
                    speed=p.speed,
                )
            )

    def _build_crossings(self) -> None:
        for name, c in self.ctx.file.crossings.items():
            length = c.legs if c.legs is not None else self.principles.leg_m
            fouling = c.fouling if c.fouling is not None else self.principles.fouling_m
            arms = []
            for i, arm in enumerate(c.arms):
                pair = [
                    self.edge(
                        f"{name}.{i + 1}{side}",
                        NodeId(name),
                        self.node(Port("crossing", name, f"{i + 1}{side}")),
                        length,
                        arm.section,
                    )
                    for side in "ab"
                ]
                arms.append((pair[0], pair[1]))
            self.out.crossings.append(Crossing(CrossingId(name), NodeId(name), (arms[0], arms[1]), fouling))

    def _build_boundaries(self) -> None:
        for name, spec in self.ctx.file.boundaries.items():
            approach, metres = self.lengths.get(name, (None, 0.0))
            self.out.boundaries.append(
                Boundary(
                    NodeId(name),
                    BoundaryKind(spec.trains),
                    SectionId(approach) if approach else None,
                    BlockKind(spec.block),
                    spec.button,
                    spec.indicator,
                    metres,
                )
            )
