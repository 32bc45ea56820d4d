"""Layouts to begin with: a starter to edit, and large ones of any size for trials and benchmarks.

A *yard*: two lines at each end, joined by a scissors crossover, fan out over a tree of points into parallel tracks;
every track has a signal at both ends with an overlap.  8 routes a track and 8 more.
A *line*: a single line with crossing loops, signals wherever trains wait.  8 routes a station and 2 more.
"""

from __future__ import annotations

STARTER = """\
# A crossing loop on a single line.  Change it step by step, and run `interlock check` after each step;
# `interlock explain language` has every key, `interlock explain signals` those of signals.
interlock: 1
name: starter

boundaries:                     # where trains come in or leave; the approach section lies outside
  W: {approach: ap_W 600}
  E: {approach: ap_E 600}

tracks:                         # sections in order, lengths in metres
  west: [W, q1 200]
  main: [q3 600]
  loop: [q4 600]
  east: [q6 200, E]

points:                         # toe, normal and reverse say what is joined there
  P1: {section: q2, toe: west.end,   normal: main.start, reverse: loop.start}
  P2: {section: q5, toe: east.start, normal: main.end,   reverse: loop.end}

signals:                        # at the joint of two sections, read by trains that go into the second
  X1: {from: W,  into: q1}
  X2: {from: q1, into: q2}
  X3: {from: q3, into: q5}
  X4: {from: q4, into: q5}
  Y1: {from: E,  into: q6}
  Y2: {from: q6, into: q5}
  Y3: {from: q3, into: q2}
  Y4: {from: q4, into: q2}
"""


def yard(tracks: int) -> str:
    """A yard with two lines at each end and a number of parallel tracks (at least 4)."""
    if tracks < 4:
        raise ValueError("a yard has at least 4 tracks")
    half = tracks // 2
    boundaries, lines, points, crossings, signals = [], [], [], [], []
    for k in range(1, tracks + 1):
        lines.append(f"  t{k}: [t{k} 400]")
    for p in "WE":
        for i in (1, 2):
            boundaries.append(f"  {p}{i}: {{approach: ap{p}{i} 600}}")
            lines.append(f"  lead{p}{i}: [{p}{i}, {p}a{i} 300]")
            signals += [f"  X{p}{i}: {{from: {p}{i}, into: {p}a{i}}}", f"  H{p}{i}: {{from: {p}a{i}, into: {p}s{i}}}"]
        points += [
            f"  {p}1a: {{section: {p}s1, machine: {p}M1, toe: lead{p}1.end, normal: {p}2b.normal}}",
            f"  {p}2b: {{section: {p}s1, machine: {p}M2, toe: {p}f1.toe}}",
            f"  {p}2a: {{section: {p}s2, machine: {p}M2, toe: lead{p}2.end, normal: {p}1b.normal}}",
            f"  {p}1b: {{section: {p}s2, machine: {p}M1, toe: {p}f2.toe}}",
        ]
        crossings += [
            f"  {p}X:",
            "    arms:",
            f"      - {{section: {p}s1, ends: [{p}1a.reverse, {p}1b.reverse]}}",
            f"      - {{section: {p}s2, ends: [{p}2a.reverse, {p}2b.reverse]}}",
        ]
        end = "start" if p == "W" else "end"
        for i, (low, high) in ((1, (1, half)), (2, (half + 1, tracks))):
            _fan(points, signals, p, f"{p}f{i}", low, high, end)
    out = ["interlock: 1", f"name: yard{tracks}", "principles: {overlap_m: 30, overlap_release_s: 45}"]
    parts = (
        ("boundaries", boundaries),
        ("tracks", lines),
        ("points", points),
        ("crossings", crossings),
        ("signals", signals),
    )
    for key, rows in parts:
        out += [f"{key}:", *rows]
    return "\n".join(out) + "\n"


def _fan(points: list[str], signals: list[str], p: str, name: str, low: int, high: int, end: str) -> None:
    """The tree of points that leads to the tracks low to high; `name` is its first point."""
    middle = (low + high) // 2
    legs = []
    for leg, a, b in (("n", low, middle), ("r", middle + 1, high)):
        child = f"{name}{leg}"
        if a == b:
            legs.append(f"t{a}.{end}")
            signals.append(f"  S{p}{a}: {{from: t{a}, into: {name}}}")
        else:
            legs.append(f"{child}.toe")
            _fan(points, signals, p, child, a, b, end)
    points.append(f"  {name}: {{section: {name}, normal: {legs[0]}, reverse: {legs[1]}}}")


def line(stations: int) -> str:
    """A single line with a number of crossing loops (at least 1)."""
    if stations < 1:
        raise ValueError("a line has at least 1 station")
    lines = ["  line0: [W, a0 800]"]
    points, signals = [], ["  X: {from: W, into: a0}"]
    for k in range(1, stations + 1):
        last = k == stations
        lines += [f"  main{k}: [m{k} 600]", f"  loop{k}: [l{k} 600]"]
        lines.append(f"  line{k}: [a{k} 800{', E' if last else ''}]")
        points += [
            f"  P{k}: {{section: p{k}, toe: line{k - 1}.end, normal: main{k}.start, reverse: loop{k}.start}}",
            f"  Q{k}: {{section: q{k}, toe: line{k}.start, normal: main{k}.end, reverse: loop{k}.end}}",
        ]
        signals += [
            f"  A{k}: {{from: a{k - 1}, into: p{k}}}",
            f"  B{k}: {{from: a{k}, into: q{k}}}",
            f"  C{k}: {{from: m{k}, into: q{k}}}",
            f"  D{k}: {{from: l{k}, into: q{k}}}",
            f"  F{k}: {{from: m{k}, into: p{k}}}",
            f"  G{k}: {{from: l{k}, into: p{k}}}",
        ]
    signals.append(f"  S: {{from: E, into: a{stations}}}")
    head = ["interlock: 1", f"name: line{stations}", "boundaries:"]
    head += ["  W: {approach: ap_W 600}", "  E: {approach: ap_E 600}"]
    return "\n".join([*head, "tracks:", *lines, "points:", *points, "signals:", *signals]) + "\n"
