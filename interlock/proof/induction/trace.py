"""A counterexample as an ITF trace (the JSON trace format of the TLA+ tools), with all that a player needs.

**Theorem.**  The trace lists, state by state, the variables that are true in the run that was found, and nothing
else: it is a run of the system if and only if the counterexample is.  (Informal Trace Format, Apalache, ADR 015.)
"""

from __future__ import annotations

import json
from collections.abc import Sequence

from interlock.logic import names
from interlock.logic.names import Name
from interlock.model.machines import shown_by
from interlock.proof.induction.story import Story
from interlock.proof.system.loop import ClosedLoop


def views(loop: ClosedLoop, state: Sequence[Name]) -> dict[str, list[list[str]]]:
    """What each state variable shows on the plan: kind of element, its id, what is shown, and of
    a machine the word for it."""
    sym, layout, known = loop.controller.symbols, loop.layout, set(state)
    out: dict[str, list[list[str]]] = {}
    for s in layout.track.sections:
        if names.STANDS(s.id) in known:
            out[names.STANDS(s.id)] = [["section", s.id, "occupied"]]
    for (s_, n), name in sym.sections.lock.items():
        out[name] = [["edge", e, "locked"] for e in loop.topo.traversals[s_][n - 1].edges]
    for option, name in sym.overlaps.held.items():
        ways = sym.overlaps.ways[option]
        out[name] = [["edge", e, "overlap"] for s_, n in ways for e in loop.topo.traversals[s_][n - 1].edges]
    for s_, name in sym.sections.restart.items():
        out[name] = [["section", s_, "restart"]]
    for r in sym.routes:
        shows = "identifier" if r.path.identifier else "proceed"
        out |= {name: [["signal", r.entry, shows]] for name in r.open_while}
    for (m, x), _ in sym.machines.command.items():
        out[names.LIES(m, x)] = shown_by(layout.machines, m, x)
    return {n: v for n, v in out.items() if n in known}


def itf(loop: ClosedLoop, state: Sequence[Name], story: Story, layout_digest: str, plan: str) -> str:
    """The trace of a story: one state for each of its steps; `state`: the state variables."""
    states: list[dict[str, object]] = []
    for k, (text, frame) in enumerate(zip(story.steps, story.after, strict=True)):
        true = set(story.frames[frame][0])
        states.append({"#meta": {"index": k, "text": text}, **{n: n in true for n in state}})
    body = {
        "#meta": {
            "format": "ITF",
            "title": f"Counterexample to {story.claim} in {loop.layout.name}",
            "claim": f"{story.claim} at {story.place}",
            "sentence": story.sentence,
            "layout": layout_digest,
            "plan": plan,
            "views": views(loop, state),
        },
        "vars": [*state],
        "states": states,
    }
    return json.dumps(body, ensure_ascii=False, indent=1) + "\n"
