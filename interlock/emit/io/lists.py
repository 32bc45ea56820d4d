"""The allocation as lists: wiring per cabinet, tags for TIA Portal, and the equipment with its counts."""

from __future__ import annotations

import io
import re
from collections import Counter
from collections.abc import Iterable, Sequence
from datetime import datetime

from interlock.derivation.lamps import Beside, beside_main
from interlock.emit.bundle import reproducible
from interlock.logic.cabinet import Allocation, Channel
from interlock.logic.controller import Controller
from interlock.logic.words import SAID
from interlock.model.elements import Position
from interlock.model.layout import Layout
from interlock.model.portable import beside, portable
from interlock.spreadsheet import csv_text

CROSS_REFERENCE = "io/xref_"
"""What the names of files begin with that tell where each variable is written and read."""
HEADINGS = ("Substation", "Slot", "Card", "Byte", "Bit", "Address", "Variable", "Element", "When 1", "At restart")


def channels_csv(layout: Layout, controller: Controller, a: Allocation) -> str:
    """The wiring list: one row for each channel, cabinet by cabinet, the spare ones too; for machines of slips with the
    ends at which their blades lie, and to which these lead."""
    blades = _blades(layout, controller)

    def told(c: Channel) -> tuple[str, ...]:
        return c.variable, c.element, c.note + blades.get(c.variable, ""), start.get(c.variable, "")

    start: dict[str, str] = {o.name: str(int(o.restrictive)) for o in controller.outputs}
    used = {(c.direction, c.byte, c.bit): c for c in a.wires}
    rows: list[tuple[object, ...]] = [HEADINGS]
    kept = {p.place: f"reserved for {p.variable} of {p.element}" for p in a.reserved}
    seen = set()
    for card in a.cards:
        for byte, bit in ((b, bit) for b in card.bytes for bit in range(8)):
            place = (card.direction, byte, bit)
            kind = "DI" if card.direction == "I" else "DO"
            what = told(used[place]) if place in used else ("", "", kept.get(place, "spare"), "")
            address = f"{card.direction}{byte}.{bit}"
            rows.append((card.substation, card.slot, kind, byte, bit, address, *what))
            seen.add(place)
    for key, c in sorted(used.items()):
        if key not in seen:
            kind = "DI" if c.direction == "I" else "DO"
            rows.append((c.substation, "as stated", kind, c.byte, c.bit, c.address, *told(c)))
    return csv_text(rows)


def names_csv(layout: Layout) -> str:
    """Each element with its name in PLC text, one row each; empty where all are written as they are, but for `-`, `/`
    and spaces."""
    kinds: tuple[tuple[str, Iterable[str]], ...] = (
        ("layout", (layout.name,)),
        ("section", (s.id for s in layout.track.sections)),
        ("signal", (g.id for g in layout.signalling.signals)),
        ("machine", layout.machines),
        ("condition", (c.id for c in layout.signalling.conditions)),
        ("zone", (z.id for z in layout.declared.zones)),
        ("boundary", (b.node for b in layout.track.boundaries)),
    )
    rows = [(kind, name, portable(name)) for kind, names in kinds for name in names]
    if all(re.sub("[-/ ]", "_", name) == written for _, name, written in rows):
        return ""
    return csv_text([("Kind", "Name", "Name in PLC text"), *rows])


def cross_reference_csv(headings: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    """Where each variable of a text is written and read."""
    return csv_text([tuple(headings), *map(tuple, rows)])


def words_csv(controller: Controller) -> str:
    """What the words of routes say: the word of each route, and each code with its sentence, rule and elements."""
    ids = {r.number: r.id for r in controller.symbols.routes}
    rows: list[tuple[object, ...]] = [("Word", "Code", "Says", "Rule", "About")]
    rows += [(name, "", f"route {ids[number]}", "", "") for number, name in controller.words.routes.items()]
    rows += [("", code, text, "", "") for code, text in SAID.items()]
    for r in controller.words.reasons.values():
        rows.append(("", r.code, r.text, r.rule, beside(x.partition(":")[2] for x in r.at)))
    return csv_text(rows)


def _blades(layout: Layout, controller: Controller) -> dict[str, str]:
    """For each wire of a machine of a slip, where the blades lie, and to which end they lead when it is 1."""
    found: dict[str, str] = {}
    named = {b.point: b for b in layout.pointwork.blades}
    for m, ends in layout.machines.ends.items():
        for x in Position:
            lie = [(named[p.id], x) for p in ends if p.id in named]
            told = "; ".join(f"blades at {' and '.join(b.at)} to {b.to(x)}" for b, x in lie)
            for wire in (controller.symbols.machines.detected[m, x], f"Y{x}_{portable(m)}"):
                found[wire] = f"; {told}" if told else ""
    return found


def equipment_csv(layout: Layout, a: Allocation) -> str:
    """What has to be bought and mounted, counted from the layout (document B 2.2).

    A machine counts once, whatever it works; ends of points and derailers are counted beside machines and keys, so that
    whoever mounts a drive at each end of double-acting points reads their number there.  A double slip has four ends,
    whether one machine lays them or two.  Channels are those of cabinets that the layout has; of one that is gone,
    where something is still reserved, neither cards nor channels are."""
    lit = [g for g in layout.signalling.signals if g.id not in layout.signalling.boards]
    kinds = Counter(f"signal, {'shunt' if g.id in layout.signalling.stops else g.kind}" for g in lit)
    kinds["stop board"] = sum(g in layout.signalling.stops for g in layout.signalling.boards)
    kinds["limit-of-shunt board"] = sum(g not in layout.signalling.stops for g in layout.signalling.boards)
    kinds["call-on lamp"] = sum(g.call_on for g in layout.signalling.signals)
    units = Counter(unit for each in beside_main(layout).values() for unit in each)
    kinds["second yellow lamp"], kinds["route indicator"] = units[Beside.SECOND], units[Beside.INDICATOR]
    kinds["speed indicator"] = units[Beside.SPEED]
    kinds["identifier light"] = len(layout.signalling.identifiers)
    kinds["distant signal"] = len(layout.signalling.distants)
    kinds["section with detection"] = sum(s.detected and not s.approach for s in layout.track.sections)
    kinds["approach section with detection"] = sum(s.detected and s.approach for s in layout.track.sections)
    for m in layout.machines.ends:
        what = "derailer" if layout.machines.is_derailer(m) else "point"
        kinds[f"{what} worked by hand, with key" if m in layout.machines.by_hand else f"{what} machine"] += 1
    ends = {b.point: len(b.at) for b in layout.pointwork.blades}
    for p in layout.pointwork.points:
        kinds["derailer" if p.derailer else "point end"] += ends.get(p.id, 1)
    for d in layout.signalling.devices:
        kinds[str(d.kind)] += 1
    kinds["external condition"] = len(layout.signalling.conditions)
    kinds["substation"] = len(a.stations)
    for card in a.cards:
        kinds[f"card, {card.size} digital {'inputs' if card.direction == 'I' else 'outputs'}"] += 1
    kinds["channel in use"] = len(a.wires)
    kinds["channel"] = sum(card.size for card in a.cards)
    on_cards = {(card.direction, byte) for card in a.cards for byte in card.bytes}
    kinds["channel, reserved"] = sum((p.direction, p.byte) in on_cards for p in a.reserved)
    return csv_text([("Item", "Count"), *sorted((k, n) for k, n in kinds.items() if n)])


_TIA = (
    "Name",
    "Path",
    "Data Type",
    "Logical Address",
    "Comment",
    "Hmi Visible",
    "Hmi Accessible",
    "Hmi Writeable",
    "Typeobject ID",
    "Version ID",
)


def tags_xlsx(layout: Layout, a: Allocation) -> bytes:
    """A tag table that TIA Portal's tag import asks for; from a public description, tried in no tool.

    A tag bears the station's name, so that a controller may hold several."""
    import xlsxwriter  # a proof writes none

    out = io.BytesIO()
    with xlsxwriter.Workbook(out, {"in_memory": True}) as book:
        book.set_properties({"created": datetime(2000, 1, 1)})
        sheet = book.add_worksheet("PLC Tags")
        for x, title in enumerate(_TIA):
            sheet.write_string(0, x, title)
        for y, c in enumerate(a.wires, 1):
            row = (
                f"{portable(layout.name)}_{c.variable}",
                f"IL_{layout.name}",
                "Bool",
                f"%{c.address}",
                c.note,
                "True",
                "True",
                "False",
                "",
                "",
            )
            for x, value in enumerate(row):
                sheet.write_string(y, x, value)
    return reproducible(out.getvalue())
