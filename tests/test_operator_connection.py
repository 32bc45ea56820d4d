"""Connections to the operator's place on Modbus, byte by byte: whose request is whose, and what is none at all."""

from __future__ import annotations

import random
import socket
import struct
from collections.abc import Iterator
from contextlib import contextmanager

import pytest

from interlock.field.connection import PIPELINED
from interlock.field.frames import LARGEST, NotModbus, frames
from interlock.field.operator_place import (
    CANCEL,
    FIRST_ONE,
    INCOMPLETE,
    MOST_CANCELS,
    REFUSED,
    SET,
    TAKEN,
    USED,
    WAITING,
    OperatorPlace,
    Reply,
)
from tests.layouts import built
from tests.test_operator_place import free_port, place_of, said


def frame(request: bytes, transaction: int = 1) -> bytes:
    return struct.pack(">HHHB", transaction, 0, len(request) + 1, 1) + request


def poll(address: int, count: int) -> bytes:
    return struct.pack(">BHH", 4, address, count)


def register(address: int, value: int) -> bytes:
    return struct.pack(">BHH", 6, address, value)


def all_three(*values: int) -> bytes:
    return struct.pack(">BHHB3H", 16, 0, 3, 6, *values)


class Client:
    """A client that sends what it likes."""

    def __init__(self, port: int) -> None:
        self.sock = socket.create_connection(("127.0.0.1", port), 5)
        self.sock.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self.port: int = self.sock.getsockname()[1]

    def answers(self, number: int) -> list[tuple[int, bytes]]:
        """So many answers, each with its transaction; fewer where the server lets go."""
        found, data = list[tuple[int, bytes]](), b""
        try:
            while len(found) < number and (more := self.sock.recv(4096)):
                data += more
                while len(data) >= 6 and len(data) >= (size := 6 + int.from_bytes(data[4:6], "big")):
                    found.append((int.from_bytes(data[:2], "big"), data[7:size]))
                    data = data[size:]
        except ConnectionError:
            pass
        return found

    def one(self, request: bytes) -> bytes:
        self.sock.sendall(frame(request))
        return self.answers(1)[0][1]

    def said(self) -> tuple[int, int]:
        """SEEN and ANSWER."""
        seen, answer = struct.unpack(">2H", self.one(poll(3, 2))[2:])
        return seen, answer

    def asks(self, *values: int) -> tuple[int, int]:
        """Write a request at once; SEEN and ANSWER then."""
        assert self.one(all_three(*values))[0] == 16
        return self.said()

    @property
    def gone(self) -> bool:
        return self.answers(1) == []


class Place:
    """An operator's place, what was asked there, and its clients."""

    def __init__(self) -> None:
        self.asked: list[tuple[str, str, str]] = []
        self.replies: list[Reply] = []
        self.place = OperatorPlace(place_of(*built("fig2_2")[::2]), "127.0.0.1", free_port(), self._ask)
        self.clients: list[Client] = []
        self.place.start()
        self.scan()

    def _ask(self, who: str, what: str, name: str, reply: Reply) -> None:
        self.asked.append((who, what, name))
        self.replies.append(reply)

    def scan(self) -> None:
        """A scan takes all that waits."""
        replies, self.replies = self.replies, []
        for reply in replies:
            reply(True)
        self.place.publish(said(), ())

    def client(self) -> Client:
        self.clients.append(Client(self.place.place[1]))
        return self.clients[-1]


@contextmanager
def _served() -> Iterator[Place]:
    place = Place()
    try:
        yield place
    finally:
        for client in place.clients:
            client.sock.close()
        place.place.stop()


@pytest.fixture
def fresh() -> Iterator[Place]:
    """As after a start."""
    with _served() as place:
        yield place


@pytest.fixture
def served(fresh: Place) -> Place:
    """The first request since the start, which is not carried out, has been made."""
    assert fresh.client().asks(1, SET, 2) == (1, FIRST_ONE)
    return fresh


WEB_PAGE = b"POST / HTTP/1.1\r\nHost: 127.0.0.1\r\nContent-Length: 9\r\n\r\n"


@pytest.mark.parametrize(
    "rubbish",
    [
        WEB_PAGE,
        WEB_PAGE + 300 * b"A",
        300 * b"A",
        b"\x16\x03\x01\x02\x00\x01\x00",
        bytes([0, 1, 0, 1, 0, 6]),
        bytes([0, 1, 0, 0, 1, 0]),
        bytes([0, 1, 0, 0, 0, 1, 1]),
        bytes([0, 1, 0, 0, 0, LARGEST + 1, 1]),
        frame(b"\x00"),
        frame(b"\x84\x02"),
        frame(poll(0, 1) + b"\x00"),
        frame(poll(0, 1)[:4]),
        frame(struct.pack(">BHHB2H", 16, 0, 3, 4, 1, 1)),
        frame(struct.pack(">BHHB3H", 16, 0, 3, 6, 1, 1, 1) + b"\x00"),
    ],
    ids=lambda x: x[:9].hex(),
)
@pytest.mark.parametrize("good", [0, 1])
def test_what_is_no_modbus_closes_the_connection_and_nothing_behind_it_is_read(
    served: Place, rubbish: bytes, good: int
) -> None:
    """A web page sent sixteen thousand letters and a request behind them: the buffer was emptied, the request found."""
    client = served.client()
    client.sock.sendall(good * frame(poll(0, 1)) + rubbish)
    try:
        for k in range(3):
            client.sock.sendall(frame(all_three(50 + k, SET, 1)))
    except ConnectionError:
        pass
    assert client.gone and not served.asked
    assert served.client().said() == (1, FIRST_ONE)


def test_a_request_may_come_byte_by_byte_or_many_at_once(served: Place) -> None:
    """Of two that came together one was dropped, and nobody told."""
    client = served.client()
    for byte in frame(all_three(7, SET, 1), 300):
        client.sock.sendall(bytes([byte]))
    assert [n for n, _ in client.answers(1)] == [300] and served.asked[-1][1:] == ("set", "X1-A")
    for both in (True, False):
        two = [frame(poll(0, 10), 1), frame(all_three(100 + both, CANCEL, 1), 2)]
        for part in [b"".join(two)] if both else two:
            client.sock.sendall(part)
        assert [n for n, _ in client.answers(2)] == [1, 2] and served.asked.pop()[1:] == ("cancel", "X1")
    many = [register(1, CANCEL), register(2, 1), register(0, 130), poll(3, 2)]
    client.sock.sendall(b"".join(frame(r, k) for k, r in enumerate(many)))
    *_, last = found = client.answers(4)
    assert [n for n, _ in found] == [0, 1, 2, 3] and struct.unpack(">2H", last[1][2:]) == (130, WAITING)
    client.sock.sendall(b"".join(frame(poll(0, 1), k) for k in range(PIPELINED)))
    assert [n for n, _ in client.answers(PIPELINED)] == [*range(PIPELINED)]


def test_functions_that_are_not_answered_are_told_so(served: Place) -> None:
    client = served.client()
    for function in (5, 7, 8, 15, 20, 22, 23, 43, 100):
        assert client.one(bytes([function, 0, 0, 0, 1])) == bytes([function | 128, 1])
    assert client.one(poll(0, 1))[:2] == b"\x04\x02"


def test_requests_are_found_in_any_bytes_or_the_connection_is_closed() -> None:
    """Whatever comes: what is found is whole, and what is kept could still become a request."""
    rng = random.Random(7)
    for _ in range(3000):
        data = bytes(rng.choice((0, 0, 0, 1, 3, 5, 6, 16, 255)) for _ in range(rng.randrange(40)))
        data = frame(poll(1, rng.randrange(9))) * rng.randrange(3) + data
        try:
            found, rest = frames(data)
        except NotModbus:
            continue
        whole = [frame(f.request, f.transaction)[:6] + bytes([f.device]) + f.request for f in found]
        assert b"".join(whole) + rest == data
        assert len(rest) < 6 or len(rest) < 6 + rest[5] <= 6 + LARGEST
    one = frame(all_three(1, 1, 1))
    for cut in range(len(one)):
        assert frames(one[:cut]) == ([], one[:cut])


def test_the_first_request_since_the_start_is_not_carried_out(fresh: Place) -> None:
    """A client that wrote once more what it had written before the restart had the route set again."""
    client = fresh.client()
    assert client.asks(77, SET, 1) == (77, FIRST_ONE) and not fresh.asked
    assert client.asks(77, SET, 1) == (77, FIRST_ONE) and fresh.client().asks(77, SET, 1) == (77, USED)
    assert client.asks(78, SET, 1) == (78, WAITING) and fresh.asked[-1][1:] == ("set", "X1-A")


def test_one_that_cancels_is_carried_out_first_or_not(fresh: Place) -> None:
    client = fresh.client()
    assert client.asks(77, CANCEL, 1) == (77, WAITING) and fresh.asked[-1][1:] == ("cancel", "X1")
    assert client.asks(78, SET, 1) == (78, FIRST_ONE) and len(fresh.asked) == 1


def test_a_number_that_was_used_for_something_else_is_not_said_to_be_taken(served: Place) -> None:
    """A client that counted anew cancelled under a number of before: `taken`, and the signal stayed open."""
    assert served.client().asks(6, SET, 1) == (6, WAITING)
    served.scan()
    again = served.client()
    assert again.said() == (6, TAKEN)
    assert again.asks(6, CANCEL, 1) == (6, WAITING) and served.asked[-1][1:] == ("cancel", "X1")
    served.scan()
    assert again.said() == (6, TAKEN)
    assert served.client().asks(6, CANCEL, 1) == (6, WAITING) and len(served.asked) == 3, "from elsewhere it is another"
    served.scan()
    assert again.asks(6, SET, 1) == (6, USED)
    assert again.asks(6, SET, 3) == (6, USED) and len(served.asked) == 3
    assert again.asks(8, SET, 3) == (8, WAITING)
    served.scan()
    assert again.asks(8, SET, 3) == (8, TAKEN) and len(served.asked) == 4, "one request, however often it is written"


def test_what_two_clients_write_is_not_mixed(served: Place) -> None:
    """One wrote to cancel, another to set, the first one its number: the route was set in its name."""
    first, second = served.client(), served.client()
    for client, what in ((first, CANCEL), (second, SET)):
        client.one(register(1, what))
        client.one(register(2, 1))
    assert first.one(struct.pack(">BHH", 3, 0, 3))[2:] == struct.pack(">3H", 1, CANCEL, 1)
    first.one(register(0, 140))
    assert served.asked == [(f"modbus 127.0.0.1:{first.port}", "cancel", "X1")] and first.said() == (140, WAITING)
    third = served.client()
    third.one(register(0, 141))
    assert third.said() == (141, INCOMPLETE), "what others have written is not asked for"
    second.one(register(0, 142))
    assert served.asked[1:] == [(f"modbus 127.0.0.1:{second.port}", "set", "X1-A")]


def test_one_request_waits_and_to_cancel_waits_for_none(served: Place) -> None:
    """Three hundred were kept, one was taken in a scan: to cancel came true half a minute later."""
    client = served.client()
    assert client.asks(10, SET, 1) == (10, WAITING)
    for number in range(11, 40):
        assert client.asks(number, SET, 1 + number % 4) == (number, REFUSED)
    assert client.asks(40, CANCEL, 1) == (40, WAITING)
    assert [x[1:] for x in served.asked] == [("set", "X1-A"), ("cancel", "X1")]
    served.scan()
    assert client.said() == (40, TAKEN) and client.asks(41, SET, 2) == (41, WAITING)


def test_who_cancels_without_end_is_told_that_it_was_not_taken(served: Place) -> None:
    """More than a scan can take are not kept, and not acknowledged either."""
    client = served.client()
    for number in range(MOST_CANCELS):
        assert client.one(all_three(100 + number, CANCEL, 1 + number % 3))[0] == 16
    assert client.one(all_three(999, CANCEL, 1)) == bytes([16 | 128, 6])
    assert client.said()[0] != 999 and len(served.asked) == MOST_CANCELS
    served.scan()
    assert client.asks(999, CANCEL, 1) == (999, WAITING)
