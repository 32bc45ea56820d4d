"""What goes wrong in the world, and how often; times in seconds, rates for each second and place.

The rates are far above a railway's, so that faults meet.  Shunt is lost for less than the release delay (R15), for
longer than the proof assumes (A-DETECT: one scan).  What no interlocking withstands is left out: two neighbouring
sections that are falsely reported occupied (A-ONE-FALSE), contacts that lie (A-CONTACT), signals passed at stop.
"""

from __future__ import annotations

from interlock.dataclass import dataclass


@dataclass(frozen=True)
class Faults:
    """Rates of faults.

    late: chance that a section which a train has just entered or left is still reported as before, for one scan.
    false: a clear section reported occupied.  contact: a point without detection.  lamp: a lamp out.  inputs: all
    inputs not valid.  stall: a cycle of more than a second.  power: the controller off, all that it remembers lost.
    divide: a train parts, its rear stays.  overrun: chance that a driver does not stop at a signal with an overlap.
    condition: an external condition not fulfilled.  shunt: a section with a train in it reads clear, for `shunt_s` and
    the rest of two cycles at most.  sensor: a detector that is not healthy, and says so where that is wired; what it
    reports then is anything.  trail: chance that a vehicle which is moved under local rules runs through points of
    the sections that it stood in.  contradict: share of the faults of contacts in which both positions are reported,
    in place of none.
    """

    late: float = 0.3
    false: float = 0.0005
    contact: float = 0.0005
    lamp: float = 0.0003
    inputs: float = 0.0005
    stall: float = 0.0005
    power: float = 0.00005
    divide: float = 0.0005
    overrun: float = 0.1
    condition: float = 0.0005
    shunt: float = 0.001
    shunt_s: float = 1.0
    sensor: float = 0.0005
    trail: float = 0.5
    contradict: float = 0.5


NO_FAULTS = Faults(0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, sensor=0, trail=0, contradict=0)
"""Nothing goes wrong."""
