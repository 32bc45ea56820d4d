"""`interlock run` as a service: hours with faults, kills, and the loss and return of field, panel and record.

    python -m tests.campaigns.service [--hours N] [--kills N] [--bus N] [--seed N] [-o proofs/service.md]

*Hours*: Heishan on a simulated railway at sixty times the speed; a client works it at random, and now and then its
substation is cut off, the client drops its connection, or the record cannot be written (the process may write no longer
files, `RLIMIT_FSIZE`), each for a while.  *Kills*: the server is killed with SIGKILL at random moments and started
again on the same record.  *Bus*: a mine on two substations over Modbus TCP on the loopback; they die, answer late, and
their heartbeats freeze; a second start on the same outputs is tried; the server is killed and started again.  The
three go on beside each other.
"""

from __future__ import annotations

import argparse
import contextlib
import os
import platform
import resource
import signal
import subprocess
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from random import Random
from typing import Any

from websockets.sync.client import ClientConnection, connect

from interlock.app.run import prepare
from interlock.panel.journal import page
from interlock.record.log import Recorded, read_file
from tests.campaigns.origin import processor
from tests.campaigns.panel import LAYOUT, Client, Server
from tests.field import TWO, Station
from tests.substation import FROZEN, LATE

LOSSES = ("field", "panel", "record")
EVERY_MIN = 12
"""Simulated minutes from one loss to the next."""


class Failed(Exception):
    """What must not be."""


def need(so: bool, what: str) -> None:
    """Something that has to hold."""
    if not so:
        raise Failed(what)


def until(client: Client, so: Callable[[Client], bool], what: str, seconds: float = 30.0) -> None:
    """Listen until something is so."""
    end = time.monotonic() + seconds
    while not so(client):
        need(time.monotonic() < end, f"never {what}")
        client.ask(do="why", route=client.still["routes"][0]["id"])


def valid(client: Client) -> bool:
    """Whether the inputs are."""
    return bool(client.sys["valid"])


def lost(client: Client) -> bool:
    """Whether they are not."""
    return not valid(client)


def unrecorded(client: Client) -> bool:
    """Whether it stands as an alarm that the record cannot be written."""
    return any(a[0] == "record" and a[4] for a in client.alarms)


def recorded(client: Client) -> bool:
    """Whether it does not."""
    return not unrecorded(client)


def tried(client: Client) -> bool:
    """The same as `unrecorded`, after something else was done."""
    client.act()
    return unrecorded(client)


@contextlib.contextmanager
def at_work(server: Server) -> Iterator[ClientConnection]:
    """A connection to a server, which does not outlive a failure."""
    try:
        with connect(f"ws{server.url}talk", max_size=None, ping_interval=None) as ws:
            yield ws
    finally:
        server.process.kill()


class Shift:
    """Ten hours at one panel."""

    def __init__(self, folder: Path, rng: Random) -> None:
        self.record, self.rng = folder / "hours.log", rng
        self.server = Server(self.record)
        self.connection: ClientConnection | None = None
        self.done: Counter[str] = Counter()
        self.losses: Counter[str] = Counter()
        self.memory: list[float] = []
        self.client = self._come()

    def _come(self) -> Client:
        self.connection = connect(f"ws{self.server.url}talk", max_size=None, ping_interval=None)
        client = Client(self.connection, self.rng)
        client.done = self.done
        return client

    def lose(self, what: str) -> None:
        """Something is lost for a while, and comes back."""
        self.losses[what] += 1
        match what:
            case "field":
                self.client.ask(do="power", on=True)
                self.client.ask(do="fail", kind="station", name="main", on=True)
                until(self.client, lost, "not valid without its substation")
                self._work(self.rng.uniform(0.2, 3.0))
                self.client.ask(do="power", on=True)
                self.client.ask(do="fail", kind="station", name="main", on=False)
                until(self.client, valid, "valid with its substation")
            case "panel":
                assert self.connection is not None
                self.connection.socket.close()  # no word of farewell
                time.sleep(self.rng.uniform(0.0, 1.0))
                self.client = self._come()
            case _:
                size = self.record.stat().st_size + self.rng.randrange(5000)
                resource.prlimit(self.server.process.pid, resource.RLIMIT_FSIZE, (size, resource.RLIM_INFINITY))
                until(self.client, tried, "an alarm of the record")
                self._work(self.rng.uniform(0.2, 3.0))
                forever = (resource.RLIM_INFINITY, resource.RLIM_INFINITY)
                resource.prlimit(self.server.process.pid, resource.RLIMIT_FSIZE, forever)
                until(self.client, recorded, "a record again")

    def _work(self, seconds: float) -> None:
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            self.client.act()

    def run(self, hours: float) -> tuple[float, float]:
        """Work for so many simulated hours; those that were, and the minutes on the wall."""
        began, last = time.monotonic(), 0
        while (minutes := self.client.sys.get("minutes", 0)) < hours * 60:
            self.client.act()
            if minutes >= last + EVERY_MIN:
                last = minutes
                self.lose(LOSSES[self.losses.total() % 3])
            if minutes >= len(self.memory) * hours * 60 / 40:
                self.memory.append(self.server.mib())
        self.memory.append(self.server.mib())
        return minutes / 60, (time.monotonic() - began) / 60


def hours(folder: Path, count: float, rng: Random) -> list[str]:
    """So many simulated hours in one process: memory, losses, and what is recorded and printed."""
    shift = Shift(folder, rng)
    try:
        passed, wall = shift.run(count)
        code = shift.server.end(signal.SIGINT)
    finally:
        shift.server.process.kill()
    found = read_file(shift.record)
    need(code == 130 and found.ended, f"exit code {code}, record {'closed' if found.ended else 'not closed'}")
    kinds = Counter(e["kind"] for e in found.events)
    told = shift.done["release"] + shift.done["release all"]
    need(kinds["release"] == told, f"{told} releases were told, {kinds['release']} are recorded")
    gaps = [e["dropped"] for e in found.events if e["kind"] == "gap"]
    need(len(gaps) >= shift.losses["record"] and not any(gaps), f"gaps of the record: {gaps}")
    _printed(found)
    harm = [e["text"] for e in found.events if e.get("text", "").startswith("the bystander sees")]
    m, gone = shift.memory, shift.losses
    return [
        f"{passed:.1f} simulated hours of one process in {wall:.0f} minutes, {shift.done.total():,} commands; "
        f"harm seen by the bystander: {len(harm)}.",
        f"Lost and back: its substation {gone['field']} times, the panel's connection {gone['panel']} times, the room "
        f"for its record {gone['record']} times (events dropped: {sum(gaps)}).",
        f"Resident memory: {m[2]:.1f} MiB after a twentieth of the time, {m[len(m) // 2]:.1f} MiB at half of it, "
        f"{max(m):.1f} MiB at most, {m[-1]:.1f} MiB at the end.",
        f"Record: whole, {len(found.events):,} events, {shift.record.stat().st_size / 2**20:.1f} MiB; "
        f"{kinds['operation']:,} operations, {kinds['refusal']:,} refusals; {kinds['release']:,} releases by hand, as "
        f"many as the client was told of, and {kinds['alarm']:,} alarms: the shift's printed page counts as many.",
        *harm[:5],
    ]


def _printed(found: Recorded) -> None:
    """The page of the shift counts what is recorded."""
    kinds, text = Counter(e["kind"] for e in found.events), page(found)
    need(f">{kinds['release']}</td>" in text and f">{kinds['alarm']}</td>" in text, "the page counts otherwise")


def kills(folder: Path, count: int, rng: Random) -> list[str]:
    """Killed and started again on one record."""
    record, torn, before = folder / "kills.log", 0, 0
    for _ in range(count):
        server = Server(record)
        end = time.monotonic() + rng.uniform(0.1, 8.0)
        with at_work(server) as ws:
            client = Client(ws, rng)
            while time.monotonic() < end:
                client.act()
            server.end(signal.SIGKILL)
        told = client.done["release"] + client.done["release all"]
        before, torn = _whole(record, before, told, torn)
    _printed(read_file(record))
    return [
        f"{count} kills (`SIGKILL`) at random moments, each time started again on the same record: it is whole up to "
        f"its last event each time ({torn} times torn within one), and none of {before} releases by hand that clients "
        "were told of is missing."
    ]


def _whole(record: Path, before: int, told: int, torn: int) -> tuple[int, int]:
    found = read_file(record)
    need(found.problem is None, f"the record is damaged: {found.problem}")
    releases = sum(e["kind"] == "release" for e in found.events)
    need(releases >= before + told, f"{before + told} releases were told, {releases} are recorded")
    return releases, torn + bool(found.torn)


class OnTheBus(Server):
    """The panel on two substations."""

    def __init__(self, layout: Path, record: Path, stations: list[Station]) -> None:
        self.links = [x for s in stations for x in ("--modbus", f"{s.name}=127.0.0.1:{s.port}")]
        self.layout = layout
        super().__init__(record, layout, self.links)

    def second(self) -> int:
        """The exit code of a second start on the same outputs."""
        command = [sys.executable, "-m", "interlock", "run", str(self.layout), *self.links, "--cycles", "1"]
        return subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=120).returncode


class Lasting(Station):
    """A substation for all of it."""

    lives_s = 7200


def ill(s: Station, how: str, on: bool) -> None:
    """A substation falls ill, or is well again."""
    match how:
        case "stands still":
            os.kill(s.process.pid, signal.SIGSTOP if on else signal.SIGCONT)
        case "dies":
            s.kill() if on else s.start()
        case "answers late":
            s.wire(LATE, int(on))
        case _:
            s.wire(FROZEN, int(on))


def bus(folder: Path, count: int, rng: Random) -> list[str]:
    """So many lives on two substations over Modbus TCP."""
    layout = folder / "mine.yaml"
    layout.write_text(Path("layouts/mine11.yaml").read_text("utf-8") + TWO, "utf-8")
    ready = prepare(str(layout))
    stations = [Lasting(ready, "west"), Lasting(ready, "east")]
    record, torn, before, refused, done = folder / "bus.log", 0, 0, 0, Counter[str]()
    try:
        for k in range(count):
            server = OnTheBus(layout, record, stations)
            if k % 5 == 0:
                need(server.second() == 2, "a second start on the same outputs was not refused")
                refused += 1
            with at_work(server) as ws:
                client = Client(ws, rng)
                until(client, valid, "valid")
                for how in rng.sample(("stands still", "dies", "answers late", "freezes"), 2):
                    s = rng.choice(stations)
                    ill(s, how, True)
                    until(client, lost, f"not valid while one {how}")
                    time.sleep(rng.uniform(0.0, 0.5))
                    ill(s, how, False)
                    until(client, valid, f"valid after one {how}")
                    done[how] += 1
                for _ in range(rng.randrange(60)):
                    client.act()
                server.end(signal.SIGKILL if k < count - 1 else signal.SIGINT)
            told = client.done["release"] + client.done["release all"]
            before, torn = _whole(record, before, told, torn)
        found = read_file(record)
        need(found.ended and stations[0].lamp("YS_X7") and not stations[0].lamp("YP_X7"), "not restrictive at the end")
    finally:
        for s in stations:
            s.kill()
    _printed(found)
    alarms = sum(e["kind"] == "alarm" and e["text"].startswith("substation ") for e in found.events)
    return [
        f"{count} lives on two substations over Modbus TCP, {count - 1} of them ended by SIGKILL: a substation "
        + ", ".join(f"{how} {n} times" for how, n in sorted(done.items()))
        + f" and was back each time ({alarms} alarms of a substation); {refused} second starts on the same outputs, "
        "all refused; the record is whole, and at the end every output is restrictive.",
    ]


def _told(part: Callable[[Path, Any, Random], list[str]], folder: Path, count: float, seed: str) -> list[str]:
    """A part, and what it says when it has ended."""
    lines = part(folder, count, Random(seed))
    print(*lines, sep="\n", flush=True)
    return lines


def main() -> None:
    """Run it."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--hours", type=float, default=10.0)
    parser.add_argument("--kills", type=int, default=50)
    parser.add_argument("--bus", type=int, default=25)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("-o", "--out", type=Path)
    given = parser.parse_args()
    began = time.monotonic()
    commit = subprocess.run(["git", "rev-parse", "--short", "HEAD"], capture_output=True, text=True).stdout.strip()
    parts = ((hours, given.hours), (kills, given.kills), (bus, given.bus))
    with tempfile.TemporaryDirectory() as folder, ThreadPoolExecutor(3) as beside:
        found = [beside.submit(_told, part, Path(folder), n, f"{given.seed} {part.__name__}") for part, n in parts]
        told = [line for part in found for line in part.result()]
    call = f"--hours {given.hours:g} --kills {given.kills} --bus {given.bus} --seed {given.seed}"
    text = (
        f"# Service for days\n\n`python -m tests.campaigns.service {call}` at commit {commit}, {processor()}, "
        f"{os.cpu_count()} cores, Python {platform.python_version()}; {LAYOUT.stem}, "
        f"{(time.monotonic() - began) / 60:.0f} minutes in all.\n\n" + "\n".join(f"- {line}" for line in told) + "\n"
    )
    print(text)
    if given.out is not None:
        given.out.write_text(text, "utf-8")


if __name__ == "__main__":
    main()
