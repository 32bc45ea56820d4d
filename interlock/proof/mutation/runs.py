"""The runs of trains and operators that work with a controller, and which of them a change reaches.

All runs are taken once, and what every wire and next value reads in each of their scans is kept.  A changed equation
that has, in all these scans, the value of the one it replaces leaves every run as it was: nothing is run again.
Otherwise the runs in which it once had another value are.

**Theorem.**  The loop is deterministic under given choices and inputs: a run in whose every scan the changed equations
have the values of those that they replace is a run of the changed loop, with the same states.  (Induction over scans.)
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from interlock.logic.expr import AND, NOT, OR, TRUE, VAR, Expr
from interlock.logic.names import Name
from interlock.proof.system.loop import ClosedLoop
from interlock.proof.witnesses.operations import operated
from interlock.proof.witnesses.routes import Trial, Trials, journeys


class Runs:
    """The runs that work with a controller as it is."""

    def __init__(self, loop: ClosedLoop) -> None:
        self.journeys, self.operations = journeys(loop), operated(loop)
        self.trials: list[Trial] = [*self.journeys, *self.operations]
        self._steps: list[Mapping[str, int]] = []
        self._going: list[int] = []
        self._vectors: dict[str, int] = {}
        found = Trials(loop, self._record).run(self.trials)
        if any(failure is not None for failure in found):
            raise RuntimeError("a run that works alone does not work beside others")
        self._mask = self._joined(self._going)
        self._equations = {e.name: e.expr for e in loop.controller.equations}
        self._equations |= {e.name.next: e.expr for e in loop.controller.next}

    def _record(self, values: Mapping[str, int], going: int) -> None:
        self._steps.append(values)
        self._going.append(going)

    def _joined(self, vectors: Sequence[int]) -> int:
        """The vectors of all scans as one."""
        size = (len(self.trials) + 7) // 8
        return int.from_bytes(b"".join(v.to_bytes(size, "little") for v in vectors), "little")

    def reached(self, changed: Mapping[Name, Expr]) -> list[int]:
        """The runs in which one of the changed right sides once has another value."""
        memo: dict[Expr, int] = {}
        differ = 0
        for name, x in changed.items():
            differ |= self._value(x, memo) ^ self._value(self._equations[name], memo)
        differ &= self._mask
        size = (len(self.trials) + 7) // 8
        runs = 0
        data = differ.to_bytes(size * len(self._steps), "little") if differ else b""
        for k in range(0, len(data), size):
            runs |= int.from_bytes(data[k : k + size], "little")
        return [n for n in range(len(self.trials)) if runs >> n & 1]

    def _value(self, x: Expr, memo: dict[Expr, int]) -> int:
        """An expression in every scan of every run."""
        found = memo.get(x)
        if found is None:
            memo[x] = found = self._computed(x, memo)
        return found

    def _computed(self, x: Expr, memo: dict[Expr, int]) -> int:
        if not x.args:
            if not x.name:
                return self._mask if x is TRUE else 0
            name = x.name if x.op is VAR else f"{x.name}={x.value}"
            if name not in self._vectors:
                self._vectors[name] = self._joined([s[name] for s in self._steps]) & self._mask
            return self._vectors[name]
        if x.op is NOT:
            return self._mask ^ self._value(x.args[0], memo)
        out = self._mask if x.op is AND else 0
        for a in x.args:
            y = self._value(a, memo)
            out = out | y if x.op is OR else out & y
        return out

    def noticed(self, loop: ClosedLoop, changed: Mapping[Name, Expr] | None) -> tuple[bool, str] | None:
        """Whether a run does not work any more under a mutant, and which, and why: first trains (True), then
        operators.  `changed`: the definitions that are others; None where more than right sides has changed."""
        every = changed is None or not changed.keys() <= self._equations.keys()
        those = range(len(self.trials)) if changed is None or every else self.reached(changed)
        on = None
        for trains in (True, False):
            some = [self.trials[n] for n in those if (n < len(self.journeys)) is trains]
            if not some:
                continue
            on = on or Trials(loop)
            for t, failure in zip(some, on.run(some, first=True), strict=True):
                if failure is not None:
                    return trains, f"{t.name}: {failure}"
        return None
