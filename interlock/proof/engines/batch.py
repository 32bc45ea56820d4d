"""Goals asked of a solver one after the other."""

from __future__ import annotations

import time
from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from interlock.proof.engines import Answer, Sat
from interlock.proof.engines.tseitin import Cnf

LONG = 40  # a denial of more literals than this is asked by itself


@dataclass(frozen=True, slots=True)
class Decision:
    """Whether a goal follows, and the seconds that the question took."""

    follows: bool
    seconds: float


@dataclass(frozen=True, slots=True)
class Together:
    """Denials by number: none of them can be if the literals cannot all be true."""

    literals: Sequence[int]
    denials: Sequence[int]


def together(cnf: Cnf, denials: Sequence[Sequence[int]]) -> list[Together]:
    """All denials; those that differ in one literal only are one question: can the rest be, with one of these?

    Adds the clauses for that.  What a signal promises of each section, say, is shown once for all that it promises.
    """
    rests = [_rests(d) for d in denials]
    often = Counter(rest for those in rests for rest in those)
    alike: dict[object, list[int]] = {}
    for n, those in enumerate(rests):
        best = max(those, key=often.__getitem__, default=None)
        alike.setdefault(n if best is None or often[best] < 2 else best, []).append(n)
    found: list[Together] = []
    for rest, numbers in alike.items():
        if isinstance(rest, tuple) and len(numbers) > 1:
            chosen = cnf.fresh()
            others = set(rest)
            cnf.clauses.append((-chosen, *(x for n in numbers for x in denials[n] if x not in others)))
            found.append(Together((*rest, chosen), numbers))
        else:
            found += [Together(denials[n], (n,)) for n in numbers]
    return found


def _rests(denial: Sequence[int]) -> list[tuple[int, ...]]:
    """A denial without one of its literals, in one order."""
    if not 1 < len(denial) <= LONG:
        return []
    ordered = sorted(denial)
    return [(*ordered[:k], *ordered[k + 1 :]) for k in range(len(ordered))]


def decisions(
    sat: Sat,
    denials: Sequence[Sequence[int]],
    known: Sequence[bool] = (),
    patience: int = 0,
    asked: Iterable[Together] = (),
) -> list[Decision]:
    """Which goals follow, each by itself: those whose denial cannot be.

    known: those that need not be asked.  patience: when so many do not follow, the rest is left open.  asked: which
    denials are asked together at first, each of them once.
    """
    found = [Decision(follows, 0.0) for follows in known or [False] * len(denials)]
    left = patience or len(denials)
    for question in asked or (Together(d, (n,)) for n, d in enumerate(denials)):
        numbers = [n for n in question.denials if not found[n].follows]
        if len(numbers) > 1:
            began = time.perf_counter()
            if sat.ask(*question.literals) is Answer.UNSAT:
                each = Decision(True, (time.perf_counter() - began) / len(numbers))
                for n in numbers:
                    found[n] = each
                continue
        for n in numbers:
            if left <= 0:
                return found
            began = time.perf_counter()
            follows = sat.ask(*denials[n]) is Answer.UNSAT
            left -= not follows
            found[n] = Decision(follows, time.perf_counter() - began)
    return found
