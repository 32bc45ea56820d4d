"""One connection to a Modbus TCP server: frames are taken one after the other, and whatever is no Modbus ends it.

pymodbus throws away what does not fit and reads on, and has one place for a request: behind enough rubbish, which any
web page may send to this computer, it found a frame, and of two frames that came together it lost one.  Here the first
byte that cannot belong to a request closes the connection, and nothing behind it is read.
Needs the extra `field`.
"""

from __future__ import annotations

from collections import deque
from typing import Any

from pymodbus.constants import ExcCodes
from pymodbus.pdu import ExceptionResponse
from pymodbus.server import ModbusTcpServer
from pymodbus.server.requesthandler import ServerRequestHandler

from interlock.field.frames import FIXED, WRITES, Caller, Frame, NotModbus, caller, frames
from interlock.field.sockets import keeps_alive, most

IDLE_S = 60.0
"""Seconds after which a connection over which nothing was asked is let go (our choice)."""

PIPELINED = 16
"""Requests of one connection that may wait for their answer (our choice)."""


class Connection(ServerRequestHandler):
    """One client: what he asks is answered in its order."""

    def __init__(self, server: ModbusTcpServer) -> None:
        super().__init__(server, server.trace_packet, server.trace_pdu, server.trace_connect)  # type: ignore[no-untyped-call]
        self._asks = self._works = False
        self._rest = b""
        self._frames: deque[Frame] = deque()
        self._caller = Caller("unknown")

    def callback_connected(self) -> None:
        """Somebody has come."""
        super().callback_connected()
        if sock := self.transport.get_extra_info("socket"):
            keeps_alive(sock)
        if found := self.transport.get_extra_info("peername"):
            self._caller = Caller(f"{found[0]}:{found[1]}")
        if len(self.server.active_connections) > most():
            self.loop.call_soon(self.close)
        self.loop.call_later(IDLE_S, self._look)

    def _look(self) -> None:
        if not self._asks:
            self.close()
        elif not self.is_closing:
            self._asks = False
            self.loop.call_later(IDLE_S, self._look)

    def data_received(self, data: bytes) -> None:
        """Some bytes have come."""
        if self.is_closing:
            return
        try:
            found, self._rest = frames(self._rest + data)
        except NotModbus:
            self._frames.clear()
            self.close()
            return
        self._frames.extend(found)
        if len(self._frames) > PIPELINED:
            self._frames.clear()
            self.close()
        elif self._frames and not self._works:
            self._works = True
            self._working = self.loop.create_task(self._work())

    async def _work(self) -> None:
        caller.set(self._caller)
        try:
            while self._frames and not self.is_closing:
                self._asks = True
                await self._answer(self._frames.popleft())
        finally:
            self._works = False

    async def _answer(self, frame: Frame) -> None:
        known = frame.request[0] in (*FIXED, WRITES)
        pdu: Any = self.server.decoder.decode(frame.request) if known else None
        if pdu is None:
            no = ExceptionResponse(frame.request[0], ExcCodes.ILLEGAL_FUNCTION, frame.device, frame.transaction)
            self.server_send(no, None)  # type: ignore[no-untyped-call]
            return
        pdu.dev_id, pdu.transaction_id = frame.device, frame.transaction
        self.last_pdu, self.last_addr = pdu, None
        await self.handle_request()  # type: ignore[no-untyped-call]


class Server(ModbusTcpServer):
    """A server of such connections."""

    def callback_new_connection(self) -> Connection:
        """Somebody comes."""
        return Connection(self)


__all__ = ["Connection", "Server"]
