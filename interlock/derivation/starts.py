"""Supervision of machines that wait for others to start (R10).  IL3023.

With `point_start_gap_s` one machine starts after the other, in the order of their names, while each is supervised from
its command on.  A route commands all that it needs in one scan: the k-th of them that turns starts k - 1 gaps later,
and then runs.  That is the least; it takes longer while machines of another route wait or have just started, and each
start takes up to three scans.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from math import floor

from interlock.dataclass import dataclass
from interlock.diag import Element, Sink
from interlock.model.elements import MachineId, RouteId
from interlock.model.layout import Layout
from interlock.model.times import supervision_s, tenths, whole_ms
from interlock.table.rows import RouteRow


@dataclass(frozen=True)
class _Wait:
    """A machine, the route for which it waits longest, and how many machines of that start before it."""

    machine: MachineId
    route: RouteId
    before: int


def check_starts(layout: Layout, rows: Sequence[RouteRow], sink: Sink) -> None:
    """Report supervision that is over before its machine, having waited for the others of a route, has turned."""
    gap, run = layout.principles.point_start_gap_s, layout.principles.point_run_s
    if not gap:
        return
    own = dict(layout.pointwork.supervision)
    principle: _Wait | None = None
    for w in _longest(layout, rows):
        if whole_ms(supervision_s(layout, w.machine)) >= w.before * whole_ms(gap) + whole_ms(run):
            continue
        if w.machine in own:
            _report(layout, w, f"the supervision of {w.machine}", Element("points", _point(layout, w.machine)), sink)
        elif principle is None or w.before > principle.before:
            principle = w
    if principle is not None:
        _report(layout, principle, "point_supervision_s", Element("principles", "point_supervision_s"), sink)


def _longest(layout: Layout, rows: Sequence[RouteRow]) -> list[_Wait]:
    """Of each machine that waits for others of a route, the longest wait."""
    by_id, found = {r.id: r for r in rows}, dict[MachineId, _Wait]()
    for r in rows:
        for k, m in enumerate(_turned(layout, by_id, r)):
            if k and (m not in found or found[m].before < k):
                found[m] = _Wait(m, r.id, k)
    return [found[m] for m in layout.machines if m in found]


def _turned(layout: Layout, by_id: Mapping[RouteId, RouteRow], r: RouteRow) -> list[MachineId]:
    """The machines that start for a route, and for those that are set with it past its end, in the order in which
    they start: no devices, and no keys."""
    commanded = {p.machine for p in (*r.locking.points, *r.locking.driven)}
    while r.path.onward is not None:
        r = by_id[r.path.onward]
        commanded |= {p.machine for p in (*r.locking.points, *r.locking.driven)}
    still = {*layout.machines.device, *layout.machines.by_hand}
    return [m for m in layout.machines if m in commanded and m not in still]


def _point(layout: Layout, machine: MachineId) -> str:
    return layout.machines.ends[machine][0].id


def _report(layout: Layout, w: _Wait, what: str, about: Element, sink: Sink) -> None:
    rules, own = layout.principles, supervision_s(layout, w.machine)
    gap, run = rules.point_start_gap_s, rules.point_run_s
    waits, need = w.before * gap, w.before * whole_ms(gap) + whole_ms(run)
    others = "another machine" if w.before == 1 else f"{w.before} others"
    bearable = floor(10 * (own - run) / w.before) / 10
    shorter = f", or a `point_start_gap_s` of at most {bearable:g} s, if the supply bears it" if bearable > 0 else ""
    sink.add(
        "IL3023",
        f"{what} is {own:g} s, and {tenths(need)} s are needed for {w.machine}: where {w.route} turns it after "
        f"{others}, {gap:g} s apart, it starts {waits:g} s after it is commanded, and runs for {run:g} s",
        None,
        f"state at least {-(-need // 1000)} s{shorter}",
        about=about,
    )
