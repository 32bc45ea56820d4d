"""Whether the routes of a layout that are not hostile can be used at the same time, and how soon each one opens."""

from __future__ import annotations

from pathlib import Path

from interlock.app.check import Checked, check_file
from interlock.app.own import write_whole
from interlock.dataclass import dataclass
from interlock.emit.drawing import plan_svg
from interlock.emit.report import player_html
from interlock.logic.lower import lower
from interlock.proof.induction.trace import itf
from interlock.proof.system.loop import ClosedLoop, closed_loop
from interlock.proof.system.transition import System
from interlock.proof.witnesses.availability import Availability, PairResult, Trial, availability

TRACES = 8  # so many pairs that failed get a page that plays them


@dataclass(frozen=True)
class Tried:
    """A checked layout and what its runs showed (None when it has errors)."""

    checked: Checked
    railway: ClosedLoop | None = None
    found: Availability | None = None

    @property
    def shown(self) -> bool:
        """Every route and every pair."""
        return self.found is not None and self.found.shown


def try_file(path: str) -> Tried:
    """Check a file and carry out the runs of its controller."""
    checked = check_file(path)
    if not checked.ok or checked.layout is None or checked.table is None:
        return Tried(checked)
    railway = closed_loop(checked.layout, lower(checked.layout, checked.table))
    return Tried(checked, railway, availability(railway, checked.table))


def write_stories(tried: Tried, folder: Path) -> list[Path]:
    """A trace and a page that plays it for pairs that failed; the pages.  Raises OSError."""
    if tried.railway is None or tried.found is None or tried.checked.layout is None:
        return []
    failed = [p for p in tried.found.pairs if p.failed is not None][:TRACES]
    if not failed:
        return []
    layout, trial = tried.checked.layout, Trial(tried.railway)
    relation = System(layout, tried.railway.controller).relation
    plan, out = plan_svg(layout), []
    folder.mkdir(parents=True, exist_ok=True)
    for p in failed:
        story = trial.story(p, relation)
        assert story is not None
        trace = itf(tried.railway, relation.state, story, layout.digest, plan)
        page = folder / f"{layout.name}-{_file(p)}.html"
        write_whole(page.with_suffix(".itf.json"), trace.encode())
        write_whole(page, player_html(trace).encode())
        out.append(page)
    return out


def _file(p: PairResult) -> str:
    return "".join(c if c.isalnum() or c in "-_." else "_" for c in f"{p.first}+{p.second}")
