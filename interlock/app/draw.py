"""Pictures: the track plan of a layout, and the player of a trace."""

from __future__ import annotations

from collections.abc import Sequence
from enum import StrEnum
from pathlib import Path

from interlock.app.own import write_whole
from interlock.app.proved import Proved
from interlock.dataclass import dataclass
from interlock.diag import Diagnostic, Severity, Sink
from interlock.emit.drawing import folded, opening, place, plan_svg, sheets
from interlock.emit.report import player_html
from interlock.frontend import Source, load


def plan_notes(notes: Sequence[str], source: Source) -> tuple[Diagnostic, ...]:
    """What a plan cannot show, as diagnostics of its layout."""
    span = source.at("name")
    return tuple(
        Diagnostic(
            "IL5008", Severity.WARNING, f"on the plan {note}", span, "tell the plan's readers, or try `drawing:`"
        )
        for note in notes
    )


class Paper(StrEnum):
    """How a plan is laid out: all of it on one page, on sheets of A3, or folded into rows."""

    WHOLE = "whole"
    SHEETS = "sheets"
    FOLDED = "folded"


@dataclass(frozen=True)
class Drawn:
    """A plan, page by page, what the drawing could not do, and the diagnostics when there is none."""

    source: Source
    pages: tuple[str, ...]
    notes: tuple[str, ...] = ()
    diagnostics: tuple[Diagnostic, ...] = ()


def draw_file(path: str, paper: Paper = Paper.WHOLE) -> Drawn:
    """The plan of a layout file; nothing needs to be derived or proved for it."""
    sink = Sink()
    layout, source = load(path, sink)
    if layout is None:
        return Drawn(source, (), (), sink.diagnostics)
    drawing = place(layout)
    if paper is Paper.SHEETS:
        pages = sheets(drawing)
    else:
        pages = [folded(drawing) if paper is Paper.FOLDED else opening(plan_svg(layout, drawing))]
    return Drawn(source, tuple(pages), tuple(drawing.notes))


def write_traces(proved: Proved, folder: Path) -> list[Path]:
    """A trace and a player for each refuted claim; the players' paths.  Raises OSError."""
    out = []
    layout = proved.checked.layout
    for claim, trace in proved.traces:
        assert layout is not None
        folder.mkdir(parents=True, exist_ok=True)
        page = folder / f"{layout.name}-{claim}.html"
        write_whole(page.with_suffix(".itf.json"), trace.encode())
        write_whole(page, player_html(trace).encode())
        out.append(page)
    return out
