"""A run as a page that plays it: plan, slider, sentences, and what changed.

Made from an ITF trace (the JSON trace format of the TLA+ tools): `vars`, `states`, and in `#meta` the plan as SVG,
which variable shows what on it (`views`), and the sentence of each state.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from typing import Any

from markupsafe import Markup

from interlock.emit.report.drawn import is_drawing
from interlock.emit.report.page import asset, environment, script_json


class BadTrace(Exception):
    """The file is not a trace that can be played; the message says why."""


def player_html(itf: str) -> str:
    """The page of an ITF trace.  Raises `BadTrace`."""
    try:
        trace = json.loads(itf)
        meta, states = trace["#meta"], trace["states"]
        texts = [str(s["#meta"]["text"]) for s in states]
        shown = [sorted(n for n in trace["vars"] if _true(s[n])) for s in states]
        plan, views = str(meta["plan"]), dict(meta["views"])
    except (ValueError, KeyError, TypeError, AttributeError, RecursionError):
        raise BadTrace("not an ITF trace with a plan, as `prove` and `compile` write them, nor a record") from None
    if not states or not is_drawing(plan):
        raise BadTrace("the trace has no states, or its plan is no drawing")
    used = {n: views[n] for n in sorted({*views} & {*trace["vars"]})}
    return (
        environment()
        .get_template("player.html.j2")
        .render(
            title=str(meta.get("title", "Trace")),
            claim=str(meta.get("claim", "")),
            sentence=str(meta.get("sentence", "")),
            occupied=str(meta.get("occupied", "a train")),
            plan=plan,
            steps=texts,
            css=Markup(asset("player.css")),
            js=asset("player.js"),
            data=script_json(
                {
                    "texts": texts,
                    "trains": "occupied" not in meta,
                    "shown": list(range(len(states))),
                    "states": [[n for n in names if n in used] for names in shown],
                    "views": used,
                }
            ),
        )
    )


def _true(value: Any) -> bool:
    if isinstance(value, Mapping):  # ITF writes large numbers as {"#bigint": "1"}
        return str(value.get("#bigint", "0")) != "0"
    return bool(value)
