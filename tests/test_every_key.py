"""Every key of the language: a controller that passes over what a layout says there is refused by the second checker.

A good controller is made, with its text and what would be its proof, of a layout that says less, or something else; the
checker is shown the author's own.  Keys that cannot matter to a controller are listed with the reason, and where they
stand changes no byte of the text.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import pytest

from interlock.checker.check import agree
from interlock.checker.language import FORMS
from interlock.checker.reading import loaded
from interlock.checker.specification import shipped as specification
from interlock.verify import Rejected
from tests.written import told


def of_file(name: str) -> str:
    file = Path(f"tests/layouts_for_tests/{name}.yaml")
    return (file if file.exists() else Path(f"layouts/{name}.yaml")).read_text("utf-8")


FORK = """interlock: 1
name: fork
boundaries:
  W: {approach: wa 300}
  E: {approach: ea 300}
buffers: [B]
tracks:
  west: [W, q1 100]
  east: [q3 100, q4 100, E]
  side: [s1 100, B]
points:
  P1: {section: q2, toe: west.end, normal: east.start, reverse: side.start}
signals:
  X1: {from: W,  into: q1}
  X2: {from: q1, into: q2, kind: combined}
  Y3: {from: q3, into: q2}
  Y1: {from: E,  into: q4}
  S1: {from: s1, into: q2, kind: combined}
  N3: {from: q3, into: q4}
"""
"""A siding at a line with an entry signal at either end."""

LINE = """interlock: 1
name: line
boundaries:
  W: {approach: wa 300}
  E: {trains: out}
tracks:
  main: [W, q1 100, q2 100, E]
signals:
  X1: {from: W,  into: q1}
  X2: {from: q1, into: q2}
"""


@dataclass(frozen=True)
class Case:
    """The layout as its author has it, the other one of which a controller is made, and what refuses this one."""

    author: str
    other: str
    why: str


def said(base: str, wanted: str, why: str, instead: str = "") -> Case:
    """The author says something that the other layout lacks, or says otherwise."""
    return Case(f"{base}{wanted}\n", f"{base}{instead}\n", why)


def put(base: str, old: str, new: str, why: str) -> Case:
    """The author says `new` where the other layout says `old`."""
    assert base.count(old) == 1, (old, base.count(old))
    return Case(base.replace(old, new), base, why)


def forgot(base: str, old: str, new: str, why: str) -> Case:
    """The other layout says `new` where the author says `old`."""
    assert base.count(old) == 1, (old, base.count(old))
    return Case(base, base.replace(old, new), why)


def knob(base: str, name: str, wanted: object, other: object, why: str, more: str = "") -> Case:
    one, two = (f"{base}principles: {{{name}: {x}{more}}}\n" for x in (wanted, other))
    return Case(one, two, why)


EXCLUDED = "claim S-EXCLUDED lacks"
DECLARED = "claim S-DECLARED lacks"
DEMANDED = "claim S-DEMANDED lacks"
HOIST = f"{LINE}interlocks: {{D: {{over: [q2]}}}}\n"
REASON = "reason: of the doors of air lock north only one may be open"
DOORS = Path("tests/layouts_for_tests/air_lock_doors.yaml").read_text("utf-8")
BY_DEMANDS = DOORS.replace("air_lock: north", "kind: door") + "".join(
    [
        "demand:\n",
        *(
            f"  - {{point: {d}, lies: normal, routes: {{via: [{s}]}}, {REASON}}}\n"
            for d, s in (("D2", "a"), ("D1", "b"))
        ),
    ]
)
"""The same doors, kept apart through routes alone."""
FORK2 = FORK.replace("buffers: [B]", "buffers: [B, C]")
FORK2 = FORK2.replace("q4 100, E]", "q4 100, E]").replace("tracks:\n", "tracks:\n  p2: [C, c1 100]\n")
FORK2 = FORK2.replace("  east: [q3 100, q4 100, E]", "  mid: [q3 100]\n  east: [q4 100, E]")
FORK2 = (
    FORK2.replace("normal: east.start", "normal: mid.start")
    .replace("signals:", "  P2: {section: q5, toe: east.start, normal: mid.end, reverse: p2.end}\nsignals:")
    .replace("Y3: {from: q3", "C1: {from: c1, into: q5}\n  Y4: {from: q4, into: q5}\n  Y3: {from: q3")
    .replace("N3: {from: q3, into: q4}", "N3: {from: q3, into: q5}")
)
DETOUR, SPEEDS = of_file("detour"), of_file("speeds")
OVERLAPS, FLANK, SLIP, DEVICES = of_file("overlaps"), of_file("flank_lab"), of_file("slip"), of_file("devices")
FLANK_PLAIN = FLANK.replace(
    "principles: {overlap_release_s: 45, lamp_proof: yes, flank_lamp: yes, slow_below_kmh: 60}\n", ""
).replace("profile: de\n", "")
SPEEDS_PLAIN = "\n".join(x for x in SPEEDS.splitlines() if not x.startswith("principles")) + "\n"
WAIVED = "waive: [{flank: 2.reverse, reason: r}]\n"
HOSTILE = "hostile: [{one: {%s}, other: {from: Y1}, reason: r}]"
DEMAND = "demand: [{point: P1, lies: normal, routes: {%s}, reason: r}]"

YARD, SWING, TOKEN = of_file("shunt_yard"), of_file("swing"), of_file("token")
BOARDS, IDENT = of_file("boards"), of_file("identifier")
UNDETECTED, CROSS = of_file("undetected"), of_file("junction")
KM = FORK.replace("west: [W, q1 100]", "west: [W, 0+000, q1, q0]").replace("toe: west.end", "km: 0+120, toe: west.end")
KM = KM.replace("X2: {from: q1,", "X0: {from: q1, into: q0, km: 0+060}\n  X2: {from: q0,")
SIDE = """interlock: 1
name: side
boundaries: {W: {approach: wa 300}, E: {approach: ea 300}}
tracks: {west: [W, q1 100], main: [b 50], side: [s 100], east: [q2 100, E]}
points:
  P1: {section: b, toe: west.end, normal: main.start, reverse: side.start}
  P2: {section: b, toe: east.start, normal: main.end, reverse: side.end}
signals:
  X: {from: W, into: q1}
  Y: {from: E, into: q2}
  S: {from: s, into: b, at: P1}
"""
DIAMOND = """interlock: 1
name: diamond
boundaries: {A: {approach: aa 300}, B: {trains: out}, C: {approach: ca 300}, D: {trains: out}}
tracks: {a: [A, a1 100], b: [b1 100, B], c: [C, c1 100], d: [d1 100, D]}
crossings: {X: {arms: [{section: x1, ends: [a.end, b.start]}, {section: x2, ends: [c.end, d.start]}]}}
signals:
  SA: {from: A, into: a1}
  SC: {from: C, into: c1}
  S1: {from: a1, into: x1}
  S2: {from: c1, into: x2}
"""
NO_DERAILER = DEVICES.replace("Gs1.inner", "sid.start").replace(
    "derailers:\n  Gs1: {section: p1, outer: sid.start}\n", ""
)
TURNED = DEVICES.replace("Gs1.inner", "Gs1.outer").replace("outer: sid.start", "inner: sid.start")
SHORT = DEVICES.replace("reverse: Gs1.inner", "legs: 4, reverse: Gs1.inner")
REQUEST, PRESET, PLANT = (
    "claim S-REQUEST lacks",
    "claim D-PRESET lacks",
    "",
)

RESTRICTS: dict[str, Case] = {
    # the layout
    "layout.profile": said(FORK, "profile: uk", "S-OVERLAP|A-STAND"),
    "layout.principles": knob(FORK, "overlap_m", 60, 0, PLANT),
    "layout.boundaries": put(FORK, "E: {approach: ea 300}", "E: {trains: in, approach: ea 300}", EXCLUDED),
    "layout.buffers": forgot(FORK, "buffers: [B]", "traps: [B]", PLANT),
    "layout.traps": put(FORK, "buffers: [B]", "traps: [B]", EXCLUDED),
    "layout.tracks": forgot(OVERLAPS, "g6 200", "g6 90", PLANT),
    "layout.points": forgot(
        FORK, "normal: east.start, reverse: side.start", "reverse: east.start, normal: side.start", PLANT
    ),
    "layout.level_crossings": said(LINE, "level_crossings: {LC: {over: [q2]}}", PLANT),
    "layout.interlocks": said(LINE, "interlocks: {D: {over: [q2]}}", PLANT),
    "layout.signals": put(LINE, "  X2: {from: q1, into: q2}\n", "", PLANT),
    "layout.distants": said(FORK, "distants: {D: {of: X2}}", "S-ASPECT lacks|D"),
    "layout.sections": said(FORK, "sections: {q2: {speed: 40}}", "claim S-SPEED lacks"),
    "layout.conditions": said(FORK, "conditions: {C: {over: [q2]}}", "claim S-CONDITION lacks"),
    "layout.zones": said(FORK, "zones: {Z: {sections: [q2, q3], trains: 1}}", "claim T-ZONE lacks|as specified"),
    "layout.automatic": said(FORK, "", REQUEST, "automatic: [{from: X1, to: X2}]"),
    "layout.exclude": said(FORK, "exclude: [{from: X2, to: N3, reason: r}]", EXCLUDED),
    "layout.hostile": said(FORK, HOSTILE % "from: X1", DECLARED),
    "layout.demand": said(FORK, DEMAND % "from: X1", DEMANDED),
    "layout.overlaps": said(FORK, "overlaps: {X2: {length: 50}}", PLANT),
    "layout.waive": Case(FLANK, FLANK + WAIVED, "claim S-FLANK-SPACE lacks"),
    # principles
    "principles.release_delay_s": knob(LINE, "release_delay_s", 5, 3, PRESET),
    "principles.approach_release_s": knob(LINE, "approach_release_s", 200, 180, PRESET),
    "principles.shunt_release_s": knob(YARD, "shunt_release_s", 50, 30, PRESET),
    "principles.point_supervision_s": knob(FORK, "point_supervision_s", 20, 13, PRESET),
    "principles.point_start_gap_s": knob(FORK, "point_start_gap_s", 1, 0.5, PRESET),
    "principles.fouling_m": knob(FORK, "fouling_m", 30, 12, PLANT),
    "principles.clearance_m": knob(FORK, "clearance_m", 12, 3.5, PLANT),
    "principles.leg_m": knob(FORK, "leg_m", 5, 20, PLANT),
    "principles.flank_space": knob(FLANK_PLAIN, "flank_space", "yes", "no", "claim S-FLANK-SPACE lacks"),
    "principles.flank_lamp": knob(
        FLANK_PLAIN, "flank_lamp", "yes", "no", "claim S-FLANK-SPACE lacks", ", lamp_proof: yes"
    ),
    "principles.sensor_faults": knob(LINE, "sensor_faults", "yes", "no", "SH_|claim|assumption"),
    "principles.lamp_proof": knob(LINE, "lamp_proof", "yes", "no", "claim S-LAMP lacks"),
    "principles.caution": knob(SPEEDS_PLAIN, "caution", "turnout", "next", "claim S-ASPECT lacks"),
    "principles.overlap_m": knob(FORK, "overlap_m", 60, 0, PLANT),
    "principles.overlap_release_s": knob(OVERLAPS, "overlap_release_s", 90, 60, PRESET),
    "principles.local_requests": knob(LINE, "local_requests", "first", "last", REQUEST),
    "principles.token_delay_s": knob(TOKEN, "token_delay_s", 90, 60, PRESET),
    "principles.token_agreed_s": knob(TOKEN, "token_agreed_s", 90, 30, PRESET),
    "principles.line_speed_kmh": knob(FORK, "line_speed_kmh", 120, 40, "."),
    "principles.shunt_speed_kmh": knob(YARD, "shunt_speed_kmh", 120, 40, PRESET),
    "principles.braking_ms2": knob(FORK, "braking_ms2", 0.3, 1, "."),
    "principles.reaction_s": knob(FORK, "reaction_s", 20, 4, "."),
    "principles.output_delay_s": knob(FORK, "output_delay_s", 20, 1, "."),
    "principles.point_run_s": knob(FORK, "point_run_s", 16, 6, PRESET),
    "principles.restart_delay_s": knob(FORK, "restart_delay_s", 300, 180, PRESET),
    "principles.slow_below_kmh": knob(SPEEDS_PLAIN, "slow_below_kmh", 60, 0, "claim S-ASPECT lacks"),
    # boundaries
    "boundary_form.approach": forgot(FORK, "W: {approach: wa 300}", "W: {trains: both}", "RT_wa"),
    "boundary_form.trains": put(FORK, "approach: ea 300}", "approach: ea 300, trains: in}", EXCLUDED),
    "boundary_form.block": put(LINE, "trains: out", "trains: out, block: automatic", "claim S-CONDITION lacks"),
    # points
    "point.section": Case(FORK, FORK.replace("q2", "q5"), "RT_q2"),
    "point.toe": Case(
        FORK, FORK.replace("toe: west.end, normal: east.start", "toe: east.start, normal: west.end"), PLANT
    ),
    "point.normal": forgot(
        FORK, "normal: east.start, reverse: side.start", "reverse: east.start, normal: side.start", PLANT
    ),
    "point.reverse": forgot(
        FORK, "normal: east.start, reverse: side.start", "reverse: east.start, normal: side.start", PLANT
    ),
    "point.machine": put(FORK2, "reverse: p2.end", "reverse: p2.end, machine: P1", PLANT),
    "point.legs": put(FORK, "reverse: side.start", "reverse: side.start, legs: 5", PLANT),
    "point.fouling": put(FORK, "reverse: side.start", "reverse: side.start, fouling: 30", PLANT),
    "point.km": Case(KM, KM.replace("0+120", "0+620"), "claim L-APPROACH lacks"),
    "point.speed": put(FORK, "reverse: side.start", "reverse: side.start, speed: 40", "claim S-SPEED lacks"),
    "point.work": put(FORK, "reverse: side.start", "reverse: side.start, work: hand", "."),
    "point.supervision": put(FORK, "reverse: side.start", "reverse: side.start, supervision: 20", PRESET),
    # crossings, slips, derailers, devices
    "crossing.arms": forgot(
        DIAMOND,
        "[a.end, b.start]}, {section: x2, ends: [c.end, d.start]",
        "[a.end, d.start]}, {section: x2, ends: [c.end, b.start]",
        PLANT,
    ),
    "crossing.fouling": put(CROSS, "    legs: 25", "    legs: 25\n    fouling: 40", "claim T-FOUL lacks"),
    "crossing.legs": put(CROSS, "    legs: 25", "    legs: 5", "claim T-FOUL lacks"),
    "arm.section": Case(DIAMOND, DIAMOND.replace("x2", "x1"), PLANT + "|RT_x2"),
    "arm.ends": forgot(
        DIAMOND,
        "[a.end, b.start]}, {section: x2, ends: [c.end, d.start]",
        "[a.end, d.start]}, {section: x2, ends: [c.end, b.start]",
        PLANT,
    ),
    "layout.crossings": put(CROSS, "    legs: 25", "    legs: 5", "claim T-FOUL lacks"),
    "layout.slips": forgot(SLIP, "7: {section: T7", "7: {single: 1a-2b, section: T7", PLANT),
    "slip.section": Case(SLIP, SLIP.replace("T7", "T8"), "RT_T7"),
    "slip.arms": forgot(
        SLIP, "[[nw.end, se.start], [sw.end, ne.start]]", "[[nw.end, ne.start], [sw.end, se.start]]", PLANT
    ),
    "slip.single": put(SLIP, "7: {section: T7", "7: {single: 1a-2b, section: T7", PLANT),
    "slip.machines": put(SLIP, "7: {section: T7", "7: {machines: [7b, 7a], section: T7", PLANT),
    "slip.blades": put(SLIP, "7: {section: T7", "7: {blades: near, section: T7", PLANT),
    "slip.legs": put(SLIP, "7: {section: T7", "7: {legs: 5, section: T7", PLANT),
    "slip.fouling": put(SLIP, "7: {section: T7", "7: {fouling: 30, section: T7", PLANT),
    "slip.supervision": put(SLIP, "7: {section: T7", "7: {supervision: 20, section: T7", PRESET),
    "layout.derailers": Case(DEVICES, NO_DERAILER, "ST_Gs1|Gs1"),
    "derailer.section": Case(DEVICES, NO_DERAILER, "ST_Gs1|Gs1"),
    "derailer.outer": Case(DEVICES, TURNED, PLANT),
    "derailer.inner": Case(DEVICES, TURNED, PLANT),
    "derailer.legs": put(SHORT, "outer: sid.start}", "outer: sid.start, legs: 5}", "claim T-FOUL lacks"),
    "derailer.machine": put(DEVICES, "outer: sid.start}", "outer: sid.start, machine: 9}", "ST_Gs1|Gs1"),
    "derailer.supervision": put(DEVICES, "outer: sid.start}", "outer: sid.start, supervision: 20}", PRESET),
    "device.over": forgot(DEVICES, "LC1: {over: [g4]}", "LC1: {over: [g5]}", PLANT),
    "device.supervision": forgot(DEVICES, "LC1: {over: [g4]}", "LC1: {over: [g4], supervision: 8}", "."),
    "interlock.over": forgot(HOIST, "over: [q2]", "over: [q1]", "."),
    "interlock.supervision": forgot(HOIST, "{over: [q2]}", "{over: [q2], supervision: 8}", "."),
    "interlock.air_lock": Case(DOORS, BY_DEMANDS, "claim P-AIR-LOCK lacks"),
    # signals
    "signal_form.from": forgot(FORK, "Y3: {from: q3, into: q2}", "Y3: {from: q4, into: q3}", PLANT),
    "signal_form.into": forgot(FORK, "N3: {from: q3, into: q4}", "N3: {from: q2, into: q3}", PLANT),
    "signal_form.kind": forgot(
        YARD, "D2: {from: l2, into: p1, kind: shunt}", "D2: {from: l2, into: p1, kind: combined}", "."
    ),
    "signal_form.at": forgot(SIDE, "at: P1", "at: P2", PLANT),
    "signal_form.km": forgot(f"{KM}overlaps: {{X0: {{length: 50}}}}\n", "km: 0+060", "km: 0+010", PLANT),
    "signal_form.stops_trains": forgot(BOARDS, ", stops_trains: yes", "", PLANT),
    "signal_form.release": put(LINE, "X2: {from: q1, into: q2}", "X2: {from: q1, into: q2, release: 200}", PRESET),
    "signal_form.identifier": forgot(
        IDENT.replace("identifier: yes", "call_on: no"), "call_on: no", "identifier: yes", "claim"
    ),
    "signal_form.call_on": forgot(
        LINE, "X2: {from: q1, into: q2}", "X2: {from: q1, into: q2, call_on: yes}", "claim S-CALL-ON"
    ),
    "distant.of": Case(FORK + "distants: {D: {of: X2}}\n", FORK + "distants: {D: {of: Y3}}\n", "claim S-ASPECT lacks"),
    # sections
    "section_form.speed": said(FORK, "sections: {q3: {speed: 40}}", "claim S-SPEED lacks"),
    "section_form.detected": forgot(UNDETECTED, "sections:\n  sid: {detected: no}\n", "", PLANT),
    "section_form.berth": said(YARD, "sections: {g1: {berth: no}}", "."),
    "section_form.one_way": said(FORK, "sections: {q4: {one_way: forward}}", PLANT),
    # conditions, zones
    "condition.over": said(
        FORK, "conditions: {C: {over: [q1, q3]}}", "claim S-CONDITION lacks", "conditions: {C: {over: [q1]}}"
    ),
    "condition.signals": said(
        FORK, "conditions: {C: {over: [q1], signals: [X2]}}", "claim S-CONDITION lacks", "conditions: {C: {over: [q1]}}"
    ),
    "condition.exits": said(
        FORK, "conditions: {C: {over: [q1], exits: [E]}}", "claim S-CONDITION lacks", "conditions: {C: {over: [q1]}}"
    ),
    "zone.sections": said(
        FORK, "zones: {Z: {sections: [q2, q3], trains: 1}}", "T-ZONE", "zones: {Z: {sections: [q2], trains: 1}}"
    ),
    "zone.trains": said(
        FORK,
        "zones: {Z: {sections: [q2, q3, q4], trains: 1}}",
        "T-ZONE",
        "zones: {Z: {sections: [q2, q3, q4], trains: 2}}",
    ),
    # what the author adds and takes
    "route.from": said(FORK, "automatic: [{from: X1, to: X2}]", REQUEST, "automatic: [{from: Y1, to: Y3}]"),
    "route.to": said(FORK, "automatic: [{from: X2, to: N3}]", "works automatically", "automatic: [{from: X2, to: B}]"),
    "route.via": said(
        DETOUR, "automatic: [{from: S, to: m2, via: [r1]}]", "works automatically", "automatic: [{from: S, to: m2}]"
    ),
    "exclude.from": said(
        FORK, "exclude: [{from: X2, to: q3, reason: r}]", EXCLUDED, "exclude: [{from: Y1, to: Y3, reason: r}]"
    ),
    "exclude.to": said(
        FORK, "exclude: [{from: X2, to: N3, reason: r}]", EXCLUDED, "exclude: [{from: X2, to: B, reason: r}]"
    ),
    "exclude.via": said(
        FORK, "exclude: [{from: X2, via: [q3], reason: r}]", EXCLUDED, "exclude: [{from: X2, via: [s1], reason: r}]"
    ),
    "exclude.not_via": said(
        FORK,
        "exclude: [{from: X2, not_via: [s1], reason: r}]",
        EXCLUDED,
        "exclude: [{from: X2, not_via: [q3], reason: r}]",
    ),
    "exclude.kind": said(
        FORK, "exclude: [{from: X2, kind: main, reason: r}]", EXCLUDED, "exclude: [{from: X2, kind: shunt, reason: r}]"
    ),
    "hostile.one": said(FORK, HOSTILE % "from: X1", DECLARED, HOSTILE % "from: S1"),
    "hostile.other": said(FORK, HOSTILE % "from: X1", DECLARED, HOSTILE.replace("Y1", "S1") % "from: X1"),
    "demand.point": said(FORK2, DEMAND % "from: X1", DEMANDED, DEMAND.replace("P1", "P2") % "from: X1"),
    "demand.lies": said(FORK, DEMAND % "from: X1", DEMANDED, DEMAND.replace("normal", "reverse") % "from: X1"),
    "demand.clear": said(
        FORK, DEMAND.replace("point: P1, lies: normal", "clear: q4") % "from: X1", DEMANDED, DEMAND % "from: S1"
    ),
    "demand.hold": said(
        FORK, DEMAND.replace("reason", "hold: 30, reason") % "from: X1", "there is no timer AHT_R", DEMAND % "from: X1"
    ),
    "demand.routes": said(FORK, DEMAND % "from: X1", DEMANDED, DEMAND % "from: Y1"),
    "choice.from": said(FORK, DEMAND % "from: X1", DEMANDED, DEMAND % "from: Y1"),
    "choice.to": said(FORK, HOSTILE % "from: X2, to: B", DECLARED, HOSTILE % "from: X2, to: N3"),
    "choice.via": said(FORK, HOSTILE % "from: X2, via: [s1]", DECLARED, HOSTILE % "from: X2, via: [q3]"),
    "choice.not_via": said(FORK, HOSTILE % "from: X2, not_via: [q3]", DECLARED, HOSTILE % "from: X2, not_via: [s1]"),
    "choice.kind": said(FORK, HOSTILE % "from: X2, kind: main", DECLARED, HOSTILE % "from: X2, kind: shunt"),
    "waiver.flank": Case(FLANK + WAIVED.replace("2.rev", "1.rev"), FLANK + WAIVED, "claim S-FLANK-SPACE lacks"),
    # overlaps
    "overlap.length": said(FORK, "overlaps: {X2: {length: 150}}", PLANT, "overlaps: {X2: {length: 50}}"),
    "overlap.speed": said(FORK, "overlaps: {X2: {speed: 100}}", PLANT, "overlaps: {X2: {speed: 40}}"),
    "overlap.falling": said(FORK, "overlaps: {X2: {speed: 40, falling: 30}}", PLANT, "overlaps: {X2: {speed: 40}}"),
    "overlap.successive": said(FORK, "overlaps: {X2: {successive: yes}}", PLANT, "overlaps: {X2: {length: 30}}"),
    "overlap.swing": forgot(SWING.replace(", swing: yes", ""), "X3: {length: 60", "X3: {swing: yes, length: 60", "."),
    "overlap.entry_speed": said(
        FORK, "overlaps: {X2: {length: 50, entry_speed: 40}}", "claim S-ENTRY lacks", "overlaps: {X2: {length: 50}}"
    ),
    "overlap.release": said(FORK, "overlaps: {X2: {length: 50, release: 90}}", PRESET, "overlaps: {X2: {length: 50}}"),
    "overlap.release_by_length": said(
        FORK.replace("q1 100", "q1 1400"),
        "overlaps: {X2: {length: 50, release_by_length: yes}}",
        PRESET,
        "overlaps: {X2: {length: 50}}",
    ),
    "overlap.not_over": said(
        FORK,
        "overlaps: {X2: {length: 50, not_over: [P1.reverse]}}",
        PLANT,
        "overlaps: {X2: {length: 50}}",
    ),
    "overlap.ways": said(
        FORK, "overlaps: {X2: {length: 50, ways: [{over: [q3], length: 150}]}}", PLANT, "overlaps: {X2: {length: 50}}"
    ),
    "overlap_way.over": said(
        FORK,
        "overlaps: {X2: {length: 50, ways: [{over: [q3], length: 150}]}}",
        PLANT,
        "overlaps: {X2: {length: 50, ways: [{over: [s1], length: 150}]}}",
    ),
    "overlap_way.length": said(
        FORK,
        "overlaps: {X2: {length: 50, ways: [{over: [q3], length: 150}]}}",
        PLANT,
        "overlaps: {X2: {length: 50, ways: [{over: [q3], length: 60}]}}",
    ),
    "overlap_way.falling": said(
        FORK,
        "overlaps: {X2: {length: 50, ways: [{over: [q3], entry_speed: 40, falling: 30}]}}",
        PLANT,
        "overlaps: {X2: {length: 50, ways: [{over: [q3], entry_speed: 40}]}}",
    ),
    "overlap_way.entry_speed": said(
        FORK,
        "overlaps: {X2: {length: 50, ways: [{over: [q3], length: 50, entry_speed: 40}]}}",
        "claim S-ENTRY lacks",
        "overlaps: {X2: {length: 50}}",
    ),
}


PRINTED = "printed on plans, forms and lists, and read by nobody else"
DISPATCH = "of voyages, which are commands above the interlocking: the controller knows nothing of them"
CABINET = "of the mapping program, of which the checker says that it has not read it"
SIZES = "of the size of the text, told as a diagnostic"
EITHER = "a choice between two ways of which claims hold whichever is taken: "

CANNOT_MATTER: dict[str, str] = {
    "layout.interlock": "there is one version, and every other one is refused",
    "layout.name": "names folder and block; a text of another name is not found",
    **dict.fromkeys(("layout.title", "layout.drawing", "layout.title_block", "layout.routes"), PRINTED),
    **dict.fromkeys(("boundary_form.label", "boundary_form.button", "boundary_form.indicator"), PRINTED),
    **dict.fromkeys(
        (f"{x}.xy" for x in ("boundary_form", "point", "crossing", "slip", "derailer", "signal_form")), PRINTED
    ),
    **dict.fromkeys(("point.hand", "device.text", "condition.text"), PRINTED),
    **dict.fromkeys(("interlock.text", "interlock.kind"), PRINTED),
    **dict.fromkeys((f"named.{x}" for x in ("from", "to", "via", "kind", "listed")), PRINTED),
    **dict.fromkeys((f"title_block.{x}" for x in ("company", "author", "number", "revision", "date")), PRINTED),
    **dict.fromkeys(("exclude.reason", "hostile.reason", "demand.reason", "waiver.reason"), PRINTED),
    **dict.fromkeys(("layout.allow", "allow.lint", "allow.at", "allow.reason"), "of warnings to the author"),
    **dict.fromkeys(
        ("layout.voyages", *(f"voyage.{x}" for x in ("from", "to", "via", "kind", "order", "direction"))), DISPATCH
    ),
    **dict.fromkeys(("principles.priorities", "principles.priority_wait_s", "section_form.lane"), DISPATCH),
    **dict.fromkeys(("layout.substations", "layout.addresses", "layout.telegram"), CABINET),
    **dict.fromkeys(("layout.health", "health.by", "health.within"), CABINET),
    "principles.detection_delay_s": "compared with lengths and speeds for A-SCAN: told by check, and beside VERIFIED",
    **dict.fromkeys(("layout.target", *(f"target.{x}" for x in ("cpu", "blocks", "block_kb", "memory_kb"))), SIZES),
    "principles.flank_by": EITHER + "T-FLANK and S-FLANK ask that nothing rolls in, however it is kept out",
    "principles.drive_points": EITHER + "a driven point is never a condition of proceed, and P-LOCKED is claimed of it",
    "principles.main_closes": EITHER + "S-PASSING says when a signal may stay open behind the first axle",
    "principles.shunt_closes": EITHER + "S-PASSING says when a signal may stay open behind the first axle",
}
"""Keys that cannot matter to what is claimed of a controller, each with the reason."""


def every_key() -> Iterator[str]:
    forms = loaded(FORMS.read_text("utf-8"))
    for form, keys in forms.items():
        for key in keys:
            yield f"{form}.{key}"


def test_of_every_key_something_is_said() -> None:
    assert RESTRICTS.keys() | CANNOT_MATTER.keys() == set(every_key())
    assert not RESTRICTS.keys() & CANNOT_MATTER.keys()


WORDS = ("exclude", "hostile", "demand", "choice", "route", "layout.traps", "layout.exclude", "layout.hostile")
WORDS += (
    "layout.hostile",
    "layout.demand",
    "layout.conditions",
    "layout.automatic",
    "signal_form.call_on",
    "point.speed",
)
WORDS += ("boundary_form.trains", "section_form.speed", "signal_form.identifier", "interlock.")
"""The keys with which an author forbids something; `tests.campaigns.keys` asks of all."""


@pytest.mark.parametrize("key", [k for k in RESTRICTS if k.startswith(WORDS)])
def test_a_controller_that_passes_over_a_key_is_refused(key: str) -> None:
    case = RESTRICTS[key]
    _, system, text = told(case.other)
    with pytest.raises(Rejected, match=case.why):
        agree(loaded(case.author), system, text, specification())
