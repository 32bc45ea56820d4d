"""The panel's server: pages as files, and one socket for each browser, over which everything else goes.

Nothing is shown and nothing taken before a browser has said who it is and, where tokens are asked for, has given one.
A page of another origin cannot open the socket, nor one that has made its own name lead to this computer.
"""

from __future__ import annotations

import asyncio
import hmac
import json
import socket
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager, suppress
from importlib import resources
from types import FrameType
from typing import Any
from urllib.parse import urlsplit

import uvicorn
from starlette.applications import Starlette
from starlette.requests import Request
from starlette.responses import Response
from starlette.routing import Route, WebSocketRoute
from starlette.websockets import WebSocket, WebSocketDisconnect

from interlock.dataclass import dataclass
from interlock.field.sockets import keeps_alive
from interlock.panel import entry
from interlock.panel.browsers import clock, sent
from interlock.panel.connection import HELLO_S, Connection
from interlock.panel.desk import Desk
from interlock.panel.operating import Person

FILES = {
    "": ("index.html", "text/html"),
    "panel.css": ("panel.css", "text/css"),
    **{n: (n, "text/javascript") for n in ("panel.js", "plan.js", "slips.js", "acts.js", "rows.js", "talk.js")},
}
"""What is served, and as what."""

HEADERS = {
    "Content-Security-Policy": "default-src 'none'; script-src 'self'; style-src 'self' 'unsafe-inline'; "
    "connect-src 'self'; img-src data:; base-uri 'none'; frame-ancestors 'none'; form-action 'none'",
    "Cache-Control": "no-store",
    "X-Content-Type-Options": "nosniff",
    "Referrer-Policy": "no-referrer",
}

LOCAL = ("127.0.0.1", "localhost", "::1")
"""Names of this computer itself."""

BEHIND = 200
"""Messages that may wait for one browser; one that falls behind further is let go, and comes back by itself."""

WAITING = 50
"""Commands of one browser that may wait for the next cycle; so many again where they put all signals to stop, which is
not refused because of others (our choice)."""

LOOKS_S = 0.05
"""Seconds between two messages that are read of a browser that only looks (our choice)."""

NOT_DATED = "it does not say when it was asked for, and is not done"

LARGEST = 4096
"""Characters of a command at most."""

LONGEST = 200 * entry.MOST_ALARMS
"""The same of one that acknowledges alarms, each of which it names."""


BACKLOG = 64
"""Connections that wait to be taken, and are taken at once."""


@dataclass(frozen=True)
class Access:
    """Tokens for operating and for looking; both empty where only this computer can reach the panel."""

    operate: str = ""
    look: str = ""

    def admits(self, host: str, origin: str | None) -> bool:
        """Whether a browser may open the socket: from a page of this panel, and, where no token is asked for, only
        under a name of this computer itself, so that no other name can be made to lead here."""
        try:
            if origin is not None and urlsplit(origin).netloc != host:
                return False
            return bool(self.operate) or urlsplit(f"//{host}").hostname in LOCAL
        except ValueError:  # the address of no host
            return False

    def person(self, hello: Any) -> Person | None:
        """Who says hello; None for somebody who may not even look."""
        if not isinstance(hello, dict):
            return None
        name = entry.name(hello.get("name"))
        given = str(hello.get("token", "")).encode(errors="surrogatepass")
        if not self.operate and not self.look:
            return Person(name, not hello.get("look"))
        if self.operate and hmac.compare_digest(given, self.operate.encode()):
            return Person(name, not hello.get("look"))
        if self.look and hmac.compare_digest(given, self.look.encode()):
            return Person(name, False)
        return None


def application(desk: Desk, access: Access) -> Starlette:
    """The panel as an ASGI application; the desk runs while it does."""

    @asynccontextmanager
    async def life(app: Starlette) -> AsyncIterator[None]:
        desk.start()
        try:
            yield
        finally:
            await asyncio.to_thread(desk.stop)

    async def file(request: Request) -> Response:
        name, kind = FILES[request.url.path.removeprefix("/")]
        text = resources.files("interlock.panel").joinpath("page", name).read_bytes()
        return Response(text, media_type=kind, headers=HEADERS)

    async def talk(ws: WebSocket) -> None:
        if not access.admits(ws.headers.get("host", ""), ws.headers.get("origin")):
            await ws.close(1008)
            return
        await ws.accept()
        with suppress(WebSocketDisconnect, RuntimeError):  # a browser may go at any moment
            await _Talk(desk, access, ws).run()

    routes = [*(Route(f"/{path}", file) for path in FILES), WebSocketRoute("/talk", talk)]
    return Starlette(routes=routes, lifespan=life)


class _Talk:
    """One browser."""

    def __init__(self, desk: Desk, access: Access, ws: WebSocket) -> None:
        self.desk, self.access, self.ws = desk, access, ws
        self.loop = asyncio.get_running_loop()
        self.out: asyncio.Queue[str | None] = asyncio.Queue(BEHIND)
        self.waiting = 0

    async def run(self) -> None:
        """From hello until it goes."""
        try:
            hello = await asyncio.wait_for(self._read(), HELLO_S)
        except TimeoutError:
            await self.ws.close(1008)
            return
        who = self.access.person(hello)
        if who is None:
            given = isinstance(hello, dict) and hello.get("token")
            why = "this token is none of this panel's" if given else "this panel asks for a token"
            await self.ws.send_text(sent({"refused": why}))
            await self.ws.close(1008)
            return
        first = self.desk.browsers.listen(self._tell)
        sending = asyncio.create_task(self._send())
        try:
            await self.ws.send_text(sent({"hello": {"operates": who.operates}, **first}))
            while True:
                command = await self._read()
                if not isinstance(command, dict):
                    break
                self._ask(who, command)
                if not who.operates:
                    await asyncio.sleep(LOOKS_S)
        finally:
            self.desk.browsers.forget(self._tell)
            sending.cancel()
            with suppress(RuntimeError):  # it is closed already
                await self.ws.close(1003)

    def _ask(self, who: Person, command: dict[str, Any]) -> None:
        """Hand on a command, if not too many wait; it is answered by the mark that the browser gave to it."""
        mark = entry.mark(command.get("re"))
        if command.get("do") == entry.CLOCK:
            self._queue(clock(mark))
            return
        if self.waiting >= WAITING * (2 if command.get("do") == "stop" else 1):
            why = f"{self.waiting} commands of this browser wait to be carried out: it is not done, ask again"
            self._queue(sent({"re": mark, "ok": False, "why": [[why, []]]}))
            return
        self.waiting += 1
        why_not = "" if entry.dated(command) else NOT_DATED
        self.desk.ask(who, command, lambda answer: self._tell(sent({"re": mark, **answer}), answers=True), why_not)

    async def _read(self) -> Any:
        """The next message, None for one that is none."""
        try:
            text = await self.ws.receive_text()
            if len(text) > LONGEST:
                return None
            found = json.loads(text)
            names = isinstance(found, dict) and found.get("do") == entry.ACKNOWLEDGE
            return found if names or len(text) <= LARGEST else None
        except (KeyError, ValueError, RecursionError):  # KeyError: it is bytes
            return None

    def _tell(self, text: str, answers: bool = False) -> None:
        """Called in the thread of the cycles."""
        with suppress(RuntimeError):  # the loop has ended
            self.loop.call_soon_threadsafe(self._queue, text, answers)

    def _queue(self, text: str, answers: bool = False) -> None:
        self.waiting -= answers
        if self.out.full():
            self.desk.browsers.forget(self._tell)
            self.out.get_nowait()
            self.out.put_nowait(None)
        else:
            self.out.put_nowait(text)

    async def _send(self) -> None:
        with suppress(WebSocketDisconnect, RuntimeError):
            while (text := await self.out.get()) is not None:
                await self.ws.send_text(text)
            await self.ws.close(1013)


def listening(host: str, port: int) -> socket.socket:
    """A socket that listens there.  Raises `OSError`."""
    kind = socket.AF_INET6 if ":" in host else socket.AF_INET
    sock = socket.socket(kind, socket.SOCK_STREAM)
    sock.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
    keeps_alive(sock)
    try:
        sock.bind((host, port))
        sock.listen(BACKLOG)
    except OSError:
        sock.close()
        raise
    return sock


class _Server(uvicorn.Server):
    """Ends in its own time however often it is interrupted; uvicorn's breaks off at the second, with a traceback."""

    def handle_exit(self, sig: int, frame: FrameType | None) -> None:
        self.should_exit = True


def serve(desk: Desk, access: Access, sock: socket.socket) -> None:
    """Serve until interrupted, once or more; then every output that can be reached is restrictive."""
    config = uvicorn.Config(
        application(desk, access),
        log_level="error",
        access_log=False,
        lifespan="on",
        http=Connection,
        backlog=BACKLOG,
        ws="websockets-sansio",
        ws_max_size=4 * LONGEST,
        timeout_graceful_shutdown=1,
    )
    server = _Server(config)
    desk.ended = lambda: setattr(server, "should_exit", True)
    server.run(sockets=[sock])
