"""The emitted text equals the controller: proved output by output, base case and step.

The text is parsed back by our own grammar and executed symbolically, from any values that its variables may have kept
from the scan before; every state variable's initial and next value, every timer's input and preset, and every output
must be the same function as in the controller.  That is compared at the end of the scan; so that nobody who looks in
its midst sees anything else, a text that writes a variable twice in a scan is refused.

Where a variable of the text gets the very expression that the controller has for the wire of its name, the wire's name
stands for it in what follows: by the order of the text, each name then stands for what the controller computes.

**Theorem.**  If text and controller begin with equal states, and compute equal next states, timer inputs and outputs
from equal states, inputs and timers, then their outputs are equal in every scan of every run.  (Induction over scans;
sequential equivalence with corresponding registers: van Eijk, 2000.)
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace

from interlock.dataclass import dataclass
from interlock.logic.controller import Controller
from interlock.logic.expr import FALSE, TRUE, Expr, Substitution, conj, disj, iff, neg, var, variables
from interlock.logic.names import Name, computed, spelled
from interlock.logic.words import UNKNOWN
from interlock.proof.engines import Answer
from interlock.proof.engines.minisat import MiniSat
from interlock.proof.engines.tseitin import Cnf
from interlock.st.ast import Unit
from interlock.st.dialects import BY_NAME
from interlock.st.dialects.dialect import Dialect, Files
from interlock.st.meaning import BadText, Cases, Constant, Execution, Symbol, Symbols, Term
from interlock.st.parser import NotInSubset
from interlock.st.restart import RESTART


@dataclass(frozen=True)
class Difference:
    """A place where text and controller differ, with an input that tells them apart."""

    name: str
    text: str


@dataclass(frozen=True)
class Translation:
    """`proved` when no difference is possible."""

    compared: int
    differences: tuple[Difference, ...]

    @property
    def proved(self) -> bool:
        """Whether text and controller are equal."""
        return not self.differences


def compare_st(controller: Controller, text: str) -> Translation:
    """Compare a Structured Text file with its controller."""
    return compare_dialect(controller, BY_NAME["iec"], {"text": text})


def compare_dialect(controller: Controller, dialect: Dialect, files: Files) -> Translation:
    """Compare the files of a dialect with their controller."""
    try:
        unit = dialect.read(files)
    except (NotInSubset, KeyError) as error:
        return Translation(0, (Difference("text", f"cannot be read: {error}"),))
    return compare_unit(controller, unit, dialect.restart)


def compare_unit(controller: Controller, unit: Unit, restart: bool) -> Translation:
    """Compare what was read of an interlocking with its controller; `restart`: it has an input RESTART."""
    try:
        found = compare_scan(controller, _scan(controller, unit, restart))
        found = replace(found, differences=(*found.differences, *_beginning(controller, unit, restart)))
        return _restarted(controller, unit, found) if restart else found
    except (BadText, KeyError) as error:
        return Translation(0, (Difference("text", f"cannot be read: {error}"),))


def _beginning(controller: Controller, unit: Unit, restart: bool) -> Iterator[Difference]:
    """What is wrong with inputs and outputs before the first scan, with types, and with blocks that no other calls."""
    start: dict[str, int] = {o.name: int(o.restrictive) for o in controller.outputs}
    start |= {i.name: int(i.restrictive) for i in controller.inputs}
    start |= dict.fromkeys(controller.words.routes.values(), UNKNOWN)
    start |= {RESTART: 1} if restart else {}
    for d in (*unit.blocks[-1].outputs, *unit.blocks[-1].inputs):
        first = int(getattr(d.initial, "value", 0))
        if first != start.get(d.name, first):
            yield Difference(d.name, "begins with another value")
    numbers = {str(w.name) for w in controller.words.words} | {i.name for i in controller.inputs if i.size}
    for b in unit.blocks:
        for d in (*b.inputs, *b.outputs, *b.locals):
            if d.type in ("BOOL", "INT") and (d.type == "INT") != (d.name in numbers):
                yield Difference(d.name, f"is of type {d.type}")
            if not d.begins_as_typed:
                yield Difference(d.name, f"is of type {d.type}, and begins with a value of another")
    used = {d.type.upper() for b in unit.blocks for d in (*b.locals, *b.handed)}
    for b in unit.blocks[:-1]:
        if b.name.upper() not in used:
            yield Difference(b.name, "is a block that no other calls")


@dataclass(frozen=True)
class Scan:
    """What a text computes in one scan from its initial state variables by name.

    words: those of the routes.
    """

    base: dict[str, Term]
    after: dict[str, Term]
    outputs: dict[str, Term]
    timers: dict[str, tuple[Expr, int]]
    words: Mapping[str, Term]


def _scan(controller: Controller, unit: Unit, restart: bool = False, restarting: bool = False) -> Scan:
    algebra = Symbols(
        timer_names={f"TON_{t.name}": t.name for t in controller.timers},
        known=wires(controller),
        words=words(controller),
    )
    run: Execution[Term] = Execution(unit, algebra, kept)
    holders = _holders(controller, run)
    base = {n: values[n] for n, values in holders.items()}
    run.main.forget()
    for s in controller.state:
        holders[s.name][s.name] = var(s.name)
    inputs: dict[str, Term] = {i.name: Symbol(i.name) if i.size else var(i.name) for i in controller.inputs}
    if restart:
        inputs[RESTART] = TRUE if restarting else FALSE
    outputs = run.scan(inputs)
    after = {n: values[n] for n, values in _holders(controller, run).items()}
    said: dict[str, Term] = {n: outputs.pop(n) for n in controller.words.routes.values() if n in outputs}
    return Scan(base, after, outputs, dict(algebra.timers), said)


def wires(controller: Controller) -> dict[str, tuple[Expr, Expr]]:
    """By the names that they have in a text: the controller's wires and next values, and what stands for each."""
    found: dict[str, tuple[Expr, Expr]] = {computed(e.name): (e.expr, _next(e.name)) for e in controller.next}
    found |= {e.name: (e.expr, var(e.name)) for e in controller.equations}
    other = {i.name for i in controller.inputs} | {t.name for t in controller.timers}
    for name in other | {s.name for s in controller.state}:
        found.pop(name, None)
    return found


def words(controller: Controller) -> dict[str, Term]:
    """The words of a controller by name, as a text has them: next values by a name that no text can have."""
    put = Substitution({computed(s.name): _next(s.name) for s in controller.state})
    told: dict[int | Name, Term] = {}
    found: dict[str, Term] = {}
    for w in controller.words.words:
        for value in (*[c.value for c in w.cases], w.otherwise):
            if value not in told:
                told[value] = Constant(value) if isinstance(value, int) else Symbol(value)
        found[w.name] = Cases(tuple([(put(c.condition), told[c.value]) for c in w.cases]), told[w.otherwise])
    return found


def _next(state: Name) -> Expr:
    """The next value of a state variable, by a name that no text can have."""
    return var(state.next)


def kept(path: str, start: Term) -> Term:
    """What a variable keeps from the last scan may be anything: whoever reads it before it is written differs."""
    unknown = spelled(f"kept {path}")
    return var(unknown) if isinstance(start, Expr) else Symbol(unknown)


def _restarted(controller: Controller, unit: Unit, found: Translation) -> Translation:
    """With RESTART the scan ends in the initial state with timers stopped and its outputs, whatever was kept."""
    scan = _scan(controller, unit, True, True)
    initial = {s.name: TRUE if s.initial else FALSE for s in controller.state}
    start = Substitution(initial)
    wrong = [Difference(n, "RESTART does not set it") for n, x in initial.items() if scan.after.get(n) is not x]
    for o in controller.outputs:
        if scan.outputs.get(o.name) is not start(o.expr):
            wrong.append(Difference(o.name, "RESTART does not make it restrictive"))
    for n in controller.words.routes.values():
        if scan.words.get(n) != Constant(UNKNOWN):
            wrong.append(Difference(n, "RESTART does not make it say that nothing is known"))
    for t in controller.timers:
        if scan.timers.get(t.name, (TRUE, 0))[0] is not FALSE:
            wrong.append(Difference(t.name, "RESTART does not stop it"))
    return Translation(found.compared + len(initial), (*found.differences, *wrong))


def _holders(controller: Controller, run: Execution[Term]) -> dict[str, dict[str, Term]]:
    """For each state variable, the variables of the block that keeps it: one for state, or the one for everything."""
    own = {d.name for d in run.main.block.locals}
    out: dict[str, dict[str, Term]] = {s.name: run.main.values for s in controller.state if s.name in own}
    for inst in run.main.inner.values():
        out |= {n: inst.values for n in inst.block.output_names if f"N_{n}" in inst.start}
    return out


def compare_scan(controller: Controller, scan: Scan) -> Translation:
    """Compare what a text computes with the controller."""
    wrong: list[Difference] = []
    pairs: list[tuple[str, Expr, Expr]] = []
    following = {e.name: _next(e.name) for e in controller.next}
    for s in controller.state:
        if scan.base.get(s.name) is not (TRUE if s.initial else FALSE):
            wrong.append(Difference(s.name, "another initial value"))
        mine = scan.after.get(s.name)
        if isinstance(mine, Expr):
            pairs.append((s.name, mine, following[s.name]))
        else:
            wrong.append(Difference(s.name, "missing in the text"))
    new = Substitution(following)
    for o in controller.outputs:
        mine = scan.outputs.get(o.name)
        if isinstance(mine, Expr):
            pairs.append((o.name, mine, new(o.expr)))
        else:
            wrong.append(Difference(o.name, "missing in the text"))
    if set(scan.outputs) != {o.name for o in controller.outputs}:
        wrong.append(Difference("outputs", "the text has other outputs"))
    by_name = dict(scan.timers)
    for t in controller.timers:
        got = by_name.pop(t.name, None)
        if got is None or got[1] != t.preset_ms:
            wrong.append(Difference(t.name, "timer missing or another time"))
        else:
            pairs.append((t.name, got[0], var(t.input)))
    wrong.extend(Difference(n, "a timer that the controller lacks") for n in by_name)
    pairs.extend(_words(controller, scan.words, wrong))
    if other := [(n, a, b) for n, a, b in pairs if a is not b]:
        wrong.extend(_different(controller, other))
    return Translation(len(pairs) + len(controller.state), tuple(wrong))


def _words(controller: Controller, given: Mapping[str, Term], wrong: list[Difference]) -> list[tuple[str, Expr, Expr]]:
    """What is left to compare of the words of routes: a word whose cases are those of the controller, name by name, is
    equal; of another, when it has each of its codes."""
    out: list[tuple[str, Expr, Expr]] = []
    told: dict[str, dict[int, Expr]] = {}
    for name in controller.words.routes.values():
        mine = given.get(name)
        if mine is None or isinstance(mine, Expr):
            wrong.append(Difference(name, "missing in the text, or a truth value"))
        elif mine == Symbol(name):
            out.append((name, TRUE, TRUE))
        else:
            if not told:
                for n, x in words(controller).items():
                    told[n] = _codes(x, told)
            try:
                codes = _codes(mine, told)
            except KeyError as error:
                wrong.append(Difference(name, f"reads {error}, which is no word"))
                continue
            both = codes.keys() | told[name].keys()
            out += [(f"{name} = {k}", codes.get(k, FALSE), told[name].get(k, FALSE)) for k in sorted(both)]
    if set(given) != set(controller.words.routes.values()):
        wrong.append(Difference("words", "the text has other words"))
    return out


def _codes(x: Term, told: Mapping[str, dict[int, Expr]]) -> dict[int, Expr]:
    """When an integer has each of its values.  Raises KeyError for one that is no word."""
    if isinstance(x, Constant):
        return {x.value: TRUE}
    if not isinstance(x, Cases):
        return told[x.name if isinstance(x, Symbol) else repr(x)]
    found: dict[int, list[Expr]] = {}
    before: list[Expr] = []
    for condition, value in (*x.cases, (TRUE, x.otherwise)):
        for code, when in _codes(value, told).items():
            found.setdefault(code, []).append(conj((*before, condition, when)))
        before.append(neg(condition))
    return {code: disj(xs) for code, xs in found.items()}


def _different(controller: Controller, pairs: list[tuple[str, Expr, Expr]]) -> list[Difference]:
    """Pairs of expressions that differ for some inputs and state, every wire's name written out."""
    meaning = controller.expanded | {n.next: x for n, x in controller.next_state.items()}
    put = Substitution(meaning)
    open_ = [(n, x, y) for n, a, b in pairs if (x := put(a)) is not (y := put(b))]
    cnf = Cnf()
    literals = [cnf.literal(iff(a, b)) for _, a, b in open_]
    solver = MiniSat(cnf)
    wrong = []
    for (name, a, b), lit in zip(open_, literals, strict=True):
        answer = solver.ask(-lit)
        if answer is Answer.SAT:
            model = solver.model()
            seen = sorted(n for n, v in model.items() if v and n in _names(a, b))
            wrong.append(Difference(name, f"differs when {', '.join(seen[:12]) or 'everything is false'}"))
        elif answer is Answer.UNKNOWN:
            wrong.append(Difference(name, "could not be decided"))
    return wrong


def _names(a: Expr, b: Expr) -> set[str]:
    return set(variables((a, b)))


__all__ = [
    "Difference",
    "Scan",
    "Translation",
    "compare_dialect",
    "compare_scan",
    "compare_st",
    "compare_unit",
    "kept",
    "wires",
    "words",
]
