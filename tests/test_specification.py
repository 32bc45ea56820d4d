"""The specification: every layout's written system says the same; a forged one does not, nor the same system once the
specification is weakened.  Nothing is proved here: what a forger could prove does not matter."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path

import pytest

from interlock.checker import specification
from interlock.checker.check import agree
from interlock.checker.moves import World
from interlock.checker.plant import define
from interlock.checker.railway import Railway
from interlock.checker.reading import loaded
from interlock.checker.specification import FOLDER, Specification
from interlock.checker.told import Telling
from interlock.checker.written import written
from interlock.logic.lower.index import OverlapIndex
from interlock.logic.plant import ASSUMPTIONS, OF_PLC
from interlock.model.principles import KNOBS, PROFILES
from interlock.proof.claims import CLAIMS
from interlock.verify import Rejected
from tests.written import shipped, told

CLAIMS_TEXT = (FOLDER / "claims.yaml").read_text("utf-8")
PLANT_TEXT = (FOLDER / "plant.yaml").read_text("utf-8")
TOLD_TEXT = (FOLDER / "told.yaml").read_text("utf-8")
OTHERS = (
    *("balloon", "closing", "closing_next", "devices", "foul_beyond"),
    *("overlap_head", "scripts", "spaces", "speeds", "token", "trap_beyond", "undetected"),
)
"""Layouts with what no shipped one has; those are read with their words (`test_said.py`), the others are for the
campaign of certificates."""


@pytest.mark.parametrize("name", OTHERS)
def test_text_and_written_system_say_what_the_specification_says(name: str) -> None:
    source = Path(f"tests/layouts_for_tests/{name}.yaml").read_text("utf-8")
    assert agree(*told(source), specification.shipped()).left == ()


@pytest.mark.parametrize("trains", [1, 9])
def test_so_do_those_of_zones_that_cannot_fill_or_that_nothing_enters_on_one_side(trains: int) -> None:
    source = Path("tests/layouts_for_tests/closing_next.yaml").read_text("utf-8")
    zone = f"zones:\n  Z: {{sections: [l3], trains: {trains}}}\n"
    assert agree(*told(source + zone), specification.shipped()).left == ()


def test_a_layout_with_automatic_routes_has_switches_for_these_and_for_no_others() -> None:
    source = Path("layouts/fig2_2.yaml").read_text("utf-8")
    entry, other = "  - {from: X1, to: A}\n", "  - {from: X3, to: C}\n"
    one, both = (f"{source}automatic:\n{x}" for x in (entry, entry + other))
    assert agree(*told(one), specification.shipped()).left == ()
    _, system, text = told(both)
    with pytest.raises(Rejected, match="S-REQUEST"):
        agree(loaded(one), system, text, specification.shipped())


def test_an_overlap_swings_at_its_own_number_and_not_at_any_that_names_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    source = Path("tests/layouts_for_tests/trap_beyond.yaml").read_text("utf-8")
    right = OverlapIndex.swing_number
    monkeypatch.setattr(OverlapIndex, "swing_number", lambda self, g: right(self, g) + 1)
    told.cache_clear()
    try:
        with pytest.raises(Rejected, match="S-REQUEST"):
            agree(*told(source), specification.shipped())
    finally:
        told.cache_clear()


def test_so_does_one_where_an_overlap_leads_towards_a_boundary_at_which_trains_only_come_in() -> None:
    source = Path("tests/layouts_for_tests/trap_beyond.yaml").read_text("utf-8")
    other = source.replace("traps: [sand]\n", "").replace("normal: sand", "normal: F")
    other = other.replace("tracks:", "  F: {approach: fa 300, trains: in}\ntracks:") + "  XF: {from: F, into: p1}\n"
    assert agree(*told(other), specification.shipped()).left == ()


# --- forged bundles, for layouts of different kinds --------------------------------------------------

KINDS = ("mine11", "junction", "cn6502", "passing_loop")
Forged = tuple[str, str, str]
"""The written system, the text, and what the checker says of them."""


def changed(name: str) -> tuple[str, str]:
    """Written system and text of a layout that waits longer before it releases: a good controller of another one."""
    source = Path(f"layouts/{name}.yaml").read_text("utf-8")
    _, system, text = told(source + "\nprinciples: {release_delay_s: 5}\n")
    return system, text


def with_assumption(system: str, line: str) -> str:
    at = system.index("asm A-TON")
    return f"{system[:at]}asm {line}\n{system[at:]}"


def all_claims_T(name: str, system: str, text: str) -> Forged:
    return re.sub(r"^(claim \S+ \S+) .*$", r"\1 T", system, flags=re.M), text, "lacks what the specification asks"


def an_assumption_F(name: str, system: str, text: str) -> Forged:
    return with_assumption(system, "A-CONTACT (& VALID !VALID)"), text, "assumption A-CONTACT says more"


def an_assumption_dropped_from_the_list(name: str, system: str, text: str) -> Forged:
    left = re.sub(r"^assumed A-ONE-FALSE .*\n", "", system, flags=re.M)
    return left, text, "A-ONE-FALSE is assumed, but not in the list"


def a_weaker_claim_under_the_old_sentence(name: str, system: str, text: str) -> Forged:
    weaker = re.sub(r"^(claim T-DERAIL \S+) (.*)$", r"\1 (| RELALL \2)", system, count=1, flags=re.M)
    return weaker, text, "claim T-DERAIL lacks what the specification asks"


def another_layouts_certificate(name: str, system: str, text: str) -> Forged:
    _, other, _ = shipped("terminus")
    return other, text, ""


def another_layouts_certificate_and_text(name: str, system: str, text: str) -> Forged:
    _, other, its = shipped("terminus")
    return other, its, ""


def a_wrong_controller_with_its_own_correct_certificate_beside_the_shipped_text(
    name: str, system: str, text: str
) -> Forged:
    return changed(name)[0], text, "has 3000 ms in the text, 5000 ms as written"


def one_changed_output_equation(name: str, system: str, text: str) -> Forged:
    return system, re.sub(r"(\n\s*OUTP\.YL_\w+ := )([^;]+);", r"\1NOT (\2);", text, count=1), "the text computes"


def an_invariant_assumed_instead_of_proved(name: str, system: str, text: str) -> Forged:
    invariant = re.search(r"^inv \S+ \S+ (.*)$", system, flags=re.M)
    assert invariant is not None
    forged = with_assumption(system.replace(invariant.group(0) + "\n", ""), f"A-CONTACT {invariant.group(1)}")
    return forged, text, "assumption A-CONTACT says more"


FORGERIES: tuple[Callable[[str, str, str], Forged], ...] = (
    all_claims_T,
    an_assumption_F,
    an_assumption_dropped_from_the_list,
    a_weaker_claim_under_the_old_sentence,
    another_layouts_certificate,
    another_layouts_certificate_and_text,
    a_wrong_controller_with_its_own_correct_certificate_beside_the_shipped_text,
    one_changed_output_equation,
    an_invariant_assumed_instead_of_proved,
)


@pytest.mark.parametrize("name", KINDS)
@pytest.mark.parametrize("forgery", FORGERIES, ids=lambda f: f.__name__)
def test_a_forged_bundle_is_refused(name: str, forgery: Callable[[str, str, str], Forged]) -> None:
    body, system, text = shipped(name)
    forged_system, forged_text, why = forgery(name, system, text)
    assert (forged_system, forged_text) != (system, text)
    with pytest.raises(Rejected) as found:
        agree(body, forged_system, forged_text, specification.shipped())
    assert why in str(found.value)


def test_a_controller_that_waits_too_short_is_refused_with_its_own_text() -> None:
    source = Path("layouts/passing_loop.yaml").read_text("utf-8")
    _, system, text = told(source + "\nprinciples: {release_delay_s: 1}\n")
    with pytest.raises(Rejected, match="D-PRESET lacks"):
        agree(loaded(source), system, text, specification.shipped())


def test_a_controller_of_the_layout_without_its_overlaps_is_refused_with_its_own_text() -> None:
    source = Path("layouts/junction.yaml").read_text("utf-8")
    _, system, text = told(source + "\nprinciples: {overlap_m: 0}\n")
    with pytest.raises(Rejected):
        agree(loaded(source), system, text, specification.shipped())


def test_a_lamp_that_the_layout_does_not_give_a_signal_relaxes_nothing() -> None:
    """A call-on lamp, or an identifier light, that is never lit: what it reads makes no route a call-on route, or one
    that nobody asks for."""
    body, system, _ = shipped("fig2_2")
    more = "".join(f"state {x}_X1\ndef {x}_X1' (& S_R1 !S_R1)\n" for x in ("YO", "YI"))
    plain, forged = (World(Railway(body), written(text)) for text in (system, system + more))
    assert forged.w_own_routes() == plain.w_own_routes() == forged.w_routes()
    for s in plain.r.track.sections:
        ways = plain.w_lockable_for_a_clear_movement(s)
        assert forged.w_lockable_for_a_clear_movement(s) == ways == plain.w_lockable(s)


def test_a_signal_without_a_stop_lamp_has_no_others() -> None:
    body, system, _ = shipped("fig2_2")
    dark = re.sub("(?m)^state YS_X1$\n", "", system)
    with pytest.raises(Rejected, match="has lamps, and none for stop"):
        World(Railway(body), written(dark)).w_opening()


# --- weakenings of the specification: each is noticed at a shipped layout ----------------------------

WEAKENED = {
    "a train passes a signal that it has not accepted": (
        "mine11",
        "(berth(s) or heading_to(s, j)) and accepted(c)",
        "berth(s) or heading_to(s, j)",
    ),
    "a head goes on before it was scanned": ("mine11", "not across(j, s) and scanned(s)\n", "not across(j, s)\n"),
    "a second train accepts while the first passes": (
        "mine11",
        "occupied(before(c)) and not across(joint_of(c), before(c)) and",
        "occupied(before(c)) and",
    ),
    "a machine follows an output of long ago": (
        "mine11",
        "lies(m, x) and (driven(m, other(x)) or was_driven(m, other(x)))",
        "lies(m, x)",
    ),
    "no train changes direction": (
        "mine11",
        "for: t in turning_ways",
        "for: t in turning_ways\n    when: berth(section(t))",
    ),
    "a train comes where one stands": (
        "mine11",
        "(not occupied(outside(b)) or leaves(node(b), outside(b))) and (each t",
        "(each t",
    ),
    "a tail leaves before its train is out": (
        "mine11",
        "(each k in other_ends(s, j): not coming(s, k)) or berth(s)",
        "true or berth(s)",
    ),
    "at a restart trains may run": ("mine11", "(standing(s) <-> occupied(s)) and one", "one"),
    "at a restart delays have been covered by nothing": (
        "mine11",
        "says: covered(g) and not stopped(g)",
        "says: not stopped(g)",
    ),
    "vehicles never stay in a berth": ("depot", "tail_out(s) and not (berth(s) and stays(s))", "tail_out(s)"),
    "a shunting movement passes as a train": (
        "depot",
        "heading_to(s, j) and not (for_trains_only(s, j) and shunting(s))",
        "heading_to(s, j)",
    ),
    "no train overruns a signal": ("junction", "or (some h in overrun_at(s, j): runs_over(h, s, j)))", ")"),
    "a train never comes to a stand": (
        "junction",
        "and not (some g in overlapped_from(s): stand_long(g)) or comes_into(s)",
        "or comes_into(s)",
    ),
    "a train overruns while the overlap turns": (
        "flank_lab",
        "heading_to(before_of(g), node(g))\n      and not (some m in swings_in_time(g): turning(g, m))",
        "heading_to(before_of(g), node(g))",
    ),
    "the neighbour gives what he needs": (
        "passing_loop",
        "he_is_ready(b) and not line_in(b) and",
        "he_is_ready(b) and",
    ),
    "telegrams are made up": ("passing_loop", "chance_telegram(b) and he(b, w) or", "chance_telegram(b) or"),
    "what hangs on a called train is not called": (
        "crossing_line",
        "(moves(s) or drawn(s)) and not gone(s)",
        "moves(s) and not gone(s)",
    ),
    "neighbours may be falsely occupied at once": (
        "mine11",
        "not (falsely(rear(n)) and falsely(front(n)))",
        "not (falsely(rear(n)) and falsely(front(n)) and valid and not valid)",
    ),
    "loss of shunt is excluded": ("mine11", "occupied(s) and occupied'(s) and valid ->", "occupied'(s) and valid ->"),
    "stop is believed at once": ("mine11", "stop_long(g) -> not accepted(c)", "shown_stop(g) -> not accepted(c)"),
    "a contact may lie": (
        "mine11",
        "valid and detected(m, x) -> lies'(m, x)",
        "valid and detected(m, x) and not detected(m, other(x)) -> lies'(m, x)",
    ),
    "a path may be blocked instead of clear": (
        "mine11",
        "(each w in kept_clear(p): steadily_clear(section(w)))",
        "(each w in kept_clear(p): steadily_clear(section(w)) or blocked(section(w)))",
    ),
    "both contacts count as detected": (
        "mine11",
        " and not detected(machine(d), opposite(d)))\n      and (each d in devices",
        ")\n      and (each d in devices",
    ),
    "an open crossing counts as closed": ("crossing_line", "detected(d, R) and not detected(d, N)", "detected(d, R)"),
    "a point may move before a train": (
        "mine11",
        "\n      or (some w in through(s, m): into(s, entry(w)) and lies(w)))",
        ")",
    ),
    "two trains on a diamond if one stands": (
        "junction",
        "(still(section_one(d)) and still(section_two(d)))",
        "(still(section_one(d)) or still(section_two(d)))",
    ),
    "vehicles stand foul": (
        "cn6502",
        "-> (each e in conditions(c, p): holds(e)) and (each s in line_beyond(c, p): steadily_clear(s))\n",
        "-> (each e in conditions(c, p): holds(e)) and (each s in line_beyond(c, p): steadily_clear(s)) or valid\n",
    ),
    "an overlap may be occupied": (
        "junction",
        "(each w in ways(o): steadily_clear(section(w)) and not blocked(section(w)))",
        "(each w in ways(o): (steadily_clear(section(w)) or valid) and not blocked(section(w)))",
    ),
    "an overlap may be blocked": (
        "junction",
        "(each w in ways(o): steadily_clear(section(w)) and not blocked(section(w)))",
        "(each w in ways(o): steadily_clear(section(w)))",
    ),
    "a condition over an overlap may be missing": (
        "../tests/layouts_for_tests/overlap_condition",
        " and (each e in conditions_over(o): holds(e))",
        "",
    ),
    "something may stand foul of an overlap": (
        "../tests/layouts_for_tests/foul_overlap",
        "(each e in conditions_over(o): holds(e)) and nothing_foul(o)",
        "(each e in conditions_over(o): holds(e))",
    ),
    "something may stand foul of a path": (
        "../tests/layouts_for_tests/foul_overlap",
        "\n      and nothing_foul(p)",
        "",
    ),
    "a crossing over an overlap may be open": (
        "../tests/layouts_for_tests/swing_condition",
        " and (each e in devices_over(o): closed_and_detected(e))",
        "",
    ),
    "locks may be given up under a train": (
        "mine11",
        "-> nobody_on_the_way(g) or stopped'(g)",
        "-> nobody_on_the_way(g) or stopped'(g) or valid",
    ),
    "a train is called on beside clear": (
        "passing_loop",
        "calls_on'(g) and lies'(p) -> stop'(g) and",
        "calls_on'(g) and lies'(p) ->",
    ),
    "trains against each other on the line": ("passing_loop", " and not (sends(b) and line_out(b))", ""),
    "a zone that is never full": ("heishan", "must: not too_full(z)", "must: not too_full(z) or valid"),
    "a speed beside stop": (
        "flank_lab",
        "l in speed_lamps(g): lit'(l) -> opens_main'(g)",
        "l in speed_lamps(g): lit'(l) -> opens_main'(g) or stop'(g)",
    ),
    "flank space may be occupied": (
        "flank_lab",
        "after_scan(o) -> quiet(s, x)",
        "after_scan(o) -> quiet(s, x) or valid",
    ),
    "a lock goes without a reason": (
        "mine11",
        "restart_ends(s) -> by_hand(s) or all_by_hand or passed(s)",
        "restart_ends(s) -> by_hand(s) or all_by_hand or passed(s) or valid",
    ),
    "the other crossover lies anyhow": (
        "terminus",
        "shown_over'(w) -> lies'(m, N)",
        "shown_over'(w) -> lies'(m, N) or valid",
    ),
    "an overlap goes at once": (
        "junction",
        "locked_overlap(o) and not locked_overlap'(o) -> swung'(o)",
        "locked_overlap(o) and not locked_overlap'(o) -> swung'(o) or valid",
    ),
    "an overlap goes under a train": ("junction", "at_end(o, w) and stays_locked(w)", "at_end(o, w)"),
    "an overlap goes under a train on its way": ("junction", "at_end(o, w) and stays_locked(w)", "stays_locked(w)"),
    "an overlap goes under a train that nothing keeps": (
        "junction",
        "used(section(w)) and locked'(w) and firm'(",
        "used(section(w)) and firm'(",
    ),
    "a train that stood does not part": (
        "mine11",
        'says: "tail_out(s) and not astray(s)"',
        'says: "tail_out(s) and not astray(s) and not standing(s)"',
    ),
    "what a train passes is open for the next one": (
        "../tests/layouts_for_tests/closing_next",
        "opens_to_train'(c) and not passing'(c)) or (some",
        "opens_to_train'(c)) or (some",
    ),
    "nothing is asked of the way past an identifier light": (
        "../tests/layouts_for_tests/identifier",
        "(opens'(c) and not passing'(c) or calls_past'(c)) and",
        "opens'(c) and not passing'(c) and",
    ),
    "a route runs past a signal at stop": (
        "../tests/layouts_for_tests/identifier",
        "\"opened'(r) -> identifies'(i)\"",
        "\"opened'(r) -> identifies'(i) or valid\"",
    ),
    "shunting movements pass their board": (
        "../tests/layouts_for_tests/boards",
        "locked'(w) and not locked(w) -> for_train'(into_of(g))",
        "locked'(w) and not locked(w) -> for_train'(into_of(g)) or valid",
    ),
    "an excluded route is shown": (
        "depot",
        "shown_along(c, p) -> (some i in passed_by(c, p): (opens'(c) or calls_past'(c)) and identifies'(i))",
        "shown_along(c, p) -> (some i in passed_by(c, p): (opens'(c) or calls_past'(c)) and identifies'(i)) or valid",
    ),
    "a train runs into a trap": (
        "../tests/layouts_for_tests/trap_beyond",
        '"not shown_along(c, p)"',
        '"shown_along(c, p) -> valid"',
    ),
    "a speed is not shown": (
        "../tests/layouts_for_tests/speeds",
        "opens_main'(g) and lies'(p) -> (some l in lamps_within(g, p): lit'(l))",
        "opens_main'(g) and lies'(p) -> (some l in lamps_within(g, p): lit'(l)) or valid",
    ),
    "a signal opens for nothing": ("mine11", "opened'(r) -> set'(r)\"", "opened'(r) -> set'(r) or valid\""),
    "a lamp is lit for nothing": (
        "mine11",
        "(some r in routes_for(c): opened'(r)) or passing'(c)",
        "(some r in routes_for(c): opened'(r)) or passing'(c) or valid",
    ),
    "a claim is left out": ("junction", "  - id: T-DIAMOND\n", "  - id: T-ELSEWHERE\n"),
}


def weakened(before: str, after: str) -> Specification:
    whole = CLAIMS_TEXT.count(before) + PLANT_TEXT.count(before)
    assert whole == 1, f"{whole} times in the specification: {before}"
    return specification.read(CLAIMS_TEXT.replace(before, after), PLANT_TEXT.replace(before, after), TOLD_TEXT)


@pytest.mark.parametrize("which", WEAKENED)
def test_a_weakened_specification_is_noticed(which: str) -> None:
    name, before, after = WEAKENED[which]
    try:
        found = agree(*shipped(name), weakened(before, after))
    except Rejected as e:
        assert "word" not in str(e) and "cannot be read" not in str(e), (
            "noticed for what it says, not for how it is put"
        )
    else:
        assert found.left != ()


# --- the specification as it is read ------------------------------------------------------------------


def test_its_sentences_are_those_of_the_documents() -> None:
    spec = specification.shipped()
    claims = {s["id"]: s["sentence"] for s in spec.claims if "sentence" in s}
    assert claims == CLAIMS
    stated = {s["id"]: s["sentence"] for s in spec.assumptions if "sentence" in s}
    assert {**stated, **spec.guards} == ASSUMPTIONS | OF_PLC


def test_every_assumption_is_named_where_it_is_made() -> None:
    spec = specification.shipped()
    named = {a for s in [*spec.moves, *spec.claims] for a in specification.under(s)}
    assert set(spec.guards) <= named


def test_its_principles_are_those_of_the_profiles() -> None:
    book = loaded((FOLDER / "principles.yaml").read_text("utf-8"))
    elsewhere = book.pop("elsewhere")
    assert {*book["generic"], *elsewhere} == set(KNOBS)
    for profile, rules in PROFILES.items():
        for knob, value in {**book["generic"], **book[profile]}.items():
            assert str(getattr(rules, knob)) in (value, f"{value}.0", {"yes": "True", "no": "False"}.get(value))


def test_every_word_is_used_and_none_is_explained_in_vain() -> None:
    tokens: set[str] = set()

    def read(x: object) -> None:
        if isinstance(x, dict):
            for k, v in x.items():
                if k in ("for", "must", "because", "says", "when") or (k == "routes" and isinstance(v, str)):
                    tokens.update(re.findall(r"[A-Za-z_]\w*", v))
                elif k == "words":
                    tokens.update(t for s in v.values() for t in re.findall(r"[A-Za-z_]\w*", s))
                else:
                    read(v)
        elif isinstance(x, list):
            for y in x:
                read(y)

    read(loaded(CLAIMS_TEXT))
    read(loaded(PLANT_TEXT))
    read(loaded(TOLD_TEXT))
    known, explained = {n[2:] for n in dir(Telling) if n.startswith("w_")}, set(specification.shipped().words)
    assert known <= tokens and explained <= tokens
    assert not known & explained, "no word has two meanings"


def test_two_elements_of_one_name_are_no_layout() -> None:
    """One approach section at two boundaries: what is so of the one would be so of the other."""
    source = Path("layouts/fig2_3_split.yaml").read_text("utf-8")
    one = re.sub(r"(?m)^(  [BD]: \{approach: )\w+", r"\1SB", source)
    assert one.count("approach: SB") == 2
    _, system, _ = shipped("fig2_3_split")
    world = Telling(Railway(loaded(one)), written(system))
    with pytest.raises(Rejected, match="two elements of the layout have the same name"):
        define(world, specification.shipped())
