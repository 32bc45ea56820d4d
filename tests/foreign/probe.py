"""What a compiler must do before anything that it compiles counts: a loop from n to n runs once; a timer is a TON.

The emitted text has no loops; a compiler that runs such a loop no times reads the language wrongly all the same, and
beremiz' MATIEC of 2024 does.  The same program tries the wires, and a TON after a pause in which it did not run.
"""

from __future__ import annotations

import tempfile
from pathlib import Path

from interlock.logic.cabinet import Channel
from interlock.st.ast import Task
from tests.foreign.compilers import Compiler, answers
from tests.foreign.wiring import Segment, Wiring, differences

PROBE = """\
FUNCTION_BLOCK IL_PROBE_LOOP
VAR_INPUT
  N : INT;
END_VAR
VAR_OUTPUT
  ONCE : BOOL;
  TWICE : BOOL;
END_VAR
VAR
  K : INT;
  TURNS : INT;
END_VAR
  TURNS := 0;
  FOR K := N TO N DO
    TURNS := TURNS + 1;
  END_FOR;
  ONCE := TURNS = 1;
  TURNS := 0;
  FOR K := N TO N + 1 DO
    TURNS := TURNS + 1;
  END_FOR;
  TWICE := TURNS = 2;
END_FUNCTION_BLOCK

PROGRAM IL_PROBE_IO
VAR
  GO AT %IX1.3 : BOOL;
  SHOWN AT %QX0.6 : BOOL;
  DUE AT %QX2.1 : BOOL;
END_VAR
VAR
  N : INT := 0;
  ONCE : BOOL;
  TWICE : BOOL;
  LOOP : IL_PROBE_LOOP;
  WAIT : TON;
END_VAR
  LOOP(N := N);
  ONCE := LOOP.ONCE;
  TWICE := LOOP.TWICE;
  WAIT(IN := GO, PT := T#1s);
  DUE := WAIT.Q;
  SHOWN := GO;
END_PROGRAM

CONFIGURATION IL_PROBE_CONF
  RESOURCE IL_PROBE_RES ON PLC
    TASK IL_PROBE_TASK(INTERVAL := T#100ms, PRIORITY := 0);
    PROGRAM IL_PROBE_MAIN WITH IL_PROBE_TASK : IL_PROBE_IO;
  END_RESOURCE
END_CONFIGURATION
"""
WIRING = Wiring(
    Task("IL_PROBE_CONF", "IL_PROBE_RES", "IL_PROBE_TASK", 100, "IL_PROBE_MAIN", "IL_PROBE_IO"),
    (
        Channel("GO", "I", "main", "", "", 0, 1, 3),
        Channel("SHOWN", "Q", "main", "", "", 0, 0, 6),
        Channel("DUE", "Q", "main", "", "", 0, 2, 1),
    ),
    (("N", "INT"),),
    ("ONCE", "TWICE"),
)
SCANS = (
    # n, the timer's input, milliseconds since the scan before, whether the timer is due
    (0, 0, 100, 0),
    (1, 0, 5000, 0),
    (2, 1, 3000, 0),
    (-1, 1, 999, 0),
    (7, 1, 1, 1),
    (-300, 1, 100, 1),
    (300, 0, 100, 0),
    (1, 1, 1500, 0),
    (4, 1, 1000, 1),
)


def _expected() -> Segment:
    told = Segment(86_400_000)
    for n, go, dt_ms, due in SCANS:
        told.given += WIRING.given({"N": n, "GO": go}, dt_ms)
        told.told += WIRING.told({"ONCE": 1, "TWICE": 1, "SHOWN": go, "DUE": due})
        told.scans += 1
    return told


def unfit(compiler: Compiler) -> str:
    """What this compiler makes of the probe otherwise than it should; nothing when it passes.  Raises `Refused`."""
    expected = _expected()
    with tempfile.TemporaryDirectory() as folder:
        program = compiler.build(PROBE, WIRING, Path(folder))
        found = differences(WIRING, [expected], answers(program, [expected]))
    return "" if not found else f"{found[0]} ({len(found)} of {len(SCANS)} scans)"
