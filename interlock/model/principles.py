"""The railway's policy knobs.  A profile is a named set; a layout may override single knobs.

Every knob names its source.  Where no source gives a figure, its meaning says that it is our choice.
"""

from __future__ import annotations

from dataclasses import fields
from enum import StrEnum

from interlock.dataclass import dataclass
from interlock.model.figures import exact


class FlankChoice(StrEnum):
    """What protects a flank where both a point and a signal could (R5)."""

    POINT = "point"
    SIGNAL = "signal"


class Local(StrEnum):
    """Requests from a place on the spot, beside those from the control centre (R14, document A)."""

    NONE = "none"
    FIRST = "first"
    LAST = "last"


class Caution(StrEnum):
    """When an open main signal shows caution instead of clear (R11)."""

    NEVER = "never"
    NEXT = "next"
    TURNOUT = "turnout"


class Closes(StrEnum):
    """When an open signal returns to stop behind a movement (R3)."""

    FIRST_AXLE = "first-axle"
    WHOLE = "whole-movement"


@dataclass(frozen=True)
class Principles:
    """Knobs of derivation and control; `MEANING` tells what each of them means."""

    release_delay_s: float = 3.0
    approach_release_s: float = 180.0
    shunt_release_s: float = 30.0
    point_supervision_s: float = 13.0
    point_start_gap_s: float = 0.0
    fouling_m: float = 12.0
    clearance_m: float = 3.5
    leg_m: float = 20.0
    flank_by: FlankChoice = FlankChoice.POINT
    flank_space: bool = False
    flank_lamp: bool = False
    drive_points: bool = False
    overlap_m: float = 0.0
    overlap_release_s: float = 60.0
    sensor_faults: bool = False
    lamp_proof: bool = False
    local_requests: Local = Local.NONE
    priorities: bool = False
    priority_wait_s: float = 0.0
    slow_below_kmh: float = 0.0
    token_delay_s: float = 60.0
    token_agreed_s: float = 30.0
    line_speed_kmh: float = 80.0
    shunt_speed_kmh: float = 40.0
    braking_ms2: float = 0.6
    reaction_s: float = 4.0
    output_delay_s: float = 1.0
    detection_delay_s: float = 0.5
    point_run_s: float = 6.0
    restart_delay_s: float = 180.0
    main_closes: Closes = Closes.FIRST_AXLE
    shunt_closes: Closes = Closes.FIRST_AXLE
    caution: Caution = Caution.NEXT


MEANING: dict[str, str] = {
    "release_delay_s": (
        "how long a section must read clear without a break before it counts as clear, and is released (R9, R15: 3 s)"
    ),
    "approach_release_s": (
        "delay of a cancellation while the approach is occupied, for train routes (R8: 180 s receiving and "
        "main-line departure; an Indian example has 120 s).  `mine` takes 60 s (our choice)"
    ),
    "shunt_release_s": "the same for signals that open for shunt routes alone (R8: 30 s)",
    "point_supervision_s": "time after which a commanded point without detection raises an alarm (R10: 13 s)",
    "point_start_gap_s": (
        "least time between the starts of two point machines, so that their currents do not add up (R10, sequence "
        "start); 0 starts all at once"
    ),
    "fouling_m": "distance from a point to its fouling point where the layout states none (our choice)",
    "clearance_m": (
        "least distance from the fouling point to a joint that is not foul (R7: 3.5 m; 5 m on lines for multiple units)"
    ),
    "leg_m": "length of the legs of a point where the layout states none (our choice)",
    "flank_by": (
        "whether a flank is protected by turning a point or by a signal at stop, where both can (R5); in either "
        "case a flank where nothing can come is asked for nothing, a point is turned away from the end of a track, and "
        "a derailer is laid, and a point that leads into a trap for it, whatever signal stands behind"
    ),
    "flank_space": (
        "whether the track between a flank and what protects it must be reported clear (R5: Flankenschutzraum; "
        "German practice unless a table says otherwise)"
    ),
    "flank_lamp": (
        "whether a signal protects a flank only while its stop lamp is reported intact (R5: Lichtschutz); needs "
        "`lamp_proof`"
    ),
    "drive_points": (
        "whether a route drives the other points of its sections along, so that parallel routes stay possible: to "
        "normal, or to where those hold them, or to where a train there is not foul of them (带动道岔).  A driven "
        "point is never a condition of proceed (R10)"
    ),
    "overlap_m": (
        "metres of overlap beyond every main signal inside the layout where the layout states none (R4: UK 180 m; "
        "Chinese main lines and mines none)"
    ),
    "overlap_release_s": (
        "time for which the section before the signal must have been occupied until the train counts as standing "
        "and its overlap is released (R4: 30 to 80 s), and vehicles are shunted towards it (R2: without an overlap, "
        "too, and later where the berth needs it)"
    ),
    "sensor_faults": (
        "whether the substations report for every section that its detector is healthy (document B 2.1); one that "
        "is not counts as occupied"
    ),
    "lamp_proof": (
        "whether the lamps of stop, clear, caution and identifier and speed indicators are reported (R11, Chinese "
        "practice; white and call-on lamps are not): a signal opens only while its stop lamp is intact, shows caution "
        "while its clear lamp is not, and stop while its caution lamp is not, on which it would have to fall back "
        "(with two aspects, its clear lamp), or the second yellow lamp or the indicator that it has to light"
    ),
    "local_requests": (
        "whether routes are asked for on the spot too, and which of two requests in one scan is taken: the local "
        "one `first`, or `last` (document A: its heading says remote, its reason says that the scene knows better; "
        "local first is our reading)"
    ),
    "priorities": (
        "whether voyages, and automatic routes, are served in an order: transport over an inclined lane first, then"
        " the main direction (document A); otherwise as they were commanded, or as the layout names them"
    ),
    "priority_wait_s": (
        "how long a voyage, or a request of a lower class, may wait before it comes first for once, before what is "
        "asked for by hand, too; 0 for ever"
    ),
    "slow_below_kmh": (
        "a main signal shows caution instead of clear for a route whose stated speed is lower (R11, by route "
        "speed; nothing with `caution: never`); 0 for never"
    ),
    "token_delay_s": "how long the operator must hold the special manual change of direction (R12; our choice)",
    "token_agreed_s": (
        "how long that hand must at least be held until telegrams and trains that were under way have "
        "arrived, as agreed by telephone (our choice)"
    ),
    "line_speed_kmh": "highest speed of trains where a section states none (our choice)",
    "shunt_speed_kmh": "highest speed of shunting movements (our choice)",
    "braking_ms2": (
        "braking of the worst train, in m/s^2 (our choice; in `mine` it brakes from 20 km/h within 39 m, the coal "
        "rules' 40 m for goods, and needs 66 m with `output_delay_s` and `reaction_s`; their 20 m for trains "
        "with men are not met: state what yours do)"
    ),
    "reaction_s": "time until a driver who sees stop applies the brake (our choice)",
    "output_delay_s": "time from a decision of the controller until the driver can see it (two scans; our choice)",
    "detection_delay_s": (
        "time from when an axle comes into a section until a scan has read it as occupied: the detector and one scan; "
        "no train runs through a section, or past a joint, in less (A-SCAN; our choice)"
    ),
    "point_run_s": "time in which a point machine runs from one position to the other (our choice)",
    "restart_delay_s": (
        "time after power-up before which no section is released: whatever ran at the power cut, at half of "
        "`line_speed_kmh` at least, has come to a stand (R16; our choice)"
    ),
    "main_closes": (
        "whether a main signal returns to stop with the first axle (railway practice), or when the whole movement "
        "has passed it (document B 2.1); where no second one can come from behind meanwhile (R3)"
    ),
    "shunt_closes": "the same for shunt signals (TB/T 3027: when the whole movement has passed)",
    "caution": (
        "when an open main signal shows caution instead of clear (R11): `never` (two aspects), `next` while the "
        "next main signal does not show proceed, or `turnout`, also into a track inside the layout over a reversed "
        "point (Chinese practice), which it tells by a second yellow lamp"
    ),
}
"""What each knob means, with its unit and source; the language page and editors show it."""

PROFILES: dict[str, Principles] = {
    "generic": Principles(),
    "mine": Principles(
        approach_release_s=60.0,
        fouling_m=8.0,
        caution=Caution.NEVER,
        local_requests=Local.FIRST,
        priorities=True,
        restart_delay_s=600.0,
        line_speed_kmh=20.0,
        shunt_speed_kmh=20.0,
        braking_ms2=0.4,
    ),
    "uk": Principles(overlap_m=180.0, approach_release_s=120.0),
    "de": Principles(overlap_m=200.0, overlap_release_s=45.0, flank_space=True),
    "cn": Principles(
        point_start_gap_s=0.5,
        flank_by=FlankChoice.SIGNAL,
        drive_points=True,
        lamp_proof=True,
        shunt_closes=Closes.WHOLE,
        caution=Caution.TURNOUT,
    ),
}

KNOBS: tuple[str, ...] = tuple(f.name for f in fields(Principles))


def written(x: object) -> str:
    """A value of a principle as a layout states it."""
    return ("yes" if x else "no") if isinstance(x, bool) else exact(x) if isinstance(x, float) else str(x)
