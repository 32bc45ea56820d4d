"""Tests of point machines, derailers, level crossings and other devices, one after the other, while nothing is set."""

from __future__ import annotations

from collections.abc import Iterator

from interlock.commissioning.bench import FEW, Bench, Moment, occupied, undetected
from interlock.commissioning.place import Place
from interlock.commissioning.step import SLACK_S, Sheet, Step
from interlock.diag.called import called
from interlock.logic.names import Name
from interlock.model.elements import MachineId, Position
from interlock.model.figures import exact
from interlock.model.times import supervision_s


def machines(bench: Bench, rest: Moment) -> Iterator[Step]:
    """Each by hand to its other position; not under a vehicle; the alarm where it does not arrive; and that of points
    which were trailed.  A key that an attendant turns is tried with the routes alone."""
    for m in bench.layout.machines:
        by_hand = bench.symbols.machines.by_hand.get((m, Position.REVERSE))
        if by_hand is not None:
            yield from _one(bench, rest, m, by_hand)
        yield from _trailed(bench, rest, m)


def _one(bench: Bench, rest: Moment, m: MachineId, by_hand: Name) -> Iterator[Step]:
    all_, y = bench.layout.machines, bench.symbols
    order, named = all_.to_move(m, Position.REVERSE), all_.named(m)
    there, asked = f"{named} {all_.word(m, Position.REVERSE)}", {str(by_hand): 1}
    bench.back(rest)
    bench.scans(FEW, asked)
    came = [] if bench.lies[m] is Position.REVERSE else ["nothing moves"]
    leads = Place(bench.layout).leads(m, Position.REVERSE)
    yield _step(m, f"{order} by hand", f"{there}, detected{f' ({leads})' if leads else ''}", came)
    if m not in all_.device:  # what a road crosses may always be closed to it
        for s in all_.sections[m]:
            if inputs := occupied(y, s):
                bench.back(rest)
                bench.inputs |= inputs
                bench.scans(FEW, asked)
                came = [] if bench.lies[m] is Position.NORMAL else [there]
                yield _step(m, f"{called('section', s)} reported occupied: try to {order}", "nothing moves", came)
    alarm = y.indication.get(f"late {m}")
    if alarm is not None:
        seconds, lost = supervision_s(bench.layout, m), undetected(y, m)
        bench.back(rest)
        bench.scan(asked | lost)
        bench.wait(max(0.0, seconds - SLACK_S), asked | lost)
        came = ["the alarm comes too early"] if bench.on(alarm) else []
        bench.wait(2 * SLACK_S, asked | lost)
        came += [] if bench.on(alarm) else ["no alarm"]
        told = f"an alarm after {exact(seconds)} s ({alarm})"
        yield _step(m, f"{order} by hand, and keep it from arriving", told, came)


def _trailed(bench: Bench, rest: Moment, m: MachineId) -> Iterator[Step]:
    """Points with a drive that lose their detection without a command count as trailed until somebody confirms that
    they were looked at, whenever it was, also while inputs were lost."""
    y = bench.symbols
    alarm, confirmed, lost = y.indication.get(f"trailed {m}"), y.machines.looked_at.get(m), undetected(y, m)
    if alarm is None or confirmed is None:
        return
    done = f"{bench.layout.machines.named(m)} loses its detection without a command"
    expect = f"an alarm ({alarm}), which stays when it is detected again, until it is confirmed ({confirmed})"
    for inputs in ({}, {str(y.valid): 0}):
        bench.back(rest)
        bench.scans(FEW)
        if inputs:
            bench.scans(2, inputs)
        bench.scans(2, inputs | lost)
        bench.scan(lost)
        came = [] if bench.on(alarm) else ["no alarm"]
        bench.wait(bench.layout.principles.release_delay_s + SLACK_S)  # what inputs tell again counts when it is steady
        came += [] if came or bench.on(alarm) else ["the alarm does not stay"]
        bench.scan({str(confirmed): 1})
        came += ["the alarm stays"] if bench.on(alarm) else []
        when = " while inputs are lost" if inputs else ""
        yield _step(m, f"{done}{when}, and then as before", expect, came)


def _step(m: MachineId, do: str, expect: str, came: list[str]) -> Step:
    return Step(Sheet.MACHINES, str(m), do, expect, "R10", True, "; ".join(came))
