"""The routes that names and switches for automatic working mean.

Input: the layout and its paths.  Output: names of routes, automatic routes; diagnostics IL1022, IL2002, IL2007 and
IL2024.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from interlock.derivation.ends import over_which
from interlock.derivation.routes import Path
from interlock.derivation.voyages import priority
from interlock.diag import Element, Sink
from interlock.diag.suggest import did_you_mean
from interlock.model.elements import NamedRoute, RouteId, SectionId
from interlock.model.layout import Layout
from interlock.table.cells import RouteKind

_KINDS = {False: RouteKind.MAIN, True: RouteKind.SHUNT, None: RouteKind.CALL_ON}


def derive_names(layout: Layout, paths: Sequence[Path], sink: Sink) -> dict[RouteId, tuple[str, ...]]:
    """The names of each route that has any; without a kind, a name is the train route's where there is one."""
    out: dict[RouteId, tuple[str, ...]] = {}
    called = {p.id.casefold(): (str(p.id), p) for p in paths}
    """By name, whatever its case: the name as it is written, and the route."""
    stated = {name: _KINDS[shunt] for name, shunt in layout.declared.named_kinds}
    for n in layout.declared.named_routes:
        fits = [p for p in paths if _fits(n, p)]
        kinds = {p.kind for p in fits}
        of = {stated[n.name]} if n.name in stated else kinds - {RouteKind.SHUNT} or kinds
        fits = [p for p in fits if p.kind in of]
        at = Element("routes", n.name)
        if fits:
            meant = _one(n, fits, f"the name {n.name}", sink, at)
            out[meant.id] = (*out.get(meant.id, ()), n.name)
            other = called.setdefault(n.name.casefold(), (n.name, meant))
            if other[1] is not meant:
                text = f"{n.name} names the route {meant.id}, and {other[0]} is the route from {other[1].entry} to "
                text += f"{other[1].exit}"
                sink.add("IL2002", text, None, "give it another name: whoever sets a route means one", about=at)
        else:
            of_kind = [p for p in paths if n.name not in stated or p.kind is stated[n.name]]
            kind = f"{stated[n.name].replace('main', 'train')} route" if n.name in stated else "route"
            _none(n, of_kind, kind, f" (named {n.name})", sink, at)
    return out


def derive_automatic(layout: Layout, paths: Sequence[Path], sink: Sink) -> tuple[RouteId, ...]:
    """The routes that may work automatically (R14: an explicit mode), in the order in which they are offered.

    As the layout names them; where the principle `priorities` asks for it, the class of priority comes first.
    """
    out: list[Path] = []
    first: dict[RouteId, str] = {}
    for n in layout.declared.automatic:
        fits = [p for p in paths if p.kind is RouteKind.MAIN and _fits(n, p)]
        at = Element("automatic", int(n.name))
        if fits:
            meant = _one(n, fits, "automatic working", sink, at)
            if first.setdefault(meant.id, n.name) != n.name:
                text = f"`automatic`: this entry means {meant.id}, as entry {int(first[meant.id]) + 1} does"
                sink.add("IL1022", text, None, "remove one of them, or correct the one that means another", about=at)
            out.append(meant)
        else:
            _none(n, [p for p in paths if p.kind is RouteKind.MAIN], "train route", "", sink, at)
    if layout.principles.priorities:
        out.sort(key=lambda p: priority(layout, {t.section for t in p.ways}, True))
    return tuple(dict.fromkeys(p.id for p in out))


def _fits(n: NamedRoute, p: Path) -> bool:
    own = p.kind is not RouteKind.IDENTIFIER  # a part of the routes that lead past its signal
    return own and p.entry == n.entry and n.exit in _ends(p) and set(n.via) <= {t.section for t in p.run}


def _ends(p: Path) -> tuple[str, SectionId]:
    """Where its train stops or leaves, and the last section."""
    last = p.parts[-1]
    return last.exit, last.ways[-1].section


def _one(n: NamedRoute, fits: Sequence[Path], what: str, sink: Sink, at: Element) -> Path:
    """The first, which is preferred; said aloud where `via` could tell it from others and does not.

    A way of which every section lies on all the others, too, has none to name: without more sections it is meant.
    """
    over = {p.id: {t.section for t in p.run} for p in fits}
    within = [p for p in fits if p.kind is fits[0].kind and all(over[p.id] <= o for o in over.values())]
    if within:
        return within[0]
    first = fits[0]
    others = [p for p in fits if p.kind is first.kind and p.run != first.run]
    if others:
        ways = 1 + len({p.run for p in others})
        text = f"{what} fits {ways} routes from {n.entry} to {n.exit}, and means {first.id}"
        via = _telling([t.section for t in first.run], [over[p.id] for p in others])
        one = "a section" if len(via) == 1 else "sections"
        fix = f"add `via: [{', '.join(via)}]`, or {one} of the one that is meant"
        sink.add("IL2024", text, None, fix, about=at)
    return first


def _telling(own: Sequence[SectionId], others: Sequence[set[SectionId]]) -> list[SectionId]:
    """Few sections of a way that tell it from the others, but for those on which all of it lies, too."""
    via: list[SectionId] = []
    left = [o for o in others if not set(own) <= o]
    while left:
        via.append(max(own, key=lambda s: sum(s not in o for o in left)))
        left = [o for o in left if via[-1] in o]
    return via


def _none(n: NamedRoute, paths: Sequence[Path], kind: str, named: str, sink: Sink, at: Element) -> None:
    """IL2007, with what routes of the kind that is wanted there are."""
    text = f"there is no {kind} from {n.entry} to {n.exit}{named}"
    alike = [[t.section for t in p.run] for p in paths if _fits(replace(n, via=()), p)]
    if n.via and alike:
        fix = f"correct `via`: {over_which(alike)}"
        sink.add("IL2007", f"{text} over {' and '.join(n.via)}", None, fix, about=at)
        return
    ends = sorted({_ends(p)[0] for p in paths if p.entry == n.entry and p.kind is not RouteKind.IDENTIFIER})
    none = "" if ends else f"correct `from`: no {kind} begins at {n.entry}"
    sink.add("IL2007", text, None, did_you_mean(n.exit, ends, none), about=at)
