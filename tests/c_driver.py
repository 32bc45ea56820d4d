"""The C runtime compiled by gcc, fed scan by scan through its tables of names, beside the Python runtime."""

from __future__ import annotations

import re
import struct
import subprocess
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from random import Random
from typing import Any

from interlock.emit.c99.runtime import fixed
from interlock.emit.python.runtime import runtime_py
from interlock.logic.controller import Controller
from interlock.model.layout import Layout
from interlock.simulate.faults import Faults
from interlock.simulate.run import Life, Outcome, load
from interlock.simulate.track import Track
from interlock.table.rows import InterlockingTable

WARNINGS = (
    *("-pedantic", "-Wall", "-Wextra", "-Werror", "-Wconversion", "-Wshadow", "-Wstrict-prototypes"),
    *("-Wmissing-prototypes", "-Wundef", "-Wcast-qual"),
)
RESTART, SCAN = b"\0", b"\1"
HARSH = Faults(inputs=0.01, stall=0.02, power=0.002)
STRAY = (2, 3, 0x7F, 0x80, 0xFE, 0xFF)
"""Bytes that are neither 0 nor 1."""
VALID = "VALID"


def edited(files: Mapping[str, str], old: str, new: str | Callable[[re.Match[str]], str]) -> list[dict[str, str]]:
    """All files with one edit in one of them, for each in which the pattern is found; at least one."""
    changed = [{**files, n: re.sub(old, new, t, count=1)} for n, t in files.items()]
    found = [x for x in changed if x != files]
    assert found, old
    return found


_DRIVER = """\
#include <stdio.h>
#include "{name}.h"

#define COUNT(table) (sizeof(table) / sizeof((table)[0]))

int main(void)
{{
  int kind = 0;
  while ((kind = getchar()) != EOF)
  {{
    size_t i = 0u;
    uint32_t ms = 0u;
    if (kind == 0)
    {{
      {p}_init();
      continue;
    }}
    for (i = 0u; i < 4u; i++)
    {{
      ms |= (uint32_t)getchar() << (8u * i);
    }}
    for (i = 0u; i < COUNT({p}_input_bits); i++)
    {{
      *{p}_input_bits[i].bit = (uint8_t)getchar();
    }}
    for (i = 0u; i < COUNT({p}_input_numbers); i++)
    {{
      int low = getchar();
      *{p}_input_numbers[i].number = (int16_t)(low + 256 * getchar());
    }}
    {p}_scan(ms);
    for (i = 0u; i < COUNT({p}_output_bits); i++)
    {{
      putchar(*{p}_output_bits[i].bit ? 1 : 0);
    }}
    for (i = 0u; i < COUNT({p}_state_bits); i++)
    {{
      putchar(*{p}_state_bits[i].bit ? 1 : 0);
    }}
    for (i = 0u; i < COUNT({p}_routes); i++)
    {{
      putchar(*{p}_routes[i].word % 256);
      putchar(*{p}_routes[i].word / 256);
    }}
  }}
  return 0;
}}
"""


class Pair:
    """Stands where the Python runtime stands: writes down what it is given, and what it answers and keeps.

    stray: of so many inputs, as a share, another byte, or number, is read than anybody means; of a byte the Python
    runtime is told that its inputs are not valid, as the C runtime finds by itself.
    """

    def __init__(self, controller: Controller, stray: float = 0.0) -> None:
        self.controller = controller
        self.stray, self.rng = stray, Random(1)
        self.names = load(runtime_py(controller, []))
        self.cycle_max_ms = self.names["Controller"].cycle_max_ms
        self.given, self.told = bytearray(), bytearray()
        self.scans = self.stalls = self.restarts = 0

    def __call__(self) -> Pair:
        """Power-on."""
        self.given += RESTART
        self.restarts += 1
        self.one: Any = self.names["Controller"]()
        return self

    def scan(self, inputs: Mapping[str, int], dt_ms: int) -> Mapping[str, bool]:
        """One scan."""
        c, rng = self.controller, self.rng
        for i in c.inputs:
            if rng.random() < self.stray:
                inputs = {**inputs, i.name: rng.randrange(-(2**15), 2**15) if i.size else rng.choice(STRAY)}
        strays = any(inputs[i.name] in STRAY for i in c.inputs if not i.size)
        outputs: Mapping[str, bool] = self.one.scan({**inputs, VALID: 0} if strays else inputs, dt_ms)
        self.given += SCAN + struct.pack("<I", dt_ms)
        self.given += bytes(int(inputs[i.name]) for i in c.inputs if not i.size)
        self.given += b"".join(struct.pack("<h", inputs[i.name]) for i in c.inputs if i.size)
        self.told += bytes(outputs[o.name] for o in c.outputs) + bytes(self.one.state[s.name] for s in c.state)
        words = self.one.words()
        self.told += b"".join(struct.pack("<h", words[number]) for number in self.names["ROUTES"].values())
        self.scans += 1
        self.stalls += dt_ms > self.cycle_max_ms
        return outputs


def driven(
    layout: Layout,
    table: InterlockingTable,
    controller: Controller,
    scans: int,
    seed: int,
    movements: int = 0,
    stray: float = 0.0,
) -> tuple[Pair, int]:
    """Trains in metres for so many scans, with stalled cycles, lost inputs and power cuts; as often again, without
    power cuts, as so many movements need, ten times at most; then so many scans with inputs at random.  Told are what
    was recorded, and how many movements there were."""
    pair, total = Pair(controller, stray), Outcome()
    routes: dict[str, tuple[int, ...]] = {}
    for r in table.routes:
        routes[str(r.entry)] = (*routes.get(str(r.entry), ()), r.number)
    names = {**pair.names, "Controller": pair}
    track, calm = Track.of(layout), replace(HARSH, power=0.0, stall=0.002)
    Life(layout, track, names, Random(seed), False, routes, HARSH).run(scans, total, lambda _: False, None)
    for n in range(10):
        if total.movements >= movements:
            break
        Life(layout, track, names, Random(f"{seed} {n}"), False, routes, calm).run(scans, total, lambda _: False, None)
    rng, longest, one = Random(seed), pair.cycle_max_ms, pair()
    for _ in range(scans):
        inputs = {i.name: rng.randrange(i.size) if i.size else int(rng.random() < 0.8) for i in controller.inputs}
        one.scan(inputs, rng.choice((0, 100, 400, longest, longest + 1, 5 * longest)))
    return pair, total.movements


def built_by_gcc(
    controller: Controller,
    files: Mapping[str, str],
    folder: Path,
    warnings: Sequence[str] = WARNINGS,
    optimised: str = "-O1",
) -> Path:
    """The program that a test can feed; raises CalledProcessError at any warning."""
    p = fixed(controller).prefix
    name = p.removeprefix("IL_")
    for file, text in {**files, "driver.c": _DRIVER.format(p=p, name=name)}.items():
        (folder / file).write_text(text)
    program = folder / "driver"
    command = [
        "gcc",
        "-std=c99",
        *warnings,
        optimised,
        "-o",
        str(program),
        str(folder / f"{name}.c"),
        str(folder / "driver.c"),
    ]
    subprocess.run(command, check=True, capture_output=True, timeout=300)
    return program


def answers(program: Path, given: bytes) -> bytes:
    """Outputs, state and the words of routes after each scan."""
    return subprocess.run([str(program)], input=given, capture_output=True, check=True, timeout=300).stdout
