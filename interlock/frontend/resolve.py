"""Pass 3: signals, conditions, named routes and waivers, once the graph stands.

Output: diagnostics IL2004, IL2006, IL3005-IL3007, IL2008 (malformed), and the elements.
"""

from __future__ import annotations

from collections.abc import Collection
from functools import partial

from interlock.diag import Span
from interlock.diag.called import called
from interlock.diag.suggest import did_you_mean
from interlock.frontend.context import Context
from interlock.frontend.doors import as_door, check_doors
from interlock.frontend.mistaken import ends_of_layout, for_a_section, is_end
from interlock.frontend.parts import points_of
from interlock.frontend.pieces import report_split
from interlock.frontend.ports import Wiring
from interlock.frontend.scalars import item_parts, length_behind
from interlock.frontend.schema import ChoiceSpec, RouteSpec, SignalSpec
from interlock.model.elements import (
    Choice,
    Condition,
    ConditionId,
    Device,
    DeviceKind,
    Distant,
    Edge,
    Exclude,
    Hand,
    MachineId,
    NamedRoute,
    NodeId,
    PointId,
    Position,
    SectionId,
    Signal,
    SignalId,
    SignalKind,
    TitleBlock,
    Voyage,
    Waiver,
    Zone,
)


def _edges_at(wiring: Wiring) -> dict[NodeId, list[Edge]]:
    at: dict[NodeId, list[Edge]] = {}
    for e in wiring.edges:
        at.setdefault(e.a, []).append(e)
        at.setdefault(e.b, []).append(e)
    return at


def check_signal_names(ctx: Context, wiring: Wiring) -> None:
    """Report signals that name no section; runs even when the graph does not stand yet."""
    meant = _meant(ctx, wiring)
    unread = [m for m in meant if m not in wiring.sections and m not in ctx.file.boundaries]
    sections = (wiring.sections.keys() | meant) - ctx.file.boundaries.keys()
    known = sections | ctx.file.boundaries.keys()
    beside = _neighbours(wiring, _edges_at(wiring))
    for name, spec in ctx.file.signals.items():
        for key, value, names, other in (
            ("from", spec.from_, known, spec.into),
            ("into", spec.into, sections, spec.from_),
        ):
            if value not in names:
                span = ctx.at("signals", name, key)
                if any(length_behind(item, value) for item in unread):
                    continue  # the item is reported: a space is missing in it
                if value in wiring.approaches:
                    hint = "an entry signal stands at the boundary: write the boundary's name after `from`"
                    ctx.add("IL2004", f"{called('signal', name)}: {value} is the approach section, outside", span, hint)
                else:
                    kind = "section or boundary" if key == "from" else "section"
                    near = [n for n in beside.get(other, ()) if n in names]
                    meets = f"{other} meets: {', '.join(near)}" if near else ""
                    what = called("signal", name)
                    _unknown(ctx, kind, value, span, near or names, what, of_a_signal=True, otherwise=meets)


def _meant(ctx: Context, wiring: Wiring) -> set[str]:
    """What may be the name of a section in an item of a track that cannot be read, which is reported."""
    ends = ends_of_layout(ctx.file)
    items = [x for those in ctx.file.tracks.values() for x in those if x.strip() and " ".join(x.split()) not in ends]
    items = [x for x in items if not is_end(ctx.file, x.strip())]
    unclear = [item.split() for item in items if item_parts(item)[0] not in wiring.sections]
    return {" ".join(words[:k]) for words in unclear for k in range(1, max(2, len(words)))} - ends


def no_section(ctx: Context, wiring: Wiring, name: str, span: Span, what: str) -> None:
    """Report that `what` names a section that there is not, unless its track cannot be read, which is reported."""
    if name in wiring.sections or name in _meant(ctx, wiring):
        return
    if what and name in wiring.approaches:
        hint = (
            f"name sections inside, or let the layout begin before {name}: on a track, with an entry signal before it"
        )
        text = f"{what}: {name} is an approach section, outside the layout, which no route locks"
        ctx.add("IL2004", text, span, hint, cause=f"approach {name}", note=what)
    else:
        _unknown(ctx, "section", name, span, wiring.sections, what)


def resolve_signals(ctx: Context, wiring: Wiring) -> tuple[Signal, ...]:
    """Signals at their joints."""
    at = _edges_at(wiring)
    meets = _neighbours(wiring, at)
    special = {p.node for p in wiring.points} | {c.node for c in wiring.crossings}
    leading: dict[str, list[tuple[NodeId, Edge]]] = {}
    for node, edges in sorted(at.items()):
        for e in edges if node not in special else ():
            leading.setdefault(e.section, []).append((node, e))
    taken: dict[tuple[NodeId, str], str] = {}
    signals: list[Signal] = []
    split: frozenset[SectionId] | None = None
    for name, spec in ctx.file.signals.items():
        places = [
            (node, into)
            for node, into in leading.get(spec.into, ())
            if node == spec.from_ or any(e.section == spec.from_ and e.section != into.section for e in at[node])
        ]
        if spec.at is not None:
            places = [(n, e) for n, e in places if _near(wiring, at, n, spec.at)]
        if not places:
            near = f" next to {spec.at}" if spec.at else ""
            ctx.add(
                "IL3005",
                f"{called('signal', name)} stands at no joint: {spec.from_} and {spec.into} do not meet{near}",
                ctx.at("signals", name, "into"),
                f"{spec.into} meets: " + ", ".join(meets.get(spec.into, ())),
            )
            continue
        if len(places) > 1:
            split = report_split(ctx, wiring.edges) if split is None else split
            if not split & {spec.from_, spec.into}:
                ctx.add(
                    "IL3006",
                    f"{called('signal', name)}: {spec.from_} and {spec.into} meet in {len(places)} places",
                    ctx.at("signals", name, "into"),
                    _parted(spec) if spec.at else "add `at: POINT`, naming a point next to the joint meant",
                )
            continue
        node, into = places[0]
        if (node, into.section) in taken:
            _two_in_one(ctx, name, taken[node, into.section])
            continue
        taken[node, into.section] = name
        _check_kind(ctx, name, spec)
        signals.append(Signal(SignalId(name), node, into.id, _kind(spec), spec.call_on))
    return tuple(sorted(signals, key=lambda g: g.id))


def _check_kind(ctx: Context, name: str, spec: SignalSpec) -> None:
    """What is stated of a signal fits its kind."""
    if spec.call_on and spec.kind not in ("main", "combined"):
        what = "shunt signal" if spec.kind == "shunt" else "board"
        ctx.add(
            "IL2016",
            f"{name} is a {what}: it cannot call a train on",
            ctx.at("signals", name, "call_on"),
            "remove `call_on`, or make it a `main` or `combined` signal",
        )
    if spec.identifier and spec.kind not in ("main", "combined"):
        what = "shunt signal" if spec.kind == "shunt" else "board"
        text = f"{name} is a {what}: no train is to obey it, so that none is to be told to disregard it"
        fix = "remove `identifier`, or make it a `main` or `combined` signal"
        ctx.add("IL2025", text, ctx.at("signals", name, "identifier"), fix)
    if spec.stops_trains and spec.kind != "shunt":
        text = f"{name} is no shunt signal: `stops_trains` says nothing of it"
        ctx.add("IL3027", text, ctx.at("signals", name, "stops_trains"), "remove `stops_trains`")
    if spec.release is not None and spec.kind in ("board", "limit"):
        text = f"no route begins at {name}: `release` says nothing of it"
        ctx.add("IL3027", text, ctx.at("signals", name, "release"), "remove `release`")


def _kind(spec: SignalSpec) -> SignalKind:
    """The kind of signal whose routes end there."""
    if spec.kind == "board":
        return SignalKind.MAIN
    if spec.kind == "limit":
        return SignalKind.SHUNT
    return SignalKind.COMBINED if spec.stops_trains else SignalKind(spec.kind)


def title_block(ctx: Context) -> TitleBlock | None:
    """The title block of printed forms, where anything of it is stated."""
    block = TitleBlock(**ctx.file.title_block.model_dump())
    return None if block == TitleBlock() else block


def hands(ctx: Context) -> tuple[tuple[PointId, Hand], ...]:
    """The side to which the reverse leg of each point lies, where it is stated."""
    return tuple(sorted((PointId(n), Hand(p.hand)) for n, p in ctx.file.points.items() if p.hand is not None))


def resolve_supervision(ctx: Context, wiring: Wiring) -> tuple[tuple[MachineId, float], ...]:
    """Seconds of supervision by machine; the longest, where the two ends of one state different ones."""
    f, found = ctx.file, dict[MachineId, float]()
    machine_of = {str(p.id): p.machine for p in wiring.points}
    stated = [(machine_of[n], p.supervision) for n, p in f.points.items()]
    stated += [(machine_of[n], d.supervision) for n, d in f.derailers.items()]
    stated += [(machine_of[p], s.supervision) for n, s in f.slips.items() for p in points_of(n, s)]
    stated += [(MachineId(n), d.supervision) for n, d in (*f.level_crossings.items(), *f.interlocks.items())]
    for machine, seconds in stated:
        if seconds is not None:
            found[machine] = max(seconds, found.get(machine, 0.0))
    return tuple(sorted(found.items()))


def boards(ctx: Context) -> tuple[SignalId, ...]:
    """Stop boards and limit-of-shunt boards."""
    return tuple(sorted(SignalId(g) for g, x in ctx.file.signals.items() if x.kind in ("board", "limit")))


def stops(ctx: Context) -> tuple[SignalId, ...]:
    """Where train routes end and none begins."""
    return tuple(sorted(SignalId(g) for g, x in ctx.file.signals.items() if x.kind == "board" or x.stops_trains))


def identifiers(ctx: Context) -> tuple[SignalId, ...]:
    """Main signals that show an identifier light while a longer route passes them."""
    those = (g for g, x in ctx.file.signals.items() if x.identifier and x.kind in ("main", "combined"))
    return tuple(sorted(map(SignalId, those)))


def signal_releases(ctx: Context) -> tuple[tuple[SignalId, float], ...]:
    """Seconds for which the routes of a signal are held, where it has a time of its own (R8)."""
    return tuple(sorted((SignalId(g), x.release) for g, x in ctx.file.signals.items() if x.release is not None))


def _parted(spec: SignalSpec) -> str:
    """What to do where two sections meet twice at one point, as those of a balloon loop do."""
    parts = f"give {spec.from_} or {spec.into} two parts, each with a name of its own"
    return f"{spec.at} lies next to all of them: {parts}, so that one of them meets the other section there"


def _near(wiring: Wiring, at: dict[NodeId, list[Edge]], node: NodeId, point: str) -> bool:
    legs = {e for p in wiring.points if p.id == point for e in (p.toe, p.normal, p.reverse)}
    return any(e.id in legs for e in at[node])


def _neighbours(wiring: Wiring, at: dict[NodeId, list[Edge]]) -> dict[str, list[str]]:
    """What every section and boundary meets: the sections beyond its ends, and boundaries."""
    boundaries = {b.node for b in wiring.boundaries}
    found: dict[str, set[str]] = {}
    for node, edges in at.items():
        here = {e.section for e in edges} | ({node} & boundaries)
        for name in here:
            found.setdefault(name, set()).update(here - {name})
    return {name: sorted(others) for name, others in found.items()}


def resolve_conditions(ctx: Context, wiring: Wiring) -> tuple[Condition, ...]:
    """External conditions with what requires them."""
    out = []
    for name, spec in ctx.file.conditions.items():
        for i, s in enumerate(spec.over):
            no_section(ctx, wiring, s, ctx.at("conditions", name, "over", i), called("condition", name))
        for i, g in enumerate(spec.signals):
            if g not in ctx.file.signals:
                at = ctx.at("conditions", name, "signals", i)
                _unknown(ctx, "signal", g, at, ctx.file.signals, called("condition", name))
        for i, b in enumerate(spec.exits):
            if b not in ctx.file.boundaries:
                at = ctx.at("conditions", name, "exits", i)
                _unknown(ctx, "boundary", b, at, ctx.file.boundaries, called("condition", name))
        out.append(
            Condition(
                ConditionId(name),
                spec.text,
                tuple(sorted(map(SectionId, spec.over))),
                tuple(sorted(map(SignalId, spec.signals))),
                tuple(sorted(map(NodeId, spec.exits))),
            )
        )
        if not spec.over and not spec.signals and not spec.exits:
            ctx.add(
                "IL2011",
                f"no route requires {name}",
                ctx.at_key("conditions", name),
                "say what requires it: `over: [sections]`, `signals: [signals]` or `exits: [boundaries]`",
            )
    for name, boundary in ctx.file.boundaries.items():
        if boundary.block == "token":
            if boundary.trains != "both":
                ctx.add(
                    "IL2017",
                    f"{name} has a direction token, but trains run only one way there",
                    ctx.at_key("boundaries", name),
                    "write `trains: both`, or another block: `automatic` or `semi-automatic`",
                )
            continue
        if boundary.block != "none" and boundary.trains != "in":
            if block_condition(name) in ctx.file.conditions:
                ctx.add(
                    "IL2002",
                    f"{block_condition(name)} is the input of the block at {name}",
                    ctx.at_key("conditions", block_condition(name)),
                    "give the condition another name, or remove it",
                )
                continue
            text = f"block towards {name} free, direction ours"
            out.append(Condition(block_condition(name), text, (), (), (NodeId(name),)))
    return tuple(sorted(out, key=lambda c: c.id))


def block_condition(boundary: str) -> ConditionId:
    """The input that the block beyond a boundary gives: free, and the direction ours (R12)."""
    return ConditionId(f"BF/{boundary}")


def resolve_devices(ctx: Context, wiring: Wiring) -> tuple[Device, ...]:
    """Level crossings and other interlocks over their sections."""
    out = []
    for room, kind, specs in (
        ("level_crossings", DeviceKind.LEVEL_CROSSING, ctx.file.level_crossings),
        ("interlocks", DeviceKind.INTERLOCK, ctx.file.interlocks),
    ):
        for name, spec in specs.items():
            for i, s in enumerate(spec.over):
                no_section(ctx, wiring, s, ctx.at(room, name, "over", i), f"{kind} {name}")
            device = Device(MachineId(name), kind, spec.text, tuple(sorted(map(SectionId, spec.over))))
            out.append(as_door(ctx, device, spec))
    check_doors(ctx)
    return tuple(sorted(out, key=lambda d: d.id))


def _two_in_one(ctx: Context, name: str, first: str) -> None:
    """A second signal at a joint: on drawings often the shunt signal on the post of the main one."""
    kinds = {ctx.file.signals[n].kind for n in (first, name)}
    both = "shunt" in kinds and kinds & {"main", "combined"}
    fix = f"one signal gives both: `{first}: {{..., kind: combined}}`; remove {name}" if both else "remove one of them"
    text = f"{called('signal', name)} stands where {first} stands, in the same direction"
    ctx.add("IL3007", text, ctx.at_key("signals", name), f"{fix}, or turn it round: swap `from` and `into`")


def resolve_routes(ctx: Context, wiring: Wiring) -> tuple[NamedRoute, ...]:
    """Names that the author gives to routes; whether the routes exist is known after derivation."""
    out = []
    for name, spec in ctx.file.routes.items():
        _check_ends(ctx, wiring, spec, f"route {name}", ("routes", name))
        out.append(NamedRoute(name, SignalId(spec.from_), spec.to, tuple(map(SectionId, spec.via))))
    return tuple(sorted(out, key=lambda r: r.name))


def resolve_voyages(ctx: Context, wiring: Wiring) -> tuple[Voyage, ...]:
    """Voyages; of which routes they consist is known after derivation."""
    out = []
    for name, spec in ctx.file.voyages.items():
        _check_ends(ctx, wiring, spec, f"voyage {name}", ("voyages", name))
        shunt = spec.kind == "shunt"
        far = shunt if spec.order is None else spec.order == "far"
        via, forward = tuple(map(SectionId, spec.via)), spec.direction == "forward"
        out.append(Voyage(name, SignalId(spec.from_), spec.to, via, shunt, far, forward))
    return tuple(sorted(out, key=lambda v: v.name))


def resolve_automatic(ctx: Context, wiring: Wiring) -> tuple[NamedRoute, ...]:
    """Routes that may work automatically."""
    out = []
    for i, spec in enumerate(ctx.file.automatic):
        what = f"automatic route {spec.from_}-{spec.to}"
        _check_ends(ctx, wiring, spec, what, ("automatic", i))
        out.append(NamedRoute(str(i), SignalId(spec.from_), spec.to, tuple(map(SectionId, spec.via))))
    return tuple(out)


def _check_ends(ctx: Context, wiring: Wiring, spec: RouteSpec, what: str, at: tuple[str | int, ...]) -> None:
    if spec.from_ not in ctx.file.signals:
        _unknown(ctx, "signal", spec.from_, ctx.at(*at, "from"), ctx.file.signals, what)
    if not _is_end(ctx, wiring, spec.to):
        _unknown(ctx, "signal, boundary or buffer", spec.to, ctx.at(*at, "to"), _ends(ctx, wiring), what)
    for i, s in enumerate(spec.via):
        no_section(ctx, wiring, s, ctx.at(*at, "via", i), what)


def _ends(ctx: Context, wiring: Wiring) -> tuple[str, ...]:
    """Everything at which a route can end."""
    return (*ctx.file.signals, *ctx.file.boundaries, *ctx.file.buffers, *wiring.sections)


def _is_end(ctx: Context, wiring: Wiring, name: str) -> bool:
    return name in _ends(ctx, wiring) or name in _meant(ctx, wiring)


def _unknown(
    ctx: Context,
    kind: str,
    name: str,
    span: Span,
    known: Collection[str],
    what: str,
    *,
    of_a_signal: bool = False,
    otherwise: str = "",
) -> None:
    """Report a name that `what` refers to and nothing of the kind bears; one that is misspelt everywhere is one
    mistake.  `otherwise`: what to say where none of the known names is like it."""
    section = kind.startswith("section")
    message = f"{what}: there is no {kind} {name}" if what else f"there is no {kind} {name}"
    other = partial(for_a_section, ctx.file, of_a_signal=of_a_signal) if section else None
    hint = did_you_mean(name, known, otherwise, of_another_kind=other)
    ctx.add("IL2004" if section else "IL2006", message, span, hint, cause=name, note=what)


def resolve_choice(ctx: Context, wiring: Wiring, spec: ChoiceSpec, at: tuple[str | int, ...], what: str) -> Choice:
    """Routes chosen by their ends, sections and kind; whether there are any is known after derivation."""
    if spec.from_ is not None and spec.from_ not in ctx.file.signals:
        _unknown(ctx, "signal", spec.from_, ctx.at(*at, "from"), ctx.file.signals, what)
    if spec.to is not None and not _is_end(ctx, wiring, spec.to):
        _unknown(ctx, "signal, boundary or buffer", spec.to, ctx.at(*at, "to"), _ends(ctx, wiring), what)
    for key, sections in (("via", spec.via), ("not_via", spec.not_via)):
        for k, s in enumerate(sections):
            no_section(ctx, wiring, s, ctx.at(*at, key, k), what)
    entry = SignalId(spec.from_) if spec.from_ else None
    shunt, called_on = None if spec.kind is None else spec.kind == "shunt", spec.kind == "call-on"
    via, not_via = tuple(map(SectionId, spec.via)), tuple(map(SectionId, spec.not_via))
    return Choice(entry, spec.to, via, not_via, shunt, called_on=called_on)


def resolve_excludes(ctx: Context, wiring: Wiring) -> tuple[Exclude, ...]:
    """Routes not wanted."""
    out = []
    for i, spec in enumerate(ctx.file.exclude):
        x = resolve_choice(ctx, wiring, spec, ("exclude", i), "an exclusion")
        out.append(Exclude(x.entry, x.exit, x.via, x.not_via, x.shunt, spec.reason, called_on=x.called_on))
    return tuple(out)


def resolve_distants(ctx: Context, signals: tuple[Signal, ...]) -> tuple[Distant, ...]:
    """Distant and repeating signals, each with the main signal that it announces."""
    mains = {g.id for g in signals if g.main} - {*boards(ctx), *stops(ctx)}
    out = []
    for name, spec in sorted(ctx.file.distants.items()):
        if spec.of not in mains:
            ctx.add(
                "IL2006",
                f"distant {name} announces a main signal: {spec.of} is none",
                ctx.at("distants", name, "of"),
                did_you_mean(spec.of, mains),
            )
        else:
            out.append(Distant(SignalId(name), SignalId(spec.of)))
    return tuple(out)


def resolve_zones(ctx: Context, wiring: Wiring) -> tuple[Zone, ...]:
    """Zones with a maximum of trains."""
    out = []
    for name, spec in ctx.file.zones.items():
        for i, s in enumerate(spec.sections):
            no_section(ctx, wiring, s, ctx.at("zones", name, "sections", i), f"zone {name}")
        if not spec.sections:
            at = ctx.at_key("zones", name)
            ctx.add("IL2004", f"zone {name} has no section", at, "name them: `sections: [s1, s2]`")
        out.append(Zone(name, tuple(sorted({SectionId(s) for s in spec.sections})), spec.trains))
    return tuple(sorted(out, key=lambda z: z.id))


def resolve_waivers(ctx: Context) -> tuple[Waiver, ...]:
    """Waivers of flank protection; each needs an existing leg and a reason."""
    out = []
    for i, spec in enumerate(ctx.file.waive):
        name, _, leg = spec.flank.partition(".")
        span = ctx.at("waive", i, "flank")
        if name not in ctx.file.points:
            ctx.add("IL2001", f"the waiver names {name}, which is no point", span, did_you_mean(name, ctx.file.points))
            continue
        if leg not in ("normal", "reverse"):
            ctx.add(
                "IL2003",
                f"flank protection is asked at a leg: {name} has no leg `{leg}`",
                span,
                f"write {name}.normal or {name}.reverse",
            )
            continue
        if not spec.reason:
            ctx.add(
                "IL2009",
                f"the waiver of {spec.flank} gives no reason",
                span,
                "add `reason: ...`: say why a vehicle can never roll from there",
            )
            continue
        out.append(Waiver(PointId(name), Position.NORMAL if leg == "normal" else Position.REVERSE, spec.reason))
    return tuple(sorted(out, key=lambda w: (w.point, w.leg)))
