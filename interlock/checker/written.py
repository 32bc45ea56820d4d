"""The certificate's written system, line by line and by kinds."""

from __future__ import annotations

from dataclasses import dataclass, field

from interlock.checker.formula import Formula, read, spaced
from interlock.verify import need

WORDS = {"assumed": 2, "sentence": 2, "state": 1, "ini": 1, "def": 2, "asm": 2, "timer": 3, "val": 2, "lemma": 1}
WORDS |= {"inv": 3, "claim": 3, "start": 1}


@dataclass
class Written:
    """What is told of a system: names by what they are, formulas as they stand."""

    sentences: dict[str, str] = field(default_factory=dict)
    assumed: dict[str, str] = field(default_factory=dict)
    state: list[str] = field(default_factory=list)
    initial: list[Formula] = field(default_factory=list)
    definitions: dict[str, Formula] = field(default_factory=dict)
    assumptions: list[tuple[str, Formula]] = field(default_factory=list)
    timers: dict[str, tuple[str, int]] = field(default_factory=dict)
    ranges: dict[str, int] = field(default_factory=dict)
    claims: list[tuple[str, str, Formula]] = field(default_factory=list)
    start: list[Formula] = field(default_factory=list)


def written(text: str) -> Written:
    """The lines of system.txt; invariants and lemmas are proved, and so are nobody's concern but the prover's."""
    w = Written()
    for line in text.splitlines()[1:]:
        kind, _, rest = line.partition(" ")
        need(kind in WORDS, f"the written system has an unknown line {line[:60]}")
        said = rest.split(" ", WORDS[kind] - 1)
        if kind not in ("sentence", "assumed"):
            said[:-1] = map(spaced, said[:-1])
        need(len(said) == WORDS[kind], f"the written system has a line without all its words: {line[:60]}")
        if kind in ("sentence", "assumed"):
            book = w.sentences if kind == "sentence" else w.assumed
            need(book.setdefault(said[0], said[1]) == said[1], f"{said[0]} has two sentences")
        elif kind == "state":
            w.state.append(spaced(said[0]))
        elif kind == "ini":
            w.initial.append(read(said[0]))
        elif kind == "def":
            need(said[0] not in w.definitions, f"{said[0]} is defined twice")
            w.definitions[said[0]] = read(said[1])
        elif kind == "asm":
            w.assumptions.append((said[0], read(said[1])))
        elif kind == "timer":
            need(said[0] not in w.timers, f"the timer {said[0]} is told twice")
            w.timers[said[0]] = (said[1], int(said[2]))
        elif kind == "val":
            w.ranges[said[0]] = int(said[1])
        elif kind == "claim":
            w.claims.append((said[0], said[1], read(said[2])))
        elif kind == "start":
            w.start.append(read(said[0]))
    return w
