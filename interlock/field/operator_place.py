"""The operator's place on Modbus TCP: what is said of routes, outputs and alarms, for a SCADA that reads registers.

Input registers and discrete inputs are read; requests are written into holding registers, if that is allowed at all:
what and which, and a number that changes, all at once or the number last, over one connection.  A request is told to
whoever runs the controller, with who asks, and goes the way of every other command.  To cancel is always carried out;
to set or to swing only if it is neither doubtful nor the first since the start, which may be one from before, and one
at a time, so that none waits behind others and comes true late.  Modbus knows no user and no password: the address from
which somebody asks is all there is.  Values that are older than `FRESH_S`, or of no scan, are told as unknown.  Alarms
stand behind the outputs.
Needs the extra `field`.
"""

from __future__ import annotations

import asyncio
import socket
import threading
import time
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import field
from functools import cached_property
from hashlib import sha256
from typing import Any

from interlock.dataclass import dataclass
from interlock.field.frames import Caller, caller
from interlock.field.plc import Cycle
from interlock.logic.controller import Controller
from interlock.logic.words import UNKNOWN
from interlock.spreadsheet import csv_text

FORM = 2
"""The form of these registers: what they mean, and what is done with a request."""
FIRST = 16
"""The input register of the route with the lowest number; those before it are about the controller."""
FRESH_S = 2.0
"""Seconds after which the values of a scan are not told any more (our choice): the controller has stopped."""
WAITING, TAKEN, REFUSED, NOT_KNOWN, INCOMPLETE, FIRST_ONE, USED = range(1, 8)
ANSWERS = {
    0: "no request yet",
    WAITING: "waits for the next scan",
    TAKEN: "taken; what becomes of it is said by the word of the route",
    REFUSED: "refused",
    NOT_KNOWN: "no such request",
    INCOMPLETE: "refused: WHAT and WHICH have to be written with REQUEST or before it, over the same connection",
    FIRST_ONE: "not carried out: the first one since the start may be from before; ask again with another number",
    USED: "not carried out: this number was that of another request; ask again with another number",
}
SET, CANCEL, SWING = 1, 2, 3
DOES = {SET: ("set", "route"), CANCEL: ("cancel", "signal"), SWING: ("swing", "signal")}
"""What can be asked for: the word of the command, and what it is about."""
REQUEST = 3
"""Holding registers of a request: its number, what, which."""
TOGETHER_S = 10.0
"""Seconds before the number within which what and which are written, if not at once with it (our choice)."""

MOST_CANCELS = 200
"""Requests to cancel that may wait for the next scan; one more is answered by the exception that the server is busy."""

NOT_COUNTED = 65_535
"""Said instead of how many alarms stand, where that is not known."""

_HEAD = (
    ("form of these registers", "FORM"),
    ("cycles since the controller started, modulo 65536: it stands still when the controller does", "CYCLE"),
    ("1 while the inputs are valid and a scan is not older than 2 s", "VALID"),
    ("number of the last request that was seen", "SEEN"),
    (f"what became of it: {'; '.join(f'{k} {v}' for k, v in ANSWERS.items())}", "ANSWER"),
    ("1 where requests may be written", "MAY_ASK"),
    (f"how many alarms stand; {NOT_COUNTED}: not known", "ALARMS"),
    ("alarms that have come since the run began, modulo 65536: one that came and went is counted, too", "CAME"),
)
_DIGEST = ("TABLE_HIGH", "TABLE_LOW")
"""After these: what tells this table from that of another layout."""
HEADINGS = ("Kind", "Address", "Name", "Meaning")
Reply = Callable[[bool], None]
Ask = Callable[[str, str, str, Reply], None]
"""Told who asks, what (`set`, `cancel`, `swing`) and for which route or signal, and whom to tell what became of it."""


@dataclass(frozen=True)
class Registers:
    """Where everything stands."""

    words: Sequence[tuple[int, str, str]]
    """Number, variable and route of each word, in the order of their registers."""
    bits: Sequence[tuple[str, str]]
    """Outputs and their meaning, in the order of their discrete inputs."""
    requests: dict[tuple[int, int], str]
    """What and which: the route or the signal."""
    alarms: Sequence[tuple[str, str, str]]
    """Key, variable and meaning of each alarm, in the order of their discrete inputs, behind those of `bits`."""
    codes: Mapping[int, str] = field(default_factory=dict)
    """What each code of a word says."""

    def table(self) -> list[tuple[str, str, str, str]]:
        """A row for each register, discrete input and request."""
        rows = self._rows()
        for k, (name, half) in enumerate(zip(_DIGEST, self.digest, strict=True), len(_HEAD)):
            text = f"always {half}: what reads otherwise belongs to another layout, and so to another table"
            rows.insert(k, ("input register", str(k), name, text))
        return rows

    @cached_property
    def digest(self) -> tuple[int, int]:
        """Two registers that tell this table, and what its codes say, from others."""
        rows = [",".join(row[:3]) for row in self._rows()]
        rows += [f"code {code}: {text}" for code, text in sorted(self.codes.items())]
        said = sha256("\n".join(rows).encode()).digest()
        return int.from_bytes(said[:2], "big"), int.from_bytes(said[2:4], "big")

    def _rows(self) -> list[tuple[str, str, str, str]]:
        rows = [("input register", str(k), name, text) for k, (text, name) in enumerate(_HEAD)]
        for k, (_, name, route) in enumerate(self.words, FIRST):
            rows.append(
                ("input register", str(k), name, f"word of route {route}: io/words.csv says what a value means")
            )
        rows += [("discrete input", str(k), name, note) for k, (name, note) in enumerate(self.bits)]
        for k, (_, name, text) in enumerate(self.alarms, len(self.bits)):
            rows.append(("discrete input", str(k), name, f"alarm: {text}"))
        asked = (
            (
                0,
                "REQUEST",
                "a number other than before: the request in the next two registers is carried out once; write all "
                "three at once (function 16), or these two first and REQUEST last, over one connection; 0 by itself "
                "asks for nothing",
            ),
            (1, "WHAT", "what is asked for; 0 again after each request"),
            (2, "WHICH", "for which; 0 again after each request"),
        )
        rows += [("holding register", str(k), name, text) for k, name, text in asked]
        for (what, which), name in self.requests.items():
            rows.append(("request", f"{what} {which}", f"{DOES[what][0]} {name}", f"WHAT {what}, WHICH {which}"))
        return rows

    def csv(self) -> str:
        """The same as a file."""
        return csv_text([HEADINGS, *self.table()])


def registers(controller: Controller, alarms: Sequence[tuple[str, str, str]]) -> Registers:
    """The registers of a controller; outputs with a wire stand among the others.  `alarms`: key, variable, meaning."""
    symbols, words = controller.symbols, controller.words
    routes = {r.number: str(r.id) for r in symbols.routes}
    requests = {(SET, n): name for n, name in sorted(routes.items())}
    requests |= {(CANCEL, k): str(g) for k, g in enumerate(symbols.cancellation.cancel, 1)}
    requests |= {(SWING, k): str(g) for k, g in enumerate(symbols.overlaps.swing_request, 1)}
    return Registers(
        [(n, str(words.routes[n]), routes[n]) for n in sorted(words.routes)],
        [(str(o.name), o.note) for o in controller.outputs],
        requests,
        alarms,
        {code: words.said(code) for code in words.reasons},
    )


@dataclass(frozen=True)
class _Image:
    """What is told: of one scan, or of none."""

    cycle: int = 0
    valid: bool = False
    words: tuple[int, ...] = ()
    bits: tuple[bool, ...] = ()
    alarms: int = NOT_COUNTED
    came: int = 0
    at: float = float("-inf")


def _family(place: tuple[str, int]) -> socket.AddressFamily:
    return socket.getaddrinfo(*place, type=socket.SOCK_STREAM)[0][0]


class OperatorPlace:
    """A server in a thread of its own; `publish` after each cycle, `ask` is told of requests (None: none are taken)."""

    def __init__(
        self,
        registers: Registers,
        host: str,
        port: int,
        ask: Ask | None = None,
        now: Callable[[], float] = time.monotonic,
    ) -> None:
        self.registers, self.place, self.asks, self._now = registers, (host, port), ask, now
        self._image = _Image()
        self._stood: frozenset[str] = frozenset()
        self._request = (0, 0)  # the number of the last request, and what became of it
        self._first = True  # nothing was asked for since the start but to cancel
        self._waits: object = None  # the request to set or to swing that nobody has answered yet
        self._cancels: set[object] = set()  # requests to cancel that nobody has answered yet
        self._ready = threading.Event()
        self._failed = ""
        self._thread = threading.Thread(target=self._run, name="operator's place", daemon=True)

    def start(self) -> None:
        """Begin to answer.  Raises OSError where that cannot be."""
        socket.create_server(self.place, family=_family(self.place)).close()  # says why not, where that cannot be
        self._thread.start()
        self._ready.wait(10.0)
        if self._failed:
            raise OSError(self._failed)

    def stop(self) -> None:
        """Answer no more."""
        if self._thread.is_alive():
            self._loop.call_soon_threadsafe(self._end.set)
            self._thread.join(5.0)

    def publish(self, cycle: Cycle | None, alarms: Iterable[str]) -> None:
        """What a scan has said, and the keys of the alarms that stand, each with its bit or with that of its first word
        (`train 12`: `train`); None: the controller has no power."""
        last = self._image
        if cycle is None:
            self._image, self._stood = _Image(last.cycle, came=last.came), frozenset()
            return
        stand = frozenset(alarms)
        lit = stand | {key.partition(" ")[0] for key in stand}
        words = cycle.words()
        self._image = _Image(
            (last.cycle + 1) % 65536,
            cycle.valid,
            tuple(words.get(n, UNKNOWN) for n, _, _ in self.registers.words),
            (
                *(bool(cycle.outputs.get(name)) for name, _ in self.registers.bits),
                *(key in lit for key, _, _ in self.registers.alarms),
            ),
            min(len(stand), NOT_COUNTED - 1),
            (last.came + len(stand - self._stood)) % 65536,
            self._now(),
        )
        self._stood = stand

    # --- the thread --------------------------------------------------------------------------------

    def _run(self) -> None:
        try:
            asyncio.run(self._serve())
        except (OSError, RuntimeError) as error:
            self._failed = str(error) or type(error).__name__
        finally:
            self._ready.set()

    async def _serve(self) -> None:
        from pymodbus.simulator import DataType, SimData, SimDevice

        from interlock.field.connection import Server

        self._loop, self._end = asyncio.get_running_loop(), asyncio.Event()
        bits = len(self.registers.bits) + len(self.registers.alarms)
        counts = (16, max(16, bits), REQUEST, FIRST + len(self.registers.words))
        types = (DataType.BITS, DataType.BITS, DataType.REGISTERS, DataType.REGISTERS)
        coils, inputs, holding, words = (
            [SimData(0, values=[False] * n if t is DataType.BITS else [0] * n, datatype=t)]
            for n, t in zip(counts, types, strict=True)
        )
        device = SimDevice(0, simdata=(coils, inputs, holding, words), action=self._act)
        server = Server(device, address=self.place)
        await server.serve_forever(background=True)
        self._ready.set()
        try:
            await self._end.wait()
        finally:
            await server.shutdown()  # type: ignore[no-untyped-call]

    async def _act(
        self, function: int, start: int, address: int, count: int, held: list[int], values: list[Any] | None
    ) -> Any:
        """Before anything is read or written: put what is so now in its place, or take a request."""
        from pymodbus.constants import ExcCodes

        del start, count
        image = self._fresh()
        if values:
            if self.asks is None or function not in (6, 16):
                return ExcCodes.ILLEGAL_FUNCTION
            if address + len(values) > REQUEST:
                return ExcCodes.ILLEGAL_ADDRESS
            return self._write(caller.get(), address, values, held, image)
        if function == 3:
            held[:] = [held[0], *(self._pair(caller.get()).get(k, 0) for k in range(1, REQUEST))]
        elif function == 2:
            bits = [*image.bits, *[False] * (16 * len(held))]
            held[:] = [sum(bit << n for n, bit in enumerate(bits[16 * k : 16 * k + 16])) for k in range(len(held))]
        elif function == 4:
            head = [FORM, image.cycle, int(image.valid), *self._request, int(self.asks is not None)]
            head += [image.alarms, image.came, *self.registers.digest]
            told = [*head, *[0] * (FIRST - len(head)), *image.words]
            held[:] = [*told, *[0] * (len(held) - len(told))]
        return None

    def _fresh(self) -> _Image:
        """What is so now; nothing, where the last scan is too old."""
        image = self._image
        return image if self._now() - image.at <= FRESH_S else _Image(image.cycle, came=image.came)

    def _pair(self, who: Caller) -> dict[int, int]:
        """What somebody has written of a request since his last one, and not too long ago."""
        return {k: value for k, (value, at) in who.pair.items() if self._now() - at <= TOGETHER_S}

    def _write(self, who: Caller, address: int, values: list[Any], held: list[int], image: _Image) -> Any:
        """What is asked for is carried out only if it was written together with its number, or before it over the same
        connection; it is cleared with each request.  Who writes the number first would ask for what he wanted the time
        before: after that his numbers ask for nothing until he writes all at once, or the number 0."""
        written = dict(enumerate(values, address))
        who.pair |= {k: (value, self._now()) for k, value in written.items() if k}
        number, whole, pair = written.get(0), len(written) == REQUEST, self._pair(who)
        values[:] = [x if k == 0 else 0 for k, x in written.items()]
        if number is None or (number == held[0] and not pair):
            return None
        complete = whole or (not who.number_first and len(pair) == REQUEST - 1)
        nothing = not number and (not whole or not any(pair.values()))
        if complete and not nothing:
            busy = self._take(who, (number, pair[1], pair[2]), number == held[0], image)
            if busy:
                return busy
        elif number and number != held[0]:
            self._request = (number, INCOMPLETE)
        who.number_first = bool(number) and (not complete)
        who.pair.clear()
        return None

    def _take(self, who: Caller, wanted: tuple[int, int, int], used: bool, image: _Image) -> Any:
        """A request, which is told on once, however often it is written; the exception where it cannot be."""
        from pymodbus.constants import ExcCodes

        number, what, which = wanted
        name = self.registers.requests.get((what, which))
        if who.last == wanted:
            return None
        used |= who.last is not None and who.last[0] == number
        cancels = what == CANCEL and name is not None
        if cancels and len(self._cancels) >= MOST_CANCELS:
            return ExcCodes.DEVICE_BUSY
        who.last = wanted
        first, self._first = self._first and not cancels, self._first and cancels
        if name is None:
            self._request = (number, NOT_KNOWN)
        elif not cancels and (first or used):
            self._request = (number, FIRST_ONE if first else USED)
        elif self.asks is None or (not cancels and (not image.valid or self._waits is not None)):
            self._request = (number, REFUSED)
        else:
            self._tell(who, number, DOES[what][0], name, cancels)
        return None

    def _tell(self, who: Caller, number: int, what: str, name: str, cancels: bool) -> None:
        """Hand a request on, and say what becomes of it."""
        assert self.asks is not None
        this = self._request = (number, WAITING)
        ticket = object()
        if cancels:
            self._cancels.add(ticket)
        else:
            self._waits = ticket

        def reply(taken: bool) -> None:
            self._cancels.discard(ticket)
            if self._waits is ticket:
                self._waits = None
            if self._request is this:
                self._request = (number, TAKEN if taken else REFUSED)

        self.asks(f"modbus {who.name}", what, name, reply)


__all__ = ["DOES", "OperatorPlace", "Registers", "registers"]
