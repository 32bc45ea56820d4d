"""Where in a text what belongs to an element stands: place, blocks, variables."""

from __future__ import annotations

from interlock.logic.cabinet import Allocation
from interlock.logic.controller import Controller
from interlock.logic.names import computed
from interlock.model.portable import portable
from interlock.st.ast import Name, Unit
from interlock.st.shared import reads, writes


def places(controller: Controller) -> dict[str, str]:
    """By a variable's name in the text: the place of the railway to which it belongs."""
    found: dict[str, str] = {n: e.group for e in controller.next for n in (e.name, computed(e.name))}
    found |= {e.name: e.group for e in controller.equations}
    found |= {w.name: w.group for w in controller.words.words}
    return found


def index(controller: Controller, unit: Unit) -> tuple[str, ...]:
    """A line for each place: in which blocks which of its variables are computed."""
    place = places(controller)
    *blocks, main = unit.blocks
    found: dict[str, dict[str, list[str]]] = {}
    for b in blocks:
        short = b.name.removeprefix(f"{main.name}_")
        for d in b.outputs:
            here = place.get(d.name)
            if here is not None:
                found.setdefault(here, {}).setdefault(short, []).append(d.name)
    lines = []
    for p, of in sorted(found.items()):
        lines.append(f"{p}: {'; '.join(f'{b} {chr(32).join(names)}' for b, names in of.items())}")
    return ("index: place, blocks with what they compute of it", *lines)


HEADINGS = ("Variable", "Place", "Meaning", "Terminal", "Written in", "Read in")


def cross_reference(controller: Controller, a: Allocation, unit: Unit) -> list[tuple[str, ...]]:
    """A row for each variable: place, meaning, terminal, the blocks that write it, and those that read it.

    unit: what is delivered, with its mapping program, in the form in which it is written.  What is handed on as a
    parameter of the same name is not read where it is handed on.
    """
    meaning = _meanings(controller)
    written: dict[str, dict[str, None]] = {n: {} for n in meaning}
    read: dict[str, dict[str, None]] = {n: {} for n in meaning}
    prefix = f"IL_{portable(controller.name)}"
    station = f"{portable(controller.name)}_"  # before a terminal, where a controller holds several interlockings

    def known(n: Name) -> str:
        last = n.parts[-1]
        return last if last in meaning else last.removeprefix(station)

    for b in unit.blocks:
        own = {d.name for d in b.locals if d.type != "BOOL" or d.name not in meaning}
        block = b.name.removeprefix(f"{prefix}_") if b.name != prefix else prefix
        for n in (n for s in b.body for n in writes(s)):
            written.get(known(n), {})[block] = None
        for n in (n for s in b.body for n in reads(s)):
            if n.parts[0] not in own or len(n.parts) > 1:
                read.get(known(n), {})[block] = None
    place = {str(c.variable): c.element for c in a.wires} | places(controller)
    terminal = {c.variable: c.address for c in a.wires} | dict.fromkeys((*a.written, *a.read), "operator")
    terminal |= {str(n): "operator" for n in controller.words.routes.values()}
    return [
        (n, place.get(n, ""), meaning[n], terminal.get(n, ""), " ".join(written[n]), " ".join(read[n]))
        for n in sorted(meaning)
    ]


def _meanings(c: Controller) -> dict[str, str]:
    """What each variable of a text means."""
    found: dict[str, str] = {str(x.name): x.note for x in (*c.inputs, *c.outputs, *c.state, *c.steps, *c.words.words)}
    return found | {str(computed(e.name)): f"next: {e.note}" for e in c.next}
