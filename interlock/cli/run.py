"""`interlock run`: the proved runtime as a soft PLC against real inputs and outputs."""

from __future__ import annotations

import gc
import queue
import sys
import threading
from collections.abc import Mapping

import click

from interlock.app.run import BadCommand, Operator, Ready, prepare, run
from interlock.cli.common import exit_code, progress, show_proof
from interlock.field.modbus import ModbusLink
from interlock.field.plc import Link


def _links(ready: Ready, given: tuple[str, ...]) -> dict[str, Link]:
    assert ready.allocation is not None
    stations = [c.substation for c in ready.allocation.heartbeats]
    links: dict[str, Link] = {}
    for text in given:
        station, _, rest = text.rpartition("=")
        station = station or (stations[0] if len(stations) == 1 else "")
        host, _, tail = rest.rpartition(":")
        port, _, device = tail.partition("/")
        if station not in stations or not host or not port.isdigit() or not (device or "1").isdigit():
            raise click.UsageError(f"{text}: write SUBSTATION=HOST:PORT[/DEVICE]; substations: {', '.join(stations)}")
        links[station] = ModbusLink(ready.allocation, station, host, int(port), int(device or 1))
    missing = sorted(set(stations) - set(links))
    if missing:
        raise click.UsageError(f"--modbus is missing for {', '.join(missing)}")
    return links


@click.command("run")
@click.argument("layout", type=click.Path())
@click.option("--modbus", multiple=True, required=True, help="SUBSTATION=HOST:PORT[/DEVICE], one for each substation.")
@click.option("--cycle", "cycle_ms", type=click.IntRange(10, 1000), default=100, show_default=True, help="In ms.")
@click.option("--cycles", type=click.IntRange(1), default=None, help="Stop after so many cycles (otherwise: Ctrl-C).")
def command(layout: str, modbus: tuple[str, ...], cycle_ms: int, cycles: int | None) -> None:
    """Prove LAYOUT, then run its runtime on Modbus TCP.

    A line of input is a command for one cycle: set ROUTE, swing SIGNAL, voyage NAME, cancel SIGNAL or release.
    VARIABLE=VALUE (for instance BLK_q1=1) stays until it is set otherwise.  Every change of an output is printed.  A
    standard computer is no safety PLC: for trials, not for a railway.
    """
    try:
        import pymodbus  # noqa: F401
    except ImportError:
        raise click.UsageError("Modbus needs the extra `field`: pip install 'interlock[field]'") from None
    with progress(layout) as report:
        ready = prepare(layout, None, report)
    show_proof(ready.proved, "full", False)
    if ready.allocation is None:
        sys.exit(exit_code([ready.proved]))
    links = _links(ready, modbus)
    typed: queue.SimpleQueue[str] = queue.SimpleQueue()

    def listen() -> None:
        for line in sys.stdin:
            typed.put(line)

    gc.enable()  # off in the short-lived commands; this one runs on
    threading.Thread(target=listen, daemon=True).start()

    operator = Operator(ready)

    def ask() -> Mapping[str, int]:
        line = "" if typed.empty() else typed.get().strip()
        if line:
            try:
                operator.type(line)
            except BadCommand as error:
                click.echo(f"  {error}")
            if "=" in line:
                click.echo(f"  held: {', '.join(f'{n}={v}' for n, v in sorted(operator.held.items())) or 'nothing'}")
        return operator.inputs()

    before: dict[str, bool] = {}
    said: tuple[object, ...] = ()
    longest = 0.0
    try:
        for result, took in run(ready, links, cycle_ms, cycles, ask):
            longest = max(longest, took)
            if (result.valid, result.lost) != said:
                said = (result.valid, result.lost)
                click.echo(f"inputs {'valid' if result.valid else 'NOT VALID'}{''.join(f'; {x}' for x in result.lost)}")
            for name, value in result.outputs.items():
                if before.get(name) is not value and (before or value):
                    click.echo(f"  {name} = {int(value)}")
            before = dict(result.outputs)
    except KeyboardInterrupt:
        pass
    click.echo(f"stopped; the longest cycle took {longest * 1000:.1f} ms of {cycle_ms} ms")
