"""Point telegrams of document C: golden vectors, every telegram decided, and what the check cannot see."""

from __future__ import annotations

import random
import re
from collections import Counter
from collections.abc import Callable
from functools import cache
from itertools import combinations, pairwise, product
from pathlib import Path

import pytest

from interlock.app.check import check_file
from interlock.derivation import derive
from interlock.diag import Sink
from interlock.emit.python.runtime import runtime_py
from interlock.field.plc import runtime_scan
from interlock.field.telegram import BadTelegram, Form, Receiver, Sender, decode, encode, form_of
from interlock.frontend import load_text
from interlock.logic.expr import neg, var
from interlock.logic.lower import lower
from interlock.model.elements import MachineId, Position
from interlock.proof.engines import Answer, solver
from interlock.proof.engines.tseitin import Cnf
from interlock.proof.equivalence.telegram import compare_telegram, right
from interlock.st.ast import Unit
from interlock.st.lint import lint
from interlock.st.meaning import Execution, Numbers
from interlock.st.parser import parse_unit
from interlock.st.printer import print_unit
from interlock.st.telegram import telegram_unit

N, R = Position.NORMAL, Position.REVERSE
ELEVEN = form_of([MachineId(f"P{k}") for k in range(1, 12)])
SIZES = (1, 2, 4, 5, 11)
FORMS = [form_of([MachineId(f"P{k}") for k in range(1, n + 1)], tagged) for n in SIZES for tagged in (False, True)]


def commands(form: Form, positions: list[Position]) -> dict[MachineId, Position]:
    return dict(zip(form.machines, positions, strict=True))


def text_of(form: Form) -> str:
    return print_unit(telegram_unit("demo", form.machines, form.tagged, ["made for a test"]))


def test_the_vectors_of_document_c() -> None:
    assert encode(form_of(ELEVEN.machines[:4]), commands(form_of(ELEVEN.machines[:4]), [N, N, R, R]))[0] == 0xA5
    telegram = encode(ELEVEN, commands(ELEVEN, [N, N, R, R, N, N, N, N, N, N, N]))
    assert telegram.hex(" ").upper() == "A5 AA A8 A7"
    assert decode(ELEVEN, telegram)[MachineId("P3")] is R


@pytest.mark.parametrize("form", FORMS, ids=str)
def test_what_is_sent_is_received(form: Form) -> None:
    rng = random.Random(1)
    for _ in range(50):
        wanted = commands(form, [rng.choice((N, R)) for _ in form.machines])
        assert decode(form, encode(form, wanted)) == wanted


@pytest.mark.parametrize("form", FORMS, ids=str)
def test_the_text_is_proved_for_every_telegram(form: Form) -> None:
    text = text_of(form)
    assert compare_telegram("demo", form.machines, form.tagged, text) == ()
    for old, new in (
        ("D_1 XOR D_2;", "D_1 OR D_2;"),
        ("WELL := ", "WELL := NOT "),
        ("AND D_1;", "AND D_2;"),
        ("NOT T_2", "T_2"),
    ):
        assert old in text
        assert compare_telegram("demo", form.machines, form.tagged, text.replace(old, new, 1)), (old, new)


def _block(text: str, name: str) -> str:
    return text[text.index(f"FUNCTION_BLOCK {name}\n") :].partition("END_FUNCTION_BLOCK\n")[0] + "END_FUNCTION_BLOCK\n"


def _with_memory(block: str) -> str:
    """A machine is commanded by what the telegram before said, too."""
    found = block.replace("END_VAR\n  T_1", "  KEPT : BOOL;\nEND_VAR\n  T_1")
    return found.replace("END_FUNCTION_BLOCK", "  CN_P1 := CN_P1 OR KEPT;\n  KEPT := D_1;\nEND_FUNCTION_BLOCK")


FORGED: dict[str, Callable[[str], str]] = {
    "a block of the same name before it, which the controller's tool may take": lambda x: (
        x.replace("WELL := ", "WELL := NOT ") + x
    ),
    "what is kept from the telegram before commands a machine": _with_memory,
    "a machine is driven before the first telegram": lambda x: x.replace("CN_P1 : BOOL;", "CN_P1 : BOOL := TRUE;"),
    "another block, whose name is that of the timer": lambda x: f"{x}{x.replace('IL_demo_RECV', 'TON')}",
    "one more output": lambda x: x.replace("  CN_P1 : BOOL;", "  CN_P9 : BOOL;\n  CN_P1 : BOOL;", 1).replace(
        "END_FUNCTION_BLOCK", "  CN_P9 := D_5;\nEND_FUNCTION_BLOCK"
    ),
}


@pytest.mark.parametrize("how", FORGED)
def test_a_forged_text_of_the_receiver_is_refused(how: str) -> None:
    form = form_of(ELEVEN.machines[:2])
    text, receive = text_of(form), _block(text_of(form), "IL_demo_RECV")
    forged = FORGED[how](receive)
    assert forged != receive and parse_unit(text.replace(receive, forged))
    assert compare_telegram("demo", form.machines, form.tagged, text.replace(receive, forged))


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("ALARM := NOT YES AND (ALARM OR FAIL)", "ALARM := NOT YES AND FAIL"),
        ("FIRST OR AGAIN", "FIRST OR LOST"),
        ("OPEN AND NOT AGAIN AND NOT FIRST", "OPEN AND NOT AGAIN"),
        ("FRESH AND NOT WAS", "FRESH"),
        ("T#200ms", "T#200h"),
        ("THIRD : BOOL := FALSE", "THIRD : BOOL := TRUE"),
    ],
)
def test_a_changed_block_that_repeats_telegrams_is_refused(old: str, new: str) -> None:
    form = form_of(ELEVEN.machines[:2])
    assert old in text_of(form)
    assert compare_telegram("demo", form.machines, form.tagged, text_of(form).replace(old, new))


@pytest.mark.parametrize("form", FORMS, ids=str)
def test_text_and_python_accept_the_same_telegrams(form: Form) -> None:
    unit = parse_unit(text_of(form))
    receive: Execution[int] = Execution(Unit((unit.blocks[1],)), Numbers())
    rng = random.Random(2)
    accepted = 0
    for _ in range(400):
        telegram = bytearray(encode(form, commands(form, [rng.choice((N, R)) for _ in form.machines])))
        for _ in range(rng.choice((0, 0, 1, 2, 4))):
            telegram[rng.randrange(form.size)] ^= 1 << rng.randrange(8)
        bits = {f"D_{k * 8 + b + 1}": byte >> (7 - b) & 1 for k, byte in enumerate(telegram) for b in range(8)}
        out = receive.scan(bits)
        try:
            positions: dict[MachineId, Position] = decode(form, bytes(telegram))
        except BadTelegram:
            positions = {}
        assert bool(out["WELL"]) is bool(positions)
        for m in form.machines:
            assert out[f"CN_{m}"] == (positions.get(m) is N) and out[f"CR_{m}"] == (positions.get(m) is R)
        accepted += bool(positions)
    assert 100 < accepted < 400


def test_of_all_telegrams_of_eleven_points_exactly_the_right_ones_are_accepted() -> None:
    """2^32 telegrams: those that the receiver accepts are the 2^11 encodings, by proof, and no two are near."""
    bits = {(byte, bit): var(f"b{byte}.{bit}") for byte in range(4) for bit in range(8)}
    cnf = Cnf()
    cnf.require(right(11, False, bits))
    sat = solver("minisat", cnf, 10_000)
    points = [cnf.literal(bits[n // 4, n % 4 * 2]) for n in range(11)]
    for choice in ([1] * 11, [0] * 11, [1, 0] * 5 + [1]):
        given = [x if c else -x for x, c in zip(points, choice, strict=True)]
        assert sat.ask(*given) is Answer.SAT
        wanted = encode(ELEVEN, commands(ELEVEN, [N if c else R for c in choice]))
        for (byte, bit), x in bits.items():
            value = wanted[byte] >> (7 - bit) & 1
            assert sat.ask(*given, cnf.literal(neg(x) if value else x)) is Answer.UNSAT  # nothing else is free
    everything = {encode(ELEVEN, commands(ELEVEN, list(p))) for p in product((N, R), repeat=11)}
    assert len(everything) == 2048
    first = min(everything)
    far = Counter(sum((a ^ b).bit_count() for a, b in zip(first, t, strict=True)) for t in everything)
    assert min(d for d in far if d) == 4  # any three wrong bits are seen
    assert (far[4], far[8], far[12]) == (21, 165, 585)


def test_the_plain_check_is_blind_to_the_order_of_bytes_and_the_tagged_one_is_not() -> None:
    plain = encode(ELEVEN, commands(ELEVEN, [N, N, R, R, N, N, N, N, N, N, N]))
    exchanged = bytes([plain[1], plain[0], *plain[2:]])
    assert decode(ELEVEN, exchanged) != decode(ELEVEN, plain)  # the documented weakness of document C
    tagged = form_of(ELEVEN.machines, tagged=True)
    telegram = encode(tagged, commands(tagged, [N, N, R, R, N, N, N, N, N, N, N]))
    for i, j in ((0, 1), (0, 2), (1, 3), (2, 3)):
        swapped = bytearray(telegram)
        swapped[i], swapped[j] = swapped[j], swapped[i]
        with pytest.raises(BadTelegram):
            decode(tagged, bytes(swapped))


@pytest.mark.parametrize(
    ("telegram", "message"),
    [
        ("A5 AA A8", "3 bytes, not 4"),
        ("A5 AA A8 A6", "check byte"),
        ("E5 AA A8 E7", "P1: 11 is no position"),
        ("25 AA A8 27", "P1: 00 is no position"),
        ("A5 AA AA A5", "unused place"),
    ],
)
def test_wrong_telegrams_are_refused_and_change_nothing(telegram: str, message: str) -> None:
    receiver = Receiver(ELEVEN, commands(ELEVEN, [N] * 11))
    assert not receiver.receive(bytes.fromhex(telegram))
    assert message in receiver.refused[0] and receiver.positions == commands(ELEVEN, [N] * 11)


def test_nothing_is_sent_unless_the_host_agrees() -> None:
    form = form_of(ELEVEN.machines[:2])
    sender = Sender(form)
    own = commands(form, [N, R])
    assert sender.step(own, commands(form, [N, N]), None, 100) is None
    assert sender.step(own, {}, None, 100) is None
    assert sender.step(own, own, None, 100) == encode(form, own)


def test_a_telegram_is_repeated_twice_and_then_alarmed() -> None:
    form = form_of(ELEVEN.machines[:2])
    sender = Sender(form)
    own = commands(form, [N, R])
    sent = [sender.step(own, own, None, 100) for _ in range(10)]
    assert [t is not None for t in sent] == [True, False, True, False, True, False, False, False, False, False]
    assert sender.alarm
    assert sender.step(own, own, True, 100) is None and not sender.alarm  # a late word of the receiver
    refused = Sender(form)
    answers = [None, False, False, False, True]
    assert [refused.step(own, own, a, 10) is not None for a in answers] == [True, True, True, False, False]


def test_the_text_repeats_and_alarms_as_the_runtime_does() -> None:
    """TRY against the Python sender: the same telegrams, the same alarm, on answers at random."""
    unit = parse_unit(text_of(form_of(ELEVEN.machines[:2])))
    assert unit.blocks[2].name == "IL_demo_TRY"
    numbers = Numbers(dt_ms=100)
    run: Execution[int] = Execution(Unit((unit.blocks[2],)), numbers)
    sends = [run.scan({"FRESH": k == 0, "YES": 0, "NO": 0}) for k in range(12)]
    assert sum(s["SEND"] for s in sends) == 3 and sends[-1]["ALARM"] and not sends[0]["ALARM"]
    assert sends[0]["SEND"] and all(not (a["SEND"] and b["SEND"]) for a, b in pairwise(sends))
    assert not run.scan({"FRESH": 0, "YES": 1, "NO": 0})["ALARM"]
    run = Execution(Unit((unit.blocks[2],)), Numbers(dt_ms=100))
    refused = [run.scan({"FRESH": k == 0, "YES": 0, "NO": k in (1, 3, 5)}) for k in range(8)]
    assert [k for k, s in enumerate(refused) if s["SEND"]] == [0, 1, 3] and refused[5]["ALARM"]
    run = Execution(Unit((unit.blocks[2],)), Numbers(dt_ms=100))
    fine = [run.scan({"FRESH": k == 0, "YES": k == 1, "NO": 0}) for k in range(30)]
    assert sum(s["SEND"] for s in fine) == 1 and not any(s["ALARM"] for s in fine)


def trying(dt_ms: int) -> Callable[..., tuple[bool, bool]]:
    """The emitted TRY, called at such distances: whether it sends, and its alarm."""
    unit = parse_unit(text_of(form_of(ELEVEN.machines[:2])))
    run: Execution[int] = Execution(Unit((unit.blocks[2],)), Numbers(dt_ms=dt_ms))

    def call(new: bool = False, answer: bool | None = None) -> tuple[bool, bool]:
        out = run.scan({"FRESH": int(new), "YES": int(answer is True), "NO": int(answer is False)})
        return bool(out["SEND"]), bool(out["ALARM"])

    return call


def test_in_runs_at_random_the_text_sends_and_alarms_as_the_python_sender() -> None:
    """The wait counts from the call after a telegram was sent, and after one was repeated from the next but one."""
    rng, form = random.Random(4), form_of(ELEVEN.machines[:2])
    every = [commands(form, list(p)) for p in product((N, R), repeat=2)]
    sent = alarms = early = 0
    for run in range(300):
        dt, sender = (10, 50, 90, 100, 200, 250)[run % 6], Sender(form)
        call, now, fresh = trying(dt), rng.choice(every), True
        busy, answering = rng.choice((0.02, 0.1, 0.4)), rng.choice((0.0, 0.02, 0.2))
        since = 0
        for _ in range(200):
            answer = rng.choice((True, False)) if rng.random() < answering else None
            asked = sender.step(now, now, answer, dt)
            assert call(fresh, answer) == (asked is not None, sender.alarm)
            since = 0 if asked is not None else since + dt
            if asked is not None:
                sender.wait_ms = 200 + dt * (1 if fresh else 2)
            sent, alarms = sent + (asked is not None), alarms + sender.alarm
            fresh = not fresh and rng.random() < busy
            if fresh:
                early += 0 < since < 200
                now = rng.choice([x for x in every if x != now])
    assert sent > 3000 and alarms > 3000 and early > 500


def test_a_new_telegram_has_the_whole_wait_for_its_answer() -> None:
    call = trying(10)
    told = [call(k in (0, 19)) for k in range(100)]
    assert [k for k, (send, _) in enumerate(told) if send] == [0, 19, 40, 62]
    assert next(k for k, (_, alarm) in enumerate(told) if alarm) == 84


def test_a_new_that_stands_is_one_telegram_and_silences_no_alarm() -> None:
    call = trying(100)
    told = [call(True) for _ in range(600)]
    assert sum(send for send, _ in told) == 3 and all(alarm for _, alarm in told[11:])
    assert [call(), call()] == [(True, True), (False, True)], "the last of them, and the alarm until one is confirmed"


@pytest.mark.parametrize("seed", range(20))
def test_of_telegrams_in_calls_on_end_the_last_is_sent(seed: int) -> None:
    """FRESH says that the telegram is another one: without a break, and while the one before is confirmed, too."""
    rng, call = random.Random(seed), trying(100)
    pending = lost = new = False
    several = 0
    for _ in range(400):
        before, new = new, rng.random() < 0.5
        send, _ = call(new, rng.choice((None, None, True, False)))
        several += new and before
        pending = (pending or new) and not send
        lost = lost or (pending and not new)
    assert several > 20 and not lost


def test_the_python_sender_sends_what_was_confirmed_before_another_one() -> None:
    """That other one may have arrived, and its answer been lost."""
    form = form_of(ELEVEN.machines[:2])
    sender, first, other = Sender(form), commands(form, [N, N]), commands(form, [R, N])
    assert sender.step(first, first, None, 100) and not sender.step(first, first, True, 100)
    assert sender.step(other, other, None, 100) == encode(form, other)
    assert sender.step(first, first, None, 100) == encode(form, first)


def test_the_blocks_say_what_they_leave_to_the_caller() -> None:
    text = " ".join(text_of(FORMS[0]).replace("(*", "").replace("*)", "").split())
    assert (
        "FRESH, YES and NO are pulses, YES and NO for this telegram" in text
        and "clear every D_ when none comes in time" in text
    )


@pytest.mark.parametrize("form", FORMS, ids=str)
def test_a_yes_that_stands_confirms_what_nobody_has_received(form: Form) -> None:
    """Why it has to be a pulse."""
    unit = telegram_unit("demo", form.machines, form.tagged, [])
    run: Execution[int] = Execution(Unit((unit.blocks[2],)), Numbers(dt_ms=100))
    sends = [run.scan({"FRESH": k == 0, "YES": 1, "NO": 0}) for k in range(30)]
    assert sum(s["SEND"] for s in sends) == 1 and not any(s["ALARM"] for s in sends)


@pytest.mark.parametrize("form", FORMS, ids=str)
def test_the_blocks_pass_our_own_checks(form: Form) -> None:
    unit = telegram_unit("demo", form.machines, form.tagged, [])
    kinds = {f.rule for f in lint(unit) if "no block has an instance" not in f.text}
    assert kinds <= {"ST-INIT"}  # AGAIN and the like are of the last scan
    assert not re.search(r"\b(FOR|WHILE|ARRAY)\b", text_of(form))


def _turned(telegram: bytes, bits: int, fill: bool = True) -> bytes:
    """To the left by so many bits: what goes out comes in again on the right, or zeros do."""
    length = 8 * len(telegram)
    number = int.from_bytes(telegram, "big") << bits
    return (number & (1 << length) - 1 | (number >> length if fill else 0)).to_bytes(len(telegram), "big")


def _bit_by_bit(telegram: bytes) -> bytes:
    """From its end."""
    return bytes(int(f"{byte:08b}"[::-1], 2) for byte in reversed(telegram))


def _exchanged(telegram: bytes, i: int, j: int) -> bytes:
    out = bytearray(telegram)
    out[i], out[j] = out[j], out[i]
    return bytes(out)


MISHAPS: dict[str, Callable[[bytes], bytes]] = {
    "every bit inverted": lambda t: bytes(~byte & 0xFF for byte in t),
    "bits of each byte in reverse order": lambda t: _bit_by_bit(t)[::-1],
    "each byte rotated by two bits": lambda t: bytes(_turned(bytes([byte]), 2)[0] for byte in t),
    "the telegram rotated by two bits": lambda t: _turned(t, 2),
    "the telegram shifted by one bit, to the left": lambda t: _turned(t, 1, fill=False),
    "bytes 1 and 2 exchanged": lambda t: _exchanged(t, 0, 1),
    "the telegram from its end, bit by bit": _bit_by_bit,
    "both bits of every point exchanged": lambda t: bytes((x & 0xAA) >> 1 | (x & 0x55) << 1 for x in t),
}


@cache
def _said(form: Form) -> dict[bytes, tuple[Position, ...]]:
    """Every telegram, and what it commands."""
    every = (commands(form, list(p)) for p in product((N, R), repeat=len(form.machines)))
    return {encode(form, x): tuple(x.values()) for x in every}


def _passed(form: Form, mishap: Callable[[bytes], bytes]) -> tuple[int, int, int]:
    """Of how many telegrams how many are well after a mishap, and how many of these command something else."""
    said = _said(form)
    well = [(said[t], said[after]) for t in said if (after := mishap(t)) in said]
    return len(said), len(well), sum(a != b for a, b in well)


def test_what_passes_the_check_is_as_the_page_counts_it() -> None:
    page = Path("interlock/docs/plc.md").read_text("utf-8")
    head, _, *rows = page[page.index("| what becomes of them") :].partition("\n\n")[0].splitlines()
    columns, tagged = [], False
    for cell in head.split("|")[2:-1]:
        tagged = "tagged" in cell
        columns.append(form_of([MachineId(f"P{k}") for k in range(1, int(re.findall(r"\d+", cell)[0]) + 1)], tagged))
    assert len(columns) == 7
    told = {cells[0]: cells[1:] for row in rows for cells in [[c.strip() for c in row.split("|")[1:-1]]]}
    assert list(told) == list(MISHAPS)
    for name, mishap in MISHAPS.items():
        found = [_passed(form, mishap) for form in columns]
        assert told[name] == [f"{other} of {every}" if other else "0" for every, _, other in found], name


def ladder(machines: int, form: str) -> str:
    """So many points, one behind the other."""
    ends = "".join(f"  B{k}: {{trains: out}}\n" for k in range(1, machines + 2))
    points = "".join(
        f"  P{k}: {{section: d, toe: {f'P{k - 1}.normal' if k > 1 else 'C'}, "
        f"normal: {f'P{k + 1}.toe' if k < machines else f'B{machines + 1}'}, reverse: B{k}}}\n"
        for k in range(1, machines + 1)
    )
    return (
        f"interlock: 1\nname: ladder\ntelegram: {form}\nboundaries:\n  C: {{approach: ca 1200, trains: in}}\n{ends}"
        f"points:\n{points}signals:\n  X1: {{from: C, into: d}}\n"
    )


@pytest.mark.parametrize(
    ("kind", "machines"),
    [*(("plain", n) for n in (1, 2, 3, 4, 5, 7, 8, 9, 11, 12)), *(("tagged", n) for n in (1, 3, 4, 12, 13, 14, 15))],
)
def test_il3046_warns_where_every_telegram_passes_or_bytes_can_be_exchanged(
    kind: str, machines: int, tmp_path: Path
) -> None:
    """By counting all telegrams; both bits of every point exchanged are no matter of the check."""
    form = form_of([MachineId(f"P{k}") for k in range(1, machines + 1)], kind == "tagged")
    names = [n for n in MISHAPS if n not in ("both bits of every point exchanged", "bytes 1 and 2 exchanged")]
    counted = {n: _passed(form, MISHAPS[n]) for n in names}
    always = {n for n, (every, well, other) in counted.items() if well == every and other}
    pairs = [
        (i + 1, j + 1)
        for i, j in combinations(range(form.size), 2)
        if _passed(form, lambda t, i=i, j=j: _exchanged(t, i, j))[2]  # type: ignore[misc]
    ]
    path = tmp_path / "ladder.yaml"
    path.write_text(ladder(machines, kind), "utf-8")
    found = check_file(str(path))
    told = [d.message for d in found.diagnostics if d.code == "IL3046"]
    assert found.ok and bool(told) is bool(always or pairs)
    if told:
        named = ("every bit inverted", "bits of each byte in reverse", "each byte rotated")
        assert [n in told[0] for n in named] == [any(a.startswith(n) for a in always) for n in named]
        exchanged = re.search(r"bytes (\d) and (\d)", told[0])
        assert ((int(exchanged[1]), int(exchanged[2])) in pairs) if exchanged else not pairs


def test_with_a_gap_between_starts_a_telegram_is_sent_as_il3047_advises() -> None:
    """The outputs of a machine are on only until it has arrived: wired from these alone nothing would ever be sent."""
    text = Path("tests/diagnostics/IL3047.yaml").read_text("utf-8")
    layout, _ = load_text("gap.yaml", text, sink := Sink())
    assert layout is not None and "IL3047" in {d.code for d in sink.diagnostics}
    controller = lower(layout, table := derive(layout, sink))
    plc = runtime_scan(runtime_py(controller, []))
    world = {str(i.name): int(i.name.startswith("CLR_")) for i in controller.inputs} | {"VALID": 1, "DN_P1": 1}

    def scan(**more: int) -> tuple[bool, bool, bool]:
        """Whether there is a command as it is wired from outputs alone and as advised, and whether that is reverse."""
        o = plc.scan({**world, **more}, 1000)
        n, r = o["YN_P1"], o["YR_P1"]
        own = n or (bool(world["DN_P1"]) and not r), r or (bool(world["DR_P1"]) and not n)
        return n != r, own[0] != own[1], own[1]

    for _ in range(round(layout.principles.restart_delay_s) + 2):
        scan()
    scan(RELALL=1)
    assert scan() == (False, True, False)
    route = next(r for r in table.routes if r.exit == "B" and r.entry == "X2")
    scan(REQ=route.number)
    assert [scan() for _ in range(3)][-1] == (True, True, True)
    world |= {"DN_P1": 0, "DR_P1": 1}
    assert [scan() for _ in range(3)][-1] == (False, True, True)
