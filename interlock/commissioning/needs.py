"""What keeps a signal at stop, one thing at a time, as the row of a route says."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from interlock.commissioning.bench import occupied, undetected
from interlock.commissioning.row import Row
from interlock.dataclass import dataclass
from interlock.diag.called import called
from interlock.model.elements import MachineId, Position, SectionId, SignalId
from interlock.table.cells import RouteKind, Shows


@dataclass(frozen=True)
class Need:
    """A thing without which the signal is at stop: what a tester does, as inputs too, and the rule that asks for it."""

    lost: str
    inputs: dict[str, int]
    rule: str


def needs(row: Row) -> Iterator[Need]:
    """What keeps the signal at stop, and returns it there: track, machines, conditions, blocks, lost inputs."""
    y, machines = row.bench.symbols, row.bench.layout.machines
    for s, rule in dict(reversed(list(_clear(row)))).items():
        if inputs := occupied(y, s):
            yield Need(f"{called('section', s)} reported occupied", inputs, rule)
    for m in row.demands:
        if inputs := undetected(y, m):
            yield Need(f"{machines.named(m)} without detection", inputs, "R10")
    for part in row.parts:
        for x in part.conditions.external:
            yield Need(f"condition {x.condition} not fulfilled", {str(y.condition[x.condition]): 0}, x.because.rule)
    yield from _lamps(row)
    for s in dict.fromkeys((*(s for part in row.parts for s, _ in part.path.locked), *row.overlap)):
        if s in y.sections.blocked:
            yield Need(f"{called('section', s)} blocked by the operator", {str(y.sections.blocked[s]): 1}, "R3")
    yield Need("inputs lost, since a substation does not answer", {str(y.valid): 0}, "R16")


def _lamps(row: Row) -> Iterator[Need]:
    """What must be able to light: the most restrictive proceed, the indicator of a speed, identifier lights past which
    the route leads."""
    g, lamps = row.row.entry, row.bench.symbols.lamp_proof
    if row.row.kind is RouteKind.MAIN and g in lamps.clear:
        word, proof = ("caution", lamps.caution[g]) if g in lamps.caution else ("clear", lamps.clear[g])
        yield Need(f"the {word} lamp of {g} out", {str(proof): 0}, "R11")
        if row.row.signal.aspect.shows is Shows.TWO_YELLOWS:
            yield Need(f"the second yellow lamp of {g} out", {str(lamps.second[g]): 0}, "R11")
        if row.row.signal.speed.kmh is not None:
            yield Need(f"the speed indicator of {g} out", {str(lamps.speed[g]): 0}, "R11")
    for part in row.parts[1:]:
        if part.entry in lamps.identifier:
            yield Need(f"the identifier lamp of {part.entry} out", {str(lamps.identifier[part.entry]): 0}, "R11")
    for x in dict.fromkeys(x for part in row.parts for x in part.clear.space if x.lamp):
        protecting = SignalId(x.name)
        yield Need(
            f"the stop lamp of {protecting}, which protects a flank, out",
            {str(lamps.stop[protecting]): 0},
            x.because.rule,
        )


def to_open(row: Row) -> Iterator[Need]:
    """What it takes besides to open the signal, and not to keep it open: its stop lamp, and the direction of a line."""
    y = row.bench.symbols
    for b in row.tokens:
        yield Need(f"the direction at {b} not asked for", {str(y.token[b].manual): 0}, "R12")
    if row.row.entry in y.lamp_proof.stop:
        yield Need(f"the stop lamp of {row.row.entry} out", {str(y.lamp_proof.stop[row.row.entry]): 0}, "R11")


def _clear(row: Row) -> Iterable[tuple[SectionId, str]]:
    """Track that has to be clear, each with its rule; the first of two that say so counts."""
    for part in row.parts:
        yield from ((c.section, c.because.rule) for c in (*part.clear.sections, *(part.clear.demanded or ())))
    yield from ((s, "R4") for s in row.overlap)
    for part in row.parts:
        yield from ((f.section, f.because.rule) for f in part.clear.foul if _fouls(row, f.when))
        yield from ((SectionId(x.name), x.because.rule) for x in part.clear.space if not x.lamp)
        yield from ((b.section, b.because.rule) for b in part.conditions.block)


def _fouls(row: Row, when: tuple[MachineId, Position] | None) -> bool:
    """Whether a section that is foul only while a machine lies somehow is so on the bench."""
    if when is None:
        return True
    lies = row.demands[when[0]].position if when[0] in row.demands else row.bench.lies[when[0]]
    return lies is when[1]
