"""What is asked for at a panel, in words: a refusal names it, since the record has nothing else of it."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from interlock.model.elements import MachineId, Position
from interlock.model.machines import Machines
from interlock.panel.commands import TEXT

ASKED = {
    "set": "set route {route}",
    "why": "why route {route} is at stop",
    "swing": "swing the overlap of {signal}",
    "cancel": "cancel the route from {signal}",
    "stop": "all signals to stop",
    "release": "release section {section}",
    "release all": "release all clear sections",
    "turn": "{to}",
    "looked": "{machine} was looked at",
    "direction": "special manual change of direction at {boundary}",
    "voyage": "voyage {name}",
    "train": "train {name} stands in {section}",
    "remind": "reminder on {at}",
    "put": "put train {train} on {section}",
    "bring": "bring train {train} to {boundary}",
    "turn train": "let train {train} change ends",
    "divide": "divide train {train}",
    "take away": "take away train {train}",
    "speed": "time runs {times} times as fast",
}
"""By command: what is asked for."""

SWITCHED = {
    "block": ("free section {section}", "block section {section}"),
    "automatic": ("route {route} does not work automatically", "route {route} works automatically"),
    "drive": ("stop train {train}", "let train {train} go on"),
    "fail": ("put right {kind} {name}", "let {kind} {name} fail"),
    "power": ("power off", "power on"),
}
"""By command that has `on` or `go`: what is asked for without and with it."""


class _Fields(dict[str, str]):
    """The fields of a command; what is missing is named by nothing."""

    def __missing__(self, key: str) -> str:
        return ""


def in_words(command: Mapping[str, Any], machines: Machines) -> str:
    """What somebody asks for."""
    what = str(command.get("do", ""))[:TEXT]
    on = bool(command.get("on", command.get("go")))
    found = SWITCHED[what][on] if what in SWITCHED else ASKED.get(what)
    if found is None:  # what nobody knows may say anything, and is no form to be filled in
        return " ".join(what.split())
    fields = _Fields({str(k): str(v)[:TEXT] for k, v in command.items()})
    x = {"N": Position.NORMAL, "R": Position.REVERSE}.get(fields["to"])
    m = MachineId(fields["machine"])
    fields["to"] = f"move {m}" if x is None else machines.to_move(m, x)
    if what == "remind":
        fields["at"] = fields["at"].partition(":")[2]
    return " ".join(found.format_map(fields).split())
