"""What the machine has no room for, in words: no defect of interlock, and none of the layout."""

from __future__ import annotations

import errno

from interlock.exceptions import Ended

FINDINGS, UNKNOWN = 1, 3

_ROOM = {
    errno.ENOSPC: "make room there",
    errno.EDQUOT: "make room there",
    errno.EFBIG: "a file may not be so large here: see `ulimit -f`",
}
_OPEN = (errno.EMFILE, errno.ENFILE)
_MEMORY = ("failed to map segment", "out of memory", "max. memory exceeded", "bad_alloc", "cannot allocate memory")
"""What loaders of libraries and solvers say where there is no memory."""


def limit_of(error: Exception) -> tuple[str, int] | None:
    """Why there was no room, what to do, and the exit code: 1 where nothing more can be stored, 3 where what was asked
    is not known then; None where it is something else."""
    if isinstance(error, Ended):
        return str(error), UNKNOWN
    system = _system(error)
    if system is not None and system.errno in _ROOM:
        return f"what is written does not fit: {system.strerror}; {_ROOM[system.errno]}", FINDINGS
    if system is not None and system.errno in _OPEN:
        return f"no more files can be opened ({system.strerror}): raise `ulimit -n`, or try fewer jobs", UNKNOWN
    short = system is not None and system.errno == errno.ENOMEM
    if short or isinstance(error, MemoryError) or any(said in str(error).lower() for said in _MEMORY):
        return "memory has run out: try fewer jobs, a higher `ulimit -v`, or a machine with more of it", UNKNOWN
    return None


def _system(error: Exception) -> OSError | None:
    """What the system said: the error itself, or one that a library has wrapped."""
    for found in (error, *error.args, error.__cause__):
        if isinstance(found, OSError) and found.errno is not None:
            return found
    return None
