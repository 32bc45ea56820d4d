"""Pass 1: names.  In one namespace no two elements share a name, not even in another case (PLC text ignores case).

Output: diagnostics IL2002, IL2010; names that look alike: `alike.py`, IL7010.
"""

from __future__ import annotations

from interlock.diag import Span
from interlock.frontend.alike import check_alike
from interlock.frontend.context import Context
from interlock.frontend.parts import points_of
from interlock.model.portable import portable


def _declared(ctx: Context) -> list[tuple[str, str, Span]]:
    f = ctx.file
    found: list[tuple[str, str, Span]] = []
    for kind, names in (
        ("boundary", f.boundaries),
        ("track", f.tracks),
        ("point", f.points),
        ("crossing", f.crossings),
        ("slip", f.slips),
        ("derailer", f.derailers),
        ("level crossing", f.level_crossings),
        ("interlock", f.interlocks),
        ("signal", f.signals),
        ("distant", f.distants),
        ("condition", f.conditions),
        ("zone", f.zones),
        ("substation", f.substations),
    ):
        room = {"boundary": "boundaries"}.get(kind, kind.replace(" ", "_") + "s")
        found.extend((kind, n, ctx.at_key(room, n)) for n in names)
    found.extend(("buffer", n, ctx.at("buffers", i)) for i, n in enumerate(f.buffers))
    found.extend(("buffer", n, ctx.at("traps", i)) for i, n in enumerate(f.traps))
    return found


# names of one room are told apart where the layout refers to them, or in PLC text
ROOMS: tuple[tuple[str, ...], ...] = (
    ("section", "boundary"),
    ("point", "crossing", "slip", "derailer", "boundary", "buffer"),
    ("signal", "distant", "boundary", "buffer"),
    ("condition",),
    ("zone",),
    ("substation",),
    ("machine", "derailer", "level crossing", "interlock"),
    ("point", "level crossing", "interlock"),
)


# these become machines in PLC text
MOVED = ("point", "machine", "derailer", "level crossing", "interlock")


def check_names(ctx: Context, sections: dict[str, Span]) -> None:
    """Report names used twice within a namespace.  A track's name never leaves the layout, so it only needs to differ
    from what else can be joined: points, crossings, boundaries and buffers."""
    declared = _declared(ctx)
    elements = [d for d in declared if d[0] != "track"] + [("section", n, s) for n, s in sections.items()]
    machines: dict[str, Span] = {}
    for part, those in (("points", ctx.file.points), ("derailers", ctx.file.derailers)):
        for name, spec in those.items():
            if spec.machine:
                machines.setdefault(spec.machine, ctx.at(part, name, "machine"))
    for name, slip in ctx.file.slips.items():
        for m in slip.machines or (f"{name}a", f"{name}b"):
            machines.setdefault(m, ctx.at_key("slips", name))
        elements += [("point", p, ctx.at_key("slips", name)) for p in points_of(name, slip)]
    elements += [("machine", n, s) for n, s in machines.items()]
    for room in ROOMS:
        seen: dict[str, tuple[str, str, Span]] = {}
        for kind, name, span in elements:
            if kind in room:
                before = seen.setdefault(name.lower(), (kind, name, span))
                if before[2] != span:
                    _clash(ctx, (kind, name, span), before)
    check_alike(ctx, [*elements, *(d for d in declared if d[0] == "track")])
    joinable = {n: (k, n, s) for k, n, s in elements if k in ROOMS[1]}
    for name in ctx.file.tracks:
        if name in joinable:
            _clash(ctx, ("track", name, ctx.at_key("tracks", name)), joinable[name])
    written: dict[tuple[str, str], tuple[str, str]] = {}
    for kind, name, span in [(("machine" if k in MOVED else k), n, s) for k, n, s in elements]:
        shared = "section" if kind == "boundary" else kind
        first = written.setdefault((shared, portable(name).lower()), (kind, name))
        if first[1].lower() != name.lower():
            ctx.add(
                "IL2010",
                f"the {first[0]} {first[1]} and the {kind} {name} would both be written {portable(name)} in PLC text",
                span,
                "rename one of them",
            )


def _clash(ctx: Context, new: tuple[str, str, Span], old: tuple[str, str, Span]) -> None:
    ctx.add(
        "IL2002",
        f"{new[1]} names a {new[0]} and, in line {old[2].line}, the {old[0]} {old[1]}",
        new[2],
        "rename one of them; upper and lower case are not told apart in PLC text",
    )
