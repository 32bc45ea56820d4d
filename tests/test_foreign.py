"""The campaign with foreign compilers, without one: what it records, what it compares, and what it would notice.

Here the text with its mapping program is run by our own interpreter in the compilers' stead.
"""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Callable
from dataclasses import replace
from functools import cache
from pathlib import Path

import pytest

from interlock.st.ast import Unit
from interlock.st.meaning import Execution, Numbers
from interlock.st.parser import parse_unit
from interlock.st.program import io_task, joined, parted
from interlock.st.structures import plain
from tests.campaigns.foreign import IN_C, MOVEMENTS, CRow, Row, Verdict, still
from tests.foreign.bundle import Bundle, bundle
from tests.foreign.planted import TEXTS, early_timer
from tests.foreign.recording import Recording, harsh_faults, record, scramble
from tests.foreign.wiring import Segment, changed, differences, digest

SCANS = 2600
SEEDS = range(1, 7)
"""A fault must be noticed with one of these; mostly it is with the first."""


@cache
def made() -> Bundle:
    return bundle("layouts/fig2_2.yaml")


@cache
def recorded(seed: int = 1) -> Recording:
    """Trains, stalls and power cuts."""
    return record(made().railway, SCANS, seed, [(False, True)])


@cache
def scrambled(seed: int = 1) -> Recording:
    """Inputs at random."""
    return scramble(made().railway, 1500, seed)


def interpreted(source: str, recording: Recording) -> list[bytes]:
    """What our reading of a text answers to a recording."""
    unit, wiring, found = _unit(source), recording.wiring, []
    for s in recording.segments:
        numbers = Numbers()
        run: Execution[int] = Execution(unit, numbers)
        cells, answer = run.main.values, bytearray()
        size = len(s.given) // s.scans
        for at in range(0, len(s.given), size):
            scan = bytes(s.given[at : at + size])
            numbers.dt_ms = int.from_bytes(scan[:4], "little")
            for c in wiring.wires:
                if c.direction == "I":
                    cells[c.variable] = scan[4 + c.byte] >> c.bit & 1
            for k, (name, _) in enumerate(wiring.written):
                first = 4 + wiring.image_i + 2 * k
                cells[name] = int.from_bytes(scan[first : first + 2], "little", signed=True)
            run.scan({})
            answer += _told(unit, recording, cells)
        found.append(bytes(answer))
    return found


def _unit(source: str) -> Unit:
    core, mapping = parted(plain(parse_unit(source)))
    return joined(core, mapping)


def _told(unit: Unit, recording: Recording, cells: dict[str, int]) -> bytes:
    """The outputs by the addresses of the text, which need not be those of the recording."""
    image = bytearray(recording.wiring.image_q)
    for d in unit.blocks[-1].locals:
        if d.address is not None and d.address.startswith("%QX") and cells[d.name]:
            byte, _, bit = d.address.removeprefix("%QX").partition(".")
            image[int(byte)] |= 1 << int(bit)
    words = b"".join(cells[n].to_bytes(2, "little") for n in recording.wiring.words)
    return bytes(image) + bytes(int(cells[n]) for n in recording.wiring.read) + words


def test_the_text_with_its_mapping_program_answers_as_was_recorded() -> None:
    r = next(x for x in map(recorded, SEEDS) if x.power_cuts and x.movements)
    assert r.scans == SCANS and r.invalid > r.stalls > 10
    assert len(r.segments) == 1 + r.power_cuts
    assert changed(r.wiring, r.segments) > r.wiring.outputs // 2
    for x in (r, scrambled()):
        assert differences(x.wiring, x.segments, interpreted(made().source, x)) == []


def test_a_layout_whose_name_is_shortened_for_the_plc_comes_whole(tmp_path: Path) -> None:
    """Its texts were looked for under the layout's own name: the compiler got none, and made no configuration."""
    path = tmp_path / "long.yaml"
    path.write_text(Path("layouts/fig2_2.yaml").read_text("utf-8").replace("fig2_2", "overlap_past_signals"), "utf-8")
    found, task = bundle(str(path)), "IL_overlap_p_q4zj_CONF"
    assert f"CONFIGURATION {task}" in found.source and io_task(found.railway.controller).configuration == task
    assert "FUNCTION_BLOCK IL_overlap_p_q4zj\n" in found.source and len(found.xml) == 2


def test_a_recording_in_which_little_moves_goes_on_with_other_trains() -> None:
    """What is shorter than a restart has no movement, however often a route is asked for."""
    calm, scans = [(False, False)], 2600
    short = record(made().railway, 500, 1, calm)
    once = record(made().railway, scans, 1, calm)
    more = record(made().railway, scans, 1, calm, once.movements + 1)
    assert short.movements == 0 and short.scans == 500
    assert more.movements > once.movements and more.scans in range(2 * scans, 9 * scans, scans)
    assert more.segments[0] == once.segments[0]
    cut = record(made().railway, 400, 3, [(False, True)], power_cuts=1)
    assert cut.power_cuts and cut.scans in range(800, 3600, 400)


def test_power_cuts_leave_trains_the_time_to_run() -> None:
    """At a fixed rate nearly no life of a mine, where the restart delay is ten minutes, came to its end."""
    railway = made().railway
    for delay in (180.0, 600.0):
        rules = replace(railway.layout.principles, restart_delay_s=delay)
        faults = harsh_faults(replace(railway, layout=replace(railway.layout, principles=rules)))
        assert 0.3 < faults.power * delay < 0.7


def test_a_layout_in_which_too_little_happened_is_told() -> None:
    def row(movements: int, power_cuts: int = 1) -> Row:
        return Row("yard", 304, (1500, 50, movements, 375, 22, power_cuts), "", 0, "", (Verdict(0),), ())

    def in_c(movements: int) -> CRow:
        return CRow("yard", (1500, movements, 1500, 1, 1), Verdict(0))

    assert still([row(MOVEMENTS)], [in_c(IN_C)]) == []
    assert still([row(2)], [in_c(0)]) == ["yard (2)", "yard in C (0)"]
    assert still([row(MOVEMENTS, 0)], []) == ["yard (0 power cuts)"]


@pytest.mark.parametrize("what", TEXTS)
def test_a_fault_in_the_text_is_noticed(what: str) -> None:
    edit: Callable[[str], str] = TEXTS[what]
    wrong = edit(made().source)
    assert wrong != made().source
    tried = (recording(seed) for seed in SEEDS for recording in (scrambled, recorded))
    assert any(differences(r.wiring, r.segments, interpreted(wrong, r)) for r in tried)


def test_a_runtime_that_counts_time_too_early_is_noticed() -> None:
    wrong = replace(made().railway, runtime=early_timer(made().railway.runtime))
    tried = (record(wrong, SCANS, seed, [(False, True)]) for seed in SEEDS)
    assert any(differences(r.wiring, r.segments, interpreted(made().source, r)) for r in tried)


def test_one_bit_more_is_told_by_scan_output_and_address() -> None:
    r = recorded()
    answers = [bytes(s.told) for s in r.segments]
    assert differences(r.wiring, r.segments, answers) == []
    wire = next(c for c in r.wiring.wires if c.direction == "Q" and c.variable == "YP_X2")
    told = bytearray(answers[0])
    told[7 * r.wiring.length + wire.byte] ^= 1 << wire.bit
    told[9 * r.wiring.length + r.wiring.image_q + r.wiring.read.index("YL_DP")] ^= 1
    told[12 * r.wiring.length - 1] ^= 1
    first, second, third = differences(r.wiring, r.segments, [bytes(told), *answers[1:]])
    assert str(first) == f"power-on 1, scan 8: YP_X2 at {wire.located}"
    assert (second.segment, second.scan, second.outputs) == (1, 10, ("YL_DP",))
    assert (third.segment, third.scan, third.outputs) == (1, 12, (r.wiring.words[-1],))
    with pytest.raises(ValueError, match="bytes, not"):
        differences(r.wiring, r.segments, [answers[0][:-1], *answers[1:]])


def test_a_digest_changes_with_every_byte_and_with_the_clock() -> None:
    s = recorded().segments[0]
    seen = {digest([s]), digest([s, s]), digest([replace(s, start_ms=s.start_ms + 1)])}
    for part in ("given", "told"):
        other = bytearray(getattr(s, part))
        other[len(other) // 2] ^= 1
        seen.add(digest([replace(s, **{part: other})]))
    assert len(seen) == 5
    assert digest([Segment(0)]) != digest([])


def test_a_recording_is_the_same_in_every_process() -> None:
    code = (
        "from tests.foreign.bundle import bundle; from tests.foreign.recording import record;"
        "from tests.foreign.wiring import digest;"
        "print(digest(record(bundle('layouts/fig2_2.yaml').railway, 1200, 5).segments))"
    )
    found = {
        subprocess.run(
            [sys.executable, "-c", code],
            env={**os.environ, "PYTHONHASHSEED": seed},
            capture_output=True,
            text=True,
            check=True,
        ).stdout
        for seed in ("1", "77")
    }
    assert found == {digest(record(made().railway, 1200, 5).segments) + "\n"}
    assert digest(record(made().railway, 1200, 6).segments) + "\n" not in found
