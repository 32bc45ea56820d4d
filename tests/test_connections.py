"""Connections to the panel and to the operator's place: those that ask for nothing go, and never use up the files of
the process."""

from __future__ import annotations

import json
import socket
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

import pytest
import websockets.sync.client

from interlock.app.run import Ready
from interlock.field import connection as modbus_connection
from interlock.field import sockets
from interlock.field.operator_place import OperatorPlace
from interlock.panel import connection, server
from interlock.panel.desk import Desk
from interlock.panel.server import Access, listening, serve
from tests.layouts import built
from tests.test_operator_place import free_port, place_of


@pytest.fixture
def quick(monkeypatch: pytest.MonkeyPatch) -> None:
    """Whoever asks for nothing goes soon, and few may come."""
    monkeypatch.setattr(connection, "HELLO_S", 0.3)
    monkeypatch.setattr(server, "HELLO_S", 0.3)
    monkeypatch.setattr(modbus_connection, "IDLE_S", 0.3)
    for module in (connection, modbus_connection):
        monkeypatch.setattr(module, "most", lambda: 4)


@contextmanager
def panel(ready: Ready) -> Iterator[int]:
    """A panel that is served; its port."""
    sock, desk = listening("127.0.0.1", 0), Desk(ready)
    port: int = sock.getsockname()[1]
    thread = threading.Thread(target=serve, args=(desk, Access(), sock))
    thread.start()
    try:
        yield port
    finally:
        desk._stop.set()
        thread.join(20.0)
        assert not thread.is_alive()


def gone(client: socket.socket) -> bool:
    """Whether the server lets go of it within some seconds."""
    client.settimeout(5.0)
    try:
        return client.recv(1) == b""
    except ConnectionError:
        return True


def comes(so: Callable[[], Any]) -> Any:
    """What is so at last."""
    end = time.monotonic() + 10
    while True:
        try:
            return so()
        except OSError:
            assert time.monotonic() < end
            time.sleep(0.05)


def get(port: int) -> bytes:
    """The page of the panel."""
    with socket.create_connection(("127.0.0.1", port), 5) as client:
        client.sendall(b"GET / HTTP/1.1\r\nHost: 127.0.0.1\r\nConnection: close\r\n\r\n")
        return client.recv(15)


@pytest.mark.usefixtures("quick")
@pytest.mark.parametrize("said", [b"", b"GET / HTTP/1.1\r\nHost: 12"])
def test_who_asks_for_nothing_is_let_go(ready: Ready, said: bytes) -> None:
    """Eighty that were idle took all the files that a process may have, and the page and the record were gone."""
    with panel(ready) as port:
        idle = [socket.create_connection(("127.0.0.1", port), 5) for _ in range(12)]
        for client in idle[:4]:
            client.sendall(said)
        assert all(gone(client) for client in idle)
        assert comes(lambda: get(port)) == b"HTTP/1.1 200 OK"
        for client in idle:
            client.close()


@pytest.mark.usefixtures("quick")
def test_a_browser_says_who_it_is_and_may_then_be_silent(ready: Ready) -> None:
    with panel(ready) as port:
        silent = websockets.sync.client.connect(f"ws://127.0.0.1:{port}/talk")
        with silent, pytest.raises(websockets.exceptions.ConnectionClosed):
            silent.recv(5)
        with websockets.sync.client.connect(f"ws://127.0.0.1:{port}/talk") as ws:
            ws.send(json.dumps({"name": "Ann"}))
            end = time.monotonic() + 1.0
            while time.monotonic() < end:
                ws.recv(5)
            assert get(port) == b"HTTP/1.1 200 OK"


@pytest.mark.usefixtures("quick")
def test_a_scada_that_asks_for_nothing_is_let_go_and_one_that_asks_stays() -> None:
    place = OperatorPlace(place_of(*built("fig2_2")[::2]), "127.0.0.1", free_port())
    place.start()
    try:
        idle = [socket.create_connection(place.place, 5) for _ in range(8)]
        assert all(gone(client) for client in idle)
        with socket.create_connection(place.place, 5) as client:
            for k in range(8):
                client.sendall(bytes([0, k, 0, 0, 0, 6, 1, 4, 0, 0, 0, 1]))
                assert client.recv(100)[:2] == bytes([0, k])
                time.sleep(0.1)
        for one in idle:
            one.close()
    finally:
        place.stop()


def test_the_system_asks_whether_the_other_end_is_there() -> None:
    """One whose cable was pulled stayed for ever."""
    sock = listening("127.0.0.1", 0)
    with sock, socket.create_connection(sock.getsockname()):
        taken, _ = sock.accept()
        assert taken.getsockopt(socket.SOL_SOCKET, socket.SO_KEEPALIVE) == 1
        taken.close()
    assert 1 <= sockets.most() <= sockets.MOST
