"""Where in a text what belongs to an element stands: place, blocks, variables."""

from __future__ import annotations

from interlock.logic.controller import Controller
from interlock.logic.names import computed
from interlock.st.ast import Unit


def places(controller: Controller) -> dict[str, str]:
    """By a variable's name in the text: the place of the railway to which it belongs."""
    found = {n: e.group for e in controller.next for n in (e.name, computed(e.name))}
    found |= {e.name: e.group for e in controller.equations}
    found |= {w.name: w.group for w in controller.words.words}
    return {str(n): place for n, place in found.items()}


def index(controller: Controller, unit: Unit) -> tuple[str, ...]:
    """A line for each place: in which blocks which of its variables are computed."""
    place = places(controller)
    *blocks, main = unit.blocks
    found: dict[str, dict[str, list[str]]] = {}
    for b in blocks:
        for d in b.outputs:
            if d.name in place:
                found.setdefault(place[d.name], {}).setdefault(b.name.removeprefix(f"{main.name}_"), []).append(d.name)
    lines = []
    for p, of in sorted(found.items()):
        lines.append(f"{p}: {'; '.join(f'{b} {chr(32).join(names)}' for b, names in of.items())}")
    return ("index: place, blocks with what they compute of it", *lines)
