"""A connection to the panel's server: one that asks for nothing is let go, and so is one too many."""

from __future__ import annotations

import asyncio
from typing import Any

from uvicorn.protocols.http.h11_impl import H11Protocol

from interlock.field.sockets import most

HELLO_S = 5.0
"""Seconds for which a connection may ask for nothing, and a browser say nothing of itself (our choice)."""


class Connection(H11Protocol):
    """One that has become the socket of a browser is not looked at any more: the server asks that itself whether it is
    there."""

    _before: Any = None

    def connection_made(self, transport: asyncio.Transport) -> None:  # type: ignore[override]
        """See `asyncio.Protocol`."""
        super().connection_made(transport)
        if len(self.connections) > most():
            transport.abort()
        else:
            self.loop.call_later(HELLO_S, self._look)

    def _look(self) -> None:
        if self.transport.is_closing() or self.transport.get_protocol() is not self:
            return
        if self.cycle is self._before and (self.cycle is None or self.cycle.response_complete):
            self.transport.abort()
            return
        self._before = self.cycle
        self.loop.call_later(HELLO_S, self._look)
