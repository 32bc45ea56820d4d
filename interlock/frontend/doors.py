"""Doors, and air locks, of whose doors never more than one is open (R13).

Input: the file.  Output: devices as doors, what routes over one door demand of the others, and IL3048.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from interlock.diag import Span
from interlock.diag.suggest import did_you_mean
from interlock.frontend.context import Context
from interlock.frontend.schema import DeviceSpec, InterlockSpec
from interlock.model.elements import Choice, Demanded, Device, DeviceKind, MachineId, Position, SectionId
from interlock.model.machines import grouped


def as_door(ctx: Context, device: Device, spec: DeviceSpec) -> Device:
    """The device, as a door where it is one."""
    if not isinstance(spec, InterlockSpec) or (spec.kind != "door" and spec.air_lock is None):
        return device
    lock = spec.air_lock or ""
    beside = tuple(MachineId(m) for m in _air_locks(ctx).get(lock, ()) if m != device.id)
    return replace(device, kind=DeviceKind.DOOR, air_lock=lock, beside=beside)


def demands_of_air_locks(ctx: Context) -> Iterator[Demanded]:
    """Every route over a door of an air lock demands the others shut."""
    for lock, doors in sorted(_air_locks(ctx).items()):
        for one in doors:
            for other in (x for x in doors if x != one):
                for s in sorted(set(ctx.file.interlocks[one].over)):
                    over = Choice(None, None, (SectionId(s),), (), None)
                    reason = f"of the doors of air lock {lock} only one may be open"
                    yield Demanded(MachineId(other), Position.NORMAL, over, reason, air_lock=lock)


def check_doors(ctx: Context) -> None:
    """Report an air lock of one door: the other one says another name, or none; and a door of one that is said to be
    none."""
    locks = _air_locks(ctx)
    for lock, doors in locks.items():
        if len(doors) == 1:
            near = did_you_mean(lock, [x for x in locks if x != lock])
            fix = near or f"give its other door `air_lock: {lock}`, too, or remove the key"
            ctx.add("IL3048", f"{doors[0]} is the only door of air lock {lock}", _at(ctx, doors[0], "air_lock"), fix)
        for name in doors:
            if ctx.file.interlocks[name].kind == "device":
                text = f"{name} is a door of air lock {lock}, and said to be none"
                ctx.add("IL3048", text, _at(ctx, name, "kind"), "write `kind: door`, or remove one of the two keys")


def _at(ctx: Context, name: str, key: str) -> Span:
    return ctx.at("interlocks", name, key)


def _air_locks(ctx: Context) -> dict[str, tuple[str, ...]]:
    """The doors of each air lock, in order."""
    return grouped((x.air_lock, name) for name, x in sorted(ctx.file.interlocks.items()) if x.air_lock)
