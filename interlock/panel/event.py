"""What happens at a panel, as it is told to every browser and recorded."""

from __future__ import annotations

from dataclasses import field
from datetime import datetime
from typing import Any

from interlock.app.reasons import Reason
from interlock.dataclass import dataclass


def stamp() -> str:
    """The time on the wall, with its zone."""
    return datetime.now().astimezone().isoformat(timespec="milliseconds")


def rules(event: Event) -> list[str]:
    """The rule behind each reason, empty where none is named."""
    return [r.rule for r in event.reasons]


@dataclass
class Event:
    """Something that happened: `kind` is operation, refusal, release, alarm, acknowledged, cleared or note."""

    kind: str
    text: str
    who: str = ""
    at: tuple[str, ...] = ()
    reasons: tuple[Reason, ...] = ()
    time: str = field(default_factory=stamp)
    number: int = 0

    def told(self) -> dict[str, Any]:
        """As it is sent and recorded."""
        body = {"n": self.number, "time": self.time, "kind": self.kind, "text": self.text, "who": self.who}
        return body | {
            "at": list(self.at),
            "reasons": [[r.text, list(r.at)] for r in self.reasons],
            "rules": rules(self),
        }
