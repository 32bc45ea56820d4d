"""Single weakenings: each kind fails a claim, or is shown redundant by the proof."""

from __future__ import annotations

import pytest

from interlock.proof.claims import CLAIMS
from interlock.proof.engines.limits import Limits
from interlock.proof.mutation.judge import Fate as MutantFate
from interlock.proof.mutation.movements import Fate, judge, run_mutants
from interlock.proof.mutation.texts import TEXT_KINDS, text_mutants
from interlock.proof.mutation.weakenings import KINDS
from tests.layouts import built

NO_SEARCH = Limits(search_depth=0)

# where the rest of the controller protects without the condition; the long campaign says the same
REDUNDANT = {
    "proceed-before-lock": "W is set only by the lock itself",
    "signal-open-behind-train": "the occupied section closes the signal as well",
    "proceed-on-lost-input": "sections read occupied when inputs are lost",
    "use-without-rear": "a train that is only reported is no danger behind the approach locking delay",
    "use-while-stale": "stale sections are released by hand",
    "flank-not-held": "the flank points lie in the locked section itself, or a signal protects too",
}
FLANK = "../tests/layouts_for_tests/flank_point"
SHUNT = "../tests/layouts_for_tests/shunt_yard"
DEVICES = "../tests/layouts_for_tests/devices"
OVERLAPS = "../tests/layouts_for_tests/overlaps"
CLOSING = "../tests/layouts_for_tests/closing"
TOKEN = "../tests/layouts_for_tests/token"
ADDED = "../tests/layouts_for_tests/added"
HELD = "../tests/layouts_for_tests/held_apart"
DOORS = "../tests/layouts_for_tests/air_lock_doors"
SWING = "../tests/layouts_for_tests/swing"
BOARDS = "../tests/layouts_for_tests/boards"
IDENTIFIER = "../tests/layouts_for_tests/identifier"
OVERLAP_FLANK = "../tests/layouts_for_tests/overlap_flank"
ENTRY = "../tests/layouts_for_tests/entry_speeds"
BARE = "../tests/layouts_for_tests/bare_signal"
# the layout on which a kind has mutants
ON = {
    "way-not-available": "../tests/layouts_for_tests/foul_joint",
    "diamond-not-excluded": "junction",
    "approach-one-section": "junction",
    **dict.fromkeys(("door-beside-open", "doors-at-once"), "../tests/layouts_for_tests/air_lock_doors"),
    **dict.fromkeys(("blocked-point-moves", "blocked-drive-runs"), "junction"),
    "starts-under-train": "cn6502",
    "flank-missing": FLANK,
    "flank-wrong": FLANK,
    "withdraw-occupied": FLANK,
    "berth-under-train": SHUNT,
    "lamp-not-proved": SHUNT,
    "lamp-not-lit": SHUNT,
    "clear-lamp-not-lit": SHUNT,
    "clear-before-stop": OVERLAPS,
    **dict.fromkeys(("closes-late", "stays-open", "open-while-released", "passing-not-supervised"), CLOSING),
    **dict.fromkeys((k.name for k in KINDS if k.name.startswith("direction-")), TOKEN),
    **dict.fromkeys((k.name for k in KINDS if k.name.startswith("swing-")), SWING),
    "speed-too-high": "../tests/layouts_for_tests/speeds",
    "entry-speed-forgotten": ENTRY,
    "speed-not-shown": "../tests/layouts_for_tests/speeds",
    "one-yellow": SHUNT,
    "approach-not-asked": "../tests/layouts_for_tests/two_before",
    "order-not-asked": SHUNT,
    "arrived-unseen": "../tests/layouts_for_tests/berth_before",
    "route-not-indicated": "../tests/layouts_for_tests/indicator",
    "excluded-offered": BARE,
    "trap-entered": "../tests/layouts_for_tests/trap_beyond",
    "entrance-left-by": "../tests/layouts_for_tests/no_calling_on",
    **dict.fromkeys(("declared-not-excluded", "added-point-not-detected", "added-let-go"), ADDED),
    **dict.fromkeys((k.name for k in KINDS if k.name.startswith(("held-", "hold-"))), HELD),
    "added-to-called-on-forgotten": "../tests/layouts_for_tests/called_on",
    "added-not-clear": "../tests/layouts_for_tests/clear_beyond",
    "board-passed": BOARDS,
    **dict.fromkeys((k.name for k in KINDS if k.name.startswith("identifier-")), IDENTIFIER),
    "zone-not-checked": "heishan",
    "fault-ignored": "pit_bottom",
    "zone-miscounted": "heishan",
    "flank-space-not-checked": "flank_lab",
    **dict.fromkeys((k.name for k in KINDS if k.name.startswith("call-on-")), "passing_loop"),
    "berth-from-both-ends": SHUNT,
    "berth-read-once": SHUNT,
    "arrived-early": SHUNT,
    "arrived-running": "../tests/layouts_for_tests/berth_before",
    "berth-released-early": SHUNT,
    "driven-while-locked": "../tests/layouts_for_tests/driven",
    "foul-not-checked": "../tests/layouts_for_tests/foul_joint",
    "device-missing": DEVICES,
    "device-wrong": DEVICES,
    "opens-under-train": DEVICES,
    **dict.fromkeys((k.name for k in KINDS if k.name.startswith("overlap-")), OVERLAPS),
    "overlap-flank-not-held": OVERLAP_FLANK,
    "overlap-beside": "../tests/layouts_for_tests/overlap_past_both_ways",
    "overlap-let-go": "../tests/layouts_for_tests/overlap_past_signals",
    "overlap-under-train": "../tests/layouts_for_tests/overlap_past_signals",
    "overlap-free-of-one": "../tests/layouts_for_tests/overlap_past_signals",
    "overlap-inside": "../tests/layouts_for_tests/overlap_inside",
}


@pytest.mark.parametrize("kind", [k.name for k in KINDS if k.name not in REDUNDANT])
def test_each_kind_is_killed_somewhere(kind: str) -> None:
    layout, table, _ = built(ON.get(kind, "fig2_3_split"))
    sample = 0 if kind in ("swing-into-held", "overlap-timed-early") else 2
    assert any(o.fate is not Fate.REDUNDANT for o in run_mutants(layout, table, sample, NO_SEARCH, only=(kind,)))


@pytest.mark.parametrize("kind", ["proceed-on-lost-input", "proceed-before-lock"])
def test_redundant_kinds_are_shown_redundant(kind: str) -> None:
    layout, table, _ = built("fig2_2")
    assert {o.fate for o in run_mutants(layout, table, 1, NO_SEARCH, only=(kind,))} == {Fate.REDUNDANT}


def test_a_killed_mutant_has_a_train_movement() -> None:
    layout, table, _ = built("fig2_2")
    kind = next(k for k in KINDS if k.name == "release-occupied")
    place, controller = next(kind.make(layout, table))
    outcome = judge(layout, kind.name, place, controller, Limits(search_depth=12, search_s=60))
    assert outcome.fate is Fate.KILLED and len(outcome.story) >= 4


def test_at_least_twelve_kinds() -> None:
    assert len({k.name for k in KINDS}) == len(KINDS) >= 30


def _killers() -> dict[str, tuple[str, str]]:
    """For each claim a kind of mutant that fails it, and the layout on which it does."""
    split, two, foul = "fig2_3_split", "fig2_2", "../tests/layouts_for_tests/foul_joint"
    return {
        "T-COLLISION": (two, "hostile-not-excluded"),
        "T-DIAMOND": ("junction", "diamond-not-excluded"),
        "T-FOUL": (foul, "diamond-not-excluded"),
        "T-DERAIL": (two, "point-wrong"),
        "T-POINT-MOVES": (two, "point-missing"),
        "T-ROAD": (DEVICES, "device-missing"),
        "T-FLANK": (FLANK, "flank-missing"),
        "T-SCISSORS": ("terminus", "flank-missing"),
        "S-SCISSORS": ("terminus", "flank-missing"),
        "S-EXCLUDED": (BARE, "excluded-offered"),
        "S-DECLARED": (ADDED, "declared-not-excluded"),
        "S-DEMANDED": (ADDED, "added-point-not-detected"),
        "T-LINE": (TOKEN, "direction-given-early"),
        "S-DIRECTION": (TOKEN, "direction-not-checked"),
        "S-OPPOSING": (two, "hostile-not-excluded"),
        "S-HOSTILE": (SHUNT, "berth-under-train"),
        "S-CLEAR": (split, "section-not-checked"),
        "S-FLANK-SPACE": ("flank_lab", "flank-space-not-checked"),
        "S-BOARD": (BOARDS, "board-passed"),
        "S-IDENTIFIER": (IDENTIFIER, "identifier-not-shown"),
        "T-ZONE": ("heishan", "zone-not-checked"),
        "S-PASSING": (CLOSING, "stays-open"),
        "S-CALL-ON": ("passing_loop", "call-on-blind"),
        "S-DETECTED": (two, "detection-not-required"),
        "S-OVERLAP": (OVERLAPS, "overlap-not-checked"),
        "S-LOCKED": (two, "point-wrong"),
        "S-FLANK": (FLANK, "flank-missing"),
        "S-CONDITION": (foul, "foul-not-checked"),
        "S-BLOCKED": (two, "blocked-not-checked"),
        "S-LOST-INPUT": (two, "validity-not-wired"),
        "S-ASPECT": (OVERLAPS, "clear-before-stop"),
        "S-AGAIN": (two, "opens-by-itself"),
        "S-TRAILED": (two, "trailed-not-kept-back"),
        "S-SPEED": ("../tests/layouts_for_tests/speeds", "speed-too-high"),
        "S-ENTRY": (ENTRY, "entry-speed-forgotten"),
        "S-LAMP": (SHUNT, "lamp-not-proved"),
        "S-CANCELLED": (two, "cancel-not-obeyed"),
        "L-CLEAR": (two, "clear-not-counted"),
        "L-APPROACH": ("junction", "approach-one-section"),
        "L-RELEASE": (two, "release-occupied"),
        "L-HELD": (two, "restart-release-occupied"),
        "P-LOCKED": (two, "point-free-while-locked"),
        "P-BLOCKED": ("junction", "blocked-point-moves"),
        "P-AIR-LOCK": (DOORS, "door-beside-open"),
        "P-START": (two, "restart-unlocked"),
        "S-STOP": (two, "stop-lamp-dark"),
        "P-DRIVEN": (two, "machine-not-driven"),
        "I-TOLD": (two, "indication-dark"),
        "D-PRESET": (two, "delay-too-short"),
        "S-REQUEST": (two, "number-held"),
        "S-SET": (two, "set-while-occupied"),
        "L-REASON": (two, "released-by-nobody"),
    }


ALONE = {
    "excluded-offered": (BARE, "S-EXCLUDED"),
    "trap-entered": ("../tests/layouts_for_tests/trap_beyond", "S-EXCLUDED"),
    "entrance-left-by": ("../tests/layouts_for_tests/no_calling_on", "S-EXCLUDED"),
    "call-on-unasked": ("../tests/layouts_for_tests/trap_beyond", "S-CALL-ON"),
    "speed-not-shown": ("../tests/layouts_for_tests/speeds", "S-SPEED"),
    "swing-misread": ("../tests/layouts_for_tests/trap_beyond", "S-REQUEST"),
    "request-kept": ("fig2_3_split", "S-AGAIN"),
    "opens-after-block": ("fig2_3_split", "S-AGAIN"),
    "blocked-point-moves": ("junction", "P-BLOCKED"),
    "blocked-drive-runs": ("junction", "P-BLOCKED"),
    "door-beside-open": (DOORS, "P-AIR-LOCK"),
    "doors-at-once": (DOORS, "P-AIR-LOCK"),
    "starts-under-train": ("cn6502", "P-LOCKED"),
    "berth-read-once": (SHUNT, "S-SET"),
    "call-on-after-loss": ("passing_loop", "S-AGAIN"),
    "trailed-unseen": ("fig2_2", "S-TRAILED"),
    "trailed-uncommanded": ("fig2_2", "S-TRAILED"),
    "added-let-go": (ADDED, "S-DECLARED"),
    "held-no-longer": (HELD, "S-DEMANDED"),
    "held-from-the-grant": (HELD, "S-DEMANDED"),
    "hold-begun-under-way": (HELD, "S-DEMANDED"),
    "hold-not-begun-anew": (HELD, "S-DEMANDED"),
    "added-to-called-on-forgotten": ("../tests/layouts_for_tests/called_on", "S-DECLARED"),
    "added-not-clear": ("../tests/layouts_for_tests/clear_beyond", "S-DEMANDED"),
}
"""Kinds that one claim alone keeps out, each on a layout where that is so: nobody would come to harm by them."""


@pytest.mark.parametrize("kind", ALONE)
def test_what_the_author_forbids_is_kept_out_by_its_own_claim_alone(kind: str) -> None:
    name, claim = ALONE[kind]
    layout, table, _ = built(name)
    outcomes = run_mutants(layout, table, 1, NO_SEARCH, only=(kind,))
    assert [o.claims for o in outcomes] == [(claim,)]


def test_a_killer_is_named_for_every_claim() -> None:
    assert set(_killers()) == set(CLAIMS)


@pytest.mark.parametrize("claim", sorted(_killers()))
def test_each_claim_is_failed_by_some_mutant(claim: str) -> None:
    name, kind = _killers()[claim]
    layout, table, _ = built(name)
    assert any(claim in o.claims for o in run_mutants(layout, table, 8, NO_SEARCH, only=(kind,)))


@pytest.mark.parametrize("name", [SHUNT, DEVICES, OVERLAPS])
def test_every_kind_makes_controllers_on_the_layouts_of_every_rule(name: str) -> None:
    layout, table, _ = built(name)
    made = {k.name: sum(1 for _ in k.make(layout, table)) for k in KINDS}
    assert sum(made.values()) > 100


def test_every_kind_of_edit_of_the_texts_is_refuted_somewhere() -> None:
    found = list(text_mutants(built("fig2_2")[2], 2))
    refuted = {m.family for m, v in found if v.fate is MutantFate.TEXT}
    assert refuted >= set(TEXT_KINDS) - {"text-statements-exchanged"}
    kept = ("exchanged", "swapped", "operand-dropped")
    for m, v in found:  # whatever keeps its meaning only moved statements, or an operand that another one implies
        assert v.fate is MutantFate.TEXT or any(x in m.family for x in kept), m
    assert {v.fate for _, v in found} == {MutantFate.TEXT, MutantFate.EQUIVALENT}
