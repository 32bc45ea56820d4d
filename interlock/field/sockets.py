"""Connections of servers: one whose other end is gone is noticed, and there are never so many that the files of the
process are used up, of which substations and the record have need, too."""

from __future__ import annotations

import socket
import sys

MOST = 200
"""Connections of a server at most (our choice); less where the system allows the process few files."""

QUIET_S = 30
EVERY_S = 10
TRIES = 3
"""After how many seconds in which nothing was heard the system asks whether the other end is still there, how often
after that, and when it gives up (our choice)."""


def keeps_alive(sock: socket.socket) -> None:
    """Let the system ask whether the other end is still there; on a socket that listens, for all that it accepts."""
    sock.setsockopt(socket.SOL_SOCKET, socket.SO_KEEPALIVE, 1)
    for name, value in (("TCP_KEEPIDLE", QUIET_S), ("TCP_KEEPINTVL", EVERY_S), ("TCP_KEEPCNT", TRIES)):
        if hasattr(socket, name):
            sock.setsockopt(socket.IPPROTO_TCP, getattr(socket, name), value)


def most() -> int:
    """Connections that a server takes at most: a quarter of the files that the process may open."""
    if sys.platform == "win32":
        return MOST
    import resource

    files, _ = resource.getrlimit(resource.RLIMIT_NOFILE)
    return MOST if files == resource.RLIM_INFINITY else max(1, min(MOST, files // 4))
