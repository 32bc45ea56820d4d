"""The physics: what trains, points, detectors and lamps can do.  Built from the layout alone.

The plant is a transition system in the same expression language.  A step of the whole system is:
    1. the plant moves (any number of trains, points), seeing the outputs of the last scan, or of the scan
       before, since outputs reach signals and machines up to one scan late;
    2. inputs are sampled: an input image is any image that the detection assumptions permit;
    3. the controller scans.

State, by prefix (s a section, j an end of it, g a signal, m a machine):
    o.s       a train, or part of one, stands in s
    in.s.j    it came in at end j (after a reversal: it stands as if it had come in there)
    x.j.s     a train stands across end j, going out of s (head beyond, tail in s)
    rest.s    it has stood in s since the restart and moves only when a signal calls it
    called.s  it has been called by a signal, or is part of a train that has
    part.s    it is the rear part of a train that parted, and stays
    go.g      a train has accepted the proceed aspect of g and will pass it
    at.m.N/R  the machine really lies normal / reverse; neither means it is moving
    img.s     s was reported occupied in the last scan
    sh.s      the train in s moves as a shunting movement (layouts with shunt signals)
    gos.g     a shunting movement has accepted the shunt aspect of g and will pass it
    lamp.g    proceed was shown at g in the scan before the last; lamps.g the same of the shunt aspect
    cmd.m.x   the command of the scan before the last
No train has an identity, a length or a speed: heads and tails move separately.

Layouts with overlaps:
    run.s     the train in s, before a signal with an overlap, has not yet come to a stand there
    over.g.s  what stands in s has overrun g; it may run on within the overlap, and moves then only when called

Layouts with a short overlap inside a longer one of the same signal, the short one made for v km/h:
    fast.v.g  the train before g may have seen proceed there without an indicator of v or less
    slow.v.s  the train in s was called at no more than v; if it overruns, it stops within the short one

Lines with a direction token (b a boundary):
    line.out.b, line.in.b     a train is on the line beyond b, going out or coming in
    token.has.b, .gives, .fresh   the neighbour: has the token, gives it, has seen it not given since he last took it
    tel.has.b, tel.gives.b    what the last telegram from the neighbour says; saw.has.b, saw.gives.b the last to him

In a *berth* (a plain section that is left over its joints only on a signal) vehicles may stand in any number: a
shunting movement may come to them, each signal may call some of them, and some may stay behind.
"""

from interlock.logic.plant.build import build_plant
from interlock.logic.plant.kinds import (
    ASSUMPTIONS,
    OF_PLC,
    Assumption,
    Hazard,
    Plant,
    TokenWires,
    Wiring,
    assumed_of,
)
from interlock.logic.plant.words import (
    OUTSIDE,
    accepted,
    across,
    came,
    fast,
    has_token,
    image,
    lamp,
    lies,
    line,
    o,
    old_command,
    overran,
    parted,
    rests,
    running,
    seen_by,
    shunting,
    slow,
    telegram,
    was_called,
)

__all__ = [
    "ASSUMPTIONS",
    "OF_PLC",
    "OUTSIDE",
    "Assumption",
    "Hazard",
    "Plant",
    "TokenWires",
    "Wiring",
    "accepted",
    "across",
    "assumed_of",
    "build_plant",
    "came",
    "fast",
    "has_token",
    "image",
    "lamp",
    "lies",
    "line",
    "o",
    "old_command",
    "overran",
    "parted",
    "rests",
    "running",
    "seen_by",
    "shunting",
    "slow",
    "telegram",
    "was_called",
]
