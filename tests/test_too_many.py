"""Layouts with more ways than anybody can list are refused at once: sixty loops in a row have 2^60 of them."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from interlock.audit import audit
from interlock.derivation import derive
from interlock.diag import Diagnostic, Sink
from interlock.frontend import load_text
from tests.layouts import grown


def loops(number: int, between: str = "", more: str = "", one_section: bool = False) -> str:
    """So many loops in a row, a main signal at each end; `between`: what a signal each way is that stands behind every
    loop, if one does."""
    tracks, points, signals = ["a: [W, A 200, B 100]"], [], ["S1: {from: W, into: A}", "S3: {from: A, into: B}"]
    before = "a.end"
    for i in range(1, number + 1):
        there, back, normal, reverse, middle = (["X"] * 5) if one_section else [f"{x}{i}" for x in "DENRM"]
        tracks += [f"n{i}: [{normal} 200]", f"r{i}: [{reverse} 200]"]
        legs = f"normal: n{i}.%s, reverse: r{i}.%s, legs: 50}}"
        points.append(f"P{i}: {{section: {there}, toe: {before}, {legs % ('start', 'start')}")
        points.append(f"Q{i}: {{section: {back}, toe: m{i}.start, {legs % ('end', 'end')}")
        tracks.append(f"m{i}: [{middle} 100]" if i < number else f"m{i}: [Z 100, Y 200, E]")
        if between and i < number:
            signals += [f"G{i}: {{from: M{i}, into: D{i + 1}{between}}}", f"H{i}: {{from: M{i}, into: E{i}{between}}}"]
        before = f"m{i}.end"
    signals += ["S2: {from: E, into: Y}", "S4: {from: Y, into: Z}"]
    return (
        "interlock: 1\nname: loops\nprinciples: {restart_delay_s: 3600}\n"
        "boundaries: {W: {approach: AW 1000}, E: {approach: AE 1000}}\n"
        + "".join(f"{room}:\n  " + "\n  ".join(x) + "\n" for room, x in (("tracks", tracks), ("points", points)))
        + "signals:\n  "
        + "\n  ".join(signals)
        + f"\n{more}"
    )


def told(text: str) -> list[Diagnostic]:
    sink = Sink()
    layout, _ = load_text("loops.yaml", text, sink)
    if layout is not None:
        assert not derive(layout, sink).routes  # nothing of it is used
    return [d for d in sink.diagnostics if d.code == "IL3049"]


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (loops(60), "from S3 more than 1,024 ways lead to where its train routes end"),
        (loops(60, ", kind: shunt"), "from S3 more than 1,024 ways lead to where its train routes end"),
        (
            loops(60).replace("S1: {", "S9: {from: B, into: D1, kind: shunt}\n  S1: {"),
            "from S9 more than 1,024 ways lead to where its shunt",
        ),
        (loops(60, ", identifier: yes"), "past signals with an identifier light routes have more than 20,000 ways"),
        (loops(60, more="overlaps: {S3: {successive: yes}}\n"), "the overlap of S3 would lead over more than 256 ways"),
        (loops(60, one_section=True), "more than 256 ways lead through section X from one of its ends"),
    ],
    ids=["main", "past shunt signals", "shunt", "identifiers", "overlap", "section"],
)
def test_too_many_ways_are_refused(text: str, said: str) -> None:
    found, *more = told(text)
    assert not more and found.message.startswith(said) and found.fix and found.span is not None


def test_every_signal_is_named() -> None:
    (found,) = told(loops(60))
    assert [p.note for p in found.also] == ["from S4 more than 1,024 ways lead to where its train routes end"]


def test_it_is_told_at_once(tmp_path: Path) -> None:
    """Every command that reads a layout ends; none in more than a fraction of the minute that it is given here."""
    file = tmp_path / "loops.yaml"
    file.write_text(loops(60), encoding="utf-8")
    env = {**os.environ, "NO_COLOR": "1"}
    for verb in (["check"], ["compile", "-o", str(tmp_path / "out")], ["why"], ["prove"], ["availability"]):
        command = [sys.executable, "-m", "interlock", verb[0], str(file), *verb[1:]]
        done = subprocess.run(command, capture_output=True, text=True, timeout=60, env=env, check=False)
        assert done.returncode == 1 and "IL3049" in done.stdout + done.stderr, verb
    assert not [*(tmp_path / "out").rglob("*.st")]


def test_as_many_as_there_may_be_are_listed() -> None:
    found = grown(loops(8))
    assert found is not None and len(found[1].routes) == 2 * 2**8 + 2


def test_bars_that_leave_few_enough_ways_are_of_use() -> None:
    """Without the bar there would be more than can be listed, which is no reason to call it idle."""
    bars = ", ".join(f"R{i}" for i in range(1, 61))
    sink = Sink()
    layout, _ = load_text(
        "loops.yaml", loops(60, more=f"overlaps: {{S3: {{successive: yes, not_over: [{bars}]}}}}\n"), sink
    )
    assert layout is not None and not sink.has("IL1014", "IL3049")
    one = loops(60, ", kind: main", "overlaps: {S3: {successive: yes, not_over: [R1]}}\n")
    sink = Sink()
    layout, _ = load_text("loops.yaml", one, sink)
    assert layout is not None and not sink.has("IL1014", "IL3049")


def test_a_voyage_along_many_loops_is_found() -> None:
    """Its chains are more than can be listed, and the one with the fewest alternatives is none the harder to find."""
    found = grown(
        loops(60, ", kind: main", "voyages:\n  V: {from: S3, to: E}\n  X: {from: S3, to: E, via: [R7, R50]}\n")
    )
    assert found is not None and not found[2].has("IL2013")
    v, x = found[1].voyages
    assert v.routes == ("S3-G1", *(f"G{i}-G{i + 1}" for i in range(1, 59)), "G59-E")
    assert set(x.routes) - set(v.routes) == {"G6-G7.2", "G49-G50.2"} and len(x.routes) == 60


def test_a_voyage_that_is_none_is_told_with_every_end() -> None:
    found = grown(loops(60, ", kind: main", "voyages:\n  V: {from: S3, to: S2}\n"))
    assert found is not None
    (none,) = (d for d in found[2].diagnostics if d.code == "IL2013")
    assert none.fix == f"from S3 the train routes lead to {', '.join(sorted(['E', *(f'G{i}' for i in range(1, 60))]))}"


def test_the_audit_does_not_run_through_a_section_twice() -> None:
    """Eight loops before a balloon: 2^8 ways there, and no train comes back, which would be as many for each."""
    text = (
        loops(8)
        .replace("m8: [Z 100, Y 200, E]", "m8: [Z 100]\n  ring: [U 100]")
        .replace(", E: {approach: AE 1000}", "")
    )
    text = text.replace(
        "points:\n", "points:\n  T: {section: V, toe: m8.end, normal: ring.start, reverse: ring.end, legs: 50}\n"
    )
    text = text.split("  S2:")[0]
    found = grown(text)
    assert found is not None
    layout, table, _ = found
    assert not [f for f in audit(layout, table) if f.column == "path"]
