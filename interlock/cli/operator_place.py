"""`interlock run --operator-modbus`: where the operator's place is read, and what may be asked there."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

import click

from interlock.app.alarms import listed, possible
from interlock.app.run import Ready
from interlock.field.operator_place import Ask, OperatorPlace, registers

LOOPBACK = "127.0.0.1"


def parsed(text: str) -> tuple[str, int]:
    """[HOST:]PORT; without a host only this computer can reach it."""
    host, _, port = text.rpartition(":")
    if not port.isdecimal() or not 0 < int(port) < 65536:
        raise click.UsageError(f"{text}: write --operator-modbus [HOST:]PORT, with a port from 1 to 65535")
    return host.strip("[]") or LOOPBACK, int(port)


@contextmanager
def answering(ready: Ready, at: tuple[str, int] | None, ask: Ask | None) -> Iterator[OperatorPlace | None]:
    """The server while the controller runs; None where none is asked for."""
    if at is None:
        yield None
        return
    assert ready.layout is not None and ready.controller is not None and ready.allocation is not None
    alarms = possible(ready.layout, ready.controller, ready.allocation)
    place = OperatorPlace(registers(ready.controller, listed(alarms)), *at, ask)
    try:
        place.start()
    except OSError as error:
        raise click.UsageError(
            f"the operator's place cannot listen on {at[0]} port {at[1]}: {error.strerror or error}"
        ) from None
    try:
        yield place
    finally:
        place.stop()
