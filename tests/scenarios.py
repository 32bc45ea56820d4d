"""What may happen on the railway that is proved safe: each scenario with a run in which it happens.

A scenario: names of a layout's system that hold together in one step (`!` before a name: it does not hold).  It is in
the world of the proof only if a run leads there, under all assumptions, from a restart; then every claim that is
proved of the layout holds with it.
"""

from __future__ import annotations

from dataclasses import dataclass

from interlock.logic.expr import Expr, conj, neg, var
from interlock.proof.claims import Claim
from interlock.proof.induction.search import Run, search
from interlock.proof.induction.story import Story, narrated
from interlock.proof.system.transition import System
from tests.layouts import built

HERE = "../tests/layouts_for_tests/"
OVERRUN, YARD, TOKEN = f"{HERE}overrun", f"{HERE}shunt_yard", f"{HERE}token"
DEPTH = 16


@dataclass(frozen=True)
class Scenario:
    """`says`: in words; `layout`: where it is shown; `holds`: the names of one step."""

    says: str
    layout: str
    holds: tuple[str, ...]

    def happens(self) -> Expr:
        """All names hold."""
        return conj(neg(var(n[1:])) if n.startswith("!") else var(n) for n in self.holds)


P1 = "III|IV@P1.normal"
OVERLAP = "l1|q2@line.0"
BERTH = "g1|p1@P1.normal"

SCENARIOS = (
    # a restart
    Scenario("A train that has stood since the restart is called.", "fig2_3_split", ("accept.X5", "rest.IV")),
    # trains
    Scenario(
        "A second train stands in an approach in the very step in which the tail of the first leaves it.",
        "fig2_3_split",
        ("tail.B.SB", "appear.SB"),
    ),
    Scenario(
        "A driver accepts a signal before the section in which he stands was ever scanned as occupied.",
        "fig2_3_split",
        ("accept.X3", "!img.SB"),
    ),
    Scenario("A driver who has accepted a proceed stops after all.", "fig2_3_split", ("refuse.X3", "go.X3")),
    Scenario(
        "A train is longer than a section, and lies across both of its ends.",
        "fig2_3_split",
        ("x.B.SB", f"x.{P1}.III"),
    ),
    Scenario("A train parts on a point, and its rear part stays there.", "fig2_3_split", ("parts.III", "!rest.III")),
    Scenario("A train parts on plain track.", "fig2_3_split", ("parts.IV",)),
    Scenario(
        "A train turns back within a section where a signal governs its new direction.",
        "fig2_3_split",
        (f"turn.IV.{P1}.IV|SC@main.0",),
    ),
    Scenario("A train passes a joint while all inputs are lost.", "fig2_3_split", ("head.B.SB", "!VALID")),
    Scenario("A train fails to stop before a signal with an overlap.", OVERRUN, ("fails.N1",)),
    Scenario("It runs on into the overlap.", OVERRUN, (f"overruns.N1.{OVERLAP}.l1",)),
    # points, detection
    Scenario("A point moves.", "fig2_3_split", ("start.P1.N",)),
    Scenario("A point moves in the scan after its drive was switched off.", "fig2_3_split", ("start.P1.N", "!YR_P1")),
    Scenario("A point loses its detection as it lies.", "fig2_3_split", ("at.P1.N", "at.P1.N'", "!DN_P1", "VALID")),
    Scenario("A section in which nobody is reads occupied.", "fig2_3_split", ("!CLR_IV", "!o.IV", "!o.IV'", "VALID")),
    Scenario(
        "A section into which a train has just come still reads clear.",
        "fig2_3_split",
        ("CLR_III", "o.III'", "!o.III", "VALID"),
    ),
    # shunting
    Scenario("A shunting movement joins vehicles that stand in a berth.", YARD, (f"shunts.{BERTH}.p1", "o.g1")),
    Scenario("A part of what stands in a berth leaves it, the rest stays.", YARD, (f"tail.{BERTH}.g1", "o.g1'")),
    # the neighbour's line
    Scenario("The neighbour takes the direction that is given to him.", TOKEN, ("neighbour.takes.E",)),
    Scenario("He gives it back.", TOKEN, ("neighbour.gives.E",)),
    Scenario("He is restarted, and has the direction no more.", TOKEN, ("token.has.E", "neighbour.lost.E")),
    Scenario("He takes it as agreed by telephone.", TOKEN, ("neighbour.manual.E",)),
    Scenario("He sends a train, and it appears.", TOKEN, ("appear.ea",)),
)


def run_to(scenario: Scenario) -> tuple[System, Run] | None:
    """The shortest run in which a scenario happens in the last step."""
    layout, _, controller = built(scenario.layout)
    system = System(layout, controller)
    never = Claim("scenario", scenario.layout, neg(scenario.happens()))
    found = search(system, [never], DEPTH, 60)
    return None if found is None else (system, found)


def told(system: System, run: Run, scenario: Scenario) -> Story:
    """The run in words."""
    return narrated(system.loop, run.frames, ("", scenario.layout, scenario.says), [])
