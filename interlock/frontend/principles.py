"""The keys of `principles`: each principle by its name, with its meaning and its values in the profiles."""

from __future__ import annotations

from enum import StrEnum
from typing import Annotated, Any

from pydantic import Field

from interlock.frontend.keys import Part
from interlock.frontend.scalars import Amount, Seconds, YesNo, choice
from interlock.model.principles import MEANING, PROFILES, Caution, Closes, FlankChoice, Local, written


def knob(name: str) -> Any:
    """A key of `principles`: its meaning stands where the principle does, and its values in the profiles."""
    told, values = MEANING[name], {profile: getattr(p, name) for profile, p in PROFILES.items()}
    usual = values.pop("generic")
    others = ", ".join(f"{profile} {written(v)}" for profile, v in values.items() if v != usual)
    text = f"{told}; without it, the profile's: {written(usual)}" + (f" ({others})" if others else "")
    return Field(None, description=text, json_schema_extra=None if others else {"default": _plain(usual)})


def _plain(x: Any) -> Any:
    return str(x) if isinstance(x, StrEnum) else x


class PrinciplesSpec(Part):
    """Single knobs of the profile, overridden."""

    release_delay_s: Seconds | None = knob("release_delay_s")
    approach_release_s: Seconds | None = knob("approach_release_s")
    shunt_release_s: Seconds | None = knob("shunt_release_s")
    point_supervision_s: Seconds | None = knob("point_supervision_s")
    point_start_gap_s: Amount | None = knob("point_start_gap_s")
    fouling_m: Seconds | None = knob("fouling_m")
    clearance_m: Seconds | None = knob("clearance_m")
    leg_m: Seconds | None = knob("leg_m")
    flank_by: Annotated[FlankChoice | None, choice("protection", tuple(FlankChoice))] = knob("flank_by")
    flank_space: YesNo | None = knob("flank_space")
    flank_lamp: YesNo | None = knob("flank_lamp")
    drive_points: YesNo | None = knob("drive_points")
    sensor_faults: YesNo | None = knob("sensor_faults")
    lamp_proof: YesNo | None = knob("lamp_proof")
    caution: Annotated[Caution | None, choice("use of caution", tuple(Caution))] = knob("caution")
    overlap_m: Amount | None = knob("overlap_m")
    overlap_release_s: Seconds | None = knob("overlap_release_s")
    local_requests: Annotated[Local | None, choice("rule for local requests", tuple(Local))] = knob("local_requests")
    priorities: YesNo | None = knob("priorities")
    priority_wait_s: Amount | None = knob("priority_wait_s")
    token_delay_s: Seconds | None = knob("token_delay_s")
    token_agreed_s: Seconds | None = knob("token_agreed_s")
    line_speed_kmh: Seconds | None = knob("line_speed_kmh")
    shunt_speed_kmh: Seconds | None = knob("shunt_speed_kmh")
    braking_ms2: Seconds | None = knob("braking_ms2")
    reaction_s: Seconds | None = knob("reaction_s")
    output_delay_s: Seconds | None = knob("output_delay_s")
    detection_delay_s: Seconds | None = knob("detection_delay_s")
    point_run_s: Seconds | None = knob("point_run_s")
    restart_delay_s: Seconds | None = knob("restart_delay_s")
    slow_below_kmh: Amount | None = knob("slow_below_kmh")
    main_closes: Annotated[Closes | None, choice("closing of signals", tuple(Closes))] = knob("main_closes")
    shunt_closes: Annotated[Closes | None, choice("closing of signals", tuple(Closes))] = knob("shunt_closes")
