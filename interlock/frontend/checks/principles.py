"""Principles that no railway keeps.  IL3040.

What is proved of a layout rests on these numbers: a train that is said to brake with 60 m/s^2 has passed a signal, or
stands, when it is released, and a section that is released after a millisecond of silence may have a vehicle in it that
lost its shunt for a scan.  They are the author's; what lies outside what is built and driven is usually another unit.
"""

from __future__ import annotations

from interlock.frontend.context import Context
from interlock.model.layout import Layout

USUAL: dict[str, tuple[float, float, str, str]] = {
    "release_delay_s": (1, 60, "s", "vehicles lose their shunt for a second and more (R15: 3 s)"),
    "line_speed_kmh": (3, 400, "km/h", "is it in km/h?"),
    "shunt_speed_kmh": (3, 100, "km/h", "is it in km/h?"),
    "braking_ms2": (0.05, 3, "m/s^2", "wheels on rails brake with some 0.3 to 1.3 m/s^2, a tram's track brake with 3"),
    "reaction_s": (0.5, 60, "s", "a driver takes seconds; an automatic train brakes some tenths after it is told to"),
    "output_delay_s": (0.05, 10, "s", "a decision is seen after two scans and the way to the lamp"),
    "detection_delay_s": (0.05, 10, "s", "detectors take tenths of a second, and a scan passes before one is read"),
    "point_run_s": (0.5, 60, "s", "the fastest point machines take half a second"),
    "fouling_m": (2, 300, "m", "is it in metres?"),
    "clearance_m": (1, 100, "m", "a vehicle reaches beyond its last axle by a metre and more (R7: 3.5 m)"),
    "leg_m": (2, 300, "m", "is it in metres?"),
}
"""Least and greatest value of what is built and driven, its unit, and why; our choice where no rule is named."""


def check_principles(ctx: Context, layout: Layout) -> None:
    """Report each stated principle outside of what is built and driven."""
    for name, (least, most, unit, why) in USUAL.items():
        if getattr(ctx.file.principles, name) is None:
            continue
        own = float(getattr(layout.principles, name))
        if not least <= own <= most:
            off = f"less than {least:g}" if own < least else f"more than {most:g}"
            ctx.add("IL3040", f"{name} is {own:g} {unit}, {off} {unit}: {why}", ctx.at("principles", name), FIX)
    if ctx.file.principles.flank_lamp and layout.principles.flank_lamp and not layout.principles.lamp_proof:
        ctx.add(
            "IL1014",
            "flank_lamp asks for stop lamps that are intact, and without `lamp_proof` nobody reports whether they are",
            ctx.at("principles", "flank_lamp"),
            "add `lamp_proof: yes`, or remove `flank_lamp`",
        )


FIX = "state what trains and machines really do: the proof takes it for true"
