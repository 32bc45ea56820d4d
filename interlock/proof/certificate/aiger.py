"""The whole system as a sequential circuit in binary AIGER, for engines that share nothing with this package.

Inputs: the free variables of a step, where a small-range input gives its bits, and the plant's initial state, read in
the first step.  Latches, all 0 at reset: every state variable, `later` (not the first step) and `unfair` (an assumption
or the initial condition was broken).
Output 0 is bad: in a step in which everything assumed holds, and held before, some claim does not hold.

**Theorem.**  Output 0 is 1 in some step of a run of the circuit exactly if the system has a run, from an initial state
and under its assumptions up to that step, in which some claim of that step does not hold.  (A latch for each state
variable, a gate for each part of a definition: Biere, Heljanko and Wieringa, *AIGER 1.9 and Beyond*, 2011.)
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from interlock.logic.expr import AND, EQ, NOT, OR, TRUE, VAR, Expr, conj, neg, walk
from interlock.logic.names import Name
from interlock.proof.claims import Claim
from interlock.proof.system.transition import System


class Circuit:
    """And-gates over literals: 2n is variable n, 2n+1 its negation, 0 and 1 are the constants."""

    def __init__(self) -> None:
        self.gates: list[tuple[int, int]] = []
        self.top = 0
        self._known: dict[tuple[int, int], int] = {}

    def fresh(self) -> int:
        """A new variable's literal."""
        self.top += 1
        return 2 * self.top

    def both(self, a: int, b: int) -> int:
        """AND of two literals."""
        a, b = max(a, b), min(a, b)
        if b == 0 or a == (b ^ 1):
            return 0
        if b == 1 or a == b:
            return a
        found = self._known.get((a, b))
        if found is None:
            found = self._known[a, b] = self.fresh()
            self.gates.append((a, b))
        return found

    def either(self, a: int, b: int) -> int:
        """OR of two literals."""
        return self.both(a ^ 1, b ^ 1) ^ 1

    def all(self, xs: Sequence[int]) -> int:
        """AND of any number of literals, as a balanced tree."""
        if not xs:
            return 1
        if len(xs) == 1:
            return xs[0]
        middle = len(xs) // 2
        return self.both(self.all(xs[:middle]), self.all(xs[middle:]))


class _Literals:
    """Literals of expressions, each node once; `names` and `bits` of variables are added to while it is used."""

    def __init__(self, circuit: Circuit, names: Mapping[str, int], bits: Mapping[Name, Sequence[int]]) -> None:
        self._circuit, self._names, self._bits = circuit, names, bits
        self._known: dict[Expr, int] = {}

    def __call__(self, root: Expr) -> int:
        known = self._known
        for node in walk((root,)):
            if node not in known:
                known[node] = self._node(node)
        return known[root]

    def _node(self, node: Expr) -> int:
        known, c = self._known, self._circuit
        if node.op is VAR:
            return self._names[node.name]
        if node.op is EQ:
            return c.all([b if node.value >> k & 1 else b ^ 1 for k, b in enumerate(self._bits[node.name])])
        if node.op is NOT:
            return known[node.args[0]] ^ 1
        if node.op is AND:
            return c.all([known[a] for a in node.args])
        if node.op is OR:
            return c.all([known[a] ^ 1 for a in node.args]) ^ 1
        return int(node is TRUE)


def aiger(system: System, claims: Sequence[Claim]) -> bytes:
    """The circuit; bad exactly when some claim is violated in a fair run."""
    c, relation = Circuit(), system.relation
    names: dict[str, int] = {}
    symbols: list[str] = []
    inputs = 0
    bits: dict[Name, list[int]] = {}
    for name in relation.inputs:
        size = relation.sizes.get(name)
        width = max(1, (size - 1).bit_length()) if size else 1
        lits = [c.fresh() for _ in range(width)]
        inputs += width
        if size:
            bits[name] = lits
            symbols += [f"i{inputs - width + k} {name}[{k}]" for k in range(width)]
        else:
            names[name] = lits[0]
            symbols.append(f"i{inputs - 1} {name}")
    kept = {x.args[0].name if x.op is NOT else x.name: x.op is VAR for x in system.initial.parts if _literal(x)}
    started: dict[str, int] = {}
    for name in relation.state:
        if name not in kept:
            started[name] = c.fresh()
            symbols.append(f"i{inputs} first {name}")
            inputs += 1
    stored = {name: c.fresh() for name in relation.state}
    later, unfair = c.fresh(), c.fresh()
    latches = [*relation.state, "later", "unfair"]
    symbols += [f"l{n} {name}" for n, name in enumerate(latches)]
    for name in relation.state:
        at_first = started.get(name, int(kept.get(name, False)))
        names[name] = c.either(c.both(later, stored[name]), c.both(later ^ 1, at_first))
    literal = _Literals(c, names, bits)
    for name, x in relation.definitions.items():
        names[name] = literal(x)
    assumed = [literal(a.expr) for a in relation.assumptions]
    for ranged, lits in bits.items():  # a value out of range is no value
        size = relation.sizes[ranged]
        for value in range(size, 1 << len(lits)):
            assumed.append(c.all([b if value >> k & 1 else b ^ 1 for k, b in enumerate(lits)]) ^ 1)
    starts = c.either(later, literal(system.initial.whole))
    now = c.both(unfair ^ 1, c.all([*assumed, starts]))
    bad = c.both(now, literal(neg(conj(x.expr for x in claims))))
    out = [f"aig {c.top} {inputs} {len(latches)} 1 {len(c.gates)}\n".encode()]
    out += [f"{names[name.next]}\n".encode() for name in relation.state]
    out.append(f"1\n{now ^ 1}\n".encode())
    out.append(f"{bad}\n".encode())
    gate = 2 * (inputs + len(latches)) + 2
    for a, b in c.gates:
        out.append(_delta(gate - a) + _delta(a - b))
        gate += 2
    text = [*symbols, "o0 bad", "c", f"interlock {system.loop.layout.name}", ""]
    return b"".join(out) + "\n".join(text).encode()


def _literal(x: Expr) -> bool:
    return x.op is VAR or (x.op is NOT and x.args[0].op is VAR)


def _delta(n: int) -> bytes:
    out = bytearray()
    while n >= 128:
        out.append(n & 127 | 128)
        n >>= 7
    out.append(n)
    return bytes(out)
