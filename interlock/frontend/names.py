"""Pass 1: names.  No two elements may share a name, not even in another case (PLC text ignores case).

Output: diagnostics IL2002, IL2010.
"""

from __future__ import annotations

from interlock.diag import Span
from interlock.frontend.context import Context
from interlock.model.portable import portable


def _declared(ctx: Context) -> list[tuple[str, str, Span]]:
    f = ctx.file
    found: list[tuple[str, str, Span]] = []
    for kind, names in (
        ("boundary", f.boundaries),
        ("track", f.tracks),
        ("point", f.points),
        ("crossing", f.crossings),
        ("signal", f.signals),
        ("condition", f.conditions),
    ):
        room = {"boundary": "boundaries"}.get(kind, kind + "s")
        found.extend((kind, n, ctx.at_key(room, n)) for n in names)
    found.extend(("buffer", n, ctx.at("buffers", i)) for i, n in enumerate(f.buffers))
    return found


def check_names(ctx: Context, sections: dict[str, Span]) -> None:
    """Report names used twice.  Tracks are only names for lists, so they may share with nothing else."""
    seen: dict[str, tuple[str, str, Span]] = {}
    declared = [*_declared(ctx), *(("section", n, s) for n, s in sections.items())]
    for kind, name, span in declared:
        before = seen.setdefault(name.lower(), (kind, name, span))
        if before[2] == span:
            continue
        if {kind, before[0]} == {"track", "section"}:
            continue  # a track of one section may bear its name
        ctx.add(
            "IL2002",
            f"{name} names a {kind} and, in line {before[2].line}, the {before[0]} {before[1]}",
            span,
            "rename one of them; upper and lower case are not told apart in PLC text",
        )
    text: dict[tuple[str, str], tuple[str, Span]] = {}
    machines = {p.machine: ctx.at("points", n, "machine") for n, p in ctx.file.points.items() if p.machine}
    for kind, name, span in [*declared, *(("point", n, s) for n, s in machines.items())]:
        first = text.setdefault((kind, portable(name).lower()), (name, span))
        if first[0].lower() != name.lower():
            ctx.add(
                "IL2010",
                f"the {kind}s {first[0]} and {name} would both be written {portable(name)} in PLC text",
                span,
                "rename one of them",
            )
