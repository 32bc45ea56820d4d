"""What the second checker reads of the words of routes: whoever lies to an operator is refused, in text or table."""

from __future__ import annotations

import csv
import io
import re
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

import pytest

from interlock.checker.check import agree
from interlock.checker.outputs import CODE
from interlock.checker.said import Published
from interlock.checker.specification import shipped as specification
from interlock.emit.io import words_csv
from interlock.logic.controller import Controller
from interlock.logic.lower import lower
from interlock.proof.functions import FUNCTIONS
from interlock.verify import Rejected
from tests.grow_all import grow_all
from tests.layouts import SHIPPED, built, grown
from tests.written import shipped, told

OTHERS = (
    "added",
    "air_lock_doors",
    "held_apart",
    "held_longer",
    "boards",
    "clear_beyond",
    "devices",
    "identifier",
    "overlap_berth",
    "spaces",
    "token",
    "turning_loop",
)


def table(name: str) -> Published:
    """The table of a layout's words, as it is written."""
    return published(built(name)[2])


def published(controller: Controller) -> Published:
    rows = list(csv.DictReader(io.StringIO(words_csv(controller))))
    codes = {int(r["Code"]): r["Says"] for r in rows if r["Code"]}
    rules = {int(r["Code"]): r["Rule"] for r in rows if r["Code"]}
    return Published(codes, {r["Word"]: r["Says"] for r in rows if r["Word"]}, rules)


@pytest.mark.parametrize("name", [*SHIPPED, *(f"../tests/layouts_for_tests/{x}" for x in OTHERS)])
def test_text_written_system_words_and_sentences_of_a_layout_say_what_they_should(name: str) -> None:
    source = Path(f"layouts/{name}.yaml").read_text("utf-8")
    found = agree(*told(source), specification(), table(name))
    assert found.left == (), "everything was compared"
    assert "as specified" in found.compared[1]
    assert (
        "words of routes say what is so" in found.compared[4] and "sentences of io/words.csv read" in found.compared[4]
    )


def test_its_sentence_is_that_of_the_function() -> None:
    assert {s["id"]: s["sentence"] for s in specification().told if "sentence" in s} == {"F-WORD": FUNCTIONS["F-WORD"]}


def test_without_a_table_it_says_that_none_was_read() -> None:
    found = agree(*shipped("fig2_2"), specification())
    assert "no table that says what their 14 codes mean" in found.compared[4] and found.left == ()


FALSE_WORDS = {
    "open while at stop": ("IF D.N_S_R1 THEN OUTP.YX_R1", "IF D.N_A_R1 THEN OUTP.YX_R1", "says open"),
    "open a scan late": ("IF D.N_S_R1 THEN OUTP.YX_R1", "IF D.S_R1 THEN OUTP.YX_R1", "says open"),
    "open of another route": ("IF D.N_S_R1 THEN OUTP.YX_R1", "IF D.N_S_R2 THEN OUTP.YX_R1", "says open"),
    "never open": ("IF D.N_S_R1 THEN OUTP.YX_R1 := 3;", "IF D.N_S_R1 THEN OUTP.YX_R1 := 2;", "says set"),
    "free while set": ("ELSIF D.N_A_R1 THEN OUTP.YX_R1 := D.XW_R1;", "", "says refused"),
    "free that would be refused": ("ELSIF NOT D.WF_DP_3 THEN OUTP.YX_R1 := D.XF_DP_3;", "", "says free"),
    "refused that is free": (
        "ELSE OUTP.YX_R1 := 1;",
        "ELSE OUTP.YX_R1 := 10001;",
        "said of two conditions|says refused",
    ),
    "refused at once": ("ELSE OUTP.YX_R1 := 1;", "ELSE OUTP.YX_R1 := 10010;", "says refused"),
    "what has no part in it": (
        "  IF D.K_DP THEN D.XS_DP",
        "  IF D.TR_P1 THEN D.XS_DP := 10012; ELSIF D.K_DP THEN D.XS_DP",
        "has no part in",
    ),
    "what the grant does not ask for": (
        "ELSIF NOT INP.VALID THEN OUTP.YX_R1",
        "ELSIF NOT INP.CLR_SC THEN OUTP.YX_R1 := 10097; ELSIF NOT INP.VALID THEN OUTP.YX_R1",
        "says refused",
    ),
    "cancelling as another signal": ("IF D.N_X_X1 THEN D.XW_R1", "IF D.N_X_X2 THEN D.XW_R1", "says cancelling"),
    "cancelling a scan late": ("IF D.N_X_X1 THEN D.XW_R1", "IF D.X_X1 THEN D.XW_R1", "says cancelling"),
    "cancelled in secret": ("IF D.N_X_X1 THEN D.XW_R1 := 4;", "IF D.N_X_X1 THEN D.XW_R1 := 2;", "says set"),
    "waiting while locked": ("ELSIF D.N_B_R1 THEN D.XW_R1 := 2;", "", "says waiting"),
    "waiting for what lies": ("ELSIF NOT D.QN_P1 THEN D.XW_R1", "ELSIF D.QN_P1 THEN D.XW_R1", "says waiting"),
    "nothing known": ("ELSE OUTP.YX_R1 := 1;", "ELSE OUTP.YX_R1 := 0;", "says unknown"),
    "nothing is named": ("ELSIF D.L_DP_1 THEN D.XS_DP := 10003;", "", "says unknown"),
    "a value that says nothing": ("ELSE OUTP.YX_R1 := 1;", "ELSE OUTP.YX_R1 := 7;", "value 7, which says nothing"),
    "a code that nobody explains": ("D.XC_DP := 10008;", "D.XC_DP := 10098;", "nothing is published of the code 10098"),
    "a code of two conditions": ("D.XC_DP := 10008;", "D.XC_DP := 10009;", "10009 is said of two conditions"),
    "another condition": (
        "NOT INP.CLR_DP THEN D.XC_DP := 10008;",
        "NOT INP.CLR_SA THEN D.XC_DP := 10008;",
        "has no part in",
    ),
    "another that is asked for": (
        "INP.BLK_DP THEN D.XF_DP_3 := 10009;",
        "INP.BLK_DP THEN D.XF_DP_3 := 10010;",
        "10010",
    ),
    "the other direction": ("ELSIF D.L_DP_1 THEN D.XS_DP := 10003;", "ELSIF D.L_DP_1 THEN D.XS_DP := 10004;", "10004"),
}


@pytest.mark.parametrize("which", FALSE_WORDS)
def test_a_word_that_lies_is_refused(which: str) -> None:
    before, after, why = FALSE_WORDS[which]
    body, system, text = shipped("fig2_2")
    assert text.count(before) >= 1, before
    with pytest.raises(Rejected, match=why):
        agree(body, system, text.replace(before, after, 1), specification(), table("fig2_2"))


def exchanged(codes: Mapping[int, str], a: int, b: int) -> dict[int, str]:
    return {**codes, a: codes[b], b: codes[a]}


@pytest.mark.parametrize(("a", "b"), [(10002, 10009), (10003, 10004), (10001, 10008), (10008, 10009), (2, 4), (1, 3)])
def test_exchanged_sentences_are_refused(a: int, b: int) -> None:
    whole = table("fig2_2")
    with pytest.raises(Rejected, match="is published as"):
        agree(*shipped("fig2_2"), specification(), replace(whole, codes=exchanged(whole.codes, a, b)))


def test_machines_that_are_exchanged_are_refused() -> None:
    whole = table("junction")
    a, b = (k for k, v in whole.codes.items() if v.startswith("set, waiting for points"))
    with pytest.raises(Rejected, match="is published as"):
        agree(*shipped("junction"), specification(), replace(whole, codes=exchanged(whole.codes, a, b)))


def test_route_names_that_are_exchanged_are_refused() -> None:
    whole = table("fig2_2")
    for a, b in (("YX_R1", "YX_R2"), ("YX_R1", "YX_R3")):
        words = {**whole.words, a: whole.words[b], b: whole.words[a]}
        with pytest.raises(Rejected, match="calls YX_R1"):
            agree(*shipped("fig2_2"), specification(), replace(whole, words=words))


def test_a_sentence_that_nobody_can_compare_verifies_nothing() -> None:
    """What the specification does not know is told, and then nothing counts as verified."""
    whole = table("fig2_2")
    strange = replace(whole, codes={**whole.codes, 10008: "all is well with section DP"})
    assert agree(*shipped("fig2_2"), specification(), strange).left == (
        "the sentences of the codes 10008 in io/words.csv",
    )


def test_the_lamp_of_a_signal_that_only_protects_is_spoken_of() -> None:
    """A signal from which no route leads lights no lamp; a route is refused for its stop lamp all the same."""
    source = grow_all(93)
    found = grown(source)
    assert found is not None and "the stop lamp of G32 is out" in (its := published(lower(*found[:2]))).codes.values()
    assert agree(*told(source), specification(), its).left == ()


BESIDE = {
    "another route over the way": ("10003", "for route X2-C", "for route X1-A"),
    "a route of the other direction": ("10003", "for route X2-C", "for route X2-C or X1-A"),
    "none": ("10003", " for route X2-C", ""),
    "others that there are none of": ("10003", "for route X2-C", "for route X2-C or another"),
    "a route that is none": ("10003", "for route X2-C", "for route X2-D"),
    "routes where none are listed": ("10008", "is occupied", "is occupied for route X1-A"),
    "one in the sentence of a machine": ("10010", "is locked", "is locked for route X1-A"),
}


@pytest.mark.parametrize("which", BESIDE)
def test_routes_that_are_listed_are_those_that_lead_there(which: str) -> None:
    code, before, after = BESIDE[which]
    whole = table("fig2_2")
    text = whole.codes[int(code)]
    assert before in text
    with pytest.raises(Rejected, match="lists other routes than lead there"):
        agree(
            *shipped("fig2_2"),
            specification(),
            replace(whole, codes={**whole.codes, int(code): text.replace(before, after)}),
        )


@pytest.mark.parametrize("change", ["one left out", "another order", "fewer"])
def test_of_many_routes_the_first_are_listed(change: str) -> None:
    """Three of them and `another`: none of them is left out; how many are named is the table's own business."""
    whole = table("cn6502")
    code, text = next(
        (k, v) for k, v in whole.codes.items() if v.endswith(" for route D7-IIAG or S4-BS.2 or S5-BS or another")
    )
    said = {
        "one left out": text.replace("D7-IIAG or ", ""),
        "another order": text.replace("D7-IIAG or S4-BS.2", "S4-BS.2 or D7-IIAG"),
        "fewer": text.replace(" or S5-BS or another", " or another"),
    }
    lie = replace(whole, codes={**whole.codes, code: said[change]})
    if change == "fewer":
        assert agree(*shipped("cn6502"), specification(), lie).left == ()
        return
    with pytest.raises(Rejected, match="lists other routes than lead there"):
        agree(*shipped("cn6502"), specification(), lie)


@pytest.mark.parametrize(
    ("code", "rule"), [(10008, "R2"), (10003, "R10"), (1001, "R3"), (10010, "R6"), (10001, ""), (3, "R3")]
)
def test_the_rule_beside_a_sentence_is_one_that_asks_for_it(code: int, rule: str) -> None:
    whole = table("fig2_2")
    with pytest.raises(Rejected, match=f"the code {code}|a rule is published for the code {code}"):
        agree(*shipped("fig2_2"), specification(), replace(whole, rules={**whole.rules, code: rule}))


REASON = 'no room for route X: it cannot move: {a} *) "b"'
DEMANDED = (
    "D2 cannot be worked: route X1-X2, which demands D2 open (the other door of the air lock is shut), "
    "is set or not yet cleared"
)


def air_lock(reason: str = "") -> tuple[str, Published]:
    text = Path("tests/layouts_for_tests/air_lock.yaml").read_text("utf-8")
    if reason:
        text = text.replace("the other door of the air lock is shut", f"'{reason}'")
    found = grown(text)
    assert found is not None
    return text, published(lower(*found[:2]))


def test_what_keeps_a_machine_that_a_route_demands_is_told_with_the_reason() -> None:
    """It was told as a route that is declared hostile, where nothing is."""
    text, its = air_lock()
    assert DEMANDED in its.codes.values() and not any("hostile" in x for x in its.codes.values())
    assert agree(*told(text), specification(), its).left == ()


def test_a_reason_may_say_what_sentences_say() -> None:
    text, its = air_lock(REASON)
    assert any(REASON in x for x in its.codes.values())
    assert agree(*told(text), specification(), its).left == ()


LIES = {
    "another machine": ("demands D2", "demands D1"),
    "another position": ("D2 open", "D2 closed"),
    "another reason": ("is shut", "is open"),
    "declared": (", which demands D2 open (the other door of the air lock is shut)", ", declared hostile"),
}


@pytest.mark.parametrize("which", LIES)
def test_another_demand_than_the_author_has_is_none_that_is_known(which: str) -> None:
    text, its = air_lock()
    (code,) = (k for k, x in its.codes.items() if x == DEMANDED)
    lie = replace(its, codes={**its.codes, code: DEMANDED.replace(*LIES[which])})
    assert agree(*told(text), specification(), lie).left == (f"the sentences of the codes {code} in io/words.csv",)


HELD = Path("tests/layouts_for_tests/held_longer.yaml").read_text("utf-8")
TWICE = "  - {point: 2, lies: normal, routes: {from: A}, hold: 45, reason: a steep grade}\n"


def held_longer(more: str) -> tuple[str, Published]:
    found = grown(HELD + more)
    assert found is not None
    return HELD + more, published(lower(*found[:2]))


@pytest.mark.parametrize(("more", "seconds"), [("", 30), (TWICE, 45), (TWICE.replace("45", "45.00004"), 45)])
def test_a_declared_route_that_is_held_longer_is_told_with_the_seconds(more: str, seconds: int) -> None:
    text, its = held_longer(more)
    hostile = {k: x for k, x in its.codes.items() if "declared hostile" in x}
    assert sorted(hostile.values()) == [
        f"route A-N, declared hostile (held {seconds} s longer), is set or not yet cleared",
        "route N-E, declared hostile, is set or not yet cleared",
    ]
    assert agree(*told(text), specification(), its).left == ()
    for code, said in hostile.items():
        for other in (f" (held {seconds} s longer)", " (held 29 s longer)", ""):
            lie = re.sub(r"declared hostile( \(.*?\))?", f"declared hostile{other}", said)
            left = agree(*told(text), specification(), replace(its, codes={**its.codes, code: lie})).left
            assert left == (() if lie == said else (f"the sentences of the codes {code} in io/words.csv",)), lie


def test_the_reasons_of_two_demands_of_one_machine_are_known_as_the_table_tells_them() -> None:
    """VERIFIED was refused to a layout with two demands of one machine, of which the later holds it longer."""
    text, its = held_longer(TWICE)
    both = "which demands 2 normal (overrun; a steep grade; held 45 s longer)"
    (code,) = (k for k, x in its.codes.items() if both in x)
    assert agree(*told(text), specification(), its).left == ()
    for other in (
        "overrun; held 30 s longer",
        "a steep grade; held 45 s longer",
        "a steep grade; overrun; held 45 s longer",
    ):
        lie = its.codes[code].replace("overrun; a steep grade; held 45 s longer", other)
        left = agree(*told(text), specification(), replace(its, codes={**its.codes, code: lie})).left
        assert left == (f"the sentences of the codes {code} in io/words.csv",), other
    idle = TWICE.replace("hold: 45, ", "")  # it adds nothing to the first
    assert agree(*told(held_longer(idle)[0]), specification(), held_longer(idle)[1]).left == ()


def test_the_reasons_of_a_train_route_are_not_those_of_the_call_on_route_over_the_same_way() -> None:
    text = Path("tests/layouts_for_tests/called_on.yaml").read_text("utf-8")
    at, chosen = text.index("hostile:"), "point: 2, lies: normal, routes: {from: A, to: N2"
    text = f"{text[:at]}demand:\n  - {{{chosen}}}, hold: 5, reason: one}}\n"
    text += f"  - {{{chosen}, kind: call-on}}, hold: 15, reason: another}}\n"
    found = grown(text)
    assert found is not None
    its = published(lower(*found[:2]))
    said = [x for x in its.codes.values() if "which demands" in x]
    train, called = (
        "A-N2, which demands 2 normal (one; held 5 s",
        "A-N2.c, which demands 2 normal (one; another; held 15 s",
    )
    assert [any(x in y for y in said) for x in (train, called)] == [True, True], said
    assert agree(*told(text), specification(), its).left == ()


def test_a_comment_ends_as_it_began() -> None:
    """A sentence with `*)` was cut there in the C runtime, and its comment called false."""
    both = "w.X = 10001; /* a *) b */\n W.X := 10002; (* c */ d *)"
    assert [(code, "".join(told)) for _, code, *told in CODE.findall(both)] == [
        ("10001", " a *) b "),
        ("10002", " c */ d "),
    ]


ZONE = "the zone is full: no more than 3 trains in Z, counting the one for which this route is set"


@pytest.mark.parametrize("said", [ZONE, ZONE.replace("3", "2"), ZONE.replace("Z,", "Y,")])
def test_that_a_zone_is_full_is_read(said: str) -> None:
    text = Path("tests/layouts_for_tests/zone_of_called.yaml").read_text("utf-8")
    found = grown(text)
    assert found is not None
    its = published(lower(*found[:2]))
    (code,) = (k for k, x in its.codes.items() if x == ZONE)
    agreed = agree(*told(text), specification(), replace(its, codes={**its.codes, code: said}))
    assert agreed.left == (() if said == ZONE else (f"the sentences of the codes {code} in io/words.csv",))
    assert "not:" not in agreed.compared[4]


def test_a_zone_that_is_called_full_while_another_is_is_a_lie() -> None:
    text = Path("tests/layouts_for_tests/zone_of_called.yaml").read_text("utf-8")
    two = "  Z: {sections: [s8, s10], trains: 1}\n  Y: {sections: [s14], trains: 1}\n"
    text = re.sub("  Z: {sections.*\n", two, text)
    found = grown(text)
    assert found is not None
    its = published(lower(*found[:2]))
    a, b = (k for k, x in its.codes.items() if x.startswith("the zone is full"))
    assert agree(*told(text), specification(), its).left == ()
    with pytest.raises(Rejected, match="is published as 'the zone is full"):
        agree(*told(text), specification(), replace(its, codes=exchanged(its.codes, a, b)))
