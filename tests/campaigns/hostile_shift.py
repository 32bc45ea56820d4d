"""A hostile dispatcher on the emitted runtime: whatever is asked for, taken back or released, no train is harmed.

    python -m tests.campaigns.hostile_shift [--scans N] [--moves N] [-j N] [-o proofs/hostile_shift.md] [LAYOUT ...]

Trains come in at every boundary as soon as there is room, run wherever a signal lets them, change ends where they can,
and go; those that stand for too long are taken away.  Every second or so the dispatcher asks for some route, mostly for
one on whose signal a train waits, and cancels, releases by hand, blocks, moves points and confirms at random.  A move
is a signal passed at proceed.
"""

from __future__ import annotations

import argparse
import os
import platform
import subprocess
import sys
import time
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, field
from functools import lru_cache, partial
from pathlib import Path
from random import Random
from textwrap import wrap

from interlock.simulate.agenda import Agenda
from interlock.simulate.driving import Build, Rolling
from interlock.simulate.motion import Motion
from interlock.simulate.run import load
from interlock.simulate.scans import Scans
from interlock.simulate.track import NONE, Track
from interlock.simulate.yard import Yard
from tests.campaigns.origin import processor
from tests.campaigns.simulate import Case

CYCLE_MS = 500
LAYOUTS = ("mine11", "heishan", "pit_bottom", "fig2_1", "two_loops", "junction")
MOST = 8
"""Trains at once."""
AT_ONCE = 1000
"""More things at one millisecond than ever happen while time goes on."""


@dataclass
class Found:
    """What a run showed."""

    scans: int = 0
    moves: int = 0
    trains: int = 0
    hazards: list[str] = field(default_factory=list)


FIGURES = ("scans", "moves", "trains")


class Hostile:
    """A railway with trains that run as they may, and a dispatcher who wants an accident."""

    def __init__(self, case: Case, seed: int) -> None:
        self.case, self.rng, self.agenda = case, Random(f"hostile {seed}"), Agenda()
        names = load(case.runtime)
        self.scans, self.inputs = Scans(names, CYCLE_MS), names["INPUTS"]
        self.track = Track.of(case.layout)
        self.yard = Yard(self.track, self.scans.inputs, self.agenda, Random(f"yard {seed}"), lambda kind, **f: None)
        self.yard.driving.stopped = self._stopped
        self.ways_in = [b.name for b in self.track.beyond if b.comes != NONE]
        self.trains = 0
        self.operator = [n for n in self.inputs if n.startswith(("CAN_", "REL_", "BLK_", "MN_", "MR_", "TC_", "AUTO_"))]

    def run(self, scans: int) -> Found:
        """So many scans from the restart on, or until harm is done."""
        self.yard.inputs.write("RELALL", 1)
        self.agenda.after(1.0, self._acts)
        self.agenda.after(2.0, self._comes)
        at_once = 0
        while self.scans.runs < scans and not self.yard.watch.found and not self.yard.driving.passed_at_stop:
            event, due = self.agenda.next_ms(), self.scans.due(self.yard.inputs.changed_ms)
            now = min(t for t in (event, due) if t is not None)
            at_once = at_once + 1 if now == self.agenda.now_ms else 0
            if at_once > AT_ONCE:
                raise RuntimeError(f"time does not go on after {now} ms")
            self.agenda.now_ms = now
            if event == now:
                self.agenda.step()
                continue
            self.yard.inputs.changed_ms = None
            if self.scans.scan(now):
                self.yard.shown(self.scans.outputs)
        harm = [*self.yard.watch.found, *self.yard.driving.passed_at_stop]
        return Found(self.scans.runs, self.yard.driving.movements, self.trains, harm)

    # --- trains ------------------------------------------------------------------------------------

    def _comes(self) -> None:
        self.agenda.after(self.rng.uniform(5, 40), self._comes)
        at = self.rng.choice(self.ways_in)
        if len(self.yard.trains) < MOST and self.yard.room(at):
            self.trains += 1
            rng = self.rng
            build = Build(rng.choice((15.0, 40.0, 60.0)), rng.uniform(2, 9), rng.uniform(0.2, 0.6), 0.8, 2.0)
            self.yard.comes(str(self.trains), build, at)

    def _stopped(self, r: Rolling) -> None:
        self.agenda.after(self.rng.uniform(5, 60), partial(self._turns, r))
        self.agenda.after(self.rng.uniform(60, 400), partial(self._patience, r, r.motion))

    def _patience(self, r: Rolling, stood: Motion) -> None:
        """It still stands where it stood: it is moved under local rules."""
        if r.name in self.yard.rolling and r.motion is stood and not r.accepted:
            self.yard.taken_away(r)

    def _turns(self, r: Rolling) -> None:
        """It changes ends where it stands wholly in one section, at the end of which a signal governs its new way."""
        t, s = r.train, self.track.stretches
        if r.name not in self.yard.rolling or r.motion.stands > self.yard.clock or len(t.under.sections) != 1:
            return
        self.agenda.after(self.rng.uniform(30, 120), partial(self._turns, r))
        if any(s[d].outside for d in t.body) or r.accepted or (t.view.target != NONE and self.rng.random() < 0.7):
            return
        d = t.body[0] ^ 1
        for _ in range(50):
            on = self.yard.sight.follows(s[d])
            if on == NONE or s[on].section != s[d].section:
                break
            d = on
        else:
            return
        if on != NONE and s[on].signal != NONE:
            self.yard.driving.turns(r)

    # --- the dispatcher ----------------------------------------------------------------------------

    def _acts(self) -> None:
        rng, write = self.rng, self.yard.inputs.write
        self.agenda.after(rng.choice((0.5, 1.0, 1.5)), self._acts)
        if self.scans.inputs["REQ"]:
            write("REQ", 0)
        else:
            write("REQ", self._wish())
        write("RELALL", int(rng.random() < 0.7))
        if self.operator and rng.random() < 0.15:
            name = rng.choice(self.operator)
            write(name, 1)
            seconds = rng.choice((0.5, 5.0, 70.0, 200.0) if name.startswith("REL_") else (0.5, 1.0, 3.0))
            self.agenda.after(seconds, partial(write, name, 0))

    def _wish(self) -> int:
        rng = self.rng
        waiting = [t.view.target for t in self.yard.trains if t.view.target != NONE]
        if waiting and rng.random() < 0.8:
            numbers = self.case.routes.get(self.track.signals[rng.choice(waiting)], ())
            if numbers:
                return rng.choice(numbers)
        return rng.randrange(self.inputs["REQ"][1])


@lru_cache
def case_of(path: str, weakening: str = "") -> Case:
    """A layout with its runtime, weakened or not."""
    return Case.of(path, weakening)


def drive(path: str, seed: int, scans: int) -> Found:
    """A run on a layout as shipped."""
    return Hostile(case_of(path), seed).run(scans)


def path_of(name: str) -> str:
    """Where a layout lies."""
    shipped = Path(f"layouts/{name}.yaml")
    return str(shipped if shipped.exists() else Path(f"tests/layouts_for_tests/{name}.yaml"))


def _short(total: dict[str, Found], scans: int, moves: int) -> bool:
    """There were fewer scans, or fewer moves."""
    found = total.values()
    return sum(f.scans for f in found) < scans or sum(f.moves for f in found) < moves


def page(total: dict[str, Found], made: str) -> str:
    """The page: how it was made, and what each layout showed."""
    rows = {**total, "**all**": Found(*(sum(getattr(f, k) for f in total.values()) for k in FIGURES))}
    harm = [f"{n}: {h}" for n, f in total.items() for h in f.hazards]
    counts = [str(len(f.hazards)) for f in total.values()] + [f"**{len(harm)}**"]
    lines = [
        "# A hostile dispatcher",
        "",
        *wrap(made, 120, break_long_words=False, break_on_hyphens=False),
        "",
        "Fleets on the emitted runtimes; routes asked for, cancelled, released by hand, blocked, points moved by hand",
        "and confirmed at random, every second or so.  Only scans that can change something are run, and counted.",
        "*Moves*: signals passed at proceed.  *Harm*: `interlock/simulate/hazards.py`, and signals passed at stop.",
        "",
        "| layout | scans | trains | moves | harm |",
        "|---|---:|---:|---:|---:|",
    ]
    for (name, f), count in zip(rows.items(), counts, strict=True):
        lines.append(f"| {name} | {f.scans:,} | {f.trains:,} | {f.moves:,} | {count} |")
    return "\n".join([*lines, "", *(f"- {h}" for h in harm)])


def main() -> int:
    """Write the page after each seed; 1 when harm was done."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("layouts", nargs="*", default=LAYOUTS)
    parser.add_argument("--scans", type=int, default=1_000_000)
    parser.add_argument("--moves", type=int, default=20_000)
    parser.add_argument("-j", "--jobs", type=int, default=2)
    parser.add_argument("-o", "--output", type=Path, default=Path("proofs/hostile_shift.md"))
    options = parser.parse_args()
    commit = subprocess.run(["git", "rev-parse", "--short", "HEAD"], capture_output=True, text=True, check=True)
    began, total, seed = time.monotonic(), {n: Found() for n in options.layouts}, 0
    text = ""
    with ProcessPoolExecutor(options.jobs) as pool:
        while _short(total, options.scans, options.moves):
            work = {n: pool.submit(drive, path_of(n), seed, 20_000) for n in options.layouts}
            for n, future in work.items():
                found, f = future.result(), total[n]
                f.scans, f.moves, f.trains = f.scans + found.scans, f.moves + found.moves, f.trains + found.trains
                f.hazards += [f"seed {seed}: {h}" for h in found.hazards]
            seed += 1
            made = (
                f"`python -m tests.campaigns.hostile_shift --scans {options.scans} --moves {options.moves} "
                f"-j {options.jobs}` at commit {commit.stdout.strip()}, {processor()}, {os.cpu_count()} cores, Python "
                f"{platform.python_version()}; seeds 0 to {seed - 1}, {(time.monotonic() - began) / 60:.0f} minutes"
                f"{', not at its end yet' if _short(total, options.scans, options.moves) else ''}."
            )
            text = page(total, made)
            options.output.write_text(text, encoding="utf-8")
    print(text)
    return 1 if any(f.hazards for f in total.values()) else 0


if __name__ == "__main__":
    sys.exit(main())
