"""Expressions under every reader: truth tables, vectors of runs, clauses in both directions and in one."""

from __future__ import annotations

from itertools import pairwise, product

from hypothesis import given, settings
from hypothesis import strategies as st

from interlock.logic.bits import Bits
from interlock.logic.controller import Controller, Equation, Input, Join, Term
from interlock.logic.expr import FALSE, TRUE, Expr, conj, disj, eq, evaluate, neg, settled, var
from interlock.logic.names import spelled
from interlock.proof.engines import Answer, solver
from interlock.proof.engines.plaisted_greenbaum import OneSided
from interlock.proof.engines.tseitin import Cnf
from interlock.sim.run import missing

NAMES = ("a", "b", "c", "d")
leaves = st.sampled_from([TRUE, FALSE, *(var(n) for n in NAMES)])
expressions = st.recursive(
    leaves,
    lambda inner: st.one_of(
        inner.map(neg), st.lists(inner, max_size=4).map(conj), st.lists(inner, max_size=4).map(disj)
    ),
)
ROWS = list(product((0, 1), repeat=len(NAMES)))


def holds(x: Expr, row: tuple[int, ...]) -> bool:
    values = dict(zip(NAMES, row, strict=True))
    return evaluate(x, values.__getitem__, {})


@given(expressions, st.dictionaries(st.sampled_from(NAMES), st.booleans()))
def test_what_some_variables_settle_is_so_whatever_the_others_are(x: Expr, known: dict[str, bool]) -> None:
    rows = [r for r in ROWS if all(r[NAMES.index(n)] == value for n, value in known.items())]
    told = settled(x, {spelled(n): value for n, value in known.items()})
    assert told is None or all(holds(x, row) is told for row in rows)
    assert told is not None or len(known) < len(NAMES)


def test_a_number_is_never_settled() -> None:
    """Nothing is known of it: what it may be compared with stays open."""
    number = spelled("n")
    assert settled(disj((eq(number, 1), var("a"))), {number: True, spelled("a"): False}) is None


@given(st.lists(expressions, min_size=1, max_size=5))
def test_runs_side_by_side_are_runs_one_by_one(roots: list[Expr]) -> None:
    """A bit for each row of the truth table."""
    run = Bits({str(n): x for n, x in enumerate(roots)})
    mask = (1 << len(ROWS)) - 1
    vectors = {name: sum(row[k] << n for n, row in enumerate(ROWS)) for k, name in enumerate(NAMES)}
    for name, vector in run(vectors, mask).items():
        assert [bool(vector >> n & 1) for n in range(len(ROWS))] == [holds(roots[int(name)], row) for row in ROWS]


@given(
    st.lists(expressions, min_size=1, max_size=5),
    st.lists(st.tuples(st.sampled_from(NAMES), st.integers(0, 7), st.booleans()), max_size=12),
)
def test_what_is_computed_where_something_has_changed_is_as_if_all_were(
    roots: list[Expr], changes: list[tuple[str, int, bool]]
) -> None:
    named = {str(n): x for n, x in enumerate(roots)}
    run, mask = Bits(named), 7
    vectors, told = dict.fromkeys(NAMES, 0), dict(run(dict.fromkeys(NAMES, 0), mask))
    assert run.changed == told
    for name, vector, again in changes:
        vectors = {**vectors, name: vector}
        if again:
            run.forget()
        found = run(vectors if again else {name: vector}, mask)
        assert found == Bits(named)(vectors, mask)
        assert again or run.changed == {n: x for n, x in found.items() if x != told[n]}
        assert not again or run.changed == found
        told = dict(found)


@given(
    st.lists(expressions, min_size=1, max_size=3),
    st.lists(expressions, min_size=1, max_size=3),
    st.lists(
        st.tuples(st.lists(st.integers(0, 7), min_size=len(NAMES), max_size=len(NAMES)), st.booleans()), max_size=6
    ),
)
def test_a_later_stage_computes_with_what_is_read_then(
    first: list[Expr], last: list[Expr], steps: list[tuple[list[int], bool]]
) -> None:
    """What the first stage has computed is computed again where its variables have changed since."""
    one, two = ({f"{letter}{n}": x for n, x in enumerate(some)} for letter, some in (("a", first), ("b", last)))
    run, mask, before = Bits(one, two), 7, dict.fromkeys(NAMES, 0)
    told: dict[str, int] = {}
    for values, between in steps:
        vectors = dict(zip(NAMES, values, strict=True))
        early = before if between else vectors
        found = run(early, mask)
        assert {n: found[n] for n in one} == Bits(one)(early, mask)
        found = run(vectors, mask, 1)
        assert found == Bits(one | two)(vectors, mask)
        assert {n: x for n, x in found.items() if x != told.get(n)}.items() <= run.changed.items()
        before, told = vectors, dict(found)


def test_a_name_may_stand_for_names_as_deep_as_a_zone_is_long() -> None:
    """A count of sections reads the count before it: neither a run nor its explanation goes down by recursion."""
    wires = [spelled(f"w{n}") for n in range(4000)]
    meaning = {w: conj((var(before), var(spelled("a")))) for before, w in pairwise(wires)}
    meaning[wires[0]] = neg(var(spelled("b")))
    assert Bits({"": meaning[wires[-1]]}, meaning=meaning)({"a": 6, "b": 1}, 7) == {"": 6}
    steps = [Equation(w, Join.ALL, (Term(meaning[w], "counts", f"term of {w}"),), "") for w in wires]
    inputs = tuple(Input(spelled(n), "") for n in ("a", "b"))
    controller = Controller("deep", inputs, (), tuple(steps), (), (), symbols=None)  # type: ignore[arg-type]
    assert missing(controller, wires[-1], {"a": 1, "b": 0}.__getitem__) == []
    assert missing(controller, wires[-1], {"a": 1, "b": 1}.__getitem__) == [f"term of {wires[-1]}"]


@settings(deadline=None)
@given(st.dictionaries(st.sampled_from(("w1", "w2")), expressions), st.lists(expressions, max_size=3), expressions)
def test_clauses_in_one_direction_answer_as_those_in_both(
    meaning: dict[str, Expr], facts: list[Expr], asked: Expr
) -> None:
    """Facts and a question that also read names with a meaning: does the question follow from the facts?"""
    facts = [*facts, *(disj((var(w), conj((var("a"), var("b"))))) for w in meaning)]
    asked = disj((asked, conj(var(w) for w in meaning)))
    rows = [row for row in ROWS if all(true_under(f, meaning, row) for f in facts)]
    follows = all(true_under(asked, meaning, row) for row in rows)
    whole, lean = Cnf(), OneSided(meaning)
    for name, x in meaning.items():
        whole.define(name, x)
    for f in facts:
        whole.require(f)
        lean.require(f)
    answers = []
    for cnf, denial in ((whole, [-whole.literal(asked)]), (lean, lean.denial(asked))):
        sat = solver("minisat", cnf, 1000)
        answers.append(sat.ask(*denial) is Answer.UNSAT)
        assert (sat.ask() is Answer.SAT) == bool(rows), "the question by itself says nothing"
    assert answers == [follows, follows]


def true_under(x: Expr, meaning: dict[str, Expr], row: tuple[int, ...]) -> bool:
    values = dict(zip(NAMES, row, strict=True))
    values |= {w: int(holds(m, row)) for w, m in meaning.items()}
    return evaluate(x, values.__getitem__, {})
