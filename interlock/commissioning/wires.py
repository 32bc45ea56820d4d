"""Correspondence tests: each wire between a cabinet and what stands outside, one after the other."""

from __future__ import annotations

from collections.abc import Iterator

from interlock.commissioning.step import Sheet, Step
from interlock.logic.cabinet import Allocation, Channel


def wires(allocation: Allocation) -> Iterator[Step]:
    """Both values of each channel.  None of these is tried on the bench: they are about wires."""
    alive = {c.variable for c in (*allocation.heartbeats, *allocation.diagnoses, *allocation.sent)}
    for c in allocation.wires:
        where = f"{c.substation} {c.address}"
        if c.variable in alive:
            yield Step(Sheet.WIRES, where, f"watch {c.variable} while all runs", c.note, "R16")
        elif c.direction == "I":
            yield from _read(c, where)
        else:
            yield Step(Sheet.WIRES, where, f"set {c.variable} to 1, every other output to 0", f"{c.note}, nothing else")
            yield Step(Sheet.WIRES, where, f"set {c.variable} to 0", f"no more {c.note}")


def _read(c: Channel, where: str) -> Iterator[Step]:
    yield Step(Sheet.WIRES, where, f"bring about: {c.note}", f"{c.variable} reads 1, and no other input changes")
    yield Step(Sheet.WIRES, where, f"bring about the contrary of: {c.note}", f"{c.variable} reads 0")
    yield Step(Sheet.WIRES, where, f"as in the first, and open the circuit of {c.element}", f"{c.variable} reads 0")
