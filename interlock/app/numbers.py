"""Numbers of trains while a runtime runs: they step with the sections that the inputs report.

They are kept from the first number that somebody names, by a command (`voyage 12:W>E`) or where a train stands (`train
12 q4`); until then nobody is told that a train has none.  Nothing steps while the inputs are not valid.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from interlock.dispatch import Dispatcher
from interlock.dispatch.describer import DOUBT, Describer
from interlock.dispatch.plan.errands import OUTSIDE
from interlock.dispatch.run import Run, ways
from interlock.logic.symbols import Symbols
from interlock.model.elements import SectionId
from interlock.model.layout import Layout


class Numbers:
    """Of one operator's place.  `kept`: somebody has named a number."""

    def __init__(self, layout: Layout, symbols: Symbols, dispatcher: Dispatcher) -> None:
        self.describer = Describer(layout, symbols)
        self.dispatcher = dispatcher
        self._rear = symbols.cancellation.approach_of
        self.kept = False
        self._seen: Mapping[str, int] = {}
        self._news: list[str] = []
        self._at: Mapping[str, Sequence[SectionId]] = {}
        self._told: set[str] = set()

    @property
    def alarms(self) -> dict[str, tuple[str, tuple[str, ...]]]:
        """By number: what is wrong, and where it is described."""
        found: dict[str, tuple[str, tuple[str, ...]]] = {}
        for number, text in self.describer.alarms.items():
            at = self.describer.where(number)
            found[number] = (f"train {number}: {text}", () if at is None else (str(at),))
        return found

    @property
    def sections(self) -> dict[str, list[str]]:
        """By number: the sections under it, the head's last."""
        return {t.number: [str(s) for s in t.under] for t in self.describer.trains if t.under}

    def expects(self, run: Run) -> None:
        """A command was taken: its train comes in over a boundary, or stands where the command says."""
        self._keep()
        at, way = run.journey.start.under[-1]
        if way == OUTSIDE:
            approach = self.dispatcher.railway.approach.get(str(at))
            if approach is None or not self.describer.takes(approach, run.name):
                self.describer.expects(str(at), run.name)
        else:
            self.describer.confirm(at, run.name)

    def ends(self, name: str) -> None:
        """A command was given up: its train does not come any more."""
        for row in self.describer.expected.values():
            if name in row:
                row.remove(name)

    def stands(self, number: str, section: str) -> bool:
        """Somebody has looked: this train stands there.  False where the section is not reported occupied."""
        self._keep()
        return self.describer.confirm(SectionId(section), number)

    def cycle(self, seen: Mapping[str, int], valid: bool) -> None:
        """After a cycle: numbers step, and nothing is asked for a train whose number is in doubt."""
        if not valid:
            return
        self._seen = seen
        if not self.kept:
            return
        self.describer.step(seen, self._ways())
        for run in (*self.dispatcher.runs, *self.dispatcher.pending):
            why = self.describer.alarms.get(run.name)
            if why is not None:
                self.dispatcher.held.setdefault(run.name, f"{DOUBT}: {why}")
            elif self.dispatcher.held.get(run.name, "").startswith(DOUBT):
                del self.dispatcher.held[run.name]
        now = {t.number: tuple(t.under) for t in self.describer.trains if t.under}
        for number, under in now.items():
            if self._at.get(number, ())[-1:] != under[-1:]:
                self._news.append(f"train {number} is in {under[-1]}")
        self._news += [f"train {number} has left" for number in self._at if number not in now]
        self._at = now
        alarms = self.describer.alarms
        self._news += [f"ALARM, train {n}: {text}" for n, text in alarms.items() if n not in self._told]
        self._told = set(alarms)

    def news(self) -> list[str]:
        """What has happened to numbers since this was last asked."""
        found, self._news = self._news, []
        return found

    def _ways(self) -> list[tuple[SectionId, ...]]:
        """Over which sections trains are to run, by the routes that are set for them."""
        return ways(self.dispatcher.runs, self._rear, self.describer.occupied)

    def _keep(self) -> None:
        if not self.kept:
            self.kept = True
            if self._seen:
                self.describer.step(self._seen, self._ways())
