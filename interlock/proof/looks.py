"""Goals of a large system decided view by view, first of what is near and then of all around: see `views.py`."""

from __future__ import annotations

import time
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from interlock.logic.expr import Expr
from interlock.logic.names import Kind
from interlock.proof.alike import Forms
from interlock.proof.asking import decisions
from interlock.proof.engines import solver
from interlock.proof.limits import Limits
from interlock.proof.onesided import OneSided
from interlock.proof.pool import Board
from interlock.proof.scenes import scenes
from interlock.proof.sight import view
from interlock.proof.views import Placed, Scene, View, Views

CHUNK = 60  # scenes that are looked at one after the other by one process


@dataclass(frozen=True)
class Look:
    """Scenes, the goals that are in them, and how far around a view goes."""

    scenes: Sequence[Scene]
    goals: Sequence[int]

    def __len__(self) -> int:
        return len(self.goals)


@dataclass(frozen=True, slots=True)
class Seen:
    """The goals that a look has left open, and the seconds that it took."""

    open: tuple[int, ...]
    seconds: float


class Looks:
    """Looks at goals, and what they show."""

    def __init__(self, system: Placed, hypotheses: Sequence[Expr], limits: Limits) -> None:
        """`hypotheses`: the invariants."""
        self.views = Views(system, hypotheses)
        self.limits = limits
        self._forms = Forms({})
        self._known: dict[str, list[bool]] = {}
        self._shown = Board() if limits.jobs > 1 else None
        """Forms in which all that is asked follows, whoever has asked."""

    def looks(self, goals: Iterable[tuple[int, Expr]]) -> list[Look]:
        """Numbered goals in so many looks; some are in none."""
        found = scenes(self.views, goals)
        looks = [
            Look(some, tuple(dict.fromkeys(n for s in some for n in s.goals)))
            for some in (found[k : k + CHUNK] for k in range(0, len(found), CHUNK))
        ]
        each = -(-len(looks) // self.limits.jobs)  # a process begins where no other has been: neighbours are alike
        return [x for k in range(each) for x in looks[k::each]]

    def see(self, look: Look) -> Seen:
        """What a look shows."""
        began = time.perf_counter()
        left: dict[int, None] = {}
        for scene in look.scenes:
            left |= self._left(scene)
        return Seen(tuple(left), time.perf_counter() - began)

    def _left(self, scene: Scene) -> dict[int, None]:
        """The goals of a scene that follow neither from what is near nor from all around.

        An overlap lies elsewhere than the signal that holds it: what is near is not asked.
        """
        if not any(h.kind is Kind.OVERLAP for h in scene.homes):
            open_ = self._open(scene, narrow=True)
            if not open_:
                return open_
            scene = scene.only(open_)
        return self._open(scene, narrow=False)

    def _open(self, scene: Scene, narrow: bool) -> dict[int, None]:
        """The goals of a scene that do not follow in its view."""
        seen = view(self.views, scene, narrow)
        decided = zip(seen.asked, self._decided(seen), strict=True)
        return {n: None for (_, goals), follows in decided if not follows for n in goals}

    def _decided(self, seen: View) -> list[bool]:
        """What follows in a view; in one that is another but for names, the same."""
        form = self._forms.of(seen.definitions, [x for x, _ in seen.asked], seen.facts)
        found = self._known.get(form)
        if found is None and self._shown is not None and bytes.fromhex(form) in self._shown:
            found = self._known[form] = [True] * len(seen.asked)
        if found is None:
            key = self.limits.cache.key(lambda: form, self.limits.engine)
            found = self.limits.cache.known(key, len(seen.asked))
            if not all(found):
                found = self._asked(seen)
                self.limits.cache.keep(key, found)
            self._known[form] = found
            if self._shown is not None and all(found):
                self._shown.write(bytes.fromhex(form))
        return found

    def _asked(self, seen: View) -> list[bool]:
        cnf = OneSided(seen.definitions)
        for x in seen.facts:
            cnf.require(x)
        denials = [cnf.denial(x) for x, _ in seen.asked]
        sat = solver(self.limits.engine, cnf, self.limits.query_ms)
        return [d.follows for d in decisions(sat, denials)]
