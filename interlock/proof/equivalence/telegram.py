"""The text of the telegram blocks does what document C asks for: proved for every telegram, not tried on some.

RECV says WELL exactly when every point has 10 or 01, every unused place is 00, every tag is the byte's number, and the
exclusive or of all bytes is zero; it commands exactly what the telegram says, and nothing otherwise.  SEND is ready
exactly when the host agrees on every machine, what it then sends is such a telegram for these commands, and what it
holds otherwise is none.  Neither remembers anything: that is proved for every value that a variable may have kept from
the call before.  TRY, which has memory, is the block that is made, statement by statement; no other block is there.

**Theorem.**  A formula that no valuation of its variables makes false holds for every telegram, every command and every
value that was left from the call before; where no result reads what was left, the block has no memory.  (Validity of a
propositional formula, as unsatisfiability of its denial.)
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import reduce

from interlock.logic.expr import FALSE, Expr, conj, disj, iff, implies, neg, var
from interlock.logic.names import spelled
from interlock.model.elements import MachineId
from interlock.model.portable import portable
from interlock.proof.engines import Answer, solver
from interlock.proof.engines.tseitin import Cnf
from interlock.proof.equivalence.structured_text import Difference, kept
from interlock.st.ast import Block, Unit
from interlock.st.meaning import BadText, Execution, Symbols, Term
from interlock.st.parser import NotInSubset, parse_unit
from interlock.st.telegram import telegram_unit


def compare_telegram(name: str, machines: Sequence[MachineId], tagged: bool, text: str) -> tuple[Difference, ...]:
    """What is wrong with the telegram blocks; empty when nothing is."""
    try:
        blocks = parse_unit(text).blocks
        if wrong := tuple(_otherwise(blocks, telegram_unit(name, machines, tagged, ()).blocks)):
            return wrong
        send, receive, _ = blocks
        claims = {**_receiving(machines, tagged, _run(receive)), **_sending(machines, tagged, _run(send))}
    except (NotInSubset, BadText, KeyError, ValueError) as error:
        return (Difference("telegram", f"cannot be read: {error}"),)
    cnf = Cnf()
    literals = {claim: cnf.literal(x) for claim, x in claims.items()}
    sat = solver("minisat", cnf, 20_000)
    return tuple(Difference(c, "does not hold") for c, x in literals.items() if sat.ask(-x) is not Answer.UNSAT)


def _otherwise(blocks: Sequence[Block], made: Sequence[Block]) -> Iterator[Difference]:
    """Blocks by other names, or twice; inputs and outputs that are not those that are made, or begin otherwise."""
    if [b.name for b in blocks] != [b.name for b in made]:
        yield Difference("telegram", f"not the blocks {', '.join(b.name for b in made)}, each once")
        return
    for mine, should in zip(blocks, made, strict=True):
        if (mine.kind, mine.inputs, mine.outputs) != (should.kind, should.inputs, should.outputs):
            yield Difference(mine.name, "has other inputs or outputs, or begins with other values")
    if blocks[-1] != made[-1]:
        yield Difference(blocks[-1].name, "does not send, wait, repeat and alarm as it is made")


def _run(block: Block) -> dict[str, Expr]:
    """The outputs of a block, whatever its variables have kept from the call before."""
    run: Execution[Term] = Execution(Unit((block,)), Symbols(), kept)
    run.main.forget()
    found = run.scan({d.name: var(spelled(d.name)) for d in block.inputs})
    return {n: x for n, x in found.items() if isinstance(x, Expr)}


def places(count: int, tagged: bool) -> list[tuple[int, int, int | None]]:
    """Every pair of bits of the bytes before the check: byte, place, and the point in it (None: unused; -1: a tag)."""
    in_a_byte = 3 if tagged else 4
    out: list[tuple[int, int, int | None]] = []
    for byte in range(-(-count // in_a_byte)):
        for place in range(4):
            point = byte * in_a_byte + place
            if tagged and place == 3:
                out.append((byte, place, -1))
            else:
                out.append((byte, place, point if point < count else None))
    return out


def right(count: int, tagged: bool, bits: Mapping[tuple[int, int], Expr]) -> Expr:
    """A telegram is right; `bits` by byte and bit from the left."""
    rules = []
    table = places(count, tagged)
    for byte, place, point in table:
        high, low = bits[byte, 2 * place], bits[byte, 2 * place + 1]
        if point is None:
            rules += [neg(high), neg(low)]
        elif point < 0:
            rules += [high if byte & 2 else neg(high), low if byte & 1 else neg(low)]
        else:
            rules.append(_differ(high, low))
    size = table[-1][0] + 2
    for bit in range(8):
        rules.append(neg(reduce(_differ, (bits[byte, bit] for byte in range(size)))))
    return conj(rules)


def _differ(a: Expr, b: Expr) -> Expr:
    return disj((conj((a, neg(b))), conj((neg(a), b))))


def _bits(count: int, tagged: bool, of: Mapping[str, Expr] | None) -> dict[tuple[int, int], Expr]:
    size = places(count, tagged)[-1][0] + 2
    names = {(byte, bit): f"D_{byte * 8 + bit + 1}" for byte in range(size) for bit in range(8)}
    return {at: of[n] if of is not None else var(spelled(n)) for at, n in names.items()}


def _receiving(machines: Sequence[MachineId], tagged: bool, out: Mapping[str, Expr]) -> dict[str, Expr]:
    bits = _bits(len(machines), tagged, None)
    claims = {"RECV WELL": iff(out["WELL"], right(len(machines), tagged, bits))}
    for byte, place, point in places(len(machines), tagged):
        if point is not None and point >= 0:
            m = portable(machines[point])
            for word, bit in (("CN", 2 * place), ("CR", 2 * place + 1)):
                claims[f"RECV {word}_{m}"] = iff(out[f"{word}_{m}"], conj((out["WELL"], bits[byte, bit])))
    return claims


def _sending(machines: Sequence[MachineId], tagged: bool, out: Mapping[str, Expr]) -> dict[str, Expr]:
    agree = []
    for m in map(portable, machines):
        own_n, own_r, host_n, host_r = (var(spelled(f"{x}_{m}")) for x in ("CN", "CR", "HN", "HR"))
        agree.append(conj((_differ(own_n, own_r), iff(own_n, host_n), iff(own_r, host_r))))
    bits = _bits(len(machines), tagged, out)
    ready, whole = out["READY"], right(len(machines), tagged, bits)
    claims = {"SEND READY": iff(ready, conj(agree)), "SEND telegram": iff(ready, whole)}
    for byte, place, point in places(len(machines), tagged):
        if point is not None and point >= 0:
            m = portable(machines[point])
            for word, bit in (("CN", 2 * place), ("CR", 2 * place + 1)):
                claims[f"SEND {word}_{m}"] = implies(ready, iff(bits[byte, bit], var(spelled(f"{word}_{m}"))))
    return claims if machines else {"SEND": FALSE}
