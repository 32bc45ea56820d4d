"""The panel at work: how long a change takes to the page; and the server and the client of longer trials.

    python -m tests.campaigns.panel [-o proofs/panel.md]

The client works a panel at random: routes, cancellations, releases, blocks, trains, faults, lost substations, power
cuts.  `tests.campaigns.service` lets it do so for hours.
"""

from __future__ import annotations

import argparse
import json
import os
import platform
import statistics
import subprocess
import sys
from collections import Counter
from collections.abc import Sequence
from pathlib import Path
from random import Random
from typing import Any

from websockets.sync.client import ClientConnection

from tests.browsers import browser
from tests.campaigns.origin import processor
from tests.pages import changes

LAYOUT = Path("layouts/heishan.yaml").resolve()


class Server:
    """The command as a process."""

    def __init__(self, record: Path, layout: Path = LAYOUT, more: Sequence[str] = ()) -> None:
        command = [sys.executable, "-m", "interlock", "run", str(layout), "--panel", "--port", "0", *more]
        self.process = subprocess.Popen(
            [*command, "--record", str(record)], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True
        )
        assert self.process.stdout is not None
        line = next(x for x in self.process.stdout if x.startswith("panel: "))
        self.url = line.removeprefix("panel: http").strip()

    def mib(self) -> float:
        """Resident memory (Linux)."""
        pages = int(Path(f"/proc/{self.process.pid}/statm").read_text("ascii").split()[1])
        return pages * os.sysconf("SC_PAGE_SIZE") / 2**20

    def end(self, how: int) -> int:
        """Its exit code."""
        self.process.send_signal(how)
        self.process.wait(30)
        return self.process.returncode


class Client:
    """Somebody who works a panel at random."""

    def __init__(self, ws: ClientConnection, rng: Random) -> None:
        self.ws, self.rng = ws, rng
        self.ws.send(json.dumps({"name": f"client {rng.randrange(100)}"}))
        self.sys: dict[str, Any] = {}
        self.heard = 0.0
        self.trains: list[Any] = []
        self.alarms: list[Any] = []
        self.done: Counter[str] = Counter()
        self.still = self._hear()["still"]
        self.ask(do="speed", times=60)

    def _hear(self) -> dict[str, Any]:
        m: dict[str, Any] = json.loads(self.ws.recv(timeout=20))
        self.heard = m.get("t", self.heard)
        self.sys, self.trains = m.get("sys", self.sys), m.get("trains", self.trains)
        self.alarms = m.get("alarms", self.alarms)
        return m

    def ask(self, **command: Any) -> bool:
        """A command, and whether it was done."""
        self.ws.send(json.dumps({"heard": self.heard, "after": 0, **command, "re": 1}))
        while "re" not in (m := self._hear()):
            pass
        self.done[f"{command['do']}{'' if m['ok'] else ', refused'}"] += 1
        return bool(m["ok"])

    def act(self) -> None:
        """Something."""
        rng, still = self.rng, self.still
        section, machine = rng.choice([*still["sections"]]), rng.choice([*still["machines"]])
        train = rng.choice(self.trains)[0] if self.trains else ""
        if not self.sys.get("power", True):
            self.ask(do="power", on=True)
        elif self.sys.get("restart") and rng.random() < 0.3:
            self.ask(do="release all")
        else:
            match rng.choices(range(12), (30, 6, 4, 3, 3, 6, 12, 6, 5, 3, 0.3, 1))[0]:
                case 0:
                    self.ask(do="set", route=rng.choice(still["routes"])["id"])
                case 1:
                    self.ask(do="cancel", signal=rng.choice([*still["signals"]]))
                case 2:
                    self.ask(do="release", section=section)
                case 3:
                    self.ask(do="block", section=section, on=rng.random() < 0.3)
                case 4:
                    self.ask(do="turn", machine=machine, to=rng.choice("NR"))
                case 5:
                    self.ask(do="acknowledge")
                    self.ask(do="looked", machine=machine)
                case 6 if len(self.trains) < 4:
                    self.ask(do="bring", boundary="W", metres=rng.choice((20, 30, 60)))
                case 7 if train:
                    self.ask(do="turn train", train=train)
                case 8 if train and len(self.trains) > 2:
                    self.ask(do="take away", train=train)
                case 9:
                    kind, name = rng.choice((("section", section), ("machine", machine), ("station", "main")))
                    if self.ask(do="fail", kind=kind, name=name, on=True):
                        self.ask(do="fail", kind=kind, name=name, on=False)
                case 10:
                    self.ask(do="power", on=False)
                case _:
                    self.ask(do="remind", at=f"m:{machine}", text=rng.choice(("", "being oiled")))


def main() -> None:
    """Run it."""
    parser = argparse.ArgumentParser()
    parser.add_argument("-o", "--out", type=Path)
    given = parser.parse_args()
    commit = subprocess.run(["git", "rev-parse", "--short", "HEAD"], capture_output=True, text=True).stdout.strip()
    with browser() as chromium:
        took, _ = changes(chromium)
    text = (
        f"# The panel at work\n\n`python -m tests.campaigns.panel` at commit {commit}, {processor()}, "
        f"{os.cpu_count()} cores, Python {platform.python_version()}.\n\n"
        "- A change in a yard of 1,000 routes, from what a detector reports until Chromium draws it, at cycles of 100 "
        f"ms: median {statistics.median(took):.0f} ms, {max(took):.0f} ms at most ({len(took)} changes).\n"
        "- Hours, kills, and what is lost and comes back: [service](service.md).\n"
    )
    print(text)
    if given.out is not None:
        given.out.write_text(text, "utf-8")


if __name__ == "__main__":
    main()
