"""Correspondence tests: each wire between a cabinet and what stands outside, one after the other."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from interlock.commissioning.step import Sheet, Step
from interlock.logic.cabinet import Allocation, Channel


def wires(allocation: Allocation, places: Mapping[str, str]) -> Iterator[Step]:
    """Both values of each channel.  `places`: by variable where its element lies, which the words have, too: else a
    wire would be the same test although it means another place.  None of these is tried on the bench: they are about
    wires."""
    alive = {c.variable for c in (*allocation.heartbeats, *allocation.diagnoses, *allocation.sent)}
    for c in allocation.wires:
        slot = f"slot {c.slot} " if c.slot else ""
        where, place = f"{c.substation} {slot}{c.address}", places.get(c.variable, "")
        note = f"{c.note} ({place})" if place else c.note
        if c.variable in alive:
            yield Step(Sheet.WIRES, where, f"watch {c.variable} while all runs", note, "R16")
        elif c.direction == "I":
            yield from _read(c, where, note)
        else:
            yield Step(Sheet.WIRES, where, f"set {c.variable} to 1, every other output to 0", f"{note}, nothing else")
            yield Step(Sheet.WIRES, where, f"set {c.variable} to 0", f"no more {note}")


def _read(c: Channel, where: str, note: str) -> Iterator[Step]:
    one = f"{c.variable} reads 1, and no other input changes"
    yield Step(Sheet.WIRES, where, f"bring about: {note}", one)
    yield Step(Sheet.WIRES, where, f"bring about the contrary of: {note}", f"{c.variable} reads 0")
    yield Step(Sheet.WIRES, where, f"{note}: open the circuit of {c.element}", f"{c.variable} reads 0")
