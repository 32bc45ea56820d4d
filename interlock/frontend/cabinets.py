"""What hangs on a layout beside its logic: cabinets and addresses (document B 2.2), and hints for the plan.

Output: diagnostics IL2004, IL2014, IL2015, IL3030, IL7018, and the elements.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from interlock.diag import Element
from interlock.diag.suggest import did_you_mean
from interlock.frontend.context import Context
from interlock.frontend.ports import Wiring
from interlock.frontend.scalars import ADDRESS
from interlock.frontend.schema import TargetSpec
from interlock.model.elements import Anchor, Health, NodeId, SectionId, Signal, Substation
from interlock.model.target import CPUS, KB, Target
from interlock.model.times import at_most_ms

ONLY = "main"
"""The cabinet of a layout that names none."""


def _wired(ctx: Context, wiring: Wiring) -> list[str]:
    """Everything that has a wire: sections, machines, devices, signals, distants, conditions."""
    f = ctx.file
    undetected = {s for s, spec in f.sections.items() if not spec.detected}
    sections = [s for s in (*wiring.sections, *wiring.approaches) if s not in undetected]
    machines = sorted({str(p.machine) for p in wiring.points})
    return [*sections, *machines, *f.level_crossings, *f.interlocks, *f.signals, *f.distants, *f.conditions]


def resolve_substations(ctx: Context, wiring: Wiring) -> tuple[Substation, ...]:
    """The cabinets in the order of the layout; every element is wired to exactly one."""
    given = ctx.file.substations
    known = dict.fromkeys(_wired(ctx, wiring))
    holder: dict[str, str] = {}
    rest = [name for name, elements in given.items() if not elements]
    for name, elements in given.items():
        for i, element in enumerate(elements):
            span = ctx.at("substations", name, i)
            if element not in known:
                ctx.add(
                    "IL2014",
                    f"substation {name}: {element} is no section, machine, signal, device or condition",
                    span,
                    did_you_mean(element, known),
                )
            first = holder.setdefault(element, name)
            if first != name or element in elements[:i]:
                ctx.add("IL2014", f"{element} is wired to {first} and to {name}", span, "name it once")
    if len(rest) > 1:
        ctx.add(
            "IL2014",
            f"the substations {', '.join(rest)} are all empty",
            ctx.at_key("substations", rest[1]),
            "one of them may be empty: it takes what no other names",
        )
    _twice(ctx, wiring, holder)
    missing = [e for e in known if e not in holder]
    if given and missing and not rest:
        ctx.add(
            "IL2014",
            f"no substation is wired to {', '.join(missing[:8])}{' ...' if len(missing) > 8 else ''}",
            ctx.at_key("substations", next(iter(given))),
            "name each of them, or add a substation with an empty list for the rest",
        )
    return tuple(Substation(n, tuple(elements)) for n, elements in given.items())


def _twice(ctx: Context, wiring: Wiring, holder: Mapping[str, str]) -> None:
    """Report names in the lists of substations that two elements bear: both are wired there."""
    f = ctx.file
    kinds = {
        "section": {*wiring.sections, *wiring.approaches},
        "machine of points": {str(p.machine) for p in wiring.points},
        "level crossing": {*f.level_crossings},
        "interlock": {*f.interlocks},
        "signal": {*f.signals, *f.distants},
        "condition": {*f.conditions},
    }
    for element, name in holder.items():
        meant = [kind for kind, those in kinds.items() if element in those]
        if len(meant) > 1:
            what = " and ".join(f"{'an' if k == 'interlock' else 'a'} {k}" for k in meant)
            ctx.add(
                "IL7018",
                f"substation {name}: {element} is {what}, and all of it is wired there",
                ctx.at("substations", name, f.substations[name].index(element)),
                f"give one of them another name if {'they hang' if len(meant) == 2 else 'some of them hang'} on "
                "different substations",
                about=Element("substations", element),
            )


def resolve_health(ctx: Context) -> tuple[Health, ...]:
    """How substations are seen to be well."""
    known = list(ctx.file.substations) or [ONLY]
    for name in ctx.file.health:
        if name not in known:
            ctx.add("IL2014", f"there is no substation {name}", ctx.at_key("health", name), did_you_mean(name, known))
    found = (Health(n, x.by, at_most_ms(x.within)) for n, x in ctx.file.health.items())
    return tuple(sorted(found, key=lambda h: h.substation))


def resolve_addresses(ctx: Context) -> tuple[tuple[str, str], ...]:
    """Addresses that the author wants, by PLC variable; whether the variable exists is seen when they are allocated."""
    seen: dict[str, str] = {}
    for name, written in ctx.file.addresses.items():
        span = ctx.at("addresses", name)
        parts = ADDRESS.fullmatch(written)
        address = written if parts is None else f"{parts[1]}{int(parts[2])}.{parts[3]}"  # I04.0 is I4.0
        if parts is None:
            ctx.add(
                "IL2015",
                f"{address!r} is no address",
                span,
                "write I or Q, the byte, a point and the bit, for instance I4.0 or Q12.7",
            )
        elif address in seen:
            ctx.add("IL2015", f"{name} and {seen[address]} would both have {address}", span, "give each its own")
        seen.setdefault(address, name)
    return tuple(sorted((name, address) for address, name in seen.items()))


def resolve_drawing(ctx: Context, wiring: Wiring) -> tuple[tuple[SectionId, int], ...]:
    """Hints for the plan: sections and their levels."""
    for name in ctx.file.drawing:
        if name not in wiring.sections:
            hint = did_you_mean(name, wiring.sections)
            ctx.add("IL2004", f"drawing: there is no section {name}", ctx.at_key("drawing", name), hint)
    return tuple(sorted((SectionId(n), level) for n, level in ctx.file.drawing.items()))


def resolve_anchors(ctx: Context, wiring: Wiring, signals: tuple[Signal, ...]) -> tuple[Anchor, ...]:
    """Elements with coordinates, in order of node; reports IL3030."""
    f, there = ctx.file, {e.a for e in wiring.edges} | {e.b for e in wiring.edges}
    at = {str(g.id): g.node for g in signals}
    found: dict[tuple[NodeId, ...], tuple[Anchor, str]] = {}
    for room, one in (
        ("boundaries", "boundary"),
        ("points", "point"),
        ("crossings", "crossing"),
        ("slips", "slip"),
        ("derailers", "derailer"),
        ("signals", "signal"),
    ):
        for name, spec in getattr(f, room).items():
            if spec.xy is None:
                continue
            nodes: tuple[NodeId, ...] = (at[name],) if room == "signals" else (NodeId(name),)
            if nodes[0] not in there:  # a slip of two points
                nodes = (NodeId(f"{name}a"), NodeId(f"{name}b"))
            anchor = Anchor(nodes, *spec.xy)
            before, told = found.setdefault(nodes, (anchor, f"{one} {name}"))
            if before != anchor:
                text = f"{one} {name} stands where {told} does, at other coordinates: {before.x:g}, {before.y:g}"
                ctx.add("IL3030", text, ctx.at(room, name, "xy"), "leave one of them out")
    return tuple(a for _, (a, _) in sorted(found.items()))


def resolve_target(given: TargetSpec) -> Target | None:
    """The limits of a CPU, with those that the author states instead; None when there are none."""
    base = CPUS[given.cpu] if given.cpu is not None else Target("the target")
    found = replace(
        base,
        blocks=given.blocks or base.blocks,
        block_bytes=KB * given.block_kb if given.block_kb else base.block_bytes,
        memory_bytes=KB * given.memory_kb if given.memory_kb else base.memory_bytes,
    )
    return found if any((found.blocks, found.block_bytes, found.memory_bytes)) else None
