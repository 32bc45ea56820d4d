"""What is half written when a process is asked to end is taken away before it does."""

from __future__ import annotations

import os
import signal
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType


@contextmanager
def taken_away() -> Iterator[None]:
    """Within this, SIGTERM and SIGHUP raise KeyboardInterrupt, so that whoever writes takes away what is half written;
    then the process ends by that signal all the same.  Where somebody else has a handler, or ignores the signal, that
    stays."""
    came: list[int] = []

    def end(number: int, frame: FrameType | None) -> None:
        came.append(number)
        if len(came) == 1:
            raise KeyboardInterrupt

    ours: list[signal.Signals] = []
    try:
        if threading.current_thread() is threading.main_thread():
            for name in ("SIGTERM", "SIGHUP"):  # Windows has no SIGHUP
                number = getattr(signal, name, None)
                if number is not None and signal.getsignal(number) is signal.SIG_DFL:
                    ours.append(number)
                    signal.signal(number, end)
        yield
    finally:
        for number in ours:
            signal.signal(number, signal.SIG_DFL)
        if came:
            os.kill(os.getpid(), came[0])
