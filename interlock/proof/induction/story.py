"""A counterexample told in the engineer's words, as numbered steps.

**Theorem.**  Every frame is evaluated from the run itself, with the equations that were encoded, so that the
sentences tell what the system does in this run and add no step to it.  (Evaluation of a formula in a model.)
"""

from __future__ import annotations

from collections.abc import Sequence

from interlock.dataclass import dataclass
from interlock.diag.called import called
from interlock.logic import names
from interlock.logic.expr import evaluate
from interlock.model.elements import Position
from interlock.proof.claims import CLAIMS
from interlock.proof.induction.search import Frame, Run
from interlock.proof.system.loop import ClosedLoop


@dataclass(frozen=True)
class Story:
    """The claim that fails, the steps in words, and the raw run for replay."""

    claim: str
    place: str
    sentence: str
    steps: tuple[str, ...]
    frames: tuple[tuple[tuple[str, ...], tuple[str, ...]], ...]
    after: tuple[int, ...] = ()
    """For each step, the frame whose state it leads to."""


def tell(loop: ClosedLoop, run: Run) -> Story:
    """A violated claim as sentences."""
    sentence = CLAIMS[run.claim.id]
    ending = [f"This violates {run.claim.id} at {run.claim.place}: {sentence}"]
    if run.claim.id.endswith("-FLANK"):
        leg = run.claim.place.split(":", 2)[2]
        ending.insert(
            0, f"Nothing keeps a vehicle away that rolls in over {leg}: no signal at stop, no point turned away."
        )
    return narrated(loop, run.frames, (run.claim.id, run.claim.place, sentence), ending)


def narrated(loop: ClosedLoop, frames: Sequence[Frame], claim: tuple[str, str, str], ending: Sequence[str]) -> Story:
    """A run as sentences; frames with nothing to tell are joined to the next.  `claim`: its id, place and sentence."""
    steps: list[str] = []
    trains = [str(n.at[0]) for n in loop.plant.state if n.family is names.STANDS]
    first = frames[0].state
    standing = [s for s in trains if first[names.STANDS(s)]]
    lying = _points(loop, first)
    steps.append(
        "Restart: everything is locked, all signals show stop"
        + (f"; a train stands in {', '.join(standing)}" if standing else "; no train inside")
        + (f"; {lying}" if lying else "")
        + "."
    )
    after_step = [0]
    raw: list[tuple[tuple[str, ...], tuple[str, ...]]] = []
    for i, frame in enumerate(frames):
        values = {**frame.state, **frame.inputs}
        memo: dict[int, bool] = {}
        events = [
            loop.plant.choices[names.choice(e)]
            for e, x in loop.plant.flat.events.items()
            if names.choice(e) in loop.plant.choices and evaluate(x, lambda n, v=values: v.get(n, 0), memo)  # type: ignore[misc]
        ]
        asked = _requests(loop, frame.inputs)
        after = frames[i + 1].state if i + 1 < len(frames) else None
        shown = _changes(loop, frame.state, after) if after is not None else []
        sentences = [*events, *asked, *shown]
        raw.append(
            (
                tuple(sorted(n for n, v in frame.state.items() if v)),
                tuple(f"{n}={v}" for n, v in sorted(frame.inputs.items()) if v),
            )
        )
        if sentences:
            steps.append("; ".join(_capital(s) if k == 0 else s for k, s in enumerate(sentences)) + ".")
            after_step.append(min(i + 1, len(frames) - 1))
    last = frames[-1].state
    lines = [
        f"the line at {b}"
        for b in loop.controller.symbols.token
        if last[names.ON_LINE(b, "in")] or last[names.ON_LINE(b, "out")]
    ]
    where = ", ".join([*(s for s in trains if last[names.STANDS(s)]), *lines])
    lying = _points(loop, last)
    now = f"Now trains stand in {where}" if where else "Now no train is inside"
    steps.append(f"{now}{f'; {lying}' if lying else ''}.")
    steps += ending
    after_step += [len(frames) - 1] * (len(steps) - len(after_step))
    return Story(*claim, tuple(steps), tuple(raw), tuple(after_step))


def _capital(text: str) -> str:
    return text[:1].upper() + text[1:]


def _points(loop: ClosedLoop, state: dict[str, int]) -> str:
    out = []
    for m in loop.layout.machines:
        lying = [loop.layout.machines.word(m, x) for x in Position if state[names.LIES(m, x)]]
        out.append(f"{m} lies {lying[0] if lying else 'between its positions'}")
    return ", ".join(out)


def _requests(loop: ClosedLoop, inputs: dict[str, int]) -> list[str]:
    out, symbols = [], loop.controller.symbols
    for who, name in (
        ("the operator", symbols.requests.request),
        ("somebody on the spot", symbols.requests.local_request),
    ):
        request = inputs.get(name, 0) if name else 0
        out += [f"{who} asks for route {r.id}" for r in symbols.routes if r.number == request]
        swings = [g for g, number in symbols.overlaps.swing_request.items() if number == request]
        out += [f"{who} asks for another overlap of {g}" for g in swings]
    for i in loop.controller.inputs:
        if i.note.startswith("operator:") and not i.size and inputs.get(i.name):
            out.append(i.note.replace("operator: ", "the operator: ").split(" (")[0])
    if not inputs.get(symbols.valid, 0):
        out.append("inputs are lost")
    return out


def _changes(loop: ClosedLoop, old: dict[str, int], new: dict[str, int]) -> list[str]:
    out, symbols = [], loop.controller.symbols
    for r in symbols.routes:
        now, before = (any(x[n] for n in r.open_while) for x in (new, old))
        if now and not before:
            what = "its identifier light" if r.path.identifier else "proceed"
            out.append(f"{called('signal', r.entry)} shows {what} for route {r.id}")
        if before and not now:
            out.append(f"{called('signal', r.entry)} returns to stop")
    for b, token in symbols.token.items():
        if new[token.have] and not old[token.have]:
            out.append(f"the direction at {b} is ours")
        if new[token.give] and not old[token.give]:
            out.append(f"the direction at {b} is given to the neighbour")
    for (m, x), name in symbols.machines.command.items():
        if new[name] and not old[name]:
            out.append(f"machine {m} is commanded {loop.layout.machines.word(m, x)}")
    for s, name in symbols.sections.clear.items():
        del name
        if names.STANDS(s) in new and new[names.IMAGE(s)] and not new[names.STANDS(s)] and not old[names.IMAGE(s)]:
            out.append(f"{s} is falsely reported occupied")
    return out
