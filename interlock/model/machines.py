"""The machines of a layout: what is moved and locked, by points, keys and devices."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from typing import TypeVar

from interlock.diag.called import called
from interlock.model.elements import Device, DeviceKind, MachineId, Point, PointId, Position, SectionId, Work

K = TypeVar("K")
V = TypeVar("V")


def grouped(pairs: Iterable[tuple[K, V]]) -> dict[K, tuple[V, ...]]:
    """The second of each pair, by the first."""
    found: dict[K, list[V]] = {}
    for key, value in pairs:
        found.setdefault(key, []).append(value)
    return {key: tuple(values) for key, values in found.items()}


class Machines(Collection[MachineId]):
    """Machines of points, and devices, in order.  toes: in which section the toe of each point lies."""

    def __init__(self, points: Sequence[Point], devices: Sequence[Device], toes: Mapping[PointId, SectionId]) -> None:
        self.ends: dict[MachineId, tuple[Point, ...]] = grouped((p.machine, p) for p in points)
        """The point ends that one machine works."""
        self.device: dict[MachineId, Device] = {d.id: d for d in devices}
        self.by_hand: frozenset[MachineId] = frozenset(p.machine for p in points if p.work is Work.HAND)
        """Machines that are keys of hand-worked points."""
        over = {m: {toes[p.id] for p in ps} for m, ps in self.ends.items()} | {d.id: set(d.over) for d in devices}
        self.sections: dict[MachineId, tuple[SectionId, ...]] = {m: tuple(sorted(s)) for m, s in over.items()}
        """The sections in which a machine's ends lie, or over which a device stands."""
        self.points_in: dict[SectionId, tuple[Point, ...]] = grouped((toes[p.id], p) for p in points)
        """The points of a section: those whose toe lies in it."""
        self._all = tuple(sorted({*self.ends, *self.device}))

    def __iter__(self) -> Iterator[MachineId]:
        return iter(self._all)

    def __len__(self) -> int:
        return len(self._all)

    def __contains__(self, machine: object) -> bool:
        return machine in self.sections

    def is_derailer(self, machine: MachineId) -> bool:
        """Whether a machine works a derailer alone; one that works points, too, is told as points."""
        return all(p.derailer for p in self.ends.get(machine, ())) and machine in self.ends

    def _is_door(self, machine: MachineId) -> bool:
        """Whether a device is told as a door, which is open for trains and shut otherwise."""
        return machine in self.device and self.device[machine].kind is DeviceKind.DOOR

    def named(self, machine: MachineId) -> str:
        """A machine in a sentence: with its kind, but that a bridge, door or hoist is told by its name alone."""
        device = self.device.get(machine)
        if device is not None:
            crossing = device.kind is DeviceKind.LEVEL_CROSSING
            return called(str(device.kind), machine) if crossing else str(machine)
        return called("derailer" if self.is_derailer(machine) else "points", machine)

    def lie(self, machine: MachineId, position: Position) -> str:
        """Where a machine lies now: `P1 lies reverse`, `Gs1 is off`, `level crossing LC is closed`, `D1 is shut`."""
        name, word = self.named(machine) if machine in self.device else str(machine), self.word(machine, position)
        return f"{name} {'lies' if word in ('normal', 'reverse') else 'is'} {word}"

    def trailed(self, machine: MachineId) -> str:
        """That points were trailed, or a derailer was run over, or only has lost its detection."""
        if self.is_derailer(machine):
            return f"{self.named(machine)} was run over, or has lost its detection: look at it, and confirm it"
        return f"{self.named(machine)} were trailed: look at them, and confirm it"

    def undetected(self, machine: MachineId) -> str:
        """That a machine is not where it was commanded: points are detected, what a road crosses is proved."""
        if machine in self.device:
            return f"{self.named(machine)} is not proved as it is commanded"
        return f"{machine} is not detected"

    def lies(self, machine: MachineId, position: Position, is_so: bool) -> str:
        """That a machine is reported in a position, or is not: points are detected, what a road crosses is proved."""
        no = "" if is_so else "not "
        if machine in self.device:
            return f"{self.named(machine)} is {no}proved {self.word(machine, position)}"
        return f"{machine} is {no}detected {'normal' if position is Position.NORMAL else 'reverse'}"

    def to_move(self, machine: MachineId, position: Position) -> str:
        """What whoever works a machine by hand wants: `move P1 reverse`, `take Gs1 off`, `close level crossing LC`."""
        name = self.named(machine) if machine in self.device else str(machine)
        before, after = self._order(machine, position)
        return f"{before} {name} {after}".rstrip()

    def order(self, machine: MachineId, position: Position) -> str:
        """The same without a name, as a button says it: `Move reverse`, `Release by its key`."""
        return " ".join(self._order(machine, position)).rstrip().capitalize()

    def _order(self, machine: MachineId, position: Position) -> tuple[str, str]:
        """What is said before and after the name."""
        normal = position is Position.NORMAL
        if self._is_door(machine):
            return ("shut" if normal else "open"), ""
        if machine in self.device:
            return ("open" if normal else "close"), ""
        if machine in self.by_hand:
            return ("lock" if normal else "release"), "by its key"
        if self.is_derailer(machine):
            return ("put", "on") if normal else ("take", "off")
        return "move", self.word(machine, position)

    def moved(self, machine: MachineId, position: Position) -> str:
        """What is done to it then: `moved reverse`, `opened`, `released by its key`, `taken off`."""
        before, after = self._order(machine, position)
        done = {"open": "opened", "put": "put", "shut": "shut", "take": "taken"}.get(
            before, f"{before.removesuffix('e')}ed"
        )
        return f"{done} {after}".rstrip()

    def word(self, machine: MachineId, position: Position) -> str:
        """The position in the engineer's words."""
        normal = position is Position.NORMAL
        if self._is_door(machine):
            return "shut" if normal else "open"
        if machine in self.device:
            return "open" if normal else "closed"
        if machine in self.by_hand:
            return "locked by its key" if normal else "released by its key"
        if self.is_derailer(machine):
            return "on" if normal else "off"
        return "normal" if normal else "reverse"


def shown_by(machines: Machines, machine: MachineId, position: Position) -> list[list[str]]:
    """What shows on a plan that a machine lies so: of each of its points, or of the device, the kind of element, its
    id, the position, and the word for it."""
    word = machines.word(machine, position)
    ends = [["point", str(p.id), str(position), word] for p in machines.ends.get(machine, ())]
    return ends or [["device", str(machine), str(position), word]]


def other_doors(machines: Machines, machine: MachineId) -> tuple[MachineId, ...]:
    """Of a door of an air lock the others, none of which is open while it is (R13); of anything else none."""
    return machines.device[machine].beside if machine in machines.device else ()
