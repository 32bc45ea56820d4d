"""A span of a shift's record as a trace that the player plays: sections, signals and points after every event."""

from __future__ import annotations

import json
from collections.abc import Sequence

from interlock.emit.drawing import place, plan_svg
from interlock.model.elements import Position
from interlock.model.layout import Layout
from interlock.model.machines import Machines, shown_by
from interlock.record.log import Event
from interlock.record.shift import NoShift, as_written, clock

_WORDS = {
    "comes": "train {train} comes towards {at}",
    "enters": "train {train} comes into {section}",
    "clears": "train {train} has left {section}",
    "leaves": "train {train} is gone over {at}",
    "passes": "train {train} passes {signal}",
    "stands": "train {train} stands in {section}",
    "runs": "train {train} sets off",
    "turns": "train {train} changes ends in {section}",
    "granted": "{route} is set for train {train}",
    "ordered": "train {train} is ordered to {load}, then to {tip}",
    "waits": "train {train} waits: {text}",
    "loads": "train {train} is being loaded at {place}",
    "loaded": "train {train} is loaded",
    "tips": "train {train} is being tipped at {place}",
    "tipped": "train {train} is tipped: {tonnes} t",
    "back": "train {train} is back",
    "alarm": "alarm: {text}",
    "fault": "fault: {text}",
    "mended": "mended: {text}",
    "hazard": "HAZARD: {text}",
    "pressed": "the operator presses {button}",
}


@as_written()
def trace(layout: Layout, events: Sequence[Event], since_s: float, until_s: float) -> str:
    """The trace of a span, seconds from the shift's beginning.  Raises `NoShift`: no shift of this layout, or nothing
    happened in the span."""
    if not events or events[0].get("what") != "shift" or events[0]["layout_digest"] != layout.digest:
        raise NoShift(f"this log is no record of a shift on {layout.name} as it is now")
    names = sorted([f"o.{s.id}" for s in layout.track.sections] + [f"g.{g.id}" for g in layout.signalling.signals])
    names += [f"at.{m}.{x}" for m in layout.machines for x in "NR"]
    on: dict[str, int] = {f"at.{m}.N": 1 for m in layout.machines}
    states: list[dict[str, object]] = []
    for e in events:
        said = _said(e, on, layout.machines)
        if said and since_s <= e["t"] / 1000 <= until_s:
            text = f"{clock(e['t'] / 1000)} {said}"
            states.append({"#meta": {"index": len(states), "text": text}, **{n: bool(on.get(n)) for n in names}})
    if not states:
        raise NoShift("nothing happened in this span")
    body = {
        "#meta": {
            "format": "ITF",
            "title": f"{layout.name}: shift with seed {events[0]['seed']}",
            "claim": "",
            "sentence": "",
            "layout": layout.digest,
            "plan": plan_svg(layout, place(layout)),
            "views": _views(layout),
        },
        "vars": names,
        "states": states,
    }
    return json.dumps(body, ensure_ascii=False) + "\n"


def _said(e: Event, on: dict[str, int], machines: Machines) -> str:
    """The sentence of an event, after what it changes is changed; empty for what shows itself."""
    kind = e["kind"]
    if kind in ("enters", "clears"):
        name = f"o.{e['section']}"
        on[name] = max(0, on.get(name, 0) + (1 if kind == "enters" else -1))
    elif kind == "signal":
        on[f"g.{e['signal']}"] = int(e["open"])
        return f"{e['signal']} {'opens' if e['open'] else 'shows stop'}"
    elif kind == "lies":
        on[f"at.{e['machine']}.N"], on[f"at.{e['machine']}.R"] = int(e["position"] == 0), int(e["position"] == 1)
        return machines.lie(e["machine"], Position.REVERSE if e["position"] else Position.NORMAL)
    return _WORDS[kind].format(**e) if kind in _WORDS else ""


def _views(layout: Layout) -> dict[str, list[list[str]]]:
    out = {f"o.{s.id}": [["section", str(s.id), "occupied"]] for s in layout.track.sections}
    out |= {f"g.{g.id}": [["signal", str(g.id), "proceed"]] for g in layout.signalling.signals}
    for m in layout.machines:
        out |= {f"at.{m}.{x}": shown_by(layout.machines, m, x) for x in Position}
    return out
