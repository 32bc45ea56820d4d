"""Where a page of figures comes from: commit, processor and cores, said in one way by every campaign that says them."""

from __future__ import annotations

import os
import platform
import subprocess
from pathlib import Path


def processor() -> str:
    """The processor's name, where the system tells it."""
    try:
        lines = Path("/proc/cpuinfo").read_text("utf-8").splitlines()
    except OSError:
        lines = []
    told = (x.split(":", 1)[1].strip() for x in lines if x.startswith("model name"))
    return next(told, platform.processor() or platform.machine())


def origin() -> str:
    """`at commit 0123abcd, PROCESSOR, 2 cores`; of a version that is in no repository `at commit unknown`."""
    told = subprocess.run(["git", "rev-parse", "--short", "HEAD"], capture_output=True, text=True, check=False)
    return f"at commit {told.stdout.strip() or 'unknown'}, {processor()}, {os.cpu_count()} cores"
