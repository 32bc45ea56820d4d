"""Checks of a resolved layout, one file each, run in this order."""

from interlock.frontend.checks.approach import check_approach
from interlock.frontend.checks.boundaries import check_boundaries
from interlock.frontend.checks.connected import check_connected
from interlock.frontend.checks.delays import check_delays
from interlock.frontend.checks.detection import check_detection
from interlock.frontend.checks.diamonds import check_diamonds
from interlock.frontend.checks.facing import check_facing
from interlock.frontend.checks.foul import check_foul
from interlock.frontend.checks.lanes import check_lanes
from interlock.frontend.checks.lengths import check_lengths
from interlock.frontend.checks.loops import check_loops
from interlock.frontend.checks.machines import check_machines
from interlock.frontend.checks.overlaps import check_overlaps
from interlock.frontend.checks.principles import check_principles
from interlock.frontend.checks.repeated import check_repeated
from interlock.frontend.checks.signals import check_signals
from interlock.frontend.checks.standing import check_standing
from interlock.frontend.checks.telegram import check_telegram
from interlock.frontend.checks.unseen import check_unseen
from interlock.frontend.checks.zones import check_zones

CHECKS = (
    check_connected,
    check_machines,
    check_boundaries,
    check_signals,
    check_detection,
    check_standing,
    check_lanes,
    check_foul,
    check_zones,
    check_overlaps,
    check_delays,
    check_lengths,
    check_unseen,
    check_principles,
    check_telegram,
    check_approach,
    check_facing,
    check_loops,
    check_diamonds,
    check_repeated,
)
