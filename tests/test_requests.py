"""Requests by hand, automatic working, aspects, trailed points, machines started in turn: what an operator sees."""

from __future__ import annotations

import pytest

from interlock.model.elements import MachineId, Position, SectionId
from interlock.proof.system.loop import closed_loop
from interlock.sim.run import Simulator
from tests.layouts import grown

TWO = """
interlock: 1
name: two
boundaries:
  W: {approach: wa 300}
  E: {approach: ea 300}
tracks:
  west: [W, q1 200]
  odd:  [q3 300]
  even: [q4 300]
  east: [q6 200, E]
points:
  P1: {section: q2, toe: west.end,   normal: odd.start, reverse: even.start}
  P2: {section: q5, toe: east.start, normal: odd.end,   reverse: even.end}
signals:
  X1: {from: W,  into: q1}
  X2: {from: q1, into: q2}
  X3: {from: q3, into: q5}
  X4: {from: q4, into: q5}
  Y1: {from: E,  into: q6}
  Y2: {from: q6, into: q5}
  Y3: {from: q3, into: q2}
  Y4: {from: q4, into: q2}
"""


def simulator(text: str) -> Simulator:
    """A grown layout, every section clear and released after the restart, points lying normal."""
    from interlock.logic.lower import lower

    made = grown(text)
    assert made is not None
    layout, table, _ = made
    controller = lower(layout, table)
    sim = Simulator(controller, closed_loop(layout, controller).plant)
    sim.reset({f"at.{m}.N": 1 for m in layout.machines})
    for _ in range(2):
        sim.step((), {"RELALL": 1})
    return sim


def steps(sim: Simulator, count: int, events: tuple[str, ...] = (), **inputs: int) -> list[set[str]]:
    """The signals and states that are on after each step; machines run as they are commanded.

    Numbers count on a change: before the first step the panel lets go of the number that it held.
    """
    seen = []
    numbers = {x for x in ("REQ", "LREQ") if inputs.get(x) and sim.last.get(x)}
    if numbers:
        sim.step((), {k: v for k, v in inputs.items() if k not in numbers})
    for _ in range(count):
        moves = [e for e in sim.possible() if e.startswith("arrive.") or _leaves(sim, e)]
        sim.step((*events, *moves), inputs)
        seen.append(
            {n for n, v in sim.state.items() if v} | {o.name for o in sim.controller.outputs if on(sim, o.name)}
        )
    return seen


def _leaves(sim: Simulator, event: str) -> bool:
    """A machine leaves a position because it is commanded away."""
    if not event.startswith("start."):
        return False
    _, m, x = event.split(".")
    return sim.is_on(sim.controller.symbols.machines.command[MachineId(m), Position(x).other])


def on(sim: Simulator, output: str) -> bool:
    """An output after the last step."""
    from interlock.logic.expr import evaluate

    expr = next(o.expr for o in sim.controller.outputs if o.name == output)
    return bool(evaluate(expr, sim.state.__getitem__, {}))


def number(sim: Simulator, route: str) -> int:
    """The number of a route."""
    return next(r.number for r in sim.controller.symbols.routes if r.id == route)


def test_an_automatic_route_is_set_again_after_every_train() -> None:
    sim = simulator(TWO + "automatic:\n  - {from: X1, to: X2}\n")
    name = f"A_R{number(sim, 'X1-X2')}"
    assert not any(name in seen for seen in steps(sim, 6))
    assert name in steps(sim, 6, AUTO_R1=1)[-1]
    for _ in range(2):
        drive(sim, "wa", "q1", "W")
        assert name not in steps(sim, 1)[-1]
        drive(sim, "q1", "q2", sim_joint(sim, "X2"), route="X2-X3")
        drive(sim, "q2", "q3", joint_between(sim, "q2", "q3"))
        assert any(name in seen for seen in steps(sim, 80, AUTO_R1=1))
        drive(sim, "q3", "q5", sim_joint(sim, "X3"), route="X3-E")
        drive(sim, "q5", "q6", joint_between(sim, "q5", "q6"))
        steps(sim, 3, ("head.E.q6",))
        steps(sim, 80, ("tail.E.q6",))
        assert not sim.hazards


def sim_joint(sim: Simulator, signal: str) -> str:
    """The joint at which a signal stands, read from its events."""
    first = next(r.path.ways[0][0] for r in sim.controller.symbols.routes if r.entry == signal)
    rear = sim.controller.symbols.cancellation.approach_of[signal]  # type: ignore[index]
    return joint_between(sim, str(rear), first)


def joint_between(sim: Simulator, a: str, b: str) -> str:
    """The joint between two sections."""
    ends = sim.controller.symbols.ways.ends
    return next(j for j in ends[SectionId(a)] if j in ends[SectionId(b)])


def drive(sim: Simulator, a: str, b: str, joint: str, route: str = "") -> None:
    """A train goes from one section into the next, wholly; a route is asked for first if it needs one."""
    if not sim.state.get(f"o.{a}"):
        steps(sim, 2, (f"appear.{a}",))
    if route:
        steps(sim, 1, REQ=number(sim, route))
        steps(sim, 6)
    accepts = tuple(e for e in sim.plant.events if e.startswith("accept."))
    steps(sim, 4, (f"head.{joint}.{a}", *accepts))
    assert sim.is_on(f"o.{b}"), f"no train came into {b}"
    steps(sim, 4, (f"tail.{joint}.{a}",))
    assert not sim.is_on(f"x.{joint}.{a}")


def test_clear_is_shown_only_while_the_next_signal_is_open() -> None:
    sim = simulator(TWO + "distants:\n  V2: {of: X2}\n")
    steps(sim, 1, REQ=number(sim, "X2-X3"))
    assert steps(sim, 6)[-1] >= {"YY_X2", "YC_V2"} and not on(sim, "YP_X2")
    steps(sim, 1, REQ=number(sim, "X3-E"))
    assert steps(sim, 6)[-1] >= {"YP_X2", "YP_X3", "YD_V2"} and not on(sim, "YY_X2")
    seen = steps(sim, 1, CAN_X3=1)[-1]
    assert "YS_X3" in seen and "YY_X2" in seen and "YP_X2" not in seen, "in the same scan"


def test_a_lamp_that_fails_gives_a_more_restrictive_aspect() -> None:
    sim = simulator(TWO.replace("name: two", "name: two\nprofile: cn"))
    lit = {"CLR_wa": 1}
    steps(sim, 1, REQ=number(sim, "X2-X3"))
    steps(sim, 1, REQ=number(sim, "X3-E"))
    assert "YP_X2" in steps(sim, 8, **lit)[-1]
    assert "YY_X2" in steps(sim, 1, GL_X2=0)[-1]
    assert "YS_X2" in steps(sim, 1, GL_X2=0, CL_X2=0)[-1]
    assert "YS_X2" in steps(sim, 3)[-1], "it does not open again by itself"


def test_a_trailed_point_is_kept_back_until_somebody_has_looked_at_it() -> None:
    sim = simulator(TWO)
    route = number(sim, "X2-X3")
    steps(sim, 1, REQ=route)
    assert "YY_X2" in steps(sim, 6)[-1]
    seen = steps(sim, 2, DN_P1=0)[-1]
    assert "YS_X2" in seen and "YT_P1" in seen
    steps(sim, 1, REQ=route)
    assert "YS_X2" in steps(sim, 6)[-1], "detection is back, but nobody has looked"
    steps(sim, 1, TC_P1=1)
    steps(sim, 1, REQ=route)
    assert "YY_X2" in steps(sim, 3)[-1] and not on(sim, "YT_P1")


def test_machines_start_one_after_the_other() -> None:
    text = TWO.replace("name: two", "name: two\nprinciples: {point_start_gap_s: 2}")
    sim = simulator(text)
    steps(sim, 1, REQ=number(sim, "X2-X4"))
    steps(sim, 1, REQ=number(sim, "X4-E"))
    started = {}
    for i in range(60):
        sim.step((), {})
        for name in ("YR_P1", "YR_P2"):
            if on(sim, name):
                started.setdefault(name, i)
    assert set(started) == {"YR_P1", "YR_P2"}
    assert abs(started["YR_P1"] - started["YR_P2"]) * sim.dt_ms >= 2000


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("voyages:\n  V: {from: X1, to: W}\n", "IL2013"),
        ("voyages:\n  V: {from: X9, to: E}\n", "IL2006"),
        ("automatic:\n  - {from: X1, to: E}\n", "IL2007"),
        ("distants:\n  D1: {of: X9}\n", "IL2006"),
        ("distants:\n  X1: {of: X2}\n", "IL2002"),
    ],
)
def test_what_does_not_exist_is_named(text: str, code: str) -> None:
    from interlock.derivation import derive
    from interlock.diag import Sink
    from interlock.frontend import load_text

    sink = Sink()
    layout, _ = load_text("two.yaml", TWO + text, sink)
    if layout is not None:
        derive(layout, sink)
    assert code in {d.code for d in sink.diagnostics}


CALL = TWO.replace("X2: {from: q1, into: q2}", "X2: {from: q1, into: q2, call_on: yes}")


def test_a_train_is_called_on_past_a_failed_section_and_its_locks_are_cancelled_by_hand() -> None:
    sim = simulator(CALL)
    main, call = number(sim, "X2-X3"), number(sim, "X2-X3.c")
    steps(sim, 2, ("appear.wa",))
    seen = steps(sim, 3, REQ=main, CLR_q3=0)  # the track circuit of q3 has failed
    assert "G_R" not in seen[-1] and f"A_R{main}" not in seen[-1]
    seen = steps(sim, 3, REQ=call, CLR_q3=0)
    assert {f"A_R{call}", "YO_X2", "YS_X2"} <= seen[-1] and "YP_X2" not in seen[-1]
    assert "YO_X2" not in steps(sim, 1, CLR_q3=0, CLR_q2=0)[-1]  # the first axle closes it
    seen = steps(sim, 5, REQ=call, CLR_q3=0)
    assert all("YO_X2" not in s for s in seen) and "L_q2_1" in seen[-1]  # and it stays closed
    seen = steps(sim, 60, CAN_X2=1, CLR_q3=0)
    assert "L_q2_1" not in seen[-1] and "L_q3_1" in seen[-1]  # an occupied section is never released
    seen = steps(sim, 60)
    assert "L_q3_1" not in seen[-1]


def test_inputs_that_were_lost_while_a_call_on_was_set_keep_its_signal_at_stop() -> None:
    """What passed it meanwhile was not seen: it is cancelled and set again, asked for once more or not (R16)."""
    sim = simulator(CALL)
    call = number(sim, "X2-X3.c")
    steps(sim, 2, REQ=call, DN_P1=0, DR_P1=0)
    steps(sim, 2, DN_P1=0, DR_P1=0)
    steps(sim, 1, VALID=0)
    assert f"A_R{call}" in steps(sim, 2)[-1] and on(sim, "YS_X2")
    steps(sim, 2, REQ=call)
    assert not any("YO_X2" in seen for seen in steps(sim, 60)), "nothing opens it by itself, nor when asked for again"


def test_no_call_on_with_the_first_section_occupied_or_over_a_locked_section() -> None:
    sim = simulator(CALL)
    call = number(sim, "X2-X3.c")
    seen = steps(sim, 3, REQ=call, CLR_q2=0)
    assert f"A_R{call}" not in seen[-1]
    steps(sim, 3, REQ=number(sim, "Y2-Y3"))
    assert f"A_R{call}" not in steps(sim, 3, REQ=call)[-1]


BOTH = (
    TWO.replace("name: two", "name: two\nprofile: mine\nprinciples: {approach_release_s: 9, line_speed_kmh: 5}")
    + "sections: {q4: {lane: inclined}}\nautomatic:\n  - {from: Y3, to: W}\n  - {from: X2, to: X4}\n"
)


def first_set(text: str) -> str:
    """Which of two automatic routes that could both be set is set, when both are switched on."""
    sim = simulator(text)
    numbers = {word: number(sim, r) for word, r in (("level", "Y3-W"), ("steep", "X2-X4"))}
    switches = {f"AUTO_R{k}": 1 for k in numbers.values()}
    (seen,) = steps(sim, 1, **switches)
    found = [word for word, k in numbers.items() if f"A_R{k}" in seen]
    assert len(found) == 1, "two hostile routes in one scan, or none"
    return found[0]


def test_of_automatic_routes_the_inclined_lane_comes_first_otherwise_the_one_named_first() -> None:
    assert first_set(BOTH) == "steep"
    assert first_set(BOTH.replace("line_speed_kmh: 5}", "line_speed_kmh: 5, priorities: no}")) == "level"


def test_an_automatic_route_waits_while_somebody_asks_by_hand() -> None:
    sim = simulator(BOTH)
    k, other = number(sim, "X2-X4"), number(sim, "X3-E")
    (seen,) = steps(sim, 1, REQ=other, **{f"AUTO_R{k}": 1})
    assert f"A_R{other}" in seen and f"A_R{k}" not in seen
    assert f"A_R{k}" in steps(sim, 2, REQ=other, **{f"AUTO_R{k}": 1})[-1], "a number that is held asks once"


@pytest.mark.parametrize(("rule", "winner"), [("first", "X2-X4"), ("last", "Y3-W")])
def test_of_a_local_and_a_remote_request_one_is_heard(rule: str, winner: str) -> None:
    sim = simulator(TWO.replace("name: two", f"name: two\nprinciples: {{local_requests: {rule}}}"))
    numbers = {r: number(sim, r) for r in ("Y3-W", "X2-X4")}
    steps(sim, 1, REQ=numbers["Y3-W"], LREQ=numbers["X2-X4"])
    (seen,) = steps(sim, 1)
    assert {r for r, n in numbers.items() if f"A_R{n}" in seen} == {winner}


@pytest.mark.parametrize("whole", [False, True])
def test_a_signal_returns_to_stop_with_the_first_axle_or_behind_the_whole_movement(whole: bool) -> None:
    """Where the principle says so, X2 stays open until the train has left q1; X1 at the boundary never does."""
    knob = "principles: {main_closes: whole-movement}\n" if whole else ""
    sim = simulator(TWO.replace("boundaries:", f"{knob}boundaries:"))
    steps(sim, 1, ("appear.wa",))
    steps(sim, 4, REQ=number(sim, "X1-X2"))
    steps(sim, 4, REQ=number(sim, "X2-X3"))
    assert on(sim, "YP_X1") or on(sim, "YY_X1")
    steps(sim, 1, ("accept.X1",))
    steps(sim, 2, ("head.W.wa",))
    assert on(sim, "YS_X1")
    steps(sim, 2, ("tail.W.wa",))
    steps(sim, 1, ("accept.X2",))
    into = next(e for e in sim.possible() if e.startswith("head.") and e.endswith(".q1"))
    assert on(sim, "YP_X2") or on(sim, "YY_X2")
    steps(sim, 2, (into,))
    assert on(sim, "YS_X2") is not whole
    steps(sim, 3, (into.replace("head.", "tail."),))
    assert on(sim, "YS_X2")


class Stations:
    """Two stations at the ends of one line: what each tells, the other reads some scans later."""

    def __init__(self, delay: int) -> None:
        self.west = simulator(TWO.replace("{approach: ea 300}", "{approach: ea 300, block: token}"))
        self.east = simulator(TWO.replace("{approach: wa 300}", "{approach: wa 300, block: token}"))
        self.ends = ((self.west, "E"), (self.east, "W"))
        quiet = dict.fromkeys(("NR", "NG", "NN", "NH"), 0)
        self.under_way = [[quiet] * delay for _ in self.ends]

    def run(self, count: int, west: dict[str, int] | None = None, east: dict[str, int] | None = None) -> None:
        """Scans of both, each in turn; the line is clear."""
        for _ in range(count):
            words = (("R", "A"), ("G", "G"), ("N", "N"), ("H", "H"))
            told = [{f"N{w}": int(on(sim, f"YT{y}_{end}")) for w, y in words} for sim, end in self.ends]
            for k, (sim, end) in enumerate(self.ends):
                self.under_way[k].append(told[1 - k])
                telegram = {f"{name}_{end}": value for name, value in self.under_way[k].pop(0).items()}
                steps(sim, 1, **(telegram | ((west, east)[k] or {})))
            assert not (self.west.is_on("BH_E") and self.east.is_on("BH_W"))


@pytest.mark.parametrize("delay", [1, 4])
def test_the_direction_changes_when_a_departure_is_set_and_never_has_two_owners(delay: int) -> None:
    line = Stations(delay)
    line.run(10)
    assert not line.west.is_on("BH_E") and not line.east.is_on("BH_W")  # after a restart nobody has it
    line.run(70, west={"TKN_E": 1})
    assert line.west.is_on("BH_E")  # the special manual change
    line.run(4, east={"REQ": number(line.east, "Y3-W")})
    line.run(6 * delay + 10)
    assert line.east.is_on("BH_W") and on(line.east, "YP_Y3") and not line.west.is_on("BH_E")
    line.run(4, west={"REQ": number(line.west, "X3-E")})
    line.run(6 * delay + 10)
    assert line.east.is_on("BH_W") and on(line.west, "YS_X3")  # not while something is locked towards the line
    line.run(2, east={"CAN_Y3": 1})
    line.run(6 * delay + 10)
    assert line.west.is_on("BH_E") and on(line.west, "YP_X3") and not line.east.is_on("BH_W")


def test_a_direction_that_is_given_to_a_neighbour_who_does_not_take_it_is_taken_back_by_hand() -> None:
    """It stayed given until our own restart: the neighbour had gone out of service before he took it."""
    west = Stations(1).west
    silent = {"NR_E": 0, "NG_E": 0, "NN_E": 0, "NH_E": 0}
    steps(west, 10, **silent)
    steps(west, 70, **silent, TKN_E=1)
    steps(west, 3, **{**silent, "NN_E": 1})
    steps(west, 2, **{**silent, "NR_E": 1})
    steps(west, 600, **silent)
    assert west.is_on("BG_E") and not west.is_on("BH_E")
    steps(west, 2, **silent, TKN_E=1)
    assert not west.is_on("BG_E") and not west.is_on("BH_E"), "nobody has it until the agreed time is over"
    steps(west, 70, **silent, TKN_E=1)
    assert west.is_on("BH_E")


def test_while_the_hand_is_held_nothing_is_given() -> None:
    """A contact that sticks gave the direction for one scan, and took it back."""
    west = Stations(1).west
    silent = {"NR_E": 0, "NG_E": 0, "NN_E": 1, "NH_E": 0}
    steps(west, 80, **silent, TKN_E=1)
    assert west.is_on("BH_E")
    for _ in range(20):
        steps(west, 1, **{**silent, "NR_E": 1}, TKN_E=1)
        assert west.is_on("BH_E") and not west.is_on("BG_E")
    steps(west, 2, **{**silent, "NR_E": 1})
    assert west.is_on("BG_E")


@pytest.mark.parametrize("delay", [1, 3, 6])
def test_a_direction_that_is_taken_back_while_the_neighbour_takes_it_is_his(delay: int) -> None:
    """`run` looks at it after every scan: never two have it."""
    for pressed in range(2 * delay + 3):
        line = Stations(delay)
        line.run(10)
        line.run(70, west={"TKN_E": 1})
        line.run(4 + delay, east={"REQ": number(line.east, "Y3-W")})
        line.run(pressed)
        line.run(6 * delay + 80, west={"TKN_E": 1})
        assert line.west.is_on("BH_E") != line.east.is_on("BH_W")


def test_an_overlap_swings_until_a_train_is_close() -> None:
    text = (
        TWO.replace("name: two", "name: two\nprinciples: {line_speed_kmh: 40}")
        + "overlaps:\n  X2: {length: 60, swing: yes}\n"
    )
    sim = simulator(text)
    swing = sim.controller.symbols.overlaps.swing_request["X2"]  # type: ignore[index]
    steps(sim, 1, ("appear.wa",))
    steps(sim, 4, REQ=number(sim, "X1-X2"))
    assert sim.is_on("V_X2_1") and sim.is_on("CN_P1")
    assert not on(sim, "YS_X1")
    first = steps(sim, 1, REQ=swing)
    assert on(sim, "YS_X1") and on(sim, "YR_P1"), "stop in the scan in which the points are driven"
    assert "V_X2_2" in first[0] and "V_X2_1" not in first[0] and "VF_X2" not in first[0]
    steps(sim, 4)
    assert sim.is_on("VF_X2") and sim.is_on("at.P1.R") and on(sim, "YS_X1")  # it has turned; X1 opens when asked again
    steps(sim, 2, REQ=number(sim, "X1-X2"))
    assert not on(sim, "YS_X1")
    steps(sim, 1, ("accept.X1",))
    steps(sim, 2, ("head.W.wa",))
    steps(sim, 4, REQ=swing)
    assert sim.is_on("V_X2_2") and not sim.is_on("V_X2_1")  # a train is close
