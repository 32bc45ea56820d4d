"""The panel for a shift and more: memory, its record under kill -9, and how long a change takes to the page.

    python -m tests.campaigns.panel [--hours N] [--kills N] [--seed N] [-o proofs/panel.md]

`interlock run --panel` runs Heishan at sixty times the speed; a client works it at random: routes, cancellations,
releases, blocks, trains, faults, lost substations, power cuts.  Then the server is killed at random moments with a
signal that it cannot catch, and started again on the same record.
"""

from __future__ import annotations

import argparse
import json
import os
import platform
import signal
import statistics
import subprocess
import sys
import tempfile
import time
from collections import Counter
from pathlib import Path
from random import Random
from typing import Any

from websockets.sync.client import ClientConnection, connect

from interlock.panel.journal import page
from interlock.record import read_file
from tests.campaigns.deadlock import processor
from tests.test_panel_browser import changes

LAYOUT = Path("layouts/heishan.yaml").resolve()


class Server:
    """The command as a process."""

    def __init__(self, record: Path) -> None:
        command = [sys.executable, "-m", "interlock.cli.main", "run", str(LAYOUT), "--panel", "--port", "0"]
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
        self.trains: list[Any] = []
        self.done: Counter[str] = Counter()
        self.still = self._hear()["still"]
        self.ask(do="speed", times=60)

    def _hear(self) -> dict[str, Any]:
        m: dict[str, Any] = json.loads(self.ws.recv(timeout=20))
        self.sys, self.trains = m.get("sys", self.sys), m.get("trains", self.trains)
        return m

    def ask(self, **command: Any) -> bool:
        """A command, and whether it was done."""
        self.ws.send(json.dumps({**command, "re": 1}))
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


def endures(folder: Path, hours: float, rng: Random) -> list[str]:
    """So many simulated hours in one process: its memory, what was done, and its record."""
    record = folder / "endures.log"
    server = Server(record)
    began, seen = time.monotonic(), list[float]()
    with connect(f"ws{server.url}talk", max_size=None) as ws:
        client = Client(ws, rng)
        while (passed := (time.monotonic() - began) * 60 / 3600) < hours:
            client.act()
            if passed > len(seen) * hours / 20:
                seen.append(server.mib())
        seen.append(server.mib())
    code = server.end(signal.SIGINT)
    found = read_file(record)
    if code != 130 or not found.ended:
        raise RuntimeError(f"exit code {code}, record {'closed' if found.ended else 'not closed'}")
    kinds = Counter(e["kind"] for e in found.events)
    text = page(found)
    if f">{kinds['release']}</td>" not in text or f">{kinds['alarm']}</td>" not in text:
        raise RuntimeError("the page of the shift counts otherwise than the record")
    seen_harm = [e["text"] for e in found.events if e.get("text", "").startswith("the bystander sees")]
    minutes, size = (time.monotonic() - began) / 60, record.stat().st_size / 2**20
    accepted = sum(n for k, n in client.done.items() if not k.endswith("refused"))
    return [
        f"{hours:g} simulated hours in {minutes:.0f} minutes; {client.done.total():,} commands, {accepted:,} of them "
        f"for the controller or the railway, the others refused at the desk; harm seen by the bystander: "
        f"{len(seen_harm)}.",
        f"Resident memory: {seen[1]:.1f} MiB after a twentieth of the time, {max(seen):.1f} MiB at most, "
        f"{seen[-1]:.1f} MiB at the end.",
        f"Record: {len(found.events):,} events, {size:.1f} MiB; {kinds['operation']:,} operations, "
        f"{kinds['refusal']:,} refusals, {kinds['release']:,} releases by hand, {kinds['alarm']:,} alarms: "
        "as many on its page.",
        *seen_harm[:5],
    ]


def killed(folder: Path, kills: int, rng: Random) -> list[str]:
    """Killed and started again on one record: whether it is whole, and the count of releases goes on."""
    record, torn, before, told = folder / "killed.log", 0, 0, 0
    for _ in range(kills):
        server = Server(record)
        until = time.monotonic() + rng.uniform(0.2, 4.0)
        with connect(f"ws{server.url}talk", max_size=None) as ws:
            client = Client(ws, rng)
            while time.monotonic() < until:
                client.act()
            server.end(signal.SIGKILL)
        told = client.done["release"] + client.done["release all"]
        found = read_file(record)
        if found.problem is not None:
            raise RuntimeError(f"line {found.problem.line}: {found.problem.text}")
        torn += bool(found.torn)
        releases = sum(e["kind"] == "release" for e in found.events)
        if releases < before + told:
            raise RuntimeError(f"{before + told} releases were told, {releases} are recorded")
        before = releases
    return [
        f"{kills} kills (`SIGKILL`) of a server at work, started again on the same record: it is whole up to its last "
        f"event each time ({torn} times torn within one), and none of {before} releases that clients were "
        "told of is missing."
    ]


def main() -> None:
    """Run it."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--hours", type=float, default=10.0)
    parser.add_argument("--kills", type=int, default=50)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("-o", "--out", type=Path)
    given = parser.parse_args()
    rng = Random(given.seed)
    commit = subprocess.run(["git", "rev-parse", "--short", "HEAD"], capture_output=True, text=True).stdout.strip()
    took = changes()
    drawn = (
        f"A change in a yard of 1,000 routes, from what a detector reports until Chromium draws it, at cycles of 100 "
        f"ms: median {statistics.median(took):.0f} ms, {max(took):.0f} ms at most ({len(took)} changes)."
    )
    with tempfile.TemporaryDirectory() as folder:
        told = [drawn, *killed(Path(folder), given.kills, rng), *endures(Path(folder), given.hours, rng)]
    call = f"python -m tests.campaigns.panel --hours {given.hours:g} --kills {given.kills} --seed {given.seed}"
    text = (
        f"# The panel at work\n\n`{call}` at commit {commit}, {processor()}, {os.cpu_count()} cores, "
        f"Python {platform.python_version()}.\n\n" + "\n".join(f"- {line}" for line in told) + "\n"
    )
    print(text)
    if given.out is not None:
        given.out.write_text(text, "utf-8")


if __name__ == "__main__":
    main()
