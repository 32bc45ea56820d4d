"""Point telegrams as Structured Text: bits of a telegram are BOOL inputs and outputs, most significant first.

SEND makes the telegram from what the controller commands, if the host's own result agrees (document C); RECV takes
it apart and commands only when every code, place and check is right; TRY repeats it until it is confirmed, then alarms.
"""

from __future__ import annotations

from collections.abc import Sequence

from interlock.model.elements import MachineId
from interlock.model.portable import portable
from interlock.st.ast import Assign, Block, Bool, Call, Declaration, Expression, Name, Nary, Not, Time, Unit

WAIT_MS = 200  # our choice, as in the Python runtime


def _n(name: str) -> Name:
    return Name((name,))


def _all(xs: Sequence[Expression]) -> Expression:
    return Bool(True) if not xs else xs[0] if len(xs) == 1 else Nary("AND", tuple(xs))


def _xor(a: Expression, b: Expression) -> Expression:
    return Nary("XOR", (a, b))


class _Body:
    """Statements of a block with temporaries, ten operands at most."""

    def __init__(self) -> None:
        self.statements: list[Assign | Call] = []
        self.locals: list[Declaration] = []

    def temp(self, value: Expression, note: str = "") -> Name:
        """A variable of the block."""
        name = f"T_{len(self.locals) + 1}"
        self.locals.append(Declaration(name, "BOOL"))
        self.statements.append(Assign(_n(name), value, note))
        return _n(name)

    def every(self, xs: Sequence[Expression], note: str) -> Expression:
        """All of them."""
        left = list(xs)
        while len(left) > 10:
            left = [self.temp(_all(left[k : k + 10]), note) for k in range(0, len(left), 10)]
        return _all(left)


def _place(tagged: bool, n: int) -> int:
    """The first bit of point n."""
    per_byte = 3 if tagged else 4
    return n // per_byte * 8 + n % per_byte * 2


def telegram_unit(name: str, machines: Sequence[MachineId], tagged: bool, header: Sequence[str]) -> Unit:
    """The three blocks for the machines in their order."""
    prefix = f"IL_{portable(name)}"
    blocks = (
        _send(f"{prefix}_SEND", machines, tagged),
        _receive(f"{prefix}_RECV", machines, tagged),
        _try(f"{prefix}_TRY"),
    )
    return Unit(blocks, tuple(header))


def _bytes(machines: Sequence[MachineId], tagged: bool) -> int:
    return -(-len(machines) // (3 if tagged else 4))


def _inputs(machines: Sequence[MachineId], prefixes: Sequence[tuple[str, str]]) -> tuple[Declaration, ...]:
    named = [(f"{p}_{portable(m)}", f"{m}: {text}") for m in machines for p, text in prefixes]
    return tuple(Declaration(name, "BOOL", None, note) for name, note in named)


def _bits(count: int) -> tuple[Declaration, ...]:
    """The bits of a telegram of so many bytes and a check byte."""
    return tuple(
        Declaration(f"D_{b + 1}", "BOOL", None, f"byte {b // 8 + 1}, bit {7 - b % 8}") for b in range(count * 8 + 8)
    )


def _send(name: str, machines: Sequence[MachineId], tagged: bool) -> Block:
    body = _Body()
    whole, count = [], _bytes(machines, tagged)
    bits: dict[int, Expression] = {}
    for n, m in enumerate(machines):
        p = portable(m)
        own_n, own_r, host_n, host_r = (_n(f"{x}_{p}") for x in ("CN", "CR", "HN", "HR"))
        one = body.temp(_xor(own_n, own_r), f"{m} is commanded one way")
        same_n, same_r = body.temp(_xor(own_n, host_n)), body.temp(_xor(own_r, host_r))
        whole.append(body.temp(Nary("AND", (one, Not(same_n), Not(same_r))), f"{m}: the host agrees"))
        at = _place(tagged, n)
        bits[at], bits[at + 1] = own_n, own_r
    if tagged:
        for k in range(count):
            bits[k * 8 + 6], bits[k * 8 + 7] = Bool(bool(k & 2)), Bool(bool(k & 1))
    body.statements.append(Assign(_n("READY"), body.every(whole, "every machine"), "to be sent"))
    for b in range(count * 8):
        value = bits.get(b, Bool(False))
        sent = Nary("AND", (_n("READY"), value)) if isinstance(value, Name) else value
        body.statements.append(Assign(_n(f"D_{b + 1}"), sent))
    for b in range(8):
        check: Expression = _n(f"D_{b + 1}")
        for k in range(1, count):
            check = body.temp(_xor(check, _n(f"D_{k * 8 + b + 1}")))
        body.statements.append(Assign(_n(f"D_{count * 8 + b + 1}"), check))
    words = (("CN", "commanded normal"), ("CR", "commanded reverse"), ("HN", "host: normal"), ("HR", "host: reverse"))
    return Block(
        name,
        _inputs(machines, words),
        (
            Declaration("READY", "BOOL", None, "controller and host agree on every machine"),
            *_bits(count),
        ),
        tuple(body.locals),
        tuple(body.statements),
        "the telegram of the point commands, while the host's own result agrees",
    )


def _receive(name: str, machines: Sequence[MachineId], tagged: bool) -> Block:
    body = _Body()
    count = _bytes(machines, tagged)
    right: list[Expression] = []
    used = set()
    for n, m in enumerate(machines):
        at = _place(tagged, n)
        used |= {at, at + 1}
        right.append(body.temp(_xor(_n(f"D_{at + 1}"), _n(f"D_{at + 2}")), f"{m}: 10 or 01"))
    for b in range(count * 8):
        if b in used:
            continue
        tag = tagged and b % 8 >= 6
        one = tag and bool(b // 8 & (2 if b % 8 == 6 else 1))
        right.append(_n(f"D_{b + 1}") if one else Not(_n(f"D_{b + 1}")))
    for b in range(8):
        check: Expression = _n(f"D_{b + 1}")
        for k in range(1, count + 1):
            check = body.temp(_xor(check, _n(f"D_{k * 8 + b + 1}")))
        right.append(Not(check))
    body.statements.append(Assign(_n("WELL"), body.every(right, "codes, places and check"), "the answer"))
    for n, m in enumerate(machines):
        at = _place(tagged, n)
        for x, b in (("CN", at), ("CR", at + 1)):
            body.statements.append(Assign(_n(f"{x}_{portable(m)}"), Nary("AND", (_n("WELL"), _n(f"D_{b + 1}")))))
    return Block(
        name,
        _bits(count),
        (
            Declaration("WELL", "BOOL", None, "codes, unused places and check byte are right"),
            *_inputs(machines, (("CN", "drive to normal"), ("CR", "drive to reverse"))),
        ),
        tuple(body.locals),
        tuple(body.statements),
        "takes a telegram apart, commands nothing unless all is right; clear every D_ when none comes in time",
    )


def _try(name: str) -> Block:
    """Three telegrams without a confirmation, then an alarm that stays until one is confirmed.

    A FRESH that stands is one telegram, so that it silences no alarm; at its end there may have been others, of which
    the last is sent.
    """
    new, confirmed, refused, over = _n("FRESH"), _n("YES"), _n("NO"), Name(("WAIT", "Q"))
    open_, again, second, third = _n("OPEN"), _n("AGAIN"), _n("SECOND"), _n("THIRD")
    first, was, more = _n("FIRST"), _n("WAS"), _n("MORE")
    begins, ends = Nary("AND", (new, Not(was))), Nary("AND", (more, Not(new)))
    body: list[Assign | Call] = [
        Assign(first, Nary("OR", (begins, ends)), "a new telegram"),
        Assign(_n("RUN"), Nary("AND", (open_, Not(again), Not(first))), "waiting for an answer"),
        Call("WAIT", (("IN", _n("RUN")), ("PT", Time(WAIT_MS)))),
        Assign(_n("LOST"), Nary("AND", (open_, Not(confirmed), Nary("OR", (refused, over)))), "refused, or no answer"),
        Assign(again, Nary("AND", (_n("LOST"), Not(first), Not(third))), "once more"),
        Assign(_n("SEND"), Nary("OR", (first, again)), "send now"),
        Assign(_n("FAIL"), Nary("AND", (_n("LOST"), third, Not(first))), "three in vain"),
        Assign(_n("ALARM"), Nary("AND", (Not(confirmed), Nary("OR", (_n("ALARM"), _n("FAIL"))))), "until confirmed"),
        Assign(third, Nary("AND", (Not(first), Not(confirmed), Nary("OR", (third, Nary("AND", (second, again))))))),
        Assign(second, Nary("AND", (Not(first), Not(confirmed), Nary("OR", (second, again))))),
        Assign(open_, Nary("OR", (first, Nary("AND", (open_, Not(confirmed), Not(_n("FAIL"))))))),
        Assign(more, Nary("AND", (new, was)), "perhaps another one meanwhile"),
        Assign(was, new),
    ]
    return Block(
        name,
        (
            Declaration("FRESH", "BOOL", None, "there is a new telegram: 1 in one call for each"),
            Declaration("YES", "BOOL", None, "the receiver has confirmed it: 1 in one call for each answer"),
            Declaration("NO", "BOOL", None, "the receiver has refused it: 1 in one call for each answer"),
        ),
        (
            Declaration("SEND", "BOOL", None, "send it in this scan"),
            Declaration("ALARM", "BOOL", Bool(False), "three in vain"),
        ),
        (
            Declaration("OPEN", "BOOL", Bool(False), "sent, and not yet confirmed"),
            Declaration("AGAIN", "BOOL", Bool(False)),
            Declaration("SECOND", "BOOL", Bool(False), "sent twice"),
            Declaration("THIRD", "BOOL", Bool(False), "sent three times"),
            Declaration("WAS", "BOOL", Bool(False), "FRESH in the last call"),
            Declaration("MORE", "BOOL", Bool(False), "FRESH has stood for more than a call"),
            Declaration("FIRST", "BOOL"),
            Declaration("RUN", "BOOL"),
            Declaration("LOST", "BOOL"),
            Declaration("FAIL", "BOOL"),
            Declaration("WAIT", "TON", None, "time for an answer"),
        ),
        tuple(body),
        "sends, waits, repeats twice, alarms; FRESH, YES and NO are pulses, YES and NO for this telegram",
    )
