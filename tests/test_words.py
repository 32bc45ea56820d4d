"""The words of routes: every refusal of a hostile hour is explained, and what is named was in the way."""

from __future__ import annotations

import re
from dataclasses import replace
from pathlib import Path
from random import Random

import pytest

from interlock.app.check import check_file
from interlock.checker.scan import execute
from interlock.checker.structured_text import Reader
from interlock.derivation import derive
from interlock.diag import Sink
from interlock.emit.python.runtime import runtime_py
from interlock.frontend import load_text
from interlock.logic import names
from interlock.logic.controller import Controller, MalformedController, Term
from interlock.logic.eval import Machine
from interlock.logic.expr import NOT, TRUE, conj, interning, var, walk
from interlock.logic.lower import lower
from interlock.logic.words import CANCELLING, FREE, OPEN, REFUSED, SET, UNKNOWN, Case, Word, Words
from interlock.model.elements import MachineId, Position
from interlock.proof.equivalence.python_text import compare_runtime
from interlock.proof.equivalence.structured_text import compare_dialect
from interlock.proof.mutation.lines import Lines
from interlock.proof.mutation.switched import Switched
from interlock.proof.system.transition import System
from interlock.st.delivery import write_st
from interlock.st.dialects import BY_NAME
from interlock.verify import Rejected
from tests.layouts import SHIPPED, built
from tests.refusals import hostile_hour, module_of

LAYOUTS = ("fig2_3_split", "crossing_line", "junction")
RULES = {f"R{n}" for n in range(1, 19)}


@pytest.mark.parametrize("name", LAYOUTS)
def test_every_refusal_of_a_hostile_hour_is_explained(name: str) -> None:
    """The named condition is false, and with it and those named after it true the route is granted."""
    hour = hostile_hour(name, 7, 700)
    assert hour.granted >= 10 and hour.refused.total() >= 150 and hour.at_once >= 40, hour
    assert len(hour.refused) >= 6, hour.refused


@pytest.mark.parametrize("name", SHIPPED)
def test_every_route_has_a_word_and_every_code_a_sentence_and_a_rule(name: str) -> None:
    _, table, c = built(name)
    assert set(c.words.routes) == {r.number for r in table.routes}
    values = {x.value for w in c.words.words for x in w.cases if isinstance(x.value, int)}
    assert values - c.words.reasons.keys() <= {OPEN, CANCELLING, SET}
    assert c.words.reasons.keys() <= values
    for r in c.words.reasons.values():
        assert r.text and not r.text.startswith("it needs: no ") and r.rule in RULES, r
    assert len({r.text for r in c.words.reasons.values()}) > len(c.words.reasons) * 0.9


def test_machines_are_told_as_what_they_are() -> None:
    """Of a crossing nothing is detected or lies reverse, and a derailer alone is no set of points."""
    machines = built("flank_lab")[0].machines
    said = [(machines.undetected(m), machines.lie(m, Position.REVERSE)) for m in map(MachineId, ("LC1", "2", "Gs1"))]
    assert said == [
        ("level crossing LC1 is not proved as it is commanded", "level crossing LC1 is closed"),
        ("2 is not detected", "2 lies reverse"),
        ("Gs1 is not detected", "Gs1 is off"),
    ]
    assert machines.trailed(MachineId("2")) == "points 2 were trailed: look at them, and confirm it"


def test_words_say_what_a_railwayman_says() -> None:
    """A crossing is worked and proved, a bridge too; points move and are detected; of trains one is singular."""
    told = {name: {r.text for r in built(name)[2].words.reasons.values()} for name in ("flank_lab", "depot", "heishan")}
    assert {
        "set, waiting for level crossing LC1",
        "set, waiting for derailer Gs1",
        "derailer Gs1 was run over, or has lost its detection: look at it, and confirm it",
        "level crossing LC1 cannot be worked: section g4 is locked",
        "section g4 is not released since the restart, and level crossing LC1 is not proved closed",
        "points 2 cannot move: section w2 is locked",
        "section w6 is locked, and not for a route onward from its signal",
    } <= told["flank_lab"]
    assert {"set, waiting for BRIDGE", "BRIDGE cannot be worked: section brg is locked"} <= told["depot"]
    full = "the zone is full: no more than 4 trains in INSIDE, counting the one for which this route is set"
    assert full in told["heishan"]
    one = Path("layouts/heishan.yaml").read_text("utf-8").replace("trains: 4}", "trains: 1}")
    layout, _ = load_text("one", one, Sink())
    assert layout is not None
    with interning():
        words = lower(layout, derive(layout, Sink())).words
    assert full.replace("4 trains", "one train") in {r.text for r in words.reasons.values()}


@pytest.mark.parametrize("name", SHIPPED)
def test_no_case_asks_for_not_of_what_itself_says_not(name: str) -> None:
    """a AND b, not NOT (NOT a OR NOT b): STruC++ makes C++ of the latter that does not compile."""
    _, _, c = built(name)
    for w in c.words.words:
        nots = [x for x in walk(case.condition for case in w.cases) if x.op is NOT and x.args[0].args]
        assert not [x for x in nots for y in walk(x.args) if y.op is NOT], w.name


def longest(c: Controller) -> Word:
    """The word of a route with the most cases."""
    return max((c.words.by_name[n] for n in c.words.routes.values()), key=lambda w: len(w.cases))


def quiet(controller: Controller) -> dict[str, int]:
    """Everything clear, points normal, nothing asked for."""
    sym = controller.symbols
    lying = [name for (_, position), name in sym.machines.detected.items() if position is Position.NORMAL]
    on = [
        sym.valid,
        *sym.sections.clear.values(),
        *lying,
        *sym.lamp_proof.stop.values(),
        *sym.lamp_proof.clear.values(),
    ]
    return {i.name: 0 for i in controller.inputs} | dict.fromkeys(on, 1)


def test_the_word_of_a_route_from_restart_to_cancellation() -> None:
    _, _, controller = built("fig2_2")
    module = module_of(controller)
    one, sym, base = module.Controller(), controller.symbols, quiet(controller)
    route = sym.routes[0]
    assert one.status(route.id) == (UNKNOWN, "not known: no scan since the restart") and one.why_not(route.id) is None
    one.scan(base, 100)
    assert "is not released since the restart" in one.why_not(route.id)[1] and one.why_not(route.id)[2] == "R16"
    for _ in range(4000):
        one.scan({**base, sym.sections.release_all: 1}, 100)
        one.scan(base, 100)
    assert one.status(route.id) == (FREE, "free") and one.why_not(route.id) is None
    first = route.path.ways[0][0]
    one.scan({**base, **one.request(route.id), sym.sections.clear[first]: 0}, 100)
    assert one.why_not(route.id)[1:] == (f"section {first} is occupied", "R3")
    for _ in range(300):
        one.scan(base, 100)
    one.scan({**base, **one.request(route.id)}, 100)
    assert one.why_not(route.id) is None
    one.scan(base, 100)
    one.scan(base, 100)
    assert one.status(route.id) == (OPEN, "open") and one.countdown_ms(route.id) is None
    approach = sym.cancellation.approach_of[route.entry]
    coming = {sym.sections.clear[approach]: 0} if approach in sym.sections.clear else {}
    one.scan({**base, **coming, sym.cancellation.cancel[route.entry]: 1}, 100)
    one.scan({**base, **coming}, 100)
    left = one.countdown_ms(route.id)
    assert one.status(route.id) == (CANCELLING, "being cancelled")
    one.scan({**base, **coming}, 100)
    assert one.countdown_ms(route.id) == left - 100 > 0
    assert one.status(route.id)[0] == CANCELLING


@pytest.mark.parametrize("name", ["fig2_2", "junction"])
def test_the_reference_and_the_runtime_say_the_same(name: str) -> None:
    _, _, c = built(name)
    one, other, chance = module_of(c).Controller(), Machine(c), Random(3)
    assert set(other.words().values()) == {UNKNOWN}
    for _ in range(40):
        inputs = quiet(c) | {i.name: chance.randrange(i.size or 2) for i in c.inputs if chance.random() < 0.05}
        dt_ms = chance.choice((100, 5000, 60_000))
        before = one.scan(inputs, dt_ms), dict(one.state), dict(one.elapsed)
        other.scan(inputs, dt_ms)
        told = other.words()
        assert one.words() == {number: told[n] for number, n in c.words.routes.items()}
        assert before[1:] == (one.state, one.elapsed)  # who asks changes nothing


def test_nothing_reads_a_word() -> None:
    _, _, c = built("fig2_2")
    word = c.words.words[-1]
    for wrong in (
        lambda: replace(c, next=(replace(c.next[0], terms=(Term(var(word.name), "word"),)), *c.next[1:])),
        lambda: replace(c, words=replace(c.words, words=(word, *c.words.words))),
        lambda: replace(c, words=Words((replace(word, cases=(Case(var(names.spelled("nobody")), 1),)),))),
    ):
        with pytest.raises(MalformedController):
            wrong()


def test_a_runtime_with_another_word_is_refused() -> None:
    _, _, c = built("fig2_2")
    text = runtime_py(c, [])
    assert compare_runtime(c, text).proved
    word = longest(c)
    line = next(x for x in text.split("\n") if x.startswith(f"            {word.name} = self._first("))
    inside = line.split("self._first(")[1].removesuffix(")").split(", ")
    swapped = [*inside[:-5], *inside[-3:-1], *inside[-5:-3], inside[-1]]
    for other in (inside[2:], [inside[0], "1", *inside[2:]], [*inside[:-1], "2"], swapped, ["True", "0", *inside]):
        changed = text.replace(", ".join(inside), ", ".join(other), 1)
        assert changed != text and not compare_runtime(c, changed).proved, other
    code = max(c.words.reasons)
    for old, new in (
        (f"    {code}: (", f"    {code}: ('not ' + "),
        (f"    {code}: ('", f"    {code}: ('x"),
        ("if cases[i]:", "if not cases[i]:"),
        (f"1: {c.words.routes[1]},", f"1: {c.words.routes[2]},"),
        ("        if say:\n", "        if not say:\n"),
        (f"    1: '{c.symbols.cancellation.approach_timer[c.symbols.routes[0].entry]}'", "    1: 'RST'"),
    ):
        assert text.count(old) >= 1 and not compare_runtime(c, text.replace(old, new, 1)).proved, old


def test_the_same_word_written_otherwise_is_proved() -> None:
    """A word is compared code by code where its cases are not those of the controller."""
    _, _, c = built("fig2_2")
    word = longest(c)
    first = word.cases[0]
    twice = replace(word, cases=(first, Case(conj((first.condition, word.cases[1].condition)), 2), *word.cases[1:]))
    said = tuple(twice if w is word else w for w in c.words.words)
    text = runtime_py(replace(c, words=replace(c.words, words=said)), [])
    assert compare_runtime(c, text).proved


def test_a_name_that_was_read_from_a_text_before_is_known() -> None:
    """A unique table may hold nodes of the same names, read from a text, which know nothing of families."""
    checked = check_file("layouts/fig2_2.yaml")
    assert checked.layout is not None and checked.table is not None
    with interning():
        told = lower(checked.layout, checked.table)
    with interning():
        for name in [*(i.name for i in told.inputs), *(s.name for s in told.state), *(s.name for s in told.steps)]:
            var(names.spelled(str(name)))
        again = lower(checked.layout, checked.table)
    assert [r.text for r in again.words.reasons.values()] == [r.text for r in told.words.reasons.values()]
    assert [r.at for r in again.words.reasons.values()] == [r.at for r in told.words.reasons.values()]


def assigned(text: str, name: str, old: str, new: str) -> str:
    """The text with another value in the first place that gives one to a word: `NAME := VALUE;`, `L VALUE; T NAME;`."""
    block = r'(?:#|"\w+"\.|(?:OUTP|D)\.)?'  # of the data, where there is one
    named = re.search(rf"{block}\b{new}\b", text) if not new.isdigit() else None
    said = named[0] if named else new
    text, done = re.subn(rf"(\b{name} := ){block}{old};", rf"\g<1>{said};", text, count=1)
    if done:
        return text
    return re.sub(rf"(\bL +){block}{old}(;.*\n +T +{block}{name};)", rf"\g<1>{said}\g<2>", text, count=1)


@pytest.mark.parametrize("dialect", list(BY_NAME))
def test_a_text_with_another_word_is_refused(dialect: str) -> None:
    _, _, c = built("fig2_2")
    d = BY_NAME[dialect]
    files = write_st(c, d, [])
    assert compare_dialect(c, d, files).proved
    word = longest(c)
    value, does = word.cases[-1].value, word.cases[1].value
    for name, old, new in (
        (word.name, value, 1),
        (word.name, 1, 3),
        (does, 4, 3),
        (does, 2, 32767),
        (does, 2, value),
    ):
        changed = {n: assigned(text, f"{name}", f"{old}", f"{new}") for n, text in files.items()}
        assert changed != files and not compare_dialect(c, d, changed).proved, old


def test_the_second_checker_refuses_whoever_reads_a_word() -> None:
    _, _, c = built("fig2_2")
    text = write_st(c, BY_NAME["iec"], [])["fig2_2.st"]
    state = [*(s.name for s in c.state), *(o.name for o in c.outputs)]
    wires = [*(e.name for e in c.equations), *(f"{s.name}'" for s in c.state), *(f"{o.name}'" for o in c.outputs)]
    assert set(execute(text, state, wires).words) == {w.name for w in c.words.words}
    route, other = c.words.routes[1], c.words.routes[2]
    for old, new, said in (
        ("  OUTP.YS_X1 := ", f"  OUTP.YS_X1 := OUTP.{route} OR ", "where TRUE or FALSE is meant"),
        ("  OUTP.YS_X1 := ", f"  OUTP.YS_X1 := (OUTP.{route} = 3) OR ", "no number"),
        ("  OUTP.YA_P1 := D.AL_P1;", f"  OUTP.YA_P1 := OUTP.{route};", "written with a number"),
        ("  OUTP.YA_P1 := D.AL_P1;", f"  OUTP.YA_P1 := D.AL_P1;\n  OUTP.{other} := 3;", "written twice"),
        ("  OUTP.YA_P1 := D.AL_P1;", "  OUTP.YA_P1 := INP.REQ;", "INP.REQ is not known"),
        (f" OUTP.{route} := 3;", f" OUTP.{other} := 3;", "several variables"),
        (f" OUTP.{route} := 3;", f" OUTP.{route} := 40000;", "no INT"),
        (f" OUTP.{route} := 3;", f" OUTP.{route} := 3; OUTP.{route} := 5;", "at once"),
        (f" OUTP.{route} := 3;", f" OUTP.{route} := D.RT_DP;", "neither a code nor a word"),
        (f" OUTP.{route} := 3;", f" OUTP.{route} := INP.REQ;", "neither a code nor a word"),
        (f"  {route} : INT := 0;", f"  {route} : INT := 1;", "begin with 0"),
    ):
        assert text.count(old) >= 1, old
        with pytest.raises(Rejected, match=said):
            execute(text.replace(old, new, 1), state, wires)


def test_if_without_else_says_nothing_to_the_checker() -> None:
    head = "FUNCTION_BLOCK A\nVAR X : BOOL; W : INT; END_VAR\n"
    whole = "IF X THEN W := 1; ELSIF NOT X THEN W := 2; ELSE W := 3; END_IF;\nEND_FUNCTION_BLOCK\n"
    assert Reader(head + whole).unit().blocks[0].body[0][0] == "if"
    for other in (whole.replace(" ELSE W := 3;", ""), whole.replace("W := 2;", "", 1), whole.replace("END_IF;", ";")):
        with pytest.raises(Rejected):
            Reader(head + other).unit()


@pytest.mark.parametrize(
    ("change", "code"),
    [("open at stop", OPEN), ("free that is refused", FREE), ("refused that is free", REFUSED), ("another name", 0)],
)
def test_a_word_that_is_not_so_is_found(change: str, code: int) -> None:
    """F-WORD: of words that say what is not so."""
    layout, _, c = built("fig2_2")
    word = next(w for w in c.words.words if w.name == c.words.routes[1])
    first, last = word.cases[0], word.cases[-1]
    cases = {
        OPEN: (Case(var(c.symbols.routes[0].active), OPEN), *word.cases[1:]),
        FREE: word.cases[:-1],
        REFUSED: (*word.cases, Case(TRUE, last.value)),
        0: (first, *(x._replace(value=c.words.words[0].name) for x in word.cases[1:])),
    }[code]
    wrong = replace(word, cases=cases)
    told = Words(tuple(wrong if w is word else w for w in c.words.words), c.words.reasons, c.words.routes)
    for controller, good in ((c, True), (replace(c, words=told), False)):
        lines, step = Lines.of(System(layout, controller)), Switched()
        known = [step.define(n, x) for n, x in lines.definitions.items()]
        known += [step.fact(x) for x in (*lines.assumptions, *(x for _, x in lines.invariants))]
        said = [x for n, x in lines.functions if n.startswith("F-WORD")]
        assert (step.model(*known, step.any_false(said)) is None) is good, change


@pytest.mark.parametrize(("where", "rule"), [("exits: [E]", "R12"), ("over: [q6]", "R17")])
def test_a_term_has_the_rule_of_its_cell_in_the_table(where: str, rule: str) -> None:
    """A condition on leaving over a boundary belongs to the line beyond, one on a section is external alone."""
    text = Path("layouts/mine11.yaml").read_text("utf-8") + f"conditions:\n  READY: {{text: ready, {where}}}\n"
    layout, _ = load_text("mine11.yaml", text, sink := Sink())
    assert layout is not None, sink.diagnostics
    table = derive(layout, sink)
    cells = {c.because for r in table.routes for c in r.conditions.external}
    terms = [t for e in lower(layout, table).equations for t in e.terms if t.kind == "condition"]
    assert terms and {(t.rule, t.note) for t in terms} == {(b.rule, b.text) for b in cells}
    assert {t.rule for t in terms} == {rule}
