"""What a run says, written by a thread of its own: whoever does not read it holds up nobody.

A terminal that was stopped by Ctrl-S, or a pipe that nobody reads, takes no more at some time, and whoever writes there
stands still; that must not be the thread that works the signals.  What finds no room is dropped, and counted.
"""

from __future__ import annotations

import os
import queue
import sys
import threading
from collections.abc import Callable
from contextlib import suppress
from typing import Any

import click

MOST = 1000
"""Events that wait to be written (our choice)."""

LAST_S = 2.0
"""Seconds for which the last words wait to be written (our choice)."""


def written(text: str, err: bool = False) -> None:
    """Write a line at once, past the buffer of the stream: one that waits holds no lock that the process needs to end.
    Raises `OSError`."""
    stream = sys.stderr if err else sys.stdout
    try:
        number = stream.fileno()
    except OSError:  # it is no file, as in a test
        click.echo(text, err=err)
        return
    data = f"{text}\n".replace("\n", os.linesep).encode(stream.encoding, "backslashreplace")
    while data:
        data = data[os.write(number, data) :]


class Heard:
    """Says what happens.  Where that finds no room the controller goes on, and the standard error output is told once;
    somebody who reads no more ends it, as always (`BrokenPipeError`).  Any thread may say something.

    text: an event as it is written; write: where to.
    """

    def __init__(self, text: Callable[[dict[str, Any]], str], write: Callable[[str], None] = written) -> None:
        self._text, self._write = text, write
        self._waiting: queue.Queue[dict[str, Any] | None] = queue.Queue(MOST)
        self._lock = threading.Lock()
        self._gone, self._dropped = False, 0
        with suppress(OSError):
            sys.stdout.flush()
        self._thread = threading.Thread(target=self._writing, name="what is said", daemon=True)
        self._thread.start()

    def __call__(self, event: dict[str, Any]) -> None:
        """Say that something has happened, now or, where too much waits, only that it was dropped."""
        if self._gone:
            raise BrokenPipeError
        with self._lock:
            if self._waiting.qsize() + bool(self._dropped) >= MOST:
                self._dropped += 1
                return
            self._tell_dropped()
            self._waiting.put_nowait(event)

    def close(self, last: dict[str, Any] | None = None) -> bool:
        """The last words: whether they, and all before them, were written in time.  Raises `BrokenPipeError`."""
        with self._lock:
            if self._waiting.qsize() > MOST - 3:
                with suppress(queue.Empty):
                    while True:
                        self._waiting.get_nowait()
                        self._dropped += 1
            self._tell_dropped()
            if last is not None:
                self._waiting.put_nowait(last)
            self._waiting.put_nowait(None)
        self._thread.join(LAST_S)
        if self._gone:
            raise BrokenPipeError
        return not self._thread.is_alive()

    def _tell_dropped(self) -> None:
        if self._dropped:
            self._waiting.put_nowait({"not_told": self._dropped})
            self._dropped = 0

    def _writing(self) -> None:
        unheard = False
        while (event := self._waiting.get()) is not None:
            try:
                if text := self._text(event):
                    self._write(text)
                unheard = False
            except BrokenPipeError:
                self._gone = True
                return
            except OSError as error:
                if not unheard:
                    with suppress(OSError):
                        written(f"what happens cannot be written: {error.strerror or error}; the run goes on", True)
                unheard = True


__all__ = ["Heard", "written"]
