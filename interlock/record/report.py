"""The report of a shift: one page that needs nothing else, made from its record alone."""

from __future__ import annotations

from functools import lru_cache

from jinja2 import Environment, PackageLoader, StrictUndefined, UndefinedError, select_autoescape

from interlock.record.graph import graph_svg
from interlock.record.log import Recorded
from interlock.record.shift import LOADS, OUTSIDE, RUNS, TIPS, Figures, as_written, clock, figures

WAITS = "waits"
COLOURS = {RUNS: "#0b5fa5", LOADS: "#15803d", TIPS: "#a16207", OUTSIDE: "#cbd5e1", WAITS: "#dc2626"}


@lru_cache(maxsize=1)
def _environment() -> Environment:
    return Environment(
        loader=PackageLoader("interlock.record", "."),
        undefined=StrictUndefined,
        autoescape=select_autoescape(default=True, default_for_string=True),
        trim_blocks=True,
        lstrip_blocks=True,
    )


def share(f: Figures, train: str, name: str) -> float:
    """The part of the shift for which a train was in a state; `waits`: in none of the others."""
    if name != WAITS:
        return f.share(train, name)
    rest = sum(s for state, s in f.states[train].items() if state not in COLOURS)
    return rest / f.seconds if f.seconds else 0.0


@as_written()
def shift_html(recorded: Recorded) -> str:
    """The page of a shift's record, up to its last whole event.  Raises `NoShift`."""
    f, template = figures(recorded.events), _environment().get_template("shift.html.j2")
    try:
        return template.render(
            f=f,
            graph=graph_svg(recorded.events),
            clock=clock,
            colours=COLOURS,
            share=lambda train, name: share(f, train, name),
            hazards=[(None, x) for x in f.hazards],
            chain=recorded.chain.digest,
            ended=recorded.ended,
        )
    except UndefinedError as error:
        raise LookupError(error) from error
